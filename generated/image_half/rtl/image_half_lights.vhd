-- image_half_lights: the lights of a sample in sequence through the core image_half
--
-- Made by: brdfgen generate core.toml
-- Spec c91e1a366b8521bb. Generated; the sequencer is yours to use under any terms.
--
--   in_last   1 bit   with the lights of this clock the sample ends
--   out_r     UQ8.0   red; 255 is full scale
--   out_g     UQ8.0   green; 255 is full scale
--   out_b     UQ8.0   blue; 255 is full scale
--
-- A sample is any number of clocks' lights, the last with in_last. Latency 29 clocks from
-- there; lights at every clock, and no pause between samples.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity image_half_lights is
    generic (
        -- Path of the memory texels_1_even_even_even, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_EVEN_EVEN_FILE : string := "rom/image_half_texels_1_even_even_even.mem";
        -- Path of the memory texels_1_even_even_odd, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_EVEN_ODD_FILE : string := "rom/image_half_texels_1_even_even_odd.mem";
        -- Path of the memory texels_1_even_odd_even, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_ODD_EVEN_FILE : string := "rom/image_half_texels_1_even_odd_even.mem";
        -- Path of the memory texels_1_even_odd_odd, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_ODD_ODD_FILE : string := "rom/image_half_texels_1_even_odd_odd.mem";
        -- Path of the memory texels_1_odd_even_even, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_EVEN_EVEN_FILE : string := "rom/image_half_texels_1_odd_even_even.mem";
        -- Path of the memory texels_1_odd_even_odd, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_EVEN_ODD_FILE : string := "rom/image_half_texels_1_odd_even_odd.mem";
        -- Path of the memory texels_1_odd_odd_even, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_ODD_EVEN_FILE : string := "rom/image_half_texels_1_odd_odd_even.mem";
        -- Path of the memory texels_1_odd_odd_odd, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_ODD_ODD_FILE : string := "rom/image_half_texels_1_odd_odd_odd.mem"
    );
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: drops all that is under way, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- the other inputs are to be taken
        in_valid  : in  std_logic;
        -- with the lights of this clock the sample ends
        in_last   : in  std_logic;
        -- Q1.16: x of the unit normal, the viewer at +z
        in_nx     : in  signed(17 downto 0);
        -- Q1.16: y of the unit normal, the viewer at +z
        in_ny     : in  signed(17 downto 0);
        -- Q1.16: z of the unit normal, the viewer at +z
        in_nz     : in  signed(17 downto 0);
        -- Q1.16: x of the unit vector to light 1
        in_l1x    : in  signed(17 downto 0);
        -- Q1.16: y of the unit vector to light 1
        in_l1y    : in  signed(17 downto 0);
        -- Q1.16: z of the unit vector to light 1
        in_l1z    : in  signed(17 downto 0);
        -- Q1.16: x of row 1 of the turn to light 1's half vector
        in_u1x    : in  signed(17 downto 0);
        -- Q1.16: y of row 1 of the turn to light 1's half vector
        in_u1y    : in  signed(17 downto 0);
        -- Q1.16: z of row 1 of the turn to light 1's half vector
        in_u1z    : in  signed(17 downto 0);
        -- Q1.16: x of row 2 of the turn to light 1's half vector
        in_v1x    : in  signed(17 downto 0);
        -- Q1.16: y of row 2 of the turn to light 1's half vector
        in_v1y    : in  signed(17 downto 0);
        -- UQ4.0: slice of texels below light 1's angle
        in_band1  : in  unsigned(3 downto 0);
        -- UQ1.5: weight of the odd one of this slice and the next, at most 1
        in_blend1 : in  unsigned(5 downto 0);
        -- UQ4.0: exponent of light 1's gain
        in_shift1 : in  unsigned(3 downto 0);
        -- UQ1.17: red of light 1's gain
        in_gain1r : in  unsigned(17 downto 0);
        -- UQ1.17: green of light 1's gain
        in_gain1g : in  unsigned(17 downto 0);
        -- UQ1.17: blue of light 1's gain
        in_gain1b : in  unsigned(17 downto 0);
        -- the other outputs are a sample: 29 enabled clocks behind its in_last
        out_valid : out std_logic;
        -- UQ8.0: red; 255 is full scale
        out_r     : out unsigned(7 downto 0);
        -- UQ8.0: green; 255 is full scale
        out_g     : out unsigned(7 downto 0);
        -- UQ8.0: blue; 255 is full scale
        out_b     : out unsigned(7 downto 0)
    );
end entity image_half_lights;

