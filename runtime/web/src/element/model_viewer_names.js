// Attributes of model-viewer that the element does not have: what is ours, for the console.

const MOTION = "nothing: assets stay as they were made", AR = "nothing: there is no AR";
const OURS = {
  "environment-image": "environment", "skybox-image": "environment with skybox", "skybox-height": "skybox, of which the image is far away",
  "shadow-intensity": "ground, on an opaque background-color", "shadow-softness": "ground, whose shadow is as soft as the lights are wide",
  "tone-mapping": "view-transform", autoplay: MOTION, "animation-name": MOTION, "animation-crossfade-duration": MOTION, ar: AR, "ar-modes": AR,
  "ar-scale": AR, "ar-placement": AR, "ar-usdz-max-texture-size": AR, "ios-src": AR, "xr-environment": AR, orientation: "camera-orbit, or light-rotation", scale: "camera-orbit, whose radius says how near",
  "with-credentials": "nothing: files are asked for with the cookies of their own site alone", "disable-tap": "nothing: a tap moves no camera",
  "interaction-prompt-threshold": "interaction-prompt", "interaction-prompt-style": "interaction-prompt", bounds: "nothing: the whole asset is framed",
  "orbit-sensitivity": "nothing: a gesture has one speed", "zoom-sensitivity": "nothing: a gesture has one speed", "pan-sensitivity": "nothing: a gesture has one speed",
  "min-hotspot-opacity": "data-visibility-attribute, and CSS", "max-hotspot-opacity": "data-visibility-attribute, and CSS",
  "generate-schema": "nothing", a11y: "texts",
};

/** Lines about those of these names that are model-viewer's. */
export function linesOnNames(names) {
  const lines = names.filter((name) => Object.hasOwn(OURS, name)).map((name) => `no attribute ${name}, which is model-viewer's; here it is ${OURS[name]}`);
  if (lines.length && names.includes("exposure")) lines.push("exposure is in stops, where model-viewer's is a factor: its 1 is 0 here");
  return lines;
}

export const isModelViewers = (name) => Object.hasOwn(OURS, name);
