/* A decoder from an ONNX model: layers checked and packed (section 6.2). */
#ifndef RNA_DECODER_LOAD_H
#define RNA_DECODER_LOAD_H

#include "decoder_chain.h"

/* Packs a weight [b->width, outputs], of int8 or float32. */
static bool take_weights(Builder *b, Layer *layer, Span name, bool is_int8) {
    const OnnxTensor *weight = find_value(b, name).tensor;
    bool fits = weight && weight->rank == 2 && weight->dims[1] > 0 && weight->dims[1] <= MAX_WIDTH;
    if (!fits) return outside(b, "a layer of other than 1 to 8192 outputs");
    layer->inputs = b->width;
    layer->outputs = (int)weight->dims[1];
    b->work += (uint64_t)layer->inputs * weight->dims[1];
    if (layer != &b->decoder->matrix) b->results += weight->dims[1];
    if (b->results > MAX_QUERY_VALUES || b->work > MAX_QUERY_WORK)
        return stop(b, "DECODER_COST", "more values or multiply-adds of a query than 2^16 or 2^24");
    weight = constant(b, name, is_int8 ? ONNX_INT8 : ONNX_FLOAT, 2, layer->inputs, layer->outputs);
    if (!weight) return false;
    size_t inputs = (size_t)layer->inputs, outputs = (size_t)layer->outputs;
    size_t padded = (size_t)rounded_up(layer->outputs, OUTPUTS);
    layer->weights = allocate(b, inputs * padded, sizeof *layer->weights);
    if (!layer->weights) return false;
    for (size_t k = 0; k < inputs; k++)
        for (size_t j = 0; j < outputs; j++) {
            size_t from = k * outputs + j;
            float value = is_int8 ? (float)(int8_t)weight->raw.at[from] : float_at(weight, from);
            layer->weights[(j / OUTPUTS * inputs + k) * OUTPUTS + j % OUTPUTS] = value;
        }
    b->width = layer->outputs;
    if (b->width > b->decoder->widest) b->decoder->widest = b->width;
    return true;
}

/* The node that dequantizes constants along `axis` into an operand of a Gemm; NULL where it is none. */
static const OnnxNode *take_dequantized(Builder *b, Span name, uint64_t axis) {
    OnnxNode *node = find_value(b, name).node;
    bool fits = is_operator(node, "DequantizeLinear", 2) && node->has_axis && node->axis == axis;
    if (!fits || node->used || node >= &b->model.nodes[b->at]) {
        outside(b, "an operand of Gemm that is no DequantizeLinear of constants");
        return NULL;
    }
    node->used = true;
    return node;
}

/* The step of the next layer's inputs: QuantizeLinear and DequantizeLinear of one scale, zero point 0. */
static bool take_step(Builder *b, float *step) {
    float again;
    const OnnxNode *first = take_node(b, "QuantizeLinear", 2);
    const OnnxNode *second = first ? take_node(b, "DequantizeLinear", 2) : NULL;
    if (!second || !take_scalar(b, first->input[1], step)) return false;
    const OnnxTensor *zero = constant(b, first->input[2], ONNX_UINT8, 0, 1, 1);
    const OnnxTensor *zero_again = zero ? constant(b, second->input[2], ONNX_UINT8, 0, 1, 1) : NULL;
    if (!zero_again || !take_scalar(b, second->input[1], &again)) return false;
    return (*step == again && zero->raw.at[0] == 0 && zero_again->raw.at[0] == 0) ||
           outside(b, "a scale of its own, or a zero point");
}

static bool take_int8_layer(Builder *b, Layer *layer) {
    if (!take_step(b, &layer->step)) return false;
    const OnnxNode *gemm = take_node(b, "Gemm", 2);
    const OnnxNode *weight = gemm ? take_dequantized(b, gemm->input[1], 1) : NULL;
    const OnnxNode *bias = weight ? take_dequantized(b, gemm->input[2], 0) : NULL;
    if (!bias || !take_weights(b, layer, weight->input[0], true)) return false;
    if (!take_row(b, weight->input[1], layer->outputs, &layer->unit)) return false;
    const OnnxTensor *whole = constant(b, bias->input[0], ONNX_INT32, 1, 1, layer->outputs);
    const OnnxTensor *unit = whole ? constant(b, bias->input[1], ONNX_FLOAT, 1, 1, layer->outputs) : NULL;
    if (!unit) return false;
    layer->whole_bias = allocate(b, (size_t)rounded_up(layer->outputs, OUTPUTS), sizeof *layer->whole_bias);
    if (!layer->whole_bias) return false;
    for (size_t i = 0; i < (size_t)layer->outputs; i++) {
        layer->unit[i] *= layer->step;
        layer->whole_bias[i] = (int32_t)u32_at(whole->raw.at + 4 * i);
        if (layer->unit[i] != float_at(unit, i)) return outside(b, "a bias with a scale of its own");
    }
    return true;
}

static bool take_float_layer(Builder *b, Layer *layer) {
    const OnnxNode *gemm = take_node(b, "Gemm", 2);
    if (!gemm || !take_weights(b, layer, gemm->input[1], false)) return false;
    if (!take_row(b, gemm->input[2], layer->outputs, &layer->bias)) return false;
    layer->relu = is_operator(next_node(b), "Relu", 1);
    return !layer->relu || take_node(b, "Relu", 0);
}

