// Images on triangles: spec/RNA.md, 4.6 Base colour; textures of materials are looked up likewise. A texel is a
// u32 of three bytes; levels lie one behind the other. The host declares
//     fn rna_image_word(at: u32) -> u32

const RNA_REPEAT: u32 = 0u;
const RNA_MIRROR: u32 = 2u;
const RNA_IS_SRGB: u32 = 16u;
const RNA_MIXES_SRGB: u32 = 256u; // of base colours: encoded values are mixed

struct RnaImage {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32, // wrap in u and in v, 2 bits each; RNA_IS_SRGB or RNA_MIXES_SRGB
}

fn rna_texel_of(at: RnaImage, column: u32, row: u32) -> vec3f {
    let word = rna_image_word(at.place + row * at.size.x + column);
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & RNA_IS_SRGB) == 0u {
        return c;
    }
    return rna_linear(c);
}

fn rna_linear(c: vec3f) -> vec3f {
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct RnaAround {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn rna_texels_around(x: f32, size: u32, wrap: u32) -> RnaAround {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == RNA_REPEAT {
        inside = x - floor(x);
    } else if wrap == RNA_MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == RNA_REPEAT {
        let wrapped = select(first, last, first < 0);
        return RnaAround(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return RnaAround(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, at coordinates of the image.
fn rna_image_color(at: RnaImage, place: vec2f) -> vec3f {
    let x = rna_texels_around(place.x, at.size.x, at.form & 3u);
    let y = rna_texels_around(place.y, at.size.y, (at.form >> 2u) & 3u);
    var color = vec3f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let right = (k & 1u) == 1u;
        let below = k > 1u;
        let weight = select(1.0 - x.part, x.part, right) * select(1.0 - y.part, y.part, below);
        color += weight * rna_texel_of(at, select(x.first, x.second, right), select(y.first, y.second, below));
    }
    if (at.form & RNA_MIXES_SRGB) == 0u {
        return color;
    }
    return rna_linear(color);
}

// The next level, of half the size.
fn rna_next_level(at: RnaImage) -> RnaImage {
    return RnaImage(at.place + at.size.x * at.size.y, max(at.size / 2u, vec2<u32>(1u)), at.form);
}

// At a level that need not be whole; `at` is level 0, the last level has one texel.
fn rna_image_color_at(at: RnaImage, place: vec2f, level: f32) -> vec3f {
    var finer = at;
    let whole = u32(level);
    for (var k = 0u; k < whole && any(finer.size > vec2<u32>(1u)); k++) {
        finer = rna_next_level(finer);
    }
    let rest = select(level - f32(whole), 0.0, all(finer.size == vec2<u32>(1u)));
    var color = vec3f(0.0);
    for (var k = 0u; k < select(2u, 1u, rest == 0.0); k++) {
        color += select(1.0 - rest, rest, k == 1u) * rna_image_color(finer, place);
        finer = rna_next_level(finer);
    }
    return color;
}

// The level whose texels are as wide as `width` on a triangle of the corners p. uv: of the corners in the image.
fn rna_level_for(at: RnaImage, p: mat3x3f, uv: mat3x2f, width: f32) -> f32 {
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let texels = abs(d1.x * d2.y - d2.x * d1.y) * f32(at.size.x) * f32(at.size.y);
    let area = length(cross(p[1] - p[0], p[2] - p[0]));
    let wide = width * sqrt(select(0.0, texels / area, area > 0.0));
    return log2(max(wide, 1.0));
}
