// Means of an environment under von Mises-Fisher distributions, by their concentration kappa.

export const LEAST_KAPPA = 0.25, LEVELS_AN_OCTAVE = 2;
const LEVELS = 19;      // up to kappa 128
const NEGLIGIBLE = 1e-6;

/**
 * { texels, width, height, levels, unit }: float16 RGBA of the levels, one behind the other, in multiples of `unit`. The first
 * row is the pole +y and the last -y; columns are those of the radiance. radiance: of cells [rows, columns] of equal angle, RGB.
 * It yields between steps.
 */
export function* prefilter(radiance, [rows, width]) {
  const height = rows + 1, unit = radiance.reduce((a, b) => a + b, 0) / radiance.length || 1;
  const spectrum = yield* spectrumOf(radiance, rows, width, unit), texels = new Uint16Array(4 * width * height * LEVELS);
  for (let level = 0; level < LEVELS; level++) {
    const kappa = LEAST_KAPPA * 2 ** (level / LEVELS_AN_OCTAVE);
    for (let row = 0; row < height; row++) {
      const sums = meanSpectrum(spectrum, (Math.PI * row) / rows, rows, width / 2, kappa);
      writeRow(texels, 4 * width * (level * height + row), sums, width);
      yield;
    }
  }
  return { texels, width, height, levels: LEVELS, unit };
}

const cosines = (width) => Float64Array.from({ length: width }, (_, k) => Math.cos((2 * Math.PI * k) / width));

/** Of a whole row. */
const solidAngle = (row, rows) => 2 * Math.PI * (Math.cos((Math.PI * row) / rows) - Math.cos((Math.PI * (row + 1)) / rows));

/** Of each row the flux by waves around: [row][wave][cosine, sine][RGB]. */
function* spectrumOf(radiance, rows, width, unit) {
  const waves = width / 2, result = new Float64Array(6 * rows * waves), turns = cosines(width);
  for (let row = 0; row < rows; row++) {
    yield;
    const solid = solidAngle(row, rows) / width;
    for (let wave = 0; wave < waves; wave++) {
      for (let column = 0; column < width; column++) {
        const turn = wave * column, at = 6 * (row * waves + wave), from = 3 * (row * width + column);
        const cosine = (solid / unit) * turns[turn % width], sine = (solid / unit) * turns[(turn + 0.75 * width) % width];
        for (let c = 0; c < 3; c++) {
          result[at + c] += radiance[from + c] * cosine;
          result[at + 3 + c] += radiance[from + c] * sine;
        }
      }
    }
  }
  return result;
}

/**
 * The same of the mean at polar angle theta. The density at a difference of angles around is exp(z cos) times a factor, whose
 * waves are modified Bessel functions of z (Abramowitz and Stegun 9.6.34). The weights of all rows are made 1 together.
 */
function meanSpectrum(spectrum, theta, rows, waves, kappa) {
  const sums = new Float64Array(6 * waves), bessel = new Float64Array(waves);
  let total = 0;
  for (let row = 0; row < rows; row++) {
    const other = (Math.PI * (row + 0.5)) / rows, factor = Math.exp(kappa * (Math.cos(theta - other) - 1));
    if (factor < NEGLIGIBLE) continue;
    scaledBessel(kappa * Math.sin(theta) * Math.sin(other), bessel);
    total += factor * bessel[0] * solidAngle(row, rows);
    for (let wave = 0; wave < waves && bessel[wave] > NEGLIGIBLE; wave++) {
      const weight = factor * bessel[wave] * (wave ? 2 : 1), from = 6 * (waves * row + wave), to = 6 * wave;
      for (let k = 0; k < 6; k++) sums[to + k] += weight * spectrum[from + k];
    }
  }
  return sums.map((sum) => sum / total);
}

/** exp(-z) I_m(z) for all m: ratios from the last one down, in which nothing overflows; with those of -m the sum is 1. */
function scaledBessel(z, result) {
  const last = Math.min(result.length - 1, Math.ceil(8 + 6 * Math.sqrt(z)));
  let ratio = 0;
  for (let m = last + 8; m > 0; m--) {
    ratio = z / (2 * m + z * ratio);
    if (m <= last) result[m] = ratio;
  }
  let product = 1, sum = 1;
  for (let m = 1; m <= last; m++) {
    product *= result[m];
    result[m] = product;
    sum += 2 * product;
  }
  result[0] = 1;
  for (let m = 0; m <= last; m++) result[m] /= sum;
  result.fill(0, last + 1);
}

/** A row of texels from its waves. */
function writeRow(texels, start, sums, width) {
  const turns = cosines(width);
  let waves = width / 2;
  while (waves > 1 && sums.subarray(6 * waves - 6, 6 * waves).every((value) => Math.abs(value) < NEGLIGIBLE)) waves -= 1;
  for (let column = 0; column < width; column++) {
    let r = 0, g = 0, b = 0;
    for (let wave = 0, turn = 0, k = 0; wave < waves; wave++, turn = (turn + column) % width, k += 6) {
      const cosine = turns[turn], sine = turns[(turn + 0.75 * width) % width];
      r += sums[k] * cosine + sums[k + 3] * sine;
      g += sums[k + 1] * cosine + sums[k + 4] * sine;
      b += sums[k + 2] * cosine + sums[k + 5] * sine;
    }
    [r, g, b].forEach((value, c) => { texels[start + 4 * column + c] = half(value); });
  }
}

const number = new Float32Array(1), word = new Uint32Array(number.buffer);

/** A number that is not negative as float16, rounded; those that would be subnormal are 0. */
function half(value) {
  number[0] = Math.max(value, 0);
  return Math.max(0, Math.min(0x7bff, ((word[0] + 0x1000) >>> 13) - 0x1c000));
}
