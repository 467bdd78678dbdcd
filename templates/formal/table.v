// What the table of lights {{ table.name }} promises, whatever comes at its inputs.
//
// Beside it stands what it is to do: how many words of the sample are left, and which is next. The
// wires under "the table's state" are connected to signals of the table and its sequencer. What the
// memory holds is left open.

module lights_table (
    input wire clk,
    input wire rst,
    input wire ce,
    input wire in_valid,
{%- for port in inputs %}
    input wire {{ port.range() }}{{ port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
);

    localparam BITS = {{ table.address_bits }};

    wire in_ready, out_valid;
{%- for c in channels %}
    wire [{{ bits - 1 }}:0] out_{{ c }};
{%- endfor %}
    {{ table.name }} dut (
        .clk(clk),
        .rst(rst),
        .ce(ce),
        .in_valid(in_valid),
        .in_ready(in_ready),
{%- for port in inputs %}
        .{{ port.name }}({{ port.name }}),
{%- endfor %}
        .out_valid(out_valid){% for c in channels %},
        .out_{{ c }}(out_{{ c }}){% endfor %}
    );

    // ===== The table's state
    wire busy;
    wire [BITS-1:0] word;
    wire [BITS-1:0] until_word;
    wire read_valid;
    wire read_last;
{%- for port in table.sample %}
    wire {{ port.range() }}now_{{ port.name }};
    wire {{ port.range() }}read_{{ port.name }};
{%- endfor %}

    // ===== What it is to do
    reg started = 1'b0;
    reg [BITS:0] left; // words of the sample that are still to be read,
    reg [BITS-1:0] at; // and the next of them
    reg was_read, was_last;
{%- for port in table.sample %}
    reg {{ port.range() }}taken_{{ port.name }};
    reg {{ port.range() }}given_{{ port.name }};
{%- endfor %}
    wire [BITS-1:0] apart = in_end - in_begin;
    wire take = in_valid & left <= 1;

    always @(posedge clk) begin
        started <= 1'b1;
        if (rst) begin
            left <= 0;
            was_read <= 1'b0;
        end else if (ce) begin
            left <= take ? {1'b0, apart} + 1'b1 : left == 0 ? 0 : left - 1'b1;
            was_read <= left != 0;
        end
        if (ce) begin
            at <= take ? in_begin : at + 1'b1;
            was_last <= left == 1;
{%- for port in table.sample %}
            if (take) taken_{{ port.name }} <= {{ port.name }};
            given_{{ port.name }} <= taken_{{ port.name }};
{%- endfor %}
        end
    end

    always @* if (~started) assume (rst);

    always @* if (started) begin
        // ===== What is promised
        a_sample_is_taken_with_the_last_word: assert (in_ready == (left <= 1));
        a_word_a_clock: assert (read_valid == was_read);
        if (was_read) the_last_word_ends_the_sample: assert (read_last == was_last);
{%- for port in table.sample %}
        if (was_read) goes_with_its_lights_{{ port.name }}: assert (read_{{ port.name }} == given_{{ port.name }});
{%- endfor %}
        if (left != 0) words_in_order: assert (word == at);

        // ===== What it follows from, clock by clock
        state_of_the_sample: assert (busy == (left != 0));
        if (left != 0) begin
            state_of_its_end: assert (until_word == at + left[BITS-1:0] - 1'b1);
            state_of_the_count: assert (left <= {1'b1, {BITS{1'b0}}});
{%- for port in table.sample %}
            state_of_{{ port.name }}: assert (now_{{ port.name }} == taken_{{ port.name }});
{%- endfor %}
        end

        // ===== And what does happen
        cover (in_ready & left == 1 & take & was_read & ~was_last);
        cover (out_valid & left > 1);
    end

endmodule
