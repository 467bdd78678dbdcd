//! The kernel for a design, where there is one.

use super::{CubicRom, CubicWidths, Kernel, QuadraticRom, QuadraticWidths, cubic, quadratic};
use crate::core::{BlockDesign, Design};
use crate::datapath::graph::{Graph, Node, Op};
use crate::datapath::products::WideProduct;
use crate::fixed::{Format, Width};
use crate::method::width;
use crate::spec::{Form, InputRange, Operand, Pipeline, RomStyle, Tail};

/// The kernel of a design's method, if there is an instance at just its widths.
///
/// The kernels have the pipeline of `auto`, take any cosine, round down, read a ROM that is addressed by `in_n` itself
/// and cannot be written, and scale by a shift that is wholly in the ROM.
#[must_use]
pub fn of_design(design: &Design) -> Option<Box<dyn Kernel>> {
    let BlockDesign::Lobe(lobe) = design.block() else { return None };
    let (spec, interface) = (&design.spec, lobe.interface);
    let table = design.datapath.coefficients()?;
    let suits = lobe.method.form() == Form::Stable
        && lobe.method.options().tail != Some(Tail::Hold)
        && interface.operand == Operand::Cos
        && interface.input_range == InputRange::Any
        && spec.pipeline == Pipeline::Auto
        && spec.rom != RomStyle::Writable
        && interface.input_fraction <= interface.output_fraction
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
    let bits = |width: Width| lobe.widths[width] as usize;
    let (f, g, n) =
        (interface.input_fraction as usize, interface.output_fraction as usize, table.address_bits as usize);
    let k = words("k");
    match lobe.method.about().name {
        "quadratic" if design.wide_products.is_empty() => {
            let widths = QuadraticWidths {
                f,
                g,
                n,
                kw: width("k"),
                kmax: k.iter().max().copied().unwrap_or(0) as usize,
                ca: width("a"),
                fv: bits(width::V),
                fp: bits(width::P),
                xb: bits(width::X),
                ft: bits(width::T),
            };
            quadratic(&widths, QuadraticRom { k: &k, a: &words("a") })
        }
        "cubic" => {
            // Where no row is cut, the ROM has no threshold.
            table.find("cut")?;
            let nodes = &design.function().nodes;
            let products: Vec<&Node> = nodes.iter().filter(|node| node.op == Op::Mul).collect();
            // a v, v q and x p.
            let [_, vq, _] = products[..] else { return None };
            let [v, q] = [0, 1].map(|place| nodes[vq.args[place]].format);
            let lq = match &design.wide_products[..] {
                [] => None,
                [wide] if wide.operands == [v, q].map(Format::width) => Some(low_of_right(design.graph(), wide)?),
                _ => return None,
            };
            let widths = CubicWidths {
                f,
                g,
                n,
                kw: width("k"),
                fv: bits(width::V),
                iv: v.int_bits as usize,
                cl: bits(width::SMALL_A),
                wl: width("a"),
                ca: bits(width::BIG_A),
                wa: width("big_a"),
                fr: bits(width::BIG_A),
                fq: bits(width::BIG_A),
                wq: q.width() as usize,
                lq,
                fp: bits(width::P),
                xb: bits(width::X),
                ft: bits(width::T),
            };
            let rom = CubicRom { k: &k, a: &words("a"), constant: &words("big_a"), threshold: &words("cut") };
            cubic(&widths, rom)
        }
        _ => None,
    }
}

/// The low bits of the right operand of a wide product which of all is split, once.
fn low_of_right(graph: &Graph, wide: &WideProduct) -> Option<usize> {
    let &[low, high] = &wide.parts[..] else { return None };
    let [left, right] = [0, 1].map(|place| [low, high].map(|part| graph.nodes[part].args[place]));
    (left[0] == left[1]).then(|| graph.nodes[right[0]].format.width() as usize)
}
