/* Meshes: binary glTF in a profile (section 4.1). */
#ifndef RNA_MESH_H
#define RNA_MESH_H

#include "rules.h"
#include "tensors.h"

enum { GLTF_UINT = 5125, GLTF_FLOAT = 5126 };
#define LARGEST_UINT 4294967295.0

#define INDEX 0, LARGEST_UINT
#define COUNT 1, LARGEST_UINT

static const Rule NODE_NUMBER = {"", INTEGER, 0, 0, 0};
static const Rule GLTF_ASSET[] = {{"version", CHOICE, REQUIRED, .choices = "2.0"},
                                  {"generator", TEXT},
                                  {"copyright", TEXT},
                                  {0}};
static const Rule GLTF_SCENE[] = {{"nodes", LIST, REQUIRED, 1, 1, &NODE_NUMBER}, {"name", TEXT}, {0}};
static const Rule GLTF_NODE[] = {{"mesh", INTEGER, REQUIRED, 0, 0}, {"name", TEXT}, {0}};
static const Rule ATTRIBUTES[] = {{"POSITION", INTEGER, REQUIRED, INDEX},
                                  {"NORMAL", INTEGER, REQUIRED, INDEX},
                                  {"TEXCOORD_0", INTEGER, 0, INDEX},
                                  {0}};
static const Rule PRIMITIVE[] = {{"attributes", OBJECT, REQUIRED, .of = ATTRIBUTES},
                                 {"indices", INTEGER, REQUIRED, INDEX},
                                 {"mode", INTEGER, 0, 4, 4},
                                 {0}};
static const Rule A_PRIMITIVE = {"", OBJECT, .of = PRIMITIVE};
static const Rule GLTF_MESH[] = {{"primitives", LIST, REQUIRED, 1, 1, &A_PRIMITIVE}, {"name", TEXT}, {0}};
static const Rule ACCESSOR[] = {{"bufferView", INTEGER, REQUIRED, INDEX},
                                {"byteOffset", INTEGER, 0, INDEX},
                                {"componentType", INTEGER, REQUIRED, GLTF_UINT, GLTF_FLOAT},
                                {"normalized", FALSE},
                                {"count", INTEGER, REQUIRED, COUNT},
                                {"type", CHOICE, REQUIRED, .choices = "SCALAR VEC2 VEC3"},
                                {"min", LIST, 0, ANY_COUNT, &COORDINATE},
                                {"max", LIST, 0, ANY_COUNT, &COORDINATE},
                                {"name", TEXT},
                                {0}};
static const Rule BUFFER_VIEW[] = {{"buffer", INTEGER, REQUIRED, 0, 0},
                                   {"byteOffset", INTEGER, 0, INDEX},
                                   {"byteLength", INTEGER, REQUIRED, COUNT},
                                   {"target", INTEGER, 0, 34962, 34963},
                                   {"name", TEXT},
                                   {0}};
static const Rule BUFFER[] = {{"byteLength", INTEGER, REQUIRED, COUNT}, {"name", TEXT}, {0}};
static const Rule A_SCENE = {"", OBJECT, .of = GLTF_SCENE}, A_NODE = {"", OBJECT, .of = GLTF_NODE};
static const Rule A_MESH = {"", OBJECT, .of = GLTF_MESH}, AN_ACCESSOR = {"", OBJECT, .of = ACCESSOR};
static const Rule A_VIEW = {"", OBJECT, .of = BUFFER_VIEW}, A_BUFFER = {"", OBJECT, .of = BUFFER};
static const Rule GLTF[] = {{"asset", OBJECT, REQUIRED, .of = GLTF_ASSET},
                            {"scene", INTEGER, 0, 0, 0},
                            {"scenes", LIST, REQUIRED, 1, 1, &A_SCENE},
                            {"nodes", LIST, REQUIRED, 1, 1, &A_NODE},
                            {"meshes", LIST, REQUIRED, 1, 1, &A_MESH},
                            {"accessors", LIST, REQUIRED, 3, 4, &AN_ACCESSOR},
                            {"bufferViews", LIST, REQUIRED, 1, 4, &A_VIEW},
                            {"buffers", LIST, REQUIRED, 1, 1, &A_BUFFER},
                            {"extras", ANYTHING},
                            {0}};

