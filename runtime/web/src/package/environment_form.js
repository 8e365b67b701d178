// RNA_environment (spec, 12.1): lobes of the transport for light from whole environments.
import schema from "../../../../spec/schema/manifest.schema.json";
import { blockNamed } from "./blocks.js";
import { fail } from "./errors.js";
import { forParts, orNull, record } from "./schema_parts.js";
import { isMetadata, isTensor, readHeader, takeTensors } from "./tensors.js";

export const VISIBILITY_COLUMNS = 16;
const MOST_LOBES = 32;
const { emission, ...OF_A_PART } = schema.$defs.TierPart.properties;
const NUMBER = { type: "number" }, MEASURE = { type: "number", minimum: 0 };
const VALIDATION = record({
  environment: schema.$defs.Tier.properties.name, psnr: NUMBER, psnrWithLights: NUMBER, flip: MEASURE,
  brightness: { type: "array", minItems: 3, maxItems: 3, items: MEASURE },
});
export const ENVIRONMENT_SCHEMA = {
  $defs: schema.$defs,
  type: "object", required: ["parts"], additionalProperties: false,
  properties: {
    parts: forParts(orNull({
      type: "object", additionalProperties: false, required: [...schema.$defs.TierPart.required, "lobes"],
      properties: { ...OF_A_PART, lobes: { type: "integer", minimum: 2, maximum: MOST_LOBES }, visibility: OF_A_PART.planes },
    })),
    validation: { type: "array", maxItems: 64, items: VALIDATION },
  },
};

/** The parts' records; null where a part has none. */
export function environmentOf(manifest) {
  const parts = manifest.extensions?.RNA_environment?.parts;
  return parts?.every((record) => record) ? parts : null;
}

/** Fails where the data, which fits the schema and has one record or null a part, is not as it must be. */
export function checkEnvironment({ parts }, manifest, where) {
  if (!parts.some((record) => record)) fail("FIELD_VALUE", where, "lobes of no part");
  parts.forEach((record, k) => {
    if (!record) return;
    const at = `${where}/parts/${k}`;
    if (record.lobes % 2) fail("FIELD_VALUE", `${at}/lobes`, `found ${record.lobes}, expected an even number`);
    for (const name of record.inputs) {
      if (!blockNamed(name).kinds.includes(manifest.parts[k].kind)) fail("INPUT_KIND", `${at}/inputs`, `${name} is not for this part`);
    }
    for (const name of entriesOf([record])) {
      if (!Object.hasOwn(manifest.entries, name)) fail("REFERENCE_MISSING", at, `no entry ${name}`);
    }
  });
}

/** Names of the entries of records. */
export const entriesOf = (records) =>
  records.flatMap(({ planes, decoder, visibility }) => [planes, decoder, ...(visibility ? [visibility] : [])]);

/** Harmonics of the asset's own visibility about its points: 16 whole numbers each, of which 127 stands for 1. */
export function readHarmonics(bytes, points, where) {
  const code = "ENVIRONMENT_VISIBILITY", header = readHeader(bytes, where, code), tensor = header.tensors.harmonics;
  if (!isMetadata(header.metadata)) fail(code, where, "__metadata__ is no object");
  if (Object.keys(header.tensors).join() !== "harmonics" || !isTensor(tensor)) fail(code, where, "not one tensor harmonics");
  const expected = [points, VISIBILITY_COLUMNS];
  if (tensor.dtype !== "I8" || tensor.shape.join() !== expected.join()) {
    fail(code, where, `found ${tensor.dtype} [${tensor.shape}], expected I8 [${expected}]`);
  }
  if (header.data % 64) fail(code, where, "data does not start at a multiple of 64");
  return takeTensors(bytes, header, ["harmonics"], where, code)[0];
}
