// <RnaViewer> for React 19, and <rna-viewer> in its JSX: import { RnaViewer } from "rna-viewer/react".
import type { DetailedHTMLProps, FunctionComponent, HTMLAttributes } from "react";
import type { RnaViewer as Element, RnaViewerAttributes, RnaViewerEvents } from "./rna-viewer.js";

// React hears these of no custom element under names of its own.
type Unheard = "onLoad" | "onError" | "onProgress";
type Common = Omit<DetailedHTMLProps<HTMLAttributes<Element>, Element>, Unheard> & RnaViewerAttributes;
type Pascal<Name> = Name extends `${infer First}-${infer Rest}` ? `${Capitalize<First>}${Pascal<Rest>}` : Capitalize<Name & string>;

/** Of the tag: React takes what follows "on" as the event's name. */
type TagListeners = { [Name in keyof RnaViewerEvents as `on${Name}`]?: (event: RnaViewerEvents[Name]) => void };
/** Of the component: onLoad, onCameraChange and so on. */
type Listeners = { [Name in keyof RnaViewerEvents as `on${Pascal<Name>}`]?: (event: RnaViewerEvents[Name]) => void };

export type RnaViewerProps = Common & Listeners;
/** The element as a component; attributes are as in markup. */
export declare const RnaViewer: FunctionComponent<RnaViewerProps>;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "rna-viewer": Common & TagListeners;
    }
  }
}
