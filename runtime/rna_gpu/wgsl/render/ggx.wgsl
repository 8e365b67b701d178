// The GGX microfacet surface, as rna_render.materials.ggx has it.

// D, of the squared sine and the cosine of the half vector to the normal.
fn distribution(alpha: f32, sine2: f32, nh: f32) -> f32 {
    let a2 = alpha * alpha;
    let spread = sine2 + a2 * nh * nh;
    return a2 / (PI * spread * spread);
}

fn smith_root(alpha: f32, cosine: f32) -> f32 {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

struct Half {
    sine2: f32,
    nh: f32,
    oh: f32,
}

fn half_of(m: vec3f, o: vec3f, i: vec3f) -> Half {
    let sum = o + i;
    let size = length(sum);
    if size < 1e-6 {
        return Half(1.0, 0.0, 0.0);
    }
    let h = sum / size;
    let aside = cross(m, h);
    return Half(dot(aside, aside), min(dot(m, h), 1.0), dot(o, h));
}

// Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps (HPG 2023).
fn sample_reflection(alpha: f32, o: vec3f, u: vec2f) -> vec3f {
    let s = normalize(vec3f(alpha * o.x, alpha * o.y, o.z));
    let phi = 2.0 * PI * u.x;
    let z = (1.0 - u.y) * (1.0 + s.z) - s.z;
    let radius = sqrt(max(0.0, 1.0 - z * z));
    let h = vec3f(alpha * (radius * cos(phi) + s.x), alpha * (radius * sin(phi) + s.y), z + s.z);
    let size = length(h);
    let n = select(vec3f(0.0, 0.0, 1.0), h / max(size, 1e-30), size > 0.0);
    return 2.0 * dot(o, n) * n - o;
}

// Of sample_reflection about m.
fn reflected_density(alpha: f32, m: vec3f, o: vec3f, i: vec3f) -> f32 {
    let h = half_of(m, o, i);
    if h.nh <= 0.0 {
        return 0.0;
    }
    let cos_o = dot(m, o);
    return distribution(alpha, h.sine2, h.nh) / (2.0 * (cos_o + smith_root(alpha, cos_o)));
}
