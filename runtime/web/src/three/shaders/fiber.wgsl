// What the fragment shows: a segment, where the ray through the fragment, which lies on a box about it, meets it.

fn begin(primitive: u32, x: vec3f, wo: vec3f, width: f32) -> f32 {
    let record = rna_primitives[primitive];
    let cone = rna_cone(record.a);
    let origin = x + 4.0 * max(cone.ra, cone.rb) * wo;
    let entry = rna_meet_segment(RnaRay(origin, 0.0, -wo, RNA_FAR), record);
    vertex.x = origin - entry.t * wo;
    vertex.n = entry.normal;
    vertex.ng = entry.normal;
    vertex.wo = wo;
    vertex.strand = rna_strand(record);
    vertex.surface = rna_surface(record);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    vertex.axis = normalize(way / size);
    let across = cross(vertex.axis, wo);
    let sine = length(across);
    vertex.h = 0.0;
    if sine > 1e-6 {
        vertex.h = clamp(dot(vertex.n, across) / sine, -1.0, 1.0);
    }
    return select(1.0, 0.0, entry.t >= RNA_FAR);
}
