//! Moves registers into the DSP blocks and block RAMs of an ECP5 netlist, which Yosys leaves outside.
//!
//! A register right in front of both operands of a `MULT18X18D`, right behind its product, or right behind the word of
//! a block RAM, is what the block has inside; there it costs no flip-flop and no way through the fabric. A register is
//! moved only if
//! - it has the same clock and the same clock enable as the block's other registers, rising edge, no set or reset, and
//!   comes up 0, and
//! - for an operand: every bit of both operands is such a register or a constant, with a 1 in one operand at most; a
//!   register that others read as well stays for them,
//! - for an output: every bit of it that is read is read by that register alone.
//!
//! Registers behind the multiplexers of a memory of several block RAMs are [moved](retime()) in front of these first.
//!
//! So each bit is seen through one register before and after, and the netlist does what it did. Tests simulate the
//! result.

use std::collections::{HashMap, HashSet};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use super::retime::retime;
use crate::platform::error::Error;

/// Counts the changes to what this makes, as results of it are kept.
pub const REVISION: u32 = 3;

/// What was moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Packed {
    /// Multipliers that hold the registers of their operands.
    pub operands: u32,
    /// Multipliers that hold the register of their product.
    pub products: u32,
    /// Block RAM ports that hold a second register of their word.
    pub words: u32,
}

/// Moves registers into the blocks of a module of a `write_json` netlist.
///
/// # Errors
/// A netlist without the module.
pub fn pack(netlist: &mut Value, module: &str) -> Result<Packed, Error> {
    let module = &mut netlist["modules"][module];
    let outputs: Vec<u64> = module["ports"]
        .as_object()
        .into_iter()
        .flat_map(Map::values)
        .filter(|port| port["direction"] != "input")
        .flat_map(|port| port["bits"].as_array().into_iter().flatten().filter_map(Value::as_u64))
        .collect();
    let cells = module["cells"].as_object_mut().ok_or_else(|| Error::ToolFailed {
        tool: "yosys".to_owned(),
        what: "its netlist has no cells".to_owned(),
        output: String::new(),
    })?;
    let mut packed = Packed::default();
    let names = |kind: &str, cells: &Map<String, Value>| -> Vec<String> {
        cells.iter().filter(|(_, cell)| cell["type"] == kind).map(|(name, _)| name.clone()).collect()
    };
    retime(cells, &outputs);
    // The RAMs first: a register between a RAM and a multiplier is worth more to the RAM, whose word takes 5.6 ns
    // without.
    for name in names("DP16KD", cells) {
        let width = |port: &str| cells[&name]["parameters"][format!("DATA_WIDTH_{port}")].as_str().and_then(number);
        if [width("A"), width("B")].contains(&Some(36)) {
            packed.words += u32::from(Bits::of(cells, &outputs).wide_word(cells, &name));
        } else {
            for port in ["A", "B"] {
                packed.words += u32::from(Bits::of(cells, &outputs).word(cells, &name, port));
            }
        }
    }
    let multipliers = names("MULT18X18D", cells);
    for name in &multipliers {
        packed.operands += u32::from(Bits::of(cells, &outputs).operands(cells, name));
    }
    for name in &multipliers {
        packed.products += u32::from(Bits::of(cells, &outputs).product(cells, name));
    }
    Ok(packed)
}

/// The clock and the clock enable of a register: nets, or a constant for the enable.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Control {
    clock: Value,
    enable: Value,
}

/// Who drives and who reads each net.
pub(super) struct Bits {
    /// The register whose output a net is.
    registers: HashMap<u64, String>,
    /// Reading ports of cells, by net.
    pub(super) readers: HashMap<u64, Vec<(String, String)>>,
    pub(super) outputs: HashSet<u64>,
}

/// The bits of a port of one bit, or of none.
pub(super) fn bit(cell: &Value, port: &str) -> Value {
    cell["connections"][port][0].clone()
}

fn is_zero(value: &Value) -> bool {
    value == "0"
}

