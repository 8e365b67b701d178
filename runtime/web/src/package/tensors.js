// Tensor files: safetensors in the form of the spec (4.3).
import { parseJson } from "./json.js";
import { fail } from "./errors.js";

const TYPES = {
  F32: Float32Array, F16: Uint16Array, I8: Int8Array, U8: Uint8Array,
  U16: Uint16Array, I16: Int16Array, U32: Uint32Array, I32: Int32Array,
};
const HEADER_LIMIT = 65536;

/** A typed array on `bytes`, copied where they are not aligned. */
export function typed(Type, bytes, offset, count) {
  const at = bytes.byteOffset + offset;
  if (at % Type.BYTES_PER_ELEMENT === 0) return new Type(bytes.buffer, at, count);
  return new Type(bytes.slice(offset, offset + count * Type.BYTES_PER_ELEMENT).buffer);
}

/** The header: tensors by name, and where the data starts; `code` of a header that is none. */
export function readHeader(bytes, where, code) {
  if (bytes.length < 8) fail(code, where, "shorter than a header");
  const length = new DataView(bytes.buffer, bytes.byteOffset).getBigUint64(0, true);
  if (length > HEADER_LIMIT || Number(length) > bytes.length - 8) fail(code, where, `a header of ${length} bytes`);
  const data = 8 + Number(length);
  if (bytes[8] !== 0x7b) fail(code, where, "the header does not start with {");
  const { __metadata__: metadata, ...tensors } = parseJson(bytes.subarray(8, data), where, code);
  return { tensors, metadata, data };
}

export const isObject = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
const isCount = (value) => Number.isSafeInteger(value) && value >= 0;

const isCounts = (value) => Array.isArray(value) && value.every(isCount);

/** Whether it is an object with a dtype and a shape of counts. */
export const isTensor = (tensor) => isObject(tensor) && typeof tensor.dtype === "string" && isCounts(tensor.shape);

export const isMetadata = (value) => value === undefined || isObject(value);

/** The named tensors as typed arrays: one after the other, to the end of the file. */
export function takeTensors(bytes, { tensors, data }, names, where, code) {
  let next = 0;
  const result = names.map((name) => {
    const { dtype, shape, data_offsets: offsets } = tensors[name];
    if (!isCounts(offsets) || offsets.length !== 2) fail(code, where, `${name}: data_offsets are not two counts`);
    const [first, last] = offsets;
    const count = shape.reduce((product, side) => product * side, 1);
    if (first !== next || last - first !== count * TYPES[dtype].BYTES_PER_ELEMENT || data + last > bytes.length) {
      fail(code, where, `the bytes of ${name} are not where they must be`);
    }
    next = last;
    return typed(TYPES[dtype], bytes, data + first, count);
  });
  if (data + next !== bytes.length) fail(code, where, "bytes behind the last tensor");
  return result;
}
