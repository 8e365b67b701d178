// What the page's address asks for: attributes of the element, as ?src=toy.rna&samples=64, and parameters of the page.
import { READERS } from "../element/attributes.js";
import { fileAddress } from "../package/file_address.js";

const FILES = ["src", "environment", "scene"];
const OWN = ["ui", "bench"];  // of the page: 0 or 1

/** { attributes, own, problems }: by name; the element tells of values that it cannot read. problems: a line each. */
export function readParameters(address) {
  const attributes = new Map(), own = new Map(), problems = [];
  for (const [name, value] of new URLSearchParams(address)) {
    if (Object.hasOwn(READERS, name)) attributes.set(name, FILES.includes(name) ? fileAddress(value) : value);
    else if (OWN.includes(name) && /^[01]$/.test(value)) own.set(name, value === "1");
    else problems.push(OWN.includes(name) ? `${name}: expected 0 or 1, found ${JSON.stringify(value)}` : misspelt(name));
  }
  return { attributes, own, problems: problems.filter(Boolean) };
}

/** The line for a name that is nearly one of ours; null for others, which analytics and the like add to addresses. */
function misspelt(name) {
  const near = [...Object.keys(READERS), ...OWN].find((known) => distance(name.toLowerCase(), known) <= (known.length > 3 ? 2 : 1));
  return near ? `?${name}= is no parameter of this page: did you mean ${near}=?` : null;
}

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
