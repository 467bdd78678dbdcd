{%- let header = &axis.header %}
{%- let rom_files = &texts.rom_files %}
{%- include "verilog/header.v" %}

`timescale 1ns / 1ps
`default_nettype none

module {{ axis.name }}
{%- include "verilog/parameters.v" %} (
{%- for (comment, declaration) in ports %}
    // {{ comment }}
    {{ declaration }}{% if !loop.last %},{% endif %}
{%- endfor %}
);

    // ===== The core
    // The enable of the whole pipeline{% if !axis.takes_samples() %} and the source's tready{% endif %}: a register.
    reg ready;
    initial ready = 1'b0;
{%- if axis.takes_samples() %}
    // Whether the table takes a sample: it reads the last word of the one before, or none.
    wire in_ready;
{%- endif %}
    wire out_valid;
{%- for lane in axis.outputs.lanes %}
    wire [{{ lane.bits - 1 }}:0] {{ lane.port.name }};
{%- endfor %}
    {{ texts.name }}{% include "verilog/parameter_map.v" %} core (
        .{{ axis.padded("clk") }} (aclk),
        .{{ axis.padded("rst") }} (~aresetn),
        .{{ axis.padded("ce") }} (ready),
        .{{ axis.padded("in_valid") }} (s_axis_tvalid),
{%- if axis.takes_samples() %}
        .{{ axis.padded("in_ready") }} (in_ready),
{%- endif %}
{%- if axis.sequenced %}
        .{{ axis.padded("in_last") }} (s_axis_tlast),
{%- endif %}
{%- for lane in axis.inputs.lanes %}
        .{{ axis.padded(lane.port.name) }} (s_axis_tdata[{{ lane.range() }}]),
{%- endfor %}
{%- for port in axis.memories %}
        .{{ axis.padded(port.name) }} ({{ port.name }}),
{%- endfor %}
        .{{ axis.padded("out_valid") }} (out_valid),
{%- for lane in axis.outputs.lanes %}
        .{{ axis.padded(lane.port.name) }} ({{ lane.port.name }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );

{% if axis.sequenced %}    // ===== tuser, in step with the core's valid chain
{%- else %}    // ===== tlast and tuser, in step with the core's valid chain
{%- if axis.takes_samples() %}
    // In front they are those of the sample whose words are read, and go on with each word.
{%- endif %}
    reg [{{ axis.latency }}:1] last;
{%- endif %}
    reg [{{ axis.user_bits() - 1 }}:0] user;
    always @(posedge aclk) begin
        if (ready) begin
{%- if axis.latency == 1 %}
            last <= s_axis_tlast;
            user <= s_axis_tuser;
{%- else %}
{%- if !axis.sequenced %}
            last <= {last[{{ axis.latency - 1 }}:1], {% if axis.takes_samples() %}in_ready ? s_axis_tlast : last[1]{% else %}s_axis_tlast{% endif %}};
{%- endif %}
            user <= {user[{{ axis.user_low() - 1 }}:0], {% if axis.takes_samples() %}in_ready ? s_axis_tuser : user[{{ axis.newest_user() }}]{% else %}s_axis_tuser{% endif %}};
{%- endif %}
        end
    end

    // ===== Skid register
    // The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    // whatever the sink does: a beat that the sink leaves waits in the skid register.
    wire [{{ axis.beat_bits() - 1 }}:0] beat = {
        user[{{ axis.oldest_user() }}],
        {% if axis.sequenced %}1'b1{% else %}last[{{ axis.latency }}]{% endif %},
{%- for lane in axis.outputs.lanes.iter().rev() %}
        {{ lane.port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
    };
    reg [{{ axis.beat_bits() - 1 }}:0] skid;
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
    wire [{{ axis.beat_bits() - 1 }}:0] shown =
        skid_valid ? skid : out_valid ? beat : {{ axis.beat_bits() }}'d0;
{%- if axis.reads_outside() %}
    assign texels_ce = ready;
{%- endif %}
    assign s_axis_tready = ready{% if axis.takes_samples() %} & in_ready{% endif %};
    assign m_axis_tvalid = skid_valid | out_valid;
    assign m_axis_tdata = {% if axis.outputs.padding() > 0 %}{ {{- axis.outputs.padding() }}'d0, shown[{{ axis.outputs.bits - 1 }}:0]}{% else %}shown[{{ axis.outputs.bits - 1 }}:0]{% endif %};
    assign m_axis_tlast = shown[{{ axis.outputs.bits }}];
    assign m_axis_tuser = shown[{{ axis.shown_user() }}];
{%- if axis.inputs.padding() > 0 %}

    // What fills s_axis_tdata up to whole bytes.
    wire unused = &{1'b0, s_axis_tdata[{{ axis.inputs.padding_range() }}]};
{%- endif %}

endmodule

`default_nettype wire
