// The output contract (spec, 6.1): of any finite queries a decoder's results are finite and not negative.
import { fail } from "./errors.js";

const PROBES = [0, 1, -1, 1e4, -1e4, 3.4028234663852886e38, -3.4e38], RANDOM_ROWS = 5;
const LARGEST = 3.4028234663852886e38;

/** Fails where a query of one of the numbers, or of random ones from -1 to 1, has another result. */
export function checkResults(decoder, where) {
  let random = 1;
  const draw = () => (random = (Math.imul(random, 1664525) + 1013904223) | 0) / 2 ** 31;
  for (let k = 0; k < PROBES.length + RANDOM_ROWS; k++) {
    const query = Float32Array.from({ length: decoder.columns }, () => PROBES[k] ?? draw());
    const wrong = run(decoder, query).find((value) => !(value >= 0 && value <= LARGEST));
    if (wrong !== undefined) {
      fail("DECODER_RESULT", where, `a query of ${PROBES[k] ?? "random"} numbers gives ${wrong}, expected finite results, not negative`);
    }
  }
}

function run({ low, high, gain, offset, layers, top, unit, matrix, outputs }, query) {
  const clipped = query.map((value) => Math.min(Math.max(value, low), high));
  let values = gain ? clipped.map((value, k) => value * gain[k] + offset[k]) : clipped;
  for (const layer of layers) values = runLayer(layer, values);
  const colours = values.map((value) => (Math.exp(Math.min(Math.max(value, 0), top)) - 1) * unit);
  return matrix ? product(colours, matrix, outputs) : colours;
}

function runLayer({ weight, bias, columns, step, scales, relu }, values) {
  const inputs = scales ? values.map((value) => (value / step > 0 ? rounded(Math.min(value / step, 255)) : 0)) : values;
  return product(inputs, weight, columns).map((sum, k) => {
    const value = scales ? (sum + bias[k]) * step * scales[k] : sum + bias[k];
    return relu ? Math.max(value, 0) : value;
  });
}

/** To the nearest whole number, halves to the even one. */
const rounded = (value) => value + 1.5 * 2 ** 52 - 1.5 * 2 ** 52;

/** A row times a matrix of so many columns, (columns,) float32. */
function product(row, matrix, columns) {
  const sums = new Float64Array(columns);
  row.forEach((value, k) => {
    if (value !== 0) for (let j = 0, at = k * columns; j < columns; j++, at++) sums[j] += value * matrix[at];
  });
  return Float32Array.from(sums);
}
