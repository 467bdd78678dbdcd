use std::path::Path;

use brdfgen::platform::error::Error;
use brdfgen::reflectance::directory::*;
use brdfgen::reflectance::form::{Form, FormKind, FormSpec};
use brdfgen::reflectance::{Model, Reflectance};

fn written(form: &Form) -> tempfile::TempDir {
    let directory = tempfile::tempdir().unwrap();
    for (name, bytes) in files(form).unwrap() {
        std::fs::write(directory.path().join(name), bytes).unwrap();
    }
    directory
}

fn form(kind: FormKind, texel: &str) -> Form {
    let model = Model::named("ggx").unwrap();
    let spec = FormSpec::sized(kind, 3, 8, texel.parse().unwrap());
    spec.build(&model as &dyn Reflectance, 3.8).unwrap()
}

#[test]
fn every_form_reads_back() {
    for kind in FormKind::MADE {
        for texel in ["float", "linear:8", "linear:3", "sqrt:12", "sqrt:6", "sqrt:8:4", "565"] {
            let form = form(kind, texel);
            let directory = written(&form);
            assert_eq!(read(directory.path()).unwrap(), form, "{kind:?} {texel}");
        }
    }
}

#[test]
fn wrong_directories_are_refused() {
    let form = form(FormKind::Paper, "linear:8");
    let said = |change: &dyn Fn(&Path)| {
        let directory = written(&form);
        change(directory.path());
        match read(directory.path()).unwrap_err() {
            Error::Input { what, allowed } => format!("{what} / {allowed}"),
            other => other.to_string(),
        }
    };
    let edit = |from: &'static str, to: &'static str| {
        said(&move |directory: &Path| {
            let path = directory.join(INDEX);
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(text.contains(from), "{text}");
            std::fs::write(path, text.replacen(from, to, 1)).unwrap();
        })
    };
    let remove =
        |name: &'static str| said(&move |directory: &Path| std::fs::remove_file(directory.join(name)).unwrap());
    assert!(remove("001_phi_60.png").contains("lists 001_phi_60.png, which is not there"));
    assert!(remove(INDEX).contains("has no images.toml"));
    assert!(edit("size = 8", "size = 9").contains("8 × 8 pixels / images.toml says 9 × 9"));
    assert!(edit("size = 8", "size = 1000000").contains("size 1000000 is out of range"));
    assert!(edit("phi = 60.0", "phi = 0.0").contains("do not ascend"));
    assert!(edit("phi = 120.0", "phi = 190.0").contains("190° is out of range"));
    assert!(edit("phi = 120.0", "phi = nan").contains("out of range"));
    assert!(edit("texel = \"linear:8\"", "texel = \"linear:80\"").contains("no texel"));
    assert!(edit("form = \"paper\"", "form = \"photo\"").contains("`photo` is no form"));
    assert!(edit("exposure = 3.8", "exposure = -1.0").contains("exposure = -1"));
    assert!(edit("caps = [1.0]", "caps = []").contains("0 caps"));
    assert!(edit("caps = [1.0]", "caps = [nan]").contains("cap NaN"));
    assert!(edit("000_phi_0.png", "../000_phi_0.png").contains("without a directory"));
    assert!(edit("behind", "beside").contains("unknown field `beside`"));
    let broken = said(&|directory: &Path| std::fs::write(directory.join("000_phi_0.png"), "no picture").unwrap());
    assert!(broken.contains("000_phi_0.png: the picture cannot be read"), "{broken}");
}
