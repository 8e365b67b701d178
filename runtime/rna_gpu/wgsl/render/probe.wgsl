// What hits of an asset see and are asked with, for the conformance kit: `paths` hold the hits, results
// go to `sums`. An instance of the asset in the world's place is number 0.

fn probed(k: u32) -> Vertex {
    let path = paths[k];
    let record = rna_primitives[path.primitive];
    if (record.w & 1u) == 0u {
        var v = triangle_vertex(record, path.b1, path.b2);
        v.kind = OF_NEURAL;
        return v;
    }
    var v: Vertex;
    v.kind = OF_FIBERS;
    v.x = path.origin;
    v.strand = record.z;
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
    sums[k] = vec4f(own_kept(0u, way, v.strand), 0.0);
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
