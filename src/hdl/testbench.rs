//! The self-checking test benches.

use askama::Template;

use super::{Layout, RomFile, Texts, render};
use crate::error::Error;
use crate::spec::Language;

/// What the templates of both languages need.
struct Bench<'a> {
    name: &'a str,
    header: &'a [String],
    rom_files: &'a [RomFile],
    golden: &'a str,
    operand: &'a str,
    operand_signed: bool,
    index_bits: u32,
    operand_bits: u32,
    output_bits: u32,
    latency: u32,
}

#[derive(Template)]
#[template(path = "testbench/tb.v", escape = "none")]
struct VerilogBench<'a> {
    bench: &'a Bench<'a>,
}

#[derive(Template)]
#[template(path = "testbench/tb.vhd", escape = "none")]
struct VhdlBench<'a> {
    bench: &'a Bench<'a>,
}

/// The test bench of a core in a language; `golden` is the path of its vectors, relative to the core's directory.
///
/// # Errors
/// If the template cannot be filled in.
pub fn test_bench(language: Language, layout: &Layout, texts: &Texts, golden: &str) -> Result<String, Error> {
    let graph = &layout.datapath.graph;
    let operand = &graph.nodes[graph.operand()];
    let bench = &Bench {
        name: &texts.name,
        header: &texts.header,
        rom_files: &texts.rom_files,
        golden,
        operand: &operand.name,
        operand_signed: operand.format.signed,
        index_bits: graph.nodes[graph.index()].format.width(),
        operand_bits: operand.format.width(),
        output_bits: graph.nodes[graph.output()].format.width(),
        latency: layout.schedule.latency,
    };
    match language {
        Language::Verilog => render(&VerilogBench { bench }),
        Language::Vhdl => render(&VhdlBench { bench }),
    }
}
