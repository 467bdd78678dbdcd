{%- let header = &table.header %}
{%- let rom_files = &core.rom_files %}
{%- include "verilog/header.v" %}

`timescale 1ns / 1ps
`default_nettype none

module {{ table.name }}
{%- include "verilog/parameters.v" %} (
{%- for port in ports %}
    // {{ port.comment }}
    {{ port.declaration }}{% if !loop.last %},{% endif %}
{%- endfor %}
);
{% if words.is_empty() %}
    // ===== The table: black lights until it is written
    reg [{{ table.word_bits() - 1 }}:0] records [0:{{ table.depth - 1 }}];
    integer i;
    initial begin
        for (i = 0; i < {{ table.depth }}; i = i + 1) records[i] = {{ table.word_bits() }}'d0;
    end
    always @(posedge clk) begin
        if (lights_en) records[lights_addr] <= lights_data;
    end
{%- else %}
    // ===== The table, a word with the last of its lights first
    reg [{{ table.word_bits() - 1 }}:0] records [0:{{ table.depth - 1 }}];
    initial begin
{%- for word in words %}
        records[{{ loop.index0 }}] = {
{%- for light in word %}
            {{ light }}{% if !loop.last %},{% endif %}
{%- endfor %}
        };
{%- endfor %}
    end
{%- endif %}

    // ===== The sample whose lights are read
    reg busy;
    initial busy = 1'b0;
    reg [{{ table.address_bits - 1 }}:0] word;
    reg [{{ table.address_bits - 1 }}:0] until_word;
{%- for port in table.sample %}
    reg {{ port.range() }}now_{{ port.name }};
{%- endfor %}
    wire ends = word == until_word;
    wire free = ~busy | ends;
    always @(posedge clk) begin
        if (rst) begin
            busy <= 1'b0;
        end else if (ce & free) begin
            busy <= in_valid;
        end
    end
    always @(posedge clk) begin
        if (ce) begin
            word <= free ? in_begin : word + {{ table.address_bits }}'d1;
            if (free) begin
                until_word <= in_end;
{%- for port in table.sample %}
                now_{{ port.name }} <= {{ port.name }};
{%- endfor %}
            end
        end
    end

    // ===== Its lights, a word a clock
    reg valid;
    initial valid = 1'b0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= 1'b0;
        end else if (ce) begin
            valid <= busy;
        end
    end
    reg last;
    reg [{{ table.word_bits() - 1 }}:0] record;
{%- for port in table.sample %}
    reg {{ port.range() }}read_{{ port.name }};
{%- endfor %}
    always @(posedge clk) begin
        if (ce) begin
            last <= ends;
            record <= records[word];
{%- for port in table.sample %}
            read_{{ port.name }} <= now_{{ port.name }};
{%- endfor %}
        end
    end

    // ===== The sequencer
    {{ table.sequencer.name }}{% include "verilog/parameter_map.v" %} sequencer (
        .{{ table.padded("clk") }} (clk),
        .{{ table.padded("rst") }} (rst),
        .{{ table.padded("ce") }} (ce),
        .{{ table.padded("in_valid") }} (valid),
        .{{ table.padded("in_last") }} (last),
{%- for port in table.sample %}
        .{{ table.padded(port.name) }} (read_{{ port.name }}),
{%- endfor %}
{%- for lane in table.record.lanes %}
        .{{ table.padded(lane.port.name) }} (record[{{ lane.range() }}]),
{%- endfor %}
{%- for name in table.passed %}
        .{{ table.padded(name) }} ({{ name }}),
{%- endfor %}
        .{{ table.padded("out_valid") }} (out_valid),
        .{{ table.padded("out_r") }} (out_r),
        .{{ table.padded("out_g") }} (out_g),
        .{{ table.padded("out_b") }} (out_b)
    );

    assign in_ready = free;

endmodule

`default_nettype wire
