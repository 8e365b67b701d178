/* Records of a range of triangles with a texture: their common members (sections 4.4 and 4.5). */
#ifndef RNA_TEXTURES_H
#define RNA_TEXTURES_H

#include "manifest_rules.h"
#include "tensors.h"

/* The texture in a file of one tensor; code: of every fault. */
static bool read_texels(Span file, const char *name, uint64_t least, uint64_t most, const char *code,
                        const char *entry, RnaTexture *texture, RnaReport *report) {
    const TensorCodes codes = {code, code, code, code, code, code};
    Tensor tensor = {name, "U8", 3, {1, 1, least}, {MAX_TEXTURE, MAX_TEXTURE, most}};
    if (!read_tensors(file, &tensor, 1, entry, &codes, report)) return false;
    *texture = (RnaTexture){(uint32_t)tensor.shape[1], (uint32_t)tensor.shape[0], (uint32_t)tensor.shape[2],
                         tensor.data};
    return true;
}

/* Triangles of a record. */
typedef struct Range {
    uint32_t first, count;
} Range;

static Range range_of(const Json *record) {
    const Json *first = member(record, "triangles")->first;
    /* Beyond 32 bits there is no triangle, and check_range refuses what ends there. */
    return (Range){(uint32_t)fmin(first->number, UINT32_MAX), (uint32_t)fmin(first->next->number, UINT32_MAX)};
}

/* The range lies in the mesh, behind the range of the record before, which ends at `start`. */
static bool check_range(Range range, uint64_t start, const RnaMesh *mesh, const char *code,
                        const char *where, RnaReport *report) {
    return (range.first >= start && (uint64_t)range.first + range.count <= mesh->triangle_count) ||
           refuse(report, code, where, "ranges that ascend, inside the mesh", "%u triangles from %u",
                  (unsigned)range.count, (unsigned)range.first);
}

static double wrapped(double i, double size) { return i - size * floor(i / size); }

/* Values of the texture at (u, v), which repeats: 0 to 1, the first channel again where there are no
 * three. */
static void sample_texture(const RnaTexture *texture, const double uv[2], double values[3]) {
    double s = uv[0] * texture->width - 0.5, t = uv[1] * texture->height - 0.5, i = floor(s), j = floor(t);
    for (size_t channel = 0; channel < 3; channel++) values[channel] = 0;
    for (int corner = 0; corner < 4; corner++) {
        double column = wrapped(i + (corner & 1), texture->width);
        double row = wrapped(j + (corner >> 1), texture->height);
        double weight = (corner & 1 ? s - i : 1 - (s - i)) * (corner >> 1 ? t - j : 1 - (t - j));
        if (!(column < texture->width && row < texture->height)) return; /* beyond what float64 resolves */
        const uint8_t *texel =
            texture->texels + ((size_t)row * texture->width + (size_t)column) * texture->channels;
        for (size_t channel = 0; channel < 3; channel++)
            values[channel] += weight * texel[channel % texture->channels] / 255;
    }
}

/* Texture coordinates of a hit; 0 where the mesh has none. */
static void coordinates_at(const RnaMesh *mesh, const uint32_t corner[3], const double b[3], double uv[2]) {
    uv[0] = uv[1] = 0;
    for (int i = 0; i < 3 && mesh->uvs; i++)
        for (size_t k = 0; k < 2; k++) uv[k] += b[i] * mesh->uvs[2 * (size_t)corner[i] + k];
}

#endif
