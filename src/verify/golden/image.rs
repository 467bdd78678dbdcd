//! Which inputs of an image-based block become vectors, and its digests.

use rayon::prelude::*;

use super::Vector;
use super::matcap;
use super::samples::{self, RANDOM, corners, detecting};
use crate::block::image::{FrontEnd, Image};
use crate::core::sample::random_codes;
use crate::core::{Direction, ImageDesign};
use crate::fixed::Rng;
use crate::reflectance::{Light, Vector as Direction3};

/// Tasks that seek inputs which detect mutants.
const TASKS: u64 = 16;
/// Samples among which those are sought that detect a flipped bit of all texels of a memory.
const CANDIDATES: usize = 96;

/// The vectors of an image-based block, in groups with a heading.
pub(super) fn vectors(design: ImageDesign<'_>) -> Vec<(String, Vec<Vector>)> {
    if !design.of.image.has_lights() {
        return matcap::vectors(design);
    }
    let mut rng = Rng::new(0);
    let ports = design.numbers(Direction::In);
    let image = &design.of.image;
    let mut groups: Vec<(&str, Vec<Vec<i64>>)> = Vec::new();
    groups.push(("corners of the port codes", corners(&ports, 1 << image.vector_fraction, None)));
    groups
        .push(("normals along the axes and between them, lights at and between the bands' angles", along_axes(design)));
    groups.push(("all texels", all_texels(design)));
    if let Some(rows) = design.block.turn_rows() {
        groups.push(("turns by all angles", all_turns(design, rows)));
    }
    if image.front_end == FrontEnd::Vector {
        groups.push(("all rows of the tables that lights' records are made by", design.at_front_end_rows()));
        groups.push(("vectors to the light along the axes and between them, of any length", any_vectors(design)));
    }
    groups.push(("n.v a power of two", {
        let light = (Light::new(90.0, 45.0), [1.0; 3]);
        let codes = design.inputs(Direction3::new(0.6, 0.6, 0.5), &vec![light; image.lights as usize]);
        let with = |code: i64| {
            let mut codes = codes.clone();
            codes[2] = code;
            codes
        };
        (0..=image.vector_fraction).map(|bit| with(1 << bit)).chain([with(0), with(-1)]).collect()
    }));
    groups.push(("powers of two in each channel", (0..3).flat_map(|channel| design.powers(channel)).collect()));
    groups.push(("the greatest gain with every shift", greatest_gains(design)));
    if image.lights > 1 {
        let alone = |light: usize| {
            let mut lights = vec![(Light::new(30.0, 40.0), [0.0; 3]); image.lights as usize];
            lights[light].1 = [1.0, 0.7, 0.4];
            design.inputs(Direction3::new(0.3, 0.1, 0.9).normalize(), &lights)
        };
        groups.push(("each light alone", (0..image.lights as usize).map(alone).collect()));
    }
    let candidates: Vec<Vec<i64>> = {
        let mut rng = Rng::new(1 << 40);
        (0..CANDIDATES).map(|_| design.random(&mut rng)).collect()
    };
    groups.push(("texels told from texels with any bit flipped", detecting(design.core(), &candidates)));
    groups.push(("random codes", (0..RANDOM).map(|_| random_codes(&ports, &mut rng)).collect()));
    groups.push(("random samples", (0..RANDOM).map(|_| design.random(&mut rng)).collect()));
    samples::vectors(design.core(), groups, TASKS, &mut rng)
}

/// Normals along the axes, halfway between them and along the half vector, with the lights one behind the other at the
/// bands' angles and between these.
fn along_axes(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let image = &design.of.image;
    let bands = image.band_angles();
    let between = [0.5 * (bands[0] + bands[1]), 179.0, 180.0];
    let angles: Vec<f64> = bands.iter().copied().step_by(bands.len().div_ceil(20)).chain(between).collect();
    let mut result = Vec::new();
    for place in 0..angles.len() {
        let light = |number: usize| Light::new(angles[(place + number) % angles.len()], 45.0 * (place + number) as f64);
        let lights: Vec<_> = (0..image.lights as usize).map(|number| (light(number), [1.0, 0.5, 0.25])).collect();
        let half = (lights[0].0.direction() + Direction3::z()).try_normalize(1e-9).unwrap_or(Direction3::x());
        let x = Direction3::x();
        let normals = [
            half,
            Direction3::z(),
            x,
            -Direction3::y(),
            (Direction3::z() + x).normalize(),
            (Direction3::z() - x + Direction3::y()).normalize(),
            lights[0].0.direction(),
            -Direction3::z(),
        ];
        result.extend(normals.map(|n| design.inputs(n, &lights)));
    }
    result
}

/// Between all texels, each once, as far as these are not too many, where every channel is about to take its next code
/// and where it just has: a bit that is wrong in any of them shows in one of both.
fn all_texels(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let image = &design.of.image;
    let parts = 1u64 << image.weight_bits;
    let middle = |corner: Vec<u64>| -> Vec<u64> { corner.into_iter().map(|place| place + parts / 2).collect() };
    cells(image).into_par_iter().flat_map_iter(|(_, corner)| design.at_steps(&middle(corner))).collect()
}

