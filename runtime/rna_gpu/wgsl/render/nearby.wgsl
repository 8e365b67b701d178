// Nearby light of the queries of a part that counts it, before its decoder answers them.

@compute @workgroup_size(64)
fn nearby(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD || queries[k].at_point.part != frame.neural_part {
        return;
    }
    let path = paths[k];
    let query = queries[k].at_point;
    let of_ray = (frame.flags & FOR_BETA) != 0u; // which has left the point
    let instance = select(path.instance, path.ignored, of_ray);
    var u = at_light_sample(path.pixel, NEARBY + LIGHT);
    if of_ray {
        u = at_point(path.pixel, NEARBY + DIRECTION);
    }
    start_passing(PASS_MOST);
    let root = rna_instances[instance].root;
    queries[k].at_point.nearby = nearby_light(root, frame.lengths, query.x, query.wi, query.far, u);
}
