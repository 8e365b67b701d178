// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
