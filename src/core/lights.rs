//! The core in a design that takes lights in sequence, and the sequencer around it.

use super::{BlockDesign, Design, Direction, Port, Role, edges};
use crate::block::CHANNELS;
use crate::block::lights::Sums;
use crate::fixed::Format;
use crate::spec::{Block, LightSource};

/// The colours of the channels, in words.
const COLOURS: [&str; 3] = ["red", "green", "blue"];
/// Stages of the sequencer behind the core: the sum of a sample's lights, and its rounding.
const STAGES: u32 = 2;
/// The ports of a sample's first and last word in a table of lights.
pub(crate) const FIRST_WORD: &str = "in_begin";
pub(crate) const LAST_WORD: &str = "in_end";
/// The ports of a sequencer that change the set of texels, and that show it.
const SWAP: &str = "swap";
const SET_SHOWN: &str = "texel_set";
/// Stages of the table in front of the sequencer: the sample that is taken, and its lights that are read.
const TABLE_STAGES: u32 = 2;

/// What each output port of a core with lights in sequence is for, in order.
pub(super) fn sum_meanings(sums: &Sums) -> Vec<String> {
    let of_lights = COLOURS.map(|colour| format!("{colour} of these lights, at most 1.0"));
    let ambient = COLOURS.map(|colour| format!("{colour} of the ambient light"));
    of_lights.into_iter().chain(ambient.into_iter().filter(|_| sums.ambient.is_some())).collect()
}

/// What the output ports with the codes of the channels are for, in order.
pub(super) fn code_meanings(channel_bits: u32) -> Vec<String> {
    let full = (1u32 << channel_bits) - 1;
    COLOURS.map(|colour| format!("{colour}; {full} is full scale")).to_vec()
}

impl Design {
    /// What comes out of the core and is added up by the sequencer around it; `None` of a core without one.
    #[must_use]
    pub fn sums(&self) -> Option<Sums> {
        match self.block() {
            BlockDesign::Lobe(_) => None,
            BlockDesign::Shader(shader) => shader.shader.sums(shader.lobe.interface),
            BlockDesign::Image(image) => image.block.sums(),
        }
    }

    /// The words of the table of lights in front of the sequencer, a power of two; `None` of a core without one.
    #[must_use]
    pub fn light_table(&self) -> Option<u32> {
        let most = match &self.spec.block {
            Block::Lobe(_) => return None,
            Block::Shader(_, shader) => shader.most_lights?,
            Block::Image(of) => of.image.most_lights,
        };
        let lights = match self.spec.light_source {
            LightSource::Port => return None,
            LightSource::Table => most,
            LightSource::Rom => self.spec.light_records.0.len() as u32,
        };
        Some(lights.div_ceil(self.lights_a_clock()?).next_power_of_two().max(2))
    }

    /// The lights that the core is told of at once; `None` of a lobe and of a matcap.
    #[must_use]
    pub fn lights_a_clock(&self) -> Option<u32> {
        match &self.spec.block {
            Block::Lobe(_) => None,
            Block::Shader(_, shader) => Some(shader.lights),
            Block::Image(of) => of.image.has_lights().then_some(of.image.lights),
        }
    }

    /// What the words of the table of lights hold if it is not written: the codes of a clock's lights each, of those
    /// that are missing 0.
    #[must_use]
    pub fn light_words(&self) -> Option<Vec<Vec<i64>>> {
        let depth = self.light_table().filter(|_| self.spec.light_source == LightSource::Rom)? as usize;
        let codes = self.light_inputs().len();
        let a_word = self.lights_a_clock()? as usize;
        let mut words: Vec<Vec<i64>> = self.spec.light_records.0.chunks(a_word).map(<[_]>::concat).collect();
        words.resize(depth, Vec::new());
        words.iter_mut().for_each(|word| word.resize(codes, 0));
        Some(words)
    }

    /// The ports of the core that carry what it is told of the first light of a clock, and their formats; none of a
    /// core without a sequencer.
    #[must_use]
    pub fn light_ports(&self) -> Vec<(&str, Format)> {
        let Some(a_clock) = self.lights_a_clock() else { return Vec::new() };
        let all = self.light_inputs();
        let mut ports = self.numbers(Direction::In);
        ports.retain(|(name, _)| all.contains(name));
        ports.truncate(all.len() / a_clock as usize);
        ports
    }

    /// The latency of the core, or of the sequencer around it from the last light of a sample on.
    #[must_use]
    pub fn sequenced_latency(&self) -> u32 {
        self.schedule.latency + if self.sums().is_some() { STAGES } else { 0 }
    }

    /// The latency of the whole: of the core or its sequencer, and with a table of lights that of a sample whose lights
    /// are one word.
    #[must_use]
    pub fn whole_latency(&self) -> u32 {
        self.sequenced_latency() + if self.light_table().is_some() { TABLE_STAGES } else { 0 }
    }

    /// The ports of what a user of the core instantiates, in the order of their declaration: of its table of lights,
    /// its sequencer, or itself.
    #[must_use]
    pub fn whole_ports(&self) -> Vec<Port> {
        match self.light_table() {
            Some(depth) => self.table_ports(depth),
            None => self.sequencer_ports(),
        }
    }

