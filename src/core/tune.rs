//! Fitted coefficients as ROM words: the search over the integers about the rounded ones, so that what becomes least is
//! the error of what the hardware computes, its roundings included.

use std::collections::VecDeque;

use rayon::prelude::*;

use crate::datapath::evaluate::Evaluator;
use crate::datapath::widths::Solution;
use crate::datapath::{Architecture, Datapath};
use crate::fixed::{Table, exp2};
use crate::lobe;
use crate::spec::{LobeSpec, Operand};

/// The most versines at which a row's error is taken.
const MOST_POINTS: i128 = 2048;
/// Past this depth, s = n u, the power is below 2^-23 and no core has anything but 0 or a held value.
const DEEPEST: f64 = 16.0;
/// Points of a block that is looked at first: as many as the evaluator computes at a time.
const BLOCK: usize = 64;
/// The blocks that are looked at first: an error curve that is as flat as it can be has about so many summits.
const WITNESSES: usize = 6;
/// The most steps of a search.
const MOST_STEPS: usize = 64;

/// Where a row's error is taken: operand codes, and what the power is there and what its error weighs.
struct Points {
    index: u32,
    first: i64,
    stride: i64,
    targets: Vec<(f64, f64)>,
}

impl Points {
    /// The points of a row of the coefficient ROM; `None` where nothing of what it serves counts.
    fn of(spec: &LobeSpec, architecture: &dyn Architecture, table: &Table, row: usize) -> Option<Self> {
        let parts = table.rows() / spec.interface.shininess.rows();
        let (n, one) = (table.keys[row], 1i128 << spec.interface.input_fraction);
        let [first, last] = architecture.versines(row)?;
        let deepest = (DEEPEST / n).min(1.0) * one as f64;
        let last = last.min(one - 1).min(deepest as i128);
        if last < first {
            return None;
        }
        let stride = (last - first) / MOST_POINTS + 1;
        let versines: Vec<i128> = (first..=last).step_by(stride as usize).collect();
        let objective = spec.method.options().objective.unwrap_or_default();
        let target = |&code: &i128| {
            let power = lobe::exact(n, code as f64 / one as f64);
            (power, if objective.counts(power) { objective.weight(power) } else { 0.0 })
        };
        let mut targets: Vec<(f64, f64)> = versines.iter().map(target).collect();
        if targets.iter().all(|&(_, weight)| weight == 0.0) {
            return None;
        }
        // The evaluator goes upwards in the operand.
        let first = match spec.interface.operand {
            Operand::Versine => versines[0],
            Operand::Cos => {
                targets.reverse();
                one - versines[versines.len() - 1]
            }
        };
        let index = spec.interface.shininess.index_of_row(row / parts);
        Some(Self { index, first: first as i64, stride: stride as i64, targets })
    }

    /// The largest weighted error of a datapath whose memories are `tables`, if it is less than `bound`.
    ///
    /// Most words fail where others have failed before them: `witnesses` are the blocks of points with the largest
    /// errors of late, which are looked at first.
    fn error_below(
        &self,
        bound: f64,
        witnesses: &mut VecDeque<usize>,
        spec: &LobeSpec,
        datapath: &Datapath,
        tables: &[Table],
    ) -> Option<f64> {
        let evaluator = Evaluator::new(&datapath.graph, tables);
        let ulp = exp2(-(spec.interface.output_fraction as i32));
        // The largest error of the points from a place on, and where it is.
        let largest = |from: usize, count: usize| {
            let targets = &self.targets[from..(from + count).min(self.targets.len())];
            let mut outputs = vec![0; targets.len()];
            evaluator.evaluate(self.index, self.first + self.stride * from as i64, self.stride, &mut outputs);
            let errors = outputs.iter().zip(targets);
            let errors = errors.map(|(&output, &(power, weight))| (f64::from(output) * ulp - power).abs() * weight);
            let place =
                errors.enumerate().fold((0.0, 0), |most, (at, error)| if error > most.0 { (error, at) } else { most });
            (place.0, from + place.1)
        };
        let failed = witnesses.iter().position(|&block| largest(block * BLOCK, BLOCK).0 >= bound);
        if let Some(place) = failed {
            witnesses.swap(0, place);
            return None;
        }
        let (error, at) = largest(0, self.targets.len());
        let block = at / BLOCK;
        if !witnesses.contains(&block) {
            witnesses.truncate(WITNESSES - 1);
            witnesses.push_front(block);
        }
        (error < bound).then_some(error)
    }
}

