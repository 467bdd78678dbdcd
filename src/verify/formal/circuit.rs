//! The circuit of a core, as Yosys reads it from its text: gates, products, memories and registers.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;

use serde_json::{Map, Value};

use super::aig::{Aig, Literal};
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool;
use crate::synth::yosys::{Yosys, parse_netlist};

/// A bit: a constant or a net.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bit {
    Constant(bool),
    Net(usize),
}

/// A register of one bit, with the clock, what enables it and what zeroes it.
#[derive(Clone, Debug)]
pub(super) struct Register {
    /// The names of its output in the text, with their bits.
    pub(super) names: Vec<String>,
    pub(super) d: Bit,
    pub(super) q: usize,
    pub(super) clock: Bit,
    /// The enable; none for a register that takes its input at every edge.
    pub(super) enable: Option<Bit>,
    /// What zeroes it whatever the enable is.
    pub(super) reset: Option<Bit>,
}

/// A part of the circuit between its inputs and outputs.
#[derive(Clone, Debug)]
pub(super) enum Part {
    And { a: Bit, b: Bit, y: usize },
    Not { a: Bit, y: usize },
    Product { a: Vec<Bit>, b: Vec<Bit>, signed: bool, y: Vec<usize> },
    Read { memory: usize, address: Vec<Bit>, data: Vec<usize> },
    Register(Register),
}

impl Part {
    pub(super) fn reads(&self) -> Vec<Bit> {
        match self {
            Self::And { a, b, .. } => vec![*a, *b],
            Self::Not { a, .. } => vec![*a],
            Self::Product { a, b, .. } => [a.as_slice(), b].concat(),
            Self::Read { address, .. } => address.clone(),
            Self::Register(register) => vec![register.d],
        }
    }

    pub(super) fn drives(&self) -> Vec<usize> {
        match self {
            Self::And { y, .. } | Self::Not { y, .. } => vec![*y],
            Self::Product { y, .. } => y.clone(),
            Self::Read { data, .. } => data.clone(),
            Self::Register(register) => vec![register.q],
        }
    }
}

/// A memory's write port, with an enable for each bit of the word.
#[derive(Clone, Debug)]
pub(super) struct Write {
    pub(super) clock: Bit,
    pub(super) address: Vec<Bit>,
    pub(super) data: Vec<Bit>,
    pub(super) enable: Vec<Bit>,
}

impl Write {
    pub(super) fn bits(&self) -> Vec<Bit> {
        [self.address.as_slice(), &self.data, &self.enable].concat()
    }
}

/// A memory: 2^address bits words, each lowest bit first.
#[derive(Clone, Debug)]
pub(super) struct CircuitMemory {
    pub(super) words: Vec<Vec<bool>>,
    pub(super) writes: Vec<Write>,
}

/// A circuit. Its parts are in such an order that each comes after those that drive it, registers taken as wires.
#[derive(Clone, Debug)]
pub(super) struct Circuit {
    /// The nets of the inputs, lowest bit first.
    pub(super) inputs: BTreeMap<String, Vec<usize>>,
    /// The bits of the outputs, lowest bit first.
    pub(super) outputs: BTreeMap<String, Vec<Bit>>,
    pub(super) parts: Vec<Part>,
    pub(super) memories: Vec<CircuitMemory>,
    /// Nets that stand for the bits that the text leaves undefined, such as a case that never happens: each may be
    /// anything.
    undefined: Vec<usize>,
    pub(super) nets: usize,
}

/// What a memory with a write port shows: for the read's place among the parts and its address.
pub(super) type Word<'a> = dyn Fn(&mut Aig, usize, &[Literal]) -> Vec<Literal> + 'a;

/// Why a circuit is not one that the proof is for.
pub(super) type Unfit = String;

