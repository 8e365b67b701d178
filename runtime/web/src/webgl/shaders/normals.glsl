// The normals of hits whose place and barycentric coordinates are in the rows.
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int place = int(texelFetch(rows2, pixel, 0).w);
  Hit hit = Hit(0.0, place, texelFetch(rows1, pixel, 0).w, texelFetch(rows3, pixel, 0).w, vec3(0.0));
  first = vec4(shadingNormal(wordsAt(primitives, place), hit), 1.0);
  second = vec4(0.0);
}
