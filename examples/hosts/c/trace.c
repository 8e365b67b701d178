/* Rays against the geometry of one asset; trace.h says what it offers. */
#include "trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 4, MAX_DEPTH = 48, STACK = 128 };

typedef struct Node {
    double low[3], high[3];
    uint32_t first, count; /* of a leaf: places in Tracer.order; count 0: the right child is `first` */
} Node;

/* A triangle or segment of a part. */
typedef struct Primitive {
    uint32_t part, index;
} Primitive;

/* What the tracer knows of a part. */
typedef struct Shape {
    const RnaMesh *mesh;     /* one of the two */
    const RnaCurves *curves;
    uint32_t count;          /* primitives */
    uint32_t *strand;        /* of each segment */
} Shape;

struct Tracer {
    const RnaAsset *asset;
    int parts;
    Shape shapes[RNA_MAX_PARTS];
    Primitive *order;        /* as they stand in the leaves */
    Node *nodes;             /* the left child stands behind its parent */
    uint32_t node_count;
    double extent;           /* largest absolute coordinate of the asset (section 7.1) */
};

typedef struct Ray {
    double origin[3], direction[3], inverse[3];
    double near, far;
} Ray;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void subtract(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[k] - b[k];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = a[i] * b[j] - a[j] * b[i];
    }
}

/* Brings v to unit length; leaves a vector without length. */
static void normalize(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int k = 0; k < 3 && length > 0; k++) v[k] /= length;
}

static void load(const float *from, double to[3]) {
    for (int k = 0; k < 3; k++) to[k] = from[k];
}

/* ---------------------------------------------------------------- Triangles */

static void corners_of(const RnaMesh *mesh, uint32_t triangle, double v[3][3]) {
    const uint32_t *corner = &mesh->triangles[3 * (size_t)triangle];
    for (int k = 0; k < 3; k++) load(&mesh->positions[3 * (size_t)corner[k]], v[k]);
}

/* The sign of the area between the ray and the edge from a to b, as seen along the ray.  Where the ray
 * meets the edge it is that of a ray beside it, always on the same side: of the triangles around an edge
 * or a corner a ray meets one. */
static double edge_sign(const double a[3], const double b[3], int x, int y, double area) {
    if (area != 0) return area;
    return a[y] != b[y] ? b[y] - a[y] : a[x] - b[x];
}

/* Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides block. */
static bool hit_triangle(const RnaMesh *mesh, uint32_t triangle, const Ray *ray, TraceHit *hit) {
    const double *d = ray->direction;
    int z = fabs(d[0]) > fabs(d[1]) ? 0 : 1;
    if (fabs(d[2]) > fabs(d[z])) z = 2;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    double v[3][3], u[3], sum = 0, t = 0;
    int positive = 0;
    corners_of(mesh, triangle, v);
    for (int k = 0; k < 3; k++) {
        subtract(v[k], ray->origin, v[k]);
        v[k][x] -= d[x] / d[z] * v[k][z];
        v[k][y] -= d[y] / d[z] * v[k][z];
    }
    for (int k = 0; k < 3; k++) {
        const double *a = v[(k + 1) % 3], *b = v[(k + 2) % 3];
        u[k] = b[x] * a[y] - b[y] * a[x];
        sum += u[k];
        positive += edge_sign(a, b, x, y, u[k]) > 0;
    }
    if (sum == 0 || positive != (sum > 0 ? 3 : 0)) return false;
    for (int k = 0; k < 3; k++) t += u[k] * v[k][z] / d[z];
    t /= sum;
    if (!(t >= ray->near && t <= ray->far)) return false;
    *hit = (TraceHit){.t = t, .primitive = triangle, .b1 = u[1] / sum, .b2 = u[2] / sum};
    return true;
}

/* ---------------------------------------------------------------- Segments */

/* A round cone: the convex hull of two spheres. */
typedef struct Cone {
    double a[3], b[3], ra, rb;
} Cone;

static Cone cone_of(const Shape *shape, uint32_t segment) {
    uint32_t i = segment + shape->strand[segment]; /* its first point */
    Cone cone = {.ra = shape->curves->radii[i], .rb = shape->curves->radii[i + 1]};
    load(&shape->curves->points[3 * (size_t)i], cone.a);
    load(&shape->curves->points[3 * (size_t)i + 3], cone.b);
    return cone;
}

/* Where the line enters the sphere; infinity where it does not. */
static double enter_sphere(const Ray *ray, const double centre[3], double radius) {
    double from[3];
    subtract(ray->origin, centre, from);
    double along = dot(from, ray->direction), rest[3];
    for (int k = 0; k < 3; k++) rest[k] = from[k] - along * ray->direction[k];
    double h = radius * radius - dot(rest, rest);
    return h > 0 ? -along - sqrt(h) : HUGE_VAL;
}

/* The entry of the line into the cone, at any t: of all points where it enters one of the two spheres
 * or the side between them, the first. */
