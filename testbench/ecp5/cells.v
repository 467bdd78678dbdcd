// Lattice ECP5's cells as far as a synthesised core uses them, for a simulation without delays. Tables, carry chains and the order of a
// block RAM's words and halves follow what Yosys says of the cells in its own library and mapping (`share/lattice`), so a misreading of
// the device that both share is not found; Lattice's guides are sysDSP (FPGA-TN-02205) and sysMEM (FPGA-TN-02204).
//
// A setting or a mode that is not modelled ends the simulation without a verdict of the bench. Registers come up as their REGSET says,
// those inside of blocks 0. An undefined clock enable makes a register undefined.

`default_nettype none
`timescale 1ns/1ps

// Ends the simulation.
module ecp5_unknown;
    task report;
        input [8*20-1:0] cell_type;
        input [8*20-1:0] name;
        begin
            $display("the model of %0s does not know this %0s", cell_type, name);
            $finish_and_return(1);
        end
    endtask
endmodule

module LUT4 (input wire A, B, C, D, output wire Z);
    parameter [15:0] INIT = 16'h0000;
    // A condition that is undefined gives what both ways agree on, as in the table's multiplexers.
    wire [7:0] by_d = D ? INIT[15:8] : INIT[7:0];
    wire [3:0] by_c = C ? by_d[7:4] : by_d[3:0];
    wire [1:0] by_b = B ? by_c[3:2] : by_c[1:0];
    assign Z = A ? by_b[1] : by_b[0];
endmodule

module PFUMX (input wire ALUT, BLUT, C0, output wire Z);
    assign Z = C0 ? ALUT : BLUT;
endmodule

module L6MUX21 (input wire D0, D1, SD, output wire Z);
    assign Z = SD ? D1 : D0;
endmodule

// Two bits of a carry chain: in each a table of four inputs says whether the carry goes on, and its quarter of A and B what it is else.
module CCU2C (input wire CIN, A0, B0, C0, D0, A1, B1, C1, D1, output wire S0, S1, COUT);
    parameter [15:0] INIT0 = 16'h0000;
    parameter [15:0] INIT1 = 16'h0000;
    parameter INJECT1_0 = "YES";
    parameter INJECT1_1 = "YES";
    ecp5_unknown unknown ();
    wire go0, go1, make0, make1, carry;
    LUT4 #(.INIT(INIT0)) table0 (.A(A0), .B(B0), .C(C0), .D(D0), .Z(go0));
    LUT4 #(.INIT(INIT1)) table1 (.A(A1), .B(B1), .C(C1), .D(D1), .Z(go1));
    LUT4 #(.INIT({4{INIT0[3:0]}})) quarter0 (.A(A0), .B(B0), .C(1'b0), .D(1'b0), .Z(make0));
    LUT4 #(.INIT({4{INIT1[3:0]}})) quarter1 (.A(A1), .B(B1), .C(1'b0), .D(1'b0), .Z(make1));
    assign S0 = go0 ^ CIN;
    assign carry = go0 ? CIN : make0;
    assign S1 = go1 ^ carry;
    assign COUT = go1 ? carry : make1;
    initial begin
        if (INJECT1_0 != "NO") unknown.report("CCU2C", "INJECT1_0");
        if (INJECT1_1 != "NO") unknown.report("CCU2C", "INJECT1_1");
    end
endmodule

