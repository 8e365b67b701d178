// Attributes of the element as values, in model-viewer's syntax, and values as attributes. What cannot be read throws a
// line that says what is expected.
import { linearColour } from "./backdrop.js";
import { steep } from "./orbit.js";
import { readTexts } from "./texts.js";

const RADIANS = Math.PI / 180;
const ANGLES = { deg: RADIANS, rad: 1 }, LENGTHS = { m: 1, cm: 0.01, mm: 0.001 }, SHARES = { "%": 0.01 };

function expected(form, text) {
  throw new Error(`expected ${form}, found ${JSON.stringify(text)}`);
}

/** A number with one of these units, in radians, metres or shares; null if it is none. */
function quantity(word, units) {
  const [, number, unit] = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(word) ?? [];
  return Object.hasOwn(units, unit ?? "") ? Number(number) * units[unit] : null;
}

/** Words of a text, each read by its reader; "auto" is null. */
function words(text, form, readers) {
  const list = text.trim().split(/\s+/);
  if (list.length !== readers.length) expected(form, text);
  return list.map((word, k) => (word === "auto" ? null : readers[k](word) ?? expected(form, text)));
}

const angle = (word) => quantity(word, ANGLES), length = (word) => quantity(word, LENGTHS);
const number = (low, high, whole = false) => (text) => {
  const value = Number(text), fits = text.trim() !== "" && value >= low && value <= high && (!whole || Number.isInteger(value));
  return fits ? value : expected(`a ${whole ? "whole " : ""}number from ${low} to ${high}`, text);
};
const choice = (...names) => (text) => (names.includes(text) ? text : expected(names.join(" or "), text));
const text = (value) => value;
/** Of a file; an empty one, as templates write it, is none. */
const address = (value) => value.trim() || null;
/** True where the attribute is present, except for "false", which Vue and Svelte write for a false value. */
export const flag = (value) => value !== "false";

function cameraOrbit(value) {
  const radius = (word) => length(word) ?? quantity(word, SHARES);
  const [azimuth, polar, distance] = words(value, "THETA PHI RADIUS, as 45deg 75deg 2m", [angle, angle, radius]);
  const isShare = value.trim().endsWith("%");
  return {
    azimuth, elevation: polar === null ? null : steep(Math.PI / 2 - polar),
    distance: isShare ? null : distance, share: isShare ? distance : null,
  };
}

export const cameraTarget = (value) => words(value, "X Y Z, as 0m 0.5m 0m", [length, length, length]);

function fieldOfView(value) {
  const [radians] = words(value, "an angle, as 30deg", [angle]);
  return radians === null ? null : Math.min(170, Math.max(1, radians / RADIANS));
}

/** Degrees. */
const turn = (value) => words(value, "an angle, as 90deg", [angle])[0] / RADIANS;

function sunLight(value) {
  if (value.trim() === "none") return { sun: 0 };
  const plain = (word) => (word >= 0 ? Number(word) : null);
  const [azimuth, height, brightness] = words(value, "none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2", [angle, angle, plain]);
  return { sunAzimuth: (azimuth ?? 40 * RADIANS) / RADIANS, sunHeight: (height ?? 45 * RADIANS) / RADIANS, sun: brightness ?? 2 };
}

/** By label its address. */
function addresses(value) {
  const pairs = value.trim().split(/\s+/).filter(Boolean).map((word) => [word.slice(0, word.indexOf("=")), word.slice(word.indexOf("=") + 1)]);
  if (pairs.some(([label, address]) => !label || !address)) expected("LABEL=ADDRESS ..., as label=label-de.png", value);
  return Object.fromEntries(pairs);
}

/** Linear RGB. */
function tintColour(value) {
  const rgb = value.trim().split(/\s+/).map(Number), isColour = globalThis.CSS?.supports("color", value);
  if (rgb.length === 3 && rgb.every((one) => one >= 0 && one < Infinity)) return rgb;
  return (isColour && linearColour(value)) || expected("a colour, or R G B of linear light, as 1 0.5 0.2", value);
}

/** By attribute: how its text is read. */
export const READERS = {
  src: address, glass: address, alt: text, poster: address, scene: address, environment: address, tier: text, "variant-name": text,
  loading: choice("auto", "lazy", "eager"), reveal: choice("auto", "manual"),
  "camera-orbit": cameraOrbit, "camera-target": cameraTarget, "field-of-view": fieldOfView,
  "min-camera-orbit": cameraOrbit, "max-camera-orbit": cameraOrbit, "min-field-of-view": fieldOfView, "max-field-of-view": fieldOfView,
  sun: sunLight, "light-rotation": turn, "environment-intensity": number(0, 1e6), ground: flag, skybox: flag,
  exposure: number(-30, 30), "view-transform": choice("srgb", "filmic"),
  "camera-controls": flag, "disable-zoom": flag, "disable-pan": flag, "disable-light": flag,
  "touch-action": choice("pan-y", "pan-x", "none"), "wheel-zoom": choice("focus", "always"), "interaction-prompt": choice("auto", "none"), "interpolation-decay": number(0, 1e5),
  "auto-rotate": flag, "auto-rotate-delay": number(0, 1e9), "rotation-per-second": turn,
  samples: number(1, 1e6, true), "pixel-ratio": number(0.1, 8), jitter: number(0, 1),
  "first-look": choice("auto", "off"), maps: addresses, tint: tintColour, messages: choice("calm", "whole"), texts: readTexts,
};

/** The name of an attribute's property, as cameraOrbit. */
export const propertyOf = (attribute) => attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** Without digits that nobody needs. */
const plain = (value) => String(Number(value.toPrecision(6)));
const degrees = (value) => `${plain(value)}deg`, metres = (value) => `${plain(value)}m`;

/** Attributes that show a camera again. */
export function cameraText({ azimuth, elevation, distance, target, fov }) {
  const turned = azimuth / RADIANS, theta = turned - 360 * Math.round(turned / 360);
  return {
    cameraOrbit: `${degrees(theta)} ${degrees(90 - elevation / RADIANS)} ${metres(distance)}`,
    cameraTarget: target.map(metres).join(" "), fieldOfView: degrees(fov),
  };
}

/** Attributes that show a light again. */
export function lightText({ rotation, strength, suns, sun, sunAzimuth, sunHeight }) {
  return {
    sun: suns || !(sun > 0) ? "none" : `${degrees(sunAzimuth)} ${degrees(sunHeight)} ${plain(sun)}`,
    lightRotation: degrees(rotation), environmentIntensity: plain(strength),
  };
}
