// The closest hit of each path's ray; with it, whether an asset is in its own way.

@compute @workgroup_size(64)
fn closest(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    let path = paths[k];
    let ray = RnaRay(path.origin, 0.0, path.direction, RNA_FAR);
    let followed = follow(ray, path.ignored, frame.depth, path.pixel);
    let hit = followed.hit;
    if followed.bent {
        paths[k].origin = followed.ray.origin;
        paths[k].direction = followed.ray.direction;
        paths[k].pdf = BENT;
    }
    paths[k].t = hit.t;
    paths[k].instance = hit.instance;
    paths[k].primitive = hit.primitive;
    paths[k].b1 = hit.b1;
    paths[k].b2 = hit.b2;
    paths[k].normal = hit.normal;
    let query = queries[k].at_point;
    if query.part == NONE {
        paths[k].beta = path.beta * followed.weight;
        return;
    }
    if hit.instance == RNA_NOTHING && (frame.flags & HAS_SKY) == 0u {
        queries[k].at_point.part = NONE; // a ray into a black sky brings nothing
        return;
    }
    let far = min(followed.first / rna_instances[path.ignored].scale, RNA_FAR);
    let way = RnaRay(path.leaving, 0.0, query.wi, far);
    queries[k].at_point.far = far;
    queries[k].at_point.visible = start_visibility(path.ignored, way, query.strand);
    queries[k].at_point.weight = query.weight * followed.weight;
}
