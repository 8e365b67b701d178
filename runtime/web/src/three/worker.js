// The worker of RnaLoader: one package a message.
import { buffersOf, readAsset } from "./read_asset.js";

onmessage = async ({ data: { number, bytes, name, tier, variant } }) => {
  try {
    const asset = await readAsset(bytes, name, tier, variant);
    postMessage({ number, asset }, buffersOf(asset));
  } catch (error) {
    postMessage({ number, error: { name: error.name, message: error.message, code: error.code } });
  }
};

postMessage("ready");
