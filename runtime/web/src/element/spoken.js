// What a screen reader says of the camera.

const SIDES = ["front", "front-right", "right", "back-right", "back", "back-left", "left", "front-left"];
const LEVEL = (20 * Math.PI) / 180;

/** Where the asset is seen from, its front being towards +z. text(name): see texts.js. */
export function spokenView({ azimuth, elevation }, text) {
  const eighth = Math.round((4 * azimuth) / Math.PI), side = SIDES[((eighth % 8) + 8) % 8];
  const height = elevation > LEVEL ? text("above") : elevation < -LEVEL ? text("below") : "";
  return text(side) + height;
}
