// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit {
    var hit = of_geometry;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
        let t = meet_light(light, RnaRay(ray.origin, ray.near, ray.direction, hit.t));
        if !hidden && t < RNA_FAR && (hit.instance == RNA_NOTHING || t < hit.t) {
            hit = rna_miss(t);
            hit.instance = IS_LIGHT | light;
        }
    }
    return hit;
}
