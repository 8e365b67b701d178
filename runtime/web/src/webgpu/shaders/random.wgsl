// Numbers in [0, 1): of each pixel and dimension a start of its own, and from there the additive recurrence
// with the plastic number (Roberts 2018), so that the samples of a pixel are spread evenly.

fn hashed(x: u32) -> u32 { // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

fn random(pixel: vec2<u32>, dimension: u32) -> vec2f {
    let seed = hashed(pixel.x + hashed(pixel.y + hashed(dimension)));
    let start = vec2f(f32(seed >> 8u), f32(hashed(seed) >> 8u)) / 16777216.0;
    // In whole numbers: floats of later samples would lose digits.
    let turned = vec2<u32>(3242174889u, 2447445414u) * view.sample;
    return fract(start + vec2f(turned >> vec2<u32>(8u)) / 16777216.0);
}