/// From a Verilog text to gates: no pass here removes, adds or merges a register that is not the same as another, and
/// none uses what a register or memory holds when it comes up. A register that Yosys would zero by a data signal gets a
/// gate instead; products stay whole.
fn script(reader: &str, top: &str) -> String {
    format!(
        "{reader} {TEXT}\n\
         hierarchy -check -top {top}\n\
         proc\n\
         flatten\n\
         setattr -unset init w:*\n\
         opt_expr\n\
         opt_merge\n\
         opt_clean\n\
         opt_dff\n\
         opt_clean\n\
         dffunmap -srst-only t:$sdff* i:rst %co1:+[SRST] %d\n\
         memory_collect\n\
         opt_clean\n\
         wreduce t:$mul\n\
         opt_clean\n\
         chtype -set {PRODUCT} t:$mul\n\
         techmap\n\
         opt_expr\n\
         aigmap\n\
         opt_clean\n\
         write_json {GATES}\n"
    )
}

const TEXT: &str = "core.v";
const GATES: &str = "gates.json";
/// A product, under a name that Yosys does not take apart.
const PRODUCT: &str = "brdfgen_product";

impl Circuit {
    /// Reads the module `top` of a Verilog text. The folder `rom` of `directory` is there for the text's files.
    /// Errors: if Yosys cannot be started or does not take the text.
    pub(super) fn read(yosys: &Yosys, directory: &Path, top: &str, text: &[u8]) -> Result<Result<Self, Unfit>, Error> {
        let scratch = tool::scratch()?;
        package::write_file(&scratch.path().join(TEXT), text)?;
        let rom = directory.join("rom");
        for entry in std::fs::read_dir(&rom).into_iter().flatten().flatten() {
            let bytes = std::fs::read(entry.path()).map_err(|error| Error::io("cannot read", &entry.path(), error))?;
            package::write_file(&scratch.path().join("rom").join(entry.file_name()), &bytes)?;
        }
        Self::gates(yosys, scratch.path(), "read_verilog", top)
    }

    /// Reads the module `top` of a netlist in Yosys' own language, whose memories' words are in it.
    /// Errors: as [`Self::read`].
    pub(super) fn read_netlist(yosys: &Yosys, top: &str, netlist: &[u8]) -> Result<Result<Self, Unfit>, Error> {
        let scratch = tool::scratch()?;
        package::write_file(&scratch.path().join(TEXT), netlist)?;
        Self::gates(yosys, scratch.path(), "read_rtlil", top)
    }

    /// The circuit of the text in a directory.
    fn gates(yosys: &Yosys, directory: &Path, reader: &str, top: &str) -> Result<Result<Self, Unfit>, Error> {
        yosys.run(directory, &script(reader, top))?;
        let path = directory.join(GATES);
        let bytes = std::fs::read(&path).map_err(|error| Error::io("cannot read", &path, error))?;
        Ok(Self::of(&mut parse_netlist(&bytes)?["modules"][top]))
    }

    /// The circuit of a module of a netlist.
    fn of(module: &mut Value) -> Result<Self, Unfit> {
        let undefined = name_undefined(module);
        let mut circuit = Self {
            inputs: BTreeMap::new(),
            outputs: BTreeMap::new(),
            parts: Vec::new(),
            memories: Vec::new(),
            undefined,
            nets: 0,
        };
        for (name, port) in object(&module["ports"]) {
            let bits = bits(&port["bits"]).map_err(|why| format!("the port {name}: {why}"))?;
            if port["direction"] == "input" {
                // The rust-hdl kernels' name of it.
                let name = if name == "clock" { "clk" } else { name };
                circuit.inputs.insert(name.to_owned(), nets(&bits)?);
            } else {
                circuit.outputs.insert(name.clone(), bits);
            }
        }
        let mut names: HashMap<usize, Vec<String>> = HashMap::new();
        for (name, net) in object(&module["netnames"]).filter(|(_, net)| net["hide_name"] == 0) {
            for (place, bit) in bits(&net["bits"]).unwrap_or_default().into_iter().enumerate() {
                if let Bit::Net(net) = bit {
                    names.entry(net).or_default().push(format!("{name}[{place}]"));
                }
            }
        }
        let mut parts = Vec::new();
        for (name, cell) in object(&module["cells"]) {
            let kind = cell["type"].as_str().unwrap_or_default();
            if kind == "$scopeinfo" {
                continue;
            }
            let part = circuit.cell(kind, cell, &names).map_err(|why| format!("the cell {name} ({kind}): {why}"))?;
            parts.extend(part);
        }
        circuit.order(parts)?;
        Ok(circuit)
    }

