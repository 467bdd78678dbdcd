-- shader_axis: AXI4-Stream interfaces for the core shader
--
-- Made by: brdfgen generate core.toml
-- Spec ef73cb5e346c03ce. Generated; the wrapper is yours to use under any terms.
--
-- s_axis_tdata, 28 bytes:
--   [1:0]     in_material   UQ2.0 index of the material, 0 to 3; above: the last
--   [19:2]    in_nx         Q1.16 x of the normal N, of unit length
--   [37:20]   in_ny         Q1.16 y of the normal N, of unit length
--   [55:38]   in_nz         Q1.16 z of the normal N, of unit length
--   [73:56]   in_vx         Q1.16 x of the unit vector V to the viewer
--   [91:74]   in_vy         Q1.16 y of the unit vector V to the viewer
--   [109:92]  in_vz         Q1.16 z of the unit vector V to the viewer
--   [127:110] in_l1x        Q1.16 x of the unit vector L to light 1
--   [145:128] in_l1y        Q1.16 y of the unit vector L to light 1
--   [163:146] in_l1z        Q1.16 z of the unit vector L to light 1
--   [181:164] in_l2x        Q1.16 x of the unit vector L to light 2
--   [199:182] in_l2y        Q1.16 y of the unit vector L to light 2
--   [217:200] in_l2z        Q1.16 z of the unit vector L to light 2
--   [223:218] of no meaning
--
-- m_axis_tdata, 3 bytes:
--   [7:0]   out_r UQ8.0 red; 255 is full scale
--   [15:8]  out_g UQ8.0 green; 255 is full scale
--   [23:16] out_b UQ8.0 blue; 255 is full scale
--
-- tlast and tuser stay with their beat. tkeep and tstrb are not needed: a beat is always whole.
-- Latency 16 clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and
-- m_axis_tready leads to registers only.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity shader_axis_tb is
    generic (
        -- The vector file.
        GOLDEN : string := "golden/shader.vec"
    );
end entity;

architecture bench of shader_axis_tb is

    constant NAME    : string   := "shader_axis";
    constant LATENCY : positive := 16;
    constant SHOWN   : positive := 10; -- faults printed; the others are only counted

    subtype in_material_word is std_logic_vector(1 downto 0);
    subtype in_nx_word is std_logic_vector(17 downto 0);
    subtype in_ny_word is std_logic_vector(17 downto 0);
    subtype in_nz_word is std_logic_vector(17 downto 0);
    subtype in_vx_word is std_logic_vector(17 downto 0);
    subtype in_vy_word is std_logic_vector(17 downto 0);
    subtype in_vz_word is std_logic_vector(17 downto 0);
    subtype in_l1x_word is std_logic_vector(17 downto 0);
    subtype in_l1y_word is std_logic_vector(17 downto 0);
    subtype in_l1z_word is std_logic_vector(17 downto 0);
    subtype in_l2x_word is std_logic_vector(17 downto 0);
    subtype in_l2y_word is std_logic_vector(17 downto 0);
    subtype in_l2z_word is std_logic_vector(17 downto 0);
    subtype out_r_word is std_logic_vector(7 downto 0);
    subtype out_g_word is std_logic_vector(7 downto 0);
    subtype out_b_word is std_logic_vector(7 downto 0);

    subtype input_word is std_logic_vector(223 downto 0);
    subtype output_word is std_logic_vector(23 downto 0);
    subtype user_word is std_logic_vector(7 downto 0);
    -- tuser, tlast and tdata of a result.
    subtype beat_word is std_logic_vector(32 downto 0);

    signal aclk          : std_logic := '0';
    signal aresetn       : std_logic := '1';
    signal s_axis_tdata  : input_word := (others => '0');
    signal s_axis_tvalid : std_logic := '0';
    signal s_axis_tready : std_logic;
    signal s_axis_tlast  : std_logic := '0';
    signal s_axis_tuser  : user_word := (others => '0');
    signal m_axis_tdata  : output_word;
    signal m_axis_tvalid : std_logic;
    signal m_axis_tready : std_logic := '0';
    signal m_axis_tlast  : std_logic;
    signal m_axis_tuser  : user_word;
    signal beat          : beat_word;

