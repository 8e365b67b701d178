// Turns the asset under lights and camera that stay, while nobody moves them.

const LONGEST_STEP = 0.25;  // seconds: what follows a pause is no jump

export class Turntable {
  /** delay: ms after the last movement. speed: degrees a second. */
  constructor(stage) {
    Object.assign(this, { stage, angle: 0, isOn: false, isTurning: false, delay: 3000, speed: 30 });
    stage.addEventListener("shown", () => this._next());
    for (const name of ["load", "stand-in", "camera", "light"]) stage.addEventListener(name, () => this.wait());
  }

  /** Turns once `delay` has passed from now. */
  wait() {
    clearTimeout(this.timer);
    const wasTurning = this.isTurning;
    this.isTurning = false;
    if (this.isOn) this.timer = setTimeout(() => this._start(), this.delay);
    else if (wasTurning) this.stage.restart();  // all samples
  }

  switch(on) {
    this.isOn = on;
    this.wait();
  }

  set(angle) {
    this.angle = angle;
    this.stage.turnTable(angle, this.isTurning);
  }

  /** Not where the network's picture waits to be as sharp as what covers it: pictures that turn are coarse on slow devices. */
  _start() {
    if (this.stage.isWaited) return;
    Object.assign(this, { isTurning: true, last: performance.now() });
    this._next();
  }

  /** The next angle, once the picture of the last one is seen. */
  _next() {
    if (!this.isTurning || this.isRequested) return;
    this.isRequested = true;
    requestAnimationFrame((now) => {
      this.isRequested = false;
      if (!this.isTurning) return;
      const seconds = Math.min(LONGEST_STEP, Math.max(0, now - this.last) / 1e3);
      this.last = now;
      this.set(this.angle + (seconds * this.speed * Math.PI) / 180);
    });
  }
}
