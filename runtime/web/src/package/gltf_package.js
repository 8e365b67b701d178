// Packages inside binary glTF (spec/RNA_relightable_asset.md).
import { fail } from "./errors.js";
import { parseJson } from "./json.js";

export const EXTENSION = "RNA_relightable_asset";
const MEDIA_TYPE = "model/vnd.rna", ALIGNMENT = 64, LARGEST_JSON = 2 ** 23;
const HEADER = 12, CHUNK = 8, GLTF = 0x46546c67, JSON_CHUNK = 0x4e4f534a, BIN_CHUNK = 0x004e4942;

/** Where the bytes of the one package are: `source` itself, unless that is a binary glTF that has some. */
export async function packageIn(source) {
  const { size, name } = source, wrong = (text) => fail("GLB_CONTAINER", name, text);
  const words = async (start, count) => new Uint32Array((await source.read(start, start + 4 * count)).slice().buffer);
  if (size < HEADER + CHUNK) return source;
  const [magic, version, total, length, kind] = await words(0, 5), bin = HEADER + CHUNK + length;
  if (magic !== GLTF || version !== 2) return source;
  if (kind !== JSON_CHUNK || bin > size) wrong(`expected a JSON chunk that ends within the file's ${size} bytes, found a chunk to byte ${bin}`);
  if (length > LARGEST_JSON) wrong(`JSON of ${length} bytes; at most ${LARGEST_JSON}`);
  const bytes = await source.read(HEADER + CHUNK, bin);
  if (!new TextDecoder().decode(bytes).includes(`"${EXTENSION}"`)) return source;
  if (total !== size) wrong(`expected the ${total} bytes that the header says, found ${size}`);
  const [binLength, binKind] = bin + CHUNK <= size ? await words(bin, 2) : [0, BIN_CHUNK], start = bin + CHUNK;
  if (bin < size && (binKind !== BIN_CHUNK || start + binLength > size)) wrong(`expected a BIN chunk at byte ${bin}, found another, or one that ends behind the file`);
  const packages = [...packagesIn(parseJson(bytes, name, "GLB_CONTAINER"), { start, length: binLength }, name).values()];
  if (packages.length > 1) fail("GLB_SEVERAL", name, `expected one package, found ${packages.length}: RNAExtension of rna-three shows scenes of several`);
  return packages.length ? source.part(...packages[0]) : source;
}

/** [start, end] in the file of the packages that nodes have, by their buffer view. bin: start and length of the BIN chunk's data. */
export function packagesIn(json, bin, name) {
  const nodes = Array.isArray(json.nodes) ? json.nodes : [], packages = new Map();
  nodes.forEach((node, k) => {
    const record = node?.extensions?.[EXTENSION];
    if (record == null) return;
    const where = `${name}: /nodes/${k}/extensions/${EXTENSION}`;
    if (record?.mimeType !== MEDIA_TYPE) fail("GLB_PACKAGE", `${where}/mimeType`, `expected "${MEDIA_TYPE}", found ${JSON.stringify(record?.mimeType)}`);
    if (!isSize(record.package)) fail("GLB_PACKAGE", `${where}/package`, `expected the index of a buffer view, found ${JSON.stringify(record.package)}`);
    packages.set(record.package, spanOf(json, record.package, bin, `${name}: /bufferViews/${record.package}`));
  });
  return packages;
}

function spanOf({ bufferViews, buffers }, index, bin, where) {
  const view = bufferViews?.[index], { buffer, byteOffset = 0, byteLength } = view ?? {}, start = bin.start + byteOffset;
  if (!view) fail("GLB_PACKAGE", where, "no such buffer view");
  if (buffer !== 0 || !buffers?.[0] || "uri" in buffers[0]) fail("GLB_PACKAGE", where, "expected a view of the BIN chunk, buffer 0");
  if (!isSize(byteOffset) || !isSize(byteLength) || !byteLength || byteOffset + byteLength > bin.length) fail("GLB_PACKAGE", where, `${byteLength} bytes at ${byteOffset} of ${bin.length}`);
  if (start % ALIGNMENT) fail("GLB_ALIGNMENT", where, `begins at byte ${start} of the file, no multiple of ${ALIGNMENT}`);
  return [start, start + byteLength];
}

const isSize = (value) => Number.isSafeInteger(value) && value >= 0;
