-- image_paper: image-based block of ggx (paper, 6 sphere images of 64 x 64 texels), 1 light a clock, 8 bits a channel
--
-- Made by: brdfgen generate core.toml
-- Spec e91d917992f4fdd5. Generated; the core is yours to use under any terms.
--
--   in_nx         Q1.16   x of the unit normal, the viewer at +z
--   in_ny         Q1.16   y of the unit normal, the viewer at +z
--   in_nz         Q1.16   z of the unit normal, the viewer at +z
--   in_u1x        Q1.16   x of row 1 of the turn to light 1's half vector
--   in_u1y        Q1.16   y of row 1 of the turn to light 1's half vector
--   in_u1z        Q1.16   z of row 1 of the turn to light 1's half vector
--   in_v1x        Q1.16   x of row 2 of the turn to light 1's half vector
--   in_v1y        Q1.16   y of row 2 of the turn to light 1's half vector
--   in_band1      UQ3.0   image of texels below light 1's angle
--   in_blend1     UQ1.6   weight of the odd one of this image and the next, at most 1
--   in_turn1_even Q0.14   half of the way from light 1 to its even image, in right angles
--   in_turn1_odd  Q0.14   half of the way from light 1 to its odd image, in right angles
--   in_alone1     UQ1.0   1 where a single image is looked up for light 1
--   in_shift1     UQ3.0   exponent of light 1's gain
--   in_gain1r     UQ1.17  red of light 1's gain
--   in_gain1g     UQ1.17  green of light 1's gain
--   in_gain1b     UQ1.17  blue of light 1's gain
--   out_sum_r     UQ1.17  red of these lights, at most 1.0
--   out_sum_g     UQ1.17  green of these lights, at most 1.0
--   out_sum_b     UQ1.17  blue of these lights, at most 1.0
--
-- Latency 52 clocks, one result a clock.
-- Pictures of a sphere against the exact reflectance, lit from 34 angles:
--   41.6 dB in the mean, 27.1 dB at the worst angle.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity image_paper is
    generic (
        -- Path of the memory texels_1_even_even_even, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_EVEN_EVEN_FILE : string := "rom/image_paper_texels_1_even_even_even.mem";
        -- Path of the memory texels_1_even_even_odd, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_EVEN_ODD_FILE : string := "rom/image_paper_texels_1_even_even_odd.mem";
        -- Path of the memory texels_1_even_odd_even, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_ODD_EVEN_FILE : string := "rom/image_paper_texels_1_even_odd_even.mem";
        -- Path of the memory texels_1_even_odd_odd, in the format of Verilog's $readmemh.
        TEXELS_1_EVEN_ODD_ODD_FILE : string := "rom/image_paper_texels_1_even_odd_odd.mem";
        -- Path of the memory texels_1_odd_even_even, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_EVEN_EVEN_FILE : string := "rom/image_paper_texels_1_odd_even_even.mem";
        -- Path of the memory texels_1_odd_even_odd, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_EVEN_ODD_FILE : string := "rom/image_paper_texels_1_odd_even_odd.mem";
        -- Path of the memory texels_1_odd_odd_even, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_ODD_EVEN_FILE : string := "rom/image_paper_texels_1_odd_odd_even.mem";
        -- Path of the memory texels_1_odd_odd_odd, in the format of Verilog's $readmemh.
        TEXELS_1_ODD_ODD_ODD_FILE : string := "rom/image_paper_texels_1_odd_odd_odd.mem";
        -- Path of the memory roots_1, in the format of Verilog's $readmemh.
        ROOTS_1_FILE : string := "rom/image_paper_roots_1.mem";
        -- Path of the memory sines_1_even, in the format of Verilog's $readmemh.
        SINES_1_EVEN_FILE : string := "rom/image_paper_sines_1_even.mem";
        -- Path of the memory sines_1_odd, in the format of Verilog's $readmemh.
        SINES_1_ODD_FILE : string := "rom/image_paper_sines_1_odd.mem"
    );
    port (
        -- clock; everything happens on its rising edge
        clk           : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst           : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce            : in  std_logic;
        -- the other inputs are to be taken
        in_valid      : in  std_logic;
        -- Q1.16: x of the unit normal, the viewer at +z
        in_nx         : in  signed(17 downto 0);
        -- Q1.16: y of the unit normal, the viewer at +z
        in_ny         : in  signed(17 downto 0);
        -- Q1.16: z of the unit normal, the viewer at +z
        in_nz         : in  signed(17 downto 0);
        -- Q1.16: x of row 1 of the turn to light 1's half vector
        in_u1x        : in  signed(17 downto 0);
        -- Q1.16: y of row 1 of the turn to light 1's half vector
        in_u1y        : in  signed(17 downto 0);
        -- Q1.16: z of row 1 of the turn to light 1's half vector
        in_u1z        : in  signed(17 downto 0);
        -- Q1.16: x of row 2 of the turn to light 1's half vector
        in_v1x        : in  signed(17 downto 0);
        -- Q1.16: y of row 2 of the turn to light 1's half vector
        in_v1y        : in  signed(17 downto 0);
        -- UQ3.0: image of texels below light 1's angle
        in_band1      : in  unsigned(2 downto 0);
        -- UQ1.6: weight of the odd one of this image and the next, at most 1
        in_blend1     : in  unsigned(6 downto 0);
        -- Q0.14: half of the way from light 1 to its even image, in right angles
        in_turn1_even : in  signed(14 downto 0);
        -- Q0.14: half of the way from light 1 to its odd image, in right angles
        in_turn1_odd  : in  signed(14 downto 0);
        -- UQ1.0: 1 where a single image is looked up for light 1
        in_alone1     : in  unsigned(0 downto 0);
        -- UQ3.0: exponent of light 1's gain
        in_shift1     : in  unsigned(2 downto 0);
        -- UQ1.17: red of light 1's gain
        in_gain1r     : in  unsigned(17 downto 0);
        -- UQ1.17: green of light 1's gain
        in_gain1g     : in  unsigned(17 downto 0);
        -- UQ1.17: blue of light 1's gain
        in_gain1b     : in  unsigned(17 downto 0);
        -- the other outputs are a result: in_valid, 52 enabled clocks later
        out_valid     : out std_logic;
        -- UQ1.17: red of these lights, at most 1.0
        out_sum_r     : out unsigned(17 downto 0);
        -- UQ1.17: green of these lights, at most 1.0
        out_sum_g     : out unsigned(17 downto 0);
        -- UQ1.17: blue of these lights, at most 1.0
        out_sum_b     : out unsigned(17 downto 0)
    );
end entity image_paper;

