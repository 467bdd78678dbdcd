//! Moves the registers behind the multiplexers of a memory that takes several block RAMs in front of them.
//!
//! Yosys puts a deep memory together of block RAMs and multiplexers, so that the second register of a word lies behind
//! these and not where a block RAM has one inside. What such a register holds is a function of the RAMs' outputs and of
//! a few other bits, the high bits of the address: the same function of all of these, each through a register, is the
//! same in every clock. So is it in the first, if the function of zeros is 0, with which all registers come up. The
//! registers behind the RAMs are then [packed](super::pack) as any.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Map, Value, json};

use super::pack::{Bits, Control, bit, control};

/// Cells without a register, with their outputs and inputs.
const LOGIC: &[(&str, &str, &[&str])] = &[
    ("LUT4", "Z", &["A", "B", "C", "D"]),
    ("PFUMX", "Z", &["BLUT", "ALUT", "C0"]),
    ("L6MUX21", "Z", &["D0", "D1", "SD"]),
];
/// The inputs of [`LOGIC`] that come straight from other such cells.
const CHOSEN: &[&str] = &["BLUT", "ALUT", "D0", "D1"];
/// The most other bits that get a register for a word's bit; words' bits share them.
const MOST_OTHERS: usize = 64;

fn logic(cell: &Value) -> Option<(&'static str, &'static [&'static str])> {
    let kind = cell["type"].as_str()?;
    LOGIC.iter().find(|(known, ..)| *known == kind).map(|&(_, output, inputs)| (output, inputs))
}

/// A netlist, with who reads and who makes what.
struct Netlist<'c> {
    cells: &'c Map<String, Value>,
    bits: Bits,
    /// The outputs of block RAMs.
    words: &'c BTreeSet<u64>,
    /// The cells without a register, by their outputs.
    makers: BTreeMap<u64, String>,
}

impl<'c> Netlist<'c> {
    fn of(cells: &'c Map<String, Value>, outputs: &[u64], words: &'c BTreeSet<u64>) -> Self {
        let makers = cells.iter().filter_map(|(name, cell)| Some((bit(cell, logic(cell)?.0).as_u64()?, name.clone())));
        Self { cells, bits: Bits::of(cells, outputs), words, makers: makers.collect() }
    }
}

/// The registers that bits have got, by the bits: what clocks each, and its output.
type Delayed = BTreeMap<u64, Vec<(Control, u64)>>;

/// What lies between bits of block RAMs and the registers that hold functions of them.
struct Cone {
    words: BTreeSet<u64>,
    others: BTreeSet<u64>,
    logic: BTreeSet<String>,
    registers: BTreeSet<String>,
}

impl Cone {
    /// All that reads a bit of a block RAM, up to registers; `None` if not all of it is logic and registers alike.
    fn of(netlist: &Netlist, first: u64) -> Option<Self> {
        let Netlist { cells, bits, words, makers } = netlist;
        let mut cone = Self {
            words: BTreeSet::from([first]),
            others: BTreeSet::new(),
            logic: BTreeSet::new(),
            registers: BTreeSet::new(),
        };
        let mut inside = BTreeSet::new();
        let mut nets = vec![first];
        while let Some(net) = nets.pop() {
            if bits.outputs.contains(&net) {
                return None;
            }
            let mut met: Vec<&String> = Vec::new();
            for (name, port) in bits.readers.get(&net)? {
                if port == "DI" && control(&cells[name]).is_some() {
                    cone.registers.insert(name.clone());
                } else {
                    met.push(name);
                }
            }
            while let Some(name) = met.pop() {
                let cell = &cells[name];
                let (output, inputs) = logic(cell)?;
                if !cone.logic.insert(name.clone()) {
                    continue;
                }
                let made = bit(cell, output).as_u64()?;
                inside.insert(made);
                nets.push(made);
                for (port, net) in inputs.iter().filter_map(|port| Some((port, bit(cell, port).as_u64()?))) {
                    if words.contains(&net) && cone.words.insert(net) {
                        nets.push(net);
                    }
                    cone.others.insert(net);
                    // A multiplexer is one with the cells that make what it chooses from.
                    met.extend(makers.get(&net).filter(|_| CHOSEN.contains(port)));
                }
            }
        }
        cone.others.retain(|net| !inside.contains(net) && !cone.words.contains(net));
        cone.is_movable(cells).then_some(cone)
    }

    fn is_movable(&self, cells: &Map<String, Value>) -> bool {
        let mut controls = self.registers.iter().map(|name| control(&cells[name]));
        let first = controls.next();
        let held: BTreeSet<Option<u64>> = self.registers.iter().map(|name| bit(&cells[name], "DI").as_u64()).collect();
        first.is_some_and(|first| controls.all(|other| other == first))
            && held.len() == self.registers.len()
            && !self.logic.is_empty()
            && self.others.len() <= MOST_OTHERS
            && self.is_zero_of_zeros(cells)
    }

