// image_half_lights: the lights of a sample in sequence through the core image_half
//
// Made by: brdfgen generate core.toml
// Spec c91e1a366b8521bb. Generated; the sequencer is yours to use under any terms.
//
//   in_last   1 bit   with the lights of this clock the sample ends
//   out_r     UQ8.0   red; 255 is full scale
//   out_g     UQ8.0   green; 255 is full scale
//   out_b     UQ8.0   blue; 255 is full scale
//
// A sample is any number of clocks' lights, the last with in_last. Latency 29 clocks from
// there; lights at every clock, and no pause between samples.

`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module image_half_lights_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME    = "image_half_lights";
    localparam LATENCY = 29;
    localparam SHOWN   = 10; // mismatches printed; the others are only counted

    // The core reads its memory texels_1_even_even_even from this file, relative to the current directory.
    parameter TEXELS_1_EVEN_EVEN_EVEN_FILE = "rom/image_half_texels_1_even_even_even.mem";

    // The core reads its memory texels_1_even_even_odd from this file, relative to the current directory.
    parameter TEXELS_1_EVEN_EVEN_ODD_FILE = "rom/image_half_texels_1_even_even_odd.mem";

    // The core reads its memory texels_1_even_odd_even from this file, relative to the current directory.
    parameter TEXELS_1_EVEN_ODD_EVEN_FILE = "rom/image_half_texels_1_even_odd_even.mem";

    // The core reads its memory texels_1_even_odd_odd from this file, relative to the current directory.
    parameter TEXELS_1_EVEN_ODD_ODD_FILE = "rom/image_half_texels_1_even_odd_odd.mem";

    // The core reads its memory texels_1_odd_even_even from this file, relative to the current directory.
    parameter TEXELS_1_ODD_EVEN_EVEN_FILE = "rom/image_half_texels_1_odd_even_even.mem";

    // The core reads its memory texels_1_odd_even_odd from this file, relative to the current directory.
    parameter TEXELS_1_ODD_EVEN_ODD_FILE = "rom/image_half_texels_1_odd_even_odd.mem";

    // The core reads its memory texels_1_odd_odd_even from this file, relative to the current directory.
    parameter TEXELS_1_ODD_ODD_EVEN_FILE = "rom/image_half_texels_1_odd_odd_even.mem";

    // The core reads its memory texels_1_odd_odd_odd from this file, relative to the current directory.
    parameter TEXELS_1_ODD_ODD_ODD_FILE = "rom/image_half_texels_1_odd_odd_odd.mem";

    // ------------------------------------------------------------------ the core
    reg         clk       = 1'b0;
    reg         rst       = 1'b0;
    reg         ce        = 1'b0;
    reg         in_valid  = 1'b0;
    reg         in_last   = 1'b0;
    reg  [17:0] in_nx     = 0;
    reg  [17:0] in_ny     = 0;
    reg  [17:0] in_nz     = 0;
    reg  [17:0] in_l1x    = 0;
    reg  [17:0] in_l1y    = 0;
    reg  [17:0] in_l1z    = 0;
    reg  [17:0] in_u1x    = 0;
    reg  [17:0] in_u1y    = 0;
    reg  [17:0] in_u1z    = 0;
    reg  [17:0] in_v1x    = 0;
    reg  [17:0] in_v1y    = 0;
    reg  [3:0]  in_band1  = 0;
    reg  [5:0]  in_blend1 = 0;
    reg  [3:0]  in_shift1 = 0;
    reg  [17:0] in_gain1r = 0;
    reg  [17:0] in_gain1g = 0;
    reg  [17:0] in_gain1b = 0;
    wire        out_valid;
    wire [7:0]  out_r;
    wire [7:0]  out_g;
    wire [7:0]  out_b;

    image_half_lights #(
        .TEXELS_1_EVEN_EVEN_EVEN_FILE(TEXELS_1_EVEN_EVEN_EVEN_FILE),
        .TEXELS_1_EVEN_EVEN_ODD_FILE(TEXELS_1_EVEN_EVEN_ODD_FILE),
        .TEXELS_1_EVEN_ODD_EVEN_FILE(TEXELS_1_EVEN_ODD_EVEN_FILE),
        .TEXELS_1_EVEN_ODD_ODD_FILE(TEXELS_1_EVEN_ODD_ODD_FILE),
        .TEXELS_1_ODD_EVEN_EVEN_FILE(TEXELS_1_ODD_EVEN_EVEN_FILE),
        .TEXELS_1_ODD_EVEN_ODD_FILE(TEXELS_1_ODD_EVEN_ODD_FILE),
        .TEXELS_1_ODD_ODD_EVEN_FILE(TEXELS_1_ODD_ODD_EVEN_FILE),
        .TEXELS_1_ODD_ODD_ODD_FILE(TEXELS_1_ODD_ODD_ODD_FILE)
    ) dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_last(in_last),
        .in_nx(in_nx),
        .in_ny(in_ny),
        .in_nz(in_nz),
        .in_l1x(in_l1x),
        .in_l1y(in_l1y),
        .in_l1z(in_l1z),
        .in_u1x(in_u1x),
        .in_u1y(in_u1y),
        .in_u1z(in_u1z),
        .in_v1x(in_v1x),
        .in_v1y(in_v1y),
        .in_band1(in_band1),
        .in_blend1(in_blend1),
        .in_shift1(in_shift1),
        .in_gain1r(in_gain1r),
        .in_gain1g(in_gain1g),
        .in_gain1b(in_gain1b),
        .out_valid(out_valid),
        .out_r(out_r),
        .out_g(out_g),
        .out_b(out_b)
    );

    // --------------------------------------------------------- state of the vector file
    localparam LONGEST = 136; // bytes: longer than any line with a vector

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
    reg [17:0] file_in_nx;
    reg [17:0] file_in_ny;
    reg [17:0] file_in_nz;
    reg [17:0] file_in_l1x;
    reg [17:0] file_in_l1y;
    reg [17:0] file_in_l1z;
    reg [17:0] file_in_u1x;
    reg [17:0] file_in_u1y;
    reg [17:0] file_in_u1z;
    reg [17:0] file_in_v1x;
    reg [17:0] file_in_v1y;
    reg [3:0]  file_in_band1;
    reg [5:0]  file_in_blend1;
    reg [3:0]  file_in_shift1;
    reg [17:0] file_in_gain1r;
    reg [17:0] file_in_gain1g;
    reg [17:0] file_in_gain1b;
    reg [17:0] file_out_sum_r;
    reg [17:0] file_out_sum_g;
    reg [17:0] file_out_sum_b;
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
    reg [17:0] ref_in_nx     [0:LATENCY-1];
    reg [17:0] ref_in_ny     [0:LATENCY-1];
    reg [17:0] ref_in_nz     [0:LATENCY-1];
    reg [17:0] ref_in_l1x    [0:LATENCY-1];
    reg [17:0] ref_in_l1y    [0:LATENCY-1];
    reg [17:0] ref_in_l1z    [0:LATENCY-1];
    reg [17:0] ref_in_u1x    [0:LATENCY-1];
    reg [17:0] ref_in_u1y    [0:LATENCY-1];
    reg [17:0] ref_in_u1z    [0:LATENCY-1];
    reg [17:0] ref_in_v1x    [0:LATENCY-1];
    reg [17:0] ref_in_v1y    [0:LATENCY-1];
    reg [3:0]  ref_in_band1  [0:LATENCY-1];
    reg [5:0]  ref_in_blend1 [0:LATENCY-1];
    reg [3:0]  ref_in_shift1 [0:LATENCY-1];
    reg [17:0] ref_in_gain1r [0:LATENCY-1];
    reg [17:0] ref_in_gain1g [0:LATENCY-1];
    reg [17:0] ref_in_gain1b [0:LATENCY-1];
    reg [7:0]  ref_out_r     [0:LATENCY-1];
    reg [7:0]  ref_out_g     [0:LATENCY-1];
    reg [7:0]  ref_out_b     [0:LATENCY-1];
    integer ref_number [0:LATENCY-1]; // 0: not a vector of the file
    integer ref_lights [0:LATENCY-1]; // vectors of the sample that ends with it
    integer slot = 0;
    integer entry;

    // What is presented at the inputs now, beside the inputs themselves.
    integer number = 0;
    reg [7:0]  expected_out_r     = 0;
    reg [7:0]  expected_out_g     = 0;
    reg [7:0]  expected_out_b     = 0;

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
            ref_lights[entry] = 0;
            ref_in_nx[entry] = 0;
            ref_in_ny[entry] = 0;
            ref_in_nz[entry] = 0;
            ref_in_l1x[entry] = 0;
            ref_in_l1y[entry] = 0;
            ref_in_l1z[entry] = 0;
            ref_in_u1x[entry] = 0;
            ref_in_u1y[entry] = 0;
            ref_in_u1z[entry] = 0;
            ref_in_v1x[entry] = 0;
            ref_in_v1y[entry] = 0;
            ref_in_band1[entry] = 0;
            ref_in_blend1[entry] = 0;
            ref_in_shift1[entry] = 0;
            ref_in_gain1r[entry] = 0;
            ref_in_gain1g[entry] = 0;
            ref_in_gain1b[entry] = 0;
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
                    compared = compared + ref_lights[slot];
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
                $write("in_nx %h, ", ref_in_nx[slot]);
                $write("in_ny %h, ", ref_in_ny[slot]);
                $write("in_nz %h, ", ref_in_nz[slot]);
                $write("in_l1x %h, ", ref_in_l1x[slot]);
                $write("in_l1y %h, ", ref_in_l1y[slot]);
                $write("in_l1z %h, ", ref_in_l1z[slot]);
                $write("in_u1x %h, ", ref_in_u1x[slot]);
                $write("in_u1y %h, ", ref_in_u1y[slot]);
                $write("in_u1z %h, ", ref_in_u1z[slot]);
                $write("in_v1x %h, ", ref_in_v1x[slot]);
                $write("in_v1y %h, ", ref_in_v1y[slot]);
                $write("in_band1 %h, ", ref_in_band1[slot]);
                $write("in_blend1 %h, ", ref_in_blend1[slot]);
                $write("in_shift1 %h, ", ref_in_shift1[slot]);
                $write("in_gain1r %h, ", ref_in_gain1r[slot]);
                $write("in_gain1g %h, ", ref_in_gain1g[slot]);
                $write("in_gain1b %h: expected", ref_in_gain1b[slot]);
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
                ref_valid[slot] = in_valid & in_last;
                ref_number[slot] = number;
                ref_lights[slot] = lights;
                ref_in_nx[slot] = in_nx;
                ref_in_ny[slot] = in_ny;
                ref_in_nz[slot] = in_nz;
                ref_in_l1x[slot] = in_l1x;
                ref_in_l1y[slot] = in_l1y;
                ref_in_l1z[slot] = in_l1z;
                ref_in_u1x[slot] = in_u1x;
                ref_in_u1y[slot] = in_u1y;
                ref_in_u1z[slot] = in_u1z;
                ref_in_v1x[slot] = in_v1x;
                ref_in_v1y[slot] = in_v1y;
                ref_in_band1[slot] = in_band1;
                ref_in_blend1[slot] = in_blend1;
                ref_in_shift1[slot] = in_shift1;
                ref_in_gain1r[slot] = in_gain1r;
                ref_in_gain1g[slot] = in_gain1g;
                ref_in_gain1b[slot] = in_gain1b;
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
            in_nx = lfsr[17:0];
            draw;
            in_ny = lfsr[17:0];
            draw;
            in_nz = lfsr[17:0];
            draw;
            in_l1x = lfsr[17:0];
            draw;
            in_l1y = lfsr[17:0];
            draw;
            in_l1z = lfsr[17:0];
            draw;
            in_u1x = lfsr[17:0];
            draw;
            in_u1y = lfsr[17:0];
            draw;
            in_u1z = lfsr[17:0];
            draw;
            in_v1x = lfsr[17:0];
            draw;
            in_v1y = lfsr[17:0];
            draw;
            in_band1 = lfsr[3:0];
            draw;
            in_blend1 = lfsr[5:0];
            draw;
            in_shift1 = lfsr[3:0];
            draw;
            in_gain1r = lfsr[17:0];
            draw;
            in_gain1g = lfsr[17:0];
            draw;
            in_gain1b = lfsr[17:0];
            in_valid = valid;
            draw;
            in_last = lfsr[31];
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


    // The sum of a sample's lights up to the vector that was read last, and what is to come out
    // for it. It has no bound here: the core may keep it at 1.0 at every step.
    reg     opened = 1'b0; // there are lights before it,
    integer lights = 0;    // and so many up to it
    reg [47:0] total_r = 48'd0;
    reg [47:0] near_r;
    reg [47:0] total_g = 48'd0;
    reg [47:0] near_g;
    reg [47:0] total_b = 48'd0;
    reg [47:0] near_b;

    task add_lights;
        begin
            if (!opened) begin
                lights = 0;
                total_r = 48'd0;
                total_g = 48'd0;
                total_b = 48'd0;
            end
            lights = lights + 1;
            opened = !in_last;
            total_r = total_r + {30'd0, file_out_sum_r};
            near_r = (total_r + 48'd256) >> 9;
            expected_out_r = (near_r > 48'd255) ? 8'd255 : near_r[7:0];
            total_g = total_g + {30'd0, file_out_sum_g};
            near_g = (total_g + 48'd256) >> 9;
            expected_out_g = (near_g > 48'd255) ? 8'd255 : near_g[7:0];
            total_b = total_b + {30'd0, file_out_sum_b};
            near_b = (total_b + 48'd256) >> 9;
            expected_out_b = (near_b > 48'd255) ? 8'd255 : near_b[7:0];
        end
    endtask

    // Samples of one light, of two on average, of four, and long ones; the last vector ends one.
    task choose_last;
        begin
            draw;
            case ((vectors / 32) % 4)
                0: in_last = 1'b1;
                1: in_last = lfsr[31];
                2: in_last = (lfsr[31:30] == 2'd0);
                default: in_last = (lfsr[31:27] == 5'd0);
            endcase
            if (vectors == count)
                in_last = 1'b1;
        end
    endtask

    // What was read last, and what is to come out for it.
    task present_lights;
        input integer of_number;
        begin
            in_valid = 1'b1;
            in_nx = file_in_nx;
            in_ny = file_in_ny;
            in_nz = file_in_nz;
            in_l1x = file_in_l1x;
            in_l1y = file_in_l1y;
            in_l1z = file_in_l1z;
            in_u1x = file_in_u1x;
            in_u1y = file_in_u1y;
            in_u1z = file_in_u1z;
            in_v1x = file_in_v1x;
            in_v1y = file_in_v1y;
            in_band1 = file_in_band1;
            in_blend1 = file_in_blend1;
            in_shift1 = file_in_shift1;
            in_gain1r = file_in_gain1r;
            in_gain1g = file_in_gain1g;
            in_gain1b = file_in_gain1b;
            add_lights;
            number = in_last ? of_number : 0;
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
            choose_last;
            present_lights(vectors);
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
                // Without the enable a sample that has not ended is to be forgotten.
                if (!enable)
                    in_last = 1'b0;
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
            read_hex(18);
            file_in_nx = field[17:0];
            read_hex(18);
            file_in_ny = field[17:0];
            read_hex(18);
            file_in_nz = field[17:0];
            read_hex(18);
            file_in_l1x = field[17:0];
            read_hex(18);
            file_in_l1y = field[17:0];
            read_hex(18);
            file_in_l1z = field[17:0];
            read_hex(18);
            file_in_u1x = field[17:0];
            read_hex(18);
            file_in_u1y = field[17:0];
            read_hex(18);
            file_in_u1z = field[17:0];
            read_hex(18);
            file_in_v1x = field[17:0];
            read_hex(18);
            file_in_v1y = field[17:0];
            read_hex(4);
            file_in_band1 = field[3:0];
            read_hex(6);
            file_in_blend1 = field[5:0];
            read_hex(4);
            file_in_shift1 = field[3:0];
            read_hex(18);
            file_in_gain1r = field[17:0];
            read_hex(18);
            file_in_gain1g = field[17:0];
            read_hex(18);
            file_in_gain1b = field[17:0];
            read_hex(18);
            file_out_sum_r = field[17:0];
            read_hex(18);
            file_out_sum_g = field[17:0];
            read_hex(18);
            file_out_sum_b = field[17:0];
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
                path = "golden/image_half.vec";
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
