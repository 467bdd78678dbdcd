//! What a core costs on an FPGA: Yosys for the cells, nextpnr for the clock.
//!
//! Yosys and nextpnr place a core with unconstrained ports; the clock that they reach is that of the paths between
//! registers. Every result holds the versions of both, since they change it more than many a change of the core.

mod cache;
mod flow;
mod ghdl;
mod mutate;
mod place;
pub(crate) mod yosys;

pub(crate) use ghdl::as_verilog;
pub(crate) use mutate::{Listed, Mutated, mutated, mutated_by};

pub use place::{Limit, Placed, parse_report};
pub use yosys::{count, parse_netlist};

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::core::Design;
use crate::emit::package::{self, Part};
use crate::platform::error::{Error, refuse};
use crate::platform::tool::{self, YOSYS};
use crate::platform::transient::Folder;
use crate::spec::Language;
use crate::target::{self, Family};
use cache::{Cache, key};
use flow::Flow;
use place::Nextpnr;
use serde::{Deserialize, Serialize};
use yosys::Yosys;

/// The versions of the programs, as they print them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tools {
    /// Yosys.
    pub yosys: String,
    /// nextpnr, if the core was placed.
    pub nextpnr: Option<String>,
}

/// What a core takes, alone: without pads and without what surrounds it for a placement.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Resources {
    /// Cells that are a look-up table of any size, shift registers made of one included.
    pub lut: u32,
    /// Cells of a carry chain, each of as many bits as the family's has.
    pub carry: u32,
    /// Look-up tables that are used up: `lut`, and what carry chains and memories take of tables that are not among
    /// them.
    pub lut_total: u32,
    /// Flip-flops outside of DSP blocks and block RAMs.
    pub ff: u32,
    /// DSP blocks; multipliers that share one count as parts of it.
    pub dsp: u32,
    /// Block RAMs.
    pub bram: u32,
    /// All cells by their type.
    pub cells: BTreeMap<String, u32>,
}

impl Resources {
    fn of(family: Family, cells: BTreeMap<String, u32>) -> Self {
        let target::Cells { lut, carry, used_up, ff, dsp, bram } = family.cells;
        let [lut, carry, used_up, ff, dsp, bram] =
            [lut, carry, used_up, ff, dsp, bram].map(|kinds| target::count(kinds, &cells));
        Self { lut, carry, lut_total: lut + used_up, ff, dsp: dsp.div_ceil(family.dsp.parts), bram, cells }
    }
}

/// The clock that a core reaches.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// The clock that the placement was asked for, in MHz.
    pub target_mhz: f64,
    /// The clock reached with the seeds 1, 2 and so on, in MHz.
    pub mhz: Vec<f64>,
    /// The lowest of them.
    pub min_mhz: f64,
    /// The middle one; of an even number the mean of the two in the middle.
    pub median_mhz: f64,
    /// The highest.
    pub max_mhz: f64,
    /// What the slowest path is, with each seed.
    #[serde(default)]
    pub limits: Vec<Limit>,
}

impl Timing {
    /// Sums up the clocks of the seeds, of which there is at least one.
    fn of(target_mhz: f64, placed: Vec<(f64, Limit)>) -> Self {
        let (mhz, limits): (Vec<f64>, Vec<Limit>) = placed.into_iter().unzip();
        let mut sorted = mhz.clone();
        sorted.sort_by(f64::total_cmp);
        let (low, high) = (sorted[(sorted.len() - 1) / 2], sorted[sorted.len() / 2]);
        let (min_mhz, max_mhz) = (sorted[0], sorted[sorted.len() - 1]);
        Self { target_mhz, mhz, min_mhz, median_mhz: (low + high) / 2.0, max_mhz, limits }
    }

    /// Whether the median reaches the target.
    #[must_use]
    pub fn is_met(&self) -> bool {
        self.median_mhz >= self.target_mhz
    }
}