    /// The parts of a cell.
    fn cell(&mut self, kind: &str, cell: &Value, names: &HashMap<usize, Vec<String>>) -> Result<Vec<Part>, Unfit> {
        let port = |name: &str| bits(&cell["connections"][name]);
        let one = |name: &str| match port(name)?.as_slice() {
            [bit] => Ok(*bit),
            _ => Err(format!("its port {name} has not one bit")),
        };
        let net = |name: &str| one(name).and_then(|bit| Ok(nets(&[bit])?[0]));
        let register = |enable: Option<Bit>, reset: Option<Bit>| -> Result<Vec<Part>, Unfit> {
            let q = net("Q")?;
            let names = names.get(&q).cloned().unwrap_or_default();
            Ok(vec![Part::Register(Register { names, d: one("D")?, q, clock: one("C")?, enable, reset })])
        };
        match kind {
            "$_AND_" => Ok(vec![Part::And { a: one("A")?, b: one("B")?, y: net("Y")? }]),
            "$_NOT_" => Ok(vec![Part::Not { a: one("A")?, y: net("Y")? }]),
            "$_DFF_P_" => register(None, None),
            "$_DFFE_PP_" => register(Some(one("E")?), None),
            "$_SDFF_PP0_" => register(None, Some(one("R")?)),
            "$_SDFFE_PP0P_" => register(Some(one("E")?), Some(one("R")?)),
            PRODUCT => {
                let signed = number(cell, "A_SIGNED")? == 1;
                if signed != (number(cell, "B_SIGNED")? == 1) {
                    return Err("one operand is signed, the other is not".to_owned());
                }
                Ok(vec![Part::Product { a: port("A")?, b: port("B")?, signed, y: nets(&port("Y")?)? }])
            }
            "$mem_v2" => self.memory(cell),
            _ => Err("a cell of a type that has no place in a core".to_owned()),
        }
    }

    /// The reads of a memory, which joins the circuit's.
    fn memory(&mut self, cell: &Value) -> Result<Vec<Part>, Unfit> {
        let get = |name: &str| number(cell, name);
        let (size, width, address) = (get("SIZE")?, get("WIDTH")?, get("ABITS")?);
        let (reads, writes) = (get("RD_PORTS")?, get("WR_PORTS")?);
        if size != 1 << address || get("OFFSET")? != 0 {
            return Err("its words do not fill the addresses from 0 on".to_owned());
        }
        let zero = |name: &str| parameter(cell, name).is_ok_and(|digits| digits.bytes().all(|digit| digit == b'0'));
        if !zero("RD_CLK_ENABLE") || !zero("RD_WIDE_CONTINUATION") || !zero("WR_WIDE_CONTINUATION") {
            return Err("a read through a register of its own, or a wide port".to_owned());
        }
        if writes > 1 {
            return Err("more than one write port".to_owned());
        }
        let port = |name: &str, index: usize, width: usize| -> Result<Vec<Bit>, Unfit> {
            let all = bits(&cell["connections"][name])?;
            all.get(index * width..(index + 1) * width)
                .map(<[Bit]>::to_vec)
                .ok_or_else(|| format!("its port {name} has too few bits"))
        };
        // Digits are written highest first.
        let init = parameter(cell, "INIT")?.as_bytes();
        let word = |row: usize| -> Result<Vec<bool>, Unfit> {
            let digit = |bit: usize| match init.iter().rev().nth(row * width + bit) {
                Some(b'0') => Ok(false),
                Some(b'1') => Ok(true),
                _ => Err(format!("the bit {bit} of its word {row} is undefined")),
            };
            (0..width).map(digit).collect()
        };
        if init.len() != size * width {
            return Err("its words are not all given".to_owned());
        }
        let words = (0..size).map(word).collect::<Result<_, _>>()?;
        let writes = (0..writes)
            .map(|index| {
                if parameter(cell, "WR_CLK_ENABLE")? != "1" || parameter(cell, "WR_CLK_POLARITY")? != "1" {
                    return Err("a write without a rising clock".to_owned());
                }
                Ok(Write {
                    clock: port("WR_CLK", index, 1)?[0],
                    address: port("WR_ADDR", index, address)?,
                    data: port("WR_DATA", index, width)?,
                    enable: port("WR_EN", index, width)?,
                })
            })
            .collect::<Result<_, Unfit>>()?;
        let memory = self.memories.len();
        self.memories.push(CircuitMemory { words, writes });
        (0..reads)
            .map(|index| {
                let (address, data) = (port("RD_ADDR", index, address)?, nets(&port("RD_DATA", index, width)?)?);
                Ok(Part::Read { memory, address, data })
            })
            .collect()
    }

