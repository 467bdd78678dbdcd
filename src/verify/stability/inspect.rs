//! One core, every input.

use rayon::prelude::*;
use serde::Serialize;

use crate::core::{LobeDesign, Measured};
use crate::datapath::evaluate::Evaluator;
use crate::datapath::graph::Graph;
use crate::datapath::range::{Analysis, Ranges};
use crate::fixed::exp2;
use crate::spec::{InputRange, Operand};

/// Blocks of inputs that the range analysis may look at for each row.
pub(super) const MOST_BLOCKS: u64 = 1 << 18;
/// Codes beyond [0, 1] on either side, and at either end of the port, that are tried beside all from 0 to 1.
const BEYOND: i64 = 1024;

/// A value inside a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Signal {
    /// Its name in the HDL, without the stage.
    pub name: String,
    /// Its format.
    pub format: String,
    /// Its bits.
    pub width: u32,
    /// The largest magnitude that it takes where the result depends on it.
    pub largest: f64,
}

/// A place on the lobe and the largest |result - x^n| of all shininesses there, in output ulps.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Place {
    /// What the place is.
    pub name: &'static str,
    /// The error.
    pub ulps: f64,
    /// The shininess with that error.
    pub shininess: f64,
}

/// Where something is worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// How much, in output ulps.
    pub ulps: f64,
    /// The shininess.
    pub shininess: f64,
    /// The cosine: of two neighbours the greater.
    pub cosine: f64,
}

impl Worst {
    fn or(self, other: Self) -> Self {
        if other.ulps > self.ulps { other } else { self }
    }
}

/// What was found of a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Inspection {
    /// The core's name.
    pub core: String,
    /// The rows of its set.
    pub rows: usize,
    /// The inputs that were run.
    pub inputs: u64,
    /// Blocks of inputs that the range analysis looked at.
    pub blocks: u64,
    /// Values that overflow where they are needed: names, with the inputs of the first.
    pub overflows: Vec<String>,
    /// Values of which the analysis cannot tell.
    pub undecided: Vec<String>,
    /// Inputs whose result is another one with wider registers.
    pub wide_differences: u64,
    /// The value with the largest magnitude inside.
    pub largest: Signal,
    /// The widest value inside.
    pub widest: Signal,
    /// Bits that the range analysis took off the formats.
    pub narrowed_bits: u32,
    /// The errors of hardware against method in output ulps, over [0, 1].
    pub measured_ulps: [f64; 2],
    /// What is proved of them.
    pub proved_ulps: [f64; 2],
    /// The largest |result - x^n|.
    pub max_abs: f64,
    /// How far the result at x = 1 is below 1, in ulps; the largest of all rows.
    pub below_one: i64,
    /// The largest result at x = 0, as a code.
    pub at_zero: i64,
    /// Results above 1.
    pub above_one: u64,
    /// Inputs outside [0, 1] whose result is not that of the nearest end.
    pub outside_differences: u64,
    /// Whether the core is proved never to fall as the cosine rises.
    pub monotone: bool,
    /// Neighbouring cosines of which the greater has the lesser result.
    #[serde(rename = "falls")]
    pub decreases: u64,
    /// The largest of these decreases.
    #[serde(rename = "fall")]
    pub max_decrease: Worst,
    /// The largest difference between a step of the result and the step of x^n itself.
    #[serde(rename = "seam")]
    pub max_step_error: Worst,
    /// Named places.
    pub places: Vec<Place>,
}

/// Names of [`Inspection::places`].
const PLACES: [&str; 10] = [
    "x = 0",
    "1 ulp",
    "cusp - 1 ulp",
    "cusp",
    "cusp + 1 ulp",
    "end - 1 ulp",
    "end",
    "end + 1 ulp",
    "1 - 1 ulp",
    "x = 1",
];

/// What one row tells.
#[derive(Clone, Default)]
struct RowStudy {
    wide_differences: u64,
    below_one: i64,
    at_zero: i64,
    above_one: u64,
    outside: u64,
    outside_differences: u64,
    decreases: u64,
    max_decrease: Worst,
    max_step_error: Worst,
    places: [f64; 10],
}

