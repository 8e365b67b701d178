/* Curves: the file (section 4.2). */
#ifndef RNA_CURVES_H
#define RNA_CURVES_H

#include "tensors.h"

/* Strands of two points and more that share out all points, no two in a row equal. */
static bool check_strands(const RnaCurves *curves, const char *entry, RnaReport *report) {
    const uint32_t *offsets = curves->offsets;
    if (offsets[0] != 0 || offsets[curves->strand_count] != curves->point_count)
        return refuse(report, "GEOMETRY_STRANDS", entry, "offsets from 0 to the number of points",
                      "%u to %u", (unsigned)offsets[0], (unsigned)offsets[curves->strand_count]);
    for (uint32_t s = 0; s < curves->strand_count; s++)
        if ((int64_t)offsets[s + 1] - offsets[s] < 2)
            return refuse(report, "GEOMETRY_STRANDS", entry, "2 points and more in each",
                          "%lld in strand %u", (long long)offsets[s + 1] - offsets[s], (unsigned)s);
    for (uint32_t s = 0; s < curves->strand_count; s++)
        for (uint32_t i = offsets[s]; i + 1 < offsets[s + 1]; i++) {
            const float *a = &curves->points[3 * (size_t)i], *b = a + 3;
            if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2])
                return refuse(report, "GEOMETRY_SEGMENT", entry, "a segment of some length",
                              "points %u and %u are equal", (unsigned)i, (unsigned)i + 1);
        }
    return true;
}

static bool read_curves(Span file, RnaCurves *curves, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"GEOMETRY_CONTAINER", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE",
                                      "GEOMETRY_PROFILE",   "GEOMETRY_RANGE",   "GEOMETRY_PROFILE"};
    Tensor tensors[] = {{"points", "F32", 4, 2, {2, 3}, {MAX_POINTS, 3}, {0}, NULL},
                        {"radii", "F32", 4, 1, {2}, {MAX_POINTS}, {0}, NULL},
                        {"offsets", "U32", 4, 1, {2}, {MAX_STRANDS + 1}, {0}, NULL}};
    if (!read_tensors(file, tensors, 3, entry, &CODES, report)) return false;
    curves->point_count = (uint32_t)tensors[0].shape[0];
    curves->strand_count = (uint32_t)tensors[2].shape[0] - 1;
    curves->points = (const float *)(const void *)tensors[0].data;
    curves->radii = (const float *)(const void *)tensors[1].data;
    curves->offsets = (const uint32_t *)(const void *)tensors[2].data;
    if (tensors[1].shape[0] != curves->point_count)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a radius for each point", "%u points",
                      (unsigned)curves->point_count);
    if (!check_strands(curves, entry, report)) return false;
    if (!are_finite(curves->points, 3 * (size_t)curves->point_count) ||
        !are_finite(curves->radii, curves->point_count))
        return refuse(report, "GEOMETRY_NOT_FINITE", entry, "finite points and radii", "others");
    for (uint32_t i = 0; i < curves->point_count; i++)
        if (!(curves->radii[i] > 0))
            return refuse(report, "GEOMETRY_RADIUS", entry, "radii greater than 0", "%g at point %u",
                          curves->radii[i], (unsigned)i);
    return true;
}

#endif