/// The words of a row that give the least error found by steepest descent over the neighbouring integers.
fn searched(
    spec: &LobeSpec,
    architecture: &dyn Architecture,
    datapath: &Datapath,
    memory: usize,
    row: usize,
) -> Vec<i128> {
    let table = &datapath.tables[memory];
    let fields: Vec<usize> =
        (0..table.fields.len()).filter(|&field| architecture.searched().contains(&table.fields[field].name)).collect();
    let mut best: Vec<i128> = fields.iter().map(|&field| table.fields[field].codes[row]).collect();
    let Some(points) = Points::of(spec, architecture, table, row) else { return best };
    // Memories of one row each, which every address reads.
    let mut tables: Vec<Table> = datapath
        .tables
        .iter()
        .map(
            |other| {
                if other.key == table.key { other.only(row / (table.rows() / other.rows())) } else { other.clone() }
            },
        )
        .collect();
    let mut witnesses = VecDeque::new();
    let mut error_below = |bound: f64, words: &[i128]| {
        for (&field, &code) in fields.iter().zip(words) {
            tables[memory].fields[field].codes[0] = code;
        }
        points.error_below(bound, &mut witnesses, spec, datapath, &tables)
    };
    let Some(mut least) = error_below(f64::INFINITY, &best) else { return best };
    for _ in 0..MOST_STEPS {
        let mut step: Option<(f64, Vec<i128>)> = None;
        for neighbour in 0..3usize.pow(fields.len() as u32) {
            let offset = |digit: usize| (neighbour / 3usize.pow(digit as u32) % 3) as i128 - 1;
            let words: Vec<i128> = best.iter().enumerate().map(|(digit, &code)| code + offset(digit)).collect();
            let fits = |(&field, &code): (&usize, &i128)| {
                let format = table.fields[field].format;
                (format.min_code()..=format.max_code()).contains(&code)
            };
            if words == best || !fields.iter().zip(&words).all(fits) {
                continue;
            }
            let bound = step.as_ref().map_or(least, |(error, _)| *error);
            step = error_below(bound, &words).map(|error| (error, words)).or(step);
        }
        let Some((error, words)) = step else { break };
        (least, best) = (error, words);
    }
    best
}

/// The solution with the words that the search finds, which are from here on the method's coefficients themselves; with
/// the rounded ones where the analysis cannot prove the found ones.
pub(super) fn tuned(spec: &LobeSpec, architecture: &dyn Architecture, solution: Solution) -> Solution {
    let datapath = &solution.datapath;
    let Some(memory) = datapath.tables.iter().position(|table| table.name == Table::COEFFICIENTS) else {
        return solution;
    };
    if architecture.searched().is_empty() {
        return solution;
    }
    let table = &datapath.tables[memory];
    let mut tables = datapath.tables.clone();
    // Between interpolated rows no word has an error of its own.
    if spec.interface.shininess.frac_bits() == 0 {
        let rows: Vec<Vec<i128>> =
            (0..table.rows()).into_par_iter().map(|row| searched(spec, architecture, datapath, memory, row)).collect();
        let fields = tables[memory].fields.iter_mut().filter(|field| architecture.searched().contains(&field.name));
        for (place, field) in fields.enumerate() {
            field.codes = rows.iter().map(|words| words[place]).collect();
        }
    }
    [tables, datapath.tables.clone()]
        .into_iter()
        .find_map(|mut tables| {
            for field in &mut tables[memory].fields {
                field.reals = field.codes.iter().map(|&code| field.format.value(code)).collect();
            }
            let datapath = architecture.build(&solution.widths, tables)?;
            let budget = solution.budget.of_words(&datapath);
            budget.is_faithful().then(|| Solution { widths: solution.widths.clone(), datapath, budget })
        })
        .unwrap_or(solution)
}
