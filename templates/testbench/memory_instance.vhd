{%- if let Some(memory) = bench.memory %}

    -- The memory outside of the core.
    memory : entity work.{{ memory.name }}
        generic map (
{%- for part in memory.parts %}
            {{ part.file.parameter }} => {{ part.file.parameter }}{% if !loop.last %},{% endif %}
{%- endfor %}
        )
        port map (
            clk => {{ clock }},
            ce => {{ enable }},
{%- for part in memory.parts %}
            {{ part.port.address.name }} => {{ part.port.address.name }},
            {{ part.port.data.name }} => {{ part.port.data.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
        );
{%- endif %}
