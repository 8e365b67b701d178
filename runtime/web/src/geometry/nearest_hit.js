// The nearest place of an asset that a ray meets, through its hierarchy: see sceneArrays. Holes count as surface.
import { constants, records } from "../decoder/records.js";
import { cross, dot, minus, plus, times, unit } from "../vectors.js";

const { RNA_IS_SEGMENT } = constants;
const { words: NODE_WORDS, members: NODE } = records.RnaNode, { words: PRIMITIVE_WORDS, members: PRIMITIVE } = records.RnaPrimitive;
const ROOT = 1;  // behind the node of the only instance

/** { distance, position, normal } of the nearest hit; null if there is none. The direction has length 1; the normal faces the ray. */
export function nearestHit({ nodes, primitives, points }, origin, direction) {
  const floats = new Float32Array(nodes.buffer, nodes.byteOffset, nodes.length), stack = [ROOT];
  let best = null;
  while (stack.length) {
    const node = stack.pop(), at = NODE_WORDS * node, child = nodes[at + NODE.child.at], count = nodes[at + NODE.count.at];
    if (!meetsBox(floats, at, origin, direction, best?.distance ?? Infinity)) continue;
    if (!count) stack.push(child, node + 1);
    for (let k = 0; k < count; k++) {
      const record = primitives.subarray(PRIMITIVE_WORDS * (child + k)), isSegment = record[PRIMITIVE.tag.at] & RNA_IS_SEGMENT;
      const hit = (isSegment ? hitSegment : hitTriangle)(record, points, origin, direction);
      if (hit && hit.distance < (best?.distance ?? Infinity)) best = hit;
    }
  }
  if (!best) return null;
  const facing = dot(best.normal, direction) > 0 ? -1 : 1;
  return { distance: best.distance, position: plus(origin, direction, best.distance), normal: times(unit(best.normal), facing) };
}

function meetsBox(floats, at, origin, direction, most) {
  let near = 0, far = most;
  for (let axis = 0; axis < 3; axis++) {
    const low = floats[at + NODE.low.at + axis] - origin[axis], high = floats[at + NODE.high.at + axis] - origin[axis];
    if (direction[axis] === 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const a = low / direction[axis], b = high / direction[axis];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far;
}

const pointAt = (points, k) => [points[4 * k], points[4 * k + 1], points[4 * k + 2]];

/** Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997). */
function hitTriangle(record, points, origin, direction) {
  const [a, b, c] = ["a", "b", "c"].map((name) => pointAt(points, record[PRIMITIVE[name].at]));
  const ab = minus(b, a), ac = minus(c, a), p = cross(direction, ac), size = dot(ab, p);
  if (size === 0) return null;
  const from = minus(origin, a), q = cross(from, ab), u = dot(from, p) / size, v = dot(direction, q) / size, distance = dot(ac, q) / size;
  return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 ? { distance, normal: cross(ab, ac) } : null;
}

/** A strand's segment as a cylinder about the place of its middle that is nearest to the ray. */
function hitSegment(record, points, origin, direction) {
  const first = record[PRIMITIVE.a.at], start = pointAt(points, first), axis = minus(pointAt(points, first + 1), start), from = minus(origin, start);
  const length = dot(axis, axis), slope = dot(axis, direction), slant = length - slope * slope;
  const reached = slant > 0 ? (dot(from, axis) - slope * dot(from, direction)) / slant : 0, t = Math.min(1, Math.max(0, reached));
  const middle = plus(start, axis, t), nearest = dot(minus(middle, origin), direction), away = minus(plus(origin, direction, nearest), middle);
  const radius = points[4 * first + 3] + t * (points[4 * first + 7] - points[4 * first + 3]), rest = radius * radius - dot(away, away);
  if (rest < 0) return null;
  const distance = nearest - Math.sqrt(rest);
  return distance > 0 ? { distance, normal: minus(plus(origin, direction, distance), middle) } : null;
}
