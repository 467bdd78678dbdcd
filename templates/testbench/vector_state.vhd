        -- The vector file. `character_at` is the first character of the line not yet used.
        file vector_file         : text;
        variable status          : file_open_status;
        variable text_line       : line;
        variable character_at    : positive := 1;
        variable malformed       : boolean  := false;
        variable have_count      : boolean  := false;
        variable have_vector     : boolean  := false;
        variable failed          : boolean  := false;
        variable line_number     : natural  := 0;
        variable count           : natural  := 0; -- vectors the file announces,
        variable vectors         : natural  := 0; -- and those read so far
        -- Fields of the vector that was read last.
{%- for port in bench.numbers() %}
        variable file_{{ bench.padded(port.name) }} : {{ port.name }}_word;
{%- endfor %}
        variable file_{{ bench.padded("idle") }} : natural;
        variable file_{{ bench.padded("stall") }} : natural;
