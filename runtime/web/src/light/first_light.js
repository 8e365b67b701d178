// An environment for a first look: its brightest places as a few lights, and the rest prefiltered for lobes.
import { finished } from "../steps.js";
import { dot } from "../vectors.js";
import { prefilter } from "./prefilter.js";

const CELLS = [64, 128];     // rows of equal height, and cells around: equal solid angles
const GRID = [64, 128];      // rows of equal angle, for the prefilter
const LEAST_WIDTH = 512;     // of an image, so that there is a texel in each cell
const MUCH = 4;              // times the mean cell: what is above is an excess
const LIGHTS = 8;
const NEARNESS = Math.cos((15 * Math.PI) / 180);
const CANDIDATES = 200;      // the brightest cells, among which a cluster's middle is looked for
const CELL_COUNT = CELLS[0] * CELLS[1];

/**
 * { lights, up, rest }: { direction, colour } of the lights, colour being the irradiance on a plane that faces the light;
 * irradiance of the rest on a plane that faces +y; the rest, prefiltered. image: as environmentTables takes it. In steps.
 */
export const firstLight = (image) => finished(stepsOf(image));

function* stepsOf(image) {
  const fine = enlarged(image), texels = texelsOf(fine);
  yield;
  const { flux, sums, directions } = cellsOf(fine.rgb, texels);
  yield;
  const { excess, share } = excessOf(flux), clusters = clustersOf(excess), taken = new Uint8Array(CELL_COUNT);
  for (const cells of clusters) for (const cell of cells) taken[cell] = 1;
  yield;
  const { radiance, up } = restOf(fine.rgb, texels, (cell) => (taken[cell] ? 1 - share[cell] : 1));
  return { lights: clusters.map((cells) => lightOf(cells, excess, (k) => sums[k] * share[Math.floor(k / 3)], directions)), up, rest: yield* prefilter(radiance, GRID) };
}

/** Small images in a size that has texels in all cells, bilinear as they are looked up. */
function enlarged({ rgb, width, height }) {
  const by = Math.ceil(LEAST_WIDTH / width);
  if (by <= 1) return { rgb, width, height };
  const wide = by * width, high = by * height, result = new Float32Array(3 * wide * high);
  for (let row = 0; row < high; row++) {
    const y = (row + 0.5) / by - 0.5, upper = Math.floor(y), b = y - upper;
    const rows = [Math.max(upper, 0), Math.min(upper + 1, height - 1)];
    for (let column = 0; column < wide; column++) {
      const x = (column + 0.5) / by - 0.5, left = Math.floor(x), a = x - left;
      const columns = [(left + width) % width, (left + 1) % width];
      for (let c = 0; c < 3; c++) {
        const at = (j, k) => rgb[3 * (rows[j] * width + columns[k]) + c];
        const above = at(0, 0) + a * (at(0, 1) - at(0, 0)), below = at(1, 0) + a * (at(1, 1) - at(1, 0));
        result[3 * (row * wide + column) + c] = above + b * (below - above);
      }
    }
  }
  return { rgb: result, width: wide, height: high };
}

/** { width, height, solid, cells }: of each row the solid angle of a texel, and the row of cells that it is in. */
function texelsOf({ width, height }) {
  const solid = new Float64Array(height), rows = new Int32Array(height);
  for (let row = 0; row < height; row++) {
    const theta = (Math.PI * (row + 0.5)) / height;
    solid[row] = ((2 * Math.PI) / width) * (Math.cos((Math.PI * row) / height) - Math.cos((Math.PI * (row + 1)) / height));
    rows[row] = Math.min(CELLS[0] - 1, Math.floor(((1 - Math.cos(theta)) / 2) * CELLS[0]));
  }
  return { width, height, solid, rows };
}

const cellOf = ({ rows, width }, row, column) => rows[row] * CELLS[1] + Math.floor((column / width) * CELLS[1]);

/**
 * { flux, sums, directions }: mean radiance of each cell times its solid angle, RGB; that of the texels which are in it; the
 * mean direction of their light, of any length.
 */
function cellsOf(rgb, texels) {
  const sums = new Float64Array(3 * CELL_COUNT), solids = new Float64Array(CELL_COUNT), directions = new Float64Array(3 * CELL_COUNT);
  for (let row = 0, at = 0; row < texels.height; row++) {
    const theta = (Math.PI * (row + 0.5)) / texels.height, solid = texels.solid[row];
    const sine = Math.sin(theta), cosine = Math.cos(theta);
    for (let column = 0; column < texels.width; column++, at += 3) {
      const cell = cellOf(texels, row, column), phi = (2 * Math.PI * (column + 0.5)) / texels.width - Math.PI;
      solids[cell] += solid;
      for (let c = 0; c < 3; c++) sums[3 * cell + c] += rgb[at + c] * solid;
      const light = mean(rgb, at / 3) * solid;
      directions[3 * cell] += light * sine * Math.sin(phi);
      directions[3 * cell + 1] += light * cosine;
      directions[3 * cell + 2] -= light * sine * Math.cos(phi);
    }
  }
  const flux = sums.map((sum, k) => (sum / solids[Math.floor(k / 3)]) * ((4 * Math.PI) / CELL_COUNT));
  return { flux, sums, directions };
}

const mean = (values, k) => (values[3 * k] + values[3 * k + 1] + values[3 * k + 2]) / 3;

