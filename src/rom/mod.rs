//! Quantised coefficient tables and the files that hold them.

mod files;
mod table;

pub use files::{Difference, MAX_DEPTH, RomImage, first_difference, read, write};
pub use table::{Field, Table, interned};

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::error::Error;

/// A file format for the coefficient ROM.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum RomFormat {
    /// Hexadecimal words for `$readmemh`: NAME.mem.
    Mem,
    /// Intel HEX, each word in whole little-endian bytes: NAME.hex.
    Hex,
    /// Xilinx coefficient file: NAME.coe.
    Coe,
    /// Intel memory initialization file: NAME.mif.
    Mif,
    /// VHDL package with the words as a constant: NAME_rom_pkg.vhd.
    Vhdl,
    /// C header with the words as an array: NAME_rom.h.
    C,
    /// Table of shininess, real and quantised coefficients: NAME.csv.
    Csv,
    /// Raw words, each in whole little-endian bytes: NAME.bin.
    Bin,
}

impl RomFormat {
    /// Every format.
    pub const ALL: [Self; 8] = [Self::Mem, Self::Hex, Self::Coe, Self::Mif, Self::Vhdl, Self::C, Self::Csv, Self::Bin];

    /// The name of a core's file in this format for a memory: the core's own name for the coefficients.
    #[must_use]
    pub fn file_name(self, core: &str, table: &Table) -> String {
        let core = memory_name(core, table);
        match self {
            Self::Mem => format!("{core}.mem"),
            Self::Hex => format!("{core}.hex"),
            Self::Coe => format!("{core}.coe"),
            Self::Mif => format!("{core}.mif"),
            Self::Vhdl => format!("{core}_rom_pkg.vhd"),
            Self::C => format!("{core}_rom.h"),
            Self::Csv => format!("{core}.csv"),
            Self::Bin => format!("{core}.bin"),
        }
    }

    /// The format of a file, by its name's extension.
    ///
    /// # Errors
    /// Lists the extensions if this is none of them.
    pub fn of_file(path: &Path) -> Result<Self, Error> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        Ok(match extension.as_deref() {
            Some("mem") => Self::Mem,
            Some("hex") => Self::Hex,
            Some("coe") => Self::Coe,
            Some("mif") => Self::Mif,
            Some("vhd" | "vhdl") => Self::Vhdl,
            Some("h") => Self::C,
            Some("csv") => Self::Csv,
            Some("bin") => Self::Bin,
            _ => {
                return Err(Error::input(
                    format!("{}: the name does not say which ROM format this is", path.display()),
                    "a ROM file is a .mem, .hex, .coe, .mif, .vhd, .h, .csv or .bin",
                ));
            }
        })
    }
}

/// The name that the files of a core's memory go by: the core's own for the coefficients.
#[must_use]
pub fn memory_name(core: &str, table: &Table) -> String {
    if table.name == Table::COEFFICIENTS { core.to_owned() } else { format!("{core}_{}", table.name) }
}
