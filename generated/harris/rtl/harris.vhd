-- harris: specular lobe x^n as 2^(-n L(x)), L and 2^-f from tables, n = 1 to 127
--
-- Made by: brdfgen generate core.toml
-- Spec c97a03138728f208. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 13 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.747..+0.740.
--   measured -0.497..+0.732 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   1.758 % absolute, 1.430 % where x^n >= 1/2, 2.766 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity harris is
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
        -- UQ1.10: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(10 downto 0)
    );
end entity harris;

architecture rtl of harris is
    -- ===== The memory log_table
    -- Bits 16 downto 0 of each word.
    type log_table_words_0_t is array (255 downto 0) of
        std_logic_vector(19 downto 0);
    constant LOG_TABLE_WORDS_0 : log_table_words_0_t := (
        255 => x"0000c",
        254 => x"0000c",
        253 => x"0000c",
        252 => x"0000c",
        251 => x"0000c",
        250 => x"0000c",
        249 => x"0000c",
        248 => x"0000c",
        247 => x"0000c",
        246 => x"0000c",
        245 => x"0000c",
        244 => x"0000c",
        243 => x"0000c",
        242 => x"0000c",
        241 => x"0000c",
        240 => x"0000c",
        239 => x"0000c",
        238 => x"0000c",
        237 => x"0000c",
        236 => x"0000c",
        235 => x"0000c",
        234 => x"0000c",
        233 => x"0000c",
        232 => x"0000c",
        231 => x"0000c",
        230 => x"0000c",
        229 => x"0000c",
        228 => x"0000c",
        227 => x"0000c",
        226 => x"0000c",
        225 => x"0000c",
        224 => x"0000c",
        223 => x"0000c",
        222 => x"0000c",
        221 => x"0000c",
        220 => x"0000c",
        219 => x"0000c",
        218 => x"0000c",
        217 => x"0000c",
        216 => x"0000c",
        215 => x"0000c",
        214 => x"0000c",
        213 => x"0000c",
        212 => x"0000c",
        211 => x"0000c",
        210 => x"0000c",
        209 => x"0000c",
        208 => x"0000c",
        207 => x"0000c",
        206 => x"0000c",
        205 => x"0000c",
        204 => x"0000c",
        203 => x"0000c",
        202 => x"0000c",
        201 => x"0000c",
        200 => x"0000c",
        199 => x"0000c",
        198 => x"0000c",
        197 => x"0000c",
        196 => x"0000c",
        195 => x"0000c",
        194 => x"0000c",
        193 => x"0000c",
        192 => x"0000c",
        191 => x"0000c",
        190 => x"0000c",
        189 => x"0000c",
        188 => x"0000c",
        187 => x"0000c",
        186 => x"0000c",
        185 => x"0000c",
        184 => x"0000c",
        183 => x"0000c",
        182 => x"0000c",
        181 => x"0000c",
        180 => x"0000c",
        179 => x"0000c",
        178 => x"0000c",
        177 => x"0000c",
        176 => x"00006",
        175 => x"00017",
        174 => x"00017",
        173 => x"00017",
        172 => x"00017",
        171 => x"00017",
        170 => x"00017",
        169 => x"00017",
        168 => x"00011",
        167 => x"00011",
        166 => x"00011",
        165 => x"00011",
        164 => x"00011",
        163 => x"00011",
        162 => x"00011",
        161 => x"00011",
        160 => x"0000c",
        159 => x"0002e",
        158 => x"0002e",
        157 => x"0002e",
        156 => x"00028",
        155 => x"00028",
        154 => x"00028",
        153 => x"00028",
        152 => x"00023",
        151 => x"00023",
        150 => x"00023",
        149 => x"00023",
        148 => x"0001d",
        147 => x"0001d",
        146 => x"0001d",
        145 => x"0001d",
        144 => x"00017",
        143 => x"0005d",
        142 => x"00057",
        141 => x"00057",
        140 => x"00051",
        139 => x"00051",
        138 => x"0004b",
        137 => x"0004b",
        136 => x"00045",
        135 => x"00045",
        134 => x"00040",
        133 => x"00040",
        132 => x"0003a",
        131 => x"0003a",
        130 => x"00034",
        129 => x"00034",
        128 => x"0002e",
        127 => x"000b4",
        126 => x"000ae",
        125 => x"000a8",
        124 => x"000a2",
        123 => x"0009c",
        122 => x"00097",
        121 => x"00091",
        120 => x"0008b",
        119 => x"00085",
        118 => x"0007f",
        117 => x"00079",
        116 => x"00074",
        115 => x"0006e",
        114 => x"00068",
        113 => x"00062",
        112 => x"0005d",
        111 => x"0016b",
        110 => x"00160",
        109 => x"00154",
        108 => x"00148",
        107 => x"0013d",
        106 => x"00131",
        105 => x"00125",
        104 => x"0011a",
        103 => x"0010e",
        102 => x"00102",
        101 => x"000f7",
        100 => x"000eb",
        99 => x"000df",
        98 => x"000d4",
        97 => x"000c8",
        96 => x"000bc",
        95 => x"002e0",
        94 => x"002c8",
        93 => x"002b0",
        92 => x"00298",
        91 => x"00281",
        90 => x"00269",
        89 => x"00251",
        88 => x"00239",
        87 => x"00222",
        86 => x"0020a",
        85 => x"001f3",
        84 => x"001db",
        83 => x"001c4",
        82 => x"001ac",
        81 => x"00195",
        80 => x"0017d",
        79 => x"005da",
        78 => x"005a9",
        77 => x"00578",
        76 => x"00547",
        75 => x"00516",
        74 => x"004e5",
        73 => x"004b5",
        72 => x"00484",
        71 => x"00454",
        70 => x"00423",
        69 => x"003f3",
        68 => x"003c3",
        67 => x"00393",
        66 => x"00363",
        65 => x"00333",
        64 => x"00303",
        63 => x"00c1c",
        62 => x"00bb3",
        61 => x"00b4b",
        60 => x"00ae3",
        59 => x"00a7b",
        58 => x"00a14",
        57 => x"009ad",
        56 => x"00947",
        55 => x"008e1",
        54 => x"0087b",
        53 => x"00816",
        52 => x"007b2",
        51 => x"0074e",
        50 => x"006ea",
        49 => x"00687",
        48 => x"00624",
        47 => x"01a11",
        46 => x"0191e",
        45 => x"0182d",
        44 => x"0173e",
        43 => x"01651",
        42 => x"01567",
        41 => x"01480",
        40 => x"0139a",
        39 => x"012b7",
        38 => x"011d6",
        37 => x"010f7",
        36 => x"0101a",
        35 => x"00f3f",
        34 => x"00e67",
        33 => x"00d90",
        32 => x"00cbb",
        31 => x"03e8c",
        30 => x"03bc0",
        29 => x"03909",
        28 => x"03665",
        27 => x"033d5",
        26 => x"03156",
        25 => x"02ee8",
        24 => x"02c8a",
        23 => x"02a3b",
        22 => x"027fb",
        21 => x"025c8",
        20 => x"023a3",
        19 => x"02189",
        18 => x"01f7c",
        17 => x"01d7a",
        16 => x"01b84",
        15 => x"17f48",
        14 => x"11a52",
        13 => x"0eb41",
        12 => x"0cc3a",
        11 => x"0b50b",
        10 => x"0a288",
        9 => x"0931e",
        8 => x"085e9",
        7 => x"07a5c",
        6 => x"07018",
        5 => x"066db",
        4 => x"05e76",
        3 => x"056c4",
        2 => x"04fa9",
        1 => x"04910",
        0 => x"042e8"
    );
    signal log_table_5 : std_logic_vector(16 downto 0) := (others => '0');

    -- ===== The memory exp_table
    -- Bits 10 downto 0 of each word.
    type exp_table_words_0_t is array (63 downto 0) of
        std_logic_vector(11 downto 0);
    constant EXP_TABLE_WORDS_0 : exp_table_words_0_t := (
        63 => x"406",
        62 => x"411",
        61 => x"41c",
        60 => x"428",
        59 => x"433",
        58 => x"43f",
        57 => x"44b",
        56 => x"457",
        55 => x"463",
        54 => x"46f",
        53 => x"47b",
        52 => x"488",
        51 => x"494",
        50 => x"4a1",
        49 => x"4ae",
        48 => x"4bb",
        47 => x"4c8",
        46 => x"4d6",
        45 => x"4e3",
        44 => x"4f1",
        43 => x"4ff",
        42 => x"50d",
        41 => x"51b",
        40 => x"529",
        39 => x"537",
        38 => x"546",
        37 => x"554",
        36 => x"563",
        35 => x"572",
        34 => x"582",
        33 => x"591",
        32 => x"5a0",
        31 => x"5b0",
        30 => x"5c0",
        29 => x"5d0",
        28 => x"5e0",
        27 => x"5f1",
        26 => x"601",
        25 => x"612",
        24 => x"623",
        23 => x"634",
        22 => x"645",
        21 => x"657",
        20 => x"668",
        19 => x"67a",
        18 => x"68c",
        17 => x"69e",
        16 => x"6b1",
        15 => x"6c4",
        14 => x"6d6",
        13 => x"6e9",
        12 => x"6fd",
        11 => x"710",
        10 => x"724",
        9 => x"738",
        8 => x"74c",
        7 => x"760",
        6 => x"775",
        5 => x"78a",
        4 => x"79f",
        3 => x"7b4",
        2 => x"7c9",
        1 => x"7df",
        0 => x"7f5"
    );
    signal exp_table_10 : std_logic_vector(10 downto 0) := (others => '0');

    signal valid : std_logic_vector(13 downto 1) := (others => '0');
    signal n_0 : unsigned(6 downto 0) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal in_octaves_0 : std_logic := '0';
    signal m_above_8_bits_0 : unsigned(7 downto 0) := (others => '0');
    signal m_above_8_0 : std_logic := '0';
    signal m_by_8_0 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_8_0 : unsigned(11 downto 0) := (others => '0');
    signal dark_bits_0 : std_logic := '0';
    signal n_1 : unsigned(6 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal in_octaves_1 : std_logic := '0';
    signal m_above_8_1 : std_logic := '0';
    signal m_moved_8_1 : unsigned(11 downto 0) := (others => '0');
    signal dark_bits_1 : std_logic := '0';
    signal top_1 : std_logic := '0';
    signal m_8_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_4_bits_1 : unsigned(3 downto 0) := (others => '0');
    signal m_above_4_1 : std_logic := '0';
    signal m_by_4_1 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_4_1 : unsigned(11 downto 0) := (others => '0');
    signal m_4_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_2_bits_1 : unsigned(1 downto 0) := (others => '0');
    signal m_above_2_1 : std_logic := '0';
    signal m_by_2_1 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_2_1 : unsigned(11 downto 0) := (others => '0');
    signal m_2_1 : unsigned(12 downto 0) := (others => '0');
    signal m_above_1_bits_1 : unsigned(0 downto 0) := (others => '0');
    signal m_by_1_1 : unsigned(12 downto 0) := (others => '0');
    signal m_moved_1_1 : unsigned(11 downto 0) := (others => '0');
    signal taken_8_1 : std_logic := '0';
    signal part_8_1 : unsigned(0 downto 0) := (others => '0');
    signal taken_4_1 : std_logic := '0';
    signal part_4_1 : unsigned(0 downto 0) := (others => '0');
    signal octave_4_1 : unsigned(1 downto 0) := (others => '0');
    signal taken_2_1 : std_logic := '0';
    signal part_2_1 : unsigned(0 downto 0) := (others => '0');
    signal n_2 : unsigned(6 downto 0) := (others => '0');
    signal top_2 : std_logic := '0';
    signal m_2_2 : unsigned(12 downto 0) := (others => '0');
    signal m_above_1_bits_2 : unsigned(0 downto 0) := (others => '0');
    signal m_moved_1_2 : unsigned(11 downto 0) := (others => '0');
    signal octave_4_2 : unsigned(1 downto 0) := (others => '0');
    signal part_2_2 : unsigned(0 downto 0) := (others => '0');
    signal dark_bits_2 : std_logic := '0';
    signal m_above_1_2 : std_logic := '0';
    signal m_1_2 : unsigned(12 downto 0) := (others => '0');
    signal cell_2 : unsigned(3 downto 0) := (others => '0');
    signal cell_number_2 : unsigned(3 downto 0) := (others => '0');
    signal octave_2_2 : unsigned(2 downto 0) := (others => '0');
    signal taken_1_2 : std_logic := '0';
    signal part_1_2 : unsigned(0 downto 0) := (others => '0');
    signal octave_1_2 : unsigned(3 downto 0) := (others => '0');
    signal address_of_parts_2 : unsigned(3 downto 0) := (others => '0');
    signal n_3 : unsigned(6 downto 0) := (others => '0');
    signal top_3 : std_logic := '0';
    signal cell_number_3 : unsigned(3 downto 0) := (others => '0');
    signal address_of_parts_3 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_3 : std_logic := '0';
    signal part_address_3 : unsigned(7 downto 0) := (others => '0');
    signal n_4 : unsigned(6 downto 0) := (others => '0');
    signal top_4 : std_logic := '0';
    signal part_address_4 : unsigned(7 downto 0) := (others => '0');
    signal dark_bits_4 : std_logic := '0';
    signal n_5 : unsigned(6 downto 0) := (others => '0');
    signal top_5 : std_logic := '0';
    signal dark_bits_5 : std_logic := '0';
    signal log_5 : unsigned(16 downto 0) := (others => '0');
    signal n_6 : unsigned(6 downto 0) := (others => '0');
    signal top_6 : std_logic := '0';
    signal log_6 : unsigned(16 downto 0) := (others => '0');
    signal dark_bits_6 : std_logic := '0';
    signal n_7 : unsigned(6 downto 0) := (others => '0');
    signal top_7 : std_logic := '0';
    signal log_7 : unsigned(16 downto 0) := (others => '0');
    signal dark_bits_7 : std_logic := '0';
    signal L_7 : unsigned(16 downto 0) := (others => '0');
    signal n_8 : unsigned(6 downto 0) := (others => '0');
    signal L_8 : unsigned(16 downto 0) := (others => '0');
    signal dark_bits_8 : std_logic := '0';
    signal z_8 : unsigned(23 downto 0) := (others => '0');
    signal over_bits_8 : unsigned(5 downto 0) := (others => '0');
    signal i_8 : unsigned(3 downto 0) := (others => '0');
    signal f_8 : unsigned(5 downto 0) := (others => '0');
    signal entry_8 : unsigned(5 downto 0) := (others => '0');
    signal over_bits_9 : unsigned(5 downto 0) := (others => '0');
    signal i_9 : unsigned(3 downto 0) := (others => '0');
    signal entry_9 : unsigned(5 downto 0) := (others => '0');
    signal dark_bits_9 : std_logic := '0';
    signal over_9 : std_logic := '0';
    signal zero_9 : std_logic := '0';
    signal i_10 : unsigned(3 downto 0) := (others => '0');
    signal zero_10 : std_logic := '0';
    signal exp_10 : unsigned(10 downto 0) := (others => '0');
    signal i_11 : unsigned(3 downto 0) := (others => '0');
    signal exp_11 : unsigned(10 downto 0) := (others => '0');
    signal zero_11 : std_logic := '0';
    signal power_shifted_11 : unsigned(10 downto 0) := (others => '0');
    signal power_shifted_12 : unsigned(10 downto 0) := (others => '0');
    signal zero_12 : std_logic := '0';
    signal y_half_12 : unsigned(10 downto 0) := (others => '0');
    signal y_cut_12 : unsigned(10 downto 0) := (others => '0');
    signal y_12 : unsigned(10 downto 0) := (others => '0');
    signal y_13 : unsigned(10 downto 0) := (others => '0');

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

    -- ===== Stage 0: n, x, u
    -- UQ7.0: in_n taken into the range
    n_0 <= to_unsigned(1, 7) when in_n < 1 else
        in_n;
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.12: u = 1 - x, the versine
    u_0 <= to_unsigned(4096, 13) - x_0;
    -- UQ1.0: the versine lies in one of the table's octaves
    in_octaves_0 <= '1' when u_0 /= 0 else '0';
    -- UQ0.8: a bit of weight 2^-8 or more is set
    m_above_8_bits_0 <= u_0(11 downto 4);
    -- UQ1.0: a bit of weight 2^-8 or more is set
    m_above_8_0 <= '1' when m_above_8_bits_0 /= 0 else '0';
    -- UQ9.4: shifted
    m_by_8_0 <= u_0;
    -- UQ0.12: the high bits are 0
    m_moved_8_0 <= shift_left(m_by_8_0(11 downto 0), 8);
    -- UQ1.0: u = 1: the surface faces away
    dark_bits_0 <= u_0(12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_1 <= n_0;
                u_1 <= u_0;
                in_octaves_1 <= in_octaves_0;
                m_above_8_1 <= m_above_8_0;
                m_moved_8_1 <= m_moved_8_0;
                dark_bits_1 <= dark_bits_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: m_8, m_4, m_2, octave_4
    -- UQ1.0: x is 1, or so near to it that L counts as 0
    top_1 <= not in_octaves_1;
    -- UQ1.12: shifted to the left by 8 where that loses no bit
    m_8_1 <= u_1 when m_above_8_1 = '1' else resize(m_moved_8_1, 13);
    -- UQ0.4: a bit of weight 2^-4 or more is set
    m_above_4_bits_1 <= m_8_1(11 downto 8);
    -- UQ1.0: a bit of weight 2^-4 or more is set
    m_above_4_1 <= '1' when m_above_4_bits_1 /= 0 else '0';
    -- UQ5.8: shifted
    m_by_4_1 <= m_8_1;
    -- UQ0.12: the high bits are 0
    m_moved_4_1 <= shift_left(m_by_4_1(11 downto 0), 4);
    -- UQ1.12: shifted to the left by 4 where that loses no bit
    m_4_1 <= m_8_1 when m_above_4_1 = '1' else resize(m_moved_4_1, 13);
    -- UQ0.2: a bit of weight 2^-2 or more is set
    m_above_2_bits_1 <= m_4_1(11 downto 10);
    -- UQ1.0: a bit of weight 2^-2 or more is set
    m_above_2_1 <= '1' when m_above_2_bits_1 /= 0 else '0';
    -- UQ3.10: shifted
    m_by_2_1 <= m_4_1;
    -- UQ0.12: the high bits are 0
    m_moved_2_1 <= shift_left(m_by_2_1(11 downto 0), 2);
    -- UQ1.12: shifted to the left by 2 where that loses no bit
    m_2_1 <= m_4_1 when m_above_2_1 = '1' else resize(m_moved_2_1, 13);
    -- UQ0.1: a bit of weight 2^-1 or more is set
    m_above_1_bits_1 <= m_2_1(11 downto 11);
    -- UQ2.11: shifted
    m_by_1_1 <= m_2_1;
    -- UQ0.12: the high bits are 0
    m_moved_1_1 <= shift_left(m_by_1_1(11 downto 0), 1);
    -- UQ1.0: this step of the shift was taken
    taken_8_1 <= not m_above_8_1;
    -- UQ4.-3: its part of the octave
    part_8_1 <= unsigned'("" & taken_8_1);
    -- UQ1.0: this step of the shift was taken
    taken_4_1 <= not m_above_4_1;
    -- UQ3.-2: its part of the octave
    part_4_1 <= unsigned'("" & taken_4_1);
    -- UQ4.-2: the octave: how far the versine was shifted
    octave_4_1 <= shift_left(resize(part_8_1, 2), 1) + resize(part_4_1, 2);
    -- UQ1.0: this step of the shift was taken
    taken_2_1 <= not m_above_2_1;
    -- UQ2.-1: its part of the octave
    part_2_1 <= unsigned'("" & taken_2_1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_2 <= n_1;
                top_2 <= top_1;
                m_2_2 <= m_2_1;
                m_above_1_bits_2 <= m_above_1_bits_1;
                m_moved_1_2 <= m_moved_1_1;
                octave_4_2 <= octave_4_1;
                part_2_2 <= part_2_1;
                dark_bits_2 <= dark_bits_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: m_1, octave_2, octave_1
    -- UQ1.0: a bit of weight 2^-1 or more is set
    m_above_1_2 <= '1' when m_above_1_bits_2 /= 0 else '0';
    -- UQ1.12: shifted to the left by 1 where that loses no bit
    m_1_2 <= m_2_2 when m_above_1_2 = '1' else resize(m_moved_1_2, 13);
    -- UQ-1.5: where in its octave the versine lies
    cell_2 <= m_1_2(10 downto 7);
    -- UQ4.0: as a number
    cell_number_2 <= cell_2;
    -- UQ4.-1: the octave: how far the versine was shifted
    octave_2_2 <= shift_left(resize(octave_4_2, 3), 1) + resize(part_2_2, 3);
    -- UQ1.0: this step of the shift was taken
    taken_1_2 <= not m_above_1_2;
    -- UQ1.0: its part of the octave
    part_1_2 <= unsigned'("" & taken_1_2);
    -- UQ4.0: the octave: how far the versine was shifted
    octave_1_2 <= shift_left(resize(octave_2_2, 4), 1) + resize(part_1_2, 4);
    -- UQ8.-4: the address of the row's first part
    address_of_parts_2 <= octave_1_2;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_3 <= n_2;
                top_3 <= top_2;
                cell_number_3 <= cell_number_2;
                address_of_parts_3 <= address_of_parts_2;
                dark_bits_3 <= dark_bits_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: part_address
    -- UQ8.0: the address of the part
    part_address_3 <= shift_left(resize(address_of_parts_3, 8), 4) + resize(cell_number_3, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_4 <= n_3;
                top_4 <= top_3;
                part_address_4 <= part_address_3;
                dark_bits_4 <= dark_bits_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: read log_table
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                log_table_5(16 downto 0) <=
                    LOG_TABLE_WORDS_0(to_integer(part_address_4))(16 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_5 <= n_4;
                top_5 <= top_4;
                dark_bits_5 <= dark_bits_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: registers only
    -- UQ3.14: L = -log2 x midway in the cell
    log_5 <= unsigned(log_table_5(16 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_6 <= n_5;
                top_6 <= top_5;
                log_6 <= log_5;
                dark_bits_6 <= dark_bits_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_7 <= n_6;
                top_7 <= top_6;
                log_7 <= log_6;
                dark_bits_7 <= dark_bits_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: L
    -- UQ3.14: L = -log2 x
    L_7 <= (others => '0') when top_7 = '1' else log_7;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_8 <= n_7;
                L_8 <= L_7;
                dark_bits_8 <= dark_bits_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: z
    -- UQ10.14: z = n L
    z_8 <= n_8 * L_8;
    -- UQ10.-4: z is past what the result can show
    over_bits_8 <= z_8(23 downto 18);
    -- UQ4.0: the integer part of z
    i_8 <= z_8(17 downto 14);
    -- UQ0.6: the leading bits of the fraction of z
    f_8 <= z_8(13 downto 8);
    -- UQ6.0: the entry of the second table
    entry_8 <= f_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                over_bits_9 <= over_bits_8;
                i_9 <= i_8;
                entry_9 <= entry_8;
                dark_bits_9 <= dark_bits_8;
            end if;
        end if;
    end process;

    -- ===== Stage 9: read exp_table
    -- UQ1.0: z is past what the result can show
    over_9 <= '1' when over_bits_9 /= 0 else '0';
    -- UQ1.0: the result is 0
    zero_9 <= dark_bits_9 or over_9;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_table_10(10 downto 0) <=
                    EXP_TABLE_WORDS_0(to_integer(entry_9))(10 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                i_10 <= i_9;
                zero_10 <= zero_9;
            end if;
        end if;
    end process;

    -- ===== Stage 10: registers only
    -- UQ0.11: 2^-f midway in the cell
    exp_10 <= unsigned(exp_table_10(10 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                i_11 <= i_10;
                exp_11 <= exp_10;
                zero_11 <= zero_10;
            end if;
        end if;
    end process;

    -- ===== Stage 11: power_shifted
    -- UQ0.11: 2^-z = 2^-f 2^-i
    power_shifted_11 <= shift_right(exp_11, to_integer(i_11));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_shifted_12 <= power_shifted_11;
                zero_12 <= zero_11;
            end if;
        end if;
    end process;

    -- ===== Stage 12: y_half, y
    -- UQ0.11: plus half an output ulp: the result is rounded to nearest
    y_half_12 <= power_shifted_12 + to_unsigned(1, 11);
    -- UQ1.10: rounded to the output's bits
    y_cut_12 <= resize(y_half_12(10 downto 1), 11);
    -- UQ1.10: y, 0 where it is below half an ulp
    y_12 <= (others => '0') when zero_12 = '1' else y_cut_12;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_13 <= y_12;
            end if;
        end if;
    end process;

    out_valid <= valid(13);
    out_spec  <= y_13;

end architecture rtl;