/// What was measured of a core.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Synthesis {
    /// The family.
    pub family: Family,
    /// The device, its package and its speed grade.
    pub device: String,
    /// The programs.
    pub tools: Tools,
    /// The cells.
    pub resources: Resources,
    /// The clock; `None` where nothing was placed, or no path lies between two registers.
    pub timing: Option<Timing>,
    /// Clocks from an input to its result.
    pub latency_clocks: u32,
    /// The same in ns, at the median clock.
    pub latency_ns: Option<f64>,
    /// Results a second at the median clock: one a clock.
    pub results_per_second: Option<f64>,
}

impl Synthesis {
    /// Why there is no clock, where there is none.
    #[must_use]
    pub fn no_clock(&self) -> Option<&'static str> {
        match (&self.timing, &self.family.placement, &self.tools.nextpnr) {
            (Some(_), ..) => None,
            (None, None, _) => Some("there is no placement for this family here, only cells are counted"),
            (None, Some(_), None) => Some("it was not placed"),
            (None, Some(_), Some(_)) => Some("no path lies between two registers"),
        }
    }
}

/// How a core is synthesised.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The family.
    pub family: Family,
    /// How many seeds the placement is done with, 1 to [`Options::MAX_SEEDS`].
    pub seeds: u32,
    /// The clock that the placement is asked for, in MHz: above 0, up to 1000.
    pub target_mhz: f64,
    /// Whether the core is placed, where the family has a placement.
    pub place: bool,
    /// Whether registers are moved into DSP blocks and block RAMs, where Yosys leaves that out ([`target::Pack`]).
    pub pack: bool,
    /// The language that is synthesised; VHDL goes through GHDL's synthesis.
    pub language: Language,
    /// Yosys: a program, or `pyosys` for the Python package; `None` looks for one.
    pub yosys: Option<String>,
    /// The folder where results are kept; `None` keeps none.
    pub cache: Option<PathBuf>,
}

impl Options {
    /// The largest number of seeds.
    pub const MAX_SEEDS: u32 = 100;

    /// The family's defaults: three seeds, the user's cache folder.
    #[must_use]
    pub fn new(family: Family) -> Self {
        Self {
            family,
            seeds: 3,
            target_mhz: family.target_mhz(),
            place: true,
            pack: true,
            language: Language::Verilog,
            yosys: None,
            cache: Some(default_cache()),
        }
    }

    fn check(&self) -> Result<(), Error> {
        refuse!(
            !(1..=Self::MAX_SEEDS).contains(&self.seeds),
            format!("{} seeds are not allowed", self.seeds),
            format!("1 to {} are", Self::MAX_SEEDS)
        );
        refuse!(
            !(self.target_mhz > 0.0 && self.target_mhz <= 1000.0),
            format!("a target of {} MHz is not allowed", self.target_mhz),
            "more than 0 and up to 1000 are"
        );
        Ok(())
    }
}

/// The folder where results are kept unless another is given.
#[must_use]
pub fn default_cache() -> PathBuf {
    tool::cache_directory().join("synth")
}

/// A part of the work that is about to begin, or was found done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Yosys.
    Synthesis,
    /// nextpnr with this seed.
    Placement(u32),
}

/// A measurement, and what of it had been kept.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Run {
    /// What was measured.
    #[serde(flatten)]
    pub synthesis: Synthesis,
    /// Whether all of it came from the cache.
    pub cached: bool,
}

/// The programs that [`synthesise`] would run.
///
/// # Errors
/// Options out of range, or a program that is not installed.
pub fn tools(options: &Options) -> Result<Tools, Error> {
    options.check()?;
    let (yosys, nextpnr) = find(options)?;
    Ok(Tools { yosys: yosys.version, nextpnr: nextpnr.map(|nextpnr| nextpnr.version) })
}

fn find(options: &Options) -> Result<(Yosys, Option<Nextpnr>), Error> {
    let yosys = Yosys::find(options.yosys.as_deref())?;
    let nextpnr = match &options.family.description().placement {
        Some(placement) if options.place => Some(Nextpnr::find(placement.tools)?),
        _ => None,
    };
    Ok((yosys, nextpnr))
}

