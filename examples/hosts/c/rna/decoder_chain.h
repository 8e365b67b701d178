/* The one chain of nodes that a decoder may be, and its constants, taken one after the other (section 6.2). */
#ifndef RNA_DECODER_CHAIN_H
#define RNA_DECODER_CHAIN_H

#include "decoder.h"
#include "onnx.h"

/* The source of a value: a constant of the model, or a node; the queries have neither. */
typedef struct Value {
    Span name;
    OnnxTensor *tensor;
    OnnxNode *node;
} Value;

/* A model on its way to a Decoder. */
typedef struct Builder {
    OnnxModel model;
    Value *values; /* in the order of their names */
    size_t count, at; /* of the values; the next node */
    const Interface *interface;
    Decoder *decoder;
    Span value; /* what the chain has made so far */
    int width;
    uint64_t results, work; /* of a query */
    const char *code, *found; /* what is wrong, once something is */
} Builder;

/* Notes what is wrong.  Returns false, so that a step can end with it. */
static bool stop(Builder *b, const char *code, const char *found) {
    if (!b->code) b->code = code, b->found = found;
    return false;
}

static bool outside(Builder *b, const char *found) { return stop(b, "DECODER_PROFILE", found); }

/* Zeros; NULL where memory is out. */
static void *allocate(Builder *b, size_t count, size_t size) {
    void *block = calloc(count, size);
    if (!block) stop(b, "FILE_UNREADABLE", "not enough memory");
    return block;
}

static int compare_values(const void *a, const void *b) {
    return compare_spans(((const Value *)a)->name, ((const Value *)b)->name);
}

/* Sorts what the model has by name; each has a name of its own. */
static bool name_values(Builder *b) {
    OnnxModel *model = &b->model;
    b->values = allocate(b, 1 + model->tensor_count + model->node_count, sizeof *b->values);
    if (!b->values) return false;
    b->values[b->count++] = (Value){.name = text_span("queries")};
    for (size_t i = 0; i < model->tensor_count; i++)
        b->values[b->count++] = (Value){model->tensors[i].name, &model->tensors[i], NULL};
    for (size_t i = 0; i < model->node_count; i++)
        b->values[b->count++] = (Value){model->nodes[i].output, NULL, &model->nodes[i]};
    qsort(b->values, b->count, sizeof *b->values, compare_values);
    for (size_t i = 0; i < b->count; i++)
        if (b->values[i].name.size == 0 || (i && same_span(b->values[i].name, b->values[i - 1].name)))
            return outside(b, "a value without a name, or made twice");
    return true;
}

static Value find_value(const Builder *b, Span name) {
    const Value key = {.name = name};
    const Value *match = bsearch(&key, b->values, b->count, sizeof key, compare_values);
    return match ? *match : key;
}

static bool is_operator(const OnnxNode *node, const char *operator, size_t inputs) {
    return node && span_is(node->operator, operator) && node->inputs == inputs;
}

/* The next node of the chain; NULL behind the last.  Those that dequantize constants stand anywhere before
 * their Gemm. */
static OnnxNode *next_node(Builder *b) {
    for (; b->at < b->model.node_count; b->at++) {
        OnnxNode *node = &b->model.nodes[b->at];
        if (!span_is(node->operator, "DequantizeLinear") || !find_value(b, node->input[0]).tensor) return node;
    }
    return NULL;
}

/* Takes the next node, which is this operator of the value and `constants` more; NULL where it is not. */
static const OnnxNode *take_node(Builder *b, const char *operator, size_t constants) {
    OnnxNode *node = next_node(b);
    if (!is_operator(node, operator, constants + 1) || node->has_axis || !same_span(node->input[0], b->value)) {
        outside(b, operator);
        return NULL;
    }
    node->used = true;
    b->value = node->output;
    b->at++;
    return node;
}

static float float_at(const OnnxTensor *tensor, size_t i) {
    float value;
    memcpy(&value, tensor->raw.at + 4 * i, sizeof value);
    return value;
}

/* The constant of this name, of this type and shape; NULL where it is another. */
static const OnnxTensor *constant(Builder *b, Span name, uint64_t type, size_t rank, int rows, int columns) {
    OnnxTensor *tensor = find_value(b, name).tensor;
    const uint64_t sides[] = {(uint64_t)(rank == 2 ? rows : columns), (uint64_t)columns};
    size_t count = 1, item = type == ONNX_FLOAT || type == ONNX_INT32 ? 4 : 1;
    bool fits = tensor && tensor->type == type && tensor->rank == rank;
    for (size_t k = 0; k < rank; k++, count *= (size_t)sides[k - 1]) fits = fits && tensor->dims[k] == sides[k];
    if (!fits || tensor->raw.size != count * item) {
        outside(b, "a constant of another type or shape");
        return NULL;
    }
    for (size_t i = 0; type == ONNX_FLOAT && i < count; i++)
        if (!isfinite(float_at(tensor, i))) {
            stop(b, "DECODER_RESULT", "a constant that is NaN or infinite");
            return NULL;
        }
    tensor->used = true;
    return tensor;
}

static bool take_scalar(Builder *b, Span name, float *value) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT, 0, 1, 1);
    if (tensor) *value = float_at(tensor, 0);
    return tensor != NULL;
}

static bool take_clip(Builder *b, float *low, float *high) {
    const OnnxNode *node = take_node(b, "Clip", 2);
    return node && take_scalar(b, node->input[1], low) && take_scalar(b, node->input[2], high);
}

/* `width` values, and room to the next multiple of OUTPUTS; *values: the caller frees it in any case. */
static bool take_row(Builder *b, Span name, int width, float **values) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT, 1, 1, width);
    if (!tensor) return false;
    *values = allocate(b, (size_t)rounded_up(width, OUTPUTS), sizeof **values);
    for (size_t i = 0; *values && i < (size_t)width; i++) (*values)[i] = float_at(tensor, i);
    return *values != NULL;
}

#endif
