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
    signal sum_valid : std_logic := '0';
{%- if sequencer.swaps() %}
    -- The set of texels that samples are looked up in.
    signal in_set    : std_logic := '0';
{%- endif %}
{%- for port in sequencer.core_outputs() %}
    signal {{ port.name }} : {{ core.vhdl_ports.vector("unsigned") }}({{ port.high() }} downto 0) := (others => '0');
{%- endfor %}
{%- for channel in channels %}
    -- Half a code and the lights of a sample so far, below 1.0, and whether they have reached that.
    signal so_far_{{ channel.c }}   : unsigned({{ f - 1 }} downto 0) := to_unsigned({{ sequencer.sums.half_code() }}, {{ f }});
    signal was_full_{{ channel.c }} : std_logic := '0';
    signal sum_{{ channel.c }}      : unsigned({{ f + 1 }} downto 0) := (others => '0');
    signal is_full_{{ channel.c }}  : std_logic := '0';
    signal total_{{ channel.c }}    : unsigned({{ f - 1 }} downto 0) := (others => '0');
    signal full_{{ channel.c }}     : std_logic := '0';
{%- if let Some(ambient) = sequencer.sums.ambient %}
    signal ambient_{{ channel.c }}  : unsigned({{ ambient - 1 }} downto 0) := (others => '0');
    signal lit_{{ channel.c }}      : unsigned({{ f }} downto 0) := (others => '0');
{%- endif %}
    signal code_{{ channel.c }}     : unsigned({{ bits - 1 }} downto 0) := (others => '0');
{%- endfor %}
{%- if sequencer.sums.ambient.is_some() %}
    -- Whether the next lights out of the core are the first of their sample.
    signal begins : std_logic := '1';
{%- endif %}

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
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid({{ sequencer.latency - 1 }} downto 1) & (in_valid and in_last);
            end if;
        end if;
    end process;

    -- ===== Stage {{ sequencer.core_latency + 1 }}: half a code and a sample's lights below 1.0, and whether they have reached that
{%- for channel in channels %}
    sum_{{ channel.c }}     <= resize(so_far_{{ channel.c }}, {{ f + 2 }}) + unsigned(out_sum_{{ channel.c }});
    is_full_{{ channel.c }} <= was_full_{{ channel.c }} or sum_{{ channel.c }}({{ f + 1 }}) or sum_{{ channel.c }}({{ f }});
{%- endfor %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' or (ce = '1' and valid({{ sequencer.core_latency }}) = '1') then
{%- for channel in channels %}
                so_far_{{ channel.c }}   <= to_unsigned({{ sequencer.sums.half_code() }}, {{ f }});
                was_full_{{ channel.c }} <= '0';
{%- endfor %}
            elsif ce = '1' and sum_valid = '1' then
{%- for channel in channels %}
                so_far_{{ channel.c }}   <= sum_{{ channel.c }}({{ f - 1 }} downto 0);
                was_full_{{ channel.c }} <= is_full_{{ channel.c }};
{%- endfor %}
            end if;
            if ce = '1' and sum_valid = '1' then
{%- for channel in channels %}
                total_{{ channel.c }} <= sum_{{ channel.c }}({{ f - 1 }} downto 0);
                full_{{ channel.c }}  <= is_full_{{ channel.c }};
{%- endfor %}
            end if;
        end if;
    end process;
{%- if sequencer.sums.ambient.is_some() %}

    -- The ambient light: that of a sample's first clock.
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                begins <= '1';
            elsif ce = '1' and sum_valid = '1' then
                begins <= valid({{ sequencer.core_latency }});
            end if;
            if ce = '1' and sum_valid = '1' and begins = '1' then
{%- for channel in channels %}
                ambient_{{ channel.c }} <= unsigned(out_ambient_{{ channel.c }});
{%- endfor %}
            end if;
        end if;
    end process;
{%- endif %}

    -- ===== Stage {{ sequencer.latency }}: the code{% if sequencer.sums.ambient.is_some() %} with the ambient light{% endif %}, at most full scale
{%- if sequencer.sums.ambient.is_some() %}
{%- for channel in channels %}
    lit_{{ channel.c }} <= ('0' & total_{{ channel.c }}) + ({{ channel.vhdl_ambient }});
{%- endfor %}
{%- endif %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- for channel in channels %}
{%- if sequencer.sums.ambient.is_some() %}
                if full_{{ channel.c }} = '1' or lit_{{ channel.c }}({{ f }}) = '1' then
                    code_{{ channel.c }} <= (others => '1');
                else
                    code_{{ channel.c }} <= lit_{{ channel.c }}({{ f - 1 }} downto {{ f - bits }});
                end if;
{%- else %}
                if full_{{ channel.c }} = '1' then
                    code_{{ channel.c }} <= (others => '1');
                else
                    code_{{ channel.c }} <= total_{{ channel.c }}({{ f - 1 }} downto {{ f - bits }});
                end if;
{%- endif %}
{%- endfor %}
            end if;
        end if;
    end process;

    out_valid <= valid({{ sequencer.latency }});
{%- for channel in channels %}
    out_{{ channel.c }}     <= {{ channel.vhdl_code }};
{%- endfor %}

end architecture rtl;
