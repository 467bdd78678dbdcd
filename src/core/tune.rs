//! Fitted coefficients as ROM words: the search over the integers about the rounded ones, so that what becomes least is
//! the error of what the hardware computes, its roundings included.

use std::collections::VecDeque;

use crate::datapath::evaluate::Evaluator;
use crate::datapath::widths::is_within;
use crate::datapath::{Architecture, Datapath};
use crate::fixed::{Table, Widths, exp2};
use crate::lobe;
use crate::method::{Check, Row};
use crate::spec::{LobeSpec, Operand};

/// The most versines at which a row's error is taken.
const MOST_POINTS: i128 = 2048;
/// Past this depth, s = n u, the power is below 2^-23 and no core has anything but 0 or a held value.
const DEEPEST: f64 = 16.0;
/// Points of a block that is looked at first: as many as the evaluator computes at a time.
const BLOCK: usize = 64;
/// The blocks that are looked at first: an error curve that is as flat as it can be has about so many summits.
const WITNESSES: usize = 6;
/// Codes on either side of where the output fell with other words that are looked at first.
const NEAR: i64 = BLOCK as i64 / 2 - 1;
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

/// How far from the words of the least error those are looked for with which the output never falls, by how many fields
/// there are from this one on: the constant moves the whole row, and a little of it may be all that is needed.
const REACH: [i128; 4] = [0, 1, 3, 8];

/// The search for the words of a row of the coefficient ROM.
struct Search<'s> {
    spec: &'s LobeSpec,
    datapath: &'s Datapath,
    memory: usize,
    fields: Vec<usize>,
    /// Memories of one row each, which every address reads.
    tables: Vec<Table>,
    /// `None` where nothing of what it serves counts.
    points: Option<Points>,
    witnesses: VecDeque<usize>,
    /// The operand codes of the first versine that the row serves and of the last.
    codes: [i64; 2],
    index: u32,
    /// The lesser of two operand codes between which the output was last seen to fall: most other words fail near it.
    fallen: Option<i64>,
}

impl<'s> Search<'s> {
    fn new(
        spec: &'s LobeSpec,
        architecture: &dyn Architecture,
        datapath: &'s Datapath,
        memory: usize,
        row: usize,
    ) -> Option<Self> {
        let table = &datapath.tables[memory];
        let [first, last] = architecture.versines(row)?;
        let one = 1i128 << spec.interface.input_fraction;
        let is_searched = |&field: &usize| architecture.searched().contains(&table.fields[field].name);
        let only = |other: &Table| match other.key == table.key {
            true => other.only(row / (table.rows() / other.rows())),
            false => other.clone(),
        };
        Some(Self {
            spec,
            datapath,
            memory,
            fields: (0..table.fields.len()).filter(is_searched).collect(),
            tables: datapath.tables.iter().map(only).collect(),
            points: Points::of(spec, architecture, table, row),
            witnesses: VecDeque::new(),
            codes: [first, last].map(|versine| match spec.interface.operand {
                Operand::Versine => versine.min(one) as i64,
                Operand::Cos => (one - versine.min(one)) as i64,
            }),
            index: spec.interface.shininess.index_of_row(row / (table.rows() / spec.interface.shininess.rows())),
            fallen: None,
        })
    }

    fn set(&mut self, words: &[i128]) {
        for (&field, &code) in self.fields.iter().zip(words) {
            self.tables[self.memory].fields[field].codes[0] = code;
        }
    }

    /// The largest error of these words where it counts, if it is less than `bound`.
    fn error_below(&mut self, bound: f64, words: &[i128]) -> Option<f64> {
        self.set(words);
        let Some(points) = &self.points else { return (0.0 < bound).then_some(0.0) };
        points.error_below(bound, &mut self.witnesses, self.spec, self.datapath, &self.tables)
    }

    fn fits(&self, words: &[i128]) -> bool {
        self.fields.iter().zip(words).all(|(&field, code)| {
            let format = self.datapath.tables[self.memory].fields[field].format;
            (format.min_code()..=format.max_code()).contains(code)
        })
    }

