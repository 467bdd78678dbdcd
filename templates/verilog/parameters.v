{%- if !rom_files.is_empty() %} #(
{%- for file in rom_files %}
    // Path of the memory {{ file.memory }}, read by $readmemh.
    parameter {{ file.parameter }} = "{{ file.path }}"{% if !loop.last %},{% endif %}
{%- endfor %}
)
{%- endif %}