// Radiance for irradiance 1 from wi, at a visibility of its own.
fn sent(wi: vec3f, visibility: f32) -> vec3f {
    let v = vertex;
    let colours = rna_query(v.x, v.axis, v.h, v.wo, wi, v.base_color);
    return mix(colours.shadowed, colours.visible, visibility);
}
