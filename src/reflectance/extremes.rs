//! The forms where they degenerate, measured: every value has to be finite, not negative and within a bound that holds
//! for whatever is stored, where there is a limit it has to be met, and threads must not matter.
//!
//! The bounds follow from how values are made. A look-up is a weighted mean of texels, so the paper's form gives at
//! most the largest sample that it stores, and the other two at most the largest E f, the largest full scale, times
//! n·l.

use rayon::prelude::*;
use serde::Serialize;

use super::form::{Form, FormKind, FormSpec};
use super::vector::{self, Light, Vector};
use super::{Model, Reflectance, Rgb, Table, Texel};
use crate::platform::error::Error;

/// Lights in the sum over many.
const LIGHTS: usize = 64;
/// What rounding in single precision may add to a bound, as a part of it.
const ROUNDING: f64 = 1e-5;

/// What was found of one case in one form.
#[derive(Clone, Debug, Serialize)]
pub struct Extreme {
    /// The case.
    pub case: &'static str,
    /// The form.
    pub form: String,
    /// Values that were looked at.
    pub values: usize,
    /// The largest of them.
    pub largest: f64,
    /// The largest part of its bound that a value reaches; 0 where the bound is 0 and kept.
    pub of_bound: f64,
    /// How far values are from their limit, where the case has one, and how far they may be.
    pub off_limit: Option<[f64; 2]>,
    /// What does not hold.
    pub broken: Vec<String>,
}

impl Extreme {
    /// What does not hold, a line each.
    pub fn failures(&self) -> impl Iterator<Item = String> {
        self.broken.iter().map(|what| format!("FAIL {}, {}: {what}", self.case, self.form))
    }
}

/// The chapter's beginning.
const CHAPTER: &str = "# Measured reflectance at the extremes

`brdfgen reflectance stability --out FILE.md` measures this chapter. Every value has to be finite and not negative, \
and no larger than a bound that
holds whatever is stored: of `paper` the largest sample, of `half` and `bivariate` the largest full scale times n·l. \
Where a case has a limit
(0 at φ = 180°, the value from beside it at φ = 0, the sum of single lights), values have to be within what the last \
column allows.
";

/// What was found, as a chapter in Markdown.
#[must_use]
pub fn chapter(found: &[Extreme]) -> String {
    let all_hold = found.iter().all(|one| one.broken.is_empty());
    let mut text = format!(
        "{CHAPTER}\n{}\n\n| case | form | largest value | part of its bound | off its limit, allowed |\n| --- | --- | \
         ---: | ---: | ---: |\n",
        if all_hold { "It holds for all of them." } else { "**It does not hold for all of them.**" }
    );
    for Extreme { case, form, largest, of_bound, off_limit, .. } in found {
        let limit = off_limit.map_or_else(|| "-".to_owned(), |[off, within]| format!("{off:.1e}, {within:.1e}"));
        text += &format!("| {case} | {form} | {largest:.4e} | {of_bound:.3} | {limit} |\n");
    }
    text
}

/// A case: what is looked up.
struct Case {
    name: &'static str,
    reflectance: Box<dyn Reflectance>,
    lights: Vec<Light>,
    normals: Vec<Vector>,
    /// The limit of each value, given a light and a normal, and how far from it a value may be.
    limit: Option<Limit>,
}

struct Limit {
    of: fn(&Form, Light, Vector) -> Rgb,
    within: f64,
    /// Whether the form has this limit.
    applies: fn(&FormSpec) -> bool,
}

fn with(name: &str, key: &str, value: &str) -> Result<Box<dyn Reflectance>, Error> {
    let mut model = Model::named(name)?;
    model.set(key, value)?;
    Ok(Box::new(model))
}

fn plain(name: &str) -> Result<Box<dyn Reflectance>, Error> {
    Ok(Box::new(Model::named(name)?))
}

/// A table in which all cells but one have the same value.
fn table(rest: f32, one: f32) -> Result<Box<dyn Reflectance>, Error> {
    let shape = [super::table::THETA_H, super::table::THETA_D, super::table::PHI_D];
    let mut cells = vec![[rest; 3]; shape.iter().product()];
    cells[90 + shape[2] * (30 + shape[1] * 12)] = [one; 3];
    Ok(Box::new(Table::new(shape, cells, "the extreme table")?))
}

/// Normals all over the visible half, turned by the light's azimuth.
fn around(gamma: f64) -> Vec<Vector> {
    let ring = |theta: f64| (0..12).map(move |step| Light::new(theta, gamma + 30.0 * f64::from(step)).direction());
    [0.0, 12.0, 34.0, 56.0, 78.0, 89.9].into_iter().flat_map(ring).collect()
}

const GAMMA: f64 = 123.0;