architecture rtl of image_half_lights is

    -- Valid chain of whole samples: a bit where one's last lights are, in step with the core.
    signal valid     : std_logic_vector(29 downto 1) := (others => '0');
    signal sum_valid : std_logic := '0';
    signal out_sum_r : unsigned(17 downto 0) := (others => '0');
    signal out_sum_g : unsigned(17 downto 0) := (others => '0');
    signal out_sum_b : unsigned(17 downto 0) := (others => '0');
    -- Half a code and the lights of a sample so far, below 1.0, and whether they have reached that.
    signal so_far_r   : unsigned(16 downto 0) := to_unsigned(256, 17);
    signal was_full_r : std_logic := '0';
    signal sum_r      : unsigned(18 downto 0) := (others => '0');
    signal is_full_r  : std_logic := '0';
    signal total_r    : unsigned(16 downto 0) := (others => '0');
    signal full_r     : std_logic := '0';
    signal code_r     : unsigned(7 downto 0) := (others => '0');
    -- Half a code and the lights of a sample so far, below 1.0, and whether they have reached that.
    signal so_far_g   : unsigned(16 downto 0) := to_unsigned(256, 17);
    signal was_full_g : std_logic := '0';
    signal sum_g      : unsigned(18 downto 0) := (others => '0');
    signal is_full_g  : std_logic := '0';
    signal total_g    : unsigned(16 downto 0) := (others => '0');
    signal full_g     : std_logic := '0';
    signal code_g     : unsigned(7 downto 0) := (others => '0');
    -- Half a code and the lights of a sample so far, below 1.0, and whether they have reached that.
    signal so_far_b   : unsigned(16 downto 0) := to_unsigned(256, 17);
    signal was_full_b : std_logic := '0';
    signal sum_b      : unsigned(18 downto 0) := (others => '0');
    signal is_full_b  : std_logic := '0';
    signal total_b    : unsigned(16 downto 0) := (others => '0');
    signal full_b     : std_logic := '0';
    signal code_b     : unsigned(7 downto 0) := (others => '0');

begin

    -- ===== The core: what the lights of a clock give
    core : entity work.image_half
        generic map (
            TEXELS_1_EVEN_EVEN_EVEN_FILE => TEXELS_1_EVEN_EVEN_EVEN_FILE,
            TEXELS_1_EVEN_EVEN_ODD_FILE => TEXELS_1_EVEN_EVEN_ODD_FILE,
            TEXELS_1_EVEN_ODD_EVEN_FILE => TEXELS_1_EVEN_ODD_EVEN_FILE,
            TEXELS_1_EVEN_ODD_ODD_FILE => TEXELS_1_EVEN_ODD_ODD_FILE,
            TEXELS_1_ODD_EVEN_EVEN_FILE => TEXELS_1_ODD_EVEN_EVEN_FILE,
            TEXELS_1_ODD_EVEN_ODD_FILE => TEXELS_1_ODD_EVEN_ODD_FILE,
            TEXELS_1_ODD_ODD_EVEN_FILE => TEXELS_1_ODD_ODD_EVEN_FILE,
            TEXELS_1_ODD_ODD_ODD_FILE => TEXELS_1_ODD_ODD_ODD_FILE
        )
        port map (
            clk       => clk,
            rst       => rst,
            ce        => ce,
            in_valid  => in_valid,
            in_nx     => in_nx,
            in_ny     => in_ny,
            in_nz     => in_nz,
            in_l1x    => in_l1x,
            in_l1y    => in_l1y,
            in_l1z    => in_l1z,
            in_u1x    => in_u1x,
            in_u1y    => in_u1y,
            in_u1z    => in_u1z,
            in_v1x    => in_v1x,
            in_v1y    => in_v1y,
            in_band1  => in_band1,
            in_blend1 => in_blend1,
            in_shift1 => in_shift1,
            in_gain1r => in_gain1r,
            in_gain1g => in_gain1g,
            in_gain1b => in_gain1b,
            out_valid => sum_valid,
            out_sum_r => out_sum_r,
            out_sum_g => out_sum_g,
            out_sum_b => out_sum_b
        );

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(28 downto 1) & (in_valid and in_last);
            end if;
        end if;
    end process;

    -- ===== Stage 28: half a code and a sample's lights below 1.0, and whether they have reached that
    sum_r     <= resize(so_far_r, 19) + unsigned(out_sum_r);
    is_full_r <= was_full_r or sum_r(18) or sum_r(17);
    sum_g     <= resize(so_far_g, 19) + unsigned(out_sum_g);
    is_full_g <= was_full_g or sum_g(18) or sum_g(17);
    sum_b     <= resize(so_far_b, 19) + unsigned(out_sum_b);
    is_full_b <= was_full_b or sum_b(18) or sum_b(17);
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' or (ce = '1' and valid(27) = '1') then
                so_far_r   <= to_unsigned(256, 17);
                was_full_r <= '0';
                so_far_g   <= to_unsigned(256, 17);
                was_full_g <= '0';
                so_far_b   <= to_unsigned(256, 17);
                was_full_b <= '0';
            elsif ce = '1' and sum_valid = '1' then
                so_far_r   <= sum_r(16 downto 0);
                was_full_r <= is_full_r;
                so_far_g   <= sum_g(16 downto 0);
                was_full_g <= is_full_g;
                so_far_b   <= sum_b(16 downto 0);
                was_full_b <= is_full_b;
            end if;
            if ce = '1' and sum_valid = '1' then
                total_r <= sum_r(16 downto 0);
                full_r  <= is_full_r;
                total_g <= sum_g(16 downto 0);
                full_g  <= is_full_g;
                total_b <= sum_b(16 downto 0);
                full_b  <= is_full_b;
            end if;
        end if;
    end process;

    -- ===== Stage 29: the code, at most full scale
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                if full_r = '1' then
                    code_r <= (others => '1');
                else
                    code_r <= total_r(16 downto 9);
                end if;
                if full_g = '1' then
                    code_g <= (others => '1');
                else
                    code_g <= total_g(16 downto 9);
                end if;
                if full_b = '1' then
                    code_b <= (others => '1');
                else
                    code_b <= total_b(16 downto 9);
                end if;
            end if;
        end if;
    end process;

    out_valid <= valid(29);
    out_r     <= code_r;
    out_g     <= code_g;
    out_b     <= code_b;

end architecture rtl;
