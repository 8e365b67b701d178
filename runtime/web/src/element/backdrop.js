// Colours of CSS: that behind the asset, the element's background, and the tint.

/**
 * A colour of CSS, in any form: RGB, linear light of sRGB from 0 to 1; null if it is translucent, so that the page shows through,
 * or no colour by itself, as var(--accent) and currentcolor.
 */
export function linearColour(css) {
  if (/currentcolor/i.test(css)) return null;  // black to a canvas
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  context.fillStyle = "transparent";  // stays where the next one is no colour
  context.fillStyle = css;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b, alpha] = [...context.getImageData(0, 0, 1, 1).data].map((value) => value / 255);
  return alpha < 1 ? null : [r, g, b].map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
}
