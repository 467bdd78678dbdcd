        -- ------------------------------------------------------------- random numbers
        -- Marsaglia's xorshift32: a linear feedback register of the full period 2^32-1 that
        -- turns over 32 bits a step. The seed is fixed, and the Verilog bench draws the same
        -- numbers.
        variable lfsr : std_logic_vector(31 downto 0) := x"1badcafe";

        procedure draw is
        begin
            lfsr := lfsr xor (lfsr(18 downto 0) & (12 downto 0 => '0'));
            lfsr := lfsr xor ((16 downto 0 => '0') & lfsr(31 downto 17));
            lfsr := lfsr xor (lfsr(26 downto 0) & (4 downto 0 => '0'));
        end procedure;
