//! Inputs of a shader at which a last bit decides: scalar products just below or at a multiple of the last bit that
//! rounding leaves, a light that only just shines on a surface, products of cosines just below such a multiple.
//!
//! With k bits dropped, random samples find such an input once in 2^k. Here one is made: a vector near an axis has a
//! component of ±1 code and one of about 2^(f/2) codes, so its product with another vector becomes any number when the
//! other is moved by as few codes.

use super::ShaderDesign;
use super::sample::{Sample, Vector, front, normalised, plus, random_codes, random_direction};
use crate::core::Direction;
use crate::fixed::{Rng, exp2};
use crate::spec::{Cosine, Shader};

/// Factors on either side of a sample's that are tried for one whose other has about the value of the sample's.
const TRIED: i64 = 128;

/// The codes of a vector.
type Codes = [i64; 3];

fn product(a: Codes, b: Codes) -> i64 {
    a.iter().zip(b).map(|(&a, b)| a * b).sum()
}

/// A vector of about the length 1 with which any other has any product that it is to have, after a small move.
fn near_axis(fraction: u32, rng: &mut Rng) -> Codes {
    let one = 1i64 << fraction;
    let least = (1 << (fraction / 2)) / 2;
    let middle = (least + rng.below(3 * least + 1)) as i64;
    let rest = (one * one - middle * middle - 1).max(0);
    let first = rng.below(3) as usize;
    let step = 1 + rng.below(2) as usize;
    let mut codes = [0; 3];
    for (place, code) in [libm::sqrt(rest as f64) as i64, middle, 1].into_iter().enumerate() {
        codes[(first + place * step) % 3] = if rng.below(2) == 0 { code } else { -code };
    }
    codes
}

/// Moves `moved` so that its product with a vector near an axis is `target`.
fn tune(axis: Codes, moved: &mut Codes, target: i64) {
    let mut places = [0, 1, 2];
    places.sort_by_key(|&place| -axis[place].abs());
    for place in places {
        let missing = target - product(axis, *moved);
        let by = axis[place];
        // Half of the divisor is added, so that the rest is as small as it can be; a divisor of 1 leaves none.
        moved[place] += (missing + by.abs() / 2).div_euclid(by.abs()) * by.signum();
    }
}

/// A number whose last bits are all 1, all 0, or one of these but for one bit or two.
fn last_bits(bits: u32, rng: &mut Rng) -> i64 {
    let ones = (1i64 << bits) - 1;
    let some = if rng.below(2) == 0 { 0 } else { ones };
    let flip = |rng: &mut Rng| match rng.below(3) {
        0 => 0,
        _ => 1i64 << rng.below(bits.max(1).into()),
    };
    (some ^ flip(rng) ^ flip(rng)) & ones
}

/// The inverse of an odd number modulo a power of two, by Newton's iteration: each step doubles the bits that are
/// right.
pub(super) fn inverse(odd: i64, bits: u32) -> i64 {
    let mut inverse = odd;
    for _ in 0..5 {
        inverse = inverse.wrapping_mul(2i64.wrapping_sub(odd.wrapping_mul(inverse)));
    }
    inverse & ((1 << bits) - 1)
}

/// How many ports of a shader, its first ones, are no light's.
pub(super) fn ports_of_sample(shader: &Shader) -> usize {
    if shader.cosine == Cosine::Half { 4 } else { 7 }
}

/// The ports of a shader, as places in its codes.
struct Ports {
    normal: usize,
    viewer: Option<usize>,
    light: usize,
}

impl Ports {
    fn of(shader: &Shader, light: usize, ports: usize) -> Self {
        let viewer = (shader.cosine != Cosine::Half).then_some(4);
        let first = ports_of_sample(shader);
        Self { normal: 1, viewer, light: first + light * (ports - first) / shader.lights as usize }
    }
}

fn at(codes: &[i64], place: usize) -> Codes {
    [codes[place], codes[place + 1], codes[place + 2]]
}

fn put(codes: &mut [i64], place: usize, vector: Codes) {
    codes[place..place + 3].copy_from_slice(&vector);
}

/// An input of a shader: a random sample, random codes, or one of this module's, each of a random material.
#[must_use]
pub fn varied(design: ShaderDesign<'_>, rng: &mut Rng) -> Vec<i64> {
    let (ports, shader) = (design.numbers(Direction::In), design.shader);
    let row = rng.below(design.materials().len() as u64) as u32;
    let n = design.lobe.interface.shininess.value(row as usize);
    let codes = match rng.below(4) {
        0 => Sample::random(shader, row, n, rng).codes(shader),
        1 => random_codes(&ports, rng),
        _ => edge(design, row, n, rng),
    };
    codes.into_iter().zip(ports).map(|(code, (_, format))| format.wrap(code.into()) as i64).collect()
}

