/* Checks of an ONNX model's structure (section 6.2). */
#ifndef RNA_ONNX_CHECKS_H
#define RNA_ONNX_CHECKS_H

#include "onnx_bounds.h"

static const Span QUERIES = {(const uint8_t *)"queries", 7};

/* What a decoder must be, by the manifest. */
typedef struct Interface {
    int columns;
    bool is_int8;
    int outputs;        /* 6 of transport, 3 of emission */
    const char *output; /* its name */
} Interface;

static bool check_nodes(const OnnxModel *model, bool is_int8, const char *entry, RnaReport *report) {
    static const char OPERATORS[] =
        "Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp "
        "Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN "
        "LayerNormalization LeakyRelu Less LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu "
        "Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice Softplus Softsign Split Sqrt "
        "Sub Sum Tanh ThresholdedRelu Where Xor";
    if (model->nested)
        return refuse(report, "DECODER_NESTED", entry, "no functions, training or sparse tensors", "some");
    if (model->nodes.count > MAX_NODES)
        return refuse(report, "DECODER_GRAPH", entry, "at most 4096 nodes", "%zu", model->nodes.count);
    bool quantized = false;
    for (size_t i = 0; i < model->nodes.count; i++) {
        const OnnxNode *node = &model->nodes.at[i];
        int size = (int)(node->operator.size < 64 ? node->operator.size : 64);
        const char *name = (const char *)node->operator.at;
        if (!is_default_domain(node->domain))
            return refuse(report, "DECODER_DOMAIN", entry, "the default domain", "another in node %zu", i);
        if (node->nested)
            return refuse(report, "DECODER_NESTED", entry, "no graphs", "one in node %zu", i);
        if (!is_choice(node->operator, OPERATORS))
            return refuse(report, "DECODER_OPERATOR", entry, "an operator of the list", "%.*s", size, name);
        quantized |= is_choice(node->operator, "QuantizeLinear DequantizeLinear");
    }
    return quantized == is_int8 || refuse(report, "DECODER_PRECISION", entry, is_int8 ? "int8" : "float32",
                                          quantized ? "int8" : "float32");
}

static bool check_onnx_tensors(const OnnxModel *model, const char *entry, RnaReport *report) {
    static const uint64_t TYPES = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 6 | 1 << 7 | 1 << 9 | 1 << 10;
    for (size_t i = 0; i < model->tensors.count; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        if (tensor->external)
            return refuse(report, "DECODER_EXTERNAL", entry, "data in the file", "external data");
        bool known = tensor->type < 64 && TYPES >> tensor->type & 1;
        if (!known || tensor->rank > 2 || tensor->widest > MAX_WIDTH)
            return refuse(report, "DECODER_TENSOR", entry, "at most 2 dimensions of at most 8192",
                          "type %llu, %zu dimensions", (unsigned long long)tensor->type, tensor->rank);
    }
    return true;
}

static bool is_interface(const OnnxValue *value, size_t count, Span name, int width) {
    return count == 1 && same_span(value->name, name) && value->type == ONNX_FLOAT && value->rank == 2 &&
           value->symbolic[0] && !value->symbolic[1] && value->dims[1] == (uint64_t)width;
}

/* Checks the structure (section 6.2).  `values`: written, of the whole graph; the caller frees it. */
static bool check_onnx(Span data, const Interface *interface, OnnxModel *model, ValueTable *values,
                       const char *entry, RnaReport *report) {
    if (data.size > MAX_DECODER)
        return refuse(report, "DECODER_TOO_LARGE", entry, "at most 64 MiB", "%zu bytes", data.size);
    Wire wire = {0};
    read_onnx(&wire, data, model);
    if (wire.broken || model->opsets == 0 || model->nodes.count == 0)
        return refuse(report, "DECODER_NOT_ONNX", entry, "an ONNX ModelProto", "%s",
                      wire.broken ? wire.broken : "no operator set or no nodes");
    if (model->foreign_domain)
        return refuse(report, "DECODER_DOMAIN", entry, "the default domain, once", "more");
    if (model->bad_opset || model->ir_version < 7 || model->ir_version > 10)
        return refuse(report, "DECODER_VERSION", entry, "IR 7 to 10 and operator set 13 to 21", "others");
    if (!is_interface(&model->input, model->inputs, QUERIES, interface->columns))
        return refuse(report, "DECODER_INPUT", entry, "queries float32 [N, K], N symbolic", "another");
    if (!is_interface(&model->output, model->outputs, text_span(interface->output), interface->outputs))
        return refuse(report, "DECODER_OUTPUT", entry, "the one output, float32, N symbolic", "another");
    if (!check_nodes(model, interface->is_int8, entry, report) || !check_onnx_tensors(model, entry, report))
        return false;
    size_t room = 64;
    while (room < 2 * (model->tensors.count + model->names.count + 2)) room *= 2;
    *values = (ValueTable){calloc(room, sizeof(Value)), room - 1};
    if (!values->at)
        return refuse(report, "DECODER_LOAD", entry, "memory for its values", "not enough");
    return check_bounds(model, values, QUERIES, interface->columns, interface->output, entry, report);
}

#endif
