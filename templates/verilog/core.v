{%- let header = &texts.header %}
{%- let rom_files = &texts.rom_files %}
{%- include "verilog/header.v" %}

`timescale 1ns / 1ps
`default_nettype none

module {{ texts.name }}
{%- include "verilog/parameters.v" %} (
{%- for port in ports %}
    // {{ port.comment }}
    {{ port.declaration }}{% if !loop.last %},{% endif %}
{%- endfor %}
);

    // ===== Valid chain
    reg [{{ latency }}:1] valid;
    initial valid = {{ latency }}'d0;
    always @(posedge clk) begin
        if (rst) begin
            valid <= {{ latency }}'d0;
        end else if (ce) begin
            valid <= {% if latency == 1 %}in_valid{% else %}{valid[{{ latency - 1 }}:1], in_valid}{% endif %};
        end
    end
{%- if let Some(last) = set_stage %}

    // ===== The set of texels, in step with what is looked up in it
{%- if *last > 0 %}
    reg [{{ last }}:1] sets;
    always @(posedge clk) begin
        if (ce) sets <= {% if *last == 1 %}in_set{% else %}{sets[{{ last - 1 }}:1], in_set}{% endif %};
    end
{%- endif %}
{%- endif %}
{%- for stage in stages %}

    // ===== Stage {{ stage.index }}: {{ stage.heading }}
{%- for memory in stage.memories %}
    // The word of the memory {{ memory.name }}{% if memory.outside.is_some() %} outside of the core{% endif %}, of {% if memory.second.is_some() %}two sets of {% endif %}{{ memory.depth }} words.
    {% if memory.in_array() && !memory.registered %}wire{% else %}reg{% endif %} {{ memory.range }}{{ memory.word }};
{%- endfor %}
{%- for wire in stage.wires %}
    // {{ wire.comment }}
    wire {{ wire.range }}{{ wire.name }} ={{ wire.expression }};
{%- endfor %}
{%- for memory in stage.memories %}
{%- if let Some(outside) = memory.outside %}
    assign {{ outside.address.name }} = {{ memory.address }};
    always @(posedge clk) begin
        if (ce) {{ memory.word }} <= {{ outside.data.name }};
    end
{%- else if memory.in_array() %}
{%- if let Some(write) = memory.write %}
    // What is read from an address at the edge at which it is written is not defined: the attribute
    // spares the logic that would make it so.
    (* ramstyle = "no_rw_check" *) reg {{ memory.range }}{{ memory.name }} [0:{{ memory.last() }}];
{%- if let Some(parameter) = memory.parameter %}
{%- if let Some(second) = memory.second %}
    initial begin
        $readmemh({{ parameter }}, {{ memory.name }}, 0, {{ memory.depth - 1 }});
        $readmemh({{ parameter }}, {{ memory.name }}, {{ second }}, {{ memory.last() }});
    end
{%- else %}
    initial $readmemh({{ parameter }}, {{ memory.name }});
{%- endif %}
{%- else %}
    initial begin
{%- for (_, word) in memory.rows %}
        {{ memory.name }}[{{ loop.index0 }}] = {{ word }};
{%- endfor %}
    end
{%- endif %}
    always @(posedge clk) begin
        if ({{ write.enable.name }}) {{ memory.name }}[{{ write.address.name }}] <= {{ write.data.name }};
    end
{%- else if let Some(parameter) = memory.parameter %}
    reg {{ memory.range }}{{ memory.name }} [0:{{ memory.depth - 1 }}];
    initial $readmemh({{ parameter }}, {{ memory.name }});
{%- endif %}
{%- if memory.registered %}
    always @(posedge clk) begin
        if (ce) {{ memory.word }} <= {{ memory.name }}[{{ memory.address }}];
    end
{%- else %}
    assign {{ memory.word }} = {{ memory.name }}[{{ memory.address }}];
{%- endif %}
{%- else if memory.registered %}
    always @(posedge clk) begin
        if (ce) begin
            case ({{ memory.address }})
{%- for (address, word) in memory.rows %}
                {{ address }}: {{ memory.word }} <= {{ word }};
{%- endfor %}
                default: {{ memory.word }} <= {{ memory.rows[0].1 }};
            endcase
        end
    end
{%- else %}
    always @* begin
        case ({{ memory.address }})
{%- for (address, word) in memory.rows %}
            {{ address }}: {{ memory.word }} = {{ word }};
{%- endfor %}
            default: {{ memory.word }} = {{ memory.rows[0].1 }};
        endcase
    end
{%- endif %}
{%- endfor %}
{%- if !stage.regs.is_empty() %}
{%- for reg in stage.regs %}
    reg {{ reg.range }}{{ reg.name }};
{%- endfor %}
    always @(posedge clk) begin
        if (ce) begin
{%- for reg in stage.regs %}
            {{ reg.name }} <= {{ reg.source }};
{%- endfor %}
        end
    end
{%- endif %}
{%- endfor %}

    assign {{ out_valid }} = valid[{{ latency }}];
{%- for (port, source) in outputs %}
    assign {{ port }} = {{ source }};
{%- endfor %}
{%- if !unused.is_empty() %}

    // Bits that the roundings drop.
    wire unused = &{1'b0{% for bits in unused %},
                    {{ bits }}{% endfor %}};
{%- endif %}

endmodule

`default_nettype wire
