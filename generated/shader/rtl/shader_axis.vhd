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

entity shader_axis is
    port (
        -- clock; everything happens on its rising edge
        aclk          : in  std_logic;
        -- synchronous reset, active low: every beat under way is dropped
        aresetn       : in  std_logic;
        -- the core's inputs, packed
        s_axis_tdata  : in  std_logic_vector(223 downto 0);
        -- a beat is offered
        s_axis_tvalid : in  std_logic;
        -- the beat is taken; from a register
        s_axis_tready : out std_logic;
        -- goes with the beat
        s_axis_tlast  : in  std_logic;
        -- goes with the beat
        s_axis_tuser  : in  std_logic_vector(7 downto 0);
        -- the core's outputs, packed
        m_axis_tdata  : out std_logic_vector(23 downto 0);
        -- a beat is there; it stays until it is taken
        m_axis_tvalid : out std_logic;
        -- the beat is taken
        m_axis_tready : in  std_logic;
        -- as it came with the beat
        m_axis_tlast  : out std_logic;
        -- as it came with the beat
        m_axis_tuser  : out std_logic_vector(7 downto 0)
    );
end entity shader_axis;

architecture rtl of shader_axis is

    -- The enable of the whole pipeline and the source's tready: a register.
    signal ready      : std_logic := '0';
    signal rst        : std_logic := '0';
    signal out_valid  : std_logic := '0';
    signal out_r      : unsigned(7 downto 0) := (others => '0');
    signal out_g      : unsigned(7 downto 0) := (others => '0');
    signal out_b      : unsigned(7 downto 0) := (others => '0');

    signal last       : std_logic_vector(16 downto 1) := (others => '0');
    signal user       : std_logic_vector(127 downto 0) := (others => '0');

    signal beat       : std_logic_vector(32 downto 0) := (others => '0');
    signal skid       : std_logic_vector(32 downto 0) := (others => '0');
    signal skid_valid : std_logic := '0';
    signal waits      : std_logic := '0';
    signal shown      : std_logic_vector(32 downto 0) := (others => '0');
    signal valid      : std_logic := '0';

begin

    -- ===== The core
    rst <= not aresetn;

    core : entity work.shader
        port map (
            clk         => aclk,
            rst         => rst,
            ce          => ready,
            in_valid    => s_axis_tvalid,
            in_material => unsigned(s_axis_tdata(1 downto 0)),
            in_nx       => signed(s_axis_tdata(19 downto 2)),
            in_ny       => signed(s_axis_tdata(37 downto 20)),
            in_nz       => signed(s_axis_tdata(55 downto 38)),
            in_vx       => signed(s_axis_tdata(73 downto 56)),
            in_vy       => signed(s_axis_tdata(91 downto 74)),
            in_vz       => signed(s_axis_tdata(109 downto 92)),
            in_l1x      => signed(s_axis_tdata(127 downto 110)),
            in_l1y      => signed(s_axis_tdata(145 downto 128)),
            in_l1z      => signed(s_axis_tdata(163 downto 146)),
            in_l2x      => signed(s_axis_tdata(181 downto 164)),
            in_l2y      => signed(s_axis_tdata(199 downto 182)),
            in_l2z      => signed(s_axis_tdata(217 downto 200)),
            out_valid   => out_valid,
            out_r       => out_r,
            out_g       => out_g,
            out_b       => out_b
        );

    -- ===== tlast and tuser, in step with the core's valid chain
    process (aclk) is
    begin
        if rising_edge(aclk) then
            if ready = '1' then
                last <= last(15 downto 1) & s_axis_tlast;
                user <= user(119 downto 0) & s_axis_tuser;
            end if;
        end if;
    end process;

    -- ===== Skid register
    -- The beat at the end of the pipeline. While ready is 1 the pipeline moves on at every clock,
    -- whatever the sink does: a beat that the sink leaves waits in the skid register.
    beat <= user(127 downto 120)
            & last(16)
            & std_logic_vector(out_b)
            & std_logic_vector(out_g)
            & std_logic_vector(out_r);
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
    m_axis_tdata  <= shown(23 downto 0);
    m_axis_tlast  <= shown(24);
    m_axis_tuser  <= shown(32 downto 25);

end architecture rtl;
