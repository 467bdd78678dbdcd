{% for line in axis.header -%}
//{% if !line.is_empty() %} {{ line }}{% endif %}
{% endfor %}
`default_nettype none
`timescale 1ns/1ps

module {{ axis.name }}_tb;

    localparam NAME    = "{{ axis.name }}";
    localparam LATENCY = {{ axis.latency }};
    localparam SHOWN   = 10; // faults printed; the others are only counted
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

    // --------------------------------------------------------------------- the wrapper
    localparam BEAT = {{ axis.wide_beat_bits() }}; // bits of tuser, tlast and tdata of a result

    reg  aclk = 1'b0;
    reg  aresetn = 1'b1;
    reg  [{{ axis.inputs.tdata_bits() - 1 }}:0] s_axis_tdata = 0;
    reg  s_axis_tvalid = 1'b0;
    wire s_axis_tready;
    reg  s_axis_tlast = 1'b0;
    reg  [{{ axis.tuser_bits - 1 }}:0] s_axis_tuser = 0;
{%- if bench.has_sets() %}
    reg  swap = 1'b0; // what is offered of it
    wire texel_set;
{%- endif %}
{%- for write in bench.writes %}
    reg  {{ write.enable }} = 1'b0;
    reg  [{{ write.address_bits - 1 }}:0] {{ write.address }} = 0;
    reg  [{{ write.data_bits - 1 }}:0] {{ write.data }} = 0;
{%- endfor %}
{%- if let Some(table) = bench.written_table() %}
    reg  lights_en = 1'b0;
    reg  [{{ table.address_bits - 1 }}:0] lights_addr = 0;
    reg  [{{ table.word_bits - 1 }}:0] lights_data = 0;
{%- endif %}
{%- if bench.memory.is_some() %}
    wire texels_ce;
{%- endif %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
    wire [{{ part.address_bits - 1 }}:0] {{ part.port.address.name }};
    wire [{{ part.bits - 1 }}:0] {{ part.port.data.name }};
{%- endfor %}
{%- endif %}
    wire [{{ axis.outputs.tdata_bits() - 1 }}:0] m_axis_tdata;
    wire m_axis_tvalid;
    reg  m_axis_tready = 1'b0;
    wire m_axis_tlast;
    wire [{{ axis.tuser_bits - 1 }}:0] m_axis_tuser;

    {{ axis.name }}{% if !bench.rom_files.is_empty() %} #(
{%- for file in bench.rom_files %}
        .{{ file.parameter }}({{ file.parameter }}){% if !loop.last %},{% endif %}
{%- endfor %}
    ){% endif %} dut (
        .aclk(aclk),
        .aresetn(aresetn),
        .s_axis_tdata(s_axis_tdata),
        .s_axis_tvalid(s_axis_tvalid),
        .s_axis_tready(s_axis_tready),
        .s_axis_tlast(s_axis_tlast),
        .s_axis_tuser(s_axis_tuser),
{%- if bench.has_sets() %}
        .texel_set(texel_set),
{%- endif %}
{%- for write in bench.writes %}
        .{{ write.enable }}({{ write.enable }}),
        .{{ write.address }}({{ write.address }}),
        .{{ write.data }}({{ write.data }}),
{%- endfor %}
{%- if bench.written_table().is_some() %}
        .lights_en(lights_en),
        .lights_addr(lights_addr),
        .lights_data(lights_data),
{%- endif %}
{%- if bench.memory.is_some() %}
        .texels_ce(texels_ce),
{%- endif %}
{%- if let Some(memory) = bench.memory %}
{%- for part in memory.parts %}
        .{{ part.port.address.name }}({{ part.port.address.name }}),
        .{{ part.port.data.name }}({{ part.port.data.name }}),
{%- endfor %}
{%- endif %}
        .m_axis_tdata(m_axis_tdata),
        .m_axis_tvalid(m_axis_tvalid),
        .m_axis_tready(m_axis_tready),
        .m_axis_tlast(m_axis_tlast),
        .m_axis_tuser(m_axis_tuser)
    );

{%- let (clock, enable) = ("aclk", "texels_ce") %}
{%- include "testbench/memory_instance.v" %}

    wire [BEAT-1:0] shown = {m_axis_tuser, m_axis_tlast, m_axis_tdata};

