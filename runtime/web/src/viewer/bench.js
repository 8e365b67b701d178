// ?bench=1: how many queries a second the decoder answers here, and how long a picture takes. One line to send in.

const TRIALS = 5, TRIAL_MS = 400;

/** Rows of so many words in the part's bounds, with directions all over. */
function randomRows({ bounds: { min, max } }, words, count) {
  const rows = new Float32Array(words * count);
  let state = 1;
  const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const direction = () => {
    const z = 2 * random() - 1, phi = 2 * Math.PI * random(), r = Math.sqrt(1 - z * z);
    return [r * Math.cos(phi), r * Math.sin(phi), z];
  };
  for (let k = 0; k < count; k++) {
    const x = min.map((low, axis) => low + random() * (max[axis] - low));
    rows.set([...x, 0, ...direction(), 0, ...direction(), 0, ...direction(), 0], words * k);
  }
  return rows;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Million queries a second of a part's decoder: median of trials, from a count that takes long enough. */
async function queriesPerSecond(reader, parts, k = 0) {
  let count = 1024, ms = 0;
  for (;;) {
    const rows = randomRows(parts[k], reader.rowWords, count), begun = performance.now();
    await reader.answer(k, "transport", rows, false);
    ms = performance.now() - begun;
    if (ms > TRIAL_MS / 2 || count >= reader.engine.bandPixels) break;
    count *= 2;
  }
  const rows = randomRows(parts[k], reader.rowWords, count), rates = [];
  for (let trial = 0; trial < TRIALS; trial++) {
    const begun = performance.now();
    await reader.answer(k, "transport", rows, false);
    rates.push(count / (performance.now() - begun) / 1e3);
  }
  return { rate: median(rates), count };
}

/** The cost of a query of the part: multiply-adds and bytes of planes. */
function costOf({ decoders, planes }) {
  const { transport, visible } = decoders, { layers } = transport ?? visible;
  const multiplyAdds = layers.reduce((sum, { rows, columns }) => sum + rows * columns, 0);
  const bytes = 12 * planes.channels * { float16: 2, float32: 4, int8: 1 }[planes.precision];
  return { multiplyAdds, bytes };
}

function adapterName({ device: { adapterInfo: { vendor, architecture, description } } }) {
  return [vendor, architecture, description].filter(Boolean).join(" ");
}

/** Measures the asset that is open, and shows the table. */
export async function runBenchmark(stage) {
  const { viewer, engine, shown, opened } = stage;
  if (!shown) return;
  const samples = 3;
  viewer.rounds = samples;
  viewer.restart();
  await viewer.converged(samples);
  const pixels = stage.canvas.width * stage.canvas.height, ms = viewer.stats.ms;
  const reader = stage.reader();
  await engine.done();
  const { rate, count } = await queriesPerSecond(reader, shown.parts);
  const { multiplyAdds, bytes } = costOf(shown.parts[0]);
  const line = {
    asset: opened.manifest.name, tier: shown.name, gpu: adapterName(engine),
    millionQueriesPerSecond: Number(rate.toPrecision(3)), queries: count, multiplyAddsPerQuery: multiplyAdds,
    planeBytesPerQuery: bytes, picture: `${stage.canvas.width} x ${stage.canvas.height}`, lights: viewer.lights.length,
    msPerSample: Math.round(ms), megapixelsPerSecond: Number((pixels / ms / 1e3).toPrecision(3)), browser: navigator.userAgent,
  };
  show(line);
  stage.viewer.start();
  globalThis.rnaBenchmark = line;
}

function show(line) {
  const table = document.getElementById("bench");
  table.replaceChildren();
  for (const [name, value] of [...Object.entries(line), ["line to send in", JSON.stringify(line)]]) {
    const row = table.insertRow();
    row.insertCell().textContent = name;
    row.insertCell().textContent = String(value);
  }
  table.hidden = false;
}
