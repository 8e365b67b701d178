// Normals of materials with the relief of a normal texture: rna_render/materials/bumps.py.

const MIN_MIRROR_COSINE: f32 = 0.01;

fn unit_or_zero(v: vec3f) -> vec3f {
    let size = length(v);
    return select(vec3f(0.0), v / max(size, 1e-30), size > 0.0);
}

fn point_tangent(base: u32, point: u32) -> vec4f {
    let at = base + 4u * point;
    return bitcast<vec4f>(vec4<u32>(images[at], images[at + 1u], images[at + 2u], images[at + 3u]));
}

// The file's tangent, interpolated, and the bitangent's sign; a sign of 0 where a corner has none.
fn given_tangent(record: RnaPrimitive, b: vec3f) -> vec4f {
    let base = surface_tangents(rna_surface(record));
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.a);
    let second = point_tangent(base, record.b);
    let third = point_tangent(base, record.c);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: RnaPrimitive, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = select(1.0, -1.0, area < 0.0);
    let along_u = side * (d2.y * e1 - d1.y * e2);
    let along_v = side * (d1.x * e2 - d2.x * e1);
    let sign = select(1.0, -1.0, dot(cross(n, along_u), along_v) > 0.0);
    return vec4f(along_u, select(0.0, sign, area != 0.0));
}

// m, or the nearest normal that mirrors o above the surface; g is on o's side.
fn raised_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: RnaPrimitive, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(rna_surface(record), RELIEF);
    if texture == NONE {
        return m;
    }
    let uvs = corner_uvs(record, (image_of(texture).form >> 5u) & 1u);
    let b = weights_of(b1, b2);
    var tangent = given_tangent(record, b);
    if tangent.w == 0.0 {
        tangent = derived_tangent(record, uvs, m);
    }
    let t = unit_or_zero(tangent.xyz - dot(tangent.xyz, m) * m);
    if tangent.w == 0.0 || dot(t, t) == 0.0 {
        return m;
    }
    let scale = surface_normal_scale(rna_surface(record));
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let side_of_m = select(-side, side, dot(m, g) >= 0.0);
    return side_of_m * raised_above(side_of_m * bent, side * g, o);
}
