/* The manifest: read, compared with itself and with the archive. */
#ifndef RNA_MANIFEST_H
#define RNA_MANIFEST_H

#include "container.h"
#include "manifest_rules.h"

/* Of one part in short, the manifest is the part, and each tier its tier part. */
static bool is_short(const Json *root) { return !member(root, "parts"); }

static const Json *first_part(const Json *root) {
    return is_short(root) ? root : member(root, "parts")->first;
}

static const Json *first_tier_part(const Json *root, const Json *tier) {
    return is_short(root) ? tier : member(tier, "parts")->first;
}

/* The part behind this one; NULL behind the last. */
static const Json *next_part(const Json *root, const Json *part) { return is_short(root) ? NULL : part->next; }

/* Whether the version in the manifest is a later one. */
static bool is_newer(const Json *version, long major, long minor) {
    long its_major, its_minor;
    if (!take_version(version->string, &its_major, &its_minor)) return false;
    return its_major > major || (its_major == major && its_minor > minor);
}

static bool kind_is_known(const Json *object, const char *where, RnaReport *report) {
    const Json *kind = member(object, "kind");
    return !kind || is_string(kind, "surface") || is_string(kind, "fiber") ||
           refuse(report, "KIND_UNSUPPORTED", where, "surface or fiber", "something else");
}

/* What must hold before the members of this version mean anything. */
static bool manifest_is_readable(const Json *root, RnaReport *report) {
    if (!is_string(member(root, "format"), "rna"))
        return refuse(report, "FORMAT_UNKNOWN", "/format", "\"rna\"", "something else");
    const Json *version = member(root, "minReaderVersion"), *parts = member(root, "parts");
    if (version && version->type == JSON_STRING && is_version(version->string) && is_newer(version, 1, 1))
        return refuse(report, "VERSION_TOO_NEW", "/minReaderVersion", "at most 1.1", "%s",
                      (const char *)version->string.at);
    if (!parts && !kind_is_known(root, "/kind", report)) return false;
    if (parts && parts->type == JSON_ARRAY)
        for (const Json *part = parts->first; part; part = part->next)
            if (!kind_is_known(part, "/parts", report)) return false;
    const Json *required = member(root, "extensionsRequired");
    if (required && required->type == JSON_ARRAY)
        for (const Json *name = required->first; name; name = name->next)
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

/* Paths in the manifest. */
typedef struct Reference {
    Span path;
    char where[64];
} Reference;

enum { MAX_REFERENCES = RNA_MAX_PARTS * (1 + 2 * MAX_RECORDS) + 3 * MAX_TIERS * RNA_MAX_PARTS };

typedef struct References {
    int count;
    Reference at[MAX_REFERENCES];
} References;

/* The member `name` of `object`, which stands at `place`. */
static void add_reference(References *list, const Json *object, const char *place, const char *name) {
    Reference *reference = &list->at[list->count++];
    snprintf(reference->where, sizeof reference->where, "%s/%s", place, name);
    reference->path = member(object, name)->string;
}

/* The textures of the part's member `name`, a list of records. */
static void collect_textures(const Json *part, const char *place, const char *name, References *list) {
    const Json *records = member(part, name);
    int i = 0;
    for (const Json *record = records ? records->first : NULL; record; record = record->next) {
        char where[48];
        snprintf(where, sizeof where, "%.16s/%s/%d", place, name, i++);
        add_reference(list, record, where, "texture");
    }
}

static void collect_of_part(const Json *part, const char *place, References *list) {
    add_reference(list, part, place, "geometry");
    collect_textures(part, place, "transmittance", list);
    collect_textures(part, place, "normalMaps", list);
}

static void collect_of_tier_part(const Json *part, const char *place, References *list) {
    const Json *emission = member(part, "emission");
    char where[48];
    add_reference(list, part, place, "planes");
    add_reference(list, part, place, "decoder");
    snprintf(where, sizeof where, "%.24s/emission", place);
    if (emission) add_reference(list, emission, where, "decoder");
}

static void collect_references(const Json *root, References *list) {
    const bool flat = is_short(root);
    char place[32] = "";
    int i = 0, t = 0;
    for (const Json *part = first_part(root); part; part = next_part(root, part)) {
        if (!flat) snprintf(place, sizeof place, "/parts/%d", i++);
        collect_of_part(part, place, list);
    }
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next, t++) {
        i = 0;
        for (const Json *part = first_tier_part(root, tier); part; part = next_part(root, part)) {
            int size = snprintf(place, sizeof place, "/tiers/%d", t);
            if (!flat) snprintf(place + size, sizeof place - (size_t)size, "/parts/%d", i++);
            collect_of_tier_part(part, place, list);
        }
    }
}

