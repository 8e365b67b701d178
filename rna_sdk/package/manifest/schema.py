"""The JSON Schema of manifest.json; `python -m rna_sdk.package.manifest.schema` writes it."""

import json
import sys
from typing import Any

from pydantic import BaseModel
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from rna_sdk.package.generated import generate
from rna_sdk.package.manifest.manifest_model import REQUIRED_IN_FILE, VERSION, Manifest

SCHEMA_FILE = "spec/schema/manifest.schema.json"


_NO_LINE_BREAK = {"not": {"pattern": "\n"}}
"""The `$` of some regular expressions matches before a line break at the end as well."""


class _Generator(GenerateJsonSchema):
    """Leaves out titles, which only repeat the names, and binds all keys of an object."""

    def field_title_should_be_set(self, schema: object) -> bool:
        return False

    def str_schema(self, schema: core_schema.StringSchema) -> JsonSchemaValue:
        result = super().str_schema(schema)
        return result | _NO_LINE_BREAK if "pattern" in result else result

    def dict_schema(self, schema: core_schema.DictSchema) -> JsonSchemaValue:
        """Keys that do not match `patternProperties` would be let through."""
        result = super().dict_schema(schema)
        if "patternProperties" in result:
            ((pattern, values),) = result.pop("patternProperties").items()
            result["additionalProperties"] = values
            result["propertyNames"] = {"pattern": pattern, **result.get("propertyNames", {})}
        return result


def model_schema(model: type[BaseModel]) -> dict[str, Any]:
    """The schema of the manifest, or of the data of an extension."""
    return model.model_json_schema(by_alias=True, schema_generator=_Generator)


def manifest_schema() -> str:
    """The schema (draft 2020-12), as the text of the file.

    It covers each field by itself. What spans fields or numbers (names that must be unique, parts
    that must be the same in all tiers, blocks and transmittance for the kind, ranges,
    paths and extensions that must be declared, bounds with an extent, axes of unit length, heights
    that descend) is the validator's.
    """
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"RNA {VERSION} manifest.json",
        **model_schema(Manifest),
    }
    schema["required"] = [*REQUIRED_IN_FILE, *schema["required"]]
    for member in REQUIRED_IN_FILE:
        schema["properties"][member].pop("default", None)
    return json.dumps(schema, indent=2) + "\n"


if __name__ == "__main__":
    sys.exit(generate({SCHEMA_FILE: manifest_schema()}, "rna_sdk.package.manifest.schema"))
