// Rays through solid glass: rna_render/paths/solid_glass.py and materials/refraction.py, which this follows. No shadow
// ray passes: rays find the light that comes through.

const MOST_INTERFACES: u32 = 24u;
const INTERFACES: u32 = 0x100000u; // the first of their dimensions of random numbers

struct Followed {
    hit: RnaHit,   // of no glass
    first: f32,    // distance of the start to the first hit, of glass or not
    weight: vec3f, // what interfaces, absorption and whatever else the ray passed leave
    bent: bool,    // whether the ray has met glass
    ray: RnaRay,   // from the last interface, or the one that was given
}

// The share that is reflected. eta: index of the other side over that of this one.
fn fresnel(cos_i: f32, eta: f32) -> f32 {
    let sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    let cos_t = sqrt(max(1.0 - sin2_t, 0.0));
    let parallel = (eta * cos_i - cos_t) / max(eta * cos_i + cos_t, 1e-30);
    let across = (cos_i - eta * cos_t) / max(cos_i + eta * cos_t, 1e-30);
    return select(0.5 * (parallel * parallel + across * across), 1.0, sin2_t >= 1.0);
}

// Where fresnel is below 1.
fn refracted(d: vec3f, n: vec3f, eta: f32) -> vec3f {
    let cos_i = -dot(d, n);
    let cos_t = sqrt(max(1.0 - (1.0 - cos_i * cos_i) / (eta * eta), 0.0));
    return normalize(d / eta + (cos_i / eta - cos_t) * n);
}

// A mirrored direction, about the triangle's normal where that about n would go through the triangle.
fn mirrored_about(d: vec3f, n: vec3f, ng: vec3f) -> vec3f {
    let out = reflect(d, n);
    return select(reflect(d, ng), out, dot(out, ng) > 0.0);
}

fn is_solid(hit: RnaHit) -> bool {
    if (hit.instance & IS_LIGHT) != 0u { // as RNA_NOTHING has it
        return false;
    }
    let record = rna_primitives[hit.primitive];
    return !rna_is_segment(record) && surface_has(rna_surface(record), IS_SOLID);
}

fn glass_vertex(hit: RnaHit, ray: RnaRay) -> Vertex {
    let record = rna_primitives[hit.primitive];
    var v = triangle_vertex(record, hit.b1, hit.b2);
    v.surface = rna_surface(record);
    v.instance = hit.instance;
    place_vertex(&v, record, ray, hit.t);
    v.n_world = rna_world_direction(v.n, hit.instance);
    if dot(v.n_world, v.ng_world) <= 0.0 {
        v.n_world = v.ng_world;
    }
    return v;
}

// Takes a ray that met glass on from there. inside: absorption where it is. u: in [0, 1).
fn pass_interface(f: ptr<function, Followed>, inside: ptr<function, vec3f>, u: f32) {
    let v = glass_vertex((*f).hit, (*f).ray);
    let d = (*f).ray.direction;
    let enters = dot(d, v.ng_world) < 0.0;
    let absorption = surface_absorption(v.surface) / rna_instances[v.instance].scale;
    // A ray that began inside leaves what it was not known to be in.
    let begins_inside = !enters && all(*inside == vec3f(0.0));
    let medium = select(*inside, absorption, begins_inside);
    (*f).weight *= exp(-medium * (*f).hit.t);
    let side = select(-1.0, 1.0, enters);
    let ng = side * v.ng_world;
    let n = select(side * v.n_world, ng, dot(d, side * v.n_world) > -1e-4);
    let ior = surface_ior(v.surface).x;
    let eta = select(1.0 / ior, ior, enters);
    var out = mirrored_about(d, n, ng);
    *inside = medium;
    if u >= fresnel(clamp(-dot(d, n), 0.0, 1.0), eta) {
        out = refracted(d, n, eta);
        (*f).weight *= surface_base_color(v.surface);
        *inside = max(medium + side * absorption, vec3f(0.0));
    }
    (*f).ray = RnaRay(origin_of(v, out), 0.0, out, RNA_FAR);
}

// A ray to the first hit of no glass. depth: of the point where it starts, 0 for the camera.
fn follow(start: RnaRay, ignored: u32, depth: u32, pixel: u32) -> Followed {
    let key = chance_of(pixel);
    let through = closest_through(start, ignored, frame.rays, key);
    var f = Followed(through.hit, through.hit.t, through.weight, false, start);
    var inside = vec3f(0.0);
    for (var k = 0u; is_solid(f.hit); k++) {
        f.bent = true;
        if k == MOST_INTERFACES {
            f.hit = rna_miss(RNA_FAR);
            f.weight = vec3f(0.0);
            break;
        }
        let dimension = INTERFACES + depth * MOST_INTERFACES + k;
        pass_interface(&f, &inside, square(pixel, dimension, path_of_pixel()).x);
        let behind = closest_through(f.ray, RNA_NOTHING, INDIRECT_RAY, key);
        f.hit = behind.hit;
        f.weight *= behind.weight;
    }
    if f.bent && f.hit.instance != RNA_NOTHING {
        f.weight *= exp(-inside * f.hit.t);
    }
    return f;
}
