{%- if let Some(table) = bench.written_table() %}

        -- So many words of one half of the table are the next sample's, while the sample before
        -- may still read the other.
        procedure choose_words is
        begin
            begins_at := 0;
            if half then
                begins_at := {{ table.depth / 2 }};
            end if;
            half  := not half;
            words := 1;
{%- if table.length_bits() > 0 %}
            draw;
            if (vectors / 32) mod 2 = 1 then
                words := to_integer(unsigned(lfsr({{ table.length_bits() - 1 }} downto 0))) + 1;
            end if;
{%- endif %}
        end procedure;

        -- The light of the vector that was read last at the write port of the table.
        procedure present_light(written : natural) is
        begin
            lights_en   <= '1';
            lights_addr <= std_logic_vector(to_unsigned(written, {{ table.address_bits }}));
{%- for lane in table.lanes %}
            lights_data({{ lane.downto() }}) <= file_{{ lane.port.name }};
{%- endfor %}
        end procedure;

        -- What is to come out for a sample of that light so many times.
        procedure add_words is
        begin
            opened := false;
            for i in 1 to words loop
                add_lights(false);
            end loop;
        end procedure;
{%- endif %}
