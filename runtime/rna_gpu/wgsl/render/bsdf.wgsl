// How materials of objects and the ground scatter: rna_render/materials/bsdf.py says the formulas and
// their sources.

const MIN_COSINE: f32 = 1e-4;
const CLEAR_F0: f32 = 0.04;

// Gauss and Legendre on [0, 1], for means over sqrt(cosine) with weight 2 cosine.
const NODES = array<f32, 8>(
    0.01985507175123188, 0.10166676129318664, 0.2372337950418355, 0.4082826787521751,
    0.5917173212478249, 0.7627662049581645, 0.8983332387068134, 0.9801449282487681,
);
const WEIGHTS = array<f32, 8>(
    0.05061426814518813, 0.11119051722668724, 0.15685332293894363, 0.18134189168918099,
    0.18134189168918099, 0.15685332293894363, 0.11119051722668724, 0.05061426814518813,
);

// The shading normal on wo's side, with at least MIN_COSINE to wo.
fn turned_normal(n: vec3f, ng: vec3f, o: vec3f) -> vec3f {
    let side = dot(ng, o);
    var m = o;
    if dot(ng, ng) > 0.0 {
        m = normalize(ng);
    }
    if dot(n, n) > 0.0 {
        m = normalize(n);
    }
    let away = select(dot(m, o), dot(m, ng) * side, side != 0.0);
    if away < 0.0 {
        m = -m;
    }
    let missing = MIN_COSINE - dot(m, o);
    if missing > 0.0 {
        m = normalize(m + missing * o);
    }
    return m;
}

// (A, B) of albedo_table at a row, for sqrt(cosine) along it.
fn albedo_entry(row: u32, column: u32) -> vec2f {
    let at = row * (frame.table_size + 1u) + column;
    let pair = table[frame.albedo + at / 2u];
    return select(pair.xy, pair.zw, (at & 1u) == 1u);
}

fn table_place(x: f32) -> vec2f {
    let at = clamp(x, 0.0, 1.0) * f32(frame.table_size - 1u);
    let low = min(floor(at), f32(frame.table_size - 2u));
    return vec2f(low, at - low);
}

// What a coat reflects by itself.
fn albedo(weight: f32, f0: f32, alpha: f32, cosine: f32) -> f32 {
    if weight == 0.0 {
        return 0.0;
    }
    let r = table_place(sqrt(min(alpha, 1.0)));
    let c = table_place(sqrt(clamp(cosine, 0.0, 1.0)));
    let row = u32(r.x);
    let column = u32(c.x);
    let upper = mix(albedo_entry(row, column), albedo_entry(row, column + 1u), c.y);
    let lower = mix(albedo_entry(row + 1u, column), albedo_entry(row + 1u, column + 1u), c.y);
    let terms = mix(upper, lower, r.y);
    return weight * (f0 * terms.x + terms.y);
}

// The mean of what both coats let through; means of the lower one stand behind each row of the table.
fn mean_passed(b: Bsdf) -> f32 {
    if b.clear == 0.0 {
        let r = table_place(sqrt(min(b.alpha, 1.0)));
        let row = u32(r.x);
        let last = frame.table_size;
        let terms = mix(albedo_entry(row, last), albedo_entry(row + 1u, last), r.y);
        return 1.0 - b.coat * (b.f0 * terms.x + terms.y);
    }
    var nodes = NODES;
    var weights = WEIGHTS;
    var result = 0.0;
    for (var k = 0u; k < 8u; k++) {
        let cosine = nodes[k] * nodes[k];
        let passed = (1.0 - albedo(b.coat, b.f0, b.alpha, cosine))
            * (1.0 - albedo(b.clear, CLEAR_F0, b.clear_alpha, cosine));
        result += weights[k] * 4.0 * nodes[k] * cosine * passed;
    }
    return result;
}

fn schlick(cosine: f32) -> f32 {
    let x = 1.0 - clamp(cosine, 0.0, 1.0);
    return x * x * x * x * x;
}

// V D about the normal m, and Schlick's weight.
fn lobe(alpha: f32, m: vec3f, o: vec3f, i: vec3f) -> vec2f {
    let h = half_of(m, o, i);
    let cos_o = dot(m, o);
    let cos_i = dot(m, i);
    let root = cos_i * smith_root(alpha, cos_o) + cos_o * smith_root(alpha, cos_i);
    return vec2f(distribution(alpha, h.sine2, h.nh) * 0.5 / root, schlick(h.oh));
}

