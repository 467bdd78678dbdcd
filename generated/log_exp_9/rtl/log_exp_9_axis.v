// log_exp_9_axis: AXI4-Stream interfaces for the core log_exp_9
//
// Made by: brdfgen generate core.toml
// Spec 608aa1feabb28d90. Generated; the wrapper is yours to use under any terms.
//
// s_axis_tdata, 3 bytes:
//   [7:0]  in_n   UQ8.0 shininess, 1 to 255; outside: the nearest end
//   [23:8] in_cos Q1.14 cosine x; below 0 gives 0, above 1 counts as 1
//
// m_axis_tdata, 2 bytes:
//   [14:0] out_spec UQ1.14 the lobe, 0 to 1; 1.0 is exact
//   [15]   0
//
// tlast and tuser stay with their beat. tkeep and tstrb are not needed: a beat is always whole.
// Latency 12 clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and
// m_axis_tready leads to registers only.

`timescale 1ns / 1ps
`default_nettype none

module log_exp_9_axis (
    // clock; everything happens on its rising edge
    input  wire        aclk,
    // synchronous reset, active low: every beat under way is dropped
    input  wire        aresetn,
    // the core's inputs, packed
    input  wire [23:0] s_axis_tdata,
    // a beat is offered
    input  wire        s_axis_tvalid,
    // the beat is taken; from a register
    output wire        s_axis_tready,
    // goes with the beat
    input  wire        s_axis_tlast,
    // goes with the beat
    input  wire [0:0]  s_axis_tuser,
    // the core's outputs, packed
    output wire [15:0] m_axis_tdata,
    // a beat is there; it stays until it is taken
    output wire        m_axis_tvalid,
    // the beat is taken
    input  wire        m_axis_tready,
    // as it came with the beat
    output wire        m_axis_tlast,
    // as it came with the beat
    output wire [0:0]  m_axis_tuser
);

    // ===== The core
    // The enable of the whole pipeline and the source's tready: a register.
    reg ready;
    initial ready = 1'b0;
    wire out_valid;
    wire [14:0] out_spec;
    log_exp_9 core (
        .clk       (aclk),
        .rst       (~aresetn),
        .ce        (ready),
        .in_valid  (s_axis_tvalid),
        .in_n      (s_axis_tdata[7:0]),
        .in_cos    (s_axis_tdata[23:8]),
        .out_valid (out_valid),
        .out_spec  (out_spec)
    );

    // ===== tlast and tuser, in step with the core's valid chain
    reg [12:1] last;
    reg [11:0] user;
    always @(posedge aclk) begin
        if (ready) begin
            last <= {last[11:1], s_axis_tlast};
            user <= {user[10:0], s_axis_tuser};
        end
    end

    // ===== Skid register
    // The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    // whatever the sink does: a beat that the sink leaves waits in the skid register.
    wire [16:0] beat = {
        user[11],
        last[12],
        out_spec
    };
    reg [16:0] skid;
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
    wire [16:0] shown =
        skid_valid ? skid : out_valid ? beat : 17'd0;
    assign s_axis_tready = ready;
    assign m_axis_tvalid = skid_valid | out_valid;
    assign m_axis_tdata = {1'd0, shown[14:0]};
    assign m_axis_tlast = shown[15];
    assign m_axis_tuser = shown[16];

endmodule

`default_nettype wire
