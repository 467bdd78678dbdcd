//! What is approximated, where, and what counts as its error.

use crate::lobe;
use crate::platform::error::Error;

/// What a fit makes as small as possible. `f = x^n` is the exact lobe, `g` the approximation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Objective {
    /// The largest `|g - f|` over all cosines in [0, 1].
    #[default]
    MaxAbs,
    /// The largest `|g - f|` where `f >= level`, with the level in 0.001..=0.99. Past the level the lobe is whatever
    /// the shape gives, within [0, 1].
    MaxAbsLevel {
        /// The exact lobe's value down to which errors count: 0.5 is the epicentre.
        level: f64,
    },
    /// The largest `|g - f| / f` where `f >= level`, with the level in 0.001..=0.99. A relative error of 1 or more is
    /// reached by the zero lobe too; where a shape can do no better, it gets the coefficients of
    /// [`Objective::MaxAbsLevel`].
    MaxRel {
        /// The exact lobe's value down to which errors count.
        level: f64,
    },
    /// The largest `|g - f| f^power` over all cosines in [0, 1], with the power in -0.5..=1: above 0 it favours the
    /// highlight, below 0 the tail (-1 would be the relative error, which no lobe with a zero can keep below 1). In the
    /// weight, f is taken as at least 2^-16, which keeps it finite.
    Weighted {
        /// The exponent of the weight; 0 is [`Objective::MaxAbs`].
        power: f64,
    },
}

impl std::fmt::Display for Objective {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::MaxAbs => write!(f, "max-abs"),
            Self::MaxAbsLevel { level } => write!(f, "max-abs:{level}"),
            Self::MaxRel { level } => write!(f, "max-rel:{level}"),
            Self::Weighted { power } => write!(f, "weighted:{power}"),
        }
    }
}

impl std::str::FromStr for Objective {
    type Err = String;

    /// Reads `max-abs`, `max-abs:LEVEL`, `max-rel:LEVEL` or `weighted:POWER`.
    fn from_str(text: &str) -> Result<Self, String> {
        let allowed = "an objective is max-abs, max-abs:LEVEL, max-rel:LEVEL or weighted:POWER";
        let number = |text: &str| text.parse::<f64>().map_err(|_| format!("`{text}` is not a number; {allowed}"));
        match text.split_once(':') {
            None if text == "max-abs" => Ok(Self::MaxAbs),
            Some(("max-abs", level)) => Ok(Self::MaxAbsLevel { level: number(level)? }),
            Some(("max-rel", level)) => Ok(Self::MaxRel { level: number(level)? }),
            Some(("weighted", power)) => Ok(Self::Weighted { power: number(power)? }),
            _ => Err(format!("`{text}` is not an objective; {allowed}")),
        }
    }
}

crate::platform::as_text!(Objective);

/// The least f in [`Objective::Weighted`].
const WEIGHT_FLOOR: f64 = 1.0 / 65_536.0;

impl Objective {
    /// Refuses levels and powers out of range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match *self {
            Self::MaxAbsLevel { level } | Self::MaxRel { level } if !(0.001..=0.99).contains(&level) => {
                Err(Error::input(
                    format!("level {level} of the objective is out of range"),
                    "the level is the exact lobe's value down to which errors count, from 0.001 to 0.99",
                ))
            }
            Self::Weighted { power } if !(-0.5..=1.0).contains(&power) => Err(Error::input(
                format!("power {power} of the objective's weight is out of range"),
                "errors are weighted with the exact lobe to a power from -0.5 to 1",
            )),
            _ => Ok(()),
        }
    }

    /// Whether errors count where the exact lobe is `f`.
    pub(crate) fn counts(&self, f: f64) -> bool {
        match *self {
            Self::MaxAbs | Self::Weighted { .. } => true,
            Self::MaxAbsLevel { level } | Self::MaxRel { level } => f >= level,
        }
    }

    /// The factor of `|g - f|` where the exact lobe is `f`.
    pub(crate) fn weight(&self, f: f64) -> f64 {
        match *self {
            Self::MaxAbs | Self::MaxAbsLevel { .. } => 1.0,
            Self::MaxRel { level } => 1.0 / f.max(level),
            Self::Weighted { power } => libm::pow(f.max(WEIGHT_FLOOR), power),
        }
    }

    /// The exact lobe where leaving it out (`g = 0`) has the given error.
    pub(super) fn unweighted(&self, error: f64) -> f64 {
        match *self {
            Self::MaxAbs | Self::MaxAbsLevel { .. } => error,
            Self::MaxRel { level } => error * level,
            Self::Weighted { power } => {
                let value = libm::pow(error, 1.0 / (1.0 + power));
                if value >= WEIGHT_FLOOR { value } else { error / self.weight(0.0) }
            }
        }
    }

    /// The depth `-ln f` where the weight has a kink, and so perhaps the error its largest value.
    fn kink(&self) -> Option<f64> {
        matches!(self, Self::Weighted { .. }).then(|| -libm::log(WEIGHT_FLOOR))
    }

    /// The versine up to which errors count.
    pub(super) fn reach(&self, n: f64) -> f64 {
        match *self {
            Self::MaxAbs | Self::Weighted { .. } => 1.0,
            Self::MaxAbsLevel { level } | Self::MaxRel { level } => versine(n, -libm::log(level)),
        }
    }
}