fn edge(design: ShaderDesign<'_>, row: u32, shininess: f64, rng: &mut Rng) -> Vec<i64> {
    let shader = design.shader;
    let fraction = shader.vector_fraction;
    let axis = near_axis(fraction, rng);
    let direction: Vector = axis.map(|code| code as f64 * exp2(-(fraction as i32)));
    let dot_bits = shader.widths(design.lobe.interface).dot as u32;
    let dropped = 2 * fraction - dot_bits;
    let light = rng.below(shader.lights.into()) as usize;
    let about_normal = |rng: &mut Rng| {
        let viewer = front(random_direction(rng), direction);
        Sample::seen(shader, row, shininess, direction, viewer, rng).codes(shader)
    };
    let tuned = |axis: usize, moved: usize, codes: &mut Vec<i64>, rng: &mut Rng| {
        let mut vector = at(codes, moved);
        let product = product(at(codes, axis), vector);
        tune(at(codes, axis), &mut vector, product >> dropped << dropped | last_bits(dropped, rng));
        put(codes, moved, vector);
    };
    let ports = Ports::of(shader, light, design.numbers(Direction::In).len());
    match (ports.viewer, rng.below(6)) {
        // L.V
        (Some(viewer), 0) => {
            let normal = front(random_direction(rng), direction);
            let mut codes = Sample::seen(shader, row, shininess, normal, direction, rng).codes(shader);
            tuned(viewer, ports.light, &mut codes, rng);
            codes
        }
        // N.V
        (Some(viewer), 1) => {
            let mut codes = about_normal(rng);
            tuned(ports.normal, viewer, &mut codes, rng);
            codes
        }
        // Grazing light, straight into the viewer's eyes: N.L is a few last bits of the exact product.
        (Some(viewer), 2) => {
            let mut codes = about_normal(rng);
            let mut along = at(&codes, ports.light);
            tune(axis, &mut along, last_bits(dropped, rng) - i64::from(rng.below(2) == 0));
            put(&mut codes, ports.light, along);
            put(&mut codes, viewer, along.map(|code| -code));
            codes
        }
        // The product (N.L)(N.V) has all its last bits 1.
        (Some(viewer), 3) => {
            let mut codes = about_normal(rng);
            let [nl, nv] = [ports.light, viewer].map(|place| product(axis, at(&codes, place)) >> dropped);
            let bits = dot_bits - 1;
            let (wanted, half) = (last_bits(bits, rng), 1i64 << (bits - 1));
            // Any odd factor has an inverse, so it says the other's low bits: of many near the sample's, the one whose
            // other moves least.
            let moves = |odd: i64| {
                let low = inverse(odd, bits).wrapping_mul(wanted);
                (low.wrapping_sub(nv).wrapping_add(half) & (2 * half - 1)) - half
            };
            let near = (-TRIED..TRIED).map(|step| (nl | 1) + 2 * step);
            let odd = near.min_by_key(|&odd| moves(odd).abs()).unwrap_or(1);
            let (mut to_light, mut to_viewer) = (at(&codes, ports.light), at(&codes, viewer));
            tune(axis, &mut to_light, odd << dropped);
            tune(axis, &mut to_viewer, (nv + moves(odd)) << dropped);
            put(&mut codes, ports.light, to_light);
            put(&mut codes, viewer, to_viewer);
            codes
        }
        // The light behind the viewer: L.V is 1 or a little more.
        (Some(viewer), 4) => {
            let spread = rng.unit() / libm::sqrt(shininess);
            let near = normalised(plus(direction, random_direction(rng), spread));
            let mut codes = Sample::seen(shader, row, shininess, direction, near, rng).codes(shader);
            let along = at(&codes, viewer).map(|code| code + code.signum() * rng.below(2) as i64);
            put(&mut codes, viewer, along);
            put(&mut codes, ports.light, along);
            codes
        }
        // N.L
        _ => {
            let mut codes = about_normal(rng);
            tuned(ports.normal, ports.light, &mut codes, rng);
            codes
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::{BlockDesign, Design};
    use crate::spec::SpecFields;

    const SPEC: &str = "block = \"shader\"\nmethod = \"quadratic\"\n[[material]]\nname = \"m\"\nshininess = \
     20\n[shader]\nlights = 1\n";

    fn design() -> Design {
        Design::new(SpecFields::parse(SPEC, "test").and_then(SpecFields::resolve).expect("a spec")).expect("a design")
    }

    #[test]
    fn any_product_comes_from_a_small_move() {
        let mut rng = Rng::new(7);
        for _ in 0..1000 {
            let axis = near_axis(16, &mut rng);
            let length = libm::sqrt(product(axis, axis) as f64);
            assert!((length - 65536.0).abs() < 3.0, "{axis:?}");
            let start = [(); 3].map(|()| rng.below(1 << 17) as i64 - (1 << 16));
            let target = product(axis, start) ^ rng.below(1 << 14) as i64;
            let mut moved = start;
            tune(axis, &mut moved, target);
            assert_eq!(product(axis, moved), target);
            assert!(moved.iter().zip(start).all(|(a, b)| (a - b).abs() <= 1 << 9), "{start:?} {moved:?}");
        }
    }

    #[test]
    fn odd_numbers_have_inverses() {
        for odd in [-7, -1, 1, 3, 12345, 65535] {
            assert_eq!((inverse(odd, 17) * odd) & 0x1_ffff, 1, "{odd}");
        }
    }

    /// Each scalar product's dropped bits are all 1 in one input of three hundred or more, not in one of 2^14; and
    /// there is light that hardly reaches the surface and makes a highlight.
    #[test]
    fn products_are_often_just_below_a_last_bit() {
        let design = design();
        let BlockDesign::Shader(design) = design.block() else { panic!("a shader") };
        let dropped = 2 * design.shader.vector_fraction - design.shader.widths(design.lobe.interface).dot as u32;
        assert_eq!(dropped, 14);
        let mut rng = Rng::new(3);
        let model = design.model();
        let mut found = [0; 3];
        let mut grazing = 0;
        for _ in 0..4000 {
            let codes = varied(design, &mut rng);
            let [normal, viewer, light] = [1, 4, 7].map(|place| at(&codes, place));
            let products = [product(normal, light), product(normal, viewer), product(light, viewer)];
            for (count, product) in found.iter_mut().zip(products) {
                *count += usize::from(product & 0x3fff == 0x3fff);
            }
            let highlight = model.highlight(codes[0] as u32, &model.cosines(&codes)[0]);
            grazing += usize::from((1..1 << dropped).contains(&products[0]) && highlight > 0);
        }
        assert!(found.iter().all(|&count| count > 10), "{found:?}");
        assert!(grazing > 10, "{grazing}");
    }
}
