//! What a scene requires of a core: which lobes its pictures ask for, where on them, and how finely.
//!
//! The scene is rendered in double precision with the exact lobe, at its full size and, at a reduced one, with its
//! camera and each light moved by a margin ([`Scene::moved`]). What no pixel of these pictures asks for need not be
//! built; what a core does there all the same is defined by its ports.

use rayon::prelude::*;
use serde::Serialize;

use super::frame::{BACKGROUND, full_scale};
use super::highlight::Exact;
use super::survey::{Counts, Spread, Survey};
use super::trace::Tracer;
use super::{Budget, Difference, Frame, Highlights, Picture, Scene};
use crate::emit::package::counted;
use crate::fixed::exp2;
use crate::lobe;
use crate::platform::error::{Error, refuse};
use crate::spec::{INPUT_FRACTION, Material, OUTPUT_FRACTION};

/// The most pixels a row of a moved picture.
pub const MOVED_WIDTH: u32 = 320;
/// The most samples, pixels times lights, of all moved pictures together; they are made smaller until they have no
/// more.
const MOVED_SAMPLES: u64 = 6_000_000;
/// The margin in degrees where none is said.
pub const MARGIN: f64 = 5.0;
/// The largest margin in degrees.
pub const MAX_MARGIN: f64 = 45.0;
/// The part of the budget that each of the roundings of input and output may take by the derivation.
const SHARE: f64 = 0.25;

/// What a scene asks of one of its materials.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MaterialNeed {
    /// Its name.
    pub name: String,
    /// Its shininess; without a meaning where it is drawn by its reflectance.
    pub shininess: f64,
    /// Whether it is drawn by its reflectance, and asks for no lobe.
    pub measured: bool,
    /// The highlight's peak in output steps: the largest channel of k_s times the sum of all lights, times full scale.
    pub peak_steps: f64,
    /// Whether an object has it.
    pub used: bool,
    /// The row of the core that serves it, by its place in [`Requirements::rows`]; none where no row is needed.
    pub row: Option<usize>,
    /// Its samples in the base picture.
    pub base: Counts,
    /// Its samples in the moved pictures.
    pub moved: Counts,
    /// The least cosine of a lit sample.
    pub least_cosine: Option<f64>,
    /// Where on its lobe the samples are.
    pub spread: Spread,
}

/// A shininess that the core must serve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShininessRow {
    /// The shininess.
    pub shininess: f64,
    /// The materials that have it, joined by `+`.
    pub name: String,
    /// The sum over the lights of `k_s I` at full scale, of the material and channel where it is largest.
    pub weight: f64,
}

/// A picture of the scene, reduced to the pixels that highlights fall on: the others are the same whatever the core.
#[derive(Clone, Debug)]
pub struct View {
    /// The name: `base`, or that of the move.
    pub name: String,
    /// The pixels of the whole picture.
    pub pixels: u64,
    /// The lit pixels, as a picture of one row.
    pub lit: Frame,
    /// The exact picture of the lit pixels.
    pub exact: Picture,
    /// The exact lobe of each sample of the lit pixels.
    pub lobes: Vec<f64>,
}

/// How a picture through a core differs from the exact one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PictureError {
    /// The greatest difference of a channel in output steps.
    pub max_steps: u16,
    /// The mean of all differences in output steps.
    pub mean_steps: f64,
    /// The mean square of all differences in squared output steps.
    pub mean_square: f64,
    /// The peak signal-to-noise ratio in dB; none of the same picture.
    pub psnr: Option<f64>,
    /// The pixels that differ.
    pub pixels_off: u64,
}

impl PictureError {
    /// The error of a whole picture.
    #[must_use]
    pub fn of(difference: &Difference, channel_bits: u32) -> Self {
        let &Difference { max_steps, mean_steps, psnr, .. } = difference;
        let full = full_scale(channel_bits);
        let mean_square = psnr.map_or(0.0, |psnr| full * full / libm::pow(10.0, psnr / 10.0));
        Self { max_steps, mean_steps, mean_square, psnr, pixels_off: difference.pixels.iter().skip(1).sum() }
    }
}

