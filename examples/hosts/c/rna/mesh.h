/* Meshes: binary glTF, as float32 or quantised (section 4.1). */
#ifndef RNA_MESH_H
#define RNA_MESH_H

#include "mesh_rules.h"
#include "tensors.h"

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

/* How the values of an accessor lie in its view. */
typedef struct Layout {
    unsigned component, size; /* componentType, and bytes of a value */
    bool normalized;
    unsigned stride; /* byteStride of the view; 0: none */
} Layout;

static const Layout AS_FLOAT = {GLTF_FLOAT, 4, false, 0}, AS_UINT = {GLTF_UINT, 4, false, 0};
static const Layout AS_STEPS = {GLTF_UINT16, 2, false, 8}, AS_DIRECTION = {GLTF_INT16, 2, true, 8};
static const Layout AS_SHARE = {GLTF_UINT16, 2, true, 4}, AS_UINT16 = {GLTF_UINT16, 2, false, 0};

/* The values of an accessor, in the file. */
typedef struct Array {
    const uint8_t *at;
    uint32_t count;     /* of its elements */
    unsigned component; /* componentType */
} Array;

/* Accessor `index`, of `width` values an element, in this layout or the other. */
static bool find_array(const Json *gltf, Span blob, uint64_t index, unsigned width, const Layout *layout,
                       const Layout *other, Array *array, const char *entry, RnaReport *report) {
    static const char *const TYPES[] = {NULL, "SCALAR", "VEC2", "VEC3"};
    const Json *accessor = item_at(member(gltf, "accessors"), index);
    if (!accessor) return refuse(report, "GEOMETRY_RANGE", entry, "an existing accessor", "%u", (unsigned)index);
    array->component = (unsigned)integer_of(accessor, "componentType");
    if (other && other->component == array->component) layout = other;
    const Json *normalized = member(accessor, "normalized");
    bool is_normalized = normalized && normalized->type == JSON_TRUE;
    if (!is_string(member(accessor, "type"), TYPES[width]) || array->component != layout->component ||
        is_normalized != layout->normalized)
        return refuse(report, "GEOMETRY_PROFILE", entry, TYPES[width], "accessor %u of another type",
                      (unsigned)index);
    const Json *view = item_at(member(gltf, "bufferViews"), integer_of(accessor, "bufferView"));
    if (!view)
        return refuse(report, "GEOMETRY_RANGE", entry, "an existing view", "accessor %u without it",
                      (unsigned)index);
    if (integer_of(view, "byteStride") != layout->stride)
        return refuse(report, "GEOMETRY_PROFILE", entry, "the byteStride of its type",
                      "accessor %u with another", (unsigned)index);
    uint64_t view_start = integer_of(view, "byteOffset"), elements = integer_of(accessor, "count");
    uint64_t view_end = view_start + integer_of(view, "byteLength");
    uint64_t start = view_start + integer_of(accessor, "byteOffset"), size = width * layout->size;
    uint64_t stride = layout->stride ? layout->stride : size;
    if (start + stride * (elements - 1) + size > view_end || view_end > blob.size || start % 4)
        return refuse(report, "GEOMETRY_RANGE", entry, "aligned bytes inside view and buffer",
                      "accessor %u of %llu elements", (unsigned)index, (unsigned long long)elements);
    array->at = blob.at + start;
    array->count = (uint32_t)elements;
    return true;
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

/* The arrays of a mesh, as they lie in the file. */
typedef struct Arrays {
    Array positions, normals, uvs, indices; /* uvs.count: 0 where there are none */
} Arrays;

static bool find_arrays(const Json *gltf, bool quantised, Span blob, Arrays *arrays, const char *entry,
                        RnaReport *report) {
    const Json *primitive = member(member(gltf, "meshes")->first, "primitives")->first;
    const Json *attributes = member(primitive, "attributes"), *accessors = member(gltf, "accessors");
    const Json *position = item_at(accessors, integer_of(attributes, "POSITION"));
    const Json *index = item_at(accessors, integer_of(primitive, "indices"));
    if (quantised && position && index && integer_of(position, "count") >= 65535 &&
        integer_of(index, "componentType") == GLTF_UINT16)
        return refuse(report, "GEOMETRY_PROFILE", entry, "indices of 32 bits for so many vertices", "16");
    bool good = find_array(gltf, blob, integer_of(primitive, "indices"), 1, &AS_UINT,
                           quantised ? &AS_UINT16 : NULL, &arrays->indices, entry, report) &&
                find_array(gltf, blob, integer_of(attributes, "POSITION"), 3,
                           quantised ? &AS_STEPS : &AS_FLOAT, NULL, &arrays->positions, entry, report) &&
                find_array(gltf, blob, integer_of(attributes, "NORMAL"), 3,
                           quantised ? &AS_DIRECTION : &AS_FLOAT, NULL, &arrays->normals, entry, report) &&
                (!member(attributes, "TEXCOORD_0") ||
                 find_array(gltf, blob, integer_of(attributes, "TEXCOORD_0"), 2, &AS_FLOAT,
                            quantised ? &AS_SHARE : NULL, &arrays->uvs, entry, report));
    if (!good) return false;
    uint32_t vertices = arrays->positions.count;
    if (arrays->indices.count % 3)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a multiple of 3", "%u indices",
                      (unsigned)arrays->indices.count);
    if (arrays->normals.count != vertices || (arrays->uvs.at && arrays->uvs.count != vertices))
        return refuse(report, "GEOMETRY_ARRAY", entry, "attributes of equal counts", "others");
    return true;
}

