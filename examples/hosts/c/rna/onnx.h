/* What is read of an ONNX model, whatever it computes (section 6.2). */
#ifndef RNA_ONNX_H
#define RNA_ONNX_H

#include "protobuf.h"

/* TensorProto.DataType */
enum { ONNX_FLOAT = 1, ONNX_UINT8 = 2, ONNX_INT8 = 3, ONNX_INT32 = 6 };

typedef struct OnnxTensor {
    Span name;
    uint64_t type;
    uint64_t dims[2];
    size_t rank;
    uint64_t widest; /* the largest dimension, 1 where there is none */
    bool external, elsewhere; /* elsewhere: the values are not in raw_data alone */
    bool has_raw;
    Span raw;
} OnnxTensor;

typedef struct OnnxNode {
    Span operator, domain;
    size_t first_name;      /* in OnnxModel.names: the inputs, then the outputs */
    size_t inputs, outputs; /* how many */
    size_t first_tensor, tensors; /* in OnnxModel.tensors: those in its attributes */
    uint64_t longest_list;        /* in its attributes */
    size_t attributes;
    bool nested, has_axis, transposes_first, transposes_second;
    int64_t axis;
} OnnxNode;

typedef struct OnnxValue { /* an input or output of the graph */
    Span name;
    uint64_t type, dims[2];
    bool symbolic[2];
    size_t rank;
} OnnxValue;

typedef struct OnnxModel {
    uint64_t ir_version;
    size_t opsets;
    bool foreign_domain, bad_opset, nested;
    size_t initializers; /* how many of the tensors; the others are in attributes */
    struct { OnnxTensor *at; size_t count, room; } tensors;
    struct { OnnxNode *at; size_t count, room; } nodes;
    struct { Span *at; size_t count, room; } names;
    OnnxValue input, output; /* the last ones */
    size_t inputs, outputs;
} OnnxModel;

static void free_onnx(OnnxModel *model) {
    free(model->tensors.at);
    free(model->nodes.at);
    free(model->names.at);
}

static void read_dims(Wire *wire, OnnxTensor *tensor, const Field *field) {
    Span packed = field->is_integer ? (Span){0} : field->bytes;
    bool single = field->is_integer;
    while (single || packed.size) {
        uint64_t size = field->integer;
        if (!single && !(spend(wire) && take_varint(wire, &packed, &size))) return;
        if (tensor->rank < 2) tensor->dims[tensor->rank] = size;
        if (tensor->rank == 0 || size > tensor->widest) tensor->widest = size;
        tensor->rank++;
        single = false;
    }
}

static void read_location(Wire *wire, OnnxTensor *tensor, const Field *field) {
    Span packed = field->is_integer ? (Span){0} : field->bytes;
    if (field->is_integer) tensor->external |= field->integer != 0;
    while (packed.size) {
        uint64_t value;
        if (!(spend(wire) && take_varint(wire, &packed, &value))) return;
        tensor->external |= value != 0;
    }
}

static void read_tensor(Wire *wire, Span message, OnnxModel *model) {
    OnnxTensor *tensor = APPEND(wire, &model->tensors);
    if (!tensor) return;
    *tensor = (OnnxTensor){.widest = 1};
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) switch (field.number) {
        case 1: read_dims(wire, tensor, &field); break;
        case 2:
            if (once(wire, &seen, &field)) need_integer(wire, &field, &tensor->type);
            break;
        case 8:
            if (once(wire, &seen, &field)) need_text(wire, &field, &tensor->name);
            break;
        case 9:
            if (once(wire, &seen, &field)) tensor->has_raw = !field.is_integer;
            tensor->raw = field.bytes;
            break;
        case 12: break; /* doc_string */
        case 13: tensor->external = true; break;
        case 14: read_location(wire, tensor, &field); break;
        default: tensor->elsewhere = true;
        }
}

static void read_attribute(Wire *wire, Span message, OnnxModel *model, OnnxNode *node) {
    uint64_t floats = 0, integers = 0, strings = 0, value = 0, item, seen = 0;
    bool has_value = false;
    Span name = {0};
    Field field;
    while (next_field(wire, &message, &field)) switch (field.number) {
        case 1:
            if (once(wire, &seen, &field)) need_text(wire, &field, &name);
            break;
        case 3:
            if (once(wire, &seen, &field)) has_value = need_integer(wire, &field, &value);
            break;
        case 5:
        case 10: {
            Span tensor;
            if (!need_bytes(wire, &field, &tensor)) return;
            read_tensor(wire, tensor, model);
            if (wire->broken) return;
            node->tensors++;
            break;
        }
        case 7: floats += field.is_integer ? 0 : field.bytes.size / 4; break;
        case 8:
            if (field.is_integer) integers++;
            while (!field.is_integer && field.bytes.size) {
                if (!(spend(wire) && take_varint(wire, &field.bytes, &item))) return;
                integers++;
            }
            break;
        case 9: strings++; break;
        case 6:
        case 11:
        case 14:
        case 15:
        case 21:
        case 22:
        case 23: node->nested = true; break;
        default: break;
        }
    uint64_t longest = floats > integers ? floats : integers;
    longest = longest > strings ? longest : strings;
    if (longest > node->longest_list) node->longest_list = longest;
    if (span_is(name, "axis")) node->has_axis = true;
    if (span_is(name, "axis") && has_value) node->axis = (int64_t)value;
    if (span_is(name, "transA") && has_value) node->transposes_first = value != 0;
    if (span_is(name, "transB") && has_value) node->transposes_second = value != 0;
}

