/* Rays against the geometry of one asset; trace.h says what it offers. */
#include "trace_shapes.h"

#include <stdlib.h>

enum { LEAF = 4, MAX_DEPTH = 48, STACK = 128 };

typedef struct Node {
    double low[3], high[3];
    uint32_t first, count; /* of a leaf: places in Tracer.order; count 0: the right child is `first` */
} Node;

/* A triangle or segment of a part. */
typedef struct Primitive {
    uint32_t part, index;
} Primitive;

struct Tracer {
    const RnaAsset *asset;
    int parts;
    Shape shapes[RNA_MAX_PARTS];
    Primitive *order;        /* as they stand in the leaves */
    Node *nodes;             /* the left child stands behind its parent */
    uint32_t node_count;
    double extent;           /* largest absolute coordinate of the asset (section 7.1) */
};

/* ------------------------------------------------------- Bounding volumes */

static void box_of(const Tracer *tracer, Primitive primitive, double low[3], double high[3]) {
    const Shape *shape = &tracer->shapes[primitive.part];
    if (shape->mesh) {
        double v[3][3];
        corners_of(shape->mesh, primitive.index, v);
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(v[0][k], fmin(v[1][k], v[2][k]));
            high[k] = fmax(v[0][k], fmax(v[1][k], v[2][k]));
        }
        return;
    }
    Cone cone = cone_of(shape, primitive.index);
    for (int k = 0; k < 3; k++) {
        low[k] = fmin(cone.a[k] - cone.ra, cone.b[k] - cone.rb);
        high[k] = fmax(cone.a[k] + cone.ra, cone.b[k] + cone.rb);
    }
}

static double middle_of(const Tracer *tracer, Primitive primitive, int axis) {
    double low[3], high[3];
    box_of(tracer, primitive, low, high);
    return (low[axis] + high[axis]) / 2;
}

/* Splits order[first .. first + count) in the middle of the box, or in two halves where that fails;
 * the number on the left. */
static uint32_t split_order(Tracer *tracer, uint32_t first, uint32_t count, const Node *node, int depth) {
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (node->high[k] - node->low[k] > node->high[axis] - node->low[axis]) axis = k;
    double split = (node->low[axis] + node->high[axis]) / 2;
    uint32_t left = first;
    for (uint32_t i = first; i < first + count; i++)
        if (middle_of(tracer, tracer->order[i], axis) < split) {
            Primitive swap = tracer->order[i];
            tracer->order[i] = tracer->order[left];
            tracer->order[left++] = swap;
        }
    left -= first;
    return left == 0 || left == count || depth > MAX_DEPTH ? count / 2 : left;
}

static uint32_t build(Tracer *tracer, uint32_t first, uint32_t count, int depth) {
    uint32_t index = tracer->node_count++;
    Node node = {.first = first, .count = count};
    for (int k = 0; k < 3; k++) node.low[k] = HUGE_VAL, node.high[k] = -HUGE_VAL;
    for (uint32_t i = first; i < first + count; i++) {
        double low[3], high[3];
        box_of(tracer, tracer->order[i], low, high);
        for (int k = 0; k < 3; k++) {
            node.low[k] = fmin(node.low[k], low[k]);
            node.high[k] = fmax(node.high[k], high[k]);
        }
    }
    if (count > LEAF) {
        uint32_t left = split_order(tracer, first, count, &node, depth);
        node.count = 0;
        build(tracer, first, left, depth + 1);
        node.first = build(tracer, first + left, count - left, depth + 1);
    }
    tracer->nodes[index] = node;
    return index;
}

static bool meets_box(const Node *node, const Ray *ray) {
    double near = 0, far = ray->far;
    for (int k = 0; k < 3; k++) { /* comparisons with NaN are false: 0 / 0 leaves the axis out */
        double a = (node->low[k] - ray->origin[k]) * ray->inverse[k];
        double b = (node->high[k] - ray->origin[k]) * ray->inverse[k];
        if (ray->inverse[k] < 0) {
            double swap = a;
            a = b;
            b = swap;
        }
        if (a > near) near = a;
        if (b < far) far = b;
    }
    return near <= far * (1 + 1e-12) + 1e-300;
}

/* The aim of a ray: the first hit behind `after`, or, where `v` is there, the light that is left behind all hits. */
typedef struct Query {
    Ray ray;
    const TraceHit *after;
    TraceHit hit;
    bool is_hit;
    double *v;
    uint32_t part, strand; /* that the ray passes through; strand UINT32_MAX: none */
} Query;

