// A picture that loses the noise of environments while nothing moves: the mean of pictures that ask other directions.
import { FloatType, HalfFloatType, MeshBasicNodeMaterial, NearestFilter, NoBlending, QuadMesh, RenderTarget, Vector2 } from "three/webgpu";
import { mix, texture, uniform } from "three/tsl";
import { turnOfPicture } from "./samples.js";

const GOLDEN = 0.6180339887498949;

export class StillPicture {
  /** pictures: of the mean, after which nothing is drawn any more. */
  constructor(renderer, scene, camera, { pictures = 64 } = {}) {
    Object.assign(this, { renderer, scene, camera, pictures, count: 0, size: new Vector2(), state: [] });
    this.picture = new RenderTarget(1, 1, { type: HalfFloatType, samples: 4 });
    this.means = [0, 1].map(() => new RenderTarget(1, 1, { type: FloatType, depthBuffer: false, minFilter: NearestFilter, magFilter: NearestFilter }));
    this.before = texture(this.means[0].texture);
    this.share = uniform(1);
    this.adding = quadOf(mix(this.before, texture(this.picture.texture), this.share));
    this.mean = texture(this.means[0].texture);
    this.showing = quadOf(this.mean);
  }

  /** In the place of renderer.render(scene, camera), with the renderer's tone mapping, to its target. */
  render() {
    const { renderer, scene, camera } = this, target = renderer.getRenderTarget();
    this._resize(target);
    scene.updateMatrixWorld();
    if (!camera.parent) camera.updateMatrixWorld();
    if (this._hasChanged()) this.restart();
    if (this.count < this.pictures) this._add();
    renderer.setRenderTarget(target);
    this.mean.value = this.means[this.count % 2].texture;
    this.showing.render(renderer);
  }

  /** After a change that is none of places and lights, as of a material or of an image. */
  restart() {
    this.count = 0;
  }

  dispose() {
    for (const target of [this.picture, ...this.means]) target.dispose();
    for (const { material } of [this.adding, this.showing]) material.dispose();
  }

  _add() {
    const { renderer, count } = this;
    turnOfPicture.value = (count * GOLDEN) % 1;
    renderer.setRenderTarget(this.picture);
    renderer.render(this.scene, this.camera);
    turnOfPicture.value = 0;
    this.before.value = this.means[count % 2].texture;
    this.share.value = 1 / (count + 1);
    this.count += 1;
    renderer.setRenderTarget(this.means[this.count % 2]);
    this.adding.render(renderer);
  }

  _resize(target) {
    const { x, y } = this.size, { width, height } = target ?? this.renderer.getDrawingBufferSize(new Vector2());
    if (x === width && y === height) return;
    this.size.set(width, height);
    for (const own of [this.picture, ...this.means]) own.setSize(width, height);
    this.restart();
  }

  /** Whether camera, objects or lights are other ones than in the last call, or elsewhere. */
  _hasChanged() {
    const { scene, camera } = this, state = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements, scene.environmentIntensity, ...scene.environmentRotation.toArray()];
    scene.traverseVisible(({ id, matrixWorld, intensity, color }) => state.push(id, ...matrixWorld.elements, intensity, color?.getHex()));
    const isSame = state.length === this.state.length && state.every((value, k) => value === this.state[k]);
    this.state = state;
    return !isSame;
  }
}

/** A material that fills a target with this colour, as it is. */
function quadOf(colorNode) {
  return new QuadMesh(Object.assign(new MeshBasicNodeMaterial(), { colorNode, blending: NoBlending, depthTest: false, depthWrite: false, fog: false }));
}
