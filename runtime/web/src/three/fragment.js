// Where a fragment is and from where it is seen, in the asset's space.
import {
  cameraProjectionMatrix, cameraWorldMatrix, float, Fn, positionGeometry, positionView, positionViewDirection, screenCoordinate, vec2, vec3, vec4, viewport,
} from "three/tsl";
import { viewToWorld, worldToObject } from "./spaces.js";

/** From the fragment to the viewer; of unit length. */
export const towardsViewer = (builder) => worldToObject(viewToWorld(positionViewDirection), builder).normalize();

/** Says where the fragment is to the WGSL's functions that follow; where its ray meets no segment it is discarded. */
export const fragmentOf = ({ functions, kind }) => Fn((builder) => {
  if (kind !== "fiber") return functions.begin(positionGeometry, towardsViewer(builder), widthOfPixel(builder));
  const aside = asideOfPixel().toVar();
  const toObject = (v) => worldToObject(cameraWorldMatrix.mul(vec4(v, 0)).xyz, builder);
  const towards = builder.camera.isOrthographicCamera ? vec3(0, 0, 1) : positionView.add(aside).negate();
  const begun = functions.begin(positionGeometry.add(toObject(aside)), toObject(towards).normalize(), float(0)).toVar();
  begun.equal(0).discard();
  return begun;
})();

/** At the fragment, in the asset's space. */
function widthOfPixel(builder) {
  const spread = cameraProjectionMatrix.element(1).y.mul(viewport.w).reciprocal().mul(2);
  const width = builder.camera.isOrthographicCamera ? spread : spread.mul(positionView.length());
  return worldToObject(cameraWorldMatrix.mul(vec4(1, 0, 0, 0)).xyz, builder).length().mul(width);
}

/**
 * From what was rasterised to the ray through the pixel's middle, across the view. Corners of triangles lie on a grid, of
 * 1/16 of a pixel on SwiftShader and 1/256 on GPUs, and a strand may be thinner than a pixel.
 */
function asideOfPixel() {
  const clip = cameraProjectionMatrix.mul(vec4(positionView, 1)).toVar();
  const place = screenCoordinate.sub(viewport.xy).div(viewport.zw).mul(vec2(2, -2)).add(vec2(-1, 1));
  const scale = vec2(cameraProjectionMatrix.element(0).x, cameraProjectionMatrix.element(1).y);
  return vec3(place.mul(clip.w).sub(clip.xy).div(scale), 0);
}
