// glTF's metallic-roughness material under suns and an environment that is prefiltered (light/prefilter.js), in values of the screen.
precision highp float;
precision highp sampler2D;

const int MOST_SUNS = 16;
const float PI = 3.14159265;
const float COSINE_KAPPA = 3.0; // von Mises-Fisher whose mean cosine is that of a cosine lobe

uniform vec3 eye;
uniform vec3 factor;
uniform vec3 to_u;
uniform vec3 to_v;
uniform vec2 constants; // roughness, metallic
uniform bool has_image;
uniform bool has_levels; // of metallic and roughness
uniform int relief;      // of normals: 0 none, 1 glTF's, 2 the two numbers of spec/RNA.md, 4.5
uniform sampler2D image;
uniform sampler2D metallic_roughness;
uniform sampler2D normals;
uniform sampler2D holes;
uniform int hole_channels; // of transmittance; 0 without
uniform float cutoff;
uniform int suns;
uniform vec3 directions[MOST_SUNS];
uniform vec3 irradiances[MOST_SUNS];
uniform vec3 around; // radiance of the environment, in its unit
uniform vec2 turn;   // cosine and sine
uniform sampler2D environment;
uniform vec3 levels; // rows of one, number, least kappa
uniform float exposure;
uniform bool is_filmic;

in vec3 x;
in vec3 n;
in vec2 uv;
out vec4 color;

vec3 level_at(vec2 place, float level) {
    float rows = levels.x;
    return texture(environment, vec2(place.x, (level * rows + 0.5 + place.y * (rows - 1.0)) / (rows * levels.y))).rgb;
}

// Mean radiance of the environment under a von Mises-Fisher distribution about v.
vec3 mean_about(vec3 v, float kappa) {
    vec3 d = vec3(turn.x * v.x - turn.y * v.z, v.y, turn.x * v.z + turn.y * v.x);
    vec2 place = vec2(atan(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI);
    float level = clamp(2.0 * log2(kappa / levels.z), 0.0, levels.y - 1.0);
    float low = min(floor(level), levels.y - 2.0);
    return around * mix(level_at(place, low), level_at(place, low + 1.0), level - low);
}

// The mapped normal (spec/RNA.md, 4.5), its tangent from the pixel's differences.
vec3 mapped(vec3 normal) {
    vec3 e1 = dFdx(x), e2 = dFdy(x);
    vec2 d1 = dFdx(uv), d2 = dFdy(uv);
    float side = sign(d1.x * d2.y - d2.x * d1.y);
    vec3 U = (d2.y * e1 - d1.y * e2) * side, V = (d1.x * e2 - d2.x * e1) * side;
    vec3 T = U - dot(U, normal) * normal;
    if (side == 0.0 || length(T) <= 1e-6 * length(U)) return normal;
    vec3 t = normalize(T), w = cross(normal, t);
    vec3 q = texture(normals, uv).xyz * 2.0 - 1.0;
    if (relief == 2) {
        q.xy = (127.5 * q.xy + 0.5) / 127.0;
        q.z = sqrt(max(0.0, 1.0 - dot(q.xy, q.xy)));
    }
    return normalize(q.x * t + q.y * (dot(w, V) > 0.0 ? -w : w) + q.z * normal);
}

// What is reflected of light from all sides. The part beyond f0: Karis, Physically Based Shading on Mobile, 2014; here white
// metals are white.
vec3 reflected(vec3 f0, float roughness, float cosine) {
    vec3 r = roughness * vec3(-1.0, -0.0275, 0.022) + vec3(1.0, 0.0425, -0.04);
    float beyond = 1.04 * (min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y) + r.z;
    return f0 + (1.0 - f0) * max(beyond, 0.0);
}

// GGX with height-correlated masking, over the incoming cosine.
float ggx(vec3 m, vec3 wo, vec3 wi, float alpha) {
    float square = alpha * alpha, ci = max(dot(m, wi), 0.0), co = max(dot(m, wo), 1e-3);
    vec3 h = normalize(wo + wi), across = cross(m, h);
    float ch = dot(m, h), spread = dot(across, across) + square * ch * ch;
    float masked = ci * sqrt(square + (1.0 - square) * co * co) + co * sqrt(square + (1.0 - square) * ci * ci);
    return square / (PI * spread * spread) * 0.5 / max(masked, 1e-6);
}

// As rna_render/image/view_transform.py, which names the source.
vec3 filmic(vec3 radiance) {
    vec3 c = 1.461926 * min(radiance, vec3(1e9));
    vec3 v = vec3(dot(c, vec3(0.59719, 0.35458, 0.04823)), dot(c, vec3(0.07600, 0.90834, 0.01566)), dot(c, vec3(0.02840, 0.13383, 0.83777)));
    vec3 y = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    return vec3(dot(y, vec3(1.60475, -0.53108, -0.07367)), dot(y, vec3(-0.10208, 1.10813, -0.00605)), dot(y, vec3(-0.00327, -0.07276, 1.07602)));
}

void main() {
    // What lets more light pass is taken to be open.
    vec3 passed = texture(holes, uv).rgb;
    if (hole_channels > 0 && (hole_channels == 1 ? passed.r : dot(passed, vec3(1.0 / 3.0))) > cutoff) discard;
    vec3 wo = normalize(eye - x), m = normalize(n);
    if (dot(m, wo) < 0.0) m = -m;
    vec3 base = factor;
    vec2 looks = constants;
    if (has_image) base *= texture(image, vec2(dot(to_u, vec3(uv, 1.0)), dot(to_v, vec3(uv, 1.0)))).rgb;
    if (has_levels) looks = texture(metallic_roughness, uv).gb;
    if (relief > 0) m = mapped(m);
    float roughness = max(looks.x, 0.03), metallic = looks.y, alpha = roughness * roughness, co = max(dot(m, wo), 1e-3);
    vec3 f0 = mix(vec3(0.04), base, metallic), albedo = (1.0 - metallic) * base * (1.0 - reflected(vec3(0.04), roughness, co));
    vec3 light = albedo * mean_about(m, COSINE_KAPPA);
    // Of the lobe about the mirrored direction: Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance, 2009.
    light += reflected(f0, roughness, co) * mean_about(reflect(-wo, m), 0.5 / (alpha * alpha));
    for (int k = 0; k < suns; k++) {
        vec3 wi = directions[k];
        float fresnel = pow(1.0 - max(dot(wo, normalize(wo + wi)), 0.0), 5.0);
        light += (albedo / PI + (f0 + (1.0 - f0) * fresnel) * ggx(m, wo, wi, alpha)) * irradiances[k] * max(dot(m, wi), 0.0);
    }
    light *= exposure;
    light = clamp(is_filmic ? filmic(light) : light, 0.0, 1.0);
    color = vec4(mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light)), 1.0);
}
