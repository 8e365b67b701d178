// Lobes of the transport for light from whole environments: spec/RNA.md, 12, RNA_environment. Whoever composes the files
// declares RNA_LOBES, RNA_IS_FIBER (1 or 0) and RNA_VISIBILITY_GROUPS: 4, or 0 of parts without harmonics.

const RNA_AXIS_SHIFT: f32 = 8.0;
const RNA_LEAST_KAPPA: f32 = 0.01;
const RNA_WIDE: f32 = 2.0; // kappa of a lobe that the decoder leaves as it is, of the first half
const RNA_SHARP: f32 = 10.0; // and of the rest

struct RnaLobe {
    amplitude: vec3f,
    kappa: f32,
    axis: vec3f, // its length is kappa, but for those below RNA_LEAST_KAPPA
}

// Runs the decoder. m: the mirror direction. visibility: harmonics of the asset's own, coefficients. The result is where
// rna_lobe finds its values.
fn rna_run_lobes(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, m: vec3f, visibility: array<vec4f, 4>,
) -> u32 {
    rna_put_queries(x, axis, h, wo, m, axis); // the half vector of surfaces is n
    let first = rna_part.query_groups - RNA_VISIBILITY_GROUPS;
    for (var k = 0u; k < RNA_VISIBILITY_GROUPS; k++) {
        rna_values[first + k] = visibility[k];
    }
    return rna_run_decoder();
}

fn rna_three(place: u32, k: u32) -> vec3f {
    return max(rna_columns(place, k), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), clamp(free, 0.0, 1.0));
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
