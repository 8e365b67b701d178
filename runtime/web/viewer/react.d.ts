// <rna-viewer> in JSX of React 19: import "rna-viewer/react".
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { RnaViewer, RnaViewerAttributes } from "./rna-viewer.js";

export * from "./rna-viewer.js";

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "rna-viewer": DetailedHTMLProps<HTMLAttributes<RnaViewer>, RnaViewer> & RnaViewerAttributes;
    }
  }
}
