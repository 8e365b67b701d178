"""The files that an image becomes: an EXR or NPZ, and perhaps a PNG beside it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from rna_render.image.denoise import Denoiser
from rna_render.image.film import Film
from rna_render.image.images import read_attributes, write_linear, write_png
from rna_render.scene.scene_model import Scene
from rna_sdk.errors import SceneError
from rna_sdk.files.outputs import check_outputs


@dataclass(frozen=True)
class Output:
    """Paths of the images, and the denoiser that is applied first.

    linear: the .exr or .npz file, or for a sequence a name with one `%d` or `%04d`. png: likewise.
    One of them may be None. denoiser: None to keep the noise. contents: of the files that the
    scene reads, by `contents_key`, for images that a later command may keep; None for others.
    """

    linear: Path | None
    png: Path | None = None
    denoiser: Denoiser | None = None
    contents: str | None = None

    def frame(self, number: int) -> Output:
        """The files of one frame of a sequence."""
        return self._with_paths(lambda path: path.with_name(path.name % number))

    def absolute(self) -> Output:
        """These files, for a process with another working directory."""
        return self._with_paths(Path.absolute)

    def _with_paths(self, of: Callable[[Path], Path]) -> Output:
        linear, png = (None if path is None else of(path) for path in (self.linear, self.png))
        return replace(self, linear=linear, png=png)

    def paths(self) -> list[Path]:
        """The files."""
        return [path for path in (self.linear, self.png) if path is not None]

    def check(self, inputs: Iterable[Path]) -> None:
        """Raise RnaError, before rendering, for a file that is an input or cannot be written."""
        check_outputs(self.paths(), inputs)

    def is_there(self, scene: Scene) -> bool:
        """Whether all files were made from this very scene and these `contents`."""
        return self.contents is not None and all(
            path.is_file() and self._is_of(scene, read_attributes(path)) for path in self.paths()
        )

    def write(self, scene: Scene, film: Film) -> None:
        """Write the files.

        Raises SceneError if one cannot be written, or if a pixel is not finite: a scene's numbers
        all are.
        """
        self._check_finite(film)
        channels = film.channels()
        channels["Z"] = _depth(scene, channels)
        rgb = np.stack([channels[name] for name in "RGB"], axis=-1)
        if self.denoiser is not None:
            rgb = self.denoiser.of_channels(channels, film.variance())
            channels |= _layer("denoised", rgb)
        attributes = self._attributes(scene, film.samples)
        if self.linear is not None:
            write_linear(self.linear, channels, attributes)
        if self.png is not None:
            write_png(self.png, rgb, scene.exposure, scene.view, attributes, channels["A"])

    def write_so_far(self, scene: Scene, film: Film) -> None:
        """Write the files of a film that is not finished; with the noise."""
        replace(self, denoiser=None).write(scene, film)

    def _check_finite(self, film: Film) -> None:
        bad = film.not_finite()
        if len(bad):
            y, x = divmod(int(bad[0]), film.width)
            raise SceneError(
                f"not written: {len(bad):,} of {film.width * film.height:,} pixels are not finite "
                f"numbers, the first at column {x}, row {y}; this is a fault of the renderer, "
                "please report it with the scene",
                file=self.paths()[0],
            )

    def _is_of(self, scene: Scene, attributes: dict[str, str]) -> bool:
        """Whether attributes match the finished image; a time limit may end it early."""
        limited = scene.quality is not None and scene.quality.seconds is not None
        samples = attributes.get("rnaSamples") if limited else scene.samples
        return attributes == self._attributes(scene, samples)

    def _attributes(self, scene: Scene, samples: object) -> dict[str, str]:
        attributes = {"rnaScene": scene.model_dump_json(), "rnaSamples": str(samples)}
        if self.denoiser is not None:
            attributes["rnaDenoised"] = self.denoiser.name
        if self.contents is not None:
            attributes["rnaContents"] = self.contents
        return attributes


NOTHING = np.float32(1e10)
"""Depth where no sample hit an object, as Cycles has it."""


def _depth(scene: Scene, channels: dict[str, np.ndarray]) -> np.ndarray:
    """Distance of the hit points along the camera's axis, (height, width) float32, metres."""
    forward = np.subtract(scene.camera.look_at, scene.camera.position)
    position = np.stack([channels[f"position.{c}"] for c in "XYZ"], axis=-1).astype(np.float64)
    depth = (position - scene.camera.position) @ (forward / np.linalg.norm(forward))
    return np.where(channels["assetId"] > 0, depth, NOTHING).astype(np.float32)


def _layer(name: str, rgb: np.ndarray) -> dict[str, np.ndarray]:
    """An image as channels of a layer, by OpenEXR's convention."""
    return {f"{name}.{c}": np.ascontiguousarray(rgb[..., i]) for i, c in enumerate("RGB")}
