{%- let header = &memory.header %}
{%- include "verilog/header.v" %}

`timescale 1ns / 1ps
`default_nettype none

/* verilator lint_off DECLFILENAME */ // it lies beside the benches that use it
module {{ memory.name }}
/* verilator lint_on DECLFILENAME */
{%- include "verilog/parameters.v" %} (
    input  wire clk,
    input  wire ce{% for part in memory.parts %},
    input  wire [{{ part.address_bits - 1 }}:0] {{ part.port.address.name }},
    output wire [{{ part.bits - 1 }}:0] {{ part.port.data.name }}
{%- endfor %}
);
{%- for part in memory.parts %}

    reg [{{ part.bits - 1 }}:0] words_{{ loop.index }} [0:{{ part.depth - 1 }}];
    initial $readmemh({{ part.file.parameter }}, words_{{ loop.index }});
    // The words under way, the last one in the leading bits.
    reg [{{ memory.clocks * part.bits - 1 }}:0] way_{{ loop.index }};
    always @(posedge clk) begin
{%- if memory.clocks == 1 %}
        if (ce) way_{{ loop.index }} <= words_{{ loop.index }}[{{ part.port.address.name }}];
{%- else %}
        if (ce) begin
            way_{{ loop.index }} <= {
                way_{{ loop.index }}[{{ (memory.clocks - 1) * part.bits - 1 }}:0],
                words_{{ loop.index }}[{{ part.port.address.name }}]
            };
        end
{%- endif %}
    end
    assign {{ part.port.data.name }} = way_{{ loop.index }}[{{ memory.clocks * part.bits - 1 }}:{{ (memory.clocks - 1) * part.bits }}];
{%- endfor %}

endmodule

`default_nettype wire
