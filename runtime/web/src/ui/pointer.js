// Pointer, touch, wheel and keys over the picture.

const RADIANS_A_PIXEL = (0.4 * Math.PI) / 180;
const STEP = (5 * Math.PI) / 180;
const PAN_STEP = 0.05;  // heights of the picture

/**
 * One finger or the left button orbits; with Alt or Shift, or three fingers, the light turns; the right button or two fingers
 * pan; two that twist turn the light, too; wheel and pinch zoom. `actions`: orbit(x, y), light(x, y), pan(x, y), zoom(factor), all with a last argument
 * that tells whether more will follow at once; settle(), reset(). may(event): whether an event is for the picture;
 * others are the page's.
 */
export function listen(canvas, actions, may = () => true) {
  const pointers = new Map();
  let way = null;

  canvas.addEventListener("pointerdown", (event) => {
    if (!may(event)) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    capture(canvas, event.pointerId);
    canvas.classList.add("dragging");
    if (pointers.size > 1) way = pointers.size === 2 ? "two" : "three";
    else if (pointers.size === 1) {
      way = event.button === 2 ? "pan" : event.button !== 0 ? null : event.altKey || event.shiftKey ? "light" : "orbit";
    }
  });

  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = { x: event.clientX, y: event.clientY }, dx = now.x - before.x, dy = now.y - before.y;
    if (way === "two") twoFingers(pointers, event.pointerId, before, now, actions, canvas.clientHeight);
    pointers.set(event.pointerId, now);
    if (!dx && !dy) return;
    if (way === "orbit") actions.orbit(-dx * RADIANS_A_PIXEL, dy * RADIANS_A_PIXEL, true);
    if (way === "three") actions.light((dx / 3) * RADIANS_A_PIXEL, (-dy / 3) * RADIANS_A_PIXEL, true);
    if (way === "light") actions.light(dx * RADIANS_A_PIXEL, -dy * RADIANS_A_PIXEL, true);
    if (way === "pan") actions.pan(-dx / canvas.clientHeight, dy / canvas.clientHeight, true);
  });

  for (const name of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(name, (event) => {
      if (!pointers.delete(event.pointerId)) return;
      if (pointers.size) return;
      way = null;
      canvas.classList.remove("dragging");
      actions.settle();
    });
  }

  canvas.addEventListener("contextmenu", (event) => may(event) && event.preventDefault());
  canvas.addEventListener("dblclick", (event) => may(event) && actions.reset());
  let settling = 0;
  canvas.addEventListener("wheel", (event) => {
    if (!may(event)) return;
    event.preventDefault();
    const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * 32;
    actions.zoom(Math.exp(Math.min(300, Math.max(-300, pixels)) * 0.0012), true);
    clearTimeout(settling);
    settling = setTimeout(() => actions.settle(), 200);
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => may(event) && onKey(event, actions));
}

function capture(canvas, id) {
  try {
    canvas.setPointerCapture(id);
  } catch {
    // The pointer is gone already.
  }
}

function twoFingers(pointers, id, before, now, actions, height) {
  const other = [...pointers].find(([key]) => key !== id)?.[1];
  if (!other) return;
  const distance = (p) => Math.hypot(p.x - other.x, p.y - other.y) || 1, angle = (p) => Math.atan2(p.y - other.y, p.x - other.x);
  actions.zoom(distance(before) / distance(now), true);
  const twist = angle(now) - angle(before), shortest = Math.atan2(Math.sin(twist), Math.cos(twist));
  if (shortest) actions.light(-shortest, 0, true);
  // Each finger tells half of the movement.
  actions.pan((0.5 * (before.x - now.x)) / height, (0.5 * (now.y - before.y)) / height, true);
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