/// Fraction bits of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bits {
    /// The fewest with which the rounding is proved to take no more than a quarter of the budget; none where the budget
    /// allows no error, or where it needs more than a port may have.
    pub derived: Option<u32>,
    /// The fewest with which the pictures keep the budget where the lobe is exact and only this port is rounded; none
    /// where it needs more than a port may have.
    pub measured: Option<u32>,
}

/// What a scene requires.
#[derive(Clone, Debug, Serialize)]
pub struct Requirements {
    /// The angle in degrees by which the camera and each light were moved.
    pub margin_degrees: f64,
    /// The error that is allowed in each picture.
    pub budget: Budget,
    /// The number of lights.
    pub lights: usize,
    /// The names of the pictures: the base, then the moves.
    pub pictures: Vec<String>,
    /// Pixels a row and rows of the base picture.
    pub size: [u32; 2],
    /// Pixels a row and rows of the moved pictures.
    pub moved_size: [u32; 2],
    /// The materials, in the scene's order.
    pub materials: Vec<MaterialNeed>,
    /// The shininesses that are needed, ascending.
    pub rows: Vec<ShininessRow>,
    /// All samples of the base picture.
    pub base: Counts,
    /// All samples of the moved pictures.
    pub moved: Counts,
    /// The least cosine of a lit sample of a material with a highlight.
    pub least_cosine: Option<f64>,
    /// The pixels of the base picture and of all moved ones with a channel whose sum exceeds full scale.
    pub saturated: [u64; 2],
    /// The value of the lobe below which a highlight is less than half an output step, however bright material and
    /// light: `1 / (2 w full)` of the largest `w = k_s I` of a light.
    pub invisible_below: Option<f64>,
    /// F: an input off by half of its last bit moves `x^n` by at most `n 2^-(F+1)`, as its slope is at most n, and a
    /// channel by at most `sum(k_s I) full n 2^-(F+1)` steps.
    pub input_fraction: Bits,
    /// G: an output off by half of its last bit moves a channel by at most `sum(k_s I) full 2^-(G+1)` steps.
    pub output_fraction: Bits,
    /// The pictures.
    #[serde(skip)]
    pub(super) views: Vec<View>,
    /// The whole base picture.
    #[serde(skip)]
    pub(super) frame: Frame,
}

impl Budget {
    /// Both limits, the default put in where none is given: one step at most.
    #[must_use]
    pub fn limits(&self) -> (Option<u32>, Option<f64>) {
        match (self.max_steps, self.min_psnr) {
            (None, None) => (Some(1), None),
            both => both,
        }
    }

    /// What a picture misses of it, each as log2 of value / allowed and in words.
    #[must_use]
    pub fn missed(&self, error: &PictureError, of: &str) -> Vec<(f64, String)> {
        let (steps, psnr) = self.limits();
        let mut missed = Vec::new();
        if let Some(allowed) = steps.filter(|&allowed| u32::from(error.max_steps) > allowed) {
            // One more of each, as 0 may be allowed.
            let octaves = libm::log2((f64::from(error.max_steps) + 1.0) / (f64::from(allowed) + 1.0));
            let are = if allowed == 1 { "is" } else { "are" };
            let own = counted(error.max_steps, "step");
            missed.push((octaves, format!("{of} is off by {own} where {allowed} {are} allowed")));
        }
        if let (Some(allowed), Some(own)) = (psnr, error.psnr)
            && own < allowed
        {
            let octave = 20.0 * std::f64::consts::LOG10_2;
            missed.push((
                (allowed - own) / octave,
                format!("{of} has a PSNR of {own:.2} dB where {allowed} dB are wanted"),
            ));
        }
        missed
    }

    /// The real-valued error in steps that keeps it whatever the picture: the greatest that moves no code by more than
    /// the steps that are allowed; of a PSNR, the error e whose share of moved codes, e of them by one step, has the
    /// mean square that is allowed.
    #[must_use]
    pub fn steps(&self, channel_bits: u32) -> f64 {
        let full = full_scale(channel_bits);
        let (steps, psnr) = self.limits();
        let of_psnr = |psnr: f64| {
            let rms = full * libm::pow(10.0, -psnr / 20.0);
            if rms < 1.0 { rms * rms } else { rms }
        };
        steps.map_or(f64::INFINITY, f64::from).min(psnr.map_or(f64::INFINITY, of_psnr))
    }
}