/// Measures what a core costs.
///
/// # Errors
/// Options out of range, a program that is not installed, or one that does not do its work (a core that does not fit
/// the device, for one).
pub fn synthesise(design: &Design, options: &Options) -> Result<Synthesis, Error> {
    run(design, options, &|_| {}).map(|run| run.synthesis)
}

/// As [`synthesise`]; `progress` is told of each step before it.
///
/// # Errors
/// As those of [`synthesise`].
pub fn run(design: &Design, options: &Options, progress: &dyn Fn(Step)) -> Result<Run, Error> {
    options.check()?;
    let family = options.family;
    let (yosys, nextpnr) = find(options)?;
    let mut work = Work::new(design, options, &yosys, options.cache.clone())?;
    progress(Step::Synthesis);
    let cells = work.cells()?;
    let mut placed = Vec::new();
    if let Some(nextpnr) = &nextpnr {
        for seed in 1..=options.seeds {
            progress(Step::Placement(seed));
            placed.extend(work.placed(nextpnr, seed)?.clock);
        }
    }
    let timing = (!placed.is_empty()).then(|| Timing::of(options.target_mhz, placed));
    let latency_clocks = design.whole_latency();
    let synthesis = Synthesis {
        family,
        device: family.device.to_owned(),
        tools: Tools { yosys: yosys.version.clone(), nextpnr: nextpnr.map(|nextpnr| nextpnr.version) },
        resources: Resources::of(family, cells),
        latency_clocks,
        latency_ns: timing.as_ref().map(|timing| 1e3 * f64::from(latency_clocks) / timing.median_mhz),
        results_per_second: timing.as_ref().map(|timing| 1e6 * timing.median_mhz),
        timing,
    };
    Ok(Run { synthesis, cached: work.ran == 0 })
}

/// The netlist of the core alone, its sequencer included, as Verilog: the one whose cells [`synthesise`] counts, with
/// the registers in the blocks where they are moved. Its module has the name and the ports of the sequencer, or of the
/// core where it has none.
///
/// # Errors
/// Options out of range, no Yosys, or one that does not read the core.
pub fn netlist(design: &Design, options: &Options) -> Result<Vec<u8>, Error> {
    options.check()?;
    let yosys = Yosys::find(options.yosys.as_deref())?;
    let mut work = Work::new(design, options, &yosys, None)?;
    let file = work.netlist(Netlist::Core)?;
    let directory = work.directory()?;
    let name = &work.name;
    // Without the library's cells, which Yosys would write as empty modules.
    let value = read_netlist(&directory.join(file))?;
    let core = serde_json::json!({ "modules": { name: value["modules"][name] } });
    package::write_file(&directory.join("alone.json"), core.to_string().as_bytes())?;
    yosys.run(&directory, "read_json alone.json\nwrite_verilog -noattr netlist.v\n")?;
    YOSYS.written(&directory.join("netlist.v"))
}

/// The files that Yosys reads, by their paths: the core as Verilog, and its memories' words where it reads them from
/// files.
fn files(design: &Design, language: Language) -> Result<Vec<package::File>, Error> {
    let mut files = package::sources(design, language)?;
    let bytes = match language {
        Language::Verilog => files.pop().expect("the HDL").bytes,
        Language::Vhdl => {
            let scratch = tool::scratch()?;
            write_all(scratch.path(), &files)?;
            let source = scratch.path().join(files.pop().expect("the HDL").path);
            as_verilog(&Part::whole(design).name(design), scratch.path(), &source)?
        }
    };
    files.push(package::File { path: CORE.to_owned(), bytes });
    Ok(files)
}

/// The core as Verilog, in the directory that Yosys works in.
const CORE: &str = "core.v";

fn write_all(directory: &Path, files: &[package::File]) -> Result<(), Error> {
    files.iter().try_for_each(|file| package::write_file(&directory.join(&file.path), &file.bytes))
}

/// A core's way through the programs.
struct Work<'a> {
    /// The module at the top.
    name: String,
    files: Vec<package::File>,
    design: &'a Design,
    options: &'a Options,
    yosys: &'a Yosys,
    /// The directory, once a program had to be run in it.
    directory: Option<Folder>,
    cache: Cache,
    /// The programs that had to be run.
    ran: u32,
}