impl Inspection {
    /// Inspects a lobe's core.
    ///
    /// # Panics
    /// For cores whose inputs are too many: see [`super::sampled`].
    #[must_use]
    pub fn of(design: LobeDesign<'_>) -> Self {
        let set = &design.interface.shininess;
        let analysis = Analysis::new(design.function(), design.tables());
        let ranges = analysis.over(&design.regions(), MOST_BLOCKS);
        let wide = analysis.with_spare_bits(&ranges);
        let evaluators = [Evaluator::new(design.graph(), design.tables()), Evaluator::new(&wide, design.tables())];
        let codes = (1usize << design.interface.input_fraction) + 1;
        let logs: Vec<f64> = (0..codes).map(|x| libm::log((x as f64) / (codes - 1) as f64)).collect();
        let rows: Vec<RowStudy> =
            (0..set.rows()).into_par_iter().map(|row| RowStudy::of(design, &evaluators, &logs, row)).collect();

        let measured = Measured::of(design);
        let nodes = &design.function().nodes;
        let named =
            |ids: &mut dyn Iterator<Item = usize>| -> Vec<String> { ids.map(|id| nodes[id].name.clone()).collect() };
        let shininess = |row: usize| set.value(row);
        let place = |(place, &name): (usize, &&'static str)| {
            let (row, ulps) = rows.iter().map(|row| row.places[place]).enumerate().fold(
                (0, 0.0),
                |best: (usize, f64), (row, ulps)| {
                    if ulps > best.1 { (row, ulps) } else { best }
                },
            );
            Place { name, ulps, shininess: shininess(row) }
        };
        let sum = |of: fn(&RowStudy) -> u64| rows.iter().map(of).sum();
        let worst = |of: fn(&RowStudy) -> Worst| rows.iter().map(of).fold(Worst::default(), Worst::or);
        let overflow = |overflow: &crate::datapath::range::Overflow| {
            format!("{} at the inputs {:?}", nodes[overflow.node].name, overflow.inputs)
        };
        Self {
            core: design.spec.name.clone(),
            rows: rows.len(),
            inputs: rows.iter().map(|row| codes as u64 + row.outside).sum(),
            blocks: ranges.blocks,
            overflows: ranges.overflows.iter().map(overflow).collect(),
            undecided: named(&mut (0..nodes.len()).filter(|&id| ranges.undecided[id])),
            wide_differences: sum(|row| row.wide_differences),
            largest: signal(design.function(), &ranges, |signal| signal.largest),
            widest: signal(design.function(), &ranges, |signal| f64::from(signal.width)),
            narrowed_bits: design.narrowed.iter().map(|narrowed| narrowed.bits()).sum(),
            measured_ulps: measured.ulps,
            proved_ulps: design.budget.proved_ulps,
            max_abs: measured.max_abs,
            below_one: rows.iter().map(|row| row.below_one).max().unwrap_or(0),
            at_zero: rows.iter().map(|row| row.at_zero).max().unwrap_or(0),
            above_one: sum(|row| row.above_one),
            outside_differences: sum(|row| row.outside_differences),
            monotone: design.falls.is_proof(),
            decreases: sum(|row| row.decreases),
            max_decrease: worst(|row| row.max_decrease),
            max_step_error: worst(|row| row.max_step_error),
            places: PLACES.iter().enumerate().map(place).collect(),
        }
    }

    /// What a core must keep and this one does not, a line each.
    #[must_use]
    pub fn broken(&self) -> Vec<String> {
        let mut broken: Vec<String> = self.overflows.iter().map(|at| format!("{at} leaves its format")).collect();
        let mut check = |holds: bool, what: String| {
            if !holds {
                broken.push(what);
            }
        };
        check(self.undecided.is_empty(), format!("not proved to stay in their formats: {}", self.undecided.join(", ")));
        check(self.wide_differences == 0, format!("{} results differ with wider registers", self.wide_differences));
        check(self.above_one == 0, format!("{} results are above 1", self.above_one));
        check(self.at_zero == 0, format!("the result at x = 0 is {}, not 0", self.at_zero));
        check(
            self.outside_differences == 0,
            format!("{} inputs outside [0, 1] do not give the ends' results", self.outside_differences),
        );
        check(
            !self.monotone || self.decreases == 0,
            format!("the result falls at {} cosines, by {} ulps at most", self.decreases, self.max_decrease.ulps),
        );
        let [low, high] = self.measured_ulps;
        // Sums of doubles: the last bits are not what is checked.
        let within = self.proved_ulps[0] - 1e-6 <= low && high <= self.proved_ulps[1] + 1e-6;
        check(within, format!("the error of {low:.3}..{high:.3} ulps is outside what is proved"));
        broken
    }
}

