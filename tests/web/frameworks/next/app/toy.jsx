"use client";
import { RnaViewer } from "rna-viewer/react";

const hear = ({ type, detail }) => (globalThis.heard ??= []).push([type, detail.source ?? null]);

export const Toy = () =>
  <RnaViewer id="one" src="/toy.rna" alt="A toy car" loading="eager" camera-controls={true} onError={hear} onCameraChange={hear} />;
