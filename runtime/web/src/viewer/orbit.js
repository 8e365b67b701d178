// Where the camera is: on a sphere about the point that it looks at. Angles in radians.

const STEEPEST = (89 * Math.PI) / 180;
const FILLED = 0.95;  // of the image's height or width, by a box that is framed

/** a + factor * b */
const plus = (a, b, factor = 1) => a.map((value, k) => value + factor * b[k]);
const times = (a, factor) => a.map((value) => value * factor);
const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const unit = (a) => times(a, 1 / Math.hypot(...a));
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

export class Orbit {
  constructor() {
    Object.assign(this, { target: [0, 0, 0], azimuth: 0.6, elevation: 0.35, distance: 1, fov: 30 });
  }

  /** All corners of the box in sight, as near as that goes, from where the camera is. */
  frame({ min, max }, aspect) {
    this.target = times(plus(min, max), 0.5);
    this.size = Math.hypot(...plus(max, min, -1)) / 2 || 1;
    this.distance = this.size;  // any: for the axes
    const { forward, side, above } = this._axes(), half = FILLED * Math.tan((this.fov * Math.PI) / 360);
    const corners = Array.from({ length: 8 }, (_, k) =>
      plus([0, 1, 2].map((axis) => ((k >> axis) & 1 ? max : min)[axis]), this.target, -1));
    const far = corners.map((corner) =>
      Math.max(Math.abs(dot(corner, above)), Math.abs(dot(corner, side)) / aspect) / half - dot(corner, forward));
    this.distance = Math.max(...far) || this.size;
  }

  lookFrom(position, lookAt, fov) {
    const offset = plus(position, lookAt, -1);
    this.target = lookAt;
    this.distance = Math.hypot(...offset);
    this.azimuth = Math.atan2(offset[0], offset[2]);
    this.elevation = Math.asin(offset[1] / this.distance);
    if (fov) this.fov = fov;
  }

  get position() {
    const level = Math.cos(this.elevation);
    const away = [level * Math.sin(this.azimuth), Math.sin(this.elevation), level * Math.cos(this.azimuth)];
    return plus(this.target, away, this.distance);
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
    const { side, above } = this._axes(), height = 2 * this.distance * Math.tan((this.fov * Math.PI) / 360);
    this.target = plus(plus(this.target, side, right * height), above, up * height);
  }

  /** What shaders make rays of, for an image of this size. */
  camera(width, height) {
    const { forward, side, above } = this._axes(), half = Math.tan((this.fov * Math.PI) / 360);
    const wide = (half * width) / height;
    return {
      position: this.position, corner: plus(plus(forward, side, -wide), above, half),
      stepX: times(side, (2 * wide) / width), stepY: times(above, (-2 * half) / height),
    };
  }

  _axes() {
    const forward = unit(plus(this.target, this.position, -1)), side = unit(cross(forward, [0, 1, 0]));
    return { forward, side, above: cross(side, forward) };
  }
}
