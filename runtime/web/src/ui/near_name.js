// Names that are nearly one of ours: what people meant.

/** The one of `names` that `name` is nearly; undefined for what is like none of them. */
export const nearName = (name, names) => names.find((known) => distance(name.toLowerCase(), known) <= (known.length > 3 ? 2 : 1));

/** Letters to insert, delete or replace between two words (Levenshtein), neighbours that changed places counted as 1. */
function distance(a, b) {
  const rows = [Array.from({ length: b.length + 1 }, (_, k) => k)];
  for (let i = 1; i <= a.length; i++) {
    rows.push([i]);
    for (let j = 1; j <= b.length; j++) {
      const swapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1] ? rows[i - 2][j - 2] + 1 : Infinity;
      const replaced = rows[i - 1][j - 1] + Number(a[i - 1] !== b[j - 1]);
      rows[i].push(Math.min(rows[i - 1][j] + 1, rows[i][j - 1] + 1, replaced, swapped));
    }
  }
  return rows[a.length][b.length];
}
