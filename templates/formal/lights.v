// What the sequencer {{ sequencer.name }} promises, whatever comes at its inputs.
//
// Beside it stands what it is to do: the lights that are taken, as many clocks later as the core
// needs, and their sum without a bound. The wires under "the sequencer's state" are connected to
// the signals of the same names in the sequencer and its core.

module lights (
    input wire clk,
    input wire rst,
    input wire ce,
    input wire in_valid,
    input wire in_last,
{%- if sequencer.swaps() %}
    input wire swap,
{%- endif %}
{%- for port in sequencer.shared() %}
    input wire {{ port.range() }}{{ port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
);

    localparam CORE    = {{ sequencer.core_latency }};
    localparam LATENCY = {{ sequencer.latency }};

{%- if sequencer.swaps() %}
    wire texel_set;
{%- endif %}
    wire out_valid;
{%- for c in channels %}
    wire [{{ bits - 1 }}:0] out_{{ c }};
{%- endfor %}
    {{ sequencer.name }} dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_last(in_last),
{%- if sequencer.swaps() %}
        .swap(swap),
        .texel_set(texel_set),
{%- endif %}
{%- for port in sequencer.shared() %}
        .{{ port.name }}({{ port.name }}),
{%- endfor %}
        .out_valid(out_valid){% for c in channels %},
        .out_{{ c }}(out_{{ c }}){% endfor %}
    );

    // ===== The sequencer's state
    wire [LATENCY:1] valid;
{%- if let Some(ambient) = sequencer.sums.ambient %}
    wire begins;
{%- for c in channels %}
    wire [{{ ambient - 1 }}:0] ambient_{{ c }};
{%- endfor %}
{%- endif %}
    wire [CORE:1] core_valid;
{%- for port in sequencer.driven() %}
    wire {{ port.range() }}core_{{ port.name }};
{%- endfor %}
{%- for port in sequencer.core_outputs() %}
    wire {{ port.range() }}{{ port.name }};
{%- endfor %}
{%- for c in channels %}
    wire [{{ f - 1 }}:0] so_far_{{ c }};
    wire was_full_{{ c }};
    wire [{{ f - 1 }}:0] total_{{ c }};
    wire full_{{ c }};
{%- endfor %}

    // ===== What it is to do
    reg started = 1'b0;
    reg [CORE:1] taken;
    reg [CORE:1] last;
    reg first; // the next lights out of the core begin a sample
    reg ended; // the sum is that of a whole sample
    reg shown;
{%- for c in channels %}
    // Half a code and the lights, kept below where it would leave its bits, far above full scale.
    reg [39:0] exact_{{ c }};
    wire [39:0] next_{{ c }} = (first ? 40'd{{ half }} : exact_{{ c }}) + out_sum_{{ c }};
{%- if let Some(ambient) = sequencer.sums.ambient %}
    // Of the first lights.
    reg [39:0] once_{{ c }};
    wire [39:0] near_{{ c }} = (exact_{{ c }} + once_{{ c }}) >> {{ f - bits }};
{%- else %}
    wire [39:0] near_{{ c }} = exact_{{ c }} >> {{ f - bits }};
{%- endif %}
    reg [{{ bits - 1 }}:0] code_{{ c }};
{%- endfor %}

{%- if sequencer.swaps() %}
    // The set of texels: every sample that ends with swap changes it for those behind it.
    reg in_set;
    always @(posedge clk) begin
        if (rst) in_set <= 1'b0;
        else if (ce & in_valid & in_last) in_set <= in_set ^ swap;
    end
{%- endif %}

    always @(posedge clk) begin
        started <= 1'b1;
        if (rst) begin
            taken <= 0;
            first <= 1'b1;
            ended <= 1'b0;
            shown <= 1'b0;
        end else if (ce) begin
            taken <= {taken, in_valid};
            ended <= taken[CORE] & last[CORE];
            shown <= ended;
            if (taken[CORE]) first <= last[CORE];
        end
        if (ce) begin
            last <= {last, in_last};
            if (taken[CORE]) begin
{%- for c in channels %}
                exact_{{ c }} <= next_{{ c }}[39] ? 40'h4000000000 : next_{{ c }};
{%- if let Some(ambient) = sequencer.sums.ambient %}
                if (first) once_{{ c }} <= {40'd0, out_ambient_{{ c }}} << {{ f - ambient }};
{%- endif %}
{%- endfor %}
            end
{%- for c in channels %}
            code_{{ c }} <= near_{{ c }} > {{ full }} ? {{ full }} : near_{{ c }};
{%- endfor %}
        end
    end

    always @* if (~started) assume (rst);

    always @* if (started) begin
        // ===== What is promised
        a_sample_comes_when_it_has_ended: assert (out_valid == shown);
{%- for c in channels %}
        if (out_valid) sum_of_its_lights_{{ c }}: assert (out_{{ c }} == code_{{ c }});
{%- endfor %}
{%- for port in sequencer.driven() %}
        passes_{{ port.name }}: assert (core_{{ port.name }} == {{ port.name }});
{%- endfor %}

{%- if sequencer.swaps() %}
        shows_the_set: assert (texel_set == in_set);
{%- endif %}

        // ===== What it follows from, clock by clock
        state_of_the_core: assert (core_valid == taken);
        state_of_the_chain: assert (valid == {shown, ended, taken & last});
{%- if sequencer.sums.ambient.is_some() %}
        state_of_the_beginning: assert (begins == first);
{%- endif %}
{%- for c in channels %}
        if (first) state_of_the_start_{{ c }}: assert (~was_full_{{ c }} & so_far_{{ c }} == {{ half }});
        else state_of_the_lights_{{ c }}: assert (was_full_{{ c }} == full_{{ c }} & so_far_{{ c }} == total_{{ c }});
        if (~first | ended) state_of_the_sum_{{ c }}: assert (
            full_{{ c }} == (exact_{{ c }} >= 40'd{{ one }}) & (full_{{ c }} | total_{{ c }} == exact_{{ c }}));
{%- if let Some(ambient) = sequencer.sums.ambient %}
        if (~first | ended) state_of_the_ambient_{{ c }}: assert (
            once_{{ c }} == {40'd0, ambient_{{ c }}} << {{ f - ambient }});
{%- endif %}
{%- endfor %}

        // ===== And what does happen
        cover (out_valid & ~first);
        cover (out_valid & ended);
{%- if sequencer.swaps() %}
        cover (out_valid & in_set);
{%- endif %}
    end

endmodule
