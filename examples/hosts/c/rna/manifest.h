/* The manifest: read, compared with itself and with the archive. */
#ifndef RNA_MANIFEST_H
#define RNA_MANIFEST_H

#include "container.h"
#include "manifest_rules.h"

/* What must hold before the members of this version mean anything. */
static bool manifest_is_readable(const Json *root, RnaReport *report) {
    if (!is_string(member(root, "format"), "rna"))
        return refuse(report, "FORMAT_UNKNOWN", "/format", "\"rna\"", "something else");
    const Json *version = member(root, "minReaderVersion"), *kind = member(root, "kind");
    if (version && version->type == JSON_STRING && is_version(version->string)) {
        long major, minor;
        take_version(version->string, &major, &minor);
        if (major > 1 || minor > 0)
            return refuse(report, "VERSION_TOO_NEW", "/minReaderVersion", "at most 1.0", "%ld.%ld", major,
                          minor);
    }
    if (kind && !is_string(kind, "surface") && !is_string(kind, "fiber"))
        return refuse(report, "KIND_UNSUPPORTED", "/kind", "surface or fiber", "something else");
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

/* The member `path` of `object`, at `where`, names a declared entry. */
static void check_reference(const Json *root, const Json *object, const char *path,
                            const char *where, RnaReport *report) {
    Span name = member(object, path)->string;
    for (const Json *entry = member(root, "entries")->first; entry; entry = entry->next)
        if (same_span(entry->key, name)) return;
    refuse(report, "REFERENCE_MISSING", where, "a key of /entries", "%s", (const char *)name.at);
}

static bool is_referenced(const Json *root, Span path) {
    if (same_span(member(root, "geometry")->string, path) || is_of_extension(root, path)) return true;
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        if (same_span(member(tier, "planes")->string, path) ||
            same_span(member(tier, "decoder")->string, path))
            return true;
    return false;
}

/* Paths name declared entries, and declared entries are named by a path. */
static void check_references(const Json *root, RnaReport *report) {
    char where[64];
    int i = 0;
    check_reference(root, root, "geometry", "/geometry", report);
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next, i++) {
        snprintf(where, sizeof where, "/tiers/%d/planes", i);
        check_reference(root, tier, "planes", where, report);
        snprintf(where, sizeof where, "/tiers/%d/decoder", i);
        check_reference(root, tier, "decoder", where, report);
    }
    for (const Json *entry = member(root, "entries")->first; entry; entry = entry->next)
        if (!is_referenced(root, entry->key))
            refuse(report, "ENTRY_UNREFERENCED", "/entries", "a path that is used", "%s",
                   (const char *)entry->key.at);
}

static void check_blocks(const Json *root, RnaReport *report) {
    bool is_fiber = is_string(member(root, "kind"), "fiber");
    unsigned kind = is_fiber ? FOR_FIBER : FOR_SURFACE;
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        for (const Json *name = member(tier, "inputs")->first; name; name = name->next)
            if (!(BLOCK_TABLE[block_of(name->string)].kinds & kind))
                refuse(report, "INPUT_KIND", "/tiers", "blocks for this kind of asset", "%s",
                       (const char *)name->string.at);
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
    if (schema.issues) return NULL;
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
        sha256(entry_data(zip, entry), digest);
        if (!is_string(member(record, "sha256"), digest)) {
            refuse(report, "ENTRY_HASH", where, "the declared SHA-256", "%s", digest);
            continue;
        }
        entry->intact = check_crc(zip, entry, report);
    }
}

#endif
