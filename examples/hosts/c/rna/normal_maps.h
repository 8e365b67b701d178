/* Normals with the relief of normal maps (section 4.5). */
#ifndef RNA_NORMAL_MAPS_H
#define RNA_NORMAL_MAPS_H

#include "textures.h"
#include "vectors.h"

#define SHORT_VECTOR 1e-6

/* Brings v to unit length; false, and v as it was, where it is no longer than `least`. */
static bool made_unit(double v[3], double least) {
    double length = sqrt(dot(v, v));
    if (!(length > least)) return false;
    for (int k = 0; k < 3; k++) v[k] /= length;
    return true;
}

/* The interpolated normal (section 4.1). */
static void plain_normal(const RnaMesh *mesh, const uint32_t corner[3], const double b[3], double n[3]) {
    for (size_t k = 0; k < 3; k++) {
        n[k] = 0;
        for (int i = 0; i < 3; i++) n[k] += b[i] * mesh->normals[3 * (size_t)corner[i] + k];
    }
    normalize(n);
}

/* U and V, along which u and v grow on the triangle; false where its coordinates do not tell. */
static bool directions_of(const RnaMesh *mesh, const uint32_t corner[3], double along_u[3], double along_v[3]) {
    const float *p[3], *uv[3];
    for (int i = 0; i < 3; i++) {
        p[i] = &mesh->positions[3 * (size_t)corner[i]];
        uv[i] = &mesh->uvs[2 * (size_t)corner[i]];
    }
    double a1 = (double)uv[1][0] - uv[0][0], c1 = (double)uv[1][1] - uv[0][1];
    double a2 = (double)uv[2][0] - uv[0][0], c2 = (double)uv[2][1] - uv[0][1];
    double area = a1 * c2 - a2 * c1, sign = area < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++) {
        double e1 = (double)p[1][k] - p[0][k], e2 = (double)p[2][k] - p[0][k];
        along_u[k] = (c2 * e1 - c1 * e2) * sign;
        along_v[k] = (a1 * e2 - a2 * e1) * sign;
    }
    return area != 0;
}

/* Bends n, the plain normal of a hit, by the map. */
static void bend_normal(const RnaNormalMap *map, const RnaMesh *mesh, const uint32_t corner[3],
                        const double b[3], double n[3]) {
    double t[3], along_v[3], across[3], uv[2], q[3], bent[3];
    if (!directions_of(mesh, corner, t, along_v)) return;
    double size = sqrt(dot(t, t)), along_n = dot(t, n);
    for (int k = 0; k < 3; k++) t[k] -= along_n * n[k];
    if (!made_unit(t, SHORT_VECTOR * size)) return;
    cross(n, t, across);
    double up = dot(across, along_v) > 0 ? -1 : 1;
    coordinates_at(mesh, corner, b, uv);
    sample_texture(&map->texture, uv, q);
    double x = (255 * q[0] - 127) / 127, y = (255 * q[1] - 127) / 127, z = sqrt(fmax(0, 1 - x * x - y * y));
    for (int k = 0; k < 3; k++) bent[k] = x * t[k] + up * y * across[k] + z * n[k];
    if (made_unit(bent, SHORT_VECTOR)) memcpy(n, bent, sizeof bent);
}

#endif
