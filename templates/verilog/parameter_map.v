{% if !rom_files.is_empty() %} #(
{%- for file in rom_files %}
        .{{ file.parameter }}({{ file.parameter }}){% if !loop.last %},{% endif %}
{%- endfor %}
    ){% endif %}