-- image_bivariate: image-based block of ggx (bivariate, 32 x 32 texels), 1 light a clock, 8 bits a channel
--
-- Made by: brdfgen generate --block image --reflectance ggx --image-form bivariate --weight-bits 4
-- Spec d17cc6a203587951. Generated; the core is yours to use under any terms.
--
--   in_nx     Q1.16   x of the unit normal, the viewer at +z
--   in_ny     Q1.16   y of the unit normal, the viewer at +z
--   in_nz     Q1.16   z of the unit normal, the viewer at +z
--   in_l1x    Q1.16   x of the unit vector to light 1
--   in_l1y    Q1.16   y of the unit vector to light 1
--   in_l1z    Q1.16   z of the unit vector to light 1
--   in_h1x    Q1.16   x of light 1's half vector
--   in_h1y    Q1.16   y of light 1's half vector
--   in_h1z    Q1.16   z of light 1's half vector
--   in_band1  UQ5.0   row of texels below light 1's angle
--   in_blend1 UQ1.4   weight of the odd one of this row and the next, at most 1
--   in_shift1 UQ4.0   exponent of light 1's gain
--   in_gain1r UQ1.17  red of light 1's gain
--   in_gain1g UQ1.17  green of light 1's gain
--   in_gain1b UQ1.17  blue of light 1's gain
--   out_sum_r UQ1.17  red of these lights, at most 1.0
--   out_sum_g UQ1.17  green of these lights, at most 1.0
--   out_sum_b UQ1.17  blue of these lights, at most 1.0
--
-- Latency 27 clocks, one result a clock.
-- Pictures of a sphere against the exact reflectance, lit from 34 angles:
--   44.3 dB in the mean, 34.9 dB at the worst angle.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity image_bivariate is
    generic (
        -- Path of the memory texels_1_even_even, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_EVEN_FILE : string := "rom/image_bivariate_texels_1_even_even.mem";
        -- Path of the memory texels_1_even_odd, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_ODD_FILE : string := "rom/image_bivariate_texels_1_even_odd.mem";
        -- Path of the memory texels_1_odd_even, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_EVEN_FILE : string := "rom/image_bivariate_texels_1_odd_even.mem";
        -- Path of the memory texels_1_odd_odd, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_ODD_FILE : string := "rom/image_bivariate_texels_1_odd_odd.mem"
    );
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- the other inputs are to be taken
        in_valid  : in  std_logic;
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
        -- Q1.16: x of light 1's half vector
        in_h1x    : in  signed(17 downto 0);
        -- Q1.16: y of light 1's half vector
        in_h1y    : in  signed(17 downto 0);
        -- Q1.16: z of light 1's half vector
        in_h1z    : in  signed(17 downto 0);
        -- UQ5.0: row of texels below light 1's angle
        in_band1  : in  unsigned(4 downto 0);
        -- UQ1.4: weight of the odd one of this row and the next, at most 1
        in_blend1 : in  unsigned(4 downto 0);
        -- UQ4.0: exponent of light 1's gain
        in_shift1 : in  unsigned(3 downto 0);
        -- UQ1.17: red of light 1's gain
        in_gain1r : in  unsigned(17 downto 0);
        -- UQ1.17: green of light 1's gain
        in_gain1g : in  unsigned(17 downto 0);
        -- UQ1.17: blue of light 1's gain
        in_gain1b : in  unsigned(17 downto 0);
        -- the other outputs are a result: in_valid, 27 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.17: red of these lights, at most 1.0
        out_sum_r : out unsigned(17 downto 0);
        -- UQ1.17: green of these lights, at most 1.0
        out_sum_g : out unsigned(17 downto 0);
        -- UQ1.17: blue of these lights, at most 1.0
        out_sum_b : out unsigned(17 downto 0)
    );
end entity image_bivariate;

