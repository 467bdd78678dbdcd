{% for line in bench.header -%}
//{% if !line.is_empty() %} {{ line }}{% endif %}
{% endfor %}
`default_nettype none
`timescale 1ns/1ps

/* verilator lint_off DECLFILENAME */ // a core and its benches are told apart by their files' names
module {{ bench.name }}_tb;
/* verilator lint_on DECLFILENAME */

    localparam NAME    = "{{ bench.name }}";
    localparam LATENCY = {{ bench.latency }};
    localparam SHOWN   = 10; // mismatches printed; the others are only counted
{%- for file in bench.rom_files %}

    // The core reads its memory {{ file.memory }} from this file{% if !bench.writes.is_empty() %}, and its words are written to it{% endif %}, relative to the current directory.
    parameter {{ file.parameter }} = "{{ file.path }}";
{%- endfor %}
{%- for write in bench.written_files() %}

    // The words that are written to the memory {{ write.memory }}, relative to the current directory.
    parameter {{ write.file.parameter }} = "{{ write.file.path }}";
{%- endfor %}
{%- for file in bench.memory_files() %}

    // The words of the memory {{ file.memory }} outside of the core, relative to the current directory.
    parameter {{ file.parameter }} = "{{ file.path }}";
{%- endfor %}

    // ------------------------------------------------------------------ the core
    reg  {{ bench.ranged("") }} {{ bench.padded("clk") }} = 1'b0;
    reg  {{ bench.ranged("") }} {{ bench.padded("rst") }} = 1'b0;
    reg  {{ bench.ranged("") }} {{ bench.padded("ce") }} = 1'b0;
    reg  {{ bench.ranged("") }} {{ bench.padded("in_valid") }} = 1'b0;
{%- if bench.table.is_some() %}
    wire {{ bench.ranged("") }} in_ready;
{%- endif %}
{%- if let Some(table) = bench.written_table() %}
    reg  [{{ table.address_bits - 1 }}:0] in_begin = 0;
    reg  [{{ table.address_bits - 1 }}:0] in_end = 0;
    reg  lights_en = 1'b0;
    reg  [{{ table.address_bits - 1 }}:0] lights_addr = 0;
    reg  [{{ table.word_bits - 1 }}:0] lights_data = 0;
{%- else if bench.sums.is_some() %}
    reg  {{ bench.ranged("") }} {{ bench.padded("in_last") }} = 1'b0;
{%- endif %}
{%- for port in bench.inputs %}
    reg  {{ bench.ranged(port.range) }} {{ bench.padded(port.name) }} = 0;
{%- endfor %}
{%- if bench.has_sets() %}
{%- if bench.swaps() %}
    reg  {{ bench.ranged("") }} {{ bench.padded("swap") }} = 1'b0;
    wire {{ bench.ranged("") }} texel_set;
{%- else %}
    reg  {{ bench.ranged("") }} {{ bench.padded("in_set") }} = 1'b0;
{%- endif %}
{%- endif %}
{%- for write in bench.writes %}
    reg  {{ write.enable }} = 1'b0;
    reg  [{{ write.address_bits - 1 }}:0] {{ write.address }} = 0;
    reg  [{{ write.data_bits - 1 }}:0] {{ write.data }} = 0;
{%- endfor %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
    wire [{{ part.address_bits - 1 }}:0] {{ part.port.address.name }};
    wire [{{ part.bits - 1 }}:0] {{ part.port.data.name }};
{%- endfor %}
{%- endif %}
    wire {{ bench.ranged("") }} out_valid;
{%- for port in bench.results %}
    wire {{ bench.ranged(port.range) }} {{ port.name }};
{%- endfor %}

    {{ bench.name }}{% if !bench.rom_files.is_empty() %} #(
{%- for file in bench.rom_files %}
        .{{ file.parameter }}({{ file.parameter }}){% if !loop.last %},{% endif %}
{%- endfor %}
    ){% endif %} dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
{%- if bench.table.is_some() %}
        .in_ready(in_ready),
{%- endif %}
{%- if bench.written_table().is_some() %}
        .in_begin(in_begin),
        .in_end(in_end),
        .lights_en(lights_en),
        .lights_addr(lights_addr),
        .lights_data(lights_data),
{%- else if bench.sums.is_some() %}
        .in_last(in_last),
{%- endif %}
{%- for port in bench.driven_inputs() %}
        .{{ port.name }}({{ port.name }}),
{%- endfor %}
{%- if bench.has_sets() %}
{%- if bench.swaps() %}
        .swap(swap),
        .texel_set(texel_set),
{%- else %}
        .in_set(in_set),
{%- endif %}
{%- endif %}
{%- for write in bench.writes %}
        .{{ write.enable }}({{ write.enable }}),
        .{{ write.address }}({{ write.address }}),
        .{{ write.data }}({{ write.data }}),
{%- endfor %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
        .{{ part.port.address.name }}({{ part.port.address.name }}),
        .{{ part.port.data.name }}({{ part.port.data.name }}),
{%- endfor %}
{%- endif %}
        .out_valid(out_valid),
{%- for port in bench.results %}
        .{{ port.name }}({{ port.name }}){% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- let (clock, enable) = ("clk", "ce") %}
{%- include "testbench/memory_instance.v" %}

{%- if bench.has_sets() %}

    // What is done about the set of texels: as the core comes up they are the same, and any will
    // do; then the first holds complements, until the last of their vectors is sent; and then it is
    // the second that is looked up.
    localparam ANY = 0, FIRST = 1, SECOND = 2;
    integer of_sets = ANY;
{%- endif %}

{% include "testbench/vector_state.v" %}

    // ------------------------------------------------------- reference and comparison
    // What the core has taken and not yet given back: one entry for each enabled clock of the
    // latency, as a ring. The entry at `slot` is the one at the core's outputs now; the next
    // enabled clock overwrites it with what the core takes then.
    reg {{ bench.ranged("") }} ref_{{ bench.padded("known") }} [0:LATENCY-1]; // 0: from before the core was driven
    reg {{ bench.ranged("") }} ref_{{ bench.padded("valid") }} [0:LATENCY-1];
{%- for port in bench.shown() %}
    reg {{ bench.ranged(port.range) }} ref_{{ bench.padded(port.name) }} [0:LATENCY-1];
{%- endfor %}
    integer ref_number [0:LATENCY-1]; // 0: not a vector of the file
{%- if bench.counts_lights() %}
    integer ref_lights [0:LATENCY-1]; // vectors of the sample that ends with it
{%- endif %}
    integer slot = 0;
    integer entry;
{%- if let Some(table) = bench.table %}

    // A sample of so many words comes out so many enabled clocks and these later.
    localparam BEHIND = {{ table.behind }};
    integer remaining = 0; // words of the sample that are still to be read
    reg     accepted  = 1'b0;
{%- if table.is_written %}
{% include "testbench/sample_state.v" %}
{%- endif %}
{%- endif %}

    // What is presented at the inputs now, beside the inputs themselves.
    integer number = 0;
{%- for port in bench.results %}
    reg {{ bench.ranged(port.range) }} expected_{{ bench.padded(port.name) }} = 0;
{%- endfor %}

    reg     looked     = 1'b0; // the entry at the outputs has been looked at,
    reg     reported   = 1'b0; // and found wrong: a held fault is counted once
    reg     wrong      = 1'b0;
    integer compared   = 0;
    integer mismatches = 0;
    integer clocks     = 0;
{%- if !bench.writes.is_empty() %}

    // ---------------------------------------------------------------------- loading
    localparam COMPLEMENTS = {{ bench.complemented.len() }}; // vectors for the words' complements
    integer complements = 0; // of these, fed so far,
    integer complements_compared = 0; // and compared
    integer granted = 0; // clocks that the watchdog does not count
    integer at;
{%- for write in bench.writes %}
    reg [{{ write.data_bits - 1 }}:0] words_{{ write.memory }} [0:{{ write.depth - 1 }}];
{%- endfor %}
{%- endif %}

    initial begin
        for (entry = 0; entry < LATENCY; entry = entry + 1) begin
            ref_known[entry] = 1'b0;
            ref_valid[entry] = 1'b0;
            ref_number[entry] = 0;
{%- if bench.counts_lights() %}
            ref_lights[entry] = 0;
{%- endif %}
{%- for port in bench.shown() %}
            ref_{{ port.name }}[entry] = 0;
{%- endfor %}
        end
        run;
    end

    // Case equality throughout: an X or a Z at an output is a mismatch.
    task check_outputs;
        begin
            wrong = out_valid !== ref_valid[slot];
{%- if bench.table.is_some() %}
            if (in_ready !== (remaining <= 1))
                wrong = 1'b1;
{%- endif %}
            if (ref_number[slot] != 0) begin
{%- if bench.writes.is_empty() %}
                if (!looked)
                    compared = compared + {{ bench.lights("ref_lights[slot]") }};
{%- else %}
                if (!looked && ref_number[slot] > 0)
                    compared = compared + {{ bench.lights("ref_lights[slot]") }};
                if (!looked && ref_number[slot] < 0)
                    complements_compared = complements_compared + 1;
{%- endif %}
{%- for port in bench.results %}
                if ({{ port.name }} !== ref_{{ port.name }}[slot])
                    wrong = 1'b1;
{%- endfor %}
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
{%- if !bench.writes.is_empty() %}
                if (ref_number[slot] < 0)
                    $write("brdfgen: %0s: with complemented words, vector %0d: ",
                           NAME, -ref_number[slot]);
                else
{%- endif %}
                $write("brdfgen: %0s: vector %0d: ", NAME, ref_number[slot]);
{%- for port in bench.inputs %}
                $write("{{ port.name }} %h{% if loop.last %}: expected{% else %}, {% endif %}", ref_{{ port.name }}[slot]);
{%- endfor %}
{%- for port in bench.results %}
                $write(" %h", ref_{{ port.name }}[slot]);
{%- endfor %}
                $write(", got");
                if (out_valid === 1'b1) begin
{%- for port in bench.results %}
                    $write(" %h", {{ port.name }});
{%- endfor %}
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
{%- if let Some(table) = bench.table %}
            if (ce) begin
                ref_known[slot]  = 1'b1;
                ref_valid[slot]  = 1'b0;
                ref_number[slot] = 0;
                accepted = in_valid && remaining <= 1;
                if (remaining > 0)
                    remaining = remaining - 1;
                if (accepted && !rst) begin
                    remaining = { {{- table.spare() }}'d0, in_end - in_begin} + 1;
                    entry = (slot + remaining + BEHIND) % LATENCY;
                    ref_valid[entry]  = 1'b1;
                    ref_number[entry] = number;
{%- for port in bench.inputs %}
                    ref_{{ port.name }}[entry] = {{ port.name }};
{%- endfor %}
{%- for port in bench.results %}
                    ref_{{ port.name }}[entry] = expected_{{ port.name }};
{%- endfor %}
                end
                slot = (slot == LATENCY - 1) ? 0 : slot + 1;
            end
            if (rst)
                remaining = 0;
{%- else %}
            if (ce) begin
                ref_known[slot] = 1'b1;
                ref_valid[slot] = in_valid{% if bench.sums.is_some() %} & in_last{% endif %};
                ref_number[slot] = number;
{%- if bench.counts_lights() %}
                ref_lights[slot] = lights;
{%- endif %}
{%- for port in bench.inputs %}
                ref_{{ port.name }}[slot] = {{ port.name }};
{%- endfor %}
{%- for port in bench.results %}
                ref_{{ port.name }}[slot] = expected_{{ port.name }};
{%- endfor %}
                slot = (slot == LATENCY - 1) ? 0 : slot + 1;
            end
{%- endif %}
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
            if ({% if bench.writes.is_empty() %}clocks{% else %}(clocks - granted){% endif %} / 40 > vectors + 250) begin
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
{%- for port in bench.inputs %}
            draw;
            {{ port.name }} = lfsr{{ port.range }};
{%- endfor %}
{%- for write in bench.writes %}
            {{ write.enable }} = 1'b0;
            draw;
            {{ write.address }} = lfsr[{{ write.address_bits - 1 }}:0];
            draw;
{%- for part in write.parts() %}
            {{ write.data }}[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
{%- endfor %}
            in_valid = valid;
{%- if let Some(table) = bench.written_table() %}
            draw;
            in_begin = lfsr[{{ table.address_bits - 1 }}:0];
            in_end = lfsr[{{ table.address_bits + 15 }}:16];
            lights_en = 1'b0;
            draw;
            lights_addr = lfsr[{{ table.address_bits - 1 }}:0];
{%- for part in table.parts() %}
            lights_data[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
{%- else if bench.sums.is_some() %}
            draw;
            in_last = lfsr[31];
{%- endif %}
{%- if bench.has_sets() %}
            draw;
            {% if bench.swaps() %}swap{% else %}in_set{% endif %} = lfsr[31];
{%- endif %}
            number = 0;
        end
    endtask
{%- if bench.has_sets() %}

    // The set of texels of the vector that is presented, or of the samples behind it.
    task choose_set;
        begin
            draw;
{%- if !bench.swaps() %}
            in_set = (of_sets == ANY) ? lfsr[31] : (of_sets == SECOND);
{%- else if bench.counts_lights() %}
            swap = (of_sets == ANY || !in_last) ? lfsr[31] : (of_sets == FIRST && complements == COMPLEMENTS);
{%- else %}
            swap = (of_sets == ANY) ? lfsr[31] : (of_sets == FIRST && complements == COMPLEMENTS);
{%- endif %}
        end
    endtask
{%- endif %}

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
{%- if bench.sums.is_some() %}
{% include "testbench/lights.v" %}
{%- include "testbench/sample.v" %}
{%- if let Some(table) = bench.table %}

    // Writes the light of the vector that was read last to the words of a sample, and presents that
    // until it is taken.
    task feed_sample;
        input integer of_number;
        begin
            choose_words;
            for (written = begins_at; written < begins_at + words; written = written + 1) begin
                random_stalls;
                present_garbage(1'b0);
                draw;
                ce = lfsr[31];
                present_light;
                clock;
                ce = 1'b1;
            end
            random_stalls;
            present_garbage(1'b1);
            in_begin = begins_at[{{ table.address_bits - 1 }}:0];
            written  = written - 1;
            in_end   = written[{{ table.address_bits - 1 }}:0];
            add_words;
{%- for port in bench.inputs %}
            {{ port.name }} = file_{{ port.name }};
{%- endfor %}
            number   = of_number;
{%- if bench.has_sets() %}
            choose_set;
{%- endif %}
            accepted = 1'b0;
            while (!accepted && !failed)
                clock;
            in_valid = 1'b0;
        end
    endtask
{%- else %}

    // What was read last, and what is to come out for it.
    task present_lights;
        input integer of_number;
        begin
            in_valid = 1'b1;
{%- for port in bench.inputs %}
            {{ port.name }} = file_{{ port.name }};
{%- endfor %}
            add_lights;
            number = in_last ? of_number : 0;
{%- if bench.has_sets() %}
            choose_set;
{%- endif %}
        end
    endtask
{%- endif %}
{%- endif %}

{%- if bench.table.is_some() && bench.written_table().is_none() %}

    // Presents a sample until it is taken.
    task be_taken;
        begin
            accepted = 1'b0;
            while (!accepted && !failed)
                clock;
            in_valid = 1'b0;
        end
    endtask
{%- endif %}

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
{%- if bench.written_table().is_some() %}
            feed_sample(vectors);
{%- else if bench.sums.is_some() %}
            choose_last;
            present_lights(vectors);
{%- else %}
            in_valid = 1'b1;
{%- for port in bench.inputs %}
            {{ port.name }} = file_{{ port.name }};
{%- endfor %}
{%- for port in bench.outputs %}
            expected_{{ port.name }} = file_{{ port.name }};
{%- endfor %}
            number = vectors;
{%- if bench.has_sets() %}
            choose_set;
{%- endif %}
{%- endif %}
{%- if bench.table.is_none() %}
            clock;
{%- else if bench.written_table().is_none() %}
            be_taken;
{%- endif %}
        end
    endtask

    // A full pipeline is reset by one clock: nothing that was taken before may come out.
    task reset_phase;
        input enable;
        begin
            ce = 1'b1;
            repeat (LATENCY + 2) begin
                present_garbage(1'b1);
{%- if bench.sums.is_some() && bench.table.is_none() %}
                // Without the enable a sample that has not ended is to be forgotten.
                if (!enable)
                    in_last = 1'b0;
{%- endif %}
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

{% include "testbench/vector_file.v" %}

    // ----------------------------------------------------------------------- the run
{%- if !bench.writes.is_empty() %}
{% include "testbench/words.v" %}

    // Writes every word of the memories, or its complement{% if bench.has_sets() %}, to a set of texels{% endif %}. Neither ce nor rst must matter.
    task load;
        input complement;
{%- if bench.has_sets() %}
        input set;
{%- endif %}
        begin
{%- for write in bench.writes %}
            for (at = 0; at < {{ write.depth }}; at = at + 1) begin
                present_garbage(1'b0);
                draw;
                ce  = lfsr[31];
                rst = lfsr[30];
                {{ write.enable }} = 1'b1;
                {{ write.address }} = {% if bench.has_sets() %}{set, {% endif %}at[{{ write.own_bits() - 1 }}:0]{% if bench.has_sets() %}}{% endif %};
                {{ write.data }} = words_{{ write.memory }}[at] ^ { {{- write.data_bits }}{complement}};
                granted = granted + 1;
                clock;
            end
{%- endfor %}
            present_garbage(1'b0);
            ce  = 1'b1;
{%- if bench.has_sets() %}
            // Samples are looked up in the first set again.
            rst = 1'b1;
            clock;
{%- endif %}
            rst = 1'b0;
        end
    endtask

    // A vector for the words' complements.
    task feed_complement;
{%- for port in bench.numbers() %}
        input {{ bench.ranged(port.range) }} of_{{ port.name }};
{%- endfor %}
        begin
            idle_clock;
            random_stalls;
{%- if bench.sums.is_some() %}
{%- for port in bench.numbers() %}
            file_{{ port.name }} = of_{{ port.name }};
{%- endfor %}
            complements = complements + 1;
{%- if bench.table.is_some() %}
            feed_sample(-complements);
{%- else %}
            in_last = 1'b1;
            present_lights(-complements);
            clock;
{%- endif %}
{%- else %}
            in_valid = 1'b1;
{%- for port in bench.inputs %}
            {{ port.name }} = of_{{ port.name }};
{%- endfor %}
{%- for port in bench.outputs %}
            expected_{{ port.name }} = of_{{ port.name }};
{%- endfor %}
            complements = complements + 1;
            number = -complements;
{%- if bench.has_sets() %}
            choose_set;
{%- endif %}
{%- if bench.table.is_some() %}
            be_taken;
{%- else %}
            clock;
{%- endif %}
{%- endif %}
        end
    endtask

    task feed_complements;
        begin
{%- for vector in bench.complemented %}
            feed_complement({{ vector }});
{%- endfor %}
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
                path = "{{ bench.golden }}";
            reset_phase(1'b1);
            reset_phase(1'b0);
            run_vectors;
            if (!failed && compared != count) begin
                $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
                failed = 1'b1;
            end
            read_words;
            if (!failed) begin
{%- if bench.has_sets() %}
                // The words in the second set alone.
                load(1'b1, 1'b0);
                load(1'b1, 1'b1);
                load(1'b0, 1'b1);
                of_sets = FIRST;
                feed_complements;
                empty_pipeline;
                of_sets = SECOND;
{%- else %}
                load(1'b1);
                feed_complements;
                empty_pipeline;
                load(1'b0);
{%- endif %}
                run_vectors;
            end
            conclude;
        end
    endtask
{%- else %}
    task run;
        begin
            if (!$value$plusargs("golden=%s", path))
                path = "{{ bench.golden }}";
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
{%- endif %}

    // The verdict is the last line that is printed: hence no $finish after a PASS, before which
    // some simulators print one of their own. This bench makes the clock, so that the simulation
    // ends when it does no more.
    task conclude;
        begin
            if (!failed && compared != count)
                $display("brdfgen: %0s: the file announces %0d vectors", NAME, count);
{%- if !bench.writes.is_empty() %}
            if (!failed && (COMPLEMENTS == 0 || complements_compared != COMPLEMENTS)) begin
                $display("brdfgen: %0s: %0d of %0d vectors compared with complemented words",
                         NAME, complements_compared, COMPLEMENTS);
                failed = 1'b1;
            end
{%- endif %}
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

