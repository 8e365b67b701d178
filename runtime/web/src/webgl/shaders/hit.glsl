// A ray from the camera through each pixel, to the query of its first hit.
#include random

uniform vec3 cameraAt;
uniform vec3 corner;       // direction through the image's top left corner
uniform vec3 stepX;        // of a pixel
uniform vec3 stepY;
uniform int height;        // of the picture
uniform int firstRow;      // of the band
uniform float jitter;      // 0: rays through the middles of pixels, 1: anywhere in them

layout(location = 0) out vec4 row0;  // x; part + 1, or 0
layout(location = 1) out vec4 row1;  // n or t; of a fiber h, of a surface b1
layout(location = 2) out vec4 row2;  // wo; place of the primitive
layout(location = 3) out vec4 row3;  // throughput; b2

const int LAYERS_SEEN_THROUGH = 32;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) + ivec2(0, firstRow);
  pixel.y = height - 1 - pixel.y;  // rows from the top, as the random numbers of WebGPU have them
  vec2 at = vec2(pixel) + mix(vec2(0.5), random(pixel, PLACE), jitter);
  vec3 d = normalize(corner + at.x * stepX + at.y * stepY), origin = cameraAt, through = vec3(1.0);
  row0 = vec4(0.0);
  row1 = vec4(0.0);
  row2 = vec4(-d, 0.0);
  row3 = vec4(0.0);
  for (int k = 0; k < LAYERS_SEEN_THROUGH; k++) {
    Hit hit = nearest(origin, d);
    if (hit.t == FAR) break;
    uvec4 primitive = wordsAt(primitives, hit.place);
    bool fiber = isSegment(primitive);
    vec3 tau = fiber ? vec3(0.0) : transmittance(primitive, hit, d);
    float chance = max(tau.x, max(tau.y, tau.z));
    // Straight on, or stopped here: chosen at random (spec, 4.4).
    if (chance > 0.0 && random(pixel, STOPPED + uint(k)).x < chance) {
      through *= tau / chance;
      origin += d * (hit.t + 4.0 * epsilon);
      continue;
    }
    if (chance > 0.0) through *= (1.0 - tau) / (1.0 - chance);
    vec3 x = origin + hit.t * d;
    float part = float(surfaceRow(primitive, SURFACE_PART_ROW)[SURFACE_PART] + 1u);
    if (fiber) {
      vec3 t = tangentOf(primitive);
      row1 = vec4(t, offsetAcross(hit.n, t, -d));
    } else {
      x = mixed(cornersOf(primitive).p, weightsOf(hit));
      row1 = vec4(shadingNormal(primitive, hit), hit.b1);
    }
    row0 = vec4(x, part);
    row2.w = float(hit.place);
    row3.w = hit.b2;
    break;
  }
  row3.xyz = through;
}
