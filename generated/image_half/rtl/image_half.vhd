-- image_half: image-based block of ggx (half, 16 slices of 32 x 32 texels), 1 light a clock, 8 bits a channel
--
-- Made by: brdfgen generate core.toml
-- Spec c91e1a366b8521bb. Generated; the core is yours to use under any terms.
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
--   in_blend1 UQ1.5   weight of the odd one of this slice and the next, at most 1
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
--   49.9 dB in the mean, 44.4 dB at the worst angle.

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
        -- the other outputs are a result: in_valid, 27 enabled clocks later
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
    signal texels_1_even_even_even_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_even_even_odd_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_even_odd_even_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_even_odd_odd_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_odd_even_even_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_odd_even_odd_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_odd_odd_even_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal texels_1_odd_odd_odd_9 : std_logic_vector(23 downto 0) := (others => '0');

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
    signal blend1_0 : unsigned(5 downto 0) := (others => '0');
    signal band1_next_exact_0 : unsigned(4 downto 0) := (others => '0');
    signal band1_odd_high_0 : unsigned(2 downto 0) := (others => '0');
    signal band1_odd_0 : unsigned(2 downto 0) := (others => '0');
    signal v1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_x_0 : signed(15 downto 0) := (others => '0');
    signal v1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_y_0 : signed(15 downto 0) := (others => '0');
    signal u1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_x_0 : signed(15 downto 0) := (others => '0');
    signal u1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_y_0 : signed(15 downto 0) := (others => '0');
    signal u1_z_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_z_0 : signed(15 downto 0) := (others => '0');
    signal texels1_10_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_0 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_0 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_0 : signed(6 downto 0) := (others => '0');
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
    signal band1_next_exact_1 : unsigned(4 downto 0) := (others => '0');
    signal v1_x_1 : signed(15 downto 0) := (others => '0');
    signal v1_y_1 : signed(15 downto 0) := (others => '0');
    signal u1_x_1 : signed(15 downto 0) := (others => '0');
    signal u1_y_1 : signed(15 downto 0) := (others => '0');
    signal u1_z_1 : signed(15 downto 0) := (others => '0');
    signal texels1_10_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_1 : signed(6 downto 0) := (others => '0');
    signal nl1_xy_1 : signed(26 downto 0) := (others => '0');
    signal band1_next_1 : unsigned(3 downto 0) := (others => '0');
    signal band1_even_high_1 : unsigned(2 downto 0) := (others => '0');
    signal band1_even_1 : unsigned(2 downto 0) := (others => '0');
    signal v1_xy_1 : signed(16 downto 0) := (others => '0');
    signal v1_scaled_1 : signed(16 downto 0) := (others => '0');
    signal u1_xy_1 : signed(16 downto 0) := (others => '0');
    signal texels1_00_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_1 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_1 : unsigned(2 downto 0) := (others => '0');
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
    signal v1_scaled_2 : signed(16 downto 0) := (others => '0');
    signal u1_z_2 : signed(15 downto 0) := (others => '0');
    signal u1_xy_2 : signed(16 downto 0) := (others => '0');
    signal texels1_00_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_2 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_2 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_2 : signed(6 downto 0) := (others => '0');
    signal nl1_xyz_2 : signed(26 downto 0) := (others => '0');
    signal nl1_cut_2 : signed(24 downto 0) := (others => '0');
    signal v1_place_2 : signed(16 downto 0) := (others => '0');
    signal v1_cut_2 : signed(13 downto 0) := (others => '0');
    signal u1_xyz_2 : signed(16 downto 0) := (others => '0');
    signal u1_scaled_2 : signed(16 downto 0) := (others => '0');
    signal in_gain1r_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_3 : unsigned(17 downto 0) := (others => '0');
    signal hidden_3 : std_logic := '0';
    signal nl1_cut_3 : signed(24 downto 0) := (others => '0');
    signal nl1_by_1_3 : unsigned(0 downto 0) := (others => '0');
    signal nl1_amount_2_3 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_3 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_3 : std_logic := '0';
    signal v1_cut_3 : signed(13 downto 0) := (others => '0');
    signal u1_scaled_3 : signed(16 downto 0) := (others => '0');
    signal texels1_00_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_3 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_3 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_3 : signed(6 downto 0) := (others => '0');
    signal nl1_kept_3 : unsigned(19 downto 0) := (others => '0');
    signal nl1_up_1_3 : unsigned(20 downto 0) := (others => '0');
    signal nl1_all_3 : unsigned(20 downto 0) := (others => '0');
    signal nl1_all_wide_3 : unsigned(28 downto 0) := (others => '0');
    signal v1_kept_3 : unsigned(9 downto 0) := (others => '0');
    signal v1_texel_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_weight_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_odd_high_3 : unsigned(3 downto 0) := (others => '0');
    signal v1_odd_3 : unsigned(3 downto 0) := (others => '0');
    signal v1_is_odd_3 : std_logic := '0';
    signal v1_weight_wide_3 : unsigned(5 downto 0) := (others => '0');
    signal u1_place_3 : signed(16 downto 0) := (others => '0');
    signal u1_cut_3 : signed(13 downto 0) := (others => '0');
    signal v1_weight_bit_0_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_1_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_2_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_3_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_4_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_of_0_flag_3 : std_logic := '0';
    signal v1_weight_of_0_not_3 : std_logic := '0';
    signal v1_weight_of_0_3 : std_logic := '0';
    signal v1_weight_of_1_flag_3 : std_logic := '0';
    signal v1_weight_of_1_not_3 : std_logic := '0';
    signal v1_weight_of_1_3 : std_logic := '0';
    signal v1_weight_of_2_flag_3 : std_logic := '0';
    signal v1_weight_of_2_not_3 : std_logic := '0';
    signal v1_weight_of_2_3 : std_logic := '0';
    signal v1_weight_of_3_flag_3 : std_logic := '0';
    signal v1_weight_of_3_not_3 : std_logic := '0';
    signal v1_weight_of_3_3 : std_logic := '0';
    signal v1_weight_of_4_flag_3 : std_logic := '0';
    signal v1_weight_of_4_not_3 : std_logic := '0';
    signal v1_weight_of_4_3 : std_logic := '0';
    signal in_gain1r_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_4 : unsigned(17 downto 0) := (others => '0');
    signal hidden_4 : std_logic := '0';
    signal nl1_up_1_4 : unsigned(20 downto 0) := (others => '0');
    signal nl1_amount_2_4 : unsigned(1 downto 0) := (others => '0');
    signal nl1_amount_4_4 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_4 : std_logic := '0';
    signal nl1_all_wide_4 : unsigned(28 downto 0) := (others => '0');
    signal v1_texel_4 : unsigned(4 downto 0) := (others => '0');
    signal v1_weight_4 : unsigned(4 downto 0) := (others => '0');
    signal v1_odd_4 : unsigned(3 downto 0) := (others => '0');
    signal v1_is_odd_4 : std_logic := '0';
    signal v1_weight_wide_4 : unsigned(5 downto 0) := (others => '0');
    signal u1_cut_4 : signed(13 downto 0) := (others => '0');
    signal texels1_00_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_01_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_4 : unsigned(2 downto 0) := (others => '0');
    signal texels1_11_v2_4 : unsigned(2 downto 0) := (others => '0');
    signal blend1_signed_4 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_4 : std_logic := '0';
    signal v1_weight_of_1_4 : std_logic := '0';
    signal v1_weight_of_2_4 : std_logic := '0';
    signal v1_weight_of_3_4 : std_logic := '0';
    signal v1_weight_of_4_4 : std_logic := '0';
    signal nl1_up_2_4 : unsigned(22 downto 0) := (others => '0');
    signal v1_next_exact_4 : unsigned(5 downto 0) := (others => '0');
    signal v1_other_4 : unsigned(5 downto 0) := (others => '0');
    signal v1_odd_v2_4 : unsigned(5 downto 0) := (others => '0');
    signal u1_kept_4 : unsigned(9 downto 0) := (others => '0');
    signal u1_texel_4 : unsigned(4 downto 0) := (others => '0');
    signal u1_weight_4 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_high_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_odd_4 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_4 : std_logic := '0';
    signal texel1_01_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_01_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_4 : unsigned(6 downto 0) := (others => '0');
    signal u1_weight_bit_0_4 : unsigned(0 downto 0) := (others => '0');
    signal u1_weight_bit_1_4 : unsigned(0 downto 0) := (others => '0');
    signal u1_weight_bit_2_4 : unsigned(0 downto 0) := (others => '0');
    signal u1_weight_bit_3_4 : unsigned(0 downto 0) := (others => '0');
    signal u1_weight_bit_4_4 : unsigned(0 downto 0) := (others => '0');
    signal u1_weight_of_0_flag_4 : std_logic := '0';
    signal u1_weight_of_0_not_4 : std_logic := '0';
    signal u1_weight_of_0_4 : std_logic := '0';
    signal u1_weight_of_1_flag_4 : std_logic := '0';
    signal u1_weight_of_1_not_4 : std_logic := '0';
    signal u1_weight_of_1_4 : std_logic := '0';
    signal u1_weight_of_2_flag_4 : std_logic := '0';
    signal u1_weight_of_2_not_4 : std_logic := '0';
    signal u1_weight_of_2_4 : std_logic := '0';
    signal u1_weight_of_3_flag_4 : std_logic := '0';
    signal u1_weight_of_3_not_4 : std_logic := '0';
    signal u1_weight_of_3_4 : std_logic := '0';
    signal u1_weight_of_4_flag_4 : std_logic := '0';
    signal u1_weight_of_4_not_4 : std_logic := '0';
    signal u1_weight_of_4_4 : std_logic := '0';
    signal v1_odd_signed_4 : signed(6 downto 0) := (others => '0');
    signal in_gain1r_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_5 : unsigned(17 downto 0) := (others => '0');
    signal hidden_5 : std_logic := '0';
    signal nl1_up_2_5 : unsigned(22 downto 0) := (others => '0');
    signal nl1_amount_4_5 : unsigned(2 downto 0) := (others => '0');
    signal nl1_by_8_5 : std_logic := '0';
    signal nl1_all_wide_5 : unsigned(28 downto 0) := (others => '0');
    signal v1_next_exact_5 : unsigned(5 downto 0) := (others => '0');
    signal v1_is_odd_5 : std_logic := '0';
    signal u1_texel_5 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_5 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_5 : std_logic := '0';
    signal texels1_00_5 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_5 : unsigned(2 downto 0) := (others => '0');
    signal texels1_010_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_10_5 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_5 : unsigned(2 downto 0) := (others => '0');
    signal texels1_110_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_5 : unsigned(6 downto 0) := (others => '0');
    signal u1_weight_of_0_5 : std_logic := '0';
    signal u1_weight_of_1_5 : std_logic := '0';
    signal u1_weight_of_2_5 : std_logic := '0';
    signal u1_weight_of_3_5 : std_logic := '0';
    signal u1_weight_of_4_5 : std_logic := '0';
    signal v1_odd_signed_5 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_5 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_5 : std_logic := '0';
    signal v1_weight_of_1_5 : std_logic := '0';
    signal v1_weight_of_2_5 : std_logic := '0';
    signal v1_weight_of_3_5 : std_logic := '0';
    signal v1_weight_of_4_5 : std_logic := '0';
    signal nl1_up_4_5 : unsigned(26 downto 0) := (others => '0');
    signal nl1_up_4_wide_5 : unsigned(28 downto 0) := (others => '0');
    signal nl1_up_5 : unsigned(28 downto 0) := (others => '0');
    signal nl1_up_cut_5 : unsigned(19 downto 0) := (others => '0');
    signal nl1_within_5 : unsigned(17 downto 0) := (others => '0');
    signal v1_next_5 : unsigned(4 downto 0) := (others => '0');
    signal v1_even_high_5 : unsigned(3 downto 0) := (others => '0');
    signal v1_even_5 : unsigned(3 downto 0) := (others => '0');
    signal u1_next_exact_5 : unsigned(5 downto 0) := (others => '0');
    signal texel1_011_5 : unsigned(10 downto 0) := (others => '0');
    signal texel1_111_5 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_6 : unsigned(17 downto 0) := (others => '0');
    signal hidden_6 : std_logic := '0';
    signal nl1_within_6 : unsigned(17 downto 0) := (others => '0');
    signal v1_even_6 : unsigned(3 downto 0) := (others => '0');
    signal v1_is_odd_6 : std_logic := '0';
    signal u1_next_exact_6 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_6 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_6 : std_logic := '0';
    signal texels1_00_6 : unsigned(2 downto 0) := (others => '0');
    signal texels1_00_v2_6 : unsigned(2 downto 0) := (others => '0');
    signal texels1_010_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_6 : unsigned(10 downto 0) := (others => '0');
    signal texels1_10_6 : unsigned(2 downto 0) := (others => '0');
    signal texels1_10_v2_6 : unsigned(2 downto 0) := (others => '0');
    signal texels1_110_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_6 : unsigned(10 downto 0) := (others => '0');
    signal u1_weight_of_0_6 : std_logic := '0';
    signal u1_weight_of_1_6 : std_logic := '0';
    signal u1_weight_of_2_6 : std_logic := '0';
    signal u1_weight_of_3_6 : std_logic := '0';
    signal u1_weight_of_4_6 : std_logic := '0';
    signal v1_odd_signed_6 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_6 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_6 : std_logic := '0';
    signal v1_weight_of_1_6 : std_logic := '0';
    signal v1_weight_of_2_6 : std_logic := '0';
    signal v1_weight_of_3_6 : std_logic := '0';
    signal v1_weight_of_4_6 : std_logic := '0';
    signal nl1_6 : unsigned(17 downto 0) := (others => '0');
    signal u1_next_6 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_high_6 : unsigned(3 downto 0) := (others => '0');
    signal u1_even_6 : unsigned(3 downto 0) := (others => '0');
    signal texel1_00_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_000_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_00_v2_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_10_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_10_v2_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_6 : unsigned(6 downto 0) := (others => '0');
    signal in_gain1r_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_7 : unsigned(17 downto 0) := (others => '0');
    signal nl1_7 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_7 : std_logic := '0';
    signal u1_even_7 : unsigned(3 downto 0) := (others => '0');
    signal u1_odd_7 : unsigned(3 downto 0) := (others => '0');
    signal u1_is_odd_7 : std_logic := '0';
    signal texels1_000_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_7 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_7 : unsigned(10 downto 0) := (others => '0');
    signal texels1_100_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_7 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_7 : unsigned(10 downto 0) := (others => '0');
    signal u1_weight_of_0_7 : std_logic := '0';
    signal u1_weight_of_1_7 : std_logic := '0';
    signal u1_weight_of_2_7 : std_logic := '0';
    signal u1_weight_of_3_7 : std_logic := '0';
    signal u1_weight_of_4_7 : std_logic := '0';
    signal v1_odd_signed_7 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_7 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_7 : std_logic := '0';
    signal v1_weight_of_1_7 : std_logic := '0';
    signal v1_weight_of_2_7 : std_logic := '0';
    signal v1_weight_of_3_7 : std_logic := '0';
    signal v1_weight_of_4_7 : std_logic := '0';
    signal texel1_000_7 : unsigned(10 downto 0) := (others => '0');
    signal texel1_001_7 : unsigned(10 downto 0) := (others => '0');
    signal texel1_010_7 : unsigned(10 downto 0) := (others => '0');
    signal texel1_100_7 : unsigned(10 downto 0) := (others => '0');
    signal texel1_101_7 : unsigned(10 downto 0) := (others => '0');
    signal texel1_110_7 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_8 : unsigned(17 downto 0) := (others => '0');
    signal nl1_8 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_8 : std_logic := '0';
    signal u1_is_odd_8 : std_logic := '0';
    signal texel1_000_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_001_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_010_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_011_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_100_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_101_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_110_8 : unsigned(10 downto 0) := (others => '0');
    signal texel1_111_8 : unsigned(10 downto 0) := (others => '0');
    signal u1_weight_of_0_8 : std_logic := '0';
    signal u1_weight_of_1_8 : std_logic := '0';
    signal u1_weight_of_2_8 : std_logic := '0';
    signal u1_weight_of_3_8 : std_logic := '0';
    signal u1_weight_of_4_8 : std_logic := '0';
    signal v1_odd_signed_8 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_8 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_8 : std_logic := '0';
    signal v1_weight_of_1_8 : std_logic := '0';
    signal v1_weight_of_2_8 : std_logic := '0';
    signal v1_weight_of_3_8 : std_logic := '0';
    signal v1_weight_of_4_8 : std_logic := '0';
    signal in_gain1r_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_9 : unsigned(17 downto 0) := (others => '0');
    signal nl1_9 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_9 : std_logic := '0';
    signal u1_is_odd_9 : std_logic := '0';
    signal u1_weight_of_0_9 : std_logic := '0';
    signal u1_weight_of_1_9 : std_logic := '0';
    signal u1_weight_of_2_9 : std_logic := '0';
    signal u1_weight_of_3_9 : std_logic := '0';
    signal u1_weight_of_4_9 : std_logic := '0';
    signal v1_odd_signed_9 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_9 : signed(6 downto 0) := (others => '0');
    signal v1_weight_of_0_9 : std_logic := '0';
    signal v1_weight_of_1_9 : std_logic := '0';
    signal v1_weight_of_2_9 : std_logic := '0';
    signal v1_weight_of_3_9 : std_logic := '0';
    signal v1_weight_of_4_9 : std_logic := '0';
    signal texels_1_even_even_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_9 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_9 : unsigned(7 downto 0) := (others => '0');
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
    signal in_gain1r_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_10 : unsigned(17 downto 0) := (others => '0');
    signal nl1_10 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_10 : std_logic := '0';
    signal u1_is_odd_10 : std_logic := '0';
    signal texels_1_even_even_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_10 : unsigned(7 downto 0) := (others => '0');
    signal u1_weight_of_0_10 : std_logic := '0';
    signal u1_weight_of_1_10 : std_logic := '0';
    signal u1_weight_of_2_10 : std_logic := '0';
    signal u1_weight_of_3_10 : std_logic := '0';
    signal u1_weight_of_4_10 : std_logic := '0';
    signal v1_odd_signed_10 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_10 : signed(6 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_10 : unsigned(7 downto 0) := (others => '0');
    signal v1_weight_of_0_10 : std_logic := '0';
    signal v1_weight_of_1_10 : std_logic := '0';
    signal v1_weight_of_2_10 : std_logic := '0';
    signal v1_weight_of_3_10 : std_logic := '0';
    signal v1_weight_of_4_10 : std_logic := '0';
    signal texels_1_even_even_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_10 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_10 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_11 : unsigned(17 downto 0) := (others => '0');
    signal nl1_11 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_11 : std_logic := '0';
    signal u1_is_odd_11 : std_logic := '0';
    signal texels_1_even_even_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_11 : unsigned(7 downto 0) := (others => '0');
    signal u1_weight_of_0_11 : std_logic := '0';
    signal u1_weight_of_1_11 : std_logic := '0';
    signal u1_weight_of_2_11 : std_logic := '0';
    signal u1_weight_of_3_11 : std_logic := '0';
    signal u1_weight_of_4_11 : std_logic := '0';
    signal v1_odd_signed_11 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_11 : signed(6 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_11 : unsigned(7 downto 0) := (others => '0');
    signal v1_weight_of_0_11 : std_logic := '0';
    signal v1_weight_of_1_11 : std_logic := '0';
    signal v1_weight_of_2_11 : std_logic := '0';
    signal v1_weight_of_3_11 : std_logic := '0';
    signal v1_weight_of_4_11 : std_logic := '0';
    signal texels_1_even_even_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_11 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_either_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_first_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_0_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_1_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_2_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_3_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_4_11 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_0_11 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_1_11 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_2_11 : unsigned(9 downto 0) := (others => '0');
    signal in_gain1r_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_12 : unsigned(17 downto 0) := (others => '0');
    signal nl1_12 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_12 : std_logic := '0';
    signal blend1_r_1_0_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal v1_odd_signed_12 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_12 : signed(6 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal v1_weight_of_0_12 : std_logic := '0';
    signal v1_weight_of_1_12 : std_logic := '0';
    signal v1_weight_of_2_12 : std_logic := '0';
    signal v1_weight_of_3_12 : std_logic := '0';
    signal v1_weight_of_4_12 : std_logic := '0';
    signal blend1_b_1_0_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_0_12 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_1_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_2_12 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_0_12 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_13 : unsigned(17 downto 0) := (others => '0');
    signal nl1_13 : unsigned(17 downto 0) := (others => '0');
    signal v1_is_odd_13 : std_logic := '0';
    signal blend1_r_1_0_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal v1_odd_signed_13 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_13 : signed(6 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal v1_weight_of_0_13 : std_logic := '0';
    signal v1_weight_of_1_13 : std_logic := '0';
    signal v1_weight_of_2_13 : std_logic := '0';
    signal v1_weight_of_3_13 : std_logic := '0';
    signal v1_weight_of_4_13 : std_logic := '0';
    signal blend1_b_1_0_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_2_13 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_0_13 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_1_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_1_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_1_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_1_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_first_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_first_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_either_4_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_4_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_first_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_first_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_0_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_1_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_2_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_3_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_either_4_13 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_4_13 : unsigned(12 downto 0) := (others => '0');
    signal in_gain1r_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_14 : unsigned(17 downto 0) := (others => '0');
    signal nl1_14 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_1_0_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_1_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_2_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_3_14 : unsigned(12 downto 0) := (others => '0');
    signal v1_odd_signed_14 : signed(6 downto 0) := (others => '0');
    signal blend1_signed_14 : signed(6 downto 0) := (others => '0');
    signal blend1_g_1_0_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_1_1_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_first_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_0_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_1_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_2_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_3_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_1_by_4_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_0_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_1_1_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_first_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_0_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_1_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_2_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_3_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_1_by_4_14 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_2_0_apart_14 : signed(13 downto 0) := (others => '0');
    signal blend1_r_2_1_apart_14 : signed(13 downto 0) := (others => '0');
    signal blend1_g_2_0_apart_14 : signed(13 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_0_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_1_14 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_2_14 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_0_apart_14 : signed(13 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_0_14 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_1_14 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_2_14 : unsigned(14 downto 0) := (others => '0');
    signal in_gain1r_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_15 : unsigned(17 downto 0) := (others => '0');
    signal nl1_15 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_1_0_15 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_2_15 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_2_0_apart_15 : signed(13 downto 0) := (others => '0');
    signal v1_odd_signed_15 : signed(6 downto 0) := (others => '0');
    signal blend1_r_2_1_apart_15 : signed(13 downto 0) := (others => '0');
    signal blend1_signed_15 : signed(6 downto 0) := (others => '0');
    signal blend1_g_1_0_15 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_0_apart_15 : signed(13 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_0_15 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_1_15 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_2_15 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_1_0_15 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_0_apart_15 : signed(13 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_0_15 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_1_15 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_2_15 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_0_part_15 : signed(20 downto 0) := (others => '0');
    signal blend1_r_2_1_part_15 : signed(20 downto 0) := (others => '0');
    signal blend1_g_2_0_part_15 : signed(20 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_0_15 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_part_15 : signed(20 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_0_15 : unsigned(15 downto 0) := (others => '0');
    signal in_gain1r_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_16 : unsigned(17 downto 0) := (others => '0');
    signal nl1_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_1_0_16 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_1_2_16 : unsigned(12 downto 0) := (others => '0');
    signal blend1_r_2_0_part_16 : signed(20 downto 0) := (others => '0');
    signal blend1_r_2_1_part_16 : signed(20 downto 0) := (others => '0');
    signal blend1_signed_16 : signed(6 downto 0) := (others => '0');
    signal blend1_g_1_0_16 : unsigned(12 downto 0) := (others => '0');
    signal blend1_g_2_0_part_16 : signed(20 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_2_16 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_0_16 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_1_0_16 : unsigned(12 downto 0) := (others => '0');
    signal blend1_b_2_0_part_16 : signed(20 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_2_16 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_0_16 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_0_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_1_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_0_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_g_2_1_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_b_2_1_16 : unsigned(17 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal in_gain1r_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_17 : unsigned(17 downto 0) := (others => '0');
    signal nl1_17 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_signed_17 : signed(6 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_apart_17 : signed(17 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_17 : signed(17 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_17 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_18 : unsigned(17 downto 0) := (others => '0');
    signal nl1_18 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_18 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_apart_18 : signed(17 downto 0) := (others => '0');
    signal blend1_signed_18 : signed(6 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_18 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_18 : signed(17 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_18 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_18 : signed(17 downto 0) := (others => '0');
    signal blend1_r_3_0_part_18 : signed(24 downto 0) := (others => '0');
    signal blend1_g_3_0_part_18 : signed(24 downto 0) := (others => '0');
    signal blend1_b_3_0_part_18 : signed(24 downto 0) := (others => '0');
    signal in_gain1r_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_19 : unsigned(17 downto 0) := (others => '0');
    signal nl1_19 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_19 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_part_19 : signed(24 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_19 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_part_19 : signed(24 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_19 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_part_19 : signed(24 downto 0) := (others => '0');
    signal in_gain1r_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_20 : unsigned(17 downto 0) := (others => '0');
    signal nl1_20 : unsigned(17 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_20 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_part_20 : signed(24 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_20 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_part_20 : signed(24 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_20 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_part_20 : signed(24 downto 0) := (others => '0');
    signal blend1_r_3_0_20 : unsigned(21 downto 0) := (others => '0');
    signal root1_r_20 : unsigned(17 downto 0) := (others => '0');
    signal blend1_g_3_0_20 : unsigned(21 downto 0) := (others => '0');
    signal root1_g_20 : unsigned(17 downto 0) := (others => '0');
    signal blend1_b_3_0_20 : unsigned(21 downto 0) := (others => '0');
    signal root1_b_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_21 : unsigned(17 downto 0) := (others => '0');
    signal nl1_21 : unsigned(17 downto 0) := (others => '0');
    signal root1_r_21 : unsigned(17 downto 0) := (others => '0');
    signal root1_g_21 : unsigned(17 downto 0) := (others => '0');
    signal root1_b_21 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_exact_21 : unsigned(35 downto 0) := (others => '0');
    signal square1_r_21 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_exact_21 : unsigned(35 downto 0) := (others => '0');
    signal square1_g_21 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_exact_21 : unsigned(35 downto 0) := (others => '0');
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

    -- ===== Stage 0: nz_kept, shift1, nl1_x_exact, nl1_y_exact, nl1_z_exact and 7 more
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
    -- UQ1.5: the weight of the odd band, at most 1
    blend1_0 <= (5 => '1', others => '0') when in_blend1(5) = '1' else
        in_blend1;
    -- UQ5.0: the next
    band1_next_exact_0 <= resize(in_band1, 5) + to_unsigned(1, 5);
    -- UQ4.-1: its leading bits
    band1_odd_high_0 <= in_band1(3 downto 1);
    -- UQ3.0: the odd one of both
    band1_odd_0 <= band1_odd_high_0;
    -- Q3.32: the turned normal
    v1_x_exact_0 <= in_nx * in_v1x;
    -- Q3.12: rounded down
    v1_x_0 <= v1_x_exact_0(35 downto 20);
    -- Q3.32: the turned normal
    v1_y_exact_0 <= in_ny * in_v1y;
    -- Q3.12: rounded down
    v1_y_0 <= v1_y_exact_0(35 downto 20);
    -- Q3.32: the turned normal
    u1_x_exact_0 <= in_nx * in_u1x;
    -- Q3.12: rounded down
    u1_x_0 <= u1_x_exact_0(35 downto 20);
    -- Q3.32: the turned normal
    u1_y_exact_0 <= in_ny * in_u1y;
    -- Q3.12: rounded down
    u1_y_0 <= u1_y_exact_0(35 downto 20);
    -- Q3.32: the turned normal
    u1_z_exact_0 <= in_nz * in_u1z;
    -- Q3.12: rounded down
    u1_z_0 <= u1_z_exact_0(35 downto 20);
    -- UQ7.-4: the first of them
    texels1_10_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_10_v2_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_11_0 <= band1_odd_0;
    -- UQ7.-4: the first of them
    texels1_11_v2_0 <= band1_odd_0;
    -- Q1.5: a sign bit for the signed product
    blend1_signed_0 <= signed(resize(blend1_0, 7));
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
                v1_x_1 <= v1_x_0;
                v1_y_1 <= v1_y_0;
                u1_x_1 <= u1_x_0;
                u1_y_1 <= u1_y_0;
                u1_z_1 <= u1_z_0;
                texels1_10_1 <= texels1_10_0;
                texels1_10_v2_1 <= texels1_10_v2_0;
                texels1_11_1 <= texels1_11_0;
                texels1_11_v2_1 <= texels1_11_v2_0;
                blend1_signed_1 <= blend1_signed_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: nl1_xy, band1_next, v1_xy, u1_xy
    -- Q4.22: n.l
    nl1_xy_1 <= resize(nl1_x_1, 27) + resize(nl1_y_1, 27);
    -- UQ4.0: at most the last
    band1_next_1 <= to_unsigned(15, 4) when band1_next_exact_1(4) = '1' else
        band1_next_exact_1(3 downto 0);
    -- UQ4.-1: its leading bits
    band1_even_high_1 <= band1_next_1(3 downto 1);
    -- UQ3.0: the even one of both
    band1_even_1 <= band1_even_high_1;
    -- Q4.12: the turned normal
    v1_xy_1 <= resize(v1_x_1, 17) + resize(v1_y_1, 17);
    -- Q8.8: in texels from the middle
    v1_scaled_1 <= v1_xy_1;
    -- Q4.12: the turned normal
    u1_xy_1 <= resize(u1_x_1, 17) + resize(u1_y_1, 17);
    -- UQ7.-4: the first of them
    texels1_00_1 <= band1_even_1;
    -- UQ7.-4: the first of them
    texels1_00_v2_1 <= band1_even_1;
    -- UQ7.-4: the first of them
    texels1_01_1 <= band1_even_1;
    -- UQ7.-4: the first of them
    texels1_01_v2_1 <= band1_even_1;
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

    -- ===== Stage 2: nl1_xyz, v1_place, u1_xyz
    -- Q4.22: n.l
    nl1_xyz_2 <= nl1_xy_2 + resize(nl1_z_2, 27);
    -- Q4.20: rounded down
    nl1_cut_2 <= nl1_xyz_2(26 downto 2);
    -- Q8.8: from the first, plus half a weight's last bit
    v1_place_2 <= v1_scaled_2 + to_signed(3972, 17);
    -- Q8.5: rounded to the nearest weight
    v1_cut_2 <= v1_place_2(16 downto 3);
    -- Q4.12: the turned normal
    u1_xyz_2 <= u1_xy_2 + resize(u1_z_2, 17);
    -- Q8.8: in texels from the middle
    u1_scaled_2 <= u1_xyz_2;
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
                v1_cut_3 <= v1_cut_2;
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

    -- ===== Stage 3: nl1_kept, nl1_up_1, v1_kept, u1_place, v1_weight_of_0 and 4 more
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
    -- UQ5.5: between the outermost centres
    v1_kept_3 <= (others => '0') when v1_cut_3(13) = '1' else
        to_unsigned(992, 10) when v1_cut_3 > 992 else
        unsigned(v1_cut_3(9 downto 0));
    -- UQ5.0: the texel at or below it
    v1_texel_3 <= v1_kept_3(9 downto 5);
    -- UQ0.5: the weight of the next
    v1_weight_3 <= v1_kept_3(4 downto 0);
    -- UQ5.-1: its leading bits
    v1_odd_high_3 <= v1_texel_3(4 downto 1);
    -- UQ4.0: the odd one of both
    v1_odd_3 <= v1_odd_high_3;
    -- UQ1.0: its last bit
    v1_is_odd_3 <= v1_texel_3(0);
    -- UQ1.5: in the wider of two formats
    v1_weight_wide_3 <= resize(v1_weight_3, 6);
    -- Q8.8: from the first, plus half a weight's last bit
    u1_place_3 <= u1_scaled_3 + to_signed(3972, 17);
    -- Q8.5: rounded to the nearest weight
    u1_cut_3 <= u1_place_3(16 downto 3);
    -- UQ-4.5: a bit of the weight
    v1_weight_bit_0_3 <= v1_weight_3(0 downto 0);
    -- UQ-3.4: a bit of the weight
    v1_weight_bit_1_3 <= v1_weight_3(1 downto 1);
    -- UQ-2.3: a bit of the weight
    v1_weight_bit_2_3 <= v1_weight_3(2 downto 2);
    -- UQ-1.2: a bit of the weight
    v1_weight_bit_3_3 <= v1_weight_3(3 downto 3);
    -- UQ0.1: a bit of the weight
    v1_weight_bit_4_3 <= v1_weight_3(4 downto 4);
    -- UQ1.0: as a flag
    v1_weight_of_0_flag_3 <= v1_weight_bit_0_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_0_not_3 <= not v1_weight_of_0_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_0_3 <= v1_weight_of_0_not_3 when v1_is_odd_3 = '1' else v1_weight_of_0_flag_3;
    -- UQ1.0: as a flag
    v1_weight_of_1_flag_3 <= v1_weight_bit_1_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_1_not_3 <= not v1_weight_of_1_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_1_3 <= v1_weight_of_1_not_3 when v1_is_odd_3 = '1' else v1_weight_of_1_flag_3;
    -- UQ1.0: as a flag
    v1_weight_of_2_flag_3 <= v1_weight_bit_2_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_2_not_3 <= not v1_weight_of_2_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_2_3 <= v1_weight_of_2_not_3 when v1_is_odd_3 = '1' else v1_weight_of_2_flag_3;
    -- UQ1.0: as a flag
    v1_weight_of_3_flag_3 <= v1_weight_bit_3_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_3_not_3 <= not v1_weight_of_3_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_3_3 <= v1_weight_of_3_not_3 when v1_is_odd_3 = '1' else v1_weight_of_3_flag_3;
    -- UQ1.0: as a flag
    v1_weight_of_4_flag_3 <= v1_weight_bit_4_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_4_not_3 <= not v1_weight_of_4_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_4_3 <= v1_weight_of_4_not_3 when v1_is_odd_3 = '1' else v1_weight_of_4_flag_3;
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
                v1_texel_4 <= v1_texel_3;
                v1_weight_4 <= v1_weight_3;
                v1_odd_4 <= v1_odd_3;
                v1_is_odd_4 <= v1_is_odd_3;
                v1_weight_wide_4 <= v1_weight_wide_3;
                u1_cut_4 <= u1_cut_3;
                texels1_00_4 <= texels1_00_3;
                texels1_00_v2_4 <= texels1_00_v2_3;
                texels1_01_4 <= texels1_01_3;
                texels1_01_v2_4 <= texels1_01_v2_3;
                texels1_10_4 <= texels1_10_3;
                texels1_10_v2_4 <= texels1_10_v2_3;
                texels1_11_4 <= texels1_11_3;
                texels1_11_v2_4 <= texels1_11_v2_3;
                blend1_signed_4 <= blend1_signed_3;
                v1_weight_of_0_4 <= v1_weight_of_0_3;
                v1_weight_of_1_4 <= v1_weight_of_1_3;
                v1_weight_of_2_4 <= v1_weight_of_2_3;
                v1_weight_of_3_4 <= v1_weight_of_3_3;
                v1_weight_of_4_4 <= v1_weight_of_4_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: nl1_up_2, v1_next_exact, v1_other, v1_odd, u1_kept and 9 more
    -- UQ3.20: times 2^2 if so
    nl1_up_2_4 <= shift_left(resize(nl1_up_1_4, 23), to_integer(nl1_amount_2_4));
    -- UQ6.0: the next
    v1_next_exact_4 <= resize(v1_texel_4, 6) + to_unsigned(1, 6);
    -- UQ1.5: the weight of the place itself
    v1_other_4 <= to_unsigned(32, 6) - resize(v1_weight_4, 6);
    -- UQ1.5: the weight of the odd one
    v1_odd_v2_4 <= v1_other_4 when v1_is_odd_4 = '1' else v1_weight_wide_4;
    -- UQ5.5: between the outermost centres
    u1_kept_4 <= (others => '0') when u1_cut_4(13) = '1' else
        to_unsigned(992, 10) when u1_cut_4 > 992 else
        unsigned(u1_cut_4(9 downto 0));
    -- UQ5.0: the texel at or below it
    u1_texel_4 <= u1_kept_4(9 downto 5);
    -- UQ0.5: the weight of the next
    u1_weight_4 <= u1_kept_4(4 downto 0);
    -- UQ5.-1: its leading bits
    u1_odd_high_4 <= u1_texel_4(4 downto 1);
    -- UQ4.0: the odd one of both
    u1_odd_4 <= u1_odd_high_4;
    -- UQ1.0: its last bit
    u1_is_odd_4 <= u1_texel_4(0);
    -- UQ7.0: side by side
    texel1_01_4 <= shift_left(resize(texels1_01_4, 7), 4) + resize(v1_odd_4, 7);
    -- UQ11.-4: the first of them
    texels1_010_4 <= texel1_01_4;
    -- UQ7.0: side by side
    texel1_01_v2_4 <= shift_left(resize(texels1_01_v2_4, 7), 4) + resize(v1_odd_4, 7);
    -- UQ11.-4: the first of them
    texels1_011_4 <= texel1_01_v2_4;
    -- UQ7.0: side by side
    texel1_11_4 <= shift_left(resize(texels1_11_4, 7), 4) + resize(v1_odd_4, 7);
    -- UQ11.-4: the first of them
    texels1_110_4 <= texel1_11_4;
    -- UQ7.0: side by side
    texel1_11_v2_4 <= shift_left(resize(texels1_11_v2_4, 7), 4) + resize(v1_odd_4, 7);
    -- UQ11.-4: the first of them
    texels1_111_4 <= texel1_11_v2_4;
    -- UQ-4.5: a bit of the weight
    u1_weight_bit_0_4 <= u1_weight_4(0 downto 0);
    -- UQ-3.4: a bit of the weight
    u1_weight_bit_1_4 <= u1_weight_4(1 downto 1);
    -- UQ-2.3: a bit of the weight
    u1_weight_bit_2_4 <= u1_weight_4(2 downto 2);
    -- UQ-1.2: a bit of the weight
    u1_weight_bit_3_4 <= u1_weight_4(3 downto 3);
    -- UQ0.1: a bit of the weight
    u1_weight_bit_4_4 <= u1_weight_4(4 downto 4);
    -- UQ1.0: as a flag
    u1_weight_of_0_flag_4 <= u1_weight_bit_0_4(0);
    -- UQ1.0: it is 0
    u1_weight_of_0_not_4 <= not u1_weight_of_0_flag_4;
    -- UQ1.0: whether it counts for the odd one
    u1_weight_of_0_4 <= u1_weight_of_0_not_4 when u1_is_odd_4 = '1' else u1_weight_of_0_flag_4;
    -- UQ1.0: as a flag
    u1_weight_of_1_flag_4 <= u1_weight_bit_1_4(0);
    -- UQ1.0: it is 0
    u1_weight_of_1_not_4 <= not u1_weight_of_1_flag_4;
    -- UQ1.0: whether it counts for the odd one
    u1_weight_of_1_4 <= u1_weight_of_1_not_4 when u1_is_odd_4 = '1' else u1_weight_of_1_flag_4;
    -- UQ1.0: as a flag
    u1_weight_of_2_flag_4 <= u1_weight_bit_2_4(0);
    -- UQ1.0: it is 0
    u1_weight_of_2_not_4 <= not u1_weight_of_2_flag_4;
    -- UQ1.0: whether it counts for the odd one
    u1_weight_of_2_4 <= u1_weight_of_2_not_4 when u1_is_odd_4 = '1' else u1_weight_of_2_flag_4;
    -- UQ1.0: as a flag
    u1_weight_of_3_flag_4 <= u1_weight_bit_3_4(0);
    -- UQ1.0: it is 0
    u1_weight_of_3_not_4 <= not u1_weight_of_3_flag_4;
    -- UQ1.0: whether it counts for the odd one
    u1_weight_of_3_4 <= u1_weight_of_3_not_4 when u1_is_odd_4 = '1' else u1_weight_of_3_flag_4;
    -- UQ1.0: as a flag
    u1_weight_of_4_flag_4 <= u1_weight_bit_4_4(0);
    -- UQ1.0: it is 0
    u1_weight_of_4_not_4 <= not u1_weight_of_4_flag_4;
    -- UQ1.0: whether it counts for the odd one
    u1_weight_of_4_4 <= u1_weight_of_4_not_4 when u1_is_odd_4 = '1' else u1_weight_of_4_flag_4;
    -- Q1.5: a sign bit for the signed product
    v1_odd_signed_4 <= signed(resize(v1_odd_v2_4, 7));
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
                v1_next_exact_5 <= v1_next_exact_4;
                v1_is_odd_5 <= v1_is_odd_4;
                u1_texel_5 <= u1_texel_4;
                u1_odd_5 <= u1_odd_4;
                u1_is_odd_5 <= u1_is_odd_4;
                texels1_00_5 <= texels1_00_4;
                texels1_00_v2_5 <= texels1_00_v2_4;
                texels1_010_5 <= texels1_010_4;
                texels1_011_5 <= texels1_011_4;
                texels1_10_5 <= texels1_10_4;
                texels1_10_v2_5 <= texels1_10_v2_4;
                texels1_110_5 <= texels1_110_4;
                texels1_111_5 <= texels1_111_4;
                u1_weight_of_0_5 <= u1_weight_of_0_4;
                u1_weight_of_1_5 <= u1_weight_of_1_4;
                u1_weight_of_2_5 <= u1_weight_of_2_4;
                u1_weight_of_3_5 <= u1_weight_of_3_4;
                u1_weight_of_4_5 <= u1_weight_of_4_4;
                v1_odd_signed_5 <= v1_odd_signed_4;
                blend1_signed_5 <= blend1_signed_4;
                v1_weight_of_0_5 <= v1_weight_of_0_4;
                v1_weight_of_1_5 <= v1_weight_of_1_4;
                v1_weight_of_2_5 <= v1_weight_of_2_4;
                v1_weight_of_3_5 <= v1_weight_of_3_4;
                v1_weight_of_4_5 <= v1_weight_of_4_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: nl1_up_4, nl1_up, nl1_within, v1_next, u1_next_exact and 2 more
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
    -- UQ5.0: at most the last
    v1_next_5 <= to_unsigned(31, 5) when v1_next_exact_5(5) = '1' else
        v1_next_exact_5(4 downto 0);
    -- UQ5.-1: its leading bits
    v1_even_high_5 <= v1_next_5(4 downto 1);
    -- UQ4.0: the even one of both
    v1_even_5 <= v1_even_high_5;
    -- UQ6.0: the next
    u1_next_exact_5 <= resize(u1_texel_5, 6) + to_unsigned(1, 6);
    -- UQ11.0: side by side
    texel1_011_5 <= shift_left(resize(texels1_011_5, 11), 4) + resize(u1_odd_5, 11);
    -- UQ11.0: side by side
    texel1_111_5 <= shift_left(resize(texels1_111_5, 11), 4) + resize(u1_odd_5, 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_6 <= in_gain1r_5;
                in_gain1g_6 <= in_gain1g_5;
                in_gain1b_6 <= in_gain1b_5;
                hidden_6 <= hidden_5;
                nl1_within_6 <= nl1_within_5;
                v1_even_6 <= v1_even_5;
                v1_is_odd_6 <= v1_is_odd_5;
                u1_next_exact_6 <= u1_next_exact_5;
                u1_odd_6 <= u1_odd_5;
                u1_is_odd_6 <= u1_is_odd_5;
                texels1_00_6 <= texels1_00_5;
                texels1_00_v2_6 <= texels1_00_v2_5;
                texels1_010_6 <= texels1_010_5;
                texel1_011_6 <= texel1_011_5;
                texels1_10_6 <= texels1_10_5;
                texels1_10_v2_6 <= texels1_10_v2_5;
                texels1_110_6 <= texels1_110_5;
                texel1_111_6 <= texel1_111_5;
                u1_weight_of_0_6 <= u1_weight_of_0_5;
                u1_weight_of_1_6 <= u1_weight_of_1_5;
                u1_weight_of_2_6 <= u1_weight_of_2_5;
                u1_weight_of_3_6 <= u1_weight_of_3_5;
                u1_weight_of_4_6 <= u1_weight_of_4_5;
                v1_odd_signed_6 <= v1_odd_signed_5;
                blend1_signed_6 <= blend1_signed_5;
                v1_weight_of_0_6 <= v1_weight_of_0_5;
                v1_weight_of_1_6 <= v1_weight_of_1_5;
                v1_weight_of_2_6 <= v1_weight_of_2_5;
                v1_weight_of_3_6 <= v1_weight_of_3_5;
                v1_weight_of_4_6 <= v1_weight_of_4_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: nl1, u1_next, texel1_00, texel1_00, texel1_10, texel1_10
    -- UQ7.11: n.l, 0 for a normal that is turned away
    nl1_6 <= (others => '0') when hidden_6 = '1' else nl1_within_6;
    -- UQ5.0: at most the last
    u1_next_6 <= to_unsigned(31, 5) when u1_next_exact_6(5) = '1' else
        u1_next_exact_6(4 downto 0);
    -- UQ5.-1: its leading bits
    u1_even_high_6 <= u1_next_6(4 downto 1);
    -- UQ4.0: the even one of both
    u1_even_6 <= u1_even_high_6;
    -- UQ7.0: side by side
    texel1_00_6 <= shift_left(resize(texels1_00_6, 7), 4) + resize(v1_even_6, 7);
    -- UQ11.-4: the first of them
    texels1_000_6 <= texel1_00_6;
    -- UQ7.0: side by side
    texel1_00_v2_6 <= shift_left(resize(texels1_00_v2_6, 7), 4) + resize(v1_even_6, 7);
    -- UQ11.-4: the first of them
    texels1_001_6 <= texel1_00_v2_6;
    -- UQ7.0: side by side
    texel1_10_6 <= shift_left(resize(texels1_10_6, 7), 4) + resize(v1_even_6, 7);
    -- UQ11.-4: the first of them
    texels1_100_6 <= texel1_10_6;
    -- UQ7.0: side by side
    texel1_10_v2_6 <= shift_left(resize(texels1_10_v2_6, 7), 4) + resize(v1_even_6, 7);
    -- UQ11.-4: the first of them
    texels1_101_6 <= texel1_10_v2_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_7 <= in_gain1r_6;
                in_gain1g_7 <= in_gain1g_6;
                in_gain1b_7 <= in_gain1b_6;
                nl1_7 <= nl1_6;
                v1_is_odd_7 <= v1_is_odd_6;
                u1_even_7 <= u1_even_6;
                u1_odd_7 <= u1_odd_6;
                u1_is_odd_7 <= u1_is_odd_6;
                texels1_000_7 <= texels1_000_6;
                texels1_001_7 <= texels1_001_6;
                texels1_010_7 <= texels1_010_6;
                texel1_011_7 <= texel1_011_6;
                texels1_100_7 <= texels1_100_6;
                texels1_101_7 <= texels1_101_6;
                texels1_110_7 <= texels1_110_6;
                texel1_111_7 <= texel1_111_6;
                u1_weight_of_0_7 <= u1_weight_of_0_6;
                u1_weight_of_1_7 <= u1_weight_of_1_6;
                u1_weight_of_2_7 <= u1_weight_of_2_6;
                u1_weight_of_3_7 <= u1_weight_of_3_6;
                u1_weight_of_4_7 <= u1_weight_of_4_6;
                v1_odd_signed_7 <= v1_odd_signed_6;
                blend1_signed_7 <= blend1_signed_6;
                v1_weight_of_0_7 <= v1_weight_of_0_6;
                v1_weight_of_1_7 <= v1_weight_of_1_6;
                v1_weight_of_2_7 <= v1_weight_of_2_6;
                v1_weight_of_3_7 <= v1_weight_of_3_6;
                v1_weight_of_4_7 <= v1_weight_of_4_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: texel1_000, texel1_001, texel1_010, texel1_100, texel1_101 and 1 more
    -- UQ11.0: side by side
    texel1_000_7 <= shift_left(resize(texels1_000_7, 11), 4) + resize(u1_even_7, 11);
    -- UQ11.0: side by side
    texel1_001_7 <= shift_left(resize(texels1_001_7, 11), 4) + resize(u1_odd_7, 11);
    -- UQ11.0: side by side
    texel1_010_7 <= shift_left(resize(texels1_010_7, 11), 4) + resize(u1_even_7, 11);
    -- UQ11.0: side by side
    texel1_100_7 <= shift_left(resize(texels1_100_7, 11), 4) + resize(u1_even_7, 11);
    -- UQ11.0: side by side
    texel1_101_7 <= shift_left(resize(texels1_101_7, 11), 4) + resize(u1_odd_7, 11);
    -- UQ11.0: side by side
    texel1_110_7 <= shift_left(resize(texels1_110_7, 11), 4) + resize(u1_even_7, 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_8 <= in_gain1r_7;
                in_gain1g_8 <= in_gain1g_7;
                in_gain1b_8 <= in_gain1b_7;
                nl1_8 <= nl1_7;
                v1_is_odd_8 <= v1_is_odd_7;
                u1_is_odd_8 <= u1_is_odd_7;
                texel1_000_8 <= texel1_000_7;
                texel1_001_8 <= texel1_001_7;
                texel1_010_8 <= texel1_010_7;
                texel1_011_8 <= texel1_011_7;
                texel1_100_8 <= texel1_100_7;
                texel1_101_8 <= texel1_101_7;
                texel1_110_8 <= texel1_110_7;
                texel1_111_8 <= texel1_111_7;
                u1_weight_of_0_8 <= u1_weight_of_0_7;
                u1_weight_of_1_8 <= u1_weight_of_1_7;
                u1_weight_of_2_8 <= u1_weight_of_2_7;
                u1_weight_of_3_8 <= u1_weight_of_3_7;
                u1_weight_of_4_8 <= u1_weight_of_4_7;
                v1_odd_signed_8 <= v1_odd_signed_7;
                blend1_signed_8 <= blend1_signed_7;
                v1_weight_of_0_8 <= v1_weight_of_0_7;
                v1_weight_of_1_8 <= v1_weight_of_1_7;
                v1_weight_of_2_8 <= v1_weight_of_2_7;
                v1_weight_of_3_8 <= v1_weight_of_3_7;
                v1_weight_of_4_8 <= v1_weight_of_4_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_even_9 <= TEXELS_1_EVEN_EVEN_EVEN(to_integer(texel1_000_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_odd_9 <= TEXELS_1_EVEN_EVEN_ODD(to_integer(texel1_001_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_even_9 <= TEXELS_1_EVEN_ODD_EVEN(to_integer(texel1_010_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_odd_9 <= TEXELS_1_EVEN_ODD_ODD(to_integer(texel1_011_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_even_9 <= TEXELS_1_ODD_EVEN_EVEN(to_integer(texel1_100_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_odd_9 <= TEXELS_1_ODD_EVEN_ODD(to_integer(texel1_101_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_even_9 <= TEXELS_1_ODD_ODD_EVEN(to_integer(texel1_110_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_odd_9 <= TEXELS_1_ODD_ODD_ODD(to_integer(texel1_111_8));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_9 <= in_gain1r_8;
                in_gain1g_9 <= in_gain1g_8;
                in_gain1b_9 <= in_gain1b_8;
                nl1_9 <= nl1_8;
                v1_is_odd_9 <= v1_is_odd_8;
                u1_is_odd_9 <= u1_is_odd_8;
                u1_weight_of_0_9 <= u1_weight_of_0_8;
                u1_weight_of_1_9 <= u1_weight_of_1_8;
                u1_weight_of_2_9 <= u1_weight_of_2_8;
                u1_weight_of_3_9 <= u1_weight_of_3_8;
                u1_weight_of_4_9 <= u1_weight_of_4_8;
                v1_odd_signed_9 <= v1_odd_signed_8;
                blend1_signed_9 <= blend1_signed_8;
                v1_weight_of_0_9 <= v1_weight_of_0_8;
                v1_weight_of_1_9 <= v1_weight_of_1_8;
                v1_weight_of_2_9 <= v1_weight_of_2_8;
                v1_weight_of_3_9 <= v1_weight_of_3_8;
                v1_weight_of_4_9 <= v1_weight_of_4_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: registers only
    -- UQ0.8: red
    texels_1_even_even_even_r_9 <= unsigned(texels_1_even_even_even_9(23 downto 16));
    -- UQ0.8: red
    texels_1_even_even_odd_r_9 <= unsigned(texels_1_even_even_odd_9(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_even_r_9 <= unsigned(texels_1_even_odd_even_9(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_odd_r_9 <= unsigned(texels_1_even_odd_odd_9(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_even_r_9 <= unsigned(texels_1_odd_even_even_9(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_odd_r_9 <= unsigned(texels_1_odd_even_odd_9(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_even_r_9 <= unsigned(texels_1_odd_odd_even_9(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_odd_r_9 <= unsigned(texels_1_odd_odd_odd_9(23 downto 16));
    -- UQ0.8: green
    texels_1_even_even_even_g_9 <= unsigned(texels_1_even_even_even_9(15 downto 8));
    -- UQ0.8: green
    texels_1_even_even_odd_g_9 <= unsigned(texels_1_even_even_odd_9(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_even_g_9 <= unsigned(texels_1_even_odd_even_9(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_odd_g_9 <= unsigned(texels_1_even_odd_odd_9(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_even_g_9 <= unsigned(texels_1_odd_even_even_9(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_odd_g_9 <= unsigned(texels_1_odd_even_odd_9(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_even_g_9 <= unsigned(texels_1_odd_odd_even_9(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_odd_g_9 <= unsigned(texels_1_odd_odd_odd_9(15 downto 8));
    -- UQ0.8: blue
    texels_1_even_even_even_b_9 <= unsigned(texels_1_even_even_even_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_even_odd_b_9 <= unsigned(texels_1_even_even_odd_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_even_b_9 <= unsigned(texels_1_even_odd_even_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_odd_b_9 <= unsigned(texels_1_even_odd_odd_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_even_b_9 <= unsigned(texels_1_odd_even_even_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_odd_b_9 <= unsigned(texels_1_odd_even_odd_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_even_b_9 <= unsigned(texels_1_odd_odd_even_9(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_odd_b_9 <= unsigned(texels_1_odd_odd_odd_9(7 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_10 <= in_gain1r_9;
                in_gain1g_10 <= in_gain1g_9;
                in_gain1b_10 <= in_gain1b_9;
                nl1_10 <= nl1_9;
                v1_is_odd_10 <= v1_is_odd_9;
                u1_is_odd_10 <= u1_is_odd_9;
                texels_1_even_even_even_r_10 <= texels_1_even_even_even_r_9;
                texels_1_even_even_odd_r_10 <= texels_1_even_even_odd_r_9;
                texels_1_even_odd_even_r_10 <= texels_1_even_odd_even_r_9;
                texels_1_even_odd_odd_r_10 <= texels_1_even_odd_odd_r_9;
                texels_1_odd_even_even_r_10 <= texels_1_odd_even_even_r_9;
                texels_1_odd_even_odd_r_10 <= texels_1_odd_even_odd_r_9;
                texels_1_odd_odd_even_r_10 <= texels_1_odd_odd_even_r_9;
                texels_1_odd_odd_odd_r_10 <= texels_1_odd_odd_odd_r_9;
                u1_weight_of_0_10 <= u1_weight_of_0_9;
                u1_weight_of_1_10 <= u1_weight_of_1_9;
                u1_weight_of_2_10 <= u1_weight_of_2_9;
                u1_weight_of_3_10 <= u1_weight_of_3_9;
                u1_weight_of_4_10 <= u1_weight_of_4_9;
                v1_odd_signed_10 <= v1_odd_signed_9;
                blend1_signed_10 <= blend1_signed_9;
                texels_1_even_even_even_g_10 <= texels_1_even_even_even_g_9;
                texels_1_even_even_odd_g_10 <= texels_1_even_even_odd_g_9;
                texels_1_even_odd_even_g_10 <= texels_1_even_odd_even_g_9;
                texels_1_even_odd_odd_g_10 <= texels_1_even_odd_odd_g_9;
                texels_1_odd_even_even_g_10 <= texels_1_odd_even_even_g_9;
                texels_1_odd_even_odd_g_10 <= texels_1_odd_even_odd_g_9;
                texels_1_odd_odd_even_g_10 <= texels_1_odd_odd_even_g_9;
                texels_1_odd_odd_odd_g_10 <= texels_1_odd_odd_odd_g_9;
                v1_weight_of_0_10 <= v1_weight_of_0_9;
                v1_weight_of_1_10 <= v1_weight_of_1_9;
                v1_weight_of_2_10 <= v1_weight_of_2_9;
                v1_weight_of_3_10 <= v1_weight_of_3_9;
                v1_weight_of_4_10 <= v1_weight_of_4_9;
                texels_1_even_even_even_b_10 <= texels_1_even_even_even_b_9;
                texels_1_even_even_odd_b_10 <= texels_1_even_even_odd_b_9;
                texels_1_even_odd_even_b_10 <= texels_1_even_odd_even_b_9;
                texels_1_even_odd_odd_b_10 <= texels_1_even_odd_odd_b_9;
                texels_1_odd_even_even_b_10 <= texels_1_odd_even_even_b_9;
                texels_1_odd_even_odd_b_10 <= texels_1_odd_even_odd_b_9;
                texels_1_odd_odd_even_b_10 <= texels_1_odd_odd_even_b_9;
                texels_1_odd_odd_odd_b_10 <= texels_1_odd_odd_odd_b_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_11 <= in_gain1r_10;
                in_gain1g_11 <= in_gain1g_10;
                in_gain1b_11 <= in_gain1b_10;
                nl1_11 <= nl1_10;
                v1_is_odd_11 <= v1_is_odd_10;
                u1_is_odd_11 <= u1_is_odd_10;
                texels_1_even_even_even_r_11 <= texels_1_even_even_even_r_10;
                texels_1_even_even_odd_r_11 <= texels_1_even_even_odd_r_10;
                texels_1_even_odd_even_r_11 <= texels_1_even_odd_even_r_10;
                texels_1_even_odd_odd_r_11 <= texels_1_even_odd_odd_r_10;
                texels_1_odd_even_even_r_11 <= texels_1_odd_even_even_r_10;
                texels_1_odd_even_odd_r_11 <= texels_1_odd_even_odd_r_10;
                texels_1_odd_odd_even_r_11 <= texels_1_odd_odd_even_r_10;
                texels_1_odd_odd_odd_r_11 <= texels_1_odd_odd_odd_r_10;
                u1_weight_of_0_11 <= u1_weight_of_0_10;
                u1_weight_of_1_11 <= u1_weight_of_1_10;
                u1_weight_of_2_11 <= u1_weight_of_2_10;
                u1_weight_of_3_11 <= u1_weight_of_3_10;
                u1_weight_of_4_11 <= u1_weight_of_4_10;
                v1_odd_signed_11 <= v1_odd_signed_10;
                blend1_signed_11 <= blend1_signed_10;
                texels_1_even_even_even_g_11 <= texels_1_even_even_even_g_10;
                texels_1_even_even_odd_g_11 <= texels_1_even_even_odd_g_10;
                texels_1_even_odd_even_g_11 <= texels_1_even_odd_even_g_10;
                texels_1_even_odd_odd_g_11 <= texels_1_even_odd_odd_g_10;
                texels_1_odd_even_even_g_11 <= texels_1_odd_even_even_g_10;
                texels_1_odd_even_odd_g_11 <= texels_1_odd_even_odd_g_10;
                texels_1_odd_odd_even_g_11 <= texels_1_odd_odd_even_g_10;
                texels_1_odd_odd_odd_g_11 <= texels_1_odd_odd_odd_g_10;
                v1_weight_of_0_11 <= v1_weight_of_0_10;
                v1_weight_of_1_11 <= v1_weight_of_1_10;
                v1_weight_of_2_11 <= v1_weight_of_2_10;
                v1_weight_of_3_11 <= v1_weight_of_3_10;
                v1_weight_of_4_11 <= v1_weight_of_4_10;
                texels_1_even_even_even_b_11 <= texels_1_even_even_even_b_10;
                texels_1_even_even_odd_b_11 <= texels_1_even_even_odd_b_10;
                texels_1_even_odd_even_b_11 <= texels_1_even_odd_even_b_10;
                texels_1_even_odd_odd_b_11 <= texels_1_even_odd_odd_b_10;
                texels_1_odd_even_even_b_11 <= texels_1_odd_even_even_b_10;
                texels_1_odd_even_odd_b_11 <= texels_1_odd_even_odd_b_10;
                texels_1_odd_odd_even_b_11 <= texels_1_odd_odd_even_b_10;
                texels_1_odd_odd_odd_b_11 <= texels_1_odd_odd_odd_b_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 106 more
    -- UQ0.8: either of both
    blend1_r_1_0_either_first_11 <=
        texels_1_even_even_odd_r_11 when u1_is_odd_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_0_by_first_11 <= blend1_r_1_0_either_first_11;
    -- UQ0.8: either of both
    blend1_r_1_0_either_0_11 <=
        texels_1_even_even_odd_r_11 when u1_weight_of_0_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_0_by_0_11 <= blend1_r_1_0_either_0_11;
    -- UQ0.8: either of both
    blend1_r_1_0_either_1_11 <=
        texels_1_even_even_odd_r_11 when u1_weight_of_1_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-4.12: shifted
    blend1_r_1_0_by_1_11 <= blend1_r_1_0_either_1_11;
    -- UQ0.8: either of both
    blend1_r_1_0_either_2_11 <=
        texels_1_even_even_odd_r_11 when u1_weight_of_2_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-3.11: shifted
    blend1_r_1_0_by_2_11 <= blend1_r_1_0_either_2_11;
    -- UQ0.8: either of both
    blend1_r_1_0_either_3_11 <=
        texels_1_even_even_odd_r_11 when u1_weight_of_3_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-2.10: shifted
    blend1_r_1_0_by_3_11 <= blend1_r_1_0_either_3_11;
    -- UQ0.8: either of both
    blend1_r_1_0_either_4_11 <=
        texels_1_even_even_odd_r_11 when u1_weight_of_4_11 = '1' else texels_1_even_even_even_r_11;
    -- UQ-1.9: shifted
    blend1_r_1_0_by_4_11 <= blend1_r_1_0_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_r_1_0_sum_1_0_11 <=
        resize(blend1_r_1_0_by_first_11, 9) + resize(blend1_r_1_0_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_r_1_0_sum_1_1_11 <=
        resize(blend1_r_1_0_by_1_11, 10) + shift_left(resize(blend1_r_1_0_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_r_1_0_sum_1_2_11 <=
        resize(blend1_r_1_0_by_3_11, 10) + shift_left(resize(blend1_r_1_0_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_1_either_first_11 <=
        texels_1_even_odd_odd_r_11 when u1_is_odd_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_1_by_first_11 <= blend1_r_1_1_either_first_11;
    -- UQ0.8: either of both
    blend1_r_1_1_either_0_11 <=
        texels_1_even_odd_odd_r_11 when u1_weight_of_0_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_1_by_0_11 <= blend1_r_1_1_either_0_11;
    -- UQ0.8: either of both
    blend1_r_1_1_either_1_11 <=
        texels_1_even_odd_odd_r_11 when u1_weight_of_1_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-4.12: shifted
    blend1_r_1_1_by_1_11 <= blend1_r_1_1_either_1_11;
    -- UQ0.8: either of both
    blend1_r_1_1_either_2_11 <=
        texels_1_even_odd_odd_r_11 when u1_weight_of_2_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-3.11: shifted
    blend1_r_1_1_by_2_11 <= blend1_r_1_1_either_2_11;
    -- UQ0.8: either of both
    blend1_r_1_1_either_3_11 <=
        texels_1_even_odd_odd_r_11 when u1_weight_of_3_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-2.10: shifted
    blend1_r_1_1_by_3_11 <= blend1_r_1_1_either_3_11;
    -- UQ0.8: either of both
    blend1_r_1_1_either_4_11 <=
        texels_1_even_odd_odd_r_11 when u1_weight_of_4_11 = '1' else texels_1_even_odd_even_r_11;
    -- UQ-1.9: shifted
    blend1_r_1_1_by_4_11 <= blend1_r_1_1_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_r_1_1_sum_1_0_11 <=
        resize(blend1_r_1_1_by_first_11, 9) + resize(blend1_r_1_1_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_r_1_1_sum_1_1_11 <=
        resize(blend1_r_1_1_by_1_11, 10) + shift_left(resize(blend1_r_1_1_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_r_1_1_sum_1_2_11 <=
        resize(blend1_r_1_1_by_3_11, 10) + shift_left(resize(blend1_r_1_1_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_2_either_first_11 <=
        texels_1_odd_even_odd_r_11 when u1_is_odd_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_2_by_first_11 <= blend1_r_1_2_either_first_11;
    -- UQ0.8: either of both
    blend1_r_1_2_either_0_11 <=
        texels_1_odd_even_odd_r_11 when u1_weight_of_0_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_2_by_0_11 <= blend1_r_1_2_either_0_11;
    -- UQ0.8: either of both
    blend1_r_1_2_either_1_11 <=
        texels_1_odd_even_odd_r_11 when u1_weight_of_1_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-4.12: shifted
    blend1_r_1_2_by_1_11 <= blend1_r_1_2_either_1_11;
    -- UQ0.8: either of both
    blend1_r_1_2_either_2_11 <=
        texels_1_odd_even_odd_r_11 when u1_weight_of_2_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-3.11: shifted
    blend1_r_1_2_by_2_11 <= blend1_r_1_2_either_2_11;
    -- UQ0.8: either of both
    blend1_r_1_2_either_3_11 <=
        texels_1_odd_even_odd_r_11 when u1_weight_of_3_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-2.10: shifted
    blend1_r_1_2_by_3_11 <= blend1_r_1_2_either_3_11;
    -- UQ0.8: either of both
    blend1_r_1_2_either_4_11 <=
        texels_1_odd_even_odd_r_11 when u1_weight_of_4_11 = '1' else texels_1_odd_even_even_r_11;
    -- UQ-1.9: shifted
    blend1_r_1_2_by_4_11 <= blend1_r_1_2_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_r_1_2_sum_1_0_11 <=
        resize(blend1_r_1_2_by_first_11, 9) + resize(blend1_r_1_2_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_r_1_2_sum_1_1_11 <=
        resize(blend1_r_1_2_by_1_11, 10) + shift_left(resize(blend1_r_1_2_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_r_1_2_sum_1_2_11 <=
        resize(blend1_r_1_2_by_3_11, 10) + shift_left(resize(blend1_r_1_2_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_3_either_first_11 <=
        texels_1_odd_odd_odd_r_11 when u1_is_odd_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_3_by_first_11 <= blend1_r_1_3_either_first_11;
    -- UQ0.8: either of both
    blend1_r_1_3_either_0_11 <=
        texels_1_odd_odd_odd_r_11 when u1_weight_of_0_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-5.13: shifted
    blend1_r_1_3_by_0_11 <= blend1_r_1_3_either_0_11;
    -- UQ0.8: either of both
    blend1_r_1_3_either_1_11 <=
        texels_1_odd_odd_odd_r_11 when u1_weight_of_1_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-4.12: shifted
    blend1_r_1_3_by_1_11 <= blend1_r_1_3_either_1_11;
    -- UQ0.8: either of both
    blend1_r_1_3_either_2_11 <=
        texels_1_odd_odd_odd_r_11 when u1_weight_of_2_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-3.11: shifted
    blend1_r_1_3_by_2_11 <= blend1_r_1_3_either_2_11;
    -- UQ0.8: either of both
    blend1_r_1_3_either_3_11 <=
        texels_1_odd_odd_odd_r_11 when u1_weight_of_3_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-2.10: shifted
    blend1_r_1_3_by_3_11 <= blend1_r_1_3_either_3_11;
    -- UQ0.8: either of both
    blend1_r_1_3_either_4_11 <=
        texels_1_odd_odd_odd_r_11 when u1_weight_of_4_11 = '1' else texels_1_odd_odd_even_r_11;
    -- UQ-1.9: shifted
    blend1_r_1_3_by_4_11 <= blend1_r_1_3_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_r_1_3_sum_1_0_11 <=
        resize(blend1_r_1_3_by_first_11, 9) + resize(blend1_r_1_3_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_r_1_3_sum_1_1_11 <=
        resize(blend1_r_1_3_by_1_11, 10) + shift_left(resize(blend1_r_1_3_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_r_1_3_sum_1_2_11 <=
        resize(blend1_r_1_3_by_3_11, 10) + shift_left(resize(blend1_r_1_3_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_0_either_first_11 <=
        texels_1_even_even_odd_g_11 when u1_is_odd_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_0_by_first_11 <= blend1_g_1_0_either_first_11;
    -- UQ0.8: either of both
    blend1_g_1_0_either_0_11 <=
        texels_1_even_even_odd_g_11 when u1_weight_of_0_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_0_by_0_11 <= blend1_g_1_0_either_0_11;
    -- UQ0.8: either of both
    blend1_g_1_0_either_1_11 <=
        texels_1_even_even_odd_g_11 when u1_weight_of_1_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-4.12: shifted
    blend1_g_1_0_by_1_11 <= blend1_g_1_0_either_1_11;
    -- UQ0.8: either of both
    blend1_g_1_0_either_2_11 <=
        texels_1_even_even_odd_g_11 when u1_weight_of_2_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-3.11: shifted
    blend1_g_1_0_by_2_11 <= blend1_g_1_0_either_2_11;
    -- UQ0.8: either of both
    blend1_g_1_0_either_3_11 <=
        texels_1_even_even_odd_g_11 when u1_weight_of_3_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-2.10: shifted
    blend1_g_1_0_by_3_11 <= blend1_g_1_0_either_3_11;
    -- UQ0.8: either of both
    blend1_g_1_0_either_4_11 <=
        texels_1_even_even_odd_g_11 when u1_weight_of_4_11 = '1' else texels_1_even_even_even_g_11;
    -- UQ-1.9: shifted
    blend1_g_1_0_by_4_11 <= blend1_g_1_0_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_g_1_0_sum_1_0_11 <=
        resize(blend1_g_1_0_by_first_11, 9) + resize(blend1_g_1_0_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_g_1_0_sum_1_1_11 <=
        resize(blend1_g_1_0_by_1_11, 10) + shift_left(resize(blend1_g_1_0_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_g_1_0_sum_1_2_11 <=
        resize(blend1_g_1_0_by_3_11, 10) + shift_left(resize(blend1_g_1_0_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_1_either_first_11 <=
        texels_1_even_odd_odd_g_11 when u1_is_odd_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_1_by_first_11 <= blend1_g_1_1_either_first_11;
    -- UQ0.8: either of both
    blend1_g_1_1_either_0_11 <=
        texels_1_even_odd_odd_g_11 when u1_weight_of_0_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_1_by_0_11 <= blend1_g_1_1_either_0_11;
    -- UQ0.8: either of both
    blend1_g_1_1_either_1_11 <=
        texels_1_even_odd_odd_g_11 when u1_weight_of_1_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-4.12: shifted
    blend1_g_1_1_by_1_11 <= blend1_g_1_1_either_1_11;
    -- UQ0.8: either of both
    blend1_g_1_1_either_2_11 <=
        texels_1_even_odd_odd_g_11 when u1_weight_of_2_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-3.11: shifted
    blend1_g_1_1_by_2_11 <= blend1_g_1_1_either_2_11;
    -- UQ0.8: either of both
    blend1_g_1_1_either_3_11 <=
        texels_1_even_odd_odd_g_11 when u1_weight_of_3_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-2.10: shifted
    blend1_g_1_1_by_3_11 <= blend1_g_1_1_either_3_11;
    -- UQ0.8: either of both
    blend1_g_1_1_either_4_11 <=
        texels_1_even_odd_odd_g_11 when u1_weight_of_4_11 = '1' else texels_1_even_odd_even_g_11;
    -- UQ-1.9: shifted
    blend1_g_1_1_by_4_11 <= blend1_g_1_1_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_g_1_1_sum_1_0_11 <=
        resize(blend1_g_1_1_by_first_11, 9) + resize(blend1_g_1_1_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_g_1_1_sum_1_1_11 <=
        resize(blend1_g_1_1_by_1_11, 10) + shift_left(resize(blend1_g_1_1_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_g_1_1_sum_1_2_11 <=
        resize(blend1_g_1_1_by_3_11, 10) + shift_left(resize(blend1_g_1_1_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_2_either_first_11 <=
        texels_1_odd_even_odd_g_11 when u1_is_odd_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_2_by_first_11 <= blend1_g_1_2_either_first_11;
    -- UQ0.8: either of both
    blend1_g_1_2_either_0_11 <=
        texels_1_odd_even_odd_g_11 when u1_weight_of_0_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_2_by_0_11 <= blend1_g_1_2_either_0_11;
    -- UQ0.8: either of both
    blend1_g_1_2_either_1_11 <=
        texels_1_odd_even_odd_g_11 when u1_weight_of_1_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-4.12: shifted
    blend1_g_1_2_by_1_11 <= blend1_g_1_2_either_1_11;
    -- UQ0.8: either of both
    blend1_g_1_2_either_2_11 <=
        texels_1_odd_even_odd_g_11 when u1_weight_of_2_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-3.11: shifted
    blend1_g_1_2_by_2_11 <= blend1_g_1_2_either_2_11;
    -- UQ0.8: either of both
    blend1_g_1_2_either_3_11 <=
        texels_1_odd_even_odd_g_11 when u1_weight_of_3_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-2.10: shifted
    blend1_g_1_2_by_3_11 <= blend1_g_1_2_either_3_11;
    -- UQ0.8: either of both
    blend1_g_1_2_either_4_11 <=
        texels_1_odd_even_odd_g_11 when u1_weight_of_4_11 = '1' else texels_1_odd_even_even_g_11;
    -- UQ-1.9: shifted
    blend1_g_1_2_by_4_11 <= blend1_g_1_2_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_g_1_2_sum_1_0_11 <=
        resize(blend1_g_1_2_by_first_11, 9) + resize(blend1_g_1_2_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_g_1_2_sum_1_1_11 <=
        resize(blend1_g_1_2_by_1_11, 10) + shift_left(resize(blend1_g_1_2_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_g_1_2_sum_1_2_11 <=
        resize(blend1_g_1_2_by_3_11, 10) + shift_left(resize(blend1_g_1_2_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_3_either_first_11 <=
        texels_1_odd_odd_odd_g_11 when u1_is_odd_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_3_by_first_11 <= blend1_g_1_3_either_first_11;
    -- UQ0.8: either of both
    blend1_g_1_3_either_0_11 <=
        texels_1_odd_odd_odd_g_11 when u1_weight_of_0_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-5.13: shifted
    blend1_g_1_3_by_0_11 <= blend1_g_1_3_either_0_11;
    -- UQ0.8: either of both
    blend1_g_1_3_either_1_11 <=
        texels_1_odd_odd_odd_g_11 when u1_weight_of_1_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-4.12: shifted
    blend1_g_1_3_by_1_11 <= blend1_g_1_3_either_1_11;
    -- UQ0.8: either of both
    blend1_g_1_3_either_2_11 <=
        texels_1_odd_odd_odd_g_11 when u1_weight_of_2_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-3.11: shifted
    blend1_g_1_3_by_2_11 <= blend1_g_1_3_either_2_11;
    -- UQ0.8: either of both
    blend1_g_1_3_either_3_11 <=
        texels_1_odd_odd_odd_g_11 when u1_weight_of_3_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-2.10: shifted
    blend1_g_1_3_by_3_11 <= blend1_g_1_3_either_3_11;
    -- UQ0.8: either of both
    blend1_g_1_3_either_4_11 <=
        texels_1_odd_odd_odd_g_11 when u1_weight_of_4_11 = '1' else texels_1_odd_odd_even_g_11;
    -- UQ-1.9: shifted
    blend1_g_1_3_by_4_11 <= blend1_g_1_3_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_g_1_3_sum_1_0_11 <=
        resize(blend1_g_1_3_by_first_11, 9) + resize(blend1_g_1_3_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_g_1_3_sum_1_1_11 <=
        resize(blend1_g_1_3_by_1_11, 10) + shift_left(resize(blend1_g_1_3_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_g_1_3_sum_1_2_11 <=
        resize(blend1_g_1_3_by_3_11, 10) + shift_left(resize(blend1_g_1_3_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_0_either_first_11 <=
        texels_1_even_even_odd_b_11 when u1_is_odd_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_0_by_first_11 <= blend1_b_1_0_either_first_11;
    -- UQ0.8: either of both
    blend1_b_1_0_either_0_11 <=
        texels_1_even_even_odd_b_11 when u1_weight_of_0_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_0_by_0_11 <= blend1_b_1_0_either_0_11;
    -- UQ0.8: either of both
    blend1_b_1_0_either_1_11 <=
        texels_1_even_even_odd_b_11 when u1_weight_of_1_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-4.12: shifted
    blend1_b_1_0_by_1_11 <= blend1_b_1_0_either_1_11;
    -- UQ0.8: either of both
    blend1_b_1_0_either_2_11 <=
        texels_1_even_even_odd_b_11 when u1_weight_of_2_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-3.11: shifted
    blend1_b_1_0_by_2_11 <= blend1_b_1_0_either_2_11;
    -- UQ0.8: either of both
    blend1_b_1_0_either_3_11 <=
        texels_1_even_even_odd_b_11 when u1_weight_of_3_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-2.10: shifted
    blend1_b_1_0_by_3_11 <= blend1_b_1_0_either_3_11;
    -- UQ0.8: either of both
    blend1_b_1_0_either_4_11 <=
        texels_1_even_even_odd_b_11 when u1_weight_of_4_11 = '1' else texels_1_even_even_even_b_11;
    -- UQ-1.9: shifted
    blend1_b_1_0_by_4_11 <= blend1_b_1_0_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_b_1_0_sum_1_0_11 <=
        resize(blend1_b_1_0_by_first_11, 9) + resize(blend1_b_1_0_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_b_1_0_sum_1_1_11 <=
        resize(blend1_b_1_0_by_1_11, 10) + shift_left(resize(blend1_b_1_0_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_b_1_0_sum_1_2_11 <=
        resize(blend1_b_1_0_by_3_11, 10) + shift_left(resize(blend1_b_1_0_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_1_either_first_11 <=
        texels_1_even_odd_odd_b_11 when u1_is_odd_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_1_by_first_11 <= blend1_b_1_1_either_first_11;
    -- UQ0.8: either of both
    blend1_b_1_1_either_0_11 <=
        texels_1_even_odd_odd_b_11 when u1_weight_of_0_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_1_by_0_11 <= blend1_b_1_1_either_0_11;
    -- UQ0.8: either of both
    blend1_b_1_1_either_1_11 <=
        texels_1_even_odd_odd_b_11 when u1_weight_of_1_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-4.12: shifted
    blend1_b_1_1_by_1_11 <= blend1_b_1_1_either_1_11;
    -- UQ0.8: either of both
    blend1_b_1_1_either_2_11 <=
        texels_1_even_odd_odd_b_11 when u1_weight_of_2_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-3.11: shifted
    blend1_b_1_1_by_2_11 <= blend1_b_1_1_either_2_11;
    -- UQ0.8: either of both
    blend1_b_1_1_either_3_11 <=
        texels_1_even_odd_odd_b_11 when u1_weight_of_3_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-2.10: shifted
    blend1_b_1_1_by_3_11 <= blend1_b_1_1_either_3_11;
    -- UQ0.8: either of both
    blend1_b_1_1_either_4_11 <=
        texels_1_even_odd_odd_b_11 when u1_weight_of_4_11 = '1' else texels_1_even_odd_even_b_11;
    -- UQ-1.9: shifted
    blend1_b_1_1_by_4_11 <= blend1_b_1_1_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_b_1_1_sum_1_0_11 <=
        resize(blend1_b_1_1_by_first_11, 9) + resize(blend1_b_1_1_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_b_1_1_sum_1_1_11 <=
        resize(blend1_b_1_1_by_1_11, 10) + shift_left(resize(blend1_b_1_1_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_b_1_1_sum_1_2_11 <=
        resize(blend1_b_1_1_by_3_11, 10) + shift_left(resize(blend1_b_1_1_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_2_either_first_11 <=
        texels_1_odd_even_odd_b_11 when u1_is_odd_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_2_by_first_11 <= blend1_b_1_2_either_first_11;
    -- UQ0.8: either of both
    blend1_b_1_2_either_0_11 <=
        texels_1_odd_even_odd_b_11 when u1_weight_of_0_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_2_by_0_11 <= blend1_b_1_2_either_0_11;
    -- UQ0.8: either of both
    blend1_b_1_2_either_1_11 <=
        texels_1_odd_even_odd_b_11 when u1_weight_of_1_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-4.12: shifted
    blend1_b_1_2_by_1_11 <= blend1_b_1_2_either_1_11;
    -- UQ0.8: either of both
    blend1_b_1_2_either_2_11 <=
        texels_1_odd_even_odd_b_11 when u1_weight_of_2_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-3.11: shifted
    blend1_b_1_2_by_2_11 <= blend1_b_1_2_either_2_11;
    -- UQ0.8: either of both
    blend1_b_1_2_either_3_11 <=
        texels_1_odd_even_odd_b_11 when u1_weight_of_3_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-2.10: shifted
    blend1_b_1_2_by_3_11 <= blend1_b_1_2_either_3_11;
    -- UQ0.8: either of both
    blend1_b_1_2_either_4_11 <=
        texels_1_odd_even_odd_b_11 when u1_weight_of_4_11 = '1' else texels_1_odd_even_even_b_11;
    -- UQ-1.9: shifted
    blend1_b_1_2_by_4_11 <= blend1_b_1_2_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_b_1_2_sum_1_0_11 <=
        resize(blend1_b_1_2_by_first_11, 9) + resize(blend1_b_1_2_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_b_1_2_sum_1_1_11 <=
        resize(blend1_b_1_2_by_1_11, 10) + shift_left(resize(blend1_b_1_2_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_b_1_2_sum_1_2_11 <=
        resize(blend1_b_1_2_by_3_11, 10) + shift_left(resize(blend1_b_1_2_by_4_11, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_3_either_first_11 <=
        texels_1_odd_odd_odd_b_11 when u1_is_odd_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_3_by_first_11 <= blend1_b_1_3_either_first_11;
    -- UQ0.8: either of both
    blend1_b_1_3_either_0_11 <=
        texels_1_odd_odd_odd_b_11 when u1_weight_of_0_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-5.13: shifted
    blend1_b_1_3_by_0_11 <= blend1_b_1_3_either_0_11;
    -- UQ0.8: either of both
    blend1_b_1_3_either_1_11 <=
        texels_1_odd_odd_odd_b_11 when u1_weight_of_1_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-4.12: shifted
    blend1_b_1_3_by_1_11 <= blend1_b_1_3_either_1_11;
    -- UQ0.8: either of both
    blend1_b_1_3_either_2_11 <=
        texels_1_odd_odd_odd_b_11 when u1_weight_of_2_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-3.11: shifted
    blend1_b_1_3_by_2_11 <= blend1_b_1_3_either_2_11;
    -- UQ0.8: either of both
    blend1_b_1_3_either_3_11 <=
        texels_1_odd_odd_odd_b_11 when u1_weight_of_3_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-2.10: shifted
    blend1_b_1_3_by_3_11 <= blend1_b_1_3_either_3_11;
    -- UQ0.8: either of both
    blend1_b_1_3_either_4_11 <=
        texels_1_odd_odd_odd_b_11 when u1_weight_of_4_11 = '1' else texels_1_odd_odd_even_b_11;
    -- UQ-1.9: shifted
    blend1_b_1_3_by_4_11 <= blend1_b_1_3_either_4_11;
    -- UQ-4.13: the sum of two
    blend1_b_1_3_sum_1_0_11 <=
        resize(blend1_b_1_3_by_first_11, 9) + resize(blend1_b_1_3_by_0_11, 9);
    -- UQ-2.12: the sum of two
    blend1_b_1_3_sum_1_1_11 <=
        resize(blend1_b_1_3_by_1_11, 10) + shift_left(resize(blend1_b_1_3_by_2_11, 10), 1);
    -- UQ0.10: the sum of two
    blend1_b_1_3_sum_1_2_11 <=
        resize(blend1_b_1_3_by_3_11, 10) + shift_left(resize(blend1_b_1_3_by_4_11, 10), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_12 <= in_gain1r_11;
                in_gain1g_12 <= in_gain1g_11;
                in_gain1b_12 <= in_gain1b_11;
                nl1_12 <= nl1_11;
                v1_is_odd_12 <= v1_is_odd_11;
                blend1_r_1_0_sum_1_0_12 <= blend1_r_1_0_sum_1_0_11;
                blend1_r_1_0_sum_1_1_12 <= blend1_r_1_0_sum_1_1_11;
                blend1_r_1_0_sum_1_2_12 <= blend1_r_1_0_sum_1_2_11;
                blend1_r_1_1_sum_1_0_12 <= blend1_r_1_1_sum_1_0_11;
                blend1_r_1_1_sum_1_1_12 <= blend1_r_1_1_sum_1_1_11;
                blend1_r_1_1_sum_1_2_12 <= blend1_r_1_1_sum_1_2_11;
                blend1_r_1_2_sum_1_0_12 <= blend1_r_1_2_sum_1_0_11;
                blend1_r_1_2_sum_1_1_12 <= blend1_r_1_2_sum_1_1_11;
                blend1_r_1_2_sum_1_2_12 <= blend1_r_1_2_sum_1_2_11;
                blend1_r_1_3_sum_1_0_12 <= blend1_r_1_3_sum_1_0_11;
                blend1_r_1_3_sum_1_1_12 <= blend1_r_1_3_sum_1_1_11;
                blend1_r_1_3_sum_1_2_12 <= blend1_r_1_3_sum_1_2_11;
                v1_odd_signed_12 <= v1_odd_signed_11;
                blend1_signed_12 <= blend1_signed_11;
                blend1_g_1_0_sum_1_0_12 <= blend1_g_1_0_sum_1_0_11;
                blend1_g_1_0_sum_1_1_12 <= blend1_g_1_0_sum_1_1_11;
                blend1_g_1_0_sum_1_2_12 <= blend1_g_1_0_sum_1_2_11;
                blend1_g_1_1_sum_1_0_12 <= blend1_g_1_1_sum_1_0_11;
                blend1_g_1_1_sum_1_1_12 <= blend1_g_1_1_sum_1_1_11;
                blend1_g_1_1_sum_1_2_12 <= blend1_g_1_1_sum_1_2_11;
                blend1_g_1_2_sum_1_0_12 <= blend1_g_1_2_sum_1_0_11;
                blend1_g_1_2_sum_1_1_12 <= blend1_g_1_2_sum_1_1_11;
                blend1_g_1_2_sum_1_2_12 <= blend1_g_1_2_sum_1_2_11;
                blend1_g_1_3_sum_1_0_12 <= blend1_g_1_3_sum_1_0_11;
                blend1_g_1_3_sum_1_1_12 <= blend1_g_1_3_sum_1_1_11;
                blend1_g_1_3_sum_1_2_12 <= blend1_g_1_3_sum_1_2_11;
                v1_weight_of_0_12 <= v1_weight_of_0_11;
                v1_weight_of_1_12 <= v1_weight_of_1_11;
                v1_weight_of_2_12 <= v1_weight_of_2_11;
                v1_weight_of_3_12 <= v1_weight_of_3_11;
                v1_weight_of_4_12 <= v1_weight_of_4_11;
                blend1_b_1_0_sum_1_0_12 <= blend1_b_1_0_sum_1_0_11;
                blend1_b_1_0_sum_1_1_12 <= blend1_b_1_0_sum_1_1_11;
                blend1_b_1_0_sum_1_2_12 <= blend1_b_1_0_sum_1_2_11;
                blend1_b_1_1_sum_1_0_12 <= blend1_b_1_1_sum_1_0_11;
                blend1_b_1_1_sum_1_1_12 <= blend1_b_1_1_sum_1_1_11;
                blend1_b_1_1_sum_1_2_12 <= blend1_b_1_1_sum_1_2_11;
                blend1_b_1_2_sum_1_0_12 <= blend1_b_1_2_sum_1_0_11;
                blend1_b_1_2_sum_1_1_12 <= blend1_b_1_2_sum_1_1_11;
                blend1_b_1_2_sum_1_2_12 <= blend1_b_1_2_sum_1_2_11;
                blend1_b_1_3_sum_1_0_12 <= blend1_b_1_3_sum_1_0_11;
                blend1_b_1_3_sum_1_1_12 <= blend1_b_1_3_sum_1_1_11;
                blend1_b_1_3_sum_1_2_12 <= blend1_b_1_3_sum_1_2_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: blend1_r_1_0_sum_2_0, blend1_r_1_1_sum_2_0 and 10 more
    -- UQ-2.13: the sum of two
    blend1_r_1_0_sum_2_0_12 <=
        resize(blend1_r_1_0_sum_1_0_12, 11) + shift_left(resize(blend1_r_1_0_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_r_1_1_sum_2_0_12 <=
        resize(blend1_r_1_1_sum_1_0_12, 11) + shift_left(resize(blend1_r_1_1_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_r_1_2_sum_2_0_12 <=
        resize(blend1_r_1_2_sum_1_0_12, 11) + shift_left(resize(blend1_r_1_2_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_r_1_3_sum_2_0_12 <=
        resize(blend1_r_1_3_sum_1_0_12, 11) + shift_left(resize(blend1_r_1_3_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_g_1_0_sum_2_0_12 <=
        resize(blend1_g_1_0_sum_1_0_12, 11) + shift_left(resize(blend1_g_1_0_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_g_1_1_sum_2_0_12 <=
        resize(blend1_g_1_1_sum_1_0_12, 11) + shift_left(resize(blend1_g_1_1_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_g_1_2_sum_2_0_12 <=
        resize(blend1_g_1_2_sum_1_0_12, 11) + shift_left(resize(blend1_g_1_2_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_g_1_3_sum_2_0_12 <=
        resize(blend1_g_1_3_sum_1_0_12, 11) + shift_left(resize(blend1_g_1_3_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_b_1_0_sum_2_0_12 <=
        resize(blend1_b_1_0_sum_1_0_12, 11) + shift_left(resize(blend1_b_1_0_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_b_1_1_sum_2_0_12 <=
        resize(blend1_b_1_1_sum_1_0_12, 11) + shift_left(resize(blend1_b_1_1_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_b_1_2_sum_2_0_12 <=
        resize(blend1_b_1_2_sum_1_0_12, 11) + shift_left(resize(blend1_b_1_2_sum_1_1_12, 11), 1);
    -- UQ-2.13: the sum of two
    blend1_b_1_3_sum_2_0_12 <=
        resize(blend1_b_1_3_sum_1_0_12, 11) + shift_left(resize(blend1_b_1_3_sum_1_1_12, 11), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_13 <= in_gain1r_12;
                in_gain1g_13 <= in_gain1g_12;
                in_gain1b_13 <= in_gain1b_12;
                nl1_13 <= nl1_12;
                v1_is_odd_13 <= v1_is_odd_12;
                blend1_r_1_0_sum_1_2_13 <= blend1_r_1_0_sum_1_2_12;
                blend1_r_1_0_sum_2_0_13 <= blend1_r_1_0_sum_2_0_12;
                blend1_r_1_1_sum_1_2_13 <= blend1_r_1_1_sum_1_2_12;
                blend1_r_1_1_sum_2_0_13 <= blend1_r_1_1_sum_2_0_12;
                blend1_r_1_2_sum_1_2_13 <= blend1_r_1_2_sum_1_2_12;
                blend1_r_1_2_sum_2_0_13 <= blend1_r_1_2_sum_2_0_12;
                blend1_r_1_3_sum_1_2_13 <= blend1_r_1_3_sum_1_2_12;
                blend1_r_1_3_sum_2_0_13 <= blend1_r_1_3_sum_2_0_12;
                v1_odd_signed_13 <= v1_odd_signed_12;
                blend1_signed_13 <= blend1_signed_12;
                blend1_g_1_0_sum_1_2_13 <= blend1_g_1_0_sum_1_2_12;
                blend1_g_1_0_sum_2_0_13 <= blend1_g_1_0_sum_2_0_12;
                blend1_g_1_1_sum_1_2_13 <= blend1_g_1_1_sum_1_2_12;
                blend1_g_1_1_sum_2_0_13 <= blend1_g_1_1_sum_2_0_12;
                blend1_g_1_2_sum_1_2_13 <= blend1_g_1_2_sum_1_2_12;
                blend1_g_1_2_sum_2_0_13 <= blend1_g_1_2_sum_2_0_12;
                blend1_g_1_3_sum_1_2_13 <= blend1_g_1_3_sum_1_2_12;
                blend1_g_1_3_sum_2_0_13 <= blend1_g_1_3_sum_2_0_12;
                v1_weight_of_0_13 <= v1_weight_of_0_12;
                v1_weight_of_1_13 <= v1_weight_of_1_12;
                v1_weight_of_2_13 <= v1_weight_of_2_12;
                v1_weight_of_3_13 <= v1_weight_of_3_12;
                v1_weight_of_4_13 <= v1_weight_of_4_12;
                blend1_b_1_0_sum_1_2_13 <= blend1_b_1_0_sum_1_2_12;
                blend1_b_1_0_sum_2_0_13 <= blend1_b_1_0_sum_2_0_12;
                blend1_b_1_1_sum_1_2_13 <= blend1_b_1_1_sum_1_2_12;
                blend1_b_1_1_sum_2_0_13 <= blend1_b_1_1_sum_2_0_12;
                blend1_b_1_2_sum_1_2_13 <= blend1_b_1_2_sum_1_2_12;
                blend1_b_1_2_sum_2_0_13 <= blend1_b_1_2_sum_2_0_12;
                blend1_b_1_3_sum_1_2_13 <= blend1_b_1_3_sum_1_2_12;
                blend1_b_1_3_sum_2_0_13 <= blend1_b_1_3_sum_2_0_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 20 more
    -- UQ0.13: two neighbours
    blend1_r_1_0_13 <=
        resize(blend1_r_1_0_sum_2_0_13, 13) + shift_left(resize(blend1_r_1_0_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_r_1_1_13 <=
        resize(blend1_r_1_1_sum_2_0_13, 13) + shift_left(resize(blend1_r_1_1_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_r_1_2_13 <=
        resize(blend1_r_1_2_sum_2_0_13, 13) + shift_left(resize(blend1_r_1_2_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_r_1_3_13 <=
        resize(blend1_r_1_3_sum_2_0_13, 13) + shift_left(resize(blend1_r_1_3_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_g_1_0_13 <=
        resize(blend1_g_1_0_sum_2_0_13, 13) + shift_left(resize(blend1_g_1_0_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_g_1_1_13 <=
        resize(blend1_g_1_1_sum_2_0_13, 13) + shift_left(resize(blend1_g_1_1_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_g_1_2_13 <=
        resize(blend1_g_1_2_sum_2_0_13, 13) + shift_left(resize(blend1_g_1_2_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_g_1_3_13 <=
        resize(blend1_g_1_3_sum_2_0_13, 13) + shift_left(resize(blend1_g_1_3_sum_1_2_13, 13), 3);
    -- UQ0.13: either of both
    blend1_g_2_1_either_first_13 <= blend1_g_1_3_13 when v1_is_odd_13 = '1' else blend1_g_1_2_13;
    -- UQ-5.18: shifted
    blend1_g_2_1_by_first_13 <= blend1_g_2_1_either_first_13;
    -- UQ0.13: either of both
    blend1_g_2_1_either_0_13 <= blend1_g_1_3_13 when v1_weight_of_0_13 = '1' else blend1_g_1_2_13;
    -- UQ-5.18: shifted
    blend1_g_2_1_by_0_13 <= blend1_g_2_1_either_0_13;
    -- UQ0.13: either of both
    blend1_g_2_1_either_1_13 <= blend1_g_1_3_13 when v1_weight_of_1_13 = '1' else blend1_g_1_2_13;
    -- UQ-4.17: shifted
    blend1_g_2_1_by_1_13 <= blend1_g_2_1_either_1_13;
    -- UQ0.13: either of both
    blend1_g_2_1_either_2_13 <= blend1_g_1_3_13 when v1_weight_of_2_13 = '1' else blend1_g_1_2_13;
    -- UQ-3.16: shifted
    blend1_g_2_1_by_2_13 <= blend1_g_2_1_either_2_13;
    -- UQ0.13: either of both
    blend1_g_2_1_either_3_13 <= blend1_g_1_3_13 when v1_weight_of_3_13 = '1' else blend1_g_1_2_13;
    -- UQ-2.15: shifted
    blend1_g_2_1_by_3_13 <= blend1_g_2_1_either_3_13;
    -- UQ0.13: either of both
    blend1_g_2_1_either_4_13 <= blend1_g_1_3_13 when v1_weight_of_4_13 = '1' else blend1_g_1_2_13;
    -- UQ-1.14: shifted
    blend1_g_2_1_by_4_13 <= blend1_g_2_1_either_4_13;
    -- UQ0.13: two neighbours
    blend1_b_1_0_13 <=
        resize(blend1_b_1_0_sum_2_0_13, 13) + shift_left(resize(blend1_b_1_0_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_b_1_1_13 <=
        resize(blend1_b_1_1_sum_2_0_13, 13) + shift_left(resize(blend1_b_1_1_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_b_1_2_13 <=
        resize(blend1_b_1_2_sum_2_0_13, 13) + shift_left(resize(blend1_b_1_2_sum_1_2_13, 13), 3);
    -- UQ0.13: two neighbours
    blend1_b_1_3_13 <=
        resize(blend1_b_1_3_sum_2_0_13, 13) + shift_left(resize(blend1_b_1_3_sum_1_2_13, 13), 3);
    -- UQ0.13: either of both
    blend1_b_2_1_either_first_13 <= blend1_b_1_3_13 when v1_is_odd_13 = '1' else blend1_b_1_2_13;
    -- UQ-5.18: shifted
    blend1_b_2_1_by_first_13 <= blend1_b_2_1_either_first_13;
    -- UQ0.13: either of both
    blend1_b_2_1_either_0_13 <= blend1_b_1_3_13 when v1_weight_of_0_13 = '1' else blend1_b_1_2_13;
    -- UQ-5.18: shifted
    blend1_b_2_1_by_0_13 <= blend1_b_2_1_either_0_13;
    -- UQ0.13: either of both
    blend1_b_2_1_either_1_13 <= blend1_b_1_3_13 when v1_weight_of_1_13 = '1' else blend1_b_1_2_13;
    -- UQ-4.17: shifted
    blend1_b_2_1_by_1_13 <= blend1_b_2_1_either_1_13;
    -- UQ0.13: either of both
    blend1_b_2_1_either_2_13 <= blend1_b_1_3_13 when v1_weight_of_2_13 = '1' else blend1_b_1_2_13;
    -- UQ-3.16: shifted
    blend1_b_2_1_by_2_13 <= blend1_b_2_1_either_2_13;
    -- UQ0.13: either of both
    blend1_b_2_1_either_3_13 <= blend1_b_1_3_13 when v1_weight_of_3_13 = '1' else blend1_b_1_2_13;
    -- UQ-2.15: shifted
    blend1_b_2_1_by_3_13 <= blend1_b_2_1_either_3_13;
    -- UQ0.13: either of both
    blend1_b_2_1_either_4_13 <= blend1_b_1_3_13 when v1_weight_of_4_13 = '1' else blend1_b_1_2_13;
    -- UQ-1.14: shifted
    blend1_b_2_1_by_4_13 <= blend1_b_2_1_either_4_13;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_14 <= in_gain1r_13;
                in_gain1g_14 <= in_gain1g_13;
                in_gain1b_14 <= in_gain1b_13;
                nl1_14 <= nl1_13;
                blend1_r_1_0_14 <= blend1_r_1_0_13;
                blend1_r_1_1_14 <= blend1_r_1_1_13;
                blend1_r_1_2_14 <= blend1_r_1_2_13;
                blend1_r_1_3_14 <= blend1_r_1_3_13;
                v1_odd_signed_14 <= v1_odd_signed_13;
                blend1_signed_14 <= blend1_signed_13;
                blend1_g_1_0_14 <= blend1_g_1_0_13;
                blend1_g_1_1_14 <= blend1_g_1_1_13;
                blend1_g_2_1_by_first_14 <= blend1_g_2_1_by_first_13;
                blend1_g_2_1_by_0_14 <= blend1_g_2_1_by_0_13;
                blend1_g_2_1_by_1_14 <= blend1_g_2_1_by_1_13;
                blend1_g_2_1_by_2_14 <= blend1_g_2_1_by_2_13;
                blend1_g_2_1_by_3_14 <= blend1_g_2_1_by_3_13;
                blend1_g_2_1_by_4_14 <= blend1_g_2_1_by_4_13;
                blend1_b_1_0_14 <= blend1_b_1_0_13;
                blend1_b_1_1_14 <= blend1_b_1_1_13;
                blend1_b_2_1_by_first_14 <= blend1_b_2_1_by_first_13;
                blend1_b_2_1_by_0_14 <= blend1_b_2_1_by_0_13;
                blend1_b_2_1_by_1_14 <= blend1_b_2_1_by_1_13;
                blend1_b_2_1_by_2_14 <= blend1_b_2_1_by_2_13;
                blend1_b_2_1_by_3_14 <= blend1_b_2_1_by_3_13;
                blend1_b_2_1_by_4_14 <= blend1_b_2_1_by_4_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: blend1_r_2_0_apart, blend1_r_2_1_apart, blend1_g_2_0_apart and 7 more
    -- Q0.13: the difference
    blend1_r_2_0_apart_14 <=
        signed(resize(blend1_r_1_1_14, 14)) - signed(resize(blend1_r_1_0_14, 14));
    -- Q0.13: the difference
    blend1_r_2_1_apart_14 <=
        signed(resize(blend1_r_1_3_14, 14)) - signed(resize(blend1_r_1_2_14, 14));
    -- Q0.13: the difference
    blend1_g_2_0_apart_14 <=
        signed(resize(blend1_g_1_1_14, 14)) - signed(resize(blend1_g_1_0_14, 14));
    -- UQ-4.18: the sum of two
    blend1_g_2_1_sum_1_0_14 <=
        resize(blend1_g_2_1_by_first_14, 14) + resize(blend1_g_2_1_by_0_14, 14);
    -- UQ-2.17: the sum of two
    blend1_g_2_1_sum_1_1_14 <=
        resize(blend1_g_2_1_by_1_14, 15) + shift_left(resize(blend1_g_2_1_by_2_14, 15), 1);
    -- UQ0.15: the sum of two
    blend1_g_2_1_sum_1_2_14 <=
        resize(blend1_g_2_1_by_3_14, 15) + shift_left(resize(blend1_g_2_1_by_4_14, 15), 1);
    -- Q0.13: the difference
    blend1_b_2_0_apart_14 <=
        signed(resize(blend1_b_1_1_14, 14)) - signed(resize(blend1_b_1_0_14, 14));
    -- UQ-4.18: the sum of two
    blend1_b_2_1_sum_1_0_14 <=
        resize(blend1_b_2_1_by_first_14, 14) + resize(blend1_b_2_1_by_0_14, 14);
    -- UQ-2.17: the sum of two
    blend1_b_2_1_sum_1_1_14 <=
        resize(blend1_b_2_1_by_1_14, 15) + shift_left(resize(blend1_b_2_1_by_2_14, 15), 1);
    -- UQ0.15: the sum of two
    blend1_b_2_1_sum_1_2_14 <=
        resize(blend1_b_2_1_by_3_14, 15) + shift_left(resize(blend1_b_2_1_by_4_14, 15), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_15 <= in_gain1r_14;
                in_gain1g_15 <= in_gain1g_14;
                in_gain1b_15 <= in_gain1b_14;
                nl1_15 <= nl1_14;
                blend1_r_1_0_15 <= blend1_r_1_0_14;
                blend1_r_1_2_15 <= blend1_r_1_2_14;
                blend1_r_2_0_apart_15 <= blend1_r_2_0_apart_14;
                v1_odd_signed_15 <= v1_odd_signed_14;
                blend1_r_2_1_apart_15 <= blend1_r_2_1_apart_14;
                blend1_signed_15 <= blend1_signed_14;
                blend1_g_1_0_15 <= blend1_g_1_0_14;
                blend1_g_2_0_apart_15 <= blend1_g_2_0_apart_14;
                blend1_g_2_1_sum_1_0_15 <= blend1_g_2_1_sum_1_0_14;
                blend1_g_2_1_sum_1_1_15 <= blend1_g_2_1_sum_1_1_14;
                blend1_g_2_1_sum_1_2_15 <= blend1_g_2_1_sum_1_2_14;
                blend1_b_1_0_15 <= blend1_b_1_0_14;
                blend1_b_2_0_apart_15 <= blend1_b_2_0_apart_14;
                blend1_b_2_1_sum_1_0_15 <= blend1_b_2_1_sum_1_0_14;
                blend1_b_2_1_sum_1_1_15 <= blend1_b_2_1_sum_1_1_14;
                blend1_b_2_1_sum_1_2_15 <= blend1_b_2_1_sum_1_2_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: blend1_r_2_0_part, blend1_r_2_1_part, blend1_g_2_0_part and 3 more
    -- Q2.18: its part
    blend1_r_2_0_part_15 <= blend1_r_2_0_apart_15 * v1_odd_signed_15;
    -- Q2.18: its part
    blend1_r_2_1_part_15 <= blend1_r_2_1_apart_15 * v1_odd_signed_15;
    -- Q2.18: its part
    blend1_g_2_0_part_15 <= blend1_g_2_0_apart_15 * v1_odd_signed_15;
    -- UQ-2.18: the sum of two
    blend1_g_2_1_sum_2_0_15 <=
        resize(blend1_g_2_1_sum_1_0_15, 16) + shift_left(resize(blend1_g_2_1_sum_1_1_15, 16), 1);
    -- Q2.18: its part
    blend1_b_2_0_part_15 <= blend1_b_2_0_apart_15 * v1_odd_signed_15;
    -- UQ-2.18: the sum of two
    blend1_b_2_1_sum_2_0_15 <=
        resize(blend1_b_2_1_sum_1_0_15, 16) + shift_left(resize(blend1_b_2_1_sum_1_1_15, 16), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_16 <= in_gain1r_15;
                in_gain1g_16 <= in_gain1g_15;
                in_gain1b_16 <= in_gain1b_15;
                nl1_16 <= nl1_15;
                blend1_r_1_0_16 <= blend1_r_1_0_15;
                blend1_r_1_2_16 <= blend1_r_1_2_15;
                blend1_r_2_0_part_16 <= blend1_r_2_0_part_15;
                blend1_r_2_1_part_16 <= blend1_r_2_1_part_15;
                blend1_signed_16 <= blend1_signed_15;
                blend1_g_1_0_16 <= blend1_g_1_0_15;
                blend1_g_2_0_part_16 <= blend1_g_2_0_part_15;
                blend1_g_2_1_sum_1_2_16 <= blend1_g_2_1_sum_1_2_15;
                blend1_g_2_1_sum_2_0_16 <= blend1_g_2_1_sum_2_0_15;
                blend1_b_1_0_16 <= blend1_b_1_0_15;
                blend1_b_2_0_part_16 <= blend1_b_2_0_part_15;
                blend1_b_2_1_sum_1_2_16 <= blend1_b_2_1_sum_1_2_15;
                blend1_b_2_1_sum_2_0_16 <= blend1_b_2_1_sum_2_0_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    -- UQ0.18: two neighbours
    blend1_r_2_0_16 <=
        shift_left(resize(blend1_r_1_0_16, 18), 5) + unsigned(blend1_r_2_0_part_16(17 downto 0));
    -- UQ0.18: two neighbours
    blend1_r_2_1_16 <=
        shift_left(resize(blend1_r_1_2_16, 18), 5) + unsigned(blend1_r_2_1_part_16(17 downto 0));
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_r_2_0_cut_16 <= blend1_r_2_0_16(17 downto 1);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_r_2_1_cut_16 <= blend1_r_2_1_16(17 downto 1);
    -- UQ0.18: two neighbours
    blend1_g_2_0_16 <=
        shift_left(resize(blend1_g_1_0_16, 18), 5) + unsigned(blend1_g_2_0_part_16(17 downto 0));
    -- UQ0.18: two neighbours
    blend1_g_2_1_16 <=
        resize(blend1_g_2_1_sum_2_0_16, 18) + shift_left(resize(blend1_g_2_1_sum_1_2_16, 18), 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_g_2_0_cut_16 <= blend1_g_2_0_16(17 downto 1);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_g_2_1_cut_16 <= blend1_g_2_1_16(17 downto 1);
    -- UQ0.18: two neighbours
    blend1_b_2_0_16 <=
        shift_left(resize(blend1_b_1_0_16, 18), 5) + unsigned(blend1_b_2_0_part_16(17 downto 0));
    -- UQ0.18: two neighbours
    blend1_b_2_1_16 <=
        resize(blend1_b_2_1_sum_2_0_16, 18) + shift_left(resize(blend1_b_2_1_sum_1_2_16, 18), 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_b_2_0_cut_16 <= blend1_b_2_0_16(17 downto 1);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_b_2_1_cut_16 <= blend1_b_2_1_16(17 downto 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_17 <= in_gain1r_16;
                in_gain1g_17 <= in_gain1g_16;
                in_gain1b_17 <= in_gain1b_16;
                nl1_17 <= nl1_16;
                blend1_r_2_0_cut_17 <= blend1_r_2_0_cut_16;
                blend1_r_2_1_cut_17 <= blend1_r_2_1_cut_16;
                blend1_signed_17 <= blend1_signed_16;
                blend1_g_2_0_cut_17 <= blend1_g_2_0_cut_16;
                blend1_g_2_1_cut_17 <= blend1_g_2_1_cut_16;
                blend1_b_2_0_cut_17 <= blend1_b_2_0_cut_16;
                blend1_b_2_1_cut_17 <= blend1_b_2_1_cut_16;
            end if;
        end if;
    end process;

    -- ===== Stage 17: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    -- Q0.17: the difference
    blend1_r_3_0_apart_17 <=
        signed(resize(blend1_r_2_1_cut_17, 18)) - signed(resize(blend1_r_2_0_cut_17, 18));
    -- Q0.17: the difference
    blend1_g_3_0_apart_17 <=
        signed(resize(blend1_g_2_1_cut_17, 18)) - signed(resize(blend1_g_2_0_cut_17, 18));
    -- Q0.17: the difference
    blend1_b_3_0_apart_17 <=
        signed(resize(blend1_b_2_1_cut_17, 18)) - signed(resize(blend1_b_2_0_cut_17, 18));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_18 <= in_gain1r_17;
                in_gain1g_18 <= in_gain1g_17;
                in_gain1b_18 <= in_gain1b_17;
                nl1_18 <= nl1_17;
                blend1_r_2_0_cut_18 <= blend1_r_2_0_cut_17;
                blend1_r_3_0_apart_18 <= blend1_r_3_0_apart_17;
                blend1_signed_18 <= blend1_signed_17;
                blend1_g_2_0_cut_18 <= blend1_g_2_0_cut_17;
                blend1_g_3_0_apart_18 <= blend1_g_3_0_apart_17;
                blend1_b_2_0_cut_18 <= blend1_b_2_0_cut_17;
                blend1_b_3_0_apart_18 <= blend1_b_3_0_apart_17;
            end if;
        end if;
    end process;

    -- ===== Stage 18: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    -- Q2.22: its part
    blend1_r_3_0_part_18 <= blend1_r_3_0_apart_18 * blend1_signed_18;
    -- Q2.22: its part
    blend1_g_3_0_part_18 <= blend1_g_3_0_apart_18 * blend1_signed_18;
    -- Q2.22: its part
    blend1_b_3_0_part_18 <= blend1_b_3_0_apart_18 * blend1_signed_18;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_19 <= in_gain1r_18;
                in_gain1g_19 <= in_gain1g_18;
                in_gain1b_19 <= in_gain1b_18;
                nl1_19 <= nl1_18;
                blend1_r_2_0_cut_19 <= blend1_r_2_0_cut_18;
                blend1_r_3_0_part_19 <= blend1_r_3_0_part_18;
                blend1_g_2_0_cut_19 <= blend1_g_2_0_cut_18;
                blend1_g_3_0_part_19 <= blend1_g_3_0_part_18;
                blend1_b_2_0_cut_19 <= blend1_b_2_0_cut_18;
                blend1_b_3_0_part_19 <= blend1_b_3_0_part_18;
            end if;
        end if;
    end process;

    -- ===== Stage 19: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_20 <= in_gain1r_19;
                in_gain1g_20 <= in_gain1g_19;
                in_gain1b_20 <= in_gain1b_19;
                nl1_20 <= nl1_19;
                blend1_r_2_0_cut_20 <= blend1_r_2_0_cut_19;
                blend1_r_3_0_part_20 <= blend1_r_3_0_part_19;
                blend1_g_2_0_cut_20 <= blend1_g_2_0_cut_19;
                blend1_g_3_0_part_20 <= blend1_g_3_0_part_19;
                blend1_b_2_0_cut_20 <= blend1_b_2_0_cut_19;
                blend1_b_3_0_part_20 <= blend1_b_3_0_part_19;
            end if;
        end if;
    end process;

    -- ===== Stage 20: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    -- UQ0.22: two bands
    blend1_r_3_0_20 <=
        shift_left(resize(blend1_r_2_0_cut_20, 22), 5) + unsigned(blend1_r_3_0_part_20(21 downto 0));
    -- UQ0.18: the blended code
    root1_r_20 <= blend1_r_3_0_20(21 downto 4);
    -- UQ0.22: two bands
    blend1_g_3_0_20 <=
        shift_left(resize(blend1_g_2_0_cut_20, 22), 5) + unsigned(blend1_g_3_0_part_20(21 downto 0));
    -- UQ0.18: the blended code
    root1_g_20 <= blend1_g_3_0_20(21 downto 4);
    -- UQ0.22: two bands
    blend1_b_3_0_20 <=
        shift_left(resize(blend1_b_2_0_cut_20, 22), 5) + unsigned(blend1_b_3_0_part_20(21 downto 0));
    -- UQ0.18: the blended code
    root1_b_20 <= blend1_b_3_0_20(21 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_21 <= in_gain1r_20;
                in_gain1g_21 <= in_gain1g_20;
                in_gain1b_21 <= in_gain1b_20;
                nl1_21 <= nl1_20;
                root1_r_21 <= root1_r_20;
                root1_g_21 <= root1_g_20;
                root1_b_21 <= root1_b_20;
            end if;
        end if;
    end process;

    -- ===== Stage 21: square1_r_exact, square1_g_exact, square1_b_exact
    -- UQ0.36: its square
    square1_r_exact_21 <= root1_r_21 * root1_r_21;
    -- UQ0.18: rounded down
    square1_r_21 <= square1_r_exact_21(35 downto 18);
    -- UQ0.36: its square
    square1_g_exact_21 <= root1_g_21 * root1_g_21;
    -- UQ0.18: rounded down
    square1_g_21 <= square1_g_exact_21(35 downto 18);
    -- UQ0.36: its square
    square1_b_exact_21 <= root1_b_21 * root1_b_21;
    -- UQ0.18: rounded down
    square1_b_21 <= square1_b_exact_21(35 downto 18);
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
