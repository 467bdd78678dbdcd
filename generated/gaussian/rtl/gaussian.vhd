-- gaussian: specular lobe x^n as e^(-n u), n = 1 to 127
--
-- Made by: brdfgen generate core.toml
-- Spec ffaebb9642af1568. Generated; the core is yours to use under any terms.
--
--   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
--   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
--   out_spec  UQ1.10  the lobe, 0 to 1; 1.0 is exact
--
-- Latency 9 clocks, one result a clock.
-- Error against the real-valued method, in ulps of out_spec: proved within -0.821..+0.997.
--   measured -0.593..+0.935 over all 520319 inputs in [0, 1].
-- Error against x^n itself, measured over the same inputs:
--   36.792 % absolute, 10.718 % where x^n >= 1/2, 21.425 % relative there.
-- As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
--   inputs.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity gaussian is
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
        -- out_spec is a result: in_valid, 9 enabled clocks later
        out_valid : out std_logic;
        -- UQ1.10: the lobe, 0 to 1; 1.0 is exact
        out_spec  : out unsigned(10 downto 0)
    );
end entity gaussian;

architecture rtl of gaussian is
    -- ===== The memory exp_table
    -- Bits 20 downto 0 of each word.
    type exp_table_words_0_t is array (15 downto 0) of
        std_logic_vector(23 downto 0);
    constant EXP_TABLE_WORDS_0 : exp_table_words_0_t := (
        15 => x"10b4b5",
        14 => x"1170bd",
        13 => x"1236c6",
        12 => x"1304ce",
        11 => x"13dcd8",
        10 => x"14bee1",
        9 => x"15a8eb",
        8 => x"169ef6",
        7 => x"179f00",
        6 => x"18ab0c",
        5 => x"19c318",
        4 => x"1ae724",
        3 => x"1c1731",
        2 => x"1d553e",
        1 => x"1ea34d",
        0 => x"1ffd5b"
    );
    signal exp_table_4 : std_logic_vector(20 downto 0) := (others => '0');

    signal valid : std_logic_vector(9 downto 1) := (others => '0');
    signal n_0 : unsigned(6 downto 0) := (others => '0');
    signal x_0 : unsigned(12 downto 0) := (others => '0');
    signal u_0 : unsigned(12 downto 0) := (others => '0');
    signal dark_bits_0 : std_logic := '0';
    signal n_1 : unsigned(6 downto 0) := (others => '0');
    signal u_1 : unsigned(12 downto 0) := (others => '0');
    signal dark_bits_1 : std_logic := '0';
    signal nu_1 : unsigned(19 downto 0) := (others => '0');
    signal beyond_bits_1 : unsigned(3 downto 0) := (others => '0');
    signal v_1 : unsigned(13 downto 0) := (others => '0');
    signal beyond_bits_2 : unsigned(3 downto 0) := (others => '0');
    signal v_2 : unsigned(13 downto 0) := (others => '0');
    signal dark_bits_2 : std_logic := '0';
    signal beyond_2 : std_logic := '0';
    signal vk_2 : unsigned(24 downto 0) := (others => '0');
    signal z_2 : unsigned(16 downto 0) := (others => '0');
    signal power_high_2 : unsigned(3 downto 0) := (others => '0');
    signal power_entry_2 : unsigned(3 downto 0) := (others => '0');
    signal power_d_2 : unsigned(8 downto 0) := (others => '0');
    signal i_2 : unsigned(3 downto 0) := (others => '0');
    signal beyond_3 : std_logic := '0';
    signal power_entry_3 : unsigned(3 downto 0) := (others => '0');
    signal power_d_3 : unsigned(8 downto 0) := (others => '0');
    signal i_3 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_3 : std_logic := '0';
    signal beyond_4 : std_logic := '0';
    signal power_d_4 : unsigned(8 downto 0) := (others => '0');
    signal i_4 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_4 : std_logic := '0';
    signal exp_base_4 : unsigned(11 downto 0) := (others => '0');
    signal exp_slope_4 : unsigned(8 downto 0) := (others => '0');
    signal beyond_5 : std_logic := '0';
    signal exp_base_5 : unsigned(11 downto 0) := (others => '0');
    signal exp_slope_5 : unsigned(8 downto 0) := (others => '0');
    signal power_d_5 : unsigned(8 downto 0) := (others => '0');
    signal i_5 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_5 : std_logic := '0';
    signal power_fall_5 : unsigned(17 downto 0) := (others => '0');
    signal power_step_5 : unsigned(7 downto 0) := (others => '0');
    signal beyond_6 : std_logic := '0';
    signal exp_base_6 : unsigned(11 downto 0) := (others => '0');
    signal power_step_6 : unsigned(7 downto 0) := (others => '0');
    signal i_6 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_6 : std_logic := '0';
    signal power_6 : unsigned(11 downto 0) := (others => '0');
    signal beyond_7 : std_logic := '0';
    signal power_7 : unsigned(11 downto 0) := (others => '0');
    signal i_7 : unsigned(3 downto 0) := (others => '0');
    signal dark_bits_7 : std_logic := '0';
    signal power_shifted_7 : unsigned(11 downto 0) := (others => '0');
    signal beyond_8 : std_logic := '0';
    signal power_shifted_8 : unsigned(11 downto 0) := (others => '0');
    signal dark_bits_8 : std_logic := '0';
    signal y_half_8 : unsigned(12 downto 0) := (others => '0');
    signal y_cut_8 : unsigned(10 downto 0) := (others => '0');
    signal y_8 : unsigned(10 downto 0) := (others => '0');
    signal y_lit_8 : unsigned(10 downto 0) := (others => '0');
    signal y_lit_9 : unsigned(10 downto 0) := (others => '0');

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= valid(8 downto 1) & in_valid;
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
    -- UQ1.0: u = 1: the surface faces away
    dark_bits_0 <= u_0(12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_1 <= n_0;
                u_1 <= u_0;
                dark_bits_1 <= dark_bits_0;
            end if;
        end if;
    end process;

    -- ===== Stage 1: nu
    -- UQ8.12: n u
    nu_1 <= n_1 * u_1;
    -- UQ7.-3: so large that z is past what the result can show
    beyond_bits_1 <= nu_1(18 downto 15);
    -- UQ3.11: v = n u, rounded down
    v_1 <= nu_1(14 downto 1);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_bits_2 <= beyond_bits_1;
                v_2 <= v_1;
                dark_bits_2 <= dark_bits_1;
            end if;
        end if;
    end process;

    -- ===== Stage 2: vk
    -- UQ1.0: so large that z is past what the result can show
    beyond_2 <= '1' when beyond_bits_2 /= 0 else '0';
    -- UQ4.21: v log2 e
    vk_2 <= v_2 * to_unsigned(1477, 11);
    -- UQ4.13: z = n u log2 e, rounded down
    z_2 <= vk_2(24 downto 8);
    -- UQ0.4: the bits that select the entry
    power_high_2 <= z_2(12 downto 9);
    -- UQ4.0: the address in the table
    power_entry_2 <= power_high_2;
    -- UQ-4.13: the distance from the entry's start
    power_d_2 <= z_2(8 downto 0);
    -- UQ4.0: the integer part of z
    i_2 <= z_2(16 downto 13);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_3 <= beyond_2;
                power_entry_3 <= power_entry_2;
                power_d_3 <= power_d_2;
                i_3 <= i_2;
                dark_bits_3 <= dark_bits_2;
            end if;
        end if;
    end process;

    -- ===== Stage 3: read exp_table
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                exp_table_4(20 downto 0) <=
                    EXP_TABLE_WORDS_0(to_integer(power_entry_3))(20 downto 0);
            end if;
        end if;
    end process;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_4 <= beyond_3;
                power_d_4 <= power_d_3;
                i_4 <= i_3;
                dark_bits_4 <= dark_bits_3;
            end if;
        end if;
    end process;

    -- ===== Stage 4: registers only
    -- UQ0.12: 2^-f at the entry's start
    exp_base_4 <= unsigned(exp_table_4(20 downto 9));
    -- UQ0.9: how steeply 2^-f falls
    exp_slope_4 <= unsigned(exp_table_4(8 downto 0));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_5 <= beyond_4;
                exp_base_5 <= exp_base_4;
                exp_slope_5 <= exp_slope_4;
                power_d_5 <= power_d_4;
                i_5 <= i_4;
                dark_bits_5 <= dark_bits_4;
            end if;
        end if;
    end process;

    -- ===== Stage 5: power_fall
    -- UQ-4.22: how far the value has fallen from the entry's start
    power_fall_5 <= exp_slope_5 * power_d_5;
    -- UQ-4.12: rounded down
    power_step_5 <= power_fall_5(17 downto 10);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_6 <= beyond_5;
                exp_base_6 <= exp_base_5;
                power_step_6 <= power_step_5;
                i_6 <= i_5;
                dark_bits_6 <= dark_bits_5;
            end if;
        end if;
    end process;

    -- ===== Stage 6: power
    -- UQ0.12: 2^-f
    power_6 <= exp_base_6 - resize(power_step_6, 12);
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_7 <= beyond_6;
                power_7 <= power_6;
                i_7 <= i_6;
                dark_bits_7 <= dark_bits_6;
            end if;
        end if;
    end process;

    -- ===== Stage 7: power_shifted
    -- UQ0.12: 2^-z = 2^-f 2^-i
    power_shifted_7 <= shift_right(power_7, to_integer(i_7));
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                beyond_8 <= beyond_7;
                power_shifted_8 <= power_shifted_7;
                dark_bits_8 <= dark_bits_7;
            end if;
        end if;
    end process;

    -- ===== Stage 8: y_half, y, y_lit
    -- UQ1.12: plus half an output ulp: the result is rounded to nearest
    y_half_8 <= resize(power_shifted_8, 13) + to_unsigned(2, 13);
    -- UQ1.10: rounded to the output's bits
    y_cut_8 <= y_half_8(12 downto 2);
    -- UQ1.10: y, 0 where it is below half an ulp
    y_8 <= (others => '0') when beyond_8 = '1' else y_cut_8;
    -- UQ1.10: y, 0 where the surface faces away
    y_lit_8 <= (others => '0') when dark_bits_8 = '1' else y_8;
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_lit_9 <= y_lit_8;
            end if;
        end if;
    end process;

    out_valid <= valid(9);
    out_spec  <= y_lit_9;

end architecture rtl;