{% include "testbench/vector_state.v" %}

    // ------------------------------------------------------- reference and comparison
    // The beats under way, as a ring: what is due at the sink. The wrapper holds at most one
    // more than its core.
    localparam PLACES = LATENCY + 2;
    reg [BEAT-1:0] due        [0:PLACES-1];
    integer        due_number [0:PLACES-1]; // 0: not a vector of the file
{%- if bench.counts_lights() %}
    integer        due_lights [0:PLACES-1]; // vectors of the sample
{%- endif %}
{%- if bench.table.is_some() %}
    integer        due_clock  [0:PLACES-1]; // when it is taken if nothing waits
{%- endif %}
    integer        oldest    = 0;
    integer        under_way = 0;

    // What is offered now, beside the source's signals themselves, and what the sink will say.
    reg [{{ axis.outputs.tdata_bits() - 1 }}:0] expected = 0;
    integer     number     = 0;
{%- if bench.sums.is_some() %}
{%- if bench.counts_lights() %}
    reg         in_last    = 1'b0; // the sample ends
{%- endif %}
{%- for port in bench.results %}
    reg {{ bench.ranged(port.range) }} expected_{{ port.name }} = 0;
{%- endfor %}
{%- endif %}
    reg         sink_ready = 1'b0;
{%- if bench.table.is_some() %}

    // The sample whose words are read.
    integer remaining = 0;    // words that are still to be read
    reg     moves     = 1'b0; // nothing waits: a word is read at this clock
    reg     timed     = 1'b0; // nothing ever waits: samples come when they must
{%- endif %}
{%- if bench.written_table().is_some() %}

    // The sample that is offered next.
{% include "testbench/sample_state.v" %}
{%- endif %}

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
{%- if bench.table.is_none() %}
    integer        first_in     = 0; // the clock at which the first vector was accepted,
    integer        last_out     = 0; // and that at which the last was taken
{%- endif %}
{%- if !bench.writes.is_empty() %}

    // ---------------------------------------------------------------------- loading
    localparam COMPLEMENTS = {{ bench.complemented.len() }}; // vectors for the words' complements
    integer complements = 0; // of these, sent so far,
    integer complements_compared = 0; // and compared
    integer at;
{%- for write in bench.writes %}
    reg [{{ write.data_bits - 1 }}:0] words_{{ write.memory }} [0:{{ write.depth - 1 }}];
{%- endfor %}
{%- endif %}

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
{%- if bench.table.is_some() %}
            // Full throughput: the source never waits for more than the sink and the last word of
            // the sample before, and a full pipeline has a beat to give at every clock.
            if (was_ready && s_axis_tready !== (remaining <= 1))
                fault("s_axis_tready is not as the words and the sink have it");
{%- else %}
            // Full throughput: the source never waits for more than the sink, and a full
            // pipeline has a beat to give at every clock.
            if (was_ready && s_axis_tready !== 1'b1)
                fault("s_axis_tready is low, and the sink was ready");
{%- endif %}
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
                         due[oldest][BEAT-1:{{ axis.outputs.tdata_bits() + 1 }}],
                         due[oldest][{{ axis.outputs.tdata_bits() }}],
                         due[oldest][{{ axis.outputs.tdata_bits() - 1 }}:0],
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
{%- if bench.table.is_some() %}
            if (moves && remaining != 0)
                remaining = remaining - 1;
            if (accepted)
                remaining = {{ axis.words_of_beat() }};
            moves = aresetn && !held;
{%- endif %}
{%- if bench.counts_lights() %}
            if (accepted && number == 1)
                first_in = clocks;
            if (accepted)
                quiet = 0;
{%- endif %}
            if (accepted{% if bench.counts_lights() %} && s_axis_tlast{% endif %})
                accept;
            if (!aresetn) begin
                known     = 1'b1;
                under_way = 0;
{%- if bench.table.is_some() %}
                remaining = 0;
{%- endif %}
            end
            #5;
            aclk = 1'b0;
            if (quiet > {{ bench.patience() }}) begin
                $display("brdfgen: %0s: clock %0d: nothing moves any more", NAME, clocks);
                failed = 1'b1;
                conclude;
            end
        end
    endtask

    task take;
        begin
            if (due_number[oldest] > 0) begin
                compared = compared + {{ bench.lights("due_lights[oldest]") }};
{%- if bench.table.is_none() %}
                last_out = clocks;
{%- endif %}
            end
{%- if bench.table.is_some() %}
            if (timed && clocks != due_clock[oldest])
                fault("a sample comes at another clock than its words have it");
{%- endif %}
{%- if !bench.writes.is_empty() %}
            if (due_number[oldest] < 0)
                complements_compared = complements_compared + 1;
{%- endif %}
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
{%- if bench.counts_lights() %}
                due_lights[(oldest + under_way) % PLACES] = lights;
{%- endif %}
{%- if bench.table.is_some() %}
                due_clock[(oldest + under_way) % PLACES]  = clocks + LATENCY - 1 + remaining;
{%- endif %}
                under_way = under_way + 1;
            end
{%- if bench.table.is_none() && !bench.counts_lights() %}
            if (number == 1)
                first_in = clocks;
{%- endif %}
            quiet = 0;
        end
    endtask

    // Whatever the wrapper must not look at is random.
    task present_garbage;
        input valid;
        begin
            draw;
{%- for part in axis.input_parts() %}
            s_axis_tdata[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
            draw;
            s_axis_tlast = lfsr[31];
{%- for part in axis.user_parts() %}
{%- if !loop.first %}
            draw;
{%- endif %}
            s_axis_tuser[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
{%- for write in bench.writes %}
            {{ write.enable }} = 1'b0;
            draw;
            {{ write.address }} = lfsr[{{ write.address_bits - 1 }}:0];
{%- for part in write.parts() %}
            {{ write.data }}[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
{%- endfor %}
{%- if let Some(table) = bench.written_table() %}
            lights_en = 1'b0;
            draw;
            lights_addr = lfsr[{{ table.address_bits - 1 }}:0];
{%- for part in table.parts() %}
            lights_data[{{ part.high }}:{{ part.low }}] = lfsr[{{ part.top() }}:0];
{%- endfor %}
{%- endif %}
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

{% include "testbench/lights.v" %}
{%- include "testbench/sample.v" %}

    // Offers the vector that was read last until it is accepted; before it, as many idle clocks as
    // the source's rate gives. What no port takes of tdata is random, and so {% if bench.counts_lights() %}is tuser{% else %}are tlast and tuser{% endif %}.
{%- if bench.written_table().is_some() %}
    // Its light is written before, while the sample before may still be read.
{%- endif %}
    task send;
        input integer of_number;
        begin
            draw;
            while ({1'b0, lfsr[31:29]} >= source_rate) begin
                idle_clock;
                draw;
            end
{%- if bench.written_table().is_some() %}
            choose_words;
            for (written = begins_at; written < begins_at + words; written = written + 1) begin
                present_garbage(1'b0);
                present_light;
                clock;
            end
            written = written - 1;
{%- endif %}
            present_garbage(1'b1);
{%- if bench.has_sets() %}
            // The last vector for complements ends the samples that are looked up in the first set.
            swap = of_number < 0 && complements == COMPLEMENTS;
{%- endif %}
{%- for lane in axis.inputs.lanes %}
            s_axis_tdata[{{ lane.range() }}] = {{ bench.offered(lane) }};
{%- endfor %}
            expected = 0;
{%- if bench.written_table().is_some() %}
            add_words;
{%- endif %}
{%- if bench.counts_lights() %}
            choose_last;
            if (of_number < 0)
                in_last = 1'b1;
            add_lights;
            s_axis_tlast = in_last;
{%- endif %}
{%- for lane in axis.outputs.lanes %}
            expected[{{ lane.range() }}] = {% if bench.sums.is_some() %}expected{% else %}file{% endif %}_{{ lane.port.name }};
{%- endfor %}
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

{% include "testbench/vector_file.v" %}

    // ----------------------------------------------------------------------- the run
{%- if !bench.writes.is_empty() %}
{% include "testbench/words.v" %}

    // Writes every word of the memories, or its complement{% if bench.has_sets() %}, to a set of texels{% endif %}.
    task load;
        input complement;
{%- if bench.has_sets() %}
        input set;
{%- endif %}
        begin
{%- for write in bench.writes %}
            for (at = 0; at < {{ write.depth }}; at = at + 1) begin
                present_garbage(1'b0);
                {{ write.enable }} = 1'b1;
                {{ write.address }} = {% if bench.has_sets() %}{set, {% endif %}at[{{ write.own_bits() - 1 }}:0]{% if bench.has_sets() %}}{% endif %};
                {{ write.data }} = words_{{ write.memory }}[at] ^ { {{- write.data_bits }}{complement}};
                quiet = 0;
                clock;
            end
{%- endfor %}
        end
    endtask

    task send_complement;
{%- for port in bench.numbers() %}
        input {{ bench.ranged(port.range) }} of_{{ port.name }};
{%- endfor %}
        begin
{%- for port in bench.numbers() %}
            file_{{ port.name }} = of_{{ port.name }};
{%- endfor %}
            complements = complements + 1;
            send(-complements);
        end
    endtask
{%- endif %}

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
{%- if bench.table.is_some() %}
            timed       = ~stalls;
{%- endif %}
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
{%- if bench.table.is_none() %}
                if (!failed && !stalls && last_out - first_in != count - 1 + LATENCY) begin
                    $display("brdfgen: %0s: %0d vectors took %0d clocks without a stall, not %0d",
                             NAME, count, last_out - first_in, count - 1 + LATENCY);
                    failed = 1'b1;
                end
{%- endif %}
            end
        end
    endtask

    task run;
        begin
            if (!$value$plusargs("golden=%s", path))
                path = "{{ bench.golden }}";
            reset_phase(4'd8);
            reset_phase(4'd0);
            reset_phase(4'd4);
{%- if !bench.writes.is_empty() %}
            read_words;
            if (!failed) begin
{%- if bench.has_sets() %}
                // The words in the second set alone.
                load(1'b1, 1'b0);
                load(1'b1, 1'b1);
                load(1'b0, 1'b1);
{%- else %}
                load(1'b1);
{%- endif %}
{%- for vector in bench.complemented %}
                send_complement({{ vector }});
{%- endfor %}
                drain;
{%- if !bench.has_sets() %}
                load(1'b0);
{%- endif %}
            end
{%- endif %}
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
