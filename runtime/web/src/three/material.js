// The node material of a part in one tier: rna_gpu's WGSL with the buffers that three.js binds.
import { DoubleSide, Euler, FrontSide, LightingNode, NodeMaterial, StorageBufferAttribute } from "three/webgpu";
import { attribute, bool, buffer, Fn, pmremTexture, positionGeometry, referenceAttribute, storage, wgsl, wgslFn } from "three/tsl";
import { fragmentOf, towardsViewer } from "./fragment.js";
import { RnaLighting, shadowPosition } from "./lighting.js";
import { partSource } from "./shader_source.js";
import { instanceColumns } from "./spaces.js";
import { hasWebGPU, STAND_IN, standInNode } from "./stand_in.js";

/** What the name of each function that three.js calls begins with. */
export const MARK = "rna_three_";

/** Buffers of all parts and tiers of an asset. */
export class SharedBuffers {
  constructor({ nodes, primitives, points, ...facts }) {
    this.facts = facts;
    this.nodes = new StorageBufferAttribute(nodes, 8);
    this.primitives = new StorageBufferAttribute(primitives, 4);
    this.points = new StorageBufferAttribute(points, 4);
  }

  dispose() {
    for (const own of [this.nodes, this.primitives, this.points]) own.dispose();
  }
}

const named = (own, type, name) => storage(own, type, own.count).toReadOnly().setName(name);

export class RnaMaterial extends NodeMaterial {
  static get type() {
    return "RnaMaterial";
  }

  /** options: those of RnaAsset. part: planes and decoders of a part in a tier. */
  constructor(shared, kind, { planes, transport, emission }, options) {
    super();
    this.given = [shared, kind, { planes, transport, emission }, options];
    Object.assign(this, { lights: true, side: kind === "fiber" ? FrontSide : DoubleSide, isRnaMaterial: true, options, kind });
    // As three.js' own have it: without a `null` here it leaves scene.environmentRotation out.
    Object.assign(this, { envMap: null, envMapIntensity: 1, envMapRotation: new Euler() });
    Object.assign(this, STAND_IN);
    this.receivedShadowPositionNode = shadowPosition;
    this.stored = [];
    const [xy, yz, zx] = planes.map((plane) => this._store(plane, 1));
    const buffers = [
      named(shared.nodes, "RnaNode", "rna_nodes"), named(shared.primitives, "RnaPrimitive", "rna_primitives"),
      named(shared.points, "vec4", "rna_points"),
      named(xy, "uint", "rna_plane_xy"), named(yz, "uint", "rna_plane_yz"), named(zx, "uint", "rna_plane_zx"),
      ...this._decoder(transport, "rna_"), ...(emission ? this._decoder(emission, "rnae_") : []),
    ];
    const groups = Math.max(transport.groups, emission?.groups ?? 0);
    this.functions = functionsOf(partSource({ kind, groups, emits: emission !== null, ...shared.facts }), buffers);
    this.fragment = fragmentOf(this);
    if (emission) this.emissiveNode = Fn((builder) => this.functions.emitted(towardsViewer(builder)))();
  }

  _store(array, items) {
    const own = new StorageBufferAttribute(array, items);
    this.stored.push(own);
    return own;
  }

  /** Up to 64 KiB the weights are uniform, which is faster. */
  _decoder({ record, weights, uniform }, prefix) {
    const name = `${prefix}weights`;
    return [
      buffer(new Float32Array(record.buffer), "RnaPart", 1).setName(`${prefix}part`),
      uniform ? buffer(weights, "vec4", weights.length / 4).setName(name) : named(this._store(weights, 4), "vec4", name),
    ];
  }

  /** Materials have buffers of their own, which three.js keeps with the program. */
  customProgramCacheKey() {
    return `${super.customProgramCacheKey()} ${this.uuid}`;
  }

  setup(builder) {
    const { fragmentNode } = this;
    if (!hasWebGPU(builder.renderer)) this.fragmentNode = standInNode();
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
      const matrix = referenceAttribute("instanceMatrix", "mat4");
      instanceColumns.forEach((column, k) => column.assign(matrix.element(k).xyz));
    }
    return result;
  }

  /** Shares the buffers, of which the asset's own material disposes. */
  clone() {
    return Object.assign(new this.constructor(...this.given).copy(this), { stored: [] });
  }

  dispose() {
    super.dispose();
    for (const own of this.stored) own.dispose();
  }
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
function functionsOf(source, buffers) {
  const all = wgsl(source, buffers), primitive = attribute("rnaPrimitive", "uint");
  const make = (head, body) => wgslFn(`fn ${MARK}${head} {\n    return ${body};\n}`, [all]);
  const begin = make("begin(primitive: u32, x: vec3f, wo: vec3f) -> f32", "begin(primitive, x, wo)");
  const own = make("own(wi: vec3f, entry: bool) -> vec2f", "self_visibility(wi, entry)");
  const emitted = make("emitted(primitive: u32, x: vec3f, wo: vec3f) -> vec3f", "emitted(primitive, x, wo)");
  return {
    begin: (x, wo) => begin(primitive, x, wo),
    own: (wi, entry) => own(wi, bool(entry)),
    sent: make("sent(wi: vec3f, visibility: f32) -> vec3f", "sent(wi, visibility)"),
    direction: make("direction(number: f32, count: f32, turn: f32) -> vec4f", "direction_about(number, count, turn)"),
    emitted: (wo) => emitted(primitive, positionGeometry, wo),
  };
}
