// What is wrong with a package: one line with the code of spec/ISSUES.md and the place.

export class PackageError extends Error {
  constructor(code, where, text) {
    super(`${where ? where + ": " : ""}${text.slice(0, 400)} [${code}]`);  // a value may be as long as its file
    this.code = code;
    this.where = where;
  }
}

export function fail(code, where, text) {
  throw new PackageError(code, where, text);
}

/** Something in order that this viewer cannot do; the package may be valid. */
export class NotSupported extends Error {}
