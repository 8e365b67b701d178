// Surfaces of the scene, by the number that primitives have: sections of `table`, filled by
// scene_surfaces.py. Numbers of textures are NONE for none.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

const OF_MATERIAL: u32 = 0u; // kinds of surfaces
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;

const EMITS: u32 = 1u; // flags
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u; // a material whose rays end on it only so often: see bsdf.wgsl
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;

// vec4f, in this order: kind, part, flags, normal map of an asset; base colour, roughness; metallic,
// F0, weight of the coat, transmission; emission, scale of the normal texture; clear coat, its
// roughness, places in `images` of second texture coordinates and tangents; textures of base colour,
// metallic and roughness, coat, emission; of clear coat, its roughness, transmission, normals; what is let
// through: texture, cutoff, indices of refraction; F0 of it by Schlick, free.
const SURFACE_SIZE: u32 = 9u;

const BASE: u32 = 0u; // textures of a material
const METAL: u32 = 1u;
const COAT: u32 = 2u;
const GLOW: u32 = 3u;
const CLEAR: u32 = 4u;
const CLEAR_ROUGH: u32 = 5u;
const THROUGH: u32 = 6u;
const RELIEF: u32 = 7u;

fn surface_row(surface: u32, k: u32) -> vec4f {
    return table[frame.surfaces + SURFACE_SIZE * surface + k];
}

fn surface_kind(surface: u32) -> u32 {
    return bitcast<u32>(surface_row(surface, 0u).x);
}

fn surface_part(surface: u32) -> u32 {
    return bitcast<u32>(surface_row(surface, 0u).y);
}

fn surface_has(surface: u32, flag: u32) -> bool {
    return (bitcast<u32>(surface_row(surface, 0u).z) & flag) != 0u;
}

fn surface_texture(surface: u32, k: u32) -> u32 {
    return bitcast<u32>(surface_row(surface, 5u + k / 4u)[k % 4u]);
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = bitcast<u32>(surface_row(surface, 4u).z) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: vec4<u32>, uv_set: u32) -> mat3x2f {
    let surface = record.w >> 1u;
    return mat3x2f(
        corner_uv(surface, record.x, uv_set),
        corner_uv(surface, record.y, uv_set),
        corner_uv(surface, record.z, uv_set),
    );
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
