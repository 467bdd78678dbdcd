//! Simulation in this process.

use std::collections::VecDeque;

use super::{Job, LISTED, Outcome, Part, Simulator};
use crate::core::{Design, Direction};
use crate::datapath::fault::Defect;
use crate::datapath::simulate::{Inputs, Outputs, Simulation, Write};
use crate::fixed::Table;
use crate::platform::error::Error;
use crate::spec::Language;
use crate::verify::faults::inputs_text;
use crate::verify::golden::{self, Golden, Vector, codes_text};
#[cfg(feature = "kernel")]
use crate::verify::kernel;

/// What simulates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// The rust-hdl kernel of the method, at the core's widths.
    Kernel,
    /// The datapath's pipeline.
    Pipeline,
}

impl Engine {
    /// For messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Kernel => "builtin (rust-hdl kernel)",
            Self::Pipeline => "builtin (datapath pipeline)",
        }
    }
}

/// A core under simulation: one call, one rising edge.
trait Device {
    fn clock(&mut self, inputs: &Inputs, writes: &[Write]) -> Outputs;
}

impl Device for Simulation<'_> {
    fn clock(&mut self, inputs: &Inputs, writes: &[Write]) -> Outputs {
        self.clock_writing(inputs, writes)
    }
}

#[cfg(feature = "kernel")]
struct KernelDevice(Box<dyn kernel::Kernel>);

#[cfg(feature = "kernel")]
impl Device for KernelDevice {
    fn clock(&mut self, inputs: &Inputs, writes: &[Write]) -> Outputs {
        debug_assert!(writes.is_empty(), "no kernel stands for a core that can be written");
        // The kernel takes bit patterns; it masks the bits above its port's width.
        let code = |port: usize| inputs.codes.get(port).copied().unwrap_or_default() as u64;
        let (out_valid, out_spec) = self.0.clock(inputs.rst, inputs.ce, inputs.in_valid, code(0), code(1));
        Outputs { out_valid, codes: vec![out_spec.into()] }
    }
}

/// What the built-in simulation of a design uses.
#[must_use]
pub fn builtin_engine(design: &Design) -> Engine {
    #[cfg(feature = "kernel")]
    if kernel::of_design(design).is_some() {
        return Engine::Kernel;
    }
    let _ = design;
    Engine::Pipeline
}

fn device(design: &Design) -> Box<dyn Device + '_> {
    #[cfg(feature = "kernel")]
    if let Some(kernel) = kernel::of_design(design) {
        return Box::new(KernelDevice(kernel));
    }
    Box::new(Simulation::new(design.graph(), &design.schedule, design.tables()))
}

/// The simulation in this process.
#[derive(Clone, Copy, Debug)]
pub(super) struct Builtin;

impl Simulator for Builtin {
    fn name(&self) -> &'static str {
        "builtin"
    }

    fn language(&self) -> Option<Language> {
        None
    }

    fn run(&self, job: &Job, _: Part) -> Result<Outcome, Error> {
        Ok(run(job))
    }
}

/// Golden vectors in the form in which a simulation in this process runs them.
#[derive(Clone, Debug)]
pub struct Vectors<'a> {
    design: &'a Design,
    vectors: Vec<&'a Vector>,
    complemented: Vec<Vector>,
}

impl<'a> Vectors<'a> {
    /// Those of a golden file.
    #[must_use]
    pub fn of(design: &'a Design, golden: &'a Golden) -> Self {
        Self { design, vectors: golden.vectors(), complemented: golden::complemented(design, golden) }
    }

    /// What a core with something wrong in it does that the vectors do not expect: the first such thing, if there is
    /// one.
    #[must_use]
    pub fn detect(&self, defect: &Defect) -> Option<String> {
        let design = self.design;
        let mut device = Simulation::new(design.graph(), &design.schedule, design.tables()).with(defect);
        self.run(&mut device, 1).first.into_iter().next()
    }

    /// Runs the vectors, with their pauses, and compares `out_valid` and the outputs at every clock, until there are so
    /// many mismatches. A core whose memories can be written runs them as it comes up, then some vectors with other
    /// words in its memories, and all again with the right words.
    fn run(&self, device: &mut dyn Device, most: u64) -> Outcome {
        let Self { design, vectors, complemented } = self;
        let complemented: Vec<&Vector> = complemented.iter().collect();
        let mut bench = Bench::new(device, design, most).run_reset(vectors);
        bench.run(vectors);
        let mut first = Vec::new();
        if !design.write_ports().is_empty() && bench.mismatches < most {
            let mut due = vectors.len();
            for (what, tables, vectors) in [
                ("with complemented words", golden::complemented_tables(design), &complemented),
                ("with the words loaded", design.tables().to_vec(), vectors),
            ] {
                let compared = std::mem::take(&mut bench.compared);
                if compared == 0 || compared != due as u64 {
                    first.push(format!("{compared} of {due} vectors compared before the run {what}"));
                }
                let before = bench.mismatches;
                due = vectors.len();
                bench.load(&tables);
                bench.run(vectors);
                if bench.mismatches > before {
                    first.push(format!("{} mismatches {what}", bench.mismatches - before));
                }
            }
        }
        first.append(&mut bench.first);
        let (compared, mismatches) = (bench.compared, bench.mismatches);
        Outcome { vectors: compared, mismatches, first, ..Outcome::none("", "golden vectors", vectors.len() as u64) }
    }
}

