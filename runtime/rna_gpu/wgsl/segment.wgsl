// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn rna_cone(point: u32) -> RnaCone {
    let a = rna_points[point];
    let b = rna_points[point + 1u];
    return RnaCone(a.xyz, a.w, b.xyz, b.w);
}

// Along d from p to where it enters the sphere; RNA_FAR where it does not.
fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    let v = p - centre;
    let along = dot(v, d);
    let rest = v - along * d;
    let h = radius * radius - dot(rest, rest);
    if h <= 0.0 {
        return RNA_FAR;
    }
    return -along - sqrt(h);
}

// How far p is outside of the cone; negative inside.
fn rna_cone_distance(cone: RnaCone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let size = length(axis);
    let dr = cone.ra - cone.rb;
    let v = p - cone.a;
    let y = dot(v, axis) / size;
    let x = length(v - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size <= abs(dr) {
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

struct RnaEntry {
    t: f32,
    u: f32, // of the sphere that touches the surface there: how far along the segment its middle is, 0 to 1
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. `from` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), select(1.0, 0.0, ta < tb), vec3f(0.0));
    entry.normal = p + entry.t * d - select(cone.b, cone.a, ta < tb);
    let axis = cone.b - cone.a;
    let v = p - cone.a;
    let dr = cone.ra - cone.rb;
    let squared = dot(axis, axis);
    let d2 = squared - dr * dr;
    let m1 = dot(axis, v);
    let m2 = dot(axis, d);
    let k2 = d2 - m2 * m2;
    let k1 = d2 * dot(d, v) - m1 * m2 + m2 * dr * cone.ra;
    let k0 = d2 * dot(v, v) - m1 * m1 + 2.0 * m1 * dr * cone.ra - squared * cone.ra * cone.ra;
    let h = k1 * k1 - k0 * k2;
    if d2 <= 0.0 || h < 0.0 || k2 == 0.0 {
        return entry;
    }
    for (var sign = -1.0; sign <= 1.0; sign += 2.0) {
        let side = (sign * sqrt(h) - k1) / k2;
        let y = m1 - cone.ra * dr + side * m2;
        let normal = d2 * (v + side * d) - axis * y;
        if y > 0.0 && y < d2 && side < entry.t && dot(normal, d) < 0.0 {
            entry = RnaEntry(side, y / d2, normal);
        }
    }
    return entry;
}

// Whether p, on a segment, is inside the one before or after it: there is no surface there.
fn rna_in_neighbour(segment: RnaPrimitive, p: vec3f) -> bool {
    if (segment.b & RNA_HAS_BEFORE) != 0u {
        let before = rna_cone(segment.a - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.b & RNA_HAS_AFTER) != 0u {
        let after = rna_cone(segment.a + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, 0.0, vec3f(0.0));
    let cone = rna_cone(segment.a);
    let shift = dot(0.5 * (cone.a + cone.b) - ray.origin, ray.direction);
    let p = ray.origin + shift * ray.direction;
    let entry = rna_enter_cone(cone, p, ray.direction);
    let t = entry.t + shift;
    if entry.t >= RNA_FAR || !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    if rna_in_neighbour(segment, p + entry.t * ray.direction) {
        return miss;
    }
    return RnaEntry(t, entry.u, normalize(entry.normal));
}
