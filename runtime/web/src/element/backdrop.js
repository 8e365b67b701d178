// What is behind the asset: the element's background colour.

const DEFAULT = [64, 67, 71];

/** Its `background-color`, an opaque sRGB colour, as linear light; a dark grey for any other. */
export function linearColour(place) {
  const { backgroundColor } = getComputedStyle(place);
  const found = /^rgb\((\d+), (\d+), (\d+)\)$/.exec(backgroundColor)?.slice(1).map(Number) ?? DEFAULT;
  return found.map((value) => value / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
}
