// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they call
//     fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool
// which opaque.wgsl answers, or a host that knows what lets light through; found: (t, b1, b2).

// Nodes to come back to: of the tree over instances, then of a body's. Private, since a function's own
// array would be set to 0 at every call.
var<private> rna_stack: array<u32, 2u * RNA_STACK>;

fn rna_inverse(d: vec3f) -> vec3f {
    let tiny = select(vec3f(1e-20), vec3f(-1e-20), d < vec3f(0.0));
    return vec3f(1.0) / select(d, tiny, abs(d) < vec3f(1e-20));
}

// Where the ray enters a node's box; RNA_FAR where it does not.
fn rna_enter_node(node: u32, origin: vec3f, inverse: vec3f, near: f32, far: f32) -> f32 {
    let a = (rna_nodes[node].low - origin) * inverse;
    let b = (rna_nodes[node].high - origin) * inverse;
    let lower = min(a, b);
    let upper = max(a, b);
    let enter = max(max(lower.x, lower.y), max(lower.z, near));
    let leave = min(min(upper.x, upper.y), min(upper.z, far));
    return select(RNA_FAR, enter, enter <= leave * 1.0000005);
}

// The next node down, nearer child first; RNA_NOTHING where none is hit.
fn rna_descend(
    node: u32, ray: RnaRay, inverse: vec3f, far: f32, top: ptr<function, u32>,
) -> u32 {
    let left = node + 1u;
    let right = rna_nodes[node].child;
    let to_left = rna_enter_node(left, ray.origin, inverse, ray.near, far);
    let to_right = rna_enter_node(right, ray.origin, inverse, ray.near, far);
    if to_left >= RNA_FAR && to_right >= RNA_FAR {
        return RNA_NOTHING;
    }
    if to_left >= RNA_FAR {
        return right;
    }
    if to_right >= RNA_FAR {
        return left;
    }
    let left_first = to_left <= to_right;
    rna_stack[*top] = select(left, right, left_first);
    *top += 1u;
    return select(right, left, left_first);
}

// Tests a primitive; whether it is hit nearer than `hit`, which is then set to it.
fn rna_meet(primitive: u32, ray: RnaRay, start_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if !rna_is_segment(record) {
        let crossing = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if crossing.x >= RNA_FAR || !rna_stops(primitive, ray, crossing, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(crossing.x, (*hit).instance, primitive, crossing.y, crossing.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == start_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, entry.u, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below `root`, ray in its object space, nearer than `hit`; with `any`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, start_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var is_hit = false;
    let inverse = rna_inverse(ray.direction);
    while node != RNA_NOTHING {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count && !(any && is_hit); k++) {
            is_hit = rna_meet(first + k, ray, start_strand, hit) || is_hit;
        }
        if next == RNA_NOTHING && top > RNA_STACK {
            top -= 1u;
            next = rna_stack[top];
        }
        node = select(next, RNA_NOTHING, any && is_hit);
    }
    return is_hit;
}

// Tests an instance, world ray; `ignored` is passed through, and so is what `rays` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, ignored: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == ignored || (rna_instances[instance].rays & rays) == 0u {
        return false;
    }
    let scale = rna_instances[instance].scale;
    let local = rna_to_object(ray, instance);
    var nearest = *hit;
    nearest.instance = instance;
    nearest.t = min((*hit).t / scale, RNA_FAR);
    if !rna_trace_body(rna_instances[instance].root, local, RNA_NOTHING, any, &nearest) {
        return false;
    }
    nearest.t *= scale;
    *hit = nearest;
    return true;
}

// The closest hit in the world, or with `any` some hit.
fn rna_trace(ray: RnaRay, ignored: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    var is_hit = false;
    let inverse = rna_inverse(ray.direction);
    while node != RNA_NOTHING {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count && !(any && is_hit); k++) {
            is_hit = rna_trace_instance(first + k, ray, ignored, rays, any, &hit) || is_hit;
        }
        if next == RNA_NOTHING && top > 0u {
            top -= 1u;
            next = rna_stack[top];
        }
        node = select(next, RNA_NOTHING, any && is_hit);
    }
    return hit;
}
