{%- if let Some(sums) = bench.sums %}

        -- The sum of a sample's lights up to the vector that was read last, and what is to come
        -- out for it. It has no bound here: the core may keep it at 1.0 at every step.
        procedure add_lights(last : boolean) is
            constant FULL : unsigned(47 downto 0) := to_unsigned({{ sums.full_scale() }}, 48);
            variable near : unsigned(47 downto 0);
        begin
            if not opened then
                lights := 0;
{%- for c in CHANNELS %}
                total_{{ c }} := (others => '0');
{%- if let Some(ambient) = sums.ambient %}
                total_{{ c }} := shift_left(resize(unsigned(file_out_ambient_{{ c }}), 48), {{ sums.frac_bits - ambient }});
{%- endif %}
{%- endfor %}
            end if;
            lights := lights + 1;
            opened := not last;
{%- for c in CHANNELS %}
            total_{{ c }} := total_{{ c }} + unsigned(file_out_sum_{{ c }});
            near := shift_right(total_{{ c }} + {{ sums.half_code() }}, {{ sums.frac_bits - sums.channel_bits }});
            if near > FULL then
                near := FULL;
            end if;
            expected_out_{{ c }} := std_logic_vector(near({{ sums.channel_bits - 1 }} downto 0));
{%- endfor %}
        end procedure;
{%- if bench.table.is_none() %}

        -- Samples of one light, of two on average, of four, and long ones; the last vector ends
        -- one.
        impure function chosen_last return boolean is
        begin
            if vectors = count then
                return true;
            end if;
            case (vectors / 32) mod 4 is
                when 0 => return true;
                when 1 => return lfsr(31) = '1';
                when 2 => return lfsr(31 downto 30) = "00";
                when others => return lfsr(31 downto 27) = "00000";
            end case;
        end function;
{%- endif %}
{%- endif %}
