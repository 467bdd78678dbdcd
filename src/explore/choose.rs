//! The cheapest core that meets the constraints, and what just misses it.

use std::collections::BTreeSet;
use std::str::FromStr;

use serde::Serialize;

use super::pareto::dominates;
use super::{Cost, Objective, Point, Results};
use crate::emit::package::counted;
use crate::method::word;
use crate::platform::error::Error;
use crate::spec::{Shininess, SpecFields};
use crate::synth::Tools;
use crate::target::Family;

/// The near misses that a choice names.
pub const MISSES: usize = 3;

/// The largest |result - x^n| that is allowed, as a part of 1: above 0, at most 1.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize)]
pub struct MaxError(pub f64);

impl FromStr for MaxError {
    type Err = String;

    /// Reads a number (`0.01`), a percentage (`1%`) or a power (`2^-7`).
    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<f64>().ok();
        let value = if let Some(percent) = text.strip_suffix('%') {
            number(percent).map(|percent| percent / 100.0)
        } else if let Some((base, exponent)) = text.split_once('^') {
            number(base).zip(number(exponent)).map(|(base, exponent)| libm::pow(base, exponent))
        } else {
            number(text)
        };
        match value.filter(|value| *value > 0.0 && *value <= 1.0) {
            Some(value) => Ok(Self(value)),
            None => Err("an error is above 0 and at most 1, written 0.01, 1% or 2^-7".to_owned()),
        }
    }
}

/// What is asked of a core.
#[derive(Clone, Debug)]
pub struct Constraints {
    /// The largest |result - x^n|.
    pub max_error: MaxError,
    /// The family.
    pub family: Family,
    /// The least median frequency in MHz.
    pub min_mhz: Option<f64>,
    /// What is to be small.
    pub objective: Objective,
    /// The most of each cost.
    pub limits: Vec<(Objective, u32)>,
    /// The shininesses that the core has to serve: exactly this set, or a range that holds this range.
    pub shininess: Shininess,
    /// Keys of the spec that the core must have as they are here; `name`, `languages`, `rom_formats` and the shininess
    /// are not looked at.
    pub keys: SpecFields,
    /// Whether cores are considered that are there to be compared with; those of a method that `keys` name are in any
    /// case.
    pub baselines: bool,
}

/// A core with its cost.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// The core.
    pub point: Point,
    /// What it takes.
    pub cost: Cost,
}

/// The outcome.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Choice {
    /// The cheapest core that meets the constraints.
    pub chosen: Option<Candidate>,
    /// The nearest misses, the nearest first: cores that no other considered core dominates in error, the four costs
    /// and, where a frequency is asked for, the frequency.
    pub misses: Vec<NearMiss<Candidate>>,
    /// The number of cores considered: those of the family, the shininess and the keys that have a cost.
    pub considered: usize,
    /// How many of them meet the constraints.
    pub meeting: usize,
    /// The versions of the tools that the figures come from.
    pub tools: Tools,
}

impl Objective {
    /// This cost, then those that decide between cores that have as much of it.
    #[must_use]
    pub fn order(self) -> [Self; 4] {
        match self {
            Self::Lut => [Self::Lut, Self::Dsp, Self::Bram, Self::Latency],
            Self::Dsp => [Self::Dsp, Self::Bram, Self::Lut, Self::Latency],
            Self::Bram => [Self::Bram, Self::Dsp, Self::Lut, Self::Latency],
            Self::Latency => [Self::Latency, Self::Lut, Self::Dsp, Self::Bram],
            Self::Area => [Self::Area, Self::Dsp, Self::Bram, Self::Latency],
        }
    }

    /// So much of it, for people.
    #[must_use]
    pub fn counted(self, count: u32) -> String {
        let (one, rest) = match self {
            Self::Lut => ("LUT", ""),
            Self::Dsp => ("DSP", ""),
            Self::Bram => ("block RAM", ""),
            Self::Latency => ("clock", " of latency"),
            // A DSP block counts as some hundred of them, and so does a block RAM.
            Self::Area => ("LUT", " of area"),
        };
        counted(count, one) + rest
    }
}

