// The picture over time: a coarse one at once, then finer ones, then samples that are averaged. Work is cut into
// bands of rows, so that nothing holds up the page for long.

const BAND_MS = 120;
const MOVING_MS = 110;     // of a picture while something moves
const COARSEST = 16;
export const SHARP = 4;  // a picture of a quarter of the size, or finer: the first one where a poster is seen meanwhile
const NOISE = 0.4;         // of one sample, in values of the screen: differences that may be noise
const NOISY_ROUNDS = 12;   // from which on no noise is taken out
const LOOK_ROUNDS = 64;    // from which on nothing is left of the first look
const LOOK_WORTH = 8;      // samples that it is worth: in FLIP 7 for the toy
const EDGE_RAYS = [[1, 3], [-3, 1], [3, -1], [-1, -3]].map((shift) => shift.map((eighths) => eighths / 8));  // pixels
const DARKNESS = { kind: "sun", direction: [0, 1, 0], colour: [0, 0, 0] };

export class Viewer extends EventTarget {
  constructor(engine, canvas, orbit) {
    super();
    Object.assign(this, { engine, canvas, orbit });
    Object.assign(this, {
      lights: [], firstLights: null, sky: null, shownCamera: null, ground: null, exposure: 0, view: "srgb", denoise: true, rounds: 256, jitter: 1, generation: 0, msPerPixel: 0.005, shown: null, rowsAhead: 0,
      ready: false, stopped: false, moving: false, isHeld: false, resting: false, backdrop: null, coarsest: COARSEST, coarsestSeen: () => Infinity, stats: { ms: 0, rounds: 0 },
    });
    this.wake = null;
  }

  /** Starts the picture again, since something changed. `moving`: more changes will follow at once. coarsest: size, as one in so many. */
  restart(moving = false, coarsest = COARSEST) {
    Object.assign(this, { moving, coarsest, isHeld: false });
    Object.assign(this.stats, { rounds: 0, scale: 0, isSharp: false });
    this.generation += 1;
    this.wake?.();
  }

  /** No picture until a restart, since something moves that is seen elsewhere. */
  hold() {
    Object.assign(this, { moving: true, isHeld: true });
    this.generation += 1;
  }

  start() {
    this.ready = true;
    this.restart();
    this.running ??= this._run();  // last: a restart would throw its first picture away
  }

  pause() {
    this.ready = false;
    this.generation += 1;
  }

  /** Holds samples back; those that are there stay. */
  rest(on) {
    this.resting = on;
    if (!on) this.rouse?.();
  }

  stop() {
    this.stopped = true;
    this.rest(false);
    this.pause();
    this.wake?.();
    return this.running;
  }

  /** Resolves when there is a picture. */
  async pictured() {
    while (!this.shown) await this._nextPicture();
  }

  /** Resolves when the picture has `rounds` samples in full size. */
  async converged(rounds = this.rounds) {
    while (!(this.stats.scale === 1 && this.stats.rounds >= rounds)) await this._nextPicture();
  }

  _nextPicture() {
    return new Promise((resolve) => this.addEventListener("shown", resolve, { once: true }));
  }

  /** The picture as it is: rows of a sample that is under way count as many samples as they have. */
  show() {
    if (!this.shown) return;
    const { rounds, firstLook } = this.shown, noisy = this.denoise && rounds < NOISY_ROUNDS && !firstLook;
    this.engine.show({
      rounds, firstLook, rowsAhead: this.rowsAhead, exposure: 2 ** this.exposure, backdrop: this.backdrop ? [...this.backdrop, 1] : [0, 0, 0, 0], filmic: this.view === "filmic",
      spread: noisy ? NOISE / Math.sqrt(rounds) : 0, camera: this.shownCamera, sky: this.sky,
    });
  }

  async _run() {
    while (!this.stopped) {
      const generation = this.generation;
      try {
        if (this.ready) await this._picture(generation);
      } catch (error) {
        if (!this.engine.lost) this.dispatchEvent(Object.assign(new Event("failed"), { error }));
        this.ready = false;
      }
      if (generation === this.generation && !this.stopped) await new Promise((resolve) => { this.wake = resolve; });
    }
  }

  /** All sizes of the picture, until something changes. One of many that follow at once is finished: else none would be seen. */
  async _picture(generation) {
    this.isFleeting = this.moving;
    if (this.isHeld) return;
    for (const scale of this._scales()) {
      const rounds = scale === 1 && !this.moving ? this.rounds : Number(!this.firstLights);
      if (!(await this._stage(generation, scale, rounds))) return;
      if (this.moving) return;
    }
  }

  /** Sizes to go through: what is quick enough first, then finer ones, the last of them in steps of a half. */
  _scales() {
    const pixels = this.canvas.width * this.canvas.height * Math.max(1, (this.firstLights ?? this.lights).length);
    const coarsest = Math.min(this.coarsest, this.coarsestSeen());
    let scale = 1;
    while (scale < coarsest && (pixels * this.msPerPixel) / scale ** 2 > MOVING_MS) scale *= 2;
    const scales = [scale];
    while (scale > 1) scales.push((scale /= scale > 4 ? 4 : 2));
    return scales;
  }

