//! A resolved core: its spec, widths, ROM, datapath, schedule, and what is proved and measured of its error.

mod budget;
pub mod edges;
mod evaluation;
pub mod golden;
pub mod layout;
mod measure;
mod port;
pub mod sample;
mod tune;

pub use budget::{Part, ShaderError};
pub use evaluation::Evaluation;
pub use measure::{Measured, Sweep};

use std::sync::Arc;

use serde::Serialize;
use sha2::{Digest, Sha256};

pub use layout::Layout;
pub use port::{Direction, Port, Role, WritePort};

use crate::block::shader::ShaderModel;
use crate::block::shader::datapath::{self as shader, Joints};
use crate::datapath::evaluate::Evaluator;
use crate::datapath::graph::Graph;
use crate::datapath::range::{Analysis, Narrowed, Region, regions};
use crate::datapath::schedule::{Schedule, schedule};
use crate::datapath::widths::{Budget, Solution, solve};
use crate::datapath::{Datapath, Description};
use crate::fixed::{Format, Table, Widths};
use crate::lobe::Lobe;
use crate::method::{Configured, Model, Options};
use crate::platform::error::Error;
use crate::spec::{Block, CoreSpec, Cosine, Form, InputRange, LightColours, Operand, RomStyle, Shader, Shininess, hex};

/// The same core in the method's other form, or why it cannot be built.
pub type OtherForm = Result<Box<Design>, String>;

/// The measured error of a core.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Account {
    /// Of a lobe.
    Lobe {
        /// What was measured.
        #[serde(flatten)]
        measured: Measured,
        /// The core that the datasheet compares this one with, where the method has two forms for it.
        #[serde(skip)]
        other_form: Option<OtherForm>,
    },
    /// Of a shader.
    Shader(ShaderError),
}

impl Account {
    /// Measures a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        match &design.spec.block {
            Block::Lobe => Self::Lobe { measured: Measured::of(design), other_form: design.other_form() },
            Block::Shader(shader) => Self::Shader(ShaderError::of(design, shader)),
        }
    }
}

/// A resolved core.
#[derive(Clone, Debug)]
pub struct Design {
    /// What was asked for.
    pub spec: CoreSpec,
    /// The inner widths of the lobe.
    pub widths: Widths,
    /// The operations and the ROM.
    pub datapath: Datapath,
    /// The pipeline.
    pub schedule: Schedule,
    /// The proved error of the lobe.
    pub budget: Budget,
    /// The values of the lobe that the range analysis took bits off.
    pub narrowed: Vec<Narrowed>,
    /// The joints of a shader's lights, in their order; none of a lobe.
    pub joints: Vec<Joints>,
    /// The real-valued method of each shininess; kept, so that coefficients are fitted once.
    lobes: Arc<[Box<dyn Lobe>]>,
    /// What the lobe computes and how.
    description: Description,
}

impl Design {
    /// Chooses widths, quantises the coefficients, builds and schedules the datapath.
    ///
    /// # Errors
    /// A spec that no core can be built for, such as one whose printed form needs values wider than 126 bits, or a
    /// writable ROM of a method that has none.
    pub fn new(spec: CoreSpec) -> Result<Self, Error> {
        spec.method.check(&spec.interface)?;
        let architecture = spec.method.architecture(&spec.interface)?;
        let mut solution = solve(&*architecture)?;
        if spec.is_fitted() {
            solution = tune::tuned(&spec, &*architecture, solution);
        }
        let lobes = architecture.lobes(&solution.datapath.tables).into();
        let description = architecture.description(&solution.datapath.tables);
        drop(architecture);
        let Solution { widths, datapath: mut lobe, budget } = solution;
        let narrowed = narrow(&spec, &mut lobe);
        let (datapath, joints) = match &spec.block {
            Block::Lobe => (lobe, Vec::new()),
            Block::Shader(shader) => shader::build(&spec.interface, shader, &lobe).ok_or_else(|| {
                Error::input("the shader would need values of more than 126 bits", "use fewer fraction bits")
            })?,
        };
        let schedule = schedule(&datapath.graph, spec.pipeline)?;
        let design = Self { widths, datapath, schedule, budget, narrowed, lobes, description, joints, spec };
        design.spec.golden_inputs.check(&design.numbers(Direction::In))?;
        if design.spec.rom == RomStyle::Writable && design.write_ports().is_empty() {
            return Err(Error::input(
                format!("the core {} has no coefficient memory that could be written", design.spec.name),
                "leave `rom = \"writable\"` out, or choose a method with coefficients",
            ));
        }
        Ok(design)
    }

