//! Verilog-2005.

use askama::Template;
use num_bigint::BigUint;

use super::{
    Backend, Declaration, Direction, Layout, Port, ReadPort, Role, Texts, WritePort, continued, names, render,
};
use crate::datapath::graph::{NodeId, Op, clamped_from};
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::spec::Language;

/// The Verilog backend.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verilog;

struct Wire {
    comment: String,
    range: String,
    name: String,
    expression: String,
}

struct Reg {
    range: String,
    name: String,
    source: String,
}

/// A memory, read in a stage.
struct MemoryText<'a> {
    name: &'a str,
    word: String,
    range: String,
    address: String,
    depth: usize,
    /// Where its second set of so many words begins, if it holds two.
    second: Option<usize>,
    registered: bool,
    /// The parameter that names its file, if it is read from one.
    parameter: Option<String>,
    /// The ports through which it is written, if it is.
    write: Option<&'a WritePort>,
    /// The ports through which it is read, if it lies outside of the core.
    outside: Option<&'a ReadPort>,
    rows: Vec<(String, String)>,
}

impl MemoryText<'_> {
    /// The greatest address.
    fn last(&self) -> usize {
        self.second.unwrap_or_default() + self.depth - 1
    }

    /// Whether its words are in an array, and not in the branches of a case statement.
    fn in_array(&self) -> bool {
        self.parameter.is_some() || self.write.is_some()
    }
}

struct Stage<'a> {
    index: u32,
    heading: String,
    memories: Vec<MemoryText<'a>>,
    wires: Vec<Wire>,
    regs: Vec<Reg>,
}

#[derive(Template)]
#[template(path = "verilog/core.v", escape = "none")]
struct Core<'a> {
    texts: &'a Texts,
    ports: Vec<Declaration>,
    latency: u32,
    /// The last stage in which a set of texels is chosen, if there are several.
    set_stage: Option<u32>,
    stages: Vec<Stage<'a>>,
    /// `out_valid` and the other outputs with what they show, their names of one length.
    out_valid: String,
    outputs: Vec<(String, String)>,
    unused: Vec<String>,
}

/// `[high:0] `, or nothing for a single bit.
fn range(format: Format) -> String {
    match format.width() {
        1 => String::new(),
        width => format!("[{}:0] ", width - 1),
    }
}

fn literal(code: i128, width: u32) -> String {
    let format = Format::unsigned(width as i32, 0);
    format!("{width}'h{:0digits$x}", format.bits(code), digits = width.div_ceil(4) as usize)
}

/// A memory's word, in parts on a line each where it would be too long for one.
fn word_literal(word: &BigUint, bits: u32) -> String {
    const PART: u32 = 224;
    let part = |low: u32| {
        let width = (bits - low).min(PART);
        let value = (word >> low) & ((BigUint::from(1u8) << width) - 1u8);
        format!("{width}'h{value:0digits$x}", digits = width.div_ceil(4) as usize)
    };
    if bits <= PART {
        return part(0);
    }
    let parts: Vec<String> = (0..bits.div_ceil(PART)).rev().map(|index| part(PART * index)).collect();
    format!("{{\n                    {}}}", parts.join(",\n                    "))
}

fn zeros(width: u32) -> String {
    format!("{width}'d0")
}

/// Bits `high..=low` of a value that is `width` bits wide.
fn slice(name: &str, width: u32, high: u32, low: u32) -> String {
    if low == 0 && high + 1 == width {
        name.to_owned()
    } else if high == low {
        format!("{name}[{low}]")
    } else {
        format!("{name}[{high}:{low}]")
    }
}

struct Writer<'a> {
    layout: &'a Layout<'a>,
    stage: u32,
}

