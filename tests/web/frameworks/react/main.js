// As from a server: React takes the markup over, and adds no listeners of its own to custom elements in it.
import { createElement, StrictMode } from "react";
import { hydrateRoot } from "react-dom/client";
import { renderToString } from "react-dom/server";
import { RnaViewer } from "rna-viewer/react";

const hear = ({ type, detail }) => (globalThis.heard ??= []).push([type, detail.source ?? null]);

const page = createElement(StrictMode, null,
  createElement("h1", null, "React"),
  createElement(RnaViewer, { id: "one", src: "/toy.rna", alt: "A toy car", loading: "eager", "camera-controls": true, onError: hear, onCameraChange: hear }),
  createElement("div", { style: { height: 3000 } }));
const root = document.getElementById("root");
root.innerHTML = renderToString(page);
hydrateRoot(root, page);
