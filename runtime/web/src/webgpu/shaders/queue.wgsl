// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

@group(2) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(2) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

// What a light brings to the ground, and the coverage. `sums` are of the whole picture.
@compute @workgroup_size(64)
fn begin(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let is_query = band[k].axis.w != 0u;
    let covered = select(band[k].coverage, 1.0, is_query) * f32(view.counts_coverage);
    let before = select(sums[view.first + k], vec4f(0.0), view.is_first == 1u);
    sums[view.first + k] = before + vec4f(select(band[k].radiance, vec3f(0.0), is_query), covered);
}

// Whether a decoder, of visible or of shadowed light alone, adds something there.
fn counts(visibility: vec3f) -> bool {
    if view.form == FORM_VISIBLE {
        return any(visibility > vec3f(0.0));
    }
    return view.form != FORM_SHADOWED || any(visibility < vec3f(1.0));
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part || !counts(band[k].visibility) {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    let color = bitcast<vec3<u32>>(pixel.base_color);
    let detail = vec3<u32>(pack2x16float(pixel.detail.xy), pack2x16float(pixel.detail.zz), bitcast<u32>(free));
    let more = select(color, detail, view.form == FORM_ENVIRONMENT);
    rows[at] = RnaRow(
        pixel.position.xyz, pixel.position.w, pixel.axis.xyz, more.x, pixel.wo.xyz, more.y, wi.xyz, more.z,
        bitcast<vec3<u32>>(pixel.nearby), 1u,
    );
}

@compute @workgroup_size(64)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let k = atomicLoad(&count[at + 1u]);
    let pixel = band[k];
    var radiance = pixel.through * answers[at].xyz;
    if view.form <= FORM_SHADOWED {
        var transport = vec3f(0.0);
        if view.form != FORM_SHADOWED {
            transport = pixel.visibility * answers[2u * at].xyz;
        }
        if view.form != FORM_VISIBLE {
            transport += (1.0 - pixel.visibility) * answers[2u * at + select(0u, 1u, view.form == FORM_TRANSPORT)].xyz;
        }
        radiance = pixel.radiance * transport;
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
