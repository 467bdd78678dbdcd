//! Intel Cyclone V.

use super::{Bram, Cells, Description, Dsp};

/// Yosys leaves the registers of multipliers and of block RAMs outside of them; Quartus would move them.
pub(super) const FAMILY: Description = Description {
    name: "cyclonev",
    title: "Cyclone V",
    brief: "Cyclone V (cells only)",
    about: "Intel Cyclone V: cells only, as there is no placement here; a LUT is an adaptive LUT, of which a logic \
     module (ALM) has two",
    device: "Cyclone V",
    yosys: "synth_intel_alm -family cyclonev -noiopad -noclkbuf",
    padless: "",
    cells: Cells {
        // One of six inputs takes both of its module, and counts once like the others.
        lut: &[
            ("MISTRAL_ALUT2", 1),
            ("MISTRAL_ALUT3", 1),
            ("MISTRAL_ALUT4", 1),
            ("MISTRAL_ALUT5", 1),
            ("MISTRAL_ALUT6", 1),
            ("MISTRAL_NOT", 1),
        ],
        carry: &[("MISTRAL_ALUT_ARITH", 1)],
        // A memory of 32 words of 1 bit is a twentieth of a block of ten modules.
        used_up: &[("MISTRAL_ALUT_ARITH", 1), ("MISTRAL_MLAB", 1)],
        ff: &[("MISTRAL_FF", 1)],
        // In sixths: a block multiplies 27 by 27 bits, twice 18 by 18, or three times 9 by 9.
        dsp: &[("MISTRAL_MUL27X27", 6), ("MISTRAL_MUL18X18", 3), ("MISTRAL_MUL9X9", 2)],
        bram: &[("MISTRAL_M10K", 1)],
    },
    dsp: Dsp {
        shapes: &[([9, 9], 2), ([18, 18], 3), ([27, 27], 6)],
        parts: 6,
        sign_bits: 0,
        least_operand: 4,
        least_product: 0,
    },
    // `memory_bram` asks for 5 % of a block's 10 kbit.
    bram: Bram {
        shapes: &[(8192, 1), (4096, 2), (2048, 5), (1024, 10), (512, 20), (256, 40)],
        worth: 512,
        registers: 2,
    },
    placement: None,
    pack: None,
    models: None,
};