    /// Puts the parts in order.
    fn order(&mut self, parts: Vec<Part>) -> Result<(), Unfit> {
        let read: Vec<Bit> = self.outputs.values().flatten().copied().collect();
        let written = self.memories.iter().flat_map(|memory| &memory.writes).flat_map(Write::bits);
        let read: Vec<Bit> = read.into_iter().chain(written).chain(parts.iter().flat_map(Part::reads)).collect();
        let free = || self.inputs.values().flatten().chain(&self.undefined).copied();
        let driven = parts.iter().flat_map(Part::drives).chain(free());
        let of = |bit: &Bit| if let Bit::Net(net) = bit { Some(*net) } else { None };
        self.nets = driven.chain(read.iter().filter_map(of)).max().map_or(0, |net| net + 1);
        let mut driver = vec![None; self.nets];
        for (index, part) in parts.iter().enumerate() {
            for net in part.drives() {
                if driver[net].replace(index).is_some() {
                    return Err("two parts drive the same net".to_owned());
                }
            }
        }
        let mut is_input = vec![false; self.nets];
        for net in self.inputs.values().flatten().chain(&self.undefined).copied() {
            is_input[net] = true;
        }
        if read.iter().filter_map(of).any(|net| !is_input[net] && driver[net].is_none()) {
            return Err("a net that nothing drives".to_owned());
        }
        // Depth first, with a stack of its own: a carry chain through a whole core is deep.
        let (mut begun, mut done) = (vec![false; parts.len()], vec![false; parts.len()]);
        let mut order = Vec::with_capacity(parts.len());
        for first in 0..parts.len() {
            let mut stack = vec![first];
            while let Some(&index) = stack.last() {
                if done[index] {
                    stack.pop();
                    continue;
                }
                begun[index] = true;
                let mut waits = false;
                for bit in parts[index].reads() {
                    let Bit::Net(net) = bit else { continue };
                    let Some(on) = driver[net].filter(|&on| !done[on]) else { continue };
                    // What was begun and is not done waits for this one.
                    if begun[on] {
                        return Err("a loop: what a stage does depends on a later one".to_owned());
                    }
                    stack.push(on);
                    waits = true;
                }
                if !waits {
                    done[index] = true;
                    order.push(index);
                    stack.pop();
                }
            }
        }
        let mut parts: Vec<Option<Part>> = parts.into_iter().map(Some).collect();
        self.parts = order.into_iter().filter_map(|index| parts[index].take()).collect();
        Ok(())
    }

    /// The registers, with their places among the parts.
    pub(super) fn registers(&self) -> impl Iterator<Item = (usize, &Register)> {
        self.parts.iter().enumerate().filter_map(|(index, part)| match part {
            Part::Register(register) => Some((index, register)),
            _ => None,
        })
    }

    /// The circuit with a number at an input, which it does not have any more.
    pub(super) fn with(&self, input: &str, number: u32) -> Self {
        let mut circuit = self.clone();
        let nets = circuit.inputs.remove(input).unwrap_or_default();
        let constant = |(place, y): (usize, usize)| {
            let a = Bit::Constant(number.checked_shr(place as u32).is_some_and(|rest| rest & 1 == 1));
            Part::And { a, b: Bit::Constant(true), y }
        };
        circuit.parts.splice(0..0, nets.into_iter().enumerate().map(constant));
        circuit
    }

