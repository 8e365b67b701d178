// What the page's address asks for, as attributes of the element. What cannot be used is told and left out.
//   ?asset=toy.rna  &tier=small  &env=studio.hdr  &scene=scene.json  &ui=0  &view=filmic  &bench=1
//   &rounds=64  &dpr=1  &jitter=0 (rays through the middles of pixels, for comparisons)  &look=0 (no first look)

import { fileAddress } from "../package/file_address.js";

const anything = () => null;
const oneOf = (...choices) => (value) => (choices.includes(value) ? null : `expected ${choices.join(" or ")}`);
const number = (low, high, whole) => (value) => {
  const found = Number(value);
  const fits = value.trim() !== "" && found >= low && found <= high && (!whole || Number.isInteger(found));
  return fits ? null : `expected a ${whole ? "whole " : ""}number from ${low} to ${high}`;
};

const CHECKS = {
  asset: anything, tier: anything, env: anything, scene: anything,  // whoever opens them tells
  ui: oneOf("0", "1"), bench: oneOf("0", "1"), jitter: oneOf("0", "1"), look: oneOf("0", "1"), view: oneOf("srgb", "filmic"),
  rounds: number(1, 1e6, true), dpr: number(0.1, 8, false),
};

/** By parameter, the element's attribute and its value. */
export const ATTRIBUTES = {
  asset: (value) => ["src", fileAddress(value)], env: (value) => ["environment", fileAddress(value)],
  scene: (value) => ["scene", fileAddress(value)], tier: (value) => ["tier", value], view: (value) => ["view-transform", value],
  rounds: (value) => ["samples", value], dpr: (value) => ["pixel-ratio", value],
  jitter: (value) => ["jitter", value], look: (value) => ["first-look", value === "0" ? "off" : "auto"],
};

/** { parameters, problems }: of the address. problems: a line each. */
export function readParameters(address) {
  const parameters = new Map(), problems = [];
  for (const [name, value] of new URLSearchParams(address)) {
    const wrong = Object.hasOwn(CHECKS, name) ? CHECKS[name](value) : misspelt(name);
    if (wrong) problems.push(Object.hasOwn(CHECKS, name) ? `?${name}=: ${wrong}, found ${value}` : wrong);
    else parameters.set(name, value);
  }
  return { parameters, problems };
}

/** The line for a name that is nearly one of ours; null for others, which analytics and the like add to addresses. */
function misspelt(name) {
  const near = Object.keys(CHECKS).find((known) => distance(name.toLowerCase(), known) <= (known.length > 3 ? 2 : 1));
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
