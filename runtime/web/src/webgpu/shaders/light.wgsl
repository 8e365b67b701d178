// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, mirror_cosine(u.y / share), u.x));
    }
    let rest = (u.y - share) / (1.0 - share);
    let all_sides = rest < FROM_ALL_SIDES;
    let v = select((rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES), rest / FROM_ALL_SIDES, all_sides);
    let ball = along_axis(vec3f(0.0, 0.0, 1.0), 1.0 - 2.0 * v, u.x);
    return normalize(ball + select(at.n * 1.0001, vec3f(0.0), all_sides));
}

fn density_about(at: Surroundings, wi: vec3f) -> f32 {
    if all(at.n == vec3f(0.0)) {
        return SPHERE_PDF;
    }
    let rest = mix(max(0.0, dot(at.n, wi)) / PI, SPHERE_PDF, FROM_ALL_SIDES);
    return mix(rest, mirror_pdf(dot(at.mirror, wi)), mirrored_share(at));
}

fn surroundings_of(pixel: Pixel) -> Surroundings {
    if pixel.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if rna_is_segment(rna_primitives[pixel.wo.w]) {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// The direction of queries for lobes. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(u: vec2f, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let wi = normalize(along_axis(vec3f(0.0, 1.0, 0.0), 1.0 - 2.0 * u.y, u.x) + vec3f(0.0, 1.0001, 0.0));
        return Arrival(wi, view.colour / max(wi.y, 1e-3));
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    let m = select(reflect(-wo, axis), reflect(wo, axis), rna_is_segment(rna_primitives[pixel.wo.w]));
    return Arrival(m, vec3f(1.0));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == LIGHT_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == LIGHT_GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let is_bright = view.kind == LIGHT_ENVIRONMENT;
    let u = at_point(number, select(DIRECTION, LIGHT, is_bright));
    if view.kind == LIGHT_MIRROR {
        return mirrored(u, pixel);
    }
    let at = surroundings_of(pixel);
    if is_bright {
        let bright = sample_image(0u, u);
        return Arrival(bright.wi, bright.radiance / (bright.pdf + density_about(at, bright.wi)));
    }
    let wi = direction_about(at, u);
    let sky = look_up_image(0u, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + density_about(at, wi)));
}

// Where rays of light start, the strand that they pass, and what is sent on of the light; of the ground how much it
// covers.
struct Start {
    x: vec3f,
    strand: u32,
    weight: vec3f,
    coverage: f32,
}

fn start_on_asset(pixel: Pixel, wi: vec3f) -> Start {
    let record = rna_primitives[pixel.wo.w];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = rna_strand(record);
    }
    return Start(leaving_point(v, wi), v.strand, vec3f(1.0), 0.0);
}

// The ground, which the pixel's ray meets, shows the shadow and fades with the distance.
fn start_on_ground(pixel: Pixel, wi: vec3f) -> Start {
    let start = bitcast<vec3f>(pixel.position.xyz);
    let d = -bitcast<vec3f>(pixel.wo.xyz);
    if view.ground_size == 0.0 || d.y * (start.y - view.ground) >= 0.0 {
        return Start(vec3f(0.0), RNA_NOTHING, vec3f(0.0), 0.0);
    }
    let x = start + d * ((view.ground - start.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    let step = 0x1p-18f * rna_instances[0].extent;
    return Start(x + vec3f(0.0, step, 0.0), RNA_NOTHING, weight, fade);
}

@compute @workgroup_size(64)
fn light_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    var pixel = band[k];
    let number = view.first + k;
    let arrival = arrival_at(number, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    let is_asset = pixel.axis.w != 0u;
    var start: Start;
    if is_asset {
        start = start_on_asset(pixel, arrival.wi);
    } else {
        start = start_on_ground(pixel, arrival.wi);
    }
    // Drivers inline each call, so the asset and the ground share those that trace.
    var visible = vec3f(0.0);
    var arriving = vec3f(0.0);
    if any(start.weight > vec3f(0.0)) {
        visible = start_visibility(0u, RnaRay(start.x, 0.0, arrival.wi, RNA_FAR), start.strand);
        arriving = past_glass(number, pixel, start.x, arrival);
    }
    if is_asset {
        pixel.visibility = visible;
        pixel.radiance = pixel.through * arriving;
    } else {
        let is_behind_glass = HAS_GLASS && pixel.axis.x == BENT_AWAY;
        pixel.radiance = start.weight * visible * arriving;
        if is_behind_glass {
            pixel.radiance = seen_behind_glass(pixel, pixel.radiance, start.coverage);
        }
        pixel.radiance *= pixel.through;
        pixel.coverage = select(start.coverage, 1.0, is_behind_glass);
    }
    band[k] = pixel;
}
