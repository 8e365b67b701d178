// The extensions that the spec defines (12): their data in the manifest.
import published from "../../../../spec/schema/manifest.schema.json";
import { checkEnvironment, ENVIRONMENT_SCHEMA } from "./environment_form.js";
import { fail } from "./errors.js";
import { checkSampling, SAMPLING_SCHEMA } from "./sampling.js";
import { checkSchema } from "./schema.js";
import { forParts, integer, orNull, record, share } from "./schema_parts.js";

const path = { type: "string", pattern: "^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$", maxLength: 200 };

/** A record of base colour without triangles, for each of a part; null where it stays. */
const { triangles, ...printed } = published.$defs.BaseColorRecord.properties;
const changes = {
  type: "array", minItems: 1, maxItems: 64, items: orNull({ type: "object", properties: printed, additionalProperties: false }),
};

const LARGEST = 2 ** 32 - 2;
// A coded entry inflates to this many bytes and RATIO times those stored, at most.
const DEFLATE_ALLOWANCE = 2 ** 20, DEFLATE_RATIO = 64;
const SCHEMAS = {
  RNA_deflate: record({
    entries: {
      type: "object",
      propertyNames: path,
      additionalProperties: record({
        elementSize: { enum: [1, 2, 4] }, distance: integer(0), size: integer(0, LARGEST),
        sha256: { type: "string", pattern: "^[0-9a-f]{64}$" },
      }),
    },
  }),
  RNA_poster: record({ image: path, width: integer(1), height: integer(1) }),
  RNA_standin: record({
    parts: forParts(record({
      baseColor: { type: "array", items: share, minItems: 3, maxItems: 3 }, roughness: share, metallic: share,
    })),
  }),
  RNA_standin_textures: record({ parts: forParts(orNull(record({ baseColor: path, metallicRoughness: path, normal: path }))) }),
  RNA_proxy: record({
    parts: forParts(orNull({ type: "array", minItems: 1, maxItems: 8, items: record({ geometry: path, height: integer(1) }) })),
  }),
  RNA_variants: {
    $defs: published.$defs,
    ...record({
      variants: {
        type: "array", minItems: 1, maxItems: 64,
        items: record({
          name: { type: "string", minLength: 1 }, parts: forParts(orNull(changes)),
        }),
      },
    }),
  },
  RNA_environment: ENVIRONMENT_SCHEMA,
  RNA_sampling: SAMPLING_SCHEMA,
};
/** The prints that a manifest names, with what they have in the place of base colour. */
export const variantsOf = ({ extensions }) => extensions?.RNA_variants?.variants ?? [];

export const KNOWN_EXTENSIONS = Object.keys(SCHEMAS);

/** Fails where the data of a known extension is not as it must be. */
export function checkExtensions(manifest) {
  const data = manifest.extensions ?? {};
  for (const name of KNOWN_EXTENSIONS) {
    const where = `/extensions/${name}`;
    if (!Object.hasOwn(data, name)) {
      if (manifest.extensionsUsed?.includes(name)) fail("FIELD_MISSING", where, "its data is missing");
      continue;
    }
    checkSchema(SCHEMAS[name], data[name], where);
    CHECKS[name](data[name], manifest, where);
  }
}

function checkReference(manifest, name, where) {
  if (!Object.hasOwn(manifest.entries, name)) fail("REFERENCE_MISSING", where, `no entry ${name}`);
}

function checkCount(parts, manifest, where) {
  if (parts.length !== manifest.parts.length) {
    fail("PARTS_DIFFER", where, `found ${parts.length} parts, expected ${manifest.parts.length}`);
  }
}

const CHECKS = {
  RNA_deflate({ entries }, manifest, where) {
    if (!manifest.extensionsRequired?.includes("RNA_deflate")) {
      fail("EXTENSION_UNDECLARED", where, "RNA_deflate is not in extensionsRequired");
    }
    const total = Object.values(entries).reduce((sum, { size }) => sum + size, 0);
    if (total > LARGEST) fail("FIELD_VALUE", where, `${total} decoded bytes`);
    for (const [name, { size }] of Object.entries(entries)) {
      checkReference(manifest, name, where);
      const most = DEFLATE_ALLOWANCE + DEFLATE_RATIO * manifest.entries[name].size;
      if (size > most) fail("DEFLATE_SIZE", `${where}/entries/${name}/size`, `${size} decoded bytes; at most ${most}`);
    }
  },
  RNA_poster({ image }, manifest, where) {
    checkReference(manifest, image, where);
  },
  RNA_standin({ parts }, manifest, where) {
    checkCount(parts, manifest, where);
  },
  RNA_standin_textures({ parts }, manifest, where) {
    checkCount(parts, manifest, where);
    if (!parts.some((textures) => textures)) fail("FIELD_VALUE", where, "textures of no part");
    parts.forEach((textures, k) => {
      const { kind, transmittance, normalMaps } = manifest.parts[k];
      if (textures && (kind !== "surface" || transmittance || normalMaps)) fail("FIELD_VALUE", where, "textures of a part that has none");
      for (const name of Object.values(textures ?? {})) checkReference(manifest, name, where);
    });
  },
  RNA_proxy({ parts }, manifest, where) {
    checkCount(parts, manifest, where);
    if (!parts.some((levels) => levels)) fail("FIELD_VALUE", where, "a proxy of no part");
    parts.forEach((levels, k) => {
      const { transmittance, normalMaps, baseColor } = manifest.parts[k];
      if (levels && (transmittance || normalMaps || baseColor)) fail("FIELD_VALUE", where, "a proxy of a part with textures");
      (levels ?? []).forEach(({ geometry, height }, j) => {
        checkReference(manifest, geometry, where);
        if (j && height >= levels[j - 1].height) fail("FIELD_VALUE", where, "heights must descend");
      });
    });
  },
  RNA_variants({ variants }, manifest, where) {
    if (new Set(variants.map(({ name }) => name)).size < variants.length) fail("FIELD_VALUE", where, "two variants of one name");
    for (const { name, parts } of variants) {
      checkCount(parts, manifest, where);
      parts.forEach((changes, k) => {
        const records = manifest.parts[k].baseColor?.length ?? 0;
        if (changes && changes.length !== records) fail("FIELD_VALUE", where, `${name}: ${changes.length} records, expected ${records}`);
        for (const change of changes ?? []) if (change?.image !== undefined) checkReference(manifest, change.image, where);
      });
    }
  },
  RNA_environment(data, manifest, where) {
    checkCount(data.parts, manifest, where);
    checkEnvironment(data, manifest, where);
  },
  RNA_sampling(data, manifest, where) {
    checkCount(data.parts, manifest, where);
    checkSampling(data, manifest, where);
  },
};