static bool take_layers(Builder *b) {
    Decoder *decoder = b->decoder;
    decoder->layers = allocate(b, b->model.node_count + 1, sizeof *decoder->layers);
    bool last = decoder->layers == NULL;
    while (!last) {
        Layer *layer = &decoder->layers[decoder->count++];
        if (!(b->interface->is_int8 ? take_int8_layer : take_float_layer)(b, layer)) return false;
        last = b->interface->is_int8 ? is_operator(next_node(b), "Clip", 3) : !layer->relu;
    }
    return !b->code;
}

/* Exp, Sub, and Mul of a number or MatMul of a matrix. */
static bool take_end(Builder *b) {
    Decoder *decoder = b->decoder;
    float zero, one;
    if (!take_clip(b, &zero, &decoder->top)) return false;
    const OnnxNode *subtract = take_node(b, "Exp", 0) ? take_node(b, "Sub", 1) : NULL;
    if (!subtract || !take_scalar(b, subtract->input[1], &one)) return false;
    if (zero != 0 || one != 1) return outside(b, "another Clip than from 0, or another Sub than of 1");
    decoder->unit = 1;
    if (!is_operator(next_node(b), "MatMul", 2)) {
        const OnnxNode *multiply = take_node(b, "Mul", 1);
        return multiply && take_scalar(b, multiply->input[1], &decoder->unit);
    }
    const OnnxNode *product = take_node(b, "MatMul", 1);
    decoder->matrix.bias = allocate(b, (size_t)rounded_up(b->interface->outputs, OUTPUTS), sizeof(float));
    return product && decoder->matrix.bias && take_weights(b, &decoder->matrix, product->input[1], false);
}

/* Follows the one chain from the queries to the output. */
static bool build_decoder(Builder *b) {
    Decoder *decoder = b->decoder;
    decoder->columns = decoder->widest = b->width;
    if (!take_clip(b, &decoder->low, &decoder->high)) return false;
    if (b->interface->is_int8) {
        const OnnxNode *gain = take_node(b, "Mul", 1), *offset = gain ? take_node(b, "Add", 1) : NULL;
        if (!offset || !take_row(b, gain->input[1], b->width, &decoder->gain) ||
            !take_row(b, offset->input[1], b->width, &decoder->offset))
            return false;
    }
    if (!take_layers(b) || !take_end(b)) return false;
    bool all = true;
    for (size_t i = 0; i < b->model.node_count; i++) all &= b->model.nodes[i].used;
    for (size_t i = 0; i < b->model.tensor_count; i++) all &= b->model.tensors[i].used;
    if (!all) return outside(b, "a node or a constant that the chain does not have");
    return (span_is(b->value, b->interface->output) && b->width == b->interface->outputs) ||
           outside(b, "a last node that does not make the output");
}

/* Rows filled with 0, +-1, +-1e4 and about +-3.4e38, and random ones, give finite results that are
 * not negative. */
static bool check_results(Builder *b) {
    static const float PROBES[] = {0, 1, -1, 1e4f, -1e4f, FLT_MAX, -3.4e38f};
    enum { PROBE_COUNT = sizeof PROBES / sizeof *PROBES };
    const Decoder *decoder = b->decoder;
    size_t size = sizeof(float) * ROWS * (size_t)rounded_up(decoder->widest, OUTPUTS);
    float *x = aligned(size), *y = aligned(size);
    bool good = x && y;
    uint32_t random = 1;
    for (int k = 0; good && k < decoder->columns; k++)
        for (int r = 0; r < ROWS; r++) {
            random = random * 1664525u + 1013904223u;
            x[k * ROWS + r] = r < PROBE_COUNT ? PROBES[r] : (float)random * 0x1p-31f - 1; /* -1 to 1 */
        }
    const float *results = good ? run_decoder(decoder, x, y) : NULL;
    for (int i = 0; good && i < b->interface->outputs * ROWS; i++)
        good = results[i] >= 0 && results[i] <= FLT_MAX;
    free_aligned(x);
    free_aligned(y);
    return good || stop(b, "DECODER_RESULT", "results that are not finite, or below 0");
}

/* Whether an int8 layer has weights, of inputs 2k and 2k + 1, of one sign that add up to more than 128. */
static bool saturates(const Layer *layer) {
    for (int j = 0; j < layer->outputs; j++)
        for (int k = 0; k + 1 < layer->inputs; k += 2) {
            const float *w = &layer->weights[(j / OUTPUTS * layer->inputs + k) * OUTPUTS + j % OUTPUTS];
            if (w[0] * w[OUTPUTS] >= 0 && fabsf(w[0] + w[OUTPUTS]) > 128) return true;
        }
    return false;
}

/* Checks a decoder, and loads it. */
static void read_decoder(Span data, const Interface *interface, Decoder *decoder, const char *entry,
                         RnaReport *report) {
    if (data.size > MAX_DECODER) {
        refuse(report, "DECODER_TOO_LARGE", entry, "at most 64 MiB", "%zu bytes", data.size);
        return;
    }
    Builder b = {.interface = interface, .decoder = decoder, .value = text_span("queries"),
                 .width = interface->columns, .results = (uint64_t)interface->outputs};
    Wire wire = {0};
    read_onnx(&wire, data, interface, &b.model);
    if (wire.broken) outside(&b, wire.broken);
    bool good = !b.code && name_values(&b) && build_decoder(&b) && check_results(&b);
    if (!good) refuse(report, b.code, entry, "a decoder as the format has it", "%s", b.found);
    for (int i = 0; good && interface->is_int8 && i < decoder->count; i++)
        if (saturates(&decoder->layers[i])) {
            warn(report, "DECODER_SATURATION", entry, "pairs of weights up to 128", "larger ones");
            break;
        }
    free(b.values);
    free_onnx(&b.model);
}

#endif
