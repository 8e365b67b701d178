// Queries that do not come from a picture: those of the conformance kit, and of the benchmark.
import { packed, records } from "../decoder/records.js";
import { dispatch, read } from "./gpu_device.js";

const CAMERA = { position: [0, 0, 0], corner: [0, 0, 0], stepX: [0, 0, 0], stepY: [0, 0, 0] };

/** Words of a row: position and h; n or t and red; wo and green; wi and blue, of the base colour; nearby light, and not 0 where it is there. */
export const ROW_WORDS = records.RnaRow.words;

/** (n, colours, 3) numbers for rows. */
export async function evaluate(engine, part, output, rows, wantsAnswers = true) {
  const { [output]: one, visible, shadowed } = engine.parts[part], { device, queue, bandPixels } = engine;
  const evaluators = one ? [one] : [visible, shadowed], all = output === "transport" ? 2 : 1, colours = all / evaluators.length;
  const count = rows.length / ROW_WORDS, result = new Float32Array(3 * all * count);
  for (let first = 0; first < count; first += bandPixels) {
    const some = Math.min(bandPixels, count - first);
    device.queue.writeBuffer(queue.rows, 0, rows, ROW_WORDS * first, ROW_WORDS * some);
    device.queue.writeBuffer(queue.count, 0, Uint32Array.of(some));
    for (const [place, evaluator] of evaluators.entries()) {
      engine._run((pass) => evaluator.run(pass, queue, some));
      await engine.done();
      if (!wantsAnswers) continue;
      const answers = new Float32Array(await read(device, queue.answers, 16 * all * some));  // `all` a row
      for (let k = 0; k < colours * some; k++) {
        const row = Math.floor(k / colours), own = all * row + (k % colours);
        result.set(answers.subarray(4 * own, 4 * own + 3), 3 * (all * first + own + place));
      }
    }
  }
  return result;
}

/** Runs a kernel of rays over hits { place, b1, b2, x, wi, level, part }; a vector of each pixel. */
async function answersOf(engine, hits, kernel, member) {
  const { device, band } = engine, { words, members } = records.Pixel, rows = new Uint32Array(words * hits.length);
  hits.forEach(({ place, b1, b2, x, wi, level, part }, k) => {
    const bits = (v, last) => [...new Uint32Array(Float32Array.from(v).buffer), last];
    rows.set(packed("Pixel", { position: bits(x, 0), axis: [0, 0, 0, part + 1], wo: [0, 0, 0, place], wi: bits(wi, 0), b1, b2, coverage: level }), words * k);
  });
  engine.resize(hits.length, 1);
  engine.span = { first: 0, pixels: hits.length, jitter: 0 };
  device.queue.writeBuffer(band, 0, rows);
  engine._writeFrame(CAMERA, 0, hits.length);
  engine._writeView({ kind: "given", colour: [1, 1, 1] });
  engine._run((pass) => dispatch(pass, kernel, engine.groups.rays, hits.length));
  const answers = new Float32Array(await read(device, band, rows.byteLength));
  return Float32Array.from({ length: 3 * hits.length }, (_, k) => answers[words * Math.floor(k / 3) + members[member].at + (k % 3)]);
}

/** (n, 3) visibilities. */
export const visibility = (engine, hits) => answersOf(engine, hits, engine.kernels.light, "visibility");

const ofHits = (entry, member) => async (engine, hits) =>
  answersOf(engine, hits, await engine.pipelines.get(engine.raySources.hit, entry, engine.rayLayout), member);

/** (n, 3) mapped normals, and base colours. */
export const mappedNormals = ofHits("find_normals", "axis"), baseColors = ofHits("find_base_colors", "base_color");
