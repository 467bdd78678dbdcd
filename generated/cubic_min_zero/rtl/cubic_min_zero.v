// cubic_min_zero: specular lobe x^n as x max(0, 1 - K u)^2, n = 1 to 127, minimax
//
// Made by: brdfgen generate core.toml
// Spec 2f2c78809c9dfeea. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   wr_addr   UQ7.0   address of the word that is written
//   wr_data   UQ16.0  word for the coefficient memory; layout as in its files
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 10 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.625..+0.750.
//   measured -0.616..+0.746 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   6.806 % absolute, 6.806 % where x^n >= 1/2, 13.124 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module cubic_min_zero (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ7.0: shininess, 1 to 127; outside: the nearest end
    input  wire [6:0] in_n,
    // Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [13:0] in_cos,
    // write enable: takes wr_data into the coefficient memory, whatever ce and rst are
    input  wire        wr_en,
    // UQ7.0: address of the word that is written
    input  wire [6:0] wr_addr,
    // UQ16.0: word for the coefficient memory; layout as in its files
    input  wire [15:0] wr_data,
    // out_spec is a result: in_valid, 10 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [10:1] valid;
    initial valid = 10'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 10'd0;
        end else if (ce) begin
            valid <= {valid[9:1], in_valid};
        end
    end

    // ===== Stage 0: read the ROM, x, u
    // The word of the memory rom, of 128 words.
    reg [15:0] rom_1;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // What is read from an address at the edge at which it is written is not defined: the attribute
    // spares the logic that would make it so.
    (* ramstyle = "no_rw_check" *) reg [15:0] rom [0:127];
    initial begin
        rom[0] = 16'h0000;
        rom[1] = 16'h0000;
        rom[2] = 16'h95f8;
        rom[3] = 16'h8001;
        rom[4] = 16'hafd9;
        rom[5] = 16'hde49;
        rom[6] = 16'h862a;
        rom[7] = 16'h9d12;
        rom[8] = 16'hb3ea;
        rom[9] = 16'hcac2;
        rom[10] = 16'he192;
        rom[11] = 16'hf85a;
        rom[12] = 16'h8793;
        rom[13] = 16'h92fb;
        rom[14] = 16'h9e5b;
        rom[15] = 16'ha9cb;
        rom[16] = 16'hb52b;
        rom[17] = 16'hc08b;
        rom[18] = 16'hcbe3;
        rom[19] = 16'hd753;
        rom[20] = 16'he2bb;
        rom[21] = 16'hee1b;
        rom[22] = 16'hf983;
        rom[23] = 16'h827c;
        rom[24] = 16'h8824;
        rom[25] = 16'h8ddc;
        rom[26] = 16'h938c;
        rom[27] = 16'h993c;
        rom[28] = 16'h9eec;
        rom[29] = 16'ha49c;
        rom[30] = 16'haa54;
        rom[31] = 16'hb004;
        rom[32] = 16'hb5b4;
        rom[33] = 16'hbb64;
        rom[34] = 16'hc11c;
        rom[35] = 16'hc6cc;
        rom[36] = 16'hcc84;
        rom[37] = 16'hd22c;
        rom[38] = 16'hd7e4;
        rom[39] = 16'hdd84;
        rom[40] = 16'he344;
        rom[41] = 16'he8fc;
        rom[42] = 16'heeac;
        rom[43] = 16'hf454;
        rom[44] = 16'hfa0c;
        rom[45] = 16'hffbc;
        rom[46] = 16'h82b5;
        rom[47] = 16'h858d;
        rom[48] = 16'h8865;
        rom[49] = 16'h8b3d;
        rom[50] = 16'h8e1d;
        rom[51] = 16'h90f5;
        rom[52] = 16'h93cd;
        rom[53] = 16'h96a5;
        rom[54] = 16'h997d;
        rom[55] = 16'h9c55;
        rom[56] = 16'h9f2d;
        rom[57] = 16'ha20d;
        rom[58] = 16'ha4ed;
        rom[59] = 16'ha7b5;
        rom[60] = 16'haa95;
        rom[61] = 16'had6d;
        rom[62] = 16'hb045;
        rom[63] = 16'hb325;
        rom[64] = 16'hb5f5;
        rom[65] = 16'hb8c5;
        rom[66] = 16'hbba5;
        rom[67] = 16'hbe85;
        rom[68] = 16'hc15d;
        rom[69] = 16'hc435;
        rom[70] = 16'hc70d;
        rom[71] = 16'hc9e5;
        rom[72] = 16'hccbd;
        rom[73] = 16'hcf95;
        rom[74] = 16'hd26d;
        rom[75] = 16'hd545;
        rom[76] = 16'hd81d;
        rom[77] = 16'hdafd;
        rom[78] = 16'hddd5;
        rom[79] = 16'he0a5;
        rom[80] = 16'he37d;
        rom[81] = 16'he655;
        rom[82] = 16'he93d;
        rom[83] = 16'hec15;
        rom[84] = 16'heee5;
        rom[85] = 16'hf1c5;
        rom[86] = 16'hf495;
        rom[87] = 16'hf775;
        rom[88] = 16'hfa45;
        rom[89] = 16'hfd25;
        rom[90] = 16'hfffd;
        rom[91] = 16'h816e;
        rom[92] = 16'h82d6;
        rom[93] = 16'h843e;
        rom[94] = 16'h85be;
        rom[95] = 16'h8726;
        rom[96] = 16'h888e;
        rom[97] = 16'h89f6;
        rom[98] = 16'h8b66;
        rom[99] = 16'h8cce;
        rom[100] = 16'h8e36;
        rom[101] = 16'h8fae;
        rom[102] = 16'h9116;
        rom[103] = 16'h9286;
        rom[104] = 16'h93f6;
        rom[105] = 16'h9556;
        rom[106] = 16'h96ce;
        rom[107] = 16'h9836;
        rom[108] = 16'h99a6;
        rom[109] = 16'h9b0e;
        rom[110] = 16'h9c7e;
        rom[111] = 16'h9de6;
        rom[112] = 16'h9f4e;
        rom[113] = 16'ha0be;
        rom[114] = 16'ha22e;
        rom[115] = 16'ha396;
        rom[116] = 16'ha506;
        rom[117] = 16'ha66e;
        rom[118] = 16'ha7de;
        rom[119] = 16'ha946;
        rom[120] = 16'haab6;
        rom[121] = 16'hac26;
        rom[122] = 16'had8e;
        rom[123] = 16'haefe;
        rom[124] = 16'hb066;
        rom[125] = 16'hb1d6;
        rom[126] = 16'hb33e;
        rom[127] = 16'hb4ae;
    end
    always @(posedge clk) begin
        if (wr_en) rom[wr_addr] <= wr_data;
    end
    always @(posedge clk) begin
        if (ce) rom_1 <= rom[in_n];
    end
    reg [12:0] x_1;
    reg [12:0] u_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            u_1 <= u_0;
        end
    end

    // ===== Stage 1: registers only
    // UQ0.13: the coefficient A, times 2^-k
    wire [12:0] big_a_1 = rom_1[15:3];
    // UQ3.0: shift of the versine
    wire [2:0] k_1 = rom_1[2:0];
    reg [12:0] x_2;
    reg [12:0] u_2;
    reg [12:0] big_a_2;
    reg [2:0] k_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            u_2 <= u_1;
            big_a_2 <= big_a_1;
            k_2 <= k_1;
        end
    end

    // ===== Stage 2: registers only
    reg [12:0] x_3;
    reg [12:0] u_3;
    reg [12:0] big_a_3;
    reg [2:0] k_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            u_3 <= u_2;
            big_a_3 <= big_a_2;
            k_3 <= k_2;
        end
    end

    // ===== Stage 3: u_scaled
    // UQ7.12: u 2^k
    wire [18:0] u_scaled_3 = {6'd0, u_3} << k_3;
    // UQ7.-1: u 2^k >= 2: then A u >= 1, since A 2^-k >= 1/2
    wire [5:0] beyond_bits_3 = u_scaled_3[18:13];
    // UQ1.0: u 2^k >= 2: then A u >= 1, since A 2^-k >= 1/2
    wire beyond_3 = |beyond_bits_3;
    // UQ1.12: v = u 2^k, rounded down
    wire [12:0] v_3 = u_scaled_3[12:0];
    reg [12:0] x_4;
    reg [12:0] big_a_4;
    reg beyond_4;
    reg [12:0] v_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            big_a_4 <= big_a_3;
            beyond_4 <= beyond_3;
            v_4 <= v_3;
        end
    end

    // ===== Stage 4: registers only
    reg [12:0] x_5;
    reg [12:0] big_a_5;
    reg beyond_5;
    reg [12:0] v_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            big_a_5 <= big_a_4;
            beyond_5 <= beyond_4;
            v_5 <= v_4;
        end
    end

    // ===== Stage 5: Av
    // UQ1.25: A u = (A 2^-k) v
    wire [25:0] Av_5 = big_a_5 * v_5;
    // UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    wire p_above_bits_5 = Av_5[25];
    // UQ0.15: p, rounded down
    wire [14:0] p_5 = Av_5[24:10];
    reg [12:0] x_6;
    reg beyond_6;
    reg p_above_bits_6;
    reg [14:0] p_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            beyond_6 <= beyond_5;
            p_above_bits_6 <= p_above_bits_5;
            p_6 <= p_5;
        end
    end

    // ===== Stage 6: w
    // UQ1.15: w = 1 - p
    wire [15:0] w_6 = 16'h8000 - {1'd0, p_6};
    // UQ1.0: the result is 0
    wire zero_6 = beyond_6 | p_above_bits_6;
    reg [12:0] x_7;
    reg [15:0] w_7;
    reg zero_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            w_7 <= w_6;
            zero_7 <= zero_6;
        end
    end

    // ===== Stage 7: w2
    // UQ2.30: w^2
    wire [31:0] w2_7 = w_7 * w_7;
    // UQ1.15: w^2, rounded down
    wire [15:0] w2_cut_7 = w2_7[30:15];
    reg [12:0] x_8;
    reg [15:0] w2_cut_8;
    reg zero_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            w2_cut_8 <= w2_cut_7;
            zero_8 <= zero_7;
        end
    end

    // ===== Stage 8: xw
    // UQ2.27: x w^2
    wire [28:0] xw_8 = x_8 * w2_cut_8;
    reg [28:0] xw_9;
    reg zero_9;
    always @(posedge clk) begin
        if (ce) begin
            xw_9 <= xw_8;
            zero_9 <= zero_8;
        end
    end

    // ===== Stage 9: y_half, y
    // UQ1.27: plus half an output ulp: the result is rounded to nearest
    wire [27:0] y_half_9 = xw_9[27:0] + 28'h0004000;
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_cut_9 = y_half_9[27:15];
    // UQ1.12: y, 0 where the lobe has ended
    wire [12:0] y_9 = zero_9 ? 13'd0 : y_cut_9;
    reg [12:0] y_10;
    always @(posedge clk) begin
        if (ce) begin
            y_10 <= y_9;
        end
    end

    assign out_valid = valid[10];
    assign out_spec  = y_10;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    Av_5[9:0],
                    w2_7[31],
                    w2_7[14:0],
                    xw_9[28],
                    y_half_9[14:0]};

endmodule

`default_nettype wire
