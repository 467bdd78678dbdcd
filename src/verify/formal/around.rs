//! The proofs of what is around a core, forever and whatever comes at its inputs.
//!
//! - Of the wrapper with AXI4-Stream interfaces, `templates/formal/stream.v`: no beat is lost, doubled, made up or
//!   reordered, `tlast`, `tuser` and `tdata` stay with their beat, a beat that waits stays as it is, the source waits
//!   for the sink only, a full pipeline gives a beat at every clock, and a reset drops everything; where lights come in
//!   sequence that is said of the beats that end a sample, and where they come from a table the source waits for the
//!   words of the sample before as well, and for no clock more.
//! - Of the sequencer, `templates/formal/lights.v`: a sample comes out where it has ended, as the sum of its lights,
//!   rounded once.
//! - Of the table of lights, `templates/formal/table.v`: every sample goes through its words in order, its inputs with
//!   it, and the next is taken with the last.

use std::path::Path;

use askama::Template;

use super::induction::{Claims, prove};
use super::{Proof, Step, tried};
use crate::block::CHANNELS;
use crate::core::Design;
use crate::emit::package::{self, Part};
use crate::emit::{Axis, Connected, LightTable, Sequencer, render};
use crate::platform::error::Error;
use crate::spec::Language;

#[derive(Template)]
#[template(path = "formal/stream.v", escape = "none")]
struct AxisClaims<'a> {
    axis: &'a Axis,
}

#[derive(Template)]
#[template(path = "formal/lights.v", escape = "none")]
struct SequencerClaims<'a> {
    sequencer: &'a Sequencer,
    channels: [char; 3],
    /// Fraction bits of the sums, and bits of a code.
    f: u32,
    bits: u32,
    /// Half a code and 1.0, in units of a sum's last bit; the greatest code.
    half: i64,
    one: i64,
    full: i64,
}

#[derive(Template)]
#[template(path = "formal/table.v", escape = "none")]
struct TableClaims<'a> {
    table: &'a LightTable,
    /// The ports besides those of every core.
    inputs: Vec<Connected>,
    channels: [char; 3],
    bits: u32,
}

/// Proves what is promised of a core's sequencer, its table of lights and its wrapper, of those among the parts, once
/// for each of its languages; of a core without them there is nothing to prove.
///
/// `directory` is the core's. `progress` is told of each claim before and after it is looked at.
///
/// # Errors
/// A tool that is not installed, or a text that GHDL or Yosys does not read.
pub fn around(design: &Design, parts: &[Part], directory: &Path, progress: &dyn Fn(Step)) -> Result<Vec<Proof>, Error> {
    let mut all = Vec::new();
    if let Some(sequencer) = package::sequencer(design) {
        all.push(("adds up the lights of every sample, and rounds the sum once", of_sequencer(&sequencer)?));
    }
    if let Some(table) = package::light_table(design) {
        all.push(("reads the lights of every sample in order, and takes the next with the last", of_table(&table)?));
    }
    if let Some(axis) = package::axis(design) {
        all.push(("keeps every beat, in order and unchanged, at full throughput", of_axis(&axis)?));
    }
    all.retain(|(_, claims)| parts.contains(&claims.part));
    let proved = |(promise, claims): &(&str, Claims)| {
        let of_language = |&language: &Language| {
            let claim = format!("{} in {language} {promise}", claims.part.name(design));
            tried(claim, progress, || prove(design, claims, directory, language))
        };
        design.spec.languages.iter().map(of_language).collect::<Result<Vec<_>, _>>()
    };
    Ok(all.iter().map(proved).collect::<Result<Vec<_>, _>>()?.concat())
}

fn of_axis(axis: &Axis) -> Result<Claims, Error> {
    let own = ["ready", "skid_valid", "last", "user", "skid"].into_iter();
    let own = own.filter(|&name| name != "last" || !axis.sequenced);
    let own = own.map(|name| (name.to_owned(), format!("dut.{name}")));
    let lanes = axis.inputs.lanes.iter().chain(&axis.outputs.lanes).map(|lane| lane.port.name.as_str());
    let of_core = lanes.map(|name| (name, name));
    // What tells of a beat at each stage.
    let valid: &[_] = if axis.takes_samples() {
        &[
            ("busy", "busy"),
            ("word", "word"),
            ("until_word", "until_word"),
            ("read_valid", "valid"),
            ("read_last", "last"),
            ("sequencer_valid", "sequencer.valid"),
        ]
    } else {
        &[("valid", "valid")]
    };
    let of_core = of_core.chain(valid.iter().copied());
    let of_core = of_core.map(|(wire, name)| (wire.to_owned(), format!("dut.core.{name}")));
    Ok(Claims {
        module: "stream",
        text: render(&AxisClaims { axis })?,
        part: Part::Axis,
        connections: own.chain(of_core).collect(),
        // Beats that leave the skid register, and a full wrapper that is reset, take a walk through the pipeline.
        walk: axis.latency + 8,
    })
}

fn of_table(table: &LightTable) -> Result<Claims, Error> {
    let inputs = table.inputs();
    let text = TableClaims { table, inputs, channels: CHANNELS, bits: table.sequencer.sums.channel_bits };
    let own = ["busy", "word", "until_word"].map(|name| (name.to_owned(), format!("dut.{name}")));
    let read =
        [("read_valid", "valid"), ("read_last", "last")].map(|(wire, name)| (wire.to_owned(), format!("dut.{name}")));
    let of_sample = |port: &Connected| {
        let Connected { name, .. } = port;
        [(format!("now_{name}"), format!("dut.now_{name}")), (format!("read_{name}"), format!("dut.sequencer.{name}"))]
    };
    Ok(Claims {
        module: "lights_table",
        text: render(&text)?,
        part: Part::Table,
        connections: own.into_iter().chain(read).chain(table.sample.iter().flat_map(of_sample)).collect(),
        walk: table.latency + 8,
    })
}

fn of_sequencer(sequencer: &Sequencer) -> Result<Claims, Error> {
    let (channels, sums) = (CHANNELS, sequencer.sums);
    let text = SequencerClaims {
        sequencer,
        channels,
        f: sums.frac_bits,
        bits: sums.channel_bits,
        half: sums.half_code(),
        one: 1 << sums.frac_bits,
        full: sums.full_scale(),
    };
    let kept = channels.iter().flat_map(|c| ["so_far", "was_full", "total", "full"].map(|what| format!("{what}_{c}")));
    let of_ambient = std::iter::once("begins".to_owned()).chain(channels.iter().map(|c| format!("ambient_{c}")));
    let of_ambient = of_ambient.filter(|_| sums.ambient.is_some());
    let own = std::iter::once("valid".to_owned()).chain(kept).chain(of_ambient);
    let own = own.map(|name| (name.clone(), format!("dut.{name}")));
    let outputs = sequencer.core_outputs().iter().map(|port| (port.name.clone(), format!("dut.{}", port.name)));
    let inputs = sequencer.driven();
    let inputs = inputs.iter().map(|port| (format!("core_{}", port.name), format!("dut.core.{}", port.name)));
    let core = std::iter::once(("core_valid".to_owned(), "dut.core.valid".to_owned()));
    Ok(Claims {
        module: "lights",
        text: render(&text)?,
        part: Part::Lights,
        connections: own.chain(outputs).chain(inputs).chain(core).collect(),
        walk: sequencer.latency + 4,
    })
}
