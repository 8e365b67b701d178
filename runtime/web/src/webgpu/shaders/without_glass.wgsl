// What render/solid_glass.wgsl has, for assets without glass beside them.

struct Followed {
    hit: RnaHit,
    weight: vec3f,
    bent: bool,
    ray: RnaRay,
}

fn follow(start: RnaRay, ignored: u32, depth: u32, pixel: u32) -> Followed {
    let through = closest_through(start, ignored, frame.rays, chance_of(pixel));
    return Followed(through.hit, through.weight, false, start);
}