module TRELLIS_FF (input wire CLK, CE, LSR, DI, output reg Q);
    parameter GSR = "ENABLED";
    parameter CEMUX = "1";
    parameter CLKMUX = "CLK";
    parameter LSRMUX = "LSR";
    parameter REGSET = "RESET";
    parameter SRMODE = "LSR_OVER_CE";
    ecp5_unknown unknown ();
    wire enable = CEMUX == "1" ? 1'b1 : CEMUX == "INV" ? !CE : CE;
    wire reset = LSRMUX == "INV" ? !LSR : LSR;
    wire level = REGSET == "SET";
    initial begin
        Q = level;
        if (GSR != "DISABLED") unknown.report("TRELLIS_FF", "GSR");
        if (CEMUX != "1" && CEMUX != "CE" && CEMUX != "INV") unknown.report("TRELLIS_FF", "CEMUX");
        if (CLKMUX != "CLK") unknown.report("TRELLIS_FF", "CLKMUX");
        if (LSRMUX != "LSR" && LSRMUX != "INV") unknown.report("TRELLIS_FF", "LSRMUX");
        if (REGSET != "RESET" && REGSET != "SET") unknown.report("TRELLIS_FF", "REGSET");
        if (SRMODE != "LSR_OVER_CE" && SRMODE != "CE_OVER_LSR") unknown.report("TRELLIS_FF", "SRMODE");
    end
    // The set or reset is synchronous. One that the enable holds off is CE_OVER_LSR.
    wire acts = reset & (SRMODE == "LSR_OVER_CE" | enable);
    always @(posedge CLK)
        if (acts === 1'b1)
            Q <= level;
        else if (acts !== 1'b0 || (enable !== 1'b0 && enable !== 1'b1))
            Q <= 1'bx;
        else if (enable)
            Q <= DI;
endmodule

// 16 words of 4 bits, written at the clock, read at once.
module TRELLIS_DPR16X4 (
    input wire [3:0] DI, WAD, RAD,
    input wire WRE, WCK,
    output wire [3:0] DO
);
    parameter WCKMUX = "WCK";
    parameter WREMUX = "WRE";
    parameter [63:0] INITVAL = 64'h0;
    ecp5_unknown unknown ();
    reg [3:0] words [0:15];
    integer place;
    initial begin
        for (place = 0; place < 16; place = place + 1)
            words[place] = INITVAL[4 * place +: 4];
        if (WCKMUX != "WCK") unknown.report("TRELLIS_DPR16X4", "WCKMUX");
        if (WREMUX != "WRE") unknown.report("TRELLIS_DPR16X4", "WREMUX");
    end
    always @(posedge WCK)
        if (WRE !== 1'b0)
            words[WAD] <= WRE ? DI : 4'bx;
    assign DO = words[RAD];
endmodule

// A multiplier with registers of its operands and its product, all with CLK0, CE0 and no reset.
module MULT18X18D (
    input wire A0, A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A13, A14, A15, A16, A17,
    input wire B0, B1, B2, B3, B4, B5, B6, B7, B8, B9, B10, B11, B12, B13, B14, B15, B16, B17,
    input wire C0, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, C15, C16, C17,
    input wire SIGNEDA, SIGNEDB, SOURCEA, SOURCEB, CLK0, CE0, RST0,
    output wire P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, P10, P11, P12, P13, P14, P15, P16, P17, P18, P19, P20, P21,
    P22, P23, P24, P25, P26, P27, P28, P29, P30, P31, P32, P33, P34, P35
);
    parameter REG_INPUTA_CLK = "NONE";
    parameter REG_INPUTA_CE = "CE0";
    parameter REG_INPUTA_RST = "RST0";
    parameter REG_INPUTB_CLK = "NONE";
    parameter REG_INPUTB_CE = "CE0";
    parameter REG_INPUTB_RST = "RST0";
    parameter REG_OUTPUT_CLK = "NONE";
    parameter REG_OUTPUT_CE = "CE0";
    parameter REG_OUTPUT_RST = "RST0";
    ecp5_unknown unknown ();
    wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
    wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};
    reg [17:0] held_a = 18'd0;
    reg [17:0] held_b = 18'd0;
    reg [35:0] held_product = 36'd0;
    wire [17:0] left = REG_INPUTA_CLK == "NONE" ? a : held_a;
    wire [17:0] right = REG_INPUTB_CLK == "NONE" ? b : held_b;
    // The sign's own registers follow the operands'; here the signs are constants, and an operand that comes up 0 has none.
    wire signed [35:0] wide_left = {{18{SIGNEDA & left[17]}}, left};
    wire signed [35:0] wide_right = {{18{SIGNEDB & right[17]}}, right};
    wire [35:0] product = wide_left * wide_right;
    wire [35:0] shown = REG_OUTPUT_CLK == "NONE" ? product : held_product;
    assign {P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18, P17, P16, P15,
    P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0} = shown;
    wire clocked = REG_INPUTA_CLK != "NONE" || REG_INPUTB_CLK != "NONE" || REG_OUTPUT_CLK != "NONE";
    initial begin
        if (REG_INPUTA_CLK != "NONE" && REG_INPUTA_CLK != "CLK0") unknown.report("MULT18X18D", "REG_INPUTA_CLK");
        if (REG_INPUTA_CE != "CE0") unknown.report("MULT18X18D", "REG_INPUTA_CE");
        if (REG_INPUTA_RST != "RST0") unknown.report("MULT18X18D", "REG_INPUTA_RST");
        if (REG_INPUTB_CLK != "NONE" && REG_INPUTB_CLK != "CLK0") unknown.report("MULT18X18D", "REG_INPUTB_CLK");
        if (REG_INPUTB_CE != "CE0") unknown.report("MULT18X18D", "REG_INPUTB_CE");
        if (REG_INPUTB_RST != "RST0") unknown.report("MULT18X18D", "REG_INPUTB_RST");
        if (REG_OUTPUT_CLK != "NONE" && REG_OUTPUT_CLK != "CLK0") unknown.report("MULT18X18D", "REG_OUTPUT_CLK");
        if (REG_OUTPUT_CE != "CE0") unknown.report("MULT18X18D", "REG_OUTPUT_CE");
        if (REG_OUTPUT_RST != "RST0") unknown.report("MULT18X18D", "REG_OUTPUT_RST");
        // Constants have their values once the simulation runs.
        #1;
        if (SIGNEDA !== 1'b0 && SIGNEDA !== 1'b1) unknown.report("MULT18X18D", "SIGNEDA");
        if (SIGNEDB !== 1'b0 && SIGNEDB !== 1'b1) unknown.report("MULT18X18D", "SIGNEDB");
        if (SOURCEA !== 1'b0 || SOURCEB !== 1'b0) unknown.report("MULT18X18D", "SOURCEA, SOURCEB");
        if (clocked && RST0 !== 1'b0) unknown.report("MULT18X18D", "RST0");
    end
    // A sign that changes would be late by the registers that are not modelled.
    always @(SIGNEDA or SIGNEDB)
        if ($time > 0) unknown.report("MULT18X18D", "SIGNEDA, SIGNEDB");
    always @(posedge CLK0)
        if (CE0 !== 1'b0) begin
            held_a <= CE0 ? a : 18'bx;
            held_b <= CE0 ? b : 18'bx;
            held_product <= CE0 ? product : 36'bx;
        end
endmodule

// A block RAM: 1024 words of 18 bits, each port 9 or 18 bits wide, or both together 36, port A writing and port B reading. INITVAL_xx
// hold 16 words each, 20 bits apart. The word that is read is held; with OUTREG a second register follows. Widths below 9 are not modelled.
module DP16KD (
    input wire DIA0, DIA1, DIA2, DIA3, DIA4, DIA5, DIA6, DIA7, DIA8, DIA9, DIA10, DIA11, DIA12, DIA13, DIA14, DIA15,
    DIA16, DIA17,
    input wire ADA0, ADA1, ADA2, ADA3, ADA4, ADA5, ADA6, ADA7, ADA8, ADA9, ADA10, ADA11, ADA12, ADA13,
    input wire CEA, OCEA, CLKA, WEA, RSTA, CSA0, CSA1, CSA2,
    input wire DIB0, DIB1, DIB2, DIB3, DIB4, DIB5, DIB6, DIB7, DIB8, DIB9, DIB10, DIB11, DIB12, DIB13, DIB14, DIB15,
    DIB16, DIB17,
    input wire ADB0, ADB1, ADB2, ADB3, ADB4, ADB5, ADB6, ADB7, ADB8, ADB9, ADB10, ADB11, ADB12, ADB13,
    input wire CEB, OCEB, CLKB, WEB, RSTB, CSB0, CSB1, CSB2,
    output wire DOA0, DOA1, DOA2, DOA3, DOA4, DOA5, DOA6, DOA7, DOA8, DOA9, DOA10, DOA11, DOA12, DOA13, DOA14, DOA15,
    DOA16, DOA17,
    output wire DOB0, DOB1, DOB2, DOB3, DOB4, DOB5, DOB6, DOB7, DOB8, DOB9, DOB10, DOB11, DOB12, DOB13, DOB14, DOB15,
    DOB16, DOB17
);
    parameter DATA_WIDTH_A = 18;
    parameter REGMODE_A = "NOREG";
    parameter CLKAMUX = "CLKA";
    parameter CSDECODE_A = "0b000";
    parameter WRITEMODE_A = "NORMAL";
    parameter DATA_WIDTH_B = 18;
    parameter REGMODE_B = "NOREG";
    parameter CLKBMUX = "CLKB";
    parameter CSDECODE_B = "0b000";
    parameter WRITEMODE_B = "NORMAL";
    parameter RESETMODE = "SYNC";
    parameter ASYNC_RESET_RELEASE = "SYNC";
    parameter GSR = "ENABLED";
    parameter INIT_DATA = "STATIC";
    parameter [319:0] INITVAL_00 = 320'd0;
    parameter [319:0] INITVAL_01 = 320'd0;
    parameter [319:0] INITVAL_02 = 320'd0;
    parameter [319:0] INITVAL_03 = 320'd0;
    parameter [319:0] INITVAL_04 = 320'd0;
    parameter [319:0] INITVAL_05 = 320'd0;
    parameter [319:0] INITVAL_06 = 320'd0;
    parameter [319:0] INITVAL_07 = 320'd0;
    parameter [319:0] INITVAL_08 = 320'd0;
    parameter [319:0] INITVAL_09 = 320'd0;
    parameter [319:0] INITVAL_0A = 320'd0;
    parameter [319:0] INITVAL_0B = 320'd0;
    parameter [319:0] INITVAL_0C = 320'd0;
    parameter [319:0] INITVAL_0D = 320'd0;
    parameter [319:0] INITVAL_0E = 320'd0;
    parameter [319:0] INITVAL_0F = 320'd0;
    parameter [319:0] INITVAL_10 = 320'd0;
    parameter [319:0] INITVAL_11 = 320'd0;
    parameter [319:0] INITVAL_12 = 320'd0;
    parameter [319:0] INITVAL_13 = 320'd0;
    parameter [319:0] INITVAL_14 = 320'd0;
    parameter [319:0] INITVAL_15 = 320'd0;
    parameter [319:0] INITVAL_16 = 320'd0;
    parameter [319:0] INITVAL_17 = 320'd0;
    parameter [319:0] INITVAL_18 = 320'd0;
    parameter [319:0] INITVAL_19 = 320'd0;
    parameter [319:0] INITVAL_1A = 320'd0;
    parameter [319:0] INITVAL_1B = 320'd0;
    parameter [319:0] INITVAL_1C = 320'd0;
    parameter [319:0] INITVAL_1D = 320'd0;
    parameter [319:0] INITVAL_1E = 320'd0;
    parameter [319:0] INITVAL_1F = 320'd0;
    parameter [319:0] INITVAL_20 = 320'd0;
    parameter [319:0] INITVAL_21 = 320'd0;
    parameter [319:0] INITVAL_22 = 320'd0;
    parameter [319:0] INITVAL_23 = 320'd0;
    parameter [319:0] INITVAL_24 = 320'd0;
    parameter [319:0] INITVAL_25 = 320'd0;
    parameter [319:0] INITVAL_26 = 320'd0;
    parameter [319:0] INITVAL_27 = 320'd0;
    parameter [319:0] INITVAL_28 = 320'd0;
    parameter [319:0] INITVAL_29 = 320'd0;
    parameter [319:0] INITVAL_2A = 320'd0;
    parameter [319:0] INITVAL_2B = 320'd0;
    parameter [319:0] INITVAL_2C = 320'd0;
    parameter [319:0] INITVAL_2D = 320'd0;
    parameter [319:0] INITVAL_2E = 320'd0;
    parameter [319:0] INITVAL_2F = 320'd0;
    parameter [319:0] INITVAL_30 = 320'd0;
    parameter [319:0] INITVAL_31 = 320'd0;
    parameter [319:0] INITVAL_32 = 320'd0;
    parameter [319:0] INITVAL_33 = 320'd0;
    parameter [319:0] INITVAL_34 = 320'd0;
    parameter [319:0] INITVAL_35 = 320'd0;
    parameter [319:0] INITVAL_36 = 320'd0;
    parameter [319:0] INITVAL_37 = 320'd0;
    parameter [319:0] INITVAL_38 = 320'd0;
    parameter [319:0] INITVAL_39 = 320'd0;
    parameter [319:0] INITVAL_3A = 320'd0;
    parameter [319:0] INITVAL_3B = 320'd0;
    parameter [319:0] INITVAL_3C = 320'd0;
    parameter [319:0] INITVAL_3D = 320'd0;
    parameter [319:0] INITVAL_3E = 320'd0;
    parameter [319:0] INITVAL_3F = 320'd0;
    localparam [20479:0] INITIAL = {INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A,
    INITVAL_39, INITVAL_38, INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32, INITVAL_31,
    INITVAL_30, INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B, INITVAL_2A, INITVAL_29, INITVAL_28,
    INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24, INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20, INITVAL_1F,
    INITVAL_1E, INITVAL_1D, INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18, INITVAL_17, INITVAL_16,
    INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10, INITVAL_0F, INITVAL_0E, INITVAL_0D,
    INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08, INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04,
    INITVAL_03, INITVAL_02, INITVAL_01, INITVAL_00};
    ecp5_unknown unknown ();
    localparam WIDE = DATA_WIDTH_A == 36;
    reg [17:0] words [0:1023];
    integer place;
    wire [13:0] address_a = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0};
    wire [17:0] in_a = {DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4,
    DIA3, DIA2, DIA1, DIA0};
    wire [13:0] address_b = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0};
    wire [17:0] in_b = {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4,
    DIB3, DIB2, DIB1, DIB0};
    wire enable_a = CEA & !(CSA0 | CSA1 | CSA2);
    wire enable_b = CEB & !(CSB0 | CSB1 | CSB2);
    reg [17:0] read_a = 18'd0, read_b = 18'd0, held_a = 18'd0, held_b = 18'd0;
    assign {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2,
    DOA1, DOA0} = REGMODE_A == "OUTREG" ? held_a : read_a;
    assign {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2,
    DOB1, DOB0} = REGMODE_B == "OUTREG" ? held_b : read_b;
    initial begin
        for (place = 0; place < 1024; place = place + 1)
            words[place] = INITIAL[20 * place +: 18];
        if (DATA_WIDTH_A != 1 && DATA_WIDTH_A != 2 && DATA_WIDTH_A != 4 && DATA_WIDTH_A != 9 && DATA_WIDTH_A != 18 && DATA_WIDTH_A != 36)
            unknown.report("DP16KD", "DATA_WIDTH_A");
        if (REGMODE_A != "NOREG" && REGMODE_A != "OUTREG") unknown.report("DP16KD", "REGMODE_A");
        if (CLKAMUX != "CLKA") unknown.report("DP16KD", "CLKAMUX");
        if (CSDECODE_A != "0b000") unknown.report("DP16KD", "CSDECODE_A");
        if (WRITEMODE_A != "NORMAL" && WRITEMODE_A != "READBEFOREWRITE") unknown.report("DP16KD", "WRITEMODE_A");
        if (DATA_WIDTH_B != 1 && DATA_WIDTH_B != 2 && DATA_WIDTH_B != 4 && DATA_WIDTH_B != 9 && DATA_WIDTH_B != 18 && DATA_WIDTH_B != 36)
            unknown.report("DP16KD", "DATA_WIDTH_B");
        if (REGMODE_B != "NOREG" && REGMODE_B != "OUTREG") unknown.report("DP16KD", "REGMODE_B");
        if (CLKBMUX != "CLKB") unknown.report("DP16KD", "CLKBMUX");
        if (CSDECODE_B != "0b000") unknown.report("DP16KD", "CSDECODE_B");
        if (WRITEMODE_B != "NORMAL" && WRITEMODE_B != "READBEFOREWRITE") unknown.report("DP16KD", "WRITEMODE_B");
        if ((DATA_WIDTH_A == 36) != (DATA_WIDTH_B == 36)) unknown.report("DP16KD", "pair of widths");
        if (WIDE && REGMODE_A != REGMODE_B) unknown.report("DP16KD", "pair of REGMODEs");
        if (RESETMODE != "SYNC" && RESETMODE != "ASYNC") unknown.report("DP16KD", "RESETMODE");
        if (ASYNC_RESET_RELEASE != "SYNC" && ASYNC_RESET_RELEASE != "ASYNC") unknown.report("DP16KD", "ASYNC_RESET_RELEASE");
        if (GSR != "DISABLED" && GSR != "AUTO") unknown.report("DP16KD", "GSR");
        if (INIT_DATA != "STATIC") unknown.report("DP16KD", "INIT_DATA");
        // Constants have their values once the simulation runs.
        #1;
        if (RSTA !== 1'b0 || RSTB !== 1'b0) unknown.report("DP16KD", "RSTA, RSTB");
        if (WIDE && WEB !== 1'b0) unknown.report("DP16KD", "WEB");
        if (DATA_WIDTH_A < 9 && WEA !== 1'b0) unknown.report("DP16KD", "WEA of less than a byte");
        if (DATA_WIDTH_B < 9 && WEB !== 1'b0) unknown.report("DP16KD", "WEB of less than a byte");
    end

    // What a port reads at the clock at which the other writes there is undefined.
    wire same = address_a[13:5] == address_b[13:5] && (WIDE || address_a[4] == address_b[4]);
    wire collides_a = enable_b && WEB && CLKB && same;
    wire collides_b = enable_a && WEA && CLKA && same && (DATA_WIDTH_A == 9 || address_a[1:0] != 2'd0 || (WIDE && address_a[3:2] != 2'd0));

    // The word that a port reads, of one with 9 bits its half; of fewer bits a part of eight bits of that, without the
    // ninth.
    function [17:0] narrow;
        input integer width;
        input [13:0] address;
        input [17:0] word;
        reg [8:0] half;
        begin
            half = address[3] ? word[17:9] : word[8:0];
            case (width)
                1: narrow = {17'd0, half[address[2:0]]};
                2: narrow = {16'd0, half[{address[2:1], 1'b0} +: 2]};
                4: narrow = {14'd0, half[{address[2], 2'b00} +: 4]};
                9: narrow = {9'd0, half};
                default: narrow = word;
            endcase
        end
    endfunction

    // A word after a write of the bytes whose bits of `bytes` are 1.
    function [17:0] written;
        input [17:0] word;
        input [17:0] value;
        input [1:0] bytes;
        written = {bytes[1] ? value[17:9] : word[17:9], bytes[0] ? value[8:0] : word[8:0]};
    endfunction

    task write;
        input integer width;
        input [13:0] address;
        input [17:0] value;
        if (width == 9)
            words[address[13:4]] <= written(words[address[13:4]], {value[8:0], value[8:0]}, {address[3], !address[3]});
        else
            words[address[13:4]] <= written(words[address[13:4]], value, address[1:0]);
    endtask

    always @(posedge CLKA) begin
        if (!WIDE && OCEA !== 1'b0)
            held_a <= OCEA ? read_a : 18'bx;
        if (!WIDE && enable_a !== 1'b0 && (WRITEMODE_A == "READBEFOREWRITE" || WEA !== 1'b1))
            read_a <= enable_a && !collides_a ? narrow(DATA_WIDTH_A, address_a, words[address_a[13:4]]) : 18'bx;
        if ((enable_a & WEA) !== 1'b0) begin
            if ((enable_a & WEA) !== 1'b1)
                unknown.report("DP16KD", "undefined write");
            else if (WIDE) begin
                words[{address_a[13:5], 1'b0}] <= written(words[{address_a[13:5], 1'b0}], in_a, address_a[1:0]);
                words[{address_a[13:5], 1'b1}] <= written(words[{address_a[13:5], 1'b1}], in_b, address_a[3:2]);
            end
            else
                write(DATA_WIDTH_A, address_a, in_a);
        end
    end
    always @(posedge CLKB) begin
        if (OCEB !== 1'b0) begin
            held_b <= OCEB ? read_b : 18'bx;
            if (WIDE)
                held_a <= OCEB ? read_a : 18'bx;
        end
        if (enable_b !== 1'b0 && WIDE) begin
            read_a <= enable_b && !collides_b ? words[{address_b[13:5], 1'b0}] : 18'bx;
            read_b <= enable_b && !collides_b ? words[{address_b[13:5], 1'b1}] : 18'bx;
        end
        else if (enable_b !== 1'b0 && (WRITEMODE_B == "READBEFOREWRITE" || WEB !== 1'b1))
            read_b <= enable_b && !collides_b ? narrow(DATA_WIDTH_B, address_b, words[address_b[13:4]]) : 18'bx;
        if (!WIDE && (enable_b & WEB) !== 1'b0) begin
            if ((enable_b & WEB) !== 1'b1)
                unknown.report("DP16KD", "undefined write");
            else
                write(DATA_WIDTH_B, address_b, in_b);
        end
    end
endmodule

`default_nettype wire
