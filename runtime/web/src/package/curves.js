// Curves (spec, 4.2): points, radii and offsets of strands, quantised or not.
import { fail } from "./errors.js";
import { isMetadata, isTensor, readHeader, takeTensors } from "./tensors.js";

const MOST_POINTS = 2 ** 26, MOST_STRANDS = 2 ** 25, MOST_STEPS = 2 ** 31;
const PLAIN = { points: [["F32"], 2], radii: [["F32"], 1], offsets: [["U32"], 1] };
const QUANTISED = {
  scales: [["F32"], 1], origins: [["F32"], 2], offsets: [["U32"], 1], steps: [["I16", "I32"], 2], radii: [["U8", "U16"], 1],
};

/** { points, radii, offsets } as float32 and uint32. */
export function readCurves(bytes, where) {
  const header = readHeader(bytes, where, "GEOMETRY_CONTAINER");
  const { tensors } = header, quantised = "steps" in tensors || "scales" in tensors;
  const form = quantised ? QUANTISED : PLAIN, names = Object.keys(form);
  checkForm(header, form, names, where);
  const shapes = Object.fromEntries(names.map((name) => [name, tensors[name].shape]));
  const taken = takeTensors(bytes, header, names, where, "GEOMETRY_RANGE");
  const arrays = Object.fromEntries(names.map((name, k) => [name, taken[k]]));
  const strands = shapes.offsets[0] - 1, points = shapes.radii[0];
  const fits = quantised
    ? shapes.origins[0] === strands && shapes.steps[0] === points - strands && shapes.scales[0] === 2
    : shapes.points[0] === points;
  if (!fits || strands < 1) fail("GEOMETRY_ARRAY", where, "tensors whose shapes do not fit each other");
  checkOffsets(arrays.offsets, points, where);
  const curves = quantised ? restored(arrays, where) : arrays;
  checkCurves(curves, where);
  return curves;
}

function checkForm(header, form, names, where) {
  const { tensors } = header, code = "GEOMETRY_PROFILE";
  const present = Object.keys(tensors);
  if (present.length !== names.length || names.some((name) => !present.includes(name))) {
    fail(code, where, `found ${present.join(", ") || "no tensors"}, expected ${names.join(", ")}`);
  }
  if (!isMetadata(header.metadata)) fail(code, where, "__metadata__ is no object");
  for (const [name, [dtypes, dims]] of Object.entries(form)) {
    const tensor = tensors[name];
    const right = isTensor(tensor) && dtypes.includes(tensor.dtype) && tensor.shape.length === dims
      && (dims === 1 || tensor.shape[1] === 3);
    if (!right) fail(code, where, `${name} is not ${dtypes.join(" or ")} of ${dims} dimensions`);
  }
  const points = tensors.points ?? tensors.radii;
  if (points.shape[0] > MOST_POINTS || tensors.radii.shape[0] > MOST_POINTS || tensors.offsets.shape[0] - 1 > MOST_STRANDS) {
    fail(code, where, "more points or strands than allowed");
  }
  if (header.data % 64) fail(code, where, "data does not start at a multiple of 64");
}

function checkOffsets(offsets, points, where) {
  let right = offsets[0] === 0 && offsets.at(-1) === points;
  for (let k = 1; k < offsets.length && right; k++) right = offsets[k] >= offsets[k - 1] + 2;
  if (!right) fail("GEOMETRY_STRANDS", where, "the offsets do not part the points into strands");
}

/** Points and radii from steps, in float64, rounded once. */
function restored({ scales, origins, offsets, steps, radii }, where) {
  const [step, unit] = scales;
  if (!(step > 0 && Number.isFinite(step))) fail("GEOMETRY_STEPS", where, "steps without length");
  if (origins.some((x) => !Number.isFinite(x))) fail("GEOMETRY_NOT_FINITE", where, "an origin is not finite");
  if (!(unit > 0 && Number.isFinite(unit)) || radii.some((radius) => radius === 0)) fail("GEOMETRY_RADIUS", where, "a radius that is not above 0");
  const points = new Float32Array(3 * radii.length);
  let from = 0;
  for (let strand = 0; strand + 1 < offsets.length; strand++) {
    for (let axis = 0; axis < 3; axis++) {
      const origin = origins[3 * strand + axis];
      let sum = 0;
      points[3 * offsets[strand] + axis] = origin;
      for (let point = offsets[strand] + 1, k = from; point < offsets[strand + 1]; point++, k++) {
        sum += steps[3 * k + axis];
        if (Math.abs(sum) > MOST_STEPS) fail("GEOMETRY_STEPS", where, `strand ${strand} goes too far`);
        points[3 * point + axis] = origin + step * sum;
      }
    }
    from += offsets[strand + 1] - offsets[strand] - 1;
  }
  return { points, radii: Float32Array.from(radii, (radius) => radius * unit), offsets };
}

function checkCurves({ points, radii, offsets }, where) {
  if (points.some((x) => !Number.isFinite(x)) || radii.some((x) => !Number.isFinite(x))) {
    fail("GEOMETRY_NOT_FINITE", where, "a point or a radius is not finite");
  }
  for (let strand = 0; strand + 1 < offsets.length; strand++) {
    for (let k = offsets[strand] + 1; k < offsets[strand + 1]; k++) {
      const same = points[3 * k] === points[3 * k - 3] && points[3 * k + 1] === points[3 * k - 2]
        && points[3 * k + 2] === points[3 * k - 1];
      if (same) fail("GEOMETRY_SEGMENT", where, `two equal points in strand ${strand}`);
    }
  }
  if (radii.some((radius) => !(radius > 0))) fail("GEOMETRY_RADIUS", where, "a radius that is not above 0");
}
