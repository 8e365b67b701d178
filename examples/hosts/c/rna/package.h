/* A package, checked and read into an RnaAsset. */
#ifndef RNA_PACKAGE_H
#define RNA_PACKAGE_H

#include "asset.h"
#include "base_color.h"
#include "curves.h"
#include "decoder_load.h"
#include "manifest.h"
#include "mesh.h"
#include "normal_maps.h"
#include "transmittance.h"

/* The entry that a reference names; NULL where it is not as declared. */
static const Entry *intact_entry(Container *zip, const Json *object, const char *name) {
    const Entry *entry = find_entry(zip, member(object, name)->string);
    return entry && entry->intact ? entry : NULL;
}

static bool same_entry(Span a, Span b) { return a.at == b.at && a.size == b.size; }

/* ------------------------------------------------------------------- Geometry */

static void warn_outside(const RnaPart *part, const float low[3], const float high[3], RnaReport *report) {
    for (int k = 0; k < 3; k++) {
        double slack = 1e-4 * ((double)part->high[k] - part->low[k]);
        if (low[k] >= part->low[k] - slack && high[k] <= part->high[k] + slack) continue;
        warn(report, "GEOMETRY_OUTSIDE", part->name, "geometry inside the bounds", "%g to %g along %c",
             low[k], high[k], "xyz"[k]);
        return;
    }
}

/* Takes the geometry from an earlier part of the same kind and entry, so that a file cannot make a
 * reader restore one entry many times; false where there is none. */
static bool share_geometry(RnaAsset *asset, Part *part, Span data) {
    for (Part *other = asset->part; other < part; other++)
        if (same_entry(other->geometry, data) && other->public.kind == part->public.kind) {
            part->mesh = other->mesh;
            part->curves = other->curves;
            return true;
        }
    return false;
}

static void read_geometry(const Entry *entry, Span data, RnaAsset *asset, Part *part, RnaReport *report) {
    RnaPart *public = &part->public;
    const bool is_mesh = public->kind == RNA_SURFACE;
    if (!share_geometry(asset, part, data)) {
        bool good = is_mesh ? read_mesh(data, &part->mesh, &part->restored, entry->name, report)
                            : read_curves(data, &part->curves, &part->restored, entry->name, report);
        if (!good) return;
    }
    part->geometry = data;
    float low[3], high[3];
    if (is_mesh) {
        public->mesh = &part->mesh;
        box_around(part->mesh.positions, NULL, part->mesh.vertex_count, low, high);
    } else {
        public->curves = &part->curves;
        box_around(part->curves.points, part->curves.radii, part->curves.point_count, low, high);
    }
    warn_outside(public, low, high, report);
}

static void read_transmittance(Container *zip, const Json *json, Part *part, RnaReport *report) {
    const Json *list = member(json, "transmittance");
    for (const Json *item = list ? list->first : NULL; item; item = item->next) {
        int i = part->public.record_count++;
        RnaTransmittance *record = &part->records[i];
        *record = record_of(item);
        const Entry *entry = intact_entry(zip, item, "texture");
        bool good = entry && read_texture(entry_data(zip, entry), record, entry->name, report);
        uint64_t start = i ? (uint64_t)record[-1].first + record[-1].count : 0;
        if (!part->public.mesh || !check_range((Range){record->first, record->count}, start, &part->mesh,
                                               "TRANSMITTANCE_RANGE", part->public.name, report))
            return;
        if (good) check_coordinates(record, &part->mesh, part->public.name, report);
    }
    if (list) part->public.records = part->records;
}

static void read_normal_maps(Container *zip, const Json *json, Part *part, RnaReport *report) {
    const Json *list = member(json, "normalMaps");
    uint64_t start = 0;
    if (list && part->public.mesh && !part->mesh.uvs)
        refuse(report, "NORMAL_MAP_UV", part->public.name, "a mesh with TEXCOORD_0", "none");
    for (const Json *item = list ? list->first : NULL; item; item = item->next) {
        RnaNormalMap *map = &part->maps[part->public.normal_map_count++];
        const Range range = range_of(item);
        const Entry *entry = intact_entry(zip, item, "texture");
        map->first = range.first;
        map->count = range.count;
        if (entry)
            read_texels(entry_data(zip, entry), "normals", 2, 2, "NORMAL_MAP_TEXTURE", entry->name,
                        &map->texture, report);
        if (!part->public.mesh ||
            !check_range(range, start, &part->mesh, "NORMAL_MAP_RANGE", part->public.name, report))
            return;
        start = (uint64_t)range.first + range.count;
    }
    if (list) part->public.normal_maps = part->maps;
}

