// log_exp_9_axis: AXI4-Stream interfaces for the core log_exp_9
//
// Made by: brdfgen generate core.toml
// Spec 608aa1feabb28d90. Generated; the wrapper is yours to use under any terms.
//
// s_axis_tdata, 3 bytes:
//   [7:0]  in_n   UQ8.0 shininess, 1 to 255; outside: the nearest end
//   [23:8] in_cos Q1.14 cosine x; below 0 gives 0, above 1 counts as 1
//
// m_axis_tdata, 2 bytes:
//   [14:0] out_spec UQ1.14 the lobe, 0 to 1; 1.0 is exact
//   [15]   0
//
// tlast and tuser stay with their beat. tkeep and tstrb are not needed: a beat is always whole.
// Latency 12 clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and
// m_axis_tready leads to registers only.

`default_nettype none
`timescale 1ns/1ps

module log_exp_9_axis_tb;

    localparam NAME    = "log_exp_9_axis";
    localparam LATENCY = 12;
    localparam SHOWN   = 10; // faults printed; the others are only counted

    // --------------------------------------------------------------------- the wrapper
    localparam BEAT = 18; // bits of tuser, tlast and tdata of a result

    reg  aclk = 1'b0;
    reg  aresetn = 1'b1;
    reg  [23:0] s_axis_tdata = 0;
    reg  s_axis_tvalid = 1'b0;
    wire s_axis_tready;
    reg  s_axis_tlast = 1'b0;
    reg  [0:0] s_axis_tuser = 0;
    wire [15:0] m_axis_tdata;
    wire m_axis_tvalid;
    reg  m_axis_tready = 1'b0;
    wire m_axis_tlast;
    wire [0:0] m_axis_tuser;

    log_exp_9_axis dut (
        .aclk(aclk),
        .aresetn(aresetn),
        .s_axis_tdata(s_axis_tdata),
        .s_axis_tvalid(s_axis_tvalid),
        .s_axis_tready(s_axis_tready),
        .s_axis_tlast(s_axis_tlast),
        .s_axis_tuser(s_axis_tuser),
        .m_axis_tdata(m_axis_tdata),
        .m_axis_tvalid(m_axis_tvalid),
        .m_axis_tready(m_axis_tready),
        .m_axis_tlast(m_axis_tlast),
        .m_axis_tuser(m_axis_tuser)
    );

    wire [BEAT-1:0] shown = {m_axis_tuser, m_axis_tlast, m_axis_tdata};

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
    reg [15:0] file_in_cos;
    reg [14:0] file_out_spec;

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
    // The beats under way, as a ring: what is due at the sink. The wrapper holds at most one
    // more than its core.
    localparam PLACES = LATENCY + 2;
    reg [BEAT-1:0] due        [0:PLACES-1];
    integer        due_number [0:PLACES-1]; // 0: not a vector of the file
    integer        oldest    = 0;
    integer        under_way = 0;

    // What is offered now, beside the source's signals themselves, and what the sink will say.
    reg [15:0] expected = 0;
    integer     number     = 0;
    reg         sink_ready = 1'b0;

    // How often, of eight clocks, the source offers a beat and the sink takes one.
    reg [3:0]   source_rate = 4'd8;
    reg [3:0]   sink_rate   = 4'd8;

    reg            known        = 1'b0; // the wrapper has been reset
    reg            held         = 1'b0; // a beat was not taken at the last clock,
    reg [BEAT-1:0] held_beat    = 0;    // and must still be there
    reg            was_ready    = 1'b0; // the sink was ready at the last clock
    reg            early_tready = 1'b0;
    reg            early_tvalid = 1'b0;
    reg            accepted     = 1'b0;
    reg            taken        = 1'b0;
    integer        compared     = 0;
    integer        mismatches   = 0;
    integer        clocks       = 0;
    integer        quiet        = 0; // clocks since a beat was accepted or taken
    integer        first_in     = 0; // the clock at which the first vector was accepted,
    integer        last_out     = 0; // and that at which the last was taken

    initial run;

    // A fault at this clock.
    task fault;
        input [8*64-1:0] what;
        begin
            mismatches = mismatches + 1;
            if (mismatches <= SHOWN)
                $display("brdfgen: %0s: clock %0d: %0s", NAME, clocks, what);
        end
    endtask

    // Case equality throughout: an X or a Z at an output is a fault.
    task check;
        begin
            if (s_axis_tready !== early_tready || m_axis_tvalid !== early_tvalid)
                fault("an output follows m_axis_tready within the clock");
            if (^{s_axis_tready, m_axis_tvalid} === 1'bx)
                fault("s_axis_tready or m_axis_tvalid is unknown");
            if (held && m_axis_tvalid !== 1'b1)
                fault("a beat went before it was taken");
            else if (held && shown !== held_beat)
                fault("a beat changed before it was taken");
            // Full throughput: the source never waits for more than the sink, and a full
            // pipeline has a beat to give at every clock.
            if (was_ready && s_axis_tready !== 1'b1)
                fault("s_axis_tready is low, and the sink was ready");
            if (under_way >= LATENCY && m_axis_tvalid !== 1'b1)
                fault("a full pipeline gives no beat");
            if (m_axis_tvalid === 1'b1) begin
                if (under_way == 0)
                    fault("a beat that nobody sent");
                else if (!held && shown !== due[oldest])
                    show_mismatch;
            end
        end
    endtask

    task show_mismatch;
        begin
            mismatches = mismatches + 1;
            if (mismatches <= SHOWN)
                $display("brdfgen: %0s: vector %0d: due tuser, tlast, tdata %h %b %h, got %h %b %h",
                         NAME, due_number[oldest],
                         due[oldest][BEAT-1:17],
                         due[oldest][16],
                         due[oldest][15:0],
                         m_axis_tuser, m_axis_tlast, m_axis_tdata);
        end
    endtask

    // ------------------------------------------------------------------------ clocks
    // One clock. The inputs change while aclk is low, so no simulator can see a race. The sink
    // first says the opposite of what it will say at the rising edge.
    task clock;
        begin
            draw;
            sink_ready = {1'b0, lfsr[31:29]} < sink_rate;
            m_axis_tready = ~sink_ready;
            #2;
            early_tready = s_axis_tready;
            early_tvalid = m_axis_tvalid;
            m_axis_tready = sink_ready;
            #3;
            if (known)
                check;
            taken    = aresetn && m_axis_tvalid === 1'b1 && sink_ready;
            accepted = aresetn && s_axis_tvalid && s_axis_tready === 1'b1;
            held      = aresetn && m_axis_tvalid === 1'b1 && !sink_ready;
            held_beat = shown;
            was_ready = aresetn && known && sink_ready;
            aclk   = 1'b1;
            clocks = clocks + 1;
            quiet  = quiet + 1;
            if (taken && under_way != 0)
                take;
            if (accepted)
                accept;
            if (!aresetn) begin
                known     = 1'b1;
                under_way = 0;
            end
            #5;
            aclk = 1'b0;
            if (quiet > 2000) begin
                $display("brdfgen: %0s: clock %0d: nothing moves any more", NAME, clocks);
                failed = 1'b1;
                conclude;
            end
        end
    endtask

    task take;
        begin
            if (due_number[oldest] > 0) begin
                compared = compared + 1;
                last_out = clocks;
            end
            oldest    = (oldest == PLACES - 1) ? 0 : oldest + 1;
            under_way = under_way - 1;
            quiet     = 0;
        end
    endtask

    task accept;
        begin
            if (under_way == PLACES && known)
                fault("more beats are accepted than the wrapper can hold");
            if (under_way < PLACES) begin
                due[(oldest + under_way) % PLACES]        = {s_axis_tuser, s_axis_tlast, expected};
                due_number[(oldest + under_way) % PLACES] = number;
                under_way = under_way + 1;
            end
            if (number == 1)
                first_in = clocks;
            quiet = 0;
        end
    endtask

    // Whatever the wrapper must not look at is random.
    task present_garbage;
        input valid;
        begin
            draw;
            s_axis_tdata[23:0] = lfsr[23:0];
            draw;
            s_axis_tlast = lfsr[31];
            s_axis_tuser[0:0] = lfsr[0:0];
            s_axis_tvalid = valid;
            number = 0;
        end
    endtask

    task idle_clock;
        begin
            present_garbage(1'b0);
            clock;
        end
    endtask



    // Offers the vector that was read last until it is accepted; before it, as many idle clocks as
    // the source's rate gives. What no port takes of tdata is random, and so are tlast and tuser.
    task send;
        input integer of_number;
        begin
            draw;
            while ({1'b0, lfsr[31:29]} >= source_rate) begin
                idle_clock;
                draw;
            end
            present_garbage(1'b1);
            s_axis_tdata[7:0] = file_in_n;
            s_axis_tdata[23:8] = file_in_cos;
            expected = 0;
            expected[14:0] = file_out_spec;
            number   = of_number;
            accepted = 1'b0;
            while (!accepted && !failed)
                clock;
            s_axis_tvalid = 1'b0;
        end
    endtask

    // Nothing is under way any more, and nothing more comes.
    task drain;
        begin
            while (under_way != 0 && !failed)
                idle_clock;
            repeat (LATENCY + 2)
                idle_clock;
        end
    endtask

    // A full wrapper is reset by one clock: nothing that was accepted before may come out. The
    // sink stands still or takes beats.
    task reset_phase;
        input [3:0] rate;
        begin
            sink_rate = rate;
            repeat (LATENCY + 4) begin
                present_garbage(1'b1);
                clock_of_garbage;
            end
            present_garbage(1'b1); // what is presented together with reset is not accepted
            aresetn = 1'b0;
            clock;
            aresetn = 1'b1;
            sink_rate = 4'd8;
            repeat (LATENCY + 2)
                idle_clock;
        end
    endtask

    // A clock at which a beat may be accepted whose result is not known: only that it comes
    // and is stable is checked.
    task clock_of_garbage;
        begin
            known = 1'b0;
            clock;
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
            read_hex(16);
            file_in_cos = field[15:0];
            read_hex(15);
            file_out_spec = field[14:0];
            // How long the core's own bench waits before the vector.
            read_decimal;
            read_decimal;
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

    // How often the source and the sink of the vectors of a block of 32 are ready.
    task choose_rates;
        case ((vectors / 32) % 6)
            0: begin source_rate = 4'd8; sink_rate = 4'd4; end
            1: begin source_rate = 4'd4; sink_rate = 4'd8; end
            2: begin source_rate = 4'd4; sink_rate = 4'd4; end
            3: begin source_rate = 4'd8; sink_rate = 4'd1; end
            4: begin source_rate = 4'd2; sink_rate = 4'd7; end
            default: begin source_rate = 4'd7; sink_rate = 4'd7; end
        endcase
    endtask

    // All vectors of the file, with stalls of both sides or without; behind them the pipeline is
    // empty.
    task run_vectors;
        input stalls;
        begin
            source_rate = 4'd8;
            sink_rate   = 4'd8;
            line        = 0;
            have_count  = 1'b0;
            count       = 0;
            vectors     = 0;
            compared    = 0;
            file = $fopen(path, "r");
            if (file == 0) begin
                $display("brdfgen: %0s: cannot open %0s", NAME, path);
                failed = 1'b1;
            end
            else begin
                read_vector;
                while (have_vector && !failed) begin
                    if (stalls)
                        choose_rates;
                    send(vectors);
                    read_vector;
                end
                $fclose(file);
                drain;
                if (!failed && compared != count) begin
                    $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
                    failed = 1'b1;
                end
                if (!failed && !stalls && last_out - first_in != count - 1 + LATENCY) begin
                    $display("brdfgen: %0s: %0d vectors took %0d clocks without a stall, not %0d",
                             NAME, count, last_out - first_in, count - 1 + LATENCY);
                    failed = 1'b1;
                end
            end
        end
    endtask

    task run;
        begin
            if (!$value$plusargs("golden=%s", path))
                path = "golden/log_exp_9.vec";
            reset_phase(4'd8);
            reset_phase(4'd0);
            reset_phase(4'd4);
            if (!failed)
                run_vectors(1'b0);
            if (!failed)
                run_vectors(1'b1);
            conclude;
        end
    endtask

    // The verdict is the last line that is printed: hence no $finish after a PASS, before which
    // some simulators print one of their own. This bench makes the clock, so that the simulation
    // ends when it does no more.
    task conclude;
        begin
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
