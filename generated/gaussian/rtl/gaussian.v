// gaussian: specular lobe x^n as e^(-n u), n = 1 to 127
//
// Made by: brdfgen generate core.toml
// Spec ffaebb9642af1568. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
//
// Latency 9 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.821..+0.997.
//   measured -0.593..+0.935 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   36.792 % absolute, 10.718 % where x^n >= 1/2, 21.425 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module gaussian (
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
    // out_spec is a result: in_valid, 9 enabled clocks later
    output wire        out_valid,
    // UQ1.10: the lobe, 0 to 1; 1.0 is exact
    output wire [10:0] out_spec
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

    // ===== Stage 0: n, x, u
    // UQ7.0: in_n taken into the range
    wire [6:0] n_0 = (in_n < 7'h01) ? 7'h01 : in_n;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.12: u = 1 - x, the versine
    wire [12:0] u_0 = 13'h1000 - x_0;
    // UQ1.0: u = 1: the surface faces away
    wire dark_bits_0 = u_0[12];
    reg [6:0] n_1;
    reg [12:0] u_1;
    reg dark_bits_1;
    always @(posedge clk) begin
        if (ce) begin
            n_1 <= n_0;
            u_1 <= u_0;
            dark_bits_1 <= dark_bits_0;
        end
    end

    // ===== Stage 1: nu
    // UQ8.12: n u
    wire [19:0] nu_1 = n_1 * u_1;
    // UQ7.-3: so large that z is past what the result can show
    wire [3:0] beyond_bits_1 = nu_1[18:15];
    // UQ3.11: v = n u, rounded down
    wire [13:0] v_1 = nu_1[14:1];
    reg [3:0] beyond_bits_2;
    reg [13:0] v_2;
    reg dark_bits_2;
    always @(posedge clk) begin
        if (ce) begin
            beyond_bits_2 <= beyond_bits_1;
            v_2 <= v_1;
            dark_bits_2 <= dark_bits_1;
        end
    end

    // ===== Stage 2: vk
    // UQ1.0: so large that z is past what the result can show
    wire beyond_2 = |beyond_bits_2;
    // UQ4.21: v log2 e
    wire [24:0] vk_2 = v_2 * 11'h5c5;
    // UQ4.13: z = n u log2 e, rounded down
    wire [16:0] z_2 = vk_2[24:8];
    // UQ0.4: the bits that select the entry
    wire [3:0] power_high_2 = z_2[12:9];
    // UQ4.0: the address in the table
    wire [3:0] power_entry_2 = power_high_2;
    // UQ-4.13: the distance from the entry's start
    wire [8:0] power_d_2 = z_2[8:0];
    // UQ4.0: the integer part of z
    wire [3:0] i_2 = z_2[16:13];
    reg beyond_3;
    reg [3:0] power_entry_3;
    reg [8:0] power_d_3;
    reg [3:0] i_3;
    reg dark_bits_3;
    always @(posedge clk) begin
        if (ce) begin
            beyond_3 <= beyond_2;
            power_entry_3 <= power_entry_2;
            power_d_3 <= power_d_2;
            i_3 <= i_2;
            dark_bits_3 <= dark_bits_2;
        end
    end

    // ===== Stage 3: read exp_table
    // The word of the memory exp_table, of 16 words.
    reg [20:0] exp_table_4;
    always @(posedge clk) begin
        if (ce) begin
            case (power_entry_3)
                4'd0: exp_table_4 <= 21'h1ffd5b;
                4'd1: exp_table_4 <= 21'h1ea34d;
                4'd2: exp_table_4 <= 21'h1d553e;
                4'd3: exp_table_4 <= 21'h1c1731;
                4'd4: exp_table_4 <= 21'h1ae724;
                4'd5: exp_table_4 <= 21'h19c318;
                4'd6: exp_table_4 <= 21'h18ab0c;
                4'd7: exp_table_4 <= 21'h179f00;
                4'd8: exp_table_4 <= 21'h169ef6;
                4'd9: exp_table_4 <= 21'h15a8eb;
                4'd10: exp_table_4 <= 21'h14bee1;
                4'd11: exp_table_4 <= 21'h13dcd8;
                4'd12: exp_table_4 <= 21'h1304ce;
                4'd13: exp_table_4 <= 21'h1236c6;
                4'd14: exp_table_4 <= 21'h1170bd;
                4'd15: exp_table_4 <= 21'h10b4b5;
                default: exp_table_4 <= 21'h1ffd5b;
            endcase
        end
    end
    reg beyond_4;
    reg [8:0] power_d_4;
    reg [3:0] i_4;
    reg dark_bits_4;
    always @(posedge clk) begin
        if (ce) begin
            beyond_4 <= beyond_3;
            power_d_4 <= power_d_3;
            i_4 <= i_3;
            dark_bits_4 <= dark_bits_3;
        end
    end

    // ===== Stage 4: registers only
    // UQ0.12: 2^-f at the entry's start
    wire [11:0] exp_base_4 = exp_table_4[20:9];
    // UQ0.9: how steeply 2^-f falls
    wire [8:0] exp_slope_4 = exp_table_4[8:0];
    reg beyond_5;
    reg [11:0] exp_base_5;
    reg [8:0] exp_slope_5;
    reg [8:0] power_d_5;
    reg [3:0] i_5;
    reg dark_bits_5;
    always @(posedge clk) begin
        if (ce) begin
            beyond_5 <= beyond_4;
            exp_base_5 <= exp_base_4;
            exp_slope_5 <= exp_slope_4;
            power_d_5 <= power_d_4;
            i_5 <= i_4;
            dark_bits_5 <= dark_bits_4;
        end
    end

    // ===== Stage 5: power_fall
    // UQ-4.22: how far the value has fallen from the entry's start
    wire [17:0] power_fall_5 = exp_slope_5 * power_d_5;
    // UQ-4.12: rounded down
    wire [7:0] power_step_5 = power_fall_5[17:10];
    reg beyond_6;
    reg [11:0] exp_base_6;
    reg [7:0] power_step_6;
    reg [3:0] i_6;
    reg dark_bits_6;
    always @(posedge clk) begin
        if (ce) begin
            beyond_6 <= beyond_5;
            exp_base_6 <= exp_base_5;
            power_step_6 <= power_step_5;
            i_6 <= i_5;
            dark_bits_6 <= dark_bits_5;
        end
    end

    // ===== Stage 6: power
    // UQ0.12: 2^-f
    wire [11:0] power_6 = exp_base_6 - {4'd0, power_step_6};
    reg beyond_7;
    reg [11:0] power_7;
    reg [3:0] i_7;
    reg dark_bits_7;
    always @(posedge clk) begin
        if (ce) begin
            beyond_7 <= beyond_6;
            power_7 <= power_6;
            i_7 <= i_6;
            dark_bits_7 <= dark_bits_6;
        end
    end

    // ===== Stage 7: power_shifted
    // UQ0.12: 2^-z = 2^-f 2^-i
    wire [11:0] power_shifted_7 = power_7 >> i_7;
    reg beyond_8;
    reg [11:0] power_shifted_8;
    reg dark_bits_8;
    always @(posedge clk) begin
        if (ce) begin
            beyond_8 <= beyond_7;
            power_shifted_8 <= power_shifted_7;
            dark_bits_8 <= dark_bits_7;
        end
    end

    // ===== Stage 8: y_half, y, y_lit
    // UQ1.12: plus half an output ulp: the result is rounded to nearest
    wire [12:0] y_half_8 = {1'd0, power_shifted_8} + 13'h0002;
    // UQ1.10: rounded to the output's bits
    wire [10:0] y_cut_8 = y_half_8[12:2];
    // UQ1.10: y, 0 where it is below half an ulp
    wire [10:0] y_8 = beyond_8 ? 11'd0 : y_cut_8;
    // UQ1.10: y, 0 where the surface faces away
    wire [10:0] y_lit_8 = dark_bits_8 ? 11'd0 : y_8;
    reg [10:0] y_lit_9;
    always @(posedge clk) begin
        if (ce) begin
            y_lit_9 <= y_lit_8;
        end
    end

    assign out_valid = valid[9];
    assign out_spec  = y_lit_9;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nu_1[19],
                    nu_1[0],
                    vk_2[7:0],
                    power_fall_5[9:0],
                    y_half_8[1:0]};

endmodule

`default_nettype wire
