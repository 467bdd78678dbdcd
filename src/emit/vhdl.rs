//! VHDL-2008 with `ieee.numeric_std`.

use askama::Template;
use num_bigint::BigUint;

use super::{Backend, Declaration, Layout, Port, ReadPort, Role, Texts, WritePort, continued, names, render};
use crate::core::layout::Register;
use crate::datapath::graph::{NodeId, Op, clamped_from};
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::spec::{Language, VhdlPorts};

/// The VHDL backend.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vhdl;

struct Signal {
    name: String,
    kind: String,
}

struct Assignment {
    comment: String,
    target: String,
    expression: String,
}

/// A memory, read in a stage.
struct MemoryText<'a> {
    name: &'a str,
    /// The name of its constant.
    constant: String,
    word: String,
    bits: u32,
    address: String,
    depth: usize,
    /// Where its second set of so many words begins, if it holds two.
    second: Option<usize>,
    registered: bool,
    /// The ports through which it is read, if it lies outside of the core.
    outside: Option<&'a ReadPort>,
    /// The generic that names its file, if it is read from one.
    generic: Option<String>,
    /// The ports through which it is written, if it is.
    write: Option<&'a WritePort>,
    chunks: Vec<Chunk>,
}

/// A function that reads a memory's words from a file.
pub(super) struct WordReader {
    /// What is read, as its name says it.
    pub(super) name: String,
    /// The type of the words.
    pub(super) kind: String,
    /// The words.
    pub(super) depth: usize,
    /// Bits of a word.
    pub(super) bits: u32,
    /// Where they stand once more, if they do.
    pub(super) second: Option<usize>,
}

impl MemoryText<'_> {
    /// What reads its words.
    fn reader(&self) -> WordReader {
        let (name, kind) = (self.name.to_owned(), format!("{}_t", self.name));
        WordReader { name, kind, depth: self.depth, bits: self.bits, second: self.second }
    }

    /// The greatest address.
    fn last(&self) -> usize {
        self.second.unwrap_or_default() + self.depth - 1
    }

    /// The constant or signal that holds its whole words, if they are not in [`MemoryText::chunks`] only.
    fn array(&self) -> Option<&str> {
        match (&self.generic, self.write) {
            (_, Some(_)) => Some(self.name),
            (Some(_), None) => Some(&self.constant),
            (None, None) => None,
        }
    }
}

struct Stage<'a> {
    index: u32,
    heading: String,
    memories: Vec<MemoryText<'a>>,
    assignments: Vec<Assignment>,
    registers: Vec<(String, String)>,
}

/// Up to 32 bits of every ROM word: some tools take no longer constants.
struct Chunk {
    index: usize,
    /// Bits of the array's elements, a whole number of hexadecimal digits.
    element_bits: u32,
    /// Bits of the word.
    bits: u32,
    high: u32,
    low: u32,
    rows: Vec<(usize, String)>,
}

#[derive(Template)]
#[template(path = "vhdl/core.vhd", escape = "none")]
struct Core<'a> {
    texts: &'a Texts,
    ports: Vec<Declaration>,
    /// The signals of the inputs and what they are of the ports, where the ports are no numbers.
    inputs: Vec<(String, String)>,
    latency: u32,
    /// The last stage in which a set of texels is chosen, if there are several.
    set_stage: Option<u32>,
    signals: Vec<Signal>,
    stages: Vec<Stage<'a>>,
    /// `out_valid` and the other outputs with what they show, their names of one length.
    out_valid: String,
    outputs: Vec<(String, String)>,
}

impl Core<'_> {
    /// The address that is written, as a number.
    fn write_address(&self, write: &WritePort) -> String {
        port_number(&write.address.name, self.texts.vhdl_ports)
    }

    /// An address as a port shows it.
    fn read_address(&self, address: &str) -> String {
        match self.texts.vhdl_ports {
            VhdlPorts::StdLogic => format!("std_logic_vector({address})"),
            VhdlPorts::Numeric => address.to_owned(),
        }
    }

    /// Whether the memory is the first that is written, in the order of the text.
    fn is_first_written(&self, name: &str) -> bool {
        let mut memories = self.stages.iter().flat_map(|stage| &stage.memories);
        memories.find(|memory| memory.write.is_some()).is_some_and(|memory| memory.name == name)
    }
}

