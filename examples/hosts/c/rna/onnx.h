/* The fields of a decoder's ONNX model: nodes, constants, the interface (section 6.2). */
#ifndef RNA_ONNX_H
#define RNA_ONNX_H

#include "protobuf.h"

/* TensorProto.DataType */
enum { ONNX_FLOAT = 1, ONNX_UINT8 = 2, ONNX_INT8 = 3, ONNX_INT32 = 6 };

/* The manifest's requirements on a decoder. */
typedef struct Interface {
    int columns;
    bool is_int8;
    int outputs;        /* 6 of transport, 3 of emission */
    const char *output; /* its name */
} Interface;

typedef struct OnnxTensor {
    Span name, raw;
    uint64_t type, dims[2];
    size_t rank;
    bool used;
} OnnxTensor;

typedef struct OnnxNode {
    Span operator, input[3], output;
    size_t inputs; /* how many */
    bool has_axis, used;
    uint64_t axis; /* of DequantizeLinear, the one attribute that a decoder has */
} OnnxNode;

typedef struct OnnxModel {
    OnnxTensor *tensors;
    OnnxNode *nodes;
    size_t tensor_count, node_count;
} OnnxModel;

static void free_onnx(OnnxModel *model) {
    free(model->tensors);
    free(model->nodes);
}

static bool add_dimension(Wire *wire, OnnxTensor *tensor, uint64_t size) {
    if (tensor->rank == 2) return breaks(wire, "a constant of more than two dimensions");
    tensor->dims[tensor->rank++] = size;
    return true;
}

static OnnxTensor read_tensor(Wire *wire, Span bytes) {
    static const unsigned ELSEWHERE[] = {3, 4, 5, 6, 7, 10, 11, 13}; /* where values may be but in raw_data */
    const Message message = read_message(wire, bytes);
    OnnxTensor tensor = {.name = text_field(wire, &message, 8),
                         .type = integer_field(wire, &message, 2),
                         .raw = bytes_field(wire, &message, 9)};
    bool elsewhere = integer_field(wire, &message, 14) != 0;
    for (size_t i = 0; i < sizeof ELSEWHERE / sizeof *ELSEWHERE; i++)
        elsewhere |= message.count[ELSEWHERE[i]] > 0;
    if (elsewhere) breaks(wire, "a constant whose values are not in raw_data");
    Span rest = message.bytes;
    Field field;
    while (next_of(wire, &rest, 1, &field)) {
        uint64_t size;
        if (field.is_integer) add_dimension(wire, &tensor, field.integer);
        while (field.bytes.size && take_varint(wire, &field.bytes, &size))
            if (!add_dimension(wire, &tensor, size)) break;
    }
    return tensor;
}

static bool is_default_domain(Span domain) { return domain.size == 0 || span_is(domain, "ai.onnx"); }

static void read_axis(Wire *wire, Span bytes, OnnxNode *node) {
    const Message message = read_message(wire, bytes);
    if (!span_is(text_field(wire, &message, 1), "axis") || !message.count[3])
        breaks(wire, "another attribute than axis");
    node->has_axis = true;
    node->axis = integer_field(wire, &message, 3);
}

static OnnxNode read_node(Wire *wire, Span bytes) {
    const Message message = read_message(wire, bytes);
    OnnxNode node = {.operator = text_field(wire, &message, 4), .output = text_field(wire, &message, 2)};
    Span rest = message.bytes;
    Field field;
    while (next_of(wire, &rest, 1, &field)) {
        if (node.inputs == 3 || field.is_integer || !is_utf8(field.bytes)) breaks(wire, "a node of other inputs");
        if (!wire->broken) node.input[node.inputs++] = field.bytes;
    }
    if (!is_default_domain(text_field(wire, &message, 7))) breaks(wire, "an operator of another domain");
    if (message.count[5]) read_axis(wire, bytes_field(wire, &message, 5), &node);
    return node;
}

/* Whether the input or output of the graph is float32 [N, width], N symbolic. */
static bool is_interface(Wire *wire, Span bytes, const char *name, int width) {
    const Message value = read_message(wire, bytes), type = read_message(wire, bytes_field(wire, &value, 2));
    const Message tensor = read_message(wire, bytes_field(wire, &type, 1));
    Span rest = bytes_field(wire, &tensor, 2);
    const Message shape = read_message(wire, rest);
    bool fits = span_is(text_field(wire, &value, 1), name) && integer_field(wire, &tensor, 1) == ONNX_FLOAT &&
                shape.count[1] == 2;
    Field field;
    for (int k = 0; next_of(wire, &rest, 1, &field); k++) {
        const Message dimension = read_message(wire, field.bytes);
        text_field(wire, &dimension, 2); /* the name of a symbolic one, which engines read */
        fits &= (dimension.count[1] > 0) == (k == 1);
        fits &= integer_field(wire, &dimension, 1) == (k ? (uint64_t)width : 0);
    }
    return fits || breaks(wire, name);
}

static bool check_versions(Wire *wire, const Message *model) {
    uint64_t ir = integer_field(wire, model, 1);
    const Message set = read_message(wire, bytes_field(wire, model, 8));
    uint64_t version = integer_field(wire, &set, 2);
    if (ir < 7 || ir > 10 || version < 13 || version > 21)
        return breaks(wire, "another IR version than 7 to 10, or another operator set than 13 to 21");
    return is_default_domain(text_field(wire, &set, 1)) || breaks(wire, "operators of another domain");
}

/* Reads the model; wire->broken says what is wrong with it.  The caller frees it in any case. */
static void read_onnx(Wire *wire, Span data, const Interface *interface, OnnxModel *model) {
    const Message whole = read_message(wire, data);
    const Message graph = read_message(wire, bytes_field(wire, &whole, 7));
    if (wire->broken || !check_versions(wire, &whole)) return;
    if (whole.count[20] || whole.count[25] || graph.count[15])
        breaks(wire, "functions, training or sparse tensors");
    if (!is_interface(wire, bytes_field(wire, &graph, 11), "queries", interface->columns) ||
        !is_interface(wire, bytes_field(wire, &graph, 12), interface->output, interface->outputs))
        return;
    if (graph.count[1] > MAX_NODES) breaks(wire, "more than 4096 nodes");
    model->nodes = calloc(graph.count[1] + 1, sizeof *model->nodes);
    model->tensors = calloc(graph.count[5] + 1, sizeof *model->tensors);
    if (!model->nodes || !model->tensors) breaks(wire, "more nodes than the memory holds");
    Span rest = graph.bytes;
    Field field;
    while (next_of(wire, &rest, 1, &field))
        model->nodes[model->node_count++] = read_node(wire, field.bytes);
    rest = graph.bytes;
    while (next_of(wire, &rest, 5, &field))
        model->tensors[model->tensor_count++] = read_tensor(wire, field.bytes);
}

#endif
