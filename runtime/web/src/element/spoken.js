// What a screen reader says of the camera.

const SIDES = ["front", "front right", "right", "back right", "back", "back left", "left", "front left"];
const LEVEL = (20 * Math.PI) / 180;

/** Where the asset is seen from, its front being towards +z. */
export function spokenView({ azimuth, elevation }) {
  const eighth = Math.round((4 * azimuth) / Math.PI), side = SIDES[((eighth % 8) + 8) % 8];
  const height = elevation > LEVEL ? ", from above" : elevation < -LEVEL ? ", from below" : "";
  return `View from the ${side}${height}`;
}
