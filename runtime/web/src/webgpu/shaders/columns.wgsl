// Inputs of decoders of lobes: the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn write_visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= count[0] {
        return;
    }
    let pixel = band[count[at + 1u]];
    let record = primitives[pixel.wo.w];
    let is_segment = (record.tag & RNA_IS_SEGMENT) != 0u;
    let second = select(record.b, record.a + 1u, is_segment);
    let third = select(record.c, record.a, is_segment);
    for (var k = 0u; k < 4u; k++) {
        let first = (1.0 - pixel.b1 - pixel.b2) * harmonic(record.a, k);
        columns[4u * at + k] = first + pixel.b1 * harmonic(second, k) + pixel.b2 * harmonic(third, k);
    }
}
