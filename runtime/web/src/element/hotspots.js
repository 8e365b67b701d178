// Children of the element that stay at places of the asset, and are hidden behind it: slot="hotspot-NAME" with
// data-position and data-normal, as model-viewer has them.
import { nearestHit } from "../geometry/nearest_hit.js";
import { dot, minus, unit } from "../vectors.js";
import { cameraTarget } from "./attributes.js";

const NEAR = 2e-3;  // of the distance: a hit nearer than the place by more hides it
const WATCHED = { childList: true, subtree: true, attributes: true, attributeFilter: ["slot", "data-position", "data-normal"] };

/** The direction of the ray through a place of the picture, shares of its width and height from the upper left. */
export function rayThrough({ corner, stepX, stepY, width, height }, x, y) {
  return unit(corner.map((value, k) => value + x * width * stepX[k] + y * height * stepY[k]));
}

/** Where a point is in the picture, in shares; null behind the camera. */
function placeOf({ position, corner, stepX, stepY, width, height }, point) {
  const across = stepX.map((value) => value * width), down = stepY.map((value) => value * height), from = minus(point, position);
  const share = (axis, v) => dot(v, axis) / dot(axis, axis);
  const forward = corner.map((value, k) => value + 0.5 * (across[k] + down[k])), depth = share(forward, from);
  return depth > 0 ? [0.5 + share(across, from) / depth, 0.5 + share(down, from) / depth] : null;
}

export class Hotspots {
  /** host: whose children they are. place: what their slots go into. */
  constructor(host, place, stage) {
    Object.assign(this, { host, place, stage });
    new MutationObserver(() => this.update()).observe(host, WATCHED);
    stage.addEventListener("shown", () => this.update());
  }

  /** By name: { position, normal }; those that cannot be read are left out, with a line. */
  _known() {
    const known = new Map(), problems = [];
    for (const child of this.host.querySelectorAll(':scope > [slot^="hotspot"]')) {
      try {
        const { position, normal } = child.dataset;
        known.set(child, { position: placed(position ?? ""), normal: normal === undefined ? null : placed(normal) });
      } catch (error) {
        problems.push(`${child.slot}: ${error.message}`);
      }
    }
    this.stage.notices.say(problems.join("; "), true, "hotspots");
    return known;
  }

  /** All of them to where the picture that is shown has them. */
  update() {
    const known = this._known(), slots = new Set([...known.keys()].map(({ slot }) => slot)), camera = this.stage.shownCamera;
    for (const slot of [...this.place.children]) if (!slots.has(slot.name)) slot.remove();
    for (const [child, spot] of known) {
      const slot = this._slot(child.slot), at = camera && placeOf(camera, spot.position), isSeen = !!at && this._isSeen(camera, spot);
      slot.classList.toggle("unseen", !isSeen);
      if (at) Object.assign(slot.style, { left: `${100 * at[0]}%`, top: `${100 * at[1]}%` });
      if (child.dataset.visibilityAttribute) child.toggleAttribute(`data-${child.dataset.visibilityAttribute}`, isSeen);
    }
  }

  _slot(name) {
    const there = [...this.place.children].find((slot) => slot.name === name);
    if (there) return there;
    const made = Object.assign(document.createElement("slot"), { name });
    this.place.append(made);
    return made;
  }

  /** Whether it faces the camera, and nothing of the asset is in between. */
  _isSeen({ position }, spot) {
    const away = minus(spot.position, position), distance = Math.hypot(...away);
    if (spot.normal && dot(spot.normal, away) >= 0) return false;
    const { hitArrays } = this.stage, hit = hitArrays && nearestHit(hitArrays, position, unit(away));
    return !hit || hit.distance > (1 - NEAR) * distance;
  }
}

function placed(text) {
  const vector = cameraTarget(text);
  if (vector.includes(null)) throw new Error(`expected X Y Z, as 0m 0.5m 0m, found ${JSON.stringify(text)}`);
  return vector;
}
