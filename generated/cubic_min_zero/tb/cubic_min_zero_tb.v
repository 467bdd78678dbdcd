// cubic_min_zero: specular lobe x^n as x max(0, 1 - K u)^2, n = 1 to 127, minimax
//
// Made by: brdfgen generate core.toml
// Spec 2f2c78809c9dfeea. Generated; the core is yours to use under any terms.
//
//   in_n      UQ7.0   shininess, 1 to 127; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   wr_addr   UQ7.0   address of the word that is written
//   wr_data   UQ16.0  word for the coefficient memory; layout as in its files
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 10 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.625..+0.750.
//   measured -0.616..+0.746 over all 520319 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   6.806 % absolute, 6.806 % where x^n >= 1/2, 13.124 % relative there.
// As the cosine rises, the output never falls: proved by running all 520192 pairs of neighbouring
//   inputs.

`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module cubic_min_zero_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME    = "cubic_min_zero";
    localparam LATENCY = 10;
    localparam SHOWN   = 10; // mismatches printed; the others are only counted

    // The words that are written to the memory rom, relative to the current directory.
    parameter ROM_FILE = "rom/cubic_min_zero.mem";

    // ------------------------------------------------------------------ the core
    reg         clk       = 1'b0;
    reg         rst       = 1'b0;
    reg         ce        = 1'b0;
    reg         in_valid  = 1'b0;
    reg  [6:0]  in_n      = 0;
    reg  [13:0] in_cos    = 0;
    reg  wr_en = 1'b0;
    reg  [6:0] wr_addr = 0;
    reg  [15:0] wr_data = 0;
    wire        out_valid;
    wire [12:0] out_spec;

    cubic_min_zero dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_n(in_n),
        .in_cos(in_cos),
        .wr_en(wr_en),
        .wr_addr(wr_addr),
        .wr_data(wr_data),
        .out_valid(out_valid),
        .out_spec(out_spec)
    );

    // --------------------------------------------------------- state of the vector file
    localparam LONGEST = 40; // bytes: longer than any line with a vector

    reg [8*1024-1:0]       path;
    integer                file;
    reg [8*LONGEST-1:0]    text;
    integer                length;
    integer                place;     // of the first character of the line not yet used, from 0
    reg [7:0]              character; // the last one used
    reg [7:0]              first;
    reg [35:0]             field;
    integer                digits;
    integer                code;
    reg                    at_end      = 1'b0;
    reg                    line_ended  = 1'b0;
    reg                    malformed   = 1'b0;
    reg                    have_count  = 1'b0;
    reg                    have_vector = 1'b0;
    reg                    failed      = 1'b0;
    integer                line        = 0;
    integer                count       = 0; // vectors the file announces,
    integer                vectors     = 0; // and those read so far
    // Fields of the vector that was read last.
    reg [6:0]  file_in_n;
    reg [13:0] file_in_cos;
    reg [12:0] file_out_spec;
    integer file_idle;
    integer file_stall;

    // -------------------------------------------------------------- random numbers
    // Marsaglia's xorshift32: a linear feedback register of the full period 2^32-1 that turns
    // over 32 bits a step. The seed is fixed, and the VHDL bench draws the same numbers.
    reg [31:0] lfsr = 32'h1badcafe;

    task draw;
        begin
            lfsr = lfsr ^ (lfsr << 13);
            lfsr = lfsr ^ (lfsr >> 17);
            lfsr = lfsr ^ (lfsr << 5);
        end
    endtask

    // ------------------------------------------------------- reference and comparison
    // What the core has taken and not yet given back: one entry for each enabled clock of the
    // latency, as a ring. The entry at `slot` is the one at the core's outputs now; the next
    // enabled clock overwrites it with what the core takes then.
    reg        ref_known     [0:LATENCY-1]; // 0: from before the core was driven
    reg        ref_valid     [0:LATENCY-1];
    reg [6:0]  ref_in_n      [0:LATENCY-1];
    reg [13:0] ref_in_cos    [0:LATENCY-1];
    reg [12:0] ref_out_spec  [0:LATENCY-1];
    integer ref_number [0:LATENCY-1]; // 0: not a vector of the file
    integer slot = 0;
    integer entry;

    // What is presented at the inputs now, beside the inputs themselves.
    integer number = 0;
    reg [12:0] expected_out_spec  = 0;

    reg     looked     = 1'b0; // the entry at the outputs has been looked at,
    reg     reported   = 1'b0; // and found wrong: a held fault is counted once
    reg     wrong      = 1'b0;
    integer compared   = 0;
    integer mismatches = 0;
    integer clocks     = 0;

    // ---------------------------------------------------------------------- loading
    localparam COMPLEMENTS = 64; // vectors for the words' complements
    integer complements = 0; // of these, fed so far,
    integer complements_compared = 0; // and compared
    integer granted = 0; // clocks that the watchdog does not count
    integer at;
    reg [15:0] words_rom [0:127];

    initial begin
        for (entry = 0; entry < LATENCY; entry = entry + 1) begin
            ref_known[entry] = 1'b0;
            ref_valid[entry] = 1'b0;
            ref_number[entry] = 0;
            ref_in_n[entry] = 0;
            ref_in_cos[entry] = 0;
            ref_out_spec[entry] = 0;
        end
        run;
    end

    // Case equality throughout: an X or a Z at an output is a mismatch.
    task check_outputs;
        begin
            wrong = out_valid !== ref_valid[slot];
            if (ref_number[slot] != 0) begin
                if (!looked && ref_number[slot] > 0)
                    compared = compared + 1;
                if (!looked && ref_number[slot] < 0)
                    complements_compared = complements_compared + 1;
                if (out_spec !== ref_out_spec[slot])
                    wrong = 1'b1;
            end
            looked = 1'b1;
            if (ref_known[slot] && wrong && !reported) begin
                reported   = 1'b1;
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    show_mismatch;
            end
        end
    endtask

    task show_mismatch;
        begin
            if (ref_number[slot] == 0)
                $display("brdfgen: %0s: clock %0d: expected out_valid %b, got %b",
                         NAME, clocks, ref_valid[slot], out_valid);
            else begin
                if (ref_number[slot] < 0)
                    $write("brdfgen: %0s: with complemented words, vector %0d: ",
                           NAME, -ref_number[slot]);
                else
                $write("brdfgen: %0s: vector %0d: ", NAME, ref_number[slot]);
                $write("in_n %h, ", ref_in_n[slot]);
                $write("in_cos %h: expected", ref_in_cos[slot]);
                $write(" %h", ref_out_spec[slot]);
                $write(", got");
                if (out_valid === 1'b1) begin
                    $write(" %h", out_spec);
                    $display("");
                end
                else
                    $display(" out_valid %b", out_valid);
            end
        end
    endtask

    // ------------------------------------------------------------------------ clocks
    // One clock. The inputs change while clk is low, so no simulator can see a race. The outputs
    // are looked at just before the rising edge, when the inputs already have their new values:
    // they must still be those of the last edge, whatever ce and the other inputs are.
    task clock;
        begin
            #5;
            check_outputs;
            clk    = 1'b1;
            clocks = clocks + 1;
            if (ce) begin
                ref_known[slot] = 1'b1;
                ref_valid[slot] = in_valid;
                ref_number[slot] = number;
                ref_in_n[slot] = in_n;
                ref_in_cos[slot] = in_cos;
                ref_out_spec[slot] = expected_out_spec;
                slot = (slot == LATENCY - 1) ? 0 : slot + 1;
            end
            if (rst)
                for (entry = 0; entry < LATENCY; entry = entry + 1) begin
                    ref_known[entry]  = 1'b1;
                    ref_valid[entry]  = 1'b0;
                    ref_number[entry] = 0;
                end
            if (ce || rst) begin
                looked   = 1'b0;
                reported = 1'b0;
            end
            #5;
            clk = 1'b0;
            // Only a vector file that asks for absurdly many empty clocks gets here.
            if ((clocks - granted) / 40 > vectors + 250) begin
                $display("brdfgen: %0s: watchdog: %0d clocks for %0d vectors",
                         NAME, clocks, vectors);
                failed = 1'b1;
                conclude;
            end
        end
    endtask

    // Whatever the core must not look at is random.
    task present_garbage;
        input valid;
        begin
            draw;
            in_n = lfsr[6:0];
            draw;
            in_cos = lfsr[13:0];
            wr_en = 1'b0;
            draw;
            wr_addr = lfsr[6:0];
            draw;
            wr_data[15:0] = lfsr[15:0];
            in_valid = valid;
            number = 0;
        end
    endtask

    // A clock with ce low: garbage at all inputs, in_valid too.
    task stalled_clock;
        begin
            draw;
            present_garbage(lfsr[31]);
            ce = 1'b0;
            clock;
            ce = 1'b1;
        end
    endtask

    // One time in eight a stalled clock, then perhaps another.
    task random_stalls;
        begin
            draw;
            while (lfsr[31:29] == 3'd0) begin
                stalled_clock;
                draw;
            end
        end
    endtask

    // An enabled clock that takes no vector.
    task idle_clock;
        begin
            random_stalls;
            present_garbage(1'b0);
            clock;
        end
    endtask

    // The vector that was read last, with the clocks the file asks for before it and random ones.
    task feed_vector;
        begin
            repeat (file_idle)
                idle_clock;
            draw;
            while (lfsr[31:29] == 3'd0) begin
                idle_clock;
                draw;
            end
            repeat (file_stall)
                stalled_clock;
            random_stalls;
            in_valid = 1'b1;
            in_n = file_in_n;
            in_cos = file_in_cos;
            expected_out_spec = file_out_spec;
            number = vectors;
            clock;
        end
    endtask

    // A full pipeline is reset by one clock: nothing that was taken before may come out.
    task reset_phase;
        input enable;
        begin
            ce = 1'b1;
            repeat (LATENCY + 2) begin
                present_garbage(1'b1);
                clock;
            end
            present_garbage(1'b1); // what is presented together with rst is not taken
            rst = 1'b1;
            ce  = enable;
            clock;
            rst = 1'b0;
            ce  = 1'b1;
            repeat (LATENCY) begin
                present_garbage(1'b0);
                clock;
            end
        end
    endtask

    // -------------------------------------------------------------- the vector file
    // Reads a line to `text`, without its line feed or carriage return and line feed. Of a line
    // longer than `text` the rest is dropped: it is a comment, or malformed anyway.
    task read_line;
        begin
            length = $fgets(text, file);
            at_end = (length == 0);
            if (!at_end) begin
                line       = line + 1;
                line_ended = (text[7:0] == 8'h0a);
                while (!line_ended) begin
                    code       = $fgetc(file);
                    line_ended = code == 10 || code == -1;
                end
                if (text[7:0] == 8'h0a) begin
                    text   = text >> 8;
                    length = length - 1;
                end
                if (text[7:0] == 8'h0d) begin
                    text   = text >> 8;
                    length = length - 1;
                end
                // A byte order mark in front of the file is passed over.
                place = 0;
                if (line == 1 && length >= 3 && text[8*(length-1) +: 8] == 8'hef)
                    place = 3;
            end
        end
    endtask

    // The next character of the line, or NUL past its end.
    task next_character;
        begin
            character = 8'h00;
            if (place < length)
                character = text[8*(length-1-place) +: 8];
            place = place + 1;
        end
    endtask

    task read_space;
        begin
            next_character;
            if (character != " ")
                malformed = 1'b1;
        end
    endtask

    // A space and as many hexadecimal digits (lower case) as `width` bits take: a value that fits.
    task read_hex;
        input integer width;
        begin
            read_space;
            field = 36'd0;
            repeat ((width + 3) / 4) begin
                next_character;
                if (character >= "0" && character <= "9")
                    field = {field[31:0], character[3:0]};
                else if (character >= "a" && character <= "f")
                    field = {field[31:0], character[3:0] + 4'd9};
                else
                    malformed = 1'b1;
            end
            if (field >> width != 36'd0)
                malformed = 1'b1;
        end
    endtask

    // A space and a decimal number of one to nine digits, without leading zeros.
    task read_decimal;
        begin
            read_space;
            next_character;
            first  = character;
            field  = 36'd0;
            digits = 0;
            while (character >= "0" && character <= "9" && digits < 9) begin
                field  = 36'd10 * field + {32'd0, character[3:0]};
                digits = digits + 1;
                next_character;
            end
            place = place - 1; // the character behind the number is still to be used
            if (digits == 0 || (digits > 1 && first == "0"))
                malformed = 1'b1;
        end
    endtask

    task expect_line_end;
        begin
            if (place != length)
                malformed = 1'b1;
        end
    endtask

    task read_count;
        begin
            read_decimal;
            count = {1'b0, field[30:0]};
            expect_line_end;
            if (have_count)
                malformed = 1'b1;
            have_count = 1'b1;
        end
    endtask

    task read_fields;
        begin
            read_hex(7);
            file_in_n = field[6:0];
            read_hex(14);
            file_in_cos = field[13:0];
            read_hex(13);
            file_out_spec = field[12:0];
            read_decimal;
            file_idle = {1'b0, field[30:0]};
            read_decimal;
            file_stall = {1'b0, field[30:0]};
            expect_line_end;
            if (!have_count)
                malformed = 1'b1;
            have_vector = !malformed;
        end
    endtask

    // Reads on to the next vector. have_vector is 0 if there is none, or a line is malformed.
    task read_vector;
        begin
            have_vector = 1'b0;
            read_line;
            while (!at_end && !malformed && !have_vector) begin
                next_character;
                case (character)
                    "#", "d": ; // comments and digests
                    "c": read_count;
                    "v": read_fields;
                    default: malformed = 1'b1;
                endcase
                if (malformed) begin
                    $display("brdfgen: %0s: %0s:%0d: malformed line", NAME, path, line);
                    failed = 1'b1;
                end
                else if (!have_vector)
                    read_line;
            end
            if (have_vector)
                vectors = vectors + 1;
        end
    endtask

    // ----------------------------------------------------------------------- the run
    // The memories' words, from their files.
    task read_words;
        begin
            file = $fopen(ROM_FILE, "r");
            if (file == 0) begin
                $display("brdfgen: %0s: cannot open %0s", NAME, ROM_FILE);
                failed = 1'b1;
            end
            else begin
                $fclose(file);
                $readmemh(ROM_FILE, words_rom);
                if (^words_rom[127] === 1'bx) begin
                    $display("brdfgen: %0s: %0s has too few words", NAME, ROM_FILE);
                    failed = 1'b1;
                end
            end
        end
    endtask

    // Writes every word of the memories, or its complement. Neither ce nor rst must matter.
    task load;
        input complement;
        begin
            for (at = 0; at < 128; at = at + 1) begin
                present_garbage(1'b0);
                draw;
                ce  = lfsr[31];
                rst = lfsr[30];
                wr_en = 1'b1;
                wr_addr = at[6:0];
                wr_data = words_rom[at] ^ {16{complement}};
                granted = granted + 1;
                clock;
            end
            present_garbage(1'b0);
            ce  = 1'b1;
            rst = 1'b0;
        end
    endtask

    // A vector for the words' complements.
    task feed_complement;
        input [6:0]  of_in_n;
        input [13:0] of_in_cos;
        input [12:0] of_out_spec;
        begin
            idle_clock;
            random_stalls;
            in_valid = 1'b1;
            in_n = of_in_n;
            in_cos = of_in_cos;
            expected_out_spec = of_out_spec;
            complements = complements + 1;
            number = -complements;
            clock;
        end
    endtask

    task feed_complements;
        begin
            feed_complement(7'h00, 14'h0800, 13'h0000);
            feed_complement(7'h02, 14'h0800, 13'h0000);
            feed_complement(7'h04, 14'h0801, 13'h0000);
            feed_complement(7'h06, 14'h0f97, 13'h05cb);
            feed_complement(7'h08, 14'h0c00, 13'h0000);
            feed_complement(7'h0a, 14'h0d44, 13'h0000);
            feed_complement(7'h0c, 14'h0dae, 13'h0000);
            feed_complement(7'h0e, 14'h0ce3, 13'h0000);
            feed_complement(7'h10, 14'h0efe, 13'h0776);
            feed_complement(7'h12, 14'h0f60, 13'h0bb6);
            feed_complement(7'h14, 14'h0e68, 13'h09a3);
            feed_complement(7'h16, 14'h0ea0, 13'h0da0);
            feed_complement(7'h18, 14'h0fdf, 13'h0eee);
            feed_complement(7'h1a, 14'h0fe7, 13'h0f40);
            feed_complement(7'h1c, 14'h0eb2, 13'h0853);
            feed_complement(7'h1e, 14'h0f36, 13'h0b76);
            feed_complement(7'h20, 14'h0efe, 13'h0aee);
            feed_complement(7'h22, 14'h0ed1, 13'h0ad3);
            feed_complement(7'h24, 14'h0fc7, 13'h0f14);
            feed_complement(7'h26, 14'h0f5c, 13'h0ddc);
            feed_complement(7'h28, 14'h0fb1, 13'h0f27);
            feed_complement(7'h2a, 14'h0fa4, 13'h0f43);
            feed_complement(7'h2c, 14'h0fb1, 13'h0f94);
            feed_complement(7'h2e, 14'h0fe5, 13'h0f7d);
            feed_complement(7'h30, 14'h0fd0, 13'h0f21);
            feed_complement(7'h32, 14'h0a15, 13'h012e);
            feed_complement(7'h34, 14'h0f5b, 13'h0d56);
            feed_complement(7'h36, 14'h0fc1, 13'h0efd);
            feed_complement(7'h38, 14'h0f3c, 13'h0d1c);
            feed_complement(7'h3a, 14'h0ff7, 13'h0fde);
            feed_complement(7'h3c, 14'h0d33, 13'h07c1);
            feed_complement(7'h3e, 14'h0ffc, 13'h0ff2);
            feed_complement(7'h40, 14'h0f4b, 13'h0dc5);
            feed_complement(7'h42, 14'h0f9a, 13'h0ec8);
            feed_complement(7'h44, 14'h0fcf, 13'h0f71);
            feed_complement(7'h46, 14'h0f9e, 13'h0ef6);
            feed_complement(7'h48, 14'h0f7a, 13'h0ead);
            feed_complement(7'h4a, 14'h0ff0, 13'h0fd9);
            feed_complement(7'h4c, 14'h0fd6, 13'h0fa2);
            feed_complement(7'h4e, 14'h0fe6, 13'h0fca);
            feed_complement(7'h50, 14'h0fae, 13'h0f67);
            feed_complement(7'h52, 14'h0fc8, 13'h0fa1);
            feed_complement(7'h54, 14'h0f96, 13'h0f5f);
            feed_complement(7'h56, 14'h0ff7, 13'h0ff4);
            feed_complement(7'h58, 14'h0fe7, 13'h0fe3);
            feed_complement(7'h5a, 14'h0fca, 13'h0fca);
            feed_complement(7'h5c, 14'h0ffb, 13'h0ff1);
            feed_complement(7'h5e, 14'h0ffe, 13'h0ffa);
            feed_complement(7'h60, 14'h0fd4, 13'h0f83);
            feed_complement(7'h62, 14'h0ffb, 13'h0ff2);
            feed_complement(7'h64, 14'h0f9f, 13'h0ef9);
            feed_complement(7'h66, 14'h0fea, 13'h0fc4);
            feed_complement(7'h68, 14'h0ff7, 13'h0fe8);
            feed_complement(7'h6a, 14'h0f9e, 13'h0f02);
            feed_complement(7'h6c, 14'h0fe4, 13'h0fb8);
            feed_complement(7'h6e, 14'h0fdb, 13'h0fa2);
            feed_complement(7'h70, 14'h0f95, 13'h0ef9);
            feed_complement(7'h72, 14'h0faa, 13'h0f30);
            feed_complement(7'h74, 14'h0ffd, 13'h0ff9);
            feed_complement(7'h76, 14'h02a4, 13'h007a);
            feed_complement(7'h78, 14'h0fce, 13'h0f8d);
            feed_complement(7'h7a, 14'h0ffe, 13'h0ffc);
            feed_complement(7'h7c, 14'h0fb6, 13'h0f5c);
            feed_complement(7'h7e, 14'h0fa3, 13'h0f37);
        end
    endtask

    // All vectors of the file; behind them the pipeline is empty.
    task run_vectors;
        begin
            granted    = clocks;
            line       = 0;
            have_count = 1'b0;
            count      = 0;
            vectors    = 0;
            compared   = 0;
            file = $fopen(path, "r");
            if (file == 0) begin
                $display("brdfgen: %0s: cannot open %0s", NAME, path);
                failed = 1'b1;
            end
            else begin
                read_vector;
                while (have_vector) begin
                    feed_vector;
                    read_vector;
                end
                $fclose(file);
                empty_pipeline;
            end
        end
    endtask

    task empty_pipeline;
        repeat (LATENCY + 2)
            idle_clock;
    endtask

    // The core as it comes up, with complements in its memories, and with the right words again.
    task run;
        begin
            if (!$value$plusargs("golden=%s", path))
                path = "golden/cubic_min_zero.vec";
            reset_phase(1'b1);
            reset_phase(1'b0);
            run_vectors;
            if (!failed && compared != count) begin
                $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
                failed = 1'b1;
            end
            read_words;
            if (!failed) begin
                load(1'b1);
                feed_complements;
                empty_pipeline;
                load(1'b0);
                run_vectors;
            end
            conclude;
        end
    endtask

    // The verdict is the last line that is printed: hence no $finish after a PASS, before which
    // some simulators print one of their own. This bench makes the clock, so that the simulation
    // ends when it does no more.
    task conclude;
        begin
            if (!failed && compared != count)
                $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
            if (!failed && (COMPLEMENTS == 0 || complements_compared != COMPLEMENTS)) begin
                $display("brdfgen: %0s: %0d of %0d vectors compared with complemented words",
                         NAME, complements_compared, COMPLEMENTS);
                failed = 1'b1;
            end
            if (failed || mismatches != 0 || compared == 0 || compared != count) begin
                $display("brdfgen: %0s: %0d vectors compared, %0d mismatches: FAIL",
                         NAME, compared, mismatches);
`ifdef __ICARUS__
                $finish_and_return(1);
`else
`ifdef VERILATOR
                $c("std::exit(1);"); // $stop would print after the verdict
`else
                $stop;
`endif
`endif
            end
            else
                $display("brdfgen: %0s: %0d vectors compared, %0d mismatches: PASS",
                         NAME, compared, mismatches);
        end
    endtask

endmodule

`default_nettype wire
