"""The motion of an asset: a motion file, or an animated glTF that its geometry is bound to."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import numpy as np

from rna_render.motion.gltf_motion import GltfMotion
from rna_sdk.console import command_line
from rna_sdk.errors import MotionError
from rna_sdk.file_kinds import kind_of
from rna_sdk.motion import Binding, bind, open_motion
from rna_sdk.package import Curves, Mesh

GLTF = (".gltf", ".glb")


class Motion(Protocol):
    """Positions of an asset's parts by frame; rna_sdk.motion.MotionFile is one."""

    @property
    def frames(self) -> int: ...

    @property
    def rate(self) -> float: ...

    def positions(self, frame: float) -> list[np.ndarray]: ...


class BoundMotion:
    """Parts that follow an animated glTF.

    Attributes:
        frames, rate: as of the glTF.
    """

    def __init__(self, source: GltfMotion, bindings: Sequence[Binding]) -> None:
        self._source, self._bindings = source, bindings
        self.frames, self.rate = source.frames, source.rate

    def positions(self, frame: float) -> list[np.ndarray]:
        """Positions of each part at a frame: (v, 3) float32. Raises MotionError if it has none."""
        if not 0 <= frame <= self.frames - 1:
            last = self.frames - 1
            raise MotionError(
                f"{self._source.path}: has frames 0 to {last}, and no frame {frame:g}"
            )
        source = self._source.positions(frame)
        return [binding.positions(source) for binding in self._bindings]


def open_asset_motion(
    path: Path,
    geometries: Sequence[Mesh | Curves],
    package: str,
    clip: str | None = None,
    rate: float = 24.0,
) -> Motion:
    """The motion in a file for the parts of a package.

    geometries: of the parts, in order. package: its name, for errors. clip, rate: of a glTF, as for
    GltfMotion.

    Raises:
        MotionError: the file is no motion, or not one of this package.
    """
    suffix = path.suffix.lower()
    if suffix in GLTF:
        return bound_gltf(GltfMotion(path, clip, rate), geometries, package)
    if kind_of(path) == "model":
        out = path.with_suffix(".rnam").name
        made = command_line("rna-motion", path, package, "--out", out)
        raise MotionError(f"{path}: is not read here; {made} writes a motion file of it")
    return open_motion(path, geometries, package)


def bound_gltf(
    source: GltfMotion, geometries: Sequence[Mesh | Curves], package: str
) -> BoundMotion:
    """A package that follows a glTF, in whose rest pose it was made.

    Raises:
        MotionError: in none of the poses that it may have been made in, it has the package's shape.
    """
    first: MotionError | None = None
    for pose in source.rest_poses():
        try:
            names = source.path.name, package
            return BoundMotion(source, bind(geometries, pose, source.triangles, names))
        except MotionError as error:
            first = first or error
    assert first is not None
    raise first
