/* RNA packages in C; rna.h says what it offers.  One translation unit: compile this file; the files in
 * rna/ are parts of it, one concept each, and all their names are static.
 *
 * Nothing read from a package is trusted before it was compared with the bytes that are there. */
#define _POSIX_C_SOURCE 200809L /* for S_ISREG */
#include "rna.h"

#if defined(__GNUC__) /* tables leave out members that are 0 */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif

#include "rna/blocks.h"
#include "rna/package.h"

#include <sys/stat.h>

#ifndef S_ISREG
#define S_ISREG(mode) (((mode) & _S_IFMT) == _S_IFREG)
#endif

/* own: what is freed with the asset, or NULL. */
static RnaAsset *open_span(Span file, void *own, RnaReport *report) {
    RnaAsset *asset = calloc(1, sizeof *asset);
    Container *zip = calloc(1, sizeof *zip);
    if (asset && zip) {
        asset->file = zip->file = file;
        asset->own = own;
        read_package(zip, asset, report);
    } else {
        refuse(report, "FILE_UNREADABLE", "byte 0", "memory for it", "not enough");
        free(asset);
        asset = NULL;
        free_aligned(own);
    }
#ifdef RNA_EXACT_ENTRIES
    if (asset && zip) {
        asset->zip = zip;
        zip = NULL;
    }
#endif
    free(zip);
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
    void *own = NULL;
    if (good && size > 0 && size < UINT32_MAX) { /* others are refused for their size */
        own = bytes_of(path, size);
        good = own != NULL;
    }
    if (good) return open_span((Span){own, size}, own, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "a readable file", "%s", path ? path : "no path");
    return NULL;
}

void rna_close(RnaAsset *asset) {
    if (!asset) return;
    free_package(asset);
    free_aligned(asset->own);
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

/* Runs a network of the part on all rows.  colours: one or two arrays of n x 3, for its outputs. */
static RnaStatus run_network(const RnaAsset *asset, int tier, int part, bool emission, const Batch *batch,
                             float *const *colours, int count) {
    const RnaPart *of = rna_part(asset, part);
    if (!of || !rna_tier(asset, tier)) return RNA_BAD_ARGUMENT;
    if (batch->n == 0) return RNA_OK;
    if (!batch->positions || !batch->axes || !batch->wo || !batch->wi || !colours[0] || !colours[count - 1] ||
        (of->kind == RNA_FIBER && !batch->h))
        return RNA_BAD_ARGUMENT;
    const TierPart *with = &asset->tier[tier].part[part];
    const Network *network = emission ? &with->emission : &with->transport;
    if (!network->decoder) { /* the part does not emit */
        memset(colours[0], 0, 3 * batch->n * sizeof *colours[0]);
        return RNA_OK;
    }
    size_t size = (size_t)ROWS * (size_t)rounded_up(network->decoder->widest, ALIGNMENT);
    float *buffers = aligned(2 * size * sizeof *buffers);
    if (!buffers) return RNA_OUT_OF_MEMORY;
    Points points;
    for (size_t first = 0; first < batch->n; first += ROWS) {
        int rows = (int)(batch->n - first < ROWS ? batch->n - first : ROWS);
        load_points(of, batch, first, rows, &points);
        fill_queries(of->kind, &with->planes, network->column, &points, buffers);
        const float *results = run_decoder(network->decoder, buffers, buffers + size);
        for (size_t i = 0; i < (size_t)count; i++)
            for (size_t r = 0; r < (size_t)rows; r++)
                for (size_t k = 0; k < 3; k++)
                    colours[i][3 * (first + r) + k] = light(results[(3 * i + k) * ROWS + r], points.valid[r]);
    }
    free_aligned(buffers);
    return RNA_OK;
}

RnaStatus rna_evaluate(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       float *visible, float *shadowed) {
    const Batch batch = {n, positions, axes, h, wo, wi};
    return run_network(asset, tier, part, false, &batch, (float *const[]){visible, shadowed}, 2);
}

RnaStatus rna_emission(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, float *emission) {
    const Batch batch = {n, positions, axes, h, wo, .wi = wo}; /* which no block of emission uses */
    return run_network(asset, tier, part, true, &batch, &emission, 1);
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

const char *rna_status_text(RnaStatus status) {
    switch (status) {
    case RNA_OK: return "done";
    case RNA_BAD_ARGUMENT: return "an array is missing, or the tier or part does not exist";
    default: return "out of memory";
    }
}
