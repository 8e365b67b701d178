// An asset in a scene: a mesh for each part; each picture takes the tier that is good enough for its size.
import { Box3, BufferAttribute, BufferGeometry, Color, Group, InstancedMesh, Matrix4, Mesh, Sphere, Vector2, Vector3 } from "three/webgpu";
import { variantsOf } from "../package/extensions.js";
import { pictureOf } from "../package/images.js";
import { keepPipelines } from "./kept_pipelines.js";
import { MARK, RnaMaterial, SharedBuffers } from "./material.js";
import { optionsOf } from "./options.js";
import { PartRays } from "./raycast.js";
import { hasWebGPU } from "./stand_in.js";
import { chooseTier } from "./tiers.js";

const HEIGHT = 1080;  // of a first picture in a worker, pixels
const centre = /*@__PURE__*/ new Vector3(), eye = /*@__PURE__*/ new Vector3(), size = /*@__PURE__*/ new Vector2();

/** Data that copies of an asset share. */
class Content {
  constructor(data, options) {
    Object.assign(this, { data, options, users: new Set(), materials: new Map(), renderers: new Set(), rays: [] });
    this.buffers = new SharedBuffers(data.geometry);
    this.geometries = data.parts.map(geometryOf);
    this.sphere = new Box3(new Vector3(...data.box.min), new Vector3(...data.box.max)).getBoundingSphere(new Sphere());
  }

  raysOf(k) {
    return (this.rays[k] ??= new PartRays(this.data.geometry, this.data.parts[k]));
  }

  materialsOf(tier) {
    if (!this.materials.has(tier)) {
      const { parts } = this.data.tiers.find(({ name }) => name === tier);
      this.materials.set(tier, parts.map((part, k) => new RnaMaterial(this.buffers, this.data.parts[k].kind, part, this.options)));
    }
    return this.materials.get(tier);
  }

  dispose() {
    for (const renderer of this.renderers) keepPipelines(renderer, MARK);
    this.renderers.clear();
    this.buffers.dispose();
    for (const geometry of this.geometries) geometry.dispose();
    for (const materials of this.materials.values()) for (const material of materials) material.dispose();
    this.materials.clear();
  }
}

export class RnaAsset extends Group {
  /** data: what `readAsset` gives, or the content of another one. */
  constructor(data, options = {}) {
    super();
    this.content = data instanceof Content ? data : new Content(data, optionsOf(options));
    this.content.users.add(this);
    const { name, parts, tiers, notes, manifest } = this.content.data;
    Object.assign(this, { isRnaAsset: true, type: "RnaAsset", name, manifest, height: (globalThis.innerHeight ?? HEIGHT) * (globalThis.devicePixelRatio ?? 1) });
    // three.js calls `update` of objects with these once a picture, as of its own THREE.LOD; of those with isGroup it does not.
    Object.assign(this, { isLOD: true, autoUpdate: true, isGroup: false, choice: "auto" });
    this.shown = tiers[0].name;
    const materials = this.content.materialsOf(this.shown);
    this.meshes = parts.map((part, k) => this._mesh(part, k, materials[k]));
    this.add(...this.meshes);
    for (const note of notes) console.warn(`rna-three: ${name}: ${note}`);
  }

  get tiers() {
    return this.content.data.tiers.map(({ name }) => name);
  }

  get tier() {
    return this.choice;
  }

  /** "auto", or the name of a tier. */
  set tier(name) {
    const names = ["auto", ...this.tiers];
    if (!names.includes(name)) throw new Error(`tier: expected ${names.join(" or ")}, found ${JSON.stringify(name)}`);
    this.choice = name;
  }

  /** Names of the package's variants, for the loader's `setVariant`. */
  get variants() {
    return variantsOf(this.manifest).map(({ name }) => name);
  }

  /** The names of the images of base colour, for `setMap`. */
  get maps() {
    return this.content.buffers.surfaces.labels;
  }

  /**
   * Another picture, a Blob, ImageBitmap, canvas, image or three.js texture of one, in place of those with that label; null: the
   * package's own. Copies share it.
   */
  async setMap(label, picture) {
    const { buffers } = this.content;
    if (!this.maps.includes(label)) throw new Error(`setMap: expected ${this.maps.join(" or ") || "an asset with base colour"}, found ${JSON.stringify(label)}`);
    await buffers.surfaces.setImage(label, picture && (await pictureOf(picture.isTexture ? picture.image : picture)));
    buffers.print();
  }

