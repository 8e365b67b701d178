// Loads packages as three.js loads models.
import { FileLoader, Loader } from "three/webgpu";
import { RnaAsset } from "./asset.js";
import { optionsOf } from "./options.js";
import { read } from "./reading.js";

export class RnaLoader extends Loader {
  constructor(manager) {
    super(manager);
    this.tier = this.variant = null;
    this.options = {};
    this.aborting = new AbortController();
    this.files = new Set();
  }

  /** Reads this tier of a package alone; null: all, and each picture chooses. */
  setTier(name) {
    this.tier = name;
    return this;
  }

  /** Shows this variant of a package; null: its own print. */
  setVariant(name) {
    this.variant = name;
    return this;
  }

  /** Of RnaAsset, for what is loaded from here on. */
  setOptions(options) {
    this.options = optionsOf({ ...this.options, ...options });
    return this;
  }

  load(url, onLoad = () => {}, onProgress, onError) {
    const { manager } = this, file = this._file(), address = manager.resolveURL(this.path + url);
    manager.itemStart(address);
    const failed = (error) => {
      if (onError) onError(error);
      else console.error(`RnaLoader: ${error.message}`);
      manager.itemError(address);
      manager.itemEnd(address);
    };
    const done = (asset) => {
      onLoad(asset);
      manager.itemEnd(address);
    };
    this.files.add(file);
    file.load(url, (bytes) => {
      this.files.delete(file);
      this.parseAsync(bytes, nameOf(address)).then(done).catch(failed);
    }, onProgress, (error) => {
      this.files.delete(file);
      failed(error);
    });
  }

  /** bytes: an ArrayBuffer, which stays as it is. */
  parse(bytes, onLoad, onError = (error) => console.error(`RnaLoader: ${error.message}`)) {
    this.parseAsync(bytes).then(onLoad, onError);
  }

  async parseAsync(bytes, name = "package") {
    return new RnaAsset(await read(bytes, name, this, this.aborting.signal), this.options);
  }

  abort() {
    for (const file of this.files) file.abort();
    this.aborting.abort();
    this.aborting = new AbortController();
    return this;
  }

  _file() {
    const { path, requestHeader, withCredentials, priority, cache } = this;  // before three.js 0.187 there is no priority and no cache
    return Object.assign(new FileLoader(this.manager), { path, requestHeader, withCredentials, priority, cache, responseType: "arraybuffer" });
  }
}

function nameOf(url) {
  const last = url.split(/[?#]/)[0].split("/").pop();
  try {
    return decodeURIComponent(last);
  } catch {
    return last;  // with a "%" that encodes nothing
  }
}
