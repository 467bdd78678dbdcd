use std::fs;

use brdfgen::platform::paths::*;

fn refused(paths: &Paths) -> String {
    paths.check().expect_err("it must be refused").to_string()
}

#[test]
fn one_file_is_known_by_all_its_names() {
    let scratch = tempfile::tempdir().unwrap();
    let at = |name: &str| scratch.path().join(name);
    fs::create_dir_all(at("d/e")).unwrap();
    fs::write(at("d/a"), "kept").unwrap();
    fs::hard_link(at("d/a"), at("hard")).unwrap();
    let mut names = vec!["d/a", "d/../d/a", "./d//a", "d/e/../a", "hard"];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(at("d"), at("link")).unwrap();
        std::os::unix::fs::symlink(at("d/a"), at("d/soft")).unwrap();
        names.extend(["link/a", "d/soft", "link/soft", "link/../d/a"]);
    }
    for name in &names {
        let text = refused(&Paths::default().reads("--in", at("d/a")).writes("--out", at(name)));
        assert!(text.contains("--out would write") && text.contains("(--in)"), "{name}: {text}");
    }
    for name in ["b", "d/b", "d/e", "d/a2", "/dev/null", "-"] {
        Paths::default().reads("--in", at("d/a")).writes("--out", at(name)).check().unwrap();
    }
    // Once it is to be renewed it may be.
    Paths::default().reads("SPEC", at("d/a")).renewing(&at("d/e/../a")).writes("--out", at("d/a")).check().unwrap();
}

#[test]
fn two_outputs_are_two_files() {
    let scratch = tempfile::tempdir().unwrap();
    let at = |name: &str| scratch.path().join(name);
    let mut names = vec!["new/../new/x", "new/./x", "other/../new/x"];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(at("new"), at("to_new")).unwrap();
        names.push("to_new/x");
    }
    for name in names {
        let text = refused(&Paths::default().writes("--csv", at("new/x")).writes("--json", at(name)));
        assert!(text.starts_with("--csv and --json are one file: "), "{name}: {text}");
    }
    let text = refused(&Paths::default().writes("--csv", at("x")).writes_in("--plots", &at("x"), ["y"]));
    assert!(text.contains("a directory to the other"), "{text}");
    Paths::default().writes_in("--plots", &at("x"), ["y", "z"]).writes("--csv", at("x/w")).check().unwrap();
}

#[test]
fn streams_hold_nothing() {
    let paths = Paths::default().reads("--in", "/dev/null");
    paths.clone().writes("--out", "/dev/null").writes("--csv", "/dev/null").writes("--json", "-").check().unwrap();
    let text = refused(&paths.writes("--csv", "-").writes("--json", "-"));
    assert_eq!(text, "--csv and --json both go to standard output");
}
