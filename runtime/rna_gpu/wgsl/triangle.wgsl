// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
// Ray/Triangle Intersection (JCGT 2(1), 2013).

// Coordinates with the ray's largest one last.
fn rna_turned(v: vec3f, axis: u32) -> vec3f {
    if axis == 0u {
        return v.yzx;
    }
    if axis == 1u {
        return v.zxy;
    }
    return v;
}

fn rna_largest_axis(d: vec3f) -> u32 {
    let size = abs(d);
    if size.x > size.y && size.x > size.z {
        return 0u;
    }
    return select(2u, 1u, size.y > size.z);
}

// t by the triangle's plane, or `t` where that is nearer to the truth: a plane across an axis is exact however wide
// it is, and the other loses 2^-24 of the corners' distance; of slivers the plane is uncertain.
fn rna_distance(ray: RnaRay, way: vec3f, e1: vec3f, e2: vec3f, t: f32, depth: f32) -> f32 {
    let n = cross(e1, e2);
    let size = rna_box_size(e1, e2);
    let uncertain = dot(abs(way), size.yzx * size.zxy);
    let along = dot(n, ray.direction);
    let is_better = along != 0.0 && uncertain < depth * max(abs(n.x), max(abs(n.y), abs(n.z)));
    return select(t, dot(n, way) / along, is_better);
}

// (t, b1, b2), t of RNA_FAR for a miss.
fn rna_meet_triangle(ray: RnaRay, p0: vec3f, p1: vec3f, p2: vec3f) -> vec3f {
    let miss = vec3f(RNA_FAR, 0.0, 0.0);
    let axis = rna_largest_axis(ray.direction);
    let d = rna_turned(ray.direction, axis);
    let shear = vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z);
    let a = rna_turned(p0 - ray.origin, axis);
    let b = rna_turned(p1 - ray.origin, axis);
    let c = rna_turned(p2 - ray.origin, axis);
    let a2 = a.xy - shear.xy * a.z;
    let b2 = b.xy - shear.xy * b.z;
    let c2 = c.xy - shear.xy * c.z;
    let u = c2.x * b2.y - c2.y * b2.x;
    let v = a2.x * c2.y - a2.y * c2.x;
    let w = b2.x * a2.y - b2.y * a2.x;
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return miss;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return miss;
    }
    let depth = max(abs(a.z), max(abs(b.z), abs(c.z)));
    let mixed = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
    let t = rna_distance(ray, p0 - ray.origin, p1 - p0, p2 - p0, mixed, depth);
    if !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    return vec3f(t, v / sum, w / sum);
}
