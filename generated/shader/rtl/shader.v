// shader: Phong shader, 2 lights, 4 materials, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec ef73cb5e346c03ce. Generated; the core is yours to use under any terms.
//
//   in_material UQ2.0   index of the material, 0 to 3; above: the last
//   in_nx       Q1.16   x of the normal N, of unit length
//   in_ny       Q1.16   y of the normal N, of unit length
//   in_nz       Q1.16   z of the normal N, of unit length
//   in_vx       Q1.16   x of the unit vector V to the viewer
//   in_vy       Q1.16   y of the unit vector V to the viewer
//   in_vz       Q1.16   z of the unit vector V to the viewer
//   in_l1x      Q1.16   x of the unit vector L to light 1
//   in_l1y      Q1.16   y of the unit vector L to light 1
//   in_l1z      Q1.16   z of the unit vector L to light 1
//   in_l2x      Q1.16   x of the unit vector L to light 2
//   in_l2y      Q1.16   y of the unit vector L to light 2
//   in_l2z      Q1.16   z of the unit vector L to light 2
//   out_r       UQ8.0   red; 255 is full scale
//   out_g       UQ8.0   green; 255 is full scale
//   out_b       UQ8.0   blue; 255 is full scale
//
// Latency 16 clocks, one result a clock.
// Error against the exact shader, in codes of a channel, over 262144 samples:
//   -61.201..+5.929, root mean square 8.984.

`timescale 1ns / 1ps
`default_nettype none

