//! Which inputs of an image-based block of the form matcap become vectors.

use rayon::prelude::*;

use super::image::cells;
use super::samples::{self, RANDOM, TASKS, corners};
use super::{Vector, greedy};
use crate::core::sample::random_codes;
use crate::core::{Direction, ImageDesign};
use crate::fixed::{Rng, Table};

/// Places among which those are sought, for each four texels, that detect a wrong bit of any of them.
const PLACES: u64 = 48;

/// The vectors of a matcap, in groups with a heading.
pub(super) fn vectors(design: ImageDesign<'_>) -> Vec<(String, Vec<Vector>)> {
    let mut rng = Rng::new(0);
    let ports = design.numbers(Direction::In);
    let groups: Vec<(&str, Vec<Vec<i64>>)> = vec![
        ("corners of the port codes", corners(&ports, 1 << design.of.image.vector_fraction, None)),
        ("along the sides, at and about every texel", along_sides(design)),
        ("all texels", all_texels(design)),
        ("random codes", (0..RANDOM).map(|_| random_codes(&ports, &mut rng)).collect()),
        ("random normals", (0..RANDOM).map(|_| design.random(&mut rng)).collect()),
    ];
    samples::vectors(design.core(), groups, TASKS, &mut rng)
}

/// Every texel's place and the edges of its rounding, along x and along y in turn.
fn along_sides(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let parts = 1u64 << design.of.image.weight_bits;
    let middle = u64::from(design.of.image.size / 2) * parts + parts / 2;
    let mut result = Vec::new();
    for texel in 0..u64::from(design.of.image.size) {
        for side in 0..2 {
            let mut places = [middle; 2];
            places[side] = texel * parts;
            let at = design.at_texels(&places);
            let half = (design.at_texels(&[0, 1])[0] - design.at_texels(&[0, 0])[0]) / 2;
            // x is the first port, and y the first direction.
            for off in [-half - 1, -half, 0, half - 1, half] {
                let mut codes = at.clone();
                codes[1 - side] += off;
                result.push(codes);
            }
        }
    }
    result
}

/// For each four texels that are blended, every texel in one of them, the fewest places that a greedy search finds to
/// detect a wrong last bit of any channel of any of them, and with it every greater error; as far as they are not too
/// many, and places between these texels can.
fn all_texels(design: ImageDesign<'_>) -> Vec<Vec<i64>> {
    let image = &design.of.image;
    let parts = 1u64 << image.weight_bits;
    // The last bits of each memory flipped: of four texels that are blended each lies in one of its own.
    let flipped = |memory: usize| -> Vec<Table> {
        let mut tables = design.tables().to_vec();
        tables[memory].fields.iter_mut().flat_map(|field| &mut field.codes).for_each(|code| *code ^= 1);
        tables
    };
    let mutants: Vec<Vec<Table>> = (0..design.tables().len()).map(flipped).collect();
    let of_cell = |(number, first): (u64, Vec<u64>)| {
        let mut rng = Rng::new((3 << 40) + number);
        let inside = |place: u64, rng: &mut Rng| match place {
            // The texels themselves.
            0..4 => [place / 2 * parts, place % 2 * parts],
            _ => [rng.below(parts + 1), rng.below(parts + 1)],
        };
        let candidates: Vec<Vec<i64>> = (0..PLACES)
            .map(|place| inside(place, &mut rng))
            .map(|[y, x]| design.at_texels(&[first[0] + y, first[1] + x]))
            .collect();
        let outputs = |tables: &[Table]| -> Vec<Vec<i64>> {
            candidates.iter().map(|codes| design.graph().results(tables, codes)).collect()
        };
        let right = outputs(design.tables());
        let detects: Vec<Vec<bool>> = mutants
            .iter()
            .map(|tables| outputs(tables))
            .flat_map(|wrong| {
                let of_channel = |c: usize| right.iter().zip(&wrong).map(|(a, b)| a[c] != b[c]).collect();
                (0..3).map(of_channel).collect::<Vec<Vec<bool>>>()
            })
            .collect();
        greedy(candidates.len(), &detects).into_iter().map(|place| candidates[place].clone()).collect::<Vec<_>>()
    };
    cells(image).into_par_iter().flat_map_iter(of_cell).collect()
}