static bool enter_cone(const Cone *cone, const Ray *ray, double *t, double n[3]) {
    double axis[3], from[3], at[3];
    subtract(cone->b, cone->a, axis);
    subtract(ray->origin, cone->a, from);
    const double dr = cone->ra - cone->rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
    double ta = enter_sphere(ray, cone->a, cone->ra), tb = enter_sphere(ray, cone->b, cone->rb);
    *t = ta < tb ? ta : tb;
    const double *centre = ta < tb ? cone->a : cone->b;
    for (int k = 0; k < 3; k++) n[k] = ray->origin[k] + *t * ray->direction[k] - centre[k];
    double m1 = dot(axis, from), m2 = dot(axis, ray->direction), m3 = dot(ray->direction, from);
    double k2 = d2 - m2 * m2, k1 = d2 * m3 - m1 * m2 + m2 * dr * cone->ra;
    double k0 = d2 * dot(from, from) - m1 * m1 + 2 * m1 * dr * cone->ra - length2 * cone->ra * cone->ra;
    double h = k1 * k1 - k0 * k2;
    for (int sign = -1; sign <= 1 && d2 > 0 && h >= 0 && k2 != 0; sign += 2) {
        double side = (-k1 + sign * sqrt(h)) / k2, y = m1 - cone->ra * dr + side * m2, normal[3];
        if (!(y > 0 && y < d2 && side < *t)) continue;
        for (int k = 0; k < 3; k++) {
            at[k] = from[k] + side * ray->direction[k];
            normal[k] = d2 * at[k] - axis[k] * y;
        }
        if (dot(normal, ray->direction) >= 0) continue;
        *t = side;
        memcpy(n, normal, sizeof normal);
    }
    if (!(*t < HUGE_VAL)) return false;
    normalize(n);
    return true;
}

/* How far p is outside of the cone; negative inside. */
static double distance_to(const Cone *cone, const double p[3]) {
    double axis[3], from[3], rest[3];
    subtract(cone->b, cone->a, axis);
    subtract(p, cone->a, from);
    const double dr = cone->ra - cone->rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
    double y = dot(from, axis) / sqrt(length2), length = sqrt(length2);
    for (int k = 0; k < 3; k++) rest[k] = from[k] - y * axis[k] / length;
    double x = sqrt(dot(rest, rest)), z = y - length;
    double to_a = sqrt(x * x + y * y) - cone->ra, to_b = sqrt(x * x + z * z) - cone->rb;
    if (d2 <= 0) return dr > 0 ? to_a : to_b;
    double slope = dr / length, lean = sqrt(1 - slope * slope); /* the side's normal: lean out, slope along */
    double along = y * lean - x * slope;
    if (along <= 0) return to_a;
    if (along >= length * lean) return to_b;
    return x * lean + y * slope - cone->ra;
}

/* Whether the entry point lies inside the segment before or after on the strand: no surface there. */
static bool is_in_neighbour(const Shape *shape, uint32_t segment, const double p[3]) {
    for (int step = -1; step <= 1; step += 2) {
        uint32_t other = segment + (uint32_t)step;
        if (other >= shape->count || shape->strand[other] != shape->strand[segment]) continue;
        Cone cone = cone_of(shape, other);
        if (distance_to(&cone, p) < -1e-7 * (cone.ra < cone.rb ? cone.ra : cone.rb)) return true;
    }
    return false;
}

static bool hit_segment(const Shape *shape, uint32_t segment, const Ray *ray, TraceHit *hit) {
    Cone cone = cone_of(shape, segment);
    double t, n[3], p[3];
    if (!enter_cone(&cone, ray, &t, n) || !(t >= ray->near && t <= ray->far)) return false;
    for (int k = 0; k < 3; k++) p[k] = ray->origin[k] + t * ray->direction[k];
    if (is_in_neighbour(shape, segment, p)) return false;
    *hit = (TraceHit){.t = t, .primitive = segment};
    memcpy(hit->n, n, sizeof n);
    return true;
}

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

/* What a ray looks for: the first hit behind `after`, or, where `v` is there, what is left of the light
 * behind all hits. */
typedef struct Query {
    Ray ray;
    const TraceHit *after;
    TraceHit hit;
    bool found;
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
    if (!behind || (query->found && comes_before(&query->hit, hit))) return false;
    query->found = true;
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
    return query.found;
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

/* What is left of the light along the ray. */
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

/* Section 7.1: from the side of the triangle that wi is on; near the terminator from the smooth surface. */
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
    double step = tracer->extent * 0x1p-18, above = dot(ng, wi), side = above < 0 ? -1 : 1;
    if (dot(n, wi) > 0 && dot(n, ng) > 0 && above < 0.1) {
        add_lift(mesh, triangle, corners, b, 1 - fmax(0, above) / 0.1, x);
        side = 1;
    }
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