impl View {
    fn new(name: String, scene: &Scene, frame: &Frame) -> Self {
        let lights = frame.lights;
        let weights = frame.weights(scene);
        let shines = |material: u16, light: usize| weights[usize::from(material)][light].iter().any(|&k| k > 0.0);
        let is_lit = |&pixel: &usize| {
            let material = frame.material[pixel];
            material != BACKGROUND
                && (0..lights).any(|l| shines(material, l) && !frame.versine[pixel * lights + l].is_nan())
        };
        let kept: Vec<usize> = (0..frame.material.len()).filter(is_lit).collect();
        let versines = |&pixel: &usize| &frame.versine[pixel * lights..][..lights];
        let lit = Frame {
            width: kept.len() as u32,
            height: 1,
            lights,
            material: kept.iter().map(|&pixel| frame.material[pixel]).collect(),
            base: kept.iter().map(|&pixel| frame.base[pixel]).collect(),
            versine: kept.iter().flat_map(versines).copied().collect(),
        };
        let lobes = exact(scene, &lit);
        let exact = lit.picture(scene, &lobes);
        Self { name, pixels: frame.material.len() as u64, lit, exact, lobes }
    }

    /// How the whole picture with these values of the lobes, a sample of the lit pixels each, differs from the exact
    /// one.
    #[must_use]
    pub fn error(&self, scene: &Scene, highlights: &[f64]) -> PictureError {
        let own = Difference::of(&self.exact, &self.lit.picture(scene, highlights));
        // Where nothing is lit there is nothing to compare.
        let lit = self.lit.material.len() as f64;
        if lit == 0.0 {
            return PictureError::default();
        }
        let part = lit / self.pixels as f64;
        let full = scene.full_scale();
        let squares = own.psnr.map_or(0.0, |psnr| full * full * libm::pow(10.0, -psnr / 10.0) * part);
        PictureError {
            max_steps: own.max_steps,
            mean_steps: own.mean_steps * part,
            mean_square: squares,
            psnr: own.psnr.map(|psnr| psnr - 10.0 * libm::log10(part)),
            pixels_off: own.pixels.iter().skip(1).sum(),
        }
    }
}

impl PictureError {
    /// The worse of two in each figure, where they are of several pictures; the pixels are added.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        let psnr = match (self.psnr, other.psnr) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        Self {
            max_steps: self.max_steps.max(other.max_steps),
            mean_steps: self.mean_steps.max(other.mean_steps),
            mean_square: self.mean_square.max(other.mean_square),
            psnr,
            pixels_off: self.pixels_off + other.pixels_off,
        }
    }
}

/// Refuses a margin that is not allowed.
pub(super) fn check_margin(margin_degrees: f64) -> Result<(), Error> {
    refuse!(
        !(0.0..=MAX_MARGIN).contains(&margin_degrees),
        format!("a margin of {margin_degrees} degrees is out of range"),
        format!("a margin is a real number from 0 to {MAX_MARGIN}")
    );
    Ok(())
}

fn exact(scene: &Scene, frame: &Frame) -> Vec<f64> {
    Exact.of(scene, frame).expect("the exact lobe needs no tools")
}

/// The size of the moved pictures: as the base's, made smaller to at most [`MOVED_WIDTH`] pixels a row and so many
/// samples in all of them.
pub(super) fn moved_size(scene: &Scene, moves: usize) -> [u32; 2] {
    let samples = moves as f64 * scene.lights.len() as f64 * f64::from(scene.width) * f64::from(scene.height);
    let narrow = f64::from(MOVED_WIDTH) / f64::from(scene.width);
    let few = libm::sqrt(MOVED_SAMPLES as f64 / samples.max(1.0));
    let scale = narrow.min(few).min(1.0);
    [scene.width, scene.height].map(|side| (libm::round(f64::from(side) * scale) as u32).max(1))
}

