// A point that three.js has rasterised, as rna_gpu's functions want it: object space, metres.

struct Vertex {
    x: vec3f,
    n: vec3f, // interpolated normal; of strands that of the round surface
    ng: vec3f,
    lift: vec3f,
    axis: vec3f, // what the decoder is asked with: normal or tangent
    h: f32,
    strand: u32,
    surface: u32, // number of it
    wo: vec3f,
    base_color: vec3f,
}

var<private> vertex: Vertex; // of this fragment
