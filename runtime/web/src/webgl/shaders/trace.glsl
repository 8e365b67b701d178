// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48, ROOT = 1;  // node 0 is rna_gpu's, of the only instance
const float FAR = 1e30;

float entersBox(vec3 low, vec3 high, vec3 origin, vec3 inverse, float far) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 near3 = min(a, b), far3 = max(a, b);
  float near = max(max(near3.x, near3.y), max(near3.z, 0.0));
  float last = min(min(far3.x, far3.y), min(far3.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  vec3 low = uintBitsToFloat(wordsAt(nodes, 2 * node).xyz), high = uintBitsToFloat(wordsAt(nodes, 2 * node + 1).xyz);
  return entersBox(low, high, origin, inverse, far);
}

// The nearest hit; t is FAR where there is none.
Hit nearest(vec3 origin, vec3 d) {
  Hit hit = Hit(FAR, 0, 0.0, 0.0, vec3(0.0));
  vec3 inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = ROOT;
  if (boxAt(ROOT, origin, inverse, FAR) == FAR) return hit;
  for (;;) {
    int first = int(wordsAt(nodes, 2 * node).w), count = int(wordsAt(nodes, 2 * node + 1).w);
    if (count > 0) {
      for (int k = first; k < first + count; k++) {
        uvec4 primitive = wordsAt(primitives, k);
        bool met = isSegment(primitive) ? meetsSegment(primitive, origin, d, hit.t, hit)
                                                 : meetsTriangle(primitive, origin, shear, hit.t, hit);
        if (met) hit.place = k;
      }
    } else {
      int left = node + 1, right = first;
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      int nearer = a <= b ? left : right, farther = a <= b ? right : left;
      if (max(a, b) < FAR) stack[top++] = farther;
      if (min(a, b) < FAR) {
        node = nearer;
        continue;
      }
    }
    if (top == 0) return hit;
    node = stack[--top];
  }
}

// The light that passes from origin along d to infinity, strand `own` being no obstacle.
vec3 passes(vec3 origin, vec3 d, uint own) {
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = ROOT;
  if (boxAt(ROOT, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    int first = int(wordsAt(nodes, 2 * node).w), count = int(wordsAt(nodes, 2 * node + 1).w);
    if (count > 0) {
      for (int k = first; k < first + count; k++) {
        uvec4 primitive = wordsAt(primitives, k);
        Hit hit;
        if (isSegment(primitive)) {
          if (primitive.z != own && meetsSegment(primitive, origin, d, FAR, hit)) return vec3(0.0);
        } else if (meetsTriangle(primitive, origin, shear, FAR, hit)) {
          light *= transmittance(primitive, hit, d);
          if (light == vec3(0.0)) return light;
        }
      }
    } else {
      int left = node + 1, right = first;
      bool onLeft = boxAt(left, origin, inverse, FAR) < FAR, onRight = boxAt(right, origin, inverse, FAR) < FAR;
      if (onLeft && onRight) stack[top++] = right;
      if (onLeft || onRight) {
        node = onLeft ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}
