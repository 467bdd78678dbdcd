// log_exp: specular lobe x^n as 2^(-n L(x)), L = -log2 x, n = 1 to 63
//
// Made by: brdfgen generate core.toml
// Spec 1c52e369b64c704a. Generated; the core is yours to use under any terms.
//
//   in_n      UQ6.2   shininess, 1 to 63 in steps of 2^-2; outside: the nearest end
//   in_cos    Q1.12   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.12  the lobe, 0 to 1; 1.0 is exact
//
// Latency 14 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.886..+0.988.
//   measured -0.629..+0.743 over all 1020153 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   0.01815 % absolute, 0.01815 % where x^n >= 1/2, 0.03395 % relative there.
// As the cosine rises, the output never falls: proved by running all 1019904 pairs of neighbouring
//   inputs.

`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module log_exp_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME    = "log_exp";
    localparam LATENCY = 14;
    localparam SHOWN   = 10; // mismatches printed; the others are only counted

    // ------------------------------------------------------------------ the core
    reg         clk       = 1'b0;
    reg         rst       = 1'b0;
    reg         ce        = 1'b0;
    reg         in_valid  = 1'b0;
    reg  [7:0]  in_n      = 0;
    reg  [13:0] in_cos    = 0;
    wire        out_valid;
    wire [12:0] out_spec;

    log_exp dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_n(in_n),
        .in_cos(in_cos),
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
    reg [7:0]  file_in_n;
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
    reg [7:0]  ref_in_n      [0:LATENCY-1];
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
                if (!looked)
                    compared = compared + 1;
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
            if (clocks / 40 > vectors + 250) begin
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
            in_n = lfsr[7:0];
            draw;
            in_cos = lfsr[13:0];
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
            read_hex(8);
            file_in_n = field[7:0];
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
    task run;
        begin
            if (!$value$plusargs("golden=%s", path))
                path = "golden/log_exp.vec";
            file = $fopen(path, "r");
            if (file == 0) begin
                $display("brdfgen: %0s: cannot open %0s", NAME, path);
                failed = 1'b1;
                conclude;
            end
            else begin
                reset_phase(1'b1);
                reset_phase(1'b0);
                read_vector;
                while (have_vector) begin
                    feed_vector;
                    read_vector;
                end
                $fclose(file);
                // The last vector, and the end of valid behind it.
                repeat (LATENCY + 2)
                    idle_clock;
                conclude;
            end
        end
    endtask

    // The verdict is the last line that is printed: hence no $finish after a PASS, before which
    // some simulators print one of their own. This bench makes the clock, so that the simulation
    // ends when it does no more.
    task conclude;
        begin
            if (!failed && compared != count)
                $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
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
