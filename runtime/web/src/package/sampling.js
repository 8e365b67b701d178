// RNA_sampling (spec, 12): lobes that rays leave the parts in.
import { usualLobes } from "../decoder/records.js";
import { fail } from "./errors.js";
import { forParts, integer, orNull, record, share } from "./schema_parts.js";

const MOST_MIXTURES = 16, NARROW = 3, LARGEST_SHARE = 0.99;
const OF_KIND = { surface: ["cosine", "mirror"], fiber: ["forward", "cone"] };
const lobe = (minimum, maximum) => record({ share, width: { type: "number", minimum, maximum } });
const some = (items) => ({ type: "array", minItems: 1, maxItems: NARROW, items });
const MIRROR = lobe(1e-4, 1), FIBER = lobe(0.01, 4);
export const SAMPLING_SCHEMA = record({
  parts: forParts(orNull({
    type: "array", minItems: 1, maxItems: MOST_MIXTURES,
    items: {
      type: "object", additionalProperties: false,
      properties: { first: integer(0), cosine: share, mirror: some(MIRROR), forward: FIBER, cone: some(FIBER) },
    },
  })),
});

/** Fails where the data, which fits the schema and has mixtures or null a part, is not as it must be. */
export function checkSampling({ parts }, manifest, where) {
  if (!parts.some((mixtures) => mixtures)) fail("FIELD_VALUE", where, "lobes of no part");
  parts.forEach((mixtures, k) => mixtures?.forEach((mixture, j) => {
    const { kind } = manifest.parts[k], at = `${where}/parts/${k}/${j}`, { first = 0, ...lobes } = mixture;
    const stranger = Object.keys(lobes).find((name) => !OF_KIND[kind].includes(name));
    if (stranger) fail("FIELD_VALUE", `${at}/${stranger}`, `found ${stranger}, expected ${OF_KIND[kind].join(" and ")} of a ${kind}`);
    const total = lobesOf(lobes, kind).lobe_shares.reduce((sum, share) => sum + share, 0);
    if (total > LARGEST_SHARE) fail("FIELD_VALUE", at, `found shares that add up to ${total}, expected at most ${LARGEST_SHARE}`);
    const fits = j === 0 ? first === 0 : first > (mixtures[j - 1].first ?? 0) && kind === "surface";
    if (!fits) fail("FIELD_VALUE", `${at}/first`, `found ${first}, expected 0, then each above the one before`);
  }));
}

/** Mixtures of a part: the first triangle, and members of surfaces: shares and widths of the broad lobe, then of narrow ones. */
export function samplingOf({ parts, extensions }, k) {
  const mixtures = extensions?.RNA_sampling?.parts[k], { kind } = parts[k];
  return mixtures?.map(({ first = 0, ...lobes }) => ({ first, lobes: lobesOf(lobes, kind) })) ?? [{ first: 0, lobes: usualLobes[kind] }];
}

function lobesOf({ cosine = 0, mirror = [], forward = { share: 0, width: 1 }, cone = [] }, kind) {
  const lobes = kind === "fiber" ? [forward, ...cone] : [{ share: cosine, width: 1 }, ...mirror];
  while (lobes.length < 1 + NARROW) lobes.push({ share: 0, width: 1 });
  return { lobe_shares: lobes.map(({ share }) => share), lobe_widths: lobes.map(({ width }) => width) };
}
