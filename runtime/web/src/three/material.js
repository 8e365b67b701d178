// The node material of a part in one tier: rna_gpu's WGSL with the buffers that three.js binds.
import { Color, DoubleSide, Euler, FrontSide, InstancedInterleavedBuffer, LightingNode, NodeMaterial, StorageBufferAttribute } from "three/webgpu";
import * as tsl from "three/tsl";
import { attribute, bool, buffer, Fn, pmremTexture, positionGeometry, storage, vec4, wgsl, wgslFn } from "three/tsl";
import { SurfaceTable } from "../geometry/surface_table.js";
import { fragmentOf, towardsViewer } from "./fragment.js";
import { RnaLighting, shadowPosition } from "./lighting.js";
import { LETTERS, partSource } from "./shader_source.js";
import { instanceColumns } from "./spaces.js";
import { canShow, hasSmallUniforms, STAND_IN, standInNode } from "./stand_in.js";

/** The prefix of the name of each function that three.js calls. */
export const MARK = "rna_three_";

/** Buffers of all parts and tiers of an asset. */
export class SharedBuffers {
  constructor({ nodes, primitives, points, surfaces, ...facts }) {
    const { words, places } = sceneOf(nodes, primitives, points);
    this.facts = { ...facts, ...places, mixtures: surfaces.surfaces };
    this.surfaces = new SurfaceTable(surfaces);
    const { hasBaseColor, texturesAt, table } = this.surfaces.arrays();
    this.facts.printed = hasBaseColor ? { texturesAt: 4 * texturesAt, imagesAt: table.length } : null;
    this.images = hasBaseColor ? named(this._printed(), "uint", "rna_images") : null;
    this.scene = new StorageBufferAttribute(words, 4);
  }

  /** Takes the images and the tint of `surfaces` over. */
  print() {
    this.images.value.dispose();
    this.images.value = this._printed();
  }

  _printed() {
    const { table, images } = this.surfaces.arrays(), words = new Uint32Array(table.length + images.length);
    words.set(table);
    words.set(images, table.length);
    return new StorageBufferAttribute(words, 1);
  }

  dispose() {
    for (const stored of [this.scene, this.images?.value]) stored?.dispose();
  }
}

/** One buffer of all geometry, as GPUs of WebGPU's compatibility level may have four for fragments; places: of vec4u in it. */
function sceneOf(nodes, primitives, points) {
  const words = new Uint32Array(nodes.length + primitives.length + points.length), primitivesAt = nodes.length, pointsAt = primitivesAt + primitives.length;
  words.set(nodes);
  words.set(primitives, primitivesAt);
  new Float32Array(words.buffer).set(points, pointsAt);
  return { words, places: { primitivesAt: primitivesAt / 4, pointsAt: pointsAt / 4 } };
}

const named = (attribute, type, name) => storage(attribute, type, attribute.count).toReadOnly().setName(name);

/** Of the nearby light whose columns are traced, or null. */
const lengthsOf = ({ lengths }, { visibility }) => (visibility === "rays" ? lengths : null);

export class RnaMaterial extends NodeMaterial {
  static get type() {
    return "RnaMaterial";
  }

  /** options: those of RnaAsset. part: planes and decoders of a part in a tier. */
  constructor(shared, kind, part, options) {
    super();
    this.given = [shared, kind, part, options];
    Object.assign(this, { lights: true, side: kind === "fiber" ? FrontSide : DoubleSide, isRnaMaterial: true, options, kind, tracesColumns: !!lengthsOf(part, options) });
    // As three.js' own have it: without a `null` here it leaves scene.environmentRotation out.
    Object.assign(this, { envMap: null, envMapIntensity: 1, envMapRotation: new Euler() });
    // For exporters, which read a colour of every material: they write the shape in white. Here nothing depends on it.
    Object.assign(this, { color: new Color(), colorNode: vec4(1) });
    Object.assign(this, STAND_IN);
    this.receivedShadowPositionNode = shadowPosition;
    Object.assign(this, { stored: [], storesAll: null });
    this._compose(false);
    if (part.decoders.emission) this.emissiveNode = Fn((builder) => this.functions.emitted(towardsViewer(builder)))();
  }

  /** The WGSL and its buffers. storesAll: weights are not uniform, which is faster, where they would fit. */
  _compose(storesAll) {
    if (storesAll === this.storesAll) return;
    this._letGo();
    const [shared, kind, part, options] = this.given, { planes, decoders } = part, forms = Object.keys(decoders);
    const { weightsAt, weights } = storedWeights(decoders, storesAll), isUniform = (form) => weightsAt[form] === undefined;
    // Four storage buffers at most.
    const buffers = [
      named(shared.scene, "uvec4", "rna_scene"), named(this._store(planes, 1), "uint", "rna_planes"),
      ...(shared.images ? [shared.images] : []), ...(weights.length ? [named(this._store(weights, 4), "vec4", "rna_stored")] : []),
      ...forms.map((form) => buffer(new Float32Array(decoders[form].record.buffer), "RnaPart", 1).setName(`rna${LETTERS[form]}_part`)),
      ...forms.filter(isUniform).map((form) => buffer(decoders[form].weights, "vec4", decoders[form].weights.length / 4).setName(`rna${LETTERS[form]}_weights`)),
    ];
    const groups = Math.max(...Object.values(decoders).map((decoder) => decoder.groups));
    const source = partSource({ kind, groups, forms, weightsAt, planeWords: planes.length / 3, lengths: lengthsOf(part, options), ...shared.facts });
    Object.assign(this, {
      storesAll, storageBuffers: buffers.filter(({ isStorageBufferNode }) => isStorageBufferNode).length,
      functions: functionsOf(source, buffers, "emission" in decoders),
    });
    this.fragment = fragmentOf(this);
  }

