{%- let header = &memory.header %}
{%- include "vhdl/header.vhd" %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity {{ memory.name }} is
{%- include "vhdl/generics.vhd" %}
    port (
        clk : in std_logic;
        ce  : in std_logic
{%- for part in memory.parts %};
        {{ part.port.address.name }} : in {{ ExternalMemory::vector(core, *part.address_bits) }};
        {{ part.port.data.name }} : out {{ ExternalMemory::vector(core, *part.bits) }}
{%- endfor %}
    );
end entity {{ memory.name }};

architecture model of {{ memory.name }} is
{%- for part in memory.parts %}

    type words_{{ loop.index }}_t is array (0 to {{ part.depth - 1 }}) of std_logic_vector({{ part.bits - 1 }} downto 0);
    type way_{{ loop.index }}_t is array (1 to {{ memory.clocks }}) of std_logic_vector({{ part.bits - 1 }} downto 0);
{%- let reader = part.reader(loop.index) %}

{% include "vhdl/word_reader.vhd" %}

    constant WORDS_{{ loop.index }} : words_{{ loop.index }}_t := read_{{ loop.index }}({{ part.file.parameter }});
    -- The words under way, the last one at the end. An address that is not known yet has none.
    signal way_{{ loop.index }} : way_{{ loop.index }}_t := (others => (others => 'X'));
{%- endfor %}

begin
{%- for part in memory.parts %}

    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                for place in 2 to {{ memory.clocks }} loop
                    way_{{ loop.index }}(place) <= way_{{ loop.index }}(place - 1);
                end loop;
                if is_x(std_logic_vector({{ part.port.address.name }})) then
                    way_{{ loop.index }}(1) <= (others => 'X');
                else
                    way_{{ loop.index }}(1) <= WORDS_{{ loop.index }}(to_integer({{ self.address(part) }}));
                end if;
            end if;
        end if;
    end process;
    {{ part.port.data.name }} <= {{ self.word(loop.index) }};
{%- endfor %}

end architecture model;
