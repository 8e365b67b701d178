// The start of the page: what its address, or its own body, asks for.
import { nameOf } from "../package/source.js";
import { say } from "../ui/elements.js";
import { App } from "./app.js";
import { runBenchmark } from "./bench.js";
import { fileAddress, readParameters } from "./parameters.js";

async function start() {
  const { query, labels } = document.body.dataset;
  const { parameters, problems } = readParameters(query, location.search);
  say(problems.join("; "), true, "address");
  document.body.classList.toggle("bare", parameters.get("ui") === "0");
  const app = (globalThis.rnaViewer = new App(parameters, JSON.parse(labels ?? "{}")));
  app.begin();
  const address = (name) => (parameters.has(name) ? fileAddress(parameters.get(name)) : null);
  const given = address("asset"), scene = address("scene"), image = address("env");
  if (given) app.expectAsset();
  const described = scene && (await app.openScene(scene));
  if (image) await app.openImage(image, nameOf(image));
  const asset = given ?? (described?.asset && fileAddress(described.asset));
  if (asset) await app.open(asset);
  if (parameters.get("bench") === "1") await runBenchmark(app);
}

start();
