        variable begins_at : natural := 0;     -- where the words of the sample are in the table,
        variable words     : positive := 1;    -- and how many
        variable half      : boolean := false; -- the half of the table that is written next
