/* A decoder from an ONNX model: the chains that decoder.h runs, checked (section 6.4). */
#ifndef RNA_DECODER_LOAD_H
#define RNA_DECODER_LOAD_H

#include "decoder.h"
#include "onnx_checks.h"

/* A graph on its way to a Decoder. */
typedef struct Builder {
    const OnnxModel *model;
    const ValueTable *values;
    const Interface *interface;
    Decoder *decoder;
    size_t node; /* the next one */
    Span value;  /* what the chain has made so far */
    int width;
    char kinds[MAX_NODES + 1]; /* one letter a step, for the profile */
    int letters;
    bool plain; /* constants have no other shapes than the profile's */
    size_t used; /* nodes that the chain holds */
} Builder;

typedef enum Outcome {
    LOADED,
    NO_CHAIN, /* needs an ONNX engine */
    DOES_NOT_FIT
} Outcome;

/* The initializer `name` of this type, with all its values in raw_data; NULL where it is none. */
static const OnnxTensor *constant(const Builder *b, Span name, uint64_t type) {
    const Value *value = find_value(b->values, name);
    if (!value->known || value->tensor < 0 || name.size == 0) return NULL;
    const OnnxTensor *tensor = &b->model->tensors.at[value->tensor];
    return tensor->type == type && tensor->has_raw && !tensor->elsewhere ? tensor : NULL;
}

static uint64_t element_count(const OnnxTensor *tensor) {
    return (tensor->rank > 0 ? tensor->dims[0] : 1) * (tensor->rank > 1 ? tensor->dims[1] : 1);
}

static bool has_bytes(const OnnxTensor *tensor, unsigned item) {
    return tensor->raw.size == element_count(tensor) * item;
}

static float float_at(const OnnxTensor *tensor, uint64_t i) {
    float value;
    memcpy(&value, tensor->raw.at + 4 * i, sizeof value);
    return value;
}

static Outcome one_float(Builder *b, Span name, float *value) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT);
    if (!tensor) return NO_CHAIN;
    if (element_count(tensor) != 1 || !has_bytes(tensor, 4)) return DOES_NOT_FIT;
    b->plain &= tensor->rank == 0;
    *value = float_at(tensor, 0);
    return LOADED;
}

/* A value for each of `width` columns, from a constant of one or of so many.  rank: that the profile
 * asks for. */
static Outcome column_floats(Builder *b, Span name, int width, size_t rank, float **values) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT);
    if (!tensor || tensor->rank > 1) return NO_CHAIN;
    uint64_t count = element_count(tensor);
    if ((count != 1 && count != (uint64_t)width) || !has_bytes(tensor, 4)) return DOES_NOT_FIT;
    b->plain &= tensor->rank == rank && (rank == 0 || count == (uint64_t)width);
    *values = aligned(sizeof(float) * (size_t)rounded_up(width, OUTPUTS));
    if (!*values) return DOES_NOT_FIT;
    for (int i = 0; i < rounded_up(width, OUTPUTS); i++)
        (*values)[i] = i < width ? float_at(tensor, count == 1 ? 0 : (uint64_t)i) : 0;
    return LOADED;
}

static const OnnxNode *node_that_makes(const Builder *b, Span name) {
    const Value *value = find_value(b->values, name);
    return value->known && value->node >= 0 ? &b->model->nodes.at[value->node] : NULL;
}

static Span name_of(const Builder *b, const OnnxNode *node, size_t i) {
    return b->model->names.at[node->first_name + i];
}

/* Packs a weight [inputs, outputs] of the step's sizes; of int8 where `is_int8`. */
static Outcome pack_weights(Step *step, const OnnxTensor *weight, bool is_int8) {
    if (weight->rank != 2 || weight->dims[0] != (uint64_t)step->inputs || weight->dims[1] == 0 ||
        !has_bytes(weight, is_int8 ? 1 : 4))
        return DOES_NOT_FIT;
    step->outputs = (int)weight->dims[1];
    size_t inputs = (size_t)step->inputs, outputs = (size_t)step->outputs;
    size_t padded = (size_t)rounded_up(step->outputs, OUTPUTS);
    step->weights = aligned(sizeof(float) * inputs * padded);
    if (!step->weights) return DOES_NOT_FIT;
    for (size_t j = 0; j < padded; j++)
        for (size_t k = 0; k < inputs; k++) {
            size_t from = k * outputs + j;
            float value = j >= outputs ? 0
                          : is_int8    ? (float)(int8_t)weight->raw.at[from]
                                       : float_at(weight, from);
            step->weights[(j / OUTPUTS * inputs + k) * OUTPUTS + j % OUTPUTS] = value;
        }
    return LOADED;
}

