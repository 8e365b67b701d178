// One part of a tier as the GPU sees it: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.
// The layout of RnaPart is in README.md; `part_uniform.py` packs it.

const RNA_NONE: u32 = 0xffffffffu;
const RNA_FLOAT32: u32 = 0u; // planePrecision
const RNA_FLOAT16: u32 = 1u;
const RNA_INT8: u32 = 2u;

// A layer of the decoder. Sizes count groups of 4 columns, places count vec4f of the weights.
struct RnaLayer {
    inputs: u32,
    outputs: u32,
    weights: u32, // [outputs][inputs][4] vec4f
    bias: u32, // [outputs] vec4f
    units: u32, // [outputs] vec4f of an int8 layer: what a sum of 1 means
    relu: u32, // 1: negative results are 0
    int8_step: f32, // of an int8 layer: what 1 means in its inputs; else 0
    reserved: u32,
}

struct RnaPart {
    low: vec3f, // bounds
    resolution: u32,
    high: vec3f,
    channel_groups: u32,
    query_groups: u32, // of the decoder's input
    layer_count: u32,
    plane_precision: u32,
    gain: u32, // place of [query_groups] gains, then as many offsets; RNA_NONE without
    query_low: f32, // the decoder's first Clip
    query_high: f32,
    top: f32, // of the Clip before Exp
    unit: f32, // result = (exp(x) - 1) unit, or times the matrix
    matrix: RnaLayer, // inputs 0 without one
    // First group of each input block in the queries, RNA_NONE for a block that is not there:
    // features, position, normal, tangent | h, wo, wi, half_vector |
    // highlight, learned_normal, fiber_angles, fiber_lobes
    slots: array<vec4<u32>, 3>,
    scales: array<vec4f, 48>, // of int8 planes: [plane][16] groups of channels
    layers: array<RnaLayer, 32>,
}

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
