/* The functions that the formulas of input blocks call (section 6.3). */
#ifndef RNA_BLOCK_FUNCTIONS_H
#define RNA_BLOCK_FUNCTIONS_H

#include "decoder.h"
#include "vectors.h"

/* log2 of a positive normal number to some 1e-7: x = 2^e m with m within sqrt(2) of 1, and
 * log2 m = 2 / ln 2 (s + s^3 / 3 + s^5 / 5 + ...) with s = (m - 1) / (m + 1). */
static float log2_of(float x) {
    int32_t bits, e;
    memcpy(&bits, &x, sizeof bits);
    e = (bits - 0x3f3504f3) >> 23;
    bits -= (int32_t)((uint32_t)e << 23);
    float m;
    memcpy(&m, &bits, sizeof m);
    float s = (m - 1) / (m + 1), q = s * s;
    float series = MULTIPLY_ADD(q, 1.0f / 9, 1.0f / 7);
    series = MULTIPLY_ADD(q, series, 1.0f / 5);
    series = MULTIPLY_ADD(q, series, 1.0f / 3);
    series = MULTIPLY_ADD(q, series, 1.0f);
    return MULTIPLY_ADD(2.88539008f * s, series, (float)e);
}

static inline double where(bool condition, double a, double b) { return condition ? a : b; }

static inline double at_least(double a, double b) { return a > b ? a : b; }

static inline double clamped(double x) { return x < -1 ? -1 : x > 1 ? 1 : x; }

static inline double length(const double v[3]) { return sqrt(dot(v, v)); }

static inline double largest(const double v[3]) {
    return at_least(fabs(v[0]), at_least(fabs(v[1]), fabs(v[2])));
}

/* Copies `width` columns of values to `column` of queries, [columns][ROWS]; none where it is negative. */
static inline void keep(float (*values)[ROWS], int width, int column, float *queries) {
    if (column >= 0) memcpy(queries + column * ROWS, values, (size_t)width * sizeof *values);
}

#endif
