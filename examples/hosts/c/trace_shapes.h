/* Triangles and round cones, and where rays hit them (sections 4.1 and 4.2); a part of trace.c. */
#ifndef TRACE_SHAPES_H
#define TRACE_SHAPES_H

#include "rna/vectors.h"
#include "trace.h"

#include <string.h>

/* The tracer's record of a part. */
typedef struct Shape {
    const RnaMesh *mesh;     /* one of the two */
    const RnaCurves *curves;
    uint32_t count;          /* primitives */
    uint32_t *strand;        /* of each segment */
} Shape;

typedef struct Ray {
    double origin[3], direction[3], inverse[3];
    double near, far;
} Ray;

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

#endif
