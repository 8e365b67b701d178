// Directions about an axis.

const SPHERE_PDF: f32 = 1.0 / (4.0 * PI);

struct Tangents {
    s: vec3f,
    t: vec3f,
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
fn tangents_of(n: vec3f) -> Tangents {
    let sign = select(1.0, -1.0, n.z < 0.0);
    let c = -1.0 / (sign + n.z);
    let d = n.x * n.y * c;
    return Tangents(
        vec3f(1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x),
        vec3f(d, sign + n.y * n.y * c, -n.y),
    );
}

fn about(axis: vec3f, sine: f32, cosine: f32, turns: f32) -> vec3f {
    let frame_of = tangents_of(axis);
    let phi = 2.0 * PI * turns;
    return sine * cos(phi) * frame_of.s + sine * sin(phi) * frame_of.t + cosine * axis;
}

fn along_axis(axis: vec3f, cosine: f32, turns: f32) -> vec3f {
    return about(axis, sqrt(max(0.0, 1.0 - cosine * cosine)), cosine, turns);
}

// Cosine to the axis of a von Mises-Fisher direction.
fn fisher_cosine(u: f32, kappa: f32) -> f32 {
    return max(-1.0, 1.0 + log(u + (1.0 - u) * exp(-2.0 * kappa)) / kappa);
}

fn fisher_pdf(cosine: f32, kappa: f32) -> f32 {
    return kappa * exp(kappa * (cosine - 1.0)) / (2.0 * PI * (1.0 - exp(-2.0 * kappa)));
}

// Uniform within a cone about a unit axis, by 1 - cos of the angle to its rim.
fn cone_direction(axis: vec3f, one_minus_cosine: f32, u: vec2f) -> vec3f {
    let height = u.x * one_minus_cosine;
    return about(axis, sqrt(max(0.0, height * (2.0 - height))), 1.0 - height, u.y);
}
