/* RNA packages in C; rna.h says what it offers.  One translation unit: compile this file; the files in
 * rna/ are parts of it, one concept each, and all their names are static.
 *
 * Nothing read from a package is trusted before it was compared with the bytes that are there. */
#define _POSIX_C_SOURCE 200809L /* for S_ISREG */
#include "rna.h"

#if defined(__GNUC__) /* tables leave out members that are 0 */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif

#include "rna/base_color.h"
#include "rna/blocks.h"
#include "rna/carrier.h"
#include "rna/deform.h"
#include "rna/package.h"

#include <sys/stat.h>

#ifndef S_ISREG
#define S_ISREG(mode) (((mode) & _S_IFMT) == _S_IFREG)
#endif

/* block: what is freed with the asset, or NULL.  The file is a package, or a .glb that carries one. */
static RnaAsset *open_span(Span file, void *block, RnaReport *report) {
    if (is_glb(file)) file = find_package(file, report);
    if (report->errors) {
        free_aligned(block);
        return NULL;
    }
    RnaAsset *asset = calloc(1, sizeof *asset);
    Container *zip = calloc(1, sizeof *zip);
    if (!asset || !zip) {
        refuse(report, "FILE_UNREADABLE", "byte 0", "memory for it", "not enough");
        free(asset);
        free(zip);
        free_aligned(block);
        return NULL;
    }
    asset->file = zip->file = file;
    asset->block = block;
    asset->zip = zip;
    read_package(zip, asset, report);
    if (report->errors == 0) return asset;
    rna_close(asset);
    return NULL;
}

RnaAsset *rna_open_memory(const void *data, size_t size, RnaReport *report) {
    RnaReport unread;
    if (!report) report = &unread;
    memset(report, 0, sizeof *report);
    if (data && (uintptr_t)data % ALIGNMENT == 0) return open_span((Span){data, size}, NULL, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "an address that is a multiple of 64", "%p", data);
    return NULL;
}

/* The bytes of a file whose size is known; NULL where it has others. */
static void *bytes_of(const char *path, size_t size) {
    FILE *file = fopen(path, "rb");
    void *bytes = file ? aligned(size) : NULL;
    if (bytes && fread(bytes, 1, size, file) != size) {
        free_aligned(bytes);
        bytes = NULL;
    }
    if (file) fclose(file);
    return bytes;
}

RnaAsset *rna_open(const char *path, RnaReport *report) {
    RnaReport unread;
    if (!report) report = &unread;
    memset(report, 0, sizeof *report);
    struct stat status;
    bool good = path && stat(path, &status) == 0 && S_ISREG(status.st_mode); /* a pipe would wait for a writer */
    size_t size = good ? (size_t)status.st_size : 0;
    void *block = NULL;
    if (good && size > 0 && size < UINT32_MAX) { /* others are refused for their size */
        block = bytes_of(path, size);
        good = block != NULL;
    }
    if (good) return open_span((Span){block, size}, block, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "a readable file", "%s", path ? path : "no path");
    return NULL;
}

void rna_close(RnaAsset *asset) {
    if (!asset) return;
    free_package(asset);
    free_aligned(asset->block);
    free(asset);
}

int rna_part_count(const RnaAsset *asset) { return asset ? asset->parts : 0; }

const RnaPart *rna_part(const RnaAsset *asset, int part) {
    return asset && part >= 0 && part < asset->parts ? &asset->part[part].public : NULL;
}

int rna_tier_count(const RnaAsset *asset) { return asset ? asset->tiers : 0; }

int rna_tier_index(const RnaAsset *asset, const char *name) {
    for (int i = 0; asset && name && i < asset->tiers; i++)
        if (strcmp(asset->tier[i].public.name, name) == 0) return i;
    return -1;
}

const RnaTier *rna_tier(const RnaAsset *asset, int tier) {
    return asset && tier >= 0 && tier < asset->tiers ? &asset->tier[tier].public : NULL;
}

