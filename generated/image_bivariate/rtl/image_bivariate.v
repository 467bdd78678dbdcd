// image_bivariate: image-based block of ggx (bivariate, 32 x 32 texels), 1 light a clock, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec b18a9704e4315ab5. Generated; the core is yours to use under any terms.
//
//   in_nx     Q1.16   x of the unit normal, the viewer at +z
//   in_ny     Q1.16   y of the unit normal, the viewer at +z
//   in_nz     Q1.16   z of the unit normal, the viewer at +z
//   in_l1x    Q1.16   x of the unit vector to light 1
//   in_l1y    Q1.16   y of the unit vector to light 1
//   in_l1z    Q1.16   z of the unit vector to light 1
//   in_h1x    Q1.16   x of light 1's half vector
//   in_h1y    Q1.16   y of light 1's half vector
//   in_h1z    Q1.16   z of light 1's half vector
//   in_band1  UQ5.0   row of texels below light 1's angle
//   in_blend1 UQ1.5   weight of the odd one of this row and the next, at most 1
//   in_shift1 UQ4.0   exponent of light 1's gain
//   in_gain1r UQ0.18  red of light 1's gain
//   in_gain1g UQ0.18  green of light 1's gain
//   in_gain1b UQ0.18  blue of light 1's gain
//   out_sum_r UQ1.17  red of these lights, at most 1.0
//   out_sum_g UQ1.17  green of these lights, at most 1.0
//   out_sum_b UQ1.17  blue of these lights, at most 1.0
//
// Latency 23 clocks, one result a clock.
// Pictures of a sphere against the exact reflectance, lit from 34 angles:
//   44.7 dB in the mean, 35.0 dB at the worst angle.

`timescale 1ns / 1ps
`default_nettype none

