// Rays against the hierarchy of three-mesh-bvh: the nearest hit, and how much light passes (spec, 7.1).

const STACK = 48;
const NO_STRAND = 0xffffffffu;

// No axis is exactly parallel: 0 times infinity would be no number.
fn inverse_of(d: vec3f) -> vec3f {
    return 1.0 / select(d, vec3f(1e-20), abs(d) < vec3f(1e-20));
}

// Where the ray enters the box of a node, FAR if not.
fn enters(node: u32, origin: vec3f, inverse: vec3f, far: f32) -> f32 {
    let first = bitcast<vec4f>(nodes[2u * node]);
    let second = bitcast<vec2f>(nodes[2u * node + 1u].xy);
    let a = (first.xyz - origin) * inverse;
    let b = (vec3f(first.w, second) - origin) * inverse;
    let low = min(a, b);
    let high = max(a, b);
    let near = max(max(low.x, low.y), max(low.z, 0.0));
    let last = min(min(high.x, high.y), min(high.z, far)) * 1.0000004;
    return select(FAR, near, near <= last);
}

// A primitive in a leaf, by rna_gpu's triangle.wgsl and segment.wgsl: whether it is met, nearer than `hit`,
// which then becomes it.
fn meets(place: u32, ray: RnaRay, own: u32, hit: ptr<function, Hit>) -> bool {
    let primitive = primitives[place];
    if !HAS_SEGMENTS || (primitive.w & SEGMENT) == 0u {
        let found = rna_meet_triangle(
            ray, rna_points[primitive.x].xyz, rna_points[primitive.y].xyz, rna_points[primitive.z].xyz,
        );
        if found.x >= FAR {
            return false;
        }
        *hit = Hit(found.x, primitive.w, place, found.y, found.z, vec3f(0.0));
        return true;
    }
    if primitive.z == own {
        return false;
    }
    let entry = rna_meet_segment(ray, primitive);
    if entry.t >= FAR {
        return false;
    }
    *hit = Hit(entry.t, primitive.w, place, 0.0, 0.0, entry.normal);
    return true;
}

// t is FAR where there is no hit.
fn nearest(origin: vec3f, d: vec3f) -> Hit {
    var hit = Hit(FAR, 0u, 0u, 0.0, 0.0, vec3f(0.0));
    let inverse = inverse_of(d);
    var stack: array<u32, STACK>;
    var top = 0;
    var node = 0u;
    if enters(0u, origin, inverse, FAR) == FAR {
        return hit;
    }
    loop {
        let words = nodes[2u * node + 1u];
        if (words.w >> 16u) == 0xffffu {
            for (var k = words.z; k < words.z + (words.w & 0xffffu); k++) {
                meets(k, RnaRay(origin, 0.0, d, hit.t), NO_STRAND, &hit);
            }
        } else {
            let left = node + 1u;
            let right = node + words.z;
            let a = enters(left, origin, inverse, hit.t);
            let b = enters(right, origin, inverse, hit.t);
            if max(a, b) < FAR {
                stack[top] = select(left, right, a <= b);
                top++;
            }
            if min(a, b) < FAR {
                node = select(right, left, a <= b);
                continue;
            }
        }
        if top == 0 {
            break;
        }
        top--;
        node = stack[top];
    }
    return hit;
}

// The light that passes from origin along d to infinity, strand `own` being no obstacle.
fn passes(origin: vec3f, d: vec3f, own: u32) -> vec3f {
    var light = vec3f(1.0);
    let inverse = inverse_of(d);
    var stack: array<u32, STACK>;
    var top = 0;
    var node = 0u;
    if enters(0u, origin, inverse, FAR) == FAR {
        return light;
    }
    loop {
        let words = nodes[2u * node + 1u];
        if (words.w >> 16u) == 0xffffu {
            for (var k = words.z; k < words.z + (words.w & 0xffffu); k++) {
                var hit: Hit;
                if meets(k, RnaRay(origin, 0.0, d, FAR), own, &hit) {
                    if (hit.number & SEGMENT) != 0u {
                        return vec3f(0.0);
                    }
                    light *= transmittance(primitives[k], hit, d);
                    if all(light == vec3f(0.0)) {
                        return light;
                    }
                }
            }
        } else {
            let left = node + 1u;
            let right = node + words.z;
            let first = enters(left, origin, inverse, FAR) < FAR;
            let second = enters(right, origin, inverse, FAR) < FAR;
            if first && second {
                stack[top] = right;
                top++;
            }
            if first || second {
                node = select(right, left, first);
                continue;
            }
        }
        if top == 0 {
            break;
        }
        top--;
        node = stack[top];
    }
    return light;
}
