"""Meshes of Wavefront OBJ files, with the materials of their MTL files.

trimesh reads the faces. Of a material, Kd and map_Kd make a Lambertian one, Ke adds emission, and
Pr and Pm (the common extension for metals) make it one of glTF, with Ni for its coat. Phong's
highlights (Ks, Ns) have no equal there and are left out, as Ka is.
"""

import io
import re
import warnings
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.materials.files.mesh_parts import MeshFile, Part, fans
from rna_render.materials.files.obj_indices import with_plain_indices
from rna_render.materials.material import Material, reflectance_of_ior
from rna_render.materials.textures import SRGB, Texture, read_texels
from rna_render.scene.limits import MAX_NUMBER
from rna_render.scene.material_models import DiffuseModel

# Of faces without a material.
DEFAULT_MATERIAL = Material(base_color=DiffuseModel(type="diffuse").color)

# Statements of MTL that change the look and are not read.
LEFT_OUT = {"bump", "norm", "disp", "decal"}


def read_obj(path: Path, with_materials: bool) -> MeshFile:
    """The parts of an OBJ file; arguments and errors as in `read_gltf`."""
    text = with_plain_indices(path, _text(path).replace("\\\n", " "))  # lines that go on
    used = set(_names(text, "usemtl"))
    geometry = _geometry(text, used)
    left_out: set[str] = set()
    libraries = _read_libraries(path, text, left_out) if with_materials else {}
    materials, places = [DEFAULT_MATERIAL], {}
    for name in dict.fromkeys(_material_name(item) for item in geometry):
        if name in libraries:
            places[name] = len(materials)
            materials.append(_material(path, libraries[name], left_out))
        elif name in used and with_materials:  # trimesh invents names where there are none
            left_out.add(f"material {name!r}, which is in no MTL file")
    if with_materials and any(item.get("vertex_colors") is not None for item in geometry):
        left_out.add("vertex colours")
    parts = [_part(item, places.get(_material_name(item) or "", 0)) for item in geometry]
    return MeshFile(parts, materials, sorted(left_out))


def _text(path: Path) -> str:
    """Without a byte order mark and tabs, which trimesh does not know."""
    return path.read_text(encoding="utf-8-sig", errors="replace").replace("\t", " ")


def _names(text: str, statement: str) -> list[str]:
    """Arguments of all statements with this keyword."""
    return re.findall(rf"^ *{statement} +(.*?)[ \r]*$", text, re.MULTILINE)


def _geometry(text: str, used: Iterable[str]) -> list[dict[str, Any]]:
    """Geometry as read by trimesh: for each material the arguments of a mesh."""
    from trimesh.exchange.obj import load_obj

    # Without a library that has a material, trimesh forgets that the faces use it.
    library = "\n".join(f"newmtl {name}\nKd 1 1 1" for name in used)
    body = re.sub(r"^\s*mtllib\b.*$", "", text, flags=re.MULTILINE)
    with warnings.catch_warnings():
        # numpy stops at a number that it cannot read, and only warns.
        warnings.filterwarnings("error", "string or file could not be read")
        source = io.StringIO(f"mtllib names.mtl\n{body}")
        loaded = load_obj(source, resolver={"names.mtl": library})
    return list(loaded.get("geometry", {}).values())


def _material_name(item: dict[str, Any]) -> str | None:
    material = getattr(item.get("visual"), "material", None)
    return getattr(material, "name", None)


def _part(item: dict[str, Any], material: int) -> Part:
    uvs = getattr(item.get("visual"), "uv", None)
    if uvs is not None:
        # The lower left corner of the image is (0, 0) in OBJ.
        uvs = np.column_stack([uvs[:, 0], 1.0 - uvs[:, 1]])
    triangles = fans(np.asarray(item["faces"]))
    return Part(item["vertices"], item.get("vertex_normals"), uvs, triangles, material)


def _read_libraries(path: Path, text: str, left_out: set[str]) -> dict[str, dict[str, str]]:
    """The statements of each material in the MTL files that are there."""
    result: dict[str, dict[str, str]] = {}
    for name in _names(text, "mtllib"):
        library = path.parent / name
        if library.is_file():
            result |= _statements(_text(library))
        else:
            left_out.add(f"materials of {name}, which is not there")
    return result


def _statements(text: str) -> dict[str, dict[str, str]]:
    result: dict[str, dict[str, str]] = {}
    current: dict[str, str] = {}
    for line in text.splitlines():
        key, _, value = line.strip().partition(" ")
        if key.lower() == "newmtl":
            current = result.setdefault(value.strip(), {})
        elif value.strip():
            current[key.lower()] = value.strip()
    return result


def _material(path: Path, data: dict[str, str], left_out: set[str]) -> Material:
    if any(key.startswith("map_") and key != "map_kd" for key in data) or LEFT_OUT & set(data):
        left_out.add("textures other than map_Kd")
    if _number(data, "d", 1) < 1 or _number(data, "tr", 0) > 0:
        left_out.add("transparency (d, Tr)")
    texture = None
    if "map_kd" in data:
        if data["map_kd"].startswith("-"):
            left_out.add("options of map_Kd")
        name = re.sub(r"^(-\w+(\s+(on|off|[-+.\d]+))+\s+)*", "", data["map_kd"])
        image = path.parent / name.replace("\\", "/")
        texture = Texture(read_texels(image, image), SRGB)
    plain = Material(
        _colour(data, "kd", 1.0 if texture else 0.8),
        emission=_colour(data, "ke", 0.0),
        base_color_texture=texture,
    )
    if not {"pr", "pm"} & set(data):
        return plain
    return replace(
        plain,
        metallic=min(_number(data, "pm", 0), 1.0),
        roughness=min(_number(data, "pr", 1), 1.0),
        coat_f0=min(reflectance_of_ior(max(_number(data, "ni", 1.5), 1.0)), 0.999),
    )


def _colour(data: dict[str, str], key: str, default: float) -> tuple[float, float, float]:
    try:
        values = [float(value) for value in data.get(key, str(default)).split()]
    except ValueError as error:
        raise ValueError(f"{key} of a material is not a colour") from error
    red, green, blue = values if len(values) == 3 else values[:1] * 3
    limit = 1.0 if key == "kd" else np.inf
    if not all(0 <= value <= MAX_NUMBER for value in (red, green, blue)):
        raise ValueError(f"{key} of a material is outside [0, {MAX_NUMBER:g}]")
    return min(red, limit), min(green, limit), min(blue, limit)


def _number(data: dict[str, str], key: str, default: float) -> float:
    value = float(data.get(key, default))
    if not 0 <= value < np.inf:
        raise ValueError(f"{key} of a material is below 0, or not finite")
    return value
