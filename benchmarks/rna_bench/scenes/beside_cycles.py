"""A scene rendered by us and, with the original in the asset's place, by Cycles."""

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.asset_flip import SHOWN_AT, AssetFlip, ImageFlip, asset_flip, luminance_level
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.comparison_run import Timed
from rna_export.compare.cycles_scene import cycles_scene
from rna_export.metrics import IRRADIANCE, NoiselessPsnr, display, flip, psnr_without_noise, to_png
from rna_export.pictures import flip_colours
from rna_render import Camera, Denoiser, load_world, make_integrator, render
from rna_render.scene import Scene, SceneFile

EXPOSURE_DEFINITION = (
    "radiance times the scene's exposure, which puts the 95th percentile of the asset's luminance "
    "in Cycles' image at 0.8, clamped to [0, 1]"
)


@dataclass(frozen=True)
class Beside:
    """Two independent references, (2, h, w, 3), and the exposure that images are shown with."""

    halves: np.ndarray
    exposure: float
    asset: np.ndarray  # (h, w) bool: pixels that the asset covers, in part at least

    @classmethod
    def of(cls, halves: np.ndarray, asset: np.ndarray) -> "Beside":
        return cls(halves, SHOWN_AT / luminance_level(halves.mean(axis=0)[asset]), asset)

    @property
    def reference(self) -> np.ndarray:
        return self.halves.mean(axis=0, dtype=np.float32)

    def psnr(self, image: np.ndarray, where: np.ndarray | None = None) -> NoiselessPsnr:
        """PSNR of the displayed image over the asset or `where`, without the references' noise."""
        rows = self.asset if where is None else where
        ours = display(self._shown(image)) / IRRADIANCE  # its own noise is an error, as displayed
        return psnr_without_noise(ours[rows], *(self._shown(h)[rows] for h in self.halves))

    def flip(self, image: np.ndarray) -> AssetFlip:
        """FLIP of the asset's pixels without the noise of the references."""
        return asset_flip(
            [ImageFlip.of(self._shown(image), self._shown(self.halves), self.asset, exposure=1.0)]
        )

    def flip_map(self, image: np.ndarray) -> np.ndarray:
        """FLIP of every pixel, (h, w), with that noise."""
        return flip(self._shown(image), self._shown(self.reference))[1]

    def brightness(self, image: np.ndarray) -> np.ndarray:
        """Light over the reference's, red, green and blue, (3,), over the asset."""
        ours, theirs = (
            i[self.asset].sum(axis=0, dtype=np.float64) for i in (image, self.reference)
        )
        return ours / theirs

    def picture(self, image: np.ndarray) -> np.ndarray:
        """The image as displayed, (h, w, 3) uint8."""
        return to_png(self._shown(image))

    def flip_picture(self, image: np.ndarray) -> np.ndarray:
        """FLIP's map in its colours, (h, w, 3) uint8."""
        return flip_colours(self.flip_map(image))

    def _shown(self, image: np.ndarray) -> np.ndarray:
        """The exposed image, divided by IRRADIANCE, by which `metrics` multiplies radiance."""
        return (image * (self.exposure / IRRADIANCE)).astype(np.float32)


class OurScene:
    """A scene of ours, loaded."""

    def __init__(self, scene: Scene):
        self._scene = scene
        self._world = load_world(SceneFile(Path("scene.yaml"), scene, {}))

    def render(self, samples: int, seed: int = 0, denoiser: Denoiser | None = None) -> Timed:
        """RGB and the time of the render, which holds no reading of files.

        denoiser: of the image, guided as rna-run does; its time counts.
        """
        scene = self._scene.model_copy(update={"samples": samples, "seed": seed})
        integrator = make_integrator(scene, self._world)
        begun = time.perf_counter()
        film = render(scene, integrator)
        channels = film.channels()
        if denoiser is None:
            image = np.stack([channels[c] for c in "RGB"], axis=-1)
        else:
            image = denoiser.of_channels(channels, film.variance())
        return Timed(image, time.perf_counter() - begun)

    def channels(self, samples: int) -> dict[str, np.ndarray]:
        scene = self._scene.model_copy(update={"samples": samples})
        return render(scene, make_integrator(scene, self._world)).channels()


class CyclesScene:
    """A scene in a worker that has the original open, with the bounces of the original's file."""

    def __init__(self, worker: BlenderWorker, scene: Scene):
        self._worker, self._described = worker, cycles_scene(scene)
        self._camera = Camera(scene.camera, scene.resolution)
        self.render(1, seed=1)  # builds the scene

    def render(self, samples: int, seed: int, denoise: bool = False) -> Timed:
        """RGB, and the time of the request without any building of the scene."""
        begun = time.perf_counter()
        image, _ = self._worker.render_scene(self._described, self._camera, samples, seed, denoise)
        return Timed(image[..., :3], time.perf_counter() - begun)