impl Writer<'_> {
    fn format(&self, id: NodeId) -> Format {
        self.layout.nodes()[id].format
    }

    fn name(&self, id: NodeId) -> String {
        self.layout.name(id, self.stage)
    }

    /// A node's value, aligned to `frac_bits` and exactly `width` bits wide.
    fn fitted(&self, id: NodeId, frac_bits: i32, width: u32) -> String {
        let format = self.format(id);
        let shift = (frac_bits - format.frac_bits) as u32;
        if let Op::Constant(code) = self.layout.nodes()[id].op {
            return literal(code << shift, width);
        }
        if shift >= width {
            return zeros(width);
        }
        let name = self.name(id);
        let kept = format.width().min(width - shift);
        let own = slice(&name, format.width(), kept - 1, 0);
        let extra = width - shift - kept;
        let mut parts = Vec::new();
        match (extra, format.signed) {
            (0, _) => {}
            (_, false) => parts.push(zeros(extra)),
            (_, true) => parts.push(format!("{{{extra}{{{name}[{}]}}}}", format.width() - 1)),
        }
        parts.push(own);
        if shift > 0 {
            parts.push(zeros(shift));
        }
        if parts.len() == 1 { parts.remove(0) } else { format!("{{{}}}", parts.join(", ")) }
    }

    fn expression(&self, id: NodeId) -> String {
        let node = &self.layout.nodes()[id];
        let (frac, width) = (node.format.frac_bits, node.format.width());
        let arg = |index: usize| node.args[index];
        match node.op {
            Op::Input | Op::Constant(_) => unreachable!("a port or a literal"),
            Op::Field { memory, field } => {
                let table = &self.layout.datapath.tables[memory];
                let low = table.field_low_bit(field);
                let word = format!("{}_{}", table.name, self.stage);
                slice(&word, table.word_bits(), low + width - 1, low)
            }
            Op::Clamp { low, high } => self.clamp(arg(0), low, high, width),
            Op::Add => format!("{} + {}", self.fitted(arg(0), frac, width), self.fitted(arg(1), frac, width)),
            Op::Sub => format!("{} - {}", self.fitted(arg(0), frac, width), self.fitted(arg(1), frac, width)),
            Op::Mul => {
                let [a, b] =
                    [arg(0), arg(1)].map(|id| self.fitted(id, self.format(id).frac_bits, self.format(id).width()));
                if node.format.signed { format!("$signed({a}) * $signed({b})") } else { format!("{a} * {b}") }
            }
            Op::ShiftLeft => {
                let from = self.format(arg(0)).frac_bits;
                format!("{} << {}", self.fitted(arg(0), from, width), self.name(arg(1)))
            }
            Op::ShiftRight if node.format.signed => format!("$signed({}) >>> {}", self.name(arg(0)), self.name(arg(1))),
            Op::ShiftRight => format!("{} >> {}", self.name(arg(0)), self.name(arg(1))),
            Op::Cast => {
                let from = self.format(arg(0));
                if frac >= from.frac_bits {
                    return self.fitted(arg(0), frac, width);
                }
                let low = (from.frac_bits - frac) as u32;
                let name = self.name(arg(0));
                if low >= from.width() {
                    // Every bit is dropped: what is left of a number is its sign.
                    let sign = format!("{{{width}{{{name}[{}]}}}}", from.width() - 1);
                    return if from.signed { sign } else { zeros(width) };
                }
                let kept = (from.width() - low).min(width);
                let own = slice(&name, from.width(), low + kept - 1, low);
                match (width - kept, from.signed) {
                    (0, _) => own,
                    (extra, false) => format!("{{{}, {own}}}", zeros(extra)),
                    (extra, true) => format!("{{{{{extra}{{{name}[{}]}}}}, {own}}}", from.width() - 1),
                }
            }
            Op::Scale => self.name(arg(0)),
            Op::NonZero => format!("|{}", self.name(arg(0))),
            Op::Greater => {
                if let Some(decided) = self.layout.decided(arg(0), arg(1)) {
                    return literal(decided.into(), 1);
                }
                let wider = self.format(arg(0)).width().max(self.format(arg(1)).width());
                let frac = self.format(arg(0)).frac_bits;
                let [a, b] = [arg(0), arg(1)].map(|id| self.fitted(id, frac, wider));
                if self.format(arg(0)).signed { format!("$signed({a}) > $signed({b})") } else { format!("{a} > {b}") }
            }
            Op::Or => format!("{} | {}", self.name(arg(0)), self.name(arg(1))),
            Op::Not => format!("~{}", self.name(arg(0))),
            Op::Select => {
                let [a, b] = [arg(1), arg(2)].map(|id| self.fitted(id, frac, width));
                format!("{} ? {a} : {b}", self.name(arg(0)))
            }
            Op::ZeroIf => format!("{} ? {} : {}", self.name(arg(0)), zeros(width), self.name(arg(1))),
        }
    }

    fn clamp(&self, arg: NodeId, low: i128, high: i128, width: u32) -> String {
        let (from, name) = (self.format(arg), self.name(arg));
        let magnitude = from.width() - u32::from(from.signed);
        // Past a power of two the high bits tell.
        let leading = |power: i128| slice(&name, from.width(), magnitude - 1, power.trailing_zeros());
        let power = clamped_from(high);
        if low < 0 {
            let sign = format!("{name}[{}]", from.width() - 1);
            let of = |test: String, bound: i128| format!("({test}) ? {} :\n        ", literal(bound, width));
            let compared =
                |test: &str, bound| format!("$signed({name}) {test} $signed({})", literal(bound, from.width()));
            let below = match low {
                _ if low <= from.min_code() => String::new(),
                _ if (-low).count_ones() == 1 => of(format!("{sign} & ~&{}", leading(-low)), low),
                _ => of(compared("<", low), low),
            };
            let above = match power {
                _ if high >= from.max_code() => String::new(),
                Some(power) => of(format!("~{sign} & |{}", leading(power)), high),
                None => of(compared(">", high), high),
            };
            return below + &above + &self.fitted(arg, from.frac_bits, width);
        }
        let own = slice(&name, from.width(), width.min(magnitude) - 1, 0);
        let own = if magnitude < width { format!("{{{}, {own}}}", zeros(width - magnitude)) } else { own };
        let mut text = String::new();
        if from.signed && low > 0 {
            let bound = literal(low, from.width());
            text += &format!("($signed({name}) < $signed({bound})) ? {} : ", literal(low, width));
        } else if from.signed {
            text += &format!("{name}[{}] ? {} : ", from.width() - 1, literal(low, width));
        } else if low > 0 {
            text += &format!("({name} < {}) ? {} : ", literal(low, from.width()), literal(low, width));
        }
        if high < from.max_code() {
            let test = match power {
                Some(power) => format!("|{}", leading(power)),
                None => format!("{name} > {}", literal(high, from.width())),
            };
            text += &format!("({test}) ? {} : ", literal(high, width));
        }
        text + &own
    }
}

