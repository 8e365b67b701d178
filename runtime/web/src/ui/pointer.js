// Pointer, touch, wheel and keys over the picture.

const RADIANS_A_PIXEL = (0.4 * Math.PI) / 180;
const STEP = (5 * Math.PI) / 180;
const PAN_STEP = 0.05;  // heights of the picture
const DECIDED = 8;      // pixels that fingers move until it is known what they do; Chromium scrolls after 15
const WHEEL_MS = 250;   // turns of the wheel that follow sooner are one movement

/** By touch-action: whether one finger that moves so is the page's. */
const SCROLLS = { "pan-y": (x, y) => Math.abs(y) > Math.abs(x), "pan-x": (x, y) => Math.abs(x) > Math.abs(y) };

/** The effect of pointers that move by dx, dy. path: of that pointer, { before, now }, the place of another one, and the picture's height. */
const MOVES = {
  orbit: (actions, dx, dy) => actions.orbit(-dx * RADIANS_A_PIXEL, dy * RADIANS_A_PIXEL, true),
  light: (actions, dx, dy) => actions.light(dx * RADIANS_A_PIXEL, -dy * RADIANS_A_PIXEL, true),
  three: (actions, dx, dy) => MOVES.light(actions, dx / 3, dy / 3),  // each finger tells a third of the movement
  pan: (actions, dx, dy, { height }) => actions.pan(-dx / height, dy / height, true),
  pinch(actions, dx, dy, { before, now, other, height }) {
    actions.zoom(apart(before, other) / apart(now, other), true);
    MOVES.pan(actions, dx / 2, dy / 2, { height });
  },
  twist: (actions, dx, dy, { before, now, other }) => actions.light(-turned(before, now, other), 0, true),
};

/**
 * One finger or the left button orbits; with Alt or Shift, or three fingers, the light turns; the right button or two fingers
 * pan; wheel and pinch zoom; two fingers that twist turn the light instead. Fingers move nothing until it is known which of
 * these they mean, and what the browser takes over is undone. `actions`: orbit(x, y), light(x, y), pan(x, y), zoom(factor),
 * all with a last argument that tells whether more will follow at once; settle(), reset(); remember() returns a function
 * that undoes what follows. may(event): whether an event is for the picture; others are the page's.
 */
export function listen(canvas, actions, may = () => true, signal = undefined) {
  const on = (name, action) => canvas.addEventListener(name, (event) => may(event) && action(event));
  listenToPointers(canvas, actions, may);
  listenToWheel(canvas, actions, may, signal);
  on("contextmenu", (event) => event.preventDefault());
  on("dblclick", () => actions.reset());
  on("keydown", (event) => onKey(event, actions));
}

function listenToPointers(canvas, actions, may) {
  const places = new Map();                        // by pointer
  let way = null, begun = new Map(), undo = null;  // way: a key of MOVES, another text for nothing, or null until it is known

  const end = () => {
    places.clear();
    canvas.classList.remove("dragging");
    actions.settle();
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (!may(event)) return;
    if (!places.size) undo = actions.remember?.();
    places.set(event.pointerId, placeOf(event));
    capture(canvas, event.pointerId);
    canvas.classList.add("dragging");
    begun = new Map(places);
    way = places.size > 2 ? "three" : places.size === 1 && event.pointerType === "mouse" ? wayOfMouse(event) : null;
  });

  canvas.addEventListener("pointermove", (event) => {
    const before = places.get(event.pointerId), now = placeOf(event);
    if (!before) return;
    places.set(event.pointerId, now);
    const [other] = [...places].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    const dx = now.x - before.x, dy = now.y - before.y;
    if (way === null) way = places.size > 1 ? wayOfTwo(begun, places) : wayOfOne(begun, places, canvas);
    else if (dx || dy) MOVES[way]?.(actions, dx, dy, { before, now, other, height: canvas.clientHeight });
  });

  canvas.addEventListener("pointerup", (event) => {
    if (!places.delete(event.pointerId)) return;
    way = "ended";  // fingers leave one after the other
    if (!places.size) end();
  });

  canvas.addEventListener("pointercancel", (event) => {
    if (!places.has(event.pointerId)) return;
    undo?.();
    end();
  });
}

