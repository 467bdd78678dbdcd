// table_2d: specular lobe x^n as x^n from a table, 4 shininesses
//
// Made by: brdfgen generate core.toml
// Spec 93bf5e71d0f70b86. Generated; the core is yours to use under any terms.
//
//   in_n      UQ2.0   index of the shininess, 0 to 3; above: the last
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
//
// Latency 6 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.500..+0.478.
//   measured -0.500..+0.478 over all 16388 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   30.273 % absolute, 30.273 % where x^n >= 1/2, 39.357 % relative there.
// As the cosine rises, the output never falls: proved by running all 16384 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module table_2d (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ2.0: index of the shininess, 0 to 3; above: the last
    input  wire [1:0] in_n,
    // Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [13:0] in_cos,
    // out_spec is a result: in_valid, 6 enabled clocks later
    output wire        out_valid,
    // UQ1.10: the lobe, 0 to 1; 1.0 is exact
    output wire [10:0] out_spec
);

    // ===== Valid chain
    reg [6:1] valid;
    initial valid = 6'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 6'd0;
        end else if (ce) begin
            valid <= {valid[5:1], in_valid};
        end
    end

    // ===== Stage 0: x, u
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ0.6: the cell of the versine, for u below 1
    wire [5:0] cell_0 = u_0[11:6];
    // UQ6.0: the number of the cell
    wire [5:0] cell_number_0 = cell_0;
    // UQ8.-6: the address of the row's first part
    wire [1:0] address_of_parts_0 = in_n;
    // UQ1.0: u = 1: the surface faces away
    wire dark_bits_0 = u_0[12];
    reg [5:0] cell_number_1;
    reg [1:0] address_of_parts_1;
    reg dark_bits_1;
    always @(posedge clk) begin
        if (ce) begin
            cell_number_1 <= cell_number_0;
            address_of_parts_1 <= address_of_parts_0;
            dark_bits_1 <= dark_bits_0;
        end
    end

    // ===== Stage 1: part_address
    // UQ8.0: the address of the part
    wire [7:0] part_address_1 = {address_of_parts_1, 6'd0} + {2'd0, cell_number_1};
    reg [7:0] part_address_2;
    reg dark_bits_2;
    always @(posedge clk) begin
        if (ce) begin
            part_address_2 <= part_address_1;
            dark_bits_2 <= dark_bits_1;
        end
    end

    // ===== Stage 2: read power_table
    // The word of the memory power_table, of 256 words.
    reg [9:0] power_table_3;
    always @(posedge clk) begin
        if (ce) begin
            case (part_address_2)
                8'd0: power_table_3 <= 10'h3f8;
                8'd1: power_table_3 <= 10'h3e8;
                8'd2: power_table_3 <= 10'h3d8;
                8'd3: power_table_3 <= 10'h3c8;
                8'd4: power_table_3 <= 10'h3b8;
                8'd5: power_table_3 <= 10'h3a8;
                8'd6: power_table_3 <= 10'h398;
                8'd7: power_table_3 <= 10'h388;
                8'd8: power_table_3 <= 10'h378;
                8'd9: power_table_3 <= 10'h368;
                8'd10: power_table_3 <= 10'h358;
                8'd11: power_table_3 <= 10'h348;
                8'd12: power_table_3 <= 10'h338;
                8'd13: power_table_3 <= 10'h328;
                8'd14: power_table_3 <= 10'h318;
                8'd15: power_table_3 <= 10'h308;
                8'd16: power_table_3 <= 10'h2f8;
                8'd17: power_table_3 <= 10'h2e8;
                8'd18: power_table_3 <= 10'h2d8;
                8'd19: power_table_3 <= 10'h2c8;
                8'd20: power_table_3 <= 10'h2b8;
                8'd21: power_table_3 <= 10'h2a8;
                8'd22: power_table_3 <= 10'h298;
                8'd23: power_table_3 <= 10'h288;
                8'd24: power_table_3 <= 10'h278;
                8'd25: power_table_3 <= 10'h268;
                8'd26: power_table_3 <= 10'h258;
                8'd27: power_table_3 <= 10'h248;
                8'd28: power_table_3 <= 10'h238;
                8'd29: power_table_3 <= 10'h228;
                8'd30: power_table_3 <= 10'h218;
                8'd31: power_table_3 <= 10'h208;
                8'd32: power_table_3 <= 10'h1f8;
                8'd33: power_table_3 <= 10'h1e8;
                8'd34: power_table_3 <= 10'h1d8;
                8'd35: power_table_3 <= 10'h1c8;
                8'd36: power_table_3 <= 10'h1b8;
                8'd37: power_table_3 <= 10'h1a8;
                8'd38: power_table_3 <= 10'h198;
                8'd39: power_table_3 <= 10'h188;
                8'd40: power_table_3 <= 10'h178;
                8'd41: power_table_3 <= 10'h168;
                8'd42: power_table_3 <= 10'h158;
                8'd43: power_table_3 <= 10'h148;
                8'd44: power_table_3 <= 10'h138;
                8'd45: power_table_3 <= 10'h128;
                8'd46: power_table_3 <= 10'h118;
                8'd47: power_table_3 <= 10'h108;
                8'd48: power_table_3 <= 10'h0f8;
                8'd49: power_table_3 <= 10'h0e8;
                8'd50: power_table_3 <= 10'h0d8;
                8'd51: power_table_3 <= 10'h0c8;
                8'd52: power_table_3 <= 10'h0b8;
                8'd53: power_table_3 <= 10'h0a8;
                8'd54: power_table_3 <= 10'h098;
                8'd55: power_table_3 <= 10'h088;
                8'd56: power_table_3 <= 10'h078;
                8'd57: power_table_3 <= 10'h068;
                8'd58: power_table_3 <= 10'h058;
                8'd59: power_table_3 <= 10'h048;
                8'd60: power_table_3 <= 10'h038;
                8'd61: power_table_3 <= 10'h028;
                8'd62: power_table_3 <= 10'h018;
                8'd63: power_table_3 <= 10'h008;
                8'd64: power_table_3 <= 10'h3da;
                8'd65: power_table_3 <= 10'h38f;
                8'd66: power_table_3 <= 10'h348;
                8'd67: power_table_3 <= 10'h306;
                8'd68: power_table_3 <= 10'h2c8;
                8'd69: power_table_3 <= 10'h28e;
                8'd70: power_table_3 <= 10'h258;
                8'd71: power_table_3 <= 10'h226;
                8'd72: power_table_3 <= 10'h1f7;
                8'd73: power_table_3 <= 10'h1cb;
                8'd74: power_table_3 <= 10'h1a3;
                8'd75: power_table_3 <= 10'h17d;
                8'd76: power_table_3 <= 10'h15a;
                8'd77: power_table_3 <= 10'h13a;
                8'd78: power_table_3 <= 10'h11c;
                8'd79: power_table_3 <= 10'h100;
                8'd80: power_table_3 <= 10'h0e7;
                8'd81: power_table_3 <= 10'h0d0;
                8'd82: power_table_3 <= 10'h0ba;
                8'd83: power_table_3 <= 10'h0a7;
                8'd84: power_table_3 <= 10'h095;
                8'd85: power_table_3 <= 10'h085;
                8'd86: power_table_3 <= 10'h076;
                8'd87: power_table_3 <= 10'h068;
                8'd88: power_table_3 <= 10'h05c;
                8'd89: power_table_3 <= 10'h051;
                8'd90: power_table_3 <= 10'h047;
                8'd91: power_table_3 <= 10'h03e;
                8'd92: power_table_3 <= 10'h036;
                8'd93: power_table_3 <= 10'h02f;
                8'd94: power_table_3 <= 10'h028;
                8'd95: power_table_3 <= 10'h023;
                8'd96: power_table_3 <= 10'h01e;
                8'd97: power_table_3 <= 10'h019;
                8'd98: power_table_3 <= 10'h015;
                8'd99: power_table_3 <= 10'h012;
                8'd100: power_table_3 <= 10'h00f;
                8'd101: power_table_3 <= 10'h00d;
                8'd102: power_table_3 <= 10'h00a;
                8'd103: power_table_3 <= 10'h008;
                8'd104: power_table_3 <= 10'h007;
                8'd105: power_table_3 <= 10'h006;
                8'd106: power_table_3 <= 10'h004;
                8'd107: power_table_3 <= 10'h003;
                8'd108: power_table_3 <= 10'h003;
                8'd109: power_table_3 <= 10'h002;
                8'd110: power_table_3 <= 10'h002;
                8'd111: power_table_3 <= 10'h001;
                8'd112: power_table_3 <= 10'h001;
                8'd113: power_table_3 <= 10'h001;
                8'd114: power_table_3 <= 10'h000;
                8'd115: power_table_3 <= 10'h000;
                8'd116: power_table_3 <= 10'h000;
                8'd117: power_table_3 <= 10'h000;
                8'd118: power_table_3 <= 10'h000;
                8'd119: power_table_3 <= 10'h000;
                8'd120: power_table_3 <= 10'h000;
                8'd121: power_table_3 <= 10'h000;
                8'd122: power_table_3 <= 10'h000;
                8'd123: power_table_3 <= 10'h000;
                8'd124: power_table_3 <= 10'h000;
                8'd125: power_table_3 <= 10'h000;
                8'd126: power_table_3 <= 10'h000;
                8'd127: power_table_3 <= 10'h000;
                8'd128: power_table_3 <= 10'h378;
                8'd129: power_table_3 <= 10'h286;
                8'd130: power_table_3 <= 10'h1d4;
                8'd131: power_table_3 <= 10'h152;
                8'd132: power_table_3 <= 10'h0f2;
                8'd133: power_table_3 <= 10'h0ac;
                8'd134: power_table_3 <= 10'h07a;
                8'd135: power_table_3 <= 10'h056;
                8'd136: power_table_3 <= 10'h03c;
                8'd137: power_table_3 <= 10'h02a;
                8'd138: power_table_3 <= 10'h01d;
                8'd139: power_table_3 <= 10'h014;
                8'd140: power_table_3 <= 10'h00e;
                8'd141: power_table_3 <= 10'h009;
                8'd142: power_table_3 <= 10'h006;
                8'd143: power_table_3 <= 10'h004;
                8'd144: power_table_3 <= 10'h003;
                8'd145: power_table_3 <= 10'h002;
                8'd146: power_table_3 <= 10'h001;
                8'd147: power_table_3 <= 10'h001;
                8'd148: power_table_3 <= 10'h000;
                8'd149: power_table_3 <= 10'h000;
                8'd150: power_table_3 <= 10'h000;
                8'd151: power_table_3 <= 10'h000;
                8'd152: power_table_3 <= 10'h000;
                8'd153: power_table_3 <= 10'h000;
                8'd154: power_table_3 <= 10'h000;
                8'd155: power_table_3 <= 10'h000;
                8'd156: power_table_3 <= 10'h000;
                8'd157: power_table_3 <= 10'h000;
                8'd158: power_table_3 <= 10'h000;
                8'd159: power_table_3 <= 10'h000;
                8'd160: power_table_3 <= 10'h000;
                8'd161: power_table_3 <= 10'h000;
                8'd162: power_table_3 <= 10'h000;
                8'd163: power_table_3 <= 10'h000;
                8'd164: power_table_3 <= 10'h000;
                8'd165: power_table_3 <= 10'h000;
                8'd166: power_table_3 <= 10'h000;
                8'd167: power_table_3 <= 10'h000;
                8'd168: power_table_3 <= 10'h000;
                8'd169: power_table_3 <= 10'h000;
                8'd170: power_table_3 <= 10'h000;
                8'd171: power_table_3 <= 10'h000;
                8'd172: power_table_3 <= 10'h000;
                8'd173: power_table_3 <= 10'h000;
                8'd174: power_table_3 <= 10'h000;
                8'd175: power_table_3 <= 10'h000;
                8'd176: power_table_3 <= 10'h000;
                8'd177: power_table_3 <= 10'h000;
                8'd178: power_table_3 <= 10'h000;
                8'd179: power_table_3 <= 10'h000;
                8'd180: power_table_3 <= 10'h000;
                8'd181: power_table_3 <= 10'h000;
                8'd182: power_table_3 <= 10'h000;
                8'd183: power_table_3 <= 10'h000;
                8'd184: power_table_3 <= 10'h000;
                8'd185: power_table_3 <= 10'h000;
                8'd186: power_table_3 <= 10'h000;
                8'd187: power_table_3 <= 10'h000;
                8'd188: power_table_3 <= 10'h000;
                8'd189: power_table_3 <= 10'h000;
                8'd190: power_table_3 <= 10'h000;
                8'd191: power_table_3 <= 10'h000;
                8'd192: power_table_3 <= 10'h2ca;
                8'd193: power_table_3 <= 10'h114;
                8'd194: power_table_3 <= 10'h069;
                8'd195: power_table_3 <= 10'h028;
                8'd196: power_table_3 <= 10'h00f;
                8'd197: power_table_3 <= 10'h005;
                8'd198: power_table_3 <= 10'h002;
                8'd199: power_table_3 <= 10'h001;
                8'd200: power_table_3 <= 10'h000;
                8'd201: power_table_3 <= 10'h000;
                8'd202: power_table_3 <= 10'h000;
                8'd203: power_table_3 <= 10'h000;
                8'd204: power_table_3 <= 10'h000;
                8'd205: power_table_3 <= 10'h000;
                8'd206: power_table_3 <= 10'h000;
                8'd207: power_table_3 <= 10'h000;
                8'd208: power_table_3 <= 10'h000;
                8'd209: power_table_3 <= 10'h000;
                8'd210: power_table_3 <= 10'h000;
                8'd211: power_table_3 <= 10'h000;
                8'd212: power_table_3 <= 10'h000;
                8'd213: power_table_3 <= 10'h000;
                8'd214: power_table_3 <= 10'h000;
                8'd215: power_table_3 <= 10'h000;
                8'd216: power_table_3 <= 10'h000;
                8'd217: power_table_3 <= 10'h000;
                8'd218: power_table_3 <= 10'h000;
                8'd219: power_table_3 <= 10'h000;
                8'd220: power_table_3 <= 10'h000;
                8'd221: power_table_3 <= 10'h000;
                8'd222: power_table_3 <= 10'h000;
                8'd223: power_table_3 <= 10'h000;
                8'd224: power_table_3 <= 10'h000;
                8'd225: power_table_3 <= 10'h000;
                8'd226: power_table_3 <= 10'h000;
                8'd227: power_table_3 <= 10'h000;
                8'd228: power_table_3 <= 10'h000;
                8'd229: power_table_3 <= 10'h000;
                8'd230: power_table_3 <= 10'h000;
                8'd231: power_table_3 <= 10'h000;
                8'd232: power_table_3 <= 10'h000;
                8'd233: power_table_3 <= 10'h000;
                8'd234: power_table_3 <= 10'h000;
                8'd235: power_table_3 <= 10'h000;
                8'd236: power_table_3 <= 10'h000;
                8'd237: power_table_3 <= 10'h000;
                8'd238: power_table_3 <= 10'h000;
                8'd239: power_table_3 <= 10'h000;
                8'd240: power_table_3 <= 10'h000;
                8'd241: power_table_3 <= 10'h000;
                8'd242: power_table_3 <= 10'h000;
                8'd243: power_table_3 <= 10'h000;
                8'd244: power_table_3 <= 10'h000;
                8'd245: power_table_3 <= 10'h000;
                8'd246: power_table_3 <= 10'h000;
                8'd247: power_table_3 <= 10'h000;
                8'd248: power_table_3 <= 10'h000;
                8'd249: power_table_3 <= 10'h000;
                8'd250: power_table_3 <= 10'h000;
                8'd251: power_table_3 <= 10'h000;
                8'd252: power_table_3 <= 10'h000;
                8'd253: power_table_3 <= 10'h000;
                8'd254: power_table_3 <= 10'h000;
                8'd255: power_table_3 <= 10'h000;
                default: power_table_3 <= 10'h3f8;
            endcase
        end
    end
    reg dark_bits_3;
    always @(posedge clk) begin
        if (ce) begin
            dark_bits_3 <= dark_bits_2;
        end
    end

    // ===== Stage 3: registers only
    // UQ0.10: x^n midway in the cell
    wire [9:0] y_3 = power_table_3;
    reg [9:0] y_4;
    reg dark_bits_4;
    always @(posedge clk) begin
        if (ce) begin
            y_4 <= y_3;
            dark_bits_4 <= dark_bits_3;
        end
    end

    // ===== Stage 4: registers only
    reg [9:0] y_5;
    reg dark_bits_5;
    always @(posedge clk) begin
        if (ce) begin
            y_5 <= y_4;
            dark_bits_5 <= dark_bits_4;
        end
    end

    // ===== Stage 5: y_lit
    // UQ0.10: y, 0 where the surface faces away
    wire [9:0] y_lit_5 = dark_bits_5 ? 10'd0 : y_5;
    // UQ1.10: with an integer bit
    wire [10:0] y_wide_5 = {1'd0, y_lit_5};
    reg [10:0] y_wide_6;
    always @(posedge clk) begin
        if (ce) begin
            y_wide_6 <= y_wide_5;
        end
    end

    assign out_valid = valid[6];
    assign out_spec  = y_wide_6;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    u_0[5:0]};

endmodule

`default_nettype wire
