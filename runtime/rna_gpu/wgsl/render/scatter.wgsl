// The ray that continues each path, in a direction of its body's choice.

@compute @workgroup_size(64)
fn scatter(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    queries[k].at_point.part = NONE;
    let path = paths[k];
    if object_catches(path.instance) == 1u {
        paths[k].state = DEAD;
        return;
    }
    var beta = path.beta;
    if frame.depth == 1u {
        beta /= f32(frame.branches);
    } else { // as often as if the path had not been split
        let survival = min(max(beta.x, max(beta.y, beta.z)) * f32(frame.branches), 1.0);
        if at_point(path.pixel, ROULETTE).x >= survival {
            paths[k].state = DEAD;
            return;
        }
        beta /= max(survival, 1e-30);
    }
    let v = vertex_of(path);
    if is_inside(v) {
        paths[k].state = DEAD;
        return;
    }
    let u = vec3f(at_point(path.pixel, DIRECTION), at_point(path.pixel, CHOICES).y);
    var wi = vec3f(0.0);
    var pdf = 0.0;
    if v.kind == OF_MATERIAL {
        let b = bsdf_of(v);
        wi = bsdf_sample(b, v.wo, u);
        pdf = bsdf_density(b, v.wo, wi);
        let value = bsdf_value(b, v.ng, v.wo, wi) / ending_share(v);
        beta *= select(vec3f(0.0), value / max(pdf, 1e-30), pdf > 0.0);
        if all(beta <= vec3f(0.0)) {
            paths[k].state = DEAD;
            return;
        }
    } else {
        let is_fiber = v.kind == OF_FIBERS;
        let at = lobe_frame(v.shading, select(vec3f(0.0), v.axis, is_fiber), v.wo);
        let lobes = surface_lobes(v.surface);
        wi = lobe_sample(at, lobes, u.xy);
        pdf = lobe_density(at, lobes, wi);
        let weight = beta / max(pdf, 1e-30);
        queries[k].at_point = Query(
            v.x, v.h, v.axis, v.part, v.wo, NONE, wi, v.strand, weight, 0.0, vec3f(0.0), 0.0,
            base_color_of(path, v), vec3f(0.0),
        );
        paths[k].leaving = leaving_point(v, wi);
        beta = vec3f(0.0); // until the decoder has answered
    }
    let wi_world = normalize(rna_world_direction(wi, v.instance));
    paths[k].origin = origin_of(v, wi_world);
    paths[k].direction = wi_world;
    paths[k].pdf = pdf;
    paths[k].beta = beta;
    paths[k].ignored = select(NONE, v.instance, object_passes(v.instance) == 1u);
}
