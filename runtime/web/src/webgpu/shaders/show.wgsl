// The picture on the page: mean of the samples, exposure, sRGB.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec3f, // linear light of the screen
    rounds: f32,
    exposure: f32,  // a factor
    unused_a: f32,
    unused_b: f32,
    unused_c: f32,
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    return sums[place.y * u32(shown.picture.x) + place.x];
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y) / shown.rounds;
    let linear = clamp(mean.xyz * shown.exposure, vec3f(0.0), vec3f(1.0)) + max(0.0, 1.0 - mean.w) * shown.backdrop;
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return vec4f(clamp(encoded, vec3f(0.0), vec3f(1.0)), 1.0);
}
