/* Planes of features: the file (section 5). */
#ifndef RNA_PLANES_H
#define RNA_PLANES_H

#include "tensors.h"

/* The planes of a tier part, in the file. */
typedef struct Planes {
    enum { INT8, FLOAT16, FLOAT32 } precision;
    int resolution, channels;
    const void *texels;  /* [3, R, R, C] */
    const float *scales; /* [3, C] of int8 */
} Planes;

static bool read_planes(Span file, Planes *planes, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"PLANES_HEADER", "PLANES_TENSOR", "PLANES_DTYPE",
                                      "PLANES_SHAPE",  "PLANES_HEADER", "PLANES_ALIGNMENT"};
    static const char *const DTYPES[] = {[INT8] = "I8", [FLOAT16] = "F16", [FLOAT32] = "F32"};
    uint64_t r = (uint64_t)planes->resolution, c = (uint64_t)planes->channels;
    Tensor tensors[] = {{"scales", "F32", 2, {3, c}, {3, c}},
                        {"planes", DTYPES[planes->precision], 4, {3, r, r, c}, {3, r, r, c}}};
    int skipped = planes->precision != INT8;
    if (!read_tensors(file, tensors + skipped, 2 - skipped, entry, &CODES, report)) return false;
    planes->scales = (const float *)(const void *)tensors[0].data;
    planes->texels = tensors[1].data;
    size_t count = (size_t)(3 * r * r * c);
    bool good = planes->precision == INT8      ? are_within(planes->scales, (size_t)(3 * c), 1e18f / 128)
                : planes->precision == FLOAT16 ? halves_are_finite(planes->texels, count)
                                               : are_within(planes->texels, count, 1e18f);
    return good || refuse(report, "PLANES_NOT_FINITE", entry, "values within 1e18", "others");
}

#endif
