// What render/solid_glass.wgsl has, for assets without glass beside them.

struct Followed {
    hit: RnaHit,
    weight: vec3f,
    bent: bool,
    ray: RnaRay,
}

fn follow(start: RnaRay, own: u32, depth: u32, pixel: u32) -> Followed {
    let found = closest_through(start, own, frame.rays, chance_of(pixel));
    return Followed(found.hit, found.weight, false, start);
}