/// Ports in the text of a module.
pub(super) fn declarations(ports: &[Port]) -> Vec<Declaration> {
    ports.iter().map(declaration).collect()
}

fn declaration(port: &Port) -> Declaration {
    let direction = match port.role.direction() {
        Direction::In => "input  wire",
        Direction::Out => "output wire",
    };
    let range = port.format.map_or("       ".to_owned(), range);
    Declaration { comment: port.comment(), declaration: format!("{direction} {range}{}", port.name) }
}

/// The memories that are read in a stage.
fn memories<'a>(layout: &Layout<'a>, texts: &'a Texts, stage: u32) -> Vec<MemoryText<'a>> {
    let tables = layout.datapath.tables.iter().enumerate();
    let reads = tables.filter_map(|(memory, table)| Some((memory, table, layout.read(memory)?)));
    reads
        .filter(|(_, _, read)| read.stage == stage)
        .map(|(memory, table, read)| {
            let address_bits = layout.nodes()[read.address].format.width();
            let row = |address: usize| {
                (format!("{address_bits}'d{address}"), word_literal(&table.word(address), table.word_bits()))
            };
            let write = texts.write_port(memory);
            MemoryText {
                name: table.name,
                range: range(Format::unsigned(table.word_bits() as i32, 0)),
                address: match (texts.sets_of(memory), stage) {
                    (1, _) => layout.name(read.address, stage),
                    (_, 0) => format!("{{{}, {}}}", Role::IN_SET, layout.name(read.address, stage)),
                    _ => format!("{{sets[{stage}], {}}}", layout.name(read.address, stage)),
                },
                depth: table.depth(),
                second: (texts.sets_of(memory) > 1).then_some(1 << table.address_bits),
                registered: read.registers > 0,
                outside: texts.read_port(memory),
                parameter: texts.rom_file(table.name).map(|file| file.parameter.clone()),
                write,
                rows: (0..table.depth()).map(row).collect(),
                word: read.word,
            }
        })
        .collect()
}

impl Backend for Verilog {
    fn emit(&self, layout: &Layout, texts: &Texts) -> Result<String, Error> {
        let mut unused = Vec::new();
        let stages = (0..layout.schedule.latency)
            .map(|index| {
                let writer = Writer { layout, stage: index };
                let wire = |id: NodeId| {
                    let node = &layout.nodes()[id];
                    let (range, name) = (range(node.format), layout.name(id, index));
                    Wire {
                        comment: format!("{}: {}", node.format, node.comment),
                        expression: continued(format!("    wire {range}{name} =").len(), &writer.expression(id)),
                        range,
                        name,
                    }
                };
                let computed = layout.computed(index);
                let reg = |register: crate::core::layout::Register| Reg {
                    range: range(layout.nodes()[register.node].format),
                    name: layout.name(register.node, index + 1),
                    source: layout.name(register.node, index),
                };
                Stage {
                    index,
                    heading: layout.heading(index),
                    memories: memories(layout, texts, index),
                    wires: computed.into_iter().map(wire).collect(),
                    regs: layout.registers(index).into_iter().map(reg).collect(),
                }
            })
            .collect();
        for id in (0..layout.nodes().len()).filter(|&id| !layout.is_literal(id)) {
            let (node, last) = (&layout.nodes()[id], layout.schedule.last_use[id]);
            for (high, low) in layout.unused_bits(id) {
                unused.push(slice(&layout.name(id, last), node.format.width(), high, low));
            }
        }
        let text = render(&Core {
            texts,
            ports: declarations(&texts.ports),
            latency: layout.schedule.latency,
            set_stage: texts.last_set_stage(layout),
            stages,
            out_valid: layout.padded_output("out_valid"),
            outputs: layout.shown(),
            unused,
        })?;
        names::checked(Language::Verilog, &texts.name, text)
    }
}
