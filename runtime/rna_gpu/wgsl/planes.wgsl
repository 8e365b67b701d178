// Features of a position: spec/RNA.md, 5 Planes.

// Values of float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: vec4<u32>) -> vec4f {
    let exponent = (bits >> vec4<u32>(10u)) & vec4<u32>(31u);
    let mantissa = bits & vec4<u32>(1023u);
    let size = select(
        bitcast<vec4f>(((exponent + 112u) << vec4<u32>(23u)) | (mantissa << vec4<u32>(13u))),
        vec4f(mantissa) * 0x1p-24f,
        exponent == vec4<u32>(0u),
    );
    return select(size, -size, (bits & vec4<u32>(0x8000u)) != vec4<u32>(0u));
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let count = 4u >> rna_part.plane_precision; // words of four channels
    let at = count * (texel * rna_part.channel_groups + group);
    var words = vec4<u32>(0u);
    for (var k = 0u; k < count; k++) {
        words[k] = rna_plane_word(plane, at + k);
    }
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return bitcast<vec4f>(words);
        }
        case RNA_FLOAT16: {
            let halves = vec4<u32>(words.x, words.x >> 16u, words.y, words.y >> 16u);
            return rna_from_float16(halves & vec4<u32>(0xffffu));
        }
        default: {
            let high = words.xxxx << vec4<u32>(24u, 16u, 8u, 0u);
            let integers = bitcast<vec4<i32>>(high) >> vec4<u32>(24u);
            return vec4f(integers) * rna_part.scales[plane * RNA_CHANNEL_GROUPS + group];
        }
    }
}

// Where a position is on one axis: texel, the next one, and the fraction between them.
struct RnaTexel {
    low: vec3<u32>,
    high: vec3<u32>,
    fraction: vec3f,
}

fn rna_texels(p: vec3f) -> RnaTexel {
    let last = f32(rna_part.resolution - 1u);
    let s = clamp(p * f32(rna_part.resolution) - 0.5, vec3f(0.0), vec3f(last));
    let below = floor(s);
    let low = vec3<u32>(below);
    let high = min(low + vec3<u32>(1u), vec3<u32>(rna_part.resolution - 1u));
    return RnaTexel(low, high, s - below);
}

// x: (texel, next) along the columns, y: along the rows.
fn rna_bilinear(
    plane: u32, group: u32, columns: vec2<u32>, rows: vec2<u32>, a: f32, b: f32,
) -> vec4f {
    var sum = vec4f(0.0);
    for (var row = 0u; row < 2u; row++) {
        var along = vec4f(0.0);
        for (var column = 0u; column < 2u; column++) {
            let texel = rows[row] * rna_part.resolution + columns[column];
            along += select(1.0 - a, a, column == 1u) * rna_texel(plane, texel, group);
        }
        sum += select(1.0 - b, b, row == 1u) * along;
    }
    return sum;
}

// Position as a fraction of the bounds, clamped to them.
fn rna_relative(x: vec3f) -> vec3f {
    let inside = clamp(x, rna_part.low, rna_part.high);
    return clamp((inside - rna_part.low) / (rna_part.high - rna_part.low), vec3f(0.0), vec3f(1.0));
}

// Channels 4 group to 4 group + 3 of the features at p, in [0, 1].
fn rna_features(t: RnaTexel, group: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var plane = 0u; plane < 3u; plane++) {
        let next = (plane + 1u) % 3u;
        let columns = vec2<u32>(t.low[plane], t.high[plane]);
        let rows = vec2<u32>(t.low[next], t.high[next]);
        sum += rna_bilinear(plane, group, columns, rows, t.fraction[plane], t.fraction[next]);
    }
    return sum;
}