static void read_base_colors(Container *zip, const Json *json, Part *part, RnaReport *report) {
    const Json *list = member(json, "baseColor");
    uint64_t start = 0;
    bool any = false; /* images */
    for (const Json *item = list ? list->first : NULL; item; item = item->next) {
        RnaBaseColor *record = &part->colors[part->public.base_color_count++];
        *record = base_color_of(item);
        const bool pictured = member(item, "image") != NULL;
        const Entry *entry = pictured ? intact_entry(zip, item, "image") : NULL;
        ImageSize size;
        if (entry && read_image_size(entry_data(zip, entry), entry->name, &size, report)) {
            record->file = entry_data(zip, entry).at;
            record->file_size = entry->size;
            record->width = size.width;
            record->height = size.height;
        }
        if (!part->public.mesh || !check_range((Range){record->first, record->count}, start, &part->mesh,
                                               "BASE_COLOR_RANGE", part->public.name, report))
            return;
        start = (uint64_t)record->first + record->count;
        any |= pictured;
    }
    if (any && !part->mesh.uvs)
        refuse(report, "BASE_COLOR_UV", part->public.name, "a mesh with TEXCOORD_0", "none");
    if (list) part->public.base_colors = part->colors;
}

static void read_part(Container *zip, const Json *json, RnaAsset *asset, RnaReport *report) {
    Part *part = &asset->part[asset->parts++];
    RnaPart *public = &part->public;
    const Json *bounds = member(json, "bounds");
    const Json *low = member(bounds, "min")->first, *high = member(bounds, "max")->first;
    public->name = (const char *)member(json, "name")->string.at;
    public->kind = is_string(member(json, "kind"), "fiber") ? RNA_FIBER : RNA_SURFACE;
    for (int k = 0; k < 3; k++, low = low->next, high = high->next) {
        public->low[k] = (float)low->number;
        public->high[k] = (float)high->number;
    }
    const Entry *entry = intact_entry(zip, json, "geometry");
    if (entry) read_geometry(entry, entry_data(zip, entry), asset, part, report);
    read_transmittance(zip, json, part, report);
    read_normal_maps(zip, json, part, report);
    read_base_colors(zip, json, part, report);
}

/* ---------------------------------------------------------------------- Tiers */

/* Takes the planes from an earlier tier part that reads the same entry alike. */
static bool share_planes(const RnaAsset *asset, TierPart *part, Span data) {
    for (int t = 0; t < asset->tiers; t++)
        for (int i = 0; i < asset->parts; i++) {
            const TierPart *other = &asset->tier[t].part[i];
            const Planes *a = &other->planes, *b = &part->planes;
            if (!same_entry(other->planes_entry, data) || a->resolution != b->resolution ||
                a->channels != b->channels || a->precision != b->precision)
                continue;
            part->planes = *a;
            return true;
        }
    return false;
}

static void read_part_planes(Container *zip, const Json *json, const RnaAsset *asset, TierPart *part,
                             RnaReport *report) {
    const Json *precision = member(json, "planePrecision");
    part->planes.resolution = (int)member(json, "resolution")->number;
    part->planes.channels = (int)member(json, "channels")->number;
    part->planes.precision = is_string(precision, "int8")      ? INT8
                             : is_string(precision, "float16") ? FLOAT16
                                                               : FLOAT32;
    const Entry *entry = intact_entry(zip, json, "planes");
    if (!entry) return;
    Span data = entry_data(zip, entry);
    if (share_planes(asset, part, data) || read_planes(data, &part->planes, entry->name, report))
        part->planes_entry = data;
}

/* The decoder in the entry, loaded now or for an earlier tier part. */
static const Decoder *load_decoder(RnaAsset *asset, Span data, const Interface *interface,
                                   const char *name, RnaReport *report) {
    for (const Loaded *other = asset->decoders; other; other = other->next)
        if (same_entry(other->entry, data) && other->columns == interface->columns &&
            other->is_int8 == interface->is_int8 && other->outputs == interface->outputs &&
            strcmp(other->output, interface->output) == 0)
            return &other->decoder;
    Loaded *loaded = calloc(1, sizeof *loaded);
    if (!loaded) {
        refuse(report, "FILE_UNREADABLE", name, "memory for it", "not enough");
        return NULL;
    }
    *loaded = (Loaded){asset->decoders,   data, interface->columns, interface->is_int8, interface->outputs,
                       interface->output};
    asset->decoders = loaded;
    read_decoder(data, interface, &loaded->decoder, name, report);
    return &loaded->decoder;
}

static int place_blocks(int column[BLOCKS], const Json *inputs, int channels) {
    int width = 0;
    for (int block = 0; block < BLOCKS; block++) column[block] = -1;
    for (const Json *name = inputs->first; name; name = name->next) {
        int block = block_of(name->string);
        column[block] = width;
        width += BLOCK_TABLE[block].width ? BLOCK_TABLE[block].width : channels;
    }
    return width;
}

