// Light from all directions: an equirectangular image, and distributions to draw directions from.

const LARGEST = [1024, 512];

/**
 * { floats, places, total, width, height, up }: what rna_gpu/wgsl/render/environment.wgsl reads of an image: texels,
 * heights of rows of cells, running sums of the rows and of each row's cells, one behind the other from `places` on; the
 * sum of all; the irradiance on a plane that faces +y. rgb: rows from +y down, the middle towards -z.
 */
export function environmentTables(image) {
  const { rgb, width, height } = reduced(image);
  const places = [0, rgb.length, rgb.length + height + 1, rgb.length + 2 * height + 3];
  const floats = new Float32Array(places[3] + (height + 1) * (width + 1));
  floats.set(rgb);
  const edge = (row) => Math.cos(Math.PI * Math.min(1, Math.max(0, (row - 0.5) / height)));
  let total = 0;
  for (let row = 0; row <= height; row++) {
    const size = edge(row) - edge(row + 1), upper = width * Math.max(row - 1, 0), lower = width * Math.min(row, height - 1);
    floats[places[1] + row] = size;
    let sum = 0;
    for (let column = 0; column < width; column++) {
      const right = (column + 1) % width;
      const cell = [upper + column, upper + right, lower + column, lower + right].reduce((all, at) => all + luminance(rgb, at), 0);
      sum += (cell / 4) * size;
      floats[places[3] + row * (width + 1) + column + 1] = sum;
    }
    total += sum;
    floats[places[2] + row + 1] = total;
  }
  return { floats, places, total, width, height, up: irradiance(rgb, width, height) };
}

const luminance = (rgb, at) => 0.2126 * rgb[3 * at] + 0.7152 * rgb[3 * at + 1] + 0.0722 * rgb[3 * at + 2];

/** On a plane that faces +y. */
function irradiance(rgb, width, height) {
  const up = [0, 0, 0];
  for (let row = 0; row < height; row++) {
    const theta = (Math.PI * (row + 0.5)) / height;
    const factor = ((2 * Math.PI ** 2 * Math.sin(theta)) / (width * height)) * Math.max(0, Math.cos(theta));
    for (let k = 0; k < 3 * width; k++) up[k % 3] += rgb[3 * width * row + k] * factor;
  }
  return up;
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

/** Equal radiance from everywhere. */
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
