#define LATENCY {{ design.sequenced_latency() }}
#define INPUTS {{ inputs.len() }}
{% include "cosim/present.h" %}
static void sample(const Vcore& core, uint32_t* codes) {
{%- for channel in channels %}
    codes[{{ loop.index0 }}] = core.out_{{ channel }};
{%- endfor %}
}