/// Which of the two netlists of a core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Netlist {
    /// The core alone; its cells are counted.
    Core,
    /// What is placed.
    Placed,
}

impl<'a> Work<'a> {
    fn new(design: &'a Design, options: &'a Options, yosys: &'a Yosys, cache: Option<PathBuf>) -> Result<Self, Error> {
        let files = files(design, options.language)?;
        Ok(Self {
            name: Part::whole(design).name(design),
            files,
            design,
            options,
            yosys,
            directory: None,
            cache: Cache::new(cache),
            ran: 0,
        })
    }

    fn flow(&self) -> Flow {
        Flow::new(self.design, self.options)
    }

    /// What is kept in the cache is kept by the digest of everything that it depends on: this is a netlist's.
    fn netlist_key(&self, netlist: Netlist) -> String {
        let flow = self.flow();
        let script = flow.script(&self.name, netlist);
        let pack = format!("{} {}", flow.pack.is_some(), target::PACK_REVISION);
        let mut parts: Vec<&[u8]> = vec![self.yosys.version.as_bytes(), script.as_bytes(), pack.as_bytes()];
        for file in self.files.iter().chain(&flow.files) {
            parts.extend([file.path.as_bytes(), &file.bytes]);
        }
        key(&parts)
    }

    /// The directory with the files of the core in it.
    fn directory(&mut self) -> Result<PathBuf, Error> {
        if let Some(directory) = &self.directory {
            return Ok(directory.path().to_owned());
        }
        let made = tool::scratch()?;
        write_all(made.path(), &self.files)?;
        write_all(made.path(), &self.flow().files)?;
        Ok(self.directory.insert(made).path().to_owned())
    }

    /// Makes a netlist, unless it is there already, and returns its file's name.
    fn netlist(&mut self, netlist: Netlist) -> Result<String, Error> {
        let flow = self.flow();
        let netlist = if flow.shell.is_some() { netlist } else { Netlist::Core };
        let file = flow.file(netlist);
        let directory = self.directory()?;
        let path = directory.join(file);
        if !path.exists() {
            self.yosys.run(&directory, &flow.script(&self.name, netlist))?;
            self.ran += 1;
            if let Some(pack) = flow.pack {
                let mut value = read_netlist(&path)?;
                (pack.run)(&mut value, &self.name)?;
                let text = serde_json::to_string(&value).expect("JSON of plain values");
                package::write_file(&path, text.as_bytes())?;
            }
        }
        Ok(file.to_owned())
    }

    /// The cells of the core by their type.
    fn cells(&mut self) -> Result<BTreeMap<String, u32>, Error> {
        let key = self.netlist_key(Netlist::Core);
        if let Some(kept) = self.cache.get(&key) {
            return Ok(kept);
        }
        let file = self.netlist(Netlist::Core)?;
        let value = read_netlist(&self.directory()?.join(file))?;
        let cells = yosys::count(&value, &self.name)?;
        self.cache.put(&key, &cells)?;
        Ok(cells)
    }

    /// The clock with a seed.
    fn placed(&mut self, nextpnr: &Nextpnr, seed: u32) -> Result<Placed, Error> {
        let flow = self.flow();
        let arguments = flow.placement(self.options.target_mhz, seed);
        let netlist = self.netlist_key(Netlist::Placed);
        let key = key(&[netlist.as_bytes(), nextpnr.version.as_bytes(), arguments.join("\n").as_bytes()]);
        if let Some(kept) = self.cache.get(&key) {
            return Ok(kept);
        }
        self.netlist(Netlist::Placed)?;
        let directory = self.directory()?;
        let placed = nextpnr.run(&directory, &arguments)?;
        self.ran += 1;
        self.cache.put(&key, &placed)?;
        Ok(placed)
    }
}

fn read_netlist(path: &Path) -> Result<serde_json::Value, Error> {
    yosys::parse_netlist(&YOSYS.written(path)?)
}
