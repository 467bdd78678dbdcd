{%- let header = &table.header %}
{%- let rom_files = &core.rom_files %}
{%- include "vhdl/header.vhd" %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity {{ table.name }} is
{%- include "vhdl/generics.vhd" %}
    port (
{%- for port in ports %}
        -- {{ port.comment }}
        {{ port.declaration }}{% if !loop.last %};{% endif %}
{%- endfor %}
    );
end entity {{ table.name }};

architecture rtl of {{ table.name }} is

    -- The table{% if words.is_empty() %}: black lights until it is written{% else %}, a word with the last of its lights first{% endif %}.
    type records_t is array (0 to {{ table.depth - 1 }}) of std_logic_vector({{ table.word_bits() - 1 }} downto 0);
{%- if words.is_empty() %}
    signal records : records_t := (others => (others => '0'));
{%- else %}
    constant records : records_t := (
{%- for word in words %}
        {{ loop.index0 }} =>
{%- for light in word %}
            {{ light }}{% if !loop.last %} &{% endif %}
{%- endfor %}{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- endif %}

    -- The sample whose lights are read.
    signal busy  : std_logic := '0';
    signal free  : std_logic;
    signal ends  : std_logic;
    signal word  : unsigned({{ table.address_bits - 1 }} downto 0) := (others => '0');
    signal until_word : unsigned({{ table.address_bits - 1 }} downto 0) := (others => '0');
{%- for port in table.sample %}
    signal now_{{ port.name }} : {{ port.vhdl(core) }} := {{ port.vhdl_zero() }};
{%- endfor %}

    -- Its lights, a word a clock.
    signal valid  : std_logic := '0';
    signal last   : std_logic := '0';
    signal record_word : std_logic_vector({{ table.word_bits() - 1 }} downto 0) := (others => '0');
{%- for port in table.sample %}
    signal read_{{ port.name }} : {{ port.vhdl(core) }} := {{ port.vhdl_zero() }};
{%- endfor %}

begin
{% if words.is_empty() %}
    -- ===== The table
    process (clk) is
    begin
        if rising_edge(clk) then
            if lights_en = '1' then
                records(to_integer({{ table.vhdl_address(core) }})) <= std_logic_vector(lights_data);
            end if;
        end if;
    end process;
{% endif %}
    -- ===== The sample whose lights are read
    ends <= '1' when word = until_word else '0';
    free <= not busy or ends;
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                busy  <= '0';
                valid <= '0';
            elsif ce = '1' then
                if free = '1' then
                    busy <= in_valid;
                end if;
                valid <= busy;
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                if free = '1' then
                    word       <= unsigned(in_begin);
                    until_word <= unsigned(in_end);
{%- for port in table.sample %}
                    now_{{ port.name }} <= {{ port.name }};
{%- endfor %}
                else
                    word <= word + 1;
                end if;
            end if;
        end if;
    end process;

    -- ===== Its lights, a word a clock
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                last        <= ends;
                record_word <= records(to_integer(word));
{%- for port in table.sample %}
                read_{{ port.name }} <= now_{{ port.name }};
{%- endfor %}
            end if;
        end if;
    end process;

    -- ===== The sequencer
    sequencer : entity work.{{ table.sequencer.name }}
{%- include "vhdl/generic_map.vhd" %}
        port map (
            {{ table.padded("clk") }} => clk,
            {{ table.padded("rst") }} => rst,
            {{ table.padded("ce") }} => ce,
            {{ table.padded("in_valid") }} => valid,
            {{ table.padded("in_last") }} => last,
{%- for port in table.sample %}
            {{ table.padded(port.name) }} => read_{{ port.name }},
{%- endfor %}
{%- for lane in table.record.lanes %}
            {{ table.padded(lane.port.name) }} => {{ lane.of_bits("record_word", core) }},
{%- endfor %}
{%- for name in table.passed %}
            {{ table.padded(name) }} => {{ name }},
{%- endfor %}
            {{ table.padded("out_valid") }} => out_valid,
            {{ table.padded("out_r") }} => out_r,
            {{ table.padded("out_g") }} => out_g,
            {{ table.padded("out_b") }} => out_b
        );

    in_ready <= free;

end architecture rtl;
