// What a band of the picture holds between the kernels: of each pixel a row as rna_evaluate reads it, with four
// numbers in its free places, and what it weighs.

struct Row {
    position: vec4<u32>, // and h of a fiber, b1 of a surface
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the place of the primitive
    wi: vec4<u32>,       // and b2
}

@group(1) @binding(0) var<storage, read_write> rows: array<Row>;
@group(1) @binding(1) var<storage, read_write> through: array<vec4f>; // throughput

// The pixel of an invocation; beyond the band y is at least view.rows.
fn pixel_of(index: u32) -> vec2<u32> {
    return vec2<u32>(index % view.width, index / view.width);
}
