//! A core's way through the programs: Yosys' script, what is around the core that is placed, nextpnr's arguments.

use askama::Template;

use super::{CORE, Netlist, Options};
use crate::core::{Design, Direction, Role};
use crate::emit::package::{File, Part};
use crate::target::{Family, Pack};

/// What nextpnr reads.
pub(super) const NETLIST: &str = "placed.json";
/// What nextpnr writes.
pub(super) const REPORT: &str = "report.json";
const SHELL: &str = "shell.v";

/// A core's way through the programs, in a family.
pub(super) struct Flow {
    family: Family,
    /// The files besides the core's.
    pub(super) files: Vec<File>,
    /// The module around the core that is placed in its stead, where the core has too many ports.
    pub(super) shell: Option<String>,
    /// How registers are moved into the blocks, where they are.
    pub(super) pack: Option<&'static Pack>,
}

impl Flow {
    /// How a core goes through the programs.
    pub(super) fn new(design: &Design, options: &Options) -> Self {
        let family = options.family;
        let file = |path: &str, text: &str| File { path: path.to_owned(), bytes: text.as_bytes().to_vec() };
        let mut flow = Self { family, files: Vec::new(), shell: None, pack: None };
        let description = family.description();
        if let Some(placement) = &description.placement {
            if placement.shell {
                flow.shell = Some(format!("{}_shell", Part::whole(design).name(design)));
                flow.files.push(file(SHELL, &shell_text(design)));
            }
            flow.files.extend(placement.files.iter().map(|(path, text)| file(path, text)));
        }
        flow.pack = description.pack.as_ref().filter(|_| options.pack);
        flow
    }

    /// The script that makes a netlist of the core of this name, a command a line.
    pub(super) fn script(&self, core: &str, netlist: Netlist) -> String {
        let (read, top, padless) = match (&self.shell, netlist) {
            (Some(shell), Netlist::Placed) => (format!("{CORE} {SHELL}"), shell.as_str(), ""),
            _ => (CORE.to_owned(), core, self.family.padless),
        };
        let mut synth = format!("{}{padless} -top {top}", self.family.yosys);
        if let Some(Pack { before_ffs, .. }) = self.pack {
            synth = format!("{synth} -run begin:map_ffs\n{before_ffs}\n{synth} -run map_ffs:");
        }
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
        let device = self.family.placement.as_ref().map_or(&[][..], |placement| placement.arguments);
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
    for port in design.whole_ports().into_iter().filter(|port| port.role != Role::Clock) {
        let bits = port.format.map_or(1, |format| format.width());
        let (chain, width) = match port.role.direction() {
            Direction::In => ("in_chain", &mut inputs_width),
            Direction::Out => ("outputs", &mut outputs_width),
        };
        ports.push(ShellPort { name: port.name, chain, high: *width + bits - 1, low: *width });
        *width += bits;
    }
    let shell = Shell { name: &Part::whole(design).name(design), inputs_width, outputs_width, ports };
    shell.render().expect("a template without conditions")
}
