-- image_half: image-based block of ggx (half, 16 slices of 32 x 32 texels), 1 light a clock, 8 bits a channel
--
-- Made by: brdfgen generate core.toml
-- Spec 2d84489c342361ed. Generated; the core is yours to use under any terms.
--
--   in_nx     Q1.16   x of the unit normal, the viewer at +z
--   in_ny     Q1.16   y of the unit normal, the viewer at +z
--   in_nz     Q1.16   z of the unit normal, the viewer at +z
--   in_l1x    Q1.16   x of the unit vector to light 1
--   in_l1y    Q1.16   y of the unit vector to light 1
--   in_l1z    Q1.16   z of the unit vector to light 1
--   in_u1x    Q1.16   x of row 1 of the turn to light 1's half vector
--   in_u1y    Q1.16   y of row 1 of the turn to light 1's half vector
--   in_u1z    Q1.16   z of row 1 of the turn to light 1's half vector
--   in_v1x    Q1.16   x of row 2 of the turn to light 1's half vector
--   in_v1y    Q1.16   y of row 2 of the turn to light 1's half vector
--   in_band1  UQ4.0   slice of texels below light 1's angle
--   in_blend1 UQ1.6   weight of the odd one of this slice and the next, at most 1
--   in_shift1 UQ4.0   exponent of light 1's gain
--   in_gain1r UQ0.18  red of light 1's gain
--   in_gain1g UQ0.18  green of light 1's gain
--   in_gain1b UQ0.18  blue of light 1's gain
--   out_sum_r UQ1.17  red of these lights, at most 1.0
--   out_sum_g UQ1.17  green of these lights, at most 1.0
--   out_sum_b UQ1.17  blue of these lights, at most 1.0
--
-- Latency 22 clocks, one result a clock.
-- Pictures of a sphere against the exact reflectance, lit from 34 angles:
--   49.9 dB in the mean, 44.7 dB at the worst angle.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity image_half is
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
        -- UQ1.6: weight of the odd one of this slice and the next, at most 1
        in_blend1 : in  unsigned(6 downto 0);
        -- UQ4.0: exponent of light 1's gain
        in_shift1 : in  unsigned(3 downto 0);
        -- UQ0.18: red of light 1's gain
        in_gain1r : in  unsigned(17 downto 0);
        -- UQ0.18: green of light 1's gain
        in_gain1g : in  unsigned(17 downto 0);
        -- UQ0.18: blue of light 1's gain
        in_gain1b : in  unsigned(17 downto 0);
        -- the other outputs are a result: in_valid, 22 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.17: red of these lights, at most 1.0
        out_sum_r : out unsigned(17 downto 0);
        -- UQ1.17: green of these lights, at most 1.0
        out_sum_g : out unsigned(17 downto 0);
        -- UQ1.17: blue of these lights, at most 1.0
        out_sum_b : out unsigned(17 downto 0)
    );
end entity image_half;

