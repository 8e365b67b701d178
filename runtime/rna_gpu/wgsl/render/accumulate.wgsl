// Adds a sample of each pixel to the film.

@group(1) @binding(0) var<storage, read_write> film: array<vec4f>;

const LARGEST: f32 = 1e18; // whose square, summed over all samples, is finite

@compute @workgroup_size(64)
fn accumulate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let at = frame.sums * k;
    let to = (frame.sums + 1u) * k;
    let sort = sums[at + SUM_NORMAL].w;
    let colour = min(sums[at + SUM_BEAUTY].xyz, vec3f(LARGEST));
    film[to] += vec4f(colour * colour, select(0.0, 1.0, sort == 2.0));
    for (var slot = 0u; slot < frame.sums; slot++) {
        var value = sums[at + slot];
        if slot == SUM_NORMAL {
            value.w = select(0.0, 1.0, sort == 1.0);
        } else if slot == SUM_POSITION && film[to + 1u + slot].w != 0.0 {
            value.w = 0.0;
        }
        film[to + 1u + slot] += value;
    }
}
