{%- for line in texts.header %}
{%- if line.is_empty() %}
--
{%- else %}
-- {{ line }}
{%- endif %}
{%- endfor %}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
{%- if texts.rom_file.is_some() %}
use std.textio.all;
{%- endif %}

entity {{ texts.name }} is
{%- if let Some(file) = texts.rom_file %}
    generic (
        -- Path of the coefficient ROM, in the format of Verilog's $readmemh.
        ROM_FILE : string := "{{ file }}"
    );
{%- endif %}
    port (
        -- Clock; everything happens on its rising edge.
        clk       : in  std_logic;
        -- Synchronous reset: clears the valid chain, whatever ce is.
        rst       : in  std_logic;
        -- Clock enable: 0 freezes the whole pipeline.
        ce        : in  std_logic;
        -- in_n and {{ operand }} are to be taken.
        in_valid  : in  std_logic;
        -- {{ index_format }}: selects the shininess.
        in_n      : in  {{ index_kind }};
        -- {{ operand_format }}: {% if operand_signed %}cosine; below 0 gives 0, above 1 counts as 1.{% else %}versine; above 1 counts as 1, which gives 0.{% endif %}
        {{ operand }}    : in  {{ operand_kind }};
        -- out_spec is a result: in_valid, {{ latency }} enabled clocks later.
        out_valid : out std_logic;
        -- {{ output_format }}: the lobe, 0 to 1.
        out_spec  : out {{ output_kind }}
    );
end entity {{ texts.name }};

architecture rtl of {{ texts.name }} is

    -- ===== The coefficient ROM
{%- if texts.rom_file.is_some() %}
    type rom_t is array ({{ rom_depth - 1 }} downto 0) of std_logic_vector({{ rom_bits - 1 }} downto 0);

    -- Reads one word a line; lines that begin with a slash are comments.
    impure function read_rom(path : string) return rom_t is
        file source     : text open read_mode is path;
        variable row    : line;
        variable word   : std_logic_vector({{ rom_digit_bits - 1 }} downto 0);
        variable result : rom_t;
        variable index  : natural := 0;
    begin
        while not endfile(source) loop
            readline(source, row);
            if row'length > 0 and row(row'left) /= '/' then
                assert index < {{ rom_depth }} report path & " has too many words" severity failure;
                hread(row, word);
                result(index) := word({{ rom_bits - 1 }} downto 0);
                index := index + 1;
            end if;
        end loop;
        assert index = {{ rom_depth }} report path & " has too few words" severity failure;
        return result;
    end function;

    constant ROM : rom_t := read_rom(ROM_FILE);
{%- else %}
{%- for chunk in chunks %}
    -- Bits {{ chunk.high }} downto {{ chunk.low }} of each word.
    type rom_words_{{ chunk.index }}_t is array ({{ rom_depth - 1 }} downto 0) of
        std_logic_vector({{ chunk.element_bits - 1 }} downto 0);
    constant ROM_WORDS_{{ chunk.index }} : rom_words_{{ chunk.index }}_t := (
{%- for (address, word) in chunk.rows %}
        {{ address }} => x"{{ word }}"{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- endfor %}
{%- endif %}
    signal {{ rom_name }} : std_logic_vector({{ rom_bits - 1 }} downto 0){% if rom_registered %} := (others => '0'){% endif %};

    signal valid : std_logic_vector({{ latency }} downto 1) := (others => '0');
{%- for signal in signals %}
    signal {{ signal.name }} : {{ signal.kind }};
{%- endfor %}

begin

    -- ===== Valid chain
    process (clk) is
    begin
        if rising_edge(clk) then
            if rst = '1' then
                valid <= (others => '0');
            elsif ce = '1' then
                valid <= {% if latency == 1 %}(1 => in_valid){% else %}valid({{ latency - 1 }} downto 1) & in_valid{% endif %};
            end if;
        end if;
    end process;
{%- for stage in stages %}

    -- ===== Stage {{ stage.index }}: {{ stage.heading }}
{%- for assignment in stage.assignments %}
    -- {{ assignment.comment }}
    {{ assignment.target }} <={{ assignment.expression }};
{%- endfor %}
{%- if stage.index == rom_stage %}
{%- if rom_registered %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- if texts.rom_file.is_some() %}
                {{ rom_name }} <= ROM(to_integer({{ rom_address }}));
{%- else %}
{%- for chunk in chunks %}
                {{ rom_name }}({{ chunk.high }} downto {{ chunk.low }}) <=
                    ROM_WORDS_{{ chunk.index }}(to_integer({{ rom_address }}))({{ chunk.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
            end if;
        end if;
    end process;
{%- else if texts.rom_file.is_some() %}
    {{ rom_name }} <= ROM(to_integer({{ rom_address }}));
{%- else %}
{%- for chunk in chunks %}
    {{ rom_name }}({{ chunk.high }} downto {{ chunk.low }}) <=
        ROM_WORDS_{{ chunk.index }}(to_integer({{ rom_address }}))({{ chunk.bits - 1 }} downto 0);
{%- endfor %}
{%- endif %}
{%- endif %}
{%- if !stage.registers.is_empty() %}
    process (clk) is
    begin
        if rising_edge(clk) then
            if ce = '1' then
{%- for (target, source) in stage.registers %}
                {{ target }} <= {{ source }};
{%- endfor %}
            end if;
        end if;
    end process;
{%- endif %}
{%- endfor %}

    out_valid <= valid({{ latency }});
    out_spec  <= {{ output }};

end architecture rtl;
