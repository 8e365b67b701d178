// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
// recurrence in four dimensions (Roberts 2018), so that the samples of a pixel are spread evenly. All others: hashed.

uniform uint sampleNumber;

uint hashed(uint x) {  // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

const uint PLACE = 0u, DIRECTION = 1u, STOPPED = 2u;  // and those behind it

vec2 random(ivec2 pixel, uint dimension) {
  uint own = dimension >= STOPPED ? sampleNumber : 0u;
  uint seed = hashed(uint(pixel.x) + hashed(uint(pixel.y) + hashed(dimension + hashed(own))));
  vec2 start = vec2(seed >> 8u, hashed(seed) >> 8u) / 16777216.0;
  if (dimension >= STOPPED) return start;
  // In whole numbers: floats of later samples would lose digits.
  uvec2 turn = dimension == DIRECTION ? uvec2(2700274805u, 2313257605u) : uvec2(3679390609u, 3152041523u);
  return fract(start + vec2((turn * sampleNumber) >> 8u) / 16777216.0);
}
