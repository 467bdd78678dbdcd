/*
 * image_half_light: the records of lights for the core image_half
 *
 * Made by: brdfgen generate core.toml
 * Spec c91e1a366b8521bb. Generated; the function is yours to use under any terms.
 */

#include "image_half_light.h"

/* Fraction bits of sines and of what is computed with them, and 1.0. */
#define FRACTION 62
#define ONE (UINT64_C(1) << FRACTION)
/* Half a turn, and an intensity of 1. */
#define HALF_TURN (UINT64_C(1) << 63)
#define BANDS 16

/* The sine of every 256th of a turn, from 0 to a quarter turn. */
static const uint64_t sines[65] = {
    UINT64_C(0x0000000000000000),
    UINT64_C(0x0192155f7a3667e0),
    UINT64_C(0x0323ecbe21bb0280),
    UINT64_C(0x04b54824b3867d80),
    UINT64_C(0x0645e9af0a6d0b00),
    UINT64_C(0x07d59395aa5cc380),
    UINT64_C(0x0964083747309d00),
    UINT64_C(0x0af10a22459fe300),
    UINT64_C(0x0c7c5c1e34d30500),
    UINT64_C(0x0e05c1353f27b180),
    UINT64_C(0x0f8cfcbd90af8d00),
    UINT64_C(0x1111d262b1f67700),
    UINT64_C(0x1294062ed59f0500),
    UINT64_C(0x14135c9417660200),
    UINT64_C(0x158f9a75ab1fdd00),
    UINT64_C(0x17088530fa459e00),
    UINT64_C(0x187de2a6aea96300),
    UINT64_C(0x19ef7943a8ed8a00),
    UINT64_C(0x1b5d1009e15cc000),
    UINT64_C(0x1cc66e9931c45d00),
    UINT64_C(0x1e2b5d3806f63b00),
    UINT64_C(0x1f8ba4dbf89aba00),
    UINT64_C(0x20e70f3245ffda00),
    UINT64_C(0x223d66a836964400),
    UINT64_C(0x238e76735cd19000),
    UINT64_C(0x24da0a99ba25be00),
    UINT64_C(0x261feff9c2e06a00),
    UINT64_C(0x275ff45240a17200),
    UINT64_C(0x2899e64a123bac00),
    UINT64_C(0x29cd9577c7cbd200),
    UINT64_C(0x2afad26919d93e00),
    UINT64_C(0x2c216eaa3a59bc00),
    UINT64_C(0x2d413cccfe779800),
    UINT64_C(0x2e5a106fdfff2c00),
    UINT64_C(0x2f6bbe44d55f5e00),
    UINT64_C(0x30761c17ff2edc00),
    UINT64_C(0x317900d62a2e8000),
    UINT64_C(0x3274449324c7f600),
    UINT64_C(0x3367c08fe70e8000),
    UINT64_C(0x34534f408c4f0400),
    UINT64_C(0x3536cc521d434600),
    UINT64_C(0x361214b02a03fe00),
    UINT64_C(0x36e5068a32dc7c00),
    UINT64_C(0x37af8158df2a5200),
    UINT64_C(0x387165e3017b6000),
    UINT64_C(0x392a96426823ea00),
    UINT64_C(0x39daf5e8798ee600),
    UINT64_C(0x3a8269a29b927400),
    UINT64_C(0x3b20d79e651a8c00),
    UINT64_C(0x3bb6276d99847800),
    UINT64_C(0x3c424209ed0dca00),
    UINT64_C(0x3cc511d891c22400),
    UINT64_C(0x3d3e82ad8c5bb600),
    UINT64_C(0x3dae81ced092c600),
    UINT64_C(0x3e14fdf72461ae00),
    UINT64_C(0x3e71e758c9cb1200),
    UINT64_C(0x3ec52f9feeb96000),
    UINT64_C(0x3f0ec9f4e2975200),
    UINT64_C(0x3f4eaafe114a2e00),
    UINT64_C(0x3f84c8e1c33fa600),
    UINT64_C(0x3fb11b47a24a4a00),
    UINT64_C(0x3fd39b5a03107400),
    UINT64_C(0x3fec43c6f2dafc00),
    UINT64_C(0x3ffb10c1099a1a00),
    UINT64_C(0x4000000000000000)
};

/* The bands of texels: the angle in 2^-64 turns, 2^116 over what lies between it and the next, and
 * the root of the gain of a light of intensity 1 there, with 43 fraction bits. */