/// The signal for which `key` is largest, of those that the result depends on somewhere. A bit of another value is
/// none: its weight is only where that value has it.
pub(super) fn signal(graph: &Graph, ranges: &Ranges, key: impl Fn(&Signal) -> f64) -> Signal {
    let mut best: Option<(f64, Signal)> = None;
    for (node, span) in graph.nodes.iter().zip(&ranges.needed) {
        let (Some(span), width) = (span, node.format.width()) else { continue };
        if width == 1 {
            continue;
        }
        let largest = span.magnitude() as f64 * node.format.lsb();
        let signal = Signal { name: node.name.clone(), format: node.format.to_string(), width, largest };
        let key = key(&signal);
        if best.as_ref().is_none_or(|(known, _)| key > *known) {
            best = Some((key, signal));
        }
    }
    best.expect("the output is needed").1
}

impl RowStudy {
    fn of(design: LobeDesign<'_>, [core, wide]: &[Evaluator; 2], logs: &[f64], row: usize) -> Self {
        let interface = design.interface;
        let (index, n) = (interface.shininess.index_of_row(row), interface.shininess.value(row));
        let one = 1i64 << interface.input_fraction;
        let scale = exp2(interface.output_fraction as i32);
        let mut found = Self::default();
        let mut run = |first: i64, count: usize| {
            let (mut own, mut other) = (vec![0u32; count], vec![0u32; count]);
            core.evaluate(index, first, 1, &mut own);
            wide.evaluate(index, first, 1, &mut other);
            found.wide_differences += own.iter().zip(&other).filter(|(a, b)| a != b).count() as u64;
            own
        };
        let mut outputs = run(0, one as usize + 1);
        let ends = [outputs[0], outputs[one as usize]];
        let mut differing = 0;
        let mut outside = 0;
        if interface.input_range == InputRange::Any {
            let (first, count) = crate::verify::golden::all_codes(design.operand_format());
            let last = first + count as i64 - 1;
            for (from, to, end) in [
                (first, (first + BEYOND).min(-1), ends[0]),
                ((-BEYOND).max(first), -1, ends[0]),
                (one + 1, (one + BEYOND).min(last), ends[1]),
                ((last - BEYOND).max(one + 1), last, ends[1]),
            ] {
                if from <= to {
                    let beyond = run(from, (to - from + 1) as usize);
                    outside += beyond.len() as u64;
                    differing += beyond.iter().filter(|&&output| output != end).count() as u64;
                }
            }
        }
        (found.outside, found.outside_differences) = (outside, differing);
        if interface.operand == Operand::Versine {
            outputs.reverse();
        }
        // From here on the outputs are in the order of the cosines.
        let top = 1i64 << interface.output_fraction;
        found.at_zero = outputs[0].into();
        found.below_one = top - i64::from(outputs[one as usize]);
        found.above_one = outputs.iter().filter(|&&output| i64::from(output) > top).count() as u64;
        // Below e^-40 the power is nothing beside an ulp.
        let exact = |x: usize| if n * logs[x] < -40.0 { 0.0 } else { scale * libm::exp(n * logs[x]) };
        let cosine = |x: usize| x as f64 / one as f64;
        let mut before = exact(0);
        for x in 1..outputs.len() {
            let here = exact(x);
            let step = f64::from(outputs[x]) - f64::from(outputs[x - 1]);
            let at = |ulps: f64| Worst { ulps, shininess: n, cosine: cosine(x) };
            if step < 0.0 {
                found.decreases += 1;
                found.max_decrease = found.max_decrease.or(at(-step));
            }
            found.max_step_error = found.max_step_error.or(at((step - (here - before)).abs()));
            before = here;
        }
        // The cusp is where x^n = 1/2, the end the greatest cosine from which on everything down to 0 gives 0.
        let one = one as usize;
        let cusp = (libm::exp(-std::f64::consts::LN_2 / n) * one as f64) as usize;
        let end = outputs.iter().position(|&output| output > 0).unwrap_or(one).saturating_sub(1);
        let around = |x: usize| [x.saturating_sub(1), x, (x + 1).min(one)];
        let [below_cusp, cusp, above_cusp] = around(cusp);
        let [below_end, end, above_end] = around(end);
        let places = [0, 1, below_cusp, cusp, above_cusp, below_end, end, above_end, one - 1, one];
        found.places = places.map(|x| (f64::from(outputs[x]) - exact(x)).abs());
        found
    }
}
