// Lists of the paths that go on, so that steps are dispatched for these alone. A list is the workgroups to
// dispatch (x, y, z), its number of paths, and the paths.

const LIST_HEADER: u32 = 4u;

@group(0) @binding(6) var<storage, read_write> live: array<atomic<u32>>;

// A path of the step's list, or NONE.
fn live_path(at: u32) -> u32 {
    if at >= atomicLoad(&live[frame.list + 3u]) {
        return NONE;
    }
    return atomicLoad(&live[frame.list + LIST_HEADER + at]);
}
