//! Proofs about the HDL of a core, for every input and every clock, where [`crate::cosim`] compares runs.

mod abc;
mod aig;
mod circuit;
mod equivalence;
mod planted;
mod stream;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use crate::cosim;
use crate::design::Design;
use crate::error::Error;
use crate::golden::Golden;
#[cfg(feature = "kernel")]
use crate::kernel;
use crate::package;
use crate::spec::Language;
use crate::synth::yosys::Yosys;
use circuit::Circuit;
use equivalence::{Compared, Comparison, Pipeline};
pub use stream::stream;

/// What came of a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The claim holds.
    Proved,
    /// The claim is false.
    Refuted,
    /// Neither was found: the time limit, or a circuit of a form that the method does not know.
    Open,
}

/// A claim, and what came of its proof.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Proof {
    /// The claim, such as "Verilog = VHDL".
    pub claim: String,
    /// What came of it.
    pub verdict: Verdict,
    /// How it was proved, or why not.
    pub how: String,
    /// The time it took, in seconds.
    pub seconds: f64,
}

impl Proof {
    fn new(claim: String, verdict: Verdict, how: String, start: Instant) -> Self {
        Self { claim, verdict, how, seconds: start.elapsed().as_secs_f64() }
    }
}

/// A text of a core as Verilog: its name for people, its top module, its bytes.
struct Text {
    name: String,
    top: String,
    bytes: Vec<u8>,
}

/// The texts of a core: its files in a directory, and the Verilog of its rust-hdl kernel where there is one of its widths.
fn texts(design: &Design, directory: &Path) -> Result<Vec<Text>, Error> {
    let mut texts = Vec::new();
    for &language in &design.spec.languages {
        let source = directory.join(package::rtl_path(design, language));
        let bytes = match language {
            Language::Verilog => std::fs::read(&source).map_err(|error| Error::io("cannot read", &source, error))?,
            Language::Vhdl => cosim::as_verilog(&design.spec.name, directory, &source)?,
        };
        texts.push(Text { name: language.to_string(), top: design.spec.name.clone(), bytes });
    }
    #[cfg(feature = "kernel")]
    if let Some(kernel) = kernel::of_design(design) {
        texts.push(Text { name: "rust-hdl".to_owned(), top: "top".to_owned(), bytes: kernel.verilog().into_bytes() });
    }
    Ok(texts)
}

/// Proves that the texts of the core in a directory are pipelines of the core's latency and all the same circuit: see
/// [`equivalence`](self) for what that says. Each text is first run on the golden
/// vectors.
///
/// `seconds` is the most that the solver may take at once; `progress` is told of each claim before it is looked at. A claim that was
/// proved is proved again with faults planted in one of the circuits; if one of them is not found, the claim counts as open.
///
/// # Errors
/// A tool that is not installed or does not do its work, GHDL and Yosys with a text that they do not read among them.
pub fn equivalence(
    design: &Design,
    directory: &Path,
    golden: &Golden,
    seconds: u32,
    progress: &dyn Fn(&str),
) -> Result<Vec<Proof>, Error> {
    let yosys = Yosys::find(None)?;
    let latency = design.schedule.latency;
    let mut proofs = Vec::new();
    let mut known: Vec<(String, Pipeline)> = Vec::new();
    for text in texts(design, directory)? {
        let start = Instant::now();
        let claim = format!("{} is a pipeline of {latency} clocks", text.name);
        progress(&claim);
        let circuit = Circuit::read(&yosys, directory, &text.top, &text.bytes)?;
        let pipeline = circuit.and_then(|circuit| Pipeline::of(circuit, latency));
        let ran = pipeline.as_ref().map(|pipeline| pipeline.against(design, golden));
        let (verdict, how) = match ran {
            Ok(Ok(runs)) => (Verdict::Proved, format!("and gives the results of {runs} golden vectors")),
            Ok(Err(differs)) => (Verdict::Refuted, format!("it is another core: {differs}")),
            Err(why) => (Verdict::Open, why.clone()),
        };
        proofs.push(Proof::new(claim, verdict, how, start));
        if let Ok(pipeline) = pipeline {
            known.push((text.name, pipeline));
        }
    }
    let Some(((name, first), others)) = known.split_first() else { return Ok(proofs) };
    for (other_name, other) in others {
        let start = Instant::now();
        let claim = format!("{name} = {other_name}");
        progress(&claim);
        let (verdict, how) = compare(first, other, seconds)?;
        proofs.push(Proof::new(claim, verdict, how, start));
    }
    Ok(proofs)
}

fn compare(one: &Pipeline, other: &Pipeline, seconds: u32) -> Result<(Verdict, String), Error> {
    let comparison = match Comparison::new(one, other) {
        Ok(comparison) => comparison,
        Err(differ) => return Ok((Verdict::Refuted, differ)),
    };
    let (compared, solved, whole) = match comparison.run(seconds)? {
        Compared::Same { compared, solved, whole } => (compared, solved, whole),
        Compared::Different(why) => return Ok((Verdict::Refuted, why)),
        Compared::Unknown(why) => return Ok((Verdict::Open, why)),
    };
    let (planted, missed) = planted::check(&comparison, seconds)?;
    if !missed.is_empty() {
        let how = format!("the proof goes through with a planted fault as well: {}", missed.join(", "));
        return Ok((Verdict::Open, how));
    }
    let cut = if whole { "from the inputs to the outputs" } else { "stage by stage" };
    let how =
        format!("{cut}, {compared} bits, {solved} of them by the solver; {planted} of {planted} planted faults found");
    Ok((Verdict::Proved, how))
}
