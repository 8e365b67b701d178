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

struct Tracer {
    const RnaMesh *mesh;     /* one of the two */
    const RnaCurves *curves;
    uint32_t count;          /* primitives */
    uint32_t *order;         /* of the primitives in the leaves */
    uint32_t *strand;        /* of each segment */
    Node *nodes;             /* the left child stands behind its parent */
    uint32_t node_count;
    double extent;           /* largest absolute coordinate of the positions */
};

typedef struct Ray {
    double origin[3], direction[3], inverse[3];
    double far;
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

/* Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides block, and
 * of two triangles that share an edge one is hit at least. */
static bool hit_triangle(const RnaMesh *mesh, uint32_t triangle, const Ray *ray, TraceHit *hit) {
    const double *d = ray->direction;
    int z = fabs(d[0]) > fabs(d[1]) ? 0 : 1;
    if (fabs(d[2]) > fabs(d[z])) z = 2;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    double v[3][3], u[3], sum = 0, t = 0;
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
    }
    bool outside = (u[0] < 0 || u[1] < 0 || u[2] < 0) && (u[0] > 0 || u[1] > 0 || u[2] > 0);
    if (outside || sum == 0) return false;
    for (int k = 0; k < 3; k++) t += u[k] * v[k][z] / d[z];
    t /= sum;
    if (!(t >= 0 && t < ray->far)) return false;
    *hit = (TraceHit){.t = t, .primitive = triangle, .b1 = u[1] / sum, .b2 = u[2] / sum};
    return true;
}

/* ---------------------------------------------------------------- Segments */

/* A round cone: the convex hull of two spheres. */
typedef struct Cone {
    double a[3], b[3], ra, rb;
} Cone;

static Cone cone_of(const Tracer *tracer, uint32_t segment) {
    uint32_t i = segment + tracer->strand[segment]; /* its first point */
    Cone cone = {.ra = tracer->curves->radii[i], .rb = tracer->curves->radii[i + 1]};
    load(&tracer->curves->points[3 * (size_t)i], cone.a);
    load(&tracer->curves->points[3 * (size_t)i + 3], cone.b);
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
static bool is_in_neighbour(const Tracer *tracer, uint32_t segment, const double p[3]) {
    for (int step = -1; step <= 1; step += 2) {
        uint32_t other = segment + (uint32_t)step;
        if (other >= tracer->count || tracer->strand[other] != tracer->strand[segment]) continue;
        Cone cone = cone_of(tracer, other);
        if (distance_to(&cone, p) < -1e-7 * (cone.ra < cone.rb ? cone.ra : cone.rb)) return true;
    }
    return false;
}

static bool hit_segment(const Tracer *tracer, uint32_t segment, const Ray *ray, TraceHit *hit) {
    Cone cone = cone_of(tracer, segment);
    double t, n[3], p[3];
    if (!enter_cone(&cone, ray, &t, n) || !(t >= 0 && t < ray->far)) return false;
    for (int k = 0; k < 3; k++) p[k] = ray->origin[k] + t * ray->direction[k];
    if (is_in_neighbour(tracer, segment, p)) return false;
    *hit = (TraceHit){.t = t, .primitive = segment};
    memcpy(hit->n, n, sizeof n);
    return true;
}

/* ------------------------------------------------------- Bounding volumes */

static void box_of(const Tracer *tracer, uint32_t primitive, double low[3], double high[3]) {
    if (tracer->mesh) {
        double v[3][3];
        corners_of(tracer->mesh, primitive, v);
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(v[0][k], fmin(v[1][k], v[2][k]));
            high[k] = fmax(v[0][k], fmax(v[1][k], v[2][k]));
        }
        return;
    }
    Cone cone = cone_of(tracer, primitive);
    for (int k = 0; k < 3; k++) {
        low[k] = fmin(cone.a[k] - cone.ra, cone.b[k] - cone.rb);
        high[k] = fmax(cone.a[k] + cone.ra, cone.b[k] + cone.rb);
    }
}

static double middle_of(const Tracer *tracer, uint32_t primitive, int axis) {
    double low[3], high[3];
    box_of(tracer, primitive, low, high);
    return (low[axis] + high[axis]) / 2;
}

/* Parts order[first .. first + count) in the middle of the box, or in two halves where that fails;
 * the number on the left. */
static uint32_t part(Tracer *tracer, uint32_t first, uint32_t count, const Node *node, int depth) {
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (node->high[k] - node->low[k] > node->high[axis] - node->low[axis]) axis = k;
    double split = (node->low[axis] + node->high[axis]) / 2;
    uint32_t left = first;
    for (uint32_t i = first; i < first + count; i++)
        if (middle_of(tracer, tracer->order[i], axis) < split) {
            uint32_t swap = tracer->order[i];
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
        uint32_t left = part(tracer, first, count, &node, depth);
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

/* Hits of a ray, each handed to `take`, which may shorten the ray; stops where it returns true. */
typedef struct Query {
    Ray ray;
    TraceHit hit;
    bool found, any;   /* any: the first hit will do */
    uint32_t skipped;  /* strand that the ray passes through, or UINT32_MAX */
} Query;

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
        for (uint32_t i = node->first; i < node->first + node->count; i++) {
            uint32_t primitive = tracer->order[i];
            if (tracer->curves && tracer->strand[primitive] == query->skipped) continue;
            bool hit = tracer->mesh ? hit_triangle(tracer->mesh, primitive, &query->ray, &query->hit)
                                    : hit_segment(tracer, primitive, &query->ray, &query->hit);
            if (!hit) continue;
            query->found = true;
            query->ray.far = query->hit.t;
            if (query->any) return;
        }
    }
}

