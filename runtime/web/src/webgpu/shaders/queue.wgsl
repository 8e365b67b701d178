// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

struct Queue {
    width: u32,
    first_row: u32,
    rows: u32,
    part: u32,      // + 1
    emission: u32,  // 1: answers are of emission, one vec4f each
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Row {
    position: vec4<u32>,
    axis: vec4<u32>,
    wo: vec4<u32>,
    wi: vec4<u32>,
}

struct Lit {
    visibility: vec3f,
    is_query: u32,
    radiance: vec3f,
    unused: u32,
}

@group(0) @binding(0) var<uniform> queue: Queue;
@group(0) @binding(1) var<storage, read_write> rows: array<Row>;
@group(0) @binding(2) var<storage, read_write> through: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> lit: array<Lit>;
@group(0) @binding(4) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> asked: array<Row>;
@group(0) @binding(6) var<storage, read_write> answers: array<vec4f>;
@group(0) @binding(7) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

@compute @workgroup_size(64)
fn gather(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    if index >= queue.width * queue.rows || rows[index].axis.w != queue.part {
        return;
    }
    var row = rows[index];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], index);
    if queue.emission == 1u {
        row.wi = row.wo; // which no block of emission reads
    }
    asked[at] = row;
}

@compute @workgroup_size(64)
fn scatter(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let at = id.y * groups.x * 64u + id.x;
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let index = atomicLoad(&count[at + 1u]);
    var radiance: vec3f;
    if queue.emission == 1u {
        radiance = through[index].xyz * answers[at].xyz;
    } else {
        let own = lit[index];
        radiance = own.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, own.visibility);
    }
    sums[queue.first_row * queue.width + index] += vec4f(radiance, 0.0);
}
