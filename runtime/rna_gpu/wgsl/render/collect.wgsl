// Emission at the hits of rays, and what the camera sees; ends paths that hit no scatterer.

fn mis_weight(path: Path, light: u32, pdf: f32) -> vec3f {
    if frame.depth == 0u {
        return path.beta;
    }
    return path.beta * share(path.pdf, samples_of(light, frame.depth) * pdf);
}

fn add_light_hit(k: u32, path: Path, light: u32, hit: LightHit) {
    add_light(k, light, clamped(mis_weight(path, light, hit.pdf) * hit.radiance));
}

fn collect_sky(k: u32, path: Path) {
    for (var light = 0u; light < frame.light_count; light++) {
        let seen = frame.depth > 0u || path.pdf == BENT || light_is(light, LIGHT_SEEN);
        if seen && light_is(light, LIGHT_INFINITE) {
            add_light_hit(k, path, light, environment_along(light, path.direction));
            if frame.depth == 0u {
                sums[frame.sums * k + SUM_BEAUTY].w = 1.0;
            }
        }
    }
}

fn collect_shape(k: u32, path: Path) {
    let light = path.instance & ~IS_LIGHT;
    if frame.depth == 0u {
        sums[frame.sums * k + SUM_BEAUTY].w = 1.0;
    }
    let pdf = shape_pdf(light, path.origin, path.direction);
    let radiance = select(vec3f(0.0), light_colour(light), pdf > 0.0);
    add_light_hit(k, path, light, LightHit(radiance, pdf));
}

// Emission of surfaces that also scatter.
fn collect_emission(k: u32, path: Path, record: RnaPrimitive) {
    let light = rna_instances[path.instance].host_data;
    if light == NONE || !surface_has(rna_surface(record), EMITS) {
        return;
    }
    if frame.depth > 0u && (frame.flags & RAYS_MEET_LIGHTS) == 0u {
        return;
    }
    var pdf = 0.0;
    if !rna_is_segment(record) { // strands are found by rays alone
        let x = rna_object_point(path.origin, path.instance);
        let d = rna_object_direction(path.direction, path.instance);
        pdf = triangle_pdf(light, path.primitive, x, d);
    }
    if surface_kind(rna_surface(record)) == OF_MATERIAL {
        add_light_hit(k, path, light, LightHit(emission_on(record, path.b1, path.b2), pdf));
        return;
    }
    let weight = mis_weight(path, light, pdf) * light_colour(light);
    let v = vertex_of(path);
    let none = vec3f(0.0);
    queries[k].at_point = Query(
        v.x, v.h, v.axis, v.part, v.wo, light, v.wo, NONE, weight, 0.0, none, 0.0, none, none,
    );
}

fn describe(k: u32, v: Vertex) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY].w = 1.0;
    sums[at + SUM_NORMAL] = vec4f(v.n_world, 1.0);
    sums[at + SUM_POSITION] = vec4f(v.x_world, object_number(v.instance));
}

// What shows behind a shadow catcher.
fn behind_catcher(k: u32, path: Path) {
    let at = frame.sums * k;
    sums[at + SUM_NORMAL].w = 2.0;
    for (var light = 0u; light < frame.light_count; light++) {
        if light_is(light, LIGHT_INFINITE) && light_is(light, LIGHT_SEEN) {
            let radiance = vec4f(environment_along(light, path.direction).radiance * path.beta, 0.0);
            sums[at + SUM_BEHIND] = vec4f((sums[at + SUM_BEHIND] + radiance).xyz, 1.0);
            let group = light_group(light);
            if group != NONE {
                sums[at + SUM_GROUPS + 2u * group + 1u] += radiance;
            }
        }
    }
}

@compute @workgroup_size(64)
fn collect(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    let path = paths[k];
    queries[k].at_point.part = NONE;
    if frame.depth == 0u && path.pdf == BENT {
        sums[frame.sums * k + SUM_BEAUTY].w = 1.0;
    }
    let meets = frame.depth == 0u || (frame.flags & RAYS_MEET_LIGHTS) != 0u;
    if path.instance == RNA_NOTHING {
        paths[k].state = DEAD;
        if meets {
            collect_sky(k, path);
        }
    } else if (path.instance & IS_LIGHT) != 0u {
        paths[k].state = DEAD;
        if meets {
            collect_shape(k, path);
        }
    } else if object_catches(path.instance) == 0u {
        if frame.depth == 0u {
            describe(k, vertex_of(path));
        }
        collect_emission(k, path, rna_primitives[path.primitive]);
    } else if frame.depth == 0u {
        behind_catcher(k, path);
    }
}
