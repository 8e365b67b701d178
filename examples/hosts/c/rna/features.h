/* Features of points: sums of bilinear samples of the planes (section 5). */
#ifndef RNA_FEATURES_H
#define RNA_FEATURES_H

#include "planes.h"
#include "points.h"

static float from_bits(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* binary16 to binary32 without branches, nor help of the processor. */
static float half_value(uint16_t half) {
    uint32_t bits = (uint32_t)(half & 0x7fff) << 13, subnormal = bits < 1u << 23;
    float excess = from_bits(subnormal * 0x38800000u); /* 2^-14 */
    float value = from_bits(bits + ((112u + subnormal) << 23)) - excess;
    memcpy(&bits, &value, sizeof bits);
    return from_bits(bits | (uint32_t)(half & 0x8000) << 16);
}

/* The four texels around a point in one plane, and their weights. */
typedef struct Footprint {
    size_t texel[4]; /* places in the flat planes */
    float weight[4];
} Footprint;

enum { CHANNELS_AT_ONCE = 8 };

/* Adds scale * the weighted texels, `count` channels from `channel` on. */
#define DEFINE_ADD_TEXELS(name, type, VALUE, SCALE)                                              \
    static inline void name(const Planes *planes, const Footprint *print, const float *scales, \
                            int channel, int count, float *sums) {                             \
        const type *texels = (const type *)planes->texels + channel;                           \
        for (int c = 0; c < count; c++) {                                                      \
            float part = 0;                                                                    \
            for (int i = 0; i < 4; i++)                                                        \
                part = MULTIPLY_ADD(VALUE(texels[print->texel[i] + (size_t)c]), print->weight[i], part); \
            sums[c] += part * SCALE(scales[channel + c]);                                      \
        }                                                                                      \
    }

#define AS_IT_IS(x) (x)
#define ONE(x) ((void)scales, 1.0f)
DEFINE_ADD_TEXELS(add_int8_texels, int8_t, (float), AS_IT_IS)
DEFINE_ADD_TEXELS(add_half_texels, uint16_t, half_value, ONE)
DEFINE_ADD_TEXELS(add_float_texels, float, AS_IT_IS, ONE)

static inline void add_texels(const Planes *planes, const Footprint *print, int plane, int channel,
                              int count, float *sums) {
    const float *scales = planes->scales ? planes->scales + plane * planes->channels : NULL;
    switch (planes->precision) {
    case INT8: add_int8_texels(planes, print, scales, channel, count, sums); break;
    case FLOAT16: add_half_texels(planes, print, scales, channel, count, sums); break;
    case FLOAT32: add_float_texels(planes, print, scales, channel, count, sums); break;
    }
}

/* Where p falls along an axis of `size` texels: the texel before it, the step to the next, the part. */
typedef struct Cell {
    size_t index, step;
    float part;
} Cell;

static Cell cell_of(double p, int size) {
    double t = limited(p * size - 0.5, 0, size - 1.0);
    int index = (int)t;
    return (Cell){(size_t)index, index < size - 1, (float)(t - index)};
}

static size_t texel_bytes(const Planes *planes) {
    return planes->precision == INT8 ? 1 : planes->precision == FLOAT16 ? 2 : 4;
}

/* The footprints of a point in the three planes; prefetches their memory. */
static void find_footprints(const Planes *planes, const Points *points, int r, Footprint prints[3]) {
    const size_t size = (size_t)planes->resolution, channels = (size_t)planes->channels;
    Cell cells[3];
    for (int k = 0; k < 3; k++) cells[k] = cell_of(points->p[k][r], planes->resolution);
    for (size_t plane = 0; plane < 3; plane++) { /* XY, YZ, ZX: u along rows, v across */
        Cell u = cells[plane], v = cells[(plane + 1) % 3];
        size_t start = ((plane * size + v.index) * size + u.index) * channels;
        size_t right = u.step * channels, up = v.step * size * channels;
        prints[plane] = (Footprint){{start, start + right, start + up, start + up + right},
                                    {(1 - v.part) * (1 - u.part), (1 - v.part) * u.part,
                                     v.part * (1 - u.part), v.part * u.part}};
        for (int i = 0; i < 4; i++)
            PREFETCH((const char *)planes->texels + prints[plane].texel[i] * texel_bytes(planes));
    }
}

/* The features at the points, summed over the three planes: [channels][ROWS] (section 5). */
static void gather_features(const Planes *planes, const Points *points, float *features) {
    Footprint prints[ROWS][3];
    for (int r = 0; r < ROWS; r++) find_footprints(planes, points, r, prints[r]);
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < planes->channels; c += CHANNELS_AT_ONCE) {
            float sums[CHANNELS_AT_ONCE] = {0};
            int count = planes->channels - c;
            for (int plane = 0; plane < 3; plane++)
                if (count >= CHANNELS_AT_ONCE) /* a constant, for the compiler */
                    add_texels(planes, &prints[r][plane], plane, c, CHANNELS_AT_ONCE, sums);
                else
                    add_texels(planes, &prints[r][plane], plane, c, count, sums);
            for (int i = 0; i < count && i < CHANNELS_AT_ONCE; i++) features[(c + i) * ROWS + r] = sums[i];
        }
}

#endif
