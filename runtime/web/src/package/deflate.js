// RNA_deflate (spec, 12): entries as a zlib stream of byte planes of differences.
import { fail } from "./errors.js";

/** The entry that `stored` decodes to. */
export async function decodeEntry(stored, { elementSize, distance, size }, name) {
  const coded = await inflate(stored, size, name);
  const whole = Math.floor(size / elementSize), result = new Uint8Array(size);
  for (let byte = 0; byte < elementSize; byte++) {
    const plane = byte * whole;
    for (let k = 0; k < whole; k++) result[k * elementSize + byte] = coded[plane + k];
  }
  result.set(coded.subarray(whole * elementSize), whole * elementSize);
  if (distance) {
    const Elements = { 1: Uint8Array, 2: Uint16Array, 4: Uint32Array }[elementSize];
    const elements = new Elements(result.buffer, 0, whole);
    for (let k = distance; k < whole; k++) elements[k] += elements[k - distance];
  }
  return result;
}

/** Inflates to `size` bytes, and stops at the first one beyond. */
async function inflate(stored, size, name) {
  const result = new Uint8Array(size);
  let at = 0;
  try {
    const reader = new Blob([stored]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      if (at + value.length > size) {
        reader.cancel().catch(() => {});
        throw new RangeError(`more than ${size} bytes`);
      }
      result.set(value, at);
      at += value.length;
    }
  } catch (error) {
    fail("DEFLATE_STREAM", name, `no whole zlib stream of ${size} bytes (${error.message})`);
  }
  if (at !== size) fail("DEFLATE_STREAM", name, `inflates to ${at} bytes, expected ${size}`);
  return result;
}