fn run(job: &Job) -> Outcome {
    let (design, simulator) = (job.design, builtin_engine(job.design).name().to_owned());
    Outcome { simulator, ..Vectors::of(design, job.golden).run(device(design).as_mut(), u64::MAX) }
}

/// A device with a delay line of what it should answer.
struct Bench<'a> {
    device: &'a mut dyn Device,
    design: &'a Design,
    expected: VecDeque<Option<(usize, &'a Vector)>>,
    compared: u64,
    mismatches: u64,
    /// Mismatches after which no more vectors are fed.
    most: u64,
    /// The first differences, a line each.
    first: Vec<String>,
}

impl<'a> Bench<'a> {
    fn new(device: &'a mut dyn Device, design: &'a Design, most: u64) -> Self {
        let expected = std::iter::repeat_n(None, design.schedule.latency as usize).collect();
        Self { device, design, expected, compared: 0, mismatches: 0, most, first: Vec::new() }
    }

    /// Feeds vectors, with their pauses, until all results are out.
    fn run(&mut self, vectors: &[&'a Vector]) {
        let ports = self.design.numbers(Direction::In);
        for (number, &vector) in vectors.iter().enumerate() {
            if self.mismatches >= self.most {
                return;
            }
            for inputs in vector.clocks(&ports) {
                let taken = inputs.ce && inputs.in_valid;
                self.clock(&inputs, taken.then_some((number, vector)));
            }
        }
        let idle = Inputs { ce: true, ..Inputs::default() };
        for _ in 0..self.expected.len() {
            self.clock(&idle, None);
        }
    }

    /// Writes the words of tables to every memory that can be written, while the clock is enabled and not, and with the
    /// reset and without.
    fn load(&mut self, tables: &[Table]) {
        for port in self.design.write_ports() {
            for (address, word) in tables[port.memory].words().into_iter().enumerate() {
                let inputs = Inputs { ce: address % 2 == 0, rst: address % 4 < 2, ..Inputs::default() };
                self.clock_writing(&inputs, &[Write { memory: port.memory, address, word }], None);
            }
        }
    }

    /// Fills the pipeline and resets it, with the clock enabled and then without: nothing may come out.
    fn run_reset(mut self, vectors: &[&Vector]) -> Self {
        for ce in [true, false] {
            for vector in vectors.iter().take(self.expected.len() + 2) {
                let codes = vector.inputs.iter().copied().map(i128::from).collect();
                self.device.clock(&Inputs { rst: false, ce: true, in_valid: true, codes }, &[]);
            }
            // With an input that is presented at the same time: at this edge already nothing comes out, nor later. A
            // core of one stage shows nowhere else that it was reset.
            self.clock(&Inputs { rst: true, ce, in_valid: true, ..Inputs::default() }, None);
            for _ in 0..self.expected.len() {
                self.clock(&Inputs { ce: true, ..Inputs::default() }, None);
            }
        }
        self
    }

    fn clock(&mut self, inputs: &Inputs, expected: Option<(usize, &'a Vector)>) {
        self.clock_writing(inputs, &[], expected);
    }

    fn clock_writing(&mut self, inputs: &Inputs, writes: &[Write], expected: Option<(usize, &'a Vector)>) {
        let outputs = self.device.clock(inputs, writes);
        let fresh = inputs.ce;
        if fresh {
            self.expected.pop_back();
            self.expected.push_front(expected);
        }
        let due = self.expected.back().copied().flatten();
        let right = match due {
            Some((_, vector)) => {
                outputs.out_valid && outputs.codes.iter().copied().eq(vector.outputs.iter().copied().map(i128::from))
            }
            None => !outputs.out_valid,
        };
        // A result that is held while the clock is disabled is compared each time and counted once.
        self.compared += u64::from(fresh && due.is_some());
        if !right {
            self.mismatches += 1;
            if self.first.len() < LISTED {
                let got = if outputs.out_valid {
                    outputs.codes.iter().map(i128::to_string).collect::<Vec<_>>().join(" ")
                } else {
                    "nothing".to_owned()
                };
                self.first.push(match due {
                    Some((number, vector)) => {
                        let inputs = inputs_text(self.design, &vector.inputs);
                        let expected = codes_text(&vector.outputs);
                        format!("vector {}: {inputs}: expected {expected}, got {got}", number + 1)
                    }
                    None => format!("out_valid is {got} where it should not be"),
                });
            }
        }
    }
}
