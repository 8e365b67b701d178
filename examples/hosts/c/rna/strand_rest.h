/* Rest points of deformed strands, and the rotations along them (section 8.3). */
#ifndef RNA_STRAND_REST_H
#define RNA_STRAND_REST_H

#include "rest.h"

enum { NEIGHBOURS = 6 }; /* strands on either side, along a curve that fills space */
#define FAR_POINTS 1e-3  /* weight of a strand's middle and tip */

typedef struct Root {
    uint32_t code, strand;
} Root;

static int compare_roots(const void *a, const void *b) {
    const Root *p = a, *q = b;
    if (p->code != q->code) return p->code < q->code ? -1 : 1;
    return p->strand < q->strand ? -1 : p->strand > q->strand;
}

/* The strands in the order of their roots along Morton's curve. */
static Root *ordered_roots(const RnaCurves *curves) {
    Root *roots = malloc(((size_t)curves->strand_count + 1) * sizeof *roots);
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    if (!roots) return NULL;
    for (uint32_t s = 0; s < curves->strand_count; s++)
        for (size_t k = 0; k < 3; k++) {
            const float x = curves->points[3 * (size_t)curves->offsets[s] + k];
            low[k] = x < low[k] ? x : low[k], high[k] = x > high[k] ? x : high[k];
        }
    double size = 1e-30;
    for (int k = 0; k < 3; k++) size = fmax(size, (double)high[k] - low[k]);
    for (uint32_t s = 0; s < curves->strand_count; s++) {
        roots[s] = (Root){0, s};
        for (size_t k = 0; k < 3; k++) {
            const double x = curves->points[3 * (size_t)curves->offsets[s] + k];
            const uint32_t cell = (uint32_t)((x - low[k]) / size * 1023);
            for (unsigned bit = 0; bit < 10; bit++) roots[s].code |= (cell >> bit & 1) << (3 * bit + k);
        }
    }
    qsort(roots, curves->strand_count, sizeof *roots, compare_roots);
    return roots;
}

static void way_of(const float *points, size_t a, size_t b, double way[3]) {
    for (size_t k = 0; k < 3; k++) way[k] = (double)points[3 * b + k] - points[3 * a + k];
}

/* c += weight E(the way from point a to point b). */
static void add_way(const RnaShape *shape, size_t a, size_t b, double weight, double c[9]) {
    double d[3], moved[3];
    way_of(shape->curves->points, a, b, d);
    way_of(shape->positions, a, b, moved);
    const double square = dot(d, d);
    for (int i = 0; i < 9 && square > 0; i++) c[i] += weight * moved[i / 3] * d[i % 3] / square;
}

/* The rotation of the root of a strand, the `place`-th in the order. */
static void root_rotation(const RnaShape *shape, const Root *roots, size_t place, double r[9]) {
    const uint32_t *offsets = shape->curves->offsets, strand = roots[place].strand;
    const size_t root = offsets[strand], points = offsets[strand + 1] - root;
    const size_t start = place > NEIGHBOURS ? place - NEIGHBOURS : 0;
    double squares[2 * NEIGHBOURS + 1], nearest = HUGE_VAL, c[9] = {0};
    size_t count = 0;
    for (size_t k = start; k < shape->curves->strand_count && k <= place + NEIGHBOURS; k++) {
        double way[3];
        way_of(shape->curves->points, root, offsets[roots[k].strand], way);
        squares[count++] = dot(way, way);
        if (squares[count - 1] > 0) nearest = fmin(nearest, squares[count - 1]);
    }
    for (size_t k = 0; k < count; k++) {
        const size_t beside = offsets[roots[start + k].strand];
        const double weight = squares[k] > 0 ? nearest / squares[k] : 1;
        add_way(shape, beside, beside + 1, weight, c);
        add_way(shape, root, beside, weight, c);
    }
    add_way(shape, root, root + points / 2, FAR_POINTS, c);
    add_way(shape, root, root + points - 1, FAR_POINTS, c);
    fitted_rotation(c, r);
}

/* The rotations of a strand's segments, from its root's rotation on. */
static void turn_strand(RnaShape *shape, uint32_t strand, double r[9]) {
    const uint32_t *offsets = shape->curves->offsets;
    for (uint32_t k = offsets[strand]; k + 1 < offsets[strand + 1]; k++) {
        double t[3], moved[3], turned[3], q[9], next[9];
        way_of(shape->curves->points, k, k + 1, t);
        way_of(shape->positions, k, k + 1, moved);
        normalize(t);
        normalize(moved);
        turn(r, t, turned);
        smallest_rotation(turned, moved, q);
        composed(q, r, next);
        memcpy(r, next, sizeof next);
        memcpy(shape->rotations[k - strand], r, sizeof next);
        shape->first[k - strand] = k;
    }
}

static bool turn_strands(RnaShape *shape) {
    Root *roots = ordered_roots(shape->curves);
    double r[9];
    for (size_t place = 0; roots && place < shape->curves->strand_count; place++) {
        root_rotation(shape, roots, place, r);
        turn_strand(shape, roots[place].strand, r);
    }
    free(roots);
    return roots != NULL;
}

/* Of a hit at the place u of a segment of the shape, with this outward normal. */
static void rest_on_strand(const RnaShape *shape, uint32_t segment, double u, const float normal[3], RnaRest *rest) {
    const RnaCurves *curves = shape->curves;
    const size_t a = shape->first[segment];
    const double radius = (1 - u) * curves->radii[a] + u * curves->radii[a + 1];
    double q[9], n[3], outward[3], t[3];
    memcpy(q, shape->rotations[segment], sizeof q);
    transpose(q);
    load(normal, outward);
    turn(q, outward, n);
    way_of(curves->points, a, a + 1, t);
    normalize(t);
    for (size_t k = 0; k < 3; k++) {
        const double p = curves->points[3 * a + k], p1 = curves->points[3 * a + 3 + k];
        rest->position[k] = (float)((1 - u) * p + u * p1 + radius * n[k]);
        rest->axis[k] = (float)t[k];
    }
    for (int i = 0; i < 9; i++) rest->rotation[i] = (float)q[i];
}

#endif
