// Light from all directions: an equirectangular image, and distributions to draw directions from.

const LARGEST = [1024, 512];

/**
 * { values, marginal, width, height, up }: radiance with the distribution along the row as fourth number; the
 * distribution over rows, and behind it 1 / the sum of all texels' weights and the least weight; the irradiance on a
 * plane that faces +y. A texel's weight is its luminance times the sine of its row's angle from +y.
 * rgb: rows from +y down, the middle towards -z.
 */
export function environmentTables({ rgb, width, height }) {
  const image = reduced({ rgb, width, height });
  ({ rgb, width, height } = image);
  const values = new Float32Array(4 * width * height), marginal = new Float32Array(height + 2), up = [0, 0, 0];
  let total = 0;
  const least = 1e-4 * mean(rgb) + 1e-20;  // black texels may have bright colours beside them
  for (let row = 0; row < height; row++) {
    const theta = (Math.PI * (row + 0.5)) / height, solid = (2 * Math.PI ** 2 * Math.sin(theta)) / (width * height);
    let sum = 0;
    for (let column = 0; column < width; column++) {
      const at = row * width + column;
      for (let c = 0; c < 3; c++) {
        values[4 * at + c] = rgb[3 * at + c];
        up[c] += rgb[3 * at + c] * solid * Math.max(0, Math.cos(theta));
      }
      sum += Math.max(least, 0.2126 * rgb[3 * at] + 0.7152 * rgb[3 * at + 1] + 0.0722 * rgb[3 * at + 2]);
      values[4 * at + 3] = sum;
    }
    for (let column = 0; column < width; column++) values[4 * (row * width + column) + 3] /= sum;
    total += sum * Math.sin(theta);
    marginal[row] = total;
  }
  for (let row = 0; row < height; row++) marginal[row] /= total;
  marginal.set([1 / total, least], height);
  return { values, marginal, width, height, up };
}

function mean(rgb) {
  let sum = 0;
  for (let k = 0; k < rgb.length; k++) sum += rgb[k];
  return sum / rgb.length;
}

/** The image in a size that a shader searches quickly: means of blocks. */
function reduced({ rgb, width, height }) {
  const step = Math.max(1, Math.ceil(width / LARGEST[0]), Math.ceil(height / LARGEST[1]));
  if (step === 1) return { rgb, width, height };
  const w = Math.ceil(width / step), h = Math.ceil(height / step), result = new Float32Array(3 * w * h);
  for (let row = 0; row < h; row++) {
    for (let column = 0; column < w; column++) {
      let count = 0;
      for (let y = row * step; y < Math.min(height, (row + 1) * step); y++) {
        for (let x = column * step; x < Math.min(width, (column + 1) * step); x++, count++) {
          for (let c = 0; c < 3; c++) result[3 * (row * w + column) + c] += rgb[3 * (y * width + x) + c];
        }
      }
      for (let c = 0; c < 3; c++) result[3 * (row * w + column) + c] /= count;
    }
  }
  return { rgb: result, width: w, height: h };
}

/** The same radiance from everywhere. */
export function evenImage(radiance) {
  const width = 8, height = 4;
  return { rgb: Float32Array.from({ length: 3 * width * height }, (_, k) => radiance[k % 3]), width, height };
}

/** A studio: a dim room, brighter above, with a wide soft light at each side. */
export function studioImage() {
  const width = 128, height = 64, rgb = new Float32Array(3 * width * height);
  const lamps = [[[-0.7, 0.6, 0.5], 0.93, [2.4, 2.5, 2.7]], [[0.8, 0.5, -0.35], 0.95, [3.2, 3.0, 2.7]]];
  for (let row = 0; row < height; row++) {
    const theta = (Math.PI * (row + 0.5)) / height;
    for (let column = 0; column < width; column++) {
      const phi = 2 * Math.PI * ((column + 0.5) / width - 0.5);
      const d = [Math.sin(theta) * Math.sin(phi), Math.cos(theta), -Math.sin(theta) * Math.cos(phi)];
      const sky = 0.16 + 0.14 * Math.max(0, d[1]);
      for (let c = 0; c < 3; c++) {
        let value = sky * [0.95, 1.0, 1.08][c];
        for (const [at, edge, colour] of lamps) {
          const cosine = (d[0] * at[0] + d[1] * at[1] + d[2] * at[2]) / Math.hypot(...at);
          value += colour[c] * Math.min(1, Math.max(0, (cosine - edge) / 0.03));
        }
        rgb[3 * (row * width + column) + c] = value;
      }
    }
  }
  return { rgb, width, height };
}
