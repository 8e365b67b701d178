/* Rest points of deformed shapes, and the rotations to rest (section 8.3). */
#ifndef RNA_REST_H
#define RNA_REST_H

#include "asset.h"
#include "rotations.h"

struct RnaShape {
    const RnaMesh *mesh;     /* at rest; of a surface, else NULL */
    const RnaCurves *curves; /* of fibers, else NULL */
    float *positions;        /* deformed, a copy */
    float *normals;          /* of a mesh, deformed */
    double (*rotations)[9];  /* of curves, a segment: from rest to deformed */
    uint32_t *first;         /* the first point of each segment */
    uint32_t segments;
};

/* The edges of a triangle; false where they enclose no area. */
static bool edges_of(const float *positions, const uint32_t corner[3], double e1[3], double e2[3], double n[3]) {
    double p[3][3];
    for (int k = 0; k < 3; k++) load(positions + 3 * (size_t)corner[k], p[k]);
    subtract(p[1], p[0], e1);
    subtract(p[2], p[0], e2);
    cross(e1, e2, n);
    const double area = sqrt(dot(n, n)), longest = fmax(dot(e1, e1), dot(e2, e2));
    normalize(n);
    return area > 1e-6 * longest;
}

/* The rotation of a triangle; false, and none, where it has no area.  In axes of their own, along e1 and across it, the
 * gradient of two triangles is [[along, shear], [0, across]], whose polar decomposition has a closed form. */
static bool triangle_rotation(const float *rest, const float *deformed, const uint32_t corner[3], double r[9]) {
    double axes[2][3][3], size[2][3];
    for (int i = 0; i < 9; i++) r[i] = i % 4 == 0;
    for (int s = 0; s < 2; s++) {
        double e1[3], e2[3], *t = axes[s][0], *n = axes[s][2];
        if (!edges_of(s ? deformed : rest, corner, e1, e2, n)) return false;
        memcpy(t, e1, sizeof e1);
        normalize(t);
        cross(n, t, axes[s][1]);
        size[s][0] = dot(e1, t), size[s][1] = dot(e2, t), size[s][2] = dot(e2, axes[s][1]);
    }
    const double along = size[1][0] / size[0][0], shear = (size[1][1] - along * size[0][1]) / size[0][2];
    double c = along + size[1][2] / size[0][2], s = -shear;
    const double scale = 1 / sqrt(c * c + s * s);
    c *= scale, s *= scale;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double x = c * axes[1][0][i] + s * axes[1][1][i], y = c * axes[1][1][i] - s * axes[1][0][i];
            r[3 * i + j] = x * axes[0][0][j] + y * axes[0][1][j] + axes[1][2][i] * axes[0][2][j];
        }
    return true;
}

/* A vertex, by its place and normal. */
typedef struct Keyed {
    float key[6];
    uint32_t vertex;
} Keyed;

static int compare_keyed(const void *a, const void *b) {
    const float *p = ((const Keyed *)a)->key, *q = ((const Keyed *)b)->key;
    for (int k = 0; k < 6; k++)
        if (p[k] != q[k]) return p[k] < q[k] ? -1 : 1;
    return 0;
}

/* group[v]: the same for vertices at one place with one normal. */
static bool group_vertices(const RnaMesh *mesh, uint32_t *group) {
    Keyed *keyed = malloc(((size_t)mesh->vertex_count + 1) * sizeof *keyed);
    if (!keyed) return false;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        memcpy(keyed[v].key, mesh->positions + 3 * (size_t)v, 3 * sizeof(float));
        memcpy(keyed[v].key + 3, mesh->normals + 3 * (size_t)v, 3 * sizeof(float));
        keyed[v].vertex = v;
    }
    qsort(keyed, mesh->vertex_count, sizeof *keyed, compare_keyed);
    for (uint32_t i = 0; i < mesh->vertex_count; i++)
        group[keyed[i].vertex] = i && compare_keyed(&keyed[i - 1], &keyed[i]) == 0 ? group[keyed[i - 1].vertex] : i;
    free(keyed);
    return true;
}

/* Adds R n of each triangle to the sums of its corners, by their angles at rest. */
static void add_normals(const RnaMesh *mesh, const float *deformed, const uint32_t *group, double (*sums)[3]) {
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *corner = &mesh->triangles[3 * t];
        double r[9], p[3][3];
        if (!triangle_rotation(mesh->positions, deformed, corner, r)) continue;
        for (int k = 0; k < 3; k++) load(mesh->positions + 3 * (size_t)corner[k], p[k]);
        for (int k = 0; k < 3; k++) {
            double a[3], b[3], across[3], n[3], turned[3];
            subtract(p[(k + 1) % 3], p[k], a);
            subtract(p[(k + 2) % 3], p[k], b);
            cross(a, b, across);
            const double angle = atan2(sqrt(dot(across, across)), dot(a, b));
            load(mesh->normals + 3 * (size_t)corner[k], n);
            turn(r, n, turned);
            for (int i = 0; i < 3; i++) sums[group[corner[k]]][i] += angle * turned[i];
        }
    }
}

static bool deform_normals(RnaShape *shape) {
    const RnaMesh *mesh = shape->mesh;
    const size_t count = (size_t)mesh->vertex_count + 1;
    uint32_t *group = malloc(count * sizeof *group);
    double(*sums)[3] = calloc(count, sizeof *sums);
    const bool good = group && sums && group_vertices(mesh, group);
    if (good) add_normals(mesh, shape->positions, group, sums);
    for (size_t v = 0; good && v < mesh->vertex_count; v++) {
        double *n = sums[group[v]];
        if (dot(n, n) > 0)
            normalize(n);
        else
            load(mesh->normals + 3 * v, n);
        for (int k = 0; k < 3; k++) shape->normals[3 * v + (size_t)k] = (float)n[k];
    }
    free(group);
    free(sums);
    return good;
}

/* Of a hit on a triangle of the shape. */
static void rest_on_mesh(const RnaShape *shape, uint32_t triangle, const double b[3], RnaRest *rest) {
    const RnaMesh *mesh = shape->mesh, moved = {.normals = shape->normals};
    const uint32_t *corner = &mesh->triangles[3 * (size_t)triangle];
    double r[9], n[3], bent[3], near[3], q[9], all[9];
    triangle_rotation(mesh->positions, shape->positions, corner, r);
    transpose(r);
    plain_normal(mesh, corner, b, n);
    plain_normal(&moved, corner, b, bent);
    turn(r, bent, near);
    smallest_rotation(near, n, q);
    composed(q, r, all);
    for (size_t k = 0; k < 3; k++) {
        double x = 0;
        for (int i = 0; i < 3; i++) x += b[i] * mesh->positions[3 * (size_t)corner[i] + k];
        rest->position[k] = (float)x;
        rest->axis[k] = (float)n[k];
    }
    for (int i = 0; i < 9; i++) rest->rotation[i] = (float)all[i];
}

#endif
