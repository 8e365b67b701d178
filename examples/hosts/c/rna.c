/* RNA packages in C; rna.h says what it offers.  One translation unit: compile this file; the files in
 * rna/ are parts of it, one concept each, and all their names are static.
 *
 * Nothing read from a package is trusted before it was compared with the bytes that are there. */
#define _POSIX_C_SOURCE 200809L
#include "rna.h"

#include "rna/blocks.h"
#include "rna/curves.h"
#include "rna/decoder_load.h"
#include "rna/manifest.h"
#include "rna/mesh.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

static int place_blocks(Tier *tier, const Json *inputs) {
    int width = 0;
    for (int block = 0; block < BLOCKS; block++) tier->column[block] = -1;
    for (const Json *name = inputs->first; name; name = name->next) {
        int block = block_of(name->string);
        tier->column[block] = width;
        width += BLOCK_TABLE[block].width ? BLOCK_TABLE[block].width : tier->planes.channels;
    }
    return width;
}

static double measured(const Json *tier, const char *object, const char *name) {
    const Json *value = member(member(tier, object), name);
    return value ? value->number : -1;
}

static void read_tier(Container *zip, const Json *record, Tier *tier, RnaReport *report) {
    const Json *precision = member(record, "planePrecision");
    Span planes = member(record, "planes")->string, decoder = member(record, "decoder")->string;
    tier->public.name = (const char *)member(record, "name")->string.at;
    tier->public.is_int8 = is_string(member(record, "decoderPrecision"), "int8");
    tier->public.multiply_adds = measured(record, "cost", "multiplyAdds");
    tier->public.flip = measured(record, "validation", "flip");
    tier->planes.resolution = (int)member(record, "resolution")->number;
    tier->planes.channels = (int)member(record, "channels")->number;
    tier->planes.precision = is_string(precision, "int8")      ? INT8
                             : is_string(precision, "float16") ? FLOAT16
                                                               : FLOAT32;
    int columns = place_blocks(tier, member(record, "inputs"));
    const Entry *entry = find_entry(zip, planes);
    if (entry && entry->intact) read_planes(entry_data(zip, entry), &tier->planes, entry->name, report);
    entry = find_entry(zip, decoder);
    if (entry && entry->intact)
        read_decoder(entry_data(zip, entry), columns, tier->public.is_int8, &tier->decoder, entry->name,
                     report);
    tier->public.runs = tier->decoder.runs;
}

static void warn_outside(const RnaAsset *asset, const float low[3], const float high[3], RnaReport *report) {
    for (int k = 0; k < 3; k++) {
        double slack = 1e-4 * ((double)asset->high[k] - asset->low[k]);
        if (low[k] >= asset->low[k] - slack && high[k] <= asset->high[k] + slack) continue;
        warn(report, "GEOMETRY_OUTSIDE", "/bounds", "geometry inside", "%g to %g along %c", low[k], high[k],
             "xyz"[k]);
        return;
    }
}

static void read_geometry(Container *zip, const Json *root, RnaAsset *asset, RnaReport *report) {
    const Json *bounds = member(root, "bounds");
    const Json *low = member(bounds, "min")->first, *high = member(bounds, "max")->first;
    for (int k = 0; k < 3; k++, low = low->next, high = high->next) {
        asset->low[k] = (float)low->number;
        asset->high[k] = (float)high->number;
    }
    const Entry *entry = find_entry(zip, member(root, "geometry")->string);
    if (!entry || !entry->intact) return;
    float corner[2][3];
    if (asset->kind == RNA_SURFACE) {
        if (!read_mesh(entry_data(zip, entry), &asset->mesh, entry->name, report)) return;
        box_around(asset->mesh.positions, NULL, asset->mesh.vertex_count, corner[0], corner[1]);
    } else {
        if (!read_curves(entry_data(zip, entry), &asset->curves, entry->name, report)) return;
        box_around(asset->curves.points, asset->curves.radii, asset->curves.point_count, corner[0],
                   corner[1]);
    }
    warn_outside(asset, corner[0], corner[1], report);
}

static void read_package(Container *zip, RnaAsset *asset, RnaReport *report) {
    if (!read_container(zip, report) || !check_crc(zip, &zip->entries[0], report)) return;
    const Json *root = read_manifest(entry_data(zip, &zip->entries[0]), &asset->manifest, report);
    if (!root) return;
    asset->kind = is_string(member(root, "kind"), "fiber") ? RNA_FIBER : RNA_SURFACE;
    check_entries(zip, root, report);
    read_geometry(zip, root, asset, report);
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        read_tier(zip, tier, &asset->tier[asset->tiers++], report);
}

