/*
{%- for line in c.header %}
{%- if line.is_empty() %}
 *
{%- else %}
 * {{ line }}
{%- endif %}
{%- endfor %}
 */

#include "{{ c.name }}_light.h"

/* Fraction bits of sines and of what is computed with them, and 1.0. */
#define FRACTION {{ c.fraction }}
#define ONE (UINT64_C(1) << FRACTION)
/* Half a turn, and an intensity of 1. */
#define HALF_TURN (UINT64_C(1) << 63)
{%- if !c.is_vector %}
#define BANDS {{ c.table.bands.len() }}
{%- endif %}

/* The sine of every 256th of a turn, from 0 to a quarter turn. */
static const uint64_t sines[{{ c.sines.len() }}] = {
{%- for sine in c.sines %}
    UINT64_C({{ "0x{:016x}"|format(sine) }}){% if !loop.last %},{% endif %}
{%- endfor %}
};
{%- if !c.is_vector %}

/* The bands of texels: the angle in 2^-64 turns, 2^{{ c.reciprocal_bits }} over what lies between it and the next, and
 * the root of the gain of a light of intensity 1 there, with {{ c.table.root_bits }} fraction bits. */
static const struct {
    uint64_t angle, reciprocal, root;
} bands[BANDS] = {
{%- for band in c.table.bands %}
    {UINT64_C({{ "0x{:016x}"|format(band.angle) }}), UINT64_C({{ "0x{:016x}"|format(band.reciprocal) }}), UINT64_C({{ "0x{:012x}"|format(band.root) }})}{% if !loop.last %},{% endif %}
{%- endfor %}
};
{%- endif %}

/* a b 2^-bits, rounded down; bits are 1 to 63, and the result fits. */
static uint64_t product(uint64_t a, uint64_t b, unsigned bits)
{
    const uint64_t low_half = UINT64_C(0xffffffff);
    uint64_t a0 = a & low_half, a1 = a >> 32, b0 = b & low_half, b1 = b >> 32;
    uint64_t low = a0 * b0;
    uint64_t middle = a1 * b0 + (low >> 32);
    uint64_t other = a0 * b1 + (middle & low_half);
    uint64_t high = a1 * b1 + (middle >> 32) + (other >> 32);
    low = (other << 32) | (low & low_half);
    return (high << (64 - bits)) | (low >> bits);
}

/* The product of two sines, rounded towards 0. */
static int64_t times(int64_t a, int64_t b)
{
    uint64_t magnitude = product((uint64_t)(a < 0 ? -a : a), (uint64_t)(b < 0 ? -b : b), FRACTION);
    return (a < 0) == (b < 0) ? (int64_t)magnitude : -(int64_t)magnitude;
}

/* Sine and cosine of an angle: of the nearest step of the table, turned by what is left, whose own
 * are the first terms of their series. */
static void sine_cosine(uint64_t angle, int64_t *sine, int64_t *cosine)
{
    uint64_t part = angle & (ONE - 1);
    uint64_t step = (part + (UINT64_C(1) << {{ c.step_bits - 1 }})) >> {{ c.step_bits }};
    uint64_t at = step << {{ c.step_bits }};
    int is_past = part >= at;
    /* In radians: times pi / 2. */
    uint64_t x = product(is_past ? part - at : at - part, UINT64_C({{ "0x{:016x}"|format(c.half_pi) }}), {{ c.half_pi_bits }});
    uint64_t square = product(x, x, FRACTION);
    uint64_t cube = product(square, x, FRACTION);
    uint64_t sine_x = x - cube / 6 + product(cube, square, FRACTION) / 120;
    uint64_t cosine_x = ONE - square / 2 + product(square, square, FRACTION) / 24;
    uint64_t along = product(sines[step], sine_x, FRACTION);
    uint64_t aside = product(sines[{{ c.sines.len() - 1 }} - step], sine_x, FRACTION);
    uint64_t s = product(sines[step], cosine_x, FRACTION);
    uint64_t c = product(sines[{{ c.sines.len() - 1 }} - step], cosine_x, FRACTION);
    int64_t own = (int64_t)(is_past ? s + aside : s - aside);
    int64_t other = (int64_t)(is_past ? c - along : c + along);
    switch (angle >> FRACTION) {
    case 0:
        *sine = own;
        *cosine = other;
        break;
    case 1:
        *sine = other;
        *cosine = -own;
        break;
    case 2:
        *sine = -own;
        *cosine = -other;
        break;
    default:
        *sine = -other;
        *cosine = own;
        break;
    }
}

/* The code of a vector's component with {{ c.vector_fraction }} fraction bits: the nearest, halves away from 0. */
static int32_t component(int64_t value)
{
    uint64_t magnitude = (uint64_t)(value < 0 ? -value : value);
    int32_t code = (int32_t)((magnitude + (UINT64_C(1) << (FRACTION - {{ c.vector_fraction + 1 }}))) >> (FRACTION - {{ c.vector_fraction }}));
    return value < 0 ? -code : code;
}

/* What is less. */
static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}
{%- if let ImageForm::Paper { .. } = c.form %}

/* The code of half of the way from phi to an image, in right angles with {{ c.angle_bits }} fraction bits: the nearest,
 * and at most half of a right angle, which only an image without a weight is beyond. */
