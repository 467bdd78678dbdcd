        -- The memories' words, from their files: one a line; lines that begin with a slash are
        -- comments.
        procedure read_words is
            variable index : natural;
{%- for write in bench.writes %}
            variable bits_{{ write.memory }} : std_logic_vector({{ write.digit_bits - 1 }} downto 0);
{%- endfor %}
            variable good  : boolean;
        begin
{%- for write in bench.writes %}
            file_open(status, file_of_{{ write.memory }}, {{ write.file.parameter }}, read_mode);
            if status /= open_ok then
                say("cannot open " & {{ write.file.parameter }});
                failed := true;
                conclude;
            end if;
            index := 0;
            while not endfile(file_of_{{ write.memory }}) loop
                readline(file_of_{{ write.memory }}, text_line);
                if text_line'length > 0 and text_line(text_line'left) /= '/' then
                    hread(text_line, bits_{{ write.memory }}, good);
                    if not good or index > words_{{ write.memory }}'high then
                        say({{ write.file.parameter }} & ": malformed, or too many words");
                        failed := true;
                        conclude;
                    end if;
                    words_{{ write.memory }}(index) := bits_{{ write.memory }}({{ write.data_bits - 1 }} downto 0);
                    index := index + 1;
                end if;
            end loop;
            file_close(file_of_{{ write.memory }});
            if index /= words_{{ write.memory }}'length then
                say({{ write.file.parameter }} & " has too few words");
                failed := true;
                conclude;
            end if;
{%- endfor %}
        end procedure;
