// The planes of a tier part (spec, 5), as they are stored.
import { fail } from "./errors.js";
import { isMetadata, isObject, isTensor, readHeader, takeTensors } from "./tensors.js";

const DTYPES = { float16: "F16", float32: "F32", int8: "I8" };
const LARGEST = 1e18;

/** { values, scales or null, resolution, channels, precision }; float16 as its bits. */
export function readPlanes(bytes, { planePrecision: precision, resolution, channels }, where) {
  const header = readHeader(bytes, where, "PLANES_HEADER");
  const { tensors } = header, int8 = precision === "int8";
  const expected = int8
    ? { scales: ["F32", [3, channels]], planes: ["I8", [3, resolution, resolution, channels]] }
    : { planes: [DTYPES[precision], [3, resolution, resolution, channels]] };
  const names = Object.keys(expected);
  const present = Object.keys(tensors);
  if (!isMetadata(header.metadata)) fail("PLANES_TENSOR", where, "__metadata__ is no object");
  if (present.length !== names.length || names.some((name) => !present.includes(name))) {
    fail("PLANES_TENSOR", where, `found ${present.join(", ") || "no tensors"}, expected ${names.join(", ")}`);
  }
  for (const name of names) if (!isObject(tensors[name])) fail("PLANES_TENSOR", where, `${name} is no object`);
  for (const name of names) {
    const [dtype, shape] = expected[name], tensor = tensors[name];
    if (tensor.dtype !== dtype) fail("PLANES_DTYPE", where, `${name}: found ${tensor.dtype}, expected ${dtype}`);
    if (!isTensor(tensor) || tensor.shape.join() !== shape.join()) {
      fail("PLANES_SHAPE", where, `${name}: found [${tensor.shape}], expected [${shape}]`);
    }
  }
  const taken = takeTensors(bytes, header, names, where, "PLANES_HEADER");
  if (header.data % 64) fail("PLANES_ALIGNMENT", where, "data does not start at a multiple of 64");
  const values = taken.at(-1), scales = int8 ? taken[0] : null;
  checkValues(precision, values, scales, where);
  return { values, scales, resolution, channels, precision };
}

function checkValues(precision, values, scales, where) {
  const wrong = () => fail("PLANES_NOT_FINITE", where, `NaN, or a value beyond ${LARGEST}`);
  if (precision === "int8") {
    if (scales.some((scale) => !(Math.abs(scale) * 128 <= LARGEST))) wrong();
  } else if (precision === "float16") {
    for (let k = 0; k < values.length; k++) if ((values[k] & 0x7c00) === 0x7c00) wrong();
  } else {
    for (let k = 0; k < values.length; k++) if (!(Math.abs(values[k]) <= LARGEST)) wrong();
  }
}
