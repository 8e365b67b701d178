// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and its own ray to the light (7.1).

struct Corners {
  vec3 p[3], n[3];
  vec2 uv[3];
};

Corners cornersOf(uvec4 primitive) {
  Corners corners;
  for (int k = 0; k < 3; k++) {
    vec4 place = valuesAt(points, int(primitive[PRIMITIVE_A + k])), normal = valuesAt(normals, int(primitive[PRIMITIVE_A + k]));
    corners.p[k] = place.xyz;
    corners.n[k] = normal.xyz;
    corners.uv[k] = vec2(place.w, normal.w);
  }
  return corners;
}

vec3 weightsOf(Hit hit) {
  return vec3(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

vec3 mixed(vec3 v[3], vec3 b) {
  return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

vec2 uvOf(Corners corners, vec3 b) {
  return b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
vec3 lookUp(uint image, vec2 uv) {
  uvec4 record = wordsAt(surfaces, texturesAt + TEXTURE_ROWS * int(image));
  ivec2 size = ivec2(record[TEXTURE_SIZE] & 0xffffu, record[TEXTURE_SIZE] >> 16u);
  vec2 place = uv * vec2(size) - 0.5, low = floor(place), f = place - low;
  // Repeat before integers: coordinates may be large.
  ivec2 at = clamp(ivec2(low - vec2(size) * floor(low / vec2(size))), ivec2(0), size - 1), next = (at + 1) % size;
  ivec4 places = int(record[TEXTURE_PLACE]) + ivec4(at.y, at.y, next.y, next.y) * size.x + ivec4(at.x, next.x, at.x, next.x);
  vec3 lower = mix(vec3(wordsAt(texels, places.x).xyz), vec3(wordsAt(texels, places.y).xyz), f.x);
  vec3 upper = mix(vec3(wordsAt(texels, places.z).xyz), vec3(wordsAt(texels, places.w).xyz), f.x);
  return mix(lower, upper, f.y);
}

float fresnel(float index, float c) {
  float g2 = index * index - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), r = (g - c) / (g + c), s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

vec3 transmittance(uvec4 primitive, Hit hit, vec3 d) {
  uint flags = surfaceRow(primitive, SURFACE_FLAGS_ROW)[SURFACE_FLAGS];
  if ((flags & LETS_THROUGH) == 0u) return vec3(0.0);
  uint through = surfaceRow(primitive, SURFACE_THROUGH_ROW)[SURFACE_THROUGH];
  float cutoff = uintBitsToFloat(surfaceRow(primitive, SURFACE_CUTOFF_ROW)[SURFACE_CUTOFF]);
  uvec4 iors = surfaceRow(primitive, SURFACE_IOR_ROW);
  vec2 ior = uintBitsToFloat(uvec2(iors[SURFACE_IOR], iors[SURFACE_IOR + 1]));  // in front and behind
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), tau = lookUp(through, uvOf(corners, b)) / 255.0;
  if ((flags & HAS_CUTOFF) != 0u) tau = vec3(tau.x > cutoff ? 1.0 : 0.0);
  if (ior.x > 0.0) {
    vec3 n = unit(mixed(corners.n, b)), ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
    tau *= 1.0 - fresnel(dot(d, ng) < 0.0 ? ior.x : ior.y, abs(dot(n, d)));
  }
  return tau;
}

// The normal with relief, 4.5.
vec3 mappedNormal(uint map, Corners corners, vec3 b, vec3 n) {
  if (map == NONE) return n;
  vec3 e1 = corners.p[1] - corners.p[0], e2 = corners.p[2] - corners.p[0];
  vec2 a = corners.uv[1] - corners.uv[0], c = corners.uv[2] - corners.uv[0];
  float area = a.x * c.y - c.x * a.y;
  if (area == 0.0) return n;
  vec3 u = (c.y * e1 - a.y * e2) * sign(area), v = (a.x * e2 - c.x * e1) * sign(area);
  vec3 along = u - dot(u, n) * n;
  if (length(along) <= 1e-6 * length(u)) return n;
  vec3 t = unit(along), up = cross(n, t);
  if (dot(up, v) > 0.0) up = -up;
  vec2 q = (lookUp(map, uvOf(corners, b)).xy - 127.0) / 127.0;
  vec3 m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
  return length(m) <= 1e-6 ? n : normalize(m);
}

vec3 shadingNormal(uvec4 primitive, Hit hit) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  return mappedNormal(surfaceRow(primitive, SURFACE_NORMAL_MAP_ROW)[SURFACE_NORMAL_MAP], corners, b, unit(mixed(corners.n, b)));
}

vec3 tangentOf(uvec4 primitive) {
  int point = int(primitive[PRIMITIVE_A]);
  return unit(valuesAt(points, point + 1).xyz - valuesAt(points, point).xyz);
}

// h of 4.2.
float offsetAcross(vec3 n, vec3 t, vec3 wo) {
  vec3 across = cross(t, wo);
  float size = length(across);
  return size > 1e-6 ? clamp(dot(n, across) / size, -1.0, 1.0) : 0.0;
}

// Where the visibility ray of a mesh starts.
vec3 liftedOrigin(uvec4 primitive, Hit hit, vec3 wi) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), x = mixed(corners.p, b), n = unit(mixed(corners.n, b));
  vec3 ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
  float side = dot(ng, wi) < 0.0 ? -1.0 : 1.0;
  if (dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && dot(ng, wi) < 0.1) {
    vec3 lift = vec3(0.0);
    for (int k = 0; k < 3; k++) lift += b[k] * max(0.0, dot(corners.p[k] - x, corners.n[k])) * corners.n[k];
    x += (1.0 - max(0.0, dot(ng, wi)) / 0.1) * lift;
    side = 1.0;
  }
  return x + side * epsilon * ng;
}
