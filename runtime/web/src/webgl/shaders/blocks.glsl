// Input blocks of a decoder (spec, 6.3), in the forms for float32. Each starts at a group of four columns.

uniform bool isFiber;
uniform sampler2DArray planes;  // three planes of `channel_groups` layers of four channels

// Features are summed over the planes (spec, 5).
vec4 featuresOf(uint group, vec3 p) {
  float size = float(part.resolution);
  vec4 sum = vec4(0.0);
  for (uint k = 0u; k < 3u; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1u) % 3u]) * size - 0.5, 0.0, size - 1.0);
    ivec2 low = ivec2(floor(at)), high = min(low + 1, int(size) - 1);
    vec2 f = at - floor(at);
    int layer = int(k * part.channel_groups + group);
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    vec4 scale = part.plane_precision == RNA_INT8 ? part.scales[k * RNA_CHANNEL_GROUPS + group] : vec4(1.0);
    sum += mix(lower, upper, f.y) * scale;
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

uint slotOf(uint block) {
  return part.slots[block >> 2][block & 3u];
}

bool has(uint block) {
  return slotOf(block) != RNA_NONE;
}

void put(uint block, vec4 value) {
  if (has(block)) values[slotOf(block)] = value;
}

// With the second group of blocks of more than four columns.
void put(uint block, vec4 value, vec4 more) {
  put(block, value);
  if (has(block)) values[slotOf(block) + 1u] = more;
}

void putSurface(vec3 n, vec3 wo, vec3 wi, vec3 features) {
  vec3 m = halfway(wo, wi, n), aside = cross(n, m);
  put(RNA_BLOCK_NORMAL, vec4(n, 0.0));
  put(RNA_BLOCK_HALF_VECTOR, vec4(dot(n, m), gap(n, m), dot(n, wi), dot(n, wo)), vec4(dot(wi, m), 0.0, 0.0, 0.0));
  put(RNA_BLOCK_HIGHLIGHT, vec4(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
  vec3 bent = n + 0.1 * features, q = length(bent) < 1e-6 ? n : unit(bent), learned = halfway(wo, wi, q);
  put(RNA_BLOCK_LEARNED_NORMAL, vec4(dot(q, learned), gap(q, learned), 0.0, 0.0));
}

void putFiber(vec3 t, float h, vec3 wo, vec3 wi) {
  put(RNA_BLOCK_TANGENT, vec4(t, 0.0));
  put(RNA_BLOCK_H, vec4(h, 0.0, 0.0, 0.0));
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  put(RNA_BLOCK_FIBER_ANGLES, vec4(si, so, sum, log2(sum * sum + 1e-3) / 6.0), vec4(cosPhi, sinPhi, 0.0, 0.0));
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  vec4 lobes = vec4(0.0);
  for (int p = 0; p < 3; p++) {
    lobes[p] = cosPhi * lobe.x + sinPhi * lobe.y;
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
  put(RNA_BLOCK_FIBER_LOBES, lobes);
}

// Fills `values`. x: a position, axis: n or t; all directions unit.
void fillValues(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - part.low) / (part.high - part.low), 0.0, 1.0);
  vec4 features = featuresOf(0u, p);
  put(RNA_BLOCK_FEATURES, features);
  for (uint group = 1u; has(RNA_BLOCK_FEATURES) && group < part.channel_groups; group++) {
    values[slotOf(RNA_BLOCK_FEATURES) + group] = featuresOf(group, p);
  }
  put(RNA_BLOCK_POSITION, vec4(2.0 * p - 1.0, 0.0));
  put(RNA_BLOCK_WO, vec4(wo, 0.0));
  put(RNA_BLOCK_WI, vec4(wi, 0.0));
  if (isFiber) putFiber(axis, h, wo, wi);
  else putSurface(axis, wo, wi, features.xyz);
}
