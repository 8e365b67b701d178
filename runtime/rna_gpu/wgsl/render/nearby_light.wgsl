// Nearby light by one column: spec/RNA.md, 7.3, and rna_trace/nearby.py, which draws the same.

const COLUMNS_BEGIN: f32 = 2.0; // of distant light, times the diagonal of the asset
const OF_LENGTHS: f32 = 1.2; // median of rho, times the geometric mean of the outer lengths
const SHAPE: f32 = 1.5; // of the distribution of rho

// x, wi, far (the distance of the light): object space of the body below `root`. u: from 0 to 1. A host whose triangles
// let light through says which of them columns pass.
fn nearby_light(root: u32, lengths: vec3f, x: vec3f, wi: vec3f, far: f32, u: vec2f) -> vec3f {
    let share = clamp(u.x, 0x1p-24f, 1.0 - 0x1p-24f);
    let rho = OF_LENGTHS * sqrt(lengths.x) * sqrt(lengths.z) * pow(share / (1.0 - share), 1.0 / SHAPE);
    let phi = 2.0 * PI * u.y;
    let axes = tangents_of(wi);
    let reach = min(far, COLUMNS_BEGIN * distance(rna_nodes[root].low, rna_nodes[root].high));
    let origin = x + rho * (cos(phi) * axes.s + sin(phi) * axes.t) + reach * wi;
    var hit = rna_miss(RNA_FAR);
    if !rna_trace_body(root, RnaRay(origin, 0.0, -wi, RNA_FAR), RNA_NOTHING, false, &hit) {
        return vec3f(0.0);
    }
    let beside = vec3f(rho) / lengths;
    let far_away = vec3f(length(vec2f(rho, reach - hit.t))) / lengths;
    return exp(-far_away) * beside * beside / (SHAPE * share * (1.0 - share));
}
