// image_paper: image-based block of ggx (paper, 6 sphere images of 64 x 64 texels), 1 light a clock, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec e91d917992f4fdd5. Generated; the core is yours to use under any terms.
//
//   in_nx         Q1.16   x of the unit normal, the viewer at +z
//   in_ny         Q1.16   y of the unit normal, the viewer at +z
//   in_nz         Q1.16   z of the unit normal, the viewer at +z
//   in_u1x        Q1.16   x of row 1 of the turn to light 1's half vector
//   in_u1y        Q1.16   y of row 1 of the turn to light 1's half vector
//   in_u1z        Q1.16   z of row 1 of the turn to light 1's half vector
//   in_v1x        Q1.16   x of row 2 of the turn to light 1's half vector
//   in_v1y        Q1.16   y of row 2 of the turn to light 1's half vector
//   in_band1      UQ3.0   image of texels below light 1's angle
//   in_blend1     UQ1.6   weight of the odd one of this image and the next, at most 1
//   in_turn1_even Q0.14   half of the way from light 1 to its even image, in right angles
//   in_turn1_odd  Q0.14   half of the way from light 1 to its odd image, in right angles
//   in_alone1     UQ1.0   1 where a single image is looked up for light 1
//   in_shift1     UQ3.0   exponent of light 1's gain
//   in_gain1r     UQ1.17  red of light 1's gain
//   in_gain1g     UQ1.17  green of light 1's gain
//   in_gain1b     UQ1.17  blue of light 1's gain
//   out_sum_r     UQ1.17  red of these lights, at most 1.0
//   out_sum_g     UQ1.17  green of these lights, at most 1.0
//   out_sum_b     UQ1.17  blue of these lights, at most 1.0
//
// Latency 52 clocks, one result a clock.
// Pictures of a sphere against the exact reflectance, lit from 34 angles:
//   41.6 dB in the mean, 27.1 dB at the worst angle.

`timescale 1ns / 1ps
`default_nettype none