double rna_flip_at(const RnaAsset *asset, int tier, double pixels) {
    const RnaTier *of = rna_tier(asset, tier);
    if (!of || !asset->tier[tier].validation) return -1;
    const Json *table = member(asset->tier[tier].validation, "flipAtHeight");
    if (!table || !table->first) return of->flip;
    const Json *at = table->first; /* the tallest first */
    double height = member(at, "height")->number, flip = member(at, "flip")->number;
    while (pixels > 0 && pixels < height && (at = at->next)) {
        double lower = member(at, "height")->number, its_flip = member(at, "flip")->number;
        if (pixels > lower) return flip + (its_flip - flip) * log(height / pixels) / log(height / lower);
        height = lower;
        flip = its_flip;
    }
    return flip;
}

bool rna_in_domain(const RnaAsset *asset, bool is_wi, const float direction[3]) {
    const Json *region = asset ? member(asset->domain, is_wi ? "wi" : "wo") : NULL;
    if (!region || !direction) return false;
    const double x = direction[0], y = direction[1], z = direction[2], length = sqrt(x * x + y * y + z * z);
    if (!(length > 0 && length <= DBL_MAX)) return false;
    if (is_string(region, "sphere")) return true;
    if (is_string(region, "hemisphere")) return y >= 0;
    for (const Json *cone = region->first; cone; cone = cone->next) {
        const Json *i = member(cone, "axis")->first, *j = i->next, *k = j->next;
        double size = sqrt(i->number * i->number + j->number * j->number + k->number * k->number);
        double cosine = (i->number * x + j->number * y + k->number * z) / (size * length);
        if (cosine >= cos(member(cone, "halfAngle")->number) - 1e-6) return true; /* float32 directions */
    }
    return false;
}

static float light(float value, bool valid) {
    return valid && value > 0 ? (value < FLT_MAX ? value : FLT_MAX) : 0; /* 0 for NaN */
}

/* The tier part of the queries; NULL where an argument is missing or wrong. */
static const TierPart *queried_part(const RnaAsset *asset, int tier, int part, const Batch *batch) {
    const RnaPart *of = rna_part(asset, part);
    if (!of || !rna_tier(asset, tier)) return NULL;
    const bool given = batch->positions && batch->axes && batch->wo && batch->wi;
    if (batch->n && !(given && (of->kind == RNA_SURFACE || batch->h))) return NULL;
    return &asset->tier[tier].part[part];
}

enum { EMISSION = 2 }; /* behind visible and shadowed light */

/* The factors of a row's outputs; NULL where a tier part has none. */
typedef struct Factors {
    const float *base_color, *nearby;
} Factors;

/* A column of row r of the outputs and, with nearby light, those of each length, `set` columns on, times it. */
static float with_nearby(const float *outputs, size_t column, size_t set, const float *nearby, size_t r) {
    float value = outputs[column * ROWS + r];
    for (size_t k = 0; nearby && k < 3; k++)
        value += (nearby[k] > 0 ? nearby[k] : 0) * outputs[(column + (k + 1) * set) * ROWS + r];
    return value;
}

/* One colour of row r of the outputs, of `count`: a term, and with base colour another, which it multiplies. */
static void put_light(const float *outputs, size_t i, size_t count, Factors factors, bool valid, size_t r,
                      float *colour) {
    const float *a = factors.base_color, *s = factors.nearby;
    const size_t set = 3 * count * (a ? 2 : 1);
    for (size_t k = 0; k < 3; k++) valid &= (!a || a[k] - a[k] == 0) && (!s || s[k] - s[k] == 0);
    for (size_t k = 0; k < 3; k++) {
        float value = with_nearby(outputs, 3 * i + k, set, s, r);
        if (a) value += a[k] * with_nearby(outputs, 3 * (i + count) + k, set, s, r);
        colour[k] = light(value, valid);
    }
}

static Factors factors_of(const TierPart *with, Factors given, size_t result, size_t at) {
    Factors factors = {given.base_color ? given.base_color + at : NULL, NULL};
    if (with->counts_nearby && result < 2)
        factors.nearby = given.nearby ? given.nearby + at : with->nearby_means[result];
    return factors;
}

