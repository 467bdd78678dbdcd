//! A resolved core: its spec, widths, ROM, datapath, schedule, and what is proved and measured of its error.

mod budget;
pub mod edges;
mod evaluation;
pub mod golden;
mod image;
mod image_inputs;
pub mod layout;
mod lights;
mod lobe;
mod matcap_inputs;
mod measure;
mod port;
pub mod sample;
mod shader;
mod tune;
mod vector_inputs;

pub use budget::{Part, ShaderError};
pub use evaluation::Evaluation;
pub use image::{ImageDesign, ImageError};
pub use measure::{Measured, Sweep};

pub use layout::Layout;
pub(crate) use lights::{FIRST_WORD, LAST_WORD};
pub use lobe::{LobeDesign, OtherForm};
pub use port::{Direction, Port, ReadPort, Role, WritePort};
pub use shader::ShaderDesign;

use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::block::image::{ImageBlock, Joints as ImageJoints};
use crate::block::shader::datapath::{Joints, build};
use crate::datapath::Datapath;
use crate::datapath::evaluate::Evaluator;
use crate::datapath::graph::Graph;
use crate::datapath::products::WideProduct;
use crate::datapath::range::{Region, regions};
use crate::datapath::schedule::{Adders, External, Schedule, schedule};
use crate::fixed::{Format, Rng, Table};
use crate::platform::error::Error;
use crate::spec::{Block, CoreSpec, RomStyle, hex};
use lobe::{MadeLobe, regions_of};

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
    /// Of an image-based block.
    Image(ImageError),
}

impl Account {
    /// Measures a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        match design.block() {
            BlockDesign::Lobe(lobe) => Self::Lobe { measured: Measured::of(lobe), other_form: lobe.other_form() },
            BlockDesign::Shader(shader) => Self::Shader(ShaderError::of(shader)),
            BlockDesign::Image(image) => Self::Image(ImageError::of(image)),
        }
    }
}

/// A resolved core.
#[derive(Clone, Debug)]
pub struct Design {
    /// What was asked for.
    pub spec: CoreSpec,
    /// The operations of the hardware, and the memories.
    pub datapath: Datapath,
    /// The operations with each product as one, whatever its width: what ranges and joints are of.
    function: Graph,
    /// The products that are wider than a DSP block, as nodes of the datapath.
    pub wide_products: Vec<WideProduct>,
    /// The pipeline.
    pub schedule: Schedule,
    /// How its block was made.
    made: Made,
}

/// What is known of a block besides its datapath.
#[derive(Clone, Debug)]
enum Made {
    Lobe(MadeLobe),
    /// With the joints of its lights, in their order.
    Shader(MadeLobe, Vec<Joints>),
    Image(ImageBlock, ImageJoints),
}

impl Made {
    /// The operations of a block, and what else is known of it.
    fn new(spec: &CoreSpec) -> Result<(Datapath, Self), Error> {
        let too_wide = |what: &str| {
            Error::input(format!("the {what} would need values of more than 126 bits"), "use fewer fraction bits")
        };
        match &spec.block {
            Block::Lobe(lobe) => MadeLobe::new(lobe, spec.rom).map(|(datapath, lobe)| (datapath, Self::Lobe(lobe))),
            Block::Shader(lobe, shader) => {
                let (of_lobe, made) = MadeLobe::new(lobe, spec.rom)?;
                let built = build(&lobe.interface, shader, &of_lobe);
                let (datapath, joints) = built.ok_or_else(|| too_wide("shader"))?;
                Ok((datapath, Self::Shader(made, joints)))
            }
            Block::Image(image) => {
                let block = ImageBlock::of(image)?;
                let (datapath, joints) = block.datapath().ok_or_else(|| too_wide("block"))?;
                Ok((datapath, Self::Image(block, joints)))
            }
        }
    }
}