module image_bivariate #(
    // Path of the memory texels_1_even_even, read by $readmemh.
    parameter TEXELS_1_EVEN_EVEN_FILE = "rom/image_bivariate_texels_1_even_even.mem",
    // Path of the memory texels_1_even_odd, read by $readmemh.
    parameter TEXELS_1_EVEN_ODD_FILE = "rom/image_bivariate_texels_1_even_odd.mem",
    // Path of the memory texels_1_odd_even, read by $readmemh.
    parameter TEXELS_1_ODD_EVEN_FILE = "rom/image_bivariate_texels_1_odd_even.mem",
    // Path of the memory texels_1_odd_odd, read by $readmemh.
    parameter TEXELS_1_ODD_ODD_FILE = "rom/image_bivariate_texels_1_odd_odd.mem"
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
    // Q1.16: x of light 1's half vector
    input  wire [17:0] in_h1x,
    // Q1.16: y of light 1's half vector
    input  wire [17:0] in_h1y,
    // Q1.16: z of light 1's half vector
    input  wire [17:0] in_h1z,
    // UQ5.0: row of texels below light 1's angle
    input  wire [4:0] in_band1,
    // UQ1.5: weight of the odd one of this row and the next, at most 1
    input  wire [5:0] in_blend1,
    // UQ4.0: exponent of light 1's gain
    input  wire [3:0] in_shift1,
    // UQ0.18: red of light 1's gain
    input  wire [17:0] in_gain1r,
    // UQ0.18: green of light 1's gain
    input  wire [17:0] in_gain1g,
    // UQ0.18: blue of light 1's gain
    input  wire [17:0] in_gain1b,
    // the other outputs are a result: in_valid, 23 enabled clocks later
    output wire        out_valid,
    // UQ1.17: red of these lights, at most 1.0
    output wire [17:0] out_sum_r,
    // UQ1.17: green of these lights, at most 1.0
    output wire [17:0] out_sum_g,
    // UQ1.17: blue of these lights, at most 1.0
    output wire [17:0] out_sum_b
);

    // ===== Valid chain
    reg [23:1] valid;
    initial valid = 23'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 23'd0;
        end else if (ce) begin
            valid <= {valid[22:1], in_valid};
        end
    end

    // ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 9 more
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
    // UQ1.5: the weight of the odd band, at most 1
    wire [5:0] blend1_0 = (|in_blend1[5]) ? 6'h20 : in_blend1;
    // UQ6.0: the next
    wire [5:0] band1_next_exact_0 = {1'd0, in_band1} + 6'h01;
    // UQ5.0: at most the last
    wire [4:0] band1_next_0 = (band1_next_exact_0 > 6'h1f) ? 5'h1f : band1_next_exact_0[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] band1_even_high_0 = band1_next_0[4:1];
    // UQ4.0: the even one of both
    wire [3:0] band1_even_0 = band1_even_high_0;
    // UQ5.-1: its leading bits
    wire [3:0] band1_odd_high_0 = in_band1[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] band1_odd_0 = band1_odd_high_0;
    // Q2.16: a component of n - h
    wire [18:0] d1_x_exact_0 = {{1{in_nx[17]}}, in_nx} - {{1{in_h1x[17]}}, in_h1x};
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_x_0 = ($signed(d1_x_exact_0) < $signed(19'h60000)) ? 18'h20000 :
        ($signed(d1_x_exact_0) > $signed(19'h1ffff)) ? 18'h1ffff :
        d1_x_exact_0[17:0];
    // Q2.16: a component of n - h
    wire [18:0] d1_y_exact_0 = {{1{in_ny[17]}}, in_ny} - {{1{in_h1y[17]}}, in_h1y};
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_y_0 = ($signed(d1_y_exact_0) < $signed(19'h60000)) ? 18'h20000 :
        ($signed(d1_y_exact_0) > $signed(19'h1ffff)) ? 18'h1ffff :
        d1_y_exact_0[17:0];
    // Q2.16: a component of n - h
    wire [18:0] d1_z_exact_0 = {{1{in_nz[17]}}, in_nz} - {{1{in_h1z[17]}}, in_h1z};
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_z_0 = ($signed(d1_z_exact_0) < $signed(19'h60000)) ? 18'h20000 :
        ($signed(d1_z_exact_0) > $signed(19'h1ffff)) ? 18'h1ffff :
        d1_z_exact_0[17:0];
    // UQ8.-4: the first of them
    wire [3:0] texels1_00_0 = band1_even_0;
    // UQ8.-4: the first of them
    wire [3:0] texels1_01_0 = band1_even_0;
    // UQ8.-4: the first of them
    wire [3:0] texels1_10_0 = band1_odd_0;
    // UQ8.-4: the first of them
    wire [3:0] texels1_11_0 = band1_odd_0;
    // Q1.5: a sign bit for the signed product
    wire [6:0] blend1_signed_0 = {1'd0, blend1_0};
    reg [17:0] in_gain1r_1;
    reg [17:0] in_gain1g_1;
    reg [17:0] in_gain1b_1;
    reg hidden_1;
    reg [3:0] shift1_1;
    reg [26:0] nl1_x_1;
    reg [26:0] nl1_y_1;
    reg [26:0] nl1_z_1;
    reg [17:0] d1_x_1;
    reg [17:0] d1_y_1;
    reg [17:0] d1_z_1;
    reg [3:0] texels1_00_1;
    reg [3:0] texels1_01_1;
    reg [3:0] texels1_10_1;
    reg [3:0] texels1_11_1;
    reg [6:0] blend1_signed_1;
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
            d1_x_1 <= d1_x_0;
            d1_y_1 <= d1_y_0;
            d1_z_1 <= d1_z_0;
            texels1_00_1 <= texels1_00_0;
            texels1_01_1 <= texels1_01_0;
            texels1_10_1 <= texels1_10_0;
            texels1_11_1 <= texels1_11_0;
            blend1_signed_1 <= blend1_signed_0;
        end
    end

    // ===== Stage 1: nl1_xy, dd1_x_exact, dd1_y_exact, dd1_z_exact
    // Q4.23: n.l
    wire [27:0] nl1_xy_1 = {{1{nl1_x_1[26]}}, nl1_x_1} + {{1{nl1_y_1[26]}}, nl1_y_1};
    // Q3.32: |n - h|^2
    wire [35:0] dd1_x_exact_1 = $signed(d1_x_1) * $signed(d1_x_1);
    // Q3.17: rounded down
    wire [20:0] dd1_x_1 = dd1_x_exact_1[35:15];
    // Q3.32: |n - h|^2
    wire [35:0] dd1_y_exact_1 = $signed(d1_y_1) * $signed(d1_y_1);
    // Q3.17: rounded down
    wire [20:0] dd1_y_1 = dd1_y_exact_1[35:15];
    // Q3.32: |n - h|^2
    wire [35:0] dd1_z_exact_1 = $signed(d1_z_1) * $signed(d1_z_1);
    // Q3.17: rounded down
    wire [20:0] dd1_z_1 = dd1_z_exact_1[35:15];
    reg [17:0] in_gain1r_2;
    reg [17:0] in_gain1g_2;
    reg [17:0] in_gain1b_2;
    reg hidden_2;
    reg [3:0] shift1_2;
    reg [26:0] nl1_z_2;
    reg [27:0] nl1_xy_2;
    reg [20:0] dd1_x_2;
    reg [20:0] dd1_y_2;
    reg [20:0] dd1_z_2;
    reg [3:0] texels1_00_2;
    reg [3:0] texels1_01_2;
    reg [3:0] texels1_10_2;
    reg [3:0] texels1_11_2;
    reg [6:0] blend1_signed_2;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_2 <= in_gain1r_1;
            in_gain1g_2 <= in_gain1g_1;
            in_gain1b_2 <= in_gain1b_1;
            hidden_2 <= hidden_1;
            shift1_2 <= shift1_1;
            nl1_z_2 <= nl1_z_1;
            nl1_xy_2 <= nl1_xy_1;
            dd1_x_2 <= dd1_x_1;
            dd1_y_2 <= dd1_y_1;
            dd1_z_2 <= dd1_z_1;
            texels1_00_2 <= texels1_00_1;
            texels1_01_2 <= texels1_01_1;
            texels1_10_2 <= texels1_10_1;
            texels1_11_2 <= texels1_11_1;
            blend1_signed_2 <= blend1_signed_1;
        end
    end

    // ===== Stage 2: nl1_xyz, nl1_kept, dd1_xy
    // Q4.23: n.l
    wire [27:0] nl1_xyz_2 = nl1_xy_2 + {{1{nl1_z_2[26]}}, nl1_z_2};
    // Q4.21: rounded down
    wire [25:0] nl1_cut_2 = nl1_xyz_2[27:2];
    // UQ0.21: n.l, kept in [0, 1)
    wire [20:0] nl1_kept_2 =
        nl1_cut_2[25] ? 21'h000000 : (nl1_cut_2 > 26'h01fffff) ? 21'h1fffff : nl1_cut_2[20:0];
    // Q4.17: |n - h|^2
    wire [21:0] dd1_xy_2 = {{1{dd1_x_2[20]}}, dd1_x_2} + {{1{dd1_y_2[20]}}, dd1_y_2};
    reg [17:0] in_gain1r_3;
    reg [17:0] in_gain1g_3;
    reg [17:0] in_gain1b_3;
    reg hidden_3;
    reg [3:0] shift1_3;
    reg [20:0] nl1_kept_3;
    reg [20:0] dd1_z_3;
    reg [21:0] dd1_xy_3;
    reg [3:0] texels1_00_3;
    reg [3:0] texels1_01_3;
    reg [3:0] texels1_10_3;
    reg [3:0] texels1_11_3;
    reg [6:0] blend1_signed_3;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_3 <= in_gain1r_2;
            in_gain1g_3 <= in_gain1g_2;
            in_gain1b_3 <= in_gain1b_2;
            hidden_3 <= hidden_2;
            shift1_3 <= shift1_2;
            nl1_kept_3 <= nl1_kept_2;
            dd1_z_3 <= dd1_z_2;
            dd1_xy_3 <= dd1_xy_2;
            texels1_00_3 <= texels1_00_2;
            texels1_01_3 <= texels1_01_2;
            texels1_10_3 <= texels1_10_2;
            texels1_11_3 <= texels1_11_2;
            blend1_signed_3 <= blend1_signed_2;
        end
    end

    // ===== Stage 3: nl1_up, nl1_within, nl1, dd1_xyz, u1
    // UQ10.21: times 2^shift
    wire [30:0] nl1_up_3 = {10'd0, nl1_kept_3} << shift1_3;
    // UQ10.11: rounded down
    wire [20:0] nl1_up_cut_3 = nl1_up_3[30:10];
    // UQ8.11: kept in its format
    wire [18:0] nl1_within_3 = (nl1_up_cut_3 > 21'h07ffff) ? 19'h7ffff : nl1_up_cut_3[18:0];
    // UQ8.11: n.l, 0 for a normal that is turned away
    wire [18:0] nl1_3 = hidden_3 ? 19'd0 : nl1_within_3;
    // Q4.17: |n - h|^2
    wire [21:0] dd1_xyz_3 = dd1_xy_3 + {{1{dd1_z_3[20]}}, dd1_z_3};
    // Q3.18: |n - h|^2 / 2
    wire [21:0] u1_exact_3 = dd1_xyz_3;
    // Q3.14: rounded down
    wire [17:0] u1_cut_3 = u1_exact_3[21:4];
    // UQ0.14: the versine u = |n - h|^2 / 2, at most the last column's
    wire [13:0] u1_3 = u1_cut_3[17] ? 14'h0000 : (u1_cut_3 > 18'h03800) ? 14'h3800 : u1_cut_3[13:0];
    // UQ0.4: the first 4 bits of u
    wire [3:0] high1_4_bits_3 = u1_3[13:10];
    // UQ-4.14: without them
    wire [9:0] u_low1_4_3 = u1_3[9:0];
    // UQ0.10: u 2^4
    wire [9:0] u_up1_4_3 = u_low1_4_3;
    // UQ0.14: in the wider of two formats
    wire [13:0] u_up1_4_wide_3 = {u_up1_4_3, 4'd0};
    reg [17:0] in_gain1r_4;
    reg [17:0] in_gain1g_4;
    reg [17:0] in_gain1b_4;
    reg [18:0] nl1_4;
    reg [13:0] u1_4;
    reg [3:0] high1_4_bits_4;
    reg [13:0] u_up1_4_wide_4;
    reg [3:0] texels1_00_4;
    reg [3:0] texels1_01_4;
    reg [3:0] texels1_10_4;
    reg [3:0] texels1_11_4;
    reg [6:0] blend1_signed_4;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_4 <= in_gain1r_3;
            in_gain1g_4 <= in_gain1g_3;
            in_gain1b_4 <= in_gain1b_3;
            nl1_4 <= nl1_3;
            u1_4 <= u1_3;
            high1_4_bits_4 <= high1_4_bits_3;
            u_up1_4_wide_4 <= u_up1_4_wide_3;
            texels1_00_4 <= texels1_00_3;
            texels1_01_4 <= texels1_01_3;
            texels1_10_4 <= texels1_10_3;
            texels1_11_4 <= texels1_11_3;
            blend1_signed_4 <= blend1_signed_3;
        end
    end

    // ===== Stage 4: u1_4, u1_2, u1_1, rest1
    // UQ1.0: the first 4 bits of u
    wire high1_4_4 = |high1_4_bits_4;
    // UQ0.14: u, times 2^4 if it is so small
    wire [13:0] u1_4_4 = high1_4_4 ? u1_4 : u_up1_4_wide_4;
    // UQ3.-2: a bit of the exponent
    wire place1_4_4 = high1_4_4;
    // UQ0.2: the first 2 bits of u
    wire [1:0] high1_2_bits_4 = u1_4_4[13:12];
    // UQ1.0: the first 2 bits of u
    wire high1_2_4 = |high1_2_bits_4;
    // UQ-2.14: without them
    wire [11:0] u_low1_2_4 = u1_4_4[11:0];
    // UQ0.12: u 2^2
    wire [11:0] u_up1_2_4 = u_low1_2_4;
    // UQ0.14: in the wider of two formats
    wire [13:0] u_up1_2_wide_4 = {u_up1_2_4, 2'd0};
    // UQ0.14: u, times 2^2 if it is so small
    wire [13:0] u1_2_4 = high1_2_4 ? u1_4_4 : u_up1_2_wide_4;
    // UQ2.-1: a bit of the exponent
    wire place1_2_4 = high1_2_4;
    // UQ0.1: the first 1 bits of u
    wire high1_1_bits_4 = u1_2_4[13];
    // UQ-1.14: without them
    wire [12:0] u_low1_1_4 = u1_2_4[12:0];
    // UQ0.13: u 2^1
    wire [12:0] u_up1_1_4 = u_low1_1_4;
    // UQ0.14: in the wider of two formats
    wire [13:0] u_up1_1_wide_4 = {u_up1_1_4, 1'd0};
    // UQ0.14: u, times 2^1 if it is so small
    wire [13:0] u1_1_4 = high1_1_bits_4 ? u1_2_4 : u_up1_1_wide_4;
    // UQ1.0: a bit of the exponent
    wire place1_1_4 = high1_1_bits_4;
    // UQ1.0: the exponent is not 0
    wire normal1_of_2_4 = high1_4_4 | high1_2_4;
    // UQ1.0: the exponent is not 0
    wire normal1_4 = normal1_of_2_4 | high1_1_bits_4;
    // UQ1.13: 2 u
    wire [13:0] u1_twice_4 = u1_1_4;
    // UQ0.13: 2 u - 1
    wire [12:0] u1_rest_4 = u1_twice_4[12:0];
    // UQ0.14: in the wider of two formats
    wire [13:0] u1_rest_wide_4 = {u1_rest_4, 1'd0};
    // UQ0.14: the place in the octave
    wire [13:0] rest1_4 = normal1_4 ? u1_rest_wide_4 : u1_1_4;
    // UQ0.7: rounded down to the weights' last bit
    wire [6:0] rest1_cut_4 = rest1_4[13:7];
    // UQ0.2: the column in the octave
    wire [1:0] step1_4 = rest1_cut_4[6:5];
    // UQ2.0: its number
    wire [1:0] step1_number_4 = step1_4;
    // UQ-2.7: u past it
    wire [4:0] part1_4 = rest1_cut_4[4:0];
    // UQ0.5: the weight of the next column
    wire [4:0] weight1_4 = part1_4;
    // UQ1.5: in the wider of two formats
    wire [5:0] weight1_wide_4 = {1'd0, weight1_4};
    reg [17:0] in_gain1r_5;
    reg [17:0] in_gain1g_5;
    reg [17:0] in_gain1b_5;
    reg [18:0] nl1_5;
    reg place1_4_5;
    reg place1_2_5;
    reg place1_1_5;
    reg [1:0] step1_number_5;
    reg [4:0] weight1_5;
    reg [5:0] weight1_wide_5;
    reg [3:0] texels1_00_5;
    reg [3:0] texels1_01_5;
    reg [3:0] texels1_10_5;
    reg [3:0] texels1_11_5;
    reg [6:0] blend1_signed_5;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_5 <= in_gain1r_4;
            in_gain1g_5 <= in_gain1g_4;
            in_gain1b_5 <= in_gain1b_4;
            nl1_5 <= nl1_4;
            place1_4_5 <= place1_4_4;
            place1_2_5 <= place1_2_4;
            place1_1_5 <= place1_1_4;
            step1_number_5 <= step1_number_4;
            weight1_5 <= weight1_4;
            weight1_wide_5 <= weight1_wide_4;
            texels1_00_5 <= texels1_00_4;
            texels1_01_5 <= texels1_01_4;
            texels1_10_5 <= texels1_10_4;
            texels1_11_5 <= texels1_11_4;
            blend1_signed_5 <= blend1_signed_4;
        end
    end

    // ===== Stage 5: exponent1_2, column1_other
    // UQ3.-1: the exponent's bits so far
    wire [1:0] exponent1_2_5 = {place1_4_5, 1'd0} + {1'd0, place1_2_5};
    // UQ1.5: the weight of the place itself
    wire [5:0] column1_other_5 = 6'h20 - {1'd0, weight1_5};
    reg [17:0] in_gain1r_6;
    reg [17:0] in_gain1g_6;
    reg [17:0] in_gain1b_6;
    reg [18:0] nl1_6;
    reg [1:0] exponent1_2_6;
    reg place1_1_6;
    reg [1:0] step1_number_6;
    reg [5:0] column1_other_6;
    reg [5:0] weight1_wide_6;
    reg [3:0] texels1_00_6;
    reg [3:0] texels1_01_6;
    reg [3:0] texels1_10_6;
    reg [3:0] texels1_11_6;
    reg [6:0] blend1_signed_6;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_6 <= in_gain1r_5;
            in_gain1g_6 <= in_gain1g_5;
            in_gain1b_6 <= in_gain1b_5;
            nl1_6 <= nl1_5;
            exponent1_2_6 <= exponent1_2_5;
            place1_1_6 <= place1_1_5;
            step1_number_6 <= step1_number_5;
            column1_other_6 <= column1_other_5;
            weight1_wide_6 <= weight1_wide_5;
            texels1_00_6 <= texels1_00_5;
            texels1_01_6 <= texels1_01_5;
            texels1_10_6 <= texels1_10_5;
            texels1_11_6 <= texels1_11_5;
            blend1_signed_6 <= blend1_signed_5;
        end
    end

    // ===== Stage 6: exponent1_1
    // UQ3.0: the exponent's bits so far
    wire [2:0] exponent1_1_6 = {exponent1_2_6, 1'd0} + {2'd0, place1_1_6};
    // UQ5.-2: the octave's first column
    wire [2:0] octave1_6 = exponent1_1_6;
    reg [17:0] in_gain1r_7;
    reg [17:0] in_gain1g_7;
    reg [17:0] in_gain1b_7;
    reg [18:0] nl1_7;
    reg [1:0] step1_number_7;
    reg [2:0] octave1_7;
    reg [5:0] column1_other_7;
    reg [5:0] weight1_wide_7;
    reg [3:0] texels1_00_7;
    reg [3:0] texels1_01_7;
    reg [3:0] texels1_10_7;
    reg [3:0] texels1_11_7;
    reg [6:0] blend1_signed_7;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_7 <= in_gain1r_6;
            in_gain1g_7 <= in_gain1g_6;
            in_gain1b_7 <= in_gain1b_6;
            nl1_7 <= nl1_6;
            step1_number_7 <= step1_number_6;
            octave1_7 <= octave1_6;
            column1_other_7 <= column1_other_6;
            weight1_wide_7 <= weight1_wide_6;
            texels1_00_7 <= texels1_00_6;
            texels1_01_7 <= texels1_01_6;
            texels1_10_7 <= texels1_10_6;
            texels1_11_7 <= texels1_11_6;
            blend1_signed_7 <= blend1_signed_6;
        end
    end

    // ===== Stage 7: column1, column1_odd
    // UQ5.0: the column at or below u
    wire [4:0] column1_7 = {octave1_7, 2'd0} + {3'd0, step1_number_7};
    // UQ5.-1: its leading bits
    wire [3:0] column1_odd_high_7 = column1_7[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] column1_odd_7 = column1_odd_high_7;
    // UQ1.0: its last bit
    wire column1_is_odd_7 = column1_7[0];
    // UQ1.5: the weight of the odd one
    wire [5:0] column1_odd_v2_7 = column1_is_odd_7 ? column1_other_7 : weight1_wide_7;
    // Q1.5: a sign bit for the signed product
    wire [6:0] column1_odd_signed_7 = {1'd0, column1_odd_v2_7};
    reg [17:0] in_gain1r_8;
    reg [17:0] in_gain1g_8;
    reg [17:0] in_gain1b_8;
    reg [18:0] nl1_8;
    reg [4:0] column1_8;
    reg [3:0] column1_odd_8;
    reg [3:0] texels1_00_8;
    reg [3:0] texels1_01_8;
    reg [3:0] texels1_10_8;
    reg [3:0] texels1_11_8;
    reg [6:0] column1_odd_signed_8;
    reg [6:0] blend1_signed_8;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_8 <= in_gain1r_7;
            in_gain1g_8 <= in_gain1g_7;
            in_gain1b_8 <= in_gain1b_7;
            nl1_8 <= nl1_7;
            column1_8 <= column1_7;
            column1_odd_8 <= column1_odd_7;
            texels1_00_8 <= texels1_00_7;
            texels1_01_8 <= texels1_01_7;
            texels1_10_8 <= texels1_10_7;
            texels1_11_8 <= texels1_11_7;
            column1_odd_signed_8 <= column1_odd_signed_7;
            blend1_signed_8 <= blend1_signed_7;
        end
    end

    // ===== Stage 8: column1_next_exact, column1_next, texel1_01, texel1_11
    // UQ6.0: the next
    wire [5:0] column1_next_exact_8 = {1'd0, column1_8} + 6'h01;
    // UQ5.0: at most the last
    wire [4:0] column1_next_8 = (column1_next_exact_8 > 6'h1f) ? 5'h1f : column1_next_exact_8[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] column1_even_high_8 = column1_next_8[4:1];
    // UQ4.0: the even one of both
    wire [3:0] column1_even_8 = column1_even_high_8;
    // UQ8.0: side by side
    wire [7:0] texel1_01_8 = {texels1_01_8, 4'd0} + {4'd0, column1_odd_8};
    // UQ8.0: side by side
    wire [7:0] texel1_11_8 = {texels1_11_8, 4'd0} + {4'd0, column1_odd_8};
    reg [17:0] in_gain1r_9;
    reg [17:0] in_gain1g_9;
    reg [17:0] in_gain1b_9;
    reg [18:0] nl1_9;
    reg [3:0] column1_even_9;
    reg [3:0] texels1_00_9;
    reg [7:0] texel1_01_9;
    reg [3:0] texels1_10_9;
    reg [7:0] texel1_11_9;
    reg [6:0] column1_odd_signed_9;
    reg [6:0] blend1_signed_9;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_9 <= in_gain1r_8;
            in_gain1g_9 <= in_gain1g_8;
            in_gain1b_9 <= in_gain1b_8;
            nl1_9 <= nl1_8;
            column1_even_9 <= column1_even_8;
            texels1_00_9 <= texels1_00_8;
            texel1_01_9 <= texel1_01_8;
            texels1_10_9 <= texels1_10_8;
            texel1_11_9 <= texel1_11_8;
            column1_odd_signed_9 <= column1_odd_signed_8;
            blend1_signed_9 <= blend1_signed_8;
        end
    end

    // ===== Stage 9: texel1_00, texel1_10
    // UQ8.0: side by side
    wire [7:0] texel1_00_9 = {texels1_00_9, 4'd0} + {4'd0, column1_even_9};
    // UQ8.0: side by side
    wire [7:0] texel1_10_9 = {texels1_10_9, 4'd0} + {4'd0, column1_even_9};
    reg [17:0] in_gain1r_10;
    reg [17:0] in_gain1g_10;
    reg [17:0] in_gain1b_10;
    reg [18:0] nl1_10;
    reg [7:0] texel1_00_10;
    reg [7:0] texel1_01_10;
    reg [7:0] texel1_10_10;
    reg [7:0] texel1_11_10;
    reg [6:0] column1_odd_signed_10;
    reg [6:0] blend1_signed_10;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_10 <= in_gain1r_9;
            in_gain1g_10 <= in_gain1g_9;
            in_gain1b_10 <= in_gain1b_9;
            nl1_10 <= nl1_9;
            texel1_00_10 <= texel1_00_9;
            texel1_01_10 <= texel1_01_9;
            texel1_10_10 <= texel1_10_9;
            texel1_11_10 <= texel1_11_9;
            column1_odd_signed_10 <= column1_odd_signed_9;
            blend1_signed_10 <= blend1_signed_9;
        end
    end

    // ===== Stage 10: read texels_1_even_even, read texels_1_even_odd and 2 more
    // The word of the memory texels_1_even_even, of 256 words.
    reg [23:0] texels_1_even_even_11;
    // The word of the memory texels_1_even_odd, of 256 words.
    reg [23:0] texels_1_even_odd_11;
    // The word of the memory texels_1_odd_even, of 256 words.
    reg [23:0] texels_1_odd_even_11;
    // The word of the memory texels_1_odd_odd, of 256 words.
    reg [23:0] texels_1_odd_odd_11;
    reg [23:0] texels_1_even_even [0:255];
    initial $readmemh(TEXELS_1_EVEN_EVEN_FILE, texels_1_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_11 <= texels_1_even_even[texel1_00_10];
    end
    reg [23:0] texels_1_even_odd [0:255];
    initial $readmemh(TEXELS_1_EVEN_ODD_FILE, texels_1_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_11 <= texels_1_even_odd[texel1_01_10];
    end
    reg [23:0] texels_1_odd_even [0:255];
    initial $readmemh(TEXELS_1_ODD_EVEN_FILE, texels_1_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_11 <= texels_1_odd_even[texel1_10_10];
    end
    reg [23:0] texels_1_odd_odd [0:255];
    initial $readmemh(TEXELS_1_ODD_ODD_FILE, texels_1_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_11 <= texels_1_odd_odd[texel1_11_10];
    end
    reg [17:0] in_gain1r_11;
    reg [17:0] in_gain1g_11;
    reg [17:0] in_gain1b_11;
    reg [18:0] nl1_11;
    reg [6:0] column1_odd_signed_11;
    reg [6:0] blend1_signed_11;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_11 <= in_gain1r_10;
            in_gain1g_11 <= in_gain1g_10;
            in_gain1b_11 <= in_gain1b_10;
            nl1_11 <= nl1_10;
            column1_odd_signed_11 <= column1_odd_signed_10;
            blend1_signed_11 <= blend1_signed_10;
        end
    end

    // ===== Stage 11: registers only
    // UQ0.8: red
    wire [7:0] texels_1_even_even_r_11 = texels_1_even_even_11[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_r_11 = texels_1_even_odd_11[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_r_11 = texels_1_odd_even_11[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_r_11 = texels_1_odd_odd_11[23:16];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_g_11 = texels_1_even_even_11[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_g_11 = texels_1_even_odd_11[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_g_11 = texels_1_odd_even_11[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_g_11 = texels_1_odd_odd_11[15:8];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_b_11 = texels_1_even_even_11[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_b_11 = texels_1_even_odd_11[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_b_11 = texels_1_odd_even_11[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_b_11 = texels_1_odd_odd_11[7:0];
    reg [17:0] in_gain1r_12;
    reg [17:0] in_gain1g_12;
    reg [17:0] in_gain1b_12;
    reg [18:0] nl1_12;
    reg [7:0] texels_1_even_even_r_12;
    reg [7:0] texels_1_even_odd_r_12;
    reg [7:0] texels_1_odd_even_r_12;
    reg [7:0] texels_1_odd_odd_r_12;
    reg [6:0] column1_odd_signed_12;
    reg [6:0] blend1_signed_12;
    reg [7:0] texels_1_even_even_g_12;
    reg [7:0] texels_1_even_odd_g_12;
    reg [7:0] texels_1_odd_even_g_12;
    reg [7:0] texels_1_odd_odd_g_12;
    reg [7:0] texels_1_even_even_b_12;
    reg [7:0] texels_1_even_odd_b_12;
    reg [7:0] texels_1_odd_even_b_12;
    reg [7:0] texels_1_odd_odd_b_12;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_12 <= in_gain1r_11;
            in_gain1g_12 <= in_gain1g_11;
            in_gain1b_12 <= in_gain1b_11;
            nl1_12 <= nl1_11;
            texels_1_even_even_r_12 <= texels_1_even_even_r_11;
            texels_1_even_odd_r_12 <= texels_1_even_odd_r_11;
            texels_1_odd_even_r_12 <= texels_1_odd_even_r_11;
            texels_1_odd_odd_r_12 <= texels_1_odd_odd_r_11;
            column1_odd_signed_12 <= column1_odd_signed_11;
            blend1_signed_12 <= blend1_signed_11;
            texels_1_even_even_g_12 <= texels_1_even_even_g_11;
            texels_1_even_odd_g_12 <= texels_1_even_odd_g_11;
            texels_1_odd_even_g_12 <= texels_1_odd_even_g_11;
            texels_1_odd_odd_g_12 <= texels_1_odd_odd_g_11;
            texels_1_even_even_b_12 <= texels_1_even_even_b_11;
            texels_1_even_odd_b_12 <= texels_1_even_odd_b_11;
            texels_1_odd_even_b_12 <= texels_1_odd_even_b_11;
            texels_1_odd_odd_b_12 <= texels_1_odd_odd_b_11;
        end
    end

    // ===== Stage 12: registers only
    reg [17:0] in_gain1r_13;
    reg [17:0] in_gain1g_13;
    reg [17:0] in_gain1b_13;
    reg [18:0] nl1_13;
    reg [7:0] texels_1_even_even_r_13;
    reg [7:0] texels_1_even_odd_r_13;
    reg [7:0] texels_1_odd_even_r_13;
    reg [7:0] texels_1_odd_odd_r_13;
    reg [6:0] column1_odd_signed_13;
    reg [6:0] blend1_signed_13;
    reg [7:0] texels_1_even_even_g_13;
    reg [7:0] texels_1_even_odd_g_13;
    reg [7:0] texels_1_odd_even_g_13;
    reg [7:0] texels_1_odd_odd_g_13;
    reg [7:0] texels_1_even_even_b_13;
    reg [7:0] texels_1_even_odd_b_13;
    reg [7:0] texels_1_odd_even_b_13;
    reg [7:0] texels_1_odd_odd_b_13;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_13 <= in_gain1r_12;
            in_gain1g_13 <= in_gain1g_12;
            in_gain1b_13 <= in_gain1b_12;
            nl1_13 <= nl1_12;
            texels_1_even_even_r_13 <= texels_1_even_even_r_12;
            texels_1_even_odd_r_13 <= texels_1_even_odd_r_12;
            texels_1_odd_even_r_13 <= texels_1_odd_even_r_12;
            texels_1_odd_odd_r_13 <= texels_1_odd_odd_r_12;
            column1_odd_signed_13 <= column1_odd_signed_12;
            blend1_signed_13 <= blend1_signed_12;
            texels_1_even_even_g_13 <= texels_1_even_even_g_12;
            texels_1_even_odd_g_13 <= texels_1_even_odd_g_12;
            texels_1_odd_even_g_13 <= texels_1_odd_even_g_12;
            texels_1_odd_odd_g_13 <= texels_1_odd_odd_g_12;
            texels_1_even_even_b_13 <= texels_1_even_even_b_12;
            texels_1_even_odd_b_13 <= texels_1_even_odd_b_12;
            texels_1_odd_even_b_13 <= texels_1_odd_even_b_12;
            texels_1_odd_odd_b_13 <= texels_1_odd_odd_b_12;
        end
    end

    // ===== Stage 13: blend1_r_1_0_apart, blend1_r_1_1_apart, blend1_g_1_0_apart and 3 more
    // Q0.8: the difference
    wire [8:0] blend1_r_1_0_apart_13 =
        {1'd0, texels_1_even_odd_r_13} - {1'd0, texels_1_even_even_r_13};
    // Q0.8: the difference
    wire [8:0] blend1_r_1_1_apart_13 =
        {1'd0, texels_1_odd_odd_r_13} - {1'd0, texels_1_odd_even_r_13};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_0_apart_13 =
        {1'd0, texels_1_even_odd_g_13} - {1'd0, texels_1_even_even_g_13};
    // Q0.8: the difference
    wire [8:0] blend1_g_1_1_apart_13 =
        {1'd0, texels_1_odd_odd_g_13} - {1'd0, texels_1_odd_even_g_13};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_0_apart_13 =
        {1'd0, texels_1_even_odd_b_13} - {1'd0, texels_1_even_even_b_13};
    // Q0.8: the difference
    wire [8:0] blend1_b_1_1_apart_13 =
        {1'd0, texels_1_odd_odd_b_13} - {1'd0, texels_1_odd_even_b_13};
    reg [17:0] in_gain1r_14;
    reg [17:0] in_gain1g_14;
    reg [17:0] in_gain1b_14;
    reg [18:0] nl1_14;
    reg [7:0] texels_1_even_even_r_14;
    reg [7:0] texels_1_odd_even_r_14;
    reg [8:0] blend1_r_1_0_apart_14;
    reg [6:0] column1_odd_signed_14;
    reg [8:0] blend1_r_1_1_apart_14;
    reg [6:0] blend1_signed_14;
    reg [7:0] texels_1_even_even_g_14;
    reg [7:0] texels_1_odd_even_g_14;
    reg [8:0] blend1_g_1_0_apart_14;
    reg [8:0] blend1_g_1_1_apart_14;
    reg [7:0] texels_1_even_even_b_14;
    reg [7:0] texels_1_odd_even_b_14;
    reg [8:0] blend1_b_1_0_apart_14;
    reg [8:0] blend1_b_1_1_apart_14;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_14 <= in_gain1r_13;
            in_gain1g_14 <= in_gain1g_13;
            in_gain1b_14 <= in_gain1b_13;
            nl1_14 <= nl1_13;
            texels_1_even_even_r_14 <= texels_1_even_even_r_13;
            texels_1_odd_even_r_14 <= texels_1_odd_even_r_13;
            blend1_r_1_0_apart_14 <= blend1_r_1_0_apart_13;
            column1_odd_signed_14 <= column1_odd_signed_13;
            blend1_r_1_1_apart_14 <= blend1_r_1_1_apart_13;
            blend1_signed_14 <= blend1_signed_13;
            texels_1_even_even_g_14 <= texels_1_even_even_g_13;
            texels_1_odd_even_g_14 <= texels_1_odd_even_g_13;
            blend1_g_1_0_apart_14 <= blend1_g_1_0_apart_13;
            blend1_g_1_1_apart_14 <= blend1_g_1_1_apart_13;
            texels_1_even_even_b_14 <= texels_1_even_even_b_13;
            texels_1_odd_even_b_14 <= texels_1_odd_even_b_13;
            blend1_b_1_0_apart_14 <= blend1_b_1_0_apart_13;
            blend1_b_1_1_apart_14 <= blend1_b_1_1_apart_13;
        end
    end

    // ===== Stage 14: blend1_r_1_0_part, blend1_r_1_1_part, blend1_g_1_0_part and 3 more
    // Q2.13: its part
    wire [15:0] blend1_r_1_0_part_14 =
        $signed(blend1_r_1_0_apart_14) * $signed(column1_odd_signed_14);
    // Q2.13: its part
    wire [15:0] blend1_r_1_1_part_14 =
        $signed(blend1_r_1_1_apart_14) * $signed(column1_odd_signed_14);
    // Q2.13: its part
    wire [15:0] blend1_g_1_0_part_14 =
        $signed(blend1_g_1_0_apart_14) * $signed(column1_odd_signed_14);
    // Q2.13: its part
    wire [15:0] blend1_g_1_1_part_14 =
        $signed(blend1_g_1_1_apart_14) * $signed(column1_odd_signed_14);
    // Q2.13: its part
    wire [15:0] blend1_b_1_0_part_14 =
        $signed(blend1_b_1_0_apart_14) * $signed(column1_odd_signed_14);
    // Q2.13: its part
    wire [15:0] blend1_b_1_1_part_14 =
        $signed(blend1_b_1_1_apart_14) * $signed(column1_odd_signed_14);
    reg [17:0] in_gain1r_15;
    reg [17:0] in_gain1g_15;
    reg [17:0] in_gain1b_15;
    reg [18:0] nl1_15;
    reg [7:0] texels_1_even_even_r_15;
    reg [7:0] texels_1_odd_even_r_15;
    reg [15:0] blend1_r_1_0_part_15;
    reg [15:0] blend1_r_1_1_part_15;
    reg [6:0] blend1_signed_15;
    reg [7:0] texels_1_even_even_g_15;
    reg [7:0] texels_1_odd_even_g_15;
    reg [15:0] blend1_g_1_0_part_15;
    reg [15:0] blend1_g_1_1_part_15;
    reg [7:0] texels_1_even_even_b_15;
    reg [7:0] texels_1_odd_even_b_15;
    reg [15:0] blend1_b_1_0_part_15;
    reg [15:0] blend1_b_1_1_part_15;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_15 <= in_gain1r_14;
            in_gain1g_15 <= in_gain1g_14;
            in_gain1b_15 <= in_gain1b_14;
            nl1_15 <= nl1_14;
            texels_1_even_even_r_15 <= texels_1_even_even_r_14;
            texels_1_odd_even_r_15 <= texels_1_odd_even_r_14;
            blend1_r_1_0_part_15 <= blend1_r_1_0_part_14;
            blend1_r_1_1_part_15 <= blend1_r_1_1_part_14;
            blend1_signed_15 <= blend1_signed_14;
            texels_1_even_even_g_15 <= texels_1_even_even_g_14;
            texels_1_odd_even_g_15 <= texels_1_odd_even_g_14;
            blend1_g_1_0_part_15 <= blend1_g_1_0_part_14;
            blend1_g_1_1_part_15 <= blend1_g_1_1_part_14;
            texels_1_even_even_b_15 <= texels_1_even_even_b_14;
            texels_1_odd_even_b_15 <= texels_1_odd_even_b_14;
            blend1_b_1_0_part_15 <= blend1_b_1_0_part_14;
            blend1_b_1_1_part_15 <= blend1_b_1_1_part_14;
        end
    end

    // ===== Stage 15: blend1_r_1_0, blend1_r_1_1, blend1_g_1_0, blend1_g_1_1 and 2 more
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_0_15 = {texels_1_even_even_r_15, 5'd0} + blend1_r_1_0_part_15[12:0];
    // UQ0.13: two neighbours
    wire [12:0] blend1_r_1_1_15 = {texels_1_odd_even_r_15, 5'd0} + blend1_r_1_1_part_15[12:0];
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_0_15 = {texels_1_even_even_g_15, 5'd0} + blend1_g_1_0_part_15[12:0];
    // UQ0.13: two neighbours
    wire [12:0] blend1_g_1_1_15 = {texels_1_odd_even_g_15, 5'd0} + blend1_g_1_1_part_15[12:0];
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_0_15 = {texels_1_even_even_b_15, 5'd0} + blend1_b_1_0_part_15[12:0];
    // UQ0.13: two neighbours
    wire [12:0] blend1_b_1_1_15 = {texels_1_odd_even_b_15, 5'd0} + blend1_b_1_1_part_15[12:0];
    reg [17:0] in_gain1r_16;
    reg [17:0] in_gain1g_16;
    reg [17:0] in_gain1b_16;
    reg [18:0] nl1_16;
    reg [12:0] blend1_r_1_0_16;
    reg [12:0] blend1_r_1_1_16;
    reg [6:0] blend1_signed_16;
    reg [12:0] blend1_g_1_0_16;
    reg [12:0] blend1_g_1_1_16;
    reg [12:0] blend1_b_1_0_16;
    reg [12:0] blend1_b_1_1_16;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_16 <= in_gain1r_15;
            in_gain1g_16 <= in_gain1g_15;
            in_gain1b_16 <= in_gain1b_15;
            nl1_16 <= nl1_15;
            blend1_r_1_0_16 <= blend1_r_1_0_15;
            blend1_r_1_1_16 <= blend1_r_1_1_15;
            blend1_signed_16 <= blend1_signed_15;
            blend1_g_1_0_16 <= blend1_g_1_0_15;
            blend1_g_1_1_16 <= blend1_g_1_1_15;
            blend1_b_1_0_16 <= blend1_b_1_0_15;
            blend1_b_1_1_16 <= blend1_b_1_1_15;
        end
    end

    // ===== Stage 16: blend1_r_2_0_apart, blend1_g_2_0_apart, blend1_b_2_0_apart
    // Q0.13: the difference
    wire [13:0] blend1_r_2_0_apart_16 = {1'd0, blend1_r_1_1_16} - {1'd0, blend1_r_1_0_16};
    // Q0.13: the difference
    wire [13:0] blend1_g_2_0_apart_16 = {1'd0, blend1_g_1_1_16} - {1'd0, blend1_g_1_0_16};
    // Q0.13: the difference
    wire [13:0] blend1_b_2_0_apart_16 = {1'd0, blend1_b_1_1_16} - {1'd0, blend1_b_1_0_16};
    reg [17:0] in_gain1r_17;
    reg [17:0] in_gain1g_17;
    reg [17:0] in_gain1b_17;
    reg [18:0] nl1_17;
    reg [12:0] blend1_r_1_0_17;
    reg [13:0] blend1_r_2_0_apart_17;
    reg [6:0] blend1_signed_17;
    reg [12:0] blend1_g_1_0_17;
    reg [13:0] blend1_g_2_0_apart_17;
    reg [12:0] blend1_b_1_0_17;
    reg [13:0] blend1_b_2_0_apart_17;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_17 <= in_gain1r_16;
            in_gain1g_17 <= in_gain1g_16;
            in_gain1b_17 <= in_gain1b_16;
            nl1_17 <= nl1_16;
            blend1_r_1_0_17 <= blend1_r_1_0_16;
            blend1_r_2_0_apart_17 <= blend1_r_2_0_apart_16;
            blend1_signed_17 <= blend1_signed_16;
            blend1_g_1_0_17 <= blend1_g_1_0_16;
            blend1_g_2_0_apart_17 <= blend1_g_2_0_apart_16;
            blend1_b_1_0_17 <= blend1_b_1_0_16;
            blend1_b_2_0_apart_17 <= blend1_b_2_0_apart_16;
        end
    end

    // ===== Stage 17: blend1_r_2_0_part, blend1_g_2_0_part, blend1_b_2_0_part
    // Q2.18: its part
    wire [20:0] blend1_r_2_0_part_17 = $signed(blend1_r_2_0_apart_17) * $signed(blend1_signed_17);
    // Q2.18: its part
    wire [20:0] blend1_g_2_0_part_17 = $signed(blend1_g_2_0_apart_17) * $signed(blend1_signed_17);
    // Q2.18: its part
    wire [20:0] blend1_b_2_0_part_17 = $signed(blend1_b_2_0_apart_17) * $signed(blend1_signed_17);
    reg [17:0] in_gain1r_18;
    reg [17:0] in_gain1g_18;
    reg [17:0] in_gain1b_18;
    reg [18:0] nl1_18;
    reg [12:0] blend1_r_1_0_18;
    reg [20:0] blend1_r_2_0_part_18;
    reg [12:0] blend1_g_1_0_18;
    reg [20:0] blend1_g_2_0_part_18;
    reg [12:0] blend1_b_1_0_18;
    reg [20:0] blend1_b_2_0_part_18;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_18 <= in_gain1r_17;
            in_gain1g_18 <= in_gain1g_17;
            in_gain1b_18 <= in_gain1b_17;
            nl1_18 <= nl1_17;
            blend1_r_1_0_18 <= blend1_r_1_0_17;
            blend1_r_2_0_part_18 <= blend1_r_2_0_part_17;
            blend1_g_1_0_18 <= blend1_g_1_0_17;
            blend1_g_2_0_part_18 <= blend1_g_2_0_part_17;
            blend1_b_1_0_18 <= blend1_b_1_0_17;
            blend1_b_2_0_part_18 <= blend1_b_2_0_part_17;
        end
    end

    // ===== Stage 18: blend1_r_2_0, blend1_g_2_0, blend1_b_2_0
    // UQ0.18: two bands
    wire [17:0] blend1_r_2_0_18 = {blend1_r_1_0_18, 5'd0} + blend1_r_2_0_part_18[17:0];
    // UQ0.18: two bands
    wire [17:0] blend1_g_2_0_18 = {blend1_g_1_0_18, 5'd0} + blend1_g_2_0_part_18[17:0];
    // UQ0.18: two bands
    wire [17:0] blend1_b_2_0_18 = {blend1_b_1_0_18, 5'd0} + blend1_b_2_0_part_18[17:0];
    reg [17:0] in_gain1r_19;
    reg [17:0] in_gain1g_19;
    reg [17:0] in_gain1b_19;
    reg [18:0] nl1_19;
    reg [17:0] blend1_r_2_0_19;
    reg [17:0] blend1_g_2_0_19;
    reg [17:0] blend1_b_2_0_19;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_19 <= in_gain1r_18;
            in_gain1g_19 <= in_gain1g_18;
            in_gain1b_19 <= in_gain1b_18;
            nl1_19 <= nl1_18;
            blend1_r_2_0_19 <= blend1_r_2_0_18;
            blend1_g_2_0_19 <= blend1_g_2_0_18;
            blend1_b_2_0_19 <= blend1_b_2_0_18;
        end
    end

    // ===== Stage 19: square1_r_exact, square1_g_exact, square1_b_exact
    // UQ0.36: its square
    wire [35:0] square1_r_exact_19 = blend1_r_2_0_19 * blend1_r_2_0_19;
    // UQ0.18: rounded down
    wire [17:0] square1_r_19 = square1_r_exact_19[35:18];
    // UQ0.36: its square
    wire [35:0] square1_g_exact_19 = blend1_g_2_0_19 * blend1_g_2_0_19;
    // UQ0.18: rounded down
    wire [17:0] square1_g_19 = square1_g_exact_19[35:18];
    // UQ0.36: its square
    wire [35:0] square1_b_exact_19 = blend1_b_2_0_19 * blend1_b_2_0_19;
    // UQ0.18: rounded down
    wire [17:0] square1_b_19 = square1_b_exact_19[35:18];
    reg [17:0] in_gain1r_20;
    reg [17:0] in_gain1g_20;
    reg [17:0] in_gain1b_20;
    reg [18:0] nl1_20;
    reg [17:0] square1_r_20;
    reg [17:0] square1_g_20;
    reg [17:0] square1_b_20;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_20 <= in_gain1r_19;
            in_gain1g_20 <= in_gain1g_19;
            in_gain1b_20 <= in_gain1b_19;
            nl1_20 <= nl1_19;
            square1_r_20 <= square1_r_19;
            square1_g_20 <= square1_g_19;
            square1_b_20 <= square1_b_19;
        end
    end

    // ===== Stage 20: lit1_r_exact, lit1_g_exact, lit1_b_exact
    // UQ8.29: n.l times the square
    wire [36:0] lit1_r_exact_20 = nl1_20 * square1_r_20;
    // UQ8.11: rounded down
    wire [18:0] lit1_r_20 = lit1_r_exact_20[36:18];
    // UQ8.29: n.l times the square
    wire [36:0] lit1_g_exact_20 = nl1_20 * square1_g_20;
    // UQ8.11: rounded down
    wire [18:0] lit1_g_20 = lit1_g_exact_20[36:18];
    // UQ8.29: n.l times the square
    wire [36:0] lit1_b_exact_20 = nl1_20 * square1_b_20;
    // UQ8.11: rounded down
    wire [18:0] lit1_b_20 = lit1_b_exact_20[36:18];
    reg [17:0] in_gain1r_21;
    reg [17:0] in_gain1g_21;
    reg [17:0] in_gain1b_21;
    reg [18:0] lit1_r_21;
    reg [18:0] lit1_g_21;
    reg [18:0] lit1_b_21;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_21 <= in_gain1r_20;
            in_gain1g_21 <= in_gain1g_20;
            in_gain1b_21 <= in_gain1b_20;
            lit1_r_21 <= lit1_r_20;
            lit1_g_21 <= lit1_g_20;
            lit1_b_21 <= lit1_b_20;
        end
    end

    // ===== Stage 21: light1_r_exact, light1_g_exact, light1_b_exact
    // UQ8.29: times the gain
    wire [36:0] light1_r_exact_21 = lit1_r_21 * in_gain1r_21;
    // UQ8.17: rounded down
    wire [24:0] light1_r_21 = light1_r_exact_21[36:12];
    // UQ8.29: times the gain
    wire [36:0] light1_g_exact_21 = lit1_g_21 * in_gain1g_21;
    // UQ8.17: rounded down
    wire [24:0] light1_g_21 = light1_g_exact_21[36:12];
    // UQ8.29: times the gain
    wire [36:0] light1_b_exact_21 = lit1_b_21 * in_gain1b_21;
    // UQ8.17: rounded down
    wire [24:0] light1_b_21 = light1_b_exact_21[36:12];
    reg [24:0] light1_r_22;
    reg [24:0] light1_g_22;
    reg [24:0] light1_b_22;
    always @(posedge clk) begin
        if (ce) begin
            light1_r_22 <= light1_r_21;
            light1_g_22 <= light1_g_21;
            light1_b_22 <= light1_b_21;
        end
    end

    // ===== Stage 22: sum_r, sum_g, sum_b
    // UQ1.17: kept at 1.0
    wire [17:0] sum_r_22 = (|light1_r_22[24:17]) ? 18'h20000 : light1_r_22[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_g_22 = (|light1_g_22[24:17]) ? 18'h20000 : light1_g_22[17:0];
    // UQ1.17: kept at 1.0
    wire [17:0] sum_b_22 = (|light1_b_22[24:17]) ? 18'h20000 : light1_b_22[17:0];
    reg [17:0] sum_r_23;
    reg [17:0] sum_g_23;
    reg [17:0] sum_b_23;
    always @(posedge clk) begin
        if (ce) begin
            sum_r_23 <= sum_r_22;
            sum_g_23 <= sum_g_22;
            sum_b_23 <= sum_b_22;
        end
    end

    assign out_valid = valid[23];
    assign out_sum_r = sum_r_23;
    assign out_sum_g = sum_g_23;
    assign out_sum_b = sum_b_23;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nl1_x_exact_0[8:0],
                    nl1_y_exact_0[8:0],
                    nl1_z_exact_0[8:0],
                    nl1_xyz_2[1:0],
                    nl1_up_3[9:0],
                    band1_next_0[0],
                    dd1_x_exact_1[14:0],
                    dd1_y_exact_1[14:0],
                    dd1_z_exact_1[14:0],
                    u1_exact_3[3:0],
                    u1_twice_4[13],
                    rest1_4[6:0],
                    column1_next_8[0],
                    blend1_r_1_0_part_15[15:13],
                    blend1_r_1_1_part_15[15:13],
                    blend1_r_2_0_part_18[20:18],
                    square1_r_exact_19[17:0],
                    lit1_r_exact_20[17:0],
                    light1_r_exact_21[11:0],
                    blend1_g_1_0_part_15[15:13],
                    blend1_g_1_1_part_15[15:13],
                    blend1_g_2_0_part_18[20:18],
                    square1_g_exact_19[17:0],
                    lit1_g_exact_20[17:0],
                    light1_g_exact_21[11:0],
                    blend1_b_1_0_part_15[15:13],
                    blend1_b_1_1_part_15[15:13],
                    blend1_b_2_0_part_18[20:18],
                    square1_b_exact_19[17:0],
                    lit1_b_exact_20[17:0],
                    light1_b_exact_21[11:0]};

endmodule

`default_nettype wire
