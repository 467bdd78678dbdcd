//! What reflectances are tried with.

use std::f64::consts::PI;

use brdfgen::reflectance::{Reflectance, Rgb, Vector};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64;

/// Numbers from 0 to 1, the same in every run.
pub fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut random = Pcg64::seed_from_u64(seed);
    move || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// A direction of the upper half of the sphere.
pub fn upper(random: &mut impl FnMut() -> f64) -> Vector {
    let (z, a) = (random(), 2.0 * PI * random());
    let r = (1.0 - z * z).sqrt();
    Vector::new(r * a.cos(), r * a.sin(), z)
}

/// A reflectance that is 0 everywhere or a constant, for what is to be tested against a closed form.
pub struct Flat(pub Rgb);

impl Reflectance for Flat {
    fn at(&self, l: Vector, v: Vector, n: Vector) -> Rgb {
        if n.dot(&l) > 0.0 && n.dot(&v) > 0.0 { self.0 } else { [0.0; 3] }
    }
}
