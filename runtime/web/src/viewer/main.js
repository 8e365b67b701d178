// The page: the element with a panel beside it, and what the address asks for.
import { element } from "../ui/elements.js";
import { runBenchmark } from "./bench.js";
import { Panel } from "./panel.js";
import { readParameters } from "./parameters.js";

async function start() {
  const viewer = element("viewer"), { attributes, ofPage, problems } = readParameters(location.search);
  document.body.classList.toggle("bare", ofPage.get("ui") === false);
  for (const [name, value] of attributes) viewer.setAttribute(name, value);
  // A scene has lights and a ground of its own, or none.
  if (viewer.hasAttribute("scene")) for (const name of ["sun", "ground"]) viewer.removeAttribute(name);
  if (self !== top) viewer.removeAttribute("wheel-zoom");  // the page around this one scrolls
  await customElements.whenDefined("rna-viewer");
  const stage = (globalThis.rnaViewer = viewer.stage);
  globalThis.rnaPanel = new Panel(stage);
  viewer.notices.say(problems.join("; "), true, "address");
  const { classList } = document.body;
  classList.toggle("expecting", viewer.hasAttribute("src") || viewer.hasAttribute("scene"));
  stage.addEventListener("loading", () => classList.add("expecting"));
  stage.addEventListener("ended", () => classList.remove("expecting"));
  stage.addEventListener("package", () => classList.add("loaded"));
  stage.addEventListener("failed", ({ about }) => about === "scene" && classList.remove("expecting"));
  listenForDrops(stage);
  if (ofPage.get("bench")) viewer.addEventListener("load", () => runBenchmark(stage), { once: true });
}

function listenForDrops(stage) {
  const { classList } = document.body;
  for (const name of ["dragenter", "dragover"]) {
    addEventListener(name, (event) => {
      event.preventDefault();
      classList.add("dropping");
    });
  }
  addEventListener("dragleave", () => classList.remove("dropping"));
  addEventListener("drop", async (event) => {
    event.preventDefault();
    classList.remove("dropping");
    for (const file of [...(event.dataTransfer?.files ?? [])]) {
      await (/\.(hdr|pic|exr)$/i.test(file.name) ? stage.openImage(file, file.name) : stage.open(file));
    }
  });
}

start();
