// Names of files as addresses.

/**
 * A file's address. "#" is a letter of its name, for files have no places in them that an address could name; so is
 * "%" without two digits of an encoded byte behind it.
 */
export function fileAddress(value) {
  return value.replaceAll("#", "%23").replace(/%(?![0-9a-f]{2})/gi, "%25");
}
