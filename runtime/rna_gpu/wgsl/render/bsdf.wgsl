// Metallic-roughness materials of objects and the ground: rna_render/materials/bsdf.py says the
// formulas and their sources. Without clear coat and transmission.

const MIN_ALPHA: f32 = 1e-3;
const MIN_COSINE: f32 = 1e-4;

struct Bsdf {
    base: vec3f,
    alpha: f32,
    metallic: f32,
    f0: f32,
    coat: f32, // its weight
}

fn texel(record: vec2<u32>, at: vec2<u32>, is_srgb: bool) -> vec3f {
    let word = images[record.x + 1u + at.y * images[record.x] + at.x];
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if !is_srgb {
        return c;
    }
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

// Bilinear, repeated, mixed after decoding.
fn texture_value(record: vec2<u32>, uv: vec2f, is_srgb: bool) -> vec3f {
    let size = vec2<i32>(texture_size(record));
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let first = ((vec2<i32>(low) % size) + size) % size;
    let i = vec2<u32>(first);
    let j = vec2<u32>((first + 1) % size);
    let part = at - low;
    let upper = mix(texel(record, i, is_srgb), texel(record, vec2(j.x, i.y), is_srgb), part.x);
    let lower = mix(texel(record, vec2(i.x, j.y), is_srgb), texel(record, j, is_srgb), part.x);
    return mix(upper, lower, part.y);
}

fn bsdf_of(v: Vertex) -> Bsdf {
    let at = frame.surfaces + SURFACE_SIZE * v.surface;
    var base = table[at + 1u];
    var rest = table[at + 2u];
    let srgb = u32(rest.w);
    let colour = texture_of(v.surface, 0u);
    if colour.y != 0u {
        base = vec4f(base.xyz * texture_value(colour, v.uv, (srgb & 1u) != 0u), base.w);
    }
    let metal = texture_of(v.surface, 1u);
    if metal.y != 0u {
        let value = texture_value(metal, v.uv, (srgb & 2u) != 0u);
        base.w *= value.y;
        rest.x *= value.z;
    }
    let coat = select(0.0, rest.z, rest.y > 0.0);
    return Bsdf(base.xyz, max(base.w * base.w, MIN_ALPHA), rest.x, rest.y, coat);
}

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

// The mean of what the coat lets through; means stand behind each row of the table.
fn mean_passed(b: Bsdf) -> f32 {
    let r = table_place(sqrt(min(b.alpha, 1.0)));
    let row = u32(r.x);
    let last = frame.table_size;
    let terms = mix(albedo_entry(row, last), albedo_entry(row + 1u, last), r.y);
    return 1.0 - b.coat * (b.f0 * terms.x + terms.y);
}

// D, of the squared sine and the cosine of the half vector to the normal.
fn distribution(alpha: f32, sine2: f32, nh: f32) -> f32 {
    let a2 = alpha * alpha;
    let spread = sine2 + a2 * nh * nh;
    return a2 / (PI * spread * spread);
}

fn smith_root(alpha: f32, cosine: f32) -> f32 {
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

fn schlick(cosine: f32) -> f32 {
    let x = 1.0 - clamp(cosine, 0.0, 1.0);
    return x * x * x * x * x;
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

// f(o, i) |n.i|. m: of turned_normal; g: geometric normal.
fn bsdf_value(b: Bsdf, m: vec3f, g: vec3f, o: vec3f, i: vec3f) -> vec3f {
    let cos_o = dot(m, o);
    let cos_i = max(dot(m, i), 0.0);
    if dot(g, o) * dot(g, i) <= 0.0 || cos_i == 0.0 {
        return vec3f(0.0);
    }
    var mirror = 0.0;
    var s = 0.0;
    var below = 1.0;
    if b.metallic > 0.0 || b.coat > 0.0 {
        let h = half_of(m, o, i);
        let root = cos_i * smith_root(b.alpha, cos_o) + cos_o * smith_root(b.alpha, cos_i);
        mirror = distribution(b.alpha, h.sine2, h.nh) * 0.5 / root;
        s = schlick(h.oh);
        below = (1.0 - albedo(b.coat, b.f0, b.alpha, cos_o))
            * (1.0 - albedo(b.coat, b.f0, b.alpha, cos_i)) / max(mean_passed(b), 1e-9);
    }
    let coat = (1.0 - b.metallic) * b.coat * (b.f0 + (1.0 - b.f0) * s);
    let metal = b.metallic * (b.base + (1.0 - b.base) * s);
    return cos_i * (mirror * (metal + coat) + b.base * ((1.0 - b.metallic) / PI * below));
}

// Part of the samples for the microfacets.
fn specular_share(b: Bsdf, cos_o: f32) -> f32 {
    if b.metallic == 0.0 && b.coat == 0.0 {
        return 0.0;
    }
    let mean = (b.base.x + b.base.y + b.base.z) / 3.0;
    let coat = albedo(b.coat, b.f0, b.alpha, cos_o);
    let specular = b.metallic * albedo(1.0, mean, b.alpha, cos_o) + (1.0 - b.metallic) * coat;
    let diffuse = (1.0 - b.metallic) * mean * (1.0 - coat);
    let total = specular + diffuse;
    return select(0.0, specular / max(total, 1e-30), total > 0.0);
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

fn bsdf_sample(b: Bsdf, m: vec3f, o: vec3f, u: vec3f) -> vec3f {
    let local = tangents_of(m);
    var i = vec3f(0.0);
    if u.z < specular_share(b, dot(m, o)) {
        i = sample_reflection(b.alpha, vec3f(dot(local.s, o), dot(local.t, o), dot(m, o)), u.xy);
    } else {
        let radius = sqrt(u.x);
        let phi = 2.0 * PI * u.y;
        i = vec3f(radius * cos(phi), radius * sin(phi), sqrt(1.0 - u.x));
    }
    return i.x * local.s + i.y * local.t + i.z * m;
}

fn bsdf_density(b: Bsdf, m: vec3f, o: vec3f, i: vec3f) -> f32 {
    let specular = specular_share(b, dot(m, o));
    var density = (1.0 - specular) * max(0.0, dot(m, i)) / PI;
    if specular > 0.0 {
        let h = half_of(m, o, i);
        if h.nh > 0.0 {
            let cos_o = dot(m, o);
            density += specular * distribution(b.alpha, h.sine2, h.nh)
                / (2.0 * (cos_o + smith_root(b.alpha, cos_o)));
        }
    }
    return density;
}
