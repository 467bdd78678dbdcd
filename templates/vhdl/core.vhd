{%- let header = &texts.header %}
{%- let rom_files = &texts.rom_files %}
{%- include "vhdl/header.vhd" %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
{%- if !texts.rom_files.is_empty() %}
use std.textio.all;
{%- endif %}

entity {{ texts.name }} is
{%- include "vhdl/generics.vhd" %}
    port (
{%- for port in ports %}
        -- {{ port.comment }}
        {{ port.declaration }}{% if !loop.last %};{% endif %}
{%- endfor %}
    );
end entity {{ texts.name }};

architecture rtl of {{ texts.name }} is

{%- for stage in stages %}
{%- for memory in stage.memories %}
    -- ===== The memory {{ memory.name }}{% if memory.outside.is_some() %} outside of the core{% endif %}
{%- if memory.outside.is_some() %}
{%- else if let Some(generic) = memory.generic %}
    type {{ memory.name }}_t is array ({{ memory.last() }} downto 0) of
        std_logic_vector({{ memory.bits - 1 }} downto 0);
{%- let reader = memory.reader() %}

{% include "vhdl/word_reader.vhd" %}

    constant {{ memory.constant }}{% if memory.write.is_some() %}_WORDS{% endif %} : {{ memory.name }}_t := read_{{ memory.name }}({{ generic }});
{%- else %}
{%- for chunk in memory.chunks %}
    -- Bits {{ chunk.high }} downto {{ chunk.low }} of each word.
    type {{ memory.name }}_words_{{ chunk.index }}_t is array ({{ memory.depth - 1 }} downto 0) of
        std_logic_vector({{ chunk.element_bits - 1 }} downto 0);
    constant {{ memory.constant }}_WORDS_{{ chunk.index }} : {{ memory.name }}_words_{{ chunk.index }}_t := (
{%- for (address, word) in chunk.rows %}
        {{ address }} => x"{{ word }}"{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- endfor %}
{%- endif %}
{%- if memory.write.is_some() %}
{%- if memory.generic.is_some() %}
    signal {{ memory.name }} : {{ memory.name }}_t := {{ memory.constant }}_WORDS;
{%- else %}
    type {{ memory.name }}_t is array ({{ memory.depth - 1 }} downto 0) of
        std_logic_vector({{ memory.bits - 1 }} downto 0);

    function initial_{{ memory.name }} return {{ memory.name }}_t is
        variable result : {{ memory.name }}_t;
    begin
        for address in result'range loop
{%- for chunk in memory.chunks %}
            result(address)({{ chunk.high }} downto {{ chunk.low }}) :=
                {{ memory.constant }}_WORDS_{{ chunk.index }}(address)({{ chunk.bits - 1 }} downto 0);
{%- endfor %}
        end loop;
        return result;
    end function;

    signal {{ memory.name }} : {{ memory.name }}_t := initial_{{ memory.name }};
{%- endif %}
    -- What is read from an address at the edge at which it is written is not defined: the attribute
    -- spares the logic that would make it so.
{%- if is_first_written(memory.name) %}
    attribute ramstyle : string;
{%- endif %}
    attribute ramstyle of {{ memory.name }} : signal is "no_rw_check";
{%- endif %}
    signal {{ memory.word }} : std_logic_vector({{ memory.bits - 1 }} downto 0) := (others => '0');
{% endfor %}
{%- endfor %}
    signal valid : std_logic_vector({{ latency }} downto 1) := (others => '0');
{%- if let Some(last) = set_stage %}
{%- if *last > 0 %}
    -- The set of texels, in step with what is looked up in it.
    signal sets  : std_logic_vector({{ last }} downto 1) := (others => '0');
{%- endif %}
{%- endif %}
{%- for signal in signals %}
    signal {{ signal.name }} : {{ signal.kind }};
{%- endfor %}

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= {% if latency == 1 %}(1 => in_valid){% else %}valid({{ latency - 1 }} downto 1) & in_valid{% endif %};
            end if;
        end if;
    end process;
{%- if let Some(last) = set_stage %}
{%- if *last > 0 %}

    -- ===== The set of texels
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sets <= {% if *last == 1 %}(1 => in_set){% else %}sets({{ last - 1 }} downto 1) & in_set{% endif %};
            end if;
        end if;
    end process;
{%- endif %}
{%- endif %}
{%- if !inputs.is_empty() %}

    -- ===== The inputs as numbers
{%- for (signal, port) in inputs %}
    {{ signal }} <= {{ port }};
{%- endfor %}
{%- endif %}
{%- for stage in stages %}

    -- ===== Stage {{ stage.index }}: {{ stage.heading }}
{%- for assignment in stage.assignments %}
    -- {{ assignment.comment }}
    {{ assignment.target }} <={{ assignment.expression }};
{%- endfor %}
{%- for memory in stage.memories %}
{%- if let Some(write) = memory.write %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if {{ write.enable.name }} = '1' then
                {{ memory.name }}(to_integer({{ self.write_address(write) }})) <= std_logic_vector({{ write.data.name }});
            end if;
        end if;
    end process;
{%- endif %}
{%- if let Some(outside) = memory.outside %}
    {{ outside.address.name }} <= {{ self.read_address(memory.address) }};
{%- endif %}
{%- if memory.registered %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- if let Some(outside) = memory.outside %}
                {{ memory.word }} <= std_logic_vector({{ outside.data.name }});
{%- else if let Some(array) = memory.array() %}
                {{ memory.word }} <= {{ array }}(to_integer({{ memory.address }}));
{%- else %}
{%- for chunk in memory.chunks %}
                {{ memory.word }}({{ chunk.high }} downto {{ chunk.low }}) <=
                    {{ memory.constant }}_WORDS_{{ chunk.index }}(to_integer({{ memory.address }}))({{ chunk.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
            end if;
        end if;
    end process;
{%- else if let Some(array) = memory.array() %}
    {{ memory.word }} <= {{ array }}(to_integer({{ memory.address }}));
{%- else %}
{%- for chunk in memory.chunks %}
    {{ memory.word }}({{ chunk.high }} downto {{ chunk.low }}) <=
        {{ memory.constant }}_WORDS_{{ chunk.index }}(to_integer({{ memory.address }}))({{ chunk.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
{%- endfor %}
{%- if !stage.registers.is_empty() %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- for (target, source) in stage.registers %}
                {{ target }} <= {{ source }};
{%- endfor %}
            end if;
        end if;
    end process;
{%- endif %}
{%- endfor %}

    {{ out_valid }} <= valid({{ latency }});
{%- for (port, source) in outputs %}
    {{ port }} <= {{ source }};
{%- endfor %}

end architecture rtl;