/// A parameter that Yosys writes as binary digits.
fn number(digits: &str) -> Option<u32> {
    u32::from_str_radix(digits, 2).ok()
}

/// What clocks a register, if it is one that a block could hold.
pub(super) fn control(cell: &Value) -> Option<Control> {
    let parameter = |name: &str| cell["parameters"][name].as_str().unwrap_or_default();
    let plain = cell["type"] == "TRELLIS_FF"
        && parameter("CLKMUX") == "CLK"
        && parameter("REGSET") == "RESET"
        && is_zero(&bit(cell, "LSR"))
        && parameter("LSRMUX") == "LSR";
    let enable = match parameter("CEMUX") {
        "1" => json!("1"),
        "CE" => bit(cell, "CE"),
        _ => return None,
    };
    plain.then(|| Control { clock: bit(cell, "CLK"), enable })
}

impl Bits {
    pub(super) fn of(cells: &Map<String, Value>, outputs: &[u64]) -> Self {
        let mut bits =
            Self { registers: HashMap::new(), readers: HashMap::new(), outputs: outputs.iter().copied().collect() };
        for (name, cell) in cells {
            let Some(connections) = cell["connections"].as_object() else { continue };
            for (port, nets) in connections {
                let written = cell["port_directions"][port] == "output";
                for net in nets.as_array().into_iter().flatten().filter_map(Value::as_u64) {
                    if !written {
                        bits.readers.entry(net).or_default().push((name.clone(), port.clone()));
                    } else if port == "Q" && control(cell).is_some() {
                        bits.registers.insert(net, name.clone());
                    }
                }
            }
        }
        bits
    }

    /// The registers that alone read the outputs `ports` of a block, each with its port; `None` if others read them or
    /// they differ in their control. Outputs that nobody reads are left out.
    fn behind(
        &self,
        cells: &Map<String, Value>,
        block: &str,
        ports: &[String],
    ) -> Option<(Control, Vec<(String, String)>)> {
        let mut found: Option<Control> = None;
        let mut registers = Vec::new();
        for port in ports {
            let Some(net) = bit(&cells[block], port).as_u64() else { continue };
            if self.outputs.contains(&net) {
                return None;
            }
            let readers = self.readers.get(&net).map(Vec::as_slice).unwrap_or_default();
            let register = match readers {
                [] => continue,
                [(register, input)] if input == "DI" => register,
                _ => return None,
            };
            let control = control(&cells[register])?;
            if found.as_ref().is_some_and(|known| *known != control) {
                return None;
            }
            found = Some(control);
            registers.push((port.clone(), register.clone()));
        }
        found.map(|control| (control, registers))
    }

    /// Puts the outputs of registers in the place of a block's, and takes the registers away.
    fn replace(cells: &mut Map<String, Value>, block: &str, registers: Vec<(String, String)>) {
        for (port, register) in registers {
            let net = bit(&cells[&register], "Q");
            cells[block]["connections"][port] = json!([net]);
            cells.shift_remove(&register);
        }
    }

    /// A second register of the word of a port, `A` or `B`, of a block RAM.
    fn word(&self, cells: &mut Map<String, Value>, name: &str, port: &str) -> bool {
        self.register_word(cells, name, port, &[port])
    }

    /// A second register of the word of a block RAM with 36 bits: the outputs of both ports belong to the reading port
    /// B.
    fn wide_word(&self, cells: &mut Map<String, Value>, name: &str) -> bool {
        self.register_word(cells, name, "B", &["A", "B"])
    }

