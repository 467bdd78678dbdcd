//! "Computing just right": the cheapest inner widths whose proved error is below one output ulp.
//!
//! The goal is that of FloPoCo's faithful operators: `|hardware - method| < 1 ulp` for every representable input, at
//! the least cost. Each quantisation adds an error of its own, and these add up nearly exactly; so each width is probed
//! alone (all others at their widest), the sums rank the candidates, and the candidates are then proved in the order of
//! their cost, each by the whole analysis.

use rayon::prelude::*;
use serde::Serialize;

use super::{Architecture, Datapath, Parameter};
use crate::fixed::{Interval, Width, Widths};
use crate::platform::error::Error;

/// What one quantisation contributes to the error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Contribution {
    /// The width's name.
    pub name: &'static str,
    /// What is quantised.
    pub meaning: &'static str,
    /// To how many fraction bits.
    pub frac_bits: i32,
    /// The least and the greatest error in output ulps that the error gains over the widest setting, over all cases.
    pub ulps: [f64; 2],
}

/// The error account of a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Budget {
    /// What each inner width contributes (probed alone).
    pub contributions: Vec<Contribution>,
    /// The proved bounds of `hardware - method` in output ulps, over all cases and inputs.
    pub proved_ulps: [f64; 2],
    /// The part of it that comes from rounding coefficients.
    pub coefficient_ulps: [f64; 2],
    /// The part that comes from the datapath.
    pub arithmetic_ulps: [f64; 2],
    /// The shininess with the largest bound.
    pub worst_shininess: f64,
}

/// The chosen widths, the datapath they give, and its error account.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The inner widths.
    pub widths: Widths,
    /// The datapath with these widths.
    pub datapath: Datapath,
    /// Its error account.
    pub budget: Budget,
}

/// A bound below this part of what is allowed is one below it: the rest covers the errors of the double-precision
/// coefficients (below 1e-13 of values that weigh at most 2^20 ulps) and of the analysis' own sums.
const FAITHFUL: f64 = 1.0 - 1e-6;

/// The sums of single contributions are near the true bound, on either side: candidates up to here are tried.
const HOPEFUL: f64 = 1.12;

fn hull(datapath: &Datapath, part: impl Fn(&super::CaseError) -> Interval) -> [f64; 2] {
    let all = datapath.errors.iter().map(part).reduce(Interval::hull).unwrap_or(Interval::ZERO);
    [all.low, all.high]
}

fn total(datapath: &Datapath) -> [f64; 2] {
    hull(datapath, super::CaseError::total)
}

/// Whether the proved bounds of a datapath's error are below so many output ulps.
#[must_use]
pub fn is_within(datapath: &Datapath, tolerance: f64) -> bool {
    total(datapath).iter().all(|bound| bound.abs() < FAITHFUL * tolerance)
}

fn widths_of(parameters: &[Parameter], values: &[i32]) -> Widths {
    Widths::new(parameters.iter().map(|p| p.width).zip(values.iter().copied()).collect())
}

impl Budget {
    fn of(contributions: Vec<Contribution>, datapath: &Datapath) -> Self {
        let size = |error: &super::CaseError| error.total().magnitude();
        // The first of the largest: `max_by` would take the last.
        let worst = datapath.errors.iter().rev().max_by(|a, b| size(a).total_cmp(&size(b)));
        Self {
            contributions,
            proved_ulps: total(datapath),
            coefficient_ulps: hull(datapath, |e| e.coefficients),
            arithmetic_ulps: hull(datapath, |e| e.arithmetic),
            worst_shininess: worst.map_or(1.0, |error| error.shininess),
        }
    }
}

fn built(architecture: &dyn Architecture, widths: &Widths) -> Option<Datapath> {
    architecture.build(widths, architecture.tables(widths))
}

/// Widths that are probed together, by their places among the parameters, with what each combination of their values
/// adds to the bounds of the error.
struct Probe {
    members: Vec<usize>,
    /// The values of the members, and the additions to the least and the greatest error.
    combinations: Vec<(Vec<i32>, [f64; 2])>,
}

/// Every combination of a value out of each list.
fn combinations(lists: &[Vec<i32>]) -> Vec<Vec<i32>> {
    lists.iter().fold(vec![Vec::new()], |all, list| {
        all.iter().flat_map(|start| list.iter().map(|&value| [start.as_slice(), &[value]].concat())).collect()
    })
}

/// What each group of widths adds on either side, with all others at their widest.
fn probe(architecture: &dyn Architecture, parameters: &[Parameter], widest: &[i32], base: [f64; 2]) -> Vec<Probe> {
    let place = |&width: &Width| parameters.iter().position(|parameter| parameter.width == width);
    let mut groups: Vec<Vec<usize>> =
        architecture.interacting().iter().map(|group| group.iter().filter_map(place).collect()).collect();
    let grouped: Vec<usize> = groups.concat();
    groups.extend((0..parameters.len()).filter(|index| !grouped.contains(index)).map(|index| vec![index]));
    let probe = |members: Vec<usize>| {
        let ranges: Vec<Vec<i32>> = members.iter().map(|&member| parameters[member].range.clone().collect()).collect();
        let added = |chosen: Vec<i32>| {
            let mut values = widest.to_vec();
            members.iter().zip(&chosen).for_each(|(&member, &value)| values[member] = value);
            let error = built(architecture, &widths_of(parameters, &values)).map(|datapath| total(&datapath));
            let added = error.map(|error| [error[0] - base[0], error[1] - base[1]]);
            (chosen, added.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]))
        };
        let combinations = combinations(&ranges).into_par_iter().map(added).collect();
        Probe { members, combinations }
    };
    groups.into_iter().map(probe).collect()
}

