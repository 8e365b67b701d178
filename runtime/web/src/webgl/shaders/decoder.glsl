// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;
uniform int layerCount;
uniform ivec4 layers[LAYERS];   // groups of inputs, groups of outputs, first texel of weights, of bias
uniform vec2 steps[LAYERS];     // of int8: scale of the inputs; first texel of the outputs' scales
uniform bool isInt8;
uniform int gainAt;             // of int8: first texel of gains, then of offsets
uniform vec3 limits;            // low and high of the first Clip, top of the second
uniform int matrixAt;           // first texel of the matrix, or -1
uniform float unitOf;
uniform int outputs;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(int k) {
  return texelFetch(weights, ivec2(k & 1023, k >> 10), 0);
}

void runLayer(int k) {
  ivec4 layer = layers[k];
  bool last = k == layerCount - 1;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (int i = 0; i < layer.x; i++) values[i] = clamp(roundEven(values[i] / steps[k].x), 0.0, 255.0);
  }
  for (int o = 0; o < layer.y; o++) {
    vec4 sum = isInt8 ? vec4(0.0) : weightAt(layer.w + o);
    int at = layer.z + 4 * layer.x * o;
    for (int i = 0; i < layer.x; i++, at += 4) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1) * x.y + weightAt(at + 2) * x.z + weightAt(at + 3) * x.w;
    }
    if (isInt8) sum = (sum + weightAt(layer.w + o)) * weightAt(int(steps[k].y) + o) * steps[k].x;
    next[o] = last || isInt8 ? sum : max(sum, 0.0);
  }
  for (int o = 0; o < layer.y; o++) values[o] = next[o];
}

// Six numbers of `columns`, three and three.
void decode(int width, out vec3 first, out vec3 second) {
  int groups = layers[0].x;
  for (int i = 0; i < groups; i++) {
    vec4 value = vec4(0.0);
    for (int c = 0; c < 4; c++) if (4 * i + c < width) value[c] = columns[4 * i + c];
    value = clamp(value, limits.x, limits.y);
    values[i] = isInt8 ? value * weightAt(gainAt + i) + weightAt(gainAt + groups + i) : value;
  }
  for (int k = 0; k < layerCount; k++) runLayer(k);
  int last = layers[layerCount - 1].y;
  float result[8];
  for (int i = 0; i < 8; i++) result[i] = 0.0;
  for (int i = 0; i < last; i++) values[i] = exp(clamp(values[i], 0.0, limits.z)) - 1.0;
  if (matrixAt < 0) {
    for (int i = 0; i < outputs; i++) result[i] = values[i / 4][i % 4] * unitOf;
  } else {
    for (int i = 0; i < last; i++) {
      for (int c = 0; c < 4; c++) {
        vec4 low = weightAt(matrixAt + 2 * (4 * i + c)), high = weightAt(matrixAt + 2 * (4 * i + c) + 1);
        for (int o = 0; o < 4; o++) {
          result[o] += values[i][c] * low[o];
          result[4 + o] += values[i][c] * high[o];
        }
      }
    }
  }
  first = max(vec3(result[0], result[1], result[2]), 0.0);
  second = max(vec3(result[3], result[4], result[5]), 0.0);
}
