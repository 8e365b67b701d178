// What is done for each sample of a light that has many.
import { int, Loop, uniform } from "three/tsl";

/** By how much all directions are turned: another value for each picture of a mean. */
export const turnOfPicture = /*@__PURE__*/ uniform(0);

/**
 * body(number), an integer node, for each below `count`. A loop, since drivers inline all that is written out; but about
 * strands SwiftShader does not come to an end with a loop around those of rays.
 */
export function eachSample({ kind }, count, body) {
  if (kind === "fiber") for (let k = 0; k < count; k++) body(int(k));
  else Loop({ start: 0, end: count, type: "int", condition: "<" }, ({ i }) => body(i));
}
