// Where the camera is: on a sphere about the point that it looks at. Angles in radians.
import { clamp } from "../ui/elements.js";
import { cross, dot, plus, times, unit } from "../vectors.js";

// Posters have the same camera: rna_export/export/poster_rendering.py.
const HOME = { azimuth: 0.6, elevation: 0.35, fov: 30 };
const STEEPEST = (89 * Math.PI) / 180;
const FILLED = 0.95;  // of the image's height or width, by a box that is framed
const TURNS = Array.from({ length: 16 }, (_, k) => (k * Math.PI) / 8);

const AUTO = { azimuth: null, elevation: null, distance: null, share: null };
const NO_LIMITS = { low: AUTO, high: AUTO, lowFov: null, highFov: null };

/** The nearest elevation that has an "up" in the image. */
export const steep = (angle) => clamp(angle, -STEEPEST, STEEPEST);

/** Limits of a camera, from settings. */
export const limitsOf = ({ minCameraOrbit, maxCameraOrbit, minFieldOfView, maxFieldOfView }) =>
  ({ low: minCameraOrbit ?? AUTO, high: maxCameraOrbit ?? AUTO, lowFov: minFieldOfView, highFov: maxFieldOfView });

/** A view from a position; see place. */
export function viewFrom(position, target, fov) {
  const offset = plus(position, target, -1), distance = Math.hypot(...offset);
  return { azimuth: Math.atan2(offset[0], offset[2]), elevation: Math.asin(offset[1] / distance), distance, target, fov };
}

export class Orbit {
  /** turntable: by how much the asset is turned under camera and lights, which amounts to turning both the other way. */
  constructor() {
    Object.assign(this, { target: [0, 0, 0], distance: 1, framed: 1, size: 1, turntable: 0, ...HOME });
    this.limits = NO_LIMITS;
  }

  /**
   * Goes where `views` say, later ones first: azimuth, elevation, fov (degrees), target, and distance or `share` of the
   * framed one. What they leave out (null) is so that the box, if there is one, is in sight at each angle of the turntable.
   */
  place(views, box, aspect) {
    const given = views.map((view) => Object.fromEntries(Object.entries(view).filter(([, value]) => value != null)));
    const { azimuth, elevation, fov, target = [], distance, share = 1 } = Object.assign({}, HOME, ...given);
    const { lowFov, highFov } = this.limits;
    Object.assign(this, { azimuth, elevation, fov: clamp(fov, lowFov ?? 0, highFov ?? Infinity) });
    if (box) this.frame(box, aspect);
    this.framed = this.distance;
    this.distance = distance ?? share * this.framed;
    this.target = this.target.map((value, axis) => target[axis] ?? value);
    this.limit();
  }

  /** Back to where `limits` allow: low and high are as `views` of place; high ones of the polar angle are low elevations. */
  limit() {
    const { low, high, lowFov, highFov } = this.limits, far = ({ distance, share }) => distance ?? (share === null ? null : share * this.framed);
    this.azimuth = clamp(this.azimuth, low.azimuth ?? -Infinity, high.azimuth ?? Infinity);
    this.elevation = clamp(this.elevation, high.elevation ?? -STEEPEST, low.elevation ?? STEEPEST);
    this.distance = clamp(this.distance, far(low) ?? 1e-3 * this.size, far(high) ?? 1e4 * this.size);
    this.fov = clamp(this.fov, lowFov ?? 0, highFov ?? Infinity);
  }

  /** All corners of the box in sight from the camera's height, as near as that goes, however the box is turned. */
  frame({ min, max }, aspect) {
    this.target = times(plus(min, max), 0.5);
    this.size = Math.hypot(...plus(max, min, -1)) / 2 || 1;
    const half = FILLED * Math.tan((this.fov * Math.PI) / 360);
    const corners = Array.from({ length: 8 }, (_, k) =>
      plus([0, 1, 2].map((axis) => ((k >> axis) & 1 ? max : min)[axis]), this.target, -1));
    const far = TURNS.flatMap((angle) => {
      const { forward, side, above } = this._axes(angle);
      return corners.map((corner) =>
        Math.max(Math.abs(dot(corner, above)), Math.abs(dot(corner, side)) / aspect) / half - dot(corner, forward));
    });
    this.distance = Math.max(...far) || this.size;
  }

  get position() {
    return plus(this.target, this._away(this.turntable), this.distance);
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation += elevation;
    this.limit();
  }

  zoom(factor) {
    this.distance *= factor;
    this.limit();
  }

  /** Along the image, in heights of the image. */
  pan(right, up) {
    const { side, above } = this._axes(), height = 2 * this.distance * Math.tan((this.fov * Math.PI) / 360);
    this.target = plus(plus(this.target, side, right * height), above, up * height);
  }

  /** The view from which shaders make rays, for an image of this size. */
  camera(width, height) {
    const { forward, side, above } = this._axes(), half = Math.tan((this.fov * Math.PI) / 360);
    const wide = (half * width) / height;
    return {
      position: this.position, corner: plus(plus(forward, side, -wide), above, half),
      stepX: times(side, (2 * wide) / width), stepY: times(above, (-2 * half) / height),
    };
  }

  /** Towards the camera. */
  _away(turntable) {
    const level = Math.cos(this.elevation), azimuth = this.azimuth + turntable;
    return [level * Math.sin(azimuth), Math.sin(this.elevation), level * Math.cos(azimuth)];
  }

  _axes(turntable = this.turntable) {
    const forward = times(this._away(turntable), -1), side = unit(cross(forward, [0, 1, 0]));
    return { forward, side, above: cross(side, forward) };
  }
}
