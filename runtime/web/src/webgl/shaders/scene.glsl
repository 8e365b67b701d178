// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node
uniform usampler2D primitives;  // one a primitive, in the order of the leaves
uniform sampler2D places;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D records;     // three texels a record
uniform usampler2D texels;      // one byte of textures each
uniform int recordCount;
uniform int partCount;
uniform int partFirst[16];      // number of its first primitive
uniform bool partIsFiber[16];
uniform float epsilon;          // the spec's e, 7.1

const uint SEGMENT = 0x80000000u;

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

int partOf(uint number) {
  // Parts stand in the order of their first primitives, but for meshes before strands.
  int found = 0, first = -1;
  for (int k = 0; k < partCount; k++) {
    if (int(number) >= partFirst[k] && partFirst[k] > first) {
      found = k;
      first = partFirst[k];
    }
  }
  return found;
}

struct Hit {
  float t;
  uint number;     // of the primitive, with SEGMENT; in `place` its place in the table
  int place;
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
