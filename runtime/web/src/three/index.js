// rna-three: relightable neural assets in scenes of three.js.
export { RnaAsset } from "./asset.js";
export { RNAExtension } from "./gltf_extension.js";
export { RnaLoader } from "./loader.js";
export { RnaMaterial } from "./material.js";
export { StillPicture } from "./still_picture.js";
