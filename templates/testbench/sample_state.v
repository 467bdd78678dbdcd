    integer words;         // of the sample that is presented
    integer begins_at;     // where they are in the table
    integer written;
    reg     in_last   = 1'b0;
    reg     half      = 1'b0; // the half of the table that is written next
