-- table_2d: specular lobe x^n as x^n from a table, 4 shininesses
--
-- Made by: brdfgen generate core.toml
-- Spec 93bf5e71d0f70b86. Generated; the core is yours to use under any terms.
--
--   in_n      UQ2.0   index of the shininess, 0 to 3; above: the last
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 6 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.500..+0.478.
--   measured -0.500..+0.478 over all 16388 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   30.273 % absolute, 30.273 % where x^n >= 1/2, 39.357 % relative there.
-- As the cosine rises, the output never falls: proved by running all 16384 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity table_2d is
    port (
        -- clock; everything happens on its rising edge
        clk       : in  std_logic;
        -- synchronous reset, active high: clears the valid chain, whatever ce is
        rst       : in  std_logic;
        -- clock enable: 0 freezes the whole pipeline
        ce        : in  std_logic;
        -- in_n and in_cos are to be taken
        in_valid  : in  std_logic;
        -- UQ2.0: index of the shininess, 0 to 3; above: the last
        in_n      : in  unsigned(1 downto 0);
        -- Q1.12: cosine x; below 0 gives 0, above 1 counts as 1
        in_cos    : in  signed(13 downto 0);
        -- out_spec is a result: in_valid, 6 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.10: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(10 downto 0)
    );
end entity table_2d;