/// The versine where `x^n = e^-depth`.
pub(super) fn versine(n: f64, depth: f64) -> f64 {
    -libm::expm1(-depth / n)
}

/// A point at which errors are looked at.
pub(super) struct Sample {
    pub u: f64,
    pub exact: f64,
    pub weight: f64,
}

/// The exact lobe on an interval of the versine, sampled, with the error's weight.
pub(super) struct Target {
    n: f64,
    objective: Objective,
    /// In increasing order of u; the first and the last are the ends of the interval.
    pub samples: Vec<Sample>,
}

/// The depth `-ln f` past which the exact lobe is 0 for every purpose here.
pub(super) const DEEP: f64 = 40.0;

impl Target {
    /// The whole interval in which the objective counts errors.
    ///
    /// The samples lie at depths `-ln f`: for all shininesses the same features lie at the same depths. Past `DEEP` no
    /// shape has an extremum inside; its far end is a sample.
    pub fn whole(n: f64, objective: &Objective) -> Self {
        let mut depths: Vec<f64> = match *objective {
            Objective::MaxAbsLevel { level } | Objective::MaxRel { level } => {
                lobatto(0.0, -libm::log(level), 96).collect()
            }
            Objective::MaxAbs | Objective::Weighted { .. } => {
                (0..=240).map(|i| DEEP * (f64::from(i) / 240.0) * (f64::from(i) / 240.0)).collect()
            }
        };
        depths.extend(objective.kink());
        depths.sort_by(f64::total_cmp);
        let mut target = Self { n, objective: *objective, samples: Vec::with_capacity(depths.len() + 1) };
        for depth in depths {
            let exact = libm::exp(-depth);
            target.samples.push(Sample { u: versine(n, depth), exact, weight: objective.weight(exact) });
        }
        if objective.reach(n) == 1.0 {
            target.samples.push(Sample { u: 1.0, exact: 0.0, weight: objective.weight(0.0) });
        }
        target
    }

    /// The interval from `low` to `high`, sampled evenly enough both in u and in depth.
    pub fn interval(n: f64, low: f64, high: f64, objective: &Objective) -> Self {
        let depth = |u: f64| (-n * libm::log1p(-u)).min(DEEP);
        let mut places: Vec<f64> = lobatto(low, high, 32).collect();
        if depth(high) - depth(low) > 4.0 {
            places.extend(lobatto(depth(low), depth(high), 48).map(|depth| versine(n, depth).clamp(low, high)));
        }
        places.extend(objective.kink().map(|depth| versine(n, depth)).filter(|u| (low..=high).contains(u)));
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut target = Self { n, objective: *objective, samples: Vec::with_capacity(places.len()) };
        target.samples.extend(places.into_iter().map(|u| {
            let exact = lobe::exact(n, u);
            Sample { u, exact, weight: objective.weight(exact) }
        }));
        target
    }

    /// The first and the last versine.
    pub fn ends(&self) -> (f64, f64) {
        (self.samples[0].u, self.samples[self.samples.len() - 1].u)
    }

    /// The exact lobe and the weight anywhere.
    pub fn at(&self, u: f64) -> Sample {
        let exact = lobe::exact(self.n, u);
        Sample { u, exact, weight: self.objective.weight(exact) }
    }
}

/// The extrema of a Chebyshev polynomial of the degree `count`, on [low, high], in increasing order; the ends are
/// exact.
fn lobatto(low: f64, high: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| {
        let sine = libm::sin(std::f64::consts::FRAC_PI_2 * f64::from(i) / f64::from(count));
        if i == count { high } else { low + (high - low) * sine * sine }
    })
}
