-- cubic_rational: specular lobe x^n as x(1 - u(A - a u)) to the cusp, x/(d + b u) past it, n = 1 to 127
--
-- Made by: brdfgen generate core.toml
-- Spec 3702d28f8874f127. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 13 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.959..+0.948.
--   measured -0.689..+0.772 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   10.089 % absolute, 0.540 % where x^n >= 1/2, 0.688 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cubic_rational is
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
        -- out_spec is a result: in_valid, 13 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity cubic_rational;

architecture rtl of cubic_rational is
    -- ===== The memory rom
    -- Bits 31 downto 0 of each word.
    type rom_words_0_t is array (127 downto 0) of
        std_logic_vector(31 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        127 => x"f2785016",
        126 => x"ea785016",
        125 => x"e2786016",
        124 => x"da786016",
        123 => x"d2787017",
        122 => x"ca787017",
        121 => x"c2788017",
        120 => x"ba788017",
        119 => x"b2789017",
        118 => x"aa78a017",
        117 => x"a278a018",
        116 => x"9a78b018",
        115 => x"9278b018",
        114 => x"8a78c018",
        113 => x"8278c019",
        112 => x"7a78d019",
        111 => x"7278e019",
        110 => x"6a78e019",
        109 => x"6278f019",
        108 => x"5a79001a",
        107 => x"5279001a",
        106 => x"4a79101a",
        105 => x"4279201a",
        104 => x"3a79201b",
        103 => x"3279301b",
        102 => x"2a79401b",
        101 => x"2279501c",
        100 => x"1a79501c",
        99 => x"1279601c",
        98 => x"0a79701c",
        97 => x"0279801d",
        96 => x"fa79901d",
        95 => x"f279a01d",
        94 => x"ea79a01e",
        93 => x"e279b01e",
        92 => x"da79c01e",
        91 => x"d279d01f",
        90 => x"ca79e01f",
        89 => x"c279f01f",
        88 => x"ba7a0020",
        87 => x"b27a1020",
        86 => x"aa7a2020",
        85 => x"a27a3021",
        84 => x"9a7a4021",
        83 => x"927a6022",
        82 => x"8a7a7022",
        81 => x"827a8022",
        80 => x"7a7a9023",
        79 => x"727aa023",
        78 => x"6a7ab024",
        77 => x"627ad024",
        76 => x"5a7ae025",
        75 => x"527b0025",
        74 => x"4a7b1026",
        73 => x"427b2026",
        72 => x"3a7b4027",
        71 => x"327b7027",
        70 => x"2a7b7028",
        69 => x"227b9028",
        68 => x"1a7ba029",
        67 => x"127bc02a",
        66 => x"0a7be02a",
        65 => x"027c002b",
        64 => x"fa7c202c",
        63 => x"f27c302c",
        62 => x"ea7c502d",
        61 => x"e27c802e",
        60 => x"da7c902f",
        59 => x"d27cc02f",
        58 => x"ca7ce030",
        57 => x"c27d0031",
        56 => x"ba7d3032",
        55 => x"b27d5033",
        54 => x"aa7d8034",
        53 => x"a27db035",
        52 => x"9a7de036",
        51 => x"927e1037",
        50 => x"8a7e4038",
        49 => x"827e7039",
        48 => x"7a7ea03a",
        47 => x"727ee03b",
        46 => x"6a7f103d",
        45 => x"627f503e",
        44 => x"5a7f9040",
        43 => x"527fd041",
        42 => x"4a801043",
        41 => x"42806044",
        40 => x"3a80b046",
        39 => x"32810048",
        38 => x"2a81504a",
        37 => x"2281a04c",
        36 => x"1a82004e",
        35 => x"12826050",
        34 => x"0a82d052",
        33 => x"02834055",
        32 => x"fa83b057",
        31 => x"f284305a",
        30 => x"ea84b05d",
        29 => x"e2854060",
        28 => x"da85e064",
        27 => x"d2868067",
        26 => x"ca87306b",
        25 => x"c287f070",
        24 => x"ba88c074",
        23 => x"b289a079",
        22 => x"aa8a907f",
        21 => x"a28ba084",
        20 => x"9a8cc08b",
        19 => x"928e0092",
        18 => x"8a8f709a",
        17 => x"829100a3",
        16 => x"7a92c0ad",
        15 => x"7294c0b8",
        14 => x"6a9700c5",
        13 => x"6299a0d4",
        12 => x"5a9ca0e5",
        11 => x"52a040fa",
        10 => x"4aa48112",
        9 => x"42a9c12f",
        8 => x"3ab03153",
        7 => x"32b87182",
        6 => x"2ac361be",
        5 => x"22d27212",
        4 => x"1ae8a28b",
        3 => x"130c834d",
        2 => x"0b5054af",
        1 => x"04000800",
        0 => x"04000800"
    );
    -- Bits 61 downto 32 of each word.
    type rom_words_1_t is array (127 downto 0) of
        std_logic_vector(31 downto 0);
    constant ROM_WORDS_1 : rom_words_1_t := (
        127 => x"3b81cf7f",
        126 => x"3b094e3f",
        125 => x"3a904cff",
        124 => x"3a1bcbdf",
        123 => x"39a24a9f",
        122 => x"3928495f",
        121 => x"38adc81f",
        120 => x"3837c6ff",
        119 => x"37bc45bf",
        118 => x"3745c49f",
        117 => x"36cec37f",
        116 => x"3652423f",
        115 => x"35da411f",
        114 => x"3561bfff",
        113 => x"34e93edf",
        112 => x"34703dbf",
        111 => x"33f6bc9f",
        110 => x"3381bb9f",
        109 => x"33073a7f",
        108 => x"328cb95f",
        107 => x"3216b85f",
        106 => x"319b373f",
        105 => x"3124363f",
        104 => x"30ad353f",
        103 => x"3035b43f",
        102 => x"2fbdb33f",
        101 => x"2f3f321f",
        100 => x"2ecc313f",
        99 => x"2e52b03f",
        98 => x"2dd92f3f",
        97 => x"2d5eae3f",
        96 => x"2ce3ad3e",
        95 => x"2c6eac5e",
        94 => x"2bf2ab5e",
        93 => x"2b7c2a7e",
        92 => x"2b05a99e",
        91 => x"2a88289e",
        90 => x"2a10a7be",
        89 => x"299826de",
        88 => x"291fa5fe",
        87 => x"28a6a51e",
        86 => x"282ca43e",
        85 => x"27b9237e",
        84 => x"273e229e",
        83 => x"26c2a1be",
        82 => x"264da0fe",
        81 => x"25d1201e",
        80 => x"255b1f5e",
        79 => x"24e41e9e",
        78 => x"246d1dde",
        77 => x"23f51d1e",
        76 => x"23759c3e",
        75 => x"23041b9e",
        74 => x"228a9ade",
        73 => x"22109a1e",
        72 => x"2195995e",
        71 => x"211a189e",
        70 => x"20a597fe",
        69 => x"2028973e",
        68 => x"3f66da1a",
        67 => x"3e76d77a",
        66 => x"3d8554da",
        65 => x"3c92d23a",
        64 => x"3ba2cfb9",
        63 => x"3ab14d39",
        62 => x"39becab9",
        61 => x"38cec859",
        60 => x"37ddc5f9",
        59 => x"36eb4399",
        58 => x"35fbc159",
        57 => x"350b3f19",
        56 => x"3418bcd9",
        55 => x"3324ba99",
        54 => x"3233b879",
        53 => x"31413659",
        52 => x"3052b459",
        51 => x"2f62b259",
        50 => x"2e703059",
        49 => x"2d7c2e59",
        48 => x"2c8c2c79",
        47 => x"2b9a2a99",
        46 => x"2aaca8d9",
        45 => x"29b6a6f9",
        44 => x"28c4a539",
        43 => x"27d7a399",
        42 => x"26e121d9",
        41 => x"25efa039",
        40 => x"25031eb9",
        39 => x"240d1d19",
        38 => x"231b9b99",
        37 => x"22301a39",
        36 => x"213998b9",
        35 => x"20489759",
        34 => x"3eb2d7d5",
        33 => x"3cced295",
        32 => x"3ae9cd74",
        31 => x"3907c894",
        30 => x"372443d4",
        29 => x"35443f54",
        28 => x"335e3ad4",
        27 => x"317b3694",
        26 => x"2f9cb294",
        25 => x"2db72e94",
        24 => x"2bd52ad4",
        23 => x"29f22734",
        22 => x"280d23b4",
        21 => x"262ca074",
        20 => x"244a9d54",
        19 => x"22661a54",
        18 => x"207f9774",
        17 => x"3d3d5310",
        16 => x"3976c910",
        15 => x"35afbfb0",
        14 => x"31e7b6f0",
        13 => x"2e1eaed0",
        12 => x"2a542750",
        11 => x"268f2090",
        10 => x"22c19a50",
        9 => x"3df3530c",
        8 => x"365fbf8c",
        7 => x"2ec22e6c",
        6 => x"2727a00c",
        5 => x"3effd048",
        4 => x"2f972ae8",
        3 => x"20001008",
        2 => x"20000004",
        1 => x"00000000",
        0 => x"00000000"
    );
    signal rom_1 : std_logic_vector(61 downto 0) := (others => '0');

    -- ===== The memory reciprocal
    -- Bits 21 downto 0 of each word.
    type reciprocal_words_0_t is array (63 downto 0) of
        std_logic_vector(23 downto 0);
    constant RECIPROCAL_WORDS_0 : reciprocal_words_0_t := (
        63 => x"204010",
        62 => x"208110",
        61 => x"20c511",
        60 => x"210851",
        59 => x"214c91",
        58 => x"2191d1",
        57 => x"21da52",
        56 => x"2221d2",
        55 => x"226a92",
        54 => x"22b6d3",
        53 => x"230213",
        52 => x"234e93",
        51 => x"239e94",
        50 => x"23edd4",
        49 => x"243e94",
        48 => x"249295",
        47 => x"24e655",
        46 => x"253b55",
        45 => x"259416",
        44 => x"25ec56",
        43 => x"264817",
        42 => x"26a3d7",
        41 => x"270318",
        40 => x"276218",
        39 => x"27c318",
        38 => x"2827d9",
        37 => x"288cd9",
        36 => x"28f59a",
        35 => x"295e9a",
        34 => x"29cb5b",
        33 => x"2a3a9c",
        32 => x"2aaa1c",
        31 => x"2b1ddd",
        30 => x"2b921d",
        29 => x"2c0a9e",
        28 => x"2c861f",
        27 => x"2d01df",
        26 => x"2d8260",
        25 => x"2e0621",
        24 => x"2e8a61",
        23 => x"2f13e2",
        22 => x"2fa023",
        21 => x"303024",
        20 => x"30c365",
        19 => x"3159e6",
        18 => x"31f427",
        17 => x"329027",
        16 => x"3331e8",
        15 => x"33d7e9",
        14 => x"3483eb",
        13 => x"35322c",
        12 => x"35e4ed",
        11 => x"369c6e",
        10 => x"3758ef",
        9 => x"381cb1",
        8 => x"38e332",
        7 => x"39afb3",
        6 => x"3a83b5",
        5 => x"3b5bb6",
        4 => x"3c3bf8",
        3 => x"3d22fa",
        2 => x"3e0e7b",
        1 => x"3f02fd",
        0 => x"3fff3f"
    );
    signal reciprocal_7 : std_logic_vector(21 downto 0) := (others => '0');

    signal valid : std_logic_vector(13 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal num_0 : unsigned(11 downto 0) := (others => '0');
    signal x_1 : unsigned(12 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal num_1 : unsigned(11 downto 0) := (others => '0');
    signal cut_1 : unsigned(11 downto 0) := (others => '0');
    signal big_a_1 : unsigned(14 downto 0) := (others => '0');
    signal a_1 : unsigned(9 downto 0) := (others => '0');
    signal k_1 : unsigned(2 downto 0) := (others => '0');
    signal b_1 : unsigned(6 downto 0) := (others => '0');
    signal d_1 : unsigned(14 downto 0) := (others => '0');
    signal x_2 : unsigned(12 downto 0) := (others => '0');
    signal u_2 : unsigned(12 downto 0) := (others => '0');
    signal cut_2 : unsigned(11 downto 0) := (others => '0');
    signal big_a_2 : unsigned(14 downto 0) := (others => '0');
    signal a_2 : unsigned(9 downto 0) := (others => '0');
    signal k_2 : unsigned(2 downto 0) := (others => '0');
    signal b_2 : unsigned(6 downto 0) := (others => '0');
    signal d_2 : unsigned(14 downto 0) := (others => '0');
    signal num_2 : unsigned(11 downto 0) := (others => '0');
    signal x_3 : unsigned(12 downto 0) := (others => '0');
    signal u_3 : unsigned(12 downto 0) := (others => '0');
    signal cut_3 : unsigned(11 downto 0) := (others => '0');
    signal big_a_3 : unsigned(14 downto 0) := (others => '0');
    signal a_3 : unsigned(9 downto 0) := (others => '0');
    signal k_3 : unsigned(2 downto 0) := (others => '0');
    signal b_3 : unsigned(6 downto 0) := (others => '0');
    signal d_3 : unsigned(14 downto 0) := (others => '0');
    signal num_3 : unsigned(11 downto 0) := (others => '0');
    signal past_3 : std_logic := '0';
    signal u_scaled_3 : unsigned(12 downto 0) := (others => '0');
    signal v_3 : unsigned(11 downto 0) := (others => '0');
    signal bu_3 : unsigned(19 downto 0) := (others => '0');
    signal x_4 : unsigned(12 downto 0) := (others => '0');
    signal past_4 : std_logic := '0';
    signal big_a_4 : unsigned(14 downto 0) := (others => '0');
    signal a_4 : unsigned(9 downto 0) := (others => '0');
    signal v_4 : unsigned(11 downto 0) := (others => '0');
    signal d_4 : unsigned(14 downto 0) := (others => '0');
    signal num_4 : unsigned(11 downto 0) := (others => '0');
    signal bu_4 : unsigned(19 downto 0) := (others => '0');
    signal den_4 : unsigned(21 downto 0) := (others => '0');
    signal from_4_bits_4 : unsigned(3 downto 0) := (others => '0');
    signal from_4_4 : std_logic := '0';
    signal m_4_high_4 : unsigned(21 downto 0) := (others => '0');
    signal m_4_high_wide_4 : unsigned(17 downto 0) := (others => '0');
    signal m_4_low_wide_4 : unsigned(17 downto 0) := (others => '0');
    signal m_4_4 : unsigned(17 downto 0) := (others => '0');
    signal from_2_bits_4 : unsigned(1 downto 0) := (others => '0');
    signal m_2_high_4 : unsigned(17 downto 0) := (others => '0');
    signal m_2_high_wide_4 : unsigned(15 downto 0) := (others => '0');
    signal m_2_low_wide_4 : unsigned(15 downto 0) := (others => '0');
    signal x_5 : unsigned(12 downto 0) := (others => '0');
    signal past_5 : std_logic := '0';
    signal big_a_5 : unsigned(14 downto 0) := (others => '0');
    signal a_5 : unsigned(9 downto 0) := (others => '0');
    signal v_5 : unsigned(11 downto 0) := (others => '0');
    signal num_5 : unsigned(11 downto 0) := (others => '0');
    signal from_4_5 : std_logic := '0';
    signal from_2_bits_5 : unsigned(1 downto 0) := (others => '0');
    signal m_2_high_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal m_2_low_wide_5 : unsigned(15 downto 0) := (others => '0');
    signal av_5 : unsigned(21 downto 0) := (others => '0');
    signal r_5 : unsigned(12 downto 0) := (others => '0');
    signal from_2_5 : std_logic := '0';
    signal m_2_5 : unsigned(15 downto 0) := (others => '0');
    signal from_1_bits_5 : std_logic := '0';
    signal m_1_high_5 : unsigned(15 downto 0) := (others => '0');
    signal m_1_high_wide_5 : unsigned(14 downto 0) := (others => '0');
    signal m_1_low_wide_5 : unsigned(14 downto 0) := (others => '0');
    signal m_1_5 : unsigned(14 downto 0) := (others => '0');
    signal fraction_5 : unsigned(13 downto 0) := (others => '0');
    signal entry_5 : unsigned(5 downto 0) := (others => '0');
    signal offset_5 : unsigned(7 downto 0) := (others => '0');
    signal x_6 : unsigned(12 downto 0) := (others => '0');
    signal past_6 : std_logic := '0';
    signal big_a_6 : unsigned(14 downto 0) := (others => '0');
    signal v_6 : unsigned(11 downto 0) := (others => '0');
    signal r_6 : unsigned(12 downto 0) := (others => '0');
    signal num_6 : unsigned(11 downto 0) := (others => '0');
    signal from_4_6 : std_logic := '0';
    signal from_2_6 : std_logic := '0';
    signal from_1_bits_6 : std_logic := '0';
    signal entry_6 : unsigned(5 downto 0) := (others => '0');
    signal offset_6 : unsigned(7 downto 0) := (others => '0');
    signal q_6 : unsigned(14 downto 0) := (others => '0');
    signal x_7 : unsigned(12 downto 0) := (others => '0');
    signal past_7 : std_logic := '0';
    signal v_7 : unsigned(11 downto 0) := (others => '0');
    signal q_7 : unsigned(14 downto 0) := (others => '0');
    signal num_7 : unsigned(11 downto 0) := (others => '0');
    signal from_4_7 : std_logic := '0';
    signal from_2_7 : std_logic := '0';
    signal from_1_bits_7 : std_logic := '0';
    signal offset_7 : unsigned(7 downto 0) := (others => '0');
    signal vq_7 : unsigned(26 downto 0) := (others => '0');
    signal p_above_bits_7 : std_logic := '0';
    signal p_7 : unsigned(13 downto 0) := (others => '0');
    signal seed_7 : unsigned(15 downto 0) := (others => '0');
    signal slope_7 : unsigned(5 downto 0) := (others => '0');
    signal x_8 : unsigned(12 downto 0) := (others => '0');
    signal past_8 : std_logic := '0';
    signal p_above_bits_8 : std_logic := '0';
    signal p_8 : unsigned(13 downto 0) := (others => '0');
    signal num_8 : unsigned(11 downto 0) := (others => '0');
    signal from_4_8 : std_logic := '0';
    signal from_2_8 : std_logic := '0';
    signal from_1_bits_8 : std_logic := '0';
    signal seed_8 : unsigned(15 downto 0) := (others => '0');
    signal slope_8 : unsigned(5 downto 0) := (others => '0');
    signal offset_8 : unsigned(7 downto 0) := (others => '0');
    signal xp_8 : unsigned(26 downto 0) := (others => '0');
    signal t_8 : unsigned(11 downto 0) := (others => '0');
    signal fall_exact_8 : unsigned(13 downto 0) := (others => '0');
    signal fall_8 : unsigned(9 downto 0) := (others => '0');
    signal x_9 : unsigned(12 downto 0) := (others => '0');
    signal past_9 : std_logic := '0';
    signal p_above_bits_9 : std_logic := '0';
    signal t_9 : unsigned(11 downto 0) := (others => '0');
    signal num_9 : unsigned(11 downto 0) := (others => '0');
    signal from_4_9 : std_logic := '0';
    signal from_2_9 : std_logic := '0';
    signal from_1_bits_9 : std_logic := '0';
    signal seed_9 : unsigned(15 downto 0) := (others => '0');
    signal fall_9 : unsigned(9 downto 0) := (others => '0');
    signal y_exact_9 : unsigned(13 downto 0) := (others => '0');
    signal y_cut_9 : unsigned(12 downto 0) := (others => '0');
    signal y_9 : unsigned(12 downto 0) := (others => '0');
    signal inverse_9 : unsigned(15 downto 0) := (others => '0');
    signal past_10 : std_logic := '0';
    signal y_10 : unsigned(12 downto 0) := (others => '0');
    signal num_10 : unsigned(11 downto 0) := (others => '0');
    signal from_4_10 : std_logic := '0';
    signal from_2_10 : std_logic := '0';
    signal from_1_bits_10 : std_logic := '0';
    signal inverse_10 : unsigned(15 downto 0) := (others => '0');
    signal product_10 : unsigned(27 downto 0) := (others => '0');
    signal scaled_10 : unsigned(12 downto 0) := (others => '0');
    signal scaled_4_moved_10 : unsigned(12 downto 0) := (others => '0');
    signal scaled_4_low_10 : unsigned(8 downto 0) := (others => '0');
    signal past_11 : std_logic := '0';
    signal y_11 : unsigned(12 downto 0) := (others => '0');
    signal from_4_11 : std_logic := '0';
    signal from_2_11 : std_logic := '0';
    signal from_1_bits_11 : std_logic := '0';
    signal scaled_11 : unsigned(12 downto 0) := (others => '0');
    signal scaled_4_low_11 : unsigned(8 downto 0) := (others => '0');
    signal scaled_4_11 : unsigned(12 downto 0) := (others => '0');
    signal scaled_2_moved_11 : unsigned(12 downto 0) := (others => '0');
    signal scaled_2_low_11 : unsigned(10 downto 0) := (others => '0');
    signal scaled_2_11 : unsigned(12 downto 0) := (others => '0');
    signal scaled_1_moved_11 : unsigned(12 downto 0) := (others => '0');
    signal scaled_1_low_11 : unsigned(11 downto 0) := (others => '0');
    signal scaled_1_11 : unsigned(12 downto 0) := (others => '0');
    signal past_12 : std_logic := '0';
    signal y_12 : unsigned(12 downto 0) := (others => '0');
    signal scaled_1_12 : unsigned(12 downto 0) := (others => '0');
    signal quotient_half_12 : unsigned(12 downto 0) := (others => '0');
    signal quotient_12 : unsigned(11 downto 0) := (others => '0');
    signal either_12 : unsigned(12 downto 0) := (others => '0');
    signal either_13 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(12 downto 1) & in_valid;
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
    -- UQ0.12: x, rounded down: below 1 in the tail
    num_0 <= x_0(11 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_1(31 downto 0) <=
                    ROM_WORDS_0(to_integer(in_n))(31 downto 0);
                rom_1(61 downto 32) <=
                    ROM_WORDS_1(to_integer(in_n))(29 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_1 <= x_0;
                u_1 <= u_0;
                num_1 <= num_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: registers only
    -- UQ0.12: the largest versine of the cubic
    cut_1 <= unsigned(rom_1(11 downto 0));
    -- UQ0.15: the coefficient A, times 2^-k
    big_a_1 <= unsigned(rom_1(61 downto 47));
    -- UQ-1.11: the coefficient a, times 4^-k
    a_1 <= unsigned(rom_1(46 downto 37));
    -- UQ3.0: shift of the versine
    k_1 <= unsigned(rom_1(36 downto 34));
    -- UQ8.-1: the tail's slope b
    b_1 <= unsigned(rom_1(33 downto 27));
    -- UQ1.14: the tail's constant d
    d_1 <= unsigned(rom_1(26 downto 12));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_2 <= x_1;
                u_2 <= u_1;
                cut_2 <= cut_1;
                big_a_2 <= big_a_1;
                a_2 <= a_1;
                k_2 <= k_1;
                b_2 <= b_1;
                d_2 <= d_1;
                num_2 <= num_1;
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
                cut_3 <= cut_2;
                big_a_3 <= big_a_2;
                a_3 <= a_2;
                k_3 <= k_2;
                b_3 <= b_2;
                d_3 <= d_2;
                num_3 <= num_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: past, u_scaled, bu
    -- UQ1.0: u > cut: past the cubic's versines
    past_3 <= '1' when u_3 > cut_3 else '0';
    -- UQ1.12: u 2^k
    u_scaled_3 <= shift_left(u_3, to_integer(k_3));
    -- UQ1.11: v = u 2^k, rounded down; wraps past the cut
    v_3 <= u_scaled_3(12 downto 1);
    -- UQ9.11: b u
    bu_3 <= b_3 * u_3;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                past_4 <= past_3;
                big_a_4 <= big_a_3;
                a_4 <= a_3;
                v_4 <= v_3;
                d_4 <= d_3;
                num_4 <= num_3;
                bu_4 <= bu_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: den, m_4
    -- UQ8.14: the tail's denominator, d + b u
    den_4 <= resize(d_4, 22) + shift_left(resize(bu_4, 22), 3);
    -- UQ8.-4: the bits from 2^4 on
    from_4_bits_4 <= den_4(21 downto 18);
    -- UQ1.0: the denominator is 2^4 or more
    from_4_4 <= '1' when from_4_bits_4 /= 0 else '0';
    -- UQ4.18: times 2^-4
    m_4_high_4 <= den_4;
    -- UQ4.14: in one format
    m_4_high_wide_4 <= m_4_high_4(21 downto 4);
    -- UQ4.14: in one format
    m_4_low_wide_4 <= den_4(17 downto 0);
    -- UQ4.14: below 2^4
    m_4_4 <= m_4_high_wide_4 when from_4_4 = '1' else m_4_low_wide_4;
    -- UQ4.-2: the bits from 2^2 on
    from_2_bits_4 <= m_4_4(17 downto 16);
    -- UQ2.16: times 2^-2
    m_2_high_4 <= m_4_4;
    -- UQ2.14: in one format
    m_2_high_wide_4 <= m_2_high_4(17 downto 2);
    -- UQ2.14: in one format
    m_2_low_wide_4 <= m_4_4(15 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                past_5 <= past_4;
                big_a_5 <= big_a_4;
                a_5 <= a_4;
                v_5 <= v_4;
                num_5 <= num_4;
                from_4_5 <= from_4_4;
                from_2_bits_5 <= from_2_bits_4;
                m_2_high_wide_5 <= m_2_high_wide_4;
                m_2_low_wide_5 <= m_2_low_wide_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: av, m_2, m_1
    -- UQ0.22: (a 4^-k) v
    av_5 <= a_5 * v_5;
    -- UQ-2.15: (a 4^-k) v, rounded down
    r_5 <= av_5(19 downto 7);
    -- UQ1.0: the denominator is 2^2 or more
    from_2_5 <= '1' when from_2_bits_5 /= 0 else '0';
    -- UQ2.14: below 2^2
    m_2_5 <= m_2_high_wide_5 when from_2_5 = '1' else m_2_low_wide_5;
    -- UQ2.-1: the bits from 2^1 on
    from_1_bits_5 <= m_2_5(15);
    -- UQ1.15: times 2^-1
    m_1_high_5 <= m_2_5;
    -- UQ1.14: in one format
    m_1_high_wide_5 <= m_1_high_5(15 downto 1);
    -- UQ1.14: in one format
    m_1_low_wide_5 <= m_2_5(14 downto 0);
    -- UQ1.14: below 2^1
    m_1_5 <= m_1_high_wide_5 when from_1_bits_5 = '1' else m_1_low_wide_5;
    -- UQ0.14: m - 1, rounded down
    fraction_5 <= m_1_5(13 downto 0);
    -- UQ0.6: the entry of the table
    entry_5 <= fraction_5(13 downto 8);
    -- UQ-6.14: m less the entry's least m
    offset_5 <= fraction_5(7 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                past_6 <= past_5;
                big_a_6 <= big_a_5;
                v_6 <= v_5;
                r_6 <= r_5;
                num_6 <= num_5;
                from_4_6 <= from_4_5;
                from_2_6 <= from_2_5;
                from_1_bits_6 <= from_1_bits_5;
                entry_6 <= entry_5;
                offset_6 <= offset_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: read reciprocal, q
    -- UQ0.15: q = (A - a u) 2^-k; wraps past the cut
    q_6 <= big_a_6 - resize(r_6, 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_7(21 downto 0) <=
                    RECIPROCAL_WORDS_0(to_integer(entry_6))(21 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                past_7 <= past_6;
                v_7 <= v_6;
                q_7 <= q_6;
                num_7 <= num_6;
                from_4_7 <= from_4_6;
                from_2_7 <= from_2_6;
                from_1_bits_7 <= from_1_bits_6;
                offset_7 <= offset_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: vq
    -- UQ1.26: u (A - a u) = v q
    vq_7 <= v_7 * q_7;
    -- UQ1.0: the integer bits of p: the lobe is 0 from p = 1 on
    p_above_bits_7 <= vq_7(26);
    -- UQ-1.15: p, rounded down
    p_7 <= vq_7(24 downto 11);
    -- UQ0.16: about 1/m at the entry's least m
    seed_7 <= unsigned(reciprocal_7(21 downto 6));
    -- UQ0.6: how fast 1/m falls
    slope_7 <= unsigned(reciprocal_7(5 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                past_8 <= past_7;
                p_above_bits_8 <= p_above_bits_7;
                p_8 <= p_7;
                num_8 <= num_7;
                from_4_8 <= from_4_7;
                from_2_8 <= from_2_7;
                from_1_bits_8 <= from_1_bits_7;
                seed_8 <= seed_7;
                slope_8 <= slope_7;
                offset_8 <= offset_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: xp, fall_exact
    -- UQ0.27: x p
    xp_8 <= x_8 * p_8;
    -- UQ-1.13: t = x p, rounded down
    t_8 <= xp_8(25 downto 14);
    -- UQ-6.20: slope d
    fall_exact_8 <= slope_8 * offset_8;
    -- UQ-6.16: slope d, rounded down
    fall_8 <= fall_exact_8(13 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_9 <= x_8;
                past_9 <= past_8;
                p_above_bits_9 <= p_above_bits_8;
                t_9 <= t_8;
                num_9 <= num_8;
                from_4_9 <= from_4_8;
                from_2_9 <= from_2_8;
                from_1_bits_9 <= from_1_bits_8;
                seed_9 <= seed_8;
                fall_9 <= fall_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: y_exact, y, inverse
    -- UQ1.13: x - t = x (1 - p)
    y_exact_9 <= shift_left(resize(x_9, 14), 1) - resize(t_9, 14);
    -- UQ1.12: rounded down to the output's bits
    y_cut_9 <= y_exact_9(13 downto 1);
    -- UQ1.12: y, 0 where the lobe has ended
    y_9 <= (others => '0') when p_above_bits_9 = '1' else y_cut_9;
    -- UQ0.16: 1/m = seed - slope d
    inverse_9 <= seed_9 - resize(fall_9, 16);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                past_10 <= past_9;
                y_10 <= y_9;
                num_10 <= num_9;
                from_4_10 <= from_4_9;
                from_2_10 <= from_2_9;
                from_1_bits_10 <= from_1_bits_9;
                inverse_10 <= inverse_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: product
    -- UQ0.28: num / m
    product_10 <= num_10 * inverse_10;
    -- UQ0.13: num / m, rounded down
    scaled_10 <= product_10(27 downto 15);
    -- UQ-4.17: as often halved
    scaled_4_moved_10 <= scaled_10;
    -- UQ-4.13: rounded down
    scaled_4_low_10 <= scaled_4_moved_10(12 downto 4);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                past_11 <= past_10;
                y_11 <= y_10;
                from_4_11 <= from_4_10;
                from_2_11 <= from_2_10;
                from_1_bits_11 <= from_1_bits_10;
                scaled_11 <= scaled_10;
                scaled_4_low_11 <= scaled_4_low_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: scaled_4, scaled_2, scaled_1
    -- UQ0.13: halved as often as the denominator was
    scaled_4_11 <= resize(scaled_4_low_11, 13) when from_4_11 = '1' else scaled_11;
    -- UQ-2.15: as often halved
    scaled_2_moved_11 <= scaled_4_11;
    -- UQ-2.13: rounded down
    scaled_2_low_11 <= scaled_2_moved_11(12 downto 2);
    -- UQ0.13: halved as often as the denominator was
    scaled_2_11 <= resize(scaled_2_low_11, 13) when from_2_11 = '1' else scaled_4_11;
    -- UQ-1.14: as often halved
    scaled_1_moved_11 <= scaled_2_11;
    -- UQ-1.13: rounded down
    scaled_1_low_11 <= scaled_1_moved_11(12 downto 1);
    -- UQ0.13: halved as often as the denominator was
    scaled_1_11 <= resize(scaled_1_low_11, 13) when from_1_bits_11 = '1' else scaled_2_11;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                past_12 <= past_11;
                y_12 <= y_11;
                scaled_1_12 <= scaled_1_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: quotient_half, either
    -- UQ0.13: plus half an output ulp
    quotient_half_12 <= scaled_1_12 + to_unsigned(1, 13);
    -- UQ0.12: num / den, rounded to nearest
    quotient_12 <= quotient_half_12(12 downto 1);
    -- UQ1.12: the tail past the cut, the cubic up to it
    either_12 <= resize(quotient_12, 13) when past_12 = '1' else y_12;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                either_13 <= either_12;
            end if;
        end if;
    end process;

    out_valid <= valid(13);
    out_spec  <= either_13;

end architecture rtl;
