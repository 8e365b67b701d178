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
  if (!tracesColumns) return [float(DISTANT), float(columns), float(0)];
  // Another noise than that of the environment's directions, and another step from picture to picture: columns that went by these
  // would be wrong in the mean of all pictures, too.
  const turn = interleavedGradientNoise(screenCoordinate.yx).add(turnOfPicture.mul(3)).add(float(number).mul(0.7548777)).fract();
  return [far ?? float(DISTANT), float(columns), turn];
}