  _store(array, items) {
    const attribute = new StorageBufferAttribute(array, items);
    this.stored.push(attribute);
    return attribute;
  }

  _letGo() {
    for (const attribute of this.stored.splice(0)) attribute.dispose();
  }

  /** Materials have buffers of their own, which three.js keeps with the program. */
  customProgramCacheKey() {
    return `${super.customProgramCacheKey()} ${this.uuid}`;
  }

  setup(builder) {
    const { fragmentNode } = this;
    this._compose(hasSmallUniforms(builder.renderer));
    if (!canShow(builder.renderer, this.storageBuffers)) this.fragmentNode = standInNode();
    super.setup(builder);
    this.fragmentNode = fragmentNode;
  }

  setupLightingModel() {
    return new RnaLighting(this);
  }

  setupEnvironment(builder) {
    const node = super.setupEnvironment(builder) ?? builder.environmentNode;
    return node ? new Environment(node) : null;
  }

  setupPosition(builder) {
    const result = super.setupPosition(builder);
    if (builder.object.isInstancedMesh) {
      const columns = columnsOf(builder.object);
      instanceColumns.forEach((column, k) => column.assign(columns[k].xyz));
    }
    return result;
  }

  /** Shares the buffers, of which the asset's own material disposes. */
  clone() {
    return Object.assign(new this.constructor(...this.given).copy(this), { stored: [] });
  }

  dispose() {
    super.dispose();
    this._letGo();
  }
}

/** { weights, weightsAt }: of all decoders whose weights are in storage, one behind the other, and where those of a form begin, in vec4f. */
function storedWeights(decoders, storesAll) {
  const stored = Object.entries(decoders).filter(([, { uniform }]) => storesAll || !uniform), weightsAt = {};
  const weights = new Float32Array(stored.reduce((sum, [, decoder]) => sum + decoder.weights.length, 0));
  let at = 0;
  for (const [form, decoder] of stored) {
    weights.set(decoder.weights, at);
    weightsAt[form] = at / 4;
    at += decoder.weights.length;
  }
  return { weights, weightsAt };
}

/** Of an instance's matrix. three.js before 0.187, which has no referenceAttribute, has a program for each InstancedMesh. */
function columnsOf({ instanceMatrix }) {
  const matrix = tsl.referenceAttribute?.("instanceMatrix", "mat4");
  if (matrix) return [0, 1, 2].map((k) => matrix.element(k));
  const all = new InstancedInterleavedBuffer(instanceMatrix.array, 16);
  return [0, 1, 2].map((k) => tsl.instancedDynamicBufferAttribute(all, "vec4", 16, 4 * k));
}

/** Tells RnaLighting of the environment, of the scene or of the material: a node that is asked along a direction. */
class Environment extends LightingNode {
  constructor(node) {
    super();
    this.node = node;
  }

  setup({ context, material }) {
    const image = this.node.isMaterialReferenceNode ? material.envMap : this.node.value;
    context.rnaEnvironment = image ? pmremTexture(image) : this.node;
  }
}

/** The WGSL's functions, as nodes. `begin` says where the fragment is, for all that follow: 0 where there is nothing. */
function functionsOf(source, buffers, emits) {
  const all = wgsl(source, buffers), primitive = attribute("rnaPrimitive", "uint");
  const make = (head, body) => wgslFn(`fn ${MARK}${head} {\n    return ${body};\n}`, [all]);
  const begin = make("begin(primitive: u32, x: vec3f, wo: vec3f, width: f32) -> f32", "begin(primitive, x, wo, width)");
  const selfVisibility = make("self_visibility(wi: vec3f, entry: bool) -> vec2f", "self_visibility(wi, entry)");
  const emitted = emits && make("emitted(primitive: u32, x: vec3f, wo: vec3f) -> vec3f", "emitted(primitive, x, wo)");
  return {
    begin: (x, wo, width) => begin(primitive, x, wo, width),
    selfVisibility: (wi, entry) => selfVisibility(wi, bool(entry)),
    sent: make("sent(wi: vec3f, visibility: f32, far: f32, columns: f32, turn: f32) -> vec3f", "sent(wi, visibility, far, columns, turn)"),
    direction: make("direction(number: f32, count: f32, turn: f32) -> vec4f", "direction_about(number, count, turn)"),
    emitted: (wo) => emitted(primitive, positionGeometry, wo),
  };
}
