// segmented_4: specular lobe x^n as x(c - u(A - a u)) in 4 segments, n = 1 to 63, minimax
//
// Made by: brdfgen generate core.toml
// Spec f7893d2af80957a7. Generated; the core is yours to use under any terms.
//
//   in_n      UQ6.0   shininess, 1 to 63; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 17 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.824..+0.750.
//   measured -0.679..+0.739 over all 258111 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.173 % absolute, 0.171 % where x^n >= 1/2, 0.312 % relative there.
// As the cosine rises, the output never falls: proved by running all 258048 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module segmented_4 (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ6.0: shininess, 1 to 63; outside: the nearest end
    input  wire [5:0] in_n,
    // Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [13:0] in_cos,
    // out_spec is a result: in_valid, 17 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [17:1] valid;
    initial valid = 17'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 17'd0;
        end else if (ce) begin
            valid <= {valid[16:1], in_valid};
        end
    end

    // ===== Stage 0: read scale, x, u
    // The word of the memory scale, of 64 words.
    reg [11:0] scale_1;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ8.-2: the address of the row's first part
    wire [5:0] address_of_parts_0 = in_n;
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                6'd0: scale_1 <= 12'h800;
                6'd1: scale_1 <= 12'h800;
                6'd2: scale_1 <= 12'h801;
                6'd3: scale_1 <= 12'hc01;
                6'd4: scale_1 <= 12'h802;
                6'd5: scale_1 <= 12'ha02;
                6'd6: scale_1 <= 12'hc02;
                6'd7: scale_1 <= 12'he02;
                6'd8: scale_1 <= 12'h803;
                6'd9: scale_1 <= 12'h903;
                6'd10: scale_1 <= 12'ha03;
                6'd11: scale_1 <= 12'hb03;
                6'd12: scale_1 <= 12'hc03;
                6'd13: scale_1 <= 12'hd03;
                6'd14: scale_1 <= 12'he03;
                6'd15: scale_1 <= 12'hf03;
                6'd16: scale_1 <= 12'h804;
                6'd17: scale_1 <= 12'h884;
                6'd18: scale_1 <= 12'h904;
                6'd19: scale_1 <= 12'h984;
                6'd20: scale_1 <= 12'ha04;
                6'd21: scale_1 <= 12'ha84;
                6'd22: scale_1 <= 12'hb04;
                6'd23: scale_1 <= 12'hb84;
                6'd24: scale_1 <= 12'hc04;
                6'd25: scale_1 <= 12'hc84;
                6'd26: scale_1 <= 12'hd04;
                6'd27: scale_1 <= 12'hd84;
                6'd28: scale_1 <= 12'he04;
                6'd29: scale_1 <= 12'he84;
                6'd30: scale_1 <= 12'hf04;
                6'd31: scale_1 <= 12'hf84;
                6'd32: scale_1 <= 12'h805;
                6'd33: scale_1 <= 12'h845;
                6'd34: scale_1 <= 12'h885;
                6'd35: scale_1 <= 12'h8c5;
                6'd36: scale_1 <= 12'h905;
                6'd37: scale_1 <= 12'h945;
                6'd38: scale_1 <= 12'h985;
                6'd39: scale_1 <= 12'h9c5;
                6'd40: scale_1 <= 12'ha05;
                6'd41: scale_1 <= 12'ha45;
                6'd42: scale_1 <= 12'ha85;
                6'd43: scale_1 <= 12'hac5;
                6'd44: scale_1 <= 12'hb05;
                6'd45: scale_1 <= 12'hb45;
                6'd46: scale_1 <= 12'hb85;
                6'd47: scale_1 <= 12'hbc5;
                6'd48: scale_1 <= 12'hc05;
                6'd49: scale_1 <= 12'hc45;
                6'd50: scale_1 <= 12'hc85;
                6'd51: scale_1 <= 12'hcc5;
                6'd52: scale_1 <= 12'hd05;
                6'd53: scale_1 <= 12'hd45;
                6'd54: scale_1 <= 12'hd85;
                6'd55: scale_1 <= 12'hdc5;
                6'd56: scale_1 <= 12'he05;
                6'd57: scale_1 <= 12'he45;
                6'd58: scale_1 <= 12'he85;
                6'd59: scale_1 <= 12'hec5;
                6'd60: scale_1 <= 12'hf05;
                6'd61: scale_1 <= 12'hf45;
                6'd62: scale_1 <= 12'hf85;
                6'd63: scale_1 <= 12'hfc5;
                default: scale_1 <= 12'h800;
            endcase
        end
    end
    reg [12:0] x_1;
    reg [12:0] u_1;
    reg [5:0] address_of_parts_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            u_1 <= u_0;
            address_of_parts_1 <= address_of_parts_0;
        end
    end

    // ===== Stage 1: registers only
    // UQ0.9: n 2^-k, for the segment
    wire [8:0] m_1 = scale_1[11:3];
    // UQ3.0: shift of the versine
    wire [2:0] k_1 = scale_1[2:0];
    reg [12:0] x_2;
    reg [12:0] u_2;
    reg [8:0] m_2;
    reg [2:0] k_2;
    reg [5:0] address_of_parts_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            u_2 <= u_1;
            m_2 <= m_1;
            k_2 <= k_1;
            address_of_parts_2 <= address_of_parts_1;
        end
    end

    // ===== Stage 2: u_scaled
    // UQ7.11: u 2^(k + 1)
    wire [17:0] u_scaled_2 = {5'd0, u_2} << k_2;
    // UQ7.-5: u 2^k is past every segment
    wire [1:0] beyond_bits_2 = u_scaled_2[17:16];
    // UQ1.0: u 2^k is past every segment
    wire beyond_2 = |beyond_bits_2;
    // UQ5.9: the leading bits of u 2^k
    wire [13:0] v_rough_2 = u_scaled_2[15:2];
    // UQ4.11: v = u 2^k, rounded down; wraps past the last segment
    wire [14:0] v_2 = u_scaled_2[14:0];
    reg [12:0] x_3;
    reg [8:0] m_3;
    reg beyond_3;
    reg [13:0] v_rough_3;
    reg [5:0] address_of_parts_3;
    reg [14:0] v_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            m_3 <= m_2;
            beyond_3 <= beyond_2;
            v_rough_3 <= v_rough_2;
            address_of_parts_3 <= address_of_parts_2;
            v_3 <= v_2;
        end
    end

    // ===== Stage 3: registers only
    reg [12:0] x_4;
    reg [8:0] m_4;
    reg beyond_4;
    reg [13:0] v_rough_4;
    reg [5:0] address_of_parts_4;
    reg [14:0] v_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            m_4 <= m_3;
            beyond_4 <= beyond_3;
            v_rough_4 <= v_rough_3;
            address_of_parts_4 <= address_of_parts_3;
            v_4 <= v_3;
        end
    end

    // ===== Stage 4: s_exact
    // UQ5.18: n u, roughly
    wire [22:0] s_exact_4 = v_rough_4 * m_4;
    // UQ5.9: n u, roughly
    wire [13:0] s_4 = s_exact_4[22:9];
    reg [12:0] x_5;
    reg beyond_5;
    reg [13:0] s_5;
    reg [5:0] address_of_parts_5;
    reg [14:0] v_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            beyond_5 <= beyond_4;
            s_5 <= s_4;
            address_of_parts_5 <= address_of_parts_4;
            v_5 <= v_4;
        end
    end

    // ===== Stage 5: past, segment_bit_1, bound_1_0_0
    // UQ1.0: past the last segment
    wire past_5 = s_5 > 14'h0c4b;
    // UQ1.0: a bit of the segment
    wire segment_bit_1_5 = s_5 > 14'h03a1;
    // UQ5.9: the next bound to compare with
    wire [13:0] bound_1_0_0_5 = segment_bit_1_5 ? 14'h06ca : 14'h018d;
    // UQ2.-1: the bit at its place
    wire segment_part_1_5 = segment_bit_1_5;
    // UQ1.0: the result is 0
    wire zero_5 = beyond_5 | past_5;
    reg [12:0] x_6;
    reg [13:0] s_6;
    reg [13:0] bound_1_0_0_6;
    reg segment_part_1_6;
    reg [5:0] address_of_parts_6;
    reg [14:0] v_6;
    reg zero_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            s_6 <= s_5;
            bound_1_0_0_6 <= bound_1_0_0_5;
            segment_part_1_6 <= segment_part_1_5;
            address_of_parts_6 <= address_of_parts_5;
            v_6 <= v_5;
            zero_6 <= zero_5;
        end
    end

    // ===== Stage 6: segment_bit_0, segment_1
    // UQ1.0: a bit of the segment
    wire segment_bit_0_6 = s_6 > bound_1_0_0_6;
    // UQ1.0: the bit at its place
    wire segment_part_0_6 = segment_bit_0_6;
    // UQ2.0: the number of the segment
    wire [1:0] segment_1_6 = {segment_part_1_6, 1'd0} + {1'd0, segment_part_0_6};
    reg [12:0] x_7;
    reg [1:0] segment_1_7;
    reg [5:0] address_of_parts_7;
    reg [14:0] v_7;
    reg zero_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            segment_1_7 <= segment_1_6;
            address_of_parts_7 <= address_of_parts_6;
            v_7 <= v_6;
            zero_7 <= zero_6;
        end
    end

    // ===== Stage 7: part_address
    // UQ8.0: the address of the part
    wire [7:0] part_address_7 = {address_of_parts_7, 2'd0} + {6'd0, segment_1_7};
    reg [12:0] x_8;
    reg [7:0] part_address_8;
    reg [14:0] v_8;
    reg zero_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            part_address_8 <= part_address_7;
            v_8 <= v_7;
            zero_8 <= zero_7;
        end
    end

    // ===== Stage 8: read the ROM
    // The word of the memory rom, of 256 words.
    reg [46:0] rom_9;
    always @(posedge clk) begin
        if (ce) begin
            case (part_address_8)
                8'd0: rom_9 <= 47'h400000000000;
                8'd1: rom_9 <= 47'h400000000000;
                8'd2: rom_9 <= 47'h000000000000;
                8'd3: rom_9 <= 47'h000000000000;
                8'd4: rom_9 <= 47'h400000000000;
                8'd5: rom_9 <= 47'h400000000000;
                8'd6: rom_9 <= 47'h000000000000;
                8'd7: rom_9 <= 47'h000000000000;
                8'd8: rom_9 <= 47'h400040000000;
                8'd9: rom_9 <= 47'h400040000000;
                8'd10: rom_9 <= 47'h400040000000;
                8'd11: rom_9 <= 47'h000000000000;
                8'd12: rom_9 <= 47'h3fff7fff9000;
                8'd13: rom_9 <= 47'h3fff80001001;
                8'd14: rom_9 <= 47'h3fff7fff9000;
                8'd15: rom_9 <= 47'h000000000000;
                8'd16: rom_9 <= 47'h3ffc5f5a0add;
                8'd17: rom_9 <= 47'h3e275694082a;
                8'd18: rom_9 <= 47'h2eb836c48408;
                8'd19: rom_9 <= 47'h0b440b5000b5;
                8'd20: rom_9 <= 47'h3ff97e6e147e;
                8'd21: rom_9 <= 47'h3cef6bfa0d4f;
                8'd22: rom_9 <= 47'h2c763fca05d5;
                8'd23: rom_9 <= 47'h089a08e0808e;
                8'd24: rom_9 <= 47'h3ff69d5e20e5;
                8'd25: rom_9 <= 47'h3c1a8108938a;
                8'd26: rom_9 <= 47'h2a3a471707af;
                8'd27: rom_9 <= 47'h0778080f8081;
                8'd28: rom_9 <= 47'h3ff4bc3cb00f;
                8'd29: rom_9 <= 47'h3b8695f59ada;
                8'd30: rom_9 <= 47'h28db4f2189e5;
                8'd31: rom_9 <= 47'h07b6096480ab;
                8'd32: rom_9 <= 47'h3ff26d859080;
                8'd33: rom_9 <= 47'h3b15556788d3;
                8'd34: rom_9 <= 47'h27f42bc8831c;
                8'd35: rom_9 <= 47'h07fe057d0039;
                8'd36: rom_9 <= 47'h3ff17ce995a9;
                8'd37: rom_9 <= 47'h3abc5fcd0b37;
                8'd38: rom_9 <= 47'h2747301183d3;
                8'd39: rom_9 <= 47'h082e063f0049;
                8'd40: rom_9 <= 47'h3ff08c499b84;
                8'd41: rom_9 <= 47'h3a736a298de2;
                8'd42: rom_9 <= 47'h26cb347904a0;
                8'd43: rom_9 <= 47'h08520702805b;
                8'd44: rom_9 <= 47'h3fef9ba8a20d;
                8'd45: rom_9 <= 47'h3a39748090d1;
                8'd46: rom_9 <= 47'h265e38d4857f;
                8'd47: rom_9 <= 47'h087d07d40070;
                8'd48: rom_9 <= 47'h3feeab032948;
                8'd49: rom_9 <= 47'h3a0c7ee9140e;
                8'd50: rom_9 <= 47'h26123d4f0675;
                8'd51: rom_9 <= 47'h089408968086;
                8'd52: rom_9 <= 47'h3feeba66313a;
                8'd53: rom_9 <= 47'h39e389449790;
                8'd54: rom_9 <= 47'h25c741b1077b;
                8'd55: rom_9 <= 47'h08a80959809e;
                8'd56: rom_9 <= 47'h3fedc9bb39ce;
                8'd57: rom_9 <= 47'h39c093939b53;
                8'd58: rom_9 <= 47'h25934635889a;
                8'd59: rom_9 <= 47'h08bf0a2780b9;
                8'd60: rom_9 <= 47'h3fecd911c314;
                8'd61: rom_9 <= 47'h39a39df71f68;
                8'd62: rom_9 <= 47'h25684abd89cd;
                8'd63: rom_9 <= 47'h08cd0aea80d5;
                8'd64: rom_9 <= 47'h3feb743b134a;
                8'd65: rom_9 <= 47'h398e543988f4;
                8'd66: rom_9 <= 47'h254127a182c5;
                8'd67: rom_9 <= 47'h08e005dc003d;
                8'd68: rom_9 <= 47'h3feb7be195ee;
                8'd69: rom_9 <= 47'h396e594f8a19;
                8'd70: rom_9 <= 47'h251329d3031a;
                8'd71: rom_9 <= 47'h08e7063d0045;
                8'd72: rom_9 <= 47'h3feb839398ca;
                8'd73: rom_9 <= 47'h395e5e840b53;
                8'd74: rom_9 <= 47'h24f62c188376;
                8'd75: rom_9 <= 47'h08ec0697804d;
                8'd76: rom_9 <= 47'h3fea8b3b1bcc;
                8'd77: rom_9 <= 47'h394b63ae8c9f;
                8'd78: rom_9 <= 47'h24d92e5703d6;
                8'd79: rom_9 <= 47'h08f406f88056;
                8'd80: rom_9 <= 47'h3fea92e19ef4;
                8'd81: rom_9 <= 47'h393a68d60dfb;
                8'd82: rom_9 <= 47'h24c730a6043d;
                8'd83: rom_9 <= 47'h090507640060;
                8'd84: rom_9 <= 47'h3fea9a942254;
                8'd85: rom_9 <= 47'h392b6dff8f6a;
                8'd86: rom_9 <= 47'h24a632d404a5;
                8'd87: rom_9 <= 47'h090c07c6006a;
                8'd88: rom_9 <= 47'h3feaa242a5dd;
                8'd89: rom_9 <= 47'h391d732910eb;
                8'd90: rom_9 <= 47'h248d350b0513;
                8'd91: rom_9 <= 47'h0917082f0075;
                8'd92: rom_9 <= 47'h3fe9a9e7298a;
                8'd93: rom_9 <= 47'h390f784d127d;
                8'd94: rom_9 <= 47'h24873769058b;
                8'd95: rom_9 <= 47'h0929089f0081;
                8'd96: rom_9 <= 47'h3fe9b196ad6d;
                8'd97: rom_9 <= 47'h390a7d99942c;
                8'd98: rom_9 <= 47'h247b39b70606;
                8'd99: rom_9 <= 47'h092808fa008c;
                8'd100: rom_9 <= 47'h3fe9b93b316f;
                8'd101: rom_9 <= 47'h38f782a295db;
                8'd102: rom_9 <= 47'h24643be88682;
                8'd103: rom_9 <= 47'h093709690099;
                8'd104: rom_9 <= 47'h3fe8c0e835a8;
                8'd105: rom_9 <= 47'h38ed87bd179c;
                8'd106: rom_9 <= 47'h24473e078700;
                8'd107: rom_9 <= 47'h093409c380a5;
                8'd108: rom_9 <= 47'h3fe9c89fba1d;
                8'd109: rom_9 <= 47'h38ee8d1d9988;
                8'd110: rom_9 <= 47'h24454063078c;
                8'd111: rom_9 <= 47'h093f0a3080b3;
                8'd112: rom_9 <= 47'h3fe8d044bea3;
                8'd113: rom_9 <= 47'h38e3923f9b73;
                8'd114: rom_9 <= 47'h244242c0881e;
                8'd115: rom_9 <= 47'h09490a9a00c1;
                8'd116: rom_9 <= 47'h3fe8d7f24362;
                8'd117: rom_9 <= 47'h38db97691d72;
                8'd118: rom_9 <= 47'h243044f388ae;
                8'd119: rom_9 <= 47'h094a0afb00cf;
                8'd120: rom_9 <= 47'h3fe8df864824;
                8'd121: rom_9 <= 47'h38ce9c711f77;
                8'd122: rom_9 <= 47'h242f4752094a;
                8'd123: rom_9 <= 47'h09510b6300de;
                8'd124: rom_9 <= 47'h3fe9e745cd58;
                8'd125: rom_9 <= 47'h38d0a1d421ae;
                8'd126: rom_9 <= 47'h2426499d89e9;
                8'd127: rom_9 <= 47'h095a0bcf00ee;
                8'd128: rom_9 <= 47'h3fe8777414a2;
                8'd129: rom_9 <= 47'h38c1536388f4;
                8'd130: rom_9 <= 47'h241325e002a1;
                8'd131: rom_9 <= 47'h096706238040;
                8'd132: rom_9 <= 47'h3fe77b4815fc;
                8'd133: rom_9 <= 47'h38bc55f78984;
                8'd134: rom_9 <= 47'h240726fc02ca;
                8'd135: rom_9 <= 47'h095406418043;
                8'd136: rom_9 <= 47'h3fe87f219766;
                8'd137: rom_9 <= 47'h38bb589e8a1f;
                8'd138: rom_9 <= 47'h2402282102f5;
                8'd139: rom_9 <= 47'h096806828048;
                8'd140: rom_9 <= 47'h3fe782fe18df;
                8'd141: rom_9 <= 47'h38bc5b428abb;
                8'd142: rom_9 <= 47'h23f829400321;
                8'd143: rom_9 <= 47'h096106ae004c;
                8'd144: rom_9 <= 47'h3fe786c69a4b;
                8'd145: rom_9 <= 47'h38ac5db80b55;
                8'd146: rom_9 <= 47'h23f52a68834f;
                8'd147: rom_9 <= 47'h097106eb0051;
                8'd148: rom_9 <= 47'h3fe78a911bc7;
                8'd149: rom_9 <= 47'h389860118bea;
                8'd150: rom_9 <= 47'h23e32b79037c;
                8'd151: rom_9 <= 47'h097b07240056;
                8'd152: rom_9 <= 47'h3fe88e7a9d6d;
                8'd153: rom_9 <= 47'h38aa62fc0ca6;
                8'd154: rom_9 <= 47'h23e22ca083ac;
                8'd155: rom_9 <= 47'h096f0749005a;
                8'd156: rom_9 <= 47'h3fe8924b1f04;
                8'd157: rom_9 <= 47'h38a465860d4f;
                8'd158: rom_9 <= 47'h23e72dda03e0;
                8'd159: rom_9 <= 47'h0976077f005f;
                8'd160: rom_9 <= 47'h3fe6961e20ab;
                8'd161: rom_9 <= 47'h38a268260e03;
                8'd162: rom_9 <= 47'h23e92f098414;
                8'd163: rom_9 <= 47'h097707b10064;
                8'd164: rom_9 <= 47'h3fe799f52260;
                8'd165: rom_9 <= 47'h38976aa00eb2;
                8'd166: rom_9 <= 47'h23cb2ffc8442;
                8'd167: rom_9 <= 47'h097607e18069;
                8'd168: rom_9 <= 47'h3fe79dd02422;
                8'd169: rom_9 <= 47'h38946d2e0f68;
                8'd170: rom_9 <= 47'h23bb31070474;
                8'd171: rom_9 <= 47'h09840820006f;
                8'd172: rom_9 <= 47'h3fe6a18825cb;
                8'd173: rom_9 <= 47'h387a6f709014;
                8'd174: rom_9 <= 47'h23b8322f04ab;
                8'd175: rom_9 <= 47'h0980084c8074;
                8'd176: rom_9 <= 47'h3fe6a568a7a9;
                8'd177: rom_9 <= 47'h387f722390dd;
                8'd178: rom_9 <= 47'h23ae334184e0;
                8'd179: rom_9 <= 47'h097b08778079;
                8'd180: rom_9 <= 47'h3fe8a94d299b;
                8'd181: rom_9 <= 47'h388b74f091b0;
                8'd182: rom_9 <= 47'h23b03470051a;
                8'd183: rom_9 <= 47'h098108af007f;
                8'd184: rom_9 <= 47'h3fe6ad0bab67;
                8'd185: rom_9 <= 47'h387f77651276;
                8'd186: rom_9 <= 47'h23bd35b88559;
                8'd187: rom_9 <= 47'h098608e40085;
                8'd188: rom_9 <= 47'h3fe6b0f6ad7b;
                8'd189: rom_9 <= 47'h38837a15134c;
                8'd190: rom_9 <= 47'h23b536d58594;
                8'd191: rom_9 <= 47'h09960928008c;
                8'd192: rom_9 <= 47'h3fe6b4b8af5e;
                8'd193: rom_9 <= 47'h387f7cae1424;
                8'd194: rom_9 <= 47'h23c5382305d6;
                8'd195: rom_9 <= 47'h099609598092;
                8'd196: rom_9 <= 47'h3fe6b8acb192;
                8'd197: rom_9 <= 47'h388b7f85150f;
                8'd198: rom_9 <= 47'h23bd393e8613;
                8'd199: rom_9 <= 47'h099409888098;
                8'd200: rom_9 <= 47'h3fe7bc74b393;
                8'd201: rom_9 <= 47'h388081ef15e0;
                8'd202: rom_9 <= 47'h23ac3a3b864c;
                8'd203: rom_9 <= 47'h099109b7009e;
                8'd204: rom_9 <= 47'h3fe6c03ab5a1;
                8'd205: rom_9 <= 47'h3876846896bc;
                8'd206: rom_9 <= 47'h23b33b7a8691;
                8'd207: rom_9 <= 47'h099a09f180a5;
                8'd208: rom_9 <= 47'h3fe6c403b7bb;
                8'd209: rom_9 <= 47'h38618692177e;
                8'd210: rom_9 <= 47'h238e3c4a86c6;
                8'd211: rom_9 <= 47'h09890a1380ab;
                8'd212: rom_9 <= 47'h3fe6c7ceb9e2;
                8'd213: rom_9 <= 47'h385e892a186c;
                8'd214: rom_9 <= 47'h23953d84070c;
                8'd215: rom_9 <= 47'h09920a4880b1;
                8'd216: rom_9 <= 47'h3fe8cbd7bc6e;
                8'd217: rom_9 <= 47'h387d8c699990;
                8'd218: rom_9 <= 47'h23a33ed50758;
                8'd219: rom_9 <= 47'h09940a7d00b8;
                8'd220: rom_9 <= 47'h3fe7cfa9beb6;
                8'd221: rom_9 <= 47'h386f8ebd9a6e;
                8'd222: rom_9 <= 47'h23943fd90798;
                8'd223: rom_9 <= 47'h099f0abd00c0;
                8'd224: rom_9 <= 47'h3fe6d37bc109;
                8'd225: rom_9 <= 47'h3878918e9b7b;
                8'd226: rom_9 <= 47'h239b411107e2;
                8'd227: rom_9 <= 47'h099b0aeb80c7;
                8'd228: rom_9 <= 47'h3fe6d750c36c;
                8'd229: rom_9 <= 47'h387193ff1c6a;
                8'd230: rom_9 <= 47'h238541fb081f;
                8'd231: rom_9 <= 47'h099b0b1c00ce;
                8'd232: rom_9 <= 47'h3fe6db28c5de;
                8'd233: rom_9 <= 47'h386c96799d60;
                8'd234: rom_9 <= 47'h23874335086e;
                8'd235: rom_9 <= 47'h099d0b4d80d5;
                8'd236: rom_9 <= 47'h3fe7df044861;
                8'd237: rom_9 <= 47'h386899059e63;
                8'd238: rom_9 <= 47'h237d443908b1;
                8'd239: rom_9 <= 47'h09a00b8500dd;
                8'd240: rom_9 <= 47'h3fe5e294ca77;
                8'd241: rom_9 <= 47'h38589b5c9f5f;
                8'd242: rom_9 <= 47'h23a145c98910;
                8'd243: rom_9 <= 47'h09a60bbd80e5;
                8'd244: rom_9 <= 47'h3fe5e6724d10;
                8'd245: rom_9 <= 47'h38599e03a074;
                8'd246: rom_9 <= 47'h238a46ab8951;
                8'd247: rom_9 <= 47'h09980be500ed;
                8'd248: rom_9 <= 47'h3fe5ea52cfbb;
                8'd249: rom_9 <= 47'h385ea0bb2193;
                8'd250: rom_9 <= 47'h239147e709a3;
                8'd251: rom_9 <= 47'h099c0c1180f3;
                8'd252: rom_9 <= 47'h3fe7ee36d277;
                8'd253: rom_9 <= 47'h3850a2f5a283;
                8'd254: rom_9 <= 47'h237148b909e5;
                8'd255: rom_9 <= 47'h09aa0c5900fd;
                default: rom_9 <= 47'h400000000000;
            endcase
        end
    end
    reg [12:0] x_9;
    reg [14:0] v_9;
    reg zero_9;
    always @(posedge clk) begin
        if (ce) begin
            x_9 <= x_8;
            v_9 <= v_8;
            zero_9 <= zero_8;
        end
    end

    // ===== Stage 9: registers only
    // UQ1.14: the coefficient c
    wire [14:0] c_9 = rom_9[46:32];
    // UQ0.17: the coefficient A, times 2^-k
    wire [16:0] big_a_9 = rom_9[31:15];
    // UQ-1.16: the coefficient a, times 4^-k
    wire [14:0] a_9 = rom_9[14:0];
    reg [12:0] x_10;
    reg [14:0] c_10;
    reg [16:0] big_a_10;
    reg [14:0] a_10;
    reg [14:0] v_10;
    reg zero_10;
    always @(posedge clk) begin
        if (ce) begin
            x_10 <= x_9;
            c_10 <= c_9;
            big_a_10 <= big_a_9;
            a_10 <= a_9;
            v_10 <= v_9;
            zero_10 <= zero_9;
        end
    end

    // ===== Stage 10: registers only
    reg [12:0] x_11;
    reg [14:0] c_11;
    reg [16:0] big_a_11;
    reg [14:0] a_11;
    reg [14:0] v_11;
    reg zero_11;
    always @(posedge clk) begin
        if (ce) begin
            x_11 <= x_10;
            c_11 <= c_10;
            big_a_11 <= big_a_10;
            a_11 <= a_10;
            v_11 <= v_10;
            zero_11 <= zero_10;
        end
    end

    // ===== Stage 11: av
    // UQ3.27: (a 4^-k) v
    wire [29:0] av_11 = a_11 * v_11;
    // UQ-1.17: (a 4^-k) v, rounded down
    wire [15:0] r_11 = av_11[25:10];
    reg [12:0] x_12;
    reg [14:0] c_12;
    reg [16:0] big_a_12;
    reg [14:0] v_12;
    reg [15:0] r_12;
    reg zero_12;
    always @(posedge clk) begin
        if (ce) begin
            x_12 <= x_11;
            c_12 <= c_11;
            big_a_12 <= big_a_11;
            v_12 <= v_11;
            r_12 <= r_11;
            zero_12 <= zero_11;
        end
    end

    // ===== Stage 12: q
    // UQ0.17: q = (A - a u) 2^-k
    wire [16:0] q_12 = big_a_12 - {1'd0, r_12};
    reg [12:0] x_13;
    reg [14:0] c_13;
    reg [14:0] v_13;
    reg [16:0] q_13;
    reg zero_13;
    always @(posedge clk) begin
        if (ce) begin
            x_13 <= x_12;
            c_13 <= c_12;
            v_13 <= v_12;
            q_13 <= q_12;
            zero_13 <= zero_12;
        end
    end

    // ===== Stage 13: vq
    // UQ4.28: u (A - a u) = v q
    wire [31:0] vq_13 = v_13 * q_13;
    // UQ0.14: u (A - a u), rounded down
    wire [13:0] m_13 = vq_13[27:14];
    reg [12:0] x_14;
    reg [14:0] c_14;
    reg [13:0] m_14;
    reg zero_14;
    always @(posedge clk) begin
        if (ce) begin
            x_14 <= x_13;
            c_14 <= c_13;
            m_14 <= m_13;
            zero_14 <= zero_13;
        end
    end

    // ===== Stage 14: d, d_positive
    // Q1.14: d = c - u (A - a u)
    wire [15:0] d_14 = {1'd0, c_14} - {2'd0, m_14};
    // UQ1.14: d, at least 0
    wire [14:0] d_positive_14 = d_14[15] ? 15'h0000 : d_14[14:0];
    reg [12:0] x_15;
    reg [14:0] d_positive_15;
    reg zero_15;
    always @(posedge clk) begin
        if (ce) begin
            x_15 <= x_14;
            d_positive_15 <= d_positive_14;
            zero_15 <= zero_14;
        end
    end

    // ===== Stage 15: xd
    // UQ2.26: x d
    wire [27:0] xd_15 = x_15 * d_positive_15;
    reg [27:0] xd_16;
    reg zero_16;
    always @(posedge clk) begin
        if (ce) begin
            xd_16 <= xd_15;
            zero_16 <= zero_15;
        end
    end

    // ===== Stage 16: y_half, y
    // UQ1.26: plus half an output ulp: the result is rounded to nearest
    wire [26:0] y_half_16 = xd_16[26:0] + 27'h0002000;
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_cut_16 = y_half_16[26:14];
    // UQ1.12: y, 0 past the last segment
    wire [12:0] y_16 = zero_16 ? 13'd0 : y_cut_16;
    reg [12:0] y_17;
    always @(posedge clk) begin
        if (ce) begin
            y_17 <= y_16;
        end
    end

    assign out_valid = valid[17];
    assign out_spec  = y_17;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    s_exact_4[8:0],
                    av_11[29:26],
                    av_11[9:0],
                    vq_13[31:28],
                    vq_13[13:0],
                    xd_16[27],
                    y_half_16[13:0]};

endmodule

`default_nettype wire
