//! Reflectance models with named parameters. Each is reciprocal and in 1/sr; colours are factors from 0 to 1.
//!
//! Where the printed normalisation gives off more light than comes in, `norm` chooses between the form as `published`
//! and one that is `conserving`: with factors that sum to at most 1, no more than what comes in.

use std::f64::consts::PI;
use std::fmt;

use libm::{exp, exp2, pow, sqrt};

use super::family::PRESETS;
pub use super::family::{Family, Norm, Parameter};
use super::vector::Vector;
use super::{Reflectance, Rgb};
use crate::platform::error::Error;

/// A model with its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    family: Family,
    norm: Norm,
    /// In the order of [`Family::parameters`]; numbers three times.
    values: Vec<Rgb>,
}

impl Model {
    /// The model of a family with its defaults.
    #[must_use]
    pub fn of(family: Family) -> Self {
        Self { family, norm: Norm::Published, values: family.parameters().iter().map(|one| one.default).collect() }
    }

    /// The model of a family's or a preset's name with its defaults.
    ///
    /// # Errors
    /// A name that is none: all of them are listed.
    pub fn named(name: &str) -> Result<Self, Error> {
        let plain = if name == "blinn-phong" { "blinnphong" } else { name };
        if let Some(family) = Family::ALL.into_iter().find(|family| family.name() == plain) {
            return Ok(Self::of(family));
        }
        if let Some((_, family, changes)) = PRESETS.iter().find(|(preset, ..)| *preset == name) {
            let mut model = Self::of(*family);
            changes.iter().try_for_each(|(key, value)| model.set(key, value))?;
            return Ok(model);
        }
        let families = Family::ALL.map(Family::name).join(", ");
        let presets = PRESETS.map(|(name, ..)| name).join(", ");
        Err(Error::input(
            format!("there is no reflectance model `{name}`"),
            format!("models: {families}; presets: {presets}"),
        ))
    }

    /// The names of the presets.
    #[must_use]
    pub fn presets() -> [&'static str; 7] {
        PRESETS.map(|(name, ..)| name)
    }

    /// Its family.
    #[must_use]
    pub fn family(&self) -> Family {
        self.family
    }

    /// How it is normalised.
    #[must_use]
    pub fn norm(&self) -> Norm {
        self.norm
    }

    /// Sets a parameter from text: a number, three of them for a colour's channels with commas between, or `norm`'s
    /// name.
    ///
    /// # Errors
    /// A parameter that the model does not have; what is no number; a number out of range.
    pub fn set(&mut self, name: &str, text: &str) -> Result<(), Error> {
        let family = self.family;
        let here = |what: String, allowed: String| Err(Error::input(format!("{}: {what}", family.name()), allowed));
        if name == "norm" && family.has_norms() {
            self.norm = match text {
                "published" => Norm::Published,
                "conserving" => Norm::Conserving,
                _ => return here(format!("norm = `{text}`"), "norm is `published` or `conserving`".to_owned()),
            };
            return Ok(());
        }
        let Some(place) = family.parameters().iter().position(|one| one.name == name) else {
            let mut names: Vec<&str> = family.parameters().iter().map(|one| one.name).collect();
            if family.has_norms() {
                names.push("norm");
            }
            return here(format!("there is no parameter `{name}`"), format!("it has {}", names.join(", ")));
        };
        let Parameter { colour, range: [low, high], doc, .. } = family.parameters()[place];
        let numbers: Vec<f64> = text.split(',').filter_map(|part| part.trim().parse().ok()).collect();
        let value = match numbers[..] {
            [one] if text.split(',').count() == 1 => [one; 3],
            [r, g, b] if colour && text.split(',').count() == 3 => [r, g, b],
            _ => {
                let form = if colour { "one number, or red,green,blue as in 0.4,0.3,0.1" } else { "one number" };
                return here(format!("{name} = `{text}`"), format!("{name}, the {doc}, is {form}"));
            }
        };
        if !value.iter().all(|value| (low..=high).contains(value)) {
            return here(
                format!("{name} = {text} is out of range"),
                format!("{name}, the {doc}, is from {low} to {high}"),
            );
        }
        self.values[place] = value;
        Ok(())
    }

    /// All parameters in the order of their family, each as [`Model::set`] reads it.
    #[must_use]
    pub fn parameters(&self) -> Vec<(String, String)> {
        let own = self.family.parameters().iter().zip(&self.values).map(|(parameter, value)| {
            let text = match (parameter.colour, value) {
                (true, [r, g, b]) => format!("{r},{g},{b}"),
                (false, [value, ..]) => value.to_string(),
            };
            (parameter.name.to_owned(), text)
        });
        let norm = match self.norm {
            Norm::Published => "published",
            Norm::Conserving => "conserving",
        };
        own.chain(self.family.has_norms().then(|| ("norm".to_owned(), norm.to_owned()))).collect()
    }

    /// The value of a parameter; a number three times.
    ///
    /// # Panics
    /// If the model has no such parameter.
    #[must_use]
    pub fn value(&self, name: &str) -> Rgb {
        let place = self.family.parameters().iter().position(|one| one.name == name);
        self.values[place.expect("a parameter of the model")]
    }
}

impl fmt::Display for Model {
    /// The name and all parameters, as they are given.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.family.name())?;
        self.parameters().iter().try_for_each(|(name, value)| write!(f, " {name}={value}"))
    }
}

/// The cosines that the models are made of.
struct Cosines {
    /// n·l.
    nl: f64,
    /// n·v.
    nv: f64,
    /// n·h.
    nh: f64,
    /// l·h, which is v·h.
    lh: f64,
    /// 1 - (n·h)², without cancellation.
    sine_squared: f64,
}