static int16_t i16_at(const uint8_t *at) { return (int16_t)u16_at(at); }

/* One vertex of a quantised mesh; the length of the normal as it is stored.  Products are rounded before
 * they are added: all readers have the same mesh. */
static double restore_vertex(const Arrays *from, const double translation[3], double scale, size_t i,
                             float position[3], float normal[3]) {
    double n[3], length2 = 0;
    for (size_t k = 0; k < 3; k++) {
        double offset = scale * u16_at(from->positions.at + 8 * i + 2 * k);
        position[k] = (float)(translation[k] + offset);
        n[k] = fmax(i16_at(from->normals.at + 8 * i + 2 * k) / 32767.0, -1);
        length2 += n[k] * n[k];
    }
    double length = sqrt(length2);
    for (int k = 0; k < 3; k++) normal[k] = (float)(n[k] / (length > 0 ? length : 1));
    return length;
}

/* A quantised mesh, in memory of its own. */
static bool restore_mesh(const Json *gltf, const Arrays *from, RnaMesh *mesh, void **block,
                         const char *entry, RnaReport *report) {
    const Json *node = member(gltf, "nodes")->first, *item = member(node, "translation")->first;
    double translation[3], scale = member(node, "scale")->first->number;
    size_t n = from->positions.count, indices = from->indices.count;
    for (int k = 0; k < 3; k++, item = item->next) translation[k] = item->number;
    float *positions = *block = malloc(8 * n * sizeof *positions + indices * sizeof(uint32_t));
    if (!positions) return refuse(report, "GEOMETRY_CONTAINER", entry, "memory for it", "not enough");
    float *normals = positions + 3 * n, *uvs = normals + 3 * n;
    uint32_t *triangles = (uint32_t *)(void *)(uvs + 2 * n);
    for (size_t i = 0; i < n; i++) {
        double length = restore_vertex(from, translation, scale, i, positions + 3 * i, normals + 3 * i);
        if (fabs(length - 1) > 1e-3)
            return refuse(report, "GEOMETRY_NORMAL", entry, "unit within 0.001", "length %g", length);
    }
    for (size_t i = 0; i < 2 * n && from->uvs.component == GLTF_UINT16; i++)
        uvs[i] = (float)(u16_at(from->uvs.at + 2 * i) / 65535.0);
    for (size_t i = 0; i < indices && from->indices.component == GLTF_UINT16; i++)
        triangles[i] = u16_at(from->indices.at + 2 * i);
    mesh->positions = positions;
    mesh->normals = normals;
    if (from->uvs.component == GLTF_UINT16) mesh->uvs = uvs;
    if (from->indices.component == GLTF_UINT16) mesh->triangles = triangles;
    return true;
}

