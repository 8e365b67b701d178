// The WGSL of a part: rna_gpu's files as they stand there, with the names that three.js gives to buffers.
import { compositions, sharedFiles } from "rna_gpu/wgsl";  // by build.mjs
import withoutSegments from "../webgpu/shaders/without_segments.wgsl";
import fiberFile from "./shaders/fiber.wgsl";
import lightFile from "./shaders/light.wgsl";
import surfaceFile from "./shaders/surface.wgsl";
import vertexFile from "./shaders/vertex.wgsl";

// Buffers of three.js are members `value` of structs; it declares them itself.
const BUFFERS = ["nodes", "primitives", "points", "weights", "plane_xy", "plane_yz", "plane_zx"];
const BUFFER = new RegExp(`\\brna(e?)_(${BUFFERS.join("|")})\\[`, "g");
const filesOf = (name) => (name in sharedFiles ? [name] : compositions[name].flatMap(filesOf));

/** groups: RNA_GROUPS. normalsAt: place of the first normal among the points. hasSegments: some part is of strands. */
export function partSource({ kind, groups, emits, normalsAt, extent, hasSegments }) {
  // The name of a query is that of a triangle's surface in geometry.wgsl.
  const instead = { "surface.wgsl": sharedFiles["surface.wgsl"].replace(/\brna_surface\(/g, "rna_surface_query(") };
  if (!hasSegments) instead["segment.wgsl"] = withoutSegments;
  const names = [...new Set([...filesOf(kind), ...filesOf("trace"), "visibility.wgsl"])];
  const shared = names.map((name) => instead[name] ?? sharedFiles[name]).join("\n")
    .replace(/^@group.*;.*$/gm, "");
  const own = `
    const RNA_GROUPS: u32 = ${groups}u;
    const EXTENT: f32 = ${float(extent)};
    var<private> rna_instances: array<RnaInstance, 1>; // one body, in its own space
    fn rna_weight(at: u32) -> vec4f { return rna_weights[at]; }
    fn rna_normal(point: u32) -> vec3f { return rna_points[${normalsAt}u + point].xyz; }
  `;
  const host = [vertexFile, kind === "fiber" ? fiberFile : surfaceFile, lightFile, emits ? emissionSource(kind) : ""];
  return [own, shared, ...host].join("\n")
    .replace(BUFFER, "rna$1_$2.value[").replace(/\brna(e?)_part\./g, "rna$1_part.value[0].");
}

/** The decoder once more, with names of its own. */
function emissionSource(kind) {
  const files = filesOf(kind).filter((name) => name !== "part_records.wgsl" && name !== "part.wgsl").map((name) => sharedFiles[name]);
  const source = files.join("\n").replace(/\brna_(?!plane_(xy|yz|zx)\b)/g, "rnae_").replace(/\bRna(Transport|Texel)\b/g, "Rnae$1")
    .replace(/\bRNA_ETA\b/g, "RNAE_ETA");
  return `${source}
    var<private> rnae_values: array<vec4f, 2u * RNA_GROUPS>;
    fn rnae_weight(at: u32) -> vec4f { return rnae_weights[at]; }
    fn emitted(primitive: u32, x: vec3f, wo: vec3f) -> vec3f {
        if begin(primitive, x, wo) == 0.0 {
            return vec3f(0.0);
        }
        return rnae_query(vertex.x, vertex.axis, vertex.h, wo, wo).visible;
    }
  `;
}

const float = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));