const placeOf = ({ clientX, clientY }) => ({ x: clientX, y: clientY });
const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y) || 1;

/** The angle by which a point moved about a centre, from -pi to pi. */
function turned(before, now, centre) {
  const angle = (place) => Math.atan2(place.y - centre.y, place.x - centre.x), turn = angle(now) - angle(before);
  return Math.atan2(Math.sin(turn), Math.cos(turn));
}

function wayOfMouse({ button, altKey, shiftKey }) {
  if (button === 2) return "pan";
  if (button !== 0) return "none";
  return altKey || shiftKey ? "light" : "orbit";
}

/** Where one finger, or a pen, moved; null while it has hardly moved. */
function wayOfOne(begun, places, canvas) {
  const [[id, now]] = places, dx = now.x - begun.get(id).x, dy = now.y - begun.get(id).y;
  if (Math.hypot(dx, dy) < DECIDED) return null;
  const [action] = getComputedStyle(canvas).touchAction.split(" ");
  return SCROLLS[action]?.(dx, dy) ? "scroll" : "orbit";
}

function wayOfTwo(begun, places) {
  const [[a, A], [b, B]] = places, before = begun.get(a), other = begun.get(b);
  const between = apart(A, B), middle = { x: (A.x + B.x - before.x - other.x) / 2, y: (A.y + B.y - before.y - other.y) / 2 };
  const direction = (p, q) => ({ x: q.x - p.x, y: q.y - p.y });
  const twist = (Math.abs(turned(direction(before, other), direction(A, B), { x: 0, y: 0 })) * between) / 2;
  const pinch = Math.max(Math.abs(between - apart(before, other)) / 2, Math.hypot(middle.x, middle.y));
  if (Math.max(twist, pinch) < DECIDED) return null;
  return twist > pinch ? "twist" : "pinch";
}

/** A movement of the wheel is the page's or the picture's as a whole: what scrolls the page does not zoom where it comes to the picture. */
function listenToWheel(canvas, actions, may, signal) {
  let last = -Infinity, begins = false, isOurs = false, settling = 0;
  globalThis.addEventListener("wheel", (event) => {
    begins = event.timeStamp - last > WHEEL_MS || event.ctrlKey || event.metaKey;
    if (begins) isOurs = false;
    last = event.timeStamp;
  }, { capture: true, passive: true, signal });
  canvas.addEventListener("focus", () => { last = -Infinity; });
  canvas.addEventListener("wheel", (event) => {
    if (begins) isOurs = may(event);  // the window heard of it before
    if (!isOurs) return;
    event.preventDefault();
    const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * 32;
    actions.zoom(Math.exp(Math.min(300, Math.max(-300, pixels)) * 0.0012), true);
    clearTimeout(settling);
    settling = setTimeout(() => actions.settle(), 200);
  }, { passive: false });
}

function capture(canvas, id) {
  try {
    canvas.setPointerCapture(id);
  } catch {
    // The pointer is gone already.
  }
}

function onKey(event, actions) {
  if (event.ctrlKey || event.metaKey) return;
  const turn = event.altKey || event.shiftKey ? actions.light : actions.orbit;
  const keys = {
    ArrowLeft: () => turn(-STEP, 0), ArrowRight: () => turn(STEP, 0),
    ArrowUp: () => turn(0, STEP), ArrowDown: () => turn(0, -STEP),
    "+": () => actions.zoom(1 / 1.1), "=": () => actions.zoom(1 / 1.1), "-": () => actions.zoom(1.1),
    a: () => actions.pan(-PAN_STEP, 0), d: () => actions.pan(PAN_STEP, 0),
    w: () => actions.pan(0, PAN_STEP), s: () => actions.pan(0, -PAN_STEP),
    "[": () => actions.light(-STEP, 0), "]": () => actions.light(STEP, 0), Home: () => actions.reset(),
  };
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (!Object.hasOwn(keys, key)) return;
  event.preventDefault();
  keys[key]();
}
