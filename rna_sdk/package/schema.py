"""The JSON Schema of manifest.json; `python -m rna_sdk.package.schema` writes it."""

from __future__ import annotations

import json
import sys

from pydantic.json_schema import GenerateJsonSchema

from rna_sdk.package.generated import generate
from rna_sdk.package.manifest import REQUIRED_IN_FILE, Manifest

SCHEMA_FILE = "schema/manifest.schema.json"


class _Untitled(GenerateJsonSchema):
    """Leaves out titles, which only repeat the names."""

    def field_title_should_be_set(self, schema: object) -> bool:
        return False


def manifest_schema() -> str:
    """The schema (draft 2020-12), as the text of the file.

    It covers each field by itself. What spans fields (names that must be unique, paths that
    must be declared, bounds with an extent) is the validator's.
    """
    schema = Manifest.model_json_schema(by_alias=True, schema_generator=_Untitled)
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "RNA 1.0 manifest.json",
        **{key: value for key, value in schema.items() if key != "title"},
    }
    schema["required"] = [*REQUIRED_IN_FILE, *schema["required"]]
    for name in REQUIRED_IN_FILE:
        schema["properties"][name].pop("default", None)
    return json.dumps(schema, indent=2) + "\n"


if __name__ == "__main__":
    sys.exit(generate(SCHEMA_FILE, manifest_schema(), "rna_sdk.package.schema"))