/* The names in fields `number` of a node; how many there are. */
static size_t read_names(Wire *wire, Span message, uint64_t number, OnnxModel *model) {
    size_t before = model->names.count;
    Wire unlimited = {0}; /* these fields were paid for already */
    Field field;
    while (next_field(&unlimited, &message, &field)) {
        unlimited.items = 0;
        Span *name = field.number == number ? APPEND(wire, &model->names) : NULL;
        if (name && !need_text(wire, &field, name)) break;
    }
    return model->names.count - before;
}

static void read_node(Wire *wire, Span message, OnnxModel *model) {
    OnnxNode node = {.first_name = model->names.count, .first_tensor = model->tensors.count};
    Span rest = message;
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &rest, &field)) switch (field.number) {
        case 4:
            if (once(wire, &seen, &field)) need_text(wire, &field, &node.operator);
            break;
        case 5: {
            Span attribute;
            node.attributes++;
            if (need_bytes(wire, &field, &attribute)) read_attribute(wire, attribute, model, &node);
            break;
        }
        case 7:
            if (once(wire, &seen, &field)) need_text(wire, &field, &node.domain);
            break;
        default: break;
        }
    if (wire->broken) return;
    node.inputs = read_names(wire, message, 1, model);
    node.outputs = read_names(wire, message, 2, model);
    OnnxNode *place = APPEND(wire, &model->nodes);
    if (place) *place = node;
}

static void read_dimension(Wire *wire, Span message, OnnxValue *value) {
    uint64_t seen = 0, size = 0;
    bool known = false;
    Field field;
    Span name;
    while (next_field(wire, &message, &field)) {
        if (field.number == 1 && once(wire, &seen, &field)) known = need_integer(wire, &field, &size);
        if (field.number == 2 && once(wire, &seen, &field)) need_text(wire, &field, &name);
    }
    if (value->rank < 2) {
        value->dims[value->rank] = size;
        value->symbolic[value->rank] = !known;
    }
    value->rank++;
}

/* The message in field `number`, empty where it is absent; `name` and `type` of fields 1. */
static Span one_message(Wire *wire, Span message, uint64_t number, Span *name, uint64_t *type) {
    Span found = {0};
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) {
        if (field.number == number && once(wire, &seen, &field)) need_bytes(wire, &field, &found);
        if (field.number == 1 && name && once(wire, &seen, &field)) need_text(wire, &field, name);
        if (field.number == 1 && type && once(wire, &seen, &field)) need_integer(wire, &field, type);
    }
    return found;
}

static OnnxValue read_value(Wire *wire, Span message) {
    OnnxValue value = {0};
    Span type = one_message(wire, message, 2, &value.name, NULL);
    Span tensor = one_message(wire, type, 1, NULL, NULL);
    Span shape = one_message(wire, tensor, 2, NULL, &value.type);
    Field field;
    while (next_field(wire, &shape, &field)) {
        Span dimension;
        if (field.number == 1 && need_bytes(wire, &field, &dimension))
            read_dimension(wire, dimension, &value);
    }
    return value;
}

/* The messages in fields `number` of the graph, each handed to what reads it. */
static void read_graph(Wire *wire, Span graph, OnnxModel *model) {
    Span rest = graph, message;
    Field field;
    while (next_field(wire, &rest, &field)) {
        bool wanted = field.number == 1 || field.number == 11 || field.number == 12;
        if (field.number == 15) model->nested = true;
        if (field.number == 5) {
            if (!need_bytes(wire, &field, &message)) return;
            read_tensor(wire, message, model);
            model->initializers = model->tensors.count;
        }
        if (wanted && !need_bytes(wire, &field, &message)) return;
    }
    Wire paid = {0};
    while (next_field(&paid, &graph, &field)) {
        paid.items = 0;
        if (field.number == 1) read_node(wire, field.bytes, model);
        if (field.number == 11) model->inputs++, model->input = read_value(wire, field.bytes);
        if (field.number == 12) model->outputs++, model->output = read_value(wire, field.bytes);
    }
}

static bool is_default_domain(Span domain) { return domain.size == 0 || span_is(domain, "ai.onnx"); }

static void read_opset(Wire *wire, Span message, OnnxModel *model) {
    Span domain = {0};
    uint64_t version = 0, seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) {
        if (field.number == 1 && once(wire, &seen, &field)) need_text(wire, &field, &domain);
        if (field.number == 2 && once(wire, &seen, &field)) need_integer(wire, &field, &version);
    }
    model->foreign_domain |= !is_default_domain(domain) || model->opsets > 0;
    model->bad_opset |= version < 13 || version > 21;
    model->opsets++;
}

static void read_onnx(Wire *wire, Span data, OnnxModel *model) {
    uint64_t seen = 0;
    Span graph = {0}, message;
    Field field;
    while (next_field(wire, &data, &field)) switch (field.number) {
        case 1:
            if (once(wire, &seen, &field)) need_integer(wire, &field, &model->ir_version);
            break;
        case 7:
            if (once(wire, &seen, &field)) need_bytes(wire, &field, &graph);
            break;
        case 8:
            if (need_bytes(wire, &field, &message)) read_opset(wire, message, model);
            break;
        case 20:
        case 25: model->nested = true; break;
        default: break;
        }
    read_graph(wire, graph, model);
}

#endif