architecture rtl of table_2d is
    -- ===== The memory power_table
    -- Bits 9 downto 0 of each word.
    type power_table_words_0_t is array (255 downto 0) of
        std_logic_vector(11 downto 0);
    constant POWER_TABLE_WORDS_0 : power_table_words_0_t := (
        255 => x"000",
        254 => x"000",
        253 => x"000",
        252 => x"000",
        251 => x"000",
        250 => x"000",
        249 => x"000",
        248 => x"000",
        247 => x"000",
        246 => x"000",
        245 => x"000",
        244 => x"000",
        243 => x"000",
        242 => x"000",
        241 => x"000",
        240 => x"000",
        239 => x"000",
        238 => x"000",
        237 => x"000",
        236 => x"000",
        235 => x"000",
        234 => x"000",
        233 => x"000",
        232 => x"000",
        231 => x"000",
        230 => x"000",
        229 => x"000",
        228 => x"000",
        227 => x"000",
        226 => x"000",
        225 => x"000",
        224 => x"000",
        223 => x"000",
        222 => x"000",
        221 => x"000",
        220 => x"000",
        219 => x"000",
        218 => x"000",
        217 => x"000",
        216 => x"000",
        215 => x"000",
        214 => x"000",
        213 => x"000",
        212 => x"000",
        211 => x"000",
        210 => x"000",
        209 => x"000",
        208 => x"000",
        207 => x"000",
        206 => x"000",
        205 => x"000",
        204 => x"000",
        203 => x"000",
        202 => x"000",
        201 => x"000",
        200 => x"000",
        199 => x"001",
        198 => x"002",
        197 => x"005",
        196 => x"00f",
        195 => x"028",
        194 => x"069",
        193 => x"114",
        192 => x"2ca",
        191 => x"000",
        190 => x"000",
        189 => x"000",
        188 => x"000",
        187 => x"000",
        186 => x"000",
        185 => x"000",
        184 => x"000",
        183 => x"000",
        182 => x"000",
        181 => x"000",
        180 => x"000",
        179 => x"000",
        178 => x"000",
        177 => x"000",
        176 => x"000",
        175 => x"000",
        174 => x"000",
        173 => x"000",
        172 => x"000",
        171 => x"000",
        170 => x"000",
        169 => x"000",
        168 => x"000",
        167 => x"000",
        166 => x"000",
        165 => x"000",
        164 => x"000",
        163 => x"000",
        162 => x"000",
        161 => x"000",
        160 => x"000",
        159 => x"000",
        158 => x"000",
        157 => x"000",
        156 => x"000",
        155 => x"000",
        154 => x"000",
        153 => x"000",
        152 => x"000",
        151 => x"000",
        150 => x"000",
        149 => x"000",
        148 => x"000",
        147 => x"001",
        146 => x"001",
        145 => x"002",
        144 => x"003",
        143 => x"004",
        142 => x"006",
        141 => x"009",
        140 => x"00e",
        139 => x"014",
        138 => x"01d",
        137 => x"02a",
        136 => x"03c",
        135 => x"056",
        134 => x"07a",
        133 => x"0ac",
        132 => x"0f2",
        131 => x"152",
        130 => x"1d4",
        129 => x"286",
        128 => x"378",
        127 => x"000",
        126 => x"000",
        125 => x"000",
        124 => x"000",
        123 => x"000",
        122 => x"000",
        121 => x"000",
        120 => x"000",
        119 => x"000",
        118 => x"000",
        117 => x"000",
        116 => x"000",
        115 => x"000",
        114 => x"000",
        113 => x"001",
        112 => x"001",
        111 => x"001",
        110 => x"002",
        109 => x"002",
        108 => x"003",
        107 => x"003",
        106 => x"004",
        105 => x"006",
        104 => x"007",
        103 => x"008",
        102 => x"00a",
        101 => x"00d",
        100 => x"00f",
        99 => x"012",
        98 => x"015",
        97 => x"019",
        96 => x"01e",
        95 => x"023",
        94 => x"028",
        93 => x"02f",
        92 => x"036",
        91 => x"03e",
        90 => x"047",
        89 => x"051",
        88 => x"05c",
        87 => x"068",
        86 => x"076",
        85 => x"085",
        84 => x"095",
        83 => x"0a7",
        82 => x"0ba",
        81 => x"0d0",
        80 => x"0e7",
        79 => x"100",
        78 => x"11c",
        77 => x"13a",
        76 => x"15a",
        75 => x"17d",
        74 => x"1a3",
        73 => x"1cb",
        72 => x"1f7",
        71 => x"226",
        70 => x"258",
        69 => x"28e",
        68 => x"2c8",
        67 => x"306",
        66 => x"348",
        65 => x"38f",
        64 => x"3da",
        63 => x"008",
        62 => x"018",
        61 => x"028",
        60 => x"038",
        59 => x"048",
        58 => x"058",
        57 => x"068",
        56 => x"078",
        55 => x"088",
        54 => x"098",
        53 => x"0a8",
        52 => x"0b8",
        51 => x"0c8",
        50 => x"0d8",
        49 => x"0e8",
        48 => x"0f8",
        47 => x"108",
        46 => x"118",
        45 => x"128",
        44 => x"138",
        43 => x"148",
        42 => x"158",
        41 => x"168",
        40 => x"178",
        39 => x"188",
        38 => x"198",
        37 => x"1a8",
        36 => x"1b8",
        35 => x"1c8",
        34 => x"1d8",
        33 => x"1e8",
        32 => x"1f8",
        31 => x"208",
        30 => x"218",
        29 => x"228",
        28 => x"238",
        27 => x"248",
        26 => x"258",
        25 => x"268",
        24 => x"278",
        23 => x"288",
        22 => x"298",
        21 => x"2a8",
        20 => x"2b8",
        19 => x"2c8",
        18 => x"2d8",
        17 => x"2e8",
        16 => x"2f8",
        15 => x"308",
        14 => x"318",
        13 => x"328",
        12 => x"338",
        11 => x"348",
        10 => x"358",
        9 => x"368",
        8 => x"378",
        7 => x"388",
        6 => x"398",
        5 => x"3a8",
        4 => x"3b8",
        3 => x"3c8",
        2 => x"3d8",
        1 => x"3e8",
        0 => x"3f8"
    );
    signal power_table_3 : std_logic_vector(9 downto 0) := (others => '0');

    signal valid : std_logic_vector(6 downto 1) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal cell_0 : unsigned(5 downto 0) := (others => '0');
    signal cell_number_0 : unsigned(5 downto 0) := (others => '0');
    signal address_of_parts_0 : unsigned(1 downto 0) := (others => '0');
    signal dark_bits_0 : std_logic := '0';
    signal cell_number_1 : unsigned(5 downto 0) := (others => '0');
    signal address_of_parts_1 : unsigned(1 downto 0) := (others => '0');
    signal dark_bits_1 : std_logic := '0';
    signal part_address_1 : unsigned(7 downto 0) := (others => '0');
    signal part_address_2 : unsigned(7 downto 0) := (others => '0');
    signal dark_bits_2 : std_logic := '0';
    signal dark_bits_3 : std_logic := '0';
    signal y_3 : unsigned(9 downto 0) := (others => '0');
    signal y_4 : unsigned(9 downto 0) := (others => '0');
    signal dark_bits_4 : std_logic := '0';
    signal y_5 : unsigned(9 downto 0) := (others => '0');
    signal dark_bits_5 : std_logic := '0';
    signal y_lit_5 : unsigned(9 downto 0) := (others => '0');
    signal y_wide_5 : unsigned(10 downto 0) := (others => '0');
    signal y_wide_6 : unsigned(10 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(5 downto 1) & in_valid;
            end if;
        end if;
    end process;

    -- ===== Stage 0: x, u
    -- UQ1.12: x = in_cos taken into [0, 1]: back-facing gives x = 0
    x_0 <= (others => '0') when in_cos(13) = '1' else
        (12 => '1', others => '0') when in_cos(12) = '1' else
        unsigned(in_cos(12 downto 0));
    -- UQ1.12: u = 1 - x, the versine
    u_0 <= to_unsigned(4096, 13) - x_0;
    -- UQ0.6: the cell of the versine, for u below 1
    cell_0 <= u_0(11 downto 6);
    -- UQ6.0: the number of the cell
    cell_number_0 <= cell_0;
    -- UQ8.-6: the address of the row's first part
    address_of_parts_0 <= in_n;
    -- UQ1.0: u = 1: the surface faces away
    dark_bits_0 <= u_0(12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                cell_number_1 <= cell_number_0;
                address_of_parts_1 <= address_of_parts_0;
                dark_bits_1 <= dark_bits_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: part_address
    -- UQ8.0: the address of the part
    part_address_1 <= shift_left(resize(address_of_parts_1, 8), 6) + resize(cell_number_1, 8);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                part_address_2 <= part_address_1;
                dark_bits_2 <= dark_bits_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: read power_table
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                power_table_3(9 downto 0) <=
                    POWER_TABLE_WORDS_0(to_integer(part_address_2))(9 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dark_bits_3 <= dark_bits_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: registers only
    -- UQ0.10: x^n midway in the cell
    y_3 <= unsigned(power_table_3(9 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_4 <= y_3;
                dark_bits_4 <= dark_bits_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: registers only
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_5 <= y_4;
                dark_bits_5 <= dark_bits_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: y_lit
    -- UQ0.10: y, 0 where the surface faces away
    y_lit_5 <= (others => '0') when dark_bits_5 = '1' else y_5;
    -- UQ1.10: with an integer bit
    y_wide_5 <= resize(y_lit_5, 11);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_wide_6 <= y_wide_5;
            end if;
        end if;
    end process;

    out_valid <= valid(6);
    out_spec  <= y_wide_6;

end architecture rtl;
