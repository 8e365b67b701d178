// Nearby light by one column: spec/RNA.md, 7.3, and rna_trace/nearby.py, which draws the same.

const COLUMNS_BEGIN: f32 = 2.0; // of distant light, times the diagonal of the asset

// r with 1 - (1 + r) exp(-r) = p, of the Gamma distribution of shape 2.
fn gamma_quantile(share: f32) -> f32 {
    let p = min(share, 1.0 - 0x1p-24f);
    let e = select(-log(1.0 - p), p * (1.0 + p * (0.5 + p / 3.0)), p < 0.01);
    let c = sqrt(2.0 * e);
    let rest = 0.0278336 + c * (-0.00385199 + c * (0.00038292 + c * (-2.2748e-05 + c * 5.68073e-07)));
    return c * (1.0 + c * (1.0 / 3.0 + c * rest));
}

// The estimate of a column rho beside x, that meets the asset height above it along wi. Exponents are compared before
// exp, so that lengths of any size stay in float32.
fn shares_of_column(lengths: vec3f, rho: f32, height: f32) -> vec3f {
    let scale = 2.0 * log(vec3f(lengths.z) / lengths);
    let of_rho = scale - vec3f(rho) / lengths;
    let largest = max(of_rho.x, max(of_rho.y, of_rho.z));
    let density = dot(exp(of_rho - largest), vec3f(1.0 / 3.0));
    return exp(scale - vec3f(length(vec2f(rho, height))) / lengths - largest) / density;
}

// x, wi, far (the distance of the light): object space of the body below `root`. u: from 0 to 1. A host whose triangles
// let light through says which of them columns pass.
fn nearby_light(root: u32, lengths: vec3f, x: vec3f, wi: vec3f, far: f32, u: vec2f) -> vec3f {
    let scaled = 3.0 * u.x;
    let k = min(u32(scaled), 2u);
    let rho = lengths[k] * gamma_quantile(scaled - f32(k));
    let phi = 2.0 * PI * u.y;
    let beside = tangents_of(wi);
    let reach = min(far, COLUMNS_BEGIN * distance(rna_nodes[root].low, rna_nodes[root].high));
    let origin = x + rho * (cos(phi) * beside.s + sin(phi) * beside.t) + reach * wi;
    var hit = rna_miss(RNA_FAR);
    if !rna_trace_body(root, RnaRay(origin, 0.0, -wi, RNA_FAR), RNA_NOTHING, false, &hit) {
        return vec3f(0.0);
    }
    return shares_of_column(lengths, rho, reach - hit.t);
}
