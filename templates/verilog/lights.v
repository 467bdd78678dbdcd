{%- let header = &sequencer.header %}
{%- let rom_files = &core.rom_files %}
{%- include "verilog/header.v" %}

`timescale 1ns / 1ps
`default_nettype none

module {{ sequencer.name }}
{%- include "verilog/parameters.v" %} (
{%- for port in ports %}
    // {{ port.comment }}
    {{ port.declaration }}{% if !loop.last %},{% endif %}
{%- endfor %}
);
{%- if sequencer.swaps() %}

    // ===== The set of texels that samples are looked up in: the other one behind a swap
    reg in_set;
    initial in_set = 1'b0;
    always @(posedge clk) begin
        if (rst) begin
            in_set <= 1'b0;
        end else if (ce & in_valid & in_last & swap) begin
            in_set <= ~in_set;
        end
    end
{%- endif %}

    // ===== The core: what the lights of a clock give
    wire sum_valid;
{%- for port in sequencer.core_outputs() %}
    wire [{{ port.high() }}:0] {{ port.name }};
{%- endfor %}
    {{ core.name }}{% include "verilog/parameter_map.v" %} core (
        .{{ sequencer.padded("clk") }} (clk),
        .{{ sequencer.padded("rst") }} (rst),
        .{{ sequencer.padded("ce") }} (ce),
        .{{ sequencer.padded("in_valid") }} (in_valid),
{%- for port in sequencer.driven().iter().chain(sequencer.addresses()) %}
        .{{ sequencer.padded(port.name) }} ({{ port.name }}),
{%- endfor %}
        .{{ sequencer.padded("out_valid") }} (sum_valid),
{%- for port in sequencer.core_outputs() %}
        .{{ sequencer.padded(port.name) }} ({{ port.name }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );

    // ===== Valid chain of whole samples: a bit where one's last lights are, in step with the core
    reg [{{ sequencer.latency }}:1] valid;
    initial valid = {{ sequencer.latency }}'d0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= {{ sequencer.latency }}'d0;
        end else if (ce) begin
            valid <= {valid[{{ sequencer.latency - 1 }}:1], in_valid & in_last};
        end
    end

    // Whether the next lights out of the core are the first of their sample.
    reg begins;
    initial begins = 1'b1;
    always @(posedge clk) begin
        if (rst) begin
            begins <= 1'b1;
        end else if (ce & sum_valid) begin
            begins <= valid[{{ sequencer.core_latency }}];
        end
    end

    // ===== Stage {{ sequencer.core_latency + 1 }}: the sum of a sample's lights below 1.0, and whether it has reached that
{%- for channel in channels %}
    reg [{{ f - 1 }}:0] total_{{ channel.c }};
    reg full_{{ channel.c }};
    wire [{{ f }}:0] start_{{ channel.c }} = begins ? {{ channel.start }} : {1'b0, total_{{ channel.c }}};
    wire [{{ f + 1 }}:0] sum_{{ channel.c }} = {1'b0, start_{{ channel.c }}} + {1'b0, out_sum_{{ channel.c }}};
    wire over_{{ channel.c }} = |sum_{{ channel.c }}[{{ f + 1 }}:{{ f }}];
{%- endfor %}
    always @(posedge clk) begin
        if (ce & sum_valid) begin
{%- for channel in channels %}
            total_{{ channel.c }} <= sum_{{ channel.c }}[{{ f - 1 }}:0];
            full_{{ channel.c }}  <= over_{{ channel.c }} | (full_{{ channel.c }} & ~begins);
{%- endfor %}
        end
    end

    // ===== Stage {{ sequencer.latency }}: the nearest code, at most full scale
{%- for channel in channels %}
    wire [{{ f }}:0] near_{{ channel.c }} = {1'b0, total_{{ channel.c }}} + {{ f + 1 }}'d{{ sequencer.sums.half_code() }};
    reg [{{ bits - 1 }}:0] code_{{ channel.c }};
{%- endfor %}
    always @(posedge clk) begin
        if (ce) begin
{%- for channel in channels %}
            code_{{ channel.c }} <= (full_{{ channel.c }} | near_{{ channel.c }}[{{ f }}]) ? {{ bits }}'h{{ "{:x}"|format(sequencer.sums.full_scale()) }} : near_{{ channel.c }}[{{ f - 1 }}:{{ f - bits }}];
{%- endfor %}
        end
    end

    assign out_valid = valid[{{ sequencer.latency }}];
{%- if sequencer.swaps() %}
    assign texel_set = in_set;
{%- endif %}
{%- for channel in channels %}
    assign out_{{ channel.c }} = code_{{ channel.c }};
{%- endfor %}

    // Bits that the rounding drops.
    wire unused = &{1'b0
{%- for channel in channels %}, near_{{ channel.c }}[{{ f - bits - 1 }}:0]{% endfor %}};

endmodule

`default_nettype wire