    /// Builds the circuit with registers as wires. `input` says what a port's bit is, `cut` what stands for a register,
    /// by its place, instead of its input.
    pub(super) fn build(
        &self,
        aig: &mut Aig,
        input: &dyn Fn(&str, usize) -> Literal,
        word: &Word,
        cut: &dyn Fn(usize) -> Option<Literal>,
    ) -> Wires {
        let mut wires = Wires(vec![Literal::FALSE; self.nets]);
        for (name, nets) in &self.inputs {
            for (place, &net) in nets.iter().enumerate() {
                wires.0[net] = input(name, place);
            }
        }
        for &net in &self.undefined {
            wires.0[net] = aig.input();
        }
        for (index, part) in self.parts.iter().enumerate() {
            match part {
                Part::And { a, b, y } => wires.0[*y] = aig.and(wires.bit(*a), wires.bit(*b)),
                Part::Not { a, y } => wires.0[*y] = !wires.bit(*a),
                Part::Product { a, b, signed, y } => {
                    let product = aig.product(&wires.bits(a), &wires.bits(b), *signed, y.len());
                    wires.set(y, &product);
                }
                Part::Read { memory, address, data } => {
                    let (memory, address) = (&self.memories[*memory], wires.bits(address));
                    let read = match memory.writes.as_slice() {
                        [] => aig.word(&memory.words, &address),
                        _ => word(aig, index, &address),
                    };
                    wires.set(data, &read);
                }
                Part::Register(register) => wires.0[register.q] = cut(index).unwrap_or_else(|| wires.bit(register.d)),
            }
        }
        wires
    }
}

/// Gives each undefined bit that a cell or an output takes a net of its own, and returns these.
fn name_undefined(module: &mut Value) -> Vec<usize> {
    let mut lists: Vec<&mut Value> = Vec::new();
    let Some(module) = module.as_object_mut() else { return Vec::new() };
    for (section, value) in module.iter_mut() {
        let things = value.as_object_mut().into_iter().flat_map(Map::values_mut);
        match section.as_str() {
            "ports" => lists.extend(things.filter_map(|port| port.get_mut("bits"))),
            "cells" => lists.extend(things.flat_map(|cell| {
                cell.get_mut("connections").and_then(Value::as_object_mut).into_iter().flat_map(Map::values_mut)
            })),
            _ => {}
        }
    }
    let all = lists.iter().filter_map(|list| list.as_array()).flatten();
    let first = all.filter_map(Value::as_u64).max().map_or(0, |net| net as usize + 1);
    let mut made = Vec::new();
    for bit in lists.into_iter().filter_map(Value::as_array_mut).flatten().filter(|bit| *bit == "x") {
        *bit = (first + made.len()).into();
        made.push(first + made.len());
    }
    made
}

/// What each net of a circuit is in a graph.
pub(super) struct Wires(Vec<Literal>);

impl Wires {
    pub(super) fn bit(&self, bit: Bit) -> Literal {
        match bit {
            Bit::Constant(value) => value.into(),
            Bit::Net(net) => self.0[net],
        }
    }

    pub(super) fn bits(&self, bits: &[Bit]) -> Vec<Literal> {
        bits.iter().map(|&bit| self.bit(bit)).collect()
    }

    fn set(&mut self, nets: &[usize], values: &[Literal]) {
        for (&net, &value) in nets.iter().zip(values) {
            self.0[net] = value;
        }
    }
}

fn object(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flat_map(Map::iter)
}

fn bits(value: &Value) -> Result<Vec<Bit>, Unfit> {
    let bit = |bit: &Value| match (bit.as_u64(), bit.as_str()) {
        (Some(net), _) => Ok(Bit::Net(net as usize)),
        (_, Some("0")) => Ok(Bit::Constant(false)),
        (_, Some("1")) => Ok(Bit::Constant(true)),
        _ => Err("an undefined bit".to_owned()),
    };
    value.as_array().into_iter().flatten().map(bit).collect()
}

fn nets(bits: &[Bit]) -> Result<Vec<usize>, Unfit> {
    let net = |bit: &Bit| match bit {
        Bit::Net(net) => Ok(*net),
        Bit::Constant(_) => Err("a constant where a net is wanted".to_owned()),
    };
    bits.iter().map(net).collect()
}

/// A parameter, which Yosys writes as binary digits.
fn parameter<'a>(cell: &'a Value, name: &str) -> Result<&'a str, Unfit> {
    cell["parameters"][name].as_str().ok_or_else(|| format!("it has no parameter {name}"))
}

fn number(cell: &Value, name: &str) -> Result<usize, Unfit> {
    usize::from_str_radix(parameter(cell, name)?, 2).map_err(|_| format!("its parameter {name} is no number"))
}
