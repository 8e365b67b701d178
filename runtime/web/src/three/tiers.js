// The tier for a size in the image, as rna_sdk.runtime.choose_tier has it.

/** Name of the cheapest tier whose mean FLIP is at most this at so many pixels; of the most accurate where none is. */
export function chooseTier(tiers, maxError, pixels) {
  const errors = tiers.map((tier) => expectedError(tier, pixels));
  const good = tiers.filter((_, k) => errors[k] <= maxError);
  if (good.length) return good.reduce((best, tier) => (tier.work < best.work ? tier : best)).name;
  const least = Math.min(...errors);
  return (tiers[errors.indexOf(least)] ?? tiers[0]).name;
}

/** Between recorded heights linear in the logarithm of the height. */
function expectedError({ validation }, pixels) {
  if (!validation) return Infinity;
  const table = [...(validation.flipAtHeight ?? [])].reverse();  // ascending
  if (!table.length) return validation.flip;
  const height = Math.max(1, pixels), above = table.findIndex((row) => row.height >= height);
  if (above === -1) return table.at(-1).flip;
  if (above === 0) return table[0].flip;
  const [a, b] = [table[above - 1], table[above]];
  return a.flip + (b.flip - a.flip) * (Math.log(height / a.height) / Math.log(b.height / a.height));
}
