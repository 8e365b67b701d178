// A sample of a light at each path's point: what materials scatter is added at once, what assets
// scatter waits for their decoder, and before that for the decoder of an asset's emission as a light.

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
        let p = samples_of(k, 3u);
        if p > 0.0 && u >= below {
            chosen = k;
        }
        below += p;
    }
    return chosen;
}

// Queries what an asset emits at the sampled point of it, towards the path's point, weighted by the
// share that does not let light through; evaluates it for an object. Returns the sample with its radiance.
fn shining(k: u32, light: u32, sampled: LightSample) -> LightSample {
    var lit = sampled;
    let instance = light_instance(light);
    let record = rna_primitives[sampled.primitive];
    let there = triangle_vertex(record, sampled.b1, sampled.b2);
    let d = rna_object_direction(sampled.wi, instance);
    if surface_kind(rna_surface(record)) == OF_MATERIAL {
        let tau = transmittance(record, sampled.b1, sampled.b2, vec3f(1.0), true);
        lit.radiance *= emission_on(record, sampled.b1, sampled.b2) * (1.0 - tau);
        return lit;
    }
    lit.radiance *= 1.0 - transmittance(record, sampled.b1, sampled.b2, d, dot(there.ng, d) < 0.0);
    let none = vec3f(0.0);
    let part = surface_part(rna_surface(record));
    queries[k].at_light = Query(
        there.x, 0.0, there.axis, part, -d, light, -d, NONE, none, 0.0, none, 0.0, none, none,
    );
    return lit;
}

fn waits_for_light(k: u32) -> bool {
    return queries[k].at_light.part != NONE;
}

fn mean_of(c: vec3f) -> f32 {
    return (c.x + c.y + c.z) / 3.0;
}

// How much of the light a shadow catcher receives, and would without what is in the way.
fn catch_light(k: u32, path: Path, v: Vertex, light: u32, sampled: LightSample, tau: vec3f) {
    var cosine = abs(dot(v.n_world, sampled.wi));
    if dot(v.ng_world, path.direction) * dot(v.ng_world, sampled.wi) >= 0.0 {
        cosine = 0.0;
    }
    let weight = sampled.radiance * (cosine / (sampled.pdf * samples_of(light, 1u)));
    if waits_for_light(k) {
        queries[k].at_point.part = CATCHER_PART;
        queries[k].at_point.weight = weight;
        queries[k].at_point.visible = tau;
        return;
    }
    sums[frame.sums * k + SUM_LIGHT_SAMPLES] += vec4f(0.0, 0.0, mean_of(weight * tau), mean_of(weight));
}

// The part of the estimate that belongs to samples of this light, over its density.
fn light_share(light: u32, pdf_of_light: f32, pdf_of_ray: f32) -> f32 {
    let pdf = pdf_of_light * samples_of(light, frame.depth);
    if light_is(light, LIGHT_DELTA) || (frame.flags & RAYS_MEET_LIGHTS) == 0u {
        return 1.0 / pdf;
    }
    return share(pdf, pdf_of_ray) / pdf;
}

fn direct_material(k: u32, path: Path, v: Vertex, light: u32, sampled: LightSample, tau: vec3f) {
    let b = bsdf_of(v);
    let wi = rna_object_direction(sampled.wi, v.instance);
    let value = bsdf_value(b, v.ng, v.wo, wi) / ending_share(v);
    let share_of = light_share(light, sampled.pdf, bsdf_density(b, v.wo, wi));
    let weight = path.beta * value * sampled.radiance * share_of * tau;
    if waits_for_light(k) {
        queries[k].at_point.part = MATERIAL_PART;
        queries[k].at_point.light = light;
        queries[k].at_point.weight = weight;
    } else {
        add_light(k, light, clamped(weight));
    }
    count_seen(k, mean_of(tau));
}

fn direct_neural(k: u32, path: Path, v: Vertex, light: u32, sampled: LightSample, tau: vec3f) {
    let wi = rna_object_direction(sampled.wi, v.instance);
    let far = min(sampled.distance / instance_scale(v.instance), RNA_FAR);
    let way = RnaRay(leaving_point(v, wi), 0.0, wi, far);
    let visible = start_visibility(v.instance, way, v.strand);
    let is_fiber = v.kind == OF_FIBERS;
    let tangent = select(vec3f(0.0), v.axis, is_fiber);
    let pdf_of_ray = lobe_density(lobe_frame(v.shading, tangent, v.wo), surface_lobes(v.surface), wi);
    let weight = path.beta * sampled.radiance * light_share(light, sampled.pdf, pdf_of_ray) * tau;
    queries[k].at_point = Query(
        v.x, v.h, v.axis, v.part, v.wo, light, wi, v.strand, weight, 0.0, visible, far,
        base_color_of(path, v), vec3f(0.0),
    );
    count_seen(k, mean_of(visible) * mean_of(tau));
}

fn count_seen(k: u32, seen: f32) {
    queries[k].at_point.seen = seen;
    if frame.depth == 1u {
        sums[frame.sums * k + SUM_LIGHT_SAMPLES].y += seen;
    }
}

// Whether what the light throws on the point's own instance is part of its transport.
fn is_same_light(light: u32, v: Vertex) -> bool {
    return light_kind(light) == TRIANGLES && light_instance(light) == v.instance
        && object_passes(v.instance) == 1u;
}

@compute @workgroup_size(64)
fn direct(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    queries[k].at_point.part = NONE;
    queries[k].at_light.part = NONE;
    let path = paths[k];
    let v = vertex_of(path);
    let catches = object_catches(v.instance) == 1u;
    let light = chosen_light(path.pixel);
    if (catches && frame.depth != 1u) || is_same_light(light, v) || is_inside(v) {
        return;
    }
    var sampled = sample_light(light, v.x_world, at_light_sample(path.pixel, LIGHT));
    if sampled.pdf > 0.0 && sampled.primitive != NONE {
        sampled = shining(k, light, sampled);
    }
    let behind = v.kind == OF_MATERIAL && !catches
        && dot(v.ng_world, path.direction) * dot(v.ng_world, sampled.wi) >= 0.0;
    if sampled.pdf <= 0.0 || all(sampled.radiance <= vec3f(0.0)) || behind {
        queries[k].at_light.part = NONE;
        return;
    }
    if frame.depth == 1u && !catches {
        sums[frame.sums * k + SUM_LIGHT_SAMPLES].x += 1.0;
    }
    let ignored = select(NONE, v.instance, object_passes(v.instance) == 1u);
    let tau = visible_on(shadow_ray(v.x_world, origin_of(v, sampled.wi), sampled), ignored);
    if catches {
        catch_light(k, path, v, light, sampled, tau);
    } else if all(tau <= vec3f(0.0)) {
        queries[k].at_light.part = NONE;
    } else if v.kind == OF_MATERIAL {
        direct_material(k, path, v, light, sampled, tau);
    } else {
        direct_neural(k, path, v, light, sampled, tau);
    }
}
