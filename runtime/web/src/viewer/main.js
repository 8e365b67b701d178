// The start of the page: what its address, or its own body, asks for.
//   ?asset=toy.rna  &tier=small  &env=studio.hdr  &scene=scene.json  &ui=0  &bench=1
//   &api=webgpu|webgl2  &rounds=64  &dpr=1  &jitter=0 (rays through the middles of pixels, for comparisons)
import { App } from "./app.js";
import { runBenchmark } from "./bench.js";

async function start() {
  const parameters = new URLSearchParams(document.body.dataset.query);
  for (const [name, value] of new URLSearchParams(location.search)) parameters.set(name, value);
  document.body.classList.toggle("bare", parameters.get("ui") === "0");
  const app = (globalThis.rnaViewer = new App(parameters));
  app.begin();
  const scene = parameters.get("scene") && (await app.openScene(parameters.get("scene")));
  const env = parameters.get("env");
  if (env) await app.openImage(env, env.split("/").pop());
  const asset = parameters.get("asset") ?? scene?.asset;
  if (asset) await app.open(asset);
  if (parameters.get("bench") === "1") await runBenchmark(app);
}

start();
