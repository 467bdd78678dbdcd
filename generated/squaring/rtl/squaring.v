// squaring: specular lobe x^n as x^n by log2 n squarings, 8 shininesses
//
// Made by: brdfgen generate core.toml
// Spec 8bd38130fdf7535e. Generated; the core is yours to use under any terms.
//
//   in_n      UQ3.0   index of the shininess, 0 to 7; above: the last
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 9 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.859..+0.500.
//   measured -0.613..+0.500 over all 32776 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.01496 % absolute, 0.01496 % where x^n >= 1/2, 0.02412 % relative there.
// As the cosine rises, the output never falls: proved by running all 32768 pairs of neighbouring inputs.

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
    // out_spec is a result: in_valid, 9 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [9:1] valid;
    initial valid = 9'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 9'd0;
        end else if (ce) begin
            valid <= {valid[8:1], in_valid};
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
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_0_1 = rom_1[0];
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_1_1 = rom_1[1];
    // UQ1.0: a bit of the number of the power that is taken
    wire tap_2_1 = rom_1[2];
    reg [22:0] x2_2;
    reg [16:0] x2_cut_2;
    reg tap_0_2;
    reg [16:0] x_wide_2;
    reg tap_1_2;
    reg tap_2_2;
    always @(posedge clk) begin
        if (ce) begin
            x2_2 <= x2_1;
            x2_cut_2 <= x2_cut_1;
            tap_0_2 <= tap_0_1;
            x_wide_2 <= x_wide_1;
            tap_1_2 <= tap_1_1;
            tap_2_2 <= tap_2_1;
        end
    end

    // ===== Stage 2: x4_exact, power_0_0
    // UQ2.44: x^4
    wire [45:0] x4_exact_2 = x2_2 * x2_2;
    // UQ1.21: x^4, rounded down
    wire [21:0] x4_2 = x4_exact_2[44:23];
    // UQ1.16: x^4 with fewer bits
    wire [16:0] x4_cut_2 = x4_2[21:5];
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_0_2 = tap_0_2 ? x2_cut_2 : x_wide_2;
    reg [21:0] x4_3;
    reg [16:0] x4_cut_3;
    reg tap_0_3;
    reg [16:0] power_0_0_3;
    reg tap_1_3;
    reg tap_2_3;
    always @(posedge clk) begin
        if (ce) begin
            x4_3 <= x4_2;
            x4_cut_3 <= x4_cut_2;
            tap_0_3 <= tap_0_2;
            power_0_0_3 <= power_0_0_2;
            tap_1_3 <= tap_1_2;
            tap_2_3 <= tap_2_2;
        end
    end

    // ===== Stage 3: x8_exact
    // UQ2.42: x^8
    wire [43:0] x8_exact_3 = x4_3 * x4_3;
    // UQ1.20: x^8, rounded down
    wire [20:0] x8_3 = x8_exact_3[42:22];
    // UQ1.16: x^8 with fewer bits
    wire [16:0] x8_cut_3 = x8_3[20:4];
    reg [16:0] x4_cut_4;
    reg [20:0] x8_4;
    reg [16:0] x8_cut_4;
    reg tap_0_4;
    reg [16:0] power_0_0_4;
    reg tap_1_4;
    reg tap_2_4;
    always @(posedge clk) begin
        if (ce) begin
            x4_cut_4 <= x4_cut_3;
            x8_4 <= x8_3;
            x8_cut_4 <= x8_cut_3;
            tap_0_4 <= tap_0_3;
            power_0_0_4 <= power_0_0_3;
            tap_1_4 <= tap_1_3;
            tap_2_4 <= tap_2_3;
        end
    end

    // ===== Stage 4: x16_exact, power_0_1, power_1_0
    // UQ2.40: x^16
    wire [41:0] x16_exact_4 = x8_4 * x8_4;
    // UQ1.19: x^16, rounded down
    wire [19:0] x16_4 = x16_exact_4[40:21];
    // UQ1.16: x^16 with fewer bits
    wire [16:0] x16_cut_4 = x16_4[19:3];
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_1_4 = tap_0_4 ? x8_cut_4 : x4_cut_4;
    // UQ1.16: one of two powers of x
    wire [16:0] power_1_0_4 = tap_1_4 ? power_0_1_4 : power_0_0_4;
    reg [19:0] x16_5;
    reg [16:0] x16_cut_5;
    reg tap_0_5;
    reg tap_1_5;
    reg [16:0] power_1_0_5;
    reg tap_2_5;
    always @(posedge clk) begin
        if (ce) begin
            x16_5 <= x16_4;
            x16_cut_5 <= x16_cut_4;
            tap_0_5 <= tap_0_4;
            tap_1_5 <= tap_1_4;
            power_1_0_5 <= power_1_0_4;
            tap_2_5 <= tap_2_4;
        end
    end

    // ===== Stage 5: x32_exact
    // UQ2.38: x^32
    wire [39:0] x32_exact_5 = x16_5 * x16_5;
    // UQ1.18: x^32, rounded down
    wire [18:0] x32_5 = x32_exact_5[38:20];
    // UQ1.16: x^32 with fewer bits
    wire [16:0] x32_cut_5 = x32_5[18:2];
    reg [16:0] x16_cut_6;
    reg [18:0] x32_6;
    reg [16:0] x32_cut_6;
    reg tap_0_6;
    reg tap_1_6;
    reg [16:0] power_1_0_6;
    reg tap_2_6;
    always @(posedge clk) begin
        if (ce) begin
            x16_cut_6 <= x16_cut_5;
            x32_6 <= x32_5;
            x32_cut_6 <= x32_cut_5;
            tap_0_6 <= tap_0_5;
            tap_1_6 <= tap_1_5;
            power_1_0_6 <= power_1_0_5;
            tap_2_6 <= tap_2_5;
        end
    end

    // ===== Stage 6: x64_exact, power_0_2
    // UQ2.36: x^64
    wire [37:0] x64_exact_6 = x32_6 * x32_6;
    // UQ1.17: x^64, rounded down
    wire [17:0] x64_6 = x64_exact_6[36:19];
    // UQ1.16: x^64 with fewer bits
    wire [16:0] x64_cut_6 = x64_6[17:1];
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_2_6 = tap_0_6 ? x32_cut_6 : x16_cut_6;
    reg [17:0] x64_7;
    reg [16:0] x64_cut_7;
    reg tap_0_7;
    reg [16:0] power_0_2_7;
    reg tap_1_7;
    reg [16:0] power_1_0_7;
    reg tap_2_7;
    always @(posedge clk) begin
        if (ce) begin
            x64_7 <= x64_6;
            x64_cut_7 <= x64_cut_6;
            tap_0_7 <= tap_0_6;
            power_0_2_7 <= power_0_2_6;
            tap_1_7 <= tap_1_6;
            power_1_0_7 <= power_1_0_6;
            tap_2_7 <= tap_2_6;
        end
    end

    // ===== Stage 7: x128_exact
    // UQ2.34: x^128
    wire [35:0] x128_exact_7 = x64_7 * x64_7;
    // UQ1.16: x^128, rounded down
    wire [16:0] x128_7 = x128_exact_7[34:18];
    reg [16:0] x64_cut_8;
    reg [16:0] x128_8;
    reg tap_0_8;
    reg [16:0] power_0_2_8;
    reg tap_1_8;
    reg [16:0] power_1_0_8;
    reg tap_2_8;
    always @(posedge clk) begin
        if (ce) begin
            x64_cut_8 <= x64_cut_7;
            x128_8 <= x128_7;
            tap_0_8 <= tap_0_7;
            power_0_2_8 <= power_0_2_7;
            tap_1_8 <= tap_1_7;
            power_1_0_8 <= power_1_0_7;
            tap_2_8 <= tap_2_7;
        end
    end

    // ===== Stage 8: power_0_3, power_1_1, power_2_0, y_half
    // UQ1.16: one of two powers of x
    wire [16:0] power_0_3_8 = tap_0_8 ? x128_8 : x64_cut_8;
    // UQ1.16: one of two powers of x
    wire [16:0] power_1_1_8 = tap_1_8 ? power_0_3_8 : power_0_2_8;
    // UQ1.16: one of two powers of x
    wire [16:0] power_2_0_8 = tap_2_8 ? power_1_1_8 : power_1_0_8;
    // UQ1.16: plus half an output ulp: the result is rounded to nearest
    wire [16:0] y_half_8 = power_2_0_8 + 17'h00008;
    // UQ1.12: rounded down to the output's bits
    wire [12:0] y_8 = y_half_8[16:4];
    reg [12:0] y_9;
    always @(posedge clk) begin
        if (ce) begin
            y_9 <= y_8;
        end
    end

    assign out_valid = valid[9];
    assign out_spec  = y_9;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    x2_exact_1[25],
                    x2_exact_1[1:0],
                    x4_exact_2[45],
                    x4_exact_2[22:0],
                    x8_exact_3[43],
                    x8_exact_3[21:0],
                    x16_exact_4[41],
                    x16_exact_4[20:0],
                    x32_exact_5[39],
                    x32_exact_5[19:0],
                    x64_exact_6[37],
                    x64_exact_6[18:0],
                    x128_exact_7[35],
                    x128_exact_7[17:0],
                    y_half_8[3:0]};

endmodule

`default_nettype wire