/* Hits in the order of the ray; those at one place in the order of their numbers. */
static bool comes_before(const TraceHit *a, const TraceHit *b) {
    if (a->t != b->t) return a->t < b->t;
    return a->part != b->part ? a->part < b->part : a->primitive < b->primitive;
}

/* Notes a hit; true where no other one matters. */
static bool take_hit(const Tracer *tracer, Query *query, const TraceHit *hit) {
    if (query->v) {
        float tau[3], direction[3];
        for (int k = 0; k < 3; k++) direction[k] = (float)query->ray.direction[k];
        rna_transmittance(tracer->asset, hit->part, hit->primitive, hit->b1, hit->b2, direction, tau);
        for (int k = 0; k < 3; k++) query->v[k] *= tau[k];
        return query->v[0] + query->v[1] + query->v[2] == 0;
    }
    bool behind = !query->after || comes_before(query->after, hit);
    if (!behind || (query->is_hit && comes_before(&query->hit, hit))) return false;
    query->is_hit = true;
    query->hit = *hit;
    query->ray.far = hit->t;
    return false;
}

static bool try_primitive(const Tracer *tracer, Query *query, Primitive primitive) {
    const Shape *shape = &tracer->shapes[primitive.part];
    TraceHit hit;
    if (shape->curves && primitive.part == query->part && shape->strand[primitive.index] == query->strand)
        return false;
    bool meets = shape->mesh ? hit_triangle(shape->mesh, primitive.index, &query->ray, &hit)
                             : hit_segment(shape, primitive.index, &query->ray, &hit);
    hit.part = (int)primitive.part;
    return meets && take_hit(tracer, query, &hit);
}

static void search(const Tracer *tracer, Query *query) {
    uint32_t stack[STACK], top = 0;
    stack[top++] = 0;
    while (top) {
        const Node *node = &tracer->nodes[stack[--top]];
        if (!meets_box(node, &query->ray)) continue;
        if (node->count == 0) {
            stack[top++] = node->first;
            stack[top++] = (uint32_t)(node - tracer->nodes) + 1;
            continue;
        }
        for (uint32_t i = node->first; i < node->first + node->count; i++)
            if (try_primitive(tracer, query, tracer->order[i])) return;
    }
}

static Query new_query(const double origin[3], const double direction[3]) {
    Query query = {.strand = UINT32_MAX, .ray.far = HUGE_VAL};
    memcpy(query.ray.origin, origin, sizeof query.ray.origin);
    memcpy(query.ray.direction, direction, sizeof query.ray.direction);
    normalize(query.ray.direction);
    for (int k = 0; k < 3; k++) query.ray.inverse[k] = 1 / query.ray.direction[k];
    return query;
}

/* --------------------------------------------------------- The interface */

static void number_segments(Shape *shape) {
    uint32_t segment = 0;
    for (uint32_t s = 0; s < shape->curves->strand_count; s++)
        for (uint32_t i = shape->curves->offsets[s]; i + 1 < shape->curves->offsets[s + 1]; i++)
            shape->strand[segment++] = s;
}

/* The largest absolute coordinate of a part's geometry, radii added. */
static double extent_of(const Shape *shape) {
    double extent = 0;
    const float *points = shape->mesh ? shape->mesh->positions : shape->curves->points;
    size_t count = shape->mesh ? shape->mesh->vertex_count : shape->curves->point_count;
    for (size_t i = 0; i < 3 * count; i++)
        extent = fmax(extent, fabs(points[i]) + (shape->mesh ? 0 : (double)shape->curves->radii[i / 3]));
    return extent;
}

static bool add_shape(Tracer *tracer, const RnaPart *part) {
    Shape *shape = &tracer->shapes[tracer->parts++];
    shape->mesh = part->mesh;
    shape->curves = part->curves;
    shape->count = part->mesh ? part->mesh->triangle_count
                              : part->curves->point_count - part->curves->strand_count;
    tracer->extent = fmax(tracer->extent, extent_of(shape));
    if (part->mesh) return true;
    shape->strand = malloc(shape->count * sizeof *shape->strand);
    if (shape->strand) number_segments(shape);
    return shape->strand != NULL;
}

Tracer *trace_new(const RnaAsset *asset) {
    Tracer *tracer = calloc(1, sizeof *tracer);
    uint64_t count = 0;
    bool good = tracer != NULL;
    for (int i = 0; good && i < rna_part_count(asset); i++) {
        good = add_shape(tracer, rna_part(asset, i));
        count += tracer->shapes[i].count;
    }
    if (good) {
        tracer->asset = asset;
        tracer->order = malloc(count * sizeof *tracer->order);
        tracer->nodes = malloc(2 * count * sizeof *tracer->nodes);
        good = tracer->order && tracer->nodes && count < UINT32_MAX / 2;
    }
    if (!good) {
        trace_free(tracer);
        return NULL;
    }
    uint32_t n = 0;
    for (uint32_t part = 0; part < (uint32_t)tracer->parts; part++)
        for (uint32_t i = 0; i < tracer->shapes[part].count; i++) tracer->order[n++] = (Primitive){part, i};
    build(tracer, 0, n, 0);
    return tracer;
}

