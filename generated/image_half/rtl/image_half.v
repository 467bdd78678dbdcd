// image_half: image-based block of ggx (half, 16 slices of 32 x 32 texels), 1 light a clock, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec 2d84489c342361ed. Generated; the core is yours to use under any terms.
//
//   in_nx     Q1.16   x of the unit normal, the viewer at +z
//   in_ny     Q1.16   y of the unit normal, the viewer at +z
//   in_nz     Q1.16   z of the unit normal, the viewer at +z
//   in_l1x    Q1.16   x of the unit vector to light 1
//   in_l1y    Q1.16   y of the unit vector to light 1
//   in_l1z    Q1.16   z of the unit vector to light 1
//   in_u1x    Q1.16   x of row 1 of the turn to light 1's half vector
//   in_u1y    Q1.16   y of row 1 of the turn to light 1's half vector
//   in_u1z    Q1.16   z of row 1 of the turn to light 1's half vector
//   in_v1x    Q1.16   x of row 2 of the turn to light 1's half vector
//   in_v1y    Q1.16   y of row 2 of the turn to light 1's half vector
//   in_band1  UQ4.0   slice of texels below light 1's angle
//   in_blend1 UQ1.6   weight of the odd one of this slice and the next, at most 1
//   in_shift1 UQ4.0   exponent of light 1's gain
//   in_gain1r UQ0.18  red of light 1's gain
//   in_gain1g UQ0.18  green of light 1's gain
//   in_gain1b UQ0.18  blue of light 1's gain
//   out_sum_r UQ1.17  red of these lights, at most 1.0
//   out_sum_g UQ1.17  green of these lights, at most 1.0
//   out_sum_b UQ1.17  blue of these lights, at most 1.0
//
// Latency 22 clocks, one result a clock.
// Pictures of a sphere against the exact reflectance, lit from 34 angles:
//   49.9 dB in the mean, 44.7 dB at the worst angle.

`timescale 1ns / 1ps
`default_nettype none