static RnaAsset *open_span(Span file, bool mapped, RnaReport *report) {
    RnaAsset *asset = calloc(1, sizeof *asset);
    Container *zip = calloc(1, sizeof *zip);
    if (asset && zip) {
        asset->file = zip->file = file;
        asset->mapped = mapped;
        read_package(zip, asset, report);
    } else {
        refuse(report, "FILE_UNREADABLE", "byte 0", "memory for it", "not enough");
        if (mapped) munmap((void *)(uintptr_t)file.at, file.size);
    }
    free(zip);
    if (report->errors == 0) return asset;
    rna_close(asset);
    return NULL;
}

RnaAsset *rna_open_memory(const void *data, size_t size, RnaReport *report) {
    memset(report, 0, sizeof *report);
    if ((uintptr_t)data % ALIGNMENT == 0) return open_span((Span){data, size}, false, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "an address that is a multiple of 64", "%p", data);
    return NULL;
}

RnaAsset *rna_open(const char *path, RnaReport *report) {
    memset(report, 0, sizeof *report);
    struct stat status;
    int file = open(path, O_RDONLY);
    bool good = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    size_t size = good ? (size_t)status.st_size : 0;
    void *data = NULL;
    if (good && size > 0 && size < UINT32_MAX) {
        data = mmap(NULL, size, PROT_READ, MAP_PRIVATE, file, 0);
        good = data != MAP_FAILED;
    }
    if (file >= 0) close(file);
    if (good) return open_span((Span){data, size}, data != NULL, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "a readable file", "%s", path);
    return NULL;
}

void rna_close(RnaAsset *asset) {
    if (!asset) return;
    for (int i = 0; i < asset->tiers; i++) free_decoder(&asset->tier[i].decoder);
    free_json(&asset->manifest);
    if (asset->mapped) munmap((void *)(uintptr_t)asset->file.at, asset->file.size);
    free(asset);
}

RnaKind rna_kind(const RnaAsset *asset) { return asset->kind; }

void rna_bounds(const RnaAsset *asset, float low[3], float high[3]) {
    memcpy(low, asset->low, sizeof asset->low);
    memcpy(high, asset->high, sizeof asset->high);
}

const RnaMesh *rna_mesh(const RnaAsset *asset) {
    return asset->kind == RNA_SURFACE ? &asset->mesh : NULL;
}

const RnaCurves *rna_curves(const RnaAsset *asset) {
    return asset->kind == RNA_FIBER ? &asset->curves : NULL;
}

int rna_tier_count(const RnaAsset *asset) { return asset->tiers; }

int rna_tier_index(const RnaAsset *asset, const char *name) {
    for (int i = 0; i < asset->tiers; i++)
        if (strcmp(asset->tier[i].public.name, name) == 0) return i;
    return -1;
}

const RnaTier *rna_tier(const RnaAsset *asset, int tier) {
    return tier >= 0 && tier < asset->tiers ? &asset->tier[tier].public : NULL;
}

static float light(float value, bool valid) {
    return valid && value > 0 ? (value < FLT_MAX ? value : FLT_MAX) : 0; /* 0 for NaN */
}

RnaStatus rna_evaluate(const RnaAsset *asset, int tier_index, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       float *visible, float *shadowed) {
    if (!asset || !rna_tier(asset, tier_index)) return RNA_BAD_ARGUMENT;
    const Tier *tier = &asset->tier[tier_index];
    if (!tier->decoder.runs) return RNA_UNSUPPORTED_DECODER;
    if (n == 0) return RNA_OK;
    if (!positions || !axes || !wo || !wi || !visible || !shadowed || (asset->kind == RNA_FIBER && !h))
        return RNA_BAD_ARGUMENT;
    size_t size = sizeof(float) * ROWS * (size_t)rounded_up(tier->decoder.widest, OUTPUTS);
    size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    float *buffers = aligned(2 * size);
    if (!buffers) return RNA_OUT_OF_MEMORY;
    const Batch batch = {n, positions, axes, h, wo, wi};
    Points points;
    for (size_t first = 0; first < n; first += ROWS) {
        int count = (int)(n - first < ROWS ? n - first : ROWS);
        load_points(asset, &batch, first, count, &points);
        fill_queries(asset, tier, &points, buffers);
        const float *transport = run_decoder(&tier->decoder, buffers, buffers + size / sizeof(float));
        for (size_t r = 0; r < (size_t)count; r++)
            for (size_t k = 0; k < 3; k++) {
                visible[3 * (first + r) + k] = light(transport[k * ROWS + r], points.valid[r]);
                shadowed[3 * (first + r) + k] = light(transport[(k + 3) * ROWS + r], points.valid[r]);
            }
    }
    free(buffers);
    return RNA_OK;
}

const char *rna_status_text(RnaStatus status) {
    switch (status) {
    case RNA_OK: return "done";
    case RNA_BAD_ARGUMENT: return "an array is missing, or the tier does not exist";
    case RNA_UNSUPPORTED_DECODER: return "the decoder is no chain of the decoder profile: it needs an ONNX engine";
    default: return "out of memory";
    }
}
