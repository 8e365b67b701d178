// For each query a direction of one light, what arrives from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // 0: sun; environment: 1 where it is bright, 3 about the point; 2: given directions
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D environment;  // radiance, row 0 at +y; w: the row's distribution along it
uniform sampler2D marginal;     // distribution over rows; 1 / the sum of weights; the least weight
uniform vec2 turn;              // cosine and sine of the environment's rotation
uniform vec4 ground;            // height, 1 if there is one, middle x and z
uniform vec3 groundColour;      // radiance of it in full light, over the light's irradiance
uniform float groundSize;
uniform vec3 cameraAt;
uniform int height;
uniform int firstRow;

layout(location = 0) out vec4 lit0;  // wi; 0 nothing, 1 a query, 2 radiance in lit2
layout(location = 1) out vec4 lit1;  // visibility; coverage
layout(location = 2) out vec4 lit2;  // radiance over density, times the throughput

const float PI = 3.14159265358979;

int searched(sampler2D table, int row, int count, float u, int channel) {
  int low = 0, high = count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(table, ivec2(middle, row), 0)[channel] > u) high = middle;
    else low = middle + 1;
  }
  return low;
}

// A texel's weight among all: luminance times the sine of its row.
float texelWeight(vec3 rgb, int row, ivec2 size) {
  float least = texelFetch(marginal, ivec2(size.y + 1, 0), 0).x;
  return max(least, dot(rgb, vec3(0.2126, 0.7152, 0.0722))) * sin(PI * (float(row) + 0.5) / float(size.y));
}

// Radiance at a place in the image, bilinear, and the density there of brightDirection: the weights, bilinear.
vec3 skyAt(vec2 st, float sine, out float density) {
  ivec2 size = textureSize(environment, 0);
  vec2 at = st * vec2(size) - 0.5, low = floor(at), f = at - low;
  vec3 radiance = vec3(0.0);
  float weight = 0.0;
  for (int k = 0; k < 4; k++) {
    ivec2 offset = ivec2(k & 1, k >> 1);
    float share = (offset.x == 1 ? f.x : 1.0 - f.x) * (offset.y == 1 ? f.y : 1.0 - f.y);
    int column = (int(low.x) + offset.x + size.x) % size.x, row = clamp(int(low.y) + offset.y, 0, size.y - 1);
    vec3 rgb = texelFetch(environment, ivec2(column, row), 0).xyz;
    radiance += share * rgb;
    weight += share * texelWeight(rgb, row, size);
  }
  float overTotal = texelFetch(marginal, ivec2(size.y, 0), 0).x;
  density = weight * overTotal * float(size.x * size.y) / (2.0 * PI * PI * max(sine, 1e-6));
  return radiance;
}

// From the uniform distribution on [0, 1] to the tent about 0, on [-1, 1].
vec2 tent(vec2 u) {
  vec2 t = 2.0 * clamp(u, 0.0, 1.0) - 1.0;
  return sign(t) * (1.0 - sqrt(1.0 - abs(t)));
}

// A direction: a texel in proportion to its weight, then a place about its middle by a tent
// two texels wide. So the density is the weights' bilinear interpolation, and follows the radiance that is looked up.
vec3 brightDirection(vec2 u) {
  ivec2 size = textureSize(environment, 0);
  int row = searched(marginal, 0, size.y, u.y, 0);
  float before = row > 0 ? texelFetch(marginal, ivec2(row - 1, 0), 0).x : 0.0;
  float chance = texelFetch(marginal, ivec2(row, 0), 0).x - before;
  int column = searched(environment, row, size.x, u.x, 3);
  float left = column > 0 ? texelFetch(environment, ivec2(column - 1, row), 0).w : 0.0;
  float width = texelFetch(environment, ivec2(column, row), 0).w - left;
  vec2 within = (u - vec2(left, before)) / max(vec2(width, chance), 1e-12);
  vec2 place = (vec2(column, row) + 0.5 + tent(within)) / vec2(size);
  vec2 st = vec2(fract(place.x), 1.0 - abs(1.0 - abs(place.y)));  // back from beyond the poles
  float theta = PI * st.y, phi = 2.0 * PI * (st.x - 0.5), sine = sin(theta);
  vec3 d = vec3(sine * sin(phi), cos(theta), -sine * cos(phi));
  return vec3(turn.x * d.x + turn.y * d.z, d.y, turn.x * d.z - turn.y * d.x);
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
  vec3 n;  // turned to the viewer
  vec3 mirror;
};

const float MIRRORED = 1.0 / 3.0, MIRROR_KAPPA = 20.0;  // of a von Mises-Fisher distribution
const float FROM_ALL_SIDES = 0.25, EVEN = 0.25 / PI;

