// The closest hit of each path's ray; with it, whether an asset is in its own way.

@compute @workgroup_size(64)
fn closest(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    let path = paths[k];
    let hit = trace(RnaRay(path.origin, 0.0, path.direction, RNA_FAR), path.own, false);
    paths[k].t = hit.t;
    paths[k].instance = hit.instance;
    paths[k].primitive = hit.primitive;
    paths[k].b1 = hit.b1;
    paths[k].b2 = hit.b2;
    paths[k].normal = hit.normal;
    if pendings[k].part == NONE {
        return;
    }
    pendings[k].visible = select(0.0, 1.0, path.self_t > hit.t || path.self_t >= RNA_FAR);
    if hit.instance == RNA_NOTHING && (frame.flags & HAS_SKY) == 0u {
        pendings[k].part = NONE; // a ray into a black sky brings nothing
    }
}
