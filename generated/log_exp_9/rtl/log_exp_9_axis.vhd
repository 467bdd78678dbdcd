-- log_exp_9_axis: AXI4-Stream interfaces for the core log_exp_9
--
-- Made by: brdfgen generate core.toml
-- Spec 608aa1feabb28d90. Generated; the wrapper is yours to use under any terms.
--
-- s_axis_tdata, 3 bytes:
--   [7:0]  in_n   UQ8.0 shininess, 1 to 255; outside: the nearest end
--   [23:8] in_cos Q1.14 cosine x; below 0 gives 0, above 1 counts as 1
--
-- m_axis_tdata, 2 bytes:
--   [14:0] out_spec UQ1.14 the lobe, 0 to 1; 1.0 is exact
--   [15]   0
--
-- tlast and tuser stay with their beat. tkeep and tstrb are not needed: a beat is always whole.
-- Latency 12 clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and
-- m_axis_tready leads to registers only.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity log_exp_9_axis is
    port (
        -- clock; everything happens on its rising edge
        aclk          : in  std_logic;
        -- synchronous reset, active low: every beat under way is dropped
        aresetn       : in  std_logic;
        -- the core's inputs, packed
        s_axis_tdata  : in  std_logic_vector(23 downto 0);
        -- a beat is offered
        s_axis_tvalid : in  std_logic;
        -- the beat is taken; from a register
        s_axis_tready : out std_logic;
        -- goes with the beat
        s_axis_tlast  : in  std_logic;
        -- goes with the beat
        s_axis_tuser  : in  std_logic_vector(0 downto 0);
        -- the core's outputs, packed
        m_axis_tdata  : out std_logic_vector(15 downto 0);
        -- a beat is there; it stays until it is taken
        m_axis_tvalid : out std_logic;
        -- the beat is taken
        m_axis_tready : in  std_logic;
        -- as it came with the beat
        m_axis_tlast  : out std_logic;
        -- as it came with the beat
        m_axis_tuser  : out std_logic_vector(0 downto 0)
    );
end entity log_exp_9_axis;

architecture rtl of log_exp_9_axis is

    -- The enable of the whole pipeline and the source's tready: a register.
    signal ready      : std_logic := '0';
    signal rst        : std_logic := '0';
    signal out_valid  : std_logic := '0';
    signal out_spec   : unsigned(14 downto 0) := (others => '0');

    signal last       : std_logic_vector(12 downto 1) := (others => '0');
    signal user       : std_logic_vector(11 downto 0) := (others => '0');

    signal beat       : std_logic_vector(16 downto 0) := (others => '0');
    signal skid       : std_logic_vector(16 downto 0) := (others => '0');
    signal skid_valid : std_logic := '0';
    signal waits      : std_logic := '0';
    signal shown      : std_logic_vector(16 downto 0) := (others => '0');
    signal valid      : std_logic := '0';

begin

    -- ===== The core
    rst <= not aresetn;

    core : entity work.log_exp_9
        port map (
            clk       => aclk,
            rst       => rst,
            ce        => ready,
            in_valid  => s_axis_tvalid,
            in_n      => unsigned(s_axis_tdata(7 downto 0)),
            in_cos    => signed(s_axis_tdata(23 downto 8)),
            out_valid => out_valid,
            out_spec  => out_spec
        );

    -- ===== tlast and tuser, in step with the core's valid chain
    process (aclk) is
    begin
        if rising_edge(aclk) then
            if ready = '1' then
                last <= last(11 downto 1) & s_axis_tlast;
                user <= user(10 downto 0) & s_axis_tuser;
            end if;
        end if;
    end process;

    -- ===== Skid register
    -- The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    -- whatever the sink does: a beat that the sink leaves waits in the skid register.
    beat <= user(11 downto 11)
            & last(12)
            & std_logic_vector(out_spec);
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
    s_axis_tready <= ready;
    m_axis_tvalid <= valid;
    m_axis_tdata  <= (0 downto 0 => '0') & shown(14 downto 0);
    m_axis_tlast  <= shown(15);
    m_axis_tuser  <= shown(16 downto 16);

end architecture rtl;
