// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;
const BENT: f32 = 0x1p100f; // density of directions that no sample of a light finds: those behind solid glass

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> queries: array<PathQueries>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY] += vec4f(radiance, 0.0);
    let group = light_group(light);
    if group != NONE {
        sums[at + SUM_GROUPS + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Clamped after two or more scatterings.
fn clamped(radiance: vec3f) -> vec3f {
    if frame.clamp <= 0.0 || frame.depth < 2u {
        return radiance;
    }
    let largest = max(max(radiance.x, max(radiance.y, radiance.z)), 1e-30);
    return radiance * (min(frame.clamp, largest) / largest);
}

// Power heuristic: the part of the estimate that belongs to the first way.
fn share(pdf: f32, other: f32) -> f32 {
    if pdf <= 0.0 {
        return 0.0;
    }
    let ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
