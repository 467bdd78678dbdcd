-- cubic_min_zero: specular lobe x^n as x max(0, 1 - K u)^2, n = 1 to 127, minimax
--
-- Made by: brdfgen generate core.toml
-- Spec 2f2c78809c9dfeea. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   wr_addr   UQ7.0   address of the word that is written
--   wr_data   UQ16.0  word for the coefficient memory; layout as in its files
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 10 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.625..+0.750.
--   measured -0.616..+0.746 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   6.806 % absolute, 6.806 % where x^n >= 1/2, 13.124 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity cubic_min_zero_tb is
    generic (
        -- The words that are written to the memory rom, relative to the current directory.
        ROM_FILE : string := "rom/cubic_min_zero.mem";
        -- The vector file.
        GOLDEN : string := "golden/cubic_min_zero.vec"
    );
end entity;

architecture bench of cubic_min_zero_tb is

    constant NAME    : string   := "cubic_min_zero";
    constant LATENCY : positive := 10;
    constant SHOWN   : positive := 10; -- mismatches printed; the others are only counted

    subtype in_n_word is std_logic_vector(6 downto 0);
    subtype in_cos_word is std_logic_vector(13 downto 0);
    subtype out_spec_word is std_logic_vector(12 downto 0);

    signal clk       : std_logic := '0';
    signal rst       : std_logic := '0';
    signal ce        : std_logic := '0';
    signal in_valid  : std_logic := '0';
    signal in_n      : in_n_word := (others => '0');
    signal in_cos    : in_cos_word := (others => '0');
    signal wr_en : std_logic := '0';
    signal wr_addr : std_logic_vector(6 downto 0) := (others => '0');
    signal wr_data : std_logic_vector(15 downto 0) := (others => '0');
    signal out_valid : std_logic;
    signal out_spec  : unsigned(12 downto 0);

