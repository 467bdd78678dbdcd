-- cubic: specular lobe x^n as x(1 - u(A - a u)), cut, n = 1 to 1000, stable form
--
-- Made by: brdfgen generate --method cubic --shininess 1..=1000
-- Spec 43bb992a623fab26. Generated; the core is yours to use under any terms.
--
--   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
--   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.16  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 12 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.875..+0.970.
--   measured -0.727..+0.864 over all 65537000 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   22.797 % absolute, 0.552 % where x^n >= 1/2, 0.702 % relative there.
-- As the cosine rises, the output never falls: proved by running all 65536000 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity cubic_tb is
    generic (
        -- The vector file.
        GOLDEN : string := "golden/cubic.vec"
    );
end entity;

architecture bench of cubic_tb is

    constant NAME    : string   := "cubic";
    constant LATENCY : positive := 12;
    constant SHOWN   : positive := 10; -- mismatches printed; the others are only counted

    subtype in_n_word is std_logic_vector(9 downto 0);
    subtype in_cos_word is std_logic_vector(17 downto 0);
    subtype out_spec_word is std_logic_vector(16 downto 0);

    signal clk       : std_logic := '0';
    signal rst       : std_logic := '0';
    signal ce        : std_logic := '0';
    signal in_valid  : std_logic := '0';
    signal in_n      : in_n_word := (others => '0');
    signal in_cos    : in_cos_word := (others => '0');
    signal out_valid : std_logic;
    signal out_spec  : unsigned(16 downto 0);

