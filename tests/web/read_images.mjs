// node read_images.mjs FILE...: one line of JSON a file, as the viewer reads it:
// { height, width, rgb } with rgb as base64 of float32, or { error }.
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { readImage } from "../../runtime/web/src/light/image_files.js";

console.warn = () => {};  // three's, of attributes that it does not know
for (const path of process.argv.slice(2)) {
  const file = readFileSync(path), buffer = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
  let result;
  try {
    const { rgb, width, height } = readImage(buffer, basename(path));
    result = { height, width, rgb: Buffer.from(rgb.buffer).toString("base64") };
  } catch (error) {
    result = { error: `${error.constructor.name}: ${error.message}` };
  }
  console.log(JSON.stringify(result));
}
