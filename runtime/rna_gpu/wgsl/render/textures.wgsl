// Textures on triangles: rna_render/materials/textures.py.

fn rna_image_word(at: u32) -> u32 {
    return images[at];
}

fn image_of(texture: u32) -> RnaImage {
    let size = texture_size(texture);
    return RnaImage(texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture));
}

// From coordinates of the mesh to the image's.
fn image_place(texture: u32, uv: vec2f) -> vec2f {
    let at = vec3f(uv, 1.0);
    return vec2f(dot(texture_row_u(texture), at), dot(texture_row_v(texture), at));
}

// At the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    return rna_image_color(image_of(texture), image_place(texture, uv));
}

// On a triangle at barycentrics.
fn texture_on(texture: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    return surface_emission(rna_surface(record)) * factor_on(GLOW, record, b1, b2);
}
