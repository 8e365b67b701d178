// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6; m: unit, or 0 for one across n
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(select(0.5 * dot(gap, gap), 1.0, all(m == vec3f(0.0))) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    let square = select(dot(aside, aside), 1.0, all(m == vec3f(0.0)));
    rna_put(slot, vec4f(log2(square + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, m: vec3f) {
    if slot == RNA_NONE {
        return;
    }
    var q = n + 0.1 * features;
    let size = length(q);
    if size < 1e-6 {
        q = n;
    } else {
        q = q / size;
    }
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

// m: of rna_halfway; of lobes n.
fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f, m: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, m);
}