/* Smallest and largest stored values of the positions. */
static void box_of_positions(const Array *positions, bool quantised, float low[3], float high[3]) {
    if (!quantised) {
        box_around((const float *)(const void *)positions->at, NULL, positions->count, low, high);
        return;
    }
    for (size_t k = 0; k < 3; k++) {
        low[k] = HUGE_VALF;
        high[k] = -HUGE_VALF;
        for (size_t i = 0; i < positions->count; i++) {
            float q = (float)u16_at(positions->at + 8 * i + 2 * k);
            low[k] = fminf(low[k], q);
            high[k] = fmaxf(high[k], q);
        }
    }
}

static bool build_mesh(const Json *gltf, bool quantised, Span blob, RnaMesh *mesh, void **block,
                       const char *entry, RnaReport *report) {
    Arrays arrays = {0};
    if (!find_arrays(gltf, quantised, blob, &arrays, entry, report)) return false;
    mesh->vertex_count = arrays.positions.count;
    mesh->triangle_count = arrays.indices.count / 3;
    mesh->positions = (const float *)(const void *)arrays.positions.at;
    mesh->normals = (const float *)(const void *)arrays.normals.at;
    mesh->uvs = (const float *)(const void *)arrays.uvs.at;
    mesh->triangles = (const uint32_t *)(const void *)arrays.indices.at;
    if (quantised && !restore_mesh(gltf, &arrays, mesh, block, entry, report)) return false;
    if (!check_mesh(mesh, entry, report)) return false;
    const Json *attributes = member(member(member(gltf, "meshes")->first, "primitives")->first, "attributes");
    const Json *accessor = item_at(member(gltf, "accessors"), integer_of(attributes, "POSITION"));
    float low[3], high[3];
    box_of_positions(&arrays.positions, quantised, low, high);
    return (has_values(member(accessor, "min"), low) && has_values(member(accessor, "max"), high)) ||
           refuse(report, "GEOMETRY_BOUNDS", entry, "min and max of POSITION", "others");
}

/* The mesh in a file; *block: what is allocated for it, in any case for the caller to free. */
static bool read_mesh(Span file, RnaMesh *mesh, void **block, const char *entry, RnaReport *report) {
    Span json = {0}, blob = {0};
    if (!split_glb(file, &json, &blob, entry, report)) return false;
    JsonText text;
    Schema schema = {report, "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", .only_first = true};
    schema.length = (size_t)snprintf(schema.where, sizeof schema.where / 2, "%s#", entry);
    if (schema.length >= sizeof schema.where / 2) schema.length = sizeof schema.where / 2 - 1;
    const Json *gltf = parse_json(json, entry, "GEOMETRY_CONTAINER", &text, report);
    bool good = gltf != NULL;
    schema.option = member(gltf, "extensionsUsed") || member(gltf, "extensionsRequired");
    if (good) check_members(&schema, GLTF, gltf);
    good = good && schema.issues == 0;
    if (good) {
        uint64_t declared = integer_of(member(gltf, "buffers")->first, "byteLength");
        if (declared > blob.size || blob.size > declared + 3)
            good = refuse(report, "GEOMETRY_RANGE", entry, "a buffer as long as its chunk", "%llu bytes",
                          (unsigned long long)declared);
        blob.size = (size_t)declared;
    }
    good = good && build_mesh(gltf, schema.option, blob, mesh, block, entry, report);
    free_json(&text);
    return good;
}

#endif
