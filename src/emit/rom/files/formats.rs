//! The formats, each described in one place: its name and help, the ends of its files' names, what it allows, its reader and its writer.
//! The command line, the spec's key `rom_formats`, the tests and the fuzzer go by this list.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::read::Source;
use super::write::Writing;
use super::{RomImage, read, write};
use crate::emit::rom::memory_name;
use crate::fixed::Table;
use crate::platform::error::Error;

/// All that is known of a format.
pub(super) struct Sheet {
    /// What a file's name has behind the core's name.
    pub suffix: &'static str,
    /// The extensions, in lower case, by which a file is taken for one of this format.
    pub extensions: &'static [&'static str],
    /// What the format allows, for messages.
    pub allowed: &'static str,
    /// Whether it is text.
    pub is_text: bool,
    /// Its reader.
    pub read: fn(&Source<'_>) -> Result<RomImage, Error>,
    /// Its writer.
    pub write: fn(&Writing<'_>) -> Vec<u8>,
}

macro_rules! formats {
    ($($(#[doc = $about:literal])* $name:ident = $sheet:expr;)*) => {
        /// A file format for the coefficient ROM.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, clap::ValueEnum)]
        #[serde(rename_all = "kebab-case")]
        pub enum RomFormat {
            $($(#[doc = $about])* $name,)*
        }

        impl RomFormat {
            /// Every format.
            pub const ALL: [Self; [$(stringify!($name)),*].len()] = [$(Self::$name),*];

            pub(super) fn sheet(self) -> Sheet {
                match self {
                    $(Self::$name => $sheet,)*
                }
            }
        }
    };
}

formats! {
    /// Hexadecimal words for `$readmemh`: NAME.mem.
    Mem = Sheet {
        suffix: ".mem",
        extensions: &["mem", "vmem", "memh"],
        allowed: "a .mem file has hexadecimal words separated by white space, @ADDRESS in hexadecimal, and // or /* */ comments; \
                  or Lattice's header from #Format= to #Data and its lines",
        is_text: true,
        read: read::mem,
        write: write::mem,
    };
    /// Intel HEX with byte addresses, each word in whole little-endian bytes: NAME.hex; for Quartus see quartus-hex.
    Hex = Sheet {
        suffix: ".hex",
        extensions: &["hex", "ihex", "ihx"],
        allowed: "an Intel HEX file has one record a line, as in :0300300002337A1E, and ends with :00000001FF; its addresses count \
                  bytes, or words as Quartus writes them",
        is_text: true,
        read: read::hex,
        write: write::hex,
    };
    /// Xilinx coefficient file: NAME.coe.
    Coe = Sheet {
        suffix: ".coe",
        extensions: &["coe"],
        allowed: "a .coe file has memory_initialization_radix=2, 8, 10 or 16; then memory_initialization_vector=WORD,WORD,...; and \
                  after each semicolon a comment up to the end of the line",
        is_text: true,
        read: read::coe,
        write: write::coe,
    };
    /// Intel memory initialization file: NAME.mif.
    Mif = Sheet {
        suffix: ".mif",
        extensions: &["mif"],
        allowed: "Intel's .mif file has DEPTH, WIDTH, ADDRESS_RADIX and DATA_RADIX, each as in DEPTH = 256; then CONTENT BEGIN, \
                  lines such as 0 : 1f; or [0..3] : 1f; and END; Xilinx' has a word of binary digits a line",
        is_text: true,
        read: read::mif,
        write: write::mif,
    };
    /// VHDL package with the words as a constant: NAME_rom_pkg.vhd.
    Vhdl = Sheet {
        suffix: "_rom_pkg.vhd",
        extensions: &["vhd", "vhdl"],
        allowed: "the words stand in a constant array of bit strings, as in := (0 => \"0101\", 1 => x\"a\"); and the package ends \
                  with `end`",
        is_text: true,
        read: read::vhdl,
        write: write::vhdl,
    };
    /// C header with the words as an array: NAME_rom.h.
    C = Sheet {
        suffix: "_rom.h",
        extensions: &["h"],
        allowed: "the words stand in an array of integers or of limbs of 32 bits, as in = {0x1f, 0x2e}; or = {{1, 2}, {3, 4}};",
        is_text: true,
        read: read::c,
        write: write::c,
    };
    /// Table of shininess, real and quantised coefficients: NAME.csv.
    Csv = Sheet {
        suffix: ".csv",
        extensions: &["csv"],
        allowed: "a ROM's .csv has the columns address and word (hexadecimal), FIELD_code with integers and FIELD_real with numbers, \
                  named in the first row",
        is_text: true,
        read: read::csv,
        write: write::csv,
    };
    /// Raw words, each in whole little-endian bytes: NAME.bin.
    Bin = Sheet {
        suffix: ".bin",
        extensions: &["bin"],
        allowed: "a .bin file has whole little-endian bytes for each word",
        is_text: false,
        read: read::bin,
        write: write::bin,
    };
    /// Quartus' .hex, Intel HEX whose addresses count words, each in whole big-endian bytes: NAME_quartus.hex.
    QuartusHex = Sheet {
        suffix: "_quartus.hex",
        extensions: &[],
        allowed: "Quartus' .hex has one word a record, as in :03000200100001EA, and ends with :00000001FF; its addresses count words",
        is_text: true,
        read: read::quartus_hex,
        write: write::quartus_hex,
    };
    /// As mem, without comments, as Vivado's synthesis wants it: NAME_plain.mem.
    MemPlain = Sheet {
        suffix: "_plain.mem",
        extensions: &[],
        allowed: "a .mem file has hexadecimal words separated by white space, and @ADDRESS in hexadecimal",
        is_text: true,
        read: read::mem,
        write: write::mem_plain,
    };
}

impl RomFormat {
    /// The name of a core's file in this format for a memory: the core's own name for the coefficients.
    #[must_use]
    pub fn file_name(self, core: &str, table: &Table) -> String {
        memory_name(core, table) + self.sheet().suffix
    }

    /// The format of a file, by how its name ends: as we name files, or else by its extension.
    ///
    /// # Errors
    /// Lists the extensions if this is none of them.
    pub fn of_file(path: &Path) -> Result<Self, Error> {
        let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        let named = Self::ALL.into_iter().filter(|format| name.ends_with(format.sheet().suffix));
        if let Some(format) = named.max_by_key(|format| format.sheet().suffix.len()) {
            return Ok(format);
        }
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let of_extension =
            |format: &Self| extension.as_deref().is_some_and(|own| format.sheet().extensions.contains(&own));
        Self::ALL.into_iter().find(of_extension).ok_or_else(|| {
            let known: Vec<String> = Self::ALL
                .iter()
                .flat_map(|format| format.sheet().extensions)
                .map(|known| format!(".{known}"))
                .collect();
            Error::input(
                format!("{}: the name does not say which ROM format this is", path.display()),
                format!("say it with --format; by their names are known {}", known.join(", ")),
            )
        })
    }
}