module image_paper #(
    // Path of the memory texels_1_even_even_even, read by $readmemh.
    parameter TEXELS_1_EVEN_EVEN_EVEN_FILE = "rom/image_paper_texels_1_even_even_even.mem",
    // Path of the memory texels_1_even_even_odd, read by $readmemh.
    parameter TEXELS_1_EVEN_EVEN_ODD_FILE = "rom/image_paper_texels_1_even_even_odd.mem",
    // Path of the memory texels_1_even_odd_even, read by $readmemh.
    parameter TEXELS_1_EVEN_ODD_EVEN_FILE = "rom/image_paper_texels_1_even_odd_even.mem",
    // Path of the memory texels_1_even_odd_odd, read by $readmemh.
    parameter TEXELS_1_EVEN_ODD_ODD_FILE = "rom/image_paper_texels_1_even_odd_odd.mem",
    // Path of the memory texels_1_odd_even_even, read by $readmemh.
    parameter TEXELS_1_ODD_EVEN_EVEN_FILE = "rom/image_paper_texels_1_odd_even_even.mem",
    // Path of the memory texels_1_odd_even_odd, read by $readmemh.
    parameter TEXELS_1_ODD_EVEN_ODD_FILE = "rom/image_paper_texels_1_odd_even_odd.mem",
    // Path of the memory texels_1_odd_odd_even, read by $readmemh.
    parameter TEXELS_1_ODD_ODD_EVEN_FILE = "rom/image_paper_texels_1_odd_odd_even.mem",
    // Path of the memory texels_1_odd_odd_odd, read by $readmemh.
    parameter TEXELS_1_ODD_ODD_ODD_FILE = "rom/image_paper_texels_1_odd_odd_odd.mem",
    // Path of the memory roots_1, read by $readmemh.
    parameter ROOTS_1_FILE = "rom/image_paper_roots_1.mem",
    // Path of the memory sines_1_even, read by $readmemh.
    parameter SINES_1_EVEN_FILE = "rom/image_paper_sines_1_even.mem",
    // Path of the memory sines_1_odd, read by $readmemh.
    parameter SINES_1_ODD_FILE = "rom/image_paper_sines_1_odd.mem"
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
    // UQ3.0: image of texels below light 1's angle
    input  wire [2:0] in_band1,
    // UQ1.6: weight of the odd one of this image and the next, at most 1
    input  wire [6:0] in_blend1,
    // Q0.14: half of the way from light 1 to its even image, in right angles
    input  wire [14:0] in_turn1_even,
    // Q0.14: half of the way from light 1 to its odd image, in right angles
    input  wire [14:0] in_turn1_odd,
    // UQ1.0: 1 where a single image is looked up for light 1
    input  wire in_alone1,
    // UQ3.0: exponent of light 1's gain
    input  wire [2:0] in_shift1,
    // UQ1.17: red of light 1's gain
    input  wire [17:0] in_gain1r,
    // UQ1.17: green of light 1's gain
    input  wire [17:0] in_gain1g,
    // UQ1.17: blue of light 1's gain
    input  wire [17:0] in_gain1b,
    // the other outputs are a result: in_valid, 52 enabled clocks later
    output wire        out_valid,
    // UQ1.17: red of these lights, at most 1.0
    output wire [17:0] out_sum_r,
    // UQ1.17: green of these lights, at most 1.0
    output wire [17:0] out_sum_g,
    // UQ1.17: blue of these lights, at most 1.0
    output wire [17:0] out_sum_b
);

    // ===== Valid chain
    reg [52:1] valid;
    initial valid = 52'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 52'd0;
        end else if (ce) begin
            valid <= {valid[51:1], in_valid};
        end
    end

    // ===== Stage 0: nz_kept, shift1, blend1, band1_kept, v1_x_exact and 10 more
    // UQ1.16: n.v, not below 0
    wire [16:0] nz_kept_0 = in_nz[17] ? 17'h00000 : in_nz[16:0];
    // UQ1.0: n.v > 0
    wire seen_0 = |nz_kept_0;
    // UQ1.0: the normal is turned away from the viewer
    wire hidden_0 = ~seen_0;
    // UQ3.0: at most the greatest
    wire [2:0] shift1_0 = (|in_shift1[2]) ? 3'h4 : in_shift1;
    // UQ1.6: the weight of the odd band, at most 1
    wire [6:0] blend1_0 = (|in_blend1[6]) ? 7'h40 : in_blend1;
    // UQ3.0: at most the last
    wire [2:0] band1_kept_0 = (in_band1 > 3'h5) ? 3'h5 : in_band1;
    // UQ3.-1: its leading bits
    wire [1:0] band1_odd_high_0 = band1_kept_0[2:1];
    // UQ2.0: the odd one of both
    wire [1:0] band1_odd_0 = band1_odd_high_0;
    // Q3.32: the turned normal
    wire [35:0] v1_x_exact_0 = $signed(in_nx) * $signed(in_v1x);
    // Q3.14: rounded down
    wire [17:0] v1_x_0 = v1_x_exact_0[35:18];
    // Q3.32: the turned normal
    wire [35:0] v1_y_exact_0 = $signed(in_ny) * $signed(in_v1y);
    // Q3.14: rounded down
    wire [17:0] v1_y_0 = v1_y_exact_0[35:18];
    // Q3.32: x, turned back
    wire [35:0] x1_x_exact_0 = $signed(in_nx) * $signed(in_v1y);
    // Q3.14: rounded down
    wire [17:0] x1_x_0 = x1_x_exact_0[35:18];
    // Q3.32: x, turned back
    wire [35:0] x1_y_exact_0 = $signed(in_ny) * $signed(in_v1x);
    // Q3.14: rounded down
    wire [17:0] x1_y_0 = x1_y_exact_0[35:18];
    // Q3.32: the turned normal
    wire [35:0] u1_x_exact_0 = $signed(in_nx) * $signed(in_u1x);
    // Q3.14: rounded down
    wire [17:0] u1_x_0 = u1_x_exact_0[35:18];
    // Q3.32: the turned normal
    wire [35:0] u1_y_exact_0 = $signed(in_ny) * $signed(in_u1y);
    // Q3.14: rounded down
    wire [17:0] u1_y_0 = u1_y_exact_0[35:18];
    // Q3.32: the turned normal
    wire [35:0] u1_z_exact_0 = $signed(in_nz) * $signed(in_u1z);
    // Q3.14: rounded down
    wire [17:0] u1_z_0 = u1_z_exact_0[35:18];
    // UQ1.0: whether one image is alone
    wire alone1_0 = |in_alone1;
    // UQ1.0: whether it turns to negative x
    wire back1_even_0 = $signed(15'h0000) > $signed(in_turn1_even);
    // UQ6.6: the end of the row on that side
    wire [11:0] end1_even_0 = back1_even_0 ? 12'h000 : 12'hfc0;
    // UQ1.0: whether it turns to negative x
    wire back1_odd_0 = $signed(15'h0000) > $signed(in_turn1_odd);
    // UQ6.6: the end of the row on that side
    wire [11:0] end1_odd_0 = back1_odd_0 ? 12'h000 : 12'hfc0;
    // UQ7.-5: the first of them
    wire [1:0] texels1_10_0 = band1_odd_0;
    // UQ7.-5: the first of them
    wire [1:0] texels1_10_v2_0 = band1_odd_0;
    // UQ7.-5: the first of them
    wire [1:0] texels1_11_0 = band1_odd_0;
    // UQ7.-5: the first of them
    wire [1:0] texels1_11_v2_0 = band1_odd_0;
    // Q1.6: a sign bit for the signed product
    wire [7:0] blend1_signed_0 = {1'd0, blend1_0};
    // UQ1.0: a bit of the shift
    wire square1_r_by_1_0 = shift1_0[0];
    // UQ2.-1: a bit of the shift
    wire square1_r_by_2_0 = shift1_0[1];
    // UQ2.0: its weight
    wire [1:0] square1_r_amount_2_0 = {square1_r_by_2_0, 1'd0};
    // UQ3.-2: a bit of the shift
    wire square1_r_by_4_0 = shift1_0[2];
    // UQ1.0: a bit of the shift
    wire square1_g_by_1_0 = shift1_0[0];
    // UQ2.-1: a bit of the shift
    wire square1_g_by_2_0 = shift1_0[1];
    // UQ2.0: its weight
    wire [1:0] square1_g_amount_2_0 = {square1_g_by_2_0, 1'd0};
    // UQ3.-2: a bit of the shift
    wire square1_g_by_4_0 = shift1_0[2];
    // UQ1.0: a bit of the shift
    wire square1_b_by_1_0 = shift1_0[0];
    // UQ2.-1: a bit of the shift
    wire square1_b_by_2_0 = shift1_0[1];
    // UQ2.0: its weight
    wire [1:0] square1_b_amount_2_0 = {square1_b_by_2_0, 1'd0};
    // UQ3.-2: a bit of the shift
    wire square1_b_by_4_0 = shift1_0[2];
    reg [17:0] in_nz_1;
    reg [14:0] in_turn1_even_1;
    reg [14:0] in_turn1_odd_1;
    reg [17:0] in_gain1r_1;
    reg [17:0] in_gain1g_1;
    reg [17:0] in_gain1b_1;
    reg hidden_1;
    reg [2:0] band1_kept_1;
    reg [17:0] v1_x_1;
    reg [17:0] v1_y_1;
    reg [17:0] x1_x_1;
    reg [17:0] x1_y_1;
    reg [17:0] u1_x_1;
    reg [17:0] u1_y_1;
    reg [17:0] u1_z_1;
    reg alone1_1;
    reg [11:0] end1_even_1;
    reg [11:0] end1_odd_1;
    reg [1:0] texels1_10_1;
    reg [1:0] texels1_10_v2_1;
    reg [1:0] texels1_11_1;
    reg [1:0] texels1_11_v2_1;
    reg [7:0] blend1_signed_1;
    reg square1_r_by_1_1;
    reg [1:0] square1_r_amount_2_1;
    reg square1_r_by_4_1;
    reg square1_g_by_1_1;
    reg [1:0] square1_g_amount_2_1;
    reg square1_g_by_4_1;
    reg square1_b_by_1_1;
    reg [1:0] square1_b_amount_2_1;
    reg square1_b_by_4_1;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_1 <= in_nz;
            in_turn1_even_1 <= in_turn1_even;
            in_turn1_odd_1 <= in_turn1_odd;
            in_gain1r_1 <= in_gain1r;
            in_gain1g_1 <= in_gain1g;
            in_gain1b_1 <= in_gain1b;
            hidden_1 <= hidden_0;
            band1_kept_1 <= band1_kept_0;
            v1_x_1 <= v1_x_0;
            v1_y_1 <= v1_y_0;
            x1_x_1 <= x1_x_0;
            x1_y_1 <= x1_y_0;
            u1_x_1 <= u1_x_0;
            u1_y_1 <= u1_y_0;
            u1_z_1 <= u1_z_0;
            alone1_1 <= alone1_0;
            end1_even_1 <= end1_even_0;
            end1_odd_1 <= end1_odd_0;
            texels1_10_1 <= texels1_10_0;
            texels1_10_v2_1 <= texels1_10_v2_0;
            texels1_11_1 <= texels1_11_0;
            texels1_11_v2_1 <= texels1_11_v2_0;
            blend1_signed_1 <= blend1_signed_0;
            square1_r_by_1_1 <= square1_r_by_1_0;
            square1_r_amount_2_1 <= square1_r_amount_2_0;
            square1_r_by_4_1 <= square1_r_by_4_0;
            square1_g_by_1_1 <= square1_g_by_1_0;
            square1_g_amount_2_1 <= square1_g_amount_2_0;
            square1_g_by_4_1 <= square1_g_by_4_0;
            square1_b_by_1_1 <= square1_b_by_1_0;
            square1_b_amount_2_1 <= square1_b_amount_2_0;
            square1_b_by_4_1 <= square1_b_by_4_0;
        end
    end

    // ===== Stage 1: band1_next_exact, v1_xy, x1_exact, u1_xy
    // UQ3.0: the next
    wire [2:0] band1_next_exact_1 = band1_kept_1 + 3'h1;
    // Q4.14: the turned normal
    wire [18:0] v1_xy_1 = {{1{v1_x_1[17]}}, v1_x_1} + {{1{v1_y_1[17]}}, v1_y_1};
    // Q9.9: in texels from the middle
    wire [18:0] v1_scaled_1 = v1_xy_1;
    // Q4.14: the component across y of the normal, turned back
    wire [18:0] x1_exact_1 = {{1{x1_x_1[17]}}, x1_x_1} - {{1{x1_y_1[17]}}, x1_y_1};
    // Q4.14: the turned normal
    wire [18:0] u1_xy_1 = {{1{u1_x_1[17]}}, u1_x_1} + {{1{u1_y_1[17]}}, u1_y_1};
    reg [17:0] in_nz_2;
    reg [14:0] in_turn1_even_2;
    reg [14:0] in_turn1_odd_2;
    reg [17:0] in_gain1r_2;
    reg [17:0] in_gain1g_2;
    reg [17:0] in_gain1b_2;
    reg hidden_2;
    reg [2:0] band1_next_exact_2;
    reg [18:0] v1_xy_2;
    reg [18:0] v1_scaled_2;
    reg [18:0] x1_exact_2;
    reg [17:0] u1_z_2;
    reg [18:0] u1_xy_2;
    reg alone1_2;
    reg [11:0] end1_even_2;
    reg [11:0] end1_odd_2;
    reg [1:0] texels1_10_2;
    reg [1:0] texels1_10_v2_2;
    reg [1:0] texels1_11_2;
    reg [1:0] texels1_11_v2_2;
    reg [7:0] blend1_signed_2;
    reg square1_r_by_1_2;
    reg [1:0] square1_r_amount_2_2;
    reg square1_r_by_4_2;
    reg square1_g_by_1_2;
    reg [1:0] square1_g_amount_2_2;
    reg square1_g_by_4_2;
    reg square1_b_by_1_2;
    reg [1:0] square1_b_amount_2_2;
    reg square1_b_by_4_2;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_2 <= in_nz_1;
            in_turn1_even_2 <= in_turn1_even_1;
            in_turn1_odd_2 <= in_turn1_odd_1;
            in_gain1r_2 <= in_gain1r_1;
            in_gain1g_2 <= in_gain1g_1;
            in_gain1b_2 <= in_gain1b_1;
            hidden_2 <= hidden_1;
            band1_next_exact_2 <= band1_next_exact_1;
            v1_xy_2 <= v1_xy_1;
            v1_scaled_2 <= v1_scaled_1;
            x1_exact_2 <= x1_exact_1;
            u1_z_2 <= u1_z_1;
            u1_xy_2 <= u1_xy_1;
            alone1_2 <= alone1_1;
            end1_even_2 <= end1_even_1;
            end1_odd_2 <= end1_odd_1;
            texels1_10_2 <= texels1_10_1;
            texels1_10_v2_2 <= texels1_10_v2_1;
            texels1_11_2 <= texels1_11_1;
            texels1_11_v2_2 <= texels1_11_v2_1;
            blend1_signed_2 <= blend1_signed_1;
            square1_r_by_1_2 <= square1_r_by_1_1;
            square1_r_amount_2_2 <= square1_r_amount_2_1;
            square1_r_by_4_2 <= square1_r_by_4_1;
            square1_g_by_1_2 <= square1_g_by_1_1;
            square1_g_amount_2_2 <= square1_g_amount_2_1;
            square1_g_by_4_2 <= square1_g_by_4_1;
            square1_b_by_1_2 <= square1_b_by_1_1;
            square1_b_amount_2_2 <= square1_b_amount_2_1;
            square1_b_by_4_2 <= square1_b_by_4_1;
        end
    end

    // ===== Stage 2: band1_next, v1_place, x1, u1_xyz, v1_unit
    // UQ3.0: at most the last
    wire [2:0] band1_next_2 = (band1_next_exact_2 > 3'h5) ? 3'h5 : band1_next_exact_2;
    // UQ3.-1: its leading bits
    wire [1:0] band1_even_high_2 = band1_next_2[2:1];
    // UQ2.0: the even one of both
    wire [1:0] band1_even_2 = band1_even_high_2;
    // Q9.9: from the first, plus half a weight's last bit
    wire [18:0] v1_place_2 = v1_scaled_2 + 19'h03f04;
    // Q9.6: rounded to the nearest weight
    wire [15:0] v1_cut_2 = v1_place_2[18:3];
    // Q1.14: of a unit vector it is at most 1
    wire [15:0] x1_2 = (x1_exact_2[18] & ~&x1_exact_2[17:14]) ? 16'hc000 :
        (~x1_exact_2[18] & |x1_exact_2[17:14]) ? 16'h4000 :
        x1_exact_2[15:0];
    // Q4.14: the turned normal
    wire [18:0] u1_xyz_2 = u1_xy_2 + {{1{u1_z_2[17]}}, u1_z_2};
    // Q1.14: y of a unit vector
    wire [15:0] v1_unit_2 = (v1_xy_2[18] & ~&v1_xy_2[17:14]) ? 16'hc000 :
        (~v1_xy_2[18] & |v1_xy_2[17:14]) ? 16'h4000 :
        v1_xy_2[15:0];
    // UQ7.-5: the first of them
    wire [1:0] texels1_00_2 = band1_even_2;
    // UQ7.-5: the first of them
    wire [1:0] texels1_00_v2_2 = band1_even_2;
    // UQ7.-5: the first of them
    wire [1:0] texels1_01_2 = band1_even_2;
    // UQ7.-5: the first of them
    wire [1:0] texels1_01_v2_2 = band1_even_2;
    reg [17:0] in_nz_3;
    reg [14:0] in_turn1_even_3;
    reg [14:0] in_turn1_odd_3;
    reg [17:0] in_gain1r_3;
    reg [17:0] in_gain1g_3;
    reg [17:0] in_gain1b_3;
    reg hidden_3;
    reg [15:0] v1_cut_3;
    reg [15:0] x1_3;
    reg [18:0] u1_xyz_3;
    reg [15:0] v1_unit_3;
    reg alone1_3;
    reg [11:0] end1_even_3;
    reg [11:0] end1_odd_3;
    reg [1:0] texels1_00_3;
    reg [1:0] texels1_00_v2_3;
    reg [1:0] texels1_01_3;
    reg [1:0] texels1_01_v2_3;
    reg [1:0] texels1_10_3;
    reg [1:0] texels1_10_v2_3;
    reg [1:0] texels1_11_3;
    reg [1:0] texels1_11_v2_3;
    reg [7:0] blend1_signed_3;
    reg square1_r_by_1_3;
    reg [1:0] square1_r_amount_2_3;
    reg square1_r_by_4_3;
    reg square1_g_by_1_3;
    reg [1:0] square1_g_amount_2_3;
    reg square1_g_by_4_3;
    reg square1_b_by_1_3;
    reg [1:0] square1_b_amount_2_3;
    reg square1_b_by_4_3;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_3 <= in_nz_2;
            in_turn1_even_3 <= in_turn1_even_2;
            in_turn1_odd_3 <= in_turn1_odd_2;
            in_gain1r_3 <= in_gain1r_2;
            in_gain1g_3 <= in_gain1g_2;
            in_gain1b_3 <= in_gain1b_2;
            hidden_3 <= hidden_2;
            v1_cut_3 <= v1_cut_2;
            x1_3 <= x1_2;
            u1_xyz_3 <= u1_xyz_2;
            v1_unit_3 <= v1_unit_2;
            alone1_3 <= alone1_2;
            end1_even_3 <= end1_even_2;
            end1_odd_3 <= end1_odd_2;
            texels1_00_3 <= texels1_00_2;
            texels1_00_v2_3 <= texels1_00_v2_2;
            texels1_01_3 <= texels1_01_2;
            texels1_01_v2_3 <= texels1_01_v2_2;
            texels1_10_3 <= texels1_10_2;
            texels1_10_v2_3 <= texels1_10_v2_2;
            texels1_11_3 <= texels1_11_2;
            texels1_11_v2_3 <= texels1_11_v2_2;
            blend1_signed_3 <= blend1_signed_2;
            square1_r_by_1_3 <= square1_r_by_1_2;
            square1_r_amount_2_3 <= square1_r_amount_2_2;
            square1_r_by_4_3 <= square1_r_by_4_2;
            square1_g_by_1_3 <= square1_g_by_1_2;
            square1_g_amount_2_3 <= square1_g_amount_2_2;
            square1_g_by_4_3 <= square1_g_by_4_2;
            square1_b_by_1_3 <= square1_b_by_1_2;
            square1_b_amount_2_3 <= square1_b_amount_2_2;
            square1_b_by_4_3 <= square1_b_by_4_2;
        end
    end

    // ===== Stage 3: v1_kept, u1_below, u1_minus, u1_either, v1_square and 6 more
    // UQ6.6: between the outermost centres
    wire [11:0] v1_kept_3 =
        v1_cut_3[15] ? 12'h000 : (v1_cut_3 > 16'h0fc0) ? 12'hfc0 : v1_cut_3[11:0];
    // UQ6.0: the texel at or below it
    wire [5:0] v1_texel_3 = v1_kept_3[11:6];
    // UQ0.6: the weight of the next
    wire [5:0] v1_weight_3 = v1_kept_3[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] v1_odd_high_3 = v1_texel_3[5:1];
    // UQ5.0: the odd one of both
    wire [4:0] v1_odd_3 = v1_odd_high_3;
    // UQ1.0: its last bit
    wire v1_is_odd_3 = v1_texel_3[0];
    // UQ1.0: whether it is below 0
    wire u1_below_3 = $signed(19'h00000) > $signed(u1_xyz_3);
    // Q4.14: its opposite
    wire [18:0] u1_minus_3 = 19'h00000 - u1_xyz_3;
    // Q4.14: on either side of h
    wire [18:0] u1_either_3 = u1_below_3 ? u1_minus_3 : u1_xyz_3;
    // Q3.28: y^2
    wire [31:0] v1_square_3 = $signed(v1_unit_3) * $signed(v1_unit_3);
    // UQ-5.6: a bit of the weight
    wire v1_weight_bit_0_3 = v1_weight_3[0];
    // UQ-4.5: a bit of the weight
    wire v1_weight_bit_1_3 = v1_weight_3[1];
    // UQ-3.4: a bit of the weight
    wire v1_weight_bit_2_3 = v1_weight_3[2];
    // UQ-2.3: a bit of the weight
    wire v1_weight_bit_3_3 = v1_weight_3[3];
    // UQ-1.2: a bit of the weight
    wire v1_weight_bit_4_3 = v1_weight_3[4];
    // UQ0.1: a bit of the weight
    wire v1_weight_bit_5_3 = v1_weight_3[5];
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
    // UQ1.0: as a flag
    wire v1_weight_of_5_flag_3 = v1_weight_bit_5_3;
    // UQ1.0: it is 0
    wire v1_weight_of_5_not_3 = ~v1_weight_of_5_flag_3;
    // UQ1.0: whether it counts for the odd one
    wire v1_weight_of_5_3 = v1_is_odd_3 ? v1_weight_of_5_not_3 : v1_weight_of_5_flag_3;
    reg [17:0] in_nz_4;
    reg [14:0] in_turn1_even_4;
    reg [14:0] in_turn1_odd_4;
    reg [17:0] in_gain1r_4;
    reg [17:0] in_gain1g_4;
    reg [17:0] in_gain1b_4;
    reg hidden_4;
    reg [5:0] v1_texel_4;
    reg [4:0] v1_odd_4;
    reg v1_is_odd_4;
    reg [15:0] x1_4;
    reg [18:0] u1_either_4;
    reg [31:0] v1_square_4;
    reg alone1_4;
    reg [11:0] end1_even_4;
    reg [11:0] end1_odd_4;
    reg [1:0] texels1_00_4;
    reg [1:0] texels1_00_v2_4;
    reg [1:0] texels1_01_4;
    reg [1:0] texels1_01_v2_4;
    reg [1:0] texels1_10_4;
    reg [1:0] texels1_10_v2_4;
    reg [1:0] texels1_11_4;
    reg [1:0] texels1_11_v2_4;
    reg v1_weight_of_0_4;
    reg v1_weight_of_1_4;
    reg v1_weight_of_2_4;
    reg v1_weight_of_3_4;
    reg v1_weight_of_4_4;
    reg v1_weight_of_5_4;
    reg [7:0] blend1_signed_4;
    reg square1_r_by_1_4;
    reg [1:0] square1_r_amount_2_4;
    reg square1_r_by_4_4;
    reg square1_g_by_1_4;
    reg [1:0] square1_g_amount_2_4;
    reg square1_g_by_4_4;
    reg square1_b_by_1_4;
    reg [1:0] square1_b_amount_2_4;
    reg square1_b_by_4_4;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_4 <= in_nz_3;
            in_turn1_even_4 <= in_turn1_even_3;
            in_turn1_odd_4 <= in_turn1_odd_3;
            in_gain1r_4 <= in_gain1r_3;
            in_gain1g_4 <= in_gain1g_3;
            in_gain1b_4 <= in_gain1b_3;
            hidden_4 <= hidden_3;
            v1_texel_4 <= v1_texel_3;
            v1_odd_4 <= v1_odd_3;
            v1_is_odd_4 <= v1_is_odd_3;
            x1_4 <= x1_3;
            u1_either_4 <= u1_either_3;
            v1_square_4 <= v1_square_3;
            alone1_4 <= alone1_3;
            end1_even_4 <= end1_even_3;
            end1_odd_4 <= end1_odd_3;
            texels1_00_4 <= texels1_00_3;
            texels1_00_v2_4 <= texels1_00_v2_3;
            texels1_01_4 <= texels1_01_3;
            texels1_01_v2_4 <= texels1_01_v2_3;
            texels1_10_4 <= texels1_10_3;
            texels1_10_v2_4 <= texels1_10_v2_3;
            texels1_11_4 <= texels1_11_3;
            texels1_11_v2_4 <= texels1_11_v2_3;
            v1_weight_of_0_4 <= v1_weight_of_0_3;
            v1_weight_of_1_4 <= v1_weight_of_1_3;
            v1_weight_of_2_4 <= v1_weight_of_2_3;
            v1_weight_of_3_4 <= v1_weight_of_3_3;
            v1_weight_of_4_4 <= v1_weight_of_4_3;
            v1_weight_of_5_4 <= v1_weight_of_5_3;
            blend1_signed_4 <= blend1_signed_3;
            square1_r_by_1_4 <= square1_r_by_1_3;
            square1_r_amount_2_4 <= square1_r_amount_2_3;
            square1_r_by_4_4 <= square1_r_by_4_3;
            square1_g_by_1_4 <= square1_g_by_1_3;
            square1_g_amount_2_4 <= square1_g_amount_2_3;
            square1_g_by_4_4 <= square1_g_by_4_3;
            square1_b_by_1_4 <= square1_b_by_1_3;
            square1_b_amount_2_4 <= square1_b_amount_2_3;
            square1_b_by_4_4 <= square1_b_by_4_3;
        end
    end

    // ===== Stage 4: v1_next_exact, u1_kept, rr1_exact, texel1_01, texel1_01 and 2 more
    // UQ7.0: the next
    wire [6:0] v1_next_exact_4 = {1'd0, v1_texel_4} + 7'h01;
    // UQ1.14: of a unit vector it is at most 1
    wire [14:0] u1_kept_4 =
        u1_either_4[18] ? 15'h0000 : (|u1_either_4[17:14]) ? 15'h4000 : u1_either_4[14:0];
    // UQ2.28: r^2 = 1 - y^2
    wire [29:0] rr1_exact_4 = 30'h10000000 - v1_square_4[29:0];
    // UQ2.16: rounded down
    wire [17:0] rr1_cut_4 = rr1_exact_4[29:12];
    // Q1.14: a sign bit for the signed product
    wire [15:0] u1_kept_signed_4 = {1'd0, u1_kept_4};
    // UQ7.0: side by side
    wire [6:0] texel1_01_4 = {texels1_01_4, 5'd0} + {2'd0, v1_odd_4};
    // UQ12.-5: the first of them
    wire [6:0] texels1_010_4 = texel1_01_4;
    // UQ7.0: side by side
    wire [6:0] texel1_01_v2_4 = {texels1_01_v2_4, 5'd0} + {2'd0, v1_odd_4};
    // UQ12.-5: the first of them
    wire [6:0] texels1_011_4 = texel1_01_v2_4;
    // UQ7.0: side by side
    wire [6:0] texel1_11_4 = {texels1_11_4, 5'd0} + {2'd0, v1_odd_4};
    // UQ12.-5: the first of them
    wire [6:0] texels1_110_4 = texel1_11_4;
    // UQ7.0: side by side
    wire [6:0] texel1_11_v2_4 = {texels1_11_v2_4, 5'd0} + {2'd0, v1_odd_4};
    // UQ12.-5: the first of them
    wire [6:0] texels1_111_4 = texel1_11_v2_4;
    reg [17:0] in_nz_5;
    reg [14:0] in_turn1_even_5;
    reg [14:0] in_turn1_odd_5;
    reg [17:0] in_gain1r_5;
    reg [17:0] in_gain1g_5;
    reg [17:0] in_gain1b_5;
    reg hidden_5;
    reg [6:0] v1_next_exact_5;
    reg v1_is_odd_5;
    reg [15:0] x1_5;
    reg [17:0] rr1_cut_5;
    reg [15:0] u1_kept_signed_5;
    reg alone1_5;
    reg [11:0] end1_even_5;
    reg [11:0] end1_odd_5;
    reg [1:0] texels1_00_5;
    reg [1:0] texels1_00_v2_5;
    reg [6:0] texels1_010_5;
    reg [6:0] texels1_011_5;
    reg [1:0] texels1_10_5;
    reg [1:0] texels1_10_v2_5;
    reg [6:0] texels1_110_5;
    reg [6:0] texels1_111_5;
    reg v1_weight_of_0_5;
    reg v1_weight_of_1_5;
    reg v1_weight_of_2_5;
    reg v1_weight_of_3_5;
    reg v1_weight_of_4_5;
    reg v1_weight_of_5_5;
    reg [7:0] blend1_signed_5;
    reg square1_r_by_1_5;
    reg [1:0] square1_r_amount_2_5;
    reg square1_r_by_4_5;
    reg square1_g_by_1_5;
    reg [1:0] square1_g_amount_2_5;
    reg square1_g_by_4_5;
    reg square1_b_by_1_5;
    reg [1:0] square1_b_amount_2_5;
    reg square1_b_by_4_5;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_5 <= in_nz_4;
            in_turn1_even_5 <= in_turn1_even_4;
            in_turn1_odd_5 <= in_turn1_odd_4;
            in_gain1r_5 <= in_gain1r_4;
            in_gain1g_5 <= in_gain1g_4;
            in_gain1b_5 <= in_gain1b_4;
            hidden_5 <= hidden_4;
            v1_next_exact_5 <= v1_next_exact_4;
            v1_is_odd_5 <= v1_is_odd_4;
            x1_5 <= x1_4;
            rr1_cut_5 <= rr1_cut_4;
            u1_kept_signed_5 <= u1_kept_signed_4;
            alone1_5 <= alone1_4;
            end1_even_5 <= end1_even_4;
            end1_odd_5 <= end1_odd_4;
            texels1_00_5 <= texels1_00_4;
            texels1_00_v2_5 <= texels1_00_v2_4;
            texels1_010_5 <= texels1_010_4;
            texels1_011_5 <= texels1_011_4;
            texels1_10_5 <= texels1_10_4;
            texels1_10_v2_5 <= texels1_10_v2_4;
            texels1_110_5 <= texels1_110_4;
            texels1_111_5 <= texels1_111_4;
            v1_weight_of_0_5 <= v1_weight_of_0_4;
            v1_weight_of_1_5 <= v1_weight_of_1_4;
            v1_weight_of_2_5 <= v1_weight_of_2_4;
            v1_weight_of_3_5 <= v1_weight_of_3_4;
            v1_weight_of_4_5 <= v1_weight_of_4_4;
            v1_weight_of_5_5 <= v1_weight_of_5_4;
            blend1_signed_5 <= blend1_signed_4;
            square1_r_by_1_5 <= square1_r_by_1_4;
            square1_r_amount_2_5 <= square1_r_amount_2_4;
            square1_r_by_4_5 <= square1_r_by_4_4;
            square1_g_by_1_5 <= square1_g_by_1_4;
            square1_g_amount_2_5 <= square1_g_amount_2_4;
            square1_g_by_4_5 <= square1_g_by_4_4;
            square1_b_by_1_5 <= square1_b_by_1_4;
            square1_b_amount_2_5 <= square1_b_amount_2_4;
            square1_b_by_4_5 <= square1_b_by_4_4;
        end
    end

    // ===== Stage 5: v1_next, rr1, rr1_4, rr1_2, rr1_1
    // UQ6.0: at most the last
    wire [5:0] v1_next_5 = (|v1_next_exact_5[6]) ? 6'h3f : v1_next_exact_5[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] v1_even_high_5 = v1_next_5[5:1];
    // UQ5.0: the even one of both
    wire [4:0] v1_even_5 = v1_even_high_5;
    // UQ0.16: r^2, below 1
    wire [15:0] rr1_5 = (|rr1_cut_5[17:16]) ? 16'hffff : rr1_cut_5[15:0];
    // UQ0.4: the first 4 bits of rr
    wire [3:0] high1_4_bits_5 = rr1_5[15:12];
    // UQ1.0: the first 4 bits of rr
    wire high1_4_5 = |high1_4_bits_5;
    // UQ-4.16: without them
    wire [11:0] rr_low1_4_5 = rr1_5[11:0];
    // UQ0.12: rr 2^4
    wire [11:0] rr_up1_4_5 = rr_low1_4_5;
    // UQ0.16: in the wider of two formats
    wire [15:0] rr_up1_4_wide_5 = {rr_up1_4_5, 4'd0};
    // UQ0.16: rr, times 2^4 if it is so small
    wire [15:0] rr1_4_5 = high1_4_5 ? rr1_5 : rr_up1_4_wide_5;
    // UQ3.-2: a bit of the exponent
    wire place1_4_5 = high1_4_5;
    // UQ0.2: the first 2 bits of rr
    wire [1:0] high1_2_bits_5 = rr1_4_5[15:14];
    // UQ1.0: the first 2 bits of rr
    wire high1_2_5 = |high1_2_bits_5;
    // UQ-2.16: without them
    wire [13:0] rr_low1_2_5 = rr1_4_5[13:0];
    // UQ0.14: rr 2^2
    wire [13:0] rr_up1_2_5 = rr_low1_2_5;
    // UQ0.16: in the wider of two formats
    wire [15:0] rr_up1_2_wide_5 = {rr_up1_2_5, 2'd0};
    // UQ0.16: rr, times 2^2 if it is so small
    wire [15:0] rr1_2_5 = high1_2_5 ? rr1_4_5 : rr_up1_2_wide_5;
    // UQ2.-1: a bit of the exponent
    wire place1_2_5 = high1_2_5;
    // UQ0.1: the first 1 bits of rr
    wire high1_1_bits_5 = rr1_2_5[15];
    // UQ-1.16: without them
    wire [14:0] rr_low1_1_5 = rr1_2_5[14:0];
    // UQ0.15: rr 2^1
    wire [14:0] rr_up1_1_5 = rr_low1_1_5;
    // UQ0.16: in the wider of two formats
    wire [15:0] rr_up1_1_wide_5 = {rr_up1_1_5, 1'd0};
    // UQ0.16: rr, times 2^1 if it is so small
    wire [15:0] rr1_1_5 = high1_1_bits_5 ? rr1_2_5 : rr_up1_1_wide_5;
    // UQ1.0: a bit of the exponent
    wire place1_1_5 = high1_1_bits_5;
    // UQ1.0: the exponent is not 0
    wire normal1_of_2_5 = high1_4_5 | high1_2_5;
    // UQ1.0: the exponent is not 0
    wire normal1_5 = normal1_of_2_5 | high1_1_bits_5;
    // UQ1.15: 2 rr
    wire [15:0] rr1_twice_5 = rr1_1_5;
    // UQ0.15: 2 rr - 1
    wire [14:0] rr1_rest_5 = rr1_twice_5[14:0];
    // UQ0.16: in the wider of two formats
    wire [15:0] rr1_rest_wide_5 = {rr1_rest_5, 1'd0};
    reg [17:0] in_nz_6;
    reg [14:0] in_turn1_even_6;
    reg [14:0] in_turn1_odd_6;
    reg [17:0] in_gain1r_6;
    reg [17:0] in_gain1g_6;
    reg [17:0] in_gain1b_6;
    reg hidden_6;
    reg [4:0] v1_even_6;
    reg v1_is_odd_6;
    reg [15:0] x1_6;
    reg place1_4_6;
    reg place1_2_6;
    reg [15:0] rr1_1_6;
    reg place1_1_6;
    reg normal1_6;
    reg [15:0] rr1_rest_wide_6;
    reg [15:0] u1_kept_signed_6;
    reg alone1_6;
    reg [11:0] end1_even_6;
    reg [11:0] end1_odd_6;
    reg [1:0] texels1_00_6;
    reg [1:0] texels1_00_v2_6;
    reg [6:0] texels1_010_6;
    reg [6:0] texels1_011_6;
    reg [1:0] texels1_10_6;
    reg [1:0] texels1_10_v2_6;
    reg [6:0] texels1_110_6;
    reg [6:0] texels1_111_6;
    reg v1_weight_of_0_6;
    reg v1_weight_of_1_6;
    reg v1_weight_of_2_6;
    reg v1_weight_of_3_6;
    reg v1_weight_of_4_6;
    reg v1_weight_of_5_6;
    reg [7:0] blend1_signed_6;
    reg square1_r_by_1_6;
    reg [1:0] square1_r_amount_2_6;
    reg square1_r_by_4_6;
    reg square1_g_by_1_6;
    reg [1:0] square1_g_amount_2_6;
    reg square1_g_by_4_6;
    reg square1_b_by_1_6;
    reg [1:0] square1_b_amount_2_6;
    reg square1_b_by_4_6;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_6 <= in_nz_5;
            in_turn1_even_6 <= in_turn1_even_5;
            in_turn1_odd_6 <= in_turn1_odd_5;
            in_gain1r_6 <= in_gain1r_5;
            in_gain1g_6 <= in_gain1g_5;
            in_gain1b_6 <= in_gain1b_5;
            hidden_6 <= hidden_5;
            v1_even_6 <= v1_even_5;
            v1_is_odd_6 <= v1_is_odd_5;
            x1_6 <= x1_5;
            place1_4_6 <= place1_4_5;
            place1_2_6 <= place1_2_5;
            rr1_1_6 <= rr1_1_5;
            place1_1_6 <= place1_1_5;
            normal1_6 <= normal1_5;
            rr1_rest_wide_6 <= rr1_rest_wide_5;
            u1_kept_signed_6 <= u1_kept_signed_5;
            alone1_6 <= alone1_5;
            end1_even_6 <= end1_even_5;
            end1_odd_6 <= end1_odd_5;
            texels1_00_6 <= texels1_00_5;
            texels1_00_v2_6 <= texels1_00_v2_5;
            texels1_010_6 <= texels1_010_5;
            texels1_011_6 <= texels1_011_5;
            texels1_10_6 <= texels1_10_5;
            texels1_10_v2_6 <= texels1_10_v2_5;
            texels1_110_6 <= texels1_110_5;
            texels1_111_6 <= texels1_111_5;
            v1_weight_of_0_6 <= v1_weight_of_0_5;
            v1_weight_of_1_6 <= v1_weight_of_1_5;
            v1_weight_of_2_6 <= v1_weight_of_2_5;
            v1_weight_of_3_6 <= v1_weight_of_3_5;
            v1_weight_of_4_6 <= v1_weight_of_4_5;
            v1_weight_of_5_6 <= v1_weight_of_5_5;
            blend1_signed_6 <= blend1_signed_5;
            square1_r_by_1_6 <= square1_r_by_1_5;
            square1_r_amount_2_6 <= square1_r_amount_2_5;
            square1_r_by_4_6 <= square1_r_by_4_5;
            square1_g_by_1_6 <= square1_g_by_1_5;
            square1_g_amount_2_6 <= square1_g_amount_2_5;
            square1_g_by_4_6 <= square1_g_by_4_5;
            square1_b_by_1_6 <= square1_b_by_1_5;
            square1_b_amount_2_6 <= square1_b_amount_2_5;
            square1_b_by_4_6 <= square1_b_by_4_5;
        end
    end

    // ===== Stage 6: exponent1_2, rest1, texel1_00, texel1_00, texel1_10 and 1 more
    // UQ3.-1: the exponent's bits so far
    wire [1:0] exponent1_2_6 = {place1_4_6, 1'd0} + {1'd0, place1_2_6};
    // UQ0.16: the place in the octave
    wire [15:0] rest1_6 = normal1_6 ? rr1_rest_wide_6 : rr1_1_6;
    // UQ0.9: rounded down to the weights' last bit
    wire [8:0] rest1_cut_6 = rest1_6[15:7];
    // UQ0.4: the column in the octave
    wire [3:0] step1_6 = rest1_cut_6[8:5];
    // UQ4.0: its number
    wire [3:0] step1_number_6 = step1_6;
    // UQ-4.9: rr past it
    wire [4:0] part1_6 = rest1_cut_6[4:0];
    // UQ0.5: the weight of the next column
    wire [4:0] weight1_6 = part1_6;
    // UQ7.0: side by side
    wire [6:0] texel1_00_6 = {texels1_00_6, 5'd0} + {2'd0, v1_even_6};
    // UQ12.-5: the first of them
    wire [6:0] texels1_000_6 = texel1_00_6;
    // UQ7.0: side by side
    wire [6:0] texel1_00_v2_6 = {texels1_00_v2_6, 5'd0} + {2'd0, v1_even_6};
    // UQ12.-5: the first of them
    wire [6:0] texels1_001_6 = texel1_00_v2_6;
    // UQ7.0: side by side
    wire [6:0] texel1_10_6 = {texels1_10_6, 5'd0} + {2'd0, v1_even_6};
    // UQ12.-5: the first of them
    wire [6:0] texels1_100_6 = texel1_10_6;
    // UQ7.0: side by side
    wire [6:0] texel1_10_v2_6 = {texels1_10_v2_6, 5'd0} + {2'd0, v1_even_6};
    // UQ12.-5: the first of them
    wire [6:0] texels1_101_6 = texel1_10_v2_6;
    reg [17:0] in_nz_7;
    reg [14:0] in_turn1_even_7;
    reg [14:0] in_turn1_odd_7;
    reg [17:0] in_gain1r_7;
    reg [17:0] in_gain1g_7;
    reg [17:0] in_gain1b_7;
    reg hidden_7;
    reg v1_is_odd_7;
    reg [15:0] x1_7;
    reg [1:0] exponent1_2_7;
    reg place1_1_7;
    reg [3:0] step1_number_7;
    reg [4:0] weight1_7;
    reg [15:0] u1_kept_signed_7;
    reg alone1_7;
    reg [11:0] end1_even_7;
    reg [11:0] end1_odd_7;
    reg [6:0] texels1_000_7;
    reg [6:0] texels1_001_7;
    reg [6:0] texels1_010_7;
    reg [6:0] texels1_011_7;
    reg [6:0] texels1_100_7;
    reg [6:0] texels1_101_7;
    reg [6:0] texels1_110_7;
    reg [6:0] texels1_111_7;
    reg v1_weight_of_0_7;
    reg v1_weight_of_1_7;
    reg v1_weight_of_2_7;
    reg v1_weight_of_3_7;
    reg v1_weight_of_4_7;
    reg v1_weight_of_5_7;
    reg [7:0] blend1_signed_7;
    reg square1_r_by_1_7;
    reg [1:0] square1_r_amount_2_7;
    reg square1_r_by_4_7;
    reg square1_g_by_1_7;
    reg [1:0] square1_g_amount_2_7;
    reg square1_g_by_4_7;
    reg square1_b_by_1_7;
    reg [1:0] square1_b_amount_2_7;
    reg square1_b_by_4_7;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_7 <= in_nz_6;
            in_turn1_even_7 <= in_turn1_even_6;
            in_turn1_odd_7 <= in_turn1_odd_6;
            in_gain1r_7 <= in_gain1r_6;
            in_gain1g_7 <= in_gain1g_6;
            in_gain1b_7 <= in_gain1b_6;
            hidden_7 <= hidden_6;
            v1_is_odd_7 <= v1_is_odd_6;
            x1_7 <= x1_6;
            exponent1_2_7 <= exponent1_2_6;
            place1_1_7 <= place1_1_6;
            step1_number_7 <= step1_number_6;
            weight1_7 <= weight1_6;
            u1_kept_signed_7 <= u1_kept_signed_6;
            alone1_7 <= alone1_6;
            end1_even_7 <= end1_even_6;
            end1_odd_7 <= end1_odd_6;
            texels1_000_7 <= texels1_000_6;
            texels1_001_7 <= texels1_001_6;
            texels1_010_7 <= texels1_010_6;
            texels1_011_7 <= texels1_011_6;
            texels1_100_7 <= texels1_100_6;
            texels1_101_7 <= texels1_101_6;
            texels1_110_7 <= texels1_110_6;
            texels1_111_7 <= texels1_111_6;
            v1_weight_of_0_7 <= v1_weight_of_0_6;
            v1_weight_of_1_7 <= v1_weight_of_1_6;
            v1_weight_of_2_7 <= v1_weight_of_2_6;
            v1_weight_of_3_7 <= v1_weight_of_3_6;
            v1_weight_of_4_7 <= v1_weight_of_4_6;
            v1_weight_of_5_7 <= v1_weight_of_5_6;
            blend1_signed_7 <= blend1_signed_6;
            square1_r_by_1_7 <= square1_r_by_1_6;
            square1_r_amount_2_7 <= square1_r_amount_2_6;
            square1_r_by_4_7 <= square1_r_by_4_6;
            square1_g_by_1_7 <= square1_g_by_1_6;
            square1_g_amount_2_7 <= square1_g_amount_2_6;
            square1_g_by_4_7 <= square1_g_by_4_6;
            square1_b_by_1_7 <= square1_b_by_1_6;
            square1_b_amount_2_7 <= square1_b_amount_2_6;
            square1_b_by_4_7 <= square1_b_by_4_6;
        end
    end

    // ===== Stage 7: exponent1_1
    // UQ3.0: the exponent's bits so far
    wire [2:0] exponent1_1_7 = {exponent1_2_7, 1'd0} + {2'd0, place1_1_7};
    // UQ7.-4: the octave's first column
    wire [2:0] octave1_7 = exponent1_1_7;
    reg [17:0] in_nz_8;
    reg [14:0] in_turn1_even_8;
    reg [14:0] in_turn1_odd_8;
    reg [17:0] in_gain1r_8;
    reg [17:0] in_gain1g_8;
    reg [17:0] in_gain1b_8;
    reg hidden_8;
    reg v1_is_odd_8;
    reg [15:0] x1_8;
    reg [3:0] step1_number_8;
    reg [2:0] octave1_8;
    reg [4:0] weight1_8;
    reg [15:0] u1_kept_signed_8;
    reg alone1_8;
    reg [11:0] end1_even_8;
    reg [11:0] end1_odd_8;
    reg [6:0] texels1_000_8;
    reg [6:0] texels1_001_8;
    reg [6:0] texels1_010_8;
    reg [6:0] texels1_011_8;
    reg [6:0] texels1_100_8;
    reg [6:0] texels1_101_8;
    reg [6:0] texels1_110_8;
    reg [6:0] texels1_111_8;
    reg v1_weight_of_0_8;
    reg v1_weight_of_1_8;
    reg v1_weight_of_2_8;
    reg v1_weight_of_3_8;
    reg v1_weight_of_4_8;
    reg v1_weight_of_5_8;
    reg [7:0] blend1_signed_8;
    reg square1_r_by_1_8;
    reg [1:0] square1_r_amount_2_8;
    reg square1_r_by_4_8;
    reg square1_g_by_1_8;
    reg [1:0] square1_g_amount_2_8;
    reg square1_g_by_4_8;
    reg square1_b_by_1_8;
    reg [1:0] square1_b_amount_2_8;
    reg square1_b_by_4_8;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_8 <= in_nz_7;
            in_turn1_even_8 <= in_turn1_even_7;
            in_turn1_odd_8 <= in_turn1_odd_7;
            in_gain1r_8 <= in_gain1r_7;
            in_gain1g_8 <= in_gain1g_7;
            in_gain1b_8 <= in_gain1b_7;
            hidden_8 <= hidden_7;
            v1_is_odd_8 <= v1_is_odd_7;
            x1_8 <= x1_7;
            step1_number_8 <= step1_number_7;
            octave1_8 <= octave1_7;
            weight1_8 <= weight1_7;
            u1_kept_signed_8 <= u1_kept_signed_7;
            alone1_8 <= alone1_7;
            end1_even_8 <= end1_even_7;
            end1_odd_8 <= end1_odd_7;
            texels1_000_8 <= texels1_000_7;
            texels1_001_8 <= texels1_001_7;
            texels1_010_8 <= texels1_010_7;
            texels1_011_8 <= texels1_011_7;
            texels1_100_8 <= texels1_100_7;
            texels1_101_8 <= texels1_101_7;
            texels1_110_8 <= texels1_110_7;
            texels1_111_8 <= texels1_111_7;
            v1_weight_of_0_8 <= v1_weight_of_0_7;
            v1_weight_of_1_8 <= v1_weight_of_1_7;
            v1_weight_of_2_8 <= v1_weight_of_2_7;
            v1_weight_of_3_8 <= v1_weight_of_3_7;
            v1_weight_of_4_8 <= v1_weight_of_4_7;
            v1_weight_of_5_8 <= v1_weight_of_5_7;
            blend1_signed_8 <= blend1_signed_7;
            square1_r_by_1_8 <= square1_r_by_1_7;
            square1_r_amount_2_8 <= square1_r_amount_2_7;
            square1_r_by_4_8 <= square1_r_by_4_7;
            square1_g_by_1_8 <= square1_g_by_1_7;
            square1_g_amount_2_8 <= square1_g_amount_2_7;
            square1_g_by_4_8 <= square1_g_by_4_7;
            square1_b_by_1_8 <= square1_b_by_1_7;
            square1_b_amount_2_8 <= square1_b_amount_2_7;
            square1_b_by_4_8 <= square1_b_by_4_7;
        end
    end

    // ===== Stage 8: column1
    // UQ7.0: the column at or below rr
    wire [6:0] column1_8 = {octave1_8, 4'd0} + {3'd0, step1_number_8};
    reg [17:0] in_nz_9;
    reg [14:0] in_turn1_even_9;
    reg [14:0] in_turn1_odd_9;
    reg [17:0] in_gain1r_9;
    reg [17:0] in_gain1g_9;
    reg [17:0] in_gain1b_9;
    reg hidden_9;
    reg v1_is_odd_9;
    reg [15:0] x1_9;
    reg [6:0] column1_9;
    reg [4:0] weight1_9;
    reg [15:0] u1_kept_signed_9;
    reg alone1_9;
    reg [11:0] end1_even_9;
    reg [11:0] end1_odd_9;
    reg [6:0] texels1_000_9;
    reg [6:0] texels1_001_9;
    reg [6:0] texels1_010_9;
    reg [6:0] texels1_011_9;
    reg [6:0] texels1_100_9;
    reg [6:0] texels1_101_9;
    reg [6:0] texels1_110_9;
    reg [6:0] texels1_111_9;
    reg v1_weight_of_0_9;
    reg v1_weight_of_1_9;
    reg v1_weight_of_2_9;
    reg v1_weight_of_3_9;
    reg v1_weight_of_4_9;
    reg v1_weight_of_5_9;
    reg [7:0] blend1_signed_9;
    reg square1_r_by_1_9;
    reg [1:0] square1_r_amount_2_9;
    reg square1_r_by_4_9;
    reg square1_g_by_1_9;
    reg [1:0] square1_g_amount_2_9;
    reg square1_g_by_4_9;
    reg square1_b_by_1_9;
    reg [1:0] square1_b_amount_2_9;
    reg square1_b_by_4_9;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_9 <= in_nz_8;
            in_turn1_even_9 <= in_turn1_even_8;
            in_turn1_odd_9 <= in_turn1_odd_8;
            in_gain1r_9 <= in_gain1r_8;
            in_gain1g_9 <= in_gain1g_8;
            in_gain1b_9 <= in_gain1b_8;
            hidden_9 <= hidden_8;
            v1_is_odd_9 <= v1_is_odd_8;
            x1_9 <= x1_8;
            column1_9 <= column1_8;
            weight1_9 <= weight1_8;
            u1_kept_signed_9 <= u1_kept_signed_8;
            alone1_9 <= alone1_8;
            end1_even_9 <= end1_even_8;
            end1_odd_9 <= end1_odd_8;
            texels1_000_9 <= texels1_000_8;
            texels1_001_9 <= texels1_001_8;
            texels1_010_9 <= texels1_010_8;
            texels1_011_9 <= texels1_011_8;
            texels1_100_9 <= texels1_100_8;
            texels1_101_9 <= texels1_101_8;
            texels1_110_9 <= texels1_110_8;
            texels1_111_9 <= texels1_111_8;
            v1_weight_of_0_9 <= v1_weight_of_0_8;
            v1_weight_of_1_9 <= v1_weight_of_1_8;
            v1_weight_of_2_9 <= v1_weight_of_2_8;
            v1_weight_of_3_9 <= v1_weight_of_3_8;
            v1_weight_of_4_9 <= v1_weight_of_4_8;
            v1_weight_of_5_9 <= v1_weight_of_5_8;
            blend1_signed_9 <= blend1_signed_8;
            square1_r_by_1_9 <= square1_r_by_1_8;
            square1_r_amount_2_9 <= square1_r_amount_2_8;
            square1_r_by_4_9 <= square1_r_by_4_8;
            square1_g_by_1_9 <= square1_g_by_1_8;
            square1_g_amount_2_9 <= square1_g_amount_2_8;
            square1_g_by_4_9 <= square1_g_by_4_8;
            square1_b_by_1_9 <= square1_b_by_1_8;
            square1_b_amount_2_9 <= square1_b_amount_2_8;
            square1_b_by_4_9 <= square1_b_by_4_8;
        end
    end

    // ===== Stage 9: read roots_1
    // The word of the memory roots_1, of 128 words.
    reg [30:0] roots_1_10;
    reg [30:0] roots_1 [0:127];
    initial $readmemh(ROOTS_1_FILE, roots_1);
    always @(posedge clk) begin
        if (ce) roots_1_10 <= roots_1[column1_9];
    end
    reg [17:0] in_nz_10;
    reg [14:0] in_turn1_even_10;
    reg [14:0] in_turn1_odd_10;
    reg [17:0] in_gain1r_10;
    reg [17:0] in_gain1g_10;
    reg [17:0] in_gain1b_10;
    reg hidden_10;
    reg v1_is_odd_10;
    reg [15:0] x1_10;
    reg [4:0] weight1_10;
    reg [15:0] u1_kept_signed_10;
    reg alone1_10;
    reg [11:0] end1_even_10;
    reg [11:0] end1_odd_10;
    reg [6:0] texels1_000_10;
    reg [6:0] texels1_001_10;
    reg [6:0] texels1_010_10;
    reg [6:0] texels1_011_10;
    reg [6:0] texels1_100_10;
    reg [6:0] texels1_101_10;
    reg [6:0] texels1_110_10;
    reg [6:0] texels1_111_10;
    reg v1_weight_of_0_10;
    reg v1_weight_of_1_10;
    reg v1_weight_of_2_10;
    reg v1_weight_of_3_10;
    reg v1_weight_of_4_10;
    reg v1_weight_of_5_10;
    reg [7:0] blend1_signed_10;
    reg square1_r_by_1_10;
    reg [1:0] square1_r_amount_2_10;
    reg square1_r_by_4_10;
    reg square1_g_by_1_10;
    reg [1:0] square1_g_amount_2_10;
    reg square1_g_by_4_10;
    reg square1_b_by_1_10;
    reg [1:0] square1_b_amount_2_10;
    reg square1_b_by_4_10;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_10 <= in_nz_9;
            in_turn1_even_10 <= in_turn1_even_9;
            in_turn1_odd_10 <= in_turn1_odd_9;
            in_gain1r_10 <= in_gain1r_9;
            in_gain1g_10 <= in_gain1g_9;
            in_gain1b_10 <= in_gain1b_9;
            hidden_10 <= hidden_9;
            v1_is_odd_10 <= v1_is_odd_9;
            x1_10 <= x1_9;
            weight1_10 <= weight1_9;
            u1_kept_signed_10 <= u1_kept_signed_9;
            alone1_10 <= alone1_9;
            end1_even_10 <= end1_even_9;
            end1_odd_10 <= end1_odd_9;
            texels1_000_10 <= texels1_000_9;
            texels1_001_10 <= texels1_001_9;
            texels1_010_10 <= texels1_010_9;
            texels1_011_10 <= texels1_011_9;
            texels1_100_10 <= texels1_100_9;
            texels1_101_10 <= texels1_101_9;
            texels1_110_10 <= texels1_110_9;
            texels1_111_10 <= texels1_111_9;
            v1_weight_of_0_10 <= v1_weight_of_0_9;
            v1_weight_of_1_10 <= v1_weight_of_1_9;
            v1_weight_of_2_10 <= v1_weight_of_2_9;
            v1_weight_of_3_10 <= v1_weight_of_3_9;
            v1_weight_of_4_10 <= v1_weight_of_4_9;
            v1_weight_of_5_10 <= v1_weight_of_5_9;
            blend1_signed_10 <= blend1_signed_9;
            square1_r_by_1_10 <= square1_r_by_1_9;
            square1_r_amount_2_10 <= square1_r_amount_2_9;
            square1_r_by_4_10 <= square1_r_by_4_9;
            square1_g_by_1_10 <= square1_g_by_1_9;
            square1_g_amount_2_10 <= square1_g_amount_2_9;
            square1_g_by_4_10 <= square1_g_by_4_9;
            square1_b_by_1_10 <= square1_b_by_1_9;
            square1_b_amount_2_10 <= square1_b_amount_2_9;
            square1_b_by_4_10 <= square1_b_by_4_9;
        end
    end

    // ===== Stage 10: registers only
    // UQ6.10: 1/sqrt(1 - y^2)
    wire [15:0] root_1_10 = roots_1_10[30:15];
    // UQ5.10: what it falls by to the next row
    wire [14:0] fall_1_10 = roots_1_10[14:0];
    reg [17:0] in_nz_11;
    reg [14:0] in_turn1_even_11;
    reg [14:0] in_turn1_odd_11;
    reg [17:0] in_gain1r_11;
    reg [17:0] in_gain1g_11;
    reg [17:0] in_gain1b_11;
    reg hidden_11;
    reg v1_is_odd_11;
    reg [15:0] x1_11;
    reg [4:0] weight1_11;
    reg [15:0] root_1_11;
    reg [14:0] fall_1_11;
    reg [15:0] u1_kept_signed_11;
    reg alone1_11;
    reg [11:0] end1_even_11;
    reg [11:0] end1_odd_11;
    reg [6:0] texels1_000_11;
    reg [6:0] texels1_001_11;
    reg [6:0] texels1_010_11;
    reg [6:0] texels1_011_11;
    reg [6:0] texels1_100_11;
    reg [6:0] texels1_101_11;
    reg [6:0] texels1_110_11;
    reg [6:0] texels1_111_11;
    reg v1_weight_of_0_11;
    reg v1_weight_of_1_11;
    reg v1_weight_of_2_11;
    reg v1_weight_of_3_11;
    reg v1_weight_of_4_11;
    reg v1_weight_of_5_11;
    reg [7:0] blend1_signed_11;
    reg square1_r_by_1_11;
    reg [1:0] square1_r_amount_2_11;
    reg square1_r_by_4_11;
    reg square1_g_by_1_11;
    reg [1:0] square1_g_amount_2_11;
    reg square1_g_by_4_11;
    reg square1_b_by_1_11;
    reg [1:0] square1_b_amount_2_11;
    reg square1_b_by_4_11;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_11 <= in_nz_10;
            in_turn1_even_11 <= in_turn1_even_10;
            in_turn1_odd_11 <= in_turn1_odd_10;
            in_gain1r_11 <= in_gain1r_10;
            in_gain1g_11 <= in_gain1g_10;
            in_gain1b_11 <= in_gain1b_10;
            hidden_11 <= hidden_10;
            v1_is_odd_11 <= v1_is_odd_10;
            x1_11 <= x1_10;
            weight1_11 <= weight1_10;
            root_1_11 <= root_1_10;
            fall_1_11 <= fall_1_10;
            u1_kept_signed_11 <= u1_kept_signed_10;
            alone1_11 <= alone1_10;
            end1_even_11 <= end1_even_10;
            end1_odd_11 <= end1_odd_10;
            texels1_000_11 <= texels1_000_10;
            texels1_001_11 <= texels1_001_10;
            texels1_010_11 <= texels1_010_10;
            texels1_011_11 <= texels1_011_10;
            texels1_100_11 <= texels1_100_10;
            texels1_101_11 <= texels1_101_10;
            texels1_110_11 <= texels1_110_10;
            texels1_111_11 <= texels1_111_10;
            v1_weight_of_0_11 <= v1_weight_of_0_10;
            v1_weight_of_1_11 <= v1_weight_of_1_10;
            v1_weight_of_2_11 <= v1_weight_of_2_10;
            v1_weight_of_3_11 <= v1_weight_of_3_10;
            v1_weight_of_4_11 <= v1_weight_of_4_10;
            v1_weight_of_5_11 <= v1_weight_of_5_10;
            blend1_signed_11 <= blend1_signed_10;
            square1_r_by_1_11 <= square1_r_by_1_10;
            square1_r_amount_2_11 <= square1_r_amount_2_10;
            square1_r_by_4_11 <= square1_r_by_4_10;
            square1_g_by_1_11 <= square1_g_by_1_10;
            square1_g_amount_2_11 <= square1_g_amount_2_10;
            square1_g_by_4_11 <= square1_g_by_4_10;
            square1_b_by_1_11 <= square1_b_by_1_10;
            square1_b_amount_2_11 <= square1_b_amount_2_10;
            square1_b_by_4_11 <= square1_b_by_4_10;
        end
    end

    // ===== Stage 11: registers only
    reg [17:0] in_nz_12;
    reg [14:0] in_turn1_even_12;
    reg [14:0] in_turn1_odd_12;
    reg [17:0] in_gain1r_12;
    reg [17:0] in_gain1g_12;
    reg [17:0] in_gain1b_12;
    reg hidden_12;
    reg v1_is_odd_12;
    reg [15:0] x1_12;
    reg [4:0] weight1_12;
    reg [15:0] root_1_12;
    reg [14:0] fall_1_12;
    reg [15:0] u1_kept_signed_12;
    reg alone1_12;
    reg [11:0] end1_even_12;
    reg [11:0] end1_odd_12;
    reg [6:0] texels1_000_12;
    reg [6:0] texels1_001_12;
    reg [6:0] texels1_010_12;
    reg [6:0] texels1_011_12;
    reg [6:0] texels1_100_12;
    reg [6:0] texels1_101_12;
    reg [6:0] texels1_110_12;
    reg [6:0] texels1_111_12;
    reg v1_weight_of_0_12;
    reg v1_weight_of_1_12;
    reg v1_weight_of_2_12;
    reg v1_weight_of_3_12;
    reg v1_weight_of_4_12;
    reg v1_weight_of_5_12;
    reg [7:0] blend1_signed_12;
    reg square1_r_by_1_12;
    reg [1:0] square1_r_amount_2_12;
    reg square1_r_by_4_12;
    reg square1_g_by_1_12;
    reg [1:0] square1_g_amount_2_12;
    reg square1_g_by_4_12;
    reg square1_b_by_1_12;
    reg [1:0] square1_b_amount_2_12;
    reg square1_b_by_4_12;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_12 <= in_nz_11;
            in_turn1_even_12 <= in_turn1_even_11;
            in_turn1_odd_12 <= in_turn1_odd_11;
            in_gain1r_12 <= in_gain1r_11;
            in_gain1g_12 <= in_gain1g_11;
            in_gain1b_12 <= in_gain1b_11;
            hidden_12 <= hidden_11;
            v1_is_odd_12 <= v1_is_odd_11;
            x1_12 <= x1_11;
            weight1_12 <= weight1_11;
            root_1_12 <= root_1_11;
            fall_1_12 <= fall_1_11;
            u1_kept_signed_12 <= u1_kept_signed_11;
            alone1_12 <= alone1_11;
            end1_even_12 <= end1_even_11;
            end1_odd_12 <= end1_odd_11;
            texels1_000_12 <= texels1_000_11;
            texels1_001_12 <= texels1_001_11;
            texels1_010_12 <= texels1_010_11;
            texels1_011_12 <= texels1_011_11;
            texels1_100_12 <= texels1_100_11;
            texels1_101_12 <= texels1_101_11;
            texels1_110_12 <= texels1_110_11;
            texels1_111_12 <= texels1_111_11;
            v1_weight_of_0_12 <= v1_weight_of_0_11;
            v1_weight_of_1_12 <= v1_weight_of_1_11;
            v1_weight_of_2_12 <= v1_weight_of_2_11;
            v1_weight_of_3_12 <= v1_weight_of_3_11;
            v1_weight_of_4_12 <= v1_weight_of_4_11;
            v1_weight_of_5_12 <= v1_weight_of_5_11;
            blend1_signed_12 <= blend1_signed_11;
            square1_r_by_1_12 <= square1_r_by_1_11;
            square1_r_amount_2_12 <= square1_r_amount_2_11;
            square1_r_by_4_12 <= square1_r_by_4_11;
            square1_g_by_1_12 <= square1_g_by_1_11;
            square1_g_amount_2_12 <= square1_g_amount_2_11;
            square1_g_by_4_12 <= square1_g_by_4_11;
            square1_b_by_1_12 <= square1_b_by_1_11;
            square1_b_amount_2_12 <= square1_b_amount_2_11;
            square1_b_by_4_12 <= square1_b_by_4_11;
        end
    end

    // ===== Stage 12: fall_part1
    // UQ5.15: its part
    wire [19:0] fall_part1_12 = fall_1_12 * weight1_12;
    reg [17:0] in_nz_13;
    reg [14:0] in_turn1_even_13;
    reg [14:0] in_turn1_odd_13;
    reg [17:0] in_gain1r_13;
    reg [17:0] in_gain1g_13;
    reg [17:0] in_gain1b_13;
    reg hidden_13;
    reg v1_is_odd_13;
    reg [15:0] x1_13;
    reg [15:0] root_1_13;
    reg [19:0] fall_part1_13;
    reg [15:0] u1_kept_signed_13;
    reg alone1_13;
    reg [11:0] end1_even_13;
    reg [11:0] end1_odd_13;
    reg [6:0] texels1_000_13;
    reg [6:0] texels1_001_13;
    reg [6:0] texels1_010_13;
    reg [6:0] texels1_011_13;
    reg [6:0] texels1_100_13;
    reg [6:0] texels1_101_13;
    reg [6:0] texels1_110_13;
    reg [6:0] texels1_111_13;
    reg v1_weight_of_0_13;
    reg v1_weight_of_1_13;
    reg v1_weight_of_2_13;
    reg v1_weight_of_3_13;
    reg v1_weight_of_4_13;
    reg v1_weight_of_5_13;
    reg [7:0] blend1_signed_13;
    reg square1_r_by_1_13;
    reg [1:0] square1_r_amount_2_13;
    reg square1_r_by_4_13;
    reg square1_g_by_1_13;
    reg [1:0] square1_g_amount_2_13;
    reg square1_g_by_4_13;
    reg square1_b_by_1_13;
    reg [1:0] square1_b_amount_2_13;
    reg square1_b_by_4_13;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_13 <= in_nz_12;
            in_turn1_even_13 <= in_turn1_even_12;
            in_turn1_odd_13 <= in_turn1_odd_12;
            in_gain1r_13 <= in_gain1r_12;
            in_gain1g_13 <= in_gain1g_12;
            in_gain1b_13 <= in_gain1b_12;
            hidden_13 <= hidden_12;
            v1_is_odd_13 <= v1_is_odd_12;
            x1_13 <= x1_12;
            root_1_13 <= root_1_12;
            fall_part1_13 <= fall_part1_12;
            u1_kept_signed_13 <= u1_kept_signed_12;
            alone1_13 <= alone1_12;
            end1_even_13 <= end1_even_12;
            end1_odd_13 <= end1_odd_12;
            texels1_000_13 <= texels1_000_12;
            texels1_001_13 <= texels1_001_12;
            texels1_010_13 <= texels1_010_12;
            texels1_011_13 <= texels1_011_12;
            texels1_100_13 <= texels1_100_12;
            texels1_101_13 <= texels1_101_12;
            texels1_110_13 <= texels1_110_12;
            texels1_111_13 <= texels1_111_12;
            v1_weight_of_0_13 <= v1_weight_of_0_12;
            v1_weight_of_1_13 <= v1_weight_of_1_12;
            v1_weight_of_2_13 <= v1_weight_of_2_12;
            v1_weight_of_3_13 <= v1_weight_of_3_12;
            v1_weight_of_4_13 <= v1_weight_of_4_12;
            v1_weight_of_5_13 <= v1_weight_of_5_12;
            blend1_signed_13 <= blend1_signed_12;
            square1_r_by_1_13 <= square1_r_by_1_12;
            square1_r_amount_2_13 <= square1_r_amount_2_12;
            square1_r_by_4_13 <= square1_r_by_4_12;
            square1_g_by_1_13 <= square1_g_by_1_12;
            square1_g_amount_2_13 <= square1_g_amount_2_12;
            square1_g_by_4_13 <= square1_g_by_4_12;
            square1_b_by_1_13 <= square1_b_by_1_12;
            square1_b_amount_2_13 <= square1_b_amount_2_12;
            square1_b_by_4_13 <= square1_b_by_4_12;
        end
    end

    // ===== Stage 13: registers only
    reg [17:0] in_nz_14;
    reg [14:0] in_turn1_even_14;
    reg [14:0] in_turn1_odd_14;
    reg [17:0] in_gain1r_14;
    reg [17:0] in_gain1g_14;
    reg [17:0] in_gain1b_14;
    reg hidden_14;
    reg v1_is_odd_14;
    reg [15:0] x1_14;
    reg [15:0] root_1_14;
    reg [19:0] fall_part1_14;
    reg [15:0] u1_kept_signed_14;
    reg alone1_14;
    reg [11:0] end1_even_14;
    reg [11:0] end1_odd_14;
    reg [6:0] texels1_000_14;
    reg [6:0] texels1_001_14;
    reg [6:0] texels1_010_14;
    reg [6:0] texels1_011_14;
    reg [6:0] texels1_100_14;
    reg [6:0] texels1_101_14;
    reg [6:0] texels1_110_14;
    reg [6:0] texels1_111_14;
    reg v1_weight_of_0_14;
    reg v1_weight_of_1_14;
    reg v1_weight_of_2_14;
    reg v1_weight_of_3_14;
    reg v1_weight_of_4_14;
    reg v1_weight_of_5_14;
    reg [7:0] blend1_signed_14;
    reg square1_r_by_1_14;
    reg [1:0] square1_r_amount_2_14;
    reg square1_r_by_4_14;
    reg square1_g_by_1_14;
    reg [1:0] square1_g_amount_2_14;
    reg square1_g_by_4_14;
    reg square1_b_by_1_14;
    reg [1:0] square1_b_amount_2_14;
    reg square1_b_by_4_14;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_14 <= in_nz_13;
            in_turn1_even_14 <= in_turn1_even_13;
            in_turn1_odd_14 <= in_turn1_odd_13;
            in_gain1r_14 <= in_gain1r_13;
            in_gain1g_14 <= in_gain1g_13;
            in_gain1b_14 <= in_gain1b_13;
            hidden_14 <= hidden_13;
            v1_is_odd_14 <= v1_is_odd_13;
            x1_14 <= x1_13;
            root_1_14 <= root_1_13;
            fall_part1_14 <= fall_part1_13;
            u1_kept_signed_14 <= u1_kept_signed_13;
            alone1_14 <= alone1_13;
            end1_even_14 <= end1_even_13;
            end1_odd_14 <= end1_odd_13;
            texels1_000_14 <= texels1_000_13;
            texels1_001_14 <= texels1_001_13;
            texels1_010_14 <= texels1_010_13;
            texels1_011_14 <= texels1_011_13;
            texels1_100_14 <= texels1_100_13;
            texels1_101_14 <= texels1_101_13;
            texels1_110_14 <= texels1_110_13;
            texels1_111_14 <= texels1_111_13;
            v1_weight_of_0_14 <= v1_weight_of_0_13;
            v1_weight_of_1_14 <= v1_weight_of_1_13;
            v1_weight_of_2_14 <= v1_weight_of_2_13;
            v1_weight_of_3_14 <= v1_weight_of_3_13;
            v1_weight_of_4_14 <= v1_weight_of_4_13;
            v1_weight_of_5_14 <= v1_weight_of_5_13;
            blend1_signed_14 <= blend1_signed_13;
            square1_r_by_1_14 <= square1_r_by_1_13;
            square1_r_amount_2_14 <= square1_r_amount_2_13;
            square1_r_by_4_14 <= square1_r_by_4_13;
            square1_g_by_1_14 <= square1_g_by_1_13;
            square1_g_amount_2_14 <= square1_g_amount_2_13;
            square1_g_by_4_14 <= square1_g_by_4_13;
            square1_b_by_1_14 <= square1_b_by_1_13;
            square1_b_amount_2_14 <= square1_b_amount_2_13;
            square1_b_by_4_14 <= square1_b_by_4_13;
        end
    end

    // ===== Stage 14: root_at1
    // Q6.15: 1/r
    wire [21:0] root_at1_14 = {1'd0, root_1_14, 5'd0} - {2'd0, fall_part1_14};
    // Q6.10: rounded down
    wire [16:0] root_cut1_14 = root_at1_14[21:5];
    reg [17:0] in_nz_15;
    reg [14:0] in_turn1_even_15;
    reg [14:0] in_turn1_odd_15;
    reg [17:0] in_gain1r_15;
    reg [17:0] in_gain1g_15;
    reg [17:0] in_gain1b_15;
    reg hidden_15;
    reg v1_is_odd_15;
    reg [15:0] x1_15;
    reg [16:0] root_cut1_15;
    reg [15:0] u1_kept_signed_15;
    reg alone1_15;
    reg [11:0] end1_even_15;
    reg [11:0] end1_odd_15;
    reg [6:0] texels1_000_15;
    reg [6:0] texels1_001_15;
    reg [6:0] texels1_010_15;
    reg [6:0] texels1_011_15;
    reg [6:0] texels1_100_15;
    reg [6:0] texels1_101_15;
    reg [6:0] texels1_110_15;
    reg [6:0] texels1_111_15;
    reg v1_weight_of_0_15;
    reg v1_weight_of_1_15;
    reg v1_weight_of_2_15;
    reg v1_weight_of_3_15;
    reg v1_weight_of_4_15;
    reg v1_weight_of_5_15;
    reg [7:0] blend1_signed_15;
    reg square1_r_by_1_15;
    reg [1:0] square1_r_amount_2_15;
    reg square1_r_by_4_15;
    reg square1_g_by_1_15;
    reg [1:0] square1_g_amount_2_15;
    reg square1_g_by_4_15;
    reg square1_b_by_1_15;
    reg [1:0] square1_b_amount_2_15;
    reg square1_b_by_4_15;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_15 <= in_nz_14;
            in_turn1_even_15 <= in_turn1_even_14;
            in_turn1_odd_15 <= in_turn1_odd_14;
            in_gain1r_15 <= in_gain1r_14;
            in_gain1g_15 <= in_gain1g_14;
            in_gain1b_15 <= in_gain1b_14;
            hidden_15 <= hidden_14;
            v1_is_odd_15 <= v1_is_odd_14;
            x1_15 <= x1_14;
            root_cut1_15 <= root_cut1_14;
            u1_kept_signed_15 <= u1_kept_signed_14;
            alone1_15 <= alone1_14;
            end1_even_15 <= end1_even_14;
            end1_odd_15 <= end1_odd_14;
            texels1_000_15 <= texels1_000_14;
            texels1_001_15 <= texels1_001_14;
            texels1_010_15 <= texels1_010_14;
            texels1_011_15 <= texels1_011_14;
            texels1_100_15 <= texels1_100_14;
            texels1_101_15 <= texels1_101_14;
            texels1_110_15 <= texels1_110_14;
            texels1_111_15 <= texels1_111_14;
            v1_weight_of_0_15 <= v1_weight_of_0_14;
            v1_weight_of_1_15 <= v1_weight_of_1_14;
            v1_weight_of_2_15 <= v1_weight_of_2_14;
            v1_weight_of_3_15 <= v1_weight_of_3_14;
            v1_weight_of_4_15 <= v1_weight_of_4_14;
            v1_weight_of_5_15 <= v1_weight_of_5_14;
            blend1_signed_15 <= blend1_signed_14;
            square1_r_by_1_15 <= square1_r_by_1_14;
            square1_r_amount_2_15 <= square1_r_amount_2_14;
            square1_r_by_4_15 <= square1_r_by_4_14;
            square1_g_by_1_15 <= square1_g_by_1_14;
            square1_g_amount_2_15 <= square1_g_amount_2_14;
            square1_g_by_4_15 <= square1_g_by_4_14;
            square1_b_by_1_15 <= square1_b_by_1_14;
            square1_b_amount_2_15 <= square1_b_amount_2_14;
            square1_b_by_4_15 <= square1_b_by_4_14;
        end
    end

    // ===== Stage 15: tilt1_exact
    // Q8.24: the sine of the angle to h
    wire [32:0] tilt1_exact_15 = $signed(u1_kept_signed_15) * $signed(root_cut1_15);
    // Q6.12: rounded down
    wire [18:0] tilt1_cut_15 = tilt1_exact_15[30:12];
    reg [17:0] in_nz_16;
    reg [14:0] in_turn1_even_16;
    reg [14:0] in_turn1_odd_16;
    reg [17:0] in_gain1r_16;
    reg [17:0] in_gain1g_16;
    reg [17:0] in_gain1b_16;
    reg hidden_16;
    reg v1_is_odd_16;
    reg [15:0] x1_16;
    reg [18:0] tilt1_cut_16;
    reg alone1_16;
    reg [11:0] end1_even_16;
    reg [11:0] end1_odd_16;
    reg [6:0] texels1_000_16;
    reg [6:0] texels1_001_16;
    reg [6:0] texels1_010_16;
    reg [6:0] texels1_011_16;
    reg [6:0] texels1_100_16;
    reg [6:0] texels1_101_16;
    reg [6:0] texels1_110_16;
    reg [6:0] texels1_111_16;
    reg v1_weight_of_0_16;
    reg v1_weight_of_1_16;
    reg v1_weight_of_2_16;
    reg v1_weight_of_3_16;
    reg v1_weight_of_4_16;
    reg v1_weight_of_5_16;
    reg [7:0] blend1_signed_16;
    reg square1_r_by_1_16;
    reg [1:0] square1_r_amount_2_16;
    reg square1_r_by_4_16;
    reg square1_g_by_1_16;
    reg [1:0] square1_g_amount_2_16;
    reg square1_g_by_4_16;
    reg square1_b_by_1_16;
    reg [1:0] square1_b_amount_2_16;
    reg square1_b_by_4_16;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_16 <= in_nz_15;
            in_turn1_even_16 <= in_turn1_even_15;
            in_turn1_odd_16 <= in_turn1_odd_15;
            in_gain1r_16 <= in_gain1r_15;
            in_gain1g_16 <= in_gain1g_15;
            in_gain1b_16 <= in_gain1b_15;
            hidden_16 <= hidden_15;
            v1_is_odd_16 <= v1_is_odd_15;
            x1_16 <= x1_15;
            tilt1_cut_16 <= tilt1_cut_15;
            alone1_16 <= alone1_15;
            end1_even_16 <= end1_even_15;
            end1_odd_16 <= end1_odd_15;
            texels1_000_16 <= texels1_000_15;
            texels1_001_16 <= texels1_001_15;
            texels1_010_16 <= texels1_010_15;
            texels1_011_16 <= texels1_011_15;
            texels1_100_16 <= texels1_100_15;
            texels1_101_16 <= texels1_101_15;
            texels1_110_16 <= texels1_110_15;
            texels1_111_16 <= texels1_111_15;
            v1_weight_of_0_16 <= v1_weight_of_0_15;
            v1_weight_of_1_16 <= v1_weight_of_1_15;
            v1_weight_of_2_16 <= v1_weight_of_2_15;
            v1_weight_of_3_16 <= v1_weight_of_3_15;
            v1_weight_of_4_16 <= v1_weight_of_4_15;
            v1_weight_of_5_16 <= v1_weight_of_5_15;
            blend1_signed_16 <= blend1_signed_15;
            square1_r_by_1_16 <= square1_r_by_1_15;
            square1_r_amount_2_16 <= square1_r_amount_2_15;
            square1_r_by_4_16 <= square1_r_by_4_15;
            square1_g_by_1_16 <= square1_g_by_1_15;
            square1_g_amount_2_16 <= square1_g_amount_2_15;
            square1_g_by_4_16 <= square1_g_by_4_15;
            square1_b_by_1_16 <= square1_b_by_1_15;
            square1_b_amount_2_16 <= square1_b_amount_2_15;
            square1_b_by_4_16 <= square1_b_by_4_15;
        end
    end

    // ===== Stage 16: tilt1_kept, tilt1
    // UQ1.12: at most 1
    wire [12:0] tilt1_kept_16 =
        tilt1_cut_16[18] ? 13'h0000 : (|tilt1_cut_16[17:12]) ? 13'h1000 : tilt1_cut_16[12:0];
    // UQ1.12: the sine of the angle to h; 1/2, which makes k = 3/4, where one image is alone
    wire [12:0] tilt1_16 = alone1_16 ? 13'h0800 : tilt1_kept_16;
    // Q1.12: a sign bit for the signed product
    wire [13:0] tilt1_signed_16 = {1'd0, tilt1_16};
    reg [17:0] in_nz_17;
    reg [14:0] in_turn1_even_17;
    reg [14:0] in_turn1_odd_17;
    reg [17:0] in_gain1r_17;
    reg [17:0] in_gain1g_17;
    reg [17:0] in_gain1b_17;
    reg hidden_17;
    reg v1_is_odd_17;
    reg [15:0] x1_17;
    reg [13:0] tilt1_signed_17;
    reg [11:0] end1_even_17;
    reg [11:0] end1_odd_17;
    reg [6:0] texels1_000_17;
    reg [6:0] texels1_001_17;
    reg [6:0] texels1_010_17;
    reg [6:0] texels1_011_17;
    reg [6:0] texels1_100_17;
    reg [6:0] texels1_101_17;
    reg [6:0] texels1_110_17;
    reg [6:0] texels1_111_17;
    reg v1_weight_of_0_17;
    reg v1_weight_of_1_17;
    reg v1_weight_of_2_17;
    reg v1_weight_of_3_17;
    reg v1_weight_of_4_17;
    reg v1_weight_of_5_17;
    reg [7:0] blend1_signed_17;
    reg square1_r_by_1_17;
    reg [1:0] square1_r_amount_2_17;
    reg square1_r_by_4_17;
    reg square1_g_by_1_17;
    reg [1:0] square1_g_amount_2_17;
    reg square1_g_by_4_17;
    reg square1_b_by_1_17;
    reg [1:0] square1_b_amount_2_17;
    reg square1_b_by_4_17;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_17 <= in_nz_16;
            in_turn1_even_17 <= in_turn1_even_16;
            in_turn1_odd_17 <= in_turn1_odd_16;
            in_gain1r_17 <= in_gain1r_16;
            in_gain1g_17 <= in_gain1g_16;
            in_gain1b_17 <= in_gain1b_16;
            hidden_17 <= hidden_16;
            v1_is_odd_17 <= v1_is_odd_16;
            x1_17 <= x1_16;
            tilt1_signed_17 <= tilt1_signed_16;
            end1_even_17 <= end1_even_16;
            end1_odd_17 <= end1_odd_16;
            texels1_000_17 <= texels1_000_16;
            texels1_001_17 <= texels1_001_16;
            texels1_010_17 <= texels1_010_16;
            texels1_011_17 <= texels1_011_16;
            texels1_100_17 <= texels1_100_16;
            texels1_101_17 <= texels1_101_16;
            texels1_110_17 <= texels1_110_16;
            texels1_111_17 <= texels1_111_16;
            v1_weight_of_0_17 <= v1_weight_of_0_16;
            v1_weight_of_1_17 <= v1_weight_of_1_16;
            v1_weight_of_2_17 <= v1_weight_of_2_16;
            v1_weight_of_3_17 <= v1_weight_of_3_16;
            v1_weight_of_4_17 <= v1_weight_of_4_16;
            v1_weight_of_5_17 <= v1_weight_of_5_16;
            blend1_signed_17 <= blend1_signed_16;
            square1_r_by_1_17 <= square1_r_by_1_16;
            square1_r_amount_2_17 <= square1_r_amount_2_16;
            square1_r_by_4_17 <= square1_r_by_4_16;
            square1_g_by_1_17 <= square1_g_by_1_16;
            square1_g_amount_2_17 <= square1_g_amount_2_16;
            square1_g_by_4_17 <= square1_g_by_4_16;
            square1_b_by_1_17 <= square1_b_by_1_16;
            square1_b_amount_2_17 <= square1_b_amount_2_16;
            square1_b_by_4_17 <= square1_b_by_4_16;
        end
    end

    // ===== Stage 17: turn_more_exact1_even, turn_more_exact1_odd
    // Q2.26: its part by the tilt
    wire [28:0] turn_more_exact1_even_17 = $signed(in_turn1_even_17) * $signed(tilt1_signed_17);
    // Q0.14: rounded down
    wire [14:0] turn_more1_even_17 = turn_more_exact1_even_17[26:12];
    // Q2.26: its part by the tilt
    wire [28:0] turn_more_exact1_odd_17 = $signed(in_turn1_odd_17) * $signed(tilt1_signed_17);
    // Q0.14: rounded down
    wire [14:0] turn_more1_odd_17 = turn_more_exact1_odd_17[26:12];
    reg [17:0] in_nz_18;
    reg [14:0] in_turn1_even_18;
    reg [14:0] in_turn1_odd_18;
    reg [17:0] in_gain1r_18;
    reg [17:0] in_gain1g_18;
    reg [17:0] in_gain1b_18;
    reg hidden_18;
    reg v1_is_odd_18;
    reg [15:0] x1_18;
    reg [14:0] turn_more1_even_18;
    reg [11:0] end1_even_18;
    reg [14:0] turn_more1_odd_18;
    reg [11:0] end1_odd_18;
    reg [6:0] texels1_000_18;
    reg [6:0] texels1_001_18;
    reg [6:0] texels1_010_18;
    reg [6:0] texels1_011_18;
    reg [6:0] texels1_100_18;
    reg [6:0] texels1_101_18;
    reg [6:0] texels1_110_18;
    reg [6:0] texels1_111_18;
    reg v1_weight_of_0_18;
    reg v1_weight_of_1_18;
    reg v1_weight_of_2_18;
    reg v1_weight_of_3_18;
    reg v1_weight_of_4_18;
    reg v1_weight_of_5_18;
    reg [7:0] blend1_signed_18;
    reg square1_r_by_1_18;
    reg [1:0] square1_r_amount_2_18;
    reg square1_r_by_4_18;
    reg square1_g_by_1_18;
    reg [1:0] square1_g_amount_2_18;
    reg square1_g_by_4_18;
    reg square1_b_by_1_18;
    reg [1:0] square1_b_amount_2_18;
    reg square1_b_by_4_18;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_18 <= in_nz_17;
            in_turn1_even_18 <= in_turn1_even_17;
            in_turn1_odd_18 <= in_turn1_odd_17;
            in_gain1r_18 <= in_gain1r_17;
            in_gain1g_18 <= in_gain1g_17;
            in_gain1b_18 <= in_gain1b_17;
            hidden_18 <= hidden_17;
            v1_is_odd_18 <= v1_is_odd_17;
            x1_18 <= x1_17;
            turn_more1_even_18 <= turn_more1_even_17;
            end1_even_18 <= end1_even_17;
            turn_more1_odd_18 <= turn_more1_odd_17;
            end1_odd_18 <= end1_odd_17;
            texels1_000_18 <= texels1_000_17;
            texels1_001_18 <= texels1_001_17;
            texels1_010_18 <= texels1_010_17;
            texels1_011_18 <= texels1_011_17;
            texels1_100_18 <= texels1_100_17;
            texels1_101_18 <= texels1_101_17;
            texels1_110_18 <= texels1_110_17;
            texels1_111_18 <= texels1_111_17;
            v1_weight_of_0_18 <= v1_weight_of_0_17;
            v1_weight_of_1_18 <= v1_weight_of_1_17;
            v1_weight_of_2_18 <= v1_weight_of_2_17;
            v1_weight_of_3_18 <= v1_weight_of_3_17;
            v1_weight_of_4_18 <= v1_weight_of_4_17;
            v1_weight_of_5_18 <= v1_weight_of_5_17;
            blend1_signed_18 <= blend1_signed_17;
            square1_r_by_1_18 <= square1_r_by_1_17;
            square1_r_amount_2_18 <= square1_r_amount_2_17;
            square1_r_by_4_18 <= square1_r_by_4_17;
            square1_g_by_1_18 <= square1_g_by_1_17;
            square1_g_amount_2_18 <= square1_g_amount_2_17;
            square1_g_by_4_18 <= square1_g_by_4_17;
            square1_b_by_1_18 <= square1_b_by_1_17;
            square1_b_amount_2_18 <= square1_b_amount_2_17;
            square1_b_by_4_18 <= square1_b_by_4_17;
        end
    end

    // ===== Stage 18: turn_exact1_even, turn_exact1_odd
    // Q1.14: the turn k (phi_i - phi), in right angles
    wire [15:0] turn_exact1_even_18 =
        {{1{in_turn1_even_18[14]}}, in_turn1_even_18} + {{1{turn_more1_even_18[14]}}, turn_more1_even_18};
    // Q1.14: the turn k (phi_i - phi), in right angles
    wire [15:0] turn_exact1_odd_18 =
        {{1{in_turn1_odd_18[14]}}, in_turn1_odd_18} + {{1{turn_more1_odd_18[14]}}, turn_more1_odd_18};
    reg [17:0] in_nz_19;
    reg [17:0] in_gain1r_19;
    reg [17:0] in_gain1g_19;
    reg [17:0] in_gain1b_19;
    reg hidden_19;
    reg v1_is_odd_19;
    reg [15:0] x1_19;
    reg [15:0] turn_exact1_even_19;
    reg [11:0] end1_even_19;
    reg [15:0] turn_exact1_odd_19;
    reg [11:0] end1_odd_19;
    reg [6:0] texels1_000_19;
    reg [6:0] texels1_001_19;
    reg [6:0] texels1_010_19;
    reg [6:0] texels1_011_19;
    reg [6:0] texels1_100_19;
    reg [6:0] texels1_101_19;
    reg [6:0] texels1_110_19;
    reg [6:0] texels1_111_19;
    reg v1_weight_of_0_19;
    reg v1_weight_of_1_19;
    reg v1_weight_of_2_19;
    reg v1_weight_of_3_19;
    reg v1_weight_of_4_19;
    reg v1_weight_of_5_19;
    reg [7:0] blend1_signed_19;
    reg square1_r_by_1_19;
    reg [1:0] square1_r_amount_2_19;
    reg square1_r_by_4_19;
    reg square1_g_by_1_19;
    reg [1:0] square1_g_amount_2_19;
    reg square1_g_by_4_19;
    reg square1_b_by_1_19;
    reg [1:0] square1_b_amount_2_19;
    reg square1_b_by_4_19;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_19 <= in_nz_18;
            in_gain1r_19 <= in_gain1r_18;
            in_gain1g_19 <= in_gain1g_18;
            in_gain1b_19 <= in_gain1b_18;
            hidden_19 <= hidden_18;
            v1_is_odd_19 <= v1_is_odd_18;
            x1_19 <= x1_18;
            turn_exact1_even_19 <= turn_exact1_even_18;
            end1_even_19 <= end1_even_18;
            turn_exact1_odd_19 <= turn_exact1_odd_18;
            end1_odd_19 <= end1_odd_18;
            texels1_000_19 <= texels1_000_18;
            texels1_001_19 <= texels1_001_18;
            texels1_010_19 <= texels1_010_18;
            texels1_011_19 <= texels1_011_18;
            texels1_100_19 <= texels1_100_18;
            texels1_101_19 <= texels1_101_18;
            texels1_110_19 <= texels1_110_18;
            texels1_111_19 <= texels1_111_18;
            v1_weight_of_0_19 <= v1_weight_of_0_18;
            v1_weight_of_1_19 <= v1_weight_of_1_18;
            v1_weight_of_2_19 <= v1_weight_of_2_18;
            v1_weight_of_3_19 <= v1_weight_of_3_18;
            v1_weight_of_4_19 <= v1_weight_of_4_18;
            v1_weight_of_5_19 <= v1_weight_of_5_18;
            blend1_signed_19 <= blend1_signed_18;
            square1_r_by_1_19 <= square1_r_by_1_18;
            square1_r_amount_2_19 <= square1_r_amount_2_18;
            square1_r_by_4_19 <= square1_r_by_4_18;
            square1_g_by_1_19 <= square1_g_by_1_18;
            square1_g_amount_2_19 <= square1_g_amount_2_18;
            square1_g_by_4_19 <= square1_g_by_4_18;
            square1_b_by_1_19 <= square1_b_by_1_18;
            square1_b_amount_2_19 <= square1_b_amount_2_18;
            square1_b_by_4_19 <= square1_b_by_4_18;
        end
    end

    // ===== Stage 19: turn1_even, turn1_odd
    // Q0.14: less than a right angle
    wire [14:0] turn1_even_19 = (turn_exact1_even_19[15] & ~&turn_exact1_even_19[14]) ? 15'h4000 :
        (~turn_exact1_even_19[15] & |turn_exact1_even_19[14]) ? 15'h3fff :
        turn_exact1_even_19[14:0];
    // Q0.14: less than a right angle
    wire [14:0] turn1_odd_19 = (turn_exact1_odd_19[15] & ~&turn_exact1_odd_19[14]) ? 15'h4000 :
        (~turn_exact1_odd_19[15] & |turn_exact1_odd_19[14]) ? 15'h3fff :
        turn_exact1_odd_19[14:0];
    reg [17:0] in_nz_20;
    reg [17:0] in_gain1r_20;
    reg [17:0] in_gain1g_20;
    reg [17:0] in_gain1b_20;
    reg hidden_20;
    reg v1_is_odd_20;
    reg [15:0] x1_20;
    reg [14:0] turn1_even_20;
    reg [11:0] end1_even_20;
    reg [14:0] turn1_odd_20;
    reg [11:0] end1_odd_20;
    reg [6:0] texels1_000_20;
    reg [6:0] texels1_001_20;
    reg [6:0] texels1_010_20;
    reg [6:0] texels1_011_20;
    reg [6:0] texels1_100_20;
    reg [6:0] texels1_101_20;
    reg [6:0] texels1_110_20;
    reg [6:0] texels1_111_20;
    reg v1_weight_of_0_20;
    reg v1_weight_of_1_20;
    reg v1_weight_of_2_20;
    reg v1_weight_of_3_20;
    reg v1_weight_of_4_20;
    reg v1_weight_of_5_20;
    reg [7:0] blend1_signed_20;
    reg square1_r_by_1_20;
    reg [1:0] square1_r_amount_2_20;
    reg square1_r_by_4_20;
    reg square1_g_by_1_20;
    reg [1:0] square1_g_amount_2_20;
    reg square1_g_by_4_20;
    reg square1_b_by_1_20;
    reg [1:0] square1_b_amount_2_20;
    reg square1_b_by_4_20;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_20 <= in_nz_19;
            in_gain1r_20 <= in_gain1r_19;
            in_gain1g_20 <= in_gain1g_19;
            in_gain1b_20 <= in_gain1b_19;
            hidden_20 <= hidden_19;
            v1_is_odd_20 <= v1_is_odd_19;
            x1_20 <= x1_19;
            turn1_even_20 <= turn1_even_19;
            end1_even_20 <= end1_even_19;
            turn1_odd_20 <= turn1_odd_19;
            end1_odd_20 <= end1_odd_19;
            texels1_000_20 <= texels1_000_19;
            texels1_001_20 <= texels1_001_19;
            texels1_010_20 <= texels1_010_19;
            texels1_011_20 <= texels1_011_19;
            texels1_100_20 <= texels1_100_19;
            texels1_101_20 <= texels1_101_19;
            texels1_110_20 <= texels1_110_19;
            texels1_111_20 <= texels1_111_19;
            v1_weight_of_0_20 <= v1_weight_of_0_19;
            v1_weight_of_1_20 <= v1_weight_of_1_19;
            v1_weight_of_2_20 <= v1_weight_of_2_19;
            v1_weight_of_3_20 <= v1_weight_of_3_19;
            v1_weight_of_4_20 <= v1_weight_of_4_19;
            v1_weight_of_5_20 <= v1_weight_of_5_19;
            blend1_signed_20 <= blend1_signed_19;
            square1_r_by_1_20 <= square1_r_by_1_19;
            square1_r_amount_2_20 <= square1_r_amount_2_19;
            square1_r_by_4_20 <= square1_r_by_4_19;
            square1_g_by_1_20 <= square1_g_by_1_19;
            square1_g_amount_2_20 <= square1_g_amount_2_19;
            square1_g_by_4_20 <= square1_g_by_4_19;
            square1_b_by_1_20 <= square1_b_by_1_19;
            square1_b_amount_2_20 <= square1_b_amount_2_19;
            square1_b_by_4_20 <= square1_b_by_4_19;
        end
    end

    // ===== Stage 20: turn_up1_even, turn_up1_odd
    // UQ1.14: from minus a right angle
    wire [14:0] turn_up1_even_20 = turn1_even_20 + 15'h4000;
    // UQ1.6: the table's row
    wire [6:0] step1_even_20 = turn_up1_even_20[14:8];
    // UQ7.0: its number
    wire [6:0] step_number1_even_20 = step1_even_20;
    // UQ-6.14: the angle past it
    wire [7:0] past1_even_20 = turn_up1_even_20[7:0];
    // UQ0.8: as a part of the way to the next
    wire [7:0] past_part1_even_20 = past1_even_20;
    // Q0.8: a sign bit for the signed product
    wire [8:0] past_part1_even_signed_20 = {1'd0, past_part1_even_20};
    // UQ1.14: from minus a right angle
    wire [14:0] turn_up1_odd_20 = turn1_odd_20 + 15'h4000;
    // UQ1.6: the table's row
    wire [6:0] step1_odd_20 = turn_up1_odd_20[14:8];
    // UQ7.0: its number
    wire [6:0] step_number1_odd_20 = step1_odd_20;
    // UQ-6.14: the angle past it
    wire [7:0] past1_odd_20 = turn_up1_odd_20[7:0];
    // UQ0.8: as a part of the way to the next
    wire [7:0] past_part1_odd_20 = past1_odd_20;
    // Q0.8: a sign bit for the signed product
    wire [8:0] past_part1_odd_signed_20 = {1'd0, past_part1_odd_20};
    reg [17:0] in_nz_21;
    reg [17:0] in_gain1r_21;
    reg [17:0] in_gain1g_21;
    reg [17:0] in_gain1b_21;
    reg hidden_21;
    reg v1_is_odd_21;
    reg [15:0] x1_21;
    reg [6:0] step_number1_even_21;
    reg [7:0] past_part1_even_21;
    reg [8:0] past_part1_even_signed_21;
    reg [11:0] end1_even_21;
    reg [6:0] step_number1_odd_21;
    reg [7:0] past_part1_odd_21;
    reg [8:0] past_part1_odd_signed_21;
    reg [11:0] end1_odd_21;
    reg [6:0] texels1_000_21;
    reg [6:0] texels1_001_21;
    reg [6:0] texels1_010_21;
    reg [6:0] texels1_011_21;
    reg [6:0] texels1_100_21;
    reg [6:0] texels1_101_21;
    reg [6:0] texels1_110_21;
    reg [6:0] texels1_111_21;
    reg v1_weight_of_0_21;
    reg v1_weight_of_1_21;
    reg v1_weight_of_2_21;
    reg v1_weight_of_3_21;
    reg v1_weight_of_4_21;
    reg v1_weight_of_5_21;
    reg [7:0] blend1_signed_21;
    reg square1_r_by_1_21;
    reg [1:0] square1_r_amount_2_21;
    reg square1_r_by_4_21;
    reg square1_g_by_1_21;
    reg [1:0] square1_g_amount_2_21;
    reg square1_g_by_4_21;
    reg square1_b_by_1_21;
    reg [1:0] square1_b_amount_2_21;
    reg square1_b_by_4_21;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_21 <= in_nz_20;
            in_gain1r_21 <= in_gain1r_20;
            in_gain1g_21 <= in_gain1g_20;
            in_gain1b_21 <= in_gain1b_20;
            hidden_21 <= hidden_20;
            v1_is_odd_21 <= v1_is_odd_20;
            x1_21 <= x1_20;
            step_number1_even_21 <= step_number1_even_20;
            past_part1_even_21 <= past_part1_even_20;
            past_part1_even_signed_21 <= past_part1_even_signed_20;
            end1_even_21 <= end1_even_20;
            step_number1_odd_21 <= step_number1_odd_20;
            past_part1_odd_21 <= past_part1_odd_20;
            past_part1_odd_signed_21 <= past_part1_odd_signed_20;
            end1_odd_21 <= end1_odd_20;
            texels1_000_21 <= texels1_000_20;
            texels1_001_21 <= texels1_001_20;
            texels1_010_21 <= texels1_010_20;
            texels1_011_21 <= texels1_011_20;
            texels1_100_21 <= texels1_100_20;
            texels1_101_21 <= texels1_101_20;
            texels1_110_21 <= texels1_110_20;
            texels1_111_21 <= texels1_111_20;
            v1_weight_of_0_21 <= v1_weight_of_0_20;
            v1_weight_of_1_21 <= v1_weight_of_1_20;
            v1_weight_of_2_21 <= v1_weight_of_2_20;
            v1_weight_of_3_21 <= v1_weight_of_3_20;
            v1_weight_of_4_21 <= v1_weight_of_4_20;
            v1_weight_of_5_21 <= v1_weight_of_5_20;
            blend1_signed_21 <= blend1_signed_20;
            square1_r_by_1_21 <= square1_r_by_1_20;
            square1_r_amount_2_21 <= square1_r_amount_2_20;
            square1_r_by_4_21 <= square1_r_by_4_20;
            square1_g_by_1_21 <= square1_g_by_1_20;
            square1_g_amount_2_21 <= square1_g_amount_2_20;
            square1_g_by_4_21 <= square1_g_by_4_20;
            square1_b_by_1_21 <= square1_b_by_1_20;
            square1_b_amount_2_21 <= square1_b_amount_2_20;
            square1_b_by_4_21 <= square1_b_by_4_20;
        end
    end

    // ===== Stage 21: read sines_1_even, read sines_1_odd
    // The word of the memory sines_1_even, of 128 words.
    reg [52:0] sines_1_even_22;
    // The word of the memory sines_1_odd, of 128 words.
    reg [52:0] sines_1_odd_22;
    reg [52:0] sines_1_even [0:127];
    initial $readmemh(SINES_1_EVEN_FILE, sines_1_even);
    always @(posedge clk) begin
        if (ce) sines_1_even_22 <= sines_1_even[step_number1_even_21];
    end
    reg [52:0] sines_1_odd [0:127];
    initial $readmemh(SINES_1_ODD_FILE, sines_1_odd);
    always @(posedge clk) begin
        if (ce) sines_1_odd_22 <= sines_1_odd[step_number1_odd_21];
    end
    reg [17:0] in_nz_22;
    reg [17:0] in_gain1r_22;
    reg [17:0] in_gain1g_22;
    reg [17:0] in_gain1b_22;
    reg hidden_22;
    reg v1_is_odd_22;
    reg [15:0] x1_22;
    reg [7:0] past_part1_even_22;
    reg [8:0] past_part1_even_signed_22;
    reg [11:0] end1_even_22;
    reg [7:0] past_part1_odd_22;
    reg [8:0] past_part1_odd_signed_22;
    reg [11:0] end1_odd_22;
    reg [6:0] texels1_000_22;
    reg [6:0] texels1_001_22;
    reg [6:0] texels1_010_22;
    reg [6:0] texels1_011_22;
    reg [6:0] texels1_100_22;
    reg [6:0] texels1_101_22;
    reg [6:0] texels1_110_22;
    reg [6:0] texels1_111_22;
    reg v1_weight_of_0_22;
    reg v1_weight_of_1_22;
    reg v1_weight_of_2_22;
    reg v1_weight_of_3_22;
    reg v1_weight_of_4_22;
    reg v1_weight_of_5_22;
    reg [7:0] blend1_signed_22;
    reg square1_r_by_1_22;
    reg [1:0] square1_r_amount_2_22;
    reg square1_r_by_4_22;
    reg square1_g_by_1_22;
    reg [1:0] square1_g_amount_2_22;
    reg square1_g_by_4_22;
    reg square1_b_by_1_22;
    reg [1:0] square1_b_amount_2_22;
    reg square1_b_by_4_22;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_22 <= in_nz_21;
            in_gain1r_22 <= in_gain1r_21;
            in_gain1g_22 <= in_gain1g_21;
            in_gain1b_22 <= in_gain1b_21;
            hidden_22 <= hidden_21;
            v1_is_odd_22 <= v1_is_odd_21;
            x1_22 <= x1_21;
            past_part1_even_22 <= past_part1_even_21;
            past_part1_even_signed_22 <= past_part1_even_signed_21;
            end1_even_22 <= end1_even_21;
            past_part1_odd_22 <= past_part1_odd_21;
            past_part1_odd_signed_22 <= past_part1_odd_signed_21;
            end1_odd_22 <= end1_odd_21;
            texels1_000_22 <= texels1_000_21;
            texels1_001_22 <= texels1_001_21;
            texels1_010_22 <= texels1_010_21;
            texels1_011_22 <= texels1_011_21;
            texels1_100_22 <= texels1_100_21;
            texels1_101_22 <= texels1_101_21;
            texels1_110_22 <= texels1_110_21;
            texels1_111_22 <= texels1_111_21;
            v1_weight_of_0_22 <= v1_weight_of_0_21;
            v1_weight_of_1_22 <= v1_weight_of_1_21;
            v1_weight_of_2_22 <= v1_weight_of_2_21;
            v1_weight_of_3_22 <= v1_weight_of_3_21;
            v1_weight_of_4_22 <= v1_weight_of_4_21;
            v1_weight_of_5_22 <= v1_weight_of_5_21;
            blend1_signed_22 <= blend1_signed_21;
            square1_r_by_1_22 <= square1_r_by_1_21;
            square1_r_amount_2_22 <= square1_r_amount_2_21;
            square1_r_by_4_22 <= square1_r_by_4_21;
            square1_g_by_1_22 <= square1_g_by_1_21;
            square1_g_amount_2_22 <= square1_g_amount_2_21;
            square1_g_by_4_22 <= square1_g_by_4_21;
            square1_b_by_1_22 <= square1_b_by_1_21;
            square1_b_amount_2_22 <= square1_b_amount_2_21;
            square1_b_by_4_22 <= square1_b_by_4_21;
        end
    end

    // ===== Stage 22: registers only
    // Q0.14: the sine
    wire [14:0] sine_1_even_22 = sines_1_even_22[52:38];
    // UQ-5.16: what it rises by to the next row
    wire [10:0] sine_rise_1_even_22 = sines_1_even_22[37:27];
    // UQ1.14: the cosine
    wire [14:0] cosine_1_even_22 = sines_1_even_22[26:12];
    // Q-5.16: what it rises by to the next row
    wire [11:0] cosine_rise_1_even_22 = sines_1_even_22[11:0];
    // Q0.14: the sine
    wire [14:0] sine_1_odd_22 = sines_1_odd_22[52:38];
    // UQ-5.16: what it rises by to the next row
    wire [10:0] sine_rise_1_odd_22 = sines_1_odd_22[37:27];
    // UQ1.14: the cosine
    wire [14:0] cosine_1_odd_22 = sines_1_odd_22[26:12];
    // Q-5.16: what it rises by to the next row
    wire [11:0] cosine_rise_1_odd_22 = sines_1_odd_22[11:0];
    reg [17:0] in_nz_23;
    reg [17:0] in_gain1r_23;
    reg [17:0] in_gain1g_23;
    reg [17:0] in_gain1b_23;
    reg hidden_23;
    reg v1_is_odd_23;
    reg [15:0] x1_23;
    reg [7:0] past_part1_even_23;
    reg [14:0] sine_1_even_23;
    reg [10:0] sine_rise_1_even_23;
    reg [14:0] cosine_1_even_23;
    reg [11:0] cosine_rise_1_even_23;
    reg [8:0] past_part1_even_signed_23;
    reg [11:0] end1_even_23;
    reg [7:0] past_part1_odd_23;
    reg [14:0] sine_1_odd_23;
    reg [10:0] sine_rise_1_odd_23;
    reg [14:0] cosine_1_odd_23;
    reg [11:0] cosine_rise_1_odd_23;
    reg [8:0] past_part1_odd_signed_23;
    reg [11:0] end1_odd_23;
    reg [6:0] texels1_000_23;
    reg [6:0] texels1_001_23;
    reg [6:0] texels1_010_23;
    reg [6:0] texels1_011_23;
    reg [6:0] texels1_100_23;
    reg [6:0] texels1_101_23;
    reg [6:0] texels1_110_23;
    reg [6:0] texels1_111_23;
    reg v1_weight_of_0_23;
    reg v1_weight_of_1_23;
    reg v1_weight_of_2_23;
    reg v1_weight_of_3_23;
    reg v1_weight_of_4_23;
    reg v1_weight_of_5_23;
    reg [7:0] blend1_signed_23;
    reg square1_r_by_1_23;
    reg [1:0] square1_r_amount_2_23;
    reg square1_r_by_4_23;
    reg square1_g_by_1_23;
    reg [1:0] square1_g_amount_2_23;
    reg square1_g_by_4_23;
    reg square1_b_by_1_23;
    reg [1:0] square1_b_amount_2_23;
    reg square1_b_by_4_23;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_23 <= in_nz_22;
            in_gain1r_23 <= in_gain1r_22;
            in_gain1g_23 <= in_gain1g_22;
            in_gain1b_23 <= in_gain1b_22;
            hidden_23 <= hidden_22;
            v1_is_odd_23 <= v1_is_odd_22;
            x1_23 <= x1_22;
            past_part1_even_23 <= past_part1_even_22;
            sine_1_even_23 <= sine_1_even_22;
            sine_rise_1_even_23 <= sine_rise_1_even_22;
            cosine_1_even_23 <= cosine_1_even_22;
            cosine_rise_1_even_23 <= cosine_rise_1_even_22;
            past_part1_even_signed_23 <= past_part1_even_signed_22;
            end1_even_23 <= end1_even_22;
            past_part1_odd_23 <= past_part1_odd_22;
            sine_1_odd_23 <= sine_1_odd_22;
            sine_rise_1_odd_23 <= sine_rise_1_odd_22;
            cosine_1_odd_23 <= cosine_1_odd_22;
            cosine_rise_1_odd_23 <= cosine_rise_1_odd_22;
            past_part1_odd_signed_23 <= past_part1_odd_signed_22;
            end1_odd_23 <= end1_odd_22;
            texels1_000_23 <= texels1_000_22;
            texels1_001_23 <= texels1_001_22;
            texels1_010_23 <= texels1_010_22;
            texels1_011_23 <= texels1_011_22;
            texels1_100_23 <= texels1_100_22;
            texels1_101_23 <= texels1_101_22;
            texels1_110_23 <= texels1_110_22;
            texels1_111_23 <= texels1_111_22;
            v1_weight_of_0_23 <= v1_weight_of_0_22;
            v1_weight_of_1_23 <= v1_weight_of_1_22;
            v1_weight_of_2_23 <= v1_weight_of_2_22;
            v1_weight_of_3_23 <= v1_weight_of_3_22;
            v1_weight_of_4_23 <= v1_weight_of_4_22;
            v1_weight_of_5_23 <= v1_weight_of_5_22;
            blend1_signed_23 <= blend1_signed_22;
            square1_r_by_1_23 <= square1_r_by_1_22;
            square1_r_amount_2_23 <= square1_r_amount_2_22;
            square1_r_by_4_23 <= square1_r_by_4_22;
            square1_g_by_1_23 <= square1_g_by_1_22;
            square1_g_amount_2_23 <= square1_g_amount_2_22;
            square1_g_by_4_23 <= square1_g_by_4_22;
            square1_b_by_1_23 <= square1_b_by_1_22;
            square1_b_amount_2_23 <= square1_b_amount_2_22;
            square1_b_by_4_23 <= square1_b_by_4_22;
        end
    end

    // ===== Stage 23: registers only
    reg [17:0] in_nz_24;
    reg [17:0] in_gain1r_24;
    reg [17:0] in_gain1g_24;
    reg [17:0] in_gain1b_24;
    reg hidden_24;
    reg v1_is_odd_24;
    reg [15:0] x1_24;
    reg [7:0] past_part1_even_24;
    reg [14:0] sine_1_even_24;
    reg [10:0] sine_rise_1_even_24;
    reg [14:0] cosine_1_even_24;
    reg [11:0] cosine_rise_1_even_24;
    reg [8:0] past_part1_even_signed_24;
    reg [11:0] end1_even_24;
    reg [7:0] past_part1_odd_24;
    reg [14:0] sine_1_odd_24;
    reg [10:0] sine_rise_1_odd_24;
    reg [14:0] cosine_1_odd_24;
    reg [11:0] cosine_rise_1_odd_24;
    reg [8:0] past_part1_odd_signed_24;
    reg [11:0] end1_odd_24;
    reg [6:0] texels1_000_24;
    reg [6:0] texels1_001_24;
    reg [6:0] texels1_010_24;
    reg [6:0] texels1_011_24;
    reg [6:0] texels1_100_24;
    reg [6:0] texels1_101_24;
    reg [6:0] texels1_110_24;
    reg [6:0] texels1_111_24;
    reg v1_weight_of_0_24;
    reg v1_weight_of_1_24;
    reg v1_weight_of_2_24;
    reg v1_weight_of_3_24;
    reg v1_weight_of_4_24;
    reg v1_weight_of_5_24;
    reg [7:0] blend1_signed_24;
    reg square1_r_by_1_24;
    reg [1:0] square1_r_amount_2_24;
    reg square1_r_by_4_24;
    reg square1_g_by_1_24;
    reg [1:0] square1_g_amount_2_24;
    reg square1_g_by_4_24;
    reg square1_b_by_1_24;
    reg [1:0] square1_b_amount_2_24;
    reg square1_b_by_4_24;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_24 <= in_nz_23;
            in_gain1r_24 <= in_gain1r_23;
            in_gain1g_24 <= in_gain1g_23;
            in_gain1b_24 <= in_gain1b_23;
            hidden_24 <= hidden_23;
            v1_is_odd_24 <= v1_is_odd_23;
            x1_24 <= x1_23;
            past_part1_even_24 <= past_part1_even_23;
            sine_1_even_24 <= sine_1_even_23;
            sine_rise_1_even_24 <= sine_rise_1_even_23;
            cosine_1_even_24 <= cosine_1_even_23;
            cosine_rise_1_even_24 <= cosine_rise_1_even_23;
            past_part1_even_signed_24 <= past_part1_even_signed_23;
            end1_even_24 <= end1_even_23;
            past_part1_odd_24 <= past_part1_odd_23;
            sine_1_odd_24 <= sine_1_odd_23;
            sine_rise_1_odd_24 <= sine_rise_1_odd_23;
            cosine_1_odd_24 <= cosine_1_odd_23;
            cosine_rise_1_odd_24 <= cosine_rise_1_odd_23;
            past_part1_odd_signed_24 <= past_part1_odd_signed_23;
            end1_odd_24 <= end1_odd_23;
            texels1_000_24 <= texels1_000_23;
            texels1_001_24 <= texels1_001_23;
            texels1_010_24 <= texels1_010_23;
            texels1_011_24 <= texels1_011_23;
            texels1_100_24 <= texels1_100_23;
            texels1_101_24 <= texels1_101_23;
            texels1_110_24 <= texels1_110_23;
            texels1_111_24 <= texels1_111_23;
            v1_weight_of_0_24 <= v1_weight_of_0_23;
            v1_weight_of_1_24 <= v1_weight_of_1_23;
            v1_weight_of_2_24 <= v1_weight_of_2_23;
            v1_weight_of_3_24 <= v1_weight_of_3_23;
            v1_weight_of_4_24 <= v1_weight_of_4_23;
            v1_weight_of_5_24 <= v1_weight_of_5_23;
            blend1_signed_24 <= blend1_signed_23;
            square1_r_by_1_24 <= square1_r_by_1_23;
            square1_r_amount_2_24 <= square1_r_amount_2_23;
            square1_r_by_4_24 <= square1_r_by_4_23;
            square1_g_by_1_24 <= square1_g_by_1_23;
            square1_g_amount_2_24 <= square1_g_amount_2_23;
            square1_g_by_4_24 <= square1_g_by_4_23;
            square1_b_by_1_24 <= square1_b_by_1_23;
            square1_b_amount_2_24 <= square1_b_amount_2_23;
            square1_b_by_4_24 <= square1_b_by_4_23;
        end
    end

    // ===== Stage 24: sin_part1_even, cos_part1_even, sin_part1_odd and 1 more
    // UQ-5.24: its part of the rise
    wire [18:0] sin_part1_even_24 = sine_rise_1_even_24 * past_part1_even_24;
    // Q-4.24: its part of the rise
    wire [20:0] cos_part1_even_24 =
        $signed(cosine_rise_1_even_24) * $signed(past_part1_even_signed_24);
    // UQ-5.24: its part of the rise
    wire [18:0] sin_part1_odd_24 = sine_rise_1_odd_24 * past_part1_odd_24;
    // Q-4.24: its part of the rise
    wire [20:0] cos_part1_odd_24 =
        $signed(cosine_rise_1_odd_24) * $signed(past_part1_odd_signed_24);
    reg [17:0] in_nz_25;
    reg [17:0] in_gain1r_25;
    reg [17:0] in_gain1g_25;
    reg [17:0] in_gain1b_25;
    reg hidden_25;
    reg v1_is_odd_25;
    reg [15:0] x1_25;
    reg [14:0] sine_1_even_25;
    reg [14:0] cosine_1_even_25;
    reg [18:0] sin_part1_even_25;
    reg [20:0] cos_part1_even_25;
    reg [11:0] end1_even_25;
    reg [14:0] sine_1_odd_25;
    reg [14:0] cosine_1_odd_25;
    reg [18:0] sin_part1_odd_25;
    reg [20:0] cos_part1_odd_25;
    reg [11:0] end1_odd_25;
    reg [6:0] texels1_000_25;
    reg [6:0] texels1_001_25;
    reg [6:0] texels1_010_25;
    reg [6:0] texels1_011_25;
    reg [6:0] texels1_100_25;
    reg [6:0] texels1_101_25;
    reg [6:0] texels1_110_25;
    reg [6:0] texels1_111_25;
    reg v1_weight_of_0_25;
    reg v1_weight_of_1_25;
    reg v1_weight_of_2_25;
    reg v1_weight_of_3_25;
    reg v1_weight_of_4_25;
    reg v1_weight_of_5_25;
    reg [7:0] blend1_signed_25;
    reg square1_r_by_1_25;
    reg [1:0] square1_r_amount_2_25;
    reg square1_r_by_4_25;
    reg square1_g_by_1_25;
    reg [1:0] square1_g_amount_2_25;
    reg square1_g_by_4_25;
    reg square1_b_by_1_25;
    reg [1:0] square1_b_amount_2_25;
    reg square1_b_by_4_25;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_25 <= in_nz_24;
            in_gain1r_25 <= in_gain1r_24;
            in_gain1g_25 <= in_gain1g_24;
            in_gain1b_25 <= in_gain1b_24;
            hidden_25 <= hidden_24;
            v1_is_odd_25 <= v1_is_odd_24;
            x1_25 <= x1_24;
            sine_1_even_25 <= sine_1_even_24;
            cosine_1_even_25 <= cosine_1_even_24;
            sin_part1_even_25 <= sin_part1_even_24;
            cos_part1_even_25 <= cos_part1_even_24;
            end1_even_25 <= end1_even_24;
            sine_1_odd_25 <= sine_1_odd_24;
            cosine_1_odd_25 <= cosine_1_odd_24;
            sin_part1_odd_25 <= sin_part1_odd_24;
            cos_part1_odd_25 <= cos_part1_odd_24;
            end1_odd_25 <= end1_odd_24;
            texels1_000_25 <= texels1_000_24;
            texels1_001_25 <= texels1_001_24;
            texels1_010_25 <= texels1_010_24;
            texels1_011_25 <= texels1_011_24;
            texels1_100_25 <= texels1_100_24;
            texels1_101_25 <= texels1_101_24;
            texels1_110_25 <= texels1_110_24;
            texels1_111_25 <= texels1_111_24;
            v1_weight_of_0_25 <= v1_weight_of_0_24;
            v1_weight_of_1_25 <= v1_weight_of_1_24;
            v1_weight_of_2_25 <= v1_weight_of_2_24;
            v1_weight_of_3_25 <= v1_weight_of_3_24;
            v1_weight_of_4_25 <= v1_weight_of_4_24;
            v1_weight_of_5_25 <= v1_weight_of_5_24;
            blend1_signed_25 <= blend1_signed_24;
            square1_r_by_1_25 <= square1_r_by_1_24;
            square1_r_amount_2_25 <= square1_r_amount_2_24;
            square1_r_by_4_25 <= square1_r_by_4_24;
            square1_g_by_1_25 <= square1_g_by_1_24;
            square1_g_amount_2_25 <= square1_g_amount_2_24;
            square1_g_by_4_25 <= square1_g_by_4_24;
            square1_b_by_1_25 <= square1_b_by_1_24;
            square1_b_amount_2_25 <= square1_b_amount_2_24;
            square1_b_by_4_25 <= square1_b_by_4_24;
        end
    end

    // ===== Stage 25: registers only
    reg [17:0] in_nz_26;
    reg [17:0] in_gain1r_26;
    reg [17:0] in_gain1g_26;
    reg [17:0] in_gain1b_26;
    reg hidden_26;
    reg v1_is_odd_26;
    reg [15:0] x1_26;
    reg [14:0] sine_1_even_26;
    reg [14:0] cosine_1_even_26;
    reg [18:0] sin_part1_even_26;
    reg [20:0] cos_part1_even_26;
    reg [11:0] end1_even_26;
    reg [14:0] sine_1_odd_26;
    reg [14:0] cosine_1_odd_26;
    reg [18:0] sin_part1_odd_26;
    reg [20:0] cos_part1_odd_26;
    reg [11:0] end1_odd_26;
    reg [6:0] texels1_000_26;
    reg [6:0] texels1_001_26;
    reg [6:0] texels1_010_26;
    reg [6:0] texels1_011_26;
    reg [6:0] texels1_100_26;
    reg [6:0] texels1_101_26;
    reg [6:0] texels1_110_26;
    reg [6:0] texels1_111_26;
    reg v1_weight_of_0_26;
    reg v1_weight_of_1_26;
    reg v1_weight_of_2_26;
    reg v1_weight_of_3_26;
    reg v1_weight_of_4_26;
    reg v1_weight_of_5_26;
    reg [7:0] blend1_signed_26;
    reg square1_r_by_1_26;
    reg [1:0] square1_r_amount_2_26;
    reg square1_r_by_4_26;
    reg square1_g_by_1_26;
    reg [1:0] square1_g_amount_2_26;
    reg square1_g_by_4_26;
    reg square1_b_by_1_26;
    reg [1:0] square1_b_amount_2_26;
    reg square1_b_by_4_26;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_26 <= in_nz_25;
            in_gain1r_26 <= in_gain1r_25;
            in_gain1g_26 <= in_gain1g_25;
            in_gain1b_26 <= in_gain1b_25;
            hidden_26 <= hidden_25;
            v1_is_odd_26 <= v1_is_odd_25;
            x1_26 <= x1_25;
            sine_1_even_26 <= sine_1_even_25;
            cosine_1_even_26 <= cosine_1_even_25;
            sin_part1_even_26 <= sin_part1_even_25;
            cos_part1_even_26 <= cos_part1_even_25;
            end1_even_26 <= end1_even_25;
            sine_1_odd_26 <= sine_1_odd_25;
            cosine_1_odd_26 <= cosine_1_odd_25;
            sin_part1_odd_26 <= sin_part1_odd_25;
            cos_part1_odd_26 <= cos_part1_odd_25;
            end1_odd_26 <= end1_odd_25;
            texels1_000_26 <= texels1_000_25;
            texels1_001_26 <= texels1_001_25;
            texels1_010_26 <= texels1_010_25;
            texels1_011_26 <= texels1_011_25;
            texels1_100_26 <= texels1_100_25;
            texels1_101_26 <= texels1_101_25;
            texels1_110_26 <= texels1_110_25;
            texels1_111_26 <= texels1_111_25;
            v1_weight_of_0_26 <= v1_weight_of_0_25;
            v1_weight_of_1_26 <= v1_weight_of_1_25;
            v1_weight_of_2_26 <= v1_weight_of_2_25;
            v1_weight_of_3_26 <= v1_weight_of_3_25;
            v1_weight_of_4_26 <= v1_weight_of_4_25;
            v1_weight_of_5_26 <= v1_weight_of_5_25;
            blend1_signed_26 <= blend1_signed_25;
            square1_r_by_1_26 <= square1_r_by_1_25;
            square1_r_amount_2_26 <= square1_r_amount_2_25;
            square1_r_by_4_26 <= square1_r_by_4_25;
            square1_g_by_1_26 <= square1_g_by_1_25;
            square1_g_amount_2_26 <= square1_g_amount_2_25;
            square1_g_by_4_26 <= square1_g_by_4_25;
            square1_b_by_1_26 <= square1_b_by_1_25;
            square1_b_amount_2_26 <= square1_b_amount_2_25;
            square1_b_by_4_26 <= square1_b_by_4_25;
        end
    end

    // ===== Stage 26: sin_exact1_even, cos_exact1_even, sin_exact1_odd and 1 more
    // Q1.24: between two rows
    wire [25:0] sin_exact1_even_26 =
        {{1{sine_1_even_26[14]}}, sine_1_even_26, 10'd0} + {7'd0, sin_part1_even_26};
    // Q1.14: rounded down
    wire [15:0] sin1_even_26 = sin_exact1_even_26[25:10];
    // Q1.24: between two rows
    wire [25:0] cos_exact1_even_26 =
        {1'd0, cosine_1_even_26, 10'd0} + {{5{cos_part1_even_26[20]}}, cos_part1_even_26};
    // Q1.14: rounded down
    wire [15:0] cos1_even_26 = cos_exact1_even_26[25:10];
    // Q1.24: between two rows
    wire [25:0] sin_exact1_odd_26 =
        {{1{sine_1_odd_26[14]}}, sine_1_odd_26, 10'd0} + {7'd0, sin_part1_odd_26};
    // Q1.14: rounded down
    wire [15:0] sin1_odd_26 = sin_exact1_odd_26[25:10];
    // Q1.24: between two rows
    wire [25:0] cos_exact1_odd_26 =
        {1'd0, cosine_1_odd_26, 10'd0} + {{5{cos_part1_odd_26[20]}}, cos_part1_odd_26};
    // Q1.14: rounded down
    wire [15:0] cos1_odd_26 = cos_exact1_odd_26[25:10];
    reg [17:0] in_nz_27;
    reg [17:0] in_gain1r_27;
    reg [17:0] in_gain1g_27;
    reg [17:0] in_gain1b_27;
    reg hidden_27;
    reg v1_is_odd_27;
    reg [15:0] x1_27;
    reg [15:0] sin1_even_27;
    reg [15:0] cos1_even_27;
    reg [11:0] end1_even_27;
    reg [15:0] sin1_odd_27;
    reg [15:0] cos1_odd_27;
    reg [11:0] end1_odd_27;
    reg [6:0] texels1_000_27;
    reg [6:0] texels1_001_27;
    reg [6:0] texels1_010_27;
    reg [6:0] texels1_011_27;
    reg [6:0] texels1_100_27;
    reg [6:0] texels1_101_27;
    reg [6:0] texels1_110_27;
    reg [6:0] texels1_111_27;
    reg v1_weight_of_0_27;
    reg v1_weight_of_1_27;
    reg v1_weight_of_2_27;
    reg v1_weight_of_3_27;
    reg v1_weight_of_4_27;
    reg v1_weight_of_5_27;
    reg [7:0] blend1_signed_27;
    reg square1_r_by_1_27;
    reg [1:0] square1_r_amount_2_27;
    reg square1_r_by_4_27;
    reg square1_g_by_1_27;
    reg [1:0] square1_g_amount_2_27;
    reg square1_g_by_4_27;
    reg square1_b_by_1_27;
    reg [1:0] square1_b_amount_2_27;
    reg square1_b_by_4_27;
    always @(posedge clk) begin
        if (ce) begin
            in_nz_27 <= in_nz_26;
            in_gain1r_27 <= in_gain1r_26;
            in_gain1g_27 <= in_gain1g_26;
            in_gain1b_27 <= in_gain1b_26;
            hidden_27 <= hidden_26;
            v1_is_odd_27 <= v1_is_odd_26;
            x1_27 <= x1_26;
            sin1_even_27 <= sin1_even_26;
            cos1_even_27 <= cos1_even_26;
            end1_even_27 <= end1_even_26;
            sin1_odd_27 <= sin1_odd_26;
            cos1_odd_27 <= cos1_odd_26;
            end1_odd_27 <= end1_odd_26;
            texels1_000_27 <= texels1_000_26;
            texels1_001_27 <= texels1_001_26;
            texels1_010_27 <= texels1_010_26;
            texels1_011_27 <= texels1_011_26;
            texels1_100_27 <= texels1_100_26;
            texels1_101_27 <= texels1_101_26;
            texels1_110_27 <= texels1_110_26;
            texels1_111_27 <= texels1_111_26;
            v1_weight_of_0_27 <= v1_weight_of_0_26;
            v1_weight_of_1_27 <= v1_weight_of_1_26;
            v1_weight_of_2_27 <= v1_weight_of_2_26;
            v1_weight_of_3_27 <= v1_weight_of_3_26;
            v1_weight_of_4_27 <= v1_weight_of_4_26;
            v1_weight_of_5_27 <= v1_weight_of_5_26;
            blend1_signed_27 <= blend1_signed_26;
            square1_r_by_1_27 <= square1_r_by_1_26;
            square1_r_amount_2_27 <= square1_r_amount_2_26;
            square1_r_by_4_27 <= square1_r_by_4_26;
            square1_g_by_1_27 <= square1_g_by_1_26;
            square1_g_amount_2_27 <= square1_g_amount_2_26;
            square1_g_by_4_27 <= square1_g_by_4_26;
            square1_b_by_1_27 <= square1_b_by_1_26;
            square1_b_amount_2_27 <= square1_b_amount_2_26;
            square1_b_by_4_27 <= square1_b_by_4_26;
        end
    end

    // ===== Stage 27: xc1_even_exact, zs1_even_exact, zc1_even_exact and 5 more
    // Q3.28: x cos
    wire [31:0] xc1_even_exact_27 = $signed(x1_27) * $signed(cos1_even_27);
    // Q1.14: rounded down
    wire [15:0] xc1_even_27 = xc1_even_exact_27[29:14];
    // Q3.30: z sin
    wire [33:0] zs1_even_exact_27 = $signed(in_nz_27) * $signed(sin1_even_27);
    // Q2.14: rounded down
    wire [16:0] zs1_even_27 = zs1_even_exact_27[32:16];
    // Q3.30: z cos
    wire [33:0] zc1_even_exact_27 = $signed(in_nz_27) * $signed(cos1_even_27);
    // Q2.14: rounded down
    wire [16:0] zc1_even_27 = zc1_even_exact_27[32:16];
    // Q3.28: x sin
    wire [31:0] xs1_even_exact_27 = $signed(x1_27) * $signed(sin1_even_27);
    // Q1.14: rounded down
    wire [15:0] xs1_even_27 = xs1_even_exact_27[29:14];
    // Q3.28: x cos
    wire [31:0] xc1_odd_exact_27 = $signed(x1_27) * $signed(cos1_odd_27);
    // Q1.14: rounded down
    wire [15:0] xc1_odd_27 = xc1_odd_exact_27[29:14];
    // Q3.30: z sin
    wire [33:0] zs1_odd_exact_27 = $signed(in_nz_27) * $signed(sin1_odd_27);
    // Q2.14: rounded down
    wire [16:0] zs1_odd_27 = zs1_odd_exact_27[32:16];
    // Q3.30: z cos
    wire [33:0] zc1_odd_exact_27 = $signed(in_nz_27) * $signed(cos1_odd_27);
    // Q2.14: rounded down
    wire [16:0] zc1_odd_27 = zc1_odd_exact_27[32:16];
    // Q3.28: x sin
    wire [31:0] xs1_odd_exact_27 = $signed(x1_27) * $signed(sin1_odd_27);
    // Q1.14: rounded down
    wire [15:0] xs1_odd_27 = xs1_odd_exact_27[29:14];
    reg [17:0] in_gain1r_28;
    reg [17:0] in_gain1g_28;
    reg [17:0] in_gain1b_28;
    reg hidden_28;
    reg v1_is_odd_28;
    reg [15:0] xc1_even_28;
    reg [16:0] zs1_even_28;
    reg [16:0] zc1_even_28;
    reg [15:0] xs1_even_28;
    reg [11:0] end1_even_28;
    reg [15:0] xc1_odd_28;
    reg [16:0] zs1_odd_28;
    reg [16:0] zc1_odd_28;
    reg [15:0] xs1_odd_28;
    reg [11:0] end1_odd_28;
    reg [6:0] texels1_000_28;
    reg [6:0] texels1_001_28;
    reg [6:0] texels1_010_28;
    reg [6:0] texels1_011_28;
    reg [6:0] texels1_100_28;
    reg [6:0] texels1_101_28;
    reg [6:0] texels1_110_28;
    reg [6:0] texels1_111_28;
    reg v1_weight_of_0_28;
    reg v1_weight_of_1_28;
    reg v1_weight_of_2_28;
    reg v1_weight_of_3_28;
    reg v1_weight_of_4_28;
    reg v1_weight_of_5_28;
    reg [7:0] blend1_signed_28;
    reg square1_r_by_1_28;
    reg [1:0] square1_r_amount_2_28;
    reg square1_r_by_4_28;
    reg square1_g_by_1_28;
    reg [1:0] square1_g_amount_2_28;
    reg square1_g_by_4_28;
    reg square1_b_by_1_28;
    reg [1:0] square1_b_amount_2_28;
    reg square1_b_by_4_28;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_28 <= in_gain1r_27;
            in_gain1g_28 <= in_gain1g_27;
            in_gain1b_28 <= in_gain1b_27;
            hidden_28 <= hidden_27;
            v1_is_odd_28 <= v1_is_odd_27;
            xc1_even_28 <= xc1_even_27;
            zs1_even_28 <= zs1_even_27;
            zc1_even_28 <= zc1_even_27;
            xs1_even_28 <= xs1_even_27;
            end1_even_28 <= end1_even_27;
            xc1_odd_28 <= xc1_odd_27;
            zs1_odd_28 <= zs1_odd_27;
            zc1_odd_28 <= zc1_odd_27;
            xs1_odd_28 <= xs1_odd_27;
            end1_odd_28 <= end1_odd_27;
            texels1_000_28 <= texels1_000_27;
            texels1_001_28 <= texels1_001_27;
            texels1_010_28 <= texels1_010_27;
            texels1_011_28 <= texels1_011_27;
            texels1_100_28 <= texels1_100_27;
            texels1_101_28 <= texels1_101_27;
            texels1_110_28 <= texels1_110_27;
            texels1_111_28 <= texels1_111_27;
            v1_weight_of_0_28 <= v1_weight_of_0_27;
            v1_weight_of_1_28 <= v1_weight_of_1_27;
            v1_weight_of_2_28 <= v1_weight_of_2_27;
            v1_weight_of_3_28 <= v1_weight_of_3_27;
            v1_weight_of_4_28 <= v1_weight_of_4_27;
            v1_weight_of_5_28 <= v1_weight_of_5_27;
            blend1_signed_28 <= blend1_signed_27;
            square1_r_by_1_28 <= square1_r_by_1_27;
            square1_r_amount_2_28 <= square1_r_amount_2_27;
            square1_r_by_4_28 <= square1_r_by_4_27;
            square1_g_by_1_28 <= square1_g_by_1_27;
            square1_g_amount_2_28 <= square1_g_amount_2_27;
            square1_g_by_4_28 <= square1_g_by_4_27;
            square1_b_by_1_28 <= square1_b_by_1_27;
            square1_b_amount_2_28 <= square1_b_amount_2_27;
            square1_b_by_4_28 <= square1_b_by_4_27;
        end
    end

    // ===== Stage 28: across1_even, across1_odd
    // Q2.14: x of the turned normal
    wire [16:0] across1_even_28 = {{1{xc1_even_28[15]}}, xc1_even_28} + zs1_even_28;
    // Q7.9: in texels from the middle
    wire [16:0] u1_even_scaled_28 = across1_even_28;
    // Q2.14: x of the turned normal
    wire [16:0] across1_odd_28 = {{1{xc1_odd_28[15]}}, xc1_odd_28} + zs1_odd_28;
    // Q7.9: in texels from the middle
    wire [16:0] u1_odd_scaled_28 = across1_odd_28;
    reg [17:0] in_gain1r_29;
    reg [17:0] in_gain1g_29;
    reg [17:0] in_gain1b_29;
    reg hidden_29;
    reg v1_is_odd_29;
    reg [16:0] zc1_even_29;
    reg [15:0] xs1_even_29;
    reg [16:0] u1_even_scaled_29;
    reg [11:0] end1_even_29;
    reg [16:0] zc1_odd_29;
    reg [15:0] xs1_odd_29;
    reg [16:0] u1_odd_scaled_29;
    reg [11:0] end1_odd_29;
    reg [6:0] texels1_000_29;
    reg [6:0] texels1_001_29;
    reg [6:0] texels1_010_29;
    reg [6:0] texels1_011_29;
    reg [6:0] texels1_100_29;
    reg [6:0] texels1_101_29;
    reg [6:0] texels1_110_29;
    reg [6:0] texels1_111_29;
    reg v1_weight_of_0_29;
    reg v1_weight_of_1_29;
    reg v1_weight_of_2_29;
    reg v1_weight_of_3_29;
    reg v1_weight_of_4_29;
    reg v1_weight_of_5_29;
    reg [7:0] blend1_signed_29;
    reg square1_r_by_1_29;
    reg [1:0] square1_r_amount_2_29;
    reg square1_r_by_4_29;
    reg square1_g_by_1_29;
    reg [1:0] square1_g_amount_2_29;
    reg square1_g_by_4_29;
    reg square1_b_by_1_29;
    reg [1:0] square1_b_amount_2_29;
    reg square1_b_by_4_29;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_29 <= in_gain1r_28;
            in_gain1g_29 <= in_gain1g_28;
            in_gain1b_29 <= in_gain1b_28;
            hidden_29 <= hidden_28;
            v1_is_odd_29 <= v1_is_odd_28;
            zc1_even_29 <= zc1_even_28;
            xs1_even_29 <= xs1_even_28;
            u1_even_scaled_29 <= u1_even_scaled_28;
            end1_even_29 <= end1_even_28;
            zc1_odd_29 <= zc1_odd_28;
            xs1_odd_29 <= xs1_odd_28;
            u1_odd_scaled_29 <= u1_odd_scaled_28;
            end1_odd_29 <= end1_odd_28;
            texels1_000_29 <= texels1_000_28;
            texels1_001_29 <= texels1_001_28;
            texels1_010_29 <= texels1_010_28;
            texels1_011_29 <= texels1_011_28;
            texels1_100_29 <= texels1_100_28;
            texels1_101_29 <= texels1_101_28;
            texels1_110_29 <= texels1_110_28;
            texels1_111_29 <= texels1_111_28;
            v1_weight_of_0_29 <= v1_weight_of_0_28;
            v1_weight_of_1_29 <= v1_weight_of_1_28;
            v1_weight_of_2_29 <= v1_weight_of_2_28;
            v1_weight_of_3_29 <= v1_weight_of_3_28;
            v1_weight_of_4_29 <= v1_weight_of_4_28;
            v1_weight_of_5_29 <= v1_weight_of_5_28;
            blend1_signed_29 <= blend1_signed_28;
            square1_r_by_1_29 <= square1_r_by_1_28;
            square1_r_amount_2_29 <= square1_r_amount_2_28;
            square1_r_by_4_29 <= square1_r_by_4_28;
            square1_g_by_1_29 <= square1_g_by_1_28;
            square1_g_amount_2_29 <= square1_g_amount_2_28;
            square1_g_by_4_29 <= square1_g_by_4_28;
            square1_b_by_1_29 <= square1_b_by_1_28;
            square1_b_amount_2_29 <= square1_b_amount_2_28;
            square1_b_by_4_29 <= square1_b_by_4_28;
        end
    end

    // ===== Stage 29: behind1_even, u1_even_place, behind1_odd, u1_odd_place
    // UQ1.0: whether it is behind the rim, z < 0
    wire behind1_even_29 = $signed({{1{xs1_even_29[15]}}, xs1_even_29}) > $signed(zc1_even_29);
    // Q8.9: from the first, plus half a weight's last bit
    wire [17:0] u1_even_place_29 = {{1{u1_even_scaled_29[16]}}, u1_even_scaled_29} + 18'h03f04;
    // Q8.6: rounded to the nearest weight
    wire [14:0] u1_even_cut_29 = u1_even_place_29[17:3];
    // UQ1.0: whether it is behind the rim, z < 0
    wire behind1_odd_29 = $signed({{1{xs1_odd_29[15]}}, xs1_odd_29}) > $signed(zc1_odd_29);
    // Q8.9: from the first, plus half a weight's last bit
    wire [17:0] u1_odd_place_29 = {{1{u1_odd_scaled_29[16]}}, u1_odd_scaled_29} + 18'h03f04;
    // Q8.6: rounded to the nearest weight
    wire [14:0] u1_odd_cut_29 = u1_odd_place_29[17:3];
    reg [17:0] in_gain1r_30;
    reg [17:0] in_gain1g_30;
    reg [17:0] in_gain1b_30;
    reg hidden_30;
    reg v1_is_odd_30;
    reg behind1_even_30;
    reg [14:0] u1_even_cut_30;
    reg [11:0] end1_even_30;
    reg behind1_odd_30;
    reg [14:0] u1_odd_cut_30;
    reg [11:0] end1_odd_30;
    reg [6:0] texels1_000_30;
    reg [6:0] texels1_001_30;
    reg [6:0] texels1_010_30;
    reg [6:0] texels1_011_30;
    reg [6:0] texels1_100_30;
    reg [6:0] texels1_101_30;
    reg [6:0] texels1_110_30;
    reg [6:0] texels1_111_30;
    reg v1_weight_of_0_30;
    reg v1_weight_of_1_30;
    reg v1_weight_of_2_30;
    reg v1_weight_of_3_30;
    reg v1_weight_of_4_30;
    reg v1_weight_of_5_30;
    reg [7:0] blend1_signed_30;
    reg square1_r_by_1_30;
    reg [1:0] square1_r_amount_2_30;
    reg square1_r_by_4_30;
    reg square1_g_by_1_30;
    reg [1:0] square1_g_amount_2_30;
    reg square1_g_by_4_30;
    reg square1_b_by_1_30;
    reg [1:0] square1_b_amount_2_30;
    reg square1_b_by_4_30;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_30 <= in_gain1r_29;
            in_gain1g_30 <= in_gain1g_29;
            in_gain1b_30 <= in_gain1b_29;
            hidden_30 <= hidden_29;
            v1_is_odd_30 <= v1_is_odd_29;
            behind1_even_30 <= behind1_even_29;
            u1_even_cut_30 <= u1_even_cut_29;
            end1_even_30 <= end1_even_29;
            behind1_odd_30 <= behind1_odd_29;
            u1_odd_cut_30 <= u1_odd_cut_29;
            end1_odd_30 <= end1_odd_29;
            texels1_000_30 <= texels1_000_29;
            texels1_001_30 <= texels1_001_29;
            texels1_010_30 <= texels1_010_29;
            texels1_011_30 <= texels1_011_29;
            texels1_100_30 <= texels1_100_29;
            texels1_101_30 <= texels1_101_29;
            texels1_110_30 <= texels1_110_29;
            texels1_111_30 <= texels1_111_29;
            v1_weight_of_0_30 <= v1_weight_of_0_29;
            v1_weight_of_1_30 <= v1_weight_of_1_29;
            v1_weight_of_2_30 <= v1_weight_of_2_29;
            v1_weight_of_3_30 <= v1_weight_of_3_29;
            v1_weight_of_4_30 <= v1_weight_of_4_29;
            v1_weight_of_5_30 <= v1_weight_of_5_29;
            blend1_signed_30 <= blend1_signed_29;
            square1_r_by_1_30 <= square1_r_by_1_29;
            square1_r_amount_2_30 <= square1_r_amount_2_29;
            square1_r_by_4_30 <= square1_r_by_4_29;
            square1_g_by_1_30 <= square1_g_by_1_29;
            square1_g_amount_2_30 <= square1_g_amount_2_29;
            square1_g_by_4_30 <= square1_g_by_4_29;
            square1_b_by_1_30 <= square1_b_by_1_29;
            square1_b_amount_2_30 <= square1_b_amount_2_29;
            square1_b_by_4_30 <= square1_b_by_4_29;
        end
    end

    // ===== Stage 30: u1_even_kept, u_at1_even, u1_odd_kept, u_at1_odd and 12 more
    // UQ6.6: between the outermost centres
    wire [11:0] u1_even_kept_30 =
        u1_even_cut_30[14] ? 12'h000 : (u1_even_cut_30 > 15'h0fc0) ? 12'hfc0 : u1_even_cut_30[11:0];
    // UQ6.6: that end from behind the rim
    wire [11:0] u_at1_even_30 = behind1_even_30 ? end1_even_30 : u1_even_kept_30;
    // UQ6.0: the texel at or below it
    wire [5:0] u1_even_texel_30 = u_at1_even_30[11:6];
    // UQ0.6: the weight of the next
    wire [5:0] u1_even_weight_30 = u_at1_even_30[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] u1_even_odd_high_30 = u1_even_texel_30[5:1];
    // UQ5.0: the odd one of both
    wire [4:0] u1_even_odd_30 = u1_even_odd_high_30;
    // UQ1.0: its last bit
    wire u1_even_is_odd_30 = u1_even_texel_30[0];
    // UQ6.6: between the outermost centres
    wire [11:0] u1_odd_kept_30 =
        u1_odd_cut_30[14] ? 12'h000 : (u1_odd_cut_30 > 15'h0fc0) ? 12'hfc0 : u1_odd_cut_30[11:0];
    // UQ6.6: that end from behind the rim
    wire [11:0] u_at1_odd_30 = behind1_odd_30 ? end1_odd_30 : u1_odd_kept_30;
    // UQ6.0: the texel at or below it
    wire [5:0] u1_odd_texel_30 = u_at1_odd_30[11:6];
    // UQ0.6: the weight of the next
    wire [5:0] u1_odd_weight_30 = u_at1_odd_30[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] u1_odd_odd_high_30 = u1_odd_texel_30[5:1];
    // UQ5.0: the odd one of both
    wire [4:0] u1_odd_odd_30 = u1_odd_odd_high_30;
    // UQ1.0: its last bit
    wire u1_odd_is_odd_30 = u1_odd_texel_30[0];
    // UQ-5.6: a bit of the weight
    wire u1_even_weight_bit_0_30 = u1_even_weight_30[0];
    // UQ-4.5: a bit of the weight
    wire u1_even_weight_bit_1_30 = u1_even_weight_30[1];
    // UQ-3.4: a bit of the weight
    wire u1_even_weight_bit_2_30 = u1_even_weight_30[2];
    // UQ-2.3: a bit of the weight
    wire u1_even_weight_bit_3_30 = u1_even_weight_30[3];
    // UQ-1.2: a bit of the weight
    wire u1_even_weight_bit_4_30 = u1_even_weight_30[4];
    // UQ0.1: a bit of the weight
    wire u1_even_weight_bit_5_30 = u1_even_weight_30[5];
    // UQ1.0: as a flag
    wire u1_even_weight_of_0_flag_30 = u1_even_weight_bit_0_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_0_not_30 = ~u1_even_weight_of_0_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_0_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_0_not_30 : u1_even_weight_of_0_flag_30;
    // UQ1.0: as a flag
    wire u1_even_weight_of_1_flag_30 = u1_even_weight_bit_1_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_1_not_30 = ~u1_even_weight_of_1_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_1_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_1_not_30 : u1_even_weight_of_1_flag_30;
    // UQ1.0: as a flag
    wire u1_even_weight_of_2_flag_30 = u1_even_weight_bit_2_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_2_not_30 = ~u1_even_weight_of_2_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_2_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_2_not_30 : u1_even_weight_of_2_flag_30;
    // UQ1.0: as a flag
    wire u1_even_weight_of_3_flag_30 = u1_even_weight_bit_3_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_3_not_30 = ~u1_even_weight_of_3_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_3_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_3_not_30 : u1_even_weight_of_3_flag_30;
    // UQ1.0: as a flag
    wire u1_even_weight_of_4_flag_30 = u1_even_weight_bit_4_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_4_not_30 = ~u1_even_weight_of_4_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_4_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_4_not_30 : u1_even_weight_of_4_flag_30;
    // UQ1.0: as a flag
    wire u1_even_weight_of_5_flag_30 = u1_even_weight_bit_5_30;
    // UQ1.0: it is 0
    wire u1_even_weight_of_5_not_30 = ~u1_even_weight_of_5_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_even_weight_of_5_30 =
        u1_even_is_odd_30 ? u1_even_weight_of_5_not_30 : u1_even_weight_of_5_flag_30;
    // UQ-5.6: a bit of the weight
    wire u1_odd_weight_bit_0_30 = u1_odd_weight_30[0];
    // UQ-4.5: a bit of the weight
    wire u1_odd_weight_bit_1_30 = u1_odd_weight_30[1];
    // UQ-3.4: a bit of the weight
    wire u1_odd_weight_bit_2_30 = u1_odd_weight_30[2];
    // UQ-2.3: a bit of the weight
    wire u1_odd_weight_bit_3_30 = u1_odd_weight_30[3];
    // UQ-1.2: a bit of the weight
    wire u1_odd_weight_bit_4_30 = u1_odd_weight_30[4];
    // UQ0.1: a bit of the weight
    wire u1_odd_weight_bit_5_30 = u1_odd_weight_30[5];
    // UQ1.0: as a flag
    wire u1_odd_weight_of_0_flag_30 = u1_odd_weight_bit_0_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_0_not_30 = ~u1_odd_weight_of_0_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_0_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_0_not_30 : u1_odd_weight_of_0_flag_30;
    // UQ1.0: as a flag
    wire u1_odd_weight_of_1_flag_30 = u1_odd_weight_bit_1_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_1_not_30 = ~u1_odd_weight_of_1_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_1_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_1_not_30 : u1_odd_weight_of_1_flag_30;
    // UQ1.0: as a flag
    wire u1_odd_weight_of_2_flag_30 = u1_odd_weight_bit_2_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_2_not_30 = ~u1_odd_weight_of_2_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_2_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_2_not_30 : u1_odd_weight_of_2_flag_30;
    // UQ1.0: as a flag
    wire u1_odd_weight_of_3_flag_30 = u1_odd_weight_bit_3_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_3_not_30 = ~u1_odd_weight_of_3_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_3_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_3_not_30 : u1_odd_weight_of_3_flag_30;
    // UQ1.0: as a flag
    wire u1_odd_weight_of_4_flag_30 = u1_odd_weight_bit_4_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_4_not_30 = ~u1_odd_weight_of_4_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_4_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_4_not_30 : u1_odd_weight_of_4_flag_30;
    // UQ1.0: as a flag
    wire u1_odd_weight_of_5_flag_30 = u1_odd_weight_bit_5_30;
    // UQ1.0: it is 0
    wire u1_odd_weight_of_5_not_30 = ~u1_odd_weight_of_5_flag_30;
    // UQ1.0: whether it counts for the odd one
    wire u1_odd_weight_of_5_30 =
        u1_odd_is_odd_30 ? u1_odd_weight_of_5_not_30 : u1_odd_weight_of_5_flag_30;
    reg [17:0] in_gain1r_31;
    reg [17:0] in_gain1g_31;
    reg [17:0] in_gain1b_31;
    reg hidden_31;
    reg v1_is_odd_31;
    reg [5:0] u1_even_texel_31;
    reg [4:0] u1_even_odd_31;
    reg u1_even_is_odd_31;
    reg [5:0] u1_odd_texel_31;
    reg [4:0] u1_odd_odd_31;
    reg u1_odd_is_odd_31;
    reg [6:0] texels1_000_31;
    reg [6:0] texels1_001_31;
    reg [6:0] texels1_010_31;
    reg [6:0] texels1_011_31;
    reg [6:0] texels1_100_31;
    reg [6:0] texels1_101_31;
    reg [6:0] texels1_110_31;
    reg [6:0] texels1_111_31;
    reg u1_even_weight_of_0_31;
    reg u1_even_weight_of_1_31;
    reg u1_even_weight_of_2_31;
    reg u1_even_weight_of_3_31;
    reg u1_even_weight_of_4_31;
    reg u1_even_weight_of_5_31;
    reg u1_odd_weight_of_0_31;
    reg u1_odd_weight_of_1_31;
    reg u1_odd_weight_of_2_31;
    reg u1_odd_weight_of_3_31;
    reg u1_odd_weight_of_4_31;
    reg u1_odd_weight_of_5_31;
    reg v1_weight_of_0_31;
    reg v1_weight_of_1_31;
    reg v1_weight_of_2_31;
    reg v1_weight_of_3_31;
    reg v1_weight_of_4_31;
    reg v1_weight_of_5_31;
    reg [7:0] blend1_signed_31;
    reg square1_r_by_1_31;
    reg [1:0] square1_r_amount_2_31;
    reg square1_r_by_4_31;
    reg square1_g_by_1_31;
    reg [1:0] square1_g_amount_2_31;
    reg square1_g_by_4_31;
    reg square1_b_by_1_31;
    reg [1:0] square1_b_amount_2_31;
    reg square1_b_by_4_31;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_31 <= in_gain1r_30;
            in_gain1g_31 <= in_gain1g_30;
            in_gain1b_31 <= in_gain1b_30;
            hidden_31 <= hidden_30;
            v1_is_odd_31 <= v1_is_odd_30;
            u1_even_texel_31 <= u1_even_texel_30;
            u1_even_odd_31 <= u1_even_odd_30;
            u1_even_is_odd_31 <= u1_even_is_odd_30;
            u1_odd_texel_31 <= u1_odd_texel_30;
            u1_odd_odd_31 <= u1_odd_odd_30;
            u1_odd_is_odd_31 <= u1_odd_is_odd_30;
            texels1_000_31 <= texels1_000_30;
            texels1_001_31 <= texels1_001_30;
            texels1_010_31 <= texels1_010_30;
            texels1_011_31 <= texels1_011_30;
            texels1_100_31 <= texels1_100_30;
            texels1_101_31 <= texels1_101_30;
            texels1_110_31 <= texels1_110_30;
            texels1_111_31 <= texels1_111_30;
            u1_even_weight_of_0_31 <= u1_even_weight_of_0_30;
            u1_even_weight_of_1_31 <= u1_even_weight_of_1_30;
            u1_even_weight_of_2_31 <= u1_even_weight_of_2_30;
            u1_even_weight_of_3_31 <= u1_even_weight_of_3_30;
            u1_even_weight_of_4_31 <= u1_even_weight_of_4_30;
            u1_even_weight_of_5_31 <= u1_even_weight_of_5_30;
            u1_odd_weight_of_0_31 <= u1_odd_weight_of_0_30;
            u1_odd_weight_of_1_31 <= u1_odd_weight_of_1_30;
            u1_odd_weight_of_2_31 <= u1_odd_weight_of_2_30;
            u1_odd_weight_of_3_31 <= u1_odd_weight_of_3_30;
            u1_odd_weight_of_4_31 <= u1_odd_weight_of_4_30;
            u1_odd_weight_of_5_31 <= u1_odd_weight_of_5_30;
            v1_weight_of_0_31 <= v1_weight_of_0_30;
            v1_weight_of_1_31 <= v1_weight_of_1_30;
            v1_weight_of_2_31 <= v1_weight_of_2_30;
            v1_weight_of_3_31 <= v1_weight_of_3_30;
            v1_weight_of_4_31 <= v1_weight_of_4_30;
            v1_weight_of_5_31 <= v1_weight_of_5_30;
            blend1_signed_31 <= blend1_signed_30;
            square1_r_by_1_31 <= square1_r_by_1_30;
            square1_r_amount_2_31 <= square1_r_amount_2_30;
            square1_r_by_4_31 <= square1_r_by_4_30;
            square1_g_by_1_31 <= square1_g_by_1_30;
            square1_g_amount_2_31 <= square1_g_amount_2_30;
            square1_g_by_4_31 <= square1_g_by_4_30;
            square1_b_by_1_31 <= square1_b_by_1_30;
            square1_b_amount_2_31 <= square1_b_amount_2_30;
            square1_b_by_4_31 <= square1_b_by_4_30;
        end
    end

    // ===== Stage 31: u1_even_next_exact, u1_odd_next_exact, texel1_001 and 3 more
    // UQ7.0: the next
    wire [6:0] u1_even_next_exact_31 = {1'd0, u1_even_texel_31} + 7'h01;
    // UQ7.0: the next
    wire [6:0] u1_odd_next_exact_31 = {1'd0, u1_odd_texel_31} + 7'h01;
    // UQ12.0: side by side
    wire [11:0] texel1_001_31 = {texels1_001_31, 5'd0} + {7'd0, u1_even_odd_31};
    // UQ12.0: side by side
    wire [11:0] texel1_011_31 = {texels1_011_31, 5'd0} + {7'd0, u1_even_odd_31};
    // UQ12.0: side by side
    wire [11:0] texel1_101_31 = {texels1_101_31, 5'd0} + {7'd0, u1_odd_odd_31};
    // UQ12.0: side by side
    wire [11:0] texel1_111_31 = {texels1_111_31, 5'd0} + {7'd0, u1_odd_odd_31};
    reg [17:0] in_gain1r_32;
    reg [17:0] in_gain1g_32;
    reg [17:0] in_gain1b_32;
    reg hidden_32;
    reg v1_is_odd_32;
    reg [6:0] u1_even_next_exact_32;
    reg u1_even_is_odd_32;
    reg [6:0] u1_odd_next_exact_32;
    reg u1_odd_is_odd_32;
    reg [6:0] texels1_000_32;
    reg [11:0] texel1_001_32;
    reg [6:0] texels1_010_32;
    reg [11:0] texel1_011_32;
    reg [6:0] texels1_100_32;
    reg [11:0] texel1_101_32;
    reg [6:0] texels1_110_32;
    reg [11:0] texel1_111_32;
    reg u1_even_weight_of_0_32;
    reg u1_even_weight_of_1_32;
    reg u1_even_weight_of_2_32;
    reg u1_even_weight_of_3_32;
    reg u1_even_weight_of_4_32;
    reg u1_even_weight_of_5_32;
    reg u1_odd_weight_of_0_32;
    reg u1_odd_weight_of_1_32;
    reg u1_odd_weight_of_2_32;
    reg u1_odd_weight_of_3_32;
    reg u1_odd_weight_of_4_32;
    reg u1_odd_weight_of_5_32;
    reg v1_weight_of_0_32;
    reg v1_weight_of_1_32;
    reg v1_weight_of_2_32;
    reg v1_weight_of_3_32;
    reg v1_weight_of_4_32;
    reg v1_weight_of_5_32;
    reg [7:0] blend1_signed_32;
    reg square1_r_by_1_32;
    reg [1:0] square1_r_amount_2_32;
    reg square1_r_by_4_32;
    reg square1_g_by_1_32;
    reg [1:0] square1_g_amount_2_32;
    reg square1_g_by_4_32;
    reg square1_b_by_1_32;
    reg [1:0] square1_b_amount_2_32;
    reg square1_b_by_4_32;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_32 <= in_gain1r_31;
            in_gain1g_32 <= in_gain1g_31;
            in_gain1b_32 <= in_gain1b_31;
            hidden_32 <= hidden_31;
            v1_is_odd_32 <= v1_is_odd_31;
            u1_even_next_exact_32 <= u1_even_next_exact_31;
            u1_even_is_odd_32 <= u1_even_is_odd_31;
            u1_odd_next_exact_32 <= u1_odd_next_exact_31;
            u1_odd_is_odd_32 <= u1_odd_is_odd_31;
            texels1_000_32 <= texels1_000_31;
            texel1_001_32 <= texel1_001_31;
            texels1_010_32 <= texels1_010_31;
            texel1_011_32 <= texel1_011_31;
            texels1_100_32 <= texels1_100_31;
            texel1_101_32 <= texel1_101_31;
            texels1_110_32 <= texels1_110_31;
            texel1_111_32 <= texel1_111_31;
            u1_even_weight_of_0_32 <= u1_even_weight_of_0_31;
            u1_even_weight_of_1_32 <= u1_even_weight_of_1_31;
            u1_even_weight_of_2_32 <= u1_even_weight_of_2_31;
            u1_even_weight_of_3_32 <= u1_even_weight_of_3_31;
            u1_even_weight_of_4_32 <= u1_even_weight_of_4_31;
            u1_even_weight_of_5_32 <= u1_even_weight_of_5_31;
            u1_odd_weight_of_0_32 <= u1_odd_weight_of_0_31;
            u1_odd_weight_of_1_32 <= u1_odd_weight_of_1_31;
            u1_odd_weight_of_2_32 <= u1_odd_weight_of_2_31;
            u1_odd_weight_of_3_32 <= u1_odd_weight_of_3_31;
            u1_odd_weight_of_4_32 <= u1_odd_weight_of_4_31;
            u1_odd_weight_of_5_32 <= u1_odd_weight_of_5_31;
            v1_weight_of_0_32 <= v1_weight_of_0_31;
            v1_weight_of_1_32 <= v1_weight_of_1_31;
            v1_weight_of_2_32 <= v1_weight_of_2_31;
            v1_weight_of_3_32 <= v1_weight_of_3_31;
            v1_weight_of_4_32 <= v1_weight_of_4_31;
            v1_weight_of_5_32 <= v1_weight_of_5_31;
            blend1_signed_32 <= blend1_signed_31;
            square1_r_by_1_32 <= square1_r_by_1_31;
            square1_r_amount_2_32 <= square1_r_amount_2_31;
            square1_r_by_4_32 <= square1_r_by_4_31;
            square1_g_by_1_32 <= square1_g_by_1_31;
            square1_g_amount_2_32 <= square1_g_amount_2_31;
            square1_g_by_4_32 <= square1_g_by_4_31;
            square1_b_by_1_32 <= square1_b_by_1_31;
            square1_b_amount_2_32 <= square1_b_amount_2_31;
            square1_b_by_4_32 <= square1_b_by_4_31;
        end
    end

    // ===== Stage 32: u1_even_next, u1_odd_next
    // UQ6.0: at most the last
    wire [5:0] u1_even_next_32 = (|u1_even_next_exact_32[6]) ? 6'h3f : u1_even_next_exact_32[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] u1_even_even_high_32 = u1_even_next_32[5:1];
    // UQ5.0: the even one of both
    wire [4:0] u1_even_even_32 = u1_even_even_high_32;
    // UQ6.0: at most the last
    wire [5:0] u1_odd_next_32 = (|u1_odd_next_exact_32[6]) ? 6'h3f : u1_odd_next_exact_32[5:0];
    // UQ6.-1: its leading bits
    wire [4:0] u1_odd_even_high_32 = u1_odd_next_32[5:1];
    // UQ5.0: the even one of both
    wire [4:0] u1_odd_even_32 = u1_odd_even_high_32;
    reg [17:0] in_gain1r_33;
    reg [17:0] in_gain1g_33;
    reg [17:0] in_gain1b_33;
    reg hidden_33;
    reg v1_is_odd_33;
    reg [4:0] u1_even_even_33;
    reg u1_even_is_odd_33;
    reg [4:0] u1_odd_even_33;
    reg u1_odd_is_odd_33;
    reg [6:0] texels1_000_33;
    reg [11:0] texel1_001_33;
    reg [6:0] texels1_010_33;
    reg [11:0] texel1_011_33;
    reg [6:0] texels1_100_33;
    reg [11:0] texel1_101_33;
    reg [6:0] texels1_110_33;
    reg [11:0] texel1_111_33;
    reg u1_even_weight_of_0_33;
    reg u1_even_weight_of_1_33;
    reg u1_even_weight_of_2_33;
    reg u1_even_weight_of_3_33;
    reg u1_even_weight_of_4_33;
    reg u1_even_weight_of_5_33;
    reg u1_odd_weight_of_0_33;
    reg u1_odd_weight_of_1_33;
    reg u1_odd_weight_of_2_33;
    reg u1_odd_weight_of_3_33;
    reg u1_odd_weight_of_4_33;
    reg u1_odd_weight_of_5_33;
    reg v1_weight_of_0_33;
    reg v1_weight_of_1_33;
    reg v1_weight_of_2_33;
    reg v1_weight_of_3_33;
    reg v1_weight_of_4_33;
    reg v1_weight_of_5_33;
    reg [7:0] blend1_signed_33;
    reg square1_r_by_1_33;
    reg [1:0] square1_r_amount_2_33;
    reg square1_r_by_4_33;
    reg square1_g_by_1_33;
    reg [1:0] square1_g_amount_2_33;
    reg square1_g_by_4_33;
    reg square1_b_by_1_33;
    reg [1:0] square1_b_amount_2_33;
    reg square1_b_by_4_33;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_33 <= in_gain1r_32;
            in_gain1g_33 <= in_gain1g_32;
            in_gain1b_33 <= in_gain1b_32;
            hidden_33 <= hidden_32;
            v1_is_odd_33 <= v1_is_odd_32;
            u1_even_even_33 <= u1_even_even_32;
            u1_even_is_odd_33 <= u1_even_is_odd_32;
            u1_odd_even_33 <= u1_odd_even_32;
            u1_odd_is_odd_33 <= u1_odd_is_odd_32;
            texels1_000_33 <= texels1_000_32;
            texel1_001_33 <= texel1_001_32;
            texels1_010_33 <= texels1_010_32;
            texel1_011_33 <= texel1_011_32;
            texels1_100_33 <= texels1_100_32;
            texel1_101_33 <= texel1_101_32;
            texels1_110_33 <= texels1_110_32;
            texel1_111_33 <= texel1_111_32;
            u1_even_weight_of_0_33 <= u1_even_weight_of_0_32;
            u1_even_weight_of_1_33 <= u1_even_weight_of_1_32;
            u1_even_weight_of_2_33 <= u1_even_weight_of_2_32;
            u1_even_weight_of_3_33 <= u1_even_weight_of_3_32;
            u1_even_weight_of_4_33 <= u1_even_weight_of_4_32;
            u1_even_weight_of_5_33 <= u1_even_weight_of_5_32;
            u1_odd_weight_of_0_33 <= u1_odd_weight_of_0_32;
            u1_odd_weight_of_1_33 <= u1_odd_weight_of_1_32;
            u1_odd_weight_of_2_33 <= u1_odd_weight_of_2_32;
            u1_odd_weight_of_3_33 <= u1_odd_weight_of_3_32;
            u1_odd_weight_of_4_33 <= u1_odd_weight_of_4_32;
            u1_odd_weight_of_5_33 <= u1_odd_weight_of_5_32;
            v1_weight_of_0_33 <= v1_weight_of_0_32;
            v1_weight_of_1_33 <= v1_weight_of_1_32;
            v1_weight_of_2_33 <= v1_weight_of_2_32;
            v1_weight_of_3_33 <= v1_weight_of_3_32;
            v1_weight_of_4_33 <= v1_weight_of_4_32;
            v1_weight_of_5_33 <= v1_weight_of_5_32;
            blend1_signed_33 <= blend1_signed_32;
            square1_r_by_1_33 <= square1_r_by_1_32;
            square1_r_amount_2_33 <= square1_r_amount_2_32;
            square1_r_by_4_33 <= square1_r_by_4_32;
            square1_g_by_1_33 <= square1_g_by_1_32;
            square1_g_amount_2_33 <= square1_g_amount_2_32;
            square1_g_by_4_33 <= square1_g_by_4_32;
            square1_b_by_1_33 <= square1_b_by_1_32;
            square1_b_amount_2_33 <= square1_b_amount_2_32;
            square1_b_by_4_33 <= square1_b_by_4_32;
        end
    end

    // ===== Stage 33: texel1_000, texel1_010, texel1_100, texel1_110
    // UQ12.0: side by side
    wire [11:0] texel1_000_33 = {texels1_000_33, 5'd0} + {7'd0, u1_even_even_33};
    // UQ12.0: side by side
    wire [11:0] texel1_010_33 = {texels1_010_33, 5'd0} + {7'd0, u1_even_even_33};
    // UQ12.0: side by side
    wire [11:0] texel1_100_33 = {texels1_100_33, 5'd0} + {7'd0, u1_odd_even_33};
    // UQ12.0: side by side
    wire [11:0] texel1_110_33 = {texels1_110_33, 5'd0} + {7'd0, u1_odd_even_33};
    reg [17:0] in_gain1r_34;
    reg [17:0] in_gain1g_34;
    reg [17:0] in_gain1b_34;
    reg hidden_34;
    reg v1_is_odd_34;
    reg u1_even_is_odd_34;
    reg u1_odd_is_odd_34;
    reg [11:0] texel1_000_34;
    reg [11:0] texel1_001_34;
    reg [11:0] texel1_010_34;
    reg [11:0] texel1_011_34;
    reg [11:0] texel1_100_34;
    reg [11:0] texel1_101_34;
    reg [11:0] texel1_110_34;
    reg [11:0] texel1_111_34;
    reg u1_even_weight_of_0_34;
    reg u1_even_weight_of_1_34;
    reg u1_even_weight_of_2_34;
    reg u1_even_weight_of_3_34;
    reg u1_even_weight_of_4_34;
    reg u1_even_weight_of_5_34;
    reg u1_odd_weight_of_0_34;
    reg u1_odd_weight_of_1_34;
    reg u1_odd_weight_of_2_34;
    reg u1_odd_weight_of_3_34;
    reg u1_odd_weight_of_4_34;
    reg u1_odd_weight_of_5_34;
    reg v1_weight_of_0_34;
    reg v1_weight_of_1_34;
    reg v1_weight_of_2_34;
    reg v1_weight_of_3_34;
    reg v1_weight_of_4_34;
    reg v1_weight_of_5_34;
    reg [7:0] blend1_signed_34;
    reg square1_r_by_1_34;
    reg [1:0] square1_r_amount_2_34;
    reg square1_r_by_4_34;
    reg square1_g_by_1_34;
    reg [1:0] square1_g_amount_2_34;
    reg square1_g_by_4_34;
    reg square1_b_by_1_34;
    reg [1:0] square1_b_amount_2_34;
    reg square1_b_by_4_34;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_34 <= in_gain1r_33;
            in_gain1g_34 <= in_gain1g_33;
            in_gain1b_34 <= in_gain1b_33;
            hidden_34 <= hidden_33;
            v1_is_odd_34 <= v1_is_odd_33;
            u1_even_is_odd_34 <= u1_even_is_odd_33;
            u1_odd_is_odd_34 <= u1_odd_is_odd_33;
            texel1_000_34 <= texel1_000_33;
            texel1_001_34 <= texel1_001_33;
            texel1_010_34 <= texel1_010_33;
            texel1_011_34 <= texel1_011_33;
            texel1_100_34 <= texel1_100_33;
            texel1_101_34 <= texel1_101_33;
            texel1_110_34 <= texel1_110_33;
            texel1_111_34 <= texel1_111_33;
            u1_even_weight_of_0_34 <= u1_even_weight_of_0_33;
            u1_even_weight_of_1_34 <= u1_even_weight_of_1_33;
            u1_even_weight_of_2_34 <= u1_even_weight_of_2_33;
            u1_even_weight_of_3_34 <= u1_even_weight_of_3_33;
            u1_even_weight_of_4_34 <= u1_even_weight_of_4_33;
            u1_even_weight_of_5_34 <= u1_even_weight_of_5_33;
            u1_odd_weight_of_0_34 <= u1_odd_weight_of_0_33;
            u1_odd_weight_of_1_34 <= u1_odd_weight_of_1_33;
            u1_odd_weight_of_2_34 <= u1_odd_weight_of_2_33;
            u1_odd_weight_of_3_34 <= u1_odd_weight_of_3_33;
            u1_odd_weight_of_4_34 <= u1_odd_weight_of_4_33;
            u1_odd_weight_of_5_34 <= u1_odd_weight_of_5_33;
            v1_weight_of_0_34 <= v1_weight_of_0_33;
            v1_weight_of_1_34 <= v1_weight_of_1_33;
            v1_weight_of_2_34 <= v1_weight_of_2_33;
            v1_weight_of_3_34 <= v1_weight_of_3_33;
            v1_weight_of_4_34 <= v1_weight_of_4_33;
            v1_weight_of_5_34 <= v1_weight_of_5_33;
            blend1_signed_34 <= blend1_signed_33;
            square1_r_by_1_34 <= square1_r_by_1_33;
            square1_r_amount_2_34 <= square1_r_amount_2_33;
            square1_r_by_4_34 <= square1_r_by_4_33;
            square1_g_by_1_34 <= square1_g_by_1_33;
            square1_g_amount_2_34 <= square1_g_amount_2_33;
            square1_g_by_4_34 <= square1_g_by_4_33;
            square1_b_by_1_34 <= square1_b_by_1_33;
            square1_b_amount_2_34 <= square1_b_amount_2_33;
            square1_b_by_4_34 <= square1_b_by_4_33;
        end
    end

    // ===== Stage 34: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    // The word of the memory texels_1_even_even_even, of 4096 words.
    reg [23:0] texels_1_even_even_even_35;
    // The word of the memory texels_1_even_even_odd, of 4096 words.
    reg [23:0] texels_1_even_even_odd_35;
    // The word of the memory texels_1_even_odd_even, of 4096 words.
    reg [23:0] texels_1_even_odd_even_35;
    // The word of the memory texels_1_even_odd_odd, of 4096 words.
    reg [23:0] texels_1_even_odd_odd_35;
    // The word of the memory texels_1_odd_even_even, of 4096 words.
    reg [23:0] texels_1_odd_even_even_35;
    // The word of the memory texels_1_odd_even_odd, of 4096 words.
    reg [23:0] texels_1_odd_even_odd_35;
    // The word of the memory texels_1_odd_odd_even, of 4096 words.
    reg [23:0] texels_1_odd_odd_even_35;
    // The word of the memory texels_1_odd_odd_odd, of 4096 words.
    reg [23:0] texels_1_odd_odd_odd_35;
    reg [23:0] texels_1_even_even_even [0:4095];
    initial $readmemh(TEXELS_1_EVEN_EVEN_EVEN_FILE, texels_1_even_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_even_35 <= texels_1_even_even_even[texel1_000_34];
    end
    reg [23:0] texels_1_even_even_odd [0:4095];
    initial $readmemh(TEXELS_1_EVEN_EVEN_ODD_FILE, texels_1_even_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_odd_35 <= texels_1_even_even_odd[texel1_001_34];
    end
    reg [23:0] texels_1_even_odd_even [0:4095];
    initial $readmemh(TEXELS_1_EVEN_ODD_EVEN_FILE, texels_1_even_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_even_35 <= texels_1_even_odd_even[texel1_010_34];
    end
    reg [23:0] texels_1_even_odd_odd [0:4095];
    initial $readmemh(TEXELS_1_EVEN_ODD_ODD_FILE, texels_1_even_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_odd_35 <= texels_1_even_odd_odd[texel1_011_34];
    end
    reg [23:0] texels_1_odd_even_even [0:4095];
    initial $readmemh(TEXELS_1_ODD_EVEN_EVEN_FILE, texels_1_odd_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_even_35 <= texels_1_odd_even_even[texel1_100_34];
    end
    reg [23:0] texels_1_odd_even_odd [0:4095];
    initial $readmemh(TEXELS_1_ODD_EVEN_ODD_FILE, texels_1_odd_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_odd_35 <= texels_1_odd_even_odd[texel1_101_34];
    end
    reg [23:0] texels_1_odd_odd_even [0:4095];
    initial $readmemh(TEXELS_1_ODD_ODD_EVEN_FILE, texels_1_odd_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_even_35 <= texels_1_odd_odd_even[texel1_110_34];
    end
    reg [23:0] texels_1_odd_odd_odd [0:4095];
    initial $readmemh(TEXELS_1_ODD_ODD_ODD_FILE, texels_1_odd_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_odd_35 <= texels_1_odd_odd_odd[texel1_111_34];
    end
    reg [17:0] in_gain1r_35;
    reg [17:0] in_gain1g_35;
    reg [17:0] in_gain1b_35;
    reg hidden_35;
    reg v1_is_odd_35;
    reg u1_even_is_odd_35;
    reg u1_odd_is_odd_35;
    reg u1_even_weight_of_0_35;
    reg u1_even_weight_of_1_35;
    reg u1_even_weight_of_2_35;
    reg u1_even_weight_of_3_35;
    reg u1_even_weight_of_4_35;
    reg u1_even_weight_of_5_35;
    reg u1_odd_weight_of_0_35;
    reg u1_odd_weight_of_1_35;
    reg u1_odd_weight_of_2_35;
    reg u1_odd_weight_of_3_35;
    reg u1_odd_weight_of_4_35;
    reg u1_odd_weight_of_5_35;
    reg v1_weight_of_0_35;
    reg v1_weight_of_1_35;
    reg v1_weight_of_2_35;
    reg v1_weight_of_3_35;
    reg v1_weight_of_4_35;
    reg v1_weight_of_5_35;
    reg [7:0] blend1_signed_35;
    reg square1_r_by_1_35;
    reg [1:0] square1_r_amount_2_35;
    reg square1_r_by_4_35;
    reg square1_g_by_1_35;
    reg [1:0] square1_g_amount_2_35;
    reg square1_g_by_4_35;
    reg square1_b_by_1_35;
    reg [1:0] square1_b_amount_2_35;
    reg square1_b_by_4_35;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_35 <= in_gain1r_34;
            in_gain1g_35 <= in_gain1g_34;
            in_gain1b_35 <= in_gain1b_34;
            hidden_35 <= hidden_34;
            v1_is_odd_35 <= v1_is_odd_34;
            u1_even_is_odd_35 <= u1_even_is_odd_34;
            u1_odd_is_odd_35 <= u1_odd_is_odd_34;
            u1_even_weight_of_0_35 <= u1_even_weight_of_0_34;
            u1_even_weight_of_1_35 <= u1_even_weight_of_1_34;
            u1_even_weight_of_2_35 <= u1_even_weight_of_2_34;
            u1_even_weight_of_3_35 <= u1_even_weight_of_3_34;
            u1_even_weight_of_4_35 <= u1_even_weight_of_4_34;
            u1_even_weight_of_5_35 <= u1_even_weight_of_5_34;
            u1_odd_weight_of_0_35 <= u1_odd_weight_of_0_34;
            u1_odd_weight_of_1_35 <= u1_odd_weight_of_1_34;
            u1_odd_weight_of_2_35 <= u1_odd_weight_of_2_34;
            u1_odd_weight_of_3_35 <= u1_odd_weight_of_3_34;
            u1_odd_weight_of_4_35 <= u1_odd_weight_of_4_34;
            u1_odd_weight_of_5_35 <= u1_odd_weight_of_5_34;
            v1_weight_of_0_35 <= v1_weight_of_0_34;
            v1_weight_of_1_35 <= v1_weight_of_1_34;
            v1_weight_of_2_35 <= v1_weight_of_2_34;
            v1_weight_of_3_35 <= v1_weight_of_3_34;
            v1_weight_of_4_35 <= v1_weight_of_4_34;
            v1_weight_of_5_35 <= v1_weight_of_5_34;
            blend1_signed_35 <= blend1_signed_34;
            square1_r_by_1_35 <= square1_r_by_1_34;
            square1_r_amount_2_35 <= square1_r_amount_2_34;
            square1_r_by_4_35 <= square1_r_by_4_34;
            square1_g_by_1_35 <= square1_g_by_1_34;
            square1_g_amount_2_35 <= square1_g_amount_2_34;
            square1_g_by_4_35 <= square1_g_by_4_34;
            square1_b_by_1_35 <= square1_b_by_1_34;
            square1_b_amount_2_35 <= square1_b_amount_2_34;
            square1_b_by_4_35 <= square1_b_by_4_34;
        end
    end

    // ===== Stage 35: registers only
    // UQ0.8: red
    wire [7:0] texels_1_even_even_even_r_35 = texels_1_even_even_even_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_even_odd_r_35 = texels_1_even_even_odd_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_even_r_35 = texels_1_even_odd_even_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_odd_r_35 = texels_1_even_odd_odd_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_even_r_35 = texels_1_odd_even_even_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_odd_r_35 = texels_1_odd_even_odd_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_even_r_35 = texels_1_odd_odd_even_35[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_odd_r_35 = texels_1_odd_odd_odd_35[23:16];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_even_g_35 = texels_1_even_even_even_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_odd_g_35 = texels_1_even_even_odd_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_even_g_35 = texels_1_even_odd_even_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_odd_g_35 = texels_1_even_odd_odd_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_even_g_35 = texels_1_odd_even_even_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_odd_g_35 = texels_1_odd_even_odd_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_even_g_35 = texels_1_odd_odd_even_35[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_odd_g_35 = texels_1_odd_odd_odd_35[15:8];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_even_b_35 = texels_1_even_even_even_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_odd_b_35 = texels_1_even_even_odd_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_even_b_35 = texels_1_even_odd_even_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_odd_b_35 = texels_1_even_odd_odd_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_even_b_35 = texels_1_odd_even_even_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_odd_b_35 = texels_1_odd_even_odd_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_even_b_35 = texels_1_odd_odd_even_35[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_odd_b_35 = texels_1_odd_odd_odd_35[7:0];
    reg [17:0] in_gain1r_36;
    reg [17:0] in_gain1g_36;
    reg [17:0] in_gain1b_36;
    reg hidden_36;
    reg v1_is_odd_36;
    reg u1_even_is_odd_36;
    reg u1_odd_is_odd_36;
    reg [7:0] texels_1_even_even_even_r_36;
    reg [7:0] texels_1_even_even_odd_r_36;
    reg [7:0] texels_1_even_odd_even_r_36;
    reg [7:0] texels_1_even_odd_odd_r_36;
    reg [7:0] texels_1_odd_even_even_r_36;
    reg [7:0] texels_1_odd_even_odd_r_36;
    reg [7:0] texels_1_odd_odd_even_r_36;
    reg [7:0] texels_1_odd_odd_odd_r_36;
    reg u1_even_weight_of_0_36;
    reg u1_even_weight_of_1_36;
    reg u1_even_weight_of_2_36;
    reg u1_even_weight_of_3_36;
    reg u1_even_weight_of_4_36;
    reg u1_even_weight_of_5_36;
    reg u1_odd_weight_of_0_36;
    reg u1_odd_weight_of_1_36;
    reg u1_odd_weight_of_2_36;
    reg u1_odd_weight_of_3_36;
    reg u1_odd_weight_of_4_36;
    reg u1_odd_weight_of_5_36;
    reg v1_weight_of_0_36;
    reg v1_weight_of_1_36;
    reg v1_weight_of_2_36;
    reg v1_weight_of_3_36;
    reg v1_weight_of_4_36;
    reg v1_weight_of_5_36;
    reg [7:0] blend1_signed_36;
    reg square1_r_by_1_36;
    reg [1:0] square1_r_amount_2_36;
    reg square1_r_by_4_36;
    reg [7:0] texels_1_even_even_even_g_36;
    reg [7:0] texels_1_even_even_odd_g_36;
    reg [7:0] texels_1_even_odd_even_g_36;
    reg [7:0] texels_1_even_odd_odd_g_36;
    reg [7:0] texels_1_odd_even_even_g_36;
    reg [7:0] texels_1_odd_even_odd_g_36;
    reg [7:0] texels_1_odd_odd_even_g_36;
    reg [7:0] texels_1_odd_odd_odd_g_36;
    reg square1_g_by_1_36;
    reg [1:0] square1_g_amount_2_36;
    reg square1_g_by_4_36;
    reg [7:0] texels_1_even_even_even_b_36;
    reg [7:0] texels_1_even_even_odd_b_36;
    reg [7:0] texels_1_even_odd_even_b_36;
    reg [7:0] texels_1_even_odd_odd_b_36;
    reg [7:0] texels_1_odd_even_even_b_36;
    reg [7:0] texels_1_odd_even_odd_b_36;
    reg [7:0] texels_1_odd_odd_even_b_36;
    reg [7:0] texels_1_odd_odd_odd_b_36;
    reg square1_b_by_1_36;
    reg [1:0] square1_b_amount_2_36;
    reg square1_b_by_4_36;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_36 <= in_gain1r_35;
            in_gain1g_36 <= in_gain1g_35;
            in_gain1b_36 <= in_gain1b_35;
            hidden_36 <= hidden_35;
            v1_is_odd_36 <= v1_is_odd_35;
            u1_even_is_odd_36 <= u1_even_is_odd_35;
            u1_odd_is_odd_36 <= u1_odd_is_odd_35;
            texels_1_even_even_even_r_36 <= texels_1_even_even_even_r_35;
            texels_1_even_even_odd_r_36 <= texels_1_even_even_odd_r_35;
            texels_1_even_odd_even_r_36 <= texels_1_even_odd_even_r_35;
            texels_1_even_odd_odd_r_36 <= texels_1_even_odd_odd_r_35;
            texels_1_odd_even_even_r_36 <= texels_1_odd_even_even_r_35;
            texels_1_odd_even_odd_r_36 <= texels_1_odd_even_odd_r_35;
            texels_1_odd_odd_even_r_36 <= texels_1_odd_odd_even_r_35;
            texels_1_odd_odd_odd_r_36 <= texels_1_odd_odd_odd_r_35;
            u1_even_weight_of_0_36 <= u1_even_weight_of_0_35;
            u1_even_weight_of_1_36 <= u1_even_weight_of_1_35;
            u1_even_weight_of_2_36 <= u1_even_weight_of_2_35;
            u1_even_weight_of_3_36 <= u1_even_weight_of_3_35;
            u1_even_weight_of_4_36 <= u1_even_weight_of_4_35;
            u1_even_weight_of_5_36 <= u1_even_weight_of_5_35;
            u1_odd_weight_of_0_36 <= u1_odd_weight_of_0_35;
            u1_odd_weight_of_1_36 <= u1_odd_weight_of_1_35;
            u1_odd_weight_of_2_36 <= u1_odd_weight_of_2_35;
            u1_odd_weight_of_3_36 <= u1_odd_weight_of_3_35;
            u1_odd_weight_of_4_36 <= u1_odd_weight_of_4_35;
            u1_odd_weight_of_5_36 <= u1_odd_weight_of_5_35;
            v1_weight_of_0_36 <= v1_weight_of_0_35;
            v1_weight_of_1_36 <= v1_weight_of_1_35;
            v1_weight_of_2_36 <= v1_weight_of_2_35;
            v1_weight_of_3_36 <= v1_weight_of_3_35;
            v1_weight_of_4_36 <= v1_weight_of_4_35;
            v1_weight_of_5_36 <= v1_weight_of_5_35;
            blend1_signed_36 <= blend1_signed_35;
            square1_r_by_1_36 <= square1_r_by_1_35;
            square1_r_amount_2_36 <= square1_r_amount_2_35;
            square1_r_by_4_36 <= square1_r_by_4_35;
            texels_1_even_even_even_g_36 <= texels_1_even_even_even_g_35;
            texels_1_even_even_odd_g_36 <= texels_1_even_even_odd_g_35;
            texels_1_even_odd_even_g_36 <= texels_1_even_odd_even_g_35;
            texels_1_even_odd_odd_g_36 <= texels_1_even_odd_odd_g_35;
            texels_1_odd_even_even_g_36 <= texels_1_odd_even_even_g_35;
            texels_1_odd_even_odd_g_36 <= texels_1_odd_even_odd_g_35;
            texels_1_odd_odd_even_g_36 <= texels_1_odd_odd_even_g_35;
            texels_1_odd_odd_odd_g_36 <= texels_1_odd_odd_odd_g_35;
            square1_g_by_1_36 <= square1_g_by_1_35;
            square1_g_amount_2_36 <= square1_g_amount_2_35;
            square1_g_by_4_36 <= square1_g_by_4_35;
            texels_1_even_even_even_b_36 <= texels_1_even_even_even_b_35;
            texels_1_even_even_odd_b_36 <= texels_1_even_even_odd_b_35;
            texels_1_even_odd_even_b_36 <= texels_1_even_odd_even_b_35;
            texels_1_even_odd_odd_b_36 <= texels_1_even_odd_odd_b_35;
            texels_1_odd_even_even_b_36 <= texels_1_odd_even_even_b_35;
            texels_1_odd_even_odd_b_36 <= texels_1_odd_even_odd_b_35;
            texels_1_odd_odd_even_b_36 <= texels_1_odd_odd_even_b_35;
            texels_1_odd_odd_odd_b_36 <= texels_1_odd_odd_odd_b_35;
            square1_b_by_1_36 <= square1_b_by_1_35;
            square1_b_amount_2_36 <= square1_b_amount_2_35;
            square1_b_by_4_36 <= square1_b_by_4_35;
        end
    end

    // ===== Stage 36: registers only
    reg [17:0] in_gain1r_37;
    reg [17:0] in_gain1g_37;
    reg [17:0] in_gain1b_37;
    reg hidden_37;
    reg v1_is_odd_37;
    reg u1_even_is_odd_37;
    reg u1_odd_is_odd_37;
    reg [7:0] texels_1_even_even_even_r_37;
    reg [7:0] texels_1_even_even_odd_r_37;
    reg [7:0] texels_1_even_odd_even_r_37;
    reg [7:0] texels_1_even_odd_odd_r_37;
    reg [7:0] texels_1_odd_even_even_r_37;
    reg [7:0] texels_1_odd_even_odd_r_37;
    reg [7:0] texels_1_odd_odd_even_r_37;
    reg [7:0] texels_1_odd_odd_odd_r_37;
    reg u1_even_weight_of_0_37;
    reg u1_even_weight_of_1_37;
    reg u1_even_weight_of_2_37;
    reg u1_even_weight_of_3_37;
    reg u1_even_weight_of_4_37;
    reg u1_even_weight_of_5_37;
    reg u1_odd_weight_of_0_37;
    reg u1_odd_weight_of_1_37;
    reg u1_odd_weight_of_2_37;
    reg u1_odd_weight_of_3_37;
    reg u1_odd_weight_of_4_37;
    reg u1_odd_weight_of_5_37;
    reg v1_weight_of_0_37;
    reg v1_weight_of_1_37;
    reg v1_weight_of_2_37;
    reg v1_weight_of_3_37;
    reg v1_weight_of_4_37;
    reg v1_weight_of_5_37;
    reg [7:0] blend1_signed_37;
    reg square1_r_by_1_37;
    reg [1:0] square1_r_amount_2_37;
    reg square1_r_by_4_37;
    reg [7:0] texels_1_even_even_even_g_37;
    reg [7:0] texels_1_even_even_odd_g_37;
    reg [7:0] texels_1_even_odd_even_g_37;
    reg [7:0] texels_1_even_odd_odd_g_37;
    reg [7:0] texels_1_odd_even_even_g_37;
    reg [7:0] texels_1_odd_even_odd_g_37;
    reg [7:0] texels_1_odd_odd_even_g_37;
    reg [7:0] texels_1_odd_odd_odd_g_37;
    reg square1_g_by_1_37;
    reg [1:0] square1_g_amount_2_37;
    reg square1_g_by_4_37;
    reg [7:0] texels_1_even_even_even_b_37;
    reg [7:0] texels_1_even_even_odd_b_37;
    reg [7:0] texels_1_even_odd_even_b_37;
    reg [7:0] texels_1_even_odd_odd_b_37;
    reg [7:0] texels_1_odd_even_even_b_37;
    reg [7:0] texels_1_odd_even_odd_b_37;
    reg [7:0] texels_1_odd_odd_even_b_37;
    reg [7:0] texels_1_odd_odd_odd_b_37;
    reg square1_b_by_1_37;
    reg [1:0] square1_b_amount_2_37;
    reg square1_b_by_4_37;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_37 <= in_gain1r_36;
            in_gain1g_37 <= in_gain1g_36;
            in_gain1b_37 <= in_gain1b_36;
            hidden_37 <= hidden_36;
            v1_is_odd_37 <= v1_is_odd_36;
            u1_even_is_odd_37 <= u1_even_is_odd_36;
            u1_odd_is_odd_37 <= u1_odd_is_odd_36;
            texels_1_even_even_even_r_37 <= texels_1_even_even_even_r_36;
            texels_1_even_even_odd_r_37 <= texels_1_even_even_odd_r_36;
            texels_1_even_odd_even_r_37 <= texels_1_even_odd_even_r_36;
            texels_1_even_odd_odd_r_37 <= texels_1_even_odd_odd_r_36;
            texels_1_odd_even_even_r_37 <= texels_1_odd_even_even_r_36;
            texels_1_odd_even_odd_r_37 <= texels_1_odd_even_odd_r_36;
            texels_1_odd_odd_even_r_37 <= texels_1_odd_odd_even_r_36;
            texels_1_odd_odd_odd_r_37 <= texels_1_odd_odd_odd_r_36;
            u1_even_weight_of_0_37 <= u1_even_weight_of_0_36;
            u1_even_weight_of_1_37 <= u1_even_weight_of_1_36;
            u1_even_weight_of_2_37 <= u1_even_weight_of_2_36;
            u1_even_weight_of_3_37 <= u1_even_weight_of_3_36;
            u1_even_weight_of_4_37 <= u1_even_weight_of_4_36;
            u1_even_weight_of_5_37 <= u1_even_weight_of_5_36;
            u1_odd_weight_of_0_37 <= u1_odd_weight_of_0_36;
            u1_odd_weight_of_1_37 <= u1_odd_weight_of_1_36;
            u1_odd_weight_of_2_37 <= u1_odd_weight_of_2_36;
            u1_odd_weight_of_3_37 <= u1_odd_weight_of_3_36;
            u1_odd_weight_of_4_37 <= u1_odd_weight_of_4_36;
            u1_odd_weight_of_5_37 <= u1_odd_weight_of_5_36;
            v1_weight_of_0_37 <= v1_weight_of_0_36;
            v1_weight_of_1_37 <= v1_weight_of_1_36;
            v1_weight_of_2_37 <= v1_weight_of_2_36;
            v1_weight_of_3_37 <= v1_weight_of_3_36;
            v1_weight_of_4_37 <= v1_weight_of_4_36;
            v1_weight_of_5_37 <= v1_weight_of_5_36;
            blend1_signed_37 <= blend1_signed_36;
            square1_r_by_1_37 <= square1_r_by_1_36;
            square1_r_amount_2_37 <= square1_r_amount_2_36;
            square1_r_by_4_37 <= square1_r_by_4_36;
            texels_1_even_even_even_g_37 <= texels_1_even_even_even_g_36;
            texels_1_even_even_odd_g_37 <= texels_1_even_even_odd_g_36;
            texels_1_even_odd_even_g_37 <= texels_1_even_odd_even_g_36;
            texels_1_even_odd_odd_g_37 <= texels_1_even_odd_odd_g_36;
            texels_1_odd_even_even_g_37 <= texels_1_odd_even_even_g_36;
            texels_1_odd_even_odd_g_37 <= texels_1_odd_even_odd_g_36;
            texels_1_odd_odd_even_g_37 <= texels_1_odd_odd_even_g_36;
            texels_1_odd_odd_odd_g_37 <= texels_1_odd_odd_odd_g_36;
            square1_g_by_1_37 <= square1_g_by_1_36;
            square1_g_amount_2_37 <= square1_g_amount_2_36;
            square1_g_by_4_37 <= square1_g_by_4_36;
            texels_1_even_even_even_b_37 <= texels_1_even_even_even_b_36;
            texels_1_even_even_odd_b_37 <= texels_1_even_even_odd_b_36;
            texels_1_even_odd_even_b_37 <= texels_1_even_odd_even_b_36;
            texels_1_even_odd_odd_b_37 <= texels_1_even_odd_odd_b_36;
            texels_1_odd_even_even_b_37 <= texels_1_odd_even_even_b_36;
            texels_1_odd_even_odd_b_37 <= texels_1_odd_even_odd_b_36;
            texels_1_odd_odd_even_b_37 <= texels_1_odd_odd_even_b_36;
            texels_1_odd_odd_odd_b_37 <= texels_1_odd_odd_odd_b_36;
            square1_b_by_1_37 <= square1_b_by_1_36;
            square1_b_amount_2_37 <= square1_b_amount_2_36;
            square1_b_by_4_37 <= square1_b_by_4_36;
        end
    end

    // ===== Stage 37: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 118 more
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_0_by_first_37 = blend1_r_1_0_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_0_by_0_37 = blend1_r_1_0_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_0_by_1_37 = blend1_r_1_0_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_0_by_2_37 = blend1_r_1_0_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_0_by_3_37 = blend1_r_1_0_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_0_by_4_37 = blend1_r_1_0_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_even_odd_r_37 : texels_1_even_even_even_r_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_0_by_5_37 = blend1_r_1_0_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_r_1_0_sum_1_0_37 =
        {1'd0, blend1_r_1_0_by_first_37} + {1'd0, blend1_r_1_0_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_r_1_0_sum_1_1_37 =
        {2'd0, blend1_r_1_0_by_1_37} + {1'd0, blend1_r_1_0_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_0_sum_1_2_37 =
        {2'd0, blend1_r_1_0_by_3_37} + {1'd0, blend1_r_1_0_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_1_by_first_37 = blend1_r_1_1_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_1_by_0_37 = blend1_r_1_1_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_1_by_1_37 = blend1_r_1_1_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_1_by_2_37 = blend1_r_1_1_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_1_by_3_37 = blend1_r_1_1_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_1_by_4_37 = blend1_r_1_1_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_odd_odd_r_37 : texels_1_even_odd_even_r_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_1_by_5_37 = blend1_r_1_1_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_r_1_1_sum_1_0_37 =
        {1'd0, blend1_r_1_1_by_first_37} + {1'd0, blend1_r_1_1_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_r_1_1_sum_1_1_37 =
        {2'd0, blend1_r_1_1_by_1_37} + {1'd0, blend1_r_1_1_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_1_sum_1_2_37 =
        {2'd0, blend1_r_1_1_by_3_37} + {1'd0, blend1_r_1_1_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_2_by_first_37 = blend1_r_1_2_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_2_by_0_37 = blend1_r_1_2_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_2_by_1_37 = blend1_r_1_2_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_2_by_2_37 = blend1_r_1_2_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_2_by_3_37 = blend1_r_1_2_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_2_by_4_37 = blend1_r_1_2_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_2_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_even_odd_r_37 : texels_1_odd_even_even_r_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_2_by_5_37 = blend1_r_1_2_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_r_1_2_sum_1_0_37 =
        {1'd0, blend1_r_1_2_by_first_37} + {1'd0, blend1_r_1_2_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_r_1_2_sum_1_1_37 =
        {2'd0, blend1_r_1_2_by_1_37} + {1'd0, blend1_r_1_2_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_2_sum_1_2_37 =
        {2'd0, blend1_r_1_2_by_3_37} + {1'd0, blend1_r_1_2_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_3_by_first_37 = blend1_r_1_3_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_r_1_3_by_0_37 = blend1_r_1_3_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_r_1_3_by_1_37 = blend1_r_1_3_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_3_by_2_37 = blend1_r_1_3_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_3_by_3_37 = blend1_r_1_3_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_3_by_4_37 = blend1_r_1_3_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_3_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_odd_odd_r_37 : texels_1_odd_odd_even_r_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_3_by_5_37 = blend1_r_1_3_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_r_1_3_sum_1_0_37 =
        {1'd0, blend1_r_1_3_by_first_37} + {1'd0, blend1_r_1_3_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_r_1_3_sum_1_1_37 =
        {2'd0, blend1_r_1_3_by_1_37} + {1'd0, blend1_r_1_3_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_3_sum_1_2_37 =
        {2'd0, blend1_r_1_3_by_3_37} + {1'd0, blend1_r_1_3_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_0_by_first_37 = blend1_g_1_0_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_0_by_0_37 = blend1_g_1_0_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_0_by_1_37 = blend1_g_1_0_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_0_by_2_37 = blend1_g_1_0_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_0_by_3_37 = blend1_g_1_0_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_0_by_4_37 = blend1_g_1_0_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_even_odd_g_37 : texels_1_even_even_even_g_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_0_by_5_37 = blend1_g_1_0_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_g_1_0_sum_1_0_37 =
        {1'd0, blend1_g_1_0_by_first_37} + {1'd0, blend1_g_1_0_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_g_1_0_sum_1_1_37 =
        {2'd0, blend1_g_1_0_by_1_37} + {1'd0, blend1_g_1_0_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_0_sum_1_2_37 =
        {2'd0, blend1_g_1_0_by_3_37} + {1'd0, blend1_g_1_0_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_1_by_first_37 = blend1_g_1_1_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_1_by_0_37 = blend1_g_1_1_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_1_by_1_37 = blend1_g_1_1_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_1_by_2_37 = blend1_g_1_1_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_1_by_3_37 = blend1_g_1_1_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_1_by_4_37 = blend1_g_1_1_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_odd_odd_g_37 : texels_1_even_odd_even_g_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_1_by_5_37 = blend1_g_1_1_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_g_1_1_sum_1_0_37 =
        {1'd0, blend1_g_1_1_by_first_37} + {1'd0, blend1_g_1_1_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_g_1_1_sum_1_1_37 =
        {2'd0, blend1_g_1_1_by_1_37} + {1'd0, blend1_g_1_1_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_1_sum_1_2_37 =
        {2'd0, blend1_g_1_1_by_3_37} + {1'd0, blend1_g_1_1_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_2_by_first_37 = blend1_g_1_2_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_2_by_0_37 = blend1_g_1_2_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_2_by_1_37 = blend1_g_1_2_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_2_by_2_37 = blend1_g_1_2_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_2_by_3_37 = blend1_g_1_2_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_2_by_4_37 = blend1_g_1_2_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_2_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_even_odd_g_37 : texels_1_odd_even_even_g_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_2_by_5_37 = blend1_g_1_2_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_g_1_2_sum_1_0_37 =
        {1'd0, blend1_g_1_2_by_first_37} + {1'd0, blend1_g_1_2_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_g_1_2_sum_1_1_37 =
        {2'd0, blend1_g_1_2_by_1_37} + {1'd0, blend1_g_1_2_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_2_sum_1_2_37 =
        {2'd0, blend1_g_1_2_by_3_37} + {1'd0, blend1_g_1_2_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_3_by_first_37 = blend1_g_1_3_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_g_1_3_by_0_37 = blend1_g_1_3_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_g_1_3_by_1_37 = blend1_g_1_3_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_3_by_2_37 = blend1_g_1_3_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_3_by_3_37 = blend1_g_1_3_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_3_by_4_37 = blend1_g_1_3_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_3_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_odd_odd_g_37 : texels_1_odd_odd_even_g_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_3_by_5_37 = blend1_g_1_3_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_g_1_3_sum_1_0_37 =
        {1'd0, blend1_g_1_3_by_first_37} + {1'd0, blend1_g_1_3_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_g_1_3_sum_1_1_37 =
        {2'd0, blend1_g_1_3_by_1_37} + {1'd0, blend1_g_1_3_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_3_sum_1_2_37 =
        {2'd0, blend1_g_1_3_by_3_37} + {1'd0, blend1_g_1_3_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_0_by_first_37 = blend1_b_1_0_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_0_by_0_37 = blend1_b_1_0_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_0_by_1_37 = blend1_b_1_0_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_0_by_2_37 = blend1_b_1_0_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_0_by_3_37 = blend1_b_1_0_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_0_by_4_37 = blend1_b_1_0_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_even_odd_b_37 : texels_1_even_even_even_b_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_0_by_5_37 = blend1_b_1_0_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_b_1_0_sum_1_0_37 =
        {1'd0, blend1_b_1_0_by_first_37} + {1'd0, blend1_b_1_0_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_b_1_0_sum_1_1_37 =
        {2'd0, blend1_b_1_0_by_1_37} + {1'd0, blend1_b_1_0_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_0_sum_1_2_37 =
        {2'd0, blend1_b_1_0_by_3_37} + {1'd0, blend1_b_1_0_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_first_37 =
        u1_even_is_odd_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_1_by_first_37 = blend1_b_1_1_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_0_37 =
        u1_even_weight_of_0_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_1_by_0_37 = blend1_b_1_1_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_1_37 =
        u1_even_weight_of_1_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_1_by_1_37 = blend1_b_1_1_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_2_37 =
        u1_even_weight_of_2_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_1_by_2_37 = blend1_b_1_1_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_3_37 =
        u1_even_weight_of_3_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_1_by_3_37 = blend1_b_1_1_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_4_37 =
        u1_even_weight_of_4_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_1_by_4_37 = blend1_b_1_1_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_5_37 =
        u1_even_weight_of_5_37 ? texels_1_even_odd_odd_b_37 : texels_1_even_odd_even_b_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_1_by_5_37 = blend1_b_1_1_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_b_1_1_sum_1_0_37 =
        {1'd0, blend1_b_1_1_by_first_37} + {1'd0, blend1_b_1_1_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_b_1_1_sum_1_1_37 =
        {2'd0, blend1_b_1_1_by_1_37} + {1'd0, blend1_b_1_1_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_1_sum_1_2_37 =
        {2'd0, blend1_b_1_1_by_3_37} + {1'd0, blend1_b_1_1_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_2_by_first_37 = blend1_b_1_2_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_2_by_0_37 = blend1_b_1_2_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_2_by_1_37 = blend1_b_1_2_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_2_by_2_37 = blend1_b_1_2_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_2_by_3_37 = blend1_b_1_2_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_2_by_4_37 = blend1_b_1_2_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_2_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_even_odd_b_37 : texels_1_odd_even_even_b_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_2_by_5_37 = blend1_b_1_2_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_b_1_2_sum_1_0_37 =
        {1'd0, blend1_b_1_2_by_first_37} + {1'd0, blend1_b_1_2_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_b_1_2_sum_1_1_37 =
        {2'd0, blend1_b_1_2_by_1_37} + {1'd0, blend1_b_1_2_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_2_sum_1_2_37 =
        {2'd0, blend1_b_1_2_by_3_37} + {1'd0, blend1_b_1_2_by_4_37, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_first_37 =
        u1_odd_is_odd_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_3_by_first_37 = blend1_b_1_3_either_first_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_0_37 =
        u1_odd_weight_of_0_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-6.14: shifted
    wire [7:0] blend1_b_1_3_by_0_37 = blend1_b_1_3_either_0_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_1_37 =
        u1_odd_weight_of_1_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-5.13: shifted
    wire [7:0] blend1_b_1_3_by_1_37 = blend1_b_1_3_either_1_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_2_37 =
        u1_odd_weight_of_2_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_3_by_2_37 = blend1_b_1_3_either_2_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_3_37 =
        u1_odd_weight_of_3_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_3_by_3_37 = blend1_b_1_3_either_3_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_4_37 =
        u1_odd_weight_of_4_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_3_by_4_37 = blend1_b_1_3_either_4_37;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_3_either_5_37 =
        u1_odd_weight_of_5_37 ? texels_1_odd_odd_odd_b_37 : texels_1_odd_odd_even_b_37;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_3_by_5_37 = blend1_b_1_3_either_5_37;
    // UQ-5.14: the sum of two
    wire [8:0] blend1_b_1_3_sum_1_0_37 =
        {1'd0, blend1_b_1_3_by_first_37} + {1'd0, blend1_b_1_3_by_0_37};
    // UQ-3.13: the sum of two
    wire [9:0] blend1_b_1_3_sum_1_1_37 =
        {2'd0, blend1_b_1_3_by_1_37} + {1'd0, blend1_b_1_3_by_2_37, 1'd0};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_3_sum_1_2_37 =
        {2'd0, blend1_b_1_3_by_3_37} + {1'd0, blend1_b_1_3_by_4_37, 1'd0};
    reg [17:0] in_gain1r_38;
    reg [17:0] in_gain1g_38;
    reg [17:0] in_gain1b_38;
    reg hidden_38;
    reg v1_is_odd_38;
    reg [7:0] blend1_r_1_0_by_5_38;
    reg [8:0] blend1_r_1_0_sum_1_0_38;
    reg [9:0] blend1_r_1_0_sum_1_1_38;
    reg [9:0] blend1_r_1_0_sum_1_2_38;
    reg [7:0] blend1_r_1_1_by_5_38;
    reg [8:0] blend1_r_1_1_sum_1_0_38;
    reg [9:0] blend1_r_1_1_sum_1_1_38;
    reg [9:0] blend1_r_1_1_sum_1_2_38;
    reg [7:0] blend1_r_1_2_by_5_38;
    reg [8:0] blend1_r_1_2_sum_1_0_38;
    reg [9:0] blend1_r_1_2_sum_1_1_38;
    reg [9:0] blend1_r_1_2_sum_1_2_38;
    reg [7:0] blend1_r_1_3_by_5_38;
    reg [8:0] blend1_r_1_3_sum_1_0_38;
    reg [9:0] blend1_r_1_3_sum_1_1_38;
    reg [9:0] blend1_r_1_3_sum_1_2_38;
    reg v1_weight_of_0_38;
    reg v1_weight_of_1_38;
    reg v1_weight_of_2_38;
    reg v1_weight_of_3_38;
    reg v1_weight_of_4_38;
    reg v1_weight_of_5_38;
    reg [7:0] blend1_signed_38;
    reg square1_r_by_1_38;
    reg [1:0] square1_r_amount_2_38;
    reg square1_r_by_4_38;
    reg [7:0] blend1_g_1_0_by_5_38;
    reg [8:0] blend1_g_1_0_sum_1_0_38;
    reg [9:0] blend1_g_1_0_sum_1_1_38;
    reg [9:0] blend1_g_1_0_sum_1_2_38;
    reg [7:0] blend1_g_1_1_by_5_38;
    reg [8:0] blend1_g_1_1_sum_1_0_38;
    reg [9:0] blend1_g_1_1_sum_1_1_38;
    reg [9:0] blend1_g_1_1_sum_1_2_38;
    reg [7:0] blend1_g_1_2_by_5_38;
    reg [8:0] blend1_g_1_2_sum_1_0_38;
    reg [9:0] blend1_g_1_2_sum_1_1_38;
    reg [9:0] blend1_g_1_2_sum_1_2_38;
    reg [7:0] blend1_g_1_3_by_5_38;
    reg [8:0] blend1_g_1_3_sum_1_0_38;
    reg [9:0] blend1_g_1_3_sum_1_1_38;
    reg [9:0] blend1_g_1_3_sum_1_2_38;
    reg square1_g_by_1_38;
    reg [1:0] square1_g_amount_2_38;
    reg square1_g_by_4_38;
    reg [7:0] blend1_b_1_0_by_5_38;
    reg [8:0] blend1_b_1_0_sum_1_0_38;
    reg [9:0] blend1_b_1_0_sum_1_1_38;
    reg [9:0] blend1_b_1_0_sum_1_2_38;
    reg [7:0] blend1_b_1_1_by_5_38;
    reg [8:0] blend1_b_1_1_sum_1_0_38;
    reg [9:0] blend1_b_1_1_sum_1_1_38;
    reg [9:0] blend1_b_1_1_sum_1_2_38;
    reg [7:0] blend1_b_1_2_by_5_38;
    reg [8:0] blend1_b_1_2_sum_1_0_38;
    reg [9:0] blend1_b_1_2_sum_1_1_38;
    reg [9:0] blend1_b_1_2_sum_1_2_38;
    reg [7:0] blend1_b_1_3_by_5_38;
    reg [8:0] blend1_b_1_3_sum_1_0_38;
    reg [9:0] blend1_b_1_3_sum_1_1_38;
    reg [9:0] blend1_b_1_3_sum_1_2_38;
    reg square1_b_by_1_38;
    reg [1:0] square1_b_amount_2_38;
    reg square1_b_by_4_38;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_38 <= in_gain1r_37;
            in_gain1g_38 <= in_gain1g_37;
            in_gain1b_38 <= in_gain1b_37;
            hidden_38 <= hidden_37;
            v1_is_odd_38 <= v1_is_odd_37;
            blend1_r_1_0_by_5_38 <= blend1_r_1_0_by_5_37;
            blend1_r_1_0_sum_1_0_38 <= blend1_r_1_0_sum_1_0_37;
            blend1_r_1_0_sum_1_1_38 <= blend1_r_1_0_sum_1_1_37;
            blend1_r_1_0_sum_1_2_38 <= blend1_r_1_0_sum_1_2_37;
            blend1_r_1_1_by_5_38 <= blend1_r_1_1_by_5_37;
            blend1_r_1_1_sum_1_0_38 <= blend1_r_1_1_sum_1_0_37;
            blend1_r_1_1_sum_1_1_38 <= blend1_r_1_1_sum_1_1_37;
            blend1_r_1_1_sum_1_2_38 <= blend1_r_1_1_sum_1_2_37;
            blend1_r_1_2_by_5_38 <= blend1_r_1_2_by_5_37;
            blend1_r_1_2_sum_1_0_38 <= blend1_r_1_2_sum_1_0_37;
            blend1_r_1_2_sum_1_1_38 <= blend1_r_1_2_sum_1_1_37;
            blend1_r_1_2_sum_1_2_38 <= blend1_r_1_2_sum_1_2_37;
            blend1_r_1_3_by_5_38 <= blend1_r_1_3_by_5_37;
            blend1_r_1_3_sum_1_0_38 <= blend1_r_1_3_sum_1_0_37;
            blend1_r_1_3_sum_1_1_38 <= blend1_r_1_3_sum_1_1_37;
            blend1_r_1_3_sum_1_2_38 <= blend1_r_1_3_sum_1_2_37;
            v1_weight_of_0_38 <= v1_weight_of_0_37;
            v1_weight_of_1_38 <= v1_weight_of_1_37;
            v1_weight_of_2_38 <= v1_weight_of_2_37;
            v1_weight_of_3_38 <= v1_weight_of_3_37;
            v1_weight_of_4_38 <= v1_weight_of_4_37;
            v1_weight_of_5_38 <= v1_weight_of_5_37;
            blend1_signed_38 <= blend1_signed_37;
            square1_r_by_1_38 <= square1_r_by_1_37;
            square1_r_amount_2_38 <= square1_r_amount_2_37;
            square1_r_by_4_38 <= square1_r_by_4_37;
            blend1_g_1_0_by_5_38 <= blend1_g_1_0_by_5_37;
            blend1_g_1_0_sum_1_0_38 <= blend1_g_1_0_sum_1_0_37;
            blend1_g_1_0_sum_1_1_38 <= blend1_g_1_0_sum_1_1_37;
            blend1_g_1_0_sum_1_2_38 <= blend1_g_1_0_sum_1_2_37;
            blend1_g_1_1_by_5_38 <= blend1_g_1_1_by_5_37;
            blend1_g_1_1_sum_1_0_38 <= blend1_g_1_1_sum_1_0_37;
            blend1_g_1_1_sum_1_1_38 <= blend1_g_1_1_sum_1_1_37;
            blend1_g_1_1_sum_1_2_38 <= blend1_g_1_1_sum_1_2_37;
            blend1_g_1_2_by_5_38 <= blend1_g_1_2_by_5_37;
            blend1_g_1_2_sum_1_0_38 <= blend1_g_1_2_sum_1_0_37;
            blend1_g_1_2_sum_1_1_38 <= blend1_g_1_2_sum_1_1_37;
            blend1_g_1_2_sum_1_2_38 <= blend1_g_1_2_sum_1_2_37;
            blend1_g_1_3_by_5_38 <= blend1_g_1_3_by_5_37;
            blend1_g_1_3_sum_1_0_38 <= blend1_g_1_3_sum_1_0_37;
            blend1_g_1_3_sum_1_1_38 <= blend1_g_1_3_sum_1_1_37;
            blend1_g_1_3_sum_1_2_38 <= blend1_g_1_3_sum_1_2_37;
            square1_g_by_1_38 <= square1_g_by_1_37;
            square1_g_amount_2_38 <= square1_g_amount_2_37;
            square1_g_by_4_38 <= square1_g_by_4_37;
            blend1_b_1_0_by_5_38 <= blend1_b_1_0_by_5_37;
            blend1_b_1_0_sum_1_0_38 <= blend1_b_1_0_sum_1_0_37;
            blend1_b_1_0_sum_1_1_38 <= blend1_b_1_0_sum_1_1_37;
            blend1_b_1_0_sum_1_2_38 <= blend1_b_1_0_sum_1_2_37;
            blend1_b_1_1_by_5_38 <= blend1_b_1_1_by_5_37;
            blend1_b_1_1_sum_1_0_38 <= blend1_b_1_1_sum_1_0_37;
            blend1_b_1_1_sum_1_1_38 <= blend1_b_1_1_sum_1_1_37;
            blend1_b_1_1_sum_1_2_38 <= blend1_b_1_1_sum_1_2_37;
            blend1_b_1_2_by_5_38 <= blend1_b_1_2_by_5_37;
            blend1_b_1_2_sum_1_0_38 <= blend1_b_1_2_sum_1_0_37;
            blend1_b_1_2_sum_1_1_38 <= blend1_b_1_2_sum_1_1_37;
            blend1_b_1_2_sum_1_2_38 <= blend1_b_1_2_sum_1_2_37;
            blend1_b_1_3_by_5_38 <= blend1_b_1_3_by_5_37;
            blend1_b_1_3_sum_1_0_38 <= blend1_b_1_3_sum_1_0_37;
            blend1_b_1_3_sum_1_1_38 <= blend1_b_1_3_sum_1_1_37;
            blend1_b_1_3_sum_1_2_38 <= blend1_b_1_3_sum_1_2_37;
            square1_b_by_1_38 <= square1_b_by_1_37;
            square1_b_amount_2_38 <= square1_b_amount_2_37;
            square1_b_by_4_38 <= square1_b_by_4_37;
        end
    end

    // ===== Stage 38: blend1_r_1_0_sum_2_0, blend1_r_1_0_sum_2_1 and 22 more
    // UQ-3.14: the sum of two
    wire [10:0] blend1_r_1_0_sum_2_0_38 =
        {2'd0, blend1_r_1_0_sum_1_0_38} + {blend1_r_1_0_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_r_1_0_sum_2_1_38 =
        {1'd0, blend1_r_1_0_sum_1_2_38} + {1'd0, blend1_r_1_0_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_r_1_1_sum_2_0_38 =
        {2'd0, blend1_r_1_1_sum_1_0_38} + {blend1_r_1_1_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_r_1_1_sum_2_1_38 =
        {1'd0, blend1_r_1_1_sum_1_2_38} + {1'd0, blend1_r_1_1_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_r_1_2_sum_2_0_38 =
        {2'd0, blend1_r_1_2_sum_1_0_38} + {blend1_r_1_2_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_r_1_2_sum_2_1_38 =
        {1'd0, blend1_r_1_2_sum_1_2_38} + {1'd0, blend1_r_1_2_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_r_1_3_sum_2_0_38 =
        {2'd0, blend1_r_1_3_sum_1_0_38} + {blend1_r_1_3_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_r_1_3_sum_2_1_38 =
        {1'd0, blend1_r_1_3_sum_1_2_38} + {1'd0, blend1_r_1_3_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_g_1_0_sum_2_0_38 =
        {2'd0, blend1_g_1_0_sum_1_0_38} + {blend1_g_1_0_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_g_1_0_sum_2_1_38 =
        {1'd0, blend1_g_1_0_sum_1_2_38} + {1'd0, blend1_g_1_0_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_g_1_1_sum_2_0_38 =
        {2'd0, blend1_g_1_1_sum_1_0_38} + {blend1_g_1_1_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_g_1_1_sum_2_1_38 =
        {1'd0, blend1_g_1_1_sum_1_2_38} + {1'd0, blend1_g_1_1_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_g_1_2_sum_2_0_38 =
        {2'd0, blend1_g_1_2_sum_1_0_38} + {blend1_g_1_2_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_g_1_2_sum_2_1_38 =
        {1'd0, blend1_g_1_2_sum_1_2_38} + {1'd0, blend1_g_1_2_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_g_1_3_sum_2_0_38 =
        {2'd0, blend1_g_1_3_sum_1_0_38} + {blend1_g_1_3_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_g_1_3_sum_2_1_38 =
        {1'd0, blend1_g_1_3_sum_1_2_38} + {1'd0, blend1_g_1_3_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_b_1_0_sum_2_0_38 =
        {2'd0, blend1_b_1_0_sum_1_0_38} + {blend1_b_1_0_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_b_1_0_sum_2_1_38 =
        {1'd0, blend1_b_1_0_sum_1_2_38} + {1'd0, blend1_b_1_0_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_b_1_1_sum_2_0_38 =
        {2'd0, blend1_b_1_1_sum_1_0_38} + {blend1_b_1_1_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_b_1_1_sum_2_1_38 =
        {1'd0, blend1_b_1_1_sum_1_2_38} + {1'd0, blend1_b_1_1_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_b_1_2_sum_2_0_38 =
        {2'd0, blend1_b_1_2_sum_1_0_38} + {blend1_b_1_2_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_b_1_2_sum_2_1_38 =
        {1'd0, blend1_b_1_2_sum_1_2_38} + {1'd0, blend1_b_1_2_by_5_38, 2'd0};
    // UQ-3.14: the sum of two
    wire [10:0] blend1_b_1_3_sum_2_0_38 =
        {2'd0, blend1_b_1_3_sum_1_0_38} + {blend1_b_1_3_sum_1_1_38, 1'd0};
    // UQ0.11: the sum of two
    wire [10:0] blend1_b_1_3_sum_2_1_38 =
        {1'd0, blend1_b_1_3_sum_1_2_38} + {1'd0, blend1_b_1_3_by_5_38, 2'd0};
    reg [17:0] in_gain1r_39;
    reg [17:0] in_gain1g_39;
    reg [17:0] in_gain1b_39;
    reg hidden_39;
    reg v1_is_odd_39;
    reg [10:0] blend1_r_1_0_sum_2_0_39;
    reg [10:0] blend1_r_1_0_sum_2_1_39;
    reg [10:0] blend1_r_1_1_sum_2_0_39;
    reg [10:0] blend1_r_1_1_sum_2_1_39;
    reg [10:0] blend1_r_1_2_sum_2_0_39;
    reg [10:0] blend1_r_1_2_sum_2_1_39;
    reg [10:0] blend1_r_1_3_sum_2_0_39;
    reg [10:0] blend1_r_1_3_sum_2_1_39;
    reg v1_weight_of_0_39;
    reg v1_weight_of_1_39;
    reg v1_weight_of_2_39;
    reg v1_weight_of_3_39;
    reg v1_weight_of_4_39;
    reg v1_weight_of_5_39;
    reg [7:0] blend1_signed_39;
    reg square1_r_by_1_39;
    reg [1:0] square1_r_amount_2_39;
    reg square1_r_by_4_39;
    reg [10:0] blend1_g_1_0_sum_2_0_39;
    reg [10:0] blend1_g_1_0_sum_2_1_39;
    reg [10:0] blend1_g_1_1_sum_2_0_39;
    reg [10:0] blend1_g_1_1_sum_2_1_39;
    reg [10:0] blend1_g_1_2_sum_2_0_39;
    reg [10:0] blend1_g_1_2_sum_2_1_39;
    reg [10:0] blend1_g_1_3_sum_2_0_39;
    reg [10:0] blend1_g_1_3_sum_2_1_39;
    reg square1_g_by_1_39;
    reg [1:0] square1_g_amount_2_39;
    reg square1_g_by_4_39;
    reg [10:0] blend1_b_1_0_sum_2_0_39;
    reg [10:0] blend1_b_1_0_sum_2_1_39;
    reg [10:0] blend1_b_1_1_sum_2_0_39;
    reg [10:0] blend1_b_1_1_sum_2_1_39;
    reg [10:0] blend1_b_1_2_sum_2_0_39;
    reg [10:0] blend1_b_1_2_sum_2_1_39;
    reg [10:0] blend1_b_1_3_sum_2_0_39;
    reg [10:0] blend1_b_1_3_sum_2_1_39;
    reg square1_b_by_1_39;
    reg [1:0] square1_b_amount_2_39;
    reg square1_b_by_4_39;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_39 <= in_gain1r_38;
            in_gain1g_39 <= in_gain1g_38;
            in_gain1b_39 <= in_gain1b_38;
            hidden_39 <= hidden_38;
            v1_is_odd_39 <= v1_is_odd_38;
            blend1_r_1_0_sum_2_0_39 <= blend1_r_1_0_sum_2_0_38;
            blend1_r_1_0_sum_2_1_39 <= blend1_r_1_0_sum_2_1_38;
            blend1_r_1_1_sum_2_0_39 <= blend1_r_1_1_sum_2_0_38;
            blend1_r_1_1_sum_2_1_39 <= blend1_r_1_1_sum_2_1_38;
            blend1_r_1_2_sum_2_0_39 <= blend1_r_1_2_sum_2_0_38;
            blend1_r_1_2_sum_2_1_39 <= blend1_r_1_2_sum_2_1_38;
            blend1_r_1_3_sum_2_0_39 <= blend1_r_1_3_sum_2_0_38;
            blend1_r_1_3_sum_2_1_39 <= blend1_r_1_3_sum_2_1_38;
            v1_weight_of_0_39 <= v1_weight_of_0_38;
            v1_weight_of_1_39 <= v1_weight_of_1_38;
            v1_weight_of_2_39 <= v1_weight_of_2_38;
            v1_weight_of_3_39 <= v1_weight_of_3_38;
            v1_weight_of_4_39 <= v1_weight_of_4_38;
            v1_weight_of_5_39 <= v1_weight_of_5_38;
            blend1_signed_39 <= blend1_signed_38;
            square1_r_by_1_39 <= square1_r_by_1_38;
            square1_r_amount_2_39 <= square1_r_amount_2_38;
            square1_r_by_4_39 <= square1_r_by_4_38;
            blend1_g_1_0_sum_2_0_39 <= blend1_g_1_0_sum_2_0_38;
            blend1_g_1_0_sum_2_1_39 <= blend1_g_1_0_sum_2_1_38;
            blend1_g_1_1_sum_2_0_39 <= blend1_g_1_1_sum_2_0_38;
            blend1_g_1_1_sum_2_1_39 <= blend1_g_1_1_sum_2_1_38;
            blend1_g_1_2_sum_2_0_39 <= blend1_g_1_2_sum_2_0_38;
            blend1_g_1_2_sum_2_1_39 <= blend1_g_1_2_sum_2_1_38;
            blend1_g_1_3_sum_2_0_39 <= blend1_g_1_3_sum_2_0_38;
            blend1_g_1_3_sum_2_1_39 <= blend1_g_1_3_sum_2_1_38;
            square1_g_by_1_39 <= square1_g_by_1_38;
            square1_g_amount_2_39 <= square1_g_amount_2_38;
            square1_g_by_4_39 <= square1_g_by_4_38;
            blend1_b_1_0_sum_2_0_39 <= blend1_b_1_0_sum_2_0_38;
            blend1_b_1_0_sum_2_1_39 <= blend1_b_1_0_sum_2_1_38;
            blend1_b_1_1_sum_2_0_39 <= blend1_b_1_1_sum_2_0_38;
            blend1_b_1_1_sum_2_1_39 <= blend1_b_1_1_sum_2_1_38;
            blend1_b_1_2_sum_2_0_39 <= blend1_b_1_2_sum_2_0_38;
            blend1_b_1_2_sum_2_1_39 <= blend1_b_1_2_sum_2_1_38;
            blend1_b_1_3_sum_2_0_39 <= blend1_b_1_3_sum_2_0_38;
            blend1_b_1_3_sum_2_1_39 <= blend1_b_1_3_sum_2_1_38;
            square1_b_by_1_39 <= square1_b_by_1_38;
            square1_b_amount_2_39 <= square1_b_amount_2_38;
            square1_b_by_4_39 <= square1_b_by_4_38;
        end
    end

    // ===== Stage 39: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 50 more
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_0_39 = {3'd0, blend1_r_1_0_sum_2_0_39} + {blend1_r_1_0_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_1_39 = {3'd0, blend1_r_1_1_sum_2_0_39} + {blend1_r_1_1_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_2_39 = {3'd0, blend1_r_1_2_sum_2_0_39} + {blend1_r_1_2_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_r_1_3_39 = {3'd0, blend1_r_1_3_sum_2_0_39} + {blend1_r_1_3_sum_2_1_39, 3'd0};
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_first_39 = v1_is_odd_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_r_2_0_by_first_39 = blend1_r_2_0_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_0_39 = v1_weight_of_0_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_r_2_0_by_0_39 = blend1_r_2_0_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_1_39 = v1_weight_of_1_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_r_2_0_by_1_39 = blend1_r_2_0_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_2_39 = v1_weight_of_2_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_r_2_0_by_2_39 = blend1_r_2_0_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_3_39 = v1_weight_of_3_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_r_2_0_by_3_39 = blend1_r_2_0_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_4_39 = v1_weight_of_4_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_r_2_0_by_4_39 = blend1_r_2_0_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_0_either_5_39 = v1_weight_of_5_39 ? blend1_r_1_1_39 : blend1_r_1_0_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_r_2_0_by_5_39 = blend1_r_2_0_either_5_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_first_39 = v1_is_odd_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_r_2_1_by_first_39 = blend1_r_2_1_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_0_39 = v1_weight_of_0_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_r_2_1_by_0_39 = blend1_r_2_1_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_1_39 = v1_weight_of_1_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_r_2_1_by_1_39 = blend1_r_2_1_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_2_39 = v1_weight_of_2_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_r_2_1_by_2_39 = blend1_r_2_1_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_3_39 = v1_weight_of_3_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_r_2_1_by_3_39 = blend1_r_2_1_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_4_39 = v1_weight_of_4_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_r_2_1_by_4_39 = blend1_r_2_1_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_r_2_1_either_5_39 = v1_weight_of_5_39 ? blend1_r_1_3_39 : blend1_r_1_2_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_r_2_1_by_5_39 = blend1_r_2_1_either_5_39;
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_0_39 = {3'd0, blend1_g_1_0_sum_2_0_39} + {blend1_g_1_0_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_1_39 = {3'd0, blend1_g_1_1_sum_2_0_39} + {blend1_g_1_1_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_2_39 = {3'd0, blend1_g_1_2_sum_2_0_39} + {blend1_g_1_2_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_g_1_3_39 = {3'd0, blend1_g_1_3_sum_2_0_39} + {blend1_g_1_3_sum_2_1_39, 3'd0};
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_first_39 = v1_is_odd_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_g_2_0_by_first_39 = blend1_g_2_0_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_0_39 = v1_weight_of_0_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_g_2_0_by_0_39 = blend1_g_2_0_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_1_39 = v1_weight_of_1_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_g_2_0_by_1_39 = blend1_g_2_0_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_2_39 = v1_weight_of_2_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_g_2_0_by_2_39 = blend1_g_2_0_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_3_39 = v1_weight_of_3_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_g_2_0_by_3_39 = blend1_g_2_0_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_4_39 = v1_weight_of_4_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_g_2_0_by_4_39 = blend1_g_2_0_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_0_either_5_39 = v1_weight_of_5_39 ? blend1_g_1_1_39 : blend1_g_1_0_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_g_2_0_by_5_39 = blend1_g_2_0_either_5_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_first_39 = v1_is_odd_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_g_2_1_by_first_39 = blend1_g_2_1_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_0_39 = v1_weight_of_0_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_g_2_1_by_0_39 = blend1_g_2_1_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_1_39 = v1_weight_of_1_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_g_2_1_by_1_39 = blend1_g_2_1_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_2_39 = v1_weight_of_2_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_g_2_1_by_2_39 = blend1_g_2_1_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_3_39 = v1_weight_of_3_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_g_2_1_by_3_39 = blend1_g_2_1_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_4_39 = v1_weight_of_4_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_g_2_1_by_4_39 = blend1_g_2_1_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_g_2_1_either_5_39 = v1_weight_of_5_39 ? blend1_g_1_3_39 : blend1_g_1_2_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_g_2_1_by_5_39 = blend1_g_2_1_either_5_39;
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_0_39 = {3'd0, blend1_b_1_0_sum_2_0_39} + {blend1_b_1_0_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_1_39 = {3'd0, blend1_b_1_1_sum_2_0_39} + {blend1_b_1_1_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_2_39 = {3'd0, blend1_b_1_2_sum_2_0_39} + {blend1_b_1_2_sum_2_1_39, 3'd0};
    // UQ0.14: two neighbours
    wire [13:0] blend1_b_1_3_39 = {3'd0, blend1_b_1_3_sum_2_0_39} + {blend1_b_1_3_sum_2_1_39, 3'd0};
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_first_39 = v1_is_odd_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_b_2_0_by_first_39 = blend1_b_2_0_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_0_39 = v1_weight_of_0_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_b_2_0_by_0_39 = blend1_b_2_0_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_1_39 = v1_weight_of_1_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_b_2_0_by_1_39 = blend1_b_2_0_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_2_39 = v1_weight_of_2_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_b_2_0_by_2_39 = blend1_b_2_0_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_3_39 = v1_weight_of_3_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_b_2_0_by_3_39 = blend1_b_2_0_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_4_39 = v1_weight_of_4_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_b_2_0_by_4_39 = blend1_b_2_0_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_0_either_5_39 = v1_weight_of_5_39 ? blend1_b_1_1_39 : blend1_b_1_0_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_b_2_0_by_5_39 = blend1_b_2_0_either_5_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_first_39 = v1_is_odd_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_b_2_1_by_first_39 = blend1_b_2_1_either_first_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_0_39 = v1_weight_of_0_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-6.20: shifted
    wire [13:0] blend1_b_2_1_by_0_39 = blend1_b_2_1_either_0_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_1_39 = v1_weight_of_1_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-5.19: shifted
    wire [13:0] blend1_b_2_1_by_1_39 = blend1_b_2_1_either_1_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_2_39 = v1_weight_of_2_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-4.18: shifted
    wire [13:0] blend1_b_2_1_by_2_39 = blend1_b_2_1_either_2_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_3_39 = v1_weight_of_3_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-3.17: shifted
    wire [13:0] blend1_b_2_1_by_3_39 = blend1_b_2_1_either_3_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_4_39 = v1_weight_of_4_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-2.16: shifted
    wire [13:0] blend1_b_2_1_by_4_39 = blend1_b_2_1_either_4_39;
    // UQ0.14: either of both
    wire [13:0] blend1_b_2_1_either_5_39 = v1_weight_of_5_39 ? blend1_b_1_3_39 : blend1_b_1_2_39;
    // UQ-1.15: shifted
    wire [13:0] blend1_b_2_1_by_5_39 = blend1_b_2_1_either_5_39;
    reg [17:0] in_gain1r_40;
    reg [17:0] in_gain1g_40;
    reg [17:0] in_gain1b_40;
    reg hidden_40;
    reg [13:0] blend1_r_2_0_by_first_40;
    reg [13:0] blend1_r_2_0_by_0_40;
    reg [13:0] blend1_r_2_0_by_1_40;
    reg [13:0] blend1_r_2_0_by_2_40;
    reg [13:0] blend1_r_2_0_by_3_40;
    reg [13:0] blend1_r_2_0_by_4_40;
    reg [13:0] blend1_r_2_0_by_5_40;
    reg [13:0] blend1_r_2_1_by_first_40;
    reg [13:0] blend1_r_2_1_by_0_40;
    reg [13:0] blend1_r_2_1_by_1_40;
    reg [13:0] blend1_r_2_1_by_2_40;
    reg [13:0] blend1_r_2_1_by_3_40;
    reg [13:0] blend1_r_2_1_by_4_40;
    reg [13:0] blend1_r_2_1_by_5_40;
    reg [7:0] blend1_signed_40;
    reg square1_r_by_1_40;
    reg [1:0] square1_r_amount_2_40;
    reg square1_r_by_4_40;
    reg [13:0] blend1_g_2_0_by_first_40;
    reg [13:0] blend1_g_2_0_by_0_40;
    reg [13:0] blend1_g_2_0_by_1_40;
    reg [13:0] blend1_g_2_0_by_2_40;
    reg [13:0] blend1_g_2_0_by_3_40;
    reg [13:0] blend1_g_2_0_by_4_40;
    reg [13:0] blend1_g_2_0_by_5_40;
    reg [13:0] blend1_g_2_1_by_first_40;
    reg [13:0] blend1_g_2_1_by_0_40;
    reg [13:0] blend1_g_2_1_by_1_40;
    reg [13:0] blend1_g_2_1_by_2_40;
    reg [13:0] blend1_g_2_1_by_3_40;
    reg [13:0] blend1_g_2_1_by_4_40;
    reg [13:0] blend1_g_2_1_by_5_40;
    reg square1_g_by_1_40;
    reg [1:0] square1_g_amount_2_40;
    reg square1_g_by_4_40;
    reg [13:0] blend1_b_2_0_by_first_40;
    reg [13:0] blend1_b_2_0_by_0_40;
    reg [13:0] blend1_b_2_0_by_1_40;
    reg [13:0] blend1_b_2_0_by_2_40;
    reg [13:0] blend1_b_2_0_by_3_40;
    reg [13:0] blend1_b_2_0_by_4_40;
    reg [13:0] blend1_b_2_0_by_5_40;
    reg [13:0] blend1_b_2_1_by_first_40;
    reg [13:0] blend1_b_2_1_by_0_40;
    reg [13:0] blend1_b_2_1_by_1_40;
    reg [13:0] blend1_b_2_1_by_2_40;
    reg [13:0] blend1_b_2_1_by_3_40;
    reg [13:0] blend1_b_2_1_by_4_40;
    reg [13:0] blend1_b_2_1_by_5_40;
    reg square1_b_by_1_40;
    reg [1:0] square1_b_amount_2_40;
    reg square1_b_by_4_40;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_40 <= in_gain1r_39;
            in_gain1g_40 <= in_gain1g_39;
            in_gain1b_40 <= in_gain1b_39;
            hidden_40 <= hidden_39;
            blend1_r_2_0_by_first_40 <= blend1_r_2_0_by_first_39;
            blend1_r_2_0_by_0_40 <= blend1_r_2_0_by_0_39;
            blend1_r_2_0_by_1_40 <= blend1_r_2_0_by_1_39;
            blend1_r_2_0_by_2_40 <= blend1_r_2_0_by_2_39;
            blend1_r_2_0_by_3_40 <= blend1_r_2_0_by_3_39;
            blend1_r_2_0_by_4_40 <= blend1_r_2_0_by_4_39;
            blend1_r_2_0_by_5_40 <= blend1_r_2_0_by_5_39;
            blend1_r_2_1_by_first_40 <= blend1_r_2_1_by_first_39;
            blend1_r_2_1_by_0_40 <= blend1_r_2_1_by_0_39;
            blend1_r_2_1_by_1_40 <= blend1_r_2_1_by_1_39;
            blend1_r_2_1_by_2_40 <= blend1_r_2_1_by_2_39;
            blend1_r_2_1_by_3_40 <= blend1_r_2_1_by_3_39;
            blend1_r_2_1_by_4_40 <= blend1_r_2_1_by_4_39;
            blend1_r_2_1_by_5_40 <= blend1_r_2_1_by_5_39;
            blend1_signed_40 <= blend1_signed_39;
            square1_r_by_1_40 <= square1_r_by_1_39;
            square1_r_amount_2_40 <= square1_r_amount_2_39;
            square1_r_by_4_40 <= square1_r_by_4_39;
            blend1_g_2_0_by_first_40 <= blend1_g_2_0_by_first_39;
            blend1_g_2_0_by_0_40 <= blend1_g_2_0_by_0_39;
            blend1_g_2_0_by_1_40 <= blend1_g_2_0_by_1_39;
            blend1_g_2_0_by_2_40 <= blend1_g_2_0_by_2_39;
            blend1_g_2_0_by_3_40 <= blend1_g_2_0_by_3_39;
            blend1_g_2_0_by_4_40 <= blend1_g_2_0_by_4_39;
            blend1_g_2_0_by_5_40 <= blend1_g_2_0_by_5_39;
            blend1_g_2_1_by_first_40 <= blend1_g_2_1_by_first_39;
            blend1_g_2_1_by_0_40 <= blend1_g_2_1_by_0_39;
            blend1_g_2_1_by_1_40 <= blend1_g_2_1_by_1_39;
            blend1_g_2_1_by_2_40 <= blend1_g_2_1_by_2_39;
            blend1_g_2_1_by_3_40 <= blend1_g_2_1_by_3_39;
            blend1_g_2_1_by_4_40 <= blend1_g_2_1_by_4_39;
            blend1_g_2_1_by_5_40 <= blend1_g_2_1_by_5_39;
            square1_g_by_1_40 <= square1_g_by_1_39;
            square1_g_amount_2_40 <= square1_g_amount_2_39;
            square1_g_by_4_40 <= square1_g_by_4_39;
            blend1_b_2_0_by_first_40 <= blend1_b_2_0_by_first_39;
            blend1_b_2_0_by_0_40 <= blend1_b_2_0_by_0_39;
            blend1_b_2_0_by_1_40 <= blend1_b_2_0_by_1_39;
            blend1_b_2_0_by_2_40 <= blend1_b_2_0_by_2_39;
            blend1_b_2_0_by_3_40 <= blend1_b_2_0_by_3_39;
            blend1_b_2_0_by_4_40 <= blend1_b_2_0_by_4_39;
            blend1_b_2_0_by_5_40 <= blend1_b_2_0_by_5_39;
            blend1_b_2_1_by_first_40 <= blend1_b_2_1_by_first_39;
            blend1_b_2_1_by_0_40 <= blend1_b_2_1_by_0_39;
            blend1_b_2_1_by_1_40 <= blend1_b_2_1_by_1_39;
            blend1_b_2_1_by_2_40 <= blend1_b_2_1_by_2_39;
            blend1_b_2_1_by_3_40 <= blend1_b_2_1_by_3_39;
            blend1_b_2_1_by_4_40 <= blend1_b_2_1_by_4_39;
            blend1_b_2_1_by_5_40 <= blend1_b_2_1_by_5_39;
            square1_b_by_1_40 <= square1_b_by_1_39;
            square1_b_amount_2_40 <= square1_b_amount_2_39;
            square1_b_by_4_40 <= square1_b_by_4_39;
        end
    end

    // ===== Stage 40: blend1_r_2_0_sum_1_0, blend1_r_2_0_sum_1_1 and 16 more
    // UQ-5.20: the sum of two
    wire [14:0] blend1_r_2_0_sum_1_0_40 =
        {1'd0, blend1_r_2_0_by_first_40} + {1'd0, blend1_r_2_0_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_r_2_0_sum_1_1_40 =
        {2'd0, blend1_r_2_0_by_1_40} + {1'd0, blend1_r_2_0_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_r_2_0_sum_1_2_40 =
        {2'd0, blend1_r_2_0_by_3_40} + {1'd0, blend1_r_2_0_by_4_40, 1'd0};
    // UQ-5.20: the sum of two
    wire [14:0] blend1_r_2_1_sum_1_0_40 =
        {1'd0, blend1_r_2_1_by_first_40} + {1'd0, blend1_r_2_1_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_r_2_1_sum_1_1_40 =
        {2'd0, blend1_r_2_1_by_1_40} + {1'd0, blend1_r_2_1_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_r_2_1_sum_1_2_40 =
        {2'd0, blend1_r_2_1_by_3_40} + {1'd0, blend1_r_2_1_by_4_40, 1'd0};
    // UQ-5.20: the sum of two
    wire [14:0] blend1_g_2_0_sum_1_0_40 =
        {1'd0, blend1_g_2_0_by_first_40} + {1'd0, blend1_g_2_0_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_g_2_0_sum_1_1_40 =
        {2'd0, blend1_g_2_0_by_1_40} + {1'd0, blend1_g_2_0_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_g_2_0_sum_1_2_40 =
        {2'd0, blend1_g_2_0_by_3_40} + {1'd0, blend1_g_2_0_by_4_40, 1'd0};
    // UQ-5.20: the sum of two
    wire [14:0] blend1_g_2_1_sum_1_0_40 =
        {1'd0, blend1_g_2_1_by_first_40} + {1'd0, blend1_g_2_1_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_g_2_1_sum_1_1_40 =
        {2'd0, blend1_g_2_1_by_1_40} + {1'd0, blend1_g_2_1_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_g_2_1_sum_1_2_40 =
        {2'd0, blend1_g_2_1_by_3_40} + {1'd0, blend1_g_2_1_by_4_40, 1'd0};
    // UQ-5.20: the sum of two
    wire [14:0] blend1_b_2_0_sum_1_0_40 =
        {1'd0, blend1_b_2_0_by_first_40} + {1'd0, blend1_b_2_0_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_b_2_0_sum_1_1_40 =
        {2'd0, blend1_b_2_0_by_1_40} + {1'd0, blend1_b_2_0_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_b_2_0_sum_1_2_40 =
        {2'd0, blend1_b_2_0_by_3_40} + {1'd0, blend1_b_2_0_by_4_40, 1'd0};
    // UQ-5.20: the sum of two
    wire [14:0] blend1_b_2_1_sum_1_0_40 =
        {1'd0, blend1_b_2_1_by_first_40} + {1'd0, blend1_b_2_1_by_0_40};
    // UQ-3.19: the sum of two
    wire [15:0] blend1_b_2_1_sum_1_1_40 =
        {2'd0, blend1_b_2_1_by_1_40} + {1'd0, blend1_b_2_1_by_2_40, 1'd0};
    // UQ-1.17: the sum of two
    wire [15:0] blend1_b_2_1_sum_1_2_40 =
        {2'd0, blend1_b_2_1_by_3_40} + {1'd0, blend1_b_2_1_by_4_40, 1'd0};
    reg [17:0] in_gain1r_41;
    reg [17:0] in_gain1g_41;
    reg [17:0] in_gain1b_41;
    reg hidden_41;
    reg [13:0] blend1_r_2_0_by_5_41;
    reg [14:0] blend1_r_2_0_sum_1_0_41;
    reg [15:0] blend1_r_2_0_sum_1_1_41;
    reg [15:0] blend1_r_2_0_sum_1_2_41;
    reg [13:0] blend1_r_2_1_by_5_41;
    reg [14:0] blend1_r_2_1_sum_1_0_41;
    reg [15:0] blend1_r_2_1_sum_1_1_41;
    reg [15:0] blend1_r_2_1_sum_1_2_41;
    reg [7:0] blend1_signed_41;
    reg square1_r_by_1_41;
    reg [1:0] square1_r_amount_2_41;
    reg square1_r_by_4_41;
    reg [13:0] blend1_g_2_0_by_5_41;
    reg [14:0] blend1_g_2_0_sum_1_0_41;
    reg [15:0] blend1_g_2_0_sum_1_1_41;
    reg [15:0] blend1_g_2_0_sum_1_2_41;
    reg [13:0] blend1_g_2_1_by_5_41;
    reg [14:0] blend1_g_2_1_sum_1_0_41;
    reg [15:0] blend1_g_2_1_sum_1_1_41;
    reg [15:0] blend1_g_2_1_sum_1_2_41;
    reg square1_g_by_1_41;
    reg [1:0] square1_g_amount_2_41;
    reg square1_g_by_4_41;
    reg [13:0] blend1_b_2_0_by_5_41;
    reg [14:0] blend1_b_2_0_sum_1_0_41;
    reg [15:0] blend1_b_2_0_sum_1_1_41;
    reg [15:0] blend1_b_2_0_sum_1_2_41;
    reg [13:0] blend1_b_2_1_by_5_41;
    reg [14:0] blend1_b_2_1_sum_1_0_41;
    reg [15:0] blend1_b_2_1_sum_1_1_41;
    reg [15:0] blend1_b_2_1_sum_1_2_41;
    reg square1_b_by_1_41;
    reg [1:0] square1_b_amount_2_41;
    reg square1_b_by_4_41;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_41 <= in_gain1r_40;
            in_gain1g_41 <= in_gain1g_40;
            in_gain1b_41 <= in_gain1b_40;
            hidden_41 <= hidden_40;
            blend1_r_2_0_by_5_41 <= blend1_r_2_0_by_5_40;
            blend1_r_2_0_sum_1_0_41 <= blend1_r_2_0_sum_1_0_40;
            blend1_r_2_0_sum_1_1_41 <= blend1_r_2_0_sum_1_1_40;
            blend1_r_2_0_sum_1_2_41 <= blend1_r_2_0_sum_1_2_40;
            blend1_r_2_1_by_5_41 <= blend1_r_2_1_by_5_40;
            blend1_r_2_1_sum_1_0_41 <= blend1_r_2_1_sum_1_0_40;
            blend1_r_2_1_sum_1_1_41 <= blend1_r_2_1_sum_1_1_40;
            blend1_r_2_1_sum_1_2_41 <= blend1_r_2_1_sum_1_2_40;
            blend1_signed_41 <= blend1_signed_40;
            square1_r_by_1_41 <= square1_r_by_1_40;
            square1_r_amount_2_41 <= square1_r_amount_2_40;
            square1_r_by_4_41 <= square1_r_by_4_40;
            blend1_g_2_0_by_5_41 <= blend1_g_2_0_by_5_40;
            blend1_g_2_0_sum_1_0_41 <= blend1_g_2_0_sum_1_0_40;
            blend1_g_2_0_sum_1_1_41 <= blend1_g_2_0_sum_1_1_40;
            blend1_g_2_0_sum_1_2_41 <= blend1_g_2_0_sum_1_2_40;
            blend1_g_2_1_by_5_41 <= blend1_g_2_1_by_5_40;
            blend1_g_2_1_sum_1_0_41 <= blend1_g_2_1_sum_1_0_40;
            blend1_g_2_1_sum_1_1_41 <= blend1_g_2_1_sum_1_1_40;
            blend1_g_2_1_sum_1_2_41 <= blend1_g_2_1_sum_1_2_40;
            square1_g_by_1_41 <= square1_g_by_1_40;
            square1_g_amount_2_41 <= square1_g_amount_2_40;
            square1_g_by_4_41 <= square1_g_by_4_40;
            blend1_b_2_0_by_5_41 <= blend1_b_2_0_by_5_40;
            blend1_b_2_0_sum_1_0_41 <= blend1_b_2_0_sum_1_0_40;
            blend1_b_2_0_sum_1_1_41 <= blend1_b_2_0_sum_1_1_40;
            blend1_b_2_0_sum_1_2_41 <= blend1_b_2_0_sum_1_2_40;
            blend1_b_2_1_by_5_41 <= blend1_b_2_1_by_5_40;
            blend1_b_2_1_sum_1_0_41 <= blend1_b_2_1_sum_1_0_40;
            blend1_b_2_1_sum_1_1_41 <= blend1_b_2_1_sum_1_1_40;
            blend1_b_2_1_sum_1_2_41 <= blend1_b_2_1_sum_1_2_40;
            square1_b_by_1_41 <= square1_b_by_1_40;
            square1_b_amount_2_41 <= square1_b_amount_2_40;
            square1_b_by_4_41 <= square1_b_by_4_40;
        end
    end

    // ===== Stage 41: blend1_r_2_0_sum_2_0, blend1_r_2_0_sum_2_1 and 10 more
    // UQ-3.20: the sum of two
    wire [16:0] blend1_r_2_0_sum_2_0_41 =
        {2'd0, blend1_r_2_0_sum_1_0_41} + {blend1_r_2_0_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_r_2_0_sum_2_1_41 =
        {1'd0, blend1_r_2_0_sum_1_2_41} + {1'd0, blend1_r_2_0_by_5_41, 2'd0};
    // UQ-3.20: the sum of two
    wire [16:0] blend1_r_2_1_sum_2_0_41 =
        {2'd0, blend1_r_2_1_sum_1_0_41} + {blend1_r_2_1_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_r_2_1_sum_2_1_41 =
        {1'd0, blend1_r_2_1_sum_1_2_41} + {1'd0, blend1_r_2_1_by_5_41, 2'd0};
    // UQ-3.20: the sum of two
    wire [16:0] blend1_g_2_0_sum_2_0_41 =
        {2'd0, blend1_g_2_0_sum_1_0_41} + {blend1_g_2_0_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_g_2_0_sum_2_1_41 =
        {1'd0, blend1_g_2_0_sum_1_2_41} + {1'd0, blend1_g_2_0_by_5_41, 2'd0};
    // UQ-3.20: the sum of two
    wire [16:0] blend1_g_2_1_sum_2_0_41 =
        {2'd0, blend1_g_2_1_sum_1_0_41} + {blend1_g_2_1_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_g_2_1_sum_2_1_41 =
        {1'd0, blend1_g_2_1_sum_1_2_41} + {1'd0, blend1_g_2_1_by_5_41, 2'd0};
    // UQ-3.20: the sum of two
    wire [16:0] blend1_b_2_0_sum_2_0_41 =
        {2'd0, blend1_b_2_0_sum_1_0_41} + {blend1_b_2_0_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_b_2_0_sum_2_1_41 =
        {1'd0, blend1_b_2_0_sum_1_2_41} + {1'd0, blend1_b_2_0_by_5_41, 2'd0};
    // UQ-3.20: the sum of two
    wire [16:0] blend1_b_2_1_sum_2_0_41 =
        {2'd0, blend1_b_2_1_sum_1_0_41} + {blend1_b_2_1_sum_1_1_41, 1'd0};
    // UQ0.17: the sum of two
    wire [16:0] blend1_b_2_1_sum_2_1_41 =
        {1'd0, blend1_b_2_1_sum_1_2_41} + {1'd0, blend1_b_2_1_by_5_41, 2'd0};
    reg [17:0] in_gain1r_42;
    reg [17:0] in_gain1g_42;
    reg [17:0] in_gain1b_42;
    reg hidden_42;
    reg [16:0] blend1_r_2_0_sum_2_0_42;
    reg [16:0] blend1_r_2_0_sum_2_1_42;
    reg [16:0] blend1_r_2_1_sum_2_0_42;
    reg [16:0] blend1_r_2_1_sum_2_1_42;
    reg [7:0] blend1_signed_42;
    reg square1_r_by_1_42;
    reg [1:0] square1_r_amount_2_42;
    reg square1_r_by_4_42;
    reg [16:0] blend1_g_2_0_sum_2_0_42;
    reg [16:0] blend1_g_2_0_sum_2_1_42;
    reg [16:0] blend1_g_2_1_sum_2_0_42;
    reg [16:0] blend1_g_2_1_sum_2_1_42;
    reg square1_g_by_1_42;
    reg [1:0] square1_g_amount_2_42;
    reg square1_g_by_4_42;
    reg [16:0] blend1_b_2_0_sum_2_0_42;
    reg [16:0] blend1_b_2_0_sum_2_1_42;
    reg [16:0] blend1_b_2_1_sum_2_0_42;
    reg [16:0] blend1_b_2_1_sum_2_1_42;
    reg square1_b_by_1_42;
    reg [1:0] square1_b_amount_2_42;
    reg square1_b_by_4_42;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_42 <= in_gain1r_41;
            in_gain1g_42 <= in_gain1g_41;
            in_gain1b_42 <= in_gain1b_41;
            hidden_42 <= hidden_41;
            blend1_r_2_0_sum_2_0_42 <= blend1_r_2_0_sum_2_0_41;
            blend1_r_2_0_sum_2_1_42 <= blend1_r_2_0_sum_2_1_41;
            blend1_r_2_1_sum_2_0_42 <= blend1_r_2_1_sum_2_0_41;
            blend1_r_2_1_sum_2_1_42 <= blend1_r_2_1_sum_2_1_41;
            blend1_signed_42 <= blend1_signed_41;
            square1_r_by_1_42 <= square1_r_by_1_41;
            square1_r_amount_2_42 <= square1_r_amount_2_41;
            square1_r_by_4_42 <= square1_r_by_4_41;
            blend1_g_2_0_sum_2_0_42 <= blend1_g_2_0_sum_2_0_41;
            blend1_g_2_0_sum_2_1_42 <= blend1_g_2_0_sum_2_1_41;
            blend1_g_2_1_sum_2_0_42 <= blend1_g_2_1_sum_2_0_41;
            blend1_g_2_1_sum_2_1_42 <= blend1_g_2_1_sum_2_1_41;
            square1_g_by_1_42 <= square1_g_by_1_41;
            square1_g_amount_2_42 <= square1_g_amount_2_41;
            square1_g_by_4_42 <= square1_g_by_4_41;
            blend1_b_2_0_sum_2_0_42 <= blend1_b_2_0_sum_2_0_41;
            blend1_b_2_0_sum_2_1_42 <= blend1_b_2_0_sum_2_1_41;
            blend1_b_2_1_sum_2_0_42 <= blend1_b_2_1_sum_2_0_41;
            blend1_b_2_1_sum_2_1_42 <= blend1_b_2_1_sum_2_1_41;
            square1_b_by_1_42 <= square1_b_by_1_41;
            square1_b_amount_2_42 <= square1_b_amount_2_41;
            square1_b_by_4_42 <= square1_b_by_4_41;
        end
    end

    // ===== Stage 42: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    // UQ0.20: two neighbours
    wire [19:0] blend1_r_2_0_42 = {3'd0, blend1_r_2_0_sum_2_0_42} + {blend1_r_2_0_sum_2_1_42, 3'd0};
    // UQ0.20: two neighbours
    wire [19:0] blend1_r_2_1_42 = {3'd0, blend1_r_2_1_sum_2_0_42} + {blend1_r_2_1_sum_2_1_42, 3'd0};
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_r_2_0_cut_42 = blend1_r_2_0_42[19:3];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_r_2_1_cut_42 = blend1_r_2_1_42[19:3];
    // UQ0.20: two neighbours
    wire [19:0] blend1_g_2_0_42 = {3'd0, blend1_g_2_0_sum_2_0_42} + {blend1_g_2_0_sum_2_1_42, 3'd0};
    // UQ0.20: two neighbours
    wire [19:0] blend1_g_2_1_42 = {3'd0, blend1_g_2_1_sum_2_0_42} + {blend1_g_2_1_sum_2_1_42, 3'd0};
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_g_2_0_cut_42 = blend1_g_2_0_42[19:3];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_g_2_1_cut_42 = blend1_g_2_1_42[19:3];
    // UQ0.20: two neighbours
    wire [19:0] blend1_b_2_0_42 = {3'd0, blend1_b_2_0_sum_2_0_42} + {blend1_b_2_0_sum_2_1_42, 3'd0};
    // UQ0.20: two neighbours
    wire [19:0] blend1_b_2_1_42 = {3'd0, blend1_b_2_1_sum_2_0_42} + {blend1_b_2_1_sum_2_1_42, 3'd0};
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_b_2_0_cut_42 = blend1_b_2_0_42[19:3];
    // UQ0.17: rounded down to a multiplier's operand
    wire [16:0] blend1_b_2_1_cut_42 = blend1_b_2_1_42[19:3];
    reg [17:0] in_gain1r_43;
    reg [17:0] in_gain1g_43;
    reg [17:0] in_gain1b_43;
    reg hidden_43;
    reg [16:0] blend1_r_2_0_cut_43;
    reg [16:0] blend1_r_2_1_cut_43;
    reg [7:0] blend1_signed_43;
    reg square1_r_by_1_43;
    reg [1:0] square1_r_amount_2_43;
    reg square1_r_by_4_43;
    reg [16:0] blend1_g_2_0_cut_43;
    reg [16:0] blend1_g_2_1_cut_43;
    reg square1_g_by_1_43;
    reg [1:0] square1_g_amount_2_43;
    reg square1_g_by_4_43;
    reg [16:0] blend1_b_2_0_cut_43;
    reg [16:0] blend1_b_2_1_cut_43;
    reg square1_b_by_1_43;
    reg [1:0] square1_b_amount_2_43;
    reg square1_b_by_4_43;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_43 <= in_gain1r_42;
            in_gain1g_43 <= in_gain1g_42;
            in_gain1b_43 <= in_gain1b_42;
            hidden_43 <= hidden_42;
            blend1_r_2_0_cut_43 <= blend1_r_2_0_cut_42;
            blend1_r_2_1_cut_43 <= blend1_r_2_1_cut_42;
            blend1_signed_43 <= blend1_signed_42;
            square1_r_by_1_43 <= square1_r_by_1_42;
            square1_r_amount_2_43 <= square1_r_amount_2_42;
            square1_r_by_4_43 <= square1_r_by_4_42;
            blend1_g_2_0_cut_43 <= blend1_g_2_0_cut_42;
            blend1_g_2_1_cut_43 <= blend1_g_2_1_cut_42;
            square1_g_by_1_43 <= square1_g_by_1_42;
            square1_g_amount_2_43 <= square1_g_amount_2_42;
            square1_g_by_4_43 <= square1_g_by_4_42;
            blend1_b_2_0_cut_43 <= blend1_b_2_0_cut_42;
            blend1_b_2_1_cut_43 <= blend1_b_2_1_cut_42;
            square1_b_by_1_43 <= square1_b_by_1_42;
            square1_b_amount_2_43 <= square1_b_amount_2_42;
            square1_b_by_4_43 <= square1_b_by_4_42;
        end
    end

    // ===== Stage 43: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    // Q0.17: the difference
    wire [17:0] blend1_r_3_0_apart_43 = {1'd0, blend1_r_2_1_cut_43} - {1'd0, blend1_r_2_0_cut_43};
    // Q0.17: the difference
    wire [17:0] blend1_g_3_0_apart_43 = {1'd0, blend1_g_2_1_cut_43} - {1'd0, blend1_g_2_0_cut_43};
    // Q0.17: the difference
    wire [17:0] blend1_b_3_0_apart_43 = {1'd0, blend1_b_2_1_cut_43} - {1'd0, blend1_b_2_0_cut_43};
    reg [17:0] in_gain1r_44;
    reg [17:0] in_gain1g_44;
    reg [17:0] in_gain1b_44;
    reg hidden_44;
    reg [16:0] blend1_r_2_0_cut_44;
    reg [17:0] blend1_r_3_0_apart_44;
    reg [7:0] blend1_signed_44;
    reg square1_r_by_1_44;
    reg [1:0] square1_r_amount_2_44;
    reg square1_r_by_4_44;
    reg [16:0] blend1_g_2_0_cut_44;
    reg [17:0] blend1_g_3_0_apart_44;
    reg square1_g_by_1_44;
    reg [1:0] square1_g_amount_2_44;
    reg square1_g_by_4_44;
    reg [16:0] blend1_b_2_0_cut_44;
    reg [17:0] blend1_b_3_0_apart_44;
    reg square1_b_by_1_44;
    reg [1:0] square1_b_amount_2_44;
    reg square1_b_by_4_44;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_44 <= in_gain1r_43;
            in_gain1g_44 <= in_gain1g_43;
            in_gain1b_44 <= in_gain1b_43;
            hidden_44 <= hidden_43;
            blend1_r_2_0_cut_44 <= blend1_r_2_0_cut_43;
            blend1_r_3_0_apart_44 <= blend1_r_3_0_apart_43;
            blend1_signed_44 <= blend1_signed_43;
            square1_r_by_1_44 <= square1_r_by_1_43;
            square1_r_amount_2_44 <= square1_r_amount_2_43;
            square1_r_by_4_44 <= square1_r_by_4_43;
            blend1_g_2_0_cut_44 <= blend1_g_2_0_cut_43;
            blend1_g_3_0_apart_44 <= blend1_g_3_0_apart_43;
            square1_g_by_1_44 <= square1_g_by_1_43;
            square1_g_amount_2_44 <= square1_g_amount_2_43;
            square1_g_by_4_44 <= square1_g_by_4_43;
            blend1_b_2_0_cut_44 <= blend1_b_2_0_cut_43;
            blend1_b_3_0_apart_44 <= blend1_b_3_0_apart_43;
            square1_b_by_1_44 <= square1_b_by_1_43;
            square1_b_amount_2_44 <= square1_b_amount_2_43;
            square1_b_by_4_44 <= square1_b_by_4_43;
        end
    end

    // ===== Stage 44: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    // Q2.23: its part
    wire [25:0] blend1_r_3_0_part_44 = $signed(blend1_r_3_0_apart_44) * $signed(blend1_signed_44);
    // Q2.23: its part
    wire [25:0] blend1_g_3_0_part_44 = $signed(blend1_g_3_0_apart_44) * $signed(blend1_signed_44);
    // Q2.23: its part
    wire [25:0] blend1_b_3_0_part_44 = $signed(blend1_b_3_0_apart_44) * $signed(blend1_signed_44);
    reg [17:0] in_gain1r_45;
    reg [17:0] in_gain1g_45;
    reg [17:0] in_gain1b_45;
    reg hidden_45;
    reg [16:0] blend1_r_2_0_cut_45;
    reg [25:0] blend1_r_3_0_part_45;
    reg square1_r_by_1_45;
    reg [1:0] square1_r_amount_2_45;
    reg square1_r_by_4_45;
    reg [16:0] blend1_g_2_0_cut_45;
    reg [25:0] blend1_g_3_0_part_45;
    reg square1_g_by_1_45;
    reg [1:0] square1_g_amount_2_45;
    reg square1_g_by_4_45;
    reg [16:0] blend1_b_2_0_cut_45;
    reg [25:0] blend1_b_3_0_part_45;
    reg square1_b_by_1_45;
    reg [1:0] square1_b_amount_2_45;
    reg square1_b_by_4_45;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_45 <= in_gain1r_44;
            in_gain1g_45 <= in_gain1g_44;
            in_gain1b_45 <= in_gain1b_44;
            hidden_45 <= hidden_44;
            blend1_r_2_0_cut_45 <= blend1_r_2_0_cut_44;
            blend1_r_3_0_part_45 <= blend1_r_3_0_part_44;
            square1_r_by_1_45 <= square1_r_by_1_44;
            square1_r_amount_2_45 <= square1_r_amount_2_44;
            square1_r_by_4_45 <= square1_r_by_4_44;
            blend1_g_2_0_cut_45 <= blend1_g_2_0_cut_44;
            blend1_g_3_0_part_45 <= blend1_g_3_0_part_44;
            square1_g_by_1_45 <= square1_g_by_1_44;
            square1_g_amount_2_45 <= square1_g_amount_2_44;
            square1_g_by_4_45 <= square1_g_by_4_44;
            blend1_b_2_0_cut_45 <= blend1_b_2_0_cut_44;
            blend1_b_3_0_part_45 <= blend1_b_3_0_part_44;
            square1_b_by_1_45 <= square1_b_by_1_44;
            square1_b_amount_2_45 <= square1_b_amount_2_44;
            square1_b_by_4_45 <= square1_b_by_4_44;
        end
    end

    // ===== Stage 45: registers only
    reg [17:0] in_gain1r_46;
    reg [17:0] in_gain1g_46;
    reg [17:0] in_gain1b_46;
    reg hidden_46;
    reg [16:0] blend1_r_2_0_cut_46;
    reg [25:0] blend1_r_3_0_part_46;
    reg square1_r_by_1_46;
    reg [1:0] square1_r_amount_2_46;
    reg square1_r_by_4_46;
    reg [16:0] blend1_g_2_0_cut_46;
    reg [25:0] blend1_g_3_0_part_46;
    reg square1_g_by_1_46;
    reg [1:0] square1_g_amount_2_46;
    reg square1_g_by_4_46;
    reg [16:0] blend1_b_2_0_cut_46;
    reg [25:0] blend1_b_3_0_part_46;
    reg square1_b_by_1_46;
    reg [1:0] square1_b_amount_2_46;
    reg square1_b_by_4_46;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_46 <= in_gain1r_45;
            in_gain1g_46 <= in_gain1g_45;
            in_gain1b_46 <= in_gain1b_45;
            hidden_46 <= hidden_45;
            blend1_r_2_0_cut_46 <= blend1_r_2_0_cut_45;
            blend1_r_3_0_part_46 <= blend1_r_3_0_part_45;
            square1_r_by_1_46 <= square1_r_by_1_45;
            square1_r_amount_2_46 <= square1_r_amount_2_45;
            square1_r_by_4_46 <= square1_r_by_4_45;
            blend1_g_2_0_cut_46 <= blend1_g_2_0_cut_45;
            blend1_g_3_0_part_46 <= blend1_g_3_0_part_45;
            square1_g_by_1_46 <= square1_g_by_1_45;
            square1_g_amount_2_46 <= square1_g_amount_2_45;
            square1_g_by_4_46 <= square1_g_by_4_45;
            blend1_b_2_0_cut_46 <= blend1_b_2_0_cut_45;
            blend1_b_3_0_part_46 <= blend1_b_3_0_part_45;
            square1_b_by_1_46 <= square1_b_by_1_45;
            square1_b_amount_2_46 <= square1_b_amount_2_45;
            square1_b_by_4_46 <= square1_b_by_4_45;
        end
    end

    // ===== Stage 46: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    // UQ0.23: two bands
    wire [22:0] blend1_r_3_0_46 = {blend1_r_2_0_cut_46, 6'd0} + blend1_r_3_0_part_46[22:0];
    // UQ0.18: the blended code
    wire [17:0] root1_r_46 = blend1_r_3_0_46[22:5];
    // UQ0.23: two bands
    wire [22:0] blend1_g_3_0_46 = {blend1_g_2_0_cut_46, 6'd0} + blend1_g_3_0_part_46[22:0];
    // UQ0.18: the blended code
    wire [17:0] root1_g_46 = blend1_g_3_0_46[22:5];
    // UQ0.23: two bands
    wire [22:0] blend1_b_3_0_46 = {blend1_b_2_0_cut_46, 6'd0} + blend1_b_3_0_part_46[22:0];
    // UQ0.18: the blended code
    wire [17:0] root1_b_46 = blend1_b_3_0_46[22:5];
    reg [17:0] in_gain1r_47;
    reg [17:0] in_gain1g_47;
    reg [17:0] in_gain1b_47;
    reg hidden_47;
    reg [17:0] root1_r_47;
    reg square1_r_by_1_47;
    reg [1:0] square1_r_amount_2_47;
    reg square1_r_by_4_47;
    reg [17:0] root1_g_47;
    reg square1_g_by_1_47;
    reg [1:0] square1_g_amount_2_47;
    reg square1_g_by_4_47;
    reg [17:0] root1_b_47;
    reg square1_b_by_1_47;
    reg [1:0] square1_b_amount_2_47;
    reg square1_b_by_4_47;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_47 <= in_gain1r_46;
            in_gain1g_47 <= in_gain1g_46;
            in_gain1b_47 <= in_gain1b_46;
            hidden_47 <= hidden_46;
            root1_r_47 <= root1_r_46;
            square1_r_by_1_47 <= square1_r_by_1_46;
            square1_r_amount_2_47 <= square1_r_amount_2_46;
            square1_r_by_4_47 <= square1_r_by_4_46;
            root1_g_47 <= root1_g_46;
            square1_g_by_1_47 <= square1_g_by_1_46;
            square1_g_amount_2_47 <= square1_g_amount_2_46;
            square1_g_by_4_47 <= square1_g_by_4_46;
            root1_b_47 <= root1_b_46;
            square1_b_by_1_47 <= square1_b_by_1_46;
            square1_b_amount_2_47 <= square1_b_amount_2_46;
            square1_b_by_4_47 <= square1_b_by_4_46;
        end
    end

    // ===== Stage 47: square1_r_exact, square1_g_exact, square1_b_exact
    // UQ0.36: its square
    wire [35:0] square1_r_exact_47 = root1_r_47 * root1_r_47;
    // UQ0.18: rounded down
    wire [17:0] square1_r_47 = square1_r_exact_47[35:18];
    // UQ0.36: its square
    wire [35:0] square1_g_exact_47 = root1_g_47 * root1_g_47;
    // UQ0.18: rounded down
    wire [17:0] square1_g_47 = square1_g_exact_47[35:18];
    // UQ0.36: its square
    wire [35:0] square1_b_exact_47 = root1_b_47 * root1_b_47;
    // UQ0.18: rounded down
    wire [17:0] square1_b_47 = square1_b_exact_47[35:18];
    reg [17:0] in_gain1r_48;
    reg [17:0] in_gain1g_48;
    reg [17:0] in_gain1b_48;
    reg hidden_48;
    reg [17:0] square1_r_48;
    reg square1_r_by_1_48;
    reg [1:0] square1_r_amount_2_48;
    reg square1_r_by_4_48;
    reg [17:0] square1_g_48;
    reg square1_g_by_1_48;
    reg [1:0] square1_g_amount_2_48;
    reg square1_g_by_4_48;
    reg [17:0] square1_b_48;
    reg square1_b_by_1_48;
    reg [1:0] square1_b_amount_2_48;
    reg square1_b_by_4_48;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_48 <= in_gain1r_47;
            in_gain1g_48 <= in_gain1g_47;
            in_gain1b_48 <= in_gain1b_47;
            hidden_48 <= hidden_47;
            square1_r_48 <= square1_r_47;
            square1_r_by_1_48 <= square1_r_by_1_47;
            square1_r_amount_2_48 <= square1_r_amount_2_47;
            square1_r_by_4_48 <= square1_r_by_4_47;
            square1_g_48 <= square1_g_47;
            square1_g_by_1_48 <= square1_g_by_1_47;
            square1_g_amount_2_48 <= square1_g_amount_2_47;
            square1_g_by_4_48 <= square1_g_by_4_47;
            square1_b_48 <= square1_b_47;
            square1_b_by_1_48 <= square1_b_by_1_47;
            square1_b_amount_2_48 <= square1_b_amount_2_47;
            square1_b_by_4_48 <= square1_b_by_4_47;
        end
    end

    // ===== Stage 48: square1_r_seen, square1_r_up_1, square1_g_seen and 3 more
    // UQ0.18: 0 for a normal that is turned away
    wire [17:0] square1_r_seen_48 = hidden_48 ? 18'd0 : square1_r_48;
    // UQ1.18: times 2^1 if so
    wire [18:0] square1_r_up_1_48 = {1'd0, square1_r_seen_48} << square1_r_by_1_48;
    // UQ4.14: times 2^4
    wire [17:0] square1_r_all_48 = square1_r_seen_48;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_r_all_wide_48 = {square1_r_all_48, 4'd0};
    // UQ0.18: 0 for a normal that is turned away
    wire [17:0] square1_g_seen_48 = hidden_48 ? 18'd0 : square1_g_48;
    // UQ1.18: times 2^1 if so
    wire [18:0] square1_g_up_1_48 = {1'd0, square1_g_seen_48} << square1_g_by_1_48;
    // UQ4.14: times 2^4
    wire [17:0] square1_g_all_48 = square1_g_seen_48;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_g_all_wide_48 = {square1_g_all_48, 4'd0};
    // UQ0.18: 0 for a normal that is turned away
    wire [17:0] square1_b_seen_48 = hidden_48 ? 18'd0 : square1_b_48;
    // UQ1.18: times 2^1 if so
    wire [18:0] square1_b_up_1_48 = {1'd0, square1_b_seen_48} << square1_b_by_1_48;
    // UQ4.14: times 2^4
    wire [17:0] square1_b_all_48 = square1_b_seen_48;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_b_all_wide_48 = {square1_b_all_48, 4'd0};
    reg [17:0] in_gain1r_49;
    reg [17:0] in_gain1g_49;
    reg [17:0] in_gain1b_49;
    reg [18:0] square1_r_up_1_49;
    reg [1:0] square1_r_amount_2_49;
    reg square1_r_by_4_49;
    reg [21:0] square1_r_all_wide_49;
    reg [18:0] square1_g_up_1_49;
    reg [1:0] square1_g_amount_2_49;
    reg square1_g_by_4_49;
    reg [21:0] square1_g_all_wide_49;
    reg [18:0] square1_b_up_1_49;
    reg [1:0] square1_b_amount_2_49;
    reg square1_b_by_4_49;
    reg [21:0] square1_b_all_wide_49;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_49 <= in_gain1r_48;
            in_gain1g_49 <= in_gain1g_48;
            in_gain1b_49 <= in_gain1b_48;
            square1_r_up_1_49 <= square1_r_up_1_48;
            square1_r_amount_2_49 <= square1_r_amount_2_48;
            square1_r_by_4_49 <= square1_r_by_4_48;
            square1_r_all_wide_49 <= square1_r_all_wide_48;
            square1_g_up_1_49 <= square1_g_up_1_48;
            square1_g_amount_2_49 <= square1_g_amount_2_48;
            square1_g_by_4_49 <= square1_g_by_4_48;
            square1_g_all_wide_49 <= square1_g_all_wide_48;
            square1_b_up_1_49 <= square1_b_up_1_48;
            square1_b_amount_2_49 <= square1_b_amount_2_48;
            square1_b_by_4_49 <= square1_b_by_4_48;
            square1_b_all_wide_49 <= square1_b_all_wide_48;
        end
    end

    // ===== Stage 49: square1_r_up_2, square1_r_up, square1_r_within and 6 more
    // UQ3.18: times 2^2 if so
    wire [20:0] square1_r_up_2_49 = {2'd0, square1_r_up_1_49} << square1_r_amount_2_49;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_r_up_2_wide_49 = {1'd0, square1_r_up_2_49};
    // UQ4.18: times 2^shift
    wire [21:0] square1_r_up_49 =
        square1_r_by_4_49 ? square1_r_all_wide_49 : square1_r_up_2_wide_49;
    // UQ4.14: rounded down
    wire [17:0] square1_r_up_cut_49 = square1_r_up_49[21:4];
    // UQ4.14: kept in its format
    wire [17:0] square1_r_within_49 = square1_r_up_cut_49;
    // UQ3.18: times 2^2 if so
    wire [20:0] square1_g_up_2_49 = {2'd0, square1_g_up_1_49} << square1_g_amount_2_49;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_g_up_2_wide_49 = {1'd0, square1_g_up_2_49};
    // UQ4.18: times 2^shift
    wire [21:0] square1_g_up_49 =
        square1_g_by_4_49 ? square1_g_all_wide_49 : square1_g_up_2_wide_49;
    // UQ4.14: rounded down
    wire [17:0] square1_g_up_cut_49 = square1_g_up_49[21:4];
    // UQ4.14: kept in its format
    wire [17:0] square1_g_within_49 = square1_g_up_cut_49;
    // UQ3.18: times 2^2 if so
    wire [20:0] square1_b_up_2_49 = {2'd0, square1_b_up_1_49} << square1_b_amount_2_49;
    // UQ4.18: in the wider of two formats
    wire [21:0] square1_b_up_2_wide_49 = {1'd0, square1_b_up_2_49};
    // UQ4.18: times 2^shift
    wire [21:0] square1_b_up_49 =
        square1_b_by_4_49 ? square1_b_all_wide_49 : square1_b_up_2_wide_49;
    // UQ4.14: rounded down
    wire [17:0] square1_b_up_cut_49 = square1_b_up_49[21:4];
    // UQ4.14: kept in its format
    wire [17:0] square1_b_within_49 = square1_b_up_cut_49;
    reg [17:0] in_gain1r_50;
    reg [17:0] in_gain1g_50;
    reg [17:0] in_gain1b_50;
    reg [17:0] square1_r_within_50;
    reg [17:0] square1_g_within_50;
    reg [17:0] square1_b_within_50;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_50 <= in_gain1r_49;
            in_gain1g_50 <= in_gain1g_49;
            in_gain1b_50 <= in_gain1b_49;
            square1_r_within_50 <= square1_r_within_49;
            square1_g_within_50 <= square1_g_within_49;
            square1_b_within_50 <= square1_b_within_49;
        end
    end

    // ===== Stage 50: light1_r_exact, light1_g_exact, light1_b_exact
    // UQ5.31: times the gain
    wire [35:0] light1_r_exact_50 = square1_r_within_50 * in_gain1r_50;
    // UQ5.17: rounded down
    wire [21:0] light1_r_50 = light1_r_exact_50[35:14];
    // UQ5.31: times the gain
    wire [35:0] light1_g_exact_50 = square1_g_within_50 * in_gain1g_50;
    // UQ5.17: rounded down
    wire [21:0] light1_g_50 = light1_g_exact_50[35:14];
    // UQ5.31: times the gain
    wire [35:0] light1_b_exact_50 = square1_b_within_50 * in_gain1b_50;
    // UQ5.17: rounded down
    wire [21:0] light1_b_50 = light1_b_exact_50[35:14];
    reg [21:0] light1_r_51;
    reg [21:0] light1_g_51;
    reg [21:0] light1_b_51;
    always @(posedge clk) begin
        if (ce) begin
            light1_r_51 <= light1_r_50;
            light1_g_51 <= light1_g_50;
            light1_b_51 <= light1_b_50;
        end
    end

    // ===== Stage 51: sum_r, sum_g, sum_b
    // UQ1.17: kept at 1.0
    wire [17:0] sum_r_51 = (|light1_r_51[21:17]) ? 18'h20000 : light1_r_51[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_g_51 = (|light1_g_51[21:17]) ? 18'h20000 : light1_g_51[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_b_51 = (|light1_b_51[21:17]) ? 18'h20000 : light1_b_51[17:0];
    reg [17:0] sum_r_52;
    reg [17:0] sum_g_52;
    reg [17:0] sum_b_52;
    always @(posedge clk) begin
        if (ce) begin
            sum_r_52 <= sum_r_51;
            sum_g_52 <= sum_g_51;
            sum_b_52 <= sum_b_51;
        end
    end

    assign out_valid = valid[52];
    assign out_sum_r = sum_r_52;
    assign out_sum_g = sum_g_52;
    assign out_sum_b = sum_b_52;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    band1_next_2[0],
                    v1_x_exact_0[17:0],
                    v1_y_exact_0[17:0],
                    v1_place_2[2:0],
                    v1_next_5[0],
                    x1_x_exact_0[17:0],
                    x1_y_exact_0[17:0],
                    u1_x_exact_0[17:0],
                    u1_y_exact_0[17:0],
                    u1_z_exact_0[17:0],
                    v1_square_4[31:30],
                    rr1_exact_4[11:0],
                    rr1_twice_5[15],
                    rest1_6[6:0],
                    root_at1_14[4:0],
                    tilt1_exact_15[32:31],
                    tilt1_exact_15[11:0],
                    turn_more_exact1_even_17[28:27],
                    turn_more_exact1_even_17[11:0],
                    sin_exact1_even_26[9:0],
                    cos_exact1_even_26[9:0],
                    xc1_even_exact_27[31:30],
                    xc1_even_exact_27[13:0],
                    zs1_even_exact_27[33],
                    zs1_even_exact_27[15:0],
                    zc1_even_exact_27[33],
                    zc1_even_exact_27[15:0],
                    xs1_even_exact_27[31:30],
                    xs1_even_exact_27[13:0],
                    u1_even_place_29[2:0],
                    u1_even_next_32[0],
                    turn_more_exact1_odd_17[28:27],
                    turn_more_exact1_odd_17[11:0],
                    sin_exact1_odd_26[9:0],
                    cos_exact1_odd_26[9:0],
                    xc1_odd_exact_27[31:30],
                    xc1_odd_exact_27[13:0],
                    zs1_odd_exact_27[33],
                    zs1_odd_exact_27[15:0],
                    zc1_odd_exact_27[33],
                    zc1_odd_exact_27[15:0],
                    xs1_odd_exact_27[31:30],
                    xs1_odd_exact_27[13:0],
                    u1_odd_place_29[2:0],
                    u1_odd_next_32[0],
                    blend1_r_2_0_42[2:0],
                    blend1_r_2_1_42[2:0],
                    blend1_r_3_0_part_46[25:23],
                    blend1_r_3_0_46[4:0],
                    square1_r_exact_47[17:0],
                    square1_r_up_49[3:0],
                    light1_r_exact_50[13:0],
                    blend1_g_2_0_42[2:0],
                    blend1_g_2_1_42[2:0],
                    blend1_g_3_0_part_46[25:23],
                    blend1_g_3_0_46[4:0],
                    square1_g_exact_47[17:0],
                    square1_g_up_49[3:0],
                    light1_g_exact_50[13:0],
                    blend1_b_2_0_42[2:0],
                    blend1_b_2_1_42[2:0],
                    blend1_b_3_0_part_46[25:23],
                    blend1_b_3_0_46[4:0],
                    square1_b_exact_47[17:0],
                    square1_b_up_49[3:0],
                    light1_b_exact_50[13:0]};

endmodule

`default_nettype wire
