-- schlick: specular lobe x^n as x/(1 + (n-1)u), n = 1 to 127
--
-- Made by: brdfgen generate core.toml
-- Spec 500a8fd02d5cfbe6. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 16 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.500..+0.500.
--   measured -0.500..+0.500 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   20.166 % absolute, 8.982 % where x^n >= 1/2, 17.955 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity schlick is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ7.0: shininess, 1 to 127; outside: the nearest end
        in_n      : in  unsigned(6 downto 0);
        -- Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(13 downto 0);
        -- out_spec is a result: in_valid, 16 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity schlick;

architecture rtl of schlick is
    signal valid : std_logic_vector(16 downto 1) := (others => '0');
    signal n_0 : unsigned(6 downto 0) := (others => '0');
    signal n1_0 : unsigned(6 downto 0) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal double_1_0 : unsigned(12 downto 0) := (others => '0');
    signal kept_1_0 : unsigned(12 downto 0) := (others => '0');
    signal n1_1 : unsigned(6 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal double_1_1 : unsigned(12 downto 0) := (others => '0');
    signal kept_1_1 : unsigned(12 downto 0) := (others => '0');
    signal n1u_1 : unsigned(19 downto 0) := (others => '0');
    signal n1u_2 : unsigned(19 downto 0) := (others => '0');
    signal double_1_2 : unsigned(12 downto 0) := (others => '0');
    signal kept_1_2 : unsigned(12 downto 0) := (others => '0');
    signal den_2 : unsigned(18 downto 0) := (others => '0');
    signal trial_1_2 : signed(19 downto 0) := (others => '0');
    signal zero_1_2 : unsigned(0 downto 0) := (others => '0');
    signal weighted_1_2 : unsigned(0 downto 0) := (others => '0');
    signal below_1_2 : std_logic := '0';
    signal less_1_2 : unsigned(12 downto 0) := (others => '0');
    signal den_3 : unsigned(18 downto 0) := (others => '0');
    signal weighted_1_3 : unsigned(0 downto 0) := (others => '0');
    signal below_1_3 : std_logic := '0';
    signal kept_1_3 : unsigned(12 downto 0) := (others => '0');
    signal less_1_3 : unsigned(12 downto 0) := (others => '0');
    signal r_1_3 : unsigned(13 downto 0) := (others => '0');
    signal double_2_3 : unsigned(13 downto 0) := (others => '0');
    signal trial_2_3 : signed(19 downto 0) := (others => '0');
    signal zero_2_3 : unsigned(0 downto 0) := (others => '0');
    signal weighted_2_3 : unsigned(0 downto 0) := (others => '0');
    signal below_2_3 : std_logic := '0';
    signal kept_2_3 : unsigned(13 downto 0) := (others => '0');
    signal less_2_3 : unsigned(12 downto 0) := (others => '0');
    signal r_2_3 : unsigned(14 downto 0) := (others => '0');
    signal double_3_3 : unsigned(14 downto 0) := (others => '0');
    signal kept_3_3 : unsigned(14 downto 0) := (others => '0');
    signal den_4 : unsigned(18 downto 0) := (others => '0');
    signal weighted_1_4 : unsigned(0 downto 0) := (others => '0');
    signal weighted_2_4 : unsigned(0 downto 0) := (others => '0');
    signal double_3_4 : unsigned(14 downto 0) := (others => '0');
    signal kept_3_4 : unsigned(14 downto 0) := (others => '0');
    signal zeros_2_4 : unsigned(1 downto 0) := (others => '0');
    signal trial_3_4 : signed(19 downto 0) := (others => '0');
    signal zero_3_4 : unsigned(0 downto 0) := (others => '0');
    signal weighted_3_4 : unsigned(0 downto 0) := (others => '0');
    signal zeros_3_4 : unsigned(2 downto 0) := (others => '0');
    signal below_3_4 : std_logic := '0';
    signal less_3_4 : unsigned(13 downto 0) := (others => '0');
    signal r_3_4 : unsigned(15 downto 0) := (others => '0');
    signal double_4_4 : unsigned(15 downto 0) := (others => '0');
    signal kept_4_4 : unsigned(15 downto 0) := (others => '0');
    signal den_5 : unsigned(18 downto 0) := (others => '0');
    signal zeros_3_5 : unsigned(2 downto 0) := (others => '0');
    signal double_4_5 : unsigned(15 downto 0) := (others => '0');
    signal kept_4_5 : unsigned(15 downto 0) := (others => '0');
    signal trial_4_5 : signed(19 downto 0) := (others => '0');
    signal zero_4_5 : unsigned(0 downto 0) := (others => '0');
    signal weighted_4_5 : unsigned(0 downto 0) := (others => '0');
    signal zeros_4_5 : unsigned(3 downto 0) := (others => '0');
    signal below_4_5 : std_logic := '0';
    signal less_4_5 : unsigned(14 downto 0) := (others => '0');
    signal r_4_5 : unsigned(16 downto 0) := (others => '0');
    signal double_5_5 : unsigned(16 downto 0) := (others => '0');
    signal kept_5_5 : unsigned(16 downto 0) := (others => '0');
    signal den_6 : unsigned(18 downto 0) := (others => '0');
    signal zeros_4_6 : unsigned(3 downto 0) := (others => '0');
    signal double_5_6 : unsigned(16 downto 0) := (others => '0');
    signal kept_5_6 : unsigned(16 downto 0) := (others => '0');
    signal trial_5_6 : signed(19 downto 0) := (others => '0');
    signal zero_5_6 : unsigned(0 downto 0) := (others => '0');
    signal weighted_5_6 : unsigned(0 downto 0) := (others => '0');
    signal zeros_5_6 : unsigned(4 downto 0) := (others => '0');
    signal below_5_6 : std_logic := '0';
    signal less_5_6 : unsigned(15 downto 0) := (others => '0');
    signal r_5_6 : unsigned(17 downto 0) := (others => '0');
    signal double_6_6 : unsigned(17 downto 0) := (others => '0');
    signal kept_6_6 : unsigned(17 downto 0) := (others => '0');
    signal den_7 : unsigned(18 downto 0) := (others => '0');
    signal zeros_5_7 : unsigned(4 downto 0) := (others => '0');
    signal double_6_7 : unsigned(17 downto 0) := (others => '0');
    signal kept_6_7 : unsigned(17 downto 0) := (others => '0');
    signal trial_6_7 : signed(19 downto 0) := (others => '0');
    signal zero_6_7 : unsigned(0 downto 0) := (others => '0');
    signal weighted_6_7 : unsigned(0 downto 0) := (others => '0');
    signal zeros_6_7 : unsigned(5 downto 0) := (others => '0');
    signal below_6_7 : std_logic := '0';
    signal less_6_7 : unsigned(16 downto 0) := (others => '0');
    signal r_6_7 : unsigned(18 downto 0) := (others => '0');
    signal double_7_7 : unsigned(18 downto 0) := (others => '0');
    signal kept_7_7 : unsigned(17 downto 0) := (others => '0');
    signal den_8 : unsigned(18 downto 0) := (others => '0');
    signal zeros_6_8 : unsigned(5 downto 0) := (others => '0');
    signal double_7_8 : unsigned(18 downto 0) := (others => '0');
    signal kept_7_8 : unsigned(17 downto 0) := (others => '0');
    signal trial_7_8 : signed(19 downto 0) := (others => '0');
    signal zero_7_8 : unsigned(0 downto 0) := (others => '0');
    signal weighted_7_8 : unsigned(0 downto 0) := (others => '0');
    signal zeros_7_8 : unsigned(6 downto 0) := (others => '0');
    signal below_7_8 : std_logic := '0';
    signal less_7_8 : unsigned(17 downto 0) := (others => '0');
    signal r_7_8 : unsigned(18 downto 0) := (others => '0');
    signal double_8_8 : unsigned(18 downto 0) := (others => '0');
    signal kept_8_8 : unsigned(18 downto 0) := (others => '0');
    signal den_9 : unsigned(18 downto 0) := (others => '0');
    signal zeros_7_9 : unsigned(6 downto 0) := (others => '0');
    signal double_8_9 : unsigned(18 downto 0) := (others => '0');
    signal kept_8_9 : unsigned(18 downto 0) := (others => '0');
    signal trial_8_9 : signed(19 downto 0) := (others => '0');
    signal zero_8_9 : unsigned(0 downto 0) := (others => '0');
    signal weighted_8_9 : unsigned(0 downto 0) := (others => '0');
    signal zeros_8_9 : unsigned(7 downto 0) := (others => '0');
    signal below_8_9 : std_logic := '0';
    signal less_8_9 : unsigned(17 downto 0) := (others => '0');
    signal r_8_9 : unsigned(18 downto 0) := (others => '0');
    signal double_9_9 : unsigned(18 downto 0) := (others => '0');
    signal kept_9_9 : unsigned(18 downto 0) := (others => '0');
    signal den_10 : unsigned(18 downto 0) := (others => '0');
    signal zeros_8_10 : unsigned(7 downto 0) := (others => '0');
    signal double_9_10 : unsigned(18 downto 0) := (others => '0');
    signal kept_9_10 : unsigned(18 downto 0) := (others => '0');
    signal trial_9_10 : signed(19 downto 0) := (others => '0');
    signal zero_9_10 : unsigned(0 downto 0) := (others => '0');
    signal weighted_9_10 : unsigned(0 downto 0) := (others => '0');
    signal zeros_9_10 : unsigned(8 downto 0) := (others => '0');
    signal below_9_10 : std_logic := '0';
    signal less_9_10 : unsigned(18 downto 0) := (others => '0');
    signal r_9_10 : unsigned(18 downto 0) := (others => '0');
    signal double_10_10 : unsigned(18 downto 0) := (others => '0');
    signal kept_10_10 : unsigned(18 downto 0) := (others => '0');
    signal den_11 : unsigned(18 downto 0) := (others => '0');
    signal zeros_9_11 : unsigned(8 downto 0) := (others => '0');
    signal double_10_11 : unsigned(18 downto 0) := (others => '0');
    signal kept_10_11 : unsigned(18 downto 0) := (others => '0');
    signal trial_10_11 : signed(19 downto 0) := (others => '0');
    signal zero_10_11 : unsigned(0 downto 0) := (others => '0');
    signal weighted_10_11 : unsigned(0 downto 0) := (others => '0');
    signal zeros_10_11 : unsigned(9 downto 0) := (others => '0');
    signal below_10_11 : std_logic := '0';
    signal less_10_11 : unsigned(18 downto 0) := (others => '0');
    signal r_10_11 : unsigned(18 downto 0) := (others => '0');
    signal double_11_11 : unsigned(18 downto 0) := (others => '0');
    signal kept_11_11 : unsigned(18 downto 0) := (others => '0');
    signal den_12 : unsigned(18 downto 0) := (others => '0');
    signal zeros_10_12 : unsigned(9 downto 0) := (others => '0');
    signal double_11_12 : unsigned(18 downto 0) := (others => '0');
    signal kept_11_12 : unsigned(18 downto 0) := (others => '0');
    signal trial_11_12 : signed(19 downto 0) := (others => '0');
    signal zero_11_12 : unsigned(0 downto 0) := (others => '0');
    signal weighted_11_12 : unsigned(0 downto 0) := (others => '0');
    signal zeros_11_12 : unsigned(10 downto 0) := (others => '0');
    signal below_11_12 : std_logic := '0';
    signal less_11_12 : unsigned(18 downto 0) := (others => '0');
    signal r_11_12 : unsigned(18 downto 0) := (others => '0');
    signal double_12_12 : unsigned(18 downto 0) := (others => '0');
    signal kept_12_12 : unsigned(18 downto 0) := (others => '0');
    signal den_13 : unsigned(18 downto 0) := (others => '0');
    signal zeros_11_13 : unsigned(10 downto 0) := (others => '0');
    signal double_12_13 : unsigned(18 downto 0) := (others => '0');
    signal kept_12_13 : unsigned(18 downto 0) := (others => '0');
    signal trial_12_13 : signed(19 downto 0) := (others => '0');
    signal zero_12_13 : unsigned(0 downto 0) := (others => '0');
    signal weighted_12_13 : unsigned(0 downto 0) := (others => '0');
    signal zeros_12_13 : unsigned(11 downto 0) := (others => '0');
    signal below_12_13 : std_logic := '0';
    signal less_12_13 : unsigned(18 downto 0) := (others => '0');
    signal r_12_13 : unsigned(18 downto 0) := (others => '0');
    signal double_13_13 : unsigned(18 downto 0) := (others => '0');
    signal den_14 : unsigned(18 downto 0) := (others => '0');
    signal zeros_12_14 : unsigned(11 downto 0) := (others => '0');
    signal double_13_14 : unsigned(18 downto 0) := (others => '0');
    signal trial_13_14 : signed(19 downto 0) := (others => '0');
    signal zero_13_14 : unsigned(0 downto 0) := (others => '0');
    signal weighted_13_14 : unsigned(0 downto 0) := (others => '0');
    signal zeros_13_14 : unsigned(12 downto 0) := (others => '0');
    signal zeros_13_15 : unsigned(12 downto 0) := (others => '0');
    signal quotient_half_15 : unsigned(13 downto 0) := (others => '0');
    signal quotient_15 : unsigned(12 downto 0) := (others => '0');
    signal quotient_16 : unsigned(12 downto 0) := (others => '0');

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

    -- ===== Stage 0: n, n1, x, u
    -- UQ7.0: in_n taken into the range
    n_0 <= to_unsigned(1, 7) when in_n < 1 else
        in_n;
    -- UQ7.0: n - 1
    n1_0 <= n_0 - to_unsigned(1, 7);
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.12: u = 1 - x, the versine
    u_0 <= to_unsigned(4096, 13) - x_0;
    -- UQ2.11: 2 r
    double_1_0 <= x_0;
    -- UQ1.12: 2 r
    kept_1_0 <= shift_left(double_1_0, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n1_1 <= n1_0;
                u_1 <= u_0;
                double_1_1 <= double_1_0;
                kept_1_1 <= kept_1_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: n1u
    -- UQ8.12: (n-1) u
    n1u_1 <= n1_1 * u_1;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n1u_2 <= n1u_1;
                double_1_2 <= double_1_1;
                kept_1_2 <= kept_1_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: den, trial_1
    -- UQ7.12: the denominator, 1 + (n-1) u
    den_2 <= to_unsigned(4096, 19) + n1u_2(18 downto 0);
    -- Q7.12: 2 r - den
    trial_1_2 <= shift_left(signed(resize(double_1_2, 20)), 1) - signed(resize(den_2, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_1_2 <= unsigned(trial_1_2(19 downto 19));
    -- UQ0.1: as a number
    weighted_1_2 <= zero_1_2;
    -- UQ8.-7: 2 r < den
    below_1_2 <= trial_1_2(19);
    -- UQ1.12: 2 r - den
    less_1_2 <= unsigned(trial_1_2(12 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_3 <= den_2;
                weighted_1_3 <= weighted_1_2;
                below_1_3 <= below_1_2;
                kept_1_3 <= kept_1_2;
                less_1_3 <= less_1_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: r_1, trial_2, r_2
    -- UQ2.12: the remainder
    r_1_3 <= resize(kept_1_3, 14) when below_1_3 = '1' else resize(less_1_3, 14);
    -- UQ3.11: 2 r
    double_2_3 <= r_1_3;
    -- Q7.12: 2 r - den
    trial_2_3 <= shift_left(signed(resize(double_2_3, 20)), 1) - signed(resize(den_3, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_2_3 <= unsigned(trial_2_3(19 downto 19));
    -- UQ-1.2: as a number
    weighted_2_3 <= zero_2_3;
    -- UQ8.-7: 2 r < den
    below_2_3 <= trial_2_3(19);
    -- UQ2.12: 2 r
    kept_2_3 <= shift_left(double_2_3, 1);
    -- UQ1.12: 2 r - den
    less_2_3 <= unsigned(trial_2_3(12 downto 0));
    -- UQ3.12: the remainder
    r_2_3 <= resize(kept_2_3, 15) when below_2_3 = '1' else resize(less_2_3, 15);
    -- UQ4.11: 2 r
    double_3_3 <= r_2_3;
    -- UQ3.12: 2 r
    kept_3_3 <= shift_left(double_3_3, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_4 <= den_3;
                weighted_1_4 <= weighted_1_3;
                weighted_2_4 <= weighted_2_3;
                double_3_4 <= double_3_3;
                kept_3_4 <= kept_3_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: zeros_2, trial_3, zeros_3, r_3
    -- UQ0.2: the zeros of the quotient so far
    zeros_2_4 <= shift_left(resize(weighted_1_4, 2), 1) + resize(weighted_2_4, 2);
    -- Q7.12: 2 r - den
    trial_3_4 <= shift_left(signed(resize(double_3_4, 20)), 1) - signed(resize(den_4, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_3_4 <= unsigned(trial_3_4(19 downto 19));
    -- UQ-2.3: as a number
    weighted_3_4 <= zero_3_4;
    -- UQ0.3: the zeros of the quotient so far
    zeros_3_4 <= shift_left(resize(zeros_2_4, 3), 1) + resize(weighted_3_4, 3);
    -- UQ8.-7: 2 r < den
    below_3_4 <= trial_3_4(19);
    -- UQ2.12: 2 r - den
    less_3_4 <= unsigned(trial_3_4(13 downto 0));
    -- UQ4.12: the remainder
    r_3_4 <= resize(kept_3_4, 16) when below_3_4 = '1' else resize(less_3_4, 16);
    -- UQ5.11: 2 r
    double_4_4 <= r_3_4;
    -- UQ4.12: 2 r
    kept_4_4 <= shift_left(double_4_4, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_5 <= den_4;
                zeros_3_5 <= zeros_3_4;
                double_4_5 <= double_4_4;
                kept_4_5 <= kept_4_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: trial_4, zeros_4, r_4
    -- Q7.12: 2 r - den
    trial_4_5 <= shift_left(signed(resize(double_4_5, 20)), 1) - signed(resize(den_5, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_4_5 <= unsigned(trial_4_5(19 downto 19));
    -- UQ-3.4: as a number
    weighted_4_5 <= zero_4_5;
    -- UQ0.4: the zeros of the quotient so far
    zeros_4_5 <= shift_left(resize(zeros_3_5, 4), 1) + resize(weighted_4_5, 4);
    -- UQ8.-7: 2 r < den
    below_4_5 <= trial_4_5(19);
    -- UQ3.12: 2 r - den
    less_4_5 <= unsigned(trial_4_5(14 downto 0));
    -- UQ5.12: the remainder
    r_4_5 <= resize(kept_4_5, 17) when below_4_5 = '1' else resize(less_4_5, 17);
    -- UQ6.11: 2 r
    double_5_5 <= r_4_5;
    -- UQ5.12: 2 r
    kept_5_5 <= shift_left(double_5_5, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_6 <= den_5;
                zeros_4_6 <= zeros_4_5;
                double_5_6 <= double_5_5;
                kept_5_6 <= kept_5_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: trial_5, zeros_5, r_5
    -- Q7.12: 2 r - den
    trial_5_6 <= shift_left(signed(resize(double_5_6, 20)), 1) - signed(resize(den_6, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_5_6 <= unsigned(trial_5_6(19 downto 19));
    -- UQ-4.5: as a number
    weighted_5_6 <= zero_5_6;
    -- UQ0.5: the zeros of the quotient so far
    zeros_5_6 <= shift_left(resize(zeros_4_6, 5), 1) + resize(weighted_5_6, 5);
    -- UQ8.-7: 2 r < den
    below_5_6 <= trial_5_6(19);
    -- UQ4.12: 2 r - den
    less_5_6 <= unsigned(trial_5_6(15 downto 0));
    -- UQ6.12: the remainder
    r_5_6 <= resize(kept_5_6, 18) when below_5_6 = '1' else resize(less_5_6, 18);
    -- UQ7.11: 2 r
    double_6_6 <= r_5_6;
    -- UQ6.12: 2 r
    kept_6_6 <= shift_left(double_6_6, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_7 <= den_6;
                zeros_5_7 <= zeros_5_6;
                double_6_7 <= double_6_6;
                kept_6_7 <= kept_6_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: trial_6, zeros_6, r_6
    -- Q7.12: 2 r - den
    trial_6_7 <= shift_left(signed(resize(double_6_7, 20)), 1) - signed(resize(den_7, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_6_7 <= unsigned(trial_6_7(19 downto 19));
    -- UQ-5.6: as a number
    weighted_6_7 <= zero_6_7;
    -- UQ0.6: the zeros of the quotient so far
    zeros_6_7 <= shift_left(resize(zeros_5_7, 6), 1) + resize(weighted_6_7, 6);
    -- UQ8.-7: 2 r < den
    below_6_7 <= trial_6_7(19);
    -- UQ5.12: 2 r - den
    less_6_7 <= unsigned(trial_6_7(16 downto 0));
    -- UQ7.12: the remainder
    r_6_7 <= resize(kept_6_7, 19) when below_6_7 = '1' else resize(less_6_7, 19);
    -- UQ8.11: 2 r
    double_7_7 <= r_6_7;
    -- UQ6.12: 2 r
    kept_7_7 <= shift_left(double_7_7(17 downto 0), 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_8 <= den_7;
                zeros_6_8 <= zeros_6_7;
                double_7_8 <= double_7_7;
                kept_7_8 <= kept_7_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: trial_7, zeros_7, r_7
    -- Q7.12: 2 r - den
    trial_7_8 <= shift_left(signed(resize(double_7_8, 20)), 1) - signed(resize(den_8, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_7_8 <= unsigned(trial_7_8(19 downto 19));
    -- UQ-6.7: as a number
    weighted_7_8 <= zero_7_8;
    -- UQ0.7: the zeros of the quotient so far
    zeros_7_8 <= shift_left(resize(zeros_6_8, 7), 1) + resize(weighted_7_8, 7);
    -- UQ8.-7: 2 r < den
    below_7_8 <= trial_7_8(19);
    -- UQ6.12: 2 r - den
    less_7_8 <= unsigned(trial_7_8(17 downto 0));
    -- UQ7.12: the remainder
    r_7_8 <= resize(kept_7_8, 19) when below_7_8 = '1' else resize(less_7_8, 19);
    -- UQ8.11: 2 r
    double_8_8 <= r_7_8;
    -- UQ7.12: 2 r
    kept_8_8 <= shift_left(double_8_8, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_9 <= den_8;
                zeros_7_9 <= zeros_7_8;
                double_8_9 <= double_8_8;
                kept_8_9 <= kept_8_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: trial_8, zeros_8, r_8
    -- Q7.12: 2 r - den
    trial_8_9 <= shift_left(signed(resize(double_8_9, 20)), 1) - signed(resize(den_9, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_8_9 <= unsigned(trial_8_9(19 downto 19));
    -- UQ-7.8: as a number
    weighted_8_9 <= zero_8_9;
    -- UQ0.8: the zeros of the quotient so far
    zeros_8_9 <= shift_left(resize(zeros_7_9, 8), 1) + resize(weighted_8_9, 8);
    -- UQ8.-7: 2 r < den
    below_8_9 <= trial_8_9(19);
    -- UQ6.12: 2 r - den
    less_8_9 <= unsigned(trial_8_9(17 downto 0));
    -- UQ7.12: the remainder
    r_8_9 <= kept_8_9 when below_8_9 = '1' else resize(less_8_9, 19);
    -- UQ8.11: 2 r
    double_9_9 <= r_8_9;
    -- UQ7.12: 2 r
    kept_9_9 <= shift_left(double_9_9, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_10 <= den_9;
                zeros_8_10 <= zeros_8_9;
                double_9_10 <= double_9_9;
                kept_9_10 <= kept_9_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: trial_9, zeros_9, r_9
    -- Q7.12: 2 r - den
    trial_9_10 <= shift_left(signed(resize(double_9_10, 20)), 1) - signed(resize(den_10, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_9_10 <= unsigned(trial_9_10(19 downto 19));
    -- UQ-8.9: as a number
    weighted_9_10 <= zero_9_10;
    -- UQ0.9: the zeros of the quotient so far
    zeros_9_10 <= shift_left(resize(zeros_8_10, 9), 1) + resize(weighted_9_10, 9);
    -- UQ8.-7: 2 r < den
    below_9_10 <= trial_9_10(19);
    -- UQ7.12: 2 r - den
    less_9_10 <= unsigned(trial_9_10(18 downto 0));
    -- UQ7.12: the remainder
    r_9_10 <= kept_9_10 when below_9_10 = '1' else less_9_10;
    -- UQ8.11: 2 r
    double_10_10 <= r_9_10;
    -- UQ7.12: 2 r
    kept_10_10 <= shift_left(double_10_10, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_11 <= den_10;
                zeros_9_11 <= zeros_9_10;
                double_10_11 <= double_10_10;
                kept_10_11 <= kept_10_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: trial_10, zeros_10, r_10
    -- Q7.12: 2 r - den
    trial_10_11 <= shift_left(signed(resize(double_10_11, 20)), 1) - signed(resize(den_11, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_10_11 <= unsigned(trial_10_11(19 downto 19));
    -- UQ-9.10: as a number
    weighted_10_11 <= zero_10_11;
    -- UQ0.10: the zeros of the quotient so far
    zeros_10_11 <= shift_left(resize(zeros_9_11, 10), 1) + resize(weighted_10_11, 10);
    -- UQ8.-7: 2 r < den
    below_10_11 <= trial_10_11(19);
    -- UQ7.12: 2 r - den
    less_10_11 <= unsigned(trial_10_11(18 downto 0));
    -- UQ7.12: the remainder
    r_10_11 <= kept_10_11 when below_10_11 = '1' else less_10_11;
    -- UQ8.11: 2 r
    double_11_11 <= r_10_11;
    -- UQ7.12: 2 r
    kept_11_11 <= shift_left(double_11_11, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_12 <= den_11;
                zeros_10_12 <= zeros_10_11;
                double_11_12 <= double_11_11;
                kept_11_12 <= kept_11_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: trial_11, zeros_11, r_11
    -- Q7.12: 2 r - den
    trial_11_12 <= shift_left(signed(resize(double_11_12, 20)), 1) - signed(resize(den_12, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_11_12 <= unsigned(trial_11_12(19 downto 19));
    -- UQ-10.11: as a number
    weighted_11_12 <= zero_11_12;
    -- UQ0.11: the zeros of the quotient so far
    zeros_11_12 <= shift_left(resize(zeros_10_12, 11), 1) + resize(weighted_11_12, 11);
    -- UQ8.-7: 2 r < den
    below_11_12 <= trial_11_12(19);
    -- UQ7.12: 2 r - den
    less_11_12 <= unsigned(trial_11_12(18 downto 0));
    -- UQ7.12: the remainder
    r_11_12 <= kept_11_12 when below_11_12 = '1' else less_11_12;
    -- UQ8.11: 2 r
    double_12_12 <= r_11_12;
    -- UQ7.12: 2 r
    kept_12_12 <= shift_left(double_12_12, 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_13 <= den_12;
                zeros_11_13 <= zeros_11_12;
                double_12_13 <= double_12_12;
                kept_12_13 <= kept_12_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: trial_12, zeros_12, r_12
    -- Q7.12: 2 r - den
    trial_12_13 <= shift_left(signed(resize(double_12_13, 20)), 1) - signed(resize(den_13, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_12_13 <= unsigned(trial_12_13(19 downto 19));
    -- UQ-11.12: as a number
    weighted_12_13 <= zero_12_13;
    -- UQ0.12: the zeros of the quotient so far
    zeros_12_13 <= shift_left(resize(zeros_11_13, 12), 1) + resize(weighted_12_13, 12);
    -- UQ8.-7: 2 r < den
    below_12_13 <= trial_12_13(19);
    -- UQ7.12: 2 r - den
    less_12_13 <= unsigned(trial_12_13(18 downto 0));
    -- UQ7.12: the remainder
    r_12_13 <= kept_12_13 when below_12_13 = '1' else less_12_13;
    -- UQ8.11: 2 r
    double_13_13 <= r_12_13;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                den_14 <= den_13;
                zeros_12_14 <= zeros_12_13;
                double_13_14 <= double_13_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: trial_13, zeros_13
    -- Q7.12: 2 r - den
    trial_13_14 <= shift_left(signed(resize(double_13_14, 20)), 1) - signed(resize(den_14, 20));
    -- UQ8.-7: the digit, inverted: the sign
    zero_13_14 <= unsigned(trial_13_14(19 downto 19));
    -- UQ-12.13: as a number
    weighted_13_14 <= zero_13_14;
    -- UQ0.13: the zeros of the quotient so far
    zeros_13_14 <= shift_left(resize(zeros_12_14, 13), 1) + resize(weighted_13_14, 13);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                zeros_13_15 <= zeros_13_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: quotient_half
    -- UQ1.13: the quotient plus half an output ulp
    quotient_half_15 <= to_unsigned(8192, 14) - resize(zeros_13_15, 14);
    -- UQ1.12: num / den, rounded to nearest
    quotient_15 <= quotient_half_15(13 downto 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                quotient_16 <= quotient_15;
            end if;
        end if;
    end process;

    out_valid <= valid(16);
    out_spec  <= quotient_16;

end architecture rtl;
