{%- if !rom_files.is_empty() %}
    generic (
{%- for file in rom_files %}
        -- Path of the memory {{ file.memory }}, in the format of Verilog's $readmemh.
        {{ file.parameter }} : string := "{{ file.path }}"{% if !loop.last %};{% endif %}
{%- endfor %}
    );
{%- endif %}
