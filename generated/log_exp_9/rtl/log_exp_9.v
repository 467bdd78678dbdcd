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
// Error against the real-valued method, in ulps of out_spec: proved within -28.488..+28.410.
//   measured -25.000..+22.937 over all 4178175 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.153 % absolute, 0.127 % where x^n >= 1/2, 0.242 % relative there.
// As the cosine rises, the output never falls: proved by running all 4177920 pairs of neighbouring
//   inputs.

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
    // UQ0.7: the bits that select the entry
    wire [6:0] ratio_high_0 = x_0[13:7];
    // UQ7.0: the address in the table
    wire [6:0] ratio_entry_0 = ratio_high_0;
    // UQ1.0: x = 1: the result is 1
    wire top_bits_0 = x_0[14];
    // UQ1.0: n > 1
    wire above_one_0 = n_0 > 8'h01;
    reg [7:0] n_1;
    reg [14:0] x_1;
    reg [14:0] u_1;
    reg dark_bits_1;
    reg [6:0] ratio_entry_1;
    reg top_bits_1;
    reg above_one_1;
    always @(posedge clk) begin
        if (ce) begin
            n_1 <= n_0;
            x_1 <= x_0;
            u_1 <= u_0;
            dark_bits_1 <= dark_bits_0;
            ratio_entry_1 <= ratio_entry_0;
            top_bits_1 <= top_bits_0;
            above_one_1 <= above_one_0;
        end
    end

    // ===== Stage 1: read log_table, nu
    // The word of the memory log_table, of 128 words.
    reg [11:0] log_table_2;
    // UQ9.14: n u
    wire [22:0] nu_1 = n_1 * u_1;
    // UQ8.-3: so large that z is past what the result can show
    wire [4:0] beyond_bits_1 = nu_1[21:17];
    // UQ3.11: v = n u, rounded down
    wire [13:0] v_1 = nu_1[16:3];
    always @(posedge clk) begin
        if (ce) begin
            case (ratio_entry_1)
                7'd0: log_table_2 <= 12'he86;
                7'd1: log_table_2 <= 12'hc96;
                7'd2: log_table_2 <= 12'hb70;
                7'd3: log_table_2 <= 12'ha9b;
                7'd4: log_table_2 <= 12'h9f8;
                7'd5: log_table_2 <= 12'h976;
                7'd6: log_table_2 <= 12'h90a;
                7'd7: log_table_2 <= 12'h8ae;
                7'd8: log_table_2 <= 12'h85f;
                7'd9: log_table_2 <= 12'h819;
                7'd10: log_table_2 <= 12'h7da;
                7'd11: log_table_2 <= 12'h7a2;
                7'd12: log_table_2 <= 12'h76f;
                7'd13: log_table_2 <= 12'h740;
                7'd14: log_table_2 <= 12'h715;
                7'd15: log_table_2 <= 12'h6ee;
                7'd16: log_table_2 <= 12'h6c9;
                7'd17: log_table_2 <= 12'h6a6;
                7'd18: log_table_2 <= 12'h686;
                7'd19: log_table_2 <= 12'h667;
                7'd20: log_table_2 <= 12'h64b;
                7'd21: log_table_2 <= 12'h62f;
                7'd22: log_table_2 <= 12'h616;
                7'd23: log_table_2 <= 12'h5fd;
                7'd24: log_table_2 <= 12'h5e6;
                7'd25: log_table_2 <= 12'h5d0;
                7'd26: log_table_2 <= 12'h5bb;
                7'd27: log_table_2 <= 12'h5a7;
                7'd28: log_table_2 <= 12'h593;
                7'd29: log_table_2 <= 12'h581;
                7'd30: log_table_2 <= 12'h56f;
                7'd31: log_table_2 <= 12'h55e;
                7'd32: log_table_2 <= 12'h54d;
                7'd33: log_table_2 <= 12'h53d;
                7'd34: log_table_2 <= 12'h52e;
                7'd35: log_table_2 <= 12'h51f;
                7'd36: log_table_2 <= 12'h510;
                7'd37: log_table_2 <= 12'h503;
                7'd38: log_table_2 <= 12'h4f5;
                7'd39: log_table_2 <= 12'h4e8;
                7'd40: log_table_2 <= 12'h4db;
                7'd41: log_table_2 <= 12'h4cf;
                7'd42: log_table_2 <= 12'h4c3;
                7'd43: log_table_2 <= 12'h4b8;
                7'd44: log_table_2 <= 12'h4ac;
                7'd45: log_table_2 <= 12'h4a1;
                7'd46: log_table_2 <= 12'h497;
                7'd47: log_table_2 <= 12'h48c;
                7'd48: log_table_2 <= 12'h482;
                7'd49: log_table_2 <= 12'h478;
                7'd50: log_table_2 <= 12'h46f;
                7'd51: log_table_2 <= 12'h465;
                7'd52: log_table_2 <= 12'h45c;
                7'd53: log_table_2 <= 12'h453;
                7'd54: log_table_2 <= 12'h44a;
                7'd55: log_table_2 <= 12'h442;
                7'd56: log_table_2 <= 12'h439;
                7'd57: log_table_2 <= 12'h431;
                7'd58: log_table_2 <= 12'h429;
                7'd59: log_table_2 <= 12'h421;
                7'd60: log_table_2 <= 12'h41a;
                7'd61: log_table_2 <= 12'h412;
                7'd62: log_table_2 <= 12'h40b;
                7'd63: log_table_2 <= 12'h404;
                7'd64: log_table_2 <= 12'h3fc;
                7'd65: log_table_2 <= 12'h3f6;
                7'd66: log_table_2 <= 12'h3ef;
                7'd67: log_table_2 <= 12'h3e8;
                7'd68: log_table_2 <= 12'h3e1;
                7'd69: log_table_2 <= 12'h3db;
                7'd70: log_table_2 <= 12'h3d5;
                7'd71: log_table_2 <= 12'h3cf;
                7'd72: log_table_2 <= 12'h3c8;
                7'd73: log_table_2 <= 12'h3c2;
                7'd74: log_table_2 <= 12'h3bd;
                7'd75: log_table_2 <= 12'h3b7;
                7'd76: log_table_2 <= 12'h3b1;
                7'd77: log_table_2 <= 12'h3ab;
                7'd78: log_table_2 <= 12'h3a6;
                7'd79: log_table_2 <= 12'h3a0;
                7'd80: log_table_2 <= 12'h39b;
                7'd81: log_table_2 <= 12'h396;
                7'd82: log_table_2 <= 12'h391;
                7'd83: log_table_2 <= 12'h38c;
                7'd84: log_table_2 <= 12'h387;
                7'd85: log_table_2 <= 12'h382;
                7'd86: log_table_2 <= 12'h37d;
                7'd87: log_table_2 <= 12'h378;
                7'd88: log_table_2 <= 12'h373;
                7'd89: log_table_2 <= 12'h36f;
                7'd90: log_table_2 <= 12'h36a;
                7'd91: log_table_2 <= 12'h366;
                7'd92: log_table_2 <= 12'h361;
                7'd93: log_table_2 <= 12'h35d;
                7'd94: log_table_2 <= 12'h358;
                7'd95: log_table_2 <= 12'h354;
                7'd96: log_table_2 <= 12'h350;
                7'd97: log_table_2 <= 12'h34c;
                7'd98: log_table_2 <= 12'h348;
                7'd99: log_table_2 <= 12'h344;
                7'd100: log_table_2 <= 12'h340;
                7'd101: log_table_2 <= 12'h33c;
                7'd102: log_table_2 <= 12'h338;
                7'd103: log_table_2 <= 12'h334;
                7'd104: log_table_2 <= 12'h330;
                7'd105: log_table_2 <= 12'h32c;
                7'd106: log_table_2 <= 12'h329;
                7'd107: log_table_2 <= 12'h325;
                7'd108: log_table_2 <= 12'h321;
                7'd109: log_table_2 <= 12'h31e;
                7'd110: log_table_2 <= 12'h31a;
                7'd111: log_table_2 <= 12'h317;
                7'd112: log_table_2 <= 12'h313;
                7'd113: log_table_2 <= 12'h310;
                7'd114: log_table_2 <= 12'h30d;
                7'd115: log_table_2 <= 12'h309;
                7'd116: log_table_2 <= 12'h306;
                7'd117: log_table_2 <= 12'h303;
                7'd118: log_table_2 <= 12'h300;
                7'd119: log_table_2 <= 12'h2fc;
                7'd120: log_table_2 <= 12'h2f9;
                7'd121: log_table_2 <= 12'h2f6;
                7'd122: log_table_2 <= 12'h2f3;
                7'd123: log_table_2 <= 12'h2f0;
                7'd124: log_table_2 <= 12'h2ed;
                7'd125: log_table_2 <= 12'h2ea;
                7'd126: log_table_2 <= 12'h2e7;
                7'd127: log_table_2 <= 12'h2e4;
                default: log_table_2 <= 12'he86;
            endcase
        end
    end
    reg [14:0] x_2;
    reg dark_bits_2;
    reg [4:0] beyond_bits_2;
    reg [13:0] v_2;
    reg top_bits_2;
    reg above_one_2;
    always @(posedge clk) begin
        if (ce) begin
            x_2 <= x_1;
            dark_bits_2 <= dark_bits_1;
            beyond_bits_2 <= beyond_bits_1;
            v_2 <= v_1;
            top_bits_2 <= top_bits_1;
            above_one_2 <= above_one_1;
        end
    end

    // ===== Stage 2: registers only
    // UQ1.0: so large that z is past what the result can show
    wire beyond_2 = |beyond_bits_2;
    // UQ3.9: log ratio at the entry's start
    wire [11:0] log_base_2 = log_table_2;
    // UQ1.0: the result is 0
    wire zero_of_2_2 = dark_bits_2 | beyond_2;
    reg [14:0] x_3;
    reg [13:0] v_3;
    reg [11:0] log_base_3;
    reg zero_of_2_3;
    reg top_bits_3;
    reg above_one_3;
    always @(posedge clk) begin
        if (ce) begin
            x_3 <= x_2;
            v_3 <= v_2;
            log_base_3 <= log_base_2;
            zero_of_2_3 <= zero_of_2_2;
            top_bits_3 <= top_bits_2;
            above_one_3 <= above_one_2;
        end
    end

    // ===== Stage 3: registers only
    reg [14:0] x_4;
    reg [13:0] v_4;
    reg [11:0] log_base_4;
    reg zero_of_2_4;
    reg top_bits_4;
    reg above_one_4;
    always @(posedge clk) begin
        if (ce) begin
            x_4 <= x_3;
            v_4 <= v_3;
            log_base_4 <= log_base_3;
            zero_of_2_4 <= zero_of_2_3;
            top_bits_4 <= top_bits_3;
            above_one_4 <= above_one_3;
        end
    end

    // ===== Stage 4: vk
    // UQ6.20: v k
    wire [25:0] vk_4 = v_4 * log_base_4;
    // UQ6.10: z = n L, rounded down
    wire [15:0] z_4 = vk_4[25:10];
    // UQ6.-4: z is past what the result can show
    wire [1:0] over_bits_4 = z_4[15:14];
    // UQ0.5: the bits that select the entry
    wire [4:0] power_high_4 = z_4[9:5];
    // UQ5.0: the address in the table
    wire [4:0] power_entry_4 = power_high_4;
    // UQ-5.10: the distance from the entry's start
    wire [4:0] power_d_4 = z_4[4:0];
    // UQ-10.15: shifted
    wire [4:0] power_fall_by_0_4 = power_d_4;
    // UQ-9.14: shifted
    wire [4:0] power_fall_by_1_4 = power_d_4;
    // UQ-8.13: shifted
    wire [4:0] power_fall_by_2_4 = power_d_4;
    // UQ-7.12: shifted
    wire [4:0] power_fall_by_3_4 = power_d_4;
    // UQ-6.11: shifted
    wire [4:0] power_fall_by_4_4 = power_d_4;
    // UQ4.0: the integer part of z
    wire [3:0] i_4 = z_4[13:10];
    reg [14:0] x_5;
    reg [1:0] over_bits_5;
    reg [4:0] power_entry_5;
    reg [4:0] power_fall_by_0_5;
    reg [4:0] power_fall_by_1_5;
    reg [4:0] power_fall_by_2_5;
    reg [4:0] power_fall_by_3_5;
    reg [4:0] power_fall_by_4_5;
    reg [3:0] i_5;
    reg zero_of_2_5;
    reg top_bits_5;
    reg above_one_5;
    always @(posedge clk) begin
        if (ce) begin
            x_5 <= x_4;
            over_bits_5 <= over_bits_4;
            power_entry_5 <= power_entry_4;
            power_fall_by_0_5 <= power_fall_by_0_4;
            power_fall_by_1_5 <= power_fall_by_1_4;
            power_fall_by_2_5 <= power_fall_by_2_4;
            power_fall_by_3_5 <= power_fall_by_3_4;
            power_fall_by_4_5 <= power_fall_by_4_4;
            i_5 <= i_4;
            zero_of_2_5 <= zero_of_2_4;
            top_bits_5 <= top_bits_4;
            above_one_5 <= above_one_4;
        end
    end

    // ===== Stage 5: read exp_table
    // The word of the memory exp_table, of 32 words.
    reg [17:0] exp_table_6;
    // UQ1.0: z is past what the result can show
    wire over_5 = |over_bits_5;
    // UQ1.0: the result is 0
    wire zero_5 = zero_of_2_5 | over_5;
    always @(posedge clk) begin
        if (ce) begin
            case (power_entry_5)
                5'd0: exp_table_6 <= 18'h3ff76;
                5'd1: exp_table_6 <= 18'h3e955;
                5'd2: exp_table_6 <= 18'h3d415;
                5'd3: exp_table_6 <= 18'h3bf55;
                5'd4: exp_table_6 <= 18'h3aa74;
                5'd5: exp_table_6 <= 18'h39694;
                5'd6: exp_table_6 <= 18'h38293;
                5'd7: exp_table_6 <= 18'h36f93;
                5'd8: exp_table_6 <= 18'h35c72;
                5'd9: exp_table_6 <= 18'h34a32;
                5'd10: exp_table_6 <= 18'h33852;
                5'd11: exp_table_6 <= 18'h32651;
                5'd12: exp_table_6 <= 18'h31531;
                5'd13: exp_table_6 <= 18'h30471;
                5'd14: exp_table_6 <= 18'h2f3b0;
                5'd15: exp_table_6 <= 18'h2e390;
                5'd16: exp_table_6 <= 18'h2d3f0;
                5'd17: exp_table_6 <= 18'h2c40f;
                5'd18: exp_table_6 <= 18'h2b50f;
                5'd19: exp_table_6 <= 18'h2a66f;
                5'd20: exp_table_6 <= 18'h2978e;
                5'd21: exp_table_6 <= 18'h2896e;
                5'd22: exp_table_6 <= 18'h27bae;
                5'd23: exp_table_6 <= 18'h26dad;
                5'd24: exp_table_6 <= 18'h2608d;
                5'd25: exp_table_6 <= 18'h253ad;
                5'd26: exp_table_6 <= 18'h2468c;
                5'd27: exp_table_6 <= 18'h23a2c;
                5'd28: exp_table_6 <= 18'h22e0c;
                5'd29: exp_table_6 <= 18'h2222c;
                5'd30: exp_table_6 <= 18'h2162b;
                5'd31: exp_table_6 <= 18'h20acb;
                default: exp_table_6 <= 18'h3ff76;
            endcase
        end
    end
    reg [14:0] x_6;
    reg [4:0] power_fall_by_0_6;
    reg [4:0] power_fall_by_1_6;
    reg [4:0] power_fall_by_2_6;
    reg [4:0] power_fall_by_3_6;
    reg [4:0] power_fall_by_4_6;
    reg [3:0] i_6;
    reg zero_6;
    reg top_bits_6;
    reg above_one_6;
    always @(posedge clk) begin
        if (ce) begin
            x_6 <= x_5;
            power_fall_by_0_6 <= power_fall_by_0_5;
            power_fall_by_1_6 <= power_fall_by_1_5;
            power_fall_by_2_6 <= power_fall_by_2_5;
            power_fall_by_3_6 <= power_fall_by_3_5;
            power_fall_by_4_6 <= power_fall_by_4_5;
            i_6 <= i_5;
            zero_6 <= zero_5;
            top_bits_6 <= top_bits_5;
            above_one_6 <= above_one_5;
        end
    end

    // ===== Stage 6: registers only
    // UQ0.13: 2^-f at the entry's start
    wire [12:0] exp_base_6 = exp_table_6[17:5];
    // UQ0.5: how steeply 2^-f falls
    wire [4:0] exp_slope_6 = exp_table_6[4:0];
    reg [14:0] x_7;
    reg [12:0] exp_base_7;
    reg [4:0] exp_slope_7;
    reg [4:0] power_fall_by_0_7;
    reg [4:0] power_fall_by_1_7;
    reg [4:0] power_fall_by_2_7;
    reg [4:0] power_fall_by_3_7;
    reg [4:0] power_fall_by_4_7;
    reg [3:0] i_7;
    reg zero_7;
    reg top_bits_7;
    reg above_one_7;
    always @(posedge clk) begin
        if (ce) begin
            x_7 <= x_6;
            exp_base_7 <= exp_base_6;
            exp_slope_7 <= exp_slope_6;
            power_fall_by_0_7 <= power_fall_by_0_6;
            power_fall_by_1_7 <= power_fall_by_1_6;
            power_fall_by_2_7 <= power_fall_by_2_6;
            power_fall_by_3_7 <= power_fall_by_3_6;
            power_fall_by_4_7 <= power_fall_by_4_6;
            i_7 <= i_6;
            zero_7 <= zero_6;
            top_bits_7 <= top_bits_6;
            above_one_7 <= above_one_6;
        end
    end

    // ===== Stage 7: power_fall_term_0, power_fall_term_1, power_fall_to_1 and 3 more
    // UQ-4.5: a bit of the slope
    wire power_fall_bit_0_7 = exp_slope_7[0];
    // UQ1.0: the bit is 0
    wire power_fall_without_0_7 = ~power_fall_bit_0_7;
    // UQ-10.15: 0 where the bit is 0
    wire [4:0] power_fall_term_0_7 = power_fall_without_0_7 ? 5'd0 : power_fall_by_0_7;
    // UQ-3.4: a bit of the slope
    wire power_fall_bit_1_7 = exp_slope_7[1];
    // UQ1.0: the bit is 0
    wire power_fall_without_1_7 = ~power_fall_bit_1_7;
    // UQ-9.14: 0 where the bit is 0
    wire [4:0] power_fall_term_1_7 = power_fall_without_1_7 ? 5'd0 : power_fall_by_1_7;
    // UQ-8.15: how far the value has fallen from the entry's start
    wire [6:0] power_fall_to_1_7 = {2'd0, power_fall_term_0_7} + {1'd0, power_fall_term_1_7, 1'd0};
    // UQ-2.3: a bit of the slope
    wire power_fall_bit_2_7 = exp_slope_7[2];
    // UQ1.0: the bit is 0
    wire power_fall_without_2_7 = ~power_fall_bit_2_7;
    // UQ-8.13: 0 where the bit is 0
    wire [4:0] power_fall_term_2_7 = power_fall_without_2_7 ? 5'd0 : power_fall_by_2_7;
    // UQ-1.2: a bit of the slope
    wire power_fall_bit_3_7 = exp_slope_7[3];
    // UQ1.0: the bit is 0
    wire power_fall_without_3_7 = ~power_fall_bit_3_7;
    // UQ-7.12: 0 where the bit is 0
    wire [4:0] power_fall_term_3_7 = power_fall_without_3_7 ? 5'd0 : power_fall_by_3_7;
    // UQ0.1: a bit of the slope
    wire power_fall_bit_4_7 = exp_slope_7[4];
    // UQ1.0: the bit is 0
    wire power_fall_without_4_7 = ~power_fall_bit_4_7;
    // UQ-6.11: 0 where the bit is 0
    wire [4:0] power_fall_term_4_7 = power_fall_without_4_7 ? 5'd0 : power_fall_by_4_7;
    reg [14:0] x_8;
    reg [12:0] exp_base_8;
    reg [6:0] power_fall_to_1_8;
    reg [4:0] power_fall_term_2_8;
    reg [4:0] power_fall_term_3_8;
    reg [4:0] power_fall_term_4_8;
    reg [3:0] i_8;
    reg zero_8;
    reg top_bits_8;
    reg above_one_8;
    always @(posedge clk) begin
        if (ce) begin
            x_8 <= x_7;
            exp_base_8 <= exp_base_7;
            power_fall_to_1_8 <= power_fall_to_1_7;
            power_fall_term_2_8 <= power_fall_term_2_7;
            power_fall_term_3_8 <= power_fall_term_3_7;
            power_fall_term_4_8 <= power_fall_term_4_7;
            i_8 <= i_7;
            zero_8 <= zero_7;
            top_bits_8 <= top_bits_7;
            above_one_8 <= above_one_7;
        end
    end

    // ===== Stage 8: power_fall_to_2, power_fall_to_3
    // UQ-7.15: how far the value has fallen from the entry's start
    wire [7:0] power_fall_to_2_8 = {1'd0, power_fall_to_1_8} + {1'd0, power_fall_term_2_8, 2'd0};
    // UQ-6.15: how far the value has fallen from the entry's start
    wire [8:0] power_fall_to_3_8 = {1'd0, power_fall_to_2_8} + {1'd0, power_fall_term_3_8, 3'd0};
    reg [14:0] x_9;
    reg [12:0] exp_base_9;
    reg [8:0] power_fall_to_3_9;
    reg [4:0] power_fall_term_4_9;
    reg [3:0] i_9;
    reg zero_9;
    reg top_bits_9;
    reg above_one_9;
    always @(posedge clk) begin
        if (ce) begin
            x_9 <= x_8;
            exp_base_9 <= exp_base_8;
            power_fall_to_3_9 <= power_fall_to_3_8;
            power_fall_term_4_9 <= power_fall_term_4_8;
            i_9 <= i_8;
            zero_9 <= zero_8;
            top_bits_9 <= top_bits_8;
            above_one_9 <= above_one_8;
        end
    end

    // ===== Stage 9: power_fall_to_4, power
    // UQ-5.15: how far the value has fallen from the entry's start
    wire [9:0] power_fall_to_4_9 = {1'd0, power_fall_to_3_9} + {1'd0, power_fall_term_4_9, 4'd0};
    // UQ-5.13: rounded down
    wire [7:0] power_step_9 = power_fall_to_4_9[9:2];
    // UQ0.13: 2^-f
    wire [12:0] power_9 = exp_base_9 - {5'd0, power_step_9};
    reg [14:0] x_10;
    reg [12:0] power_10;
    reg [3:0] i_10;
    reg zero_10;
    reg top_bits_10;
    reg above_one_10;
    always @(posedge clk) begin
        if (ce) begin
            x_10 <= x_9;
            power_10 <= power_9;
            i_10 <= i_9;
            zero_10 <= zero_9;
            top_bits_10 <= top_bits_9;
            above_one_10 <= above_one_9;
        end
    end

    // ===== Stage 10: power_shifted, y, y_lit
    // UQ0.13: 2^-z = 2^-f 2^-i
    wire [12:0] power_shifted_10 = power_10 >> i_10;
    // UQ0.14: the output's bits
    wire [13:0] y_cut_10 = {power_shifted_10, 1'd0};
    // UQ0.14: y, 0 where it is past what the result can show
    wire [13:0] y_10 = zero_10 ? 14'd0 : y_cut_10;
    // UQ1.14: y, 1 at x = 1
    wire [14:0] y_lit_10 = top_bits_10 ? 15'h4000 : {1'd0, y_10};
    reg [14:0] x_11;
    reg [14:0] y_lit_11;
    reg above_one_11;
    always @(posedge clk) begin
        if (ce) begin
            x_11 <= x_10;
            y_lit_11 <= y_lit_10;
            above_one_11 <= above_one_10;
        end
    end

    // ===== Stage 11: y_or_x
    // UQ1.14: x itself for n = 1
    wire [14:0] y_or_x_11 = above_one_11 ? y_lit_11 : x_11;
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
                    vk_4[9:0],
                    power_fall_to_4_9[1:0]};

endmodule

`default_nettype wire
