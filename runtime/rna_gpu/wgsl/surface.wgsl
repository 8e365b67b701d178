// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi, and one without factors no base colour. nearby: nearby light, and 1; with a 0 behind it the part's means
// stand in.
fn rna_surface(
    x: vec3f, n: vec3f, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi, rna_halfway(wo, wi));
    return rna_decode(base_color, nearby);
}

// m: the half vector.
fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    let p = rna_relative(x);
    rna_surface_blocks(p, n, rna_put_features(p), wo, wi, m);
}

fn rna_query(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    return rna_surface(x, axis, wo, wi, base_color, nearby);
}
