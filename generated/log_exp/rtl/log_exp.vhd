-- log_exp: specular lobe x^n as 2^(-n L(x)), L = -log2 x, n = 1 to 63
--
-- Made by: brdfgen generate core.toml
-- Spec 1c52e369b64c704a. Generated; the core is yours to use under any terms.
--
--   in_n      UQ6.2   shininess, 1 to 63 in steps of 2^-2; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 14 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.886..+0.988.
--   measured -0.629..+0.743 over all 1020153 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.01815 % absolute, 0.01815 % where x^n >= 1/2, 0.03395 % relative there.
-- As the cosine rises, the output never falls: proved by running all 1019904 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity log_exp is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ6.2: shininess, 1 to 63 in steps of 2^-2; outside: the nearest end
        in_n      : in  unsigned(7 downto 0);
        -- Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(13 downto 0);
        -- out_spec is a result: in_valid, 14 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity log_exp;

architecture rtl of log_exp is
    -- ===== The memory log_table
    -- Bits 25 downto 0 of each word.
    type log_table_words_0_t is array (15 downto 0) of
        std_logic_vector(27 downto 0);
    constant LOG_TABLE_WORDS_0 : log_table_words_0_t := (
        15 => x"2ee6af3",
        14 => x"2fabb14",
        13 => x"3079337",
        12 => x"3150b5e",
        11 => x"3232387",
        10 => x"331f3b4",
        9 => x"34183e5",
        8 => x"351f41b",
        7 => x"3634455",
        6 => x"3759c96",
        5 => x"3890cdd",
        4 => x"39db52c",
        3 => x"3b3bd83",
        2 => x"3cb55e6",
        1 => x"3e49e54",
        0 => x"3ffded2"
    );
    signal log_table_3 : std_logic_vector(25 downto 0) := (others => '0');

    -- ===== The memory exp_table
    -- Bits 25 downto 0 of each word.
    type exp_table_words_0_t is array (31 downto 0) of
        std_logic_vector(27 downto 0);
    constant EXP_TABLE_WORDS_0 : exp_table_words_0_t := (
        31 => x"20b32ce",
        30 => x"216a2dd",
        29 => x"2225aed",
        28 => x"22e52fe",
        27 => x"23a8b0e",
        26 => x"2470b20",
        25 => x"253cb31",
        24 => x"260db43",
        23 => x"26e2b55",
        22 => x"27bcb68",
        21 => x"289bb7b",
        20 => x"297f38f",
        19 => x"2a67ba3",
        18 => x"2b55bb7",
        17 => x"2c48bcc",
        16 => x"2d40be1",
        15 => x"2e3e3f7",
        14 => x"2f41c0d",
        13 => x"304ac24",
        12 => x"315943b",
        11 => x"326dc53",
        10 => x"3388c6b",
        9 => x"34a9c84",
        8 => x"35d0c9d",
        7 => x"36fe4b7",
        6 => x"3832cd1",
        5 => x"396dcec",
        4 => x"3aafd08",
        3 => x"3bf8d24",
        2 => x"3d48d41",
        1 => x"3ea055e",
        0 => x"3fff57c"
    );
    signal exp_table_9 : std_logic_vector(25 downto 0) := (others => '0');

    signal valid : std_logic_vector(14 downto 1) := (others => '0');
    signal n_0 : unsigned(7 downto 0) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal enough_0 : std_logic := '0';
    signal small_0 : std_logic := '0';
    signal m_above_8_bits_0 : unsigned(8 downto 0) := (others => '0');
    signal m_above_8_0 : std_logic := '0';
    signal m_by_8_0 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_8_0 : unsigned(11 downto 0) := (others => '0');
    signal m_8_0 : unsigned(12 downto 0) := (others => '0');
    signal m_above_4_bits_0 : unsigned(4 downto 0) := (others => '0');
    signal m_above_4_0 : std_logic := '0';
    signal m_by_4_0 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_4_0 : unsigned(11 downto 0) := (others => '0');
    signal n_low_0 : unsigned(6 downto 0) := (others => '0');
    signal n_8_0 : unsigned(6 downto 0) := (others => '0');
    signal ne_8_0 : unsigned(6 downto 0) := (others => '0');
    signal n_4_0 : unsigned(6 downto 0) := (others => '0');
    signal ne_4_0 : unsigned(6 downto 0) := (others => '0');
    signal n_2_0 : unsigned(6 downto 0) := (others => '0');
    signal n_1_0 : unsigned(6 downto 0) := (others => '0');
    signal n_1 : unsigned(7 downto 0) := (others => '0');
    signal small_1 : std_logic := '0';
    signal m_8_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_4_1 : std_logic := '0';
    signal m_moved_4_1 : unsigned(11 downto 0) := (others => '0');
    signal ne_8_1 : unsigned(6 downto 0) := (others => '0');
    signal ne_4_1 : unsigned(6 downto 0) := (others => '0');
    signal n_2_1 : unsigned(6 downto 0) := (others => '0');
    signal n_1_1 : unsigned(6 downto 0) := (others => '0');
    signal m_4_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_2_bits_1 : unsigned(2 downto 0) := (others => '0');
    signal m_above_2_1 : std_logic := '0';
    signal m_by_2_1 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_2_1 : unsigned(11 downto 0) := (others => '0');
    signal m_2_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_1_bits_1 : unsigned(1 downto 0) := (others => '0');
    signal m_above_1_1 : std_logic := '0';
    signal m_by_1_1 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_1_1 : unsigned(11 downto 0) := (others => '0');
    signal m_1_1 : unsigned(12 downto 0) := (others => '0');
    signal ratio_high_1 : unsigned(3 downto 0) := (others => '0');
    signal ratio_entry_1 : unsigned(3 downto 0) := (others => '0');
    signal ratio_d_1 : unsigned(6 downto 0) := (others => '0');
    signal ne_2_1 : unsigned(6 downto 0) := (others => '0');
    signal ne_1_1 : unsigned(6 downto 0) := (others => '0');
    signal ne_sum_1_0_1 : unsigned(7 downto 0) := (others => '0');
    signal n_2 : unsigned(7 downto 0) := (others => '0');
    signal small_2 : std_logic := '0';
    signal m_1_2 : unsigned(12 downto 0) := (others => '0');
    signal ratio_entry_2 : unsigned(3 downto 0) := (others => '0');
    signal ratio_d_2 : unsigned(6 downto 0) := (others => '0');
    signal ne_2_2 : unsigned(6 downto 0) := (others => '0');
    signal ne_1_2 : unsigned(6 downto 0) := (others => '0');
    signal ne_sum_1_0_2 : unsigned(7 downto 0) := (others => '0');
    signal um_2 : unsigned(11 downto 0) := (others => '0');
    signal ne_sum_1_1_2 : unsigned(7 downto 0) := (others => '0');
    signal ne_sum_2_0_2 : unsigned(9 downto 0) := (others => '0');
    signal n_3 : unsigned(7 downto 0) := (others => '0');
    signal small_3 : std_logic := '0';
    signal um_3 : unsigned(11 downto 0) := (others => '0');
    signal ratio_d_3 : unsigned(6 downto 0) := (others => '0');
    signal ne_sum_2_0_3 : unsigned(9 downto 0) := (others => '0');
    signal nu_3 : unsigned(19 downto 0) := (others => '0');
    signal beyond_bits_3 : unsigned(0 downto 0) := (others => '0');
    signal v_3 : unsigned(17 downto 0) := (others => '0');
    signal log_base_3 : unsigned(14 downto 0) := (others => '0');
    signal log_slope_3 : unsigned(10 downto 0) := (others => '0');
    signal small_4 : std_logic := '0';
    signal beyond_bits_4 : unsigned(0 downto 0) := (others => '0');
    signal v_4 : unsigned(17 downto 0) := (others => '0');
    signal log_base_4 : unsigned(14 downto 0) := (others => '0');
    signal log_slope_4 : unsigned(10 downto 0) := (others => '0');
    signal ratio_d_4 : unsigned(6 downto 0) := (others => '0');
    signal ne_sum_2_0_4 : unsigned(9 downto 0) := (others => '0');
    signal beyond_4 : std_logic := '0';
    signal ratio_fall_4 : unsigned(17 downto 0) := (others => '0');
    signal ratio_step_4 : unsigned(9 downto 0) := (others => '0');
    signal zero_of_2_4 : std_logic := '0';
    signal v_5 : unsigned(17 downto 0) := (others => '0');
    signal log_base_5 : unsigned(14 downto 0) := (others => '0');
    signal ratio_step_5 : unsigned(9 downto 0) := (others => '0');
    signal ne_sum_2_0_5 : unsigned(9 downto 0) := (others => '0');
    signal zero_of_2_5 : std_logic := '0';
    signal ratio_5 : unsigned(14 downto 0) := (others => '0');
    signal v_6 : unsigned(17 downto 0) := (others => '0');
    signal ratio_6 : unsigned(14 downto 0) := (others => '0');
    signal ne_sum_2_0_6 : unsigned(9 downto 0) := (others => '0');
    signal zero_of_2_6 : std_logic := '0';
    signal vk_6 : unsigned(32 downto 0) := (others => '0');
    signal vk_cut_6 : unsigned(19 downto 0) := (others => '0');
    signal vk_cut_7 : unsigned(19 downto 0) := (others => '0');
    signal ne_sum_2_0_7 : unsigned(9 downto 0) := (others => '0');
    signal zero_of_2_7 : std_logic := '0';
    signal z_sum_7 : unsigned(22 downto 0) := (others => '0');
    signal over_bits_7 : unsigned(3 downto 0) := (others => '0');
    signal over_7 : std_logic := '0';
    signal power_high_7 : unsigned(4 downto 0) := (others => '0');
    signal power_entry_7 : unsigned(4 downto 0) := (others => '0');
    signal power_d_7 : unsigned(9 downto 0) := (others => '0');
    signal i_7 : unsigned(3 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal power_entry_8 : unsigned(4 downto 0) := (others => '0');
    signal power_d_8 : unsigned(9 downto 0) := (others => '0');
    signal i_8 : unsigned(3 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal power_d_9 : unsigned(9 downto 0) := (others => '0');
    signal i_9 : unsigned(3 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal exp_base_9 : unsigned(14 downto 0) := (others => '0');
    signal exp_slope_9 : unsigned(10 downto 0) := (others => '0');
    signal exp_base_10 : unsigned(14 downto 0) := (others => '0');
    signal exp_slope_10 : unsigned(10 downto 0) := (others => '0');
    signal power_d_10 : unsigned(9 downto 0) := (others => '0');
    signal i_10 : unsigned(3 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal power_fall_10 : unsigned(20 downto 0) := (others => '0');
    signal power_step_10 : unsigned(9 downto 0) := (others => '0');
    signal exp_base_11 : unsigned(14 downto 0) := (others => '0');
    signal power_step_11 : unsigned(9 downto 0) := (others => '0');
    signal i_11 : unsigned(3 downto 0) := (others => '0');
    signal zero_11 : std_logic := '0';
    signal power_11 : unsigned(14 downto 0) := (others => '0');
    signal power_12 : unsigned(14 downto 0) := (others => '0');
    signal i_12 : unsigned(3 downto 0) := (others => '0');
    signal zero_12 : std_logic := '0';
    signal power_shifted_12 : unsigned(14 downto 0) := (others => '0');
    signal power_shifted_13 : unsigned(14 downto 0) := (others => '0');
    signal zero_13 : std_logic := '0';
    signal y_half_13 : unsigned(15 downto 0) := (others => '0');
    signal y_cut_13 : unsigned(12 downto 0) := (others => '0');
    signal y_13 : unsigned(12 downto 0) := (others => '0');
    signal y_14 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(13 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: n, x, m_8, n_low, ne_8, ne_4
    -- UQ6.2: in_n taken into the range
    n_0 <= to_unsigned(4, 8) when in_n < 4 else
        to_unsigned(252, 8) when in_n > 252 else
        in_n;
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.0: x is large enough for a result above half an ulp
    enough_0 <= '1' when x_0 /= 0 else '0';
    -- UQ1.0: x is so small that the result is 0
    small_0 <= not enough_0;
    -- UQ1.8: a bit of weight 2^-8 or more is set
    m_above_8_bits_0 <= x_0(12 downto 4);
    -- UQ1.0: a bit of weight 2^-8 or more is set
    m_above_8_0 <= '1' when m_above_8_bits_0 /= 0 else '0';
    -- UQ9.4: shifted
    m_by_8_0 <= x_0;
    -- UQ0.12: the high bits are 0
    m_moved_8_0 <= shift_left(m_by_8_0(11 downto 0), 8);
    -- UQ1.12: shifted to the left by 8 where that loses no bit
    m_8_0 <= x_0 when m_above_8_0 = '1' else resize(m_moved_8_0, 13);
    -- UQ1.4: a bit of weight 2^-4 or more is set
    m_above_4_bits_0 <= m_8_0(12 downto 8);
    -- UQ1.0: a bit of weight 2^-4 or more is set
    m_above_4_0 <= '1' when m_above_4_bits_0 /= 0 else '0';
    -- UQ5.8: shifted
    m_by_4_0 <= m_8_0;
    -- UQ0.12: the high bits are 0
    m_moved_4_0 <= shift_left(m_by_4_0(11 downto 0), 4);
    -- UQ5.2: n or more than the result can show, where x < 1/2
    n_low_0 <= (6 => '1', others => '0') when unsigned(n_0(7 downto 6)) /= 0 else
        n_0(6 downto 0);
    -- UQ8.-1: 8 n
    n_8_0 <= n_low_0;
    -- UQ8.-1: 0 where this step was not taken
    ne_8_0 <= (others => '0') when m_above_8_0 = '1' else n_8_0;
    -- UQ7.0: 4 n
    n_4_0 <= n_low_0;
    -- UQ7.0: 0 where this step was not taken
    ne_4_0 <= (others => '0') when m_above_4_0 = '1' else n_4_0;
    -- UQ6.1: 2 n
    n_2_0 <= n_low_0;
    -- UQ5.2: 1 n
    n_1_0 <= n_low_0;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_1 <= n_0;
                small_1 <= small_0;
                m_8_1 <= m_8_0;
                m_above_4_1 <= m_above_4_0;
                m_moved_4_1 <= m_moved_4_0;
                ne_8_1 <= ne_8_0;
                ne_4_1 <= ne_4_0;
                n_2_1 <= n_2_0;
                n_1_1 <= n_1_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: m_4, m_2, m_1, ne_2, ne_1, ne_sum_1_0
    -- UQ1.12: shifted to the left by 4 where that loses no bit
    m_4_1 <= m_8_1 when m_above_4_1 = '1' else resize(m_moved_4_1, 13);
    -- UQ1.2: a bit of weight 2^-2 or more is set
    m_above_2_bits_1 <= m_4_1(12 downto 10);
    -- UQ1.0: a bit of weight 2^-2 or more is set
    m_above_2_1 <= '1' when m_above_2_bits_1 /= 0 else '0';
    -- UQ3.10: shifted
    m_by_2_1 <= m_4_1;
    -- UQ0.12: the high bits are 0
    m_moved_2_1 <= shift_left(m_by_2_1(11 downto 0), 2);
    -- UQ1.12: shifted to the left by 2 where that loses no bit
    m_2_1 <= m_4_1 when m_above_2_1 = '1' else resize(m_moved_2_1, 13);
    -- UQ1.1: a bit of weight 2^-1 or more is set
    m_above_1_bits_1 <= m_2_1(12 downto 11);
    -- UQ1.0: a bit of weight 2^-1 or more is set
    m_above_1_1 <= '1' when m_above_1_bits_1 /= 0 else '0';
    -- UQ2.11: shifted
    m_by_1_1 <= m_2_1;
    -- UQ0.12: the high bits are 0
    m_moved_1_1 <= shift_left(m_by_1_1(11 downto 0), 1);
    -- UQ1.12: shifted to the left by 1 where that loses no bit
    m_1_1 <= m_2_1 when m_above_1_1 = '1' else resize(m_moved_1_1, 13);
    -- UQ-1.5: the bits that select the entry
    ratio_high_1 <= m_1_1(10 downto 7);
    -- UQ4.0: the address in the table
    ratio_entry_1 <= ratio_high_1;
    -- UQ-5.12: the distance from the entry's start
    ratio_d_1 <= m_1_1(6 downto 0);
    -- UQ6.1: 0 where this step was not taken
    ne_2_1 <= (others => '0') when m_above_2_1 = '1' else n_2_1;
    -- UQ5.2: 0 where this step was not taken
    ne_1_1 <= (others => '0') when m_above_1_1 = '1' else n_1_1;
    -- UQ8.0: n e
    ne_sum_1_0_1 <= shift_left(resize(ne_8_1, 8), 1) + resize(ne_4_1, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_2 <= n_1;
                small_2 <= small_1;
                m_1_2 <= m_1_1;
                ratio_entry_2 <= ratio_entry_1;
                ratio_d_2 <= ratio_d_1;
                ne_2_2 <= ne_2_1;
                ne_1_2 <= ne_1_1;
                ne_sum_1_0_2 <= ne_sum_1_0_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: read log_table, um, ne_sum_1_1, ne_sum_2_0
    -- UQ0.12: 1 - m, m = x 2^e in [1/2, 1] or x = 0
    um_2 <= to_unsigned(0, 12) - m_1_2(11 downto 0);
    -- UQ6.2: n e
    ne_sum_1_1_2 <= shift_left(resize(ne_2_2, 8), 1) + resize(ne_1_2, 8);
    -- UQ8.2: n e
    ne_sum_2_0_2 <= shift_left(resize(ne_sum_1_0_2, 10), 2) + resize(ne_sum_1_1_2, 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                log_table_3(25 downto 0) <=
                    LOG_TABLE_WORDS_0(to_integer(ratio_entry_2))(25 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_3 <= n_2;
                small_3 <= small_2;
                um_3 <= um_2;
                ratio_d_3 <= ratio_d_2;
                ne_sum_2_0_3 <= ne_sum_2_0_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: nu
    -- UQ6.14: n (1 - m)
    nu_3 <= n_3 * um_3;
    -- UQ5.-4: so large that z is past what the result can show
    beyond_bits_3 <= nu_3(18 downto 18);
    -- UQ4.14: v = n (1 - m), rounded down
    v_3 <= nu_3(17 downto 0);
    -- UQ1.14: log ratio at the entry's start
    log_base_3 <= unsigned(log_table_3(25 downto 11));
    -- UQ1.10: how steeply the log ratio falls
    log_slope_3 <= unsigned(log_table_3(10 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                small_4 <= small_3;
                beyond_bits_4 <= beyond_bits_3;
                v_4 <= v_3;
                log_base_4 <= log_base_3;
                log_slope_4 <= log_slope_3;
                ratio_d_4 <= ratio_d_3;
                ne_sum_2_0_4 <= ne_sum_2_0_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: ratio_fall
    -- UQ1.0: so large that z is past what the result can show
    beyond_4 <= '1' when beyond_bits_4 /= 0 else '0';
    -- UQ-4.22: how far the value has fallen from the entry's start
    ratio_fall_4 <= log_slope_4 * ratio_d_4;
    -- UQ-4.14: rounded down
    ratio_step_4 <= ratio_fall_4(17 downto 8);
    -- UQ1.0: the result is 0
    zero_of_2_4 <= small_4 or beyond_4;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                v_5 <= v_4;
                log_base_5 <= log_base_4;
                ratio_step_5 <= ratio_step_4;
                ne_sum_2_0_5 <= ne_sum_2_0_4;
                zero_of_2_5 <= zero_of_2_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: ratio
    -- UQ1.14: k = -log2(m) / (1 - m)
    ratio_5 <= log_base_5 - resize(ratio_step_5, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                v_6 <= v_5;
                ratio_6 <= ratio_5;
                ne_sum_2_0_6 <= ne_sum_2_0_5;
                zero_of_2_6 <= zero_of_2_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: vk
    -- UQ5.28: v k
    vk_6 <= v_6 * ratio_6;
    -- UQ5.15: rounded down
    vk_cut_6 <= vk_6(32 downto 13);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                vk_cut_7 <= vk_cut_6;
                ne_sum_2_0_7 <= ne_sum_2_0_6;
                zero_of_2_7 <= zero_of_2_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: z_sum
    -- UQ8.15: z = n e + v k
    z_sum_7 <= shift_left(resize(ne_sum_2_0_7, 23), 13) + resize(vk_cut_7, 23);
    -- UQ8.-4: z is past what the result can show
    over_bits_7 <= z_sum_7(22 downto 19);
    -- UQ1.0: z is past what the result can show
    over_7 <= '1' when over_bits_7 /= 0 else '0';
    -- UQ0.5: the bits that select the entry
    power_high_7 <= z_sum_7(14 downto 10);
    -- UQ5.0: the address in the table
    power_entry_7 <= power_high_7;
    -- UQ-5.15: the distance from the entry's start
    power_d_7 <= z_sum_7(9 downto 0);
    -- UQ4.0: the integer part of z
    i_7 <= z_sum_7(18 downto 15);
    -- UQ1.0: the result is 0
    zero_7 <= zero_of_2_7 or over_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_entry_8 <= power_entry_7;
                power_d_8 <= power_d_7;
                i_8 <= i_7;
                zero_8 <= zero_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: read exp_table
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_table_9(25 downto 0) <=
                    EXP_TABLE_WORDS_0(to_integer(power_entry_8))(25 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_d_9 <= power_d_8;
                i_9 <= i_8;
                zero_9 <= zero_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: registers only
    -- UQ0.15: 2^-f at the entry's start
    exp_base_9 <= unsigned(exp_table_9(25 downto 11));
    -- UQ0.11: how steeply 2^-f falls
    exp_slope_9 <= unsigned(exp_table_9(10 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_base_10 <= exp_base_9;
                exp_slope_10 <= exp_slope_9;
                power_d_10 <= power_d_9;
                i_10 <= i_9;
                zero_10 <= zero_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: power_fall
    -- UQ-5.26: how far the value has fallen from the entry's start
    power_fall_10 <= exp_slope_10 * power_d_10;
    -- UQ-5.15: rounded down
    power_step_10 <= power_fall_10(20 downto 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_base_11 <= exp_base_10;
                power_step_11 <= power_step_10;
                i_11 <= i_10;
                zero_11 <= zero_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: power
    -- UQ0.15: 2^-f
    power_11 <= exp_base_11 - resize(power_step_11, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_12 <= power_11;
                i_12 <= i_11;
                zero_12 <= zero_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: power_shifted
    -- UQ0.15: 2^-z = 2^-f 2^-i
    power_shifted_12 <= shift_right(power_12, to_integer(i_12));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_shifted_13 <= power_shifted_12;
                zero_13 <= zero_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: y_half, y
    -- UQ1.15: plus half an output ulp: the result is rounded to nearest
    y_half_13 <= resize(power_shifted_13, 16) + to_unsigned(4, 16);
    -- UQ1.12: rounded to the output's bits
    y_cut_13 <= y_half_13(15 downto 3);
    -- UQ1.12: y, 0 where it is below half an ulp
    y_13 <= (others => '0') when zero_13 = '1' else y_cut_13;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_14 <= y_13;
            end if;
        end if;
    end process;

    out_valid <= valid(14);
    out_spec  <= y_14;

end architecture rtl;