architecture rtl of image_half is
    -- ===== The memory texels_1_even_even_even
    type texels_1_even_even_even_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_even_even(path : string) return texels_1_even_even_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_even_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_EVEN_EVEN : texels_1_even_even_even_t := read_texels_1_even_even_even(TEXELS_1_EVEN_EVEN_EVEN_FILE);
    signal texels_1_even_even_even_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_even_odd
    type texels_1_even_even_odd_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_even_odd(path : string) return texels_1_even_even_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_even_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_EVEN_ODD : texels_1_even_even_odd_t := read_texels_1_even_even_odd(TEXELS_1_EVEN_EVEN_ODD_FILE);
    signal texels_1_even_even_odd_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_odd_even
    type texels_1_even_odd_even_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_odd_even(path : string) return texels_1_even_odd_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_odd_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_ODD_EVEN : texels_1_even_odd_even_t := read_texels_1_even_odd_even(TEXELS_1_EVEN_ODD_EVEN_FILE);
    signal texels_1_even_odd_even_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_odd_odd
    type texels_1_even_odd_odd_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_even_odd_odd(path : string) return texels_1_even_odd_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_even_odd_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_ODD_ODD : texels_1_even_odd_odd_t := read_texels_1_even_odd_odd(TEXELS_1_EVEN_ODD_ODD_FILE);
    signal texels_1_even_odd_odd_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_even_even
    type texels_1_odd_even_even_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_even_even(path : string) return texels_1_odd_even_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_even_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_EVEN_EVEN : texels_1_odd_even_even_t := read_texels_1_odd_even_even(TEXELS_1_ODD_EVEN_EVEN_FILE);
    signal texels_1_odd_even_even_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_even_odd
    type texels_1_odd_even_odd_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_even_odd(path : string) return texels_1_odd_even_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_even_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_EVEN_ODD : texels_1_odd_even_odd_t := read_texels_1_odd_even_odd(TEXELS_1_ODD_EVEN_ODD_FILE);
    signal texels_1_odd_even_odd_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_odd_even
    type texels_1_odd_odd_even_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_odd_even(path : string) return texels_1_odd_odd_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_odd_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_ODD_EVEN : texels_1_odd_odd_even_t := read_texels_1_odd_odd_even(TEXELS_1_ODD_ODD_EVEN_FILE);
    signal texels_1_odd_odd_even_7 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_odd_odd
    type texels_1_odd_odd_odd_t is array (2047 downto 0) of
        std_logic_vector(23 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_texels_1_odd_odd_odd(path : string) return texels_1_odd_odd_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(23 downto 0);
        variable result : texels_1_odd_odd_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 2048 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 2048 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_ODD_ODD : texels_1_odd_odd_odd_t := read_texels_1_odd_odd_odd(TEXELS_1_ODD_ODD_ODD_FILE);
    signal texels_1_odd_odd_odd_7 : std_logic_vector(23 downto 0) := (others => '0');

    signal valid : std_logic_vector(22 downto 1) := (others => '0');
    signal nz_kept_0 : unsigned(16 downto 0) := (others => '0');
    signal seen_0 : std_logic := '0';
    signal hidden_0 : std_logic := '0';
    signal shift1_0 : unsigned(3 downto 0) := (others => '0');
    signal nl1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_x_0 : signed(26 downto 0) := (others => '0');
    signal nl1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_y_0 : signed(26 downto 0) := (others => '0');
    signal nl1_z_exact_0 : signed(35 downto 0) := (others => '0');
    signal nl1_z_0 : signed(26 downto 0) := (others => '0');
    signal blend1_0 : unsigned(6 downto 0) := (others => '0');
    signal band1_next_exact_0 : unsigned(4 downto 0) := (others => '0');
    signal band1_next_0 : unsigned(3 downto 0) := (others => '0');
    signal band1_even_high_0 : unsigned(2 downto 0) := (others => '0');
    signal band1_even_0 : unsigned(2 downto 0) := (others => '0');
    signal band1_odd_high_0 : unsigned(2 downto 0) := (others => '0');
    signal band1_odd_0 : unsigned(2 downto 0) := (others => '0');
    signal v1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_x_0 : signed(16 downto 0) := (others => '0');
    signal v1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_y_0 : signed(16 downto 0) := (others => '0');
    signal u1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_x_0 : signed(16 downto 0) := (others => '0');
    signal u1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_y_0 : signed(16 downto 0) := (others => '0');
    signal u1_z_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_z_0 : signed(16 downto 0) := (others => '0');
    signal texels1_00_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_0 : signed(7 downto 0) := (others => '0');
    signal in_gain1r_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_1 : unsigned(17 downto 0) := (others => '0');
    signal hidden_1 : std_logic := '0';
    signal shift1_1 : unsigned(3 downto 0) := (others => '0');
    signal nl1_x_1 : signed(26 downto 0) := (others => '0');
    signal nl1_y_1 : signed(26 downto 0) := (others => '0');
    signal nl1_z_1 : signed(26 downto 0) := (others => '0');
    signal v1_x_1 : signed(16 downto 0) := (others => '0');
    signal v1_y_1 : signed(16 downto 0) := (others => '0');
    signal u1_x_1 : signed(16 downto 0) := (others => '0');
    signal u1_y_1 : signed(16 downto 0) := (others => '0');
    signal u1_z_1 : signed(16 downto 0) := (others => '0');
    signal texels1_00_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_1 : signed(7 downto 0) := (others => '0');
    signal nl1_xy_1 : signed(27 downto 0) := (others => '0');
    signal v1_xy_1 : signed(17 downto 0) := (others => '0');
    signal v1_scaled_1 : signed(17 downto 0) := (others => '0');
    signal u1_xy_1 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_2 : unsigned(17 downto 0) := (others => '0');
    signal hidden_2 : std_logic := '0';
    signal shift1_2 : unsigned(3 downto 0) := (others => '0');
    signal nl1_z_2 : signed(26 downto 0) := (others => '0');
    signal nl1_xy_2 : signed(27 downto 0) := (others => '0');
    signal v1_scaled_2 : signed(17 downto 0) := (others => '0');
    signal u1_z_2 : signed(16 downto 0) := (others => '0');
    signal u1_xy_2 : signed(17 downto 0) := (others => '0');
    signal texels1_00_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_2 : signed(7 downto 0) := (others => '0');
    signal nl1_xyz_2 : signed(27 downto 0) := (others => '0');
    signal nl1_cut_2 : signed(25 downto 0) := (others => '0');
    signal nl1_kept_2 : unsigned(20 downto 0) := (others => '0');
    signal v1_place_2 : signed(17 downto 0) := (others => '0');
    signal v1_cut_2 : signed(14 downto 0) := (others => '0');
    signal v1_kept_2 : unsigned(10 downto 0) := (others => '0');
    signal v1_texel_2 : unsigned(4 downto 0) := (others => '0');
    signal v1_weight_2 : unsigned(5 downto 0) := (others => '0');
    signal v1_odd_high_2 : unsigned(3 downto 0) := (others => '0');
    signal v1_odd_2 : unsigned(3 downto 0) := (others => '0');
    signal v1_is_odd_2 : std_logic := '0';
    signal v1_weight_wide_2 : unsigned(6 downto 0) := (others => '0');
    signal u1_xyz_2 : signed(17 downto 0) := (others => '0');
    signal u1_scaled_2 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_3 : unsigned(17 downto 0) := (others => '0');
    signal hidden_3 : std_logic := '0';
    signal shift1_3 : unsigned(3 downto 0) := (others => '0');
    signal nl1_kept_3 : unsigned(20 downto 0) := (others => '0');
    signal v1_texel_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_weight_3 : unsigned(5 downto 0) := (others => '0');
    signal v1_odd_3 : unsigned(3 downto 0) := (others => '0');
    signal v1_is_odd_3 : std_logic := '0';
    signal v1_weight_wide_3 : unsigned(6 downto 0) := (others => '0');
    signal u1_scaled_3 : signed(17 downto 0) := (others => '0');
    signal texels1_00_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_3 : signed(7 downto 0) := (others => '0');
    signal nl1_up_3 : unsigned(30 downto 0) := (others => '0');
    signal nl1_up_cut_3 : unsigned(20 downto 0) := (others => '0');
    signal nl1_within_3 : unsigned(18 downto 0) := (others => '0');
    signal nl1_3 : unsigned(18 downto 0) := (others => '0');
    signal v1_next_exact_3 : unsigned(5 downto 0) := (others => '0');
    signal v1_next_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_even_high_3 : unsigned(3 downto 0) := (others => '0');
    signal v1_even_3 : unsigned(3 downto 0) := (others => '0');
    signal v1_other_3 : unsigned(6 downto 0) := (others => '0');
    signal v1_odd_v2_3 : unsigned(6 downto 0) := (others => '0');
    signal u1_place_3 : signed(17 downto 0) := (others => '0');
    signal u1_cut_3 : signed(14 downto 0) := (others => '0');
    signal u1_kept_3 : unsigned(10 downto 0) := (others => '0');
    signal u1_texel_3 : unsigned(4 downto 0) := (others => '0');
    signal u1_weight_3 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_high_3 : unsigned(3 downto 0) := (others => '0');
    signal u1_odd_3 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_3 : std_logic := '0';
    signal u1_weight_wide_3 : unsigned(6 downto 0) := (others => '0');
    signal texel1_01_3 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_3 : unsigned(6 downto 0) := (others => '0');
    signal texel1_01_v2_3 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_3 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_3 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_3 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_v2_3 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_3 : unsigned(6 downto 0) := (others => '0');
    signal v1_odd_signed_3 : signed(7 downto 0) := (others => '0');
    signal in_gain1r_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_4 : unsigned(17 downto 0) := (others => '0');
    signal nl1_4 : unsigned(18 downto 0) := (others => '0');
    signal v1_even_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_texel_4 : unsigned(4 downto 0) := (others => '0');
    signal u1_weight_4 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_4 : std_logic := '0';
    signal u1_weight_wide_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_00_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_010_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_10_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_110_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_4 : unsigned(6 downto 0) := (others => '0');
    signal v1_odd_signed_4 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_4 : signed(7 downto 0) := (others => '0');
    signal u1_next_exact_4 : unsigned(5 downto 0) := (others => '0');
    signal u1_next_4 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_high_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_even_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_other_4 : unsigned(6 downto 0) := (others => '0');
    signal u1_odd_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_00_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_000_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_00_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_4 : unsigned(10 downto 0) := (others => '0');
    signal texel1_10_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_10_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_4 : unsigned(10 downto 0) := (others => '0');
    signal u1_odd_signed_4 : signed(7 downto 0) := (others => '0');
    signal in_gain1r_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_5 : unsigned(17 downto 0) := (others => '0');
    signal nl1_5 : unsigned(18 downto 0) := (others => '0');
    signal u1_even_5 : unsigned(3 downto 0) := (others => '0');
    signal u1_odd_5 : unsigned(3 downto 0) := (others => '0');
    signal texels1_000_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_5 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_5 : unsigned(10 downto 0) := (others => '0');
    signal texels1_100_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_5 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_5 : unsigned(10 downto 0) := (others => '0');
    signal u1_odd_signed_5 : signed(7 downto 0) := (others => '0');
    signal v1_odd_signed_5 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_5 : signed(7 downto 0) := (others => '0');
    signal texel1_000_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_001_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_010_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_100_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_101_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_110_5 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_6 : unsigned(17 downto 0) := (others => '0');
    signal nl1_6 : unsigned(18 downto 0) := (others => '0');
    signal texel1_000_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_001_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_010_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_011_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_100_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_101_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_110_6 : unsigned(10 downto 0) := (others => '0');
    signal texel1_111_6 : unsigned(10 downto 0) := (others => '0');
    signal u1_odd_signed_6 : signed(7 downto 0) := (others => '0');
    signal v1_odd_signed_6 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_6 : signed(7 downto 0) := (others => '0');
    signal in_gain1r_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_7 : unsigned(17 downto 0) := (others => '0');
    signal nl1_7 : unsigned(18 downto 0) := (others => '0');
    signal u1_odd_signed_7 : signed(7 downto 0) := (others => '0');
    signal v1_odd_signed_7 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_7 : signed(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_7 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_7 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_8 : unsigned(17 downto 0) := (others => '0');
    signal nl1_8 : unsigned(18 downto 0) := (others => '0');
    signal texels_1_even_even_even_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_8 : unsigned(7 downto 0) := (others => '0');
    signal u1_odd_signed_8 : signed(7 downto 0) := (others => '0');
    signal v1_odd_signed_8 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_8 : signed(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_8 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_8 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_9 : unsigned(17 downto 0) := (others => '0');
    signal nl1_9 : unsigned(18 downto 0) := (others => '0');
    signal texels_1_even_even_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal u1_odd_signed_9 : signed(7 downto 0) := (others => '0');
    signal v1_odd_signed_9 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_9 : signed(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_9 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_1_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_2_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_3_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_0_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_1_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_2_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_3_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_0_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_1_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_2_apart_9 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_3_apart_9 : signed(8 downto 0) := (others => '0');
    signal in_gain1r_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_10 : unsigned(17 downto 0) := (others => '0');
    signal nl1_10 : unsigned(18 downto 0) := (others => '0');
    signal texels_1_even_even_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_apart_10 : signed(8 downto 0) := (others => '0');
    signal u1_odd_signed_10 : signed(7 downto 0) := (others => '0');
    signal blend1_r_1_1_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_2_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_3_apart_10 : signed(8 downto 0) := (others => '0');
    signal v1_odd_signed_10 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_10 : signed(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_1_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_2_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_g_1_3_apart_10 : signed(8 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_1_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_2_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_b_1_3_apart_10 : signed(8 downto 0) := (others => '0');
    signal blend1_r_1_0_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_1_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_2_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_3_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_0_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_1_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_2_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_3_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_0_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_1_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_2_part_10 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_3_part_10 : signed(16 downto 0) := (others => '0');
    signal in_gain1r_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_11 : unsigned(17 downto 0) := (others => '0');
    signal nl1_11 : unsigned(18 downto 0) := (others => '0');
    signal texels_1_even_even_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_1_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_2_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_3_part_11 : signed(16 downto 0) := (others => '0');
    signal v1_odd_signed_11 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_11 : signed(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_1_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_2_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_g_1_3_part_11 : signed(16 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_1_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_2_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_b_1_3_part_11 : signed(16 downto 0) := (others => '0');
    signal blend1_r_1_0_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_1_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_2_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_3_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_0_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_1_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_2_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_3_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_0_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_1_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_2_11 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_3_11 : unsigned(13 downto 0) := (others => '0');
    signal in_gain1r_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_12 : unsigned(17 downto 0) := (others => '0');
    signal nl1_12 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_1_0_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_1_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_2_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_3_12 : unsigned(13 downto 0) := (others => '0');
    signal v1_odd_signed_12 : signed(7 downto 0) := (others => '0');
    signal blend1_signed_12 : signed(7 downto 0) := (others => '0');
    signal blend1_g_1_0_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_1_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_2_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_3_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_0_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_1_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_2_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_3_12 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_apart_12 : signed(14 downto 0) := (others => '0');
    signal blend1_r_2_1_apart_12 : signed(14 downto 0) := (others => '0');
    signal blend1_g_2_0_apart_12 : signed(14 downto 0) := (others => '0');
    signal blend1_g_2_1_apart_12 : signed(14 downto 0) := (others => '0');
    signal blend1_b_2_0_apart_12 : signed(14 downto 0) := (others => '0');
    signal blend1_b_2_1_apart_12 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_13 : unsigned(17 downto 0) := (others => '0');
    signal nl1_13 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_1_0_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_2_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_apart_13 : signed(14 downto 0) := (others => '0');
    signal v1_odd_signed_13 : signed(7 downto 0) := (others => '0');
    signal blend1_r_2_1_apart_13 : signed(14 downto 0) := (others => '0');
    signal blend1_signed_13 : signed(7 downto 0) := (others => '0');
    signal blend1_g_1_0_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_2_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_apart_13 : signed(14 downto 0) := (others => '0');
    signal blend1_g_2_1_apart_13 : signed(14 downto 0) := (others => '0');
    signal blend1_b_1_0_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_2_13 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_apart_13 : signed(14 downto 0) := (others => '0');
    signal blend1_b_2_1_apart_13 : signed(14 downto 0) := (others => '0');
    signal blend1_r_2_0_part_13 : signed(22 downto 0) := (others => '0');
    signal blend1_r_2_1_part_13 : signed(22 downto 0) := (others => '0');
    signal blend1_g_2_0_part_13 : signed(22 downto 0) := (others => '0');
    signal blend1_g_2_1_part_13 : signed(22 downto 0) := (others => '0');
    signal blend1_b_2_0_part_13 : signed(22 downto 0) := (others => '0');
    signal blend1_b_2_1_part_13 : signed(22 downto 0) := (others => '0');
    signal in_gain1r_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_14 : unsigned(17 downto 0) := (others => '0');
    signal nl1_14 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_1_0_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_2_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_r_2_1_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_signed_14 : signed(7 downto 0) := (others => '0');
    signal blend1_g_1_0_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_2_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_g_2_1_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_b_1_0_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_2_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_b_2_1_part_14 : signed(22 downto 0) := (others => '0');
    signal blend1_r_2_0_14 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_2_1_14 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_2_0_14 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_2_1_14 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_0_14 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_1_14 : unsigned(19 downto 0) := (others => '0');
    signal in_gain1r_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_15 : unsigned(17 downto 0) := (others => '0');
    signal nl1_15 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_2_0_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_2_1_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_signed_15 : signed(7 downto 0) := (others => '0');
    signal blend1_g_2_0_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_2_1_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_0_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_1_15 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_3_0_apart_15 : signed(20 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_15 : signed(20 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_15 : signed(20 downto 0) := (others => '0');
    signal in_gain1r_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_16 : unsigned(17 downto 0) := (others => '0');
    signal nl1_16 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_2_0_16 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_3_0_apart_16 : signed(20 downto 0) := (others => '0');
    signal blend1_signed_16 : signed(7 downto 0) := (others => '0');
    signal blend1_g_2_0_16 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_16 : signed(20 downto 0) := (others => '0');
    signal blend1_b_2_0_16 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_16 : signed(20 downto 0) := (others => '0');
    signal blend1_r_3_0_part_16 : signed(28 downto 0) := (others => '0');
    signal blend1_g_3_0_part_16 : signed(28 downto 0) := (others => '0');
    signal blend1_b_3_0_part_16 : signed(28 downto 0) := (others => '0');
    signal in_gain1r_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_17 : unsigned(17 downto 0) := (others => '0');
    signal nl1_17 : unsigned(18 downto 0) := (others => '0');
    signal blend1_r_2_0_17 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_3_0_part_17 : signed(28 downto 0) := (others => '0');
    signal blend1_g_2_0_17 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_3_0_part_17 : signed(28 downto 0) := (others => '0');
    signal blend1_b_2_0_17 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_3_0_part_17 : signed(28 downto 0) := (others => '0');
    signal blend1_r_3_0_17 : unsigned(25 downto 0) := (others => '0');
    signal root1_r_17 : unsigned(17 downto 0) := (others => '0');
    signal blend1_g_3_0_17 : unsigned(25 downto 0) := (others => '0');
    signal root1_g_17 : unsigned(17 downto 0) := (others => '0');
    signal blend1_b_3_0_17 : unsigned(25 downto 0) := (others => '0');
    signal root1_b_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_18 : unsigned(17 downto 0) := (others => '0');
    signal nl1_18 : unsigned(18 downto 0) := (others => '0');
    signal root1_r_18 : unsigned(17 downto 0) := (others => '0');
    signal root1_g_18 : unsigned(17 downto 0) := (others => '0');
    signal root1_b_18 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_exact_18 : unsigned(35 downto 0) := (others => '0');
    signal square1_r_18 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_exact_18 : unsigned(35 downto 0) := (others => '0');
    signal square1_g_18 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_exact_18 : unsigned(35 downto 0) := (others => '0');
    signal square1_b_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_19 : unsigned(17 downto 0) := (others => '0');
    signal nl1_19 : unsigned(18 downto 0) := (others => '0');
    signal square1_r_19 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_19 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_19 : unsigned(17 downto 0) := (others => '0');
    signal lit1_r_exact_19 : unsigned(36 downto 0) := (others => '0');
    signal lit1_r_19 : unsigned(18 downto 0) := (others => '0');
    signal lit1_g_exact_19 : unsigned(36 downto 0) := (others => '0');
    signal lit1_g_19 : unsigned(18 downto 0) := (others => '0');
    signal lit1_b_exact_19 : unsigned(36 downto 0) := (others => '0');
    signal lit1_b_19 : unsigned(18 downto 0) := (others => '0');
    signal in_gain1r_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_20 : unsigned(17 downto 0) := (others => '0');
    signal lit1_r_20 : unsigned(18 downto 0) := (others => '0');
    signal lit1_g_20 : unsigned(18 downto 0) := (others => '0');
    signal lit1_b_20 : unsigned(18 downto 0) := (others => '0');
    signal light1_r_exact_20 : unsigned(36 downto 0) := (others => '0');
    signal light1_r_20 : unsigned(24 downto 0) := (others => '0');
    signal light1_g_exact_20 : unsigned(36 downto 0) := (others => '0');
    signal light1_g_20 : unsigned(24 downto 0) := (others => '0');
    signal light1_b_exact_20 : unsigned(36 downto 0) := (others => '0');
    signal light1_b_20 : unsigned(24 downto 0) := (others => '0');
    signal light1_r_21 : unsigned(24 downto 0) := (others => '0');
    signal light1_g_21 : unsigned(24 downto 0) := (others => '0');
    signal light1_b_21 : unsigned(24 downto 0) := (others => '0');
    signal sum_r_21 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_21 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_21 : unsigned(17 downto 0) := (others => '0');
    signal sum_r_22 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_22 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_22 : unsigned(17 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(21 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 8 more
    -- UQ1.16: n.v, not below 0
    nz_kept_0 <= (others => '0') when in_nz(17) = '1' else
        unsigned(in_nz(16 downto 0));
    -- UQ1.0: n.v > 0
    seen_0 <= '1' when nz_kept_0 /= 0 else '0';
    -- UQ1.0: the normal is turned away from the viewer
    hidden_0 <= not seen_0;
    -- UQ4.0: at most the greatest
    shift1_0 <= to_unsigned(10, 4) when in_shift1 > 10 else
        in_shift1;
    -- Q3.32: n.l
    nl1_x_exact_0 <= in_nx * in_l1x;
    -- Q3.23: rounded down
    nl1_x_0 <= nl1_x_exact_0(35 downto 9);
    -- Q3.32: n.l
    nl1_y_exact_0 <= in_ny * in_l1y;
    -- Q3.23: rounded down
    nl1_y_0 <= nl1_y_exact_0(35 downto 9);
    -- Q3.32: n.l
    nl1_z_exact_0 <= in_nz * in_l1z;
    -- Q3.23: rounded down
    nl1_z_0 <= nl1_z_exact_0(35 downto 9);
    -- UQ1.6: the weight of the odd band, at most 1
    blend1_0 <= (6 => '1', others => '0') when in_blend1(6) = '1' else
        in_blend1;
    -- UQ5.0: the next
    band1_next_exact_0 <= resize(in_band1, 5) + to_unsigned(1, 5);
    -- UQ4.0: at most the last
    band1_next_0 <= to_unsigned(15, 4) when band1_next_exact_0 > 15 else
        band1_next_exact_0(3 downto 0);
    -- UQ4.-1: its leading bits
    band1_even_high_0 <= band1_next_0(3 downto 1);
    -- UQ3.0: the even one of both
    band1_even_0 <= band1_even_high_0;
    -- UQ4.-1: its leading bits
    band1_odd_high_0 <= in_band1(3 downto 1);
    -- UQ3.0: the odd one of both
    band1_odd_0 <= band1_odd_high_0;
    -- Q3.32: the turned normal
    v1_x_exact_0 <= in_nx * in_v1x;
    -- Q3.13: rounded down
    v1_x_0 <= v1_x_exact_0(35 downto 19);
    -- Q3.32: the turned normal
    v1_y_exact_0 <= in_ny * in_v1y;
    -- Q3.13: rounded down
    v1_y_0 <= v1_y_exact_0(35 downto 19);
    -- Q3.32: the turned normal
    u1_x_exact_0 <= in_nx * in_u1x;
    -- Q3.13: rounded down
    u1_x_0 <= u1_x_exact_0(35 downto 19);
    -- Q3.32: the turned normal
    u1_y_exact_0 <= in_ny * in_u1y;
    -- Q3.13: rounded down
    u1_y_0 <= u1_y_exact_0(35 downto 19);
    -- Q3.32: the turned normal
    u1_z_exact_0 <= in_nz * in_u1z;
    -- Q3.13: rounded down
    u1_z_0 <= u1_z_exact_0(35 downto 19);
    -- UQ7.-4: the first of them
    texels1_00_0 <= band1_even_0;
    -- UQ7.-4: the first of them
    texels1_00_v2_0 <= band1_even_0;
    -- UQ7.-4: the first of them
    texels1_01_0 <= band1_even_0;
    -- UQ7.-4: the first of them
    texels1_01_v2_0 <= band1_even_0;
    -- UQ7.-4: the first of them
    texels1_10_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_10_v2_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_11_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_11_v2_0 <= band1_odd_0;
    -- Q1.6: a sign bit for the signed product
    blend1_signed_0 <= signed(resize(blend1_0, 8));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_1 <= in_gain1r;
                in_gain1g_1 <= in_gain1g;
                in_gain1b_1 <= in_gain1b;
                hidden_1 <= hidden_0;
                shift1_1 <= shift1_0;
                nl1_x_1 <= nl1_x_0;
                nl1_y_1 <= nl1_y_0;
                nl1_z_1 <= nl1_z_0;
                v1_x_1 <= v1_x_0;
                v1_y_1 <= v1_y_0;
                u1_x_1 <= u1_x_0;
                u1_y_1 <= u1_y_0;
                u1_z_1 <= u1_z_0;
                texels1_00_1 <= texels1_00_0;
                texels1_00_v2_1 <= texels1_00_v2_0;
                texels1_01_1 <= texels1_01_0;
                texels1_01_v2_1 <= texels1_01_v2_0;
                texels1_10_1 <= texels1_10_0;
                texels1_10_v2_1 <= texels1_10_v2_0;
                texels1_11_1 <= texels1_11_0;
                texels1_11_v2_1 <= texels1_11_v2_0;
                blend1_signed_1 <= blend1_signed_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: nl1_xy, v1_xy, u1_xy
    -- Q4.23: n.l
    nl1_xy_1 <= resize(nl1_x_1, 28) + resize(nl1_y_1, 28);
    -- Q4.13: the turned normal
    v1_xy_1 <= resize(v1_x_1, 18) + resize(v1_y_1, 18);
    -- Q8.9: in texels from the middle
    v1_scaled_1 <= v1_xy_1;
    -- Q4.13: the turned normal
    u1_xy_1 <= resize(u1_x_1, 18) + resize(u1_y_1, 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_2 <= in_gain1r_1;
                in_gain1g_2 <= in_gain1g_1;
                in_gain1b_2 <= in_gain1b_1;
                hidden_2 <= hidden_1;
                shift1_2 <= shift1_1;
                nl1_z_2 <= nl1_z_1;
                nl1_xy_2 <= nl1_xy_1;
                v1_scaled_2 <= v1_scaled_1;
                u1_z_2 <= u1_z_1;
                u1_xy_2 <= u1_xy_1;
                texels1_00_2 <= texels1_00_1;
                texels1_00_v2_2 <= texels1_00_v2_1;
                texels1_01_2 <= texels1_01_1;
                texels1_01_v2_2 <= texels1_01_v2_1;
                texels1_10_2 <= texels1_10_1;
                texels1_10_v2_2 <= texels1_10_v2_1;
                texels1_11_2 <= texels1_11_1;
                texels1_11_v2_2 <= texels1_11_v2_1;
                blend1_signed_2 <= blend1_signed_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: nl1_xyz, nl1_kept, v1_place, v1_kept, u1_xyz
    -- Q4.23: n.l
    nl1_xyz_2 <= nl1_xy_2 + resize(nl1_z_2, 28);
    -- Q4.21: rounded down
    nl1_cut_2 <= nl1_xyz_2(27 downto 2);
    -- UQ0.21: n.l, kept in [0, 1)
    nl1_kept_2 <= (others => '0') when nl1_cut_2(25) = '1' else
        to_unsigned(2097151, 21) when nl1_cut_2 > 2097151 else
        unsigned(nl1_cut_2(20 downto 0));
    -- Q8.9: from the first, plus half a weight's last bit
    v1_place_2 <= v1_scaled_2 + to_signed(7940, 18);
    -- Q8.6: rounded to the nearest weight
    v1_cut_2 <= v1_place_2(17 downto 3);
    -- UQ5.6: between the outermost centres
    v1_kept_2 <= (others => '0') when v1_cut_2(14) = '1' else
        to_unsigned(1984, 11) when v1_cut_2 > 1984 else
        unsigned(v1_cut_2(10 downto 0));
    -- UQ5.0: the texel at or below it
    v1_texel_2 <= v1_kept_2(10 downto 6);
    -- UQ0.6: the weight of the next
    v1_weight_2 <= v1_kept_2(5 downto 0);
    -- UQ5.-1: its leading bits
    v1_odd_high_2 <= v1_texel_2(4 downto 1);
    -- UQ4.0: the odd one of both
    v1_odd_2 <= v1_odd_high_2;
    -- UQ1.0: its last bit
    v1_is_odd_2 <= v1_texel_2(0);
    -- UQ1.6: in the wider of two formats
    v1_weight_wide_2 <= resize(v1_weight_2, 7);
    -- Q4.13: the turned normal
    u1_xyz_2 <= u1_xy_2 + resize(u1_z_2, 18);
    -- Q8.9: in texels from the middle
    u1_scaled_2 <= u1_xyz_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_3 <= in_gain1r_2;
                in_gain1g_3 <= in_gain1g_2;
                in_gain1b_3 <= in_gain1b_2;
                hidden_3 <= hidden_2;
                shift1_3 <= shift1_2;
                nl1_kept_3 <= nl1_kept_2;
                v1_texel_3 <= v1_texel_2;
                v1_weight_3 <= v1_weight_2;
                v1_odd_3 <= v1_odd_2;
                v1_is_odd_3 <= v1_is_odd_2;
                v1_weight_wide_3 <= v1_weight_wide_2;
                u1_scaled_3 <= u1_scaled_2;
                texels1_00_3 <= texels1_00_2;
                texels1_00_v2_3 <= texels1_00_v2_2;
                texels1_01_3 <= texels1_01_2;
                texels1_01_v2_3 <= texels1_01_v2_2;
                texels1_10_3 <= texels1_10_2;
                texels1_10_v2_3 <= texels1_10_v2_2;
                texels1_11_3 <= texels1_11_2;
                texels1_11_v2_3 <= texels1_11_v2_2;
                blend1_signed_3 <= blend1_signed_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: nl1_up, nl1_within, nl1, v1_next_exact, v1_next, v1_other and 7 more
    -- UQ10.21: times 2^shift
    nl1_up_3 <= shift_left(resize(nl1_kept_3, 31), to_integer(shift1_3));
    -- UQ10.11: rounded down
    nl1_up_cut_3 <= nl1_up_3(30 downto 10);
    -- UQ8.11: kept in its format
    nl1_within_3 <= to_unsigned(524287, 19) when nl1_up_cut_3 > 524287 else
        nl1_up_cut_3(18 downto 0);
    -- UQ8.11: n.l, 0 for a normal that is turned away
    nl1_3 <= (others => '0') when hidden_3 = '1' else nl1_within_3;
    -- UQ6.0: the next
    v1_next_exact_3 <= resize(v1_texel_3, 6) + to_unsigned(1, 6);
    -- UQ5.0: at most the last
    v1_next_3 <= to_unsigned(31, 5) when v1_next_exact_3 > 31 else
        v1_next_exact_3(4 downto 0);
    -- UQ5.-1: its leading bits
    v1_even_high_3 <= v1_next_3(4 downto 1);
    -- UQ4.0: the even one of both
    v1_even_3 <= v1_even_high_3;
    -- UQ1.6: the weight of the place itself
    v1_other_3 <= to_unsigned(64, 7) - resize(v1_weight_3, 7);
    -- UQ1.6: the weight of the odd one
    v1_odd_v2_3 <= v1_other_3 when v1_is_odd_3 = '1' else v1_weight_wide_3;
    -- Q8.9: from the first, plus half a weight's last bit
    u1_place_3 <= u1_scaled_3 + to_signed(7940, 18);
    -- Q8.6: rounded to the nearest weight
    u1_cut_3 <= u1_place_3(17 downto 3);
    -- UQ5.6: between the outermost centres
    u1_kept_3 <= (others => '0') when u1_cut_3(14) = '1' else
        to_unsigned(1984, 11) when u1_cut_3 > 1984 else
        unsigned(u1_cut_3(10 downto 0));
    -- UQ5.0: the texel at or below it
    u1_texel_3 <= u1_kept_3(10 downto 6);
    -- UQ0.6: the weight of the next
    u1_weight_3 <= u1_kept_3(5 downto 0);
    -- UQ5.-1: its leading bits
    u1_odd_high_3 <= u1_texel_3(4 downto 1);
    -- UQ4.0: the odd one of both
    u1_odd_3 <= u1_odd_high_3;
    -- UQ1.0: its last bit
    u1_is_odd_3 <= u1_texel_3(0);
    -- UQ1.6: in the wider of two formats
    u1_weight_wide_3 <= resize(u1_weight_3, 7);
    -- UQ7.0: side by side
    texel1_01_3 <= shift_left(resize(texels1_01_3, 7), 4) + resize(v1_odd_3, 7);
    -- UQ11.-4: the first of them
    texels1_010_3 <= texel1_01_3;
    -- UQ7.0: side by side
    texel1_01_v2_3 <= shift_left(resize(texels1_01_v2_3, 7), 4) + resize(v1_odd_3, 7);
    -- UQ11.-4: the first of them
    texels1_011_3 <= texel1_01_v2_3;
    -- UQ7.0: side by side
    texel1_11_3 <= shift_left(resize(texels1_11_3, 7), 4) + resize(v1_odd_3, 7);
    -- UQ11.-4: the first of them
    texels1_110_3 <= texel1_11_3;
    -- UQ7.0: side by side
    texel1_11_v2_3 <= shift_left(resize(texels1_11_v2_3, 7), 4) + resize(v1_odd_3, 7);
    -- UQ11.-4: the first of them
    texels1_111_3 <= texel1_11_v2_3;
    -- Q1.6: a sign bit for the signed product
    v1_odd_signed_3 <= signed(resize(v1_odd_v2_3, 8));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_4 <= in_gain1r_3;
                in_gain1g_4 <= in_gain1g_3;
                in_gain1b_4 <= in_gain1b_3;
                nl1_4 <= nl1_3;
                v1_even_4 <= v1_even_3;
                u1_texel_4 <= u1_texel_3;
                u1_weight_4 <= u1_weight_3;
                u1_odd_4 <= u1_odd_3;
                u1_is_odd_4 <= u1_is_odd_3;
                u1_weight_wide_4 <= u1_weight_wide_3;
                texels1_00_4 <= texels1_00_3;
                texels1_00_v2_4 <= texels1_00_v2_3;
                texels1_010_4 <= texels1_010_3;
                texels1_011_4 <= texels1_011_3;
                texels1_10_4 <= texels1_10_3;
                texels1_10_v2_4 <= texels1_10_v2_3;
                texels1_110_4 <= texels1_110_3;
                texels1_111_4 <= texels1_111_3;
                v1_odd_signed_4 <= v1_odd_signed_3;
                blend1_signed_4 <= blend1_signed_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: u1_next_exact, u1_next, u1_other, u1_odd, texel1_00 and 5 more
    -- UQ6.0: the next
    u1_next_exact_4 <= resize(u1_texel_4, 6) + to_unsigned(1, 6);
    -- UQ5.0: at most the last
    u1_next_4 <= to_unsigned(31, 5) when u1_next_exact_4 > 31 else
        u1_next_exact_4(4 downto 0);
    -- UQ5.-1: its leading bits
    u1_even_high_4 <= u1_next_4(4 downto 1);
    -- UQ4.0: the even one of both
    u1_even_4 <= u1_even_high_4;
    -- UQ1.6: the weight of the place itself
    u1_other_4 <= to_unsigned(64, 7) - resize(u1_weight_4, 7);
    -- UQ1.6: the weight of the odd one
    u1_odd_v2_4 <= u1_other_4 when u1_is_odd_4 = '1' else u1_weight_wide_4;
    -- UQ7.0: side by side
    texel1_00_4 <= shift_left(resize(texels1_00_4, 7), 4) + resize(v1_even_4, 7);
    -- UQ11.-4: the first of them
    texels1_000_4 <= texel1_00_4;
    -- UQ7.0: side by side
    texel1_00_v2_4 <= shift_left(resize(texels1_00_v2_4, 7), 4) + resize(v1_even_4, 7);
    -- UQ11.-4: the first of them
    texels1_001_4 <= texel1_00_v2_4;
    -- UQ11.0: side by side
    texel1_011_4 <= shift_left(resize(texels1_011_4, 11), 4) + resize(u1_odd_4, 11);
    -- UQ7.0: side by side
    texel1_10_4 <= shift_left(resize(texels1_10_4, 7), 4) + resize(v1_even_4, 7);
    -- UQ11.-4: the first of them
    texels1_100_4 <= texel1_10_4;
    -- UQ7.0: side by side
    texel1_10_v2_4 <= shift_left(resize(texels1_10_v2_4, 7), 4) + resize(v1_even_4, 7);
    -- UQ11.-4: the first of them
    texels1_101_4 <= texel1_10_v2_4;
    -- UQ11.0: side by side
    texel1_111_4 <= shift_left(resize(texels1_111_4, 11), 4) + resize(u1_odd_4, 11);
    -- Q1.6: a sign bit for the signed product
    u1_odd_signed_4 <= signed(resize(u1_odd_v2_4, 8));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_5 <= in_gain1r_4;
                in_gain1g_5 <= in_gain1g_4;
                in_gain1b_5 <= in_gain1b_4;
                nl1_5 <= nl1_4;
                u1_even_5 <= u1_even_4;
                u1_odd_5 <= u1_odd_4;
                texels1_000_5 <= texels1_000_4;
                texels1_001_5 <= texels1_001_4;
                texels1_010_5 <= texels1_010_4;
                texel1_011_5 <= texel1_011_4;
                texels1_100_5 <= texels1_100_4;
                texels1_101_5 <= texels1_101_4;
                texels1_110_5 <= texels1_110_4;
                texel1_111_5 <= texel1_111_4;
                u1_odd_signed_5 <= u1_odd_signed_4;
                v1_odd_signed_5 <= v1_odd_signed_4;
                blend1_signed_5 <= blend1_signed_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: texel1_000, texel1_001, texel1_010, texel1_100, texel1_101 and 1 more
    -- UQ11.0: side by side
    texel1_000_5 <= shift_left(resize(texels1_000_5, 11), 4) + resize(u1_even_5, 11);
    -- UQ11.0: side by side
    texel1_001_5 <= shift_left(resize(texels1_001_5, 11), 4) + resize(u1_odd_5, 11);
    -- UQ11.0: side by side
    texel1_010_5 <= shift_left(resize(texels1_010_5, 11), 4) + resize(u1_even_5, 11);
    -- UQ11.0: side by side
    texel1_100_5 <= shift_left(resize(texels1_100_5, 11), 4) + resize(u1_even_5, 11);
    -- UQ11.0: side by side
    texel1_101_5 <= shift_left(resize(texels1_101_5, 11), 4) + resize(u1_odd_5, 11);
    -- UQ11.0: side by side
    texel1_110_5 <= shift_left(resize(texels1_110_5, 11), 4) + resize(u1_even_5, 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_6 <= in_gain1r_5;
                in_gain1g_6 <= in_gain1g_5;
                in_gain1b_6 <= in_gain1b_5;
                nl1_6 <= nl1_5;
                texel1_000_6 <= texel1_000_5;
                texel1_001_6 <= texel1_001_5;
                texel1_010_6 <= texel1_010_5;
                texel1_011_6 <= texel1_011_5;
                texel1_100_6 <= texel1_100_5;
                texel1_101_6 <= texel1_101_5;
                texel1_110_6 <= texel1_110_5;
                texel1_111_6 <= texel1_111_5;
                u1_odd_signed_6 <= u1_odd_signed_5;
                v1_odd_signed_6 <= v1_odd_signed_5;
                blend1_signed_6 <= blend1_signed_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_even_7 <= TEXELS_1_EVEN_EVEN_EVEN(to_integer(texel1_000_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_odd_7 <= TEXELS_1_EVEN_EVEN_ODD(to_integer(texel1_001_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_even_7 <= TEXELS_1_EVEN_ODD_EVEN(to_integer(texel1_010_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_odd_7 <= TEXELS_1_EVEN_ODD_ODD(to_integer(texel1_011_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_even_7 <= TEXELS_1_ODD_EVEN_EVEN(to_integer(texel1_100_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_odd_7 <= TEXELS_1_ODD_EVEN_ODD(to_integer(texel1_101_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_even_7 <= TEXELS_1_ODD_ODD_EVEN(to_integer(texel1_110_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_odd_7 <= TEXELS_1_ODD_ODD_ODD(to_integer(texel1_111_6));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_7 <= in_gain1r_6;
                in_gain1g_7 <= in_gain1g_6;
                in_gain1b_7 <= in_gain1b_6;
                nl1_7 <= nl1_6;
                u1_odd_signed_7 <= u1_odd_signed_6;
                v1_odd_signed_7 <= v1_odd_signed_6;
                blend1_signed_7 <= blend1_signed_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: registers only
    -- UQ0.8: red
    texels_1_even_even_even_r_7 <= unsigned(texels_1_even_even_even_7(23 downto 16));
    -- UQ0.8: red
    texels_1_even_even_odd_r_7 <= unsigned(texels_1_even_even_odd_7(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_even_r_7 <= unsigned(texels_1_even_odd_even_7(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_odd_r_7 <= unsigned(texels_1_even_odd_odd_7(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_even_r_7 <= unsigned(texels_1_odd_even_even_7(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_odd_r_7 <= unsigned(texels_1_odd_even_odd_7(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_even_r_7 <= unsigned(texels_1_odd_odd_even_7(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_odd_r_7 <= unsigned(texels_1_odd_odd_odd_7(23 downto 16));
    -- UQ0.8: green
    texels_1_even_even_even_g_7 <= unsigned(texels_1_even_even_even_7(15 downto 8));
    -- UQ0.8: green
    texels_1_even_even_odd_g_7 <= unsigned(texels_1_even_even_odd_7(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_even_g_7 <= unsigned(texels_1_even_odd_even_7(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_odd_g_7 <= unsigned(texels_1_even_odd_odd_7(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_even_g_7 <= unsigned(texels_1_odd_even_even_7(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_odd_g_7 <= unsigned(texels_1_odd_even_odd_7(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_even_g_7 <= unsigned(texels_1_odd_odd_even_7(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_odd_g_7 <= unsigned(texels_1_odd_odd_odd_7(15 downto 8));
    -- UQ0.8: blue
    texels_1_even_even_even_b_7 <= unsigned(texels_1_even_even_even_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_even_odd_b_7 <= unsigned(texels_1_even_even_odd_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_even_b_7 <= unsigned(texels_1_even_odd_even_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_odd_b_7 <= unsigned(texels_1_even_odd_odd_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_even_b_7 <= unsigned(texels_1_odd_even_even_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_odd_b_7 <= unsigned(texels_1_odd_even_odd_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_even_b_7 <= unsigned(texels_1_odd_odd_even_7(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_odd_b_7 <= unsigned(texels_1_odd_odd_odd_7(7 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_8 <= in_gain1r_7;
                in_gain1g_8 <= in_gain1g_7;
                in_gain1b_8 <= in_gain1b_7;
                nl1_8 <= nl1_7;
                texels_1_even_even_even_r_8 <= texels_1_even_even_even_r_7;
                texels_1_even_even_odd_r_8 <= texels_1_even_even_odd_r_7;
                texels_1_even_odd_even_r_8 <= texels_1_even_odd_even_r_7;
                texels_1_even_odd_odd_r_8 <= texels_1_even_odd_odd_r_7;
                texels_1_odd_even_even_r_8 <= texels_1_odd_even_even_r_7;
                texels_1_odd_even_odd_r_8 <= texels_1_odd_even_odd_r_7;
                texels_1_odd_odd_even_r_8 <= texels_1_odd_odd_even_r_7;
                texels_1_odd_odd_odd_r_8 <= texels_1_odd_odd_odd_r_7;
                u1_odd_signed_8 <= u1_odd_signed_7;
                v1_odd_signed_8 <= v1_odd_signed_7;
                blend1_signed_8 <= blend1_signed_7;
                texels_1_even_even_even_g_8 <= texels_1_even_even_even_g_7;
                texels_1_even_even_odd_g_8 <= texels_1_even_even_odd_g_7;
                texels_1_even_odd_even_g_8 <= texels_1_even_odd_even_g_7;
                texels_1_even_odd_odd_g_8 <= texels_1_even_odd_odd_g_7;
                texels_1_odd_even_even_g_8 <= texels_1_odd_even_even_g_7;
                texels_1_odd_even_odd_g_8 <= texels_1_odd_even_odd_g_7;
                texels_1_odd_odd_even_g_8 <= texels_1_odd_odd_even_g_7;
                texels_1_odd_odd_odd_g_8 <= texels_1_odd_odd_odd_g_7;
                texels_1_even_even_even_b_8 <= texels_1_even_even_even_b_7;
                texels_1_even_even_odd_b_8 <= texels_1_even_even_odd_b_7;
                texels_1_even_odd_even_b_8 <= texels_1_even_odd_even_b_7;
                texels_1_even_odd_odd_b_8 <= texels_1_even_odd_odd_b_7;
                texels_1_odd_even_even_b_8 <= texels_1_odd_even_even_b_7;
                texels_1_odd_even_odd_b_8 <= texels_1_odd_even_odd_b_7;
                texels_1_odd_odd_even_b_8 <= texels_1_odd_odd_even_b_7;
                texels_1_odd_odd_odd_b_8 <= texels_1_odd_odd_odd_b_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_9 <= in_gain1r_8;
                in_gain1g_9 <= in_gain1g_8;
                in_gain1b_9 <= in_gain1b_8;
                nl1_9 <= nl1_8;
                texels_1_even_even_even_r_9 <= texels_1_even_even_even_r_8;
                texels_1_even_even_odd_r_9 <= texels_1_even_even_odd_r_8;
                texels_1_even_odd_even_r_9 <= texels_1_even_odd_even_r_8;
                texels_1_even_odd_odd_r_9 <= texels_1_even_odd_odd_r_8;
                texels_1_odd_even_even_r_9 <= texels_1_odd_even_even_r_8;
                texels_1_odd_even_odd_r_9 <= texels_1_odd_even_odd_r_8;
                texels_1_odd_odd_even_r_9 <= texels_1_odd_odd_even_r_8;
                texels_1_odd_odd_odd_r_9 <= texels_1_odd_odd_odd_r_8;
                u1_odd_signed_9 <= u1_odd_signed_8;
                v1_odd_signed_9 <= v1_odd_signed_8;
                blend1_signed_9 <= blend1_signed_8;
                texels_1_even_even_even_g_9 <= texels_1_even_even_even_g_8;
                texels_1_even_even_odd_g_9 <= texels_1_even_even_odd_g_8;
                texels_1_even_odd_even_g_9 <= texels_1_even_odd_even_g_8;
                texels_1_even_odd_odd_g_9 <= texels_1_even_odd_odd_g_8;
                texels_1_odd_even_even_g_9 <= texels_1_odd_even_even_g_8;
                texels_1_odd_even_odd_g_9 <= texels_1_odd_even_odd_g_8;
                texels_1_odd_odd_even_g_9 <= texels_1_odd_odd_even_g_8;
                texels_1_odd_odd_odd_g_9 <= texels_1_odd_odd_odd_g_8;
                texels_1_even_even_even_b_9 <= texels_1_even_even_even_b_8;
                texels_1_even_even_odd_b_9 <= texels_1_even_even_odd_b_8;
                texels_1_even_odd_even_b_9 <= texels_1_even_odd_even_b_8;
                texels_1_even_odd_odd_b_9 <= texels_1_even_odd_odd_b_8;
                texels_1_odd_even_even_b_9 <= texels_1_odd_even_even_b_8;
                texels_1_odd_even_odd_b_9 <= texels_1_odd_even_odd_b_8;
                texels_1_odd_odd_even_b_9 <= texels_1_odd_odd_even_b_8;
                texels_1_odd_odd_odd_b_9 <= texels_1_odd_odd_odd_b_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: blend1_r_1_0_apart, blend1_r_1_1_apart, blend1_r_1_2_apart and 9 more
    -- Q0.8: the difference
    blend1_r_1_0_apart_9 <=
        signed(resize(texels_1_even_even_odd_r_9, 9)) - signed(resize(texels_1_even_even_even_r_9, 9));
    -- Q0.8: the difference
    blend1_r_1_1_apart_9 <=
        signed(resize(texels_1_even_odd_odd_r_9, 9)) - signed(resize(texels_1_even_odd_even_r_9, 9));
    -- Q0.8: the difference
    blend1_r_1_2_apart_9 <=
        signed(resize(texels_1_odd_even_odd_r_9, 9)) - signed(resize(texels_1_odd_even_even_r_9, 9));
    -- Q0.8: the difference
    blend1_r_1_3_apart_9 <=
        signed(resize(texels_1_odd_odd_odd_r_9, 9)) - signed(resize(texels_1_odd_odd_even_r_9, 9));
    -- Q0.8: the difference
    blend1_g_1_0_apart_9 <=
        signed(resize(texels_1_even_even_odd_g_9, 9)) - signed(resize(texels_1_even_even_even_g_9, 9));
    -- Q0.8: the difference
    blend1_g_1_1_apart_9 <=
        signed(resize(texels_1_even_odd_odd_g_9, 9)) - signed(resize(texels_1_even_odd_even_g_9, 9));
    -- Q0.8: the difference
    blend1_g_1_2_apart_9 <=
        signed(resize(texels_1_odd_even_odd_g_9, 9)) - signed(resize(texels_1_odd_even_even_g_9, 9));
    -- Q0.8: the difference
    blend1_g_1_3_apart_9 <=
        signed(resize(texels_1_odd_odd_odd_g_9, 9)) - signed(resize(texels_1_odd_odd_even_g_9, 9));
    -- Q0.8: the difference
    blend1_b_1_0_apart_9 <=
        signed(resize(texels_1_even_even_odd_b_9, 9)) - signed(resize(texels_1_even_even_even_b_9, 9));
    -- Q0.8: the difference
    blend1_b_1_1_apart_9 <=
        signed(resize(texels_1_even_odd_odd_b_9, 9)) - signed(resize(texels_1_even_odd_even_b_9, 9));
    -- Q0.8: the difference
    blend1_b_1_2_apart_9 <=
        signed(resize(texels_1_odd_even_odd_b_9, 9)) - signed(resize(texels_1_odd_even_even_b_9, 9));
    -- Q0.8: the difference
    blend1_b_1_3_apart_9 <=
        signed(resize(texels_1_odd_odd_odd_b_9, 9)) - signed(resize(texels_1_odd_odd_even_b_9, 9));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_10 <= in_gain1r_9;
                in_gain1g_10 <= in_gain1g_9;
                in_gain1b_10 <= in_gain1b_9;
                nl1_10 <= nl1_9;
                texels_1_even_even_even_r_10 <= texels_1_even_even_even_r_9;
                texels_1_even_odd_even_r_10 <= texels_1_even_odd_even_r_9;
                texels_1_odd_even_even_r_10 <= texels_1_odd_even_even_r_9;
                texels_1_odd_odd_even_r_10 <= texels_1_odd_odd_even_r_9;
                blend1_r_1_0_apart_10 <= blend1_r_1_0_apart_9;
                u1_odd_signed_10 <= u1_odd_signed_9;
                blend1_r_1_1_apart_10 <= blend1_r_1_1_apart_9;
                blend1_r_1_2_apart_10 <= blend1_r_1_2_apart_9;
                blend1_r_1_3_apart_10 <= blend1_r_1_3_apart_9;
                v1_odd_signed_10 <= v1_odd_signed_9;
                blend1_signed_10 <= blend1_signed_9;
                texels_1_even_even_even_g_10 <= texels_1_even_even_even_g_9;
                texels_1_even_odd_even_g_10 <= texels_1_even_odd_even_g_9;
                texels_1_odd_even_even_g_10 <= texels_1_odd_even_even_g_9;
                texels_1_odd_odd_even_g_10 <= texels_1_odd_odd_even_g_9;
                blend1_g_1_0_apart_10 <= blend1_g_1_0_apart_9;
                blend1_g_1_1_apart_10 <= blend1_g_1_1_apart_9;
                blend1_g_1_2_apart_10 <= blend1_g_1_2_apart_9;
                blend1_g_1_3_apart_10 <= blend1_g_1_3_apart_9;
                texels_1_even_even_even_b_10 <= texels_1_even_even_even_b_9;
                texels_1_even_odd_even_b_10 <= texels_1_even_odd_even_b_9;
                texels_1_odd_even_even_b_10 <= texels_1_odd_even_even_b_9;
                texels_1_odd_odd_even_b_10 <= texels_1_odd_odd_even_b_9;
                blend1_b_1_0_apart_10 <= blend1_b_1_0_apart_9;
                blend1_b_1_1_apart_10 <= blend1_b_1_1_apart_9;
                blend1_b_1_2_apart_10 <= blend1_b_1_2_apart_9;
                blend1_b_1_3_apart_10 <= blend1_b_1_3_apart_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: blend1_r_1_0_part, blend1_r_1_1_part, blend1_r_1_2_part and 9 more
    -- Q2.14: its part
    blend1_r_1_0_part_10 <= blend1_r_1_0_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_r_1_1_part_10 <= blend1_r_1_1_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_r_1_2_part_10 <= blend1_r_1_2_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_r_1_3_part_10 <= blend1_r_1_3_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_g_1_0_part_10 <= blend1_g_1_0_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_g_1_1_part_10 <= blend1_g_1_1_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_g_1_2_part_10 <= blend1_g_1_2_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_g_1_3_part_10 <= blend1_g_1_3_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_b_1_0_part_10 <= blend1_b_1_0_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_b_1_1_part_10 <= blend1_b_1_1_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_b_1_2_part_10 <= blend1_b_1_2_apart_10 * u1_odd_signed_10;
    -- Q2.14: its part
    blend1_b_1_3_part_10 <= blend1_b_1_3_apart_10 * u1_odd_signed_10;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_11 <= in_gain1r_10;
                in_gain1g_11 <= in_gain1g_10;
                in_gain1b_11 <= in_gain1b_10;
                nl1_11 <= nl1_10;
                texels_1_even_even_even_r_11 <= texels_1_even_even_even_r_10;
                texels_1_even_odd_even_r_11 <= texels_1_even_odd_even_r_10;
                texels_1_odd_even_even_r_11 <= texels_1_odd_even_even_r_10;
                texels_1_odd_odd_even_r_11 <= texels_1_odd_odd_even_r_10;
                blend1_r_1_0_part_11 <= blend1_r_1_0_part_10;
                blend1_r_1_1_part_11 <= blend1_r_1_1_part_10;
                blend1_r_1_2_part_11 <= blend1_r_1_2_part_10;
                blend1_r_1_3_part_11 <= blend1_r_1_3_part_10;
                v1_odd_signed_11 <= v1_odd_signed_10;
                blend1_signed_11 <= blend1_signed_10;
                texels_1_even_even_even_g_11 <= texels_1_even_even_even_g_10;
                texels_1_even_odd_even_g_11 <= texels_1_even_odd_even_g_10;
                texels_1_odd_even_even_g_11 <= texels_1_odd_even_even_g_10;
                texels_1_odd_odd_even_g_11 <= texels_1_odd_odd_even_g_10;
                blend1_g_1_0_part_11 <= blend1_g_1_0_part_10;
                blend1_g_1_1_part_11 <= blend1_g_1_1_part_10;
                blend1_g_1_2_part_11 <= blend1_g_1_2_part_10;
                blend1_g_1_3_part_11 <= blend1_g_1_3_part_10;
                texels_1_even_even_even_b_11 <= texels_1_even_even_even_b_10;
                texels_1_even_odd_even_b_11 <= texels_1_even_odd_even_b_10;
                texels_1_odd_even_even_b_11 <= texels_1_odd_even_even_b_10;
                texels_1_odd_odd_even_b_11 <= texels_1_odd_odd_even_b_10;
                blend1_b_1_0_part_11 <= blend1_b_1_0_part_10;
                blend1_b_1_1_part_11 <= blend1_b_1_1_part_10;
                blend1_b_1_2_part_11 <= blend1_b_1_2_part_10;
                blend1_b_1_3_part_11 <= blend1_b_1_3_part_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 8 more
    -- UQ0.14: two neighbours
    blend1_r_1_0_11 <=
        shift_left(resize(texels_1_even_even_even_r_11, 14), 6) + unsigned(blend1_r_1_0_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_r_1_1_11 <=
        shift_left(resize(texels_1_even_odd_even_r_11, 14), 6) + unsigned(blend1_r_1_1_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_r_1_2_11 <=
        shift_left(resize(texels_1_odd_even_even_r_11, 14), 6) + unsigned(blend1_r_1_2_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_r_1_3_11 <=
        shift_left(resize(texels_1_odd_odd_even_r_11, 14), 6) + unsigned(blend1_r_1_3_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_g_1_0_11 <=
        shift_left(resize(texels_1_even_even_even_g_11, 14), 6) + unsigned(blend1_g_1_0_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_g_1_1_11 <=
        shift_left(resize(texels_1_even_odd_even_g_11, 14), 6) + unsigned(blend1_g_1_1_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_g_1_2_11 <=
        shift_left(resize(texels_1_odd_even_even_g_11, 14), 6) + unsigned(blend1_g_1_2_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_g_1_3_11 <=
        shift_left(resize(texels_1_odd_odd_even_g_11, 14), 6) + unsigned(blend1_g_1_3_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_b_1_0_11 <=
        shift_left(resize(texels_1_even_even_even_b_11, 14), 6) + unsigned(blend1_b_1_0_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_b_1_1_11 <=
        shift_left(resize(texels_1_even_odd_even_b_11, 14), 6) + unsigned(blend1_b_1_1_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_b_1_2_11 <=
        shift_left(resize(texels_1_odd_even_even_b_11, 14), 6) + unsigned(blend1_b_1_2_part_11(13 downto 0));
    -- UQ0.14: two neighbours
    blend1_b_1_3_11 <=
        shift_left(resize(texels_1_odd_odd_even_b_11, 14), 6) + unsigned(blend1_b_1_3_part_11(13 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_12 <= in_gain1r_11;
                in_gain1g_12 <= in_gain1g_11;
                in_gain1b_12 <= in_gain1b_11;
                nl1_12 <= nl1_11;
                blend1_r_1_0_12 <= blend1_r_1_0_11;
                blend1_r_1_1_12 <= blend1_r_1_1_11;
                blend1_r_1_2_12 <= blend1_r_1_2_11;
                blend1_r_1_3_12 <= blend1_r_1_3_11;
                v1_odd_signed_12 <= v1_odd_signed_11;
                blend1_signed_12 <= blend1_signed_11;
                blend1_g_1_0_12 <= blend1_g_1_0_11;
                blend1_g_1_1_12 <= blend1_g_1_1_11;
                blend1_g_1_2_12 <= blend1_g_1_2_11;
                blend1_g_1_3_12 <= blend1_g_1_3_11;
                blend1_b_1_0_12 <= blend1_b_1_0_11;
                blend1_b_1_1_12 <= blend1_b_1_1_11;
                blend1_b_1_2_12 <= blend1_b_1_2_11;
                blend1_b_1_3_12 <= blend1_b_1_3_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: blend1_r_2_0_apart, blend1_r_2_1_apart, blend1_g_2_0_apart and 3 more
    -- Q0.14: the difference
    blend1_r_2_0_apart_12 <=
        signed(resize(blend1_r_1_1_12, 15)) - signed(resize(blend1_r_1_0_12, 15));
    -- Q0.14: the difference
    blend1_r_2_1_apart_12 <=
        signed(resize(blend1_r_1_3_12, 15)) - signed(resize(blend1_r_1_2_12, 15));
    -- Q0.14: the difference
    blend1_g_2_0_apart_12 <=
        signed(resize(blend1_g_1_1_12, 15)) - signed(resize(blend1_g_1_0_12, 15));
    -- Q0.14: the difference
    blend1_g_2_1_apart_12 <=
        signed(resize(blend1_g_1_3_12, 15)) - signed(resize(blend1_g_1_2_12, 15));
    -- Q0.14: the difference
    blend1_b_2_0_apart_12 <=
        signed(resize(blend1_b_1_1_12, 15)) - signed(resize(blend1_b_1_0_12, 15));
    -- Q0.14: the difference
    blend1_b_2_1_apart_12 <=
        signed(resize(blend1_b_1_3_12, 15)) - signed(resize(blend1_b_1_2_12, 15));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_13 <= in_gain1r_12;
                in_gain1g_13 <= in_gain1g_12;
                in_gain1b_13 <= in_gain1b_12;
                nl1_13 <= nl1_12;
                blend1_r_1_0_13 <= blend1_r_1_0_12;
                blend1_r_1_2_13 <= blend1_r_1_2_12;
                blend1_r_2_0_apart_13 <= blend1_r_2_0_apart_12;
                v1_odd_signed_13 <= v1_odd_signed_12;
                blend1_r_2_1_apart_13 <= blend1_r_2_1_apart_12;
                blend1_signed_13 <= blend1_signed_12;
                blend1_g_1_0_13 <= blend1_g_1_0_12;
                blend1_g_1_2_13 <= blend1_g_1_2_12;
                blend1_g_2_0_apart_13 <= blend1_g_2_0_apart_12;
                blend1_g_2_1_apart_13 <= blend1_g_2_1_apart_12;
                blend1_b_1_0_13 <= blend1_b_1_0_12;
                blend1_b_1_2_13 <= blend1_b_1_2_12;
                blend1_b_2_0_apart_13 <= blend1_b_2_0_apart_12;
                blend1_b_2_1_apart_13 <= blend1_b_2_1_apart_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: blend1_r_2_0_part, blend1_r_2_1_part, blend1_g_2_0_part and 3 more
    -- Q2.20: its part
    blend1_r_2_0_part_13 <= blend1_r_2_0_apart_13 * v1_odd_signed_13;
    -- Q2.20: its part
    blend1_r_2_1_part_13 <= blend1_r_2_1_apart_13 * v1_odd_signed_13;
    -- Q2.20: its part
    blend1_g_2_0_part_13 <= blend1_g_2_0_apart_13 * v1_odd_signed_13;
    -- Q2.20: its part
    blend1_g_2_1_part_13 <= blend1_g_2_1_apart_13 * v1_odd_signed_13;
    -- Q2.20: its part
    blend1_b_2_0_part_13 <= blend1_b_2_0_apart_13 * v1_odd_signed_13;
    -- Q2.20: its part
    blend1_b_2_1_part_13 <= blend1_b_2_1_apart_13 * v1_odd_signed_13;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_14 <= in_gain1r_13;
                in_gain1g_14 <= in_gain1g_13;
                in_gain1b_14 <= in_gain1b_13;
                nl1_14 <= nl1_13;
                blend1_r_1_0_14 <= blend1_r_1_0_13;
                blend1_r_1_2_14 <= blend1_r_1_2_13;
                blend1_r_2_0_part_14 <= blend1_r_2_0_part_13;
                blend1_r_2_1_part_14 <= blend1_r_2_1_part_13;
                blend1_signed_14 <= blend1_signed_13;
                blend1_g_1_0_14 <= blend1_g_1_0_13;
                blend1_g_1_2_14 <= blend1_g_1_2_13;
                blend1_g_2_0_part_14 <= blend1_g_2_0_part_13;
                blend1_g_2_1_part_14 <= blend1_g_2_1_part_13;
                blend1_b_1_0_14 <= blend1_b_1_0_13;
                blend1_b_1_2_14 <= blend1_b_1_2_13;
                blend1_b_2_0_part_14 <= blend1_b_2_0_part_13;
                blend1_b_2_1_part_14 <= blend1_b_2_1_part_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    -- UQ0.20: two neighbours
    blend1_r_2_0_14 <=
        shift_left(resize(blend1_r_1_0_14, 20), 6) + unsigned(blend1_r_2_0_part_14(19 downto 0));
    -- UQ0.20: two neighbours
    blend1_r_2_1_14 <=
        shift_left(resize(blend1_r_1_2_14, 20), 6) + unsigned(blend1_r_2_1_part_14(19 downto 0));
    -- UQ0.20: two neighbours
    blend1_g_2_0_14 <=
        shift_left(resize(blend1_g_1_0_14, 20), 6) + unsigned(blend1_g_2_0_part_14(19 downto 0));
    -- UQ0.20: two neighbours
    blend1_g_2_1_14 <=
        shift_left(resize(blend1_g_1_2_14, 20), 6) + unsigned(blend1_g_2_1_part_14(19 downto 0));
    -- UQ0.20: two neighbours
    blend1_b_2_0_14 <=
        shift_left(resize(blend1_b_1_0_14, 20), 6) + unsigned(blend1_b_2_0_part_14(19 downto 0));
    -- UQ0.20: two neighbours
    blend1_b_2_1_14 <=
        shift_left(resize(blend1_b_1_2_14, 20), 6) + unsigned(blend1_b_2_1_part_14(19 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_15 <= in_gain1r_14;
                in_gain1g_15 <= in_gain1g_14;
                in_gain1b_15 <= in_gain1b_14;
                nl1_15 <= nl1_14;
                blend1_r_2_0_15 <= blend1_r_2_0_14;
                blend1_r_2_1_15 <= blend1_r_2_1_14;
                blend1_signed_15 <= blend1_signed_14;
                blend1_g_2_0_15 <= blend1_g_2_0_14;
                blend1_g_2_1_15 <= blend1_g_2_1_14;
                blend1_b_2_0_15 <= blend1_b_2_0_14;
                blend1_b_2_1_15 <= blend1_b_2_1_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    -- Q0.20: the difference
    blend1_r_3_0_apart_15 <=
        signed(resize(blend1_r_2_1_15, 21)) - signed(resize(blend1_r_2_0_15, 21));
    -- Q0.20: the difference
    blend1_g_3_0_apart_15 <=
        signed(resize(blend1_g_2_1_15, 21)) - signed(resize(blend1_g_2_0_15, 21));
    -- Q0.20: the difference
    blend1_b_3_0_apart_15 <=
        signed(resize(blend1_b_2_1_15, 21)) - signed(resize(blend1_b_2_0_15, 21));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_16 <= in_gain1r_15;
                in_gain1g_16 <= in_gain1g_15;
                in_gain1b_16 <= in_gain1b_15;
                nl1_16 <= nl1_15;
                blend1_r_2_0_16 <= blend1_r_2_0_15;
                blend1_r_3_0_apart_16 <= blend1_r_3_0_apart_15;
                blend1_signed_16 <= blend1_signed_15;
                blend1_g_2_0_16 <= blend1_g_2_0_15;
                blend1_g_3_0_apart_16 <= blend1_g_3_0_apart_15;
                blend1_b_2_0_16 <= blend1_b_2_0_15;
                blend1_b_3_0_apart_16 <= blend1_b_3_0_apart_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    -- Q2.26: its part
    blend1_r_3_0_part_16 <= blend1_r_3_0_apart_16 * blend1_signed_16;
    -- Q2.26: its part
    blend1_g_3_0_part_16 <= blend1_g_3_0_apart_16 * blend1_signed_16;
    -- Q2.26: its part
    blend1_b_3_0_part_16 <= blend1_b_3_0_apart_16 * blend1_signed_16;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_17 <= in_gain1r_16;
                in_gain1g_17 <= in_gain1g_16;
                in_gain1b_17 <= in_gain1b_16;
                nl1_17 <= nl1_16;
                blend1_r_2_0_17 <= blend1_r_2_0_16;
                blend1_r_3_0_part_17 <= blend1_r_3_0_part_16;
                blend1_g_2_0_17 <= blend1_g_2_0_16;
                blend1_g_3_0_part_17 <= blend1_g_3_0_part_16;
                blend1_b_2_0_17 <= blend1_b_2_0_16;
                blend1_b_3_0_part_17 <= blend1_b_3_0_part_16;
            end if;
        end if;
    end process;

    -- ===== Stage 17: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    -- UQ0.26: two bands
    blend1_r_3_0_17 <=
        shift_left(resize(blend1_r_2_0_17, 26), 6) + unsigned(blend1_r_3_0_part_17(25 downto 0));
    -- UQ0.18: the blended code
    root1_r_17 <= blend1_r_3_0_17(25 downto 8);
    -- UQ0.26: two bands
    blend1_g_3_0_17 <=
        shift_left(resize(blend1_g_2_0_17, 26), 6) + unsigned(blend1_g_3_0_part_17(25 downto 0));
    -- UQ0.18: the blended code
    root1_g_17 <= blend1_g_3_0_17(25 downto 8);
    -- UQ0.26: two bands
    blend1_b_3_0_17 <=
        shift_left(resize(blend1_b_2_0_17, 26), 6) + unsigned(blend1_b_3_0_part_17(25 downto 0));
    -- UQ0.18: the blended code
    root1_b_17 <= blend1_b_3_0_17(25 downto 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_18 <= in_gain1r_17;
                in_gain1g_18 <= in_gain1g_17;
                in_gain1b_18 <= in_gain1b_17;
                nl1_18 <= nl1_17;
                root1_r_18 <= root1_r_17;
                root1_g_18 <= root1_g_17;
                root1_b_18 <= root1_b_17;
            end if;
        end if;
    end process;

    -- ===== Stage 18: square1_r_exact, square1_g_exact, square1_b_exact
    -- UQ0.36: its square
    square1_r_exact_18 <= root1_r_18 * root1_r_18;
    -- UQ0.18: rounded down
    square1_r_18 <= square1_r_exact_18(35 downto 18);
    -- UQ0.36: its square
    square1_g_exact_18 <= root1_g_18 * root1_g_18;
    -- UQ0.18: rounded down
    square1_g_18 <= square1_g_exact_18(35 downto 18);
    -- UQ0.36: its square
    square1_b_exact_18 <= root1_b_18 * root1_b_18;
    -- UQ0.18: rounded down
    square1_b_18 <= square1_b_exact_18(35 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_19 <= in_gain1r_18;
                in_gain1g_19 <= in_gain1g_18;
                in_gain1b_19 <= in_gain1b_18;
                nl1_19 <= nl1_18;
                square1_r_19 <= square1_r_18;
                square1_g_19 <= square1_g_18;
                square1_b_19 <= square1_b_18;
            end if;
        end if;
    end process;

    -- ===== Stage 19: lit1_r_exact, lit1_g_exact, lit1_b_exact
    -- UQ8.29: n.l times the square
    lit1_r_exact_19 <= nl1_19 * square1_r_19;
    -- UQ8.11: rounded down
    lit1_r_19 <= lit1_r_exact_19(36 downto 18);
    -- UQ8.29: n.l times the square
    lit1_g_exact_19 <= nl1_19 * square1_g_19;
    -- UQ8.11: rounded down
    lit1_g_19 <= lit1_g_exact_19(36 downto 18);
    -- UQ8.29: n.l times the square
    lit1_b_exact_19 <= nl1_19 * square1_b_19;
    -- UQ8.11: rounded down
    lit1_b_19 <= lit1_b_exact_19(36 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_20 <= in_gain1r_19;
                in_gain1g_20 <= in_gain1g_19;
                in_gain1b_20 <= in_gain1b_19;
                lit1_r_20 <= lit1_r_19;
                lit1_g_20 <= lit1_g_19;
                lit1_b_20 <= lit1_b_19;
            end if;
        end if;
    end process;

    -- ===== Stage 20: light1_r_exact, light1_g_exact, light1_b_exact
    -- UQ8.29: times the gain
    light1_r_exact_20 <= lit1_r_20 * in_gain1r_20;
    -- UQ8.17: rounded down
    light1_r_20 <= light1_r_exact_20(36 downto 12);
    -- UQ8.29: times the gain
    light1_g_exact_20 <= lit1_g_20 * in_gain1g_20;
    -- UQ8.17: rounded down
    light1_g_20 <= light1_g_exact_20(36 downto 12);
    -- UQ8.29: times the gain
    light1_b_exact_20 <= lit1_b_20 * in_gain1b_20;
    -- UQ8.17: rounded down
    light1_b_20 <= light1_b_exact_20(36 downto 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                light1_r_21 <= light1_r_20;
                light1_g_21 <= light1_g_20;
                light1_b_21 <= light1_b_20;
            end if;
        end if;
    end process;

    -- ===== Stage 21: sum_r, sum_g, sum_b
    -- UQ1.17: kept at 1.0
    sum_r_21 <= (17 => '1', others => '0') when unsigned(light1_r_21(24 downto 17)) /= 0 else
        light1_r_21(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_g_21 <= (17 => '1', others => '0') when unsigned(light1_g_21(24 downto 17)) /= 0 else
        light1_g_21(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_b_21 <= (17 => '1', others => '0') when unsigned(light1_b_21(24 downto 17)) /= 0 else
        light1_b_21(17 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sum_r_22 <= sum_r_21;
                sum_g_22 <= sum_g_21;
                sum_b_22 <= sum_b_21;
            end if;
        end if;
    end process;

    out_valid <= valid(22);
    out_sum_r <= sum_r_22;
    out_sum_g <= sum_g_22;
    out_sum_b <= sum_b_22;

end architecture rtl;
