//! Proofs about the HDL of a core, for every input and every clock, where [`crate::verify::cosim`] compares runs.

mod abc;
mod aig;
mod around;
mod circuit;
mod equivalence;
mod induction;
mod injected;
pub mod netlist;
mod pipeline;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use crate::core::Design;
use crate::emit::package::{self, Part};
use crate::platform::error::Error;
use crate::spec::Language;
use crate::synth;
use crate::synth::yosys::Yosys;
use crate::verify::faults::{Outcome, Tally};
use crate::verify::golden::Golden;
#[cfg(feature = "kernel")]
use crate::verify::kernel;
pub use around::around;
use circuit::Circuit;
use equivalence::{Compared, Comparison, Technique};
use pipeline::Pipeline;

/// What came of a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProofStatus {
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
    pub verdict: ProofStatus,
    /// How it was proved, or why not.
    pub how: String,
    /// The time it took, in seconds.
    pub seconds: f64,
}

/// What is told while the proofs run.
#[derive(Clone, Copy, Debug)]
pub enum Step<'a> {
    /// A claim that is looked at now.
    Begun(&'a str),
    /// What came of it.
    Ended(&'a Proof),
}

/// Looks at a claim, and tells of it. Errors: those of `prove`.
fn tried(
    claim: String,
    progress: &dyn Fn(Step),
    prove: impl FnOnce() -> Result<(ProofStatus, String), Error>,
) -> Result<Proof, Error> {
    progress(Step::Begun(&claim));
    let start = Instant::now();
    let (verdict, how) = prove()?;
    let proof = Proof { claim, verdict, how, seconds: start.elapsed().as_secs_f64() };
    progress(Step::Ended(&proof));
    Ok(proof)
}

/// A text of a core as Verilog: its name for people, its top module, its bytes.
struct Text {
    name: String,
    top: String,
    bytes: Vec<u8>,
}

/// The texts of a core: its files in a directory, and the Verilog of its rust-hdl kernel where there is one of its
/// widths.
fn texts(design: &Design, directory: &Path) -> Result<Vec<Text>, Error> {
    let mut texts = Vec::new();
    for &language in &design.spec.languages {
        let source = directory.join(package::rtl_path(design, language));
        let bytes = match language {
            Language::Verilog => std::fs::read(&source).map_err(|error| Error::io("cannot read", &source, error))?,
            Language::Vhdl => synth::as_verilog(&design.spec.name, directory, &source)?,
        };
        // A core whose memory lies outside is compared together with it.
        let (more, top) =
            package::closing(design, Part::Core)?.unwrap_or_else(|| (String::new(), design.spec.name.clone()));
        texts.push(Text { name: language.to_string(), top, bytes: [bytes, more.into_bytes()].concat() });
    }
    #[cfg(feature = "kernel")]
    if let Some(kernel) = kernel::of_design(design) {
        texts.push(Text { name: "rust-hdl".to_owned(), top: "top".to_owned(), bytes: kernel.verilog().into_bytes() });
    }
    Ok(texts)
}

/// Proves that the texts of the core in a directory are pipelines of the core's latency and all the same circuit: see
/// [`equivalence`](self) for what that says. Each text is first run on the golden vectors.
///
/// `seconds` is the most that the solver may take at once; `progress` is told of each claim before and after it is
/// looked at. A claim that was proved is proved again with faults injected in one of the circuits; if one of them is
/// not found, the claim counts as open. Faults that a circuit cannot have, as its results are constants, are named.
///
/// # Errors
/// A tool that is not installed or does not do its work, GHDL and Yosys with a text that they do not read among them.
pub fn equivalence(
    design: &Design,
    directory: &Path,
    golden: &Golden,
    seconds: u32,
    progress: &dyn Fn(Step),
) -> Result<Vec<Proof>, Error> {
    let yosys = Yosys::find(None)?;
    let latency = design.schedule.latency;
    let mut proofs = Vec::new();
    let mut known: Vec<(String, Pipeline)> = Vec::new();
    for text in texts(design, directory)? {
        let claim = format!("{} is a pipeline of {latency} clocks", text.name);
        proofs.push(tried(claim, progress, || {
            let circuit = match Circuit::read(&yosys, directory, &text.top, &text.bytes)? {
                Ok(circuit) => circuit,
                Err(why) => return Ok((ProofStatus::Open, why)),
            };
            let pipeline = match Pipeline::of(circuit, latency) {
                Ok(pipeline) => pipeline,
                Err(why) => return Ok((ProofStatus::Refuted, why)),
            };
            let ran = pipeline.against(design, golden);
            known.push((text.name, pipeline));
            Ok(match ran {
                Ok(runs) => (ProofStatus::Proved, format!("and gives the results of {runs} golden vectors")),
                Err(differs) => (ProofStatus::Refuted, format!("it is another core: {differs}")),
            })
        })?);
    }
    let Some(((name, first), others)) = known.split_first() else { return Ok(proofs) };
    for (other_name, other) in others {
        proofs.push(tried(format!("{name} = {other_name}"), progress, || {
            compare([first, other], (design, golden), seconds)
        })?);
    }
    Ok(proofs)
}

fn compare(
    [one, other]: [&Pipeline; 2],
    core: (&Design, &Golden),
    seconds: u32,
) -> Result<(ProofStatus, String), Error> {
    let comparison = match Comparison::new(one, other) {
        Ok(comparison) => comparison,
        Err(differ) => return Ok((ProofStatus::Refuted, differ)),
    };
    let (method, compared, open) = match comparison.run(seconds)? {
        Compared::Same { method, compared, open } => (method, compared, open),
        Compared::Different(why) => return Ok((ProofStatus::Refuted, why)),
        Compared::Unknown(why) => return Ok((ProofStatus::Open, why)),
    };
    let injected = injected::check(&comparison, &method, core, seconds)?;
    let these = |text: &dyn Fn(&str, &Outcome) -> Option<String>| -> Vec<String> {
        injected.iter().filter_map(|(what, outcome)| text(what, outcome)).collect()
    };
    let missed = these(&|what, outcome| matches!(outcome, Outcome::Survived { .. }).then(|| what.to_owned()));
    if !missed.is_empty() {
        let how = format!("the proof goes through with an injected fault as well: {}", missed.join(", "));
        return Ok((ProofStatus::Open, how));
    }
    let method = match method {
        Technique::Stages(_) => format!("stage by stage, {compared} bits, {open} of them by the solver"),
        Technique::Every => format!("from the inputs to the outputs, {compared} bits, for every value of the inputs"),
        Technique::Whole => format!("from the inputs to the outputs, {compared} bits, {open} of them by the solver"),
    };
    let detected = Tally::of(injected.iter().map(|(_, outcome)| outcome)).detected;
    let mut how = format!("{method}; {detected} of {detected} injected faults found");
    let impossible = these(&|what, outcome| match outcome {
        Outcome::Undecided { tried } => Some(format!("{what} ({tried})")),
        _ => None,
    });
    if !impossible.is_empty() {
        how += &format!("; not injected: {}", impossible.join(", "));
    }
    Ok((ProofStatus::Proved, how))
}
