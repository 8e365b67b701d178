// Options of an asset, checked.

const whole = (most) => ({
  expected: `a whole number from 1 to ${most}`, isRight: (value) => Number.isInteger(value) && value >= 1 && value <= most,
});
const OPTIONS = {
  visibility: { usual: "rays", expected: '"rays" or "shadow-map"', isRight: (value) => ["rays", "shadow-map"].includes(value) },
  environmentSamples: { usual: 4, ...whole(64) },
  areaSamples: { usual: 2, ...whole(16) },
  nearbySamples: { usual: 4, ...whole(64) },
  maxError: { usual: 0.1, expected: "a number from 0 to 1", isRight: (value) => value >= 0 && value <= 1 },
};
const USUAL = Object.fromEntries(Object.entries(OPTIONS).map(([name, { usual }]) => [name, usual]));

/** All options, the usual where `given` leaves them out. Throws an Error for another name or value. */
export function optionsOf(given) {
  for (const [name, value] of Object.entries(given)) {
    const option = Object.hasOwn(OPTIONS, name) ? OPTIONS[name] : null;
    if (!option) throw new Error(`rna-three has no option ${name}; there are ${Object.keys(OPTIONS).join(", ")}`);
    if (!option.isRight(value)) throw new Error(`${name}: expected ${option.expected}, found ${JSON.stringify(value)}`);
  }
  return { ...USUAL, ...given };
}
