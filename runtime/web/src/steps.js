// Long work in steps, so that the page answers in between: generators that yield after each.

const SLICE_MS = 20;
const STEP = 8192;  // items

/** Hands on ranges of items, a step each. work(from, to): what is done with them. */
export function* inSteps(first, end, work) {
  for (let from = first; from < end; from += STEP) {
    work(from, Math.min(end, from + STEP));
    if (from + STEP < end) yield;
  }
}

/** The result of a generator; others have their turn whenever it took a slice of time. */
export async function finished(steps) {
  for (let since = performance.now(); ;) {
    const { done, value } = steps.next();
    if (done) return value;
    if (performance.now() - since < SLICE_MS) continue;
    await turnOfOthers();
    since = performance.now();
  }
}

/** By a message: browsers hold timers back where nobody sees the page. */
function turnOfOthers() {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
