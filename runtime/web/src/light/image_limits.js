// How large an environment's image may be: the numbers of runtime/rna_render/scene/limits.py.
import { NotSupported } from "../package/errors.js";

const MAX_PIXELS_A_SIDE = 32768, MAX_IMAGE_PIXELS = 2 ** 27, MAX_FREE_BYTES = 2 ** 28, MAX_EXPANSION = 1024;
const BYTES_A_TEXEL = 12;
export const MAX_IMAGE_VALUES = 2 ** 29, MAX_NUMBER = 1e18;
// The largest half float: a sun above it is infinite in a file of these.
export const BRIGHTEST = 65504;

/** NotSupported if an image of that size is empty, too large, or too large for its file's bytes. */
export function checkImageSize(width, height, stored) {
  const tooLong = Math.max(width, height) > MAX_PIXELS_A_SIDE || width * height > MAX_IMAGE_PIXELS;
  if (Math.min(width, height) < 1 || tooLong) {
    throw new NotSupported(`has ${width} x ${height} pixels; from 1 to ${MAX_PIXELS_A_SIDE} a side, 2^27 in all`);
  }
  const size = width * height * BYTES_A_TEXEL;
  if (size > MAX_FREE_BYTES && size > MAX_EXPANSION * stored) {
    throw new NotSupported(`has ${width} x ${height} pixels in ${stored} bytes; an image above ${MAX_FREE_BYTES} ` +
      `bytes of radiance is at most ${MAX_EXPANSION} times its file`);
  }
}
