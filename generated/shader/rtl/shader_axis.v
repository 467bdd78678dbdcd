// shader_axis: AXI4-Stream interfaces for the core shader
//
// Made by: brdfgen generate core.toml
// Spec ef73cb5e346c03ce. Generated; the wrapper is yours to use under any terms.
//
// s_axis_tdata, 28 bytes:
//   [1:0]     in_material   UQ2.0 index of the material, 0 to 3; above: the last
//   [19:2]    in_nx         Q1.16 x of the normal N, of unit length
//   [37:20]   in_ny         Q1.16 y of the normal N, of unit length
//   [55:38]   in_nz         Q1.16 z of the normal N, of unit length
//   [73:56]   in_vx         Q1.16 x of the unit vector V to the viewer
//   [91:74]   in_vy         Q1.16 y of the unit vector V to the viewer
//   [109:92]  in_vz         Q1.16 z of the unit vector V to the viewer
//   [127:110] in_l1x        Q1.16 x of the unit vector L to light 1
//   [145:128] in_l1y        Q1.16 y of the unit vector L to light 1
//   [163:146] in_l1z        Q1.16 z of the unit vector L to light 1
//   [181:164] in_l2x        Q1.16 x of the unit vector L to light 2
//   [199:182] in_l2y        Q1.16 y of the unit vector L to light 2
//   [217:200] in_l2z        Q1.16 z of the unit vector L to light 2
//   [223:218] of no meaning
//
// m_axis_tdata, 3 bytes:
//   [7:0]   out_r UQ8.0 red; 255 is full scale
//   [15:8]  out_g UQ8.0 green; 255 is full scale
//   [23:16] out_b UQ8.0 blue; 255 is full scale
//
// tlast and tuser stay with their beat. tkeep and tstrb are not needed: a beat is always whole.
// Latency 16 clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and
// m_axis_tready leads to registers only.

`timescale 1ns / 1ps
`default_nettype none

module shader_axis (
    // clock; everything happens on its rising edge
    input  wire         aclk,
    // synchronous reset, active low: every beat under way is dropped
    input  wire         aresetn,
    // the core's inputs, packed
    input  wire [223:0] s_axis_tdata,
    // a beat is offered
    input  wire         s_axis_tvalid,
    // the beat is taken; from a register
    output wire         s_axis_tready,
    // goes with the beat
    input  wire         s_axis_tlast,
    // goes with the beat
    input  wire [7:0]   s_axis_tuser,
    // the core's outputs, packed
    output wire [23:0]  m_axis_tdata,
    // a beat is there; it stays until it is taken
    output wire         m_axis_tvalid,
    // the beat is taken
    input  wire         m_axis_tready,
    // as it came with the beat
    output wire         m_axis_tlast,
    // as it came with the beat
    output wire [7:0]   m_axis_tuser
);

    // ===== The core
    // The enable of the whole pipeline and the source's tready: a register.
    reg ready;
    initial ready = 1'b0;
    wire out_valid;
    wire [7:0] out_r;
    wire [7:0] out_g;
    wire [7:0] out_b;
    shader core (
        .clk         (aclk),
        .rst         (~aresetn),
        .ce          (ready),
        .in_valid    (s_axis_tvalid),
        .in_material (s_axis_tdata[1:0]),
        .in_nx       (s_axis_tdata[19:2]),
        .in_ny       (s_axis_tdata[37:20]),
        .in_nz       (s_axis_tdata[55:38]),
        .in_vx       (s_axis_tdata[73:56]),
        .in_vy       (s_axis_tdata[91:74]),
        .in_vz       (s_axis_tdata[109:92]),
        .in_l1x      (s_axis_tdata[127:110]),
        .in_l1y      (s_axis_tdata[145:128]),
        .in_l1z      (s_axis_tdata[163:146]),
        .in_l2x      (s_axis_tdata[181:164]),
        .in_l2y      (s_axis_tdata[199:182]),
        .in_l2z      (s_axis_tdata[217:200]),
        .out_valid   (out_valid),
        .out_r       (out_r),
        .out_g       (out_g),
        .out_b       (out_b)
    );

    // ===== tlast and tuser, in step with the core's valid chain
    reg [16:1] last;
    reg [127:0] user;
    always @(posedge aclk) begin
        if (ready) begin
            last <= {last[15:1], s_axis_tlast};
            user <= {user[119:0], s_axis_tuser};
        end
    end

    // ===== Skid register
    // The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    // whatever the sink does: a beat that the sink leaves waits in the skid register.
    wire [32:0] beat = {
        user[127:120],
        last[16],
        out_b,
        out_g,
        out_r
    };
    reg [32:0] skid;
    always @(posedge aclk) begin
        if (ready) skid <= beat;
    end

    reg skid_valid;
    initial skid_valid = 1'b0;
    wire waits = m_axis_tvalid & ~m_axis_tready;
    always @(posedge aclk) begin
        if (~aresetn) begin
            ready <= 1'b0;
            skid_valid <= 1'b0;
        end else begin
            ready <= ~waits;
            skid_valid <= waits;
        end
    end

    // 0 while there is no beat: until one has passed them, the core's registers are unknown.
    wire [32:0] shown =
        skid_valid ? skid : out_valid ? beat : 33'd0;
    assign s_axis_tready = ready;
    assign m_axis_tvalid = skid_valid | out_valid;
    assign m_axis_tdata = shown[23:0];
    assign m_axis_tlast = shown[24];
    assign m_axis_tuser = shown[32:25];

    // What fills s_axis_tdata up to whole bytes.
    wire unused = &{1'b0, s_axis_tdata[223:218]};

endmodule

`default_nettype wire
