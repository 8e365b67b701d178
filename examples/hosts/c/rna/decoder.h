/* A decoder, run on 48 rows at a time (section 6.2). */
#ifndef RNA_DECODER_H
#define RNA_DECODER_H

#include "base.h"

/* Values lie column after column, ROWS queries in each, and every loop over rows has this constant
 * length: compilers make it whole vectors.  Multiply-adds are written as such, so that a row's result
 * does not hang on what the compiler contracts, nor on other rows. */
#if defined(__AVX512F__)
enum { LANES = 16 };
#elif defined(__AVX__)
enum { LANES = 8 };
#else
enum { LANES = 4 };
#endif
enum { ROWS = 48, GROUP = 3 * LANES, OUTPUTS = 4 }; /* GROUP x OUTPUTS sums stay in registers */

#ifdef FP_FAST_FMAF
#define MULTIPLY_ADD(a, b, c) fmaf(a, b, c)
#else
#define MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

enum { EXACT_INPUTS = 512 }; /* 512 * 255 * 128 < 2^24: float32 holds such sums of integers exactly */

/* A fully connected layer. */
typedef struct Layer {
    int inputs, outputs;
    float *weights;     /* [outputs / OUTPUTS][inputs][OUTPUTS] */
    float *bias;        /* of float32: one an output */
    bool relu;          /* of float32 */
    float step;         /* of int8: what 1 means in its uint8 inputs; else 0 */
    float *unit;        /* of int8: (sum + whole_bias) * unit, one an output */
    double *whole_bias;
} Layer;

/* (exp(clip(layers(queries), 0, top)) - 1) times unit, or times a matrix, which is one more layer. */
typedef struct Decoder {
    int columns, widest, count;
    float low, high;     /* what queries are clipped to */
    float *gain, *offset; /* of int8: one a column */
    float top, unit;
    Layer *layers, matrix; /* the matrix: without weights where there is none */
} Decoder;

static int rounded_up(int n, int to) { return (n + to - 1) / to * to; }

static void free_layer(Layer *layer) {
    free(layer->weights);
    free(layer->bias);
    free(layer->unit);
    free(layer->whole_bias);
}

static void free_decoder(Decoder *decoder) {
    for (int i = 0; i < decoder->count; i++) free_layer(&decoder->layers[i]);
    free_layer(&decoder->matrix);
    free(decoder->layers);
    free(decoder->gain);
    free(decoder->offset);
    *decoder = (Decoder){0};
}

static float clamp(float x, float low, float high) {
    x = x > low ? x : low; /* low for NaN */
    return x < high ? x : high;
}

/* Sums of OUTPUTS columns for GROUP rows: sums[j][r] = sum over k of weights[k][j] * x[k][r]. */
static void multiply(int inputs, const float *restrict x, const float *restrict weights,
                     float sums[restrict OUTPUTS][GROUP]) {
    float s[OUTPUTS][GROUP] = {{0}};
    for (int k = 0; k < inputs; k++, x += ROWS, weights += OUTPUTS)
        for (int j = 0; j < OUTPUTS; j++)
            for (int r = 0; r < GROUP; r++) s[j][r] = MULTIPLY_ADD(weights[j], x[r], s[j][r]);
    memcpy(sums, s, sizeof s);
}

static void run_layer(const Layer *layer, const float *restrict x, float *restrict y) {
    const float floor = layer->relu ? 0 : -FLT_MAX;
    for (int j = 0; j < layer->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            multiply(layer->inputs, x + g, layer->weights + (size_t)j * (size_t)layer->inputs, sums);
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    float value = sums[i][r] + layer->bias[j + i];
                    y[(j + i) * ROWS + g + r] = value < floor ? floor : value; /* NaN stays */
                }
        }
}

/* Rounds to nearest, ties to even, for |x| below 2^22; what is larger stays so. */
static float rounded(float x) { return (x + 12582912.0f) - 12582912.0f; }

static void quantize(float x[ROWS], float step) {
    for (int r = 0; r < ROWS; r++) x[r] = clamp(rounded(x[r] / step), 0, 255);
}

