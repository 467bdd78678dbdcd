//! Pictures of spheres, made here.

use std::path::PathBuf;
use std::sync::LazyLock;

use brdfgen::reflectance::images::{Pixels, png};
use tempfile::TempDir;

/// The bytes of a PNG file of so many pixels along a side: a colour, of linear light from 0 to 1, where x and y of the
/// pixel's centre are, from -1 to 1, +y at the top.
pub fn picture(size: usize, colour: impl Fn(f64, f64) -> [f64; 3]) -> Vec<u8> {
    let at = |place: usize| (2 * place + 1) as f64 / size as f64 - 1.0;
    let code = |value: f64| (value.clamp(0.0, 1.0) * 65535.0).round() as u16;
    let pixel = |place: usize| colour(at(place % size), -at(place / size)).map(code);
    let codes = (0..size * size).map(pixel).collect();
    png(&Pixels { width: size, height: size, depth: 16, gamma: Some(1.0), codes })
}

/// A sphere in a studio, on black: a key light, a rim light, a window with sharp edges, and a floor.
pub fn studio(x: f64, y: f64) -> [f64; 3] {
    let rest = 1.0 - x * x - y * y;
    if rest < 0.0 {
        return [0.0; 3];
    }
    let z = rest.sqrt();
    let towards = |lx: f64, ly: f64, lz: f64| (x * lx + y * ly + z * lz).max(0.0);
    let key = towards(-0.48, 0.6, 0.64);
    let shine = key.powi(40);
    let rim = (1.0 - z).powi(3) * (0.5 + 0.5 * x);
    let window = if (0.25..0.55).contains(&x) && (0.2..0.6).contains(&y) { 0.7 } else { 0.0 };
    let floor = 0.15 * (0.5 - 0.5 * y);
    [0.55, 0.3, 0.12]
        .map(|kd| (0.02 + kd * (key + floor)).min(0.8) + shine)
        .iter()
        .zip([0.3, 0.5, 1.0])
        .map(|(own, tint)| own + tint * rim + window)
        .collect::<Vec<f64>>()
        .try_into()
        .expect("three channels")
}

/// The path of a file with that sphere in so many pixels, 16 or 64 or 512, which is there while the tests run.
fn file(size: usize) -> PathBuf {
    static FILES: LazyLock<TempDir> = LazyLock::new(|| {
        let directory = tempfile::Builder::new().prefix("brdfgen-matcap-").tempdir().expect("a directory");
        for size in [16, 64, 512] {
            std::fs::write(directory.path().join(format!("{size}.png")), picture(size, studio)).expect("written");
        }
        directory
    });
    FILES.path().join(format!("{size}.png"))
}

/// The spec of a matcap of that sphere.
pub fn spec(size: usize, keys: &str) -> String {
    format!("block = 'image'\nimage_form = 'matcap'\n{keys}\n[reflectance]\nfile = '{}'\n", file(size).display())
}

/// Cores at the ends of what is allowed.
pub fn specs() -> Vec<String> {
    [
        (16, "image_size = 8\ntexel_bits = 4\nweight_bits = 3\nvector_bits = 10\npipeline = 2"),
        (16, "image_size = 8\ntexel_bits = 10\nweight_bits = 8\noutput_bits = 8\naxi_stream = true"),
        (16, "image_size = 16\ntexel_bits = 4\noutput_bits = 12\ntexels = 'writable'"),
        (64, "image_size = 32\ntexel_bits = 8"),
        (64, "image_size = 32\ntexel_bits = 10\nweight_bits = 8\noutput_bits = 12\nvector_bits = 22"),
        (64, "image_size = 32\ntexel_bits = 6\noutput_bits = 10\ntexels = 'writable'\naxi_stream = true"),
    ]
    .map(|(size, keys)| spec(size, keys))
    .to_vec()
}
