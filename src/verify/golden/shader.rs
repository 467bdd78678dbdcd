//! Which inputs of a shader become vectors, and its digests.

use rayon::prelude::*;

use super::detection::{self, Candidates};
use super::{OutputHash, Vector};
use crate::core::edges::varied;
use crate::core::golden::STREAM;
use crate::core::sample::{Sample, normalised, random_codes};
use crate::core::{Design, Direction, ShaderDesign};
use crate::fixed::{Rng, Table};
use crate::spec::Shader;
use crate::verify::faults::simulation::blocks;

/// Rows beyond which not every row has vectors of its own.
const MOST_ROWS: usize = 256;
/// Random vectors of each of the two kinds.
const RANDOM: usize = 512;
/// Scenes among which those are sought that detect a flipped bit of a ROM word.
const CANDIDATES: usize = 96;
/// Tasks that seek inputs which detect mutants, and the candidates of each.
const TASKS: u64 = 64;
const OF_TASK: u64 = 1 << 14;

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

    // All ports at once at the ends of their codes, about 0 and about 1, and each port alone.
    let one = 1i64 << shader.vector_fraction;
    let ends = [i64::MIN, -one - 1, -one, -one + 1, -1, 0, 1, one - 1, one, one + 1, i64::MAX];
    let within = |code: i64, port: usize| {
        let format = ports[port].1;
        code.clamp(format.min_code() as i64, format.max_code() as i64)
    };
    let mut corners: Vec<Vec<i64>> = Vec::new();
    for code in ends {
        corners.push((0..ports.len()).map(|port| within(code, port)).collect());
        for port in 1..ports.len() {
            let mut codes: Vec<i64> = (0..ports.len()).map(|port| within(one, port)).collect();
            codes[0] = within(i64::from(materials[port % materials.len()]), 0);
            codes[port] = within(code, port);
            corners.push(codes);
        }
    }
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
    let detecting: Vec<Vec<Vec<i64>>> = materials.par_iter().map(|&row| detecting(design, row)).collect();
    groups.push(("rows told from rows with any bit of a word flipped", detecting.concat()));
    groups.push(("random codes", (0..RANDOM).map(|_| random_codes(&ports, &mut rng)).collect()));
    groups.push(("random samples", {
        let sample = |_| {
            let (material, n) = any_material(&mut rng);
            Sample::random(shader, material, n, &mut rng).codes(shader)
        };
        (0..RANDOM).map(sample).collect()
    }));

    let vector = |inputs: Vec<i64>, rng: &mut Rng| {
        let (idle, stall) = (super::pause(rng), super::pause(rng));
        Vector { outputs: design.evaluate(&inputs), inputs, idle, stall }
    };
    let mut group = |(heading, inputs): (&str, Vec<Vec<i64>>)| {
        (heading.to_owned(), inputs.into_iter().map(|inputs| vector(inputs, &mut rng)).collect())
    };
    let mut groups: Vec<(String, Vec<Vector>)> = groups.into_iter().map(&mut group).collect();
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let mutants = detection::detecting(&design, &known, TASKS, &|task| candidates(design, task));
    if !mutants.is_empty() {
        groups.push((
            "mutants that no vector above tells from the core".to_owned(),
            mutants.into_iter().map(|inputs| vector(inputs, &mut rng)).collect(),
        ));
    }
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let pausing = detection::pausing(&design, &known, &|task| candidates(design, task));
    if !pausing.is_empty() {
        groups.push(("mutants of registers that no vector above tells from the core".to_owned(), pausing));
    }
    groups
}

/// A task's candidates among which those are sought that detect mutants.
fn candidates(design: ShaderDesign<'_>, task: u64) -> Candidates<'_> {
    let mut rng = Rng::new((5 << 40) + task);
    blocks((0..OF_TASK).map(move |_| varied(design, &mut rng)))
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
fn detecting(design: ShaderDesign<'_>, row: u32) -> Vec<Vec<i64>> {
    let shader = design.shader;
    let mut rng = Rng::new((1 << 40) + u64::from(row));
    let n = design.lobe.interface.shininess.value(row as usize);
    let candidates: Vec<Vec<i64>> =
        (0..CANDIDATES).map(|_| Sample::random(shader, row, n, &mut rng).codes(shader)).collect();
    let outputs = |tables: &[Table]| -> Vec<Vec<i64>> {
        candidates.iter().map(|codes| through_graph(&design, tables, codes)).collect()
    };
    let right = outputs(design.tables());
    let mut detects: Vec<Vec<bool>> = Vec::new();
    for (memory, table) in design.tables().iter().enumerate().filter(|(_, table)| table.key != "entry") {
        for field in 0..table.fields.len() {
            let format = table.fields[field].format;
            for bit in 0..format.width() {
                let mut tables = design.tables().to_vec();
                for code in &mut tables[memory].fields[field].codes {
                    *code = format.wrap(*code ^ (1 << bit));
                }
                detects.push(outputs(&tables).iter().zip(&right).map(|(a, b)| a != b).collect());
            }
        }
    }
    super::greedy(candidates.len(), &detects).into_iter().map(|place| candidates[place].clone()).collect()
}

/// The outputs by the datapath's graph.
fn through_graph(design: &Design, tables: &[Table], codes: &[i64]) -> Vec<i64> {
    let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
    let values = design.graph().values(tables, &inputs);
    design.graph().outputs.iter().map(|&(_, node)| values[node] as i64).collect()
}

/// The digest of a material: its stream's inputs are samples and random codes in turn.
pub(super) fn digest(design: ShaderDesign<'_>, index: u32) -> u64 {
    let shader = design.shader;
    let mut rng = Rng::new((2 << 40) + u64::from(index));
    let ports = design.numbers(Direction::In);
    let set = &design.lobe.interface.shininess;
    let n = set.value(set.row_of_index(index));
    let mut hash = OutputHash::default();
    for sample in 0..STREAM {
        let codes = if sample % 2 == 0 {
            Sample::random(shader, index, n, &mut rng).codes(shader)
        } else {
            let mut codes = random_codes(&ports, &mut rng);
            codes[0] = index.into();
            codes
        };
        let outputs: Vec<u32> =
            through_graph(&design, design.tables(), &codes).into_iter().map(|code| code as u32).collect();
        hash.update(&outputs);
    }
    hash.digest()
}