    /// Whether all that the registers hold is 0 where all that goes in is.
    fn is_zero_of_zeros(&self, cells: &Map<String, Value>) -> bool {
        let mut known: BTreeMap<u64, bool> = self.words.iter().chain(&self.others).map(|&net| (net, false)).collect();
        let mut left: Vec<&Value> = self.logic.iter().map(|name| &cells[name]).collect();
        while !left.is_empty() {
            let before = left.len();
            left.retain(|cell| {
                let Some((output, inputs)) = logic(cell) else { return true };
                let value = |port: &&str| match bit(cell, port) {
                    Value::String(constant) => Some(constant == "1"),
                    net => known.get(&net.as_u64()?).copied(),
                };
                let Some(values) = inputs.iter().map(value).collect::<Option<Vec<bool>>>() else { return true };
                let made = match cell["type"].as_str() {
                    Some("LUT4") => {
                        let index: usize =
                            values.iter().enumerate().map(|(place, &value)| usize::from(value) << place).sum();
                        let table = cell["parameters"]["INIT"].as_str().unwrap_or_default().as_bytes();
                        table.len() == 16 && table[15 - index] == b'1'
                    }
                    _ if values[2] => values[1],
                    _ => values[0],
                };
                if let Some(net) = bit(cell, output).as_u64() {
                    known.insert(net, made);
                }
                false
            });
            if left.len() == before {
                return false;
            }
        }
        self.registers.iter().all(|name| {
            let held = bit(&cells[name], "DI").as_u64();
            held.and_then(|net| known.get(&net)) == Some(&false)
        })
    }

    /// Moves the registers; `delayed` are the bits that have got one, with what clocks it.
    fn retime(self, cells: &mut Map<String, Value>, next: &mut u64, delayed: &mut Delayed) {
        let Some(like) = self.registers.first().map(|name| cells[name].clone()) else { return };
        let Some(clocked) = control(&like) else { return };
        let mut moved: BTreeMap<u64, u64> = BTreeMap::new();
        for name in &self.registers {
            let [held, shown] = ["DI", "Q"].map(|port| bit(&cells[name], port).as_u64());
            let (Some(held), Some(shown)) = (held, shown) else { continue };
            // What the logic makes is now what the register showed; one right behind a RAM stays.
            moved.insert(held, shown);
            if !self.words.contains(&held) {
                cells.shift_remove(name);
            }
        }
        for &net in self.words.iter().chain(&self.others) {
            if moved.contains_key(&net) {
                continue;
            }
            if let Some((_, there)) = delayed.get(&net).and_then(|all| all.iter().find(|(by, _)| *by == clocked)) {
                moved.insert(net, *there);
                continue;
            }
            let mut register = like.clone();
            register["connections"]["DI"] = json!([net]);
            register["connections"]["Q"] = json!([*next]);
            cells.insert(format!("$retimed${next}"), register);
            moved.insert(net, *next);
            delayed.entry(net).or_default().push((clocked.clone(), *next));
            *next += 1;
        }
        for name in &self.logic {
            let Some((output, inputs)) = logic(&cells[name]) else { continue };
            for port in inputs.iter().chain([&output]) {
                if let Some(new) = bit(&cells[name], port).as_u64().and_then(|net| moved.get(&net)) {
                    cells[name]["connections"][*port] = json!([new]);
                }
            }
        }
    }
}

/// Moves what registers there are behind the multiplexers of block RAMs.
pub(super) fn retime(cells: &mut Map<String, Value>, outputs: &[u64]) {
    let outputs_of = |cell: &Value| -> Vec<u64> {
        let ports = ["A", "B"].into_iter().flat_map(|port| (0..18).map(move |index| format!("DO{port}{index}")));
        ports.filter_map(|port| bit(cell, &port).as_u64()).collect()
    };
    let words: BTreeSet<u64> = cells.values().filter(|cell| cell["type"] == "DP16KD").flat_map(outputs_of).collect();
    let nets = |cell: &Value| -> u64 {
        let nets = cell["connections"].as_object().into_iter().flat_map(Map::values);
        nets.flat_map(|nets| nets.as_array().into_iter().flatten()).filter_map(Value::as_u64).max().unwrap_or_default()
    };
    let mut next =
        cells.values().map(nets).max().unwrap_or_default().max(outputs.iter().copied().max().unwrap_or_default()) + 1;
    let mut delayed = Delayed::new();
    let mut left = words.clone();
    loop {
        // Who reads what is another matter only once registers have moved.
        let netlist = Netlist::of(cells, outputs, &words);
        let next_cone = std::iter::from_fn(|| left.pop_first()).find_map(|word| Cone::of(&netlist, word));
        let Some(cone) = next_cone else { return };
        left.retain(|word| !cone.words.contains(word));
        cone.retime(cells, &mut next, &mut delayed);
    }
}
