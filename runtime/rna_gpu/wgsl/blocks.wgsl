// Where input blocks are written: spec/RNA.md, 6.3 Input blocks. Each block starts at a group of 4
// columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// The largest absolute component.
fn rna_largest(v: vec3f) -> f32 {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

// Writes `features`; returns the first three. p: of rna_relative.
fn rna_put_features(p: vec3f) -> vec3f {
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    return first.xyz;
}
