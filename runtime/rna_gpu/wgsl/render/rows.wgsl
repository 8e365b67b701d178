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

// Which of a path's two queries a step is about.
fn pending_of(k: u32) -> u32 {
    return 2u * k + select(0u, 1u, (frame.flags & FOR_LIGHT) != 0u);
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    let asked = pendings[pending_of(k)];
    if asked.part != frame.neural_part {
        return;
    }
    let row = atomicAdd(&row_count, 1u);
    rows[row] = Row(asked.x, asked.h, asked.axis, 0.0, asked.wo, 0.0, asked.wi, 0.0);
    path_of_row[row] = k;
    if (frame.flags & (FOR_EMISSION | FOR_LIGHT)) == 0u {
        watch_domain(asked.part, asked.wo, asked.wi);
    }
}

// What an asset emits as a light, for what waits for it.
fn apply_light(k: u32, emitted: vec3f) {
    let asked = pendings[2u * k];
    let light = asked.weight * emitted;
    pendings[2u * k].weight = light;
    if asked.part == ADDS {
        add_light(k, asked.light, clamped(light));
    } else if asked.part == CATCHES_IT {
        let third = vec3f(1.0 / 3.0);
        let received = dot(light * asked.visible, third);
        sums[frame.sums * k + SUM_LIGHT_SAMPLES] += vec4f(0.0, 0.0, received, dot(light, third));
    }
    if all(emitted <= vec3f(0.0)) && asked.part != CATCHES_IT {
        pendings[2u * k].part = NONE;
        if frame.depth == 1u { // there was no light to be found
            sums[frame.sums * k + SUM_LIGHT_SAMPLES] -= vec4f(1.0, asked.seen, 0.0, 0.0);
        }
    }
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
    let asked = pendings[2u * k];
    if (frame.flags & FOR_LIGHT) != 0u {
        apply_light(k, results[row].xyz);
        return;
    }
    if (frame.flags & FOR_EMISSION) != 0u {
        add_light(k, asked.light, clamped(asked.weight * results[row].xyz));
        return;
    }
    let transport = mix(results[2u * row + 1u].xyz, results[2u * row].xyz, asked.visible);
    if (frame.flags & FOR_BETA) != 0u {
        paths[k].beta = asked.weight * transport;
    } else {
        add_light(k, asked.light, clamped(asked.weight * transport));
    }
}
