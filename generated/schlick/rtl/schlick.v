// schlick: specular lobe x^n as x/(1 + (n-1)u), n = 1 to 127
//
// Made by: brdfgen generate core.toml
// Spec 500a8fd02d5cfbe6. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 16 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.500..+0.500.
//   measured -0.500..+0.500 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   20.166 % absolute, 8.982 % where x^n >= 1/2, 17.955 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module schlick (
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

    // ===== Stage 0: n, n1, x, u
    // UQ7.0: in_n taken into the range
    wire [6:0] n_0 = (in_n < 7'h01) ? 7'h01 : in_n;
    // UQ7.0: n - 1
    wire [6:0] n1_0 = n_0 - 7'h01;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ2.11: 2 r
    wire [12:0] double_1_0 = x_0;
    // UQ1.12: 2 r
    wire [12:0] kept_1_0 = {double_1_0[11:0], 1'd0};
    reg [6:0] n1_1;
    reg [12:0] u_1;
    reg [12:0] double_1_1;
    reg [12:0] kept_1_1;
    always @(posedge clk) begin
        if (ce) begin
            n1_1 <= n1_0;
            u_1 <= u_0;
            double_1_1 <= double_1_0;
            kept_1_1 <= kept_1_0;
        end
    end

    // ===== Stage 1: n1u
    // UQ8.12: (n-1) u
    wire [19:0] n1u_1 = n1_1 * u_1;
    reg [19:0] n1u_2;
    reg [12:0] double_1_2;
    reg [12:0] kept_1_2;
    always @(posedge clk) begin
        if (ce) begin
            n1u_2 <= n1u_1;
            double_1_2 <= double_1_1;
            kept_1_2 <= kept_1_1;
        end
    end

    // ===== Stage 2: den, trial_1
    // UQ7.12: the denominator, 1 + (n-1) u
    wire [18:0] den_2 = 19'h01000 + n1u_2[18:0];
    // Q7.12: 2 r - den
    wire [19:0] trial_1_2 = {6'd0, double_1_2, 1'd0} - {1'd0, den_2};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_1_2 = trial_1_2[19];
    // UQ0.1: as a number
    wire weighted_1_2 = zero_1_2;
    // UQ8.-7: 2 r < den
    wire below_1_2 = trial_1_2[19];
    // UQ1.12: 2 r - den
    wire [12:0] less_1_2 = trial_1_2[12:0];
    reg [18:0] den_3;
    reg weighted_1_3;
    reg below_1_3;
    reg [12:0] kept_1_3;
    reg [12:0] less_1_3;
    always @(posedge clk) begin
        if (ce) begin
            den_3 <= den_2;
            weighted_1_3 <= weighted_1_2;
            below_1_3 <= below_1_2;
            kept_1_3 <= kept_1_2;
            less_1_3 <= less_1_2;
        end
    end

    // ===== Stage 3: r_1, trial_2, r_2
    // UQ2.12: the remainder
    wire [13:0] r_1_3 = below_1_3 ? {1'd0, kept_1_3} : {1'd0, less_1_3};
    // UQ3.11: 2 r
    wire [13:0] double_2_3 = r_1_3;
    // Q7.12: 2 r - den
    wire [19:0] trial_2_3 = {5'd0, double_2_3, 1'd0} - {1'd0, den_3};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_2_3 = trial_2_3[19];
    // UQ-1.2: as a number
    wire weighted_2_3 = zero_2_3;
    // UQ8.-7: 2 r < den
    wire below_2_3 = trial_2_3[19];
    // UQ2.12: 2 r
    wire [13:0] kept_2_3 = {double_2_3[12:0], 1'd0};
    // UQ1.12: 2 r - den
    wire [12:0] less_2_3 = trial_2_3[12:0];
    // UQ3.12: the remainder
    wire [14:0] r_2_3 = below_2_3 ? {1'd0, kept_2_3} : {2'd0, less_2_3};
    // UQ4.11: 2 r
    wire [14:0] double_3_3 = r_2_3;
    // UQ3.12: 2 r
    wire [14:0] kept_3_3 = {double_3_3[13:0], 1'd0};
    reg [18:0] den_4;
    reg weighted_1_4;
    reg weighted_2_4;
    reg [14:0] double_3_4;
    reg [14:0] kept_3_4;
    always @(posedge clk) begin
        if (ce) begin
            den_4 <= den_3;
            weighted_1_4 <= weighted_1_3;
            weighted_2_4 <= weighted_2_3;
            double_3_4 <= double_3_3;
            kept_3_4 <= kept_3_3;
        end
    end

    // ===== Stage 4: zeros_2, trial_3, zeros_3, r_3
    // UQ0.2: the zeros of the quotient so far
    wire [1:0] zeros_2_4 = {weighted_1_4, 1'd0} + {1'd0, weighted_2_4};
    // Q7.12: 2 r - den
    wire [19:0] trial_3_4 = {4'd0, double_3_4, 1'd0} - {1'd0, den_4};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_3_4 = trial_3_4[19];
    // UQ-2.3: as a number
    wire weighted_3_4 = zero_3_4;
    // UQ0.3: the zeros of the quotient so far
    wire [2:0] zeros_3_4 = {zeros_2_4, 1'd0} + {2'd0, weighted_3_4};
    // UQ8.-7: 2 r < den
    wire below_3_4 = trial_3_4[19];
    // UQ2.12: 2 r - den
    wire [13:0] less_3_4 = trial_3_4[13:0];
    // UQ4.12: the remainder
    wire [15:0] r_3_4 = below_3_4 ? {1'd0, kept_3_4} : {2'd0, less_3_4};
    // UQ5.11: 2 r
    wire [15:0] double_4_4 = r_3_4;
    // UQ4.12: 2 r
    wire [15:0] kept_4_4 = {double_4_4[14:0], 1'd0};
    reg [18:0] den_5;
    reg [2:0] zeros_3_5;
    reg [15:0] double_4_5;
    reg [15:0] kept_4_5;
    always @(posedge clk) begin
        if (ce) begin
            den_5 <= den_4;
            zeros_3_5 <= zeros_3_4;
            double_4_5 <= double_4_4;
            kept_4_5 <= kept_4_4;
        end
    end

    // ===== Stage 5: trial_4, zeros_4, r_4
    // Q7.12: 2 r - den
    wire [19:0] trial_4_5 = {3'd0, double_4_5, 1'd0} - {1'd0, den_5};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_4_5 = trial_4_5[19];
    // UQ-3.4: as a number
    wire weighted_4_5 = zero_4_5;
    // UQ0.4: the zeros of the quotient so far
    wire [3:0] zeros_4_5 = {zeros_3_5, 1'd0} + {3'd0, weighted_4_5};
    // UQ8.-7: 2 r < den
    wire below_4_5 = trial_4_5[19];
    // UQ3.12: 2 r - den
    wire [14:0] less_4_5 = trial_4_5[14:0];
    // UQ5.12: the remainder
    wire [16:0] r_4_5 = below_4_5 ? {1'd0, kept_4_5} : {2'd0, less_4_5};
    // UQ6.11: 2 r
    wire [16:0] double_5_5 = r_4_5;
    // UQ5.12: 2 r
    wire [16:0] kept_5_5 = {double_5_5[15:0], 1'd0};
    reg [18:0] den_6;
    reg [3:0] zeros_4_6;
    reg [16:0] double_5_6;
    reg [16:0] kept_5_6;
    always @(posedge clk) begin
        if (ce) begin
            den_6 <= den_5;
            zeros_4_6 <= zeros_4_5;
            double_5_6 <= double_5_5;
            kept_5_6 <= kept_5_5;
        end
    end

    // ===== Stage 6: trial_5, zeros_5, r_5
    // Q7.12: 2 r - den
    wire [19:0] trial_5_6 = {2'd0, double_5_6, 1'd0} - {1'd0, den_6};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_5_6 = trial_5_6[19];
    // UQ-4.5: as a number
    wire weighted_5_6 = zero_5_6;
    // UQ0.5: the zeros of the quotient so far
    wire [4:0] zeros_5_6 = {zeros_4_6, 1'd0} + {4'd0, weighted_5_6};
    // UQ8.-7: 2 r < den
    wire below_5_6 = trial_5_6[19];
    // UQ4.12: 2 r - den
    wire [15:0] less_5_6 = trial_5_6[15:0];
    // UQ6.12: the remainder
    wire [17:0] r_5_6 = below_5_6 ? {1'd0, kept_5_6} : {2'd0, less_5_6};
    // UQ7.11: 2 r
    wire [17:0] double_6_6 = r_5_6;
    // UQ6.12: 2 r
    wire [17:0] kept_6_6 = {double_6_6[16:0], 1'd0};
    reg [18:0] den_7;
    reg [4:0] zeros_5_7;
    reg [17:0] double_6_7;
    reg [17:0] kept_6_7;
    always @(posedge clk) begin
        if (ce) begin
            den_7 <= den_6;
            zeros_5_7 <= zeros_5_6;
            double_6_7 <= double_6_6;
            kept_6_7 <= kept_6_6;
        end
    end

    // ===== Stage 7: trial_6, zeros_6, r_6
    // Q7.12: 2 r - den
    wire [19:0] trial_6_7 = {1'd0, double_6_7, 1'd0} - {1'd0, den_7};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_6_7 = trial_6_7[19];
    // UQ-5.6: as a number
    wire weighted_6_7 = zero_6_7;
    // UQ0.6: the zeros of the quotient so far
    wire [5:0] zeros_6_7 = {zeros_5_7, 1'd0} + {5'd0, weighted_6_7};
    // UQ8.-7: 2 r < den
    wire below_6_7 = trial_6_7[19];
    // UQ5.12: 2 r - den
    wire [16:0] less_6_7 = trial_6_7[16:0];
    // UQ7.12: the remainder
    wire [18:0] r_6_7 = below_6_7 ? {1'd0, kept_6_7} : {2'd0, less_6_7};
    // UQ8.11: 2 r
    wire [18:0] double_7_7 = r_6_7;
    // UQ6.12: 2 r
    wire [17:0] kept_7_7 = {double_7_7[16:0], 1'd0};
    reg [18:0] den_8;
    reg [5:0] zeros_6_8;
    reg [18:0] double_7_8;
    reg [17:0] kept_7_8;
    always @(posedge clk) begin
        if (ce) begin
            den_8 <= den_7;
            zeros_6_8 <= zeros_6_7;
            double_7_8 <= double_7_7;
            kept_7_8 <= kept_7_7;
        end
    end

    // ===== Stage 8: trial_7, zeros_7, r_7
    // Q7.12: 2 r - den
    wire [19:0] trial_7_8 = {double_7_8, 1'd0} - {1'd0, den_8};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_7_8 = trial_7_8[19];
    // UQ-6.7: as a number
    wire weighted_7_8 = zero_7_8;
    // UQ0.7: the zeros of the quotient so far
    wire [6:0] zeros_7_8 = {zeros_6_8, 1'd0} + {6'd0, weighted_7_8};
    // UQ8.-7: 2 r < den
    wire below_7_8 = trial_7_8[19];
    // UQ6.12: 2 r - den
    wire [17:0] less_7_8 = trial_7_8[17:0];
    // UQ7.12: the remainder
    wire [18:0] r_7_8 = below_7_8 ? {1'd0, kept_7_8} : {1'd0, less_7_8};
    // UQ8.11: 2 r
    wire [18:0] double_8_8 = r_7_8;
    // UQ7.12: 2 r
    wire [18:0] kept_8_8 = {double_8_8[17:0], 1'd0};
    reg [18:0] den_9;
    reg [6:0] zeros_7_9;
    reg [18:0] double_8_9;
    reg [18:0] kept_8_9;
    always @(posedge clk) begin
        if (ce) begin
            den_9 <= den_8;
            zeros_7_9 <= zeros_7_8;
            double_8_9 <= double_8_8;
            kept_8_9 <= kept_8_8;
        end
    end

    // ===== Stage 9: trial_8, zeros_8, r_8
    // Q7.12: 2 r - den
    wire [19:0] trial_8_9 = {double_8_9, 1'd0} - {1'd0, den_9};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_8_9 = trial_8_9[19];
    // UQ-7.8: as a number
    wire weighted_8_9 = zero_8_9;
    // UQ0.8: the zeros of the quotient so far
    wire [7:0] zeros_8_9 = {zeros_7_9, 1'd0} + {7'd0, weighted_8_9};
    // UQ8.-7: 2 r < den
    wire below_8_9 = trial_8_9[19];
    // UQ6.12: 2 r - den
    wire [17:0] less_8_9 = trial_8_9[17:0];
    // UQ7.12: the remainder
    wire [18:0] r_8_9 = below_8_9 ? kept_8_9 : {1'd0, less_8_9};
    // UQ8.11: 2 r
    wire [18:0] double_9_9 = r_8_9;
    // UQ7.12: 2 r
    wire [18:0] kept_9_9 = {double_9_9[17:0], 1'd0};
    reg [18:0] den_10;
    reg [7:0] zeros_8_10;
    reg [18:0] double_9_10;
    reg [18:0] kept_9_10;
    always @(posedge clk) begin
        if (ce) begin
            den_10 <= den_9;
            zeros_8_10 <= zeros_8_9;
            double_9_10 <= double_9_9;
            kept_9_10 <= kept_9_9;
        end
    end

    // ===== Stage 10: trial_9, zeros_9, r_9
    // Q7.12: 2 r - den
    wire [19:0] trial_9_10 = {double_9_10, 1'd0} - {1'd0, den_10};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_9_10 = trial_9_10[19];
    // UQ-8.9: as a number
    wire weighted_9_10 = zero_9_10;
    // UQ0.9: the zeros of the quotient so far
    wire [8:0] zeros_9_10 = {zeros_8_10, 1'd0} + {8'd0, weighted_9_10};
    // UQ8.-7: 2 r < den
    wire below_9_10 = trial_9_10[19];
    // UQ7.12: 2 r - den
    wire [18:0] less_9_10 = trial_9_10[18:0];
    // UQ7.12: the remainder
    wire [18:0] r_9_10 = below_9_10 ? kept_9_10 : less_9_10;
    // UQ8.11: 2 r
    wire [18:0] double_10_10 = r_9_10;
    // UQ7.12: 2 r
    wire [18:0] kept_10_10 = {double_10_10[17:0], 1'd0};
    reg [18:0] den_11;
    reg [8:0] zeros_9_11;
    reg [18:0] double_10_11;
    reg [18:0] kept_10_11;
    always @(posedge clk) begin
        if (ce) begin
            den_11 <= den_10;
            zeros_9_11 <= zeros_9_10;
            double_10_11 <= double_10_10;
            kept_10_11 <= kept_10_10;
        end
    end

    // ===== Stage 11: trial_10, zeros_10, r_10
    // Q7.12: 2 r - den
    wire [19:0] trial_10_11 = {double_10_11, 1'd0} - {1'd0, den_11};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_10_11 = trial_10_11[19];
    // UQ-9.10: as a number
    wire weighted_10_11 = zero_10_11;
    // UQ0.10: the zeros of the quotient so far
    wire [9:0] zeros_10_11 = {zeros_9_11, 1'd0} + {9'd0, weighted_10_11};
    // UQ8.-7: 2 r < den
    wire below_10_11 = trial_10_11[19];
    // UQ7.12: 2 r - den
    wire [18:0] less_10_11 = trial_10_11[18:0];
    // UQ7.12: the remainder
    wire [18:0] r_10_11 = below_10_11 ? kept_10_11 : less_10_11;
    // UQ8.11: 2 r
    wire [18:0] double_11_11 = r_10_11;
    // UQ7.12: 2 r
    wire [18:0] kept_11_11 = {double_11_11[17:0], 1'd0};
    reg [18:0] den_12;
    reg [9:0] zeros_10_12;
    reg [18:0] double_11_12;
    reg [18:0] kept_11_12;
    always @(posedge clk) begin
        if (ce) begin
            den_12 <= den_11;
            zeros_10_12 <= zeros_10_11;
            double_11_12 <= double_11_11;
            kept_11_12 <= kept_11_11;
        end
    end

    // ===== Stage 12: trial_11, zeros_11, r_11
    // Q7.12: 2 r - den
    wire [19:0] trial_11_12 = {double_11_12, 1'd0} - {1'd0, den_12};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_11_12 = trial_11_12[19];
    // UQ-10.11: as a number
    wire weighted_11_12 = zero_11_12;
    // UQ0.11: the zeros of the quotient so far
    wire [10:0] zeros_11_12 = {zeros_10_12, 1'd0} + {10'd0, weighted_11_12};
    // UQ8.-7: 2 r < den
    wire below_11_12 = trial_11_12[19];
    // UQ7.12: 2 r - den
    wire [18:0] less_11_12 = trial_11_12[18:0];
    // UQ7.12: the remainder
    wire [18:0] r_11_12 = below_11_12 ? kept_11_12 : less_11_12;
    // UQ8.11: 2 r
    wire [18:0] double_12_12 = r_11_12;
    // UQ7.12: 2 r
    wire [18:0] kept_12_12 = {double_12_12[17:0], 1'd0};
    reg [18:0] den_13;
    reg [10:0] zeros_11_13;
    reg [18:0] double_12_13;
    reg [18:0] kept_12_13;
    always @(posedge clk) begin
        if (ce) begin
            den_13 <= den_12;
            zeros_11_13 <= zeros_11_12;
            double_12_13 <= double_12_12;
            kept_12_13 <= kept_12_12;
        end
    end

    // ===== Stage 13: trial_12, zeros_12, r_12
    // Q7.12: 2 r - den
    wire [19:0] trial_12_13 = {double_12_13, 1'd0} - {1'd0, den_13};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_12_13 = trial_12_13[19];
    // UQ-11.12: as a number
    wire weighted_12_13 = zero_12_13;
    // UQ0.12: the zeros of the quotient so far
    wire [11:0] zeros_12_13 = {zeros_11_13, 1'd0} + {11'd0, weighted_12_13};
    // UQ8.-7: 2 r < den
    wire below_12_13 = trial_12_13[19];
    // UQ7.12: 2 r - den
    wire [18:0] less_12_13 = trial_12_13[18:0];
    // UQ7.12: the remainder
    wire [18:0] r_12_13 = below_12_13 ? kept_12_13 : less_12_13;
    // UQ8.11: 2 r
    wire [18:0] double_13_13 = r_12_13;
    reg [18:0] den_14;
    reg [11:0] zeros_12_14;
    reg [18:0] double_13_14;
    always @(posedge clk) begin
        if (ce) begin
            den_14 <= den_13;
            zeros_12_14 <= zeros_12_13;
            double_13_14 <= double_13_13;
        end
    end

    // ===== Stage 14: trial_13, zeros_13
    // Q7.12: 2 r - den
    wire [19:0] trial_13_14 = {double_13_14, 1'd0} - {1'd0, den_14};
    // UQ8.-7: the digit, inverted: the sign
    wire zero_13_14 = trial_13_14[19];
    // UQ-12.13: as a number
    wire weighted_13_14 = zero_13_14;
    // UQ0.13: the zeros of the quotient so far
    wire [12:0] zeros_13_14 = {zeros_12_14, 1'd0} + {12'd0, weighted_13_14};
    reg [12:0] zeros_13_15;
    always @(posedge clk) begin
        if (ce) begin
            zeros_13_15 <= zeros_13_14;
        end
    end

    // ===== Stage 15: quotient_half
    // UQ1.13: the quotient plus half an output ulp
    wire [13:0] quotient_half_15 = 14'h2000 - {1'd0, zeros_13_15};
    // UQ1.12: num / den, rounded to nearest
    wire [12:0] quotient_15 = quotient_half_15[13:1];
    reg [12:0] quotient_16;
    always @(posedge clk) begin
        if (ce) begin
            quotient_16 <= quotient_15;
        end
    end

    assign out_valid = valid[16];
    assign out_spec  = quotient_16;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    n1u_2[19],
                    trial_1_2[18:13],
                    trial_2_3[18:13],
                    trial_3_4[18:14],
                    trial_4_5[18:15],
                    trial_5_6[18:16],
                    trial_6_7[18:17],
                    trial_7_8[18],
                    trial_8_9[18],
                    trial_13_14[18:0],
                    quotient_half_15[0]};

endmodule

`default_nettype wire
