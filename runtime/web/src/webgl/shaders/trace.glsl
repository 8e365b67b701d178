// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48, ROOT = 1;  // node 0 is rna_gpu's, of the only instance
const float FAR = 1e30;

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

// Where a ray enters the box of a node, FAR if not.
float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  vec3 a = (uintBitsToFloat(wordsAt(nodes, 2 * node).xyz) - origin) * inverse;
  vec3 b = (uintBitsToFloat(wordsAt(nodes, 2 * node + 1).xyz) - origin) * inverse, low = min(a, b), high = max(a, b);
  float near = max(max(low.x, low.y), max(low.z, 0.0)), last = min(min(high.x, high.y), min(high.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// The nearest hit of a ray, in `hit`, of which t is FAR for none; or, if it weakens, the light that passes to infinity.
// Strand `own` is no obstacle.
vec3 traced(vec3 origin, vec3 d, uint own, bool weakens, out Hit hit) {
  hit = Hit(FAR, 0, 0.0, 0.0, vec3(0.0));
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = ROOT;
  if (boxAt(ROOT, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    int first = int(wordsAt(nodes, 2 * node).w), count = int(wordsAt(nodes, 2 * node + 1).w);
    for (int k = first; k < first + count; k++) {
      uvec4 primitive = wordsAt(primitives, k);
      bool segment = isSegment(primitive);
      if (segment && primitive[PRIMITIVE_C] == own) continue;
      bool isHit = segment ? meetsSegment(primitive, origin, d, hit.t, hit) : meetsTriangle(primitive, origin, shear, hit.t, hit);
      if (!isHit) continue;
      hit.place = k;
      if (!weakens) continue;
      light *= segment ? vec3(0.0) : transmittance(primitive, hit, d);
      if (light == vec3(0.0)) return light;
      hit.t = FAR;
    }
    if (count == 0) {
      int left = node + 1, right = first;
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      if (max(a, b) < FAR) stack[top++] = a <= b ? right : left;
      if (min(a, b) < FAR) {
        node = a <= b ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}

Hit nearest(vec3 origin, vec3 d) {
  Hit hit;
  traced(origin, d, NONE, false, hit);
  return hit;
}

vec3 passes(vec3 origin, vec3 d, uint own) {
  Hit hit;
  return traced(origin, d, own, true, hit);
}
