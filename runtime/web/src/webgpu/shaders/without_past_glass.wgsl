// What past_glass.wgsl has, for assets without glass beside them.

const HAS_GLASS = false;

fn past_glass(number: u32, pixel: Pixel, x: vec3f, arrival: Arrival) -> vec3f {
    return arrival.radiance;
}

fn seen_behind_glass(pixel: Pixel, ground: vec3f, coverage: f32) -> vec3f {
    return ground;
}