    /// All words that are no further from these than `reach` says of each field, but for themselves.
    fn about(&self, words: &[i128], reach: &[i128]) -> Vec<Vec<i128>> {
        let mut all = vec![Vec::new()];
        for (&code, &reach) in words.iter().zip(reach) {
            let with = |by: i128| all.iter().map(move |start: &Vec<i128>| [start.as_slice(), &[code + by]].concat());
            all = (-reach..=reach).flat_map(with).collect();
        }
        all.retain(|other| other != words && self.fits(other));
        all
    }

    /// The words on the way of steepest descent over the neighbouring integers, from the given ones to those of the
    /// least error found.
    fn descent(&mut self, start: Vec<i128>) -> Vec<Vec<i128>> {
        let mut way = vec![start];
        if self.points.is_none() {
            return way;
        }
        let mut least = self.error_below(f64::INFINITY, &way[0]).unwrap_or(f64::INFINITY);
        for _ in 0..MOST_STEPS {
            let mut step: Option<(f64, Vec<i128>)> = None;
            let best = &way[way.len() - 1];
            for words in self.about(best, &vec![1; best.len()]) {
                let bound = step.as_ref().map_or(least, |(error, _)| *error);
                step = self.error_below(bound, &words).map(|error| (error, words)).or(step);
            }
            let Some((error, words)) = step else { break };
            least = error;
            way.push(words);
        }
        way
    }

    /// The outputs of these words at the first and the last versine, if none in between is greater than the one before
    /// it; else `None`.
    fn falling(&mut self, check: &Check, words: &[i128]) -> Option<[u32; 2]> {
        self.set(words);
        let evaluator = Evaluator::new(&self.datapath.graph, &self.tables);
        let row = Row::new(&evaluator, self.index, self.spec.interface.operand);
        let [first, last] = self.codes;
        let [from, to] = [first.min(last), first.max(last)];
        let suspect = self.fallen.map(|code| row.falls((code - NEAR).max(from), (code + NEAR).min(to)));
        let falls = check.blocks(from, to).flat_map(|(first, last)| row.falls(first, last));
        let fallen = suspect.into_iter().flatten().chain(falls).next();
        self.fallen = fallen.map(|(code, _)| code).or(self.fallen);
        fallen.is_none().then(|| self.codes.map(|code| row.output(code)))
    }

    /// The words with the least error found with which the output never rises with the versine and begins at `most` or
    /// below, and its last value.
    ///
    /// `None` if there are none whose error is `slack` ulps at most above a tenth more than the least.
    fn best_falling(&mut self, check: &Check, start: Vec<i128>, most: u32, slack: f64) -> Option<(Vec<i128>, u32)> {
        let way = self.descent(start);
        let least = self.error_below(f64::INFINITY, way.last()?)?;
        let allowed = 1.1 * least + slack * exp2(-(self.spec.interface.output_fraction as i32));
        for words in way.iter().rev() {
            if self.error_below(allowed, words).is_none() {
                break;
            }
            if let Some([_, last]) = self.falling(check, words).filter(|&[first, _]| first <= most) {
                return Some((words.clone(), last));
            }
        }
        let mut middle = way.into_iter().next_back()?;
        self.set(&middle);
        let evaluator = Evaluator::new(&self.datapath.graph, &self.tables);
        let first = Row::new(&evaluator, self.index, self.spec.interface.operand).output(self.codes[0]);
        let field = |place: usize| &self.datapath.tables[self.memory].fields[self.fields[place]];
        if let Some(constant) = (0..middle.len()).find(|&place| field(place).name == "c") {
            let finer = field(constant).format.frac_bits - self.spec.interface.output_fraction as i32;
            middle[constant] -= i128::from(first.saturating_sub(most)) << finer.max(0);
        }
        let reach: Vec<i128> = (0..middle.len()).map(|place| REACH[middle.len() - place]).collect();
        let mut found: Option<(f64, Vec<i128>, u32)> = None;
        for words in self.about(&middle, &reach) {
            if let Some([_, last]) = self.falling(check, &words).filter(|&[first, _]| first <= most) {
                let bound = found.as_ref().map_or(allowed, |(error, ..)| *error);
                found = self.error_below(bound, &words).map(|error| (error, words, last)).or(found);
            }
        }
        found.map(|(_, words, last)| (words, last))
    }
}

