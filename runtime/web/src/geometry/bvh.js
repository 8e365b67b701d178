// A bounding volume hierarchy with binned surface-area heuristics, as rna_gpu/bvh.py builds it.
// Wald, On fast Construction of SAH-based Bounding Volume Hierarchies (2007).
import { records } from "../decoder/records.js";

const { words: NODE_WORDS, members: NODE } = records.RnaNode;
const BINS = 16;
const LEAF = 4;          // primitives
const STEP = 256;        // primitives of a set that takes a step
const HALVED_FROM = 24;  // levels; from here on sets are halved, which ends below the stack of shaders

/**
 * { nodes, order }: nodes: words of RnaNode. order: numbers of the primitives in the order of the leaves.
 * boxes: six numbers a primitive, min and max. at: place of the root among all nodes. before: primitives of other
 * hierarchies. It yields between steps.
 */
export function* buildHierarchy(boxes, at = 0, before = 0) {
  const count = boxes.length / 6, order = Uint32Array.from({ length: count }, (_, k) => k);
  const centres = new Float32Array(3 * count);
  for (let k = 0; k < count; k++) {
    for (let axis = 0; axis < 3; axis++) centres[3 * k + axis] = 0.5 * (boxes[6 * k + axis] + boxes[6 * k + 3 + axis]);
  }
  const floats = new Float32Array(2 * NODE_WORDS * count), words = new Uint32Array(floats.buffer), arrays = { boxes, centres, order };
  const stack = [[0, count, 0, -1]];  // first, end, level, parent of a right child
  let used = 0;
  while (stack.length) {
    const [first, end, level, parent] = stack.pop(), node = NODE_WORDS * used;
    used += 1;
    if (parent >= 0) words[parent + NODE.child.at] = at + used - 1;
    if (end - first > STEP) yield;
    boundsOf(arrays, first, end);
    for (let k = 0; k < 3; k++) {
      floats[node + NODE.low.at + k] = box[k];
      floats[node + NODE.high.at + k] = box[3 + k];
    }
    if (end - first <= LEAF) {
      words[node + NODE.child.at] = before + first;
      words[node + NODE.count.at] = end - first;
      continue;
    }
    let best = { cost: Infinity };
    for (let axis = 0; axis < 3 && level < HALVED_FROM; axis++) {
      const other = bestCut(arrays, first, end, axis);
      if (other.cost < best.cost) best = other;
      if (end - first > STEP) yield;
    }
    let middle = best.cost < Infinity ? split(arrays, first, end, best) : first;
    if (!(first < middle && middle < end)) middle = halve(arrays, first, end);
    stack.push([middle, end, level + 1, node], [first, middle, level + 1, -1]);
  }
  return { nodes: words.slice(0, NODE_WORDS * used), order: order.map((k) => before + k) };
}

/** Makes the box at `to` of `target` hold the one at `from` of `boxes` too. */
function grow(target, to, boxes, from) {
  for (let k = 0; k < 3; k++) {
    const low = boxes[from + k], high = boxes[from + 3 + k];
    if (low < target[to + k]) target[to + k] = low;
    if (high > target[to + 3 + k]) target[to + 3 + k] = high;
  }
}

function clear(boxes) {
  for (let at = 0; at < boxes.length; at += 6) {
    for (let k = 0; k < 3; k++) {
      boxes[at + k] = Infinity;
      boxes[at + 3 + k] = -Infinity;
    }
  }
  return boxes;
}

// Made once, since new arrays for each set would take most of the time; nobody else has a turn while they are in use.
const box = new Float32Array(6), bins = new Float32Array(6 * BINS), counts = new Uint32Array(BINS);
const left = new Float64Array(BINS), right = new Float64Array(BINS);

function boundsOf({ boxes, order }, first, end) {
  clear(box);
  for (let k = first; k < end; k++) grow(box, 0, boxes, 6 * order[k]);
}

/** [low, high] of the centres along an axis. */
function spanOf({ centres, order }, first, end, axis) {
  let low = Infinity, high = -Infinity;
  for (let k = first; k < end; k++) {
    const value = centres[3 * order[k] + axis];
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

const binOf = (value, low, high) => Math.min(Math.floor(((value - low) / (high - low)) * BINS), BINS - 1);

/** The cheapest cut between bins along an axis: its cost, infinite for none, and the first bin behind it. */
function bestCut(arrays, first, end, axis) {
  const { boxes, centres, order } = arrays, [low, high] = spanOf(arrays, first, end, axis);
  if (!(high > low)) return { cost: Infinity };
  clear(bins);
  counts.fill(0);
  for (let k = first; k < end; k++) {
    const bin = binOf(centres[3 * order[k] + axis], low, high);
    counts[bin] += 1;
    grow(bins, 6 * bin, boxes, 6 * order[k]);
  }
  sideCosts(right, BINS - 1, -1);
  sideCosts(left, 0, 1);
  let cost = Infinity, cut = 0;
  for (let bin = 1; bin < BINS; bin++) {
    if (left[bin - 1] + right[bin] < cost) {
      cost = left[bin - 1] + right[bin];
      cut = bin;
    }
  }
  return { cost, cut, axis, low, high };
}

/** Half the area of the box of the bins from `from` up to each, times their primitives. */
function sideCosts(costs, from, step) {
  clear(box);
  for (let bin = from, count = 0; bin >= 0 && bin < BINS; bin += step) {
    grow(box, 0, bins, 6 * bin);
    count += counts[bin];
    const x = box[3] - box[0], y = box[4] - box[1], z = box[5] - box[2];
    costs[bin] = count ? (x * y + y * z + z * x) * count : Infinity;
  }
}

/** Sorts the set by a cut; the first of the right half. */
function split({ centres, order }, first, end, { axis, cut, low, high }) {
  let middle = first, last = end - 1;
  while (middle <= last) {
    const number = order[middle];
    if (binOf(centres[3 * number + axis], low, high) < cut) middle++;
    else {
      order[middle] = order[last];
      order[last--] = number;
    }
  }
  return middle;
}

/** Halves the set at the median of its widest axis. */
function halve(arrays, first, end) {
  const { centres, order } = arrays, widths = [0, 1, 2].map((axis) => {
    const [low, high] = spanOf(arrays, first, end, axis);
    return high - low;
  });
  const axis = widths.indexOf(Math.max(...widths));
  order.subarray(first, end).sort((a, b) => centres[3 * a + axis] - centres[3 * b + axis]);
  return Math.floor((first + end) / 2);
}
