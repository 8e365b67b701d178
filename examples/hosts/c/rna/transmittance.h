/* Holes and thin glass (section 4.4). */
#ifndef RNA_TRANSMITTANCE_H
#define RNA_TRANSMITTANCE_H

#include "manifest_rules.h"
#include "tensors.h"

static bool read_texture(Span file, RnaTransmittance *record, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"TRANSMITTANCE_TEXTURE", "TRANSMITTANCE_TEXTURE",
                                      "TRANSMITTANCE_TEXTURE", "TRANSMITTANCE_TEXTURE",
                                      "TRANSMITTANCE_TEXTURE", "TRANSMITTANCE_TEXTURE"};
    Tensor tensor = {"transmittance", "U8", 3, {1, 1, 1}, {MAX_TEXTURE, MAX_TEXTURE, 3}};
    if (!read_tensors(file, &tensor, 1, entry, &CODES, report)) return false;
    record->height = (uint32_t)tensor.shape[0];
    record->width = (uint32_t)tensor.shape[1];
    record->channels = (uint32_t)tensor.shape[2];
    record->texels = tensor.data;
    if (record->channels == 2 || (record->channels == 3 && record->cutoff > 0))
        return refuse(report, "TRANSMITTANCE_TEXTURE", entry, "1 or 3 channels, 1 with a cutoff", "%u",
                      (unsigned)record->channels);
    return true;
}

/* The triangles of a record.  Beyond 32 bits there is none, and check_range refuses what ends there. */
static void range_of(const Json *json, uint32_t *first, uint32_t *count) {
    const Json *triangles = member(json, "triangles")->first;
    *first = (uint32_t)fmin(triangles->number, UINT32_MAX);
    *count = (uint32_t)fmin(triangles->next->number, UINT32_MAX);
}

/* What the manifest says of a record. */
static RnaTransmittance record_of(const Json *json) {
    const Json *cutoff = member(json, "cutoff"), *ior = member(json, "ior");
    RnaTransmittance record = {0};
    range_of(json, &record.first, &record.count);
    if (cutoff) record.cutoff = cutoff->number;
    if (ior) record.ior[0] = ior->first->number, record.ior[1] = ior->first->next->number;
    return record;
}

/* The range lies at `start` or behind, and in the mesh. */
static bool check_range(const char *code, uint32_t first, uint32_t count, uint64_t start,
                        const RnaMesh *mesh, const char *where, RnaReport *report) {
    return (first >= start && (uint64_t)first + count <= mesh->triangle_count) ||
           refuse(report, code, where, "ranges that ascend, inside the mesh", "%u triangles from %u",
                  (unsigned)count, (unsigned)first);
}

/* Whether the mesh has the coordinates that the texture is looked up with. */
static bool check_coordinates(const RnaTransmittance *record, const RnaMesh *mesh, const char *where,
                              RnaReport *report) {
    return mesh->uvs || (record->width == 1 && record->height == 1) ||
           refuse(report, "TRANSMITTANCE_UV", where, "a mesh with TEXCOORD_0", "none");
}

/* Reflectance of unpolarised light at a smooth dielectric of relative index e, at cosine c. */
static double fresnel(double e, double c) {
    double square = e * e - 1 + c * c;
    if (!(square > 0)) return 1;
    double g = sqrt(square), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
    return a * a * (1 + b * b) / 2;
}

static double wrapped(double i, double size) { return i - size * floor(i / size); }

/* [height][width][channels], which repeat. */
typedef struct Texels {
    const uint8_t *at;
    uint32_t width, height, channels;
} Texels;

/* Values from 0 to 255 of each channel at (u, v), bilinear; false, and 0, beyond what float64 resolves. */
static bool sample_texels(const Texels *texels, double u, double v, double *values) {
    const double width = texels->width, height = texels->height;
    double s = u * width - 0.5, t = v * height - 0.5, i = floor(s), j = floor(t);
    for (size_t channel = 0; channel < texels->channels; channel++) values[channel] = 0;
    for (int corner = 0; corner < 4; corner++) {
        double column = wrapped(i + (corner & 1), width), row = wrapped(j + (corner >> 1), height);
        double weight = (corner & 1 ? s - i : 1 - (s - i)) * (corner >> 1 ? t - j : 1 - (t - j));
        if (!(column < width && row < height)) return false;
        const uint8_t *texel =
            texels->at + ((size_t)row * texels->width + (size_t)column) * texels->channels;
        for (size_t channel = 0; channel < texels->channels; channel++)
            values[channel] += weight * texel[channel];
    }
    return true;
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
    double uv[2] = {0}, d[3] = {direction[0], direction[1], direction[2]}, values[3], share = 1;
    for (int i = 0; i < 3 && mesh->uvs; i++)
        for (size_t k = 0; k < 2; k++) uv[k] += b[i] * mesh->uvs[2 * (size_t)corner[i] + k];
    const Texels texels = {record->texels, record->width, record->height, record->channels};
    sample_texels(&texels, uv[0], uv[1], values);
    for (uint32_t k = 3; k-- > 0;) values[k] = values[k % record->channels] / 255;
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
