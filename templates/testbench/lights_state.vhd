{%- if bench.sums.is_some() %}

        -- The lights of the sample that is fed.
        variable opened : boolean := false; -- there are lights before the vector,
        variable lights : natural := 0;     -- and so many up to it
{%- for c in CHANNELS %}
        variable total_{{ c }} : unsigned(47 downto 0) := (others => '0');
{%- endfor %}
{%- endif %}
