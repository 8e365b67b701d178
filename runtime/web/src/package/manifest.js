// manifest.json (spec, 3): its members by the published schema, then what spans them.
import schema from "../../../../spec/schema/manifest.schema.json";
import { blockNamed } from "./blocks.js";
import { fail } from "./errors.js";
import { checkExtensions, KNOWN_EXTENSIONS } from "./extensions.js";
import { parseJson } from "./json.js";
import { checkSchema } from "./schema.js";

const READER = "2.0";
/** Records of ranges of triangles. */
const RANGES = [["transmittance", "TRANSMITTANCE_RANGE"], ["normalMaps", "NORMAL_MAP_RANGE"], ["baseColor", "BASE_COLOR_RANGE"]];
const VERSION = /^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;

/** The manifest, checked, with `warnings`. */
export function readManifest(bytes) {
  const manifest = parseJson(bytes, "manifest.json", "MANIFEST_NOT_JSON");
  checkFirst(manifest);
  checkSchema(schema, manifest);
  checkBounds(manifest);
  checkNames(manifest);
  checkParts(manifest);
  checkUsed(manifest);
  checkExtensions(manifest);
  checkInputs(manifest);
  checkRecords(manifest);
  checkReferences(manifest);
  const unknown = (manifest.extensionsUsed ?? []).filter((name) => !KNOWN_EXTENSIONS.includes(name));
  return { ...manifest, warnings: unknown.map((name) => `unknown extension ${name}`) };
}

/** The checks before all other members. */
function checkFirst(manifest) {
  if (manifest.format !== "rna") fail("FORMAT_UNKNOWN", "/format", "this is no RNA package");
  const { version } = manifest;
  if (typeof version === "string" && VERSION.test(version) && version !== READER) {
    const code = parseInt(version, 10) < parseInt(READER, 10) ? "VERSION_TOO_OLD" : "VERSION_TOO_NEW";
    fail(code, "/version", `the package is of version ${version}; this viewer reads ${READER}`);
  }
  for (const part of Array.isArray(manifest.parts) ? manifest.parts : []) {
    if (part?.kind !== undefined && !["surface", "fiber"].includes(part.kind)) {
      fail("KIND_UNSUPPORTED", "/kind", `found ${JSON.stringify(part.kind)}, expected surface or fiber`);
    }
  }
  for (const name of Array.isArray(manifest.extensionsRequired) ? manifest.extensionsRequired : []) {
    if (typeof name === "string" && !KNOWN_EXTENSIONS.includes(name)) {
      fail("EXTENSION_REQUIRED", "/extensionsRequired", `this viewer does not know ${name}`);
    }
  }
}

function checkBounds(manifest) {
  manifest.parts.forEach(({ bounds: { min, max } }, k) => {
    min.forEach((low, axis) => {
      if (!(Math.fround(max[axis]) - Math.fround(low) >= 1e-18)) {
        fail("BOUNDS_EMPTY", `/parts/${k}/bounds`, `no extent along axis ${axis}`);
      }
    });
  });
  for (const side of ["wo", "wi"]) {
    const cones = manifest.domain[side];
    for (const { axis } of Array.isArray(cones) ? cones : []) {
      if (Math.abs(Math.hypot(...axis) - 1) > 1e-3) fail("FIELD_VALUE", `/domain/${side}`, "an axis is no unit vector");
    }
  }
}

function checkNames(manifest) {
  for (const [list, code] of [["tiers", "TIER_DUPLICATE"], ["parts", "PART_DUPLICATE"]]) {
    const names = manifest[list].map(({ name }) => name);
    if (new Set(names).size !== names.length) fail(code, `/${list}`, "a name is there twice");
  }
  manifest.tiers.forEach(({ validation, parts }, k) => {
    parts.forEach(({ nearby }, j) => {
      if (nearby?.lengths.some((length, i, all) => i && length <= all[i - 1])) {
        fail("FIELD_VALUE", `/tiers/${k}/parts/${j}/nearby/lengths`, "lengths must ascend");
      }
    });
    (validation?.flipAtHeight ?? []).forEach(({ height }, j, all) => {
      if (j && height >= all[j - 1].height) {
        fail("FIELD_VALUE", `/tiers/${k}/validation/flipAtHeight/${j}`, "heights must descend");
      }
    });
  });
}

