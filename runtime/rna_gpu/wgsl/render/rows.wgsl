// Queries of one part: gathered from the paths that have one, and what becomes of the answers.

struct Row {
    x: vec3f,
    h: f32,
    axis: vec3f,
    a: f32,
    wo: vec3f,
    b: f32,
    wi: vec3f,
    c: f32,
}

@group(1) @binding(0) var<storage, read_write> rows: array<Row>;
@group(1) @binding(1) var<storage, read_write> results: array<vec4f>;
@group(1) @binding(2) var<storage, read_write> row_count: atomic<u32>;
@group(1) @binding(3) var<storage, read_write> path_of_row: array<u32>;

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || paths[k].state == DEAD || pendings[k].part != frame.neural_part {
        return;
    }
    let asked = pendings[k];
    let row = atomicAdd(&row_count, 1u);
    rows[row] = Row(asked.x, asked.h, asked.axis, 0.0, asked.wo, 0.0, asked.wi, 0.0);
    path_of_row[row] = k;
}

@compute @workgroup_size(64)
fn apply(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = path_number(id, groups);
    if row >= atomicLoad(&row_count) {
        return;
    }
    let k = path_of_row[row];
    let asked = pendings[k];
    if (frame.flags & FOR_EMISSION) != 0u {
        let emitted = clamped(asked.weight * results[row].xyz);
        sums[frame.sums * k] += vec4f(emitted, 0.0);
        return;
    }
    let transport = mix(results[2u * row + 1u].xyz, results[2u * row].xyz, asked.visible);
    if (frame.flags & FOR_BETA) != 0u {
        paths[k].beta = asked.weight * transport;
    } else {
        add_light(k, asked.light, clamped(asked.weight * transport));
    }
}
