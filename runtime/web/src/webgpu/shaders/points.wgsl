// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and where its ray to the light starts (7.1).

struct Corners {
    p: array<vec3f, 3>,
    n: array<vec3f, 3>,
    uv: array<vec2f, 3>,
}

fn corners_of(primitive: vec4<u32>) -> Corners {
    var corners: Corners;
    for (var k = 0u; k < 3u; k++) {
        let place = rna_points[primitive[k]];
        let normal = rna_points[view.normals_at + primitive[k]];
        corners.p[k] = place.xyz;
        corners.n[k] = normal.xyz;
        corners.uv[k] = vec2f(place.w, normal.w);
    }
    return corners;
}

fn weights_of(hit: Hit) -> vec3f {
    return vec3f(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

fn mixed(v: array<vec3f, 3>, b: vec3f) -> vec3f {
    return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

// Of twelve words: kind, first and end of the primitives, offset of texels; width, height, channels,
// cutoff; two indices of refraction.
struct Record {
    offset: u32,
    size: vec2<u32>,
    channels: u32,
    cutoff: f32,
    front: f32,
    back: f32,
}

fn record_at(k: u32) -> Record {
    let at = 12u * k;
    return Record(
        textures[at + 3u], vec2<u32>(textures[at + 4u], textures[at + 5u]), textures[at + 6u],
        bitcast<f32>(textures[at + 7u]), bitcast<f32>(textures[at + 8u]), bitcast<f32>(textures[at + 9u]),
    );
}

// The record of this kind that the triangle is in, or -1.
fn record_of(number: u32, kind: u32) -> i32 {
    for (var k = 0u; k < view.record_count; k++) {
        let at = 12u * k;
        if textures[at] == kind && number >= textures[at + 1u] && number < textures[at + 2u] {
            return i32(k);
        }
    }
    return -1;
}

fn texel_at(record: Record, column: u32, row: u32) -> vec3f {
    let first = record.offset + ((row % record.size.y) * record.size.x + column % record.size.x) * record.channels;
    var value = vec3f(0.0);
    for (var c = 0u; c < record.channels; c++) {
        let at = first + c;
        value[c] = f32((textures[view.texels_at + at / 4u] >> (8u * (at % 4u))) & 255u);
    }
    return value;
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
fn look_up(record: Record, uv: vec2f) -> vec3f {
    let size = vec2f(record.size);
    let place = uv * size - 0.5;
    let below = floor(place);
    let f = place - below;
    let low = vec2<u32>(clamp(below - size * floor(below / size), vec2f(0.0), size - 1.0));
    let lower = mix(texel_at(record, low.x, low.y), texel_at(record, low.x + 1u, low.y), f.x);
    let upper = mix(texel_at(record, low.x, low.y + 1u), texel_at(record, low.x + 1u, low.y + 1u), f.x);
    return mix(lower, upper, f.y);
}

fn uv_of(corners: Corners, b: vec3f) -> vec2f {
    return b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
}

fn fresnel(index: f32, c: f32) -> f32 {
    let g2 = index * index - 1.0 + c * c;
    if g2 <= 0.0 {
        return 1.0;
    }
    let g = sqrt(g2);
    let r = (g - c) / (g + c);
    let s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

fn transmittance(primitive: vec4<u32>, hit: Hit, d: vec3f) -> vec3f {
    if !HAS_TEXTURES {
        return vec3f(0.0);
    }
    let k = record_of(primitive.w, 0u);
    if k < 0 {
        return vec3f(0.0);
    }
    let record = record_at(u32(k));
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    var tau = look_up(record, uv_of(corners, b)) / 255.0;
    if record.channels == 1u {
        tau = tau.xxx;
    }
    if record.cutoff > 0.0 {
        tau = vec3f(select(0.0, 1.0, tau.x > record.cutoff));
    }
    if record.front > 0.0 {
        let n = unit(mixed(corners.n, b));
        let ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
        let index = select(record.back, record.front, dot(d, ng) < 0.0);
        tau *= 1.0 - fresnel(index, abs(dot(n, d)));
    }
    return tau;
}

// The normal with relief, 4.5.
fn mapped_normal(number: u32, corners: Corners, b: vec3f, n: vec3f) -> vec3f {
    if !HAS_TEXTURES {
        return n;
    }
    let k = record_of(number, 1u);
    if k < 0 {
        return n;
    }
    let e1 = corners.p[1] - corners.p[0];
    let e2 = corners.p[2] - corners.p[0];
    let a = corners.uv[1] - corners.uv[0];
    let c = corners.uv[2] - corners.uv[0];
    let area = a.x * c.y - c.x * a.y;
    let u = (c.y * e1 - a.y * e2) * sign(area);
    let v = (a.x * e2 - c.x * e1) * sign(area);
    let along = u - dot(u, n) * n;
    if area == 0.0 || length(along) <= 1e-6 * length(u) {
        return n;
    }
    let t = unit(along);
    var up = cross(n, t);
    if dot(up, v) > 0.0 {
        up = -up;
    }
    let q = (look_up(record_at(u32(k)), uv_of(corners, b)).xy - 127.0) / 127.0;
    let m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}

fn shading_normal(primitive: vec4<u32>, hit: Hit) -> vec3f {
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    return mapped_normal(primitive.w, corners, b, unit(mixed(corners.n, b)));
}

fn tangent_of(primitive: vec4<u32>) -> vec3f {
    return unit(rna_points[primitive.x + 1u].xyz - rna_points[primitive.x].xyz);
}

// h of 4.2.
fn offset_across(n: vec3f, t: vec3f, wo: vec3f) -> f32 {
    let across = cross(t, wo);
    let size = length(across);
    if size <= 1e-6 {
        return 0.0;
    }
    return clamp(dot(n, across) / size, -1.0, 1.0);
}

// Where the visibility ray of a mesh starts, by rna_gpu's visibility.wgsl.
fn lifted_origin(primitive: vec4<u32>, hit: Hit, wi: vec3f) -> vec3f {
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    let x = mixed(corners.p, b);
    let n = unit(mixed(corners.n, b));
    let ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
    let places = mat3x3f(corners.p[0], corners.p[1], corners.p[2]);
    let lift = rna_lift(x, b, places, mat3x3f(corners.n[0], corners.n[1], corners.n[2]));
    return rna_leaving_origin(x, n, ng, lift, wi, view.epsilon * 0x1p18f);
}
