"""The geometry of a part, whatever its kind: its arrays from and to the bytes of its entry."""

from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.curves_file import curves_from_bytes, curves_to_bytes
from rna_sdk.package.geometry.glb_reader import mesh_from_glb
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.quantised_curves import quantise_curves
from rna_sdk.package.geometry.quantised_mesh import quantise_mesh
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest.manifest_fields import Kind

Geometry = Mesh | Curves

CLASSES: dict[Kind, type[Geometry]] = {"surface": Mesh, "fiber": Curves}


def geometry_from_bytes(data: memoryview, name: str, kind: Kind) -> Geometry:
    """The geometry in the entry `data`, checked; its arrays are read-only.

    Args:
        data: the bytes of the entry.
        name: the entry's name, for issues.
        kind: the part's.

    Raises:
        PackageError: with the first GEOMETRY_* or JSON_* issue found.
    """
    return mesh_from_glb(data, name) if kind == "surface" else curves_from_bytes(data, name)


def geometry_to_bytes(geometry: Geometry, kind: Kind, where: str) -> bytes:
    """The entry's bytes. The same arrays give the same bytes; values are not looked at.

    where: JSON pointer of the geometry's name in the manifest.

    Raises:
        PackageError: GEOMETRY_CONTAINER, where the kind asks for the other class.
    """
    if not isinstance(geometry, CLASSES[kind]):
        found, expected = type(geometry).__name__, CLASSES[kind].__name__
        refuse(Code.GEOMETRY_CONTAINER, where, found, f"{expected} for a {kind} part")
    return mesh_to_glb(geometry) if isinstance(geometry, Mesh) else curves_to_bytes(geometry)


def quantise(geometry: Geometry) -> Geometry:
    """The geometry as restored from a quantised file of a third to half the size; for exporters.

    Quantise before capture, so that training sees the stored geometry. Meshes have 16 bits per
    axis, strands steps below a fiftieth of their smallest radius.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     mesh = package.mesh()
        >>> off = np.abs(quantise(mesh).positions - mesh.positions)
        >>> bool(off.max() < 1e-4)  # metres
        True
    """
    if isinstance(geometry, Mesh):
        return quantise_mesh(geometry)
    return quantise_curves(geometry)
