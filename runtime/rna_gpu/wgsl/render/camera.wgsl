// The first rays, and sums of 0.

@group(1) @binding(0) var<storage, read> pixels: array<u32>; // of the band

@compute @workgroup_size(64)
fn camera(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let pixel = pixels[k];
    let u = square(pixel, 0u, frame.sample);
    let ray = camera_ray(vec2f(vec2<u32>(pixel % frame.width, pixel / frame.width)) + u, pixel);
    var path: Path;
    path.origin = ray.origin;
    path.pixel = pixel;
    path.direction = ray.direction;
    path.beta = vec3f(1.0);
    path.state = ALIVE;
    path.ignored = NONE;
    paths[k] = path;
    atomicStore(&live[frame.list + LIST_HEADER + k], k);
    queries[k].at_point.part = NONE;
    for (var slot = 0u; slot < frame.sums; slot++) {
        sums[frame.sums * k + slot] = vec4f(0.0);
    }
}
