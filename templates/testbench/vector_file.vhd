        -- ----------------------------------------------------------- the vector file
        -- It is read character by character: hread would take an X for a digit and white space
        -- of any kind for a space. Past the end of the line there are NULs.
        impure function next_character return character is
        begin
            if character_at > text_line'length then
                return NUL;
            end if;
            return text_line(text_line'left + character_at - 1);
        end function;

        procedure skip_space is
        begin
            if next_character /= ' ' then
                malformed := true;
            end if;
            character_at := character_at + 1;
        end procedure;

        -- The end of the line, with or without a carriage return.
        procedure expect_line_end is
        begin
            if next_character = CR then
                character_at := character_at + 1;
            end if;
            if character_at <= text_line'length then
                malformed := true;
            end if;
        end procedure;

        -- A space and exactly `width` hexadecimal digits (lower case), a value that fits.
        procedure read_hex(width : positive; value : out std_logic_vector) is
            variable bits : std_logic_vector(4 * width - 1 downto 0) := (others => '0');
            variable code : natural;
        begin
            skip_space;
            for i in width - 1 downto 0 loop
                code := character'pos(next_character);
                case next_character is
                    when '0' to '9' => code := code - character'pos('0');
                    when 'a' to 'f' => code := code - character'pos('a') + 10;
                    when others =>
                        code      := 0;
                        malformed := true;
                end case;
                bits(4 * i + 3 downto 4 * i) := std_logic_vector(to_unsigned(code, 4));
                character_at := character_at + 1;
            end loop;
            value := bits(value'length - 1 downto 0);
            for i in value'length to bits'left loop
                if bits(i) = '1' then
                    malformed := true;
                end if;
            end loop;
        end procedure;

        -- A space and a decimal number of one to nine digits, without leading zeros.
        procedure read_decimal(value : out natural) is
            variable sum    : natural := 0;
            variable digits : natural := 0;
        begin
            skip_space;
            while next_character >= '0' and next_character <= '9' and digits < 9 loop
                sum          := 10 * sum + character'pos(next_character) - character'pos('0');
                digits       := digits + 1;
                character_at := character_at + 1;
            end loop;
            if digits = 0 or (digits > 1 and sum < 10 ** (digits - 1)) then
                malformed := true;
            end if;
            value := sum;
        end procedure;

        -- Reads on to the next vector. have_vector is false if there is none, or a line is
        -- malformed.
        procedure read_vector is
        begin
            have_vector := false;
            while not (malformed or have_vector) and not endfile(vector_file) loop
                readline(vector_file, text_line);
                line_number  := line_number + 1;
                character_at := 1;
                -- A byte order mark in front of the file is passed over.
                if line_number = 1 and next_character = character'val(16#EF#) then
                    character_at := 4;
                end if;
                case next_character is
                    when '#' | 'd' => null; -- comments and digests
                    when 'c' =>
                        character_at := character_at + 1;
                        read_decimal(count);
                        expect_line_end;
                        if have_count then
                            malformed := true;
                        end if;
                        have_count := true;
                    when 'v' =>
                        character_at := character_at + 1;
{%- for port in bench.numbers() %}
                        read_hex({{ port.digits }}, file_{{ port.name }});
{%- endfor %}
                        read_decimal(file_idle);
                        read_decimal(file_stall);
                        expect_line_end;
                        if not have_count then
                            malformed := true;
                        end if;
                        have_vector := not malformed;
                    when others => malformed := true;
                end case;
                if malformed then
                    say(GOLDEN & ":" & to_string(line_number) & ": malformed line");
                    failed := true;
                end if;
            end loop;
            if have_vector then
                vectors := vectors + 1;
            end if;
        end procedure;