/* A member that is an integer from 0, which it is where it is absent. */
static uint64_t integer_of(const Json *object, const char *name) {
    const Json *value = member(object, name);
    return value ? (uint64_t)value->number : 0;
}

static const Json *item_at(const Json *list, uint64_t index) {
    const Json *item = list->first;
    while (item && index--) item = item->next;
    return item;
}

/* The values of accessor `index`, which must be of this type; *count: of its elements. */
static const void *gltf_array(const Json *gltf, Span blob, uint64_t index, const char *type,
                              uint32_t *count, const char *entry, RnaReport *report) {
    const Json *accessor = item_at(member(gltf, "accessors"), index);
    unsigned width = strcmp(type, "VEC3") == 0 ? 3 : strcmp(type, "VEC2") == 0 ? 2 : 1;
    if (!accessor) {
        refuse(report, "GEOMETRY_RANGE", entry, "an existing accessor", "%u", (unsigned)index);
        return NULL;
    }
    if (!is_string(member(accessor, "type"), type) ||
        integer_of(accessor, "componentType") != (width == 1 ? GLTF_UINT : GLTF_FLOAT)) {
        refuse(report, "GEOMETRY_PROFILE", entry, type, "accessor %u of another type", (unsigned)index);
        return NULL;
    }
    const Json *view = item_at(member(gltf, "bufferViews"), integer_of(accessor, "bufferView"));
    if (!view) {
        refuse(report, "GEOMETRY_RANGE", entry, "an existing view", "accessor %u without it",
               (unsigned)index);
        return NULL;
    }
    uint64_t view_start = integer_of(view, "byteOffset"), elements = integer_of(accessor, "count");
    uint64_t view_end = view_start + integer_of(view, "byteLength");
    uint64_t start = view_start + integer_of(accessor, "byteOffset");
    if (start + 4 * width * elements > view_end || view_end > blob.size || start % 4) {
        refuse(report, "GEOMETRY_RANGE", entry, "aligned bytes inside view and buffer",
               "accessor %u of %llu elements", (unsigned)index, (unsigned long long)elements);
        return NULL;
    }
    *count = (uint32_t)elements;
    return blob.at + start;
}

/* The chunks of a .glb. */
static bool split_glb(Span file, Span *json, Span *blob, const char *entry, RnaReport *report) {
    if (file.size < 28 || u32_at(file.at) != 0x46546C67 || u32_at(file.at + 4) != 2 ||
        u32_at(file.at + 8) != file.size)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a glTF header and two chunks", "%zu bytes",
                      file.size);
    uint64_t size = u32_at(file.at + 12), bin = 20 + size + 8;
    if (u32_at(file.at + 16) != 0x4E4F534A || size > MAX_HEADER || bin > file.size)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a JSON chunk of at most 64 KiB",
                      "another of %llu bytes", (unsigned long long)size);
    *json = (Span){file.at + 20, (size_t)size};
    *blob = (Span){file.at + bin, file.size - (size_t)bin};
    if (u32_at(file.at + bin - 4) != 0x004E4942 || u32_at(file.at + bin - 8) != blob->size || bin % 4 ||
        blob->size % 4)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a BIN chunk that fills the file",
                      "another of %u bytes", (unsigned)u32_at(file.at + bin - 8));
    return true;
}

static bool check_mesh(const RnaMesh *mesh, const char *entry, RnaReport *report) {
    size_t vertices = mesh->vertex_count;
    if (!are_finite(mesh->positions, 3 * vertices) || !are_finite(mesh->normals, 3 * vertices) ||
        (mesh->uvs && !are_finite(mesh->uvs, 2 * vertices)))
        return refuse(report, "GEOMETRY_NOT_FINITE", entry, "finite attributes", "others");
    uint32_t largest = 0;
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++)
        largest = mesh->triangles[i] > largest ? mesh->triangles[i] : largest;
    if (largest >= vertices)
        return refuse(report, "GEOMETRY_INDEX", entry, "existing vertices", "%u of %zu",
                      (unsigned)largest, vertices);
    for (size_t i = 0; i < vertices; i++) {
        double x = mesh->normals[3 * i], y = mesh->normals[3 * i + 1], z = mesh->normals[3 * i + 2];
        double length = sqrt(x * x + y * y + z * z);
        if (fabs(length - 1) > 1e-3)
            return refuse(report, "GEOMETRY_NORMAL", entry, "unit within 0.001", "length %g", length);
    }
    return true;
}

