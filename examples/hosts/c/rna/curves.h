/* Curves: the file, as float32 or quantised (section 4.2). */
#ifndef RNA_CURVES_H
#define RNA_CURVES_H

#include "tensors.h"

static const TensorCodes CURVE_CODES = {"GEOMETRY_CONTAINER", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE",
                                        "GEOMETRY_PROFILE",   "GEOMETRY_RANGE",   "GEOMETRY_PROFILE"};

/* Strands of two points and more that share out all points. */
static bool check_offsets(const RnaCurves *curves, const char *entry, RnaReport *report) {
    const uint32_t *offsets = curves->offsets;
    if (offsets[0] != 0 || offsets[curves->strand_count] != curves->point_count)
        return refuse(report, "GEOMETRY_STRANDS", entry, "offsets from 0 to the number of points",
                      "%u to %u", (unsigned)offsets[0], (unsigned)offsets[curves->strand_count]);
    for (uint32_t s = 0; s < curves->strand_count; s++)
        if ((int64_t)offsets[s + 1] - offsets[s] < 2)
            return refuse(report, "GEOMETRY_STRANDS", entry, "2 points and more in each",
                          "%lld in strand %u", (long long)offsets[s + 1] - offsets[s], (unsigned)s);
    return true;
}

/* Checks of the points and radii, once the offsets are good. */
static bool check_points(const RnaCurves *curves, const char *entry, RnaReport *report) {
    if (!are_finite(curves->points, 3 * (size_t)curves->point_count) ||
        !are_finite(curves->radii, curves->point_count))
        return refuse(report, "GEOMETRY_NOT_FINITE", entry, "finite points and radii", "others");
    for (uint32_t s = 0; s < curves->strand_count; s++)
        for (uint32_t i = curves->offsets[s]; i + 1 < curves->offsets[s + 1]; i++) {
            const float *a = &curves->points[3 * (size_t)i], *b = a + 3;
            if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2])
                return refuse(report, "GEOMETRY_SEGMENT", entry, "a segment of some length",
                              "points %u and %u are equal", (unsigned)i, (unsigned)i + 1);
        }
    for (uint32_t i = 0; i < curves->point_count; i++)
        if (!(curves->radii[i] > 0))
            return refuse(report, "GEOMETRY_RADIUS", entry, "radii greater than 0", "%g at point %u",
                          curves->radii[i], (unsigned)i);
    return true;
}

static bool read_plain_curves(Span file, const Json *header, RnaCurves *curves, const char *entry,
                              RnaReport *report) {
    Tensor tensors[] = {{"points", "F32", 2, {2, 3}, {MAX_POINTS, 3}},
                        {"radii", "F32", 1, {2}, {MAX_POINTS}},
                        {"offsets", "U32", 1, {2}, {MAX_STRANDS + 1}}};
    if (!find_tensors(file, header, tensors, 3, entry, &CURVE_CODES, report)) return false;
    curves->point_count = (uint32_t)tensors[0].shape[0];
    curves->strand_count = (uint32_t)tensors[2].shape[0] - 1;
    curves->points = (const float *)(const void *)tensors[0].data;
    curves->radii = (const float *)(const void *)tensors[1].data;
    curves->offsets = (const uint32_t *)(const void *)tensors[2].data;
    if (tensors[1].shape[0] != curves->point_count)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a radius for each point", "%u points",
                      (unsigned)curves->point_count);
    return check_offsets(curves, entry, report) && check_points(curves, entry, report);
}

/* A quantised file: its tensors. */
typedef struct Steps {
    double step, unit;
    const float *origins; /* one a strand */
    const uint8_t *steps; /* one a point, except the first of each strand */
    const uint8_t *radii;
    unsigned step_size, radius_size; /* bytes of a number */
} Steps;

static int32_t step_at(const Steps *from, size_t i) {
    const uint8_t *at = from->steps + i * from->step_size;
    return from->step_size == 2 ? (int16_t)u16_at(at) : (int32_t)u32_at(at);
}

static uint32_t radius_at(const Steps *from, size_t i) {
    return from->radius_size == 1 ? from->radii[i] : u16_at(from->radii + 2 * i);
}