  /** A factor of all base colours: a THREE.Color, or what makes one. Copies share it. */
  setTint(color) {
    const { buffers } = this.content;
    if (!buffers.images) throw new Error("setTint: expected an asset with base colour");
    buffers.surfaces.tint = new Color(color).toArray();
    buffers.print();
  }

  /** Chooses the tier; the picture's height is the previous picture's, at first the window's. */
  update(camera) {
    if (isShadowPass(rootOf(this))) return;
    const wanted = this.choice === "auto" ? chooseTier(this.content.data.tiers, this.content.options.maxError, this.pixels(camera)) : this.choice;
    if (wanted === this.shown) return;
    const materials = this.content.materialsOf(wanted);
    this.meshes.forEach((mesh, k) => {
      if (mesh.material.isRnaMaterial) mesh.material = materials[k];
    });
    this.shown = wanted;
  }

  /** Height in the image of the sphere about the asset. */
  pixels(camera) {
    const { sphere } = this.content, radius = sphere.radius * this.matrixWorld.getMaxScaleOnAxis();
    const distance = centre.copy(sphere.center).applyMatrix4(this.matrixWorld).distanceTo(eye.setFromMatrixPosition(camera.matrixWorld));
    const away = camera.isOrthographicCamera ? 1 : Math.max(distance, radius);
    return (radius / away) * camera.projectionMatrix.elements[5] * this.height;
  }

  /** An InstancedMesh of each part, in the tier that is shown, whose geometry and decoders it shares. */
  instanced(count) {
    return this.meshes.map(({ geometry, material, name, castShadow, receiveShadow, onBeforeRender }, k) => {
      const mesh = new InstancedMesh(geometry, material, count), place = new Matrix4();
      mesh.raycast = (raycaster, hits) => {
        for (let instanceId = 0; instanceId < mesh.count; instanceId++) {
          mesh.getMatrixAt(instanceId, place);
          this.content.raysOf(k).raycast(mesh, place.premultiply(mesh.matrixWorld), raycaster, hits, { instanceId });
        }
      };
      return Object.assign(mesh, { name, castShadow, receiveShadow, onBeforeRender });
    });
  }

  /** With what was added to it; shares the geometry and the decoders; each is disposed of by itself. */
  clone(recursive) {
    return new this.constructor(this.content).copy(this, recursive);
  }

  copy(source, recursive = true) {
    super.copy(source, false);
    Object.assign(this, { choice: source.choice, shown: source.shown });
    this.meshes.forEach((mesh, k) => mesh.copy(source.meshes[k], recursive));
    const added = source.children.filter((child) => !source.meshes.includes(child));
    if (recursive) for (const child of added) this.add(child.clone());
    return this;
  }

  /** Lets go of everything on the GPU, once no copy is left. It stays in the scene, as three.js' own objects do. */
  dispose() {
    const { users } = this.content;
    if (users.delete(this) && !users.size) this.content.dispose();
  }

  _mesh(part, k, material) {
    const mesh = new Mesh(this.content.geometries[k], material);
    Object.assign(mesh, { name: part.name, castShadow: true, receiveShadow: true });
    mesh.raycast = (raycaster, hits) => this.content.raysOf(k).raycast(mesh, mesh.matrixWorld, raycaster, hits);
    mesh.onBeforeRender = (renderer, scene) => {
      if (!isShadowPass(scene)) this.height = renderer.getRenderTarget()?.height ?? renderer.getDrawingBufferSize(size).y;
      if (hasWebGPU(renderer)) this.content.renderers.add(renderer);
    };
    return mesh;
  }
}

const rootOf = (object) => (object.parent ? rootOf(object.parent) : object);
/** Whether three.js draws a shadow map just now, with a camera of its own. */
const isShadowPass = (scene) => scene.overrideMaterial?.isShadowPassMaterial === true;

function geometryOf({ position, normal, primitive, index }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("normal", new BufferAttribute(normal, 3));
  geometry.setAttribute("rnaPrimitive", new BufferAttribute(primitive, 1));
  if (index) geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}
