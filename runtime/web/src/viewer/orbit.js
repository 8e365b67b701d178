// Where the camera is: on a sphere about the point that it looks at. Angles in radians.
import { Vector3 } from "three";

const STEEPEST = (89 * Math.PI) / 180;

export class Orbit {
  constructor() {
    Object.assign(this, { target: new Vector3(), azimuth: 0.6, elevation: 0.35, distance: 1, fov: 30 });
  }

  /** The whole box in sight. */
  frame({ min, max }, aspect) {
    const low = new Vector3(...min), high = new Vector3(...max);
    this.target.addVectors(low, high).multiplyScalar(0.5);
    const radius = low.distanceTo(high) / 2 || 1, half = (this.fov * Math.PI) / 360;
    const narrow = Math.min(half, Math.atan(Math.tan(half) * aspect));
    this.distance = (0.92 * radius) / Math.sin(narrow);
    this.size = radius;
  }

  lookFrom(position, lookAt, fov) {
    const offset = new Vector3(...position).sub(new Vector3(...lookAt));
    this.target.set(...lookAt);
    this.distance = offset.length();
    this.azimuth = Math.atan2(offset.x, offset.z);
    this.elevation = Math.asin(offset.y / this.distance);
    if (fov) this.fov = fov;
  }

  get position() {
    const level = Math.cos(this.elevation);
    return new Vector3(
      level * Math.sin(this.azimuth), Math.sin(this.elevation), level * Math.cos(this.azimuth),
    ).multiplyScalar(this.distance).add(this.target);
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, this.elevation + elevation));
  }

  zoom(factor) {
    this.distance = Math.min(1e4 * this.size, Math.max(1e-3 * this.size, this.distance * factor));
  }

  /** Along the image, in heights of the image. */
  pan(right, up) {
    const { forward, side, above } = this._axes();
    const height = 2 * this.distance * Math.tan((this.fov * Math.PI) / 360);
    this.target.addScaledVector(side, right * height).addScaledVector(above, up * height);
    return forward;
  }

  /** What shaders make rays of, for an image of this size. */
  camera(width, height) {
    const { forward, side, above } = this._axes(), half = Math.tan((this.fov * Math.PI) / 360);
    const wide = (half * width) / height;
    const corner = forward.clone().addScaledVector(side, -wide).addScaledVector(above, half);
    return {
      position: this.position.toArray(), corner: corner.toArray(),
      stepX: side.clone().multiplyScalar((2 * wide) / width).toArray(),
      stepY: above.clone().multiplyScalar((-2 * half) / height).toArray(),
    };
  }

  _axes() {
    const forward = this.target.clone().sub(this.position).normalize();
    const side = forward.clone().cross(new Vector3(0, 1, 0)).normalize();
    return { forward, side, above: side.clone().cross(forward) };
  }
}