/// What a port of unsigned codes has, as a number.
pub(super) fn port_number(port: &str, types: VhdlPorts) -> String {
    if types == VhdlPorts::StdLogic { format!("unsigned({port})") } else { port.to_owned() }
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

    /// The name of a node's value as a vector: a flag is a single bit.
    fn vector(&self, id: NodeId) -> String {
        if self.layout.is_flag(id) { format!("unsigned'(\"\" & {})", self.name(id)) } else { self.name(id) }
    }

    /// A value of one bit as a `std_logic`.
    fn bit(&self, id: NodeId) -> String {
        let name = self.name(id);
        if self.layout.is_flag(id) { name } else { format!("{name}(0)") }
    }

    fn kind(&self, id: NodeId) -> String {
        if self.layout.is_flag(id) { "std_logic".to_owned() } else { kind(self.format(id)) }
    }

    /// The type of a node's signal and its initial value.
    fn initialised(&self, id: NodeId) -> String {
        format!("{} := {}", self.kind(id), initial(self.layout.is_flag(id)))
    }

    /// A node's value as a vector of the signedness, the fraction bits and exactly the width of `to`.
    fn fitted(&self, id: NodeId, to: Format) -> String {
        let (from, width) = (self.format(id), to.width());
        let shift = (to.frac_bits - from.frac_bits) as u32;
        let shifted = |text: String| if shift > 0 { format!("shift_left({text}, {shift})") } else { text };
        if let Op::Constant(code) = self.layout.nodes()[id].op {
            let function = if to.signed { "to_signed" } else { "to_unsigned" };
            // The functions take 31-bit integers only, and warn of bits that the vector does not hold.
            let whole = to.wrap(code << shift);
            return if whole < 1 << 31 {
                format!("{function}({whole}, {width})")
            } else {
                shifted(format!("{function}({code}, {width})"))
            };
        }
        let name = self.vector(id);
        let converted = |text: String| match (from.signed, to.signed) {
            (true, false) => format!("unsigned({text})"),
            (false, true) => format!("signed({text})"),
            _ => text,
        };
        if from.width() > width {
            // The result wraps: `resize` would keep the sign in place of the low bits.
            return shifted(converted(format!("{name}({} downto 0)", width - 1)));
        }
        let resized = if from.width() == width { name } else { format!("resize({name}, {width})") };
        shifted(converted(resized))
    }

    fn expression(&self, id: NodeId) -> String {
        let node = &self.layout.nodes()[id];
        let (format, width) = (node.format, node.format.width());
        let arg = |index: usize| node.args[index];
        match node.op {
            Op::Input | Op::Constant(_) => unreachable!("a port or a literal"),
            Op::Field { memory, field } => {
                let table = &self.layout.datapath.tables[memory];
                let (word, low) = (format!("{}_{}", table.name, self.stage), table.field_low_bit(field));
                if self.layout.is_flag(id) {
                    return format!("{word}({low})");
                }
                let slice = format!("{word}({} downto {low})", low + width - 1);
                format!("{}({slice})", if format.signed { "signed" } else { "unsigned" })
            }
            Op::Clamp { low, high } => self.clamp(arg(0), low, high, width),
            Op::Add => format!("{} + {}", self.fitted(arg(0), format), self.fitted(arg(1), format)),
            Op::Sub => format!("{} - {}", self.fitted(arg(0), format), self.fitted(arg(1), format)),
            Op::Mul => {
                let [a, b] = [arg(0), arg(1)].map(|id| self.fitted(id, self.format(id)));
                format!("{a} * {b}")
            }
            Op::ShiftLeft => {
                let to = Format { frac_bits: self.format(arg(0)).frac_bits, int_bits: 0, ..format };
                let to = Format { int_bits: width as i32 - to.frac_bits - i32::from(to.signed), ..to };
                format!("shift_left({}, to_integer({}))", self.fitted(arg(0), to), self.name(arg(1)))
            }
            Op::ShiftRight => format!("shift_right({}, to_integer({}))", self.name(arg(0)), self.name(arg(1))),
            Op::Cast => self.cast(id),
            Op::Scale if self.layout.is_flag(id) => self.bit(arg(0)),
            Op::Scale => self.vector(arg(0)),
            Op::NonZero => format!("'1' when {} /= 0 else '0'", self.name(arg(0))),
            Op::Greater => {
                if let Some(decided) = self.layout.decided(arg(0), arg(1)) {
                    return if decided { "'1'".to_owned() } else { "'0'".to_owned() };
                }
                let [a, b] = [arg(0), arg(1)].map(|id| self.fitted(id, self.format(id)));
                format!("'1' when {a} > {b} else '0'")
            }
            Op::Or => format!("{} or {}", self.name(arg(0)), self.name(arg(1))),
            Op::Not => format!("not {}", self.name(arg(0))),
            Op::Select => {
                let is_flag = self.layout.is_flag(id);
                let [a, b] = [arg(1), arg(2)].map(|id| if is_flag { self.bit(id) } else { self.fitted(id, format) });
                format!("{a} when {} = '1' else {b}", self.name(arg(0)))
            }
            Op::ZeroIf => format!("(others => '0') when {} = '1' else {}", self.name(arg(0)), self.name(arg(1))),
        }
    }

    fn cast(&self, id: NodeId) -> String {
        let node = &self.layout.nodes()[id];
        let (from, to, name) = (self.format(node.args[0]), node.format, self.name(node.args[0]));
        if to.frac_bits == from.frac_bits && self.layout.is_flag(id) && !self.layout.is_flag(node.args[0]) {
            return format!("{name}(0)");
        }
        if to.frac_bits >= from.frac_bits {
            return self.fitted(node.args[0], to);
        }
        let low = (from.frac_bits - to.frac_bits) as u32;
        if low >= from.width() {
            // Every bit is dropped: what is left of a number is its sign.
            let bit = if from.signed { format!("{name}({})", from.width() - 1) } else { "'0'".to_owned() };
            return if self.layout.is_flag(id) { bit } else { format!("(others => {bit})") };
        }
        let kept = (from.width() - low).min(to.width());
        if self.layout.is_flag(id) {
            return format!("{name}({low})");
        }
        let own = format!("{name}({} downto {low})", low + kept - 1);
        let own = if kept < to.width() { format!("resize({own}, {})", to.width()) } else { own };
        match (from.signed, to.signed) {
            (true, false) => format!("unsigned({own})"),
            (false, true) => format!("signed({own})"),
            _ => own,
        }
    }

    fn clamp(&self, arg: NodeId, low: i128, high: i128, width: u32) -> String {
        let (from, name) = (self.format(arg), self.name(arg));
        let magnitude = from.width() - u32::from(from.signed);
        // Past a power of two the high bits tell.
        let leading = |power: i128| match power.trailing_zeros() {
            bit if bit + 1 == magnitude => format!("{name}({bit}) = '1'"),
            bit => format!("unsigned({name}({} downto {bit})) /= 0", magnitude - 1),
        };
        let power = clamped_from(high);
        if low < 0 {
            let own = self.fitted(arg, Format { int_bits: width as i32 - 1 - from.frac_bits, ..from });
            let leading = |power: i128| format!("{name}({} downto {})", from.width() - 1, power.trailing_zeros());
            let when = |bound: i128, test: String| format!("{} when {test} else\n        ", number(bound, width, true));
            let below = match low {
                _ if low <= from.min_code() => String::new(),
                _ if (-low).count_ones() == 1 => when(low, format!("{} < -1", leading(-low))),
                _ => when(low, format!("{name} < {}", compared(low, from))),
            };
            let above = match power {
                _ if high >= from.max_code() => String::new(),
                Some(power) => when(high, format!("{} > 0", leading(power))),
                None => when(high, format!("{name} > {}", compared(high, from))),
            };
            return below + &above + &own;
        }
        let mut text = String::new();
        if from.signed && low == 0 {
            text += &format!("(others => '0') when {name}({}) = '1' else\n        ", from.width() - 1);
        } else if low > 0 {
            let (value, than) = (number(low, width, false), compared(low, from));
            text += &format!("{value} when {name} < {than} else\n        ");
        }
        if high < from.max_code() {
            let value = match high {
                _ if high.count_ones() == 1 => format!("({} => '1', others => '0')", high.trailing_zeros()),
                _ => number(high, width, false),
            };
            let test = match power {
                Some(power) => leading(power),
                None => format!("{name} > {}", compared(high, from)),
            };
            text += &format!("{value} when {test} else\n        ");
        }
        let kept = width.min(magnitude);
        let own = if kept == from.width() { name } else { format!("{name}({} downto 0)", kept - 1) };
        let own = if from.signed { format!("unsigned({own})") } else { own };
        text + &if kept < width { format!("resize({own}, {width})") } else { own }
    }
}

