// Radiance for irradiance 1 from wi, at a visibility of its own: by the decoder of visible or of shadowed light, or both.
fn sent(wi: vec3f, visibility: f32) -> vec3f {
    let v = vertex;
    var result = vec3f(0.0);
    if visibility > 0.0 {
        result = visibility * rna_query(v.x, v.axis, v.h, v.wo, wi, v.base_color).visible;
    }
    if visibility < 1.0 {
        result += (1.0 - visibility) * rnas_query(v.x, v.axis, v.h, v.wo, wi, v.base_color).visible;
    }
    return result;
}
