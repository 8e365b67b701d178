// The start of the page: what its address asks for.
//   ?asset=toy.rna  &tier=small  &env=studio.hdr  &scene=scene.json  &ui=0  &api=webgpu|webgl2  &rounds=64  &dpr=1
import { App } from "./app.js";

async function start() {
  const parameters = new URLSearchParams(location.search);
  document.body.classList.toggle("bare", parameters.get("ui") === "0");
  const app = (globalThis.rnaViewer = new App(parameters));
  try {
    await app.begin();
  } catch (error) {
    app._failed(error);
    return;
  }
  const scene = parameters.get("scene");
  let { asset, env } = Object.fromEntries(parameters);
  if (scene) {
    const answer = await fetch(scene);
    const found = await answer.json();
    app.applyScene(found);
    asset ??= found.asset;
  }
  if (env) await app.openImage(env, env.split("/").pop());
  if (asset) await app.open(asset);
}

start();
