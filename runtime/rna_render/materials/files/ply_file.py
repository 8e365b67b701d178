"""Meshes of PLY files, by trimesh; they have no materials but may name an image."""

import re
from pathlib import Path

import numpy as np

from rna_render.materials.files.mesh_parts import MeshFile, Part, fans
from rna_render.materials.material import Material
from rna_render.materials.textures import SRGB, Texture, read_texels
from rna_render.scene.material_models import DiffuseModel


def read_ply(path: Path, with_materials: bool) -> MeshFile:
    """The one part of a PLY file; arguments and errors as in `read_gltf`.

    Its material is Lambertian, of the image that its header names (`comment TextureFile`), else
    grey.
    """
    from trimesh.exchange.ply import load_ply

    with path.open("rb") as file:
        loaded = load_ply(file, skip_materials=True)
    if loaded.get("faces") is None:
        return MeshFile([], [Material()])
    uvs = getattr(loaded.get("visual"), "uv", None)
    if uvs is not None:
        # As in OBJ, the lower left corner of the image is (0, 0).
        uvs = np.column_stack([uvs[:, 0], 1.0 - uvs[:, 1]])
    triangles = fans(np.asarray(loaded["faces"], np.int64))
    part = Part(loaded["vertices"], loaded.get("vertex_normals"), uvs, triangles, 0)
    if not with_materials:
        return MeshFile([part], [Material()])
    coloured = any(loaded.get(key) is not None for key in ("vertex_colors", "face_colors"))
    return MeshFile([part], [_material(path)], ["vertex colours"] if coloured else [])


def _material(path: Path) -> Material:
    with path.open("rb") as file:
        header = file.read(65536).partition(b"end_header")[0].decode("utf-8", "replace")
    named = re.search(r"^comment\s+TextureFile\s+(.*?)\s*$", header, re.MULTILINE)
    if named is None:
        return Material(base_color=DiffuseModel(type="diffuse").color)
    image = path.parent / named[1]
    return Material(base_color_texture=Texture(read_texels(image, image), SRGB))
