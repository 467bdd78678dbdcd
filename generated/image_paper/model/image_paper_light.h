/*
 * image_paper_light: the records of lights for the core image_paper
 *
 * Made by: brdfgen generate core.toml
 * Spec e91d917992f4fdd5. Generated; the function is yours to use under any terms.
 */

#ifndef IMAGE_PAPER_LIGHT_H
#define IMAGE_PAPER_LIGHT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An angle in degrees with 16 fraction bits, from 0 up to 511 degrees, in 2^-64 turns: 60 degrees
 * are IMAGE_PAPER_DEGREES(60 * 65536), and
 * IMAGE_PAPER_DEGREES(180 * 65536) is half a turn exactly.
 * What is negated, or beyond a turn, wraps as angles do. */
#define IMAGE_PAPER_DEGREES(degrees) ((((uint64_t)(degrees) << 39) / 45) << 6)

/* An intensity of so many parts of a whole, which is from 1 to 2^32 - 1: of a colour of 8 bits
 * IMAGE_PAPER_INTENSITY(colour, 255). */
#define IMAGE_PAPER_INTENSITY(parts, whole) ((((uint64_t)(parts) << 31) / (uint64_t)(whole)) << 32)

/* The codes of the ports of a light, in their order. */
struct image_paper_light_record {
    int32_t u[3]; /* in_u1x, in_u1y, in_u1z: Q1.16 */
    int32_t v[2]; /* in_v1x, in_v1y: Q1.16 */
    int32_t band; /* in_band1: UQ3.0 */
    int32_t blend; /* in_blend1: UQ1.6 */
    int32_t turn_even; /* in_turn1_even: Q0.14 */
    int32_t turn_odd; /* in_turn1_odd: Q0.14 */
    int32_t alone; /* in_alone1: UQ1.0 */
    int32_t shift; /* in_shift1: UQ3.0 */
    int32_t gain[3]; /* in_gain1r, in_gain1g, in_gain1b: UQ1.17 */
};

/* The record of a light.
 *
 * phi: the polar angle from the viewer's direction (+z), in 2^-64 turns. 180 degrees are 2^63; more
 *     is taken for that, where no normal that is seen is lit. The bands' angles are kept rounded down
 *     to 2^-64 turns; a light there has that band alone.
 * gamma: the azimuth about +z from +x to +y, in 2^-64 turns; any value.
 * intensity: red, green and blue, each from 0 to 1, of which 2^63 are 1; more is taken for that.
 *
 * Needs no memory, no floating point and no library but the compiler's own division of 64 bits. */
struct image_paper_light_record
image_paper_light(uint64_t phi, uint64_t gamma, const uint64_t intensity[3]);

#ifdef __cplusplus
}
#endif

#endif
