// Directions for rays that leave a neural asset: the mixtures of rna_render.world.neural_sampling, which
// says why.

// shares: of the broad lobe (cosine of surfaces, forward of fibers) and of narrow ones (mirror, cone); all
// directions alike have what they leave.
struct Lobes {
    is_fiber: bool,
    shares: vec4f,
    widths: vec4f,
}

struct LobeFrame {
    o: vec3f,
    normal: vec3f, // turned to the viewer
    tangent: vec3f,
}

fn unit_or_up(v: vec3f) -> vec3f {
    let size = length(v);
    if size <= 0.5 {
        return vec3f(0.0, 1.0, 0.0);
    }
    return v / size;
}

fn lobe_frame(n: vec3f, tangent: vec3f, o: vec3f) -> LobeFrame {
    var normal = unit_or_up(n);
    if dot(normal, o) < 0.0 {
        normal = -normal;
    }
    return LobeFrame(o, normal, unit_or_up(tangent));
}

fn logistic(x: f32) -> f32 {
    return 1.0 / (1.0 + exp(-x));
}

fn lobe_cone_sine(u: f32, middle: f32, scale: f32) -> f32 {
    let low = logistic((-1.0 - middle) / scale);
    let high = logistic((1.0 - middle) / scale);
    let p = clamp(low + u * (high - low), 1e-7, 1.0 - 1e-7);
    return clamp(middle + scale * log(p / (1.0 - p)), -1.0, 1.0);
}

fn lobe_cone_pdf(sine: f32, middle: f32, scale: f32) -> f32 {
    let low = logistic((-1.0 - middle) / scale);
    let high = logistic((1.0 - middle) / scale);
    let p = logistic((sine - middle) / scale);
    return p * (1.0 - p) / (scale * (high - low) * 2.0 * PI);
}

fn lobe_mirrored(at: LobeFrame, alpha: f32, u: vec2f) -> vec3f {
    let local = tangents_of(at.normal);
    let o = vec3f(dot(local.s, at.o), dot(local.t, at.o), dot(at.normal, at.o));
    let i = sample_reflection(alpha, o, u.yx);
    return i.x * local.s + i.y * local.t + i.z * at.normal;
}

// u.x chooses the lobe, and what is left of it the direction there.
fn lobe_sample(at: LobeFrame, lobes: Lobes, u: vec2f) -> vec3f {
    var left = u.x;
    for (var k = 0u; k < 4u; k++) {
        let share = lobes.shares[k];
        if left < share {
            return normalize(lobe_direction(at, lobes, k, vec2f(left / share, u.y)));
        }
        left -= share;
    }
    let rest = max(1.0 - dot(lobes.shares, vec4f(1.0)), 1e-6);
    return normalize(along_axis(at.normal, 1.0 - 2.0 * min(left / rest, 1.0), u.y));
}

fn lobe_direction(at: LobeFrame, lobes: Lobes, k: u32, u: vec2f) -> vec3f {
    let width = lobes.widths[k];
    if !lobes.is_fiber {
        if k == 0u {
            return along_axis(at.normal, sqrt(1.0 - u.x), u.y);
        }
        return lobe_mirrored(at, width, u);
    }
    if k == 0u {
        return along_axis(-at.o, fisher_cosine(u.x, 1.0 / (width * width)), u.y);
    }
    return along_axis(at.tangent, lobe_cone_sine(u.x, -dot(at.tangent, at.o), width), u.y);
}

fn lobe_density(at: LobeFrame, lobes: Lobes, w: vec3f) -> f32 {
    var density = max(1.0 - dot(lobes.shares, vec4f(1.0)), 0.0) * SPHERE_PDF;
    if lobes.is_fiber {
        let width = lobes.widths.x;
        density += lobes.shares.x * fisher_pdf(-dot(at.o, w), 1.0 / (width * width));
    } else {
        density += lobes.shares.x * max(0.0, dot(at.normal, w)) / PI;
    }
    for (var k = 1u; k < 4u; k++) {
        let share = lobes.shares[k];
        let width = lobes.widths[k];
        if share > 0.0 && lobes.is_fiber {
            density += share * lobe_cone_pdf(dot(at.tangent, w), -dot(at.tangent, at.o), width);
        } else if share > 0.0 {
            density += share * reflected_density(width, at.normal, at.o, w);
        }
    }
    return density;
}