begin

    dut : entity work.cubic_min_zero
        port map (
            clk       => clk,
            rst       => rst,
            ce        => ce,
            in_valid  => in_valid,
            in_n      => unsigned(in_n),
            in_cos    => signed(in_cos),
            wr_en => wr_en,
            wr_addr => unsigned(wr_addr),
            wr_data => unsigned(wr_data),
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
            number    : integer; -- 0: not a vector of the file
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
        variable number : integer := 0;
        variable expected_out_spec  : out_spec_word := (others => '0');

        variable looked     : boolean := false; -- the entry at the outputs has been looked at,
        variable reported   : boolean := false; -- and found wrong: a held fault is counted once
        variable compared   : natural := 0;
        variable mismatches : natural := 0;
        variable clocks     : natural := 0;

        -- ------------------------------------------------------------------ loading
        constant COMPLEMENTS          : natural := 64; -- vectors for the words' complements
        variable complements_fed      : natural := 0;
        variable complements_compared : natural := 0;
        variable granted              : integer := 0; -- clocks that the watchdog does not count
        subtype rom_word is std_logic_vector(15 downto 0);
        type rom_words is array (0 to 127) of rom_word;
        variable words_rom : rom_words;
        file file_of_rom : text;

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
            if not failed and (COMPLEMENTS = 0 or complements_compared /= COMPLEMENTS) then
                say(to_string(complements_compared) & " of " & to_string(COMPLEMENTS)
                    & " vectors compared with complemented words");
                failed := true;
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
                if want.number < 0 then
                    say("with complemented words:");
                end if;
                say("vector " & to_string(abs want.number)
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
                if not looked and due(slot).number > 0 then
                    compared := compared + 1;
                end if;
                if not looked and due(slot).number < 0 then
                    complements_compared := complements_compared + 1;
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
            if (clocks - granted) / 40 > vectors + 250 then
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
            in_n <= lfsr(6 downto 0);
            draw;
            in_cos <= lfsr(13 downto 0);
            wr_en <= '0';
            draw;
            wr_addr <= lfsr(6 downto 0);
            draw;
            wr_data(15 downto 0) <= lfsr(15 downto 0);
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
                        read_hex(2, file_in_n);
                        read_hex(4, file_in_cos);
                        read_hex(4, file_out_spec);
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

        -- The memories' words, from their files: one a line; lines that begin with a slash are
        -- comments.
        procedure read_words is
            variable index : natural;
            variable bits_rom : std_logic_vector(15 downto 0);
            variable good  : boolean;
        begin
            file_open(status, file_of_rom, ROM_FILE, read_mode);
            if status /= open_ok then
                say("cannot open " & ROM_FILE);
                failed := true;
                conclude;
            end if;
            index := 0;
            while not endfile(file_of_rom) loop
                readline(file_of_rom, text_line);
                if text_line'length > 0 and text_line(text_line'left) /= '/' then
                    hread(text_line, bits_rom, good);
                    if not good or index > words_rom'high then
                        say(ROM_FILE & ": malformed, or too many words");
                        failed := true;
                        conclude;
                    end if;
                    words_rom(index) := bits_rom(15 downto 0);
                    index := index + 1;
                end if;
            end loop;
            file_close(file_of_rom);
            if index /= words_rom'length then
                say(ROM_FILE & " has too few words");
                failed := true;
                conclude;
            end if;
        end procedure;

        -- Writes every word of the memories, or its complement. Neither ce nor rst must matter.
        procedure load(complement : boolean) is
        begin
            for address in words_rom'range loop
                present_garbage('0');
                draw;
                ce  <= lfsr(31);
                rst <= lfsr(30);
                wr_en <= '1';
                wr_addr <= std_logic_vector(to_unsigned(address, 7));
                wr_data <= words_rom(address);
                if complement then
                    wr_data <= not words_rom(address);
                end if;
                granted := granted + 1;
                clock;
            end loop;
            present_garbage('0');
            ce  <= '1';
            rst <= '0';
        end procedure;

        -- A vector for the words' complements.
        procedure feed_complement(
            of_in_n : in_n_word;
            of_in_cos : in_cos_word;
            of_out_spec : out_spec_word
        ) is
        begin
            idle_clock;
            random_stalls;
            in_valid <= '1';
            in_n <= of_in_n;
            in_cos <= of_in_cos;
            expected_out_spec := of_out_spec;
            complements_fed := complements_fed + 1;
            number := -complements_fed;
            clock;
        end procedure;

        procedure feed_complements is
        begin
            feed_complement(7x"00", 14x"0800", 13x"0000");
            feed_complement(7x"02", 14x"0800", 13x"0000");
            feed_complement(7x"04", 14x"0801", 13x"0000");
            feed_complement(7x"06", 14x"0f97", 13x"05cb");
            feed_complement(7x"08", 14x"0c00", 13x"0000");
            feed_complement(7x"0a", 14x"0d44", 13x"0000");
            feed_complement(7x"0c", 14x"0dae", 13x"0000");
            feed_complement(7x"0e", 14x"0ce3", 13x"0000");
            feed_complement(7x"10", 14x"0efe", 13x"0776");
            feed_complement(7x"12", 14x"0f60", 13x"0bb6");
            feed_complement(7x"14", 14x"0e68", 13x"09a3");
            feed_complement(7x"16", 14x"0ea0", 13x"0da0");
            feed_complement(7x"18", 14x"0fdf", 13x"0eee");
            feed_complement(7x"1a", 14x"0fe7", 13x"0f40");
            feed_complement(7x"1c", 14x"0eb2", 13x"0853");
            feed_complement(7x"1e", 14x"0f36", 13x"0b76");
            feed_complement(7x"20", 14x"0efe", 13x"0aee");
            feed_complement(7x"22", 14x"0ed1", 13x"0ad3");
            feed_complement(7x"24", 14x"0fc7", 13x"0f14");
            feed_complement(7x"26", 14x"0f5c", 13x"0ddc");
            feed_complement(7x"28", 14x"0fb1", 13x"0f27");
            feed_complement(7x"2a", 14x"0fa4", 13x"0f43");
            feed_complement(7x"2c", 14x"0fb1", 13x"0f94");
            feed_complement(7x"2e", 14x"0fe5", 13x"0f7d");
            feed_complement(7x"30", 14x"0fd0", 13x"0f21");
            feed_complement(7x"32", 14x"0a15", 13x"012e");
            feed_complement(7x"34", 14x"0f5b", 13x"0d56");
            feed_complement(7x"36", 14x"0fc1", 13x"0efd");
            feed_complement(7x"38", 14x"0f3c", 13x"0d1c");
            feed_complement(7x"3a", 14x"0ff7", 13x"0fde");
            feed_complement(7x"3c", 14x"0d33", 13x"07c1");
            feed_complement(7x"3e", 14x"0ffc", 13x"0ff2");
            feed_complement(7x"40", 14x"0f4b", 13x"0dc5");
            feed_complement(7x"42", 14x"0f9a", 13x"0ec8");
            feed_complement(7x"44", 14x"0fcf", 13x"0f71");
            feed_complement(7x"46", 14x"0f9e", 13x"0ef6");
            feed_complement(7x"48", 14x"0f7a", 13x"0ead");
            feed_complement(7x"4a", 14x"0ff0", 13x"0fd9");
            feed_complement(7x"4c", 14x"0fd6", 13x"0fa2");
            feed_complement(7x"4e", 14x"0fe6", 13x"0fca");
            feed_complement(7x"50", 14x"0fae", 13x"0f67");
            feed_complement(7x"52", 14x"0fc8", 13x"0fa1");
            feed_complement(7x"54", 14x"0f96", 13x"0f5f");
            feed_complement(7x"56", 14x"0ff7", 13x"0ff4");
            feed_complement(7x"58", 14x"0fe7", 13x"0fe3");
            feed_complement(7x"5a", 14x"0fca", 13x"0fca");
            feed_complement(7x"5c", 14x"0ffb", 13x"0ff1");
            feed_complement(7x"5e", 14x"0ffe", 13x"0ffa");
            feed_complement(7x"60", 14x"0fd4", 13x"0f83");
            feed_complement(7x"62", 14x"0ffb", 13x"0ff2");
            feed_complement(7x"64", 14x"0f9f", 13x"0ef9");
            feed_complement(7x"66", 14x"0fea", 13x"0fc4");
            feed_complement(7x"68", 14x"0ff7", 13x"0fe8");
            feed_complement(7x"6a", 14x"0f9e", 13x"0f02");
            feed_complement(7x"6c", 14x"0fe4", 13x"0fb8");
            feed_complement(7x"6e", 14x"0fdb", 13x"0fa2");
            feed_complement(7x"70", 14x"0f95", 13x"0ef9");
            feed_complement(7x"72", 14x"0faa", 13x"0f30");
            feed_complement(7x"74", 14x"0ffd", 13x"0ff9");
            feed_complement(7x"76", 14x"02a4", 13x"007a");
            feed_complement(7x"78", 14x"0fce", 13x"0f8d");
            feed_complement(7x"7a", 14x"0ffe", 13x"0ffc");
            feed_complement(7x"7c", 14x"0fb6", 13x"0f5c");
            feed_complement(7x"7e", 14x"0fa3", 13x"0f37");
        end procedure;

        procedure empty_pipeline is
        begin
            for i in 1 to LATENCY + 2 loop
                idle_clock;
            end loop;
        end procedure;

        -- All vectors of the file; behind them the pipeline is empty.
        procedure run_vectors is
        begin
            granted     := clocks;
            line_number := 0;
            have_count  := false;
            count       := 0;
            vectors     := 0;
            compared    := 0;
            file_open(status, vector_file, GOLDEN, read_mode);
            if status /= open_ok then
                say("cannot open " & GOLDEN);
                failed := true;
                conclude;
            end if;
            read_vector;
            while have_vector loop
                feed_vector;
                read_vector;
            end loop;
            file_close(vector_file);
            empty_pipeline;
        end procedure;

    -- The core as it comes up, with complements in its memories, and with the right words again.
    begin
        reset_phase('1');
        reset_phase('0');
        run_vectors;
        if failed or compared /= count then
            conclude;
        end if;
        read_words;
        load(true);
        feed_complements;
        empty_pipeline;
        load(false);
        run_vectors;
        conclude;
    end process;

end architecture;