fn cases() -> Result<Vec<Case>, Error> {
    let light = |phi: f64| Light::new(phi, GAMMA);
    let all = || [0.0, 1e-9, 20.0, 45.0, 90.0, 135.0, 160.0, 176.0, 179.999_999].map(light).to_vec();
    let zero: fn(&Form, Light, Vector) -> Rgb = |_, _, _| [0.0; 3];
    let any: fn(&FormSpec) -> bool = |_| true;
    let sliced: fn(&FormSpec) -> bool = |spec| spec.kind != FormKind::Paper;
    let turned = |n: Vector| vector::about_z(n, vector::sine_cosine(GAMMA));
    let case = |name, reflectance, lights, normals, limit| Case { name, reflectance, lights, normals, limit };
    Ok(vec![
        case(
            "a normal on the terminator",
            plain("ggx")?,
            [20.0, 75.0, 150.0].map(light).to_vec(),
            [20.0, 75.0, 150.0].map(|phi| Light::new(phi - 90.0, GAMMA).direction()).to_vec(),
            None,
        ),
        case(
            "a normal a hair inside the terminator",
            plain("ggx")?,
            vec![light(75.0)],
            vec![Light::new(-15.0 + 1e-6, GAMMA).direction()],
            // n·l is 1.7e-8 there.
            Some(Limit { of: zero, within: 1e-5, applies: sliced }),
        ),
        case(
            "a normal along ±y of the light's frame",
            plain("gold-paint")?,
            all(),
            [Vector::y(), -Vector::y()].map(turned).to_vec(),
            None,
        ),
        case(
            "the light behind the viewer, φ = 0",
            plain("ggx")?,
            vec![Light::new(0.0, 0.0), Light::new(0.0, 77.0), Light::new(0.0, 291.0)],
            around(0.0),
            // From beside it.
            Some(Limit { of: |form, light, n| form.at(Light::new(1e-7, light.gamma), n), within: 1e-3, applies: any }),
        ),
        case(
            "the light behind the object, φ = 180°",
            plain("ggx")?,
            vec![light(180.0)],
            around(GAMMA),
            Some(Limit { of: zero, within: 0.0, applies: sliced }),
        ),
        case("the last image's own angle, 135°", plain("lambert")?, vec![light(135.0)], around(GAMMA), None),
        case("past the last image", plain("ggx")?, [150.0, 170.0, 179.0].map(light).to_vec(), around(GAMMA), None),
        case("the half vector at the horizon", plain("ggx")?, vec![light(179.9)], around(GAMMA), None),
        case(
            "a black table",
            table(0.0, 0.0)?,
            all(),
            around(GAMMA),
            Some(Limit { of: zero, within: 0.0, applies: any }),
        ),
        case("a black table with one cell of 1e6", table(0.0, 1e6)?, all(), around(GAMMA), None),
        case("a table of 1 with one cell of 1e6", table(1.0, 1e6)?, all(), around(GAMMA), None),
        case("ggx, α = 0.001", with("ggx", "alpha", "0.001")?, all(), around(GAMMA), None),
        case("blinnphong, n = 65536", with("blinnphong", "n", "65536")?, all(), around(GAMMA), None),
        case("blinnphong, n = 0", with("blinnphong", "n", "0")?, all(), around(GAMMA), None),
    ])
}

/// The forms in which each case is looked at: the usual ones, one image or slice only, and the smallest.
fn forms() -> Vec<FormSpec> {
    let sized = |kind, images, size, texel| FormSpec::sized(kind, images, size, texel);
    vec![
        sized(FormKind::Paper, 4, 64, Texel::Linear(8)),
        sized(FormKind::Paper, 4, 64, Texel::Float),
        sized(FormKind::Paper, 1, 2, Texel::Float),
        sized(FormKind::Half, 16, 32, Texel::Sqrt(8, None)),
        sized(FormKind::Half, 16, 32, Texel::Float),
        sized(FormKind::Half, 1, 2, Texel::Sqrt(1, None)),
        sized(FormKind::Bivariate, 1, 32, Texel::Sqrt(8, None)),
        sized(FormKind::Bivariate, 1, 2, Texel::Float),
    ]
}

/// The largest value that a form can give under a light of intensity 1, but for n·l.
fn largest(form: &Form) -> f64 {
    let stored = (0..form.texels.layers()).flat_map(|layer| form.texels.layer(layer));
    match form.texels.texel {
        Texel::Float => stored.flat_map(|texel| texel[..3].iter()).fold(0.0, |most, &value| most.max(f64::from(value))),
        _ => form.texels.caps().iter().copied().fold(0.0, f64::max),
    }
}

