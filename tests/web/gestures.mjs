// node gestures.mjs POINTER_JS: what gestures do to actions, as JSON, by name of the gesture.
const { listen } = await import(process.argv[2]);

let touchAction = "pan-y", time = 0;
globalThis.getComputedStyle = () => ({ touchAction });
const listeners = new Map();
globalThis.addEventListener = (name, action) => listeners.set(name, action);

function event(name, canvas, values) {
  const made = Object.assign(new Event(name, { cancelable: true }), values);
  Object.defineProperty(made, "timeStamp", { value: (time += values.after ?? 16) });
  return made;
}

/** What is heard of a gesture: [name of an event, pointer, x, y] or values of one, in this order. */
function played(events, { action = "pan-y", mouse = false, may = true } = {}) {
  const heard = [], canvas = Object.assign(new EventTarget(), { clientHeight: 100, classList: { add() {}, remove() {} }, setPointerCapture() {} });
  const hear = (name) => (...values) => void heard.push([name, ...values.slice(0, -1).map((value) => Math.round(1e3 * value) / 1e3)]);
  touchAction = action;
  const remember = () => () => heard.push(["undone"]);
  listen(canvas, { orbit: hear("orbit"), light: hear("light"), pan: hear("pan"), zoom: hear("zoom"), settle() {}, reset() {}, remember }, () => may);
  for (const [name, id, x, y, more] of events) {
    const values = { pointerId: id, clientX: x, clientY: y, button: 0, pointerType: mouse ? "mouse" : "touch", ...more };
    canvas.dispatchEvent(event(`pointer${name}`, canvas, values));
  }
  return heard;
}

/** Turns of the wheel, by whether they are over the picture: how many zoom. */
function wheeled(places, may = true) {
  let zoomed = 0;
  const canvas = Object.assign(new EventTarget(), { clientHeight: 100 });
  listen(canvas, { zoom: () => { zoomed += 1; }, settle() {} }, () => may);
  time += 1e4;
  for (const { over, ...values } of places) {
    const turn = event("wheel", canvas, { deltaMode: 0, deltaY: 10, ...values });
    listeners.get("wheel")(turn);
    if (over) canvas.dispatchEvent(turn);
  }
  return zoomed;
}

const down = (id, x, y) => ["down", id, x, y], move = (id, x, y) => ["move", id, x, y], cancel = (id) => ["cancel", id];
const two = [down(1, 40, 50), down(2, 60, 50)], over = { over: true }, beside = { over: false };
console.log(JSON.stringify({
  upwards: played([down(1, 50, 50), move(1, 50, 40), move(1, 60, 30), move(1, 90, 20)]),
  upwardsAlone: played([down(1, 50, 50), move(1, 50, 40), move(1, 50, 30)], { action: "none" }),
  sideways: played([down(1, 50, 50), move(1, 45, 50), move(1, 41, 50), move(1, 31, 50)]),
  panX: played([down(1, 50, 50), move(1, 41, 50), move(1, 31, 50)], { action: "pan-x pinch-zoom" }),
  taken: played([down(1, 50, 50), move(1, 41, 50), move(1, 31, 50), cancel(1), move(1, 10, 50)]),
  mouse: played([down(1, 50, 50), move(1, 50, 49)], { mouse: true }),
  pages: played([down(1, 50, 50), move(1, 31, 50), move(1, 21, 50)], { may: false }),
  pinch: played([...two, move(1, 30, 50), move(1, 20, 50), move(1, 0, 50)]),
  pan: played([...two, move(1, 40, 45), move(2, 60, 40), move(1, 40, 35), move(1, 40, 30)]),
  twist: played([...two, move(1, 42, 40), move(2, 58, 60), move(2, 56, 62)]),
  left: played([...two, move(1, 20, 50), ["up", 1], move(2, 90, 50), move(2, 99, 50)]),
  wheel: [wheeled([over, over]), wheeled([beside, over]), wheeled([beside, { ...over, after: 300 }]), wheeled([beside, { ...over, ctrlKey: true }]), wheeled([over], false)],
}));
