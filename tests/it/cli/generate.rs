//! The directory of a core: what is in it, made again, and checked.

use super::*;

#[test]
fn generate_writes_these_files_and_says_that_the_simulation_passed() {
    let scratch = Scratch::new();
    let run = scratch.run(&format!("generate {SMALL} --out core")).succeeds();
    let run = run.says(&["quadratic: Q1.8 -> UQ1.8", "PASS builtin", " 0 mismatches", "10 files in core"]);
    assert!(run.stdout.contains("error against x^n"));
    let expected = [
        "README.md",
        "core.toml",
        "files.f",
        "golden/quadratic.vec",
        "manifest.json",
        "rom/quadratic.mem",
        "rtl/quadratic.v",
        "rtl/quadratic.vhd",
        "tb/quadratic_tb.v",
        "tb/quadratic_tb.vhd",
    ];
    assert_eq!(scratch.files("core"), expected);
    assert_eq!(scratch.files(""), expected.map(|file| format!("core/{file}")), "nothing beside the core");
    assert_eq!(scratch.text("core/files.f"), "rtl/quadratic.v\n");
}

#[test]
fn generate_fills_an_existing_empty_directory() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --out new/core/")).succeeds();
    fs::create_dir(scratch.path("empty")).unwrap();
    scratch.run(&format!("generate {SMALL} --out empty")).succeeds();
    assert_eq!(scratch.tree("empty"), scratch.tree("new/core"));
    let here = Scratch::new();
    here.run(&format!("generate {SMALL} --out .")).succeeds();
    assert_eq!(here.tree(""), scratch.tree("new/core"));
}

#[cfg(unix)]
#[test]
fn generate_follows_a_link_to_an_empty_directory() {
    let scratch = Scratch::new();
    fs::create_dir(scratch.path("real")).unwrap();
    std::os::unix::fs::symlink("real", scratch.path("link")).unwrap();
    scratch.run(&format!("generate {SMALL} --out link")).succeeds();
    assert_eq!(scratch.files("real").len(), 10);
    assert!(scratch.path("link").is_symlink());
}

