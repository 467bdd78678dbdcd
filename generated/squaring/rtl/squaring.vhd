-- squaring: specular lobe x^n as x^n by log2 n squarings, 8 shininesses
--
-- Made by: brdfgen generate core.toml
-- Spec 8bd38130fdf7535e. Generated; the core is yours to use under any terms.
--
--   in_n      UQ3.0   index of the shininess, 0 to 7; above: the last
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 9 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.859..+0.500.
--   measured -0.613..+0.500 over all 32776 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.01496 % absolute, 0.01496 % where x^n >= 1/2, 0.02412 % relative there.
-- As the cosine rises, the output never falls: proved by running all 32768 pairs of neighbouring inputs.

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
        -- out_spec is a result: in_valid, 9 enabled clocks later
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

    signal valid : std_logic_vector(9 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal x_wide_0 : unsigned(16 downto 0) := (others => '0');
    signal x_1 : unsigned(12 downto 0) := (others => '0');
    signal x_wide_1 : unsigned(16 downto 0) := (others => '0');
    signal x2_exact_1 : unsigned(25 downto 0) := (others => '0');
    signal x2_1 : unsigned(22 downto 0) := (others => '0');
    signal x2_cut_1 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_1 : std_logic := '0';
    signal tap_1_1 : std_logic := '0';
    signal tap_2_1 : std_logic := '0';
    signal x2_2 : unsigned(22 downto 0) := (others => '0');
    signal x2_cut_2 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_2 : std_logic := '0';
    signal x_wide_2 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_2 : std_logic := '0';
    signal tap_2_2 : std_logic := '0';
    signal x4_exact_2 : unsigned(45 downto 0) := (others => '0');
    signal x4_2 : unsigned(21 downto 0) := (others => '0');
    signal x4_cut_2 : unsigned(16 downto 0) := (others => '0');
    signal power_0_0_2 : unsigned(16 downto 0) := (others => '0');
    signal x4_3 : unsigned(21 downto 0) := (others => '0');
    signal x4_cut_3 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_3 : std_logic := '0';
    signal power_0_0_3 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_3 : std_logic := '0';
    signal tap_2_3 : std_logic := '0';
    signal x8_exact_3 : unsigned(43 downto 0) := (others => '0');
    signal x8_3 : unsigned(20 downto 0) := (others => '0');
    signal x8_cut_3 : unsigned(16 downto 0) := (others => '0');
    signal x4_cut_4 : unsigned(16 downto 0) := (others => '0');
    signal x8_4 : unsigned(20 downto 0) := (others => '0');
    signal x8_cut_4 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_4 : std_logic := '0';
    signal power_0_0_4 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_4 : std_logic := '0';
    signal tap_2_4 : std_logic := '0';
    signal x16_exact_4 : unsigned(41 downto 0) := (others => '0');
    signal x16_4 : unsigned(19 downto 0) := (others => '0');
    signal x16_cut_4 : unsigned(16 downto 0) := (others => '0');
    signal power_0_1_4 : unsigned(16 downto 0) := (others => '0');
    signal power_1_0_4 : unsigned(16 downto 0) := (others => '0');
    signal x16_5 : unsigned(19 downto 0) := (others => '0');
    signal x16_cut_5 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_5 : std_logic := '0';
    signal tap_1_5 : std_logic := '0';
    signal power_1_0_5 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_5 : std_logic := '0';
    signal x32_exact_5 : unsigned(39 downto 0) := (others => '0');
    signal x32_5 : unsigned(18 downto 0) := (others => '0');
    signal x32_cut_5 : unsigned(16 downto 0) := (others => '0');
    signal x16_cut_6 : unsigned(16 downto 0) := (others => '0');
    signal x32_6 : unsigned(18 downto 0) := (others => '0');
    signal x32_cut_6 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_6 : std_logic := '0';
    signal tap_1_6 : std_logic := '0';
    signal power_1_0_6 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_6 : std_logic := '0';
    signal x64_exact_6 : unsigned(37 downto 0) := (others => '0');
    signal x64_6 : unsigned(17 downto 0) := (others => '0');
    signal x64_cut_6 : unsigned(16 downto 0) := (others => '0');
    signal power_0_2_6 : unsigned(16 downto 0) := (others => '0');
    signal x64_7 : unsigned(17 downto 0) := (others => '0');
    signal x64_cut_7 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_7 : std_logic := '0';
    signal power_0_2_7 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_7 : std_logic := '0';
    signal power_1_0_7 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_7 : std_logic := '0';
    signal x128_exact_7 : unsigned(35 downto 0) := (others => '0');
    signal x128_7 : unsigned(16 downto 0) := (others => '0');
    signal x64_cut_8 : unsigned(16 downto 0) := (others => '0');
    signal x128_8 : unsigned(16 downto 0) := (others => '0');
    signal tap_0_8 : std_logic := '0';
    signal power_0_2_8 : unsigned(16 downto 0) := (others => '0');
    signal tap_1_8 : std_logic := '0';
    signal power_1_0_8 : unsigned(16 downto 0) := (others => '0');
    signal tap_2_8 : std_logic := '0';
    signal power_0_3_8 : unsigned(16 downto 0) := (others => '0');
    signal power_1_1_8 : unsigned(16 downto 0) := (others => '0');
    signal power_2_0_8 : unsigned(16 downto 0) := (others => '0');
    signal y_half_8 : unsigned(16 downto 0) := (others => '0');
    signal y_8 : unsigned(12 downto 0) := (others => '0');
    signal y_9 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(8 downto 1) & in_valid;
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
                x2_2 <= x2_1;
                x2_cut_2 <= x2_cut_1;
                tap_0_2 <= tap_0_1;
                x_wide_2 <= x_wide_1;
                tap_1_2 <= tap_1_1;
                tap_2_2 <= tap_2_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: x4_exact, power_0_0
    -- UQ2.44: x^4
    x4_exact_2 <= x2_2 * x2_2;
    -- UQ1.21: x^4, rounded down
    x4_2 <= x4_exact_2(44 downto 23);
    -- UQ1.16: x^4 with fewer bits
    x4_cut_2 <= x4_2(21 downto 5);
    -- UQ1.16: one of two powers of x
    power_0_0_2 <= x2_cut_2 when tap_0_2 = '1' else x_wide_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_3 <= x4_2;
                x4_cut_3 <= x4_cut_2;
                tap_0_3 <= tap_0_2;
                power_0_0_3 <= power_0_0_2;
                tap_1_3 <= tap_1_2;
                tap_2_3 <= tap_2_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: x8_exact
    -- UQ2.42: x^8
    x8_exact_3 <= x4_3 * x4_3;
    -- UQ1.20: x^8, rounded down
    x8_3 <= x8_exact_3(42 downto 22);
    -- UQ1.16: x^8 with fewer bits
    x8_cut_3 <= x8_3(20 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x4_cut_4 <= x4_cut_3;
                x8_4 <= x8_3;
                x8_cut_4 <= x8_cut_3;
                tap_0_4 <= tap_0_3;
                power_0_0_4 <= power_0_0_3;
                tap_1_4 <= tap_1_3;
                tap_2_4 <= tap_2_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: x16_exact, power_0_1, power_1_0
    -- UQ2.40: x^16
    x16_exact_4 <= x8_4 * x8_4;
    -- UQ1.19: x^16, rounded down
    x16_4 <= x16_exact_4(40 downto 21);
    -- UQ1.16: x^16 with fewer bits
    x16_cut_4 <= x16_4(19 downto 3);
    -- UQ1.16: one of two powers of x
    power_0_1_4 <= x8_cut_4 when tap_0_4 = '1' else x4_cut_4;
    -- UQ1.16: one of two powers of x
    power_1_0_4 <= power_0_1_4 when tap_1_4 = '1' else power_0_0_4;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_5 <= x16_4;
                x16_cut_5 <= x16_cut_4;
                tap_0_5 <= tap_0_4;
                tap_1_5 <= tap_1_4;
                power_1_0_5 <= power_1_0_4;
                tap_2_5 <= tap_2_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: x32_exact
    -- UQ2.38: x^32
    x32_exact_5 <= x16_5 * x16_5;
    -- UQ1.18: x^32, rounded down
    x32_5 <= x32_exact_5(38 downto 20);
    -- UQ1.16: x^32 with fewer bits
    x32_cut_5 <= x32_5(18 downto 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x16_cut_6 <= x16_cut_5;
                x32_6 <= x32_5;
                x32_cut_6 <= x32_cut_5;
                tap_0_6 <= tap_0_5;
                tap_1_6 <= tap_1_5;
                power_1_0_6 <= power_1_0_5;
                tap_2_6 <= tap_2_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: x64_exact, power_0_2
    -- UQ2.36: x^64
    x64_exact_6 <= x32_6 * x32_6;
    -- UQ1.17: x^64, rounded down
    x64_6 <= x64_exact_6(36 downto 19);
    -- UQ1.16: x^64 with fewer bits
    x64_cut_6 <= x64_6(17 downto 1);
    -- UQ1.16: one of two powers of x
    power_0_2_6 <= x32_cut_6 when tap_0_6 = '1' else x16_cut_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_7 <= x64_6;
                x64_cut_7 <= x64_cut_6;
                tap_0_7 <= tap_0_6;
                power_0_2_7 <= power_0_2_6;
                tap_1_7 <= tap_1_6;
                power_1_0_7 <= power_1_0_6;
                tap_2_7 <= tap_2_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: x128_exact
    -- UQ2.34: x^128
    x128_exact_7 <= x64_7 * x64_7;
    -- UQ1.16: x^128, rounded down
    x128_7 <= x128_exact_7(34 downto 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x64_cut_8 <= x64_cut_7;
                x128_8 <= x128_7;
                tap_0_8 <= tap_0_7;
                power_0_2_8 <= power_0_2_7;
                tap_1_8 <= tap_1_7;
                power_1_0_8 <= power_1_0_7;
                tap_2_8 <= tap_2_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: power_0_3, power_1_1, power_2_0, y_half
    -- UQ1.16: one of two powers of x
    power_0_3_8 <= x128_8 when tap_0_8 = '1' else x64_cut_8;
    -- UQ1.16: one of two powers of x
    power_1_1_8 <= power_0_3_8 when tap_1_8 = '1' else power_0_2_8;
    -- UQ1.16: one of two powers of x
    power_2_0_8 <= power_1_1_8 when tap_2_8 = '1' else power_1_0_8;
    -- UQ1.16: plus half an output ulp: the result is rounded to nearest
    y_half_8 <= power_2_0_8 + to_unsigned(8, 17);
    -- UQ1.12: rounded down to the output's bits
    y_8 <= y_half_8(16 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_9 <= y_8;
            end if;
        end if;
    end process;

    out_valid <= valid(9);
    out_spec  <= y_9;

end architecture rtl;
