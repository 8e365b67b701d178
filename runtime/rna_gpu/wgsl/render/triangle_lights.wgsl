// Triangles that shine, of an object or an asset: rna_render/lights/mesh.py. In `images` a light has, at
// places of its record's last vec4f: running sums of its triangles' shares (count + 1), their
// primitives (count), density per area by primitive of the body; then the count.

fn light_words(light: u32) -> vec4<u32> {
    return bitcast<vec4<u32>>(table[frame.lights + LIGHT_SIZE * light + 7u]);
}

fn light_instance(light: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + LIGHT_SIZE * light].w);
}

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[light_words(light).z + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.x].xyz;
    let area = cross(rna_points[record.y].xyz - p, rna_points[record.z].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let words = light_words(light);
    if words.w == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(words.x + words.w);
    let chosen = interval(words.x, words.w, value);
    let root = sqrt(place_within(words.x, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[words.y + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.x].xyz;
    let way = p - x + b.x * (rna_points[record.y].xyz - p) + b.y * (rna_points[record.z].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[RNA_INSTANCE * instance + 6u].w;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_vector(light, 0u);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
