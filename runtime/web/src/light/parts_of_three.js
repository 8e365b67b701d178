// What three's EXRLoader takes from three, which the build gives it in place of the whole of three.
export { DataUtils } from "three/src/extras/DataUtils.js";
export * from "three/src/constants.js";

export class DataTextureLoader {}
