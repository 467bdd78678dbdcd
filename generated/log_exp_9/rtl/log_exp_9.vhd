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
-- Error against the real-valued method, in ulps of out_spec: proved within -28.488..+28.410.
--   measured -25.000..+22.937 over all 4178175 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.153 % absolute, 0.127 % where x^n >= 1/2, 0.242 % relative there.
-- As the cosine rises, the output never falls: proved by running all 4177920 pairs of neighbouring
--   inputs.

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
    -- Bits 11 downto 0 of each word.
    type log_table_words_0_t is array (127 downto 0) of
        std_logic_vector(11 downto 0);
    constant LOG_TABLE_WORDS_0 : log_table_words_0_t := (
        127 => x"2e4",
        126 => x"2e7",
        125 => x"2ea",
        124 => x"2ed",
        123 => x"2f0",
        122 => x"2f3",
        121 => x"2f6",
        120 => x"2f9",
        119 => x"2fc",
        118 => x"300",
        117 => x"303",
        116 => x"306",
        115 => x"309",
        114 => x"30d",
        113 => x"310",
        112 => x"313",
        111 => x"317",
        110 => x"31a",
        109 => x"31e",
        108 => x"321",
        107 => x"325",
        106 => x"329",
        105 => x"32c",
        104 => x"330",
        103 => x"334",
        102 => x"338",
        101 => x"33c",
        100 => x"340",
        99 => x"344",
        98 => x"348",
        97 => x"34c",
        96 => x"350",
        95 => x"354",
        94 => x"358",
        93 => x"35d",
        92 => x"361",
        91 => x"366",
        90 => x"36a",
        89 => x"36f",
        88 => x"373",
        87 => x"378",
        86 => x"37d",
        85 => x"382",
        84 => x"387",
        83 => x"38c",
        82 => x"391",
        81 => x"396",
        80 => x"39b",
        79 => x"3a0",
        78 => x"3a6",
        77 => x"3ab",
        76 => x"3b1",
        75 => x"3b7",
        74 => x"3bd",
        73 => x"3c2",
        72 => x"3c8",
        71 => x"3cf",
        70 => x"3d5",
        69 => x"3db",
        68 => x"3e1",
        67 => x"3e8",
        66 => x"3ef",
        65 => x"3f6",
        64 => x"3fc",
        63 => x"404",
        62 => x"40b",
        61 => x"412",
        60 => x"41a",
        59 => x"421",
        58 => x"429",
        57 => x"431",
        56 => x"439",
        55 => x"442",
        54 => x"44a",
        53 => x"453",
        52 => x"45c",
        51 => x"465",
        50 => x"46f",
        49 => x"478",
        48 => x"482",
        47 => x"48c",
        46 => x"497",
        45 => x"4a1",
        44 => x"4ac",
        43 => x"4b8",
        42 => x"4c3",
        41 => x"4cf",
        40 => x"4db",
        39 => x"4e8",
        38 => x"4f5",
        37 => x"503",
        36 => x"510",
        35 => x"51f",
        34 => x"52e",
        33 => x"53d",
        32 => x"54d",
        31 => x"55e",
        30 => x"56f",
        29 => x"581",
        28 => x"593",
        27 => x"5a7",
        26 => x"5bb",
        25 => x"5d0",
        24 => x"5e6",
        23 => x"5fd",
        22 => x"616",
        21 => x"62f",
        20 => x"64b",
        19 => x"667",
        18 => x"686",
        17 => x"6a6",
        16 => x"6c9",
        15 => x"6ee",
        14 => x"715",
        13 => x"740",
        12 => x"76f",
        11 => x"7a2",
        10 => x"7da",
        9 => x"819",
        8 => x"85f",
        7 => x"8ae",
        6 => x"90a",
        5 => x"976",
        4 => x"9f8",
        3 => x"a9b",
        2 => x"b70",
        1 => x"c96",
        0 => x"e86"
    );
    signal log_table_2 : std_logic_vector(11 downto 0) := (others => '0');

    -- ===== The memory exp_table
    -- Bits 17 downto 0 of each word.
    type exp_table_words_0_t is array (31 downto 0) of
        std_logic_vector(19 downto 0);
    constant EXP_TABLE_WORDS_0 : exp_table_words_0_t := (
        31 => x"20acb",
        30 => x"2162b",
        29 => x"2222c",
        28 => x"22e0c",
        27 => x"23a2c",
        26 => x"2468c",
        25 => x"253ad",
        24 => x"2608d",
        23 => x"26dad",
        22 => x"27bae",
        21 => x"2896e",
        20 => x"2978e",
        19 => x"2a66f",
        18 => x"2b50f",
        17 => x"2c40f",
        16 => x"2d3f0",
        15 => x"2e390",
        14 => x"2f3b0",
        13 => x"30471",
        12 => x"31531",
        11 => x"32651",
        10 => x"33852",
        9 => x"34a32",
        8 => x"35c72",
        7 => x"36f93",
        6 => x"38293",
        5 => x"39694",
        4 => x"3aa74",
        3 => x"3bf55",
        2 => x"3d415",
        1 => x"3e955",
        0 => x"3ff76"
    );
    signal exp_table_6 : std_logic_vector(17 downto 0) := (others => '0');

    signal valid : std_logic_vector(12 downto 1) := (others => '0');
    signal n_0 : unsigned(7 downto 0) := (others => '0');
    signal x_0 : unsigned(14 downto 0) := (others => '0');
    signal u_0 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_0 : std_logic := '0';
    signal ratio_high_0 : unsigned(6 downto 0) := (others => '0');
    signal ratio_entry_0 : unsigned(6 downto 0) := (others => '0');
    signal top_bits_0 : std_logic := '0';
    signal above_one_0 : std_logic := '0';
    signal n_1 : unsigned(7 downto 0) := (others => '0');
    signal x_1 : unsigned(14 downto 0) := (others => '0');
    signal u_1 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_1 : std_logic := '0';
    signal ratio_entry_1 : unsigned(6 downto 0) := (others => '0');
    signal top_bits_1 : std_logic := '0';
    signal above_one_1 : std_logic := '0';
    signal nu_1 : unsigned(22 downto 0) := (others => '0');
    signal beyond_bits_1 : unsigned(4 downto 0) := (others => '0');
    signal v_1 : unsigned(13 downto 0) := (others => '0');
    signal x_2 : unsigned(14 downto 0) := (others => '0');
    signal dark_bits_2 : std_logic := '0';
    signal beyond_bits_2 : unsigned(4 downto 0) := (others => '0');
    signal v_2 : unsigned(13 downto 0) := (others => '0');
    signal top_bits_2 : std_logic := '0';
    signal above_one_2 : std_logic := '0';
    signal beyond_2 : std_logic := '0';
    signal log_base_2 : unsigned(11 downto 0) := (others => '0');
    signal zero_of_2_2 : std_logic := '0';
    signal x_3 : unsigned(14 downto 0) := (others => '0');
    signal v_3 : unsigned(13 downto 0) := (others => '0');
    signal log_base_3 : unsigned(11 downto 0) := (others => '0');
    signal zero_of_2_3 : std_logic := '0';
    signal top_bits_3 : std_logic := '0';
    signal above_one_3 : std_logic := '0';
    signal x_4 : unsigned(14 downto 0) := (others => '0');
    signal v_4 : unsigned(13 downto 0) := (others => '0');
    signal log_base_4 : unsigned(11 downto 0) := (others => '0');
    signal zero_of_2_4 : std_logic := '0';
    signal top_bits_4 : std_logic := '0';
    signal above_one_4 : std_logic := '0';
    signal vk_4 : unsigned(25 downto 0) := (others => '0');
    signal z_4 : unsigned(15 downto 0) := (others => '0');
    signal over_bits_4 : unsigned(1 downto 0) := (others => '0');
    signal power_high_4 : unsigned(4 downto 0) := (others => '0');
    signal power_entry_4 : unsigned(4 downto 0) := (others => '0');
    signal power_d_4 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_0_4 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_4 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_4 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_4 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_4_4 : unsigned(4 downto 0) := (others => '0');
    signal i_4 : unsigned(3 downto 0) := (others => '0');
    signal x_5 : unsigned(14 downto 0) := (others => '0');
    signal over_bits_5 : unsigned(1 downto 0) := (others => '0');
    signal power_entry_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_0_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_5 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_4_5 : unsigned(4 downto 0) := (others => '0');
    signal i_5 : unsigned(3 downto 0) := (others => '0');
    signal zero_of_2_5 : std_logic := '0';
    signal top_bits_5 : std_logic := '0';
    signal above_one_5 : std_logic := '0';
    signal over_5 : std_logic := '0';
    signal zero_5 : std_logic := '0';
    signal x_6 : unsigned(14 downto 0) := (others => '0');
    signal power_fall_by_0_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_6 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_4_6 : unsigned(4 downto 0) := (others => '0');
    signal i_6 : unsigned(3 downto 0) := (others => '0');
    signal zero_6 : std_logic := '0';
    signal top_bits_6 : std_logic := '0';
    signal above_one_6 : std_logic := '0';
    signal exp_base_6 : unsigned(12 downto 0) := (others => '0');
    signal exp_slope_6 : unsigned(4 downto 0) := (others => '0');
    signal x_7 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_7 : unsigned(12 downto 0) := (others => '0');
    signal exp_slope_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_0_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_1_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_2_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_3_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_by_4_7 : unsigned(4 downto 0) := (others => '0');
    signal i_7 : unsigned(3 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal top_bits_7 : std_logic := '0';
    signal above_one_7 : std_logic := '0';
    signal power_fall_bit_0_7 : std_logic := '0';
    signal power_fall_without_0_7 : std_logic := '0';
    signal power_fall_term_0_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_bit_1_7 : std_logic := '0';
    signal power_fall_without_1_7 : std_logic := '0';
    signal power_fall_term_1_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_to_1_7 : unsigned(6 downto 0) := (others => '0');
    signal power_fall_bit_2_7 : std_logic := '0';
    signal power_fall_without_2_7 : std_logic := '0';
    signal power_fall_term_2_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_bit_3_7 : std_logic := '0';
    signal power_fall_without_3_7 : std_logic := '0';
    signal power_fall_term_3_7 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_bit_4_7 : std_logic := '0';
    signal power_fall_without_4_7 : std_logic := '0';
    signal power_fall_term_4_7 : unsigned(4 downto 0) := (others => '0');
    signal x_8 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_8 : unsigned(12 downto 0) := (others => '0');
    signal power_fall_to_1_8 : unsigned(6 downto 0) := (others => '0');
    signal power_fall_term_2_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_term_3_8 : unsigned(4 downto 0) := (others => '0');
    signal power_fall_term_4_8 : unsigned(4 downto 0) := (others => '0');
    signal i_8 : unsigned(3 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal top_bits_8 : std_logic := '0';
    signal above_one_8 : std_logic := '0';
    signal power_fall_to_2_8 : unsigned(7 downto 0) := (others => '0');
    signal power_fall_to_3_8 : unsigned(8 downto 0) := (others => '0');
    signal x_9 : unsigned(14 downto 0) := (others => '0');
    signal exp_base_9 : unsigned(12 downto 0) := (others => '0');
    signal power_fall_to_3_9 : unsigned(8 downto 0) := (others => '0');
    signal power_fall_term_4_9 : unsigned(4 downto 0) := (others => '0');
    signal i_9 : unsigned(3 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal top_bits_9 : std_logic := '0';
    signal above_one_9 : std_logic := '0';
    signal power_fall_to_4_9 : unsigned(9 downto 0) := (others => '0');
    signal power_step_9 : unsigned(7 downto 0) := (others => '0');
    signal power_9 : unsigned(12 downto 0) := (others => '0');
    signal x_10 : unsigned(14 downto 0) := (others => '0');
    signal power_10 : unsigned(12 downto 0) := (others => '0');
    signal i_10 : unsigned(3 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal top_bits_10 : std_logic := '0';
    signal above_one_10 : std_logic := '0';
    signal power_shifted_10 : unsigned(12 downto 0) := (others => '0');
    signal y_cut_10 : unsigned(13 downto 0) := (others => '0');
    signal y_10 : unsigned(13 downto 0) := (others => '0');
    signal y_lit_10 : unsigned(14 downto 0) := (others => '0');
    signal x_11 : unsigned(14 downto 0) := (others => '0');
    signal y_lit_11 : unsigned(14 downto 0) := (others => '0');
    signal above_one_11 : std_logic := '0';
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
    -- UQ0.7: the bits that select the entry
    ratio_high_0 <= x_0(13 downto 7);
    -- UQ7.0: the address in the table
    ratio_entry_0 <= ratio_high_0;
    -- UQ1.0: x = 1: the result is 1
    top_bits_0 <= x_0(14);
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
                top_bits_1 <= top_bits_0;
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
                log_table_2(11 downto 0) <=
                    LOG_TABLE_WORDS_0(to_integer(ratio_entry_1))(11 downto 0);
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
                top_bits_2 <= top_bits_1;
                above_one_2 <= above_one_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: registers only
    -- UQ1.0: so large that z is past what the result can show
    beyond_2 <= '1' when beyond_bits_2 /= 0 else '0';
    -- UQ3.9: log ratio at the entry's start
    log_base_2 <= unsigned(log_table_2(11 downto 0));
    -- UQ1.0: the result is 0
    zero_of_2_2 <= dark_bits_2 or beyond_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_3 <= x_2;
                v_3 <= v_2;
                log_base_3 <= log_base_2;
                zero_of_2_3 <= zero_of_2_2;
                top_bits_3 <= top_bits_2;
                above_one_3 <= above_one_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                v_4 <= v_3;
                log_base_4 <= log_base_3;
                zero_of_2_4 <= zero_of_2_3;
                top_bits_4 <= top_bits_3;
                above_one_4 <= above_one_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: vk
    -- UQ6.20: v k
    vk_4 <= v_4 * log_base_4;
    -- UQ6.10: z = n L, rounded down
    z_4 <= vk_4(25 downto 10);
    -- UQ6.-4: z is past what the result can show
    over_bits_4 <= z_4(15 downto 14);
    -- UQ0.5: the bits that select the entry
    power_high_4 <= z_4(9 downto 5);
    -- UQ5.0: the address in the table
    power_entry_4 <= power_high_4;
    -- UQ-5.10: the distance from the entry's start
    power_d_4 <= z_4(4 downto 0);
    -- UQ-10.15: shifted
    power_fall_by_0_4 <= power_d_4;
    -- UQ-9.14: shifted
    power_fall_by_1_4 <= power_d_4;
    -- UQ-8.13: shifted
    power_fall_by_2_4 <= power_d_4;
    -- UQ-7.12: shifted
    power_fall_by_3_4 <= power_d_4;
    -- UQ-6.11: shifted
    power_fall_by_4_4 <= power_d_4;
    -- UQ4.0: the integer part of z
    i_4 <= z_4(13 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                over_bits_5 <= over_bits_4;
                power_entry_5 <= power_entry_4;
                power_fall_by_0_5 <= power_fall_by_0_4;
                power_fall_by_1_5 <= power_fall_by_1_4;
                power_fall_by_2_5 <= power_fall_by_2_4;
                power_fall_by_3_5 <= power_fall_by_3_4;
                power_fall_by_4_5 <= power_fall_by_4_4;
                i_5 <= i_4;
                zero_of_2_5 <= zero_of_2_4;
                top_bits_5 <= top_bits_4;
                above_one_5 <= above_one_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: read exp_table
    -- UQ1.0: z is past what the result can show
    over_5 <= '1' when over_bits_5 /= 0 else '0';
    -- UQ1.0: the result is 0
    zero_5 <= zero_of_2_5 or over_5;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_table_6(17 downto 0) <=
                    EXP_TABLE_WORDS_0(to_integer(power_entry_5))(17 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                power_fall_by_0_6 <= power_fall_by_0_5;
                power_fall_by_1_6 <= power_fall_by_1_5;
                power_fall_by_2_6 <= power_fall_by_2_5;
                power_fall_by_3_6 <= power_fall_by_3_5;
                power_fall_by_4_6 <= power_fall_by_4_5;
                i_6 <= i_5;
                zero_6 <= zero_5;
                top_bits_6 <= top_bits_5;
                above_one_6 <= above_one_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: registers only
    -- UQ0.13: 2^-f at the entry's start
    exp_base_6 <= unsigned(exp_table_6(17 downto 5));
    -- UQ0.5: how steeply 2^-f falls
    exp_slope_6 <= unsigned(exp_table_6(4 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                exp_base_7 <= exp_base_6;
                exp_slope_7 <= exp_slope_6;
                power_fall_by_0_7 <= power_fall_by_0_6;
                power_fall_by_1_7 <= power_fall_by_1_6;
                power_fall_by_2_7 <= power_fall_by_2_6;
                power_fall_by_3_7 <= power_fall_by_3_6;
                power_fall_by_4_7 <= power_fall_by_4_6;
                i_7 <= i_6;
                zero_7 <= zero_6;
                top_bits_7 <= top_bits_6;
                above_one_7 <= above_one_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: power_fall_term_0, power_fall_term_1, power_fall_to_1 and 3 more
    -- UQ-4.5: a bit of the slope
    power_fall_bit_0_7 <= exp_slope_7(0);
    -- UQ1.0: the bit is 0
    power_fall_without_0_7 <= not power_fall_bit_0_7;
    -- UQ-10.15: 0 where the bit is 0
    power_fall_term_0_7 <= (others => '0') when power_fall_without_0_7 = '1' else power_fall_by_0_7;
    -- UQ-3.4: a bit of the slope
    power_fall_bit_1_7 <= exp_slope_7(1);
    -- UQ1.0: the bit is 0
    power_fall_without_1_7 <= not power_fall_bit_1_7;
    -- UQ-9.14: 0 where the bit is 0
    power_fall_term_1_7 <= (others => '0') when power_fall_without_1_7 = '1' else power_fall_by_1_7;
    -- UQ-8.15: how far the value has fallen from the entry's start
    power_fall_to_1_7 <=
        resize(power_fall_term_0_7, 7) + shift_left(resize(power_fall_term_1_7, 7), 1);
    -- UQ-2.3: a bit of the slope
    power_fall_bit_2_7 <= exp_slope_7(2);
    -- UQ1.0: the bit is 0
    power_fall_without_2_7 <= not power_fall_bit_2_7;
    -- UQ-8.13: 0 where the bit is 0
    power_fall_term_2_7 <= (others => '0') when power_fall_without_2_7 = '1' else power_fall_by_2_7;
    -- UQ-1.2: a bit of the slope
    power_fall_bit_3_7 <= exp_slope_7(3);
    -- UQ1.0: the bit is 0
    power_fall_without_3_7 <= not power_fall_bit_3_7;
    -- UQ-7.12: 0 where the bit is 0
    power_fall_term_3_7 <= (others => '0') when power_fall_without_3_7 = '1' else power_fall_by_3_7;
    -- UQ0.1: a bit of the slope
    power_fall_bit_4_7 <= exp_slope_7(4);
    -- UQ1.0: the bit is 0
    power_fall_without_4_7 <= not power_fall_bit_4_7;
    -- UQ-6.11: 0 where the bit is 0
    power_fall_term_4_7 <= (others => '0') when power_fall_without_4_7 = '1' else power_fall_by_4_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                exp_base_8 <= exp_base_7;
                power_fall_to_1_8 <= power_fall_to_1_7;
                power_fall_term_2_8 <= power_fall_term_2_7;
                power_fall_term_3_8 <= power_fall_term_3_7;
                power_fall_term_4_8 <= power_fall_term_4_7;
                i_8 <= i_7;
                zero_8 <= zero_7;
                top_bits_8 <= top_bits_7;
                above_one_8 <= above_one_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: power_fall_to_2, power_fall_to_3
    -- UQ-7.15: how far the value has fallen from the entry's start
    power_fall_to_2_8 <=
        resize(power_fall_to_1_8, 8) + shift_left(resize(power_fall_term_2_8, 8), 2);
    -- UQ-6.15: how far the value has fallen from the entry's start
    power_fall_to_3_8 <=
        resize(power_fall_to_2_8, 9) + shift_left(resize(power_fall_term_3_8, 9), 3);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_9 <= x_8;
                exp_base_9 <= exp_base_8;
                power_fall_to_3_9 <= power_fall_to_3_8;
                power_fall_term_4_9 <= power_fall_term_4_8;
                i_9 <= i_8;
                zero_9 <= zero_8;
                top_bits_9 <= top_bits_8;
                above_one_9 <= above_one_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: power_fall_to_4, power
    -- UQ-5.15: how far the value has fallen from the entry's start
    power_fall_to_4_9 <=
        resize(power_fall_to_3_9, 10) + shift_left(resize(power_fall_term_4_9, 10), 4);
    -- UQ-5.13: rounded down
    power_step_9 <= power_fall_to_4_9(9 downto 2);
    -- UQ0.13: 2^-f
    power_9 <= exp_base_9 - resize(power_step_9, 13);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_10 <= x_9;
                power_10 <= power_9;
                i_10 <= i_9;
                zero_10 <= zero_9;
                top_bits_10 <= top_bits_9;
                above_one_10 <= above_one_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: power_shifted, y, y_lit
    -- UQ0.13: 2^-z = 2^-f 2^-i
    power_shifted_10 <= shift_right(power_10, to_integer(i_10));
    -- UQ0.14: the output's bits
    y_cut_10 <= shift_left(resize(power_shifted_10, 14), 1);
    -- UQ0.14: y, 0 where it is past what the result can show
    y_10 <= (others => '0') when zero_10 = '1' else y_cut_10;
    -- UQ1.14: y, 1 at x = 1
    y_lit_10 <= to_unsigned(16384, 15) when top_bits_10 = '1' else resize(y_10, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_11 <= x_10;
                y_lit_11 <= y_lit_10;
                above_one_11 <= above_one_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: y_or_x
    -- UQ1.14: x itself for n = 1
    y_or_x_11 <= y_lit_11 when above_one_11 = '1' else x_11;
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