/* Runs a network of the part on all rows.  given: of all rows; without nearby light there, the means count.  colours:
 * `count` arrays of n x 3, for its results, from the part's result `first_result` on. */
static RnaStatus run_network(const RnaPart *of, const TierPart *with, const Network *network, const Batch *batch,
                             Factors given, float *const *colours, size_t first_result, size_t count) {
    if (batch->n == 0) return RNA_OK;
    if (!colours[0] || !colours[count - 1]) return RNA_BAD_ARGUMENT;
    size_t size = (size_t)ROWS * (size_t)rounded_up(network->decoder->widest, ALIGNMENT);
    float *buffers = aligned(2 * size * sizeof *buffers);
    if (!buffers) return RNA_OUT_OF_MEMORY;
    Points points;
    for (size_t first = 0; first < batch->n; first += ROWS) {
        int rows = (int)(batch->n - first < ROWS ? batch->n - first : ROWS);
        load_points(of, batch, first, rows, &points);
        fill_queries(&with->planes, network->column, &points, buffers);
        const float *results = run_decoder(network->decoder, buffers, buffers + size);
        for (size_t i = 0; i < count; i++)
            for (size_t r = 0, at = 3 * first; r < (size_t)rows; r++, at += 3)
                put_light(results, i, count, factors_of(with, given, first_result + i, at), points.valid[r], r,
                          colours[i] + at);
    }
    free_aligned(buffers);
    return RNA_OK;
}

RnaStatus rna_evaluate(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       const float *base_colors, float *visible, float *shadowed) {
    return rna_evaluate_nearby(asset, tier, part, n, positions, axes, h, wo, wi, base_colors, NULL, visible, shadowed);
}

RnaStatus rna_evaluate_nearby(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                              const float *axes, const float *h, const float *wo, const float *wi,
                              const float *base_colors, const float *nearby, float *visible, float *shadowed) {
    const Batch batch = {n, positions, axes, h, wo, wi};
    const TierPart *with = queried_part(asset, tier, part, &batch);
    if (!with || (n && !(visible && shadowed && (base_colors || !with->uses_base_color)))) return RNA_BAD_ARGUMENT;
    const RnaPart *of = rna_part(asset, part);
    const Factors given = {with->uses_base_color ? base_colors : NULL, nearby};
    const bool apart = with->shadowed.decoder != NULL;
    float *const both[] = {visible, shadowed};
    RnaStatus status = run_network(of, with, &with->transport, &batch, given, both, 0, apart ? 1 : 2);
    return apart && status == RNA_OK ? run_network(of, with, &with->shadowed, &batch, given, both + 1, 1, 1) : status;
}

const double *rna_nearby_lengths(const RnaAsset *asset, int tier, int part) {
    const bool there = rna_tier(asset, tier) && rna_part(asset, part);
    const TierPart *with = there ? &asset->tier[tier].part[part] : NULL;
    return with && with->counts_nearby ? with->nearby_lengths : NULL;
}

bool rna_uses_base_color(const RnaAsset *asset, int tier, int part) {
    return rna_tier(asset, tier) && rna_part(asset, part) && asset->tier[tier].part[part].uses_base_color;
}

RnaStatus rna_emission(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, float *emission) {
    const Batch batch = {n, positions, axes, h, wo, .wi = wo}; /* which no block of emission uses */
    const TierPart *with = queried_part(asset, tier, part, &batch);
    if (!with || (n && !emission)) return RNA_BAD_ARGUMENT;
    if (with->emission.decoder)
        return run_network(rna_part(asset, part), with, &with->emission, &batch, (Factors){0}, &emission, EMISSION, 1);
    for (size_t i = 0; i < 3 * n; i++) emission[i] = 0;
    return RNA_OK;
}

void rna_transmittance(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2,
                       const float direction[3], float tau[3]) {
    const RnaPart *of = rna_part(asset, part);
    for (int k = 0; k < 3; k++) tau[k] = 0;
    for (int i = 0; of && i < of->record_count; i++)
        if (triangle >= of->records[i].first && triangle - of->records[i].first < of->records[i].count)
            look_up(&of->records[i], of->mesh, triangle, b1, b2, direction, tau);
}

