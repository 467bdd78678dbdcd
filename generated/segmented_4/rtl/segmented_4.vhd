-- segmented_4: specular lobe x^n as x(c - u(A - a u)) in 4 segments, n = 1 to 63, minimax
--
-- Made by: brdfgen generate core.toml
-- Spec f7893d2af80957a7. Generated; the core is yours to use under any terms.
--
--   in_n      UQ6.0   shininess, 1 to 63; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 17 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.824..+0.750.
--   measured -0.679..+0.739 over all 258111 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   0.173 % absolute, 0.171 % where x^n >= 1/2, 0.312 % relative there.
-- As the cosine rises, the output never falls: proved by running all 258048 pairs of neighbouring
--   inputs.

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
        -- out_spec is a result: in_valid, 17 enabled clocks later
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
        255 => x"0c5900fd",
        254 => x"48b909e5",
        253 => x"a2f5a283",
        252 => x"ee36d277",
        251 => x"0c1180f3",
        250 => x"47e709a3",
        249 => x"a0bb2193",
        248 => x"ea52cfbb",
        247 => x"0be500ed",
        246 => x"46ab8951",
        245 => x"9e03a074",
        244 => x"e6724d10",
        243 => x"0bbd80e5",
        242 => x"45c98910",
        241 => x"9b5c9f5f",
        240 => x"e294ca77",
        239 => x"0b8500dd",
        238 => x"443908b1",
        237 => x"99059e63",
        236 => x"df044861",
        235 => x"0b4d80d5",
        234 => x"4335086e",
        233 => x"96799d60",
        232 => x"db28c5de",
        231 => x"0b1c00ce",
        230 => x"41fb081f",
        229 => x"93ff1c6a",
        228 => x"d750c36c",
        227 => x"0aeb80c7",
        226 => x"411107e2",
        225 => x"918e9b7b",
        224 => x"d37bc109",
        223 => x"0abd00c0",
        222 => x"3fd90798",
        221 => x"8ebd9a6e",
        220 => x"cfa9beb6",
        219 => x"0a7d00b8",
        218 => x"3ed50758",
        217 => x"8c699990",
        216 => x"cbd7bc6e",
        215 => x"0a4880b1",
        214 => x"3d84070c",
        213 => x"892a186c",
        212 => x"c7ceb9e2",
        211 => x"0a1380ab",
        210 => x"3c4a86c6",
        209 => x"8692177e",
        208 => x"c403b7bb",
        207 => x"09f180a5",
        206 => x"3b7a8691",
        205 => x"846896bc",
        204 => x"c03ab5a1",
        203 => x"09b7009e",
        202 => x"3a3b864c",
        201 => x"81ef15e0",
        200 => x"bc74b393",
        199 => x"09888098",
        198 => x"393e8613",
        197 => x"7f85150f",
        196 => x"b8acb192",
        195 => x"09598092",
        194 => x"382305d6",
        193 => x"7cae1424",
        192 => x"b4b8af5e",
        191 => x"0928008c",
        190 => x"36d58594",
        189 => x"7a15134c",
        188 => x"b0f6ad7b",
        187 => x"08e40085",
        186 => x"35b88559",
        185 => x"77651276",
        184 => x"ad0bab67",
        183 => x"08af007f",
        182 => x"3470051a",
        181 => x"74f091b0",
        180 => x"a94d299b",
        179 => x"08778079",
        178 => x"334184e0",
        177 => x"722390dd",
        176 => x"a568a7a9",
        175 => x"084c8074",
        174 => x"322f04ab",
        173 => x"6f709014",
        172 => x"a18825cb",
        171 => x"0820006f",
        170 => x"31070474",
        169 => x"6d2e0f68",
        168 => x"9dd02422",
        167 => x"07e18069",
        166 => x"2ffc8442",
        165 => x"6aa00eb2",
        164 => x"99f52260",
        163 => x"07b10064",
        162 => x"2f098414",
        161 => x"68260e03",
        160 => x"961e20ab",
        159 => x"077f005f",
        158 => x"2dda03e0",
        157 => x"65860d4f",
        156 => x"924b1f04",
        155 => x"0749005a",
        154 => x"2ca083ac",
        153 => x"62fc0ca6",
        152 => x"8e7a9d6d",
        151 => x"07240056",
        150 => x"2b79037c",
        149 => x"60118bea",
        148 => x"8a911bc7",
        147 => x"06eb0051",
        146 => x"2a68834f",
        145 => x"5db80b55",
        144 => x"86c69a4b",
        143 => x"06ae004c",
        142 => x"29400321",
        141 => x"5b428abb",
        140 => x"82fe18df",
        139 => x"06828048",
        138 => x"282102f5",
        137 => x"589e8a1f",
        136 => x"7f219766",
        135 => x"06418043",
        134 => x"26fc02ca",
        133 => x"55f78984",
        132 => x"7b4815fc",
        131 => x"06238040",
        130 => x"25e002a1",
        129 => x"536388f4",
        128 => x"777414a2",
        127 => x"0bcf00ee",
        126 => x"499d89e9",
        125 => x"a1d421ae",
        124 => x"e745cd58",
        123 => x"0b6300de",
        122 => x"4752094a",
        121 => x"9c711f77",
        120 => x"df864824",
        119 => x"0afb00cf",
        118 => x"44f388ae",
        117 => x"97691d72",
        116 => x"d7f24362",
        115 => x"0a9a00c1",
        114 => x"42c0881e",
        113 => x"923f9b73",
        112 => x"d044bea3",
        111 => x"0a3080b3",
        110 => x"4063078c",
        109 => x"8d1d9988",
        108 => x"c89fba1d",
        107 => x"09c380a5",
        106 => x"3e078700",
        105 => x"87bd179c",
        104 => x"c0e835a8",
        103 => x"09690099",
        102 => x"3be88682",
        101 => x"82a295db",
        100 => x"b93b316f",
        99 => x"08fa008c",
        98 => x"39b70606",
        97 => x"7d99942c",
        96 => x"b196ad6d",
        95 => x"089f0081",
        94 => x"3769058b",
        93 => x"784d127d",
        92 => x"a9e7298a",
        91 => x"082f0075",
        90 => x"350b0513",
        89 => x"732910eb",
        88 => x"a242a5dd",
        87 => x"07c6006a",
        86 => x"32d404a5",
        85 => x"6dff8f6a",
        84 => x"9a942254",
        83 => x"07640060",
        82 => x"30a6043d",
        81 => x"68d60dfb",
        80 => x"92e19ef4",
        79 => x"06f88056",
        78 => x"2e5703d6",
        77 => x"63ae8c9f",
        76 => x"8b3b1bcc",
        75 => x"0697804d",
        74 => x"2c188376",
        73 => x"5e840b53",
        72 => x"839398ca",
        71 => x"063d0045",
        70 => x"29d3031a",
        69 => x"594f8a19",
        68 => x"7be195ee",
        67 => x"05dc003d",
        66 => x"27a182c5",
        65 => x"543988f4",
        64 => x"743b134a",
        63 => x"0aea80d5",
        62 => x"4abd89cd",
        61 => x"9df71f68",
        60 => x"d911c314",
        59 => x"0a2780b9",
        58 => x"4635889a",
        57 => x"93939b53",
        56 => x"c9bb39ce",
        55 => x"0959809e",
        54 => x"41b1077b",
        53 => x"89449790",
        52 => x"ba66313a",
        51 => x"08968086",
        50 => x"3d4f0675",
        49 => x"7ee9140e",
        48 => x"ab032948",
        47 => x"07d40070",
        46 => x"38d4857f",
        45 => x"748090d1",
        44 => x"9ba8a20d",
        43 => x"0702805b",
        42 => x"347904a0",
        41 => x"6a298de2",
        40 => x"8c499b84",
        39 => x"063f0049",
        38 => x"301183d3",
        37 => x"5fcd0b37",
        36 => x"7ce995a9",
        35 => x"057d0039",
        34 => x"2bc8831c",
        33 => x"556788d3",
        32 => x"6d859080",
        31 => x"096480ab",
        30 => x"4f2189e5",
        29 => x"95f59ada",
        28 => x"bc3cb00f",
        27 => x"080f8081",
        26 => x"471707af",
        25 => x"8108938a",
        24 => x"9d5e20e5",
        23 => x"08e0808e",
        22 => x"3fca05d5",
        21 => x"6bfa0d4f",
        20 => x"7e6e147e",
        19 => x"0b5000b5",
        18 => x"36c48408",
        17 => x"5694082a",
        16 => x"5f5a0add",
        15 => x"00000000",
        14 => x"7fff9000",
        13 => x"80001001",
        12 => x"7fff9000",
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
        255 => x"09aa",
        254 => x"2371",
        253 => x"3850",
        252 => x"3fe7",
        251 => x"099c",
        250 => x"2391",
        249 => x"385e",
        248 => x"3fe5",
        247 => x"0998",
        246 => x"238a",
        245 => x"3859",
        244 => x"3fe5",
        243 => x"09a6",
        242 => x"23a1",
        241 => x"3858",
        240 => x"3fe5",
        239 => x"09a0",
        238 => x"237d",
        237 => x"3868",
        236 => x"3fe7",
        235 => x"099d",
        234 => x"2387",
        233 => x"386c",
        232 => x"3fe6",
        231 => x"099b",
        230 => x"2385",
        229 => x"3871",
        228 => x"3fe6",
        227 => x"099b",
        226 => x"239b",
        225 => x"3878",
        224 => x"3fe6",
        223 => x"099f",
        222 => x"2394",
        221 => x"386f",
        220 => x"3fe7",
        219 => x"0994",
        218 => x"23a3",
        217 => x"387d",
        216 => x"3fe8",
        215 => x"0992",
        214 => x"2395",
        213 => x"385e",
        212 => x"3fe6",
        211 => x"0989",
        210 => x"238e",
        209 => x"3861",
        208 => x"3fe6",
        207 => x"099a",
        206 => x"23b3",
        205 => x"3876",
        204 => x"3fe6",
        203 => x"0991",
        202 => x"23ac",
        201 => x"3880",
        200 => x"3fe7",
        199 => x"0994",
        198 => x"23bd",
        197 => x"388b",
        196 => x"3fe6",
        195 => x"0996",
        194 => x"23c5",
        193 => x"387f",
        192 => x"3fe6",
        191 => x"0996",
        190 => x"23b5",
        189 => x"3883",
        188 => x"3fe6",
        187 => x"0986",
        186 => x"23bd",
        185 => x"387f",
        184 => x"3fe6",
        183 => x"0981",
        182 => x"23b0",
        181 => x"388b",
        180 => x"3fe8",
        179 => x"097b",
        178 => x"23ae",
        177 => x"387f",
        176 => x"3fe6",
        175 => x"0980",
        174 => x"23b8",
        173 => x"387a",
        172 => x"3fe6",
        171 => x"0984",
        170 => x"23bb",
        169 => x"3894",
        168 => x"3fe7",
        167 => x"0976",
        166 => x"23cb",
        165 => x"3897",
        164 => x"3fe7",
        163 => x"0977",
        162 => x"23e9",
        161 => x"38a2",
        160 => x"3fe6",
        159 => x"0976",
        158 => x"23e7",
        157 => x"38a4",
        156 => x"3fe8",
        155 => x"096f",
        154 => x"23e2",
        153 => x"38aa",
        152 => x"3fe8",
        151 => x"097b",
        150 => x"23e3",
        149 => x"3898",
        148 => x"3fe7",
        147 => x"0971",
        146 => x"23f5",
        145 => x"38ac",
        144 => x"3fe7",
        143 => x"0961",
        142 => x"23f8",
        141 => x"38bc",
        140 => x"3fe7",
        139 => x"0968",
        138 => x"2402",
        137 => x"38bb",
        136 => x"3fe8",
        135 => x"0954",
        134 => x"2407",
        133 => x"38bc",
        132 => x"3fe7",
        131 => x"0967",
        130 => x"2413",
        129 => x"38c1",
        128 => x"3fe8",
        127 => x"095a",
        126 => x"2426",
        125 => x"38d0",
        124 => x"3fe9",
        123 => x"0951",
        122 => x"242f",
        121 => x"38ce",
        120 => x"3fe8",
        119 => x"094a",
        118 => x"2430",
        117 => x"38db",
        116 => x"3fe8",
        115 => x"0949",
        114 => x"2442",
        113 => x"38e3",
        112 => x"3fe8",
        111 => x"093f",
        110 => x"2445",
        109 => x"38ee",
        108 => x"3fe9",
        107 => x"0934",
        106 => x"2447",
        105 => x"38ed",
        104 => x"3fe8",
        103 => x"0937",
        102 => x"2464",
        101 => x"38f7",
        100 => x"3fe9",
        99 => x"0928",
        98 => x"247b",
        97 => x"390a",
        96 => x"3fe9",
        95 => x"0929",
        94 => x"2487",
        93 => x"390f",
        92 => x"3fe9",
        91 => x"0917",
        90 => x"248d",
        89 => x"391d",
        88 => x"3fea",
        87 => x"090c",
        86 => x"24a6",
        85 => x"392b",
        84 => x"3fea",
        83 => x"0905",
        82 => x"24c7",
        81 => x"393a",
        80 => x"3fea",
        79 => x"08f4",
        78 => x"24d9",
        77 => x"394b",
        76 => x"3fea",
        75 => x"08ec",
        74 => x"24f6",
        73 => x"395e",
        72 => x"3feb",
        71 => x"08e7",
        70 => x"2513",
        69 => x"396e",
        68 => x"3feb",
        67 => x"08e0",
        66 => x"2541",
        65 => x"398e",
        64 => x"3feb",
        63 => x"08cd",
        62 => x"2568",
        61 => x"39a3",
        60 => x"3fec",
        59 => x"08bf",
        58 => x"2593",
        57 => x"39c0",
        56 => x"3fed",
        55 => x"08a8",
        54 => x"25c7",
        53 => x"39e3",
        52 => x"3fee",
        51 => x"0894",
        50 => x"2612",
        49 => x"3a0c",
        48 => x"3fee",
        47 => x"087d",
        46 => x"265e",
        45 => x"3a39",
        44 => x"3fef",
        43 => x"0852",
        42 => x"26cb",
        41 => x"3a73",
        40 => x"3ff0",
        39 => x"082e",
        38 => x"2747",
        37 => x"3abc",
        36 => x"3ff1",
        35 => x"07fe",
        34 => x"27f4",
        33 => x"3b15",
        32 => x"3ff2",
        31 => x"07b6",
        30 => x"28db",
        29 => x"3b86",
        28 => x"3ff4",
        27 => x"0778",
        26 => x"2a3a",
        25 => x"3c1a",
        24 => x"3ff6",
        23 => x"089a",
        22 => x"2c76",
        21 => x"3cef",
        20 => x"3ff9",
        19 => x"0b44",
        18 => x"2eb8",
        17 => x"3e27",
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
    signal rom_9 : std_logic_vector(46 downto 0) := (others => '0');

    signal valid : std_logic_vector(17 downto 1) := (others => '0');
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
    signal x_4 : unsigned(12 downto 0) := (others => '0');
    signal m_4 : unsigned(8 downto 0) := (others => '0');
    signal beyond_4 : std_logic := '0';
    signal v_rough_4 : unsigned(13 downto 0) := (others => '0');
    signal address_of_parts_4 : unsigned(5 downto 0) := (others => '0');
    signal v_4 : unsigned(14 downto 0) := (others => '0');
    signal s_exact_4 : unsigned(22 downto 0) := (others => '0');
    signal s_4 : unsigned(13 downto 0) := (others => '0');
    signal x_5 : unsigned(12 downto 0) := (others => '0');
    signal beyond_5 : std_logic := '0';
    signal s_5 : unsigned(13 downto 0) := (others => '0');
    signal address_of_parts_5 : unsigned(5 downto 0) := (others => '0');
    signal v_5 : unsigned(14 downto 0) := (others => '0');
    signal past_5 : std_logic := '0';
    signal segment_bit_1_5 : std_logic := '0';
    signal bound_1_0_0_5 : unsigned(13 downto 0) := (others => '0');
    signal segment_part_1_5 : unsigned(0 downto 0) := (others => '0');
    signal zero_5 : std_logic := '0';
    signal x_6 : unsigned(12 downto 0) := (others => '0');
    signal s_6 : unsigned(13 downto 0) := (others => '0');
    signal bound_1_0_0_6 : unsigned(13 downto 0) := (others => '0');
    signal segment_part_1_6 : unsigned(0 downto 0) := (others => '0');
    signal address_of_parts_6 : unsigned(5 downto 0) := (others => '0');
    signal v_6 : unsigned(14 downto 0) := (others => '0');
    signal zero_6 : std_logic := '0';
    signal segment_bit_0_6 : std_logic := '0';
    signal segment_part_0_6 : unsigned(0 downto 0) := (others => '0');
    signal segment_1_6 : unsigned(1 downto 0) := (others => '0');
    signal x_7 : unsigned(12 downto 0) := (others => '0');
    signal segment_1_7 : unsigned(1 downto 0) := (others => '0');
    signal address_of_parts_7 : unsigned(5 downto 0) := (others => '0');
    signal v_7 : unsigned(14 downto 0) := (others => '0');
    signal zero_7 : std_logic := '0';
    signal part_address_7 : unsigned(7 downto 0) := (others => '0');
    signal x_8 : unsigned(12 downto 0) := (others => '0');
    signal part_address_8 : unsigned(7 downto 0) := (others => '0');
    signal v_8 : unsigned(14 downto 0) := (others => '0');
    signal zero_8 : std_logic := '0';
    signal x_9 : unsigned(12 downto 0) := (others => '0');
    signal v_9 : unsigned(14 downto 0) := (others => '0');
    signal zero_9 : std_logic := '0';
    signal c_9 : unsigned(14 downto 0) := (others => '0');
    signal big_a_9 : unsigned(16 downto 0) := (others => '0');
    signal a_9 : unsigned(14 downto 0) := (others => '0');
    signal x_10 : unsigned(12 downto 0) := (others => '0');
    signal c_10 : unsigned(14 downto 0) := (others => '0');
    signal big_a_10 : unsigned(16 downto 0) := (others => '0');
    signal a_10 : unsigned(14 downto 0) := (others => '0');
    signal v_10 : unsigned(14 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal x_11 : unsigned(12 downto 0) := (others => '0');
    signal c_11 : unsigned(14 downto 0) := (others => '0');
    signal big_a_11 : unsigned(16 downto 0) := (others => '0');
    signal a_11 : unsigned(14 downto 0) := (others => '0');
    signal v_11 : unsigned(14 downto 0) := (others => '0');
    signal zero_11 : std_logic := '0';
    signal av_11 : unsigned(29 downto 0) := (others => '0');
    signal r_11 : unsigned(15 downto 0) := (others => '0');
    signal x_12 : unsigned(12 downto 0) := (others => '0');
    signal c_12 : unsigned(14 downto 0) := (others => '0');
    signal big_a_12 : unsigned(16 downto 0) := (others => '0');
    signal v_12 : unsigned(14 downto 0) := (others => '0');
    signal r_12 : unsigned(15 downto 0) := (others => '0');
    signal zero_12 : std_logic := '0';
    signal q_12 : unsigned(16 downto 0) := (others => '0');
    signal x_13 : unsigned(12 downto 0) := (others => '0');
    signal c_13 : unsigned(14 downto 0) := (others => '0');
    signal v_13 : unsigned(14 downto 0) := (others => '0');
    signal q_13 : unsigned(16 downto 0) := (others => '0');
    signal zero_13 : std_logic := '0';
    signal vq_13 : unsigned(31 downto 0) := (others => '0');
    signal m_13 : unsigned(13 downto 0) := (others => '0');
    signal x_14 : unsigned(12 downto 0) := (others => '0');
    signal c_14 : unsigned(14 downto 0) := (others => '0');
    signal m_14 : unsigned(13 downto 0) := (others => '0');
    signal zero_14 : std_logic := '0';
    signal d_14 : signed(15 downto 0) := (others => '0');
    signal d_positive_14 : unsigned(14 downto 0) := (others => '0');
    signal x_15 : unsigned(12 downto 0) := (others => '0');
    signal d_positive_15 : unsigned(14 downto 0) := (others => '0');
    signal zero_15 : std_logic := '0';
    signal xd_15 : unsigned(27 downto 0) := (others => '0');
    signal xd_16 : unsigned(27 downto 0) := (others => '0');
    signal zero_16 : std_logic := '0';
    signal y_half_16 : unsigned(26 downto 0) := (others => '0');
    signal y_cut_16 : unsigned(12 downto 0) := (others => '0');
    signal y_16 : unsigned(12 downto 0) := (others => '0');
    signal y_17 : unsigned(12 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(16 downto 1) & in_valid;
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

    -- ===== Stage 3: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_4 <= x_3;
                m_4 <= m_3;
                beyond_4 <= beyond_3;
                v_rough_4 <= v_rough_3;
                address_of_parts_4 <= address_of_parts_3;
                v_4 <= v_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: s_exact
    -- UQ5.18: n u, roughly
    s_exact_4 <= v_rough_4 * m_4;
    -- UQ5.9: n u, roughly
    s_4 <= s_exact_4(22 downto 9);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_5 <= x_4;
                beyond_5 <= beyond_4;
                s_5 <= s_4;
                address_of_parts_5 <= address_of_parts_4;
                v_5 <= v_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: past, segment_bit_1, bound_1_0_0
    -- UQ1.0: past the last segment
    past_5 <= '1' when s_5 > to_unsigned(3147, 14) else '0';
    -- UQ1.0: a bit of the segment
    segment_bit_1_5 <= '1' when s_5 > to_unsigned(929, 14) else '0';
    -- UQ5.9: the next bound to compare with
    bound_1_0_0_5 <= to_unsigned(1738, 14) when segment_bit_1_5 = '1' else to_unsigned(397, 14);
    -- UQ2.-1: the bit at its place
    segment_part_1_5 <= unsigned'("" & segment_bit_1_5);
    -- UQ1.0: the result is 0
    zero_5 <= beyond_5 or past_5;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_6 <= x_5;
                s_6 <= s_5;
                bound_1_0_0_6 <= bound_1_0_0_5;
                segment_part_1_6 <= segment_part_1_5;
                address_of_parts_6 <= address_of_parts_5;
                v_6 <= v_5;
                zero_6 <= zero_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: segment_bit_0, segment_1
    -- UQ1.0: a bit of the segment
    segment_bit_0_6 <= '1' when s_6 > bound_1_0_0_6 else '0';
    -- UQ1.0: the bit at its place
    segment_part_0_6 <= unsigned'("" & segment_bit_0_6);
    -- UQ2.0: the number of the segment
    segment_1_6 <= shift_left(resize(segment_part_1_6, 2), 1) + resize(segment_part_0_6, 2);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_7 <= x_6;
                segment_1_7 <= segment_1_6;
                address_of_parts_7 <= address_of_parts_6;
                v_7 <= v_6;
                zero_7 <= zero_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: part_address
    -- UQ8.0: the address of the part
    part_address_7 <= shift_left(resize(address_of_parts_7, 8), 2) + resize(segment_1_7, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_8 <= x_7;
                part_address_8 <= part_address_7;
                v_8 <= v_7;
                zero_8 <= zero_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: read the ROM
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                rom_9(31 downto 0) <=
                    ROM_WORDS_0(to_integer(part_address_8))(31 downto 0);
                rom_9(46 downto 32) <=
                    ROM_WORDS_1(to_integer(part_address_8))(14 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_9 <= x_8;
                v_9 <= v_8;
                zero_9 <= zero_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: registers only
    -- UQ1.14: the coefficient c
    c_9 <= unsigned(rom_9(46 downto 32));
    -- UQ0.17: the coefficient A, times 2^-k
    big_a_9 <= unsigned(rom_9(31 downto 15));
    -- UQ-1.16: the coefficient a, times 4^-k
    a_9 <= unsigned(rom_9(14 downto 0));
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

    -- ===== Stage 10: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_11 <= x_10;
                c_11 <= c_10;
                big_a_11 <= big_a_10;
                a_11 <= a_10;
                v_11 <= v_10;
                zero_11 <= zero_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: av
    -- UQ3.27: (a 4^-k) v
    av_11 <= a_11 * v_11;
    -- UQ-1.17: (a 4^-k) v, rounded down
    r_11 <= av_11(25 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_12 <= x_11;
                c_12 <= c_11;
                big_a_12 <= big_a_11;
                v_12 <= v_11;
                r_12 <= r_11;
                zero_12 <= zero_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: q
    -- UQ0.17: q = (A - a u) 2^-k
    q_12 <= big_a_12 - resize(r_12, 17);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_13 <= x_12;
                c_13 <= c_12;
                v_13 <= v_12;
                q_13 <= q_12;
                zero_13 <= zero_12;
            end if;
        end if;
    end process;

    -- ===== Stage 13: vq
    -- UQ4.28: u (A - a u) = v q
    vq_13 <= v_13 * q_13;
    -- UQ0.14: u (A - a u), rounded down
    m_13 <= vq_13(27 downto 14);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_14 <= x_13;
                c_14 <= c_13;
                m_14 <= m_13;
                zero_14 <= zero_13;
            end if;
        end if;
    end process;

    -- ===== Stage 14: d, d_positive
    -- Q1.14: d = c - u (A - a u)
    d_14 <= signed(resize(c_14, 16)) - signed(resize(m_14, 16));
    -- UQ1.14: d, at least 0
    d_positive_14 <= (others => '0') when d_14(15) = '1' else
        unsigned(d_14(14 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x_15 <= x_14;
                d_positive_15 <= d_positive_14;
                zero_15 <= zero_14;
            end if;
        end if;
    end process;

    -- ===== Stage 15: xd
    -- UQ2.26: x d
    xd_15 <= x_15 * d_positive_15;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                xd_16 <= xd_15;
                zero_16 <= zero_15;
            end if;
        end if;
    end process;

    -- ===== Stage 16: y_half, y
    -- UQ1.26: plus half an output ulp: the result is rounded to nearest
    y_half_16 <= xd_16(26 downto 0) + to_unsigned(8192, 27);
    -- UQ1.12: rounded down to the output's bits
    y_cut_16 <= y_half_16(26 downto 14);
    -- UQ1.12: y, 0 past the last segment
    y_16 <= (others => '0') when zero_16 = '1' else y_cut_16;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_17 <= y_16;
            end if;
        end if;
    end process;

    out_valid <= valid(17);
    out_spec  <= y_17;

end architecture rtl;
