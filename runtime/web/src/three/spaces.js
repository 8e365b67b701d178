// Directions between the spaces that three.js has and the asset's own.
import { cameraWorldMatrix, modelWorldMatrix, modelWorldMatrixInverse, varyingProperty, vec3, vec4 } from "three/tsl";

/** The linear part of the instance's matrix, of an InstancedMesh alone. */
export const instanceColumns = [0, 1, 2].map((k) => /*@__PURE__*/ varyingProperty("vec3", `vRnaInstance${k}`));

export const viewToWorld = (direction) => direction.transformDirection(cameraWorldMatrix);

/** A direction of the world in the asset's space: as much shorter as the asset is larger. */
export function worldToObject(world, { object }) {
  const direction = modelWorldMatrixInverse.mul(vec4(world, 0)).xyz;
  if (!object.isInstancedMesh) return direction;
  const inMesh = direction.toVar(), [a, b, c] = instanceColumns;
  return vec3(a.dot(inMesh), b.dot(inMesh), c.dot(inMesh)).div(a.dot(a));
}

export function objectToWorld(direction, { object }) {
  const [a, b, c] = instanceColumns;
  const inMesh = object.isInstancedMesh ? a.mul(direction.x).add(b.mul(direction.y)).add(c.mul(direction.z)) : direction;
  return modelWorldMatrix.mul(vec4(inMesh, 0)).xyz.normalize();
}
