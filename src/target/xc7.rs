//! AMD 7 series.

use super::{Bram, Cells, Description, Dsp, SHAPES_OF_18_KBIT};

pub(super) const FAMILY: Description = Description {
    name: "xc7",
    title: "Xilinx 7",
    brief: "7 series (cells only)",
    about: "AMD 7 series: cells only, as there is no placement here",
    device: "7 series",
    yosys: "synth_xilinx -family xc7 -flatten -noiopad -noclkbuf",
    padless: "",
    cells: Cells {
        lut: &[("LUT1", 1), ("LUT2", 1), ("LUT3", 1), ("LUT4", 1), ("LUT5", 1), ("LUT6", 1), ("SRL*", 1)],
        carry: &[("CARRY4", 1)],
        // The tables beside a carry are among the tables.
        used_up: &[],
        ff: &[("FDRE", 1), ("FDSE", 1), ("FDCE", 1), ("FDPE", 1)],
        dsp: &[("DSP48E1", 1)],
        bram: &[("RAMB36E1", 2), ("RAMB18E1", 1)],
    },
    dsp: Dsp { shapes: &[([25, 18], 1)], parts: 1, sign_bits: 1, least_operand: 2, least_product: 9 },
    bram: Bram { shapes: SHAPES_OF_18_KBIT, worth: 129 * 16, registers: 2 },
    placement: None,
    pack: None,
    models: None,
};
