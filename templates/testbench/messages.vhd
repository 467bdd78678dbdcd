        -- ----------------------------------------------------------------- messages
        -- Lower case as in Verilog, and an x for a digit with a bit that is neither 0 nor 1.
        function hex(value : std_logic_vector) return string is
            constant DIGITS : string(1 to 16) := "0123456789abcdef";
            constant WIDTH  : positive := (value'length + 3) / 4;
            variable bits   : std_logic_vector(4 * WIDTH - 1 downto 0) := (others => '0');
            variable digit  : natural;
            variable result : string(1 to WIDTH);
        begin
            bits(value'length - 1 downto 0) := value;
            for i in result'range loop
                digit     := 0;
                result(i) := '0';
                for b in 4 * (WIDTH - i) + 3 downto 4 * (WIDTH - i) loop
                    digit := 2 * digit;
                    if bits(b) = '1' then
                        digit := digit + 1;
                    elsif bits(b) /= '0' then
                        result(i) := 'x';
                    end if;
                end loop;
                if result(i) /= 'x' then
                    result(i) := DIGITS(digit + 1);
                end if;
            end loop;
            return result;
        end function;

        -- `report` would put a time and a place before the text.
        procedure say(text : string) is
            variable message : line;
        begin
            write(message, "brdfgen: " & NAME & ": " & text);
            writeline(output, message);
        end procedure;
