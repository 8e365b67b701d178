// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
// by their bits, since WGSL may assume that there is no NaN, and may take subnormal numbers for 0.

const RNA_EXPONENT: u32 = 0x7f800000u;

fn rna_is_finite(bits: vec4<u32>) -> bool {
    return all((bits & vec4<u32>(RNA_EXPONENT)) != vec4<u32>(RNA_EXPONENT));
}

// A component, divided by 2^(largest - 127); of a subnormal largest 0, by 2^-149.
fn rna_scaled(bits: u32, largest: u32) -> f32 {
    let exponent = (bits & RNA_EXPONENT) >> 23u;
    let mantissa = f32(bits & 0x7fffffu);
    var size = 0.0;
    if largest == 0u {
        size = mantissa;
    } else if exponent != 0u {
        let down = largest - exponent;
        if down < 64u {
            size = bitcast<f32>(((127u - down) << 23u) | (bits & 0x7fffffu));
        }
    } else if largest < 64u {
        size = mantissa * bitcast<f32>((105u - largest) << 23u);
    }
    return select(size, -size, (bits >> 31u) == 1u);
}

// The unit vector along one of any length; 0 of length 0.
fn rna_unit(bits: vec3<u32>) -> vec3f {
    let exponents = (bits & vec3<u32>(RNA_EXPONENT)) >> vec3<u32>(23u);
    let largest = max(exponents.x, max(exponents.y, exponents.z));
    var v: vec3f;
    for (var k = 0u; k < 3u; k++) {
        v[k] = rna_scaled(bits[k], largest);
    }
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
