/* A decoder: chains of layers, run on 48 rows at a time. */
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

/* One operator of a chain, or an int8 layer. */
typedef struct Step {
    enum { CLIP, MULTIPLY, ADD, EXP, PRODUCT, INT8_PRODUCT } kind;
    int inputs, outputs;
    float low, high;      /* CLIP; of an INT8_PRODUCT, the range of the stored integers */
    float step;           /* INT8_PRODUCT: what 1 means in its uint8 inputs */
    bool relu;            /* of the products */
    float *values;        /* MULTIPLY, ADD: one a column */
    float *weights;       /* products: [outputs / OUTPUTS][inputs][OUTPUTS] */
    float *bias;          /* PRODUCT: one an output */
    float *unit;          /* INT8_PRODUCT: (sum + whole_bias) * unit, one an output */
    double *whole_bias;
} Step;

typedef struct Decoder {
    int columns, widest, count;
    Step *steps;
    bool runs;       /* it is a chain, and loaded */
    bool in_profile; /* and one of the decoder profile */
} Decoder;

static int rounded_up(int n, int to) { return (n + to - 1) / to * to; }

static void free_decoder(Decoder *decoder) {
    for (int i = 0; i < decoder->count; i++) {
        free(decoder->steps[i].values);
        free(decoder->steps[i].weights);
        free(decoder->steps[i].bias);
        free(decoder->steps[i].unit);
        free(decoder->steps[i].whole_bias);
    }
    free(decoder->steps);
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

static void run_product(const Step *step, const float *restrict x, float *restrict y) {
    const float floor = step->relu ? 0 : -FLT_MAX;
    for (int j = 0; j < step->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            multiply(step->inputs, x + g, step->weights + (size_t)j * (size_t)step->inputs, sums);
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    float value = sums[i][r] + step->bias[j + i];
                    y[(j + i) * ROWS + g + r] = value < floor ? floor : value; /* NaN stays */
                }
        }
}

/* Rounds to nearest, ties to even, for |x| below 2^22. */
static float rounded(float x) { return (x + 12582912.0f) - 12582912.0f; }

static void quantize(const Step *step, float *x) {
    for (int k = 0; k < step->inputs; k++)
        for (int r = 0; r < ROWS; r++)
            x[k * ROWS + r] = rounded(clamp(x[k * ROWS + r] / step->step, step->low, step->high));
}

/* Sums of integers, exact: in float32 over up to EXACT_INPUTS inputs, in int32 over all. */
static void run_int8_product(const Step *step, float *restrict x, float *restrict y) {
    const float floor = step->relu ? 0 : -FLT_MAX;
    quantize(step, x);
    for (int j = 0; j < step->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            int32_t total[OUTPUTS][GROUP] = {{0}};
            for (int k = 0; k < step->inputs; k += EXACT_INPUTS) {
                int part = step->inputs - k < EXACT_INPUTS ? step->inputs - k : EXACT_INPUTS;
                multiply(part, x + k * ROWS + g,
                         step->weights + (size_t)j * (size_t)step->inputs + (size_t)k * OUTPUTS, sums);
                for (int i = 0; i < OUTPUTS; i++)
                    for (int r = 0; r < GROUP; r++) total[i][r] += (int32_t)sums[i][r];
            }
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    double sum = total[i][r] + step->whole_bias[j + i];
                    float value = (float)(sum * step->unit[j + i]);
                    y[(j + i) * ROWS + g + r] = value < floor ? floor : value; /* NaN stays */
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

static void run_elementwise(const Step *step, float *x) {
    for (int k = 0; k < step->inputs; k++, x += ROWS) switch (step->kind) {
        case CLIP:
            for (int r = 0; r < ROWS; r++) { /* NaN stays, to be found in the end */
                float raised = x[r] < step->low ? step->low : x[r];
                x[r] = raised > step->high ? step->high : raised;
            }
            break;
        case MULTIPLY:
            for (int r = 0; r < ROWS; r++) x[r] *= step->values[k];
            break;
        case ADD:
            for (int r = 0; r < ROWS; r++) x[r] += step->values[k];
            break;
        default:
            for (int r = 0; r < ROWS; r++) x[r] = exponential(x[r]);
        }
}

/* Runs ROWS queries; returns the results, [outputs][ROWS], which are in `a` or `b`.  a: the queries,
 * [columns][ROWS].  Both have room for `widest` columns. */
static const float *run_decoder(const Decoder *decoder, float *a, float *b) {
    for (int i = 0; i < decoder->count; i++) {
        const Step *step = &decoder->steps[i];
        if (step->kind != PRODUCT && step->kind != INT8_PRODUCT) {
            run_elementwise(step, a);
            continue;
        }
        if (step->kind == PRODUCT)
            run_product(step, a, b);
        else
            run_int8_product(step, a, b);
        float *swap = a;
        a = b;
        b = swap;
    }
    return a;
}

static void *aligned(size_t size) {
    return aligned_alloc(ALIGNMENT, (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
}

#endif