static int32_t half_turn(uint64_t angle, uint64_t phi)
{
    uint64_t apart = angle < phi ? phi - angle : angle - phi;
    int32_t code = (int32_t)least((apart + (UINT64_C(1) << {{ 62 - c.angle_bits }})) >> {{ 63 - c.angle_bits }}, UINT64_C(1) << {{ c.angle_bits - 1 }});
    return angle < phi ? -code : code;
}
{%- endif %}

struct {{ c.name }}_light_record
{{ c.name }}_light(uint64_t phi, uint64_t gamma, const uint64_t intensity[3])
{
    struct {{ c.name }}_light_record record;
{%- if c.is_vector %}
    int64_t sine, cosine, gamma_sine, gamma_cosine;
    int channel;

    phi = least(phi, HALF_TURN);
    sine_cosine(phi, &sine, &cosine);
    sine_cosine(gamma, &gamma_sine, &gamma_cosine);
    record.direction[0] = component(times(sine, gamma_cosine));
    record.direction[1] = component(times(sine, gamma_sine));
    record.direction[2] = component(cosine);
    for (channel = 0; channel < 3; ++channel)
        record.intensity[channel] = (int32_t)((least(intensity[channel], HALF_TURN) + (UINT64_C(1) << {{ 62 - c.gain_bits }})) >> {{ 63 - c.gain_bits }});
{%- else %}
    int64_t {% if c.has_direction %}sine, cosine, {% endif %}half_sine, half_cosine, gamma_sine, gamma_cosine;
    uint64_t part, own, next, weight, odd, gain, gains[3], greatest = 0;
    unsigned band = 0, dropped, shift = 0;
    int channel;

    phi = least(phi, HALF_TURN);
{%- if c.has_direction %}
    sine_cosine(phi, &sine, &cosine);
{%- endif %}
    sine_cosine(phi / 2, &half_sine, &half_cosine);
    sine_cosine(gamma, &gamma_sine, &gamma_cosine);
{%- if c.has_direction %}
    record.direction[0] = component(times(sine, gamma_cosine));
    record.direction[1] = component(times(sine, gamma_sine));
    record.direction[2] = component(cosine);
{%- endif %}
{%- match c.form %}
{%- when ImageForm::Bivariate { .. } %}
    /* The half vector; behind the object, where it vanishes, +z. */
    if (phi == HALF_TURN) {
        half_sine = 0;
        half_cosine = (int64_t)ONE;
    }
    record.h[0] = component(times(half_sine, gamma_cosine));
    record.h[1] = component(times(half_sine, gamma_sine));
    record.h[2] = component(half_cosine);
{%- when ImageForm::Matcap %}
{%- when ImageForm::Half { .. } or ImageForm::Paper { .. } %}
    /* The rows of the turn by -gamma about z and by -phi / 2 about y. */
    record.u[0] = component(times(gamma_cosine, half_cosine));
    record.u[1] = component(times(gamma_sine, half_cosine));
    record.u[2] = component(-half_sine);
    record.v[0] = component(-gamma_sine);
    record.v[1] = component(gamma_cosine);
{%- endmatch %}

    /* The band below phi, and the part of the next one; past the last one that one alone. */
    while (band + 2 < BANDS && bands[band + 1].angle <= phi)
        ++band;
    if (phi < bands[band].angle)
        part = 0;
    else if (phi >= bands[BANDS - 1].angle)
        part = ONE;
    else
        part = product(phi - bands[band].angle, bands[band].reciprocal, {{ c.reciprocal_bits }} - FRACTION);
    own = product(ONE - part, bands[band].root, FRACTION);
    next = product(part, bands[band + 1].root, FRACTION);
    weight = own + next;
    odd = band % 2 == 0 ? next : own;
    record.band = (int32_t)band;
{%- if let ImageForm::Paper { .. } = c.form %}
    /* The even one of both images is this one or the next. */
    record.turn_even = half_turn(bands[band + band % 2].angle, phi);
    record.turn_odd = half_turn(bands[band + 1 - band % 2].angle, phi);
    record.alone = phi < bands[0].angle || phi >= bands[BANDS - 1].angle;
{%- endif %}
    if (weight == 0)
        record.blend = band % 2 == 0 ? 0 : INT32_C(1) << {{ c.weight_bits }};
    else
        record.blend = (int32_t)(((odd << {{ c.weight_bits + 1 }}) + weight) / (2 * weight));

    /* The gains, and the shift that makes codes of their port of them. Behind the object nothing is lit. */
    gain = phi == HALF_TURN ? 0 : product(weight, weight, {{ 2 * c.table.root_bits - c.table.gain_bits }});
    for (channel = 0; channel < 3; ++channel) {
        gains[channel] = product(gain, least(intensity[channel], HALF_TURN), 63);
        if (gains[channel] > greatest)
            greatest = gains[channel];
    }
{%- if c.most_shift > 0 %}
    while (shift < {{ c.most_shift }} && greatest >> ({{ c.table.gain_bits + c.gain_width - c.gain_bits }} + shift) != 0)
        ++shift;
    record.shift = (int32_t)shift;
{%- endif %}
    dropped = {{ c.table.gain_bits - c.gain_bits }} + shift;
    for (channel = 0; channel < 3; ++channel) {
        uint64_t code = (gains[channel] + (UINT64_C(1) << (dropped - 1))) >> dropped;
        record.gain[channel] = (int32_t)least(code, UINT64_C({{ c.most_gain }}));
    }
{%- endif %}
    return record;
}
