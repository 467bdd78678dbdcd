// log_exp_9: specular lobe x^n as 2^(-n L(x)), L = -log2 x, n = 1 to 255
//
// Made by: brdfgen generate core.toml
// Spec 608aa1feabb28d90. Generated; the core is yours to use under any terms.
//
//   in_n      UQ8.0   shininess, 1 to 255; outside: the nearest end
//   in_cos    Q1.14   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.14  the lobe, 0 to 1; 1.0 is exact
//
// Latency 12 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -27.411..+26.557.
//   measured -19.559..+19.152 over all 4178175 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.119 % absolute, 0.119 % where x^n >= 1/2, 0.219 % relative there.

`timescale 1ns / 1ps
`default_nettype none

module log_exp_9 (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ8.0: shininess, 1 to 255; outside: the nearest end
    input  wire [7:0] in_n,
    // Q1.14: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [15:0] in_cos,
    // out_spec is a result: in_valid, 12 enabled clocks later
    output wire        out_valid,
    // UQ1.14: the lobe, 0 to 1; 1.0 is exact
    output wire [14:0] out_spec
);

    // ===== Valid chain
    reg [12:1] valid;
    initial valid = 12'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 12'd0;
        end else if (ce) begin
            valid <= {valid[11:1], in_valid};
        end
    end

    // ===== Stage 0: n, x, u, above_one
    // UQ8.0: in_n taken into the range
    wire [7:0] n_0 = (in_n < 8'h01) ? 8'h01 : in_n;
    // UQ1.14: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [14:0] x_0 = in_cos[15] ? 15'h0000 : (|in_cos[14]) ? 15'h4000 : in_cos[14:0];
    // UQ1.14: u = 1 - x, the versine
    wire [14:0] u_0 = 15'h4000 - x_0;
    // UQ1.0: u = 1: the result is 0
    wire dark_bits_0 = u_0[14];
    // UQ0.6: the bits that select the entry
    wire [5:0] ratio_high_0 = x_0[13:8];
    // UQ6.0: the address in the table
    wire [5:0] ratio_entry_0 = ratio_high_0;
    // UQ-6.11: the distance from the entry's start
    wire [4:0] ratio_d_0 = x_0[7:3];
    // UQ-6.11: shifted
    wire [4:0] ratio_fall_by_0_0 = ratio_d_0;
    // UQ-5.10: shifted
    wire [4:0] ratio_fall_by_1_0 = ratio_d_0;
    // UQ1.0: n > 1
    wire above_one_0 = n_0 > 8'h01;
    reg [7:0] n_1;
    reg [14:0] x_1;
    reg [14:0] u_1;
    reg dark_bits_1;
    reg [5:0] ratio_entry_1;
    reg [4:0] ratio_fall_by_0_1;
    reg [4:0] ratio_fall_by_1_1;
    reg above_one_1;
    always @(posedge clk) begin
        if (ce) begin
            n_1 <= n_0;
            x_1 <= x_0;
            u_1 <= u_0;
            dark_bits_1 <= dark_bits_0;
            ratio_entry_1 <= ratio_entry_0;
            ratio_fall_by_0_1 <= ratio_fall_by_0_0;
            ratio_fall_by_1_1 <= ratio_fall_by_1_0;
            above_one_1 <= above_one_0;
        end
    end

    // ===== Stage 1: read log_table, nu
    // The word of the memory log_table, of 64 words.
    reg [13:0] log_table_2;
    // UQ9.14: n u
    wire [22:0] nu_1 = n_1 * u_1;
    // UQ8.-3: so large that z is past what the result can show
    wire [4:0] beyond_bits_1 = nu_1[21:17];
    // UQ3.11: v = n u, rounded down
    wire [13:0] v_1 = nu_1[16:3];
    always @(posedge clk) begin
        if (ce) begin
            case (ratio_entry_1)
                6'd0: log_table_2 <= 14'h32af;
                6'd1: log_table_2 <= 14'h2b1f;
                6'd2: log_table_2 <= 14'h26a7;
                6'd3: log_table_2 <= 14'h2373;
                6'd4: log_table_2 <= 14'h2107;
                6'd5: log_table_2 <= 14'h1f1b;
                6'd6: log_table_2 <= 14'h1d87;
                6'd7: log_table_2 <= 14'h1c33;
                6'd8: log_table_2 <= 14'h1b0b;
                6'd9: log_table_2 <= 14'h1a07;
                6'd10: log_table_2 <= 14'h1923;
                6'd11: log_table_2 <= 14'h1857;
                6'd12: log_table_2 <= 14'h179f;
                6'd13: log_table_2 <= 14'h16f3;
                6'd14: log_table_2 <= 14'h165b;
                6'd15: log_table_2 <= 14'h15cb;
                6'd16: log_table_2 <= 14'h1547;
                6'd17: log_table_2 <= 14'h14cb;
                6'd18: log_table_2 <= 14'h1457;
                6'd19: log_table_2 <= 14'h13eb;
                6'd20: log_table_2 <= 14'h1387;
                6'd21: log_table_2 <= 14'h1327;
                6'd22: log_table_2 <= 14'h12cb;
                6'd23: log_table_2 <= 14'h1277;
                6'd24: log_table_2 <= 14'h1227;
                6'd25: log_table_2 <= 14'h11ca;
                6'd26: log_table_2 <= 14'h117e;
                6'd27: log_table_2 <= 14'h113a;
                6'd28: log_table_2 <= 14'h10f6;
                6'd29: log_table_2 <= 14'h10b6;
                6'd30: log_table_2 <= 14'h107a;
                6'd31: log_table_2 <= 14'h103e;
                6'd32: log_table_2 <= 14'h1006;
                6'd33: log_table_2 <= 14'h0fce;
                6'd34: log_table_2 <= 14'h0f9a;
                6'd35: log_table_2 <= 14'h0f66;
                6'd36: log_table_2 <= 14'h0f36;
                6'd37: log_table_2 <= 14'h0f06;
                6'd38: log_table_2 <= 14'h0ec9;
                6'd39: log_table_2 <= 14'h0e9d;
                6'd40: log_table_2 <= 14'h0e71;
                6'd41: log_table_2 <= 14'h0e49;
                6'd42: log_table_2 <= 14'h0e21;
                6'd43: log_table_2 <= 14'h0df9;
                6'd44: log_table_2 <= 14'h0dd5;
                6'd45: log_table_2 <= 14'h0dad;
                6'd46: log_table_2 <= 14'h0d89;
                6'd47: log_table_2 <= 14'h0d69;
                6'd48: log_table_2 <= 14'h0d45;
                6'd49: log_table_2 <= 14'h0d25;
                6'd50: log_table_2 <= 14'h0d05;
                6'd51: log_table_2 <= 14'h0ce5;
                6'd52: log_table_2 <= 14'h0cc9;
                6'd53: log_table_2 <= 14'h0ca9;
                6'd54: log_table_2 <= 14'h0c8d;
                6'd55: log_table_2 <= 14'h0c71;
                6'd56: log_table_2 <= 14'h0c55;
                6'd57: log_table_2 <= 14'h0c3d;
                6'd58: log_table_2 <= 14'h0c21;
                6'd59: log_table_2 <= 14'h0c09;
                6'd60: log_table_2 <= 14'h0bed;
                6'd61: log_table_2 <= 14'h0bd5;
                6'd62: log_table_2 <= 14'h0bbd;
                6'd63: log_table_2 <= 14'h0ba5;
                default: log_table_2 <= 14'h32af;
            endcase
        end
    end
    reg [14:0] x_2;
    reg dark_bits_2;
    reg [4:0] beyond_bits_2;
    reg [13:0] v_2;
    reg [4:0] ratio_fall_by_0_2;
    reg [4:0] ratio_fall_by_1_2;
    reg above_one_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            dark_bits_2 <= dark_bits_1;
            beyond_bits_2 <= beyond_bits_1;
            v_2 <= v_1;
            ratio_fall_by_0_2 <= ratio_fall_by_0_1;
            ratio_fall_by_1_2 <= ratio_fall_by_1_1;
            above_one_2 <= above_one_1;
        end
    end

    // ===== Stage 2: registers only
    // UQ1.0: so large that z is past what the result can show
    wire beyond_2 = |beyond_bits_2;
    // UQ3.9: log ratio at the entry's start
    wire [11:0] log_base_2 = log_table_2[13:2];
    // UQ2.0: how steeply the log ratio falls
    wire [1:0] log_slope_2 = log_table_2[1:0];
    // UQ1.0: the result is 0
    wire zero_of_2_2 = dark_bits_2 | beyond_2;
    reg [14:0] x_3;
    reg [13:0] v_3;
    reg [11:0] log_base_3;
    reg [1:0] log_slope_3;
    reg [4:0] ratio_fall_by_0_3;
    reg [4:0] ratio_fall_by_1_3;
    reg zero_of_2_3;
    reg above_one_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            v_3 <= v_2;
            log_base_3 <= log_base_2;
            log_slope_3 <= log_slope_2;
            ratio_fall_by_0_3 <= ratio_fall_by_0_2;
            ratio_fall_by_1_3 <= ratio_fall_by_1_2;
            zero_of_2_3 <= zero_of_2_2;
            above_one_3 <= above_one_2;
        end
    end

    // ===== Stage 3: ratio_fall_term_0, ratio_fall_term_1, ratio_fall_to_1
    // UQ1.0: a bit of the slope
    wire ratio_fall_bit_0_3 = log_slope_3[0];
    // UQ1.0: the bit is 0
    wire ratio_fall_without_0_3 = ~ratio_fall_bit_0_3;
    // UQ-6.11: 0 where the bit is 0
    wire [4:0] ratio_fall_term_0_3 = ratio_fall_without_0_3 ? 5'd0 : ratio_fall_by_0_3;
    // UQ2.-1: a bit of the slope
    wire ratio_fall_bit_1_3 = log_slope_3[1];
    // UQ1.0: the bit is 0
    wire ratio_fall_without_1_3 = ~ratio_fall_bit_1_3;
    // UQ-5.10: 0 where the bit is 0
    wire [4:0] ratio_fall_term_1_3 = ratio_fall_without_1_3 ? 5'd0 : ratio_fall_by_1_3;
    // UQ-4.11: how far the value has fallen from the entry's start
    wire [6:0] ratio_fall_to_1_3 = {2'd0, ratio_fall_term_0_3} + {1'd0, ratio_fall_term_1_3, 1'd0};
    // UQ-4.9: rounded down
    wire [4:0] ratio_step_3 = ratio_fall_to_1_3[6:2];
    reg [14:0] x_4;
    reg [13:0] v_4;
    reg [11:0] log_base_4;
    reg [4:0] ratio_step_4;
    reg zero_of_2_4;
    reg above_one_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            v_4 <= v_3;
            log_base_4 <= log_base_3;
            ratio_step_4 <= ratio_step_3;
            zero_of_2_4 <= zero_of_2_3;
            above_one_4 <= above_one_3;
        end
    end

    // ===== Stage 4: ratio
    // UQ3.9: k = -log2(x) / u
    wire [11:0] ratio_4 = log_base_4 - {7'd0, ratio_step_4};
    reg [14:0] x_5;
    reg [13:0] v_5;
    reg [11:0] ratio_5;
    reg zero_of_2_5;
    reg above_one_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            v_5 <= v_4;
            ratio_5 <= ratio_4;
            zero_of_2_5 <= zero_of_2_4;
            above_one_5 <= above_one_4;
        end
    end

    // ===== Stage 5: vk
    // UQ6.20: v k
    wire [25:0] vk_5 = v_5 * ratio_5;
    // UQ6.10: z = n L, rounded down
    wire [15:0] z_5 = vk_5[25:10];
    // UQ6.-4: z is past what the result can show
    wire [1:0] over_bits_5 = z_5[15:14];
    // UQ0.5: the bits that select the entry
    wire [4:0] power_high_5 = z_5[9:5];
    // UQ5.0: the address in the table
    wire [4:0] power_entry_5 = power_high_5;
    // UQ-5.10: the distance from the entry's start
    wire [4:0] power_d_5 = z_5[4:0];
    // UQ-9.14: shifted
    wire [4:0] power_fall_by_0_5 = power_d_5;
    // UQ-8.13: shifted
    wire [4:0] power_fall_by_1_5 = power_d_5;
    // UQ-7.12: shifted
    wire [4:0] power_fall_by_2_5 = power_d_5;
    // UQ-6.11: shifted
    wire [4:0] power_fall_by_3_5 = power_d_5;
    // UQ4.0: the integer part of z
    wire [3:0] i_5 = z_5[13:10];
    reg [14:0] x_6;
    reg [1:0] over_bits_6;
    reg [4:0] power_entry_6;
    reg [4:0] power_fall_by_0_6;
    reg [4:0] power_fall_by_1_6;
    reg [4:0] power_fall_by_2_6;
    reg [4:0] power_fall_by_3_6;
    reg [3:0] i_6;
    reg zero_of_2_6;
    reg above_one_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            over_bits_6 <= over_bits_5;
            power_entry_6 <= power_entry_5;
            power_fall_by_0_6 <= power_fall_by_0_5;
            power_fall_by_1_6 <= power_fall_by_1_5;
            power_fall_by_2_6 <= power_fall_by_2_5;
            power_fall_by_3_6 <= power_fall_by_3_5;
            i_6 <= i_5;
            zero_of_2_6 <= zero_of_2_5;
            above_one_6 <= above_one_5;
        end
    end

    // ===== Stage 6: read exp_table
    // The word of the memory exp_table, of 32 words.
    reg [15:0] exp_table_7;
    // UQ1.0: z is past what the result can show
    wire over_6 = |over_bits_6;
    // UQ1.0: the result is 0
    wire zero_6 = zero_of_2_6 | over_6;
    always @(posedge clk) begin
        if (ce) begin
            case (power_entry_6)
                5'd0: exp_table_7 <= 16'hffdb;
                5'd1: exp_table_7 <= 16'hfa7b;
                5'd2: exp_table_7 <= 16'hf52b;
                5'd3: exp_table_7 <= 16'hefba;
                5'd4: exp_table_7 <= 16'hea9a;
                5'd5: exp_table_7 <= 16'he5aa;
                5'd6: exp_table_7 <= 16'he0ca;
                5'd7: exp_table_7 <= 16'hdbc9;
                5'd8: exp_table_7 <= 16'hd719;
                5'd9: exp_table_7 <= 16'hd289;
                5'd10: exp_table_7 <= 16'hce19;
                5'd11: exp_table_7 <= 16'hc9b9;
                5'd12: exp_table_7 <= 16'hc538;
                5'd13: exp_table_7 <= 16'hc108;
                5'd14: exp_table_7 <= 16'hbce8;
                5'd15: exp_table_7 <= 16'hb8e8;
                5'd16: exp_table_7 <= 16'hb4f8;
                5'd17: exp_table_7 <= 16'hb128;
                5'd18: exp_table_7 <= 16'had27;
                5'd19: exp_table_7 <= 16'ha977;
                5'd20: exp_table_7 <= 16'ha5e7;
                5'd21: exp_table_7 <= 16'ha257;
                5'd22: exp_table_7 <= 16'h9ee7;
                5'd23: exp_table_7 <= 16'h9b87;
                5'd24: exp_table_7 <= 16'h9847;
                5'd25: exp_table_7 <= 16'h94c6;
                5'd26: exp_table_7 <= 16'h91a6;
                5'd27: exp_table_7 <= 16'h8e86;
                5'd28: exp_table_7 <= 16'h8b86;
                5'd29: exp_table_7 <= 16'h8886;
                5'd30: exp_table_7 <= 16'h85a6;
                5'd31: exp_table_7 <= 16'h82d6;
                default: exp_table_7 <= 16'hffdb;
            endcase
        end
    end
    reg [14:0] x_7;
    reg [4:0] power_fall_by_0_7;
    reg [4:0] power_fall_by_1_7;
    reg [4:0] power_fall_by_2_7;
    reg [4:0] power_fall_by_3_7;
    reg [3:0] i_7;
    reg zero_7;
    reg above_one_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            power_fall_by_0_7 <= power_fall_by_0_6;
            power_fall_by_1_7 <= power_fall_by_1_6;
            power_fall_by_2_7 <= power_fall_by_2_6;
            power_fall_by_3_7 <= power_fall_by_3_6;
            i_7 <= i_6;
            zero_7 <= zero_6;
            above_one_7 <= above_one_6;
        end
    end

    // ===== Stage 7: registers only
    // UQ0.12: 2^-f at the entry's start
    wire [11:0] exp_base_7 = exp_table_7[15:4];
    // UQ0.4: how steeply 2^-f falls
    wire [3:0] exp_slope_7 = exp_table_7[3:0];
    reg [14:0] x_8;
    reg [11:0] exp_base_8;
    reg [3:0] exp_slope_8;
    reg [4:0] power_fall_by_0_8;
    reg [4:0] power_fall_by_1_8;
    reg [4:0] power_fall_by_2_8;
    reg [4:0] power_fall_by_3_8;
    reg [3:0] i_8;
    reg zero_8;
    reg above_one_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            exp_base_8 <= exp_base_7;
            exp_slope_8 <= exp_slope_7;
            power_fall_by_0_8 <= power_fall_by_0_7;
            power_fall_by_1_8 <= power_fall_by_1_7;
            power_fall_by_2_8 <= power_fall_by_2_7;
            power_fall_by_3_8 <= power_fall_by_3_7;
            i_8 <= i_7;
            zero_8 <= zero_7;
            above_one_8 <= above_one_7;
        end
    end

    // ===== Stage 8: power_fall_term_0, power_fall_term_1, power_fall_to_1 and 2 more
    // UQ-3.4: a bit of the slope
    wire power_fall_bit_0_8 = exp_slope_8[0];
    // UQ1.0: the bit is 0
    wire power_fall_without_0_8 = ~power_fall_bit_0_8;
    // UQ-9.14: 0 where the bit is 0
    wire [4:0] power_fall_term_0_8 = power_fall_without_0_8 ? 5'd0 : power_fall_by_0_8;
    // UQ-2.3: a bit of the slope
    wire power_fall_bit_1_8 = exp_slope_8[1];
    // UQ1.0: the bit is 0
    wire power_fall_without_1_8 = ~power_fall_bit_1_8;
    // UQ-8.13: 0 where the bit is 0
    wire [4:0] power_fall_term_1_8 = power_fall_without_1_8 ? 5'd0 : power_fall_by_1_8;
    // UQ-7.14: how far the value has fallen from the entry's start
    wire [6:0] power_fall_to_1_8 = {2'd0, power_fall_term_0_8} + {1'd0, power_fall_term_1_8, 1'd0};
    // UQ-1.2: a bit of the slope
    wire power_fall_bit_2_8 = exp_slope_8[2];
    // UQ1.0: the bit is 0
    wire power_fall_without_2_8 = ~power_fall_bit_2_8;
    // UQ-7.12: 0 where the bit is 0
    wire [4:0] power_fall_term_2_8 = power_fall_without_2_8 ? 5'd0 : power_fall_by_2_8;
    // UQ0.1: a bit of the slope
    wire power_fall_bit_3_8 = exp_slope_8[3];
    // UQ1.0: the bit is 0
    wire power_fall_without_3_8 = ~power_fall_bit_3_8;
    // UQ-6.11: 0 where the bit is 0
    wire [4:0] power_fall_term_3_8 = power_fall_without_3_8 ? 5'd0 : power_fall_by_3_8;
    reg [14:0] x_9;
    reg [11:0] exp_base_9;
    reg [6:0] power_fall_to_1_9;
    reg [4:0] power_fall_term_2_9;
    reg [4:0] power_fall_term_3_9;
    reg [3:0] i_9;
    reg zero_9;
    reg above_one_9;
    always @(posedge clk) begin
        if (ce) begin
            x_9 <= x_8;
            exp_base_9 <= exp_base_8;
            power_fall_to_1_9 <= power_fall_to_1_8;
            power_fall_term_2_9 <= power_fall_term_2_8;
            power_fall_term_3_9 <= power_fall_term_3_8;
            i_9 <= i_8;
            zero_9 <= zero_8;
            above_one_9 <= above_one_8;
        end
    end

    // ===== Stage 9: power_fall_to_2, power_fall_to_3
    // UQ-6.14: how far the value has fallen from the entry's start
    wire [7:0] power_fall_to_2_9 = {1'd0, power_fall_to_1_9} + {1'd0, power_fall_term_2_9, 2'd0};
    // UQ-5.14: how far the value has fallen from the entry's start
    wire [8:0] power_fall_to_3_9 = {1'd0, power_fall_to_2_9} + {1'd0, power_fall_term_3_9, 3'd0};
    // UQ-5.12: rounded down
    wire [6:0] power_step_9 = power_fall_to_3_9[8:2];
    reg [14:0] x_10;
    reg [11:0] exp_base_10;
    reg [6:0] power_step_10;
    reg [3:0] i_10;
    reg zero_10;
    reg above_one_10;
    always @(posedge clk) begin
        if (ce) begin
            x_10 <= x_9;
            exp_base_10 <= exp_base_9;
            power_step_10 <= power_step_9;
            i_10 <= i_9;
            zero_10 <= zero_9;
            above_one_10 <= above_one_9;
        end
    end

    // ===== Stage 10: power
    // UQ0.12: 2^-f
    wire [11:0] power_10 = exp_base_10 - {5'd0, power_step_10};
    reg [14:0] x_11;
    reg [11:0] power_11;
    reg [3:0] i_11;
    reg zero_11;
    reg above_one_11;
    always @(posedge clk) begin
        if (ce) begin
            x_11 <= x_10;
            power_11 <= power_10;
            i_11 <= i_10;
            zero_11 <= zero_10;
            above_one_11 <= above_one_10;
        end
    end

    // ===== Stage 11: power_shifted, y, y_or_x
    // UQ0.12: 2^-z = 2^-f 2^-i
    wire [11:0] power_shifted_11 = power_11 >> i_11;
    // UQ0.14: the output's bits
    wire [13:0] y_cut_11 = {power_shifted_11, 2'd0};
    // UQ0.14: y, 0 where it is past what the result can show
    wire [13:0] y_11 = zero_11 ? 14'd0 : y_cut_11;
    // UQ1.14: x itself for n = 1
    wire [14:0] y_or_x_11 = above_one_11 ? {1'd0, y_11} : x_11;
    reg [14:0] y_or_x_12;
    always @(posedge clk) begin
        if (ce) begin
            y_or_x_12 <= y_or_x_11;
        end
    end

    assign out_valid = valid[12];
    assign out_spec  = y_or_x_12;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nu_1[22],
                    nu_1[2:0],
                    ratio_fall_to_1_3[1:0],
                    vk_5[9:0],
                    power_fall_to_3_9[1:0]};

endmodule

`default_nettype wire
