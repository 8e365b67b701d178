// A plugin of GLTFLoader: the packages of a glTF file, in place of the meshes that stand for them where nothing reads them.
import { Group, Matrix4, Quaternion, Vector3 } from "three/webgpu";
import { EXTENSION, packagesIn } from "../package/gltf_package.js";
import { RnaAsset } from "./asset.js";
import { optionsOf } from "./options.js";
import { read } from "./reading.js";
import { canShow, hasWebGPU } from "./stand_in.js";

const INSTANCING = "EXT_mesh_gpu_instancing", PLACES = ["TRANSLATION", "ROTATION", "SCALE"];
const HEADERS = 28;  // bytes: of a .glb, and of its JSON and BIN chunks
const INSTEAD = "glTF files show their fallback";

export class RNAExtension {
  /** options: renderer, the scene's; tier and variant, as RnaLoader has them; those of RnaAsset. */
  constructor(parser, { renderer, tier = null, variant = null, ...options } = {}) {
    if (!renderer) throw new Error("RNAExtension: expected the option renderer, as in loader.register((parser) => new RNAExtension(parser, { renderer }))");
    Object.assign(this, { name: EXTENSION, parser, renderer, tier, variant, options: optionsOf(options), assets: new Map(), unused: new Set() });
  }

  /** Reads the packages. Of nodes that are shown by one GLTFLoader then loads no mesh, and of those below the places alone: joints of other meshes. */
  async beforeRoot() {
    const { parser, renderer } = this, { json } = parser, { content = "", body } = parser.extensions.KHR_binary_glTF ?? {};
    const bin = { start: HEADERS + new TextEncoder().encode(content).length, length: body?.byteLength ?? 0 };
    let packages = new Map();
    try {
      packages = packagesIn(json, bin, "glTF");
    } catch (error) {
      warn(error);
    }
    await renderer.init?.();
    if (!packages.size || !hasWebGPU(renderer, INSTEAD)) return;
    const take = ([index, [start, end]]) => this._take(index, new Blob([new Uint8Array(body, start - bin.start, end - start)])).catch(warn);
    await Promise.all([...packages].map(take));
    const shown = json.nodes.filter((node) => this._assetOf(node)), below = new Set(shown.flatMap(childrenOf));
    for (const index of below) childrenOf(json.nodes[index]).forEach((child) => below.add(child));
    const loaded = (node, index) => (below.has(index) ? placeOf(node) : this._assetOf(node) ? withoutMesh(node) : node);
    parser.json = { ...json, nodes: json.nodes.map(loaded) };
  }

  createNodeMesh(index) {
    const node = this.parser.json.nodes[index], asset = this._assetOf(node), places = node.extensions?.[INSTANCING];
    if (!asset) return null;
    if (places) return this._instances(asset, places.attributes);
    return Promise.resolve(this.unused.delete(asset) ? asset : asset.clone());
  }

  /** userData.rnaAssets: of each package the asset, of which the scene has copies or instances; its userData.fallbackFlip: what the fallback lacks. */
  afterRoot(gltf) {
    for (const node of this.parser.json.nodes ?? []) {
      const asset = this._assetOf(node), { fallbackFlip } = node.extensions?.[EXTENSION] ?? {};
      if (asset && fallbackFlip !== undefined) asset.userData.fallbackFlip = fallbackFlip;
    }
    gltf.userData.rnaAssets = [...this.assets.values()];
  }

  /** Reads the package of a buffer view; it is dropped where this GPU cannot show it. */
  async _take(index, bytes) {
    const asset = new RnaAsset(await read(bytes, "glTF", this), this.options);
    const isShown = asset.meshes.every(({ material }) => canShow(this.renderer, material.storageBuffers, INSTEAD));
    if (!isShown) return asset.dispose();
    this.assets.set(index, asset);
    this.unused.add(asset);
  }

  _assetOf(node) {
    return this.assets.get(node.extensions?.[EXTENSION]?.package);
  }

  async _instances(asset, attributes) {
    const places = await this._places(attributes), isMirrored = (place) => place.determinant() < 0;
    const groups = [[places.filter((place) => !isMirrored(place)), 1], [places.filter(isMirrored), -1]];
    const meshes = groups.filter(([{ length }]) => length).flatMap(([these, side]) => asset.instanced(these.length).map((mesh) => {
      mesh.scale.x = side;  // three.js culls by the matrix of the mesh, whatever those of its instances are
      these.forEach((place, k) => mesh.setMatrixAt(k, new Matrix4().makeScale(side, 1, 1).multiply(place)));
      return mesh;
    }));
    return meshes.reduce((group, mesh) => group.add(mesh), new Group());
  }

  /** The matrices of instances. */
  async _places(attributes) {
    const p = new Vector3(), q = new Quaternion(), s = new Vector3(1, 1, 1);
    const [place, turn, size] = await Promise.all(PLACES.map((name) => attributes?.[name] !== undefined && this.parser.getDependency("accessor", attributes[name])));
    const length = (place || turn || size)?.count ?? 1;  // all in one place without any
    return Array.from({ length }, (_, k) => {
      if (place) p.fromBufferAttribute(place, k);
      if (turn) q.fromBufferAttribute(turn, k);
      if (size) s.fromBufferAttribute(size, k);
      return new Matrix4().compose(p, q, s);
    });
  }
}

const warn = ({ message }) => console.warn(`rna-three: ${message}: ${INSTEAD}`);

const childrenOf = (node) => node?.children ?? [];

function withoutMesh({ mesh, skin, weights, ...node }) {
  return node;
}

function placeOf({ mesh, skin, weights, camera, extensions, ...node }) {
  return node;
}
