// A ray from the camera through each pixel of the band, to the query of its first hit.

const SEEN_THROUGH = 32u;

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

@compute @workgroup_size(64)
fn trace_pixels(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    let local = pixel_of(index);
    if local.y >= view.rows {
        return;
    }
    let pixel = vec2<u32>(local.x, local.y + view.first_row);
    let at = vec2f(pixel) + mix(vec2f(0.5), random(pixel, PLACE), view.jitter);
    let d = normalize(view.corner + at.x * view.step_x + at.y * view.step_y);
    var origin = view.camera;
    var throughput = vec3f(1.0);
    let nothing = vec4<u32>(0u);
    var row = Row(nothing, nothing, words(-d, 0u), nothing);
    for (var k = 0u; k < SEEN_THROUGH; k++) {
        let hit = nearest(origin, d);
        if hit.t == FAR {
            break;
        }
        let primitive = primitives[hit.place];
        let fiber = HAS_SEGMENTS && (hit.number & SEGMENT) != 0u;
        var tau = vec3f(0.0);
        if !fiber {
            tau = transmittance(primitive, hit, d);
        }
        let chance = max(tau.x, max(tau.y, tau.z));
        // Straight on, or stopped here: chosen at random (spec, 4.4).
        if chance > 0.0 && random(pixel, STOPPED + k).x < chance {
            throughput *= tau / chance;
            origin += d * (hit.t + 4.0 * view.epsilon);
            continue;
        }
        if chance > 0.0 {
            throughput *= (1.0 - tau) / (1.0 - chance);
        }
        let part = part_of(hit.number & ~SEGMENT) + 1u;
        if fiber {
            let t = tangent_of(primitive);
            let h = offset_across(hit.n, t, -d);
            row.position = words(origin + hit.t * d, bitcast<u32>(h));
            row.axis = words(t, part);
        } else {
            let corners = corners_of(primitive);
            row.position = words(mixed(corners.p, weights_of(hit)), bitcast<u32>(hit.b1));
            row.axis = words(shading_normal(primitive, hit), part);
        }
        row.wo.w = hit.place;
        row.wi.w = bitcast<u32>(hit.b2);
        break;
    }
    rows[index] = row;
    through[index] = vec4f(throughput, 0.0);
}

// The normals of hits whose place and barycentric coordinates are in the rows.
@compute @workgroup_size(64)
fn find_normals(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= view.width {
        return;
    }
    let row = rows[id.x];
    let hit = Hit(0.0, 0u, row.wo.w, bitcast<f32>(row.position.w), bitcast<f32>(row.wi.w), vec3f(0.0));
    rows[id.x].axis = words(shading_normal(primitives[row.wo.w], hit), row.axis.w);
}
