//! Simulation in this process.

use std::collections::VecDeque;

use super::{Job, LISTED, Outcome, Simulator};
use crate::datapath::simulate::{Inputs, Outputs, Simulation};
use crate::design::Design;
use crate::error::Error;
use crate::golden::{Vector, codes_text};
use crate::hdl::Direction;
#[cfg(feature = "kernel")]
use crate::kernel;
use crate::number::Format;
use crate::spec::Language;

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
    fn clock(&mut self, inputs: &Inputs) -> Outputs;
}

impl Device for Simulation<'_> {
    fn clock(&mut self, inputs: &Inputs) -> Outputs {
        Simulation::clock(self, inputs)
    }
}

#[cfg(feature = "kernel")]
struct KernelDevice(Box<dyn kernel::Kernel>);

#[cfg(feature = "kernel")]
impl Device for KernelDevice {
    fn clock(&mut self, inputs: &Inputs) -> Outputs {
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

    fn golden(&self, job: &Job) -> Result<Outcome, Error> {
        Ok(run(job))
    }
}

/// Runs the golden vectors, with their pauses, and compares `out_valid` and the outputs at every clock.
fn run(job: &Job) -> Outcome {
    let design = job.design;
    let ports = design.numbers(Direction::In);
    let vectors = job.golden.vectors();
    let mut device = device(design);
    let mut bench = Bench::new(device.as_mut(), design.schedule.latency).run_reset(&vectors);
    for (number, vector) in vectors.iter().enumerate() {
        let inverted = |(&code, &(_, format)): (&i64, &(&str, Format))| format.wrap(!i128::from(code));
        let garbage = Inputs {
            rst: false,
            ce: true,
            in_valid: false,
            codes: vector.inputs.iter().zip(&ports).map(inverted).collect(),
        };
        for _ in 0..vector.idle {
            bench.clock(&garbage, None);
        }
        for _ in 0..vector.stall {
            bench.clock(&Inputs { ce: false, in_valid: true, ..garbage.clone() }, None);
        }
        let inputs = Inputs { in_valid: true, codes: codes(vector), ..garbage };
        bench.clock(&inputs, Some((number, &vector.outputs)));
    }
    let idle = Inputs { ce: true, ..Inputs::default() };
    for _ in 0..design.schedule.latency {
        bench.clock(&idle, None);
    }
    let first = bench
        .first
        .iter()
        .map(|(number, got)| match number {
            Some(number) => {
                let v = &vectors[*number];
                let inputs: Vec<String> =
                    ports.iter().zip(&v.inputs).map(|((port, _), code)| format!("{port} {code}")).collect();
                let expected = codes_text(&v.outputs);
                format!("vector {}: {}: expected {expected}, got {got}", number + 1, inputs.join(", "))
            }
            None => format!("out_valid is {got} where it should not be"),
        })
        .collect();
    Outcome {
        simulator: builtin_engine(design).name().to_owned(),
        mode: "golden vectors",
        vectors: bench.compared,
        expected_vectors: vectors.len() as u64,
        mismatches: bench.mismatches,
        first,
        seconds: 0.0,
    }
}

fn codes(vector: &Vector) -> Vec<i128> {
    vector.inputs.iter().copied().map(i128::from).collect()
}

/// A device with a delay line of what it should answer.
struct Bench<'a> {
    device: &'a mut dyn Device,
    expected: VecDeque<Option<(usize, &'a [i64])>>,
    compared: u64,
    mismatches: u64,
    first: Vec<(Option<usize>, String)>,
}

impl<'a> Bench<'a> {
    fn new(device: &'a mut dyn Device, latency: u32) -> Self {
        let expected = std::iter::repeat_n(None, latency as usize).collect();
        Self { device, expected, compared: 0, mismatches: 0, first: Vec::new() }
    }

    /// Fills the pipeline and resets it, with the clock enabled and then without: nothing may come out.
    fn run_reset(mut self, vectors: &[&Vector]) -> Self {
        for ce in [true, false] {
            for vector in vectors.iter().take(self.expected.len() + 2) {
                let inputs = Inputs { rst: false, ce: true, in_valid: true, codes: codes(vector) };
                self.device.clock(&inputs);
            }
            self.device.clock(&Inputs { rst: true, ce, ..Inputs::default() });
            for _ in 0..self.expected.len() {
                self.clock(&Inputs { ce: true, ..Inputs::default() }, None);
            }
        }
        self
    }

    fn clock(&mut self, inputs: &Inputs, expected: Option<(usize, &'a [i64])>) {
        let outputs = self.device.clock(inputs);
        let fresh = inputs.ce;
        if fresh {
            self.expected.pop_back();
            self.expected.push_front(expected);
        }
        let due = self.expected.back().copied().flatten();
        let right = match due {
            Some((_, codes)) => {
                outputs.out_valid && outputs.codes.iter().copied().eq(codes.iter().copied().map(i128::from))
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
                self.first.push((due.map(|(number, _)| number), got));
            }
        }
    }
}
