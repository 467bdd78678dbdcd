//! Wide products are built of blocks, and are the same products.

use brdfgen::datapath::graph::{Graph, Node, Op};
use brdfgen::datapath::products::{DspBlocks, of_blocks};
use brdfgen::fixed::{Format, Rng};
use brdfgen::target::{Dsp, Family};

/// A product of two ports, or the square of one.
fn product(operands: [Format; 2], square: bool) -> Graph {
    let signed = operands[0].signed;
    let [a, b] = operands;
    let int_bits = a.int_bits + b.int_bits + i32::from(signed);
    let format = Format { signed, int_bits, frac_bits: a.frac_bits + b.frac_bits };
    let node = |op: Op, args: &[usize], format: Format, name: &str| Node {
        op,
        args: args.to_vec(),
        format,
        name: name.to_owned(),
        comment: String::new(),
    };
    let nodes = vec![
        node(Op::Input, &[], a, "a"),
        node(Op::Input, &[], b, "b"),
        node(Op::Mul, &[0, usize::from(!square)], format, "p"),
    ];
    Graph { nodes, inputs: vec![0, 1], outputs: vec![("out".to_owned(), 2)] }
}

/// Asserts that all products of a graph fit a block and that it gives what another does.
fn assert_built(built: &Graph, dsp: &Dsp, whole: &Graph, inputs: impl Iterator<Item = [i128; 2]>, what: &str) {
    for node in built.nodes.iter().filter(|node| node.op == Op::Mul) {
        let [a, b] = [0, 1].map(|place| built.nodes[node.args[place]].format.width());
        let [most, least] = dsp.operands(node.format.signed);
        assert!(a.max(b) <= most && a.min(b) <= least, "{what}: a part of {a}x{b}");
        // No part loses a bit.
        let formats = [0, 1].map(|place| built.nodes[node.args[place]].format);
        assert_eq!(formats[0].signed, formats[1].signed, "{what}");
        assert_eq!(node.format.width(), a + b, "{what}");
    }
    for codes in inputs {
        let result = |graph: &Graph| graph.values(&[], &codes)[graph.outputs[0].1];
        assert_eq!(result(built), result(whole), "{what}: {codes:?}");
    }
}

fn block(operands: [u32; 2], sign_bits: u32) -> Dsp {
    // One shape, which lives as long as the program.
    let shapes = Box::leak(Box::new([(operands, 1)]));
    Dsp { shapes, parts: 1, sign_bits, least_operand: 2, least_product: 0 }
}

/// Every code of every pair of widths up to 7 bits, of blocks of a few bits.
#[test]
fn products_of_small_blocks_are_the_same_for_every_input() {
    for (dsp, signed) in [(block([3, 3], 0), false), (block([3, 3], 0), true), (block([4, 3], 1), false)] {
        for widths in (1..=7).flat_map(|a| (1..=7).map(move |b| [a, b])) {
            for square in [false, true] {
                if signed && widths.contains(&1) || square && widths[0] != widths[1] {
                    continue;
                }
                let format = |width: i32| Format { signed, int_bits: 2, frac_bits: width - 2 - i32::from(signed) };
                let operands = widths.map(format);
                let whole = product(operands, square);
                let (built, wide) = of_blocks(&whole, &dsp);
                let what = format!("{operands:?} of {:?}, square {square}", dsp.shapes);
                let [least, most] = [operands.map(Format::min_code), operands.map(Format::max_code)];
                let codes = (least[0]..=most[0]).flat_map(|a| (least[1]..=most[1]).map(move |b| [a, b]));
                assert_built(&built, &dsp, &whole, codes, &what);
                let fits = built == whole;
                assert_eq!(wide.is_empty(), fits, "{what}");
                if let [wide] = &wide[..] {
                    assert_eq!(built.outputs[0].1, wide.node, "{what}");
                    assert_eq!(wide.operands, widths.map(|width| width as u32), "{what}");
                    let products = built.nodes.iter().filter(|node| node.op == Op::Mul).count();
                    assert_eq!(wide.parts(&built).count(), products, "{what}");
                }
            }
        }
    }
}

/// Random and extreme codes of random formats, for each family.
#[test]
fn products_of_every_familys_blocks_are_the_same() {
    let mut rng = Rng::new(5);
    for &family in Family::ALL {
        for _ in 0..300 {
            let signed = rng.below(2) == 0;
            let mut format = || {
                let width = 2 + rng.below(59) as i32;
                let frac_bits = rng.below(40) as i32 - 4;
                Format { signed, int_bits: width - frac_bits - i32::from(signed), frac_bits }
            };
            let mut operands = [format(), format()];
            let square = rng.below(2) == 0;
            if square {
                operands[1] = operands[0];
            }
            let whole = product(operands, square);
            let (built, _) = DspBlocks::Of(family).built(&whole);
            let mut codes = vec![operands.map(Format::min_code), operands.map(Format::max_code), [0, -1], [-1, -1]];
            for _ in 0..100 {
                codes.push([(); 2].map(|()| i128::from(rng.below(u64::MAX))));
            }
            let codes = codes.into_iter().map(|[a, b]| [operands[0].wrap(a), operands[1].wrap(b)]);
            assert_built(&built, &family.dsp, &whole, codes, &format!("{operands:?} of {}", family.name));
            assert_eq!(DspBlocks::Whole.built(&whole), (whole, Vec::new()));
        }
    }
}

/// Parts of a constant are constants.
#[test]
fn a_wide_constant_is_split_as_well() {
    for (signed, code) in [(false, (1 << 29) - 12_345), (true, -(1 << 29) + 12_345), (true, (1 << 29) - 1)] {
        let format = Format { signed, int_bits: 3, frac_bits: 27 };
        let mut whole = product([format; 2], false);
        whole.nodes[1] = Node { op: Op::Constant(code), ..whole.nodes[1].clone() };
        whole.inputs = vec![0];
        let (built, wide) = DspBlocks::default().built(&whole);
        assert_eq!(wide.len(), 1);
        let is_constant = |id: usize| matches!(built.nodes[id].op, Op::Constant(_));
        assert!(built.nodes.iter().all(|node| node.op != Op::Cast || !is_constant(node.args[0])));
        for input in [format.min_code(), -1, 0, 1, 0x155_5555, format.max_code()] {
            let result = |graph: &Graph| graph.values(&[], &[format.wrap(input)])[graph.outputs[0].1];
            assert_eq!(result(&built), result(&whole), "{code} {input}");
        }
    }
}

/// A square needs fewer blocks than a product: the mixed products are one.
#[test]
fn squares_share_their_mixed_products() {
    let format = Format::unsigned(0, 29);
    let parts = |square: bool| DspBlocks::default().built(&product([format; 2], square)).1[0].parts.len();
    assert_eq!([parts(false), parts(true)], [4, 3]);
}

#[test]
fn what_products_are_built_of_is_a_family_or_nothing() {
    for text in ["ecp5", "ice40", "none"] {
        assert_eq!(text.parse::<DspBlocks>().map(|dsp| dsp.to_string()), Ok(text.to_owned()));
    }
    let message = "stratix".parse::<DspBlocks>().unwrap_err();
    assert!(message.contains("stratix") && message.contains("ecp5, ice40") && message.contains("none"), "{message}");
}
