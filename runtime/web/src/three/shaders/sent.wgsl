// Radiance for irradiance 1 from wi, at a visibility of its own. The rest: of nearby_of.
fn sent(wi: vec3f, visibility: f32, far: f32, columns: f32, turn: f32) -> vec3f {
    let v = vertex;
    let colours = rna_query(v.x, v.axis, v.h, v.wo, wi, v.base_color, nearby_of(wi, far, columns, turn));
    return mix(colours.shadowed, colours.visible, visibility);
}
