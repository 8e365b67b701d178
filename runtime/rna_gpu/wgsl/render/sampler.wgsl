// Owen-scrambled Sobol' points, the very ones of rna_render.paths.sampling: a pure function of seed, pixel,
// sample and dimension.

fn hash_bits(value: u32) -> u32 {
    var x = (value ^ (value >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
fn owen(value: u32, seed: u32) -> u32 {
    var x = reverseBits(value) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

fn second_sobol(index: u32) -> u32 {
    var x = reverseBits(index);
    x ^= x << 16u;
    x ^= (x & 0x00ff00ffu) << 8u;
    x ^= (x & 0x0f0f0f0fu) << 4u;
    x ^= (x & 0x33333333u) << 2u;
    return x ^ ((x & 0x55555555u) << 1u);
}

// A point of the unit square for a dimension of the path at its present point.
fn square(pixel: u32, dimension: u32, number: u32) -> vec2f {
    let image_key = hash_bits(hash_bits(frame.seed) + dimension);
    let key = hash_bits(image_key ^ hash_bits(pixel + 1u));
    let index = owen(number, key);
    let first = owen(reverseBits(index), hash_bits(key + 1u));
    let second = owen(second_sobol(index), hash_bits(key + 2u));
    return vec2f(f32(first >> 8u), f32(second >> 8u)) * 0x1p-24f;
}

// Number of the path among all of its pixel that have come to this point.
fn path_of_pixel() -> u32 {
    return frame.sample * frame.branches + frame.branch;
}

fn at_point(pixel: u32, dimension: u32) -> vec2f {
    return square(pixel, (frame.depth - 1u) * DIMENSIONS + dimension, path_of_pixel());
}

// For the sample of a light that the step is about, or its nearby light.
fn at_light_sample(pixel: u32, dimension: u32) -> vec2f {
    let which = select(frame.light, 0u, frame.light == NONE);
    let of_light = (frame.depth - 1u) * DIMENSIONS + dimension + which;
    return square(pixel, of_light, path_of_pixel() * frame.parts + frame.part);
}

// What a path's next ray passes at random through.
fn chance_of(pixel: u32) -> u32 {
    let path = hash_bits(hash_bits(frame.seed + 1u) ^ hash_bits(pixel + 1u));
    return hash_bits(hash_bits(path ^ path_of_pixel()) + frame.depth);
}
