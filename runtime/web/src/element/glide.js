// The camera glides to where it is placed: nearer by the same share in the same time, one step a picture that is seen.

const NEAR = 1e-3;  // of the way
const LONGEST_STEP = 100;  // ms: what follows a pause is no jump

const viewOf = ({ azimuth, elevation, distance, target, fov }) => ({ azimuth, elevation, distance, target, fov });
const mixed = (a, b, share) => (Array.isArray(a) ? a.map((value, k) => mixed(value, b[k], share)) : a + share * (b - a));

export class Glide {
  #stage;

  constructor(stage) {
    this.#stage = stage;
    this.goal = null;
    stage.addEventListener("shown", () => this._next());
  }

  /** Does `place`, which moves the camera, and has it glide there; decay: ms, 0 for none. */
  to(place, decay) {
    const { orbit } = this.#stage, from = viewOf(orbit);
    this.stop();
    place();
    const goal = viewOf(orbit), isSame = JSON.stringify(from) === JSON.stringify(goal);
    if (!(decay > 0) || isSame) return;
    // The shorter way around.
    const turns = Math.round((goal.azimuth - from.azimuth) / (2 * Math.PI));
    Object.assign(orbit, from, { azimuth: from.azimuth + 2 * Math.PI * turns });
    Object.assign(this, { goal, left: 1, decay, last: performance.now() });
    this.#stage.restart(true);
  }

  /** Leaves the camera where it is. */
  stop() {
    this.goal = null;
  }

  _next() {
    if (!this.goal || this.isRequested) return;
    this.isRequested = true;
    requestAnimationFrame((now) => {
      this.isRequested = false;
      if (this.goal) this._step(Math.min(LONGEST_STEP, Math.max(0, now - this.last)));
      this.last = now;
    });
  }

  _step(ms) {
    const { orbit } = this.#stage, { goal } = this, share = 1 - Math.exp(-ms / (2 * this.decay));
    this.left *= 1 - share;
    const isThere = this.left < NEAR, view = viewOf(orbit);
    Object.assign(orbit, isThere ? goal : Object.fromEntries(Object.keys(goal).map((name) => [name, mixed(view[name], goal[name], share)])));
    if (isThere) this.stop();
    this.#stage.restart(!isThere);
  }
}