  async _stage(generation, scale, rounds) {
    const { engine, canvas } = this;
    const width = Math.ceil(canvas.width / scale), height = Math.ceil(canvas.height / scale);
    this.shown = null;
    engine.resize(width, height);
    const camera = { ...this.orbit.camera(width, height), jitter: this.jitter }, { firstLights } = this;
    if (firstLights) {
      if (!(await this._look(generation, { ...camera, jitter: 0 }, scale))) return false;
    } else if (!this.hasShown && this.coarsestSeen() > SHARP) {  // one light is better than none
      if (!(await this._round(generation, camera, 0, this.lights.slice(0, 1)))) return false;
      this._present(camera, 1, scale, 0, engine.target, false);
    }
    for (let round = 0; round < rounds; round++) {
      const begun = performance.now();
      if (!(await this._round(generation, camera, round, this.lights))) return false;
      const ms = performance.now() - begun;
      this._present(camera, round + 1, scale, firstLights ? lookShare(round + 1) : 0);
      this._measure(ms, width * height, this.lights.length);
      if (scale === 1) this.stats.ms = this.stats.ms ? 0.7 * this.stats.ms + 0.3 * ms : ms;
    }
    return true;
  }

  /** A sample of every pixel; false if the picture is no longer wanted. */
  _round(generation, camera, round, lights) {
    return this._bands(generation, lights.length, (from, to) => {
      this._band(camera, round, lights, from, to);
      if (this.shown?.rounds === round) this.rowsAhead = to;
    });
  }

  /** The first look: light at the pixels' middles, then edges by rays alone, at once in that size, then in full size: rays
   * are cheaper than light. */
  async _look(generation, camera, scale) {
    const { engine, canvas, firstLights, moving, stats } = this, { target } = engine, begun = performance.now();
    const full = { width: canvas.width, height: canvas.height }, isOneSize = scale === 1 || scale > SHARP || moving;
    const views = [[camera, target], [{ ...this.orbit.camera(full.width, full.height), jitter: 0 }, full]];
    const lit = await this._bands(generation, firstLights.length, (from, to) => {
      this._band(camera, 0, firstLights, from, to);
      engine.remember();
    });
    if (!lit) return false;
    for (const [view, size] of isOneSize ? views.slice(0, 1) : views.slice(Number(stats.isSharp))) {
      if (!(await this._edges(generation, view, size))) return false;
      this._present(view, 0, scale, 1, size);
      if (size === target) this._measure(performance.now() - begun, target.width * target.height, firstLights.length);
    }
    return true;
  }

  _edges(generation, camera, size) {
    const { engine } = this;
    return this._bands(generation, 1, (from, to) => EDGE_RAYS.forEach((shift, k) => {
      engine.trace({ ...camera, shift }, 0, from, to, size.width);
      engine.smoothEdges(EDGE_RAYS.length, k === 0, size);
    }), size);
  }

  /** Does work on some rows at a time, which takes as long as so many lights; false if the picture is no longer wanted. */
  async _bands(generation, lights, work, { width, height } = this.engine.target) {
    const { engine } = this;
    const cost = this.msPerPixel * width * Math.max(1, lights);
    const rows = Math.max(1, Math.min(height, Math.floor(BAND_MS / cost), Math.floor(engine.bandPixels / width)));
    for (let from = 0; from < height; from += rows) {
      if (this.resting) await new Promise((resolve) => { this.rouse = resolve; });
      work(from, Math.min(height, from + rows));
      await engine.done();
      const isUnwanted = this.isFleeting ? !this.ready || !this.moving : generation !== this.generation;
      if (isUnwanted || this.stopped || engine.lost) return false;
    }
    return true;
  }

  _band(camera, round, lights, from, to) {
    const { engine } = this;
    engine.trace(camera, round, from, to);
    const all = lights.length ? lights : [DARKNESS];
    all.forEach((light, k) =>
      engine.light({ ...light, ground: this.ground }, { isFirst: round === 0 && k === 0, countsCoverage: k === 0, number: k }));
    if (engine.emits) engine.emission();
  }

  /** firstLook: share of the first look in the picture. scale: of its light. isLit: by all lights. */
  _present(camera, rounds, scale, firstLook, size = this.engine.target, isLit = true) {
    Object.assign(this, { shown: { rounds, firstLook }, shownCamera: { ...camera, ...size }, rowsAhead: 0 });
    this.show();
    if (!this.hasShown) performance.mark("picture");
    this.hasShown = true;
    Object.assign(this.stats, { rounds, scale, isSharp: isLit && scale <= SHARP });
    this.dispatchEvent(new Event("shown"));
  }

  _measure(ms, pixels, lights) {
    const each = ms / (pixels * Math.max(1, lights));
    this.msPerPixel = pixels < 4096 ? Math.min(this.msPerPixel * 4, each) : 0.5 * (this.msPerPixel + each);
  }
}

/** Of a picture of so many samples. */
const lookShare = (rounds) => Math.max(0, 1 - rounds / LOOK_ROUNDS) / (1 + rounds / LOOK_WORTH);
