{%- if let Some(memory) = bench.memory %}

    // ------------------------------------------------- the memory outside of the core
    {{ memory.name }} #(
{%- for part in memory.parts %}
        .{{ part.file.parameter }}({{ part.file.parameter }}){% if !loop.last %},{% endif %}
{%- endfor %}
    ) memory (
        .clk({{ clock }}),
        .ce({{ enable }}),
{%- for part in memory.parts %}
        .{{ part.port.address.name }}({{ part.port.address.name }}),
        .{{ part.port.data.name }}({{ part.port.data.name }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- endif %}
