// A ray from the camera through each pixel of the band, to the query of its first hit.

const LEAST_BASE_COLOR = 0.02;

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, rays: u32, of_geometry: RnaHit) -> RnaHit {
    return of_geometry;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, ray: RnaRay) -> Pixel {
    var pixel: Pixel;
    let wo = -ray.direction;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        pixel.position = words(ray.origin, 0u);
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        v = segment_vertex(record, hit.b1, hit.normal, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
    pixel.base_color = vec3f(1.0);
    pixel.detail = vec3f(1.0);
    if !rna_is_segment(record) {
        let width = frame.spread * distance(frame.camera, v.x);
        var colors = mat2x3f(); // the second where there are lobes
        for (var k = 0u; k < select(1u, 2u, view.texel > 0.0); k++) {
            colors[k] = base_color_on(record, hit.b1, hit.b2, select(width, max(view.texel, width), k == 1u));
        }
        pixel.base_color = colors[0];
        // The base colour over that of a texel of the lobes' planes: spec/RNA.md, 12.1, Print.
        pixel.detail = (colors[0] + LEAST_BASE_COLOR) / (colors[1] + LEAST_BASE_COLOR);
    }
    return pixel;
}

@compute @workgroup_size(64)
fn trace_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let place = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter) + view.shift;
    let d = normalize(frame.corner + at.x * frame.step_x + at.y * frame.step_y);
    let ray = RnaRay(frame.camera, 0.0, d, RNA_FAR);
    let followed = follow(ray, RNA_NOTHING, 0u, number);
    var pixel = pixel_of(followed.hit, followed.ray);
    pixel.through = followed.weight;
    if followed.bent && followed.hit.instance == RNA_NOTHING {
        pixel.axis.x = BENT_AWAY;
    }
    band[k] = pixel;
}

// The normals of hits whose primitives and barycentric coordinates are in the band.
@compute @workgroup_size(64)
fn find_normals(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let hit = RnaHit(0.0, 0u, band[k].wo.w, band[k].b1, band[k].b2, vec3f(0.0));
        let ray = RnaRay(frame.camera, 0.0, -bitcast<vec3f>(band[k].wo.xyz), RNA_FAR);
        band[k].axis = pixel_of(hit, ray).axis;
    }
}

// Likewise the base colours; the level of images is where the coverage is.
@compute @workgroup_size(64)
fn find_base_colors(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let at = band[k];
        band[k].base_color = base_color_of_level(rna_primitives[at.wo.w], at.b1, at.b2, at.coverage);
    }
}