impl Requirements {
    /// Finds what a scene requires, with its camera and each of its lights moved by `margin_degrees`, from 0 to
    /// [`MAX_MARGIN`]. `done` is told how many of how many pictures have been rendered.
    ///
    /// # Errors
    /// A margin that is not allowed, a scene without a highlight.
    pub fn of(scene: &Scene, margin_degrees: f64, done: &(dyn Fn(usize, usize) + Sync)) -> Result<Self, Error> {
        check_margin(margin_degrees)?;
        refuse!(
            !scene.has_highlights(),
            "all objects of the scene are drawn by a reflectance, and none asks for a lobe",
            "shading = \"classical\" makes the nearest diffuse and cos^n materials of them"
        );
        let moved = scene.moved(margin_degrees);
        let [width, height] = moved_size(scene, moved.len());
        let total = 1 + moved.len();
        let tracer = Tracer::new(scene);
        let frame = Frame::trace(&tracer, scene, &|| {});
        let base = Survey::of(scene, &frame);
        let mut pictures = vec!["base".to_owned()];
        let mut views = vec![View::new("base".to_owned(), scene, &frame)];
        done(1, total);
        let finished = std::sync::atomic::AtomicUsize::new(1);
        let of_moved: Vec<(View, Survey)> = moved
            .into_par_iter()
            .map(|(name, moved)| {
                let moved = moved.resized(width, height);
                let frame = Frame::trace(&tracer, &moved, &|| {});
                let both = (View::new(name, scene, &frame), Survey::of(&moved, &frame));
                done(finished.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1, total);
                both
            })
            .collect();
        let mut elsewhere = Survey::new(scene.materials.len());
        for (view, survey) in of_moved {
            elsewhere = elsewhere.and(&survey);
            pictures.push(view.name.clone());
            views.push(view);
        }
        let full = scene.full_scale();
        let rows = rows(scene, &base, &elsewhere);
        let all = |counts: &[Counts]| counts.iter().fold(Counts::default(), |sum, counts| sum.and(counts));
        let (base_counts, moved_counts) = (all(&base.counts), all(&elsewhere.counts));
        let saturated = [base.saturated, elsewhere.saturated];
        let lit = |&material: &usize| base.counts[material].lit() + elsewhere.counts[material].lit() > 0;
        let served = (0..scene.materials.len()).filter(lit);
        let strengths = served.flat_map(|material| (0..scene.lights.len()).map(move |light| (material, light)));
        let strongest = strengths.flat_map(|(material, light)| scene.specular(material, light)).fold(0.0, f64::max);
        let materials = needs(scene, [&base, &elsewhere, &base.clone().and(&elsewhere)], &rows, full);
        let least = materials.iter().filter_map(|need| need.least_cosine).fold(f64::INFINITY, f64::min);
        let mut requirements = Self {
            margin_degrees,
            budget: scene.budget,
            lights: scene.lights.len(),
            pictures,
            size: [scene.width, scene.height],
            moved_size: [width, height],
            materials,
            rows,
            base: base_counts,
            moved: moved_counts,
            least_cosine: least.is_finite().then_some(least),
            saturated,
            invisible_below: (strongest > 0.0).then(|| 0.5 / (strongest * full)),
            input_fraction: Bits { derived: None, measured: None },
            output_fraction: Bits { derived: None, measured: None },
            views,
            frame,
        };
        requirements.input_fraction = requirements.input_bits(scene);
        requirements.output_fraction = requirements.output_bits(scene);
        Ok(requirements)
    }
}

/// The largest channel of k_s times the sum of all lights.
fn weight(scene: &Scene, material: usize) -> f64 {
    let of_channel = |c: usize| (0..scene.lights.len()).map(|light| scene.specular(material, light)[c]).sum::<f64>();
    [0, 1, 2].map(of_channel).into_iter().fold(0.0, f64::max)
}

/// The shininesses of the materials with lit samples, ascending.
fn rows(scene: &Scene, base: &Survey, moved: &Survey) -> Vec<ShininessRow> {
    let mut rows: Vec<ShininessRow> = Vec::new();
    for (place, material) in scene.materials.iter().enumerate() {
        if base.counts[place].lit() + moved.counts[place].lit() == 0 {
            continue;
        }
        let weight = weight(scene, place);
        match rows.iter_mut().find(|row| row.shininess == material.shininess) {
            Some(row) => {
                row.name = format!("{}+{}", row.name, material.name);
                row.weight = row.weight.max(weight);
            }
            None => rows.push(ShininessRow { shininess: material.shininess, name: material.name.clone(), weight }),
        }
    }
    rows.sort_by(|a, b| a.shininess.total_cmp(&b.shininess));
    rows
}

