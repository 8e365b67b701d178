"""Mesh files: glTF, OBJ and PLY in, a mesh with materials out."""

import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path

from rna_render.materials.files.gltf_file import read_gltf
from rna_render.materials.files.mesh_parts import MeshFile, join_parts
from rna_render.materials.files.obj_file import read_obj
from rna_render.materials.files.ply_file import read_ply
from rna_render.materials.material import Material, make_material
from rna_render.materials.mesh_object import MeshObject
from rna_render.scene.gltf_container import reason_of
from rna_render.scene.material_models import MaterialModel, ShadowCatcherModel
from rna_sdk.errors import SceneError
from rna_sdk.files.regular_file import check_regular

_READERS: dict[str, Callable[[Path, bool], MeshFile]] = {
    ".glb": read_gltf,
    ".gltf": read_gltf,
    ".obj": read_obj,
    ".ply": read_ply,
}


class MeshFileWarning(UserWarning):
    """Something in a mesh file changes its look and is not shown."""


def read_mesh_object(
    path: Path, material: MaterialModel | None = None, fallbacks: bool = True
) -> MeshObject:
    """A .glb, .gltf, .obj or .ply file as one mesh, in the file's own space.

    Nodes of glTF are baked, without lights, cameras and animation; coordinates of OBJ and PLY
    are taken as they are, with +Y up. Parts without normals get flat ones.

    material: what the whole mesh is made of; the file's own materials if None. fallbacks: of a
    .glb with packages, whether their fallbacks are part of the mesh.

    Warns once (MeshFileWarning) with all that the file says of its look and is not shown, such
    as volumes or vertex colours. Raises SceneError, which names the file: it is not there,
    has another ending, is broken, has no triangles, positions that are not finite, or a texture
    but no texture coordinates.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        known = ", ".join(_READERS)
        raise SceneError(f"expected a file that ends with one of {known}", file=path)
    if reader is read_gltf and not fallbacks:
        reader = partial(read_gltf, fallbacks=False)
    override = None if material is None else [make_material(material)]
    file, mesh = _read(reader, path, override, isinstance(material, ShadowCatcherModel))
    if file.left_out:
        message = f"{path}: not shown: {', '.join(file.left_out)}"
        warnings.warn(message, MeshFileWarning, stacklevel=2)
    return mesh


def _read(
    reader: Callable[[Path, bool], MeshFile],
    path: Path,
    materials: list[Material] | None,
    catches_shadows: bool,
) -> tuple[MeshFile, MeshObject]:
    try:
        check_regular(path)
        file = reader(path, materials is None)
        used = file.materials if materials is None else materials
        return file, join_parts(path, file.parts, used, catches_shadows)
    except SceneError:
        raise
    except FileNotFoundError as error:
        raise SceneError("no such file", file=path) from error
    except OSError as error:
        raise SceneError(error.strerror or str(error), file=path) from error
    except Exception as error:  # whatever a broken file makes trimesh or json raise
        kind = path.suffix.lower()
        raise SceneError(f"it cannot be read as {kind}: {reason_of(error)}", file=path) from error
