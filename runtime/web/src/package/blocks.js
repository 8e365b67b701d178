// The input blocks of decoders, by their index: spec/blocks.json.
import tables from "../../../../spec/blocks.json";

export const BLOCKS = tables.blocks;

export const blockNamed = (name) => BLOCKS.find((block) => block.name === name);

/** Columns of a block; `features` have as many as the planes have channels. */
export const widthOf = (name, channels) => blockNamed(name).width ?? channels;