begin

    dut : entity work.shader_axis
        port map (
            aclk          => aclk,
            aresetn       => aresetn,
            s_axis_tdata  => s_axis_tdata,
            s_axis_tvalid => s_axis_tvalid,
            s_axis_tready => s_axis_tready,
            s_axis_tlast  => s_axis_tlast,
            s_axis_tuser  => s_axis_tuser,
            m_axis_tdata  => m_axis_tdata,
            m_axis_tvalid => m_axis_tvalid,
            m_axis_tready => m_axis_tready,
            m_axis_tlast  => m_axis_tlast,
            m_axis_tuser  => m_axis_tuser
        );

    beat <= m_axis_tuser & m_axis_tlast & m_axis_tdata;

    run : process is

        -- The beats under way, as a ring: what is due at the sink. The wrapper holds at most one
        -- more than its core.
        constant PLACES : positive := LATENCY + 2;
        type entry is record
            beat   : beat_word;
            number : integer; -- 0: not a vector of the file
        end record;
        type ring is array (0 to PLACES - 1) of entry;
        variable due       : ring;
        variable oldest    : natural := 0;
        variable under_way : natural := 0;
        variable place     : natural;

        -- What is offered now, beside the source's signals themselves, and what the sink will say.
        variable expected   : output_word := (others => '0');
        variable number     : integer := 0;
        variable sink_ready : boolean := false;

        -- How often, of eight clocks, the source offers a beat and the sink takes one.
        variable source_rate : natural := 8;
        variable sink_rate   : natural := 8;

        variable known        : boolean := false; -- the wrapper has been reset
        variable held         : boolean := false; -- a beat was not taken at the last clock,
        variable held_beat    : beat_word;        -- and must still be there
        variable was_ready    : boolean := false; -- the sink was ready at the last clock
        variable early_tready : std_logic;
        variable early_tvalid : std_logic;
        variable accepted     : boolean := false;
        variable taken        : boolean := false;
        variable compared     : natural := 0;
        variable mismatches   : natural := 0;
        variable clocks       : natural := 0;
        variable quiet        : natural := 0; -- clocks since a beat was accepted or taken
        variable first_in     : natural := 0; -- the clock at which the first vector was accepted,
        variable last_out     : natural := 0; -- and that at which the last was taken

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
        variable file_in_material : in_material_word;
        variable file_in_nx       : in_nx_word;
        variable file_in_ny       : in_ny_word;
        variable file_in_nz       : in_nz_word;
        variable file_in_vx       : in_vx_word;
        variable file_in_vy       : in_vy_word;
        variable file_in_vz       : in_vz_word;
        variable file_in_l1x      : in_l1x_word;
        variable file_in_l1y      : in_l1y_word;
        variable file_in_l1z      : in_l1z_word;
        variable file_in_l2x      : in_l2x_word;
        variable file_in_l2y      : in_l2y_word;
        variable file_in_l2z      : in_l2z_word;
        variable file_out_r       : out_r_word;
        variable file_out_g       : out_g_word;
        variable file_out_b       : out_b_word;
        variable file_idle        : natural;
        variable file_stall       : natural;

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
        -- A fault at this clock.
        procedure fault(what : string) is
        begin
            mismatches := mismatches + 1;
            if mismatches <= SHOWN then
                say("clock " & to_string(clocks) & ": " & what);
            end if;
        end procedure;

        procedure show_mismatch is
            variable want : beat_word := due(oldest).beat;
        begin
            mismatches := mismatches + 1;
            if mismatches <= SHOWN then
                say("vector " & to_string(due(oldest).number) & ": expected tuser, tlast, tdata "
                    & hex(want(want'high downto 25))
                    & " " & to_string(want(24))
                    & " " & hex(want(23 downto 0))
                    & ", got " & hex(m_axis_tuser) & " " & to_string(m_axis_tlast)
                    & " " & hex(m_axis_tdata));
            end if;
        end procedure;

        -- The words are compared as std_logic_vector, where U, X and Z differ from 0 and 1 as
        -- any two values do.
        procedure check is
        begin
            if s_axis_tready /= early_tready or m_axis_tvalid /= early_tvalid then
                fault("an output follows m_axis_tready within the clock");
            end if;
            if is_x(s_axis_tready) or is_x(m_axis_tvalid) then
                fault("s_axis_tready or m_axis_tvalid is unknown");
            end if;
            if held and m_axis_tvalid /= '1' then
                fault("a beat went before it was taken");
            elsif held and beat /= held_beat then
                fault("a beat changed before it was taken");
            end if;
            -- Full throughput: the source never waits for more than the sink, and a full
            -- pipeline has a beat to give at every clock.
            if was_ready and s_axis_tready /= '1' then
                fault("s_axis_tready is low, and the sink was ready");
            end if;
            if under_way >= LATENCY and m_axis_tvalid /= '1' then
                fault("a full pipeline gives no beat");
            end if;
            if m_axis_tvalid = '1' then
                if under_way = 0 then
                    fault("a beat that nobody sent");
                elsif not held and beat /= due(oldest).beat then
                    show_mismatch;
                end if;
            end if;
        end procedure;

        -- -------------------------------------------------------------------- clocks
        procedure take is
        begin
            if due(oldest).number > 0 then
                compared := compared + 1;
                last_out := clocks;
            end if;
            oldest    := (oldest + 1) mod PLACES;
            under_way := under_way - 1;
            quiet     := 0;
        end procedure;

        procedure accept_beat is
        begin
            if under_way = PLACES and known then
                fault("more beats are accepted than the wrapper can hold");
            end if;
            if under_way < PLACES then
                place             := (oldest + under_way) mod PLACES;
                due(place).beat   := s_axis_tuser & s_axis_tlast & expected;
                due(place).number := number;
                under_way         := under_way + 1;
            end if;
            if number = 1 then
                first_in := clocks;
            end if;
            quiet := 0;
        end procedure;

        -- One clock. The inputs change while aclk is low. The sink first says the opposite of
        -- what it will say at the rising edge.
        procedure clock is
        begin
            draw;
            sink_ready := to_integer(unsigned(lfsr(31 downto 29))) < sink_rate;
            m_axis_tready <= '0' when sink_ready else '1';
            wait for 2 ns;
            early_tready := s_axis_tready;
            early_tvalid := m_axis_tvalid;
            m_axis_tready <= '1' when sink_ready else '0';
            wait for 3 ns;
            if known then
                check;
            end if;
            taken     := aresetn = '1' and m_axis_tvalid = '1' and sink_ready;
            accepted  := aresetn = '1' and s_axis_tvalid = '1' and s_axis_tready = '1';
            held      := aresetn = '1' and m_axis_tvalid = '1' and not sink_ready;
            held_beat := beat;
            was_ready := aresetn = '1' and known and sink_ready;
            aclk   <= '1';
            clocks := clocks + 1;
            quiet  := quiet + 1;
            if taken and under_way /= 0 then
                take;
            end if;
            if accepted then
                accept_beat;
            end if;
            if aresetn = '0' then
                known     := true;
                under_way := 0;
            end if;
            wait for 5 ns;
            aclk <= '0';
            if quiet > 2000 then
                say("clock " & to_string(clocks) & ": nothing moves any more");
                failed := true;
                conclude;
            end if;
        end procedure;

        -- Whatever the wrapper must not look at is random.
        procedure present_garbage(valid : std_logic) is
        begin
            draw;
            s_axis_tdata(31 downto 0) <= lfsr(31 downto 0);
            s_axis_tdata(63 downto 32) <= lfsr(31 downto 0);
            s_axis_tdata(95 downto 64) <= lfsr(31 downto 0);
            s_axis_tdata(127 downto 96) <= lfsr(31 downto 0);
            s_axis_tdata(159 downto 128) <= lfsr(31 downto 0);
            s_axis_tdata(191 downto 160) <= lfsr(31 downto 0);
            s_axis_tdata(223 downto 192) <= lfsr(31 downto 0);
            draw;
            s_axis_tlast <= lfsr(31);
            s_axis_tuser(7 downto 0) <= lfsr(7 downto 0);
            s_axis_tvalid <= valid;
            number := 0;
        end procedure;

        procedure idle_clock is
        begin
            present_garbage('0');
            clock;
        end procedure;



        -- Offers the vector that was read last until it is accepted; before it, as many idle
        -- clocks as the source's rate gives. What no port takes of tdata is random, and so are
        -- tlast and tuser.
        procedure send(of_number : integer) is
        begin
            draw;
            while to_integer(unsigned(lfsr(31 downto 29))) >= source_rate loop
                idle_clock;
                draw;
            end loop;
            present_garbage('1');
            s_axis_tdata(1 downto 0) <= file_in_material;
            s_axis_tdata(19 downto 2) <= file_in_nx;
            s_axis_tdata(37 downto 20) <= file_in_ny;
            s_axis_tdata(55 downto 38) <= file_in_nz;
            s_axis_tdata(73 downto 56) <= file_in_vx;
            s_axis_tdata(91 downto 74) <= file_in_vy;
            s_axis_tdata(109 downto 92) <= file_in_vz;
            s_axis_tdata(127 downto 110) <= file_in_l1x;
            s_axis_tdata(145 downto 128) <= file_in_l1y;
            s_axis_tdata(163 downto 146) <= file_in_l1z;
            s_axis_tdata(181 downto 164) <= file_in_l2x;
            s_axis_tdata(199 downto 182) <= file_in_l2y;
            s_axis_tdata(217 downto 200) <= file_in_l2z;
            expected := (others => '0');
            expected(7 downto 0) := file_out_r;
            expected(15 downto 8) := file_out_g;
            expected(23 downto 16) := file_out_b;
            number := of_number;
            loop
                clock;
                exit when accepted;
            end loop;
            s_axis_tvalid <= '0';
        end procedure;

        -- Nothing is under way any more, and nothing more comes.
        procedure drain is
        begin
            while under_way /= 0 loop
                idle_clock;
            end loop;
            for i in 1 to LATENCY + 2 loop
                idle_clock;
            end loop;
        end procedure;

        -- A full wrapper is reset by one clock: nothing that was accepted before may come out.
        -- The sink stands still or takes beats. The results of the garbage before the reset are
        -- not known, and not checked.
        procedure reset_phase(rate : natural) is
        begin
            sink_rate := rate;
            for i in 1 to LATENCY + 4 loop
                present_garbage('1');
                known := false;
                clock;
            end loop;
            present_garbage('1'); -- what is presented together with reset is not accepted
            aresetn <= '0';
            clock;
            aresetn <= '1';
            sink_rate := 8;
            for i in 1 to LATENCY + 2 loop
                idle_clock;
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
                        read_hex(1, file_in_material);
                        read_hex(5, file_in_nx);
                        read_hex(5, file_in_ny);
                        read_hex(5, file_in_nz);
                        read_hex(5, file_in_vx);
                        read_hex(5, file_in_vy);
                        read_hex(5, file_in_vz);
                        read_hex(5, file_in_l1x);
                        read_hex(5, file_in_l1y);
                        read_hex(5, file_in_l1z);
                        read_hex(5, file_in_l2x);
                        read_hex(5, file_in_l2y);
                        read_hex(5, file_in_l2z);
                        read_hex(2, file_out_r);
                        read_hex(2, file_out_g);
                        read_hex(2, file_out_b);
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

        -- How often the source and the sink of the vectors of a block of 32 are ready.
        procedure choose_rates is
        begin
            case (vectors / 32) mod 6 is
                when 0      => source_rate := 8; sink_rate := 4;
                when 1      => source_rate := 4; sink_rate := 8;
                when 2      => source_rate := 4; sink_rate := 4;
                when 3      => source_rate := 8; sink_rate := 1;
                when 4      => source_rate := 2; sink_rate := 7;
                when others => source_rate := 7; sink_rate := 7;
            end case;
        end procedure;

        -- All vectors of the file, with stalls of both sides or without; behind them the
        -- pipeline is empty.
        procedure run_vectors(stalls : boolean) is
        begin
            source_rate := 8;
            sink_rate   := 8;
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
                if stalls then
                    choose_rates;
                end if;
                send(vectors);
                read_vector;
            end loop;
            file_close(vector_file);
            drain;
            if not failed and compared /= count then
                say("the file announces " & to_string(count) & " vectors");
                failed := true;
            end if;
            if not failed and not stalls and last_out - first_in /= count - 1 + LATENCY then
                say(to_string(count) & " vectors took " & to_string(last_out - first_in)
                    & " clocks without a stall, not " & to_string(count - 1 + LATENCY));
                failed := true;
            end if;
            if failed then
                conclude;
            end if;
        end procedure;

    begin
        reset_phase(8);
        reset_phase(0);
        reset_phase(4);
        run_vectors(false);
        run_vectors(true);
        conclude;
    end process;

end architecture;
