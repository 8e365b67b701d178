// Pointer, wheel and keys over the picture: what they change, and which of them the page keeps.
import { clamp, wrappedDegrees } from "../ui/elements.js";

/** Whether a pointer, a wheel or a key acts on the picture; else it is the page's, which scrolls by it. */
export function isForPicture(stage, event) {
  const { cameraControls, disableZoom, wheelZoom } = stage.settings;
  if (!cameraControls || event.type !== "wheel") return cameraControls;
  const isFocused = stage.place.getRootNode().activeElement === stage.canvas;
  return !disableZoom && (wheelZoom === "always" || isFocused || event.ctrlKey || event.metaKey);
}

/** Effects of gestures on a stage: see ui/pointer.js. */
export function actions(stage) {
  const moved = (change, hindrance) => (...values) => {
    if (stage.settings[hindrance]) return;
    stage.glide.stop();
    change(...values);
    stage.isTouched = true;
    stage.restart(values.at(-1) === true);
    stage.emit("camera", { byUser: true });
  };
  return {
    orbit: moved((x, y) => stage.orbit.turn(x, y)),
    pan: moved((x, y) => stage.orbit.pan(x, y), "disablePan"),
    zoom: moved((factor) => stage.orbit.zoom(factor), "disableZoom"),
    light: (x, y, moving) => {
      if (stage.settings.disableLight) return;
      const rotation = wrappedDegrees(stage.lighting.rotation + (x * 180) / Math.PI);
      const sunHeight = clamp(stage.lighting.sunHeight + (y * 180) / Math.PI, -10, 90);
      stage.setLight({ rotation, sunHeight }, { moving: moving === true, byUser: true });
    },
    remember: () => remembered(stage),
    settle: () => stage.viewer?.moving && stage.restart(),
    reset: () => stage.glideTo(() => stage.reset()),
  };
}

/** Undoes what moves camera and light from now on. */
function remembered(stage) {
  const { orbit, lighting, isTouched } = stage, { azimuth, elevation, distance, target } = orbit, { rotation, sunHeight } = lighting;
  const view = { azimuth, elevation, distance, target }, light = { rotation, sunHeight };
  const differs = (object, values) => Object.keys(values).some((name) => object[name] !== values[name]);
  return () => {
    if (differs(lighting, light)) stage.setLight(light);
    if (!differs(orbit, view)) return;
    Object.assign(orbit, view);
    stage.isTouched = isTouched;
    stage.restart();
    stage.emit("camera", { byUser: false });
  };
}
