// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

// From x, at barycentric coordinates b of a triangle, onto the smooth surface it stands for.
fn rna_lift(x: vec3f, b: vec3f, p: mat3x3f, n: mat3x3f) -> vec3f {
    return b.x * max(0.0, dot(p[0] - x, n[0])) * n[0]
        + b.y * max(0.0, dot(p[1] - x, n[1])) * n[1]
        + b.z * max(0.0, dot(p[2] - x, n[2])) * n[2];
}

// n: interpolated, ng: of the triangle; extent: largest absolute coordinate of the asset.
fn rna_leaving_origin(
    x: vec3f, n: vec3f, ng: vec3f, lift: vec3f, wi: vec3f, extent: f32,
) -> vec3f {
    let step = extent * 0x1p-18f;
    let above_plane = dot(ng, wi);
    let is_smooth = dot(n, ng) > 0.0;
    let above = select(above_plane, dot(n, wi), is_smooth);
    if is_smooth && above > 0.0 && above_plane < 0.1 {
        return x + (1.0 - max(0.0, above_plane) / 0.1) * lift + step * ng;
    }
    return x + select(step, -step, above < 0.0) * ng;
}
