/*
{%- for line in c.header %}
{%- if line.is_empty() %}
 *
{%- else %}
 * {{ line }}
{%- endif %}
{%- endfor %}
 */

#ifndef {{ c.upper }}_LIGHT_H
#define {{ c.upper }}_LIGHT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An angle in degrees with 16 fraction bits, from 0 up to 511 degrees, in 2^-64 turns: 60 degrees
 * are {{ c.upper }}_DEGREES(60 * 65536), and
 * {{ c.upper }}_DEGREES(180 * 65536) is half a turn exactly.
 * What is negated, or beyond a turn, wraps as angles do. */
#define {{ c.upper }}_DEGREES(degrees) ((((uint64_t)(degrees) << 39) / 45) << 6)

/* An intensity of so many parts of a whole, which is from 1 to 2^32 - 1: of a colour of 8 bits
 * {{ c.upper }}_INTENSITY(colour, 255). */
#define {{ c.upper }}_INTENSITY(parts, whole) ((((uint64_t)(parts) << 31) / (uint64_t)(whole)) << 32)

/* The codes of the ports of a light, in their order. */
struct {{ c.name }}_light_record {
{%- for field in c.fields %}
    int32_t {{ field.declared }}; /* {{ field.ports }}: {{ field.format }} */
{%- endfor %}
};

/* The record of a light.
 *
 * phi: the polar angle from the viewer's direction (+z), in 2^-64 turns. 180 degrees are 2^63; more
 *     is taken for that, where no normal that is seen is lit.
{%- if !c.is_vector %} The bands' angles are kept rounded down
 *     to 2^-64 turns; a light there has that band alone.
{%- endif %}
 * gamma: the azimuth about +z from +x to +y, in 2^-64 turns; any value.
 * intensity: red, green and blue, each from 0 to 1, of which 2^63 are 1; more is taken for that.
 *
 * Needs no memory, no floating point and no library but the compiler's own division of 64 bits. */
struct {{ c.name }}_light_record
{{ c.name }}_light(uint64_t phi, uint64_t gamma, const uint64_t intensity[3]);

#ifdef __cplusplus
}
#endif

#endif
