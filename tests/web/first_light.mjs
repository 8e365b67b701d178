// node first_light.mjs WIDTH HEIGHT < rgb as float32: { lights, up, rest } of firstLight as JSON, the texels as base64.
import { readFileSync } from "node:fs";
import { firstLight } from "../../runtime/web/src/light/first_light.js";

const [width, height] = process.argv.slice(2).map(Number), file = readFileSync(0);
const rgb = new Float32Array(file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
const { rest, ...result } = await firstLight({ rgb, width, height });
console.log(JSON.stringify({ ...result, rest: { ...rest, texels: Buffer.from(rest.texels.buffer).toString("base64") } }));