begin

    dut : entity work.cubic
        port map (
            clk       => clk,
            rst       => rst,
            ce        => ce,
            in_valid  => in_valid,
            in_n      => unsigned(in_n),
            in_cos    => signed(in_cos),
            out_valid => out_valid,
            out_spec  => out_spec
        );

    run : process is

        -- What the core has taken and not yet given back: one entry for each enabled clock of
        -- the latency, as a ring. The entry at `slot` is the one at the core's outputs now; the
        -- next enabled clock overwrites it with what the core takes then.
        type entry is record
            known     : boolean; -- false: from before the core was driven
            valid     : std_logic;
            number    : natural; -- 0: not a vector of the file
            in_n      : in_n_word;
            in_cos    : in_cos_word;
            out_spec  : out_spec_word;
        end record;
        type ring is array (0 to LATENCY - 1) of entry;

        variable due : ring := (others => (
            known     => false,
            valid     => '0',
            number    => 0,
            in_n      => (others => '0'),
            in_cos    => (others => '0'),
            out_spec  => (others => '0')
        ));
        variable slot : natural range 0 to LATENCY - 1 := 0;

        -- What is presented at the inputs now, beside the inputs themselves.
        variable number : natural := 0;
        variable expected_out_spec  : out_spec_word := (others => '0');

        variable looked     : boolean := false; -- the entry at the outputs has been looked at,
        variable reported   : boolean := false; -- and found wrong: a held fault is counted once
        variable compared   : natural := 0;
        variable mismatches : natural := 0;
        variable clocks     : natural := 0;

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
        variable file_in_n      : in_n_word;
        variable file_in_cos    : in_cos_word;
        variable file_out_spec  : out_spec_word;
        variable file_idle      : natural;
        variable file_stall     : natural;

        -- ------------------------------------------------------------- random numbers
        -- Marsaglia's xorshift32: a linear feedback register of the full period 2^32-1 that
        -- turns over 32 bits a step. The seed is fixed, and the Verilog bench draws the same
        -- numbers.
        variable lfsr : std_logic_vector(31 downto 0) := x"1badcafe";

        procedure draw is
        begin
            lfsr := lfsr xor (lfsr(18 downto 0) & (12 downto 0 => '0'));
            lfsr := lfsr xor ((16 downto 0 => '0') & lfsr(31 downto 17));
            lfsr := lfsr xor (lfsr(26 downto 0) & (4 downto 0 => '0'));
        end procedure;

        impure function one_in_eight return boolean is
        begin
            return lfsr(31 downto 29) = "000";
        end function;

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

        -- The verdict is the last line the bench prints. After a PASS it does no more, and as
        -- it makes the clock, the simulation ends. After a FAIL the simulator may add a line.
        procedure conclude is
        begin
            if not failed and compared /= count then
                say("the file announces " & to_string(count) & " vectors");
            end if;
            if failed or mismatches /= 0 or compared = 0 or compared /= count then
                say(to_string(compared) & " vectors compared, " & to_string(mismatches)
                    & " mismatches: FAIL");
                std.env.stop(1);
            else
                say(to_string(compared) & " vectors compared, " & to_string(mismatches)
                    & " mismatches: PASS");
            end if;
            wait;
        end procedure;

        -- ---------------------------------------------------------------- comparison
        impure function shown_outputs return string is
        begin
            if out_valid /= '1' then
                return "out_valid " & to_string(out_valid);
            end if;
            return hex(std_logic_vector(out_spec));
        end function;

        procedure show_mismatch is
            variable want : entry := due(slot);
        begin
            if want.number = 0 then
                say("clock " & to_string(clocks) & ": expected out_valid "
                    & to_string(want.valid) & ", got " & to_string(out_valid));
            else
                say("vector " & to_string(want.number)
                    & ": in_n " & hex(want.in_n)
                    & ", in_cos " & hex(want.in_cos)
                    & ": expected"
                    & " " & hex(want.out_spec)
                    & ", got " & shown_outputs);
            end if;
        end procedure;

        -- The words are compared as std_logic_vector, where U, X and Z differ from 0 and 1 as
        -- any two values do; the "=" of numeric_std would only warn.
        procedure check_outputs is
            variable wrong : boolean;
        begin
            wrong := out_valid /= due(slot).valid;
            if due(slot).number /= 0 then
                if not looked then
                    compared := compared + 1;
                end if;
                if std_logic_vector(out_spec) /= due(slot).out_spec then
                    wrong := true;
                end if;
            end if;
            looked := true;
            if due(slot).known and wrong and not reported then
                reported   := true;
                mismatches := mismatches + 1;
                if mismatches <= SHOWN then
                    show_mismatch;
                end if;
            end if;
        end procedure;

        -- -------------------------------------------------------------------- clocks
        -- One clock. The inputs change while clk is low. The outputs are looked at just before
        -- the rising edge, when the inputs already have their new values: they must still be
        -- those of the last edge, whatever ce and the other inputs are.
        procedure clock is
        begin
            wait for 5 ns;
            check_outputs;
            clk    <= '1';
            clocks := clocks + 1;
            if ce = '1' then
                due(slot).known := true;
                due(slot).valid := in_valid;
                due(slot).number := number;
                due(slot).in_n := in_n;
                due(slot).in_cos := in_cos;
                due(slot).out_spec := expected_out_spec;
                slot := (slot + 1) mod LATENCY;
            end if;
            if rst = '1' then
                for i in due'range loop
                    due(i).known  := true;
                    due(i).valid  := '0';
                    due(i).number := 0;
                end loop;
            end if;
            if ce = '1' or rst = '1' then
                looked   := false;
                reported := false;
            end if;
            wait for 5 ns;
            clk <= '0';
            -- Only a vector file that asks for absurdly many empty clocks gets here.
            if clocks / 40 > vectors + 250 then
                say("watchdog: " & to_string(clocks) & " clocks for " & to_string(vectors)
                    & " vectors");
                failed := true;
                conclude;
            end if;
        end procedure;

        -- Whatever the core must not look at is random.
        procedure present_garbage(valid : std_logic) is
        begin
            draw;
            in_n <= lfsr(9 downto 0);
            draw;
            in_cos <= lfsr(17 downto 0);
            in_valid <= valid;
            number := 0;
        end procedure;

        -- A clock with ce low: garbage at all inputs, in_valid too.
        procedure stalled_clock is
        begin
            draw;
            present_garbage(lfsr(31));
            ce <= '0';
            clock;
            ce <= '1';
        end procedure;

        -- One time in eight a stalled clock, then perhaps another.
        procedure random_stalls is
        begin
            draw;
            while one_in_eight loop
                stalled_clock;
                draw;
            end loop;
        end procedure;

        -- An enabled clock that takes no vector.
        procedure idle_clock is
        begin
            random_stalls;
            present_garbage('0');
            clock;
        end procedure;

        -- The vector that was read last, with the clocks the file asks for before it and random
        -- ones.
        procedure feed_vector is
        begin
            for i in 1 to file_idle loop
                idle_clock;
            end loop;
            draw;
            while one_in_eight loop
                idle_clock;
                draw;
            end loop;
            for i in 1 to file_stall loop
                stalled_clock;
            end loop;
            random_stalls;
            in_valid <= '1';
            in_n <= file_in_n;
            in_cos <= file_in_cos;
            expected_out_spec := file_out_spec;
            number := vectors;
            clock;
        end procedure;

        -- A full pipeline is reset by one clock: nothing that was taken before may come out.
        procedure reset_phase(enable : std_logic) is
        begin
            ce <= '1';
            for i in 1 to LATENCY + 2 loop
                present_garbage('1');
                clock;
            end loop;
            present_garbage('1'); -- what is presented together with rst is not taken
            rst <= '1';
            ce  <= enable;
            clock;
            rst <= '0';
            ce  <= '1';
            for i in 1 to LATENCY loop
                present_garbage('0');
                clock;
            end loop;
        end procedure;

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
                        read_hex(3, file_in_n);
                        read_hex(5, file_in_cos);
                        read_hex(5, file_out_spec);
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

    begin
        file_open(status, vector_file, GOLDEN, read_mode);
        if status /= open_ok then
            say("cannot open " & GOLDEN);
            failed := true;
            conclude;
        end if;
        reset_phase('1');
        reset_phase('0');
        read_vector;
        while have_vector loop
            feed_vector;
            read_vector;
        end loop;
        file_close(vector_file);
        -- The last vector, and the end of valid behind it.
        for i in 1 to LATENCY + 2 loop
            idle_clock;
        end loop;
        conclude;
    end process;

end architecture;
