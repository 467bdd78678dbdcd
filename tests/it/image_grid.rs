//! The reference cores of the image-based block over a grid of normals: where their error comes from.

use std::path::Path;

use brdfgen::core::{BlockDesign, Design, ImageError};
use brdfgen::reflectance::measure::Sphere;
use brdfgen::spec::SpecFields;

use crate::common::all;

/// Every normal on a grid of 2^-10, or of 2^-6 where not all is tested, under 64 lights from the viewer's direction to
/// that behind the object: what the hardware rounds stays below what its texels lose.
#[test]
fn the_error_of_the_reference_cores_over_all_normals() {
    let sphere = Sphere::new(if all() { 2048 } else { 128 });
    let angles: Vec<f64> = (0..64).map(|light| 180.0 * f64::from(light) / 63.0).collect();
    for name in ["image_paper", "image_half", "image_bivariate"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("generated").join(name);
        let spec = SpecFields::read(&path).and_then(SpecFields::resolve).expect(name);
        let design = Design::new(spec).expect(name);
        let BlockDesign::Image(image) = design.block() else { panic!("{name} is an image-based block") };
        let account = ImageError::over(image, &sphere, &angles);
        println!("{name}, {} samples:", account.samples);
        for part in account.parts.iter().chain([&account.whole]) {
            println!("{:12} {:+.3} {:+.3} rms {:.4}", part.name, part.codes[0], part.codes[1], part.rms);
        }
        assert_eq!(account.samples, 64 * sphere.normals.len() as u64);
        let of = |name: &str| account.parts.iter().find(|part| part.name == name).expect("a part of every account");
        // Half a code is the output's own rounding.
        let [low, high] = of("arithmetic").codes;
        assert!(-1.0 < low && high < 1.0, "{name}: {low} {high}");
        for part in ["ports", "weights", "arithmetic"] {
            assert!(of(part).rms < of("texels").rms, "{name}: {part}");
        }
    }
}
