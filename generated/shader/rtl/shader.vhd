-- shader: Phong shader, 2 lights, 4 materials, 8 bits a channel
--
-- Made by: brdfgen generate core.toml
-- Spec ef73cb5e346c03ce. Generated; the core is yours to use under any terms.
--
--   in_material UQ2.0   index of the material, 0 to 3; above: the last
--   in_nx       Q1.16   x of the normal N, of unit length
--   in_ny       Q1.16   y of the normal N, of unit length
--   in_nz       Q1.16   z of the normal N, of unit length
--   in_vx       Q1.16   x of the unit vector V to the viewer
--   in_vy       Q1.16   y of the unit vector V to the viewer
--   in_vz       Q1.16   z of the unit vector V to the viewer
--   in_l1x      Q1.16   x of the unit vector L to light 1
--   in_l1y      Q1.16   y of the unit vector L to light 1
--   in_l1z      Q1.16   z of the unit vector L to light 1
--   in_l2x      Q1.16   x of the unit vector L to light 2
--   in_l2y      Q1.16   y of the unit vector L to light 2
--   in_l2z      Q1.16   z of the unit vector L to light 2
--   out_r       UQ8.0   red; 255 is full scale
--   out_g       UQ8.0   green; 255 is full scale
--   out_b       UQ8.0   blue; 255 is full scale
--
-- Latency 16 clocks, one result a clock.
-- Error against the exact shader, in codes of a channel, over 262144 samples:
--   -61.201..+5.929, root mean square 8.984.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity shader is
    port (
        -- clock; everything happens on its rising edge
        clk         : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst         : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce          : in  std_logic;
        -- the other inputs are to be taken
        in_valid    : in  std_logic;
        -- UQ2.0: index of the material, 0 to 3; above: the last
        in_material : in  unsigned(1 downto 0);
        -- Q1.16: x of the normal N, of unit length
        in_nx       : in  signed(17 downto 0);
        -- Q1.16: y of the normal N, of unit length
        in_ny       : in  signed(17 downto 0);
        -- Q1.16: z of the normal N, of unit length
        in_nz       : in  signed(17 downto 0);
        -- Q1.16: x of the unit vector V to the viewer
        in_vx       : in  signed(17 downto 0);
        -- Q1.16: y of the unit vector V to the viewer
        in_vy       : in  signed(17 downto 0);
        -- Q1.16: z of the unit vector V to the viewer
        in_vz       : in  signed(17 downto 0);
        -- Q1.16: x of the unit vector L to light 1
        in_l1x      : in  signed(17 downto 0);
        -- Q1.16: y of the unit vector L to light 1
        in_l1y      : in  signed(17 downto 0);
        -- Q1.16: z of the unit vector L to light 1
        in_l1z      : in  signed(17 downto 0);
        -- Q1.16: x of the unit vector L to light 2
        in_l2x      : in  signed(17 downto 0);
        -- Q1.16: y of the unit vector L to light 2
        in_l2y      : in  signed(17 downto 0);
        -- Q1.16: z of the unit vector L to light 2
        in_l2z      : in  signed(17 downto 0);
        -- the other outputs are a result: in_valid, 16 enabled clocks later
        out_valid   : out std_logic;
        -- UQ8.0: red; 255 is full scale
        out_r       : out unsigned(7 downto 0);
        -- UQ8.0: green; 255 is full scale
        out_g       : out unsigned(7 downto 0);
        -- UQ8.0: blue; 255 is full scale
        out_b       : out unsigned(7 downto 0)
    );
end entity shader;