/// The words of the rows of the coefficient ROM that serve a shininess; `None` if the output is to be falling with
/// the versine, with an error so many ulps larger at most, and no words are found with which it is.
fn searched(
    spec: &LobeSpec,
    architecture: &dyn Architecture,
    datapath: &Datapath,
    memory: usize,
    shininess: usize,
    falling: Option<(&Check, f64)>,
) -> Option<Vec<Vec<i128>>> {
    let table = &datapath.tables[memory];
    let parts = table.rows() / spec.interface.shininess.rows();
    // The output at the last versine before the part.
    let mut most = u32::MAX;
    (shininess * parts..(shininess + 1) * parts)
        .map(|row| {
            let Some(mut search) = Search::new(spec, architecture, datapath, memory, row) else {
                let fields = table.fields.iter().filter(|field| architecture.searched().contains(&field.name));
                return Some(fields.map(|field| field.codes[row]).collect());
            };
            let start = search.fields.iter().map(|&field| table.fields[field].codes[row]).collect();
            let Some((check, slack)) = falling else { return search.descent(start).pop() };
            let (words, last) = search.best_falling(check, start, most, slack)?;
            most = last;
            Some(words)
        })
        .collect()
}

/// The memories of a datapath with the words that the search finds; `None` if it has none to search, or finds none.
fn with_searched(
    spec: &LobeSpec,
    architecture: &dyn Architecture,
    check: Option<(&Check, f64)>,
    datapath: &Datapath,
    memory: usize,
) -> Option<Vec<Table>> {
    let mut tables = datapath.tables.clone();
    // Between interpolated rows no word has an error of its own.
    if spec.interface.shininess.frac_bits() > 0 {
        return Some(tables);
    }
    let words = |shininess: usize| searched(spec, architecture, datapath, memory, shininess, check);
    let rows = check.map_or(&Check::new(&spec.interface), |(check, _)| check).each_row(words)?;
    let fields = tables[memory].fields.iter_mut().filter(|field| architecture.searched().contains(&field.name));
    for (place, field) in fields.enumerate() {
        field.codes = rows.iter().flatten().map(|words| words[place]).collect();
    }
    Some(tables)
}

/// The datapath with the words that are its own: where coefficients are fitted, those that the search finds, which are
/// from here on the method's coefficients themselves, or the rounded ones where the analysis cannot prove the found
/// ones. `None` where a check is given and the output falls as the cosine rises, or the search has to go so many ulps
/// further for it.
pub(super) fn finished(
    spec: &LobeSpec,
    architecture: &dyn Architecture,
    check: Option<(&Check, f64)>,
    widths: &Widths,
    datapath: Datapath,
) -> Option<Datapath> {
    let holds = |datapath: &Datapath| check.is_none_or(|(check, _)| check.holds(datapath));
    let coefficients = datapath.tables.iter().position(|table| table.name == Table::COEFFICIENTS);
    if let Some(memory) = coefficients.filter(|_| spec.is_fitted() && !architecture.searched().is_empty()) {
        let found = with_searched(spec, architecture, check, &datapath, memory);
        let own = [found, Some(datapath.tables.clone())].into_iter().flatten().find_map(|mut tables| {
            for field in &mut tables[memory].fields {
                field.reals = field.codes.iter().map(|&code| field.format.value(code)).collect();
            }
            architecture.build(widths, tables).filter(|datapath| is_within(datapath, 1.0) && holds(datapath))
        });
        if own.is_some() {
            return own;
        }
    }
    Some(datapath).filter(|datapath| holds(datapath))
}
