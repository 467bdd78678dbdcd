    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_{{ reader.name }}(path : string) return {{ reader.kind }} is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector({{ reader.bits.next_multiple_of(4) - 1 }} downto 0);
        variable result : {{ reader.kind }};
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < {{ reader.depth }} report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word({{ reader.bits - 1 }} downto 0);
{%- if let Some(second) = reader.second %}
                result(index + {{ second }}) := word({{ reader.bits - 1 }} downto 0);
{%- endif %}
                index := index + 1;
            end if;
        end loop;
        assert index = {{ reader.depth }} report path & " has too few words" severity failure;
        return result;
    end function;