static Outcome add_product(Builder *b, Step *step, const OnnxNode *node) {
    bool is_gemm = span_is(node->operator, "Gemm");
    const OnnxTensor *weight = constant(b, name_of(b, node, 1), ONNX_FLOAT);
    if (!weight || node->inputs != (is_gemm ? 3 : 2)) return NO_CHAIN;
    step->kind = PRODUCT;
    Outcome outcome = pack_weights(step, weight, false);
    if (outcome != LOADED) return outcome;
    if (is_gemm) return column_floats(b, name_of(b, node, 2), step->outputs, 1, &step->bias);
    step->bias = calloc((size_t)rounded_up(step->outputs, OUTPUTS), sizeof *step->bias);
    return step->bias ? LOADED : DOES_NOT_FIT;
}

/* DequantizeLinear of a constant of `type` along `axis`, whose result is `name`; its operands. */
static bool is_dequantized(Builder *b, Span name, uint64_t type, int64_t axis,
                           const OnnxTensor **tensor, Span *scale) {
    const OnnxNode *node = node_that_makes(b, name);
    if (!node || !span_is(node->operator, "DequantizeLinear") || node->inputs != 2) return false;
    if (node->attributes > 1 || (node->attributes && !node->has_axis)) return false;
    if ((node->has_axis ? node->axis : 1) != axis) return false;
    b->plain &= node->has_axis;
    *tensor = constant(b, name_of(b, node, 0), type);
    *scale = name_of(b, node, 1);
    return *tensor != NULL;
}

static bool same_constant(const Builder *b, Span x, Span y, uint64_t type) {
    const OnnxTensor *a = constant(b, x, type), *c = constant(b, y, type);
    return a && c && same_span(a->raw, c->raw);
}

/* The first node of the chain from `node` on: without those that dequantize constants, which stand
 * anywhere before their Gemm. */
static size_t next_in_chain(const Builder *b, size_t node) {
    for (; node < b->model->nodes.count; node++) {
        const OnnxNode *at = &b->model->nodes.at[node];
        if (!span_is(at->operator, "DequantizeLinear") || at->inputs == 0) break;
        if (find_value(b->values, name_of(b, at, 0))->tensor < 0) break;
    }
    return node;
}

/* The bias as it is stored, in units of the sums. */
static Outcome add_whole_bias(Builder *b, Step *step, const OnnxTensor *bias, Span scale_name) {
    float *scale = NULL;
    Outcome outcome = column_floats(b, scale_name, step->outputs, 1, &scale);
    bool fits = bias->rank == 1 && bias->dims[0] == (uint64_t)step->outputs && has_bytes(bias, 4);
    if (outcome == LOADED && !fits) outcome = DOES_NOT_FIT;
    step->whole_bias = calloc((size_t)rounded_up(step->outputs, OUTPUTS), sizeof *step->whole_bias);
    if (!step->whole_bias) outcome = DOES_NOT_FIT;
    for (int i = 0; outcome == LOADED && i < step->outputs; i++) {
        if (!(fabsf(scale[i] - step->unit[i]) <= 1e-6f * fabsf(step->unit[i]))) outcome = NO_CHAIN;
        step->whole_bias[i] = (int32_t)u32_at(bias->raw.at + 4 * i);
    }
    free(scale);
    return outcome;
}

/* QuantizeLinear, DequantizeLinear and a Gemm of dequantized constants: one layer in integers. */
static Outcome add_int8_product(Builder *b, Step *step, const OnnxNode *quantize) {
    size_t second = next_in_chain(b, b->node + 1), third = next_in_chain(b, second + 1);
    if (third >= b->model->nodes.count || quantize->inputs != 3) return NO_CHAIN;
    const OnnxNode *dequantize = &b->model->nodes.at[second], *gemm = &b->model->nodes.at[third];
    bool chained = span_is(dequantize->operator, "DequantizeLinear") && span_is(gemm->operator, "Gemm") &&
                   dequantize->inputs == 3 && gemm->inputs == 3 && dequantize->outputs == 1 &&
                   gemm->outputs == 1 && quantize->attributes == 0 && dequantize->attributes == 0 &&
                   gemm->attributes == 0 && same_span(name_of(b, dequantize, 0), name_of(b, quantize, 3)) &&
                   same_span(name_of(b, gemm, 0), name_of(b, dequantize, 3)) &&
                   same_constant(b, name_of(b, quantize, 1), name_of(b, dequantize, 1), ONNX_FLOAT) &&
                   same_constant(b, name_of(b, quantize, 2), name_of(b, dequantize, 2), ONNX_UINT8);
    const OnnxTensor *weight, *bias, *zero = constant(b, name_of(b, quantize, 2), ONNX_UINT8);
    Span weight_scale, bias_scale;
    if (!chained || !is_dequantized(b, name_of(b, gemm, 1), ONNX_INT8, 1, &weight, &weight_scale) ||
        !is_dequantized(b, name_of(b, gemm, 2), ONNX_INT32, 0, &bias, &bias_scale))
        return NO_CHAIN;
    step->kind = INT8_PRODUCT;
    Outcome outcome = one_float(b, name_of(b, quantize, 1), &step->step);
    if (outcome != LOADED) return outcome;
    if (element_count(zero) != 1 || !has_bytes(zero, 1)) return DOES_NOT_FIT;
    /* Stored less the zero point, so that nothing is left of it in the sums. */
    step->low = -(float)zero->raw.at[0];
    step->high = 255 + step->low;
    if ((outcome = pack_weights(step, weight, true)) != LOADED) return outcome;
    if ((outcome = column_floats(b, weight_scale, step->outputs, 1, &step->unit)) != LOADED) return outcome;
    for (int i = 0; i < step->outputs; i++) step->unit[i] *= step->step;
    if ((outcome = add_whole_bias(b, step, bias, bias_scale)) != LOADED) return outcome;
    b->node = third;
    b->used += 4;
    return LOADED;
}

