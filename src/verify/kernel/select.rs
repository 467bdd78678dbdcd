//! The kernel for a design, where there is one.

use super::{CubicRom, CubicWidths, Kernel, QuadraticRom, QuadraticWidths, cubic, quadratic};
use crate::core::Design;
use crate::spec::{Block, Form, InputRange, Operand, Pipeline, RomStyle, Tail};

/// The kernel of a design's method, if there is an instance at just its widths.
///
/// The kernels have the pipeline of `auto`, take any cosine, round down, read a ROM that is addressed by `in_n` itself and cannot
/// be written, and scale by a shift that is wholly in the ROM.
#[must_use]
pub fn of_design(design: &Design) -> Option<Box<dyn Kernel>> {
    let spec = &design.spec;
    let table = design.datapath.coefficients()?;
    let suits = spec.block == Block::Lobe
        && spec.method.form() == Form::Stable
        && spec.method.options().tail != Some(Tail::Hold)
        && spec.interface.operand == Operand::Cos
        && spec.interface.input_range == InputRange::Any
        && spec.pipeline == Pipeline::Auto
        && spec.rom != RomStyle::Writable
        && spec.interface.input_fraction <= spec.interface.output_fraction
        && table.first_index == 0
        && table.shared_shift == 0
        && table.fields.iter().all(|field| !field.format.signed);
    if !suits || table.find("k").is_none() {
        return None;
    }
    let words = |name: &str| -> Vec<u64> {
        let field = table.field(name);
        (0..table.depth()).map(|address| field.codes[table.row_of_address(address)] as u64).collect()
    };
    let width = |name: &str| table.field(name).format.width() as usize;
    let bits = |name: &str| design.widths.get(name) as usize;
    let (f, g, n) =
        (spec.interface.input_fraction as usize, spec.interface.output_fraction as usize, table.address_bits as usize);
    let k = words("k");
    match spec.method.about().name {
        "quadratic" => {
            let widths = QuadraticWidths {
                f,
                g,
                n,
                kw: width("k"),
                kmax: k.iter().max().copied().unwrap_or(0) as usize,
                ca: width("a"),
                fv: bits("v"),
                fp: bits("p"),
                xb: bits("x"),
                ft: bits("t"),
            };
            quadratic(&widths, QuadraticRom { k: &k, a: &words("a") })
        }
        "cubic" => {
            // Where no row is cut, the ROM has no threshold.
            table.find("cut")?;
            let node = |name: &str| design.graph().nodes.iter().find(|node| node.name == name);
            let (v, q) = (node("v")?.format, node("q")?.format);
            let widths = CubicWidths {
                f,
                g,
                n,
                kw: width("k"),
                fv: bits("v"),
                iv: v.int_bits as usize,
                cl: bits("a"),
                wl: width("a"),
                ca: bits("A"),
                wa: width("big_a"),
                fr: bits("A"),
                fq: bits("A"),
                wq: q.width() as usize,
                fp: bits("p"),
                xb: bits("x"),
                ft: bits("t"),
            };
            let rom = CubicRom { k: &k, a: &words("a"), constant: &words("big_a"), threshold: &words("cut") };
            cubic(&widths, rom)
        }
        _ => None,
    }
}
