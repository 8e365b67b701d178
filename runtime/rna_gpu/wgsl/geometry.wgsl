// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; `instances` place the bodies in the world. `geometry.py` fills them.

// A node: two vec4f. An inner one has the corner min and, as bits, its right child, then max and 0;
// its left child is the next node. A leaf has its first primitive instead, and their number.
@group(2) @binding(0) var<storage, read> rna_nodes: array<vec4f>;

// A triangle: three points and 2 surface. A segment: its first point, neighbours on its strand
// (1: before, 2: after), strand and 2 surface + 1.
@group(2) @binding(1) var<storage, read> rna_primitives: array<vec4<u32>>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

// RNA_INSTANCE vec4f each: rows of the matrix to object space (3), of the rotation to the world (3),
// then translation to the world and scale, then root node, bits of the rays that meet it, largest
// coordinate of its body, a number of the host's. The nodes of the tree over instances come first in rna_nodes.
@group(2) @binding(3) var<storage, read> rna_instances: array<vec4f>;

const RNA_INSTANCE: u32 = 8u;
const RNA_FAR: f32 = 1e30;
const RNA_STACK: u32 = 48u;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct RnaHit {
    t: f32,
    instance: u32, // RNA_NOTHING for a miss
    primitive: u32,
    b1: f32, // barycentric coordinates of a triangle's second and third corner
    b2: f32,
    normal: vec3f, // outward, of a segment
}

const RNA_NOTHING: u32 = 0xffffffffu;

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let at = RNA_INSTANCE * instance;
    let scale = rna_instances[at + 6u].w;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let at = RNA_INSTANCE * instance;
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[at], p), dot(rna_instances[at + 1u], p), dot(rna_instances[at + 2u], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    let at = RNA_INSTANCE * instance;
    return d.x * rna_instances[at + 3u].xyz + d.y * rna_instances[at + 4u].xyz
        + d.z * rna_instances[at + 5u].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    let at = RNA_INSTANCE * instance + 3u;
    return vec3f(
        dot(rna_instances[at].xyz, d),
        dot(rna_instances[at + 1u].xyz, d),
        dot(rna_instances[at + 2u].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    let place = rna_instances[RNA_INSTANCE * instance + 6u];
    return place.w * rna_world_direction(x, instance) + place.xyz;
}
