// As much of JSON Schema as spec/schema/manifest.schema.json uses, with the codes of the spec.
import { fail } from "./errors.js";

const TYPES = {
  object: (v) => v !== null && typeof v === "object" && !Array.isArray(v),
  array: Array.isArray,
  string: (v) => typeof v === "string",
  number: (v) => typeof v === "number",
  integer: (v) => Number.isSafeInteger(v),
  boolean: (v) => typeof v === "boolean",
  null: (v) => v === null,
};

/** Fails with FIELD_UNKNOWN, FIELD_MISSING or FIELD_VALUE where `value` is not as `schema` says. */
export function checkSchema(schema, value, where = "") {
  new Checker(schema).check(schema, value, where);
}

class Checker {
  constructor(root) {
    this.root = root;
  }

  fits(schema, value) {
    try {
      this.check(schema, value, "");
      return true;
    } catch {
      return false;
    }
  }

  check(schema, value, where) {
    if (schema.$ref) this.check(this.root.$defs[schema.$ref.split("/").pop()], value, where);
    const wrong = (expected) => fail("FIELD_VALUE", where, `found ${shown(value)}, expected ${expected}`);
    if (schema.type && !TYPES[schema.type](value)) wrong(schema.type);
    if ("const" in schema && value !== schema.const) wrong(shown(schema.const));
    if (schema.enum && !schema.enum.includes(value)) {
      if (schema.enum.includes("features")) fail("INPUT_UNKNOWN", where, `no block ${shown(value)}`);
      wrong(schema.enum.join(", "));
    }
    for (const choices of [schema.anyOf, schema.oneOf]) {
      if (choices && !choices.some((choice) => this.fits(choice, value))) {
        this.check(choices.find((c) => TYPES[c.type]?.(value)) ?? choices[0], value, where);
      }
    }
    if (schema.not && this.fits(schema.not, value)) wrong("another value");
    if (typeof value === "number") this.checkNumber(schema, value, wrong);
    if (typeof value === "string") this.checkString(schema, value, wrong);
    if (Array.isArray(value)) this.checkArray(schema, value, where, wrong);
    else if (TYPES.object(value)) this.checkObject(schema, value, where);
  }

  checkNumber(schema, value, wrong) {
    if (value < schema.minimum) wrong(`at least ${schema.minimum}`);
    if (value > schema.maximum) wrong(`at most ${schema.maximum}`);
    if (value <= schema.exclusiveMinimum) wrong(`more than ${schema.exclusiveMinimum}`);
    if (value >= schema.exclusiveMaximum) wrong(`less than ${schema.exclusiveMaximum}`);
  }

  checkString(schema, value, wrong) {
    if (value.length < schema.minLength) wrong(`${schema.minLength} characters or more`);
    if (value.length > schema.maxLength) wrong(`at most ${schema.maxLength} characters`);
    if (schema.pattern && !new RegExp(schema.pattern, "u").test(value)) wrong(schema.pattern);
  }

  checkArray(schema, value, where, wrong) {
    if (value.length < schema.minItems) wrong(`${schema.minItems} items or more`);
    if (value.length > schema.maxItems) wrong(`at most ${schema.maxItems} items`);
    value.forEach((item, k) => {
      const rule = schema.prefixItems?.[k] ?? schema.items;
      if (rule) this.check(rule, item, `${where}/${k}`);
    });
    if (schema.uniqueItems && new Set(value).size !== value.length) {
      fail("INPUT_UNKNOWN", where, "a name twice");
    }
  }

  checkObject(schema, value, where) {
    const keys = Object.keys(value), known = schema.properties ?? {};
    for (const key of keys) {
      if (schema.additionalProperties === false && !Object.hasOwn(known, key)) {
        fail("FIELD_UNKNOWN", `${where}/${key}`, "no such member");
      }
      if (schema.propertyNames) this.check({ type: "string", ...schema.propertyNames }, key, `${where}/${key}`);
    }
    for (const key of schema.required ?? []) {
      if (!Object.hasOwn(value, key)) fail("FIELD_MISSING", `${where}/${key}`, "missing");
    }
    for (const key of keys) {
      const rule = Object.hasOwn(known, key) ? known[key] : schema.additionalProperties;
      if (rule) this.check(rule, value[key], `${where}/${key}`);
    }
  }
}

function shown(value) {
  const text = JSON.stringify(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
}
