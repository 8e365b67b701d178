// Types of rna-three. Those of three.js itself are in @types/three.
import type { WebGLRenderer } from "three";
import type { Camera, ColorRepresentation, Euler, Group, InstancedMesh, Loader, LoadingManager, Mesh, NodeMaterial, Scene, Texture, WebGPURenderer } from "three/webgpu";

export interface RnaOptions {
  /** The shadow of the asset on itself: by rays through its own hierarchy, or by the light's shadow map. Default "rays". */
  visibility?: "rays" | "shadow-map";
  /** Directions a pixel for scene.environment, HemisphereLight and AmbientLight; each lengthens the shader. Default 4. */
  environmentSamples?: number;
  /** Points of a RectAreaLight along each of its sides. Default 2. */
  areaSamples?: number;
  /** Rays a pixel and light for nearby light, of tiers that count it. Default 4. */
  nearbySamples?: number;
  /** Largest mean FLIP, of the asset's pixels, of the tier that is chosen by size. Default 0.1. */
  maxError?: number;
}

/** Loads .rna packages, as other loaders of three.js do; packages are read in a worker. */
export class RnaLoader extends Loader<RnaAsset> {
  constructor(manager?: LoadingManager);
  /** Reads one tier alone; null: all, from which each picture chooses. */
  setTier(name: string | null): this;
  /** Shows a variant of the package; null: its own print. A package without it is refused. */
  setVariant(name: string | null): this;
  /** For what is loaded from here on. Throws for an option or a value that it does not know. */
  setOptions(options: RnaOptions): this;
  /** From bytes that are there already. */
  parse(bytes: ArrayBuffer, onLoad: (asset: RnaAsset) => void, onError?: (error: Error) => void): void;
  parseAsync(bytes: ArrayBuffer, name?: string): Promise<RnaAsset>;
  /** Stops what is under way; its promises are rejected. */
  abort(): this;
}

/**
 * A plugin of three.js' GLTFLoader: shows the packages of glTF files (RNA_relightable_asset) in place of their fallback.
 * `loader.register((parser) => new RNAExtension(parser, { renderer }))`. Of what is loaded, `userData.rnaAssets` has the assets, and `userData.fallbackFlip` of an asset the error of its fallback, if the file has it.
 */
export class RNAExtension {
  constructor(parser: unknown, options: RNAExtensionOptions);
  readonly name: "RNA_relightable_asset";
}

export interface RNAExtensionOptions extends RnaOptions {
  /** The renderer of the scene; one without WebGPU shows the fallback. */
  renderer: WebGPURenderer | WebGLRenderer;
  /** As setTier and setVariant of RnaLoader. */
  tier?: string | null;
  variant?: string | null;
}

/** A relightable asset: a group of a mesh for each part. */
export class RnaAsset extends Group {
  readonly isRnaAsset: true;
  /** The package's manifest. */
  readonly manifest: Record<string, unknown>;
  /** Names of the tiers that were read. */
  readonly tiers: string[];
  /** A tier's name (another one throws), or "auto": the cheapest that is good enough for the asset's size in the image. */
  tier: string;
  /** Names of the package's variants, for the loader's setVariant. */
  readonly variants: string[];
  /** The names of the images of base colour, for setMap. */
  readonly maps: string[];
  /** Another picture for the images with that label; null: the package's own. Copies share it. Rejects for another label. */
  setMap(label: string, picture: Blob | ImageBitmap | CanvasImageSource | Texture | null): Promise<void>;
  /** A factor of all base colours, as "crimson". Copies share it. Throws for an asset without base colour. */
  setTint(color: ColorRepresentation): void;
  /** Meshes of the parts; geometry and material can be given to an InstancedMesh. */
  readonly meshes: Mesh[];
  /** Chooses the tier; the renderer calls it. */
  update(camera: Camera): void;
  /** Many of it, each with a matrix of its own, which may turn, move and scale evenly. */
  instanced(count: number): InstancedMesh[];
  /** With children, userData and what else was set; shares geometry and decoders. */
  clone(recursive?: boolean): this;
  /** Frees what is on the GPU, once the last copy is disposed of; a second call does nothing. */
  dispose(): void;
}

/** The node material of a part; WebGPU alone. */
export class RnaMaterial extends NodeMaterial {
  readonly isRnaMaterial: true;
  /** Lights this part in place of scene.environment. */
  envMap: Texture | null;
  envMapIntensity: number;
  envMapRotation: Euler;
  /** Shares the buffers of the asset. */
  clone(): this;
}

/** A picture that loses the noise of environments while camera, objects and lights rest. */
export class StillPicture {
  /** pictures: of the mean, after which nothing is drawn any more. Default 64. */
  constructor(renderer: WebGPURenderer, scene: Scene, camera: Camera, options?: { pictures?: number });
  /** How many pictures the mean has. */
  readonly count: number;
  /** In the place of renderer.render(scene, camera). */
  render(): void;
  /** After a change that is none of places and lights, as of a material or of an image. */
  restart(): void;
  dispose(): void;
}
