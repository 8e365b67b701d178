// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// at modulo sides. Vulkan leaves `%` of a negative number undefined, and drivers differ.
fn rna_repeated(at: vec2<i32>, sides: vec2<i32>) -> vec2<i32> {
    let left = at - at / sides * sides;
    return select(left, left + sides, left < vec2<i32>(0));
}

// x and y of a map of `size` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let i = vec2<u32>(rna_repeated(vec2<i32>(low), sides));
    let j = vec2<u32>(rna_repeated(vec2<i32>(low) + 1, sides));
    let upper = mix(rna_map_texel(map, i.y, i.x), rna_map_texel(map, i.y, j.x), part.x);
    let lower = mix(rna_map_texel(map, j.y, i.x), rna_map_texel(map, j.y, j.x), part.x);
    return (mix(upper, lower, part.y) - 127.0) / 127.0;
}

// n: interpolated normal; p: corners; uv: their texture coordinates; b: barycentric coordinates.
fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = sign(area);
    let along_u = (d2.y * e1 - d1.y * e2) * side;
    let along_v = (d1.x * e2 - d2.x * e1) * side;
    let t = along_u - dot(along_u, n) * n;
    if area == 0.0 || length(t) <= 1e-6 * length(along_u) {
        return n;
    }
    let tangent = normalize(t);
    var bitangent = cross(n, tangent);
    if dot(bitangent, along_v) > 0.0 {
        bitangent = -bitangent;
    }
    let xy = rna_map_value(map, size, uv * b);
    let z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
    let m = xy.x * tangent + xy.y * bitangent + z * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}
