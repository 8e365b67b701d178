// Adds what one light brings, or what the asset emits, to the picture.
precision highp float;
precision highp sampler2D;
uniform sampler2D before;
uniform sampler2D rows0;
uniform sampler2D rows3;
uniform sampler2D lit0;
uniform sampler2D lit1;
uniform sampler2D lit2;
uniform sampler2D first;
uniform sampler2D second;
uniform bool isEmission;
uniform bool countsCoverage;  // once a round
uniform bool isFirst;
uniform int firstRow;
out vec4 sum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  sum = isFirst ? vec4(0.0) : texelFetch(before, pixel + ivec2(0, firstRow), 0);
  float part = texelFetch(rows0, pixel, 0).w;
  vec3 a = texelFetch(first, pixel, 0).xyz;
  if (isEmission) {
    if (part > 0.0) sum.xyz += texelFetch(rows3, pixel, 0).xyz * a;
    return;
  }
  vec4 light = texelFetch(lit0, pixel, 0), v = texelFetch(lit1, pixel, 0);
  vec3 radiance = texelFetch(lit2, pixel, 0).xyz;
  if (light.w == 1.0) sum.xyz += radiance * mix(texelFetch(second, pixel, 0).xyz, a, v.xyz);
  if (light.w == 2.0) sum.xyz += radiance;
  if (countsCoverage) sum.w += v.w;
}
