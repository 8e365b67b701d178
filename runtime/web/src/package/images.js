// Images of base colour (spec, 4.6): decoded by the browser as they are stored, and their levels.
import { inSteps } from "../steps.js";
import { fail, NotSupported } from "./errors.js";

const WIDEST = 8192;
const STARTS = [[0x89, 0x50, 0x4e, 0x47], [0xff, 0xd8, 0xff], [0x52, 0x49, 0x46, 0x46]];  // PNG, JPEG, RIFF
const AS_STORED = { colorSpaceConversion: "none", premultiplyAlpha: "none" };

/** { pixels, width, height } of an entry: RGBA, a byte each, the upper row first. */
export async function readImage(bytes, where) {
  const isKnown = STARTS.some((start) => start.every((byte, k) => bytes[k] === byte));
  const wrong = (found) => fail("BASE_COLOR_IMAGE", where, `found ${found}, expected a PNG, JPEG or WebP of 1 to ${WIDEST} pixels a side`);
  if (!isKnown) wrong("another file");
  const sides = sidesOf(bytes);  // before any memory is taken
  if (!sides) wrong("a file without a size, or in inks");
  if (!sides.every((side) => side >= 1 && side <= WIDEST)) wrong(`${sides.join(" x ")} pixels`);
  needBrowser(where);
  const bitmap = await createImageBitmap(new Blob([withoutOrientation(bytes)]), AS_STORED).catch(() => wrong("what cannot be decoded"));
  return pixelsOf(bitmap);
}

function needBrowser(what) {
  if (!globalThis.createImageBitmap) throw new NotSupported(`${what}: expected a browser, which decodes images; there is no createImageBitmap here`);
}

/** [width, height] by the file's header; null where it has none, or is of a JPEG in inks. */
function sidesOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  try {
    if (bytes[0] === 0x89) return [view.getUint32(16), view.getUint32(20)];
    if (bytes[0] === 0x52) return sidesOfWebp(view);
    for (let at = 2; ; at += 2 + view.getUint16(at + 2)) {
      const marker = view.getUint16(at);
      if (marker < 0xffc0 || marker === 0xffda) return null;
      if (marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker)) {
        const isGreyOrColour = [1, 3].includes(view.getUint8(at + 9));  // not of four inks
        return isGreyOrColour ? [view.getUint16(at + 7), view.getUint16(at + 5)] : null;
      }
    }
  } catch {
    return null;  // it ends before
  }
}

/** By its first chunk: with all features, lossless or lossy. */
function sidesOfWebp(view) {
  const side = (at) => 1 + view.getUint16(at, true) + 65536 * view.getUint8(at + 2);
  const kind = String.fromCharCode(...[12, 13, 14, 15].map((at) => view.getUint8(at)));
  if (kind === "VP8X") return [side(24), side(27)];
  if (kind === "VP8 ") return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
  if (kind !== "VP8L") return null;
  const bits = view.getUint32(21, true);
  return [1 + (bits & 0x3fff), 1 + ((bits >>> 14) & 0x3fff)];
}

/** The same of a picture of the page's: a Blob, ImageBitmap, canvas, or element of an image. */
export async function pictureOf(source) {
  needBrowser("an image");
  const bitmap = source instanceof ImageBitmap ? source : await createImageBitmap(source, AS_STORED);
  if (Math.max(bitmap.width, bitmap.height) > WIDEST) throw new Error(`an image of ${bitmap.width} x ${bitmap.height} pixels; at most ${WIDEST} a side`);
  return pixelsOf(bitmap);
}

/** JPEG without APP1, PNG without eXIf, by which browsers turn images. */
function withoutOrientation(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length), isJpeg = bytes[0] === 0xff;
  if (bytes[0] === 0x52) return bytes;
  const pieces = [bytes.subarray(0, isJpeg ? 2 : 8)];
  let at = pieces[0].length;
  while (at + 12 <= bytes.length) {
    const name = view.getUint32(at + (isJpeg ? 0 : 4)), marker = name >>> 16;
    if (isJpeg && (marker < 0xffc0 || marker === 0xffda)) break;  // the picture
    const end = at + (isJpeg ? 2 + view.getUint16(at + 2) : 12 + view.getUint32(at));
    if (!(isJpeg ? marker === 0xffe1 : name === 0x65584966)) pieces.push(bytes.subarray(at, end));
    at = end;
  }
  return new Blob([...pieces, bytes.subarray(at)]);
}

