// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi. nearby: as of a surface.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f, nearby: vec4f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi, wi);
    return rna_decode(vec3f(1.0), nearby);
}

// The last argument is the half vector of surfaces.
fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f, m: vec3f) {
    let p = rna_relative(x);
    rna_put_features(p);
    rna_fiber_blocks(p, t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f, base_color: vec3f, nearby: vec4f,
) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi, nearby);
}
