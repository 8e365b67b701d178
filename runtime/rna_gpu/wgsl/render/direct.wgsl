// A sample of a light at each path's point: what materials send on is added at once, what assets send
// on waits for their decoder.

// Direction and length of the ray from `origin` to just before the light's point.
fn shadow_ray(x: vec3f, origin: vec3f, light: LightSample) -> RnaRay {
    if light.distance >= RNA_FAR {
        return RnaRay(origin, 0.0, light.wi, RNA_FAR);
    }
    let way = light.wi * light.distance - (origin - x);
    let size = max(length(way), 1e-30);
    return RnaRay(origin, 0.0, way / size, size * SHORTER);
}

fn chosen_light(pixel: u32) -> u32 {
    if frame.light != NONE {
        return frame.light;
    }
    let u = at_point(pixel, CHOICES).x;
    var below = 0.0;
    var chosen = 0u;
    for (var k = 0u; k < frame.light_count; k++) {
        let p = light_probability(k, 3u);
        if p > 0.0 && u >= below {
            chosen = k;
        }
        below += p;
    }
    return chosen;
}

fn light_point(pixel: u32) -> vec2f {
    let which = select(frame.light, 0u, frame.light == NONE);
    let dimension = (frame.depth - 1u) * DIMENSIONS + LIGHT + which;
    return square(pixel, dimension, frame.sample * frame.parts + frame.part);
}

// How much of the light a shadow catcher receives, and would without what is in the way.
fn catch_light(k: u32, path: Path, v: Vertex, light: u32, found: LightSample) {
    var cosine = abs(dot(v.n_world, found.wi));
    if dot(v.ng_world, path.direction) * dot(v.ng_world, found.wi) >= 0.0 {
        cosine = 0.0;
    }
    let pdf = found.pdf * light_probability(light, 1u);
    if pdf <= 0.0 || cosine == 0.0 {
        return;
    }
    let received = cosine / pdf * dot(found.radiance, vec3f(1.0 / 3.0));
    let ray = shadow_ray(v.x_world, origin_of(v, found.wi), found);
    let free = trace(ray, NONE, true).instance == RNA_NOTHING;
    sums[frame.sums * k + 3u] += vec4f(0.0, 0.0, select(0.0, received, free), received);
}

fn direct_material(k: u32, path: Path, v: Vertex, light: u32, found: LightSample) {
    let b = bsdf_of(v);
    let wi = rna_object_direction(found.wi, v.instance);
    let m = turned_normal(v.n, v.ng, v.wo);
    let pdf = found.pdf * light_probability(light, frame.depth);
    var own = bsdf_density(b, m, v.wo, wi);
    if (light_flags(light) & 2u) != 0u || (frame.flags & RAYS_MEET_LIGHTS) == 0u {
        own = 0.0;
    }
    let value = bsdf_value(b, m, v.ng, v.wo, wi) * found.radiance * (share(pdf, own) / pdf);
    add_light(k, light, clamped(path.beta * value));
}

fn direct_neural(k: u32, path: Path, v: Vertex, light: u32, found: LightSample) {
    let wi = rna_object_direction(found.wi, v.instance);
    let far = min(found.distance / instance_scale(v), RNA_FAR);
    let visible = trace_own(v, own_ray(v, wi, far), true).instance == RNA_NOTHING;
    let pdf = found.pdf * light_probability(light, frame.depth);
    var own = 0.0;
    if (light_flags(light) & 2u) == 0u && (frame.flags & RAYS_MEET_LIGHTS) != 0u {
        let is_fiber = v.kind == OF_FIBERS;
        let tangent = select(vec3f(0.0), v.axis, is_fiber);
        own = lobe_density(lobe_frame(v.shading, tangent, v.wo), is_fiber, wi);
    }
    let weight = path.beta * found.radiance * (share(pdf, own) / pdf);
    let seen = select(0.0, 1.0, visible);
    pendings[k] = Pending(v.x, v.h, v.axis, v.part, v.wo, seen, wi, light, weight, 0u);
    if frame.depth == 1u {
        sums[frame.sums * k + 3u].y += seen;
    }
}

@compute @workgroup_size(64)
fn direct(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    pendings[k].part = NONE;
    let path = paths[k];
    let v = vertex_of(path);
    let light = chosen_light(path.pixel);
    let found = sample_light(light, v.x_world, light_point(path.pixel));
    let thing = thing_of(v.instance);
    if thing.y == CATCHES {
        if frame.depth == 1u {
            catch_light(k, path, v, light, found);
        }
        return;
    }
    if found.pdf <= 0.0 || all(found.radiance <= vec3f(0.0)) {
        return;
    }
    if frame.depth == 1u {
        sums[frame.sums * k + 3u].x += 1.0;
    }
    let own = select(NONE, v.instance, thing.w == 1.0);
    let ray = shadow_ray(v.x_world, origin_of(v, found.wi), found);
    if trace(ray, own, true).instance != RNA_NOTHING {
        return;
    }
    if v.kind == OF_MATERIAL {
        direct_material(k, path, v, light, found);
        if frame.depth == 1u {
            sums[frame.sums * k + 3u].y += 1.0;
        }
    } else {
        direct_neural(k, path, v, light, found);
    }
}