static Outcome add_elementwise(Builder *b, Step *step, const OnnxNode *node) {
    if (span_is(node->operator, "Exp")) {
        step->kind = EXP;
        return node->inputs == 1 ? LOADED : NO_CHAIN;
    }
    if (span_is(node->operator, "Clip")) {
        step->kind = CLIP;
        if (node->inputs != 3) return NO_CHAIN;
        Outcome outcome = one_float(b, name_of(b, node, 1), &step->low);
        return outcome != LOADED ? outcome : one_float(b, name_of(b, node, 2), &step->high);
    }
    if (node->inputs != 2) return NO_CHAIN;
    bool enters = b->letters <= 3; /* gain and offset, one a column */
    step->kind = span_is(node->operator, "Mul") ? MULTIPLY : ADD;
    Outcome outcome = column_floats(b, name_of(b, node, 1), b->width, enters, &step->values);
    if (outcome == LOADED && span_is(node->operator, "Sub"))
        for (int k = 0; k < b->width; k++) step->values[k] = -step->values[k];
    return outcome;
}

/* The next operator of the chain. */
static Outcome add_step(Builder *b) {
    static const struct {
        const char *operator;
        char letter;
    } KINDS[] = {{"Clip", 'C'}, {"Mul", 'M'},  {"Add", 'A'},    {"Sub", 'S'}, {"Exp", 'E'},
                 {"Relu", 'R'}, {"Gemm", 'G'}, {"MatMul", 'X'}, {"QuantizeLinear", '8'}};
    const OnnxNode *node = &b->model->nodes.at[b->node];
    size_t kind = 0;
    while (kind < sizeof KINDS / sizeof *KINDS && !span_is(node->operator, KINDS[kind].operator)) kind++;
    if (kind == sizeof KINDS / sizeof *KINDS || node->attributes || node->outputs != 1 ||
        node->inputs == 0 || !same_span(name_of(b, node, 0), b->value))
        return NO_CHAIN;
    Decoder *decoder = b->decoder;
    char letter = KINDS[kind].letter;
    b->kinds[b->letters++] = letter;
    Step *step = &decoder->steps[decoder->count];
    if (letter == 'R') {
        if (node->inputs != 1 || b->letters < 2 || !strchr("GX8", b->kinds[b->letters - 2])) return NO_CHAIN;
        step[-1].relu = true;
    } else {
        *step = (Step){.inputs = b->width, .outputs = b->width};
        decoder->count++;
        Outcome outcome = letter == '8'                    ? add_int8_product(b, step, node)
                          : letter == 'G' || letter == 'X' ? add_product(b, step, node)
                                                           : add_elementwise(b, step, node);
        if (outcome != LOADED) return outcome;
        b->width = step->outputs;
        if (b->width > decoder->widest) decoder->widest = b->width;
    }
    node = &b->model->nodes.at[b->node++];
    b->value = name_of(b, node, node->inputs);
    b->used++;
    return LOADED;
}

/* Whether the chain is one of the decoder profile (section 6.4): the letters of its steps, and the
 * numbers of the last Clip and of Sub, which are fixed. */
