//! Scenes and meshes of any text: taken or refused, no panic.

use super::*;

proptest! {
    #[test]
    fn any_text_is_taken_or_refused(text in "\\PC*") {
        let _ = parse(&text);
        let _ = Scene::is_scene(&text);
    }

    #[test]
    fn any_value_is_taken_or_refused(
        place in 0usize..6,
        key in "(name|width|position|target|up|field_of_view|shininess|roughness|k_s|colour|direction|intensity|\
             radius|normal|point|scale|max_steps|min_psnr|family|method|core)",
        value in "(\"[a-z0-9.=,]{0,12}\"|-?[0-9]{1,12}|[0-9]{1,3}\\.[0-9]{1,3}|\\[[-0-9., ]{0,9}\\]|\
             \\[nan, inf, 1\\]|nan|true)",
    ) {
        let mut parts =
            [String::new(), CAMERA.into(), MATERIAL.into(), LIGHT.into(), SPHERE.into(), "[core]".to_owned()];
        write!(parts[place], "\n{key} = {value}").unwrap();
        let [top, camera, material, light, object, end] = &parts;
        let _ = parse(&scene(top, camera, material, light, object, end));
    }

    #[test]
    fn any_obj_is_taken_or_refused(
        text in "((v|vn|vt|f|l|o|g|#|s|mtllib|usemtl|p)( \
             (-?[0-9]{1,2}(\\.[0-9])?|nan|-?[0-9]{1,20}(//?-?[0-9]{1,20}){0,3}|1e300|/|a)){0,5}\n){0,20}",
    ) {
        for normals in [Normals::File, Normals::Smooth] {
            if let Ok(mesh) = Mesh::parse(format!("{TRIANGLE}vn 0 0 1\nf 1 2 3\n{text}").as_bytes(), "m", normals) {
                let (positions, normals) = (mesh.positions.len(), mesh.normals.len());
                let corners = || mesh.triangles.iter().flatten();
                prop_assert!(corners().all(|c| (c.position as usize) < positions && (c.normal as usize) < normals));
            }
        }
    }

    #[test]
    fn any_ply_is_taken_or_refused(
        format in "(ascii|binary_little_endian|binary_big_endian)",
        header in "((element (vertex|face|edge) [0-9]{1,19}|property (float|double|uchar|int|int8|uint) (x|y|z|nx|a)|\
             property list (uchar|int|float|uint|char) (int|uint|uchar|float) (vertex_indices|vertex_index|x|a)|\
             comment a|obj_info)\n){0,9}",
        body in proptest::collection::vec(any::<u8>(), 0..80),
        numbers in "([0-9]{1,3}( |\n)){0,30}",
    ) {
        let full = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
             element face 1\nproperty list uchar int vertex_indices\n";
        let start = format!("ply\nformat {format} 1.0\n");
        for header in [format!("{start}{header}end_header\n"), format!("{start}{full}{header}end_header\n")] {
            let _ = Mesh::parse(&[header.as_bytes(), &body].concat(), "m", Normals::File);
            let _ = Mesh::parse(&[header.as_bytes(), numbers.as_bytes()].concat(), "m", Normals::File);
        }
    }
}
