// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
