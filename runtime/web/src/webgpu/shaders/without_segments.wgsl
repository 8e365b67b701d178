// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    u: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, 0.0, vec3f(0.0));
}
