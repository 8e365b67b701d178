// Numbers in [0, 1): of each pixel and dimension a start of its own, and from there the additive recurrence
// with the plastic number (Roberts 2018), so that the samples of a pixel are spread evenly.

uniform uint sampleNumber;

uint hashed(uint x) {  // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

vec2 firstRandom(ivec2 pixel, int dimension) {
  uint seed = hashed(uint(pixel.x) + hashed(uint(pixel.y) + hashed(uint(dimension))));
  vec2 start = vec2(seed >> 8u, hashed(seed) >> 8u) / 16777216.0;
  // In whole numbers: floats of later samples would lose digits.
  uvec2 turned = uvec2(3242174889u, 2447445414u) * sampleNumber;
  return fract(start + vec2(turned >> 8u) / 16777216.0);
}