/* Restores the points of a strand, each from the whole sum of the steps up to it; false where a sum
 * leaves the range. */
static bool restore_strand(const Steps *from, uint32_t strand, const uint32_t *offsets, float *points) {
    int64_t sum[3] = {0};
    for (uint32_t i = offsets[strand]; i < offsets[strand + 1]; i++)
        for (size_t k = 0; k < 3; k++) {
            if (i > offsets[strand]) sum[k] += step_at(from, 3 * ((size_t)i - strand - 1) + k);
            if (sum[k] > INT64_C(1) << 31 || sum[k] < -(INT64_C(1) << 31)) return false;
            double offset = from->step * (double)sum[k];
            points[3 * (size_t)i + k] = (float)((double)from->origins[3 * (size_t)strand + k] + offset);
        }
    return true;
}

/* Points and radii of quantised curves, in memory of their own. */
static bool restore_curves(const Steps *from, RnaCurves *curves, void **block, const char *entry,
                           RnaReport *report) {
    size_t n = curves->point_count;
    float *points = *block = malloc(4 * n * sizeof *points), *radii = points + 3 * n;
    if (!points) return refuse(report, "GEOMETRY_CONTAINER", entry, "memory for it", "not enough");
    for (uint32_t s = 0; s < curves->strand_count; s++)
        if (!restore_strand(from, s, curves->offsets, points))
            return refuse(report, "GEOMETRY_STEPS", entry, "at most 2^31 steps from an origin",
                          "more in strand %u", (unsigned)s);
    for (size_t i = 0; i < n; i++) radii[i] = (float)(from->unit * radius_at(from, i));
    curves->points = points;
    curves->radii = radii;
    return true;
}

static bool read_quantised_curves(Span file, const Json *header, RnaCurves *curves, void **block,
                                  const char *entry, RnaReport *report) {
    Tensor tensors[] = {{"scales", "F32", 1, {2}, {2}},
                        {"origins", "F32", 2, {1, 3}, {MAX_STRANDS, 3}},
                        {"offsets", "U32", 1, {2}, {MAX_STRANDS + 1}},
                        {"steps", "I16 I32", 2, {1, 3}, {MAX_POINTS, 3}},
                        {"radii", "U8 U16", 1, {2}, {MAX_POINTS}}};
    if (!find_tensors(file, header, tensors, 5, entry, &CURVE_CODES, report)) return false;
    const float *scales = (const float *)(const void *)tensors[0].data;
    Steps from = {scales[0], scales[1], (const float *)(const void *)tensors[1].data,
                  tensors[3].data, tensors[4].data, tensors[3].item, tensors[4].item};
    curves->strand_count = (uint32_t)tensors[2].shape[0] - 1;
    curves->point_count = (uint32_t)tensors[4].shape[0];
    curves->offsets = (const uint32_t *)(const void *)tensors[2].data;
    if (tensors[1].shape[0] != curves->strand_count ||
        tensors[3].shape[0] + curves->strand_count != curves->point_count)
        return refuse(report, "GEOMETRY_ARRAY", entry, "an origin a strand, steps to all other points",
                      "%u strands, %u points", (unsigned)curves->strand_count,
                      (unsigned)curves->point_count);
    if (!(from.step > 0))
        return refuse(report, "GEOMETRY_STEPS", entry, "steps longer than 0", "%g", from.step);
    return check_offsets(curves, entry, report) && restore_curves(&from, curves, block, entry, report) &&
           check_points(curves, entry, report);
}

/* The curves in a file; *block: what is allocated for them, in any case for the caller to free. */
static bool read_curves(Span file, RnaCurves *curves, void **block, const char *entry, RnaReport *report) {
    JsonText text;
    const Json *header = read_header(file, entry, &CURVE_CODES, &text, report);
    bool quantised = header && member(header, "steps");
    bool good = header && (quantised ? read_quantised_curves(file, header, curves, block, entry, report)
                                     : read_plain_curves(file, header, curves, entry, report));
    free_json(&text);
    return good;
}

#endif
