{%- let header = &axis.header %}
{%- let rom_files = &texts.rom_files %}
{%- include "vhdl/header.vhd" %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity {{ axis.name }} is
{%- include "vhdl/generics.vhd" %}
    port (
{%- for (comment, declaration) in ports %}
        -- {{ comment }}
        {{ declaration }}{% if !loop.last %};{% endif %}
{%- endfor %}
    );
end entity {{ axis.name }};

architecture rtl of {{ axis.name }} is

    -- The enable of the whole pipeline{% if !axis.takes_samples() %} and the source's tready{% endif %}: a register.
    signal ready      : std_logic := '0';
{%- if axis.takes_samples() %}
    -- Whether the table takes a sample: it reads the last word of the one before, or none.
    signal in_ready   : std_logic := '0';
{%- endif %}
    signal rst        : std_logic := '0';
    signal out_valid  : std_logic := '0';
{%- for lane in axis.outputs.lanes %}
    signal {{ "{:<10}"|format(lane.port.name) }} : {{ lane.kind(texts) }} := (others => '0');
{%- endfor %}
{% if !axis.sequenced %}
    signal last       : std_logic_vector({{ axis.latency }} downto 1) := (others => '0');
{%- endif %}
    signal user       : std_logic_vector({{ axis.user_bits() - 1 }} downto 0) := (others => '0');

    signal beat       : std_logic_vector({{ axis.beat_bits() - 1 }} downto 0) := (others => '0');
    signal skid       : std_logic_vector({{ axis.beat_bits() - 1 }} downto 0) := (others => '0');
    signal skid_valid : std_logic := '0';
    signal waits      : std_logic := '0';
    signal shown      : std_logic_vector({{ axis.beat_bits() - 1 }} downto 0) := (others => '0');
    signal valid      : std_logic := '0';

begin

    -- ===== The core
    rst <= not aresetn;

    core : entity work.{{ texts.name }}
{%- include "vhdl/generic_map.vhd" %}
        port map (
            {{ axis.padded("clk") }} => aclk,
            {{ axis.padded("rst") }} => rst,
            {{ axis.padded("ce") }} => ready,
            {{ axis.padded("in_valid") }} => s_axis_tvalid,
{%- if axis.takes_samples() %}
            {{ axis.padded("in_ready") }} => in_ready,
{%- endif %}
{%- if axis.sequenced %}
            {{ axis.padded("in_last") }} => s_axis_tlast,
{%- endif %}
{%- for lane in axis.inputs.lanes %}
            {{ axis.padded(lane.port.name) }} => {{ lane.of_bits("s_axis_tdata", texts) }},
{%- endfor %}
{%- for port in axis.memories %}
            {{ axis.padded(port.name) }} => {{ port.name }},
{%- endfor %}
            {{ axis.padded("out_valid") }} => out_valid,
{%- for lane in axis.outputs.lanes %}
            {{ axis.padded(lane.port.name) }} => {{ lane.port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
        );

    -- ===== {% if !axis.sequenced %}tlast and {% endif %}tuser, in step with the core's valid chain
{%- if axis.takes_samples() %}
    -- In front they are those of the sample whose words are read, and go on with each word.
{%- endif %}
    process (aclk) is
    begin
        if rising_edge(aclk) then
            if ready = '1' then
{%- if axis.latency == 1 %}
                last(1) <= s_axis_tlast;
                user    <= s_axis_tuser;
{%- else %}
{%- if !axis.sequenced %}
{%- if axis.takes_samples() %}
                last({{ axis.latency }} downto 2) <= last({{ axis.latency - 1 }} downto 1);
{%- else %}
                last <= last({{ axis.latency - 1 }} downto 1) & s_axis_tlast;
{%- endif %}
{%- endif %}
{%- if axis.takes_samples() %}
                user({{ axis.user_bits() - 1 }} downto {{ axis.tuser_bits }}) <= user({{ axis.user_low() - 1 }} downto 0);
                if in_ready = '1' then
                    last(1) <= s_axis_tlast;
                    user({{ axis.tuser_bits - 1 }} downto 0) <= s_axis_tuser;
                end if;
{%- else %}
                user <= user({{ axis.user_low() - 1 }} downto 0) & s_axis_tuser;
{%- endif %}
{%- endif %}
            end if;
        end if;
    end process;

    -- ===== Skid register
    -- The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    -- whatever the sink does: a beat that the sink leaves waits in the skid register.
    beat <= user({{ axis.user_bits() - 1 }} downto {{ axis.user_low() }})
            & {% if axis.sequenced %}'1'{% else %}last({{ axis.latency }}){% endif %}
{%- for lane in axis.outputs.lanes.iter().rev() %}
            & std_logic_vector({{ lane.port.name }}){% if loop.last %};{% endif %}
{%- endfor %}
    process (aclk) is
    begin
        if rising_edge(aclk) then
            if ready = '1' then
                skid <= beat;
            end if;
        end if;
    end process;

    valid <= skid_valid or out_valid;
    waits <= valid and not m_axis_tready;
    process (aclk) is
    begin
        if rising_edge(aclk) then
            if aresetn = '0' then
                ready      <= '0';
                skid_valid <= '0';
            else
                ready      <= not waits;
                skid_valid <= waits;
            end if;
        end if;
    end process;

    -- 0 while there is no beat, as in Verilog.
    shown <= skid when skid_valid = '1' else
             beat when out_valid = '1' else
             (others => '0');
{%- if axis.reads_outside() %}
    texels_ce     <= ready;
{%- endif %}
    s_axis_tready <= ready{% if axis.takes_samples() %} and in_ready{% endif %};
    m_axis_tvalid <= valid;
    m_axis_tdata  <= {% if axis.outputs.padding() > 0 %}({{ axis.outputs.padding() - 1 }} downto 0 => '0') & {% endif %}shown({{ axis.outputs.bits - 1 }} downto 0);
    m_axis_tlast  <= shown({{ axis.outputs.bits }});
    m_axis_tuser  <= shown({{ axis.beat_bits() - 1 }} downto {{ axis.outputs.bits + 1 }});

end architecture rtl;