/* output: name of the decoder's form; outputs: its columns. */
static void read_network(Container *zip, const Json *json, RnaAsset *asset, int channels, const char *output,
                         int outputs, Network *network, RnaReport *report) {
    Interface interface = {.columns = place_blocks(network->column, member(json, "inputs"), channels),
                           .is_int8 = is_string(member(json, "decoderPrecision"), "int8"),
                           .outputs = outputs,
                           .output = output};
    const Entry *entry = intact_entry(zip, json, "decoder");
    if (entry) network->decoder = load_decoder(asset, entry_data(zip, entry), &interface, entry->name, report);
}

static void read_nearby(const Json *json, TierPart *part) {
    static const char *const cases[] = {"visible", "shadowed"};
    const Json *length = member(json, "lengths")->first;
    for (int k = 0; length; length = length->next) part->nearby_lengths[k++] = length->number;
    for (int i = 0; i < 2; i++) {
        const Json *mean = member(json, cases[i])->first;
        for (int k = 0; mean; mean = mean->next) part->nearby_means[i][k++] = (float)mean->number;
    }
}

static void read_networks(Container *zip, const Json *json, RnaAsset *asset, TierPart *part, RnaReport *report) {
    const Json *shadowed = member(json, "shadowed"), *emission = member(json, "emission");
    const int channels = part->planes.channels;
    part->uses_base_color = is_true(member(json, "usesBaseColor"));
    const Json *nearby = member(json, "nearby");
    part->counts_nearby = nearby != NULL;
    if (nearby) read_nearby(nearby, part);
    /* Of a result and, with base colour, its factor; with nearby light of it and of each length. */
    const int colours = (part->uses_base_color ? 6 : 3) * (nearby ? 4 : 1);
    if (shadowed) {
        read_network(zip, json, asset, channels, "visible", colours, &part->transport, report);
        read_network(zip, shadowed, asset, channels, "shadowed", colours, &part->shadowed, report);
    } else {
        read_network(zip, json, asset, channels, "transport", 2 * colours, &part->transport, report);
    }
    if (emission) read_network(zip, emission, asset, channels, "emission", 3, &part->emission, report);
}

static double measured(const Json *tier, const char *object, const char *name) {
    const Json *value = member(member(tier, object), name);
    return value ? value->number : -1;
}

static void read_tier(Container *zip, const Json *json, RnaAsset *asset, RnaReport *report) {
    Tier *tier = &asset->tier[asset->tiers];
    int i = 0;
    tier->public = (RnaTier){.name = (const char *)member(json, "name")->string.at,
                             .is_int8 = true,
                             .multiply_adds = measured(json, "cost", "multiplyAdds"),
                             .flip = measured(json, "validation", "flip")};
    const Json *validation = member(json, "validation");
    const bool known = validation && validation->type != JSON_NULL;
    tier->validation = known ? validation : NULL;
    tier->public.psnr = known ? member(validation, "psnr")->number : NAN;
    for (const Json *of = member(json, "parts")->first; of; of = of->next, i++) {
        TierPart *part = &tier->part[i];
        read_part_planes(zip, of, asset, part, report);
        read_networks(zip, of, asset, part, report);
        asset->part[i].public.emits = member(of, "emission") != NULL;
        tier->public.is_int8 &= is_string(member(of, "decoderPrecision"), "int8");
    }
    asset->tiers++;
}

static void read_package(Container *zip, RnaAsset *asset, RnaReport *report) {
    if (!read_container(zip, report) || !check_crc(zip, &zip->entries[0], report)) return;
    const Json *root = read_manifest(entry_data(zip, &zip->entries[0]), &asset->manifest, report);
    if (!root) return;
    check_entries(zip, root, report);
    asset->domain = member(root, "domain");
    asset->extensions = member(root, "extensions");
    for (const Json *part = member(root, "parts")->first; part; part = part->next)
        read_part(zip, part, asset, report);
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        read_tier(zip, tier, asset, report);
}

static void free_package(RnaAsset *asset) {
    for (int i = 0; i < asset->parts; i++) {
        free(asset->part[i].restored);
        for (int k = 0; k < MAX_RECORDS; k++) free(asset->part[i].images[k]);
    }
    for (Loaded *loaded = asset->decoders, *next; loaded; loaded = next) {
        next = loaded->next;
        free_decoder(&loaded->decoder);
        free(loaded);
    }
    free_json(&asset->manifest);
#ifdef RNA_EXACT_ENTRIES
    for (int i = 0; i < MAX_ENTRIES; i++) free(asset->zip->entries[i].copy);
#endif
    free(asset->zip);
}

#endif
