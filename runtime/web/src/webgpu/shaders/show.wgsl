// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB, alpha
// where the page behind it shows.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec4f, // linear light of the screen, and 1; or zeros, where the page shows
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    first_look: f32, // share of the first look in what is shown, 0 to 1
    rows_ahead: f32, // from the top, which have one sample more than `rounds`
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

// The mean of the samples and the first look.
fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    let k = place.y * u32(shown.picture.x) + place.x;
    if shown.first_look >= 1.0 {
        return first_look[k];
    }
    let mean = sums[k] / (shown.rounds + f32(f32(place.y) < shown.rows_ahead));
    if shown.first_look <= 0.0 {
        return mean;
    }
    return mix(mean, first_look[k], shown.first_look);
}

// As rna_render/image/view_transform.py, which names the source.
fn filmic(radiance: vec3f) -> vec3f {
    let c = 1.461926 * min(radiance, vec3f(1e9));
    let x = vec3f(dot(c, vec3f(0.59719, 0.35458, 0.04823)), dot(c, vec3f(0.07600, 0.90834, 0.01566)),
                  dot(c, vec3f(0.02840, 0.13383, 0.83777)));
    // Both parts divided by x, so that none overflows.
    let inverse = 1.0 / max(x, vec3f(1e-9));
    let y = (x + 0.0245786 - 0.000090537 * inverse) / (0.983729 * x + 0.4329510 + 0.238081 * inverse);
    return vec3f(dot(y, vec3f(1.60475, -0.53108, -0.07367)), dot(y, vec3f(-0.10208, 1.10813, -0.00605)),
                 dot(y, vec3f(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, premultiplied, of a mean.
fn displayed(mean: vec4f) -> vec4f {
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let behind = max(0.0, 1.0 - mean.w) * shown.backdrop.w;
    let alpha = min(mean.w, 1.0) + behind;
    let linear = (clamp(light, vec3f(0.0), vec3f(1.0)) + behind * shown.backdrop.xyz) / max(alpha, 1e-4);
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return vec4f(clamp(encoded, vec3f(0.0), vec3f(1.0)), 1.0) * alpha;
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y);
    let here = displayed(mean);
    if (shown.spread == 0.0) {
        return here;
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = here;
    var total = 1.0;
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y);
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            let weight = exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
            sum += weight * value;
            total += weight;
        }
    }
    return sum / total;
}
