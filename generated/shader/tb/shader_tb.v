// shader: Phong shader, 2 lights, 4 materials, 8 bits a channel
//
// Made by: brdfgen generate core.toml
// Spec ef73cb5e346c03ce. Generated; the core is yours to use under any terms.
//
//   in_material UQ2.0   index of the material, 0 to 3; above: the last
//   in_nx       Q1.16   x of the normal N, of unit length
//   in_ny       Q1.16   y of the normal N, of unit length
//   in_nz       Q1.16   z of the normal N, of unit length
//   in_vx       Q1.16   x of the unit vector V to the viewer
//   in_vy       Q1.16   y of the unit vector V to the viewer
//   in_vz       Q1.16   z of the unit vector V to the viewer
//   in_l1x      Q1.16   x of the unit vector L to light 1
//   in_l1y      Q1.16   y of the unit vector L to light 1
//   in_l1z      Q1.16   z of the unit vector L to light 1
//   in_l2x      Q1.16   x of the unit vector L to light 2
//   in_l2y      Q1.16   y of the unit vector L to light 2
//   in_l2z      Q1.16   z of the unit vector L to light 2
//   out_r       UQ8.0   red; 255 is full scale
//   out_g       UQ8.0   green; 255 is full scale
//   out_b       UQ8.0   blue; 255 is full scale
//
// Latency 16 clocks, one result a clock.
// Error against the exact shader, in codes of a channel, over 262144 samples:
//   -61.201..+5.929, root mean square 8.984.

