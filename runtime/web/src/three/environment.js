// Light from all sides: the scene's environment, and lights of three.js that have no place. One function; a decoder of
// its own for whole environments would take the place of the sum in it.
import { float, interleavedGradientNoise, materialEnvIntensity, mix, screenCoordinate, vec3 } from "three/tsl";
import { columnsOf } from "./nearby.js";
import { eachSample, turnOfPicture } from "./samples.js";
import { objectToWorld } from "./spaces.js";

/** Adds what comes from all sides, as `environmentSamples` directions find it. */
export function environmentLight(material, builder) {
  const radiance = radianceOf(builder);
  if (!radiance.length) return;
  const { functions, options } = material, count = options.environmentSamples;
  const turn = interleavedGradientNoise(screenCoordinate.xy).add(turnOfPicture).fract().toVar(), sum = vec3(0).toVar();
  eachSample(material, count, (number) => {
    const drawn = functions.direction(float(number), float(count), turn).toVar(), wi = drawn.xyz.toVar();
    const world = objectToWorld(wi, builder).toVar();
    // What a sample stands for is as wide as the lobe of this roughness: a blurred image has no noise.
    const roughness = float(1 / (4 * Math.PI * count)).div(drawn.w).pow(0.25).clamp();
    const selfVisibility = functions.selfVisibility(wi, false).x;
    const arriving = radiance.map((of) => of(world, roughness)).reduce((a, b) => a.add(b));
    sum.addAssign(functions.sent(wi, selfVisibility, ...columnsOf(material, null, count, number)).mul(arriving).div(drawn.w));
  });
  builder.context.reflectedLight.indirectDiffuse.addAssign(sum.div(count));
}

/** Radiance along a direction of the world, of each source: (direction, roughness) => vec3. */
function radianceOf(builder) {
  const { rnaEnvironment } = builder.context, sources = [];
  if (rnaEnvironment) {
    const along = (world, roughness) => rnaEnvironment.context({ getUV: () => world, getTextureLevel: () => roughness }).isolate();
    sources.push((world, roughness) => along(world, roughness).mul(materialEnvIntensity));
  }
  for (const { light, colorNode, groundColorNode, lightDirectionNode } of builder.lightsNode.getLightNodes(builder)) {
    if (light?.isAmbientLight) sources.push(() => colorNode.mul(1 / Math.PI));
    // Its irradiance goes linearly from below to above: two even half spheres.
    if (light?.isHemisphereLight) {
      sources.push((world) => mix(groundColorNode, colorNode, world.dot(lightDirectionNode).greaterThan(0).select(1, 0)).mul(1 / Math.PI));
    }
  }
  return sources;
}
