// Nearby light of one part's pixels, along the directions of light that light_pixels has drawn. All lights are far away.

@compute @workgroup_size(64)
fn find_nearby(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let x = bitcast<vec3f>(band[k].position.xyz);
    let wi = bitcast<vec3f>(band[k].wi.xyz);
    let u = at_point(view.first + k, NEARBY + LIGHT + view.number);
    start_passing(PASS_MOST);
    band[k].nearby = nearby_light(rna_instances[0].root, view.lengths, x, wi, RNA_FAR, u);
}
