// The base colour of an asset's hit: spec/RNA.md, 4.6. Its surface has the factor, and the image as texture BASE.

// Texture coordinates of the triangle's corners in the image.
fn corners_in_image(texture: u32, record: RnaPrimitive) -> mat3x2f {
    let uv = corner_uvs(record, 0u);
    return mat3x2f(
        image_place(texture, uv[0]), image_place(texture, uv[1]), image_place(texture, uv[2]),
    );
}

// place: in the image.
fn base_color_at(surface: u32, place: vec2f, level: f32) -> vec3f {
    let image = image_of(surface_textures(surface, BASE));
    return surface_base_color(surface) * rna_image_color_at(image, place, level);
}

fn base_color_of_level(record: RnaPrimitive, b1: f32, b2: f32, level: f32) -> vec3f {
    let surface = rna_surface(record);
    let texture = surface_textures(surface, BASE);
    if texture == NONE {
        return surface_base_color(surface);
    }
    return base_color_at(surface, corners_in_image(texture, record) * weights_of(b1, b2), level);
}

// width: of a pixel at the hit, object space; 0 for the image as it is.
fn base_color_on(record: RnaPrimitive, b1: f32, b2: f32, width: f32) -> vec3f {
    let surface = rna_surface(record);
    let texture = surface_textures(surface, BASE);
    if texture == NONE {
        return surface_base_color(surface);
    }
    let p = mat3x3f(rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz);
    let uv = corners_in_image(texture, record);
    let level = rna_level_for(image_of(texture), p, uv, width);
    return base_color_at(surface, uv * weights_of(b1, b2), level);
}
