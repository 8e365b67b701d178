// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform float rounds;
uniform float exposure;  // a factor
uniform float filmicView;  // 1 for the filmic view transform, 0 for none
uniform float spread;    // of noise, in values of the screen; 0 to leave it
uniform vec3 backdrop;   // linear light of the screen
uniform vec2 size;       // of the canvas, pixels
out vec4 colour;

vec4 at(ivec2 place) {
  return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0);
}

// As rna_render/image/view_transform.py, which names the source.
vec3 filmic(vec3 radiance) {
  vec3 c = 1.461926 * min(radiance, vec3(1e9));
  vec3 x = vec3(dot(c, vec3(0.59719, 0.35458, 0.04823)), dot(c, vec3(0.07600, 0.90834, 0.01566)),
                dot(c, vec3(0.02840, 0.13383, 0.83777)));
  // Both parts divided by x, so that none overflows.
  vec3 inv = 1.0 / max(x, vec3(1e-9));
  vec3 y = (x + 0.0245786 - 0.000090537 * inv) / (0.983729 * x + 0.4329510 + 0.238081 * inv);
  return vec3(dot(y, vec3(1.60475, -0.53108, -0.07367)), dot(y, vec3(-0.10208, 1.10813, -0.00605)),
              dot(y, vec3(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, of a mean.
vec3 displayed(vec4 mean) {
  vec3 exposed = max(mean.xyz * exposure, vec3(0.0));
  vec3 light = filmicView > 0.5 ? filmic(exposed) : exposed;
  vec3 linear = clamp(light, 0.0, 1.0) + max(0.0, 1.0 - mean.w) * backdrop;
  vec3 encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  return clamp(encoded, 0.0, 1.0);
}

void main() {
  vec2 scale = vec2(textureSize(picture, 0)) / size;
  vec2 place = gl_FragCoord.xy * scale - 0.5, low = floor(place), f = place - low;
  ivec2 a = ivec2(low);
  vec4 mean = mix(mix(at(a), at(a + ivec2(1, 0)), f.x), mix(at(a + ivec2(0, 1)), at(a + ivec2(1, 1)), f.x), f.y) / rounds;
  vec3 here = displayed(mean);
  colour = vec4(here, 1.0);
  if (spread == 0.0) return;
  // Bilateral: neighbours count by how near and how like they are.
  vec4 sum = vec4(here, 1.0);
  vec2 middle = floor(place + 0.5);
  for (float dy = -2.0; dy <= 2.0; dy += 1.0) {
    for (float dx = -2.0; dx <= 2.0; dx += 1.0) {
      vec2 there = middle + vec2(dx, dy), away = there - place;
      vec4 other = at(ivec2(there)) / rounds;
      vec3 value = displayed(other), unlike = (value - here) / spread;
      float edge = 4.0 * (other.w - mean.w);
      sum += vec4(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
    }
  }
  colour = vec4(sum.xyz / sum.w, 1.0);
}
