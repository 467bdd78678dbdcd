// segmented_4: specular lobe x^n as x(c - u(A - a u)) in 4 segments, n = 1 to 63, minimax
//
// Made by: brdfgen generate core.toml
// Spec f7893d2af80957a7. Generated; the core is yours to use under any terms.
//
//   in_n      UQ6.0   shininess, 1 to 63; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 16 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.653..+0.750.
//   measured -0.588..+0.740 over all 258111 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.157 % absolute, 0.157 % where x^n >= 1/2, 0.278 % relative there.

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
    // out_spec is a result: in_valid, 16 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [16:1] valid;
    initial valid = 16'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 16'd0;
        end else if (ce) begin
            valid <= {valid[15:1], in_valid};
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

    // ===== Stage 3: s_exact
    // UQ5.18: n u, roughly
    wire [22:0] s_exact_3 = v_rough_3 * m_3;
    // UQ5.9: n u, roughly
    wire [13:0] s_3 = s_exact_3[22:9];
    reg [12:0] x_4;
    reg beyond_4;
    reg [13:0] s_4;
    reg [5:0] address_of_parts_4;
    reg [14:0] v_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            beyond_4 <= beyond_3;
            s_4 <= s_3;
            address_of_parts_4 <= address_of_parts_3;
            v_4 <= v_3;
        end
    end

    // ===== Stage 4: past, segment_bit_1, bound_1_0_0
    // UQ1.0: past the last segment
    wire past_4 = s_4 > 14'h0c73;
    // UQ1.0: a bit of the segment
    wire segment_bit_1_4 = s_4 > 14'h037d;
    // UQ5.9: the next bound to compare with
    wire [13:0] bound_1_0_0_4 = segment_bit_1_4 ? 14'h0672 : 14'h0180;
    // UQ2.-1: the bit at its place
    wire segment_part_1_4 = segment_bit_1_4;
    // UQ1.0: the result is 0
    wire zero_4 = beyond_4 | past_4;
    reg [12:0] x_5;
    reg [13:0] s_5;
    reg [13:0] bound_1_0_0_5;
    reg segment_part_1_5;
    reg [5:0] address_of_parts_5;
    reg [14:0] v_5;
    reg zero_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            s_5 <= s_4;
            bound_1_0_0_5 <= bound_1_0_0_4;
            segment_part_1_5 <= segment_part_1_4;
            address_of_parts_5 <= address_of_parts_4;
            v_5 <= v_4;
            zero_5 <= zero_4;
        end
    end

    // ===== Stage 5: segment_bit_0, segment_1
    // UQ1.0: a bit of the segment
    wire segment_bit_0_5 = s_5 > bound_1_0_0_5;
    // UQ1.0: the bit at its place
    wire segment_part_0_5 = segment_bit_0_5;
    // UQ2.0: the number of the segment
    wire [1:0] segment_1_5 = {segment_part_1_5, 1'd0} + {1'd0, segment_part_0_5};
    reg [12:0] x_6;
    reg [1:0] segment_1_6;
    reg [5:0] address_of_parts_6;
    reg [14:0] v_6;
    reg zero_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            segment_1_6 <= segment_1_5;
            address_of_parts_6 <= address_of_parts_5;
            v_6 <= v_5;
            zero_6 <= zero_5;
        end
    end

    // ===== Stage 6: part_address
    // UQ8.0: the address of the part
    wire [7:0] part_address_6 = {address_of_parts_6, 2'd0} + {6'd0, segment_1_6};
    reg [12:0] x_7;
    reg [7:0] part_address_7;
    reg [14:0] v_7;
    reg zero_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            part_address_7 <= part_address_6;
            v_7 <= v_6;
            zero_7 <= zero_6;
        end
    end

    // ===== Stage 7: read the ROM
    // The word of the memory rom, of 256 words.
    reg [46:0] rom_8;
    always @(posedge clk) begin
        if (ce) begin
            case (part_address_7)
                8'd0: rom_8 <= 47'h400000000000;
                8'd1: rom_8 <= 47'h400000000000;
                8'd2: rom_8 <= 47'h000000000000;
                8'd3: rom_8 <= 47'h000000000000;
                8'd4: rom_8 <= 47'h400000000000;
                8'd5: rom_8 <= 47'h400000000000;
                8'd6: rom_8 <= 47'h000000000000;
                8'd7: rom_8 <= 47'h000000000000;
                8'd8: rom_8 <= 47'h400040000000;
                8'd9: rom_8 <= 47'h400040000000;
                8'd10: rom_8 <= 47'h400040000000;
                8'd11: rom_8 <= 47'h000000000000;
                8'd12: rom_8 <= 47'h3fff7fffc800;
                8'd13: rom_8 <= 47'h3fff7fffc800;
                8'd14: rom_8 <= 47'h3fff7fff8800;
                8'd15: rom_8 <= 47'h000000000000;
                8'd16: rom_8 <= 47'h3ffc5f640573;
                8'd17: rom_8 <= 47'h3e58573a0426;
                8'd18: rom_8 <= 47'h32c43daa825f;
                8'd19: rom_8 <= 47'h1546168840bf;
                8'd20: rom_8 <= 47'h3ffa7e878a4d;
                8'd21: rom_8 <= 47'h3d3a6d3d46d1;
                8'd22: rom_8 <= 47'h2e6743e2432e;
                8'd23: rom_8 <= 47'h101512b640ae;
                8'd24: rom_8 <= 47'h3ff79d87508e;
                8'd25: rom_8 <= 47'h3c7682db0a0c;
                8'd26: rom_8 <= 47'h2c2d4bff0438;
                8'd27: rom_8 <= 47'h0d3610c140a9;
                8'd28: rom_8 <= 47'h3ff5bc751836;
                8'd29: rom_8 <= 47'h3bea985ccdde;
                8'd30: rom_8 <= 47'h2ad254db4575;
                8'd31: rom_8 <= 47'h0bb1101a00af;
                8'd32: rom_8 <= 47'h3ff36dab8852;
                8'd33: rom_8 <= 47'h3b8356e58491;
                8'd34: rom_8 <= 47'h29ed2f1401b9;
                8'd35: rom_8 <= 47'h0b7a08c58035;
                8'd36: rom_8 <= 47'h3ff27d164aed;
                8'd37: rom_8 <= 47'h3b2d618185ce;
                8'd38: rom_8 <= 47'h293933b8421f;
                8'd39: rom_8 <= 47'h0b7a09b34041;
                8'd40: rom_8 <= 47'h3ff18c83cde3;
                8'd41: rom_8 <= 47'h3aec6c2a8732;
                8'd42: rom_8 <= 47'h28b538764291;
                8'd43: rom_8 <= 47'h0b6f0a98404e;
                8'd44: rom_8 <= 47'h3ff19beb5130;
                8'd45: rom_8 <= 47'h3ab476cc08bc;
                8'd46: rom_8 <= 47'h284a3d39430e;
                8'd47: rom_8 <= 47'h0b8e0bae005e;
                8'd48: rom_8 <= 47'h3ff0ab4f54d6;
                8'd49: rom_8 <= 47'h3a898172ca6c;
                8'd50: rom_8 <= 47'h27fe421ac398;
                8'd51: rom_8 <= 47'h0b870c9c406e;
                8'd52: rom_8 <= 47'h3fefbab818da;
                8'd53: rom_8 <= 47'h3a638c0c8c3f;
                8'd54: rom_8 <= 47'h27b246e0c42b;
                8'd55: rom_8 <= 47'h0ba00db48081;
                8'd56: rom_8 <= 47'h3fefca1e1d34;
                8'd57: rom_8 <= 47'h3a4796c18e3c;
                8'd58: rom_8 <= 47'h277c4bc304cb;
                8'd59: rom_8 <= 47'h0b9d0eaa4094;
                8'd60: rom_8 <= 47'h3feed977e1df;
                8'd61: rom_8 <= 47'h3a24a13f5058;
                8'd62: rom_8 <= 47'h274850970575;
                8'd63: rom_8 <= 47'h0ba40faec0a9;
                8'd64: rom_8 <= 47'h3fed746dc9bc;
                8'd65: rom_8 <= 47'h3a0e55f0c4a7;
                8'd66: rom_8 <= 47'h27212ac0418b;
                8'd67: rom_8 <= 47'h0baf085f0030;
                8'd68: rom_8 <= 47'h3fed7c1ccb14;
                8'd69: rom_8 <= 47'h39f65b38c541;
                8'd70: rom_8 <= 47'h26f82d2a01bb;
                8'd71: rom_8 <= 47'h0bb508e24036;
                8'd72: rom_8 <= 47'h3fec83ca0c84;
                8'd73: rom_8 <= 47'h39df607605e3;
                8'd74: rom_8 <= 47'h26d52f9801ee;
                8'd75: rom_8 <= 47'h0bad0959403c;
                8'd76: rom_8 <= 47'h3fec8b7a0e07;
                8'd77: rom_8 <= 47'h39cd65c14690;
                8'd78: rom_8 <= 47'h26b131fac223;
                8'd79: rom_8 <= 47'h0bbc09e68043;
                8'd80: rom_8 <= 47'h3fec9337cfab;
                8'd81: rom_8 <= 47'h39c86b34874b;
                8'd82: rom_8 <= 47'h269a3471425c;
                8'd83: rom_8 <= 47'h0bbe0a68004a;
                8'd84: rom_8 <= 47'h3fec9ae2115a;
                8'd85: rom_8 <= 47'h39b3706f480a;
                8'd86: rom_8 <= 47'h268d36f8c299;
                8'd87: rom_8 <= 47'h0bd10afc8052;
                8'd88: rom_8 <= 47'h3feba2985324;
                8'd89: rom_8 <= 47'h39aa75bd48d2;
                8'd90: rom_8 <= 47'h2669394902d5;
                8'd91: rom_8 <= 47'h0bc00b698059;
                8'd92: rom_8 <= 47'h3fecaa46d501;
                8'd93: rom_8 <= 47'h39a47b2a09aa;
                8'd94: rom_8 <= 47'h26643bd88318;
                8'd95: rom_8 <= 47'h0bc00be94061;
                8'd96: rom_8 <= 47'h3febb1ecd6f1;
                8'd97: rom_8 <= 47'h399280560a82;
                8'd98: rom_8 <= 47'h26523e4b035c;
                8'd99: rom_8 <= 47'h0bcd0c7a006a;
                8'd100: rom_8 <= 47'h3feab99858f9;
                8'd101: rom_8 <= 47'h397d856f4b61;
                8'd102: rom_8 <= 47'h2632409883a0;
                8'd103: rom_8 <= 47'h0bd20d014073;
                8'd104: rom_8 <= 47'h3feac14d5b1e;
                8'd105: rom_8 <= 47'h397a8acc0c50;
                8'd106: rom_8 <= 47'h262a431c83eb;
                8'd107: rom_8 <= 47'h0bd10d7f807c;
                8'd108: rom_8 <= 47'h3feac8f19d4c;
                8'd109: rom_8 <= 47'h3971901c8d4a;
                8'd110: rom_8 <= 47'h2623459c8438;
                8'd111: rom_8 <= 47'h0bca0df68085;
                8'd112: rom_8 <= 47'h3febd0bb9fae;
                8'd113: rom_8 <= 47'h397295964e53;
                8'd114: rom_8 <= 47'h2613480a4487;
                8'd115: rom_8 <= 47'h0bdb0e914090;
                8'd116: rom_8 <= 47'h3fead85361fe;
                8'd117: rom_8 <= 47'h39609aa90f55;
                8'd118: rom_8 <= 47'h260a4a8004d9;
                8'd119: rom_8 <= 47'h0bd90f0f409a;
                8'd120: rom_8 <= 47'h3feae0112485;
                8'd121: rom_8 <= 47'h395fa00ed06c;
                8'd122: rom_8 <= 47'h25f54cd5c52b;
                8'd123: rom_8 <= 47'h0bd30f85c0a4;
                8'd124: rom_8 <= 47'h3feae7b4670b;
                8'd125: rom_8 <= 47'h3956a552518a;
                8'd126: rom_8 <= 47'h25f14f5a8584;
                8'd127: rom_8 <= 47'h0bd3100880af;
                8'd128: rom_8 <= 47'h3fea77ae8a6b;
                8'd129: rom_8 <= 47'h394b553b44aa;
                8'd130: rom_8 <= 47'h25ea28ed8178;
                8'd131: rom_8 <= 47'h0be80856002f;
                8'd132: rom_8 <= 47'h3fe97b880b1b;
                8'd133: rom_8 <= 47'h394b57f384f8;
                8'd134: rom_8 <= 47'h25e02a22c18f;
                8'd135: rom_8 <= 47'h0bc208754031;
                8'd136: rom_8 <= 47'h3fea7f644bd3;
                8'd137: rom_8 <= 47'h39475a980546;
                8'd138: rom_8 <= 47'h25cc2b4941a6;
                8'd139: rom_8 <= 47'h0bc508b7c034;
                8'd140: rom_8 <= 47'h3fea83458c91;
                8'd141: rom_8 <= 47'h39475d54859a;
                8'd142: rom_8 <= 47'h25c82c8941bf;
                8'd143: rom_8 <= 47'h0be70918c038;
                8'd144: rom_8 <= 47'h3fea87138d4c;
                8'd145: rom_8 <= 47'h393f5fec05eb;
                8'd146: rom_8 <= 47'h25d02ddf81da;
                8'd147: rom_8 <= 47'h0be20954403b;
                8'd148: rom_8 <= 47'h3fe98ae28e0c;
                8'd149: rom_8 <= 47'h392e6262463b;
                8'd150: rom_8 <= 47'h25be2f0501f3;
                8'd151: rom_8 <= 47'h0bda098cc03e;
                8'd152: rom_8 <= 47'h3fe88eb48ed6;
                8'd153: rom_8 <= 47'h392664f90691;
                8'd154: rom_8 <= 47'h25b13032820d;
                8'd155: rom_8 <= 47'h0bcf09c28041;
                8'd156: rom_8 <= 47'h3fea92a70fb4;
                8'd157: rom_8 <= 47'h393567e586f3;
                8'd158: rom_8 <= 47'h25b031754229;
                8'd159: rom_8 <= 47'h0bdf0a14c045;
                8'd160: rom_8 <= 47'h3fe9967f908a;
                8'd161: rom_8 <= 47'h39376aa50753;
                8'd162: rom_8 <= 47'h25ac32af4245;
                8'd163: rom_8 <= 47'h0bd10a460048;
                8'd164: rom_8 <= 47'h3fe89a399156;
                8'd165: rom_8 <= 47'h391c6ce987a6;
                8'd166: rom_8 <= 47'h259e33da4261;
                8'd167: rom_8 <= 47'h0bdd0a93804c;
                8'd168: rom_8 <= 47'h3fe99e18523b;
                8'd169: rom_8 <= 47'h391b6f98c808;
                8'd170: rom_8 <= 47'h259b3519827f;
                8'd171: rom_8 <= 47'h0be50add4050;
                8'd172: rom_8 <= 47'h3fe9a1f81327;
                8'd173: rom_8 <= 47'h3920725c086f;
                8'd174: rom_8 <= 47'h258e3641829c;
                8'd175: rom_8 <= 47'h0bd10b074053;
                8'd176: rom_8 <= 47'h3feaa5df941d;
                8'd177: rom_8 <= 47'h3926753008dc;
                8'd178: rom_8 <= 47'h2591378bc2bc;
                8'd179: rom_8 <= 47'h0bd50b4c4057;
                8'd180: rom_8 <= 47'h3fe9a9a09501;
                8'd181: rom_8 <= 47'h391a77b60941;
                8'd182: rom_8 <= 47'h259c38e782de;
                8'd183: rom_8 <= 47'h0bd70b8ec05b;
                8'd184: rom_8 <= 47'h3fe8ad8cd605;
                8'd185: rom_8 <= 47'h391e7a7549ae;
                8'd186: rom_8 <= 47'h258239f182fb;
                8'd187: rom_8 <= 47'h0bd60bcec05f;
                8'd188: rom_8 <= 47'h3fe8b151d6f6;
                8'd189: rom_8 <= 47'h390c7ccf8a10;
                8'd190: rom_8 <= 47'h25733b0f031a;
                8'd191: rom_8 <= 47'h0bd40c0c0063;
                8'd192: rom_8 <= 47'h3fe8b51817ed;
                8'd193: rom_8 <= 47'h390b7f8a4a84;
                8'd194: rom_8 <= 47'h25893c854340;
                8'd195: rom_8 <= 47'h0bd00c480067;
                8'd196: rom_8 <= 47'h3fe8b90fd90c;
                8'd197: rom_8 <= 47'h391b827c4aff;
                8'd198: rom_8 <= 47'h258c3dd18364;
                8'd199: rom_8 <= 47'h0bde0c9a406c;
                8'd200: rom_8 <= 47'h3fe9bcdada11;
                8'd201: rom_8 <= 47'h390484b44b61;
                8'd202: rom_8 <= 47'h25613eac0380;
                8'd203: rom_8 <= 47'h0bd70cd1c070;
                8'd204: rom_8 <= 47'h3fe9c0a6db1c;
                8'd205: rom_8 <= 47'h38fe8748cbd5;
                8'd206: rom_8 <= 47'h25764024c3a9;
                8'd207: rom_8 <= 47'h0be20d204075;
                8'd208: rom_8 <= 47'h3fe7c4731c2c;
                8'd209: rom_8 <= 47'h38fa89eccc4f;
                8'd210: rom_8 <= 47'h257a4171c3cf;
                8'd211: rom_8 <= 47'h0be80d6ac07a;
                8'd212: rom_8 <= 47'h3fe8c8429d45;
                8'd213: rom_8 <= 47'h38fa8ca60cce;
                8'd214: rom_8 <= 47'h257642a2c3f3;
                8'd215: rom_8 <= 47'h0bdc0d9b807e;
                8'd216: rom_8 <= 47'h3fe8cc13de64;
                8'd217: rom_8 <= 47'h38ee8f084d3f;
                8'd218: rom_8 <= 47'h256a43cb4418;
                8'd219: rom_8 <= 47'h0be10de2c083;
                8'd220: rom_8 <= 47'h3fe9d0261fba;
                8'd221: rom_8 <= 47'h390192160dce;
                8'd222: rom_8 <= 47'h254c44b80438;
                8'd223: rom_8 <= 47'h0bd30e100087;
                8'd224: rom_8 <= 47'h3fe9d3fe20ea;
                8'd225: rom_8 <= 47'h390b95044e5d;
                8'd226: rom_8 <= 47'h257146618469;
                8'd227: rom_8 <= 47'h0be40e6a008d;
                8'd228: rom_8 <= 47'h3fe8d795a1ed;
                8'd229: rom_8 <= 47'h38e796e80ec1;
                8'd230: rom_8 <= 47'h25614777c48e;
                8'd231: rom_8 <= 47'h0be40eaa8092;
                8'd232: rom_8 <= 47'h3fe7db6fe32a;
                8'd233: rom_8 <= 47'h38e69984cf44;
                8'd234: rom_8 <= 47'h255b48a804b6;
                8'd235: rom_8 <= 47'h0be20ee8c097;
                8'd236: rom_8 <= 47'h3fe7df4be46c;
                8'd237: rom_8 <= 47'h38e59c2a0fcc;
                8'd238: rom_8 <= 47'h255649db84df;
                8'd239: rom_8 <= 47'h0be10f27009c;
                8'd240: rom_8 <= 47'h3fe8e32c65b7;
                8'd241: rom_8 <= 47'h38e59edd105a;
                8'd242: rom_8 <= 47'h25414ad8c503;
                8'd243: rom_8 <= 47'h0bd00f4d40a0;
                8'd244: rom_8 <= 47'h3fe7e70ea70a;
                8'd245: rom_8 <= 47'h38eaa1a310eb;
                8'd246: rom_8 <= 47'h25494c32c531;
                8'd247: rom_8 <= 47'h0bd90f9bc0a6;
                8'd248: rom_8 <= 47'h3fe7eaf3a867;
                8'd249: rom_8 <= 47'h38efa4755184;
                8'd250: rom_8 <= 47'h253e4d4d0559;
                8'd251: rom_8 <= 47'h0bd30fd300ab;
                8'd252: rom_8 <= 47'h3fe8eedbe9cd;
                8'd253: rom_8 <= 47'h38f8a75d9224;
                8'd254: rom_8 <= 47'h25534ed3858d;
                8'd255: rom_8 <= 47'h0be41030c0b2;
                default: rom_8 <= 47'h400000000000;
            endcase
        end
    end
    reg [12:0] x_8;
    reg [14:0] v_8;
    reg zero_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            v_8 <= v_7;
            zero_8 <= zero_7;
        end
    end

    // ===== Stage 8: registers only
    // UQ1.14: the coefficient c
    wire [14:0] c_8 = rom_8[46:32];
    // UQ0.18: the coefficient A, times 2^-k
    wire [17:0] big_a_8 = rom_8[31:14];
    // UQ-1.15: the coefficient a, times 4^-k
    wire [13:0] a_8 = rom_8[13:0];
    reg [12:0] x_9;
    reg [14:0] c_9;
    reg [17:0] big_a_9;
    reg [13:0] a_9;
    reg [14:0] v_9;
    reg zero_9;
    always @(posedge clk) begin
        if (ce) begin
            x_9 <= x_8;
            c_9 <= c_8;
            big_a_9 <= big_a_8;
            a_9 <= a_8;
            v_9 <= v_8;
            zero_9 <= zero_8;
        end
    end

    // ===== Stage 9: registers only
    reg [12:0] x_10;
    reg [14:0] c_10;
    reg [17:0] big_a_10;
    reg [13:0] a_10;
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

    // ===== Stage 10: av
    // UQ3.26: (a 4^-k) v
    wire [28:0] av_10 = a_10 * v_10;
    // UQ-1.18: (a 4^-k) v, rounded down
    wire [16:0] r_10 = av_10[24:8];
    reg [12:0] x_11;
    reg [14:0] c_11;
    reg [17:0] big_a_11;
    reg [14:0] v_11;
    reg [16:0] r_11;
    reg zero_11;
    always @(posedge clk) begin
        if (ce) begin
            x_11 <= x_10;
            c_11 <= c_10;
            big_a_11 <= big_a_10;
            v_11 <= v_10;
            r_11 <= r_10;
            zero_11 <= zero_10;
        end
    end

    // ===== Stage 11: q
    // UQ0.18: q = (A - a u) 2^-k
    wire [17:0] q_11 = big_a_11 - {1'd0, r_11};
    reg [12:0] x_12;
    reg [14:0] c_12;
    reg [14:0] v_12;
    reg [17:0] q_12;
    reg zero_12;
    always @(posedge clk) begin
        if (ce) begin
            x_12 <= x_11;
            c_12 <= c_11;
            v_12 <= v_11;
            q_12 <= q_11;
            zero_12 <= zero_11;
        end
    end

    // ===== Stage 12: vq
    // UQ4.29: u (A - a u) = v q
    wire [32:0] vq_12 = v_12 * q_12;
    // UQ0.14: u (A - a u), rounded down
    wire [13:0] m_12 = vq_12[28:15];
    reg [12:0] x_13;
    reg [14:0] c_13;
    reg [13:0] m_13;
    reg zero_13;
    always @(posedge clk) begin
        if (ce) begin
            x_13 <= x_12;
            c_13 <= c_12;
            m_13 <= m_12;
            zero_13 <= zero_12;
        end
    end

    // ===== Stage 13: d, d_positive
    // Q1.14: d = c - u (A - a u)
    wire [15:0] d_13 = {1'd0, c_13} - {2'd0, m_13};
    // UQ1.14: d, at least 0
    wire [14:0] d_positive_13 = d_13[15] ? 15'h0000 : d_13[14:0];
    reg [12:0] x_14;
    reg [14:0] d_positive_14;
    reg zero_14;
    always @(posedge clk) begin
        if (ce) begin
            x_14 <= x_13;
            d_positive_14 <= d_positive_13;
            zero_14 <= zero_13;
        end
    end

    // ===== Stage 14: xd
    // UQ2.26: x d
    wire [27:0] xd_14 = x_14 * d_positive_14;
    reg [27:0] xd_15;
    reg zero_15;
    always @(posedge clk) begin
        if (ce) begin
            xd_15 <= xd_14;
            zero_15 <= zero_14;
        end
    end

    // ===== Stage 15: y_half, y
    // UQ1.26: plus half an output ulp: the result is rounded to nearest
    wire [26:0] y_half_15 = xd_15[26:0] + 27'h0002000;
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_cut_15 = y_half_15[26:14];
    // UQ1.12: y, 0 past the last segment
    wire [12:0] y_15 = zero_15 ? 13'd0 : y_cut_15;
    reg [12:0] y_16;
    always @(posedge clk) begin
        if (ce) begin
            y_16 <= y_15;
        end
    end

    assign out_valid = valid[16];
    assign out_spec  = y_16;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    s_exact_3[8:0],
                    av_10[28:25],
                    av_10[7:0],
                    vq_12[32:29],
                    vq_12[14:0],
                    xd_15[27],
                    y_half_15[13:0]};

endmodule

`default_nettype wire
