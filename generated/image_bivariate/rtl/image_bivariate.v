// image_bivariate: image-based block of ggx (bivariate, 32 x 32 texels), 1 light a clock, 8 bits a channel
//
// Made by: brdfgen generate --block image --reflectance ggx --image-form bivariate --weight-bits 4
// Spec d17cc6a203587951. Generated; the core is yours to use under any terms.
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
//   in_blend1 UQ1.4   weight of the odd one of this row and the next, at most 1
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
//   44.3 dB in the mean, 34.9 dB at the worst angle.

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
    // UQ1.4: weight of the odd one of this row and the next, at most 1
    input  wire [4:0] in_blend1,
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

    // ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 5 more
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
    // UQ1.4: the weight of the odd band, at most 1
    wire [4:0] blend1_0 = (|in_blend1[4]) ? 5'h10 : in_blend1;
    // UQ6.0: the next
    wire [5:0] band1_next_exact_0 = {1'd0, in_band1} + 6'h01;
    // UQ5.-1: its leading bits
    wire [3:0] band1_odd_high_0 = in_band1[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] band1_odd_0 = band1_odd_high_0;
    // Q2.16: a component of n - h
    wire [18:0] d1_x_exact_0 = {{1{in_nx[17]}}, in_nx} - {{1{in_h1x[17]}}, in_h1x};
    // Q2.16: a component of n - h
    wire [18:0] d1_y_exact_0 = {{1{in_ny[17]}}, in_ny} - {{1{in_h1y[17]}}, in_h1y};
    // Q2.16: a component of n - h
    wire [18:0] d1_z_exact_0 = {{1{in_nz[17]}}, in_nz} - {{1{in_h1z[17]}}, in_h1z};
    // UQ8.-4: the first of them
    wire [3:0] texels1_10_0 = band1_odd_0;
    // UQ8.-4: the first of them
    wire [3:0] texels1_11_0 = band1_odd_0;
    // UQ1.0: a bit of the weight
    wire blend1_whole_0 = blend1_0[4];
    // UQ-3.4: a bit of the weight
    wire blend1_bit_0_0 = blend1_0[0];
    // UQ-2.3: a bit of the weight
    wire blend1_bit_1_0 = blend1_0[1];
    // UQ-1.2: a bit of the weight
    wire blend1_bit_2_0 = blend1_0[2];
    // UQ0.1: a bit of the weight
    wire blend1_bit_3_0 = blend1_0[3];
    // UQ1.0: 1 where the weight is 1
    wire blend1_of_0_0 = blend1_bit_0_0 | blend1_whole_0;
    // UQ1.0: 1 where the weight is 1
    wire blend1_of_1_0 = blend1_bit_1_0 | blend1_whole_0;
    // UQ1.0: 1 where the weight is 1
    wire blend1_of_2_0 = blend1_bit_2_0 | blend1_whole_0;
    // UQ1.0: 1 where the weight is 1
    wire blend1_of_3_0 = blend1_bit_3_0 | blend1_whole_0;
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
    reg [5:0] band1_next_exact_1;
    reg [18:0] d1_x_exact_1;
    reg [18:0] d1_y_exact_1;
    reg [18:0] d1_z_exact_1;
    reg [3:0] texels1_10_1;
    reg [3:0] texels1_11_1;
    reg blend1_whole_1;
    reg blend1_of_0_1;
    reg blend1_of_1_1;
    reg blend1_of_2_1;
    reg blend1_of_3_1;
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
            d1_x_exact_1 <= d1_x_exact_0;
            d1_y_exact_1 <= d1_y_exact_0;
            d1_z_exact_1 <= d1_z_exact_0;
            texels1_10_1 <= texels1_10_0;
            texels1_11_1 <= texels1_11_0;
            blend1_whole_1 <= blend1_whole_0;
            blend1_of_0_1 <= blend1_of_0_0;
            blend1_of_1_1 <= blend1_of_1_0;
            blend1_of_2_1 <= blend1_of_2_0;
            blend1_of_3_1 <= blend1_of_3_0;
        end
    end

    // ===== Stage 1: nl1_xy, band1_next, d1_x, d1_y, d1_z
    // Q4.22: n.l
    wire [26:0] nl1_xy_1 = {{1{nl1_x_1[25]}}, nl1_x_1} + {{1{nl1_y_1[25]}}, nl1_y_1};
    // UQ5.0: at most the last
    wire [4:0] band1_next_1 = (|band1_next_exact_1[5]) ? 5'h1f : band1_next_exact_1[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] band1_even_high_1 = band1_next_1[4:1];
    // UQ4.0: the even one of both
    wire [3:0] band1_even_1 = band1_even_high_1;
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_x_1 = (d1_x_exact_1[18] & ~&d1_x_exact_1[17]) ? 18'h20000 :
        (~d1_x_exact_1[18] & |d1_x_exact_1[17]) ? 18'h1ffff :
        d1_x_exact_1[17:0];
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_y_1 = (d1_y_exact_1[18] & ~&d1_y_exact_1[17]) ? 18'h20000 :
        (~d1_y_exact_1[18] & |d1_y_exact_1[17]) ? 18'h1ffff :
        d1_y_exact_1[17:0];
    // Q1.16: of unit vectors it is below 2
    wire [17:0] d1_z_1 = (d1_z_exact_1[18] & ~&d1_z_exact_1[17]) ? 18'h20000 :
        (~d1_z_exact_1[18] & |d1_z_exact_1[17]) ? 18'h1ffff :
        d1_z_exact_1[17:0];
    // UQ8.-4: the first of them
    wire [3:0] texels1_00_1 = band1_even_1;
    // UQ8.-4: the first of them
    wire [3:0] texels1_01_1 = band1_even_1;
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
    reg [17:0] d1_x_2;
    reg [17:0] d1_y_2;
    reg [17:0] d1_z_2;
    reg [3:0] texels1_00_2;
    reg [3:0] texels1_01_2;
    reg [3:0] texels1_10_2;
    reg [3:0] texels1_11_2;
    reg blend1_whole_2;
    reg blend1_of_0_2;
    reg blend1_of_1_2;
    reg blend1_of_2_2;
    reg blend1_of_3_2;
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
            d1_x_2 <= d1_x_1;
            d1_y_2 <= d1_y_1;
            d1_z_2 <= d1_z_1;
            texels1_00_2 <= texels1_00_1;
            texels1_01_2 <= texels1_01_1;
            texels1_10_2 <= texels1_10_1;
            texels1_11_2 <= texels1_11_1;
            blend1_whole_2 <= blend1_whole_1;
            blend1_of_0_2 <= blend1_of_0_1;
            blend1_of_1_2 <= blend1_of_1_1;
            blend1_of_2_2 <= blend1_of_2_1;
            blend1_of_3_2 <= blend1_of_3_1;
        end
    end

    // ===== Stage 2: nl1_xyz, dd1_x_exact, dd1_y_exact, dd1_z_exact
    // Q4.22: n.l
    wire [26:0] nl1_xyz_2 = nl1_xy_2 + {{1{nl1_z_2[25]}}, nl1_z_2};
    // Q4.20: rounded down
    wire [24:0] nl1_cut_2 = nl1_xyz_2[26:2];
    // Q3.32: |n - h|^2
    wire [35:0] dd1_x_exact_2 = $signed(d1_x_2) * $signed(d1_x_2);
    // Q3.16: rounded down
    wire [19:0] dd1_x_2 = dd1_x_exact_2[35:16];
    // Q3.32: |n - h|^2
    wire [35:0] dd1_y_exact_2 = $signed(d1_y_2) * $signed(d1_y_2);
    // Q3.16: rounded down
    wire [19:0] dd1_y_2 = dd1_y_exact_2[35:16];
    // Q3.32: |n - h|^2
    wire [35:0] dd1_z_exact_2 = $signed(d1_z_2) * $signed(d1_z_2);
    // Q3.16: rounded down
    wire [19:0] dd1_z_2 = dd1_z_exact_2[35:16];
    reg [17:0] in_gain1r_3;
    reg [17:0] in_gain1g_3;
    reg [17:0] in_gain1b_3;
    reg hidden_3;
    reg [24:0] nl1_cut_3;
    reg nl1_by_1_3;
    reg [1:0] nl1_amount_2_3;
    reg [2:0] nl1_amount_4_3;
    reg nl1_by_8_3;
    reg [19:0] dd1_x_3;
    reg [19:0] dd1_y_3;
    reg [19:0] dd1_z_3;
    reg [3:0] texels1_00_3;
    reg [3:0] texels1_01_3;
    reg [3:0] texels1_10_3;
    reg [3:0] texels1_11_3;
    reg blend1_whole_3;
    reg blend1_of_0_3;
    reg blend1_of_1_3;
    reg blend1_of_2_3;
    reg blend1_of_3_3;
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
            dd1_x_3 <= dd1_x_2;
            dd1_y_3 <= dd1_y_2;
            dd1_z_3 <= dd1_z_2;
            texels1_00_3 <= texels1_00_2;
            texels1_01_3 <= texels1_01_2;
            texels1_10_3 <= texels1_10_2;
            texels1_11_3 <= texels1_11_2;
            blend1_whole_3 <= blend1_whole_2;
            blend1_of_0_3 <= blend1_of_0_2;
            blend1_of_1_3 <= blend1_of_1_2;
            blend1_of_2_3 <= blend1_of_2_2;
            blend1_of_3_3 <= blend1_of_3_2;
        end
    end

    // ===== Stage 3: nl1_kept, nl1_up_1, dd1_xy
    // UQ0.20: n.l, kept in [0, 1)
    wire [19:0] nl1_kept_3 =
        nl1_cut_3[24] ? 20'h00000 : (|nl1_cut_3[23:20]) ? 20'hfffff : nl1_cut_3[19:0];
    // UQ1.20: times 2^1 if so
    wire [20:0] nl1_up_1_3 = {1'd0, nl1_kept_3} << nl1_by_1_3;
    // UQ9.12: times 2^8
    wire [20:0] nl1_all_3 = nl1_up_1_3;
    // UQ9.20: in the wider of two formats
    wire [28:0] nl1_all_wide_3 = {nl1_all_3, 8'd0};
    // Q4.16: |n - h|^2
    wire [20:0] dd1_xy_3 = {{1{dd1_x_3[19]}}, dd1_x_3} + {{1{dd1_y_3[19]}}, dd1_y_3};
    reg [17:0] in_gain1r_4;
    reg [17:0] in_gain1g_4;
    reg [17:0] in_gain1b_4;
    reg hidden_4;
    reg [20:0] nl1_up_1_4;
    reg [1:0] nl1_amount_2_4;
    reg [2:0] nl1_amount_4_4;
    reg nl1_by_8_4;
    reg [28:0] nl1_all_wide_4;
    reg [19:0] dd1_z_4;
    reg [20:0] dd1_xy_4;
    reg [3:0] texels1_00_4;
    reg [3:0] texels1_01_4;
    reg [3:0] texels1_10_4;
    reg [3:0] texels1_11_4;
    reg blend1_whole_4;
    reg blend1_of_0_4;
    reg blend1_of_1_4;
    reg blend1_of_2_4;
    reg blend1_of_3_4;
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
            dd1_z_4 <= dd1_z_3;
            dd1_xy_4 <= dd1_xy_3;
            texels1_00_4 <= texels1_00_3;
            texels1_01_4 <= texels1_01_3;
            texels1_10_4 <= texels1_10_3;
            texels1_11_4 <= texels1_11_3;
            blend1_whole_4 <= blend1_whole_3;
            blend1_of_0_4 <= blend1_of_0_3;
            blend1_of_1_4 <= blend1_of_1_3;
            blend1_of_2_4 <= blend1_of_2_3;
            blend1_of_3_4 <= blend1_of_3_3;
        end
    end

    // ===== Stage 4: nl1_up_2, dd1_xyz
    // UQ3.20: times 2^2 if so
    wire [22:0] nl1_up_2_4 = {2'd0, nl1_up_1_4} << nl1_amount_2_4;
    // Q4.16: |n - h|^2
    wire [20:0] dd1_xyz_4 = dd1_xy_4 + {{1{dd1_z_4[19]}}, dd1_z_4};
    // Q3.17: |n - h|^2 / 2
    wire [20:0] u1_exact_4 = dd1_xyz_4;
    // Q3.13: rounded down
    wire [16:0] u1_cut_4 = u1_exact_4[20:4];
    reg [17:0] in_gain1r_5;
    reg [17:0] in_gain1g_5;
    reg [17:0] in_gain1b_5;
    reg hidden_5;
    reg [22:0] nl1_up_2_5;
    reg [2:0] nl1_amount_4_5;
    reg nl1_by_8_5;
    reg [28:0] nl1_all_wide_5;
    reg [16:0] u1_cut_5;
    reg [3:0] texels1_00_5;
    reg [3:0] texels1_01_5;
    reg [3:0] texels1_10_5;
    reg [3:0] texels1_11_5;
    reg blend1_whole_5;
    reg blend1_of_0_5;
    reg blend1_of_1_5;
    reg blend1_of_2_5;
    reg blend1_of_3_5;
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
            u1_cut_5 <= u1_cut_4;
            texels1_00_5 <= texels1_00_4;
            texels1_01_5 <= texels1_01_4;
            texels1_10_5 <= texels1_10_4;
            texels1_11_5 <= texels1_11_4;
            blend1_whole_5 <= blend1_whole_4;
            blend1_of_0_5 <= blend1_of_0_4;
            blend1_of_1_5 <= blend1_of_1_4;
            blend1_of_2_5 <= blend1_of_2_4;
            blend1_of_3_5 <= blend1_of_3_4;
        end
    end

    // ===== Stage 5: nl1_up_4, nl1_up, nl1_within, u1, u1_4
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
    // UQ0.13: the versine u = |n - h|^2 / 2, at most the last column's
    wire [12:0] u1_5 = u1_cut_5[16] ? 13'h0000 : (u1_cut_5 > 17'h01c00) ? 13'h1c00 : u1_cut_5[12:0];
    // UQ0.4: the first 4 bits of u
    wire [3:0] high1_4_bits_5 = u1_5[12:9];
    // UQ1.0: the first 4 bits of u
    wire high1_4_5 = |high1_4_bits_5;
    // UQ-4.13: without them
    wire [8:0] u_low1_4_5 = u1_5[8:0];
    // UQ0.9: u 2^4
    wire [8:0] u_up1_4_5 = u_low1_4_5;
    // UQ0.13: in the wider of two formats
    wire [12:0] u_up1_4_wide_5 = {u_up1_4_5, 4'd0};
    // UQ0.13: u, times 2^4 if it is so small
    wire [12:0] u1_4_5 = high1_4_5 ? u1_5 : u_up1_4_wide_5;
    // UQ3.-2: a bit of the exponent
    wire place1_4_5 = high1_4_5;
    // UQ0.2: the first 2 bits of u
    wire [1:0] high1_2_bits_5 = u1_4_5[12:11];
    // UQ-2.13: without them
    wire [10:0] u_low1_2_5 = u1_4_5[10:0];
    // UQ0.11: u 2^2
    wire [10:0] u_up1_2_5 = u_low1_2_5;
    // UQ0.13: in the wider of two formats
    wire [12:0] u_up1_2_wide_5 = {u_up1_2_5, 2'd0};
    reg [17:0] in_gain1r_6;
    reg [17:0] in_gain1g_6;
    reg [17:0] in_gain1b_6;
    reg hidden_6;
    reg [17:0] nl1_within_6;
    reg high1_4_6;
    reg [12:0] u1_4_6;
    reg place1_4_6;
    reg [1:0] high1_2_bits_6;
    reg [12:0] u_up1_2_wide_6;
    reg [3:0] texels1_00_6;
    reg [3:0] texels1_01_6;
    reg [3:0] texels1_10_6;
    reg [3:0] texels1_11_6;
    reg blend1_whole_6;
    reg blend1_of_0_6;
    reg blend1_of_1_6;
    reg blend1_of_2_6;
    reg blend1_of_3_6;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_6 <= in_gain1r_5;
            in_gain1g_6 <= in_gain1g_5;
            in_gain1b_6 <= in_gain1b_5;
            hidden_6 <= hidden_5;
            nl1_within_6 <= nl1_within_5;
            high1_4_6 <= high1_4_5;
            u1_4_6 <= u1_4_5;
            place1_4_6 <= place1_4_5;
            high1_2_bits_6 <= high1_2_bits_5;
            u_up1_2_wide_6 <= u_up1_2_wide_5;
            texels1_00_6 <= texels1_00_5;
            texels1_01_6 <= texels1_01_5;
            texels1_10_6 <= texels1_10_5;
            texels1_11_6 <= texels1_11_5;
            blend1_whole_6 <= blend1_whole_5;
            blend1_of_0_6 <= blend1_of_0_5;
            blend1_of_1_6 <= blend1_of_1_5;
            blend1_of_2_6 <= blend1_of_2_5;
            blend1_of_3_6 <= blend1_of_3_5;
        end
    end

    // ===== Stage 6: nl1, u1_2, exponent1_2, u1_1, rest1
    // UQ7.11: n.l, 0 for a normal that is turned away
    wire [17:0] nl1_6 = hidden_6 ? 18'd0 : nl1_within_6;
    // UQ1.0: the first 2 bits of u
    wire high1_2_6 = |high1_2_bits_6;
    // UQ0.13: u, times 2^2 if it is so small
    wire [12:0] u1_2_6 = high1_2_6 ? u1_4_6 : u_up1_2_wide_6;
    // UQ2.-1: a bit of the exponent
    wire place1_2_6 = high1_2_6;
    // UQ3.-1: the exponent's bits so far
    wire [1:0] exponent1_2_6 = {place1_4_6, 1'd0} + {1'd0, place1_2_6};
    // UQ0.1: the first 1 bits of u
    wire high1_1_bits_6 = u1_2_6[12];
    // UQ-1.13: without them
    wire [11:0] u_low1_1_6 = u1_2_6[11:0];
    // UQ0.12: u 2^1
    wire [11:0] u_up1_1_6 = u_low1_1_6;
    // UQ0.13: in the wider of two formats
    wire [12:0] u_up1_1_wide_6 = {u_up1_1_6, 1'd0};
    // UQ0.13: u, times 2^1 if it is so small
    wire [12:0] u1_1_6 = high1_1_bits_6 ? u1_2_6 : u_up1_1_wide_6;
    // UQ1.0: a bit of the exponent
    wire place1_1_6 = high1_1_bits_6;
    // UQ1.0: the exponent is not 0
    wire normal1_of_2_6 = high1_4_6 | high1_2_6;
    // UQ1.0: the exponent is not 0
    wire normal1_6 = normal1_of_2_6 | high1_1_bits_6;
    // UQ1.12: 2 u
    wire [12:0] u1_twice_6 = u1_1_6;
    // UQ0.12: 2 u - 1
    wire [11:0] u1_rest_6 = u1_twice_6[11:0];
    // UQ0.13: in the wider of two formats
    wire [12:0] u1_rest_wide_6 = {u1_rest_6, 1'd0};
    // UQ0.13: the place in the octave
    wire [12:0] rest1_6 = normal1_6 ? u1_rest_wide_6 : u1_1_6;
    // UQ0.6: rounded down to the weights' last bit
    wire [5:0] rest1_cut_6 = rest1_6[12:7];
    // UQ0.2: the column in the octave
    wire [1:0] step1_6 = rest1_cut_6[5:4];
    // UQ2.0: its number
    wire [1:0] step1_number_6 = step1_6;
    // UQ-2.6: u past it
    wire [3:0] part1_6 = rest1_cut_6[3:0];
    // UQ0.4: the weight of the next column
    wire [3:0] weight1_6 = part1_6;
    // UQ-3.4: a bit of the weight
    wire weight1_bit_0_6 = weight1_6[0];
    // UQ-2.3: a bit of the weight
    wire weight1_bit_1_6 = weight1_6[1];
    // UQ-1.2: a bit of the weight
    wire weight1_bit_2_6 = weight1_6[2];
    // UQ0.1: a bit of the weight
    wire weight1_bit_3_6 = weight1_6[3];
    // UQ1.0: as a flag
    wire weight1_of_0_flag_6 = weight1_bit_0_6;
    // UQ1.0: it is 0
    wire weight1_of_0_not_6 = ~weight1_of_0_flag_6;
    // UQ1.0: as a flag
    wire weight1_of_1_flag_6 = weight1_bit_1_6;
    // UQ1.0: it is 0
    wire weight1_of_1_not_6 = ~weight1_of_1_flag_6;
    // UQ1.0: as a flag
    wire weight1_of_2_flag_6 = weight1_bit_2_6;
    // UQ1.0: it is 0
    wire weight1_of_2_not_6 = ~weight1_of_2_flag_6;
    // UQ1.0: as a flag
    wire weight1_of_3_flag_6 = weight1_bit_3_6;
    // UQ1.0: it is 0
    wire weight1_of_3_not_6 = ~weight1_of_3_flag_6;
    reg [17:0] in_gain1r_7;
    reg [17:0] in_gain1g_7;
    reg [17:0] in_gain1b_7;
    reg [17:0] nl1_7;
    reg [1:0] exponent1_2_7;
    reg place1_1_7;
    reg [1:0] step1_number_7;
    reg [3:0] texels1_00_7;
    reg [3:0] texels1_01_7;
    reg [3:0] texels1_10_7;
    reg [3:0] texels1_11_7;
    reg weight1_of_0_flag_7;
    reg weight1_of_0_not_7;
    reg weight1_of_1_flag_7;
    reg weight1_of_1_not_7;
    reg weight1_of_2_flag_7;
    reg weight1_of_2_not_7;
    reg weight1_of_3_flag_7;
    reg weight1_of_3_not_7;
    reg blend1_whole_7;
    reg blend1_of_0_7;
    reg blend1_of_1_7;
    reg blend1_of_2_7;
    reg blend1_of_3_7;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_7 <= in_gain1r_6;
            in_gain1g_7 <= in_gain1g_6;
            in_gain1b_7 <= in_gain1b_6;
            nl1_7 <= nl1_6;
            exponent1_2_7 <= exponent1_2_6;
            place1_1_7 <= place1_1_6;
            step1_number_7 <= step1_number_6;
            texels1_00_7 <= texels1_00_6;
            texels1_01_7 <= texels1_01_6;
            texels1_10_7 <= texels1_10_6;
            texels1_11_7 <= texels1_11_6;
            weight1_of_0_flag_7 <= weight1_of_0_flag_6;
            weight1_of_0_not_7 <= weight1_of_0_not_6;
            weight1_of_1_flag_7 <= weight1_of_1_flag_6;
            weight1_of_1_not_7 <= weight1_of_1_not_6;
            weight1_of_2_flag_7 <= weight1_of_2_flag_6;
            weight1_of_2_not_7 <= weight1_of_2_not_6;
            weight1_of_3_flag_7 <= weight1_of_3_flag_6;
            weight1_of_3_not_7 <= weight1_of_3_not_6;
            blend1_whole_7 <= blend1_whole_6;
            blend1_of_0_7 <= blend1_of_0_6;
            blend1_of_1_7 <= blend1_of_1_6;
            blend1_of_2_7 <= blend1_of_2_6;
            blend1_of_3_7 <= blend1_of_3_6;
        end
    end

    // ===== Stage 7: exponent1_1
    // UQ3.0: the exponent's bits so far
    wire [2:0] exponent1_1_7 = {exponent1_2_7, 1'd0} + {2'd0, place1_1_7};
    // UQ5.-2: the octave's first column
    wire [2:0] octave1_7 = exponent1_1_7;
    reg [17:0] in_gain1r_8;
    reg [17:0] in_gain1g_8;
    reg [17:0] in_gain1b_8;
    reg [17:0] nl1_8;
    reg [1:0] step1_number_8;
    reg [2:0] octave1_8;
    reg [3:0] texels1_00_8;
    reg [3:0] texels1_01_8;
    reg [3:0] texels1_10_8;
    reg [3:0] texels1_11_8;
    reg weight1_of_0_flag_8;
    reg weight1_of_0_not_8;
    reg weight1_of_1_flag_8;
    reg weight1_of_1_not_8;
    reg weight1_of_2_flag_8;
    reg weight1_of_2_not_8;
    reg weight1_of_3_flag_8;
    reg weight1_of_3_not_8;
    reg blend1_whole_8;
    reg blend1_of_0_8;
    reg blend1_of_1_8;
    reg blend1_of_2_8;
    reg blend1_of_3_8;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_8 <= in_gain1r_7;
            in_gain1g_8 <= in_gain1g_7;
            in_gain1b_8 <= in_gain1b_7;
            nl1_8 <= nl1_7;
            step1_number_8 <= step1_number_7;
            octave1_8 <= octave1_7;
            texels1_00_8 <= texels1_00_7;
            texels1_01_8 <= texels1_01_7;
            texels1_10_8 <= texels1_10_7;
            texels1_11_8 <= texels1_11_7;
            weight1_of_0_flag_8 <= weight1_of_0_flag_7;
            weight1_of_0_not_8 <= weight1_of_0_not_7;
            weight1_of_1_flag_8 <= weight1_of_1_flag_7;
            weight1_of_1_not_8 <= weight1_of_1_not_7;
            weight1_of_2_flag_8 <= weight1_of_2_flag_7;
            weight1_of_2_not_8 <= weight1_of_2_not_7;
            weight1_of_3_flag_8 <= weight1_of_3_flag_7;
            weight1_of_3_not_8 <= weight1_of_3_not_7;
            blend1_whole_8 <= blend1_whole_7;
            blend1_of_0_8 <= blend1_of_0_7;
            blend1_of_1_8 <= blend1_of_1_7;
            blend1_of_2_8 <= blend1_of_2_7;
            blend1_of_3_8 <= blend1_of_3_7;
        end
    end

    // ===== Stage 8: column1, weight1_of_0, weight1_of_1, weight1_of_2 and 1 more
    // UQ5.0: the column at or below u
    wire [4:0] column1_8 = {octave1_8, 2'd0} + {3'd0, step1_number_8};
    // UQ5.-1: its leading bits
    wire [3:0] column1_odd_high_8 = column1_8[4:1];
    // UQ4.0: the odd one of both
    wire [3:0] column1_odd_8 = column1_odd_high_8;
    // UQ1.0: its last bit
    wire column1_is_odd_8 = column1_8[0];
    // UQ1.0: whether it counts for the odd one
    wire weight1_of_0_8 = column1_is_odd_8 ? weight1_of_0_not_8 : weight1_of_0_flag_8;
    // UQ1.0: whether it counts for the odd one
    wire weight1_of_1_8 = column1_is_odd_8 ? weight1_of_1_not_8 : weight1_of_1_flag_8;
    // UQ1.0: whether it counts for the odd one
    wire weight1_of_2_8 = column1_is_odd_8 ? weight1_of_2_not_8 : weight1_of_2_flag_8;
    // UQ1.0: whether it counts for the odd one
    wire weight1_of_3_8 = column1_is_odd_8 ? weight1_of_3_not_8 : weight1_of_3_flag_8;
    reg [17:0] in_gain1r_9;
    reg [17:0] in_gain1g_9;
    reg [17:0] in_gain1b_9;
    reg [17:0] nl1_9;
    reg [4:0] column1_9;
    reg [3:0] column1_odd_9;
    reg column1_is_odd_9;
    reg [3:0] texels1_00_9;
    reg [3:0] texels1_01_9;
    reg [3:0] texels1_10_9;
    reg [3:0] texels1_11_9;
    reg weight1_of_0_9;
    reg weight1_of_1_9;
    reg weight1_of_2_9;
    reg weight1_of_3_9;
    reg blend1_whole_9;
    reg blend1_of_0_9;
    reg blend1_of_1_9;
    reg blend1_of_2_9;
    reg blend1_of_3_9;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_9 <= in_gain1r_8;
            in_gain1g_9 <= in_gain1g_8;
            in_gain1b_9 <= in_gain1b_8;
            nl1_9 <= nl1_8;
            column1_9 <= column1_8;
            column1_odd_9 <= column1_odd_8;
            column1_is_odd_9 <= column1_is_odd_8;
            texels1_00_9 <= texels1_00_8;
            texels1_01_9 <= texels1_01_8;
            texels1_10_9 <= texels1_10_8;
            texels1_11_9 <= texels1_11_8;
            weight1_of_0_9 <= weight1_of_0_8;
            weight1_of_1_9 <= weight1_of_1_8;
            weight1_of_2_9 <= weight1_of_2_8;
            weight1_of_3_9 <= weight1_of_3_8;
            blend1_whole_9 <= blend1_whole_8;
            blend1_of_0_9 <= blend1_of_0_8;
            blend1_of_1_9 <= blend1_of_1_8;
            blend1_of_2_9 <= blend1_of_2_8;
            blend1_of_3_9 <= blend1_of_3_8;
        end
    end

    // ===== Stage 9: column1_next_exact, texel1_01, texel1_11
    // UQ6.0: the next
    wire [5:0] column1_next_exact_9 = {1'd0, column1_9} + 6'h01;
    // UQ8.0: side by side
    wire [7:0] texel1_01_9 = {texels1_01_9, 4'd0} + {4'd0, column1_odd_9};
    // UQ8.0: side by side
    wire [7:0] texel1_11_9 = {texels1_11_9, 4'd0} + {4'd0, column1_odd_9};
    reg [17:0] in_gain1r_10;
    reg [17:0] in_gain1g_10;
    reg [17:0] in_gain1b_10;
    reg [17:0] nl1_10;
    reg [5:0] column1_next_exact_10;
    reg column1_is_odd_10;
    reg [3:0] texels1_00_10;
    reg [7:0] texel1_01_10;
    reg [3:0] texels1_10_10;
    reg [7:0] texel1_11_10;
    reg weight1_of_0_10;
    reg weight1_of_1_10;
    reg weight1_of_2_10;
    reg weight1_of_3_10;
    reg blend1_whole_10;
    reg blend1_of_0_10;
    reg blend1_of_1_10;
    reg blend1_of_2_10;
    reg blend1_of_3_10;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_10 <= in_gain1r_9;
            in_gain1g_10 <= in_gain1g_9;
            in_gain1b_10 <= in_gain1b_9;
            nl1_10 <= nl1_9;
            column1_next_exact_10 <= column1_next_exact_9;
            column1_is_odd_10 <= column1_is_odd_9;
            texels1_00_10 <= texels1_00_9;
            texel1_01_10 <= texel1_01_9;
            texels1_10_10 <= texels1_10_9;
            texel1_11_10 <= texel1_11_9;
            weight1_of_0_10 <= weight1_of_0_9;
            weight1_of_1_10 <= weight1_of_1_9;
            weight1_of_2_10 <= weight1_of_2_9;
            weight1_of_3_10 <= weight1_of_3_9;
            blend1_whole_10 <= blend1_whole_9;
            blend1_of_0_10 <= blend1_of_0_9;
            blend1_of_1_10 <= blend1_of_1_9;
            blend1_of_2_10 <= blend1_of_2_9;
            blend1_of_3_10 <= blend1_of_3_9;
        end
    end

    // ===== Stage 10: column1_next
    // UQ5.0: at most the last
    wire [4:0] column1_next_10 = (|column1_next_exact_10[5]) ? 5'h1f : column1_next_exact_10[4:0];
    // UQ5.-1: its leading bits
    wire [3:0] column1_even_high_10 = column1_next_10[4:1];
    // UQ4.0: the even one of both
    wire [3:0] column1_even_10 = column1_even_high_10;
    reg [17:0] in_gain1r_11;
    reg [17:0] in_gain1g_11;
    reg [17:0] in_gain1b_11;
    reg [17:0] nl1_11;
    reg [3:0] column1_even_11;
    reg column1_is_odd_11;
    reg [3:0] texels1_00_11;
    reg [7:0] texel1_01_11;
    reg [3:0] texels1_10_11;
    reg [7:0] texel1_11_11;
    reg weight1_of_0_11;
    reg weight1_of_1_11;
    reg weight1_of_2_11;
    reg weight1_of_3_11;
    reg blend1_whole_11;
    reg blend1_of_0_11;
    reg blend1_of_1_11;
    reg blend1_of_2_11;
    reg blend1_of_3_11;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_11 <= in_gain1r_10;
            in_gain1g_11 <= in_gain1g_10;
            in_gain1b_11 <= in_gain1b_10;
            nl1_11 <= nl1_10;
            column1_even_11 <= column1_even_10;
            column1_is_odd_11 <= column1_is_odd_10;
            texels1_00_11 <= texels1_00_10;
            texel1_01_11 <= texel1_01_10;
            texels1_10_11 <= texels1_10_10;
            texel1_11_11 <= texel1_11_10;
            weight1_of_0_11 <= weight1_of_0_10;
            weight1_of_1_11 <= weight1_of_1_10;
            weight1_of_2_11 <= weight1_of_2_10;
            weight1_of_3_11 <= weight1_of_3_10;
            blend1_whole_11 <= blend1_whole_10;
            blend1_of_0_11 <= blend1_of_0_10;
            blend1_of_1_11 <= blend1_of_1_10;
            blend1_of_2_11 <= blend1_of_2_10;
            blend1_of_3_11 <= blend1_of_3_10;
        end
    end

    // ===== Stage 11: texel1_00, texel1_10
    // UQ8.0: side by side
    wire [7:0] texel1_00_11 = {texels1_00_11, 4'd0} + {4'd0, column1_even_11};
    // UQ8.0: side by side
    wire [7:0] texel1_10_11 = {texels1_10_11, 4'd0} + {4'd0, column1_even_11};
    reg [17:0] in_gain1r_12;
    reg [17:0] in_gain1g_12;
    reg [17:0] in_gain1b_12;
    reg [17:0] nl1_12;
    reg column1_is_odd_12;
    reg [7:0] texel1_00_12;
    reg [7:0] texel1_01_12;
    reg [7:0] texel1_10_12;
    reg [7:0] texel1_11_12;
    reg weight1_of_0_12;
    reg weight1_of_1_12;
    reg weight1_of_2_12;
    reg weight1_of_3_12;
    reg blend1_whole_12;
    reg blend1_of_0_12;
    reg blend1_of_1_12;
    reg blend1_of_2_12;
    reg blend1_of_3_12;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_12 <= in_gain1r_11;
            in_gain1g_12 <= in_gain1g_11;
            in_gain1b_12 <= in_gain1b_11;
            nl1_12 <= nl1_11;
            column1_is_odd_12 <= column1_is_odd_11;
            texel1_00_12 <= texel1_00_11;
            texel1_01_12 <= texel1_01_11;
            texel1_10_12 <= texel1_10_11;
            texel1_11_12 <= texel1_11_11;
            weight1_of_0_12 <= weight1_of_0_11;
            weight1_of_1_12 <= weight1_of_1_11;
            weight1_of_2_12 <= weight1_of_2_11;
            weight1_of_3_12 <= weight1_of_3_11;
            blend1_whole_12 <= blend1_whole_11;
            blend1_of_0_12 <= blend1_of_0_11;
            blend1_of_1_12 <= blend1_of_1_11;
            blend1_of_2_12 <= blend1_of_2_11;
            blend1_of_3_12 <= blend1_of_3_11;
        end
    end

    // ===== Stage 12: read texels_1_even_even, read texels_1_even_odd and 2 more
    // The word of the memory texels_1_even_even, of 256 words.
    reg [23:0] texels_1_even_even_13;
    // The word of the memory texels_1_even_odd, of 256 words.
    reg [23:0] texels_1_even_odd_13;
    // The word of the memory texels_1_odd_even, of 256 words.
    reg [23:0] texels_1_odd_even_13;
    // The word of the memory texels_1_odd_odd, of 256 words.
    reg [23:0] texels_1_odd_odd_13;
    reg [23:0] texels_1_even_even [0:255];
    initial $readmemh(TEXELS_1_EVEN_EVEN_FILE, texels_1_even_even);
    always @(posedge clk) begin
        if (ce) texels_1_even_even_13 <= texels_1_even_even[texel1_00_12];
    end
    reg [23:0] texels_1_even_odd [0:255];
    initial $readmemh(TEXELS_1_EVEN_ODD_FILE, texels_1_even_odd);
    always @(posedge clk) begin
        if (ce) texels_1_even_odd_13 <= texels_1_even_odd[texel1_01_12];
    end
    reg [23:0] texels_1_odd_even [0:255];
    initial $readmemh(TEXELS_1_ODD_EVEN_FILE, texels_1_odd_even);
    always @(posedge clk) begin
        if (ce) texels_1_odd_even_13 <= texels_1_odd_even[texel1_10_12];
    end
    reg [23:0] texels_1_odd_odd [0:255];
    initial $readmemh(TEXELS_1_ODD_ODD_FILE, texels_1_odd_odd);
    always @(posedge clk) begin
        if (ce) texels_1_odd_odd_13 <= texels_1_odd_odd[texel1_11_12];
    end
    reg [17:0] in_gain1r_13;
    reg [17:0] in_gain1g_13;
    reg [17:0] in_gain1b_13;
    reg [17:0] nl1_13;
    reg column1_is_odd_13;
    reg weight1_of_0_13;
    reg weight1_of_1_13;
    reg weight1_of_2_13;
    reg weight1_of_3_13;
    reg blend1_whole_13;
    reg blend1_of_0_13;
    reg blend1_of_1_13;
    reg blend1_of_2_13;
    reg blend1_of_3_13;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_13 <= in_gain1r_12;
            in_gain1g_13 <= in_gain1g_12;
            in_gain1b_13 <= in_gain1b_12;
            nl1_13 <= nl1_12;
            column1_is_odd_13 <= column1_is_odd_12;
            weight1_of_0_13 <= weight1_of_0_12;
            weight1_of_1_13 <= weight1_of_1_12;
            weight1_of_2_13 <= weight1_of_2_12;
            weight1_of_3_13 <= weight1_of_3_12;
            blend1_whole_13 <= blend1_whole_12;
            blend1_of_0_13 <= blend1_of_0_12;
            blend1_of_1_13 <= blend1_of_1_12;
            blend1_of_2_13 <= blend1_of_2_12;
            blend1_of_3_13 <= blend1_of_3_12;
        end
    end

    // ===== Stage 13: registers only
    // UQ0.8: red
    wire [7:0] texels_1_even_even_r_13 = texels_1_even_even_13[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_even_odd_r_13 = texels_1_even_odd_13[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_even_r_13 = texels_1_odd_even_13[23:16];
    // UQ0.8: red
    wire [7:0] texels_1_odd_odd_r_13 = texels_1_odd_odd_13[23:16];
    // UQ0.8: green
    wire [7:0] texels_1_even_even_g_13 = texels_1_even_even_13[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_even_odd_g_13 = texels_1_even_odd_13[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_even_g_13 = texels_1_odd_even_13[15:8];
    // UQ0.8: green
    wire [7:0] texels_1_odd_odd_g_13 = texels_1_odd_odd_13[15:8];
    // UQ0.8: blue
    wire [7:0] texels_1_even_even_b_13 = texels_1_even_even_13[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_even_odd_b_13 = texels_1_even_odd_13[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_even_b_13 = texels_1_odd_even_13[7:0];
    // UQ0.8: blue
    wire [7:0] texels_1_odd_odd_b_13 = texels_1_odd_odd_13[7:0];
    reg [17:0] in_gain1r_14;
    reg [17:0] in_gain1g_14;
    reg [17:0] in_gain1b_14;
    reg [17:0] nl1_14;
    reg column1_is_odd_14;
    reg [7:0] texels_1_even_even_r_14;
    reg [7:0] texels_1_even_odd_r_14;
    reg [7:0] texels_1_odd_even_r_14;
    reg [7:0] texels_1_odd_odd_r_14;
    reg weight1_of_0_14;
    reg weight1_of_1_14;
    reg weight1_of_2_14;
    reg weight1_of_3_14;
    reg blend1_whole_14;
    reg blend1_of_0_14;
    reg blend1_of_1_14;
    reg blend1_of_2_14;
    reg blend1_of_3_14;
    reg [7:0] texels_1_even_even_g_14;
    reg [7:0] texels_1_even_odd_g_14;
    reg [7:0] texels_1_odd_even_g_14;
    reg [7:0] texels_1_odd_odd_g_14;
    reg [7:0] texels_1_even_even_b_14;
    reg [7:0] texels_1_even_odd_b_14;
    reg [7:0] texels_1_odd_even_b_14;
    reg [7:0] texels_1_odd_odd_b_14;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_14 <= in_gain1r_13;
            in_gain1g_14 <= in_gain1g_13;
            in_gain1b_14 <= in_gain1b_13;
            nl1_14 <= nl1_13;
            column1_is_odd_14 <= column1_is_odd_13;
            texels_1_even_even_r_14 <= texels_1_even_even_r_13;
            texels_1_even_odd_r_14 <= texels_1_even_odd_r_13;
            texels_1_odd_even_r_14 <= texels_1_odd_even_r_13;
            texels_1_odd_odd_r_14 <= texels_1_odd_odd_r_13;
            weight1_of_0_14 <= weight1_of_0_13;
            weight1_of_1_14 <= weight1_of_1_13;
            weight1_of_2_14 <= weight1_of_2_13;
            weight1_of_3_14 <= weight1_of_3_13;
            blend1_whole_14 <= blend1_whole_13;
            blend1_of_0_14 <= blend1_of_0_13;
            blend1_of_1_14 <= blend1_of_1_13;
            blend1_of_2_14 <= blend1_of_2_13;
            blend1_of_3_14 <= blend1_of_3_13;
            texels_1_even_even_g_14 <= texels_1_even_even_g_13;
            texels_1_even_odd_g_14 <= texels_1_even_odd_g_13;
            texels_1_odd_even_g_14 <= texels_1_odd_even_g_13;
            texels_1_odd_odd_g_14 <= texels_1_odd_odd_g_13;
            texels_1_even_even_b_14 <= texels_1_even_even_b_13;
            texels_1_even_odd_b_14 <= texels_1_even_odd_b_13;
            texels_1_odd_even_b_14 <= texels_1_odd_even_b_13;
            texels_1_odd_odd_b_14 <= texels_1_odd_odd_b_13;
        end
    end

    // ===== Stage 14: registers only
    reg [17:0] in_gain1r_15;
    reg [17:0] in_gain1g_15;
    reg [17:0] in_gain1b_15;
    reg [17:0] nl1_15;
    reg column1_is_odd_15;
    reg [7:0] texels_1_even_even_r_15;
    reg [7:0] texels_1_even_odd_r_15;
    reg [7:0] texels_1_odd_even_r_15;
    reg [7:0] texels_1_odd_odd_r_15;
    reg weight1_of_0_15;
    reg weight1_of_1_15;
    reg weight1_of_2_15;
    reg weight1_of_3_15;
    reg blend1_whole_15;
    reg blend1_of_0_15;
    reg blend1_of_1_15;
    reg blend1_of_2_15;
    reg blend1_of_3_15;
    reg [7:0] texels_1_even_even_g_15;
    reg [7:0] texels_1_even_odd_g_15;
    reg [7:0] texels_1_odd_even_g_15;
    reg [7:0] texels_1_odd_odd_g_15;
    reg [7:0] texels_1_even_even_b_15;
    reg [7:0] texels_1_even_odd_b_15;
    reg [7:0] texels_1_odd_even_b_15;
    reg [7:0] texels_1_odd_odd_b_15;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_15 <= in_gain1r_14;
            in_gain1g_15 <= in_gain1g_14;
            in_gain1b_15 <= in_gain1b_14;
            nl1_15 <= nl1_14;
            column1_is_odd_15 <= column1_is_odd_14;
            texels_1_even_even_r_15 <= texels_1_even_even_r_14;
            texels_1_even_odd_r_15 <= texels_1_even_odd_r_14;
            texels_1_odd_even_r_15 <= texels_1_odd_even_r_14;
            texels_1_odd_odd_r_15 <= texels_1_odd_odd_r_14;
            weight1_of_0_15 <= weight1_of_0_14;
            weight1_of_1_15 <= weight1_of_1_14;
            weight1_of_2_15 <= weight1_of_2_14;
            weight1_of_3_15 <= weight1_of_3_14;
            blend1_whole_15 <= blend1_whole_14;
            blend1_of_0_15 <= blend1_of_0_14;
            blend1_of_1_15 <= blend1_of_1_14;
            blend1_of_2_15 <= blend1_of_2_14;
            blend1_of_3_15 <= blend1_of_3_14;
            texels_1_even_even_g_15 <= texels_1_even_even_g_14;
            texels_1_even_odd_g_15 <= texels_1_even_odd_g_14;
            texels_1_odd_even_g_15 <= texels_1_odd_even_g_14;
            texels_1_odd_odd_g_15 <= texels_1_odd_odd_g_14;
            texels_1_even_even_b_15 <= texels_1_even_even_b_14;
            texels_1_even_odd_b_15 <= texels_1_even_odd_b_14;
            texels_1_odd_even_b_15 <= texels_1_odd_even_b_14;
            texels_1_odd_odd_b_15 <= texels_1_odd_odd_b_14;
        end
    end

    // ===== Stage 15: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 40 more
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_first_15 =
        column1_is_odd_15 ? texels_1_even_odd_r_15 : texels_1_even_even_r_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_0_by_first_15 = blend1_r_1_0_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_0_15 =
        weight1_of_0_15 ? texels_1_even_odd_r_15 : texels_1_even_even_r_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_0_by_0_15 = blend1_r_1_0_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_1_15 =
        weight1_of_1_15 ? texels_1_even_odd_r_15 : texels_1_even_even_r_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_0_by_1_15 = blend1_r_1_0_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_2_15 =
        weight1_of_2_15 ? texels_1_even_odd_r_15 : texels_1_even_even_r_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_0_by_2_15 = blend1_r_1_0_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_0_either_3_15 =
        weight1_of_3_15 ? texels_1_even_odd_r_15 : texels_1_even_even_r_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_0_by_3_15 = blend1_r_1_0_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_r_1_0_sum_1_0_15 =
        {1'd0, blend1_r_1_0_by_first_15} + {1'd0, blend1_r_1_0_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_0_sum_1_1_15 =
        {2'd0, blend1_r_1_0_by_1_15} + {1'd0, blend1_r_1_0_by_2_15, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_first_15 =
        column1_is_odd_15 ? texels_1_odd_odd_r_15 : texels_1_odd_even_r_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_1_by_first_15 = blend1_r_1_1_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_0_15 =
        weight1_of_0_15 ? texels_1_odd_odd_r_15 : texels_1_odd_even_r_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_r_1_1_by_0_15 = blend1_r_1_1_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_1_15 =
        weight1_of_1_15 ? texels_1_odd_odd_r_15 : texels_1_odd_even_r_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_r_1_1_by_1_15 = blend1_r_1_1_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_2_15 =
        weight1_of_2_15 ? texels_1_odd_odd_r_15 : texels_1_odd_even_r_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_r_1_1_by_2_15 = blend1_r_1_1_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_r_1_1_either_3_15 =
        weight1_of_3_15 ? texels_1_odd_odd_r_15 : texels_1_odd_even_r_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_r_1_1_by_3_15 = blend1_r_1_1_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_r_1_1_sum_1_0_15 =
        {1'd0, blend1_r_1_1_by_first_15} + {1'd0, blend1_r_1_1_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_r_1_1_sum_1_1_15 =
        {2'd0, blend1_r_1_1_by_1_15} + {1'd0, blend1_r_1_1_by_2_15, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_first_15 =
        column1_is_odd_15 ? texels_1_even_odd_g_15 : texels_1_even_even_g_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_0_by_first_15 = blend1_g_1_0_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_0_15 =
        weight1_of_0_15 ? texels_1_even_odd_g_15 : texels_1_even_even_g_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_0_by_0_15 = blend1_g_1_0_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_1_15 =
        weight1_of_1_15 ? texels_1_even_odd_g_15 : texels_1_even_even_g_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_0_by_1_15 = blend1_g_1_0_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_2_15 =
        weight1_of_2_15 ? texels_1_even_odd_g_15 : texels_1_even_even_g_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_0_by_2_15 = blend1_g_1_0_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_0_either_3_15 =
        weight1_of_3_15 ? texels_1_even_odd_g_15 : texels_1_even_even_g_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_0_by_3_15 = blend1_g_1_0_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_g_1_0_sum_1_0_15 =
        {1'd0, blend1_g_1_0_by_first_15} + {1'd0, blend1_g_1_0_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_0_sum_1_1_15 =
        {2'd0, blend1_g_1_0_by_1_15} + {1'd0, blend1_g_1_0_by_2_15, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_first_15 =
        column1_is_odd_15 ? texels_1_odd_odd_g_15 : texels_1_odd_even_g_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_1_by_first_15 = blend1_g_1_1_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_0_15 =
        weight1_of_0_15 ? texels_1_odd_odd_g_15 : texels_1_odd_even_g_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_g_1_1_by_0_15 = blend1_g_1_1_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_1_15 =
        weight1_of_1_15 ? texels_1_odd_odd_g_15 : texels_1_odd_even_g_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_g_1_1_by_1_15 = blend1_g_1_1_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_2_15 =
        weight1_of_2_15 ? texels_1_odd_odd_g_15 : texels_1_odd_even_g_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_g_1_1_by_2_15 = blend1_g_1_1_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_g_1_1_either_3_15 =
        weight1_of_3_15 ? texels_1_odd_odd_g_15 : texels_1_odd_even_g_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_g_1_1_by_3_15 = blend1_g_1_1_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_g_1_1_sum_1_0_15 =
        {1'd0, blend1_g_1_1_by_first_15} + {1'd0, blend1_g_1_1_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_g_1_1_sum_1_1_15 =
        {2'd0, blend1_g_1_1_by_1_15} + {1'd0, blend1_g_1_1_by_2_15, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_first_15 =
        column1_is_odd_15 ? texels_1_even_odd_b_15 : texels_1_even_even_b_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_0_by_first_15 = blend1_b_1_0_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_0_15 =
        weight1_of_0_15 ? texels_1_even_odd_b_15 : texels_1_even_even_b_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_0_by_0_15 = blend1_b_1_0_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_1_15 =
        weight1_of_1_15 ? texels_1_even_odd_b_15 : texels_1_even_even_b_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_0_by_1_15 = blend1_b_1_0_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_2_15 =
        weight1_of_2_15 ? texels_1_even_odd_b_15 : texels_1_even_even_b_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_0_by_2_15 = blend1_b_1_0_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_0_either_3_15 =
        weight1_of_3_15 ? texels_1_even_odd_b_15 : texels_1_even_even_b_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_0_by_3_15 = blend1_b_1_0_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_b_1_0_sum_1_0_15 =
        {1'd0, blend1_b_1_0_by_first_15} + {1'd0, blend1_b_1_0_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_0_sum_1_1_15 =
        {2'd0, blend1_b_1_0_by_1_15} + {1'd0, blend1_b_1_0_by_2_15, 1'd0};
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_first_15 =
        column1_is_odd_15 ? texels_1_odd_odd_b_15 : texels_1_odd_even_b_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_1_by_first_15 = blend1_b_1_1_either_first_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_0_15 =
        weight1_of_0_15 ? texels_1_odd_odd_b_15 : texels_1_odd_even_b_15;
    // UQ-4.12: shifted
    wire [7:0] blend1_b_1_1_by_0_15 = blend1_b_1_1_either_0_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_1_15 =
        weight1_of_1_15 ? texels_1_odd_odd_b_15 : texels_1_odd_even_b_15;
    // UQ-3.11: shifted
    wire [7:0] blend1_b_1_1_by_1_15 = blend1_b_1_1_either_1_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_2_15 =
        weight1_of_2_15 ? texels_1_odd_odd_b_15 : texels_1_odd_even_b_15;
    // UQ-2.10: shifted
    wire [7:0] blend1_b_1_1_by_2_15 = blend1_b_1_1_either_2_15;
    // UQ0.8: either of both
    wire [7:0] blend1_b_1_1_either_3_15 =
        weight1_of_3_15 ? texels_1_odd_odd_b_15 : texels_1_odd_even_b_15;
    // UQ-1.9: shifted
    wire [7:0] blend1_b_1_1_by_3_15 = blend1_b_1_1_either_3_15;
    // UQ-3.12: the sum of two
    wire [8:0] blend1_b_1_1_sum_1_0_15 =
        {1'd0, blend1_b_1_1_by_first_15} + {1'd0, blend1_b_1_1_by_0_15};
    // UQ-1.11: the sum of two
    wire [9:0] blend1_b_1_1_sum_1_1_15 =
        {2'd0, blend1_b_1_1_by_1_15} + {1'd0, blend1_b_1_1_by_2_15, 1'd0};
    reg [17:0] in_gain1r_16;
    reg [17:0] in_gain1g_16;
    reg [17:0] in_gain1b_16;
    reg [17:0] nl1_16;
    reg [7:0] blend1_r_1_0_by_3_16;
    reg [8:0] blend1_r_1_0_sum_1_0_16;
    reg [9:0] blend1_r_1_0_sum_1_1_16;
    reg [7:0] blend1_r_1_1_by_3_16;
    reg [8:0] blend1_r_1_1_sum_1_0_16;
    reg [9:0] blend1_r_1_1_sum_1_1_16;
    reg blend1_whole_16;
    reg blend1_of_0_16;
    reg blend1_of_1_16;
    reg blend1_of_2_16;
    reg blend1_of_3_16;
    reg [7:0] blend1_g_1_0_by_3_16;
    reg [8:0] blend1_g_1_0_sum_1_0_16;
    reg [9:0] blend1_g_1_0_sum_1_1_16;
    reg [7:0] blend1_g_1_1_by_3_16;
    reg [8:0] blend1_g_1_1_sum_1_0_16;
    reg [9:0] blend1_g_1_1_sum_1_1_16;
    reg [7:0] blend1_b_1_0_by_3_16;
    reg [8:0] blend1_b_1_0_sum_1_0_16;
    reg [9:0] blend1_b_1_0_sum_1_1_16;
    reg [7:0] blend1_b_1_1_by_3_16;
    reg [8:0] blend1_b_1_1_sum_1_0_16;
    reg [9:0] blend1_b_1_1_sum_1_1_16;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_16 <= in_gain1r_15;
            in_gain1g_16 <= in_gain1g_15;
            in_gain1b_16 <= in_gain1b_15;
            nl1_16 <= nl1_15;
            blend1_r_1_0_by_3_16 <= blend1_r_1_0_by_3_15;
            blend1_r_1_0_sum_1_0_16 <= blend1_r_1_0_sum_1_0_15;
            blend1_r_1_0_sum_1_1_16 <= blend1_r_1_0_sum_1_1_15;
            blend1_r_1_1_by_3_16 <= blend1_r_1_1_by_3_15;
            blend1_r_1_1_sum_1_0_16 <= blend1_r_1_1_sum_1_0_15;
            blend1_r_1_1_sum_1_1_16 <= blend1_r_1_1_sum_1_1_15;
            blend1_whole_16 <= blend1_whole_15;
            blend1_of_0_16 <= blend1_of_0_15;
            blend1_of_1_16 <= blend1_of_1_15;
            blend1_of_2_16 <= blend1_of_2_15;
            blend1_of_3_16 <= blend1_of_3_15;
            blend1_g_1_0_by_3_16 <= blend1_g_1_0_by_3_15;
            blend1_g_1_0_sum_1_0_16 <= blend1_g_1_0_sum_1_0_15;
            blend1_g_1_0_sum_1_1_16 <= blend1_g_1_0_sum_1_1_15;
            blend1_g_1_1_by_3_16 <= blend1_g_1_1_by_3_15;
            blend1_g_1_1_sum_1_0_16 <= blend1_g_1_1_sum_1_0_15;
            blend1_g_1_1_sum_1_1_16 <= blend1_g_1_1_sum_1_1_15;
            blend1_b_1_0_by_3_16 <= blend1_b_1_0_by_3_15;
            blend1_b_1_0_sum_1_0_16 <= blend1_b_1_0_sum_1_0_15;
            blend1_b_1_0_sum_1_1_16 <= blend1_b_1_0_sum_1_1_15;
            blend1_b_1_1_by_3_16 <= blend1_b_1_1_by_3_15;
            blend1_b_1_1_sum_1_0_16 <= blend1_b_1_1_sum_1_0_15;
            blend1_b_1_1_sum_1_1_16 <= blend1_b_1_1_sum_1_1_15;
        end
    end

    // ===== Stage 16: blend1_r_1_0_sum_2_0, blend1_r_1_1_sum_2_0 and 4 more
    // UQ-1.12: the sum of two
    wire [10:0] blend1_r_1_0_sum_2_0_16 =
        {2'd0, blend1_r_1_0_sum_1_0_16} + {blend1_r_1_0_sum_1_1_16, 1'd0};
    // UQ-1.12: the sum of two
    wire [10:0] blend1_r_1_1_sum_2_0_16 =
        {2'd0, blend1_r_1_1_sum_1_0_16} + {blend1_r_1_1_sum_1_1_16, 1'd0};
    // UQ-1.12: the sum of two
    wire [10:0] blend1_g_1_0_sum_2_0_16 =
        {2'd0, blend1_g_1_0_sum_1_0_16} + {blend1_g_1_0_sum_1_1_16, 1'd0};
    // UQ-1.12: the sum of two
    wire [10:0] blend1_g_1_1_sum_2_0_16 =
        {2'd0, blend1_g_1_1_sum_1_0_16} + {blend1_g_1_1_sum_1_1_16, 1'd0};
    // UQ-1.12: the sum of two
    wire [10:0] blend1_b_1_0_sum_2_0_16 =
        {2'd0, blend1_b_1_0_sum_1_0_16} + {blend1_b_1_0_sum_1_1_16, 1'd0};
    // UQ-1.12: the sum of two
    wire [10:0] blend1_b_1_1_sum_2_0_16 =
        {2'd0, blend1_b_1_1_sum_1_0_16} + {blend1_b_1_1_sum_1_1_16, 1'd0};
    reg [17:0] in_gain1r_17;
    reg [17:0] in_gain1g_17;
    reg [17:0] in_gain1b_17;
    reg [17:0] nl1_17;
    reg [7:0] blend1_r_1_0_by_3_17;
    reg [10:0] blend1_r_1_0_sum_2_0_17;
    reg [7:0] blend1_r_1_1_by_3_17;
    reg [10:0] blend1_r_1_1_sum_2_0_17;
    reg blend1_whole_17;
    reg blend1_of_0_17;
    reg blend1_of_1_17;
    reg blend1_of_2_17;
    reg blend1_of_3_17;
    reg [7:0] blend1_g_1_0_by_3_17;
    reg [10:0] blend1_g_1_0_sum_2_0_17;
    reg [7:0] blend1_g_1_1_by_3_17;
    reg [10:0] blend1_g_1_1_sum_2_0_17;
    reg [7:0] blend1_b_1_0_by_3_17;
    reg [10:0] blend1_b_1_0_sum_2_0_17;
    reg [7:0] blend1_b_1_1_by_3_17;
    reg [10:0] blend1_b_1_1_sum_2_0_17;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_17 <= in_gain1r_16;
            in_gain1g_17 <= in_gain1g_16;
            in_gain1b_17 <= in_gain1b_16;
            nl1_17 <= nl1_16;
            blend1_r_1_0_by_3_17 <= blend1_r_1_0_by_3_16;
            blend1_r_1_0_sum_2_0_17 <= blend1_r_1_0_sum_2_0_16;
            blend1_r_1_1_by_3_17 <= blend1_r_1_1_by_3_16;
            blend1_r_1_1_sum_2_0_17 <= blend1_r_1_1_sum_2_0_16;
            blend1_whole_17 <= blend1_whole_16;
            blend1_of_0_17 <= blend1_of_0_16;
            blend1_of_1_17 <= blend1_of_1_16;
            blend1_of_2_17 <= blend1_of_2_16;
            blend1_of_3_17 <= blend1_of_3_16;
            blend1_g_1_0_by_3_17 <= blend1_g_1_0_by_3_16;
            blend1_g_1_0_sum_2_0_17 <= blend1_g_1_0_sum_2_0_16;
            blend1_g_1_1_by_3_17 <= blend1_g_1_1_by_3_16;
            blend1_g_1_1_sum_2_0_17 <= blend1_g_1_1_sum_2_0_16;
            blend1_b_1_0_by_3_17 <= blend1_b_1_0_by_3_16;
            blend1_b_1_0_sum_2_0_17 <= blend1_b_1_0_sum_2_0_16;
            blend1_b_1_1_by_3_17 <= blend1_b_1_1_by_3_16;
            blend1_b_1_1_sum_2_0_17 <= blend1_b_1_1_sum_2_0_16;
        end
    end

    // ===== Stage 17: blend1_r_1_0, blend1_r_1_1, blend1_r_2_0_either_first and 18 more
    // UQ0.12: two neighbours
    wire [11:0] blend1_r_1_0_17 =
        {1'd0, blend1_r_1_0_sum_2_0_17} + {1'd0, blend1_r_1_0_by_3_17, 3'd0};
    // UQ0.12: two neighbours
    wire [11:0] blend1_r_1_1_17 =
        {1'd0, blend1_r_1_1_sum_2_0_17} + {1'd0, blend1_r_1_1_by_3_17, 3'd0};
    // UQ0.12: either of both
    wire [11:0] blend1_r_2_0_either_first_17 = blend1_whole_17 ? blend1_r_1_1_17 : blend1_r_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_r_2_0_by_first_17 = blend1_r_2_0_either_first_17;
    // UQ0.12: either of both
    wire [11:0] blend1_r_2_0_either_0_17 = blend1_of_0_17 ? blend1_r_1_1_17 : blend1_r_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_r_2_0_by_0_17 = blend1_r_2_0_either_0_17;
    // UQ0.12: either of both
    wire [11:0] blend1_r_2_0_either_1_17 = blend1_of_1_17 ? blend1_r_1_1_17 : blend1_r_1_0_17;
    // UQ-3.15: shifted
    wire [11:0] blend1_r_2_0_by_1_17 = blend1_r_2_0_either_1_17;
    // UQ0.12: either of both
    wire [11:0] blend1_r_2_0_either_2_17 = blend1_of_2_17 ? blend1_r_1_1_17 : blend1_r_1_0_17;
    // UQ-2.14: shifted
    wire [11:0] blend1_r_2_0_by_2_17 = blend1_r_2_0_either_2_17;
    // UQ0.12: either of both
    wire [11:0] blend1_r_2_0_either_3_17 = blend1_of_3_17 ? blend1_r_1_1_17 : blend1_r_1_0_17;
    // UQ-1.13: shifted
    wire [11:0] blend1_r_2_0_by_3_17 = blend1_r_2_0_either_3_17;
    // UQ0.12: two neighbours
    wire [11:0] blend1_g_1_0_17 =
        {1'd0, blend1_g_1_0_sum_2_0_17} + {1'd0, blend1_g_1_0_by_3_17, 3'd0};
    // UQ0.12: two neighbours
    wire [11:0] blend1_g_1_1_17 =
        {1'd0, blend1_g_1_1_sum_2_0_17} + {1'd0, blend1_g_1_1_by_3_17, 3'd0};
    // UQ0.12: either of both
    wire [11:0] blend1_g_2_0_either_first_17 = blend1_whole_17 ? blend1_g_1_1_17 : blend1_g_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_g_2_0_by_first_17 = blend1_g_2_0_either_first_17;
    // UQ0.12: either of both
    wire [11:0] blend1_g_2_0_either_0_17 = blend1_of_0_17 ? blend1_g_1_1_17 : blend1_g_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_g_2_0_by_0_17 = blend1_g_2_0_either_0_17;
    // UQ0.12: either of both
    wire [11:0] blend1_g_2_0_either_1_17 = blend1_of_1_17 ? blend1_g_1_1_17 : blend1_g_1_0_17;
    // UQ-3.15: shifted
    wire [11:0] blend1_g_2_0_by_1_17 = blend1_g_2_0_either_1_17;
    // UQ0.12: either of both
    wire [11:0] blend1_g_2_0_either_2_17 = blend1_of_2_17 ? blend1_g_1_1_17 : blend1_g_1_0_17;
    // UQ-2.14: shifted
    wire [11:0] blend1_g_2_0_by_2_17 = blend1_g_2_0_either_2_17;
    // UQ0.12: either of both
    wire [11:0] blend1_g_2_0_either_3_17 = blend1_of_3_17 ? blend1_g_1_1_17 : blend1_g_1_0_17;
    // UQ-1.13: shifted
    wire [11:0] blend1_g_2_0_by_3_17 = blend1_g_2_0_either_3_17;
    // UQ0.12: two neighbours
    wire [11:0] blend1_b_1_0_17 =
        {1'd0, blend1_b_1_0_sum_2_0_17} + {1'd0, blend1_b_1_0_by_3_17, 3'd0};
    // UQ0.12: two neighbours
    wire [11:0] blend1_b_1_1_17 =
        {1'd0, blend1_b_1_1_sum_2_0_17} + {1'd0, blend1_b_1_1_by_3_17, 3'd0};
    // UQ0.12: either of both
    wire [11:0] blend1_b_2_0_either_first_17 = blend1_whole_17 ? blend1_b_1_1_17 : blend1_b_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_b_2_0_by_first_17 = blend1_b_2_0_either_first_17;
    // UQ0.12: either of both
    wire [11:0] blend1_b_2_0_either_0_17 = blend1_of_0_17 ? blend1_b_1_1_17 : blend1_b_1_0_17;
    // UQ-4.16: shifted
    wire [11:0] blend1_b_2_0_by_0_17 = blend1_b_2_0_either_0_17;
    // UQ0.12: either of both
    wire [11:0] blend1_b_2_0_either_1_17 = blend1_of_1_17 ? blend1_b_1_1_17 : blend1_b_1_0_17;
    // UQ-3.15: shifted
    wire [11:0] blend1_b_2_0_by_1_17 = blend1_b_2_0_either_1_17;
    // UQ0.12: either of both
    wire [11:0] blend1_b_2_0_either_2_17 = blend1_of_2_17 ? blend1_b_1_1_17 : blend1_b_1_0_17;
    // UQ-2.14: shifted
    wire [11:0] blend1_b_2_0_by_2_17 = blend1_b_2_0_either_2_17;
    // UQ0.12: either of both
    wire [11:0] blend1_b_2_0_either_3_17 = blend1_of_3_17 ? blend1_b_1_1_17 : blend1_b_1_0_17;
    // UQ-1.13: shifted
    wire [11:0] blend1_b_2_0_by_3_17 = blend1_b_2_0_either_3_17;
    reg [17:0] in_gain1r_18;
    reg [17:0] in_gain1g_18;
    reg [17:0] in_gain1b_18;
    reg [17:0] nl1_18;
    reg [11:0] blend1_r_2_0_by_first_18;
    reg [11:0] blend1_r_2_0_by_0_18;
    reg [11:0] blend1_r_2_0_by_1_18;
    reg [11:0] blend1_r_2_0_by_2_18;
    reg [11:0] blend1_r_2_0_by_3_18;
    reg [11:0] blend1_g_2_0_by_first_18;
    reg [11:0] blend1_g_2_0_by_0_18;
    reg [11:0] blend1_g_2_0_by_1_18;
    reg [11:0] blend1_g_2_0_by_2_18;
    reg [11:0] blend1_g_2_0_by_3_18;
    reg [11:0] blend1_b_2_0_by_first_18;
    reg [11:0] blend1_b_2_0_by_0_18;
    reg [11:0] blend1_b_2_0_by_1_18;
    reg [11:0] blend1_b_2_0_by_2_18;
    reg [11:0] blend1_b_2_0_by_3_18;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_18 <= in_gain1r_17;
            in_gain1g_18 <= in_gain1g_17;
            in_gain1b_18 <= in_gain1b_17;
            nl1_18 <= nl1_17;
            blend1_r_2_0_by_first_18 <= blend1_r_2_0_by_first_17;
            blend1_r_2_0_by_0_18 <= blend1_r_2_0_by_0_17;
            blend1_r_2_0_by_1_18 <= blend1_r_2_0_by_1_17;
            blend1_r_2_0_by_2_18 <= blend1_r_2_0_by_2_17;
            blend1_r_2_0_by_3_18 <= blend1_r_2_0_by_3_17;
            blend1_g_2_0_by_first_18 <= blend1_g_2_0_by_first_17;
            blend1_g_2_0_by_0_18 <= blend1_g_2_0_by_0_17;
            blend1_g_2_0_by_1_18 <= blend1_g_2_0_by_1_17;
            blend1_g_2_0_by_2_18 <= blend1_g_2_0_by_2_17;
            blend1_g_2_0_by_3_18 <= blend1_g_2_0_by_3_17;
            blend1_b_2_0_by_first_18 <= blend1_b_2_0_by_first_17;
            blend1_b_2_0_by_0_18 <= blend1_b_2_0_by_0_17;
            blend1_b_2_0_by_1_18 <= blend1_b_2_0_by_1_17;
            blend1_b_2_0_by_2_18 <= blend1_b_2_0_by_2_17;
            blend1_b_2_0_by_3_18 <= blend1_b_2_0_by_3_17;
        end
    end

    // ===== Stage 18: blend1_r_2_0_sum_1_0, blend1_r_2_0_sum_1_1 and 4 more
    // UQ-3.16: the sum of two
    wire [12:0] blend1_r_2_0_sum_1_0_18 =
        {1'd0, blend1_r_2_0_by_first_18} + {1'd0, blend1_r_2_0_by_0_18};
    // UQ-1.15: the sum of two
    wire [13:0] blend1_r_2_0_sum_1_1_18 =
        {2'd0, blend1_r_2_0_by_1_18} + {1'd0, blend1_r_2_0_by_2_18, 1'd0};
    // UQ-3.16: the sum of two
    wire [12:0] blend1_g_2_0_sum_1_0_18 =
        {1'd0, blend1_g_2_0_by_first_18} + {1'd0, blend1_g_2_0_by_0_18};
    // UQ-1.15: the sum of two
    wire [13:0] blend1_g_2_0_sum_1_1_18 =
        {2'd0, blend1_g_2_0_by_1_18} + {1'd0, blend1_g_2_0_by_2_18, 1'd0};
    // UQ-3.16: the sum of two
    wire [12:0] blend1_b_2_0_sum_1_0_18 =
        {1'd0, blend1_b_2_0_by_first_18} + {1'd0, blend1_b_2_0_by_0_18};
    // UQ-1.15: the sum of two
    wire [13:0] blend1_b_2_0_sum_1_1_18 =
        {2'd0, blend1_b_2_0_by_1_18} + {1'd0, blend1_b_2_0_by_2_18, 1'd0};
    reg [17:0] in_gain1r_19;
    reg [17:0] in_gain1g_19;
    reg [17:0] in_gain1b_19;
    reg [17:0] nl1_19;
    reg [11:0] blend1_r_2_0_by_3_19;
    reg [12:0] blend1_r_2_0_sum_1_0_19;
    reg [13:0] blend1_r_2_0_sum_1_1_19;
    reg [11:0] blend1_g_2_0_by_3_19;
    reg [12:0] blend1_g_2_0_sum_1_0_19;
    reg [13:0] blend1_g_2_0_sum_1_1_19;
    reg [11:0] blend1_b_2_0_by_3_19;
    reg [12:0] blend1_b_2_0_sum_1_0_19;
    reg [13:0] blend1_b_2_0_sum_1_1_19;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_19 <= in_gain1r_18;
            in_gain1g_19 <= in_gain1g_18;
            in_gain1b_19 <= in_gain1b_18;
            nl1_19 <= nl1_18;
            blend1_r_2_0_by_3_19 <= blend1_r_2_0_by_3_18;
            blend1_r_2_0_sum_1_0_19 <= blend1_r_2_0_sum_1_0_18;
            blend1_r_2_0_sum_1_1_19 <= blend1_r_2_0_sum_1_1_18;
            blend1_g_2_0_by_3_19 <= blend1_g_2_0_by_3_18;
            blend1_g_2_0_sum_1_0_19 <= blend1_g_2_0_sum_1_0_18;
            blend1_g_2_0_sum_1_1_19 <= blend1_g_2_0_sum_1_1_18;
            blend1_b_2_0_by_3_19 <= blend1_b_2_0_by_3_18;
            blend1_b_2_0_sum_1_0_19 <= blend1_b_2_0_sum_1_0_18;
            blend1_b_2_0_sum_1_1_19 <= blend1_b_2_0_sum_1_1_18;
        end
    end

    // ===== Stage 19: blend1_r_2_0_sum_2_0, blend1_g_2_0_sum_2_0 and 1 more
    // UQ-1.16: the sum of two
    wire [14:0] blend1_r_2_0_sum_2_0_19 =
        {2'd0, blend1_r_2_0_sum_1_0_19} + {blend1_r_2_0_sum_1_1_19, 1'd0};
    // UQ-1.16: the sum of two
    wire [14:0] blend1_g_2_0_sum_2_0_19 =
        {2'd0, blend1_g_2_0_sum_1_0_19} + {blend1_g_2_0_sum_1_1_19, 1'd0};
    // UQ-1.16: the sum of two
    wire [14:0] blend1_b_2_0_sum_2_0_19 =
        {2'd0, blend1_b_2_0_sum_1_0_19} + {blend1_b_2_0_sum_1_1_19, 1'd0};
    reg [17:0] in_gain1r_20;
    reg [17:0] in_gain1g_20;
    reg [17:0] in_gain1b_20;
    reg [17:0] nl1_20;
    reg [11:0] blend1_r_2_0_by_3_20;
    reg [14:0] blend1_r_2_0_sum_2_0_20;
    reg [11:0] blend1_g_2_0_by_3_20;
    reg [14:0] blend1_g_2_0_sum_2_0_20;
    reg [11:0] blend1_b_2_0_by_3_20;
    reg [14:0] blend1_b_2_0_sum_2_0_20;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_20 <= in_gain1r_19;
            in_gain1g_20 <= in_gain1g_19;
            in_gain1b_20 <= in_gain1b_19;
            nl1_20 <= nl1_19;
            blend1_r_2_0_by_3_20 <= blend1_r_2_0_by_3_19;
            blend1_r_2_0_sum_2_0_20 <= blend1_r_2_0_sum_2_0_19;
            blend1_g_2_0_by_3_20 <= blend1_g_2_0_by_3_19;
            blend1_g_2_0_sum_2_0_20 <= blend1_g_2_0_sum_2_0_19;
            blend1_b_2_0_by_3_20 <= blend1_b_2_0_by_3_19;
            blend1_b_2_0_sum_2_0_20 <= blend1_b_2_0_sum_2_0_19;
        end
    end

    // ===== Stage 20: blend1_r_2_0, blend1_g_2_0, blend1_b_2_0
    // UQ0.16: two bands
    wire [15:0] blend1_r_2_0_20 =
        {1'd0, blend1_r_2_0_sum_2_0_20} + {1'd0, blend1_r_2_0_by_3_20, 3'd0};
    // UQ0.16: two bands
    wire [15:0] blend1_g_2_0_20 =
        {1'd0, blend1_g_2_0_sum_2_0_20} + {1'd0, blend1_g_2_0_by_3_20, 3'd0};
    // UQ0.16: two bands
    wire [15:0] blend1_b_2_0_20 =
        {1'd0, blend1_b_2_0_sum_2_0_20} + {1'd0, blend1_b_2_0_by_3_20, 3'd0};
    reg [17:0] in_gain1r_21;
    reg [17:0] in_gain1g_21;
    reg [17:0] in_gain1b_21;
    reg [17:0] nl1_21;
    reg [15:0] blend1_r_2_0_21;
    reg [15:0] blend1_g_2_0_21;
    reg [15:0] blend1_b_2_0_21;
    always @(posedge clk) begin
        if (ce) begin
            in_gain1r_21 <= in_gain1r_20;
            in_gain1g_21 <= in_gain1g_20;
            in_gain1b_21 <= in_gain1b_20;
            nl1_21 <= nl1_20;
            blend1_r_2_0_21 <= blend1_r_2_0_20;
            blend1_g_2_0_21 <= blend1_g_2_0_20;
            blend1_b_2_0_21 <= blend1_b_2_0_20;
        end
    end

    // ===== Stage 21: square1_r_exact, square1_g_exact, square1_b_exact
    // UQ0.32: its square
    wire [31:0] square1_r_exact_21 = blend1_r_2_0_21 * blend1_r_2_0_21;
    // UQ0.18: rounded down
    wire [17:0] square1_r_21 = square1_r_exact_21[31:14];
    // UQ0.32: its square
    wire [31:0] square1_g_exact_21 = blend1_g_2_0_21 * blend1_g_2_0_21;
    // UQ0.18: rounded down
    wire [17:0] square1_g_21 = square1_g_exact_21[31:14];
    // UQ0.32: its square
    wire [31:0] square1_b_exact_21 = blend1_b_2_0_21 * blend1_b_2_0_21;
    // UQ0.18: rounded down
    wire [17:0] square1_b_21 = square1_b_exact_21[31:14];
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
                    dd1_x_exact_2[15:0],
                    dd1_y_exact_2[15:0],
                    dd1_z_exact_2[15:0],
                    u1_exact_4[3:0],
                    u1_twice_6[12],
                    rest1_6[6:0],
                    column1_next_10[0],
                    square1_r_exact_21[13:0],
                    lit1_r_exact_23[17:0],
                    light1_r_exact_25[10:0],
                    square1_g_exact_21[13:0],
                    lit1_g_exact_23[17:0],
                    light1_g_exact_25[10:0],
                    square1_b_exact_21[13:0],
                    lit1_b_exact_23[17:0],
                    light1_b_exact_25[10:0]};

endmodule

`default_nettype wire