void trace_free(Tracer *tracer) {
    if (!tracer) return;
    for (int i = 0; i < tracer->parts; i++) free(tracer->shapes[i].strand);
    free(tracer->order);
    free(tracer->nodes);
    free(tracer);
}

uint32_t trace_primitive_count(const Tracer *tracer, int part) {
    return part >= 0 && part < tracer->parts ? tracer->shapes[part].count : 0;
}

bool trace_closest(const Tracer *tracer, const double origin[3], const double direction[3],
                   const TraceHit *after, TraceHit *hit) {
    Query query = new_query(origin, direction);
    query.after = after;
    if (after) query.ray.near = after->t;
    search(tracer, &query);
    *hit = query.hit;
    return query.is_hit;
}

void trace_surface_point(const RnaMesh *mesh, uint32_t triangle, double b1, double b2, double position[3],
                         double n[3]) {
    const double b[3] = {1 - b1 - b2, b1, b2};
    for (int k = 0; k < 3; k++) position[k] = n[k] = 0;
    for (size_t corner = 0; corner < 3; corner++) {
        size_t vertex = mesh->triangles[3 * (size_t)triangle + corner];
        for (size_t k = 0; k < 3; k++) {
            position[k] += b[corner] * mesh->positions[3 * vertex + k];
            n[k] += b[corner] * mesh->normals[3 * vertex + k];
        }
    }
    normalize(n);
}

void trace_tangent(const Tracer *tracer, int part, uint32_t segment, double t[3]) {
    Cone cone = cone_of(&tracer->shapes[part], segment);
    subtract(cone.b, cone.a, t);
    normalize(t);
}

/* The light that is left along the ray. */
static void find_visibility(const Tracer *tracer, Query *query, double v[3]) {
    for (int k = 0; k < 3; k++) v[k] = 1;
    query->v = v;
    search(tracer, query);
}

/* How far the smooth surface, which the flat triangles stand for, lies above x. */
static void add_lift(const RnaMesh *mesh, uint32_t triangle, double corners[3][3], const double b[3],
                     double share, double x[3]) {
    double lift[3] = {0};
    for (int i = 0; i < 3; i++) {
        double to_corner[3], normal[3];
        subtract(corners[i], x, to_corner);
        load(&mesh->normals[3 * (size_t)mesh->triangles[3 * (size_t)triangle + (size_t)i]], normal);
        double height = fmax(0, dot(to_corner, normal));
        for (int k = 0; k < 3; k++) lift[k] += share * b[i] * height * normal[k];
    }
    for (int k = 0; k < 3; k++) x[k] += lift[k];
}

/* Section 7.1: from the side of the smooth surface that wi is on; near the terminator from that surface. */
void trace_visible_on_mesh(const Tracer *tracer, int part, uint32_t triangle, double b1, double b2,
                           const double wi[3], double v[3]) {
    const RnaMesh *mesh = tracer->shapes[part].mesh;
    const double b[3] = {1 - b1 - b2, b1, b2};
    double corners[3][3], x[3], n[3], ng[3], e1[3], e2[3];
    corners_of(mesh, triangle, corners);
    trace_surface_point(mesh, triangle, b1, b2, x, n);
    subtract(corners[1], corners[0], e1);
    subtract(corners[2], corners[0], e2);
    cross(e1, e2, ng);
    normalize(ng);
    const bool smooth = dot(n, ng) > 0;
    const double above_plane = dot(ng, wi), above = smooth ? dot(n, wi) : above_plane;
    if (smooth && above > 0 && above_plane < 0.1)
        add_lift(mesh, triangle, corners, b, 1 - fmax(0, above_plane) / 0.1, x);
    const double step = tracer->extent * 0x1p-18, side = above < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++) x[k] += side * step * ng[k];
    Query query = new_query(x, wi);
    find_visibility(tracer, &query, v);
}

/* Other strands block, where the ray enters them, and triangles. */
void trace_visible_on_fiber(const Tracer *tracer, int part, uint32_t segment, const double position[3],
                            const double wi[3], double v[3]) {
    Query query = new_query(position, wi);
    query.part = (uint32_t)part;
    query.strand = tracer->shapes[part].strand[segment];
    find_visibility(tracer, &query, v);
}
