// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

struct Frame {
    camera: vec3f,
    width: u32,
    corner: vec3f, // direction through the image's top left corner
    textures: u32, // as `things` below
    step_x: vec3f, // of a pixel
    paths: u32,
    step_y: vec3f,
    sample: u32,
    seed: u32,
    depth: u32, // points of the path so far
    light: u32, // that is sampled; NONE: one that is chosen
    part: u32, // number of the sample of this light at this point
    parts: u32, // samples of this light at this point
    rays: u32, // bit of the sort of rays: 1 camera, 2 indirect, 4 shadow
    clamp: f32,
    light_count: u32,
    things: u32, // places of the sections of `table`
    surfaces: u32,
    lights: u32,
    albedo: u32,
    sums: u32, // vec4f a path: beauty, normal and hit, position and number, lights, behind catcher
    flags: u32, // of those below
    neural_part: u32,
    table_size: u32, // of albedo
    domains: u32,
}

const NONE: u32 = 0xffffffffu;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u; // something lets light through
const IS_LIGHT: u32 = 0x80000000u; // with a light's number, in place of an instance
const PI: f32 = 3.14159265358979;
const SHADOW_RAY: u32 = 4u;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const LIGHT_SIZE: u32 = 8u; // vec4f of a light in `table`, see lights.wgsl

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;

struct Path {
    origin: vec3f,
    pixel: u32,
    direction: vec3f,
    pdf: f32, // of the direction; 0 of camera rays
    beta: vec3f,
    state: u32,
    normal: vec3f, // of a segment
    t: f32,
    instance: u32,
    primitive: u32,
    own: u32, // instance that the ray passes through
    b1: f32,
    leaving: vec3f, // of a ray that leaves an asset: its start in object space
    b2: f32,
}

// A query of a decoder: its row, and what becomes of the result. A path has two: what its point
// sends on, and what an asset emits that its point samples as a light.
struct Pending {
    x: vec3f,
    h: f32,
    axis: vec3f,
    part: u32, // or one of those below
    wo: vec3f,
    light: u32,
    wi: vec3f,
    strand: u32, // that a ray from here passes through
    weight: vec3f,
    seen: f32, // mean of what all that is in the way leaves of the light
    visible: vec3f, // what the asset itself leaves of it
    reserved: u32,
}

const ADDS: u32 = 0xfffffffeu; // parts, beside NONE: no decoder is asked what is sent on
const CATCHES_IT: u32 = 0xfffffffdu; // a shadow catcher

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> pendings: array<Pending>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at] += vec4f(radiance, 0.0);
    let group = bitcast<u32>(table[frame.lights + LIGHT_SIZE * light].y);
    if group != NONE {
        sums[at + 5u + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Not above the clamp where light left more than one thing.
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
