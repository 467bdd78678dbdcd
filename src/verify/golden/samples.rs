//! Vectors of cores that have too many inputs to run through them all.

use rayon::prelude::*;

use super::detection::{self, Candidates};
use super::{OutputHash, Vector};
use crate::core::{Design, Direction};
use crate::fixed::{Format, Rng, Table};
use crate::verify::faults::simulation::blocks;

/// Random vectors of each of the two kinds.
pub(super) const RANDOM: usize = 512;
/// Tasks that seek inputs which detect mutants, where nothing else is said, and the candidates of each.
pub(super) const TASKS: u64 = 64;
const OF_TASK: u64 = 1 << 14;

/// Groups of inputs as vectors, and those of so many tasks that detect what these do not.
pub(super) fn vectors(
    design: &Design,
    groups: Vec<(&str, Vec<Vec<i64>>)>,
    tasks: u64,
    rng: &mut Rng,
) -> Vec<(String, Vec<Vector>)> {
    let ports = design.numbers(Direction::In);
    let vector = |inputs: Vec<i64>, rng: &mut Rng| {
        debug_assert!(
            inputs.iter().zip(&ports).all(|(&code, (_, format))| format.wrap(code.into()) == i128::from(code))
        );
        let (idle, stall) = (super::pause(rng), super::pause(rng));
        Vector { outputs: design.evaluate(&inputs), inputs, idle, stall }
    };
    let mut group = |(heading, inputs): (&str, Vec<Vec<i64>>)| {
        (heading.to_owned(), inputs.into_iter().map(|inputs| vector(inputs, rng)).collect())
    };
    let mut groups: Vec<(String, Vec<Vector>)> = groups.into_iter().map(&mut group).collect();
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let mutants = detection::detecting(design, &known, tasks, &|task| candidates(design, task));
    if !mutants.is_empty() {
        groups.push((
            "mutants that no vector above tells from the core".to_owned(),
            mutants.into_iter().map(|inputs| vector(inputs, rng)).collect(),
        ));
    }
    let known: Vec<&Vector> = groups.iter().flat_map(|(_, vectors)| vectors).collect();
    let pausing = detection::pausing(design, &known, &|task| candidates(design, task));
    if !pausing.is_empty() {
        groups.push(("mutants of registers that no vector above tells from the core".to_owned(), pausing));
    }
    groups
}

/// A task's candidates among which those are sought that detect mutants.
fn candidates(design: &Design, task: u64) -> Candidates<'_> {
    let mut rng = Rng::new((5 << 40) + task);
    blocks((0..OF_TASK).map(move |_| design.varied(&mut rng)))
}

/// All ports at once at the ends of their codes, about 0 and about the code `one`, and each port alone with the others
/// at `one`; `index` says what the first port is given then, where that selects something.
pub(super) fn corners(ports: &[(&str, Format)], one: i64, index: Option<&dyn Fn(usize) -> i64>) -> Vec<Vec<i64>> {
    let ends = [i64::MIN, -one - 1, -one, -one + 1, -1, 0, 1, one - 1, one, one + 1, i64::MAX];
    let within = |code: i64, port: usize| {
        let format = ports[port].1;
        code.clamp(format.min_code() as i64, format.max_code() as i64)
    };
    let mut corners: Vec<Vec<i64>> = Vec::new();
    for code in ends {
        corners.push((0..ports.len()).map(|port| within(code, port)).collect());
        for port in usize::from(index.is_some())..ports.len() {
            let mut codes: Vec<i64> = (0..ports.len()).map(|port| within(one, port)).collect();
            if let Some(index) = index {
                codes[0] = within(index(port), 0);
            }
            codes[port] = within(code, port);
            corners.push(codes);
        }
    }
    corners
}

/// The fewest of some inputs that a greedy search finds to detect each flipped bit of all words of a memory that holds
/// data, as far as any of them does.
pub(super) fn detecting(design: &Design, candidates: &[Vec<i64>]) -> Vec<Vec<i64>> {
    let outputs = |tables: &[Table]| -> Vec<Vec<i64>> {
        candidates.iter().map(|codes| design.graph().results(tables, codes)).collect()
    };
    let right = outputs(design.tables());
    let holds = |table: &Table| table.holds_data() || table.key == "material";
    let mut flips = Vec::new();
    for (memory, table) in design.tables().iter().enumerate().filter(|(_, table)| holds(table)) {
        for (field, of) in table.fields.iter().enumerate() {
            flips.extend((0..of.format.width()).map(|bit| (memory, field, bit)));
        }
    }
    let detect = |&(memory, field, bit): &(usize, usize, u32)| -> Vec<bool> {
        let mut tables = design.tables().to_vec();
        let of = &mut tables[memory].fields[field];
        for code in &mut of.codes {
            *code = of.format.wrap(*code ^ (1 << bit));
        }
        outputs(&tables).iter().zip(&right).map(|(a, b)| a != b).collect()
    };
    let detects: Vec<Vec<bool>> = flips.par_iter().map(detect).collect();
    super::greedy(candidates.len(), &detects).into_iter().map(|place| candidates[place].clone()).collect()
}

/// The digest of a stream of inputs.
pub(super) fn digest(design: &Design, stream: impl Iterator<Item = Vec<i64>>) -> u64 {
    let results = |codes: &Vec<i64>| -> Vec<u32> {
        design.graph().results(design.tables(), codes).into_iter().map(|code| code as u32).collect()
    };
    let outputs: Vec<Vec<u32>> = stream.collect::<Vec<_>>().par_iter().map(results).collect();
    let mut hash = OutputHash::default();
    outputs.iter().for_each(|outputs| hash.update(outputs));
    hash.digest()
}
