// Where a ray meets a triangle or a round segment (spec, 4.1 and 4.2).

// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides.
struct Shear {
  ivec3 axes;
  vec3 s;
};

Shear shearOf(vec3 d) {
  vec3 a = abs(d);
  int z = a.x > a.y ? 0 : 1;
  if (a.z > a[z]) z = 2;
  int x = (z + 1) % 3, y = (z + 2) % 3;
  return Shear(ivec3(x, y, z), vec3(d[x], d[y], 1.0) / d[z]);
}

bool meetsTriangle(uvec4 primitive, vec3 origin, Shear shear, float far, inout Hit hit) {
  vec3 v[3];
  for (int k = 0; k < 3; k++) {
    vec3 p = valuesAt(points, int(primitive[k])).xyz - origin;
    vec3 q = vec3(p[shear.axes.x], p[shear.axes.y], p[shear.axes.z]);
    v[k] = vec3(q.xy - shear.s.xy * q.z, q.z);
  }
  float u0 = v[2].x * v[1].y - v[2].y * v[1].x;
  float u1 = v[0].x * v[2].y - v[0].y * v[2].x;
  float u2 = v[1].x * v[0].y - v[1].y * v[0].x;
  if (min(u0, min(u1, u2)) < 0.0 && max(u0, max(u1, u2)) > 0.0) return false;
  float sum = u0 + u1 + u2;
  if (sum == 0.0) return false;
  float t = (u0 * v[0].z + u1 * v[1].z + u2 * v[2].z) * shear.s.z / sum;
  if (!(t >= 0.0 && t < far)) return false;
  hit.t = t;
  hit.b1 = u1 / sum;
  hit.b2 = u2 / sum;
  return true;
}

struct Cone {
  vec3 a, b;
  float ra, rb;
};

Cone coneAt(int point) {
  vec4 a = valuesAt(points, point), b = valuesAt(points, point + 1);
  return Cone(a.xyz, b.xyz, a.w, b.w);
}

// The entry into a sphere, from a point near it.
float entersSphere(vec3 origin, vec3 d, vec3 centre, float radius) {
  vec3 between = origin - centre;
  float along = dot(between, d);
  vec3 across = between - along * d;
  float h = radius * radius - dot(across, across);
  return h > 0.0 ? -along - sqrt(h) : 1e30;
}

// The first of all points where the line enters one of the two spheres or the side between them.
bool entersCone(Cone cone, vec3 origin, vec3 d, out float t, out vec3 n) {
  vec3 axis = cone.b - cone.a;
  // From the point of the line nearest to the segment, so that distances do not cancel.
  float shift = dot(0.5 * (cone.a + cone.b) - origin, d);
  vec3 near = (origin - cone.a) + shift * d;
  float dr = cone.ra - cone.rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
  float ta = entersSphere(near, d, vec3(0.0), cone.ra), tb = entersSphere(near, d, axis, cone.rb);
  t = min(ta, tb);
  n = near + t * d - (ta < tb ? vec3(0.0) : axis);
  if (d2 > 0.0) {
    float m1 = dot(axis, near), m2 = dot(axis, d), m3 = dot(d, near);
    float k2 = d2 - m2 * m2, k1 = d2 * m3 - m1 * m2 + m2 * dr * cone.ra;
    float k0 = d2 * dot(near, near) - m1 * m1 + 2.0 * m1 * dr * cone.ra - length2 * cone.ra * cone.ra;
    float h = k1 * k1 - k0 * k2;
    if (h >= 0.0 && k2 != 0.0) {
      for (float way = -1.0; way < 2.0; way += 2.0) {
        float side = (-k1 + way * sqrt(h)) / k2, y = m1 - cone.ra * dr + side * m2;
        vec3 normal = d2 * (near + side * d) - axis * y;
        if (y > 0.0 && y < d2 && side < t && dot(normal, d) < 0.0) {
          t = side;
          n = normal;
        }
      }
    }
  }
  if (t > 1e29) return false;
  t += shift;
  n = unit(n);
  return true;
}

// How far p is outside of the cone; negative inside.
float distanceTo(Cone cone, vec3 p) {
  vec3 axis = cone.b - cone.a, near = p - cone.a;
  float dr = cone.ra - cone.rb, size = length(axis), y = dot(near, axis) / size, z = y - size;
  float x = length(near - axis * (y / size));
  float toA = length(vec2(x, y)) - cone.ra, toB = length(vec2(x, z)) - cone.rb;
  if (size * size <= dr * dr) return dr > 0.0 ? toA : toB;
  float slope = dr / size, lean = sqrt(1.0 - slope * slope), along = y * lean - x * slope;
  if (along <= 0.0) return toA;
  if (along >= size * lean) return toB;
  return x * lean + y * slope - cone.ra;
}

// An entry inside the segment before or after is no surface.
bool insideNeighbour(int point, uint neighbours, vec3 p) {
  for (int k = 0; k < 2; k++) {
    if ((neighbours & (k == 0 ? RNA_HAS_BEFORE : RNA_HAS_AFTER)) == 0u) continue;
    Cone cone = coneAt(point + (k == 0 ? -1 : 1));
    if (distanceTo(cone, p) < -1e-4 * min(cone.ra, cone.rb)) return true;
  }
  return false;
}

bool meetsSegment(uvec4 primitive, vec3 origin, vec3 d, float far, inout Hit hit) {
  int point = int(primitive[PRIMITIVE_A]);
  float t;
  vec3 n;
  if (!entersCone(coneAt(point), origin, d, t, n)) return false;
  if (!(t >= 0.0 && t < far)) return false;
  if (insideNeighbour(point, primitive[PRIMITIVE_B], origin + t * d)) return false;
  hit.t = t;
  hit.n = n;
  return true;
}