architecture rtl of shader is
    -- ===== The memory colours
    -- Bits 31 downto 0 of each word.
    type colours_words_0_t is array (3 downto 0) of
        std_logic_vector(31 downto 0);
    constant COLOURS_WORDS_0 : colours_words_0_t := (
        3 => x"0f43d0a3",
        2 => x"7a70551a",
        1 => x"8183f4a6",
        0 => x"6b22d476"
    );
    -- Bits 63 downto 32 of each word.
    type colours_words_1_t is array (3 downto 0) of
        std_logic_vector(31 downto 0);
    constant COLOURS_WORDS_1 : colours_words_1_t := (
        3 => x"e148a4f5",
        2 => x"d7251b6f",
        1 => x"2df5afe8",
        0 => x"fca47643"
    );
    -- Bits 95 downto 64 of each word.
    type colours_words_2_t is array (3 downto 0) of
        std_logic_vector(31 downto 0);
    constant COLOURS_WORDS_2 : colours_words_2_t := (
        3 => x"04c8d611",
        2 => x"a643928e",
        1 => x"6874dc82",
        0 => x"21789d7c"
    );
    -- Bits 127 downto 96 of each word.
    type colours_words_3_t is array (3 downto 0) of
        std_logic_vector(31 downto 0);
    constant COLOURS_WORDS_3 : colours_words_3_t := (
        3 => x"14628c99",
        2 => x"725466e5",
        1 => x"ded6b931",
        0 => x"ca11da2a"
    );
    -- Bits 155 downto 128 of each word.
    type colours_words_4_t is array (3 downto 0) of
        std_logic_vector(27 downto 0);
    constant COLOURS_WORDS_4 : colours_words_4_t := (
        3 => x"0f5ea7a",
        2 => x"4062788",
        1 => x"5fa2e48",
        0 => x"89c7a52"
    );
    signal colours_2 : std_logic_vector(155 downto 0) := (others => '0');

    -- ===== The memory rom
    -- Bits 13 downto 0 of each word.
    type rom_words_0_t is array (3 downto 0) of
        std_logic_vector(15 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        3 => x"3adc",
        2 => x"3bf3",
        1 => x"2aea",
        0 => x"315e"
    );
    signal rom_6 : std_logic_vector(13 downto 0) := (others => '0');

    signal valid : std_logic_vector(16 downto 1) := (others => '0');
    signal nv_x_0 : signed(35 downto 0) := (others => '0');
    signal nv_y_0 : signed(35 downto 0) := (others => '0');
    signal nv_z_0 : signed(35 downto 0) := (others => '0');
    signal nl1_x_0 : signed(35 downto 0) := (others => '0');
    signal nl1_y_0 : signed(35 downto 0) := (others => '0');
    signal nl1_z_0 : signed(35 downto 0) := (others => '0');
    signal lv1_x_0 : signed(35 downto 0) := (others => '0');
    signal lv1_y_0 : signed(35 downto 0) := (others => '0');
    signal lv1_z_0 : signed(35 downto 0) := (others => '0');
    signal nl2_x_0 : signed(35 downto 0) := (others => '0');
    signal nl2_y_0 : signed(35 downto 0) := (others => '0');
    signal nl2_z_0 : signed(35 downto 0) := (others => '0');
    signal lv2_x_0 : signed(35 downto 0) := (others => '0');
    signal lv2_y_0 : signed(35 downto 0) := (others => '0');
    signal lv2_z_0 : signed(35 downto 0) := (others => '0');
    signal in_material_1 : unsigned(1 downto 0) := (others => '0');
    signal nv_x_1 : signed(35 downto 0) := (others => '0');
    signal nv_y_1 : signed(35 downto 0) := (others => '0');
    signal nv_z_1 : signed(35 downto 0) := (others => '0');
    signal nl1_x_1 : signed(35 downto 0) := (others => '0');
    signal nl1_y_1 : signed(35 downto 0) := (others => '0');
    signal nl1_z_1 : signed(35 downto 0) := (others => '0');
    signal lv1_x_1 : signed(35 downto 0) := (others => '0');
    signal lv1_y_1 : signed(35 downto 0) := (others => '0');
    signal lv1_z_1 : signed(35 downto 0) := (others => '0');
    signal nl2_x_1 : signed(35 downto 0) := (others => '0');
    signal nl2_y_1 : signed(35 downto 0) := (others => '0');
    signal nl2_z_1 : signed(35 downto 0) := (others => '0');
    signal lv2_x_1 : signed(35 downto 0) := (others => '0');
    signal lv2_y_1 : signed(35 downto 0) := (others => '0');
    signal lv2_z_1 : signed(35 downto 0) := (others => '0');
    signal nv_xy_1 : signed(36 downto 0) := (others => '0');
    signal nv_xyz_1 : signed(36 downto 0) := (others => '0');
    signal nv_cut_1 : signed(22 downto 0) := (others => '0');
    signal nl1_xy_1 : signed(36 downto 0) := (others => '0');
    signal nl1_xyz_1 : signed(36 downto 0) := (others => '0');
    signal lv1_xy_1 : signed(36 downto 0) := (others => '0');
    signal lv1_xyz_1 : signed(36 downto 0) := (others => '0');
    signal lv1_cut_1 : signed(22 downto 0) := (others => '0');
    signal nl2_xy_1 : signed(36 downto 0) := (others => '0');
    signal nl2_xyz_1 : signed(36 downto 0) := (others => '0');
    signal lv2_xy_1 : signed(36 downto 0) := (others => '0');
    signal lv2_xyz_1 : signed(36 downto 0) := (others => '0');
    signal lv2_cut_1 : signed(22 downto 0) := (others => '0');
    signal in_material_2 : unsigned(1 downto 0) := (others => '0');
    signal nv_cut_2 : signed(22 downto 0) := (others => '0');
    signal nl1_xyz_2 : signed(36 downto 0) := (others => '0');
    signal lv1_cut_2 : signed(22 downto 0) := (others => '0');
    signal nl2_xyz_2 : signed(36 downto 0) := (others => '0');
    signal lv2_cut_2 : signed(22 downto 0) := (others => '0');
    signal nv_2 : signed(19 downto 0) := (others => '0');
    signal nl1_exact_2 : unsigned(32 downto 0) := (others => '0');
    signal lit1_2 : std_logic := '0';
    signal dark1_2 : std_logic := '0';
    signal nl1_2 : unsigned(18 downto 0) := (others => '0');
    signal lv1_2 : signed(19 downto 0) := (others => '0');
    signal nl1_signed_2 : signed(19 downto 0) := (others => '0');
    signal nl1_signed_low_2 : unsigned(16 downto 0) := (others => '0');
    signal nl1_signed_low_signed_2 : signed(17 downto 0) := (others => '0');
    signal nl1_signed_high_2 : signed(2 downto 0) := (others => '0');
    signal nv_low_2 : unsigned(16 downto 0) := (others => '0');
    signal nv_low_signed_2 : signed(17 downto 0) := (others => '0');
    signal nv_high_2 : signed(2 downto 0) := (others => '0');
    signal psi1_2 : unsigned(12 downto 0) := (others => '0');
    signal diffuse_r_1_2 : unsigned(10 downto 0) := (others => '0');
    signal specular_r_1_2 : unsigned(11 downto 0) := (others => '0');
    signal diffuse_g_1_2 : unsigned(10 downto 0) := (others => '0');
    signal specular_g_1_2 : unsigned(11 downto 0) := (others => '0');
    signal diffuse_b_1_2 : unsigned(9 downto 0) := (others => '0');
    signal specular_b_1_2 : unsigned(11 downto 0) := (others => '0');
    signal nl2_exact_2 : unsigned(32 downto 0) := (others => '0');
    signal lit2_2 : std_logic := '0';
    signal dark2_2 : std_logic := '0';
    signal nl2_2 : unsigned(18 downto 0) := (others => '0');
    signal lv2_2 : signed(19 downto 0) := (others => '0');
    signal nl2_signed_2 : signed(19 downto 0) := (others => '0');
    signal nl2_signed_low_2 : unsigned(16 downto 0) := (others => '0');
    signal nl2_signed_low_signed_2 : signed(17 downto 0) := (others => '0');
    signal nl2_signed_high_2 : signed(2 downto 0) := (others => '0');
    signal psi2_2 : unsigned(12 downto 0) := (others => '0');
    signal diffuse_r_2_2 : unsigned(8 downto 0) := (others => '0');
    signal specular_r_2_2 : unsigned(9 downto 0) := (others => '0');
    signal diffuse_g_2_2 : unsigned(8 downto 0) := (others => '0');
    signal specular_g_2_2 : unsigned(10 downto 0) := (others => '0');
    signal diffuse_b_2_2 : unsigned(9 downto 0) := (others => '0');
    signal specular_b_2_2 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_2 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_2 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_2 : unsigned(8 downto 0) := (others => '0');
    signal in_material_3 : unsigned(1 downto 0) := (others => '0');
    signal dark1_3 : std_logic := '0';
    signal lv1_3 : signed(19 downto 0) := (others => '0');
    signal nl1_signed_low_signed_3 : signed(17 downto 0) := (others => '0');
    signal nl1_signed_high_3 : signed(2 downto 0) := (others => '0');
    signal nv_low_signed_3 : signed(17 downto 0) := (others => '0');
    signal nv_high_3 : signed(2 downto 0) := (others => '0');
    signal psi1_3 : unsigned(12 downto 0) := (others => '0');
    signal diffuse_r_1_3 : unsigned(10 downto 0) := (others => '0');
    signal specular_r_1_3 : unsigned(11 downto 0) := (others => '0');
    signal diffuse_g_1_3 : unsigned(10 downto 0) := (others => '0');
    signal specular_g_1_3 : unsigned(11 downto 0) := (others => '0');
    signal diffuse_b_1_3 : unsigned(9 downto 0) := (others => '0');
    signal specular_b_1_3 : unsigned(11 downto 0) := (others => '0');
    signal dark2_3 : std_logic := '0';
    signal lv2_3 : signed(19 downto 0) := (others => '0');
    signal nl2_signed_low_signed_3 : signed(17 downto 0) := (others => '0');
    signal nl2_signed_high_3 : signed(2 downto 0) := (others => '0');
    signal psi2_3 : unsigned(12 downto 0) := (others => '0');
    signal diffuse_r_2_3 : unsigned(8 downto 0) := (others => '0');
    signal specular_r_2_3 : unsigned(9 downto 0) := (others => '0');
    signal diffuse_g_2_3 : unsigned(8 downto 0) := (others => '0');
    signal specular_g_2_3 : unsigned(10 downto 0) := (others => '0');
    signal diffuse_b_2_3 : unsigned(9 downto 0) := (others => '0');
    signal specular_b_2_3 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_3 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_3 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_3 : unsigned(8 downto 0) := (others => '0');
    signal nlv1_low_l_3 : signed(35 downto 0) := (others => '0');
    signal nlv1_low_h_3 : signed(20 downto 0) := (others => '0');
    signal nlv1_high_l_3 : signed(20 downto 0) := (others => '0');
    signal nlv1_high_h_3 : signed(5 downto 0) := (others => '0');
    signal dif1_r_exact_3 : unsigned(23 downto 0) := (others => '0');
    signal dif1_r_3 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_exact_3 : unsigned(23 downto 0) := (others => '0');
    signal dif1_g_3 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_exact_3 : unsigned(22 downto 0) := (others => '0');
    signal dif1_b_3 : unsigned(10 downto 0) := (others => '0');
    signal nlv2_low_l_3 : signed(35 downto 0) := (others => '0');
    signal nlv2_low_h_3 : signed(20 downto 0) := (others => '0');
    signal nlv2_high_l_3 : signed(20 downto 0) := (others => '0');
    signal nlv2_high_h_3 : signed(5 downto 0) := (others => '0');
    signal dif2_r_exact_3 : unsigned(21 downto 0) := (others => '0');
    signal dif2_r_3 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_exact_3 : unsigned(21 downto 0) := (others => '0');
    signal dif2_g_3 : unsigned(9 downto 0) := (others => '0');
    signal dif2_b_exact_3 : unsigned(22 downto 0) := (others => '0');
    signal dif2_b_3 : unsigned(10 downto 0) := (others => '0');
    signal in_material_4 : unsigned(1 downto 0) := (others => '0');
    signal dark1_4 : std_logic := '0';
    signal lv1_4 : signed(19 downto 0) := (others => '0');
    signal nlv1_low_l_4 : signed(35 downto 0) := (others => '0');
    signal nlv1_low_h_4 : signed(20 downto 0) := (others => '0');
    signal nlv1_high_l_4 : signed(20 downto 0) := (others => '0');
    signal nlv1_high_h_4 : signed(5 downto 0) := (others => '0');
    signal dif1_r_4 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_4 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_4 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_4 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_4 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_4 : unsigned(11 downto 0) := (others => '0');
    signal dark2_4 : std_logic := '0';
    signal lv2_4 : signed(19 downto 0) := (others => '0');
    signal nlv2_low_l_4 : signed(35 downto 0) := (others => '0');
    signal nlv2_low_h_4 : signed(20 downto 0) := (others => '0');
    signal nlv2_high_l_4 : signed(20 downto 0) := (others => '0');
    signal nlv2_high_h_4 : signed(5 downto 0) := (others => '0');
    signal dif2_r_4 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_4 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_4 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_4 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_4 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_4 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_4 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_4 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_4 : unsigned(8 downto 0) := (others => '0');
    signal nlv1_low_4 : signed(37 downto 0) := (others => '0');
    signal nlv1_high_4 : signed(22 downto 0) := (others => '0');
    signal nlv1_4 : signed(39 downto 0) := (others => '0');
    signal nlv1_twice_4 : signed(39 downto 0) := (others => '0');
    signal nlv2_low_4 : signed(37 downto 0) := (others => '0');
    signal nlv2_high_4 : signed(22 downto 0) := (others => '0');
    signal nlv2_4 : signed(39 downto 0) := (others => '0');
    signal nlv2_twice_4 : signed(39 downto 0) := (others => '0');
    signal in_material_5 : unsigned(1 downto 0) := (others => '0');
    signal dark1_5 : std_logic := '0';
    signal lv1_5 : signed(19 downto 0) := (others => '0');
    signal nlv1_twice_5 : signed(39 downto 0) := (others => '0');
    signal dif1_r_5 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_5 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_5 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_5 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_5 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_5 : unsigned(11 downto 0) := (others => '0');
    signal dark2_5 : std_logic := '0';
    signal lv2_5 : signed(19 downto 0) := (others => '0');
    signal nlv2_twice_5 : signed(39 downto 0) := (others => '0');
    signal dif2_r_5 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_5 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_5 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_5 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_5 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_5 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_5 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_5 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_5 : unsigned(8 downto 0) := (others => '0');
    signal x1_exact_5 : signed(37 downto 0) := (others => '0');
    signal x1_half_5 : signed(37 downto 0) := (others => '0');
    signal x1_cut_5 : signed(18 downto 0) := (others => '0');
    signal x2_exact_5 : signed(37 downto 0) := (others => '0');
    signal x2_half_5 : signed(37 downto 0) := (others => '0');
    signal x2_cut_5 : signed(18 downto 0) := (others => '0');
    signal dark1_6 : std_logic := '0';
    signal x1_cut_6 : signed(18 downto 0) := (others => '0');
    signal dif1_r_6 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_6 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_6 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_6 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_6 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_6 : unsigned(11 downto 0) := (others => '0');
    signal dark2_6 : std_logic := '0';
    signal x2_cut_6 : signed(18 downto 0) := (others => '0');
    signal dif2_r_6 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_6 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_6 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_6 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_6 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_6 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_6 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_6 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_6 : unsigned(8 downto 0) := (others => '0');
    signal x1_6 : unsigned(16 downto 0) := (others => '0');
    signal lobe1_u_6 : unsigned(16 downto 0) := (others => '0');
    signal lobe1_a_6 : unsigned(11 downto 0) := (others => '0');
    signal lobe1_k_6 : unsigned(1 downto 0) := (others => '0');
    signal lobe1_x_cut_6 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_x_half_6 : unsigned(14 downto 0) := (others => '0');
    signal x2_6 : unsigned(16 downto 0) := (others => '0');
    signal lobe2_u_6 : unsigned(16 downto 0) := (others => '0');
    signal lobe2_x_cut_6 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_x_half_6 : unsigned(14 downto 0) := (others => '0');
    signal dark1_7 : std_logic := '0';
    signal lobe1_u_7 : unsigned(16 downto 0) := (others => '0');
    signal lobe1_a_7 : unsigned(11 downto 0) := (others => '0');
    signal lobe1_k_7 : unsigned(1 downto 0) := (others => '0');
    signal lobe1_x_cut_7 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_x_half_7 : unsigned(14 downto 0) := (others => '0');
    signal dif1_r_7 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_7 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_7 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_7 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_7 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_7 : unsigned(11 downto 0) := (others => '0');
    signal dark2_7 : std_logic := '0';
    signal lobe2_u_7 : unsigned(16 downto 0) := (others => '0');
    signal lobe2_x_cut_7 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_x_half_7 : unsigned(14 downto 0) := (others => '0');
    signal dif2_r_7 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_7 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_7 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_7 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_7 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_7 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_7 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_7 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_7 : unsigned(8 downto 0) := (others => '0');
    signal lobe1_u_scaled_7 : unsigned(19 downto 0) := (others => '0');
    signal lobe1_beyond_bits_7 : unsigned(5 downto 0) := (others => '0');
    signal lobe1_beyond_7 : std_logic := '0';
    signal lobe1_v_7 : unsigned(13 downto 0) := (others => '0');
    signal lobe2_u_scaled_7 : unsigned(19 downto 0) := (others => '0');
    signal lobe2_beyond_bits_7 : unsigned(5 downto 0) := (others => '0');
    signal lobe2_beyond_7 : std_logic := '0';
    signal lobe2_v_7 : unsigned(13 downto 0) := (others => '0');
    signal dark1_8 : std_logic := '0';
    signal lobe1_a_8 : unsigned(11 downto 0) := (others => '0');
    signal lobe1_beyond_8 : std_logic := '0';
    signal lobe1_v_8 : unsigned(13 downto 0) := (others => '0');
    signal lobe1_x_cut_8 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_x_half_8 : unsigned(14 downto 0) := (others => '0');
    signal dif1_r_8 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_8 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_8 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_8 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_8 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_8 : unsigned(11 downto 0) := (others => '0');
    signal dark2_8 : std_logic := '0';
    signal lobe2_beyond_8 : std_logic := '0';
    signal lobe2_v_8 : unsigned(13 downto 0) := (others => '0');
    signal lobe2_x_cut_8 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_x_half_8 : unsigned(14 downto 0) := (others => '0');
    signal dif2_r_8 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_8 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_8 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_8 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_8 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_8 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_8 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_8 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_8 : unsigned(8 downto 0) := (others => '0');
    signal dark1_9 : std_logic := '0';
    signal lobe1_a_9 : unsigned(11 downto 0) := (others => '0');
    signal lobe1_beyond_9 : std_logic := '0';
    signal lobe1_v_9 : unsigned(13 downto 0) := (others => '0');
    signal lobe1_x_cut_9 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_x_half_9 : unsigned(14 downto 0) := (others => '0');
    signal dif1_r_9 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_9 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_9 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_9 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_9 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_9 : unsigned(11 downto 0) := (others => '0');
    signal dark2_9 : std_logic := '0';
    signal lobe2_beyond_9 : std_logic := '0';
    signal lobe2_v_9 : unsigned(13 downto 0) := (others => '0');
    signal lobe2_x_cut_9 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_x_half_9 : unsigned(14 downto 0) := (others => '0');
    signal dif2_r_9 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_9 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_9 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_9 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_9 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_9 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_9 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_9 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_9 : unsigned(8 downto 0) := (others => '0');
    signal lobe1_av_9 : unsigned(25 downto 0) := (others => '0');
    signal lobe1_p_above_bits_9 : std_logic := '0';
    signal lobe1_p_9 : unsigned(13 downto 0) := (others => '0');
    signal lobe2_av_9 : unsigned(25 downto 0) := (others => '0');
    signal lobe2_p_above_bits_9 : std_logic := '0';
    signal lobe2_p_9 : unsigned(13 downto 0) := (others => '0');
    signal dark1_10 : std_logic := '0';
    signal lobe1_beyond_10 : std_logic := '0';
    signal lobe1_x_cut_10 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_p_above_bits_10 : std_logic := '0';
    signal lobe1_p_10 : unsigned(13 downto 0) := (others => '0');
    signal lobe1_x_half_10 : unsigned(14 downto 0) := (others => '0');
    signal dif1_r_10 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_10 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_10 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_10 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_10 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_10 : unsigned(11 downto 0) := (others => '0');
    signal dark2_10 : std_logic := '0';
    signal lobe2_beyond_10 : std_logic := '0';
    signal lobe2_x_cut_10 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_p_above_bits_10 : std_logic := '0';
    signal lobe2_p_10 : unsigned(13 downto 0) := (others => '0');
    signal lobe2_x_half_10 : unsigned(14 downto 0) := (others => '0');
    signal dif2_r_10 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_10 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_10 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_10 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_10 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_10 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_10 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_10 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_10 : unsigned(8 downto 0) := (others => '0');
    signal lobe1_zero_10 : std_logic := '0';
    signal lobe1_xp_10 : unsigned(28 downto 0) := (others => '0');
    signal lobe1_t_10 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_zero_10 : std_logic := '0';
    signal lobe2_xp_10 : unsigned(28 downto 0) := (others => '0');
    signal lobe2_t_10 : unsigned(14 downto 0) := (others => '0');
    signal dark1_11 : std_logic := '0';
    signal lobe1_zero_11 : std_logic := '0';
    signal lobe1_t_11 : unsigned(14 downto 0) := (others => '0');
    signal lobe1_x_half_11 : unsigned(14 downto 0) := (others => '0');
    signal dif1_r_11 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_11 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_11 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_11 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_11 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_11 : unsigned(11 downto 0) := (others => '0');
    signal dark2_11 : std_logic := '0';
    signal lobe2_zero_11 : std_logic := '0';
    signal lobe2_t_11 : unsigned(14 downto 0) := (others => '0');
    signal lobe2_x_half_11 : unsigned(14 downto 0) := (others => '0');
    signal dif2_r_11 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_11 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_11 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_11 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_11 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_11 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_11 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_11 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_11 : unsigned(8 downto 0) := (others => '0');
    signal lobe1_y_exact_11 : unsigned(15 downto 0) := (others => '0');
    signal lobe1_y_cut_11 : unsigned(12 downto 0) := (others => '0');
    signal lobe1_y_11 : unsigned(12 downto 0) := (others => '0');
    signal spec1_11 : unsigned(12 downto 0) := (others => '0');
    signal lobe2_y_exact_11 : unsigned(15 downto 0) := (others => '0');
    signal lobe2_y_cut_11 : unsigned(12 downto 0) := (others => '0');
    signal lobe2_y_11 : unsigned(12 downto 0) := (others => '0');
    signal spec2_11 : unsigned(12 downto 0) := (others => '0');
    signal spec1_12 : unsigned(12 downto 0) := (others => '0');
    signal dif1_r_12 : unsigned(11 downto 0) := (others => '0');
    signal specular_r_1_12 : unsigned(11 downto 0) := (others => '0');
    signal dif1_g_12 : unsigned(11 downto 0) := (others => '0');
    signal specular_g_1_12 : unsigned(11 downto 0) := (others => '0');
    signal dif1_b_12 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_1_12 : unsigned(11 downto 0) := (others => '0');
    signal spec2_12 : unsigned(12 downto 0) := (others => '0');
    signal dif2_r_12 : unsigned(9 downto 0) := (others => '0');
    signal specular_r_2_12 : unsigned(9 downto 0) := (others => '0');
    signal dif2_g_12 : unsigned(9 downto 0) := (others => '0');
    signal specular_g_2_12 : unsigned(10 downto 0) := (others => '0');
    signal dif2_b_12 : unsigned(10 downto 0) := (others => '0');
    signal specular_b_2_12 : unsigned(10 downto 0) := (others => '0');
    signal ambient_r_12 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_12 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_12 : unsigned(8 downto 0) := (others => '0');
    signal spc1_r_exact_12 : unsigned(24 downto 0) := (others => '0');
    signal spc1_r_12 : unsigned(13 downto 0) := (others => '0');
    signal spc1_g_exact_12 : unsigned(24 downto 0) := (others => '0');
    signal spc1_g_12 : unsigned(13 downto 0) := (others => '0');
    signal spc1_b_exact_12 : unsigned(24 downto 0) := (others => '0');
    signal spc1_b_12 : unsigned(13 downto 0) := (others => '0');
    signal spc2_r_exact_12 : unsigned(22 downto 0) := (others => '0');
    signal spc2_r_12 : unsigned(11 downto 0) := (others => '0');
    signal spc2_g_exact_12 : unsigned(23 downto 0) := (others => '0');
    signal spc2_g_12 : unsigned(12 downto 0) := (others => '0');
    signal spc2_b_exact_12 : unsigned(23 downto 0) := (others => '0');
    signal spc2_b_12 : unsigned(12 downto 0) := (others => '0');
    signal dif1_r_13 : unsigned(11 downto 0) := (others => '0');
    signal spc1_r_13 : unsigned(13 downto 0) := (others => '0');
    signal dif1_g_13 : unsigned(11 downto 0) := (others => '0');
    signal spc1_g_13 : unsigned(13 downto 0) := (others => '0');
    signal dif1_b_13 : unsigned(10 downto 0) := (others => '0');
    signal spc1_b_13 : unsigned(13 downto 0) := (others => '0');
    signal dif2_r_13 : unsigned(9 downto 0) := (others => '0');
    signal spc2_r_13 : unsigned(11 downto 0) := (others => '0');
    signal dif2_g_13 : unsigned(9 downto 0) := (others => '0');
    signal spc2_g_13 : unsigned(12 downto 0) := (others => '0');
    signal dif2_b_13 : unsigned(10 downto 0) := (others => '0');
    signal spc2_b_13 : unsigned(12 downto 0) := (others => '0');
    signal ambient_r_13 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_13 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_13 : unsigned(8 downto 0) := (others => '0');
    signal both1_r_13 : unsigned(13 downto 0) := (others => '0');
    signal both1_g_13 : unsigned(13 downto 0) := (others => '0');
    signal both1_b_13 : unsigned(13 downto 0) := (others => '0');
    signal both2_r_13 : unsigned(11 downto 0) := (others => '0');
    signal lights2_r_13 : unsigned(14 downto 0) := (others => '0');
    signal both2_g_13 : unsigned(12 downto 0) := (others => '0');
    signal lights2_g_13 : unsigned(14 downto 0) := (others => '0');
    signal both2_b_13 : unsigned(12 downto 0) := (others => '0');
    signal lights2_b_13 : unsigned(14 downto 0) := (others => '0');
    signal lights2_r_14 : unsigned(14 downto 0) := (others => '0');
    signal lights2_g_14 : unsigned(14 downto 0) := (others => '0');
    signal lights2_b_14 : unsigned(14 downto 0) := (others => '0');
    signal ambient_r_14 : unsigned(9 downto 0) := (others => '0');
    signal ambient_g_14 : unsigned(8 downto 0) := (others => '0');
    signal ambient_b_14 : unsigned(8 downto 0) := (others => '0');
    signal sum_r_14 : unsigned(14 downto 0) := (others => '0');
    signal sum_half_r_14 : unsigned(14 downto 0) := (others => '0');
    signal cut_r_14 : unsigned(9 downto 0) := (others => '0');
    signal sum_g_14 : unsigned(14 downto 0) := (others => '0');
    signal sum_half_g_14 : unsigned(14 downto 0) := (others => '0');
    signal cut_g_14 : unsigned(9 downto 0) := (others => '0');
    signal sum_b_14 : unsigned(14 downto 0) := (others => '0');
    signal sum_half_b_14 : unsigned(14 downto 0) := (others => '0');
    signal cut_b_14 : unsigned(9 downto 0) := (others => '0');
    signal cut_r_15 : unsigned(9 downto 0) := (others => '0');
    signal cut_g_15 : unsigned(9 downto 0) := (others => '0');
    signal cut_b_15 : unsigned(9 downto 0) := (others => '0');
    signal kept_r_15 : unsigned(7 downto 0) := (others => '0');
    signal code_r_15 : unsigned(7 downto 0) := (others => '0');
    signal kept_g_15 : unsigned(7 downto 0) := (others => '0');
    signal code_g_15 : unsigned(7 downto 0) := (others => '0');
    signal kept_b_15 : unsigned(7 downto 0) := (others => '0');
    signal code_b_15 : unsigned(7 downto 0) := (others => '0');
    signal code_r_16 : unsigned(7 downto 0) := (others => '0');
    signal code_g_16 : unsigned(7 downto 0) := (others => '0');
    signal code_b_16 : unsigned(7 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(15 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: nv_x, nv_y, nv_z, nl1_x, nl1_y, nl1_z, lv1_x, lv1_y, lv1_z and 6 more
    -- Q3.32: N.V
    nv_x_0 <= in_nx * in_vx;
    -- Q3.32: N.V
    nv_y_0 <= in_ny * in_vy;
    -- Q3.32: N.V
    nv_z_0 <= in_nz * in_vz;
    -- Q3.32: N.L
    nl1_x_0 <= in_nx * in_l1x;
    -- Q3.32: N.L
    nl1_y_0 <= in_ny * in_l1y;
    -- Q3.32: N.L
    nl1_z_0 <= in_nz * in_l1z;
    -- Q3.32: L.V
    lv1_x_0 <= in_l1x * in_vx;
    -- Q3.32: L.V
    lv1_y_0 <= in_l1y * in_vy;
    -- Q3.32: L.V
    lv1_z_0 <= in_l1z * in_vz;
    -- Q3.32: N.L
    nl2_x_0 <= in_nx * in_l2x;
    -- Q3.32: N.L
    nl2_y_0 <= in_ny * in_l2y;
    -- Q3.32: N.L
    nl2_z_0 <= in_nz * in_l2z;
    -- Q3.32: L.V
    lv2_x_0 <= in_l2x * in_vx;
    -- Q3.32: L.V
    lv2_y_0 <= in_l2y * in_vy;
    -- Q3.32: L.V
    lv2_z_0 <= in_l2z * in_vz;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_material_1 <= in_material;
                nv_x_1 <= nv_x_0;
                nv_y_1 <= nv_y_0;
                nv_z_1 <= nv_z_0;
                nl1_x_1 <= nl1_x_0;
                nl1_y_1 <= nl1_y_0;
                nl1_z_1 <= nl1_z_0;
                lv1_x_1 <= lv1_x_0;
                lv1_y_1 <= lv1_y_0;
                lv1_z_1 <= lv1_z_0;
                nl2_x_1 <= nl2_x_0;
                nl2_y_1 <= nl2_y_0;
                nl2_z_1 <= nl2_z_0;
                lv2_x_1 <= lv2_x_0;
                lv2_y_1 <= lv2_y_0;
                lv2_z_1 <= lv2_z_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: read colours, nv_xy, nv_xyz, nl1_xy, nl1_xyz, lv1_xy and 5 more
    -- Q4.32: N.V
    nv_xy_1 <= resize(nv_x_1, 37) + resize(nv_y_1, 37);
    -- Q4.32: N.V
    nv_xyz_1 <= nv_xy_1 + resize(nv_z_1, 37);
    -- Q4.18: N.V, rounded down
    nv_cut_1 <= nv_xyz_1(36 downto 14);
    -- Q4.32: N.L
    nl1_xy_1 <= resize(nl1_x_1, 37) + resize(nl1_y_1, 37);
    -- Q4.32: N.L
    nl1_xyz_1 <= nl1_xy_1 + resize(nl1_z_1, 37);
    -- Q4.32: L.V
    lv1_xy_1 <= resize(lv1_x_1, 37) + resize(lv1_y_1, 37);
    -- Q4.32: L.V
    lv1_xyz_1 <= lv1_xy_1 + resize(lv1_z_1, 37);
    -- Q4.18: L.V, rounded down
    lv1_cut_1 <= lv1_xyz_1(36 downto 14);
    -- Q4.32: N.L
    nl2_xy_1 <= resize(nl2_x_1, 37) + resize(nl2_y_1, 37);
    -- Q4.32: N.L
    nl2_xyz_1 <= nl2_xy_1 + resize(nl2_z_1, 37);
    -- Q4.32: L.V
    lv2_xy_1 <= resize(lv2_x_1, 37) + resize(lv2_y_1, 37);
    -- Q4.32: L.V
    lv2_xyz_1 <= lv2_xy_1 + resize(lv2_z_1, 37);
    -- Q4.18: L.V, rounded down
    lv2_cut_1 <= lv2_xyz_1(36 downto 14);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                colours_2(31 downto 0) <=
                    COLOURS_WORDS_0(to_integer(in_material_1))(31 downto 0);
                colours_2(63 downto 32) <=
                    COLOURS_WORDS_1(to_integer(in_material_1))(31 downto 0);
                colours_2(95 downto 64) <=
                    COLOURS_WORDS_2(to_integer(in_material_1))(31 downto 0);
                colours_2(127 downto 96) <=
                    COLOURS_WORDS_3(to_integer(in_material_1))(31 downto 0);
                colours_2(155 downto 128) <=
                    COLOURS_WORDS_4(to_integer(in_material_1))(27 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_material_2 <= in_material_1;
                nv_cut_2 <= nv_cut_1;
                nl1_xyz_2 <= nl1_xyz_1;
                lv1_cut_2 <= lv1_cut_1;
                nl2_xyz_2 <= nl2_xyz_1;
                lv2_cut_2 <= lv2_cut_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: nv, nl1_exact, lv1, nl2_exact, lv2
    -- Q1.18: N.V, taken into [-1, 1]
    nv_2 <= to_signed(-262144, 20) when nv_cut_2(22 downto 18) < -1 else
        to_signed(262144, 20) when nv_cut_2(22 downto 18) > 0 else
        nv_cut_2(19 downto 0);
    -- UQ1.32: N.L, taken into [0, 1]: no light from behind
    nl1_exact_2 <= (others => '0') when nl1_xyz_2(36) = '1' else
        (32 => '1', others => '0') when unsigned(nl1_xyz_2(35 downto 32)) /= 0 else
        unsigned(nl1_xyz_2(32 downto 0));
    -- UQ1.0: N.L > 0
    lit1_2 <= '1' when nl1_exact_2 /= 0 else '0';
    -- UQ1.0: the light is behind the surface
    dark1_2 <= not lit1_2;
    -- UQ1.18: N.L, rounded down
    nl1_2 <= nl1_exact_2(32 downto 14);
    -- Q1.18: L.V, taken into [-1, 1]
    lv1_2 <= to_signed(-262144, 20) when lv1_cut_2(22 downto 18) < -1 else
        to_signed(262144, 20) when lv1_cut_2(22 downto 18) > 0 else
        lv1_cut_2(19 downto 0);
    -- Q1.18: a sign bit for the signed product
    nl1_signed_2 <= signed(resize(nl1_2, 20));
    -- UQ-1.18: the 17 low bits of nl1_signed
    nl1_signed_low_2 <= unsigned(nl1_signed_2(16 downto 0));
    -- Q-1.18: with a sign of 0
    nl1_signed_low_signed_2 <= signed(resize(nl1_signed_low_2, 18));
    -- Q1.1: nl1_signed without its 17 low bits
    nl1_signed_high_2 <= nl1_signed_2(19 downto 17);
    -- UQ-1.18: the 17 low bits of nv
    nv_low_2 <= unsigned(nv_2(16 downto 0));
    -- Q-1.18: with a sign of 0
    nv_low_signed_2 <= signed(resize(nv_low_2, 18));
    -- Q1.1: nv without its 17 low bits
    nv_high_2 <= nv_2(19 downto 17);
    -- UQ1.12: N.L for the diffuse term, rounded down
    psi1_2 <= nl1_2(18 downto 6);
    -- UQ-1.12: k_d, colour and light
    diffuse_r_1_2 <= unsigned(colours_2(127 downto 117));
    -- UQ0.12: k_s, colour and light
    specular_r_1_2 <= unsigned(colours_2(116 downto 105));
    -- UQ-1.12: k_d, colour and light
    diffuse_g_1_2 <= unsigned(colours_2(104 downto 94));
    -- UQ0.12: k_s, colour and light
    specular_g_1_2 <= unsigned(colours_2(93 downto 82));
    -- UQ-2.12: k_d, colour and light
    diffuse_b_1_2 <= unsigned(colours_2(81 downto 72));
    -- UQ0.12: k_s, colour and light
    specular_b_1_2 <= unsigned(colours_2(71 downto 60));
    -- UQ1.32: N.L, taken into [0, 1]: no light from behind
    nl2_exact_2 <= (others => '0') when nl2_xyz_2(36) = '1' else
        (32 => '1', others => '0') when unsigned(nl2_xyz_2(35 downto 32)) /= 0 else
        unsigned(nl2_xyz_2(32 downto 0));
    -- UQ1.0: N.L > 0
    lit2_2 <= '1' when nl2_exact_2 /= 0 else '0';
    -- UQ1.0: the light is behind the surface
    dark2_2 <= not lit2_2;
    -- UQ1.18: N.L, rounded down
    nl2_2 <= nl2_exact_2(32 downto 14);
    -- Q1.18: L.V, taken into [-1, 1]
    lv2_2 <= to_signed(-262144, 20) when lv2_cut_2(22 downto 18) < -1 else
        to_signed(262144, 20) when lv2_cut_2(22 downto 18) > 0 else
        lv2_cut_2(19 downto 0);
    -- Q1.18: a sign bit for the signed product
    nl2_signed_2 <= signed(resize(nl2_2, 20));
    -- UQ-1.18: the 17 low bits of nl2_signed
    nl2_signed_low_2 <= unsigned(nl2_signed_2(16 downto 0));
    -- Q-1.18: with a sign of 0
    nl2_signed_low_signed_2 <= signed(resize(nl2_signed_low_2, 18));
    -- Q1.1: nl2_signed without its 17 low bits
    nl2_signed_high_2 <= nl2_signed_2(19 downto 17);
    -- UQ1.12: N.L for the diffuse term, rounded down
    psi2_2 <= nl2_2(18 downto 6);
    -- UQ-3.12: k_d, colour and light
    diffuse_r_2_2 <= unsigned(colours_2(59 downto 51));
    -- UQ-2.12: k_s, colour and light
    specular_r_2_2 <= unsigned(colours_2(50 downto 41));
    -- UQ-3.12: k_d, colour and light
    diffuse_g_2_2 <= unsigned(colours_2(40 downto 32));
    -- UQ-1.12: k_s, colour and light
    specular_g_2_2 <= unsigned(colours_2(31 downto 21));
    -- UQ-2.12: k_d, colour and light
    diffuse_b_2_2 <= unsigned(colours_2(20 downto 11));
    -- UQ-1.12: k_s, colour and light
    specular_b_2_2 <= unsigned(colours_2(10 downto 0));
    -- UQ-2.12: ambient light, k_a and colour
    ambient_r_2 <= unsigned(colours_2(155 downto 146));
    -- UQ-3.12: ambient light, k_a and colour
    ambient_g_2 <= unsigned(colours_2(145 downto 137));
    -- UQ-3.12: ambient light, k_a and colour
    ambient_b_2 <= unsigned(colours_2(136 downto 128));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_material_3 <= in_material_2;
                dark1_3 <= dark1_2;
                lv1_3 <= lv1_2;
                nl1_signed_low_signed_3 <= nl1_signed_low_signed_2;
                nl1_signed_high_3 <= nl1_signed_high_2;
                nv_low_signed_3 <= nv_low_signed_2;
                nv_high_3 <= nv_high_2;
                psi1_3 <= psi1_2;
                diffuse_r_1_3 <= diffuse_r_1_2;
                specular_r_1_3 <= specular_r_1_2;
                diffuse_g_1_3 <= diffuse_g_1_2;
                specular_g_1_3 <= specular_g_1_2;
                diffuse_b_1_3 <= diffuse_b_1_2;
                specular_b_1_3 <= specular_b_1_2;
                dark2_3 <= dark2_2;
                lv2_3 <= lv2_2;
                nl2_signed_low_signed_3 <= nl2_signed_low_signed_2;
                nl2_signed_high_3 <= nl2_signed_high_2;
                psi2_3 <= psi2_2;
                diffuse_r_2_3 <= diffuse_r_2_2;
                specular_r_2_3 <= specular_r_2_2;
                diffuse_g_2_3 <= diffuse_g_2_2;
                specular_g_2_3 <= specular_g_2_2;
                diffuse_b_2_3 <= diffuse_b_2_2;
                specular_b_2_3 <= specular_b_2_2;
                ambient_r_3 <= ambient_r_2;
                ambient_g_3 <= ambient_g_2;
                ambient_b_3 <= ambient_b_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: nlv1_low_l, nlv1_low_h, nlv1_high_l, nlv1_high_h and 10 more
    -- Q-1.36: part of nlv1_low
    nlv1_low_l_3 <= nl1_signed_low_signed_3 * nv_low_signed_3;
    -- Q1.19: part of nlv1_low
    nlv1_low_h_3 <= nl1_signed_low_signed_3 * nv_high_3;
    -- Q1.19: part of nlv1_high
    nlv1_high_l_3 <= nl1_signed_high_3 * nv_low_signed_3;
    -- Q3.2: part of nlv1_high
    nlv1_high_h_3 <= nl1_signed_high_3 * nv_high_3;
    -- UQ0.24: colour times cosine
    dif1_r_exact_3 <= diffuse_r_1_3 * psi1_3;
    -- UQ-1.13: rounded down
    dif1_r_3 <= dif1_r_exact_3(22 downto 11);
    -- UQ0.24: colour times cosine
    dif1_g_exact_3 <= diffuse_g_1_3 * psi1_3;
    -- UQ-1.13: rounded down
    dif1_g_3 <= dif1_g_exact_3(22 downto 11);
    -- UQ-1.24: colour times cosine
    dif1_b_exact_3 <= diffuse_b_1_3 * psi1_3;
    -- UQ-2.13: rounded down
    dif1_b_3 <= dif1_b_exact_3(21 downto 11);
    -- Q-1.36: part of nlv2_low
    nlv2_low_l_3 <= nl2_signed_low_signed_3 * nv_low_signed_3;
    -- Q1.19: part of nlv2_low
    nlv2_low_h_3 <= nl2_signed_low_signed_3 * nv_high_3;
    -- Q1.19: part of nlv2_high
    nlv2_high_l_3 <= nl2_signed_high_3 * nv_low_signed_3;
    -- Q3.2: part of nlv2_high
    nlv2_high_h_3 <= nl2_signed_high_3 * nv_high_3;
    -- UQ-2.24: colour times cosine
    dif2_r_exact_3 <= diffuse_r_2_3 * psi2_3;
    -- UQ-3.13: rounded down
    dif2_r_3 <= dif2_r_exact_3(20 downto 11);
    -- UQ-2.24: colour times cosine
    dif2_g_exact_3 <= diffuse_g_2_3 * psi2_3;
    -- UQ-3.13: rounded down
    dif2_g_3 <= dif2_g_exact_3(20 downto 11);
    -- UQ-1.24: colour times cosine
    dif2_b_exact_3 <= diffuse_b_2_3 * psi2_3;
    -- UQ-2.13: rounded down
    dif2_b_3 <= dif2_b_exact_3(21 downto 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_material_4 <= in_material_3;
                dark1_4 <= dark1_3;
                lv1_4 <= lv1_3;
                nlv1_low_l_4 <= nlv1_low_l_3;
                nlv1_low_h_4 <= nlv1_low_h_3;
                nlv1_high_l_4 <= nlv1_high_l_3;
                nlv1_high_h_4 <= nlv1_high_h_3;
                dif1_r_4 <= dif1_r_3;
                specular_r_1_4 <= specular_r_1_3;
                dif1_g_4 <= dif1_g_3;
                specular_g_1_4 <= specular_g_1_3;
                dif1_b_4 <= dif1_b_3;
                specular_b_1_4 <= specular_b_1_3;
                dark2_4 <= dark2_3;
                lv2_4 <= lv2_3;
                nlv2_low_l_4 <= nlv2_low_l_3;
                nlv2_low_h_4 <= nlv2_low_h_3;
                nlv2_high_l_4 <= nlv2_high_l_3;
                nlv2_high_h_4 <= nlv2_high_h_3;
                dif2_r_4 <= dif2_r_3;
                specular_r_2_4 <= specular_r_2_3;
                dif2_g_4 <= dif2_g_3;
                specular_g_2_4 <= specular_g_2_3;
                dif2_b_4 <= dif2_b_3;
                specular_b_2_4 <= specular_b_2_3;
                ambient_r_4 <= ambient_r_3;
                ambient_g_4 <= ambient_g_3;
                ambient_b_4 <= ambient_b_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: nlv1_low, nlv1_high, nlv1, nlv2_low, nlv2_high, nlv2
    -- Q1.36: part of nlv1
    nlv1_low_4 <= resize(nlv1_low_l_4, 38) + shift_left(resize(nlv1_low_h_4, 38), 17);
    -- Q3.19: part of nlv1
    nlv1_high_4 <= resize(nlv1_high_l_4, 23) + shift_left(resize(nlv1_high_h_4, 23), 17);
    -- Q3.36: (N.L)(N.V)
    nlv1_4 <= resize(nlv1_low_4, 40) + shift_left(resize(nlv1_high_4, 40), 17);
    -- Q4.35: 2 (N.L)(N.V)
    nlv1_twice_4 <= nlv1_4;
    -- Q1.36: part of nlv2
    nlv2_low_4 <= resize(nlv2_low_l_4, 38) + shift_left(resize(nlv2_low_h_4, 38), 17);
    -- Q3.19: part of nlv2
    nlv2_high_4 <= resize(nlv2_high_l_4, 23) + shift_left(resize(nlv2_high_h_4, 23), 17);
    -- Q3.36: (N.L)(N.V)
    nlv2_4 <= resize(nlv2_low_4, 40) + shift_left(resize(nlv2_high_4, 40), 17);
    -- Q4.35: 2 (N.L)(N.V)
    nlv2_twice_4 <= nlv2_4;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                in_material_5 <= in_material_4;
                dark1_5 <= dark1_4;
                lv1_5 <= lv1_4;
                nlv1_twice_5 <= nlv1_twice_4;
                dif1_r_5 <= dif1_r_4;
                specular_r_1_5 <= specular_r_1_4;
                dif1_g_5 <= dif1_g_4;
                specular_g_1_5 <= specular_g_1_4;
                dif1_b_5 <= dif1_b_4;
                specular_b_1_5 <= specular_b_1_4;
                dark2_5 <= dark2_4;
                lv2_5 <= lv2_4;
                nlv2_twice_5 <= nlv2_twice_4;
                dif2_r_5 <= dif2_r_4;
                specular_r_2_5 <= specular_r_2_4;
                dif2_g_5 <= dif2_g_4;
                specular_g_2_5 <= specular_g_2_4;
                dif2_b_5 <= dif2_b_4;
                specular_b_2_5 <= specular_b_2_4;
                ambient_r_5 <= ambient_r_4;
                ambient_g_5 <= ambient_g_4;
                ambient_b_5 <= ambient_b_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: read the ROM, x1_exact, x1_half, x2_exact, x2_half
    -- Q2.35: 2 (N.L)(N.V) - L.V
    x1_exact_5 <= nlv1_twice_5(37 downto 0) - shift_left(resize(lv1_5, 38), 17);
    -- Q2.35: plus half a last bit
    x1_half_5 <= x1_exact_5 + to_signed(262144, 38);
    -- Q2.16: rounded to nearest
    x1_cut_5 <= x1_half_5(37 downto 19);
    -- Q2.35: 2 (N.L)(N.V) - L.V
    x2_exact_5 <= nlv2_twice_5(37 downto 0) - shift_left(resize(lv2_5, 38), 17);
    -- Q2.35: plus half a last bit
    x2_half_5 <= x2_exact_5 + to_signed(262144, 38);
    -- Q2.16: rounded to nearest
    x2_cut_5 <= x2_half_5(37 downto 19);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_6(13 downto 0) <=
                    ROM_WORDS_0(to_integer(in_material_5))(13 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_6 <= dark1_5;
                x1_cut_6 <= x1_cut_5;
                dif1_r_6 <= dif1_r_5;
                specular_r_1_6 <= specular_r_1_5;
                dif1_g_6 <= dif1_g_5;
                specular_g_1_6 <= specular_g_1_5;
                dif1_b_6 <= dif1_b_5;
                specular_b_1_6 <= specular_b_1_5;
                dark2_6 <= dark2_5;
                x2_cut_6 <= x2_cut_5;
                dif2_r_6 <= dif2_r_5;
                specular_r_2_6 <= specular_r_2_5;
                dif2_g_6 <= dif2_g_5;
                specular_g_2_6 <= specular_g_2_5;
                dif2_b_6 <= dif2_b_5;
                specular_b_2_6 <= specular_b_2_5;
                ambient_r_6 <= ambient_r_5;
                ambient_g_6 <= ambient_g_5;
                ambient_b_6 <= ambient_b_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: x1, lobe1_u, lobe1_x_half, x2, lobe2_u, lobe2_x_half
    -- UQ1.16: x = 2 (N.L)(N.V) - L.V, taken into [0, 1]
    x1_6 <= (others => '0') when x1_cut_6(18) = '1' else
        (16 => '1', others => '0') when unsigned(x1_cut_6(17 downto 16)) /= 0 else
        unsigned(x1_cut_6(16 downto 0));
    -- UQ1.16: u = 1 - x, the versine
    lobe1_u_6 <= to_unsigned(65536, 17) - x1_6;
    -- UQ0.12: the coefficient a, times 2^-k
    lobe1_a_6 <= unsigned(rom_6(13 downto 2));
    -- UQ2.0: shift of the versine
    lobe1_k_6 <= unsigned(rom_6(1 downto 0));
    -- UQ1.14: x, rounded down
    lobe1_x_cut_6 <= x1_6(16 downto 2);
    -- UQ1.14: x + half an output ulp: the result is rounded to nearest
    lobe1_x_half_6 <= lobe1_x_cut_6 + to_unsigned(2, 15);
    -- UQ1.16: x = 2 (N.L)(N.V) - L.V, taken into [0, 1]
    x2_6 <= (others => '0') when x2_cut_6(18) = '1' else
        (16 => '1', others => '0') when unsigned(x2_cut_6(17 downto 16)) /= 0 else
        unsigned(x2_cut_6(16 downto 0));
    -- UQ1.16: u = 1 - x, the versine
    lobe2_u_6 <= to_unsigned(65536, 17) - x2_6;
    -- UQ1.14: x, rounded down
    lobe2_x_cut_6 <= x2_6(16 downto 2);
    -- UQ1.14: x + half an output ulp: the result is rounded to nearest
    lobe2_x_half_6 <= lobe2_x_cut_6 + to_unsigned(2, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_7 <= dark1_6;
                lobe1_u_7 <= lobe1_u_6;
                lobe1_a_7 <= lobe1_a_6;
                lobe1_k_7 <= lobe1_k_6;
                lobe1_x_cut_7 <= lobe1_x_cut_6;
                lobe1_x_half_7 <= lobe1_x_half_6;
                dif1_r_7 <= dif1_r_6;
                specular_r_1_7 <= specular_r_1_6;
                dif1_g_7 <= dif1_g_6;
                specular_g_1_7 <= specular_g_1_6;
                dif1_b_7 <= dif1_b_6;
                specular_b_1_7 <= specular_b_1_6;
                dark2_7 <= dark2_6;
                lobe2_u_7 <= lobe2_u_6;
                lobe2_x_cut_7 <= lobe2_x_cut_6;
                lobe2_x_half_7 <= lobe2_x_half_6;
                dif2_r_7 <= dif2_r_6;
                specular_r_2_7 <= specular_r_2_6;
                dif2_g_7 <= dif2_g_6;
                specular_g_2_7 <= specular_g_2_6;
                dif2_b_7 <= dif2_b_6;
                specular_b_2_7 <= specular_b_2_6;
                ambient_r_7 <= ambient_r_6;
                ambient_g_7 <= ambient_g_6;
                ambient_b_7 <= ambient_b_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: lobe1_u_scaled, lobe2_u_scaled
    -- UQ7.13: u 2^(k + 3)
    lobe1_u_scaled_7 <= shift_left(resize(lobe1_u_7, 20), to_integer(lobe1_k_7));
    -- UQ7.-1: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    lobe1_beyond_bits_7 <= lobe1_u_scaled_7(19 downto 14);
    -- UQ1.0: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    lobe1_beyond_7 <= '1' when lobe1_beyond_bits_7 /= 0 else '0';
    -- UQ1.13: v = u 2^k, rounded down
    lobe1_v_7 <= lobe1_u_scaled_7(13 downto 0);
    -- UQ7.13: u 2^(k + 3)
    lobe2_u_scaled_7 <= shift_left(resize(lobe2_u_7, 20), to_integer(lobe1_k_7));
    -- UQ7.-1: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    lobe2_beyond_bits_7 <= lobe2_u_scaled_7(19 downto 14);
    -- UQ1.0: u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2
    lobe2_beyond_7 <= '1' when lobe2_beyond_bits_7 /= 0 else '0';
    -- UQ1.13: v = u 2^k, rounded down
    lobe2_v_7 <= lobe2_u_scaled_7(13 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_8 <= dark1_7;
                lobe1_a_8 <= lobe1_a_7;
                lobe1_beyond_8 <= lobe1_beyond_7;
                lobe1_v_8 <= lobe1_v_7;
                lobe1_x_cut_8 <= lobe1_x_cut_7;
                lobe1_x_half_8 <= lobe1_x_half_7;
                dif1_r_8 <= dif1_r_7;
                specular_r_1_8 <= specular_r_1_7;
                dif1_g_8 <= dif1_g_7;
                specular_g_1_8 <= specular_g_1_7;
                dif1_b_8 <= dif1_b_7;
                specular_b_1_8 <= specular_b_1_7;
                dark2_8 <= dark2_7;
                lobe2_beyond_8 <= lobe2_beyond_7;
                lobe2_v_8 <= lobe2_v_7;
                lobe2_x_cut_8 <= lobe2_x_cut_7;
                lobe2_x_half_8 <= lobe2_x_half_7;
                dif2_r_8 <= dif2_r_7;
                specular_r_2_8 <= specular_r_2_7;
                dif2_g_8 <= dif2_g_7;
                specular_g_2_8 <= specular_g_2_7;
                dif2_b_8 <= dif2_b_7;
                specular_b_2_8 <= specular_b_2_7;
                ambient_r_8 <= ambient_r_7;
                ambient_g_8 <= ambient_g_7;
                ambient_b_8 <= ambient_b_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_9 <= dark1_8;
                lobe1_a_9 <= lobe1_a_8;
                lobe1_beyond_9 <= lobe1_beyond_8;
                lobe1_v_9 <= lobe1_v_8;
                lobe1_x_cut_9 <= lobe1_x_cut_8;
                lobe1_x_half_9 <= lobe1_x_half_8;
                dif1_r_9 <= dif1_r_8;
                specular_r_1_9 <= specular_r_1_8;
                dif1_g_9 <= dif1_g_8;
                specular_g_1_9 <= specular_g_1_8;
                dif1_b_9 <= dif1_b_8;
                specular_b_1_9 <= specular_b_1_8;
                dark2_9 <= dark2_8;
                lobe2_beyond_9 <= lobe2_beyond_8;
                lobe2_v_9 <= lobe2_v_8;
                lobe2_x_cut_9 <= lobe2_x_cut_8;
                lobe2_x_half_9 <= lobe2_x_half_8;
                dif2_r_9 <= dif2_r_8;
                specular_r_2_9 <= specular_r_2_8;
                dif2_g_9 <= dif2_g_8;
                specular_g_2_9 <= specular_g_2_8;
                dif2_b_9 <= dif2_b_8;
                specular_b_2_9 <= specular_b_2_8;
                ambient_r_9 <= ambient_r_8;
                ambient_g_9 <= ambient_g_8;
                ambient_b_9 <= ambient_b_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: lobe1_av, lobe2_av
    -- UQ1.25: a u = (a 2^-k) v
    lobe1_av_9 <= lobe1_a_9 * lobe1_v_9;
    -- UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    lobe1_p_above_bits_9 <= lobe1_av_9(25);
    -- UQ0.14: p, rounded down
    lobe1_p_9 <= lobe1_av_9(24 downto 11);
    -- UQ1.25: a u = (a 2^-k) v
    lobe2_av_9 <= lobe1_a_9 * lobe2_v_9;
    -- UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    lobe2_p_above_bits_9 <= lobe2_av_9(25);
    -- UQ0.14: p, rounded down
    lobe2_p_9 <= lobe2_av_9(24 downto 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_10 <= dark1_9;
                lobe1_beyond_10 <= lobe1_beyond_9;
                lobe1_x_cut_10 <= lobe1_x_cut_9;
                lobe1_p_above_bits_10 <= lobe1_p_above_bits_9;
                lobe1_p_10 <= lobe1_p_9;
                lobe1_x_half_10 <= lobe1_x_half_9;
                dif1_r_10 <= dif1_r_9;
                specular_r_1_10 <= specular_r_1_9;
                dif1_g_10 <= dif1_g_9;
                specular_g_1_10 <= specular_g_1_9;
                dif1_b_10 <= dif1_b_9;
                specular_b_1_10 <= specular_b_1_9;
                dark2_10 <= dark2_9;
                lobe2_beyond_10 <= lobe2_beyond_9;
                lobe2_x_cut_10 <= lobe2_x_cut_9;
                lobe2_p_above_bits_10 <= lobe2_p_above_bits_9;
                lobe2_p_10 <= lobe2_p_9;
                lobe2_x_half_10 <= lobe2_x_half_9;
                dif2_r_10 <= dif2_r_9;
                specular_r_2_10 <= specular_r_2_9;
                dif2_g_10 <= dif2_g_9;
                specular_g_2_10 <= specular_g_2_9;
                dif2_b_10 <= dif2_b_9;
                specular_b_2_10 <= specular_b_2_9;
                ambient_r_10 <= ambient_r_9;
                ambient_g_10 <= ambient_g_9;
                ambient_b_10 <= ambient_b_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: lobe1_xp, lobe2_xp
    -- UQ1.0: the result is 0
    lobe1_zero_10 <= lobe1_beyond_10 or lobe1_p_above_bits_10;
    -- UQ1.28: x p
    lobe1_xp_10 <= lobe1_x_cut_10 * lobe1_p_10;
    -- UQ0.15: t = x p, rounded down
    lobe1_t_10 <= lobe1_xp_10(27 downto 13);
    -- UQ1.0: the result is 0
    lobe2_zero_10 <= lobe2_beyond_10 or lobe2_p_above_bits_10;
    -- UQ1.28: x p
    lobe2_xp_10 <= lobe2_x_cut_10 * lobe2_p_10;
    -- UQ0.15: t = x p, rounded down
    lobe2_t_10 <= lobe2_xp_10(27 downto 13);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark1_11 <= dark1_10;
                lobe1_zero_11 <= lobe1_zero_10;
                lobe1_t_11 <= lobe1_t_10;
                lobe1_x_half_11 <= lobe1_x_half_10;
                dif1_r_11 <= dif1_r_10;
                specular_r_1_11 <= specular_r_1_10;
                dif1_g_11 <= dif1_g_10;
                specular_g_1_11 <= specular_g_1_10;
                dif1_b_11 <= dif1_b_10;
                specular_b_1_11 <= specular_b_1_10;
                dark2_11 <= dark2_10;
                lobe2_zero_11 <= lobe2_zero_10;
                lobe2_t_11 <= lobe2_t_10;
                lobe2_x_half_11 <= lobe2_x_half_10;
                dif2_r_11 <= dif2_r_10;
                specular_r_2_11 <= specular_r_2_10;
                dif2_g_11 <= dif2_g_10;
                specular_g_2_11 <= specular_g_2_10;
                dif2_b_11 <= dif2_b_10;
                specular_b_2_11 <= specular_b_2_10;
                ambient_r_11 <= ambient_r_10;
                ambient_g_11 <= ambient_g_10;
                ambient_b_11 <= ambient_b_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: lobe1_y_exact, lobe1_y, spec1, lobe2_y_exact, lobe2_y and 1 more
    -- UQ1.15: x - t = x (1 - p)
    lobe1_y_exact_11 <= shift_left(resize(lobe1_x_half_11, 16), 1) - resize(lobe1_t_11, 16);
    -- UQ1.12: rounded down to the output's bits
    lobe1_y_cut_11 <= lobe1_y_exact_11(15 downto 3);
    -- UQ1.12: y, 0 where the lobe has ended
    lobe1_y_11 <= (others => '0') when lobe1_zero_11 = '1' else lobe1_y_cut_11;
    -- UQ1.12: no highlight from a light behind the surface
    spec1_11 <= (others => '0') when dark1_11 = '1' else lobe1_y_11;
    -- UQ1.15: x - t = x (1 - p)
    lobe2_y_exact_11 <= shift_left(resize(lobe2_x_half_11, 16), 1) - resize(lobe2_t_11, 16);
    -- UQ1.12: rounded down to the output's bits
    lobe2_y_cut_11 <= lobe2_y_exact_11(15 downto 3);
    -- UQ1.12: y, 0 where the lobe has ended
    lobe2_y_11 <= (others => '0') when lobe2_zero_11 = '1' else lobe2_y_cut_11;
    -- UQ1.12: no highlight from a light behind the surface
    spec2_11 <= (others => '0') when dark2_11 = '1' else lobe2_y_11;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                spec1_12 <= spec1_11;
                dif1_r_12 <= dif1_r_11;
                specular_r_1_12 <= specular_r_1_11;
                dif1_g_12 <= dif1_g_11;
                specular_g_1_12 <= specular_g_1_11;
                dif1_b_12 <= dif1_b_11;
                specular_b_1_12 <= specular_b_1_11;
                spec2_12 <= spec2_11;
                dif2_r_12 <= dif2_r_11;
                specular_r_2_12 <= specular_r_2_11;
                dif2_g_12 <= dif2_g_11;
                specular_g_2_12 <= specular_g_2_11;
                dif2_b_12 <= dif2_b_11;
                specular_b_2_12 <= specular_b_2_11;
                ambient_r_12 <= ambient_r_11;
                ambient_g_12 <= ambient_g_11;
                ambient_b_12 <= ambient_b_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: spc1_r_exact, spc1_g_exact, spc1_b_exact, spc2_r_exact and 2 more
    -- UQ1.24: colour times cosine
    spc1_r_exact_12 <= specular_r_1_12 * spec1_12;
    -- UQ1.13: rounded down
    spc1_r_12 <= spc1_r_exact_12(24 downto 11);
    -- UQ1.24: colour times cosine
    spc1_g_exact_12 <= specular_g_1_12 * spec1_12;
    -- UQ1.13: rounded down
    spc1_g_12 <= spc1_g_exact_12(24 downto 11);
    -- UQ1.24: colour times cosine
    spc1_b_exact_12 <= specular_b_1_12 * spec1_12;
    -- UQ1.13: rounded down
    spc1_b_12 <= spc1_b_exact_12(24 downto 11);
    -- UQ-1.24: colour times cosine
    spc2_r_exact_12 <= specular_r_2_12 * spec2_12;
    -- UQ-1.13: rounded down
    spc2_r_12 <= spc2_r_exact_12(22 downto 11);
    -- UQ0.24: colour times cosine
    spc2_g_exact_12 <= specular_g_2_12 * spec2_12;
    -- UQ0.13: rounded down
    spc2_g_12 <= spc2_g_exact_12(23 downto 11);
    -- UQ0.24: colour times cosine
    spc2_b_exact_12 <= specular_b_2_12 * spec2_12;
    -- UQ0.13: rounded down
    spc2_b_12 <= spc2_b_exact_12(23 downto 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dif1_r_13 <= dif1_r_12;
                spc1_r_13 <= spc1_r_12;
                dif1_g_13 <= dif1_g_12;
                spc1_g_13 <= spc1_g_12;
                dif1_b_13 <= dif1_b_12;
                spc1_b_13 <= spc1_b_12;
                dif2_r_13 <= dif2_r_12;
                spc2_r_13 <= spc2_r_12;
                dif2_g_13 <= dif2_g_12;
                spc2_g_13 <= spc2_g_12;
                dif2_b_13 <= dif2_b_12;
                spc2_b_13 <= spc2_b_12;
                ambient_r_13 <= ambient_r_12;
                ambient_g_13 <= ambient_g_12;
                ambient_b_13 <= ambient_b_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: both1_r, both1_g, both1_b, both2_r, lights2_r, both2_g and 3 more
    -- UQ1.13: diffuse and specular
    both1_r_13 <= resize(dif1_r_13, 14) + spc1_r_13;
    -- UQ1.13: diffuse and specular
    both1_g_13 <= resize(dif1_g_13, 14) + spc1_g_13;
    -- UQ1.13: diffuse and specular
    both1_b_13 <= resize(dif1_b_13, 14) + spc1_b_13;
    -- UQ-1.13: diffuse and specular
    both2_r_13 <= resize(dif2_r_13, 12) + spc2_r_13;
    -- UQ2.13: the lights so far
    lights2_r_13 <= resize(both1_r_13, 15) + resize(both2_r_13, 15);
    -- UQ0.13: diffuse and specular
    both2_g_13 <= resize(dif2_g_13, 13) + spc2_g_13;
    -- UQ2.13: the lights so far
    lights2_g_13 <= resize(both1_g_13, 15) + resize(both2_g_13, 15);
    -- UQ0.13: diffuse and specular
    both2_b_13 <= resize(dif2_b_13, 13) + spc2_b_13;
    -- UQ2.13: the lights so far
    lights2_b_13 <= resize(both1_b_13, 15) + resize(both2_b_13, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                lights2_r_14 <= lights2_r_13;
                lights2_g_14 <= lights2_g_13;
                lights2_b_14 <= lights2_b_13;
                ambient_r_14 <= ambient_r_13;
                ambient_g_14 <= ambient_g_13;
                ambient_b_14 <= ambient_b_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: sum_r, sum_half_r, sum_g, sum_half_g, sum_b, sum_half_b
    -- UQ2.13: with the ambient light
    sum_r_14 <= lights2_r_14 + shift_left(resize(ambient_r_14, 15), 1);
    -- UQ2.13: plus half a code
    sum_half_r_14 <= sum_r_14 + to_unsigned(16, 15);
    -- UQ2.8: rounded to the nearest code
    cut_r_14 <= sum_half_r_14(14 downto 5);
    -- UQ2.13: with the ambient light
    sum_g_14 <= lights2_g_14 + shift_left(resize(ambient_g_14, 15), 1);
    -- UQ2.13: plus half a code
    sum_half_g_14 <= sum_g_14 + to_unsigned(16, 15);
    -- UQ2.8: rounded to the nearest code
    cut_g_14 <= sum_half_g_14(14 downto 5);
    -- UQ2.13: with the ambient light
    sum_b_14 <= lights2_b_14 + shift_left(resize(ambient_b_14, 15), 1);
    -- UQ2.13: plus half a code
    sum_half_b_14 <= sum_b_14 + to_unsigned(16, 15);
    -- UQ2.8: rounded to the nearest code
    cut_b_14 <= sum_half_b_14(14 downto 5);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                cut_r_15 <= cut_r_14;
                cut_g_15 <= cut_g_14;
                cut_b_15 <= cut_b_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: kept_r, kept_g, kept_b
    -- UQ0.8: at most full scale
    kept_r_15 <= to_unsigned(255, 8) when unsigned(cut_r_15(9 downto 8)) /= 0 else
        cut_r_15(7 downto 0);
    -- UQ8.0: as a whole number
    code_r_15 <= kept_r_15;
    -- UQ0.8: at most full scale
    kept_g_15 <= to_unsigned(255, 8) when unsigned(cut_g_15(9 downto 8)) /= 0 else
        cut_g_15(7 downto 0);
    -- UQ8.0: as a whole number
    code_g_15 <= kept_g_15;
    -- UQ0.8: at most full scale
    kept_b_15 <= to_unsigned(255, 8) when unsigned(cut_b_15(9 downto 8)) /= 0 else
        cut_b_15(7 downto 0);
    -- UQ8.0: as a whole number
    code_b_15 <= kept_b_15;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                code_r_16 <= code_r_15;
                code_g_16 <= code_g_15;
                code_b_16 <= code_b_15;
            end if;
        end if;
    end process;

    out_valid <= valid(16);
    out_r     <= code_r_16;
    out_g     <= code_g_16;
    out_b     <= code_b_16;

end architecture rtl;
