-- log_exp_9: specular lobe x^n as 2^(-n L(x)), L = -log2 x, n = 1 to 255
--
-- Made by: brdfgen generate core.toml
-- Spec 608aa1feabb28d90. Generated; the core is yours to use under any terms.
--
--   in_n      UQ8.0   shininess, 1 to 255; outside: the nearest end
--   in_cos    Q1.14   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.14  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 12 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -27.411..+26.557.
--   measured -19.559..+19.152 over all 4178175 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.119 % absolute, 0.119 % where x^n >= 1/2, 0.219 % relative there.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity log_exp_9 is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ8.0: shininess, 1 to 255; outside: the nearest end
        in_n      : in  unsigned(7 downto 0);
        -- Q1.14: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(15 downto 0);
        -- out_spec is a result: in_valid, 12 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.14: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(14 downto 0)
    );
end entity log_exp_9;

architecture rtl of log_exp_9 is
    -- ===== The memory log_table
    -- Bits 13 downto 0 of each word.
    type log_table_words_0_t is array (63 downto 0) of
        std_logic_vector(15 downto 0);
    constant LOG_TABLE_WORDS_0 : log_table_words_0_t := (
        63 => x"0ba5",
        62 => x"0bbd",
        61 => x"0bd5",
        60 => x"0bed",
        59 => x"0c09",
        58 => x"0c21",
        57 => x"0c3d",
        56 => x"0c55",
        55 => x"0c71",
        54 => x"0c8d",
        53 => x"0ca9",
        52 => x"0cc9",
        51 => x"0ce5",
        50 => x"0d05",
        49 => x"0d25",
        48 => x"0d45",
        47 => x"0d69",
        46 => x"0d89",
        45 => x"0dad",
        44 => x"0dd5",
        43 => x"0df9",
        42 => x"0e21",
        41 => x"0e49",
        40 => x"0e71",
        39 => x"0e9d",
        38 => x"0ec9",
        37 => x"0f06",
        36 => x"0f36",
        35 => x"0f66",
        34 => x"0f9a",
        33 => x"0fce",
        32 => x"1006",
        31 => x"103e",
        30 => x"107a",
        29 => x"10b6",
        28 => x"10f6",
        27 => x"113a",
        26 => x"117e",
        25 => x"11ca",
        24 => x"1227",
        23 => x"1277",
        22 => x"12cb",
        21 => x"1327",
        20 => x"1387",
        19 => x"13eb",
        18 => x"1457",
        17 => x"14cb",
        16 => x"1547",
        15 => x"15cb",
        14 => x"165b",
        13 => x"16f3",
        12 => x"179f",
        11 => x"1857",
        10 => x"1923",
        9 => x"1a07",
        8 => x"1b0b",
        7 => x"1c33",
        6 => x"1d87",
        5 => x"1f1b",
        4 => x"2107",
        3 => x"2373",
        2 => x"26a7",
        1 => x"2b1f",
        0 => x"32af"
    );
    signal log_table_2 : std_logic_vector(13 downto 0) := (others => '0');

    -- ===== The memory exp_table
    -- Bits 15 downto 0 of each word.
    type exp_table_words_0_t is array (31 downto 0) of
        std_logic_vector(15 downto 0);
    constant EXP_TABLE_WORDS_0 : exp_table_words_0_t := (
        31 => x"82d6",
        30 => x"85a6",
        29 => x"8886",
        28 => x"8b86",
        27 => x"8e86",
        26 => x"91a6",
        25 => x"94c6",
        24 => x"9847",
        23 => x"9b87",
        22 => x"9ee7",
        21 => x"a257",
        20 => x"a5e7",
        19 => x"a977",
        18 => x"ad27",
        17 => x"b128",
        16 => x"b4f8",
        15 => x"b8e8",
        14 => x"bce8",
        13 => x"c108",
        12 => x"c538",
        11 => x"c9b9",
        10 => x"ce19",
        9 => x"d289",
        8 => x"d719",
        7 => x"dbc9",
        6 => x"e0ca",
        5 => x"e5aa",
        4 => x"ea9a",
        3 => x"efba",
        2 => x"f52b",
        1 => x"fa7b",
        0 => x"ffdb"
    );
    signal exp_table_7 : std_logic_vector(15 downto 0) := (others => '0');

    signal valid : std_logic_vector(12 downto 1) := (others => '0');
    signal n_0 : unsigned(7 downto 0) := (others => '0');
    signal x_0 : unsigned(14 downto 0) := (others => '0');
    signal u_0 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_0 : std_logic := '0';
    signal ratio_high_0 : unsigned(5 downto 0) := (others => '0');
    signal ratio_entry_0 : unsigned(5 downto 0) := (others => '0');
    signal ratio_d_0 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_by_0_0 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_by_1_0 : unsigned(4 downto 0) := (others => '0');
    signal above_one_0 : std_logic := '0';
    signal n_1 : unsigned(7 downto 0) := (others => '0');
    signal x_1 : unsigned(14 downto 0) := (others => '0');
    signal u_1 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_1 : std_logic := '0';
    signal ratio_entry_1 : unsigned(5 downto 0) := (others => '0');
    signal ratio_fall_by_0_1 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_by_1_1 : unsigned(4 downto 0) := (others => '0');
    signal above_one_1 : std_logic := '0';
    signal nu_1 : unsigned(22 downto 0) := (others => '0');
    signal beyond_bits_1 : unsigned(4 downto 0) := (others => '0');
    signal v_1 : unsigned(13 downto 0) := (others => '0');
    signal x_2 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_2 : std_logic := '0';
    signal beyond_bits_2 : unsigned(4 downto 0) := (others => '0');
    signal v_2 : unsigned(13 downto 0) := (others => '0');
    signal ratio_fall_by_0_2 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_by_1_2 : unsigned(4 downto 0) := (others => '0');
    signal above_one_2 : std_logic := '0';
    signal beyond_2 : std_logic := '0';
    signal log_base_2 : unsigned(11 downto 0) := (others => '0');
    signal log_slope_2 : unsigned(1 downto 0) := (others => '0');
    signal zero_of_2_2 : std_logic := '0';
    signal x_3 : unsigned(14 downto 0) := (others => '0');
    signal v_3 : unsigned(13 downto 0) := (others => '0');
    signal log_base_3 : unsigned(11 downto 0) := (others => '0');
    signal log_slope_3 : unsigned(1 downto 0) := (others => '0');
    signal ratio_fall_by_0_3 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_by_1_3 : unsigned(4 downto 0) := (others => '0');
    signal zero_of_2_3 : std_logic := '0';
    signal above_one_3 : std_logic := '0';
    signal ratio_fall_bit_0_3 : std_logic := '0';
    signal ratio_fall_without_0_3 : std_logic := '0';
    signal ratio_fall_term_0_3 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_bit_1_3 : std_logic := '0';
    signal ratio_fall_without_1_3 : std_logic := '0';
    signal ratio_fall_term_1_3 : unsigned(4 downto 0) := (others => '0');
    signal ratio_fall_to_1_3 : unsigned(6 downto 0) := (others => '0');
    signal ratio_step_3 : unsigned(4 downto 0) := (others => '0');
    signal x_4 : unsigned(14 downto 0) := (others => '0');
    signal v_4 : unsigned(13 downto 0) := (others => '0');
    signal log_base_4 : unsigned(11 downto 0) := (others => '0');
    signal ratio_step_4 : unsigned(4 downto 0) := (others => '0');
    signal zero_of_2_4 : std_logic := '0';
    signal above_one_4 : std_logic := '0';
    signal ratio_4 : unsigned(11 downto 0) := (others => '0');
    signal x_5 : unsigned(14 downto 0) := (others => '0');
    signal v_5 : unsigned(13 downto 0) := (others => '0');
    signal ratio_5 : unsigned(11 downto 0) := (others => '0');
    signal zero_of_2_5 : std_logic := '0';
    signal above_one_5 : std_logic := '0';
    signal vk_5 : unsigned(25 downto 0) := (others => '0');
    signal z_5 : unsigned(15 downto 0) := (others => '0');
    signal over_bits_5 : unsigned(1 downto 0) := (others => '0');
    signal power_high_5 : unsigned(4 downto 0) := (others => '0');
    signal power_entry_5 : unsigned(4 downto 0) := (others => '0');
    signal power_d_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_0_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_5 : unsigned(4 downto 0) := (others => '0');
    signal i_5 : unsigned(3 downto 0) := (others => '0');
    signal x_6 : unsigned(14 downto 0) := (others => '0');
    signal over_bits_6 : unsigned(1 downto 0) := (others => '0');
    signal power_entry_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_0_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_6 : unsigned(4 downto 0) := (others => '0');
    signal i_6 : unsigned(3 downto 0) := (others => '0');
    signal zero_of_2_6 : std_logic := '0';
    signal above_one_6 : std_logic := '0';
    signal over_6 : std_logic := '0';
    signal zero_6 : std_logic := '0';
    signal x_7 : unsigned(14 downto 0) := (others => '0');
    signal power_fall_by_0_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_7 : unsigned(4 downto 0) := (others => '0');
    signal i_7 : unsigned(3 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal above_one_7 : std_logic := '0';
    signal exp_base_7 : unsigned(11 downto 0) := (others => '0');
    signal exp_slope_7 : unsigned(3 downto 0) := (others => '0');
    signal x_8 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_8 : unsigned(11 downto 0) := (others => '0');
    signal exp_slope_8 : unsigned(3 downto 0) := (others => '0');
    signal power_fall_by_0_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_8 : unsigned(4 downto 0) := (others => '0');
    signal i_8 : unsigned(3 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal above_one_8 : std_logic := '0';
    signal power_fall_bit_0_8 : std_logic := '0';
    signal power_fall_without_0_8 : std_logic := '0';
    signal power_fall_term_0_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_bit_1_8 : std_logic := '0';
    signal power_fall_without_1_8 : std_logic := '0';
    signal power_fall_term_1_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_to_1_8 : unsigned(6 downto 0) := (others => '0');
    signal power_fall_bit_2_8 : std_logic := '0';
    signal power_fall_without_2_8 : std_logic := '0';
    signal power_fall_term_2_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_bit_3_8 : std_logic := '0';
    signal power_fall_without_3_8 : std_logic := '0';
    signal power_fall_term_3_8 : unsigned(4 downto 0) := (others => '0');
    signal x_9 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_9 : unsigned(11 downto 0) := (others => '0');
    signal power_fall_to_1_9 : unsigned(6 downto 0) := (others => '0');
    signal power_fall_term_2_9 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_term_3_9 : unsigned(4 downto 0) := (others => '0');
    signal i_9 : unsigned(3 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal above_one_9 : std_logic := '0';
    signal power_fall_to_2_9 : unsigned(7 downto 0) := (others => '0');
    signal power_fall_to_3_9 : unsigned(8 downto 0) := (others => '0');
    signal power_step_9 : unsigned(6 downto 0) := (others => '0');
    signal x_10 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_10 : unsigned(11 downto 0) := (others => '0');
    signal power_step_10 : unsigned(6 downto 0) := (others => '0');
    signal i_10 : unsigned(3 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal above_one_10 : std_logic := '0';
    signal power_10 : unsigned(11 downto 0) := (others => '0');
    signal x_11 : unsigned(14 downto 0) := (others => '0');
    signal power_11 : unsigned(11 downto 0) := (others => '0');
    signal i_11 : unsigned(3 downto 0) := (others => '0');
    signal zero_11 : std_logic := '0';
    signal above_one_11 : std_logic := '0';
    signal power_shifted_11 : unsigned(11 downto 0) := (others => '0');
    signal y_cut_11 : unsigned(13 downto 0) := (others => '0');
    signal y_11 : unsigned(13 downto 0) := (others => '0');
    signal y_or_x_11 : unsigned(14 downto 0) := (others => '0');
    signal y_or_x_12 : unsigned(14 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(11 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: n, x, u, above_one
    -- UQ8.0: in_n taken into the range
    n_0 <= to_unsigned(1, 8) when in_n < 1 else
        in_n;
    -- UQ1.14: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(15) = '1' else
        (14 => '1', others => '0') when in_cos(14) = '1' else
        unsigned(in_cos(14 downto 0));
    -- UQ1.14: u = 1 - x, the versine
    u_0 <= to_unsigned(16384, 15) - x_0;
    -- UQ1.0: u = 1: the result is 0
    dark_bits_0 <= u_0(14);
    -- UQ0.6: the bits that select the entry
    ratio_high_0 <= x_0(13 downto 8);
    -- UQ6.0: the address in the table
    ratio_entry_0 <= ratio_high_0;
    -- UQ-6.11: the distance from the entry's start
    ratio_d_0 <= x_0(7 downto 3);
    -- UQ-6.11: shifted
    ratio_fall_by_0_0 <= ratio_d_0;
    -- UQ-5.10: shifted
    ratio_fall_by_1_0 <= ratio_d_0;
    -- UQ1.0: n > 1
    above_one_0 <= '1' when n_0 > to_unsigned(1, 8) else '0';
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_1 <= n_0;
                x_1 <= x_0;
                u_1 <= u_0;
                dark_bits_1 <= dark_bits_0;
                ratio_entry_1 <= ratio_entry_0;
                ratio_fall_by_0_1 <= ratio_fall_by_0_0;
                ratio_fall_by_1_1 <= ratio_fall_by_1_0;
                above_one_1 <= above_one_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: read log_table, nu
    -- UQ9.14: n u
    nu_1 <= n_1 * u_1;
    -- UQ8.-3: so large that z is past what the result can show
    beyond_bits_1 <= nu_1(21 downto 17);
    -- UQ3.11: v = n u, rounded down
    v_1 <= nu_1(16 downto 3);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                log_table_2(13 downto 0) <=
                    LOG_TABLE_WORDS_0(to_integer(ratio_entry_1))(13 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_2 <= x_1;
                dark_bits_2 <= dark_bits_1;
                beyond_bits_2 <= beyond_bits_1;
                v_2 <= v_1;
                ratio_fall_by_0_2 <= ratio_fall_by_0_1;
                ratio_fall_by_1_2 <= ratio_fall_by_1_1;
                above_one_2 <= above_one_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: registers only
    -- UQ1.0: so large that z is past what the result can show
    beyond_2 <= '1' when beyond_bits_2 /= 0 else '0';
    -- UQ3.9: log ratio at the entry's start
    log_base_2 <= unsigned(log_table_2(13 downto 2));
    -- UQ2.0: how steeply the log ratio falls
    log_slope_2 <= unsigned(log_table_2(1 downto 0));
    -- UQ1.0: the result is 0
    zero_of_2_2 <= dark_bits_2 or beyond_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_3 <= x_2;
                v_3 <= v_2;
                log_base_3 <= log_base_2;
                log_slope_3 <= log_slope_2;
                ratio_fall_by_0_3 <= ratio_fall_by_0_2;
                ratio_fall_by_1_3 <= ratio_fall_by_1_2;
                zero_of_2_3 <= zero_of_2_2;
                above_one_3 <= above_one_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: ratio_fall_term_0, ratio_fall_term_1, ratio_fall_to_1
    -- UQ1.0: a bit of the slope
    ratio_fall_bit_0_3 <= log_slope_3(0);
    -- UQ1.0: the bit is 0
    ratio_fall_without_0_3 <= not ratio_fall_bit_0_3;
    -- UQ-6.11: 0 where the bit is 0
    ratio_fall_term_0_3 <= (others => '0') when ratio_fall_without_0_3 = '1' else ratio_fall_by_0_3;
    -- UQ2.-1: a bit of the slope
    ratio_fall_bit_1_3 <= log_slope_3(1);
    -- UQ1.0: the bit is 0
    ratio_fall_without_1_3 <= not ratio_fall_bit_1_3;
    -- UQ-5.10: 0 where the bit is 0
    ratio_fall_term_1_3 <= (others => '0') when ratio_fall_without_1_3 = '1' else ratio_fall_by_1_3;
    -- UQ-4.11: how far the value has fallen from the entry's start
    ratio_fall_to_1_3 <=
        resize(ratio_fall_term_0_3, 7) + shift_left(resize(ratio_fall_term_1_3, 7), 1);
    -- UQ-4.9: rounded down
    ratio_step_3 <= ratio_fall_to_1_3(6 downto 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                v_4 <= v_3;
                log_base_4 <= log_base_3;
                ratio_step_4 <= ratio_step_3;
                zero_of_2_4 <= zero_of_2_3;
                above_one_4 <= above_one_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: ratio
    -- UQ3.9: k = -log2(x) / u
    ratio_4 <= log_base_4 - resize(ratio_step_4, 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                v_5 <= v_4;
                ratio_5 <= ratio_4;
                zero_of_2_5 <= zero_of_2_4;
                above_one_5 <= above_one_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: vk
    -- UQ6.20: v k
    vk_5 <= v_5 * ratio_5;
    -- UQ6.10: z = n L, rounded down
    z_5 <= vk_5(25 downto 10);
    -- UQ6.-4: z is past what the result can show
    over_bits_5 <= z_5(15 downto 14);
    -- UQ0.5: the bits that select the entry
    power_high_5 <= z_5(9 downto 5);
    -- UQ5.0: the address in the table
    power_entry_5 <= power_high_5;
    -- UQ-5.10: the distance from the entry's start
    power_d_5 <= z_5(4 downto 0);
    -- UQ-9.14: shifted
    power_fall_by_0_5 <= power_d_5;
    -- UQ-8.13: shifted
    power_fall_by_1_5 <= power_d_5;
    -- UQ-7.12: shifted
    power_fall_by_2_5 <= power_d_5;
    -- UQ-6.11: shifted
    power_fall_by_3_5 <= power_d_5;
    -- UQ4.0: the integer part of z
    i_5 <= z_5(13 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                over_bits_6 <= over_bits_5;
                power_entry_6 <= power_entry_5;
                power_fall_by_0_6 <= power_fall_by_0_5;
                power_fall_by_1_6 <= power_fall_by_1_5;
                power_fall_by_2_6 <= power_fall_by_2_5;
                power_fall_by_3_6 <= power_fall_by_3_5;
                i_6 <= i_5;
                zero_of_2_6 <= zero_of_2_5;
                above_one_6 <= above_one_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: read exp_table
    -- UQ1.0: z is past what the result can show
    over_6 <= '1' when over_bits_6 /= 0 else '0';
    -- UQ1.0: the result is 0
    zero_6 <= zero_of_2_6 or over_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_table_7(15 downto 0) <=
                    EXP_TABLE_WORDS_0(to_integer(power_entry_6))(15 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                power_fall_by_0_7 <= power_fall_by_0_6;
                power_fall_by_1_7 <= power_fall_by_1_6;
                power_fall_by_2_7 <= power_fall_by_2_6;
                power_fall_by_3_7 <= power_fall_by_3_6;
                i_7 <= i_6;
                zero_7 <= zero_6;
                above_one_7 <= above_one_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: registers only
    -- UQ0.12: 2^-f at the entry's start
    exp_base_7 <= unsigned(exp_table_7(15 downto 4));
    -- UQ0.4: how steeply 2^-f falls
    exp_slope_7 <= unsigned(exp_table_7(3 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                exp_base_8 <= exp_base_7;
                exp_slope_8 <= exp_slope_7;
                power_fall_by_0_8 <= power_fall_by_0_7;
                power_fall_by_1_8 <= power_fall_by_1_7;
                power_fall_by_2_8 <= power_fall_by_2_7;
                power_fall_by_3_8 <= power_fall_by_3_7;
                i_8 <= i_7;
                zero_8 <= zero_7;
                above_one_8 <= above_one_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: power_fall_term_0, power_fall_term_1, power_fall_to_1 and 2 more
    -- UQ-3.4: a bit of the slope
    power_fall_bit_0_8 <= exp_slope_8(0);
    -- UQ1.0: the bit is 0
    power_fall_without_0_8 <= not power_fall_bit_0_8;
    -- UQ-9.14: 0 where the bit is 0
    power_fall_term_0_8 <= (others => '0') when power_fall_without_0_8 = '1' else power_fall_by_0_8;
    -- UQ-2.3: a bit of the slope
    power_fall_bit_1_8 <= exp_slope_8(1);
    -- UQ1.0: the bit is 0
    power_fall_without_1_8 <= not power_fall_bit_1_8;
    -- UQ-8.13: 0 where the bit is 0
    power_fall_term_1_8 <= (others => '0') when power_fall_without_1_8 = '1' else power_fall_by_1_8;
    -- UQ-7.14: how far the value has fallen from the entry's start
    power_fall_to_1_8 <=
        resize(power_fall_term_0_8, 7) + shift_left(resize(power_fall_term_1_8, 7), 1);
    -- UQ-1.2: a bit of the slope
    power_fall_bit_2_8 <= exp_slope_8(2);
    -- UQ1.0: the bit is 0
    power_fall_without_2_8 <= not power_fall_bit_2_8;
    -- UQ-7.12: 0 where the bit is 0
    power_fall_term_2_8 <= (others => '0') when power_fall_without_2_8 = '1' else power_fall_by_2_8;
    -- UQ0.1: a bit of the slope
    power_fall_bit_3_8 <= exp_slope_8(3);
    -- UQ1.0: the bit is 0
    power_fall_without_3_8 <= not power_fall_bit_3_8;
    -- UQ-6.11: 0 where the bit is 0
    power_fall_term_3_8 <= (others => '0') when power_fall_without_3_8 = '1' else power_fall_by_3_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_9 <= x_8;
                exp_base_9 <= exp_base_8;
                power_fall_to_1_9 <= power_fall_to_1_8;
                power_fall_term_2_9 <= power_fall_term_2_8;
                power_fall_term_3_9 <= power_fall_term_3_8;
                i_9 <= i_8;
                zero_9 <= zero_8;
                above_one_9 <= above_one_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: power_fall_to_2, power_fall_to_3
    -- UQ-6.14: how far the value has fallen from the entry's start
    power_fall_to_2_9 <=
        resize(power_fall_to_1_9, 8) + shift_left(resize(power_fall_term_2_9, 8), 2);
    -- UQ-5.14: how far the value has fallen from the entry's start
    power_fall_to_3_9 <=
        resize(power_fall_to_2_9, 9) + shift_left(resize(power_fall_term_3_9, 9), 3);
    -- UQ-5.12: rounded down
    power_step_9 <= power_fall_to_3_9(8 downto 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_10 <= x_9;
                exp_base_10 <= exp_base_9;
                power_step_10 <= power_step_9;
                i_10 <= i_9;
                zero_10 <= zero_9;
                above_one_10 <= above_one_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: power
    -- UQ0.12: 2^-f
    power_10 <= exp_base_10 - resize(power_step_10, 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_11 <= x_10;
                power_11 <= power_10;
                i_11 <= i_10;
                zero_11 <= zero_10;
                above_one_11 <= above_one_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: power_shifted, y, y_or_x
    -- UQ0.12: 2^-z = 2^-f 2^-i
    power_shifted_11 <= shift_right(power_11, to_integer(i_11));
    -- UQ0.14: the output's bits
    y_cut_11 <= shift_left(resize(power_shifted_11, 14), 2);
    -- UQ0.14: y, 0 where it is past what the result can show
    y_11 <= (others => '0') when zero_11 = '1' else y_cut_11;
    -- UQ1.14: x itself for n = 1
    y_or_x_11 <= resize(y_11, 15) when above_one_11 = '1' else x_11;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_or_x_12 <= y_or_x_11;
            end if;
        end if;
    end process;

    out_valid <= valid(12);
    out_spec  <= y_or_x_12;

end architecture rtl;
