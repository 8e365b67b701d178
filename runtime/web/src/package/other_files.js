// What hosts send, and people name, in the place of a package.

/** Such a thing, for a line of words; null for anything else. */
export function otherFile(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 512)).trimStart();
  if (text.startsWith("version https://git-lfs.github.com/")) return "a pointer of Git LFS, in whose place `git lfs pull` puts the file";
  if (/^<(!doctype\s+html|html|head|body)\b/i.test(text)) return "an HTML page: there is no such file, or it has another address";
  if (text.startsWith("glTF")) return "a glTF file: rna-make makes a package of it, as rna-make model.glb --out model.rna";
  if (text.startsWith("BLENDER")) return "a Blender file: rna-make makes a package of it, as rna-make model.blend --out model.rna";
  return null;
}
