// What is wrong with a package: one line with the code of spec/ISSUES.md and the place.

export class PackageError extends Error {
  constructor(code, where, text) {
    super(`${where ? where + ": " : ""}${text} [${code}]`);
    this.code = code;
    this.where = where;
  }
}

export function fail(code, where, text) {
  throw new PackageError(code, where, text);
}

/** Something in order that this viewer cannot do; the package may be valid. */
export class NotSupported extends Error {}