fn measured(case: &Case, spec: &FormSpec) -> Result<Extreme, Error> {
    let form = spec.build(&*case.reflectance, 2.0)?;
    let most = largest(&form);
    let mut found = Extreme {
        case: case.name,
        form: spec.to_string(),
        values: 0,
        largest: 0.0,
        of_bound: 0.0,
        off_limit: None,
        broken: Vec::new(),
    };
    for &light in &case.lights {
        let record = form.record(light);
        for &n in &case.normals {
            let value = form.at(light, n);
            let single = [0, 1, 2].map(|axis| [n[axis] as f32]);
            let mut many = [[0.0f32; 3]];
            form.add(&record, 1.0, [&single[0], &single[1], &single[2]], &mut many);
            let facing = n.dot(&light.direction()).max(0.0);
            // In single precision n·l is off by its rounding.
            let bound = if spec.kind == FormKind::Paper { most } else { most * (facing + 3e-7) };
            for value in value.into_iter().chain(many[0].map(f64::from)) {
                found.values += 1;
                if !(value.is_finite() && value >= 0.0) {
                    found.broken.push(format!("{value} at φ = {}, n = {n:?}", light.phi));
                    continue;
                }
                found.largest = found.largest.max(value);
                if value > bound * (1.0 + ROUNDING) {
                    found.broken.push(format!("{value} is above its bound {bound} at φ = {}, n = {n:?}", light.phi));
                }
                found.of_bound = found.of_bound.max(if bound > 0.0 { value / bound } else { 0.0 });
            }
            if let Some(limit) = case.limit.as_ref().filter(|limit| (limit.applies)(spec)) {
                let wanted = (limit.of)(&form, light, n);
                let off = (0..3).map(|c| (value[c] - wanted[c]).abs()).fold(0.0, f64::max);
                let [worst, _] = found.off_limit.get_or_insert([0.0, limit.within]);
                *worst = worst.max(off);
                if off > limit.within {
                    found.broken.push(format!("{off} off the limit at φ = {}, n = {n:?}", light.phi));
                }
            }
        }
    }
    Ok(found)
}

/// The sum over many lights: the sum of the single ones, whatever the number of threads.
fn many_lights(spec: &FormSpec) -> Result<Extreme, Error> {
    let model = Model::named("gold-paint")?;
    let form = spec.build(&model, 2.0)?;
    let lights: Vec<Light> =
        (0..LIGHTS).map(|i| Light::new(180.0 * i as f64 / LIGHTS as f64, 137.5 * i as f64)).collect();
    let normals: Vec<Vector> = (0..7).flat_map(|turn| around(17.0 * f64::from(turn))).collect();
    let single = [0, 1, 2].map(|axis| normals.iter().map(|n| n[axis] as f32).collect::<Vec<f32>>());
    let records: Vec<_> = lights.iter().map(|&light| form.record(light)).collect();
    let sum = |part: usize| {
        let mut out = vec![[0.0f32; 3]; normals.len()];
        out.par_chunks_mut(part).enumerate().for_each(|(place, out)| {
            let cut = [0, 1, 2].map(|axis| &single[axis][place * part..][..out.len()]);
            records.iter().for_each(|record| form.add(record, 1.0, cut, out));
        });
        out
    };
    let whole = sum(normals.len());
    let mut broken = Vec::new();
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool =
            pool.map_err(|error| Error::input(format!("no {threads} threads: {error}"), "a system with threads"))?;
        if pool.install(|| sum(29)) != whole {
            broken.push(format!("{threads} threads give another sum"));
        }
    }
    let bound = largest(&form) * LIGHTS as f64;
    let (mut most, mut off) = (0.0f64, 0.0f64);
    for (&n, sum) in normals.iter().zip(&whole) {
        let exact = lights.iter().fold([0.0; 3], |all, &light| {
            let one = form.at(light, n);
            [0, 1, 2].map(|c| all[c] + one[c])
        });
        for c in 0..3 {
            let value = f64::from(sum[c]);
            if !(value.is_finite() && value >= 0.0 && value <= bound) {
                broken.push(format!("{value} at n = {n:?}"));
            }
            most = most.max(value);
            off = off.max((value - exact[c]).abs());
        }
    }
    // Single precision: a place is some 1e-6 of a texel off, and neighbouring texels differ by as much as there is.
    let within = 1e-5 * largest(&form) * libm::sqrt(LIGHTS as f64);
    if off > within {
        broken.push(format!("{off} off the sum in double precision"));
    }
    Ok(Extreme {
        case: "64 lights on 1, 2 and 3 threads",
        form: spec.to_string(),
        values: 3 * normals.len(),
        largest: most,
        of_bound: most / bound,
        off_limit: Some([off, within]),
        broken,
    })
}

/// Measures all cases in all forms. `done` is told how many parts of how many are done.
///
/// # Errors
/// None for these cases.
pub fn measure(done: &dyn Fn(usize, usize)) -> Result<Vec<Extreme>, Error> {
    let (forms, cases) = (forms(), cases()?);
    let of = (cases.len() + 1) * forms.len();
    let mut found = Vec::with_capacity(of);
    let mut put = |one: Extreme| {
        found.push(one);
        done(found.len(), of);
    };
    for case in &cases {
        for spec in &forms {
            put(measured(case, spec)?);
        }
    }
    for spec in &forms {
        put(many_lights(spec)?);
    }
    Ok(found)
}