architecture rtl of image_paper is
    -- ===== The memory roots_1
    type roots_1_t is array (127 downto 0) of
        std_logic_vector(30 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_roots_1(path : string) return roots_1_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(31 downto 0);
        variable result : roots_1_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 128 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(30 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 128 report path & " has too few words" severity failure;
        return result;
    end function;

    constant ROOTS_1 : roots_1_t := read_roots_1(ROOTS_1_FILE);
    signal roots_1_10 : std_logic_vector(30 downto 0) := (others => '0');

    -- ===== The memory sines_1_even
    type sines_1_even_t is array (127 downto 0) of
        std_logic_vector(52 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_sines_1_even(path : string) return sines_1_even_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(55 downto 0);
        variable result : sines_1_even_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 128 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(52 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 128 report path & " has too few words" severity failure;
        return result;
    end function;

    constant SINES_1_EVEN : sines_1_even_t := read_sines_1_even(SINES_1_EVEN_FILE);
    signal sines_1_even_22 : std_logic_vector(52 downto 0) := (others => '0');

    -- ===== The memory sines_1_odd
    type sines_1_odd_t is array (127 downto 0) of
        std_logic_vector(52 downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_sines_1_odd(path : string) return sines_1_odd_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector(55 downto 0);
        variable result : sines_1_odd_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < 128 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(52 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 128 report path & " has too few words" severity failure;
        return result;
    end function;

    constant SINES_1_ODD : sines_1_odd_t := read_sines_1_odd(SINES_1_ODD_FILE);
    signal sines_1_odd_22 : std_logic_vector(52 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_even_even
    type texels_1_even_even_even_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_EVEN_EVEN : texels_1_even_even_even_t := read_texels_1_even_even_even(TEXELS_1_EVEN_EVEN_EVEN_FILE);
    signal texels_1_even_even_even_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_even_odd
    type texels_1_even_even_odd_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_EVEN_ODD : texels_1_even_even_odd_t := read_texels_1_even_even_odd(TEXELS_1_EVEN_EVEN_ODD_FILE);
    signal texels_1_even_even_odd_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_odd_even
    type texels_1_even_odd_even_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_ODD_EVEN : texels_1_even_odd_even_t := read_texels_1_even_odd_even(TEXELS_1_EVEN_ODD_EVEN_FILE);
    signal texels_1_even_odd_even_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_even_odd_odd
    type texels_1_even_odd_odd_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_EVEN_ODD_ODD : texels_1_even_odd_odd_t := read_texels_1_even_odd_odd(TEXELS_1_EVEN_ODD_ODD_FILE);
    signal texels_1_even_odd_odd_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_even_even
    type texels_1_odd_even_even_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_EVEN_EVEN : texels_1_odd_even_even_t := read_texels_1_odd_even_even(TEXELS_1_ODD_EVEN_EVEN_FILE);
    signal texels_1_odd_even_even_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_even_odd
    type texels_1_odd_even_odd_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_EVEN_ODD : texels_1_odd_even_odd_t := read_texels_1_odd_even_odd(TEXELS_1_ODD_EVEN_ODD_FILE);
    signal texels_1_odd_even_odd_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_odd_even
    type texels_1_odd_odd_even_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_ODD_EVEN : texels_1_odd_odd_even_t := read_texels_1_odd_odd_even(TEXELS_1_ODD_ODD_EVEN_FILE);
    signal texels_1_odd_odd_even_35 : std_logic_vector(23 downto 0) := (others => '0');

    -- ===== The memory texels_1_odd_odd_odd
    type texels_1_odd_odd_odd_t is array (4095 downto 0) of
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
                assert index < 4096 report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word(23 downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = 4096 report path & " has too few words" severity failure;
        return result;
    end function;

    constant TEXELS_1_ODD_ODD_ODD : texels_1_odd_odd_odd_t := read_texels_1_odd_odd_odd(TEXELS_1_ODD_ODD_ODD_FILE);
    signal texels_1_odd_odd_odd_35 : std_logic_vector(23 downto 0) := (others => '0');

    signal valid : std_logic_vector(52 downto 1) := (others => '0');
    signal nz_kept_0 : unsigned(16 downto 0) := (others => '0');
    signal seen_0 : std_logic := '0';
    signal hidden_0 : std_logic := '0';
    signal shift1_0 : unsigned(2 downto 0) := (others => '0');
    signal blend1_0 : unsigned(6 downto 0) := (others => '0');
    signal band1_kept_0 : unsigned(2 downto 0) := (others => '0');
    signal band1_odd_high_0 : unsigned(1 downto 0) := (others => '0');
    signal band1_odd_0 : unsigned(1 downto 0) := (others => '0');
    signal v1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_x_0 : signed(17 downto 0) := (others => '0');
    signal v1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal v1_y_0 : signed(17 downto 0) := (others => '0');
    signal x1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal x1_x_0 : signed(17 downto 0) := (others => '0');
    signal x1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal x1_y_0 : signed(17 downto 0) := (others => '0');
    signal u1_x_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_x_0 : signed(17 downto 0) := (others => '0');
    signal u1_y_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_y_0 : signed(17 downto 0) := (others => '0');
    signal u1_z_exact_0 : signed(35 downto 0) := (others => '0');
    signal u1_z_0 : signed(17 downto 0) := (others => '0');
    signal alone1_0 : std_logic := '0';
    signal back1_even_0 : std_logic := '0';
    signal end1_even_0 : unsigned(11 downto 0) := (others => '0');
    signal back1_odd_0 : std_logic := '0';
    signal end1_odd_0 : unsigned(11 downto 0) := (others => '0');
    signal texels1_10_0 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_0 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_0 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_v2_0 : unsigned(1 downto 0) := (others => '0');
    signal blend1_signed_0 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_by_2_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_0 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_0 : std_logic := '0';
    signal square1_g_by_1_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_by_2_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_0 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_0 : std_logic := '0';
    signal square1_b_by_1_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_by_2_0 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_0 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_0 : std_logic := '0';
    signal in_nz_1 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_1 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_1 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_1 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_1 : unsigned(17 downto 0) := (others => '0');
    signal hidden_1 : std_logic := '0';
    signal band1_kept_1 : unsigned(2 downto 0) := (others => '0');
    signal v1_x_1 : signed(17 downto 0) := (others => '0');
    signal v1_y_1 : signed(17 downto 0) := (others => '0');
    signal x1_x_1 : signed(17 downto 0) := (others => '0');
    signal x1_y_1 : signed(17 downto 0) := (others => '0');
    signal u1_x_1 : signed(17 downto 0) := (others => '0');
    signal u1_y_1 : signed(17 downto 0) := (others => '0');
    signal u1_z_1 : signed(17 downto 0) := (others => '0');
    signal alone1_1 : std_logic := '0';
    signal end1_even_1 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_1 : unsigned(11 downto 0) := (others => '0');
    signal texels1_10_1 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_1 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_1 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_v2_1 : unsigned(1 downto 0) := (others => '0');
    signal blend1_signed_1 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_1 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_1 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_1 : std_logic := '0';
    signal square1_g_by_1_1 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_1 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_1 : std_logic := '0';
    signal square1_b_by_1_1 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_1 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_1 : std_logic := '0';
    signal band1_next_exact_1 : unsigned(2 downto 0) := (others => '0');
    signal v1_xy_1 : signed(18 downto 0) := (others => '0');
    signal v1_scaled_1 : signed(18 downto 0) := (others => '0');
    signal x1_exact_1 : signed(18 downto 0) := (others => '0');
    signal u1_xy_1 : signed(18 downto 0) := (others => '0');
    signal in_nz_2 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_2 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_2 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_2 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_2 : unsigned(17 downto 0) := (others => '0');
    signal hidden_2 : std_logic := '0';
    signal band1_next_exact_2 : unsigned(2 downto 0) := (others => '0');
    signal v1_xy_2 : signed(18 downto 0) := (others => '0');
    signal v1_scaled_2 : signed(18 downto 0) := (others => '0');
    signal x1_exact_2 : signed(18 downto 0) := (others => '0');
    signal u1_z_2 : signed(17 downto 0) := (others => '0');
    signal u1_xy_2 : signed(18 downto 0) := (others => '0');
    signal alone1_2 : std_logic := '0';
    signal end1_even_2 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_2 : unsigned(11 downto 0) := (others => '0');
    signal texels1_10_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_v2_2 : unsigned(1 downto 0) := (others => '0');
    signal blend1_signed_2 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_2 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_2 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_2 : std_logic := '0';
    signal square1_g_by_1_2 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_2 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_2 : std_logic := '0';
    signal square1_b_by_1_2 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_2 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_2 : std_logic := '0';
    signal band1_next_2 : unsigned(2 downto 0) := (others => '0');
    signal band1_even_high_2 : unsigned(1 downto 0) := (others => '0');
    signal band1_even_2 : unsigned(1 downto 0) := (others => '0');
    signal v1_place_2 : signed(18 downto 0) := (others => '0');
    signal v1_cut_2 : signed(15 downto 0) := (others => '0');
    signal x1_2 : signed(15 downto 0) := (others => '0');
    signal u1_xyz_2 : signed(18 downto 0) := (others => '0');
    signal v1_unit_2 : signed(15 downto 0) := (others => '0');
    signal texels1_00_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_v2_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_2 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_v2_2 : unsigned(1 downto 0) := (others => '0');
    signal in_nz_3 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_3 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_3 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_3 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_3 : unsigned(17 downto 0) := (others => '0');
    signal hidden_3 : std_logic := '0';
    signal v1_cut_3 : signed(15 downto 0) := (others => '0');
    signal x1_3 : signed(15 downto 0) := (others => '0');
    signal u1_xyz_3 : signed(18 downto 0) := (others => '0');
    signal v1_unit_3 : signed(15 downto 0) := (others => '0');
    signal alone1_3 : std_logic := '0';
    signal end1_even_3 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_3 : unsigned(11 downto 0) := (others => '0');
    signal texels1_00_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_v2_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_v2_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_3 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_v2_3 : unsigned(1 downto 0) := (others => '0');
    signal blend1_signed_3 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_3 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_3 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_3 : std_logic := '0';
    signal square1_g_by_1_3 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_3 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_3 : std_logic := '0';
    signal square1_b_by_1_3 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_3 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_3 : std_logic := '0';
    signal v1_kept_3 : unsigned(11 downto 0) := (others => '0');
    signal v1_texel_3 : unsigned(5 downto 0) := (others => '0');
    signal v1_weight_3 : unsigned(5 downto 0) := (others => '0');
    signal v1_odd_high_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_odd_3 : unsigned(4 downto 0) := (others => '0');
    signal v1_is_odd_3 : std_logic := '0';
    signal u1_below_3 : std_logic := '0';
    signal u1_minus_3 : signed(18 downto 0) := (others => '0');
    signal u1_either_3 : signed(18 downto 0) := (others => '0');
    signal v1_square_3 : signed(31 downto 0) := (others => '0');
    signal v1_weight_bit_0_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_1_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_2_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_3_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_4_3 : unsigned(0 downto 0) := (others => '0');
    signal v1_weight_bit_5_3 : unsigned(0 downto 0) := (others => '0');
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
    signal v1_weight_of_5_flag_3 : std_logic := '0';
    signal v1_weight_of_5_not_3 : std_logic := '0';
    signal v1_weight_of_5_3 : std_logic := '0';
    signal in_nz_4 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_4 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_4 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_4 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_4 : unsigned(17 downto 0) := (others => '0');
    signal hidden_4 : std_logic := '0';
    signal v1_texel_4 : unsigned(5 downto 0) := (others => '0');
    signal v1_odd_4 : unsigned(4 downto 0) := (others => '0');
    signal v1_is_odd_4 : std_logic := '0';
    signal x1_4 : signed(15 downto 0) := (others => '0');
    signal u1_either_4 : signed(18 downto 0) := (others => '0');
    signal v1_square_4 : signed(31 downto 0) := (others => '0');
    signal alone1_4 : std_logic := '0';
    signal end1_even_4 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_4 : unsigned(11 downto 0) := (others => '0');
    signal texels1_00_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_v2_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_01_v2_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_4 : unsigned(1 downto 0) := (others => '0');
    signal texels1_11_v2_4 : unsigned(1 downto 0) := (others => '0');
    signal v1_weight_of_0_4 : std_logic := '0';
    signal v1_weight_of_1_4 : std_logic := '0';
    signal v1_weight_of_2_4 : std_logic := '0';
    signal v1_weight_of_3_4 : std_logic := '0';
    signal v1_weight_of_4_4 : std_logic := '0';
    signal v1_weight_of_5_4 : std_logic := '0';
    signal blend1_signed_4 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_4 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_4 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_4 : std_logic := '0';
    signal square1_g_by_1_4 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_4 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_4 : std_logic := '0';
    signal square1_b_by_1_4 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_4 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_4 : std_logic := '0';
    signal v1_next_exact_4 : unsigned(6 downto 0) := (others => '0');
    signal u1_kept_4 : unsigned(14 downto 0) := (others => '0');
    signal rr1_exact_4 : unsigned(29 downto 0) := (others => '0');
    signal rr1_cut_4 : unsigned(17 downto 0) := (others => '0');
    signal u1_kept_signed_4 : signed(15 downto 0) := (others => '0');
    signal texel1_01_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_01_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_4 : unsigned(6 downto 0) := (others => '0');
    signal texel1_11_v2_4 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_4 : unsigned(6 downto 0) := (others => '0');
    signal in_nz_5 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_5 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_5 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_5 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_5 : unsigned(17 downto 0) := (others => '0');
    signal hidden_5 : std_logic := '0';
    signal v1_next_exact_5 : unsigned(6 downto 0) := (others => '0');
    signal v1_is_odd_5 : std_logic := '0';
    signal x1_5 : signed(15 downto 0) := (others => '0');
    signal rr1_cut_5 : unsigned(17 downto 0) := (others => '0');
    signal u1_kept_signed_5 : signed(15 downto 0) := (others => '0');
    signal alone1_5 : std_logic := '0';
    signal end1_even_5 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_5 : unsigned(11 downto 0) := (others => '0');
    signal texels1_00_5 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_v2_5 : unsigned(1 downto 0) := (others => '0');
    signal texels1_010_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_10_5 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_5 : unsigned(1 downto 0) := (others => '0');
    signal texels1_110_5 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_5 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_5 : std_logic := '0';
    signal v1_weight_of_1_5 : std_logic := '0';
    signal v1_weight_of_2_5 : std_logic := '0';
    signal v1_weight_of_3_5 : std_logic := '0';
    signal v1_weight_of_4_5 : std_logic := '0';
    signal v1_weight_of_5_5 : std_logic := '0';
    signal blend1_signed_5 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_5 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_5 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_5 : std_logic := '0';
    signal square1_g_by_1_5 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_5 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_5 : std_logic := '0';
    signal square1_b_by_1_5 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_5 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_5 : std_logic := '0';
    signal v1_next_5 : unsigned(5 downto 0) := (others => '0');
    signal v1_even_high_5 : unsigned(4 downto 0) := (others => '0');
    signal v1_even_5 : unsigned(4 downto 0) := (others => '0');
    signal rr1_5 : unsigned(15 downto 0) := (others => '0');
    signal high1_4_bits_5 : unsigned(3 downto 0) := (others => '0');
    signal high1_4_5 : std_logic := '0';
    signal rr_low1_4_5 : unsigned(11 downto 0) := (others => '0');
    signal rr_up1_4_5 : unsigned(11 downto 0) := (others => '0');
    signal rr_up1_4_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal rr1_4_5 : unsigned(15 downto 0) := (others => '0');
    signal place1_4_5 : unsigned(0 downto 0) := (others => '0');
    signal high1_2_bits_5 : unsigned(1 downto 0) := (others => '0');
    signal high1_2_5 : std_logic := '0';
    signal rr_low1_2_5 : unsigned(13 downto 0) := (others => '0');
    signal rr_up1_2_5 : unsigned(13 downto 0) := (others => '0');
    signal rr_up1_2_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal rr1_2_5 : unsigned(15 downto 0) := (others => '0');
    signal place1_2_5 : unsigned(0 downto 0) := (others => '0');
    signal high1_1_bits_5 : std_logic := '0';
    signal rr_low1_1_5 : unsigned(14 downto 0) := (others => '0');
    signal rr_up1_1_5 : unsigned(14 downto 0) := (others => '0');
    signal rr_up1_1_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal rr1_1_5 : unsigned(15 downto 0) := (others => '0');
    signal place1_1_5 : unsigned(0 downto 0) := (others => '0');
    signal normal1_of_2_5 : std_logic := '0';
    signal normal1_5 : std_logic := '0';
    signal rr1_twice_5 : unsigned(15 downto 0) := (others => '0');
    signal rr1_rest_5 : unsigned(14 downto 0) := (others => '0');
    signal rr1_rest_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal in_nz_6 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_6 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_6 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_6 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_6 : unsigned(17 downto 0) := (others => '0');
    signal hidden_6 : std_logic := '0';
    signal v1_even_6 : unsigned(4 downto 0) := (others => '0');
    signal v1_is_odd_6 : std_logic := '0';
    signal x1_6 : signed(15 downto 0) := (others => '0');
    signal place1_4_6 : unsigned(0 downto 0) := (others => '0');
    signal place1_2_6 : unsigned(0 downto 0) := (others => '0');
    signal rr1_1_6 : unsigned(15 downto 0) := (others => '0');
    signal place1_1_6 : unsigned(0 downto 0) := (others => '0');
    signal normal1_6 : std_logic := '0';
    signal rr1_rest_wide_6 : unsigned(15 downto 0) := (others => '0');
    signal u1_kept_signed_6 : signed(15 downto 0) := (others => '0');
    signal alone1_6 : std_logic := '0';
    signal end1_even_6 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_6 : unsigned(11 downto 0) := (others => '0');
    signal texels1_00_6 : unsigned(1 downto 0) := (others => '0');
    signal texels1_00_v2_6 : unsigned(1 downto 0) := (others => '0');
    signal texels1_010_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_10_6 : unsigned(1 downto 0) := (others => '0');
    signal texels1_10_v2_6 : unsigned(1 downto 0) := (others => '0');
    signal texels1_110_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_6 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_6 : std_logic := '0';
    signal v1_weight_of_1_6 : std_logic := '0';
    signal v1_weight_of_2_6 : std_logic := '0';
    signal v1_weight_of_3_6 : std_logic := '0';
    signal v1_weight_of_4_6 : std_logic := '0';
    signal v1_weight_of_5_6 : std_logic := '0';
    signal blend1_signed_6 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_6 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_6 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_6 : std_logic := '0';
    signal square1_g_by_1_6 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_6 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_6 : std_logic := '0';
    signal square1_b_by_1_6 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_6 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_6 : std_logic := '0';
    signal exponent1_2_6 : unsigned(1 downto 0) := (others => '0');
    signal rest1_6 : unsigned(15 downto 0) := (others => '0');
    signal rest1_cut_6 : unsigned(8 downto 0) := (others => '0');
    signal step1_6 : unsigned(3 downto 0) := (others => '0');
    signal step1_number_6 : unsigned(3 downto 0) := (others => '0');
    signal part1_6 : unsigned(4 downto 0) := (others => '0');
    signal weight1_6 : unsigned(4 downto 0) := (others => '0');
    signal texel1_00_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_000_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_00_v2_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_10_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_6 : unsigned(6 downto 0) := (others => '0');
    signal texel1_10_v2_6 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_6 : unsigned(6 downto 0) := (others => '0');
    signal in_nz_7 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_7 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_7 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_7 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_7 : unsigned(17 downto 0) := (others => '0');
    signal hidden_7 : std_logic := '0';
    signal v1_is_odd_7 : std_logic := '0';
    signal x1_7 : signed(15 downto 0) := (others => '0');
    signal exponent1_2_7 : unsigned(1 downto 0) := (others => '0');
    signal place1_1_7 : unsigned(0 downto 0) := (others => '0');
    signal step1_number_7 : unsigned(3 downto 0) := (others => '0');
    signal weight1_7 : unsigned(4 downto 0) := (others => '0');
    signal u1_kept_signed_7 : signed(15 downto 0) := (others => '0');
    signal alone1_7 : std_logic := '0';
    signal end1_even_7 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_7 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_7 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_7 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_7 : std_logic := '0';
    signal v1_weight_of_1_7 : std_logic := '0';
    signal v1_weight_of_2_7 : std_logic := '0';
    signal v1_weight_of_3_7 : std_logic := '0';
    signal v1_weight_of_4_7 : std_logic := '0';
    signal v1_weight_of_5_7 : std_logic := '0';
    signal blend1_signed_7 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_7 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_7 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_7 : std_logic := '0';
    signal square1_g_by_1_7 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_7 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_7 : std_logic := '0';
    signal square1_b_by_1_7 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_7 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_7 : std_logic := '0';
    signal exponent1_1_7 : unsigned(2 downto 0) := (others => '0');
    signal octave1_7 : unsigned(2 downto 0) := (others => '0');
    signal in_nz_8 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_8 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_8 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_8 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_8 : unsigned(17 downto 0) := (others => '0');
    signal hidden_8 : std_logic := '0';
    signal v1_is_odd_8 : std_logic := '0';
    signal x1_8 : signed(15 downto 0) := (others => '0');
    signal step1_number_8 : unsigned(3 downto 0) := (others => '0');
    signal octave1_8 : unsigned(2 downto 0) := (others => '0');
    signal weight1_8 : unsigned(4 downto 0) := (others => '0');
    signal u1_kept_signed_8 : signed(15 downto 0) := (others => '0');
    signal alone1_8 : std_logic := '0';
    signal end1_even_8 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_8 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_8 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_8 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_8 : std_logic := '0';
    signal v1_weight_of_1_8 : std_logic := '0';
    signal v1_weight_of_2_8 : std_logic := '0';
    signal v1_weight_of_3_8 : std_logic := '0';
    signal v1_weight_of_4_8 : std_logic := '0';
    signal v1_weight_of_5_8 : std_logic := '0';
    signal blend1_signed_8 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_8 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_8 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_8 : std_logic := '0';
    signal square1_g_by_1_8 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_8 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_8 : std_logic := '0';
    signal square1_b_by_1_8 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_8 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_8 : std_logic := '0';
    signal column1_8 : unsigned(6 downto 0) := (others => '0');
    signal in_nz_9 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_9 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_9 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_9 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_9 : unsigned(17 downto 0) := (others => '0');
    signal hidden_9 : std_logic := '0';
    signal v1_is_odd_9 : std_logic := '0';
    signal x1_9 : signed(15 downto 0) := (others => '0');
    signal column1_9 : unsigned(6 downto 0) := (others => '0');
    signal weight1_9 : unsigned(4 downto 0) := (others => '0');
    signal u1_kept_signed_9 : signed(15 downto 0) := (others => '0');
    signal alone1_9 : std_logic := '0';
    signal end1_even_9 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_9 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_9 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_9 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_9 : std_logic := '0';
    signal v1_weight_of_1_9 : std_logic := '0';
    signal v1_weight_of_2_9 : std_logic := '0';
    signal v1_weight_of_3_9 : std_logic := '0';
    signal v1_weight_of_4_9 : std_logic := '0';
    signal v1_weight_of_5_9 : std_logic := '0';
    signal blend1_signed_9 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_9 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_9 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_9 : std_logic := '0';
    signal square1_g_by_1_9 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_9 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_9 : std_logic := '0';
    signal square1_b_by_1_9 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_9 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_9 : std_logic := '0';
    signal in_nz_10 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_10 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_10 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_10 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_10 : unsigned(17 downto 0) := (others => '0');
    signal hidden_10 : std_logic := '0';
    signal v1_is_odd_10 : std_logic := '0';
    signal x1_10 : signed(15 downto 0) := (others => '0');
    signal weight1_10 : unsigned(4 downto 0) := (others => '0');
    signal u1_kept_signed_10 : signed(15 downto 0) := (others => '0');
    signal alone1_10 : std_logic := '0';
    signal end1_even_10 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_10 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_10 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_10 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_10 : std_logic := '0';
    signal v1_weight_of_1_10 : std_logic := '0';
    signal v1_weight_of_2_10 : std_logic := '0';
    signal v1_weight_of_3_10 : std_logic := '0';
    signal v1_weight_of_4_10 : std_logic := '0';
    signal v1_weight_of_5_10 : std_logic := '0';
    signal blend1_signed_10 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_10 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_10 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_10 : std_logic := '0';
    signal square1_g_by_1_10 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_10 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_10 : std_logic := '0';
    signal square1_b_by_1_10 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_10 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_10 : std_logic := '0';
    signal root_1_10 : unsigned(15 downto 0) := (others => '0');
    signal fall_1_10 : unsigned(14 downto 0) := (others => '0');
    signal in_nz_11 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_11 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_11 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_11 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_11 : unsigned(17 downto 0) := (others => '0');
    signal hidden_11 : std_logic := '0';
    signal v1_is_odd_11 : std_logic := '0';
    signal x1_11 : signed(15 downto 0) := (others => '0');
    signal weight1_11 : unsigned(4 downto 0) := (others => '0');
    signal root_1_11 : unsigned(15 downto 0) := (others => '0');
    signal fall_1_11 : unsigned(14 downto 0) := (others => '0');
    signal u1_kept_signed_11 : signed(15 downto 0) := (others => '0');
    signal alone1_11 : std_logic := '0';
    signal end1_even_11 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_11 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_11 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_11 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_11 : std_logic := '0';
    signal v1_weight_of_1_11 : std_logic := '0';
    signal v1_weight_of_2_11 : std_logic := '0';
    signal v1_weight_of_3_11 : std_logic := '0';
    signal v1_weight_of_4_11 : std_logic := '0';
    signal v1_weight_of_5_11 : std_logic := '0';
    signal blend1_signed_11 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_11 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_11 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_11 : std_logic := '0';
    signal square1_g_by_1_11 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_11 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_11 : std_logic := '0';
    signal square1_b_by_1_11 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_11 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_11 : std_logic := '0';
    signal in_nz_12 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_12 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_12 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_12 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_12 : unsigned(17 downto 0) := (others => '0');
    signal hidden_12 : std_logic := '0';
    signal v1_is_odd_12 : std_logic := '0';
    signal x1_12 : signed(15 downto 0) := (others => '0');
    signal weight1_12 : unsigned(4 downto 0) := (others => '0');
    signal root_1_12 : unsigned(15 downto 0) := (others => '0');
    signal fall_1_12 : unsigned(14 downto 0) := (others => '0');
    signal u1_kept_signed_12 : signed(15 downto 0) := (others => '0');
    signal alone1_12 : std_logic := '0';
    signal end1_even_12 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_12 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_12 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_12 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_12 : std_logic := '0';
    signal v1_weight_of_1_12 : std_logic := '0';
    signal v1_weight_of_2_12 : std_logic := '0';
    signal v1_weight_of_3_12 : std_logic := '0';
    signal v1_weight_of_4_12 : std_logic := '0';
    signal v1_weight_of_5_12 : std_logic := '0';
    signal blend1_signed_12 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_12 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_12 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_12 : std_logic := '0';
    signal square1_g_by_1_12 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_12 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_12 : std_logic := '0';
    signal square1_b_by_1_12 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_12 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_12 : std_logic := '0';
    signal fall_part1_12 : unsigned(19 downto 0) := (others => '0');
    signal in_nz_13 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_13 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_13 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_13 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_13 : unsigned(17 downto 0) := (others => '0');
    signal hidden_13 : std_logic := '0';
    signal v1_is_odd_13 : std_logic := '0';
    signal x1_13 : signed(15 downto 0) := (others => '0');
    signal root_1_13 : unsigned(15 downto 0) := (others => '0');
    signal fall_part1_13 : unsigned(19 downto 0) := (others => '0');
    signal u1_kept_signed_13 : signed(15 downto 0) := (others => '0');
    signal alone1_13 : std_logic := '0';
    signal end1_even_13 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_13 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_13 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_13 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_13 : std_logic := '0';
    signal v1_weight_of_1_13 : std_logic := '0';
    signal v1_weight_of_2_13 : std_logic := '0';
    signal v1_weight_of_3_13 : std_logic := '0';
    signal v1_weight_of_4_13 : std_logic := '0';
    signal v1_weight_of_5_13 : std_logic := '0';
    signal blend1_signed_13 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_13 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_13 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_13 : std_logic := '0';
    signal square1_g_by_1_13 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_13 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_13 : std_logic := '0';
    signal square1_b_by_1_13 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_13 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_13 : std_logic := '0';
    signal in_nz_14 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_14 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_14 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_14 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_14 : unsigned(17 downto 0) := (others => '0');
    signal hidden_14 : std_logic := '0';
    signal v1_is_odd_14 : std_logic := '0';
    signal x1_14 : signed(15 downto 0) := (others => '0');
    signal root_1_14 : unsigned(15 downto 0) := (others => '0');
    signal fall_part1_14 : unsigned(19 downto 0) := (others => '0');
    signal u1_kept_signed_14 : signed(15 downto 0) := (others => '0');
    signal alone1_14 : std_logic := '0';
    signal end1_even_14 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_14 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_14 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_14 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_14 : std_logic := '0';
    signal v1_weight_of_1_14 : std_logic := '0';
    signal v1_weight_of_2_14 : std_logic := '0';
    signal v1_weight_of_3_14 : std_logic := '0';
    signal v1_weight_of_4_14 : std_logic := '0';
    signal v1_weight_of_5_14 : std_logic := '0';
    signal blend1_signed_14 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_14 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_14 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_14 : std_logic := '0';
    signal square1_g_by_1_14 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_14 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_14 : std_logic := '0';
    signal square1_b_by_1_14 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_14 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_14 : std_logic := '0';
    signal root_at1_14 : signed(21 downto 0) := (others => '0');
    signal root_cut1_14 : signed(16 downto 0) := (others => '0');
    signal in_nz_15 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_15 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_15 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_15 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_15 : unsigned(17 downto 0) := (others => '0');
    signal hidden_15 : std_logic := '0';
    signal v1_is_odd_15 : std_logic := '0';
    signal x1_15 : signed(15 downto 0) := (others => '0');
    signal root_cut1_15 : signed(16 downto 0) := (others => '0');
    signal u1_kept_signed_15 : signed(15 downto 0) := (others => '0');
    signal alone1_15 : std_logic := '0';
    signal end1_even_15 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_15 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_15 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_15 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_15 : std_logic := '0';
    signal v1_weight_of_1_15 : std_logic := '0';
    signal v1_weight_of_2_15 : std_logic := '0';
    signal v1_weight_of_3_15 : std_logic := '0';
    signal v1_weight_of_4_15 : std_logic := '0';
    signal v1_weight_of_5_15 : std_logic := '0';
    signal blend1_signed_15 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_15 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_15 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_15 : std_logic := '0';
    signal square1_g_by_1_15 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_15 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_15 : std_logic := '0';
    signal square1_b_by_1_15 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_15 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_15 : std_logic := '0';
    signal tilt1_exact_15 : signed(32 downto 0) := (others => '0');
    signal tilt1_cut_15 : signed(18 downto 0) := (others => '0');
    signal in_nz_16 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_16 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_16 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_16 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_16 : unsigned(17 downto 0) := (others => '0');
    signal hidden_16 : std_logic := '0';
    signal v1_is_odd_16 : std_logic := '0';
    signal x1_16 : signed(15 downto 0) := (others => '0');
    signal tilt1_cut_16 : signed(18 downto 0) := (others => '0');
    signal alone1_16 : std_logic := '0';
    signal end1_even_16 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_16 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_16 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_16 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_16 : std_logic := '0';
    signal v1_weight_of_1_16 : std_logic := '0';
    signal v1_weight_of_2_16 : std_logic := '0';
    signal v1_weight_of_3_16 : std_logic := '0';
    signal v1_weight_of_4_16 : std_logic := '0';
    signal v1_weight_of_5_16 : std_logic := '0';
    signal blend1_signed_16 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_16 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_16 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_16 : std_logic := '0';
    signal square1_g_by_1_16 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_16 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_16 : std_logic := '0';
    signal square1_b_by_1_16 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_16 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_16 : std_logic := '0';
    signal tilt1_kept_16 : unsigned(12 downto 0) := (others => '0');
    signal tilt1_16 : unsigned(12 downto 0) := (others => '0');
    signal tilt1_signed_16 : signed(13 downto 0) := (others => '0');
    signal in_nz_17 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_17 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_17 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_17 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_17 : unsigned(17 downto 0) := (others => '0');
    signal hidden_17 : std_logic := '0';
    signal v1_is_odd_17 : std_logic := '0';
    signal x1_17 : signed(15 downto 0) := (others => '0');
    signal tilt1_signed_17 : signed(13 downto 0) := (others => '0');
    signal end1_even_17 : unsigned(11 downto 0) := (others => '0');
    signal end1_odd_17 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_17 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_17 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_17 : std_logic := '0';
    signal v1_weight_of_1_17 : std_logic := '0';
    signal v1_weight_of_2_17 : std_logic := '0';
    signal v1_weight_of_3_17 : std_logic := '0';
    signal v1_weight_of_4_17 : std_logic := '0';
    signal v1_weight_of_5_17 : std_logic := '0';
    signal blend1_signed_17 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_17 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_17 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_17 : std_logic := '0';
    signal square1_g_by_1_17 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_17 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_17 : std_logic := '0';
    signal square1_b_by_1_17 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_17 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_17 : std_logic := '0';
    signal turn_more_exact1_even_17 : signed(28 downto 0) := (others => '0');
    signal turn_more1_even_17 : signed(14 downto 0) := (others => '0');
    signal turn_more_exact1_odd_17 : signed(28 downto 0) := (others => '0');
    signal turn_more1_odd_17 : signed(14 downto 0) := (others => '0');
    signal in_nz_18 : signed(17 downto 0) := (others => '0');
    signal in_turn1_even_18 : signed(14 downto 0) := (others => '0');
    signal in_turn1_odd_18 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_18 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_18 : unsigned(17 downto 0) := (others => '0');
    signal hidden_18 : std_logic := '0';
    signal v1_is_odd_18 : std_logic := '0';
    signal x1_18 : signed(15 downto 0) := (others => '0');
    signal turn_more1_even_18 : signed(14 downto 0) := (others => '0');
    signal end1_even_18 : unsigned(11 downto 0) := (others => '0');
    signal turn_more1_odd_18 : signed(14 downto 0) := (others => '0');
    signal end1_odd_18 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_18 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_18 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_18 : std_logic := '0';
    signal v1_weight_of_1_18 : std_logic := '0';
    signal v1_weight_of_2_18 : std_logic := '0';
    signal v1_weight_of_3_18 : std_logic := '0';
    signal v1_weight_of_4_18 : std_logic := '0';
    signal v1_weight_of_5_18 : std_logic := '0';
    signal blend1_signed_18 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_18 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_18 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_18 : std_logic := '0';
    signal square1_g_by_1_18 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_18 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_18 : std_logic := '0';
    signal square1_b_by_1_18 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_18 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_18 : std_logic := '0';
    signal turn_exact1_even_18 : signed(15 downto 0) := (others => '0');
    signal turn_exact1_odd_18 : signed(15 downto 0) := (others => '0');
    signal in_nz_19 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_19 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_19 : unsigned(17 downto 0) := (others => '0');
    signal hidden_19 : std_logic := '0';
    signal v1_is_odd_19 : std_logic := '0';
    signal x1_19 : signed(15 downto 0) := (others => '0');
    signal turn_exact1_even_19 : signed(15 downto 0) := (others => '0');
    signal end1_even_19 : unsigned(11 downto 0) := (others => '0');
    signal turn_exact1_odd_19 : signed(15 downto 0) := (others => '0');
    signal end1_odd_19 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_19 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_19 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_19 : std_logic := '0';
    signal v1_weight_of_1_19 : std_logic := '0';
    signal v1_weight_of_2_19 : std_logic := '0';
    signal v1_weight_of_3_19 : std_logic := '0';
    signal v1_weight_of_4_19 : std_logic := '0';
    signal v1_weight_of_5_19 : std_logic := '0';
    signal blend1_signed_19 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_19 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_19 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_19 : std_logic := '0';
    signal square1_g_by_1_19 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_19 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_19 : std_logic := '0';
    signal square1_b_by_1_19 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_19 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_19 : std_logic := '0';
    signal turn1_even_19 : signed(14 downto 0) := (others => '0');
    signal turn1_odd_19 : signed(14 downto 0) := (others => '0');
    signal in_nz_20 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_20 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_20 : unsigned(17 downto 0) := (others => '0');
    signal hidden_20 : std_logic := '0';
    signal v1_is_odd_20 : std_logic := '0';
    signal x1_20 : signed(15 downto 0) := (others => '0');
    signal turn1_even_20 : signed(14 downto 0) := (others => '0');
    signal end1_even_20 : unsigned(11 downto 0) := (others => '0');
    signal turn1_odd_20 : signed(14 downto 0) := (others => '0');
    signal end1_odd_20 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_20 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_20 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_20 : std_logic := '0';
    signal v1_weight_of_1_20 : std_logic := '0';
    signal v1_weight_of_2_20 : std_logic := '0';
    signal v1_weight_of_3_20 : std_logic := '0';
    signal v1_weight_of_4_20 : std_logic := '0';
    signal v1_weight_of_5_20 : std_logic := '0';
    signal blend1_signed_20 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_20 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_20 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_20 : std_logic := '0';
    signal square1_g_by_1_20 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_20 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_20 : std_logic := '0';
    signal square1_b_by_1_20 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_20 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_20 : std_logic := '0';
    signal turn_up1_even_20 : unsigned(14 downto 0) := (others => '0');
    signal step1_even_20 : unsigned(6 downto 0) := (others => '0');
    signal step_number1_even_20 : unsigned(6 downto 0) := (others => '0');
    signal past1_even_20 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_even_20 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_even_signed_20 : signed(8 downto 0) := (others => '0');
    signal turn_up1_odd_20 : unsigned(14 downto 0) := (others => '0');
    signal step1_odd_20 : unsigned(6 downto 0) := (others => '0');
    signal step_number1_odd_20 : unsigned(6 downto 0) := (others => '0');
    signal past1_odd_20 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_odd_20 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_odd_signed_20 : signed(8 downto 0) := (others => '0');
    signal in_nz_21 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_21 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_21 : unsigned(17 downto 0) := (others => '0');
    signal hidden_21 : std_logic := '0';
    signal v1_is_odd_21 : std_logic := '0';
    signal x1_21 : signed(15 downto 0) := (others => '0');
    signal step_number1_even_21 : unsigned(6 downto 0) := (others => '0');
    signal past_part1_even_21 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_even_signed_21 : signed(8 downto 0) := (others => '0');
    signal end1_even_21 : unsigned(11 downto 0) := (others => '0');
    signal step_number1_odd_21 : unsigned(6 downto 0) := (others => '0');
    signal past_part1_odd_21 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_odd_signed_21 : signed(8 downto 0) := (others => '0');
    signal end1_odd_21 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_21 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_21 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_21 : std_logic := '0';
    signal v1_weight_of_1_21 : std_logic := '0';
    signal v1_weight_of_2_21 : std_logic := '0';
    signal v1_weight_of_3_21 : std_logic := '0';
    signal v1_weight_of_4_21 : std_logic := '0';
    signal v1_weight_of_5_21 : std_logic := '0';
    signal blend1_signed_21 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_21 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_21 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_21 : std_logic := '0';
    signal square1_g_by_1_21 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_21 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_21 : std_logic := '0';
    signal square1_b_by_1_21 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_21 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_21 : std_logic := '0';
    signal in_nz_22 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_22 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_22 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_22 : unsigned(17 downto 0) := (others => '0');
    signal hidden_22 : std_logic := '0';
    signal v1_is_odd_22 : std_logic := '0';
    signal x1_22 : signed(15 downto 0) := (others => '0');
    signal past_part1_even_22 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_even_signed_22 : signed(8 downto 0) := (others => '0');
    signal end1_even_22 : unsigned(11 downto 0) := (others => '0');
    signal past_part1_odd_22 : unsigned(7 downto 0) := (others => '0');
    signal past_part1_odd_signed_22 : signed(8 downto 0) := (others => '0');
    signal end1_odd_22 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_22 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_22 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_22 : std_logic := '0';
    signal v1_weight_of_1_22 : std_logic := '0';
    signal v1_weight_of_2_22 : std_logic := '0';
    signal v1_weight_of_3_22 : std_logic := '0';
    signal v1_weight_of_4_22 : std_logic := '0';
    signal v1_weight_of_5_22 : std_logic := '0';
    signal blend1_signed_22 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_22 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_22 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_22 : std_logic := '0';
    signal square1_g_by_1_22 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_22 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_22 : std_logic := '0';
    signal square1_b_by_1_22 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_22 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_22 : std_logic := '0';
    signal sine_1_even_22 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_even_22 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_even_22 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_even_22 : signed(11 downto 0) := (others => '0');
    signal sine_1_odd_22 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_odd_22 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_odd_22 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_odd_22 : signed(11 downto 0) := (others => '0');
    signal in_nz_23 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_23 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_23 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_23 : unsigned(17 downto 0) := (others => '0');
    signal hidden_23 : std_logic := '0';
    signal v1_is_odd_23 : std_logic := '0';
    signal x1_23 : signed(15 downto 0) := (others => '0');
    signal past_part1_even_23 : unsigned(7 downto 0) := (others => '0');
    signal sine_1_even_23 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_even_23 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_even_23 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_even_23 : signed(11 downto 0) := (others => '0');
    signal past_part1_even_signed_23 : signed(8 downto 0) := (others => '0');
    signal end1_even_23 : unsigned(11 downto 0) := (others => '0');
    signal past_part1_odd_23 : unsigned(7 downto 0) := (others => '0');
    signal sine_1_odd_23 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_odd_23 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_odd_23 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_odd_23 : signed(11 downto 0) := (others => '0');
    signal past_part1_odd_signed_23 : signed(8 downto 0) := (others => '0');
    signal end1_odd_23 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_23 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_23 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_23 : std_logic := '0';
    signal v1_weight_of_1_23 : std_logic := '0';
    signal v1_weight_of_2_23 : std_logic := '0';
    signal v1_weight_of_3_23 : std_logic := '0';
    signal v1_weight_of_4_23 : std_logic := '0';
    signal v1_weight_of_5_23 : std_logic := '0';
    signal blend1_signed_23 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_23 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_23 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_23 : std_logic := '0';
    signal square1_g_by_1_23 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_23 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_23 : std_logic := '0';
    signal square1_b_by_1_23 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_23 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_23 : std_logic := '0';
    signal in_nz_24 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_24 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_24 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_24 : unsigned(17 downto 0) := (others => '0');
    signal hidden_24 : std_logic := '0';
    signal v1_is_odd_24 : std_logic := '0';
    signal x1_24 : signed(15 downto 0) := (others => '0');
    signal past_part1_even_24 : unsigned(7 downto 0) := (others => '0');
    signal sine_1_even_24 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_even_24 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_even_24 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_even_24 : signed(11 downto 0) := (others => '0');
    signal past_part1_even_signed_24 : signed(8 downto 0) := (others => '0');
    signal end1_even_24 : unsigned(11 downto 0) := (others => '0');
    signal past_part1_odd_24 : unsigned(7 downto 0) := (others => '0');
    signal sine_1_odd_24 : signed(14 downto 0) := (others => '0');
    signal sine_rise_1_odd_24 : unsigned(10 downto 0) := (others => '0');
    signal cosine_1_odd_24 : unsigned(14 downto 0) := (others => '0');
    signal cosine_rise_1_odd_24 : signed(11 downto 0) := (others => '0');
    signal past_part1_odd_signed_24 : signed(8 downto 0) := (others => '0');
    signal end1_odd_24 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_24 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_24 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_24 : std_logic := '0';
    signal v1_weight_of_1_24 : std_logic := '0';
    signal v1_weight_of_2_24 : std_logic := '0';
    signal v1_weight_of_3_24 : std_logic := '0';
    signal v1_weight_of_4_24 : std_logic := '0';
    signal v1_weight_of_5_24 : std_logic := '0';
    signal blend1_signed_24 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_24 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_24 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_24 : std_logic := '0';
    signal square1_g_by_1_24 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_24 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_24 : std_logic := '0';
    signal square1_b_by_1_24 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_24 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_24 : std_logic := '0';
    signal sin_part1_even_24 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_even_24 : signed(20 downto 0) := (others => '0');
    signal sin_part1_odd_24 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_odd_24 : signed(20 downto 0) := (others => '0');
    signal in_nz_25 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_25 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_25 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_25 : unsigned(17 downto 0) := (others => '0');
    signal hidden_25 : std_logic := '0';
    signal v1_is_odd_25 : std_logic := '0';
    signal x1_25 : signed(15 downto 0) := (others => '0');
    signal sine_1_even_25 : signed(14 downto 0) := (others => '0');
    signal cosine_1_even_25 : unsigned(14 downto 0) := (others => '0');
    signal sin_part1_even_25 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_even_25 : signed(20 downto 0) := (others => '0');
    signal end1_even_25 : unsigned(11 downto 0) := (others => '0');
    signal sine_1_odd_25 : signed(14 downto 0) := (others => '0');
    signal cosine_1_odd_25 : unsigned(14 downto 0) := (others => '0');
    signal sin_part1_odd_25 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_odd_25 : signed(20 downto 0) := (others => '0');
    signal end1_odd_25 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_25 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_25 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_25 : std_logic := '0';
    signal v1_weight_of_1_25 : std_logic := '0';
    signal v1_weight_of_2_25 : std_logic := '0';
    signal v1_weight_of_3_25 : std_logic := '0';
    signal v1_weight_of_4_25 : std_logic := '0';
    signal v1_weight_of_5_25 : std_logic := '0';
    signal blend1_signed_25 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_25 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_25 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_25 : std_logic := '0';
    signal square1_g_by_1_25 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_25 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_25 : std_logic := '0';
    signal square1_b_by_1_25 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_25 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_25 : std_logic := '0';
    signal in_nz_26 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_26 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_26 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_26 : unsigned(17 downto 0) := (others => '0');
    signal hidden_26 : std_logic := '0';
    signal v1_is_odd_26 : std_logic := '0';
    signal x1_26 : signed(15 downto 0) := (others => '0');
    signal sine_1_even_26 : signed(14 downto 0) := (others => '0');
    signal cosine_1_even_26 : unsigned(14 downto 0) := (others => '0');
    signal sin_part1_even_26 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_even_26 : signed(20 downto 0) := (others => '0');
    signal end1_even_26 : unsigned(11 downto 0) := (others => '0');
    signal sine_1_odd_26 : signed(14 downto 0) := (others => '0');
    signal cosine_1_odd_26 : unsigned(14 downto 0) := (others => '0');
    signal sin_part1_odd_26 : unsigned(18 downto 0) := (others => '0');
    signal cos_part1_odd_26 : signed(20 downto 0) := (others => '0');
    signal end1_odd_26 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_26 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_26 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_26 : std_logic := '0';
    signal v1_weight_of_1_26 : std_logic := '0';
    signal v1_weight_of_2_26 : std_logic := '0';
    signal v1_weight_of_3_26 : std_logic := '0';
    signal v1_weight_of_4_26 : std_logic := '0';
    signal v1_weight_of_5_26 : std_logic := '0';
    signal blend1_signed_26 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_26 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_26 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_26 : std_logic := '0';
    signal square1_g_by_1_26 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_26 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_26 : std_logic := '0';
    signal square1_b_by_1_26 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_26 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_26 : std_logic := '0';
    signal sin_exact1_even_26 : signed(25 downto 0) := (others => '0');
    signal sin1_even_26 : signed(15 downto 0) := (others => '0');
    signal cos_exact1_even_26 : signed(25 downto 0) := (others => '0');
    signal cos1_even_26 : signed(15 downto 0) := (others => '0');
    signal sin_exact1_odd_26 : signed(25 downto 0) := (others => '0');
    signal sin1_odd_26 : signed(15 downto 0) := (others => '0');
    signal cos_exact1_odd_26 : signed(25 downto 0) := (others => '0');
    signal cos1_odd_26 : signed(15 downto 0) := (others => '0');
    signal in_nz_27 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_27 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_27 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_27 : unsigned(17 downto 0) := (others => '0');
    signal hidden_27 : std_logic := '0';
    signal v1_is_odd_27 : std_logic := '0';
    signal x1_27 : signed(15 downto 0) := (others => '0');
    signal sin1_even_27 : signed(15 downto 0) := (others => '0');
    signal cos1_even_27 : signed(15 downto 0) := (others => '0');
    signal end1_even_27 : unsigned(11 downto 0) := (others => '0');
    signal sin1_odd_27 : signed(15 downto 0) := (others => '0');
    signal cos1_odd_27 : signed(15 downto 0) := (others => '0');
    signal end1_odd_27 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_27 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_27 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_27 : std_logic := '0';
    signal v1_weight_of_1_27 : std_logic := '0';
    signal v1_weight_of_2_27 : std_logic := '0';
    signal v1_weight_of_3_27 : std_logic := '0';
    signal v1_weight_of_4_27 : std_logic := '0';
    signal v1_weight_of_5_27 : std_logic := '0';
    signal blend1_signed_27 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_27 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_27 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_27 : std_logic := '0';
    signal square1_g_by_1_27 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_27 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_27 : std_logic := '0';
    signal square1_b_by_1_27 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_27 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_27 : std_logic := '0';
    signal xc1_even_exact_27 : signed(31 downto 0) := (others => '0');
    signal xc1_even_27 : signed(15 downto 0) := (others => '0');
    signal zs1_even_exact_27 : signed(33 downto 0) := (others => '0');
    signal zs1_even_27 : signed(16 downto 0) := (others => '0');
    signal zc1_even_exact_27 : signed(33 downto 0) := (others => '0');
    signal zc1_even_27 : signed(16 downto 0) := (others => '0');
    signal xs1_even_exact_27 : signed(31 downto 0) := (others => '0');
    signal xs1_even_27 : signed(15 downto 0) := (others => '0');
    signal xc1_odd_exact_27 : signed(31 downto 0) := (others => '0');
    signal xc1_odd_27 : signed(15 downto 0) := (others => '0');
    signal zs1_odd_exact_27 : signed(33 downto 0) := (others => '0');
    signal zs1_odd_27 : signed(16 downto 0) := (others => '0');
    signal zc1_odd_exact_27 : signed(33 downto 0) := (others => '0');
    signal zc1_odd_27 : signed(16 downto 0) := (others => '0');
    signal xs1_odd_exact_27 : signed(31 downto 0) := (others => '0');
    signal xs1_odd_27 : signed(15 downto 0) := (others => '0');
    signal in_gain1r_28 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_28 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_28 : unsigned(17 downto 0) := (others => '0');
    signal hidden_28 : std_logic := '0';
    signal v1_is_odd_28 : std_logic := '0';
    signal xc1_even_28 : signed(15 downto 0) := (others => '0');
    signal zs1_even_28 : signed(16 downto 0) := (others => '0');
    signal zc1_even_28 : signed(16 downto 0) := (others => '0');
    signal xs1_even_28 : signed(15 downto 0) := (others => '0');
    signal end1_even_28 : unsigned(11 downto 0) := (others => '0');
    signal xc1_odd_28 : signed(15 downto 0) := (others => '0');
    signal zs1_odd_28 : signed(16 downto 0) := (others => '0');
    signal zc1_odd_28 : signed(16 downto 0) := (others => '0');
    signal xs1_odd_28 : signed(15 downto 0) := (others => '0');
    signal end1_odd_28 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_28 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_28 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_28 : std_logic := '0';
    signal v1_weight_of_1_28 : std_logic := '0';
    signal v1_weight_of_2_28 : std_logic := '0';
    signal v1_weight_of_3_28 : std_logic := '0';
    signal v1_weight_of_4_28 : std_logic := '0';
    signal v1_weight_of_5_28 : std_logic := '0';
    signal blend1_signed_28 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_28 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_28 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_28 : std_logic := '0';
    signal square1_g_by_1_28 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_28 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_28 : std_logic := '0';
    signal square1_b_by_1_28 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_28 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_28 : std_logic := '0';
    signal across1_even_28 : signed(16 downto 0) := (others => '0');
    signal u1_even_scaled_28 : signed(16 downto 0) := (others => '0');
    signal across1_odd_28 : signed(16 downto 0) := (others => '0');
    signal u1_odd_scaled_28 : signed(16 downto 0) := (others => '0');
    signal in_gain1r_29 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_29 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_29 : unsigned(17 downto 0) := (others => '0');
    signal hidden_29 : std_logic := '0';
    signal v1_is_odd_29 : std_logic := '0';
    signal zc1_even_29 : signed(16 downto 0) := (others => '0');
    signal xs1_even_29 : signed(15 downto 0) := (others => '0');
    signal u1_even_scaled_29 : signed(16 downto 0) := (others => '0');
    signal end1_even_29 : unsigned(11 downto 0) := (others => '0');
    signal zc1_odd_29 : signed(16 downto 0) := (others => '0');
    signal xs1_odd_29 : signed(15 downto 0) := (others => '0');
    signal u1_odd_scaled_29 : signed(16 downto 0) := (others => '0');
    signal end1_odd_29 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_29 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_29 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_29 : std_logic := '0';
    signal v1_weight_of_1_29 : std_logic := '0';
    signal v1_weight_of_2_29 : std_logic := '0';
    signal v1_weight_of_3_29 : std_logic := '0';
    signal v1_weight_of_4_29 : std_logic := '0';
    signal v1_weight_of_5_29 : std_logic := '0';
    signal blend1_signed_29 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_29 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_29 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_29 : std_logic := '0';
    signal square1_g_by_1_29 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_29 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_29 : std_logic := '0';
    signal square1_b_by_1_29 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_29 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_29 : std_logic := '0';
    signal behind1_even_29 : std_logic := '0';
    signal u1_even_place_29 : signed(17 downto 0) := (others => '0');
    signal u1_even_cut_29 : signed(14 downto 0) := (others => '0');
    signal behind1_odd_29 : std_logic := '0';
    signal u1_odd_place_29 : signed(17 downto 0) := (others => '0');
    signal u1_odd_cut_29 : signed(14 downto 0) := (others => '0');
    signal in_gain1r_30 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_30 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_30 : unsigned(17 downto 0) := (others => '0');
    signal hidden_30 : std_logic := '0';
    signal v1_is_odd_30 : std_logic := '0';
    signal behind1_even_30 : std_logic := '0';
    signal u1_even_cut_30 : signed(14 downto 0) := (others => '0');
    signal end1_even_30 : unsigned(11 downto 0) := (others => '0');
    signal behind1_odd_30 : std_logic := '0';
    signal u1_odd_cut_30 : signed(14 downto 0) := (others => '0');
    signal end1_odd_30 : unsigned(11 downto 0) := (others => '0');
    signal texels1_000_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_30 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_30 : unsigned(6 downto 0) := (others => '0');
    signal v1_weight_of_0_30 : std_logic := '0';
    signal v1_weight_of_1_30 : std_logic := '0';
    signal v1_weight_of_2_30 : std_logic := '0';
    signal v1_weight_of_3_30 : std_logic := '0';
    signal v1_weight_of_4_30 : std_logic := '0';
    signal v1_weight_of_5_30 : std_logic := '0';
    signal blend1_signed_30 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_30 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_30 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_30 : std_logic := '0';
    signal square1_g_by_1_30 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_30 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_30 : std_logic := '0';
    signal square1_b_by_1_30 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_30 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_30 : std_logic := '0';
    signal u1_even_kept_30 : unsigned(11 downto 0) := (others => '0');
    signal u_at1_even_30 : unsigned(11 downto 0) := (others => '0');
    signal u1_even_texel_30 : unsigned(5 downto 0) := (others => '0');
    signal u1_even_weight_30 : unsigned(5 downto 0) := (others => '0');
    signal u1_even_odd_high_30 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_odd_30 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_is_odd_30 : std_logic := '0';
    signal u1_odd_kept_30 : unsigned(11 downto 0) := (others => '0');
    signal u_at1_odd_30 : unsigned(11 downto 0) := (others => '0');
    signal u1_odd_texel_30 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_weight_30 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_odd_high_30 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_odd_30 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_is_odd_30 : std_logic := '0';
    signal u1_even_weight_bit_0_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_bit_1_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_bit_2_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_bit_3_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_bit_4_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_bit_5_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_even_weight_of_0_flag_30 : std_logic := '0';
    signal u1_even_weight_of_0_not_30 : std_logic := '0';
    signal u1_even_weight_of_0_30 : std_logic := '0';
    signal u1_even_weight_of_1_flag_30 : std_logic := '0';
    signal u1_even_weight_of_1_not_30 : std_logic := '0';
    signal u1_even_weight_of_1_30 : std_logic := '0';
    signal u1_even_weight_of_2_flag_30 : std_logic := '0';
    signal u1_even_weight_of_2_not_30 : std_logic := '0';
    signal u1_even_weight_of_2_30 : std_logic := '0';
    signal u1_even_weight_of_3_flag_30 : std_logic := '0';
    signal u1_even_weight_of_3_not_30 : std_logic := '0';
    signal u1_even_weight_of_3_30 : std_logic := '0';
    signal u1_even_weight_of_4_flag_30 : std_logic := '0';
    signal u1_even_weight_of_4_not_30 : std_logic := '0';
    signal u1_even_weight_of_4_30 : std_logic := '0';
    signal u1_even_weight_of_5_flag_30 : std_logic := '0';
    signal u1_even_weight_of_5_not_30 : std_logic := '0';
    signal u1_even_weight_of_5_30 : std_logic := '0';
    signal u1_odd_weight_bit_0_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_bit_1_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_bit_2_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_bit_3_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_bit_4_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_bit_5_30 : unsigned(0 downto 0) := (others => '0');
    signal u1_odd_weight_of_0_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_0_not_30 : std_logic := '0';
    signal u1_odd_weight_of_0_30 : std_logic := '0';
    signal u1_odd_weight_of_1_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_1_not_30 : std_logic := '0';
    signal u1_odd_weight_of_1_30 : std_logic := '0';
    signal u1_odd_weight_of_2_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_2_not_30 : std_logic := '0';
    signal u1_odd_weight_of_2_30 : std_logic := '0';
    signal u1_odd_weight_of_3_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_3_not_30 : std_logic := '0';
    signal u1_odd_weight_of_3_30 : std_logic := '0';
    signal u1_odd_weight_of_4_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_4_not_30 : std_logic := '0';
    signal u1_odd_weight_of_4_30 : std_logic := '0';
    signal u1_odd_weight_of_5_flag_30 : std_logic := '0';
    signal u1_odd_weight_of_5_not_30 : std_logic := '0';
    signal u1_odd_weight_of_5_30 : std_logic := '0';
    signal in_gain1r_31 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_31 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_31 : unsigned(17 downto 0) := (others => '0');
    signal hidden_31 : std_logic := '0';
    signal v1_is_odd_31 : std_logic := '0';
    signal u1_even_texel_31 : unsigned(5 downto 0) := (others => '0');
    signal u1_even_odd_31 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_is_odd_31 : std_logic := '0';
    signal u1_odd_texel_31 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_odd_31 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_is_odd_31 : std_logic := '0';
    signal texels1_000_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_001_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_010_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_011_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_100_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_101_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_110_31 : unsigned(6 downto 0) := (others => '0');
    signal texels1_111_31 : unsigned(6 downto 0) := (others => '0');
    signal u1_even_weight_of_0_31 : std_logic := '0';
    signal u1_even_weight_of_1_31 : std_logic := '0';
    signal u1_even_weight_of_2_31 : std_logic := '0';
    signal u1_even_weight_of_3_31 : std_logic := '0';
    signal u1_even_weight_of_4_31 : std_logic := '0';
    signal u1_even_weight_of_5_31 : std_logic := '0';
    signal u1_odd_weight_of_0_31 : std_logic := '0';
    signal u1_odd_weight_of_1_31 : std_logic := '0';
    signal u1_odd_weight_of_2_31 : std_logic := '0';
    signal u1_odd_weight_of_3_31 : std_logic := '0';
    signal u1_odd_weight_of_4_31 : std_logic := '0';
    signal u1_odd_weight_of_5_31 : std_logic := '0';
    signal v1_weight_of_0_31 : std_logic := '0';
    signal v1_weight_of_1_31 : std_logic := '0';
    signal v1_weight_of_2_31 : std_logic := '0';
    signal v1_weight_of_3_31 : std_logic := '0';
    signal v1_weight_of_4_31 : std_logic := '0';
    signal v1_weight_of_5_31 : std_logic := '0';
    signal blend1_signed_31 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_31 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_31 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_31 : std_logic := '0';
    signal square1_g_by_1_31 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_31 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_31 : std_logic := '0';
    signal square1_b_by_1_31 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_31 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_31 : std_logic := '0';
    signal u1_even_next_exact_31 : unsigned(6 downto 0) := (others => '0');
    signal u1_odd_next_exact_31 : unsigned(6 downto 0) := (others => '0');
    signal texel1_001_31 : unsigned(11 downto 0) := (others => '0');
    signal texel1_011_31 : unsigned(11 downto 0) := (others => '0');
    signal texel1_101_31 : unsigned(11 downto 0) := (others => '0');
    signal texel1_111_31 : unsigned(11 downto 0) := (others => '0');
    signal in_gain1r_32 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_32 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_32 : unsigned(17 downto 0) := (others => '0');
    signal hidden_32 : std_logic := '0';
    signal v1_is_odd_32 : std_logic := '0';
    signal u1_even_next_exact_32 : unsigned(6 downto 0) := (others => '0');
    signal u1_even_is_odd_32 : std_logic := '0';
    signal u1_odd_next_exact_32 : unsigned(6 downto 0) := (others => '0');
    signal u1_odd_is_odd_32 : std_logic := '0';
    signal texels1_000_32 : unsigned(6 downto 0) := (others => '0');
    signal texel1_001_32 : unsigned(11 downto 0) := (others => '0');
    signal texels1_010_32 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_32 : unsigned(11 downto 0) := (others => '0');
    signal texels1_100_32 : unsigned(6 downto 0) := (others => '0');
    signal texel1_101_32 : unsigned(11 downto 0) := (others => '0');
    signal texels1_110_32 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_32 : unsigned(11 downto 0) := (others => '0');
    signal u1_even_weight_of_0_32 : std_logic := '0';
    signal u1_even_weight_of_1_32 : std_logic := '0';
    signal u1_even_weight_of_2_32 : std_logic := '0';
    signal u1_even_weight_of_3_32 : std_logic := '0';
    signal u1_even_weight_of_4_32 : std_logic := '0';
    signal u1_even_weight_of_5_32 : std_logic := '0';
    signal u1_odd_weight_of_0_32 : std_logic := '0';
    signal u1_odd_weight_of_1_32 : std_logic := '0';
    signal u1_odd_weight_of_2_32 : std_logic := '0';
    signal u1_odd_weight_of_3_32 : std_logic := '0';
    signal u1_odd_weight_of_4_32 : std_logic := '0';
    signal u1_odd_weight_of_5_32 : std_logic := '0';
    signal v1_weight_of_0_32 : std_logic := '0';
    signal v1_weight_of_1_32 : std_logic := '0';
    signal v1_weight_of_2_32 : std_logic := '0';
    signal v1_weight_of_3_32 : std_logic := '0';
    signal v1_weight_of_4_32 : std_logic := '0';
    signal v1_weight_of_5_32 : std_logic := '0';
    signal blend1_signed_32 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_32 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_32 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_32 : std_logic := '0';
    signal square1_g_by_1_32 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_32 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_32 : std_logic := '0';
    signal square1_b_by_1_32 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_32 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_32 : std_logic := '0';
    signal u1_even_next_32 : unsigned(5 downto 0) := (others => '0');
    signal u1_even_even_high_32 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_even_32 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_next_32 : unsigned(5 downto 0) := (others => '0');
    signal u1_odd_even_high_32 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_even_32 : unsigned(4 downto 0) := (others => '0');
    signal in_gain1r_33 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_33 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_33 : unsigned(17 downto 0) := (others => '0');
    signal hidden_33 : std_logic := '0';
    signal v1_is_odd_33 : std_logic := '0';
    signal u1_even_even_33 : unsigned(4 downto 0) := (others => '0');
    signal u1_even_is_odd_33 : std_logic := '0';
    signal u1_odd_even_33 : unsigned(4 downto 0) := (others => '0');
    signal u1_odd_is_odd_33 : std_logic := '0';
    signal texels1_000_33 : unsigned(6 downto 0) := (others => '0');
    signal texel1_001_33 : unsigned(11 downto 0) := (others => '0');
    signal texels1_010_33 : unsigned(6 downto 0) := (others => '0');
    signal texel1_011_33 : unsigned(11 downto 0) := (others => '0');
    signal texels1_100_33 : unsigned(6 downto 0) := (others => '0');
    signal texel1_101_33 : unsigned(11 downto 0) := (others => '0');
    signal texels1_110_33 : unsigned(6 downto 0) := (others => '0');
    signal texel1_111_33 : unsigned(11 downto 0) := (others => '0');
    signal u1_even_weight_of_0_33 : std_logic := '0';
    signal u1_even_weight_of_1_33 : std_logic := '0';
    signal u1_even_weight_of_2_33 : std_logic := '0';
    signal u1_even_weight_of_3_33 : std_logic := '0';
    signal u1_even_weight_of_4_33 : std_logic := '0';
    signal u1_even_weight_of_5_33 : std_logic := '0';
    signal u1_odd_weight_of_0_33 : std_logic := '0';
    signal u1_odd_weight_of_1_33 : std_logic := '0';
    signal u1_odd_weight_of_2_33 : std_logic := '0';
    signal u1_odd_weight_of_3_33 : std_logic := '0';
    signal u1_odd_weight_of_4_33 : std_logic := '0';
    signal u1_odd_weight_of_5_33 : std_logic := '0';
    signal v1_weight_of_0_33 : std_logic := '0';
    signal v1_weight_of_1_33 : std_logic := '0';
    signal v1_weight_of_2_33 : std_logic := '0';
    signal v1_weight_of_3_33 : std_logic := '0';
    signal v1_weight_of_4_33 : std_logic := '0';
    signal v1_weight_of_5_33 : std_logic := '0';
    signal blend1_signed_33 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_33 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_33 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_33 : std_logic := '0';
    signal square1_g_by_1_33 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_33 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_33 : std_logic := '0';
    signal square1_b_by_1_33 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_33 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_33 : std_logic := '0';
    signal texel1_000_33 : unsigned(11 downto 0) := (others => '0');
    signal texel1_010_33 : unsigned(11 downto 0) := (others => '0');
    signal texel1_100_33 : unsigned(11 downto 0) := (others => '0');
    signal texel1_110_33 : unsigned(11 downto 0) := (others => '0');
    signal in_gain1r_34 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_34 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_34 : unsigned(17 downto 0) := (others => '0');
    signal hidden_34 : std_logic := '0';
    signal v1_is_odd_34 : std_logic := '0';
    signal u1_even_is_odd_34 : std_logic := '0';
    signal u1_odd_is_odd_34 : std_logic := '0';
    signal texel1_000_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_001_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_010_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_011_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_100_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_101_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_110_34 : unsigned(11 downto 0) := (others => '0');
    signal texel1_111_34 : unsigned(11 downto 0) := (others => '0');
    signal u1_even_weight_of_0_34 : std_logic := '0';
    signal u1_even_weight_of_1_34 : std_logic := '0';
    signal u1_even_weight_of_2_34 : std_logic := '0';
    signal u1_even_weight_of_3_34 : std_logic := '0';
    signal u1_even_weight_of_4_34 : std_logic := '0';
    signal u1_even_weight_of_5_34 : std_logic := '0';
    signal u1_odd_weight_of_0_34 : std_logic := '0';
    signal u1_odd_weight_of_1_34 : std_logic := '0';
    signal u1_odd_weight_of_2_34 : std_logic := '0';
    signal u1_odd_weight_of_3_34 : std_logic := '0';
    signal u1_odd_weight_of_4_34 : std_logic := '0';
    signal u1_odd_weight_of_5_34 : std_logic := '0';
    signal v1_weight_of_0_34 : std_logic := '0';
    signal v1_weight_of_1_34 : std_logic := '0';
    signal v1_weight_of_2_34 : std_logic := '0';
    signal v1_weight_of_3_34 : std_logic := '0';
    signal v1_weight_of_4_34 : std_logic := '0';
    signal v1_weight_of_5_34 : std_logic := '0';
    signal blend1_signed_34 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_34 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_34 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_34 : std_logic := '0';
    signal square1_g_by_1_34 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_34 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_34 : std_logic := '0';
    signal square1_b_by_1_34 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_34 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_34 : std_logic := '0';
    signal in_gain1r_35 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_35 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_35 : unsigned(17 downto 0) := (others => '0');
    signal hidden_35 : std_logic := '0';
    signal v1_is_odd_35 : std_logic := '0';
    signal u1_even_is_odd_35 : std_logic := '0';
    signal u1_odd_is_odd_35 : std_logic := '0';
    signal u1_even_weight_of_0_35 : std_logic := '0';
    signal u1_even_weight_of_1_35 : std_logic := '0';
    signal u1_even_weight_of_2_35 : std_logic := '0';
    signal u1_even_weight_of_3_35 : std_logic := '0';
    signal u1_even_weight_of_4_35 : std_logic := '0';
    signal u1_even_weight_of_5_35 : std_logic := '0';
    signal u1_odd_weight_of_0_35 : std_logic := '0';
    signal u1_odd_weight_of_1_35 : std_logic := '0';
    signal u1_odd_weight_of_2_35 : std_logic := '0';
    signal u1_odd_weight_of_3_35 : std_logic := '0';
    signal u1_odd_weight_of_4_35 : std_logic := '0';
    signal u1_odd_weight_of_5_35 : std_logic := '0';
    signal v1_weight_of_0_35 : std_logic := '0';
    signal v1_weight_of_1_35 : std_logic := '0';
    signal v1_weight_of_2_35 : std_logic := '0';
    signal v1_weight_of_3_35 : std_logic := '0';
    signal v1_weight_of_4_35 : std_logic := '0';
    signal v1_weight_of_5_35 : std_logic := '0';
    signal blend1_signed_35 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_35 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_35 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_35 : std_logic := '0';
    signal square1_g_by_1_35 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_35 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_35 : std_logic := '0';
    signal square1_b_by_1_35 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_35 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_35 : std_logic := '0';
    signal texels_1_even_even_even_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_even_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_35 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_35 : unsigned(7 downto 0) := (others => '0');
    signal in_gain1r_36 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_36 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_36 : unsigned(17 downto 0) := (others => '0');
    signal hidden_36 : std_logic := '0';
    signal v1_is_odd_36 : std_logic := '0';
    signal u1_even_is_odd_36 : std_logic := '0';
    signal u1_odd_is_odd_36 : std_logic := '0';
    signal texels_1_even_even_even_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_36 : unsigned(7 downto 0) := (others => '0');
    signal u1_even_weight_of_0_36 : std_logic := '0';
    signal u1_even_weight_of_1_36 : std_logic := '0';
    signal u1_even_weight_of_2_36 : std_logic := '0';
    signal u1_even_weight_of_3_36 : std_logic := '0';
    signal u1_even_weight_of_4_36 : std_logic := '0';
    signal u1_even_weight_of_5_36 : std_logic := '0';
    signal u1_odd_weight_of_0_36 : std_logic := '0';
    signal u1_odd_weight_of_1_36 : std_logic := '0';
    signal u1_odd_weight_of_2_36 : std_logic := '0';
    signal u1_odd_weight_of_3_36 : std_logic := '0';
    signal u1_odd_weight_of_4_36 : std_logic := '0';
    signal u1_odd_weight_of_5_36 : std_logic := '0';
    signal v1_weight_of_0_36 : std_logic := '0';
    signal v1_weight_of_1_36 : std_logic := '0';
    signal v1_weight_of_2_36 : std_logic := '0';
    signal v1_weight_of_3_36 : std_logic := '0';
    signal v1_weight_of_4_36 : std_logic := '0';
    signal v1_weight_of_5_36 : std_logic := '0';
    signal blend1_signed_36 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_36 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_36 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_36 : std_logic := '0';
    signal texels_1_even_even_even_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_36 : unsigned(7 downto 0) := (others => '0');
    signal square1_g_by_1_36 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_36 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_36 : std_logic := '0';
    signal texels_1_even_even_even_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_36 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_36 : unsigned(7 downto 0) := (others => '0');
    signal square1_b_by_1_36 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_36 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_36 : std_logic := '0';
    signal in_gain1r_37 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_37 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_37 : unsigned(17 downto 0) := (others => '0');
    signal hidden_37 : std_logic := '0';
    signal v1_is_odd_37 : std_logic := '0';
    signal u1_even_is_odd_37 : std_logic := '0';
    signal u1_odd_is_odd_37 : std_logic := '0';
    signal texels_1_even_even_even_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_r_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_r_37 : unsigned(7 downto 0) := (others => '0');
    signal u1_even_weight_of_0_37 : std_logic := '0';
    signal u1_even_weight_of_1_37 : std_logic := '0';
    signal u1_even_weight_of_2_37 : std_logic := '0';
    signal u1_even_weight_of_3_37 : std_logic := '0';
    signal u1_even_weight_of_4_37 : std_logic := '0';
    signal u1_even_weight_of_5_37 : std_logic := '0';
    signal u1_odd_weight_of_0_37 : std_logic := '0';
    signal u1_odd_weight_of_1_37 : std_logic := '0';
    signal u1_odd_weight_of_2_37 : std_logic := '0';
    signal u1_odd_weight_of_3_37 : std_logic := '0';
    signal u1_odd_weight_of_4_37 : std_logic := '0';
    signal u1_odd_weight_of_5_37 : std_logic := '0';
    signal v1_weight_of_0_37 : std_logic := '0';
    signal v1_weight_of_1_37 : std_logic := '0';
    signal v1_weight_of_2_37 : std_logic := '0';
    signal v1_weight_of_3_37 : std_logic := '0';
    signal v1_weight_of_4_37 : std_logic := '0';
    signal v1_weight_of_5_37 : std_logic := '0';
    signal blend1_signed_37 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_37 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_37 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_37 : std_logic := '0';
    signal texels_1_even_even_even_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_g_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_g_37 : unsigned(7 downto 0) := (others => '0');
    signal square1_g_by_1_37 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_37 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_37 : std_logic := '0';
    signal texels_1_even_even_even_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_even_odd_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_even_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_even_odd_odd_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_even_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_even_odd_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_even_b_37 : unsigned(7 downto 0) := (others => '0');
    signal texels_1_odd_odd_odd_b_37 : unsigned(7 downto 0) := (others => '0');
    signal square1_b_by_1_37 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_37 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_37 : std_logic := '0';
    signal blend1_r_1_0_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_either_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_first_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_0_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_1_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_2_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_3_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_4_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_either_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_by_5_37 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_0_37 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_1_37 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_2_37 : unsigned(9 downto 0) := (others => '0');
    signal in_gain1r_38 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_38 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_38 : unsigned(17 downto 0) := (others => '0');
    signal hidden_38 : std_logic := '0';
    signal v1_is_odd_38 : std_logic := '0';
    signal blend1_r_1_0_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal v1_weight_of_0_38 : std_logic := '0';
    signal v1_weight_of_1_38 : std_logic := '0';
    signal v1_weight_of_2_38 : std_logic := '0';
    signal v1_weight_of_3_38 : std_logic := '0';
    signal v1_weight_of_4_38 : std_logic := '0';
    signal v1_weight_of_5_38 : std_logic := '0';
    signal blend1_signed_38 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_38 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_38 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_38 : std_logic := '0';
    signal blend1_g_1_0_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal square1_g_by_1_38 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_38 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_38 : std_logic := '0';
    signal blend1_b_1_0_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_by_5_38 : unsigned(7 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_0_38 : unsigned(8 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_1_38 : unsigned(9 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_1_2_38 : unsigned(9 downto 0) := (others => '0');
    signal square1_b_by_1_38 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_38 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_38 : std_logic := '0';
    signal blend1_r_1_0_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_0_38 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_1_38 : unsigned(10 downto 0) := (others => '0');
    signal in_gain1r_39 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_39 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_39 : unsigned(17 downto 0) := (others => '0');
    signal hidden_39 : std_logic := '0';
    signal v1_is_odd_39 : std_logic := '0';
    signal blend1_r_1_0_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_0_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_1_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_2_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_r_1_3_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal v1_weight_of_0_39 : std_logic := '0';
    signal v1_weight_of_1_39 : std_logic := '0';
    signal v1_weight_of_2_39 : std_logic := '0';
    signal v1_weight_of_3_39 : std_logic := '0';
    signal v1_weight_of_4_39 : std_logic := '0';
    signal v1_weight_of_5_39 : std_logic := '0';
    signal blend1_signed_39 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_39 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_39 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_39 : std_logic := '0';
    signal blend1_g_1_0_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_0_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_1_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_2_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_g_1_3_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal square1_g_by_1_39 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_39 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_39 : std_logic := '0';
    signal blend1_b_1_0_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_0_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_1_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_2_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_0_39 : unsigned(10 downto 0) := (others => '0');
    signal blend1_b_1_3_sum_2_1_39 : unsigned(10 downto 0) := (others => '0');
    signal square1_b_by_1_39 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_39 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_39 : std_logic := '0';
    signal blend1_r_1_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_1_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_1_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_1_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_first_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_0_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_1_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_2_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_3_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_4_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_either_5_39 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_5_39 : unsigned(13 downto 0) := (others => '0');
    signal in_gain1r_40 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_40 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_40 : unsigned(17 downto 0) := (others => '0');
    signal hidden_40 : std_logic := '0';
    signal blend1_r_2_0_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_signed_40 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_40 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_40 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_40 : std_logic := '0';
    signal blend1_g_2_0_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal square1_g_by_1_40 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_40 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_40 : std_logic := '0';
    signal blend1_b_2_0_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_first_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_0_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_1_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_2_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_3_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_4_40 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_by_5_40 : unsigned(13 downto 0) := (others => '0');
    signal square1_b_by_1_40 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_40 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_40 : std_logic := '0';
    signal blend1_r_2_0_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_0_40 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_1_40 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_2_40 : unsigned(15 downto 0) := (others => '0');
    signal in_gain1r_41 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_41 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_41 : unsigned(17 downto 0) := (others => '0');
    signal hidden_41 : std_logic := '0';
    signal blend1_r_2_0_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_1_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_signed_41 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_41 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_41 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_41 : std_logic := '0';
    signal blend1_g_2_0_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_1_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal square1_g_by_1_41 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_41 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_41 : std_logic := '0';
    signal blend1_b_2_0_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_1_by_5_41 : unsigned(13 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_0_41 : unsigned(14 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_1_41 : unsigned(15 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_1_2_41 : unsigned(15 downto 0) := (others => '0');
    signal square1_b_by_1_41 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_41 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_41 : std_logic := '0';
    signal blend1_r_2_0_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_0_41 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_1_41 : unsigned(16 downto 0) := (others => '0');
    signal in_gain1r_42 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_42 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_42 : unsigned(17 downto 0) := (others => '0');
    signal hidden_42 : std_logic := '0';
    signal blend1_r_2_0_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_0_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_signed_42 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_42 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_42 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_42 : std_logic := '0';
    signal blend1_g_2_0_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_0_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal square1_g_by_1_42 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_42 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_42 : std_logic := '0';
    signal blend1_b_2_0_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_0_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_sum_2_1_42 : unsigned(16 downto 0) := (others => '0');
    signal square1_b_by_1_42 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_42 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_42 : std_logic := '0';
    signal blend1_r_2_0_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_2_1_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_r_2_0_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_0_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_2_1_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_g_2_0_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_0_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_1_42 : unsigned(19 downto 0) := (others => '0');
    signal blend1_b_2_0_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_cut_42 : unsigned(16 downto 0) := (others => '0');
    signal in_gain1r_43 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_43 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_43 : unsigned(17 downto 0) := (others => '0');
    signal hidden_43 : std_logic := '0';
    signal blend1_r_2_0_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_2_1_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal blend1_signed_43 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_43 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_43 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_43 : std_logic := '0';
    signal blend1_g_2_0_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_2_1_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal square1_g_by_1_43 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_43 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_43 : std_logic := '0';
    signal blend1_b_2_0_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_2_1_cut_43 : unsigned(16 downto 0) := (others => '0');
    signal square1_b_by_1_43 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_43 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_43 : std_logic := '0';
    signal blend1_r_3_0_apart_43 : signed(17 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_43 : signed(17 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_43 : signed(17 downto 0) := (others => '0');
    signal in_gain1r_44 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_44 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_44 : unsigned(17 downto 0) := (others => '0');
    signal hidden_44 : std_logic := '0';
    signal blend1_r_2_0_cut_44 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_apart_44 : signed(17 downto 0) := (others => '0');
    signal blend1_signed_44 : signed(7 downto 0) := (others => '0');
    signal square1_r_by_1_44 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_44 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_44 : std_logic := '0';
    signal blend1_g_2_0_cut_44 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_apart_44 : signed(17 downto 0) := (others => '0');
    signal square1_g_by_1_44 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_44 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_44 : std_logic := '0';
    signal blend1_b_2_0_cut_44 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_apart_44 : signed(17 downto 0) := (others => '0');
    signal square1_b_by_1_44 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_44 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_44 : std_logic := '0';
    signal blend1_r_3_0_part_44 : signed(25 downto 0) := (others => '0');
    signal blend1_g_3_0_part_44 : signed(25 downto 0) := (others => '0');
    signal blend1_b_3_0_part_44 : signed(25 downto 0) := (others => '0');
    signal in_gain1r_45 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_45 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_45 : unsigned(17 downto 0) := (others => '0');
    signal hidden_45 : std_logic := '0';
    signal blend1_r_2_0_cut_45 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_part_45 : signed(25 downto 0) := (others => '0');
    signal square1_r_by_1_45 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_45 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_45 : std_logic := '0';
    signal blend1_g_2_0_cut_45 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_part_45 : signed(25 downto 0) := (others => '0');
    signal square1_g_by_1_45 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_45 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_45 : std_logic := '0';
    signal blend1_b_2_0_cut_45 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_part_45 : signed(25 downto 0) := (others => '0');
    signal square1_b_by_1_45 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_45 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_45 : std_logic := '0';
    signal in_gain1r_46 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_46 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_46 : unsigned(17 downto 0) := (others => '0');
    signal hidden_46 : std_logic := '0';
    signal blend1_r_2_0_cut_46 : unsigned(16 downto 0) := (others => '0');
    signal blend1_r_3_0_part_46 : signed(25 downto 0) := (others => '0');
    signal square1_r_by_1_46 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_46 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_46 : std_logic := '0';
    signal blend1_g_2_0_cut_46 : unsigned(16 downto 0) := (others => '0');
    signal blend1_g_3_0_part_46 : signed(25 downto 0) := (others => '0');
    signal square1_g_by_1_46 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_46 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_46 : std_logic := '0';
    signal blend1_b_2_0_cut_46 : unsigned(16 downto 0) := (others => '0');
    signal blend1_b_3_0_part_46 : signed(25 downto 0) := (others => '0');
    signal square1_b_by_1_46 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_46 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_46 : std_logic := '0';
    signal blend1_r_3_0_46 : unsigned(22 downto 0) := (others => '0');
    signal root1_r_46 : unsigned(17 downto 0) := (others => '0');
    signal blend1_g_3_0_46 : unsigned(22 downto 0) := (others => '0');
    signal root1_g_46 : unsigned(17 downto 0) := (others => '0');
    signal blend1_b_3_0_46 : unsigned(22 downto 0) := (others => '0');
    signal root1_b_46 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_47 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_47 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_47 : unsigned(17 downto 0) := (others => '0');
    signal hidden_47 : std_logic := '0';
    signal root1_r_47 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_by_1_47 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_47 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_47 : std_logic := '0';
    signal root1_g_47 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_by_1_47 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_47 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_47 : std_logic := '0';
    signal root1_b_47 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_by_1_47 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_47 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_47 : std_logic := '0';
    signal square1_r_exact_47 : unsigned(35 downto 0) := (others => '0');
    signal square1_r_47 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_exact_47 : unsigned(35 downto 0) := (others => '0');
    signal square1_g_47 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_exact_47 : unsigned(35 downto 0) := (others => '0');
    signal square1_b_47 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_48 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_48 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_48 : unsigned(17 downto 0) := (others => '0');
    signal hidden_48 : std_logic := '0';
    signal square1_r_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_by_1_48 : unsigned(0 downto 0) := (others => '0');
    signal square1_r_amount_2_48 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_48 : std_logic := '0';
    signal square1_g_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_by_1_48 : unsigned(0 downto 0) := (others => '0');
    signal square1_g_amount_2_48 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_48 : std_logic := '0';
    signal square1_b_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_by_1_48 : unsigned(0 downto 0) := (others => '0');
    signal square1_b_amount_2_48 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_48 : std_logic := '0';
    signal square1_r_seen_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_up_1_48 : unsigned(18 downto 0) := (others => '0');
    signal square1_r_all_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_all_wide_48 : unsigned(21 downto 0) := (others => '0');
    signal square1_g_seen_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_up_1_48 : unsigned(18 downto 0) := (others => '0');
    signal square1_g_all_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_all_wide_48 : unsigned(21 downto 0) := (others => '0');
    signal square1_b_seen_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_up_1_48 : unsigned(18 downto 0) := (others => '0');
    signal square1_b_all_48 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_all_wide_48 : unsigned(21 downto 0) := (others => '0');
    signal in_gain1r_49 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_49 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_up_1_49 : unsigned(18 downto 0) := (others => '0');
    signal square1_r_amount_2_49 : unsigned(1 downto 0) := (others => '0');
    signal square1_r_by_4_49 : std_logic := '0';
    signal square1_r_all_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_g_up_1_49 : unsigned(18 downto 0) := (others => '0');
    signal square1_g_amount_2_49 : unsigned(1 downto 0) := (others => '0');
    signal square1_g_by_4_49 : std_logic := '0';
    signal square1_g_all_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_b_up_1_49 : unsigned(18 downto 0) := (others => '0');
    signal square1_b_amount_2_49 : unsigned(1 downto 0) := (others => '0');
    signal square1_b_by_4_49 : std_logic := '0';
    signal square1_b_all_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_r_up_2_49 : unsigned(20 downto 0) := (others => '0');
    signal square1_r_up_2_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_r_up_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_r_up_cut_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_within_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_up_2_49 : unsigned(20 downto 0) := (others => '0');
    signal square1_g_up_2_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_g_up_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_g_up_cut_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_within_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_up_2_49 : unsigned(20 downto 0) := (others => '0');
    signal square1_b_up_2_wide_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_b_up_49 : unsigned(21 downto 0) := (others => '0');
    signal square1_b_up_cut_49 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_within_49 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1r_50 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1g_50 : unsigned(17 downto 0) := (others => '0');
    signal in_gain1b_50 : unsigned(17 downto 0) := (others => '0');
    signal square1_r_within_50 : unsigned(17 downto 0) := (others => '0');
    signal square1_g_within_50 : unsigned(17 downto 0) := (others => '0');
    signal square1_b_within_50 : unsigned(17 downto 0) := (others => '0');
    signal light1_r_exact_50 : unsigned(35 downto 0) := (others => '0');
    signal light1_r_50 : unsigned(21 downto 0) := (others => '0');
    signal light1_g_exact_50 : unsigned(35 downto 0) := (others => '0');
    signal light1_g_50 : unsigned(21 downto 0) := (others => '0');
    signal light1_b_exact_50 : unsigned(35 downto 0) := (others => '0');
    signal light1_b_50 : unsigned(21 downto 0) := (others => '0');
    signal light1_r_51 : unsigned(21 downto 0) := (others => '0');
    signal light1_g_51 : unsigned(21 downto 0) := (others => '0');
    signal light1_b_51 : unsigned(21 downto 0) := (others => '0');
    signal sum_r_51 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_51 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_51 : unsigned(17 downto 0) := (others => '0');
    signal sum_r_52 : unsigned(17 downto 0) := (others => '0');
    signal sum_g_52 : unsigned(17 downto 0) := (others => '0');
    signal sum_b_52 : unsigned(17 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(51 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: nz_kept, shift1, blend1, band1_kept, v1_x_exact and 10 more
    -- UQ1.16: n.v, not below 0
    nz_kept_0 <= (others => '0') when in_nz(17) = '1' else
        unsigned(in_nz(16 downto 0));
    -- UQ1.0: n.v > 0
    seen_0 <= '1' when nz_kept_0 /= 0 else '0';
    -- UQ1.0: the normal is turned away from the viewer
    hidden_0 <= not seen_0;
    -- UQ3.0: at most the greatest
    shift1_0 <= (2 => '1', others => '0') when in_shift1(2) = '1' else
        in_shift1;
    -- UQ1.6: the weight of the odd band, at most 1
    blend1_0 <= (6 => '1', others => '0') when in_blend1(6) = '1' else
        in_blend1;
    -- UQ3.0: at most the last
    band1_kept_0 <= to_unsigned(5, 3) when in_band1 > 5 else
        in_band1;
    -- UQ3.-1: its leading bits
    band1_odd_high_0 <= band1_kept_0(2 downto 1);
    -- UQ2.0: the odd one of both
    band1_odd_0 <= band1_odd_high_0;
    -- Q3.32: the turned normal
    v1_x_exact_0 <= in_nx * in_v1x;
    -- Q3.14: rounded down
    v1_x_0 <= v1_x_exact_0(35 downto 18);
    -- Q3.32: the turned normal
    v1_y_exact_0 <= in_ny * in_v1y;
    -- Q3.14: rounded down
    v1_y_0 <= v1_y_exact_0(35 downto 18);
    -- Q3.32: x, turned back
    x1_x_exact_0 <= in_nx * in_v1y;
    -- Q3.14: rounded down
    x1_x_0 <= x1_x_exact_0(35 downto 18);
    -- Q3.32: x, turned back
    x1_y_exact_0 <= in_ny * in_v1x;
    -- Q3.14: rounded down
    x1_y_0 <= x1_y_exact_0(35 downto 18);
    -- Q3.32: the turned normal
    u1_x_exact_0 <= in_nx * in_u1x;
    -- Q3.14: rounded down
    u1_x_0 <= u1_x_exact_0(35 downto 18);
    -- Q3.32: the turned normal
    u1_y_exact_0 <= in_ny * in_u1y;
    -- Q3.14: rounded down
    u1_y_0 <= u1_y_exact_0(35 downto 18);
    -- Q3.32: the turned normal
    u1_z_exact_0 <= in_nz * in_u1z;
    -- Q3.14: rounded down
    u1_z_0 <= u1_z_exact_0(35 downto 18);
    -- UQ1.0: whether one image is alone
    alone1_0 <= '1' when in_alone1 /= 0 else '0';
    -- UQ1.0: whether it turns to negative x
    back1_even_0 <= '1' when to_signed(0, 15) > in_turn1_even else '0';
    -- UQ6.6: the end of the row on that side
    end1_even_0 <= to_unsigned(0, 12) when back1_even_0 = '1' else to_unsigned(4032, 12);
    -- UQ1.0: whether it turns to negative x
    back1_odd_0 <= '1' when to_signed(0, 15) > in_turn1_odd else '0';
    -- UQ6.6: the end of the row on that side
    end1_odd_0 <= to_unsigned(0, 12) when back1_odd_0 = '1' else to_unsigned(4032, 12);
    -- UQ7.-5: the first of them
    texels1_10_0 <= band1_odd_0;
    -- UQ7.-5: the first of them
    texels1_10_v2_0 <= band1_odd_0;
    -- UQ7.-5: the first of them
    texels1_11_0 <= band1_odd_0;
    -- UQ7.-5: the first of them
    texels1_11_v2_0 <= band1_odd_0;
    -- Q1.6: a sign bit for the signed product
    blend1_signed_0 <= signed(resize(blend1_0, 8));
    -- UQ1.0: a bit of the shift
    square1_r_by_1_0 <= shift1_0(0 downto 0);
    -- UQ2.-1: a bit of the shift
    square1_r_by_2_0 <= shift1_0(1 downto 1);
    -- UQ2.0: its weight
    square1_r_amount_2_0 <= shift_left(resize(square1_r_by_2_0, 2), 1);
    -- UQ3.-2: a bit of the shift
    square1_r_by_4_0 <= shift1_0(2);
    -- UQ1.0: a bit of the shift
    square1_g_by_1_0 <= shift1_0(0 downto 0);
    -- UQ2.-1: a bit of the shift
    square1_g_by_2_0 <= shift1_0(1 downto 1);
    -- UQ2.0: its weight
    square1_g_amount_2_0 <= shift_left(resize(square1_g_by_2_0, 2), 1);
    -- UQ3.-2: a bit of the shift
    square1_g_by_4_0 <= shift1_0(2);
    -- UQ1.0: a bit of the shift
    square1_b_by_1_0 <= shift1_0(0 downto 0);
    -- UQ2.-1: a bit of the shift
    square1_b_by_2_0 <= shift1_0(1 downto 1);
    -- UQ2.0: its weight
    square1_b_amount_2_0 <= shift_left(resize(square1_b_by_2_0, 2), 1);
    -- UQ3.-2: a bit of the shift
    square1_b_by_4_0 <= shift1_0(2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_1 <= in_nz;
                in_turn1_even_1 <= in_turn1_even;
                in_turn1_odd_1 <= in_turn1_odd;
                in_gain1r_1 <= in_gain1r;
                in_gain1g_1 <= in_gain1g;
                in_gain1b_1 <= in_gain1b;
                hidden_1 <= hidden_0;
                band1_kept_1 <= band1_kept_0;
                v1_x_1 <= v1_x_0;
                v1_y_1 <= v1_y_0;
                x1_x_1 <= x1_x_0;
                x1_y_1 <= x1_y_0;
                u1_x_1 <= u1_x_0;
                u1_y_1 <= u1_y_0;
                u1_z_1 <= u1_z_0;
                alone1_1 <= alone1_0;
                end1_even_1 <= end1_even_0;
                end1_odd_1 <= end1_odd_0;
                texels1_10_1 <= texels1_10_0;
                texels1_10_v2_1 <= texels1_10_v2_0;
                texels1_11_1 <= texels1_11_0;
                texels1_11_v2_1 <= texels1_11_v2_0;
                blend1_signed_1 <= blend1_signed_0;
                square1_r_by_1_1 <= square1_r_by_1_0;
                square1_r_amount_2_1 <= square1_r_amount_2_0;
                square1_r_by_4_1 <= square1_r_by_4_0;
                square1_g_by_1_1 <= square1_g_by_1_0;
                square1_g_amount_2_1 <= square1_g_amount_2_0;
                square1_g_by_4_1 <= square1_g_by_4_0;
                square1_b_by_1_1 <= square1_b_by_1_0;
                square1_b_amount_2_1 <= square1_b_amount_2_0;
                square1_b_by_4_1 <= square1_b_by_4_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: band1_next_exact, v1_xy, x1_exact, u1_xy
    -- UQ3.0: the next
    band1_next_exact_1 <= band1_kept_1 + to_unsigned(1, 3);
    -- Q4.14: the turned normal
    v1_xy_1 <= resize(v1_x_1, 19) + resize(v1_y_1, 19);
    -- Q9.9: in texels from the middle
    v1_scaled_1 <= v1_xy_1;
    -- Q4.14: the component across y of the normal, turned back
    x1_exact_1 <= resize(x1_x_1, 19) - resize(x1_y_1, 19);
    -- Q4.14: the turned normal
    u1_xy_1 <= resize(u1_x_1, 19) + resize(u1_y_1, 19);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_2 <= in_nz_1;
                in_turn1_even_2 <= in_turn1_even_1;
                in_turn1_odd_2 <= in_turn1_odd_1;
                in_gain1r_2 <= in_gain1r_1;
                in_gain1g_2 <= in_gain1g_1;
                in_gain1b_2 <= in_gain1b_1;
                hidden_2 <= hidden_1;
                band1_next_exact_2 <= band1_next_exact_1;
                v1_xy_2 <= v1_xy_1;
                v1_scaled_2 <= v1_scaled_1;
                x1_exact_2 <= x1_exact_1;
                u1_z_2 <= u1_z_1;
                u1_xy_2 <= u1_xy_1;
                alone1_2 <= alone1_1;
                end1_even_2 <= end1_even_1;
                end1_odd_2 <= end1_odd_1;
                texels1_10_2 <= texels1_10_1;
                texels1_10_v2_2 <= texels1_10_v2_1;
                texels1_11_2 <= texels1_11_1;
                texels1_11_v2_2 <= texels1_11_v2_1;
                blend1_signed_2 <= blend1_signed_1;
                square1_r_by_1_2 <= square1_r_by_1_1;
                square1_r_amount_2_2 <= square1_r_amount_2_1;
                square1_r_by_4_2 <= square1_r_by_4_1;
                square1_g_by_1_2 <= square1_g_by_1_1;
                square1_g_amount_2_2 <= square1_g_amount_2_1;
                square1_g_by_4_2 <= square1_g_by_4_1;
                square1_b_by_1_2 <= square1_b_by_1_1;
                square1_b_amount_2_2 <= square1_b_amount_2_1;
                square1_b_by_4_2 <= square1_b_by_4_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: band1_next, v1_place, x1, u1_xyz, v1_unit
    -- UQ3.0: at most the last
    band1_next_2 <= to_unsigned(5, 3) when band1_next_exact_2 > 5 else
        band1_next_exact_2;
    -- UQ3.-1: its leading bits
    band1_even_high_2 <= band1_next_2(2 downto 1);
    -- UQ2.0: the even one of both
    band1_even_2 <= band1_even_high_2;
    -- Q9.9: from the first, plus half a weight's last bit
    v1_place_2 <= v1_scaled_2 + to_signed(16132, 19);
    -- Q9.6: rounded to the nearest weight
    v1_cut_2 <= v1_place_2(18 downto 3);
    -- Q1.14: of a unit vector it is at most 1
    x1_2 <= to_signed(-16384, 16) when x1_exact_2(18 downto 14) < -1 else
        to_signed(16384, 16) when x1_exact_2(18 downto 14) > 0 else
        x1_exact_2(15 downto 0);
    -- Q4.14: the turned normal
    u1_xyz_2 <= u1_xy_2 + resize(u1_z_2, 19);
    -- Q1.14: y of a unit vector
    v1_unit_2 <= to_signed(-16384, 16) when v1_xy_2(18 downto 14) < -1 else
        to_signed(16384, 16) when v1_xy_2(18 downto 14) > 0 else
        v1_xy_2(15 downto 0);
    -- UQ7.-5: the first of them
    texels1_00_2 <= band1_even_2;
    -- UQ7.-5: the first of them
    texels1_00_v2_2 <= band1_even_2;
    -- UQ7.-5: the first of them
    texels1_01_2 <= band1_even_2;
    -- UQ7.-5: the first of them
    texels1_01_v2_2 <= band1_even_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_3 <= in_nz_2;
                in_turn1_even_3 <= in_turn1_even_2;
                in_turn1_odd_3 <= in_turn1_odd_2;
                in_gain1r_3 <= in_gain1r_2;
                in_gain1g_3 <= in_gain1g_2;
                in_gain1b_3 <= in_gain1b_2;
                hidden_3 <= hidden_2;
                v1_cut_3 <= v1_cut_2;
                x1_3 <= x1_2;
                u1_xyz_3 <= u1_xyz_2;
                v1_unit_3 <= v1_unit_2;
                alone1_3 <= alone1_2;
                end1_even_3 <= end1_even_2;
                end1_odd_3 <= end1_odd_2;
                texels1_00_3 <= texels1_00_2;
                texels1_00_v2_3 <= texels1_00_v2_2;
                texels1_01_3 <= texels1_01_2;
                texels1_01_v2_3 <= texels1_01_v2_2;
                texels1_10_3 <= texels1_10_2;
                texels1_10_v2_3 <= texels1_10_v2_2;
                texels1_11_3 <= texels1_11_2;
                texels1_11_v2_3 <= texels1_11_v2_2;
                blend1_signed_3 <= blend1_signed_2;
                square1_r_by_1_3 <= square1_r_by_1_2;
                square1_r_amount_2_3 <= square1_r_amount_2_2;
                square1_r_by_4_3 <= square1_r_by_4_2;
                square1_g_by_1_3 <= square1_g_by_1_2;
                square1_g_amount_2_3 <= square1_g_amount_2_2;
                square1_g_by_4_3 <= square1_g_by_4_2;
                square1_b_by_1_3 <= square1_b_by_1_2;
                square1_b_amount_2_3 <= square1_b_amount_2_2;
                square1_b_by_4_3 <= square1_b_by_4_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: v1_kept, u1_below, u1_minus, u1_either, v1_square and 6 more
    -- UQ6.6: between the outermost centres
    v1_kept_3 <= (others => '0') when v1_cut_3(15) = '1' else
        to_unsigned(4032, 12) when v1_cut_3 > 4032 else
        unsigned(v1_cut_3(11 downto 0));
    -- UQ6.0: the texel at or below it
    v1_texel_3 <= v1_kept_3(11 downto 6);
    -- UQ0.6: the weight of the next
    v1_weight_3 <= v1_kept_3(5 downto 0);
    -- UQ6.-1: its leading bits
    v1_odd_high_3 <= v1_texel_3(5 downto 1);
    -- UQ5.0: the odd one of both
    v1_odd_3 <= v1_odd_high_3;
    -- UQ1.0: its last bit
    v1_is_odd_3 <= v1_texel_3(0);
    -- UQ1.0: whether it is below 0
    u1_below_3 <= '1' when to_signed(0, 19) > u1_xyz_3 else '0';
    -- Q4.14: its opposite
    u1_minus_3 <= to_signed(0, 19) - u1_xyz_3;
    -- Q4.14: on either side of h
    u1_either_3 <= u1_minus_3 when u1_below_3 = '1' else u1_xyz_3;
    -- Q3.28: y^2
    v1_square_3 <= v1_unit_3 * v1_unit_3;
    -- UQ-5.6: a bit of the weight
    v1_weight_bit_0_3 <= v1_weight_3(0 downto 0);
    -- UQ-4.5: a bit of the weight
    v1_weight_bit_1_3 <= v1_weight_3(1 downto 1);
    -- UQ-3.4: a bit of the weight
    v1_weight_bit_2_3 <= v1_weight_3(2 downto 2);
    -- UQ-2.3: a bit of the weight
    v1_weight_bit_3_3 <= v1_weight_3(3 downto 3);
    -- UQ-1.2: a bit of the weight
    v1_weight_bit_4_3 <= v1_weight_3(4 downto 4);
    -- UQ0.1: a bit of the weight
    v1_weight_bit_5_3 <= v1_weight_3(5 downto 5);
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
    -- UQ1.0: as a flag
    v1_weight_of_5_flag_3 <= v1_weight_bit_5_3(0);
    -- UQ1.0: it is 0
    v1_weight_of_5_not_3 <= not v1_weight_of_5_flag_3;
    -- UQ1.0: whether it counts for the odd one
    v1_weight_of_5_3 <= v1_weight_of_5_not_3 when v1_is_odd_3 = '1' else v1_weight_of_5_flag_3;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_4 <= in_nz_3;
                in_turn1_even_4 <= in_turn1_even_3;
                in_turn1_odd_4 <= in_turn1_odd_3;
                in_gain1r_4 <= in_gain1r_3;
                in_gain1g_4 <= in_gain1g_3;
                in_gain1b_4 <= in_gain1b_3;
                hidden_4 <= hidden_3;
                v1_texel_4 <= v1_texel_3;
                v1_odd_4 <= v1_odd_3;
                v1_is_odd_4 <= v1_is_odd_3;
                x1_4 <= x1_3;
                u1_either_4 <= u1_either_3;
                v1_square_4 <= v1_square_3;
                alone1_4 <= alone1_3;
                end1_even_4 <= end1_even_3;
                end1_odd_4 <= end1_odd_3;
                texels1_00_4 <= texels1_00_3;
                texels1_00_v2_4 <= texels1_00_v2_3;
                texels1_01_4 <= texels1_01_3;
                texels1_01_v2_4 <= texels1_01_v2_3;
                texels1_10_4 <= texels1_10_3;
                texels1_10_v2_4 <= texels1_10_v2_3;
                texels1_11_4 <= texels1_11_3;
                texels1_11_v2_4 <= texels1_11_v2_3;
                v1_weight_of_0_4 <= v1_weight_of_0_3;
                v1_weight_of_1_4 <= v1_weight_of_1_3;
                v1_weight_of_2_4 <= v1_weight_of_2_3;
                v1_weight_of_3_4 <= v1_weight_of_3_3;
                v1_weight_of_4_4 <= v1_weight_of_4_3;
                v1_weight_of_5_4 <= v1_weight_of_5_3;
                blend1_signed_4 <= blend1_signed_3;
                square1_r_by_1_4 <= square1_r_by_1_3;
                square1_r_amount_2_4 <= square1_r_amount_2_3;
                square1_r_by_4_4 <= square1_r_by_4_3;
                square1_g_by_1_4 <= square1_g_by_1_3;
                square1_g_amount_2_4 <= square1_g_amount_2_3;
                square1_g_by_4_4 <= square1_g_by_4_3;
                square1_b_by_1_4 <= square1_b_by_1_3;
                square1_b_amount_2_4 <= square1_b_amount_2_3;
                square1_b_by_4_4 <= square1_b_by_4_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: v1_next_exact, u1_kept, rr1_exact, texel1_01, texel1_01 and 2 more
    -- UQ7.0: the next
    v1_next_exact_4 <= resize(v1_texel_4, 7) + to_unsigned(1, 7);
    -- UQ1.14: of a unit vector it is at most 1
    u1_kept_4 <= (others => '0') when u1_either_4(18) = '1' else
        (14 => '1', others => '0') when unsigned(u1_either_4(17 downto 14)) /= 0 else
        unsigned(u1_either_4(14 downto 0));
    -- UQ2.28: r^2 = 1 - y^2
    rr1_exact_4 <= to_unsigned(268435456, 30) - unsigned(v1_square_4(29 downto 0));
    -- UQ2.16: rounded down
    rr1_cut_4 <= rr1_exact_4(29 downto 12);
    -- Q1.14: a sign bit for the signed product
    u1_kept_signed_4 <= signed(resize(u1_kept_4, 16));
    -- UQ7.0: side by side
    texel1_01_4 <= shift_left(resize(texels1_01_4, 7), 5) + resize(v1_odd_4, 7);
    -- UQ12.-5: the first of them
    texels1_010_4 <= texel1_01_4;
    -- UQ7.0: side by side
    texel1_01_v2_4 <= shift_left(resize(texels1_01_v2_4, 7), 5) + resize(v1_odd_4, 7);
    -- UQ12.-5: the first of them
    texels1_011_4 <= texel1_01_v2_4;
    -- UQ7.0: side by side
    texel1_11_4 <= shift_left(resize(texels1_11_4, 7), 5) + resize(v1_odd_4, 7);
    -- UQ12.-5: the first of them
    texels1_110_4 <= texel1_11_4;
    -- UQ7.0: side by side
    texel1_11_v2_4 <= shift_left(resize(texels1_11_v2_4, 7), 5) + resize(v1_odd_4, 7);
    -- UQ12.-5: the first of them
    texels1_111_4 <= texel1_11_v2_4;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_5 <= in_nz_4;
                in_turn1_even_5 <= in_turn1_even_4;
                in_turn1_odd_5 <= in_turn1_odd_4;
                in_gain1r_5 <= in_gain1r_4;
                in_gain1g_5 <= in_gain1g_4;
                in_gain1b_5 <= in_gain1b_4;
                hidden_5 <= hidden_4;
                v1_next_exact_5 <= v1_next_exact_4;
                v1_is_odd_5 <= v1_is_odd_4;
                x1_5 <= x1_4;
                rr1_cut_5 <= rr1_cut_4;
                u1_kept_signed_5 <= u1_kept_signed_4;
                alone1_5 <= alone1_4;
                end1_even_5 <= end1_even_4;
                end1_odd_5 <= end1_odd_4;
                texels1_00_5 <= texels1_00_4;
                texels1_00_v2_5 <= texels1_00_v2_4;
                texels1_010_5 <= texels1_010_4;
                texels1_011_5 <= texels1_011_4;
                texels1_10_5 <= texels1_10_4;
                texels1_10_v2_5 <= texels1_10_v2_4;
                texels1_110_5 <= texels1_110_4;
                texels1_111_5 <= texels1_111_4;
                v1_weight_of_0_5 <= v1_weight_of_0_4;
                v1_weight_of_1_5 <= v1_weight_of_1_4;
                v1_weight_of_2_5 <= v1_weight_of_2_4;
                v1_weight_of_3_5 <= v1_weight_of_3_4;
                v1_weight_of_4_5 <= v1_weight_of_4_4;
                v1_weight_of_5_5 <= v1_weight_of_5_4;
                blend1_signed_5 <= blend1_signed_4;
                square1_r_by_1_5 <= square1_r_by_1_4;
                square1_r_amount_2_5 <= square1_r_amount_2_4;
                square1_r_by_4_5 <= square1_r_by_4_4;
                square1_g_by_1_5 <= square1_g_by_1_4;
                square1_g_amount_2_5 <= square1_g_amount_2_4;
                square1_g_by_4_5 <= square1_g_by_4_4;
                square1_b_by_1_5 <= square1_b_by_1_4;
                square1_b_amount_2_5 <= square1_b_amount_2_4;
                square1_b_by_4_5 <= square1_b_by_4_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: v1_next, rr1, rr1_4, rr1_2, rr1_1
    -- UQ6.0: at most the last
    v1_next_5 <= to_unsigned(63, 6) when v1_next_exact_5(6) = '1' else
        v1_next_exact_5(5 downto 0);
    -- UQ6.-1: its leading bits
    v1_even_high_5 <= v1_next_5(5 downto 1);
    -- UQ5.0: the even one of both
    v1_even_5 <= v1_even_high_5;
    -- UQ0.16: r^2, below 1
    rr1_5 <= to_unsigned(65535, 16) when unsigned(rr1_cut_5(17 downto 16)) /= 0 else
        rr1_cut_5(15 downto 0);
    -- UQ0.4: the first 4 bits of rr
    high1_4_bits_5 <= rr1_5(15 downto 12);
    -- UQ1.0: the first 4 bits of rr
    high1_4_5 <= '1' when high1_4_bits_5 /= 0 else '0';
    -- UQ-4.16: without them
    rr_low1_4_5 <= rr1_5(11 downto 0);
    -- UQ0.12: rr 2^4
    rr_up1_4_5 <= rr_low1_4_5;
    -- UQ0.16: in the wider of two formats
    rr_up1_4_wide_5 <= shift_left(resize(rr_up1_4_5, 16), 4);
    -- UQ0.16: rr, times 2^4 if it is so small
    rr1_4_5 <= rr1_5 when high1_4_5 = '1' else rr_up1_4_wide_5;
    -- UQ3.-2: a bit of the exponent
    place1_4_5 <= unsigned'("" & high1_4_5);
    -- UQ0.2: the first 2 bits of rr
    high1_2_bits_5 <= rr1_4_5(15 downto 14);
    -- UQ1.0: the first 2 bits of rr
    high1_2_5 <= '1' when high1_2_bits_5 /= 0 else '0';
    -- UQ-2.16: without them
    rr_low1_2_5 <= rr1_4_5(13 downto 0);
    -- UQ0.14: rr 2^2
    rr_up1_2_5 <= rr_low1_2_5;
    -- UQ0.16: in the wider of two formats
    rr_up1_2_wide_5 <= shift_left(resize(rr_up1_2_5, 16), 2);
    -- UQ0.16: rr, times 2^2 if it is so small
    rr1_2_5 <= rr1_4_5 when high1_2_5 = '1' else rr_up1_2_wide_5;
    -- UQ2.-1: a bit of the exponent
    place1_2_5 <= unsigned'("" & high1_2_5);
    -- UQ0.1: the first 1 bits of rr
    high1_1_bits_5 <= rr1_2_5(15);
    -- UQ-1.16: without them
    rr_low1_1_5 <= rr1_2_5(14 downto 0);
    -- UQ0.15: rr 2^1
    rr_up1_1_5 <= rr_low1_1_5;
    -- UQ0.16: in the wider of two formats
    rr_up1_1_wide_5 <= shift_left(resize(rr_up1_1_5, 16), 1);
    -- UQ0.16: rr, times 2^1 if it is so small
    rr1_1_5 <= rr1_2_5 when high1_1_bits_5 = '1' else rr_up1_1_wide_5;
    -- UQ1.0: a bit of the exponent
    place1_1_5 <= unsigned'("" & high1_1_bits_5);
    -- UQ1.0: the exponent is not 0
    normal1_of_2_5 <= high1_4_5 or high1_2_5;
    -- UQ1.0: the exponent is not 0
    normal1_5 <= normal1_of_2_5 or high1_1_bits_5;
    -- UQ1.15: 2 rr
    rr1_twice_5 <= rr1_1_5;
    -- UQ0.15: 2 rr - 1
    rr1_rest_5 <= rr1_twice_5(14 downto 0);
    -- UQ0.16: in the wider of two formats
    rr1_rest_wide_5 <= shift_left(resize(rr1_rest_5, 16), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_6 <= in_nz_5;
                in_turn1_even_6 <= in_turn1_even_5;
                in_turn1_odd_6 <= in_turn1_odd_5;
                in_gain1r_6 <= in_gain1r_5;
                in_gain1g_6 <= in_gain1g_5;
                in_gain1b_6 <= in_gain1b_5;
                hidden_6 <= hidden_5;
                v1_even_6 <= v1_even_5;
                v1_is_odd_6 <= v1_is_odd_5;
                x1_6 <= x1_5;
                place1_4_6 <= place1_4_5;
                place1_2_6 <= place1_2_5;
                rr1_1_6 <= rr1_1_5;
                place1_1_6 <= place1_1_5;
                normal1_6 <= normal1_5;
                rr1_rest_wide_6 <= rr1_rest_wide_5;
                u1_kept_signed_6 <= u1_kept_signed_5;
                alone1_6 <= alone1_5;
                end1_even_6 <= end1_even_5;
                end1_odd_6 <= end1_odd_5;
                texels1_00_6 <= texels1_00_5;
                texels1_00_v2_6 <= texels1_00_v2_5;
                texels1_010_6 <= texels1_010_5;
                texels1_011_6 <= texels1_011_5;
                texels1_10_6 <= texels1_10_5;
                texels1_10_v2_6 <= texels1_10_v2_5;
                texels1_110_6 <= texels1_110_5;
                texels1_111_6 <= texels1_111_5;
                v1_weight_of_0_6 <= v1_weight_of_0_5;
                v1_weight_of_1_6 <= v1_weight_of_1_5;
                v1_weight_of_2_6 <= v1_weight_of_2_5;
                v1_weight_of_3_6 <= v1_weight_of_3_5;
                v1_weight_of_4_6 <= v1_weight_of_4_5;
                v1_weight_of_5_6 <= v1_weight_of_5_5;
                blend1_signed_6 <= blend1_signed_5;
                square1_r_by_1_6 <= square1_r_by_1_5;
                square1_r_amount_2_6 <= square1_r_amount_2_5;
                square1_r_by_4_6 <= square1_r_by_4_5;
                square1_g_by_1_6 <= square1_g_by_1_5;
                square1_g_amount_2_6 <= square1_g_amount_2_5;
                square1_g_by_4_6 <= square1_g_by_4_5;
                square1_b_by_1_6 <= square1_b_by_1_5;
                square1_b_amount_2_6 <= square1_b_amount_2_5;
                square1_b_by_4_6 <= square1_b_by_4_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: exponent1_2, rest1, texel1_00, texel1_00, texel1_10 and 1 more
    -- UQ3.-1: the exponent's bits so far
    exponent1_2_6 <= shift_left(resize(place1_4_6, 2), 1) + resize(place1_2_6, 2);
    -- UQ0.16: the place in the octave
    rest1_6 <= rr1_rest_wide_6 when normal1_6 = '1' else rr1_1_6;
    -- UQ0.9: rounded down to the weights' last bit
    rest1_cut_6 <= rest1_6(15 downto 7);
    -- UQ0.4: the column in the octave
    step1_6 <= rest1_cut_6(8 downto 5);
    -- UQ4.0: its number
    step1_number_6 <= step1_6;
    -- UQ-4.9: rr past it
    part1_6 <= rest1_cut_6(4 downto 0);
    -- UQ0.5: the weight of the next column
    weight1_6 <= part1_6;
    -- UQ7.0: side by side
    texel1_00_6 <= shift_left(resize(texels1_00_6, 7), 5) + resize(v1_even_6, 7);
    -- UQ12.-5: the first of them
    texels1_000_6 <= texel1_00_6;
    -- UQ7.0: side by side
    texel1_00_v2_6 <= shift_left(resize(texels1_00_v2_6, 7), 5) + resize(v1_even_6, 7);
    -- UQ12.-5: the first of them
    texels1_001_6 <= texel1_00_v2_6;
    -- UQ7.0: side by side
    texel1_10_6 <= shift_left(resize(texels1_10_6, 7), 5) + resize(v1_even_6, 7);
    -- UQ12.-5: the first of them
    texels1_100_6 <= texel1_10_6;
    -- UQ7.0: side by side
    texel1_10_v2_6 <= shift_left(resize(texels1_10_v2_6, 7), 5) + resize(v1_even_6, 7);
    -- UQ12.-5: the first of them
    texels1_101_6 <= texel1_10_v2_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_7 <= in_nz_6;
                in_turn1_even_7 <= in_turn1_even_6;
                in_turn1_odd_7 <= in_turn1_odd_6;
                in_gain1r_7 <= in_gain1r_6;
                in_gain1g_7 <= in_gain1g_6;
                in_gain1b_7 <= in_gain1b_6;
                hidden_7 <= hidden_6;
                v1_is_odd_7 <= v1_is_odd_6;
                x1_7 <= x1_6;
                exponent1_2_7 <= exponent1_2_6;
                place1_1_7 <= place1_1_6;
                step1_number_7 <= step1_number_6;
                weight1_7 <= weight1_6;
                u1_kept_signed_7 <= u1_kept_signed_6;
                alone1_7 <= alone1_6;
                end1_even_7 <= end1_even_6;
                end1_odd_7 <= end1_odd_6;
                texels1_000_7 <= texels1_000_6;
                texels1_001_7 <= texels1_001_6;
                texels1_010_7 <= texels1_010_6;
                texels1_011_7 <= texels1_011_6;
                texels1_100_7 <= texels1_100_6;
                texels1_101_7 <= texels1_101_6;
                texels1_110_7 <= texels1_110_6;
                texels1_111_7 <= texels1_111_6;
                v1_weight_of_0_7 <= v1_weight_of_0_6;
                v1_weight_of_1_7 <= v1_weight_of_1_6;
                v1_weight_of_2_7 <= v1_weight_of_2_6;
                v1_weight_of_3_7 <= v1_weight_of_3_6;
                v1_weight_of_4_7 <= v1_weight_of_4_6;
                v1_weight_of_5_7 <= v1_weight_of_5_6;
                blend1_signed_7 <= blend1_signed_6;
                square1_r_by_1_7 <= square1_r_by_1_6;
                square1_r_amount_2_7 <= square1_r_amount_2_6;
                square1_r_by_4_7 <= square1_r_by_4_6;
                square1_g_by_1_7 <= square1_g_by_1_6;
                square1_g_amount_2_7 <= square1_g_amount_2_6;
                square1_g_by_4_7 <= square1_g_by_4_6;
                square1_b_by_1_7 <= square1_b_by_1_6;
                square1_b_amount_2_7 <= square1_b_amount_2_6;
                square1_b_by_4_7 <= square1_b_by_4_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: exponent1_1
    -- UQ3.0: the exponent's bits so far
    exponent1_1_7 <= shift_left(resize(exponent1_2_7, 3), 1) + resize(place1_1_7, 3);
    -- UQ7.-4: the octave's first column
    octave1_7 <= exponent1_1_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_8 <= in_nz_7;
                in_turn1_even_8 <= in_turn1_even_7;
                in_turn1_odd_8 <= in_turn1_odd_7;
                in_gain1r_8 <= in_gain1r_7;
                in_gain1g_8 <= in_gain1g_7;
                in_gain1b_8 <= in_gain1b_7;
                hidden_8 <= hidden_7;
                v1_is_odd_8 <= v1_is_odd_7;
                x1_8 <= x1_7;
                step1_number_8 <= step1_number_7;
                octave1_8 <= octave1_7;
                weight1_8 <= weight1_7;
                u1_kept_signed_8 <= u1_kept_signed_7;
                alone1_8 <= alone1_7;
                end1_even_8 <= end1_even_7;
                end1_odd_8 <= end1_odd_7;
                texels1_000_8 <= texels1_000_7;
                texels1_001_8 <= texels1_001_7;
                texels1_010_8 <= texels1_010_7;
                texels1_011_8 <= texels1_011_7;
                texels1_100_8 <= texels1_100_7;
                texels1_101_8 <= texels1_101_7;
                texels1_110_8 <= texels1_110_7;
                texels1_111_8 <= texels1_111_7;
                v1_weight_of_0_8 <= v1_weight_of_0_7;
                v1_weight_of_1_8 <= v1_weight_of_1_7;
                v1_weight_of_2_8 <= v1_weight_of_2_7;
                v1_weight_of_3_8 <= v1_weight_of_3_7;
                v1_weight_of_4_8 <= v1_weight_of_4_7;
                v1_weight_of_5_8 <= v1_weight_of_5_7;
                blend1_signed_8 <= blend1_signed_7;
                square1_r_by_1_8 <= square1_r_by_1_7;
                square1_r_amount_2_8 <= square1_r_amount_2_7;
                square1_r_by_4_8 <= square1_r_by_4_7;
                square1_g_by_1_8 <= square1_g_by_1_7;
                square1_g_amount_2_8 <= square1_g_amount_2_7;
                square1_g_by_4_8 <= square1_g_by_4_7;
                square1_b_by_1_8 <= square1_b_by_1_7;
                square1_b_amount_2_8 <= square1_b_amount_2_7;
                square1_b_by_4_8 <= square1_b_by_4_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: column1
    -- UQ7.0: the column at or below rr
    column1_8 <= shift_left(resize(octave1_8, 7), 4) + resize(step1_number_8, 7);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_9 <= in_nz_8;
                in_turn1_even_9 <= in_turn1_even_8;
                in_turn1_odd_9 <= in_turn1_odd_8;
                in_gain1r_9 <= in_gain1r_8;
                in_gain1g_9 <= in_gain1g_8;
                in_gain1b_9 <= in_gain1b_8;
                hidden_9 <= hidden_8;
                v1_is_odd_9 <= v1_is_odd_8;
                x1_9 <= x1_8;
                column1_9 <= column1_8;
                weight1_9 <= weight1_8;
                u1_kept_signed_9 <= u1_kept_signed_8;
                alone1_9 <= alone1_8;
                end1_even_9 <= end1_even_8;
                end1_odd_9 <= end1_odd_8;
                texels1_000_9 <= texels1_000_8;
                texels1_001_9 <= texels1_001_8;
                texels1_010_9 <= texels1_010_8;
                texels1_011_9 <= texels1_011_8;
                texels1_100_9 <= texels1_100_8;
                texels1_101_9 <= texels1_101_8;
                texels1_110_9 <= texels1_110_8;
                texels1_111_9 <= texels1_111_8;
                v1_weight_of_0_9 <= v1_weight_of_0_8;
                v1_weight_of_1_9 <= v1_weight_of_1_8;
                v1_weight_of_2_9 <= v1_weight_of_2_8;
                v1_weight_of_3_9 <= v1_weight_of_3_8;
                v1_weight_of_4_9 <= v1_weight_of_4_8;
                v1_weight_of_5_9 <= v1_weight_of_5_8;
                blend1_signed_9 <= blend1_signed_8;
                square1_r_by_1_9 <= square1_r_by_1_8;
                square1_r_amount_2_9 <= square1_r_amount_2_8;
                square1_r_by_4_9 <= square1_r_by_4_8;
                square1_g_by_1_9 <= square1_g_by_1_8;
                square1_g_amount_2_9 <= square1_g_amount_2_8;
                square1_g_by_4_9 <= square1_g_by_4_8;
                square1_b_by_1_9 <= square1_b_by_1_8;
                square1_b_amount_2_9 <= square1_b_amount_2_8;
                square1_b_by_4_9 <= square1_b_by_4_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: read roots_1
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                roots_1_10 <= ROOTS_1(to_integer(column1_9));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_10 <= in_nz_9;
                in_turn1_even_10 <= in_turn1_even_9;
                in_turn1_odd_10 <= in_turn1_odd_9;
                in_gain1r_10 <= in_gain1r_9;
                in_gain1g_10 <= in_gain1g_9;
                in_gain1b_10 <= in_gain1b_9;
                hidden_10 <= hidden_9;
                v1_is_odd_10 <= v1_is_odd_9;
                x1_10 <= x1_9;
                weight1_10 <= weight1_9;
                u1_kept_signed_10 <= u1_kept_signed_9;
                alone1_10 <= alone1_9;
                end1_even_10 <= end1_even_9;
                end1_odd_10 <= end1_odd_9;
                texels1_000_10 <= texels1_000_9;
                texels1_001_10 <= texels1_001_9;
                texels1_010_10 <= texels1_010_9;
                texels1_011_10 <= texels1_011_9;
                texels1_100_10 <= texels1_100_9;
                texels1_101_10 <= texels1_101_9;
                texels1_110_10 <= texels1_110_9;
                texels1_111_10 <= texels1_111_9;
                v1_weight_of_0_10 <= v1_weight_of_0_9;
                v1_weight_of_1_10 <= v1_weight_of_1_9;
                v1_weight_of_2_10 <= v1_weight_of_2_9;
                v1_weight_of_3_10 <= v1_weight_of_3_9;
                v1_weight_of_4_10 <= v1_weight_of_4_9;
                v1_weight_of_5_10 <= v1_weight_of_5_9;
                blend1_signed_10 <= blend1_signed_9;
                square1_r_by_1_10 <= square1_r_by_1_9;
                square1_r_amount_2_10 <= square1_r_amount_2_9;
                square1_r_by_4_10 <= square1_r_by_4_9;
                square1_g_by_1_10 <= square1_g_by_1_9;
                square1_g_amount_2_10 <= square1_g_amount_2_9;
                square1_g_by_4_10 <= square1_g_by_4_9;
                square1_b_by_1_10 <= square1_b_by_1_9;
                square1_b_amount_2_10 <= square1_b_amount_2_9;
                square1_b_by_4_10 <= square1_b_by_4_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: registers only
    -- UQ6.10: 1/sqrt(1 - y^2)
    root_1_10 <= unsigned(roots_1_10(30 downto 15));
    -- UQ5.10: what it falls by to the next row
    fall_1_10 <= unsigned(roots_1_10(14 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_11 <= in_nz_10;
                in_turn1_even_11 <= in_turn1_even_10;
                in_turn1_odd_11 <= in_turn1_odd_10;
                in_gain1r_11 <= in_gain1r_10;
                in_gain1g_11 <= in_gain1g_10;
                in_gain1b_11 <= in_gain1b_10;
                hidden_11 <= hidden_10;
                v1_is_odd_11 <= v1_is_odd_10;
                x1_11 <= x1_10;
                weight1_11 <= weight1_10;
                root_1_11 <= root_1_10;
                fall_1_11 <= fall_1_10;
                u1_kept_signed_11 <= u1_kept_signed_10;
                alone1_11 <= alone1_10;
                end1_even_11 <= end1_even_10;
                end1_odd_11 <= end1_odd_10;
                texels1_000_11 <= texels1_000_10;
                texels1_001_11 <= texels1_001_10;
                texels1_010_11 <= texels1_010_10;
                texels1_011_11 <= texels1_011_10;
                texels1_100_11 <= texels1_100_10;
                texels1_101_11 <= texels1_101_10;
                texels1_110_11 <= texels1_110_10;
                texels1_111_11 <= texels1_111_10;
                v1_weight_of_0_11 <= v1_weight_of_0_10;
                v1_weight_of_1_11 <= v1_weight_of_1_10;
                v1_weight_of_2_11 <= v1_weight_of_2_10;
                v1_weight_of_3_11 <= v1_weight_of_3_10;
                v1_weight_of_4_11 <= v1_weight_of_4_10;
                v1_weight_of_5_11 <= v1_weight_of_5_10;
                blend1_signed_11 <= blend1_signed_10;
                square1_r_by_1_11 <= square1_r_by_1_10;
                square1_r_amount_2_11 <= square1_r_amount_2_10;
                square1_r_by_4_11 <= square1_r_by_4_10;
                square1_g_by_1_11 <= square1_g_by_1_10;
                square1_g_amount_2_11 <= square1_g_amount_2_10;
                square1_g_by_4_11 <= square1_g_by_4_10;
                square1_b_by_1_11 <= square1_b_by_1_10;
                square1_b_amount_2_11 <= square1_b_amount_2_10;
                square1_b_by_4_11 <= square1_b_by_4_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_12 <= in_nz_11;
                in_turn1_even_12 <= in_turn1_even_11;
                in_turn1_odd_12 <= in_turn1_odd_11;
                in_gain1r_12 <= in_gain1r_11;
                in_gain1g_12 <= in_gain1g_11;
                in_gain1b_12 <= in_gain1b_11;
                hidden_12 <= hidden_11;
                v1_is_odd_12 <= v1_is_odd_11;
                x1_12 <= x1_11;
                weight1_12 <= weight1_11;
                root_1_12 <= root_1_11;
                fall_1_12 <= fall_1_11;
                u1_kept_signed_12 <= u1_kept_signed_11;
                alone1_12 <= alone1_11;
                end1_even_12 <= end1_even_11;
                end1_odd_12 <= end1_odd_11;
                texels1_000_12 <= texels1_000_11;
                texels1_001_12 <= texels1_001_11;
                texels1_010_12 <= texels1_010_11;
                texels1_011_12 <= texels1_011_11;
                texels1_100_12 <= texels1_100_11;
                texels1_101_12 <= texels1_101_11;
                texels1_110_12 <= texels1_110_11;
                texels1_111_12 <= texels1_111_11;
                v1_weight_of_0_12 <= v1_weight_of_0_11;
                v1_weight_of_1_12 <= v1_weight_of_1_11;
                v1_weight_of_2_12 <= v1_weight_of_2_11;
                v1_weight_of_3_12 <= v1_weight_of_3_11;
                v1_weight_of_4_12 <= v1_weight_of_4_11;
                v1_weight_of_5_12 <= v1_weight_of_5_11;
                blend1_signed_12 <= blend1_signed_11;
                square1_r_by_1_12 <= square1_r_by_1_11;
                square1_r_amount_2_12 <= square1_r_amount_2_11;
                square1_r_by_4_12 <= square1_r_by_4_11;
                square1_g_by_1_12 <= square1_g_by_1_11;
                square1_g_amount_2_12 <= square1_g_amount_2_11;
                square1_g_by_4_12 <= square1_g_by_4_11;
                square1_b_by_1_12 <= square1_b_by_1_11;
                square1_b_amount_2_12 <= square1_b_amount_2_11;
                square1_b_by_4_12 <= square1_b_by_4_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: fall_part1
    -- UQ5.15: its part
    fall_part1_12 <= fall_1_12 * weight1_12;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_13 <= in_nz_12;
                in_turn1_even_13 <= in_turn1_even_12;
                in_turn1_odd_13 <= in_turn1_odd_12;
                in_gain1r_13 <= in_gain1r_12;
                in_gain1g_13 <= in_gain1g_12;
                in_gain1b_13 <= in_gain1b_12;
                hidden_13 <= hidden_12;
                v1_is_odd_13 <= v1_is_odd_12;
                x1_13 <= x1_12;
                root_1_13 <= root_1_12;
                fall_part1_13 <= fall_part1_12;
                u1_kept_signed_13 <= u1_kept_signed_12;
                alone1_13 <= alone1_12;
                end1_even_13 <= end1_even_12;
                end1_odd_13 <= end1_odd_12;
                texels1_000_13 <= texels1_000_12;
                texels1_001_13 <= texels1_001_12;
                texels1_010_13 <= texels1_010_12;
                texels1_011_13 <= texels1_011_12;
                texels1_100_13 <= texels1_100_12;
                texels1_101_13 <= texels1_101_12;
                texels1_110_13 <= texels1_110_12;
                texels1_111_13 <= texels1_111_12;
                v1_weight_of_0_13 <= v1_weight_of_0_12;
                v1_weight_of_1_13 <= v1_weight_of_1_12;
                v1_weight_of_2_13 <= v1_weight_of_2_12;
                v1_weight_of_3_13 <= v1_weight_of_3_12;
                v1_weight_of_4_13 <= v1_weight_of_4_12;
                v1_weight_of_5_13 <= v1_weight_of_5_12;
                blend1_signed_13 <= blend1_signed_12;
                square1_r_by_1_13 <= square1_r_by_1_12;
                square1_r_amount_2_13 <= square1_r_amount_2_12;
                square1_r_by_4_13 <= square1_r_by_4_12;
                square1_g_by_1_13 <= square1_g_by_1_12;
                square1_g_amount_2_13 <= square1_g_amount_2_12;
                square1_g_by_4_13 <= square1_g_by_4_12;
                square1_b_by_1_13 <= square1_b_by_1_12;
                square1_b_amount_2_13 <= square1_b_amount_2_12;
                square1_b_by_4_13 <= square1_b_by_4_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_14 <= in_nz_13;
                in_turn1_even_14 <= in_turn1_even_13;
                in_turn1_odd_14 <= in_turn1_odd_13;
                in_gain1r_14 <= in_gain1r_13;
                in_gain1g_14 <= in_gain1g_13;
                in_gain1b_14 <= in_gain1b_13;
                hidden_14 <= hidden_13;
                v1_is_odd_14 <= v1_is_odd_13;
                x1_14 <= x1_13;
                root_1_14 <= root_1_13;
                fall_part1_14 <= fall_part1_13;
                u1_kept_signed_14 <= u1_kept_signed_13;
                alone1_14 <= alone1_13;
                end1_even_14 <= end1_even_13;
                end1_odd_14 <= end1_odd_13;
                texels1_000_14 <= texels1_000_13;
                texels1_001_14 <= texels1_001_13;
                texels1_010_14 <= texels1_010_13;
                texels1_011_14 <= texels1_011_13;
                texels1_100_14 <= texels1_100_13;
                texels1_101_14 <= texels1_101_13;
                texels1_110_14 <= texels1_110_13;
                texels1_111_14 <= texels1_111_13;
                v1_weight_of_0_14 <= v1_weight_of_0_13;
                v1_weight_of_1_14 <= v1_weight_of_1_13;
                v1_weight_of_2_14 <= v1_weight_of_2_13;
                v1_weight_of_3_14 <= v1_weight_of_3_13;
                v1_weight_of_4_14 <= v1_weight_of_4_13;
                v1_weight_of_5_14 <= v1_weight_of_5_13;
                blend1_signed_14 <= blend1_signed_13;
                square1_r_by_1_14 <= square1_r_by_1_13;
                square1_r_amount_2_14 <= square1_r_amount_2_13;
                square1_r_by_4_14 <= square1_r_by_4_13;
                square1_g_by_1_14 <= square1_g_by_1_13;
                square1_g_amount_2_14 <= square1_g_amount_2_13;
                square1_g_by_4_14 <= square1_g_by_4_13;
                square1_b_by_1_14 <= square1_b_by_1_13;
                square1_b_amount_2_14 <= square1_b_amount_2_13;
                square1_b_by_4_14 <= square1_b_by_4_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: root_at1
    -- Q6.15: 1/r
    root_at1_14 <= shift_left(signed(resize(root_1_14, 22)), 5) - signed(resize(fall_part1_14, 22));
    -- Q6.10: rounded down
    root_cut1_14 <= root_at1_14(21 downto 5);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_15 <= in_nz_14;
                in_turn1_even_15 <= in_turn1_even_14;
                in_turn1_odd_15 <= in_turn1_odd_14;
                in_gain1r_15 <= in_gain1r_14;
                in_gain1g_15 <= in_gain1g_14;
                in_gain1b_15 <= in_gain1b_14;
                hidden_15 <= hidden_14;
                v1_is_odd_15 <= v1_is_odd_14;
                x1_15 <= x1_14;
                root_cut1_15 <= root_cut1_14;
                u1_kept_signed_15 <= u1_kept_signed_14;
                alone1_15 <= alone1_14;
                end1_even_15 <= end1_even_14;
                end1_odd_15 <= end1_odd_14;
                texels1_000_15 <= texels1_000_14;
                texels1_001_15 <= texels1_001_14;
                texels1_010_15 <= texels1_010_14;
                texels1_011_15 <= texels1_011_14;
                texels1_100_15 <= texels1_100_14;
                texels1_101_15 <= texels1_101_14;
                texels1_110_15 <= texels1_110_14;
                texels1_111_15 <= texels1_111_14;
                v1_weight_of_0_15 <= v1_weight_of_0_14;
                v1_weight_of_1_15 <= v1_weight_of_1_14;
                v1_weight_of_2_15 <= v1_weight_of_2_14;
                v1_weight_of_3_15 <= v1_weight_of_3_14;
                v1_weight_of_4_15 <= v1_weight_of_4_14;
                v1_weight_of_5_15 <= v1_weight_of_5_14;
                blend1_signed_15 <= blend1_signed_14;
                square1_r_by_1_15 <= square1_r_by_1_14;
                square1_r_amount_2_15 <= square1_r_amount_2_14;
                square1_r_by_4_15 <= square1_r_by_4_14;
                square1_g_by_1_15 <= square1_g_by_1_14;
                square1_g_amount_2_15 <= square1_g_amount_2_14;
                square1_g_by_4_15 <= square1_g_by_4_14;
                square1_b_by_1_15 <= square1_b_by_1_14;
                square1_b_amount_2_15 <= square1_b_amount_2_14;
                square1_b_by_4_15 <= square1_b_by_4_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: tilt1_exact
    -- Q8.24: the sine of the angle to h
    tilt1_exact_15 <= u1_kept_signed_15 * root_cut1_15;
    -- Q6.12: rounded down
    tilt1_cut_15 <= tilt1_exact_15(30 downto 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_16 <= in_nz_15;
                in_turn1_even_16 <= in_turn1_even_15;
                in_turn1_odd_16 <= in_turn1_odd_15;
                in_gain1r_16 <= in_gain1r_15;
                in_gain1g_16 <= in_gain1g_15;
                in_gain1b_16 <= in_gain1b_15;
                hidden_16 <= hidden_15;
                v1_is_odd_16 <= v1_is_odd_15;
                x1_16 <= x1_15;
                tilt1_cut_16 <= tilt1_cut_15;
                alone1_16 <= alone1_15;
                end1_even_16 <= end1_even_15;
                end1_odd_16 <= end1_odd_15;
                texels1_000_16 <= texels1_000_15;
                texels1_001_16 <= texels1_001_15;
                texels1_010_16 <= texels1_010_15;
                texels1_011_16 <= texels1_011_15;
                texels1_100_16 <= texels1_100_15;
                texels1_101_16 <= texels1_101_15;
                texels1_110_16 <= texels1_110_15;
                texels1_111_16 <= texels1_111_15;
                v1_weight_of_0_16 <= v1_weight_of_0_15;
                v1_weight_of_1_16 <= v1_weight_of_1_15;
                v1_weight_of_2_16 <= v1_weight_of_2_15;
                v1_weight_of_3_16 <= v1_weight_of_3_15;
                v1_weight_of_4_16 <= v1_weight_of_4_15;
                v1_weight_of_5_16 <= v1_weight_of_5_15;
                blend1_signed_16 <= blend1_signed_15;
                square1_r_by_1_16 <= square1_r_by_1_15;
                square1_r_amount_2_16 <= square1_r_amount_2_15;
                square1_r_by_4_16 <= square1_r_by_4_15;
                square1_g_by_1_16 <= square1_g_by_1_15;
                square1_g_amount_2_16 <= square1_g_amount_2_15;
                square1_g_by_4_16 <= square1_g_by_4_15;
                square1_b_by_1_16 <= square1_b_by_1_15;
                square1_b_amount_2_16 <= square1_b_amount_2_15;
                square1_b_by_4_16 <= square1_b_by_4_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: tilt1_kept, tilt1
    -- UQ1.12: at most 1
    tilt1_kept_16 <= (others => '0') when tilt1_cut_16(18) = '1' else
        (12 => '1', others => '0') when unsigned(tilt1_cut_16(17 downto 12)) /= 0 else
        unsigned(tilt1_cut_16(12 downto 0));
    -- UQ1.12: the sine of the angle to h; 1/2, which makes k = 3/4, where one image is alone
    tilt1_16 <= to_unsigned(2048, 13) when alone1_16 = '1' else tilt1_kept_16;
    -- Q1.12: a sign bit for the signed product
    tilt1_signed_16 <= signed(resize(tilt1_16, 14));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_17 <= in_nz_16;
                in_turn1_even_17 <= in_turn1_even_16;
                in_turn1_odd_17 <= in_turn1_odd_16;
                in_gain1r_17 <= in_gain1r_16;
                in_gain1g_17 <= in_gain1g_16;
                in_gain1b_17 <= in_gain1b_16;
                hidden_17 <= hidden_16;
                v1_is_odd_17 <= v1_is_odd_16;
                x1_17 <= x1_16;
                tilt1_signed_17 <= tilt1_signed_16;
                end1_even_17 <= end1_even_16;
                end1_odd_17 <= end1_odd_16;
                texels1_000_17 <= texels1_000_16;
                texels1_001_17 <= texels1_001_16;
                texels1_010_17 <= texels1_010_16;
                texels1_011_17 <= texels1_011_16;
                texels1_100_17 <= texels1_100_16;
                texels1_101_17 <= texels1_101_16;
                texels1_110_17 <= texels1_110_16;
                texels1_111_17 <= texels1_111_16;
                v1_weight_of_0_17 <= v1_weight_of_0_16;
                v1_weight_of_1_17 <= v1_weight_of_1_16;
                v1_weight_of_2_17 <= v1_weight_of_2_16;
                v1_weight_of_3_17 <= v1_weight_of_3_16;
                v1_weight_of_4_17 <= v1_weight_of_4_16;
                v1_weight_of_5_17 <= v1_weight_of_5_16;
                blend1_signed_17 <= blend1_signed_16;
                square1_r_by_1_17 <= square1_r_by_1_16;
                square1_r_amount_2_17 <= square1_r_amount_2_16;
                square1_r_by_4_17 <= square1_r_by_4_16;
                square1_g_by_1_17 <= square1_g_by_1_16;
                square1_g_amount_2_17 <= square1_g_amount_2_16;
                square1_g_by_4_17 <= square1_g_by_4_16;
                square1_b_by_1_17 <= square1_b_by_1_16;
                square1_b_amount_2_17 <= square1_b_amount_2_16;
                square1_b_by_4_17 <= square1_b_by_4_16;
            end if;
        end if;
    end process;

    -- ===== Stage 17: turn_more_exact1_even, turn_more_exact1_odd
    -- Q2.26: its part by the tilt
    turn_more_exact1_even_17 <= in_turn1_even_17 * tilt1_signed_17;
    -- Q0.14: rounded down
    turn_more1_even_17 <= turn_more_exact1_even_17(26 downto 12);
    -- Q2.26: its part by the tilt
    turn_more_exact1_odd_17 <= in_turn1_odd_17 * tilt1_signed_17;
    -- Q0.14: rounded down
    turn_more1_odd_17 <= turn_more_exact1_odd_17(26 downto 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_18 <= in_nz_17;
                in_turn1_even_18 <= in_turn1_even_17;
                in_turn1_odd_18 <= in_turn1_odd_17;
                in_gain1r_18 <= in_gain1r_17;
                in_gain1g_18 <= in_gain1g_17;
                in_gain1b_18 <= in_gain1b_17;
                hidden_18 <= hidden_17;
                v1_is_odd_18 <= v1_is_odd_17;
                x1_18 <= x1_17;
                turn_more1_even_18 <= turn_more1_even_17;
                end1_even_18 <= end1_even_17;
                turn_more1_odd_18 <= turn_more1_odd_17;
                end1_odd_18 <= end1_odd_17;
                texels1_000_18 <= texels1_000_17;
                texels1_001_18 <= texels1_001_17;
                texels1_010_18 <= texels1_010_17;
                texels1_011_18 <= texels1_011_17;
                texels1_100_18 <= texels1_100_17;
                texels1_101_18 <= texels1_101_17;
                texels1_110_18 <= texels1_110_17;
                texels1_111_18 <= texels1_111_17;
                v1_weight_of_0_18 <= v1_weight_of_0_17;
                v1_weight_of_1_18 <= v1_weight_of_1_17;
                v1_weight_of_2_18 <= v1_weight_of_2_17;
                v1_weight_of_3_18 <= v1_weight_of_3_17;
                v1_weight_of_4_18 <= v1_weight_of_4_17;
                v1_weight_of_5_18 <= v1_weight_of_5_17;
                blend1_signed_18 <= blend1_signed_17;
                square1_r_by_1_18 <= square1_r_by_1_17;
                square1_r_amount_2_18 <= square1_r_amount_2_17;
                square1_r_by_4_18 <= square1_r_by_4_17;
                square1_g_by_1_18 <= square1_g_by_1_17;
                square1_g_amount_2_18 <= square1_g_amount_2_17;
                square1_g_by_4_18 <= square1_g_by_4_17;
                square1_b_by_1_18 <= square1_b_by_1_17;
                square1_b_amount_2_18 <= square1_b_amount_2_17;
                square1_b_by_4_18 <= square1_b_by_4_17;
            end if;
        end if;
    end process;

    -- ===== Stage 18: turn_exact1_even, turn_exact1_odd
    -- Q1.14: the turn k (phi_i - phi), in right angles
    turn_exact1_even_18 <= resize(in_turn1_even_18, 16) + resize(turn_more1_even_18, 16);
    -- Q1.14: the turn k (phi_i - phi), in right angles
    turn_exact1_odd_18 <= resize(in_turn1_odd_18, 16) + resize(turn_more1_odd_18, 16);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_19 <= in_nz_18;
                in_gain1r_19 <= in_gain1r_18;
                in_gain1g_19 <= in_gain1g_18;
                in_gain1b_19 <= in_gain1b_18;
                hidden_19 <= hidden_18;
                v1_is_odd_19 <= v1_is_odd_18;
                x1_19 <= x1_18;
                turn_exact1_even_19 <= turn_exact1_even_18;
                end1_even_19 <= end1_even_18;
                turn_exact1_odd_19 <= turn_exact1_odd_18;
                end1_odd_19 <= end1_odd_18;
                texels1_000_19 <= texels1_000_18;
                texels1_001_19 <= texels1_001_18;
                texels1_010_19 <= texels1_010_18;
                texels1_011_19 <= texels1_011_18;
                texels1_100_19 <= texels1_100_18;
                texels1_101_19 <= texels1_101_18;
                texels1_110_19 <= texels1_110_18;
                texels1_111_19 <= texels1_111_18;
                v1_weight_of_0_19 <= v1_weight_of_0_18;
                v1_weight_of_1_19 <= v1_weight_of_1_18;
                v1_weight_of_2_19 <= v1_weight_of_2_18;
                v1_weight_of_3_19 <= v1_weight_of_3_18;
                v1_weight_of_4_19 <= v1_weight_of_4_18;
                v1_weight_of_5_19 <= v1_weight_of_5_18;
                blend1_signed_19 <= blend1_signed_18;
                square1_r_by_1_19 <= square1_r_by_1_18;
                square1_r_amount_2_19 <= square1_r_amount_2_18;
                square1_r_by_4_19 <= square1_r_by_4_18;
                square1_g_by_1_19 <= square1_g_by_1_18;
                square1_g_amount_2_19 <= square1_g_amount_2_18;
                square1_g_by_4_19 <= square1_g_by_4_18;
                square1_b_by_1_19 <= square1_b_by_1_18;
                square1_b_amount_2_19 <= square1_b_amount_2_18;
                square1_b_by_4_19 <= square1_b_by_4_18;
            end if;
        end if;
    end process;

    -- ===== Stage 19: turn1_even, turn1_odd
    -- Q0.14: less than a right angle
    turn1_even_19 <= to_signed(-16384, 15) when turn_exact1_even_19(15 downto 14) < -1 else
        to_signed(16383, 15) when turn_exact1_even_19(15 downto 14) > 0 else
        turn_exact1_even_19(14 downto 0);
    -- Q0.14: less than a right angle
    turn1_odd_19 <= to_signed(-16384, 15) when turn_exact1_odd_19(15 downto 14) < -1 else
        to_signed(16383, 15) when turn_exact1_odd_19(15 downto 14) > 0 else
        turn_exact1_odd_19(14 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_20 <= in_nz_19;
                in_gain1r_20 <= in_gain1r_19;
                in_gain1g_20 <= in_gain1g_19;
                in_gain1b_20 <= in_gain1b_19;
                hidden_20 <= hidden_19;
                v1_is_odd_20 <= v1_is_odd_19;
                x1_20 <= x1_19;
                turn1_even_20 <= turn1_even_19;
                end1_even_20 <= end1_even_19;
                turn1_odd_20 <= turn1_odd_19;
                end1_odd_20 <= end1_odd_19;
                texels1_000_20 <= texels1_000_19;
                texels1_001_20 <= texels1_001_19;
                texels1_010_20 <= texels1_010_19;
                texels1_011_20 <= texels1_011_19;
                texels1_100_20 <= texels1_100_19;
                texels1_101_20 <= texels1_101_19;
                texels1_110_20 <= texels1_110_19;
                texels1_111_20 <= texels1_111_19;
                v1_weight_of_0_20 <= v1_weight_of_0_19;
                v1_weight_of_1_20 <= v1_weight_of_1_19;
                v1_weight_of_2_20 <= v1_weight_of_2_19;
                v1_weight_of_3_20 <= v1_weight_of_3_19;
                v1_weight_of_4_20 <= v1_weight_of_4_19;
                v1_weight_of_5_20 <= v1_weight_of_5_19;
                blend1_signed_20 <= blend1_signed_19;
                square1_r_by_1_20 <= square1_r_by_1_19;
                square1_r_amount_2_20 <= square1_r_amount_2_19;
                square1_r_by_4_20 <= square1_r_by_4_19;
                square1_g_by_1_20 <= square1_g_by_1_19;
                square1_g_amount_2_20 <= square1_g_amount_2_19;
                square1_g_by_4_20 <= square1_g_by_4_19;
                square1_b_by_1_20 <= square1_b_by_1_19;
                square1_b_amount_2_20 <= square1_b_amount_2_19;
                square1_b_by_4_20 <= square1_b_by_4_19;
            end if;
        end if;
    end process;

    -- ===== Stage 20: turn_up1_even, turn_up1_odd
    -- UQ1.14: from minus a right angle
    turn_up1_even_20 <= unsigned(turn1_even_20) + to_unsigned(16384, 15);
    -- UQ1.6: the table's row
    step1_even_20 <= turn_up1_even_20(14 downto 8);
    -- UQ7.0: its number
    step_number1_even_20 <= step1_even_20;
    -- UQ-6.14: the angle past it
    past1_even_20 <= turn_up1_even_20(7 downto 0);
    -- UQ0.8: as a part of the way to the next
    past_part1_even_20 <= past1_even_20;
    -- Q0.8: a sign bit for the signed product
    past_part1_even_signed_20 <= signed(resize(past_part1_even_20, 9));
    -- UQ1.14: from minus a right angle
    turn_up1_odd_20 <= unsigned(turn1_odd_20) + to_unsigned(16384, 15);
    -- UQ1.6: the table's row
    step1_odd_20 <= turn_up1_odd_20(14 downto 8);
    -- UQ7.0: its number
    step_number1_odd_20 <= step1_odd_20;
    -- UQ-6.14: the angle past it
    past1_odd_20 <= turn_up1_odd_20(7 downto 0);
    -- UQ0.8: as a part of the way to the next
    past_part1_odd_20 <= past1_odd_20;
    -- Q0.8: a sign bit for the signed product
    past_part1_odd_signed_20 <= signed(resize(past_part1_odd_20, 9));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_21 <= in_nz_20;
                in_gain1r_21 <= in_gain1r_20;
                in_gain1g_21 <= in_gain1g_20;
                in_gain1b_21 <= in_gain1b_20;
                hidden_21 <= hidden_20;
                v1_is_odd_21 <= v1_is_odd_20;
                x1_21 <= x1_20;
                step_number1_even_21 <= step_number1_even_20;
                past_part1_even_21 <= past_part1_even_20;
                past_part1_even_signed_21 <= past_part1_even_signed_20;
                end1_even_21 <= end1_even_20;
                step_number1_odd_21 <= step_number1_odd_20;
                past_part1_odd_21 <= past_part1_odd_20;
                past_part1_odd_signed_21 <= past_part1_odd_signed_20;
                end1_odd_21 <= end1_odd_20;
                texels1_000_21 <= texels1_000_20;
                texels1_001_21 <= texels1_001_20;
                texels1_010_21 <= texels1_010_20;
                texels1_011_21 <= texels1_011_20;
                texels1_100_21 <= texels1_100_20;
                texels1_101_21 <= texels1_101_20;
                texels1_110_21 <= texels1_110_20;
                texels1_111_21 <= texels1_111_20;
                v1_weight_of_0_21 <= v1_weight_of_0_20;
                v1_weight_of_1_21 <= v1_weight_of_1_20;
                v1_weight_of_2_21 <= v1_weight_of_2_20;
                v1_weight_of_3_21 <= v1_weight_of_3_20;
                v1_weight_of_4_21 <= v1_weight_of_4_20;
                v1_weight_of_5_21 <= v1_weight_of_5_20;
                blend1_signed_21 <= blend1_signed_20;
                square1_r_by_1_21 <= square1_r_by_1_20;
                square1_r_amount_2_21 <= square1_r_amount_2_20;
                square1_r_by_4_21 <= square1_r_by_4_20;
                square1_g_by_1_21 <= square1_g_by_1_20;
                square1_g_amount_2_21 <= square1_g_amount_2_20;
                square1_g_by_4_21 <= square1_g_by_4_20;
                square1_b_by_1_21 <= square1_b_by_1_20;
                square1_b_amount_2_21 <= square1_b_amount_2_20;
                square1_b_by_4_21 <= square1_b_by_4_20;
            end if;
        end if;
    end process;

    -- ===== Stage 21: read sines_1_even, read sines_1_odd
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sines_1_even_22 <= SINES_1_EVEN(to_integer(step_number1_even_21));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sines_1_odd_22 <= SINES_1_ODD(to_integer(step_number1_odd_21));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_22 <= in_nz_21;
                in_gain1r_22 <= in_gain1r_21;
                in_gain1g_22 <= in_gain1g_21;
                in_gain1b_22 <= in_gain1b_21;
                hidden_22 <= hidden_21;
                v1_is_odd_22 <= v1_is_odd_21;
                x1_22 <= x1_21;
                past_part1_even_22 <= past_part1_even_21;
                past_part1_even_signed_22 <= past_part1_even_signed_21;
                end1_even_22 <= end1_even_21;
                past_part1_odd_22 <= past_part1_odd_21;
                past_part1_odd_signed_22 <= past_part1_odd_signed_21;
                end1_odd_22 <= end1_odd_21;
                texels1_000_22 <= texels1_000_21;
                texels1_001_22 <= texels1_001_21;
                texels1_010_22 <= texels1_010_21;
                texels1_011_22 <= texels1_011_21;
                texels1_100_22 <= texels1_100_21;
                texels1_101_22 <= texels1_101_21;
                texels1_110_22 <= texels1_110_21;
                texels1_111_22 <= texels1_111_21;
                v1_weight_of_0_22 <= v1_weight_of_0_21;
                v1_weight_of_1_22 <= v1_weight_of_1_21;
                v1_weight_of_2_22 <= v1_weight_of_2_21;
                v1_weight_of_3_22 <= v1_weight_of_3_21;
                v1_weight_of_4_22 <= v1_weight_of_4_21;
                v1_weight_of_5_22 <= v1_weight_of_5_21;
                blend1_signed_22 <= blend1_signed_21;
                square1_r_by_1_22 <= square1_r_by_1_21;
                square1_r_amount_2_22 <= square1_r_amount_2_21;
                square1_r_by_4_22 <= square1_r_by_4_21;
                square1_g_by_1_22 <= square1_g_by_1_21;
                square1_g_amount_2_22 <= square1_g_amount_2_21;
                square1_g_by_4_22 <= square1_g_by_4_21;
                square1_b_by_1_22 <= square1_b_by_1_21;
                square1_b_amount_2_22 <= square1_b_amount_2_21;
                square1_b_by_4_22 <= square1_b_by_4_21;
            end if;
        end if;
    end process;

    -- ===== Stage 22: registers only
    -- Q0.14: the sine
    sine_1_even_22 <= signed(sines_1_even_22(52 downto 38));
    -- UQ-5.16: what it rises by to the next row
    sine_rise_1_even_22 <= unsigned(sines_1_even_22(37 downto 27));
    -- UQ1.14: the cosine
    cosine_1_even_22 <= unsigned(sines_1_even_22(26 downto 12));
    -- Q-5.16: what it rises by to the next row
    cosine_rise_1_even_22 <= signed(sines_1_even_22(11 downto 0));
    -- Q0.14: the sine
    sine_1_odd_22 <= signed(sines_1_odd_22(52 downto 38));
    -- UQ-5.16: what it rises by to the next row
    sine_rise_1_odd_22 <= unsigned(sines_1_odd_22(37 downto 27));
    -- UQ1.14: the cosine
    cosine_1_odd_22 <= unsigned(sines_1_odd_22(26 downto 12));
    -- Q-5.16: what it rises by to the next row
    cosine_rise_1_odd_22 <= signed(sines_1_odd_22(11 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_23 <= in_nz_22;
                in_gain1r_23 <= in_gain1r_22;
                in_gain1g_23 <= in_gain1g_22;
                in_gain1b_23 <= in_gain1b_22;
                hidden_23 <= hidden_22;
                v1_is_odd_23 <= v1_is_odd_22;
                x1_23 <= x1_22;
                past_part1_even_23 <= past_part1_even_22;
                sine_1_even_23 <= sine_1_even_22;
                sine_rise_1_even_23 <= sine_rise_1_even_22;
                cosine_1_even_23 <= cosine_1_even_22;
                cosine_rise_1_even_23 <= cosine_rise_1_even_22;
                past_part1_even_signed_23 <= past_part1_even_signed_22;
                end1_even_23 <= end1_even_22;
                past_part1_odd_23 <= past_part1_odd_22;
                sine_1_odd_23 <= sine_1_odd_22;
                sine_rise_1_odd_23 <= sine_rise_1_odd_22;
                cosine_1_odd_23 <= cosine_1_odd_22;
                cosine_rise_1_odd_23 <= cosine_rise_1_odd_22;
                past_part1_odd_signed_23 <= past_part1_odd_signed_22;
                end1_odd_23 <= end1_odd_22;
                texels1_000_23 <= texels1_000_22;
                texels1_001_23 <= texels1_001_22;
                texels1_010_23 <= texels1_010_22;
                texels1_011_23 <= texels1_011_22;
                texels1_100_23 <= texels1_100_22;
                texels1_101_23 <= texels1_101_22;
                texels1_110_23 <= texels1_110_22;
                texels1_111_23 <= texels1_111_22;
                v1_weight_of_0_23 <= v1_weight_of_0_22;
                v1_weight_of_1_23 <= v1_weight_of_1_22;
                v1_weight_of_2_23 <= v1_weight_of_2_22;
                v1_weight_of_3_23 <= v1_weight_of_3_22;
                v1_weight_of_4_23 <= v1_weight_of_4_22;
                v1_weight_of_5_23 <= v1_weight_of_5_22;
                blend1_signed_23 <= blend1_signed_22;
                square1_r_by_1_23 <= square1_r_by_1_22;
                square1_r_amount_2_23 <= square1_r_amount_2_22;
                square1_r_by_4_23 <= square1_r_by_4_22;
                square1_g_by_1_23 <= square1_g_by_1_22;
                square1_g_amount_2_23 <= square1_g_amount_2_22;
                square1_g_by_4_23 <= square1_g_by_4_22;
                square1_b_by_1_23 <= square1_b_by_1_22;
                square1_b_amount_2_23 <= square1_b_amount_2_22;
                square1_b_by_4_23 <= square1_b_by_4_22;
            end if;
        end if;
    end process;

    -- ===== Stage 23: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_24 <= in_nz_23;
                in_gain1r_24 <= in_gain1r_23;
                in_gain1g_24 <= in_gain1g_23;
                in_gain1b_24 <= in_gain1b_23;
                hidden_24 <= hidden_23;
                v1_is_odd_24 <= v1_is_odd_23;
                x1_24 <= x1_23;
                past_part1_even_24 <= past_part1_even_23;
                sine_1_even_24 <= sine_1_even_23;
                sine_rise_1_even_24 <= sine_rise_1_even_23;
                cosine_1_even_24 <= cosine_1_even_23;
                cosine_rise_1_even_24 <= cosine_rise_1_even_23;
                past_part1_even_signed_24 <= past_part1_even_signed_23;
                end1_even_24 <= end1_even_23;
                past_part1_odd_24 <= past_part1_odd_23;
                sine_1_odd_24 <= sine_1_odd_23;
                sine_rise_1_odd_24 <= sine_rise_1_odd_23;
                cosine_1_odd_24 <= cosine_1_odd_23;
                cosine_rise_1_odd_24 <= cosine_rise_1_odd_23;
                past_part1_odd_signed_24 <= past_part1_odd_signed_23;
                end1_odd_24 <= end1_odd_23;
                texels1_000_24 <= texels1_000_23;
                texels1_001_24 <= texels1_001_23;
                texels1_010_24 <= texels1_010_23;
                texels1_011_24 <= texels1_011_23;
                texels1_100_24 <= texels1_100_23;
                texels1_101_24 <= texels1_101_23;
                texels1_110_24 <= texels1_110_23;
                texels1_111_24 <= texels1_111_23;
                v1_weight_of_0_24 <= v1_weight_of_0_23;
                v1_weight_of_1_24 <= v1_weight_of_1_23;
                v1_weight_of_2_24 <= v1_weight_of_2_23;
                v1_weight_of_3_24 <= v1_weight_of_3_23;
                v1_weight_of_4_24 <= v1_weight_of_4_23;
                v1_weight_of_5_24 <= v1_weight_of_5_23;
                blend1_signed_24 <= blend1_signed_23;
                square1_r_by_1_24 <= square1_r_by_1_23;
                square1_r_amount_2_24 <= square1_r_amount_2_23;
                square1_r_by_4_24 <= square1_r_by_4_23;
                square1_g_by_1_24 <= square1_g_by_1_23;
                square1_g_amount_2_24 <= square1_g_amount_2_23;
                square1_g_by_4_24 <= square1_g_by_4_23;
                square1_b_by_1_24 <= square1_b_by_1_23;
                square1_b_amount_2_24 <= square1_b_amount_2_23;
                square1_b_by_4_24 <= square1_b_by_4_23;
            end if;
        end if;
    end process;

    -- ===== Stage 24: sin_part1_even, cos_part1_even, sin_part1_odd and 1 more
    -- UQ-5.24: its part of the rise
    sin_part1_even_24 <= sine_rise_1_even_24 * past_part1_even_24;
    -- Q-4.24: its part of the rise
    cos_part1_even_24 <= cosine_rise_1_even_24 * past_part1_even_signed_24;
    -- UQ-5.24: its part of the rise
    sin_part1_odd_24 <= sine_rise_1_odd_24 * past_part1_odd_24;
    -- Q-4.24: its part of the rise
    cos_part1_odd_24 <= cosine_rise_1_odd_24 * past_part1_odd_signed_24;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_25 <= in_nz_24;
                in_gain1r_25 <= in_gain1r_24;
                in_gain1g_25 <= in_gain1g_24;
                in_gain1b_25 <= in_gain1b_24;
                hidden_25 <= hidden_24;
                v1_is_odd_25 <= v1_is_odd_24;
                x1_25 <= x1_24;
                sine_1_even_25 <= sine_1_even_24;
                cosine_1_even_25 <= cosine_1_even_24;
                sin_part1_even_25 <= sin_part1_even_24;
                cos_part1_even_25 <= cos_part1_even_24;
                end1_even_25 <= end1_even_24;
                sine_1_odd_25 <= sine_1_odd_24;
                cosine_1_odd_25 <= cosine_1_odd_24;
                sin_part1_odd_25 <= sin_part1_odd_24;
                cos_part1_odd_25 <= cos_part1_odd_24;
                end1_odd_25 <= end1_odd_24;
                texels1_000_25 <= texels1_000_24;
                texels1_001_25 <= texels1_001_24;
                texels1_010_25 <= texels1_010_24;
                texels1_011_25 <= texels1_011_24;
                texels1_100_25 <= texels1_100_24;
                texels1_101_25 <= texels1_101_24;
                texels1_110_25 <= texels1_110_24;
                texels1_111_25 <= texels1_111_24;
                v1_weight_of_0_25 <= v1_weight_of_0_24;
                v1_weight_of_1_25 <= v1_weight_of_1_24;
                v1_weight_of_2_25 <= v1_weight_of_2_24;
                v1_weight_of_3_25 <= v1_weight_of_3_24;
                v1_weight_of_4_25 <= v1_weight_of_4_24;
                v1_weight_of_5_25 <= v1_weight_of_5_24;
                blend1_signed_25 <= blend1_signed_24;
                square1_r_by_1_25 <= square1_r_by_1_24;
                square1_r_amount_2_25 <= square1_r_amount_2_24;
                square1_r_by_4_25 <= square1_r_by_4_24;
                square1_g_by_1_25 <= square1_g_by_1_24;
                square1_g_amount_2_25 <= square1_g_amount_2_24;
                square1_g_by_4_25 <= square1_g_by_4_24;
                square1_b_by_1_25 <= square1_b_by_1_24;
                square1_b_amount_2_25 <= square1_b_amount_2_24;
                square1_b_by_4_25 <= square1_b_by_4_24;
            end if;
        end if;
    end process;

    -- ===== Stage 25: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_26 <= in_nz_25;
                in_gain1r_26 <= in_gain1r_25;
                in_gain1g_26 <= in_gain1g_25;
                in_gain1b_26 <= in_gain1b_25;
                hidden_26 <= hidden_25;
                v1_is_odd_26 <= v1_is_odd_25;
                x1_26 <= x1_25;
                sine_1_even_26 <= sine_1_even_25;
                cosine_1_even_26 <= cosine_1_even_25;
                sin_part1_even_26 <= sin_part1_even_25;
                cos_part1_even_26 <= cos_part1_even_25;
                end1_even_26 <= end1_even_25;
                sine_1_odd_26 <= sine_1_odd_25;
                cosine_1_odd_26 <= cosine_1_odd_25;
                sin_part1_odd_26 <= sin_part1_odd_25;
                cos_part1_odd_26 <= cos_part1_odd_25;
                end1_odd_26 <= end1_odd_25;
                texels1_000_26 <= texels1_000_25;
                texels1_001_26 <= texels1_001_25;
                texels1_010_26 <= texels1_010_25;
                texels1_011_26 <= texels1_011_25;
                texels1_100_26 <= texels1_100_25;
                texels1_101_26 <= texels1_101_25;
                texels1_110_26 <= texels1_110_25;
                texels1_111_26 <= texels1_111_25;
                v1_weight_of_0_26 <= v1_weight_of_0_25;
                v1_weight_of_1_26 <= v1_weight_of_1_25;
                v1_weight_of_2_26 <= v1_weight_of_2_25;
                v1_weight_of_3_26 <= v1_weight_of_3_25;
                v1_weight_of_4_26 <= v1_weight_of_4_25;
                v1_weight_of_5_26 <= v1_weight_of_5_25;
                blend1_signed_26 <= blend1_signed_25;
                square1_r_by_1_26 <= square1_r_by_1_25;
                square1_r_amount_2_26 <= square1_r_amount_2_25;
                square1_r_by_4_26 <= square1_r_by_4_25;
                square1_g_by_1_26 <= square1_g_by_1_25;
                square1_g_amount_2_26 <= square1_g_amount_2_25;
                square1_g_by_4_26 <= square1_g_by_4_25;
                square1_b_by_1_26 <= square1_b_by_1_25;
                square1_b_amount_2_26 <= square1_b_amount_2_25;
                square1_b_by_4_26 <= square1_b_by_4_25;
            end if;
        end if;
    end process;

    -- ===== Stage 26: sin_exact1_even, cos_exact1_even, sin_exact1_odd and 1 more
    -- Q1.24: between two rows
    sin_exact1_even_26 <=
        shift_left(resize(sine_1_even_26, 26), 10) + signed(resize(sin_part1_even_26, 26));
    -- Q1.14: rounded down
    sin1_even_26 <= sin_exact1_even_26(25 downto 10);
    -- Q1.24: between two rows
    cos_exact1_even_26 <=
        shift_left(signed(resize(cosine_1_even_26, 26)), 10) + resize(cos_part1_even_26, 26);
    -- Q1.14: rounded down
    cos1_even_26 <= cos_exact1_even_26(25 downto 10);
    -- Q1.24: between two rows
    sin_exact1_odd_26 <=
        shift_left(resize(sine_1_odd_26, 26), 10) + signed(resize(sin_part1_odd_26, 26));
    -- Q1.14: rounded down
    sin1_odd_26 <= sin_exact1_odd_26(25 downto 10);
    -- Q1.24: between two rows
    cos_exact1_odd_26 <=
        shift_left(signed(resize(cosine_1_odd_26, 26)), 10) + resize(cos_part1_odd_26, 26);
    -- Q1.14: rounded down
    cos1_odd_26 <= cos_exact1_odd_26(25 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_nz_27 <= in_nz_26;
                in_gain1r_27 <= in_gain1r_26;
                in_gain1g_27 <= in_gain1g_26;
                in_gain1b_27 <= in_gain1b_26;
                hidden_27 <= hidden_26;
                v1_is_odd_27 <= v1_is_odd_26;
                x1_27 <= x1_26;
                sin1_even_27 <= sin1_even_26;
                cos1_even_27 <= cos1_even_26;
                end1_even_27 <= end1_even_26;
                sin1_odd_27 <= sin1_odd_26;
                cos1_odd_27 <= cos1_odd_26;
                end1_odd_27 <= end1_odd_26;
                texels1_000_27 <= texels1_000_26;
                texels1_001_27 <= texels1_001_26;
                texels1_010_27 <= texels1_010_26;
                texels1_011_27 <= texels1_011_26;
                texels1_100_27 <= texels1_100_26;
                texels1_101_27 <= texels1_101_26;
                texels1_110_27 <= texels1_110_26;
                texels1_111_27 <= texels1_111_26;
                v1_weight_of_0_27 <= v1_weight_of_0_26;
                v1_weight_of_1_27 <= v1_weight_of_1_26;
                v1_weight_of_2_27 <= v1_weight_of_2_26;
                v1_weight_of_3_27 <= v1_weight_of_3_26;
                v1_weight_of_4_27 <= v1_weight_of_4_26;
                v1_weight_of_5_27 <= v1_weight_of_5_26;
                blend1_signed_27 <= blend1_signed_26;
                square1_r_by_1_27 <= square1_r_by_1_26;
                square1_r_amount_2_27 <= square1_r_amount_2_26;
                square1_r_by_4_27 <= square1_r_by_4_26;
                square1_g_by_1_27 <= square1_g_by_1_26;
                square1_g_amount_2_27 <= square1_g_amount_2_26;
                square1_g_by_4_27 <= square1_g_by_4_26;
                square1_b_by_1_27 <= square1_b_by_1_26;
                square1_b_amount_2_27 <= square1_b_amount_2_26;
                square1_b_by_4_27 <= square1_b_by_4_26;
            end if;
        end if;
    end process;

    -- ===== Stage 27: xc1_even_exact, zs1_even_exact, zc1_even_exact and 5 more
    -- Q3.28: x cos
    xc1_even_exact_27 <= x1_27 * cos1_even_27;
    -- Q1.14: rounded down
    xc1_even_27 <= xc1_even_exact_27(29 downto 14);
    -- Q3.30: z sin
    zs1_even_exact_27 <= in_nz_27 * sin1_even_27;
    -- Q2.14: rounded down
    zs1_even_27 <= zs1_even_exact_27(32 downto 16);
    -- Q3.30: z cos
    zc1_even_exact_27 <= in_nz_27 * cos1_even_27;
    -- Q2.14: rounded down
    zc1_even_27 <= zc1_even_exact_27(32 downto 16);
    -- Q3.28: x sin
    xs1_even_exact_27 <= x1_27 * sin1_even_27;
    -- Q1.14: rounded down
    xs1_even_27 <= xs1_even_exact_27(29 downto 14);
    -- Q3.28: x cos
    xc1_odd_exact_27 <= x1_27 * cos1_odd_27;
    -- Q1.14: rounded down
    xc1_odd_27 <= xc1_odd_exact_27(29 downto 14);
    -- Q3.30: z sin
    zs1_odd_exact_27 <= in_nz_27 * sin1_odd_27;
    -- Q2.14: rounded down
    zs1_odd_27 <= zs1_odd_exact_27(32 downto 16);
    -- Q3.30: z cos
    zc1_odd_exact_27 <= in_nz_27 * cos1_odd_27;
    -- Q2.14: rounded down
    zc1_odd_27 <= zc1_odd_exact_27(32 downto 16);
    -- Q3.28: x sin
    xs1_odd_exact_27 <= x1_27 * sin1_odd_27;
    -- Q1.14: rounded down
    xs1_odd_27 <= xs1_odd_exact_27(29 downto 14);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_28 <= in_gain1r_27;
                in_gain1g_28 <= in_gain1g_27;
                in_gain1b_28 <= in_gain1b_27;
                hidden_28 <= hidden_27;
                v1_is_odd_28 <= v1_is_odd_27;
                xc1_even_28 <= xc1_even_27;
                zs1_even_28 <= zs1_even_27;
                zc1_even_28 <= zc1_even_27;
                xs1_even_28 <= xs1_even_27;
                end1_even_28 <= end1_even_27;
                xc1_odd_28 <= xc1_odd_27;
                zs1_odd_28 <= zs1_odd_27;
                zc1_odd_28 <= zc1_odd_27;
                xs1_odd_28 <= xs1_odd_27;
                end1_odd_28 <= end1_odd_27;
                texels1_000_28 <= texels1_000_27;
                texels1_001_28 <= texels1_001_27;
                texels1_010_28 <= texels1_010_27;
                texels1_011_28 <= texels1_011_27;
                texels1_100_28 <= texels1_100_27;
                texels1_101_28 <= texels1_101_27;
                texels1_110_28 <= texels1_110_27;
                texels1_111_28 <= texels1_111_27;
                v1_weight_of_0_28 <= v1_weight_of_0_27;
                v1_weight_of_1_28 <= v1_weight_of_1_27;
                v1_weight_of_2_28 <= v1_weight_of_2_27;
                v1_weight_of_3_28 <= v1_weight_of_3_27;
                v1_weight_of_4_28 <= v1_weight_of_4_27;
                v1_weight_of_5_28 <= v1_weight_of_5_27;
                blend1_signed_28 <= blend1_signed_27;
                square1_r_by_1_28 <= square1_r_by_1_27;
                square1_r_amount_2_28 <= square1_r_amount_2_27;
                square1_r_by_4_28 <= square1_r_by_4_27;
                square1_g_by_1_28 <= square1_g_by_1_27;
                square1_g_amount_2_28 <= square1_g_amount_2_27;
                square1_g_by_4_28 <= square1_g_by_4_27;
                square1_b_by_1_28 <= square1_b_by_1_27;
                square1_b_amount_2_28 <= square1_b_amount_2_27;
                square1_b_by_4_28 <= square1_b_by_4_27;
            end if;
        end if;
    end process;

    -- ===== Stage 28: across1_even, across1_odd
    -- Q2.14: x of the turned normal
    across1_even_28 <= resize(xc1_even_28, 17) + zs1_even_28;
    -- Q7.9: in texels from the middle
    u1_even_scaled_28 <= across1_even_28;
    -- Q2.14: x of the turned normal
    across1_odd_28 <= resize(xc1_odd_28, 17) + zs1_odd_28;
    -- Q7.9: in texels from the middle
    u1_odd_scaled_28 <= across1_odd_28;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_29 <= in_gain1r_28;
                in_gain1g_29 <= in_gain1g_28;
                in_gain1b_29 <= in_gain1b_28;
                hidden_29 <= hidden_28;
                v1_is_odd_29 <= v1_is_odd_28;
                zc1_even_29 <= zc1_even_28;
                xs1_even_29 <= xs1_even_28;
                u1_even_scaled_29 <= u1_even_scaled_28;
                end1_even_29 <= end1_even_28;
                zc1_odd_29 <= zc1_odd_28;
                xs1_odd_29 <= xs1_odd_28;
                u1_odd_scaled_29 <= u1_odd_scaled_28;
                end1_odd_29 <= end1_odd_28;
                texels1_000_29 <= texels1_000_28;
                texels1_001_29 <= texels1_001_28;
                texels1_010_29 <= texels1_010_28;
                texels1_011_29 <= texels1_011_28;
                texels1_100_29 <= texels1_100_28;
                texels1_101_29 <= texels1_101_28;
                texels1_110_29 <= texels1_110_28;
                texels1_111_29 <= texels1_111_28;
                v1_weight_of_0_29 <= v1_weight_of_0_28;
                v1_weight_of_1_29 <= v1_weight_of_1_28;
                v1_weight_of_2_29 <= v1_weight_of_2_28;
                v1_weight_of_3_29 <= v1_weight_of_3_28;
                v1_weight_of_4_29 <= v1_weight_of_4_28;
                v1_weight_of_5_29 <= v1_weight_of_5_28;
                blend1_signed_29 <= blend1_signed_28;
                square1_r_by_1_29 <= square1_r_by_1_28;
                square1_r_amount_2_29 <= square1_r_amount_2_28;
                square1_r_by_4_29 <= square1_r_by_4_28;
                square1_g_by_1_29 <= square1_g_by_1_28;
                square1_g_amount_2_29 <= square1_g_amount_2_28;
                square1_g_by_4_29 <= square1_g_by_4_28;
                square1_b_by_1_29 <= square1_b_by_1_28;
                square1_b_amount_2_29 <= square1_b_amount_2_28;
                square1_b_by_4_29 <= square1_b_by_4_28;
            end if;
        end if;
    end process;

    -- ===== Stage 29: behind1_even, u1_even_place, behind1_odd, u1_odd_place
    -- UQ1.0: whether it is behind the rim, z < 0
    behind1_even_29 <= '1' when xs1_even_29 > zc1_even_29 else '0';
    -- Q8.9: from the first, plus half a weight's last bit
    u1_even_place_29 <= resize(u1_even_scaled_29, 18) + to_signed(16132, 18);
    -- Q8.6: rounded to the nearest weight
    u1_even_cut_29 <= u1_even_place_29(17 downto 3);
    -- UQ1.0: whether it is behind the rim, z < 0
    behind1_odd_29 <= '1' when xs1_odd_29 > zc1_odd_29 else '0';
    -- Q8.9: from the first, plus half a weight's last bit
    u1_odd_place_29 <= resize(u1_odd_scaled_29, 18) + to_signed(16132, 18);
    -- Q8.6: rounded to the nearest weight
    u1_odd_cut_29 <= u1_odd_place_29(17 downto 3);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_30 <= in_gain1r_29;
                in_gain1g_30 <= in_gain1g_29;
                in_gain1b_30 <= in_gain1b_29;
                hidden_30 <= hidden_29;
                v1_is_odd_30 <= v1_is_odd_29;
                behind1_even_30 <= behind1_even_29;
                u1_even_cut_30 <= u1_even_cut_29;
                end1_even_30 <= end1_even_29;
                behind1_odd_30 <= behind1_odd_29;
                u1_odd_cut_30 <= u1_odd_cut_29;
                end1_odd_30 <= end1_odd_29;
                texels1_000_30 <= texels1_000_29;
                texels1_001_30 <= texels1_001_29;
                texels1_010_30 <= texels1_010_29;
                texels1_011_30 <= texels1_011_29;
                texels1_100_30 <= texels1_100_29;
                texels1_101_30 <= texels1_101_29;
                texels1_110_30 <= texels1_110_29;
                texels1_111_30 <= texels1_111_29;
                v1_weight_of_0_30 <= v1_weight_of_0_29;
                v1_weight_of_1_30 <= v1_weight_of_1_29;
                v1_weight_of_2_30 <= v1_weight_of_2_29;
                v1_weight_of_3_30 <= v1_weight_of_3_29;
                v1_weight_of_4_30 <= v1_weight_of_4_29;
                v1_weight_of_5_30 <= v1_weight_of_5_29;
                blend1_signed_30 <= blend1_signed_29;
                square1_r_by_1_30 <= square1_r_by_1_29;
                square1_r_amount_2_30 <= square1_r_amount_2_29;
                square1_r_by_4_30 <= square1_r_by_4_29;
                square1_g_by_1_30 <= square1_g_by_1_29;
                square1_g_amount_2_30 <= square1_g_amount_2_29;
                square1_g_by_4_30 <= square1_g_by_4_29;
                square1_b_by_1_30 <= square1_b_by_1_29;
                square1_b_amount_2_30 <= square1_b_amount_2_29;
                square1_b_by_4_30 <= square1_b_by_4_29;
            end if;
        end if;
    end process;

    -- ===== Stage 30: u1_even_kept, u_at1_even, u1_odd_kept, u_at1_odd and 12 more
    -- UQ6.6: between the outermost centres
    u1_even_kept_30 <= (others => '0') when u1_even_cut_30(14) = '1' else
        to_unsigned(4032, 12) when u1_even_cut_30 > 4032 else
        unsigned(u1_even_cut_30(11 downto 0));
    -- UQ6.6: that end from behind the rim
    u_at1_even_30 <= end1_even_30 when behind1_even_30 = '1' else u1_even_kept_30;
    -- UQ6.0: the texel at or below it
    u1_even_texel_30 <= u_at1_even_30(11 downto 6);
    -- UQ0.6: the weight of the next
    u1_even_weight_30 <= u_at1_even_30(5 downto 0);
    -- UQ6.-1: its leading bits
    u1_even_odd_high_30 <= u1_even_texel_30(5 downto 1);
    -- UQ5.0: the odd one of both
    u1_even_odd_30 <= u1_even_odd_high_30;
    -- UQ1.0: its last bit
    u1_even_is_odd_30 <= u1_even_texel_30(0);
    -- UQ6.6: between the outermost centres
    u1_odd_kept_30 <= (others => '0') when u1_odd_cut_30(14) = '1' else
        to_unsigned(4032, 12) when u1_odd_cut_30 > 4032 else
        unsigned(u1_odd_cut_30(11 downto 0));
    -- UQ6.6: that end from behind the rim
    u_at1_odd_30 <= end1_odd_30 when behind1_odd_30 = '1' else u1_odd_kept_30;
    -- UQ6.0: the texel at or below it
    u1_odd_texel_30 <= u_at1_odd_30(11 downto 6);
    -- UQ0.6: the weight of the next
    u1_odd_weight_30 <= u_at1_odd_30(5 downto 0);
    -- UQ6.-1: its leading bits
    u1_odd_odd_high_30 <= u1_odd_texel_30(5 downto 1);
    -- UQ5.0: the odd one of both
    u1_odd_odd_30 <= u1_odd_odd_high_30;
    -- UQ1.0: its last bit
    u1_odd_is_odd_30 <= u1_odd_texel_30(0);
    -- UQ-5.6: a bit of the weight
    u1_even_weight_bit_0_30 <= u1_even_weight_30(0 downto 0);
    -- UQ-4.5: a bit of the weight
    u1_even_weight_bit_1_30 <= u1_even_weight_30(1 downto 1);
    -- UQ-3.4: a bit of the weight
    u1_even_weight_bit_2_30 <= u1_even_weight_30(2 downto 2);
    -- UQ-2.3: a bit of the weight
    u1_even_weight_bit_3_30 <= u1_even_weight_30(3 downto 3);
    -- UQ-1.2: a bit of the weight
    u1_even_weight_bit_4_30 <= u1_even_weight_30(4 downto 4);
    -- UQ0.1: a bit of the weight
    u1_even_weight_bit_5_30 <= u1_even_weight_30(5 downto 5);
    -- UQ1.0: as a flag
    u1_even_weight_of_0_flag_30 <= u1_even_weight_bit_0_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_0_not_30 <= not u1_even_weight_of_0_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_0_30 <=
        u1_even_weight_of_0_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_0_flag_30;
    -- UQ1.0: as a flag
    u1_even_weight_of_1_flag_30 <= u1_even_weight_bit_1_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_1_not_30 <= not u1_even_weight_of_1_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_1_30 <=
        u1_even_weight_of_1_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_1_flag_30;
    -- UQ1.0: as a flag
    u1_even_weight_of_2_flag_30 <= u1_even_weight_bit_2_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_2_not_30 <= not u1_even_weight_of_2_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_2_30 <=
        u1_even_weight_of_2_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_2_flag_30;
    -- UQ1.0: as a flag
    u1_even_weight_of_3_flag_30 <= u1_even_weight_bit_3_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_3_not_30 <= not u1_even_weight_of_3_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_3_30 <=
        u1_even_weight_of_3_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_3_flag_30;
    -- UQ1.0: as a flag
    u1_even_weight_of_4_flag_30 <= u1_even_weight_bit_4_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_4_not_30 <= not u1_even_weight_of_4_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_4_30 <=
        u1_even_weight_of_4_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_4_flag_30;
    -- UQ1.0: as a flag
    u1_even_weight_of_5_flag_30 <= u1_even_weight_bit_5_30(0);
    -- UQ1.0: it is 0
    u1_even_weight_of_5_not_30 <= not u1_even_weight_of_5_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_even_weight_of_5_30 <=
        u1_even_weight_of_5_not_30 when u1_even_is_odd_30 = '1' else u1_even_weight_of_5_flag_30;
    -- UQ-5.6: a bit of the weight
    u1_odd_weight_bit_0_30 <= u1_odd_weight_30(0 downto 0);
    -- UQ-4.5: a bit of the weight
    u1_odd_weight_bit_1_30 <= u1_odd_weight_30(1 downto 1);
    -- UQ-3.4: a bit of the weight
    u1_odd_weight_bit_2_30 <= u1_odd_weight_30(2 downto 2);
    -- UQ-2.3: a bit of the weight
    u1_odd_weight_bit_3_30 <= u1_odd_weight_30(3 downto 3);
    -- UQ-1.2: a bit of the weight
    u1_odd_weight_bit_4_30 <= u1_odd_weight_30(4 downto 4);
    -- UQ0.1: a bit of the weight
    u1_odd_weight_bit_5_30 <= u1_odd_weight_30(5 downto 5);
    -- UQ1.0: as a flag
    u1_odd_weight_of_0_flag_30 <= u1_odd_weight_bit_0_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_0_not_30 <= not u1_odd_weight_of_0_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_0_30 <=
        u1_odd_weight_of_0_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_0_flag_30;
    -- UQ1.0: as a flag
    u1_odd_weight_of_1_flag_30 <= u1_odd_weight_bit_1_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_1_not_30 <= not u1_odd_weight_of_1_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_1_30 <=
        u1_odd_weight_of_1_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_1_flag_30;
    -- UQ1.0: as a flag
    u1_odd_weight_of_2_flag_30 <= u1_odd_weight_bit_2_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_2_not_30 <= not u1_odd_weight_of_2_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_2_30 <=
        u1_odd_weight_of_2_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_2_flag_30;
    -- UQ1.0: as a flag
    u1_odd_weight_of_3_flag_30 <= u1_odd_weight_bit_3_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_3_not_30 <= not u1_odd_weight_of_3_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_3_30 <=
        u1_odd_weight_of_3_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_3_flag_30;
    -- UQ1.0: as a flag
    u1_odd_weight_of_4_flag_30 <= u1_odd_weight_bit_4_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_4_not_30 <= not u1_odd_weight_of_4_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_4_30 <=
        u1_odd_weight_of_4_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_4_flag_30;
    -- UQ1.0: as a flag
    u1_odd_weight_of_5_flag_30 <= u1_odd_weight_bit_5_30(0);
    -- UQ1.0: it is 0
    u1_odd_weight_of_5_not_30 <= not u1_odd_weight_of_5_flag_30;
    -- UQ1.0: whether it counts for the odd one
    u1_odd_weight_of_5_30 <=
        u1_odd_weight_of_5_not_30 when u1_odd_is_odd_30 = '1' else u1_odd_weight_of_5_flag_30;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_31 <= in_gain1r_30;
                in_gain1g_31 <= in_gain1g_30;
                in_gain1b_31 <= in_gain1b_30;
                hidden_31 <= hidden_30;
                v1_is_odd_31 <= v1_is_odd_30;
                u1_even_texel_31 <= u1_even_texel_30;
                u1_even_odd_31 <= u1_even_odd_30;
                u1_even_is_odd_31 <= u1_even_is_odd_30;
                u1_odd_texel_31 <= u1_odd_texel_30;
                u1_odd_odd_31 <= u1_odd_odd_30;
                u1_odd_is_odd_31 <= u1_odd_is_odd_30;
                texels1_000_31 <= texels1_000_30;
                texels1_001_31 <= texels1_001_30;
                texels1_010_31 <= texels1_010_30;
                texels1_011_31 <= texels1_011_30;
                texels1_100_31 <= texels1_100_30;
                texels1_101_31 <= texels1_101_30;
                texels1_110_31 <= texels1_110_30;
                texels1_111_31 <= texels1_111_30;
                u1_even_weight_of_0_31 <= u1_even_weight_of_0_30;
                u1_even_weight_of_1_31 <= u1_even_weight_of_1_30;
                u1_even_weight_of_2_31 <= u1_even_weight_of_2_30;
                u1_even_weight_of_3_31 <= u1_even_weight_of_3_30;
                u1_even_weight_of_4_31 <= u1_even_weight_of_4_30;
                u1_even_weight_of_5_31 <= u1_even_weight_of_5_30;
                u1_odd_weight_of_0_31 <= u1_odd_weight_of_0_30;
                u1_odd_weight_of_1_31 <= u1_odd_weight_of_1_30;
                u1_odd_weight_of_2_31 <= u1_odd_weight_of_2_30;
                u1_odd_weight_of_3_31 <= u1_odd_weight_of_3_30;
                u1_odd_weight_of_4_31 <= u1_odd_weight_of_4_30;
                u1_odd_weight_of_5_31 <= u1_odd_weight_of_5_30;
                v1_weight_of_0_31 <= v1_weight_of_0_30;
                v1_weight_of_1_31 <= v1_weight_of_1_30;
                v1_weight_of_2_31 <= v1_weight_of_2_30;
                v1_weight_of_3_31 <= v1_weight_of_3_30;
                v1_weight_of_4_31 <= v1_weight_of_4_30;
                v1_weight_of_5_31 <= v1_weight_of_5_30;
                blend1_signed_31 <= blend1_signed_30;
                square1_r_by_1_31 <= square1_r_by_1_30;
                square1_r_amount_2_31 <= square1_r_amount_2_30;
                square1_r_by_4_31 <= square1_r_by_4_30;
                square1_g_by_1_31 <= square1_g_by_1_30;
                square1_g_amount_2_31 <= square1_g_amount_2_30;
                square1_g_by_4_31 <= square1_g_by_4_30;
                square1_b_by_1_31 <= square1_b_by_1_30;
                square1_b_amount_2_31 <= square1_b_amount_2_30;
                square1_b_by_4_31 <= square1_b_by_4_30;
            end if;
        end if;
    end process;

    -- ===== Stage 31: u1_even_next_exact, u1_odd_next_exact, texel1_001 and 3 more
    -- UQ7.0: the next
    u1_even_next_exact_31 <= resize(u1_even_texel_31, 7) + to_unsigned(1, 7);
    -- UQ7.0: the next
    u1_odd_next_exact_31 <= resize(u1_odd_texel_31, 7) + to_unsigned(1, 7);
    -- UQ12.0: side by side
    texel1_001_31 <= shift_left(resize(texels1_001_31, 12), 5) + resize(u1_even_odd_31, 12);
    -- UQ12.0: side by side
    texel1_011_31 <= shift_left(resize(texels1_011_31, 12), 5) + resize(u1_even_odd_31, 12);
    -- UQ12.0: side by side
    texel1_101_31 <= shift_left(resize(texels1_101_31, 12), 5) + resize(u1_odd_odd_31, 12);
    -- UQ12.0: side by side
    texel1_111_31 <= shift_left(resize(texels1_111_31, 12), 5) + resize(u1_odd_odd_31, 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_32 <= in_gain1r_31;
                in_gain1g_32 <= in_gain1g_31;
                in_gain1b_32 <= in_gain1b_31;
                hidden_32 <= hidden_31;
                v1_is_odd_32 <= v1_is_odd_31;
                u1_even_next_exact_32 <= u1_even_next_exact_31;
                u1_even_is_odd_32 <= u1_even_is_odd_31;
                u1_odd_next_exact_32 <= u1_odd_next_exact_31;
                u1_odd_is_odd_32 <= u1_odd_is_odd_31;
                texels1_000_32 <= texels1_000_31;
                texel1_001_32 <= texel1_001_31;
                texels1_010_32 <= texels1_010_31;
                texel1_011_32 <= texel1_011_31;
                texels1_100_32 <= texels1_100_31;
                texel1_101_32 <= texel1_101_31;
                texels1_110_32 <= texels1_110_31;
                texel1_111_32 <= texel1_111_31;
                u1_even_weight_of_0_32 <= u1_even_weight_of_0_31;
                u1_even_weight_of_1_32 <= u1_even_weight_of_1_31;
                u1_even_weight_of_2_32 <= u1_even_weight_of_2_31;
                u1_even_weight_of_3_32 <= u1_even_weight_of_3_31;
                u1_even_weight_of_4_32 <= u1_even_weight_of_4_31;
                u1_even_weight_of_5_32 <= u1_even_weight_of_5_31;
                u1_odd_weight_of_0_32 <= u1_odd_weight_of_0_31;
                u1_odd_weight_of_1_32 <= u1_odd_weight_of_1_31;
                u1_odd_weight_of_2_32 <= u1_odd_weight_of_2_31;
                u1_odd_weight_of_3_32 <= u1_odd_weight_of_3_31;
                u1_odd_weight_of_4_32 <= u1_odd_weight_of_4_31;
                u1_odd_weight_of_5_32 <= u1_odd_weight_of_5_31;
                v1_weight_of_0_32 <= v1_weight_of_0_31;
                v1_weight_of_1_32 <= v1_weight_of_1_31;
                v1_weight_of_2_32 <= v1_weight_of_2_31;
                v1_weight_of_3_32 <= v1_weight_of_3_31;
                v1_weight_of_4_32 <= v1_weight_of_4_31;
                v1_weight_of_5_32 <= v1_weight_of_5_31;
                blend1_signed_32 <= blend1_signed_31;
                square1_r_by_1_32 <= square1_r_by_1_31;
                square1_r_amount_2_32 <= square1_r_amount_2_31;
                square1_r_by_4_32 <= square1_r_by_4_31;
                square1_g_by_1_32 <= square1_g_by_1_31;
                square1_g_amount_2_32 <= square1_g_amount_2_31;
                square1_g_by_4_32 <= square1_g_by_4_31;
                square1_b_by_1_32 <= square1_b_by_1_31;
                square1_b_amount_2_32 <= square1_b_amount_2_31;
                square1_b_by_4_32 <= square1_b_by_4_31;
            end if;
        end if;
    end process;

    -- ===== Stage 32: u1_even_next, u1_odd_next
    -- UQ6.0: at most the last
    u1_even_next_32 <= to_unsigned(63, 6) when u1_even_next_exact_32(6) = '1' else
        u1_even_next_exact_32(5 downto 0);
    -- UQ6.-1: its leading bits
    u1_even_even_high_32 <= u1_even_next_32(5 downto 1);
    -- UQ5.0: the even one of both
    u1_even_even_32 <= u1_even_even_high_32;
    -- UQ6.0: at most the last
    u1_odd_next_32 <= to_unsigned(63, 6) when u1_odd_next_exact_32(6) = '1' else
        u1_odd_next_exact_32(5 downto 0);
    -- UQ6.-1: its leading bits
    u1_odd_even_high_32 <= u1_odd_next_32(5 downto 1);
    -- UQ5.0: the even one of both
    u1_odd_even_32 <= u1_odd_even_high_32;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_33 <= in_gain1r_32;
                in_gain1g_33 <= in_gain1g_32;
                in_gain1b_33 <= in_gain1b_32;
                hidden_33 <= hidden_32;
                v1_is_odd_33 <= v1_is_odd_32;
                u1_even_even_33 <= u1_even_even_32;
                u1_even_is_odd_33 <= u1_even_is_odd_32;
                u1_odd_even_33 <= u1_odd_even_32;
                u1_odd_is_odd_33 <= u1_odd_is_odd_32;
                texels1_000_33 <= texels1_000_32;
                texel1_001_33 <= texel1_001_32;
                texels1_010_33 <= texels1_010_32;
                texel1_011_33 <= texel1_011_32;
                texels1_100_33 <= texels1_100_32;
                texel1_101_33 <= texel1_101_32;
                texels1_110_33 <= texels1_110_32;
                texel1_111_33 <= texel1_111_32;
                u1_even_weight_of_0_33 <= u1_even_weight_of_0_32;
                u1_even_weight_of_1_33 <= u1_even_weight_of_1_32;
                u1_even_weight_of_2_33 <= u1_even_weight_of_2_32;
                u1_even_weight_of_3_33 <= u1_even_weight_of_3_32;
                u1_even_weight_of_4_33 <= u1_even_weight_of_4_32;
                u1_even_weight_of_5_33 <= u1_even_weight_of_5_32;
                u1_odd_weight_of_0_33 <= u1_odd_weight_of_0_32;
                u1_odd_weight_of_1_33 <= u1_odd_weight_of_1_32;
                u1_odd_weight_of_2_33 <= u1_odd_weight_of_2_32;
                u1_odd_weight_of_3_33 <= u1_odd_weight_of_3_32;
                u1_odd_weight_of_4_33 <= u1_odd_weight_of_4_32;
                u1_odd_weight_of_5_33 <= u1_odd_weight_of_5_32;
                v1_weight_of_0_33 <= v1_weight_of_0_32;
                v1_weight_of_1_33 <= v1_weight_of_1_32;
                v1_weight_of_2_33 <= v1_weight_of_2_32;
                v1_weight_of_3_33 <= v1_weight_of_3_32;
                v1_weight_of_4_33 <= v1_weight_of_4_32;
                v1_weight_of_5_33 <= v1_weight_of_5_32;
                blend1_signed_33 <= blend1_signed_32;
                square1_r_by_1_33 <= square1_r_by_1_32;
                square1_r_amount_2_33 <= square1_r_amount_2_32;
                square1_r_by_4_33 <= square1_r_by_4_32;
                square1_g_by_1_33 <= square1_g_by_1_32;
                square1_g_amount_2_33 <= square1_g_amount_2_32;
                square1_g_by_4_33 <= square1_g_by_4_32;
                square1_b_by_1_33 <= square1_b_by_1_32;
                square1_b_amount_2_33 <= square1_b_amount_2_32;
                square1_b_by_4_33 <= square1_b_by_4_32;
            end if;
        end if;
    end process;

    -- ===== Stage 33: texel1_000, texel1_010, texel1_100, texel1_110
    -- UQ12.0: side by side
    texel1_000_33 <= shift_left(resize(texels1_000_33, 12), 5) + resize(u1_even_even_33, 12);
    -- UQ12.0: side by side
    texel1_010_33 <= shift_left(resize(texels1_010_33, 12), 5) + resize(u1_even_even_33, 12);
    -- UQ12.0: side by side
    texel1_100_33 <= shift_left(resize(texels1_100_33, 12), 5) + resize(u1_odd_even_33, 12);
    -- UQ12.0: side by side
    texel1_110_33 <= shift_left(resize(texels1_110_33, 12), 5) + resize(u1_odd_even_33, 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_34 <= in_gain1r_33;
                in_gain1g_34 <= in_gain1g_33;
                in_gain1b_34 <= in_gain1b_33;
                hidden_34 <= hidden_33;
                v1_is_odd_34 <= v1_is_odd_33;
                u1_even_is_odd_34 <= u1_even_is_odd_33;
                u1_odd_is_odd_34 <= u1_odd_is_odd_33;
                texel1_000_34 <= texel1_000_33;
                texel1_001_34 <= texel1_001_33;
                texel1_010_34 <= texel1_010_33;
                texel1_011_34 <= texel1_011_33;
                texel1_100_34 <= texel1_100_33;
                texel1_101_34 <= texel1_101_33;
                texel1_110_34 <= texel1_110_33;
                texel1_111_34 <= texel1_111_33;
                u1_even_weight_of_0_34 <= u1_even_weight_of_0_33;
                u1_even_weight_of_1_34 <= u1_even_weight_of_1_33;
                u1_even_weight_of_2_34 <= u1_even_weight_of_2_33;
                u1_even_weight_of_3_34 <= u1_even_weight_of_3_33;
                u1_even_weight_of_4_34 <= u1_even_weight_of_4_33;
                u1_even_weight_of_5_34 <= u1_even_weight_of_5_33;
                u1_odd_weight_of_0_34 <= u1_odd_weight_of_0_33;
                u1_odd_weight_of_1_34 <= u1_odd_weight_of_1_33;
                u1_odd_weight_of_2_34 <= u1_odd_weight_of_2_33;
                u1_odd_weight_of_3_34 <= u1_odd_weight_of_3_33;
                u1_odd_weight_of_4_34 <= u1_odd_weight_of_4_33;
                u1_odd_weight_of_5_34 <= u1_odd_weight_of_5_33;
                v1_weight_of_0_34 <= v1_weight_of_0_33;
                v1_weight_of_1_34 <= v1_weight_of_1_33;
                v1_weight_of_2_34 <= v1_weight_of_2_33;
                v1_weight_of_3_34 <= v1_weight_of_3_33;
                v1_weight_of_4_34 <= v1_weight_of_4_33;
                v1_weight_of_5_34 <= v1_weight_of_5_33;
                blend1_signed_34 <= blend1_signed_33;
                square1_r_by_1_34 <= square1_r_by_1_33;
                square1_r_amount_2_34 <= square1_r_amount_2_33;
                square1_r_by_4_34 <= square1_r_by_4_33;
                square1_g_by_1_34 <= square1_g_by_1_33;
                square1_g_amount_2_34 <= square1_g_amount_2_33;
                square1_g_by_4_34 <= square1_g_by_4_33;
                square1_b_by_1_34 <= square1_b_by_1_33;
                square1_b_amount_2_34 <= square1_b_amount_2_33;
                square1_b_by_4_34 <= square1_b_by_4_33;
            end if;
        end if;
    end process;

    -- ===== Stage 34: read texels_1_even_even_even, read texels_1_even_even_odd and 6 more
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_even_35 <= TEXELS_1_EVEN_EVEN_EVEN(to_integer(texel1_000_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_even_odd_35 <= TEXELS_1_EVEN_EVEN_ODD(to_integer(texel1_001_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_even_35 <= TEXELS_1_EVEN_ODD_EVEN(to_integer(texel1_010_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_even_odd_odd_35 <= TEXELS_1_EVEN_ODD_ODD(to_integer(texel1_011_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_even_35 <= TEXELS_1_ODD_EVEN_EVEN(to_integer(texel1_100_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_even_odd_35 <= TEXELS_1_ODD_EVEN_ODD(to_integer(texel1_101_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_even_35 <= TEXELS_1_ODD_ODD_EVEN(to_integer(texel1_110_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                texels_1_odd_odd_odd_35 <= TEXELS_1_ODD_ODD_ODD(to_integer(texel1_111_34));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_35 <= in_gain1r_34;
                in_gain1g_35 <= in_gain1g_34;
                in_gain1b_35 <= in_gain1b_34;
                hidden_35 <= hidden_34;
                v1_is_odd_35 <= v1_is_odd_34;
                u1_even_is_odd_35 <= u1_even_is_odd_34;
                u1_odd_is_odd_35 <= u1_odd_is_odd_34;
                u1_even_weight_of_0_35 <= u1_even_weight_of_0_34;
                u1_even_weight_of_1_35 <= u1_even_weight_of_1_34;
                u1_even_weight_of_2_35 <= u1_even_weight_of_2_34;
                u1_even_weight_of_3_35 <= u1_even_weight_of_3_34;
                u1_even_weight_of_4_35 <= u1_even_weight_of_4_34;
                u1_even_weight_of_5_35 <= u1_even_weight_of_5_34;
                u1_odd_weight_of_0_35 <= u1_odd_weight_of_0_34;
                u1_odd_weight_of_1_35 <= u1_odd_weight_of_1_34;
                u1_odd_weight_of_2_35 <= u1_odd_weight_of_2_34;
                u1_odd_weight_of_3_35 <= u1_odd_weight_of_3_34;
                u1_odd_weight_of_4_35 <= u1_odd_weight_of_4_34;
                u1_odd_weight_of_5_35 <= u1_odd_weight_of_5_34;
                v1_weight_of_0_35 <= v1_weight_of_0_34;
                v1_weight_of_1_35 <= v1_weight_of_1_34;
                v1_weight_of_2_35 <= v1_weight_of_2_34;
                v1_weight_of_3_35 <= v1_weight_of_3_34;
                v1_weight_of_4_35 <= v1_weight_of_4_34;
                v1_weight_of_5_35 <= v1_weight_of_5_34;
                blend1_signed_35 <= blend1_signed_34;
                square1_r_by_1_35 <= square1_r_by_1_34;
                square1_r_amount_2_35 <= square1_r_amount_2_34;
                square1_r_by_4_35 <= square1_r_by_4_34;
                square1_g_by_1_35 <= square1_g_by_1_34;
                square1_g_amount_2_35 <= square1_g_amount_2_34;
                square1_g_by_4_35 <= square1_g_by_4_34;
                square1_b_by_1_35 <= square1_b_by_1_34;
                square1_b_amount_2_35 <= square1_b_amount_2_34;
                square1_b_by_4_35 <= square1_b_by_4_34;
            end if;
        end if;
    end process;

    -- ===== Stage 35: registers only
    -- UQ0.8: red
    texels_1_even_even_even_r_35 <= unsigned(texels_1_even_even_even_35(23 downto 16));
    -- UQ0.8: red
    texels_1_even_even_odd_r_35 <= unsigned(texels_1_even_even_odd_35(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_even_r_35 <= unsigned(texels_1_even_odd_even_35(23 downto 16));
    -- UQ0.8: red
    texels_1_even_odd_odd_r_35 <= unsigned(texels_1_even_odd_odd_35(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_even_r_35 <= unsigned(texels_1_odd_even_even_35(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_even_odd_r_35 <= unsigned(texels_1_odd_even_odd_35(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_even_r_35 <= unsigned(texels_1_odd_odd_even_35(23 downto 16));
    -- UQ0.8: red
    texels_1_odd_odd_odd_r_35 <= unsigned(texels_1_odd_odd_odd_35(23 downto 16));
    -- UQ0.8: green
    texels_1_even_even_even_g_35 <= unsigned(texels_1_even_even_even_35(15 downto 8));
    -- UQ0.8: green
    texels_1_even_even_odd_g_35 <= unsigned(texels_1_even_even_odd_35(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_even_g_35 <= unsigned(texels_1_even_odd_even_35(15 downto 8));
    -- UQ0.8: green
    texels_1_even_odd_odd_g_35 <= unsigned(texels_1_even_odd_odd_35(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_even_g_35 <= unsigned(texels_1_odd_even_even_35(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_even_odd_g_35 <= unsigned(texels_1_odd_even_odd_35(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_even_g_35 <= unsigned(texels_1_odd_odd_even_35(15 downto 8));
    -- UQ0.8: green
    texels_1_odd_odd_odd_g_35 <= unsigned(texels_1_odd_odd_odd_35(15 downto 8));
    -- UQ0.8: blue
    texels_1_even_even_even_b_35 <= unsigned(texels_1_even_even_even_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_even_odd_b_35 <= unsigned(texels_1_even_even_odd_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_even_b_35 <= unsigned(texels_1_even_odd_even_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_even_odd_odd_b_35 <= unsigned(texels_1_even_odd_odd_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_even_b_35 <= unsigned(texels_1_odd_even_even_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_even_odd_b_35 <= unsigned(texels_1_odd_even_odd_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_even_b_35 <= unsigned(texels_1_odd_odd_even_35(7 downto 0));
    -- UQ0.8: blue
    texels_1_odd_odd_odd_b_35 <= unsigned(texels_1_odd_odd_odd_35(7 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_36 <= in_gain1r_35;
                in_gain1g_36 <= in_gain1g_35;
                in_gain1b_36 <= in_gain1b_35;
                hidden_36 <= hidden_35;
                v1_is_odd_36 <= v1_is_odd_35;
                u1_even_is_odd_36 <= u1_even_is_odd_35;
                u1_odd_is_odd_36 <= u1_odd_is_odd_35;
                texels_1_even_even_even_r_36 <= texels_1_even_even_even_r_35;
                texels_1_even_even_odd_r_36 <= texels_1_even_even_odd_r_35;
                texels_1_even_odd_even_r_36 <= texels_1_even_odd_even_r_35;
                texels_1_even_odd_odd_r_36 <= texels_1_even_odd_odd_r_35;
                texels_1_odd_even_even_r_36 <= texels_1_odd_even_even_r_35;
                texels_1_odd_even_odd_r_36 <= texels_1_odd_even_odd_r_35;
                texels_1_odd_odd_even_r_36 <= texels_1_odd_odd_even_r_35;
                texels_1_odd_odd_odd_r_36 <= texels_1_odd_odd_odd_r_35;
                u1_even_weight_of_0_36 <= u1_even_weight_of_0_35;
                u1_even_weight_of_1_36 <= u1_even_weight_of_1_35;
                u1_even_weight_of_2_36 <= u1_even_weight_of_2_35;
                u1_even_weight_of_3_36 <= u1_even_weight_of_3_35;
                u1_even_weight_of_4_36 <= u1_even_weight_of_4_35;
                u1_even_weight_of_5_36 <= u1_even_weight_of_5_35;
                u1_odd_weight_of_0_36 <= u1_odd_weight_of_0_35;
                u1_odd_weight_of_1_36 <= u1_odd_weight_of_1_35;
                u1_odd_weight_of_2_36 <= u1_odd_weight_of_2_35;
                u1_odd_weight_of_3_36 <= u1_odd_weight_of_3_35;
                u1_odd_weight_of_4_36 <= u1_odd_weight_of_4_35;
                u1_odd_weight_of_5_36 <= u1_odd_weight_of_5_35;
                v1_weight_of_0_36 <= v1_weight_of_0_35;
                v1_weight_of_1_36 <= v1_weight_of_1_35;
                v1_weight_of_2_36 <= v1_weight_of_2_35;
                v1_weight_of_3_36 <= v1_weight_of_3_35;
                v1_weight_of_4_36 <= v1_weight_of_4_35;
                v1_weight_of_5_36 <= v1_weight_of_5_35;
                blend1_signed_36 <= blend1_signed_35;
                square1_r_by_1_36 <= square1_r_by_1_35;
                square1_r_amount_2_36 <= square1_r_amount_2_35;
                square1_r_by_4_36 <= square1_r_by_4_35;
                texels_1_even_even_even_g_36 <= texels_1_even_even_even_g_35;
                texels_1_even_even_odd_g_36 <= texels_1_even_even_odd_g_35;
                texels_1_even_odd_even_g_36 <= texels_1_even_odd_even_g_35;
                texels_1_even_odd_odd_g_36 <= texels_1_even_odd_odd_g_35;
                texels_1_odd_even_even_g_36 <= texels_1_odd_even_even_g_35;
                texels_1_odd_even_odd_g_36 <= texels_1_odd_even_odd_g_35;
                texels_1_odd_odd_even_g_36 <= texels_1_odd_odd_even_g_35;
                texels_1_odd_odd_odd_g_36 <= texels_1_odd_odd_odd_g_35;
                square1_g_by_1_36 <= square1_g_by_1_35;
                square1_g_amount_2_36 <= square1_g_amount_2_35;
                square1_g_by_4_36 <= square1_g_by_4_35;
                texels_1_even_even_even_b_36 <= texels_1_even_even_even_b_35;
                texels_1_even_even_odd_b_36 <= texels_1_even_even_odd_b_35;
                texels_1_even_odd_even_b_36 <= texels_1_even_odd_even_b_35;
                texels_1_even_odd_odd_b_36 <= texels_1_even_odd_odd_b_35;
                texels_1_odd_even_even_b_36 <= texels_1_odd_even_even_b_35;
                texels_1_odd_even_odd_b_36 <= texels_1_odd_even_odd_b_35;
                texels_1_odd_odd_even_b_36 <= texels_1_odd_odd_even_b_35;
                texels_1_odd_odd_odd_b_36 <= texels_1_odd_odd_odd_b_35;
                square1_b_by_1_36 <= square1_b_by_1_35;
                square1_b_amount_2_36 <= square1_b_amount_2_35;
                square1_b_by_4_36 <= square1_b_by_4_35;
            end if;
        end if;
    end process;

    -- ===== Stage 36: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_37 <= in_gain1r_36;
                in_gain1g_37 <= in_gain1g_36;
                in_gain1b_37 <= in_gain1b_36;
                hidden_37 <= hidden_36;
                v1_is_odd_37 <= v1_is_odd_36;
                u1_even_is_odd_37 <= u1_even_is_odd_36;
                u1_odd_is_odd_37 <= u1_odd_is_odd_36;
                texels_1_even_even_even_r_37 <= texels_1_even_even_even_r_36;
                texels_1_even_even_odd_r_37 <= texels_1_even_even_odd_r_36;
                texels_1_even_odd_even_r_37 <= texels_1_even_odd_even_r_36;
                texels_1_even_odd_odd_r_37 <= texels_1_even_odd_odd_r_36;
                texels_1_odd_even_even_r_37 <= texels_1_odd_even_even_r_36;
                texels_1_odd_even_odd_r_37 <= texels_1_odd_even_odd_r_36;
                texels_1_odd_odd_even_r_37 <= texels_1_odd_odd_even_r_36;
                texels_1_odd_odd_odd_r_37 <= texels_1_odd_odd_odd_r_36;
                u1_even_weight_of_0_37 <= u1_even_weight_of_0_36;
                u1_even_weight_of_1_37 <= u1_even_weight_of_1_36;
                u1_even_weight_of_2_37 <= u1_even_weight_of_2_36;
                u1_even_weight_of_3_37 <= u1_even_weight_of_3_36;
                u1_even_weight_of_4_37 <= u1_even_weight_of_4_36;
                u1_even_weight_of_5_37 <= u1_even_weight_of_5_36;
                u1_odd_weight_of_0_37 <= u1_odd_weight_of_0_36;
                u1_odd_weight_of_1_37 <= u1_odd_weight_of_1_36;
                u1_odd_weight_of_2_37 <= u1_odd_weight_of_2_36;
                u1_odd_weight_of_3_37 <= u1_odd_weight_of_3_36;
                u1_odd_weight_of_4_37 <= u1_odd_weight_of_4_36;
                u1_odd_weight_of_5_37 <= u1_odd_weight_of_5_36;
                v1_weight_of_0_37 <= v1_weight_of_0_36;
                v1_weight_of_1_37 <= v1_weight_of_1_36;
                v1_weight_of_2_37 <= v1_weight_of_2_36;
                v1_weight_of_3_37 <= v1_weight_of_3_36;
                v1_weight_of_4_37 <= v1_weight_of_4_36;
                v1_weight_of_5_37 <= v1_weight_of_5_36;
                blend1_signed_37 <= blend1_signed_36;
                square1_r_by_1_37 <= square1_r_by_1_36;
                square1_r_amount_2_37 <= square1_r_amount_2_36;
                square1_r_by_4_37 <= square1_r_by_4_36;
                texels_1_even_even_even_g_37 <= texels_1_even_even_even_g_36;
                texels_1_even_even_odd_g_37 <= texels_1_even_even_odd_g_36;
                texels_1_even_odd_even_g_37 <= texels_1_even_odd_even_g_36;
                texels_1_even_odd_odd_g_37 <= texels_1_even_odd_odd_g_36;
                texels_1_odd_even_even_g_37 <= texels_1_odd_even_even_g_36;
                texels_1_odd_even_odd_g_37 <= texels_1_odd_even_odd_g_36;
                texels_1_odd_odd_even_g_37 <= texels_1_odd_odd_even_g_36;
                texels_1_odd_odd_odd_g_37 <= texels_1_odd_odd_odd_g_36;
                square1_g_by_1_37 <= square1_g_by_1_36;
                square1_g_amount_2_37 <= square1_g_amount_2_36;
                square1_g_by_4_37 <= square1_g_by_4_36;
                texels_1_even_even_even_b_37 <= texels_1_even_even_even_b_36;
                texels_1_even_even_odd_b_37 <= texels_1_even_even_odd_b_36;
                texels_1_even_odd_even_b_37 <= texels_1_even_odd_even_b_36;
                texels_1_even_odd_odd_b_37 <= texels_1_even_odd_odd_b_36;
                texels_1_odd_even_even_b_37 <= texels_1_odd_even_even_b_36;
                texels_1_odd_even_odd_b_37 <= texels_1_odd_even_odd_b_36;
                texels_1_odd_odd_even_b_37 <= texels_1_odd_odd_even_b_36;
                texels_1_odd_odd_odd_b_37 <= texels_1_odd_odd_odd_b_36;
                square1_b_by_1_37 <= square1_b_by_1_36;
                square1_b_amount_2_37 <= square1_b_amount_2_36;
                square1_b_by_4_37 <= square1_b_by_4_36;
            end if;
        end if;
    end process;

    -- ===== Stage 37: blend1_r_1_0_either_first, blend1_r_1_0_either_0 and 118 more
    -- UQ0.8: either of both
    blend1_r_1_0_either_first_37 <=
        texels_1_even_even_odd_r_37 when u1_even_is_odd_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_0_by_first_37 <= blend1_r_1_0_either_first_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_0_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_0_by_0_37 <= blend1_r_1_0_either_0_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_1_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-5.13: shifted
    blend1_r_1_0_by_1_37 <= blend1_r_1_0_either_1_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_2_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-4.12: shifted
    blend1_r_1_0_by_2_37 <= blend1_r_1_0_either_2_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_3_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-3.11: shifted
    blend1_r_1_0_by_3_37 <= blend1_r_1_0_either_3_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_4_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-2.10: shifted
    blend1_r_1_0_by_4_37 <= blend1_r_1_0_either_4_37;
    -- UQ0.8: either of both
    blend1_r_1_0_either_5_37 <=
        texels_1_even_even_odd_r_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_even_even_r_37;
    -- UQ-1.9: shifted
    blend1_r_1_0_by_5_37 <= blend1_r_1_0_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_r_1_0_sum_1_0_37 <=
        resize(blend1_r_1_0_by_first_37, 9) + resize(blend1_r_1_0_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_r_1_0_sum_1_1_37 <=
        resize(blend1_r_1_0_by_1_37, 10) + shift_left(resize(blend1_r_1_0_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_r_1_0_sum_1_2_37 <=
        resize(blend1_r_1_0_by_3_37, 10) + shift_left(resize(blend1_r_1_0_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_1_either_first_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_is_odd_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_1_by_first_37 <= blend1_r_1_1_either_first_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_0_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_1_by_0_37 <= blend1_r_1_1_either_0_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_1_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-5.13: shifted
    blend1_r_1_1_by_1_37 <= blend1_r_1_1_either_1_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_2_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-4.12: shifted
    blend1_r_1_1_by_2_37 <= blend1_r_1_1_either_2_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_3_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-3.11: shifted
    blend1_r_1_1_by_3_37 <= blend1_r_1_1_either_3_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_4_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-2.10: shifted
    blend1_r_1_1_by_4_37 <= blend1_r_1_1_either_4_37;
    -- UQ0.8: either of both
    blend1_r_1_1_either_5_37 <=
        texels_1_even_odd_odd_r_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_odd_even_r_37;
    -- UQ-1.9: shifted
    blend1_r_1_1_by_5_37 <= blend1_r_1_1_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_r_1_1_sum_1_0_37 <=
        resize(blend1_r_1_1_by_first_37, 9) + resize(blend1_r_1_1_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_r_1_1_sum_1_1_37 <=
        resize(blend1_r_1_1_by_1_37, 10) + shift_left(resize(blend1_r_1_1_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_r_1_1_sum_1_2_37 <=
        resize(blend1_r_1_1_by_3_37, 10) + shift_left(resize(blend1_r_1_1_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_2_either_first_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_2_by_first_37 <= blend1_r_1_2_either_first_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_0_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_2_by_0_37 <= blend1_r_1_2_either_0_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_1_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-5.13: shifted
    blend1_r_1_2_by_1_37 <= blend1_r_1_2_either_1_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_2_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-4.12: shifted
    blend1_r_1_2_by_2_37 <= blend1_r_1_2_either_2_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_3_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-3.11: shifted
    blend1_r_1_2_by_3_37 <= blend1_r_1_2_either_3_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_4_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-2.10: shifted
    blend1_r_1_2_by_4_37 <= blend1_r_1_2_either_4_37;
    -- UQ0.8: either of both
    blend1_r_1_2_either_5_37 <=
        texels_1_odd_even_odd_r_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_even_even_r_37;
    -- UQ-1.9: shifted
    blend1_r_1_2_by_5_37 <= blend1_r_1_2_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_r_1_2_sum_1_0_37 <=
        resize(blend1_r_1_2_by_first_37, 9) + resize(blend1_r_1_2_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_r_1_2_sum_1_1_37 <=
        resize(blend1_r_1_2_by_1_37, 10) + shift_left(resize(blend1_r_1_2_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_r_1_2_sum_1_2_37 <=
        resize(blend1_r_1_2_by_3_37, 10) + shift_left(resize(blend1_r_1_2_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_r_1_3_either_first_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_3_by_first_37 <= blend1_r_1_3_either_first_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_0_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-6.14: shifted
    blend1_r_1_3_by_0_37 <= blend1_r_1_3_either_0_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_1_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-5.13: shifted
    blend1_r_1_3_by_1_37 <= blend1_r_1_3_either_1_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_2_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-4.12: shifted
    blend1_r_1_3_by_2_37 <= blend1_r_1_3_either_2_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_3_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-3.11: shifted
    blend1_r_1_3_by_3_37 <= blend1_r_1_3_either_3_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_4_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-2.10: shifted
    blend1_r_1_3_by_4_37 <= blend1_r_1_3_either_4_37;
    -- UQ0.8: either of both
    blend1_r_1_3_either_5_37 <=
        texels_1_odd_odd_odd_r_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_odd_even_r_37;
    -- UQ-1.9: shifted
    blend1_r_1_3_by_5_37 <= blend1_r_1_3_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_r_1_3_sum_1_0_37 <=
        resize(blend1_r_1_3_by_first_37, 9) + resize(blend1_r_1_3_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_r_1_3_sum_1_1_37 <=
        resize(blend1_r_1_3_by_1_37, 10) + shift_left(resize(blend1_r_1_3_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_r_1_3_sum_1_2_37 <=
        resize(blend1_r_1_3_by_3_37, 10) + shift_left(resize(blend1_r_1_3_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_0_either_first_37 <=
        texels_1_even_even_odd_g_37 when u1_even_is_odd_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_0_by_first_37 <= blend1_g_1_0_either_first_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_0_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_0_by_0_37 <= blend1_g_1_0_either_0_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_1_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-5.13: shifted
    blend1_g_1_0_by_1_37 <= blend1_g_1_0_either_1_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_2_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-4.12: shifted
    blend1_g_1_0_by_2_37 <= blend1_g_1_0_either_2_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_3_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-3.11: shifted
    blend1_g_1_0_by_3_37 <= blend1_g_1_0_either_3_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_4_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-2.10: shifted
    blend1_g_1_0_by_4_37 <= blend1_g_1_0_either_4_37;
    -- UQ0.8: either of both
    blend1_g_1_0_either_5_37 <=
        texels_1_even_even_odd_g_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_even_even_g_37;
    -- UQ-1.9: shifted
    blend1_g_1_0_by_5_37 <= blend1_g_1_0_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_g_1_0_sum_1_0_37 <=
        resize(blend1_g_1_0_by_first_37, 9) + resize(blend1_g_1_0_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_g_1_0_sum_1_1_37 <=
        resize(blend1_g_1_0_by_1_37, 10) + shift_left(resize(blend1_g_1_0_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_g_1_0_sum_1_2_37 <=
        resize(blend1_g_1_0_by_3_37, 10) + shift_left(resize(blend1_g_1_0_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_1_either_first_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_is_odd_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_1_by_first_37 <= blend1_g_1_1_either_first_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_0_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_1_by_0_37 <= blend1_g_1_1_either_0_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_1_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-5.13: shifted
    blend1_g_1_1_by_1_37 <= blend1_g_1_1_either_1_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_2_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-4.12: shifted
    blend1_g_1_1_by_2_37 <= blend1_g_1_1_either_2_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_3_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-3.11: shifted
    blend1_g_1_1_by_3_37 <= blend1_g_1_1_either_3_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_4_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-2.10: shifted
    blend1_g_1_1_by_4_37 <= blend1_g_1_1_either_4_37;
    -- UQ0.8: either of both
    blend1_g_1_1_either_5_37 <=
        texels_1_even_odd_odd_g_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_odd_even_g_37;
    -- UQ-1.9: shifted
    blend1_g_1_1_by_5_37 <= blend1_g_1_1_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_g_1_1_sum_1_0_37 <=
        resize(blend1_g_1_1_by_first_37, 9) + resize(blend1_g_1_1_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_g_1_1_sum_1_1_37 <=
        resize(blend1_g_1_1_by_1_37, 10) + shift_left(resize(blend1_g_1_1_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_g_1_1_sum_1_2_37 <=
        resize(blend1_g_1_1_by_3_37, 10) + shift_left(resize(blend1_g_1_1_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_2_either_first_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_2_by_first_37 <= blend1_g_1_2_either_first_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_0_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_2_by_0_37 <= blend1_g_1_2_either_0_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_1_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-5.13: shifted
    blend1_g_1_2_by_1_37 <= blend1_g_1_2_either_1_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_2_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-4.12: shifted
    blend1_g_1_2_by_2_37 <= blend1_g_1_2_either_2_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_3_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-3.11: shifted
    blend1_g_1_2_by_3_37 <= blend1_g_1_2_either_3_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_4_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-2.10: shifted
    blend1_g_1_2_by_4_37 <= blend1_g_1_2_either_4_37;
    -- UQ0.8: either of both
    blend1_g_1_2_either_5_37 <=
        texels_1_odd_even_odd_g_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_even_even_g_37;
    -- UQ-1.9: shifted
    blend1_g_1_2_by_5_37 <= blend1_g_1_2_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_g_1_2_sum_1_0_37 <=
        resize(blend1_g_1_2_by_first_37, 9) + resize(blend1_g_1_2_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_g_1_2_sum_1_1_37 <=
        resize(blend1_g_1_2_by_1_37, 10) + shift_left(resize(blend1_g_1_2_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_g_1_2_sum_1_2_37 <=
        resize(blend1_g_1_2_by_3_37, 10) + shift_left(resize(blend1_g_1_2_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_g_1_3_either_first_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_3_by_first_37 <= blend1_g_1_3_either_first_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_0_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-6.14: shifted
    blend1_g_1_3_by_0_37 <= blend1_g_1_3_either_0_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_1_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-5.13: shifted
    blend1_g_1_3_by_1_37 <= blend1_g_1_3_either_1_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_2_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-4.12: shifted
    blend1_g_1_3_by_2_37 <= blend1_g_1_3_either_2_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_3_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-3.11: shifted
    blend1_g_1_3_by_3_37 <= blend1_g_1_3_either_3_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_4_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-2.10: shifted
    blend1_g_1_3_by_4_37 <= blend1_g_1_3_either_4_37;
    -- UQ0.8: either of both
    blend1_g_1_3_either_5_37 <=
        texels_1_odd_odd_odd_g_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_odd_even_g_37;
    -- UQ-1.9: shifted
    blend1_g_1_3_by_5_37 <= blend1_g_1_3_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_g_1_3_sum_1_0_37 <=
        resize(blend1_g_1_3_by_first_37, 9) + resize(blend1_g_1_3_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_g_1_3_sum_1_1_37 <=
        resize(blend1_g_1_3_by_1_37, 10) + shift_left(resize(blend1_g_1_3_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_g_1_3_sum_1_2_37 <=
        resize(blend1_g_1_3_by_3_37, 10) + shift_left(resize(blend1_g_1_3_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_0_either_first_37 <=
        texels_1_even_even_odd_b_37 when u1_even_is_odd_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_0_by_first_37 <= blend1_b_1_0_either_first_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_0_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_0_by_0_37 <= blend1_b_1_0_either_0_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_1_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-5.13: shifted
    blend1_b_1_0_by_1_37 <= blend1_b_1_0_either_1_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_2_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-4.12: shifted
    blend1_b_1_0_by_2_37 <= blend1_b_1_0_either_2_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_3_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-3.11: shifted
    blend1_b_1_0_by_3_37 <= blend1_b_1_0_either_3_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_4_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-2.10: shifted
    blend1_b_1_0_by_4_37 <= blend1_b_1_0_either_4_37;
    -- UQ0.8: either of both
    blend1_b_1_0_either_5_37 <=
        texels_1_even_even_odd_b_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_even_even_b_37;
    -- UQ-1.9: shifted
    blend1_b_1_0_by_5_37 <= blend1_b_1_0_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_b_1_0_sum_1_0_37 <=
        resize(blend1_b_1_0_by_first_37, 9) + resize(blend1_b_1_0_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_b_1_0_sum_1_1_37 <=
        resize(blend1_b_1_0_by_1_37, 10) + shift_left(resize(blend1_b_1_0_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_b_1_0_sum_1_2_37 <=
        resize(blend1_b_1_0_by_3_37, 10) + shift_left(resize(blend1_b_1_0_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_1_either_first_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_is_odd_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_1_by_first_37 <= blend1_b_1_1_either_first_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_0_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_0_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_1_by_0_37 <= blend1_b_1_1_either_0_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_1_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_1_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-5.13: shifted
    blend1_b_1_1_by_1_37 <= blend1_b_1_1_either_1_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_2_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_2_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-4.12: shifted
    blend1_b_1_1_by_2_37 <= blend1_b_1_1_either_2_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_3_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_3_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-3.11: shifted
    blend1_b_1_1_by_3_37 <= blend1_b_1_1_either_3_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_4_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_4_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-2.10: shifted
    blend1_b_1_1_by_4_37 <= blend1_b_1_1_either_4_37;
    -- UQ0.8: either of both
    blend1_b_1_1_either_5_37 <=
        texels_1_even_odd_odd_b_37 when u1_even_weight_of_5_37 = '1' else texels_1_even_odd_even_b_37;
    -- UQ-1.9: shifted
    blend1_b_1_1_by_5_37 <= blend1_b_1_1_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_b_1_1_sum_1_0_37 <=
        resize(blend1_b_1_1_by_first_37, 9) + resize(blend1_b_1_1_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_b_1_1_sum_1_1_37 <=
        resize(blend1_b_1_1_by_1_37, 10) + shift_left(resize(blend1_b_1_1_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_b_1_1_sum_1_2_37 <=
        resize(blend1_b_1_1_by_3_37, 10) + shift_left(resize(blend1_b_1_1_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_2_either_first_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_2_by_first_37 <= blend1_b_1_2_either_first_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_0_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_2_by_0_37 <= blend1_b_1_2_either_0_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_1_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-5.13: shifted
    blend1_b_1_2_by_1_37 <= blend1_b_1_2_either_1_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_2_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-4.12: shifted
    blend1_b_1_2_by_2_37 <= blend1_b_1_2_either_2_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_3_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-3.11: shifted
    blend1_b_1_2_by_3_37 <= blend1_b_1_2_either_3_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_4_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-2.10: shifted
    blend1_b_1_2_by_4_37 <= blend1_b_1_2_either_4_37;
    -- UQ0.8: either of both
    blend1_b_1_2_either_5_37 <=
        texels_1_odd_even_odd_b_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_even_even_b_37;
    -- UQ-1.9: shifted
    blend1_b_1_2_by_5_37 <= blend1_b_1_2_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_b_1_2_sum_1_0_37 <=
        resize(blend1_b_1_2_by_first_37, 9) + resize(blend1_b_1_2_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_b_1_2_sum_1_1_37 <=
        resize(blend1_b_1_2_by_1_37, 10) + shift_left(resize(blend1_b_1_2_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_b_1_2_sum_1_2_37 <=
        resize(blend1_b_1_2_by_3_37, 10) + shift_left(resize(blend1_b_1_2_by_4_37, 10), 1);
    -- UQ0.8: either of both
    blend1_b_1_3_either_first_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_is_odd_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_3_by_first_37 <= blend1_b_1_3_either_first_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_0_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_0_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-6.14: shifted
    blend1_b_1_3_by_0_37 <= blend1_b_1_3_either_0_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_1_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_1_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-5.13: shifted
    blend1_b_1_3_by_1_37 <= blend1_b_1_3_either_1_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_2_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_2_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-4.12: shifted
    blend1_b_1_3_by_2_37 <= blend1_b_1_3_either_2_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_3_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_3_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-3.11: shifted
    blend1_b_1_3_by_3_37 <= blend1_b_1_3_either_3_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_4_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_4_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-2.10: shifted
    blend1_b_1_3_by_4_37 <= blend1_b_1_3_either_4_37;
    -- UQ0.8: either of both
    blend1_b_1_3_either_5_37 <=
        texels_1_odd_odd_odd_b_37 when u1_odd_weight_of_5_37 = '1' else texels_1_odd_odd_even_b_37;
    -- UQ-1.9: shifted
    blend1_b_1_3_by_5_37 <= blend1_b_1_3_either_5_37;
    -- UQ-5.14: the sum of two
    blend1_b_1_3_sum_1_0_37 <=
        resize(blend1_b_1_3_by_first_37, 9) + resize(blend1_b_1_3_by_0_37, 9);
    -- UQ-3.13: the sum of two
    blend1_b_1_3_sum_1_1_37 <=
        resize(blend1_b_1_3_by_1_37, 10) + shift_left(resize(blend1_b_1_3_by_2_37, 10), 1);
    -- UQ-1.11: the sum of two
    blend1_b_1_3_sum_1_2_37 <=
        resize(blend1_b_1_3_by_3_37, 10) + shift_left(resize(blend1_b_1_3_by_4_37, 10), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_38 <= in_gain1r_37;
                in_gain1g_38 <= in_gain1g_37;
                in_gain1b_38 <= in_gain1b_37;
                hidden_38 <= hidden_37;
                v1_is_odd_38 <= v1_is_odd_37;
                blend1_r_1_0_by_5_38 <= blend1_r_1_0_by_5_37;
                blend1_r_1_0_sum_1_0_38 <= blend1_r_1_0_sum_1_0_37;
                blend1_r_1_0_sum_1_1_38 <= blend1_r_1_0_sum_1_1_37;
                blend1_r_1_0_sum_1_2_38 <= blend1_r_1_0_sum_1_2_37;
                blend1_r_1_1_by_5_38 <= blend1_r_1_1_by_5_37;
                blend1_r_1_1_sum_1_0_38 <= blend1_r_1_1_sum_1_0_37;
                blend1_r_1_1_sum_1_1_38 <= blend1_r_1_1_sum_1_1_37;
                blend1_r_1_1_sum_1_2_38 <= blend1_r_1_1_sum_1_2_37;
                blend1_r_1_2_by_5_38 <= blend1_r_1_2_by_5_37;
                blend1_r_1_2_sum_1_0_38 <= blend1_r_1_2_sum_1_0_37;
                blend1_r_1_2_sum_1_1_38 <= blend1_r_1_2_sum_1_1_37;
                blend1_r_1_2_sum_1_2_38 <= blend1_r_1_2_sum_1_2_37;
                blend1_r_1_3_by_5_38 <= blend1_r_1_3_by_5_37;
                blend1_r_1_3_sum_1_0_38 <= blend1_r_1_3_sum_1_0_37;
                blend1_r_1_3_sum_1_1_38 <= blend1_r_1_3_sum_1_1_37;
                blend1_r_1_3_sum_1_2_38 <= blend1_r_1_3_sum_1_2_37;
                v1_weight_of_0_38 <= v1_weight_of_0_37;
                v1_weight_of_1_38 <= v1_weight_of_1_37;
                v1_weight_of_2_38 <= v1_weight_of_2_37;
                v1_weight_of_3_38 <= v1_weight_of_3_37;
                v1_weight_of_4_38 <= v1_weight_of_4_37;
                v1_weight_of_5_38 <= v1_weight_of_5_37;
                blend1_signed_38 <= blend1_signed_37;
                square1_r_by_1_38 <= square1_r_by_1_37;
                square1_r_amount_2_38 <= square1_r_amount_2_37;
                square1_r_by_4_38 <= square1_r_by_4_37;
                blend1_g_1_0_by_5_38 <= blend1_g_1_0_by_5_37;
                blend1_g_1_0_sum_1_0_38 <= blend1_g_1_0_sum_1_0_37;
                blend1_g_1_0_sum_1_1_38 <= blend1_g_1_0_sum_1_1_37;
                blend1_g_1_0_sum_1_2_38 <= blend1_g_1_0_sum_1_2_37;
                blend1_g_1_1_by_5_38 <= blend1_g_1_1_by_5_37;
                blend1_g_1_1_sum_1_0_38 <= blend1_g_1_1_sum_1_0_37;
                blend1_g_1_1_sum_1_1_38 <= blend1_g_1_1_sum_1_1_37;
                blend1_g_1_1_sum_1_2_38 <= blend1_g_1_1_sum_1_2_37;
                blend1_g_1_2_by_5_38 <= blend1_g_1_2_by_5_37;
                blend1_g_1_2_sum_1_0_38 <= blend1_g_1_2_sum_1_0_37;
                blend1_g_1_2_sum_1_1_38 <= blend1_g_1_2_sum_1_1_37;
                blend1_g_1_2_sum_1_2_38 <= blend1_g_1_2_sum_1_2_37;
                blend1_g_1_3_by_5_38 <= blend1_g_1_3_by_5_37;
                blend1_g_1_3_sum_1_0_38 <= blend1_g_1_3_sum_1_0_37;
                blend1_g_1_3_sum_1_1_38 <= blend1_g_1_3_sum_1_1_37;
                blend1_g_1_3_sum_1_2_38 <= blend1_g_1_3_sum_1_2_37;
                square1_g_by_1_38 <= square1_g_by_1_37;
                square1_g_amount_2_38 <= square1_g_amount_2_37;
                square1_g_by_4_38 <= square1_g_by_4_37;
                blend1_b_1_0_by_5_38 <= blend1_b_1_0_by_5_37;
                blend1_b_1_0_sum_1_0_38 <= blend1_b_1_0_sum_1_0_37;
                blend1_b_1_0_sum_1_1_38 <= blend1_b_1_0_sum_1_1_37;
                blend1_b_1_0_sum_1_2_38 <= blend1_b_1_0_sum_1_2_37;
                blend1_b_1_1_by_5_38 <= blend1_b_1_1_by_5_37;
                blend1_b_1_1_sum_1_0_38 <= blend1_b_1_1_sum_1_0_37;
                blend1_b_1_1_sum_1_1_38 <= blend1_b_1_1_sum_1_1_37;
                blend1_b_1_1_sum_1_2_38 <= blend1_b_1_1_sum_1_2_37;
                blend1_b_1_2_by_5_38 <= blend1_b_1_2_by_5_37;
                blend1_b_1_2_sum_1_0_38 <= blend1_b_1_2_sum_1_0_37;
                blend1_b_1_2_sum_1_1_38 <= blend1_b_1_2_sum_1_1_37;
                blend1_b_1_2_sum_1_2_38 <= blend1_b_1_2_sum_1_2_37;
                blend1_b_1_3_by_5_38 <= blend1_b_1_3_by_5_37;
                blend1_b_1_3_sum_1_0_38 <= blend1_b_1_3_sum_1_0_37;
                blend1_b_1_3_sum_1_1_38 <= blend1_b_1_3_sum_1_1_37;
                blend1_b_1_3_sum_1_2_38 <= blend1_b_1_3_sum_1_2_37;
                square1_b_by_1_38 <= square1_b_by_1_37;
                square1_b_amount_2_38 <= square1_b_amount_2_37;
                square1_b_by_4_38 <= square1_b_by_4_37;
            end if;
        end if;
    end process;

    -- ===== Stage 38: blend1_r_1_0_sum_2_0, blend1_r_1_0_sum_2_1 and 22 more
    -- UQ-3.14: the sum of two
    blend1_r_1_0_sum_2_0_38 <=
        resize(blend1_r_1_0_sum_1_0_38, 11) + shift_left(resize(blend1_r_1_0_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_r_1_0_sum_2_1_38 <=
        resize(blend1_r_1_0_sum_1_2_38, 11) + shift_left(resize(blend1_r_1_0_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_r_1_1_sum_2_0_38 <=
        resize(blend1_r_1_1_sum_1_0_38, 11) + shift_left(resize(blend1_r_1_1_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_r_1_1_sum_2_1_38 <=
        resize(blend1_r_1_1_sum_1_2_38, 11) + shift_left(resize(blend1_r_1_1_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_r_1_2_sum_2_0_38 <=
        resize(blend1_r_1_2_sum_1_0_38, 11) + shift_left(resize(blend1_r_1_2_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_r_1_2_sum_2_1_38 <=
        resize(blend1_r_1_2_sum_1_2_38, 11) + shift_left(resize(blend1_r_1_2_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_r_1_3_sum_2_0_38 <=
        resize(blend1_r_1_3_sum_1_0_38, 11) + shift_left(resize(blend1_r_1_3_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_r_1_3_sum_2_1_38 <=
        resize(blend1_r_1_3_sum_1_2_38, 11) + shift_left(resize(blend1_r_1_3_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_g_1_0_sum_2_0_38 <=
        resize(blend1_g_1_0_sum_1_0_38, 11) + shift_left(resize(blend1_g_1_0_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_g_1_0_sum_2_1_38 <=
        resize(blend1_g_1_0_sum_1_2_38, 11) + shift_left(resize(blend1_g_1_0_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_g_1_1_sum_2_0_38 <=
        resize(blend1_g_1_1_sum_1_0_38, 11) + shift_left(resize(blend1_g_1_1_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_g_1_1_sum_2_1_38 <=
        resize(blend1_g_1_1_sum_1_2_38, 11) + shift_left(resize(blend1_g_1_1_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_g_1_2_sum_2_0_38 <=
        resize(blend1_g_1_2_sum_1_0_38, 11) + shift_left(resize(blend1_g_1_2_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_g_1_2_sum_2_1_38 <=
        resize(blend1_g_1_2_sum_1_2_38, 11) + shift_left(resize(blend1_g_1_2_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_g_1_3_sum_2_0_38 <=
        resize(blend1_g_1_3_sum_1_0_38, 11) + shift_left(resize(blend1_g_1_3_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_g_1_3_sum_2_1_38 <=
        resize(blend1_g_1_3_sum_1_2_38, 11) + shift_left(resize(blend1_g_1_3_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_b_1_0_sum_2_0_38 <=
        resize(blend1_b_1_0_sum_1_0_38, 11) + shift_left(resize(blend1_b_1_0_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_b_1_0_sum_2_1_38 <=
        resize(blend1_b_1_0_sum_1_2_38, 11) + shift_left(resize(blend1_b_1_0_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_b_1_1_sum_2_0_38 <=
        resize(blend1_b_1_1_sum_1_0_38, 11) + shift_left(resize(blend1_b_1_1_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_b_1_1_sum_2_1_38 <=
        resize(blend1_b_1_1_sum_1_2_38, 11) + shift_left(resize(blend1_b_1_1_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_b_1_2_sum_2_0_38 <=
        resize(blend1_b_1_2_sum_1_0_38, 11) + shift_left(resize(blend1_b_1_2_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_b_1_2_sum_2_1_38 <=
        resize(blend1_b_1_2_sum_1_2_38, 11) + shift_left(resize(blend1_b_1_2_by_5_38, 11), 2);
    -- UQ-3.14: the sum of two
    blend1_b_1_3_sum_2_0_38 <=
        resize(blend1_b_1_3_sum_1_0_38, 11) + shift_left(resize(blend1_b_1_3_sum_1_1_38, 11), 1);
    -- UQ0.11: the sum of two
    blend1_b_1_3_sum_2_1_38 <=
        resize(blend1_b_1_3_sum_1_2_38, 11) + shift_left(resize(blend1_b_1_3_by_5_38, 11), 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_39 <= in_gain1r_38;
                in_gain1g_39 <= in_gain1g_38;
                in_gain1b_39 <= in_gain1b_38;
                hidden_39 <= hidden_38;
                v1_is_odd_39 <= v1_is_odd_38;
                blend1_r_1_0_sum_2_0_39 <= blend1_r_1_0_sum_2_0_38;
                blend1_r_1_0_sum_2_1_39 <= blend1_r_1_0_sum_2_1_38;
                blend1_r_1_1_sum_2_0_39 <= blend1_r_1_1_sum_2_0_38;
                blend1_r_1_1_sum_2_1_39 <= blend1_r_1_1_sum_2_1_38;
                blend1_r_1_2_sum_2_0_39 <= blend1_r_1_2_sum_2_0_38;
                blend1_r_1_2_sum_2_1_39 <= blend1_r_1_2_sum_2_1_38;
                blend1_r_1_3_sum_2_0_39 <= blend1_r_1_3_sum_2_0_38;
                blend1_r_1_3_sum_2_1_39 <= blend1_r_1_3_sum_2_1_38;
                v1_weight_of_0_39 <= v1_weight_of_0_38;
                v1_weight_of_1_39 <= v1_weight_of_1_38;
                v1_weight_of_2_39 <= v1_weight_of_2_38;
                v1_weight_of_3_39 <= v1_weight_of_3_38;
                v1_weight_of_4_39 <= v1_weight_of_4_38;
                v1_weight_of_5_39 <= v1_weight_of_5_38;
                blend1_signed_39 <= blend1_signed_38;
                square1_r_by_1_39 <= square1_r_by_1_38;
                square1_r_amount_2_39 <= square1_r_amount_2_38;
                square1_r_by_4_39 <= square1_r_by_4_38;
                blend1_g_1_0_sum_2_0_39 <= blend1_g_1_0_sum_2_0_38;
                blend1_g_1_0_sum_2_1_39 <= blend1_g_1_0_sum_2_1_38;
                blend1_g_1_1_sum_2_0_39 <= blend1_g_1_1_sum_2_0_38;
                blend1_g_1_1_sum_2_1_39 <= blend1_g_1_1_sum_2_1_38;
                blend1_g_1_2_sum_2_0_39 <= blend1_g_1_2_sum_2_0_38;
                blend1_g_1_2_sum_2_1_39 <= blend1_g_1_2_sum_2_1_38;
                blend1_g_1_3_sum_2_0_39 <= blend1_g_1_3_sum_2_0_38;
                blend1_g_1_3_sum_2_1_39 <= blend1_g_1_3_sum_2_1_38;
                square1_g_by_1_39 <= square1_g_by_1_38;
                square1_g_amount_2_39 <= square1_g_amount_2_38;
                square1_g_by_4_39 <= square1_g_by_4_38;
                blend1_b_1_0_sum_2_0_39 <= blend1_b_1_0_sum_2_0_38;
                blend1_b_1_0_sum_2_1_39 <= blend1_b_1_0_sum_2_1_38;
                blend1_b_1_1_sum_2_0_39 <= blend1_b_1_1_sum_2_0_38;
                blend1_b_1_1_sum_2_1_39 <= blend1_b_1_1_sum_2_1_38;
                blend1_b_1_2_sum_2_0_39 <= blend1_b_1_2_sum_2_0_38;
                blend1_b_1_2_sum_2_1_39 <= blend1_b_1_2_sum_2_1_38;
                blend1_b_1_3_sum_2_0_39 <= blend1_b_1_3_sum_2_0_38;
                blend1_b_1_3_sum_2_1_39 <= blend1_b_1_3_sum_2_1_38;
                square1_b_by_1_39 <= square1_b_by_1_38;
                square1_b_amount_2_39 <= square1_b_amount_2_38;
                square1_b_by_4_39 <= square1_b_by_4_38;
            end if;
        end if;
    end process;

    -- ===== Stage 39: blend1_r_1_0, blend1_r_1_1, blend1_r_1_2, blend1_r_1_3 and 50 more
    -- UQ0.14: two neighbours
    blend1_r_1_0_39 <=
        resize(blend1_r_1_0_sum_2_0_39, 14) + shift_left(resize(blend1_r_1_0_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_r_1_1_39 <=
        resize(blend1_r_1_1_sum_2_0_39, 14) + shift_left(resize(blend1_r_1_1_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_r_1_2_39 <=
        resize(blend1_r_1_2_sum_2_0_39, 14) + shift_left(resize(blend1_r_1_2_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_r_1_3_39 <=
        resize(blend1_r_1_3_sum_2_0_39, 14) + shift_left(resize(blend1_r_1_3_sum_2_1_39, 14), 3);
    -- UQ0.14: either of both
    blend1_r_2_0_either_first_39 <= blend1_r_1_1_39 when v1_is_odd_39 = '1' else blend1_r_1_0_39;
    -- UQ-6.20: shifted
    blend1_r_2_0_by_first_39 <= blend1_r_2_0_either_first_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_0_39 <= blend1_r_1_1_39 when v1_weight_of_0_39 = '1' else blend1_r_1_0_39;
    -- UQ-6.20: shifted
    blend1_r_2_0_by_0_39 <= blend1_r_2_0_either_0_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_1_39 <= blend1_r_1_1_39 when v1_weight_of_1_39 = '1' else blend1_r_1_0_39;
    -- UQ-5.19: shifted
    blend1_r_2_0_by_1_39 <= blend1_r_2_0_either_1_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_2_39 <= blend1_r_1_1_39 when v1_weight_of_2_39 = '1' else blend1_r_1_0_39;
    -- UQ-4.18: shifted
    blend1_r_2_0_by_2_39 <= blend1_r_2_0_either_2_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_3_39 <= blend1_r_1_1_39 when v1_weight_of_3_39 = '1' else blend1_r_1_0_39;
    -- UQ-3.17: shifted
    blend1_r_2_0_by_3_39 <= blend1_r_2_0_either_3_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_4_39 <= blend1_r_1_1_39 when v1_weight_of_4_39 = '1' else blend1_r_1_0_39;
    -- UQ-2.16: shifted
    blend1_r_2_0_by_4_39 <= blend1_r_2_0_either_4_39;
    -- UQ0.14: either of both
    blend1_r_2_0_either_5_39 <= blend1_r_1_1_39 when v1_weight_of_5_39 = '1' else blend1_r_1_0_39;
    -- UQ-1.15: shifted
    blend1_r_2_0_by_5_39 <= blend1_r_2_0_either_5_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_first_39 <= blend1_r_1_3_39 when v1_is_odd_39 = '1' else blend1_r_1_2_39;
    -- UQ-6.20: shifted
    blend1_r_2_1_by_first_39 <= blend1_r_2_1_either_first_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_0_39 <= blend1_r_1_3_39 when v1_weight_of_0_39 = '1' else blend1_r_1_2_39;
    -- UQ-6.20: shifted
    blend1_r_2_1_by_0_39 <= blend1_r_2_1_either_0_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_1_39 <= blend1_r_1_3_39 when v1_weight_of_1_39 = '1' else blend1_r_1_2_39;
    -- UQ-5.19: shifted
    blend1_r_2_1_by_1_39 <= blend1_r_2_1_either_1_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_2_39 <= blend1_r_1_3_39 when v1_weight_of_2_39 = '1' else blend1_r_1_2_39;
    -- UQ-4.18: shifted
    blend1_r_2_1_by_2_39 <= blend1_r_2_1_either_2_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_3_39 <= blend1_r_1_3_39 when v1_weight_of_3_39 = '1' else blend1_r_1_2_39;
    -- UQ-3.17: shifted
    blend1_r_2_1_by_3_39 <= blend1_r_2_1_either_3_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_4_39 <= blend1_r_1_3_39 when v1_weight_of_4_39 = '1' else blend1_r_1_2_39;
    -- UQ-2.16: shifted
    blend1_r_2_1_by_4_39 <= blend1_r_2_1_either_4_39;
    -- UQ0.14: either of both
    blend1_r_2_1_either_5_39 <= blend1_r_1_3_39 when v1_weight_of_5_39 = '1' else blend1_r_1_2_39;
    -- UQ-1.15: shifted
    blend1_r_2_1_by_5_39 <= blend1_r_2_1_either_5_39;
    -- UQ0.14: two neighbours
    blend1_g_1_0_39 <=
        resize(blend1_g_1_0_sum_2_0_39, 14) + shift_left(resize(blend1_g_1_0_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_g_1_1_39 <=
        resize(blend1_g_1_1_sum_2_0_39, 14) + shift_left(resize(blend1_g_1_1_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_g_1_2_39 <=
        resize(blend1_g_1_2_sum_2_0_39, 14) + shift_left(resize(blend1_g_1_2_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_g_1_3_39 <=
        resize(blend1_g_1_3_sum_2_0_39, 14) + shift_left(resize(blend1_g_1_3_sum_2_1_39, 14), 3);
    -- UQ0.14: either of both
    blend1_g_2_0_either_first_39 <= blend1_g_1_1_39 when v1_is_odd_39 = '1' else blend1_g_1_0_39;
    -- UQ-6.20: shifted
    blend1_g_2_0_by_first_39 <= blend1_g_2_0_either_first_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_0_39 <= blend1_g_1_1_39 when v1_weight_of_0_39 = '1' else blend1_g_1_0_39;
    -- UQ-6.20: shifted
    blend1_g_2_0_by_0_39 <= blend1_g_2_0_either_0_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_1_39 <= blend1_g_1_1_39 when v1_weight_of_1_39 = '1' else blend1_g_1_0_39;
    -- UQ-5.19: shifted
    blend1_g_2_0_by_1_39 <= blend1_g_2_0_either_1_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_2_39 <= blend1_g_1_1_39 when v1_weight_of_2_39 = '1' else blend1_g_1_0_39;
    -- UQ-4.18: shifted
    blend1_g_2_0_by_2_39 <= blend1_g_2_0_either_2_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_3_39 <= blend1_g_1_1_39 when v1_weight_of_3_39 = '1' else blend1_g_1_0_39;
    -- UQ-3.17: shifted
    blend1_g_2_0_by_3_39 <= blend1_g_2_0_either_3_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_4_39 <= blend1_g_1_1_39 when v1_weight_of_4_39 = '1' else blend1_g_1_0_39;
    -- UQ-2.16: shifted
    blend1_g_2_0_by_4_39 <= blend1_g_2_0_either_4_39;
    -- UQ0.14: either of both
    blend1_g_2_0_either_5_39 <= blend1_g_1_1_39 when v1_weight_of_5_39 = '1' else blend1_g_1_0_39;
    -- UQ-1.15: shifted
    blend1_g_2_0_by_5_39 <= blend1_g_2_0_either_5_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_first_39 <= blend1_g_1_3_39 when v1_is_odd_39 = '1' else blend1_g_1_2_39;
    -- UQ-6.20: shifted
    blend1_g_2_1_by_first_39 <= blend1_g_2_1_either_first_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_0_39 <= blend1_g_1_3_39 when v1_weight_of_0_39 = '1' else blend1_g_1_2_39;
    -- UQ-6.20: shifted
    blend1_g_2_1_by_0_39 <= blend1_g_2_1_either_0_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_1_39 <= blend1_g_1_3_39 when v1_weight_of_1_39 = '1' else blend1_g_1_2_39;
    -- UQ-5.19: shifted
    blend1_g_2_1_by_1_39 <= blend1_g_2_1_either_1_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_2_39 <= blend1_g_1_3_39 when v1_weight_of_2_39 = '1' else blend1_g_1_2_39;
    -- UQ-4.18: shifted
    blend1_g_2_1_by_2_39 <= blend1_g_2_1_either_2_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_3_39 <= blend1_g_1_3_39 when v1_weight_of_3_39 = '1' else blend1_g_1_2_39;
    -- UQ-3.17: shifted
    blend1_g_2_1_by_3_39 <= blend1_g_2_1_either_3_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_4_39 <= blend1_g_1_3_39 when v1_weight_of_4_39 = '1' else blend1_g_1_2_39;
    -- UQ-2.16: shifted
    blend1_g_2_1_by_4_39 <= blend1_g_2_1_either_4_39;
    -- UQ0.14: either of both
    blend1_g_2_1_either_5_39 <= blend1_g_1_3_39 when v1_weight_of_5_39 = '1' else blend1_g_1_2_39;
    -- UQ-1.15: shifted
    blend1_g_2_1_by_5_39 <= blend1_g_2_1_either_5_39;
    -- UQ0.14: two neighbours
    blend1_b_1_0_39 <=
        resize(blend1_b_1_0_sum_2_0_39, 14) + shift_left(resize(blend1_b_1_0_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_b_1_1_39 <=
        resize(blend1_b_1_1_sum_2_0_39, 14) + shift_left(resize(blend1_b_1_1_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_b_1_2_39 <=
        resize(blend1_b_1_2_sum_2_0_39, 14) + shift_left(resize(blend1_b_1_2_sum_2_1_39, 14), 3);
    -- UQ0.14: two neighbours
    blend1_b_1_3_39 <=
        resize(blend1_b_1_3_sum_2_0_39, 14) + shift_left(resize(blend1_b_1_3_sum_2_1_39, 14), 3);
    -- UQ0.14: either of both
    blend1_b_2_0_either_first_39 <= blend1_b_1_1_39 when v1_is_odd_39 = '1' else blend1_b_1_0_39;
    -- UQ-6.20: shifted
    blend1_b_2_0_by_first_39 <= blend1_b_2_0_either_first_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_0_39 <= blend1_b_1_1_39 when v1_weight_of_0_39 = '1' else blend1_b_1_0_39;
    -- UQ-6.20: shifted
    blend1_b_2_0_by_0_39 <= blend1_b_2_0_either_0_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_1_39 <= blend1_b_1_1_39 when v1_weight_of_1_39 = '1' else blend1_b_1_0_39;
    -- UQ-5.19: shifted
    blend1_b_2_0_by_1_39 <= blend1_b_2_0_either_1_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_2_39 <= blend1_b_1_1_39 when v1_weight_of_2_39 = '1' else blend1_b_1_0_39;
    -- UQ-4.18: shifted
    blend1_b_2_0_by_2_39 <= blend1_b_2_0_either_2_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_3_39 <= blend1_b_1_1_39 when v1_weight_of_3_39 = '1' else blend1_b_1_0_39;
    -- UQ-3.17: shifted
    blend1_b_2_0_by_3_39 <= blend1_b_2_0_either_3_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_4_39 <= blend1_b_1_1_39 when v1_weight_of_4_39 = '1' else blend1_b_1_0_39;
    -- UQ-2.16: shifted
    blend1_b_2_0_by_4_39 <= blend1_b_2_0_either_4_39;
    -- UQ0.14: either of both
    blend1_b_2_0_either_5_39 <= blend1_b_1_1_39 when v1_weight_of_5_39 = '1' else blend1_b_1_0_39;
    -- UQ-1.15: shifted
    blend1_b_2_0_by_5_39 <= blend1_b_2_0_either_5_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_first_39 <= blend1_b_1_3_39 when v1_is_odd_39 = '1' else blend1_b_1_2_39;
    -- UQ-6.20: shifted
    blend1_b_2_1_by_first_39 <= blend1_b_2_1_either_first_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_0_39 <= blend1_b_1_3_39 when v1_weight_of_0_39 = '1' else blend1_b_1_2_39;
    -- UQ-6.20: shifted
    blend1_b_2_1_by_0_39 <= blend1_b_2_1_either_0_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_1_39 <= blend1_b_1_3_39 when v1_weight_of_1_39 = '1' else blend1_b_1_2_39;
    -- UQ-5.19: shifted
    blend1_b_2_1_by_1_39 <= blend1_b_2_1_either_1_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_2_39 <= blend1_b_1_3_39 when v1_weight_of_2_39 = '1' else blend1_b_1_2_39;
    -- UQ-4.18: shifted
    blend1_b_2_1_by_2_39 <= blend1_b_2_1_either_2_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_3_39 <= blend1_b_1_3_39 when v1_weight_of_3_39 = '1' else blend1_b_1_2_39;
    -- UQ-3.17: shifted
    blend1_b_2_1_by_3_39 <= blend1_b_2_1_either_3_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_4_39 <= blend1_b_1_3_39 when v1_weight_of_4_39 = '1' else blend1_b_1_2_39;
    -- UQ-2.16: shifted
    blend1_b_2_1_by_4_39 <= blend1_b_2_1_either_4_39;
    -- UQ0.14: either of both
    blend1_b_2_1_either_5_39 <= blend1_b_1_3_39 when v1_weight_of_5_39 = '1' else blend1_b_1_2_39;
    -- UQ-1.15: shifted
    blend1_b_2_1_by_5_39 <= blend1_b_2_1_either_5_39;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_40 <= in_gain1r_39;
                in_gain1g_40 <= in_gain1g_39;
                in_gain1b_40 <= in_gain1b_39;
                hidden_40 <= hidden_39;
                blend1_r_2_0_by_first_40 <= blend1_r_2_0_by_first_39;
                blend1_r_2_0_by_0_40 <= blend1_r_2_0_by_0_39;
                blend1_r_2_0_by_1_40 <= blend1_r_2_0_by_1_39;
                blend1_r_2_0_by_2_40 <= blend1_r_2_0_by_2_39;
                blend1_r_2_0_by_3_40 <= blend1_r_2_0_by_3_39;
                blend1_r_2_0_by_4_40 <= blend1_r_2_0_by_4_39;
                blend1_r_2_0_by_5_40 <= blend1_r_2_0_by_5_39;
                blend1_r_2_1_by_first_40 <= blend1_r_2_1_by_first_39;
                blend1_r_2_1_by_0_40 <= blend1_r_2_1_by_0_39;
                blend1_r_2_1_by_1_40 <= blend1_r_2_1_by_1_39;
                blend1_r_2_1_by_2_40 <= blend1_r_2_1_by_2_39;
                blend1_r_2_1_by_3_40 <= blend1_r_2_1_by_3_39;
                blend1_r_2_1_by_4_40 <= blend1_r_2_1_by_4_39;
                blend1_r_2_1_by_5_40 <= blend1_r_2_1_by_5_39;
                blend1_signed_40 <= blend1_signed_39;
                square1_r_by_1_40 <= square1_r_by_1_39;
                square1_r_amount_2_40 <= square1_r_amount_2_39;
                square1_r_by_4_40 <= square1_r_by_4_39;
                blend1_g_2_0_by_first_40 <= blend1_g_2_0_by_first_39;
                blend1_g_2_0_by_0_40 <= blend1_g_2_0_by_0_39;
                blend1_g_2_0_by_1_40 <= blend1_g_2_0_by_1_39;
                blend1_g_2_0_by_2_40 <= blend1_g_2_0_by_2_39;
                blend1_g_2_0_by_3_40 <= blend1_g_2_0_by_3_39;
                blend1_g_2_0_by_4_40 <= blend1_g_2_0_by_4_39;
                blend1_g_2_0_by_5_40 <= blend1_g_2_0_by_5_39;
                blend1_g_2_1_by_first_40 <= blend1_g_2_1_by_first_39;
                blend1_g_2_1_by_0_40 <= blend1_g_2_1_by_0_39;
                blend1_g_2_1_by_1_40 <= blend1_g_2_1_by_1_39;
                blend1_g_2_1_by_2_40 <= blend1_g_2_1_by_2_39;
                blend1_g_2_1_by_3_40 <= blend1_g_2_1_by_3_39;
                blend1_g_2_1_by_4_40 <= blend1_g_2_1_by_4_39;
                blend1_g_2_1_by_5_40 <= blend1_g_2_1_by_5_39;
                square1_g_by_1_40 <= square1_g_by_1_39;
                square1_g_amount_2_40 <= square1_g_amount_2_39;
                square1_g_by_4_40 <= square1_g_by_4_39;
                blend1_b_2_0_by_first_40 <= blend1_b_2_0_by_first_39;
                blend1_b_2_0_by_0_40 <= blend1_b_2_0_by_0_39;
                blend1_b_2_0_by_1_40 <= blend1_b_2_0_by_1_39;
                blend1_b_2_0_by_2_40 <= blend1_b_2_0_by_2_39;
                blend1_b_2_0_by_3_40 <= blend1_b_2_0_by_3_39;
                blend1_b_2_0_by_4_40 <= blend1_b_2_0_by_4_39;
                blend1_b_2_0_by_5_40 <= blend1_b_2_0_by_5_39;
                blend1_b_2_1_by_first_40 <= blend1_b_2_1_by_first_39;
                blend1_b_2_1_by_0_40 <= blend1_b_2_1_by_0_39;
                blend1_b_2_1_by_1_40 <= blend1_b_2_1_by_1_39;
                blend1_b_2_1_by_2_40 <= blend1_b_2_1_by_2_39;
                blend1_b_2_1_by_3_40 <= blend1_b_2_1_by_3_39;
                blend1_b_2_1_by_4_40 <= blend1_b_2_1_by_4_39;
                blend1_b_2_1_by_5_40 <= blend1_b_2_1_by_5_39;
                square1_b_by_1_40 <= square1_b_by_1_39;
                square1_b_amount_2_40 <= square1_b_amount_2_39;
                square1_b_by_4_40 <= square1_b_by_4_39;
            end if;
        end if;
    end process;

    -- ===== Stage 40: blend1_r_2_0_sum_1_0, blend1_r_2_0_sum_1_1 and 16 more
    -- UQ-5.20: the sum of two
    blend1_r_2_0_sum_1_0_40 <=
        resize(blend1_r_2_0_by_first_40, 15) + resize(blend1_r_2_0_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_r_2_0_sum_1_1_40 <=
        resize(blend1_r_2_0_by_1_40, 16) + shift_left(resize(blend1_r_2_0_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_r_2_0_sum_1_2_40 <=
        resize(blend1_r_2_0_by_3_40, 16) + shift_left(resize(blend1_r_2_0_by_4_40, 16), 1);
    -- UQ-5.20: the sum of two
    blend1_r_2_1_sum_1_0_40 <=
        resize(blend1_r_2_1_by_first_40, 15) + resize(blend1_r_2_1_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_r_2_1_sum_1_1_40 <=
        resize(blend1_r_2_1_by_1_40, 16) + shift_left(resize(blend1_r_2_1_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_r_2_1_sum_1_2_40 <=
        resize(blend1_r_2_1_by_3_40, 16) + shift_left(resize(blend1_r_2_1_by_4_40, 16), 1);
    -- UQ-5.20: the sum of two
    blend1_g_2_0_sum_1_0_40 <=
        resize(blend1_g_2_0_by_first_40, 15) + resize(blend1_g_2_0_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_g_2_0_sum_1_1_40 <=
        resize(blend1_g_2_0_by_1_40, 16) + shift_left(resize(blend1_g_2_0_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_g_2_0_sum_1_2_40 <=
        resize(blend1_g_2_0_by_3_40, 16) + shift_left(resize(blend1_g_2_0_by_4_40, 16), 1);
    -- UQ-5.20: the sum of two
    blend1_g_2_1_sum_1_0_40 <=
        resize(blend1_g_2_1_by_first_40, 15) + resize(blend1_g_2_1_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_g_2_1_sum_1_1_40 <=
        resize(blend1_g_2_1_by_1_40, 16) + shift_left(resize(blend1_g_2_1_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_g_2_1_sum_1_2_40 <=
        resize(blend1_g_2_1_by_3_40, 16) + shift_left(resize(blend1_g_2_1_by_4_40, 16), 1);
    -- UQ-5.20: the sum of two
    blend1_b_2_0_sum_1_0_40 <=
        resize(blend1_b_2_0_by_first_40, 15) + resize(blend1_b_2_0_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_b_2_0_sum_1_1_40 <=
        resize(blend1_b_2_0_by_1_40, 16) + shift_left(resize(blend1_b_2_0_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_b_2_0_sum_1_2_40 <=
        resize(blend1_b_2_0_by_3_40, 16) + shift_left(resize(blend1_b_2_0_by_4_40, 16), 1);
    -- UQ-5.20: the sum of two
    blend1_b_2_1_sum_1_0_40 <=
        resize(blend1_b_2_1_by_first_40, 15) + resize(blend1_b_2_1_by_0_40, 15);
    -- UQ-3.19: the sum of two
    blend1_b_2_1_sum_1_1_40 <=
        resize(blend1_b_2_1_by_1_40, 16) + shift_left(resize(blend1_b_2_1_by_2_40, 16), 1);
    -- UQ-1.17: the sum of two
    blend1_b_2_1_sum_1_2_40 <=
        resize(blend1_b_2_1_by_3_40, 16) + shift_left(resize(blend1_b_2_1_by_4_40, 16), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_41 <= in_gain1r_40;
                in_gain1g_41 <= in_gain1g_40;
                in_gain1b_41 <= in_gain1b_40;
                hidden_41 <= hidden_40;
                blend1_r_2_0_by_5_41 <= blend1_r_2_0_by_5_40;
                blend1_r_2_0_sum_1_0_41 <= blend1_r_2_0_sum_1_0_40;
                blend1_r_2_0_sum_1_1_41 <= blend1_r_2_0_sum_1_1_40;
                blend1_r_2_0_sum_1_2_41 <= blend1_r_2_0_sum_1_2_40;
                blend1_r_2_1_by_5_41 <= blend1_r_2_1_by_5_40;
                blend1_r_2_1_sum_1_0_41 <= blend1_r_2_1_sum_1_0_40;
                blend1_r_2_1_sum_1_1_41 <= blend1_r_2_1_sum_1_1_40;
                blend1_r_2_1_sum_1_2_41 <= blend1_r_2_1_sum_1_2_40;
                blend1_signed_41 <= blend1_signed_40;
                square1_r_by_1_41 <= square1_r_by_1_40;
                square1_r_amount_2_41 <= square1_r_amount_2_40;
                square1_r_by_4_41 <= square1_r_by_4_40;
                blend1_g_2_0_by_5_41 <= blend1_g_2_0_by_5_40;
                blend1_g_2_0_sum_1_0_41 <= blend1_g_2_0_sum_1_0_40;
                blend1_g_2_0_sum_1_1_41 <= blend1_g_2_0_sum_1_1_40;
                blend1_g_2_0_sum_1_2_41 <= blend1_g_2_0_sum_1_2_40;
                blend1_g_2_1_by_5_41 <= blend1_g_2_1_by_5_40;
                blend1_g_2_1_sum_1_0_41 <= blend1_g_2_1_sum_1_0_40;
                blend1_g_2_1_sum_1_1_41 <= blend1_g_2_1_sum_1_1_40;
                blend1_g_2_1_sum_1_2_41 <= blend1_g_2_1_sum_1_2_40;
                square1_g_by_1_41 <= square1_g_by_1_40;
                square1_g_amount_2_41 <= square1_g_amount_2_40;
                square1_g_by_4_41 <= square1_g_by_4_40;
                blend1_b_2_0_by_5_41 <= blend1_b_2_0_by_5_40;
                blend1_b_2_0_sum_1_0_41 <= blend1_b_2_0_sum_1_0_40;
                blend1_b_2_0_sum_1_1_41 <= blend1_b_2_0_sum_1_1_40;
                blend1_b_2_0_sum_1_2_41 <= blend1_b_2_0_sum_1_2_40;
                blend1_b_2_1_by_5_41 <= blend1_b_2_1_by_5_40;
                blend1_b_2_1_sum_1_0_41 <= blend1_b_2_1_sum_1_0_40;
                blend1_b_2_1_sum_1_1_41 <= blend1_b_2_1_sum_1_1_40;
                blend1_b_2_1_sum_1_2_41 <= blend1_b_2_1_sum_1_2_40;
                square1_b_by_1_41 <= square1_b_by_1_40;
                square1_b_amount_2_41 <= square1_b_amount_2_40;
                square1_b_by_4_41 <= square1_b_by_4_40;
            end if;
        end if;
    end process;

    -- ===== Stage 41: blend1_r_2_0_sum_2_0, blend1_r_2_0_sum_2_1 and 10 more
    -- UQ-3.20: the sum of two
    blend1_r_2_0_sum_2_0_41 <=
        resize(blend1_r_2_0_sum_1_0_41, 17) + shift_left(resize(blend1_r_2_0_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_r_2_0_sum_2_1_41 <=
        resize(blend1_r_2_0_sum_1_2_41, 17) + shift_left(resize(blend1_r_2_0_by_5_41, 17), 2);
    -- UQ-3.20: the sum of two
    blend1_r_2_1_sum_2_0_41 <=
        resize(blend1_r_2_1_sum_1_0_41, 17) + shift_left(resize(blend1_r_2_1_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_r_2_1_sum_2_1_41 <=
        resize(blend1_r_2_1_sum_1_2_41, 17) + shift_left(resize(blend1_r_2_1_by_5_41, 17), 2);
    -- UQ-3.20: the sum of two
    blend1_g_2_0_sum_2_0_41 <=
        resize(blend1_g_2_0_sum_1_0_41, 17) + shift_left(resize(blend1_g_2_0_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_g_2_0_sum_2_1_41 <=
        resize(blend1_g_2_0_sum_1_2_41, 17) + shift_left(resize(blend1_g_2_0_by_5_41, 17), 2);
    -- UQ-3.20: the sum of two
    blend1_g_2_1_sum_2_0_41 <=
        resize(blend1_g_2_1_sum_1_0_41, 17) + shift_left(resize(blend1_g_2_1_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_g_2_1_sum_2_1_41 <=
        resize(blend1_g_2_1_sum_1_2_41, 17) + shift_left(resize(blend1_g_2_1_by_5_41, 17), 2);
    -- UQ-3.20: the sum of two
    blend1_b_2_0_sum_2_0_41 <=
        resize(blend1_b_2_0_sum_1_0_41, 17) + shift_left(resize(blend1_b_2_0_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_b_2_0_sum_2_1_41 <=
        resize(blend1_b_2_0_sum_1_2_41, 17) + shift_left(resize(blend1_b_2_0_by_5_41, 17), 2);
    -- UQ-3.20: the sum of two
    blend1_b_2_1_sum_2_0_41 <=
        resize(blend1_b_2_1_sum_1_0_41, 17) + shift_left(resize(blend1_b_2_1_sum_1_1_41, 17), 1);
    -- UQ0.17: the sum of two
    blend1_b_2_1_sum_2_1_41 <=
        resize(blend1_b_2_1_sum_1_2_41, 17) + shift_left(resize(blend1_b_2_1_by_5_41, 17), 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_42 <= in_gain1r_41;
                in_gain1g_42 <= in_gain1g_41;
                in_gain1b_42 <= in_gain1b_41;
                hidden_42 <= hidden_41;
                blend1_r_2_0_sum_2_0_42 <= blend1_r_2_0_sum_2_0_41;
                blend1_r_2_0_sum_2_1_42 <= blend1_r_2_0_sum_2_1_41;
                blend1_r_2_1_sum_2_0_42 <= blend1_r_2_1_sum_2_0_41;
                blend1_r_2_1_sum_2_1_42 <= blend1_r_2_1_sum_2_1_41;
                blend1_signed_42 <= blend1_signed_41;
                square1_r_by_1_42 <= square1_r_by_1_41;
                square1_r_amount_2_42 <= square1_r_amount_2_41;
                square1_r_by_4_42 <= square1_r_by_4_41;
                blend1_g_2_0_sum_2_0_42 <= blend1_g_2_0_sum_2_0_41;
                blend1_g_2_0_sum_2_1_42 <= blend1_g_2_0_sum_2_1_41;
                blend1_g_2_1_sum_2_0_42 <= blend1_g_2_1_sum_2_0_41;
                blend1_g_2_1_sum_2_1_42 <= blend1_g_2_1_sum_2_1_41;
                square1_g_by_1_42 <= square1_g_by_1_41;
                square1_g_amount_2_42 <= square1_g_amount_2_41;
                square1_g_by_4_42 <= square1_g_by_4_41;
                blend1_b_2_0_sum_2_0_42 <= blend1_b_2_0_sum_2_0_41;
                blend1_b_2_0_sum_2_1_42 <= blend1_b_2_0_sum_2_1_41;
                blend1_b_2_1_sum_2_0_42 <= blend1_b_2_1_sum_2_0_41;
                blend1_b_2_1_sum_2_1_42 <= blend1_b_2_1_sum_2_1_41;
                square1_b_by_1_42 <= square1_b_by_1_41;
                square1_b_amount_2_42 <= square1_b_amount_2_41;
                square1_b_by_4_42 <= square1_b_by_4_41;
            end if;
        end if;
    end process;

    -- ===== Stage 42: blend1_r_2_0, blend1_r_2_1, blend1_g_2_0, blend1_g_2_1 and 2 more
    -- UQ0.20: two neighbours
    blend1_r_2_0_42 <=
        resize(blend1_r_2_0_sum_2_0_42, 20) + shift_left(resize(blend1_r_2_0_sum_2_1_42, 20), 3);
    -- UQ0.20: two neighbours
    blend1_r_2_1_42 <=
        resize(blend1_r_2_1_sum_2_0_42, 20) + shift_left(resize(blend1_r_2_1_sum_2_1_42, 20), 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_r_2_0_cut_42 <= blend1_r_2_0_42(19 downto 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_r_2_1_cut_42 <= blend1_r_2_1_42(19 downto 3);
    -- UQ0.20: two neighbours
    blend1_g_2_0_42 <=
        resize(blend1_g_2_0_sum_2_0_42, 20) + shift_left(resize(blend1_g_2_0_sum_2_1_42, 20), 3);
    -- UQ0.20: two neighbours
    blend1_g_2_1_42 <=
        resize(blend1_g_2_1_sum_2_0_42, 20) + shift_left(resize(blend1_g_2_1_sum_2_1_42, 20), 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_g_2_0_cut_42 <= blend1_g_2_0_42(19 downto 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_g_2_1_cut_42 <= blend1_g_2_1_42(19 downto 3);
    -- UQ0.20: two neighbours
    blend1_b_2_0_42 <=
        resize(blend1_b_2_0_sum_2_0_42, 20) + shift_left(resize(blend1_b_2_0_sum_2_1_42, 20), 3);
    -- UQ0.20: two neighbours
    blend1_b_2_1_42 <=
        resize(blend1_b_2_1_sum_2_0_42, 20) + shift_left(resize(blend1_b_2_1_sum_2_1_42, 20), 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_b_2_0_cut_42 <= blend1_b_2_0_42(19 downto 3);
    -- UQ0.17: rounded down to a multiplier's operand
    blend1_b_2_1_cut_42 <= blend1_b_2_1_42(19 downto 3);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_43 <= in_gain1r_42;
                in_gain1g_43 <= in_gain1g_42;
                in_gain1b_43 <= in_gain1b_42;
                hidden_43 <= hidden_42;
                blend1_r_2_0_cut_43 <= blend1_r_2_0_cut_42;
                blend1_r_2_1_cut_43 <= blend1_r_2_1_cut_42;
                blend1_signed_43 <= blend1_signed_42;
                square1_r_by_1_43 <= square1_r_by_1_42;
                square1_r_amount_2_43 <= square1_r_amount_2_42;
                square1_r_by_4_43 <= square1_r_by_4_42;
                blend1_g_2_0_cut_43 <= blend1_g_2_0_cut_42;
                blend1_g_2_1_cut_43 <= blend1_g_2_1_cut_42;
                square1_g_by_1_43 <= square1_g_by_1_42;
                square1_g_amount_2_43 <= square1_g_amount_2_42;
                square1_g_by_4_43 <= square1_g_by_4_42;
                blend1_b_2_0_cut_43 <= blend1_b_2_0_cut_42;
                blend1_b_2_1_cut_43 <= blend1_b_2_1_cut_42;
                square1_b_by_1_43 <= square1_b_by_1_42;
                square1_b_amount_2_43 <= square1_b_amount_2_42;
                square1_b_by_4_43 <= square1_b_by_4_42;
            end if;
        end if;
    end process;

    -- ===== Stage 43: blend1_r_3_0_apart, blend1_g_3_0_apart, blend1_b_3_0_apart
    -- Q0.17: the difference
    blend1_r_3_0_apart_43 <=
        signed(resize(blend1_r_2_1_cut_43, 18)) - signed(resize(blend1_r_2_0_cut_43, 18));
    -- Q0.17: the difference
    blend1_g_3_0_apart_43 <=
        signed(resize(blend1_g_2_1_cut_43, 18)) - signed(resize(blend1_g_2_0_cut_43, 18));
    -- Q0.17: the difference
    blend1_b_3_0_apart_43 <=
        signed(resize(blend1_b_2_1_cut_43, 18)) - signed(resize(blend1_b_2_0_cut_43, 18));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_44 <= in_gain1r_43;
                in_gain1g_44 <= in_gain1g_43;
                in_gain1b_44 <= in_gain1b_43;
                hidden_44 <= hidden_43;
                blend1_r_2_0_cut_44 <= blend1_r_2_0_cut_43;
                blend1_r_3_0_apart_44 <= blend1_r_3_0_apart_43;
                blend1_signed_44 <= blend1_signed_43;
                square1_r_by_1_44 <= square1_r_by_1_43;
                square1_r_amount_2_44 <= square1_r_amount_2_43;
                square1_r_by_4_44 <= square1_r_by_4_43;
                blend1_g_2_0_cut_44 <= blend1_g_2_0_cut_43;
                blend1_g_3_0_apart_44 <= blend1_g_3_0_apart_43;
                square1_g_by_1_44 <= square1_g_by_1_43;
                square1_g_amount_2_44 <= square1_g_amount_2_43;
                square1_g_by_4_44 <= square1_g_by_4_43;
                blend1_b_2_0_cut_44 <= blend1_b_2_0_cut_43;
                blend1_b_3_0_apart_44 <= blend1_b_3_0_apart_43;
                square1_b_by_1_44 <= square1_b_by_1_43;
                square1_b_amount_2_44 <= square1_b_amount_2_43;
                square1_b_by_4_44 <= square1_b_by_4_43;
            end if;
        end if;
    end process;

    -- ===== Stage 44: blend1_r_3_0_part, blend1_g_3_0_part, blend1_b_3_0_part
    -- Q2.23: its part
    blend1_r_3_0_part_44 <= blend1_r_3_0_apart_44 * blend1_signed_44;
    -- Q2.23: its part
    blend1_g_3_0_part_44 <= blend1_g_3_0_apart_44 * blend1_signed_44;
    -- Q2.23: its part
    blend1_b_3_0_part_44 <= blend1_b_3_0_apart_44 * blend1_signed_44;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_45 <= in_gain1r_44;
                in_gain1g_45 <= in_gain1g_44;
                in_gain1b_45 <= in_gain1b_44;
                hidden_45 <= hidden_44;
                blend1_r_2_0_cut_45 <= blend1_r_2_0_cut_44;
                blend1_r_3_0_part_45 <= blend1_r_3_0_part_44;
                square1_r_by_1_45 <= square1_r_by_1_44;
                square1_r_amount_2_45 <= square1_r_amount_2_44;
                square1_r_by_4_45 <= square1_r_by_4_44;
                blend1_g_2_0_cut_45 <= blend1_g_2_0_cut_44;
                blend1_g_3_0_part_45 <= blend1_g_3_0_part_44;
                square1_g_by_1_45 <= square1_g_by_1_44;
                square1_g_amount_2_45 <= square1_g_amount_2_44;
                square1_g_by_4_45 <= square1_g_by_4_44;
                blend1_b_2_0_cut_45 <= blend1_b_2_0_cut_44;
                blend1_b_3_0_part_45 <= blend1_b_3_0_part_44;
                square1_b_by_1_45 <= square1_b_by_1_44;
                square1_b_amount_2_45 <= square1_b_amount_2_44;
                square1_b_by_4_45 <= square1_b_by_4_44;
            end if;
        end if;
    end process;

    -- ===== Stage 45: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_46 <= in_gain1r_45;
                in_gain1g_46 <= in_gain1g_45;
                in_gain1b_46 <= in_gain1b_45;
                hidden_46 <= hidden_45;
                blend1_r_2_0_cut_46 <= blend1_r_2_0_cut_45;
                blend1_r_3_0_part_46 <= blend1_r_3_0_part_45;
                square1_r_by_1_46 <= square1_r_by_1_45;
                square1_r_amount_2_46 <= square1_r_amount_2_45;
                square1_r_by_4_46 <= square1_r_by_4_45;
                blend1_g_2_0_cut_46 <= blend1_g_2_0_cut_45;
                blend1_g_3_0_part_46 <= blend1_g_3_0_part_45;
                square1_g_by_1_46 <= square1_g_by_1_45;
                square1_g_amount_2_46 <= square1_g_amount_2_45;
                square1_g_by_4_46 <= square1_g_by_4_45;
                blend1_b_2_0_cut_46 <= blend1_b_2_0_cut_45;
                blend1_b_3_0_part_46 <= blend1_b_3_0_part_45;
                square1_b_by_1_46 <= square1_b_by_1_45;
                square1_b_amount_2_46 <= square1_b_amount_2_45;
                square1_b_by_4_46 <= square1_b_by_4_45;
            end if;
        end if;
    end process;

    -- ===== Stage 46: blend1_r_3_0, blend1_g_3_0, blend1_b_3_0
    -- UQ0.23: two bands
    blend1_r_3_0_46 <=
        shift_left(resize(blend1_r_2_0_cut_46, 23), 6) + unsigned(blend1_r_3_0_part_46(22 downto 0));
    -- UQ0.18: the blended code
    root1_r_46 <= blend1_r_3_0_46(22 downto 5);
    -- UQ0.23: two bands
    blend1_g_3_0_46 <=
        shift_left(resize(blend1_g_2_0_cut_46, 23), 6) + unsigned(blend1_g_3_0_part_46(22 downto 0));
    -- UQ0.18: the blended code
    root1_g_46 <= blend1_g_3_0_46(22 downto 5);
    -- UQ0.23: two bands
    blend1_b_3_0_46 <=
        shift_left(resize(blend1_b_2_0_cut_46, 23), 6) + unsigned(blend1_b_3_0_part_46(22 downto 0));
    -- UQ0.18: the blended code
    root1_b_46 <= blend1_b_3_0_46(22 downto 5);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_47 <= in_gain1r_46;
                in_gain1g_47 <= in_gain1g_46;
                in_gain1b_47 <= in_gain1b_46;
                hidden_47 <= hidden_46;
                root1_r_47 <= root1_r_46;
                square1_r_by_1_47 <= square1_r_by_1_46;
                square1_r_amount_2_47 <= square1_r_amount_2_46;
                square1_r_by_4_47 <= square1_r_by_4_46;
                root1_g_47 <= root1_g_46;
                square1_g_by_1_47 <= square1_g_by_1_46;
                square1_g_amount_2_47 <= square1_g_amount_2_46;
                square1_g_by_4_47 <= square1_g_by_4_46;
                root1_b_47 <= root1_b_46;
                square1_b_by_1_47 <= square1_b_by_1_46;
                square1_b_amount_2_47 <= square1_b_amount_2_46;
                square1_b_by_4_47 <= square1_b_by_4_46;
            end if;
        end if;
    end process;

    -- ===== Stage 47: square1_r_exact, square1_g_exact, square1_b_exact
    -- UQ0.36: its square
    square1_r_exact_47 <= root1_r_47 * root1_r_47;
    -- UQ0.18: rounded down
    square1_r_47 <= square1_r_exact_47(35 downto 18);
    -- UQ0.36: its square
    square1_g_exact_47 <= root1_g_47 * root1_g_47;
    -- UQ0.18: rounded down
    square1_g_47 <= square1_g_exact_47(35 downto 18);
    -- UQ0.36: its square
    square1_b_exact_47 <= root1_b_47 * root1_b_47;
    -- UQ0.18: rounded down
    square1_b_47 <= square1_b_exact_47(35 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_48 <= in_gain1r_47;
                in_gain1g_48 <= in_gain1g_47;
                in_gain1b_48 <= in_gain1b_47;
                hidden_48 <= hidden_47;
                square1_r_48 <= square1_r_47;
                square1_r_by_1_48 <= square1_r_by_1_47;
                square1_r_amount_2_48 <= square1_r_amount_2_47;
                square1_r_by_4_48 <= square1_r_by_4_47;
                square1_g_48 <= square1_g_47;
                square1_g_by_1_48 <= square1_g_by_1_47;
                square1_g_amount_2_48 <= square1_g_amount_2_47;
                square1_g_by_4_48 <= square1_g_by_4_47;
                square1_b_48 <= square1_b_47;
                square1_b_by_1_48 <= square1_b_by_1_47;
                square1_b_amount_2_48 <= square1_b_amount_2_47;
                square1_b_by_4_48 <= square1_b_by_4_47;
            end if;
        end if;
    end process;

    -- ===== Stage 48: square1_r_seen, square1_r_up_1, square1_g_seen and 3 more
    -- UQ0.18: 0 for a normal that is turned away
    square1_r_seen_48 <= (others => '0') when hidden_48 = '1' else square1_r_48;
    -- UQ1.18: times 2^1 if so
    square1_r_up_1_48 <= shift_left(resize(square1_r_seen_48, 19), to_integer(square1_r_by_1_48));
    -- UQ4.14: times 2^4
    square1_r_all_48 <= square1_r_seen_48;
    -- UQ4.18: in the wider of two formats
    square1_r_all_wide_48 <= shift_left(resize(square1_r_all_48, 22), 4);
    -- UQ0.18: 0 for a normal that is turned away
    square1_g_seen_48 <= (others => '0') when hidden_48 = '1' else square1_g_48;
    -- UQ1.18: times 2^1 if so
    square1_g_up_1_48 <= shift_left(resize(square1_g_seen_48, 19), to_integer(square1_g_by_1_48));
    -- UQ4.14: times 2^4
    square1_g_all_48 <= square1_g_seen_48;
    -- UQ4.18: in the wider of two formats
    square1_g_all_wide_48 <= shift_left(resize(square1_g_all_48, 22), 4);
    -- UQ0.18: 0 for a normal that is turned away
    square1_b_seen_48 <= (others => '0') when hidden_48 = '1' else square1_b_48;
    -- UQ1.18: times 2^1 if so
    square1_b_up_1_48 <= shift_left(resize(square1_b_seen_48, 19), to_integer(square1_b_by_1_48));
    -- UQ4.14: times 2^4
    square1_b_all_48 <= square1_b_seen_48;
    -- UQ4.18: in the wider of two formats
    square1_b_all_wide_48 <= shift_left(resize(square1_b_all_48, 22), 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_49 <= in_gain1r_48;
                in_gain1g_49 <= in_gain1g_48;
                in_gain1b_49 <= in_gain1b_48;
                square1_r_up_1_49 <= square1_r_up_1_48;
                square1_r_amount_2_49 <= square1_r_amount_2_48;
                square1_r_by_4_49 <= square1_r_by_4_48;
                square1_r_all_wide_49 <= square1_r_all_wide_48;
                square1_g_up_1_49 <= square1_g_up_1_48;
                square1_g_amount_2_49 <= square1_g_amount_2_48;
                square1_g_by_4_49 <= square1_g_by_4_48;
                square1_g_all_wide_49 <= square1_g_all_wide_48;
                square1_b_up_1_49 <= square1_b_up_1_48;
                square1_b_amount_2_49 <= square1_b_amount_2_48;
                square1_b_by_4_49 <= square1_b_by_4_48;
                square1_b_all_wide_49 <= square1_b_all_wide_48;
            end if;
        end if;
    end process;

    -- ===== Stage 49: square1_r_up_2, square1_r_up, square1_r_within and 6 more
    -- UQ3.18: times 2^2 if so
    square1_r_up_2_49 <=
        shift_left(resize(square1_r_up_1_49, 21), to_integer(square1_r_amount_2_49));
    -- UQ4.18: in the wider of two formats
    square1_r_up_2_wide_49 <= resize(square1_r_up_2_49, 22);
    -- UQ4.18: times 2^shift
    square1_r_up_49 <=
        square1_r_all_wide_49 when square1_r_by_4_49 = '1' else square1_r_up_2_wide_49;
    -- UQ4.14: rounded down
    square1_r_up_cut_49 <= square1_r_up_49(21 downto 4);
    -- UQ4.14: kept in its format
    square1_r_within_49 <= square1_r_up_cut_49;
    -- UQ3.18: times 2^2 if so
    square1_g_up_2_49 <=
        shift_left(resize(square1_g_up_1_49, 21), to_integer(square1_g_amount_2_49));
    -- UQ4.18: in the wider of two formats
    square1_g_up_2_wide_49 <= resize(square1_g_up_2_49, 22);
    -- UQ4.18: times 2^shift
    square1_g_up_49 <=
        square1_g_all_wide_49 when square1_g_by_4_49 = '1' else square1_g_up_2_wide_49;
    -- UQ4.14: rounded down
    square1_g_up_cut_49 <= square1_g_up_49(21 downto 4);
    -- UQ4.14: kept in its format
    square1_g_within_49 <= square1_g_up_cut_49;
    -- UQ3.18: times 2^2 if so
    square1_b_up_2_49 <=
        shift_left(resize(square1_b_up_1_49, 21), to_integer(square1_b_amount_2_49));
    -- UQ4.18: in the wider of two formats
    square1_b_up_2_wide_49 <= resize(square1_b_up_2_49, 22);
    -- UQ4.18: times 2^shift
    square1_b_up_49 <=
        square1_b_all_wide_49 when square1_b_by_4_49 = '1' else square1_b_up_2_wide_49;
    -- UQ4.14: rounded down
    square1_b_up_cut_49 <= square1_b_up_49(21 downto 4);
    -- UQ4.14: kept in its format
    square1_b_within_49 <= square1_b_up_cut_49;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_gain1r_50 <= in_gain1r_49;
                in_gain1g_50 <= in_gain1g_49;
                in_gain1b_50 <= in_gain1b_49;
                square1_r_within_50 <= square1_r_within_49;
                square1_g_within_50 <= square1_g_within_49;
                square1_b_within_50 <= square1_b_within_49;
            end if;
        end if;
    end process;

    -- ===== Stage 50: light1_r_exact, light1_g_exact, light1_b_exact
    -- UQ5.31: times the gain
    light1_r_exact_50 <= square1_r_within_50 * in_gain1r_50;
    -- UQ5.17: rounded down
    light1_r_50 <= light1_r_exact_50(35 downto 14);
    -- UQ5.31: times the gain
    light1_g_exact_50 <= square1_g_within_50 * in_gain1g_50;
    -- UQ5.17: rounded down
    light1_g_50 <= light1_g_exact_50(35 downto 14);
    -- UQ5.31: times the gain
    light1_b_exact_50 <= square1_b_within_50 * in_gain1b_50;
    -- UQ5.17: rounded down
    light1_b_50 <= light1_b_exact_50(35 downto 14);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                light1_r_51 <= light1_r_50;
                light1_g_51 <= light1_g_50;
                light1_b_51 <= light1_b_50;
            end if;
        end if;
    end process;

    -- ===== Stage 51: sum_r, sum_g, sum_b
    -- UQ1.17: kept at 1.0
    sum_r_51 <= (17 => '1', others => '0') when unsigned(light1_r_51(21 downto 17)) /= 0 else
        light1_r_51(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_g_51 <= (17 => '1', others => '0') when unsigned(light1_g_51(21 downto 17)) /= 0 else
        light1_g_51(17 downto 0);
    -- UQ1.17: kept at 1.0
    sum_b_51 <= (17 => '1', others => '0') when unsigned(light1_b_51(21 downto 17)) /= 0 else
        light1_b_51(17 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sum_r_52 <= sum_r_51;
                sum_g_52 <= sum_g_51;
                sum_b_52 <= sum_b_51;
            end if;
        end if;
    end process;

    out_valid <= valid(52);
    out_sum_r <= sum_r_52;
    out_sum_g <= sum_g_52;
    out_sum_b <= sum_b_52;

end architecture rtl;
