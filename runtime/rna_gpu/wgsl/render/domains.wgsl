// Counts queries outside the directions that an asset was trained for: rna_render/world/domain_watch.py.
// A part has (cones of wo, the first, cones of wi, the first) in `table`, as bits; a cone is its axis
// and the cosine to its rim.

@group(1) @binding(4) var<storage, read_write> counts: array<atomic<u32>>; // of a part: queries,
    // views outside, lights outside, either

fn in_region(cones: u32, first: u32, d: vec3f) -> bool {
    if cones == ALL_DIRECTIONS {
        return true;
    }
    if cones == HEMISPHERE {
        return d.y >= 0.0;
    }
    for (var k = 0u; k < cones; k++) {
        let cone = table[frame.domains + first + k];
        if dot(d, cone.xyz) >= cone.w {
            return true;
        }
    }
    return false;
}

fn watch_domain(part: u32, wo: vec3f, wi: vec3f) {
    let domain = bitcast<vec4<u32>>(table[frame.domains + part]);
    if domain.x == ALL_DIRECTIONS && domain.z == ALL_DIRECTIONS {
        return;
    }
    let seen = in_region(domain.x, domain.y, wo);
    let lit = in_region(domain.z, domain.w, wi);
    atomicAdd(&counts[4u * part], 1u);
    atomicAdd(&counts[4u * part + 1u], select(1u, 0u, seen));
    atomicAdd(&counts[4u * part + 2u], select(1u, 0u, lit));
    atomicAdd(&counts[4u * part + 3u], select(1u, 0u, seen && lit));
}
