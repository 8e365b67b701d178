import "rna-viewer";

const hear = ({ type, detail }) => (globalThis.heard ??= []).push([type, detail.source ?? null]);
for (const name of ["error", "camera-change"]) document.getElementById("one").addEventListener(name, hear);
