// The paths of the step's list that are alive, into the next list.

var<workgroup> alive: atomic<u32>;
var<workgroup> first: u32;

@compute @workgroup_size(64)
fn compact(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32,
) {
    if local == 0u {
        atomicStore(&alive, 0u); // which not all drivers do
    }
    workgroupBarrier();
    let k = live_path(id.x);
    var is_alive = false;
    if k < frame.paths {
        is_alive = paths[k].state == ALIVE;
    }
    var at = 0u;
    if is_alive {
        at = atomicAdd(&alive, 1u);
    }
    workgroupBarrier();
    if local == 0u {
        let count = atomicLoad(&alive);
        first = atomicAdd(&live[frame.next_list + 3u], count);
        atomicMax(&live[frame.next_list], (first + count + 63u) / 64u);
    }
    workgroupBarrier();
    if is_alive {
        atomicStore(&live[frame.next_list + LIST_HEADER + first + at], k);
    }
}
