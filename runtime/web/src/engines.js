// Which of the two engines this browser can run.
import { NotSupported } from "./package/errors.js";
import { WebGLEngine } from "./webgl/engine.js";

const ENGINES = { webgl2: WebGLEngine };

/** The best engine there is; `wanted` names one. */
export async function openEngine(canvas, wanted) {
  if (wanted) return ENGINES[wanted].open(canvas);
  const reasons = [];
  for (const Engine of Object.values(ENGINES)) {
    try {
      return await Engine.open(canvas);
    } catch (error) {
      reasons.push(error.message);
    }
  }
  throw new NotSupported(`this browser can show the poster alone: ${reasons.join("; ")}`);
}
