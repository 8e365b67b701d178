/* The package in a binary glTF (spec/RNA_relightable_asset.md). */
#ifndef RNA_CARRIER_H
#define RNA_CARRIER_H

#include "json.h"

enum { GLB_HEADER = 12, GLB_CHUNK = 8, MAX_CARRIER_JSON = 1 << 23 };

static const char EXTENSION[] = "RNA_relightable_asset";

/* The chunk at `start` of the file; an empty span behind the file's end, and NULL in it after an issue. */
static Span glb_chunk(Span file, size_t start, const char *kind, RnaReport *report) {
    if (start == file.size && kind[0] == 'B') return (Span){file.at + start, 0};
    size_t left = file.size - start, size = left < GLB_CHUNK ? 0 : u32_at(file.at + start);
    if (left >= GLB_CHUNK && size <= left - GLB_CHUNK && memcmp(file.at + start + 4, kind, 4) == 0)
        return (Span){file.at + start + GLB_CHUNK, size};
    refuse(report, "GLB_CONTAINER", byte_place(start).text, "a chunk inside the file", "%zu bytes", left);
    return (Span){0};
}

/* An item of an array of the document; NULL where there is none. */
static const Json *glb_item(const Json *document, const char *name, const Json *number) {
    const Json *array = member(document, name);
    if (!array || array->type != JSON_ARRAY || !number || !is_integer(number)) return NULL;
    if (number->number < 0 || number->number >= (double)array->count) return NULL;
    const Json *item = array->first;
    for (size_t i = (size_t)number->number; i > 0; i--) item = item->next;
    return item;
}

/* A size in a buffer view; false where it is none. */
static bool glb_size(const Json *value, size_t *size) {
    if (!value || !is_integer(value) || value->number < 0 || value->number > UINT32_MAX) return false;
    *size = (size_t)value->number;
    return true;
}

/* The buffer view that all carrying nodes name; NULL after an issue. */
static const Json *carried_view(const Json *document, RnaReport *report) {
    const Json *nodes = member(document, "nodes"), *named = NULL;
    if (nodes && nodes->type != JSON_ARRAY) {
        refuse(report, "GLB_CONTAINER", "/nodes", "an array", "another type");
        return NULL;
    }
    for (const Json *node = nodes ? nodes->first : NULL; node; node = node->next) {
        const Json *record = member(member(node, "extensions"), EXTENSION);
        if (!record || record->type == JSON_NULL) continue;
        const Json *view = member(record, "package");
        if (!is_string(member(record, "mimeType"), "model/vnd.rna") || !view || !is_integer(view)) {
            refuse(report, "GLB_PACKAGE", "/nodes", "a buffer view of model/vnd.rna", "another record");
            return NULL;
        }
        if (named && named->number != view->number) {
            refuse(report, "GLB_SEVERAL", "/nodes", "one package", "several");
            return NULL;
        }
        named = view;
    }
    if (!named) refuse(report, "GLB_NO_PACKAGE", "/nodes", "a node with RNA_relightable_asset", "none");
    const Json *view = named ? glb_item(document, "bufferViews", named) : NULL;
    if (named && !view) refuse(report, "GLB_PACKAGE", "/bufferViews", "one that exists", "%g", named->number);
    return view;
}

/* The package's bytes, by the document; an empty span after an issue. */
static Span carried_bytes(Span file, Span blob, const Json *document, RnaReport *report) {
    static const Json FIRST = {.type = JSON_NUMBER};
    const Json *view = carried_view(document, report), *buffer = glb_item(document, "buffers", &FIRST);
    if (!view) return (Span){0};
    size_t of = 1, start = 0, size = 0;
    bool good = glb_size(member(view, "buffer"), &of) && of == 0 && buffer && !member(buffer, "uri");
    good = good && (!member(view, "byteOffset") || glb_size(member(view, "byteOffset"), &start));
    good = good && glb_size(member(view, "byteLength"), &size) && size && start <= blob.size && size <= blob.size - start;
    size_t place = (size_t)(blob.at - file.at) + start;
    if (!good) {
        refuse(report, "GLB_PACKAGE", "/bufferViews", "bytes inside the binary chunk", "%zu at %zu of %zu", size,
               start, blob.size);
    } else if (place % ALIGNMENT) {
        refuse(report, "GLB_ALIGNMENT", "/bufferViews", "a multiple of 64", "byte %zu of the file", place);
    } else {
        return (Span){file.at + place, size};
    }
    return (Span){0};
}

static bool is_glb(Span file) { return file.size >= 4 && memcmp(file.at, "glTF", 4) == 0; }

/* The package of a .glb, in place; an empty span after an issue. */
static Span find_package(Span file, RnaReport *report) {
    if (file.size < GLB_HEADER + GLB_CHUNK || u32_at(file.at + 4) != 2 || u32_at(file.at + 8) != file.size) {
        refuse(report, "GLB_CONTAINER", "byte 0", "version 2, as long as the file", "another header");
        return (Span){0};
    }
    Span json = glb_chunk(file, GLB_HEADER, "JSON", report);
    if (!json.at) return json;
    if (json.size > MAX_CARRIER_JSON) {
        refuse(report, "GLB_CONTAINER", "byte 12", "at most 8 MiB of JSON", "%zu bytes", json.size);
        return (Span){0};
    }
    Span blob = glb_chunk(file, GLB_HEADER + GLB_CHUNK + json.size, "BIN", report);
    if (!blob.at) return blob;
    JsonText text;
    const Json *document = parse_json(json, "JSON chunk", "GLB_CONTAINER", &text, report);
    Span package = document ? carried_bytes(file, blob, document, report) : (Span){0};
    free_json(&text);
    return package;
}

#endif
