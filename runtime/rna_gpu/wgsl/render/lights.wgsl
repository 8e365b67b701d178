// Lights: samples of them, and their radiance and density at hits of rays. They are those of rna_render.lights.

const MAX_PDF: f32 = 1e18;
const MIN_SOLID_ANGLE: f32 = 1e-3; // float32 knows no smaller one to 1e-3 of itself

struct LightSample {
    wi: vec3f,
    distance: f32,
    radiance: vec3f, // of an asset's triangles a factor on what they emit
    pdf: f32,
    primitive: u32, // of triangles
    b1: f32,
    b2: f32,
}

fn light_sample(wi: vec3f, distance: f32, radiance: vec3f, pdf: f32) -> LightSample {
    return LightSample(wi, distance, radiance, pdf, NONE, 0.0, 0.0);
}

// A light along a ray: its radiance, and the density of sampling it there.
struct LightHit {
    radiance: vec3f,
    pdf: f32,
}

// Samples that a light gets at a point, on average.
fn samples_of(light: u32, depth: u32) -> f32 {
    return light_probability(light)[min(depth, 3u) - 1u];
}

fn light_is(light: u32, flag: u32) -> bool {
    return (light_flags(light) & flag) != 0u;
}

// Of points of a plane: per_area, seen along d; 0 from behind.
fn flat_pdf(point: vec3f, normal: vec3f, per_area: f32, x: vec3f, d: vec3f) -> f32 {
    let cosine = -dot(d, normal);
    let height = dot(x - point, normal);
    if cosine <= 0.0 || height <= 0.0 {
        return 0.0;
    }
    let t = height / cosine;
    let pdf = per_area * t * t / cosine;
    return select(0.0, pdf, pdf < MAX_PDF);
}

fn edge_angle(x: f32, y: f32, sign: f32, height: f32) -> f32 {
    return atan2(height * sqrt(x * x + y * y + height * height), sign * x * y);
}

// Solid angle of a rectangle from (x0, y0) to (x1, y1), and the sum k of Ureña, Fajardo and King,
// An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013), section 5.
fn solid_angle(e: vec4f, height: f32) -> vec2f {
    let k = 2.0 * PI - edge_angle(e.x, e.w, 1.0, height) - edge_angle(e.x, e.z, -1.0, height);
    let right = edge_angle(e.y, e.z, 1.0, height) + edge_angle(e.y, e.w, -1.0, height);
    return vec2f(right - k, k);
}

// Edges x0, x1, y0, y1 of a rectangle as seen from x.
fn rectangle_edges(light: u32, from_place: vec3f) -> vec4f {
    let a = dot(from_place, rectangle_frame(light)[0]);
    let b = dot(from_place, rectangle_frame(light)[1]);
    let half = rectangle_half(light);
    return vec4f(-half.x - a, half.x - a, -half.y - b, half.y - b);
}

fn rectangle_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let half = rectangle_half(light);
    let f = rectangle_frame(light);
    let flat = flat_pdf(f[3], f[2], 0.25 / (half.x * half.y), x, d);
    let height = dot(x - f[3], f[2]);
    let angle = solid_angle(rectangle_edges(light, x - f[3]), max(height, 1e-30)).x;
    if flat == 0.0 || angle < MIN_SOLID_ANGLE {
        return flat;
    }
    return 1.0 / angle;
}

fn rectangle_point(e: vec4f, height: f32, u: vec2f) -> vec2f {
    let angle = solid_angle(e, height);
    if angle.x < MIN_SOLID_ANGLE {
        return mix(e.xz, e.yw, u);
    }
    let b0 = -e.z / sqrt(height * height + e.z * e.z);
    let b1 = e.w / sqrt(height * height + e.w * e.w);
    let turn = u.x * angle.x + angle.y;
    let sine = sin(turn);
    let f = (cos(turn) * b0 - b1) / select(sine, 1e-20, abs(sine) < 1e-20);
    let c = clamp(select(-1.0, 1.0, f >= 0.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    let x = clamp(c * height / sqrt(max(1.0 - c * c, 1e-20)), e.x, e.y);
    let squared = x * x + height * height;
    let h0 = e.z / sqrt(squared + e.z * e.z);
    let h1 = e.w / sqrt(squared + e.w * e.w);
    let h = h0 + u.y * (h1 - h0);
    let y = h * sqrt(squared / max(1.0 - h * h, 1e-20));
    return vec2f(x, clamp(y, e.z, e.w));
}

// Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
fn concentric(u: vec2f) -> vec2f {
    let a = 2.0 * u - 1.0;
    if a.x == 0.0 && a.y == 0.0 {
        return vec2f(0.0);
    }
    if abs(a.x) > abs(a.y) {
        let phi = PI / 4.0 * (a.y / a.x);
        return a.x * vec2f(cos(phi), sin(phi));
    }
    let phi = PI / 2.0 - PI / 4.0 * (a.x / a.y);
    return a.y * vec2f(cos(phi), sin(phi));
}

// 1 - cos of the angular radius of a sphere light; 0 from within.
fn sphere_cone(light: u32, x: vec3f) -> f32 {
    let to_centre = sphere_centre(light) - x;
    let radius = sphere_radius(light);
    let squared = dot(to_centre, to_centre);
    if squared <= radius * radius {
        return 0.0;
    }
    let sin2 = radius * radius / squared;
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}

fn shape_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        return rectangle_pdf(light, x, d);
    }
    if kind == DISK {
        let radius = disk_radius(light);
        let per_area = 1.0 / (PI * radius * radius);
        return flat_pdf(disk_frame(light)[3], disk_frame(light)[2], per_area, x, d);
    }
    let cone = sphere_cone(light, x);
    return select(0.0, 1.0 / (2.0 * PI * max(cone, 1e-18)), cone > 0.0);
}