#[test]
fn a_core_is_made_again_from_its_own_spec() {
    let scratch = Scratch::new();
    let materials =
        "--method quadratic --input-fraction 8 --material old_brass=9.5 --material gold=80 --rom file --name gloss";
    for (index, flags) in [SMALL, CUBIC, materials].iter().enumerate() {
        let (first, second, third) = (format!("a{index}"), format!("b{index}"), format!("c{index}"));
        scratch.run(&format!("generate {flags} --out {first}")).succeeds();
        scratch.run(&format!("generate {first}/core.toml --out {second}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&second));
        scratch.run(&format!("generate {first} --out {third}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&third));
        scratch.run(&format!("generate {first} --out {first}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&third));
    }
}

#[test]
fn flags_and_a_spec_file_give_the_same_bytes() {
    let scratch = with_core();
    scratch.write("spec.toml", SMALL_TOML);
    scratch.run("generate spec.toml --out toml").succeeds();
    assert_eq!(scratch.tree("toml"), scratch.tree("core"));
    scratch.write("other.toml", replaced(SMALL_TOML, "[1, 5, 20.5]", "\"2..=3\"") + "languages = [\"vhdl\"]\n");
    let line = "generate other.toml --shininess 1,5,20.5 --languages vhdl,verilog --out both";
    scratch.run(line).succeeds();
    assert_eq!(scratch.tree("both"), scratch.tree("core"), "a flag wins over the file");
}

#[test]
fn the_bytes_do_not_depend_on_the_machine() {
    let scratch = with_core();
    for (threads, zone, locale) in [("1", "Asia/Tokyo", "C"), ("3", "America/New_York", "de_DE.UTF-8")] {
        let elsewhere = Scratch::new();
        let mut command = elsewhere.command();
        command.env_clear().env("RAYON_NUM_THREADS", threads).env("TZ", zone).env("LC_ALL", locale);
        command.env("HOSTNAME", "another-host").env("USER", "someone-else").env("HOME", elsewhere.path("home"));
        command.args(["generate", "--out", "deeper/core"]).args(SMALL.split(' ')).assert().success();
        assert_eq!(elsewhere.tree("deeper/core"), scratch.tree("core"), "{threads} threads");
    }
}

#[test]
fn no_file_tells_where_or_when_it_was_made() {
    let scratch = with_core();
    scratch.run("rom core --out core/rom").succeeds();
    let mut secrets = vec![scratch.path("").to_str().unwrap().trim_end_matches('/').to_owned(), "/tmp".to_owned()];
    let name = scratch.path("").file_name().map(|name| name.to_str().unwrap().to_owned());
    secrets.extend(name);
    // A short name could be part of an ordinary word.
    let host = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default().trim().to_owned();
    secrets.extend((host.len() > 7).then_some(host));
    for (path, content) in scratch.tree("core") {
        let Some(content) = content else { continue };
        let text = String::from_utf8_lossy(&content);
        for secret in &secrets {
            assert!(!text.contains(secret), "{} holds {secret}", path.display());
        }
        let time = ["dddd-dd-dd", "dddd/dd/dd", "dd:dd:dd"].iter().find_map(|shape| first_like(&text, shape));
        assert_eq!(time, None, "{}", path.display());
    }
}

/// The first part of `text` that is like `shape`, where `d` stands for a digit.
fn first_like(text: &str, shape: &str) -> Option<String> {
    let like = |window: &[u8]| {
        let fits = |(c, s): (&u8, u8)| if s == b'd' { c.is_ascii_digit() } else { *c == s };
        window.iter().zip(shape.bytes()).all(fits)
    };
    let found = text.as_bytes().windows(shape.len()).find(|window| like(window))?;
    Some(String::from_utf8_lossy(found).into_owned())
}

#[test]
fn the_manifest_has_the_digest_of_every_other_file() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {CUBIC} --rom-formats coe,mif,bin --out core")).succeeds();
    let manifest: serde_json::Value = serde_json::from_slice(&scratch.read("core/manifest.json")).unwrap();
    let stated = manifest["files_sha256"].as_object().unwrap();
    let mut files = scratch.files("core");
    files.retain(|file| file != "manifest.json");
    assert_eq!(files.len(), 12);
    let mut named: Vec<&String> = stated.keys().collect();
    named.sort();
    assert_eq!(named, files.iter().collect::<Vec<_>>());
    for file in files {
        let digest = Sha256::digest(scratch.read(format!("core/{file}")));
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(stated[&file], digits, "{file}");
    }
}

#[test]
fn regenerating_removes_what_the_core_no_longer_has_and_nothing_else() {
    let scratch = with_core();
    scratch.write("core/rtl/my_wrapper.v", "module my_wrapper; endmodule\n");
    scratch.write("core/notes/todo.txt", "mine");
    scratch.run("generate core --languages vhdl --out core").succeeds();
    let files = scratch.files("core");
    for gone in ["rtl/quadratic.v", "tb/quadratic_tb.v"] {
        assert!(!files.contains(&gone.to_owned()), "{gone} is stale");
    }
    assert_eq!(scratch.text("core/rtl/my_wrapper.v"), "module my_wrapper; endmodule\n");
    assert_eq!(scratch.text("core/notes/todo.txt"), "mine");
    scratch.run("generate core --out fresh").succeeds();
    let fresh = scratch.tree("fresh");
    assert!(fresh.iter().all(|entry| scratch.tree("core").get(entry.0) == Some(entry.1)));
    assert_eq!(files.len(), scratch.files("fresh").len() + 2);

    scratch.run("generate core --name renamed --out core").succeeds();
    let old = scratch.files("core").into_iter().filter(|file| file.contains("quadratic"));
    assert_eq!(old.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn a_manifest_cannot_make_generate_remove_files_elsewhere() {
    let scratch = with_core();
    scratch.write("precious.txt", "outside");
    let mut manifest: serde_json::Value = serde_json::from_slice(&scratch.read("core/manifest.json")).unwrap();
    let listed = manifest["files_sha256"].as_object_mut().unwrap();
    for path in ["../precious.txt".to_owned(), scratch.path("precious.txt").to_str().unwrap().to_owned()] {
        listed.insert(path, json!("0"));
    }
    scratch.write("core/manifest.json", manifest.to_string());
    scratch.run("generate core --languages vhdl --out core").succeeds();
    assert_eq!(scratch.text("precious.txt"), "outside");
}

#[test]
fn generate_check_finds_what_is_not_fresh_and_writes_nothing() {
    let scratch = with_core();
    scratch.run("generate core --check --out core").succeeds().says(&["10 of 10 files"]);
    scratch.run("generate core --check --out missing").ends_with(1).says(&["missing/core.toml is missing", "0 of 10"]);
    assert!(!scratch.path("missing").exists());
    let text = scratch.text("core/rtl/quadratic.v");
    scratch.write("core/rtl/quadratic.v", text + " ");
    fs::remove_file(scratch.path("core/files.f")).unwrap();
    let before = scratch.tree("");
    let run = scratch.run("generate core --check --out core").ends_with(1);
    let run = run.says(&["core/rtl/quadratic.v differs", "core/files.f is missing", "8 of 10 files"]);
    assert_eq!(run.stdout.matches("differs").count(), 1);
    let run = scratch.run("generate core --check --json --out core").ends_with(1);
    assert_eq!(
        run.json(),
        json!({ "checked": 10, "differ": ["rtl/quadratic.v", "files.f"], "differ_in_line_ends_only": [] })
    );
    assert_eq!(scratch.tree(""), before);
}
