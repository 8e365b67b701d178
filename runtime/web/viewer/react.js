"use client";
// The element as a component of React 19, with the events under React's names. Next.js and others load it in the browser.
import { createElement } from "react";
import "./rna-viewer.js";

const EVENTS = {
  onLoad: "onload", onError: "onerror", onProgress: "onprogress", onPosterDismissed: "onposter-dismissed",
  onStandIn: "onstand-in", onCameraChange: "oncamera-change", onLightChange: "onlight-change",
};

export function RnaViewer(props) {
  const named = Object.entries(props).map(([name, value]) => [Object.hasOwn(EVENTS, name) ? EVENTS[name] : name, value]);
  return createElement("rna-viewer", Object.fromEntries(named));
}