/** WebGL hands on the colours of pixels whose alpha is 0, as a 2D canvas does not. */
function pixelsOf(bitmap) {
  const { width, height } = bitmap, gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  const pixels = new Uint8Array(4 * width * height);
  if (!gl) return { pixels: drawn(bitmap), width, height };
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const failed = gl.getError();  // as of a picture that is larger than its textures
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return { pixels: failed ? drawn(bitmap) : pixels, width, height };
}

function drawn(bitmap) {
  const { width, height } = bitmap, context = new OffscreenCanvas(width, height).getContext("2d");
  context.drawImage(bitmap, 0, 0);
  return new Uint8Array(context.getImageData(0, 0, width, height).data.buffer);
}

const VALUES = Array.from({ length: 256 }, (_, k) => k / 255);
/** (256,) linear value of each value of 8 bits. */
const LINEAR = {
  linear: Float32Array.from(VALUES),
  srgb: Float32Array.from(VALUES, (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)),
};

/** In steps, the levels of { pixels, width, height }, one behind the other: Uint32Array, a word a texel, of three bytes. */
export function* levelsOf({ pixels, width, height }, colorSpace = "srgb") {
  const linear = LINEAR[colorSpace], encode = encoder(linear);
  const sizes = [[width, height]];
  while (Math.max(...sizes.at(-1)) > 1) sizes.push(sizes.at(-1).map((side) => Math.max(1, side >> 1)));
  const words = new Uint32Array(sizes.reduce((sum, [w, h]) => sum + w * h, 0));
  words.set(new Uint32Array(pixels.buffer, pixels.byteOffset, width * height));
  let level = null, at = width * height;
  for (let k = 1; k < sizes.length; k++) {
    const from = sizes[k - 1], to = sizes[k];
    const valueOf = k === 1 ? (texel, c) => linear[pixels[4 * texel + c]] : (texel, c) => level[3 * texel + c];
    const next = yield* halved(valueOf, from, to);
    for (let texel = 0; texel < to[0] * to[1]; texel++) {
      words[at + texel] = encode(next[3 * texel]) | (encode(next[3 * texel + 1]) << 8) | (encode(next[3 * texel + 2]) << 16);
    }
    at += to[0] * to[1];
    level = next;
  }
  return words;
}

/** Means over equal intervals of texels along both sides; those that lie in one in part count in part. */
function* halved(valueOf, [width, height], [columns, rows]) {
  const along = intervals(width, columns), down = intervals(height, rows), result = new Float32Array(3 * columns * rows);
  yield* inSteps(0, columns * rows, (from, end) => {
    for (let texel = from; texel < end; texel++) {
      const u = along[texel % columns], v = down[Math.floor(texel / columns)];
      for (let c = 0; c < 3; c++) {
        let sum = 0;
        for (let j = 0; j < v.shares.length; j++) {
          for (let i = 0; i < u.shares.length; i++) {
            sum += u.shares[i] * v.shares[j] * valueOf((v.first + j) * width + u.first + i, c);
          }
        }
        result[3 * texel + c] = sum;
      }
    }
  });
  return result;
}

/** Of each of `parts` intervals of `size` texels: its first texel, and the shares of that and those behind it. */
function intervals(size, parts) {
  return Array.from({ length: parts }, (_, k) => {
    const low = (k * size) / parts, high = ((k + 1) * size) / parts, first = Math.floor(low);
    const shares = Array.from({ length: Math.min(size, Math.ceil(high)) - first }, (_, i) =>
      ((Math.min(high, first + i + 1) - Math.max(low, first + i)) * parts) / size);
    return { first, shares };
  });
}

const GUESSES = 4096;

/** The value of 8 bits whose linear value is the nearest. */
function encoder(linear) {
  const edges = linear.subarray(1).map((value, k) => (value + linear[k]) / 2), guesses = new Uint8Array(GUESSES + 1);
  for (let k = 0, value = 0; k <= GUESSES; k++) {
    while (value < 255 && edges[value] < k / GUESSES) value++;
    guesses[k] = value;
  }
  return (value) => {
    let level = guesses[Math.floor(value * GUESSES)];
    while (level < 255 && edges[level] < value) level++;
    return level;
  };
}
