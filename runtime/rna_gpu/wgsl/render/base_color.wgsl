// The base colour of an asset's hit: spec/RNA.md, 4.6. Its surface has the factor, and the image as texture BASE.

// Texture coordinates of the triangle's corners in the image.
fn corners_in_image(texture: u32, record: RnaPrimitive) -> mat3x2f {
    let uv = corner_uvs(record, 0u);
    return mat3x2f(
        image_place(texture, uv[0]), image_place(texture, uv[1]), image_place(texture, uv[2]),
    );
}

fn base_color_of_level(record: RnaPrimitive, b1: f32, b2: f32, level: f32) -> vec3f {
    let surface = rna_surface(record);
    let factor = surface_base_color(surface);
    let texture = surface_textures(surface, BASE);
    if texture == NONE {
        return factor;
    }
    let place = corners_in_image(texture, record) * weights_of(b1, b2);
    return factor * rna_image_color_at(image_of(texture), place, level);
}

// width: of a pixel at the hit, object space; 0 for the image as it is.
fn base_color_on(record: RnaPrimitive, b1: f32, b2: f32, width: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), BASE);
    var level = 0.0;
    if texture != NONE {
        let p = mat3x3f(rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz);
        level = rna_level_for(image_of(texture), p, corners_in_image(texture, record), width);
    }
    return base_color_of_level(record, b1, b2, level);
}
