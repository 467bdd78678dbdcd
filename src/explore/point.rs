//! One core for one family, with its error and its cost.

use serde::{Deserialize, Serialize};

use super::Shape;
use super::sweep::Core;
use crate::core::{Design, Measured};
use crate::emit::package::counted;
use crate::fixed::Table;
use crate::method::word;
use crate::spec::{CoreSpec, LobeSpec, Pipeline, Shininess};
use crate::synth::{Synthesis, Tools};
use crate::target::Family;

/// One core for one family: a row of the results.
///
/// Errors are those of the bit-exact arithmetic against `x^n`, as parts of 1, over the inputs that `checked` says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// 16 hexadecimal digits that stand for the spec and the family.
    pub id: String,
    /// A short name for people, such as `power-4 G16`.
    pub name: String,
    /// What the core is built for.
    pub family: Family,
    /// The method, as it is written in a spec.
    pub method: String,
    /// Where the coefficients come from: `paper`, `minimax`, or nothing for a method that has none.
    pub coefficients: String,
    /// The other keys of the spec that differ from the method's defaults: `key=value key=value`.
    pub variant: String,
    /// Whether the method is there to be compared with: it is none of the project's own.
    pub baseline: bool,
    /// The shininesses served: `1..=1000`, `8 values` or `8 materials`.
    pub shininess: String,
    /// How many they are.
    pub rows: u32,
    /// F: fraction bits of the input.
    pub input_fraction: u32,
    /// G: fraction bits of the output.
    pub output_fraction: u32,
    /// The pipeline, as it is written in a spec: a depth or `auto`.
    pub pipeline: String,
    /// The largest |result - x^n|.
    pub max_abs: f64,
    /// The largest |result - x^n| / x^n where x^n >= 1/2.
    pub max_rel: f64,
    /// The root of the mean square of result - x^n.
    pub rms: f64,
    /// The shininess at which the error is `max_abs`.
    pub worst_n: f64,
    /// The cosine at which the error is `max_abs`.
    pub worst_x: f64,
    /// Over which inputs: `exhaustive` (every shininess, every code of the operand in [0, 1]), or `subset: ` and which.
    pub checked: String,
    /// The proved bound of |result - real-valued method| over every input.
    pub bound: f64,
    /// The bits of all memories.
    pub rom_bits: u64,
    /// Clocks from input to output.
    pub latency: u32,
    /// What it is made of, before synthesis.
    pub shape: Shape,
    /// What the tools made of it.
    pub synthesis: Option<Synthesis>,
    /// What the cost model says of it.
    pub estimate: Option<Estimate>,
    /// Why there is no error or no cost; the figures that are missing are 0.
    pub failure: Option<String>,
    /// The spec, every default resolved, as TOML.
    pub spec: String,
}

/// What a cost model says of a core.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The tools whose results the model follows.
    pub tools: Tools,
    /// The number of measured points that it was fitted to.
    pub points: u32,
    /// LUTs that are used up, as [`crate::synth::Resources::lut_total`].
    pub lut: u32,
    /// Flip-flops.
    pub ff: u32,
    /// DSP blocks.
    pub dsp: u32,
    /// Block RAMs.
    pub bram: u32,
    /// The frequency in MHz, where the points that it was fitted to have one.
    pub mhz: Option<f64>,
}

/// What a core takes, measured or estimated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// LUTs that are used up, carry chains counted: [`crate::synth::Resources::lut_total`].
    pub lut: u32,
    /// Flip-flops.
    pub ff: u32,
    /// DSP blocks.
    pub dsp: u32,
    /// Block RAMs.
    pub bram: u32,
    /// Clocks from input to output.
    pub latency: u32,
    /// The median frequency in MHz over the seeds, or an estimate of it; none of a core that was not placed, or that
    /// has no path between two registers.
    pub mhz: Option<f64>,
    /// Why there is no frequency, where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_mhz: Option<&'static str>,
    /// Whether the figures come from a model and not from the tools.
    pub estimated: bool,
}

impl Cost {
    /// What the tools made of a core of so many clocks.
    #[must_use]
    pub fn measured(synthesis: &Synthesis, latency: u32) -> Self {
        let resources = &synthesis.resources;
        Self {
            lut: resources.lut_total,
            ff: resources.ff,
            dsp: resources.dsp,
            bram: resources.bram,
            latency,
            mhz: synthesis.timing.as_ref().map(|timing| timing.median_mhz),
            no_mhz: synthesis.no_clock(),
            estimated: false,
        }
    }

    /// What a cost model says of a core of so many clocks.
    #[must_use]
    pub fn estimated(estimate: &Estimate, latency: u32) -> Self {
        let &Estimate { lut, ff, dsp, bram, mhz, .. } = estimate;
        let no_mhz = mhz.is_none().then_some("too few of the cores that the cost model is fitted to were placed");
        Self { lut, ff, dsp, bram, latency, mhz, no_mhz, estimated: true }
    }

    /// The frequency as text, with so many digits behind the point, or why there is none.
    #[must_use]
    pub fn mhz_text(&self, digits: usize) -> String {
        let why = || format!("frequency not known ({})", self.no_mhz.unwrap_or("it was not placed"));
        self.mhz.map_or_else(why, |mhz| format!("{mhz:.digits$} MHz"))
    }
}

/// How the failure of a point begins whose spec no core can be built for.
pub const NO_CORE: &str = "no such core: ";

