{%- if let Some(table) = bench.written_table() %}

    // So many words of one half of the table are the next sample's, while the sample before may
    // still read the other.
    task choose_words;
        begin
            begins_at = half ? {{ table.depth / 2 }} : 0;
            half      = ~half;
            words     = 1;
{%- if table.length_bits() > 0 %}
            draw;
            if ((vectors / 32) % 2 == 1)
                words = { {{- 32 - table.length_bits() }}'d0, lfsr[{{ table.length_bits() - 1 }}:0]} + 1;
{%- endif %}
        end
    endtask

    // The light of the vector that was read last at the write port of the table.
    task present_light;
        begin
            lights_en   = 1'b1;
            lights_addr = written[{{ table.address_bits - 1 }}:0];
{%- for lane in table.lanes %}
            lights_data[{{ lane.range() }}] = file_{{ lane.port.name }};
{%- endfor %}
        end
    endtask

    // What is to come out for a sample of that light so many times.
    task add_words;
        begin
            opened = 1'b0;
            repeat (words) begin
                in_last = 1'b0;
                add_lights;
            end
        end
    endtask
{%- endif %}