// A point of a shape, relative to x.
fn shape_point(light: u32, x: vec3f, u: vec2f) -> vec3f {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        let f = rectangle_frame(light);
        let height = dot(x - f[3], f[2]);
        if height <= 0.0 {
            return f[3] - x;
        }
        let p = rectangle_point(rectangle_edges(light, x - f[3]), height, u);
        return p.x * f[0] + p.y * f[1] - height * f[2];
    }
    if kind == DISK {
        let f = disk_frame(light);
        let p = disk_radius(light) * concentric(u);
        return f[3] + p.x * f[0] + p.y * f[1] - x;
    }
    let to_centre = sphere_centre(light) - x;
    let wi = cone_direction(normalize(to_centre), sphere_cone(light, x), u);
    let along = dot(to_centre, wi);
    let rest = to_centre - along * wi;
    let radius = sphere_radius(light);
    return (along - sqrt(max(0.0, radius * radius - dot(rest, rest)))) * wi;
}

fn sample_point(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, light_colour(light) / (r * r), 1.0);
}

fn sample_spot(light: u32, x: vec3f) -> LightSample {
    let way = spot_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, spot_axis(light));
    let inner = spot_cos_inner(light);
    let outer = spot_cos_outer(light);
    var factor = 1.0;
    if cosine < inner {
        let t = clamp((cosine - outer) / max(inner - outer, 1e-20), 0.0, 1.0);
        factor = t * t * (3.0 - 2.0 * t);
    }
    let pdf = select(0.0, 1.0, factor > 0.0);
    return light_sample(wi, r, factor / (r * r) * light_colour(light), pdf);
}

fn sample_light(light: u32, x: vec3f, u: vec2f) -> LightSample {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return sample_image(light, u);
    }
    if kind == UNIFORM {
        return light_sample(
            cone_direction(vec3f(0.0, 0.0, 1.0), 2.0, u), RNA_FAR, colour, SPHERE_PDF,
        );
    }
    if kind == SUN {
        let cone = sun_one_minus_cosine(light);
        let wi = cone_direction(sun_axis(light), cone, u);
        return light_sample(wi, RNA_FAR, colour, 1.0 / (2.0 * PI * cone));
    }
    if kind == DIRECTIONAL {
        return light_sample(directional_axis(light), RNA_FAR, colour, 1.0);
    }
    if kind == TRIANGLES {
        return sample_triangles(light, x, u);
    }
    if kind == POINT {
        return sample_point(light, x);
    }
    if kind == SPOT {
        return sample_spot(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// An infinite light along d.
fn environment_along(light: u32, d: vec3f) -> LightHit {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return LightHit(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return LightHit(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return LightHit(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's position there, along the light's axes.
fn on_plane(f: mat4x3f, ray: RnaRay, t: f32) -> vec2f {
    let p = ray.origin + t * ray.direction - f[3];
    return vec2f(dot(p, f[0]), dot(p, f[1]));
}

// Where a ray meets the shape of a light; RNA_FAR where it does not.
fn meet_light(light: u32, ray: RnaRay) -> f32 {
    let kind = light_kind(light);
    var t = RNA_FAR;
    if kind == SPHERE {
        let centre = sphere_centre(light);
        let radius = sphere_radius(light);
        t = rna_enter_sphere(ray.origin, ray.direction, centre, radius);
        let from_centre = ray.origin - centre;
        if dot(from_centre, from_centre) < radius * radius && t < RNA_FAR {
            t = -t - 2.0 * dot(from_centre, ray.direction);
        }
    } else if kind == RECTANGLE {
        let f = rectangle_frame(light);
        t = meet_plane(f, ray);
        let p = abs(on_plane(f, ray, t));
        t = select(RNA_FAR, t, all(p <= rectangle_half(light)));
    } else if kind == DISK {
        let f = disk_frame(light);
        t = meet_plane(f, ray);
        t = select(RNA_FAR, t, length(on_plane(f, ray, t)) <= disk_radius(light));
    }
    return select(RNA_FAR, t, t >= ray.near && t < ray.far);
}
