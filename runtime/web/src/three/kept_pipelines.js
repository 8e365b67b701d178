// Compiled shaders outlive their assets: a package that comes again, or one of the same shape, is drawn without
// compiling anew. three.js lets go of a pipeline with its last mesh; here each counts as used once more.

const MOST = 16;
const latest = new WeakMap();  // renderer -> pipelines, the latest last

/** Keeps the renderer's pipelines whose shader has this in it, the last 16. */
export function keepPipelines(renderer, mark) {
  const manager = renderer?._pipelines;
  if (!manager?.caches) return;
  if (!latest.has(renderer)) latest.set(renderer, new Set());
  const pipelines = latest.get(renderer);
  for (const pipeline of manager.caches.values()) {
    if (!pipeline.fragmentProgram?.code.includes(mark)) continue;
    if (!pipelines.delete(pipeline)) count(pipeline, 1);
    pipelines.add(pipeline);
  }
  for (const pipeline of [...pipelines].slice(0, -MOST)) {
    pipelines.delete(pipeline);
    letGo(manager, pipeline);
  }
}

const programsOf = ({ vertexProgram, fragmentProgram }) => [vertexProgram, fragmentProgram];

function count(pipeline, change) {
  for (const used of [pipeline, ...programsOf(pipeline)]) used.usedTimes += change;
}

function letGo(manager, pipeline) {
  count(pipeline, -1);
  if (pipeline.usedTimes === 0) manager._releasePipeline(pipeline);
  for (const program of programsOf(pipeline)) if (program.usedTimes === 0) manager._releaseProgram(program);
}
