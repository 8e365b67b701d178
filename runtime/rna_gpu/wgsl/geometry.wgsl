// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; instances place the bodies in the world. `geometry.py` fills them.

// The tree over instances comes first.
@group(2) @binding(0) var<storage, read> rna_nodes: array<RnaNode>;

@group(2) @binding(1) var<storage, read> rna_primitives: array<RnaPrimitive>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

@group(2) @binding(3) var<storage, read> rna_instances: array<RnaInstance>;

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
    b1: f32, // barycentric coordinates of a triangle's second and third corner; of a segment u of RnaEntry, 0
    b2: f32,
    normal: vec3f, // outward, of a segment
}

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

fn rna_is_segment(primitive: RnaPrimitive) -> bool {
    return (primitive.tag & RNA_IS_SEGMENT) != 0u;
}

fn rna_surface(primitive: RnaPrimitive) -> u32 {
    return primitive.tag >> RNA_SURFACE_SHIFT;
}

// Of a segment.
fn rna_strand(primitive: RnaPrimitive) -> u32 {
    return primitive.c;
}

// The size of a triangle's box, from its edges from the first corner.
fn rna_box_size(e1: vec3f, e2: vec3f) -> vec3f {
    let zero = vec3f(0.0);
    return max(max(e1, e2), zero) - min(min(e1, e2), zero);
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let scale = rna_instances[instance].scale;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[instance].to_object[0], p),
        dot(rna_instances[instance].to_object[1], p),
        dot(rna_instances[instance].to_object[2], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    return d.x * rna_instances[instance].rotation[0].xyz
        + d.y * rna_instances[instance].rotation[1].xyz
        + d.z * rna_instances[instance].rotation[2].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    return vec3f(
        dot(rna_instances[instance].rotation[0].xyz, d),
        dot(rna_instances[instance].rotation[1].xyz, d),
        dot(rna_instances[instance].rotation[2].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    return rna_instances[instance].scale * rna_world_direction(x, instance)
        + rna_instances[instance].place;
}
