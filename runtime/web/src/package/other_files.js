// What hosts send, and people name, in the place of a package.

/** Such a thing, for a line of words; null for anything else. */
export function otherFile(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 512)).trimStart();
  if (text.startsWith("version https://git-lfs.github.com/")) return "a pointer of Git LFS, in whose place `git lfs pull` puts the file";
  if (/^<(!doctype\s+html|html|head|body)\b/i.test(text)) return "an HTML page: there is no such file, or it has another address";
  return null;
}

const MODELS = { glTF: ["glTF", "glb"], BLENDER: ["Blender", "blend"] };  // by first bytes: the name, and the suffix

/** A model of which a package can be made, in the same way. */
export function modelFile(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 8)), start = Object.keys(MODELS).find((one) => text.startsWith(one));
  if (!start) return null;
  const [name, suffix] = MODELS[start];
  return `a ${name} file: rna-make makes a package of it, as rna-make model.${suffix} --out model.rna`;
}