`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module shader_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME    = "shader";
    localparam LATENCY = 16;
    localparam SHOWN   = 10; // mismatches printed; the others are only counted

    // ------------------------------------------------------------------ the core
    reg         clk         = 1'b0;
    reg         rst         = 1'b0;
    reg         ce          = 1'b0;
    reg         in_valid    = 1'b0;
    reg  [1:0]  in_material = 0;
    reg  [17:0] in_nx       = 0;
    reg  [17:0] in_ny       = 0;
    reg  [17:0] in_nz       = 0;
    reg  [17:0] in_vx       = 0;
    reg  [17:0] in_vy       = 0;
    reg  [17:0] in_vz       = 0;
    reg  [17:0] in_l1x      = 0;
    reg  [17:0] in_l1y      = 0;
    reg  [17:0] in_l1z      = 0;
    reg  [17:0] in_l2x      = 0;
    reg  [17:0] in_l2y      = 0;
    reg  [17:0] in_l2z      = 0;
    wire        out_valid;
    wire [7:0]  out_r;
    wire [7:0]  out_g;
    wire [7:0]  out_b;

    shader dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_material(in_material),
        .in_nx(in_nx),
        .in_ny(in_ny),
        .in_nz(in_nz),
        .in_vx(in_vx),
        .in_vy(in_vy),
        .in_vz(in_vz),
        .in_l1x(in_l1x),
        .in_l1y(in_l1y),
        .in_l1z(in_l1z),
        .in_l2x(in_l2x),
        .in_l2y(in_l2y),
        .in_l2z(in_l2z),
        .out_valid(out_valid),
        .out_r(out_r),
        .out_g(out_g),
        .out_b(out_b)
    );

    // --------------------------------------------------------- state of the vector file
    localparam LONGEST = 112; // bytes: longer than any line with a vector

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
    reg [1:0]  file_in_material;
    reg [17:0] file_in_nx;
    reg [17:0] file_in_ny;
    reg [17:0] file_in_nz;
    reg [17:0] file_in_vx;
    reg [17:0] file_in_vy;
    reg [17:0] file_in_vz;
    reg [17:0] file_in_l1x;
    reg [17:0] file_in_l1y;
    reg [17:0] file_in_l1z;
    reg [17:0] file_in_l2x;
    reg [17:0] file_in_l2y;
    reg [17:0] file_in_l2z;
    reg [7:0]  file_out_r;
    reg [7:0]  file_out_g;
    reg [7:0]  file_out_b;
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
    reg        ref_known       [0:LATENCY-1]; // 0: from before the core was driven
    reg        ref_valid       [0:LATENCY-1];
    reg [1:0]  ref_in_material [0:LATENCY-1];
    reg [17:0] ref_in_nx       [0:LATENCY-1];
    reg [17:0] ref_in_ny       [0:LATENCY-1];
    reg [17:0] ref_in_nz       [0:LATENCY-1];
    reg [17:0] ref_in_vx       [0:LATENCY-1];
    reg [17:0] ref_in_vy       [0:LATENCY-1];
    reg [17:0] ref_in_vz       [0:LATENCY-1];
    reg [17:0] ref_in_l1x      [0:LATENCY-1];
    reg [17:0] ref_in_l1y      [0:LATENCY-1];
    reg [17:0] ref_in_l1z      [0:LATENCY-1];
    reg [17:0] ref_in_l2x      [0:LATENCY-1];
    reg [17:0] ref_in_l2y      [0:LATENCY-1];
    reg [17:0] ref_in_l2z      [0:LATENCY-1];
    reg [7:0]  ref_out_r       [0:LATENCY-1];
    reg [7:0]  ref_out_g       [0:LATENCY-1];
    reg [7:0]  ref_out_b       [0:LATENCY-1];
    integer ref_number [0:LATENCY-1]; // 0: not a vector of the file
    integer slot = 0;
    integer entry;

    // What is presented at the inputs now, beside the inputs themselves.
    integer number = 0;
    reg [7:0]  expected_out_r       = 0;
    reg [7:0]  expected_out_g       = 0;
    reg [7:0]  expected_out_b       = 0;

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
            ref_in_material[entry] = 0;
            ref_in_nx[entry] = 0;
            ref_in_ny[entry] = 0;
            ref_in_nz[entry] = 0;
            ref_in_vx[entry] = 0;
            ref_in_vy[entry] = 0;
            ref_in_vz[entry] = 0;
            ref_in_l1x[entry] = 0;
            ref_in_l1y[entry] = 0;
            ref_in_l1z[entry] = 0;
            ref_in_l2x[entry] = 0;
            ref_in_l2y[entry] = 0;
            ref_in_l2z[entry] = 0;
            ref_out_r[entry] = 0;
            ref_out_g[entry] = 0;
            ref_out_b[entry] = 0;
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
                if (out_r !== ref_out_r[slot])
                    wrong = 1'b1;
                if (out_g !== ref_out_g[slot])
                    wrong = 1'b1;
                if (out_b !== ref_out_b[slot])
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
                $write("in_material %h, ", ref_in_material[slot]);
                $write("in_nx %h, ", ref_in_nx[slot]);
                $write("in_ny %h, ", ref_in_ny[slot]);
                $write("in_nz %h, ", ref_in_nz[slot]);
                $write("in_vx %h, ", ref_in_vx[slot]);
                $write("in_vy %h, ", ref_in_vy[slot]);
                $write("in_vz %h, ", ref_in_vz[slot]);
                $write("in_l1x %h, ", ref_in_l1x[slot]);
                $write("in_l1y %h, ", ref_in_l1y[slot]);
                $write("in_l1z %h, ", ref_in_l1z[slot]);
                $write("in_l2x %h, ", ref_in_l2x[slot]);
                $write("in_l2y %h, ", ref_in_l2y[slot]);
                $write("in_l2z %h: expected", ref_in_l2z[slot]);
                $write(" %h", ref_out_r[slot]);
                $write(" %h", ref_out_g[slot]);
                $write(" %h", ref_out_b[slot]);
                $write(", got");
                if (out_valid === 1'b1) begin
                    $write(" %h", out_r);
                    $write(" %h", out_g);
                    $write(" %h", out_b);
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
                ref_in_material[slot] = in_material;
                ref_in_nx[slot] = in_nx;
                ref_in_ny[slot] = in_ny;
                ref_in_nz[slot] = in_nz;
                ref_in_vx[slot] = in_vx;
                ref_in_vy[slot] = in_vy;
                ref_in_vz[slot] = in_vz;
                ref_in_l1x[slot] = in_l1x;
                ref_in_l1y[slot] = in_l1y;
                ref_in_l1z[slot] = in_l1z;
                ref_in_l2x[slot] = in_l2x;
                ref_in_l2y[slot] = in_l2y;
                ref_in_l2z[slot] = in_l2z;
                ref_out_r[slot] = expected_out_r;
                ref_out_g[slot] = expected_out_g;
                ref_out_b[slot] = expected_out_b;
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
            in_material = lfsr[1:0];
            draw;
            in_nx = lfsr[17:0];
            draw;
            in_ny = lfsr[17:0];
            draw;
            in_nz = lfsr[17:0];
            draw;
            in_vx = lfsr[17:0];
            draw;
            in_vy = lfsr[17:0];
            draw;
            in_vz = lfsr[17:0];
            draw;
            in_l1x = lfsr[17:0];
            draw;
            in_l1y = lfsr[17:0];
            draw;
            in_l1z = lfsr[17:0];
            draw;
            in_l2x = lfsr[17:0];
            draw;
            in_l2y = lfsr[17:0];
            draw;
            in_l2z = lfsr[17:0];
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
            in_material = file_in_material;
            in_nx = file_in_nx;
            in_ny = file_in_ny;
            in_nz = file_in_nz;
            in_vx = file_in_vx;
            in_vy = file_in_vy;
            in_vz = file_in_vz;
            in_l1x = file_in_l1x;
            in_l1y = file_in_l1y;
            in_l1z = file_in_l1z;
            in_l2x = file_in_l2x;
            in_l2y = file_in_l2y;
            in_l2z = file_in_l2z;
            expected_out_r = file_out_r;
            expected_out_g = file_out_g;
            expected_out_b = file_out_b;
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
            read_hex(2);
            file_in_material = field[1:0];
            read_hex(18);
            file_in_nx = field[17:0];
            read_hex(18);
            file_in_ny = field[17:0];
            read_hex(18);
            file_in_nz = field[17:0];
            read_hex(18);
            file_in_vx = field[17:0];
            read_hex(18);
            file_in_vy = field[17:0];
            read_hex(18);
            file_in_vz = field[17:0];
            read_hex(18);
            file_in_l1x = field[17:0];
            read_hex(18);
            file_in_l1y = field[17:0];
            read_hex(18);
            file_in_l1z = field[17:0];
            read_hex(18);
            file_in_l2x = field[17:0];
            read_hex(18);
            file_in_l2y = field[17:0];
            read_hex(18);
            file_in_l2z = field[17:0];
            read_hex(8);
            file_out_r = field[7:0];
            read_hex(8);
            file_out_g = field[7:0];
            read_hex(8);
            file_out_b = field[7:0];
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
                path = "golden/shader.vec";
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
