//! Which inputs of a shader become vectors, and its digests.

use rayon::prelude::*;

use super::Vector;
use super::samples::{self, RANDOM, TASKS, corners, detecting};
use crate::core::golden::STREAM;
use crate::core::sample::{Sample, normalised, random_codes};
use crate::core::{Direction, ShaderDesign};
use crate::fixed::Rng;
use crate::spec::Shader;

/// Rows beyond which not every row has vectors of its own.
const MOST_ROWS: usize = 256;
/// Scenes among which those are sought that detect a flipped bit of a ROM word.
const CANDIDATES: usize = 96;

/// The vectors of a shader, in groups with a heading.
pub(super) fn vectors(design: ShaderDesign<'_>) -> Vec<(String, Vec<Vector>)> {
    let shader = design.shader;
    let mut rng = Rng::new(0);
    let ports = design.numbers(Direction::In);
    let rows = design.materials().len();
    let materials: Vec<u32> = (0..rows).step_by(rows.div_ceil(MOST_ROWS)).map(|row| row as u32).collect();
    let any_material = |rng: &mut Rng| {
        let row = rng.below(rows as u64) as u32;
        (row, design.lobe.interface.shininess.value(row as usize))
    };
    let mut groups: Vec<(&str, Vec<Vec<i64>>)> = Vec::new();

    let one = 1i64 << shader.vector_fraction;
    let index = |port: usize| i64::from(materials[port % materials.len()]);
    let corners = corners(&ports, one, Some(&index));
    groups.push(("corners of the port codes", corners));
    groups.push(("vectors along the axes and between them", along_axes(shader, &materials)));
    groups.push(("every code of in_material, all lights at once in the highlight", {
        let z = [0.0, 0.0, 1.0];
        let last = 1u32 << ports[0].1.width();
        let codes = (0..last).step_by((last as usize).div_ceil(2 * MOST_ROWS));
        codes.map(|material| Sample::of(material, z, z, &vec![z; shader.lights as usize]).codes(shader)).collect()
    }));
    groups.push(("each light alone, the others behind the surface", {
        let (front, behind) = ([0.6, 0.0, 0.8], [0.0, 0.0, -1.0]);
        let alone = |light: usize, material: u32| {
            let lights: Vec<_> =
                (0..shader.lights as usize).map(|other| if other == light { front } else { behind }).collect();
            Sample::of(material, [0.0, 0.0, 1.0], [-0.6, 0.0, 0.8], &lights).codes(shader)
        };
        let pairs = (0..shader.lights as usize).flat_map(|l| materials.iter().map(move |&m| (l, m)));
        pairs.map(|(light, material)| alone(light, material)).collect()
    }));
    let detecting: Vec<Vec<Vec<i64>>> = materials.par_iter().map(|&row| detecting_row(design, row)).collect();
    groups.push(("rows told from rows with any bit of a word flipped", detecting.concat()));
    groups.push(("random codes", (0..RANDOM).map(|_| random_codes(&ports, &mut rng)).collect()));
    groups.push(("random samples", {
        let sample = |_| {
            let (material, n) = any_material(&mut rng);
            Sample::random(shader, material, n, &mut rng).codes(shader)
        };
        (0..RANDOM).map(sample).collect()
    }));

    samples::vectors(&design, groups, TASKS, &mut rng)
}

/// Normal, viewer and lights along the axes and halfway between them: scalar products of 0, 1 and -1.
fn along_axes(shader: &Shader, materials: &[u32]) -> Vec<Vec<i64>> {
    let mut result = Vec::new();
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let along = |by: usize, sign: f64| {
                let mut vector = [0.0; 3];
                vector[(axis + by) % 3] = sign;
                vector
            };
            let normal = along(0, sign);
            let between = |by: usize| normalised([0, 1, 2].map(|a| normal[a] + along(by, 1.0)[a]));
            let directions =
                [normal, along(0, -sign), along(1, 1.0), along(1, -1.0), along(2, 1.0), between(1), between(2)];
            for viewer in directions {
                for first in 0..directions.len() {
                    let lights: Vec<_> = (0..shader.lights as usize)
                        .map(|light| directions[(first + light) % directions.len()])
                        .collect();
                    let material = materials[result.len() % materials.len()];
                    result.push(Sample::of(material, normal, viewer, &lights).codes(shader));
                }
            }
        }
    }
    result
}

/// The fewest samples that a greedy search finds to detect each flipped bit of a material's words, as far as any
/// candidate does.
fn detecting_row(design: ShaderDesign<'_>, row: u32) -> Vec<Vec<i64>> {
    let mut rng = Rng::new((1 << 40) + u64::from(row));
    let n = design.lobe.interface.shininess.value(row as usize);
    let candidates: Vec<Vec<i64>> =
        (0..CANDIDATES).map(|_| Sample::random(design.shader, row, n, &mut rng).codes(design.shader)).collect();
    detecting(design.core(), &candidates)
}

/// The inputs of a material's stream: samples and random codes in turn.
pub(super) fn stream(design: ShaderDesign<'_>, index: u32) -> impl Iterator<Item = Vec<i64>> {
    let shader = design.shader;
    let mut rng = Rng::new((2 << 40) + u64::from(index));
    let ports = design.core().numbers(Direction::In);
    let set = &design.lobe.interface.shininess;
    let n = set.value(set.row_of_index(index));
    (0..STREAM).map(move |sample| {
        if sample % 2 == 0 {
            return Sample::random(shader, index, n, &mut rng).codes(shader);
        }
        let mut codes = random_codes(&ports, &mut rng);
        codes[0] = index.into();
        codes
    })
}
