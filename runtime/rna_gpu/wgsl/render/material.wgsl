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
    let roughness = surface_roughness(v.surface) * values[METAL].y;
    let clear_roughness = surface_clear_coat_roughness(v.surface) * values[CLEAR_ROUGH].y;
    let coat = surface_coat_weight(v.surface) * values[COAT].x;
    var b: Bsdf;
    b.base = surface_base_color(v.surface) * values[BASE] * vertex_color(v.surface, v.record, v.b1, v.b2);
    b.alpha = max(roughness * roughness, MIN_ALPHA);
    b.metallic = surface_metallic(v.surface) * values[METAL].z;
    b.f0 = surface_coat_f0(v.surface);
    b.coat = select(0.0, coat, b.f0 > 0.0);
    b.diffuse = 1.0 - surface_transmission(v.surface) * values[THROUGH].x;
    b.clear = surface_clear_coat(v.surface) * values[CLEAR].x;
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