// What the clear coat sends on itself, and lets through to what is below it on both ways: the less
// of the two, and their product.
fn clear_coat(b: Bsdf, o: vec3f, i: vec3f) -> vec3f {
    if b.clear == 0.0 {
        return vec3f(0.0, 1.0, 1.0);
    }
    let cos_i = max(dot(b.clear_m, i), 0.0);
    var sent = 0.0;
    if cos_i > 0.0 {
        let coat = lobe(b.clear_alpha, b.clear_m, o, i);
        sent = b.clear * coat.x * (CLEAR_F0 + (1.0 - CLEAR_F0) * coat.y) * cos_i;
    }
    let way_out = 1.0 - albedo(b.clear, CLEAR_F0, b.clear_alpha, dot(b.clear_m, o));
    let way_in = 1.0 - albedo(b.clear, CLEAR_F0, b.clear_alpha, cos_i);
    return vec3f(sent, min(way_out, way_in), way_out * way_in);
}

// f(o, i) |n.i|. g: geometric normal.
fn bsdf_value(b: Bsdf, g: vec3f, o: vec3f, i: vec3f) -> vec3f {
    let cos_o = dot(b.m, o);
    let cos_i = max(dot(b.m, i), 0.0);
    if dot(g, o) * dot(g, i) <= 0.0 || (cos_i == 0.0 && b.clear == 0.0) {
        return vec3f(0.0);
    }
    let above = clear_coat(b, o, i);
    if cos_i == 0.0 {
        return vec3f(above.x);
    }
    var mirror = vec2f(0.0);
    var below = b.diffuse * above.z;
    if b.metallic > 0.0 || b.coat > 0.0 || b.clear > 0.0 {
        mirror = lobe(b.alpha, b.m, o, i);
        below *= (1.0 - albedo(b.coat, b.f0, b.alpha, cos_o))
            * (1.0 - albedo(b.coat, b.f0, b.alpha, cos_i)) / max(mean_passed(b), 1e-9);
    }
    let coat = (1.0 - b.metallic) * b.coat * (b.f0 + (1.0 - b.f0) * mirror.y);
    let metal = b.metallic * (b.base + (1.0 - b.base) * mirror.y);
    let diffuse = b.base * ((1.0 - b.metallic) / PI * below);
    return cos_i * (above.y * mirror.x * (metal + coat) + diffuse) + above.x;
}

// Parts of the samples for the clear coat, and for the microfacets below it.
fn lobe_parts(b: Bsdf, o: vec3f) -> vec2f {
    if b.metallic == 0.0 && b.coat == 0.0 && b.clear == 0.0 {
        return vec2f(0.0);
    }
    let cos_o = dot(b.m, o);
    let mean = (b.base.x + b.base.y + b.base.z) / 3.0;
    let coat = albedo(b.coat, b.f0, b.alpha, cos_o);
    let top = albedo(b.clear, CLEAR_F0, b.clear_alpha, dot(b.clear_m, o));
    var specular = b.metallic * albedo(1.0, mean, b.alpha, cos_o) + (1.0 - b.metallic) * coat;
    specular *= 1.0 - top;
    let diffuse = (1.0 - b.metallic) * mean * (1.0 - coat) * b.diffuse * (1.0 - top);
    let total = top + specular + diffuse;
    return select(vec2f(0.0), vec2f(top, specular) / max(total, 1e-30), total > 0.0);
}

fn bsdf_sample(b: Bsdf, o: vec3f, u: vec3f) -> vec3f {
    let parts = lobe_parts(b, o);
    let on_clear = u.z < parts.x;
    let axis = select(b.m, b.clear_m, on_clear);
    let local = tangents_of(axis);
    var i = vec3f(0.0);
    if u.z < parts.x + parts.y {
        let alpha = select(b.alpha, b.clear_alpha, on_clear);
        let o_local = vec3f(dot(local.s, o), dot(local.t, o), dot(axis, o));
        i = sample_reflection(alpha, o_local, u.xy);
    } else {
        let radius = sqrt(u.x);
        let phi = 2.0 * PI * u.y;
        i = vec3f(radius * cos(phi), radius * sin(phi), sqrt(1.0 - u.x));
    }
    return i.x * local.s + i.y * local.t + i.z * axis;
}

fn bsdf_density(b: Bsdf, o: vec3f, i: vec3f) -> f32 {
    let parts = lobe_parts(b, o);
    var density = (1.0 - parts.x - parts.y) * max(0.0, dot(b.m, i)) / PI;
    if parts.y > 0.0 {
        density += parts.y * reflected_density(b.alpha, b.m, o, i);
    }
    if parts.x > 0.0 {
        density += parts.x * reflected_density(b.clear_alpha, b.clear_m, o, i);
    }
    return density;
}
