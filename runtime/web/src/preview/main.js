// The page of rna-run --preview: pictures that the renderer streams, and controls that ask it for others.
import { Preview } from "./preview.js";

globalThis.rnaPreview = new Preview();
globalThis.rnaPreview.run();
