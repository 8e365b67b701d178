// The WGSL of a part: rna_gpu's files as they stand there, with the names that three.js gives to buffers.
import { compositions, sharedFiles } from "rna_gpu/wgsl";  // by build.mjs
import { constants, records } from "../decoder/records.js";
import withoutSegments from "../webgpu/shaders/without_segments.wgsl";
import baseColorFile from "./shaders/base_color.wgsl";
import emittedFile from "./shaders/emitted.wgsl";
import fiberFile from "./shaders/fiber.wgsl";
import lightFile from "./shaders/light.wgsl";
import nearbyFile from "./shaders/nearby.wgsl";
import sentFile from "./shaders/sent.wgsl";
import sentApartFile from "./shaders/sent_apart.wgsl";
import surfaceFile from "./shaders/surface.wgsl";
import vertexFile from "./shaders/vertex.wgsl";

/** The suffix in a decoder's names: none for the first, with which the others share the planes. */
export const LETTERS = { transport: "", visible: "", shadowed: "s", emission: "e" };

// Buffers of three.js are members `value` of structs; it declares them itself. Geometry is in one of them.
const BUFFER = /\brna([se]?)_(scene|weights|stored|planes|images)\[/g;
const GEOMETRY = /\brna_(nodes|primitives|points)\[([^[\]]*)\]/g;
const WITHOUT_BASE_COLOR = "fn base_color_on(record: RnaPrimitive, p: mat3x3f, b: vec3f, width: f32) -> vec3f { return vec3f(1.0); }";
const WITH_MEANS = "fn nearby_of(wi: vec3f, far: f32, columns: f32, turn: f32) -> vec4f { return vec4f(0.0); }";
const SAMPLING = ["render/directions.wgsl", "render/ggx.wgsl", "render/lobes.wgsl"];
const filesOf = (name) => (name in sharedFiles ? [name] : compositions[name].flatMap(filesOf));

/**
 * mixtures: of all surfaces, by their number. groups: RNA_GROUPS. forms: of the decoders. weightsAt: where those of a form begin that are stored together. planeWords: of a plane.
 * primitivesAt, pointsAt: places of vec4u in the scene. normalsAt: place of the first normal among the points.
 * hasSegments: some part is of strands. printed: { texturesAt, imagesAt } of the words of base colour, or null. lengths: of the nearby light whose columns are traced, or null.
 */
export function partSource({ kind, mixtures, groups, forms, weightsAt, planeWords, primitivesAt, pointsAt, normalsAt, extent, hasSegments, printed, lengths }) {
  // The name of a query is that of a triangle's surface in geometry.wgsl; what part.wgsl has is below.
  const instead = { "surface.wgsl": sharedFiles["surface.wgsl"].replace(/\brna_surface\(/g, "rna_surface_query("), "part.wgsl": "" };
  if (!hasSegments) instead["segment.wgsl"] = withoutSegments;
  const names = [...new Set([...filesOf(kind), ...filesOf("trace"), "visibility.wgsl", ...SAMPLING, ...(printed ? ["images.wgsl"] : []), ...(lengths ? ["render/nearby_light.wgsl"] : [])])];
  const shared = names.map((name) => instead[name] ?? sharedFiles[name]).join("\n")
    .replace(/^@group.*;.*$/gm, "");
  const declarations = `
    const RNA_GROUPS: u32 = ${groups}u;
    const EXTENT: f32 = ${float(extent)};
    const PI: f32 = ${Math.PI};
    const MIXTURES = array<Lobes, ${mixtures.length}>(${mixtures.map(lobesText).join(", ")});
    const NORMALS_AT: u32 = ${normalsAt}u;
    var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
    var<private> rna_instances: array<RnaInstance, 1>; // one body, in its own space
    ${forms.map((form) => weightOf(form, weightsAt[form])).join("\n")}
    fn rna_nodes_at(k: u32) -> RnaNode {
        let low = rna_scene[2u * k];
        let high = rna_scene[2u * k + 1u];
        return RnaNode(bitcast<vec3f>(low.xyz), low.w, bitcast<vec3f>(high.xyz), high.w);
    }
    fn rna_primitives_at(k: u32) -> RnaPrimitive {
        let words = rna_scene[${primitivesAt}u + k];
        return RnaPrimitive(words.x, words.y, words.z, words.w);
    }
    fn rna_points_at(k: u32) -> vec4f { return bitcast<vec4f>(rna_scene[${pointsAt}u + k]); }
    fn rna_plane_word(plane: u32, at: u32) -> u32 { return rna_planes[${planeWords}u * plane + at]; }
    fn rna_normal(point: u32) -> vec3f { return rna_points[NORMALS_AT + point].xyz; }
  `;
  const host = [
    vertexFile, printed ? placesOf(printed) + baseColorFile : WITHOUT_BASE_COLOR, kind === "fiber" ? fiberFile : surfaceFile, lightFile,
    lengths ? `const LENGTHS = vec3f(${lengths.map(float).join(", ")});\n${nearbyFile}` : WITH_MEANS,
    forms.includes("shadowed") ? copyOf(kind, "shadowed") + sentApartFile : sentFile,
    forms.includes("emission") ? copyOf(kind, "emission") + emittedFile : "",
  ];
  return [declarations, shared, ...host].join("\n")
    .replace(GEOMETRY, "rna_$1_at($2)").replace(BUFFER, "rna$1_$2.value[").replace(/\brna([se]?)_part\./g, "rna$1_part.value[0].");
}

/** The decoder once more, with names of its own. */
function copyOf(kind, form) {
  const letter = LETTERS[form], files = filesOf(kind).filter((name) => name !== "part_records.wgsl" && name !== "part.wgsl");
  const text = files.map((name) => sharedFiles[name]).join("\n"), declared = [...text.matchAll(/^(?:const|struct) (\w+)/gm)];
  const source = declared.reduce((all, [, name]) => all.replace(new RegExp(`\\b${name}\\b`, "g"), `${name}_${letter}`), text)
    .replace(/\brna_(?!plane_word\b)/g, `rna${letter}_`);
  return `${source}
    var<private> rna${letter}_values: array<vec4f, 2u * RNA_GROUPS>;
  `;
}

/** Of a decoder; at: where they begin among those that are stored together, or undefined. */
function weightOf(form, at) {
  const letter = LETTERS[form], place = at === undefined ? `rna${letter}_weights[at]` : `rna_stored[${at}u + at]`;
  return `fn rna${letter}_weight(at: u32) -> vec4f { return ${place}; }`;
}

/** Where base_color.wgsl finds the members of surfaces and textures. */
function placesOf({ texturesAt, imagesAt }) {
  const { Surface: { words: surface, members: ofSurface }, Texture: { words: texture, members: ofTexture } } = records;
  const places = {
    SURFACE_WORDS: surface, SURFACE_BASE_COLOR: ofSurface.base_color.at, SURFACE_IMAGE: ofSurface.textures.at + constants.BASE,
    TEXTURE_WORDS: texture, ...Object.fromEntries(Object.entries(ofTexture).map(([name, { at }]) => [`TEXTURE_${name.toUpperCase()}`, at])),
    TEXTURES_AT: texturesAt, IMAGES_AT: imagesAt,
  };
  return Object.entries(places).map(([name, value]) => `const ${name}: u32 = ${value}u;\n`).join("");
}

const lobesText = ({ kind, lobe_shares, lobe_widths }) => `Lobes(${kind === constants.OF_FIBERS}, ${vector(lobe_shares)}, ${vector(lobe_widths)})`;
const vector = (values) => `vec4f(${values.map(float).join(", ")})`;
const float = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));
