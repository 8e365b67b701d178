// Every triangle stops every ray.

fn rna_stops(primitive: u32, ray: RnaRay, crossing: vec3f, instance: u32) -> bool {
    return true;
}