impl Reflectance for Model {
    fn at(&self, l: Vector, v: Vector, n: Vector) -> Rgb {
        let (nl, nv) = (n.dot(&l), n.dot(&v));
        if nl <= 0.0 || nv <= 0.0 {
            return [0.0; 3];
        }
        // Both are above the surface, so their sum is not 0.
        let sum = l + v;
        let length = sum.norm();
        let h = sum / length;
        let across = n.cross(&h);
        let cosines =
            Cosines { nl, nv, nh: n.dot(&h).min(1.0), lh: (0.5 * length).min(1.0), sine_squared: across.dot(&across) };
        self.of_cosines(&cosines)
    }
}

impl Model {
    fn of_cosines(&self, c: &Cosines) -> Rgb {
        let value = |place: usize| self.values[place];
        let conserving = self.norm == Norm::Conserving;
        match self.family {
            Family::Lambert => value(0).map(|kd| kd / PI),
            Family::BlinnPhong => {
                let (kd, ks, n) = (value(0), value(1), value(2)[0]);
                let factor = if conserving {
                    (n + 2.0) * (n + 4.0) / (8.0 * PI * (exp2(-0.5 * n) + n))
                } else {
                    (n + 2.0) / (2.0 * PI)
                };
                let lobe = factor * pow(c.nh, n);
                [0, 1, 2].map(|i| kd[i] / PI + ks[i] * lobe)
            }
            Family::Ward => {
                let (kd, ks, alpha) = (value(0), value(1), value(2)[0]);
                let a2 = alpha * alpha;
                let bell = exp(-c.sine_squared / (c.nh * c.nh * a2));
                let lobe = if conserving {
                    // H = l + v in place of the unit vector: H·H/(H·n)⁴ is 1/(4 (l·h)² (n·h)⁴).
                    bell / (4.0 * PI * a2 * c.lh * c.lh * pow4(c.nh))
                } else {
                    bell / (4.0 * PI * a2 * sqrt(c.nl * c.nv))
                };
                [0, 1, 2].map(|i| kd[i] / PI + ks[i] * lobe)
            }
            Family::CookTorrance => {
                let (kd, ks, f0, m) = (value(0), value(1), value(2), value(3)[0]);
                let m2 = m * m;
                let d = exp(-c.sine_squared / (c.nh * c.nh * m2)) / (m2 * pow4(c.nh));
                // G/(n·l n·v) with G = min(1, 2 n·h n·v/(v·h), 2 n·h n·l/(v·h)).
                let masking = (1.0 / (c.nl * c.nv)).min(2.0 * c.nh / (c.lh * c.nl.max(c.nv)));
                let lobe = d * masking / PI * if conserving { 0.25 } else { 1.0 };
                [0, 1, 2].map(|i| kd[i] / PI + ks[i] * fresnel(f0[i], c.lh) * lobe)
            }
            Family::Ggx => {
                let (kd, f0, f90, alpha, power) = (value(0), value(1), value(2), value(3)[0], value(4)[0]);
                let a2 = alpha * alpha;
                let spread = c.sine_squared + a2 * c.nh * c.nh;
                let d = a2 / (PI * spread * spread);
                // G1(x)/x, which stays finite at the horizon.
                let shadow = |x: f64| 2.0 / (x + sqrt(x * x + a2 * (1.0 - x * x)));
                let lobe = 0.25 * d * shadow(c.nl) * shadow(c.nv);
                let grazing = pow(1.0 - c.lh, power);
                [0, 1, 2].map(|i| kd[i] / PI + (f0[i] + (f90[i] - f0[i]) * grazing) * lobe)
            }
            Family::AshikhminShirley => {
                let (kd, f0, n) = (value(0), value(1), value(2)[0]);
                let lobe = (n + 1.0) / (8.0 * PI) * pow(c.nh, n) / (c.lh * c.nl.max(c.nv));
                let diffuse = 28.0 / (23.0 * PI) * (1.0 - pow5(1.0 - 0.5 * c.nl)) * (1.0 - pow5(1.0 - 0.5 * c.nv));
                let grazing = pow5(1.0 - c.lh);
                [0, 1, 2].map(|i| kd[i] * (1.0 - f0[i]) * diffuse + (f0[i] + (1.0 - f0[i]) * grazing) * lobe)
            }
        }
    }
}

fn pow4(x: f64) -> f64 {
    // The bell beside it is 0 long before this overflows.
    (x * x * x * x).max(1e-200)
}

fn pow5(x: f64) -> f64 {
    x * x * x * x * x
}

/// The reflectance of unpolarised light at a dielectric whose reflectance at normal incidence is `f0`, for the cosine
/// `c` of incidence.
fn fresnel(f0: f64, c: f64) -> f64 {
    let root = sqrt(f0);
    if root >= 1.0 {
        return 1.0;
    }
    let n = (1.0 + root) / (1.0 - root);
    let g = sqrt((n * n + c * c - 1.0).max(0.0));
    let (less, more) = (g - c, g + c);
    // With n = 1 nothing is reflected; at c = 0 everything else is.
    if more == 0.0 {
        return 0.0;
    }
    let (a, b) = (less / more, (c * more - 1.0) / (c * less + 1.0));
    0.5 * a * a * (1.0 + b * b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fresnel_has_its_limits() {
        assert_eq!((fresnel(1.0, 0.3), fresnel(0.0, 0.5)), (1.0, 0.0));
        assert!((fresnel(0.04, 1.0) - 0.04).abs() < 1e-12 && (fresnel(0.04, 0.0) - 1.0).abs() < 1e-12);
    }
}
