// Glass beside the asset, where rays of light start and where the camera looks.

const HAS_GLASS = true;

// What comes along wi to x, where glass may be in the way: rays that follow it through find the environment; the other
// sorts of light do not pass.
fn past_glass(number: u32, pixel: Pixel, x: vec3f, arrival: Arrival) -> vec3f {
    let ray = RnaRay(x, 0.0, arrival.wi, RNA_FAR);
    if view.kind != LIGHT_AROUND_POINT {
        start_passing(ALL_STOP);
        let is_hidden = rna_trace(ray, 0u, frame.rays, true).instance != RNA_NOTHING;
        return select(arrival.radiance, vec3f(0.0), is_hidden);
    }
    let followed = follow(ray, 0u, 1u, number);
    if !followed.bent {
        return arrival.radiance;
    }
    if followed.hit.instance != RNA_NOTHING {
        return vec3f(0.0);
    }
    let sky = look_up_image(0u, followed.ray.direction).radiance;
    let about_point = surroundings_of(pixel);
    return followed.weight * sky / lobe_density(about_point.at, about_point.lobes, arrival.wi);
}

// What a ray that comes out of glass and meets nothing sees: the ground, and beyond it the environment.
fn seen_behind_glass(pixel: Pixel, ground: vec3f, coverage: f32) -> vec3f {
    if view.kind != LIGHT_ENVIRONMENT {
        return ground;
    }
    return ground + (1.0 - coverage) * look_up_image(0u, -bitcast<vec3f>(pixel.wo.xyz)).radiance;
}
