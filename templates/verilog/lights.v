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

    // ===== Stage {{ sequencer.core_latency + 1 }}: half a code and a sample's lights below 1.0, and whether they have reached that
{%- for channel in channels %}
    reg [{{ f - 1 }}:0] so_far_{{ channel.c }};
    reg was_full_{{ channel.c }};
    initial so_far_{{ channel.c }} = {{ f }}'d{{ sequencer.sums.half_code() }};
    initial was_full_{{ channel.c }} = 1'b0;
    reg [{{ f - 1 }}:0] total_{{ channel.c }};
    reg full_{{ channel.c }};
    wire [{{ f + 1 }}:0] sum_{{ channel.c }} = {2'b00, so_far_{{ channel.c }}} + {1'b0, out_sum_{{ channel.c }}};
    wire is_full_{{ channel.c }} = was_full_{{ channel.c }} | |sum_{{ channel.c }}[{{ f + 1 }}:{{ f }}];
{%- endfor %}
    always @(posedge clk) begin
        if (rst | (ce & valid[{{ sequencer.core_latency }}])) begin
{%- for channel in channels %}
            so_far_{{ channel.c }}   <= {{ f }}'d{{ sequencer.sums.half_code() }};
            was_full_{{ channel.c }} <= 1'b0;
{%- endfor %}
        end else if (ce & sum_valid) begin
{%- for channel in channels %}
            so_far_{{ channel.c }}   <= sum_{{ channel.c }}[{{ f - 1 }}:0];
            was_full_{{ channel.c }} <= is_full_{{ channel.c }};
{%- endfor %}
        end
        if (ce & sum_valid) begin
{%- for channel in channels %}
            total_{{ channel.c }} <= sum_{{ channel.c }}[{{ f - 1 }}:0];
            full_{{ channel.c }}  <= is_full_{{ channel.c }};
{%- endfor %}
        end
    end
{%- if let Some(ambient) = sequencer.sums.ambient %}

    // The ambient light: that of a sample's first clock.
    reg begins;
    initial begins = 1'b1;
{%- for channel in channels %}
    reg [{{ ambient - 1 }}:0] ambient_{{ channel.c }};
{%- endfor %}
    always @(posedge clk) begin
        if (rst) begin
            begins <= 1'b1;
        end else if (ce & sum_valid) begin
            begins <= valid[{{ sequencer.core_latency }}];
        end
        if (ce & sum_valid & begins) begin
{%- for channel in channels %}
            ambient_{{ channel.c }} <= out_ambient_{{ channel.c }};
{%- endfor %}
        end
    end
{%- endif %}

    // ===== Stage {{ sequencer.latency }}: the code{% if sequencer.sums.ambient.is_some() %} with the ambient light{% endif %}, at most full scale
{%- for channel in channels %}
{%- if sequencer.sums.ambient.is_some() %}
    wire [{{ f }}:0] lit_{{ channel.c }} = {1'b0, total_{{ channel.c }}} + {{ channel.ambient }};
{%- endif %}
    reg [{{ bits - 1 }}:0] code_{{ channel.c }};
{%- endfor %}
    always @(posedge clk) begin
        if (ce) begin
{%- for channel in channels %}
{%- if sequencer.sums.ambient.is_some() %}
            code_{{ channel.c }} <= (full_{{ channel.c }} | lit_{{ channel.c }}[{{ f }}]) ? {{ bits }}'h{{ "{:x}"|format(sequencer.sums.full_scale()) }} : lit_{{ channel.c }}[{{ f - 1 }}:{{ f - bits }}];
{%- else %}
            code_{{ channel.c }} <= full_{{ channel.c }} ? {{ bits }}'h{{ "{:x}"|format(sequencer.sums.full_scale()) }} : total_{{ channel.c }}[{{ f - 1 }}:{{ f - bits }}];
{%- endif %}
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
{%- for channel in channels %}, {% if sequencer.sums.ambient.is_some() %}lit{% else %}total{% endif %}_{{ channel.c }}[{{ f - bits - 1 }}:0]{% endfor %}};

endmodule

`default_nettype wire