    /// The design of the same core in the other form, for comparison, where the method has two for this core: the paper
    /// form has the papers' coefficients and does not interpolate.
    fn other_form(&self) -> Option<OtherForm> {
        let spec = &self.spec;
        if !spec.method.about().has("form") || spec.is_fitted() || spec.interface.shininess.frac_bits() > 0 {
            return None;
        }
        let form = match spec.method.form() {
            Form::Stable => Form::Paper,
            Form::Paper => Form::Stable,
        };
        let method = Configured::new(spec.method.name(), &Options { form: Some(form), ..spec.method.options() });
        let other = method.and_then(|method| Self::new(CoreSpec { method, ..spec.clone() }));
        Some(other.map(Box::new).map_err(|error| error.to_string()))
    }

    /// The ports through which the memories that are keyed by the shininess are written, in the memories' order; none
    /// unless the spec asks for them.
    #[must_use]
    pub fn write_ports(&self) -> Vec<WritePort> {
        if self.spec.rom != RomStyle::Writable {
            return Vec::new();
        }
        let layout = self.layout();
        let written =
            |(memory, table): &(usize, &Table)| table.is_keyed_by_shininess() && layout.read(*memory).is_some();
        let tables = self.tables().iter().enumerate().filter(written);
        tables.map(|(memory, table)| WritePort::of(memory, table)).collect()
    }

    /// 16 hexadecimal digits that stand for the operations, their formats and the layout of the memories' words,
    /// without what the words are: where two cores have the same, the words of the one compute in the other what they
    /// compute in their own.
    #[must_use]
    pub fn datapath_digest(&self) -> String {
        let layout = |table: &Table| -> Vec<(&str, Format)> {
            table.fields.iter().map(|field| (field.name, field.format)).collect()
        };
        let memories: Vec<_> =
            self.tables().iter().map(|table| (table.name, table.address_bits, layout(table))).collect();
        let operations: Vec<_> = self.graph().nodes.iter().map(|node| (&node.op, &node.args, node.format)).collect();
        let outputs = &self.graph().outputs;
        let functions: Vec<_> =
            self.tables().iter().filter(|table| !table.is_keyed_by_shininess()).map(Table::words).collect();
        let text = format!("{operations:?} {outputs:?} {memories:?} {functions:?}");
        hex(&Sha256::digest(text))[..16].to_owned()
    }

    /// The memories.
    #[must_use]
    pub fn tables(&self) -> &[Table] {
        &self.datapath.tables
    }

    /// The real-valued method of each shininess, in the order of the set.
    #[must_use]
    pub fn lobes(&self) -> &[Box<dyn Lobe>] {
        &self.lobes
    }

    /// The operations.
    #[must_use]
    pub fn graph(&self) -> &Graph {
        &self.datapath.graph
    }

