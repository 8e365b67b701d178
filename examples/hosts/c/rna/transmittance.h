/* Holes and thin glass (section 4.4). */
#ifndef RNA_TRANSMITTANCE_H
#define RNA_TRANSMITTANCE_H

#include "textures.h"

static bool read_texture(Span file, RnaTransmittance *record, const char *entry, RnaReport *report) {
    const char *code = "TRANSMITTANCE_TEXTURE";
    if (!read_texels(file, "transmittance", 1, 3, code, entry, &record->texture, report)) return false;
    uint32_t channels = record->texture.channels;
    return (channels == 1 || (channels == 3 && record->cutoff == 0)) ||
           refuse(report, code, entry, "1 or 3 channels, 1 with a cutoff", "%u", (unsigned)channels);
}

/* The members of a record in the manifest. */
static RnaTransmittance record_of(const Json *json) {
    const Json *cutoff = member(json, "cutoff"), *ior = member(json, "ior");
    const Range range = range_of(json);
    RnaTransmittance record = {.first = range.first, .count = range.count};
    if (cutoff) record.cutoff = cutoff->number;
    if (ior) record.ior[0] = ior->first->number, record.ior[1] = ior->first->next->number;
    return record;
}

/* Whether the mesh has the coordinates that the texture is looked up with. */
static bool check_coordinates(const RnaTransmittance *record, const RnaMesh *mesh, const char *where,
                              RnaReport *report) {
    return mesh->uvs || (record->texture.width == 1 && record->texture.height == 1) ||
           refuse(report, "TRANSMITTANCE_UV", where, "a mesh with TEXCOORD_0", "none");
}

/* Reflectance of unpolarised light at a smooth dielectric of relative index e, at cosine c. */
static double fresnel(double e, double c) {
    double square = e * e - 1 + c * c;
    if (!(square > 0)) return 1;
    double g = sqrt(square), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
    return a * a * (1 + b * b) / 2;
}

/* 1 - F for a ray of unit direction d: by its angle to the shading normal, from the side of the triangle
 * that it comes from. */
static double fresnel_share(const RnaTransmittance *record, const RnaMesh *mesh, const uint32_t corner[3],
                            const double b[3], const double d[3]) {
    double n[3] = {0}, e[2][3], side = 0, length2 = 0, n_d = 0;
    const float *v[3];
    for (int i = 0; i < 3; i++) v[i] = &mesh->positions[3 * (size_t)corner[i]];
    for (size_t k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) n[k] += b[i] * mesh->normals[3 * (size_t)corner[i] + k];
        e[0][k] = (double)v[1][k] - v[0][k];
        e[1][k] = (double)v[2][k] - v[0][k];
        length2 += n[k] * n[k];
        n_d += n[k] * d[k];
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        side += d[k] * (e[0][i] * e[1][j] - e[0][j] * e[1][i]);
    }
    double cosine = length2 > 0 ? fmin(fabs(n_d) / sqrt(length2), 1) : 0;
    return 1 - fresnel(record->ior[side < 0 ? 0 : 1], cosine);
}

static void look_up(const RnaTransmittance *record, const RnaMesh *mesh, uint32_t triangle, double b1,
                    double b2, const float direction[3], float tau[3]) {
    const uint32_t *corner = &mesh->triangles[3 * (size_t)triangle];
    const double b[3] = {1 - b1 - b2, b1, b2};
    double uv[2], d[3] = {direction[0], direction[1], direction[2]}, values[3], share = 1;
    coordinates_at(mesh, corner, b, uv);
    sample_texture(&record->texture, uv, values);
    if (record->cutoff > 0)
        for (int k = 0; k < 3; k++) values[k] = values[k] > record->cutoff;
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int k = 0; k < 3; k++) d[k] /= length > 0 ? length : 1;
    if (record->ior[0] > 0) share = fresnel_share(record, mesh, corner, b, d);
    for (int k = 0; k < 3; k++) {
        double value = values[k] * share;
        tau[k] = (float)(value > 0 ? fmin(value, 1) : 0); /* 0 for NaN */
    }
}

#endif