module image_half #(
    // Path of the memory texels_1_even_even_even, read by $readmemh.
    parameter TEXELS_1_EVEN_EVEN_EVEN_FILE = "rom/image_half_texels_1_even_even_even.mem",
    // Path of the memory texels_1_even_even_odd, read by $readmemh.
    parameter TEXELS_1_EVEN_EVEN_ODD_FILE = "rom/image_half_texels_1_even_even_odd.mem",
    // Path of the memory texels_1_even_odd_even, read by $readmemh.
    parameter TEXELS_1_EVEN_ODD_EVEN_FILE = "rom/image_half_texels_1_even_odd_even.mem",
    // Path of the memory texels_1_even_odd_odd, read by $readmemh.
    parameter TEXELS_1_EVEN_ODD_ODD_FILE = "rom/image_half_texels_1_even_odd_odd.mem",
    // Path of the memory texels_1_odd_even_even, read by $readmemh.
    parameter TEXELS_1_ODD_EVEN_EVEN_FILE = "rom/image_half_texels_1_odd_even_even.mem",
    // Path of the memory texels_1_odd_even_odd, read by $readmemh.
    parameter TEXELS_1_ODD_EVEN_ODD_FILE = "rom/image_half_texels_1_odd_even_odd.mem",
    // Path of the memory texels_1_odd_odd_even, read by $readmemh.
    parameter TEXELS_1_ODD_ODD_EVEN_FILE = "rom/image_half_texels_1_odd_odd_even.mem",
    // Path of the memory texels_1_odd_odd_odd, read by $readmemh.
    parameter TEXELS_1_ODD_ODD_ODD_FILE = "rom/image_half_texels_1_odd_odd_odd.mem"
) (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // the other inputs are to be taken
    input  wire        in_valid,
    // Q1.16: x of the unit normal, the viewer at +z
    input  wire [17:0] in_nx,
    // Q1.16: y of the unit normal, the viewer at +z
    input  wire [17:0] in_ny,
    // Q1.16: z of the unit normal, the viewer at +z
    input  wire [17:0] in_nz,
    // Q1.16: x of the unit vector to light 1
    input  wire [17:0] in_l1x,
    // Q1.16: y of the unit vector to light 1
    input  wire [17:0] in_l1y,
    // Q1.16: z of the unit vector to light 1
    input  wire [17:0] in_l1z,
    // Q1.16: x of row 1 of the turn to light 1's half vector
    input  wire [17:0] in_u1x,
    // Q1.16: y of row 1 of the turn to light 1's half vector
    input  wire [17:0] in_u1y,
    // Q1.16: z of row 1 of the turn to light 1's half vector
    input  wire [17:0] in_u1z,
    // Q1.16: x of row 2 of the turn to light 1's half vector
    input  wire [17:0] in_v1x,
    // Q1.16: y of row 2 of the turn to light 1's half vector
    input  wire [17:0] in_v1y,
    // UQ4.0: slice of texels below light 1's angle
    input  wire [3:0] in_band1,
    // UQ1.6: weight of the odd one of this slice and the next, at most 1
    input  wire [6:0] in_blend1,
    // UQ4.0: exponent of light 1's gain
    input  wire [3:0] in_shift1,
    // UQ0.18: red of light 1's gain
    input  wire [17:0] in_gain1r,
    // UQ0.18: green of light 1's gain
    input  wire [17:0] in_gain1g,
    // UQ0.18: blue of light 1's gain
    input  wire [17:0] in_gain1b,
    // the other outputs are a result: in_valid, 22 enabled clocks later
    output wire        out_valid,
    // UQ1.17: red of these lights, at most 1.0
    output wire [17:0] out_sum_r,
    // UQ1.17: green of these lights, at most 1.0
    output wire [17:0] out_sum_g,
    // UQ1.17: blue of these lights, at most 1.0
    output wire [17:0] out_sum_b
);

    // ===== Valid chain
    reg [22:1] valid;
    initial valid = 22'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 22'd0;
        end else if (ce) begin
            valid <= {valid[21:1], in_valid};
        end
    end

    // ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 8 more
    // UQ1.16: n.v, not below 0
    wire [16:0] nz_kept_0 = in_nz[17] ? 17'h00000 : in_nz[16:0];
    // UQ1.0: n.v > 0
    wire seen_0 = |nz_kept_0;
    // UQ1.0: the normal is turned away from the viewer
    wire hidden_0 = ~seen_0;
    // UQ4.0: at most the greatest
    wire [3:0] shift1_0 = (in_shift1 > 4'ha) ? 4'ha : in_shift1;
    // Q3.32: n.l
    wire [35:0] nl1_x_exact_0 = $signed(in_nx) * $signed(in_l1x);
    // Q3.23: rounded down
    wire [26:0] nl1_x_0 = nl1_x_exact_0[35:9];
    // Q3.32: n.l
    wire [35:0] nl1_y_exact_0 = $signed(in_ny) * $signed(in_l1y);
    // Q3.23: rounded down
    wire [26:0] nl1_y_0 = nl1_y_exact_0[35:9];
    // Q3.32: n.l
    wire [35:0] nl1_z_exact_0 = $signed(in_nz) * $signed(in_l1z);
    // Q3.23: rounded down
    wire [26:0] nl1_z_0 = nl1_z_exact_0[35:9];
    // UQ1.6: the weight of the odd band, at most 1
    wire [6:0] blend1_0 = (|in_blend1[6]) ? 7'h40 : in_blend1;
    // UQ5.0: the next
    wire [4:0] band1_next_exact_0 = {1'd0, in_band1} + 5'h01;
    // UQ4.0: at most the last
    wire [3:0] band1_next_0 = (band1_next_exact_0 > 5'h0f) ? 4'hf : band1_next_exact_0[3:0];
    // UQ4.-1: its leading bits
    wire [2:0] band1_even_high_0 = band1_next_0[3:1];
    // UQ3.0: the even one of both
    wire [2:0] band1_even_0 = band1_even_high_0;
    // UQ4.-1: its leading bits
    wire [2:0] band1_odd_high_0 = in_band1[3:1];
    // UQ3.0: the odd one of both
    wire [2:0] band1_odd_0 = band1_odd_high_0;
    // Q3.32: the turned normal
    wire [35:0] v1_x_exact_0 = $signed(in_nx) * $signed(in_v1x);
    // Q3.13: rounded down
    wire [16:0] v1_x_0 = v1_x_exact_0[35:19];
    // Q3.32: the turned normal
    wire [35:0] v1_y_exact_0 = $signed(in_ny) * $signed(in_v1y);
    // Q3.13: rounded down
    wire [16:0] v1_y_0 = v1_y_exact_0[35:19];
    // Q3.32: the turned normal
    wire [35:0] u1_x_exact_0 = $signed(in_nx) * $signed(in_u1x);
    // Q3.13: rounded down
    wire [16:0] u1_x_0 = u1_x_exact_0[35:19];
    // Q3.32: the turned normal
    wire [35:0] u1_y_exact_0 = $signed(in_ny) * $signed(in_u1y);
    // Q3.13: rounded down
    wire [16:0] u1_y_0 = u1_y_exact_0[35:19];
    // Q3.32: the turned normal
    wire [35:0] u1_z_exact_0 = $signed(in_nz) * $signed(in_u1z);
    // Q3.13: rounded down
    wire [16:0] u1_z_0 = u1_z_exact_0[35:19];
    // UQ7.-4: the first of them
    wire [2:0] texels1_00_0 = band1_even_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_00_v2_0 = band1_even_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_01_0 = band1_even_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_01_v2_0 = band1_even_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_10_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_10_v2_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_11_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_11_v2_0 = band1_odd_0;
    // Q1.6: a sign bit for the signed product
    wire [7:0] blend1_signed_0 = {1'd0, blend1_0};
    reg [17:0] in_gain1r_1;
    reg [17:0] in_gain1g_1;
    reg [17:0] in_gain1b_1;
    reg hidden_1;
    reg [3:0] shift1_1;
    reg [26:0] nl1_x_1;
    reg [26:0] nl1_y_1;
    reg [26:0] nl1_z_1;
    reg [16:0] v1_x_1;
    reg [16:0] v1_y_1;
    reg [16:0] u1_x_1;
    reg [16:0] u1_y_1;
    reg [16:0] u1_z_1;
    reg [2:0] texels1_00_1;
    reg [2:0] texels1_00_v2_1;
    reg [2:0] texels1_01_1;
    reg [2:0] texels1_01_v2_1;
    reg [2:0] texels1_10_1;
    reg [2:0] texels1_10_v2_1;
    reg [2:0] texels1_11_1;
    reg [2:0] texels1_11_v2_1;
    reg [7:0] blend1_signed_1;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_1 <= in_gain1r;
            in_gain1g_1 <= in_gain1g;
            in_gain1b_1 <= in_gain1b;
            hidden_1 <= hidden_0;
            shift1_1 <= shift1_0;
            nl1_x_1 <= nl1_x_0;
            nl1_y_1 <= nl1_y_0;
            nl1_z_1 <= nl1_z_0;
            v1_x_1 <= v1_x_0;
            v1_y_1 <= v1_y_0;
            u1_x_1 <= u1_x_0;
            u1_y_1 <= u1_y_0;
            u1_z_1 <= u1_z_0;
            texels1_00_1 <= texels1_00_0;
            texels1_00_v2_1 <= texels1_00_v2_0;
            texels1_01_1 <= texels1_01_0;
            texels1_01_v2_1 <= texels1_01_v2_0;
            texels1_10_1 <= texels1_10_0;
            texels1_10_v2_1 <= texels1_10_v2_0;
            texels1_11_1 <= texels1_11_0;
            texels1_11_v2_1 <= texels1_11_v2_0;
            blend1_signed_1 <= blend1_signed_0;
        end
    end

    // ===== Stage 1: nl1_xy, v1_xy, u1_xy
    // Q4.23: n.l
    wire [27:0] nl1_xy_1 = {{1{nl1_x_1[26]}}, nl1_x_1} + {{1{nl1_y_1[26]}}, nl1_y_1};
    // Q4.13: the turned normal
    wire [17:0] v1_xy_1 = {{1{v1_x_1[16]}}, v1_x_1} + {{1{v1_y_1[16]}}, v1_y_1};
    // Q8.9: in texels from the middle
    wire [17:0] v1_scaled_1 = v1_xy_1;
    // Q4.13: the turned normal
    wire [17:0] u1_xy_1 = {{1{u1_x_1[16]}}, u1_x_1} + {{1{u1_y_1[16]}}, u1_y_1};
    reg [17:0] in_gain1r_2;
    reg [17:0] in_gain1g_2;
    reg [17:0] in_gain1b_2;
    reg hidden_2;
    reg [3:0] shift1_2;
    reg [26:0] nl1_z_2;
    reg [27:0] nl1_xy_2;
    reg [17:0] v1_scaled_2;
    reg [16:0] u1_z_2;
    reg [17:0] u1_xy_2;
    reg [2:0] texels1_00_2;
    reg [2:0] texels1_00_v2_2;
    reg [2:0] texels1_01_2;
    reg [2:0] texels1_01_v2_2;
    reg [2:0] texels1_10_2;
    reg [2:0] texels1_10_v2_2;
    reg [2:0] texels1_11_2;
    reg [2:0] texels1_11_v2_2;
    reg [7:0] blend1_signed_2;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_2 <= in_gain1r_1;
            in_gain1g_2 <= in_gain1g_1;
            in_gain1b_2 <= in_gain1b_1;
            hidden_2 <= hidden_1;
            shift1_2 <= shift1_1;
            nl1_z_2 <= nl1_z_1;
            nl1_xy_2 <= nl1_xy_1;
            v1_scaled_2 <= v1_scaled_1;
            u1_z_2 <= u1_z_1;
            u1_xy_2 <= u1_xy_1;
            texels1_00_2 <= texels1_00_1;
            texels1_00_v2_2 <= texels1_00_v2_1;
            texels1_01_2 <= texels1_01_1;
            texels1_01_v2_2 <= texels1_01_v2_1;
            texels1_10_2 <= texels1_10_1;
            texels1_10_v2_2 <= texels1_10_v2_1;
            texels1_11_2 <= texels1_11_1;
            texels1_11_v2_2 <= texels1_11_v2_1;
            blend1_signed_2 <= blend1_signed_1;
        end
    end

    // ===== Stage 2: nl1_xyz, nl1_kept, v1_place, v1_kept, u1_xyz
    // Q4.23: n.l
    wire [27:0] nl1_xyz_2 = nl1_xy_2 + {{1{nl1_z_2[26]}}, nl1_z_2};
    // Q4.21: rounded down
    wire [25:0] nl1_cut_2 = nl1_xyz_2[27:2];
    // UQ0.21: n.l, kept in [0, 1)
    wire [20:0] nl1_kept_2 =
        nl1_cut_2[25] ? 21'h000000 : (nl1_cut_2 > 26'h01fffff) ? 21'h1fffff : nl1_cut_2[20:0];
    // Q8.9: from the first, plus half a weight's last bit
    wire [17:0] v1_place_2 = v1_scaled_2 + 18'h01f04;
    // Q8.6: rounded to the nearest weight
    wire [14:0] v1_cut_2 = v1_place_2[17:3];
    // UQ5.6: between the outermost centres
    wire [10:0] v1_kept_2 =
        v1_cut_2[14] ? 11'h000 : (v1_cut_2 > 15'h07c0) ? 11'h7c0 : v1_cut_2[10:0];
    // UQ5.0: the texel at or below it
    wire [4:0] v1_texel_2 = v1_kept_2[10:6];
    // UQ0.6: the weight of the next
    wire [5:0] v1_weight_2 = v1_kept_2[5:0];
    // UQ5.-1: its leading bits
    wire [3:0] v1_odd_high_2 = v1_texel_2[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] v1_odd_2 = v1_odd_high_2;
    // UQ1.0: its last bit
    wire v1_is_odd_2 = v1_texel_2[0];
    // UQ1.6: in the wider of two formats
    wire [6:0] v1_weight_wide_2 = {1'd0, v1_weight_2};
    // Q4.13: the turned normal
    wire [17:0] u1_xyz_2 = u1_xy_2 + {{1{u1_z_2[16]}}, u1_z_2};
    // Q8.9: in texels from the middle
    wire [17:0] u1_scaled_2 = u1_xyz_2;
    reg [17:0] in_gain1r_3;
    reg [17:0] in_gain1g_3;
    reg [17:0] in_gain1b_3;
    reg hidden_3;
    reg [3:0] shift1_3;
    reg [20:0] nl1_kept_3;
    reg [4:0] v1_texel_3;
    reg [5:0] v1_weight_3;
    reg [3:0] v1_odd_3;
    reg v1_is_odd_3;
    reg [6:0] v1_weight_wide_3;
    reg [17:0] u1_scaled_3;
    reg [2:0] texels1_00_3;
    reg [2:0] texels1_00_v2_3;
    reg [2:0] texels1_01_3;
    reg [2:0] texels1_01_v2_3;
    reg [2:0] texels1_10_3;
    reg [2:0] texels1_10_v2_3;
    reg [2:0] texels1_11_3;
    reg [2:0] texels1_11_v2_3;
    reg [7:0] blend1_signed_3;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_3 <= in_gain1r_2;
            in_gain1g_3 <= in_gain1g_2;
            in_gain1b_3 <= in_gain1b_2;
            hidden_3 <= hidden_2;
            shift1_3 <= shift1_2;
            nl1_kept_3 <= nl1_kept_2;
            v1_texel_3 <= v1_texel_2;
            v1_weight_3 <= v1_weight_2;
            v1_odd_3 <= v1_odd_2;
            v1_is_odd_3 <= v1_is_odd_2;
            v1_weight_wide_3 <= v1_weight_wide_2;
            u1_scaled_3 <= u1_scaled_2;
            texels1_00_3 <= texels1_00_2;
            texels1_00_v2_3 <= texels1_00_v2_2;
            texels1_01_3 <= texels1_01_2;
            texels1_01_v2_3 <= texels1_01_v2_2;
            texels1_10_3 <= texels1_10_2;
            texels1_10_v2_3 <= texels1_10_v2_2;
            texels1_11_3 <= texels1_11_2;
            texels1_11_v2_3 <= texels1_11_v2_2;
            blend1_signed_3 <= blend1_signed_2;
        end
    end

    // ===== Stage 3: nl1_up, nl1_within, nl1, v1_next_exact, v1_next, v1_other and 7 more
    // UQ10.21: times 2^shift
    wire [30:0] nl1_up_3 = {10'd0, nl1_kept_3} << shift1_3;
    // UQ10.11: rounded down
    wire [20:0] nl1_up_cut_3 = nl1_up_3[30:10];
    // UQ8.11: kept in its format
    wire [18:0] nl1_within_3 = (nl1_up_cut_3 > 21'h07ffff) ? 19'h7ffff : nl1_up_cut_3[18:0];
    // UQ8.11: n.l, 0 for a normal that is turned away
    wire [18:0] nl1_3 = hidden_3 ? 19'd0 : nl1_within_3;
    // UQ6.0: the next
    wire [5:0] v1_next_exact_3 = {1'd0, v1_texel_3} + 6'h01;
    // UQ5.0: at most the last
    wire [4:0] v1_next_3 = (v1_next_exact_3 > 6'h1f) ? 5'h1f : v1_next_exact_3[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] v1_even_high_3 = v1_next_3[4:1];
    // UQ4.0: the even one of both
    wire [3:0] v1_even_3 = v1_even_high_3;
    // UQ1.6: the weight of the place itself
    wire [6:0] v1_other_3 = 7'h40 - {1'd0, v1_weight_3};
    // UQ1.6: the weight of the odd one
    wire [6:0] v1_odd_v2_3 = v1_is_odd_3 ? v1_other_3 : v1_weight_wide_3;
    // Q8.9: from the first, plus half a weight's last bit
    wire [17:0] u1_place_3 = u1_scaled_3 + 18'h01f04;
    // Q8.6: rounded to the nearest weight
    wire [14:0] u1_cut_3 = u1_place_3[17:3];
    // UQ5.6: between the outermost centres
    wire [10:0] u1_kept_3 =
        u1_cut_3[14] ? 11'h000 : (u1_cut_3 > 15'h07c0) ? 11'h7c0 : u1_cut_3[10:0];
    // UQ5.0: the texel at or below it
    wire [4:0] u1_texel_3 = u1_kept_3[10:6];
    // UQ0.6: the weight of the next
    wire [5:0] u1_weight_3 = u1_kept_3[5:0];
    // UQ5.-1: its leading bits
    wire [3:0] u1_odd_high_3 = u1_texel_3[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] u1_odd_3 = u1_odd_high_3;
    // UQ1.0: its last bit
    wire u1_is_odd_3 = u1_texel_3[0];
    // UQ1.6: in the wider of two formats
    wire [6:0] u1_weight_wide_3 = {1'd0, u1_weight_3};
    // UQ7.0: side by side
    wire [6:0] texel1_01_3 = {texels1_01_3, 4'd0} + {3'd0, v1_odd_3};
    // UQ11.-4: the first of them
    wire [6:0] texels1_010_3 = texel1_01_3;
    // UQ7.0: side by side
    wire [6:0] texel1_01_v2_3 = {texels1_01_v2_3, 4'd0} + {3'd0, v1_odd_3};
    // UQ11.-4: the first of them
    wire [6:0] texels1_011_3 = texel1_01_v2_3;
    // UQ7.0: side by side
    wire [6:0] texel1_11_3 = {texels1_11_3, 4'd0} + {3'd0, v1_odd_3};
    // UQ11.-4: the first of them
    wire [6:0] texels1_110_3 = texel1_11_3;
    // UQ7.0: side by side
    wire [6:0] texel1_11_v2_3 = {texels1_11_v2_3, 4'd0} + {3'd0, v1_odd_3};
    // UQ11.-4: the first of them
    wire [6:0] texels1_111_3 = texel1_11_v2_3;
    // Q1.6: a sign bit for the signed product
    wire [7:0] v1_odd_signed_3 = {1'd0, v1_odd_v2_3};
    reg [17:0] in_gain1r_4;
    reg [17:0] in_gain1g_4;
    reg [17:0] in_gain1b_4;
    reg [18:0] nl1_4;
    reg [3:0] v1_even_4;
    reg [4:0] u1_texel_4;
    reg [5:0] u1_weight_4;
    reg [3:0] u1_odd_4;
    reg u1_is_odd_4;
    reg [6:0] u1_weight_wide_4;
    reg [2:0] texels1_00_4;
    reg [2:0] texels1_00_v2_4;
    reg [6:0] texels1_010_4;
    reg [6:0] texels1_011_4;
    reg [2:0] texels1_10_4;
    reg [2:0] texels1_10_v2_4;
    reg [6:0] texels1_110_4;
    reg [6:0] texels1_111_4;
    reg [7:0] v1_odd_signed_4;
    reg [7:0] blend1_signed_4;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_4 <= in_gain1r_3;
            in_gain1g_4 <= in_gain1g_3;
            in_gain1b_4 <= in_gain1b_3;
            nl1_4 <= nl1_3;
            v1_even_4 <= v1_even_3;
            u1_texel_4 <= u1_texel_3;
            u1_weight_4 <= u1_weight_3;
            u1_odd_4 <= u1_odd_3;
            u1_is_odd_4 <= u1_is_odd_3;
            u1_weight_wide_4 <= u1_weight_wide_3;
            texels1_00_4 <= texels1_00_3;
            texels1_00_v2_4 <= texels1_00_v2_3;
            texels1_010_4 <= texels1_010_3;
            texels1_011_4 <= texels1_011_3;
            texels1_10_4 <= texels1_10_3;
            texels1_10_v2_4 <= texels1_10_v2_3;
            texels1_110_4 <= texels1_110_3;
            texels1_111_4 <= texels1_111_3;
            v1_odd_signed_4 <= v1_odd_signed_3;
            blend1_signed_4 <= blend1_signed_3;
        end
    end

    // ===== Stage 4: u1_next_exact, u1_next, u1_other, u1_odd, texel1_00 and 5 more
    // UQ6.0: the next
    wire [5:0] u1_next_exact_4 = {1'd0, u1_texel_4} + 6'h01;
    // UQ5.0: at most the last
    wire [4:0] u1_next_4 = (u1_next_exact_4 > 6'h1f) ? 5'h1f : u1_next_exact_4[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] u1_even_high_4 = u1_next_4[4:1];
    // UQ4.0: the even one of both
    wire [3:0] u1_even_4 = u1_even_high_4;
    // UQ1.6: the weight of the place itself
    wire [6:0] u1_other_4 = 7'h40 - {1'd0, u1_weight_4};
    // UQ1.6: the weight of the odd one
    wire [6:0] u1_odd_v2_4 = u1_is_odd_4 ? u1_other_4 : u1_weight_wide_4;
    // UQ7.0: side by side
    wire [6:0] texel1_00_4 = {texels1_00_4, 4'd0} + {3'd0, v1_even_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_000_4 = texel1_00_4;
    // UQ7.0: side by side
    wire [6:0] texel1_00_v2_4 = {texels1_00_v2_4, 4'd0} + {3'd0, v1_even_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_001_4 = texel1_00_v2_4;
    // UQ11.0: side by side
    wire [10:0] texel1_011_4 = {texels1_011_4, 4'd0} + {7'd0, u1_odd_4};
    // UQ7.0: side by side
    wire [6:0] texel1_10_4 = {texels1_10_4, 4'd0} + {3'd0, v1_even_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_100_4 = texel1_10_4;
    // UQ7.0: side by side
    wire [6:0] texel1_10_v2_4 = {texels1_10_v2_4, 4'd0} + {3'd0, v1_even_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_101_4 = texel1_10_v2_4;
    // UQ11.0: side by side
    wire [10:0] texel1_111_4 = {texels1_111_4, 4'd0} + {7'd0, u1_odd_4};
    // Q1.6: a sign bit for the signed product
    wire [7:0] u1_odd_signed_4 = {1'd0, u1_odd_v2_4};
    reg [17:0] in_gain1r_5;
    reg [17:0] in_gain1g_5;
    reg [17:0] in_gain1b_5;
    reg [18:0] nl1_5;
    reg [3:0] u1_even_5;
    reg [3:0] u1_odd_5;
    reg [6:0] texels1_000_5;
    reg [6:0] texels1_001_5;
    reg [6:0] texels1_010_5;
    reg [10:0] texel1_011_5;
    reg [6:0] texels1_100_5;
    reg [6:0] texels1_101_5;
    reg [6:0] texels1_110_5;
    reg [10:0] texel1_111_5;
    reg [7:0] u1_odd_signed_5;
    reg [7:0] v1_odd_signed_5;
    reg [7:0] blend1_signed_5;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_5 <= in_gain1r_4;
            in_gain1g_5 <= in_gain1g_4;
            in_gain1b_5 <= in_gain1b_4;
            nl1_5 <= nl1_4;
            u1_even_5 <= u1_even_4;
            u1_odd_5 <= u1_odd_4;
            texels1_000_5 <= texels1_000_4;
            texels1_001_5 <= texels1_001_4;
            texels1_010_5 <= texels1_010_4;
            texel1_011_5 <= texel1_011_4;
            texels1_100_5 <= texels1_100_4;
            texels1_101_5 <= texels1_101_4;
            texels1_110_5 <= texels1_110_4;
            texel1_111_5 <= texel1_111_4;
            u1_odd_signed_5 <= u1_odd_signed_4;
            v1_odd_signed_5 <= v1_odd_signed_4;
            blend1_signed_5 <= blend1_signed_4;
        end
    end

    // ===== Stage 5: texel1_000, texel1_001, texel1_010, texel1_100, texel1_101 and 1 more
    // UQ11.0: side by side
    wire [10:0] texel1_000_5 = {texels1_000_5, 4'd0} + {7'd0, u1_even_5};
    // UQ11.0: side by side
    wire [10:0] texel1_001_5 = {texels1_001_5, 4'd0} + {7'd0, u1_odd_5};
    // UQ11.0: side by side
    wire [10:0] texel1_010_5 = {texels1_010_5, 4'd0} + {7'd0, u1_even_5};
    // UQ11.0: side by side
    wire [10:0] texel1_100_5 = {texels1_100_5, 4'd0} + {7'd0, u1_even_5};
    // UQ11.0: side by side
    wire [10:0] texel1_101_5 = {texels1_101_5, 4'd0} + {7'd0, u1_odd_5};
    // UQ11.0: side by side
    wire [10:0] texel1_110_5 = {texels1_110_5, 4'd0} + {7'd0, u1_even_5};
    reg [17:0] in_gain1r_6;
    reg [17:0] in_gain1g_6;
    reg [17:0] in_gain1b_6;
    reg [18:0] nl1_6;
    reg [10:0] texel1_000_6;
    reg [10:0] texel1_001_6;
    reg [10:0] texel1_010_6;
    reg [10:0] texel1_011_6;
    reg [10:0] texel1_100_6;
    reg [10:0] texel1_101_6;
    reg [10:0] texel1_110_6;
    reg [10:0] texel1_111_6;
    reg [7:0] u1_odd_signed_6;
    reg [7:0] v1_odd_signed_6;
    reg [7:0] blend1_signed_6;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_6 <= in_gain1r_5;
            in_gain1g_6 <= in_gain1g_5;
            in_gain1b_6 <= in_gain1b_5;
            nl1_6 <= nl1_5;
            texel1_000_6 <= texel1_000_5;
            texel1_001_6 <= texel1_001_5;
            texel1_010_6 <= texel1_010_5;
            texel1_011_6 <= texel1_011_5;
            texel1_100_6 <= texel1_100_5;
            texel1_101_6 <= texel1_101_5;
            texel1_110_6 <= texel1_110_5;
            texel1_111_6 <= texel1_111_5;
            u1_odd_signed_6 <= u1_odd_signed_5;
            v1_odd_signed_6 <= v1_odd_signed_5;
            blend1_signed_6 <= blend1_signed_5;
        end
    end

    // ===== Stage 6: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    // The word of the memory texels_1_even_even_even, of 2048 words.
    reg [23:0] texels_1_even_even_even_7;
    // The word of the memory texels_1_even_even_odd, of 2048 words.
    reg [23:0] texels_1_even_even_odd_7;
    // The word of the memory texels_1_even_odd_even, of 2048 words.
    reg [23:0] texels_1_even_odd_even_7;
    // The word of the memory texels_1_even_odd_odd, of 2048 words.
    reg [23:0] texels_1_even_odd_odd_7;
    // The word of the memory texels_1_odd_even_even, of 2048 words.
    reg [23:0] texels_1_odd_even_even_7;
    // The word of the memory texels_1_odd_even_odd, of 2048 words.
    reg [23:0] texels_1_odd_even_odd_7;
    // The word of the memory texels_1_odd_odd_even, of 2048 words.
    reg [23:0] texels_1_odd_odd_even_7;
    // The word of the memory texels_1_odd_odd_odd, of 2048 words.
    reg [23:0] texels_1_odd_odd_odd_7;
    reg [23:0] texels_1_even_even_even [0:2047];
    initial $readmemh(TEXELS_1_EVEN_EVEN_EVEN_FILE, texels_1_even_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_even_7 <= texels_1_even_even_even[texel1_000_6];
    end
    reg [23:0] texels_1_even_even_odd [0:2047];
    initial $readmemh(TEXELS_1_EVEN_EVEN_ODD_FILE, texels_1_even_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_odd_7 <= texels_1_even_even_odd[texel1_001_6];
    end
    reg [23:0] texels_1_even_odd_even [0:2047];
    initial $readmemh(TEXELS_1_EVEN_ODD_EVEN_FILE, texels_1_even_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_even_7 <= texels_1_even_odd_even[texel1_010_6];
    end
    reg [23:0] texels_1_even_odd_odd [0:2047];
    initial $readmemh(TEXELS_1_EVEN_ODD_ODD_FILE, texels_1_even_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_odd_7 <= texels_1_even_odd_odd[texel1_011_6];
    end
    reg [23:0] texels_1_odd_even_even [0:2047];
    initial $readmemh(TEXELS_1_ODD_EVEN_EVEN_FILE, texels_1_odd_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_even_7 <= texels_1_odd_even_even[texel1_100_6];
    end
    reg [23:0] texels_1_odd_even_odd [0:2047];
    initial $readmemh(TEXELS_1_ODD_EVEN_ODD_FILE, texels_1_odd_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_odd_7 <= texels_1_odd_even_odd[texel1_101_6];
    end
    reg [23:0] texels_1_odd_odd_even [0:2047];
    initial $readmemh(TEXELS_1_ODD_ODD_EVEN_FILE, texels_1_odd_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_even_7 <= texels_1_odd_odd_even[texel1_110_6];
    end
    reg [23:0] texels_1_odd_odd_odd [0:2047];
    initial $readmemh(TEXELS_1_ODD_ODD_ODD_FILE, texels_1_odd_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_odd_7 <= texels_1_odd_odd_odd[texel1_111_6];
    end
    reg [17:0] in_gain1r_7;
    reg [17:0] in_gain1g_7;
    reg [17:0] in_gain1b_7;
    reg [18:0] nl1_7;
    reg [7:0] u1_odd_signed_7;
    reg [7:0] v1_odd_signed_7;
    reg [7:0] blend1_signed_7;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_7 <= in_gain1r_6;
            in_gain1g_7 <= in_gain1g_6;
            in_gain1b_7 <= in_gain1b_6;
            nl1_7 <= nl1_6;
            u1_odd_signed_7 <= u1_odd_signed_6;
            v1_odd_signed_7 <= v1_odd_signed_6;
            blend1_signed_7 <= blend1_signed_6;
        end
    end

    // ===== Stage 7: registers only
    // UQ0.8: red
    wire [7:0] texels_1_even_even_even_r_7 = texels_1_even_even_even_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_even_odd_r_7 = texels_1_even_even_odd_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_even_r_7 = texels_1_even_odd_even_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_odd_r_7 = texels_1_even_odd_odd_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_even_r_7 = texels_1_odd_even_even_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_odd_r_7 = texels_1_odd_even_odd_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_even_r_7 = texels_1_odd_odd_even_7[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_odd_r_7 = texels_1_odd_odd_odd_7[23:16];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_even_g_7 = texels_1_even_even_even_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_odd_g_7 = texels_1_even_even_odd_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_even_g_7 = texels_1_even_odd_even_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_odd_g_7 = texels_1_even_odd_odd_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_even_g_7 = texels_1_odd_even_even_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_odd_g_7 = texels_1_odd_even_odd_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_even_g_7 = texels_1_odd_odd_even_7[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_odd_g_7 = texels_1_odd_odd_odd_7[15:8];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_even_b_7 = texels_1_even_even_even_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_odd_b_7 = texels_1_even_even_odd_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_even_b_7 = texels_1_even_odd_even_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_odd_b_7 = texels_1_even_odd_odd_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_even_b_7 = texels_1_odd_even_even_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_odd_b_7 = texels_1_odd_even_odd_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_even_b_7 = texels_1_odd_odd_even_7[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_odd_b_7 = texels_1_odd_odd_odd_7[7:0];
    reg [17:0] in_gain1r_8;
    reg [17:0] in_gain1g_8;
    reg [17:0] in_gain1b_8;
    reg [18:0] nl1_8;
    reg [7:0] texels_1_even_even_even_r_8;
    reg [7:0] texels_1_even_even_odd_r_8;
    reg [7:0] texels_1_even_odd_even_r_8;
    reg [7:0] texels_1_even_odd_odd_r_8;
    reg [7:0] texels_1_odd_even_even_r_8;
    reg [7:0] texels_1_odd_even_odd_r_8;
    reg [7:0] texels_1_odd_odd_even_r_8;
    reg [7:0] texels_1_odd_odd_odd_r_8;
    reg [7:0] u1_odd_signed_8;
    reg [7:0] v1_odd_signed_8;
    reg [7:0] blend1_signed_8;
    reg [7:0] texels_1_even_even_even_g_8;
    reg [7:0] texels_1_even_even_odd_g_8;
    reg [7:0] texels_1_even_odd_even_g_8;
    reg [7:0] texels_1_even_odd_odd_g_8;
    reg [7:0] texels_1_odd_even_even_g_8;
    reg [7:0] texels_1_odd_even_odd_g_8;
    reg [7:0] texels_1_odd_odd_even_g_8;
    reg [7:0] texels_1_odd_odd_odd_g_8;
    reg [7:0] texels_1_even_even_even_b_8;
    reg [7:0] texels_1_even_even_odd_b_8;
    reg [7:0] texels_1_even_odd_even_b_8;
    reg [7:0] texels_1_even_odd_odd_b_8;
    reg [7:0] texels_1_odd_even_even_b_8;
    reg [7:0] texels_1_odd_even_odd_b_8;
    reg [7:0] texels_1_odd_odd_even_b_8;
    reg [7:0] texels_1_odd_odd_odd_b_8;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_8 <= in_gain1r_7;
            in_gain1g_8 <= in_gain1g_7;
            in_gain1b_8 <= in_gain1b_7;
            nl1_8 <= nl1_7;
            texels_1_even_even_even_r_8 <= texels_1_even_even_even_r_7;
            texels_1_even_even_odd_r_8 <= texels_1_even_even_odd_r_7;
            texels_1_even_odd_even_r_8 <= texels_1_even_odd_even_r_7;
            texels_1_even_odd_odd_r_8 <= texels_1_even_odd_odd_r_7;
            texels_1_odd_even_even_r_8 <= texels_1_odd_even_even_r_7;
            texels_1_odd_even_odd_r_8 <= texels_1_odd_even_odd_r_7;
            texels_1_odd_odd_even_r_8 <= texels_1_odd_odd_even_r_7;
            texels_1_odd_odd_odd_r_8 <= texels_1_odd_odd_odd_r_7;
            u1_odd_signed_8 <= u1_odd_signed_7;
            v1_odd_signed_8 <= v1_odd_signed_7;
            blend1_signed_8 <= blend1_signed_7;
            texels_1_even_even_even_g_8 <= texels_1_even_even_even_g_7;
            texels_1_even_even_odd_g_8 <= texels_1_even_even_odd_g_7;
            texels_1_even_odd_even_g_8 <= texels_1_even_odd_even_g_7;
            texels_1_even_odd_odd_g_8 <= texels_1_even_odd_odd_g_7;
            texels_1_odd_even_even_g_8 <= texels_1_odd_even_even_g_7;
            texels_1_odd_even_odd_g_8 <= texels_1_odd_even_odd_g_7;
            texels_1_odd_odd_even_g_8 <= texels_1_odd_odd_even_g_7;
            texels_1_odd_odd_odd_g_8 <= texels_1_odd_odd_odd_g_7;
            texels_1_even_even_even_b_8 <= texels_1_even_even_even_b_7;
            texels_1_even_even_odd_b_8 <= texels_1_even_even_odd_b_7;
            texels_1_even_odd_even_b_8 <= texels_1_even_odd_even_b_7;
            texels_1_even_odd_odd_b_8 <= texels_1_even_odd_odd_b_7;
            texels_1_odd_even_even_b_8 <= texels_1_odd_even_even_b_7;
            texels_1_odd_even_odd_b_8 <= texels_1_odd_even_odd_b_7;
            texels_1_odd_odd_even_b_8 <= texels_1_odd_odd_even_b_7;
            texels_1_odd_odd_odd_b_8 <= texels_1_odd_odd_odd_b_7;
        end
    end

    // ===== Stage 8: registers only
    reg [17:0] in_gain1r_9;
    reg [17:0] in_gain1g_9;
    reg [17:0] in_gain1b_9;
    reg [18:0] nl1_9;
    reg [7:0] texels_1_even_even_even_r_9;
    reg [7:0] texels_1_even_even_odd_r_9;
    reg [7:0] texels_1_even_odd_even_r_9;
    reg [7:0] texels_1_even_odd_odd_r_9;
    reg [7:0] texels_1_odd_even_even_r_9;
    reg [7:0] texels_1_odd_even_odd_r_9;
    reg [7:0] texels_1_odd_odd_even_r_9;
    reg [7:0] texels_1_odd_odd_odd_r_9;
    reg [7:0] u1_odd_signed_9;
    reg [7:0] v1_odd_signed_9;
    reg [7:0] blend1_signed_9;
    reg [7:0] texels_1_even_even_even_g_9;
    reg [7:0] texels_1_even_even_odd_g_9;
    reg [7:0] texels_1_even_odd_even_g_9;
    reg [7:0] texels_1_even_odd_odd_g_9;
    reg [7:0] texels_1_odd_even_even_g_9;
    reg [7:0] texels_1_odd_even_odd_g_9;
    reg [7:0] texels_1_odd_odd_even_g_9;
    reg [7:0] texels_1_odd_odd_odd_g_9;
    reg [7:0] texels_1_even_even_even_b_9;
    reg [7:0] texels_1_even_even_odd_b_9;
    reg [7:0] texels_1_even_odd_even_b_9;
    reg [7:0] texels_1_even_odd_odd_b_9;
    reg [7:0] texels_1_odd_even_even_b_9;
    reg [7:0] texels_1_odd_even_odd_b_9;
    reg [7:0] texels_1_odd_odd_even_b_9;
    reg [7:0] texels_1_odd_odd_odd_b_9;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_9 <= in_gain1r_8;
            in_gain1g_9 <= in_gain1g_8;
            in_gain1b_9 <= in_gain1b_8;
            nl1_9 <= nl1_8;
            texels_1_even_even_even_r_9 <= texels_1_even_even_even_r_8;
            texels_1_even_even_odd_r_9 <= texels_1_even_even_odd_r_8;
            texels_1_even_odd_even_r_9 <= texels_1_even_odd_even_r_8;
            texels_1_even_odd_odd_r_9 <= texels_1_even_odd_odd_r_8;
            texels_1_odd_even_even_r_9 <= texels_1_odd_even_even_r_8;
            texels_1_odd_even_odd_r_9 <= texels_1_odd_even_odd_r_8;
            texels_1_odd_odd_even_r_9 <= texels_1_odd_odd_even_r_8;
            texels_1_odd_odd_odd_r_9 <= texels_1_odd_odd_odd_r_8;
            u1_odd_signed_9 <= u1_odd_signed_8;
            v1_odd_signed_9 <= v1_odd_signed_8;
            blend1_signed_9 <= blend1_signed_8;
            texels_1_even_even_even_g_9 <= texels_1_even_even_even_g_8;
            texels_1_even_even_odd_g_9 <= texels_1_even_even_odd_g_8;
            texels_1_even_odd_even_g_9 <= texels_1_even_odd_even_g_8;
            texels_1_even_odd_odd_g_9 <= texels_1_even_odd_odd_g_8;
            texels_1_odd_even_even_g_9 <= texels_1_odd_even_even_g_8;
            texels_1_odd_even_odd_g_9 <= texels_1_odd_even_odd_g_8;
            texels_1_odd_odd_even_g_9 <= texels_1_odd_odd_even_g_8;
            texels_1_odd_odd_odd_g_9 <= texels_1_odd_odd_odd_g_8;
            texels_1_even_even_even_b_9 <= texels_1_even_even_even_b_8;
            texels_1_even_even_odd_b_9 <= texels_1_even_even_odd_b_8;
            texels_1_even_odd_even_b_9 <= texels_1_even_odd_even_b_8;
            texels_1_even_odd_odd_b_9 <= texels_1_even_odd_odd_b_8;
            texels_1_odd_even_even_b_9 <= texels_1_odd_even_even_b_8;
            texels_1_odd_even_odd_b_9 <= texels_1_odd_even_odd_b_8;
            texels_1_odd_odd_even_b_9 <= texels_1_odd_odd_even_b_8;
            texels_1_odd_odd_odd_b_9 <= texels_1_odd_odd_odd_b_8;
        end
    end

    // ===== Stage 9: blend1_r_1_0_apart, blend1_r_1_1_apart, blend1_r_1_2_apart and 9 more
    // Q0.8: the difference
    wire [8:0] blend1_r_1_0_apart_9 =
        {1'd0, texels_1_even_even_odd_r_9} - {1'd0, texels_1_even_even_even_r_9};
    // Q0.8: the difference
    wire [8:0] blend1_r_1_1_apart_9 =
        {1'd0, texels_1_even_odd_odd_r_9} - {1'd0, texels_1_even_odd_even_r_9};
    // Q0.8: the difference
    wire [8:0] blend1_r_1_2_apart_9 =
        {1'd0, texels_1_odd_even_odd_r_9} - {1'd0, texels_1_odd_even_even_r_9};
    // Q0.8: the difference
    wire [8:0] blend1_r_1_3_apart_9 =
        {1'd0, texels_1_odd_odd_odd_r_9} - {1'd0, texels_1_odd_odd_even_r_9};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_0_apart_9 =
        {1'd0, texels_1_even_even_odd_g_9} - {1'd0, texels_1_even_even_even_g_9};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_1_apart_9 =
        {1'd0, texels_1_even_odd_odd_g_9} - {1'd0, texels_1_even_odd_even_g_9};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_2_apart_9 =
        {1'd0, texels_1_odd_even_odd_g_9} - {1'd0, texels_1_odd_even_even_g_9};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_3_apart_9 =
        {1'd0, texels_1_odd_odd_odd_g_9} - {1'd0, texels_1_odd_odd_even_g_9};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_0_apart_9 =
        {1'd0, texels_1_even_even_odd_b_9} - {1'd0, texels_1_even_even_even_b_9};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_1_apart_9 =
        {1'd0, texels_1_even_odd_odd_b_9} - {1'd0, texels_1_even_odd_even_b_9};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_2_apart_9 =
        {1'd0, texels_1_odd_even_odd_b_9} - {1'd0, texels_1_odd_even_even_b_9};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_3_apart_9 =
        {1'd0, texels_1_odd_odd_odd_b_9} - {1'd0, texels_1_odd_odd_even_b_9};
    reg [17:0] in_gain1r_10;
    reg [17:0] in_gain1g_10;
    reg [17:0] in_gain1b_10;
    reg [18:0] nl1_10;
    reg [7:0] texels_1_even_even_even_r_10;
    reg [7:0] texels_1_even_odd_even_r_10;
    reg [7:0] texels_1_odd_even_even_r_10;
    reg [7:0] texels_1_odd_odd_even_r_10;
    reg [8:0] blend1_r_1_0_apart_10;
    reg [7:0] u1_odd_signed_10;
    reg [8:0] blend1_r_1_1_apart_10;
    reg [8:0] blend1_r_1_2_apart_10;
    reg [8:0] blend1_r_1_3_apart_10;
    reg [7:0] v1_odd_signed_10;
    reg [7:0] blend1_signed_10;
    reg [7:0] texels_1_even_even_even_g_10;
    reg [7:0] texels_1_even_odd_even_g_10;
    reg [7:0] texels_1_odd_even_even_g_10;
    reg [7:0] texels_1_odd_odd_even_g_10;
    reg [8:0] blend1_g_1_0_apart_10;
    reg [8:0] blend1_g_1_1_apart_10;
    reg [8:0] blend1_g_1_2_apart_10;
    reg [8:0] blend1_g_1_3_apart_10;
    reg [7:0] texels_1_even_even_even_b_10;
    reg [7:0] texels_1_even_odd_even_b_10;
    reg [7:0] texels_1_odd_even_even_b_10;
    reg [7:0] texels_1_odd_odd_even_b_10;
    reg [8:0] blend1_b_1_0_apart_10;
    reg [8:0] blend1_b_1_1_apart_10;
    reg [8:0] blend1_b_1_2_apart_10;
    reg [8:0] blend1_b_1_3_apart_10;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_10 <= in_gain1r_9;
            in_gain1g_10 <= in_gain1g_9;
            in_gain1b_10 <= in_gain1b_9;
            nl1_10 <= nl1_9;
            texels_1_even_even_even_r_10 <= texels_1_even_even_even_r_9;
            texels_1_even_odd_even_r_10 <= texels_1_even_odd_even_r_9;
            texels_1_odd_even_even_r_10 <= texels_1_odd_even_even_r_9;
            texels_1_odd_odd_even_r_10 <= texels_1_odd_odd_even_r_9;
            blend1_r_1_0_apart_10 <= blend1_r_1_0_apart_9;
            u1_odd_signed_10 <= u1_odd_signed_9;
            blend1_r_1_1_apart_10 <= blend1_r_1_1_apart_9;
            blend1_r_1_2_apart_10 <= blend1_r_1_2_apart_9;
            blend1_r_1_3_apart_10 <= blend1_r_1_3_apart_9;
            v1_odd_signed_10 <= v1_odd_signed_9;
            blend1_signed_10 <= blend1_signed_9;
            texels_1_even_even_even_g_10 <= texels_1_even_even_even_g_9;
            texels_1_even_odd_even_g_10 <= texels_1_even_odd_even_g_9;
            texels_1_odd_even_even_g_10 <= texels_1_odd_even_even_g_9;
            texels_1_odd_odd_even_g_10 <= texels_1_odd_odd_even_g_9;
            blend1_g_1_0_apart_10 <= blend1_g_1_0_apart_9;
            blend1_g_1_1_apart_10 <= blend1_g_1_1_apart_9;
            blend1_g_1_2_apart_10 <= blend1_g_1_2_apart_9;
            blend1_g_1_3_apart_10 <= blend1_g_1_3_apart_9;
            texels_1_even_even_even_b_10 <= texels_1_even_even_even_b_9;
            texels_1_even_odd_even_b_10 <= texels_1_even_odd_even_b_9;
            texels_1_odd_even_even_b_10 <= texels_1_odd_even_even_b_9;
            texels_1_odd_odd_even_b_10 <= texels_1_odd_odd_even_b_9;
            blend1_b_1_0_apart_10 <= blend1_b_1_0_apart_9;
            blend1_b_1_1_apart_10 <= blend1_b_1_1_apart_9;
            blend1_b_1_2_apart_10 <= blend1_b_1_2_apart_9;
            blend1_b_1_3_apart_10 <= blend1_b_1_3_apart_9;
        end
    end

    // ===== Stage 10: blend1_r_1_0_part, blend1_r_1_1_part, blend1_r_1_2_part and 9 more
    // Q2.14: its part
    wire [16:0] blend1_r_1_0_part_10 = $signed(blend1_r_1_0_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_r_1_1_part_10 = $signed(blend1_r_1_1_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_r_1_2_part_10 = $signed(blend1_r_1_2_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_r_1_3_part_10 = $signed(blend1_r_1_3_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_g_1_0_part_10 = $signed(blend1_g_1_0_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_g_1_1_part_10 = $signed(blend1_g_1_1_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_g_1_2_part_10 = $signed(blend1_g_1_2_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_g_1_3_part_10 = $signed(blend1_g_1_3_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_b_1_0_part_10 = $signed(blend1_b_1_0_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_b_1_1_part_10 = $signed(blend1_b_1_1_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_b_1_2_part_10 = $signed(blend1_b_1_2_apart_10) * $signed(u1_odd_signed_10);
    // Q2.14: its part
    wire [16:0] blend1_b_1_3_part_10 = $signed(blend1_b_1_3_apart_10) * $signed(u1_odd_signed_10);
    reg [17:0] in_gain1r_11;
    reg [17:0] in_gain1g_11;
    reg [17:0] in_gain1b_11;
    reg [18:0] nl1_11;
    reg [7:0] texels_1_even_even_even_r_11;
    reg [7:0] texels_1_even_odd_even_r_11;
    reg [7:0] texels_1_odd_even_even_r_11;
    reg [7:0] texels_1_odd_odd_even_r_11;
    reg [16:0] blend1_r_1_0_part_11;
    reg [16:0] blend1_r_1_1_part_11;
    reg [16:0] blend1_r_1_2_part_11;
    reg [16:0] blend1_r_1_3_part_11;
    reg [7:0] v1_odd_signed_11;
    reg [7:0] blend1_signed_11;
    reg [7:0] texels_1_even_even_even_g_11;
    reg [7:0] texels_1_even_odd_even_g_11;
    reg [7:0] texels_1_odd_even_even_g_11;
    reg [7:0] texels_1_odd_odd_even_g_11;
    reg [16:0] blend1_g_1_0_part_11;
    reg [16:0] blend1_g_1_1_part_11;
    reg [16:0] blend1_g_1_2_part_11;
    reg [16:0] blend1_g_1_3_part_11;
    reg [7:0] texels_1_even_even_even_b_11;
    reg [7:0] texels_1_even_odd_even_b_11;
    reg [7:0] texels_1_odd_even_even_b_11;
    reg [7:0] texels_1_odd_odd_even_b_11;
    reg [16:0] blend1_b_1_0_part_11;
    reg [16:0] blend1_b_1_1_part_11;
    reg [16:0] blend1_b_1_2_part_11;
    reg [16:0] blend1_b_1_3_part_11;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_11 <= in_gain1r_10;
            in_gain1g_11 <= in_gain1g_10;
            in_gain1b_11 <= in_gain1b_10;
            nl1_11 <= nl1_10;
            texels_1_even_even_even_r_11 <= texels_1_even_even_even_r_10;
            texels_1_even_odd_even_r_11 <= texels_1_even_odd_even_r_10;
            texels_1_odd_even_even_r_11 <= texels_1_odd_even_even_r_10;
            texels_1_odd_odd_even_r_11 <= texels_1_odd_odd_even_r_10;
            blend1_r_1_0_part_11 <= blend1_r_1_0_part_10;
            blend1_r_1_1_part_11 <= blend1_r_1_1_part_10;
            blend1_r_1_2_part_11 <= blend1_r_1_2_part_10;
            blend1_r_1_3_part_11 <= blend1_r_1_3_part_10;
            v1_odd_signed_11 <= v1_odd_signed_10;
            blend1_signed_11 <= blend1_signed_10;
            texels_1_even_even_even_g_11 <= texels_1_even_even_even_g_10;
            texels_1_even_odd_even_g_11 <= texels_1_even_odd_even_g_10;
            texels_1_odd_even_even_g_11 <= texels_1_odd_even_even_g_10;
            texels_1_odd_odd_even_g_11 <= texels_1_odd_odd_even_g_10;
            blend1_g_1_0_part_11 <= blend1_g_1_0_part_10;
            blend1_g_1_1_part_11 <= blend1_g_1_1_part_10;
            blend1_g_1_2_part_11 <= blend1_g_1_2_part_10;
            blend1_g_1_3_part_11 <= blend1_g_1_3_part_10;
            texels_1_even_even_even_b_11 <= texels_1_even_even_even_b_10;
            texels_1_even_odd_even_b_11 <= texels_1_even_odd_even_b_10;
            texels_1_odd_even_even_b_11 <= texels_1_odd_even_even_b_10;
            texels_1_odd_odd_even_b_11 <= texels_1_odd_odd_even_b_10;
            blend1_b_1_0_part_11 <= blend1_b_1_0_part_10;
            blend1_b_1_1_part_11 <= blend1_b_1_1_part_10;
            blend1_b_1_2_part_11 <= blend1_b_1_2_part_10;
            blend1_b_1_3_part_11 <= blend1_b_1_3_part_10;
        end
    end

    // ===== Stage 11: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 8 more
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_0_11 = {texels_1_even_even_even_r_11, 6'd0} + blend1_r_1_0_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_1_11 = {texels_1_even_odd_even_r_11, 6'd0} + blend1_r_1_1_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_2_11 = {texels_1_odd_even_even_r_11, 6'd0} + blend1_r_1_2_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_3_11 = {texels_1_odd_odd_even_r_11, 6'd0} + blend1_r_1_3_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_0_11 = {texels_1_even_even_even_g_11, 6'd0} + blend1_g_1_0_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_1_11 = {texels_1_even_odd_even_g_11, 6'd0} + blend1_g_1_1_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_2_11 = {texels_1_odd_even_even_g_11, 6'd0} + blend1_g_1_2_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_3_11 = {texels_1_odd_odd_even_g_11, 6'd0} + blend1_g_1_3_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_0_11 = {texels_1_even_even_even_b_11, 6'd0} + blend1_b_1_0_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_1_11 = {texels_1_even_odd_even_b_11, 6'd0} + blend1_b_1_1_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_2_11 = {texels_1_odd_even_even_b_11, 6'd0} + blend1_b_1_2_part_11[13:0];
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_3_11 = {texels_1_odd_odd_even_b_11, 6'd0} + blend1_b_1_3_part_11[13:0];
    reg [17:0] in_gain1r_12;
    reg [17:0] in_gain1g_12;
    reg [17:0] in_gain1b_12;
    reg [18:0] nl1_12;
    reg [13:0] blend1_r_1_0_12;
    reg [13:0] blend1_r_1_1_12;
    reg [13:0] blend1_r_1_2_12;
    reg [13:0] blend1_r_1_3_12;
    reg [7:0] v1_odd_signed_12;
    reg [7:0] blend1_signed_12;
    reg [13:0] blend1_g_1_0_12;
    reg [13:0] blend1_g_1_1_12;
    reg [13:0] blend1_g_1_2_12;
    reg [13:0] blend1_g_1_3_12;
    reg [13:0] blend1_b_1_0_12;
    reg [13:0] blend1_b_1_1_12;
    reg [13:0] blend1_b_1_2_12;
    reg [13:0] blend1_b_1_3_12;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_12 <= in_gain1r_11;
            in_gain1g_12 <= in_gain1g_11;
            in_gain1b_12 <= in_gain1b_11;
            nl1_12 <= nl1_11;
            blend1_r_1_0_12 <= blend1_r_1_0_11;
            blend1_r_1_1_12 <= blend1_r_1_1_11;
            blend1_r_1_2_12 <= blend1_r_1_2_11;
            blend1_r_1_3_12 <= blend1_r_1_3_11;
            v1_odd_signed_12 <= v1_odd_signed_11;
            blend1_signed_12 <= blend1_signed_11;
            blend1_g_1_0_12 <= blend1_g_1_0_11;
            blend1_g_1_1_12 <= blend1_g_1_1_11;
            blend1_g_1_2_12 <= blend1_g_1_2_11;
            blend1_g_1_3_12 <= blend1_g_1_3_11;
            blend1_b_1_0_12 <= blend1_b_1_0_11;
            blend1_b_1_1_12 <= blend1_b_1_1_11;
            blend1_b_1_2_12 <= blend1_b_1_2_11;
            blend1_b_1_3_12 <= blend1_b_1_3_11;
        end
    end

    // ===== Stage 12: blend1_r_2_0_apart, blend1_r_2_1_apart, blend1_g_2_0_apart and 3 more
    // Q0.14: the difference
    wire [14:0] blend1_r_2_0_apart_12 = {1'd0, blend1_r_1_1_12} - {1'd0, blend1_r_1_0_12};
    // Q0.14: the difference
    wire [14:0] blend1_r_2_1_apart_12 = {1'd0, blend1_r_1_3_12} - {1'd0, blend1_r_1_2_12};
    // Q0.14: the difference
    wire [14:0] blend1_g_2_0_apart_12 = {1'd0, blend1_g_1_1_12} - {1'd0, blend1_g_1_0_12};
    // Q0.14: the difference
    wire [14:0] blend1_g_2_1_apart_12 = {1'd0, blend1_g_1_3_12} - {1'd0, blend1_g_1_2_12};
    // Q0.14: the difference
    wire [14:0] blend1_b_2_0_apart_12 = {1'd0, blend1_b_1_1_12} - {1'd0, blend1_b_1_0_12};
    // Q0.14: the difference
    wire [14:0] blend1_b_2_1_apart_12 = {1'd0, blend1_b_1_3_12} - {1'd0, blend1_b_1_2_12};
    reg [17:0] in_gain1r_13;
    reg [17:0] in_gain1g_13;
    reg [17:0] in_gain1b_13;
    reg [18:0] nl1_13;
    reg [13:0] blend1_r_1_0_13;
    reg [13:0] blend1_r_1_2_13;
    reg [14:0] blend1_r_2_0_apart_13;
    reg [7:0] v1_odd_signed_13;
    reg [14:0] blend1_r_2_1_apart_13;
    reg [7:0] blend1_signed_13;
    reg [13:0] blend1_g_1_0_13;
    reg [13:0] blend1_g_1_2_13;
    reg [14:0] blend1_g_2_0_apart_13;
    reg [14:0] blend1_g_2_1_apart_13;
    reg [13:0] blend1_b_1_0_13;
    reg [13:0] blend1_b_1_2_13;
    reg [14:0] blend1_b_2_0_apart_13;
    reg [14:0] blend1_b_2_1_apart_13;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_13 <= in_gain1r_12;
            in_gain1g_13 <= in_gain1g_12;
            in_gain1b_13 <= in_gain1b_12;
            nl1_13 <= nl1_12;
            blend1_r_1_0_13 <= blend1_r_1_0_12;
            blend1_r_1_2_13 <= blend1_r_1_2_12;
            blend1_r_2_0_apart_13 <= blend1_r_2_0_apart_12;
            v1_odd_signed_13 <= v1_odd_signed_12;
            blend1_r_2_1_apart_13 <= blend1_r_2_1_apart_12;
            blend1_signed_13 <= blend1_signed_12;
            blend1_g_1_0_13 <= blend1_g_1_0_12;
            blend1_g_1_2_13 <= blend1_g_1_2_12;
            blend1_g_2_0_apart_13 <= blend1_g_2_0_apart_12;
            blend1_g_2_1_apart_13 <= blend1_g_2_1_apart_12;
            blend1_b_1_0_13 <= blend1_b_1_0_12;
            blend1_b_1_2_13 <= blend1_b_1_2_12;
            blend1_b_2_0_apart_13 <= blend1_b_2_0_apart_12;
            blend1_b_2_1_apart_13 <= blend1_b_2_1_apart_12;
        end
    end

    // ===== Stage 13: blend1_r_2_0_part, blend1_r_2_1_part, blend1_g_2_0_part and 3 more
    // Q2.20: its part
    wire [22:0] blend1_r_2_0_part_13 = $signed(blend1_r_2_0_apart_13) * $signed(v1_odd_signed_13);
    // Q2.20: its part
    wire [22:0] blend1_r_2_1_part_13 = $signed(blend1_r_2_1_apart_13) * $signed(v1_odd_signed_13);
    // Q2.20: its part
    wire [22:0] blend1_g_2_0_part_13 = $signed(blend1_g_2_0_apart_13) * $signed(v1_odd_signed_13);
    // Q2.20: its part
    wire [22:0] blend1_g_2_1_part_13 = $signed(blend1_g_2_1_apart_13) * $signed(v1_odd_signed_13);
    // Q2.20: its part
    wire [22:0] blend1_b_2_0_part_13 = $signed(blend1_b_2_0_apart_13) * $signed(v1_odd_signed_13);
    // Q2.20: its part
    wire [22:0] blend1_b_2_1_part_13 = $signed(blend1_b_2_1_apart_13) * $signed(v1_odd_signed_13);
    reg [17:0] in_gain1r_14;
    reg [17:0] in_gain1g_14;
    reg [17:0] in_gain1b_14;
    reg [18:0] nl1_14;
    reg [13:0] blend1_r_1_0_14;
    reg [13:0] blend1_r_1_2_14;
    reg [22:0] blend1_r_2_0_part_14;
    reg [22:0] blend1_r_2_1_part_14;
    reg [7:0] blend1_signed_14;
    reg [13:0] blend1_g_1_0_14;
    reg [13:0] blend1_g_1_2_14;
    reg [22:0] blend1_g_2_0_part_14;
    reg [22:0] blend1_g_2_1_part_14;
    reg [13:0] blend1_b_1_0_14;
    reg [13:0] blend1_b_1_2_14;
    reg [22:0] blend1_b_2_0_part_14;
    reg [22:0] blend1_b_2_1_part_14;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_14 <= in_gain1r_13;
            in_gain1g_14 <= in_gain1g_13;
            in_gain1b_14 <= in_gain1b_13;
            nl1_14 <= nl1_13;
            blend1_r_1_0_14 <= blend1_r_1_0_13;
            blend1_r_1_2_14 <= blend1_r_1_2_13;
            blend1_r_2_0_part_14 <= blend1_r_2_0_part_13;
            blend1_r_2_1_part_14 <= blend1_r_2_1_part_13;
            blend1_signed_14 <= blend1_signed_13;
            blend1_g_1_0_14 <= blend1_g_1_0_13;
            blend1_g_1_2_14 <= blend1_g_1_2_13;
            blend1_g_2_0_part_14 <= blend1_g_2_0_part_13;
            blend1_g_2_1_part_14 <= blend1_g_2_1_part_13;
            blend1_b_1_0_14 <= blend1_b_1_0_13;
            blend1_b_1_2_14 <= blend1_b_1_2_13;
            blend1_b_2_0_part_14 <= blend1_b_2_0_part_13;
            blend1_b_2_1_part_14 <= blend1_b_2_1_part_13;
        end
    end

    // ===== Stage 14: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    // UQ0.20: two neighbours
    wire [19:0] blend1_r_2_0_14 = {blend1_r_1_0_14, 6'd0} + blend1_r_2_0_part_14[19:0];
    // UQ0.20: two neighbours
    wire [19:0] blend1_r_2_1_14 = {blend1_r_1_2_14, 6'd0} + blend1_r_2_1_part_14[19:0];
    // UQ0.20: two neighbours
    wire [19:0] blend1_g_2_0_14 = {blend1_g_1_0_14, 6'd0} + blend1_g_2_0_part_14[19:0];
    // UQ0.20: two neighbours
    wire [19:0] blend1_g_2_1_14 = {blend1_g_1_2_14, 6'd0} + blend1_g_2_1_part_14[19:0];
    // UQ0.20: two neighbours
    wire [19:0] blend1_b_2_0_14 = {blend1_b_1_0_14, 6'd0} + blend1_b_2_0_part_14[19:0];
    // UQ0.20: two neighbours
    wire [19:0] blend1_b_2_1_14 = {blend1_b_1_2_14, 6'd0} + blend1_b_2_1_part_14[19:0];
    reg [17:0] in_gain1r_15;
    reg [17:0] in_gain1g_15;
    reg [17:0] in_gain1b_15;
    reg [18:0] nl1_15;
    reg [19:0] blend1_r_2_0_15;
    reg [19:0] blend1_r_2_1_15;
    reg [7:0] blend1_signed_15;
    reg [19:0] blend1_g_2_0_15;
    reg [19:0] blend1_g_2_1_15;
    reg [19:0] blend1_b_2_0_15;
    reg [19:0] blend1_b_2_1_15;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_15 <= in_gain1r_14;
            in_gain1g_15 <= in_gain1g_14;
            in_gain1b_15 <= in_gain1b_14;
            nl1_15 <= nl1_14;
            blend1_r_2_0_15 <= blend1_r_2_0_14;
            blend1_r_2_1_15 <= blend1_r_2_1_14;
            blend1_signed_15 <= blend1_signed_14;
            blend1_g_2_0_15 <= blend1_g_2_0_14;
            blend1_g_2_1_15 <= blend1_g_2_1_14;
            blend1_b_2_0_15 <= blend1_b_2_0_14;
            blend1_b_2_1_15 <= blend1_b_2_1_14;
        end
    end

    // ===== Stage 15: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    // Q0.20: the difference
    wire [20:0] blend1_r_3_0_apart_15 = {1'd0, blend1_r_2_1_15} - {1'd0, blend1_r_2_0_15};
    // Q0.20: the difference
    wire [20:0] blend1_g_3_0_apart_15 = {1'd0, blend1_g_2_1_15} - {1'd0, blend1_g_2_0_15};
    // Q0.20: the difference
    wire [20:0] blend1_b_3_0_apart_15 = {1'd0, blend1_b_2_1_15} - {1'd0, blend1_b_2_0_15};
    reg [17:0] in_gain1r_16;
    reg [17:0] in_gain1g_16;
    reg [17:0] in_gain1b_16;
    reg [18:0] nl1_16;
    reg [19:0] blend1_r_2_0_16;
    reg [20:0] blend1_r_3_0_apart_16;
    reg [7:0] blend1_signed_16;
    reg [19:0] blend1_g_2_0_16;
    reg [20:0] blend1_g_3_0_apart_16;
    reg [19:0] blend1_b_2_0_16;
    reg [20:0] blend1_b_3_0_apart_16;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_16 <= in_gain1r_15;
            in_gain1g_16 <= in_gain1g_15;
            in_gain1b_16 <= in_gain1b_15;
            nl1_16 <= nl1_15;
            blend1_r_2_0_16 <= blend1_r_2_0_15;
            blend1_r_3_0_apart_16 <= blend1_r_3_0_apart_15;
            blend1_signed_16 <= blend1_signed_15;
            blend1_g_2_0_16 <= blend1_g_2_0_15;
            blend1_g_3_0_apart_16 <= blend1_g_3_0_apart_15;
            blend1_b_2_0_16 <= blend1_b_2_0_15;
            blend1_b_3_0_apart_16 <= blend1_b_3_0_apart_15;
        end
    end

    // ===== Stage 16: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    // Q2.26: its part
    wire [28:0] blend1_r_3_0_part_16 = $signed(blend1_r_3_0_apart_16) * $signed(blend1_signed_16);
    // Q2.26: its part
    wire [28:0] blend1_g_3_0_part_16 = $signed(blend1_g_3_0_apart_16) * $signed(blend1_signed_16);
    // Q2.26: its part
    wire [28:0] blend1_b_3_0_part_16 = $signed(blend1_b_3_0_apart_16) * $signed(blend1_signed_16);
    reg [17:0] in_gain1r_17;
    reg [17:0] in_gain1g_17;
    reg [17:0] in_gain1b_17;
    reg [18:0] nl1_17;
    reg [19:0] blend1_r_2_0_17;
    reg [28:0] blend1_r_3_0_part_17;
    reg [19:0] blend1_g_2_0_17;
    reg [28:0] blend1_g_3_0_part_17;
    reg [19:0] blend1_b_2_0_17;
    reg [28:0] blend1_b_3_0_part_17;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_17 <= in_gain1r_16;
            in_gain1g_17 <= in_gain1g_16;
            in_gain1b_17 <= in_gain1b_16;
            nl1_17 <= nl1_16;
            blend1_r_2_0_17 <= blend1_r_2_0_16;
            blend1_r_3_0_part_17 <= blend1_r_3_0_part_16;
            blend1_g_2_0_17 <= blend1_g_2_0_16;
            blend1_g_3_0_part_17 <= blend1_g_3_0_part_16;
            blend1_b_2_0_17 <= blend1_b_2_0_16;
            blend1_b_3_0_part_17 <= blend1_b_3_0_part_16;
        end
    end

    // ===== Stage 17: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    // UQ0.26: two bands
    wire [25:0] blend1_r_3_0_17 = {blend1_r_2_0_17, 6'd0} + blend1_r_3_0_part_17[25:0];
    // UQ0.18: the blended code
    wire [17:0] root1_r_17 = blend1_r_3_0_17[25:8];
    // UQ0.26: two bands
    wire [25:0] blend1_g_3_0_17 = {blend1_g_2_0_17, 6'd0} + blend1_g_3_0_part_17[25:0];
    // UQ0.18: the blended code
    wire [17:0] root1_g_17 = blend1_g_3_0_17[25:8];
    // UQ0.26: two bands
    wire [25:0] blend1_b_3_0_17 = {blend1_b_2_0_17, 6'd0} + blend1_b_3_0_part_17[25:0];
    // UQ0.18: the blended code
    wire [17:0] root1_b_17 = blend1_b_3_0_17[25:8];
    reg [17:0] in_gain1r_18;
    reg [17:0] in_gain1g_18;
    reg [17:0] in_gain1b_18;
    reg [18:0] nl1_18;
    reg [17:0] root1_r_18;
    reg [17:0] root1_g_18;
    reg [17:0] root1_b_18;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_18 <= in_gain1r_17;
            in_gain1g_18 <= in_gain1g_17;
            in_gain1b_18 <= in_gain1b_17;
            nl1_18 <= nl1_17;
            root1_r_18 <= root1_r_17;
            root1_g_18 <= root1_g_17;
            root1_b_18 <= root1_b_17;
        end
    end

    // ===== Stage 18: square1_r_exact, square1_g_exact, square1_b_exact
    // UQ0.36: its square
    wire [35:0] square1_r_exact_18 = root1_r_18 * root1_r_18;
    // UQ0.18: rounded down
    wire [17:0] square1_r_18 = square1_r_exact_18[35:18];
    // UQ0.36: its square
    wire [35:0] square1_g_exact_18 = root1_g_18 * root1_g_18;
    // UQ0.18: rounded down
    wire [17:0] square1_g_18 = square1_g_exact_18[35:18];
    // UQ0.36: its square
    wire [35:0] square1_b_exact_18 = root1_b_18 * root1_b_18;
    // UQ0.18: rounded down
    wire [17:0] square1_b_18 = square1_b_exact_18[35:18];
    reg [17:0] in_gain1r_19;
    reg [17:0] in_gain1g_19;
    reg [17:0] in_gain1b_19;
    reg [18:0] nl1_19;
    reg [17:0] square1_r_19;
    reg [17:0] square1_g_19;
    reg [17:0] square1_b_19;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_19 <= in_gain1r_18;
            in_gain1g_19 <= in_gain1g_18;
            in_gain1b_19 <= in_gain1b_18;
            nl1_19 <= nl1_18;
            square1_r_19 <= square1_r_18;
            square1_g_19 <= square1_g_18;
            square1_b_19 <= square1_b_18;
        end
    end

    // ===== Stage 19: lit1_r_exact, lit1_g_exact, lit1_b_exact
    // UQ8.29: n.l times the square
    wire [36:0] lit1_r_exact_19 = nl1_19 * square1_r_19;
    // UQ8.11: rounded down
    wire [18:0] lit1_r_19 = lit1_r_exact_19[36:18];
    // UQ8.29: n.l times the square
    wire [36:0] lit1_g_exact_19 = nl1_19 * square1_g_19;
    // UQ8.11: rounded down
    wire [18:0] lit1_g_19 = lit1_g_exact_19[36:18];
    // UQ8.29: n.l times the square
    wire [36:0] lit1_b_exact_19 = nl1_19 * square1_b_19;
    // UQ8.11: rounded down
    wire [18:0] lit1_b_19 = lit1_b_exact_19[36:18];
    reg [17:0] in_gain1r_20;
    reg [17:0] in_gain1g_20;
    reg [17:0] in_gain1b_20;
    reg [18:0] lit1_r_20;
    reg [18:0] lit1_g_20;
    reg [18:0] lit1_b_20;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_20 <= in_gain1r_19;
            in_gain1g_20 <= in_gain1g_19;
            in_gain1b_20 <= in_gain1b_19;
            lit1_r_20 <= lit1_r_19;
            lit1_g_20 <= lit1_g_19;
            lit1_b_20 <= lit1_b_19;
        end
    end

    // ===== Stage 20: light1_r_exact, light1_g_exact, light1_b_exact
    // UQ8.29: times the gain
    wire [36:0] light1_r_exact_20 = lit1_r_20 * in_gain1r_20;
    // UQ8.17: rounded down
    wire [24:0] light1_r_20 = light1_r_exact_20[36:12];
    // UQ8.29: times the gain
    wire [36:0] light1_g_exact_20 = lit1_g_20 * in_gain1g_20;
    // UQ8.17: rounded down
    wire [24:0] light1_g_20 = light1_g_exact_20[36:12];
    // UQ8.29: times the gain
    wire [36:0] light1_b_exact_20 = lit1_b_20 * in_gain1b_20;
    // UQ8.17: rounded down
    wire [24:0] light1_b_20 = light1_b_exact_20[36:12];
    reg [24:0] light1_r_21;
    reg [24:0] light1_g_21;
    reg [24:0] light1_b_21;
    always @(posedge clk) begin
        if (ce) begin
            light1_r_21 <= light1_r_20;
            light1_g_21 <= light1_g_20;
            light1_b_21 <= light1_b_20;
        end
    end

    // ===== Stage 21: sum_r, sum_g, sum_b
    // UQ1.17: kept at 1.0
    wire [17:0] sum_r_21 = (|light1_r_21[24:17]) ? 18'h20000 : light1_r_21[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_g_21 = (|light1_g_21[24:17]) ? 18'h20000 : light1_g_21[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_b_21 = (|light1_b_21[24:17]) ? 18'h20000 : light1_b_21[17:0];
    reg [17:0] sum_r_22;
    reg [17:0] sum_g_22;
    reg [17:0] sum_b_22;
    always @(posedge clk) begin
        if (ce) begin
            sum_r_22 <= sum_r_21;
            sum_g_22 <= sum_g_21;
            sum_b_22 <= sum_b_21;
        end
    end

    assign out_valid = valid[22];
    assign out_sum_r = sum_r_22;
    assign out_sum_g = sum_g_22;
    assign out_sum_b = sum_b_22;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nl1_x_exact_0[8:0],
                    nl1_y_exact_0[8:0],
                    nl1_z_exact_0[8:0],
                    nl1_xyz_2[1:0],
                    nl1_up_3[9:0],
                    band1_next_0[0],
                    v1_x_exact_0[18:0],
                    v1_y_exact_0[18:0],
                    v1_place_2[2:0],
                    v1_next_3[0],
                    u1_x_exact_0[18:0],
                    u1_y_exact_0[18:0],
                    u1_z_exact_0[18:0],
                    u1_place_3[2:0],
                    u1_next_4[0],
                    blend1_r_1_0_part_11[16:14],
                    blend1_r_1_1_part_11[16:14],
                    blend1_r_1_2_part_11[16:14],
                    blend1_r_1_3_part_11[16:14],
                    blend1_r_2_0_part_14[22:20],
                    blend1_r_2_1_part_14[22:20],
                    blend1_r_3_0_part_17[28:26],
                    blend1_r_3_0_17[7:0],
                    square1_r_exact_18[17:0],
                    lit1_r_exact_19[17:0],
                    light1_r_exact_20[11:0],
                    blend1_g_1_0_part_11[16:14],
                    blend1_g_1_1_part_11[16:14],
                    blend1_g_1_2_part_11[16:14],
                    blend1_g_1_3_part_11[16:14],
                    blend1_g_2_0_part_14[22:20],
                    blend1_g_2_1_part_14[22:20],
                    blend1_g_3_0_part_17[28:26],
                    blend1_g_3_0_17[7:0],
                    square1_g_exact_18[17:0],
                    lit1_g_exact_19[17:0],
                    light1_g_exact_20[11:0],
                    blend1_b_1_0_part_11[16:14],
                    blend1_b_1_1_part_11[16:14],
                    blend1_b_1_2_part_11[16:14],
                    blend1_b_1_3_part_11[16:14],
                    blend1_b_2_0_part_14[22:20],
                    blend1_b_2_1_part_14[22:20],
                    blend1_b_3_0_part_17[28:26],
                    blend1_b_3_0_17[7:0],
                    square1_b_exact_18[17:0],
                    lit1_b_exact_19[17:0],
                    light1_b_exact_20[11:0]};

endmodule

`default_nettype wire
