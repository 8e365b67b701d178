// Environment images: Radiance and OpenEXR files, which their first bytes tell apart.
import { NotSupported } from "../package/errors.js";
import { otherFile } from "../package/other_files.js";
import { readExr } from "./exr_file.js";
import { readHdr } from "./hdr_file.js";
import { BRIGHTEST, MAX_NUMBER } from "./image_limits.js";

const EXR_MAGIC = [0x76, 0x2f, 0x31, 0x01], HDR_MAGIC = [0x23, 0x3f];

/** { rgb, width, height } with row 0 at the top, of a file's bytes; negative values are 0, infinite ones BRIGHTEST. name: for errors. */
export function readImage(buffer, name) {
  const bytes = new Uint8Array(buffer), starts = (magic) => magic.every((byte, k) => bytes[k] === byte);
  const read = starts(EXR_MAGIC) ? readExr : starts(HDR_MAGIC) ? readHdr : null;
  if (read === null) throw new NotSupported(`${name}: is ${otherFile(bytes) ?? "neither an EXR nor a Radiance HDR image"}`);
  try {
    return checked(read(bytes), name);
  } catch (error) {
    const message = error instanceof NotSupported ? error.message : `cannot read the image: ${error.message ?? error}`;
    throw new NotSupported(`${name}: ${message}`);
  }
}

function checked(image, name) {
  const { rgb } = image;
  let bad = 0, infinite = 0;
  for (let k = 0; k < rgb.length; k += 3) {
    let good = true;
    if (rgb[k] === Infinity || rgb[k + 1] === Infinity || rgb[k + 2] === Infinity) infinite++;
    for (let c = k; c < k + 3; c++) {
      if (rgb[c] === Infinity) rgb[c] = BRIGHTEST;
      good &&= Number.isFinite(rgb[c]) && rgb[c] <= MAX_NUMBER;
      if (!(rgb[c] > 0)) rgb[c] = 0;
    }
    if (!good) bad++;
  }
  if (bad) throw new NotSupported(`has ${bad} texels that are not finite numbers of at most 1e+18`);
  if (infinite) console.warn(`${name}: infinite radiance in ${infinite} texels is cut to ${BRIGHTEST}: the sun is darker`);
  return image;
}
