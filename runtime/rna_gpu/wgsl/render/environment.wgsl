// An equirectangular image: see rna_render/lights/equirectangular.py and image_kernels.py, which this follows. In `images`
// a light has texels (h, w, 3), heights (h + 1), running sums of rows (h + 2) and of each row's cells
// (h + 1, w + 1).

struct Cell {
    corners: mat4x3f,
    luminances: vec4f,
}

fn image_float(at: u32) -> f32 {
    return bitcast<f32>(images[at]);
}

fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

fn image_size(light: u32) -> vec2<u32> {
    return vec2<u32>(u32(image_rows(light)), u32(image_columns(light)));
}

fn image_texel(light: u32, row: u32, column: u32) -> vec3f {
    let at = image_texels(light) + 3u * (row * image_size(light).y + column);
    return vec3f(image_float(at), image_float(at + 1u), image_float(at + 2u));
}

fn image_cell(light: u32, row: u32, column: u32) -> Cell {
    let size = image_size(light);
    let upper = max(row, 1u) - 1u;
    let lower = min(row, size.x - 1u);
    let right = select(0u, column + 1u, column + 1u < size.y);
    var cell: Cell;
    for (var k = 0u; k < 4u; k++) {
        let texel = image_texel(light, select(upper, lower, k > 1u), select(column, right, (k & 1u) == 1u));
        cell.corners[k] = texel;
        cell.luminances[k] = luminance(texel);
    }
    return cell;
}

fn in_cell(cell: Cell, x: f32, y: f32) -> vec3f {
    return cell.corners * vec4f((1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y);
}

// The interval of running sums from `at` on, `count` of them, that a value is in, by bisection.
fn interval(at: u32, count: u32, value: f32) -> u32 {
    var low = 0u;
    var high = count;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if image_float(at + middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn place_within(at: u32, k: u32, value: f32) -> f32 {
    let size = image_float(at + k + 1u) - image_float(at + k);
    if size <= 0.0 {
        return 0.0;
    }
    return clamp((value - image_float(at + k)) / size, 0.0, 0.99999994);
}

// A place in [0, 1] with density in proportion to a line from a to b.
fn sample_linear(a: f32, b: f32, u: f32) -> f32 {
    let root = sqrt(max(a * a + u * (b * b - a * a), 0.0));
    if a + root <= 0.0 {
        return u;
    }
    return u * (a + b) / (a + root);
}

fn image_density(light: u32, row: u32, sine: f32, here: f32, mean_here: f32) -> f32 {
    let total = image_total(light);
    let mean = image_mean(light);
    if total <= 0.0 {
        return 0.0;
    }
    let size = image_size(light);
    var pdf = here * f32(size.y) / (2.0 * PI * total);
    if mean > 0.0 {
        pdf *= max(mean_here - mean, 0.0) / max(mean_here, 1e-30);
    }
    if row > 0u && row < size.x {
        let height = image_float(image_heights(light) + row);
        pdf *= height * f32(size.x) / (PI * max(sine, 1e-30));
    }
    return pdf;
}

// Where in a cell of that row, down from the middles above.
fn sample_down(light: u32, row: u32, l: vec4f, u: f32) -> f32 {
    let h = image_size(light).x;
    let height = image_float(image_heights(light) + row);
    let cap = 2.0 * asin(sqrt(u * height / 2.0)) / PI * f32(h);
    if row == 0u {
        return cap + 0.5;
    }
    if row == h {
        return 0.5 - cap;
    }
    return sample_linear(l.x + l.y, l.z + l.w, u);
}

fn sample_image(light: u32, u: vec2f) -> LightSample {
    let size = image_size(light);
    let rows = image_row_sums(light);
    let down = u.y * image_float(rows + size.x + 1u);
    let row = interval(rows, size.x + 1u, down);
    let columns = image_column_sums(light) + row * (size.y + 1u);
    let across = u.x * image_float(columns + size.y);
    let column = interval(columns, size.y, across);
    let cell = image_cell(light, row, column);
    let l = cell.luminances;
    let y = sample_down(light, row, l, place_within(rows, row, down));
    let left = mix(l.x, l.z, y);
    let x = sample_linear(left, mix(l.y, l.w, y), place_within(columns, column, across));
    let theta = PI * (f32(row) - 0.5 + y) / f32(size.x);
    let phi = 2.0 * PI * ((f32(column) + 0.5 + x) / f32(size.y) - 0.5);
    let sine = sin(theta);
    let away = sine * sin(phi);
    let along = -sine * cos(phi);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let wi = vec3f(turn.x * away + turn.y * along, cos(theta), turn.x * along - turn.y * away);
    let radiance = in_cell(cell, x, y);
    let pdf = image_density(light, row, sine, luminance(radiance), dot(l, vec4f(0.25)));
    return light_sample(wi, RNA_FAR, light_colour(light) * radiance, pdf);
}

fn look_up_image(light: u32, d: vec3f) -> LightHit {
    let size = image_size(light);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let x = turn.x * d.x - turn.y * d.z;
    let z = turn.y * d.x + turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    var azimuth = 0.0;
    if sine > 0.0 {
        azimuth = atan2(x, -z);
    }
    let s = (0.5 + azimuth / (2.0 * PI)) * f32(size.y) - 0.5;
    let t = atan2(sine, d.y) / PI * f32(size.x) + 0.5;
    let row = u32(clamp(floor(t), 0.0, f32(size.x)));
    let left = floor(s);
    let column = select(size.y - 1u, u32(max(left, 0.0)), left >= 0.0 && left < f32(size.y));
    let cell = image_cell(light, row, column);
    let radiance = in_cell(cell, s - left, t - f32(row));
    let mean = dot(cell.luminances, vec4f(0.25));
    let pdf = image_density(light, row, sine, luminance(radiance), mean);
    return LightHit(light_colour(light) * radiance, pdf);
}
