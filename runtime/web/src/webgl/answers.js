// Queries that do not come from a picture: those of the conformance kit, and of the benchmark.

const WIDTH = 256;

/** Writes numbers, four a row of `stride`, into image k of a target. */
function write(gl, image, rows, from, count, stride) {
  const height = Math.ceil(count / WIDTH), values = new Float32Array(4 * WIDTH * height);
  for (let k = 0; k < count; k++) values.set(rows.subarray(stride * k + from, stride * k + from + 4), 4 * k);
  gl.bindTexture(gl.TEXTURE_2D, image.texture);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, WIDTH, height, gl.RGBA, gl.FLOAT, values);
}

/** A row of arguments that may be anything (spec, 8.1), as shaders take it: unit directions, or an axis of 0. */
function usable(row) {
  const directions = [4, 8, 12].map((from) => unit(row.subarray(from, from + 3)));
  const right = row.every(Number.isFinite) && directions.every(Boolean);
  directions.forEach((d, k) => row.set(right ? d : [0, 0, 0], 4 + 4 * k));
  if (!right) row.set([0, 0, 0, 0], 0);
}

function unit(v) {
  const size = Math.hypot(...v);
  return size > 0 && Number.isFinite(size) ? Array.from(v, (x) => x / size) : null;
}

function begin(engine, count) {
  const height = Math.ceil(count / WIDTH);
  engine.resize(WIDTH, height);
  engine.span = { rows: height, firstRow: 0 };
  engine.frame = { cameraAt: ["3fv", [0, 0, 0]], height: ["1i", height], firstRow: ["1i", 0], sampleNumber: ["1ui", 0] };
}

/** (n, outputs) numbers for rows of 16: position and h; n or t; wo; wi. The last of each four but h is free. */
export async function evaluate(engine, part, output, rows, wantsAnswers = true) {
  const colours = output === "transport" ? 2 : 1, count = rows.length / 16, result = new Float32Array(3 * colours * count);
  const most = engine.bandPixels;
  for (let first = 0; first < count; first += most) {
    const some = Math.min(most, count - first), { gl } = engine;
    begin(engine, some);
    const own = rows.slice(16 * first, 16 * (first + some));
    for (let k = 0; k < some; k++) {
      usable(own.subarray(16 * k, 16 * k + 16));
      own[16 * k + 7] = own[16 * k + 3];  // h is with the axis here
      own[16 * k + 3] = part + 1;
      own[16 * k + 15] = 1;
    }
    [0, 4, 8].forEach((from, k) => write(gl, engine.rows.images[k], own, from, some, 16));
    write(gl, engine.lit.images[0], own, 12, some, 16);
    engine._decode(output);
    await engine.done();
    if (!wantsAnswers) continue;
    for (let c = 0; c < colours; c++) {
      const answers = engine.answers.read(c);
      for (let k = 0; k < some; k++) result.set(answers.subarray(4 * k, 4 * k + 3), 3 * (colours * (first + k) + c));
    }
  }
  return result;
}

function writeHits(engine, hits) {
  const rows = new Float32Array(16 * hits.length);
  hits.forEach(({ place, b1, b2, x, wi, part }, k) => {
    rows.set([...x, part + 1, 0, 0, 0, b1, 0, 0, 0, place, 1, 1, 1, b2], 16 * k);
    hits[k].own = wi;
  });
  begin(engine, hits.length);
  [0, 4, 8, 12].forEach((from, k) => write(engine.gl, engine.rows.images[k], rows, from, hits.length, 16));
}

/** (n, 3) visibilities. */
export async function visibility(engine, hits) {
  writeHits(engine, hits);
  const { gl } = engine, given = engine.answers.images[0], wi = new Float32Array(4 * hits.length);
  hits.forEach((hit, k) => wi.set(hit.wi, 4 * k));
  write(gl, given, wi, 0, hits.length, 4);
  engine._light({ kind: "given", colour: [1, 1, 1] }, given);
  return triples(engine.lit.read(1), hits.length);
}

/** (n, 3) mapped normals. */
export async function mappedNormals(engine, hits) {
  writeHits(engine, hits);
  const [, row1, row2, row3] = engine.rows.images;
  engine._pass("normals", engine.answers, { ...engine.asset, rows1: row1, rows2: row2, rows3: row3 }, engine.geometry);
  return triples(engine.answers.read(0), hits.length);
}

function triples(values, count) {
  return Float32Array.from({ length: 3 * count }, (_, k) => values[4 * Math.floor(k / 3) + (k % 3)]);
}
