/* The functions that the formulas of input blocks call (section 6.3). */
#ifndef RNA_BLOCK_FUNCTIONS_H
#define RNA_BLOCK_FUNCTIONS_H

#include "decoder.h"
#include "vectors.h"

/* log2 of a positive normal number to some 1e-7: x = 2^e m with m within sqrt(2) of 1, and
 * log2 m = 2 / ln 2 (s + s^3 / 3 + s^5 / 5 + ...) with s = (m - 1) / (m + 1). */
static inline float log2_of(float x) {
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

/* Columns as they are, [width][ROWS], to `column` of queries; none where it is negative. */
static void put_rows(const double *values, int width, int column, float *queries) {
    for (int i = 0; column >= 0 && i < width * ROWS; i++) queries[column * ROWS + i] = (float)values[i];
}

/* In row r: a vector of the points, and the writing of column k of a block. */
#define VECTOR(v) {(v)[0][r], (v)[1][r], (v)[2][r]}
#define PUT(block, k, value) (queries[(column[block] + (k)) * ROWS + r] = (float)(value))

#endif
