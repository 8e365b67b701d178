// The asset's geometry in buffers: see geometry/scene_arrays.js. What this file and its neighbours do is what the
// spec says of hits (4) and of visibility rays (7.1).

// HAS_SEGMENTS and HAS_TEXTURES are declared by whoever composes the files: code that an asset has no use for
// is not compiled, which takes most of the time to its first picture.

struct View {
    camera: vec3f,
    epsilon: f32,           // the spec's e, 7.1
    corner: vec3f,          // direction through the image's top left corner
    width: u32,
    step_x: vec3f,          // of a pixel
    first_row: u32,         // of the band
    step_y: vec3f,
    rows: u32,              // of the band
    sample: u32,
    normals_at: u32,        // first normal in `rna_points`
    record_count: u32,
    texels_at: u32,         // first word of texels in `textures`
    part_count: u32,
    jitter: f32,            // 0: rays through the middles of pixels, 1: anywhere in them
    unused_b: u32,
    unused_c: u32,
    part_first: array<vec4<u32>, 4>, // number of each part's first primitive
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> nodes: array<vec4<u32>>;      // two a node
@group(0) @binding(2) var<storage, read> primitives: array<vec4<u32>>; // in the order of the leaves
@group(0) @binding(3) var<storage, read> rna_points: array<vec4f>; // position, u or radius; then normal, v
@group(0) @binding(4) var<storage, read> textures: array<u32>;   // twelve words a record, then texels

const SEGMENT = 0x80000000u;
const FAR = RNA_FAR;

// What rna_gpu's triangle.wgsl and segment.wgsl take; a renderer with instances declares them in geometry.wgsl.
const RNA_FAR: f32 = 1e30;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct Hit {
    t: f32,
    number: u32, // of the primitive, with SEGMENT
    place: u32,  // of it in `primitives`
    b1: f32,     // barycentric coordinates
    b2: f32,
    n: vec3f,    // of a segment, outward
}

fn part_of(number: u32) -> u32 {
    var found = 0u;
    var first = -1;
    for (var k = 0u; k < view.part_count; k++) {
        let own = i32(view.part_first[k / 4u][k % 4u]);
        if i32(number) >= own && own > first {
            found = k;
            first = own;
        }
    }
    return found;
}

fn unit(v: vec3f) -> vec3f {
    let size = abs(v);
    let largest = max(size.x, max(size.y, size.z));
    if largest == 0.0 {
        return vec3f(0.0);
    }
    return normalize(v / largest);
}
