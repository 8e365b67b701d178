// The point that a path has come to, from its hit.

// Of a rounding error, 2^-24, the times that it may come in: rna_trace/hit_points.py has half of it, in float64.
const ROUNDING: f32 = 32.0 * 0x1p-24f;
const LEAST_STEP: f32 = 0x1p-24f; // as there

struct Vertex {
    x: vec3f, // object space, as all that is not said otherwise
    kind: u32,
    n: vec3f, // interpolated normal, or that of a segment
    surface: u32,
    ng: vec3f,
    part: u32,
    lift: vec3f,
    h: f32,
    axis: vec3f, // of a decoder's queries: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: RnaPrimitive, // of its primitive
    step: f32, // of materials: how far along ng_world rays from here start
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: RnaPrimitive, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
    );
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz);
    v.x = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
    let mixed = n * b;
    v.n = select(vec3f(0.0), mixed / max(length(mixed), 1e-30), dot(mixed, mixed) > 0.0);
    let area = cross(p[1] - p[0], p[2] - p[0]);
    let largest = max(abs(area.x), max(abs(area.y), abs(area.z)));
    if largest > 0.0 {
        v.ng = normalize(area / largest);
    }
    v.lift = rna_lift(v.x, b, p, n);
    v.shading = v.n;
    v.b1 = b1;
    v.b2 = b2;
    let map = surface_normal_map(rna_surface(record));
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

// u and n as of the hit: the point of an RnaEntry, without the error of its ray's length.
fn segment_vertex(record: RnaPrimitive, u: f32, n: vec3f, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = n;
    v.ng = n;
    v.x = mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// Of a triangle's point: its place in the world, and the step of rays from there, both as right where the triangle is
// wide as where it is small: rna_trace/hit_points.py. The ray has hit it at t, world units.
fn place_vertex(v: ptr<function, Vertex>, record: RnaPrimitive, ray: RnaRay, t: f32) {
    let instance = (*v).instance;
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let size = rna_box_size(e1, e2);
    let far = t / rna_instances[instance].scale;
    let longest = max(size.x, max(size.y, size.z));
    if longest > far {
        let x = rna_object_point(ray.origin, instance) + far * rna_object_direction(ray.direction, instance);
        (*v).x = x - dot(x - p, (*v).ng) * (*v).ng;
    }
    (*v).x_world = rna_world_point((*v).x, instance);
    (*v).ng_world = rna_world_direction((*v).ng, instance);
    let reach = abs((*v).x_world) + abs(rna_instances[instance].place);
    let rounded = reach.x * abs(rna_instances[instance].rotation[0].xyz)
        + reach.y * abs(rna_instances[instance].rotation[1].xyz)
        + reach.z * abs(rna_instances[instance].rotation[2].xyz);
    // The volume of the box over twice the area; the latter by the largest component, whose square stays in float32.
    let n = cross(e1, e2);
    let largest = max(abs(n.x), max(abs(n.y), abs(n.z)));
    let uncertain = LEAST_STEP * longest + select(0.0, size.x / largest * size.y * size.z, largest > 0.0);
    let along = abs((*v).ng) + LEAST_STEP;
    (*v).step = ROUNDING * (dot(along, rounded) + rna_instances[instance].scale * uncertain);
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(record, path.b1, path.normal, wo);
    }
    v.record = record;
    v.surface = rna_surface(record);
    v.kind = surface_kind(v.surface);
    v.part = surface_part(v.surface);
    if v.kind == OF_MATERIAL {
        v.shading = bumped_normal(record, v.b1, v.b2, v.n, v.ng, wo);
    }
    v.wo = wo;
    v.instance = path.instance;
    if v.kind == OF_MATERIAL {
        place_vertex(&v, record, RnaRay(path.origin, 0.0, path.direction, RNA_FAR), path.t);
    } else {
        v.x_world = rna_world_point(v.x, path.instance);
        v.ng_world = rna_world_direction(v.ng, path.instance);
    }
    v.n_world = rna_world_direction(v.shading, path.instance);
    return v;
}

// Of the asset's point where a path is.
fn base_color_of(path: Path, v: Vertex) -> vec3f {
    if v.kind == OF_FIBERS {
        return vec3f(1.0);
    }
    let width = frame.spread * path.t / rna_instances[v.instance].scale;
    return base_color_on(v.record, v.b1, v.b2, width);
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    return v.x_world + select(v.step, -v.step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Origin of the visibility ray along wi against the asset itself; object space.
fn leaving_point(v: Vertex, wi: vec3f) -> vec3f {
    if v.kind == OF_FIBERS {
        return v.x;
    }
    let extent = rna_instances[v.instance].extent;
    return rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, extent);
}

fn instance_scale(instance: u32) -> f32 {
    return rna_instances[instance].scale;
}

// Whether a scattered ray has come to the point from inside a solid. Captures see assets from outside; inside they are
// black.
fn is_inside(v: Vertex) -> bool {
    let never = select(FRONT_ALONE, BACK_ALONE, dot(v.ng, v.wo) > 0.0);
    return frame.depth > 1u && surface_has(v.surface, never);
}
