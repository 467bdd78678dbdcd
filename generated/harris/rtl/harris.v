// harris: specular lobe x^n as 2^(-n L(x)), L and 2^-f from tables, n = 1 to 127
//
// Made by: brdfgen generate core.toml
// Spec c97a03138728f208. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
//
// Latency 13 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.747..+0.740.
//   measured -0.497..+0.732 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   1.758 % absolute, 1.430 % where x^n >= 1/2, 2.766 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module harris (
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
    // out_spec is a result: in_valid, 13 enabled clocks later
    output wire        out_valid,
    // UQ1.10: the lobe, 0 to 1; 1.0 is exact
    output wire [10:0] out_spec
);

    // ===== Valid chain
    reg [13:1] valid;
    initial valid = 13'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 13'd0;
        end else if (ce) begin
            valid <= {valid[12:1], in_valid};
        end
    end

    // ===== Stage 0: n, x, u
    // UQ7.0: in_n taken into the range
    wire [6:0] n_0 = (in_n < 7'h01) ? 7'h01 : in_n;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ1.0: the versine lies in one of the table's octaves
    wire in_octaves_0 = |u_0;
    // UQ0.8: a bit of weight 2^-8 or more is set
    wire [7:0] m_above_8_bits_0 = u_0[11:4];
    // UQ1.0: a bit of weight 2^-8 or more is set
    wire m_above_8_0 = |m_above_8_bits_0;
    // UQ9.4: shifted
    wire [12:0] m_by_8_0 = u_0;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_8_0 = {m_by_8_0[3:0], 8'd0};
    // UQ1.0: u = 1: the surface faces away
    wire dark_bits_0 = u_0[12];
    reg [6:0] n_1;
    reg [12:0] u_1;
    reg in_octaves_1;
    reg m_above_8_1;
    reg [11:0] m_moved_8_1;
    reg dark_bits_1;
    always @(posedge clk) begin
        if (ce) begin
            n_1 <= n_0;
            u_1 <= u_0;
            in_octaves_1 <= in_octaves_0;
            m_above_8_1 <= m_above_8_0;
            m_moved_8_1 <= m_moved_8_0;
            dark_bits_1 <= dark_bits_0;
        end
    end

    // ===== Stage 1: m_8, m_4, m_2, octave_4
    // UQ1.0: x is 1, or so near to it that L counts as 0
    wire top_1 = ~in_octaves_1;
    // UQ1.12: shifted to the left by 8 where that loses no bit
    wire [12:0] m_8_1 = m_above_8_1 ? u_1 : {1'd0, m_moved_8_1};
    // UQ0.4: a bit of weight 2^-4 or more is set
    wire [3:0] m_above_4_bits_1 = m_8_1[11:8];
    // UQ1.0: a bit of weight 2^-4 or more is set
    wire m_above_4_1 = |m_above_4_bits_1;
    // UQ5.8: shifted
    wire [12:0] m_by_4_1 = m_8_1;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_4_1 = {m_by_4_1[7:0], 4'd0};
    // UQ1.12: shifted to the left by 4 where that loses no bit
    wire [12:0] m_4_1 = m_above_4_1 ? m_8_1 : {1'd0, m_moved_4_1};
    // UQ0.2: a bit of weight 2^-2 or more is set
    wire [1:0] m_above_2_bits_1 = m_4_1[11:10];
    // UQ1.0: a bit of weight 2^-2 or more is set
    wire m_above_2_1 = |m_above_2_bits_1;
    // UQ3.10: shifted
    wire [12:0] m_by_2_1 = m_4_1;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_2_1 = {m_by_2_1[9:0], 2'd0};
    // UQ1.12: shifted to the left by 2 where that loses no bit
    wire [12:0] m_2_1 = m_above_2_1 ? m_4_1 : {1'd0, m_moved_2_1};
    // UQ0.1: a bit of weight 2^-1 or more is set
    wire m_above_1_bits_1 = m_2_1[11];
    // UQ2.11: shifted
    wire [12:0] m_by_1_1 = m_2_1;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_1_1 = {m_by_1_1[10:0], 1'd0};
    // UQ1.0: this step of the shift was taken
    wire taken_8_1 = ~m_above_8_1;
    // UQ4.-3: its part of the octave
    wire part_8_1 = taken_8_1;
    // UQ1.0: this step of the shift was taken
    wire taken_4_1 = ~m_above_4_1;
    // UQ3.-2: its part of the octave
    wire part_4_1 = taken_4_1;
    // UQ4.-2: the octave: how far the versine was shifted
    wire [1:0] octave_4_1 = {part_8_1, 1'd0} + {1'd0, part_4_1};
    // UQ1.0: this step of the shift was taken
    wire taken_2_1 = ~m_above_2_1;
    // UQ2.-1: its part of the octave
    wire part_2_1 = taken_2_1;
    reg [6:0] n_2;
    reg top_2;
    reg [12:0] m_2_2;
    reg m_above_1_bits_2;
    reg [11:0] m_moved_1_2;
    reg [1:0] octave_4_2;
    reg part_2_2;
    reg dark_bits_2;
    always @(posedge clk) begin
        if (ce) begin
            n_2 <= n_1;
            top_2 <= top_1;
            m_2_2 <= m_2_1;
            m_above_1_bits_2 <= m_above_1_bits_1;
            m_moved_1_2 <= m_moved_1_1;
            octave_4_2 <= octave_4_1;
            part_2_2 <= part_2_1;
            dark_bits_2 <= dark_bits_1;
        end
    end

    // ===== Stage 2: m_1, octave_2, octave_1
    // UQ1.0: a bit of weight 2^-1 or more is set
    wire m_above_1_2 = |m_above_1_bits_2;
    // UQ1.12: shifted to the left by 1 where that loses no bit
    wire [12:0] m_1_2 = m_above_1_2 ? m_2_2 : {1'd0, m_moved_1_2};
    // UQ-1.5: where in its octave the versine lies
    wire [3:0] cell_2 = m_1_2[10:7];
    // UQ4.0: as a number
    wire [3:0] cell_number_2 = cell_2;
    // UQ4.-1: the octave: how far the versine was shifted
    wire [2:0] octave_2_2 = {octave_4_2, 1'd0} + {2'd0, part_2_2};
    // UQ1.0: this step of the shift was taken
    wire taken_1_2 = ~m_above_1_2;
    // UQ1.0: its part of the octave
    wire part_1_2 = taken_1_2;
    // UQ4.0: the octave: how far the versine was shifted
    wire [3:0] octave_1_2 = {octave_2_2, 1'd0} + {3'd0, part_1_2};
    // UQ8.-4: the address of the row's first part
    wire [3:0] address_of_parts_2 = octave_1_2;
    reg [6:0] n_3;
    reg top_3;
    reg [3:0] cell_number_3;
    reg [3:0] address_of_parts_3;
    reg dark_bits_3;
    always @(posedge clk) begin
        if (ce) begin
            n_3 <= n_2;
            top_3 <= top_2;
            cell_number_3 <= cell_number_2;
            address_of_parts_3 <= address_of_parts_2;
            dark_bits_3 <= dark_bits_2;
        end
    end

    // ===== Stage 3: part_address
    // UQ8.0: the address of the part
    wire [7:0] part_address_3 = {address_of_parts_3, 4'd0} + {4'd0, cell_number_3};
    reg [6:0] n_4;
    reg top_4;
    reg [7:0] part_address_4;
    reg dark_bits_4;
    always @(posedge clk) begin
        if (ce) begin
            n_4 <= n_3;
            top_4 <= top_3;
            part_address_4 <= part_address_3;
            dark_bits_4 <= dark_bits_3;
        end
    end

    // ===== Stage 4: read log_table
    // The word of the memory log_table, of 256 words.
    reg [16:0] log_table_5;
    always @(posedge clk) begin
        if (ce) begin
            case (part_address_4)
                8'd0: log_table_5 <= 17'h042e8;
                8'd1: log_table_5 <= 17'h04910;
                8'd2: log_table_5 <= 17'h04fa9;
                8'd3: log_table_5 <= 17'h056c4;
                8'd4: log_table_5 <= 17'h05e76;
                8'd5: log_table_5 <= 17'h066db;
                8'd6: log_table_5 <= 17'h07018;
                8'd7: log_table_5 <= 17'h07a5c;
                8'd8: log_table_5 <= 17'h085e9;
                8'd9: log_table_5 <= 17'h0931e;
                8'd10: log_table_5 <= 17'h0a288;
                8'd11: log_table_5 <= 17'h0b50b;
                8'd12: log_table_5 <= 17'h0cc3a;
                8'd13: log_table_5 <= 17'h0eb41;
                8'd14: log_table_5 <= 17'h11a52;
                8'd15: log_table_5 <= 17'h17f48;
                8'd16: log_table_5 <= 17'h01b84;
                8'd17: log_table_5 <= 17'h01d7a;
                8'd18: log_table_5 <= 17'h01f7c;
                8'd19: log_table_5 <= 17'h02189;
                8'd20: log_table_5 <= 17'h023a3;
                8'd21: log_table_5 <= 17'h025c8;
                8'd22: log_table_5 <= 17'h027fb;
                8'd23: log_table_5 <= 17'h02a3b;
                8'd24: log_table_5 <= 17'h02c8a;
                8'd25: log_table_5 <= 17'h02ee8;
                8'd26: log_table_5 <= 17'h03156;
                8'd27: log_table_5 <= 17'h033d5;
                8'd28: log_table_5 <= 17'h03665;
                8'd29: log_table_5 <= 17'h03909;
                8'd30: log_table_5 <= 17'h03bc0;
                8'd31: log_table_5 <= 17'h03e8c;
                8'd32: log_table_5 <= 17'h00cbb;
                8'd33: log_table_5 <= 17'h00d90;
                8'd34: log_table_5 <= 17'h00e67;
                8'd35: log_table_5 <= 17'h00f3f;
                8'd36: log_table_5 <= 17'h0101a;
                8'd37: log_table_5 <= 17'h010f7;
                8'd38: log_table_5 <= 17'h011d6;
                8'd39: log_table_5 <= 17'h012b7;
                8'd40: log_table_5 <= 17'h0139a;
                8'd41: log_table_5 <= 17'h01480;
                8'd42: log_table_5 <= 17'h01567;
                8'd43: log_table_5 <= 17'h01651;
                8'd44: log_table_5 <= 17'h0173e;
                8'd45: log_table_5 <= 17'h0182d;
                8'd46: log_table_5 <= 17'h0191e;
                8'd47: log_table_5 <= 17'h01a11;
                8'd48: log_table_5 <= 17'h00624;
                8'd49: log_table_5 <= 17'h00687;
                8'd50: log_table_5 <= 17'h006ea;
                8'd51: log_table_5 <= 17'h0074e;
                8'd52: log_table_5 <= 17'h007b2;
                8'd53: log_table_5 <= 17'h00816;
                8'd54: log_table_5 <= 17'h0087b;
                8'd55: log_table_5 <= 17'h008e1;
                8'd56: log_table_5 <= 17'h00947;
                8'd57: log_table_5 <= 17'h009ad;
                8'd58: log_table_5 <= 17'h00a14;
                8'd59: log_table_5 <= 17'h00a7b;
                8'd60: log_table_5 <= 17'h00ae3;
                8'd61: log_table_5 <= 17'h00b4b;
                8'd62: log_table_5 <= 17'h00bb3;
                8'd63: log_table_5 <= 17'h00c1c;
                8'd64: log_table_5 <= 17'h00303;
                8'd65: log_table_5 <= 17'h00333;
                8'd66: log_table_5 <= 17'h00363;
                8'd67: log_table_5 <= 17'h00393;
                8'd68: log_table_5 <= 17'h003c3;
                8'd69: log_table_5 <= 17'h003f3;
                8'd70: log_table_5 <= 17'h00423;
                8'd71: log_table_5 <= 17'h00454;
                8'd72: log_table_5 <= 17'h00484;
                8'd73: log_table_5 <= 17'h004b5;
                8'd74: log_table_5 <= 17'h004e5;
                8'd75: log_table_5 <= 17'h00516;
                8'd76: log_table_5 <= 17'h00547;
                8'd77: log_table_5 <= 17'h00578;
                8'd78: log_table_5 <= 17'h005a9;
                8'd79: log_table_5 <= 17'h005da;
                8'd80: log_table_5 <= 17'h0017d;
                8'd81: log_table_5 <= 17'h00195;
                8'd82: log_table_5 <= 17'h001ac;
                8'd83: log_table_5 <= 17'h001c4;
                8'd84: log_table_5 <= 17'h001db;
                8'd85: log_table_5 <= 17'h001f3;
                8'd86: log_table_5 <= 17'h0020a;
                8'd87: log_table_5 <= 17'h00222;
                8'd88: log_table_5 <= 17'h00239;
                8'd89: log_table_5 <= 17'h00251;
                8'd90: log_table_5 <= 17'h00269;
                8'd91: log_table_5 <= 17'h00281;
                8'd92: log_table_5 <= 17'h00298;
                8'd93: log_table_5 <= 17'h002b0;
                8'd94: log_table_5 <= 17'h002c8;
                8'd95: log_table_5 <= 17'h002e0;
                8'd96: log_table_5 <= 17'h000bc;
                8'd97: log_table_5 <= 17'h000c8;
                8'd98: log_table_5 <= 17'h000d4;
                8'd99: log_table_5 <= 17'h000df;
                8'd100: log_table_5 <= 17'h000eb;
                8'd101: log_table_5 <= 17'h000f7;
                8'd102: log_table_5 <= 17'h00102;
                8'd103: log_table_5 <= 17'h0010e;
                8'd104: log_table_5 <= 17'h0011a;
                8'd105: log_table_5 <= 17'h00125;
                8'd106: log_table_5 <= 17'h00131;
                8'd107: log_table_5 <= 17'h0013d;
                8'd108: log_table_5 <= 17'h00148;
                8'd109: log_table_5 <= 17'h00154;
                8'd110: log_table_5 <= 17'h00160;
                8'd111: log_table_5 <= 17'h0016b;
                8'd112: log_table_5 <= 17'h0005d;
                8'd113: log_table_5 <= 17'h00062;
                8'd114: log_table_5 <= 17'h00068;
                8'd115: log_table_5 <= 17'h0006e;
                8'd116: log_table_5 <= 17'h00074;
                8'd117: log_table_5 <= 17'h00079;
                8'd118: log_table_5 <= 17'h0007f;
                8'd119: log_table_5 <= 17'h00085;
                8'd120: log_table_5 <= 17'h0008b;
                8'd121: log_table_5 <= 17'h00091;
                8'd122: log_table_5 <= 17'h00097;
                8'd123: log_table_5 <= 17'h0009c;
                8'd124: log_table_5 <= 17'h000a2;
                8'd125: log_table_5 <= 17'h000a8;
                8'd126: log_table_5 <= 17'h000ae;
                8'd127: log_table_5 <= 17'h000b4;
                8'd128: log_table_5 <= 17'h0002e;
                8'd129: log_table_5 <= 17'h00034;
                8'd130: log_table_5 <= 17'h00034;
                8'd131: log_table_5 <= 17'h0003a;
                8'd132: log_table_5 <= 17'h0003a;
                8'd133: log_table_5 <= 17'h00040;
                8'd134: log_table_5 <= 17'h00040;
                8'd135: log_table_5 <= 17'h00045;
                8'd136: log_table_5 <= 17'h00045;
                8'd137: log_table_5 <= 17'h0004b;
                8'd138: log_table_5 <= 17'h0004b;
                8'd139: log_table_5 <= 17'h00051;
                8'd140: log_table_5 <= 17'h00051;
                8'd141: log_table_5 <= 17'h00057;
                8'd142: log_table_5 <= 17'h00057;
                8'd143: log_table_5 <= 17'h0005d;
                8'd144: log_table_5 <= 17'h00017;
                8'd145: log_table_5 <= 17'h0001d;
                8'd146: log_table_5 <= 17'h0001d;
                8'd147: log_table_5 <= 17'h0001d;
                8'd148: log_table_5 <= 17'h0001d;
                8'd149: log_table_5 <= 17'h00023;
                8'd150: log_table_5 <= 17'h00023;
                8'd151: log_table_5 <= 17'h00023;
                8'd152: log_table_5 <= 17'h00023;
                8'd153: log_table_5 <= 17'h00028;
                8'd154: log_table_5 <= 17'h00028;
                8'd155: log_table_5 <= 17'h00028;
                8'd156: log_table_5 <= 17'h00028;
                8'd157: log_table_5 <= 17'h0002e;
                8'd158: log_table_5 <= 17'h0002e;
                8'd159: log_table_5 <= 17'h0002e;
                8'd160: log_table_5 <= 17'h0000c;
                8'd161: log_table_5 <= 17'h00011;
                8'd162: log_table_5 <= 17'h00011;
                8'd163: log_table_5 <= 17'h00011;
                8'd164: log_table_5 <= 17'h00011;
                8'd165: log_table_5 <= 17'h00011;
                8'd166: log_table_5 <= 17'h00011;
                8'd167: log_table_5 <= 17'h00011;
                8'd168: log_table_5 <= 17'h00011;
                8'd169: log_table_5 <= 17'h00017;
                8'd170: log_table_5 <= 17'h00017;
                8'd171: log_table_5 <= 17'h00017;
                8'd172: log_table_5 <= 17'h00017;
                8'd173: log_table_5 <= 17'h00017;
                8'd174: log_table_5 <= 17'h00017;
                8'd175: log_table_5 <= 17'h00017;
                8'd176: log_table_5 <= 17'h00006;
                8'd177: log_table_5 <= 17'h0000c;
                8'd178: log_table_5 <= 17'h0000c;
                8'd179: log_table_5 <= 17'h0000c;
                8'd180: log_table_5 <= 17'h0000c;
                8'd181: log_table_5 <= 17'h0000c;
                8'd182: log_table_5 <= 17'h0000c;
                8'd183: log_table_5 <= 17'h0000c;
                8'd184: log_table_5 <= 17'h0000c;
                8'd185: log_table_5 <= 17'h0000c;
                8'd186: log_table_5 <= 17'h0000c;
                8'd187: log_table_5 <= 17'h0000c;
                8'd188: log_table_5 <= 17'h0000c;
                8'd189: log_table_5 <= 17'h0000c;
                8'd190: log_table_5 <= 17'h0000c;
                8'd191: log_table_5 <= 17'h0000c;
                8'd192: log_table_5 <= 17'h0000c;
                8'd193: log_table_5 <= 17'h0000c;
                8'd194: log_table_5 <= 17'h0000c;
                8'd195: log_table_5 <= 17'h0000c;
                8'd196: log_table_5 <= 17'h0000c;
                8'd197: log_table_5 <= 17'h0000c;
                8'd198: log_table_5 <= 17'h0000c;
                8'd199: log_table_5 <= 17'h0000c;
                8'd200: log_table_5 <= 17'h0000c;
                8'd201: log_table_5 <= 17'h0000c;
                8'd202: log_table_5 <= 17'h0000c;
                8'd203: log_table_5 <= 17'h0000c;
                8'd204: log_table_5 <= 17'h0000c;
                8'd205: log_table_5 <= 17'h0000c;
                8'd206: log_table_5 <= 17'h0000c;
                8'd207: log_table_5 <= 17'h0000c;
                8'd208: log_table_5 <= 17'h0000c;
                8'd209: log_table_5 <= 17'h0000c;
                8'd210: log_table_5 <= 17'h0000c;
                8'd211: log_table_5 <= 17'h0000c;
                8'd212: log_table_5 <= 17'h0000c;
                8'd213: log_table_5 <= 17'h0000c;
                8'd214: log_table_5 <= 17'h0000c;
                8'd215: log_table_5 <= 17'h0000c;
                8'd216: log_table_5 <= 17'h0000c;
                8'd217: log_table_5 <= 17'h0000c;
                8'd218: log_table_5 <= 17'h0000c;
                8'd219: log_table_5 <= 17'h0000c;
                8'd220: log_table_5 <= 17'h0000c;
                8'd221: log_table_5 <= 17'h0000c;
                8'd222: log_table_5 <= 17'h0000c;
                8'd223: log_table_5 <= 17'h0000c;
                8'd224: log_table_5 <= 17'h0000c;
                8'd225: log_table_5 <= 17'h0000c;
                8'd226: log_table_5 <= 17'h0000c;
                8'd227: log_table_5 <= 17'h0000c;
                8'd228: log_table_5 <= 17'h0000c;
                8'd229: log_table_5 <= 17'h0000c;
                8'd230: log_table_5 <= 17'h0000c;
                8'd231: log_table_5 <= 17'h0000c;
                8'd232: log_table_5 <= 17'h0000c;
                8'd233: log_table_5 <= 17'h0000c;
                8'd234: log_table_5 <= 17'h0000c;
                8'd235: log_table_5 <= 17'h0000c;
                8'd236: log_table_5 <= 17'h0000c;
                8'd237: log_table_5 <= 17'h0000c;
                8'd238: log_table_5 <= 17'h0000c;
                8'd239: log_table_5 <= 17'h0000c;
                8'd240: log_table_5 <= 17'h0000c;
                8'd241: log_table_5 <= 17'h0000c;
                8'd242: log_table_5 <= 17'h0000c;
                8'd243: log_table_5 <= 17'h0000c;
                8'd244: log_table_5 <= 17'h0000c;
                8'd245: log_table_5 <= 17'h0000c;
                8'd246: log_table_5 <= 17'h0000c;
                8'd247: log_table_5 <= 17'h0000c;
                8'd248: log_table_5 <= 17'h0000c;
                8'd249: log_table_5 <= 17'h0000c;
                8'd250: log_table_5 <= 17'h0000c;
                8'd251: log_table_5 <= 17'h0000c;
                8'd252: log_table_5 <= 17'h0000c;
                8'd253: log_table_5 <= 17'h0000c;
                8'd254: log_table_5 <= 17'h0000c;
                8'd255: log_table_5 <= 17'h0000c;
                default: log_table_5 <= 17'h042e8;
            endcase
        end
    end
    reg [6:0] n_5;
    reg top_5;
    reg dark_bits_5;
    always @(posedge clk) begin
        if (ce) begin
            n_5 <= n_4;
            top_5 <= top_4;
            dark_bits_5 <= dark_bits_4;
        end
    end

    // ===== Stage 5: registers only
    // UQ3.14: L = -log2 x midway in the cell
    wire [16:0] log_5 = log_table_5;
    reg [6:0] n_6;
    reg top_6;
    reg [16:0] log_6;
    reg dark_bits_6;
    always @(posedge clk) begin
        if (ce) begin
            n_6 <= n_5;
            top_6 <= top_5;
            log_6 <= log_5;
            dark_bits_6 <= dark_bits_5;
        end
    end

    // ===== Stage 6: registers only
    reg [6:0] n_7;
    reg top_7;
    reg [16:0] log_7;
    reg dark_bits_7;
    always @(posedge clk) begin
        if (ce) begin
            n_7 <= n_6;
            top_7 <= top_6;
            log_7 <= log_6;
            dark_bits_7 <= dark_bits_6;
        end
    end

    // ===== Stage 7: L
    // UQ3.14: L = -log2 x
    wire [16:0] L_7 = top_7 ? 17'd0 : log_7;
    reg [6:0] n_8;
    reg [16:0] L_8;
    reg dark_bits_8;
    always @(posedge clk) begin
        if (ce) begin
            n_8 <= n_7;
            L_8 <= L_7;
            dark_bits_8 <= dark_bits_7;
        end
    end

    // ===== Stage 8: z
    // UQ10.14: z = n L
    wire [23:0] z_8 = n_8 * L_8;
    // UQ10.-4: z is past what the result can show
    wire [5:0] over_bits_8 = z_8[23:18];
    // UQ4.0: the integer part of z
    wire [3:0] i_8 = z_8[17:14];
    // UQ0.6: the leading bits of the fraction of z
    wire [5:0] f_8 = z_8[13:8];
    // UQ6.0: the entry of the second table
    wire [5:0] entry_8 = f_8;
    reg [5:0] over_bits_9;
    reg [3:0] i_9;
    reg [5:0] entry_9;
    reg dark_bits_9;
    always @(posedge clk) begin
        if (ce) begin
            over_bits_9 <= over_bits_8;
            i_9 <= i_8;
            entry_9 <= entry_8;
            dark_bits_9 <= dark_bits_8;
        end
    end

    // ===== Stage 9: read exp_table
    // The word of the memory exp_table, of 64 words.
    reg [10:0] exp_table_10;
    // UQ1.0: z is past what the result can show
    wire over_9 = |over_bits_9;
    // UQ1.0: the result is 0
    wire zero_9 = dark_bits_9 | over_9;
    always @(posedge clk) begin
        if (ce) begin
            case (entry_9)
                6'd0: exp_table_10 <= 11'h7f5;
                6'd1: exp_table_10 <= 11'h7df;
                6'd2: exp_table_10 <= 11'h7c9;
                6'd3: exp_table_10 <= 11'h7b4;
                6'd4: exp_table_10 <= 11'h79f;
                6'd5: exp_table_10 <= 11'h78a;
                6'd6: exp_table_10 <= 11'h775;
                6'd7: exp_table_10 <= 11'h760;
                6'd8: exp_table_10 <= 11'h74c;
                6'd9: exp_table_10 <= 11'h738;
                6'd10: exp_table_10 <= 11'h724;
                6'd11: exp_table_10 <= 11'h710;
                6'd12: exp_table_10 <= 11'h6fd;
                6'd13: exp_table_10 <= 11'h6e9;
                6'd14: exp_table_10 <= 11'h6d6;
                6'd15: exp_table_10 <= 11'h6c4;
                6'd16: exp_table_10 <= 11'h6b1;
                6'd17: exp_table_10 <= 11'h69e;
                6'd18: exp_table_10 <= 11'h68c;
                6'd19: exp_table_10 <= 11'h67a;
                6'd20: exp_table_10 <= 11'h668;
                6'd21: exp_table_10 <= 11'h657;
                6'd22: exp_table_10 <= 11'h645;
                6'd23: exp_table_10 <= 11'h634;
                6'd24: exp_table_10 <= 11'h623;
                6'd25: exp_table_10 <= 11'h612;
                6'd26: exp_table_10 <= 11'h601;
                6'd27: exp_table_10 <= 11'h5f1;
                6'd28: exp_table_10 <= 11'h5e0;
                6'd29: exp_table_10 <= 11'h5d0;
                6'd30: exp_table_10 <= 11'h5c0;
                6'd31: exp_table_10 <= 11'h5b0;
                6'd32: exp_table_10 <= 11'h5a0;
                6'd33: exp_table_10 <= 11'h591;
                6'd34: exp_table_10 <= 11'h582;
                6'd35: exp_table_10 <= 11'h572;
                6'd36: exp_table_10 <= 11'h563;
                6'd37: exp_table_10 <= 11'h554;
                6'd38: exp_table_10 <= 11'h546;
                6'd39: exp_table_10 <= 11'h537;
                6'd40: exp_table_10 <= 11'h529;
                6'd41: exp_table_10 <= 11'h51b;
                6'd42: exp_table_10 <= 11'h50d;
                6'd43: exp_table_10 <= 11'h4ff;
                6'd44: exp_table_10 <= 11'h4f1;
                6'd45: exp_table_10 <= 11'h4e3;
                6'd46: exp_table_10 <= 11'h4d6;
                6'd47: exp_table_10 <= 11'h4c8;
                6'd48: exp_table_10 <= 11'h4bb;
                6'd49: exp_table_10 <= 11'h4ae;
                6'd50: exp_table_10 <= 11'h4a1;
                6'd51: exp_table_10 <= 11'h494;
                6'd52: exp_table_10 <= 11'h488;
                6'd53: exp_table_10 <= 11'h47b;
                6'd54: exp_table_10 <= 11'h46f;
                6'd55: exp_table_10 <= 11'h463;
                6'd56: exp_table_10 <= 11'h457;
                6'd57: exp_table_10 <= 11'h44b;
                6'd58: exp_table_10 <= 11'h43f;
                6'd59: exp_table_10 <= 11'h433;
                6'd60: exp_table_10 <= 11'h428;
                6'd61: exp_table_10 <= 11'h41c;
                6'd62: exp_table_10 <= 11'h411;
                6'd63: exp_table_10 <= 11'h406;
                default: exp_table_10 <= 11'h7f5;
            endcase
        end
    end
    reg [3:0] i_10;
    reg zero_10;
    always @(posedge clk) begin
        if (ce) begin
            i_10 <= i_9;
            zero_10 <= zero_9;
        end
    end

    // ===== Stage 10: registers only
    // UQ0.11: 2^-f midway in the cell
    wire [10:0] exp_10 = exp_table_10;
    reg [3:0] i_11;
    reg [10:0] exp_11;
    reg zero_11;
    always @(posedge clk) begin
        if (ce) begin
            i_11 <= i_10;
            exp_11 <= exp_10;
            zero_11 <= zero_10;
        end
    end

    // ===== Stage 11: power_shifted
    // UQ0.11: 2^-z = 2^-f 2^-i
    wire [10:0] power_shifted_11 = exp_11 >> i_11;
    reg [10:0] power_shifted_12;
    reg zero_12;
    always @(posedge clk) begin
        if (ce) begin
            power_shifted_12 <= power_shifted_11;
            zero_12 <= zero_11;
        end
    end

    // ===== Stage 12: y_half, y
    // UQ0.11: plus half an output ulp: the result is rounded to nearest
    wire [10:0] y_half_12 = power_shifted_12 + 11'h001;
    // UQ1.10: rounded to the output's bits
    wire [10:0] y_cut_12 = {1'd0, y_half_12[10:1]};
    // UQ1.10: y, 0 where it is below half an ulp
    wire [10:0] y_12 = zero_12 ? 11'd0 : y_cut_12;
    reg [10:0] y_13;
    always @(posedge clk) begin
        if (ce) begin
            y_13 <= y_12;
        end
    end

    assign out_valid = valid[13];
    assign out_spec  = y_13;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    m_by_8_0[12:4],
                    m_by_4_1[12:8],
                    m_by_2_1[12:10],
                    m_by_1_1[12:11],
                    m_1_2[12:11],
                    m_1_2[6:0],
                    z_8[7:0],
                    y_half_12[0]};

endmodule

`default_nettype wire
