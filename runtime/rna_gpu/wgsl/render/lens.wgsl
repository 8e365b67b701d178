// The first ray of a path: of a pinhole, or of a thin lens, as rna_render.world.camera has both.

struct CameraRay {
    origin: vec3f,
    direction: vec3f,
}

// A point of the unit disk, uniform by area: Shirley and Chiu's concentric map (Journal of Graphics Tools 2(3), 1997).
fn on_disk(u: vec2f) -> vec2f {
    let p = 2.0 * u - 1.0;
    let is_wide = abs(p.x) > abs(p.y);
    let r = select(p.y, p.x, is_wide);
    if r == 0.0 {
        return vec2f(0.0);
    }
    let angle = select(PI / 2.0 - PI / 4.0 * (p.x / r), PI / 4.0 * (p.y / r), is_wide);
    return r * vec2f(cos(angle), sin(angle));
}

// at: in pixels, from the image's top left corner.
fn camera_ray(at: vec2f, pixel: u32) -> CameraRay {
    let way = frame.corner + at.x * frame.step_x + at.y * frame.step_y; // 1 along the line of sight
    if frame.focus == 0.0 {
        return CameraRay(frame.camera, normalize(way));
    }
    let p = on_disk(square(pixel, LENS, frame.sample));
    let offset = p.x * frame.lens_x + p.y * frame.lens_y;
    return CameraRay(frame.camera + offset, normalize(frame.focus * way - offset));
}
