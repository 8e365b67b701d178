/* Points of queries, prepared: directions of unit length, places in the bounds. */
#ifndef RNA_POINTS_H
#define RNA_POINTS_H

#include "asset.h"

/* ROWS points.  Directions and places are computed in float64: 1 - n.m inside a highlight, wi near
 * -wo and wi along a fiber would otherwise cancel what float32 has of them. */
typedef struct Points {
    double p[3][ROWS]; /* position in the bounds, 0 to 1 */
    double axis[3][ROWS], wo[3][ROWS], wi[3][ROWS], h[ROWS];
    double f[3][ROWS]; /* the first three features */
    bool valid[ROWS];
} Points;

/* Rows of an evaluation. */
typedef struct Batch {
    size_t n;
    const float *positions, *axes, *h, *wo, *wi;
} Batch;

static double limited(double x, double low, double high) {
    x = x > low ? x : low; /* low for NaN */
    return x < high ? x : high;
}

/* Brings the vectors to unit length; adds to `total` what is NaN or infinite where one is not finite
 * or has no length. */
static void normalize_rows(double v[restrict 3][ROWS], double *restrict total) {
    for (int r = 0; r < ROWS; r++) {
        double scale = 1 / sqrt(v[0][r] * v[0][r] + v[1][r] * v[1][r] + v[2][r] * v[2][r]);
        v[0][r] *= scale;
        v[1][r] *= scale;
        v[2][r] *= scale;
        total[r] += v[0][r] + v[1][r] + v[2][r];
    }
}

/* `count` points from row `first` on; rows behind them repeat the last. */
static void load_points(const RnaPart *part, const Batch *batch, size_t first, int count, Points *points) {
    double total[ROWS];
    for (int r = 0; r < ROWS; r++) {
        size_t i = first + (size_t)(r < count ? r : count - 1);
        for (size_t k = 0; k < 3; k++) {
            points->p[k][r] = batch->positions[3 * i + k];
            points->axis[k][r] = batch->axes[3 * i + k];
            points->wo[k][r] = batch->wo[3 * i + k];
            points->wi[k][r] = batch->wi[3 * i + k];
        }
        points->h[r] = part->kind == RNA_FIBER ? batch->h[i] : 0;
        total[r] = points->p[0][r] + points->p[1][r] + points->p[2][r] + points->h[r];
        points->h[r] = limited(points->h[r], -1, 1);
    }
    normalize_rows(points->axis, total);
    normalize_rows(points->wo, total);
    normalize_rows(points->wi, total);
    for (int r = 0; r < ROWS; r++) points->valid[r] = total[r] - total[r] == 0;
    for (int k = 0; k < 3; k++) {
        double low = part->low[k], scale = 1 / ((double)part->high[k] - low);
        for (int r = 0; r < ROWS; r++) {
            points->p[k][r] = limited((points->p[k][r] - low) * scale, 0, 1);
            points->axis[k][r] = points->valid[r] ? points->axis[k][r] : k == 0;
            points->wo[k][r] = points->valid[r] ? points->wo[k][r] : k == 1;
            points->wi[k][r] = points->valid[r] ? points->wi[k][r] : k == 2;
        }
    }
}

#endif
