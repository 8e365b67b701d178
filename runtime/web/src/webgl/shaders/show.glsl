// The picture on the page: mean of the samples, exposure, sRGB.
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform float rounds;
uniform float exposure;  // a factor
uniform vec3 backdrop;   // linear light of the screen
uniform vec2 size;       // of the canvas, pixels
out vec4 colour;

vec4 at(ivec2 place) {
  return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0);
}

void main() {
  vec2 scale = vec2(textureSize(picture, 0)) / size;
  vec2 place = gl_FragCoord.xy * scale - 0.5, low = floor(place), f = place - low;
  ivec2 a = ivec2(low);
  vec4 mean = mix(mix(at(a), at(a + ivec2(1, 0)), f.x), mix(at(a + ivec2(0, 1)), at(a + ivec2(1, 1)), f.x), f.y) / rounds;
  vec3 linear = clamp(mean.xyz * exposure, 0.0, 1.0) + max(0.0, 1.0 - mean.w) * backdrop;
  vec3 encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  colour = vec4(clamp(encoded, 0.0, 1.0), 1.0);
}
