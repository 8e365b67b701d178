// Queries that do not come from a picture: those of the conformance kit, and of the benchmark.
import { dispatch, read } from "./gpu_device.js";

const CAMERA = { position: [0, 0, 0], corner: [0, 0, 0], stepX: [0, 0, 0], stepY: [0, 0, 0] };

/** (n, outputs) numbers for rows of 16: position and h; n or t; wo; wi. The last of each four but h is free. */
export async function evaluate(engine, part, output, rows, wantsAnswers = true) {
  const own = engine.parts[part][output], { device, queue, bandPixels } = engine;
  const colours = output === "transport" ? 2 : 1, count = rows.length / 16, result = new Float32Array(3 * colours * count);
  for (let first = 0; first < count; first += bandPixels) {
    const some = Math.min(bandPixels, count - first);
    device.queue.writeBuffer(queue.rows, 0, rows, 16 * first, 16 * some);
    device.queue.writeBuffer(queue.count, 0, Uint32Array.of(some));
    engine._run((pass) => own.run(pass, queue, some));
    await engine.done();
    if (!wantsAnswers) continue;
    const answers = new Float32Array(await read(device, queue.answers, 16 * colours * some));
    for (let k = 0; k < colours * some; k++) {
      result.set(answers.subarray(4 * k, 4 * k + 3), 3 * (colours * first + k));
    }
  }
  return result;
}

/** Hits as they stand between the kernels: { place, b1, b2, x, wi, part }. */
function writeHits(engine, hits) {
  const floats = new Float32Array(16 * hits.length), words = new Uint32Array(floats.buffer);
  hits.forEach(({ place, b1, b2, x, wi, part }, k) => {
    floats.set([...x, b1], 16 * k);
    words[16 * k + 7] = part + 1;
    words[16 * k + 11] = place;
    floats.set([...wi, b2], 16 * k + 12);
  });
  engine.resize(hits.length, 1);
  engine.span = { from: 0, rows: 1, pixels: hits.length };
  engine.device.queue.writeBuffer(engine.band.rows, 0, floats);
  engine._writeView(CAMERA, 0);
}

/** (n, 3) visibilities. */
export async function visibility(engine, hits) {
  writeHits(engine, hits);
  engine._writeLight({ kind: "given", colour: [1, 1, 1] }, true, false);
  engine._run((pass) => dispatch(pass, engine.kernels.light, engine.groups.light, hits.length));
  const lit = new Float32Array(await read(engine.device, engine.band.lit, 32 * hits.length));
  return Float32Array.from({ length: 3 * hits.length }, (_, k) => lit[8 * Math.floor(k / 3) + (k % 3)]);
}

/** (n, 3) mapped normals. */
export async function mappedNormals(engine, hits) {
  writeHits(engine, hits);
  const { device, view, geometry: [, primitives, points, textures], band } = engine;
  const pipeline = await engine.pipelines.get(engine.raySources.hit, "find_normals");
  const group = (k, entries) => device.createBindGroup({
    layout: pipeline.getBindGroupLayout(k), entries: entries.map(([binding, buffer]) => ({ binding, resource: { buffer } })),
  });
  const groups = [group(0, [[0, view], [2, primitives], [3, points], [4, textures]]), group(1, [[0, band.rows]])];
  engine._run((pass) => dispatch(pass, pipeline, groups, hits.length));
  const rows = new Float32Array(await read(engine.device, engine.band.rows, 64 * hits.length));
  return Float32Array.from({ length: 3 * hits.length }, (_, k) => rows[16 * Math.floor(k / 3) + 4 + (k % 3)]);
}
