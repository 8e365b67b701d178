/* Tensor files: safetensors (section 4.3). */
#ifndef RNA_TENSORS_H
#define RNA_TENSORS_H

#include "json.h"

enum { MAX_RANK = 4 };

/* The requirements on a tensor, and its place. */
typedef struct Tensor {
    const char *name, *dtypes; /* dtypes: those that it may have, with spaces between them */
    int rank;
    uint64_t low[MAX_RANK], high[MAX_RANK]; /* range of each dimension */
    uint64_t shape[MAX_RANK];
    const uint8_t *data;
    unsigned item; /* bytes of a value */
} Tensor;

/* Codes of one sort of tensor file. */
typedef struct TensorCodes {
    const char *header, *tensors, *dtype, *shape, *offsets, *alignment;
} TensorCodes;

/* Bytes of a value; 0 of an unknown dtype. */
static unsigned item_size(Span dtype) {
    static const struct {
        const char *dtypes;
        unsigned size;
    } SIZES[] = {{"I8 U8", 1}, {"F16 I16 U16", 2}, {"F32 I32 U32", 4}};
    for (size_t i = 0; i < sizeof SIZES / sizeof *SIZES; i++)
        if (is_choice(dtype, SIZES[i].dtypes)) return SIZES[i].size;
    return 0;
}

/* The shape, once the header's record of the tensor is as it must be. */
static bool check_form(const Json *record, Tensor *tensor, const char *entry,
                       const TensorCodes *codes, RnaReport *report) {
    if (record->type != JSON_OBJECT)
        return refuse(report, codes->tensors, entry, "an object", "%s, another type", tensor->name);
    const Json *dtype = member(record, "dtype");
    if (!dtype || dtype->type != JSON_STRING || !is_choice(dtype->string, tensor->dtypes))
        return refuse(report, codes->dtype, entry, tensor->dtypes, "%s of another dtype", tensor->name);
    tensor->item = item_size(dtype->string);
    const Json *shape = member(record, "shape");
    bool fits = shape && shape->type == JSON_ARRAY && shape->count == (size_t)tensor->rank;
    const Json *size = fits ? shape->first : NULL;
    for (int i = 0; size; size = size->next, i++) {
        fits &= is_integer(size) && size->number >= (double)tensor->low[i] &&
                size->number <= (double)tensor->high[i];
        if (fits) tensor->shape[i] = (uint64_t)size->number;
    }
    return fits || refuse(report, codes->shape, entry, "the shape that the text asks for",
                          "%s of another shape", tensor->name);
}

/* Whether the record's data_offsets are [start, end]. */
static bool has_offsets(const Json *record, uint64_t start, uint64_t end) {
    const Json *list = member(record, "data_offsets");
    if (!list || list->type != JSON_ARRAY || list->count != 2) return false;
    const Json *first = list->first, *second = first->next;
    return is_integer(first) && first->number == (double)start && is_integer(second) &&
           second->number == (double)end;
}

/* Finds the tensors, in the order of their data (section 4.3). */
static bool find_tensors(Span file, const Json *header, Tensor *tensors, int count, const char *entry,
                         const TensorCodes *codes, RnaReport *report) {
    const size_t start = 8 + (size_t)u64_at(file.at);
    const Json *metadata = member(header, "__metadata__");
    size_t known = 0;
    for (int i = 0; i < count; i++) known += member(header, tensors[i].name) != NULL;
    if (known != (size_t)count || header->count != known + (metadata != NULL))
        return refuse(report, codes->tensors, entry, "the tensors of the format", "%zu members",
                      header->count);
    if (metadata && metadata->type != JSON_OBJECT)
        return refuse(report, codes->tensors, entry, "an object", "__metadata__ of another type");
    uint64_t end = 0;
    for (int i = 0; i < count; i++) {
        Tensor *tensor = &tensors[i];
        const Json *record = member(header, tensor->name);
        if (!check_form(record, tensor, entry, codes, report)) return false;
        uint64_t begin = end, size = tensor->item;
        for (int k = 0; k < tensor->rank; k++) size *= tensor->shape[k];
        end += size;
        if (!has_offsets(record, begin, end) || end > file.size - start)
            return refuse(report, codes->offsets, entry, "tensors one after another, in the file",
                          "%s to byte %llu of %zu", tensor->name, (unsigned long long)end,
                          file.size - start);
        tensor->data = file.at + start + begin;
    }
    if (end != file.size - start)
        return refuse(report, codes->offsets, entry, "the end of the file", "%zu bytes more",
                      (size_t)(file.size - start - end));
    return start % ALIGNMENT == 0 ||
           refuse(report, codes->alignment, entry, "data at a multiple of 64", "byte %zu", start);
}

/* The header, and in `text` what it lives on, which the caller frees in any case; NULL after an issue. */
static const Json *read_header(Span file, const char *entry, const TensorCodes *codes, JsonText *text,
                               RnaReport *report) {
    uint64_t size = file.size < 8 ? UINT64_MAX : u64_at(file.at);
    *text = (JsonText){0};
    if (file.size < 8 || size > MAX_HEADER || size > file.size - 8) {
        refuse(report, codes->header, entry, "a header of at most 64 KiB, inside the file", "%zu bytes",
               file.size);
        return NULL;
    }
    Span data = {file.at + 8, (size_t)size};
    if (size > 0 && data.at[0] == '{') return parse_json(data, entry, codes->header, text, report);
    refuse(report, codes->header, entry, "a header from { on", "another");
    return NULL;
}

static bool read_tensors(Span file, Tensor *tensors, int count, const char *entry,
                         const TensorCodes *codes, RnaReport *report) {
    JsonText text;
    const Json *header = read_header(file, entry, codes, &text, report);
    bool good = header && find_tensors(file, header, tensors, count, entry, codes, report);
    free_json(&text);
    return good;
}

static bool are_finite(const float *values, size_t count) {
    uint32_t all = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        all |= (bits & 0x7f800000u) == 0x7f800000u;
    }
    return all == 0;
}

static bool are_within(const float *values, size_t count, float limit) {
    int beyond = 0;
    for (size_t i = 0; i < count; i++) beyond |= !(fabsf(values[i]) <= limit); /* NaN, too */
    return beyond == 0;
}

static bool halves_are_finite(const uint16_t *values, size_t count) {
    uint16_t all = 0;
    for (size_t i = 0; i < count; i++) all |= (values[i] & 0x7c00u) == 0x7c00u;
    return all == 0;
}

#endif
