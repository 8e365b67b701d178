// Queries of one part: collected from the paths that have one, and the results applied to them.

@group(1) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> results: array<vec4f>;
@group(1) @binding(2) var<storage, read_write> row_count: RowCount;
@group(1) @binding(3) var<storage, read_write> path_of_row: array<u32>;

struct RowCount {
    rows: atomic<u32>,
    groups: atomic<u32>, // workgroups that take all of them, which are dispatched
    one: vec2<u32>,
}

// A decoder of visible or of shadowed light alone is needed where that light counts.
fn is_needed(visible: vec3f) -> bool {
    if (frame.flags & FOR_VISIBLE) != 0u {
        return any(visible > vec3f(0.0));
    }
    return (frame.flags & FOR_SHADOWED) == 0u || any(visible < vec3f(1.0));
}

// Whether the other decoder of the part counts the query.
fn is_counted(visible: vec3f) -> bool {
    return (frame.flags & FOR_SHADOWED) != 0u && any(visible > vec3f(0.0));
}

// The query of a path that a step is about.
fn query_of(k: u32) -> Query {
    if (frame.flags & FOR_LIGHT) != 0u {
        return queries[k].at_light;
    }
    return queries[k].at_point;
}

fn bits_of(v: vec3f) -> vec3<u32> {
    return bitcast<vec3<u32>>(v);
}

@compute @workgroup_size(64)
fn gather(@builtin(global_invocation_id) id: vec3<u32>) {
    let k = live_path(id.x);
    if k >= frame.paths || paths[k].state == DEAD {
        return;
    }
    let query = query_of(k);
    if query.part != frame.neural_part || !is_needed(query.visible) {
        return;
    }
    let row = atomicAdd(&row_count.rows, 1u);
    if row % 64u == 0u {
        atomicAdd(&row_count.groups, 1u);
    }
    rows[row] = RnaRow(
        bits_of(query.x), bitcast<u32>(query.h), bits_of(query.axis), bitcast<u32>(query.base_color.x),
        bits_of(query.wo), bitcast<u32>(query.base_color.y), bits_of(query.wi),
        bitcast<u32>(query.base_color.z), bits_of(query.nearby), 1u,
    );
    path_of_row[row] = k;
    if (frame.flags & (FOR_EMISSION | FOR_LIGHT)) == 0u && !is_counted(query.visible) {
        watch_domain(query.part, query.wo, query.wi);
    }
}

// What an asset emits as a light, for what waits for it.
fn apply_light(k: u32, emitted: vec3f) {
    let query = queries[k].at_point;
    let light = query.weight * emitted;
    queries[k].at_point.weight = light;
    if query.part == MATERIAL_PART {
        add_light(k, query.light, clamped(light));
    } else if query.part == CATCHER_PART {
        let third = vec3f(1.0 / 3.0);
        let received = dot(light * query.visible, third);
        sums[frame.sums * k + SUM_LIGHT_SAMPLES] += vec4f(0.0, 0.0, received, dot(light, third));
    }
    if all(emitted <= vec3f(0.0)) && query.part != CATCHER_PART {
        queries[k].at_point.part = NONE;
        if frame.depth == 1u { // there was no light to be found
            sums[frame.sums * k + SUM_LIGHT_SAMPLES] -= vec4f(1.0, query.seen, 0.0, 0.0);
        }
    }
}

@compute @workgroup_size(64)
fn apply(@builtin(global_invocation_id) id: vec3<u32>) {
    let row = id.x;
    if row >= atomicLoad(&row_count.rows) {
        return;
    }
    let k = path_of_row[row];
    let query = queries[k].at_point;
    if (frame.flags & FOR_LIGHT) != 0u {
        apply_light(k, results[row].xyz);
        return;
    }
    if (frame.flags & FOR_EMISSION) != 0u {
        add_light(k, query.light, clamped(query.weight * results[row].xyz));
        return;
    }
    var transport = vec3f(0.0);
    if (frame.flags & FOR_SHADOWED) == 0u {
        transport = query.visible * results[2u * row].xyz;
    }
    if (frame.flags & FOR_VISIBLE) == 0u {
        transport += (1.0 - query.visible) * results[2u * row + 1u].xyz;
    }
    if (frame.flags & FOR_BETA) != 0u {
        paths[k].beta += query.weight * transport;
    } else {
        add_light(k, query.light, clamped(query.weight * transport));
    }
}
