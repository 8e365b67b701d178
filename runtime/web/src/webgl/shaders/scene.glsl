// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node: min, right child or first primitive; max, number of primitives
uniform usampler2D primitives;  // RnaPrimitive, one a texel, in the order of the leaves
uniform sampler2D points;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D surfaces;    // rows of surfaces, then of textures: see geometry/surface_table.js
uniform usampler2D texels;      // of textures
uniform int texturesAt;
uniform float epsilon;          // the spec's e, 7.1

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

bool isSegment(uvec4 primitive) {
  return (primitive[PRIMITIVE_TAG] & RNA_IS_SEGMENT) != 0u;
}

// Row k of the record of a primitive's surface.
uvec4 surfaceRow(uvec4 primitive, int k) {
  return wordsAt(surfaces, SURFACE_ROWS * int(primitive[PRIMITIVE_TAG] >> RNA_SURFACE_SHIFT) + k);
}

struct Hit {
  float t;
  int place;       // of the primitive in the table
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
