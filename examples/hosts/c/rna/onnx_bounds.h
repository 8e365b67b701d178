/* Upper bounds of a decoder's memory and work (section 6.2). */
#ifndef RNA_ONNX_BOUNDS_H
#define RNA_ONNX_BOUNDS_H

#include "onnx.h"
#include "rules.h"

/* Upper bound of a value's shape, [rows, columns]; rank 1 has columns alone, rank 0 neither. */
typedef struct Shape {
    uint64_t rows, columns;
    size_t rank;
    bool per_query; /* there is a row for each query, and `rows` does not count */
} Shape;

/* Values by name: what is known of each before the node at hand. */
typedef struct Value {
    Span name;
    bool known;
    Shape shape;
    int tensor; /* of an initializer, else -1 */
    int node;   /* that made it, else -1 */
} Value;

typedef struct ValueTable {
    Value *at;
    size_t mask;
} ValueTable;

/* Sums over initializers and nodes. */
typedef struct Tally {
    uint64_t constants, values, work;
} Tally;

static Value *find_value(const ValueTable *table, Span name) {
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < name.size; i++) hash = (hash ^ name.at[i]) * 16777619u;
    size_t i = hash & table->mask;
    while (table->at[i].known && !same_span(table->at[i].name, name)) i = (i + 1) & table->mask;
    return &table->at[i];
}

static void set_value(ValueTable *table, Span name, Shape shape, int tensor, int node) {
    *find_value(table, name) = (Value){name, true, shape, tensor, node};
}

static Shape shape_of(const OnnxTensor *tensor) {
    return (Shape){.rows = tensor->rank == 2 ? tensor->dims[0] : 1,
                   .columns = tensor->rank ? tensor->dims[tensor->rank - 1] : 1,
                   .rank = tensor->rank};
}

static void enlarge(Shape *shape, Shape other) {
    if (other.rows > shape->rows) shape->rows = other.rows;
    if (other.columns > shape->columns) shape->columns = other.columns;
    if (other.rank > shape->rank) shape->rank = other.rank;
    shape->per_query |= other.per_query;
}

static bool is_product(const OnnxNode *node) { return is_choice(node->operator, "Gemm MatMul"); }
static bool is_over_columns(const OnnxNode *node) { return node->axis == 1 || node->axis == -1; }

static Shape operand_shape(const OnnxModel *model, const ValueTable *values, const OnnxNode *node, size_t k) {
    return find_value(values, model->names.at[node->first_name + k])->shape;
}

/* Rows of queries are not multiplied by each other, transposed or put below one another. */
static bool check_rows(const OnnxModel *model, const ValueTable *values, const OnnxNode *node,
                       const char *entry, RnaReport *report) {
    bool per_query = false, good = node->inputs > 1 && !node->transposes_first;
    for (size_t k = 0; k < node->inputs; k++) {
        Shape operand = operand_shape(model, values, node, k);
        per_query |= operand.per_query;
        good &= operand.per_query == (k == 0) && (k != 1 || operand.rank == 2);
    }
    if (is_product(node))
        return good || refuse(report, "DECODER_ROWS", entry, "queries' rows times a constant matrix",
                              "other operands");
    return !(span_is(node->operator, "Concat") && per_query && !is_over_columns(node)) ||
           refuse(report, "DECODER_ROWS", entry, "Concat along axis 1 or -1", "axis %lld",
                  (long long)node->axis);
}

/* Upper bound of the shape of each of the node's results. */
static Shape result_shape(const OnnxModel *model, const ValueTable *values, const OnnxNode *node) {
    Shape shape = {.rows = 1, .columns = node->longest_list ? node->longest_list : 1,
                   .rank = node->longest_list ? 1 : 0};
    uint64_t rows = 0, columns = 0; /* of all operands together */
    if (is_product(node)) {
        Shape matrix = operand_shape(model, values, node, 1);
        return (Shape){1, node->transposes_second ? matrix.rows : matrix.columns, 2, true};
    }
    for (size_t k = 0; k < node->tensors; k++)
        enlarge(&shape, shape_of(&model->tensors.at[node->first_tensor + k]));
    Shape own = shape;
    for (size_t k = 0; k < node->inputs; k++) {
        Shape operand = operand_shape(model, values, node, k);
        enlarge(&shape, operand);
        rows += operand.rows;
        columns += operand.columns;
    }
    const char *by_first = "Clip DequantizeLinear LayerNormalization QuantizeLinear Slice Split";
    if (!shape.per_query && node->inputs && is_choice(node->operator, by_first)) {
        shape = own;
        enlarge(&shape, operand_shape(model, values, node, 0));
    }
    if (span_is(node->operator, "Concat")) {
        if (shape.per_query || shape.rank < 2 || is_over_columns(node))
            shape.columns = columns;
        else
            shape.rows = rows;
    }
    return shape.per_query ? (Shape){1, shape.columns, 2, true} : shape;
}

