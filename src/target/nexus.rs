//! Lattice Nexus.

use super::{Bram, Cells, Description, Dsp, SHAPES_OF_18_KBIT};

/// Yosys moves the registers of multipliers into them.
pub(super) const FAMILY: Description = Description {
    name: "nexus",
    title: "Nexus",
    brief: "LIFCL (cells only)",
    about: "Lattice Nexus: LIFCL (CrossLink-NX); cells only, as there is no placement here",
    device: "LIFCL",
    yosys: "synth_nexus -family lifcl -noiopad",
    padless: "",
    cells: Cells {
        // Two tables of four inputs and what selects between them; an inverter that is left over takes a table.
        lut: &[("LUT4", 1), ("WIDEFN9", 2), ("INV", 1)],
        carry: &[("CCU2", 1)],
        // A carry cell is two of the four inputs; a memory of 16 words of 4 bits takes three slices of two tables.
        used_up: &[("CCU2", 2), ("DPR16X4", 6)],
        ff: &[("FD1P3*", 1)],
        // In halves: a block multiplies 18 by 18 bits, or twice 9 by 9.
        dsp: &[
            ("MULT9X9", 1),
            ("MULT18X18", 2),
            ("MULTADDSUB18X18", 2),
            ("MULTPREADD18X18", 2),
            ("MULTADDSUB9X9WIDE", 4),
            ("MULT18X36", 4),
            ("MULT36X36", 8),
        ],
        bram: &[("DP16K", 1), ("PDP16K", 1), ("PDPSC16K", 1)],
    },
    dsp: Dsp {
        // One with registers, as the cores have, is never of 9 by 9 bits.
        shapes: &[([18, 18], 2), ([36, 18], 4), ([36, 36], 8)],
        parts: 2,
        sign_bits: 0,
        least_operand: 2,
        least_product: 0,
    },
    bram: Bram { shapes: SHAPES_OF_18_KBIT, worth: 128 * 16, registers: 2 },
    placement: None,
    pack: None,
    models: None,
};
