// Directions for rays that leave a neural asset: the mixtures of rna_render.world.neural_sampling, which
// says why. Shares: uniform, cosine, mirror, cone, forward.

struct LobeFrame {
    o: vec3f,
    normal: vec3f, // turned to the viewer
    tangent: vec3f,
    mirror: vec3f,
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
    return LobeFrame(o, normal, unit_or_up(tangent), 2.0 * dot(normal, o) * normal - o);
}

fn logistic(x: f32) -> f32 {
    return 1.0 / (1.0 + exp(-x));
}

fn lobe_cone_sine(u: f32, middle: f32) -> f32 {
    let low = logistic((-1.0 - middle) / CONE_SCALE);
    let high = logistic((1.0 - middle) / CONE_SCALE);
    let p = clamp(low + u * (high - low), 1e-7, 1.0 - 1e-7);
    return clamp(middle + CONE_SCALE * log(p / (1.0 - p)), -1.0, 1.0);
}

fn lobe_cone_pdf(sine: f32, middle: f32) -> f32 {
    let low = logistic((-1.0 - middle) / CONE_SCALE);
    let high = logistic((1.0 - middle) / CONE_SCALE);
    let p = logistic((sine - middle) / CONE_SCALE);
    return p * (1.0 - p) / (CONE_SCALE * (high - low) * 2.0 * PI);
}

// u.x chooses the lobe, and what is left of it the direction there.
fn lobe_sample(at: LobeFrame, is_fiber: bool, u: vec2f) -> vec3f {
    let shares = lobe_shares(is_fiber);
    if u.x < shares.x {
        return normalize(along_axis(at.normal, 1.0 - 2.0 * u.x / shares.x, u.y));
    }
    if u.x < shares.x + shares.y {
        let left = min((u.x - shares.x) / shares.y, 1.0);
        if is_fiber {
            let sine = lobe_cone_sine(left, -dot(at.tangent, at.o));
            return normalize(along_axis(at.tangent, sine, u.y));
        }
        return normalize(along_axis(at.normal, sqrt(1.0 - left), u.y));
    }
    let left = min((u.x - shares.x - shares.y) / shares.z, 1.0);
    if is_fiber {
        return normalize(along_axis(-at.o, fisher_cosine(left, FORWARD_KAPPA), u.y));
    }
    return normalize(along_axis(at.mirror, mirror_cosine(left), u.y));
}

// Of surfaces: uniform, cosine, mirror; of fibers: uniform, cone, forward.
fn lobe_shares(is_fiber: bool) -> vec3f {
    return select(SURFACE_SHARES, FIBER_SHARES, is_fiber);
}

fn lobe_density(at: LobeFrame, is_fiber: bool, w: vec3f) -> f32 {
    let shares = lobe_shares(is_fiber);
    var second = max(0.0, dot(at.normal, w)) / PI;
    var third = 0.0;
    if is_fiber {
        second = lobe_cone_pdf(dot(at.tangent, w), -dot(at.tangent, at.o));
        third = fisher_pdf(-dot(at.o, w), FORWARD_KAPPA);
    } else {
        third = mirror_pdf(dot(at.mirror, w));
    }
    return shares.x * SPHERE_PDF + shares.y * second + shares.z * third;
}
