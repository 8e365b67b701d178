// Vectors of three numbers, in arrays.

/** a + factor * b */
export const plus = (a, b, factor = 1) => a.map((value, k) => value + factor * b[k]);
export const minus = (a, b) => a.map((value, k) => value - b[k]);
export const times = (a, factor) => a.map((value) => value * factor);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
/** (0, 0, 0) stays. */
export const unit = (a) => times(a, 1 / (Math.hypot(...a) || 1));