/// The number and the corner of the cells between texels, each texel in one of them, as far as these are not too many:
/// places in parts of a weight's last bit.
pub(super) fn cells(image: &Image) -> Vec<(u64, Vec<u64>)> {
    let counts: Vec<u32> = image.extents().into_iter().map(|extent| extent / 2).collect();
    let parts = 1u64 << image.weight_bits;
    let cells: u64 = counts.iter().copied().map(u64::from).product();
    let corner = |number| Image::places(number, &counts).into_iter().map(|cell| 2 * cell * parts).collect();
    // Of a million texels some of all columns, for which the step is odd: no file holds so many vectors.
    let step = cells.div_ceil(MOST_CELLS) as usize | 1;
    (0..cells).step_by(step).map(|number| (number, corner(number))).collect()
}

/// Turns to an image with an even number and one with an odd one by the angles of all rows of the tables of sines, and
/// with all rows of the table of reciprocal roots.
fn all_turns(design: ImageDesign<'_>, [rests, angles]: [&[f64]; 2]) -> Vec<Vec<i64>> {
    let within = |keys: &[f64], row: usize| {
        let next = keys.get(row + 1).copied().unwrap_or(1.0);
        // Not at the same part of the way in each.
        keys[row] + (next - keys[row]) * (0.3 + 0.6 * ((row * 5) % 8) as f64 / 8.0)
    };
    let by_angle = (0..angles.len()).map(|row| (within(angles, row), None));
    let by_rest = (0..rests.len()).map(|row| (0.6, Some(within(rests, row))));
    let all: Vec<(f64, Option<f64>)> = by_angle.chain(by_rest).collect();
    let last = design.of.image.band_angles().len() / 2;
    let turn = |(number, &(angle, rest)): (usize, &(f64, Option<f64>))| {
        [0, 1].map(|parity| design.at_turn(angle, 2 * (number % last) + parity, rest)).concat()
    };
    all.par_iter().enumerate().flat_map_iter(turn).collect()
}

/// Vectors to the light whose components are none, one or the ends of their codes, with a normal that is turned to the
/// viewer and one beside it.
fn any_vectors(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let one = 1i64 << design.of.image.vector_fraction;
    let components = [-2 * one, -one, 0, one, 2 * one - 1];
    let normals = [Direction3::z(), Direction3::new(0.6, -0.36, 0.72)];
    let mut result = Vec::new();
    for (number, n) in normals.into_iter().enumerate() {
        let codes = design.inputs(n, &vec![(Light::new(0.0, 0.0), [1.0, 0.6, 0.2]); design.of.image.lights as usize]);
        for l in (0..components.len().pow(3)).skip(number) {
            let mut codes = codes.clone();
            codes[3] = components[l % 5];
            codes[4] = components[l / 5 % 5];
            codes[5] = components[l / 25];
            result.push(codes);
        }
    }
    result
}

/// Lights in front of a normal that is turned to the viewer, with the greatest gain and every shift, at texels of all
/// bands.
fn greatest_gains(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let ports = design.numbers(Direction::In);
    let extents = design.of.image.extents();
    let parts = 1u64 << design.of.image.weight_bits;
    let shifts = ports.iter().find(|(name, _)| *name == "in_shift1").map_or(1, |(_, format)| 1i64 << format.width());
    let bands = u64::from(extents[0]);
    let codes = |shift: i64, band: u64| {
        let middle = if extents.len() == 2 { 0 } else { u64::from(extents[1] / 2) };
        let inner = extents[1..].iter().map(|_| middle * parts);
        let mut codes = design.at_texels(&std::iter::once(band * parts).chain(inner).collect::<Vec<u64>>());
        for (code, (name, format)) in codes.iter_mut().zip(&ports) {
            let is_record = design.of.image.front_end == FrontEnd::Record;
            if (*name == "in_l1z" && is_record) || name.starts_with("in_gain1") || name.starts_with("in_intensity1") {
                *code = format.max_code() as i64;
            } else if *name == "in_shift1" {
                *code = shift;
            }
        }
        codes
    };
    let bands = || (0..bands).step_by(bands.div_ceil(4) as usize);
    (0..shifts)
        .flat_map(|shift| bands().map(move |band| (shift, band)))
        .map(|(shift, band)| codes(shift, band))
        .collect()
}

/// The most places between texels.
const MOST_CELLS: u64 = 1 << 12;

/// The inputs of a stream: samples and random codes in turn.
pub(super) fn stream(design: ImageDesign<'_>, stream: u32) -> impl Iterator<Item = Vec<i64>> {
    let mut rng = Rng::new((2 << 40) + u64::from(stream));
    let ports = design.core().numbers(Direction::In);
    (0..crate::core::golden::STREAM)
        .map(move |sample| if sample % 2 == 0 { design.random(&mut rng) } else { random_codes(&ports, &mut rng) })
}