/// What [`solve`] makes of a datapath that is accurate enough: the one that is meant, or nothing if it is refused.
pub type Finish<'f> = &'f dyn Fn(&Widths, Datapath) -> Option<Datapath>;

/// So many datapaths may be refused before candidates are left out, more and more of them.
const PATIENCE: usize = 256;

/// Chooses the widths: of those whose datapath is accurate enough and not refused the cheapest, or where very many are
/// refused one that is nearly.
///
/// # Errors
/// If no combination of the offered widths is provably as accurate as the architecture asks for and within the
/// arithmetic of this crate, or all that are are refused.
pub fn solve(architecture: &dyn Architecture, finish: Finish) -> Result<Solution, Error> {
    let first = solve_among(architecture, architecture.parameters(), finish);
    let finest = architecture.finest();
    if first.is_ok() || finest.is_empty() {
        return first;
    }
    solve_among(architecture, finest, finish).or(first)
}

fn solve_among(architecture: &dyn Architecture, parameters: Vec<Parameter>, finish: Finish) -> Result<Solution, Error> {
    let tolerance = architecture.tolerance();
    let widest: Vec<i32> = parameters.iter().map(|p| *p.range.end()).collect();
    let too_wide = || {
        Error::input(
            "the core would need values of more than 126 bits",
            "use fewer fraction bits, a smaller shininess, or the stable form",
        )
    };
    let base = total(&built(architecture, &widths_of(&parameters, &widest)).ok_or_else(too_wide)?);
    let probes = probe(architecture, &parameters, &widest, base);
    let candidates = candidates(architecture, &parameters, &probes, base);

    // In batches, so that the proofs run in parallel.
    let mut refused = 0;
    let mut rest = &candidates[..];
    while !rest.is_empty() {
        // One in so many, once patience is over: whole patiences times an eighth of what was refused.
        let step = 1 + (refused / PATIENCE) * refused / 8;
        let (batch, later) = rest.split_at(rest.len().min(8 * step));
        rest = later;
        // The last is the one with the widest values.
        let batch: Vec<&(f64, Vec<i32>)> = batch.iter().rev().step_by(step).rev().collect();
        let proved: Vec<(&[i32], Datapath)> = batch
            .par_iter()
            .filter_map(|(_, values)| Some((&values[..], built(architecture, &widths_of(&parameters, values))?)))
            .filter(|(_, datapath)| is_within(datapath, tolerance))
            .collect();
        for (values, datapath) in proved {
            let widths = widths_of(&parameters, values);
            if let Some(datapath) = finish(&widths, datapath) {
                let budget = budget(&parameters, &probes, values, &datapath);
                return Ok(Solution { widths, datapath, budget });
            }
            refused += 1;
        }
    }
    if refused > 0 {
        return Err(Error::input(
            format!("with none of {refused} choices of widths that were tried does the output never fall as x rises"),
            "set monotone = false, use the stable form, or other input and output fraction bits",
        ));
    }
    Err(Error::input(
        format!(
            "no offered widths give an error below {tolerance} ulp: at the widest it is bounded by {:+.3}..{:+.3}",
            base[0], base[1]
        ),
        "use the stable form, or other input and output fraction bits",
    ))
}

/// The combinations of widths that may be accurate enough with their costs, the cheapest first.
fn candidates(
    architecture: &dyn Architecture,
    parameters: &[Parameter],
    probes: &[Probe],
    base: [f64; 2],
) -> Vec<(f64, Vec<i32>)> {
    // Each candidate has a combination of each probe.
    let hopeful = HOPEFUL * architecture.tolerance();
    let mut candidates = Vec::new();
    let mut choice = vec![0usize; probes.len()];
    'all: loop {
        let chosen = || choice.iter().zip(probes).map(|(&chosen, probe)| &probe.combinations[chosen]);
        let sum = |side: usize| base[side] + chosen().map(|(_, added)| added[side]).sum::<f64>();
        if sum(0) > -hopeful && sum(1) < hopeful {
            let mut values = vec![0; parameters.len()];
            for (probe, (combination, _)) in probes.iter().zip(chosen()) {
                probe.members.iter().zip(combination).for_each(|(&member, &value)| values[member] = value);
            }
            let cost = architecture.cost(&widths_of(parameters, &values));
            if cost.is_finite() {
                candidates.push((cost, values));
            }
        }
        for (digit, probe) in choice.iter_mut().zip(probes) {
            *digit += 1;
            if *digit < probe.combinations.len() {
                continue 'all;
            }
            *digit = 0;
        }
        break;
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    candidates
}

fn budget(parameters: &[Parameter], probes: &[Probe], values: &[i32], datapath: &Datapath) -> Budget {
    let contribution = |(index, parameter): (usize, &Parameter)| {
        // A group's error is told once, at its first member.
        let of_group = probes.iter().find(|probe| probe.members[0] == index);
        let ulps = of_group.and_then(|probe| {
            let is_chosen = |(combination, _): &&(Vec<i32>, [f64; 2])| {
                probe.members.iter().zip(combination).all(|(&member, &value)| values[member] == value)
            };
            probe.combinations.iter().find(is_chosen).map(|&(_, added)| added)
        });
        Contribution {
            name: parameter.width.0,
            meaning: parameter.meaning,
            frac_bits: values[index],
            ulps: ulps.unwrap_or_default(),
        }
    };
    Budget::of(parameters.iter().enumerate().map(contribution).collect(), datapath)
}
