// Environment images: .hdr and .exr files, read by three.
import { FloatType } from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { HDRLoader } from "three/addons/loaders/HDRLoader.js";
import { NotSupported } from "../package/errors.js";

/** { rgb, width, height } with row 0 at the top, of a file's bytes; its name says which kind. */
export function readImage(buffer, name) {
  const exr = /\.exr$/i.test(name);
  if (!exr && !/\.(hdr|pic)$/i.test(name)) throw new NotSupported(`${name}: neither .hdr nor .exr`);
  let image;
  try {
    image = new (exr ? EXRLoader : HDRLoader)().setDataType(FloatType).parse(buffer);
  } catch (error) {
    throw new NotSupported(`${name}: no image that can be read (${error.message ?? error})`);
  }
  const { data, width, height } = image, channels = data.length / (width * height);
  const rgb = new Float32Array(3 * width * height);
  for (let row = 0; row < height; row++) {
    const from = exr ? height - 1 - row : row;  // three has EXR rows from the bottom
    for (let column = 0; column < width; column++) {
      for (let c = 0; c < 3; c++) {
        const value = data[channels * (from * width + column) + Math.min(c, channels - 1)];
        rgb[3 * (row * width + column) + c] = Number.isFinite(value) ? Math.max(0, value) : 0;
      }
    }
  }
  return { rgb, width, height };
}
