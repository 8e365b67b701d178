// Where a ray meets a triangle or a round segment.

// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides.
struct Shear {
    axes: vec3<u32>,
    s: vec3f,
}

fn shear_of(d: vec3f) -> Shear {
    let a = abs(d);
    var z = select(1u, 0u, a.x > a.y);
    if a.z > a[z] {
        z = 2u;
    }
    let x = (z + 1u) % 3u;
    let y = (z + 2u) % 3u;
    return Shear(vec3<u32>(x, y, z), vec3f(d[x], d[y], 1.0) / d[z]);
}

fn sheared(p: vec3f, shear: Shear) -> vec3f {
    let z = p[shear.axes.z];
    return vec3f(vec2f(p[shear.axes.x], p[shear.axes.y]) - shear.s.xy * z, z);
}

fn meets_triangle(primitive: vec4<u32>, origin: vec3f, shear: Shear, far: f32, hit: ptr<function, Hit>) -> bool {
    let a = sheared(vertices[primitive.x].xyz - origin, shear);
    let b = sheared(vertices[primitive.y].xyz - origin, shear);
    let c = sheared(vertices[primitive.z].xyz - origin, shear);
    let u = vec3f(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
    if min(u.x, min(u.y, u.z)) < 0.0 && max(u.x, max(u.y, u.z)) > 0.0 {
        return false;
    }
    let sum = u.x + u.y + u.z;
    if sum == 0.0 {
        return false;
    }
    let t = dot(u, vec3f(a.z, b.z, c.z)) * shear.s.z / sum;
    if !(t >= 0.0 && t < far) {
        return false;
    }
    (*hit).t = t;
    (*hit).number = primitive.w;
    (*hit).b1 = u.y / sum;
    (*hit).b2 = u.z / sum;
    return true;
}

struct Cone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn cone_at(point: u32) -> Cone {
    let a = vertices[point];
    let b = vertices[point + 1u];
    return Cone(a.xyz, a.w, b.xyz, b.w);
}

// The entry into a sphere, from a point near it; `between`: from its centre to that point.
fn enters_sphere(between: vec3f, d: vec3f, radius: f32) -> f32 {
    let along = dot(between, d);
    let across = between - along * d;
    let h = radius * radius - dot(across, across);
    if h <= 0.0 {
        return FAR;
    }
    return -along - sqrt(h);
}

struct Entry {
    t: f32, // FAR without one
    n: vec3f,
}

// The first of all points where the line enters one of the two spheres or the side between them.
fn enters_cone(cone: Cone, origin: vec3f, d: vec3f) -> Entry {
    let axis = cone.b - cone.a;
    // From the point of the line nearest to the segment, so that distances do not cancel.
    let shift = dot(0.5 * (cone.a + cone.b) - origin, d);
    let near = (origin - cone.a) + shift * d;
    let dr = cone.ra - cone.rb;
    let length2 = dot(axis, axis);
    let d2 = length2 - dr * dr;
    let ta = enters_sphere(near, d, cone.ra);
    let tb = enters_sphere(near - axis, d, cone.rb);
    var t = min(ta, tb);
    var n = near + t * d - select(axis, vec3f(0.0), ta < tb);
    if d2 > 0.0 {
        let m1 = dot(axis, near);
        let m2 = dot(axis, d);
        let m3 = dot(d, near);
        let k2 = d2 - m2 * m2;
        let k1 = d2 * m3 - m1 * m2 + m2 * dr * cone.ra;
        let k0 = d2 * dot(near, near) - m1 * m1 + 2.0 * m1 * dr * cone.ra - length2 * cone.ra * cone.ra;
        let h = k1 * k1 - k0 * k2;
        if h >= 0.0 && k2 != 0.0 {
            for (var k = 0; k < 2; k++) {
                let side = (-k1 + select(-1.0, 1.0, k == 1) * sqrt(h)) / k2;
                let y = m1 - cone.ra * dr + side * m2;
                let normal = d2 * (near + side * d) - axis * y;
                if y > 0.0 && y < d2 && side < t && dot(normal, d) < 0.0 {
                    t = side;
                    n = normal;
                }
            }
        }
    }
    if t > 0.9 * FAR {
        return Entry(FAR, vec3f(0.0));
    }
    return Entry(t + shift, unit(n));
}

// How far p is outside of the cone; negative inside.
fn distance_to(cone: Cone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let near = p - cone.a;
    let dr = cone.ra - cone.rb;
    let size = length(axis);
    let y = dot(near, axis) / size;
    let x = length(near - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size * size <= dr * dr {
        return select(to_b, to_a, dr > 0.0);
    }
    let slope = dr / size;
    let lean = sqrt(1.0 - slope * slope);
    let along = y * lean - x * slope;
    if along <= 0.0 {
        return to_a;
    }
    if along >= size * lean {
        return to_b;
    }
    return x * lean + y * slope - cone.ra;
}

// An entry inside the segment before or after is no surface.
fn inside_neighbour(point: u32, neighbours: u32, p: vec3f) -> bool {
    for (var k = 0u; k < 2u; k++) {
        if (neighbours & (1u + k)) == 0u {
            continue;
        }
        let cone = cone_at(point + 2u * k - 1u);
        if distance_to(cone, p) < -1e-4 * min(cone.ra, cone.rb) {
            return true;
        }
    }
    return false;
}

fn meets_segment(primitive: vec4<u32>, origin: vec3f, d: vec3f, far: f32, hit: ptr<function, Hit>) -> bool {
    let entry = enters_cone(cone_at(primitive.x), origin, d);
    if !(entry.t >= 0.0 && entry.t < far) {
        return false;
    }
    if inside_neighbour(primitive.x, primitive.z, origin + entry.t * d) {
        return false;
    }
    (*hit).t = entry.t;
    (*hit).number = primitive.w;
    (*hit).n = entry.n;
    return true;
}
