// squaring: specular lobe x^n as x^n by log2 n squarings, 8 shininesses
//
// Made by: brdfgen generate core.toml
// Spec 8bd38130fdf7535e. Generated; the core is yours to use under any terms.
//
//   in_n      UQ3.0   index of the shininess, 0 to 7; above: the last
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 20 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.859..+0.500.
//   measured -0.613..+0.500 over all 32776 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.01496 % absolute, 0.01496 % where x^n >= 1/2, 0.02412 % relative there.
// As the cosine rises, the output never falls: proved by running all 32768 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module squaring (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ3.0: index of the shininess, 0 to 7; above: the last
    input  wire [2:0] in_n,
    // Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [13:0] in_cos,
    // out_spec is a result: in_valid, 20 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [20:1] valid;
    initial valid = 20'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 20'd0;
        end else if (ce) begin
            valid <= {valid[19:1], in_valid};
        end
    end

    // ===== Stage 0: read the ROM, x
    // The word of the memory rom, of 8 words.
    reg [2:0] rom_1;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.16: in the wider of two formats
    wire [16:0] x_wide_0 = {x_0, 4'd0};
    always @(posedge clk) begin
        if (ce) begin
            case (in_n)
                3'd0: rom_1 <= 3'h0;
                3'd1: rom_1 <= 3'h1;
                3'd2: rom_1 <= 3'h2;
                3'd3: rom_1 <= 3'h3;
                3'd4: rom_1 <= 3'h4;
                3'd5: rom_1 <= 3'h5;
                3'd6: rom_1 <= 3'h6;
                3'd7: rom_1 <= 3'h7;
                default: rom_1 <= 3'h0;
            endcase
        end
    end
    reg [12:0] x_1;
    reg [16:0] x_wide_1;
    always @(posedge clk) begin
        if (ce) begin
            x_1 <= x_0;
            x_wide_1 <= x_wide_0;
        end
    end

    // ===== Stage 1: x2_exact
    // UQ2.24: x^2
    wire [25:0] x2_exact_1 = x_1 * x_1;
    // UQ1.22: x^2, rounded down
    wire [22:0] x2_1 = x2_exact_1[24:2];
    // UQ1.16: x^2 with fewer bits
    wire [16:0] x2_cut_1 = x2_1[22:6];
    // UQ-4.22: the 18 low bits of x2
    wire [17:0] x2_low_1 = x2_1[17:0];
    // UQ1.4: x2 without its 18 low bits
    wire [4:0] x2_high_1 = x2_1[22:18];
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_0_1 = rom_1[0];
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_1_1 = rom_1[1];
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_2_1 = rom_1[2];
    reg [16:0] x2_cut_2;
    reg [17:0] x2_low_2;
    reg [4:0] x2_high_2;
    reg tap_0_2;
    reg [16:0] x_wide_2;
    reg tap_1_2;
    reg tap_2_2;
    always @(posedge clk) begin
        if (ce) begin
            x2_cut_2 <= x2_cut_1;
            x2_low_2 <= x2_low_1;
            x2_high_2 <= x2_high_1;
            tap_0_2 <= tap_0_1;
            x_wide_2 <= x_wide_1;
            tap_1_2 <= tap_1_1;
            tap_2_2 <= tap_2_1;
        end
    end

    // ===== Stage 2: x4_exact_low, x4_exact_mixed, x4_exact_high, power_0_0
    // UQ-8.44: part of x4_exact
    wire [35:0] x4_exact_low_2 = x2_low_2 * x2_low_2;
    // UQ-3.26: part of x4_exact
    wire [22:0] x4_exact_mixed_2 = x2_low_2 * x2_high_2;
    // UQ2.8: part of x4_exact
    wire [9:0] x4_exact_high_2 = x2_high_2 * x2_high_2;
    // UQ-2.25: both mixed products
    wire [22:0] x4_exact_twice_2 = x4_exact_mixed_2;
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_0_2 = tap_0_2 ? x2_cut_2 : x_wide_2;
    reg [35:0] x4_exact_low_3;
    reg [9:0] x4_exact_high_3;
    reg [22:0] x4_exact_twice_3;
    reg tap_0_3;
    reg [16:0] power_0_0_3;
    reg tap_1_3;
    reg tap_2_3;
    always @(posedge clk) begin
        if (ce) begin
            x4_exact_low_3 <= x4_exact_low_2;
            x4_exact_high_3 <= x4_exact_high_2;
            x4_exact_twice_3 <= x4_exact_twice_2;
            tap_0_3 <= tap_0_2;
            power_0_0_3 <= power_0_0_2;
            tap_1_3 <= tap_1_2;
            tap_2_3 <= tap_2_2;
        end
    end

    // ===== Stage 3: x4_exact_ends, x4_exact
    // UQ2.44: the squares of both parts
    wire [45:0] x4_exact_ends_3 = {10'd0, x4_exact_low_3} + {x4_exact_high_3, 36'd0};
    // UQ2.44: x^4
    wire [45:0] x4_exact_3 = x4_exact_ends_3 + {4'd0, x4_exact_twice_3, 19'd0};
    // UQ1.21: x^4, rounded down
    wire [21:0] x4_3 = x4_exact_3[44:23];
    // UQ1.16: x^4 with fewer bits
    wire [16:0] x4_cut_3 = x4_3[21:5];
    // UQ-3.21: the 18 low bits of x4
    wire [17:0] x4_low_3 = x4_3[17:0];
    // UQ1.3: x4 without its 18 low bits
    wire [3:0] x4_high_3 = x4_3[21:18];
    reg [16:0] x4_cut_4;
    reg [17:0] x4_low_4;
    reg [3:0] x4_high_4;
    reg tap_0_4;
    reg [16:0] power_0_0_4;
    reg tap_1_4;
    reg tap_2_4;
    always @(posedge clk) begin
        if (ce) begin
            x4_cut_4 <= x4_cut_3;
            x4_low_4 <= x4_low_3;
            x4_high_4 <= x4_high_3;
            tap_0_4 <= tap_0_3;
            power_0_0_4 <= power_0_0_3;
            tap_1_4 <= tap_1_3;
            tap_2_4 <= tap_2_3;
        end
    end

    // ===== Stage 4: registers only
    reg [16:0] x4_cut_5;
    reg [17:0] x4_low_5;
    reg [3:0] x4_high_5;
    reg tap_0_5;
    reg [16:0] power_0_0_5;
    reg tap_1_5;
    reg tap_2_5;
    always @(posedge clk) begin
        if (ce) begin
            x4_cut_5 <= x4_cut_4;
            x4_low_5 <= x4_low_4;
            x4_high_5 <= x4_high_4;
            tap_0_5 <= tap_0_4;
            power_0_0_5 <= power_0_0_4;
            tap_1_5 <= tap_1_4;
            tap_2_5 <= tap_2_4;
        end
    end

    // ===== Stage 5: x8_exact_low, x8_exact_mixed, x8_exact_high
    // UQ-6.42: part of x8_exact
    wire [35:0] x8_exact_low_5 = x4_low_5 * x4_low_5;
    // UQ-2.24: part of x8_exact
    wire [21:0] x8_exact_mixed_5 = x4_low_5 * x4_high_5;
    // UQ2.6: part of x8_exact
    wire [7:0] x8_exact_high_5 = x4_high_5 * x4_high_5;
    // UQ-1.23: both mixed products
    wire [21:0] x8_exact_twice_5 = x8_exact_mixed_5;
    reg [16:0] x4_cut_6;
    reg [35:0] x8_exact_low_6;
    reg [7:0] x8_exact_high_6;
    reg [21:0] x8_exact_twice_6;
    reg tap_0_6;
    reg [16:0] power_0_0_6;
    reg tap_1_6;
    reg tap_2_6;
    always @(posedge clk) begin
        if (ce) begin
            x4_cut_6 <= x4_cut_5;
            x8_exact_low_6 <= x8_exact_low_5;
            x8_exact_high_6 <= x8_exact_high_5;
            x8_exact_twice_6 <= x8_exact_twice_5;
            tap_0_6 <= tap_0_5;
            power_0_0_6 <= power_0_0_5;
            tap_1_6 <= tap_1_5;
            tap_2_6 <= tap_2_5;
        end
    end

    // ===== Stage 6: x8_exact_ends, x8_exact
    // UQ2.42: the squares of both parts
    wire [43:0] x8_exact_ends_6 = {8'd0, x8_exact_low_6} + {x8_exact_high_6, 36'd0};
    // UQ2.42: x^8
    wire [43:0] x8_exact_6 = x8_exact_ends_6 + {3'd0, x8_exact_twice_6, 19'd0};
    // UQ1.20: x^8, rounded down
    wire [20:0] x8_6 = x8_exact_6[42:22];
    // UQ1.16: x^8 with fewer bits
    wire [16:0] x8_cut_6 = x8_6[20:4];
    // UQ-2.20: the 18 low bits of x8
    wire [17:0] x8_low_6 = x8_6[17:0];
    // UQ1.2: x8 without its 18 low bits
    wire [2:0] x8_high_6 = x8_6[20:18];
    reg [16:0] x4_cut_7;
    reg [16:0] x8_cut_7;
    reg [17:0] x8_low_7;
    reg [2:0] x8_high_7;
    reg tap_0_7;
    reg [16:0] power_0_0_7;
    reg tap_1_7;
    reg tap_2_7;
    always @(posedge clk) begin
        if (ce) begin
            x4_cut_7 <= x4_cut_6;
            x8_cut_7 <= x8_cut_6;
            x8_low_7 <= x8_low_6;
            x8_high_7 <= x8_high_6;
            tap_0_7 <= tap_0_6;
            power_0_0_7 <= power_0_0_6;
            tap_1_7 <= tap_1_6;
            tap_2_7 <= tap_2_6;
        end
    end

    // ===== Stage 7: power_0_1, power_1_0
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_1_7 = tap_0_7 ? x8_cut_7 : x4_cut_7;
    // UQ1.16: one of two powers of x
    wire [16:0] power_1_0_7 = tap_1_7 ? power_0_1_7 : power_0_0_7;
    reg [17:0] x8_low_8;
    reg [2:0] x8_high_8;
    reg tap_0_8;
    reg tap_1_8;
    reg [16:0] power_1_0_8;
    reg tap_2_8;
    always @(posedge clk) begin
        if (ce) begin
            x8_low_8 <= x8_low_7;
            x8_high_8 <= x8_high_7;
            tap_0_8 <= tap_0_7;
            tap_1_8 <= tap_1_7;
            power_1_0_8 <= power_1_0_7;
            tap_2_8 <= tap_2_7;
        end
    end

    // ===== Stage 8: x16_exact_low, x16_exact_mixed, x16_exact_high
    // UQ-4.40: part of x16_exact
    wire [35:0] x16_exact_low_8 = x8_low_8 * x8_low_8;
    // UQ-1.22: part of x16_exact
    wire [20:0] x16_exact_mixed_8 = x8_low_8 * x8_high_8;
    // UQ2.4: part of x16_exact
    wire [5:0] x16_exact_high_8 = x8_high_8 * x8_high_8;
    // UQ0.21: both mixed products
    wire [20:0] x16_exact_twice_8 = x16_exact_mixed_8;
    reg [35:0] x16_exact_low_9;
    reg [5:0] x16_exact_high_9;
    reg [20:0] x16_exact_twice_9;
    reg tap_0_9;
    reg tap_1_9;
    reg [16:0] power_1_0_9;
    reg tap_2_9;
    always @(posedge clk) begin
        if (ce) begin
            x16_exact_low_9 <= x16_exact_low_8;
            x16_exact_high_9 <= x16_exact_high_8;
            x16_exact_twice_9 <= x16_exact_twice_8;
            tap_0_9 <= tap_0_8;
            tap_1_9 <= tap_1_8;
            power_1_0_9 <= power_1_0_8;
            tap_2_9 <= tap_2_8;
        end
    end

    // ===== Stage 9: x16_exact_ends, x16_exact
    // UQ2.40: the squares of both parts
    wire [41:0] x16_exact_ends_9 = {6'd0, x16_exact_low_9} + {x16_exact_high_9, 36'd0};
    // UQ2.40: x^16
    wire [41:0] x16_exact_9 = x16_exact_ends_9 + {2'd0, x16_exact_twice_9, 19'd0};
    // UQ1.19: x^16, rounded down
    wire [19:0] x16_9 = x16_exact_9[40:21];
    // UQ1.16: x^16 with fewer bits
    wire [16:0] x16_cut_9 = x16_9[19:3];
    // UQ-1.19: the 18 low bits of x16
    wire [17:0] x16_low_9 = x16_9[17:0];
    // UQ1.1: x16 without its 18 low bits
    wire [1:0] x16_high_9 = x16_9[19:18];
    reg [16:0] x16_cut_10;
    reg [17:0] x16_low_10;
    reg [1:0] x16_high_10;
    reg tap_0_10;
    reg tap_1_10;
    reg [16:0] power_1_0_10;
    reg tap_2_10;
    always @(posedge clk) begin
        if (ce) begin
            x16_cut_10 <= x16_cut_9;
            x16_low_10 <= x16_low_9;
            x16_high_10 <= x16_high_9;
            tap_0_10 <= tap_0_9;
            tap_1_10 <= tap_1_9;
            power_1_0_10 <= power_1_0_9;
            tap_2_10 <= tap_2_9;
        end
    end

    // ===== Stage 10: registers only
    reg [16:0] x16_cut_11;
    reg [17:0] x16_low_11;
    reg [1:0] x16_high_11;
    reg tap_0_11;
    reg tap_1_11;
    reg [16:0] power_1_0_11;
    reg tap_2_11;
    always @(posedge clk) begin
        if (ce) begin
            x16_cut_11 <= x16_cut_10;
            x16_low_11 <= x16_low_10;
            x16_high_11 <= x16_high_10;
            tap_0_11 <= tap_0_10;
            tap_1_11 <= tap_1_10;
            power_1_0_11 <= power_1_0_10;
            tap_2_11 <= tap_2_10;
        end
    end

    // ===== Stage 11: x32_exact_low, x32_exact_mixed, x32_exact_high
    // UQ-2.38: part of x32_exact
    wire [35:0] x32_exact_low_11 = x16_low_11 * x16_low_11;
    // UQ0.20: part of x32_exact
    wire [19:0] x32_exact_mixed_11 = x16_low_11 * x16_high_11;
    // UQ2.2: part of x32_exact
    wire [3:0] x32_exact_high_11 = x16_high_11 * x16_high_11;
    // UQ1.19: both mixed products
    wire [19:0] x32_exact_twice_11 = x32_exact_mixed_11;
    reg [16:0] x16_cut_12;
    reg [35:0] x32_exact_low_12;
    reg [3:0] x32_exact_high_12;
    reg [19:0] x32_exact_twice_12;
    reg tap_0_12;
    reg tap_1_12;
    reg [16:0] power_1_0_12;
    reg tap_2_12;
    always @(posedge clk) begin
        if (ce) begin
            x16_cut_12 <= x16_cut_11;
            x32_exact_low_12 <= x32_exact_low_11;
            x32_exact_high_12 <= x32_exact_high_11;
            x32_exact_twice_12 <= x32_exact_twice_11;
            tap_0_12 <= tap_0_11;
            tap_1_12 <= tap_1_11;
            power_1_0_12 <= power_1_0_11;
            tap_2_12 <= tap_2_11;
        end
    end

    // ===== Stage 12: x32_exact_ends, x32_exact
    // UQ2.38: the squares of both parts
    wire [39:0] x32_exact_ends_12 = {4'd0, x32_exact_low_12} + {x32_exact_high_12, 36'd0};
    // UQ2.38: x^32
    wire [39:0] x32_exact_12 = x32_exact_ends_12 + {1'd0, x32_exact_twice_12, 19'd0};
    // UQ1.18: x^32, rounded down
    wire [18:0] x32_12 = x32_exact_12[38:20];
    // UQ1.16: x^32 with fewer bits
    wire [16:0] x32_cut_12 = x32_12[18:2];
    // UQ0.18: the 18 low bits of x32
    wire [17:0] x32_low_12 = x32_12[17:0];
    // UQ1.0: x32 without its 18 low bits
    wire x32_high_12 = x32_12[18];
    reg [16:0] x16_cut_13;
    reg [16:0] x32_cut_13;
    reg [17:0] x32_low_13;
    reg x32_high_13;
    reg tap_0_13;
    reg tap_1_13;
    reg [16:0] power_1_0_13;
    reg tap_2_13;
    always @(posedge clk) begin
        if (ce) begin
            x16_cut_13 <= x16_cut_12;
            x32_cut_13 <= x32_cut_12;
            x32_low_13 <= x32_low_12;
            x32_high_13 <= x32_high_12;
            tap_0_13 <= tap_0_12;
            tap_1_13 <= tap_1_12;
            power_1_0_13 <= power_1_0_12;
            tap_2_13 <= tap_2_12;
        end
    end

    // ===== Stage 13: power_0_2
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_2_13 = tap_0_13 ? x32_cut_13 : x16_cut_13;
    reg [17:0] x32_low_14;
    reg x32_high_14;
    reg tap_0_14;
    reg [16:0] power_0_2_14;
    reg tap_1_14;
    reg [16:0] power_1_0_14;
    reg tap_2_14;
    always @(posedge clk) begin
        if (ce) begin
            x32_low_14 <= x32_low_13;
            x32_high_14 <= x32_high_13;
            tap_0_14 <= tap_0_13;
            power_0_2_14 <= power_0_2_13;
            tap_1_14 <= tap_1_13;
            power_1_0_14 <= power_1_0_13;
            tap_2_14 <= tap_2_13;
        end
    end

    // ===== Stage 14: x64_exact_low, x64_exact_mixed, x64_exact_high
    // UQ0.36: part of x64_exact
    wire [35:0] x64_exact_low_14 = x32_low_14 * x32_low_14;
    // UQ1.18: part of x64_exact
    wire [18:0] x64_exact_mixed_14 = x32_low_14 * x32_high_14;
    // UQ2.0: part of x64_exact
    wire [1:0] x64_exact_high_14 = x32_high_14 * x32_high_14;
    // UQ2.17: both mixed products
    wire [18:0] x64_exact_twice_14 = x64_exact_mixed_14;
    reg [35:0] x64_exact_low_15;
    reg [1:0] x64_exact_high_15;
    reg [18:0] x64_exact_twice_15;
    reg tap_0_15;
    reg [16:0] power_0_2_15;
    reg tap_1_15;
    reg [16:0] power_1_0_15;
    reg tap_2_15;
    always @(posedge clk) begin
        if (ce) begin
            x64_exact_low_15 <= x64_exact_low_14;
            x64_exact_high_15 <= x64_exact_high_14;
            x64_exact_twice_15 <= x64_exact_twice_14;
            tap_0_15 <= tap_0_14;
            power_0_2_15 <= power_0_2_14;
            tap_1_15 <= tap_1_14;
            power_1_0_15 <= power_1_0_14;
            tap_2_15 <= tap_2_14;
        end
    end

    // ===== Stage 15: x64_exact_ends, x64_exact
    // UQ2.36: the squares of both parts
    wire [37:0] x64_exact_ends_15 = {2'd0, x64_exact_low_15} + {x64_exact_high_15, 36'd0};
    // UQ2.36: x^64
    wire [37:0] x64_exact_15 = x64_exact_ends_15 + {x64_exact_twice_15, 19'd0};
    // UQ1.17: x^64, rounded down
    wire [17:0] x64_15 = x64_exact_15[36:19];
    // UQ1.16: x^64 with fewer bits
    wire [16:0] x64_cut_15 = x64_15[17:1];
    reg [17:0] x64_16;
    reg [16:0] x64_cut_16;
    reg tap_0_16;
    reg [16:0] power_0_2_16;
    reg tap_1_16;
    reg [16:0] power_1_0_16;
    reg tap_2_16;
    always @(posedge clk) begin
        if (ce) begin
            x64_16 <= x64_15;
            x64_cut_16 <= x64_cut_15;
            tap_0_16 <= tap_0_15;
            power_0_2_16 <= power_0_2_15;
            tap_1_16 <= tap_1_15;
            power_1_0_16 <= power_1_0_15;
            tap_2_16 <= tap_2_15;
        end
    end

    // ===== Stage 16: registers only
    reg [17:0] x64_17;
    reg [16:0] x64_cut_17;
    reg tap_0_17;
    reg [16:0] power_0_2_17;
    reg tap_1_17;
    reg [16:0] power_1_0_17;
    reg tap_2_17;
    always @(posedge clk) begin
        if (ce) begin
            x64_17 <= x64_16;
            x64_cut_17 <= x64_cut_16;
            tap_0_17 <= tap_0_16;
            power_0_2_17 <= power_0_2_16;
            tap_1_17 <= tap_1_16;
            power_1_0_17 <= power_1_0_16;
            tap_2_17 <= tap_2_16;
        end
    end

    // ===== Stage 17: x128_exact
    // UQ2.34: x^128
    wire [35:0] x128_exact_17 = x64_17 * x64_17;
    // UQ1.16: x^128, rounded down
    wire [16:0] x128_17 = x128_exact_17[34:18];
    reg [16:0] x64_cut_18;
    reg [16:0] x128_18;
    reg tap_0_18;
    reg [16:0] power_0_2_18;
    reg tap_1_18;
    reg [16:0] power_1_0_18;
    reg tap_2_18;
    always @(posedge clk) begin
        if (ce) begin
            x64_cut_18 <= x64_cut_17;
            x128_18 <= x128_17;
            tap_0_18 <= tap_0_17;
            power_0_2_18 <= power_0_2_17;
            tap_1_18 <= tap_1_17;
            power_1_0_18 <= power_1_0_17;
            tap_2_18 <= tap_2_17;
        end
    end

    // ===== Stage 18: power_0_3, power_1_1, power_2_0
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_3_18 = tap_0_18 ? x128_18 : x64_cut_18;
    // UQ1.16: one of two powers of x
    wire [16:0] power_1_1_18 = tap_1_18 ? power_0_3_18 : power_0_2_18;
    // UQ1.16: one of two powers of x
    wire [16:0] power_2_0_18 = tap_2_18 ? power_1_1_18 : power_1_0_18;
    reg [16:0] power_2_0_19;
    always @(posedge clk) begin
        if (ce) begin
            power_2_0_19 <= power_2_0_18;
        end
    end

    // ===== Stage 19: y_half
    // UQ1.16: plus half an output ulp: the result is rounded to nearest
    wire [16:0] y_half_19 = power_2_0_19 + 17'h00008;
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_19 = y_half_19[16:4];
    reg [12:0] y_20;
    always @(posedge clk) begin
        if (ce) begin
            y_20 <= y_19;
        end
    end

    assign out_valid = valid[20];
    assign out_spec  = y_20;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    x2_exact_1[25],
                    x2_exact_1[1:0],
                    x4_exact_3[45],
                    x4_exact_3[22:0],
                    x8_exact_6[43],
                    x8_exact_6[21:0],
                    x16_exact_9[41],
                    x16_exact_9[20:0],
                    x32_exact_12[39],
                    x32_exact_12[19:0],
                    x64_exact_15[37],
                    x64_exact_15[18:0],
                    x128_exact_17[35],
                    x128_exact_17[17:0],
                    y_half_19[3:0]};

endmodule

`default_nettype wire