/// How a core stands in a choice.
#[derive(Clone, Debug)]
pub struct Standing {
    /// What it takes.
    pub cost: Cost,
    /// Its errors, less is better; the first decides between cores of the same cost.
    pub errors: Vec<f64>,
    /// What it misses of the constraints, each as log2 of value / allowed and in words; nothing of a core that meets
    /// it.
    pub missed: Vec<(f64, String)>,
}

/// Cores by how well they meet constraints.
#[derive(Clone, Debug)]
pub struct Ranking<T> {
    /// Those that meet it, the cheapest first.
    pub meeting: Vec<T>,
    /// Those of the others that no core dominates in errors, the four costs and, where a frequency is asked for, the
    /// frequency; the nearest first.
    pub misses: Vec<NearMiss<T>>,
}

/// A core that does not meet the constraints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NearMiss<T> {
    /// The core.
    #[serde(flatten)]
    pub core: T,
    /// How far it misses: the sum of log2 of value / allowed over what it misses.
    pub octaves: f64,
    /// What it misses, and by how much.
    pub why: Vec<String>,
}

impl<T> Ranking<T> {
    /// Ranks cores: the cheapest is that with the least of the objective; of equals that with the least of the other
    /// costs in the order of [`Objective::order`], then the least flip-flops, the least error, the first one given.
    #[must_use]
    pub fn of(all: Vec<T>, objective: Objective, min_mhz: Option<f64>, standing: &dyn Fn(&T) -> Standing) -> Self {
        let rank = |Standing { cost, .. }: &Standing| (objective.order().map(|one| one.of(cost)), cost.ff);
        let mut all: Vec<(Standing, T)> = all.into_iter().map(|core| (standing(&core), core)).collect();
        all.sort_by(|(a, _), (b, _)| rank(a).cmp(&rank(b)).then(a.errors[0].total_cmp(&b.errors[0])));
        let values = |(Standing { cost, errors, .. }, _): &(Standing, T)| -> Vec<f64> {
            let costs = Objective::ALL.iter().map(|objective| f64::from(objective.of(cost)));
            let slowness = min_mhz.map(|_| -cost.mhz.unwrap_or(0.0));
            errors.iter().copied().chain(costs).chain(slowness).collect()
        };
        let places: Vec<Vec<f64>> = all.iter().map(values).collect();
        let (mut meeting, mut misses) = (Vec::new(), Vec::new());
        for ((Standing { missed, .. }, core), own) in all.into_iter().zip(&places) {
            if missed.is_empty() {
                meeting.push(core);
            } else if !places.iter().any(|other| dominates(other, own)) {
                let octaves = missed.iter().map(|(octaves, _)| octaves).sum();
                misses.push(NearMiss { core, octaves, why: missed.into_iter().map(|(_, why)| why).collect() });
            }
        }
        misses.sort_by(|a, b| a.octaves.total_cmp(&b.octaves));
        Self { meeting, misses }
    }
}

/// How much slower a core is than asked for, as log2 of asked / own and in words. A frequency that is not known is
/// missed by 1.
#[must_use]
pub fn too_slow(cost: &Cost, min_mhz: Option<f64>) -> Option<(f64, String)> {
    let least = min_mhz?;
    match cost.mhz {
        Some(mhz) if mhz >= least => None,
        Some(mhz) => Some((libm::log2(least / mhz), format!("it is {:.1} MHz too slow", least - mhz))),
        None => Some((1.0, format!("its frequency is not known: {}", cost.no_mhz.unwrap_or("it was not placed")))),
    }
}

/// The spec of a point, as far as this version of the program knows its keys.
fn fields(point: &Point) -> Option<SpecFields> {
    SpecFields::parse(&point.spec, &point.id).ok()
}

/// Whether a core for `own` serves `asked` with the same meaning of the codes of `in_n`.
fn serves(own: &Shininess, asked: &Shininess) -> bool {
    match (own, asked) {
        (Shininess::Range(first, last), Shininess::Range(from, to)) => first <= from && to <= last,
        _ => own == asked,
    }
}

