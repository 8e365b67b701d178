// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(uint k) {
  return texelFetch(weights, ivec2(k & 1023u, k >> 10), 0);
}

void runLayer(RnaLayer layer) {
  bool isInt8 = layer.int8_step > 0.0;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (uint i = 0u; i < layer.inputs; i++) values[i] = clamp(roundEven(values[i] / layer.int8_step), 0.0, 255.0);
  }
  uint at = layer.weights;
  for (uint o = 0u; o < layer.outputs; o++) {
    vec4 bias = weightAt(layer.bias + o), sum = isInt8 ? vec4(0.0) : bias;
    for (uint i = 0u; i < layer.inputs; i++, at += 4u) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1u) * x.y + weightAt(at + 2u) * x.z + weightAt(at + 3u) * x.w;
    }
    if (isInt8) sum = (sum + bias) * weightAt(layer.units + o);
    next[o] = layer.relu == 1u ? max(sum, 0.0) : sum;
  }
  for (uint o = 0u; o < layer.outputs; o++) values[o] = next[o];
}

// The colours, of `values` filled with the query.
void decode(out vec3 first, out vec3 second) {
  for (uint i = 0u; i < part.query_groups; i++) {
    vec4 value = clamp(values[i], part.query_low, part.query_high);
    values[i] = part.gain == RNA_NONE ? value : value * weightAt(part.gain + i) + weightAt(part.gain + part.query_groups + i);
  }
  for (uint k = 0u; k < part.layer_count; k++) runLayer(part.layers[k]);
  uint last = part.layers[part.layer_count - 1u].outputs;
  for (uint i = 0u; i < last; i++) values[i] = (exp(clamp(values[i], 0.0, part.top)) - 1.0) * part.unit;
  if (part.matrix.inputs != 0u) runLayer(part.matrix);
  first = max(values[0].xyz, 0.0);
  second = max(vec3(values[0].w, values[1].xy), 0.0);
}
