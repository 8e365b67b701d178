// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48;
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
  uvec4 first = wordsAt(nodes, 2 * node);
  uvec2 second = wordsAt(nodes, 2 * node + 1).xy;
  vec4 a = uintBitsToFloat(first);
  vec2 b = uintBitsToFloat(second);
  return entersBox(a.xyz, vec3(a.w, b), origin, inverse, far);
}

// The nearest hit; t is FAR where there is none.
Hit nearest(vec3 origin, vec3 d) {
  Hit hit = Hit(FAR, 0u, 0, 0.0, 0.0, vec3(0.0));
  vec3 inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return hit;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        bool met = (primitive.w & SEGMENT) != 0u ? meetsSegment(primitive, origin, d, hit.t, hit)
                                                 : meetsTriangle(primitive, origin, shear, hit.t, hit);
        if (met) hit.place = k;
      }
    } else {
      int left = node + 1, right = node + int(words.z);
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
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        Hit hit;
        if ((primitive.w & SEGMENT) != 0u) {
          if (primitive.z != own && meetsSegment(primitive, origin, d, FAR, hit)) return vec3(0.0);
        } else if (meetsTriangle(primitive, origin, shear, FAR, hit)) {
          light *= transmittance(primitive, hit, d);
          if (light == vec3(0.0)) return light;
        }
      }
    } else {
      int left = node + 1, right = node + int(words.z);
      bool first = boxAt(left, origin, inverse, FAR) < FAR, second = boxAt(right, origin, inverse, FAR) < FAR;
      if (first && second) stack[top++] = right;
      if (first || second) {
        node = first ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}