impl Constraints {
    /// Whether the point is one of those asked for, whatever its error and cost.
    fn asks_for(&self, point: &Point) -> bool {
        // Who names the method wants it, whatever it is there for.
        let compared_only = point.baseline && !self.baselines && self.keys.method.is_none();
        if point.family != self.family || compared_only {
            return false;
        }
        let Some(own) = fields(point) else { return false };
        let wanted = SpecFields {
            name: None,
            languages: None,
            rom_formats: None,
            shininess: None,
            material: None,
            ..self.keys.clone()
        };
        let same = wanted.or(own.clone()) == own;
        same && own.resolve().is_ok_and(|spec| serves(&spec.block.lobe().interface.shininess, &self.shininess))
    }

    /// What a candidate misses, each as log2 of value / allowed and in words.
    fn missed(&self, Candidate { point, cost }: &Candidate) -> Vec<(f64, String)> {
        let mut missed = Vec::new();
        let MaxError(allowed) = self.max_error;
        if point.max_abs > allowed {
            let ratio = point.max_abs / allowed;
            missed.push((libm::log2(ratio), format!("its error is {ratio:.3} times what is asked for")));
        }
        missed.extend(too_slow(cost, self.min_mhz));
        for &(objective, most) in &self.limits {
            let own = objective.of(cost);
            if own > most {
                let octaves = libm::log2(f64::from(own + 1) / f64::from(most + 1));
                missed.push((octaves, format!("it has {} too many", objective.counted(own - most))));
            }
        }
        missed
    }

    /// Chooses among results.
    ///
    /// They are ranked as [`Ranking::of`] says; the results are in the order of their ids.
    ///
    /// # Errors
    /// Results that hold nothing for the family and the shininess, or figures of several versions of the tools.
    pub fn choose(&self, results: &Results) -> Result<Choice, Error> {
        let candidate = |point: &Point| point.cost().map(|cost| Candidate { point: point.clone(), cost });
        let all: Vec<Candidate> =
            results.points().iter().filter(|point| self.asks_for(point)).filter_map(candidate).collect();
        // Cores that were not placed are of no nextpnr, and may stand beside those of one.
        let tools = || all.iter().filter_map(|candidate| candidate.point.tools());
        let yosys: BTreeSet<&str> = tools().map(|tools| tools.yosys.as_str()).collect();
        let nextpnr: BTreeSet<&str> = tools().filter_map(|tools| tools.nextpnr.as_deref()).collect();
        if let Some(versions) = [&yosys, &nextpnr].into_iter().find(|versions| versions.len() > 1) {
            let versions: Vec<&str> = versions.iter().copied().collect();
            return Err(Error::input(
                format!("the results hold figures of {}", versions.join(" and of ")),
                "figures of two versions cannot be compared: explore with one of them",
            ));
        }
        let placed = tools().find(|tools| tools.nextpnr.is_some());
        let tools = placed.or_else(|| tools().next()).cloned().ok_or_else(|| {
            let (family, set) = (word(&self.family), &self.shininess);
            let method = self.keys.method.map(|method| format!(" --method {}", word(&method))).unwrap_or_default();
            Error::input(
                format!("the results hold no such core for {family} that serves the shininess {set}"),
                format!("make some: brdfgen explore --family {family}{method} --shininess '{set}' --results FILE.db"),
            )
        })?;
        let considered = all.len();
        let standing = |candidate: &Candidate| Standing {
            cost: candidate.cost,
            errors: vec![candidate.point.max_abs],
            missed: self.missed(candidate),
        };
        let Ranking { meeting, mut misses } = Ranking::of(all, self.objective, self.min_mhz, &standing);
        misses.truncate(MISSES);
        Ok(Choice { considered, meeting: meeting.len(), chosen: meeting.into_iter().next(), misses, tools })
    }

    /// The spec of a chosen core, with the shininess, name, languages and ROM formats that are asked for.
    ///
    /// # Errors
    /// A name or a list that is not allowed.
    pub fn spec_of(&self, chosen: &Candidate) -> Result<SpecFields, Error> {
        let own = SpecFields::parse(&chosen.point.spec, &chosen.point.id)?;
        let shininess = match &self.shininess {
            Shininess::Range(..) => SpecFields { shininess: Some(self.shininess.clone()), ..SpecFields::default() },
            _ => SpecFields::default(),
        };
        let given = SpecFields { shininess: None, material: None, ..self.keys.clone() };
        Ok(given.or(shininess).or(own))
    }
}
