`default_nettype none

// {{ name }} with the memory that it reads.
module {{ ExternalMemory::closed_name(name) }} (
{%- for port in declarations %}
    {{ port.declaration }}{% if !loop.last %},{% endif %}
{%- endfor %}
);
{% for part in memory.parts %}
    wire [{{ part.address_bits - 1 }}:0] {{ part.port.address.name }};
    wire [{{ part.bits - 1 }}:0] {{ part.port.data.name }};
{%- endfor %}

    {{ name }} dut (
{%- for port in shown.iter().chain(own) %}
        .{{ port }}({{ port }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );

    {{ memory.name }} memory (
        .clk(clk),
        .ce(ce),
{%- for port in own %}
        .{{ port }}({{ port }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );

endmodule

`default_nettype wire
