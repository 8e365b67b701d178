/* The manifest: read, compared with itself and with the archive. */
#ifndef RNA_MANIFEST_H
#define RNA_MANIFEST_H

#include "container.h"
#include "manifest_rules.h"

/* The length of [1-9][0-9]{0,3} in the beginning of the text; 0 where it is not there. */
static size_t number_size(Span text) {
    size_t n = 0;
    while (n < text.size && text.at[n] >= '0' && text.at[n] <= '9') n++;
    return n <= 4 && n > 0 && text.at[0] != '0' ? n : 0;
}

static bool is_version(Span text) {
    size_t major = number_size(text);
    if (!major || major == text.size || text.at[major] != '.') return false;
    Span minor = {text.at + major + 1, text.size - major - 1};
    return span_is(minor, "0") || (minor.size && number_size(minor) == minor.size);
}

/* Whether the version is this text's.  Any other string is a wrong value. */
static bool check_version(const Json *version, RnaReport *report) {
    if (!version || version->type != JSON_STRING || !is_version(version->string) || is_string(version, "2.0"))
        return true;
    const char *text = (const char *)version->string.at;
    const char *code = memcmp(text, "1.", 2) ? "VERSION_TOO_NEW" : "VERSION_TOO_OLD";
    return refuse(report, code, "/version", "2.0", "%s", text);
}

/* The checks that come before the members of this version. */
static bool manifest_is_readable(const Json *root, RnaReport *report) {
    if (!is_string(member(root, "format"), "rna"))
        return refuse(report, "FORMAT_UNKNOWN", "/format", "\"rna\"", "something else");
    if (!check_version(member(root, "version"), report)) return false;
    const Json *parts = member(root, "parts"), *required = member(root, "extensionsRequired");
    for (const Json *part = parts ? parts->first : NULL; part; part = part->next) {
        const Json *kind = member(part, "kind");
        if (kind && !is_string(kind, "surface") && !is_string(kind, "fiber"))
            return refuse(report, "KIND_UNSUPPORTED", "/parts", "surface or fiber", "something else");
    }
    for (const Json *name = required ? required->first : NULL; name; name = name->next)
        if (name->type == JSON_STRING)
            return refuse(report, "EXTENSION_REQUIRED", "/extensionsRequired", "a known extension", "%s",
                          (const char *)name->string.at);
    return true;
}

static bool has_string(const Json *list, Span text) {
    for (const Json *item = list ? list->first : NULL; item; item = item->next)
        if (same_span(item->string, text)) return true;
    return false;
}

/* Whether the entry belongs to an extension that is used: extensions/NAME/... */
static bool is_of_extension(const Json *root, Span path) {
    const size_t prefix = strlen("extensions/");
    if (path.size <= prefix || memcmp(path.at, "extensions/", prefix)) return false;
    const uint8_t *slash = memchr(path.at + prefix, '/', path.size - prefix);
    Span name = {path.at + prefix, slash ? (size_t)(slash - path.at) - prefix : 0};
    return slash && has_string(member(root, "extensionsUsed"), name);
}

/* Marks the entry that the member `name` of `object`, which stands at `place`, names. */
static void mark_entry(const Json *root, const Json *object, const char *place, const char *name,
                       RnaReport *report) {
    const Json *path = member(object, name);
    Json *entry = member(root, "entries")->first;
    while (entry && !same_span(entry->key, path->string)) entry = entry->next;
    if (entry) {
        entry->marked = true;
        return;
    }
    char where[64];
    snprintf(where, sizeof where, "%s/%s", place, name);
    refuse(report, "REFERENCE_MISSING", where, "a key of /entries", "%s", (const char *)path->string.at);
}

/* The textures of the part's member `name`, a list of records, which their member `texture` names. */
static void mark_textures(const Json *root, const Json *part, const char *place, const char *name,
                          const char *texture, RnaReport *report) {
    const Json *records = member(part, name);
    char where[48];
    int i = 0;
    for (const Json *record = records ? records->first : NULL; record; record = record->next) {
        snprintf(where, sizeof where, "%.16s/%s/%d", place, name, i++);
        if (member(record, texture)) mark_entry(root, record, where, texture, report);
    }
}

static void mark_of_tier(const Json *root, const Json *tier, int t, RnaReport *report) {
    static const char *const DECODERS[] = {"shadowed", "emission"};
    char place[40], decoder[48];
    int i = 0;
    for (const Json *part = member(tier, "parts")->first; part; part = part->next) {
        snprintf(place, sizeof place, "/tiers/%d/parts/%d", t, i++);
        mark_entry(root, part, place, "planes", report);
        mark_entry(root, part, place, "decoder", report);
        for (int d = 0; d < 2; d++) {
            snprintf(decoder, sizeof decoder, "%.32s/%s", place, DECODERS[d]);
            if (member(part, DECODERS[d])) mark_entry(root, member(part, DECODERS[d]), decoder, "decoder", report);
        }
    }
}

