// Pieces of the schemas of extensions.
export const share = { type: "number", minimum: 0, maximum: 1 };
export const integer = (minimum, maximum = Number.MAX_SAFE_INTEGER) => ({ type: "integer", minimum, maximum });

/** An object of these members, all of them required. */
export const record = (properties) =>
  ({ type: "object", properties, required: Object.keys(properties), additionalProperties: false });

export const orNull = (schema) => ({ anyOf: [{ type: "null" }, schema] });

/** A value for each of an asset's parts. */
export const forParts = (items) => ({ type: "array", minItems: 1, maxItems: 16, items });