    /// A second register of the word of the port `reader` of a block RAM, whose bits are the outputs of `ports`.
    fn register_word(&self, cells: &mut Map<String, Value>, name: &str, reader: &str, ports: &[&str]) -> bool {
        let cell = &cells[name];
        let parameter = |name: String| cell["parameters"][name].as_str().unwrap_or_default();
        if parameter(format!("CLK{reader}MUX")) != format!("CLK{reader}")
            || ports.iter().any(|port| parameter(format!("REGMODE_{port}")) != "NOREG")
            || ports.iter().any(|port| !is_zero(&bit(cell, &format!("RST{port}"))))
        {
            return false;
        }
        let outputs: Vec<String> =
            ports.iter().flat_map(|port| (0..18).map(move |index| format!("DO{port}{index}"))).collect();
        let Some((control, registers)) = self.behind(cells, name, &outputs) else { return false };
        // The same enable for both registers, so that it does not matter whether the one holds the other as well.
        let own = Control { clock: bit(cell, &format!("CLK{reader}")), enable: bit(cell, &format!("CE{reader}")) };
        if control != own {
            return false;
        }
        for port in ports {
            cells[name]["parameters"][format!("REGMODE_{port}")] = json!("OUTREG");
            cells[name]["connections"][format!("OCE{port}")] = json!([control.enable]);
        }
        Self::replace(cells, name, registers);
        true
    }

    /// The registers of both operands of a multiplier.
    fn operands(&self, cells: &mut Map<String, Value>, name: &str) -> bool {
        let mut found: Option<Control> = None;
        let mut moved = Vec::new();
        let mut ones = [false; 2];
        for port in ["A", "B"].into_iter().flat_map(|port| (0..18).map(move |index| format!("{port}{index}"))) {
            let value = bit(&cells[name], &port);
            if is_zero(&value) {
                continue;
            }
            if value == "1" {
                ones[usize::from(port.starts_with('B'))] = true;
                continue;
            }
            let register = value.as_u64().and_then(|net| self.registers.get(&net));
            let Some((register, control)) = register.and_then(|name| Some((name, control(&cells[name])?))) else {
                return false;
            };
            if found.as_ref().is_some_and(|known| *known != control) {
                return false;
            }
            found = Some(control);
            moved.push((port, register.clone()));
        }
        let constant = |port: &str| bit(&cells[name], port).is_string();
        // A register that comes up 0 shows a 1 only after the first clock: until then the other operand must be 0, so
        // must be the product.
        if ones == [true; 2] {
            return false;
        }
        let (Some(control), true) = (found, ["SIGNEDA", "SIGNEDB"].iter().all(|port| constant(port))) else {
            return false;
        };
        if !join(&mut cells[name], &control, &["INPUTA", "INPUTB"]) {
            return false;
        }
        let mut left: HashMap<String, usize> = HashMap::new();
        for (port, register) in moved {
            let [input, output] = ["DI", "Q"].map(|port| bit(&cells[&register], port));
            cells[name]["connections"][port] = json!([input]);
            let net = output.as_u64().unwrap_or_default();
            let readers = self.readers.get(&net).map_or(0, Vec::len) + usize::from(self.outputs.contains(&net));
            let left = left.entry(register.clone()).or_insert(readers);
            *left -= 1;
            if *left == 0 {
                cells.shift_remove(&register);
            }
        }
        true
    }

    /// The register of the product of a multiplier.
    fn product(&self, cells: &mut Map<String, Value>, name: &str) -> bool {
        let outputs: Vec<String> = (0..36).map(|index| format!("P{index}")).collect();
        let Some((control, registers)) = self.behind(cells, name, &outputs) else { return false };
        if !join(&mut cells[name], &control, &["OUTPUT"]) {
            return false;
        }
        Self::replace(cells, name, registers);
        true
    }
}

/// Turns registers of a multiplier on; `false` if another of its registers has another clock or enable.
fn join(cell: &mut Value, control: &Control, registers: &[&str]) -> bool {
    for (port, value) in [("CLK0", &control.clock), ("CE0", &control.enable)] {
        let there = bit(cell, port);
        if !there.is_null() && there != *value {
            return false;
        }
    }
    for (port, value) in [("CLK0", &control.clock), ("CE0", &control.enable), ("RST0", &json!("0"))] {
        cell["connections"][port] = json!([value]);
        cell["port_directions"][port] = json!("input");
    }
    for register in registers {
        for (suffix, value) in [("CLK", "CLK0"), ("CE", "CE0"), ("RST", "RST0")] {
            cell["parameters"][format!("REG_{register}_{suffix}")] = json!(value);
        }
    }
    true
}
