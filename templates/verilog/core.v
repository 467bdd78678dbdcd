{%- for line in texts.header %}
{%- if line.is_empty() %}
//
{%- else %}
// {{ line }}
{%- endif %}
{%- endfor %}

`timescale 1ns / 1ps
`default_nettype none

module {{ texts.name }}
{%- if let Some(file) = texts.rom_file %} #(
    // Path of the coefficient ROM, read by $readmemh.
    parameter ROM_FILE = "{{ file }}"
)
{%- endif %} (
    // Clock; everything happens on its rising edge.
    input  wire        clk,
    // Synchronous reset: clears the valid chain, whatever ce is.
    input  wire        rst,
    // Clock enable: 0 freezes the whole pipeline.
    input  wire        ce,
    // in_n and {{ operand }} are to be taken.
    input  wire        in_valid,
    // {{ index_format }}: selects the shininess.
    input  wire {{ index_range }}in_n,
    // {{ operand_format }}: {% if operand_signed %}cosine; below 0 gives 0, above 1 counts as 1.{% else %}versine; above 1 counts as 1, which gives 0.{% endif %}
    input  wire {{ operand_range }}{{ operand }},
    // out_spec is a result: in_valid, {{ latency }} enabled clocks later.
    output wire        out_valid,
    // {{ output_format }}: the lobe, 0 to 1.
    output wire {{ output_range }}out_spec
);

    // ===== Valid chain
    reg [{{ latency }}:1] valid;
    always @(posedge clk) begin
        if (rst) begin
            valid <= {{ latency }}'d0;
        end else if (ce) begin
            valid <= {% if latency == 1 %}in_valid{% else %}{valid[{{ latency - 1 }}:1], in_valid}{% endif %};
        end
    end
{%- for stage in stages %}

    // ===== Stage {{ stage.index }}: {{ stage.heading }}
{%- if stage.index == rom_stage %}
    // The word of the coefficient ROM, of {{ rom_depth }} words.
    {% if texts.rom_file.is_some() && !rom_registered %}wire{% else %}reg{% endif %} {{ rom_range }}{{ rom_name }};
{%- endif %}
{%- for wire in stage.wires %}
    // {{ wire.comment }}
    wire {{ wire.range }}{{ wire.name }} ={{ wire.expression }};
{%- endfor %}
{%- if stage.index == rom_stage %}
{%- if texts.rom_file.is_some() %}
    reg {{ rom_range }}rom [0:{{ rom_depth - 1 }}];
    initial $readmemh(ROM_FILE, rom);
{%- if rom_registered %}
    always @(posedge clk) begin
        if (ce) {{ rom_name }} <= rom[{{ rom_address }}];
    end
{%- else %}
    assign {{ rom_name }} = rom[{{ rom_address }}];
{%- endif %}
{%- else if rom_registered %}
    always @(posedge clk) begin
        if (ce) begin
            case ({{ rom_address }})
{%- for (address, word) in rom_rows %}
                {{ address }}: {{ rom_name }} <= {{ word }};
{%- endfor %}
                default: {{ rom_name }} <= {{ rom_rows[0].1 }};
            endcase
        end
    end
{%- else %}
    always @* begin
        case ({{ rom_address }})
{%- for (address, word) in rom_rows %}
            {{ address }}: {{ rom_name }} = {{ word }};
{%- endfor %}
            default: {{ rom_name }} = {{ rom_rows[0].1 }};
        endcase
    end
{%- endif %}
{%- endif %}
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

    assign out_valid = valid[{{ latency }}];
    assign out_spec  = {{ output }};
{%- if !unused.is_empty() %}

    // Bits that the roundings drop.
    wire unused = &{1'b0{% for bits in unused %},
                    {{ bits }}{% endfor %}};
{%- endif %}

endmodule

`default_nettype wire
