"""Variants of a glTF file (KHR_materials_variants): other materials by name, shown in turn.

A package's variants differ by base colour alone, so the rest of two materials is compared here.
"""

import copy
from dataclasses import dataclass
from typing import Any

import bpy

EXTENSION = "KHR_materials_variants"

_DEFAULTS = {  # glTF 2.0, 5.19 and 5.22
    "alphaCutoff": 0.5,
    "alphaMode": "OPAQUE",
    "doubleSided": False,
    "emissiveFactor": [0.0, 0.0, 0.0],
    "metallicFactor": 1.0,
    "roughnessFactor": 1.0,
}
_NOT_COMPARED = ("name", "extras", "pbrMetallicRoughness", "baseColorFactor", "baseColorTexture")

Material = tuple[int, str | None]
"""Number in the file, and the attribute of colours of the primitive: Blender's importer makes a
material of each pair."""


@dataclass
class Variant:
    """materials: by the full name of a material, the full name of its replacement."""

    name: str
    materials: dict[str, str]


_variants: list[Variant] = []
_slots: list[tuple[bpy.types.Mesh, int, bpy.types.Material]] = []  # as they were opened


def opening() -> None:
    """Forget the variants of the file before."""
    _variants.clear()
    _slots.clear()


def described(data: Any) -> list[dict[str, Any]]:
    """A file's materials before Blender imports and changes them."""
    textures = [texture.to_dict() for texture in data.textures or []]
    return [_described(material, textures) for material in data.materials or []]


def read(data: Any, materials: list[dict[str, Any]]) -> list[str]:
    """Keep the variants of a file that was imported; returns notes on those that are left out.

    materials: what `described` gave.
    """
    said = (data.extensions or {}).get(EXTENSION) or {}
    notes = []
    for number, variant in enumerate(said.get("variants") or []):
        name = str(variant.get("name") or f"variant {number + 1}")
        changes = _changes(data, number)
        why = _why_not(changes, materials, data)
        if name in [one.name for one in _variants]:
            why = "another one has its name"
        if why is not None:
            notes.append(f"variant {name!r} is left out: {why}")
            continue
        named = {_name(data, base): _name(data, other) for base, (other,) in changes.items()}
        _variants.append(Variant(name, {a: b for a, b in named.items() if a != b}))
    return notes


def found() -> list[dict[str, Any]]:
    """The variants of the file that is open: `name` and `materials`, as in `Variant`."""
    return [{"name": one.name, "materials": one.materials} for one in _variants]


def show(name: str | None) -> None:
    """Show the materials of a variant; None: the materials of the file."""
    if not _slots:
        for mesh in bpy.data.meshes:
            _slots.extend((mesh, k, m) for k, m in enumerate(mesh.materials) if m is not None)
    materials = next((one.materials for one in _variants if one.name == name), {})
    for mesh, k, material in _slots:
        other = materials.get(material.name_full)
        mesh.materials[k] = material if other is None else bpy.data.materials[other]


def _changes(data: Any, variant: int) -> dict[Material | None, set[Material | None]]:
    """Material of the file -> its replacements in a variant, on any primitive."""
    result: dict[Material | None, set[Material | None]] = {}
    for mesh in data.meshes or []:
        for primitive in mesh.primitives:
            colours = "COLOR_0" if "COLOR_0" in primitive.attributes else None
            mappings = ((primitive.extensions or {}).get(EXTENSION) or {}).get("mappings") or []
            chosen = [m.get("material") for m in mappings if variant in m.get("variants", ())]
            base, other = (
                None if number is None else (number, colours)
                for number in (primitive.material, *(chosen or [primitive.material])[:1])
            )
            result.setdefault(base, set()).add(other)
    return result


def _why_not(
    changes: dict[Material | None, set[Material | None]], materials: list[dict[str, Any]], data: Any
) -> str | None:
    """Why a variant is no other base colour alone; None where it is."""
    for base, others in changes.items():
        if others == {base}:
            continue
        if base is None or None in others:
            return "it changes primitives without a material"
        if len(others) > 1:
            return f"it changes material {_name(data, base)!r} here and there only, or to several"
        (other,) = others
        assert other is not None
        differ = _differing(materials[base[0]], materials[other[0]])
        if differ:
            return (
                f"material {_name(data, other)!r} differs from {_name(data, base)!r} by "
                f"{', '.join(differ)}, where base colour alone may"
            )
    return None


def _name(data: Any, material: Material | None) -> str:
    """Full name in Blender."""
    if material is None:
        return ""
    number, colours = material
    name: str = data.materials[number].blender_material.get(colours, "")
    return name


def _described(material: Any, textures: list[dict[str, Any]]) -> dict[str, Any]:
    members = copy.deepcopy(material.to_dict())
    members |= members.get("pbrMetallicRoughness") or {}
    members = {name: value for name, value in members.items() if value is not None}
    described: dict[str, Any] = _with_images(_DEFAULTS | members, textures)
    return described


def _with_images(members: Any, textures: list[dict[str, Any]]) -> Any:
    """The members with textures in the place of their numbers, without names."""
    if isinstance(members, list):
        return [_with_images(one, textures) for one in members]
    if not isinstance(members, dict):
        return members
    result = {name: _with_images(value, textures) for name, value in members.items()}
    index = result.get("index")
    if isinstance(index, int) and 0 <= index < len(textures):
        result["index"] = {k: v for k, v in textures[index].items() if k != "name"}
    return result


def _differing(base: dict[str, Any], other: dict[str, Any]) -> list[str]:
    """Members by which two materials differ, base colour aside, and why its alpha counts."""
    names = sorted((base.keys() | other.keys()) - set(_NOT_COMPARED))
    differ = [name for name in names if base.get(name) != other.get(name)]
    if base["alphaMode"] != "OPAQUE":
        alphas = [(each.get("baseColorFactor") or [1.0] * 4)[3] for each in (base, other)]
        if alphas[0] != alphas[1] or base.get("baseColorTexture") != other.get("baseColorTexture"):
            differ.append("alpha")
    if "KHR_materials_transmission" in (base.get("extensions") or {}):
        differ.append("the colour of its transmitted light")
    return differ
