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

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;
const MIRROR_KAPPA = 60.0;

fn about(axis: vec3f, cosine: f32, turn: f32) -> vec3f {
    let side = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(axis.x) > 0.7);
    let u = normalize(cross(side, axis));
    let angle = 6.2831853 * turn;
    let radius = sqrt(max(0.0, 1.0 - cosine * cosine));
    return radius * (cos(angle) * u + sin(angle) * cross(axis, u)) + cosine * axis;
}

// One of `count` directions about a point, and its density, as the viewer draws them: some about the mirror direction,
// some by the cosine about the normal, some from all sides, since light comes through; about strands all of these.
fn direction_about(number: f32, count: f32, turn: f32) -> vec4f {
    let v = vertex;
    let wo = v.wo;
    let n = select(v.n, -v.n, dot(v.n, wo) < 0.0);
    let mirror = reflect(-wo, n);
    let share = select(MIRRORED, 0.0, v.strand != RNA_NOTHING);
    let all = select(FROM_ALL_SIDES, 1.0, v.strand != RNA_NOTHING);
    let place = (number + fract(12.9898 * turn + 0.7548777 * number)) / count;
    let angle = fract(turn + number * 0.61803399);
    var wi: vec3f;
    if place < share {
        let u = place / share;
        wi = about(mirror, 1.0 + log(u + (1.0 - u) * exp(-2.0 * MIRROR_KAPPA)) / MIRROR_KAPPA, angle);
    } else {
        let rest = (place - share) / (1.0 - share);
        if rest < all {
            wi = about(n, 1.0 - 2.0 * rest / all, angle);
        } else {
            wi = about(n, sqrt((rest - all) / (1.0 - all)), angle);
        }
    }
    let scale = MIRROR_KAPPA / (6.2831853 * (1.0 - exp(-2.0 * MIRROR_KAPPA)));
    let in_lobe = scale * exp(MIRROR_KAPPA * (dot(mirror, wi) - 1.0));
    let in_rest = mix(max(0.0, dot(n, wi)) / 3.14159265, 1.0 / 12.5663706, all);
    return vec4f(wi, mix(in_rest, in_lobe, share));
}