impl Point {
    /// Whether the point failed in a way that another try may mend: a tool did not do its work.
    #[must_use]
    pub fn is_to_retry(&self) -> bool {
        self.failure.as_ref().is_some_and(|failure| !failure.starts_with(NO_CORE))
    }

    /// The point of a core that is not measured: its names alone.
    #[must_use]
    pub fn unmeasured(core: &Core) -> Self {
        let spec = &core.spec;
        let LobeSpec { method, interface } = spec.block.lobe();
        let (about, options) = (method.about(), method.options());
        let method = about.name.to_owned();
        let chosen = options.coefficients.as_ref().map(word).unwrap_or_default();
        let variant = variant(spec);
        let pipeline = spec.pipeline.to_string();
        let mut name = vec![method.clone()];
        name.extend((about.coefficients.len() > 1).then(|| chosen.clone()));
        name.extend(variant.iter().map(|(key, value)| match key.as_str() {
            "inside" | "divider" | "form" | "operand" | "tail" | "objective" => value.clone(),
            _ => format!("{key}={value}"),
        }));
        name.push(format!("G{}", interface.output_fraction));
        name.extend((interface.input_fraction != 16).then(|| format!("F{}", interface.input_fraction)));
        name.extend((spec.pipeline != Pipeline::Auto).then(|| format!("P{pipeline}")));
        let shininess = match &interface.shininess {
            set @ (Shininess::Range(..) | Shininess::Fixed { .. }) => set.to_string(),
            Shininess::List(list) => counted(list.len() as u64, "value"),
            Shininess::Materials(materials) => counted(materials.len() as u64, "material"),
        };
        name.extend((shininess != "1..=1000").then(|| format!("n={shininess}")));
        Self {
            id: core.id.clone(),
            name: name.join(" "),
            family: core.family,
            baseline: about.is_baseline,
            method,
            coefficients: chosen,
            variant: variant.iter().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>().join(" "),
            shininess,
            rows: interface.shininess.rows() as u32,
            input_fraction: interface.input_fraction,
            output_fraction: interface.output_fraction,
            pipeline,
            max_abs: 0.0,
            max_rel: 0.0,
            rms: 0.0,
            worst_n: 0.0,
            worst_x: 0.0,
            checked: String::new(),
            bound: 0.0,
            rom_bits: 0,
            latency: 0,
            shape: Shape::default(),
            synthesis: None,
            estimate: None,
            failure: None,
            spec: spec.to_toml(),
        }
    }

    /// The point of a core with its error, measured on the bit-exact arithmetic; without a cost.
    #[must_use]
    pub fn measured(core: &Core, design: &Design) -> Self {
        Self::with_measured(core, design, &Measured::of(design.lobe()))
    }

    /// As [`Point::measured`], with an error that is measured already.
    #[must_use]
    pub fn with_measured(core: &Core, design: &Design, measured: &Measured) -> Self {
        let sweep = &measured.sweep;
        let checked = match (sweep.exhaustive, sweep.row_step) {
            (true, _) => "exhaustive".to_owned(),
            (false, 1) => format!("subset: every shininess, one code of the operand in {}", sweep.step),
            (false, rows) => format!("subset: one shininess in {rows}, one code of the operand in {}", sweep.step),
        };
        let ulps = design.lobe().budget.proved_ulps.iter().fold(0.0, |most: f64, bound| most.max(bound.abs()));
        let [worst_n, versine] = measured.worst;
        Self {
            max_abs: measured.max_abs,
            max_rel: measured.max_rel_epicentre,
            rms: measured.rms,
            worst_n,
            worst_x: 1.0 - versine,
            checked,
            bound: ulps * design.lobe().output_format().lsb(),
            rom_bits: design.tables().iter().map(Table::bits).sum::<usize>() as u64,
            latency: design.schedule.latency,
            shape: Shape::of(design),
            ..Self::unmeasured(core)
        }
    }

    /// What the core takes: as measured, or else as estimated; none of a point that failed.
    #[must_use]
    pub fn cost(&self) -> Option<Cost> {
        let measured = self.synthesis.as_ref().filter(|_| self.failure.is_none());
        let estimate = || self.estimate.as_ref().filter(|_| self.failure.is_none());
        measured
            .map(|synthesis| Cost::measured(synthesis, self.latency))
            .or_else(|| estimate().map(|estimate| Cost::estimated(estimate, self.latency)))
    }

    /// The tools whose figures these are.
    #[must_use]
    pub fn tools(&self) -> Option<&Tools> {
        let synthesis = self.synthesis.as_ref().map(|synthesis| &synthesis.tools);
        synthesis.or_else(|| self.estimate.as_ref().map(|estimate| &estimate.tools))
    }
}

/// The keys that differ from the method's defaults and have no column of their own, with their values.
fn variant(spec: &CoreSpec) -> Vec<(String, String)> {
    let own = [
        "method",
        "coefficients",
        "shininess",
        "material",
        "name",
        "input-fraction",
        "output-fraction",
        "pipeline",
        "languages",
        "rom-formats",
    ];
    let pair = |flag: String| {
        let (key, value) = flag.strip_prefix("--")?.split_once(' ')?;
        (!own.contains(&key)).then(|| (key.replace('-', "_"), value.to_owned()))
    };
    spec.flags().into_iter().filter_map(pair).collect()
}