architecture rtl of image_bivariate is
    -- ===== The memory texels_1_even_even
    type texels_1_even_even_t is array (255 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_even(path : string) return texels_1_even_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 256 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 256 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_EVEN : texels_1_even_even_t := read_texels_1_even_even(TEXELS_1_EVEN_EVEN_FILE);
    signal texels_1_even_even_13 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_odd
    type texels_1_even_odd_t is array (255 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_odd(path : string) return texels_1_even_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 256 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 256 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_ODD : texels_1_even_odd_t := read_texels_1_even_odd(TEXELS_1_EVEN_ODD_FILE);
    signal texels_1_even_odd_13 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_even
    type texels_1_odd_even_t is array (255 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_even(path : string) return texels_1_odd_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 256 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 256 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_EVEN : texels_1_odd_even_t := read_texels_1_odd_even(TEXELS_1_ODD_EVEN_FILE);
    signal texels_1_odd_even_13 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_odd
    type texels_1_odd_odd_t is array (255 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_odd(path : string) return texels_1_odd_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 256 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 256 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_ODD : texels_1_odd_odd_t := read_texels_1_odd_odd(TEXELS_1_ODD_ODD_FILE);
    signal texels_1_odd_odd_13 : std_logic_vector(23 downto 0) := (others => '0');

    signal valid : std_logic_vector(27 downto 1) := (others => '0');
    signal nz_kept_0 : unsigned(16 downto 0) := (others => '0');
    signal seen_0 : std_logic := '0';
    signal hidden_0 : std_logic := '0';
    signal shift1_0 : unsigned(3 downto 0) := (others => '0');
    signal nl1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_x_0 : signed(25 downto 0) := (others => '0');
    signal nl1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_y_0 : signed(25 downto 0) := (others => '0');
    signal nl1_z_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_z_0 : signed(25 downto 0) := (others => '0');
    signal nl1_by_1_0 : unsigned(0 downto 0) := (others => '0');
    signal nl1_by_2_0 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_2_0 : unsigned(1 downto 0) := (others => '0');
    signal nl1_by_4_0 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_4_0 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_0 : std_logic := '0';
    signal blend1_0 : unsigned(4 downto 0) := (others => '0');
    signal band1_next_exact_0 : unsigned(5 downto 0) := (others => '0');
    signal band1_odd_high_0 : unsigned(3 downto 0) := (others => '0');
    signal band1_odd_0 : unsigned(3 downto 0) := (others => '0');
    signal d1_x_exact_0 : signed(18 downto 0) := (others => '0');
    signal d1_y_exact_0 : signed(18 downto 0) := (others => '0');
    signal d1_z_exact_0 : signed(18 downto 0) := (others => '0');
    signal texels1_10_0 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_0 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_0 : std_logic := '0';
    signal blend1_bit_0_0 : std_logic := '0';
    signal blend1_bit_1_0 : std_logic := '0';
    signal blend1_bit_2_0 : std_logic := '0';
    signal blend1_bit_3_0 : std_logic := '0';
    signal blend1_of_0_0 : std_logic := '0';
    signal blend1_of_1_0 : std_logic := '0';
    signal blend1_of_2_0 : std_logic := '0';
    signal blend1_of_3_0 : std_logic := '0';
    signal in_gain1r_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_1 : unsigned(17 downto 0) := (others => '0');
    signal hidden_1 : std_logic := '0';
    signal nl1_x_1 : signed(25 downto 0) := (others => '0');
    signal nl1_y_1 : signed(25 downto 0) := (others => '0');
    signal nl1_z_1 : signed(25 downto 0) := (others => '0');
    signal nl1_by_1_1 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_2_1 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_1 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_1 : std_logic := '0';
    signal band1_next_exact_1 : unsigned(5 downto 0) := (others => '0');
    signal d1_x_exact_1 : signed(18 downto 0) := (others => '0');
    signal d1_y_exact_1 : signed(18 downto 0) := (others => '0');
    signal d1_z_exact_1 : signed(18 downto 0) := (others => '0');
    signal texels1_10_1 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_1 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_1 : std_logic := '0';
    signal blend1_of_0_1 : std_logic := '0';
    signal blend1_of_1_1 : std_logic := '0';
    signal blend1_of_2_1 : std_logic := '0';
    signal blend1_of_3_1 : std_logic := '0';
    signal nl1_xy_1 : signed(26 downto 0) := (others => '0');
    signal band1_next_1 : unsigned(4 downto 0) := (others => '0');
    signal band1_even_high_1 : unsigned(3 downto 0) := (others => '0');
    signal band1_even_1 : unsigned(3 downto 0) := (others => '0');
    signal d1_x_1 : signed(17 downto 0) := (others => '0');
    signal d1_y_1 : signed(17 downto 0) := (others => '0');
    signal d1_z_1 : signed(17 downto 0) := (others => '0');
    signal texels1_00_1 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_1 : unsigned(3 downto 0) := (others => '0');
    signal in_gain1r_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_2 : unsigned(17 downto 0) := (others => '0');
    signal hidden_2 : std_logic := '0';
    signal nl1_z_2 : signed(25 downto 0) := (others => '0');
    signal nl1_xy_2 : signed(26 downto 0) := (others => '0');
    signal nl1_by_1_2 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_2_2 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_2 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_2 : std_logic := '0';
    signal d1_x_2 : signed(17 downto 0) := (others => '0');
    signal d1_y_2 : signed(17 downto 0) := (others => '0');
    signal d1_z_2 : signed(17 downto 0) := (others => '0');
    signal texels1_00_2 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_2 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_2 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_2 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_2 : std_logic := '0';
    signal blend1_of_0_2 : std_logic := '0';
    signal blend1_of_1_2 : std_logic := '0';
    signal blend1_of_2_2 : std_logic := '0';
    signal blend1_of_3_2 : std_logic := '0';
    signal nl1_xyz_2 : signed(26 downto 0) := (others => '0');
    signal nl1_cut_2 : signed(24 downto 0) := (others => '0');
    signal dd1_x_exact_2 : signed(35 downto 0) := (others => '0');
    signal dd1_x_2 : signed(19 downto 0) := (others => '0');
    signal dd1_y_exact_2 : signed(35 downto 0) := (others => '0');
    signal dd1_y_2 : signed(19 downto 0) := (others => '0');
    signal dd1_z_exact_2 : signed(35 downto 0) := (others => '0');
    signal dd1_z_2 : signed(19 downto 0) := (others => '0');
    signal in_gain1r_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_3 : unsigned(17 downto 0) := (others => '0');
    signal hidden_3 : std_logic := '0';
    signal nl1_cut_3 : signed(24 downto 0) := (others => '0');
    signal nl1_by_1_3 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_2_3 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_3 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_3 : std_logic := '0';
    signal dd1_x_3 : signed(19 downto 0) := (others => '0');
    signal dd1_y_3 : signed(19 downto 0) := (others => '0');
    signal dd1_z_3 : signed(19 downto 0) := (others => '0');
    signal texels1_00_3 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_3 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_3 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_3 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_3 : std_logic := '0';
    signal blend1_of_0_3 : std_logic := '0';
    signal blend1_of_1_3 : std_logic := '0';
    signal blend1_of_2_3 : std_logic := '0';
    signal blend1_of_3_3 : std_logic := '0';
    signal nl1_kept_3 : unsigned(19 downto 0) := (others => '0');
    signal nl1_up_1_3 : unsigned(20 downto 0) := (others => '0');
    signal nl1_all_3 : unsigned(20 downto 0) := (others => '0');
    signal nl1_all_wide_3 : unsigned(28 downto 0) := (others => '0');
    signal dd1_xy_3 : signed(20 downto 0) := (others => '0');
    signal in_gain1r_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_4 : unsigned(17 downto 0) := (others => '0');
    signal hidden_4 : std_logic := '0';
    signal nl1_up_1_4 : unsigned(20 downto 0) := (others => '0');
    signal nl1_amount_2_4 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_4 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_4 : std_logic := '0';
    signal nl1_all_wide_4 : unsigned(28 downto 0) := (others => '0');
    signal dd1_z_4 : signed(19 downto 0) := (others => '0');
    signal dd1_xy_4 : signed(20 downto 0) := (others => '0');
    signal texels1_00_4 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_4 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_4 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_4 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_4 : std_logic := '0';
    signal blend1_of_0_4 : std_logic := '0';
    signal blend1_of_1_4 : std_logic := '0';
    signal blend1_of_2_4 : std_logic := '0';
    signal blend1_of_3_4 : std_logic := '0';
    signal nl1_up_2_4 : unsigned(22 downto 0) := (others => '0');
    signal dd1_xyz_4 : signed(20 downto 0) := (others => '0');
    signal u1_exact_4 : signed(20 downto 0) := (others => '0');
    signal u1_cut_4 : signed(16 downto 0) := (others => '0');
    signal in_gain1r_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_5 : unsigned(17 downto 0) := (others => '0');
    signal hidden_5 : std_logic := '0';
    signal nl1_up_2_5 : unsigned(22 downto 0) := (others => '0');
    signal nl1_amount_4_5 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_5 : std_logic := '0';
    signal nl1_all_wide_5 : unsigned(28 downto 0) := (others => '0');
    signal u1_cut_5 : signed(16 downto 0) := (others => '0');
    signal texels1_00_5 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_5 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_5 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_5 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_5 : std_logic := '0';
    signal blend1_of_0_5 : std_logic := '0';
    signal blend1_of_1_5 : std_logic := '0';
    signal blend1_of_2_5 : std_logic := '0';
    signal blend1_of_3_5 : std_logic := '0';
    signal nl1_up_4_5 : unsigned(26 downto 0) := (others => '0');
    signal nl1_up_4_wide_5 : unsigned(28 downto 0) := (others => '0');
    signal nl1_up_5 : unsigned(28 downto 0) := (others => '0');
    signal nl1_up_cut_5 : unsigned(19 downto 0) := (others => '0');
    signal nl1_within_5 : unsigned(17 downto 0) := (others => '0');
    signal u1_5 : unsigned(12 downto 0) := (others => '0');
    signal high1_4_bits_5 : unsigned(3 downto 0) := (others => '0');
    signal high1_4_5 : std_logic := '0';
    signal u_low1_4_5 : unsigned(8 downto 0) := (others => '0');
    signal u_up1_4_5 : unsigned(8 downto 0) := (others => '0');
    signal u_up1_4_wide_5 : unsigned(12 downto 0) := (others => '0');
    signal u1_4_5 : unsigned(12 downto 0) := (others => '0');
    signal place1_4_5 : unsigned(0 downto 0) := (others => '0');
    signal high1_2_bits_5 : unsigned(1 downto 0) := (others => '0');
    signal u_low1_2_5 : unsigned(10 downto 0) := (others => '0');
    signal u_up1_2_5 : unsigned(10 downto 0) := (others => '0');
    signal u_up1_2_wide_5 : unsigned(12 downto 0) := (others => '0');
    signal in_gain1r_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_6 : unsigned(17 downto 0) := (others => '0');
    signal hidden_6 : std_logic := '0';
    signal nl1_within_6 : unsigned(17 downto 0) := (others => '0');
    signal high1_4_6 : std_logic := '0';
    signal u1_4_6 : unsigned(12 downto 0) := (others => '0');
    signal place1_4_6 : unsigned(0 downto 0) := (others => '0');
    signal high1_2_bits_6 : unsigned(1 downto 0) := (others => '0');
    signal u_up1_2_wide_6 : unsigned(12 downto 0) := (others => '0');
    signal texels1_00_6 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_6 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_6 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_6 : unsigned(3 downto 0) := (others => '0');
    signal blend1_whole_6 : std_logic := '0';
    signal blend1_of_0_6 : std_logic := '0';
    signal blend1_of_1_6 : std_logic := '0';
    signal blend1_of_2_6 : std_logic := '0';
    signal blend1_of_3_6 : std_logic := '0';
    signal nl1_6 : unsigned(17 downto 0) := (others => '0');
    signal high1_2_6 : std_logic := '0';
    signal u1_2_6 : unsigned(12 downto 0) := (others => '0');
    signal place1_2_6 : unsigned(0 downto 0) := (others => '0');
    signal exponent1_2_6 : unsigned(1 downto 0) := (others => '0');
    signal high1_1_bits_6 : std_logic := '0';
    signal u_low1_1_6 : unsigned(11 downto 0) := (others => '0');
    signal u_up1_1_6 : unsigned(11 downto 0) := (others => '0');
    signal u_up1_1_wide_6 : unsigned(12 downto 0) := (others => '0');
    signal u1_1_6 : unsigned(12 downto 0) := (others => '0');
    signal place1_1_6 : unsigned(0 downto 0) := (others => '0');
    signal normal1_of_2_6 : std_logic := '0';
    signal normal1_6 : std_logic := '0';
    signal u1_twice_6 : unsigned(12 downto 0) := (others => '0');
    signal u1_rest_6 : unsigned(11 downto 0) := (others => '0');
    signal u1_rest_wide_6 : unsigned(12 downto 0) := (others => '0');
    signal rest1_6 : unsigned(12 downto 0) := (others => '0');
    signal rest1_cut_6 : unsigned(5 downto 0) := (others => '0');
    signal step1_6 : unsigned(1 downto 0) := (others => '0');
    signal step1_number_6 : unsigned(1 downto 0) := (others => '0');
    signal part1_6 : unsigned(3 downto 0) := (others => '0');
    signal weight1_6 : unsigned(3 downto 0) := (others => '0');
    signal weight1_bit_0_6 : unsigned(0 downto 0) := (others => '0');
    signal weight1_bit_1_6 : unsigned(0 downto 0) := (others => '0');
    signal weight1_bit_2_6 : unsigned(0 downto 0) := (others => '0');
    signal weight1_bit_3_6 : unsigned(0 downto 0) := (others => '0');
    signal weight1_of_0_flag_6 : std_logic := '0';
    signal weight1_of_0_not_6 : std_logic := '0';
    signal weight1_of_1_flag_6 : std_logic := '0';
    signal weight1_of_1_not_6 : std_logic := '0';
    signal weight1_of_2_flag_6 : std_logic := '0';
    signal weight1_of_2_not_6 : std_logic := '0';
    signal weight1_of_3_flag_6 : std_logic := '0';
    signal weight1_of_3_not_6 : std_logic := '0';
    signal in_gain1r_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_7 : unsigned(17 downto 0) := (others => '0');
    signal nl1_7 : unsigned(17 downto 0) := (others => '0');
    signal exponent1_2_7 : unsigned(1 downto 0) := (others => '0');
    signal place1_1_7 : unsigned(0 downto 0) := (others => '0');
    signal step1_number_7 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_7 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_7 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_7 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_7 : unsigned(3 downto 0) := (others => '0');
    signal weight1_of_0_flag_7 : std_logic := '0';
    signal weight1_of_0_not_7 : std_logic := '0';
    signal weight1_of_1_flag_7 : std_logic := '0';
    signal weight1_of_1_not_7 : std_logic := '0';
    signal weight1_of_2_flag_7 : std_logic := '0';
    signal weight1_of_2_not_7 : std_logic := '0';
    signal weight1_of_3_flag_7 : std_logic := '0';
    signal weight1_of_3_not_7 : std_logic := '0';
    signal blend1_whole_7 : std_logic := '0';
    signal blend1_of_0_7 : std_logic := '0';
    signal blend1_of_1_7 : std_logic := '0';
    signal blend1_of_2_7 : std_logic := '0';
    signal blend1_of_3_7 : std_logic := '0';
    signal exponent1_1_7 : unsigned(2 downto 0) := (others => '0');
    signal octave1_7 : unsigned(2 downto 0) := (others => '0');
    signal in_gain1r_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_8 : unsigned(17 downto 0) := (others => '0');
    signal nl1_8 : unsigned(17 downto 0) := (others => '0');
    signal step1_number_8 : unsigned(1 downto 0) := (others => '0');
    signal octave1_8 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_8 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_8 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_8 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_8 : unsigned(3 downto 0) := (others => '0');
    signal weight1_of_0_flag_8 : std_logic := '0';
    signal weight1_of_0_not_8 : std_logic := '0';
    signal weight1_of_1_flag_8 : std_logic := '0';
    signal weight1_of_1_not_8 : std_logic := '0';
    signal weight1_of_2_flag_8 : std_logic := '0';
    signal weight1_of_2_not_8 : std_logic := '0';
    signal weight1_of_3_flag_8 : std_logic := '0';
    signal weight1_of_3_not_8 : std_logic := '0';
    signal blend1_whole_8 : std_logic := '0';
    signal blend1_of_0_8 : std_logic := '0';
    signal blend1_of_1_8 : std_logic := '0';
    signal blend1_of_2_8 : std_logic := '0';
    signal blend1_of_3_8 : std_logic := '0';
    signal column1_8 : unsigned(4 downto 0) := (others => '0');
    signal column1_odd_high_8 : unsigned(3 downto 0) := (others => '0');
    signal column1_odd_8 : unsigned(3 downto 0) := (others => '0');
    signal column1_is_odd_8 : std_logic := '0';
    signal weight1_of_0_8 : std_logic := '0';
    signal weight1_of_1_8 : std_logic := '0';
    signal weight1_of_2_8 : std_logic := '0';
    signal weight1_of_3_8 : std_logic := '0';
    signal in_gain1r_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_9 : unsigned(17 downto 0) := (others => '0');
    signal nl1_9 : unsigned(17 downto 0) := (others => '0');
    signal column1_9 : unsigned(4 downto 0) := (others => '0');
    signal column1_odd_9 : unsigned(3 downto 0) := (others => '0');
    signal column1_is_odd_9 : std_logic := '0';
    signal texels1_00_9 : unsigned(3 downto 0) := (others => '0');
    signal texels1_01_9 : unsigned(3 downto 0) := (others => '0');
    signal texels1_10_9 : unsigned(3 downto 0) := (others => '0');
    signal texels1_11_9 : unsigned(3 downto 0) := (others => '0');
    signal weight1_of_0_9 : std_logic := '0';
    signal weight1_of_1_9 : std_logic := '0';
    signal weight1_of_2_9 : std_logic := '0';
    signal weight1_of_3_9 : std_logic := '0';
    signal blend1_whole_9 : std_logic := '0';
    signal blend1_of_0_9 : std_logic := '0';
    signal blend1_of_1_9 : std_logic := '0';
    signal blend1_of_2_9 : std_logic := '0';
    signal blend1_of_3_9 : std_logic := '0';
    signal column1_next_exact_9 : unsigned(5 downto 0) := (others => '0');
    signal texel1_01_9 : unsigned(7 downto 0) := (others => '0');
    signal texel1_11_9 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_10 : unsigned(17 downto 0) := (others => '0');
    signal nl1_10 : unsigned(17 downto 0) := (others => '0');
    signal column1_next_exact_10 : unsigned(5 downto 0) := (others => '0');
    signal column1_is_odd_10 : std_logic := '0';
    signal texels1_00_10 : unsigned(3 downto 0) := (others => '0');
    signal texel1_01_10 : unsigned(7 downto 0) := (others => '0');
    signal texels1_10_10 : unsigned(3 downto 0) := (others => '0');
    signal texel1_11_10 : unsigned(7 downto 0) := (others => '0');
    signal weight1_of_0_10 : std_logic := '0';
    signal weight1_of_1_10 : std_logic := '0';
    signal weight1_of_2_10 : std_logic := '0';
    signal weight1_of_3_10 : std_logic := '0';
    signal blend1_whole_10 : std_logic := '0';
    signal blend1_of_0_10 : std_logic := '0';
    signal blend1_of_1_10 : std_logic := '0';
    signal blend1_of_2_10 : std_logic := '0';
    signal blend1_of_3_10 : std_logic := '0';
    signal column1_next_10 : unsigned(4 downto 0) := (others => '0');
    signal column1_even_high_10 : unsigned(3 downto 0) := (others => '0');
    signal column1_even_10 : unsigned(3 downto 0) := (others => '0');
    signal in_gain1r_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_11 : unsigned(17 downto 0) := (others => '0');
    signal nl1_11 : unsigned(17 downto 0) := (others => '0');
    signal column1_even_11 : unsigned(3 downto 0) := (others => '0');
    signal column1_is_odd_11 : std_logic := '0';
    signal texels1_00_11 : unsigned(3 downto 0) := (others => '0');
    signal texel1_01_11 : unsigned(7 downto 0) := (others => '0');
    signal texels1_10_11 : unsigned(3 downto 0) := (others => '0');
    signal texel1_11_11 : unsigned(7 downto 0) := (others => '0');
    signal weight1_of_0_11 : std_logic := '0';
    signal weight1_of_1_11 : std_logic := '0';
    signal weight1_of_2_11 : std_logic := '0';
    signal weight1_of_3_11 : std_logic := '0';
    signal blend1_whole_11 : std_logic := '0';
    signal blend1_of_0_11 : std_logic := '0';
    signal blend1_of_1_11 : std_logic := '0';
    signal blend1_of_2_11 : std_logic := '0';
    signal blend1_of_3_11 : std_logic := '0';
    signal texel1_00_11 : unsigned(7 downto 0) := (others => '0');
    signal texel1_10_11 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_12 : unsigned(17 downto 0) := (others => '0');
    signal nl1_12 : unsigned(17 downto 0) := (others => '0');
    signal column1_is_odd_12 : std_logic := '0';
    signal texel1_00_12 : unsigned(7 downto 0) := (others => '0');
    signal texel1_01_12 : unsigned(7 downto 0) := (others => '0');
    signal texel1_10_12 : unsigned(7 downto 0) := (others => '0');
    signal texel1_11_12 : unsigned(7 downto 0) := (others => '0');
    signal weight1_of_0_12 : std_logic := '0';
    signal weight1_of_1_12 : std_logic := '0';
    signal weight1_of_2_12 : std_logic := '0';
    signal weight1_of_3_12 : std_logic := '0';
    signal blend1_whole_12 : std_logic := '0';
    signal blend1_of_0_12 : std_logic := '0';
    signal blend1_of_1_12 : std_logic := '0';
    signal blend1_of_2_12 : std_logic := '0';
    signal blend1_of_3_12 : std_logic := '0';
    signal in_gain1r_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_13 : unsigned(17 downto 0) := (others => '0');
    signal nl1_13 : unsigned(17 downto 0) := (others => '0');
    signal column1_is_odd_13 : std_logic := '0';
    signal weight1_of_0_13 : std_logic := '0';
    signal weight1_of_1_13 : std_logic := '0';
    signal weight1_of_2_13 : std_logic := '0';
    signal weight1_of_3_13 : std_logic := '0';
    signal blend1_whole_13 : std_logic := '0';
    signal blend1_of_0_13 : std_logic := '0';
    signal blend1_of_1_13 : std_logic := '0';
    signal blend1_of_2_13 : std_logic := '0';
    signal blend1_of_3_13 : std_logic := '0';
    signal texels_1_even_even_r_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_r_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_r_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_r_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_g_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_g_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_g_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_g_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_b_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_b_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_b_13 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_b_13 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_14 : unsigned(17 downto 0) := (others => '0');
    signal nl1_14 : unsigned(17 downto 0) := (others => '0');
    signal column1_is_odd_14 : std_logic := '0';
    signal texels_1_even_even_r_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_r_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_r_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_r_14 : unsigned(7 downto 0) := (others => '0');
    signal weight1_of_0_14 : std_logic := '0';
    signal weight1_of_1_14 : std_logic := '0';
    signal weight1_of_2_14 : std_logic := '0';
    signal weight1_of_3_14 : std_logic := '0';
    signal blend1_whole_14 : std_logic := '0';
    signal blend1_of_0_14 : std_logic := '0';
    signal blend1_of_1_14 : std_logic := '0';
    signal blend1_of_2_14 : std_logic := '0';
    signal blend1_of_3_14 : std_logic := '0';
    signal texels_1_even_even_g_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_g_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_g_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_g_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_b_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_b_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_b_14 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_b_14 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_15 : unsigned(17 downto 0) := (others => '0');
    signal nl1_15 : unsigned(17 downto 0) := (others => '0');
    signal column1_is_odd_15 : std_logic := '0';
    signal texels_1_even_even_r_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_r_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_r_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_r_15 : unsigned(7 downto 0) := (others => '0');
    signal weight1_of_0_15 : std_logic := '0';
    signal weight1_of_1_15 : std_logic := '0';
    signal weight1_of_2_15 : std_logic := '0';
    signal weight1_of_3_15 : std_logic := '0';
    signal blend1_whole_15 : std_logic := '0';
    signal blend1_of_0_15 : std_logic := '0';
    signal blend1_of_1_15 : std_logic := '0';
    signal blend1_of_2_15 : std_logic := '0';
    signal blend1_of_3_15 : std_logic := '0';
    signal texels_1_even_even_g_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_g_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_g_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_g_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_b_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_b_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_b_15 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_b_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_either_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_first_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_0_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_1_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_2_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_3_15 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_15 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_15 : unsigned(9 downto 0) := (others => '0');
    signal in_gain1r_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_16 : unsigned(17 downto 0) := (others => '0');
    signal nl1_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_1_0_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_whole_16 : std_logic := '0';
    signal blend1_of_0_16 : std_logic := '0';
    signal blend1_of_1_16 : std_logic := '0';
    signal blend1_of_2_16 : std_logic := '0';
    signal blend1_of_3_16 : std_logic := '0';
    signal blend1_g_1_0_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_by_3_16 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_16 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_16 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_16 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_17 : unsigned(17 downto 0) := (others => '0');
    signal nl1_17 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_1_0_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_whole_17 : std_logic := '0';
    signal blend1_of_0_17 : std_logic := '0';
    signal blend1_of_1_17 : std_logic := '0';
    signal blend1_of_2_17 : std_logic := '0';
    signal blend1_of_3_17 : std_logic := '0';
    signal blend1_g_1_0_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_by_3_17 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_17 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_1_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_either_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_either_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_either_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_either_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_either_3_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_1_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_1_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_either_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_either_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_either_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_either_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_either_3_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_1_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_1_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_either_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_first_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_either_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_0_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_either_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_1_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_either_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_2_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_either_3_17 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_17 : unsigned(11 downto 0) := (others => '0');
    signal in_gain1r_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_18 : unsigned(17 downto 0) := (others => '0');
    signal nl1_18 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_by_first_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_0_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_1_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_2_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_first_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_0_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_1_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_2_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_first_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_0_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_1_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_2_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_18 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_0_18 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_1_18 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_0_18 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_1_18 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_0_18 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_1_18 : unsigned(13 downto 0) := (others => '0');
    signal in_gain1r_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_19 : unsigned(17 downto 0) := (others => '0');
    signal nl1_19 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_19 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_0_19 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_1_19 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_19 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_0_19 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_1_19 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_19 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_0_19 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_1_19 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_2_0_19 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_2_0_19 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_2_0_19 : unsigned(14 downto 0) := (others => '0');
    signal in_gain1r_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_20 : unsigned(17 downto 0) := (others => '0');
    signal nl1_20 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_20 : unsigned(11 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_2_0_20 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_20 : unsigned(11 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_2_0_20 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_20 : unsigned(11 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_2_0_20 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_0_20 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_0_20 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_20 : unsigned(15 downto 0) := (others => '0');
    signal in_gain1r_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_21 : unsigned(17 downto 0) := (others => '0');
    signal nl1_21 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_21 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_0_21 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_21 : unsigned(15 downto 0) := (others => '0');
    signal square1_r_exact_21 : unsigned(31 downto 0) := (others => '0');
    signal square1_r_21 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_exact_21 : unsigned(31 downto 0) := (others => '0');
    signal square1_g_21 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_exact_21 : unsigned(31 downto 0) := (others => '0');
    signal square1_b_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_22 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_22 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_22 : unsigned(17 downto 0) := (others => '0');
    signal nl1_22 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_22 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_22 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_22 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_23 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_23 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_23 : unsigned(17 downto 0) := (others => '0');
    signal nl1_23 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_23 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_23 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_23 : unsigned(17 downto 0) := (others => '0');
    signal lit1_r_exact_23 : unsigned(35 downto 0) := (others => '0');
    signal lit1_r_23 : unsigned(17 downto 0) := (others => '0');
    signal lit1_g_exact_23 : unsigned(35 downto 0) := (others => '0');
    signal lit1_g_23 : unsigned(17 downto 0) := (others => '0');
    signal lit1_b_exact_23 : unsigned(35 downto 0) := (others => '0');
    signal lit1_b_23 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_24 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_24 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_24 : unsigned(17 downto 0) := (others => '0');
    signal lit1_r_24 : unsigned(17 downto 0) := (others => '0');
    signal lit1_g_24 : unsigned(17 downto 0) := (others => '0');
    signal lit1_b_24 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_25 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_25 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_25 : unsigned(17 downto 0) := (others => '0');
    signal lit1_r_25 : unsigned(17 downto 0) := (others => '0');
    signal lit1_g_25 : unsigned(17 downto 0) := (others => '0');
    signal lit1_b_25 : unsigned(17 downto 0) := (others => '0');
    signal light1_r_exact_25 : unsigned(35 downto 0) := (others => '0');
    signal light1_r_25 : unsigned(24 downto 0) := (others => '0');
    signal light1_g_exact_25 : unsigned(35 downto 0) := (others => '0');
    signal light1_g_25 : unsigned(24 downto 0) := (others => '0');
    signal light1_b_exact_25 : unsigned(35 downto 0) := (others => '0');
    signal light1_b_25 : unsigned(24 downto 0) := (others => '0');
    signal light1_r_26 : unsigned(24 downto 0) := (others => '0');
    signal light1_g_26 : unsigned(24 downto 0) := (others => '0');
    signal light1_b_26 : unsigned(24 downto 0) := (others => '0');
    signal sum_r_26 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_26 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_26 : unsigned(17 downto 0) := (others => '0');
    signal sum_r_27 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_27 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_27 : unsigned(17 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(26 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 5 more
    -- UQ1.16: n.v, not below 0
    nz_kept_0 <= (others => '0') when in_nz(17) = '1' else
        unsigned(in_nz(16 downto 0));
    -- UQ1.0: n.v > 0
    seen_0 <= '1' when nz_kept_0 /= 0 else '0';
    -- UQ1.0: the normal is turned away from the viewer
    hidden_0 <= not seen_0;
    -- UQ4.0: at most the greatest
    shift1_0 <= to_unsigned(9, 4) when in_shift1 > 9 else
        in_shift1;
    -- Q3.32: n.l
    nl1_x_exact_0 <= in_nx * in_l1x;
    -- Q3.22: rounded down
    nl1_x_0 <= nl1_x_exact_0(35 downto 10);
    -- Q3.32: n.l
    nl1_y_exact_0 <= in_ny * in_l1y;
    -- Q3.22: rounded down
    nl1_y_0 <= nl1_y_exact_0(35 downto 10);
    -- Q3.32: n.l
    nl1_z_exact_0 <= in_nz * in_l1z;
    -- Q3.22: rounded down
    nl1_z_0 <= nl1_z_exact_0(35 downto 10);
    -- UQ1.0: a bit of the shift
    nl1_by_1_0 <= shift1_0(0 downto 0);
    -- UQ2.-1: a bit of the shift
    nl1_by_2_0 <= shift1_0(1 downto 1);
    -- UQ2.0: its weight
    nl1_amount_2_0 <= shift_left(resize(nl1_by_2_0, 2), 1);
    -- UQ3.-2: a bit of the shift
    nl1_by_4_0 <= shift1_0(2 downto 2);
    -- UQ3.0: its weight
    nl1_amount_4_0 <= shift_left(resize(nl1_by_4_0, 3), 2);
    -- UQ4.-3: a bit of the shift
    nl1_by_8_0 <= shift1_0(3);
    -- UQ1.4: the weight of the odd band, at most 1
    blend1_0 <= (4 => '1', others => '0') when in_blend1(4) = '1' else
        in_blend1;
    -- UQ6.0: the next
    band1_next_exact_0 <= resize(in_band1, 6) + to_unsigned(1, 6);
    -- UQ5.-1: its leading bits
    band1_odd_high_0 <= in_band1(4 downto 1);
    -- UQ4.0: the odd one of both
    band1_odd_0 <= band1_odd_high_0;
    -- Q2.16: a component of n - h
    d1_x_exact_0 <= resize(in_nx, 19) - resize(in_h1x, 19);
    -- Q2.16: a component of n - h
    d1_y_exact_0 <= resize(in_ny, 19) - resize(in_h1y, 19);
    -- Q2.16: a component of n - h
    d1_z_exact_0 <= resize(in_nz, 19) - resize(in_h1z, 19);
    -- UQ8.-4: the first of them
    texels1_10_0 <= band1_odd_0;
    -- UQ8.-4: the first of them
    texels1_11_0 <= band1_odd_0;
    -- UQ1.0: a bit of the weight
    blend1_whole_0 <= blend1_0(4);
    -- UQ-3.4: a bit of the weight
    blend1_bit_0_0 <= blend1_0(0);
    -- UQ-2.3: a bit of the weight
    blend1_bit_1_0 <= blend1_0(1);
    -- UQ-1.2: a bit of the weight
    blend1_bit_2_0 <= blend1_0(2);
    -- UQ0.1: a bit of the weight
    blend1_bit_3_0 <= blend1_0(3);
    -- UQ1.0: 1 where the weight is 1
    blend1_of_0_0 <= blend1_bit_0_0 or blend1_whole_0;
    -- UQ1.0: 1 where the weight is 1
    blend1_of_1_0 <= blend1_bit_1_0 or blend1_whole_0;
    -- UQ1.0: 1 where the weight is 1
    blend1_of_2_0 <= blend1_bit_2_0 or blend1_whole_0;
    -- UQ1.0: 1 where the weight is 1
    blend1_of_3_0 <= blend1_bit_3_0 or blend1_whole_0;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_1 <= in_gain1r;
                in_gain1g_1 <= in_gain1g;
                in_gain1b_1 <= in_gain1b;
                hidden_1 <= hidden_0;
                nl1_x_1 <= nl1_x_0;
                nl1_y_1 <= nl1_y_0;
                nl1_z_1 <= nl1_z_0;
                nl1_by_1_1 <= nl1_by_1_0;
                nl1_amount_2_1 <= nl1_amount_2_0;
                nl1_amount_4_1 <= nl1_amount_4_0;
                nl1_by_8_1 <= nl1_by_8_0;
                band1_next_exact_1 <= band1_next_exact_0;
                d1_x_exact_1 <= d1_x_exact_0;
                d1_y_exact_1 <= d1_y_exact_0;
                d1_z_exact_1 <= d1_z_exact_0;
                texels1_10_1 <= texels1_10_0;
                texels1_11_1 <= texels1_11_0;
                blend1_whole_1 <= blend1_whole_0;
                blend1_of_0_1 <= blend1_of_0_0;
                blend1_of_1_1 <= blend1_of_1_0;
                blend1_of_2_1 <= blend1_of_2_0;
                blend1_of_3_1 <= blend1_of_3_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: nl1_xy, band1_next, d1_x, d1_y, d1_z
    -- Q4.22: n.l
    nl1_xy_1 <= resize(nl1_x_1, 27) + resize(nl1_y_1, 27);
    -- UQ5.0: at most the last
    band1_next_1 <= to_unsigned(31, 5) when band1_next_exact_1(5) = '1' else
        band1_next_exact_1(4 downto 0);
    -- UQ5.-1: its leading bits
    band1_even_high_1 <= band1_next_1(4 downto 1);
    -- UQ4.0: the even one of both
    band1_even_1 <= band1_even_high_1;
    -- Q1.16: of unit vectors it is below 2
    d1_x_1 <= to_signed(-131072, 18) when d1_x_exact_1(18 downto 17) < -1 else
        to_signed(131071, 18) when d1_x_exact_1(18 downto 17) > 0 else
        d1_x_exact_1(17 downto 0);
    -- Q1.16: of unit vectors it is below 2
    d1_y_1 <= to_signed(-131072, 18) when d1_y_exact_1(18 downto 17) < -1 else
        to_signed(131071, 18) when d1_y_exact_1(18 downto 17) > 0 else
        d1_y_exact_1(17 downto 0);
    -- Q1.16: of unit vectors it is below 2
    d1_z_1 <= to_signed(-131072, 18) when d1_z_exact_1(18 downto 17) < -1 else
        to_signed(131071, 18) when d1_z_exact_1(18 downto 17) > 0 else
        d1_z_exact_1(17 downto 0);
    -- UQ8.-4: the first of them
    texels1_00_1 <= band1_even_1;
    -- UQ8.-4: the first of them
    texels1_01_1 <= band1_even_1;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_2 <= in_gain1r_1;
                in_gain1g_2 <= in_gain1g_1;
                in_gain1b_2 <= in_gain1b_1;
                hidden_2 <= hidden_1;
                nl1_z_2 <= nl1_z_1;
                nl1_xy_2 <= nl1_xy_1;
                nl1_by_1_2 <= nl1_by_1_1;
                nl1_amount_2_2 <= nl1_amount_2_1;
                nl1_amount_4_2 <= nl1_amount_4_1;
                nl1_by_8_2 <= nl1_by_8_1;
                d1_x_2 <= d1_x_1;
                d1_y_2 <= d1_y_1;
                d1_z_2 <= d1_z_1;
                texels1_00_2 <= texels1_00_1;
                texels1_01_2 <= texels1_01_1;
                texels1_10_2 <= texels1_10_1;
                texels1_11_2 <= texels1_11_1;
                blend1_whole_2 <= blend1_whole_1;
                blend1_of_0_2 <= blend1_of_0_1;
                blend1_of_1_2 <= blend1_of_1_1;
                blend1_of_2_2 <= blend1_of_2_1;
                blend1_of_3_2 <= blend1_of_3_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: nl1_xyz, dd1_x_exact, dd1_y_exact, dd1_z_exact
    -- Q4.22: n.l
    nl1_xyz_2 <= nl1_xy_2 + resize(nl1_z_2, 27);
    -- Q4.20: rounded down
    nl1_cut_2 <= nl1_xyz_2(26 downto 2);
    -- Q3.32: |n - h|^2
    dd1_x_exact_2 <= d1_x_2 * d1_x_2;
    -- Q3.16: rounded down
    dd1_x_2 <= dd1_x_exact_2(35 downto 16);
    -- Q3.32: |n - h|^2
    dd1_y_exact_2 <= d1_y_2 * d1_y_2;
    -- Q3.16: rounded down
    dd1_y_2 <= dd1_y_exact_2(35 downto 16);
    -- Q3.32: |n - h|^2
    dd1_z_exact_2 <= d1_z_2 * d1_z_2;
    -- Q3.16: rounded down
    dd1_z_2 <= dd1_z_exact_2(35 downto 16);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_3 <= in_gain1r_2;
                in_gain1g_3 <= in_gain1g_2;
                in_gain1b_3 <= in_gain1b_2;
                hidden_3 <= hidden_2;
                nl1_cut_3 <= nl1_cut_2;
                nl1_by_1_3 <= nl1_by_1_2;
                nl1_amount_2_3 <= nl1_amount_2_2;
                nl1_amount_4_3 <= nl1_amount_4_2;
                nl1_by_8_3 <= nl1_by_8_2;
                dd1_x_3 <= dd1_x_2;
                dd1_y_3 <= dd1_y_2;
                dd1_z_3 <= dd1_z_2;
                texels1_00_3 <= texels1_00_2;
                texels1_01_3 <= texels1_01_2;
                texels1_10_3 <= texels1_10_2;
                texels1_11_3 <= texels1_11_2;
                blend1_whole_3 <= blend1_whole_2;
                blend1_of_0_3 <= blend1_of_0_2;
                blend1_of_1_3 <= blend1_of_1_2;
                blend1_of_2_3 <= blend1_of_2_2;
                blend1_of_3_3 <= blend1_of_3_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: nl1_kept, nl1_up_1, dd1_xy
    -- UQ0.20: n.l, kept in [0, 1)
    nl1_kept_3 <= (others => '0') when nl1_cut_3(24) = '1' else
        to_unsigned(1048575, 20) when unsigned(nl1_cut_3(23 downto 20)) /= 0 else
        unsigned(nl1_cut_3(19 downto 0));
    -- UQ1.20: times 2^1 if so
    nl1_up_1_3 <= shift_left(resize(nl1_kept_3, 21), to_integer(nl1_by_1_3));
    -- UQ9.12: times 2^8
    nl1_all_3 <= nl1_up_1_3;
    -- UQ9.20: in the wider of two formats
    nl1_all_wide_3 <= shift_left(resize(nl1_all_3, 29), 8);
    -- Q4.16: |n - h|^2
    dd1_xy_3 <= resize(dd1_x_3, 21) + resize(dd1_y_3, 21);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_4 <= in_gain1r_3;
                in_gain1g_4 <= in_gain1g_3;
                in_gain1b_4 <= in_gain1b_3;
                hidden_4 <= hidden_3;
                nl1_up_1_4 <= nl1_up_1_3;
                nl1_amount_2_4 <= nl1_amount_2_3;
                nl1_amount_4_4 <= nl1_amount_4_3;
                nl1_by_8_4 <= nl1_by_8_3;
                nl1_all_wide_4 <= nl1_all_wide_3;
                dd1_z_4 <= dd1_z_3;
                dd1_xy_4 <= dd1_xy_3;
                texels1_00_4 <= texels1_00_3;
                texels1_01_4 <= texels1_01_3;
                texels1_10_4 <= texels1_10_3;
                texels1_11_4 <= texels1_11_3;
                blend1_whole_4 <= blend1_whole_3;
                blend1_of_0_4 <= blend1_of_0_3;
                blend1_of_1_4 <= blend1_of_1_3;
                blend1_of_2_4 <= blend1_of_2_3;
                blend1_of_3_4 <= blend1_of_3_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: nl1_up_2, dd1_xyz
    -- UQ3.20: times 2^2 if so
    nl1_up_2_4 <= shift_left(resize(nl1_up_1_4, 23), to_integer(nl1_amount_2_4));
    -- Q4.16: |n - h|^2
    dd1_xyz_4 <= dd1_xy_4 + resize(dd1_z_4, 21);
    -- Q3.17: |n - h|^2 / 2
    u1_exact_4 <= dd1_xyz_4;
    -- Q3.13: rounded down
    u1_cut_4 <= u1_exact_4(20 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_5 <= in_gain1r_4;
                in_gain1g_5 <= in_gain1g_4;
                in_gain1b_5 <= in_gain1b_4;
                hidden_5 <= hidden_4;
                nl1_up_2_5 <= nl1_up_2_4;
                nl1_amount_4_5 <= nl1_amount_4_4;
                nl1_by_8_5 <= nl1_by_8_4;
                nl1_all_wide_5 <= nl1_all_wide_4;
                u1_cut_5 <= u1_cut_4;
                texels1_00_5 <= texels1_00_4;
                texels1_01_5 <= texels1_01_4;
                texels1_10_5 <= texels1_10_4;
                texels1_11_5 <= texels1_11_4;
                blend1_whole_5 <= blend1_whole_4;
                blend1_of_0_5 <= blend1_of_0_4;
                blend1_of_1_5 <= blend1_of_1_4;
                blend1_of_2_5 <= blend1_of_2_4;
                blend1_of_3_5 <= blend1_of_3_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: nl1_up_4, nl1_up, nl1_within, u1, u1_4
    -- UQ7.20: times 2^4 if so
    nl1_up_4_5 <= shift_left(resize(nl1_up_2_5, 27), to_integer(nl1_amount_4_5));
    -- UQ9.20: in the wider of two formats
    nl1_up_4_wide_5 <= resize(nl1_up_4_5, 29);
    -- UQ9.20: times 2^shift
    nl1_up_5 <= nl1_all_wide_5 when nl1_by_8_5 = '1' else nl1_up_4_wide_5;
    -- UQ9.11: rounded down
    nl1_up_cut_5 <= nl1_up_5(28 downto 9);
    -- UQ7.11: kept in its format
    nl1_within_5 <= to_unsigned(262143, 18) when unsigned(nl1_up_cut_5(19 downto 18)) /= 0 else
        nl1_up_cut_5(17 downto 0);
    -- UQ0.13: the versine u = |n - h|^2 / 2, at most the last column's
    u1_5 <= (others => '0') when u1_cut_5(16) = '1' else
        to_unsigned(7168, 13) when u1_cut_5 > 7168 else
        unsigned(u1_cut_5(12 downto 0));
    -- UQ0.4: the first 4 bits of u
    high1_4_bits_5 <= u1_5(12 downto 9);
    -- UQ1.0: the first 4 bits of u
    high1_4_5 <= '1' when high1_4_bits_5 /= 0 else '0';
    -- UQ-4.13: without them
    u_low1_4_5 <= u1_5(8 downto 0);
    -- UQ0.9: u 2^4
    u_up1_4_5 <= u_low1_4_5;
    -- UQ0.13: in the wider of two formats
    u_up1_4_wide_5 <= shift_left(resize(u_up1_4_5, 13), 4);
    -- UQ0.13: u, times 2^4 if it is so small
    u1_4_5 <= u1_5 when high1_4_5 = '1' else u_up1_4_wide_5;
    -- UQ3.-2: a bit of the exponent
    place1_4_5 <= unsigned'("" & high1_4_5);
    -- UQ0.2: the first 2 bits of u
    high1_2_bits_5 <= u1_4_5(12 downto 11);
    -- UQ-2.13: without them
    u_low1_2_5 <= u1_4_5(10 downto 0);
    -- UQ0.11: u 2^2
    u_up1_2_5 <= u_low1_2_5;
    -- UQ0.13: in the wider of two formats
    u_up1_2_wide_5 <= shift_left(resize(u_up1_2_5, 13), 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_6 <= in_gain1r_5;
                in_gain1g_6 <= in_gain1g_5;
                in_gain1b_6 <= in_gain1b_5;
                hidden_6 <= hidden_5;
                nl1_within_6 <= nl1_within_5;
                high1_4_6 <= high1_4_5;
                u1_4_6 <= u1_4_5;
                place1_4_6 <= place1_4_5;
                high1_2_bits_6 <= high1_2_bits_5;
                u_up1_2_wide_6 <= u_up1_2_wide_5;
                texels1_00_6 <= texels1_00_5;
                texels1_01_6 <= texels1_01_5;
                texels1_10_6 <= texels1_10_5;
                texels1_11_6 <= texels1_11_5;
                blend1_whole_6 <= blend1_whole_5;
                blend1_of_0_6 <= blend1_of_0_5;
                blend1_of_1_6 <= blend1_of_1_5;
                blend1_of_2_6 <= blend1_of_2_5;
                blend1_of_3_6 <= blend1_of_3_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: nl1, u1_2, exponent1_2, u1_1, rest1
    -- UQ7.11: n.l, 0 for a normal that is turned away
    nl1_6 <= (others => '0') when hidden_6 = '1' else nl1_within_6;
    -- UQ1.0: the first 2 bits of u
    high1_2_6 <= '1' when high1_2_bits_6 /= 0 else '0';
    -- UQ0.13: u, times 2^2 if it is so small
    u1_2_6 <= u1_4_6 when high1_2_6 = '1' else u_up1_2_wide_6;
    -- UQ2.-1: a bit of the exponent
    place1_2_6 <= unsigned'("" & high1_2_6);
    -- UQ3.-1: the exponent's bits so far
    exponent1_2_6 <= shift_left(resize(place1_4_6, 2), 1) + resize(place1_2_6, 2);
    -- UQ0.1: the first 1 bits of u
    high1_1_bits_6 <= u1_2_6(12);
    -- UQ-1.13: without them
    u_low1_1_6 <= u1_2_6(11 downto 0);
    -- UQ0.12: u 2^1
    u_up1_1_6 <= u_low1_1_6;
    -- UQ0.13: in the wider of two formats
    u_up1_1_wide_6 <= shift_left(resize(u_up1_1_6, 13), 1);
    -- UQ0.13: u, times 2^1 if it is so small
    u1_1_6 <= u1_2_6 when high1_1_bits_6 = '1' else u_up1_1_wide_6;
    -- UQ1.0: a bit of the exponent
    place1_1_6 <= unsigned'("" & high1_1_bits_6);
    -- UQ1.0: the exponent is not 0
    normal1_of_2_6 <= high1_4_6 or high1_2_6;
    -- UQ1.0: the exponent is not 0
    normal1_6 <= normal1_of_2_6 or high1_1_bits_6;
    -- UQ1.12: 2 u
    u1_twice_6 <= u1_1_6;
    -- UQ0.12: 2 u - 1
    u1_rest_6 <= u1_twice_6(11 downto 0);
    -- UQ0.13: in the wider of two formats
    u1_rest_wide_6 <= shift_left(resize(u1_rest_6, 13), 1);
    -- UQ0.13: the place in the octave
    rest1_6 <= u1_rest_wide_6 when normal1_6 = '1' else u1_1_6;
    -- UQ0.6: rounded down to the weights' last bit
    rest1_cut_6 <= rest1_6(12 downto 7);
    -- UQ0.2: the column in the octave
    step1_6 <= rest1_cut_6(5 downto 4);
    -- UQ2.0: its number
    step1_number_6 <= step1_6;
    -- UQ-2.6: u past it
    part1_6 <= rest1_cut_6(3 downto 0);
    -- UQ0.4: the weight of the next column
    weight1_6 <= part1_6;
    -- UQ-3.4: a bit of the weight
    weight1_bit_0_6 <= weight1_6(0 downto 0);
    -- UQ-2.3: a bit of the weight
    weight1_bit_1_6 <= weight1_6(1 downto 1);
    -- UQ-1.2: a bit of the weight
    weight1_bit_2_6 <= weight1_6(2 downto 2);
    -- UQ0.1: a bit of the weight
    weight1_bit_3_6 <= weight1_6(3 downto 3);
    -- UQ1.0: as a flag
    weight1_of_0_flag_6 <= weight1_bit_0_6(0);
    -- UQ1.0: it is 0
    weight1_of_0_not_6 <= not weight1_of_0_flag_6;
    -- UQ1.0: as a flag
    weight1_of_1_flag_6 <= weight1_bit_1_6(0);
    -- UQ1.0: it is 0
    weight1_of_1_not_6 <= not weight1_of_1_flag_6;
    -- UQ1.0: as a flag
    weight1_of_2_flag_6 <= weight1_bit_2_6(0);
    -- UQ1.0: it is 0
    weight1_of_2_not_6 <= not weight1_of_2_flag_6;
    -- UQ1.0: as a flag
    weight1_of_3_flag_6 <= weight1_bit_3_6(0);
    -- UQ1.0: it is 0
    weight1_of_3_not_6 <= not weight1_of_3_flag_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_7 <= in_gain1r_6;
                in_gain1g_7 <= in_gain1g_6;
                in_gain1b_7 <= in_gain1b_6;
                nl1_7 <= nl1_6;
                exponent1_2_7 <= exponent1_2_6;
                place1_1_7 <= place1_1_6;
                step1_number_7 <= step1_number_6;
                texels1_00_7 <= texels1_00_6;
                texels1_01_7 <= texels1_01_6;
                texels1_10_7 <= texels1_10_6;
                texels1_11_7 <= texels1_11_6;
                weight1_of_0_flag_7 <= weight1_of_0_flag_6;
                weight1_of_0_not_7 <= weight1_of_0_not_6;
                weight1_of_1_flag_7 <= weight1_of_1_flag_6;
                weight1_of_1_not_7 <= weight1_of_1_not_6;
                weight1_of_2_flag_7 <= weight1_of_2_flag_6;
                weight1_of_2_not_7 <= weight1_of_2_not_6;
                weight1_of_3_flag_7 <= weight1_of_3_flag_6;
                weight1_of_3_not_7 <= weight1_of_3_not_6;
                blend1_whole_7 <= blend1_whole_6;
                blend1_of_0_7 <= blend1_of_0_6;
                blend1_of_1_7 <= blend1_of_1_6;
                blend1_of_2_7 <= blend1_of_2_6;
                blend1_of_3_7 <= blend1_of_3_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: exponent1_1
    -- UQ3.0: the exponent's bits so far
    exponent1_1_7 <= shift_left(resize(exponent1_2_7, 3), 1) + resize(place1_1_7, 3);
    -- UQ5.-2: the octave's first column
    octave1_7 <= exponent1_1_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_8 <= in_gain1r_7;
                in_gain1g_8 <= in_gain1g_7;
                in_gain1b_8 <= in_gain1b_7;
                nl1_8 <= nl1_7;
                step1_number_8 <= step1_number_7;
                octave1_8 <= octave1_7;
                texels1_00_8 <= texels1_00_7;
                texels1_01_8 <= texels1_01_7;
                texels1_10_8 <= texels1_10_7;
                texels1_11_8 <= texels1_11_7;
                weight1_of_0_flag_8 <= weight1_of_0_flag_7;
                weight1_of_0_not_8 <= weight1_of_0_not_7;
                weight1_of_1_flag_8 <= weight1_of_1_flag_7;
                weight1_of_1_not_8 <= weight1_of_1_not_7;
                weight1_of_2_flag_8 <= weight1_of_2_flag_7;
                weight1_of_2_not_8 <= weight1_of_2_not_7;
                weight1_of_3_flag_8 <= weight1_of_3_flag_7;
                weight1_of_3_not_8 <= weight1_of_3_not_7;
                blend1_whole_8 <= blend1_whole_7;
                blend1_of_0_8 <= blend1_of_0_7;
                blend1_of_1_8 <= blend1_of_1_7;
                blend1_of_2_8 <= blend1_of_2_7;
                blend1_of_3_8 <= blend1_of_3_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: column1, weight1_of_0, weight1_of_1, weight1_of_2 and 1 more
    -- UQ5.0: the column at or below u
    column1_8 <= shift_left(resize(octave1_8, 5), 2) + resize(step1_number_8, 5);
    -- UQ5.-1: its leading bits
    column1_odd_high_8 <= column1_8(4 downto 1);
    -- UQ4.0: the odd one of both
    column1_odd_8 <= column1_odd_high_8;
    -- UQ1.0: its last bit
    column1_is_odd_8 <= column1_8(0);
    -- UQ1.0: whether it counts for the odd one
    weight1_of_0_8 <= weight1_of_0_not_8 when column1_is_odd_8 = '1' else weight1_of_0_flag_8;
    -- UQ1.0: whether it counts for the odd one
    weight1_of_1_8 <= weight1_of_1_not_8 when column1_is_odd_8 = '1' else weight1_of_1_flag_8;
    -- UQ1.0: whether it counts for the odd one
    weight1_of_2_8 <= weight1_of_2_not_8 when column1_is_odd_8 = '1' else weight1_of_2_flag_8;
    -- UQ1.0: whether it counts for the odd one
    weight1_of_3_8 <= weight1_of_3_not_8 when column1_is_odd_8 = '1' else weight1_of_3_flag_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_9 <= in_gain1r_8;
                in_gain1g_9 <= in_gain1g_8;
                in_gain1b_9 <= in_gain1b_8;
                nl1_9 <= nl1_8;
                column1_9 <= column1_8;
                column1_odd_9 <= column1_odd_8;
                column1_is_odd_9 <= column1_is_odd_8;
                texels1_00_9 <= texels1_00_8;
                texels1_01_9 <= texels1_01_8;
                texels1_10_9 <= texels1_10_8;
                texels1_11_9 <= texels1_11_8;
                weight1_of_0_9 <= weight1_of_0_8;
                weight1_of_1_9 <= weight1_of_1_8;
                weight1_of_2_9 <= weight1_of_2_8;
                weight1_of_3_9 <= weight1_of_3_8;
                blend1_whole_9 <= blend1_whole_8;
                blend1_of_0_9 <= blend1_of_0_8;
                blend1_of_1_9 <= blend1_of_1_8;
                blend1_of_2_9 <= blend1_of_2_8;
                blend1_of_3_9 <= blend1_of_3_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: column1_next_exact, texel1_01, texel1_11
    -- UQ6.0: the next
    column1_next_exact_9 <= resize(column1_9, 6) + to_unsigned(1, 6);
    -- UQ8.0: side by side
    texel1_01_9 <= shift_left(resize(texels1_01_9, 8), 4) + resize(column1_odd_9, 8);
    -- UQ8.0: side by side
    texel1_11_9 <= shift_left(resize(texels1_11_9, 8), 4) + resize(column1_odd_9, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_10 <= in_gain1r_9;
                in_gain1g_10 <= in_gain1g_9;
                in_gain1b_10 <= in_gain1b_9;
                nl1_10 <= nl1_9;
                column1_next_exact_10 <= column1_next_exact_9;
                column1_is_odd_10 <= column1_is_odd_9;
                texels1_00_10 <= texels1_00_9;
                texel1_01_10 <= texel1_01_9;
                texels1_10_10 <= texels1_10_9;
                texel1_11_10 <= texel1_11_9;
                weight1_of_0_10 <= weight1_of_0_9;
                weight1_of_1_10 <= weight1_of_1_9;
                weight1_of_2_10 <= weight1_of_2_9;
                weight1_of_3_10 <= weight1_of_3_9;
                blend1_whole_10 <= blend1_whole_9;
                blend1_of_0_10 <= blend1_of_0_9;
                blend1_of_1_10 <= blend1_of_1_9;
                blend1_of_2_10 <= blend1_of_2_9;
                blend1_of_3_10 <= blend1_of_3_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: column1_next
    -- UQ5.0: at most the last
    column1_next_10 <= to_unsigned(31, 5) when column1_next_exact_10(5) = '1' else
        column1_next_exact_10(4 downto 0);
    -- UQ5.-1: its leading bits
    column1_even_high_10 <= column1_next_10(4 downto 1);
    -- UQ4.0: the even one of both
    column1_even_10 <= column1_even_high_10;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_11 <= in_gain1r_10;
                in_gain1g_11 <= in_gain1g_10;
                in_gain1b_11 <= in_gain1b_10;
                nl1_11 <= nl1_10;
                column1_even_11 <= column1_even_10;
                column1_is_odd_11 <= column1_is_odd_10;
                texels1_00_11 <= texels1_00_10;
                texel1_01_11 <= texel1_01_10;
                texels1_10_11 <= texels1_10_10;
                texel1_11_11 <= texel1_11_10;
                weight1_of_0_11 <= weight1_of_0_10;
                weight1_of_1_11 <= weight1_of_1_10;
                weight1_of_2_11 <= weight1_of_2_10;
                weight1_of_3_11 <= weight1_of_3_10;
                blend1_whole_11 <= blend1_whole_10;
                blend1_of_0_11 <= blend1_of_0_10;
                blend1_of_1_11 <= blend1_of_1_10;
                blend1_of_2_11 <= blend1_of_2_10;
                blend1_of_3_11 <= blend1_of_3_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: texel1_00, texel1_10
    -- UQ8.0: side by side
    texel1_00_11 <= shift_left(resize(texels1_00_11, 8), 4) + resize(column1_even_11, 8);
    -- UQ8.0: side by side
    texel1_10_11 <= shift_left(resize(texels1_10_11, 8), 4) + resize(column1_even_11, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_12 <= in_gain1r_11;
                in_gain1g_12 <= in_gain1g_11;
                in_gain1b_12 <= in_gain1b_11;
                nl1_12 <= nl1_11;
                column1_is_odd_12 <= column1_is_odd_11;
                texel1_00_12 <= texel1_00_11;
                texel1_01_12 <= texel1_01_11;
                texel1_10_12 <= texel1_10_11;
                texel1_11_12 <= texel1_11_11;
                weight1_of_0_12 <= weight1_of_0_11;
                weight1_of_1_12 <= weight1_of_1_11;
                weight1_of_2_12 <= weight1_of_2_11;
                weight1_of_3_12 <= weight1_of_3_11;
                blend1_whole_12 <= blend1_whole_11;
                blend1_of_0_12 <= blend1_of_0_11;
                blend1_of_1_12 <= blend1_of_1_11;
                blend1_of_2_12 <= blend1_of_2_11;
                blend1_of_3_12 <= blend1_of_3_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: read texels_1_even_even, read texels_1_even_odd and 2 more
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_13 <= TEXELS_1_EVEN_EVEN(to_integer(texel1_00_12));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_13 <= TEXELS_1_EVEN_ODD(to_integer(texel1_01_12));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_13 <= TEXELS_1_ODD_EVEN(to_integer(texel1_10_12));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_13 <= TEXELS_1_ODD_ODD(to_integer(texel1_11_12));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_13 <= in_gain1r_12;
                in_gain1g_13 <= in_gain1g_12;
                in_gain1b_13 <= in_gain1b_12;
                nl1_13 <= nl1_12;
                column1_is_odd_13 <= column1_is_odd_12;
                weight1_of_0_13 <= weight1_of_0_12;
                weight1_of_1_13 <= weight1_of_1_12;
                weight1_of_2_13 <= weight1_of_2_12;
                weight1_of_3_13 <= weight1_of_3_12;
                blend1_whole_13 <= blend1_whole_12;
                blend1_of_0_13 <= blend1_of_0_12;
                blend1_of_1_13 <= blend1_of_1_12;
                blend1_of_2_13 <= blend1_of_2_12;
                blend1_of_3_13 <= blend1_of_3_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: registers only
    -- UQ0.8: red
    texels_1_even_even_r_13 <= unsigned(texels_1_even_even_13(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_r_13 <= unsigned(texels_1_even_odd_13(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_r_13 <= unsigned(texels_1_odd_even_13(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_r_13 <= unsigned(texels_1_odd_odd_13(23 downto 16));
    -- UQ0.8: green
    texels_1_even_even_g_13 <= unsigned(texels_1_even_even_13(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_g_13 <= unsigned(texels_1_even_odd_13(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_g_13 <= unsigned(texels_1_odd_even_13(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_g_13 <= unsigned(texels_1_odd_odd_13(15 downto 8));
    -- UQ0.8: blue
    texels_1_even_even_b_13 <= unsigned(texels_1_even_even_13(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_b_13 <= unsigned(texels_1_even_odd_13(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_b_13 <= unsigned(texels_1_odd_even_13(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_b_13 <= unsigned(texels_1_odd_odd_13(7 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_14 <= in_gain1r_13;
                in_gain1g_14 <= in_gain1g_13;
                in_gain1b_14 <= in_gain1b_13;
                nl1_14 <= nl1_13;
                column1_is_odd_14 <= column1_is_odd_13;
                texels_1_even_even_r_14 <= texels_1_even_even_r_13;
                texels_1_even_odd_r_14 <= texels_1_even_odd_r_13;
                texels_1_odd_even_r_14 <= texels_1_odd_even_r_13;
                texels_1_odd_odd_r_14 <= texels_1_odd_odd_r_13;
                weight1_of_0_14 <= weight1_of_0_13;
                weight1_of_1_14 <= weight1_of_1_13;
                weight1_of_2_14 <= weight1_of_2_13;
                weight1_of_3_14 <= weight1_of_3_13;
                blend1_whole_14 <= blend1_whole_13;
                blend1_of_0_14 <= blend1_of_0_13;
                blend1_of_1_14 <= blend1_of_1_13;
                blend1_of_2_14 <= blend1_of_2_13;
                blend1_of_3_14 <= blend1_of_3_13;
                texels_1_even_even_g_14 <= texels_1_even_even_g_13;
                texels_1_even_odd_g_14 <= texels_1_even_odd_g_13;
                texels_1_odd_even_g_14 <= texels_1_odd_even_g_13;
                texels_1_odd_odd_g_14 <= texels_1_odd_odd_g_13;
                texels_1_even_even_b_14 <= texels_1_even_even_b_13;
                texels_1_even_odd_b_14 <= texels_1_even_odd_b_13;
                texels_1_odd_even_b_14 <= texels_1_odd_even_b_13;
                texels_1_odd_odd_b_14 <= texels_1_odd_odd_b_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_15 <= in_gain1r_14;
                in_gain1g_15 <= in_gain1g_14;
                in_gain1b_15 <= in_gain1b_14;
                nl1_15 <= nl1_14;
                column1_is_odd_15 <= column1_is_odd_14;
                texels_1_even_even_r_15 <= texels_1_even_even_r_14;
                texels_1_even_odd_r_15 <= texels_1_even_odd_r_14;
                texels_1_odd_even_r_15 <= texels_1_odd_even_r_14;
                texels_1_odd_odd_r_15 <= texels_1_odd_odd_r_14;
                weight1_of_0_15 <= weight1_of_0_14;
                weight1_of_1_15 <= weight1_of_1_14;
                weight1_of_2_15 <= weight1_of_2_14;
                weight1_of_3_15 <= weight1_of_3_14;
                blend1_whole_15 <= blend1_whole_14;
                blend1_of_0_15 <= blend1_of_0_14;
                blend1_of_1_15 <= blend1_of_1_14;
                blend1_of_2_15 <= blend1_of_2_14;
                blend1_of_3_15 <= blend1_of_3_14;
                texels_1_even_even_g_15 <= texels_1_even_even_g_14;
                texels_1_even_odd_g_15 <= texels_1_even_odd_g_14;
                texels_1_odd_even_g_15 <= texels_1_odd_even_g_14;
                texels_1_odd_odd_g_15 <= texels_1_odd_odd_g_14;
                texels_1_even_even_b_15 <= texels_1_even_even_b_14;
                texels_1_even_odd_b_15 <= texels_1_even_odd_b_14;
                texels_1_odd_even_b_15 <= texels_1_odd_even_b_14;
                texels_1_odd_odd_b_15 <= texels_1_odd_odd_b_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 40 more
    -- UQ0.8: either of both
    blend1_r_1_0_either_first_15 <=
        texels_1_even_odd_r_15 when column1_is_odd_15 = '1' else texels_1_even_even_r_15;
    -- UQ-4.12: shifted
    blend1_r_1_0_by_first_15 <= blend1_r_1_0_either_first_15;
    -- UQ0.8: either of both
    blend1_r_1_0_either_0_15 <=
        texels_1_even_odd_r_15 when weight1_of_0_15 = '1' else texels_1_even_even_r_15;
    -- UQ-4.12: shifted
    blend1_r_1_0_by_0_15 <= blend1_r_1_0_either_0_15;
    -- UQ0.8: either of both
    blend1_r_1_0_either_1_15 <=
        texels_1_even_odd_r_15 when weight1_of_1_15 = '1' else texels_1_even_even_r_15;
    -- UQ-3.11: shifted
    blend1_r_1_0_by_1_15 <= blend1_r_1_0_either_1_15;
    -- UQ0.8: either of both
    blend1_r_1_0_either_2_15 <=
        texels_1_even_odd_r_15 when weight1_of_2_15 = '1' else texels_1_even_even_r_15;
    -- UQ-2.10: shifted
    blend1_r_1_0_by_2_15 <= blend1_r_1_0_either_2_15;
    -- UQ0.8: either of both
    blend1_r_1_0_either_3_15 <=
        texels_1_even_odd_r_15 when weight1_of_3_15 = '1' else texels_1_even_even_r_15;
    -- UQ-1.9: shifted
    blend1_r_1_0_by_3_15 <= blend1_r_1_0_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_r_1_0_sum_1_0_15 <=
        resize(blend1_r_1_0_by_first_15, 9) + resize(blend1_r_1_0_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_r_1_0_sum_1_1_15 <=
        resize(blend1_r_1_0_by_1_15, 10) + shift_left(resize(blend1_r_1_0_by_2_15, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_1_either_first_15 <=
        texels_1_odd_odd_r_15 when column1_is_odd_15 = '1' else texels_1_odd_even_r_15;
    -- UQ-4.12: shifted
    blend1_r_1_1_by_first_15 <= blend1_r_1_1_either_first_15;
    -- UQ0.8: either of both
    blend1_r_1_1_either_0_15 <=
        texels_1_odd_odd_r_15 when weight1_of_0_15 = '1' else texels_1_odd_even_r_15;
    -- UQ-4.12: shifted
    blend1_r_1_1_by_0_15 <= blend1_r_1_1_either_0_15;
    -- UQ0.8: either of both
    blend1_r_1_1_either_1_15 <=
        texels_1_odd_odd_r_15 when weight1_of_1_15 = '1' else texels_1_odd_even_r_15;
    -- UQ-3.11: shifted
    blend1_r_1_1_by_1_15 <= blend1_r_1_1_either_1_15;
    -- UQ0.8: either of both
    blend1_r_1_1_either_2_15 <=
        texels_1_odd_odd_r_15 when weight1_of_2_15 = '1' else texels_1_odd_even_r_15;
    -- UQ-2.10: shifted
    blend1_r_1_1_by_2_15 <= blend1_r_1_1_either_2_15;
    -- UQ0.8: either of both
    blend1_r_1_1_either_3_15 <=
        texels_1_odd_odd_r_15 when weight1_of_3_15 = '1' else texels_1_odd_even_r_15;
    -- UQ-1.9: shifted
    blend1_r_1_1_by_3_15 <= blend1_r_1_1_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_r_1_1_sum_1_0_15 <=
        resize(blend1_r_1_1_by_first_15, 9) + resize(blend1_r_1_1_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_r_1_1_sum_1_1_15 <=
        resize(blend1_r_1_1_by_1_15, 10) + shift_left(resize(blend1_r_1_1_by_2_15, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_0_either_first_15 <=
        texels_1_even_odd_g_15 when column1_is_odd_15 = '1' else texels_1_even_even_g_15;
    -- UQ-4.12: shifted
    blend1_g_1_0_by_first_15 <= blend1_g_1_0_either_first_15;
    -- UQ0.8: either of both
    blend1_g_1_0_either_0_15 <=
        texels_1_even_odd_g_15 when weight1_of_0_15 = '1' else texels_1_even_even_g_15;
    -- UQ-4.12: shifted
    blend1_g_1_0_by_0_15 <= blend1_g_1_0_either_0_15;
    -- UQ0.8: either of both
    blend1_g_1_0_either_1_15 <=
        texels_1_even_odd_g_15 when weight1_of_1_15 = '1' else texels_1_even_even_g_15;
    -- UQ-3.11: shifted
    blend1_g_1_0_by_1_15 <= blend1_g_1_0_either_1_15;
    -- UQ0.8: either of both
    blend1_g_1_0_either_2_15 <=
        texels_1_even_odd_g_15 when weight1_of_2_15 = '1' else texels_1_even_even_g_15;
    -- UQ-2.10: shifted
    blend1_g_1_0_by_2_15 <= blend1_g_1_0_either_2_15;
    -- UQ0.8: either of both
    blend1_g_1_0_either_3_15 <=
        texels_1_even_odd_g_15 when weight1_of_3_15 = '1' else texels_1_even_even_g_15;
    -- UQ-1.9: shifted
    blend1_g_1_0_by_3_15 <= blend1_g_1_0_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_g_1_0_sum_1_0_15 <=
        resize(blend1_g_1_0_by_first_15, 9) + resize(blend1_g_1_0_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_g_1_0_sum_1_1_15 <=
        resize(blend1_g_1_0_by_1_15, 10) + shift_left(resize(blend1_g_1_0_by_2_15, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_1_either_first_15 <=
        texels_1_odd_odd_g_15 when column1_is_odd_15 = '1' else texels_1_odd_even_g_15;
    -- UQ-4.12: shifted
    blend1_g_1_1_by_first_15 <= blend1_g_1_1_either_first_15;
    -- UQ0.8: either of both
    blend1_g_1_1_either_0_15 <=
        texels_1_odd_odd_g_15 when weight1_of_0_15 = '1' else texels_1_odd_even_g_15;
    -- UQ-4.12: shifted
    blend1_g_1_1_by_0_15 <= blend1_g_1_1_either_0_15;
    -- UQ0.8: either of both
    blend1_g_1_1_either_1_15 <=
        texels_1_odd_odd_g_15 when weight1_of_1_15 = '1' else texels_1_odd_even_g_15;
    -- UQ-3.11: shifted
    blend1_g_1_1_by_1_15 <= blend1_g_1_1_either_1_15;
    -- UQ0.8: either of both
    blend1_g_1_1_either_2_15 <=
        texels_1_odd_odd_g_15 when weight1_of_2_15 = '1' else texels_1_odd_even_g_15;
    -- UQ-2.10: shifted
    blend1_g_1_1_by_2_15 <= blend1_g_1_1_either_2_15;
    -- UQ0.8: either of both
    blend1_g_1_1_either_3_15 <=
        texels_1_odd_odd_g_15 when weight1_of_3_15 = '1' else texels_1_odd_even_g_15;
    -- UQ-1.9: shifted
    blend1_g_1_1_by_3_15 <= blend1_g_1_1_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_g_1_1_sum_1_0_15 <=
        resize(blend1_g_1_1_by_first_15, 9) + resize(blend1_g_1_1_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_g_1_1_sum_1_1_15 <=
        resize(blend1_g_1_1_by_1_15, 10) + shift_left(resize(blend1_g_1_1_by_2_15, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_0_either_first_15 <=
        texels_1_even_odd_b_15 when column1_is_odd_15 = '1' else texels_1_even_even_b_15;
    -- UQ-4.12: shifted
    blend1_b_1_0_by_first_15 <= blend1_b_1_0_either_first_15;
    -- UQ0.8: either of both
    blend1_b_1_0_either_0_15 <=
        texels_1_even_odd_b_15 when weight1_of_0_15 = '1' else texels_1_even_even_b_15;
    -- UQ-4.12: shifted
    blend1_b_1_0_by_0_15 <= blend1_b_1_0_either_0_15;
    -- UQ0.8: either of both
    blend1_b_1_0_either_1_15 <=
        texels_1_even_odd_b_15 when weight1_of_1_15 = '1' else texels_1_even_even_b_15;
    -- UQ-3.11: shifted
    blend1_b_1_0_by_1_15 <= blend1_b_1_0_either_1_15;
    -- UQ0.8: either of both
    blend1_b_1_0_either_2_15 <=
        texels_1_even_odd_b_15 when weight1_of_2_15 = '1' else texels_1_even_even_b_15;
    -- UQ-2.10: shifted
    blend1_b_1_0_by_2_15 <= blend1_b_1_0_either_2_15;
    -- UQ0.8: either of both
    blend1_b_1_0_either_3_15 <=
        texels_1_even_odd_b_15 when weight1_of_3_15 = '1' else texels_1_even_even_b_15;
    -- UQ-1.9: shifted
    blend1_b_1_0_by_3_15 <= blend1_b_1_0_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_b_1_0_sum_1_0_15 <=
        resize(blend1_b_1_0_by_first_15, 9) + resize(blend1_b_1_0_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_b_1_0_sum_1_1_15 <=
        resize(blend1_b_1_0_by_1_15, 10) + shift_left(resize(blend1_b_1_0_by_2_15, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_1_either_first_15 <=
        texels_1_odd_odd_b_15 when column1_is_odd_15 = '1' else texels_1_odd_even_b_15;
    -- UQ-4.12: shifted
    blend1_b_1_1_by_first_15 <= blend1_b_1_1_either_first_15;
    -- UQ0.8: either of both
    blend1_b_1_1_either_0_15 <=
        texels_1_odd_odd_b_15 when weight1_of_0_15 = '1' else texels_1_odd_even_b_15;
    -- UQ-4.12: shifted
    blend1_b_1_1_by_0_15 <= blend1_b_1_1_either_0_15;
    -- UQ0.8: either of both
    blend1_b_1_1_either_1_15 <=
        texels_1_odd_odd_b_15 when weight1_of_1_15 = '1' else texels_1_odd_even_b_15;
    -- UQ-3.11: shifted
    blend1_b_1_1_by_1_15 <= blend1_b_1_1_either_1_15;
    -- UQ0.8: either of both
    blend1_b_1_1_either_2_15 <=
        texels_1_odd_odd_b_15 when weight1_of_2_15 = '1' else texels_1_odd_even_b_15;
    -- UQ-2.10: shifted
    blend1_b_1_1_by_2_15 <= blend1_b_1_1_either_2_15;
    -- UQ0.8: either of both
    blend1_b_1_1_either_3_15 <=
        texels_1_odd_odd_b_15 when weight1_of_3_15 = '1' else texels_1_odd_even_b_15;
    -- UQ-1.9: shifted
    blend1_b_1_1_by_3_15 <= blend1_b_1_1_either_3_15;
    -- UQ-3.12: the sum of two
    blend1_b_1_1_sum_1_0_15 <=
        resize(blend1_b_1_1_by_first_15, 9) + resize(blend1_b_1_1_by_0_15, 9);
    -- UQ-1.11: the sum of two
    blend1_b_1_1_sum_1_1_15 <=
        resize(blend1_b_1_1_by_1_15, 10) + shift_left(resize(blend1_b_1_1_by_2_15, 10), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_16 <= in_gain1r_15;
                in_gain1g_16 <= in_gain1g_15;
                in_gain1b_16 <= in_gain1b_15;
                nl1_16 <= nl1_15;
                blend1_r_1_0_by_3_16 <= blend1_r_1_0_by_3_15;
                blend1_r_1_0_sum_1_0_16 <= blend1_r_1_0_sum_1_0_15;
                blend1_r_1_0_sum_1_1_16 <= blend1_r_1_0_sum_1_1_15;
                blend1_r_1_1_by_3_16 <= blend1_r_1_1_by_3_15;
                blend1_r_1_1_sum_1_0_16 <= blend1_r_1_1_sum_1_0_15;
                blend1_r_1_1_sum_1_1_16 <= blend1_r_1_1_sum_1_1_15;
                blend1_whole_16 <= blend1_whole_15;
                blend1_of_0_16 <= blend1_of_0_15;
                blend1_of_1_16 <= blend1_of_1_15;
                blend1_of_2_16 <= blend1_of_2_15;
                blend1_of_3_16 <= blend1_of_3_15;
                blend1_g_1_0_by_3_16 <= blend1_g_1_0_by_3_15;
                blend1_g_1_0_sum_1_0_16 <= blend1_g_1_0_sum_1_0_15;
                blend1_g_1_0_sum_1_1_16 <= blend1_g_1_0_sum_1_1_15;
                blend1_g_1_1_by_3_16 <= blend1_g_1_1_by_3_15;
                blend1_g_1_1_sum_1_0_16 <= blend1_g_1_1_sum_1_0_15;
                blend1_g_1_1_sum_1_1_16 <= blend1_g_1_1_sum_1_1_15;
                blend1_b_1_0_by_3_16 <= blend1_b_1_0_by_3_15;
                blend1_b_1_0_sum_1_0_16 <= blend1_b_1_0_sum_1_0_15;
                blend1_b_1_0_sum_1_1_16 <= blend1_b_1_0_sum_1_1_15;
                blend1_b_1_1_by_3_16 <= blend1_b_1_1_by_3_15;
                blend1_b_1_1_sum_1_0_16 <= blend1_b_1_1_sum_1_0_15;
                blend1_b_1_1_sum_1_1_16 <= blend1_b_1_1_sum_1_1_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: blend1_r_1_0_sum_2_0, blend1_r_1_1_sum_2_0 and 4 more
    -- UQ-1.12: the sum of two
    blend1_r_1_0_sum_2_0_16 <=
        resize(blend1_r_1_0_sum_1_0_16, 11) + shift_left(resize(blend1_r_1_0_sum_1_1_16, 11), 1);
    -- UQ-1.12: the sum of two
    blend1_r_1_1_sum_2_0_16 <=
        resize(blend1_r_1_1_sum_1_0_16, 11) + shift_left(resize(blend1_r_1_1_sum_1_1_16, 11), 1);
    -- UQ-1.12: the sum of two
    blend1_g_1_0_sum_2_0_16 <=
        resize(blend1_g_1_0_sum_1_0_16, 11) + shift_left(resize(blend1_g_1_0_sum_1_1_16, 11), 1);
    -- UQ-1.12: the sum of two
    blend1_g_1_1_sum_2_0_16 <=
        resize(blend1_g_1_1_sum_1_0_16, 11) + shift_left(resize(blend1_g_1_1_sum_1_1_16, 11), 1);
    -- UQ-1.12: the sum of two
    blend1_b_1_0_sum_2_0_16 <=
        resize(blend1_b_1_0_sum_1_0_16, 11) + shift_left(resize(blend1_b_1_0_sum_1_1_16, 11), 1);
    -- UQ-1.12: the sum of two
    blend1_b_1_1_sum_2_0_16 <=
        resize(blend1_b_1_1_sum_1_0_16, 11) + shift_left(resize(blend1_b_1_1_sum_1_1_16, 11), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_17 <= in_gain1r_16;
                in_gain1g_17 <= in_gain1g_16;
                in_gain1b_17 <= in_gain1b_16;
                nl1_17 <= nl1_16;
                blend1_r_1_0_by_3_17 <= blend1_r_1_0_by_3_16;
                blend1_r_1_0_sum_2_0_17 <= blend1_r_1_0_sum_2_0_16;
                blend1_r_1_1_by_3_17 <= blend1_r_1_1_by_3_16;
                blend1_r_1_1_sum_2_0_17 <= blend1_r_1_1_sum_2_0_16;
                blend1_whole_17 <= blend1_whole_16;
                blend1_of_0_17 <= blend1_of_0_16;
                blend1_of_1_17 <= blend1_of_1_16;
                blend1_of_2_17 <= blend1_of_2_16;
                blend1_of_3_17 <= blend1_of_3_16;
                blend1_g_1_0_by_3_17 <= blend1_g_1_0_by_3_16;
                blend1_g_1_0_sum_2_0_17 <= blend1_g_1_0_sum_2_0_16;
                blend1_g_1_1_by_3_17 <= blend1_g_1_1_by_3_16;
                blend1_g_1_1_sum_2_0_17 <= blend1_g_1_1_sum_2_0_16;
                blend1_b_1_0_by_3_17 <= blend1_b_1_0_by_3_16;
                blend1_b_1_0_sum_2_0_17 <= blend1_b_1_0_sum_2_0_16;
                blend1_b_1_1_by_3_17 <= blend1_b_1_1_by_3_16;
                blend1_b_1_1_sum_2_0_17 <= blend1_b_1_1_sum_2_0_16;
            end if;
        end if;
    end process;

    -- ===== Stage 17: blend1_r_1_0, blend1_r_1_1, blend1_r_2_0_either_first and 18 more
    -- UQ0.12: two neighbours
    blend1_r_1_0_17 <=
        resize(blend1_r_1_0_sum_2_0_17, 12) + shift_left(resize(blend1_r_1_0_by_3_17, 12), 3);
    -- UQ0.12: two neighbours
    blend1_r_1_1_17 <=
        resize(blend1_r_1_1_sum_2_0_17, 12) + shift_left(resize(blend1_r_1_1_by_3_17, 12), 3);
    -- UQ0.12: either of both
    blend1_r_2_0_either_first_17 <= blend1_r_1_1_17 when blend1_whole_17 = '1' else blend1_r_1_0_17;
    -- UQ-4.16: shifted
    blend1_r_2_0_by_first_17 <= blend1_r_2_0_either_first_17;
    -- UQ0.12: either of both
    blend1_r_2_0_either_0_17 <= blend1_r_1_1_17 when blend1_of_0_17 = '1' else blend1_r_1_0_17;
    -- UQ-4.16: shifted
    blend1_r_2_0_by_0_17 <= blend1_r_2_0_either_0_17;
    -- UQ0.12: either of both
    blend1_r_2_0_either_1_17 <= blend1_r_1_1_17 when blend1_of_1_17 = '1' else blend1_r_1_0_17;
    -- UQ-3.15: shifted
    blend1_r_2_0_by_1_17 <= blend1_r_2_0_either_1_17;
    -- UQ0.12: either of both
    blend1_r_2_0_either_2_17 <= blend1_r_1_1_17 when blend1_of_2_17 = '1' else blend1_r_1_0_17;
    -- UQ-2.14: shifted
    blend1_r_2_0_by_2_17 <= blend1_r_2_0_either_2_17;
    -- UQ0.12: either of both
    blend1_r_2_0_either_3_17 <= blend1_r_1_1_17 when blend1_of_3_17 = '1' else blend1_r_1_0_17;
    -- UQ-1.13: shifted
    blend1_r_2_0_by_3_17 <= blend1_r_2_0_either_3_17;
    -- UQ0.12: two neighbours
    blend1_g_1_0_17 <=
        resize(blend1_g_1_0_sum_2_0_17, 12) + shift_left(resize(blend1_g_1_0_by_3_17, 12), 3);
    -- UQ0.12: two neighbours
    blend1_g_1_1_17 <=
        resize(blend1_g_1_1_sum_2_0_17, 12) + shift_left(resize(blend1_g_1_1_by_3_17, 12), 3);
    -- UQ0.12: either of both
    blend1_g_2_0_either_first_17 <= blend1_g_1_1_17 when blend1_whole_17 = '1' else blend1_g_1_0_17;
    -- UQ-4.16: shifted
    blend1_g_2_0_by_first_17 <= blend1_g_2_0_either_first_17;
    -- UQ0.12: either of both
    blend1_g_2_0_either_0_17 <= blend1_g_1_1_17 when blend1_of_0_17 = '1' else blend1_g_1_0_17;
    -- UQ-4.16: shifted
    blend1_g_2_0_by_0_17 <= blend1_g_2_0_either_0_17;
    -- UQ0.12: either of both
    blend1_g_2_0_either_1_17 <= blend1_g_1_1_17 when blend1_of_1_17 = '1' else blend1_g_1_0_17;
    -- UQ-3.15: shifted
    blend1_g_2_0_by_1_17 <= blend1_g_2_0_either_1_17;
    -- UQ0.12: either of both
    blend1_g_2_0_either_2_17 <= blend1_g_1_1_17 when blend1_of_2_17 = '1' else blend1_g_1_0_17;
    -- UQ-2.14: shifted
    blend1_g_2_0_by_2_17 <= blend1_g_2_0_either_2_17;
    -- UQ0.12: either of both
    blend1_g_2_0_either_3_17 <= blend1_g_1_1_17 when blend1_of_3_17 = '1' else blend1_g_1_0_17;
    -- UQ-1.13: shifted
    blend1_g_2_0_by_3_17 <= blend1_g_2_0_either_3_17;
    -- UQ0.12: two neighbours
    blend1_b_1_0_17 <=
        resize(blend1_b_1_0_sum_2_0_17, 12) + shift_left(resize(blend1_b_1_0_by_3_17, 12), 3);
    -- UQ0.12: two neighbours
    blend1_b_1_1_17 <=
        resize(blend1_b_1_1_sum_2_0_17, 12) + shift_left(resize(blend1_b_1_1_by_3_17, 12), 3);
    -- UQ0.12: either of both
    blend1_b_2_0_either_first_17 <= blend1_b_1_1_17 when blend1_whole_17 = '1' else blend1_b_1_0_17;
    -- UQ-4.16: shifted
    blend1_b_2_0_by_first_17 <= blend1_b_2_0_either_first_17;
    -- UQ0.12: either of both
    blend1_b_2_0_either_0_17 <= blend1_b_1_1_17 when blend1_of_0_17 = '1' else blend1_b_1_0_17;
    -- UQ-4.16: shifted
    blend1_b_2_0_by_0_17 <= blend1_b_2_0_either_0_17;
    -- UQ0.12: either of both
    blend1_b_2_0_either_1_17 <= blend1_b_1_1_17 when blend1_of_1_17 = '1' else blend1_b_1_0_17;
    -- UQ-3.15: shifted
    blend1_b_2_0_by_1_17 <= blend1_b_2_0_either_1_17;
    -- UQ0.12: either of both
    blend1_b_2_0_either_2_17 <= blend1_b_1_1_17 when blend1_of_2_17 = '1' else blend1_b_1_0_17;
    -- UQ-2.14: shifted
    blend1_b_2_0_by_2_17 <= blend1_b_2_0_either_2_17;
    -- UQ0.12: either of both
    blend1_b_2_0_either_3_17 <= blend1_b_1_1_17 when blend1_of_3_17 = '1' else blend1_b_1_0_17;
    -- UQ-1.13: shifted
    blend1_b_2_0_by_3_17 <= blend1_b_2_0_either_3_17;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_18 <= in_gain1r_17;
                in_gain1g_18 <= in_gain1g_17;
                in_gain1b_18 <= in_gain1b_17;
                nl1_18 <= nl1_17;
                blend1_r_2_0_by_first_18 <= blend1_r_2_0_by_first_17;
                blend1_r_2_0_by_0_18 <= blend1_r_2_0_by_0_17;
                blend1_r_2_0_by_1_18 <= blend1_r_2_0_by_1_17;
                blend1_r_2_0_by_2_18 <= blend1_r_2_0_by_2_17;
                blend1_r_2_0_by_3_18 <= blend1_r_2_0_by_3_17;
                blend1_g_2_0_by_first_18 <= blend1_g_2_0_by_first_17;
                blend1_g_2_0_by_0_18 <= blend1_g_2_0_by_0_17;
                blend1_g_2_0_by_1_18 <= blend1_g_2_0_by_1_17;
                blend1_g_2_0_by_2_18 <= blend1_g_2_0_by_2_17;
                blend1_g_2_0_by_3_18 <= blend1_g_2_0_by_3_17;
                blend1_b_2_0_by_first_18 <= blend1_b_2_0_by_first_17;
                blend1_b_2_0_by_0_18 <= blend1_b_2_0_by_0_17;
                blend1_b_2_0_by_1_18 <= blend1_b_2_0_by_1_17;
                blend1_b_2_0_by_2_18 <= blend1_b_2_0_by_2_17;
                blend1_b_2_0_by_3_18 <= blend1_b_2_0_by_3_17;
            end if;
        end if;
    end process;

    -- ===== Stage 18: blend1_r_2_0_sum_1_0, blend1_r_2_0_sum_1_1 and 4 more
    -- UQ-3.16: the sum of two
    blend1_r_2_0_sum_1_0_18 <=
        resize(blend1_r_2_0_by_first_18, 13) + resize(blend1_r_2_0_by_0_18, 13);
    -- UQ-1.15: the sum of two
    blend1_r_2_0_sum_1_1_18 <=
        resize(blend1_r_2_0_by_1_18, 14) + shift_left(resize(blend1_r_2_0_by_2_18, 14), 1);
    -- UQ-3.16: the sum of two
    blend1_g_2_0_sum_1_0_18 <=
        resize(blend1_g_2_0_by_first_18, 13) + resize(blend1_g_2_0_by_0_18, 13);
    -- UQ-1.15: the sum of two
    blend1_g_2_0_sum_1_1_18 <=
        resize(blend1_g_2_0_by_1_18, 14) + shift_left(resize(blend1_g_2_0_by_2_18, 14), 1);
    -- UQ-3.16: the sum of two
    blend1_b_2_0_sum_1_0_18 <=
        resize(blend1_b_2_0_by_first_18, 13) + resize(blend1_b_2_0_by_0_18, 13);
    -- UQ-1.15: the sum of two
    blend1_b_2_0_sum_1_1_18 <=
        resize(blend1_b_2_0_by_1_18, 14) + shift_left(resize(blend1_b_2_0_by_2_18, 14), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_19 <= in_gain1r_18;
                in_gain1g_19 <= in_gain1g_18;
                in_gain1b_19 <= in_gain1b_18;
                nl1_19 <= nl1_18;
                blend1_r_2_0_by_3_19 <= blend1_r_2_0_by_3_18;
                blend1_r_2_0_sum_1_0_19 <= blend1_r_2_0_sum_1_0_18;
                blend1_r_2_0_sum_1_1_19 <= blend1_r_2_0_sum_1_1_18;
                blend1_g_2_0_by_3_19 <= blend1_g_2_0_by_3_18;
                blend1_g_2_0_sum_1_0_19 <= blend1_g_2_0_sum_1_0_18;
                blend1_g_2_0_sum_1_1_19 <= blend1_g_2_0_sum_1_1_18;
                blend1_b_2_0_by_3_19 <= blend1_b_2_0_by_3_18;
                blend1_b_2_0_sum_1_0_19 <= blend1_b_2_0_sum_1_0_18;
                blend1_b_2_0_sum_1_1_19 <= blend1_b_2_0_sum_1_1_18;
            end if;
        end if;
    end process;

    -- ===== Stage 19: blend1_r_2_0_sum_2_0, blend1_g_2_0_sum_2_0 and 1 more
    -- UQ-1.16: the sum of two
    blend1_r_2_0_sum_2_0_19 <=
        resize(blend1_r_2_0_sum_1_0_19, 15) + shift_left(resize(blend1_r_2_0_sum_1_1_19, 15), 1);
    -- UQ-1.16: the sum of two
    blend1_g_2_0_sum_2_0_19 <=
        resize(blend1_g_2_0_sum_1_0_19, 15) + shift_left(resize(blend1_g_2_0_sum_1_1_19, 15), 1);
    -- UQ-1.16: the sum of two
    blend1_b_2_0_sum_2_0_19 <=
        resize(blend1_b_2_0_sum_1_0_19, 15) + shift_left(resize(blend1_b_2_0_sum_1_1_19, 15), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_20 <= in_gain1r_19;
                in_gain1g_20 <= in_gain1g_19;
                in_gain1b_20 <= in_gain1b_19;
                nl1_20 <= nl1_19;
                blend1_r_2_0_by_3_20 <= blend1_r_2_0_by_3_19;
                blend1_r_2_0_sum_2_0_20 <= blend1_r_2_0_sum_2_0_19;
                blend1_g_2_0_by_3_20 <= blend1_g_2_0_by_3_19;
                blend1_g_2_0_sum_2_0_20 <= blend1_g_2_0_sum_2_0_19;
                blend1_b_2_0_by_3_20 <= blend1_b_2_0_by_3_19;
                blend1_b_2_0_sum_2_0_20 <= blend1_b_2_0_sum_2_0_19;
            end if;
        end if;
    end process;

    -- ===== Stage 20: blend1_r_2_0, blend1_g_2_0, blend1_b_2_0
    -- UQ0.16: two bands
    blend1_r_2_0_20 <=
        resize(blend1_r_2_0_sum_2_0_20, 16) + shift_left(resize(blend1_r_2_0_by_3_20, 16), 3);
    -- UQ0.16: two bands
    blend1_g_2_0_20 <=
        resize(blend1_g_2_0_sum_2_0_20, 16) + shift_left(resize(blend1_g_2_0_by_3_20, 16), 3);
    -- UQ0.16: two bands
    blend1_b_2_0_20 <=
        resize(blend1_b_2_0_sum_2_0_20, 16) + shift_left(resize(blend1_b_2_0_by_3_20, 16), 3);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_21 <= in_gain1r_20;
                in_gain1g_21 <= in_gain1g_20;
                in_gain1b_21 <= in_gain1b_20;
                nl1_21 <= nl1_20;
                blend1_r_2_0_21 <= blend1_r_2_0_20;
                blend1_g_2_0_21 <= blend1_g_2_0_20;
                blend1_b_2_0_21 <= blend1_b_2_0_20;
            end if;
        end if;
    end process;

    -- ===== Stage 21: square1_r_exact, square1_g_exact, square1_b_exact
    -- UQ0.32: its square
    square1_r_exact_21 <= blend1_r_2_0_21 * blend1_r_2_0_21;
    -- UQ0.18: rounded down
    square1_r_21 <= square1_r_exact_21(31 downto 14);
    -- UQ0.32: its square
    square1_g_exact_21 <= blend1_g_2_0_21 * blend1_g_2_0_21;
    -- UQ0.18: rounded down
    square1_g_21 <= square1_g_exact_21(31 downto 14);
    -- UQ0.32: its square
    square1_b_exact_21 <= blend1_b_2_0_21 * blend1_b_2_0_21;
    -- UQ0.18: rounded down
    square1_b_21 <= square1_b_exact_21(31 downto 14);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_22 <= in_gain1r_21;
                in_gain1g_22 <= in_gain1g_21;
                in_gain1b_22 <= in_gain1b_21;
                nl1_22 <= nl1_21;
                square1_r_22 <= square1_r_21;
                square1_g_22 <= square1_g_21;
                square1_b_22 <= square1_b_21;
            end if;
        end if;
    end process;

    -- ===== Stage 22: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_23 <= in_gain1r_22;
                in_gain1g_23 <= in_gain1g_22;
                in_gain1b_23 <= in_gain1b_22;
                nl1_23 <= nl1_22;
                square1_r_23 <= square1_r_22;
                square1_g_23 <= square1_g_22;
                square1_b_23 <= square1_b_22;
            end if;
        end if;
    end process;

    -- ===== Stage 23: lit1_r_exact, lit1_g_exact, lit1_b_exact
    -- UQ7.29: n.l times the square
    lit1_r_exact_23 <= nl1_23 * square1_r_23;
    -- UQ7.11: rounded down
    lit1_r_23 <= lit1_r_exact_23(35 downto 18);
    -- UQ7.29: n.l times the square
    lit1_g_exact_23 <= nl1_23 * square1_g_23;
    -- UQ7.11: rounded down
    lit1_g_23 <= lit1_g_exact_23(35 downto 18);
    -- UQ7.29: n.l times the square
    lit1_b_exact_23 <= nl1_23 * square1_b_23;
    -- UQ7.11: rounded down
    lit1_b_23 <= lit1_b_exact_23(35 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_24 <= in_gain1r_23;
                in_gain1g_24 <= in_gain1g_23;
                in_gain1b_24 <= in_gain1b_23;
                lit1_r_24 <= lit1_r_23;
                lit1_g_24 <= lit1_g_23;
                lit1_b_24 <= lit1_b_23;
            end if;
        end if;
    end process;

    -- ===== Stage 24: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_25 <= in_gain1r_24;
                in_gain1g_25 <= in_gain1g_24;
                in_gain1b_25 <= in_gain1b_24;
                lit1_r_25 <= lit1_r_24;
                lit1_g_25 <= lit1_g_24;
                lit1_b_25 <= lit1_b_24;
            end if;
        end if;
    end process;

    -- ===== Stage 25: light1_r_exact, light1_g_exact, light1_b_exact
    -- UQ8.28: times the gain
    light1_r_exact_25 <= lit1_r_25 * in_gain1r_25;
    -- UQ8.17: rounded down
    light1_r_25 <= light1_r_exact_25(35 downto 11);
    -- UQ8.28: times the gain
    light1_g_exact_25 <= lit1_g_25 * in_gain1g_25;
    -- UQ8.17: rounded down
    light1_g_25 <= light1_g_exact_25(35 downto 11);
    -- UQ8.28: times the gain
    light1_b_exact_25 <= lit1_b_25 * in_gain1b_25;
    -- UQ8.17: rounded down
    light1_b_25 <= light1_b_exact_25(35 downto 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                light1_r_26 <= light1_r_25;
                light1_g_26 <= light1_g_25;
                light1_b_26 <= light1_b_25;
            end if;
        end if;
    end process;

    -- ===== Stage 26: sum_r, sum_g, sum_b
    -- UQ1.17: kept at 1.0
    sum_r_26 <= (17 => '1', others => '0') when unsigned(light1_r_26(24 downto 17)) /= 0 else
        light1_r_26(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_g_26 <= (17 => '1', others => '0') when unsigned(light1_g_26(24 downto 17)) /= 0 else
        light1_g_26(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_b_26 <= (17 => '1', others => '0') when unsigned(light1_b_26(24 downto 17)) /= 0 else
        light1_b_26(17 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sum_r_27 <= sum_r_26;
                sum_g_27 <= sum_g_26;
                sum_b_27 <= sum_b_26;
            end if;
        end if;
    end process;

    out_valid <= valid(27);
    out_sum_r <= sum_r_27;
    out_sum_g <= sum_g_27;
    out_sum_b <= sum_b_27;

end architecture rtl;
