// image_bivariate_lights: the lights of a sample in sequence through the core image_bivariate
//
// Made by: brdfgen generate --block image --reflectance ggx --image-form bivariate --weight-bits 4
// Spec d17cc6a203587951. Generated; the sequencer is yours to use under any terms.
//
//   in_last   1 bit   with the lights of this clock the sample ends
//   out_r     UQ8.0   red; 255 is full scale
//   out_g     UQ8.0   green; 255 is full scale
//   out_b     UQ8.0   blue; 255 is full scale
//
// A sample is any number of clocks' lights, the last with in_last. Latency 29 clocks from
// there; lights at every clock, and no pause between samples.

`timescale 1ns / 1ps
`default_nettype none

module image_bivariate_lights #(
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
    // synchronous reset, active high: drops all that is under way, whatever ce is
    input  wire        rst,
    // clock enable: 0 freezes the whole pipeline
    input  wire        ce,
    // the other inputs are to be taken
    input  wire        in_valid,
    // with the lights of this clock the sample ends
    input  wire        in_last,
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
    // the other outputs are a sample: 29 enabled clocks behind its in_last
    output wire        out_valid,
    // UQ8.0: red; 255 is full scale
    output wire [7:0] out_r,
    // UQ8.0: green; 255 is full scale
    output wire [7:0] out_g,
    // UQ8.0: blue; 255 is full scale
    output wire [7:0] out_b
);

    // ===== The core: what the lights of a clock give
    wire sum_valid;
    wire [17:0] out_sum_r;
    wire [17:0] out_sum_g;
    wire [17:0] out_sum_b;
    image_bivariate #(
        .TEXELS_1_EVEN_EVEN_FILE(TEXELS_1_EVEN_EVEN_FILE),
        .TEXELS_1_EVEN_ODD_FILE(TEXELS_1_EVEN_ODD_FILE),
        .TEXELS_1_ODD_EVEN_FILE(TEXELS_1_ODD_EVEN_FILE),
        .TEXELS_1_ODD_ODD_FILE(TEXELS_1_ODD_ODD_FILE)
    ) core (
        .clk       (clk),
        .rst       (rst),
        .ce        (ce),
        .in_valid  (in_valid),
        .in_nx     (in_nx),
        .in_ny     (in_ny),
        .in_nz     (in_nz),
        .in_l1x    (in_l1x),
        .in_l1y    (in_l1y),
        .in_l1z    (in_l1z),
        .in_h1x    (in_h1x),
        .in_h1y    (in_h1y),
        .in_h1z    (in_h1z),
        .in_band1  (in_band1),
        .in_blend1 (in_blend1),
        .in_shift1 (in_shift1),
        .in_gain1r (in_gain1r),
        .in_gain1g (in_gain1g),
        .in_gain1b (in_gain1b),
        .out_valid (sum_valid),
        .out_sum_r (out_sum_r),
        .out_sum_g (out_sum_g),
        .out_sum_b (out_sum_b)
    );

    // ===== Valid chain of whole samples: a bit where one's last lights are, in step with the core
    reg [29:1] valid;
    initial valid = 29'd0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 29'd0;
        end else if (ce) begin
            valid <= {valid[28:1], in_valid & in_last};
        end
    end

    // ===== Stage 28: half a code and a sample's lights below 1.0, and whether they have reached that
    reg [16:0] so_far_r;
    reg was_full_r;
    initial so_far_r = 17'd256;
    initial was_full_r = 1'b0;
    reg [16:0] total_r;
    reg full_r;
    wire [18:0] sum_r = {2'b00, so_far_r} + {1'b0, out_sum_r};
    wire is_full_r = was_full_r | |sum_r[18:17];
    reg [16:0] so_far_g;
    reg was_full_g;
    initial so_far_g = 17'd256;
    initial was_full_g = 1'b0;
    reg [16:0] total_g;
    reg full_g;
    wire [18:0] sum_g = {2'b00, so_far_g} + {1'b0, out_sum_g};
    wire is_full_g = was_full_g | |sum_g[18:17];
    reg [16:0] so_far_b;
    reg was_full_b;
    initial so_far_b = 17'd256;
    initial was_full_b = 1'b0;
    reg [16:0] total_b;
    reg full_b;
    wire [18:0] sum_b = {2'b00, so_far_b} + {1'b0, out_sum_b};
    wire is_full_b = was_full_b | |sum_b[18:17];
    always @(posedge clk) begin
        if (rst | (ce & valid[27])) begin
            so_far_r   <= 17'd256;
            was_full_r <= 1'b0;
            so_far_g   <= 17'd256;
            was_full_g <= 1'b0;
            so_far_b   <= 17'd256;
            was_full_b <= 1'b0;
        end else if (ce & sum_valid) begin
            so_far_r   <= sum_r[16:0];
            was_full_r <= is_full_r;
            so_far_g   <= sum_g[16:0];
            was_full_g <= is_full_g;
            so_far_b   <= sum_b[16:0];
            was_full_b <= is_full_b;
        end
        if (ce & sum_valid) begin
            total_r <= sum_r[16:0];
            full_r  <= is_full_r;
            total_g <= sum_g[16:0];
            full_g  <= is_full_g;
            total_b <= sum_b[16:0];
            full_b  <= is_full_b;
        end
    end

    // ===== Stage 29: the code, at most full scale
    reg [7:0] code_r;
    reg [7:0] code_g;
    reg [7:0] code_b;
    always @(posedge clk) begin
        if (ce) begin
            code_r <= full_r ? 8'hff : total_r[16:9];
            code_g <= full_g ? 8'hff : total_g[16:9];
            code_b <= full_b ? 8'hff : total_b[16:9];
        end
    end

    assign out_valid = valid[29];
    assign out_r = code_r;
    assign out_g = code_g;
    assign out_b = code_b;

    // Bits that the rounding drops.
    wire unused = &{1'b0, total_r[8:0], total_g[8:0], total_b[8:0]};

endmodule

`default_nettype wire
