// Packages are read in one worker, which all loaders share; in the page where no worker can be made, as a page's
// content security policy may have it.
import { readAsset } from "./read_asset.js";
import workerSource from "worker_source";  // by build.mjs

const waiting = new Map();
let worker, count = 0;

/** The result of `readAsset`; an AbortSignal lets go of it. */
export async function read(bytes, name, { tier, variant }, signal) {
  signal?.throwIfAborted();
  worker ??= openWorker();
  const there = await worker;
  if (!there) return readAsset(bytes, name, tier, variant);
  return new Promise((resolve, reject) => {
    const number = count++;
    waiting.set(number, { resolve, reject });
    signal?.addEventListener("abort", () => {
      waiting.delete(number);
      reject(signal.reason);
    }, { once: true });
    there.postMessage({ number, bytes, name, tier, variant });
  });
}

/** A worker that answers, or null. */
function openWorker() {
  if (typeof Worker === "undefined") return Promise.resolve(null);
  return new Promise((resolve) => {
    const url = URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" }));
    try {
      const made = new Worker(url);
      made.onerror = () => resolve(null);  // it did not start
      made.onmessage = ({ data }) => (data === "ready" ? resolve(made) : settle(data));
    } catch {
      resolve(null);
    }
  });
}

function settle({ number, asset, error }) {
  const { resolve, reject } = waiting.get(number) ?? {};
  waiting.delete(number);
  if (error) reject?.(Object.assign(new Error(error.message), error));
  else resolve?.(asset);
}
