// Triangles that shine, of an object or an asset: rna_render/lights/kinds/mesh.py. In `images` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let area = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let sums_at = triangles_sums(light);
    let count = triangles_count(light);
    if count == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(sums_at + count);
    let chosen = interval(sums_at, count, value);
    let root = sqrt(place_within(sums_at, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[triangles_primitives(light) + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let way = p - x + b.x * (rna_points[record.b].xyz - p) + b.y * (rna_points[record.c].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[instance].scale;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_colour(light);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