/// A code as a vector. The functions of `numeric_std` take integers, which have 32 bits.
fn number(code: i128, width: u32, signed: bool) -> String {
    let kind = if signed { "signed" } else { "unsigned" };
    if i32::try_from(code).is_ok() {
        return format!("to_{kind}({code}, {width})");
    }
    format!("{kind}'(\"{:0width$b}\")", code & ((1 << width) - 1), width = width as usize)
}

/// A code as what a value of a format is compared with.
fn compared(code: i128, format: Format) -> String {
    if i32::try_from(code).is_ok() { code.to_string() } else { number(code, format.width(), format.signed) }
}

fn sign(format: Format) -> &'static str {
    if format.signed { "signed" } else { "unsigned" }
}

fn kind(format: Format) -> String {
    format!("{}({} downto 0)", sign(format), format.width() - 1)
}

/// The value that a signal has before anything is known of it, so that no operation warns of what it is given at the
/// beginning.
fn initial(is_flag: bool) -> &'static str {
    if is_flag { "'0'" } else { "(others => '0')" }
}

/// Ports of these types in the text of an entity.
pub(super) fn declarations(ports: &[Port], types: VhdlPorts) -> Vec<Declaration> {
    let name_width = ports.iter().map(|port| port.name.len()).max().unwrap_or(0);
    let vector = |format: Format| format!("{}({} downto 0)", types.vector(sign(format)), format.width() - 1);
    let declaration = |port: &Port| {
        let kind = port.format.map_or("std_logic".to_owned(), vector);
        let declaration = format!("{:<name_width$} : {:<3} {kind}", port.name, port.role.direction().word());
        Declaration { comment: port.comment(), declaration }
    };
    ports.iter().map(declaration).collect()
}

