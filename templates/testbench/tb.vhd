{% for line in bench.header -%}
--{% if !line.is_empty() %} {{ line }}{% endif %}
{% endfor %}
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity {{ bench.name }}_tb is
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

architecture bench of {{ bench.name }}_tb is

    constant NAME    : string   := "{{ bench.name }}";
    constant LATENCY : positive := {{ bench.latency }};
    constant SHOWN   : positive := 10; -- mismatches printed; the others are only counted
{% for port in bench.words() %}
    subtype {{ port.name }}_word is std_logic_vector({{ port.bits - 1 }} downto 0);
{%- endfor %}

    signal {{ bench.padded("clk") }} : std_logic := '0';
    signal {{ bench.padded("rst") }} : std_logic := '0';
    signal {{ bench.padded("ce") }} : std_logic := '0';
    signal {{ bench.padded("in_valid") }} : std_logic := '0';
{%- if bench.table.is_some() %}
    signal {{ bench.padded("in_ready") }} : std_logic;
{%- endif %}
{%- if let Some(table) = bench.written_table() %}
    signal {{ bench.padded("in_begin") }} : std_logic_vector({{ table.address_bits - 1 }} downto 0) := (others => '0');
    signal {{ bench.padded("in_end") }} : std_logic_vector({{ table.address_bits - 1 }} downto 0) := (others => '0');
    signal {{ bench.padded("lights_en") }} : std_logic := '0';
    signal {{ bench.padded("lights_addr") }} : std_logic_vector({{ table.address_bits - 1 }} downto 0) := (others => '0');
    signal {{ bench.padded("lights_data") }} : std_logic_vector({{ table.word_bits - 1 }} downto 0) := (others => '0');
{%- else if bench.sums.is_some() %}
    signal {{ bench.padded("in_last") }} : std_logic := '0';
{%- endif %}
{%- for port in bench.inputs %}
    signal {{ bench.padded(port.name) }} : {{ port.name }}_word := (others => '0');
{%- endfor %}
{%- if bench.swaps() %}
    signal {{ bench.padded("swap") }} : std_logic := '0';
    signal {{ bench.padded("texel_set") }} : std_logic;
{%- else if bench.has_sets() %}
    signal {{ bench.padded("in_set") }} : std_logic := '0';
{%- endif %}
{%- for write in bench.writes %}
    signal {{ write.enable }} : std_logic := '0';
    signal {{ write.address }} : std_logic_vector({{ write.address_bits - 1 }} downto 0) := (others => '0');
    signal {{ write.data }} : std_logic_vector({{ write.data_bits - 1 }} downto 0) := (others => '0');
{%- endfor %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
    signal {{ part.port.address.name }} : {{ bench.vector("unsigned") }}({{ part.address_bits - 1 }} downto 0);
    signal {{ part.port.data.name }} : {{ bench.vector("unsigned") }}({{ part.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
    signal {{ bench.padded("out_valid") }} : std_logic;
{%- for port in bench.results %}
    signal {{ bench.padded(port.name) }} : {{ bench.vector(port.sign()) }}({{ port.bits - 1 }} downto 0);
{%- endfor %}

begin

    dut : entity work.{{ bench.name }}
{%- if !bench.rom_files.is_empty() %}
        generic map (
{%- for file in bench.rom_files %}
            {{ file.parameter }} => {{ file.parameter }}{% if !loop.last %},{% endif %}
{%- endfor %}
        )
{%- endif %}
        port map (
            {{ bench.padded("clk") }} => clk,
            {{ bench.padded("rst") }} => rst,
            {{ bench.padded("ce") }} => ce,
            {{ bench.padded("in_valid") }} => in_valid,
{%- if bench.table.is_some() %}
            {{ bench.padded("in_ready") }} => in_ready,
{%- endif %}
{%- if bench.written_table().is_some() %}
            {{ bench.padded("in_begin") }} => {{ bench.driven("unsigned", "in_begin") }},
            {{ bench.padded("in_end") }} => {{ bench.driven("unsigned", "in_end") }},
            {{ bench.padded("lights_en") }} => lights_en,
            {{ bench.padded("lights_addr") }} => {{ bench.driven("unsigned", "lights_addr") }},
            {{ bench.padded("lights_data") }} => {{ bench.driven("unsigned", "lights_data") }},
{%- else if bench.sums.is_some() %}
            {{ bench.padded("in_last") }} => in_last,
{%- endif %}
{%- for port in bench.driven_inputs() %}
            {{ bench.padded(port.name) }} => {{ bench.driven(port.sign(), port.name) }},
{%- endfor %}
{%- if bench.swaps() %}
            {{ bench.padded("swap") }} => swap,
            {{ bench.padded("texel_set") }} => texel_set,
{%- else if bench.has_sets() %}
            {{ bench.padded("in_set") }} => in_set,
{%- endif %}
{%- for write in bench.writes %}
            {{ write.enable }} => {{ write.enable }},
            {{ write.address }} => {{ bench.driven("unsigned", write.address) }},
            {{ write.data }} => {{ bench.driven("unsigned", write.data) }},
{%- endfor %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
            {{ part.port.address.name }} => {{ part.port.address.name }},
            {{ part.port.data.name }} => {{ part.port.data.name }},
{%- endfor %}
{%- endif %}
            {{ bench.padded("out_valid") }} => out_valid,
{%- for port in bench.results %}
            {{ bench.padded(port.name) }} => {{ port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
        );
{%- let (clock, enable) = ("clk", "ce") %}
{%- include "testbench/memory_instance.vhd" %}

    run : process is

        -- What the core has taken and not yet given back: one entry for each enabled clock of
        -- the latency, as a ring. The entry at `slot` is the one at the core's outputs now; the
        -- next enabled clock overwrites it with what the core takes then.
        type entry is record
            {{ bench.padded("known") }} : boolean; -- false: from before the core was driven
            {{ bench.padded("valid") }} : std_logic;
            {{ bench.padded("number") }} : {% if bench.writes.is_empty() %}natural{% else %}integer{% endif %}; -- 0: not a vector of the file
{%- if bench.counts_lights() %}
            {{ bench.padded("lights") }} : natural; -- vectors of the sample that ends with it
{%- endif %}
{%- for port in bench.shown() %}
            {{ bench.padded(port.name) }} : {{ port.name }}_word;
{%- endfor %}
        end record;
        type ring is array (0 to LATENCY - 1) of entry;

        variable due : ring := (others => (
            {{ bench.padded("known") }} => false,
            {{ bench.padded("valid") }} => '0',
            {{ bench.padded("number") }} => 0,
{%- if bench.counts_lights() %}
            {{ bench.padded("lights") }} => 0,
{%- endif %}
{%- for port in bench.shown() %}
            {{ bench.padded(port.name) }} => (others => '0'){% if !loop.last %},{% endif %}
{%- endfor %}
        ));
        variable slot : natural range 0 to LATENCY - 1 := 0;
{%- if let Some(table) = bench.table %}

        -- A sample of so many words comes out so many enabled clocks and these later.
        constant BEHIND    : natural := {{ table.behind }};
        variable remaining : natural := 0; -- words of the sample that are still to be read
        variable place     : natural;
        variable accepted  : boolean := false;
{%- if table.is_written %}
{% include "testbench/sample_state.vhd" %}
{%- endif %}
{%- endif %}

        -- What is presented at the inputs now, beside the inputs themselves.
        variable number : {% if bench.writes.is_empty() %}natural{% else %}integer{% endif %} := 0;
{%- for port in bench.results %}
        variable expected_{{ bench.padded(port.name) }} : {{ port.name }}_word := (others => '0');
{%- endfor %}

{%- include "testbench/lights_state.vhd" %}

        variable looked     : boolean := false; -- the entry at the outputs has been looked at,
        variable reported   : boolean := false; -- and found wrong: a held fault is counted once
        variable compared   : natural := 0;
        variable mismatches : natural := 0;
        variable clocks     : natural := 0;
{%- if !bench.writes.is_empty() %}

        -- ------------------------------------------------------------------ loading
        constant COMPLEMENTS          : natural := {{ bench.complemented.len() }}; -- vectors for the words' complements
        variable complements_fed      : natural := 0;
        variable complements_compared : natural := 0;
        variable granted              : integer := 0; -- clocks that the watchdog does not count
{%- if bench.has_sets() %}
        -- What is done about the set of texels: as the core comes up they are the same, and any
        -- will do; then the first holds complements, until the last of their vectors is sent; and
        -- then it is the second that is looked up.
        type plan is (ANY, FIRST, SECOND);
        variable of_sets : plan := ANY;
{%- endif %}
{%- for write in bench.writes %}
        subtype {{ write.memory }}_word is std_logic_vector({{ write.data_bits - 1 }} downto 0);
        type {{ write.memory }}_words is array (0 to {{ write.depth - 1 }}) of {{ write.memory }}_word;
        variable words_{{ write.memory }} : {{ write.memory }}_words;
        file file_of_{{ write.memory }} : text;
{%- endfor %}
{%- endif %}

{% include "testbench/vector_state.vhd" %}

{% include "testbench/random.vhd" %}

        impure function one_in_eight return boolean is
        begin
            return lfsr(31 downto 29) = "000";
        end function;

{% include "testbench/messages.vhd" %}

        -- The verdict is the last line the bench prints. After a PASS it does no more, and as
        -- it makes the clock, the simulation ends. After a FAIL the simulator may add a line.
        procedure conclude is
        begin
            if not failed and compared /= count then
                say("the file announces " & to_string(count) & " vectors");
            end if;
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
        impure function shown_outputs return string is
        begin
            if out_valid /= '1' then
                return "out_valid " & to_string(out_valid);
            end if;
            return {% for port in bench.results %}{% if !loop.first %}
                & " " & {% endif %}hex(std_logic_vector({{ port.name }})){% endfor %};
        end function;

        procedure show_mismatch is
            variable want : entry := due(slot);
        begin
            if want.number = 0 then
                say("clock " & to_string(clocks) & ": expected out_valid "
                    & to_string(want.valid) & ", got " & to_string(out_valid));
            else
{%- if bench.writes.is_empty() %}
                say("vector " & to_string(want.number)
{%- else %}
                if want.number < 0 then
                    say("with complemented words:");
                end if;
                say("vector " & to_string(abs want.number)
{%- endif %}
{%- for port in bench.inputs %}
                    & "{% if loop.first %}:{% else %},{% endif %} {{ port.name }} " & hex(want.{{ port.name }})
{%- endfor %}
                    & ": expected"
{%- for port in bench.results %}
                    & " " & hex(want.{{ port.name }})
{%- endfor %}
                    & ", got " & shown_outputs);
            end if;
        end procedure;

        -- The words are compared as std_logic_vector, where U, X and Z differ from 0 and 1 as
        -- any two values do; the "=" of numeric_std would only warn.
        procedure check_outputs is
            variable wrong : boolean;
        begin
            wrong := out_valid /= due(slot).valid;
{%- if bench.table.is_some() %}
            if (in_ready = '1') /= (remaining <= 1) then
                wrong := true;
            end if;
{%- endif %}
            if due(slot).number /= 0 then
{%- if bench.writes.is_empty() %}
                if not looked then
                    compared := compared + {{ bench.lights("due(slot).lights") }};
                end if;
{%- else %}
                if not looked and due(slot).number > 0 then
                    compared := compared + {{ bench.lights("due(slot).lights") }};
                end if;
                if not looked and due(slot).number < 0 then
                    complements_compared := complements_compared + 1;
                end if;
{%- endif %}
{%- for port in bench.results %}
                if std_logic_vector({{ port.name }}) /= due(slot).{{ port.name }} then
                    wrong := true;
                end if;
{%- endfor %}
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
{%- if bench.table.is_some() %}
            if ce = '1' then
                due(slot).known  := true;
                due(slot).valid  := '0';
                due(slot).number := 0;
                accepted := in_valid = '1' and remaining <= 1;
                if remaining > 0 then
                    remaining := remaining - 1;
                end if;
                if accepted and rst = '0' then
                    remaining := to_integer(unsigned(in_end) - unsigned(in_begin)) + 1;
                    place := (slot + remaining + BEHIND) mod LATENCY;
                    due(place).valid  := '1';
                    due(place).number := number;
{%- for port in bench.inputs %}
                    due(place).{{ port.name }} := {{ port.name }};
{%- endfor %}
{%- for port in bench.results %}
                    due(place).{{ port.name }} := expected_{{ port.name }};
{%- endfor %}
                end if;
                slot := (slot + 1) mod LATENCY;
            end if;
            if rst = '1' then
                remaining := 0;
            end if;
{%- else %}
            if ce = '1' then
                due(slot).known := true;
                due(slot).valid := in_valid{% if bench.sums.is_some() %} and in_last{% endif %};
                due(slot).number := number;
{%- if bench.counts_lights() %}
                due(slot).lights := lights;
{%- endif %}
{%- for port in bench.inputs %}
                due(slot).{{ port.name }} := {{ port.name }};
{%- endfor %}
{%- for port in bench.results %}
                due(slot).{{ port.name }} := expected_{{ port.name }};
{%- endfor %}
                slot := (slot + 1) mod LATENCY;
            end if;
{%- endif %}
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
            if {% if bench.writes.is_empty() %}clocks{% else %}(clocks - granted){% endif %} / 40 > vectors + 250 then
                say("watchdog: " & to_string(clocks) & " clocks for " & to_string(vectors)
                    & " vectors");
                failed := true;
                conclude;
            end if;
        end procedure;

        -- Whatever the core must not look at is random.
        procedure present_garbage(valid : std_logic) is
        begin
{%- for port in bench.inputs %}
            draw;
            {{ port.name }} <= lfsr({{ port.bits - 1 }} downto 0);
{%- endfor %}
{%- for write in bench.writes %}
            {{ write.enable }} <= '0';
            draw;
            {{ write.address }} <= lfsr({{ write.address_bits - 1 }} downto 0);
            draw;
{%- for part in write.parts() %}
            {{ write.data }}({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
{%- endfor %}
            in_valid <= valid;
{%- if let Some(table) = bench.written_table() %}
            draw;
            in_begin <= lfsr({{ table.address_bits - 1 }} downto 0);
            in_end <= lfsr({{ table.address_bits + 15 }} downto 16);
            lights_en <= '0';
            draw;
            lights_addr <= lfsr({{ table.address_bits - 1 }} downto 0);
{%- for part in table.parts() %}
            lights_data({{ part.high }} downto {{ part.low }}) <= lfsr({{ part.top() }} downto 0);
{%- endfor %}
{%- else if bench.sums.is_some() %}
            draw;
            in_last <= lfsr(31);
{%- endif %}
{%- if bench.has_sets() %}
            draw;
            {% if bench.swaps() %}swap{% else %}in_set{% endif %} <= lfsr(31);
{%- endif %}
            number := 0;
        end procedure;
{%- if bench.has_sets() %}

        -- The set of texels of the vector that is presented, or of the samples behind it, which the
        -- lights of this one end or not.
        procedure choose_set(last : boolean) is
        begin
            draw;
            if of_sets = ANY or not last then
                {% if bench.swaps() %}swap{% else %}in_set{% endif %} <= lfsr(31);
{%- if bench.swaps() %}
            elsif of_sets = FIRST and complements_fed = COMPLEMENTS then
                swap <= '1';
            else
                swap <= '0';
            end if;
{%- else %}
            else
                in_set <= '1' when of_sets = SECOND else '0';
            end if;
{%- endif %}
        end procedure;
{%- endif %}

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
{%- if bench.sums.is_some() %}
{% include "testbench/lights.vhd" %}
{%- include "testbench/sample.vhd" %}
{%- if let Some(table) = bench.table %}

        -- Writes the light of the vector that was read last to the words of a sample, and presents
        -- that until it is taken.
        procedure feed_sample(of_number : integer) is
        begin
            choose_words;
            for written in begins_at to begins_at + words - 1 loop
                random_stalls;
                present_garbage('0');
                draw;
                ce <= lfsr(31);
                present_light(written);
                clock;
                ce <= '1';
            end loop;
            random_stalls;
            present_garbage('1');
            in_begin <= std_logic_vector(to_unsigned(begins_at, {{ table.address_bits }}));
            in_end   <= std_logic_vector(to_unsigned(begins_at + words - 1, {{ table.address_bits }}));
            add_words;
{%- for port in bench.inputs %}
            {{ port.name }} <= file_{{ port.name }};
{%- endfor %}
            number   := of_number;
{%- if bench.has_sets() %}
            choose_set(true);
{%- endif %}
            accepted := false;
            while not accepted loop
                clock;
            end loop;
            in_valid <= '0';
        end procedure;
{%- else %}

        -- What was read last, and what is to come out for it.
        procedure present_lights(of_number : integer; last : boolean) is
        begin
            in_valid <= '1';
            in_last  <= '1' when last else '0';
{%- for port in bench.inputs %}
            {{ port.name }} <= file_{{ port.name }};
{%- endfor %}
            add_lights(last);
            if last then
                number := of_number;
            else
                number := 0;
            end if;
{%- if bench.has_sets() %}
            choose_set(last);
{%- endif %}
        end procedure;
{%- endif %}
{%- endif %}

{%- if bench.table.is_some() && bench.written_table().is_none() %}

        -- Presents a sample until it is taken.
        procedure be_taken is
        begin
            accepted := false;
            while not accepted loop
                clock;
            end loop;
            in_valid <= '0';
        end procedure;
{%- endif %}

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
{%- if bench.written_table().is_some() %}
            feed_sample(vectors);
{%- else if bench.sums.is_some() %}
            draw;
            present_lights(vectors, chosen_last);
{%- else %}
            in_valid <= '1';
{%- for port in bench.inputs %}
            {{ port.name }} <= file_{{ port.name }};
{%- endfor %}
{%- for port in bench.outputs %}
            expected_{{ port.name }} := file_{{ port.name }};
{%- endfor %}
            number := vectors;
{%- if bench.has_sets() %}
            choose_set(true);
{%- endif %}
{%- endif %}
{%- if bench.table.is_none() %}
            clock;
{%- else if bench.written_table().is_none() %}
            be_taken;
{%- endif %}
        end procedure;

        -- A full pipeline is reset by one clock: nothing that was taken before may come out.
        procedure reset_phase(enable : std_logic) is
        begin
            ce <= '1';
            for i in 1 to LATENCY + 2 loop
                present_garbage('1');
{%- if bench.sums.is_some() && bench.table.is_none() %}
                -- Without the enable a sample that has not ended is to be forgotten.
                if enable = '0' then
                    in_last <= '0';
                end if;
{%- endif %}
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

{% include "testbench/vector_file.vhd" %}

{%- if !bench.writes.is_empty() %}

{% include "testbench/words.vhd" %}

        -- Writes every word of the memories, or its complement{% if bench.has_sets() %}, to a set of texels{% endif %}. Neither ce nor rst must matter.
        procedure load(complement : boolean{% if bench.has_sets() %}; set : std_logic{% endif %}) is
        begin
{%- for write in bench.writes %}
            for address in words_{{ write.memory }}'range loop
                present_garbage('0');
                draw;
                ce  <= lfsr(31);
                rst <= lfsr(30);
                {{ write.enable }} <= '1';
                {{ write.address }} <= {% if bench.has_sets() %}set & {% endif %}std_logic_vector(to_unsigned(address, {{ write.own_bits() }}));
                {{ write.data }} <= words_{{ write.memory }}(address);
                if complement then
                    {{ write.data }} <= not words_{{ write.memory }}(address);
                end if;
                granted := granted + 1;
                clock;
            end loop;
{%- endfor %}
            present_garbage('0');
            ce  <= '1';
{%- if bench.has_sets() %}
            -- Samples are looked up in the first set again.
            rst <= '1';
            clock;
{%- endif %}
            rst <= '0';
        end procedure;

        -- A vector for the words' complements.
        procedure feed_complement(
{%- for port in bench.numbers() %}
            of_{{ port.name }} : {{ port.name }}_word{% if !loop.last %};{% endif %}
{%- endfor %}
        ) is
        begin
            idle_clock;
            random_stalls;
{%- if bench.sums.is_some() %}
{%- for port in bench.numbers() %}
            file_{{ port.name }} := of_{{ port.name }};
{%- endfor %}
            complements_fed := complements_fed + 1;
{%- if bench.table.is_some() %}
            feed_sample(-complements_fed);
{%- else %}
            present_lights(-complements_fed, true);
            clock;
{%- endif %}
{%- else %}
            in_valid <= '1';
{%- for port in bench.inputs %}
            {{ port.name }} <= of_{{ port.name }};
{%- endfor %}
{%- for port in bench.outputs %}
            expected_{{ port.name }} := of_{{ port.name }};
{%- endfor %}
            complements_fed := complements_fed + 1;
            number := -complements_fed;
{%- if bench.has_sets() %}
            choose_set(true);
{%- endif %}
{%- if bench.table.is_some() %}
            be_taken;
{%- else %}
            clock;
{%- endif %}
{%- endif %}
        end procedure;

        procedure feed_complements is
        begin
{%- for vector in bench.complemented %}
            feed_complement({{ vector }});
{%- endfor %}
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
{%- if bench.has_sets() %}
        -- The words in the second set alone.
        load(true, '0');
        load(true, '1');
        load(false, '1');
        of_sets := FIRST;
        feed_complements;
        empty_pipeline;
        of_sets := SECOND;
{%- else %}
        load(true);
        feed_complements;
        empty_pipeline;
        load(false);
{%- endif %}
        run_vectors;
        conclude;
    end process;
{%- else %}

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
{%- endif %}

end architecture;

