// What is shown of an asset without WebGPU, and the line that says so: its shape in grey, lit from the camera.
import { normalView, positionViewDirection, vec3, vec4 } from "three/tsl";
import { constants } from "../decoder/records.js";

const warned = new WeakSet();  // renderers
const GREY = "assets are shown as grey shapes";

/** Whether this renderer has WebGPU; one that has not has a warning once. instead: what is shown then. */
export function hasWebGPU(renderer, instead = GREY) {
  return !!renderer.backend?.isWebGPUBackend || warn(renderer, "needs WebGPURenderer with WebGPU", instead);
}

/** Whether it can show a material with so many storage buffers: GPUs of WebGPU's compatibility level have few or none for fragments. */
export function canShow(renderer, buffers, instead = GREY) {
  if (!hasWebGPU(renderer, instead)) return false;
  const most = renderer.backend.device.limits.maxStorageBuffersInFragmentStage ?? Infinity;
  return buffers <= most || warn(renderer, `needs ${buffers} storage buffers in the fragment stage; this GPU allows ${most}`, instead);
}

/** Whether uniform buffers are too small for weights, as on GPUs of the compatibility level. */
export const hasSmallUniforms = ({ backend }) => backend?.device?.limits.maxUniformBufferBindingSize < 16 * constants.UNIFORM_WEIGHTS;

function warn(renderer, why, instead) {
  if (!warned.has(renderer)) console.warn(`rna-three ${why}: ${instead}`);
  warned.add(renderer);
  return false;
}

/** For the WebGL 2 backend of WebGPURenderer. */
export const standInNode = () => vec4(vec3(normalView.dot(positionViewDirection).abs().mul(0.5)), 1);

/** For WebGLRenderer: members of a material as it takes them. */
export const STAND_IN = {
  uniforms: {},
  vertexShader: `
    varying vec3 n, x;
    void main() {
      #include <beginnormal_vertex>
      #include <defaultnormal_vertex>
      #include <begin_vertex>
      #include <project_vertex>
      n = transformedNormal;
      x = mvPosition.xyz;
    }`,
  fragmentShader: `
    varying vec3 n, x;
    void main() {
      gl_FragColor = vec4(vec3(0.5 * abs(dot(normalize(n), normalize(x)))), 1.0);
      #include <tonemapping_fragment>
      #include <colorspace_fragment>
    }`,
};
