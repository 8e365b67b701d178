// Source maps of the npm packages.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, relative, resolve } from "node:path";

/** Names sources from the folder `web` on, so that where a package is built leaves no trace in it. */
export function shortenSources(file, web) {
  const map = JSON.parse(readFileSync(file, "utf8"));
  map.sources = map.sources.map((source) => (source.includes(":") ? source : relative(web, resolve(dirname(file), source))));
  writeFileSync(file, JSON.stringify(map));
}
