/* The JSON of a mesh: glTF in a profile (section 4.1). */
#ifndef RNA_MESH_RULES_H
#define RNA_MESH_RULES_H

#include "rules.h"

enum { GLTF_INT16 = 5122, GLTF_UINT16 = 5123, GLTF_UINT = 5125, GLTF_FLOAT = 5126 };
#define LARGEST_UINT 4294967295.0

#define INDEX 0, LARGEST_UINT
#define COUNT 1, LARGEST_UINT

static const Rule NODE_NUMBER = {"", INTEGER, 0, 0, 0};
static const Rule GLTF_ASSET[] = {{"version", CHOICE, REQUIRED, .choices = "2.0"},
                                  {"generator", TEXT},
                                  {"copyright", TEXT},
                                  {0}};
static const Rule GLTF_SCENE[] = {{"nodes", LIST, REQUIRED, 1, 1, &NODE_NUMBER}, {"name", TEXT}, {0}};
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

/* `option`: whether the mesh has KHR_mesh_quantization. */
static void component_is_known(Schema *schema, const Json *type) {
    if (type->number == 5124 || (!schema->option && type->number < GLTF_UINT))
        break_rule(schema, schema->value, schema->option ? "5122, 5123, 5125 or 5126" : "5125 or 5126", "%g",
                   type->number);
}

static void is_quantised(Schema *schema, const Json *normalized) {
    if (!schema->option && normalized->type == JSON_TRUE) break_rule(schema, schema->value, "false", "true");
}

static void stride_is_known(Schema *schema, const Json *stride) {
    if (stride->number != 4 && stride->number != 8)
        break_rule(schema, schema->value, "4 or 8", "%g", stride->number);
}

static void scale_is_uniform(Schema *schema, const Json *scale) {
    double first = scale->first->number;
    for (const Json *item = scale->first; item; item = item->next)
        if (!(item->number > 0 && item->number == first)) {
            break_rule(schema, schema->value, "three equal numbers greater than 0", "%g", item->number);
            return;
        }
}

static const Rule GLTF_NODE[] = {{"mesh", INTEGER, REQUIRED, 0, 0},
                                 {"translation", LIST, REQUIRED | OPTION, 3, 3, &COORDINATE},
                                 {"scale", LIST, REQUIRED | OPTION, 3, 3, &COORDINATE, .also = scale_is_uniform},
                                 {"name", TEXT},
                                 {0}};
static const Rule ACCESSOR[] = {
    {"bufferView", INTEGER, REQUIRED, INDEX},
    {"byteOffset", INTEGER, 0, INDEX},
    {"componentType", INTEGER, REQUIRED, GLTF_INT16, GLTF_FLOAT, .also = component_is_known},
    {"normalized", BOOLEAN, .also = is_quantised},
    {"count", INTEGER, REQUIRED, COUNT},
    {"type", CHOICE, REQUIRED, .choices = "SCALAR VEC2 VEC3"},
    {"min", LIST, 0, ANY_COUNT, &COORDINATE},
    {"max", LIST, 0, ANY_COUNT, &COORDINATE},
    {"name", TEXT},
    {0}};
static const Rule BUFFER_VIEW[] = {{"buffer", INTEGER, REQUIRED, 0, 0},
                                   {"byteOffset", INTEGER, 0, INDEX},
                                   {"byteLength", INTEGER, REQUIRED, COUNT},
                                   {"byteStride", INTEGER, OPTION, 4, 8, .also = stride_is_known},
                                   {"target", INTEGER, 0, 34962, 34963},
                                   {"name", TEXT},
                                   {0}};
static const Rule BUFFER[] = {{"byteLength", INTEGER, REQUIRED, COUNT}, {"name", TEXT}, {0}};
static const Rule A_SCENE = {"", OBJECT, .of = GLTF_SCENE}, A_NODE = {"", OBJECT, .of = GLTF_NODE};
static const Rule A_MESH = {"", OBJECT, .of = GLTF_MESH}, AN_ACCESSOR = {"", OBJECT, .of = ACCESSOR};
static const Rule A_VIEW = {"", OBJECT, .of = BUFFER_VIEW}, A_BUFFER = {"", OBJECT, .of = BUFFER};
static const Rule QUANTISATION = {"", CHOICE, .choices = "KHR_mesh_quantization"};
static const Rule GLTF[] = {{"asset", OBJECT, REQUIRED, .of = GLTF_ASSET},
                            {"scene", INTEGER, 0, 0, 0},
                            {"scenes", LIST, REQUIRED, 1, 1, &A_SCENE},
                            {"nodes", LIST, REQUIRED, 1, 1, &A_NODE},
                            {"meshes", LIST, REQUIRED, 1, 1, &A_MESH},
                            {"accessors", LIST, REQUIRED, 3, 4, &AN_ACCESSOR},
                            {"bufferViews", LIST, REQUIRED, 1, 4, &A_VIEW},
                            {"buffers", LIST, REQUIRED, 1, 1, &A_BUFFER},
                            {"extensionsUsed", LIST, REQUIRED | OPTION, 1, 1, &QUANTISATION},
                            {"extensionsRequired", LIST, REQUIRED | OPTION, 1, 1, &QUANTISATION},
                            {"extras", ANYTHING},
                            {0}};

#endif
