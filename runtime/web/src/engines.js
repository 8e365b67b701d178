// Which of the two engines this browser can run.
import { NotSupported } from "./package/errors.js";
import { WebGLEngine } from "./webgl/engine.js";
import { WebGPUEngine } from "./webgpu/engine.js";

const ENGINES = { webgpu: WebGPUEngine, webgl2: WebGLEngine };

/** { engine, canvas, reasons }: the best engine there is, and why no better one; `wanted` names one. */
export async function openEngine(newCanvas, wanted) {
  const reasons = [];
  for (const [name, Engine] of Object.entries(ENGINES)) {
    if (wanted && wanted !== name) continue;
    try {
      const canvas = newCanvas();  // a canvas has one kind of context for good
      return { engine: await Engine.open(canvas), canvas, reasons };
    } catch (error) {
      reasons.push(error.message);
    }
  }
  throw new NotSupported(`this browser shows the poster alone: ${reasons.join("; ") || `no engine ${wanted}`}`);
}
