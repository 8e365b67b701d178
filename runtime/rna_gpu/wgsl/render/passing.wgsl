// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened; columns of nearby light pass what lets through most.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed
const PASS_MOST: u32 = 4u; // what lets through half of the light or more: spec/RNA.md, 7.3

var<private> passing: u32;
var<private> passed_weight: vec3f;
var<private> is_coloured: bool;
var<private> stopped_share: vec3f; // of the last hit that stopped: what colours it leaves
var<private> chance_key: u32;

fn start_passing(how: u32) {
    passing = select(ALL_STOP, how, (frame.flags & TRANSMITS) != 0u);
    passed_weight = vec3f(1.0);
    is_coloured = false;
}

// In [0, 1), a fixed number for each primitive and ray.
fn chance(primitive: u32, instance: u32) -> f32 {
    let state = hash_bits(hash_bits(chance_key ^ primitive) + instance);
    return f32(state >> 8u) * 0x1p-24f;
}

fn pass_at_random(tau: vec3f, mean: f32, passes: bool) -> bool {
    let coloured = any(tau != vec3f(tau.x));
    if passes {
        is_coloured = is_coloured || coloured;
        return false;
    }
    stopped_share = select(vec3f(1.0), (1.0 - tau) / max(1.0 - mean, 1e-6), coloured);
    return true;
}

fn rna_stops(primitive: u32, ray: RnaRay, crossing: vec3f, instance: u32) -> bool {
    stopped_share = vec3f(1.0);
    if passing == ALL_STOP {
        return true;
    }
    let record = rna_primitives[primitive];
    if !surface_has(rna_surface(record), LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.a].xyz;
    let ng = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let facing = dot(ng, ray.direction) < 0.0;
    let tau = transmittance(record, crossing.y, crossing.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
    if passing == PASS_MOST {
        return mean < 0.5;
    }
    let passes = mean > 0.0 && chance(primitive, instance) < mean;
    if passing == AT_RANDOM {
        return pass_at_random(tau, mean, passes);
    }
    if passes {
        passed_weight *= tau / mean;
    }
    return false;
}
