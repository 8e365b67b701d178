// For each query a direction of one light, the radiance from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // LIGHT_SUN and so on, of sources.js
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D sky;          // the environment's numbers: see light/environment.js
uniform ivec4 skyPlaces;        // of texels, heights, sums of rows, sums of columns
uniform ivec2 skySize;          // width, height
uniform float skyTotal;
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

float skyNumber(int at) {
  return valuesAt(sky, at >> 2)[at & 3];
}

// A cell between the middles of four texels, and how bright each is.
struct Cell {
  vec3 a, b, c, d;
  vec4 luminance;
};

vec3 skyTexel(int row, int column) {
  int at = skyPlaces.x + 3 * (clamp(row, 0, skySize.y - 1) * skySize.x + column % skySize.x);
  return vec3(skyNumber(at), skyNumber(at + 1), skyNumber(at + 2));
}

Cell skyCell(int row, int column) {
  vec3 a = skyTexel(row - 1, column), b = skyTexel(row - 1, column + 1);
  vec3 c = skyTexel(row, column), d = skyTexel(row, column + 1), weights = vec3(0.2126, 0.7152, 0.0722);
  return Cell(a, b, c, d, vec4(dot(a, weights), dot(b, weights), dot(c, weights), dot(d, weights)));
}

// Radiance in a cell, bilinear; and the density of brightDirection there, in proportion to its luminance.
vec3 inCell(Cell cell, int row, vec2 f, float sine, out float density) {
  vec3 radiance = mix(mix(cell.a, cell.b, f.x), mix(cell.c, cell.d, f.x), f.y);
  density = dot(radiance, vec3(0.2126, 0.7152, 0.0722)) * float(skySize.x) / (2.0 * PI * max(skyTotal, 1e-30));
  if (row > 0 && row < skySize.y) {
    density *= skyNumber(skyPlaces.y + row) * float(skySize.y) / (PI * max(sine, 1e-30));
  }
  return radiance;
}

vec3 skyAt(vec3 d, out float density) {
  float sine = length(d.xz), azimuth = sine > 0.0 ? atan(d.x, -d.z) : 0.0;
  vec2 at = vec2(0.5 + azimuth / (2.0 * PI), atan(sine, d.y) / PI) * vec2(skySize) + vec2(-0.5, 0.5), low = floor(at);
  int row = clamp(int(low.y), 0, skySize.y), column = (int(low.x) + skySize.x) % skySize.x;
  return inCell(skyCell(row, column), row, at - vec2(low.x, row), sine, density);
}

// The interval of `count` running sums from `first` on that a value is in; the place in it, from 0 to 1.
int interval(int first, int count, float value, out float place) {
  int low = 0, high = count;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (skyNumber(first + middle) <= value) low = middle;
    else high = middle;
  }
  float before = skyNumber(first + low), size = skyNumber(first + low + 1) - before;
  place = size > 0.0 ? clamp((value - before) / size, 0.0, 0.99999994) : 0.0;
  return low;
}

// A place in [0, 1] with density in proportion to a line from a to b.
float linearPlace(float a, float b, float u) {
  float root = sqrt(max(mix(a * a, b * b, u), 0.0));
  return a + root > 0.0 ? u * (a + b) / (a + root) : u;
}

// A row of cells, a cell of it, and a place in that, in proportion to the luminance; at the poles uniform in the cosine.
vec3 brightDirection(vec2 u) {
  vec2 at;
  int rows = skySize.y, row = interval(skyPlaces.z, rows + 1, u.y * skyNumber(skyPlaces.z + rows + 1), at.y);
  int sums = skyPlaces.w + row * (skySize.x + 1), column = interval(sums, skySize.x, u.x * skyNumber(sums + skySize.x), at.x);
  vec4 l = skyCell(row, column).luminance;
  float cap = 2.0 * asin(sqrt(0.5 * at.y * skyNumber(skyPlaces.y + row))) / PI * float(rows);
  float y = row == 0 ? cap + 0.5 : row == rows ? 0.5 - cap : linearPlace(l.x + l.y, l.z + l.w, at.y);
  float x = linearPlace(mix(l.x, l.z, y), mix(l.y, l.w, y), at.x);
  float theta = PI * (float(row) - 0.5 + y) / float(rows), sine = sin(theta);
  float phi = 2.0 * PI * ((float(column) + 0.5 + x) / float(skySize.x) - 0.5);
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
  if (isSegment(wordsAt(primitives, int(row2.w)))) return Surroundings(vec3(0.0), vec3(0.0));
  vec3 n = row1.xyz, wo = row2.xyz;
  return Surroundings(dot(n, wo) < 0.0 ? -n : n, reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
vec3 sampleLight(ivec2 pixel, Surroundings at, out vec3 wi) {
  if (lightKind == LIGHT_SUN || lightKind == LIGHT_GIVEN) {
    wi = lightKind == LIGHT_SUN ? lightDirection : texelFetch(given, pixel, 0).xyz;
    return lightColour;
  }
  vec2 u = random(ivec2(pixel.x, height - 1 - pixel.y - firstRow), DIRECTION);
  wi = lightKind == LIGHT_ENVIRONMENT ? brightDirection(u) : directionAbout(at, u);
  vec3 d = vec3(turn.x * wi.x - turn.y * wi.z, wi.y, turn.x * wi.z + turn.y * wi.x);
  float density;
  vec3 radiance = skyAt(d, density);
  return lightColour * radiance / (density + densityAbout(at, wi));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
  vec3 origin;
  uint strand;  // that is no obstacle
  vec3 weight;
  float coverage;
};

Start startOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if (isSegment(primitive)) return Start(row0.xyz, primitive[PRIMITIVE_C], vec3(1.0), 1.0);
  Hit hit = Hit(0.0, place, row1.w, b2, vec3(0.0));
  return Start(liftedOrigin(primitive, hit, wi), NONE, vec3(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
Start startOnGround(vec3 d, vec3 wi) {
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return Start(vec3(0.0), NONE, vec3(0.0), 0.0);
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  return Start(x + vec3(0.0, epsilon, 0.0), NONE, fade * max(0.0, wi.y) * groundColour, fade);
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
