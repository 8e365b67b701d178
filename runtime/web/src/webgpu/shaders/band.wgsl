// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light: LIGHT_SUN and so on
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // of the queries, + 1
    form: u32,     // of the answers: up to FORM_SHADOWED two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    light_width: u32, // of the picture that has the first look's light, pixels
    light_height: u32,
    shares: f32,   // rays a pixel of the first look's edges
    texel: f32,    // of the lobes' planes, object space
    light_scale: vec2f, // width and height of that picture over those of the band's
    lengths: vec3f, // of the nearby light that the part counts
    number: u32,    // of the light
}

const FORM_TRANSPORT = 0u;
const FORM_VISIBLE = 1u;
const FORM_SHADOWED = 2u;
const FORM_EMISSION = 3u;
const FORM_ENVIRONMENT = 4u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber; where nothing is hit, the start of the ray
    axis: vec4<u32>,     // and part + 1; or 0 where nothing is hit, with BENT_AWAY first if that is behind glass
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
    base_color: vec3f,
    detail: vec3f, // factor of the lobes' first half
    nearby: vec3f, // nearby light, where the part counts it
}

const BENT_AWAY = 1u;

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