fn needs(scene: &Scene, [base, moved, both]: [&Survey; 3], rows: &[ShininessRow], full: f64) -> Vec<MaterialNeed> {
    let need = |(place, material): (usize, &Material)| MaterialNeed {
        name: material.name.clone(),
        shininess: material.shininess,
        measured: scene.reflectance(place).is_some(),
        peak_steps: weight(scene, place) * full,
        used: scene.objects.iter().any(|object| object.material == place),
        row: rows.iter().position(|row| row.shininess == material.shininess).filter(|_| both.counts[place].lit() > 0),
        base: base.counts[place],
        moved: moved.counts[place],
        least_cosine: both.least[place].is_finite().then_some(both.least[place]),
        spread: both.spreads[place].clone(),
    };
    scene.materials.iter().enumerate().map(need).collect()
}

impl Requirements {
    /// Whether no lit sample has a negative cosine, so that a port for 0 to 1 holds all of them.
    #[must_use]
    pub fn stays_in_range(&self) -> bool {
        self.base.negative + self.moved.negative == 0
    }

    /// The worst error over the moved pictures that `highlights` gives, and that of the base picture before it.
    pub(super) fn errors(&self, scene: &Scene, highlights: &dyn Fn(usize) -> Vec<f64>) -> [PictureError; 2] {
        let mut errors = self.views.iter().enumerate().map(|(place, view)| view.error(scene, &highlights(place)));
        let base = errors.next().unwrap_or_default();
        [base, errors.fold(PictureError::default(), PictureError::worst)]
    }

    /// Whether the budget holds in the base and in every moved picture.
    fn keeps(&self, scene: &Scene, highlights: &dyn Fn(usize) -> Vec<f64>) -> bool {
        self.errors(scene, highlights).iter().all(|error| self.budget.missed(error, "").is_empty())
    }

    /// The bits of a port that a channel is moved by `steepest` steps times half of its last bit: the fewest for which
    /// that is within the share of the budget, and with which the lobes that `rounded` gives keep it.
    fn bits<L: Fn(usize) -> Vec<f64>>(
        &self,
        scene: &Scene,
        steepest: f64,
        port: std::ops::RangeInclusive<u32>,
        rounded: impl Fn(f64) -> L,
    ) -> Bits {
        let allowed = SHARE * self.budget.steps(scene.channel_bits);
        let derived = (1..=*port.end()).find(|&bits| steepest * exp2(-(bits as i32) - 1) <= allowed);
        let measured = port.clone().find(|&bits| self.keeps(scene, &rounded(exp2(bits as i32))));
        Bits { derived: derived.map(|bits| bits.max(*port.start())), measured }
    }

    fn input_bits(&self, scene: &Scene) -> Bits {
        let full = scene.full_scale();
        let steepest = self.rows.iter().map(|row| row.shininess * row.weight * full).fold(0.0, f64::max);
        self.bits(scene, steepest, INPUT_FRACTION, |one| {
            move |view: usize| {
                let lit = &self.views[view].lit;
                let value = |(sample, &versine): (usize, &f64)| {
                    if versine.is_nan() || versine >= 1.0 {
                        return 0.0;
                    }
                    let n = scene.materials[usize::from(lit.material[sample / lit.lights])].shininess;
                    lobe::exact(n, 1.0 - libm::round((1.0 - versine) * one) / one)
                };
                lit.versine.par_iter().enumerate().map(value).collect()
            }
        })
    }

    fn output_bits(&self, scene: &Scene) -> Bits {
        let full = scene.full_scale();
        let strongest = self.rows.iter().map(|row| row.weight * full).fold(0.0, f64::max);
        self.bits(scene, strongest, OUTPUT_FRACTION, |one| {
            move |view: usize| self.views[view].lobes.par_iter().map(|value| libm::round(value * one) / one).collect()
        })
    }
}