/** Of each cell the flux far above the mean, RGB, and its share. */
function excessOf(flux) {
  const most = (MUCH * flux.reduce((a, b) => a + b, 0)) / flux.length;
  const share = Float64Array.from({ length: CELL_COUNT }, (_, k) => Math.max(0, 1 - most / Math.max(mean(flux, k), 1e-30)));
  return { share, excess: flux.map((value, k) => value * share[Math.floor(k / 3)]) };
}

/** The middle of a cell; columns from -z on, as in images. */
function directionOf(cell) {
  const y = 1 - (2 * (Math.floor(cell / CELLS[1]) + 0.5)) / CELLS[0], r = Math.sqrt(1 - y * y);
  const phi = (2 * Math.PI * ((cell % CELLS[1]) + 0.5)) / CELLS[1] - Math.PI;
  return [r * Math.sin(phi), y, -r * Math.cos(phi)];
}

/** The mean direction of cells by their flux: its length, the flux; unit, where it points. */
function middleOf(cells, excess) {
  const sum = [0, 0, 0];
  let flux = 0;
  for (const cell of cells) {
    const light = mean(excess, cell);
    flux += light;
    directionOf(cell).forEach((value, k) => { sum[k] += light * value; });
  }
  const size = Math.hypot(...sum) || 1;
  return { flux, size, direction: sum.map((value) => value / size) };
}

/** Lists of cells: about the brightest places, then split until there are LIGHTS. */
function clustersOf(excess) {
  let left = [];
  for (let k = 0; k < CELL_COUNT; k++) if (mean(excess, k) > 0) left.push(k);
  left.sort((a, b) => mean(excess, b) - mean(excess, a));
  const clusters = [];
  const near = (direction) => left.filter((cell) => dot(directionOf(cell), direction) > NEARNESS);
  while (left.length && clusters.length < LIGHTS) {
    const all = left.slice(0, CANDIDATES).map((cell) => middleOf(near(directionOf(cell)), excess));
    const best = all.reduce((a, b) => (b.flux > a.flux ? b : a)), members = new Set(near(best.direction));
    clusters.push([...members]);
    left = left.filter((cell) => !members.has(cell));
  }
  while (clusters.length && clusters.length < LIGHTS) if (!splitWidest(clusters, excess)) break;
  return clusters;
}

/** Halves the cluster with the largest flux times spread across its longest axis; false where there is none to halve. */
function splitWidest(clusters, excess) {
  const spread = (cells) => {
    const { flux, size } = middleOf(cells, excess);
    return flux - size;
  };
  const widest = clusters.reduce((a, b) => (spread(b) > spread(a) ? b : a)), { direction } = middleOf(widest, excess);
  const along = longestAxis(widest, excess, direction), places = widest.map((cell) => dot(directionOf(cell), along));
  let middle = 0, flux = 0;
  widest.forEach((cell, k) => {
    middle += mean(excess, cell) * places[k];
    flux += mean(excess, cell);
  });
  const [above, below] = [true, false].map((side) => widest.filter((_, k) => places[k] * flux > middle === side));
  if (!above.length || !below.length) return false;
  clusters.splice(clusters.indexOf(widest), 1, above, below);
  return true;
}

/** The direction along which the cells vary most about the middle, by powers of their covariance. */
function longestAxis(cells, excess, middle) {
  const covariance = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (const cell of cells) {
    const d = directionOf(cell).map((value, k) => value - middle[k]), light = mean(excess, cell);
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) covariance[i][j] += light * d[i] * d[j];
  }
  let axis = [0.6, 0.5, 0.62];
  for (let step = 0; step < 60; step++) {
    const next = covariance.map((row) => dot(row, axis)), size = Math.hypot(...next);
    if (!size) break;
    axis = next.map((value) => value / size);
  }
  return axis;
}

/** caught: of a number of the cells, its part of the light. */
function lightOf(cells, excess, caught, directions) {
  const colour = [0, 1, 2].map((c) => cells.reduce((sum, cell) => sum + caught(3 * cell + c), 0)), sum = [0, 0, 0];
  for (const cell of cells) {
    const d = directions.subarray(3 * cell, 3 * cell + 3), weight = mean(excess, cell) / Math.hypot(...d);
    d.forEach((value, k) => { sum[k] += weight * value; });
  }
  const size = Math.hypot(...sum);
  return { direction: sum.map((value) => value / size), colour };
}

/** { radiance, up }: mean radiance in the cells of the GRID, and irradiance on a plane that faces +y. share: of a cell that stays in it. */
function restOf(rgb, texels, share) {
  const [rows, columns] = GRID, sums = new Float64Array(3 * rows * columns), solids = new Float64Array(rows * columns), up = [0, 0, 0];
  for (let row = 0, at = 0; row < texels.height; row++) {
    const height = Math.max(0, Math.cos((Math.PI * (row + 0.5)) / texels.height)), solid = texels.solid[row];
    for (let column = 0; column < texels.width; column++, at += 3) {
      const place = Math.floor((row / texels.height) * rows) * columns + Math.floor((column / texels.width) * columns);
      const weight = solid * share(cellOf(texels, row, column));
      solids[place] += solid;
      for (let c = 0; c < 3; c++) {
        sums[3 * place + c] += weight * rgb[at + c];
        up[c] += weight * height * rgb[at + c];
      }
    }
  }
  return { radiance: sums.map((sum, k) => sum / solids[Math.floor(k / 3)]), up };
}
