// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
// a group of 4 columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// Writes `features`, `position`, `wo` and `wi`; returns the first three features.
fn rna_common_blocks(x: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let p = rna_relative(x);
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, 0 where they are opposite, for a vector across n, q and wi ("In
// float32": the difference of their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return vec3f(0.0);
    }
    return s / size;
}
