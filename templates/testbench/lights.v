{%- if let Some(sums) = bench.sums %}

    // The sum of a sample's lights up to the vector that was read last, and what is to come out
    // for it. It has no bound here: the core may keep it at 1.0 at every step.
    reg     opened = 1'b0; // there are lights before it,
    integer lights = 0;    // and so many up to it
{%- for c in CHANNELS %}
    reg [47:0] total_{{ c }} = 48'd0;
    reg [47:0] near_{{ c }};
{%- endfor %}

    task add_lights;
        begin
            if (!opened) begin
                lights = 0;
{%- for c in CHANNELS %}
                total_{{ c }} = 48'd0;
{%- if let Some(ambient) = sums.ambient %}
                total_{{ c }}[{{ ambient - 1 }}:0] = file_out_ambient_{{ c }};
                total_{{ c }} = total_{{ c }} << {{ sums.frac_bits - ambient }};
{%- endif %}
{%- endfor %}
            end
            lights = lights + 1;
            opened = !in_last;
{%- for c in CHANNELS %}
            total_{{ c }} = total_{{ c }} + { {{- 47 - sums.frac_bits }}'d0, file_out_sum_{{ c }}};
            near_{{ c }} = (total_{{ c }} + 48'd{{ sums.half_code() }}) >> {{ sums.frac_bits - sums.channel_bits }};
            expected_out_{{ c }} = (near_{{ c }} > 48'd{{ sums.full_scale() }}) ? {{ sums.channel_bits }}'d{{ sums.full_scale() }} : near_{{ c }}[{{ sums.channel_bits - 1 }}:0];
{%- endfor %}
        end
    endtask
{%- if bench.table.is_none() %}

    // Samples of one light, of two on average, of four, and long ones; the last vector ends one.
    task choose_last;
        begin
            draw;
            case ((vectors / 32) % 4)
                0: in_last = 1'b1;
                1: in_last = lfsr[31];
                2: in_last = (lfsr[31:30] == 2'd0);
                default: in_last = (lfsr[31:27] == 5'd0);
            endcase
            if (vectors == count)
                in_last = 1'b1;
        end
    endtask
{%- endif %}
{%- endif %}
