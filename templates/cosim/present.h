static void present(Vcore& core, const uint32_t* codes) {
{%- for (name, format) in inputs %}
    core.{{ name }} = codes[{{ loop.index0 }}] & {{ format|mask }};
{%- endfor %}
{%- for port in design.write_ports() %}
    core.{{ port.enable.name }} = 0;
{%- endfor %}
}
