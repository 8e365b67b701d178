// Types of rna-viewer. docs/element.md of the RNA SDK says what the attributes mean.

/** Attributes of the element in markup. */
export interface RnaViewerAttributes {
  src?: string;
  glass?: string;
  alt?: string;
  poster?: string;
  loading?: "auto" | "lazy" | "eager";
  reveal?: "auto" | "manual";
  tier?: string;
  "variant-name"?: string;
  maps?: string;
  tint?: string;
  environment?: string;
  "environment-intensity"?: number | string;
  sun?: string;
  "light-rotation"?: string;
  ground?: boolean;
  skybox?: boolean;
  exposure?: number | string;
  "view-transform"?: "srgb" | "filmic";
  "camera-orbit"?: string;
  "camera-target"?: string;
  "field-of-view"?: string;
  "min-camera-orbit"?: string;
  "max-camera-orbit"?: string;
  "min-field-of-view"?: string;
  "max-field-of-view"?: string;
  "camera-controls"?: boolean;
  "disable-zoom"?: boolean;
  "disable-pan"?: boolean;
  "disable-light"?: boolean;
  "wheel-zoom"?: "focus" | "always";
  "touch-action"?: "pan-y" | "pan-x" | "none";
  "interaction-prompt"?: "auto" | "none";
  "interpolation-decay"?: number | string;
  "auto-rotate"?: boolean;
  "auto-rotate-delay"?: number | string;
  "rotation-per-second"?: string;
  scene?: string;
  samples?: number | string;
  "pixel-ratio"?: number | string;
  jitter?: number | string;
  "first-look"?: "auto" | "off";
  messages?: "calm" | "whole";
  texts?: string;
}

type CamelCase<Name> = Name extends `${infer First}-${infer Rest}` ? `${First}${Capitalize<CamelCase<Rest>>}` : Name;

/** Properties of the same meaning: null where an attribute is missing. */
export type RnaViewerProperties = {
  [Name in keyof RnaViewerAttributes as CamelCase<Name & string>]-?: Exclude<RnaViewerAttributes[Name], undefined> | null;
};

export interface Vector {
  x: number;
  y: number;
  z: number;
  /** As data-position takes it. */
  toString(): string;
}

export interface RnaViewerEvents {
  progress: CustomEvent<{ totalProgress: number }>;
  load: CustomEvent<{ url: string }>;
  "poster-dismissed": CustomEvent<null>;
  "stand-in": CustomEvent<null>;
  "camera-change": CustomEvent<{
    cameraOrbit: string; cameraTarget: string; fieldOfView: string; source: "user-interaction" | "none";
  }>;
  "light-change": CustomEvent<{
    sun: string; lightRotation: string; environmentIntensity: string; source: "user-interaction" | "none";
  }>;
  error: CustomEvent<{ type: "asset" | "light" | "scene" | "engine"; message: string; code: string | null; sourceError: unknown }>;
}

type Overlaid = keyof RnaViewerProperties;

export interface RnaViewer extends Omit<HTMLElement, Overlaid>, RnaViewerProperties {
  readonly loaded: boolean;
  readonly availableTiers: string[];
  readonly availableVariants: string[];
  readonly availableMaps: string[];
  /** Rejects for a label that the package does not have. */
  setMap(label: string, picture: Blob | ImageBitmap | CanvasImageSource | null): Promise<void>;
  readonly turntableRotation: number;
  resetTurntableRotation(radians?: number): void;
  resetView(): void;
  showPoster(): void;
  dismissPoster(): void;
  positionAndNormalFromPoint(clientX: number, clientY: number): { position: Vector; normal: Vector } | null;
  toBlob(options?: { mimeType?: string; qualityArgument?: number; converged?: boolean }): Promise<Blob | null>;
  addEventListener<Name extends keyof RnaViewerEvents>(
    name: Name, listener: (event: RnaViewerEvents[Name]) => void, options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(name: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
  removeEventListener<Name extends keyof RnaViewerEvents>(
    name: Name, listener: (event: RnaViewerEvents[Name]) => void, options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(name: string, listener: EventListenerOrEventListenerObject, options?: boolean | EventListenerOptions): void;
}
export declare const RnaViewer: { prototype: RnaViewer; new (): RnaViewer };

declare global {
  interface HTMLElementTagNameMap {
    "rna-viewer": RnaViewer;
  }
}