/// A core as the block that it is.
#[derive(Clone, Copy, Debug)]
pub enum BlockDesign<'a> {
    /// A lobe.
    Lobe(LobeDesign<'a>),
    /// A shader.
    Shader(ShaderDesign<'a>),
    /// An image-based block.
    Image(ImageDesign<'a>),
}

impl Design {
    /// Chooses widths, quantises the coefficients, builds and schedules the datapath.
    ///
    /// # Errors
    /// A spec that no core can be built for, such as one whose printed form needs values wider than 126 bits, or a
    /// writable ROM of a method that has none.
    pub fn new(spec: CoreSpec) -> Result<Self, Error> {
        let (mut datapath, made) = Made::new(&spec)?;
        // Where lights come in sequence their number a second is what counts, and not how late a sample is.
        let adders = match &spec.block {
            Block::Image(_) => Adders::One,
            Block::Shader(_, shader) if shader.most_lights.is_some() => Adders::One,
            _ => Adders::Two,
        };
        let external = external(&spec, &datapath);
        let (graph, wide_products) = spec.dsp.built(&datapath.graph);
        let function = std::mem::replace(&mut datapath.graph, graph);
        let schedule = schedule(&datapath.graph, spec.pipeline, adders, &external)?;
        let design = Self { datapath, function, wide_products, schedule, made, spec };
        design.spec.golden_inputs.check("golden_inputs", &design.numbers(Direction::In))?;
        design.spec.light_records.check("light_records", &design.light_ports())?;
        if design.spec.rom == RomStyle::Writable && design.write_ports().is_empty() {
            return Err(Error::input(
                format!("the core {} has no coefficient memory that could be written", design.spec.name),
                "leave `rom = \"writable\"` out, or choose a method with coefficients",
            ));
        }
        Ok(design)
    }

    /// The core as the block that it is.
    #[must_use]
    pub fn block(&self) -> BlockDesign<'_> {
        match (&self.spec.block, &self.made) {
            (Block::Lobe(lobe), Made::Lobe(made)) => BlockDesign::Lobe(LobeDesign::new(self, lobe, made)),
            (Block::Shader(lobe, shader), Made::Shader(made, joints)) => {
                BlockDesign::Shader(ShaderDesign { lobe: LobeDesign::new(self, lobe, made), shader, joints })
            }
            (Block::Image(of), Made::Image(block, joints)) => {
                BlockDesign::Image(ImageDesign::new(self, of, block, joints))
            }
            _ => unreachable!("a design is made of its spec"),
        }
    }

    /// The core's lobe, alone or in a shader.
    ///
    /// # Panics
    /// An image-based block has none: where one may come, look at [`Design::block`].
    #[must_use]
    pub fn lobe(&self) -> LobeDesign<'_> {
        match self.block() {
            BlockDesign::Lobe(lobe) | BlockDesign::Shader(ShaderDesign { lobe, .. }) => lobe,
            BlockDesign::Image(_) => panic!("an image-based block has no lobe"),
        }
    }

    /// The ports through which the memories that hold data, and no function, are written, in the memories' order; none
    /// unless the spec asks for them.
    #[must_use]
    pub fn write_ports(&self) -> Vec<WritePort> {
        if self.spec.rom != RomStyle::Writable {
            return Vec::new();
        }
        let layout = self.layout();
        let written = |(memory, table): &(usize, &Table)| table.holds_data() && layout.read(*memory).is_some();
        let tables = self.tables().iter().enumerate().filter(written);
        tables.map(|(memory, table)| WritePort::of(memory, table, self.texel_sets())).collect()
    }

    /// The sets of texels that it holds: two if the one that is not looked up may be written; else one.
    #[must_use]
    pub fn texel_sets(&self) -> u32 {
        if self.spec.swap { 2 } else { 1 }
    }

    /// The ports through which memories outside of the core are read, in the memories' order; none unless the spec asks
    /// for them.
    #[must_use]
    pub fn read_ports(&self) -> Vec<ReadPort> {
        let External { memories, clocks } = &self.schedule.external;
        memories.iter().map(|&memory| ReadPort::of(memory, &self.tables()[memory], *clocks)).collect()
    }

    /// Whether its HDL reads the words of its memories from files: texels are many, and never in the source.
    #[must_use]
    pub fn reads_files(&self) -> bool {
        match self.spec.rom {
            RomStyle::File => true,
            RomStyle::Writable => !self.spec.block.has_lobe(),
            RomStyle::Inline => false,
        }
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
        let functions: Vec<_> = self.tables().iter().filter(|table| !table.holds_data()).map(Table::words).collect();
        let text = format!("{operations:?} {outputs:?} {memories:?} {functions:?}");
        hex(&Sha256::digest(text))[..16].to_owned()
    }

    /// The memories.
    #[must_use]
    pub fn tables(&self) -> &[Table] {
        &self.datapath.tables
    }

    /// The operations of the hardware.
    #[must_use]
    pub fn graph(&self) -> &Graph {
        &self.datapath.graph
    }

    /// The operations with each product as one, whatever its width. Their values are those of the hardware's; ranges
    /// are analysed here, as intervals do not see that the parts of a product belong together.
    #[must_use]
    pub fn function(&self) -> &Graph {
        &self.function
    }

    /// The vectorised evaluator.
    #[must_use]
    pub fn evaluator(&self) -> Evaluator<'_> {
        Evaluator::new(&self.function, self.tables())
    }

    /// All inputs, row by row of the memories, for the range analysis.
    #[must_use]
    pub fn regions(&self) -> Vec<Region> {
        match self.block() {
            BlockDesign::Lobe(lobe) | BlockDesign::Shader(ShaderDesign { lobe, .. }) => {
                regions_of(&lobe.interface.shininess, self.graph())
            }
            BlockDesign::Image(_) => regions(self.graph(), |_| 0),
        }
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
        let has_index = !matches!(self.spec.block, Block::Image(_));
        let numbers = |direction: Direction| {
            let meanings = match direction {
                Direction::In => self.input_meanings(),
                Direction::Out => self.output_meanings(),
            };
            let port = move |(place, ((name, format), meaning)): (usize, ((&str, Format), String))| {
                let role = match direction {
                    Direction::In if place == 0 && has_index => Role::Index,
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
        if self.texel_sets() > 1 {
            ports.push(Port {
                name: Role::IN_SET.to_owned(),
                ..control(Role::Set, "set of texels that the other inputs are looked up in")
            });
        }
        ports.extend(inputs);
        ports.extend(self.write_ports().iter().flat_map(WritePort::ports).cloned());
        ports.extend(self.read_ports().iter().flat_map(ReadPort::ports).cloned());
        ports.push(control(Role::OutValid, &result));
        ports.extend(outputs);
        ports
    }

    /// What each input port that carries numbers is for, in order.
    fn input_meanings(&self) -> Vec<String> {
        match self.block() {
            BlockDesign::Lobe(lobe) => lobe.input_meanings(),
            BlockDesign::Shader(shader) => shader.input_meanings(),
            BlockDesign::Image(image) => image.input_meanings(),
        }
    }

    /// What each output port that carries numbers is for, in order.
    fn output_meanings(&self) -> Vec<String> {
        match self.block() {
            BlockDesign::Lobe(_) => vec!["the lobe, 0 to 1; 1.0 is exact".to_owned()],
            BlockDesign::Shader(shader) => shader.output_meanings(),
            BlockDesign::Image(image) => image.output_meanings(),
        }
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
        match self.block() {
            BlockDesign::Lobe(lobe) => vec![lobe.model().evaluate(inputs[0] as u32, inputs[1]).into()],
            BlockDesign::Shader(shader) => shader.model().evaluate(inputs),
            BlockDesign::Image(image) => image.model().evaluate(inputs),
        }
    }

    /// An input of a core that has too many to run through them all: a random sample, random codes, or one that brings
    /// it to its edges.
    #[must_use]
    pub fn varied(&self, rng: &mut Rng) -> Vec<i64> {
        match self.block() {
            BlockDesign::Lobe(_) => sample::random_codes(&self.numbers(Direction::In), rng),
            BlockDesign::Shader(shader) => edges::varied(shader, rng),
            BlockDesign::Image(image) => image.varied(rng),
        }
    }

    /// Whether all its inputs are too many to run through: it is no lobe alone.
    #[must_use]
    pub fn is_sampled(&self) -> bool {
        !matches!(self.spec.block, Block::Lobe(_))
    }

    /// What the code of the first input port stands for, for people.
    #[must_use]
    pub fn selected(&self, index: i64) -> String {
        match self.block() {
            BlockDesign::Lobe(lobe) => {
                let set = &lobe.interface.shininess;
                format!("n = {}", set.value(set.row_of_index(index as u32)))
            }
            BlockDesign::Shader(shader) => shader.material(index as u32).name.clone(),
            BlockDesign::Image(_) => self.numbers(Direction::In)[0].1.value(index.into()).to_string(),
        }
    }

    /// The number of flip-flops of the pipeline, the ROM's registers and the valid chain included, before synthesis.
    #[must_use]
    pub fn register_bits(&self) -> u32 {
        let layout = self.layout();
        let crossing =
            |stage: u32| -> u32 { layout.registers(stage).iter().map(|r| layout.nodes()[r.node].format.width()).sum() };
        let word = |(memory, table): (usize, &Table)| match layout.read(memory) {
            Some(read) if read.registers > 0 => table.word_bits(),
            _ => 0,
        };
        let words: u32 = self.tables().iter().enumerate().map(word).sum();
        (0..self.schedule.latency).map(crossing).sum::<u32>() + words + self.schedule.latency
    }
}

/// The memories of a datapath that lie outside of the core, as the spec has it.
fn external(spec: &CoreSpec, datapath: &Datapath) -> External {
    let Some(clocks) = spec.texel_latency else { return External::default() };
    let memories = datapath.tables.iter().enumerate().filter(|(_, table)| table.holds_texels());
    External { memories: memories.map(|(memory, _)| memory).collect(), clocks }
}

/// The ports' names with their verb, or `many` where they are more than two.
fn subject(ports: &[Port], many: &str) -> String {
    match ports {
        [one] => format!("{} is", one.name),
        [one, other] => format!("{} and {} are", one.name, other.name),
        _ => many.to_owned(),
    }
}
