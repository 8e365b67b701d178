// Packages inside binary glTF: the extension RNA_relightable_asset (spec/RNA_relightable_asset.md).
import { fail } from "./errors.js";
import { parseJson } from "./json.js";
import { PartSource } from "./source.js";

export const EXTENSION = "RNA_relightable_asset";
const MEDIA_TYPE = "model/vnd.rna", CODE = "GLTF_PACKAGE";
const HEADER = 12, CHUNK = 8, GLTF = 0x46546c67, JSON_CHUNK = 0x4e4f534a, BIN_CHUNK = 0x004e4942;
const LARGEST_JSON = 2 ** 24;

/** Where the bytes of the package are: `source` itself, unless that is a binary glTF that has one. */
export async function packageIn(source) {
  const view = async (start, end) => new DataView((await source.read(start, end)).slice().buffer);
  if (source.size < HEADER + CHUNK) return source;
  const head = await view(0, HEADER + CHUNK), length = head.getUint32(HEADER, true), bin = HEADER + CHUNK + length;
  if (head.getUint32(0, true) !== GLTF || head.getUint32(HEADER + 4, true) !== JSON_CHUNK) return source;
  if (bin > source.size) fail(CODE, source.name, `the file ends within its JSON, at byte ${source.size} of ${bin}`);
  if (length > LARGEST_JSON) fail(CODE, source.name, `JSON of ${length} bytes; at most ${LARGEST_JSON}`);
  const bytes = await source.read(HEADER + CHUNK, bin);
  if (!new TextDecoder().decode(bytes).includes(`"${EXTENSION}"`)) return source;
  const json = parseJson(bytes, source.name, CODE), views = [...packageViews(json, source.name).values()];
  if (!views.length) return source;
  if (views.length > 1) fail(CODE, source.name, `expected one package, found ${views.length}: a scene of several is for rna-run, or GLTFLoader with RNAExtension of rna-three`);
  const [{ buffer, byteOffset = 0, byteLength }] = views, start = bin + CHUNK + byteOffset;
  const isThere = bin + CHUNK <= source.size && (await view(bin, bin + CHUNK)).getUint32(4, true) === BIN_CHUNK;
  if (buffer !== 0 || json.buffers?.[0]?.uri !== undefined || !isThere) fail(CODE, source.name, "the package is not in the file's BIN chunk");
  if (start + byteLength > source.size) fail(CODE, source.name, `the file ends within its package, at byte ${source.size} of ${start + byteLength}`);
  return new PartSource(source, start, start + byteLength);
}

/** The buffer views of packages that nodes have, by index. name: of the file, for messages. */
export function packageViews(json, name) {
  const views = new Map();
  listOf(json.nodes).forEach((node, k) => {
    const given = node?.extensions?.[EXTENSION];
    if (given === undefined) return;
    const where = `${name}: /nodes/${k}/extensions/${EXTENSION}`, view = listOf(json.bufferViews)[given?.package];
    if (given?.mimeType !== MEDIA_TYPE) fail(CODE, `${where}/mimeType`, `expected "${MEDIA_TYPE}", found ${JSON.stringify(given?.mimeType)}`);
    const isView = [view?.buffer, view?.byteOffset ?? 0, view?.byteLength].every((value) => Number.isSafeInteger(value) && value >= 0);
    if (!isView) fail(CODE, `${where}/package`, `expected the index of a buffer view, found ${JSON.stringify(given.package)}`);
    views.set(given.package, view);
  });
  return views;
}

const listOf = (value) => (Array.isArray(value) ? value : []);