static bool add_constant(Tally *tally, Shape shape, const char *entry, RnaReport *report) {
    tally->constants += shape.rows * shape.columns;
    return tally->constants <= MAX_CONSTANTS ||
           refuse(report, "DECODER_COST", entry, "at most 2^24 values of constants", "more");
}

/* Adds what the node's results take; first: its first operand. */
static bool add_results(Tally *tally, const OnnxNode *node, Shape first, Shape result, const char *entry,
                        RnaReport *report) {
    if (!result.per_query) return add_constant(tally, result, entry, report);
    tally->values += result.columns;
    tally->work += result.columns * (is_product(node) ? first.columns : 1);
    if (tally->values > MAX_QUERY_VALUES)
        return refuse(report, "DECODER_COST", entry, "at most 2^16 values a query", "more");
    return tally->work <= MAX_QUERY_WORK ||
           refuse(report, "DECODER_COST", entry, "at most 2^24 multiply-adds a query", "more");
}

static bool check_node_bounds(const OnnxModel *model, ValueTable *values, size_t i, Tally *tally,
                              const char *entry, RnaReport *report) {
    const OnnxNode *node = &model->nodes.at[i];
    const Span *names = model->names.at ? model->names.at + node->first_name : NULL;
    for (size_t k = 0; k < node->inputs; k++)
        if (!find_value(values, names[k])->known)
            return refuse(report, "DECODER_GRAPH", entry, "values made before their use", "node %zu", i);
    for (size_t k = node->inputs; k < node->inputs + node->outputs; k++)
        if (names[k].size && find_value(values, names[k])->known)
            return refuse(report, "DECODER_GRAPH", entry, "each value made once", "node %zu", i);
    if (!check_rows(model, values, node, entry, report)) return false;
    Shape result = result_shape(model, values, node);
    if (result.columns > MAX_WIDTH || result.rows > MAX_WIDTH)
        return refuse(report, "DECODER_TENSOR", entry, "a width of at most 8192", "more in node %zu", i);
    for (size_t k = 0; k < node->tensors; k++)
        if (!add_constant(tally, shape_of(&model->tensors.at[node->first_tensor + k]), entry, report))
            return false;
    Shape first = node->inputs ? operand_shape(model, values, node, 0) : (Shape){0};
    if (!add_results(tally, node, first, result, entry, report)) return false;
    for (size_t k = node->inputs; k < node->inputs + node->outputs; k++)
        if (names[k].size) set_value(values, names[k], result, -1, (int)i);
    return true;
}

/* Each value is made once and before its use, and no limit can be passed.  `values`: empty; of the
 * whole graph in the end. */
static bool check_bounds(const OnnxModel *model, ValueTable *values, Span queries, int columns,
                         const char *output, const char *entry, RnaReport *report) {
    Tally tally = {0};
    set_value(values, (Span){0}, (Shape){1, 1, 0, false}, -1, -1);
    set_value(values, queries, (Shape){1, (uint64_t)columns, 2, true}, -1, -1);
    for (size_t i = 0; i < model->initializers; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        if (find_value(values, tensor->name)->known)
            return refuse(report, "DECODER_GRAPH", entry, "each value made once", "a name made twice");
        set_value(values, tensor->name, shape_of(tensor), (int)i, -1);
        if (!add_constant(&tally, shape_of(tensor), entry, report)) return false;
    }
    for (size_t i = 0; i < model->nodes.count; i++)
        if (!check_node_bounds(model, values, i, &tally, entry, report)) return false;
    return find_value(values, text_span(output))->known ||
           refuse(report, "DECODER_GRAPH", entry, "a value of the output's name", "nothing makes it");
}

#endif