void rna_normal(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2, float normal[3]) {
    const RnaPart *of = rna_part(asset, part);
    const double b[3] = {1 - b1 - b2, b1, b2};
    double n[3] = {0};
    if (of && of->mesh && triangle < of->mesh->triangle_count) {
        const uint32_t *corner = &of->mesh->triangles[3 * (size_t)triangle];
        plain_normal(of->mesh, corner, b, n);
        for (int i = 0; i < of->normal_map_count; i++)
            if (triangle >= of->normal_maps[i].first &&
                triangle - of->normal_maps[i].first < of->normal_maps[i].count)
                bend_normal(&of->normal_maps[i], of->mesh, corner, b, n);
    }
    bool known = isfinite(n[0] + n[1] + n[2]);
    for (int k = 0; k < 3; k++) normal[k] = known ? (float)n[k] : 0;
}

RnaStatus rna_set_image(RnaAsset *asset, int part, int record, const uint8_t *rgb) {
    const RnaPart *of = rna_part(asset, part);
    if (!of || record < 0 || record >= of->base_color_count || !of->base_colors[record].file || !rgb)
        return RNA_BAD_ARGUMENT;
    const RnaBaseColor *color = &of->base_colors[record];
    Pyramid *pyramid = new_pyramid(color->width, color->height, color->is_srgb);
    if (!pyramid) return RNA_OUT_OF_MEMORY;
    memcpy(pyramid->texels, rgb, 3 * (size_t)color->width * color->height);
    if (!fill_levels(pyramid)) {
        free(pyramid);
        return RNA_OUT_OF_MEMORY;
    }
    free(asset->part[part].images[record]);
    asset->part[part].images[record] = pyramid;
    return RNA_OK;
}

/* The record of base colour of a triangle; -1 where it has none. */
static int base_color_record(const RnaPart *of, uint32_t triangle) {
    for (int i = 0; of && of->mesh && triangle < of->mesh->triangle_count && i < of->base_color_count; i++)
        if (triangle >= of->base_colors[i].first && triangle - of->base_colors[i].first < of->base_colors[i].count)
            return i;
    return -1;
}

void rna_base_color(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2, double level,
                    float a[3]) {
    const RnaPart *of = rna_part(asset, part);
    const double b[3] = {1 - b1 - b2, b1, b2};
    const int record = base_color_record(of, triangle);
    for (int k = 0; k < 3; k++) a[k] = 1;
    if (record >= 0)
        base_color_at(&of->base_colors[record], asset->part[part].images[record], of->mesh,
                      &of->mesh->triangles[3 * (size_t)triangle], b, level, a);
}

double rna_texel_density(const RnaAsset *asset, int part, uint32_t triangle) {
    const RnaPart *of = rna_part(asset, part);
    const int record = base_color_record(of, triangle);
    return record < 0 ? 0 : density_on(&of->base_colors[record], of->mesh, &of->mesh->triangles[3 * (size_t)triangle]);
}

const char *rna_extension(const RnaAsset *asset, const char *name, size_t *size) {
    const Json *data = asset && name && asset->extensions ? member(asset->extensions, name) : NULL;
    if (size) *size = data ? data->text.size : 0;
    return data ? (const char *)data->text.at : NULL;
}

const void *rna_entry(const RnaAsset *asset, const char *name, size_t *size) {
    const Entry *entry = asset && name ? find_entry(asset->zip, (Span){(const uint8_t *)name, strlen(name)}) : NULL;
    const Span data = entry ? entry_data(asset->zip, entry) : (Span){0};
    if (size) *size = data.size;
    return data.at;
}

const char *rna_status_text(RnaStatus status) {
    switch (status) {
    case RNA_OK: return "done";
    case RNA_BAD_ARGUMENT: return "an array is missing, or the tier, part or image does not exist";
    default: return "out of memory";
    }
}