    /// The ports of a table of lights of so many words in front of the sequencer, in the order of their declaration.
    #[must_use]
    pub fn table_ports(&self, depth: u32) -> Vec<Port> {
        let latency = self.whole_latency() - 1;
        let address = Some(Format::unsigned(depth.ilog2() as i32, 0));
        let of_lights = self.light_inputs();
        let is_light = |port: &Port| of_lights.contains(&port.name.as_str());
        let word: u32 = self
            .numbers(Direction::In)
            .iter()
            .filter(|(name, _)| of_lights.contains(name))
            .map(|(_, format)| format.width())
            .sum();
        let port = |name: &str, role, format, meaning: &str| Port {
            name: name.to_owned(),
            role,
            format,
            meaning: meaning.to_owned(),
        };
        let mut ports = Vec::new();
        for of_sequencer in self.sequencer_ports().into_iter().filter(|port| !is_light(port)) {
            match of_sequencer.role {
                Role::InLast => ports.extend([
                    port("in_ready", Role::InReady, None, "a sample is taken if it is valid, at an enabled clock"),
                    port(FIRST_WORD, Role::Operand, address, "word of the table with the sample's first lights"),
                    port(
                        LAST_WORD,
                        Role::Operand,
                        address,
                        "word with its last; the table goes on at 0 behind its end",
                    ),
                ]),
                Role::OutValid => {
                    if self.spec.light_source == LightSource::Table {
                        let data = Some(Format::unsigned(word as i32, 0));
                        let enable = "write enable of the table, whatever ce and rst are";
                        ports.extend([
                            port("lights_en", Role::Write, None, enable),
                            port("lights_addr", Role::Write, address, "address of the word that is written"),
                            port("lights_data", Role::Write, data, "a clock's lights; layout in the datasheet"),
                        ]);
                    }
                    let meaning = format!(
                        "the other outputs are a sample: of w words, {latency} + w enabled clocks after it was taken"
                    );
                    ports.push(Port { meaning, ..of_sequencer });
                }
                Role::Swap => ports.push(Port {
                    meaning: "the samples behind this one are looked up in the other set of texels".to_owned(),
                    ..of_sequencer
                }),
                _ => ports.push(of_sequencer),
            }
        }
        ports
    }

    /// The ports of the core that carry what it is told of lights.
    #[must_use]
    pub fn light_inputs(&self) -> Vec<&str> {
        let of_sample = match self.block() {
            BlockDesign::Lobe(_) => 0,
            BlockDesign::Shader(shader) => edges::ports_of_sample(shader.shader),
            BlockDesign::Image(image) => image.of.image.normal_axes(),
        };
        self.numbers(Direction::In).into_iter().skip(of_sample).map(|(name, _)| name).collect()
    }

    /// The ports of the sequencer around the core, in the order of their declaration; those of the core where there is
    /// none.
    #[must_use]
    pub fn sequencer_ports(&self) -> Vec<Port> {
        let Some(sums) = self.sums() else { return self.ports() };
        let latency = self.sequenced_latency();
        let meaning = |port: Port| match port.role {
            Role::InValid => Port { meaning: "the other inputs are to be taken".to_owned(), ..port },
            Role::Reset => Port {
                meaning: "synchronous reset, active high: drops all that is under way, whatever ce is".to_owned(),
                ..port
            },
            Role::OutValid => Port {
                meaning: format!("the other outputs are a sample: {latency} enabled clocks behind its in_last"),
                ..port
            },
            Role::Set => Port {
                name: SWAP.to_owned(),
                role: Role::Swap,
                format: None,
                meaning: "with in_last: the samples behind this one are looked up in the other set of texels"
                    .to_owned(),
            },
            _ => port,
        };
        let mut ports: Vec<Port> =
            self.ports().into_iter().filter(|port| !port.carries(Direction::Out)).map(meaning).collect();
        let last = Port {
            name: "in_last".to_owned(),
            role: Role::InLast,
            format: None,
            meaning: "with the lights of this clock the sample ends".to_owned(),
        };
        let place = ports.iter().position(|port| port.role == Role::InValid).map_or(0, |place| place + 1);
        ports.insert(place, last);
        let format = Some(Format::unsigned(sums.channel_bits as i32, 0));
        let code =
            |(c, meaning): (char, String)| Port { name: format!("out_{c}"), role: Role::Result, format, meaning };
        ports.extend(CHANNELS.into_iter().zip(code_meanings(sums.channel_bits)).map(code));
        if self.texel_sets() > 1 {
            ports.push(Port {
                name: SET_SHOWN.to_owned(),
                role: Role::SetShown,
                format: None,
                meaning: format!(
                    "set of texels that samples are looked up in; the other may be written {} enabled clocks after \
                     a change",
                    self.schedule.latency
                ),
            });
        }
        ports
    }

    /// The codes of a sample from what the core gives at each of its clocks: what the sequencer makes of it. Without a
    /// sequencer a sample is one clock, and what the core gives.
    #[must_use]
    pub fn sample_of(&self, clocks: &[Vec<i64>]) -> Vec<i64> {
        match self.sums() {
            Some(sums) => sums.codes(clocks.iter().map(Vec::as_slice)),
            None => clocks.first().cloned().unwrap_or_default(),
        }
    }
}
