/* Normal maps (section 4.5). */
#ifndef RNA_NORMAL_MAPS_H
#define RNA_NORMAL_MAPS_H

#include "transmittance.h"

#define SHORT_VECTOR 1e-6

static bool read_normal_map(Span file, RnaNormalMap *map, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"NORMAL_MAP_TEXTURE", "NORMAL_MAP_TEXTURE", "NORMAL_MAP_TEXTURE",
                                      "NORMAL_MAP_TEXTURE", "NORMAL_MAP_TEXTURE", "NORMAL_MAP_TEXTURE"};
    Tensor tensor = {"normals", "U8", 3, {1, 1, 2}, {MAX_TEXTURE, MAX_TEXTURE, 2}};
    if (!read_tensors(file, &tensor, 1, entry, &CODES, report)) return false;
    map->height = (uint32_t)tensor.shape[0];
    map->width = (uint32_t)tensor.shape[1];
    map->texels = tensor.data;
    return true;
}

static double dot3(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Of length 1; false, and as it was, where it has no direction. */
static bool make_unit(double v[3]) {
    double length = sqrt(dot3(v, v));
    if (!(length > 0 && length <= DBL_MAX)) return false;
    for (int k = 0; k < 3; k++) v[k] /= length;
    return true;
}

/* Along which u and v grow on the triangle; false where its coordinates do not tell. */
static bool texture_directions(const RnaMesh *mesh, const uint32_t corner[3], double along_u[3],
                               double along_v[3]) {
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

/* The frame (t, b, n) of the relief at the normal n; false where there is none. */
static bool relief_frame(const RnaMesh *mesh, const uint32_t corner[3], const double n[3], double t[3],
                         double b[3]) {
    double along_u[3], along_v[3];
    if (!texture_directions(mesh, corner, along_u, along_v)) return false;
    double along_n = dot3(along_u, n);
    for (int k = 0; k < 3; k++) t[k] = along_u[k] - along_n * n[k];
    if (!(sqrt(dot3(t, t)) > SHORT_VECTOR * sqrt(dot3(along_u, along_u))) || !make_unit(t)) return false;
    for (int k = 0; k < 3; k++) b[k] = n[(k + 1) % 3] * t[(k + 2) % 3] - n[(k + 2) % 3] * t[(k + 1) % 3];
    if (dot3(b, along_v) > 0)
        for (int k = 0; k < 3; k++) b[k] = -b[k];
    return true;
}

/* Bends the unit normal n of a hit at weights w of the corners. */
static void bend_normal(const RnaNormalMap *map, const RnaMesh *mesh, const uint32_t corner[3],
                        const double w[3], double n[3]) {
    double t[3], b[3], m[3], uv[2] = {0}, texel[2];
    if (!relief_frame(mesh, corner, n, t, b)) return;
    for (int i = 0; i < 3; i++)
        for (size_t k = 0; k < 2; k++) uv[k] += w[i] * mesh->uvs[2 * (size_t)corner[i] + k];
    const Texels texels = {map->texels, map->width, map->height, 2};
    if (!sample_texels(&texels, uv[0], uv[1], texel)) return;
    double x = (texel[0] - 127) / 127, y = (texel[1] - 127) / 127, z = sqrt(fmax(0, 1 - x * x - y * y));
    for (int k = 0; k < 3; k++) m[k] = x * t[k] + y * b[k] + z * n[k];
    if (sqrt(dot3(m, m)) > SHORT_VECTOR && make_unit(m)) memcpy(n, m, sizeof m);
}

/* The interpolated normal of a hit, unit; false where the corners' cancel. */
static bool plain_normal(const RnaMesh *mesh, const uint32_t corner[3], const double w[3], double n[3]) {
    for (size_t k = 0; k < 3; k++) {
        n[k] = 0;
        for (int i = 0; i < 3; i++) n[k] += w[i] * mesh->normals[3 * (size_t)corner[i] + k];
    }
    return make_unit(n);
}

#endif