/* The box around n points, radii included where there are any. */
static void box_around(const float *points, const float *radii, size_t n, float low[3], float high[3]) {
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = HUGE_VALF;
        high[axis] = -HUGE_VALF;
        for (size_t i = 0; i < n; i++) {
            float x = points[3 * i + (size_t)axis], r = radii ? radii[i] : 0;
            if (x - r < low[axis]) low[axis] = x - r;
            if (x + r > high[axis]) high[axis] = x + r;
        }
    }
}

/* Whether the list has these three values, as float32. */
static bool has_values(const Json *list, const float values[3]) {
    if (!list || list->type != JSON_ARRAY || list->count != 3) return false;
    const Json *item = list->first;
    for (int i = 0; i < 3; i++, item = item->next)
        if (fabs(item->number) > 2 * (double)FLT_MAX || (float)item->number != values[i]) return false;
    return true;
}

static bool find_arrays(const Json *gltf, Span blob, RnaMesh *mesh, const char *entry,
                        RnaReport *report) {
    const Json *primitive = member(member(gltf, "meshes")->first, "primitives")->first;
    const Json *attributes = member(primitive, "attributes"), *uvs = member(attributes, "TEXCOORD_0");
    uint64_t at_positions = integer_of(attributes, "POSITION");
    uint32_t indices, normals, coordinates;
    mesh->triangles = gltf_array(gltf, blob, integer_of(primitive, "indices"), "SCALAR", &indices,
                                 entry, report);
    if (!mesh->triangles) return false;
    if (indices % 3)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a multiple of 3", "%u indices",
                      (unsigned)indices);
    mesh->triangle_count = indices / 3;
    mesh->positions = gltf_array(gltf, blob, at_positions, "VEC3", &mesh->vertex_count, entry, report);
    if (!mesh->positions) return false;
    mesh->normals = gltf_array(gltf, blob, integer_of(attributes, "NORMAL"), "VEC3", &normals, entry,
                               report);
    if (!mesh->normals) return false;
    if (uvs) {
        mesh->uvs = gltf_array(gltf, blob, integer_of(attributes, "TEXCOORD_0"), "VEC2", &coordinates,
                               entry, report);
        if (!mesh->uvs) return false;
    }
    if (normals != mesh->vertex_count || (mesh->uvs && coordinates != mesh->vertex_count))
        return refuse(report, "GEOMETRY_ARRAY", entry, "attributes of equal counts", "others");
    if (!check_mesh(mesh, entry, report)) return false;
    const Json *accessor = item_at(member(gltf, "accessors"), at_positions);
    float low[3], high[3];
    box_around(mesh->positions, NULL, mesh->vertex_count, low, high);
    return (has_values(member(accessor, "min"), low) && has_values(member(accessor, "max"), high)) ||
           refuse(report, "GEOMETRY_BOUNDS", entry, "min and max of POSITION", "others");
}

static bool read_mesh(Span file, RnaMesh *mesh, const char *entry, RnaReport *report) {
    Span json, blob;
    if (!split_glb(file, &json, &blob, entry, report)) return false;
    JsonText text;
    Schema schema = {report, "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", true};
    schema.length = (size_t)snprintf(schema.where, sizeof schema.where / 2, "%s#", entry);
    if (schema.length >= sizeof schema.where / 2) schema.length = sizeof schema.where / 2 - 1;
    const Json *gltf = parse_json(json, entry, "GEOMETRY_CONTAINER", &text, report);
    bool good = gltf != NULL;
    if (good) check_members(&schema, GLTF, gltf);
    good = good && schema.issues == 0;
    if (good) {
        uint64_t declared = integer_of(member(gltf, "buffers")->first, "byteLength");
        if (declared > blob.size || blob.size > declared + 3)
            good = refuse(report, "GEOMETRY_RANGE", entry, "a buffer as long as its chunk", "%llu bytes",
                          (unsigned long long)declared);
        blob.size = (size_t)declared;
    }
    good = good && find_arrays(gltf, blob, mesh, entry, report);
    free_json(&text);
    return good;
}

#endif
