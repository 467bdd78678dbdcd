{%- let header = &sequencer.header %}
{%- let rom_files = &core.rom_files %}
{%- include "vhdl/header.vhd" %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity {{ sequencer.name }} is
{%- include "vhdl/generics.vhd" %}
    port (
{%- for port in ports %}
        -- {{ port.comment }}
        {{ port.declaration }}{% if !loop.last %};{% endif %}
{%- endfor %}
    );
end entity {{ sequencer.name }};

architecture rtl of {{ sequencer.name }} is

    -- Valid chain of whole samples: a bit where one's last lights are, in step with the core.
    signal valid     : std_logic_vector({{ sequencer.latency }} downto 1) := (others => '0');
    -- Whether the next lights out of the core are the first of their sample.
    signal begins    : std_logic := '1';
    signal sum_valid : std_logic := '0';
{%- if sequencer.swaps() %}
    -- The set of texels that samples are looked up in.
    signal in_set    : std_logic := '0';
{%- endif %}
{%- for port in sequencer.core_outputs() %}
    signal {{ port.name }} : {{ core.vhdl_ports.vector("unsigned") }}({{ port.high() }} downto 0) := (others => '0');
{%- endfor %}
{%- for channel in channels %}
    signal start_{{ channel.c }} : unsigned({{ f }} downto 0) := (others => '0');
    signal sum_{{ channel.c }}   : unsigned({{ f + 1 }} downto 0) := (others => '0');
    signal total_{{ channel.c }} : unsigned({{ f - 1 }} downto 0) := (others => '0');
    signal full_{{ channel.c }}  : std_logic := '0';
    signal near_{{ channel.c }}  : unsigned({{ f }} downto 0) := (others => '0');
    signal code_{{ channel.c }}  : unsigned({{ bits - 1 }} downto 0) := (others => '0');
{%- endfor %}

begin

    -- ===== The core: what the lights of a clock give
    core : entity work.{{ core.name }}
{%- include "vhdl/generic_map.vhd" %}
        port map (
            {{ sequencer.padded("clk") }} => clk,
            {{ sequencer.padded("rst") }} => rst,
            {{ sequencer.padded("ce") }} => ce,
            {{ sequencer.padded("in_valid") }} => in_valid,
{%- for port in sequencer.driven().iter().chain(sequencer.addresses()) %}
            {{ sequencer.padded(port.name) }} => {{ port.name }},
{%- endfor %}
            {{ sequencer.padded("out_valid") }} => sum_valid,
{%- for port in sequencer.core_outputs() %}
            {{ sequencer.padded(port.name) }} => {{ port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
        );

{%- if sequencer.swaps() %}

    -- ===== The set of texels: the other one behind a swap
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                in_set <= '0';
            elsif ce = '1' and in_valid = '1' and in_last = '1' and swap = '1' then
                in_set <= not in_set;
            end if;
        end if;
    end process;
    texel_set <= in_set;
{%- endif %}

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid  <= (others => '0');
                begins <= '1';
            elsif ce = '1' then
                valid <= valid({{ sequencer.latency - 1 }} downto 1) & (in_valid and in_last);
                if sum_valid = '1' then
                    begins <= valid({{ sequencer.core_latency }});
                end if;
            end if;
        end if;
    end process;

    -- ===== Stage {{ sequencer.core_latency + 1 }}: the sum of a sample's lights below 1.0, and whether it has reached that
{%- for channel in channels %}
    start_{{ channel.c }} <= {{ channel.vhdl_start }} when begins = '1' else
        '0' & total_{{ channel.c }};
    sum_{{ channel.c }}   <= resize(start_{{ channel.c }}, {{ f + 2 }}) + unsigned(out_sum_{{ channel.c }});
{%- endfor %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' and sum_valid = '1' then
{%- for channel in channels %}
                total_{{ channel.c }} <= sum_{{ channel.c }}({{ f - 1 }} downto 0);
                if sum_{{ channel.c }}({{ f + 1 }} downto {{ f }}) /= "00" then
                    full_{{ channel.c }} <= '1';
                elsif begins = '1' then
                    full_{{ channel.c }} <= '0';
                end if;
{%- endfor %}
            end if;
        end if;
    end process;

    -- ===== Stage {{ sequencer.latency }}: the nearest code, at most full scale
{%- for channel in channels %}
    near_{{ channel.c }} <= ('0' & total_{{ channel.c }}) + {{ sequencer.sums.half_code() }};
{%- endfor %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- for channel in channels %}
                if full_{{ channel.c }} = '1' or near_{{ channel.c }}({{ f }}) = '1' then
                    code_{{ channel.c }} <= (others => '1');
                else
                    code_{{ channel.c }} <= near_{{ channel.c }}({{ f - 1 }} downto {{ f - bits }});
                end if;
{%- endfor %}
            end if;
        end if;
    end process;

    out_valid <= valid({{ sequencer.latency }});
{%- for channel in channels %}
    out_{{ channel.c }}     <= {{ channel.vhdl_code }};
{%- endfor %}

end architecture rtl;
