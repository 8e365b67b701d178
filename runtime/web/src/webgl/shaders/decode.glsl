// What the decoder of one part answers for the queries on it.
uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D lit0;
uniform int part;
uniform bool isFiber;
uniform bool hasLight;

layout(location = 0) out vec4 first;   // visible, or emitted
layout(location = 1) out vec4 second;  // shadowed

// By its bits: shaders may assume that there is no NaN.
bool isUsable(vec3 v) {
  uvec3 bits = floatBitsToUint(v) & 0x7f800000u;
  return bits.x != 0x7f800000u && bits.y != 0x7f800000u && bits.z != 0x7f800000u;
}

bool isDirection(vec3 v) {
  uvec3 bits = floatBitsToUint(v) & 0x7fffffffu;
  return isUsable(v) && (bits.x | bits.y | bits.z) != 0u;
}

// Unit to rounding is taken as it is (spec, 6.3); the smallest numbers are brought up first.
vec3 direction(vec3 v) {
  if (abs(dot(v, v) - 1.0) < 5e-7) return v;
  vec3 size = abs(v);
  return unit(max(size.x, max(size.y, size.z)) < 1e-30 ? v * 1e30 : v);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0);
  vec4 light = texelFetch(lit0, pixel, 0);
  if (int(row0.w) != part + 1 || (hasLight && light.w != 1.0)) discard;
  vec4 row1 = texelFetch(rows1, pixel, 0);
  vec3 wo = texelFetch(rows2, pixel, 0).xyz, wi = hasLight ? light.xyz : wo;
  first = vec4(0.0, 0.0, 0.0, 1.0);
  second = vec4(0.0, 0.0, 0.0, 1.0);
  bool usable = isUsable(row0.xyz) && isDirection(row1.xyz) && isDirection(wo) && isDirection(wi)
    && isUsable(row1.www);
  if (!usable) return;
  float h = isFiber ? clamp(row1.w, -1.0, 1.0) : 0.0;
  fillColumns(row0.xyz, direction(row1.xyz), h, direction(wo), direction(wi));
  vec3 a, b;
  decode(COLUMNS, a, b);
  first.xyz = a;
  second.xyz = b;
}
