//! What there is of a core in its directory.

use super::{extension, memory_path};
use crate::core::Design;
use crate::spec::Language;

/// What there is of a core, each with a text and a test bench of its own in every language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The core.
    Core,
    /// Its sequencer.
    Lights,
    /// Its table of lights.
    Table,
    /// Its wrapper with AXI4-Stream interfaces.
    Axis,
}

impl Part {
    /// What there is of a core, what is used before what uses it.
    #[must_use]
    pub fn of(design: &Design) -> Vec<Self> {
        let lights = design.sums().map(|_| Self::Lights);
        let table = design.light_table().map(|_| Self::Table);
        let axis = design.spec.axi_stream.map(|_| Self::Axis);
        std::iter::once(Self::Core).chain(lights).chain(table).chain(axis).collect()
    }

    /// What a user of the core instantiates who has no AXI4-Stream: its table of lights, its sequencer, or itself.
    #[must_use]
    pub fn whole(design: &Design) -> Self {
        Self::of(design).into_iter().rfind(|&part| part != Self::Axis).unwrap_or(Self::Core)
    }

    /// What takes a sample clock by clock: its sequencer, or itself where it has none.
    #[must_use]
    pub fn sequenced(design: &Design) -> Self {
        if design.sums().is_some() { Self::Lights } else { Self::Core }
    }

    /// The name of its module or entity.
    #[must_use]
    pub fn name(self, design: &Design) -> String {
        let suffix = match self {
            Self::Core => "",
            Self::Lights => "_lights",
            Self::Table => "_table",
            Self::Axis => "_axis",
        };
        format!("{}{suffix}", design.spec.name)
    }

    /// The name of its test bench.
    #[must_use]
    pub fn bench_name(self, design: &Design) -> String {
        format!("{}_tb", self.name(design))
    }

    /// What it is, and its bench.
    #[must_use]
    pub fn nouns(self) -> [&'static str; 2] {
        match self {
            Self::Core => ["the core", "the core's bench"],
            Self::Lights => ["the sequencer", "the sequencer's bench"],
            Self::Table => ["the table of lights", "the table's bench"],
            Self::Axis => ["the AXI4-Stream wrapper", "the wrapper's bench"],
        }
    }

    /// The path of its text in the core's directory.
    #[must_use]
    pub fn rtl_path(self, design: &Design, language: Language) -> String {
        format!("rtl/{}.{}", self.name(design), extension(language))
    }

    /// The path of its test bench in the core's directory.
    #[must_use]
    pub fn bench_path(self, design: &Design, language: Language) -> String {
        format!("tb/{}.{}", self.bench_name(design), extension(language))
    }

    /// The paths of its text and of those that it uses, itself last.
    #[must_use]
    pub fn rtl_paths(self, design: &Design, language: Language) -> Vec<String> {
        let parts = Self::of(design);
        let own = parts.iter().position(|&part| part == self).map_or(1, |place| place + 1);
        parts[..own].iter().map(|part| part.rtl_path(design, language)).collect()
    }

    /// The same, and last its test bench, with the model of a memory outside of the core in front of it.
    #[must_use]
    pub fn paths_with_bench(self, design: &Design, language: Language) -> Vec<String> {
        let mut paths = self.rtl_paths(design, language);
        paths.extend(self.bench_paths(design, language));
        paths
    }

    /// The paths of its test bench and, in front of it, of what this uses beside the core.
    #[must_use]
    pub fn bench_paths(self, design: &Design, language: Language) -> Vec<String> {
        let memory = super::external_memory(design).map(|memory| memory_path(&memory, language));
        memory.into_iter().chain([self.bench_path(design, language)]).collect()
    }
}
