-- cubic_min_zero: specular lobe x^n as x max(0, 1 - K u)^2, n = 1 to 127, minimax
--
-- Made by: brdfgen generate core.toml
-- Spec 2f2c78809c9dfeea. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   wr_addr   UQ7.0   address of the word that is written
--   wr_data   UQ16.0  word for the coefficient memory; layout as in its files
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 10 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.625..+0.750.
--   measured -0.616..+0.746 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   6.806 % absolute, 6.806 % where x^n >= 1/2, 13.124 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cubic_min_zero is
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
        -- write enable: takes wr_data into the coefficient memory, whatever ce and rst are
        wr_en     : in  std_logic;
        -- UQ7.0: address of the word that is written
        wr_addr   : in  unsigned(6 downto 0);
        -- UQ16.0: word for the coefficient memory; layout as in its files
        wr_data   : in  unsigned(15 downto 0);
        -- out_spec is a result: in_valid, 10 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity cubic_min_zero;

architecture rtl of cubic_min_zero is
    -- ===== The memory rom
    -- Bits 15 downto 0 of each word.
    type rom_words_0_t is array (127 downto 0) of
        std_logic_vector(15 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        127 => x"b4ae",
        126 => x"b33e",
        125 => x"b1d6",
        124 => x"b066",
        123 => x"aefe",
        122 => x"ad8e",
        121 => x"ac26",
        120 => x"aab6",
        119 => x"a946",
        118 => x"a7de",
        117 => x"a66e",
        116 => x"a506",
        115 => x"a396",
        114 => x"a22e",
        113 => x"a0be",
        112 => x"9f4e",
        111 => x"9de6",
        110 => x"9c7e",
        109 => x"9b0e",
        108 => x"99a6",
        107 => x"9836",
        106 => x"96ce",
        105 => x"9556",
        104 => x"93f6",
        103 => x"9286",
        102 => x"9116",
        101 => x"8fae",
        100 => x"8e36",
        99 => x"8cce",
        98 => x"8b66",
        97 => x"89f6",
        96 => x"888e",
        95 => x"8726",
        94 => x"85be",
        93 => x"843e",
        92 => x"82d6",
        91 => x"816e",
        90 => x"fffd",
        89 => x"fd25",
        88 => x"fa45",
        87 => x"f775",
        86 => x"f495",
        85 => x"f1c5",
        84 => x"eee5",
        83 => x"ec15",
        82 => x"e93d",
        81 => x"e655",
        80 => x"e37d",
        79 => x"e0a5",
        78 => x"ddd5",
        77 => x"dafd",
        76 => x"d81d",
        75 => x"d545",
        74 => x"d26d",
        73 => x"cf95",
        72 => x"ccbd",
        71 => x"c9e5",
        70 => x"c70d",
        69 => x"c435",
        68 => x"c15d",
        67 => x"be85",
        66 => x"bba5",
        65 => x"b8c5",
        64 => x"b5f5",
        63 => x"b325",
        62 => x"b045",
        61 => x"ad6d",
        60 => x"aa95",
        59 => x"a7b5",
        58 => x"a4ed",
        57 => x"a20d",
        56 => x"9f2d",
        55 => x"9c55",
        54 => x"997d",
        53 => x"96a5",
        52 => x"93cd",
        51 => x"90f5",
        50 => x"8e1d",
        49 => x"8b3d",
        48 => x"8865",
        47 => x"858d",
        46 => x"82b5",
        45 => x"ffbc",
        44 => x"fa0c",
        43 => x"f454",
        42 => x"eeac",
        41 => x"e8fc",
        40 => x"e344",
        39 => x"dd84",
        38 => x"d7e4",
        37 => x"d22c",
        36 => x"cc84",
        35 => x"c6cc",
        34 => x"c11c",
        33 => x"bb64",
        32 => x"b5b4",
        31 => x"b004",
        30 => x"aa54",
        29 => x"a49c",
        28 => x"9eec",
        27 => x"993c",
        26 => x"938c",
        25 => x"8ddc",
        24 => x"8824",
        23 => x"827c",
        22 => x"f983",
        21 => x"ee1b",
        20 => x"e2bb",
        19 => x"d753",
        18 => x"cbe3",
        17 => x"c08b",
        16 => x"b52b",
        15 => x"a9cb",
        14 => x"9e5b",
        13 => x"92fb",
        12 => x"8793",
        11 => x"f85a",
        10 => x"e192",
        9 => x"cac2",
        8 => x"b3ea",
        7 => x"9d12",
        6 => x"862a",
        5 => x"de49",
        4 => x"afd9",
        3 => x"8001",
        2 => x"95f8",
        1 => x"0000",
        0 => x"0000"
    );
    type rom_t is array (127 downto 0) of
        std_logic_vector(15 downto 0);

    function initial_rom return rom_t is
        variable result : rom_t;
    begin
        for address in result'range loop
            result(address)(15 downto 0) :=
                ROM_WORDS_0(address)(15 downto 0);
        end loop;
        return result;
    end function;

    signal rom : rom_t := initial_rom;
    -- What is read from an address at the edge at which it is written is not defined: the attribute
    -- spares the logic that would make it so.
    attribute ramstyle : string;
    attribute ramstyle of rom : signal is "no_rw_check";
    signal rom_1 : std_logic_vector(15 downto 0) := (others => '0');

    signal valid : std_logic_vector(10 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal x_1 : unsigned(12 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal big_a_1 : unsigned(12 downto 0) := (others => '0');
    signal k_1 : unsigned(2 downto 0) := (others => '0');
    signal x_2 : unsigned(12 downto 0) := (others => '0');
    signal u_2 : unsigned(12 downto 0) := (others => '0');
    signal big_a_2 : unsigned(12 downto 0) := (others => '0');
    signal k_2 : unsigned(2 downto 0) := (others => '0');
    signal x_3 : unsigned(12 downto 0) := (others => '0');
    signal u_3 : unsigned(12 downto 0) := (others => '0');
    signal big_a_3 : unsigned(12 downto 0) := (others => '0');
    signal k_3 : unsigned(2 downto 0) := (others => '0');
    signal u_scaled_3 : unsigned(18 downto 0) := (others => '0');
    signal beyond_bits_3 : unsigned(5 downto 0) := (others => '0');
    signal beyond_3 : std_logic := '0';
    signal v_3 : unsigned(12 downto 0) := (others => '0');
    signal x_4 : unsigned(12 downto 0) := (others => '0');
    signal big_a_4 : unsigned(12 downto 0) := (others => '0');
    signal beyond_4 : std_logic := '0';
    signal v_4 : unsigned(12 downto 0) := (others => '0');
    signal x_5 : unsigned(12 downto 0) := (others => '0');
    signal big_a_5 : unsigned(12 downto 0) := (others => '0');
    signal beyond_5 : std_logic := '0';
    signal v_5 : unsigned(12 downto 0) := (others => '0');
    signal Av_5 : unsigned(25 downto 0) := (others => '0');
    signal p_above_bits_5 : std_logic := '0';
    signal p_5 : unsigned(14 downto 0) := (others => '0');
    signal x_6 : unsigned(12 downto 0) := (others => '0');
    signal beyond_6 : std_logic := '0';
    signal p_above_bits_6 : std_logic := '0';
    signal p_6 : unsigned(14 downto 0) := (others => '0');
    signal w_6 : unsigned(15 downto 0) := (others => '0');
    signal zero_6 : std_logic := '0';
    signal x_7 : unsigned(12 downto 0) := (others => '0');
    signal w_7 : unsigned(15 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal w2_7 : unsigned(31 downto 0) := (others => '0');
    signal w2_cut_7 : unsigned(15 downto 0) := (others => '0');
    signal x_8 : unsigned(12 downto 0) := (others => '0');
    signal w2_cut_8 : unsigned(15 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal xw_8 : unsigned(28 downto 0) := (others => '0');
    signal xw_9 : unsigned(28 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal y_half_9 : unsigned(27 downto 0) := (others => '0');
    signal y_cut_9 : unsigned(12 downto 0) := (others => '0');
    signal y_9 : unsigned(12 downto 0) := (others => '0');
    signal y_10 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(9 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: read the ROM, x, u
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.12: u = 1 - x, the versine
    u_0 <= to_unsigned(4096, 13) - x_0;
    process (clk) is
    begin
        if rising_edge(clk) then
            if wr_en = '1' then
                rom(to_integer(wr_addr)) <= std_logic_vector(wr_data);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_1 <= rom(to_integer(in_n));
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_1 <= x_0;
                u_1 <= u_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: registers only
    -- UQ0.13: the coefficient A, times 2^-k
    big_a_1 <= unsigned(rom_1(15 downto 3));
    -- UQ3.0: shift of the versine
    k_1 <= unsigned(rom_1(2 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_2 <= x_1;
                u_2 <= u_1;
                big_a_2 <= big_a_1;
                k_2 <= k_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_3 <= x_2;
                u_3 <= u_2;
                big_a_3 <= big_a_2;
                k_3 <= k_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: u_scaled
    -- UQ7.12: u 2^k
    u_scaled_3 <= shift_left(resize(u_3, 19), to_integer(k_3));
    -- UQ7.-1: u 2^k >= 2: then A u >= 1, since A 2^-k >= 1/2
    beyond_bits_3 <= u_scaled_3(18 downto 13);
    -- UQ1.0: u 2^k >= 2: then A u >= 1, since A 2^-k >= 1/2
    beyond_3 <= '1' when beyond_bits_3 /= 0 else '0';
    -- UQ1.12: v = u 2^k, rounded down
    v_3 <= u_scaled_3(12 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                big_a_4 <= big_a_3;
                beyond_4 <= beyond_3;
                v_4 <= v_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                big_a_5 <= big_a_4;
                beyond_5 <= beyond_4;
                v_5 <= v_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: Av
    -- UQ1.25: A u = (A 2^-k) v
    Av_5 <= big_a_5 * v_5;
    -- UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    p_above_bits_5 <= Av_5(25);
    -- UQ0.15: p, rounded down
    p_5 <= Av_5(24 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                beyond_6 <= beyond_5;
                p_above_bits_6 <= p_above_bits_5;
                p_6 <= p_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: w
    -- UQ1.15: w = 1 - p
    w_6 <= to_unsigned(32768, 16) - resize(p_6, 16);
    -- UQ1.0: the result is 0
    zero_6 <= beyond_6 or p_above_bits_6;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                w_7 <= w_6;
                zero_7 <= zero_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: w2
    -- UQ2.30: w^2
    w2_7 <= w_7 * w_7;
    -- UQ1.15: w^2, rounded down
    w2_cut_7 <= w2_7(30 downto 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                w2_cut_8 <= w2_cut_7;
                zero_8 <= zero_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: xw
    -- UQ2.27: x w^2
    xw_8 <= x_8 * w2_cut_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                xw_9 <= xw_8;
                zero_9 <= zero_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: y_half, y
    -- UQ1.27: plus half an output ulp: the result is rounded to nearest
    y_half_9 <= xw_9(27 downto 0) + to_unsigned(16384, 28);
    -- UQ1.12: rounded down to the output's bits
    y_cut_9 <= y_half_9(27 downto 15);
    -- UQ1.12: y, 0 where the lobe has ended
    y_9 <= (others => '0') when zero_9 = '1' else y_cut_9;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_10 <= y_9;
            end if;
        end if;
    end process;

    out_valid <= valid(10);
    out_spec  <= y_10;

end architecture rtl;
