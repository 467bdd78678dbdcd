//! nextpnr: placing, routing, and what its report says.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::flow::{NETLIST, REPORT};
use crate::platform::error::Error;
use crate::platform::tool::Tool;

/// The slowest path between two registers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Where it begins: the type of the cell, or its name where nextpnr made it.
    pub from: String,
    /// Cells on the way.
    pub through: u32,
    /// Where it ends, in the same way.
    pub to: String,
    /// What the cells take, in ns, with the register's way out and the set-up time.
    pub logic_ns: f64,
    /// What the wires take, in ns.
    pub routing_ns: f64,
}

impl std::fmt::Display for Limit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let through = if self.through == 1 { "cell" } else { "cells" };
        write!(
            f,
            "{} to {} through {} {through}: {:.1} ns in cells, {:.1} ns in wires",
            self.from, self.to, self.through, self.logic_ns, self.routing_ns
        )
    }
}

/// A core placed with one seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Placed {
    /// The clock in MHz and what limits it; `None` if no path lies between two registers.
    pub clock: Option<(f64, Limit)>,
}

/// A nextpnr.
#[derive(Clone, Debug)]
pub(super) struct Nextpnr {
    tool: Tool,
    /// Its version, as it prints it.
    pub(super) version: String,
}

/// What was found, by the first candidate's name; programs do not change while this one runs.
static FOUND: Mutex<BTreeMap<&'static str, Nextpnr>> = Mutex::new(BTreeMap::new());

impl Nextpnr {
    /// The first of these that is installed. Errors: if there is none.
    pub(super) fn find(tools: &'static [Tool]) -> Result<Self, Error> {
        let mut found = FOUND.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let first = tools[0].program;
        if let Some(known) = found.get(first) {
            return Ok(known.clone());
        }
        let look = |&tool: &Tool| tool.version().map(|version| Self { tool, version });
        let nextpnr = tools.iter().find_map(look).ok_or_else(|| Error::MissingTool {
            tool: tools.iter().map(|tool| tool.program).collect::<Vec<_>>().join(" or "),
            package: tools.iter().map(|tool| tool.package_text()).collect::<Vec<_>>().join("; "),
        })?;
        found.insert(first, nextpnr.clone());
        Ok(nextpnr)
    }

    /// Places the netlist in a directory. Errors: if it does not fit, or the report is not whole.
    pub(super) fn run(&self, directory: &Path, arguments: &[String]) -> Result<Placed, Error> {
        self.tool.succeed(self.tool.command(directory).args(arguments))?;
        let read = |name: &str| self.tool.written(&directory.join(name));
        let netlist = serde_json::from_slice(&read(NETLIST)?).unwrap_or_default();
        parse_report(&read(REPORT)?, &netlist)
    }
}

/// Reads a report of nextpnr. The netlist that it was given tells the types of cells.
///
/// # Errors
/// A report that is not whole.
pub fn parse_report(report: &[u8], netlist: &Value) -> Result<Placed, Error> {
    let broken = |what: String| Error::ToolFailed { tool: "nextpnr".to_owned(), what, output: String::new() };
    let report: Value =
        serde_json::from_slice(report).map_err(|error| broken(format!("its report is not whole: {error}")))?;
    let clocks = report["fmax"].as_object().ok_or_else(|| broken("its report says no clocks".to_owned()))?;
    // One clock; with several the slowest would count.
    let mut slowest: Option<f64> = None;
    for (name, clock) in clocks {
        let mhz = clock["achieved"].as_f64().filter(|mhz| mhz.is_finite() && *mhz > 0.0);
        let mhz = mhz.ok_or_else(|| broken(format!("its report says nothing of what the clock {name} reaches")))?;
        slowest = Some(slowest.map_or(mhz, |least| least.min(mhz)));
    }
    let Some(mhz) = slowest else { return Ok(Placed { clock: None }) };
    let paths = report["critical_paths"].as_array().ok_or_else(|| broken("its report has no paths".to_owned()))?;
    let between = |path: &&Value| {
        let ends = [&path["from"], &path["to"]].map(|end| end.as_str().unwrap_or_default());
        ends.iter().all(|end| !end.is_empty() && *end != "<async>")
    };
    // The slowest of those between registers.
    let delays = |path: &Value| -> Vec<(String, f64)> {
        let segments = path["path"].as_array().map(Vec::as_slice).unwrap_or_default();
        let delay = |segment: &Value| {
            (segment["type"].as_str().unwrap_or_default().to_owned(), segment["delay"].as_f64().unwrap_or_default())
        };
        segments.iter().map(delay).collect()
    };
    let total = |path: &Value| delays(path).iter().map(|(_, delay)| delay).sum::<f64>();
    let path = paths
        .iter()
        .filter(between)
        .max_by(|a, b| total(a).total_cmp(&total(b)))
        .ok_or_else(|| broken("its report has no path between registers".to_owned()))?;
    let sum = |wanted: &dyn Fn(&str) -> bool| {
        delays(path).iter().filter(|(kind, _)| wanted(kind)).map(|(_, delay)| delay).sum::<f64>()
    };
    let kind = |cell: &Value| {
        let name = cell.as_str().unwrap_or_default();
        let of = |module: &Value| module["cells"][name]["type"].as_str().map(str::to_owned);
        let modules = netlist["modules"].as_object();
        modules.and_then(|modules| modules.values().find_map(of)).unwrap_or_else(|| name.to_owned())
    };
    let segments = path["path"].as_array().map(Vec::as_slice).unwrap_or_default();
    let (first, last) = (segments.first(), segments.last());
    let limit = Limit {
        from: first.map(|segment| kind(&segment["from"]["cell"])).unwrap_or_default(),
        through: delays(path).iter().filter(|(kind, _)| kind == "logic").count() as u32,
        to: last.map(|segment| kind(&segment["to"]["cell"])).unwrap_or_default(),
        logic_ns: sum(&|kind| kind != "routing"),
        routing_ns: sum(&|kind| kind == "routing"),
    };
    Ok(Placed { clock: Some((mhz, limit)) })
}
