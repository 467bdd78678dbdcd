-- squaring: specular lobe x^n as x^n by log2 n squarings, 8 shininesses
--
-- Made by: brdfgen generate core.toml
-- Spec 8bd38130fdf7535e. Generated; the core is yours to use under any terms.
--
--   in_n      UQ3.0   index of the shininess, 0 to 7; above: the last
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 20 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.859..+0.500.
--   measured -0.613..+0.500 over all 32776 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.01496 % absolute, 0.01496 % where x^n >= 1/2, 0.02412 % relative there.
-- As the cosine rises, the output never falls: proved by running all 32768 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity squaring is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ3.0: index of the shininess, 0 to 7; above: the last
        in_n      : in  unsigned(2 downto 0);
        -- Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(13 downto 0);
        -- out_spec is a result: in_valid, 20 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity squaring;

architecture rtl of squaring is
    -- ===== The memory rom
    -- Bits 2 downto 0 of each word.
    type rom_words_0_t is array (7 downto 0) of
        std_logic_vector(3 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        7 => x"7",
        6 => x"6",
        5 => x"5",
        4 => x"4",
        3 => x"3",
        2 => x"2",
        1 => x"1",
        0 => x"0"
    );
    signal rom_1 : std_logic_vector(2 downto 0) := (others => '0');

    signal valid : std_logic_vector(20 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal x_wide_0 : unsigned(16 downto 0) := (others => '0');
    signal x_1 : unsigned(12 downto 0) := (others => '0');
    signal x_wide_1 : unsigned(16 downto 0) := (others => '0');
    signal x2_exact_1 : unsigned(25 downto 0) := (others => '0');
    signal x2_1 : unsigned(22 downto 0) := (others => '0');
    signal x2_cut_1 : unsigned(16 downto 0) := (others => '0');
    signal x2_low_1 : unsigned(17 downto 0) := (others => '0');
    signal x2_high_1 : unsigned(4 downto 0) := (others => '0');
    signal tap_0_1 : std_logic := '0';
    signal tap_1_1 : std_logic := '0';
    signal tap_2_1 : std_logic := '0';
    signal x2_cut_2 : unsigned(16 downto 0) := (others => '0');
    signal x2_low_2 : unsigned(17 downto 0) := (others => '0');
    signal x2_high_2 : unsigned(4 downto 0) := (others => '0');
    signal tap_0_2 : std_logic := '0';
    signal x_wide_2 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_2 : std_logic := '0';
    signal tap_2_2 : std_logic := '0';
    signal x4_exact_low_2 : unsigned(35 downto 0) := (others => '0');
    signal x4_exact_mixed_2 : unsigned(22 downto 0) := (others => '0');
    signal x4_exact_high_2 : unsigned(9 downto 0) := (others => '0');
    signal x4_exact_twice_2 : unsigned(22 downto 0) := (others => '0');
    signal power_0_0_2 : unsigned(16 downto 0) := (others => '0');
    signal x4_exact_low_3 : unsigned(35 downto 0) := (others => '0');
    signal x4_exact_high_3 : unsigned(9 downto 0) := (others => '0');
    signal x4_exact_twice_3 : unsigned(22 downto 0) := (others => '0');
    signal tap_0_3 : std_logic := '0';
    signal power_0_0_3 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_3 : std_logic := '0';
    signal tap_2_3 : std_logic := '0';
    signal x4_exact_ends_3 : unsigned(45 downto 0) := (others => '0');
    signal x4_exact_3 : unsigned(45 downto 0) := (others => '0');
    signal x4_3 : unsigned(21 downto 0) := (others => '0');
    signal x4_cut_3 : unsigned(16 downto 0) := (others => '0');
    signal x4_low_3 : unsigned(17 downto 0) := (others => '0');
    signal x4_high_3 : unsigned(3 downto 0) := (others => '0');
    signal x4_cut_4 : unsigned(16 downto 0) := (others => '0');
    signal x4_low_4 : unsigned(17 downto 0) := (others => '0');
    signal x4_high_4 : unsigned(3 downto 0) := (others => '0');
    signal tap_0_4 : std_logic := '0';
    signal power_0_0_4 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_4 : std_logic := '0';
    signal tap_2_4 : std_logic := '0';
    signal x4_cut_5 : unsigned(16 downto 0) := (others => '0');
    signal x4_low_5 : unsigned(17 downto 0) := (others => '0');
    signal x4_high_5 : unsigned(3 downto 0) := (others => '0');
    signal tap_0_5 : std_logic := '0';
    signal power_0_0_5 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_5 : std_logic := '0';
    signal tap_2_5 : std_logic := '0';
    signal x8_exact_low_5 : unsigned(35 downto 0) := (others => '0');
    signal x8_exact_mixed_5 : unsigned(21 downto 0) := (others => '0');
    signal x8_exact_high_5 : unsigned(7 downto 0) := (others => '0');
    signal x8_exact_twice_5 : unsigned(21 downto 0) := (others => '0');
    signal x4_cut_6 : unsigned(16 downto 0) := (others => '0');
    signal x8_exact_low_6 : unsigned(35 downto 0) := (others => '0');
    signal x8_exact_high_6 : unsigned(7 downto 0) := (others => '0');
    signal x8_exact_twice_6 : unsigned(21 downto 0) := (others => '0');
    signal tap_0_6 : std_logic := '0';
    signal power_0_0_6 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_6 : std_logic := '0';
    signal tap_2_6 : std_logic := '0';
    signal x8_exact_ends_6 : unsigned(43 downto 0) := (others => '0');
    signal x8_exact_6 : unsigned(43 downto 0) := (others => '0');
    signal x8_6 : unsigned(20 downto 0) := (others => '0');
    signal x8_cut_6 : unsigned(16 downto 0) := (others => '0');
    signal x8_low_6 : unsigned(17 downto 0) := (others => '0');
    signal x8_high_6 : unsigned(2 downto 0) := (others => '0');
    signal x4_cut_7 : unsigned(16 downto 0) := (others => '0');
    signal x8_cut_7 : unsigned(16 downto 0) := (others => '0');
    signal x8_low_7 : unsigned(17 downto 0) := (others => '0');
    signal x8_high_7 : unsigned(2 downto 0) := (others => '0');
    signal tap_0_7 : std_logic := '0';
    signal power_0_0_7 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_7 : std_logic := '0';
    signal tap_2_7 : std_logic := '0';
    signal power_0_1_7 : unsigned(16 downto 0) := (others => '0');
    signal power_1_0_7 : unsigned(16 downto 0) := (others => '0');
    signal x8_low_8 : unsigned(17 downto 0) := (others => '0');
    signal x8_high_8 : unsigned(2 downto 0) := (others => '0');
    signal tap_0_8 : std_logic := '0';
    signal tap_1_8 : std_logic := '0';
    signal power_1_0_8 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_8 : std_logic := '0';
    signal x16_exact_low_8 : unsigned(35 downto 0) := (others => '0');
    signal x16_exact_mixed_8 : unsigned(20 downto 0) := (others => '0');
    signal x16_exact_high_8 : unsigned(5 downto 0) := (others => '0');
    signal x16_exact_twice_8 : unsigned(20 downto 0) := (others => '0');
    signal x16_exact_low_9 : unsigned(35 downto 0) := (others => '0');
    signal x16_exact_high_9 : unsigned(5 downto 0) := (others => '0');
    signal x16_exact_twice_9 : unsigned(20 downto 0) := (others => '0');
    signal tap_0_9 : std_logic := '0';
    signal tap_1_9 : std_logic := '0';
    signal power_1_0_9 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_9 : std_logic := '0';
    signal x16_exact_ends_9 : unsigned(41 downto 0) := (others => '0');
    signal x16_exact_9 : unsigned(41 downto 0) := (others => '0');
    signal x16_9 : unsigned(19 downto 0) := (others => '0');
    signal x16_cut_9 : unsigned(16 downto 0) := (others => '0');
    signal x16_low_9 : unsigned(17 downto 0) := (others => '0');
    signal x16_high_9 : unsigned(1 downto 0) := (others => '0');
    signal x16_cut_10 : unsigned(16 downto 0) := (others => '0');
    signal x16_low_10 : unsigned(17 downto 0) := (others => '0');
    signal x16_high_10 : unsigned(1 downto 0) := (others => '0');
    signal tap_0_10 : std_logic := '0';
    signal tap_1_10 : std_logic := '0';
    signal power_1_0_10 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_10 : std_logic := '0';
    signal x16_cut_11 : unsigned(16 downto 0) := (others => '0');
    signal x16_low_11 : unsigned(17 downto 0) := (others => '0');
    signal x16_high_11 : unsigned(1 downto 0) := (others => '0');
    signal tap_0_11 : std_logic := '0';
    signal tap_1_11 : std_logic := '0';
    signal power_1_0_11 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_11 : std_logic := '0';
    signal x32_exact_low_11 : unsigned(35 downto 0) := (others => '0');
    signal x32_exact_mixed_11 : unsigned(19 downto 0) := (others => '0');
    signal x32_exact_high_11 : unsigned(3 downto 0) := (others => '0');
    signal x32_exact_twice_11 : unsigned(19 downto 0) := (others => '0');
    signal x16_cut_12 : unsigned(16 downto 0) := (others => '0');
    signal x32_exact_low_12 : unsigned(35 downto 0) := (others => '0');
    signal x32_exact_high_12 : unsigned(3 downto 0) := (others => '0');
    signal x32_exact_twice_12 : unsigned(19 downto 0) := (others => '0');
    signal tap_0_12 : std_logic := '0';
    signal tap_1_12 : std_logic := '0';
    signal power_1_0_12 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_12 : std_logic := '0';
    signal x32_exact_ends_12 : unsigned(39 downto 0) := (others => '0');
    signal x32_exact_12 : unsigned(39 downto 0) := (others => '0');
    signal x32_12 : unsigned(18 downto 0) := (others => '0');
    signal x32_cut_12 : unsigned(16 downto 0) := (others => '0');
    signal x32_low_12 : unsigned(17 downto 0) := (others => '0');
    signal x32_high_12 : unsigned(0 downto 0) := (others => '0');
    signal x16_cut_13 : unsigned(16 downto 0) := (others => '0');
    signal x32_cut_13 : unsigned(16 downto 0) := (others => '0');
    signal x32_low_13 : unsigned(17 downto 0) := (others => '0');
    signal x32_high_13 : unsigned(0 downto 0) := (others => '0');
    signal tap_0_13 : std_logic := '0';
    signal tap_1_13 : std_logic := '0';
    signal power_1_0_13 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_13 : std_logic := '0';
    signal power_0_2_13 : unsigned(16 downto 0) := (others => '0');
    signal x32_low_14 : unsigned(17 downto 0) := (others => '0');
    signal x32_high_14 : unsigned(0 downto 0) := (others => '0');
    signal tap_0_14 : std_logic := '0';
    signal power_0_2_14 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_14 : std_logic := '0';
    signal power_1_0_14 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_14 : std_logic := '0';
    signal x64_exact_low_14 : unsigned(35 downto 0) := (others => '0');
    signal x64_exact_mixed_14 : unsigned(18 downto 0) := (others => '0');
    signal x64_exact_high_14 : unsigned(1 downto 0) := (others => '0');
    signal x64_exact_twice_14 : unsigned(18 downto 0) := (others => '0');
    signal x64_exact_low_15 : unsigned(35 downto 0) := (others => '0');
    signal x64_exact_high_15 : unsigned(1 downto 0) := (others => '0');
    signal x64_exact_twice_15 : unsigned(18 downto 0) := (others => '0');
    signal tap_0_15 : std_logic := '0';
    signal power_0_2_15 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_15 : std_logic := '0';
    signal power_1_0_15 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_15 : std_logic := '0';
    signal x64_exact_ends_15 : unsigned(37 downto 0) := (others => '0');
    signal x64_exact_15 : unsigned(37 downto 0) := (others => '0');
    signal x64_15 : unsigned(17 downto 0) := (others => '0');
    signal x64_cut_15 : unsigned(16 downto 0) := (others => '0');
    signal x64_16 : unsigned(17 downto 0) := (others => '0');
    signal x64_cut_16 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_16 : std_logic := '0';
    signal power_0_2_16 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_16 : std_logic := '0';
    signal power_1_0_16 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_16 : std_logic := '0';
    signal x64_17 : unsigned(17 downto 0) := (others => '0');
    signal x64_cut_17 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_17 : std_logic := '0';
    signal power_0_2_17 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_17 : std_logic := '0';
    signal power_1_0_17 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_17 : std_logic := '0';
    signal x128_exact_17 : unsigned(35 downto 0) := (others => '0');
    signal x128_17 : unsigned(16 downto 0) := (others => '0');
    signal x64_cut_18 : unsigned(16 downto 0) := (others => '0');
    signal x128_18 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_18 : std_logic := '0';
    signal power_0_2_18 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_18 : std_logic := '0';
    signal power_1_0_18 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_18 : std_logic := '0';
    signal power_0_3_18 : unsigned(16 downto 0) := (others => '0');
    signal power_1_1_18 : unsigned(16 downto 0) := (others => '0');
    signal power_2_0_18 : unsigned(16 downto 0) := (others => '0');
    signal power_2_0_19 : unsigned(16 downto 0) := (others => '0');
    signal y_half_19 : unsigned(16 downto 0) := (others => '0');
    signal y_19 : unsigned(12 downto 0) := (others => '0');
    signal y_20 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(19 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: read the ROM, x
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.16: in the wider of two formats
    x_wide_0 <= shift_left(resize(x_0, 17), 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_1(2 downto 0) <=
                    ROM_WORDS_0(to_integer(in_n))(2 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_1 <= x_0;
                x_wide_1 <= x_wide_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: x2_exact
    -- UQ2.24: x^2
    x2_exact_1 <= x_1 * x_1;
    -- UQ1.22: x^2, rounded down
    x2_1 <= x2_exact_1(24 downto 2);
    -- UQ1.16: x^2 with fewer bits
    x2_cut_1 <= x2_1(22 downto 6);
    -- UQ-4.22: the 18 low bits of x2
    x2_low_1 <= x2_1(17 downto 0);
    -- UQ1.4: x2 without its 18 low bits
    x2_high_1 <= x2_1(22 downto 18);
    -- UQ1.0: a bit of the number of the power that is taken
    tap_0_1 <= rom_1(0);
    -- UQ1.0: a bit of the number of the power that is taken
    tap_1_1 <= rom_1(1);
    -- UQ1.0: a bit of the number of the power that is taken
    tap_2_1 <= rom_1(2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x2_cut_2 <= x2_cut_1;
                x2_low_2 <= x2_low_1;
                x2_high_2 <= x2_high_1;
                tap_0_2 <= tap_0_1;
                x_wide_2 <= x_wide_1;
                tap_1_2 <= tap_1_1;
                tap_2_2 <= tap_2_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: x4_exact_low, x4_exact_mixed, x4_exact_high, power_0_0
    -- UQ-8.44: part of x4_exact
    x4_exact_low_2 <= x2_low_2 * x2_low_2;
    -- UQ-3.26: part of x4_exact
    x4_exact_mixed_2 <= x2_low_2 * x2_high_2;
    -- UQ2.8: part of x4_exact
    x4_exact_high_2 <= x2_high_2 * x2_high_2;
    -- UQ-2.25: both mixed products
    x4_exact_twice_2 <= x4_exact_mixed_2;
    -- UQ1.16: one of two powers of x
    power_0_0_2 <= x2_cut_2 when tap_0_2 = '1' else x_wide_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_exact_low_3 <= x4_exact_low_2;
                x4_exact_high_3 <= x4_exact_high_2;
                x4_exact_twice_3 <= x4_exact_twice_2;
                tap_0_3 <= tap_0_2;
                power_0_0_3 <= power_0_0_2;
                tap_1_3 <= tap_1_2;
                tap_2_3 <= tap_2_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: x4_exact_ends, x4_exact
    -- UQ2.44: the squares of both parts
    x4_exact_ends_3 <= resize(x4_exact_low_3, 46) + shift_left(resize(x4_exact_high_3, 46), 36);
    -- UQ2.44: x^4
    x4_exact_3 <= x4_exact_ends_3 + shift_left(resize(x4_exact_twice_3, 46), 19);
    -- UQ1.21: x^4, rounded down
    x4_3 <= x4_exact_3(44 downto 23);
    -- UQ1.16: x^4 with fewer bits
    x4_cut_3 <= x4_3(21 downto 5);
    -- UQ-3.21: the 18 low bits of x4
    x4_low_3 <= x4_3(17 downto 0);
    -- UQ1.3: x4 without its 18 low bits
    x4_high_3 <= x4_3(21 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_cut_4 <= x4_cut_3;
                x4_low_4 <= x4_low_3;
                x4_high_4 <= x4_high_3;
                tap_0_4 <= tap_0_3;
                power_0_0_4 <= power_0_0_3;
                tap_1_4 <= tap_1_3;
                tap_2_4 <= tap_2_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_cut_5 <= x4_cut_4;
                x4_low_5 <= x4_low_4;
                x4_high_5 <= x4_high_4;
                tap_0_5 <= tap_0_4;
                power_0_0_5 <= power_0_0_4;
                tap_1_5 <= tap_1_4;
                tap_2_5 <= tap_2_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: x8_exact_low, x8_exact_mixed, x8_exact_high
    -- UQ-6.42: part of x8_exact
    x8_exact_low_5 <= x4_low_5 * x4_low_5;
    -- UQ-2.24: part of x8_exact
    x8_exact_mixed_5 <= x4_low_5 * x4_high_5;
    -- UQ2.6: part of x8_exact
    x8_exact_high_5 <= x4_high_5 * x4_high_5;
    -- UQ-1.23: both mixed products
    x8_exact_twice_5 <= x8_exact_mixed_5;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_cut_6 <= x4_cut_5;
                x8_exact_low_6 <= x8_exact_low_5;
                x8_exact_high_6 <= x8_exact_high_5;
                x8_exact_twice_6 <= x8_exact_twice_5;
                tap_0_6 <= tap_0_5;
                power_0_0_6 <= power_0_0_5;
                tap_1_6 <= tap_1_5;
                tap_2_6 <= tap_2_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: x8_exact_ends, x8_exact
    -- UQ2.42: the squares of both parts
    x8_exact_ends_6 <= resize(x8_exact_low_6, 44) + shift_left(resize(x8_exact_high_6, 44), 36);
    -- UQ2.42: x^8
    x8_exact_6 <= x8_exact_ends_6 + shift_left(resize(x8_exact_twice_6, 44), 19);
    -- UQ1.20: x^8, rounded down
    x8_6 <= x8_exact_6(42 downto 22);
    -- UQ1.16: x^8 with fewer bits
    x8_cut_6 <= x8_6(20 downto 4);
    -- UQ-2.20: the 18 low bits of x8
    x8_low_6 <= x8_6(17 downto 0);
    -- UQ1.2: x8 without its 18 low bits
    x8_high_6 <= x8_6(20 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_cut_7 <= x4_cut_6;
                x8_cut_7 <= x8_cut_6;
                x8_low_7 <= x8_low_6;
                x8_high_7 <= x8_high_6;
                tap_0_7 <= tap_0_6;
                power_0_0_7 <= power_0_0_6;
                tap_1_7 <= tap_1_6;
                tap_2_7 <= tap_2_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: power_0_1, power_1_0
    -- UQ1.16: one of two powers of x
    power_0_1_7 <= x8_cut_7 when tap_0_7 = '1' else x4_cut_7;
    -- UQ1.16: one of two powers of x
    power_1_0_7 <= power_0_1_7 when tap_1_7 = '1' else power_0_0_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x8_low_8 <= x8_low_7;
                x8_high_8 <= x8_high_7;
                tap_0_8 <= tap_0_7;
                tap_1_8 <= tap_1_7;
                power_1_0_8 <= power_1_0_7;
                tap_2_8 <= tap_2_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: x16_exact_low, x16_exact_mixed, x16_exact_high
    -- UQ-4.40: part of x16_exact
    x16_exact_low_8 <= x8_low_8 * x8_low_8;
    -- UQ-1.22: part of x16_exact
    x16_exact_mixed_8 <= x8_low_8 * x8_high_8;
    -- UQ2.4: part of x16_exact
    x16_exact_high_8 <= x8_high_8 * x8_high_8;
    -- UQ0.21: both mixed products
    x16_exact_twice_8 <= x16_exact_mixed_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_exact_low_9 <= x16_exact_low_8;
                x16_exact_high_9 <= x16_exact_high_8;
                x16_exact_twice_9 <= x16_exact_twice_8;
                tap_0_9 <= tap_0_8;
                tap_1_9 <= tap_1_8;
                power_1_0_9 <= power_1_0_8;
                tap_2_9 <= tap_2_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: x16_exact_ends, x16_exact
    -- UQ2.40: the squares of both parts
    x16_exact_ends_9 <= resize(x16_exact_low_9, 42) + shift_left(resize(x16_exact_high_9, 42), 36);
    -- UQ2.40: x^16
    x16_exact_9 <= x16_exact_ends_9 + shift_left(resize(x16_exact_twice_9, 42), 19);
    -- UQ1.19: x^16, rounded down
    x16_9 <= x16_exact_9(40 downto 21);
    -- UQ1.16: x^16 with fewer bits
    x16_cut_9 <= x16_9(19 downto 3);
    -- UQ-1.19: the 18 low bits of x16
    x16_low_9 <= x16_9(17 downto 0);
    -- UQ1.1: x16 without its 18 low bits
    x16_high_9 <= x16_9(19 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_cut_10 <= x16_cut_9;
                x16_low_10 <= x16_low_9;
                x16_high_10 <= x16_high_9;
                tap_0_10 <= tap_0_9;
                tap_1_10 <= tap_1_9;
                power_1_0_10 <= power_1_0_9;
                tap_2_10 <= tap_2_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_cut_11 <= x16_cut_10;
                x16_low_11 <= x16_low_10;
                x16_high_11 <= x16_high_10;
                tap_0_11 <= tap_0_10;
                tap_1_11 <= tap_1_10;
                power_1_0_11 <= power_1_0_10;
                tap_2_11 <= tap_2_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: x32_exact_low, x32_exact_mixed, x32_exact_high
    -- UQ-2.38: part of x32_exact
    x32_exact_low_11 <= x16_low_11 * x16_low_11;
    -- UQ0.20: part of x32_exact
    x32_exact_mixed_11 <= x16_low_11 * x16_high_11;
    -- UQ2.2: part of x32_exact
    x32_exact_high_11 <= x16_high_11 * x16_high_11;
    -- UQ1.19: both mixed products
    x32_exact_twice_11 <= x32_exact_mixed_11;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_cut_12 <= x16_cut_11;
                x32_exact_low_12 <= x32_exact_low_11;
                x32_exact_high_12 <= x32_exact_high_11;
                x32_exact_twice_12 <= x32_exact_twice_11;
                tap_0_12 <= tap_0_11;
                tap_1_12 <= tap_1_11;
                power_1_0_12 <= power_1_0_11;
                tap_2_12 <= tap_2_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: x32_exact_ends, x32_exact
    -- UQ2.38: the squares of both parts
    x32_exact_ends_12 <=
        resize(x32_exact_low_12, 40) + shift_left(resize(x32_exact_high_12, 40), 36);
    -- UQ2.38: x^32
    x32_exact_12 <= x32_exact_ends_12 + shift_left(resize(x32_exact_twice_12, 40), 19);
    -- UQ1.18: x^32, rounded down
    x32_12 <= x32_exact_12(38 downto 20);
    -- UQ1.16: x^32 with fewer bits
    x32_cut_12 <= x32_12(18 downto 2);
    -- UQ0.18: the 18 low bits of x32
    x32_low_12 <= x32_12(17 downto 0);
    -- UQ1.0: x32 without its 18 low bits
    x32_high_12 <= x32_12(18 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_cut_13 <= x16_cut_12;
                x32_cut_13 <= x32_cut_12;
                x32_low_13 <= x32_low_12;
                x32_high_13 <= x32_high_12;
                tap_0_13 <= tap_0_12;
                tap_1_13 <= tap_1_12;
                power_1_0_13 <= power_1_0_12;
                tap_2_13 <= tap_2_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: power_0_2
    -- UQ1.16: one of two powers of x
    power_0_2_13 <= x32_cut_13 when tap_0_13 = '1' else x16_cut_13;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x32_low_14 <= x32_low_13;
                x32_high_14 <= x32_high_13;
                tap_0_14 <= tap_0_13;
                power_0_2_14 <= power_0_2_13;
                tap_1_14 <= tap_1_13;
                power_1_0_14 <= power_1_0_13;
                tap_2_14 <= tap_2_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: x64_exact_low, x64_exact_mixed, x64_exact_high
    -- UQ0.36: part of x64_exact
    x64_exact_low_14 <= x32_low_14 * x32_low_14;
    -- UQ1.18: part of x64_exact
    x64_exact_mixed_14 <= x32_low_14 * x32_high_14;
    -- UQ2.0: part of x64_exact
    x64_exact_high_14 <= x32_high_14 * x32_high_14;
    -- UQ2.17: both mixed products
    x64_exact_twice_14 <= x64_exact_mixed_14;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_exact_low_15 <= x64_exact_low_14;
                x64_exact_high_15 <= x64_exact_high_14;
                x64_exact_twice_15 <= x64_exact_twice_14;
                tap_0_15 <= tap_0_14;
                power_0_2_15 <= power_0_2_14;
                tap_1_15 <= tap_1_14;
                power_1_0_15 <= power_1_0_14;
                tap_2_15 <= tap_2_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: x64_exact_ends, x64_exact
    -- UQ2.36: the squares of both parts
    x64_exact_ends_15 <=
        resize(x64_exact_low_15, 38) + shift_left(resize(x64_exact_high_15, 38), 36);
    -- UQ2.36: x^64
    x64_exact_15 <= x64_exact_ends_15 + shift_left(resize(x64_exact_twice_15, 38), 19);
    -- UQ1.17: x^64, rounded down
    x64_15 <= x64_exact_15(36 downto 19);
    -- UQ1.16: x^64 with fewer bits
    x64_cut_15 <= x64_15(17 downto 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_16 <= x64_15;
                x64_cut_16 <= x64_cut_15;
                tap_0_16 <= tap_0_15;
                power_0_2_16 <= power_0_2_15;
                tap_1_16 <= tap_1_15;
                power_1_0_16 <= power_1_0_15;
                tap_2_16 <= tap_2_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_17 <= x64_16;
                x64_cut_17 <= x64_cut_16;
                tap_0_17 <= tap_0_16;
                power_0_2_17 <= power_0_2_16;
                tap_1_17 <= tap_1_16;
                power_1_0_17 <= power_1_0_16;
                tap_2_17 <= tap_2_16;
            end if;
        end if;
    end process;

    -- ===== Stage 17: x128_exact
    -- UQ2.34: x^128
    x128_exact_17 <= x64_17 * x64_17;
    -- UQ1.16: x^128, rounded down
    x128_17 <= x128_exact_17(34 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_cut_18 <= x64_cut_17;
                x128_18 <= x128_17;
                tap_0_18 <= tap_0_17;
                power_0_2_18 <= power_0_2_17;
                tap_1_18 <= tap_1_17;
                power_1_0_18 <= power_1_0_17;
                tap_2_18 <= tap_2_17;
            end if;
        end if;
    end process;

    -- ===== Stage 18: power_0_3, power_1_1, power_2_0
    -- UQ1.16: one of two powers of x
    power_0_3_18 <= x128_18 when tap_0_18 = '1' else x64_cut_18;
    -- UQ1.16: one of two powers of x
    power_1_1_18 <= power_0_3_18 when tap_1_18 = '1' else power_0_2_18;
    -- UQ1.16: one of two powers of x
    power_2_0_18 <= power_1_1_18 when tap_2_18 = '1' else power_1_0_18;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_2_0_19 <= power_2_0_18;
            end if;
        end if;
    end process;

    -- ===== Stage 19: y_half
    -- UQ1.16: plus half an output ulp: the result is rounded to nearest
    y_half_19 <= power_2_0_19 + to_unsigned(8, 17);
    -- UQ1.12: rounded down to the output's bits
    y_19 <= y_half_19(16 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_20 <= y_19;
            end if;
        end if;
    end process;

    out_valid <= valid(20);
    out_spec  <= y_20;

end architecture rtl;
