// What the wrapper {{ axis.name }} promises, whatever the source and the sink do.
//
// One beat is picked, any one. It is followed by what can be seen from outside, as in a queue: how
// many beats are ahead of it. The wires under "the wrapper's state" are connected to the signals
// of the same names in the wrapper and its core.

module stream (
    input wire clk,
    input wire aresetn,
    input wire [{{ axis.inputs.tdata_bits() - 1 }}:0] s_tdata,
    input wire s_tvalid,
    input wire s_tlast,
    input wire [{{ axis.tuser_bits - 1 }}:0] s_tuser,
{%- for port in axis.memory_inputs() %}
    input wire [{{ port.1 - 1 }}:0] {{ port.0 }},
{%- endfor %}
    input wire m_tready,
    input wire pick
);

    localparam LATENCY = {{ axis.latency }};
    localparam USER    = {{ axis.tuser_bits }};
    localparam WAIT    = {% if let Some([first, last]) = axis.words %}{{ first.bits + 9 }}{% else %}8{% endif %};

    wire s_tready, m_tvalid, m_tlast;
    wire [{{ axis.outputs.tdata_bits() - 1 }}:0] m_tdata;
    wire [USER-1:0] m_tuser;
    {{ axis.name }} dut (
        .aclk(clk),
        .aresetn(aresetn),
        .s_axis_tdata(s_tdata),
        .s_axis_tvalid(s_tvalid),
        .s_axis_tready(s_tready),
        .s_axis_tlast(s_tlast),
        .s_axis_tuser(s_tuser),
{%- for port in axis.memory_inputs() %}
        .{{ port.0 }}({{ port.0 }}),
{%- endfor %}
        .m_axis_tdata(m_tdata),
        .m_axis_tvalid(m_tvalid),
        .m_axis_tready(m_tready),
        .m_axis_tlast(m_tlast),
        .m_axis_tuser(m_tuser)
    );

    // ===== The wrapper's state
{%- if let Some([first, last]) = axis.words %}
    localparam BITS = {{ first.bits }};
    // The table's stages in front of the sequencer's.
    wire busy;
    wire read_valid;
    wire read_last;
    wire [BITS-1:0] word;
    wire [BITS-1:0] until_word;
    wire [LATENCY:3] sequencer_valid;
    wire [LATENCY:1] valid = {sequencer_valid, read_valid & read_last, busy};
{%- else %}
    wire [LATENCY:1] valid;
{%- endif %}
    wire ready;
    wire skid_valid;
{%- if !axis.sequenced %}
    wire [LATENCY:1] last;
{%- endif %}
    wire [USER*LATENCY-1:0] user;
    wire [{{ axis.beat_bits() - 1 }}:0] skid;
{%- for lane in axis.inputs.lanes.iter().chain(axis.outputs.lanes.iter()) %}
    wire [{{ lane.bits - 1 }}:0] {{ lane.port.name }};
{%- endfor %}

    // ===== What is seen
{%- if axis.sequenced %}
    // Of the beats that are taken those count that end a sample.
    wire accept = aresetn & s_tvalid & s_tready & s_tlast;
{%- else %}
    wire accept = aresetn & s_tvalid & s_tready;
{%- endif %}
    wire take   = aresetn & m_tvalid & m_tready;
    wire [USER+{{ axis.outputs.tdata_bits() }}:0] shown = {m_tuser, m_tlast, m_tdata};
    wire [{{ axis.outputs.bits - 1 }}:0] result = { {%- for lane in axis.outputs.lanes.iter().rev() %}{{ lane.port.name }}{% if !loop.last %}, {% endif %}{% endfor -%} };
    reg started = 1'b0;
    reg was_reset, was_full, was_waiting, sink_was_ready;
    reg [USER+{{ axis.outputs.tdata_bits() }}:0] was_shown;
    reg [7:0] under_way;
{%- if let Some([first, last]) = axis.words %}
    // The words of the sample in front that are still to be read, and those of the offered one
    // besides its first.
    reg [BITS:0] left;
    wire [BITS-1:0] more = s_tdata[{{ last.range() }}] - s_tdata[{{ first.range() }}];
    wire free = left <= 1;
{%- else %}
    wire free = 1'b1;
{%- endif %}
    wire full = under_way == LATENCY + 1;

    // ===== The picked beat
    reg picked;
    reg picked_last;
    reg [USER-1:0] picked_user;
    reg has_result; // the core has shown its result, which is
    reg [{{ axis.outputs.bits - 1 }}:0] picked_result;
    reg [7:0] ahead;
    // Clocks at which the sink was ready since it was accepted, and those for its words.
    reg [WAIT-1:0] waited;
    reg [WAIT-1:0] taken_by_words;
    // The stage that it is in, a bit each; the last stands for the skid register.
    reg [LATENCY+1:1] place;
    wire chosen = accept & pick & ~picked;

    // ===== The beats in front of each stage, a byte each; of all that are under way in the lowest
    // Counted stage by stage, so that each number follows from the one beside it: of sums over all
    // stages no solver finds soon that they stay the same when everything moves on.
    reg [8*LATENCY-1:0] in_front;
    wire [8*LATENCY+7:0] beyond = {in_front, under_way};
    integer i;

    always @(posedge clk) begin
        started <= 1'b1;
        was_reset <= ~aresetn;
        was_full <= full;
        was_waiting <= aresetn & m_tvalid & ~m_tready;
        sink_was_ready <= aresetn & m_tready;
        was_shown <= shown;
        if (~aresetn) begin
            under_way <= 8'd0;
            picked <= 1'b0;
            place <= 0;
            in_front <= 0;
{%- if axis.takes_samples() %}
            left <= 0;
{%- endif %}
        end else begin
{%- if axis.takes_samples() %}
            if (ready) left <= accept ? {1'b0, more} + 1'b1 : left == 0 ? 0 : left - 1'b1;
{%- endif %}
            under_way <= under_way + {7'd0, accept} - {7'd0, take};
            if (chosen) begin
                picked <= 1'b1;
                picked_last <= s_tlast;
                picked_user <= s_tuser;
                has_result <= 1'b0;
                ahead <= under_way - {7'd0, take};
                waited <= 0;
                taken_by_words <= {% if axis.takes_samples() %}more{% else %}0{% endif %};
            end else if (picked) begin
                if (take & ahead == 8'd0) picked <= 1'b0;
                if (take) ahead <= ahead - 8'd1;
                if (m_tready) waited <= waited + 1'b1;
                if (place[LATENCY]) begin
                    has_result <= 1'b1;
                    picked_result <= result;
                end
            end
            for (i = 1; i <= LATENCY; i = i + 1)
                in_front[8*(i-1) +: 8] <=
                    (ready & (i != 1 | free) ? beyond[8*(i-1) +: 8] : beyond[8*i +: 8]) - {7'd0, take};
{%- if axis.takes_samples() %}
            // In front it stays until the last of its words is read.
            if (ready)
                place <= {place[LATENCY:2], place[1] & free, chosen | place[1] & ~free}
                    & {m_tvalid & ~m_tready, {LATENCY{1'b1}}};
{%- else %}
            if (ready) place <= {place[LATENCY:1], chosen} & {m_tvalid & ~m_tready, {LATENCY{1'b1}}};
{%- endif %}
            else if (m_tready) place[LATENCY+1] <= 1'b0;
        end
    end

    reg [7:0] position; // the number of the picked beat's stage
    always @* begin
        position = 8'd0;
        for (i = 1; i <= LATENCY + 1; i = i + 1)
            if (place[i]) position = i;
    end

    always @* if (~started) assume (~aresetn);

    always @* if (started) begin
        // ===== What is promised
        if (was_reset) nothing_survives_a_reset: assert (~m_tvalid & ~s_tready);
        if (was_waiting) a_beat_stays_until_it_is_taken: assert (m_tvalid & shown == was_shown);
        if (m_tvalid) no_beat_is_made_up: assert (under_way != 8'd0);
        not_more_than_there_is_room_for: assert (under_way <= LATENCY + 1);
        if (picked & m_tvalid & ahead == 8'd0) begin
            tlast_and_tuser_stay_with_their_beat: assert (m_tlast == picked_last & m_tuser == picked_user);
            tdata_stays_with_its_beat: assert (m_tdata == (has_result ? picked_result : result));
        end
        // So none is lost: it is there when the sink has been ready as often as there are places.
        if (picked) a_beat_comes_in_time: assert (waited <= LATENCY + 1 + taken_by_words);
        // Full throughput{% if axis.takes_samples() %}: the next sample is taken with the last word of the one before{% endif %}.
        if (sink_was_ready) the_source_waits_for_the_sink_only: assert (s_tready == free);
        if (under_way >= LATENCY) a_full_pipeline_gives_a_beat: assert (m_tvalid);
        // The core's operands are in their places.
{%- for lane in axis.inputs.lanes %}
        packing_of_{{ lane.port.name }}: assert ({{ lane.port.name }} == s_tdata[{{ lane.range() }}]);
{%- endfor %}

        // ===== What it follows from, clock by clock
        state_of_the_skid_register: assert (~(ready & skid_valid) & (ready | skid_valid | valid == 0));
        state_of_the_count: assert (beyond[8*LATENCY +: 8] == skid_valid);
        for (i = 1; i <= LATENCY; i = i + 1) begin
            assert (beyond[8*(i-1) +: 8] == beyond[8*i +: 8] + {7'd0, valid[i]});
            assert (beyond[8*(i-1) +: 8] <= LATENCY + 2 - i);
            if (~m_tvalid) assert (beyond[8*(i-1) +: 8] <= LATENCY - i);
        end
{%- if axis.takes_samples() %}
        state_of_the_source: assert (s_tready == (ready & free));
        state_of_the_sample: assert (busy == (left != 0));
        if (left != 0)
            state_of_its_words: assert (until_word == word + left[BITS-1:0] - 1'b1 & left <= {1'b1, {BITS{1'b0}}});
{%- endif %}
        state_of_the_picked_beat: assert (
            picked == |place & (place & (place - 1'b1)) == 0 & (place & ~{skid_valid, valid}) == 0);
{%- if axis.sequenced %}
        if (picked) state_of_the_end: assert (picked_last);
{%- endif %}
        if (picked) begin
            if (place[LATENCY+1]) state_of_the_order: assert (ahead == 8'd0);
            state_of_the_wait: assert (
                waited + { {(WAIT-1){1'b0}}, ~ready}
{%- if axis.takes_samples() %} + (place[1] ? left - 1'b1 : 0){% endif %} <= position + taken_by_words);
            if (place[LATENCY+1])
                state_of_the_skidded_beat: assert (has_result & skid == {picked_user, picked_last, picked_result});
            else if (has_result)
                state_of_the_result: assert (place[LATENCY] & result == picked_result);
            for (i = 1; i <= LATENCY; i = i + 1)
                if (place[i])
                    assert (ahead == beyond[8*i +: 8] & user[USER*(i-1) +: USER] == picked_user
{%- if !axis.sequenced %} & last[i] == picked_last{% endif %});
        end

        // ===== And what does happen
        cover (take & picked & ahead == 8'd0 & place[LATENCY+1]);
        cover (take & picked & ahead == 8'd0 & place[LATENCY]);
        cover (was_reset & was_full);
{%- if axis.takes_samples() %}
        cover (take & picked & ahead == 8'd0 & taken_by_words != 0);
        cover (accept & place[1] & left == 1 & taken_by_words != 0);
{%- endif %}
    end

endmodule
