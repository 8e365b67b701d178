// What the lights of a scene bring to a fragment: for each a query of the decoder, and what hides it.
import { LightingModel } from "three/webgpu";
import { cameraViewMatrix, float, int, lightViewPosition, positionView, positionWorld, property, vec3, vec4 } from "three/tsl";
import { environmentLight } from "./environment.js";
import { columnsOf } from "./nearby.js";
import { eachSample } from "./samples.js";
import { viewToWorld, worldToObject } from "./spaces.js";

/** Where shadow maps are asked. */
export const shadowPosition = /*@__PURE__*/ property("vec3", "rnaShadowPosition");

export class RnaLighting extends LightingModel {
  constructor(material) {
    super();
    this.material = material;
  }

  start(builder) {
    // The shadow is asked for in `direct`, at a place of its own.
    builder.context.getShadow = (lightNode) => lightNode.baseColorNode;
    this.material.fragment.toVar();
    super.start(builder);
  }

  direct({ lightDirection, lightColor, lightNode, reflectedLight }, builder) {
    const sent = this.sentOf(lightDirection, shadowOf(lightNode, builder), { distance: distanceOf(lightNode) }, builder);
    reflectedLight.directDiffuse.addAssign(lightColor.mul(sent));
  }

  /**
   * Radiance for irradiance 1, shadows included. direction: of view space; shadow: three's for this light, or null. distance: of the
   * light, or null; samples, number: as of columnsOf.
   */
  sentOf(direction, shadow, { distance, samples, number }, builder) {
    const { functions, options } = this.material;
    const world = viewToWorld(direction).toVar(), scaled = worldToObject(world, builder).toVar(), wi = scaled.normalize().toVar();
    const columns = columnsOf(this.material, distance && distance.mul(scaled.length()), samples, number);
    const sent = (visibility) => functions.sent(wi, visibility, ...columns);
    if (options.visibility === "shadow-map") {
      if (!shadow) return sent(float(1));
      shadowPosition.assign(positionWorld);
      return sent(vec3(shadow).x);
    }
    const selfVisibility = functions.selfVisibility(wi, shadow !== null).toVar();
    if (!shadow) return sent(selfVisibility.x);
    // Where the light enters the asset: the map, in which the asset itself is, tells there of others alone.
    shadowPosition.assign(positionWorld.add(world.mul(selfVisibility.y.div(scaled.length()))));
    return sent(selfVisibility.x).mul(vec3(shadow).toVar());
  }

  /** Points of the lamp in a grid, whose middles are asked: it shines to one side. */
  directRectArea({ lightColor, lightPosition, halfWidth, halfHeight, reflectedLight }, builder) {
    const side = this.material.options.areaSamples, corner = halfWidth.cross(halfHeight);
    const place = cameraViewMatrix.mul(vec4(positionWorld, 1)).xyz.toVar();
    const normal = corner.normalize().toVar(), area = corner.length().mul(4);
    const sum = vec3(0).toVar();
    eachSample(this.material, side * side, (number) => {
      const row = number.div(int(side)).toVar(), column = number.sub(row.mul(int(side)));
      const [across, up] = [column, row].map((k) => float(k).mul(2).add(1).div(side).sub(1));
      const way = lightPosition.add(halfWidth.mul(across)).add(halfHeight.mul(up)).sub(place).toVar();
      const distance = way.length().toVar(), direction = way.div(distance).toVar();
      const cosine = direction.dot(normal).max(0);
      const sent = this.sentOf(direction, null, { distance, samples: side * side, number }, builder);
      sum.addAssign(sent.mul(cosine.div(distance.mul(distance))));
    });
    reflectedLight.directDiffuse.addAssign(lightColor.mul(sum).mul(area.div(side * side)));
  }

  indirect(builder) {
    environmentLight(this.material, builder);
  }
}

/** Of a light with a place, in units of the world; null of others. */
function distanceOf({ light }) {
  return light?.isPointLight || light?.isSpotLight ? lightViewPosition(light).sub(positionView).length() : null;
}

/** The shadow map's term, a vector or a number, of a light that has one. */
function shadowOf({ light, shadowNode }, { object, renderer }) {
  return light?.castShadow && object.receiveShadow && renderer.shadowMap.enabled ? shadowNode : null;
}
