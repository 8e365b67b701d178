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
    corner: vec3f, // of the view, the ray through its upper left
    across: vec3f, // its width, and its height below
    down: vec3f,
    sky_size: vec2f, // of the environment's image
    sky_turn: vec2f, // cosine and sine of its turn about +y
    sky: f32, // what its radiance is multiplied by; 0 where it is not behind the asset
    sky_texels: u32, // where they begin
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look
@group(0) @binding(3) var<storage, read> images: array<f32>;

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

fn sky_texel(row: f32, column: f32) -> vec3f {
    let wide = u32(shown.sky_size.x);
    let at = shown.sky_texels + 3u * (u32(clamp(row, 0.0, shown.sky_size.y - 1.0)) * wide + (u32(column + shown.sky_size.x) % wide));
    return vec3f(images[at], images[at + 1u], images[at + 2u]);
}

// Radiance of the environment behind a place of the view, in shares from the upper left.
fn sky_behind(place: vec2f) -> vec3f {
    let v = normalize(shown.corner + place.x * shown.across + place.y * shown.down);
    let d = vec3f(shown.sky_turn.x * v.x - shown.sky_turn.y * v.z, v.y, shown.sky_turn.x * v.z + shown.sky_turn.y * v.x);
    let turns = vec2f(atan2(d.x, -d.z) / 6.2831853 + 0.5, acos(clamp(d.y, -1.0, 1.0)) / 3.1415927);
    let texel = turns * shown.sky_size - 0.5;
    let low = floor(texel);
    let f = texel - low;
    let above = mix(sky_texel(low.y, low.x), sky_texel(low.y, low.x + 1.0), f.x);
    return shown.sky * mix(above, mix(sky_texel(low.y + 1.0, low.x), sky_texel(low.y + 1.0, low.x + 1.0), f.x), f.y);
}

// Values of the screen, sRGB, premultiplied, of a mean, with what is behind it.
fn displayed(asset: vec4f, sky: vec3f) -> vec4f {
    let mean = select(asset, vec4f(asset.xyz + max(0.0, 1.0 - asset.w) * sky, 1.0), shown.sky > 0.0);
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
    var sky = vec3f(0.0);
    if shown.sky > 0.0 {
        sky = sky_behind(at.xy / shown.size);
    }
    let here = displayed(mean, sky);
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
            let value = displayed(other, sky);
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