static bool is_in_profile(const Builder *b) {
    const char *at = b->kinds;
    if (*at++ != 'C') return false;
    if (*at == 'G') {
        while (at[0] == 'G' && at[1] == 'R') at += 2;
        if (*at++ != 'G') return false;
    } else {
        if (*at++ != 'M' || *at++ != 'A' || *at != '8') return false;
        while (*at == '8') at++;
    }
    if (strcmp(at, "CESM") && strcmp(at, "CESX")) return false;
    const Step *clip = &b->decoder->steps[b->decoder->count - 4], *subtract = clip + 2;
    return b->plain && clip->low == 0 && subtract->values[0] == -1;
}

static Outcome build_decoder(Builder *b) {
    Decoder *decoder = b->decoder;
    size_t nodes = b->model->nodes.count;
    decoder->columns = decoder->widest = b->width;
    decoder->steps = calloc(nodes, sizeof *decoder->steps);
    if (!decoder->steps) return DOES_NOT_FIT;
    while ((b->node = next_in_chain(b, b->node)) < nodes) {
        Outcome outcome = add_step(b);
        if (outcome != LOADED) return outcome;
    }
    if (!span_is(b->value, b->interface->output) || b->used != nodes) return NO_CHAIN;
    decoder->in_profile = is_in_profile(b);
    return b->width == b->interface->outputs ? LOADED : DOES_NOT_FIT;
}

/* Rows filled with 0, +-1, +-1e4 and about +-3.4e38, and random ones, give finite results that are
 * not negative. */
static bool check_results(const Decoder *decoder, int outputs, const char *entry, RnaReport *report) {
    static const float PROBES[] = {0, 1, -1, 1e4f, -1e4f, FLT_MAX, -3.4e38f};
    enum { PROBE_COUNT = sizeof PROBES / sizeof *PROBES };
    size_t size = sizeof(float) * ROWS * (size_t)rounded_up(decoder->widest, OUTPUTS);
    float *a = aligned(size), *b = aligned(size);
    bool good = a && b;
    uint32_t random = 1;
    for (int k = 0; good && k < decoder->columns; k++)
        for (int r = 0; r < ROWS; r++) {
            random = random * 1664525u + 1013904223u;
            a[k * ROWS + r] = r < PROBE_COUNT ? PROBES[r] : (float)random * 0x1p-31f - 1; /* -1 to 1 */
        }
    const float *results = good ? run_decoder(decoder, a, b) : NULL;
    for (int i = 0; good && i < outputs * ROWS; i++) good = results[i] >= 0 && results[i] <= FLT_MAX;
    free(a);
    free(b);
    return good || refuse(report, "DECODER_RESULT", entry, "finite and >= 0 for any finite input", "others");
}

/* Whether an int8 matrix has weights, in rows 2k and 2k + 1, that add up to more than 128. */
static bool saturates(const OnnxModel *model) {
    for (size_t i = 0; i < model->initializers; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        size_t inputs = (size_t)tensor->dims[0], outputs = (size_t)tensor->dims[1];
        if (tensor->type != ONNX_INT8 || tensor->rank != 2 || !tensor->has_raw) continue;
        if (!has_bytes(tensor, 1)) continue;
        const int8_t *w = (const int8_t *)tensor->raw.at;
        for (size_t k = 0; k < inputs; k += 2)
            for (size_t j = 0; j < outputs; j++) {
                int x = w[k * outputs + j], y = k + 1 < inputs ? w[(k + 1) * outputs + j] : 0;
                if ((x >= 0) == (y >= 0) && abs(x + y) > 128) return true;
            }
    }
    return false;
}

/* Checks a decoder, and loads it where it is a chain. */
static void read_decoder(Span data, const Interface *interface, Decoder *decoder, const char *entry,
                         RnaReport *report) {
    OnnxModel model = {0};
    ValueTable values = {0};
    Builder *builder = calloc(1, sizeof *builder);
    if (!builder) refuse(report, "DECODER_LOAD", entry, "memory for it", "not enough");
    if (builder && check_onnx(data, interface, &model, &values, entry, report)) {
        *builder = (Builder){&model, &values, interface, decoder, .value = QUERIES,
                             .width = interface->columns, .plain = true};
        Outcome outcome = build_decoder(builder);
        if (outcome == DOES_NOT_FIT)
            refuse(report, "DECODER_LOAD", entry, "constants that fit each other", "others");
        if (outcome == LOADED) decoder->runs = check_results(decoder, interface->outputs, entry, report);
        if (outcome != DOES_NOT_FIT && !decoder->in_profile)
            warn(report, "DECODER_PROFILE", entry, "the decoder profile", "other operators");
        if (outcome != DOES_NOT_FIT && saturates(&model))
            warn(report, "DECODER_SATURATION", entry, "pairs of weights up to 128", "larger ones");
    }
    free(builder);
    free(values.at);
    free_onnx(&model);
}

#endif
