// What the asset sends to the viewer of light from one direction, and how much of that light it keeps from itself.

// How far before the asset shadow maps are asked, in EXTENT: nearer, a coarse map has the asset's own shadow.
const MAP_MARGIN = 0.03;

// x: visibility of the light along wi, 0 or 1. y: how far along wi others may shadow the point: shortly before the light
// enters the asset, so that a shadow map in which the asset itself is tells of others alone.
fn self_visibility(wi: vec3f, wants_entry: bool) -> vec2f {
    let v = vertex;
    var origin = v.x;
    if v.strand == RNA_NOTHING {
        origin = rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, EXTENT);
    }
    var hit = rna_miss(RNA_FAR);
    if !rna_trace_body(1u, RnaRay(origin, 0.0, wi, RNA_FAR), v.strand, true, &hit) {
        return vec2f(1.0, MAP_MARGIN * EXTENT);
    }
    if !wants_entry {
        return vec2f(0.0);
    }
    let far = 4.0 * EXTENT;
    var entry = rna_miss(far);
    rna_trace_body(1u, RnaRay(v.x + far * wi, 0.0, -wi, far), v.strand, false, &entry);
    return vec2f(0.0, far - entry.t + MAP_MARGIN * EXTENT);
}

// One of `count` directions about a point, and its density: those of the rays that leave the asset.
fn direction_about(number: f32, count: f32, turn: f32) -> vec4f {
    let at = lobe_frame(vertex.n, vertex.axis, vertex.wo);
    let place = (number + fract(12.9898 * turn + 0.7548777 * number)) / count;
    let angle = fract(turn + number * 0.61803399);
    var mixtures = MIXTURES;
    let lobes = mixtures[vertex.surface];
    let wi = lobe_sample(at, lobes, vec2f(place, angle));
    return vec4f(wi, lobe_density(at, lobes, wi));
}
