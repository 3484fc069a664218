/* sum.h: adding up many small numbers.
 *
 *   float s = 0;  s = sum_add_naive_f32(s, x);            what any program does
 *   running_sum_f32 s = {0};  s = sum_add_f32(s, x);      s.sum is the result
 *   sum_error(a, b, s)                                    what rounding took from s = a + b
 *
 * A float holds 24 bits. When the sum has reached 2^24 the next 1 lies below the last bit: 2^24 + 1
 * rounds back to 2^24, and the sum stands still for ever. Long before that each addition drops up
 * to half a bit. sum_add_f32 keeps what was dropped and adds it to the next number: the error stays
 * at about one epsilon, however many numbers there are (as long as they have one sign). A plain sum
 * in double (53 bits) does as well up to some 1e9 numbers of a float's accuracy.
 *
 * Sources: W. Kahan, "Further remarks on reducing truncation errors", Comm. ACM 8(1), 1965;
 * D. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B (the exact error of a sum).
 */
#ifndef SUM_H
#define SUM_H

#include "../vec3.h"

typedef struct { float sum, lost; } running_sum_f32;

/* ---------------------------------------------------------------------------------------------- */

/* What rounding took from s = a + b, exactly a + b - s, whichever of the two is larger (needs
 * rounding as IEEE 754 has it, so neither -ffast-math nor contraction). */
static inline real sum_error(real a, real b, real s)
{
    real b_used = s - a;
    return (a - (s - b_used)) + (b - b_used);
}

static inline float sum_add_naive_f32(float s, float x) { return s + x; }

static inline running_sum_f32 sum_add_f32(running_sum_f32 s, float x)
{
    float b = x + s.lost, sum = s.sum + b, b_used = sum - s.sum;
    return (running_sum_f32){sum, (s.sum - (sum - b_used)) + (b - b_used)};
}

#endif
