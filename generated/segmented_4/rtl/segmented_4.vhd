-- segmented_4: specular lobe x^n as x(c - u(A - a u)) in 4 segments, n = 1 to 63, minimax
--
-- Made by: brdfgen generate core.toml
-- Spec f7893d2af80957a7. Generated; the core is yours to use under any terms.
--
--   in_n      UQ6.0   shininess, 1 to 63; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 16 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.653..+0.750.
--   measured -0.588..+0.740 over all 258111 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.157 % absolute, 0.157 % where x^n >= 1/2, 0.278 % relative there.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity segmented_4 is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ6.0: shininess, 1 to 63; outside: the nearest end
        in_n      : in  unsigned(5 downto 0);
        -- Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(13 downto 0);
        -- out_spec is a result: in_valid, 16 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.12: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(12 downto 0)
    );
end entity segmented_4;

architecture rtl of segmented_4 is
    -- ===== The memory scale
    -- Bits 11 downto 0 of each word.
    type scale_words_0_t is array (63 downto 0) of
        std_logic_vector(11 downto 0);
    constant SCALE_WORDS_0 : scale_words_0_t := (
        63 => x"fc5",
        62 => x"f85",
        61 => x"f45",
        60 => x"f05",
        59 => x"ec5",
        58 => x"e85",
        57 => x"e45",
        56 => x"e05",
        55 => x"dc5",
        54 => x"d85",
        53 => x"d45",
        52 => x"d05",
        51 => x"cc5",
        50 => x"c85",
        49 => x"c45",
        48 => x"c05",
        47 => x"bc5",
        46 => x"b85",
        45 => x"b45",
        44 => x"b05",
        43 => x"ac5",
        42 => x"a85",
        41 => x"a45",
        40 => x"a05",
        39 => x"9c5",
        38 => x"985",
        37 => x"945",
        36 => x"905",
        35 => x"8c5",
        34 => x"885",
        33 => x"845",
        32 => x"805",
        31 => x"f84",
        30 => x"f04",
        29 => x"e84",
        28 => x"e04",
        27 => x"d84",
        26 => x"d04",
        25 => x"c84",
        24 => x"c04",
        23 => x"b84",
        22 => x"b04",
        21 => x"a84",
        20 => x"a04",
        19 => x"984",
        18 => x"904",
        17 => x"884",
        16 => x"804",
        15 => x"f03",
        14 => x"e03",
        13 => x"d03",
        12 => x"c03",
        11 => x"b03",
        10 => x"a03",
        9 => x"903",
        8 => x"803",
        7 => x"e02",
        6 => x"c02",
        5 => x"a02",
        4 => x"802",
        3 => x"c01",
        2 => x"801",
        1 => x"800",
        0 => x"800"
    );
    signal scale_1 : std_logic_vector(11 downto 0) := (others => '0');

    -- ===== The memory rom
    -- Bits 31 downto 0 of each word.
    type rom_words_0_t is array (255 downto 0) of
        std_logic_vector(31 downto 0);
    constant ROM_WORDS_0 : rom_words_0_t := (
        255 => x"1030c0b2",
        254 => x"4ed3858d",
        253 => x"a75d9224",
        252 => x"eedbe9cd",
        251 => x"0fd300ab",
        250 => x"4d4d0559",
        249 => x"a4755184",
        248 => x"eaf3a867",
        247 => x"0f9bc0a6",
        246 => x"4c32c531",
        245 => x"a1a310eb",
        244 => x"e70ea70a",
        243 => x"0f4d40a0",
        242 => x"4ad8c503",
        241 => x"9edd105a",
        240 => x"e32c65b7",
        239 => x"0f27009c",
        238 => x"49db84df",
        237 => x"9c2a0fcc",
        236 => x"df4be46c",
        235 => x"0ee8c097",
        234 => x"48a804b6",
        233 => x"9984cf44",
        232 => x"db6fe32a",
        231 => x"0eaa8092",
        230 => x"4777c48e",
        229 => x"96e80ec1",
        228 => x"d795a1ed",
        227 => x"0e6a008d",
        226 => x"46618469",
        225 => x"95044e5d",
        224 => x"d3fe20ea",
        223 => x"0e100087",
        222 => x"44b80438",
        221 => x"92160dce",
        220 => x"d0261fba",
        219 => x"0de2c083",
        218 => x"43cb4418",
        217 => x"8f084d3f",
        216 => x"cc13de64",
        215 => x"0d9b807e",
        214 => x"42a2c3f3",
        213 => x"8ca60cce",
        212 => x"c8429d45",
        211 => x"0d6ac07a",
        210 => x"4171c3cf",
        209 => x"89eccc4f",
        208 => x"c4731c2c",
        207 => x"0d204075",
        206 => x"4024c3a9",
        205 => x"8748cbd5",
        204 => x"c0a6db1c",
        203 => x"0cd1c070",
        202 => x"3eac0380",
        201 => x"84b44b61",
        200 => x"bcdada11",
        199 => x"0c9a406c",
        198 => x"3dd18364",
        197 => x"827c4aff",
        196 => x"b90fd90c",
        195 => x"0c480067",
        194 => x"3c854340",
        193 => x"7f8a4a84",
        192 => x"b51817ed",
        191 => x"0c0c0063",
        190 => x"3b0f031a",
        189 => x"7ccf8a10",
        188 => x"b151d6f6",
        187 => x"0bcec05f",
        186 => x"39f182fb",
        185 => x"7a7549ae",
        184 => x"ad8cd605",
        183 => x"0b8ec05b",
        182 => x"38e782de",
        181 => x"77b60941",
        180 => x"a9a09501",
        179 => x"0b4c4057",
        178 => x"378bc2bc",
        177 => x"753008dc",
        176 => x"a5df941d",
        175 => x"0b074053",
        174 => x"3641829c",
        173 => x"725c086f",
        172 => x"a1f81327",
        171 => x"0add4050",
        170 => x"3519827f",
        169 => x"6f98c808",
        168 => x"9e18523b",
        167 => x"0a93804c",
        166 => x"33da4261",
        165 => x"6ce987a6",
        164 => x"9a399156",
        163 => x"0a460048",
        162 => x"32af4245",
        161 => x"6aa50753",
        160 => x"967f908a",
        159 => x"0a14c045",
        158 => x"31754229",
        157 => x"67e586f3",
        156 => x"92a70fb4",
        155 => x"09c28041",
        154 => x"3032820d",
        153 => x"64f90691",
        152 => x"8eb48ed6",
        151 => x"098cc03e",
        150 => x"2f0501f3",
        149 => x"6262463b",
        148 => x"8ae28e0c",
        147 => x"0954403b",
        146 => x"2ddf81da",
        145 => x"5fec05eb",
        144 => x"87138d4c",
        143 => x"0918c038",
        142 => x"2c8941bf",
        141 => x"5d54859a",
        140 => x"83458c91",
        139 => x"08b7c034",
        138 => x"2b4941a6",
        137 => x"5a980546",
        136 => x"7f644bd3",
        135 => x"08754031",
        134 => x"2a22c18f",
        133 => x"57f384f8",
        132 => x"7b880b1b",
        131 => x"0856002f",
        130 => x"28ed8178",
        129 => x"553b44aa",
        128 => x"77ae8a6b",
        127 => x"100880af",
        126 => x"4f5a8584",
        125 => x"a552518a",
        124 => x"e7b4670b",
        123 => x"0f85c0a4",
        122 => x"4cd5c52b",
        121 => x"a00ed06c",
        120 => x"e0112485",
        119 => x"0f0f409a",
        118 => x"4a8004d9",
        117 => x"9aa90f55",
        116 => x"d85361fe",
        115 => x"0e914090",
        114 => x"480a4487",
        113 => x"95964e53",
        112 => x"d0bb9fae",
        111 => x"0df68085",
        110 => x"459c8438",
        109 => x"901c8d4a",
        108 => x"c8f19d4c",
        107 => x"0d7f807c",
        106 => x"431c83eb",
        105 => x"8acc0c50",
        104 => x"c14d5b1e",
        103 => x"0d014073",
        102 => x"409883a0",
        101 => x"856f4b61",
        100 => x"b99858f9",
        99 => x"0c7a006a",
        98 => x"3e4b035c",
        97 => x"80560a82",
        96 => x"b1ecd6f1",
        95 => x"0be94061",
        94 => x"3bd88318",
        93 => x"7b2a09aa",
        92 => x"aa46d501",
        91 => x"0b698059",
        90 => x"394902d5",
        89 => x"75bd48d2",
        88 => x"a2985324",
        87 => x"0afc8052",
        86 => x"36f8c299",
        85 => x"706f480a",
        84 => x"9ae2115a",
        83 => x"0a68004a",
        82 => x"3471425c",
        81 => x"6b34874b",
        80 => x"9337cfab",
        79 => x"09e68043",
        78 => x"31fac223",
        77 => x"65c14690",
        76 => x"8b7a0e07",
        75 => x"0959403c",
        74 => x"2f9801ee",
        73 => x"607605e3",
        72 => x"83ca0c84",
        71 => x"08e24036",
        70 => x"2d2a01bb",
        69 => x"5b38c541",
        68 => x"7c1ccb14",
        67 => x"085f0030",
        66 => x"2ac0418b",
        65 => x"55f0c4a7",
        64 => x"746dc9bc",
        63 => x"0faec0a9",
        62 => x"50970575",
        61 => x"a13f5058",
        60 => x"d977e1df",
        59 => x"0eaa4094",
        58 => x"4bc304cb",
        57 => x"96c18e3c",
        56 => x"ca1e1d34",
        55 => x"0db48081",
        54 => x"46e0c42b",
        53 => x"8c0c8c3f",
        52 => x"bab818da",
        51 => x"0c9c406e",
        50 => x"421ac398",
        49 => x"8172ca6c",
        48 => x"ab4f54d6",
        47 => x"0bae005e",
        46 => x"3d39430e",
        45 => x"76cc08bc",
        44 => x"9beb5130",
        43 => x"0a98404e",
        42 => x"38764291",
        41 => x"6c2a8732",
        40 => x"8c83cde3",
        39 => x"09b34041",
        38 => x"33b8421f",
        37 => x"618185ce",
        36 => x"7d164aed",
        35 => x"08c58035",
        34 => x"2f1401b9",
        33 => x"56e58491",
        32 => x"6dab8852",
        31 => x"101a00af",
        30 => x"54db4575",
        29 => x"985ccdde",
        28 => x"bc751836",
        27 => x"10c140a9",
        26 => x"4bff0438",
        25 => x"82db0a0c",
        24 => x"9d87508e",
        23 => x"12b640ae",
        22 => x"43e2432e",
        21 => x"6d3d46d1",
        20 => x"7e878a4d",
        19 => x"168840bf",
        18 => x"3daa825f",
        17 => x"573a0426",
        16 => x"5f640573",
        15 => x"00000000",
        14 => x"7fff8800",
        13 => x"7fffc800",
        12 => x"7fffc800",
        11 => x"00000000",
        10 => x"40000000",
        9 => x"40000000",
        8 => x"40000000",
        7 => x"00000000",
        6 => x"00000000",
        5 => x"00000000",
        4 => x"00000000",
        3 => x"00000000",
        2 => x"00000000",
        1 => x"00000000",
        0 => x"00000000"
    );
    -- Bits 46 downto 32 of each word.
    type rom_words_1_t is array (255 downto 0) of
        std_logic_vector(15 downto 0);
    constant ROM_WORDS_1 : rom_words_1_t := (
        255 => x"0be4",
        254 => x"2553",
        253 => x"38f8",
        252 => x"3fe8",
        251 => x"0bd3",
        250 => x"253e",
        249 => x"38ef",
        248 => x"3fe7",
        247 => x"0bd9",
        246 => x"2549",
        245 => x"38ea",
        244 => x"3fe7",
        243 => x"0bd0",
        242 => x"2541",
        241 => x"38e5",
        240 => x"3fe8",
        239 => x"0be1",
        238 => x"2556",
        237 => x"38e5",
        236 => x"3fe7",
        235 => x"0be2",
        234 => x"255b",
        233 => x"38e6",
        232 => x"3fe7",
        231 => x"0be4",
        230 => x"2561",
        229 => x"38e7",
        228 => x"3fe8",
        227 => x"0be4",
        226 => x"2571",
        225 => x"390b",
        224 => x"3fe9",
        223 => x"0bd3",
        222 => x"254c",
        221 => x"3901",
        220 => x"3fe9",
        219 => x"0be1",
        218 => x"256a",
        217 => x"38ee",
        216 => x"3fe8",
        215 => x"0bdc",
        214 => x"2576",
        213 => x"38fa",
        212 => x"3fe8",
        211 => x"0be8",
        210 => x"257a",
        209 => x"38fa",
        208 => x"3fe7",
        207 => x"0be2",
        206 => x"2576",
        205 => x"38fe",
        204 => x"3fe9",
        203 => x"0bd7",
        202 => x"2561",
        201 => x"3904",
        200 => x"3fe9",
        199 => x"0bde",
        198 => x"258c",
        197 => x"391b",
        196 => x"3fe8",
        195 => x"0bd0",
        194 => x"2589",
        193 => x"390b",
        192 => x"3fe8",
        191 => x"0bd4",
        190 => x"2573",
        189 => x"390c",
        188 => x"3fe8",
        187 => x"0bd6",
        186 => x"2582",
        185 => x"391e",
        184 => x"3fe8",
        183 => x"0bd7",
        182 => x"259c",
        181 => x"391a",
        180 => x"3fe9",
        179 => x"0bd5",
        178 => x"2591",
        177 => x"3926",
        176 => x"3fea",
        175 => x"0bd1",
        174 => x"258e",
        173 => x"3920",
        172 => x"3fe9",
        171 => x"0be5",
        170 => x"259b",
        169 => x"391b",
        168 => x"3fe9",
        167 => x"0bdd",
        166 => x"259e",
        165 => x"391c",
        164 => x"3fe8",
        163 => x"0bd1",
        162 => x"25ac",
        161 => x"3937",
        160 => x"3fe9",
        159 => x"0bdf",
        158 => x"25b0",
        157 => x"3935",
        156 => x"3fea",
        155 => x"0bcf",
        154 => x"25b1",
        153 => x"3926",
        152 => x"3fe8",
        151 => x"0bda",
        150 => x"25be",
        149 => x"392e",
        148 => x"3fe9",
        147 => x"0be2",
        146 => x"25d0",
        145 => x"393f",
        144 => x"3fea",
        143 => x"0be7",
        142 => x"25c8",
        141 => x"3947",
        140 => x"3fea",
        139 => x"0bc5",
        138 => x"25cc",
        137 => x"3947",
        136 => x"3fea",
        135 => x"0bc2",
        134 => x"25e0",
        133 => x"394b",
        132 => x"3fe9",
        131 => x"0be8",
        130 => x"25ea",
        129 => x"394b",
        128 => x"3fea",
        127 => x"0bd3",
        126 => x"25f1",
        125 => x"3956",
        124 => x"3fea",
        123 => x"0bd3",
        122 => x"25f5",
        121 => x"395f",
        120 => x"3fea",
        119 => x"0bd9",
        118 => x"260a",
        117 => x"3960",
        116 => x"3fea",
        115 => x"0bdb",
        114 => x"2613",
        113 => x"3972",
        112 => x"3feb",
        111 => x"0bca",
        110 => x"2623",
        109 => x"3971",
        108 => x"3fea",
        107 => x"0bd1",
        106 => x"262a",
        105 => x"397a",
        104 => x"3fea",
        103 => x"0bd2",
        102 => x"2632",
        101 => x"397d",
        100 => x"3fea",
        99 => x"0bcd",
        98 => x"2652",
        97 => x"3992",
        96 => x"3feb",
        95 => x"0bc0",
        94 => x"2664",
        93 => x"39a4",
        92 => x"3fec",
        91 => x"0bc0",
        90 => x"2669",
        89 => x"39aa",
        88 => x"3feb",
        87 => x"0bd1",
        86 => x"268d",
        85 => x"39b3",
        84 => x"3fec",
        83 => x"0bbe",
        82 => x"269a",
        81 => x"39c8",
        80 => x"3fec",
        79 => x"0bbc",
        78 => x"26b1",
        77 => x"39cd",
        76 => x"3fec",
        75 => x"0bad",
        74 => x"26d5",
        73 => x"39df",
        72 => x"3fec",
        71 => x"0bb5",
        70 => x"26f8",
        69 => x"39f6",
        68 => x"3fed",
        67 => x"0baf",
        66 => x"2721",
        65 => x"3a0e",
        64 => x"3fed",
        63 => x"0ba4",
        62 => x"2748",
        61 => x"3a24",
        60 => x"3fee",
        59 => x"0b9d",
        58 => x"277c",
        57 => x"3a47",
        56 => x"3fef",
        55 => x"0ba0",
        54 => x"27b2",
        53 => x"3a63",
        52 => x"3fef",
        51 => x"0b87",
        50 => x"27fe",
        49 => x"3a89",
        48 => x"3ff0",
        47 => x"0b8e",
        46 => x"284a",
        45 => x"3ab4",
        44 => x"3ff1",
        43 => x"0b6f",
        42 => x"28b5",
        41 => x"3aec",
        40 => x"3ff1",
        39 => x"0b7a",
        38 => x"2939",
        37 => x"3b2d",
        36 => x"3ff2",
        35 => x"0b7a",
        34 => x"29ed",
        33 => x"3b83",
        32 => x"3ff3",
        31 => x"0bb1",
        30 => x"2ad2",
        29 => x"3bea",
        28 => x"3ff5",
        27 => x"0d36",
        26 => x"2c2d",
        25 => x"3c76",
        24 => x"3ff7",
        23 => x"1015",
        22 => x"2e67",
        21 => x"3d3a",
        20 => x"3ffa",
        19 => x"1546",
        18 => x"32c4",
        17 => x"3e58",
        16 => x"3ffc",
        15 => x"0000",
        14 => x"3fff",
        13 => x"3fff",
        12 => x"3fff",
        11 => x"0000",
        10 => x"4000",
        9 => x"4000",
        8 => x"4000",
        7 => x"0000",
        6 => x"0000",
        5 => x"4000",
        4 => x"4000",
        3 => x"0000",
        2 => x"0000",
        1 => x"4000",
        0 => x"4000"
    );
    signal rom_8 : std_logic_vector(46 downto 0) := (others => '0');

    signal valid : std_logic_vector(16 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal address_of_parts_0 : unsigned(5 downto 0) := (others => '0');
    signal x_1 : unsigned(12 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal address_of_parts_1 : unsigned(5 downto 0) := (others => '0');
    signal m_1 : unsigned(8 downto 0) := (others => '0');
    signal k_1 : unsigned(2 downto 0) := (others => '0');
    signal x_2 : unsigned(12 downto 0) := (others => '0');
    signal u_2 : unsigned(12 downto 0) := (others => '0');
    signal m_2 : unsigned(8 downto 0) := (others => '0');
    signal k_2 : unsigned(2 downto 0) := (others => '0');
    signal address_of_parts_2 : unsigned(5 downto 0) := (others => '0');
    signal u_scaled_2 : unsigned(17 downto 0) := (others => '0');
    signal beyond_bits_2 : unsigned(1 downto 0) := (others => '0');
    signal beyond_2 : std_logic := '0';
    signal v_rough_2 : unsigned(13 downto 0) := (others => '0');
    signal v_2 : unsigned(14 downto 0) := (others => '0');
    signal x_3 : unsigned(12 downto 0) := (others => '0');
    signal m_3 : unsigned(8 downto 0) := (others => '0');
    signal beyond_3 : std_logic := '0';
    signal v_rough_3 : unsigned(13 downto 0) := (others => '0');
    signal address_of_parts_3 : unsigned(5 downto 0) := (others => '0');
    signal v_3 : unsigned(14 downto 0) := (others => '0');
    signal s_exact_3 : unsigned(22 downto 0) := (others => '0');
    signal s_3 : unsigned(13 downto 0) := (others => '0');
    signal x_4 : unsigned(12 downto 0) := (others => '0');
    signal beyond_4 : std_logic := '0';
    signal s_4 : unsigned(13 downto 0) := (others => '0');
    signal address_of_parts_4 : unsigned(5 downto 0) := (others => '0');
    signal v_4 : unsigned(14 downto 0) := (others => '0');
    signal past_4 : std_logic := '0';
    signal segment_bit_1_4 : std_logic := '0';
    signal bound_1_0_0_4 : unsigned(13 downto 0) := (others => '0');
    signal segment_part_1_4 : unsigned(0 downto 0) := (others => '0');
    signal zero_4 : std_logic := '0';
    signal x_5 : unsigned(12 downto 0) := (others => '0');
    signal s_5 : unsigned(13 downto 0) := (others => '0');
    signal bound_1_0_0_5 : unsigned(13 downto 0) := (others => '0');
    signal segment_part_1_5 : unsigned(0 downto 0) := (others => '0');
    signal address_of_parts_5 : unsigned(5 downto 0) := (others => '0');
    signal v_5 : unsigned(14 downto 0) := (others => '0');
    signal zero_5 : std_logic := '0';
    signal segment_bit_0_5 : std_logic := '0';
    signal segment_part_0_5 : unsigned(0 downto 0) := (others => '0');
    signal segment_1_5 : unsigned(1 downto 0) := (others => '0');
    signal x_6 : unsigned(12 downto 0) := (others => '0');
    signal segment_1_6 : unsigned(1 downto 0) := (others => '0');
    signal address_of_parts_6 : unsigned(5 downto 0) := (others => '0');
    signal v_6 : unsigned(14 downto 0) := (others => '0');
    signal zero_6 : std_logic := '0';
    signal part_address_6 : unsigned(7 downto 0) := (others => '0');
    signal x_7 : unsigned(12 downto 0) := (others => '0');
    signal part_address_7 : unsigned(7 downto 0) := (others => '0');
    signal v_7 : unsigned(14 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal x_8 : unsigned(12 downto 0) := (others => '0');
    signal v_8 : unsigned(14 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal c_8 : unsigned(14 downto 0) := (others => '0');
    signal big_a_8 : unsigned(17 downto 0) := (others => '0');
    signal a_8 : unsigned(13 downto 0) := (others => '0');
    signal x_9 : unsigned(12 downto 0) := (others => '0');
    signal c_9 : unsigned(14 downto 0) := (others => '0');
    signal big_a_9 : unsigned(17 downto 0) := (others => '0');
    signal a_9 : unsigned(13 downto 0) := (others => '0');
    signal v_9 : unsigned(14 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal x_10 : unsigned(12 downto 0) := (others => '0');
    signal c_10 : unsigned(14 downto 0) := (others => '0');
    signal big_a_10 : unsigned(17 downto 0) := (others => '0');
    signal a_10 : unsigned(13 downto 0) := (others => '0');
    signal v_10 : unsigned(14 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal av_10 : unsigned(28 downto 0) := (others => '0');
    signal r_10 : unsigned(16 downto 0) := (others => '0');
    signal x_11 : unsigned(12 downto 0) := (others => '0');
    signal c_11 : unsigned(14 downto 0) := (others => '0');
    signal big_a_11 : unsigned(17 downto 0) := (others => '0');
    signal v_11 : unsigned(14 downto 0) := (others => '0');
    signal r_11 : unsigned(16 downto 0) := (others => '0');
    signal zero_11 : std_logic := '0';
    signal q_11 : unsigned(17 downto 0) := (others => '0');
    signal x_12 : unsigned(12 downto 0) := (others => '0');
    signal c_12 : unsigned(14 downto 0) := (others => '0');
    signal v_12 : unsigned(14 downto 0) := (others => '0');
    signal q_12 : unsigned(17 downto 0) := (others => '0');
    signal zero_12 : std_logic := '0';
    signal vq_12 : unsigned(32 downto 0) := (others => '0');
    signal m_12 : unsigned(13 downto 0) := (others => '0');
    signal x_13 : unsigned(12 downto 0) := (others => '0');
    signal c_13 : unsigned(14 downto 0) := (others => '0');
    signal m_13 : unsigned(13 downto 0) := (others => '0');
    signal zero_13 : std_logic := '0';
    signal d_13 : signed(15 downto 0) := (others => '0');
    signal d_positive_13 : unsigned(14 downto 0) := (others => '0');
    signal x_14 : unsigned(12 downto 0) := (others => '0');
    signal d_positive_14 : unsigned(14 downto 0) := (others => '0');
    signal zero_14 : std_logic := '0';
    signal xd_14 : unsigned(27 downto 0) := (others => '0');
    signal xd_15 : unsigned(27 downto 0) := (others => '0');
    signal zero_15 : std_logic := '0';
    signal y_half_15 : unsigned(26 downto 0) := (others => '0');
    signal y_cut_15 : unsigned(12 downto 0) := (others => '0');
    signal y_15 : unsigned(12 downto 0) := (others => '0');
    signal y_16 : unsigned(12 downto 0) := (others => '0');

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

    -- ===== Stage 0: read scale, x, u
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.12: u = 1 - x, the versine
    u_0 <= to_unsigned(4096, 13) - x_0;
    -- UQ8.-2: the address of the row's first part
    address_of_parts_0 <= in_n;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                scale_1(11 downto 0) <=
                    SCALE_WORDS_0(to_integer(in_n))(11 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_1 <= x_0;
                u_1 <= u_0;
                address_of_parts_1 <= address_of_parts_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: registers only
    -- UQ0.9: n 2^-k, for the segment
    m_1 <= unsigned(scale_1(11 downto 3));
    -- UQ3.0: shift of the versine
    k_1 <= unsigned(scale_1(2 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_2 <= x_1;
                u_2 <= u_1;
                m_2 <= m_1;
                k_2 <= k_1;
                address_of_parts_2 <= address_of_parts_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: u_scaled
    -- UQ7.11: u 2^(k + 1)
    u_scaled_2 <= shift_left(resize(u_2, 18), to_integer(k_2));
    -- UQ7.-5: u 2^k is past every segment
    beyond_bits_2 <= u_scaled_2(17 downto 16);
    -- UQ1.0: u 2^k is past every segment
    beyond_2 <= '1' when beyond_bits_2 /= 0 else '0';
    -- UQ5.9: the leading bits of u 2^k
    v_rough_2 <= u_scaled_2(15 downto 2);
    -- UQ4.11: v = u 2^k, rounded down; wraps past the last segment
    v_2 <= u_scaled_2(14 downto 0);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_3 <= x_2;
                m_3 <= m_2;
                beyond_3 <= beyond_2;
                v_rough_3 <= v_rough_2;
                address_of_parts_3 <= address_of_parts_2;
                v_3 <= v_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: s_exact
    -- UQ5.18: n u, roughly
    s_exact_3 <= v_rough_3 * m_3;
    -- UQ5.9: n u, roughly
    s_3 <= s_exact_3(22 downto 9);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                beyond_4 <= beyond_3;
                s_4 <= s_3;
                address_of_parts_4 <= address_of_parts_3;
                v_4 <= v_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: past, segment_bit_1, bound_1_0_0
    -- UQ1.0: past the last segment
    past_4 <= '1' when s_4 > to_unsigned(3187, 14) else '0';
    -- UQ1.0: a bit of the segment
    segment_bit_1_4 <= '1' when s_4 > to_unsigned(893, 14) else '0';
    -- UQ5.9: the next bound to compare with
    bound_1_0_0_4 <= to_unsigned(1650, 14) when segment_bit_1_4 = '1' else to_unsigned(384, 14);
    -- UQ2.-1: the bit at its place
    segment_part_1_4 <= unsigned'("" & segment_bit_1_4);
    -- UQ1.0: the result is 0
    zero_4 <= beyond_4 or past_4;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                s_5 <= s_4;
                bound_1_0_0_5 <= bound_1_0_0_4;
                segment_part_1_5 <= segment_part_1_4;
                address_of_parts_5 <= address_of_parts_4;
                v_5 <= v_4;
                zero_5 <= zero_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: segment_bit_0, segment_1
    -- UQ1.0: a bit of the segment
    segment_bit_0_5 <= '1' when s_5 > bound_1_0_0_5 else '0';
    -- UQ1.0: the bit at its place
    segment_part_0_5 <= unsigned'("" & segment_bit_0_5);
    -- UQ2.0: the number of the segment
    segment_1_5 <= shift_left(resize(segment_part_1_5, 2), 1) + resize(segment_part_0_5, 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                segment_1_6 <= segment_1_5;
                address_of_parts_6 <= address_of_parts_5;
                v_6 <= v_5;
                zero_6 <= zero_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: part_address
    -- UQ8.0: the address of the part
    part_address_6 <= shift_left(resize(address_of_parts_6, 8), 2) + resize(segment_1_6, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                part_address_7 <= part_address_6;
                v_7 <= v_6;
                zero_7 <= zero_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: read the ROM
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_8(31 downto 0) <=
                    ROM_WORDS_0(to_integer(part_address_7))(31 downto 0);
                rom_8(46 downto 32) <=
                    ROM_WORDS_1(to_integer(part_address_7))(14 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                v_8 <= v_7;
                zero_8 <= zero_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: registers only
    -- UQ1.14: the coefficient c
    c_8 <= unsigned(rom_8(46 downto 32));
    -- UQ0.18: the coefficient A, times 2^-k
    big_a_8 <= unsigned(rom_8(31 downto 14));
    -- UQ-1.15: the coefficient a, times 4^-k
    a_8 <= unsigned(rom_8(13 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_9 <= x_8;
                c_9 <= c_8;
                big_a_9 <= big_a_8;
                a_9 <= a_8;
                v_9 <= v_8;
                zero_9 <= zero_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_10 <= x_9;
                c_10 <= c_9;
                big_a_10 <= big_a_9;
                a_10 <= a_9;
                v_10 <= v_9;
                zero_10 <= zero_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: av
    -- UQ3.26: (a 4^-k) v
    av_10 <= a_10 * v_10;
    -- UQ-1.18: (a 4^-k) v, rounded down
    r_10 <= av_10(24 downto 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_11 <= x_10;
                c_11 <= c_10;
                big_a_11 <= big_a_10;
                v_11 <= v_10;
                r_11 <= r_10;
                zero_11 <= zero_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: q
    -- UQ0.18: q = (A - a u) 2^-k
    q_11 <= big_a_11 - resize(r_11, 18);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_12 <= x_11;
                c_12 <= c_11;
                v_12 <= v_11;
                q_12 <= q_11;
                zero_12 <= zero_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: vq
    -- UQ4.29: u (A - a u) = v q
    vq_12 <= v_12 * q_12;
    -- UQ0.14: u (A - a u), rounded down
    m_12 <= vq_12(28 downto 15);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_13 <= x_12;
                c_13 <= c_12;
                m_13 <= m_12;
                zero_13 <= zero_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: d, d_positive
    -- Q1.14: d = c - u (A - a u)
    d_13 <= signed(resize(c_13, 16)) - signed(resize(m_13, 16));
    -- UQ1.14: d, at least 0
    d_positive_13 <= (others => '0') when d_13(15) = '1' else
        unsigned(d_13(14 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_14 <= x_13;
                d_positive_14 <= d_positive_13;
                zero_14 <= zero_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: xd
    -- UQ2.26: x d
    xd_14 <= x_14 * d_positive_14;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                xd_15 <= xd_14;
                zero_15 <= zero_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: y_half, y
    -- UQ1.26: plus half an output ulp: the result is rounded to nearest
    y_half_15 <= xd_15(26 downto 0) + to_unsigned(8192, 27);
    -- UQ1.12: rounded down to the output's bits
    y_cut_15 <= y_half_15(26 downto 14);
    -- UQ1.12: y, 0 past the last segment
    y_15 <= (others => '0') when zero_15 = '1' else y_cut_15;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_16 <= y_15;
            end if;
        end if;
    end process;

    out_valid <= valid(16);
    out_spec  <= y_16;

end architecture rtl;