/// The memories that are read in a stage.
fn memories<'a>(layout: &Layout<'a>, texts: &'a Texts, stage: u32) -> Vec<MemoryText<'a>> {
    let tables = layout.datapath.tables.iter().enumerate();
    let reads = tables.filter_map(|(memory, table)| Some((memory, table, layout.read(memory)?)));
    reads
        .filter(|(_, _, read)| read.stage == stage)
        .map(|(memory, table, read)| {
            let words = table.words();
            let chunk = |index: usize| {
                let low = 32 * index as u32;
                let bits = (table.word_bits() - low).min(32);
                let digits = bits.div_ceil(4) as usize;
                let mask = (BigUint::from(1u8) << bits) - 1u8;
                let row =
                    |(address, word): (usize, &BigUint)| (address, format!("{:0digits$x}", (word >> low) & &mask));
                Chunk {
                    index,
                    element_bits: 4 * digits as u32,
                    bits,
                    high: low + bits - 1,
                    low,
                    rows: words.iter().enumerate().rev().map(row).collect(),
                }
            };
            MemoryText {
                name: table.name,
                constant: table.name.to_ascii_uppercase(),
                bits: table.word_bits(),
                address: match (texts.sets_of(memory), stage) {
                    (1, _) => layout.name(read.address, stage),
                    (_, 0) => format!("{} & {}", Role::IN_SET, layout.name(read.address, stage)),
                    _ => format!("sets({stage}) & {}", layout.name(read.address, stage)),
                },
                depth: table.depth(),
                second: (texts.sets_of(memory) > 1).then_some(1 << table.address_bits),
                registered: read.registers > 0,
                outside: texts.read_port(memory),
                generic: texts.rom_file(table.name).map(|file| file.parameter.clone()),
                write: texts.write_port(memory),
                chunks: (0..table.word_bits().div_ceil(32) as usize).map(chunk).collect(),
                word: read.word,
            }
        })
        .collect()
}

/// An output with what it shows, as bits.
fn as_bits((port, source): (String, String)) -> (String, String) {
    (port, format!("std_logic_vector({source})"))
}

impl Backend for Vhdl {
    fn emit(&self, layout: &Layout, texts: &Texts) -> Result<String, Error> {
        let std_logic = texts.vhdl_ports == VhdlPorts::StdLogic;
        let own = if std_logic { layout.with_inputs_apart() } else { layout.clone() };
        let layout = &own;
        let latency = layout.schedule.latency;
        let mut signals = Vec::new();
        let mut stages = Vec::new();
        let mut inputs = Vec::new();
        if std_logic {
            let writer = Writer { layout, stage: 0 };
            for &id in &layout.datapath.graph.inputs {
                signals.push(Signal { name: writer.name(id), kind: writer.initialised(id) });
                let port = &layout.nodes()[id].name;
                let bits = if layout.is_flag(id) {
                    format!("{port}(0)")
                } else {
                    format!("{}({port})", sign(writer.format(id)))
                };
                inputs.push((writer.name(id), bits));
            }
        }
        for index in 0..latency {
            let writer = Writer { layout, stage: index };
            let mut assignments = Vec::new();
            for id in layout.computed(index) {
                let node = &layout.nodes()[id];
                signals.push(Signal { name: writer.name(id), kind: writer.initialised(id) });
                assignments.push(Assignment {
                    comment: format!("{}: {}", node.format, node.comment),
                    target: writer.name(id),
                    expression: continued(writer.name(id).len() + 7, &writer.expression(id)),
                });
            }
            let mut registers = Vec::new();
            for Register { node, stage } in layout.registers(index) {
                let target = layout.name(node, stage + 1);
                signals.push(Signal { name: target.clone(), kind: writer.initialised(node) });
                registers.push((target, layout.name(node, stage)));
            }
            let memories = memories(layout, texts, index);
            stages.push(Stage { index, heading: layout.heading(index), memories, assignments, registers });
        }
        let text = render(&Core {
            texts,
            ports: declarations(&texts.ports, texts.vhdl_ports),
            inputs,
            latency,
            set_stage: texts.last_set_stage(layout),
            signals,
            stages,
            out_valid: layout.padded_output("out_valid"),
            outputs: if std_logic { layout.shown().into_iter().map(as_bits).collect() } else { layout.shown() },
        })?;
        names::checked(Language::Vhdl, &texts.name, text)
    }
}