module shader (
    // clock; everything happens on its rising edge
    input  wire        clk,
    // synchronous reset, active high: clears the valid chain, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // the other inputs are to be taken
    input  wire        in_valid,
    // UQ2.0: index of the material, 0 to 3; above: the last
    input  wire [1:0] in_material,
    // Q1.16: x of the normal N, of unit length
    input  wire [17:0] in_nx,
    // Q1.16: y of the normal N, of unit length
    input  wire [17:0] in_ny,
    // Q1.16: z of the normal N, of unit length
    input  wire [17:0] in_nz,
    // Q1.16: x of the unit vector V to the viewer
    input  wire [17:0] in_vx,
    // Q1.16: y of the unit vector V to the viewer
    input  wire [17:0] in_vy,
    // Q1.16: z of the unit vector V to the viewer
    input  wire [17:0] in_vz,
    // Q1.16: x of the unit vector L to light 1
    input  wire [17:0] in_l1x,
    // Q1.16: y of the unit vector L to light 1
    input  wire [17:0] in_l1y,
    // Q1.16: z of the unit vector L to light 1
    input  wire [17:0] in_l1z,
    // Q1.16: x of the unit vector L to light 2
    input  wire [17:0] in_l2x,
    // Q1.16: y of the unit vector L to light 2
    input  wire [17:0] in_l2y,
    // Q1.16: z of the unit vector L to light 2
    input  wire [17:0] in_l2z,
    // the other outputs are a result: in_valid, 16 enabled clocks later
    output wire        out_valid,
    // UQ8.0: red; 255 is full scale
    output wire [7:0] out_r,
    // UQ8.0: green; 255 is full scale
    output wire [7:0] out_g,
    // UQ8.0: blue; 255 is full scale
    output wire [7:0] out_b
);

    // ===== Valid chain
    reg [16:1] valid;
    initial valid = 16'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 16'd0;
        end else if (ce) begin
            valid <= {valid[15:1], in_valid};
        end
    end

    // ===== Stage 0: nv_x, nv_y, nv_z, nl1_x, nl1_y, nl1_z, lv1_x, lv1_y, lv1_z and 6 more
    // Q3.32: N.V
    wire [35:0] nv_x_0 = $signed(in_nx) * $signed(in_vx);
    // Q3.32: N.V
    wire [35:0] nv_y_0 = $signed(in_ny) * $signed(in_vy);
    // Q3.32: N.V
    wire [35:0] nv_z_0 = $signed(in_nz) * $signed(in_vz);
    // Q3.32: N.L
    wire [35:0] nl1_x_0 = $signed(in_nx) * $signed(in_l1x);
    // Q3.32: N.L
    wire [35:0] nl1_y_0 = $signed(in_ny) * $signed(in_l1y);
    // Q3.32: N.L
    wire [35:0] nl1_z_0 = $signed(in_nz) * $signed(in_l1z);
    // Q3.32: L.V
    wire [35:0] lv1_x_0 = $signed(in_l1x) * $signed(in_vx);
    // Q3.32: L.V
    wire [35:0] lv1_y_0 = $signed(in_l1y) * $signed(in_vy);
    // Q3.32: L.V
    wire [35:0] lv1_z_0 = $signed(in_l1z) * $signed(in_vz);
    // Q3.32: N.L
    wire [35:0] nl2_x_0 = $signed(in_nx) * $signed(in_l2x);
    // Q3.32: N.L
    wire [35:0] nl2_y_0 = $signed(in_ny) * $signed(in_l2y);
    // Q3.32: N.L
    wire [35:0] nl2_z_0 = $signed(in_nz) * $signed(in_l2z);
    // Q3.32: L.V
    wire [35:0] lv2_x_0 = $signed(in_l2x) * $signed(in_vx);
    // Q3.32: L.V
    wire [35:0] lv2_y_0 = $signed(in_l2y) * $signed(in_vy);
    // Q3.32: L.V
    wire [35:0] lv2_z_0 = $signed(in_l2z) * $signed(in_vz);
    reg [1:0] in_material_1;
    reg [35:0] nv_x_1;
    reg [35:0] nv_y_1;
    reg [35:0] nv_z_1;
    reg [35:0] nl1_x_1;
    reg [35:0] nl1_y_1;
    reg [35:0] nl1_z_1;
    reg [35:0] lv1_x_1;
    reg [35:0] lv1_y_1;
    reg [35:0] lv1_z_1;
    reg [35:0] nl2_x_1;
    reg [35:0] nl2_y_1;
    reg [35:0] nl2_z_1;
    reg [35:0] lv2_x_1;
    reg [35:0] lv2_y_1;
    reg [35:0] lv2_z_1;
    always @(posedge clk) begin
        if (ce) begin
            in_material_1 <= in_material;
            nv_x_1 <= nv_x_0;
            nv_y_1 <= nv_y_0;
            nv_z_1 <= nv_z_0;
            nl1_x_1 <= nl1_x_0;
            nl1_y_1 <= nl1_y_0;
            nl1_z_1 <= nl1_z_0;
            lv1_x_1 <= lv1_x_0;
            lv1_y_1 <= lv1_y_0;
            lv1_z_1 <= lv1_z_0;
            nl2_x_1 <= nl2_x_0;
            nl2_y_1 <= nl2_y_0;
            nl2_z_1 <= nl2_z_0;
            lv2_x_1 <= lv2_x_0;
            lv2_y_1 <= lv2_y_0;
            lv2_z_1 <= lv2_z_0;
        end
    end

    // ===== Stage 1: read colours, nv_xy, nv_xyz, nl1_xy, nl1_xyz, lv1_xy and 5 more
    // The word of the memory colours, of 4 words.
    reg [155:0] colours_2;
    // Q4.32: N.V
    wire [36:0] nv_xy_1 = {{1{nv_x_1[35]}}, nv_x_1} + {{1{nv_y_1[35]}}, nv_y_1};
    // Q4.32: N.V
    wire [36:0] nv_xyz_1 = nv_xy_1 + {{1{nv_z_1[35]}}, nv_z_1};
    // Q4.18: N.V, rounded down
    wire [22:0] nv_cut_1 = nv_xyz_1[36:14];
    // Q4.32: N.L
    wire [36:0] nl1_xy_1 = {{1{nl1_x_1[35]}}, nl1_x_1} + {{1{nl1_y_1[35]}}, nl1_y_1};
    // Q4.32: N.L
    wire [36:0] nl1_xyz_1 = nl1_xy_1 + {{1{nl1_z_1[35]}}, nl1_z_1};
    // Q4.32: L.V
    wire [36:0] lv1_xy_1 = {{1{lv1_x_1[35]}}, lv1_x_1} + {{1{lv1_y_1[35]}}, lv1_y_1};
    // Q4.32: L.V
    wire [36:0] lv1_xyz_1 = lv1_xy_1 + {{1{lv1_z_1[35]}}, lv1_z_1};
    // Q4.18: L.V, rounded down
    wire [22:0] lv1_cut_1 = lv1_xyz_1[36:14];
    // Q4.32: N.L
    wire [36:0] nl2_xy_1 = {{1{nl2_x_1[35]}}, nl2_x_1} + {{1{nl2_y_1[35]}}, nl2_y_1};
    // Q4.32: N.L
    wire [36:0] nl2_xyz_1 = nl2_xy_1 + {{1{nl2_z_1[35]}}, nl2_z_1};
    // Q4.32: L.V
    wire [36:0] lv2_xy_1 = {{1{lv2_x_1[35]}}, lv2_x_1} + {{1{lv2_y_1[35]}}, lv2_y_1};
    // Q4.32: L.V
    wire [36:0] lv2_xyz_1 = lv2_xy_1 + {{1{lv2_z_1[35]}}, lv2_z_1};
    // Q4.18: L.V, rounded down
    wire [22:0] lv2_cut_1 = lv2_xyz_1[36:14];
    always @(posedge clk) begin
        if (ce) begin
            case (in_material_1)
                2'd0: colours_2 <= 156'h89c7a52ca11da2a21789d7cfca476436b22d476;
                2'd1: colours_2 <= 156'h5fa2e48ded6b9316874dc822df5afe88183f4a6;
                2'd2: colours_2 <= 156'h4062788725466e5a643928ed7251b6f7a70551a;
                2'd3: colours_2 <= 156'h0f5ea7a14628c9904c8d611e148a4f50f43d0a3;
                default: colours_2 <= 156'h89c7a52ca11da2a21789d7cfca476436b22d476;
            endcase
        end
    end
    reg [1:0] in_material_2;
    reg [22:0] nv_cut_2;
    reg [36:0] nl1_xyz_2;
    reg [22:0] lv1_cut_2;
    reg [36:0] nl2_xyz_2;
    reg [22:0] lv2_cut_2;
    always @(posedge clk) begin
        if (ce) begin
            in_material_2 <= in_material_1;
            nv_cut_2 <= nv_cut_1;
            nl1_xyz_2 <= nl1_xyz_1;
            lv1_cut_2 <= lv1_cut_1;
            nl2_xyz_2 <= nl2_xyz_1;
            lv2_cut_2 <= lv2_cut_1;
        end
    end

    // ===== Stage 2: nv, nl1_exact, lv1, nl2_exact, lv2
    // Q1.18: N.V, taken into [-1, 1]
    wire [19:0] nv_2 = (nv_cut_2[22] & ~&nv_cut_2[21:18]) ? 20'hc0000 :
        (~nv_cut_2[22] & |nv_cut_2[21:18]) ? 20'h40000 :
        nv_cut_2[19:0];
    // UQ1.32: N.L, taken into [0, 1]: no light from behind
    wire [32:0] nl1_exact_2 =
        nl1_xyz_2[36] ? 33'h000000000 : (|nl1_xyz_2[35:32]) ? 33'h100000000 : nl1_xyz_2[32:0];
    // UQ1.0: N.L > 0
    wire lit1_2 = |nl1_exact_2;
    // UQ1.0: the light is behind the surface
    wire dark1_2 = ~lit1_2;
    // UQ1.18: N.L, rounded down
    wire [18:0] nl1_2 = nl1_exact_2[32:14];
    // Q1.18: L.V, taken into [-1, 1]
    wire [19:0] lv1_2 = (lv1_cut_2[22] & ~&lv1_cut_2[21:18]) ? 20'hc0000 :
        (~lv1_cut_2[22] & |lv1_cut_2[21:18]) ? 20'h40000 :
        lv1_cut_2[19:0];
    // Q1.18: a sign bit for the signed product
    wire [19:0] nl1_signed_2 = {1'd0, nl1_2};
    // UQ-1.18: the 17 low bits of nl1_signed
    wire [16:0] nl1_signed_low_2 = nl1_signed_2[16:0];
    // Q-1.18: with a sign of 0
    wire [17:0] nl1_signed_low_signed_2 = {1'd0, nl1_signed_low_2};
    // Q1.1: nl1_signed without its 17 low bits
    wire [2:0] nl1_signed_high_2 = nl1_signed_2[19:17];
    // UQ-1.18: the 17 low bits of nv
    wire [16:0] nv_low_2 = nv_2[16:0];
    // Q-1.18: with a sign of 0
    wire [17:0] nv_low_signed_2 = {1'd0, nv_low_2};
    // Q1.1: nv without its 17 low bits
    wire [2:0] nv_high_2 = nv_2[19:17];
    // UQ1.12: N.L for the diffuse term, rounded down
    wire [12:0] psi1_2 = nl1_2[18:6];
    // UQ-1.12: k_d, colour and light
    wire [10:0] diffuse_r_1_2 = colours_2[127:117];
    // UQ0.12: k_s, colour and light
    wire [11:0] specular_r_1_2 = colours_2[116:105];
    // UQ-1.12: k_d, colour and light
    wire [10:0] diffuse_g_1_2 = colours_2[104:94];
    // UQ0.12: k_s, colour and light
    wire [11:0] specular_g_1_2 = colours_2[93:82];
    // UQ-2.12: k_d, colour and light
    wire [9:0] diffuse_b_1_2 = colours_2[81:72];
    // UQ0.12: k_s, colour and light
    wire [11:0] specular_b_1_2 = colours_2[71:60];
    // UQ1.32: N.L, taken into [0, 1]: no light from behind
    wire [32:0] nl2_exact_2 =
        nl2_xyz_2[36] ? 33'h000000000 : (|nl2_xyz_2[35:32]) ? 33'h100000000 : nl2_xyz_2[32:0];
    // UQ1.0: N.L > 0
    wire lit2_2 = |nl2_exact_2;
    // UQ1.0: the light is behind the surface
    wire dark2_2 = ~lit2_2;
    // UQ1.18: N.L, rounded down
    wire [18:0] nl2_2 = nl2_exact_2[32:14];
    // Q1.18: L.V, taken into [-1, 1]
    wire [19:0] lv2_2 = (lv2_cut_2[22] & ~&lv2_cut_2[21:18]) ? 20'hc0000 :
        (~lv2_cut_2[22] & |lv2_cut_2[21:18]) ? 20'h40000 :
        lv2_cut_2[19:0];
    // Q1.18: a sign bit for the signed product
    wire [19:0] nl2_signed_2 = {1'd0, nl2_2};
    // UQ-1.18: the 17 low bits of nl2_signed
    wire [16:0] nl2_signed_low_2 = nl2_signed_2[16:0];
    // Q-1.18: with a sign of 0
    wire [17:0] nl2_signed_low_signed_2 = {1'd0, nl2_signed_low_2};
    // Q1.1: nl2_signed without its 17 low bits
    wire [2:0] nl2_signed_high_2 = nl2_signed_2[19:17];
    // UQ1.12: N.L for the diffuse term, rounded down
    wire [12:0] psi2_2 = nl2_2[18:6];
    // UQ-3.12: k_d, colour and light
    wire [8:0] diffuse_r_2_2 = colours_2[59:51];
    // UQ-2.12: k_s, colour and light
    wire [9:0] specular_r_2_2 = colours_2[50:41];
    // UQ-3.12: k_d, colour and light
    wire [8:0] diffuse_g_2_2 = colours_2[40:32];
    // UQ-1.12: k_s, colour and light
    wire [10:0] specular_g_2_2 = colours_2[31:21];
    // UQ-2.12: k_d, colour and light
    wire [9:0] diffuse_b_2_2 = colours_2[20:11];
    // UQ-1.12: k_s, colour and light
    wire [10:0] specular_b_2_2 = colours_2[10:0];
    // UQ-2.12: ambient light, k_a and colour
    wire [9:0] ambient_r_2 = colours_2[155:146];
    // UQ-3.12: ambient light, k_a and colour
    wire [8:0] ambient_g_2 = colours_2[145:137];
    // UQ-3.12: ambient light, k_a and colour
    wire [8:0] ambient_b_2 = colours_2[136:128];
    reg [1:0] in_material_3;
    reg dark1_3;
    reg [19:0] lv1_3;
    reg [17:0] nl1_signed_low_signed_3;
    reg [2:0] nl1_signed_high_3;
    reg [17:0] nv_low_signed_3;
    reg [2:0] nv_high_3;
    reg [12:0] psi1_3;
    reg [10:0] diffuse_r_1_3;
    reg [11:0] specular_r_1_3;
    reg [10:0] diffuse_g_1_3;
    reg [11:0] specular_g_1_3;
    reg [9:0] diffuse_b_1_3;
    reg [11:0] specular_b_1_3;
    reg dark2_3;
    reg [19:0] lv2_3;
    reg [17:0] nl2_signed_low_signed_3;
    reg [2:0] nl2_signed_high_3;
    reg [12:0] psi2_3;
    reg [8:0] diffuse_r_2_3;
    reg [9:0] specular_r_2_3;
    reg [8:0] diffuse_g_2_3;
    reg [10:0] specular_g_2_3;
    reg [9:0] diffuse_b_2_3;
    reg [10:0] specular_b_2_3;
    reg [9:0] ambient_r_3;
    reg [8:0] ambient_g_3;
    reg [8:0] ambient_b_3;
    always @(posedge clk) begin
        if (ce) begin
            in_material_3 <= in_material_2;
            dark1_3 <= dark1_2;
            lv1_3 <= lv1_2;
            nl1_signed_low_signed_3 <= nl1_signed_low_signed_2;
            nl1_signed_high_3 <= nl1_signed_high_2;
            nv_low_signed_3 <= nv_low_signed_2;
            nv_high_3 <= nv_high_2;
            psi1_3 <= psi1_2;
            diffuse_r_1_3 <= diffuse_r_1_2;
            specular_r_1_3 <= specular_r_1_2;
            diffuse_g_1_3 <= diffuse_g_1_2;
            specular_g_1_3 <= specular_g_1_2;
            diffuse_b_1_3 <= diffuse_b_1_2;
            specular_b_1_3 <= specular_b_1_2;
            dark2_3 <= dark2_2;
            lv2_3 <= lv2_2;
            nl2_signed_low_signed_3 <= nl2_signed_low_signed_2;
            nl2_signed_high_3 <= nl2_signed_high_2;
            psi2_3 <= psi2_2;
            diffuse_r_2_3 <= diffuse_r_2_2;
            specular_r_2_3 <= specular_r_2_2;
            diffuse_g_2_3 <= diffuse_g_2_2;
            specular_g_2_3 <= specular_g_2_2;
            diffuse_b_2_3 <= diffuse_b_2_2;
            specular_b_2_3 <= specular_b_2_2;
            ambient_r_3 <= ambient_r_2;
            ambient_g_3 <= ambient_g_2;
            ambient_b_3 <= ambient_b_2;
        end
    end

    // ===== Stage 3: nlv1_low_l, nlv1_low_h, nlv1_high_l, nlv1_high_h and 10 more
    // Q-1.36: part of nlv1_low
    wire [35:0] nlv1_low_l_3 = $signed(nl1_signed_low_signed_3) * $signed(nv_low_signed_3);
    // Q1.19: part of nlv1_low
    wire [20:0] nlv1_low_h_3 = $signed(nl1_signed_low_signed_3) * $signed(nv_high_3);
    // Q1.19: part of nlv1_high
    wire [20:0] nlv1_high_l_3 = $signed(nl1_signed_high_3) * $signed(nv_low_signed_3);
    // Q3.2: part of nlv1_high
    wire [5:0] nlv1_high_h_3 = $signed(nl1_signed_high_3) * $signed(nv_high_3);
    // UQ0.24: colour times cosine
    wire [23:0] dif1_r_exact_3 = diffuse_r_1_3 * psi1_3;
    // UQ-1.13: rounded down
    wire [11:0] dif1_r_3 = dif1_r_exact_3[22:11];
    // UQ0.24: colour times cosine
    wire [23:0] dif1_g_exact_3 = diffuse_g_1_3 * psi1_3;
    // UQ-1.13: rounded down
    wire [11:0] dif1_g_3 = dif1_g_exact_3[22:11];
    // UQ-1.24: colour times cosine
    wire [22:0] dif1_b_exact_3 = diffuse_b_1_3 * psi1_3;
    // UQ-2.13: rounded down
    wire [10:0] dif1_b_3 = dif1_b_exact_3[21:11];
    // Q-1.36: part of nlv2_low
    wire [35:0] nlv2_low_l_3 = $signed(nl2_signed_low_signed_3) * $signed(nv_low_signed_3);
    // Q1.19: part of nlv2_low
    wire [20:0] nlv2_low_h_3 = $signed(nl2_signed_low_signed_3) * $signed(nv_high_3);
    // Q1.19: part of nlv2_high
    wire [20:0] nlv2_high_l_3 = $signed(nl2_signed_high_3) * $signed(nv_low_signed_3);
    // Q3.2: part of nlv2_high
    wire [5:0] nlv2_high_h_3 = $signed(nl2_signed_high_3) * $signed(nv_high_3);
    // UQ-2.24: colour times cosine
    wire [21:0] dif2_r_exact_3 = diffuse_r_2_3 * psi2_3;
    // UQ-3.13: rounded down
    wire [9:0] dif2_r_3 = dif2_r_exact_3[20:11];
    // UQ-2.24: colour times cosine
    wire [21:0] dif2_g_exact_3 = diffuse_g_2_3 * psi2_3;
    // UQ-3.13: rounded down
    wire [9:0] dif2_g_3 = dif2_g_exact_3[20:11];
    // UQ-1.24: colour times cosine
    wire [22:0] dif2_b_exact_3 = diffuse_b_2_3 * psi2_3;
    // UQ-2.13: rounded down
    wire [10:0] dif2_b_3 = dif2_b_exact_3[21:11];
    reg [1:0] in_material_4;
    reg dark1_4;
    reg [19:0] lv1_4;
    reg [35:0] nlv1_low_l_4;
    reg [20:0] nlv1_low_h_4;
    reg [20:0] nlv1_high_l_4;
    reg [5:0] nlv1_high_h_4;
    reg [11:0] dif1_r_4;
    reg [11:0] specular_r_1_4;
    reg [11:0] dif1_g_4;
    reg [11:0] specular_g_1_4;
    reg [10:0] dif1_b_4;
    reg [11:0] specular_b_1_4;
    reg dark2_4;
    reg [19:0] lv2_4;
    reg [35:0] nlv2_low_l_4;
    reg [20:0] nlv2_low_h_4;
    reg [20:0] nlv2_high_l_4;
    reg [5:0] nlv2_high_h_4;
    reg [9:0] dif2_r_4;
    reg [9:0] specular_r_2_4;
    reg [9:0] dif2_g_4;
    reg [10:0] specular_g_2_4;
    reg [10:0] dif2_b_4;
    reg [10:0] specular_b_2_4;
    reg [9:0] ambient_r_4;
    reg [8:0] ambient_g_4;
    reg [8:0] ambient_b_4;
    always @(posedge clk) begin
        if (ce) begin
            in_material_4 <= in_material_3;
            dark1_4 <= dark1_3;
            lv1_4 <= lv1_3;
            nlv1_low_l_4 <= nlv1_low_l_3;
            nlv1_low_h_4 <= nlv1_low_h_3;
            nlv1_high_l_4 <= nlv1_high_l_3;
            nlv1_high_h_4 <= nlv1_high_h_3;
            dif1_r_4 <= dif1_r_3;
            specular_r_1_4 <= specular_r_1_3;
            dif1_g_4 <= dif1_g_3;
            specular_g_1_4 <= specular_g_1_3;
            dif1_b_4 <= dif1_b_3;
            specular_b_1_4 <= specular_b_1_3;
            dark2_4 <= dark2_3;
            lv2_4 <= lv2_3;
            nlv2_low_l_4 <= nlv2_low_l_3;
            nlv2_low_h_4 <= nlv2_low_h_3;
            nlv2_high_l_4 <= nlv2_high_l_3;
            nlv2_high_h_4 <= nlv2_high_h_3;
            dif2_r_4 <= dif2_r_3;
            specular_r_2_4 <= specular_r_2_3;
            dif2_g_4 <= dif2_g_3;
            specular_g_2_4 <= specular_g_2_3;
            dif2_b_4 <= dif2_b_3;
            specular_b_2_4 <= specular_b_2_3;
            ambient_r_4 <= ambient_r_3;
            ambient_g_4 <= ambient_g_3;
            ambient_b_4 <= ambient_b_3;
        end
    end

    // ===== Stage 4: nlv1_low, nlv1_high, nlv1, nlv2_low, nlv2_high, nlv2
    // Q1.36: part of nlv1
    wire [37:0] nlv1_low_4 = {{2{nlv1_low_l_4[35]}}, nlv1_low_l_4} + {nlv1_low_h_4, 17'd0};
    // Q3.19: part of nlv1
    wire [22:0] nlv1_high_4 = {{2{nlv1_high_l_4[20]}}, nlv1_high_l_4} + {nlv1_high_h_4, 17'd0};
    // Q3.36: (N.L)(N.V)
    wire [39:0] nlv1_4 = {{2{nlv1_low_4[37]}}, nlv1_low_4} + {nlv1_high_4, 17'd0};
    // Q4.35: 2 (N.L)(N.V)
    wire [39:0] nlv1_twice_4 = nlv1_4;
    // Q1.36: part of nlv2
    wire [37:0] nlv2_low_4 = {{2{nlv2_low_l_4[35]}}, nlv2_low_l_4} + {nlv2_low_h_4, 17'd0};
    // Q3.19: part of nlv2
    wire [22:0] nlv2_high_4 = {{2{nlv2_high_l_4[20]}}, nlv2_high_l_4} + {nlv2_high_h_4, 17'd0};
    // Q3.36: (N.L)(N.V)
    wire [39:0] nlv2_4 = {{2{nlv2_low_4[37]}}, nlv2_low_4} + {nlv2_high_4, 17'd0};
    // Q4.35: 2 (N.L)(N.V)
    wire [39:0] nlv2_twice_4 = nlv2_4;
    reg [1:0] in_material_5;
    reg dark1_5;
    reg [19:0] lv1_5;
    reg [39:0] nlv1_twice_5;
    reg [11:0] dif1_r_5;
    reg [11:0] specular_r_1_5;
    reg [11:0] dif1_g_5;
    reg [11:0] specular_g_1_5;
    reg [10:0] dif1_b_5;
    reg [11:0] specular_b_1_5;
    reg dark2_5;
    reg [19:0] lv2_5;
    reg [39:0] nlv2_twice_5;
    reg [9:0] dif2_r_5;
    reg [9:0] specular_r_2_5;
    reg [9:0] dif2_g_5;
    reg [10:0] specular_g_2_5;
    reg [10:0] dif2_b_5;
    reg [10:0] specular_b_2_5;
    reg [9:0] ambient_r_5;
    reg [8:0] ambient_g_5;
    reg [8:0] ambient_b_5;
    always @(posedge clk) begin
        if (ce) begin
            in_material_5 <= in_material_4;
            dark1_5 <= dark1_4;
            lv1_5 <= lv1_4;
            nlv1_twice_5 <= nlv1_twice_4;
            dif1_r_5 <= dif1_r_4;
            specular_r_1_5 <= specular_r_1_4;
            dif1_g_5 <= dif1_g_4;
            specular_g_1_5 <= specular_g_1_4;
            dif1_b_5 <= dif1_b_4;
            specular_b_1_5 <= specular_b_1_4;
            dark2_5 <= dark2_4;
            lv2_5 <= lv2_4;
            nlv2_twice_5 <= nlv2_twice_4;
            dif2_r_5 <= dif2_r_4;
            specular_r_2_5 <= specular_r_2_4;
            dif2_g_5 <= dif2_g_4;
            specular_g_2_5 <= specular_g_2_4;
            dif2_b_5 <= dif2_b_4;
            specular_b_2_5 <= specular_b_2_4;
            ambient_r_5 <= ambient_r_4;
            ambient_g_5 <= ambient_g_4;
            ambient_b_5 <= ambient_b_4;
        end
    end

    // ===== Stage 5: read the ROM, x1_exact, x1_half, x2_exact, x2_half
    // The word of the memory rom, of 4 words.
    reg [13:0] rom_6;
    // Q2.35: 2 (N.L)(N.V) - L.V
    wire [37:0] x1_exact_5 = nlv1_twice_5[37:0] - {{1{lv1_5[19]}}, lv1_5, 17'd0};
    // Q2.35: plus half a last bit
    wire [37:0] x1_half_5 = x1_exact_5 + 38'h0000040000;
    // Q2.16: rounded to nearest
    wire [18:0] x1_cut_5 = x1_half_5[37:19];
    // Q2.35: 2 (N.L)(N.V) - L.V
    wire [37:0] x2_exact_5 = nlv2_twice_5[37:0] - {{1{lv2_5[19]}}, lv2_5, 17'd0};
    // Q2.35: plus half a last bit
    wire [37:0] x2_half_5 = x2_exact_5 + 38'h0000040000;
    // Q2.16: rounded to nearest
    wire [18:0] x2_cut_5 = x2_half_5[37:19];
    always @(posedge clk) begin
        if (ce) begin
            case (in_material_5)
                2'd0: rom_6 <= 14'h315e;
                2'd1: rom_6 <= 14'h2aea;
                2'd2: rom_6 <= 14'h3bf3;
                2'd3: rom_6 <= 14'h3adc;
                default: rom_6 <= 14'h315e;
            endcase
        end
    end
    reg dark1_6;
    reg [18:0] x1_cut_6;
    reg [11:0] dif1_r_6;
    reg [11:0] specular_r_1_6;
    reg [11:0] dif1_g_6;
    reg [11:0] specular_g_1_6;
    reg [10:0] dif1_b_6;
    reg [11:0] specular_b_1_6;
    reg dark2_6;
    reg [18:0] x2_cut_6;
    reg [9:0] dif2_r_6;
    reg [9:0] specular_r_2_6;
    reg [9:0] dif2_g_6;
    reg [10:0] specular_g_2_6;
    reg [10:0] dif2_b_6;
    reg [10:0] specular_b_2_6;
    reg [9:0] ambient_r_6;
    reg [8:0] ambient_g_6;
    reg [8:0] ambient_b_6;
    always @(posedge clk) begin
        if (ce) begin
            dark1_6 <= dark1_5;
            x1_cut_6 <= x1_cut_5;
            dif1_r_6 <= dif1_r_5;
            specular_r_1_6 <= specular_r_1_5;
            dif1_g_6 <= dif1_g_5;
            specular_g_1_6 <= specular_g_1_5;
            dif1_b_6 <= dif1_b_5;
            specular_b_1_6 <= specular_b_1_5;
            dark2_6 <= dark2_5;
            x2_cut_6 <= x2_cut_5;
            dif2_r_6 <= dif2_r_5;
            specular_r_2_6 <= specular_r_2_5;
            dif2_g_6 <= dif2_g_5;
            specular_g_2_6 <= specular_g_2_5;
            dif2_b_6 <= dif2_b_5;
            specular_b_2_6 <= specular_b_2_5;
            ambient_r_6 <= ambient_r_5;
            ambient_g_6 <= ambient_g_5;
            ambient_b_6 <= ambient_b_5;
        end
    end

    // ===== Stage 6: x1, lobe1_u, lobe1_x_half, x2, lobe2_u, lobe2_x_half
    // UQ1.16: x = 2 (N.L)(N.V) - L.V, taken into [0, 1]
    wire [16:0] x1_6 = x1_cut_6[18] ? 17'h00000 : (|x1_cut_6[17:16]) ? 17'h10000 : x1_cut_6[16:0];
    // UQ1.16: u = 1 - x, the versine
    wire [16:0] lobe1_u_6 = 17'h10000 - x1_6;
    // UQ0.12: the coefficient a, times 2^-k
    wire [11:0] lobe1_a_6 = rom_6[13:2];
    // UQ2.0: shift of the versine
    wire [1:0] lobe1_k_6 = rom_6[1:0];
    // UQ1.14: x, rounded down
    wire [14:0] lobe1_x_cut_6 = x1_6[16:2];
    // UQ1.14: x + half an output ulp: the result is rounded to nearest
    wire [14:0] lobe1_x_half_6 = lobe1_x_cut_6 + 15'h0002;
    // UQ1.16: x = 2 (N.L)(N.V) - L.V, taken into [0, 1]
    wire [16:0] x2_6 = x2_cut_6[18] ? 17'h00000 : (|x2_cut_6[17:16]) ? 17'h10000 : x2_cut_6[16:0];
    // UQ1.16: u = 1 - x, the versine
    wire [16:0] lobe2_u_6 = 17'h10000 - x2_6;
    // UQ1.14: x, rounded down
    wire [14:0] lobe2_x_cut_6 = x2_6[16:2];
    // UQ1.14: x + half an output ulp: the result is rounded to nearest
    wire [14:0] lobe2_x_half_6 = lobe2_x_cut_6 + 15'h0002;
    reg dark1_7;
    reg [16:0] lobe1_u_7;
    reg [11:0] lobe1_a_7;
    reg [1:0] lobe1_k_7;
    reg [14:0] lobe1_x_cut_7;
    reg [14:0] lobe1_x_half_7;
    reg [11:0] dif1_r_7;
    reg [11:0] specular_r_1_7;
    reg [11:0] dif1_g_7;
    reg [11:0] specular_g_1_7;
    reg [10:0] dif1_b_7;
    reg [11:0] specular_b_1_7;
    reg dark2_7;
    reg [16:0] lobe2_u_7;
    reg [14:0] lobe2_x_cut_7;
    reg [14:0] lobe2_x_half_7;
    reg [9:0] dif2_r_7;
    reg [9:0] specular_r_2_7;
    reg [9:0] dif2_g_7;
    reg [10:0] specular_g_2_7;
    reg [10:0] dif2_b_7;
    reg [10:0] specular_b_2_7;
    reg [9:0] ambient_r_7;
    reg [8:0] ambient_g_7;
    reg [8:0] ambient_b_7;
    always @(posedge clk) begin
        if (ce) begin
            dark1_7 <= dark1_6;
            lobe1_u_7 <= lobe1_u_6;
            lobe1_a_7 <= lobe1_a_6;
            lobe1_k_7 <= lobe1_k_6;
            lobe1_x_cut_7 <= lobe1_x_cut_6;
            lobe1_x_half_7 <= lobe1_x_half_6;
            dif1_r_7 <= dif1_r_6;
            specular_r_1_7 <= specular_r_1_6;
            dif1_g_7 <= dif1_g_6;
            specular_g_1_7 <= specular_g_1_6;
            dif1_b_7 <= dif1_b_6;
            specular_b_1_7 <= specular_b_1_6;
            dark2_7 <= dark2_6;
            lobe2_u_7 <= lobe2_u_6;
            lobe2_x_cut_7 <= lobe2_x_cut_6;
            lobe2_x_half_7 <= lobe2_x_half_6;
            dif2_r_7 <= dif2_r_6;
            specular_r_2_7 <= specular_r_2_6;
            dif2_g_7 <= dif2_g_6;
            specular_g_2_7 <= specular_g_2_6;
            dif2_b_7 <= dif2_b_6;
            specular_b_2_7 <= specular_b_2_6;
            ambient_r_7 <= ambient_r_6;
            ambient_g_7 <= ambient_g_6;
            ambient_b_7 <= ambient_b_6;
        end
    end

    // ===== Stage 7: lobe1_u_scaled, lobe2_u_scaled
    // UQ7.13: u 2^(k + 3)
    wire [19:0] lobe1_u_scaled_7 = {3'd0, lobe1_u_7} << lobe1_k_7;
    // UQ7.-1: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    wire [5:0] lobe1_beyond_bits_7 = lobe1_u_scaled_7[19:14];
    // UQ1.0: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    wire lobe1_beyond_7 = |lobe1_beyond_bits_7;
    // UQ1.13: v = u 2^k, rounded down
    wire [13:0] lobe1_v_7 = lobe1_u_scaled_7[13:0];
    // UQ7.13: u 2^(k + 3)
    wire [19:0] lobe2_u_scaled_7 = {3'd0, lobe2_u_7} << lobe1_k_7;
    // UQ7.-1: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    wire [5:0] lobe2_beyond_bits_7 = lobe2_u_scaled_7[19:14];
    // UQ1.0: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    wire lobe2_beyond_7 = |lobe2_beyond_bits_7;
    // UQ1.13: v = u 2^k, rounded down
    wire [13:0] lobe2_v_7 = lobe2_u_scaled_7[13:0];
    reg dark1_8;
    reg [11:0] lobe1_a_8;
    reg lobe1_beyond_8;
    reg [13:0] lobe1_v_8;
    reg [14:0] lobe1_x_cut_8;
    reg [14:0] lobe1_x_half_8;
    reg [11:0] dif1_r_8;
    reg [11:0] specular_r_1_8;
    reg [11:0] dif1_g_8;
    reg [11:0] specular_g_1_8;
    reg [10:0] dif1_b_8;
    reg [11:0] specular_b_1_8;
    reg dark2_8;
    reg lobe2_beyond_8;
    reg [13:0] lobe2_v_8;
    reg [14:0] lobe2_x_cut_8;
    reg [14:0] lobe2_x_half_8;
    reg [9:0] dif2_r_8;
    reg [9:0] specular_r_2_8;
    reg [9:0] dif2_g_8;
    reg [10:0] specular_g_2_8;
    reg [10:0] dif2_b_8;
    reg [10:0] specular_b_2_8;
    reg [9:0] ambient_r_8;
    reg [8:0] ambient_g_8;
    reg [8:0] ambient_b_8;
    always @(posedge clk) begin
        if (ce) begin
            dark1_8 <= dark1_7;
            lobe1_a_8 <= lobe1_a_7;
            lobe1_beyond_8 <= lobe1_beyond_7;
            lobe1_v_8 <= lobe1_v_7;
            lobe1_x_cut_8 <= lobe1_x_cut_7;
            lobe1_x_half_8 <= lobe1_x_half_7;
            dif1_r_8 <= dif1_r_7;
            specular_r_1_8 <= specular_r_1_7;
            dif1_g_8 <= dif1_g_7;
            specular_g_1_8 <= specular_g_1_7;
            dif1_b_8 <= dif1_b_7;
            specular_b_1_8 <= specular_b_1_7;
            dark2_8 <= dark2_7;
            lobe2_beyond_8 <= lobe2_beyond_7;
            lobe2_v_8 <= lobe2_v_7;
            lobe2_x_cut_8 <= lobe2_x_cut_7;
            lobe2_x_half_8 <= lobe2_x_half_7;
            dif2_r_8 <= dif2_r_7;
            specular_r_2_8 <= specular_r_2_7;
            dif2_g_8 <= dif2_g_7;
            specular_g_2_8 <= specular_g_2_7;
            dif2_b_8 <= dif2_b_7;
            specular_b_2_8 <= specular_b_2_7;
            ambient_r_8 <= ambient_r_7;
            ambient_g_8 <= ambient_g_7;
            ambient_b_8 <= ambient_b_7;
        end
    end

    // ===== Stage 8: registers only
    reg dark1_9;
    reg [11:0] lobe1_a_9;
    reg lobe1_beyond_9;
    reg [13:0] lobe1_v_9;
    reg [14:0] lobe1_x_cut_9;
    reg [14:0] lobe1_x_half_9;
    reg [11:0] dif1_r_9;
    reg [11:0] specular_r_1_9;
    reg [11:0] dif1_g_9;
    reg [11:0] specular_g_1_9;
    reg [10:0] dif1_b_9;
    reg [11:0] specular_b_1_9;
    reg dark2_9;
    reg lobe2_beyond_9;
    reg [13:0] lobe2_v_9;
    reg [14:0] lobe2_x_cut_9;
    reg [14:0] lobe2_x_half_9;
    reg [9:0] dif2_r_9;
    reg [9:0] specular_r_2_9;
    reg [9:0] dif2_g_9;
    reg [10:0] specular_g_2_9;
    reg [10:0] dif2_b_9;
    reg [10:0] specular_b_2_9;
    reg [9:0] ambient_r_9;
    reg [8:0] ambient_g_9;
    reg [8:0] ambient_b_9;
    always @(posedge clk) begin
        if (ce) begin
            dark1_9 <= dark1_8;
            lobe1_a_9 <= lobe1_a_8;
            lobe1_beyond_9 <= lobe1_beyond_8;
            lobe1_v_9 <= lobe1_v_8;
            lobe1_x_cut_9 <= lobe1_x_cut_8;
            lobe1_x_half_9 <= lobe1_x_half_8;
            dif1_r_9 <= dif1_r_8;
            specular_r_1_9 <= specular_r_1_8;
            dif1_g_9 <= dif1_g_8;
            specular_g_1_9 <= specular_g_1_8;
            dif1_b_9 <= dif1_b_8;
            specular_b_1_9 <= specular_b_1_8;
            dark2_9 <= dark2_8;
            lobe2_beyond_9 <= lobe2_beyond_8;
            lobe2_v_9 <= lobe2_v_8;
            lobe2_x_cut_9 <= lobe2_x_cut_8;
            lobe2_x_half_9 <= lobe2_x_half_8;
            dif2_r_9 <= dif2_r_8;
            specular_r_2_9 <= specular_r_2_8;
            dif2_g_9 <= dif2_g_8;
            specular_g_2_9 <= specular_g_2_8;
            dif2_b_9 <= dif2_b_8;
            specular_b_2_9 <= specular_b_2_8;
            ambient_r_9 <= ambient_r_8;
            ambient_g_9 <= ambient_g_8;
            ambient_b_9 <= ambient_b_8;
        end
    end

    // ===== Stage 9: lobe1_av, lobe2_av
    // UQ1.25: a u = (a 2^-k) v
    wire [25:0] lobe1_av_9 = lobe1_a_9 * lobe1_v_9;
    // UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    wire lobe1_p_above_bits_9 = lobe1_av_9[25];
    // UQ0.14: p, rounded down
    wire [13:0] lobe1_p_9 = lobe1_av_9[24:11];
    // UQ1.25: a u = (a 2^-k) v
    wire [25:0] lobe2_av_9 = lobe1_a_9 * lobe2_v_9;
    // UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    wire lobe2_p_above_bits_9 = lobe2_av_9[25];
    // UQ0.14: p, rounded down
    wire [13:0] lobe2_p_9 = lobe2_av_9[24:11];
    reg dark1_10;
    reg lobe1_beyond_10;
    reg [14:0] lobe1_x_cut_10;
    reg lobe1_p_above_bits_10;
    reg [13:0] lobe1_p_10;
    reg [14:0] lobe1_x_half_10;
    reg [11:0] dif1_r_10;
    reg [11:0] specular_r_1_10;
    reg [11:0] dif1_g_10;
    reg [11:0] specular_g_1_10;
    reg [10:0] dif1_b_10;
    reg [11:0] specular_b_1_10;
    reg dark2_10;
    reg lobe2_beyond_10;
    reg [14:0] lobe2_x_cut_10;
    reg lobe2_p_above_bits_10;
    reg [13:0] lobe2_p_10;
    reg [14:0] lobe2_x_half_10;
    reg [9:0] dif2_r_10;
    reg [9:0] specular_r_2_10;
    reg [9:0] dif2_g_10;
    reg [10:0] specular_g_2_10;
    reg [10:0] dif2_b_10;
    reg [10:0] specular_b_2_10;
    reg [9:0] ambient_r_10;
    reg [8:0] ambient_g_10;
    reg [8:0] ambient_b_10;
    always @(posedge clk) begin
        if (ce) begin
            dark1_10 <= dark1_9;
            lobe1_beyond_10 <= lobe1_beyond_9;
            lobe1_x_cut_10 <= lobe1_x_cut_9;
            lobe1_p_above_bits_10 <= lobe1_p_above_bits_9;
            lobe1_p_10 <= lobe1_p_9;
            lobe1_x_half_10 <= lobe1_x_half_9;
            dif1_r_10 <= dif1_r_9;
            specular_r_1_10 <= specular_r_1_9;
            dif1_g_10 <= dif1_g_9;
            specular_g_1_10 <= specular_g_1_9;
            dif1_b_10 <= dif1_b_9;
            specular_b_1_10 <= specular_b_1_9;
            dark2_10 <= dark2_9;
            lobe2_beyond_10 <= lobe2_beyond_9;
            lobe2_x_cut_10 <= lobe2_x_cut_9;
            lobe2_p_above_bits_10 <= lobe2_p_above_bits_9;
            lobe2_p_10 <= lobe2_p_9;
            lobe2_x_half_10 <= lobe2_x_half_9;
            dif2_r_10 <= dif2_r_9;
            specular_r_2_10 <= specular_r_2_9;
            dif2_g_10 <= dif2_g_9;
            specular_g_2_10 <= specular_g_2_9;
            dif2_b_10 <= dif2_b_9;
            specular_b_2_10 <= specular_b_2_9;
            ambient_r_10 <= ambient_r_9;
            ambient_g_10 <= ambient_g_9;
            ambient_b_10 <= ambient_b_9;
        end
    end

    // ===== Stage 10: lobe1_xp, lobe2_xp
    // UQ1.0: the result is 0
    wire lobe1_zero_10 = lobe1_beyond_10 | lobe1_p_above_bits_10;
    // UQ1.28: x p
    wire [28:0] lobe1_xp_10 = lobe1_x_cut_10 * lobe1_p_10;
    // UQ0.15: t = x p, rounded down
    wire [14:0] lobe1_t_10 = lobe1_xp_10[27:13];
    // UQ1.0: the result is 0
    wire lobe2_zero_10 = lobe2_beyond_10 | lobe2_p_above_bits_10;
    // UQ1.28: x p
    wire [28:0] lobe2_xp_10 = lobe2_x_cut_10 * lobe2_p_10;
    // UQ0.15: t = x p, rounded down
    wire [14:0] lobe2_t_10 = lobe2_xp_10[27:13];
    reg dark1_11;
    reg lobe1_zero_11;
    reg [14:0] lobe1_t_11;
    reg [14:0] lobe1_x_half_11;
    reg [11:0] dif1_r_11;
    reg [11:0] specular_r_1_11;
    reg [11:0] dif1_g_11;
    reg [11:0] specular_g_1_11;
    reg [10:0] dif1_b_11;
    reg [11:0] specular_b_1_11;
    reg dark2_11;
    reg lobe2_zero_11;
    reg [14:0] lobe2_t_11;
    reg [14:0] lobe2_x_half_11;
    reg [9:0] dif2_r_11;
    reg [9:0] specular_r_2_11;
    reg [9:0] dif2_g_11;
    reg [10:0] specular_g_2_11;
    reg [10:0] dif2_b_11;
    reg [10:0] specular_b_2_11;
    reg [9:0] ambient_r_11;
    reg [8:0] ambient_g_11;
    reg [8:0] ambient_b_11;
    always @(posedge clk) begin
        if (ce) begin
            dark1_11 <= dark1_10;
            lobe1_zero_11 <= lobe1_zero_10;
            lobe1_t_11 <= lobe1_t_10;
            lobe1_x_half_11 <= lobe1_x_half_10;
            dif1_r_11 <= dif1_r_10;
            specular_r_1_11 <= specular_r_1_10;
            dif1_g_11 <= dif1_g_10;
            specular_g_1_11 <= specular_g_1_10;
            dif1_b_11 <= dif1_b_10;
            specular_b_1_11 <= specular_b_1_10;
            dark2_11 <= dark2_10;
            lobe2_zero_11 <= lobe2_zero_10;
            lobe2_t_11 <= lobe2_t_10;
            lobe2_x_half_11 <= lobe2_x_half_10;
            dif2_r_11 <= dif2_r_10;
            specular_r_2_11 <= specular_r_2_10;
            dif2_g_11 <= dif2_g_10;
            specular_g_2_11 <= specular_g_2_10;
            dif2_b_11 <= dif2_b_10;
            specular_b_2_11 <= specular_b_2_10;
            ambient_r_11 <= ambient_r_10;
            ambient_g_11 <= ambient_g_10;
            ambient_b_11 <= ambient_b_10;
        end
    end

    // ===== Stage 11: lobe1_y_exact, lobe1_y, spec1, lobe2_y_exact, lobe2_y and 1 more
    // UQ1.15: x - t = x (1 - p)
    wire [15:0] lobe1_y_exact_11 = {lobe1_x_half_11, 1'd0} - {1'd0, lobe1_t_11};
    // UQ1.12: rounded down to the output's bits
    wire [12:0] lobe1_y_cut_11 = lobe1_y_exact_11[15:3];
    // UQ1.12: y, 0 where the lobe has ended
    wire [12:0] lobe1_y_11 = lobe1_zero_11 ? 13'd0 : lobe1_y_cut_11;
    // UQ1.12: no highlight from a light behind the surface
    wire [12:0] spec1_11 = dark1_11 ? 13'd0 : lobe1_y_11;
    // UQ1.15: x - t = x (1 - p)
    wire [15:0] lobe2_y_exact_11 = {lobe2_x_half_11, 1'd0} - {1'd0, lobe2_t_11};
    // UQ1.12: rounded down to the output's bits
    wire [12:0] lobe2_y_cut_11 = lobe2_y_exact_11[15:3];
    // UQ1.12: y, 0 where the lobe has ended
    wire [12:0] lobe2_y_11 = lobe2_zero_11 ? 13'd0 : lobe2_y_cut_11;
    // UQ1.12: no highlight from a light behind the surface
    wire [12:0] spec2_11 = dark2_11 ? 13'd0 : lobe2_y_11;
    reg [12:0] spec1_12;
    reg [11:0] dif1_r_12;
    reg [11:0] specular_r_1_12;
    reg [11:0] dif1_g_12;
    reg [11:0] specular_g_1_12;
    reg [10:0] dif1_b_12;
    reg [11:0] specular_b_1_12;
    reg [12:0] spec2_12;
    reg [9:0] dif2_r_12;
    reg [9:0] specular_r_2_12;
    reg [9:0] dif2_g_12;
    reg [10:0] specular_g_2_12;
    reg [10:0] dif2_b_12;
    reg [10:0] specular_b_2_12;
    reg [9:0] ambient_r_12;
    reg [8:0] ambient_g_12;
    reg [8:0] ambient_b_12;
    always @(posedge clk) begin
        if (ce) begin
            spec1_12 <= spec1_11;
            dif1_r_12 <= dif1_r_11;
            specular_r_1_12 <= specular_r_1_11;
            dif1_g_12 <= dif1_g_11;
            specular_g_1_12 <= specular_g_1_11;
            dif1_b_12 <= dif1_b_11;
            specular_b_1_12 <= specular_b_1_11;
            spec2_12 <= spec2_11;
            dif2_r_12 <= dif2_r_11;
            specular_r_2_12 <= specular_r_2_11;
            dif2_g_12 <= dif2_g_11;
            specular_g_2_12 <= specular_g_2_11;
            dif2_b_12 <= dif2_b_11;
            specular_b_2_12 <= specular_b_2_11;
            ambient_r_12 <= ambient_r_11;
            ambient_g_12 <= ambient_g_11;
            ambient_b_12 <= ambient_b_11;
        end
    end

    // ===== Stage 12: spc1_r_exact, spc1_g_exact, spc1_b_exact, spc2_r_exact and 2 more
    // UQ1.24: colour times cosine
    wire [24:0] spc1_r_exact_12 = specular_r_1_12 * spec1_12;
    // UQ1.13: rounded down
    wire [13:0] spc1_r_12 = spc1_r_exact_12[24:11];
    // UQ1.24: colour times cosine
    wire [24:0] spc1_g_exact_12 = specular_g_1_12 * spec1_12;
    // UQ1.13: rounded down
    wire [13:0] spc1_g_12 = spc1_g_exact_12[24:11];
    // UQ1.24: colour times cosine
    wire [24:0] spc1_b_exact_12 = specular_b_1_12 * spec1_12;
    // UQ1.13: rounded down
    wire [13:0] spc1_b_12 = spc1_b_exact_12[24:11];
    // UQ-1.24: colour times cosine
    wire [22:0] spc2_r_exact_12 = specular_r_2_12 * spec2_12;
    // UQ-1.13: rounded down
    wire [11:0] spc2_r_12 = spc2_r_exact_12[22:11];
    // UQ0.24: colour times cosine
    wire [23:0] spc2_g_exact_12 = specular_g_2_12 * spec2_12;
    // UQ0.13: rounded down
    wire [12:0] spc2_g_12 = spc2_g_exact_12[23:11];
    // UQ0.24: colour times cosine
    wire [23:0] spc2_b_exact_12 = specular_b_2_12 * spec2_12;
    // UQ0.13: rounded down
    wire [12:0] spc2_b_12 = spc2_b_exact_12[23:11];
    reg [11:0] dif1_r_13;
    reg [13:0] spc1_r_13;
    reg [11:0] dif1_g_13;
    reg [13:0] spc1_g_13;
    reg [10:0] dif1_b_13;
    reg [13:0] spc1_b_13;
    reg [9:0] dif2_r_13;
    reg [11:0] spc2_r_13;
    reg [9:0] dif2_g_13;
    reg [12:0] spc2_g_13;
    reg [10:0] dif2_b_13;
    reg [12:0] spc2_b_13;
    reg [9:0] ambient_r_13;
    reg [8:0] ambient_g_13;
    reg [8:0] ambient_b_13;
    always @(posedge clk) begin
        if (ce) begin
            dif1_r_13 <= dif1_r_12;
            spc1_r_13 <= spc1_r_12;
            dif1_g_13 <= dif1_g_12;
            spc1_g_13 <= spc1_g_12;
            dif1_b_13 <= dif1_b_12;
            spc1_b_13 <= spc1_b_12;
            dif2_r_13 <= dif2_r_12;
            spc2_r_13 <= spc2_r_12;
            dif2_g_13 <= dif2_g_12;
            spc2_g_13 <= spc2_g_12;
            dif2_b_13 <= dif2_b_12;
            spc2_b_13 <= spc2_b_12;
            ambient_r_13 <= ambient_r_12;
            ambient_g_13 <= ambient_g_12;
            ambient_b_13 <= ambient_b_12;
        end
    end

    // ===== Stage 13: both1_r, both1_g, both1_b, both2_r, lights2_r, both2_g and 3 more
    // UQ1.13: diffuse and specular
    wire [13:0] both1_r_13 = {2'd0, dif1_r_13} + spc1_r_13;
    // UQ1.13: diffuse and specular
    wire [13:0] both1_g_13 = {2'd0, dif1_g_13} + spc1_g_13;
    // UQ1.13: diffuse and specular
    wire [13:0] both1_b_13 = {3'd0, dif1_b_13} + spc1_b_13;
    // UQ-1.13: diffuse and specular
    wire [11:0] both2_r_13 = {2'd0, dif2_r_13} + spc2_r_13;
    // UQ2.13: the lights so far
    wire [14:0] lights2_r_13 = {1'd0, both1_r_13} + {3'd0, both2_r_13};
    // UQ0.13: diffuse and specular
    wire [12:0] both2_g_13 = {3'd0, dif2_g_13} + spc2_g_13;
    // UQ2.13: the lights so far
    wire [14:0] lights2_g_13 = {1'd0, both1_g_13} + {2'd0, both2_g_13};
    // UQ0.13: diffuse and specular
    wire [12:0] both2_b_13 = {2'd0, dif2_b_13} + spc2_b_13;
    // UQ2.13: the lights so far
    wire [14:0] lights2_b_13 = {1'd0, both1_b_13} + {2'd0, both2_b_13};
    reg [14:0] lights2_r_14;
    reg [14:0] lights2_g_14;
    reg [14:0] lights2_b_14;
    reg [9:0] ambient_r_14;
    reg [8:0] ambient_g_14;
    reg [8:0] ambient_b_14;
    always @(posedge clk) begin
        if (ce) begin
            lights2_r_14 <= lights2_r_13;
            lights2_g_14 <= lights2_g_13;
            lights2_b_14 <= lights2_b_13;
            ambient_r_14 <= ambient_r_13;
            ambient_g_14 <= ambient_g_13;
            ambient_b_14 <= ambient_b_13;
        end
    end

    // ===== Stage 14: sum_r, sum_half_r, sum_g, sum_half_g, sum_b, sum_half_b
    // UQ2.13: with the ambient light
    wire [14:0] sum_r_14 = lights2_r_14 + {4'd0, ambient_r_14, 1'd0};
    // UQ2.13: plus half a code
    wire [14:0] sum_half_r_14 = sum_r_14 + 15'h0010;
    // UQ2.8: rounded to the nearest code
    wire [9:0] cut_r_14 = sum_half_r_14[14:5];
    // UQ2.13: with the ambient light
    wire [14:0] sum_g_14 = lights2_g_14 + {5'd0, ambient_g_14, 1'd0};
    // UQ2.13: plus half a code
    wire [14:0] sum_half_g_14 = sum_g_14 + 15'h0010;
    // UQ2.8: rounded to the nearest code
    wire [9:0] cut_g_14 = sum_half_g_14[14:5];
    // UQ2.13: with the ambient light
    wire [14:0] sum_b_14 = lights2_b_14 + {5'd0, ambient_b_14, 1'd0};
    // UQ2.13: plus half a code
    wire [14:0] sum_half_b_14 = sum_b_14 + 15'h0010;
    // UQ2.8: rounded to the nearest code
    wire [9:0] cut_b_14 = sum_half_b_14[14:5];
    reg [9:0] cut_r_15;
    reg [9:0] cut_g_15;
    reg [9:0] cut_b_15;
    always @(posedge clk) begin
        if (ce) begin
            cut_r_15 <= cut_r_14;
            cut_g_15 <= cut_g_14;
            cut_b_15 <= cut_b_14;
        end
    end

    // ===== Stage 15: kept_r, kept_g, kept_b
    // UQ0.8: at most full scale
    wire [7:0] kept_r_15 = (|cut_r_15[9:8]) ? 8'hff : cut_r_15[7:0];
    // UQ8.0: as a whole number
    wire [7:0] code_r_15 = kept_r_15;
    // UQ0.8: at most full scale
    wire [7:0] kept_g_15 = (|cut_g_15[9:8]) ? 8'hff : cut_g_15[7:0];
    // UQ8.0: as a whole number
    wire [7:0] code_g_15 = kept_g_15;
    // UQ0.8: at most full scale
    wire [7:0] kept_b_15 = (|cut_b_15[9:8]) ? 8'hff : cut_b_15[7:0];
    // UQ8.0: as a whole number
    wire [7:0] code_b_15 = kept_b_15;
    reg [7:0] code_r_16;
    reg [7:0] code_g_16;
    reg [7:0] code_b_16;
    always @(posedge clk) begin
        if (ce) begin
            code_r_16 <= code_r_15;
            code_g_16 <= code_g_15;
            code_b_16 <= code_b_15;
        end
    end

    assign out_valid = valid[16];
    assign out_r     = code_r_16;
    assign out_g     = code_g_16;
    assign out_b     = code_b_16;

    // Bits that the roundings drop.
    wire unused = &{1'b0,
                    nv_xyz_1[13:0],
                    lv1_xyz_1[13:0],
                    nlv1_twice_5[39:38],
                    x1_half_5[18:0],
                    lobe1_av_9[10:0],
                    lobe1_xp_10[28],
                    lobe1_xp_10[12:0],
                    lobe1_y_exact_11[2:0],
                    dif1_r_exact_3[23],
                    dif1_r_exact_3[10:0],
                    spc1_r_exact_12[10:0],
                    dif1_g_exact_3[23],
                    dif1_g_exact_3[10:0],
                    spc1_g_exact_12[10:0],
                    dif1_b_exact_3[22],
                    dif1_b_exact_3[10:0],
                    spc1_b_exact_12[10:0],
                    lv2_xyz_1[13:0],
                    nlv2_twice_5[39:38],
                    x2_half_5[18:0],
                    lobe2_av_9[10:0],
                    lobe2_xp_10[28],
                    lobe2_xp_10[12:0],
                    lobe2_y_exact_11[2:0],
                    dif2_r_exact_3[21],
                    dif2_r_exact_3[10:0],
                    spc2_r_exact_12[10:0],
                    dif2_g_exact_3[21],
                    dif2_g_exact_3[10:0],
                    spc2_g_exact_12[10:0],
                    dif2_b_exact_3[22],
                    dif2_b_exact_3[10:0],
                    spc2_b_exact_12[10:0],
                    sum_half_r_14[4:0],
                    sum_half_g_14[4:0],
                    sum_half_b_14[4:0]};

endmodule

`default_nettype wire
