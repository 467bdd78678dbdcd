// cubic_paper: specular lobe x^n as x(1 - u(A - a u)), cut, n = 1 to 1000, paper form
//
// Made by: brdfgen generate --method cubic --shininess 1..=1000 --form paper
// Spec 16918f4592c43deb. Generated; the core is yours to use under any terms.
//
//   in_n      UQ10.0  shininess, 1 to 1000; outside: the nearest end
//   in_cos    Q1.16   cosine x; below 0 gives 0, above 1 counts as 1
//   out_spec  UQ1.16  0 to 1
//
// Latency 6 clocks, one result a clock.
// Error against the real-valued method, in ulps of out_spec: proved within -0.929..+0.623.
//   measured -0.898..+0.566 over all 65537000 inputs in [0, 1].
// Error against x^n itself, measured over the same inputs:
//   22.797 % absolute, 0.552 % where x^n >= 1/2, 0.701 % relative there.

`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module cubic_paper_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME          = "cubic_paper";
    localparam LATENCY       = 6;
    localparam INDEX_BITS    = 10;
    localparam OPERAND_BITS  = 18;
    localparam OUTPUT_BITS   = 17;
    localparam SHOWN         = 10; // mismatches printed; the others are only counted

    // ------------------------------------------------------------------ the core
    reg                     clk      = 1'b0;
    reg                     rst      = 1'b0;
    reg                     ce       = 1'b0;
    reg                     in_valid = 1'b0;
    reg  [INDEX_BITS-1:0]   in_n     = 0;
    reg  [OPERAND_BITS-1:0] operand  = 0;
    wire                    out_valid;
    wire [OUTPUT_BITS-1:0]  out_spec;

    cubic_paper dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_n(in_n),
        .in_cos(operand),
        .out_valid(out_valid),
        .out_spec(out_spec)
    );

    // --------------------------------------------------------- state of the vector file
    localparam LINE_BYTES = 64; // a line of vectors has at most 52 characters

    reg [8*1024-1:0]       path;
    integer                file;
    reg [8*LINE_BYTES-1:0] text;
    reg [8*LINE_BYTES-1:0] padded;
    reg [8*LINE_BYTES-1:0] again;
    integer                length;
    integer                fields;
    integer                code;
    reg [7:0]              kind;
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
    reg [INDEX_BITS-1:0]   file_n;
    reg [OPERAND_BITS-1:0] file_operand;
    reg [OUTPUT_BITS-1:0]  file_expected;
    integer                file_idle;
    integer                file_stall;

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
    reg                    ref_known    [0:LATENCY-1]; // 0: from before the core was driven
    reg                    ref_valid    [0:LATENCY-1];
    integer                ref_number   [0:LATENCY-1]; // 0: not a vector of the file
    reg [INDEX_BITS-1:0]   ref_n        [0:LATENCY-1];
    reg [OPERAND_BITS-1:0] ref_operand  [0:LATENCY-1];
    reg [OUTPUT_BITS-1:0]  ref_expected [0:LATENCY-1];
    integer                slot = 0;
    integer                entry;

    // What is presented at the inputs now, beside the inputs themselves.
    integer                number   = 0;
    reg [OUTPUT_BITS-1:0]  expected = 0;

    reg     looked     = 1'b0; // the entry at the outputs has been looked at,
    reg     reported   = 1'b0; // and found wrong: a held fault is counted once
    reg     wrong      = 1'b0;
    integer compared   = 0;
    integer mismatches = 0;
    integer clocks     = 0;

    initial begin
        for (entry = 0; entry < LATENCY; entry = entry + 1) begin
            ref_known[entry]    = 1'b0;
            ref_valid[entry]    = 1'b0;
            ref_number[entry]   = 0;
            ref_n[entry]        = 0;
            ref_operand[entry]  = 0;
            ref_expected[entry] = 0;
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
                if (out_spec !== ref_expected[slot])
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
                $write("brdfgen: %0s: vector %0d: in_n %h, in_cos %h: ",
                       NAME, ref_number[slot], ref_n[slot], ref_operand[slot]);
                if (out_valid === 1'b1)
                    $display("expected %h, got %h", ref_expected[slot], out_spec);
                else
                    $display("expected %h, got out_valid %b", ref_expected[slot], out_valid);
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
                ref_known[slot]    = 1'b1;
                ref_valid[slot]    = in_valid;
                ref_number[slot]   = number;
                ref_n[slot]        = in_n;
                ref_operand[slot]  = operand;
                ref_expected[slot] = expected;
                slot               = (slot == LATENCY - 1) ? 0 : slot + 1;
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
            in_n     = lfsr[INDEX_BITS-1:0];
            draw;
            operand  = lfsr[OPERAND_BITS-1:0];
            in_valid = valid;
            number   = 0;
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
            in_n     = file_n;
            operand  = file_operand;
            expected = file_expected;
            number   = vectors;
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
                kind       = text[8*(length-1) +: 8];
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
                // $sscanf skips blanks before the first field, but not NULs in every simulator.
                padded = text | ({LINE_BYTES{8'h20}} << 8*length);
            end
        end
    endtask

    task read_count;
        begin
            fields = $sscanf(padded, " c %d", count);
            $sformat(again, "c %0d", count);
            malformed = fields != 1 || again != text || count < 0 || have_count;
            have_count = 1'b1;
        end
    endtask

    // $sscanf takes a short field for a whole one, several spaces for one, and an x for a digit.
    // So the line must be what these fields are written as.
    task read_fields;
        begin
            fields = $sscanf(padded, " v %h %h %h %d %d",
                             file_n, file_operand, file_expected, file_idle, file_stall);
            $sformat(again, "v %h %h %h %0d %0d",
                     file_n, file_operand, file_expected, file_idle, file_stall);
            malformed = fields != 5 || again != text || file_idle < 0 || file_stall < 0 ||
                        ^{file_n, file_operand, file_expected} === 1'bx || !have_count;
            have_vector = !malformed;
        end
    endtask

    // Reads on to the next vector. have_vector is 0 if there is none, or a line is malformed.
    task read_vector;
        begin
            have_vector = 1'b0;
            read_line;
            while (!at_end && !malformed && !have_vector) begin
                case (kind)
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
                path = "golden/cubic_paper.vec";
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