static Query new_query(const double origin[3], const double direction[3], bool any, uint32_t skipped) {
    Query query = {.any = any, .skipped = skipped, .ray.far = HUGE_VAL};
    memcpy(query.ray.origin, origin, sizeof query.ray.origin);
    memcpy(query.ray.direction, direction, sizeof query.ray.direction);
    normalize(query.ray.direction);
    for (int k = 0; k < 3; k++) query.ray.inverse[k] = 1 / query.ray.direction[k];
    return query;
}

/* --------------------------------------------------------- The interface */

static void number_segments(Tracer *tracer) {
    uint32_t segment = 0;
    for (uint32_t s = 0; s < tracer->curves->strand_count; s++)
        for (uint32_t i = tracer->curves->offsets[s]; i + 1 < tracer->curves->offsets[s + 1]; i++)
            tracer->strand[segment++] = s;
}

Tracer *trace_new(const RnaAsset *asset) {
    Tracer *tracer = calloc(1, sizeof *tracer);
    if (!tracer) return NULL;
    tracer->mesh = rna_mesh(asset);
    tracer->curves = rna_curves(asset);
    tracer->count = tracer->mesh ? tracer->mesh->triangle_count
                                 : tracer->curves->point_count - tracer->curves->strand_count;
    tracer->order = malloc(tracer->count * sizeof *tracer->order);
    tracer->strand = malloc(tracer->count * sizeof *tracer->strand);
    tracer->nodes = malloc(2 * (size_t)tracer->count * sizeof *tracer->nodes);
    if (!tracer->order || !tracer->strand || !tracer->nodes) {
        trace_free(tracer);
        return NULL;
    }
    for (uint32_t i = 0; i < tracer->count; i++) tracer->order[i] = i;
    if (tracer->curves) number_segments(tracer);
    for (size_t i = 0; tracer->mesh && i < 3 * (size_t)tracer->mesh->vertex_count; i++)
        tracer->extent = fmax(tracer->extent, fabs(tracer->mesh->positions[i]));
    build(tracer, 0, tracer->count, 0);
    return tracer;
}

void trace_free(Tracer *tracer) {
    if (!tracer) return;
    free(tracer->order);
    free(tracer->strand);
    free(tracer->nodes);
    free(tracer);
}

uint32_t trace_primitive_count(const Tracer *tracer) { return tracer->count; }

bool trace_closest(const Tracer *tracer, const double origin[3], const double direction[3], TraceHit *hit) {
    Query query = new_query(origin, direction, false, UINT32_MAX);
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

void trace_tangent(const Tracer *tracer, uint32_t segment, double t[3]) {
    Cone cone = cone_of(tracer, segment);
    subtract(cone.b, cone.a, t);
    normalize(t);
}

/* Section 7: from the side of the triangle that wi is on; near the terminator from the smooth surface
 * that the flat triangles stand for. */
bool trace_visible_on_mesh(const Tracer *tracer, uint32_t triangle, double b1, double b2,
                           const double wi[3]) {
    const RnaMesh *mesh = tracer->mesh;
    const double b[3] = {1 - b1 - b2, b1, b2};
    double v[3][3], x[3], n[3], ng[3], e1[3], e2[3], lift[3] = {0};
    corners_of(mesh, triangle, v);
    trace_surface_point(mesh, triangle, b1, b2, x, n);
    subtract(v[1], v[0], e1);
    subtract(v[2], v[0], e2);
    cross(e1, e2, ng);
    normalize(ng);
    double step = tracer->extent * 0x1p-18, above = dot(ng, wi), side = above < 0 ? -1 : 1;
    if (dot(n, wi) > 0 && dot(n, ng) > 0 && above < 0.1) {
        double smooth = 1 - fmax(0, above) / 0.1;
        side = 1;
        for (int corner = 0; corner < 3; corner++) {
            double to_corner[3], normal[3];
            subtract(v[corner], x, to_corner);
            load(&mesh->normals[3 * (size_t)mesh->triangles[3 * (size_t)triangle + (size_t)corner]], normal);
            double height = fmax(0, dot(to_corner, normal));
            for (int k = 0; k < 3; k++) lift[k] += smooth * b[corner] * height * normal[k];
        }
    }
    for (int k = 0; k < 3; k++) x[k] += lift[k] + side * step * ng[k];
    Query query = new_query(x, wi, true, UINT32_MAX);
    search(tracer, &query);
    return !query.found;
}

/* Only other strands block, where the ray enters them. */
bool trace_visible_on_fiber(const Tracer *tracer, uint32_t segment, const double position[3],
                            const double wi[3]) {
    Query query = new_query(position, wi, true, tracer->strand[segment]);
    search(tracer, &query);
    return !query.found;
}
