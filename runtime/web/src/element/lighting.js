// What lights the asset: a sun and an environment, turned together; or the lights of a scene file.
import { environmentTables, evenImage, studioImage } from "../light/environment.js";

const BUILT_IN = { studio: ["Studio", studioImage], white: ["White from all sides", () => evenImage([1, 1, 1])] };
const SUN_COLOUR = [1.06, 1.0, 0.9];
const RADIANS = Math.PI / 180;

export class Lighting {
  /** turntable: by how much camera and lights are turned about the asset, which seems to turn itself. */
  constructor() {
    this.images = new Map(Object.entries(BUILT_IN).map(([key, [label, make]]) => [key, { label, make }]));
    this.choice = "studio";
    this.turntable = 0;
    this.reset();
  }

  /** suns: in place of the one that is given by angles and brightness; null for that one. */
  reset() {
    Object.assign(this, { rotation: 0, sunHeight: 45, sunAzimuth: 40, sun: 2, strength: 1, suns: [], imageTurn: 0 });
  }

  /** Another image to choose; its key. */
  add(label, image) {
    const key = `image-${this.images.size}`;
    this.images.set(key, { label, make: () => image });
    return key;
  }

  /** The tables of the environment that is chosen. */
  tables() {
    const own = this.images.get(this.choice);
    own.tables ??= environmentTables(own.make());
    return own.tables;
  }

  /** { lights, irradiance }: for shaders, and what falls on a plane that faces +y. Angles in degrees. */
  lights() {
    const lights = [], up = [0, 0, 0], all = (this.rotation + this.turntable) * RADIANS;
    for (const { direction, irradiance } of this.suns ?? [this._sun()]) {
      if (!irradiance.some((value) => value > 0)) continue;
      const turned = turn(direction, all);
      lights.push({ kind: "sun", direction: turned, colour: irradiance });
      irradiance.forEach((value, c) => { up[c] += value * Math.max(0, turned[1]); });
    }
    if (this.strength > 0) {
      const colour = [this.strength, this.strength, this.strength];
      const angle = all + this.imageTurn * RADIANS;
      // One light, sampled in two ways, which share it.
      lights.push({ kind: "environment", colour, angle }, { kind: "aroundPoint", colour, angle });
      this.tables().up.forEach((value, c) => { up[c] += value * this.strength; });
    }
    return { lights, irradiance: up };
  }

  _sun() {
    const height = this.sunHeight * RADIANS, azimuth = this.sunAzimuth * RADIANS;
    return {
      direction: [Math.cos(height) * Math.sin(azimuth), Math.sin(height), Math.cos(height) * Math.cos(azimuth)],
      irradiance: SUN_COLOUR.map((value) => value * this.sun),
    };
  }
}

/** About +y, counter-clockwise seen from above, as the environment's image is turned. */
function turn([x, y, z], angle) {
  const c = Math.cos(angle), s = Math.sin(angle), size = Math.hypot(x, y, z);
  return [(c * x + s * z) / size, y / size, (c * z - s * x) / size];
}
