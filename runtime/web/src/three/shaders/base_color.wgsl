// The base colour of a point: of its surface the factor, and the image's record and levels, in one buffer of words.

fn rna_image_word(at: u32) -> u32 {
    return rna_images[at];
}

fn image_vector(at: u32) -> vec3f {
    return bitcast<vec3f>(vec3<u32>(rna_images[at], rna_images[at + 1u], rna_images[at + 2u]));
}

fn uv_of(point: u32) -> vec3f {
    return vec3f(rna_points[point].w, rna_points[NORMALS_AT + point].w, 1.0);
}

// width: of a pixel at the point.
fn base_color_on(record: RnaPrimitive, p: mat3x3f, b: vec3f, width: f32) -> vec3f {
    let surface = SURFACE_WORDS * (record.tag >> RNA_SURFACE_SHIFT);
    let factor = image_vector(surface + SURFACE_BASE_COLOR);
    let number = rna_images[surface + SURFACE_IMAGE];
    if number == RNA_NONE {
        return factor;
    }
    let texture = TEXTURES_AT + TEXTURE_WORDS * number;
    let size = rna_images[texture + TEXTURE_SIZE];
    let image = RnaImage(
        IMAGES_AT + rna_images[texture + TEXTURE_PLACE], vec2<u32>(size & 0xffffu, size >> 16u), rna_images[texture + TEXTURE_FORM],
    );
    let to_u = image_vector(texture + TEXTURE_ROW_U);
    let to_v = image_vector(texture + TEXTURE_ROW_V);
    let uvs = mat3x3f(uv_of(record.a), uv_of(record.b), uv_of(record.c));
    let u = to_u * uvs;
    let v = to_v * uvs;
    let places = mat3x2f(u.x, v.x, u.y, v.y, u.z, v.z);
    return factor * rna_image_color_at(image, places * b, rna_level_for(image, p, places, width));
}
