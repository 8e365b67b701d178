/* Input blocks of a decoder (section 6.3). */
#ifndef RNA_BLOCKS_H
#define RNA_BLOCKS_H

#include "block_formulas.h"
#include "features.h"

/* Fills [columns][ROWS]. */
static void fill_queries(const Planes *planes, const int column[BLOCKS], Points *points, float *queries) {
    float aside[MAX_CHANNELS * ROWS];
    float *features = column[FEATURES] >= 0 ? queries + column[FEATURES] * ROWS : aside;
    bool gathers = column[FEATURES] >= 0 || column[LEARNED_NORMAL] >= 0;
    if (gathers) gather_features(planes, points, features);
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < ROWS; r++)
            points->f[k][r] = gathers && k < planes->channels ? features[k * ROWS + r] : 0;
    put_blocks(points, column, queries);
}

#endif
