// The material at a point: rna_render/materials/mesh_object.py. Textures multiply the factors.

const MIN_ALPHA: f32 = 1e-3;

struct Bsdf {
    base: vec3f,
    alpha: f32,
    metallic: f32,
    f0: f32,
    coat: f32, // its weight
    diffuse: f32, // weight of what is diffuse
    clear: f32, // weight of the clear coat
    clear_alpha: f32,
    m: vec3f, // normal that it scatters about, on the viewer's side
    clear_m: vec3f, // of the clear coat
}

fn bsdf_of(v: Vertex) -> Bsdf {
    var values: array<vec3f, 7>;
    for (var k = BASE; k <= THROUGH; k++) {
        values[k] = factor_on(k, v.record, v.b1, v.b2);
    }
    let base = surface_row(v.surface, 1u);
    let rest = surface_row(v.surface, 2u);
    let clear = surface_row(v.surface, 4u);
    let roughness = base.w * values[METAL].y;
    let clear_roughness = clear.y * values[CLEAR_ROUGH].y;
    var b: Bsdf;
    b.base = base.xyz * values[BASE];
    b.alpha = max(roughness * roughness, MIN_ALPHA);
    b.metallic = rest.x * values[METAL].z;
    b.f0 = rest.y;
    b.coat = select(0.0, rest.z * values[COAT].x, rest.y > 0.0);
    b.diffuse = 1.0 - rest.w * values[THROUGH].x;
    b.clear = clear.x * values[CLEAR].x;
    b.clear_alpha = max(clear_roughness * clear_roughness, MIN_ALPHA);
    b.m = turned_normal(v.shading, v.ng, v.wo);
    b.clear_m = b.m;
    if b.clear > 0.0 {
        b.clear_m = turned_normal(v.n, v.ng, v.wo);
    }
    return b;
}

// What rays that end on glass bring is divided by how often they do.
fn ending_share(v: Vertex) -> vec3f {
    if !surface_has(v.surface, IS_GLASS) {
        return vec3f(1.0);
    }
    let tau = transmittance(v.record, v.b1, v.b2, v.wo, dot(v.ng, v.wo) > 0.0);
    return max(1.0 - tau, vec3f(1e-6));
}
