// The columns of nearby light at a fragment.
import { float, interleavedGradientNoise, screenCoordinate } from "three/tsl";
import { turnOfPicture } from "./samples.js";

const DISTANT = 1e30;

/**
 * The last arguments of `sent`. far: distance of the light in the asset's space, or null. samples: of the light at the fragment;
 * number: of this one, a node.
 */
export function columnsOf({ tracesColumns, options }, far, samples = 1, number = float(0)) {
  const columns = Math.ceil(options.nearbySamples / samples);
  // Another noise than that of the environment's directions: columns must not go by these.
  const turn = tracesColumns ? interleavedGradientNoise(screenCoordinate.yx).add(turnOfPicture).add(float(number).mul(0.7548777)).fract() : float(0);
  return [far ?? float(DISTANT), float(columns), turn];
}
