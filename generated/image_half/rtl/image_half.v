// image_half: image-based block of ggx (half, 16 slices of 32 x 32 texels), 1 light a clock, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec c91e1a366b8521bb. Generated; the core is yours to use under any terms.
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
//   in_blend1 UQ1.5   weight of the odd one of this slice and the next, at most 1
//   in_shift1 UQ4.0   exponent of light 1's gain
//   in_gain1r UQ1.17  red of light 1's gain
//   in_gain1g UQ1.17  green of light 1's gain
//   in_gain1b UQ1.17  blue of light 1's gain
//   out_sum_r UQ1.17  red of these lights, at most 1.0
//   out_sum_g UQ1.17  green of these lights, at most 1.0
//   out_sum_b UQ1.17  blue of these lights, at most 1.0
//
// Latency 27 clocks, one result a clock.
// Pictures of a sphere against the exact reflectance, lit from 34 angles:
//   49.9 dB in the mean, 44.4 dB at the worst angle.

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
    // UQ1.5: weight of the odd one of this slice and the next, at most 1
    input  wire [5:0] in_blend1,
    // UQ4.0: exponent of light 1's gain
    input  wire [3:0] in_shift1,
    // UQ1.17: red of light 1's gain
    input  wire [17:0] in_gain1r,
    // UQ1.17: green of light 1's gain
    input  wire [17:0] in_gain1g,
    // UQ1.17: blue of light 1's gain
    input  wire [17:0] in_gain1b,
    // the other outputs are a result: in_valid, 27 enabled clocks later
    output wire        out_valid,
    // UQ1.17: red of these lights, at most 1.0
    output wire [17:0] out_sum_r,
    // UQ1.17: green of these lights, at most 1.0
    output wire [17:0] out_sum_g,
    // UQ1.17: blue of these lights, at most 1.0
    output wire [17:0] out_sum_b
);

    // ===== Valid chain
    reg [27:1] valid;
    initial valid = 27'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 27'd0;
        end else if (ce) begin
            valid <= {valid[26:1], in_valid};
        end
    end

    // ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 7 more
    // UQ1.16: n.v, not below 0
    wire [16:0] nz_kept_0 = in_nz[17] ? 17'h00000 : in_nz[16:0];
    // UQ1.0: n.v > 0
    wire seen_0 = |nz_kept_0;
    // UQ1.0: the normal is turned away from the viewer
    wire hidden_0 = ~seen_0;
    // UQ4.0: at most the greatest
    wire [3:0] shift1_0 = (in_shift1 > 4'h9) ? 4'h9 : in_shift1;
    // Q3.32: n.l
    wire [35:0] nl1_x_exact_0 = $signed(in_nx) * $signed(in_l1x);
    // Q3.22: rounded down
    wire [25:0] nl1_x_0 = nl1_x_exact_0[35:10];
    // Q3.32: n.l
    wire [35:0] nl1_y_exact_0 = $signed(in_ny) * $signed(in_l1y);
    // Q3.22: rounded down
    wire [25:0] nl1_y_0 = nl1_y_exact_0[35:10];
    // Q3.32: n.l
    wire [35:0] nl1_z_exact_0 = $signed(in_nz) * $signed(in_l1z);
    // Q3.22: rounded down
    wire [25:0] nl1_z_0 = nl1_z_exact_0[35:10];
    // UQ1.0: a bit of the shift
    wire nl1_by_1_0 = shift1_0[0];
    // UQ2.-1: a bit of the shift
    wire nl1_by_2_0 = shift1_0[1];
    // UQ2.0: its weight
    wire [1:0] nl1_amount_2_0 = {nl1_by_2_0, 1'd0};
    // UQ3.-2: a bit of the shift
    wire nl1_by_4_0 = shift1_0[2];
    // UQ3.0: its weight
    wire [2:0] nl1_amount_4_0 = {nl1_by_4_0, 2'd0};
    // UQ4.-3: a bit of the shift
    wire nl1_by_8_0 = shift1_0[3];
    // UQ1.5: the weight of the odd band, at most 1
    wire [5:0] blend1_0 = (|in_blend1[5]) ? 6'h20 : in_blend1;
    // UQ5.0: the next
    wire [4:0] band1_next_exact_0 = {1'd0, in_band1} + 5'h01;
    // UQ4.-1: its leading bits
    wire [2:0] band1_odd_high_0 = in_band1[3:1];
    // UQ3.0: the odd one of both
    wire [2:0] band1_odd_0 = band1_odd_high_0;
    // Q3.32: the turned normal
    wire [35:0] v1_x_exact_0 = $signed(in_nx) * $signed(in_v1x);
    // Q3.12: rounded down
    wire [15:0] v1_x_0 = v1_x_exact_0[35:20];
    // Q3.32: the turned normal
    wire [35:0] v1_y_exact_0 = $signed(in_ny) * $signed(in_v1y);
    // Q3.12: rounded down
    wire [15:0] v1_y_0 = v1_y_exact_0[35:20];
    // Q3.32: the turned normal
    wire [35:0] u1_x_exact_0 = $signed(in_nx) * $signed(in_u1x);
    // Q3.12: rounded down
    wire [15:0] u1_x_0 = u1_x_exact_0[35:20];
    // Q3.32: the turned normal
    wire [35:0] u1_y_exact_0 = $signed(in_ny) * $signed(in_u1y);
    // Q3.12: rounded down
    wire [15:0] u1_y_0 = u1_y_exact_0[35:20];
    // Q3.32: the turned normal
    wire [35:0] u1_z_exact_0 = $signed(in_nz) * $signed(in_u1z);
    // Q3.12: rounded down
    wire [15:0] u1_z_0 = u1_z_exact_0[35:20];
    // UQ7.-4: the first of them
    wire [2:0] texels1_10_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_10_v2_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_11_0 = band1_odd_0;
    // UQ7.-4: the first of them
    wire [2:0] texels1_11_v2_0 = band1_odd_0;
    // Q1.5: a sign bit for the signed product
    wire [6:0] blend1_signed_0 = {1'd0, blend1_0};
    reg [17:0] in_gain1r_1;
    reg [17:0] in_gain1g_1;
    reg [17:0] in_gain1b_1;
    reg hidden_1;
    reg [25:0] nl1_x_1;
    reg [25:0] nl1_y_1;
    reg [25:0] nl1_z_1;
    reg nl1_by_1_1;
    reg [1:0] nl1_amount_2_1;
    reg [2:0] nl1_amount_4_1;
    reg nl1_by_8_1;
    reg [4:0] band1_next_exact_1;
    reg [15:0] v1_x_1;
    reg [15:0] v1_y_1;
    reg [15:0] u1_x_1;
    reg [15:0] u1_y_1;
    reg [15:0] u1_z_1;
    reg [2:0] texels1_10_1;
    reg [2:0] texels1_10_v2_1;
    reg [2:0] texels1_11_1;
    reg [2:0] texels1_11_v2_1;
    reg [6:0] blend1_signed_1;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_1 <= in_gain1r;
            in_gain1g_1 <= in_gain1g;
            in_gain1b_1 <= in_gain1b;
            hidden_1 <= hidden_0;
            nl1_x_1 <= nl1_x_0;
            nl1_y_1 <= nl1_y_0;
            nl1_z_1 <= nl1_z_0;
            nl1_by_1_1 <= nl1_by_1_0;
            nl1_amount_2_1 <= nl1_amount_2_0;
            nl1_amount_4_1 <= nl1_amount_4_0;
            nl1_by_8_1 <= nl1_by_8_0;
            band1_next_exact_1 <= band1_next_exact_0;
            v1_x_1 <= v1_x_0;
            v1_y_1 <= v1_y_0;
            u1_x_1 <= u1_x_0;
            u1_y_1 <= u1_y_0;
            u1_z_1 <= u1_z_0;
            texels1_10_1 <= texels1_10_0;
            texels1_10_v2_1 <= texels1_10_v2_0;
            texels1_11_1 <= texels1_11_0;
            texels1_11_v2_1 <= texels1_11_v2_0;
            blend1_signed_1 <= blend1_signed_0;
        end
    end

    // ===== Stage 1: nl1_xy, band1_next, v1_xy, u1_xy
    // Q4.22: n.l
    wire [26:0] nl1_xy_1 = {{1{nl1_x_1[25]}}, nl1_x_1} + {{1{nl1_y_1[25]}}, nl1_y_1};
    // UQ4.0: at most the last
    wire [3:0] band1_next_1 = (|band1_next_exact_1[4]) ? 4'hf : band1_next_exact_1[3:0];
    // UQ4.-1: its leading bits
    wire [2:0] band1_even_high_1 = band1_next_1[3:1];
    // UQ3.0: the even one of both
    wire [2:0] band1_even_1 = band1_even_high_1;
    // Q4.12: the turned normal
    wire [16:0] v1_xy_1 = {{1{v1_x_1[15]}}, v1_x_1} + {{1{v1_y_1[15]}}, v1_y_1};
    // Q8.8: in texels from the middle
    wire [16:0] v1_scaled_1 = v1_xy_1;
    // Q4.12: the turned normal
    wire [16:0] u1_xy_1 = {{1{u1_x_1[15]}}, u1_x_1} + {{1{u1_y_1[15]}}, u1_y_1};
    // UQ7.-4: the first of them
    wire [2:0] texels1_00_1 = band1_even_1;
    // UQ7.-4: the first of them
    wire [2:0] texels1_00_v2_1 = band1_even_1;
    // UQ7.-4: the first of them
    wire [2:0] texels1_01_1 = band1_even_1;
    // UQ7.-4: the first of them
    wire [2:0] texels1_01_v2_1 = band1_even_1;
    reg [17:0] in_gain1r_2;
    reg [17:0] in_gain1g_2;
    reg [17:0] in_gain1b_2;
    reg hidden_2;
    reg [25:0] nl1_z_2;
    reg [26:0] nl1_xy_2;
    reg nl1_by_1_2;
    reg [1:0] nl1_amount_2_2;
    reg [2:0] nl1_amount_4_2;
    reg nl1_by_8_2;
    reg [16:0] v1_scaled_2;
    reg [15:0] u1_z_2;
    reg [16:0] u1_xy_2;
    reg [2:0] texels1_00_2;
    reg [2:0] texels1_00_v2_2;
    reg [2:0] texels1_01_2;
    reg [2:0] texels1_01_v2_2;
    reg [2:0] texels1_10_2;
    reg [2:0] texels1_10_v2_2;
    reg [2:0] texels1_11_2;
    reg [2:0] texels1_11_v2_2;
    reg [6:0] blend1_signed_2;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_2 <= in_gain1r_1;
            in_gain1g_2 <= in_gain1g_1;
            in_gain1b_2 <= in_gain1b_1;
            hidden_2 <= hidden_1;
            nl1_z_2 <= nl1_z_1;
            nl1_xy_2 <= nl1_xy_1;
            nl1_by_1_2 <= nl1_by_1_1;
            nl1_amount_2_2 <= nl1_amount_2_1;
            nl1_amount_4_2 <= nl1_amount_4_1;
            nl1_by_8_2 <= nl1_by_8_1;
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

    // ===== Stage 2: nl1_xyz, v1_place, u1_xyz
    // Q4.22: n.l
    wire [26:0] nl1_xyz_2 = nl1_xy_2 + {{1{nl1_z_2[25]}}, nl1_z_2};
    // Q4.20: rounded down
    wire [24:0] nl1_cut_2 = nl1_xyz_2[26:2];
    // Q8.8: from the first, plus half a weight's last bit
    wire [16:0] v1_place_2 = v1_scaled_2 + 17'h00f84;
    // Q8.5: rounded to the nearest weight
    wire [13:0] v1_cut_2 = v1_place_2[16:3];
    // Q4.12: the turned normal
    wire [16:0] u1_xyz_2 = u1_xy_2 + {{1{u1_z_2[15]}}, u1_z_2};
    // Q8.8: in texels from the middle
    wire [16:0] u1_scaled_2 = u1_xyz_2;
    reg [17:0] in_gain1r_3;
    reg [17:0] in_gain1g_3;
    reg [17:0] in_gain1b_3;
    reg hidden_3;
    reg [24:0] nl1_cut_3;
    reg nl1_by_1_3;
    reg [1:0] nl1_amount_2_3;
    reg [2:0] nl1_amount_4_3;
    reg nl1_by_8_3;
    reg [13:0] v1_cut_3;
    reg [16:0] u1_scaled_3;
    reg [2:0] texels1_00_3;
    reg [2:0] texels1_00_v2_3;
    reg [2:0] texels1_01_3;
    reg [2:0] texels1_01_v2_3;
    reg [2:0] texels1_10_3;
    reg [2:0] texels1_10_v2_3;
    reg [2:0] texels1_11_3;
    reg [2:0] texels1_11_v2_3;
    reg [6:0] blend1_signed_3;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_3 <= in_gain1r_2;
            in_gain1g_3 <= in_gain1g_2;
            in_gain1b_3 <= in_gain1b_2;
            hidden_3 <= hidden_2;
            nl1_cut_3 <= nl1_cut_2;
            nl1_by_1_3 <= nl1_by_1_2;
            nl1_amount_2_3 <= nl1_amount_2_2;
            nl1_amount_4_3 <= nl1_amount_4_2;
            nl1_by_8_3 <= nl1_by_8_2;
            v1_cut_3 <= v1_cut_2;
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

    // ===== Stage 3: nl1_kept, nl1_up_1, v1_kept, u1_place, v1_weight_of_0 and 4 more
    // UQ0.20: n.l, kept in [0, 1)
    wire [19:0] nl1_kept_3 =
        nl1_cut_3[24] ? 20'h00000 : (|nl1_cut_3[23:20]) ? 20'hfffff : nl1_cut_3[19:0];
    // UQ1.20: times 2^1 if so
    wire [20:0] nl1_up_1_3 = {1'd0, nl1_kept_3} << nl1_by_1_3;
    // UQ9.12: times 2^8
    wire [20:0] nl1_all_3 = nl1_up_1_3;
    // UQ9.20: in the wider of two formats
    wire [28:0] nl1_all_wide_3 = {nl1_all_3, 8'd0};
    // UQ5.5: between the outermost centres
    wire [9:0] v1_kept_3 = v1_cut_3[13] ? 10'h000 : (v1_cut_3 > 14'h03e0) ? 10'h3e0 : v1_cut_3[9:0];
    // UQ5.0: the texel at or below it
    wire [4:0] v1_texel_3 = v1_kept_3[9:5];
    // UQ0.5: the weight of the next
    wire [4:0] v1_weight_3 = v1_kept_3[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] v1_odd_high_3 = v1_texel_3[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] v1_odd_3 = v1_odd_high_3;
    // UQ1.0: its last bit
    wire v1_is_odd_3 = v1_texel_3[0];
    // UQ1.5: in the wider of two formats
    wire [5:0] v1_weight_wide_3 = {1'd0, v1_weight_3};
    // Q8.8: from the first, plus half a weight's last bit
    wire [16:0] u1_place_3 = u1_scaled_3 + 17'h00f84;
    // Q8.5: rounded to the nearest weight
    wire [13:0] u1_cut_3 = u1_place_3[16:3];
    // UQ-4.5: a bit of the weight
    wire v1_weight_bit_0_3 = v1_weight_3[0];
    // UQ-3.4: a bit of the weight
    wire v1_weight_bit_1_3 = v1_weight_3[1];
    // UQ-2.3: a bit of the weight
    wire v1_weight_bit_2_3 = v1_weight_3[2];
    // UQ-1.2: a bit of the weight
    wire v1_weight_bit_3_3 = v1_weight_3[3];
    // UQ0.1: a bit of the weight
    wire v1_weight_bit_4_3 = v1_weight_3[4];
    // UQ1.0: as a flag
    wire v1_weight_of_0_flag_3 = v1_weight_bit_0_3;
    // UQ1.0: it is 0
    wire v1_weight_of_0_not_3 = ~v1_weight_of_0_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_0_3 = v1_is_odd_3 ? v1_weight_of_0_not_3 : v1_weight_of_0_flag_3;
    // UQ1.0: as a flag
    wire v1_weight_of_1_flag_3 = v1_weight_bit_1_3;
    // UQ1.0: it is 0
    wire v1_weight_of_1_not_3 = ~v1_weight_of_1_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_1_3 = v1_is_odd_3 ? v1_weight_of_1_not_3 : v1_weight_of_1_flag_3;
    // UQ1.0: as a flag
    wire v1_weight_of_2_flag_3 = v1_weight_bit_2_3;
    // UQ1.0: it is 0
    wire v1_weight_of_2_not_3 = ~v1_weight_of_2_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_2_3 = v1_is_odd_3 ? v1_weight_of_2_not_3 : v1_weight_of_2_flag_3;
    // UQ1.0: as a flag
    wire v1_weight_of_3_flag_3 = v1_weight_bit_3_3;
    // UQ1.0: it is 0
    wire v1_weight_of_3_not_3 = ~v1_weight_of_3_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_3_3 = v1_is_odd_3 ? v1_weight_of_3_not_3 : v1_weight_of_3_flag_3;
    // UQ1.0: as a flag
    wire v1_weight_of_4_flag_3 = v1_weight_bit_4_3;
    // UQ1.0: it is 0
    wire v1_weight_of_4_not_3 = ~v1_weight_of_4_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_4_3 = v1_is_odd_3 ? v1_weight_of_4_not_3 : v1_weight_of_4_flag_3;
    reg [17:0] in_gain1r_4;
    reg [17:0] in_gain1g_4;
    reg [17:0] in_gain1b_4;
    reg hidden_4;
    reg [20:0] nl1_up_1_4;
    reg [1:0] nl1_amount_2_4;
    reg [2:0] nl1_amount_4_4;
    reg nl1_by_8_4;
    reg [28:0] nl1_all_wide_4;
    reg [4:0] v1_texel_4;
    reg [4:0] v1_weight_4;
    reg [3:0] v1_odd_4;
    reg v1_is_odd_4;
    reg [5:0] v1_weight_wide_4;
    reg [13:0] u1_cut_4;
    reg [2:0] texels1_00_4;
    reg [2:0] texels1_00_v2_4;
    reg [2:0] texels1_01_4;
    reg [2:0] texels1_01_v2_4;
    reg [2:0] texels1_10_4;
    reg [2:0] texels1_10_v2_4;
    reg [2:0] texels1_11_4;
    reg [2:0] texels1_11_v2_4;
    reg [6:0] blend1_signed_4;
    reg v1_weight_of_0_4;
    reg v1_weight_of_1_4;
    reg v1_weight_of_2_4;
    reg v1_weight_of_3_4;
    reg v1_weight_of_4_4;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_4 <= in_gain1r_3;
            in_gain1g_4 <= in_gain1g_3;
            in_gain1b_4 <= in_gain1b_3;
            hidden_4 <= hidden_3;
            nl1_up_1_4 <= nl1_up_1_3;
            nl1_amount_2_4 <= nl1_amount_2_3;
            nl1_amount_4_4 <= nl1_amount_4_3;
            nl1_by_8_4 <= nl1_by_8_3;
            nl1_all_wide_4 <= nl1_all_wide_3;
            v1_texel_4 <= v1_texel_3;
            v1_weight_4 <= v1_weight_3;
            v1_odd_4 <= v1_odd_3;
            v1_is_odd_4 <= v1_is_odd_3;
            v1_weight_wide_4 <= v1_weight_wide_3;
            u1_cut_4 <= u1_cut_3;
            texels1_00_4 <= texels1_00_3;
            texels1_00_v2_4 <= texels1_00_v2_3;
            texels1_01_4 <= texels1_01_3;
            texels1_01_v2_4 <= texels1_01_v2_3;
            texels1_10_4 <= texels1_10_3;
            texels1_10_v2_4 <= texels1_10_v2_3;
            texels1_11_4 <= texels1_11_3;
            texels1_11_v2_4 <= texels1_11_v2_3;
            blend1_signed_4 <= blend1_signed_3;
            v1_weight_of_0_4 <= v1_weight_of_0_3;
            v1_weight_of_1_4 <= v1_weight_of_1_3;
            v1_weight_of_2_4 <= v1_weight_of_2_3;
            v1_weight_of_3_4 <= v1_weight_of_3_3;
            v1_weight_of_4_4 <= v1_weight_of_4_3;
        end
    end

    // ===== Stage 4: nl1_up_2, v1_next_exact, v1_other, v1_odd, u1_kept and 9 more
    // UQ3.20: times 2^2 if so
    wire [22:0] nl1_up_2_4 = {2'd0, nl1_up_1_4} << nl1_amount_2_4;
    // UQ6.0: the next
    wire [5:0] v1_next_exact_4 = {1'd0, v1_texel_4} + 6'h01;
    // UQ1.5: the weight of the place itself
    wire [5:0] v1_other_4 = 6'h20 - {1'd0, v1_weight_4};
    // UQ1.5: the weight of the odd one
    wire [5:0] v1_odd_v2_4 = v1_is_odd_4 ? v1_other_4 : v1_weight_wide_4;
    // UQ5.5: between the outermost centres
    wire [9:0] u1_kept_4 = u1_cut_4[13] ? 10'h000 : (u1_cut_4 > 14'h03e0) ? 10'h3e0 : u1_cut_4[9:0];
    // UQ5.0: the texel at or below it
    wire [4:0] u1_texel_4 = u1_kept_4[9:5];
    // UQ0.5: the weight of the next
    wire [4:0] u1_weight_4 = u1_kept_4[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] u1_odd_high_4 = u1_texel_4[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] u1_odd_4 = u1_odd_high_4;
    // UQ1.0: its last bit
    wire u1_is_odd_4 = u1_texel_4[0];
    // UQ7.0: side by side
    wire [6:0] texel1_01_4 = {texels1_01_4, 4'd0} + {3'd0, v1_odd_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_010_4 = texel1_01_4;
    // UQ7.0: side by side
    wire [6:0] texel1_01_v2_4 = {texels1_01_v2_4, 4'd0} + {3'd0, v1_odd_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_011_4 = texel1_01_v2_4;
    // UQ7.0: side by side
    wire [6:0] texel1_11_4 = {texels1_11_4, 4'd0} + {3'd0, v1_odd_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_110_4 = texel1_11_4;
    // UQ7.0: side by side
    wire [6:0] texel1_11_v2_4 = {texels1_11_v2_4, 4'd0} + {3'd0, v1_odd_4};
    // UQ11.-4: the first of them
    wire [6:0] texels1_111_4 = texel1_11_v2_4;
    // UQ-4.5: a bit of the weight
    wire u1_weight_bit_0_4 = u1_weight_4[0];
    // UQ-3.4: a bit of the weight
    wire u1_weight_bit_1_4 = u1_weight_4[1];
    // UQ-2.3: a bit of the weight
    wire u1_weight_bit_2_4 = u1_weight_4[2];
    // UQ-1.2: a bit of the weight
    wire u1_weight_bit_3_4 = u1_weight_4[3];
    // UQ0.1: a bit of the weight
    wire u1_weight_bit_4_4 = u1_weight_4[4];
    // UQ1.0: as a flag
    wire u1_weight_of_0_flag_4 = u1_weight_bit_0_4;
    // UQ1.0: it is 0
    wire u1_weight_of_0_not_4 = ~u1_weight_of_0_flag_4;
    // UQ1.0: whether it counts for the odd one
    wire u1_weight_of_0_4 = u1_is_odd_4 ? u1_weight_of_0_not_4 : u1_weight_of_0_flag_4;
    // UQ1.0: as a flag
    wire u1_weight_of_1_flag_4 = u1_weight_bit_1_4;
    // UQ1.0: it is 0
    wire u1_weight_of_1_not_4 = ~u1_weight_of_1_flag_4;
    // UQ1.0: whether it counts for the odd one
    wire u1_weight_of_1_4 = u1_is_odd_4 ? u1_weight_of_1_not_4 : u1_weight_of_1_flag_4;
    // UQ1.0: as a flag
    wire u1_weight_of_2_flag_4 = u1_weight_bit_2_4;
    // UQ1.0: it is 0
    wire u1_weight_of_2_not_4 = ~u1_weight_of_2_flag_4;
    // UQ1.0: whether it counts for the odd one
    wire u1_weight_of_2_4 = u1_is_odd_4 ? u1_weight_of_2_not_4 : u1_weight_of_2_flag_4;
    // UQ1.0: as a flag
    wire u1_weight_of_3_flag_4 = u1_weight_bit_3_4;
    // UQ1.0: it is 0
    wire u1_weight_of_3_not_4 = ~u1_weight_of_3_flag_4;
    // UQ1.0: whether it counts for the odd one
    wire u1_weight_of_3_4 = u1_is_odd_4 ? u1_weight_of_3_not_4 : u1_weight_of_3_flag_4;
    // UQ1.0: as a flag
    wire u1_weight_of_4_flag_4 = u1_weight_bit_4_4;
    // UQ1.0: it is 0
    wire u1_weight_of_4_not_4 = ~u1_weight_of_4_flag_4;
    // UQ1.0: whether it counts for the odd one
    wire u1_weight_of_4_4 = u1_is_odd_4 ? u1_weight_of_4_not_4 : u1_weight_of_4_flag_4;
    // Q1.5: a sign bit for the signed product
    wire [6:0] v1_odd_signed_4 = {1'd0, v1_odd_v2_4};
    reg [17:0] in_gain1r_5;
    reg [17:0] in_gain1g_5;
    reg [17:0] in_gain1b_5;
    reg hidden_5;
    reg [22:0] nl1_up_2_5;
    reg [2:0] nl1_amount_4_5;
    reg nl1_by_8_5;
    reg [28:0] nl1_all_wide_5;
    reg [5:0] v1_next_exact_5;
    reg v1_is_odd_5;
    reg [4:0] u1_texel_5;
    reg [3:0] u1_odd_5;
    reg u1_is_odd_5;
    reg [2:0] texels1_00_5;
    reg [2:0] texels1_00_v2_5;
    reg [6:0] texels1_010_5;
    reg [6:0] texels1_011_5;
    reg [2:0] texels1_10_5;
    reg [2:0] texels1_10_v2_5;
    reg [6:0] texels1_110_5;
    reg [6:0] texels1_111_5;
    reg u1_weight_of_0_5;
    reg u1_weight_of_1_5;
    reg u1_weight_of_2_5;
    reg u1_weight_of_3_5;
    reg u1_weight_of_4_5;
    reg [6:0] v1_odd_signed_5;
    reg [6:0] blend1_signed_5;
    reg v1_weight_of_0_5;
    reg v1_weight_of_1_5;
    reg v1_weight_of_2_5;
    reg v1_weight_of_3_5;
    reg v1_weight_of_4_5;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_5 <= in_gain1r_4;
            in_gain1g_5 <= in_gain1g_4;
            in_gain1b_5 <= in_gain1b_4;
            hidden_5 <= hidden_4;
            nl1_up_2_5 <= nl1_up_2_4;
            nl1_amount_4_5 <= nl1_amount_4_4;
            nl1_by_8_5 <= nl1_by_8_4;
            nl1_all_wide_5 <= nl1_all_wide_4;
            v1_next_exact_5 <= v1_next_exact_4;
            v1_is_odd_5 <= v1_is_odd_4;
            u1_texel_5 <= u1_texel_4;
            u1_odd_5 <= u1_odd_4;
            u1_is_odd_5 <= u1_is_odd_4;
            texels1_00_5 <= texels1_00_4;
            texels1_00_v2_5 <= texels1_00_v2_4;
            texels1_010_5 <= texels1_010_4;
            texels1_011_5 <= texels1_011_4;
            texels1_10_5 <= texels1_10_4;
            texels1_10_v2_5 <= texels1_10_v2_4;
            texels1_110_5 <= texels1_110_4;
            texels1_111_5 <= texels1_111_4;
            u1_weight_of_0_5 <= u1_weight_of_0_4;
            u1_weight_of_1_5 <= u1_weight_of_1_4;
            u1_weight_of_2_5 <= u1_weight_of_2_4;
            u1_weight_of_3_5 <= u1_weight_of_3_4;
            u1_weight_of_4_5 <= u1_weight_of_4_4;
            v1_odd_signed_5 <= v1_odd_signed_4;
            blend1_signed_5 <= blend1_signed_4;
            v1_weight_of_0_5 <= v1_weight_of_0_4;
            v1_weight_of_1_5 <= v1_weight_of_1_4;
            v1_weight_of_2_5 <= v1_weight_of_2_4;
            v1_weight_of_3_5 <= v1_weight_of_3_4;
            v1_weight_of_4_5 <= v1_weight_of_4_4;
        end
    end

    // ===== Stage 5: nl1_up_4, nl1_up, nl1_within, v1_next, u1_next_exact and 2 more
    // UQ7.20: times 2^4 if so
    wire [26:0] nl1_up_4_5 = {4'd0, nl1_up_2_5} << nl1_amount_4_5;
    // UQ9.20: in the wider of two formats
    wire [28:0] nl1_up_4_wide_5 = {2'd0, nl1_up_4_5};
    // UQ9.20: times 2^shift
    wire [28:0] nl1_up_5 = nl1_by_8_5 ? nl1_all_wide_5 : nl1_up_4_wide_5;
    // UQ9.11: rounded down
    wire [19:0] nl1_up_cut_5 = nl1_up_5[28:9];
    // UQ7.11: kept in its format
    wire [17:0] nl1_within_5 = (|nl1_up_cut_5[19:18]) ? 18'h3ffff : nl1_up_cut_5[17:0];
    // UQ5.0: at most the last
    wire [4:0] v1_next_5 = (|v1_next_exact_5[5]) ? 5'h1f : v1_next_exact_5[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] v1_even_high_5 = v1_next_5[4:1];
    // UQ4.0: the even one of both
    wire [3:0] v1_even_5 = v1_even_high_5;
    // UQ6.0: the next
    wire [5:0] u1_next_exact_5 = {1'd0, u1_texel_5} + 6'h01;
    // UQ11.0: side by side
    wire [10:0] texel1_011_5 = {texels1_011_5, 4'd0} + {7'd0, u1_odd_5};
    // UQ11.0: side by side
    wire [10:0] texel1_111_5 = {texels1_111_5, 4'd0} + {7'd0, u1_odd_5};
    reg [17:0] in_gain1r_6;
    reg [17:0] in_gain1g_6;
    reg [17:0] in_gain1b_6;
    reg hidden_6;
    reg [17:0] nl1_within_6;
    reg [3:0] v1_even_6;
    reg v1_is_odd_6;
    reg [5:0] u1_next_exact_6;
    reg [3:0] u1_odd_6;
    reg u1_is_odd_6;
    reg [2:0] texels1_00_6;
    reg [2:0] texels1_00_v2_6;
    reg [6:0] texels1_010_6;
    reg [10:0] texel1_011_6;
    reg [2:0] texels1_10_6;
    reg [2:0] texels1_10_v2_6;
    reg [6:0] texels1_110_6;
    reg [10:0] texel1_111_6;
    reg u1_weight_of_0_6;
    reg u1_weight_of_1_6;
    reg u1_weight_of_2_6;
    reg u1_weight_of_3_6;
    reg u1_weight_of_4_6;
    reg [6:0] v1_odd_signed_6;
    reg [6:0] blend1_signed_6;
    reg v1_weight_of_0_6;
    reg v1_weight_of_1_6;
    reg v1_weight_of_2_6;
    reg v1_weight_of_3_6;
    reg v1_weight_of_4_6;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_6 <= in_gain1r_5;
            in_gain1g_6 <= in_gain1g_5;
            in_gain1b_6 <= in_gain1b_5;
            hidden_6 <= hidden_5;
            nl1_within_6 <= nl1_within_5;
            v1_even_6 <= v1_even_5;
            v1_is_odd_6 <= v1_is_odd_5;
            u1_next_exact_6 <= u1_next_exact_5;
            u1_odd_6 <= u1_odd_5;
            u1_is_odd_6 <= u1_is_odd_5;
            texels1_00_6 <= texels1_00_5;
            texels1_00_v2_6 <= texels1_00_v2_5;
            texels1_010_6 <= texels1_010_5;
            texel1_011_6 <= texel1_011_5;
            texels1_10_6 <= texels1_10_5;
            texels1_10_v2_6 <= texels1_10_v2_5;
            texels1_110_6 <= texels1_110_5;
            texel1_111_6 <= texel1_111_5;
            u1_weight_of_0_6 <= u1_weight_of_0_5;
            u1_weight_of_1_6 <= u1_weight_of_1_5;
            u1_weight_of_2_6 <= u1_weight_of_2_5;
            u1_weight_of_3_6 <= u1_weight_of_3_5;
            u1_weight_of_4_6 <= u1_weight_of_4_5;
            v1_odd_signed_6 <= v1_odd_signed_5;
            blend1_signed_6 <= blend1_signed_5;
            v1_weight_of_0_6 <= v1_weight_of_0_5;
            v1_weight_of_1_6 <= v1_weight_of_1_5;
            v1_weight_of_2_6 <= v1_weight_of_2_5;
            v1_weight_of_3_6 <= v1_weight_of_3_5;
            v1_weight_of_4_6 <= v1_weight_of_4_5;
        end
    end

    // ===== Stage 6: nl1, u1_next, texel1_00, texel1_00, texel1_10, texel1_10
    // UQ7.11: n.l, 0 for a normal that is turned away
    wire [17:0] nl1_6 = hidden_6 ? 18'd0 : nl1_within_6;
    // UQ5.0: at most the last
    wire [4:0] u1_next_6 = (|u1_next_exact_6[5]) ? 5'h1f : u1_next_exact_6[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] u1_even_high_6 = u1_next_6[4:1];
    // UQ4.0: the even one of both
    wire [3:0] u1_even_6 = u1_even_high_6;
    // UQ7.0: side by side
    wire [6:0] texel1_00_6 = {texels1_00_6, 4'd0} + {3'd0, v1_even_6};
    // UQ11.-4: the first of them
    wire [6:0] texels1_000_6 = texel1_00_6;
    // UQ7.0: side by side
    wire [6:0] texel1_00_v2_6 = {texels1_00_v2_6, 4'd0} + {3'd0, v1_even_6};
    // UQ11.-4: the first of them
    wire [6:0] texels1_001_6 = texel1_00_v2_6;
    // UQ7.0: side by side
    wire [6:0] texel1_10_6 = {texels1_10_6, 4'd0} + {3'd0, v1_even_6};
    // UQ11.-4: the first of them
    wire [6:0] texels1_100_6 = texel1_10_6;
    // UQ7.0: side by side
    wire [6:0] texel1_10_v2_6 = {texels1_10_v2_6, 4'd0} + {3'd0, v1_even_6};
    // UQ11.-4: the first of them
    wire [6:0] texels1_101_6 = texel1_10_v2_6;
    reg [17:0] in_gain1r_7;
    reg [17:0] in_gain1g_7;
    reg [17:0] in_gain1b_7;
    reg [17:0] nl1_7;
    reg v1_is_odd_7;
    reg [3:0] u1_even_7;
    reg [3:0] u1_odd_7;
    reg u1_is_odd_7;
    reg [6:0] texels1_000_7;
    reg [6:0] texels1_001_7;
    reg [6:0] texels1_010_7;
    reg [10:0] texel1_011_7;
    reg [6:0] texels1_100_7;
    reg [6:0] texels1_101_7;
    reg [6:0] texels1_110_7;
    reg [10:0] texel1_111_7;
    reg u1_weight_of_0_7;
    reg u1_weight_of_1_7;
    reg u1_weight_of_2_7;
    reg u1_weight_of_3_7;
    reg u1_weight_of_4_7;
    reg [6:0] v1_odd_signed_7;
    reg [6:0] blend1_signed_7;
    reg v1_weight_of_0_7;
    reg v1_weight_of_1_7;
    reg v1_weight_of_2_7;
    reg v1_weight_of_3_7;
    reg v1_weight_of_4_7;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_7 <= in_gain1r_6;
            in_gain1g_7 <= in_gain1g_6;
            in_gain1b_7 <= in_gain1b_6;
            nl1_7 <= nl1_6;
            v1_is_odd_7 <= v1_is_odd_6;
            u1_even_7 <= u1_even_6;
            u1_odd_7 <= u1_odd_6;
            u1_is_odd_7 <= u1_is_odd_6;
            texels1_000_7 <= texels1_000_6;
            texels1_001_7 <= texels1_001_6;
            texels1_010_7 <= texels1_010_6;
            texel1_011_7 <= texel1_011_6;
            texels1_100_7 <= texels1_100_6;
            texels1_101_7 <= texels1_101_6;
            texels1_110_7 <= texels1_110_6;
            texel1_111_7 <= texel1_111_6;
            u1_weight_of_0_7 <= u1_weight_of_0_6;
            u1_weight_of_1_7 <= u1_weight_of_1_6;
            u1_weight_of_2_7 <= u1_weight_of_2_6;
            u1_weight_of_3_7 <= u1_weight_of_3_6;
            u1_weight_of_4_7 <= u1_weight_of_4_6;
            v1_odd_signed_7 <= v1_odd_signed_6;
            blend1_signed_7 <= blend1_signed_6;
            v1_weight_of_0_7 <= v1_weight_of_0_6;
            v1_weight_of_1_7 <= v1_weight_of_1_6;
            v1_weight_of_2_7 <= v1_weight_of_2_6;
            v1_weight_of_3_7 <= v1_weight_of_3_6;
            v1_weight_of_4_7 <= v1_weight_of_4_6;
        end
    end

    // ===== Stage 7: texel1_000, texel1_001, texel1_010, texel1_100, texel1_101 and 1 more
    // UQ11.0: side by side
    wire [10:0] texel1_000_7 = {texels1_000_7, 4'd0} + {7'd0, u1_even_7};
    // UQ11.0: side by side
    wire [10:0] texel1_001_7 = {texels1_001_7, 4'd0} + {7'd0, u1_odd_7};
    // UQ11.0: side by side
    wire [10:0] texel1_010_7 = {texels1_010_7, 4'd0} + {7'd0, u1_even_7};
    // UQ11.0: side by side
    wire [10:0] texel1_100_7 = {texels1_100_7, 4'd0} + {7'd0, u1_even_7};
    // UQ11.0: side by side
    wire [10:0] texel1_101_7 = {texels1_101_7, 4'd0} + {7'd0, u1_odd_7};
    // UQ11.0: side by side
    wire [10:0] texel1_110_7 = {texels1_110_7, 4'd0} + {7'd0, u1_even_7};
    reg [17:0] in_gain1r_8;
    reg [17:0] in_gain1g_8;
    reg [17:0] in_gain1b_8;
    reg [17:0] nl1_8;
    reg v1_is_odd_8;
    reg u1_is_odd_8;
    reg [10:0] texel1_000_8;
    reg [10:0] texel1_001_8;
    reg [10:0] texel1_010_8;
    reg [10:0] texel1_011_8;
    reg [10:0] texel1_100_8;
    reg [10:0] texel1_101_8;
    reg [10:0] texel1_110_8;
    reg [10:0] texel1_111_8;
    reg u1_weight_of_0_8;
    reg u1_weight_of_1_8;
    reg u1_weight_of_2_8;
    reg u1_weight_of_3_8;
    reg u1_weight_of_4_8;
    reg [6:0] v1_odd_signed_8;
    reg [6:0] blend1_signed_8;
    reg v1_weight_of_0_8;
    reg v1_weight_of_1_8;
    reg v1_weight_of_2_8;
    reg v1_weight_of_3_8;
    reg v1_weight_of_4_8;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_8 <= in_gain1r_7;
            in_gain1g_8 <= in_gain1g_7;
            in_gain1b_8 <= in_gain1b_7;
            nl1_8 <= nl1_7;
            v1_is_odd_8 <= v1_is_odd_7;
            u1_is_odd_8 <= u1_is_odd_7;
            texel1_000_8 <= texel1_000_7;
            texel1_001_8 <= texel1_001_7;
            texel1_010_8 <= texel1_010_7;
            texel1_011_8 <= texel1_011_7;
            texel1_100_8 <= texel1_100_7;
            texel1_101_8 <= texel1_101_7;
            texel1_110_8 <= texel1_110_7;
            texel1_111_8 <= texel1_111_7;
            u1_weight_of_0_8 <= u1_weight_of_0_7;
            u1_weight_of_1_8 <= u1_weight_of_1_7;
            u1_weight_of_2_8 <= u1_weight_of_2_7;
            u1_weight_of_3_8 <= u1_weight_of_3_7;
            u1_weight_of_4_8 <= u1_weight_of_4_7;
            v1_odd_signed_8 <= v1_odd_signed_7;
            blend1_signed_8 <= blend1_signed_7;
            v1_weight_of_0_8 <= v1_weight_of_0_7;
            v1_weight_of_1_8 <= v1_weight_of_1_7;
            v1_weight_of_2_8 <= v1_weight_of_2_7;
            v1_weight_of_3_8 <= v1_weight_of_3_7;
            v1_weight_of_4_8 <= v1_weight_of_4_7;
        end
    end

    // ===== Stage 8: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    // The word of the memory texels_1_even_even_even, of 2048 words.
    reg [23:0] texels_1_even_even_even_9;
    // The word of the memory texels_1_even_even_odd, of 2048 words.
    reg [23:0] texels_1_even_even_odd_9;
    // The word of the memory texels_1_even_odd_even, of 2048 words.
    reg [23:0] texels_1_even_odd_even_9;
    // The word of the memory texels_1_even_odd_odd, of 2048 words.
    reg [23:0] texels_1_even_odd_odd_9;
    // The word of the memory texels_1_odd_even_even, of 2048 words.
    reg [23:0] texels_1_odd_even_even_9;
    // The word of the memory texels_1_odd_even_odd, of 2048 words.
    reg [23:0] texels_1_odd_even_odd_9;
    // The word of the memory texels_1_odd_odd_even, of 2048 words.
    reg [23:0] texels_1_odd_odd_even_9;
    // The word of the memory texels_1_odd_odd_odd, of 2048 words.
    reg [23:0] texels_1_odd_odd_odd_9;
    reg [23:0] texels_1_even_even_even [0:2047];
    initial $readmemh(TEXELS_1_EVEN_EVEN_EVEN_FILE, texels_1_even_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_even_9 <= texels_1_even_even_even[texel1_000_8];
    end
    reg [23:0] texels_1_even_even_odd [0:2047];
    initial $readmemh(TEXELS_1_EVEN_EVEN_ODD_FILE, texels_1_even_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_odd_9 <= texels_1_even_even_odd[texel1_001_8];
    end
    reg [23:0] texels_1_even_odd_even [0:2047];
    initial $readmemh(TEXELS_1_EVEN_ODD_EVEN_FILE, texels_1_even_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_even_9 <= texels_1_even_odd_even[texel1_010_8];
    end
    reg [23:0] texels_1_even_odd_odd [0:2047];
    initial $readmemh(TEXELS_1_EVEN_ODD_ODD_FILE, texels_1_even_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_odd_9 <= texels_1_even_odd_odd[texel1_011_8];
    end
    reg [23:0] texels_1_odd_even_even [0:2047];
    initial $readmemh(TEXELS_1_ODD_EVEN_EVEN_FILE, texels_1_odd_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_even_9 <= texels_1_odd_even_even[texel1_100_8];
    end
    reg [23:0] texels_1_odd_even_odd [0:2047];
    initial $readmemh(TEXELS_1_ODD_EVEN_ODD_FILE, texels_1_odd_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_odd_9 <= texels_1_odd_even_odd[texel1_101_8];
    end
    reg [23:0] texels_1_odd_odd_even [0:2047];
    initial $readmemh(TEXELS_1_ODD_ODD_EVEN_FILE, texels_1_odd_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_even_9 <= texels_1_odd_odd_even[texel1_110_8];
    end
    reg [23:0] texels_1_odd_odd_odd [0:2047];
    initial $readmemh(TEXELS_1_ODD_ODD_ODD_FILE, texels_1_odd_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_odd_9 <= texels_1_odd_odd_odd[texel1_111_8];
    end
    reg [17:0] in_gain1r_9;
    reg [17:0] in_gain1g_9;
    reg [17:0] in_gain1b_9;
    reg [17:0] nl1_9;
    reg v1_is_odd_9;
    reg u1_is_odd_9;
    reg u1_weight_of_0_9;
    reg u1_weight_of_1_9;
    reg u1_weight_of_2_9;
    reg u1_weight_of_3_9;
    reg u1_weight_of_4_9;
    reg [6:0] v1_odd_signed_9;
    reg [6:0] blend1_signed_9;
    reg v1_weight_of_0_9;
    reg v1_weight_of_1_9;
    reg v1_weight_of_2_9;
    reg v1_weight_of_3_9;
    reg v1_weight_of_4_9;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_9 <= in_gain1r_8;
            in_gain1g_9 <= in_gain1g_8;
            in_gain1b_9 <= in_gain1b_8;
            nl1_9 <= nl1_8;
            v1_is_odd_9 <= v1_is_odd_8;
            u1_is_odd_9 <= u1_is_odd_8;
            u1_weight_of_0_9 <= u1_weight_of_0_8;
            u1_weight_of_1_9 <= u1_weight_of_1_8;
            u1_weight_of_2_9 <= u1_weight_of_2_8;
            u1_weight_of_3_9 <= u1_weight_of_3_8;
            u1_weight_of_4_9 <= u1_weight_of_4_8;
            v1_odd_signed_9 <= v1_odd_signed_8;
            blend1_signed_9 <= blend1_signed_8;
            v1_weight_of_0_9 <= v1_weight_of_0_8;
            v1_weight_of_1_9 <= v1_weight_of_1_8;
            v1_weight_of_2_9 <= v1_weight_of_2_8;
            v1_weight_of_3_9 <= v1_weight_of_3_8;
            v1_weight_of_4_9 <= v1_weight_of_4_8;
        end
    end

    // ===== Stage 9: registers only
    // UQ0.8: red
    wire [7:0] texels_1_even_even_even_r_9 = texels_1_even_even_even_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_even_odd_r_9 = texels_1_even_even_odd_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_even_r_9 = texels_1_even_odd_even_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_odd_r_9 = texels_1_even_odd_odd_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_even_r_9 = texels_1_odd_even_even_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_odd_r_9 = texels_1_odd_even_odd_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_even_r_9 = texels_1_odd_odd_even_9[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_odd_r_9 = texels_1_odd_odd_odd_9[23:16];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_even_g_9 = texels_1_even_even_even_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_odd_g_9 = texels_1_even_even_odd_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_even_g_9 = texels_1_even_odd_even_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_odd_g_9 = texels_1_even_odd_odd_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_even_g_9 = texels_1_odd_even_even_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_odd_g_9 = texels_1_odd_even_odd_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_even_g_9 = texels_1_odd_odd_even_9[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_odd_g_9 = texels_1_odd_odd_odd_9[15:8];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_even_b_9 = texels_1_even_even_even_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_odd_b_9 = texels_1_even_even_odd_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_even_b_9 = texels_1_even_odd_even_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_odd_b_9 = texels_1_even_odd_odd_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_even_b_9 = texels_1_odd_even_even_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_odd_b_9 = texels_1_odd_even_odd_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_even_b_9 = texels_1_odd_odd_even_9[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_odd_b_9 = texels_1_odd_odd_odd_9[7:0];
    reg [17:0] in_gain1r_10;
    reg [17:0] in_gain1g_10;
    reg [17:0] in_gain1b_10;
    reg [17:0] nl1_10;
    reg v1_is_odd_10;
    reg u1_is_odd_10;
    reg [7:0] texels_1_even_even_even_r_10;
    reg [7:0] texels_1_even_even_odd_r_10;
    reg [7:0] texels_1_even_odd_even_r_10;
    reg [7:0] texels_1_even_odd_odd_r_10;
    reg [7:0] texels_1_odd_even_even_r_10;
    reg [7:0] texels_1_odd_even_odd_r_10;
    reg [7:0] texels_1_odd_odd_even_r_10;
    reg [7:0] texels_1_odd_odd_odd_r_10;
    reg u1_weight_of_0_10;
    reg u1_weight_of_1_10;
    reg u1_weight_of_2_10;
    reg u1_weight_of_3_10;
    reg u1_weight_of_4_10;
    reg [6:0] v1_odd_signed_10;
    reg [6:0] blend1_signed_10;
    reg [7:0] texels_1_even_even_even_g_10;
    reg [7:0] texels_1_even_even_odd_g_10;
    reg [7:0] texels_1_even_odd_even_g_10;
    reg [7:0] texels_1_even_odd_odd_g_10;
    reg [7:0] texels_1_odd_even_even_g_10;
    reg [7:0] texels_1_odd_even_odd_g_10;
    reg [7:0] texels_1_odd_odd_even_g_10;
    reg [7:0] texels_1_odd_odd_odd_g_10;
    reg v1_weight_of_0_10;
    reg v1_weight_of_1_10;
    reg v1_weight_of_2_10;
    reg v1_weight_of_3_10;
    reg v1_weight_of_4_10;
    reg [7:0] texels_1_even_even_even_b_10;
    reg [7:0] texels_1_even_even_odd_b_10;
    reg [7:0] texels_1_even_odd_even_b_10;
    reg [7:0] texels_1_even_odd_odd_b_10;
    reg [7:0] texels_1_odd_even_even_b_10;
    reg [7:0] texels_1_odd_even_odd_b_10;
    reg [7:0] texels_1_odd_odd_even_b_10;
    reg [7:0] texels_1_odd_odd_odd_b_10;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_10 <= in_gain1r_9;
            in_gain1g_10 <= in_gain1g_9;
            in_gain1b_10 <= in_gain1b_9;
            nl1_10 <= nl1_9;
            v1_is_odd_10 <= v1_is_odd_9;
            u1_is_odd_10 <= u1_is_odd_9;
            texels_1_even_even_even_r_10 <= texels_1_even_even_even_r_9;
            texels_1_even_even_odd_r_10 <= texels_1_even_even_odd_r_9;
            texels_1_even_odd_even_r_10 <= texels_1_even_odd_even_r_9;
            texels_1_even_odd_odd_r_10 <= texels_1_even_odd_odd_r_9;
            texels_1_odd_even_even_r_10 <= texels_1_odd_even_even_r_9;
            texels_1_odd_even_odd_r_10 <= texels_1_odd_even_odd_r_9;
            texels_1_odd_odd_even_r_10 <= texels_1_odd_odd_even_r_9;
            texels_1_odd_odd_odd_r_10 <= texels_1_odd_odd_odd_r_9;
            u1_weight_of_0_10 <= u1_weight_of_0_9;
            u1_weight_of_1_10 <= u1_weight_of_1_9;
            u1_weight_of_2_10 <= u1_weight_of_2_9;
            u1_weight_of_3_10 <= u1_weight_of_3_9;
            u1_weight_of_4_10 <= u1_weight_of_4_9;
            v1_odd_signed_10 <= v1_odd_signed_9;
            blend1_signed_10 <= blend1_signed_9;
            texels_1_even_even_even_g_10 <= texels_1_even_even_even_g_9;
            texels_1_even_even_odd_g_10 <= texels_1_even_even_odd_g_9;
            texels_1_even_odd_even_g_10 <= texels_1_even_odd_even_g_9;
            texels_1_even_odd_odd_g_10 <= texels_1_even_odd_odd_g_9;
            texels_1_odd_even_even_g_10 <= texels_1_odd_even_even_g_9;
            texels_1_odd_even_odd_g_10 <= texels_1_odd_even_odd_g_9;
            texels_1_odd_odd_even_g_10 <= texels_1_odd_odd_even_g_9;
            texels_1_odd_odd_odd_g_10 <= texels_1_odd_odd_odd_g_9;
            v1_weight_of_0_10 <= v1_weight_of_0_9;
            v1_weight_of_1_10 <= v1_weight_of_1_9;
            v1_weight_of_2_10 <= v1_weight_of_2_9;
            v1_weight_of_3_10 <= v1_weight_of_3_9;
            v1_weight_of_4_10 <= v1_weight_of_4_9;
            texels_1_even_even_even_b_10 <= texels_1_even_even_even_b_9;
            texels_1_even_even_odd_b_10 <= texels_1_even_even_odd_b_9;
            texels_1_even_odd_even_b_10 <= texels_1_even_odd_even_b_9;
            texels_1_even_odd_odd_b_10 <= texels_1_even_odd_odd_b_9;
            texels_1_odd_even_even_b_10 <= texels_1_odd_even_even_b_9;
            texels_1_odd_even_odd_b_10 <= texels_1_odd_even_odd_b_9;
            texels_1_odd_odd_even_b_10 <= texels_1_odd_odd_even_b_9;
            texels_1_odd_odd_odd_b_10 <= texels_1_odd_odd_odd_b_9;
        end
    end

    // ===== Stage 10: registers only
    reg [17:0] in_gain1r_11;
    reg [17:0] in_gain1g_11;
    reg [17:0] in_gain1b_11;
    reg [17:0] nl1_11;
    reg v1_is_odd_11;
    reg u1_is_odd_11;
    reg [7:0] texels_1_even_even_even_r_11;
    reg [7:0] texels_1_even_even_odd_r_11;
    reg [7:0] texels_1_even_odd_even_r_11;
    reg [7:0] texels_1_even_odd_odd_r_11;
    reg [7:0] texels_1_odd_even_even_r_11;
    reg [7:0] texels_1_odd_even_odd_r_11;
    reg [7:0] texels_1_odd_odd_even_r_11;
    reg [7:0] texels_1_odd_odd_odd_r_11;
    reg u1_weight_of_0_11;
    reg u1_weight_of_1_11;
    reg u1_weight_of_2_11;
    reg u1_weight_of_3_11;
    reg u1_weight_of_4_11;
    reg [6:0] v1_odd_signed_11;
    reg [6:0] blend1_signed_11;
    reg [7:0] texels_1_even_even_even_g_11;
    reg [7:0] texels_1_even_even_odd_g_11;
    reg [7:0] texels_1_even_odd_even_g_11;
    reg [7:0] texels_1_even_odd_odd_g_11;
    reg [7:0] texels_1_odd_even_even_g_11;
    reg [7:0] texels_1_odd_even_odd_g_11;
    reg [7:0] texels_1_odd_odd_even_g_11;
    reg [7:0] texels_1_odd_odd_odd_g_11;
    reg v1_weight_of_0_11;
    reg v1_weight_of_1_11;
    reg v1_weight_of_2_11;
    reg v1_weight_of_3_11;
    reg v1_weight_of_4_11;
    reg [7:0] texels_1_even_even_even_b_11;
    reg [7:0] texels_1_even_even_odd_b_11;
    reg [7:0] texels_1_even_odd_even_b_11;
    reg [7:0] texels_1_even_odd_odd_b_11;
    reg [7:0] texels_1_odd_even_even_b_11;
    reg [7:0] texels_1_odd_even_odd_b_11;
    reg [7:0] texels_1_odd_odd_even_b_11;
    reg [7:0] texels_1_odd_odd_odd_b_11;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_11 <= in_gain1r_10;
            in_gain1g_11 <= in_gain1g_10;
            in_gain1b_11 <= in_gain1b_10;
            nl1_11 <= nl1_10;
            v1_is_odd_11 <= v1_is_odd_10;
            u1_is_odd_11 <= u1_is_odd_10;
            texels_1_even_even_even_r_11 <= texels_1_even_even_even_r_10;
            texels_1_even_even_odd_r_11 <= texels_1_even_even_odd_r_10;
            texels_1_even_odd_even_r_11 <= texels_1_even_odd_even_r_10;
            texels_1_even_odd_odd_r_11 <= texels_1_even_odd_odd_r_10;
            texels_1_odd_even_even_r_11 <= texels_1_odd_even_even_r_10;
            texels_1_odd_even_odd_r_11 <= texels_1_odd_even_odd_r_10;
            texels_1_odd_odd_even_r_11 <= texels_1_odd_odd_even_r_10;
            texels_1_odd_odd_odd_r_11 <= texels_1_odd_odd_odd_r_10;
            u1_weight_of_0_11 <= u1_weight_of_0_10;
            u1_weight_of_1_11 <= u1_weight_of_1_10;
            u1_weight_of_2_11 <= u1_weight_of_2_10;
            u1_weight_of_3_11 <= u1_weight_of_3_10;
            u1_weight_of_4_11 <= u1_weight_of_4_10;
            v1_odd_signed_11 <= v1_odd_signed_10;
            blend1_signed_11 <= blend1_signed_10;
            texels_1_even_even_even_g_11 <= texels_1_even_even_even_g_10;
            texels_1_even_even_odd_g_11 <= texels_1_even_even_odd_g_10;
            texels_1_even_odd_even_g_11 <= texels_1_even_odd_even_g_10;
            texels_1_even_odd_odd_g_11 <= texels_1_even_odd_odd_g_10;
            texels_1_odd_even_even_g_11 <= texels_1_odd_even_even_g_10;
            texels_1_odd_even_odd_g_11 <= texels_1_odd_even_odd_g_10;
            texels_1_odd_odd_even_g_11 <= texels_1_odd_odd_even_g_10;
            texels_1_odd_odd_odd_g_11 <= texels_1_odd_odd_odd_g_10;
            v1_weight_of_0_11 <= v1_weight_of_0_10;
            v1_weight_of_1_11 <= v1_weight_of_1_10;
            v1_weight_of_2_11 <= v1_weight_of_2_10;
            v1_weight_of_3_11 <= v1_weight_of_3_10;
            v1_weight_of_4_11 <= v1_weight_of_4_10;
            texels_1_even_even_even_b_11 <= texels_1_even_even_even_b_10;
            texels_1_even_even_odd_b_11 <= texels_1_even_even_odd_b_10;
            texels_1_even_odd_even_b_11 <= texels_1_even_odd_even_b_10;
            texels_1_even_odd_odd_b_11 <= texels_1_even_odd_odd_b_10;
            texels_1_odd_even_even_b_11 <= texels_1_odd_even_even_b_10;
            texels_1_odd_even_odd_b_11 <= texels_1_odd_even_odd_b_10;
            texels_1_odd_odd_even_b_11 <= texels_1_odd_odd_even_b_10;
            texels_1_odd_odd_odd_b_11 <= texels_1_odd_odd_odd_b_10;
        end
    end

    // ===== Stage 11: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 106 more
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_first_11 =
        u1_is_odd_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_0_by_first_11 = blend1_r_1_0_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_0_by_0_11 = blend1_r_1_0_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_0_by_1_11 = blend1_r_1_0_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_0_by_2_11 = blend1_r_1_0_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_0_by_3_11 = blend1_r_1_0_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_even_odd_r_11 : texels_1_even_even_even_r_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_0_by_4_11 = blend1_r_1_0_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_r_1_0_sum_1_0_11 =
        {1'd0, blend1_r_1_0_by_first_11} + {1'd0, blend1_r_1_0_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_r_1_0_sum_1_1_11 =
        {2'd0, blend1_r_1_0_by_1_11} + {1'd0, blend1_r_1_0_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_r_1_0_sum_1_2_11 =
        {2'd0, blend1_r_1_0_by_3_11} + {1'd0, blend1_r_1_0_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_first_11 =
        u1_is_odd_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_1_by_first_11 = blend1_r_1_1_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_1_by_0_11 = blend1_r_1_1_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_1_by_1_11 = blend1_r_1_1_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_1_by_2_11 = blend1_r_1_1_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_1_by_3_11 = blend1_r_1_1_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_odd_odd_r_11 : texels_1_even_odd_even_r_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_1_by_4_11 = blend1_r_1_1_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_r_1_1_sum_1_0_11 =
        {1'd0, blend1_r_1_1_by_first_11} + {1'd0, blend1_r_1_1_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_r_1_1_sum_1_1_11 =
        {2'd0, blend1_r_1_1_by_1_11} + {1'd0, blend1_r_1_1_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_r_1_1_sum_1_2_11 =
        {2'd0, blend1_r_1_1_by_3_11} + {1'd0, blend1_r_1_1_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_2_by_first_11 = blend1_r_1_2_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_2_by_0_11 = blend1_r_1_2_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_2_by_1_11 = blend1_r_1_2_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_2_by_2_11 = blend1_r_1_2_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_2_by_3_11 = blend1_r_1_2_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_even_odd_r_11 : texels_1_odd_even_even_r_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_2_by_4_11 = blend1_r_1_2_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_r_1_2_sum_1_0_11 =
        {1'd0, blend1_r_1_2_by_first_11} + {1'd0, blend1_r_1_2_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_r_1_2_sum_1_1_11 =
        {2'd0, blend1_r_1_2_by_1_11} + {1'd0, blend1_r_1_2_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_r_1_2_sum_1_2_11 =
        {2'd0, blend1_r_1_2_by_3_11} + {1'd0, blend1_r_1_2_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_3_by_first_11 = blend1_r_1_3_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_3_by_0_11 = blend1_r_1_3_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_3_by_1_11 = blend1_r_1_3_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_3_by_2_11 = blend1_r_1_3_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_3_by_3_11 = blend1_r_1_3_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_odd_odd_r_11 : texels_1_odd_odd_even_r_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_3_by_4_11 = blend1_r_1_3_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_r_1_3_sum_1_0_11 =
        {1'd0, blend1_r_1_3_by_first_11} + {1'd0, blend1_r_1_3_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_r_1_3_sum_1_1_11 =
        {2'd0, blend1_r_1_3_by_1_11} + {1'd0, blend1_r_1_3_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_r_1_3_sum_1_2_11 =
        {2'd0, blend1_r_1_3_by_3_11} + {1'd0, blend1_r_1_3_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_first_11 =
        u1_is_odd_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_0_by_first_11 = blend1_g_1_0_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_0_by_0_11 = blend1_g_1_0_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_0_by_1_11 = blend1_g_1_0_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_0_by_2_11 = blend1_g_1_0_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_0_by_3_11 = blend1_g_1_0_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_even_odd_g_11 : texels_1_even_even_even_g_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_0_by_4_11 = blend1_g_1_0_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_g_1_0_sum_1_0_11 =
        {1'd0, blend1_g_1_0_by_first_11} + {1'd0, blend1_g_1_0_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_g_1_0_sum_1_1_11 =
        {2'd0, blend1_g_1_0_by_1_11} + {1'd0, blend1_g_1_0_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_g_1_0_sum_1_2_11 =
        {2'd0, blend1_g_1_0_by_3_11} + {1'd0, blend1_g_1_0_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_first_11 =
        u1_is_odd_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_1_by_first_11 = blend1_g_1_1_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_1_by_0_11 = blend1_g_1_1_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_1_by_1_11 = blend1_g_1_1_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_1_by_2_11 = blend1_g_1_1_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_1_by_3_11 = blend1_g_1_1_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_odd_odd_g_11 : texels_1_even_odd_even_g_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_1_by_4_11 = blend1_g_1_1_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_g_1_1_sum_1_0_11 =
        {1'd0, blend1_g_1_1_by_first_11} + {1'd0, blend1_g_1_1_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_g_1_1_sum_1_1_11 =
        {2'd0, blend1_g_1_1_by_1_11} + {1'd0, blend1_g_1_1_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_g_1_1_sum_1_2_11 =
        {2'd0, blend1_g_1_1_by_3_11} + {1'd0, blend1_g_1_1_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_2_by_first_11 = blend1_g_1_2_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_2_by_0_11 = blend1_g_1_2_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_2_by_1_11 = blend1_g_1_2_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_2_by_2_11 = blend1_g_1_2_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_2_by_3_11 = blend1_g_1_2_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_even_odd_g_11 : texels_1_odd_even_even_g_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_2_by_4_11 = blend1_g_1_2_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_g_1_2_sum_1_0_11 =
        {1'd0, blend1_g_1_2_by_first_11} + {1'd0, blend1_g_1_2_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_g_1_2_sum_1_1_11 =
        {2'd0, blend1_g_1_2_by_1_11} + {1'd0, blend1_g_1_2_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_g_1_2_sum_1_2_11 =
        {2'd0, blend1_g_1_2_by_3_11} + {1'd0, blend1_g_1_2_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_3_by_first_11 = blend1_g_1_3_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_3_by_0_11 = blend1_g_1_3_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_3_by_1_11 = blend1_g_1_3_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_3_by_2_11 = blend1_g_1_3_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_3_by_3_11 = blend1_g_1_3_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_odd_odd_g_11 : texels_1_odd_odd_even_g_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_3_by_4_11 = blend1_g_1_3_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_g_1_3_sum_1_0_11 =
        {1'd0, blend1_g_1_3_by_first_11} + {1'd0, blend1_g_1_3_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_g_1_3_sum_1_1_11 =
        {2'd0, blend1_g_1_3_by_1_11} + {1'd0, blend1_g_1_3_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_g_1_3_sum_1_2_11 =
        {2'd0, blend1_g_1_3_by_3_11} + {1'd0, blend1_g_1_3_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_first_11 =
        u1_is_odd_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_0_by_first_11 = blend1_b_1_0_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_0_by_0_11 = blend1_b_1_0_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_0_by_1_11 = blend1_b_1_0_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_0_by_2_11 = blend1_b_1_0_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_0_by_3_11 = blend1_b_1_0_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_even_odd_b_11 : texels_1_even_even_even_b_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_0_by_4_11 = blend1_b_1_0_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_b_1_0_sum_1_0_11 =
        {1'd0, blend1_b_1_0_by_first_11} + {1'd0, blend1_b_1_0_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_b_1_0_sum_1_1_11 =
        {2'd0, blend1_b_1_0_by_1_11} + {1'd0, blend1_b_1_0_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_b_1_0_sum_1_2_11 =
        {2'd0, blend1_b_1_0_by_3_11} + {1'd0, blend1_b_1_0_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_first_11 =
        u1_is_odd_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_1_by_first_11 = blend1_b_1_1_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_0_11 =
        u1_weight_of_0_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_1_by_0_11 = blend1_b_1_1_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_1_11 =
        u1_weight_of_1_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_1_by_1_11 = blend1_b_1_1_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_2_11 =
        u1_weight_of_2_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_1_by_2_11 = blend1_b_1_1_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_3_11 =
        u1_weight_of_3_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_1_by_3_11 = blend1_b_1_1_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_4_11 =
        u1_weight_of_4_11 ? texels_1_even_odd_odd_b_11 : texels_1_even_odd_even_b_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_1_by_4_11 = blend1_b_1_1_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_b_1_1_sum_1_0_11 =
        {1'd0, blend1_b_1_1_by_first_11} + {1'd0, blend1_b_1_1_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_b_1_1_sum_1_1_11 =
        {2'd0, blend1_b_1_1_by_1_11} + {1'd0, blend1_b_1_1_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_b_1_1_sum_1_2_11 =
        {2'd0, blend1_b_1_1_by_3_11} + {1'd0, blend1_b_1_1_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_2_by_first_11 = blend1_b_1_2_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_2_by_0_11 = blend1_b_1_2_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_2_by_1_11 = blend1_b_1_2_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_2_by_2_11 = blend1_b_1_2_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_2_by_3_11 = blend1_b_1_2_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_even_odd_b_11 : texels_1_odd_even_even_b_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_2_by_4_11 = blend1_b_1_2_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_b_1_2_sum_1_0_11 =
        {1'd0, blend1_b_1_2_by_first_11} + {1'd0, blend1_b_1_2_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_b_1_2_sum_1_1_11 =
        {2'd0, blend1_b_1_2_by_1_11} + {1'd0, blend1_b_1_2_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_b_1_2_sum_1_2_11 =
        {2'd0, blend1_b_1_2_by_3_11} + {1'd0, blend1_b_1_2_by_4_11, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_first_11 =
        u1_is_odd_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_3_by_first_11 = blend1_b_1_3_either_first_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_0_11 =
        u1_weight_of_0_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_3_by_0_11 = blend1_b_1_3_either_0_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_1_11 =
        u1_weight_of_1_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_3_by_1_11 = blend1_b_1_3_either_1_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_2_11 =
        u1_weight_of_2_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_3_by_2_11 = blend1_b_1_3_either_2_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_3_11 =
        u1_weight_of_3_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_3_by_3_11 = blend1_b_1_3_either_3_11;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_4_11 =
        u1_weight_of_4_11 ? texels_1_odd_odd_odd_b_11 : texels_1_odd_odd_even_b_11;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_3_by_4_11 = blend1_b_1_3_either_4_11;
    // UQ-4.13: the sum of two
    wire [8:0] blend1_b_1_3_sum_1_0_11 =
        {1'd0, blend1_b_1_3_by_first_11} + {1'd0, blend1_b_1_3_by_0_11};
    // UQ-2.12: the sum of two
    wire [9:0] blend1_b_1_3_sum_1_1_11 =
        {2'd0, blend1_b_1_3_by_1_11} + {1'd0, blend1_b_1_3_by_2_11, 1'd0};
    // UQ0.10: the sum of two
    wire [9:0] blend1_b_1_3_sum_1_2_11 =
        {2'd0, blend1_b_1_3_by_3_11} + {1'd0, blend1_b_1_3_by_4_11, 1'd0};
    reg [17:0] in_gain1r_12;
    reg [17:0] in_gain1g_12;
    reg [17:0] in_gain1b_12;
    reg [17:0] nl1_12;
    reg v1_is_odd_12;
    reg [8:0] blend1_r_1_0_sum_1_0_12;
    reg [9:0] blend1_r_1_0_sum_1_1_12;
    reg [9:0] blend1_r_1_0_sum_1_2_12;
    reg [8:0] blend1_r_1_1_sum_1_0_12;
    reg [9:0] blend1_r_1_1_sum_1_1_12;
    reg [9:0] blend1_r_1_1_sum_1_2_12;
    reg [8:0] blend1_r_1_2_sum_1_0_12;
    reg [9:0] blend1_r_1_2_sum_1_1_12;
    reg [9:0] blend1_r_1_2_sum_1_2_12;
    reg [8:0] blend1_r_1_3_sum_1_0_12;
    reg [9:0] blend1_r_1_3_sum_1_1_12;
    reg [9:0] blend1_r_1_3_sum_1_2_12;
    reg [6:0] v1_odd_signed_12;
    reg [6:0] blend1_signed_12;
    reg [8:0] blend1_g_1_0_sum_1_0_12;
    reg [9:0] blend1_g_1_0_sum_1_1_12;
    reg [9:0] blend1_g_1_0_sum_1_2_12;
    reg [8:0] blend1_g_1_1_sum_1_0_12;
    reg [9:0] blend1_g_1_1_sum_1_1_12;
    reg [9:0] blend1_g_1_1_sum_1_2_12;
    reg [8:0] blend1_g_1_2_sum_1_0_12;
    reg [9:0] blend1_g_1_2_sum_1_1_12;
    reg [9:0] blend1_g_1_2_sum_1_2_12;
    reg [8:0] blend1_g_1_3_sum_1_0_12;
    reg [9:0] blend1_g_1_3_sum_1_1_12;
    reg [9:0] blend1_g_1_3_sum_1_2_12;
    reg v1_weight_of_0_12;
    reg v1_weight_of_1_12;
    reg v1_weight_of_2_12;
    reg v1_weight_of_3_12;
    reg v1_weight_of_4_12;
    reg [8:0] blend1_b_1_0_sum_1_0_12;
    reg [9:0] blend1_b_1_0_sum_1_1_12;
    reg [9:0] blend1_b_1_0_sum_1_2_12;
    reg [8:0] blend1_b_1_1_sum_1_0_12;
    reg [9:0] blend1_b_1_1_sum_1_1_12;
    reg [9:0] blend1_b_1_1_sum_1_2_12;
    reg [8:0] blend1_b_1_2_sum_1_0_12;
    reg [9:0] blend1_b_1_2_sum_1_1_12;
    reg [9:0] blend1_b_1_2_sum_1_2_12;
    reg [8:0] blend1_b_1_3_sum_1_0_12;
    reg [9:0] blend1_b_1_3_sum_1_1_12;
    reg [9:0] blend1_b_1_3_sum_1_2_12;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_12 <= in_gain1r_11;
            in_gain1g_12 <= in_gain1g_11;
            in_gain1b_12 <= in_gain1b_11;
            nl1_12 <= nl1_11;
            v1_is_odd_12 <= v1_is_odd_11;
            blend1_r_1_0_sum_1_0_12 <= blend1_r_1_0_sum_1_0_11;
            blend1_r_1_0_sum_1_1_12 <= blend1_r_1_0_sum_1_1_11;
            blend1_r_1_0_sum_1_2_12 <= blend1_r_1_0_sum_1_2_11;
            blend1_r_1_1_sum_1_0_12 <= blend1_r_1_1_sum_1_0_11;
            blend1_r_1_1_sum_1_1_12 <= blend1_r_1_1_sum_1_1_11;
            blend1_r_1_1_sum_1_2_12 <= blend1_r_1_1_sum_1_2_11;
            blend1_r_1_2_sum_1_0_12 <= blend1_r_1_2_sum_1_0_11;
            blend1_r_1_2_sum_1_1_12 <= blend1_r_1_2_sum_1_1_11;
            blend1_r_1_2_sum_1_2_12 <= blend1_r_1_2_sum_1_2_11;
            blend1_r_1_3_sum_1_0_12 <= blend1_r_1_3_sum_1_0_11;
            blend1_r_1_3_sum_1_1_12 <= blend1_r_1_3_sum_1_1_11;
            blend1_r_1_3_sum_1_2_12 <= blend1_r_1_3_sum_1_2_11;
            v1_odd_signed_12 <= v1_odd_signed_11;
            blend1_signed_12 <= blend1_signed_11;
            blend1_g_1_0_sum_1_0_12 <= blend1_g_1_0_sum_1_0_11;
            blend1_g_1_0_sum_1_1_12 <= blend1_g_1_0_sum_1_1_11;
            blend1_g_1_0_sum_1_2_12 <= blend1_g_1_0_sum_1_2_11;
            blend1_g_1_1_sum_1_0_12 <= blend1_g_1_1_sum_1_0_11;
            blend1_g_1_1_sum_1_1_12 <= blend1_g_1_1_sum_1_1_11;
            blend1_g_1_1_sum_1_2_12 <= blend1_g_1_1_sum_1_2_11;
            blend1_g_1_2_sum_1_0_12 <= blend1_g_1_2_sum_1_0_11;
            blend1_g_1_2_sum_1_1_12 <= blend1_g_1_2_sum_1_1_11;
            blend1_g_1_2_sum_1_2_12 <= blend1_g_1_2_sum_1_2_11;
            blend1_g_1_3_sum_1_0_12 <= blend1_g_1_3_sum_1_0_11;
            blend1_g_1_3_sum_1_1_12 <= blend1_g_1_3_sum_1_1_11;
            blend1_g_1_3_sum_1_2_12 <= blend1_g_1_3_sum_1_2_11;
            v1_weight_of_0_12 <= v1_weight_of_0_11;
            v1_weight_of_1_12 <= v1_weight_of_1_11;
            v1_weight_of_2_12 <= v1_weight_of_2_11;
            v1_weight_of_3_12 <= v1_weight_of_3_11;
            v1_weight_of_4_12 <= v1_weight_of_4_11;
            blend1_b_1_0_sum_1_0_12 <= blend1_b_1_0_sum_1_0_11;
            blend1_b_1_0_sum_1_1_12 <= blend1_b_1_0_sum_1_1_11;
            blend1_b_1_0_sum_1_2_12 <= blend1_b_1_0_sum_1_2_11;
            blend1_b_1_1_sum_1_0_12 <= blend1_b_1_1_sum_1_0_11;
            blend1_b_1_1_sum_1_1_12 <= blend1_b_1_1_sum_1_1_11;
            blend1_b_1_1_sum_1_2_12 <= blend1_b_1_1_sum_1_2_11;
            blend1_b_1_2_sum_1_0_12 <= blend1_b_1_2_sum_1_0_11;
            blend1_b_1_2_sum_1_1_12 <= blend1_b_1_2_sum_1_1_11;
            blend1_b_1_2_sum_1_2_12 <= blend1_b_1_2_sum_1_2_11;
            blend1_b_1_3_sum_1_0_12 <= blend1_b_1_3_sum_1_0_11;
            blend1_b_1_3_sum_1_1_12 <= blend1_b_1_3_sum_1_1_11;
            blend1_b_1_3_sum_1_2_12 <= blend1_b_1_3_sum_1_2_11;
        end
    end

    // ===== Stage 12: blend1_r_1_0_sum_2_0, blend1_r_1_1_sum_2_0 and 10 more
    // UQ-2.13: the sum of two
    wire [10:0] blend1_r_1_0_sum_2_0_12 =
        {2'd0, blend1_r_1_0_sum_1_0_12} + {blend1_r_1_0_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_r_1_1_sum_2_0_12 =
        {2'd0, blend1_r_1_1_sum_1_0_12} + {blend1_r_1_1_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_r_1_2_sum_2_0_12 =
        {2'd0, blend1_r_1_2_sum_1_0_12} + {blend1_r_1_2_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_r_1_3_sum_2_0_12 =
        {2'd0, blend1_r_1_3_sum_1_0_12} + {blend1_r_1_3_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_g_1_0_sum_2_0_12 =
        {2'd0, blend1_g_1_0_sum_1_0_12} + {blend1_g_1_0_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_g_1_1_sum_2_0_12 =
        {2'd0, blend1_g_1_1_sum_1_0_12} + {blend1_g_1_1_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_g_1_2_sum_2_0_12 =
        {2'd0, blend1_g_1_2_sum_1_0_12} + {blend1_g_1_2_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_g_1_3_sum_2_0_12 =
        {2'd0, blend1_g_1_3_sum_1_0_12} + {blend1_g_1_3_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_b_1_0_sum_2_0_12 =
        {2'd0, blend1_b_1_0_sum_1_0_12} + {blend1_b_1_0_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_b_1_1_sum_2_0_12 =
        {2'd0, blend1_b_1_1_sum_1_0_12} + {blend1_b_1_1_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_b_1_2_sum_2_0_12 =
        {2'd0, blend1_b_1_2_sum_1_0_12} + {blend1_b_1_2_sum_1_1_12, 1'd0};
    // UQ-2.13: the sum of two
    wire [10:0] blend1_b_1_3_sum_2_0_12 =
        {2'd0, blend1_b_1_3_sum_1_0_12} + {blend1_b_1_3_sum_1_1_12, 1'd0};
    reg [17:0] in_gain1r_13;
    reg [17:0] in_gain1g_13;
    reg [17:0] in_gain1b_13;
    reg [17:0] nl1_13;
    reg v1_is_odd_13;
    reg [9:0] blend1_r_1_0_sum_1_2_13;
    reg [10:0] blend1_r_1_0_sum_2_0_13;
    reg [9:0] blend1_r_1_1_sum_1_2_13;
    reg [10:0] blend1_r_1_1_sum_2_0_13;
    reg [9:0] blend1_r_1_2_sum_1_2_13;
    reg [10:0] blend1_r_1_2_sum_2_0_13;
    reg [9:0] blend1_r_1_3_sum_1_2_13;
    reg [10:0] blend1_r_1_3_sum_2_0_13;
    reg [6:0] v1_odd_signed_13;
    reg [6:0] blend1_signed_13;
    reg [9:0] blend1_g_1_0_sum_1_2_13;
    reg [10:0] blend1_g_1_0_sum_2_0_13;
    reg [9:0] blend1_g_1_1_sum_1_2_13;
    reg [10:0] blend1_g_1_1_sum_2_0_13;
    reg [9:0] blend1_g_1_2_sum_1_2_13;
    reg [10:0] blend1_g_1_2_sum_2_0_13;
    reg [9:0] blend1_g_1_3_sum_1_2_13;
    reg [10:0] blend1_g_1_3_sum_2_0_13;
    reg v1_weight_of_0_13;
    reg v1_weight_of_1_13;
    reg v1_weight_of_2_13;
    reg v1_weight_of_3_13;
    reg v1_weight_of_4_13;
    reg [9:0] blend1_b_1_0_sum_1_2_13;
    reg [10:0] blend1_b_1_0_sum_2_0_13;
    reg [9:0] blend1_b_1_1_sum_1_2_13;
    reg [10:0] blend1_b_1_1_sum_2_0_13;
    reg [9:0] blend1_b_1_2_sum_1_2_13;
    reg [10:0] blend1_b_1_2_sum_2_0_13;
    reg [9:0] blend1_b_1_3_sum_1_2_13;
    reg [10:0] blend1_b_1_3_sum_2_0_13;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_13 <= in_gain1r_12;
            in_gain1g_13 <= in_gain1g_12;
            in_gain1b_13 <= in_gain1b_12;
            nl1_13 <= nl1_12;
            v1_is_odd_13 <= v1_is_odd_12;
            blend1_r_1_0_sum_1_2_13 <= blend1_r_1_0_sum_1_2_12;
            blend1_r_1_0_sum_2_0_13 <= blend1_r_1_0_sum_2_0_12;
            blend1_r_1_1_sum_1_2_13 <= blend1_r_1_1_sum_1_2_12;
            blend1_r_1_1_sum_2_0_13 <= blend1_r_1_1_sum_2_0_12;
            blend1_r_1_2_sum_1_2_13 <= blend1_r_1_2_sum_1_2_12;
            blend1_r_1_2_sum_2_0_13 <= blend1_r_1_2_sum_2_0_12;
            blend1_r_1_3_sum_1_2_13 <= blend1_r_1_3_sum_1_2_12;
            blend1_r_1_3_sum_2_0_13 <= blend1_r_1_3_sum_2_0_12;
            v1_odd_signed_13 <= v1_odd_signed_12;
            blend1_signed_13 <= blend1_signed_12;
            blend1_g_1_0_sum_1_2_13 <= blend1_g_1_0_sum_1_2_12;
            blend1_g_1_0_sum_2_0_13 <= blend1_g_1_0_sum_2_0_12;
            blend1_g_1_1_sum_1_2_13 <= blend1_g_1_1_sum_1_2_12;
            blend1_g_1_1_sum_2_0_13 <= blend1_g_1_1_sum_2_0_12;
            blend1_g_1_2_sum_1_2_13 <= blend1_g_1_2_sum_1_2_12;
            blend1_g_1_2_sum_2_0_13 <= blend1_g_1_2_sum_2_0_12;
            blend1_g_1_3_sum_1_2_13 <= blend1_g_1_3_sum_1_2_12;
            blend1_g_1_3_sum_2_0_13 <= blend1_g_1_3_sum_2_0_12;
            v1_weight_of_0_13 <= v1_weight_of_0_12;
            v1_weight_of_1_13 <= v1_weight_of_1_12;
            v1_weight_of_2_13 <= v1_weight_of_2_12;
            v1_weight_of_3_13 <= v1_weight_of_3_12;
            v1_weight_of_4_13 <= v1_weight_of_4_12;
            blend1_b_1_0_sum_1_2_13 <= blend1_b_1_0_sum_1_2_12;
            blend1_b_1_0_sum_2_0_13 <= blend1_b_1_0_sum_2_0_12;
            blend1_b_1_1_sum_1_2_13 <= blend1_b_1_1_sum_1_2_12;
            blend1_b_1_1_sum_2_0_13 <= blend1_b_1_1_sum_2_0_12;
            blend1_b_1_2_sum_1_2_13 <= blend1_b_1_2_sum_1_2_12;
            blend1_b_1_2_sum_2_0_13 <= blend1_b_1_2_sum_2_0_12;
            blend1_b_1_3_sum_1_2_13 <= blend1_b_1_3_sum_1_2_12;
            blend1_b_1_3_sum_2_0_13 <= blend1_b_1_3_sum_2_0_12;
        end
    end

    // ===== Stage 13: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 20 more
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_0_13 = {2'd0, blend1_r_1_0_sum_2_0_13} + {blend1_r_1_0_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_1_13 = {2'd0, blend1_r_1_1_sum_2_0_13} + {blend1_r_1_1_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_2_13 = {2'd0, blend1_r_1_2_sum_2_0_13} + {blend1_r_1_2_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_3_13 = {2'd0, blend1_r_1_3_sum_2_0_13} + {blend1_r_1_3_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_0_13 = {2'd0, blend1_g_1_0_sum_2_0_13} + {blend1_g_1_0_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_1_13 = {2'd0, blend1_g_1_1_sum_2_0_13} + {blend1_g_1_1_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_2_13 = {2'd0, blend1_g_1_2_sum_2_0_13} + {blend1_g_1_2_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_3_13 = {2'd0, blend1_g_1_3_sum_2_0_13} + {blend1_g_1_3_sum_1_2_13, 3'd0};
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_first_13 = v1_is_odd_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-5.18: shifted
    wire [12:0] blend1_g_2_1_by_first_13 = blend1_g_2_1_either_first_13;
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_0_13 = v1_weight_of_0_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-5.18: shifted
    wire [12:0] blend1_g_2_1_by_0_13 = blend1_g_2_1_either_0_13;
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_1_13 = v1_weight_of_1_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-4.17: shifted
    wire [12:0] blend1_g_2_1_by_1_13 = blend1_g_2_1_either_1_13;
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_2_13 = v1_weight_of_2_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-3.16: shifted
    wire [12:0] blend1_g_2_1_by_2_13 = blend1_g_2_1_either_2_13;
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_3_13 = v1_weight_of_3_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-2.15: shifted
    wire [12:0] blend1_g_2_1_by_3_13 = blend1_g_2_1_either_3_13;
    // UQ0.13: either of both
    wire [12:0] blend1_g_2_1_either_4_13 = v1_weight_of_4_13 ? blend1_g_1_3_13 : blend1_g_1_2_13;
    // UQ-1.14: shifted
    wire [12:0] blend1_g_2_1_by_4_13 = blend1_g_2_1_either_4_13;
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_0_13 = {2'd0, blend1_b_1_0_sum_2_0_13} + {blend1_b_1_0_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_1_13 = {2'd0, blend1_b_1_1_sum_2_0_13} + {blend1_b_1_1_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_2_13 = {2'd0, blend1_b_1_2_sum_2_0_13} + {blend1_b_1_2_sum_1_2_13, 3'd0};
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_3_13 = {2'd0, blend1_b_1_3_sum_2_0_13} + {blend1_b_1_3_sum_1_2_13, 3'd0};
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_first_13 = v1_is_odd_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-5.18: shifted
    wire [12:0] blend1_b_2_1_by_first_13 = blend1_b_2_1_either_first_13;
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_0_13 = v1_weight_of_0_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-5.18: shifted
    wire [12:0] blend1_b_2_1_by_0_13 = blend1_b_2_1_either_0_13;
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_1_13 = v1_weight_of_1_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-4.17: shifted
    wire [12:0] blend1_b_2_1_by_1_13 = blend1_b_2_1_either_1_13;
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_2_13 = v1_weight_of_2_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-3.16: shifted
    wire [12:0] blend1_b_2_1_by_2_13 = blend1_b_2_1_either_2_13;
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_3_13 = v1_weight_of_3_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-2.15: shifted
    wire [12:0] blend1_b_2_1_by_3_13 = blend1_b_2_1_either_3_13;
    // UQ0.13: either of both
    wire [12:0] blend1_b_2_1_either_4_13 = v1_weight_of_4_13 ? blend1_b_1_3_13 : blend1_b_1_2_13;
    // UQ-1.14: shifted
    wire [12:0] blend1_b_2_1_by_4_13 = blend1_b_2_1_either_4_13;
    reg [17:0] in_gain1r_14;
    reg [17:0] in_gain1g_14;
    reg [17:0] in_gain1b_14;
    reg [17:0] nl1_14;
    reg [12:0] blend1_r_1_0_14;
    reg [12:0] blend1_r_1_1_14;
    reg [12:0] blend1_r_1_2_14;
    reg [12:0] blend1_r_1_3_14;
    reg [6:0] v1_odd_signed_14;
    reg [6:0] blend1_signed_14;
    reg [12:0] blend1_g_1_0_14;
    reg [12:0] blend1_g_1_1_14;
    reg [12:0] blend1_g_2_1_by_first_14;
    reg [12:0] blend1_g_2_1_by_0_14;
    reg [12:0] blend1_g_2_1_by_1_14;
    reg [12:0] blend1_g_2_1_by_2_14;
    reg [12:0] blend1_g_2_1_by_3_14;
    reg [12:0] blend1_g_2_1_by_4_14;
    reg [12:0] blend1_b_1_0_14;
    reg [12:0] blend1_b_1_1_14;
    reg [12:0] blend1_b_2_1_by_first_14;
    reg [12:0] blend1_b_2_1_by_0_14;
    reg [12:0] blend1_b_2_1_by_1_14;
    reg [12:0] blend1_b_2_1_by_2_14;
    reg [12:0] blend1_b_2_1_by_3_14;
    reg [12:0] blend1_b_2_1_by_4_14;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_14 <= in_gain1r_13;
            in_gain1g_14 <= in_gain1g_13;
            in_gain1b_14 <= in_gain1b_13;
            nl1_14 <= nl1_13;
            blend1_r_1_0_14 <= blend1_r_1_0_13;
            blend1_r_1_1_14 <= blend1_r_1_1_13;
            blend1_r_1_2_14 <= blend1_r_1_2_13;
            blend1_r_1_3_14 <= blend1_r_1_3_13;
            v1_odd_signed_14 <= v1_odd_signed_13;
            blend1_signed_14 <= blend1_signed_13;
            blend1_g_1_0_14 <= blend1_g_1_0_13;
            blend1_g_1_1_14 <= blend1_g_1_1_13;
            blend1_g_2_1_by_first_14 <= blend1_g_2_1_by_first_13;
            blend1_g_2_1_by_0_14 <= blend1_g_2_1_by_0_13;
            blend1_g_2_1_by_1_14 <= blend1_g_2_1_by_1_13;
            blend1_g_2_1_by_2_14 <= blend1_g_2_1_by_2_13;
            blend1_g_2_1_by_3_14 <= blend1_g_2_1_by_3_13;
            blend1_g_2_1_by_4_14 <= blend1_g_2_1_by_4_13;
            blend1_b_1_0_14 <= blend1_b_1_0_13;
            blend1_b_1_1_14 <= blend1_b_1_1_13;
            blend1_b_2_1_by_first_14 <= blend1_b_2_1_by_first_13;
            blend1_b_2_1_by_0_14 <= blend1_b_2_1_by_0_13;
            blend1_b_2_1_by_1_14 <= blend1_b_2_1_by_1_13;
            blend1_b_2_1_by_2_14 <= blend1_b_2_1_by_2_13;
            blend1_b_2_1_by_3_14 <= blend1_b_2_1_by_3_13;
            blend1_b_2_1_by_4_14 <= blend1_b_2_1_by_4_13;
        end
    end

    // ===== Stage 14: blend1_r_2_0_apart, blend1_r_2_1_apart, blend1_g_2_0_apart and 7 more
    // Q0.13: the difference
    wire [13:0] blend1_r_2_0_apart_14 = {1'd0, blend1_r_1_1_14} - {1'd0, blend1_r_1_0_14};
    // Q0.13: the difference
    wire [13:0] blend1_r_2_1_apart_14 = {1'd0, blend1_r_1_3_14} - {1'd0, blend1_r_1_2_14};
    // Q0.13: the difference
    wire [13:0] blend1_g_2_0_apart_14 = {1'd0, blend1_g_1_1_14} - {1'd0, blend1_g_1_0_14};
    // UQ-4.18: the sum of two
    wire [13:0] blend1_g_2_1_sum_1_0_14 =
        {1'd0, blend1_g_2_1_by_first_14} + {1'd0, blend1_g_2_1_by_0_14};
    // UQ-2.17: the sum of two
    wire [14:0] blend1_g_2_1_sum_1_1_14 =
        {2'd0, blend1_g_2_1_by_1_14} + {1'd0, blend1_g_2_1_by_2_14, 1'd0};
    // UQ0.15: the sum of two
    wire [14:0] blend1_g_2_1_sum_1_2_14 =
        {2'd0, blend1_g_2_1_by_3_14} + {1'd0, blend1_g_2_1_by_4_14, 1'd0};
    // Q0.13: the difference
    wire [13:0] blend1_b_2_0_apart_14 = {1'd0, blend1_b_1_1_14} - {1'd0, blend1_b_1_0_14};
    // UQ-4.18: the sum of two
    wire [13:0] blend1_b_2_1_sum_1_0_14 =
        {1'd0, blend1_b_2_1_by_first_14} + {1'd0, blend1_b_2_1_by_0_14};
    // UQ-2.17: the sum of two
    wire [14:0] blend1_b_2_1_sum_1_1_14 =
        {2'd0, blend1_b_2_1_by_1_14} + {1'd0, blend1_b_2_1_by_2_14, 1'd0};
    // UQ0.15: the sum of two
    wire [14:0] blend1_b_2_1_sum_1_2_14 =
        {2'd0, blend1_b_2_1_by_3_14} + {1'd0, blend1_b_2_1_by_4_14, 1'd0};
    reg [17:0] in_gain1r_15;
    reg [17:0] in_gain1g_15;
    reg [17:0] in_gain1b_15;
    reg [17:0] nl1_15;
    reg [12:0] blend1_r_1_0_15;
    reg [12:0] blend1_r_1_2_15;
    reg [13:0] blend1_r_2_0_apart_15;
    reg [6:0] v1_odd_signed_15;
    reg [13:0] blend1_r_2_1_apart_15;
    reg [6:0] blend1_signed_15;
    reg [12:0] blend1_g_1_0_15;
    reg [13:0] blend1_g_2_0_apart_15;
    reg [13:0] blend1_g_2_1_sum_1_0_15;
    reg [14:0] blend1_g_2_1_sum_1_1_15;
    reg [14:0] blend1_g_2_1_sum_1_2_15;
    reg [12:0] blend1_b_1_0_15;
    reg [13:0] blend1_b_2_0_apart_15;
    reg [13:0] blend1_b_2_1_sum_1_0_15;
    reg [14:0] blend1_b_2_1_sum_1_1_15;
    reg [14:0] blend1_b_2_1_sum_1_2_15;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_15 <= in_gain1r_14;
            in_gain1g_15 <= in_gain1g_14;
            in_gain1b_15 <= in_gain1b_14;
            nl1_15 <= nl1_14;
            blend1_r_1_0_15 <= blend1_r_1_0_14;
            blend1_r_1_2_15 <= blend1_r_1_2_14;
            blend1_r_2_0_apart_15 <= blend1_r_2_0_apart_14;
            v1_odd_signed_15 <= v1_odd_signed_14;
            blend1_r_2_1_apart_15 <= blend1_r_2_1_apart_14;
            blend1_signed_15 <= blend1_signed_14;
            blend1_g_1_0_15 <= blend1_g_1_0_14;
            blend1_g_2_0_apart_15 <= blend1_g_2_0_apart_14;
            blend1_g_2_1_sum_1_0_15 <= blend1_g_2_1_sum_1_0_14;
            blend1_g_2_1_sum_1_1_15 <= blend1_g_2_1_sum_1_1_14;
            blend1_g_2_1_sum_1_2_15 <= blend1_g_2_1_sum_1_2_14;
            blend1_b_1_0_15 <= blend1_b_1_0_14;
            blend1_b_2_0_apart_15 <= blend1_b_2_0_apart_14;
            blend1_b_2_1_sum_1_0_15 <= blend1_b_2_1_sum_1_0_14;
            blend1_b_2_1_sum_1_1_15 <= blend1_b_2_1_sum_1_1_14;
            blend1_b_2_1_sum_1_2_15 <= blend1_b_2_1_sum_1_2_14;
        end
    end

    // ===== Stage 15: blend1_r_2_0_part, blend1_r_2_1_part, blend1_g_2_0_part and 3 more
    // Q2.18: its part
    wire [20:0] blend1_r_2_0_part_15 = $signed(blend1_r_2_0_apart_15) * $signed(v1_odd_signed_15);
    // Q2.18: its part
    wire [20:0] blend1_r_2_1_part_15 = $signed(blend1_r_2_1_apart_15) * $signed(v1_odd_signed_15);
    // Q2.18: its part
    wire [20:0] blend1_g_2_0_part_15 = $signed(blend1_g_2_0_apart_15) * $signed(v1_odd_signed_15);
    // UQ-2.18: the sum of two
    wire [15:0] blend1_g_2_1_sum_2_0_15 =
        {2'd0, blend1_g_2_1_sum_1_0_15} + {blend1_g_2_1_sum_1_1_15, 1'd0};
    // Q2.18: its part
    wire [20:0] blend1_b_2_0_part_15 = $signed(blend1_b_2_0_apart_15) * $signed(v1_odd_signed_15);
    // UQ-2.18: the sum of two
    wire [15:0] blend1_b_2_1_sum_2_0_15 =
        {2'd0, blend1_b_2_1_sum_1_0_15} + {blend1_b_2_1_sum_1_1_15, 1'd0};
    reg [17:0] in_gain1r_16;
    reg [17:0] in_gain1g_16;
    reg [17:0] in_gain1b_16;
    reg [17:0] nl1_16;
    reg [12:0] blend1_r_1_0_16;
    reg [12:0] blend1_r_1_2_16;
    reg [20:0] blend1_r_2_0_part_16;
    reg [20:0] blend1_r_2_1_part_16;
    reg [6:0] blend1_signed_16;
    reg [12:0] blend1_g_1_0_16;
    reg [20:0] blend1_g_2_0_part_16;
    reg [14:0] blend1_g_2_1_sum_1_2_16;
    reg [15:0] blend1_g_2_1_sum_2_0_16;
    reg [12:0] blend1_b_1_0_16;
    reg [20:0] blend1_b_2_0_part_16;
    reg [14:0] blend1_b_2_1_sum_1_2_16;
    reg [15:0] blend1_b_2_1_sum_2_0_16;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_16 <= in_gain1r_15;
            in_gain1g_16 <= in_gain1g_15;
            in_gain1b_16 <= in_gain1b_15;
            nl1_16 <= nl1_15;
            blend1_r_1_0_16 <= blend1_r_1_0_15;
            blend1_r_1_2_16 <= blend1_r_1_2_15;
            blend1_r_2_0_part_16 <= blend1_r_2_0_part_15;
            blend1_r_2_1_part_16 <= blend1_r_2_1_part_15;
            blend1_signed_16 <= blend1_signed_15;
            blend1_g_1_0_16 <= blend1_g_1_0_15;
            blend1_g_2_0_part_16 <= blend1_g_2_0_part_15;
            blend1_g_2_1_sum_1_2_16 <= blend1_g_2_1_sum_1_2_15;
            blend1_g_2_1_sum_2_0_16 <= blend1_g_2_1_sum_2_0_15;
            blend1_b_1_0_16 <= blend1_b_1_0_15;
            blend1_b_2_0_part_16 <= blend1_b_2_0_part_15;
            blend1_b_2_1_sum_1_2_16 <= blend1_b_2_1_sum_1_2_15;
            blend1_b_2_1_sum_2_0_16 <= blend1_b_2_1_sum_2_0_15;
        end
    end

    // ===== Stage 16: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    // UQ0.18: two neighbours
    wire [17:0] blend1_r_2_0_16 = {blend1_r_1_0_16, 5'd0} + blend1_r_2_0_part_16[17:0];
    // UQ0.18: two neighbours
    wire [17:0] blend1_r_2_1_16 = {blend1_r_1_2_16, 5'd0} + blend1_r_2_1_part_16[17:0];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_r_2_0_cut_16 = blend1_r_2_0_16[17:1];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_r_2_1_cut_16 = blend1_r_2_1_16[17:1];
    // UQ0.18: two neighbours
    wire [17:0] blend1_g_2_0_16 = {blend1_g_1_0_16, 5'd0} + blend1_g_2_0_part_16[17:0];
    // UQ0.18: two neighbours
    wire [17:0] blend1_g_2_1_16 = {2'd0, blend1_g_2_1_sum_2_0_16} + {blend1_g_2_1_sum_1_2_16, 3'd0};
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_g_2_0_cut_16 = blend1_g_2_0_16[17:1];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_g_2_1_cut_16 = blend1_g_2_1_16[17:1];
    // UQ0.18: two neighbours
    wire [17:0] blend1_b_2_0_16 = {blend1_b_1_0_16, 5'd0} + blend1_b_2_0_part_16[17:0];
    // UQ0.18: two neighbours
    wire [17:0] blend1_b_2_1_16 = {2'd0, blend1_b_2_1_sum_2_0_16} + {blend1_b_2_1_sum_1_2_16, 3'd0};
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_b_2_0_cut_16 = blend1_b_2_0_16[17:1];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_b_2_1_cut_16 = blend1_b_2_1_16[17:1];
    reg [17:0] in_gain1r_17;
    reg [17:0] in_gain1g_17;
    reg [17:0] in_gain1b_17;
    reg [17:0] nl1_17;
    reg [16:0] blend1_r_2_0_cut_17;
    reg [16:0] blend1_r_2_1_cut_17;
    reg [6:0] blend1_signed_17;
    reg [16:0] blend1_g_2_0_cut_17;
    reg [16:0] blend1_g_2_1_cut_17;
    reg [16:0] blend1_b_2_0_cut_17;
    reg [16:0] blend1_b_2_1_cut_17;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_17 <= in_gain1r_16;
            in_gain1g_17 <= in_gain1g_16;
            in_gain1b_17 <= in_gain1b_16;
            nl1_17 <= nl1_16;
            blend1_r_2_0_cut_17 <= blend1_r_2_0_cut_16;
            blend1_r_2_1_cut_17 <= blend1_r_2_1_cut_16;
            blend1_signed_17 <= blend1_signed_16;
            blend1_g_2_0_cut_17 <= blend1_g_2_0_cut_16;
            blend1_g_2_1_cut_17 <= blend1_g_2_1_cut_16;
            blend1_b_2_0_cut_17 <= blend1_b_2_0_cut_16;
            blend1_b_2_1_cut_17 <= blend1_b_2_1_cut_16;
        end
    end

    // ===== Stage 17: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    // Q0.17: the difference
    wire [17:0] blend1_r_3_0_apart_17 = {1'd0, blend1_r_2_1_cut_17} - {1'd0, blend1_r_2_0_cut_17};
    // Q0.17: the difference
    wire [17:0] blend1_g_3_0_apart_17 = {1'd0, blend1_g_2_1_cut_17} - {1'd0, blend1_g_2_0_cut_17};
    // Q0.17: the difference
    wire [17:0] blend1_b_3_0_apart_17 = {1'd0, blend1_b_2_1_cut_17} - {1'd0, blend1_b_2_0_cut_17};
    reg [17:0] in_gain1r_18;
    reg [17:0] in_gain1g_18;
    reg [17:0] in_gain1b_18;
    reg [17:0] nl1_18;
    reg [16:0] blend1_r_2_0_cut_18;
    reg [17:0] blend1_r_3_0_apart_18;
    reg [6:0] blend1_signed_18;
    reg [16:0] blend1_g_2_0_cut_18;
    reg [17:0] blend1_g_3_0_apart_18;
    reg [16:0] blend1_b_2_0_cut_18;
    reg [17:0] blend1_b_3_0_apart_18;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_18 <= in_gain1r_17;
            in_gain1g_18 <= in_gain1g_17;
            in_gain1b_18 <= in_gain1b_17;
            nl1_18 <= nl1_17;
            blend1_r_2_0_cut_18 <= blend1_r_2_0_cut_17;
            blend1_r_3_0_apart_18 <= blend1_r_3_0_apart_17;
            blend1_signed_18 <= blend1_signed_17;
            blend1_g_2_0_cut_18 <= blend1_g_2_0_cut_17;
            blend1_g_3_0_apart_18 <= blend1_g_3_0_apart_17;
            blend1_b_2_0_cut_18 <= blend1_b_2_0_cut_17;
            blend1_b_3_0_apart_18 <= blend1_b_3_0_apart_17;
        end
    end

    // ===== Stage 18: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    // Q2.22: its part
    wire [24:0] blend1_r_3_0_part_18 = $signed(blend1_r_3_0_apart_18) * $signed(blend1_signed_18);
    // Q2.22: its part
    wire [24:0] blend1_g_3_0_part_18 = $signed(blend1_g_3_0_apart_18) * $signed(blend1_signed_18);
    // Q2.22: its part
    wire [24:0] blend1_b_3_0_part_18 = $signed(blend1_b_3_0_apart_18) * $signed(blend1_signed_18);
    reg [17:0] in_gain1r_19;
    reg [17:0] in_gain1g_19;
    reg [17:0] in_gain1b_19;
    reg [17:0] nl1_19;
    reg [16:0] blend1_r_2_0_cut_19;
    reg [24:0] blend1_r_3_0_part_19;
    reg [16:0] blend1_g_2_0_cut_19;
    reg [24:0] blend1_g_3_0_part_19;
    reg [16:0] blend1_b_2_0_cut_19;
    reg [24:0] blend1_b_3_0_part_19;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_19 <= in_gain1r_18;
            in_gain1g_19 <= in_gain1g_18;
            in_gain1b_19 <= in_gain1b_18;
            nl1_19 <= nl1_18;
            blend1_r_2_0_cut_19 <= blend1_r_2_0_cut_18;
            blend1_r_3_0_part_19 <= blend1_r_3_0_part_18;
            blend1_g_2_0_cut_19 <= blend1_g_2_0_cut_18;
            blend1_g_3_0_part_19 <= blend1_g_3_0_part_18;
            blend1_b_2_0_cut_19 <= blend1_b_2_0_cut_18;
            blend1_b_3_0_part_19 <= blend1_b_3_0_part_18;
        end
    end

    // ===== Stage 19: registers only
    reg [17:0] in_gain1r_20;
    reg [17:0] in_gain1g_20;
    reg [17:0] in_gain1b_20;
    reg [17:0] nl1_20;
    reg [16:0] blend1_r_2_0_cut_20;
    reg [24:0] blend1_r_3_0_part_20;
    reg [16:0] blend1_g_2_0_cut_20;
    reg [24:0] blend1_g_3_0_part_20;
    reg [16:0] blend1_b_2_0_cut_20;
    reg [24:0] blend1_b_3_0_part_20;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_20 <= in_gain1r_19;
            in_gain1g_20 <= in_gain1g_19;
            in_gain1b_20 <= in_gain1b_19;
            nl1_20 <= nl1_19;
            blend1_r_2_0_cut_20 <= blend1_r_2_0_cut_19;
            blend1_r_3_0_part_20 <= blend1_r_3_0_part_19;
            blend1_g_2_0_cut_20 <= blend1_g_2_0_cut_19;
            blend1_g_3_0_part_20 <= blend1_g_3_0_part_19;
            blend1_b_2_0_cut_20 <= blend1_b_2_0_cut_19;
            blend1_b_3_0_part_20 <= blend1_b_3_0_part_19;
        end
    end

    // ===== Stage 20: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    // UQ0.22: two bands
    wire [21:0] blend1_r_3_0_20 = {blend1_r_2_0_cut_20, 5'd0} + blend1_r_3_0_part_20[21:0];
    // UQ0.18: the blended code
    wire [17:0] root1_r_20 = blend1_r_3_0_20[21:4];
    // UQ0.22: two bands
    wire [21:0] blend1_g_3_0_20 = {blend1_g_2_0_cut_20, 5'd0} + blend1_g_3_0_part_20[21:0];
    // UQ0.18: the blended code
    wire [17:0] root1_g_20 = blend1_g_3_0_20[21:4];
    // UQ0.22: two bands
    wire [21:0] blend1_b_3_0_20 = {blend1_b_2_0_cut_20, 5'd0} + blend1_b_3_0_part_20[21:0];
    // UQ0.18: the blended code
    wire [17:0] root1_b_20 = blend1_b_3_0_20[21:4];
    reg [17:0] in_gain1r_21;
    reg [17:0] in_gain1g_21;
    reg [17:0] in_gain1b_21;
    reg [17:0] nl1_21;
    reg [17:0] root1_r_21;
    reg [17:0] root1_g_21;
    reg [17:0] root1_b_21;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_21 <= in_gain1r_20;
            in_gain1g_21 <= in_gain1g_20;
            in_gain1b_21 <= in_gain1b_20;
            nl1_21 <= nl1_20;
            root1_r_21 <= root1_r_20;
            root1_g_21 <= root1_g_20;
            root1_b_21 <= root1_b_20;
        end
    end

    // ===== Stage 21: square1_r_exact, square1_g_exact, square1_b_exact
    // UQ0.36: its square
    wire [35:0] square1_r_exact_21 = root1_r_21 * root1_r_21;
    // UQ0.18: rounded down
    wire [17:0] square1_r_21 = square1_r_exact_21[35:18];
    // UQ0.36: its square
    wire [35:0] square1_g_exact_21 = root1_g_21 * root1_g_21;
    // UQ0.18: rounded down
    wire [17:0] square1_g_21 = square1_g_exact_21[35:18];
    // UQ0.36: its square
    wire [35:0] square1_b_exact_21 = root1_b_21 * root1_b_21;
    // UQ0.18: rounded down
    wire [17:0] square1_b_21 = square1_b_exact_21[35:18];
    reg [17:0] in_gain1r_22;
    reg [17:0] in_gain1g_22;
    reg [17:0] in_gain1b_22;
    reg [17:0] nl1_22;
    reg [17:0] square1_r_22;
    reg [17:0] square1_g_22;
    reg [17:0] square1_b_22;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_22 <= in_gain1r_21;
            in_gain1g_22 <= in_gain1g_21;
            in_gain1b_22 <= in_gain1b_21;
            nl1_22 <= nl1_21;
            square1_r_22 <= square1_r_21;
            square1_g_22 <= square1_g_21;
            square1_b_22 <= square1_b_21;
        end
    end

    // ===== Stage 22: registers only
    reg [17:0] in_gain1r_23;
    reg [17:0] in_gain1g_23;
    reg [17:0] in_gain1b_23;
    reg [17:0] nl1_23;
    reg [17:0] square1_r_23;
    reg [17:0] square1_g_23;
    reg [17:0] square1_b_23;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_23 <= in_gain1r_22;
            in_gain1g_23 <= in_gain1g_22;
            in_gain1b_23 <= in_gain1b_22;
            nl1_23 <= nl1_22;
            square1_r_23 <= square1_r_22;
            square1_g_23 <= square1_g_22;
            square1_b_23 <= square1_b_22;
        end
    end

    // ===== Stage 23: lit1_r_exact, lit1_g_exact, lit1_b_exact
    // UQ7.29: n.l times the square
    wire [35:0] lit1_r_exact_23 = nl1_23 * square1_r_23;
    // UQ7.11: rounded down
    wire [17:0] lit1_r_23 = lit1_r_exact_23[35:18];
    // UQ7.29: n.l times the square
    wire [35:0] lit1_g_exact_23 = nl1_23 * square1_g_23;
    // UQ7.11: rounded down
    wire [17:0] lit1_g_23 = lit1_g_exact_23[35:18];
    // UQ7.29: n.l times the square
    wire [35:0] lit1_b_exact_23 = nl1_23 * square1_b_23;
    // UQ7.11: rounded down
    wire [17:0] lit1_b_23 = lit1_b_exact_23[35:18];
    reg [17:0] in_gain1r_24;
    reg [17:0] in_gain1g_24;
    reg [17:0] in_gain1b_24;
    reg [17:0] lit1_r_24;
    reg [17:0] lit1_g_24;
    reg [17:0] lit1_b_24;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_24 <= in_gain1r_23;
            in_gain1g_24 <= in_gain1g_23;
            in_gain1b_24 <= in_gain1b_23;
            lit1_r_24 <= lit1_r_23;
            lit1_g_24 <= lit1_g_23;
            lit1_b_24 <= lit1_b_23;
        end
    end

    // ===== Stage 24: registers only
    reg [17:0] in_gain1r_25;
    reg [17:0] in_gain1g_25;
    reg [17:0] in_gain1b_25;
    reg [17:0] lit1_r_25;
    reg [17:0] lit1_g_25;
    reg [17:0] lit1_b_25;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_25 <= in_gain1r_24;
            in_gain1g_25 <= in_gain1g_24;
            in_gain1b_25 <= in_gain1b_24;
            lit1_r_25 <= lit1_r_24;
            lit1_g_25 <= lit1_g_24;
            lit1_b_25 <= lit1_b_24;
        end
    end

    // ===== Stage 25: light1_r_exact, light1_g_exact, light1_b_exact
    // UQ8.28: times the gain
    wire [35:0] light1_r_exact_25 = lit1_r_25 * in_gain1r_25;
    // UQ8.17: rounded down
    wire [24:0] light1_r_25 = light1_r_exact_25[35:11];
    // UQ8.28: times the gain
    wire [35:0] light1_g_exact_25 = lit1_g_25 * in_gain1g_25;
    // UQ8.17: rounded down
    wire [24:0] light1_g_25 = light1_g_exact_25[35:11];
    // UQ8.28: times the gain
    wire [35:0] light1_b_exact_25 = lit1_b_25 * in_gain1b_25;
    // UQ8.17: rounded down
    wire [24:0] light1_b_25 = light1_b_exact_25[35:11];
    reg [24:0] light1_r_26;
    reg [24:0] light1_g_26;
    reg [24:0] light1_b_26;
    always @(posedge clk) begin
        if (ce) begin
            light1_r_26 <= light1_r_25;
            light1_g_26 <= light1_g_25;
            light1_b_26 <= light1_b_25;
        end
    end

    // ===== Stage 26: sum_r, sum_g, sum_b
    // UQ1.17: kept at 1.0
    wire [17:0] sum_r_26 = (|light1_r_26[24:17]) ? 18'h20000 : light1_r_26[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_g_26 = (|light1_g_26[24:17]) ? 18'h20000 : light1_g_26[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_b_26 = (|light1_b_26[24:17]) ? 18'h20000 : light1_b_26[17:0];
    reg [17:0] sum_r_27;
    reg [17:0] sum_g_27;
    reg [17:0] sum_b_27;
    always @(posedge clk) begin
        if (ce) begin
            sum_r_27 <= sum_r_26;
            sum_g_27 <= sum_g_26;
            sum_b_27 <= sum_b_26;
        end
    end

    assign out_valid = valid[27];
    assign out_sum_r = sum_r_27;
    assign out_sum_g = sum_g_27;
    assign out_sum_b = sum_b_27;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nl1_x_exact_0[9:0],
                    nl1_y_exact_0[9:0],
                    nl1_z_exact_0[9:0],
                    nl1_xyz_2[1:0],
                    nl1_up_5[8:0],
                    band1_next_1[0],
                    v1_x_exact_0[19:0],
                    v1_y_exact_0[19:0],
                    v1_place_2[2:0],
                    v1_next_5[0],
                    u1_x_exact_0[19:0],
                    u1_y_exact_0[19:0],
                    u1_z_exact_0[19:0],
                    u1_place_3[2:0],
                    u1_next_6[0],
                    blend1_r_2_0_part_16[20:18],
                    blend1_r_2_0_16[0],
                    blend1_r_2_1_part_16[20:18],
                    blend1_r_2_1_16[0],
                    blend1_r_3_0_part_20[24:22],
                    blend1_r_3_0_20[3:0],
                    square1_r_exact_21[17:0],
                    lit1_r_exact_23[17:0],
                    light1_r_exact_25[10:0],
                    blend1_g_2_0_part_16[20:18],
                    blend1_g_2_0_16[0],
                    blend1_g_2_1_16[0],
                    blend1_g_3_0_part_20[24:22],
                    blend1_g_3_0_20[3:0],
                    square1_g_exact_21[17:0],
                    lit1_g_exact_23[17:0],
                    light1_g_exact_25[10:0],
                    blend1_b_2_0_part_16[20:18],
                    blend1_b_2_0_16[0],
                    blend1_b_2_1_16[0],
                    blend1_b_3_0_part_20[24:22],
                    blend1_b_3_0_20[3:0],
                    square1_b_exact_21[17:0],
                    lit1_b_exact_23[17:0],
                    light1_b_exact_25[10:0]};

endmodule

`default_nettype wire
