// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: of an asset those of the rays that leave it, of the ground by the cosine.
struct Surroundings {
    at: LobeFrame,
    lobes: Lobes,
}

const GROUND_SHARE = 0.75; // of the cosine lobe; light that is low comes from all sides

fn surroundings_of(pixel: Pixel) -> Surroundings {
    let up = vec3f(0.0, 1.0, 0.0);
    if pixel.axis.w == 0u {
        let lobes = Lobes(false, vec4f(GROUND_SHARE, 0.0, 0.0, 0.0), vec4f(1.0));
        return Surroundings(LobeFrame(up, up, up), lobes);
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz); // the normal, or the tangent
    let lobes = surface_lobes(rna_surface(rna_primitives[pixel.wo.w]));
    return Surroundings(lobe_frame(axis, axis, bitcast<vec3f>(pixel.wo.xyz)), lobes);
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
    let about_point = surroundings_of(pixel);
    if is_bright {
        let bright = sample_image(0u, u);
        let pdf = lobe_density(about_point.at, about_point.lobes, bright.wi);
        return Arrival(bright.wi, bright.radiance / (bright.pdf + pdf));
    }
    let wi = lobe_sample(about_point.at, about_point.lobes, u.yx);
    let sky = look_up_image(0u, wi);
    let pdf = lobe_density(about_point.at, about_point.lobes, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + pdf));
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
