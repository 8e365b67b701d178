// What render/base_color.wgsl has, for assets without it.

fn base_color_on(record: RnaPrimitive, b1: f32, b2: f32, width: f32) -> vec3f {
    return vec3f(1.0);
}

fn base_color_of_level(record: RnaPrimitive, b1: f32, b2: f32, level: f32) -> vec3f {
    return vec3f(1.0);
}
