// What hosts send in the place of a file.

/** Such a thing, for a line of words; null for anything else. */
export function otherFile(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 512)).trimStart();
  if (text.startsWith("version https://git-lfs.github.com/")) return "a pointer of Git LFS, in whose place `git lfs pull` puts the file";
  if (/^<(!doctype\s+html|html|head|body)\b/i.test(text)) return "an HTML page: there is no such file, or it has another address";
  return null;
}