float mirroredShare(Surroundings at) {
  return at.mirror == vec3(0.0) ? 0.0 : MIRRORED;
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
vec3 along(vec3 axis, float cosine, float phi) {
  float side = axis.z < 0.0 ? -1.0 : 1.0, c = -1.0 / (side + axis.z), d = axis.x * axis.y * c;
  vec3 s = vec3(1.0 + side * axis.x * axis.x * c, side * d, -side * axis.x);
  vec3 t = vec3(d, side + axis.y * axis.y * c, -axis.y);
  return normalize(sqrt(max(0.0, 1.0 - cosine * cosine)) * (cos(phi) * s + sin(phi) * t) + cosine * axis);
}

vec3 directionAbout(Surroundings at, vec2 u) {
  float share = mirroredShare(at), phi = 2.0 * PI * u.x;
  if (u.y < share) {
    float v = u.y / share;
    return along(at.mirror, 1.0 + log(v + (1.0 - v) * exp(-2.0 * MIRROR_KAPPA)) / MIRROR_KAPPA, phi);
  }
  float rest = (u.y - share) / (1.0 - share);
  bool allSides = rest < FROM_ALL_SIDES;
  float v = allSides ? rest / FROM_ALL_SIDES : (rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES);
  vec3 ball = along(vec3(0.0, 0.0, 1.0), 1.0 - 2.0 * v, phi);
  return normalize(ball + (allSides ? vec3(0.0) : at.n * 1.0001));
}

float densityAbout(Surroundings at, vec3 wi) {
  if (at.n == vec3(0.0)) return EVEN;
  float rest = mix(max(0.0, dot(at.n, wi)) / PI, EVEN, FROM_ALL_SIDES);
  float fisher = MIRROR_KAPPA / (2.0 * PI) * exp(MIRROR_KAPPA * (dot(at.mirror, wi) - 1.0));
  return mix(rest, fisher, mirroredShare(at));
}

Surroundings surroundingsOf(vec4 row0, vec4 row1, vec4 row2) {
  if (row0.w == 0.0) return Surroundings(vec3(0.0, 1.0, 0.0), vec3(0.0));  // of the ground
  if ((wordsAt(primitives, int(row2.w)).w & SEGMENT) != 0u) return Surroundings(vec3(0.0), vec3(0.0));
  vec3 n = row1.xyz, wo = row2.xyz;
  return Surroundings(dot(n, wo) < 0.0 ? -n : n, reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
vec3 sampleLight(ivec2 pixel, Surroundings at, out vec3 wi) {
  if (lightKind == 0 || lightKind == 2) {
    wi = lightKind == 0 ? lightDirection : texelFetch(given, pixel, 0).xyz;
    return lightColour;
  }
  vec2 u = random(ivec2(pixel.x, height - 1 - pixel.y - firstRow), DIRECTION);
  wi = lightKind == 1 ? brightDirection(u) : directionAbout(at, u);
  vec3 d = vec3(turn.x * wi.x - turn.y * wi.z, wi.y, turn.x * wi.z + turn.y * wi.x);
  float density;
  vec2 st = vec2(atan(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI);
  vec3 radiance = skyAt(st, length(d.xz), density);
  return lightColour * radiance / (density + densityAbout(at, wi));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
  vec3 origin;
  uint strand;  // that is no obstacle
  vec3 weight;
  float coverage;
};

const uint NO_STRAND = 0xffffffffu;

Start startOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if ((primitive.w & SEGMENT) != 0u) return Start(row0.xyz, primitive.z, vec3(1.0), 1.0);
  Hit hit = Hit(0.0, primitive.w, place, row1.w, b2, vec3(0.0));
  return Start(liftedOrigin(primitive, hit, wi), NO_STRAND, vec3(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
Start startOnGround(vec3 d, vec3 wi) {
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return Start(vec3(0.0), NO_STRAND, vec3(0.0), 0.0);
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  return Start(x + vec3(0.0, epsilon, 0.0), NO_STRAND, fade * max(0.0, wi.y) * groundColour, fade);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0), row1 = texelFetch(rows1, pixel, 0);
  vec4 row2 = texelFetch(rows2, pixel, 0), row3 = texelFetch(rows3, pixel, 0);
  bool isQuery = row0.w != 0.0;
  vec3 wi, radiance = row3.xyz * sampleLight(pixel, surroundingsOf(row0, row1, row2), wi);
  Start start;
  if (isQuery) start = startOf(row0, row1, row2, row3.w, wi);
  else start = startOnGround(-row2.xyz, wi);
  bool needed = any(greaterThan(start.weight, vec3(0.0)));
  vec3 passed = needed ? passes(start.origin, wi, start.strand) : vec3(0.0);
  lit0 = vec4(wi, isQuery ? 1.0 : 2.0);
  lit1 = vec4(passed, start.coverage);
  lit2 = vec4(isQuery ? radiance : start.weight * passed * radiance, 0.0);
}