/* Paths name declared entries, and declared entries are named by a path. */
static void check_references(const Json *root, RnaReport *report) {
    char place[24];
    int i = 0, t = 0;
    for (const Json *part = member(root, "parts")->first; part; part = part->next) {
        snprintf(place, sizeof place, "/parts/%d", i++);
        mark_entry(root, part, place, "geometry", report);
        mark_textures(root, part, place, "transmittance", "texture", report);
        mark_textures(root, part, place, "normalMaps", "texture", report);
        mark_textures(root, part, place, "baseColor", "image", report);
    }
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        mark_of_tier(root, tier, t++, report);
    for (const Json *entry = member(root, "entries")->first; entry; entry = entry->next)
        if (!entry->marked && !is_of_extension(root, entry->key))
            refuse(report, "ENTRY_UNREFERENCED", "/entries", "a path that is used", "%s",
                   (const char *)entry->key.at);
}

static void check_inputs(const Json *decoder, unsigned uses, RnaReport *report) {
    for (const Json *name = member(decoder, "inputs")->first; name; name = name->next)
        if ((BLOCK_TABLE[block_of(name->string)].uses & uses) != uses)
            refuse(report, "INPUT_KIND", "/tiers", "blocks for what the decoder is of", "%s",
                   (const char *)name->string.at);
}

/* Each tier has the parts, and of each part, all tiers emit or none. */
static bool check_tier_parts(const Json *root, RnaReport *report) {
    const Json *tiers = member(root, "tiers");
    for (const Json *tier = tiers->first; tier; tier = tier->next) {
        const Json *parts = member(tier, "parts"), *first = member(tiers->first, "parts")->first;
        if (parts->count != member(root, "parts")->count)
            return refuse(report, "PARTS_DIFFER", "/tiers", "a tier part for each part", "%zu", parts->count);
        for (const Json *part = parts->first; part; part = part->next, first = first->next)
            if (!member(part, "emission") != !member(first, "emission"))
                return refuse(report, "PARTS_DIFFER", "/tiers", "the same parts emit in all tiers",
                              "others in %s", (const char *)member(tier, "name")->string.at);
    }
    return true;
}

static void check_blocks(const Json *root, RnaReport *report) {
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next) {
        const Json *of = member(tier, "parts")->first;
        for (const Json *part = member(root, "parts")->first; part; part = part->next, of = of->next) {
            unsigned kind = is_string(member(part, "kind"), "fiber") ? FOR_FIBER : FOR_SURFACE;
            check_inputs(of, kind, report);
            if (member(of, "shadowed")) check_inputs(member(of, "shadowed"), kind, report);
            if (member(of, "emission")) check_inputs(member(of, "emission"), kind | FOR_EMISSION, report);
            if (is_true(member(of, "usesBaseColor")) && !member(part, "baseColor"))
                refuse(report, "FIELD_VALUE", "/tiers", "usesBaseColor of a part with baseColor alone", "true");
        }
    }
}

static void check_extensions(const Json *root, RnaReport *report) {
    const Json *used = member(root, "extensionsUsed"), *data = member(root, "extensions");
    for (const Json *m = data ? data->first : NULL; m; m = m->next)
        if (!has_string(used, m->key))
            refuse(report, "EXTENSION_UNDECLARED", "/extensions", "a name in extensionsUsed", "%s",
                   (const char *)m->key.at);
}

/* The manifest; NULL after an error. */
static const Json *read_manifest(Span data, JsonText *text, RnaReport *report) {
    const Json *root = parse_json(data, "manifest.json", "MANIFEST_NOT_JSON", text, report);
    if (!root || !manifest_is_readable(root, report)) return NULL;
    Schema schema = {report, "FIELD_UNKNOWN", "FIELD_MISSING", "FIELD_VALUE", .only_first = false};
    check_members(&schema, MANIFEST, root);
    if (schema.issues || !check_tier_parts(root, report)) return NULL;
    int errors = report->errors;
    check_extensions(root, report);
    check_blocks(root, report);
    check_references(root, report);
    if (report->errors > errors) return NULL;
    const Json *used = member(root, "extensionsUsed");
    for (const Json *name = used ? used->first : NULL; name; name = name->next)
        warn(report, "EXTENSION_UNKNOWN", "/extensionsUsed", "a known extension", "%s",
             (const char *)name->string.at);
    return root;
}

/* Compares the archive with the manifest; notes which entries are as declared. */
static void check_entries(Container *zip, const Json *root, RnaReport *report) {
    const Json *records = member(root, "entries");
    for (int i = 1; i < zip->count; i++)
        if (!member(records, zip->entries[i].name))
            refuse(report, "ENTRY_UNDECLARED", byte_place(zip->entries[i].header).text,
                   "a declared entry", "%s", zip->entries[i].name);
    for (const Json *record = records->first; record; record = record->next) {
        char where[128], digest[65];
        snprintf(where, sizeof where, "/entries/%.100s", (const char *)record->key.at);
        Entry *entry = find_entry(zip, record->key);
        if (!entry) {
            refuse(report, "ENTRY_MISSING", where, "an entry of the archive", "nothing");
            continue;
        }
        double size = member(record, "size")->number;
        if ((double)entry->size != size) {
            refuse(report, "ENTRY_SIZE", where, "the declared size", "%zu bytes, not %.0f", entry->size,
                   size);
            continue;
        }
        if (!check_crc(zip, entry, report)) continue;
        sha256(entry_data(zip, entry), digest);
        entry->intact = is_string(member(record, "sha256"), digest);
        if (!entry->intact) refuse(report, "ENTRY_HASH", where, "the declared SHA-256", "%s", digest);
    }
}

#endif
