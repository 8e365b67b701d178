/* Input blocks of a decoder (section 6.3). */
#ifndef RNA_BLOCKS_H
#define RNA_BLOCKS_H

#include "features.h"
#include "manifest_rules.h"

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

static void put_vectors(double v[3][ROWS], float *out) {
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < ROWS; r++) out[k * ROWS + r] = (float)v[k][r];
}

#define DOT(a, b, r) ((a)[0][r] * (b)[0][r] + (a)[1][r] * (b)[1][r] + (a)[2][r] * (b)[2][r])

static float log_gap(double cosine) {
    return log2_of((float)(1 - (cosine < 1 ? cosine : 1) + 1e-4)) * (1.0f / 6);
}

/* m: halfway of wi and wo; where they are opposite, 0 for one across n, q and wi. */
static void find_halfway(const Points *points, double m[3][ROWS]) {
    for (int r = 0; r < ROWS; r++) {
        double x = points->wi[0][r] + points->wo[0][r], y = points->wi[1][r] + points->wo[1][r];
        double z = points->wi[2][r] + points->wo[2][r], square = x * x + y * y + z * z;
        double scale = square < 1e-12 ? 0 : 1 / sqrt(square);
        m[0][r] = x * scale;
        m[1][r] = y * scale;
        m[2][r] = z * scale;
    }
}

/* q: the unit vector along n + 0.1 f, f the first three features. */
static void find_learned_normal(const Points *points, const float *features, int channels,
                                double q[3][ROWS]) {
    double none[ROWS] = {0};
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < ROWS; r++)
            q[k][r] = points->axis[k][r] + 0.1 * (k < channels ? features[k * ROWS + r] : none[r]);
    for (int r = 0; r < ROWS; r++) {
        double square = DOT(q, q, r), scale = square < 1e-12 ? 0 : 1 / sqrt(square), rest = square < 1e-12;
        for (int k = 0; k < 3; k++) q[k][r] = q[k][r] * scale + rest * points->axis[k][r];
    }
}

static void surface_blocks(const int column[BLOCKS], int channels, Points *points, const float *features,
                           float *queries) {
    double m[3][ROWS], q[3][ROWS];
    float *half_vector = queries + column[HALF_VECTOR] * ROWS;
    float *highlight = queries + column[HIGHLIGHT] * ROWS;
    float *learned_normal = queries + column[LEARNED_NORMAL] * ROWS;
    if (column[HALF_VECTOR] >= 0 || column[HIGHLIGHT] >= 0 || column[LEARNED_NORMAL] >= 0) find_halfway(points, m);
    if (column[HALF_VECTOR] >= 0)
        for (int r = 0; r < ROWS; r++) {
            double n_m = DOT(points->axis, m, r);
            half_vector[r] = (float)n_m;
            half_vector[ROWS + r] = log_gap(n_m);
            half_vector[2 * ROWS + r] = (float)DOT(points->axis, points->wi, r);
            half_vector[3 * ROWS + r] = (float)DOT(points->axis, points->wo, r);
            half_vector[4 * ROWS + r] = (float)DOT(points->wi, m, r);
        }
    if (column[HIGHLIGHT] >= 0)
        for (int r = 0; r < ROWS; r++) {
            double x = points->axis[1][r] * m[2][r] - points->axis[2][r] * m[1][r];
            double y = points->axis[2][r] * m[0][r] - points->axis[0][r] * m[2][r];
            double z = points->axis[0][r] * m[1][r] - points->axis[1][r] * m[0][r];
            double opposite = DOT(m, m, r) == 0;
            highlight[r] = log2_of((float)(x * x + y * y + z * z + opposite + 1e-8)) * (1.0f / 12);
        }
    if (column[LEARNED_NORMAL] >= 0) {
        find_learned_normal(points, features, channels, q);
        for (int r = 0; r < ROWS; r++) {
            double q_m = DOT(q, m, r);
            learned_normal[r] = (float)q_m;
            learned_normal[ROWS + r] = log_gap(q_m);
        }
    }
}