function checkParts(manifest) {
  manifest.tiers.forEach((tier, k) => {
    if (tier.parts.length !== manifest.parts.length) {
      fail("PARTS_DIFFER", `/tiers/${k}/parts`, `found ${tier.parts.length}, expected ${manifest.parts.length}`);
    }
    tier.parts.forEach((part, j) => {
      if (!part.emission !== !manifest.tiers[0].parts[j].emission) {
        fail("PARTS_DIFFER", `/tiers/${k}/parts/${j}`, "emission in some tiers alone");
      }
      if (part.usesBaseColor && !manifest.parts[j].baseColor) {
        fail("FIELD_VALUE", `/tiers/${k}/parts/${j}/usesBaseColor`, `found true, expected false, or baseColor in /parts/${j}`);
      }
    });
  });
}

function checkUsed(manifest) {
  const used = manifest.extensionsUsed ?? [];
  for (const name of [...Object.keys(manifest.extensions ?? {}), ...(manifest.extensionsRequired ?? [])]) {
    if (!used.includes(name)) fail("EXTENSION_UNDECLARED", "/extensionsUsed", `${name} is not there`);
  }
}

function checkInputs(manifest) {
  manifest.tiers.forEach((tier, i) => tier.parts.forEach((part, k) => {
    const { kind } = manifest.parts[k];
    const check = (inputs, allowed) => {
      for (const name of inputs) {
        if (!allowed(blockNamed(name))) fail("INPUT_KIND", `/tiers/${i}/parts/${k}/inputs`, `${name} is not for this part`);
      }
    };
    check(part.inputs, ({ kinds }) => kinds.includes(kind));
    check(part.shadowed?.inputs ?? [], ({ kinds }) => kinds.includes(kind));
    check(part.emission?.inputs ?? [], ({ kinds, light }) => kinds.includes(kind) && !light);
  }));
}

function checkRecords(manifest) {
  manifest.parts.forEach((part, k) => {
    for (const [name, code] of RANGES) {
      const where = `/parts/${k}/${name}`;
      if (part[name] && part.kind !== "surface") fail("FIELD_VALUE", where, `of a ${part.kind}`);
      let next = 0;
      (part[name] ?? []).forEach(({ triangles: [first, count] }, j) => {
        if (first < next) fail(code, `${where}/${j}`, "ranges must ascend and not overlap");
        next = first + count;
      });
    }
  });
}

/** Entry names that the manifest's paths name, with where they stand. */
function* references(manifest) {
  for (const [k, part] of manifest.parts.entries()) {
    yield [`/parts/${k}/geometry`, part.geometry];
    for (const [name] of RANGES) {
      for (const [j, { texture, image }] of (part[name] ?? []).entries()) {
        if (texture ?? image) yield [`/parts/${k}/${name}/${j}`, texture ?? image];
      }
    }
  }
  for (const [i, tier] of manifest.tiers.entries()) {
    for (const [k, part] of tier.parts.entries()) {
      const where = `/tiers/${i}/parts/${k}`;
      yield [`${where}/planes`, part.planes];
      yield [`${where}/decoder`, part.decoder];
      for (const name of ["shadowed", "emission"]) {
        if (part[name]) yield [`${where}/${name}/decoder`, part[name].decoder];
      }
    }
  }
}

function checkReferences(manifest) {
  const named = new Set();
  for (const [where, name] of references(manifest)) {
    if (!Object.hasOwn(manifest.entries, name)) fail("REFERENCE_MISSING", where, `no entry ${name}`);
    named.add(name);
  }
  const folders = (manifest.extensionsUsed ?? []).map((name) => `extensions/${name}/`);
  for (const name of Object.keys(manifest.entries)) {
    if (!named.has(name) && !folders.some((folder) => name.startsWith(folder))) {
      fail("ENTRY_UNREFERENCED", "/entries", `nothing refers to ${name}`);
    }
  }
}

/** The archive holds the declared entries, and no others. */
export function checkEntries(manifest, directory) {
  for (const name of directory.keys()) {
    if (name !== "manifest.json" && !Object.hasOwn(manifest.entries, name)) {
      fail("ENTRY_UNDECLARED", "/entries", `the archive holds ${name}`);
    }
  }
  for (const [name, { size }] of Object.entries(manifest.entries)) {
    const entry = directory.get(name);
    if (!entry || name === "manifest.json") fail("ENTRY_MISSING", "/entries", `the archive lacks ${name}`);
    if (entry.size !== size) fail("ENTRY_SIZE", `/entries/${name}`, `found ${entry.size}, expected ${size}`);
  }
}
