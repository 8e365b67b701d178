"""The motion of an asset: a motion file, or an animated glTF that its geometry is bound to."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_render.motion.gltf_motion import GltfMotion
from rna_sdk.commands.console import command_line
from rna_sdk.errors import MotionError
from rna_sdk.files.file_kinds import is_gltf, kind_of
from rna_sdk.motion import Binding, Motion, bind, open_motion
from rna_sdk.package import Curves, Mesh


class BoundMotion(Motion):
    """Parts that follow an animated glTF."""

    def __init__(self, source: GltfMotion, bindings: Sequence[Binding]) -> None:
        super().__init__(source.path, source.frames, source.rate)
        self._source, self._bindings = source, bindings

    def positions(self, frame: float) -> list[np.ndarray]:
        """See `Motion`."""
        self.check_frame(frame)
        source = self._source.positions(frame)
        return [binding.positions(source) for binding in self._bindings]


def open_asset_motion(
    path: Path,
    geometries: Sequence[Mesh | Curves],
    package: str,
    clip: str | None = None,
    rate: float = 24.0,
    rest_frame: int | None = None,
    made_from: Path | None = None,
) -> Motion:
    """The motion in a file for the parts of a package.

    geometries: of the parts, in order. package: its name, for errors. clip, rate: of a glTF, as for
    GltfMotion. rest_frame: of the package's provenance, for a glTF that is bent at rest. made_from:
    the glTF that the package was made from, of whose clip it has the shape; None for `path`.

    Raises:
        MotionError: the file is no motion, or not one of this package: in none of the poses that
            it may have been made in, a glTF has its shape.
    """
    if is_gltf(path):
        source, first = GltfMotion(path, clip, rate), None
        made = source if made_from is None else GltfMotion(made_from)
        if not np.array_equal(made.triangles, source.triangles):
            raise MotionError(f"{made.path} and {source.path} are not of the same triangles")
        for pose in made.rest_poses(rest_frame):
            try:
                names = source.path.name, package
                return BoundMotion(source, bind(geometries, pose, source.triangles, names))
            except MotionError as error:
                first = first or error
        assert first is not None
        raise first
    if kind_of(path) == "model":
        out = path.with_suffix(".rnam").name
        command = command_line("rna-motion", path, package, "--out", out)
        raise MotionError(f"{path}: is not read here; {command} writes a motion file of it")
    return open_motion(path, geometries, package)
