{% for line in axis.header -%}
--{% if !line.is_empty() %} {{ line }}{% endif %}
{% endfor %}
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity {{ axis.name }}_tb is
    generic (
{%- for file in bench.rom_files %}
        -- The core reads its memory {{ file.memory }} from this file{% if !bench.writes.is_empty() %}, and its words are written to it{% endif %}, relative to the current directory.
        {{ file.parameter }} : string := "{{ file.path }}";
{%- endfor %}
{%- for write in bench.written_files() %}
        -- The words that are written to the memory {{ write.memory }}, relative to the current directory.
        {{ write.file.parameter }} : string := "{{ write.file.path }}";
{%- endfor %}
{%- for file in bench.memory_files() %}
        -- The words of the memory {{ file.memory }} outside of the core, relative to the current directory.
        {{ file.parameter }} : string := "{{ file.path }}";
{%- endfor %}
        -- The vector file.
        GOLDEN : string := "{{ bench.golden }}"
    );
end entity;

architecture bench of {{ axis.name }}_tb is

    constant NAME    : string   := "{{ axis.name }}";
    constant LATENCY : positive := {{ axis.latency }};
    constant SHOWN   : positive := 10; -- faults printed; the others are only counted
{% for port in bench.words() %}
    subtype {{ port.name }}_word is std_logic_vector({{ port.bits - 1 }} downto 0);
{%- endfor %}

    subtype input_word is std_logic_vector({{ axis.inputs.tdata_bits() - 1 }} downto 0);
    subtype output_word is std_logic_vector({{ axis.outputs.tdata_bits() - 1 }} downto 0);
    subtype user_word is std_logic_vector({{ axis.tuser_bits - 1 }} downto 0);
    -- tuser, tlast and tdata of a result.
    subtype beat_word is std_logic_vector({{ axis.wide_beat_bits() - 1 }} downto 0);

    signal aclk          : std_logic := '0';
    signal aresetn       : std_logic := '1';
    signal s_axis_tdata  : input_word := (others => '0');
    signal s_axis_tvalid : std_logic := '0';
    signal s_axis_tready : std_logic;
    signal s_axis_tlast  : std_logic := '0';
    signal s_axis_tuser  : user_word := (others => '0');
{%- if bench.has_sets() %}
    signal texel_set     : std_logic;
{%- endif %}
{%- for write in bench.writes %}
    signal {{ write.enable }} : std_logic := '0';
    signal {{ write.address }} : std_logic_vector({{ write.address_bits - 1 }} downto 0) := (others => '0');
    signal {{ write.data }} : std_logic_vector({{ write.data_bits - 1 }} downto 0) := (others => '0');
{%- endfor %}
{%- if let Some(table) = bench.written_table() %}
    signal lights_en : std_logic := '0';
    signal lights_addr : std_logic_vector({{ table.address_bits - 1 }} downto 0) := (others => '0');
    signal lights_data : std_logic_vector({{ table.word_bits - 1 }} downto 0) := (others => '0');
{%- endif %}
{%- if bench.memory.is_some() %}
    signal texels_ce     : std_logic;
{%- endif %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
    signal {{ part.port.address.name }} : {{ bench.vector("unsigned") }}({{ part.address_bits - 1 }} downto 0);
    signal {{ part.port.data.name }} : {{ bench.vector("unsigned") }}({{ part.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
    signal m_axis_tdata  : output_word;
    signal m_axis_tvalid : std_logic;
    signal m_axis_tready : std_logic := '0';
    signal m_axis_tlast  : std_logic;
    signal m_axis_tuser  : user_word;
    signal beat          : beat_word;

begin

    dut : entity work.{{ axis.name }}
{%- if !bench.rom_files.is_empty() %}
        generic map (
{%- for file in bench.rom_files %}
            {{ file.parameter }} => {{ file.parameter }}{% if !loop.last %},{% endif %}
{%- endfor %}
        )
{%- endif %}
        port map (
            aclk          => aclk,
            aresetn       => aresetn,
            s_axis_tdata  => s_axis_tdata,
            s_axis_tvalid => s_axis_tvalid,
            s_axis_tready => s_axis_tready,
            s_axis_tlast  => s_axis_tlast,
            s_axis_tuser  => s_axis_tuser,
{%- if bench.has_sets() %}
            texel_set => texel_set,
{%- endif %}
{%- for write in bench.writes %}
            {{ write.enable }} => {{ write.enable }},
            {{ write.address }} => {{ bench.driven("unsigned", write.address) }},
            {{ write.data }} => {{ bench.driven("unsigned", write.data) }},
{%- endfor %}
{%- if bench.written_table().is_some() %}
            lights_en => lights_en,
            lights_addr => {{ bench.driven("unsigned", "lights_addr") }},
            lights_data => {{ bench.driven("unsigned", "lights_data") }},
{%- endif %}
{%- if bench.memory.is_some() %}
            texels_ce => texels_ce,
{%- endif %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
            {{ part.port.address.name }} => {{ part.port.address.name }},
            {{ part.port.data.name }} => {{ part.port.data.name }},
{%- endfor %}
{%- endif %}
            m_axis_tdata  => m_axis_tdata,
            m_axis_tvalid => m_axis_tvalid,
            m_axis_tready => m_axis_tready,
            m_axis_tlast  => m_axis_tlast,
            m_axis_tuser  => m_axis_tuser
        );
{%- let (clock, enable) = ("aclk", "texels_ce") %}
{%- include "testbench/memory_instance.vhd" %}

    beat <= m_axis_tuser & m_axis_tlast & m_axis_tdata;

    run : process is

        -- The beats under way, as a ring: what is due at the sink. The wrapper holds at most one
        -- more than its core.
        constant PLACES : positive := LATENCY + 2;
        type entry is record
            beat   : beat_word;
            number : integer; -- 0: not a vector of the file
{%- if bench.counts_lights() %}
            lights : natural; -- vectors of the sample
{%- endif %}
{%- if bench.table.is_some() %}
            clock  : natural; -- when it is taken if nothing waits
{%- endif %}
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
{%- if bench.sums.is_some() %}
{%- if bench.counts_lights() %}
        variable ends       : boolean := false; -- the sample ends
{%- endif %}
{%- for port in bench.results %}
        variable expected_{{ port.name }} : {{ port.name }}_word := (others => '0');
{%- endfor %}
{%- endif %}
{%- include "testbench/lights_state.vhd" %}
{%- if bench.table.is_some() %}

        -- The sample whose words are read.
        variable remaining : natural := 0;     -- words that are still to be read
        variable moves     : boolean := false; -- nothing waits: a word is read at this clock
        variable timed     : boolean := false; -- nothing ever waits: samples come when they must
{%- endif %}
{%- if bench.written_table().is_some() %}

        -- The sample that is offered next.
{% include "testbench/sample_state.vhd" %}
{%- endif %}

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
{%- if bench.table.is_none() %}
        variable first_in     : natural := 0; -- the clock at which the first vector was accepted,
        variable last_out     : natural := 0; -- and that at which the last was taken
{%- endif %}
{%- if !bench.writes.is_empty() %}

        -- ------------------------------------------------------------------ loading
        constant COMPLEMENTS          : natural := {{ bench.complemented.len() }}; -- vectors for the words' complements
        variable complements_sent     : natural := 0;
{%- if bench.has_sets() %}
        variable swap : std_logic_vector(0 downto 0) := "0"; -- what is offered of it
{%- endif %}
        variable complements_compared : natural := 0;
{%- for write in bench.writes %}
        subtype {{ write.memory }}_word is std_logic_vector({{ write.data_bits - 1 }} downto 0);
        type {{ write.memory }}_words is array (0 to {{ write.depth - 1 }}) of {{ write.memory }}_word;
        variable words_{{ write.memory }} : {{ write.memory }}_words;
        file file_of_{{ write.memory }} : text;
{%- endfor %}
{%- endif %}

{% include "testbench/vector_state.vhd" %}

{% include "testbench/random.vhd" %}

{% include "testbench/messages.vhd" %}

        -- The verdict is the last line the bench prints. After a PASS it does no more, and as
        -- it makes the clock, the simulation ends. After a FAIL the simulator may add a line.
        procedure conclude is
        begin
{%- if !bench.writes.is_empty() %}
            if not failed and (COMPLEMENTS = 0 or complements_compared /= COMPLEMENTS) then
                say(to_string(complements_compared) & " of " & to_string(COMPLEMENTS)
                    & " vectors compared with complemented words");
                failed := true;
            end if;
{%- endif %}
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
                    & hex(want(want'high downto {{ axis.outputs.tdata_bits() + 1 }}))
                    & " " & to_string(want({{ axis.outputs.tdata_bits() }}))
                    & " " & hex(want({{ axis.outputs.tdata_bits() - 1 }} downto 0))
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
{%- if bench.table.is_some() %}
            -- Full throughput: the source never waits for more than the sink and the last word of
            -- the sample before, and a full pipeline has a beat to give at every clock.
            if was_ready and (s_axis_tready = '1') /= (remaining <= 1) then
                fault("s_axis_tready is not as the words and the sink have it");
            end if;
{%- else %}
            -- Full throughput: the source never waits for more than the sink, and a full
            -- pipeline has a beat to give at every clock.
            if was_ready and s_axis_tready /= '1' then
                fault("s_axis_tready is low, and the sink was ready");
            end if;
{%- endif %}
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
                compared := compared + {{ bench.lights("due(oldest).lights") }};
{%- if bench.table.is_none() %}
                last_out := clocks;
{%- endif %}
            end if;
{%- if bench.table.is_some() %}
            if timed and clocks /= due(oldest).clock then
                fault("a sample comes at another clock than its words have it");
            end if;
{%- endif %}
{%- if !bench.writes.is_empty() %}
            if due(oldest).number < 0 then
                complements_compared := complements_compared + 1;
            end if;
{%- endif %}
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
{%- if bench.counts_lights() %}
                due(place).lights := lights;
{%- endif %}
{%- if bench.table.is_some() %}
                due(place).clock  := clocks + LATENCY - 1 + remaining;
{%- endif %}
                under_way         := under_way + 1;
            end if;
{%- if bench.table.is_none() && !bench.counts_lights() %}
            if number = 1 then
                first_in := clocks;
            end if;
{%- endif %}
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
{%- if bench.table.is_some() %}
            if moves and remaining /= 0 then
                remaining := remaining - 1;
            end if;
            if accepted then
                remaining := {{ axis.vhdl_words_of_beat() }};
            end if;
            moves := aresetn = '1' and not held;
{%- endif %}
{%- if bench.counts_lights() %}
            if accepted and number = 1 then
                first_in := clocks;
            end if;
            if accepted then
                quiet := 0;
            end if;
            if accepted and s_axis_tlast = '1' then
{%- else %}
            if accepted then
{%- endif %}
                accept_beat;
            end if;
            if aresetn = '0' then
                known     := true;
                under_way := 0;
{%- if bench.table.is_some() %}
                remaining := 0;
{%- endif %}
            end if;
            wait for 5 ns;
            aclk <= '0';
            if quiet > {{ bench.patience() }} then
                say("clock " & to_string(clocks) & ": nothing moves any more");
                failed := true;
                conclude;
            end if;
        end procedure;

        -- Whatever the wrapper must not look at is random.
        procedure present_garbage(valid : std_logic) is
        begin
            draw;
{%- for part in axis.input_parts() %}
            s_axis_tdata({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
            draw;
            s_axis_tlast <= lfsr(31);
{%- for part in axis.user_parts() %}
{%- if !loop.first %}
            draw;
{%- endif %}
            s_axis_tuser({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
{%- for write in bench.writes %}
            {{ write.enable }} <= '0';
            draw;
            {{ write.address }} <= lfsr({{ write.address_bits - 1 }} downto 0);
{%- for part in write.parts() %}
            {{ write.data }}({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
{%- endfor %}
{%- if let Some(table) = bench.written_table() %}
            lights_en <= '0';
            draw;
            lights_addr <= lfsr({{ table.address_bits - 1 }} downto 0);
{%- for part in table.parts() %}
            lights_data({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
{%- endif %}
            s_axis_tvalid <= valid;
            number := 0;
        end procedure;

        procedure idle_clock is
        begin
            present_garbage('0');
            clock;
        end procedure;

{% include "testbench/lights.vhd" %}
{%- include "testbench/sample.vhd" %}

        -- Offers the vector that was read last until it is accepted; before it, as many idle
        -- clocks as the source's rate gives. What no port takes of tdata is random, and so {% if bench.counts_lights() %}is
        -- tuser{% else %}are
        -- tlast and tuser{% endif %}.{% if bench.written_table().is_some() %} Its light is written before, while the sample before may still
        -- be read.{% endif %}
        procedure send(of_number : integer) is
        begin
            draw;
            while to_integer(unsigned(lfsr(31 downto 29))) >= source_rate loop
                idle_clock;
                draw;
            end loop;
{%- if bench.written_table().is_some() %}
            choose_words;
            for written in begins_at to begins_at + words - 1 loop
                present_garbage('0');
                present_light(written);
                clock;
            end loop;
{%- endif %}
            present_garbage('1');
{%- if bench.has_sets() %}
            -- The last vector for complements ends the samples that are looked up in the first set.
            swap := "0";
            if of_number < 0 and complements_sent = COMPLEMENTS then
                swap := "1";
            end if;
{%- endif %}
{%- for lane in axis.inputs.lanes %}
            s_axis_tdata({{ lane.downto() }}) <= {{ bench.vhdl_offered(lane) }};
{%- endfor %}
            expected := (others => '0');
{%- if bench.written_table().is_some() %}
            add_words;
{%- endif %}
{%- if bench.counts_lights() %}
            draw;
            ends := of_number < 0 or chosen_last;
            add_lights(ends);
            s_axis_tlast <= '1' when ends else '0';
{%- endif %}
{%- for lane in axis.outputs.lanes %}
            expected({{ lane.downto() }}) := {% if bench.sums.is_some() %}expected{% else %}file{% endif %}_{{ lane.port.name }};
{%- endfor %}
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

{% include "testbench/vector_file.vhd" %}
{%- if !bench.writes.is_empty() %}

{% include "testbench/words.vhd" %}

        -- Writes every word of the memories, or its complement{% if bench.has_sets() %}, to a set of texels{% endif %}.
        procedure load(complement : boolean{% if bench.has_sets() %}; set : std_logic{% endif %}) is
        begin
{%- for write in bench.writes %}
            for address in words_{{ write.memory }}'range loop
                present_garbage('0');
                {{ write.enable }} <= '1';
                {{ write.address }} <= {% if bench.has_sets() %}set & {% endif %}std_logic_vector(to_unsigned(address, {{ write.own_bits() }}));
                {{ write.data }} <= words_{{ write.memory }}(address);
                if complement then
                    {{ write.data }} <= not words_{{ write.memory }}(address);
                end if;
                quiet := 0;
                clock;
            end loop;
{%- endfor %}
        end procedure;

        procedure send_complement(
{%- for port in bench.numbers() %}
            of_{{ port.name }} : {{ port.name }}_word{% if !loop.last %};{% endif %}
{%- endfor %}
        ) is
        begin
{%- for port in bench.numbers() %}
            file_{{ port.name }} := of_{{ port.name }};
{%- endfor %}
            complements_sent := complements_sent + 1;
            send(-complements_sent);
        end procedure;
{%- endif %}

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
{%- if bench.table.is_some() %}
            timed       := not stalls;
{%- endif %}
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
{%- if bench.table.is_none() %}
            if not failed and not stalls and last_out - first_in /= count - 1 + LATENCY then
                say(to_string(count) & " vectors took " & to_string(last_out - first_in)
                    & " clocks without a stall, not " & to_string(count - 1 + LATENCY));
                failed := true;
            end if;
{%- endif %}
            if failed then
                conclude;
            end if;
        end procedure;

    begin
        reset_phase(8);
        reset_phase(0);
        reset_phase(4);
{%- if !bench.writes.is_empty() %}
        read_words;
{%- if bench.has_sets() %}
        -- The words in the second set alone.
        load(true, '0');
        load(true, '1');
        load(false, '1');
{%- else %}
        load(true);
{%- endif %}
{%- for vector in bench.complemented %}
        send_complement({{ vector }});
{%- endfor %}
        drain;
{%- if !bench.has_sets() %}
        load(false);
{%- endif %}
{%- endif %}
        run_vectors(false);
        run_vectors(true);
        conclude;
    end process;

end architecture;