/* Sums of integers, exact: in float32 over up to EXACT_INPUTS inputs, in int32 over all. */
static void run_int8_layer(const Layer *layer, float *restrict x, float *restrict y) {
    for (int k = 0; k < layer->inputs; k++) quantize(x + k * ROWS, layer->step);
    for (int j = 0; j < layer->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            int32_t total[OUTPUTS][GROUP] = {{0}};
            for (int k = 0; k < layer->inputs; k += EXACT_INPUTS) {
                int part = layer->inputs - k < EXACT_INPUTS ? layer->inputs - k : EXACT_INPUTS;
                multiply(part, x + k * ROWS + g,
                         layer->weights + (size_t)j * (size_t)layer->inputs + (size_t)k * OUTPUTS, sums);
                for (int i = 0; i < OUTPUTS; i++)
                    for (int r = 0; r < GROUP; r++) total[i][r] += (int32_t)sums[i][r];
            }
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    double sum = total[i][r] + layer->whole_bias[j + i];
                    y[(j + i) * ROWS + g + r] = (float)(sum * layer->unit[j + i]);
                }
        }
}

/* e^x to some 1e-7; infinity beyond the largest float32. */
static float exponential(float x) {
    float y = clamp(x, -87.0f, 89.0f);
    float n = rounded(y * 1.44269504f);
    float r = MULTIPLY_ADD(n, -0.693145752f, y);
    r = MULTIPLY_ADD(n, -1.42860677e-6f, r);
    float p = 1.0f / 5040;
    p = MULTIPLY_ADD(p, r, 1.0f / 720);
    p = MULTIPLY_ADD(p, r, 1.0f / 120);
    p = MULTIPLY_ADD(p, r, 1.0f / 24);
    p = MULTIPLY_ADD(p, r, 1.0f / 6);
    p = MULTIPLY_ADD(p, r, 0.5f);
    p = MULTIPLY_ADD(p, r, 1.0f);
    p = MULTIPLY_ADD(p, r, 1.0f);
    uint32_t bits = (uint32_t)((int32_t)n + 126) << 23; /* 2^(n - 1) */
    float power;
    memcpy(&power, &bits, sizeof power);
    return x == x ? p * power * 2.0f : x;
}

/* NaN stays, to be found in the end. */
static void clip(float x[ROWS], float low, float high) {
    for (int r = 0; r < ROWS; r++) {
        float raised = x[r] < low ? low : x[r];
        x[r] = raised > high ? high : raised;
    }
}

static void scale(float x[ROWS], float gain, float offset) {
    for (int r = 0; r < ROWS; r++) x[r] = x[r] * gain + offset;
}

/* From logarithms to colours.  Two loops: compilers make each of them vectors. */
static void expand(float x[ROWS], float unit) {
    for (int r = 0; r < ROWS; r++) x[r] = exponential(x[r]);
    for (int r = 0; r < ROWS; r++) x[r] = (x[r] - 1) * unit;
}

/* Runs ROWS queries; returns the results, [outputs][ROWS], which are in `a` or `b`.  a: the queries,
 * [columns][ROWS].  Both have room for `widest` columns. */
static const float *run_decoder(const Decoder *decoder, float *a, float *b) {
    for (int k = 0; k < decoder->columns; k++) {
        clip(a + k * ROWS, decoder->low, decoder->high);
        if (decoder->gain) scale(a + k * ROWS, decoder->gain[k], decoder->offset[k]);
    }
    int width = decoder->columns;
    for (int i = 0; i < decoder->count; i++) {
        const Layer *layer = &decoder->layers[i];
        if (layer->whole_bias)
            run_int8_layer(layer, a, b);
        else
            run_layer(layer, a, b);
        float *swap = a;
        a = b;
        b = swap;
        width = layer->outputs;
    }
    for (int k = 0; k < width; k++) {
        clip(a + k * ROWS, 0, decoder->top);
        expand(a + k * ROWS, decoder->unit);
    }
    if (!decoder->matrix.weights) return a;
    run_layer(&decoder->matrix, a, b);
    return b;
}

#endif
