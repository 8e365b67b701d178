// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
// recurrence in four dimensions (Roberts 2018), so that the samples of a pixel are spread evenly. All others: hashed.

fn hashed(x: u32) -> u32 { // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

const PLACE = 0u;
const DIRECTION = 1u;
const STOPPED = 2u; // and those behind it

fn random(pixel: vec2<u32>, dimension: u32) -> vec2f {
    let own = select(0u, view.sample, dimension >= STOPPED);
    let seed = hashed(pixel.x + hashed(pixel.y + hashed(dimension + hashed(own))));
    let start = vec2f(f32(seed >> 8u), f32(hashed(seed) >> 8u)) / 16777216.0;
    if dimension >= STOPPED {
        return start;
    }
    // In whole numbers: floats of later samples would lose digits.
    let turn = select(vec2<u32>(3679390609u, 3152041523u), vec2<u32>(2700274805u, 2313257605u), dimension == DIRECTION);
    return fract(start + vec2f((turn * view.sample) >> vec2<u32>(8u)) / 16777216.0);
}