static const struct {
    uint64_t angle, reciprocal, root;
} bands[BANDS] = {
    {UINT64_C(0x0000000000000000), UINT64_C(0x01eae8ba2e8ba2f5), UINT64_C(0x16aebd7e4568)},
    {UINT64_C(0x0857fcf746ebe600), UINT64_C(0x01eae8ba2e8ba2f5), UINT64_C(0x16ccb4830ee0)},
    {UINT64_C(0x10aff9ee8dd7cc00), UINT64_C(0x01eae8ba2e8ba2ba), UINT64_C(0x1728285e2021)},
    {UINT64_C(0x1907f6e5d4c3b300), UINT64_C(0x01eae8ba2e8ba32f), UINT64_C(0x17c5f77e6db0)},
    {UINT64_C(0x215ff3dd1baf9800), UINT64_C(0x01eae8ba2e8ba2f5), UINT64_C(0x18aef53c1a49)},
    {UINT64_C(0x29b7f0d4629b7e00), UINT64_C(0x01eae8ba2e8ba27f), UINT64_C(0x19f12967dc48)},
    {UINT64_C(0x320fedcba9876600), UINT64_C(0x01eae8ba2e8ba2f5), UINT64_C(0x1ba2073d3ab1)},
    {UINT64_C(0x3a67eac2f0734c00), UINT64_C(0x01eae8ba2e8ba36a), UINT64_C(0x1de24d64d48f)},
    {UINT64_C(0x42bfe7ba375f3000), UINT64_C(0x01eae8ba2e8ba27f), UINT64_C(0x20e502fd1341)},
    {UINT64_C(0x4b17e4b17e4b1800), UINT64_C(0x01eae8ba2e8ba36a), UINT64_C(0x24fca6a986fa)},
    {UINT64_C(0x536fe1a8c536fc00), UINT64_C(0x01eae8ba2e8ba27f), UINT64_C(0x2ab5a80f257d)},
    {UINT64_C(0x5bc7dea00c22e400), UINT64_C(0x01eae8ba2e8ba27f), UINT64_C(0x330fcdad9ef3)},
    {UINT64_C(0x641fdb97530ecc00), UINT64_C(0x01eae8ba2e8ba36a), UINT64_C(0x4006a910b08b)},
    {UINT64_C(0x6c77d88e99fab000), UINT64_C(0x01eae8ba2e8ba27f), UINT64_C(0x55f672c1d219)},
    {UINT64_C(0x74cfd585e0e69800), UINT64_C(0x01eae8ba2e8ba36a), UINT64_C(0x7f64113527d1)},
    {UINT64_C(0x7d27d27d27d27c00), UINT64_C(0x0000000000000000), UINT64_C(0xd60b6a36e676)}
};

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
    uint64_t step = (part + (UINT64_C(1) << 55)) >> 56;
    uint64_t at = step << 56;
    int is_past = part >= at;
    /* In radians: times pi / 2. */
    uint64_t x = product(is_past ? part - at : at - part, UINT64_C(0x1921fb54442d1800), 60);
    uint64_t square = product(x, x, FRACTION);
    uint64_t cube = product(square, x, FRACTION);
    uint64_t sine_x = x - cube / 6 + product(cube, square, FRACTION) / 120;
    uint64_t cosine_x = ONE - square / 2 + product(square, square, FRACTION) / 24;
    uint64_t along = product(sines[step], sine_x, FRACTION);
    uint64_t aside = product(sines[64 - step], sine_x, FRACTION);
    uint64_t s = product(sines[step], cosine_x, FRACTION);
    uint64_t c = product(sines[64 - step], cosine_x, FRACTION);
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

/* The code of a vector's component with 16 fraction bits: the nearest, halves away from 0. */
static int32_t component(int64_t value)
{
    uint64_t magnitude = (uint64_t)(value < 0 ? -value : value);
    int32_t code = (int32_t)((magnitude + (UINT64_C(1) << (FRACTION - 17))) >> (FRACTION - 16));
    return value < 0 ? -code : code;
}

/* What is less. */
static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

struct image_half_light_record
image_half_light(uint64_t phi, uint64_t gamma, const uint64_t intensity[3])
{
    struct image_half_light_record record;
    int64_t sine, cosine, half_sine, half_cosine, gamma_sine, gamma_cosine;
    uint64_t part, own, next, weight, odd, gain, gains[3], greatest = 0;
    unsigned band = 0, dropped, shift = 0;
    int channel;

    phi = least(phi, HALF_TURN);
    sine_cosine(phi, &sine, &cosine);
    sine_cosine(phi / 2, &half_sine, &half_cosine);
    sine_cosine(gamma, &gamma_sine, &gamma_cosine);
    record.direction[0] = component(times(sine, gamma_cosine));
    record.direction[1] = component(times(sine, gamma_sine));
    record.direction[2] = component(cosine);
    /* The rows of the turn by -gamma about z and by -phi / 2 about y. */
    record.u[0] = component(times(gamma_cosine, half_cosine));
    record.u[1] = component(times(gamma_sine, half_cosine));
    record.u[2] = component(-half_sine);
    record.v[0] = component(-gamma_sine);
    record.v[1] = component(gamma_cosine);

    /* The band below phi, and the part of the next one; past the last one that one alone. */
    while (band + 2 < BANDS && bands[band + 1].angle <= phi)
        ++band;
    if (phi < bands[band].angle)
        part = 0;
    else if (phi >= bands[BANDS - 1].angle)
        part = ONE;
    else
        part = product(phi - bands[band].angle, bands[band].reciprocal, 116 - FRACTION);
    own = product(ONE - part, bands[band].root, FRACTION);
    next = product(part, bands[band + 1].root, FRACTION);
    weight = own + next;
    odd = band % 2 == 0 ? next : own;
    record.band = (int32_t)band;
    if (weight == 0)
        record.blend = band % 2 == 0 ? 0 : INT32_C(1) << 5;
    else
        record.blend = (int32_t)(((odd << 6) + weight) / (2 * weight));

    /* The gains, and the shift that makes codes of their port of them. Behind the object nothing is lit. */
    gain = phi == HALF_TURN ? 0 : product(weight, weight, 34);
    for (channel = 0; channel < 3; ++channel) {
        gains[channel] = product(gain, least(intensity[channel], HALF_TURN), 63);
        if (gains[channel] > greatest)
            greatest = gains[channel];
    }
    while (shift < 9 && greatest >> (53 + shift) != 0)
        ++shift;
    record.shift = (int32_t)shift;
    dropped = 35 + shift;
    for (channel = 0; channel < 3; ++channel) {
        uint64_t code = (gains[channel] + (UINT64_C(1) << (dropped - 1))) >> dropped;
        record.gain[channel] = (int32_t)least(code, UINT64_C(262143));
    }
    return record;
}
