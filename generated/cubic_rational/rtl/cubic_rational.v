// cubic_rational: specular lobe x^n as x(1 - u(A - a u)) to the cusp, x/(d + b u) past it, n = 1 to 127
//
// Made by: brdfgen generate core.toml
// Spec 3702d28f8874f127. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 13 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.959..+0.948.
//   measured -0.689..+0.772 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   10.089 % absolute, 0.540 % where x^n >= 1/2, 0.688 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module cubic_rational (
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
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
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

    // ===== Stage 0: read the ROM, x, u
    // The word of the memory rom, of 128 words.
    reg [61:0] rom_1;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ0.12: x, rounded down: below 1 in the tail
    wire [11:0] num_0 = x_0[11:0];
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                7'd0: rom_1 <= 62'h0000000004000800;
                7'd1: rom_1 <= 62'h0000000004000800;
                7'd2: rom_1 <= 62'h200000040b5054af;
                7'd3: rom_1 <= 62'h20001008130c834d;
                7'd4: rom_1 <= 62'h2f972ae81ae8a28b;
                7'd5: rom_1 <= 62'h3effd04822d27212;
                7'd6: rom_1 <= 62'h2727a00c2ac361be;
                7'd7: rom_1 <= 62'h2ec22e6c32b87182;
                7'd8: rom_1 <= 62'h365fbf8c3ab03153;
                7'd9: rom_1 <= 62'h3df3530c42a9c12f;
                7'd10: rom_1 <= 62'h22c19a504aa48112;
                7'd11: rom_1 <= 62'h268f209052a040fa;
                7'd12: rom_1 <= 62'h2a5427505a9ca0e5;
                7'd13: rom_1 <= 62'h2e1eaed06299a0d4;
                7'd14: rom_1 <= 62'h31e7b6f06a9700c5;
                7'd15: rom_1 <= 62'h35afbfb07294c0b8;
                7'd16: rom_1 <= 62'h3976c9107a92c0ad;
                7'd17: rom_1 <= 62'h3d3d5310829100a3;
                7'd18: rom_1 <= 62'h207f97748a8f709a;
                7'd19: rom_1 <= 62'h22661a54928e0092;
                7'd20: rom_1 <= 62'h244a9d549a8cc08b;
                7'd21: rom_1 <= 62'h262ca074a28ba084;
                7'd22: rom_1 <= 62'h280d23b4aa8a907f;
                7'd23: rom_1 <= 62'h29f22734b289a079;
                7'd24: rom_1 <= 62'h2bd52ad4ba88c074;
                7'd25: rom_1 <= 62'h2db72e94c287f070;
                7'd26: rom_1 <= 62'h2f9cb294ca87306b;
                7'd27: rom_1 <= 62'h317b3694d2868067;
                7'd28: rom_1 <= 62'h335e3ad4da85e064;
                7'd29: rom_1 <= 62'h35443f54e2854060;
                7'd30: rom_1 <= 62'h372443d4ea84b05d;
                7'd31: rom_1 <= 62'h3907c894f284305a;
                7'd32: rom_1 <= 62'h3ae9cd74fa83b057;
                7'd33: rom_1 <= 62'h3cced29502834055;
                7'd34: rom_1 <= 62'h3eb2d7d50a82d052;
                7'd35: rom_1 <= 62'h2048975912826050;
                7'd36: rom_1 <= 62'h213998b91a82004e;
                7'd37: rom_1 <= 62'h22301a392281a04c;
                7'd38: rom_1 <= 62'h231b9b992a81504a;
                7'd39: rom_1 <= 62'h240d1d1932810048;
                7'd40: rom_1 <= 62'h25031eb93a80b046;
                7'd41: rom_1 <= 62'h25efa03942806044;
                7'd42: rom_1 <= 62'h26e121d94a801043;
                7'd43: rom_1 <= 62'h27d7a399527fd041;
                7'd44: rom_1 <= 62'h28c4a5395a7f9040;
                7'd45: rom_1 <= 62'h29b6a6f9627f503e;
                7'd46: rom_1 <= 62'h2aaca8d96a7f103d;
                7'd47: rom_1 <= 62'h2b9a2a99727ee03b;
                7'd48: rom_1 <= 62'h2c8c2c797a7ea03a;
                7'd49: rom_1 <= 62'h2d7c2e59827e7039;
                7'd50: rom_1 <= 62'h2e7030598a7e4038;
                7'd51: rom_1 <= 62'h2f62b259927e1037;
                7'd52: rom_1 <= 62'h3052b4599a7de036;
                7'd53: rom_1 <= 62'h31413659a27db035;
                7'd54: rom_1 <= 62'h3233b879aa7d8034;
                7'd55: rom_1 <= 62'h3324ba99b27d5033;
                7'd56: rom_1 <= 62'h3418bcd9ba7d3032;
                7'd57: rom_1 <= 62'h350b3f19c27d0031;
                7'd58: rom_1 <= 62'h35fbc159ca7ce030;
                7'd59: rom_1 <= 62'h36eb4399d27cc02f;
                7'd60: rom_1 <= 62'h37ddc5f9da7c902f;
                7'd61: rom_1 <= 62'h38cec859e27c802e;
                7'd62: rom_1 <= 62'h39becab9ea7c502d;
                7'd63: rom_1 <= 62'h3ab14d39f27c302c;
                7'd64: rom_1 <= 62'h3ba2cfb9fa7c202c;
                7'd65: rom_1 <= 62'h3c92d23a027c002b;
                7'd66: rom_1 <= 62'h3d8554da0a7be02a;
                7'd67: rom_1 <= 62'h3e76d77a127bc02a;
                7'd68: rom_1 <= 62'h3f66da1a1a7ba029;
                7'd69: rom_1 <= 62'h2028973e227b9028;
                7'd70: rom_1 <= 62'h20a597fe2a7b7028;
                7'd71: rom_1 <= 62'h211a189e327b7027;
                7'd72: rom_1 <= 62'h2195995e3a7b4027;
                7'd73: rom_1 <= 62'h22109a1e427b2026;
                7'd74: rom_1 <= 62'h228a9ade4a7b1026;
                7'd75: rom_1 <= 62'h23041b9e527b0025;
                7'd76: rom_1 <= 62'h23759c3e5a7ae025;
                7'd77: rom_1 <= 62'h23f51d1e627ad024;
                7'd78: rom_1 <= 62'h246d1dde6a7ab024;
                7'd79: rom_1 <= 62'h24e41e9e727aa023;
                7'd80: rom_1 <= 62'h255b1f5e7a7a9023;
                7'd81: rom_1 <= 62'h25d1201e827a8022;
                7'd82: rom_1 <= 62'h264da0fe8a7a7022;
                7'd83: rom_1 <= 62'h26c2a1be927a6022;
                7'd84: rom_1 <= 62'h273e229e9a7a4021;
                7'd85: rom_1 <= 62'h27b9237ea27a3021;
                7'd86: rom_1 <= 62'h282ca43eaa7a2020;
                7'd87: rom_1 <= 62'h28a6a51eb27a1020;
                7'd88: rom_1 <= 62'h291fa5feba7a0020;
                7'd89: rom_1 <= 62'h299826dec279f01f;
                7'd90: rom_1 <= 62'h2a10a7beca79e01f;
                7'd91: rom_1 <= 62'h2a88289ed279d01f;
                7'd92: rom_1 <= 62'h2b05a99eda79c01e;
                7'd93: rom_1 <= 62'h2b7c2a7ee279b01e;
                7'd94: rom_1 <= 62'h2bf2ab5eea79a01e;
                7'd95: rom_1 <= 62'h2c6eac5ef279a01d;
                7'd96: rom_1 <= 62'h2ce3ad3efa79901d;
                7'd97: rom_1 <= 62'h2d5eae3f0279801d;
                7'd98: rom_1 <= 62'h2dd92f3f0a79701c;
                7'd99: rom_1 <= 62'h2e52b03f1279601c;
                7'd100: rom_1 <= 62'h2ecc313f1a79501c;
                7'd101: rom_1 <= 62'h2f3f321f2279501c;
                7'd102: rom_1 <= 62'h2fbdb33f2a79401b;
                7'd103: rom_1 <= 62'h3035b43f3279301b;
                7'd104: rom_1 <= 62'h30ad353f3a79201b;
                7'd105: rom_1 <= 62'h3124363f4279201a;
                7'd106: rom_1 <= 62'h319b373f4a79101a;
                7'd107: rom_1 <= 62'h3216b85f5279001a;
                7'd108: rom_1 <= 62'h328cb95f5a79001a;
                7'd109: rom_1 <= 62'h33073a7f6278f019;
                7'd110: rom_1 <= 62'h3381bb9f6a78e019;
                7'd111: rom_1 <= 62'h33f6bc9f7278e019;
                7'd112: rom_1 <= 62'h34703dbf7a78d019;
                7'd113: rom_1 <= 62'h34e93edf8278c019;
                7'd114: rom_1 <= 62'h3561bfff8a78c018;
                7'd115: rom_1 <= 62'h35da411f9278b018;
                7'd116: rom_1 <= 62'h3652423f9a78b018;
                7'd117: rom_1 <= 62'h36cec37fa278a018;
                7'd118: rom_1 <= 62'h3745c49faa78a017;
                7'd119: rom_1 <= 62'h37bc45bfb2789017;
                7'd120: rom_1 <= 62'h3837c6ffba788017;
                7'd121: rom_1 <= 62'h38adc81fc2788017;
                7'd122: rom_1 <= 62'h3928495fca787017;
                7'd123: rom_1 <= 62'h39a24a9fd2787017;
                7'd124: rom_1 <= 62'h3a1bcbdfda786016;
                7'd125: rom_1 <= 62'h3a904cffe2786016;
                7'd126: rom_1 <= 62'h3b094e3fea785016;
                7'd127: rom_1 <= 62'h3b81cf7ff2785016;
                default: rom_1 <= 62'h0000000004000800;
            endcase
        end
    end
    reg [12:0] x_1;
    reg [12:0] u_1;
    reg [11:0] num_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            u_1 <= u_0;
            num_1 <= num_0;
        end
    end

    // ===== Stage 1: registers only
    // UQ0.12: the largest versine of the cubic
    wire [11:0] cut_1 = rom_1[11:0];
    // UQ0.15: the coefficient A, times 2^-k
    wire [14:0] big_a_1 = rom_1[61:47];
    // UQ-1.11: the coefficient a, times 4^-k
    wire [9:0] a_1 = rom_1[46:37];
    // UQ3.0: shift of the versine
    wire [2:0] k_1 = rom_1[36:34];
    // UQ8.-1: the tail's slope b
    wire [6:0] b_1 = rom_1[33:27];
    // UQ1.14: the tail's constant d
    wire [14:0] d_1 = rom_1[26:12];
    reg [12:0] x_2;
    reg [12:0] u_2;
    reg [11:0] cut_2;
    reg [14:0] big_a_2;
    reg [9:0] a_2;
    reg [2:0] k_2;
    reg [6:0] b_2;
    reg [14:0] d_2;
    reg [11:0] num_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            u_2 <= u_1;
            cut_2 <= cut_1;
            big_a_2 <= big_a_1;
            a_2 <= a_1;
            k_2 <= k_1;
            b_2 <= b_1;
            d_2 <= d_1;
            num_2 <= num_1;
        end
    end

    // ===== Stage 2: registers only
    reg [12:0] x_3;
    reg [12:0] u_3;
    reg [11:0] cut_3;
    reg [14:0] big_a_3;
    reg [9:0] a_3;
    reg [2:0] k_3;
    reg [6:0] b_3;
    reg [14:0] d_3;
    reg [11:0] num_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            u_3 <= u_2;
            cut_3 <= cut_2;
            big_a_3 <= big_a_2;
            a_3 <= a_2;
            k_3 <= k_2;
            b_3 <= b_2;
            d_3 <= d_2;
            num_3 <= num_2;
        end
    end

    // ===== Stage 3: past, u_scaled, bu
    // UQ1.0: u > cut: past the cubic's versines
    wire past_3 = u_3 > {1'd0, cut_3};
    // UQ1.12: u 2^k
    wire [12:0] u_scaled_3 = u_3 << k_3;
    // UQ1.11: v = u 2^k, rounded down; wraps past the cut
    wire [11:0] v_3 = u_scaled_3[12:1];
    // UQ9.11: b u
    wire [19:0] bu_3 = b_3 * u_3;
    reg [12:0] x_4;
    reg past_4;
    reg [14:0] big_a_4;
    reg [9:0] a_4;
    reg [11:0] v_4;
    reg [14:0] d_4;
    reg [11:0] num_4;
    reg [19:0] bu_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            past_4 <= past_3;
            big_a_4 <= big_a_3;
            a_4 <= a_3;
            v_4 <= v_3;
            d_4 <= d_3;
            num_4 <= num_3;
            bu_4 <= bu_3;
        end
    end

    // ===== Stage 4: den, m_4
    // UQ8.14: the tail's denominator, d + b u
    wire [21:0] den_4 = {7'd0, d_4} + {bu_4[18:0], 3'd0};
    // UQ8.-4: the bits from 2^4 on
    wire [3:0] from_4_bits_4 = den_4[21:18];
    // UQ1.0: the denominator is 2^4 or more
    wire from_4_4 = |from_4_bits_4;
    // UQ4.18: times 2^-4
    wire [21:0] m_4_high_4 = den_4;
    // UQ4.14: in one format
    wire [17:0] m_4_high_wide_4 = m_4_high_4[21:4];
    // UQ4.14: in one format
    wire [17:0] m_4_low_wide_4 = den_4[17:0];
    // UQ4.14: below 2^4
    wire [17:0] m_4_4 = from_4_4 ? m_4_high_wide_4 : m_4_low_wide_4;
    // UQ4.-2: the bits from 2^2 on
    wire [1:0] from_2_bits_4 = m_4_4[17:16];
    // UQ2.16: times 2^-2
    wire [17:0] m_2_high_4 = m_4_4;
    // UQ2.14: in one format
    wire [15:0] m_2_high_wide_4 = m_2_high_4[17:2];
    // UQ2.14: in one format
    wire [15:0] m_2_low_wide_4 = m_4_4[15:0];
    reg [12:0] x_5;
    reg past_5;
    reg [14:0] big_a_5;
    reg [9:0] a_5;
    reg [11:0] v_5;
    reg [11:0] num_5;
    reg from_4_5;
    reg [1:0] from_2_bits_5;
    reg [15:0] m_2_high_wide_5;
    reg [15:0] m_2_low_wide_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            past_5 <= past_4;
            big_a_5 <= big_a_4;
            a_5 <= a_4;
            v_5 <= v_4;
            num_5 <= num_4;
            from_4_5 <= from_4_4;
            from_2_bits_5 <= from_2_bits_4;
            m_2_high_wide_5 <= m_2_high_wide_4;
            m_2_low_wide_5 <= m_2_low_wide_4;
        end
    end

    // ===== Stage 5: av, m_2, m_1
    // UQ0.22: (a 4^-k) v
    wire [21:0] av_5 = a_5 * v_5;
    // UQ-2.15: (a 4^-k) v, rounded down
    wire [12:0] r_5 = av_5[19:7];
    // UQ1.0: the denominator is 2^2 or more
    wire from_2_5 = |from_2_bits_5;
    // UQ2.14: below 2^2
    wire [15:0] m_2_5 = from_2_5 ? m_2_high_wide_5 : m_2_low_wide_5;
    // UQ2.-1: the bits from 2^1 on
    wire from_1_bits_5 = m_2_5[15];
    // UQ1.15: times 2^-1
    wire [15:0] m_1_high_5 = m_2_5;
    // UQ1.14: in one format
    wire [14:0] m_1_high_wide_5 = m_1_high_5[15:1];
    // UQ1.14: in one format
    wire [14:0] m_1_low_wide_5 = m_2_5[14:0];
    // UQ1.14: below 2^1
    wire [14:0] m_1_5 = from_1_bits_5 ? m_1_high_wide_5 : m_1_low_wide_5;
    // UQ0.14: m - 1, rounded down
    wire [13:0] fraction_5 = m_1_5[13:0];
    // UQ0.6: the entry of the table
    wire [5:0] entry_5 = fraction_5[13:8];
    // UQ-6.14: m less the entry's least m
    wire [7:0] offset_5 = fraction_5[7:0];
    reg [12:0] x_6;
    reg past_6;
    reg [14:0] big_a_6;
    reg [11:0] v_6;
    reg [12:0] r_6;
    reg [11:0] num_6;
    reg from_4_6;
    reg from_2_6;
    reg from_1_bits_6;
    reg [5:0] entry_6;
    reg [7:0] offset_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            past_6 <= past_5;
            big_a_6 <= big_a_5;
            v_6 <= v_5;
            r_6 <= r_5;
            num_6 <= num_5;
            from_4_6 <= from_4_5;
            from_2_6 <= from_2_5;
            from_1_bits_6 <= from_1_bits_5;
            entry_6 <= entry_5;
            offset_6 <= offset_5;
        end
    end

    // ===== Stage 6: read reciprocal, q
    // The word of the memory reciprocal, of 64 words.
    reg [21:0] reciprocal_7;
    // UQ0.15: q = (A - a u) 2^-k; wraps past the cut
    wire [14:0] q_6 = big_a_6 - {2'd0, r_6};
    always @(posedge clk) begin
        if (ce) begin
            case (entry_6)
                6'd0: reciprocal_7 <= 22'h3fff3f;
                6'd1: reciprocal_7 <= 22'h3f02fd;
                6'd2: reciprocal_7 <= 22'h3e0e7b;
                6'd3: reciprocal_7 <= 22'h3d22fa;
                6'd4: reciprocal_7 <= 22'h3c3bf8;
                6'd5: reciprocal_7 <= 22'h3b5bb6;
                6'd6: reciprocal_7 <= 22'h3a83b5;
                6'd7: reciprocal_7 <= 22'h39afb3;
                6'd8: reciprocal_7 <= 22'h38e332;
                6'd9: reciprocal_7 <= 22'h381cb1;
                6'd10: reciprocal_7 <= 22'h3758ef;
                6'd11: reciprocal_7 <= 22'h369c6e;
                6'd12: reciprocal_7 <= 22'h35e4ed;
                6'd13: reciprocal_7 <= 22'h35322c;
                6'd14: reciprocal_7 <= 22'h3483eb;
                6'd15: reciprocal_7 <= 22'h33d7e9;
                6'd16: reciprocal_7 <= 22'h3331e8;
                6'd17: reciprocal_7 <= 22'h329027;
                6'd18: reciprocal_7 <= 22'h31f427;
                6'd19: reciprocal_7 <= 22'h3159e6;
                6'd20: reciprocal_7 <= 22'h30c365;
                6'd21: reciprocal_7 <= 22'h303024;
                6'd22: reciprocal_7 <= 22'h2fa023;
                6'd23: reciprocal_7 <= 22'h2f13e2;
                6'd24: reciprocal_7 <= 22'h2e8a61;
                6'd25: reciprocal_7 <= 22'h2e0621;
                6'd26: reciprocal_7 <= 22'h2d8260;
                6'd27: reciprocal_7 <= 22'h2d01df;
                6'd28: reciprocal_7 <= 22'h2c861f;
                6'd29: reciprocal_7 <= 22'h2c0a9e;
                6'd30: reciprocal_7 <= 22'h2b921d;
                6'd31: reciprocal_7 <= 22'h2b1ddd;
                6'd32: reciprocal_7 <= 22'h2aaa1c;
                6'd33: reciprocal_7 <= 22'h2a3a9c;
                6'd34: reciprocal_7 <= 22'h29cb5b;
                6'd35: reciprocal_7 <= 22'h295e9a;
                6'd36: reciprocal_7 <= 22'h28f59a;
                6'd37: reciprocal_7 <= 22'h288cd9;
                6'd38: reciprocal_7 <= 22'h2827d9;
                6'd39: reciprocal_7 <= 22'h27c318;
                6'd40: reciprocal_7 <= 22'h276218;
                6'd41: reciprocal_7 <= 22'h270318;
                6'd42: reciprocal_7 <= 22'h26a3d7;
                6'd43: reciprocal_7 <= 22'h264817;
                6'd44: reciprocal_7 <= 22'h25ec56;
                6'd45: reciprocal_7 <= 22'h259416;
                6'd46: reciprocal_7 <= 22'h253b55;
                6'd47: reciprocal_7 <= 22'h24e655;
                6'd48: reciprocal_7 <= 22'h249295;
                6'd49: reciprocal_7 <= 22'h243e94;
                6'd50: reciprocal_7 <= 22'h23edd4;
                6'd51: reciprocal_7 <= 22'h239e94;
                6'd52: reciprocal_7 <= 22'h234e93;
                6'd53: reciprocal_7 <= 22'h230213;
                6'd54: reciprocal_7 <= 22'h22b6d3;
                6'd55: reciprocal_7 <= 22'h226a92;
                6'd56: reciprocal_7 <= 22'h2221d2;
                6'd57: reciprocal_7 <= 22'h21da52;
                6'd58: reciprocal_7 <= 22'h2191d1;
                6'd59: reciprocal_7 <= 22'h214c91;
                6'd60: reciprocal_7 <= 22'h210851;
                6'd61: reciprocal_7 <= 22'h20c511;
                6'd62: reciprocal_7 <= 22'h208110;
                6'd63: reciprocal_7 <= 22'h204010;
                default: reciprocal_7 <= 22'h3fff3f;
            endcase
        end
    end
    reg [12:0] x_7;
    reg past_7;
    reg [11:0] v_7;
    reg [14:0] q_7;
    reg [11:0] num_7;
    reg from_4_7;
    reg from_2_7;
    reg from_1_bits_7;
    reg [7:0] offset_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            past_7 <= past_6;
            v_7 <= v_6;
            q_7 <= q_6;
            num_7 <= num_6;
            from_4_7 <= from_4_6;
            from_2_7 <= from_2_6;
            from_1_bits_7 <= from_1_bits_6;
            offset_7 <= offset_6;
        end
    end

    // ===== Stage 7: vq
    // UQ1.26: u (A - a u) = v q
    wire [26:0] vq_7 = v_7 * q_7;
    // UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    wire p_above_bits_7 = vq_7[26];
    // UQ-1.15: p, rounded down
    wire [13:0] p_7 = vq_7[24:11];
    // UQ0.16: about 1/m at the entry's least m
    wire [15:0] seed_7 = reciprocal_7[21:6];
    // UQ0.6: how fast 1/m falls
    wire [5:0] slope_7 = reciprocal_7[5:0];
    reg [12:0] x_8;
    reg past_8;
    reg p_above_bits_8;
    reg [13:0] p_8;
    reg [11:0] num_8;
    reg from_4_8;
    reg from_2_8;
    reg from_1_bits_8;
    reg [15:0] seed_8;
    reg [5:0] slope_8;
    reg [7:0] offset_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            past_8 <= past_7;
            p_above_bits_8 <= p_above_bits_7;
            p_8 <= p_7;
            num_8 <= num_7;
            from_4_8 <= from_4_7;
            from_2_8 <= from_2_7;
            from_1_bits_8 <= from_1_bits_7;
            seed_8 <= seed_7;
            slope_8 <= slope_7;
            offset_8 <= offset_7;
        end
    end

    // ===== Stage 8: xp, fall_exact
    // UQ0.27: x p
    wire [26:0] xp_8 = x_8 * p_8;
    // UQ-1.13: t = x p, rounded down
    wire [11:0] t_8 = xp_8[25:14];
    // UQ-6.20: slope d
    wire [13:0] fall_exact_8 = slope_8 * offset_8;
    // UQ-6.16: slope d, rounded down
    wire [9:0] fall_8 = fall_exact_8[13:4];
    reg [12:0] x_9;
    reg past_9;
    reg p_above_bits_9;
    reg [11:0] t_9;
    reg [11:0] num_9;
    reg from_4_9;
    reg from_2_9;
    reg from_1_bits_9;
    reg [15:0] seed_9;
    reg [9:0] fall_9;
    always @(posedge clk) begin
        if (ce) begin
            x_9 <= x_8;
            past_9 <= past_8;
            p_above_bits_9 <= p_above_bits_8;
            t_9 <= t_8;
            num_9 <= num_8;
            from_4_9 <= from_4_8;
            from_2_9 <= from_2_8;
            from_1_bits_9 <= from_1_bits_8;
            seed_9 <= seed_8;
            fall_9 <= fall_8;
        end
    end

    // ===== Stage 9: y_exact, y, inverse
    // UQ1.13: x - t = x (1 - p)
    wire [13:0] y_exact_9 = {x_9, 1'd0} - {2'd0, t_9};
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_cut_9 = y_exact_9[13:1];
    // UQ1.12: y, 0 where the lobe has ended
    wire [12:0] y_9 = p_above_bits_9 ? 13'd0 : y_cut_9;
    // UQ0.16: 1/m = seed - slope d
    wire [15:0] inverse_9 = seed_9 - {6'd0, fall_9};
    reg past_10;
    reg [12:0] y_10;
    reg [11:0] num_10;
    reg from_4_10;
    reg from_2_10;
    reg from_1_bits_10;
    reg [15:0] inverse_10;
    always @(posedge clk) begin
        if (ce) begin
            past_10 <= past_9;
            y_10 <= y_9;
            num_10 <= num_9;
            from_4_10 <= from_4_9;
            from_2_10 <= from_2_9;
            from_1_bits_10 <= from_1_bits_9;
            inverse_10 <= inverse_9;
        end
    end

    // ===== Stage 10: product
    // UQ0.28: num / m
    wire [27:0] product_10 = num_10 * inverse_10;
    // UQ0.13: num / m, rounded down
    wire [12:0] scaled_10 = product_10[27:15];
    // UQ-4.17: as often halved
    wire [12:0] scaled_4_moved_10 = scaled_10;
    // UQ-4.13: rounded down
    wire [8:0] scaled_4_low_10 = scaled_4_moved_10[12:4];
    reg past_11;
    reg [12:0] y_11;
    reg from_4_11;
    reg from_2_11;
    reg from_1_bits_11;
    reg [12:0] scaled_11;
    reg [8:0] scaled_4_low_11;
    always @(posedge clk) begin
        if (ce) begin
            past_11 <= past_10;
            y_11 <= y_10;
            from_4_11 <= from_4_10;
            from_2_11 <= from_2_10;
            from_1_bits_11 <= from_1_bits_10;
            scaled_11 <= scaled_10;
            scaled_4_low_11 <= scaled_4_low_10;
        end
    end

    // ===== Stage 11: scaled_4, scaled_2, scaled_1
    // UQ0.13: halved as often as the denominator was
    wire [12:0] scaled_4_11 = from_4_11 ? {4'd0, scaled_4_low_11} : scaled_11;
    // UQ-2.15: as often halved
    wire [12:0] scaled_2_moved_11 = scaled_4_11;
    // UQ-2.13: rounded down
    wire [10:0] scaled_2_low_11 = scaled_2_moved_11[12:2];
    // UQ0.13: halved as often as the denominator was
    wire [12:0] scaled_2_11 = from_2_11 ? {2'd0, scaled_2_low_11} : scaled_4_11;
    // UQ-1.14: as often halved
    wire [12:0] scaled_1_moved_11 = scaled_2_11;
    // UQ-1.13: rounded down
    wire [11:0] scaled_1_low_11 = scaled_1_moved_11[12:1];
    // UQ0.13: halved as often as the denominator was
    wire [12:0] scaled_1_11 = from_1_bits_11 ? {1'd0, scaled_1_low_11} : scaled_2_11;
    reg past_12;
    reg [12:0] y_12;
    reg [12:0] scaled_1_12;
    always @(posedge clk) begin
        if (ce) begin
            past_12 <= past_11;
            y_12 <= y_11;
            scaled_1_12 <= scaled_1_11;
        end
    end

    // ===== Stage 12: quotient_half, either
    // UQ0.13: plus half an output ulp
    wire [12:0] quotient_half_12 = scaled_1_12 + 13'h0001;
    // UQ0.12: num / den, rounded to nearest
    wire [11:0] quotient_12 = quotient_half_12[12:1];
    // UQ1.12: the tail past the cut, the cubic up to it
    wire [12:0] either_12 = past_12 ? {1'd0, quotient_12} : y_12;
    reg [12:0] either_13;
    always @(posedge clk) begin
        if (ce) begin
            either_13 <= either_12;
        end
    end

    assign out_valid = valid[13];
    assign out_spec  = either_13;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    u_scaled_3[0],
                    av_5[21:20],
                    av_5[6:0],
                    vq_7[25],
                    vq_7[10:0],
                    xp_8[26],
                    xp_8[13:0],
                    y_exact_9[0],
                    bu_4[19],
                    m_4_high_4[3:0],
                    m_2_high_4[1:0],
                    m_1_high_5[0],
                    m_1_5[14],
                    fall_exact_8[3:0],
                    product_10[14:0],
                    scaled_4_moved_10[3:0],
                    scaled_2_moved_11[1:0],
                    scaled_1_moved_11[0],
                    quotient_half_12[0]};

endmodule

`default_nettype wire
