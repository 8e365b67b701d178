// Input blocks of a decoder (spec, 6.3), in the forms for float32.

uniform sampler2DArray planes;  // three planes of `groups` layers of four channels
uniform int resolution;
uniform int channels;
uniform vec4 scales[48];        // of int8: scale of each channel; else 1
uniform vec3 boundsMin;
uniform vec3 boundsMax;
uniform int blockCount;
uniform int blocks[BLOCKS];     // BLOCK_ of each, in the order of the columns

float columns[COLUMNS];

// Features are summed over the planes (spec, 5).
vec4 featuresOf(int group, vec3 p) {
  int groups = (channels + 3) / 4;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 3; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1) % 3]) * float(resolution) - 0.5, 0.0, float(resolution - 1));
    ivec2 low = ivec2(floor(at)), high = min(low + 1, resolution - 1);
    vec2 f = at - floor(at);
    int layer = k * groups + group;
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    sum += mix(lower, upper, f.y) * scales[layer];
  }
  return sum;
}

vec3 halfway(vec3 wo, vec3 wi, vec3 instead) {
  vec3 s = wi + wo, e = wi - wo;
  float apart = dot(e, e), together = dot(s, s);
  if (together < 1e-12) return instead;
  if (together < apart) s -= e * (dot(s, e) / apart);
  return unit(s);
}

float gap(vec3 n, vec3 m) {
  vec3 d = n - m;
  return log2(0.5 * dot(d, d) + 1e-4) / 6.0;
}

void put(inout int at, float value) {
  columns[at++] = value;
}

void put3(inout int at, vec3 v) {
  put(at, v.x);
  put(at, v.y);
  put(at, v.z);
}

void putFeatures(inout int at, vec3 p) {
  for (int group = 0; 4 * group < channels; group++) {
    vec4 f = featuresOf(group, p);
    for (int c = 0; c < 4 && 4 * group + c < channels; c++) put(at, f[c]);
  }
}

void putFiber(inout int at, int block, vec3 t, float h, vec3 wo, vec3 wi) {
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  if (block == BLOCK_FIBER_ANGLES) {
    put3(at, vec3(si, so, sum));
    put3(at, vec3(log2(sum * sum + 1e-3) / 6.0, cosPhi, sinPhi));
    return;
  }
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  for (int p = 0; p < 3; p++) {
    put(at, cosPhi * lobe.x + sinPhi * lobe.y);
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
}

// Fills `columns`. x: a position, axis: n or t; all directions unit.
void fillColumns(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - boundsMin) / (boundsMax - boundsMin), 0.0, 1.0);
  int at = 0;
  for (int k = 0; k < blockCount; k++) {
    int block = blocks[k];
    if (block == BLOCK_FEATURES) putFeatures(at, p);
    else if (block == BLOCK_POSITION) put3(at, 2.0 * p - 1.0);
    else if (block == BLOCK_NORMAL || block == BLOCK_TANGENT) put3(at, axis);
    else if (block == BLOCK_H) put(at, h);
    else if (block == BLOCK_WO) put3(at, wo);
    else if (block == BLOCK_WI) put3(at, wi);
    else if (block == BLOCK_HALF_VECTOR) {
      vec3 m = halfway(wo, wi, axis);
      put3(at, vec3(dot(axis, m), gap(axis, m), dot(axis, wi)));
      put(at, dot(axis, wo));
      put(at, dot(wi, m));
    } else if (block == BLOCK_HIGHLIGHT) {
      vec3 c = cross(axis, halfway(wo, wi, axis));
      put(at, log2(dot(c, c) + 1e-8) / 12.0);
    } else if (block == BLOCK_LEARNED_NORMAL) {
      vec3 f = featuresOf(0, p).xyz * vec3(1.0, float(channels > 1), float(channels > 2));
      vec3 bent = axis + 0.1 * f;
      vec3 q = length(bent) < 1e-6 ? axis : unit(bent), m = halfway(wo, wi, q);
      put(at, dot(q, m));
      put(at, gap(q, m));
    } else putFiber(at, block, axis, h, wo, wi);
  }
}
