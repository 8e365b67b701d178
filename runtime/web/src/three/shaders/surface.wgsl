// What the fragment shows: a triangle, at the point that was rasterised.

// Barycentric coordinates of x in a triangle; points beyond an edge, which multisampling asks for, go onto it.
fn barycentrics(x: vec3f, p: mat3x3f) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let v = x - p[0];
    let d11 = dot(e1, e1);
    let d12 = dot(e1, e2);
    let d22 = dot(e2, e2);
    let d1 = dot(v, e1);
    let d2 = dot(v, e2);
    let area = max(d11 * d22 - d12 * d12, 1e-38);
    let b1 = (d22 * d1 - d12 * d2) / area;
    let b2 = (d11 * d2 - d12 * d1) / area;
    let b = max(vec3f(1.0 - b1 - b2, b1, b2), vec3f(0.0));
    return b / max(b.x + b.y + b.z, 1e-30);
}

fn triangle_vertex(record: RnaPrimitive, x: vec3f, width: f32) -> Vertex {
    var v: Vertex;
    let p = mat3x3f(rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz);
    let n = mat3x3f(rna_normal(record.a), rna_normal(record.b), rna_normal(record.c));
    let b = barycentrics(x, p);
    v.x = p * b;
    v.n = normalize(n * b);
    v.ng = normalize(cross(p[1] - p[0], p[2] - p[0]));
    v.lift = rna_lift(v.x, b, p, n);
    v.axis = v.n;
    v.strand = RNA_NOTHING;
    v.surface = rna_surface(record);
    v.base_color = base_color_on(record, p, b, width);
    return v;
}

// width: of a pixel.
fn begin(primitive: u32, x: vec3f, wo: vec3f, width: f32) -> f32 {
    vertex = triangle_vertex(rna_primitives[primitive], x, width);
    vertex.wo = wo;
    return 1.0;
}
