// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; blue: its visibility; red and green: Pixel.detail, halves
@group(1) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(1) @binding(2) var<storage, read> count: array<u32>; // [0]
@group(1) @binding(3) var<storage, read> columns: array<vec4f>; // 4 a row
@group(2) @binding(0) var<uniform> light: LobeLight;
@group(2) @binding(1) var prefiltered: texture_2d_array<f32>;
@group(2) @binding(2) var smooth_sampler: sampler;

fn mean_under(lobe: RnaLobe) -> vec3f {
    let d = lobe.axis;
    let x = light.turn.x * d.x - light.turn.y * d.z;
    let z = light.turn.y * d.x + light.turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    let azimuth = select(0.0, atan2(x, -z), sine > 0.0);
    let size = vec2f(textureDimensions(prefiltered));
    let polar = atan2(sine, d.y) / 3.14159265; // the first row is one pole, the last one the other
    let place = vec2f(0.5 + azimuth / 6.28318531, (polar * (size.y - 1.0) + 0.5) / size.y);
    let level = clamp(log2(lobe.kappa / light.least_kappa) * light.an_octave, 0.0, light.levels - 1.0);
    let wide = u32(level);
    let a = textureSampleLevel(prefiltered, smooth_sampler, place, wide, 0.0).xyz;
    let b = textureSampleLevel(prefiltered, smooth_sampler, place, min(wide + 1u, u32(light.levels) - 1u), 0.0).xyz;
    return mix(a, b, level - f32(wide));
}

@compute @workgroup_size(64)
fn light_by_lobes(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= count[0] {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let place = rna_run_lobes(bitcast<vec3f>(at.position), axis, bitcast<f32>(at.h), wo, m, visibility);
    let detail = vec3f(unpack2x16float(at.red), unpack2x16float(at.green).x);
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.blue));
        sum += lobe.amplitude * select(vec3f(1.0), detail, j < RNA_LOBES / 2u) * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
