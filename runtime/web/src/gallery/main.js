// The gallery: one light for all assets of the page.
import { element } from "../ui/elements.js";

const value = (id) => element(id).value;

element("light").addEventListener("input", () => {
  for (const viewer of document.querySelectorAll("rna-viewer")) {
    viewer.sun = `40deg ${value("height")}deg ${value("brightness")}`;
    viewer.lightRotation = `${value("rotation")}deg`;
    viewer.environmentIntensity = value("sky");
  }
});
