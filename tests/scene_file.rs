//! Scene files: what is read, and what is refused with which words.

use std::path::Path;

use brdfgen::scene::Scene;

fn scenes() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes"))
}

#[test]
fn the_scenes_read() {
    for (file, materials, objects) in [("sphere", 1, 1), ("shininess", 12, 12)] {
        let path = scenes().join(file).with_extension("toml");
        assert!(Scene::is_scene(&std::fs::read_to_string(&path).unwrap()), "{file}");
        let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!((scene.name.as_str(), scene.materials.len(), scene.objects.len()), (file, materials, objects));
    }
}