/* Paths name declared entries, and declared entries are named by a path. */
static void check_references(const Json *root, const References *list, RnaReport *report) {
    const Json *entries = member(root, "entries");
    for (int i = 0; i < list->count; i++) {
        const Json *entry = entries->first;
        while (entry && !same_span(entry->key, list->at[i].path)) entry = entry->next;
        if (!entry)
            refuse(report, "REFERENCE_MISSING", list->at[i].where, "a key of /entries", "%s",
                   (const char *)list->at[i].path.at);
    }
    for (const Json *entry = entries->first; entry; entry = entry->next) {
        int i = 0;
        while (i < list->count && !same_span(entry->key, list->at[i].path)) i++;
        if (i == list->count && !is_of_extension(root, entry->key))
            refuse(report, "ENTRY_UNREFERENCED", "/entries", "a path that is used", "%s",
                   (const char *)entry->key.at);
    }
}

static void check_inputs(const Json *decoder, unsigned uses, RnaReport *report) {
    for (const Json *name = member(decoder, "inputs")->first; name; name = name->next)
        if ((BLOCK_TABLE[block_of(name->string)].uses & uses) != uses)
            refuse(report, "INPUT_KIND", "/tiers", "blocks for what the decoder is of", "%s",
                   (const char *)name->string.at);
}

/* Each tier has the parts, and of each part, all tiers emit or none. */
static bool check_tier_parts(const Json *root, RnaReport *report) {
    if (is_short(root)) return true;
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
        const Json *of = first_tier_part(root, tier);
        for (const Json *part = first_part(root); part;
             part = next_part(root, part), of = next_part(root, of)) {
            unsigned kind = is_string(member(part, "kind"), "fiber") ? FOR_FIBER : FOR_SURFACE;
            check_inputs(of, kind, report);
            if (member(of, "emission")) check_inputs(member(of, "emission"), kind | FOR_EMISSION, report);
        }
    }
}

/* What is newer than 1.0 is there by right. */
static bool check_age(const Json *root, const char *what, const char *where, RnaReport *report) {
    const Json *version = member(root, "minReaderVersion");
    return is_newer(version, 1, 0) ||
           refuse(report, "VERSION_TOO_OLD", where, "a minReaderVersion of 1.1 at least", "%s with %s", what,
                  (const char *)version->string.at);
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
    check_members(&schema, is_short(root) ? SHORT_MANIFEST : MANIFEST, root);
    if (schema.issues || !check_tier_parts(root, report)) return NULL;
    int errors = report->errors;
    References *references = calloc(1, sizeof *references);
    if (!references) refuse(report, "FILE_UNREADABLE", "byte 0", "memory for it", "not enough");
    if (!is_short(root)) check_age(root, "parts", "/parts", report);
    check_extensions(root, report);
    check_blocks(root, report);
    if (references) {
        collect_references(root, references);
        check_references(root, references, report);
    }
    free(references);
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
        sha256(entry_data(zip, entry), digest);
        if (!is_string(member(record, "sha256"), digest)) {
            refuse(report, "ENTRY_HASH", where, "the declared SHA-256", "%s", digest);
            continue;
        }
        entry->intact = check_crc(zip, entry, report);
    }
}

#endif
