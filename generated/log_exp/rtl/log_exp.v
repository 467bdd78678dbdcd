// log_exp: specular lobe x^n as 2^(-n L(x)), L = -log2 x, n = 1 to 63
//
// Made by: brdfgen generate core.toml
// Spec 1c52e369b64c704a. Generated; the core is yours to use under any terms.
//
//   in_n      UQ6.2   shininess, 1 to 63 in steps of 2^-2; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 14 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.886..+0.988.
//   measured -0.629..+0.743 over all 1020153 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.01815 % absolute, 0.01815 % where x^n >= 1/2, 0.03395 % relative there.
// As the cosine rises, the output never falls: proved by running all 1019904 pairs of neighbouring
//   inputs.

`timescale 1ns / 1ps
`default_nettype none

module log_exp (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // in_n and in_cos are to be taken
    input  wire        in_valid,
    // UQ6.2: shininess, 1 to 63 in steps of 2^-2; outside: the nearest end
    input  wire [7:0] in_n,
    // Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
    input  wire [13:0] in_cos,
    // out_spec is a result: in_valid, 14 enabled clocks later
    output wire        out_valid,
    // UQ1.12: the lobe, 0 to 1; 1.0 is exact
    output wire [12:0] out_spec
);

    // ===== Valid chain
    reg [14:1] valid;
    initial valid = 14'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 14'd0;
        end else if (ce) begin
            valid <= {valid[13:1], in_valid};
        end
    end

    // ===== Stage 0: n, x, m_8, n_low, ne_8, ne_4
    // UQ6.2: in_n taken into the range
    wire [7:0] n_0 = (in_n < 8'h04) ? 8'h04 : (in_n > 8'hfc) ? 8'hfc : in_n;
    // UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    wire [12:0] x_0 = in_cos[13] ? 13'h0000 : (|in_cos[12]) ? 13'h1000 : in_cos[12:0];
    // UQ1.0: x is large enough for a result above half an ulp
    wire enough_0 = |x_0;
    // UQ1.0: x is so small that the result is 0
    wire small_0 = ~enough_0;
    // UQ1.8: a bit of weight 2^-8 or more is set
    wire [8:0] m_above_8_bits_0 = x_0[12:4];
    // UQ1.0: a bit of weight 2^-8 or more is set
    wire m_above_8_0 = |m_above_8_bits_0;
    // UQ9.4: shifted
    wire [12:0] m_by_8_0 = x_0;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_8_0 = {m_by_8_0[3:0], 8'd0};
    // UQ1.12: shifted to the left by 8 where that loses no bit
    wire [12:0] m_8_0 = m_above_8_0 ? x_0 : {1'd0, m_moved_8_0};
    // UQ1.4: a bit of weight 2^-4 or more is set
    wire [4:0] m_above_4_bits_0 = m_8_0[12:8];
    // UQ1.0: a bit of weight 2^-4 or more is set
    wire m_above_4_0 = |m_above_4_bits_0;
    // UQ5.8: shifted
    wire [12:0] m_by_4_0 = m_8_0;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_4_0 = {m_by_4_0[7:0], 4'd0};
    // UQ5.2: n or more than the result can show, where x < 1/2
    wire [6:0] n_low_0 = (|n_0[7:6]) ? 7'h40 : n_0[6:0];
    // UQ8.-1: 8 n
    wire [6:0] n_8_0 = n_low_0;
    // UQ8.-1: 0 where this step was not taken
    wire [6:0] ne_8_0 = m_above_8_0 ? 7'd0 : n_8_0;
    // UQ7.0: 4 n
    wire [6:0] n_4_0 = n_low_0;
    // UQ7.0: 0 where this step was not taken
    wire [6:0] ne_4_0 = m_above_4_0 ? 7'd0 : n_4_0;
    // UQ6.1: 2 n
    wire [6:0] n_2_0 = n_low_0;
    // UQ5.2: 1 n
    wire [6:0] n_1_0 = n_low_0;
    reg [7:0] n_1;
    reg small_1;
    reg [12:0] m_8_1;
    reg m_above_4_1;
    reg [11:0] m_moved_4_1;
    reg [6:0] ne_8_1;
    reg [6:0] ne_4_1;
    reg [6:0] n_2_1;
    reg [6:0] n_1_1;
    always @(posedge clk) begin
        if (ce) begin
            n_1 <= n_0;
            small_1 <= small_0;
            m_8_1 <= m_8_0;
            m_above_4_1 <= m_above_4_0;
            m_moved_4_1 <= m_moved_4_0;
            ne_8_1 <= ne_8_0;
            ne_4_1 <= ne_4_0;
            n_2_1 <= n_2_0;
            n_1_1 <= n_1_0;
        end
    end

    // ===== Stage 1: m_4, m_2, m_1, ne_2, ne_1, ne_sum_1_0
    // UQ1.12: shifted to the left by 4 where that loses no bit
    wire [12:0] m_4_1 = m_above_4_1 ? m_8_1 : {1'd0, m_moved_4_1};
    // UQ1.2: a bit of weight 2^-2 or more is set
    wire [2:0] m_above_2_bits_1 = m_4_1[12:10];
    // UQ1.0: a bit of weight 2^-2 or more is set
    wire m_above_2_1 = |m_above_2_bits_1;
    // UQ3.10: shifted
    wire [12:0] m_by_2_1 = m_4_1;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_2_1 = {m_by_2_1[9:0], 2'd0};
    // UQ1.12: shifted to the left by 2 where that loses no bit
    wire [12:0] m_2_1 = m_above_2_1 ? m_4_1 : {1'd0, m_moved_2_1};
    // UQ1.1: a bit of weight 2^-1 or more is set
    wire [1:0] m_above_1_bits_1 = m_2_1[12:11];
    // UQ1.0: a bit of weight 2^-1 or more is set
    wire m_above_1_1 = |m_above_1_bits_1;
    // UQ2.11: shifted
    wire [12:0] m_by_1_1 = m_2_1;
    // UQ0.12: the high bits are 0
    wire [11:0] m_moved_1_1 = {m_by_1_1[10:0], 1'd0};
    // UQ1.12: shifted to the left by 1 where that loses no bit
    wire [12:0] m_1_1 = m_above_1_1 ? m_2_1 : {1'd0, m_moved_1_1};
    // UQ-1.5: the bits that select the entry
    wire [3:0] ratio_high_1 = m_1_1[10:7];
    // UQ4.0: the address in the table
    wire [3:0] ratio_entry_1 = ratio_high_1;
    // UQ-5.12: the distance from the entry's start
    wire [6:0] ratio_d_1 = m_1_1[6:0];
    // UQ6.1: 0 where this step was not taken
    wire [6:0] ne_2_1 = m_above_2_1 ? 7'd0 : n_2_1;
    // UQ5.2: 0 where this step was not taken
    wire [6:0] ne_1_1 = m_above_1_1 ? 7'd0 : n_1_1;
    // UQ8.0: n e
    wire [7:0] ne_sum_1_0_1 = {ne_8_1, 1'd0} + {1'd0, ne_4_1};
    reg [7:0] n_2;
    reg small_2;
    reg [12:0] m_1_2;
    reg [3:0] ratio_entry_2;
    reg [6:0] ratio_d_2;
    reg [6:0] ne_2_2;
    reg [6:0] ne_1_2;
    reg [7:0] ne_sum_1_0_2;
    always @(posedge clk) begin
        if (ce) begin
            n_2 <= n_1;
            small_2 <= small_1;
            m_1_2 <= m_1_1;
            ratio_entry_2 <= ratio_entry_1;
            ratio_d_2 <= ratio_d_1;
            ne_2_2 <= ne_2_1;
            ne_1_2 <= ne_1_1;
            ne_sum_1_0_2 <= ne_sum_1_0_1;
        end
    end

    // ===== Stage 2: read log_table, um, ne_sum_1_1, ne_sum_2_0
    // The word of the memory log_table, of 16 words.
    reg [25:0] log_table_3;
    // UQ0.12: 1 - m, m = x 2^e in [1/2, 1] or x = 0
    wire [11:0] um_2 = 12'h000 - m_1_2[11:0];
    // UQ6.2: n e
    wire [7:0] ne_sum_1_1_2 = {ne_2_2, 1'd0} + {1'd0, ne_1_2};
    // UQ8.2: n e
    wire [9:0] ne_sum_2_0_2 = {ne_sum_1_0_2, 2'd0} + {2'd0, ne_sum_1_1_2};
    always @(posedge clk) begin
        if (ce) begin
            case (ratio_entry_2)
                4'd0: log_table_3 <= 26'h3ffded2;
                4'd1: log_table_3 <= 26'h3e49e54;
                4'd2: log_table_3 <= 26'h3cb55e6;
                4'd3: log_table_3 <= 26'h3b3bd83;
                4'd4: log_table_3 <= 26'h39db52c;
                4'd5: log_table_3 <= 26'h3890cdd;
                4'd6: log_table_3 <= 26'h3759c96;
                4'd7: log_table_3 <= 26'h3634455;
                4'd8: log_table_3 <= 26'h351f41b;
                4'd9: log_table_3 <= 26'h34183e5;
                4'd10: log_table_3 <= 26'h331f3b4;
                4'd11: log_table_3 <= 26'h3232387;
                4'd12: log_table_3 <= 26'h3150b5e;
                4'd13: log_table_3 <= 26'h3079337;
                4'd14: log_table_3 <= 26'h2fabb14;
                4'd15: log_table_3 <= 26'h2ee6af3;
                default: log_table_3 <= 26'h3ffded2;
            endcase
        end
    end
    reg [7:0] n_3;
    reg small_3;
    reg [11:0] um_3;
    reg [6:0] ratio_d_3;
    reg [9:0] ne_sum_2_0_3;
    always @(posedge clk) begin
        if (ce) begin
            n_3 <= n_2;
            small_3 <= small_2;
            um_3 <= um_2;
            ratio_d_3 <= ratio_d_2;
            ne_sum_2_0_3 <= ne_sum_2_0_2;
        end
    end

    // ===== Stage 3: nu
    // UQ6.14: n (1 - m)
    wire [19:0] nu_3 = n_3 * um_3;
    // UQ5.-4: so large that z is past what the result can show
    wire beyond_bits_3 = nu_3[18];
    // UQ4.14: v = n (1 - m), rounded down
    wire [17:0] v_3 = nu_3[17:0];
    // UQ1.14: log ratio at the entry's start
    wire [14:0] log_base_3 = log_table_3[25:11];
    // UQ1.10: how steeply the log ratio falls
    wire [10:0] log_slope_3 = log_table_3[10:0];
    reg small_4;
    reg beyond_bits_4;
    reg [17:0] v_4;
    reg [14:0] log_base_4;
    reg [10:0] log_slope_4;
    reg [6:0] ratio_d_4;
    reg [9:0] ne_sum_2_0_4;
    always @(posedge clk) begin
        if (ce) begin
            small_4 <= small_3;
            beyond_bits_4 <= beyond_bits_3;
            v_4 <= v_3;
            log_base_4 <= log_base_3;
            log_slope_4 <= log_slope_3;
            ratio_d_4 <= ratio_d_3;
            ne_sum_2_0_4 <= ne_sum_2_0_3;
        end
    end

    // ===== Stage 4: ratio_fall
    // UQ1.0: so large that z is past what the result can show
    wire beyond_4 = |beyond_bits_4;
    // UQ-4.22: how far the value has fallen from the entry's start
    wire [17:0] ratio_fall_4 = log_slope_4 * ratio_d_4;
    // UQ-4.14: rounded down
    wire [9:0] ratio_step_4 = ratio_fall_4[17:8];
    // UQ1.0: the result is 0
    wire zero_of_2_4 = small_4 | beyond_4;
    reg [17:0] v_5;
    reg [14:0] log_base_5;
    reg [9:0] ratio_step_5;
    reg [9:0] ne_sum_2_0_5;
    reg zero_of_2_5;
    always @(posedge clk) begin
        if (ce) begin
            v_5 <= v_4;
            log_base_5 <= log_base_4;
            ratio_step_5 <= ratio_step_4;
            ne_sum_2_0_5 <= ne_sum_2_0_4;
            zero_of_2_5 <= zero_of_2_4;
        end
    end

    // ===== Stage 5: ratio
    // UQ1.14: k = -log2(m) / (1 - m)
    wire [14:0] ratio_5 = log_base_5 - {5'd0, ratio_step_5};
    reg [17:0] v_6;
    reg [14:0] ratio_6;
    reg [9:0] ne_sum_2_0_6;
    reg zero_of_2_6;
    always @(posedge clk) begin
        if (ce) begin
            v_6 <= v_5;
            ratio_6 <= ratio_5;
            ne_sum_2_0_6 <= ne_sum_2_0_5;
            zero_of_2_6 <= zero_of_2_5;
        end
    end

    // ===== Stage 6: vk
    // UQ5.28: v k
    wire [32:0] vk_6 = v_6 * ratio_6;
    // UQ5.15: rounded down
    wire [19:0] vk_cut_6 = vk_6[32:13];
    reg [19:0] vk_cut_7;
    reg [9:0] ne_sum_2_0_7;
    reg zero_of_2_7;
    always @(posedge clk) begin
        if (ce) begin
            vk_cut_7 <= vk_cut_6;
            ne_sum_2_0_7 <= ne_sum_2_0_6;
            zero_of_2_7 <= zero_of_2_6;
        end
    end

    // ===== Stage 7: z_sum
    // UQ8.15: z = n e + v k
    wire [22:0] z_sum_7 = {ne_sum_2_0_7, 13'd0} + {3'd0, vk_cut_7};
    // UQ8.-4: z is past what the result can show
    wire [3:0] over_bits_7 = z_sum_7[22:19];
    // UQ1.0: z is past what the result can show
    wire over_7 = |over_bits_7;
    // UQ0.5: the bits that select the entry
    wire [4:0] power_high_7 = z_sum_7[14:10];
    // UQ5.0: the address in the table
    wire [4:0] power_entry_7 = power_high_7;
    // UQ-5.15: the distance from the entry's start
    wire [9:0] power_d_7 = z_sum_7[9:0];
    // UQ4.0: the integer part of z
    wire [3:0] i_7 = z_sum_7[18:15];
    // UQ1.0: the result is 0
    wire zero_7 = zero_of_2_7 | over_7;
    reg [4:0] power_entry_8;
    reg [9:0] power_d_8;
    reg [3:0] i_8;
    reg zero_8;
    always @(posedge clk) begin
        if (ce) begin
            power_entry_8 <= power_entry_7;
            power_d_8 <= power_d_7;
            i_8 <= i_7;
            zero_8 <= zero_7;
        end
    end

    // ===== Stage 8: read exp_table
    // The word of the memory exp_table, of 32 words.
    reg [25:0] exp_table_9;
    always @(posedge clk) begin
        if (ce) begin
            case (power_entry_8)
                5'd0: exp_table_9 <= 26'h3fff57c;
                5'd1: exp_table_9 <= 26'h3ea055e;
                5'd2: exp_table_9 <= 26'h3d48d41;
                5'd3: exp_table_9 <= 26'h3bf8d24;
                5'd4: exp_table_9 <= 26'h3aafd08;
                5'd5: exp_table_9 <= 26'h396dcec;
                5'd6: exp_table_9 <= 26'h3832cd1;
                5'd7: exp_table_9 <= 26'h36fe4b7;
                5'd8: exp_table_9 <= 26'h35d0c9d;
                5'd9: exp_table_9 <= 26'h34a9c84;
                5'd10: exp_table_9 <= 26'h3388c6b;
                5'd11: exp_table_9 <= 26'h326dc53;
                5'd12: exp_table_9 <= 26'h315943b;
                5'd13: exp_table_9 <= 26'h304ac24;
                5'd14: exp_table_9 <= 26'h2f41c0d;
                5'd15: exp_table_9 <= 26'h2e3e3f7;
                5'd16: exp_table_9 <= 26'h2d40be1;
                5'd17: exp_table_9 <= 26'h2c48bcc;
                5'd18: exp_table_9 <= 26'h2b55bb7;
                5'd19: exp_table_9 <= 26'h2a67ba3;
                5'd20: exp_table_9 <= 26'h297f38f;
                5'd21: exp_table_9 <= 26'h289bb7b;
                5'd22: exp_table_9 <= 26'h27bcb68;
                5'd23: exp_table_9 <= 26'h26e2b55;
                5'd24: exp_table_9 <= 26'h260db43;
                5'd25: exp_table_9 <= 26'h253cb31;
                5'd26: exp_table_9 <= 26'h2470b20;
                5'd27: exp_table_9 <= 26'h23a8b0e;
                5'd28: exp_table_9 <= 26'h22e52fe;
                5'd29: exp_table_9 <= 26'h2225aed;
                5'd30: exp_table_9 <= 26'h216a2dd;
                5'd31: exp_table_9 <= 26'h20b32ce;
                default: exp_table_9 <= 26'h3fff57c;
            endcase
        end
    end
    reg [9:0] power_d_9;
    reg [3:0] i_9;
    reg zero_9;
    always @(posedge clk) begin
        if (ce) begin
            power_d_9 <= power_d_8;
            i_9 <= i_8;
            zero_9 <= zero_8;
        end
    end

    // ===== Stage 9: registers only
    // UQ0.15: 2^-f at the entry's start
    wire [14:0] exp_base_9 = exp_table_9[25:11];
    // UQ0.11: how steeply 2^-f falls
    wire [10:0] exp_slope_9 = exp_table_9[10:0];
    reg [14:0] exp_base_10;
    reg [10:0] exp_slope_10;
    reg [9:0] power_d_10;
    reg [3:0] i_10;
    reg zero_10;
    always @(posedge clk) begin
        if (ce) begin
            exp_base_10 <= exp_base_9;
            exp_slope_10 <= exp_slope_9;
            power_d_10 <= power_d_9;
            i_10 <= i_9;
            zero_10 <= zero_9;
        end
    end

    // ===== Stage 10: power_fall
    // UQ-5.26: how far the value has fallen from the entry's start
    wire [20:0] power_fall_10 = exp_slope_10 * power_d_10;
    // UQ-5.15: rounded down
    wire [9:0] power_step_10 = power_fall_10[20:11];
    reg [14:0] exp_base_11;
    reg [9:0] power_step_11;
    reg [3:0] i_11;
    reg zero_11;
    always @(posedge clk) begin
        if (ce) begin
            exp_base_11 <= exp_base_10;
            power_step_11 <= power_step_10;
            i_11 <= i_10;
            zero_11 <= zero_10;
        end
    end

    // ===== Stage 11: power
    // UQ0.15: 2^-f
    wire [14:0] power_11 = exp_base_11 - {5'd0, power_step_11};
    reg [14:0] power_12;
    reg [3:0] i_12;
    reg zero_12;
    always @(posedge clk) begin
        if (ce) begin
            power_12 <= power_11;
            i_12 <= i_11;
            zero_12 <= zero_11;
        end
    end

    // ===== Stage 12: power_shifted
    // UQ0.15: 2^-z = 2^-f 2^-i
    wire [14:0] power_shifted_12 = power_12 >> i_12;
    reg [14:0] power_shifted_13;
    reg zero_13;
    always @(posedge clk) begin
        if (ce) begin
            power_shifted_13 <= power_shifted_12;
            zero_13 <= zero_12;
        end
    end

    // ===== Stage 13: y_half, y
    // UQ1.15: plus half an output ulp: the result is rounded to nearest
    wire [15:0] y_half_13 = {1'd0, power_shifted_13} + 16'h0004;
    // UQ1.12: rounded to the output's bits
    wire [12:0] y_cut_13 = y_half_13[15:3];
    // UQ1.12: y, 0 where it is below half an ulp
    wire [12:0] y_13 = zero_13 ? 13'd0 : y_cut_13;
    reg [12:0] y_14;
    always @(posedge clk) begin
        if (ce) begin
            y_14 <= y_13;
        end
    end

    assign out_valid = valid[14];
    assign out_spec  = y_14;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    m_by_8_0[12:4],
                    m_by_4_0[12:8],
                    m_by_2_1[12:10],
                    m_by_1_1[12:11],
                    m_1_2[12],
                    nu_3[19],
                    ratio_fall_4[7:0],
                    vk_6[12:0],
                    power_fall_10[10:0],
                    y_half_13[2:0]};

endmodule

`default_nettype wire