    /// What the core computes and how.
    #[must_use]
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// The bit-exact reference.
    #[must_use]
    pub fn model(&self) -> Model<'_> {
        Model {
            method: &self.spec.method,
            interface: &self.spec.interface,
            widths: &self.widths,
            tables: self.tables(),
            constants: &self.datapath.constants,
        }
    }

    /// The vectorised evaluator.
    #[must_use]
    pub fn evaluator(&self) -> Evaluator<'_> {
        Evaluator::new(self.graph(), self.tables())
    }

    /// All inputs, row by row, for the range analysis.
    #[must_use]
    pub fn regions(&self) -> Vec<Region> {
        regions_of(&self.spec, self.graph())
    }

    /// Stages and names, for the HDL.
    #[must_use]
    pub fn layout(&self) -> Layout<'_> {
        Layout::new(&self.spec.name, &self.datapath, &self.schedule)
    }

    /// The ports, in the order of their declaration.
    #[must_use]
    pub fn ports(&self) -> Vec<Port> {
        let control = |role: Role, meaning: &str| Port {
            name: role.name().unwrap_or_default().to_owned(),
            role,
            format: None,
            meaning: meaning.to_owned(),
        };
        let numbers = |direction: Direction| {
            let meanings = match direction {
                Direction::In => self.input_meanings(),
                Direction::Out => self.output_meanings(),
            };
            let port = move |(place, ((name, format), meaning)): (usize, ((&str, Format), String))| {
                let role = match direction {
                    Direction::In if place == 0 => Role::Index,
                    Direction::In => Role::Operand,
                    Direction::Out => Role::Result,
                };
                Port { name: name.to_owned(), role, format: Some(format), meaning }
            };
            self.numbers(direction).into_iter().zip(meanings).enumerate().map(port).collect::<Vec<_>>()
        };
        let (inputs, outputs) = (numbers(Direction::In), numbers(Direction::Out));
        let latency = self.schedule.latency;
        let taken = format!("{} to be taken", subject(&inputs, "the other inputs are"));
        let result = format!(
            "{} a result: in_valid, {latency} enabled clocks later",
            subject(&outputs, "the other outputs are")
        );
        let mut ports = vec![
            control(Role::Clock, "clock; everything happens on its rising edge"),
            control(Role::Reset, "synchronous reset, active high: clears the valid chain, whatever ce is"),
            control(Role::Enable, "clock enable: 0 freezes the whole pipeline"),
            control(Role::InValid, &taken),
        ];
        ports.extend(inputs);
        ports.extend(self.write_ports().iter().flat_map(WritePort::ports).cloned());
        ports.push(control(Role::OutValid, &result));
        ports.extend(outputs);
        ports
    }

    /// What each input port that carries numbers is for, in order.
    fn input_meanings(&self) -> Vec<String> {
        if let Block::Shader(shader) = &self.spec.block {
            return self.shader_input_meanings(shader);
        }
        let operand = match (self.spec.interface.operand, self.spec.interface.input_range) {
            (Operand::Cos, InputRange::Any) => "cosine x; below 0 gives 0, above 1 counts as 1",
            (Operand::Versine, InputRange::Any) => "versine u = 1 - x; above 1 counts as 1, which gives 0",
            (Operand::Cos, InputRange::Unit) => "cosine x, 0 to 1; a code above 1 counts as what it is above 1",
            (Operand::Versine, InputRange::Unit) => {
                "versine u = 1 - x, 0 to 1; a code above 1 counts as what it is above 1"
            }
        };
        vec![self.spec.interface.shininess.index_meaning(), operand.to_owned()]
    }

    /// What each output port that carries numbers is for, in order.
    fn output_meanings(&self) -> Vec<String> {
        match &self.spec.block {
            Block::Lobe => vec!["the lobe, 0 to 1; 1.0 is exact".to_owned()],
            Block::Shader(shader) => {
                let full = shader.full_scale();
                ["red", "green", "blue"].map(|channel| format!("{channel}; {full} is full scale")).to_vec()
            }
        }
    }

    /// As [`Design::input_meanings`], in the order in which [`shader::build`] makes the ports.
    fn shader_input_meanings(&self, shader: &Shader) -> Vec<String> {
        let vector = |of: &str| ["x", "y", "z"].map(|axis| format!("{axis} of {of}"));
        let last = self.spec.interface.shininess.rows() - 1;
        let mut meanings = vec![format!("index of the material, 0 to {last}; above: the last")];
        meanings.extend(vector("the normal N, of unit length"));
        if shader.cosine != Cosine::Half {
            meanings.extend(vector("the unit vector V to the viewer"));
        }
        for light in 1..=shader.lights {
            meanings.extend(vector(&format!("the unit vector L to light {light}")));
            if shader.cosine == Cosine::Half {
                meanings.extend(vector(&format!("the unit half vector H of light {light}")));
            }
            if shader.light_colours == LightColours::Ports {
                let full = shader.full_scale();
                let of = |colour| format!("{colour} of light {light}; {full} is full scale");
                meanings.extend(["red", "green", "blue"].map(of));
            }
        }
        meanings
    }

    /// The ports that carry numbers in one direction, in order: names and formats.
    #[must_use]
    pub fn numbers(&self, direction: Direction) -> Vec<(&str, Format)> {
        let graph = self.graph();
        let format = |id: usize| graph.nodes[id].format;
        match direction {
            Direction::In => graph.inputs.iter().map(|&id| (graph.nodes[id].name.as_str(), format(id))).collect(),
            Direction::Out => graph.outputs.iter().map(|(name, id)| (name.as_str(), format(*id))).collect(),
        }
    }

    /// The output ports' codes for the input ports' codes, by the bit-exact reference.
    #[must_use]
    pub fn evaluate(&self, inputs: &[i64]) -> Vec<i64> {
        match &self.spec.block {
            Block::Lobe => vec![self.model().evaluate(inputs[0] as u32, inputs[1]).into()],
            Block::Shader(shader) => self.shader_model(shader).evaluate(inputs),
        }
    }

    /// The bit-exact reference of the shader that this core is.
    #[must_use]
    pub fn shader_model<'a>(&'a self, shader: &'a Shader) -> ShaderModel<'a> {
        ShaderModel::new(&self.spec.interface, shader, self.model(), self.tables())
    }

    /// What the code of the first input port selects, for people.
    #[must_use]
    pub fn selected(&self, index: u32) -> String {
        let row = self.spec.interface.shininess.row_of_index(index);
        match (&self.spec.block, &self.spec.interface.shininess) {
            (Block::Shader(_), Shininess::Materials(materials)) => materials[row].name.clone(),
            (_, set) => format!("n = {}", set.value(row)),
        }
    }

    /// The name of the operand's port.
    #[must_use]
    pub fn operand_name(&self) -> &str {
        &self.graph().nodes[self.graph().operand()].name
    }

    /// The format of `in_n`.
    #[must_use]
    pub fn index_format(&self) -> Format {
        self.graph().nodes[self.graph().index()].format
    }

    /// The format of the operand's port.
    #[must_use]
    pub fn operand_format(&self) -> Format {
        self.graph().nodes[self.graph().operand()].format
    }

    /// The format of `out_spec`.
    #[must_use]
    pub fn output_format(&self) -> Format {
        self.graph().nodes[self.graph().output()].format
    }

    /// Whether the lobe is given the versine.
    #[must_use]
    pub fn takes_versine(&self) -> bool {
        self.spec.interface.operand == Operand::Versine
    }

    /// The versine in [0, 1] that an operand code stands for.
    #[must_use]
    pub fn versine(&self, operand: i64) -> f64 {
        let one = 1i64 << self.spec.interface.input_fraction;
        let within = match self.spec.interface.input_range {
            InputRange::Any => operand.clamp(0, one),
            InputRange::Unit if operand > one => operand - one,
            InputRange::Unit => operand,
        };
        let u = match self.spec.interface.operand {
            Operand::Cos => one - within,
            Operand::Versine => within,
        };
        u as f64 / one as f64
    }

    /// The operand code of a versine code in 0..=2^F.
    #[must_use]
    pub fn operand_of_versine(&self, versine: i64) -> i64 {
        match self.spec.interface.operand {
            Operand::Cos => (1i64 << self.spec.interface.input_fraction) - versine,
            Operand::Versine => versine,
        }
    }

    /// The number of flip-flops of the pipeline, the ROM's registers and the valid chain included, before synthesis.
    #[must_use]
    pub fn register_bits(&self) -> u32 {
        let layout = self.layout();
        let crossing =
            |stage: u32| -> u32 { layout.registers(stage).iter().map(|r| layout.nodes()[r.node].format.width()).sum() };
        let word = |(memory, table): (usize, &Table)| match layout.read(memory) {
            Some(read) if read.registered => table.word_bits(),
            _ => 0,
        };
        let words: u32 = self.tables().iter().enumerate().map(word).sum();
        (0..self.schedule.latency).map(crossing).sum::<u32>() + words + self.schedule.latency
    }
}