/* Of one point of a fiber: the two blocks that fibers alone have. */
static inline void fiber_row(const Points *points, int r, double angles[6], double lobes[3]) {
    const double tx = points->axis[0][r], ty = points->axis[1][r], tz = points->axis[2][r];
    const double ox = points->wo[0][r], oy = points->wo[1][r], oz = points->wo[2][r];
    const double ix = points->wi[0][r], iy = points->wi[1][r], iz = points->wi[2][r], h = points->h[r];
    double s_o = tx * ox + ty * oy + tz * oz, s_i = tx * ix + ty * iy + tz * iz;
    /* t x wo and t x wi: the directions seen along the fiber, of lengths c_o and c_i. */
    double ax = ty * oz - tz * oy, ay = tz * ox - tx * oz, az = tx * oy - ty * ox;
    double bx = ty * iz - tz * iy, by = tz * ix - tx * iz, bz = tx * iy - ty * ix;
    double square = ax * ax + ay * ay + az * az;
    double d = sqrt(square * (bx * bx + by * by + bz * bz));
    double triple = tx * (oy * iz - oz * iy) + ty * (oz * ix - ox * iz) + tz * (ox * iy - oy * ix);
    bool along = d < 1e-6;
    double safe = along ? 1 : d;
    double cos_phi = along ? 1 : limited((ax * bx + ay * by + az * bz) / safe, -1, 1);
    double sin_phi = along ? 0 : limited(triple / safe, -1, 1);
    angles[0] = s_i;
    angles[1] = s_o;
    angles[2] = s_i + s_o;
    angles[4] = cos_phi;
    angles[5] = sin_phi;
    /* Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi.  As cosine and sine. */
    double sin_t = h * sqrt(square / (1.55 * 1.55 - s_o * s_o));
    double c = 1 - 2 * h * h, s = 2 * h * sqrt(1 - h * h);
    double turn_c = 2 * sin_t * sin_t - 1, turn_s = 2 * sin_t * sqrt(1 - sin_t * sin_t);
    for (int p = 0; p < 3; p++) {
        lobes[p] = cos_phi * c + sin_phi * s;
        double turned = c * turn_c - s * turn_s;
        s = c * turn_s + s * turn_c;
        c = turned;
    }
}

static void fiber_blocks(const int column[BLOCKS], const Points *points, float *queries) {
    float *at_angles = queries + column[FIBER_ANGLES] * ROWS;
    float *at_lobes = queries + column[FIBER_LOBES] * ROWS;
    float values[9][ROWS];
    for (int r = 0; r < ROWS; r++) {
        double angles[6] = {0}, lobes[3];
        fiber_row(points, r, angles, lobes);
        for (int k = 0; k < 6; k++) values[k][r] = (float)angles[k];
        for (int k = 0; k < 3; k++) values[6 + k][r] = (float)lobes[k];
        values[3][r] = log2_of((float)(angles[2] * angles[2] + 1e-3)) * (1.0f / 6);
    }
    if (column[FIBER_ANGLES] >= 0) memcpy(at_angles, values, 6 * sizeof values[0]);
    if (column[FIBER_LOBES] >= 0) memcpy(at_lobes, values + 6, 3 * sizeof values[0]);
}

/* Fills [columns][ROWS]. */
static void fill_queries(RnaKind kind, const Planes *planes, const int column[BLOCKS], Points *points,
                         float *queries) {
    float aside[MAX_CHANNELS * ROWS];
    float *features = column[FEATURES] >= 0 ? queries + column[FEATURES] * ROWS : aside;
    int at_axis = kind == RNA_FIBER ? column[TANGENT] : column[NORMAL];
    if (column[FEATURES] >= 0 || column[LEARNED_NORMAL] >= 0) gather_features(planes, points, features);
    if (column[POSITION] >= 0)
        for (int k = 0; k < 3; k++)
            for (int r = 0; r < ROWS; r++)
                queries[(column[POSITION] + k) * ROWS + r] = (float)(2 * points->p[k][r] - 1);
    if (at_axis >= 0) put_vectors(points->axis, queries + at_axis * ROWS);
    if (column[WO] >= 0) put_vectors(points->wo, queries + column[WO] * ROWS);
    if (column[WI] >= 0) put_vectors(points->wi, queries + column[WI] * ROWS);
    if (column[H] >= 0)
        for (int r = 0; r < ROWS; r++) queries[column[H] * ROWS + r] = (float)points->h[r];
    if (column[FIBER_ANGLES] >= 0 || column[FIBER_LOBES] >= 0) fiber_blocks(column, points, queries);
    if (kind == RNA_SURFACE) surface_blocks(column, planes->channels, points, features, queries);
}

#endif
