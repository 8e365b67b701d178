// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// Whoever composes the files declares RNA_COLOURS, those that the decoder gives; RNA_STRIDE, those of a row of the
// results; and RNA_FIRST, the place in the row where the decoder's begin.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_STRIDE * row + RNA_FIRST] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[RNA_STRIDE * row + 1u] = vec4f(result.shadowed, 0.0);
    }
}

@compute @workgroup_size(64)
fn rna_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= rna_row_count[0] {
        return;
    }
    let at = rna_rows[row];
    let finite = rna_is_finite(vec4<u32>(at.position, at.h)) && rna_is_finite(vec4<u32>(at.axis, 0u))
        && rna_is_finite(vec4<u32>(at.wo, 0u)) && rna_is_finite(vec4<u32>(at.wi, 0u));
    let base_color = vec3<u32>(at.red, at.green, at.blue);
    let known = (rna_part.factors == 0u || rna_is_finite(vec4<u32>(base_color, 0u)))
        && (rna_part.nearby_columns == 0u || at.has_nearby == 0u || rna_is_finite(vec4<u32>(at.nearby, 0u)));
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && known && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        let nearby = vec4f(bitcast<vec3f>(at.nearby), f32(at.has_nearby));
        let color = bitcast<vec3f>(base_color);
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i, color, nearby);
    }
    rna_write(row, result);
}
