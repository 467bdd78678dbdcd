//! Samples of any number of lights through a compiled core and its sequencer; through a core without one, samples of a
//! clock each.

use std::path::{Path, PathBuf};

use askama::Template;

use super::compiled::{CORE, converse, program};
use super::mutants::filters;
use crate::block::CHANNELS;
use crate::core::{Design, Direction};
use crate::emit::package::{self, Part};
use crate::emit::render;
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::platform::tool::{self, tail};
use crate::spec::Language;
use crate::synth;

const HARNESS: &str = include_str!("../../../testbench/sequence.cpp");
/// The bytes of a sample: a word a channel.
const SAMPLE: usize = 4 * CHANNELS.len();

/// The codes of the channels of samples, each the codes of the core's inputs at the clocks of its lights, one at least:
/// by the sequencer around the core in a directory, or the core itself where it has none, whose texts `sources` names,
/// given a clock's lights a clock. It is the core's Verilog that is compiled, or its VHDL where it has no Verilog.
/// `progress` is told how many samples have come.
///
/// # Errors
/// A tool that is not installed or does not compile the core; a core that fails, or has not given as many samples.
pub fn sequence(
    design: &Design,
    directory: &Path,
    sources: &[PathBuf],
    samples: impl Iterator<Item = Vec<Vec<i64>>> + Send,
    progress: &dyn Fn(u64),
) -> Result<Vec<[u16; 3]>, Error> {
    let program = build(design, directory, sources)?;
    let mut command = tool::program(&program);
    let (mut sent, mut bytes) = (0u64, Vec::new());
    let output = converse(
        // A file of a memory is named relative to the core's directory.
        command.current_dir(directory),
        |pipe| {
            for clocks in samples {
                for (place, codes) in clocks.iter().enumerate() {
                    let last = u32::from(place + 1 == clocks.len());
                    let words = std::iter::once(last).chain(codes.iter().map(|&code| code as u32));
                    pipe.write_all(&words.flat_map(u32::to_ne_bytes).collect::<Vec<u8>>())?;
                }
                sent += 1;
            }
            Ok(())
        },
        |pipe| {
            let mut part = vec![0; 1 << 16];
            while let Ok(read @ 1..) = pipe.read(&mut part) {
                bytes.extend_from_slice(&part[..read]);
                progress((bytes.len() / SAMPLE) as u64);
            }
        },
    )?;
    let words = bytes.as_chunks::<4>().0.iter().map(|word| u32::from_ne_bytes(*word) as u16);
    let words: Vec<u16> = words.collect();
    let (samples, rest) = words.as_chunks::<3>();
    if output.status.success() && samples.len() as u64 == sent && rest.is_empty() {
        return Ok(samples.to_vec());
    }
    Err(Error::ToolFailed {
        tool: CORE.program.to_owned(),
        what: format!("{} of {sent} samples, {}", samples.len(), output.status),
        output: tail(&output, 4),
    })
}

/// The program of a core and its sequencer.
fn build(design: &Design, directory: &Path, sources: &[PathBuf]) -> Result<PathBuf, Error> {
    let mut text = Vec::new();
    for source in sources {
        text.extend(std::fs::read(source).map_err(|error| Error::io("cannot read", source, error))?);
        text.push(b'\n');
    }
    let mut top = Part::sequenced(design).name(design);
    let mut verilog = match design.spec.compiled_language() {
        Language::Verilog => text,
        Language::Vhdl => {
            let scratch = tool::scratch()?;
            let source = scratch.path().join("core.vhd");
            std::fs::write(&source, &text).map_err(|error| Error::io("cannot write", &source, error))?;
            synth::as_verilog(&top, directory, &source)?
        }
    };
    if let Some((more, closed)) = package::closing(design, Part::sequenced(design))? {
        verilog.extend(more.into_bytes());
        top = closed;
    }
    let header = render(&Header { design, inputs: design.numbers(Direction::In), channels: CHANNELS })?;
    let files = [("core.v", verilog.as_slice()), ("core.h", header.as_bytes()), ("sequence.cpp", HARNESS.as_bytes())];
    self::program(&top, &files, "-O2")
}

/// What the harness needs to know of the core.
#[derive(Template)]
#[template(path = "cosim/sequence.h", escape = "none")]
struct Header<'a> {
    design: &'a Design,
    inputs: Vec<(&'a str, Format)>,
    channels: [char; 3],
}
