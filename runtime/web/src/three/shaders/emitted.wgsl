// What the asset emits to the viewer; its point may be another than that of the lights' functions.
fn emitted(primitive: u32, x: vec3f, wo: vec3f) -> vec3f {
    let color = vertex.base_color;
    let is_there = begin(primitive, x, wo, 0.0) != 0.0;
    vertex.base_color = color;
    if !is_there {
        return vec3f(0.0);
    }
    return rnae_query(vertex.x, vertex.axis, vertex.h, wo, wo, vec3f(1.0), vec4f(0.0)).visible;
}
