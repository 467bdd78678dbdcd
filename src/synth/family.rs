//! The families: device, script, how the cells count, how the core is placed.

use std::collections::BTreeMap;

use askama::Template;
use serde::{Deserialize, Serialize};

use super::{CORE, Netlist, Resources};
use crate::core::Design;
use crate::core::Direction;
use crate::emit::package::File;
use crate::platform::tool::{NEXTPNR_ECP5, NEXTPNR_GOWIN, NEXTPNR_ICE40, Tool};

/// A family of FPGAs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// Lattice ECP5: LFE5U-85F, CABGA756, speed grade 6; the core alone is placed, its ports on no pins.
    Ecp5,
    /// Lattice iCE40: UP5K, SG48, which has DSP blocks; the core is placed between two shift registers, as it has too few pins.
    Ice40,
    /// Gowin GW2A: GW2A-18, PG256, C8/I7; placed as on iCE40; nextpnr's delays of its DSP blocks look incomplete, so that the
    /// clock of a core with multipliers may be too high.
    Gowin,
    /// AMD 7 series: cells only, as there is no placement here.
    Xc7,
}

/// What nextpnr reads.
pub(super) const NETLIST: &str = "placed.json";
/// What nextpnr writes.
pub(super) const REPORT: &str = "report.json";
/// The pins of the shell, where they must be given.
const PINS: &str = "pins.cst";
const SHELL: &str = "shell.v";

impl Family {
    /// The device, its package and its speed grade.
    #[must_use]
    pub fn device(self) -> &'static str {
        match self {
            Self::Ecp5 => "LFE5U-85F CABGA756 speed 6",
            Self::Ice40 => "iCE40UP5K SG48",
            Self::Gowin => "GW2A-LV18PG256C8/I7",
            Self::Xc7 => "7 series",
        }
    }

    /// The clock that a placement is asked for unless another is wanted, in MHz.
    #[must_use]
    pub fn target_mhz(self) -> f64 {
        match self {
            Self::Ecp5 | Self::Xc7 => 150.0,
            Self::Ice40 => 25.0,
            Self::Gowin => 100.0,
        }
    }

    /// The programs that place a core; `None` where there is none, so that only cells are counted.
    #[must_use]
    pub fn nextpnr(self) -> Option<&'static [Tool]> {
        match self {
            Self::Ecp5 => Some(&NEXTPNR_ECP5),
            Self::Ice40 => Some(&NEXTPNR_ICE40),
            Self::Gowin => Some(&NEXTPNR_GOWIN),
            Self::Xc7 => None,
        }
    }

    /// How a core of this family goes through the programs.
    pub(super) fn flow(self, design: &Design, pack: bool) -> Flow {
        let name = &design.spec.name;
        let file = |path: &str, bytes: String| File { path: path.to_owned(), bytes: bytes.into_bytes() };
        let mut files = Vec::new();
        let shell = matches!(self, Self::Ice40 | Self::Gowin).then(|| format!("{name}_shell"));
        if shell.is_some() {
            files.push(file(SHELL, shell_text(design)));
        }
        if self == Self::Gowin {
            let pins = [("clk", "H11"), ("si", "T10"), ("so", "L16")];
            files.push(file(PINS, pins.map(|(port, pin)| format!("IO_LOC \"{port}\" {pin};\n")).concat()));
        }
        Flow { family: self, files, shell, pack: pack && self == Self::Ecp5 }
    }

    /// Counts the cells.
    pub(super) fn resources(self, cells: BTreeMap<String, u32>) -> Resources {
        let count = |wanted: &dyn Fn(&str) -> u32| cells.iter().map(|(kind, count)| count * wanted(kind)).sum::<u32>();
        let one = |is: bool| u32::from(is);
        let (lut, carry, used_up, ff, dsp, bram) = match self {
            Self::Ecp5 => (
                count(&|kind| one(kind == "LUT4")),
                count(&|kind| one(kind == "CCU2C")),
                // A memory of 16 words of 4 bits takes three slices of two tables.
                count(&|kind| if kind == "CCU2C" { 2 } else { 6 * one(kind == "TRELLIS_DPR16X4") }),
                count(&|kind| one(kind == "TRELLIS_FF")),
                count(&|kind| one(kind == "MULT18X18D")),
                count(&|kind| one(matches!(kind, "DP16KD" | "PDPW16KD"))),
            ),
            Self::Ice40 => (
                count(&|kind| one(kind == "SB_LUT4")),
                count(&|kind| one(kind == "SB_CARRY")),
                0,
                count(&|kind| one(kind.starts_with("SB_DFF"))),
                count(&|kind| one(kind == "SB_MAC16")),
                count(&|kind| one(kind.starts_with("SB_RAM40_4K"))),
            ),
            Self::Gowin => (
                count(&|kind| one(matches!(kind, "LUT1" | "LUT2" | "LUT3" | "LUT4"))),
                count(&|kind| one(kind == "ALU")),
                // A memory of 16 words of 4 bits takes four tables.
                count(&|kind| one(kind == "ALU") + 4 * one(kind.starts_with("RAM16S"))),
                count(&|kind| one(kind.starts_with("DFF"))),
                // A product of 36 by 36 bits takes four blocks of 18 by 18.
                count(&|kind| if kind == "MULT36X36" { 4 } else { one(kind.starts_with("MULT")) }),
                count(&|kind| {
                    one(["SP", "DP", "pROM"].iter().any(|start| kind.starts_with(start)) || kind.starts_with("SDP"))
                }),
            ),
            Self::Xc7 => (
                count(&|kind| {
                    one(matches!(kind, "LUT1" | "LUT2" | "LUT3" | "LUT4" | "LUT5" | "LUT6") || kind.starts_with("SRL"))
                }),
                count(&|kind| one(kind == "CARRY4")),
                0,
                count(&|kind| one(matches!(kind, "FDRE" | "FDSE" | "FDCE" | "FDPE"))),
                count(&|kind| one(kind == "DSP48E1")),
                count(&|kind| if kind == "RAMB36E1" { 2 } else { one(kind == "RAMB18E1") }),
            ),
        };
        Resources { lut, carry, lut_total: lut + used_up, ff, dsp, bram, cells }
    }
}

