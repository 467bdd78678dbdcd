//! The files that hold a ROM: written from a [`Table`], read back into a [`RomImage`], compared.
//!
//! A format is a file of this folder, with all that is known of it, and its line in the list of [`RomFormat`], by which
//! the command line, the spec's key `rom_formats`, the tests and the fuzzer go.

mod bin;
mod c;
mod coe;
mod csv;
mod difference;
mod hex;
mod mem;
mod mif;
mod source;
mod vhdl;
mod writing;

pub use difference::{Difference, equal_words, first_difference};

use std::path::Path;

use num_bigint::BigUint;
use serde::{Deserialize, Serialize};

use crate::fixed::{Field, Table};
use crate::platform::error::Error;
use crate::platform::input;
use source::Source;
use writing::Writing;

/// The most words that a ROM file may hold: an address has at most 16 bits.
pub const MAX_DEPTH: usize = 1 << 16;

/// What a ROM file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RomImage {
    /// Every word, by address.
    pub words: Vec<BigUint>,
    /// Whose kind of the format it is, where there are several, such as "with Lattice's header".
    pub kind: Option<&'static str>,
    /// The width of a word, if the format states it.
    pub width: Option<u32>,
    /// The codes of each field by address, if the format has them beside the words: only a CSV file does.
    pub codes: Vec<(String, Vec<i128>)>,
}

/// All that is known of a format.
struct FileFormat {
    /// What it is, for people.
    about: &'static str,
    /// What a file's name has behind the core's name.
    suffix: &'static str,
    /// The extensions, in lower case, by which a file is taken for one of this format.
    extensions: &'static [&'static str],
    /// What the format allows, for messages.
    allowed: &'static str,
    /// Whether it is text.
    is_text: bool,
    /// Its reader.
    read: fn(&Source<'_>) -> Result<RomImage, Error>,
    /// Its writer.
    write: fn(&Writing<'_>) -> Vec<u8>,
}

macro_rules! formats {
    ($($name:ident = $file:ident::$format:ident,)*) => {
        /// A file format for the coefficient ROM.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, clap::ValueEnum)]
        #[serde(rename_all = "kebab-case")]
        #[allow(missing_docs, reason = "what each is stands in its file")]
        pub enum RomFormat {
            $(#[value(help = $file::$format.about)] $name,)*
        }

        impl RomFormat {
            /// Every format.
            pub const ALL: [Self; [$(stringify!($name)),*].len()] = [$(Self::$name),*];

            fn file(self) -> &'static FileFormat {
                match self {
                    $(Self::$name => &$file::$format,)*
                }
            }
        }
    };
}

formats! {
    Mem = mem::MEM,
    Hex = hex::HEX,
    Coe = coe::COE,
    Mif = mif::MIF,
    Vhdl = vhdl::VHDL,
    C = c::C,
    Csv = csv::CSV,
    Bin = bin::BIN,
    QuartusHex = hex::QUARTUS_HEX,
    MemPlain = mem::MEM_PLAIN,
}

impl RomFormat {
    /// The name of a core's file in this format for a memory: the core's own name for the coefficients.
    #[must_use]
    pub fn file_name(self, core: &str, table: &Table) -> String {
        memory_name(core, table) + self.file().suffix
    }

    /// The format of a file, by how its name ends: as we name files, or else by its extension.
    ///
    /// # Errors
    /// Lists the extensions if this is none of them.
    pub fn of_file(path: &Path) -> Result<Self, Error> {
        let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        let named = Self::ALL.into_iter().filter(|format| name.ends_with(format.file().suffix));
        if let Some(format) = named.max_by_key(|format| format.file().suffix.len()) {
            return Ok(format);
        }
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let of_extension =
            |format: &Self| extension.as_deref().is_some_and(|own| format.file().extensions.contains(&own));
        Self::ALL.into_iter().find(of_extension).ok_or_else(|| {
            let known: Vec<String> =
                Self::ALL.iter().flat_map(|format| format.file().extensions).map(|known| format!(".{known}")).collect();
            Error::input(
                format!("{}: the name does not say which ROM format this is", path.display()),
                format!("say it with --format; by their names are known {}", known.join(", ")),
            )
        })
    }
}

/// The name that the files of a core's memory go by: the core's own for the coefficients.
#[must_use]
pub fn memory_name(core: &str, table: &Table) -> String {
    if table.name == Table::COEFFICIENTS { core.to_owned() } else { format!("{core}_{}", table.name) }
}

/// The content of a ROM file: ASCII lines that each end in LF, except for the raw words of [`RomFormat::Bin`].
///
/// Formats with comments begin with what the file is, the command that made it, the digest of its
/// specification and the layout of the word.
#[must_use]
pub fn write(table: &Table, format: RomFormat, core: &str, digest: &str, command: &str) -> Vec<u8> {
    (format.file().write)(&Writing { table, core, digest, command })
}

/// Reads a ROM file. `expected_bits` is the width of the words that it should hold, `file` its name for messages.
///
/// # Errors
/// Says what is wrong, where, and what is allowed: the text is not of the format or is cut off, a word is wider
/// than `expected_bits` or the format states another width, an address is out of range, twice there or missing.
pub fn read(bytes: &[u8], format: RomFormat, file: &str, expected_bits: u32) -> Result<RomImage, Error> {
    let format = format.file();
    if format.is_text {
        input::refuse_wide_text(bytes, file)?;
    }
    (format.read)(&Source::new(bytes, file, format.allowed, expected_bits))
}
