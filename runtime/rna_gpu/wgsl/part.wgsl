// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}