/// A core's way through the programs, in a family.
pub(super) struct Flow {
    family: Family,
    /// The files besides the core's.
    pub(super) files: Vec<File>,
    /// The module around the core that is placed in its stead, where the core has too many ports.
    pub(super) shell: Option<String>,
    /// Whether registers are moved into the blocks.
    pub(super) pack: bool,
}

impl Flow {
    /// The script that makes a netlist of the core of this name, a command a line.
    pub(super) fn script(&self, core: &str, netlist: Netlist) -> String {
        let (read, top, pads) = match (&self.shell, netlist) {
            (Some(shell), Netlist::Placed) => (format!("{CORE} {SHELL}"), shell.as_str(), true),
            _ => (CORE.to_owned(), core, false),
        };
        let synth = match (self.family, pads) {
            (Family::Ecp5, _) => "synth_ecp5",
            (Family::Ice40, _) => "synth_ice40 -device u -dsp -abc9",
            (Family::Gowin, true) => "synth_gowin -family gw2a",
            (Family::Gowin, false) => "synth_gowin -family gw2a -noiopads",
            (Family::Xc7, _) => "synth_xilinx -family xc7 -flatten -noiopad -noclkbuf",
        };
        let synth = if self.pack {
            // Yosys turns what zeroes a register into its reset, bit by bit; such a register fits into no multiplier.
            format!(
                "{synth} -top {top} -run begin:map_ffs\n\
                 dffunmap -srst-only t:MULT18X18D %ci2 t:$_SDFF* %i\n\
                 {synth} -top {top} -run map_ffs:"
            )
        } else {
            format!("{synth} -top {top}")
        };
        format!("read_verilog {read}\n{synth}\ndelete t:$scopeinfo\nwrite_json {}\n", self.file(netlist))
    }

    /// The name of a netlist's file.
    pub(super) fn file(&self, netlist: Netlist) -> &'static str {
        match (&self.shell, netlist) {
            (Some(_), Netlist::Core) => "core.json",
            _ => NETLIST,
        }
    }

    /// What nextpnr is given.
    pub(super) fn placement(&self, target_mhz: f64, seed: u32) -> Vec<String> {
        let device: Vec<&str> = match self.family {
            // A higher weight for timing: the default places a core whose registers are inside the blocks 10 % slower, the others alike.
            Family::Ecp5 => {
                let device = ["--85k", "--package", "CABGA756", "--speed", "6"];
                [device.as_slice(), &["--out-of-context", "--placer-heap-timingweight", "30"]].concat()
            }
            Family::Ice40 => vec!["--up5k", "--package", "sg48", "--pcf-allow-unconstrained"],
            Family::Gowin => {
                vec!["--device", "GW2A-LV18PG256C8/I7", "--vopt", "family=GW2A-18", "--vopt", "cst=pins.cst"]
            }
            Family::Xc7 => Vec::new(),
        };
        let common = ["--json", NETLIST, "--report", REPORT, "--timing-allow-fail"];
        let mut arguments: Vec<String> = device.iter().chain(&common).map(|&word| word.to_owned()).collect();
        arguments.extend(["--seed".to_owned(), seed.to_string(), "--freq".to_owned(), target_mhz.to_string()]);
        arguments
    }
}

/// A port of the core and the bits of the shell's chain that it is joined to.
struct ShellPort {
    name: String,
    chain: &'static str,
    high: u32,
    low: u32,
}

#[derive(Template)]
#[template(path = "synth/shell.v", escape = "none")]
struct Shell<'a> {
    name: &'a str,
    inputs_width: u32,
    outputs_width: u32,
    ports: Vec<ShellPort>,
}

/// The module around a core that feeds it from one pin and shows its outputs on another.
fn shell_text(design: &Design) -> String {
    let (mut inputs_width, mut outputs_width) = (0, 0);
    let mut ports = Vec::new();
    for port in design.ports().into_iter().filter(|port| port.name != "clk") {
        let bits = port.format.map_or(1, |format| format.width());
        let (chain, width) = match port.direction {
            Direction::In => ("in_chain", &mut inputs_width),
            Direction::Out => ("outputs", &mut outputs_width),
        };
        ports.push(ShellPort { name: port.name, chain, high: *width + bits - 1, low: *width });
        *width += bits;
    }
    let shell = Shell { name: &design.spec.name, inputs_width, outputs_width, ports };
    shell.render().expect("a template without conditions")
}
