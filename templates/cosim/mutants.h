#define LATENCY {{ design.schedule.latency }}
#define INPUTS {{ inputs.len() }}
#define OUTPUTS {{ outputs.len() }}
#define RECENT {{ recent }}
#define WRITE_WORDS {{ write_words }}
static const int INPUT_BITS[] = {
{%- for (_, format) in inputs %}{% if !loop.first %}, {% endif %}{{ format.width() }}{% endfor -%}
};
{% include "cosim/present.h" %}
static bool shows(const Vcore& core, const uint32_t* codes) {
    return true
{%- for (name, format) in outputs %}
        && uint32_t(core.{{ name }}) == (codes[{{ loop.index0 }}] & {{ format|mask }})
{%- endfor %}
        ;
}
static bool same(const Vcore& a, const Vcore& b) {
    return true
{%- for (name, _) in outputs %}
        && a.{{ name }} == b.{{ name }}
{%- endfor %}
        ;
}
static void write(Vcore& core, const uint32_t* write) {
    (void)core, (void)write;
{%- for port in design.write_ports() %}
    if (write[0] == {{ loop.index0 }}) {
        core.{{ port.enable.name }} = 1;
        core.{{ port.address.name }} = write[1];
{%- let bits = design.tables()[port.memory].word_bits() %}
{%- if *bits <= 32 %}
        core.{{ port.data.name }} = write[2];
{%- else if *bits <= 64 %}
        core.{{ port.data.name }} = write[2] | uint64_t(write[3]) << 32;
{%- else %}
        for (int i = 0; i < {{ bits.div_ceil(32) }}; ++i) core.{{ port.data.name }}[i] = write[2 + i];
{%- endif %}
    }
{%- endfor %}
}
