// What the page's address asks for: attributes of the element, as ?src=toy.rna&samples=64, and parameters of the page.
import { READERS } from "../element/attributes.js";
import { fileAddress } from "../package/file_address.js";
import { nearName } from "../ui/near_name.js";

const FILES = ["src", "environment", "scene"];
const OWN = ["ui", "bench"];  // of the page: 0 or 1

/** { attributes, ofPage, problems }: by name; the element tells of values that it cannot read. problems: a line each. */
export function readParameters(address) {
  const attributes = new Map(), ofPage = new Map(), problems = [];
  for (const [name, value] of new URLSearchParams(address)) {
    if (Object.hasOwn(READERS, name)) attributes.set(name, FILES.includes(name) ? fileAddress(value) : value);
    else if (OWN.includes(name) && /^[01]$/.test(value)) ofPage.set(name, value === "1");
    else problems.push(OWN.includes(name) ? `${name}: expected 0 or 1, found ${JSON.stringify(value)}` : misspelt(name));
  }
  return { attributes, ofPage, problems: problems.filter(Boolean) };
}

/** The line for a name that is nearly one of ours; null for others, which analytics and the like add to addresses. */
function misspelt(name) {
  const near = nearName(name, [...Object.keys(READERS), ...OWN]);
  return near ? `?${name}= is no parameter of this page: did you mean ${near}=?` : null;
}
