// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray, whose bit is `rays`; `key` decides what it passes.
fn closest_through(ray: RnaRay, ignored: u32, rays: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let of_geometry = rna_trace(line, ignored, rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, rays, of_geometry);
        let is_triangle = (hit.instance & IS_LIGHT) == 0u
            && !rna_is_segment(rna_primitives[hit.primitive]);
        share = select(share, stopped_share, is_triangle);
        if !is_coloured {
            break;
        }
        passing = WEIGH;
        line.far = hit.t;
    }
    return Through(hit, share * passed_weight);
}

// What a shadow ray keeps of its light.
fn visible_on(ray: RnaRay, ignored: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, ignored, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, frame.rays, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn start_visibility(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
    var hit = rna_miss(ray.far);
    let root = rna_instances[instance].root;
    start_passing(WEAKEN);
    let stopped = rna_trace_body(root, ray, strand, true, &hit);
    return select(passed_weight, vec3f(0.0), stopped);
}
