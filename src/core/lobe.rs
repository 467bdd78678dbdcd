//! The lobe of a core: how it was made, its method and model, and what its ports' codes stand for.

use std::ops::Deref;
use std::sync::Arc;

use super::{Design, tune};
use crate::datapath::graph::Graph;
use crate::datapath::range::{Analysis, Narrowed, Region, regions};
use crate::datapath::widths::{Budget, Solution, solve};
use crate::datapath::{Datapath, Description};
use crate::fixed::{Format, Widths};
use crate::lobe::{self, Lobe};
use crate::method::{Check, Configured, Falls, Interface, Model, Options, are_falling};
use crate::platform::error::Error;
use crate::spec::{Block, CoreSpec, Form, InputRange, LobeSpec, Operand, RomStyle, Shininess};

/// The same core in the method's other form, or why it cannot be built.
pub type OtherForm = Result<Box<Design>, String>;

/// By how many ulps fitted words may be worse for an output that never falls, if there are widths with which they are
/// no worse than that.
const SLACK: f64 = 0.5;

/// What is known of a lobe besides its datapath.
#[derive(Clone, Debug)]
pub(super) struct MadeLobe {
    widths: Widths,
    budget: Budget,
    narrowed: Vec<Narrowed>,
    falls: Falls,
    /// The real-valued method of each shininess; kept, so that coefficients are fitted once.
    lobes: Arc<[Box<dyn Lobe>]>,
    description: Description,
}

impl MadeLobe {
    /// Chooses widths, quantises the coefficients and builds the datapath.
    ///
    /// # Errors
    /// A lobe that cannot be built.
    pub(super) fn new(spec: &LobeSpec, rom: RomStyle) -> Result<(Datapath, Self), Error> {
        let LobeSpec { method, interface } = spec;
        method.check(interface)?;
        let architecture = method.architecture(interface)?;
        let check = Check::new(interface);
        let solved = |check: Option<(&Check, f64)>| {
            solve(&*architecture, &|widths, datapath| tune::finished(spec, &*architecture, check, widths, datapath))
        };
        let within = |slack: f64| solved(interface.monotone.then_some((&check, slack)));
        let first = within(SLACK).or_else(|error| if spec.is_fitted() { within(f64::INFINITY) } else { Err(error) });
        let (solution, is_kept) = match first {
            Ok(solution) => (solution, interface.monotone),
            Err(error) if interface.monotone => {
                // Where the method's own lobe rises with the versine, no widths mend it.
                let solution = solved(None)?;
                if are_falling(&architecture.lobes(&solution.datapath.tables)) {
                    return Err(error);
                }
                (solution, false)
            }
            Err(error) => return Err(error),
        };
        let falls = if is_kept { check.none() } else { check.falls(&solution.datapath) };
        let lobes = architecture.lobes(&solution.datapath.tables).into();
        let description = architecture.description(&solution.datapath.tables);
        let Solution { widths, mut datapath, budget } = solution;
        // Words that may be written may use what those of this core do not.
        let narrowed = match rom {
            RomStyle::Writable => Vec::new(),
            _ => narrow(&interface.shininess, &mut datapath),
        };
        Ok((datapath, Self { widths, budget, narrowed, falls, lobes, description }))
    }
}

/// The lobe of a core, alone or in a shader; what is the whole core's is reached through it.
#[derive(Clone, Copy, Debug)]
pub struct LobeDesign<'a> {
    design: &'a Design,
    /// The method with its options.
    pub method: &'a Configured,
    /// The shininesses and the formats of its ports.
    pub interface: &'a Interface,
    /// Its inner widths.
    pub widths: &'a Widths,
    /// Its proved error.
    pub budget: &'a Budget,
    /// Its values that the range analysis took bits off.
    pub narrowed: &'a [Narrowed],
    /// Where its output falls as the cosine rises, with the words that it is generated with.
    pub falls: &'a Falls,
    /// The real-valued method of each shininess, in the order of the set.
    pub lobes: &'a [Box<dyn Lobe>],
    /// What it computes and how.
    pub description: &'a Description,
}

impl<'a> Deref for LobeDesign<'a> {
    type Target = Design;

    fn deref(&self) -> &Design {
        self.design
    }
}

impl<'a> LobeDesign<'a> {
    pub(super) fn new(design: &'a Design, of: &'a LobeSpec, made: &'a MadeLobe) -> Self {
        let LobeSpec { method, interface } = of;
        let MadeLobe { widths, budget, narrowed, falls, lobes, description } = made;
        Self { design, method, interface, widths, budget, narrowed, falls, lobes, description }
    }

