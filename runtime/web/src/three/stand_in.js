// What is shown of an asset without WebGPU, and the line that says so: its shape in grey, lit from the camera.
import { normalView, positionViewDirection, vec3, vec4 } from "three/tsl";

const warned = new WeakSet();  // renderers

/** Whether this renderer can show the material; one that cannot has a warning once. */
export function hasWebGPU(renderer) {
  if (renderer.backend?.isWebGPUBackend) return true;
  if (!warned.has(renderer)) console.warn("rna-three needs WebGPURenderer with WebGPU: assets are shown as grey shapes");
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
