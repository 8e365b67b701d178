// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

const RNA_LARGEST: f32 = 3.4028234e38;

struct RnaTransport {
    visible: vec3f, // of a decoder of one colour: that one, as what is emitted
    shadowed: vec3f,
}

// Clip, and gain and offset of an int8 decoder.
fn rna_prepare_queries() {
    for (var k = 0u; k < rna_part.query_groups; k++) {
        var x = clamp(rna_values[k], vec4f(rna_part.query_low), vec4f(rna_part.query_high));
        if rna_part.gain != RNA_NONE {
            x = x * rna_weight(rna_part.gain + k)
                + rna_weight(rna_part.gain + rna_part.query_groups + k);
        }
        rna_values[k] = x;
    }
}

// QuantizeLinear: whole numbers from 0 to 255, halves to even.
fn rna_quantize(layer: RnaLayer, source: u32) {
    for (var k = 0u; k < layer.inputs; k++) {
        let x = rna_values[source + k] / layer.int8_step;
        rna_values[source + k] = clamp(round(x), vec4f(0.0), vec4f(255.0));
    }
}

// What a group of columns adds to the sums of an output group, with its block at `at`.
fn rna_block(x: vec4f, at: u32) -> vec4f {
    return x.x * rna_weight(at) + x.y * rna_weight(at + 1u)
        + x.z * rna_weight(at + 2u) + x.w * rna_weight(at + 3u);
}

fn rna_finish(layer: RnaLayer, o: u32, sums: vec4f, place: u32) {
    var y = sums + rna_weight(layer.bias + o);
    if layer.int8_step != 0.0 {
        y *= rna_weight(layer.units + o);
    }
    if layer.relu == 1u {
        y = max(y, vec4f(0.0));
    }
    rna_values[place + o] = y;
}

// Four output groups at a time: a value is read once for 16 sums. Sums of int8 layers are whole
// and below 2^24: exact.
fn rna_run_layer(layer: RnaLayer, source: u32, place: u32) {
    if layer.int8_step != 0.0 {
        rna_quantize(layer, source);
    }
    let stride = 4u * layer.inputs;
    for (var o = 0u; o < layer.outputs; o += 4u) {
        var a = vec4f(0.0);
        var b = vec4f(0.0);
        var c = vec4f(0.0);
        var d = vec4f(0.0);
        var at = layer.weights + o * stride;
        for (var k = 0u; k < layer.inputs; k++) {
            let x = rna_values[source + k];
            a += rna_block(x, at);
            b += rna_block(x, at + stride);
            c += rna_block(x, at + 2u * stride);
            d += rna_block(x, at + 3u * stride);
            at += 4u;
        }
        var sums = array<vec4f, 4>(a, b, c, d); // some of groups that the layer does not have
        for (var k = 0u; k < min(4u, layer.outputs - o); k++) {
            rna_finish(layer, o + k, sums[k], place);
        }
    }
}

// What the last layer gives, clipped, as radiance.
fn rna_expand(source: u32) {
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
}

// The place of the results in rna_values, from the queries there.
fn rna_run_decoder() -> u32 {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k <= rna_part.layer_count; k++) {
        var layer = rna_part.matrix;
        if k < rna_part.layer_count {
            layer = rna_part.layers[k];
        } else {
            rna_expand(source);
        }
        if layer.inputs == 0u {
            break; // there is no matrix
        }
        rna_run_layer(layer, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    return source;
}

// Three columns of the results at `place`, from column k on.
fn rna_columns(place: u32, k: u32) -> vec3f {
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return vec3f(x, y, z);
}

// A result, from its terms, of which the second is multiplied by the base colour; each is that of the first set of columns,
// plus those of the others times nearby light: spec/RNA.md, 7.3.
fn rna_colour(place: u32, result: u32, base_color: vec3f, nearby: vec4f) -> vec3f {
    let shares = vec4f(1.0, select(rna_part.means[result].xyz, max(nearby.xyz, vec3f(0.0)), nearby.w != 0.0));
    let terms = select(1u, 2u, rna_part.factors != 0u);
    let sets = select(1u, 4u, rna_part.nearby_columns != 0u);
    var colour = vec3f(0.0);
    for (var term = 0u; term < terms; term++) {
        let first = 3u * result + term * rna_part.factors;
        var sum = vec3f(0.0);
        for (var k = 0u; k < sets; k++) {
            sum += shares[k] * rna_columns(place, first + k * rna_part.nearby_columns);
        }
        colour += select(vec3f(1.0), base_color, term == 1u) * sum;
    }
    return clamp(colour, vec3f(0.0), vec3f(RNA_LARGEST));
}

// The colours for the queries in rna_values.
fn rna_decode(base_color: vec3f, nearby: vec4f) -> RnaTransport {
    let place = rna_run_decoder();
    var colours: array<vec3f, 2>;
    for (var k = 0u; k < 2u; k++) {
        colours[k] = rna_colour(place, k, base_color, nearby);
    }
    return RnaTransport(colours[0], colours[1]);
}