    /// The core that it is in.
    #[must_use]
    pub fn core(self) -> &'a Design {
        self.design
    }

    /// The design of the same core in the other form, for comparison, where the method has two for this core: the paper
    /// form has the papers' coefficients and does not interpolate.
    pub(super) fn other_form(self) -> Option<OtherForm> {
        let Block::Lobe(spec) = &self.spec.block else { return None };
        if !self.method.about().has("form") || spec.is_fitted() || self.interface.shininess.frac_bits() > 0 {
            return None;
        }
        let form = match self.method.form() {
            Form::Stable => Form::Paper,
            Form::Paper => Form::Stable,
        };
        let method = Configured::new(self.method.name(), &Options { form: Some(form), ..self.method.options() });
        let other = method.and_then(|method| {
            let block = Block::Lobe(LobeSpec { method, interface: self.interface.clone() });
            Design::new(CoreSpec { block, ..self.spec.clone() })
        });
        Some(other.map(Box::new).map_err(|error| error.to_string()))
    }

    /// The bit-exact reference.
    #[must_use]
    pub fn model(self) -> Model<'a> {
        Model {
            method: self.method,
            interface: self.interface,
            widths: self.widths,
            tables: self.design.tables(),
            constants: &self.design.datapath.constants,
        }
    }

    /// What each input port that carries numbers is for, in order.
    pub(super) fn input_meanings(self) -> Vec<String> {
        let operand = match (self.interface.operand, self.interface.input_range) {
            (Operand::Cos, InputRange::Any) => "cosine x; below 0 gives 0, above 1 counts as 1",
            (Operand::Versine, InputRange::Any) => "versine u = 1 - x; above 1 counts as 1, which gives 0",
            (Operand::Cos, InputRange::Unit) => "cosine x, 0 to 1; a code above 1 counts as what it is above 1",
            (Operand::Versine, InputRange::Unit) => {
                "versine u = 1 - x, 0 to 1; a code above 1 counts as what it is above 1"
            }
        };
        vec![self.interface.shininess.index_meaning(), operand.to_owned()]
    }

    /// The name of the operand's port.
    #[must_use]
    pub fn operand_name(self) -> &'a str {
        &self.design.graph().nodes[self.design.graph().operand()].name
    }

    /// The format of `in_n`.
    #[must_use]
    pub fn index_format(self) -> Format {
        self.graph().nodes[self.graph().index()].format
    }

    /// The format of the operand's port.
    #[must_use]
    pub fn operand_format(self) -> Format {
        self.graph().nodes[self.graph().operand()].format
    }

    /// The format of `out_spec`.
    #[must_use]
    pub fn output_format(self) -> Format {
        self.graph().nodes[self.graph().output()].format
    }

    /// Whether it is given the versine.
    #[must_use]
    pub fn takes_versine(self) -> bool {
        self.interface.operand == Operand::Versine
    }

    /// The versine in [0, 1] that an operand code stands for.
    #[must_use]
    pub fn versine(self, operand: i64) -> f64 {
        let one = 1i64 << self.interface.input_fraction;
        let within = match self.interface.input_range {
            InputRange::Any => operand.clamp(0, one),
            InputRange::Unit if operand > one => operand - one,
            InputRange::Unit => operand,
        };
        let u = match self.interface.operand {
            Operand::Cos => one - within,
            Operand::Versine => within,
        };
        u as f64 / one as f64
    }

    /// The operand code of a versine code in 0..=2^F.
    #[must_use]
    pub fn operand_of_versine(self, versine: i64) -> i64 {
        match self.interface.operand {
            Operand::Cos => (1i64 << self.interface.input_fraction) - versine,
            Operand::Versine => versine,
        }
    }

    /// `x^n` for a row at an operand code.
    #[must_use]
    pub fn exact(self, row: usize, operand: i64) -> f64 {
        lobe::exact(self.interface.shininess.value(row), self.versine(operand))
    }
}

/// Blocks of inputs that narrowing may look at in all: less than a second's work.
const NARROWING_BLOCKS: usize = 1 << 19;

/// All inputs of a graph whose first port is an index of shininesses, row by row of the memories.
pub(super) fn regions_of(shininess: &Shininess, graph: &Graph) -> Vec<Region> {
    let (knots, frac_bits) = (shininess.of_knots(), shininess.frac_bits());
    regions(graph, |index| knots.row_of_index(index >> frac_bits))
}

/// Takes off a lobe's formats the bits that no input uses.
fn narrow(shininess: &Shininess, lobe: &mut Datapath) -> Vec<Narrowed> {
    let analysis = Analysis::new(&lobe.graph, &lobe.tables);
    let regions = regions_of(shininess, &lobe.graph);
    let ranges = analysis.over(&regions, (NARROWING_BLOCKS / regions.len()) as u64);
    let (graph, narrowed) = analysis.narrowed(&ranges);
    lobe.graph = graph;
    narrowed
}