/// Blocks of inputs that narrowing may look at in all: less than a second's work.
const NARROWING_BLOCKS: usize = 1 << 19;

fn regions_of(spec: &CoreSpec, graph: &Graph) -> Vec<Region> {
    let (knots, frac_bits) = (spec.interface.shininess.of_knots(), spec.interface.shininess.frac_bits());
    regions(graph, |index| knots.row_of_index(index >> frac_bits))
}

/// Takes off a lobe's formats the bits that no input uses. A core whose words may be written keeps them: other words
/// may use them.
fn narrow(spec: &CoreSpec, lobe: &mut Datapath) -> Vec<Narrowed> {
    if spec.rom == RomStyle::Writable {
        return Vec::new();
    }
    let analysis = Analysis::new(&lobe.graph, &lobe.tables);
    let regions = regions_of(spec, &lobe.graph);
    let ranges = analysis.over(&regions, (NARROWING_BLOCKS / regions.len()) as u64);
    let (graph, narrowed) = analysis.narrowed(&ranges);
    lobe.graph = graph;
    narrowed
}

/// The ports' names with their verb, or `many` where they are more than two.
fn subject(ports: &[Port], many: &str) -> String {
    match ports {
        [one] => format!("{} is", one.name),
        [one, other] => format!("{} and {} are", one.name, other.name),
        _ => many.to_owned(),
    }
}
