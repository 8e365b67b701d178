// Visibility, mapped normals and base colours at hits of an asset: `paths` hold the hits, results
// go to `sums`. Instance 0 is the asset, untransformed.

fn probed(k: u32) -> Vertex {
    let path = paths[k];
    let record = rna_primitives[path.primitive];
    if !rna_is_segment(record) {
        var v = triangle_vertex(record, path.b1, path.b2);
        v.kind = OF_NEURAL;
        return v;
    }
    var v: Vertex;
    v.kind = OF_FIBERS;
    v.x = path.origin;
    v.strand = rna_strand(record);
    return v;
}

@compute @workgroup_size(64)
fn visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let v = probed(k);
    let wi = paths[k].direction;
    let way = RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR);
    sums[k] = vec4f(start_visibility(0u, way, v.strand), 0.0);
}

@compute @workgroup_size(64)
fn mapped(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        sums[k] = vec4f(probed(k).axis, 0.0);
    }
}

// t: the level of the image.
@compute @workgroup_size(64)
fn colored(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let path = paths[k];
        let record = rna_primitives[path.primitive];
        sums[k] = vec4f(base_color_of_level(record, path.b1, path.b2, path.t), 0.0);
    }
}
