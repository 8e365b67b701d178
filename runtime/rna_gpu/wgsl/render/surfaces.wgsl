// Surfaces of the scene, by the number that primitives have; scene_surfaces.py fills them.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

fn surface_has(surface: u32, flag: u32) -> bool {
    return (surface_flags(surface) & flag) != 0u;
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = surface_second_uvs(surface) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: RnaPrimitive, uv_set: u32) -> mat3x2f {
    let surface = rna_surface(record);
    return mat3x2f(
        corner_uv(surface, record.a, uv_set),
        corner_uv(surface, record.b, uv_set),
        corner_uv(surface, record.c, uv_set),
    );
}

fn point_color(base: u32, point: u32) -> vec3f {
    let at = base + 3u * point;
    return bitcast<vec3f>(vec3<u32>(images[at], images[at + 1u], images[at + 2u]));
}

// The colour of the vertices, interpolated; 1 without.
fn vertex_color(surface: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let base = surface_colors(surface);
    if base == NONE {
        return vec3f(1.0);
    }
    let corners = mat3x3f(point_color(base, record.a), point_color(base, record.b), point_color(base, record.c));
    return corners * weights_of(b1, b2);
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
