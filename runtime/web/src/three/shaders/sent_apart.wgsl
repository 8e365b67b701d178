// Radiance for irradiance 1 from wi, at a visibility of its own: by the decoder of visible or of shadowed light, or both.
// The rest: of nearby_of.
fn sent(wi: vec3f, visibility: f32, far: f32, columns: f32, turn: f32) -> vec3f {
    let v = vertex;
    let nearby = nearby_of(wi, far, columns, turn);
    var result = vec3f(0.0);
    if visibility > 0.0 {
        result = visibility * rna_query(v.x, v.axis, v.h, v.wo, wi, v.base_color, nearby).visible;
    }
    if visibility < 1.0 {
        result += (1.0 - visibility) * rnas_query(v.x, v.axis, v.h, v.wo, wi, v.base_color, nearby).visible;
    }
    return result;
}
