// For each query a direction of one light, what arrives from there, and how much of it the asset lets through; and
// the light on the ground.

struct Light {
    direction: vec3f, // of a sun
    kind: u32,        // 0: sun; the environment: 1 where it is bright, 3 about the point; 2: directions of the rows
    colour: vec3f,    // irradiance of a sun, or a factor of the environment
    ground: f32,      // its height
    turn: vec2f,      // cosine and sine of the environment's rotation
    middle: vec2f,    // of the ground, x and z
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    first: u32,           // 1: the sum starts with this
    counts_coverage: u32,
    unused_a: u32,
    unused_b: u32,
}

struct Lit {
    visibility: vec3f,
    is_query: u32,
    radiance: vec3f, // over the density, times the throughput
    unused: u32,
}

@group(1) @binding(2) var<storage, read_write> lit: array<Lit>;
@group(1) @binding(3) var<storage, read_write> sums: array<vec4f>; // of the whole picture
@group(2) @binding(0) var<uniform> light: Light;
@group(2) @binding(1) var environment: texture_2d<f32>; // radiance, row 0 at +y; w: distribution along the row
@group(2) @binding(2) var marginal: texture_2d<f32>;    // distribution over rows; 1 / the sum of weights; the least weight

const PI = 3.14159265358979;

fn row_of(u: f32, count: i32) -> i32 {
    var low = 0;
    var high = count - 1;
    while low < high {
        let middle = (low + high) / 2;
        if textureLoad(marginal, vec2<i32>(middle, 0), 0).x > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

fn column_of(u: f32, row: i32, count: i32) -> i32 {
    var low = 0;
    var high = count - 1;
    while low < high {
        let middle = (low + high) / 2;
        if textureLoad(environment, vec2<i32>(middle, row), 0).w > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// A texel's weight among all: luminance times the sine of its row.
fn texel_weight(rgb: vec3f, row: i32, size: vec2<i32>) -> f32 {
    let least = textureLoad(marginal, vec2<i32>(size.y + 1, 0), 0).x;
    return max(least, dot(rgb, vec3f(0.2126, 0.7152, 0.0722))) * sin(PI * (f32(row) + 0.5) / f32(size.y));
}

struct Sky {
    radiance: vec3f,
    density: f32, // of `bright_direction`
}

// Radiance at a place in the image, bilinear, and the density there: the weights, bilinear.
fn sky_at(st: vec2f, sine: f32) -> Sky {
    let size = vec2<i32>(textureDimensions(environment));
    let at = st * vec2f(size) - 0.5;
    let low = floor(at);
    let f = at - low;
    var radiance = vec3f(0.0);
    var weight = 0.0;
    for (var k = 0; k < 4; k++) {
        let step = vec2<i32>(k & 1, k >> 1u);
        let share = select(1.0 - f.x, f.x, step.x == 1) * select(1.0 - f.y, f.y, step.y == 1);
        let column = (i32(low.x) + step.x + size.x) % size.x;
        let row = clamp(i32(low.y) + step.y, 0, size.y - 1);
        let rgb = textureLoad(environment, vec2<i32>(column, row), 0).xyz;
        radiance += share * rgb;
        weight += share * texel_weight(rgb, row, size);
    }
    let over_total = textureLoad(marginal, vec2<i32>(size.y, 0), 0).x;
    return Sky(radiance, weight * over_total * f32(size.x * size.y) / (2.0 * PI * PI * max(sine, 1e-6)));
}

// From a direction of the image to that of the world, and back.
fn turned(d: vec3f) -> vec3f {
    return vec3f(light.turn.x * d.x + light.turn.y * d.z, d.y, light.turn.x * d.z - light.turn.y * d.x);
}

fn turned_back(d: vec3f) -> vec3f {
    return vec3f(light.turn.x * d.x - light.turn.y * d.z, d.y, light.turn.x * d.z + light.turn.y * d.x);
}

// From the uniform distribution on [0, 1] to the tent about 0, on [-1, 1].
fn tent(u: vec2f) -> vec2f {
    let t = 2.0 * clamp(u, vec2f(0.0), vec2f(1.0)) - 1.0;
    return sign(t) * (1.0 - sqrt(1.0 - abs(t)));
}

// A direction: a texel in proportion to its weight, then a place about its middle by a tent two texels wide. So the
// density is the weights' bilinear interpolation, and follows the radiance that is looked up, beside a sun, too.
fn bright_direction(u: vec2f) -> vec3f {
    let size = vec2<i32>(textureDimensions(environment));
    let row = row_of(u.y, size.y);
    var before = 0.0;
    if row > 0 {
        before = textureLoad(marginal, vec2<i32>(row - 1, 0), 0).x;
    }
    let chance = textureLoad(marginal, vec2<i32>(row, 0), 0).x - before;
    let column = column_of(u.x, row, size.x);
    var left = 0.0;
    if column > 0 {
        left = textureLoad(environment, vec2<i32>(column - 1, row), 0).w;
    }
    let width = textureLoad(environment, vec2<i32>(column, row), 0).w - left;
    let within = (u - vec2f(left, before)) / max(vec2f(width, chance), vec2f(1e-12));
    let place = (vec2f(f32(column), f32(row)) + 0.5 + tent(within)) / vec2f(size);
    let st = vec2f(fract(place.x), 1.0 - abs(1.0 - abs(place.y))); // back from beyond the poles
    let theta = PI * st.y;
    let phi = 2.0 * PI * (st.x - 0.5);
    return turned(vec3f(sin(theta) * sin(phi), cos(theta), -sin(theta) * cos(phi)));
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const MIRROR_KAPPA = 20.0; // of a von Mises-Fisher distribution
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, fisher_cosine(u.y / share, MIRROR_KAPPA), u.x));
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
    return mix(rest, fisher_pdf(dot(at.mirror, wi), MIRROR_KAPPA), mirrored_share(at));
}

fn surroundings_of(row: Row) -> Surroundings {
    if row.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if HAS_SEGMENTS && (primitives[row.wo.w].w & SEGMENT) != 0u {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(row.axis.xyz);
    let wo = bitcast<vec3f>(row.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(pixel: vec2<u32>, row: Row) -> Arrival {
    if light.kind == 0u {
        return Arrival(light.direction, light.colour);
    }
    if light.kind == 2u {
        return Arrival(bitcast<vec3f>(row.wi.xyz), light.colour);
    }
    let u = random(pixel, DIRECTION);
    let at = surroundings_of(row);
    var wi: vec3f;
    if light.kind == 1u {
        wi = bright_direction(u);
    } else {
        wi = direction_about(at, u);
    }
    let d = turned_back(wi);
    let sky = sky_at(vec2f(atan2(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI), length(d.xz));
    return Arrival(wi, light.colour * sky.radiance / (sky.density + density_about(at, wi)));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
    origin: vec3f,
    strand: u32, // that is no obstacle
    weight: vec3f,
    coverage: f32,
}

fn start_of(row: Row, wi: vec3f) -> Start {
    let primitive = primitives[row.wo.w];
    if HAS_SEGMENTS && (primitive.w & SEGMENT) != 0u {
        return Start(bitcast<vec3f>(row.position.xyz), primitive.z, vec3f(1.0), 1.0);
    }
    let hit = Hit(0.0, primitive.w, row.wo.w, bitcast<f32>(row.position.w), bitcast<f32>(row.wi.w), vec3f(0.0));
    return Start(lifted_origin(primitive, hit, wi), NO_STRAND, vec3f(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
fn start_on_ground(d: vec3f, wi: vec3f) -> Start {
    let nothing = Start(vec3f(0.0), NO_STRAND, vec3f(0.0), 0.0);
    if light.ground_size == 0.0 || d.y * (view.camera.y - light.ground) >= 0.0 {
        return nothing;
    }
    let x = view.camera + d * ((light.ground - view.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - light.middle) / light.ground_size);
    return Start(x + vec3f(0.0, view.epsilon, 0.0), NO_STRAND, fade * max(0.0, wi.y) * light.ground_colour, fade);
}

@compute @workgroup_size(64)
fn light_pixels(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    let local = pixel_of(index);
    if local.y >= view.rows {
        return;
    }
    let row = rows[index];
    let is_query = row.axis.w != 0u;
    let arrival = arrival_at(vec2<u32>(local.x, local.y + view.first_row), row);
    var start: Start;
    if is_query {
        start = start_of(row, arrival.wi);
    } else {
        start = start_on_ground(-bitcast<vec3f>(row.wo.xyz), arrival.wi);
    }
    var passed = vec3f(0.0);
    if any(start.weight > vec3f(0.0)) {
        passed = passes(start.origin, arrival.wi, start.strand);
    }
    let radiance = through[index].xyz * arrival.radiance;
    rows[index].wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), row.wi.w);
    lit[index] = Lit(passed, u32(is_query), radiance, 0u);
    let at = view.first_row * view.width + index;
    var sum = vec4f(0.0);
    if light.first == 0u {
        sum = sums[at];
    }
    let on_ground = select(start.weight * passed * radiance, vec3f(0.0), is_query);
    sums[at] = sum + vec4f(on_ground, start.coverage * f32(light.counts_coverage));
}
