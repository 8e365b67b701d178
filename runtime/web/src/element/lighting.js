// What lights the asset: a sun and an environment, turned together; or the lights of a scene file.
import { environmentTables, evenImage, studioImage } from "../light/environment.js";
import { firstLight } from "../light/first_light.js";

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
    const image = this.images.get(this.choice);
    image.tables ??= environmentTables(image.make());
    return image.tables;
  }

  /** Whether the first look's lights of the image that is chosen are known, or not wanted. */
  get isPrepared() {
    return !(this.strength > 0) || !!this.images.get(this.choice).first;
  }

  async prepare() {
    const image = this.images.get(this.choice);
    image.first ??= await (image.finding ??= firstLight(image.make()));
  }

  /** Lights of a first look, once it is prepared: suns, brightest places of the environment, and the rest of it for lobes; null without one. */
  firstLights() {
    if (!(this.strength > 0)) return null;
    const { lights, rest, up } = this.images.get(this.choice).first, angle = this._turn(), scaled = (rgb) => rgb.map((value) => value * this.strength);
    const places = lights.map(({ direction, colour }) => ({ kind: "sun", direction: turn(direction, angle), colour: scaled(colour) }));
    return [...this._suns(), ...places, { kind: "mirror", colour: scaled(up), radiance: scaled([1, 1, 1]), turn: angle, rest }];
  }

  /** { lights, irradiance }: for shaders, and what falls on a plane that faces +y. Angles in degrees. */
  lights() {
    const lights = this._suns(), up = [0, 0, 0];
    for (const { direction, colour } of lights) colour.forEach((value, c) => { up[c] += value * Math.max(0, direction[1]); });
    if (this.strength > 0) {
      const colour = [this.strength, this.strength, this.strength];
      const angle = this._turn();
      // One light, sampled in two ways, which share it.
      lights.push({ kind: "environment", colour, angle }, { kind: "aroundPoint", colour, angle });
      this.tables().up.forEach((value, c) => { up[c] += value * this.strength; });
    }
    return { lights, irradiance: up };
  }

  /** Of the environment's image, radians. */
  _turn() {
    return (this.rotation + this.turntable + this.imageTurn) * RADIANS;
  }

  _suns() {
    const all = (this.rotation + this.turntable) * RADIANS;
    return (this.suns ?? [this._sun()]).filter(({ irradiance }) => irradiance.some((value) => value > 0))
      .map(({ direction, irradiance }) => ({ kind: "sun", direction: turn(direction, all), colour: irradiance }));
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
