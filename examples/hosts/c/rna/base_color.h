/* Base colour at hits (section 4.6): levels of an image, and their lookup. */
#ifndef RNA_BASE_COLOR_H
#define RNA_BASE_COLOR_H

#include "images.h"
#include "textures.h"
#include "vectors.h"

enum { MAX_LEVELS = 14 }; /* 8192 texels to 1 */

typedef struct Level {
    uint32_t width, height;
    uint8_t *texels; /* [height][width][3], in the colour space of the image */
} Level;

/* The pixels that a host has set, and their means. */
typedef struct Pyramid {
    int count;
    Level level[MAX_LEVELS];
    bool is_srgb;
    float linear[256]; /* of each value of 8 bits */
    uint8_t texels[];
} Pyramid;

static uint32_t half_of(uint32_t n) { return n > 1 ? n / 2 : 1; }

/* The linear value of an encoded one, from 0 to 1. */
static double linear_value(double c, bool is_srgb) {
    return !is_srgb ? c : c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* A pyramid for an image of this size, without texels; NULL where memory is out. */
static Pyramid *new_pyramid(uint32_t width, uint32_t height, bool is_srgb) {
    size_t total = 0;
    int count = 0;
    Level level[MAX_LEVELS];
    for (uint32_t w = width, h = height;; w = half_of(w), h = half_of(h)) {
        level[count++] = (Level){w, h, NULL};
        total += 3 * (size_t)w * h;
        if (w == 1 && h == 1) break;
    }
    Pyramid *pyramid = malloc(sizeof *pyramid + total);
    if (!pyramid) return NULL;
    pyramid->count = count;
    pyramid->is_srgb = is_srgb;
    for (int i = 0; i < count; i++) {
        pyramid->level[i] = level[i];
        pyramid->level[i].texels =
            i ? pyramid->level[i - 1].texels + 3 * (size_t)level[i - 1].width * level[i - 1].height : pyramid->texels;
    }
    for (int i = 0; i < 256; i++) {
        pyramid->linear[i] = (float)linear_value(i / 255.0, is_srgb);
    }
    return pyramid;
}

/* The value of 8 bits whose linear value is the nearest. */
static uint8_t stored_value(const float linear[256], double value) {
    int low = 0, high = 255;
    while (low < high) {
        int middle = (low + high) / 2;
        if (value > 0.5 * ((double)linear[middle] + linear[middle + 1]))
            low = middle + 1;
        else
            high = middle;
    }
    return (uint8_t)low;
}

/* Means of a row or column of n values, `step` floats apart, over half_of(n) equal intervals. */
static void halve(const float *values, uint32_t n, size_t step, float *means, size_t mean_step) {
    const uint32_t half = half_of(n);
    for (uint32_t i = 0; i < half; i++) {
        const double low = (double)i * n / half, high = (double)(i + 1) * n / half;
        double sum = 0;
        for (uint32_t k = (uint32_t)low; k < n && k < high; k++)
            sum += (fmin(high, k + 1.0) - fmax(low, k)) * (double)values[k * step];
        means[i * mean_step] = (float)(sum / (high - low));
    }
}

/* Makes the levels of level 0; false where memory is out. */
static bool fill_levels(Pyramid *pyramid) {
    const Level *first = &pyramid->level[0];
    const size_t size = (size_t)first->width * first->height;
    float *values = malloc(3 * size * sizeof *values), *rows = malloc(3 * size * sizeof *rows);
    for (size_t i = 0; values && i < 3 * size; i++) values[i] = pyramid->linear[first->texels[i]];
    for (int k = 1; values && rows && k < pyramid->count; k++) {
        const Level *large = &pyramid->level[k - 1], *small = &pyramid->level[k];
        const size_t width = 3 * (size_t)large->width, half = 3 * (size_t)small->width;
        for (size_t j = 0; j < large->height; j++)
            for (size_t c = 0; c < 3; c++)
                halve(values + j * width + c, large->width, 3, rows + j * half + c, 3);
        for (size_t i = 0; i < half; i++) halve(rows + i, large->height, half, values + i, half);
        for (size_t i = 0; i < half * small->height; i++)
            small->texels[i] = stored_value(pyramid->linear, (double)values[i]);
    }
    bool good = values && rows;
    free(values);
    free(rows);
    return good;
}

/* The texel of the image that stands in column or row i. */
static size_t texel_inside(double i, uint32_t n, RnaWrap wrap) {
    if (wrap == RNA_CLAMP) return (size_t)fmin(fmax(i, 0), n - 1.0);
    const double period = wrap == RNA_MIRROR ? 2.0 * n : n, m = i - period * floor(i / period);
    const double inside = m < n ? m : 2.0 * n - 1 - m;
    return inside >= 0 && inside < n ? (size_t)inside : 0; /* beyond what float64 resolves, the first */
}

/* Adds weight times the linear colour of a level at (p, q). */
static void add_level(const Pyramid *pyramid, int k, const RnaWrap wrap[2], const double place[2], double weight,
                      double color[3]) {
    const Level *level = &pyramid->level[k];
    const double s = place[0] * level->width - 0.5, t = place[1] * level->height - 0.5, i = floor(s), j = floor(t);
    double value[3] = {0, 0, 0};
    for (int corner = 0; corner < 4; corner++) {
        const size_t column = texel_inside(i + (corner & 1), level->width, wrap[0]);
        const size_t row = texel_inside(j + (corner >> 1), level->height, wrap[1]);
        const double share = (corner & 1 ? s - i : 1 - (s - i)) * (corner >> 1 ? t - j : 1 - (t - j));
        const uint8_t *texel = level->texels + 3 * (row * level->width + column);
        for (int c = 0; c < 3; c++) value[c] += share * texel[c] / 255;
    }
    for (int c = 0; c < 3; c++) color[c] += weight * linear_value(value[c], pyramid->is_srgb);
}

/* The base colour of a hit with corners and barycentric coordinates b. */
static void base_color_at(const RnaBaseColor *record, const Pyramid *pyramid, const RnaMesh *mesh,
                          const uint32_t corner[3], const double b[3], double level, float result[3]) {
    double uv[2], place[2], color[3] = {1, 1, 1};
    if (pyramid) {
        const double *m = record->transform, last = pyramid->count - 1;
        coordinates_at(mesh, corner, b, uv);
        for (int i = 0; i < 2; i++) place[i] = m[3 * i] * uv[0] + m[3 * i + 1] * uv[1] + m[3 * i + 2];
        level = fmin(fmax(level, 0), last); /* 0 for NaN */
        const int k = (int)level;
        const double rest = level - k;
        color[0] = color[1] = color[2] = 0;
        add_level(pyramid, k, record->wrap, place, 1 - rest, color);
        if (rest > 0) add_level(pyramid, k + 1, record->wrap, place, rest, color);
    }
    for (int c = 0; c < 3; c++) result[c] = (float)(record->factor[c] * color[c]);
}

/* Texels of an image of this size a unit of length on the triangle; 0 where it has no area. */
static double density_on(const RnaBaseColor *record, const RnaMesh *mesh, const uint32_t corner[3]) {
    double e[2][3], n[3], uv[2][2];
    const float *p[3], *t[3];
    if (!mesh->uvs) return 0;
    for (int i = 0; i < 3; i++) {
        p[i] = &mesh->positions[3 * (size_t)corner[i]];
        t[i] = &mesh->uvs[2 * (size_t)corner[i]];
    }
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++) e[i][k] = (double)p[i + 1][k] - p[0][k];
        for (int k = 0; k < 2; k++) uv[i][k] = (double)t[i + 1][k] - t[0][k];
    }
    cross(e[0], e[1], n);
    const double *m = record->transform, area = sqrt(dot(n, n));
    const double texels = fabs((uv[0][0] * uv[1][1] - uv[0][1] * uv[1][0]) * (m[0] * m[4] - m[1] * m[3])) *
                          record->width * record->height;
    return area > 0 ? sqrt(texels / area) : 0;
}

static RnaWrap wrap_of(const Json *word) {
    return is_string(word, "clamp") ? RNA_CLAMP : is_string(word, "mirror") ? RNA_MIRROR : RNA_REPEAT;
}

/* The members of a record in the manifest, except its image. */
static RnaBaseColor base_color_of(const Json *json) {
    const Json *factor = member(json, "factor"), *wrap = member(json, "wrap"), *space = member(json, "colorSpace");
    const Json *transform = member(json, "transform");
    const Range range = range_of(json);
    RnaBaseColor record = {.first = range.first, .count = range.count, .factor = {1, 1, 1},
                           .transform = {1, 0, 0, 0, 1, 0}};
    record.is_srgb = !space || is_string(space, "srgb");
    const Json *number = factor ? factor->first : NULL;
    for (int k = 0; number; number = number->next) record.factor[k++] = number->number;
    number = transform ? transform->first : NULL;
    for (int k = 0; number; number = number->next) record.transform[k++] = number->number;
    if (wrap) record.wrap[0] = wrap_of(wrap->first), record.wrap[1] = wrap_of(wrap->first->next);
    return record;
}

#endif
