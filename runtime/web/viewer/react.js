"use client";
// The element as a component of React 19, with the events under React's names. Next.js and others load it in the browser.
import { createElement, useImperativeHandle, useLayoutEffect, useRef } from "react";
import "./rna-viewer.js";

const EVENTS = {
  onLoad: "load", onError: "error", onProgress: "progress", onPosterDismissed: "poster-dismissed",
  onStandIn: "stand-in", onCameraChange: "camera-change", onLightChange: "light-change",
};

/** It listens by itself: React does not, on custom elements of pages that a server has rendered. */
export function RnaViewer({ ref, ...props }) {
  const own = useRef(null), latest = useRef(props);
  useImperativeHandle(ref, () => own.current, []);
  useLayoutEffect(() => { latest.current = props; });
  useLayoutEffect(() => {
    const listening = new AbortController();
    for (const [name, type] of Object.entries(EVENTS)) {
      own.current.addEventListener(type, (event) => latest.current[name]?.(event), { signal: listening.signal });
    }
    return () => listening.abort();
  }, []);
  const attributes = Object.entries(props).filter(([name]) => !Object.hasOwn(EVENTS, name));
  return createElement("rna-viewer", { ...Object.fromEntries(attributes), ref: own });
}
