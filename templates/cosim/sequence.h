#define LATENCY {{ design.sequenced_latency() }}
#define INPUTS {{ inputs.len() }}
{% include "cosim/present.h" %}
{%- if design.sums().is_some() %}
static void end(Vcore& core, bool last) { core.in_last = last; }
{%- else %}
static void end(Vcore&, bool) {}
{%- endif %}
static void sample(const Vcore& core, uint32_t* codes) {
{%- for channel in channels %}
    codes[{{ loop.index0 }}] = core.out_{{ channel }};
{%- endfor %}
}
