"""Images of a moving source by Cycles, and where its package's vertices are in the same frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from rna_bench.one_part import OnePart
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.followed_source import FollowedSource
from rna_render import Camera
from rna_render.scene import CameraModel
from rna_trace import part_geometry

VIEWS, SIDE, FOV_DEG = 8, 96, 30.0  # images of a frame, their width in pixels
HALF = 16  # paths a pixel, of each half


@dataclass(frozen=True)
class Views:
    """Cameras around an asset, each with a sun; the same ones in all frames.

    wi: (k, 3) float32, towards the suns.
    """

    cameras: tuple[Camera, ...]
    wi: np.ndarray

    @classmethod
    def around(cls, positions: Sequence[np.ndarray], seed: int = 3) -> Views:
        """Views of the sphere around all positions, (v, 3) each."""
        points = np.concatenate(positions)
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        distance = np.linalg.norm(points - centre, axis=1).max() / np.sin(np.radians(FOV_DEG) / 2)
        rng = np.random.default_rng(seed)
        towards = _spread(VIEWS, rng)
        aside = rng.normal(size=(VIEWS, 3))
        light = towards + 1.2 * aside / np.linalg.norm(aside, axis=1, keepdims=True)
        models = (
            CameraModel(
                position=tuple((centre + distance * w).tolist()),
                look_at=tuple(centre.astype(float).tolist()),
                vertical_fov_deg=FOV_DEG,
            )
            for w in towards
        )
        cameras = tuple(Camera(model, (SIDE, SIDE)) for model in models)
        light /= np.linalg.norm(light, axis=1, keepdims=True)
        return cls(cameras, light.astype(np.float32))

    @property
    def pixels(self) -> int:
        """Of one view."""
        return SIDE * SIDE

    def rays(self, view: int) -> tuple[np.ndarray, np.ndarray]:
        """Origins and directions through the pixels' middles, (n, 3) float32 each."""
        camera, n = self.cameras[view], self.pixels
        d = camera.directions(np.arange(n, dtype=np.uint32), np.full((n, 2), 0.5))
        origins = np.tile(np.asarray(camera.position, np.float32), (n, 1))
        return origins, np.ascontiguousarray(d, np.float32)


def _spread(count: int, rng: np.random.Generator) -> np.ndarray:
    """Directions spread over the sphere, turned by chance: (count, 3)."""
    k = np.arange(count) + 0.5
    y = 1.0 - 2.0 * k / count
    turn = k * np.pi * (3.0 - np.sqrt(5.0)) + rng.uniform(0.0, 2.0 * np.pi)
    r = np.sqrt(1.0 - y**2)
    return np.stack([r * np.cos(turn), y, r * np.sin(turn)], axis=1)


def references(
    fixtures: Fixtures, name: str, path: Path, package: OnePart, frames: Sequence[int]
) -> dict[str, np.ndarray]:
    """By frame: `F-positions` (v, 3), `F-halves` (2, n, 3) and `F-alpha` (n,), n over all views."""
    source = Source(path)
    moved = fixtures.kept(f"motion-{name}", lambda: _positions(fixtures, source, package, frames))
    views = Views.around([moved[f"{frame}-positions"] for frame in frames])

    def of_frame(frame: int) -> dict[str, np.ndarray]:
        with fixtures.cycles(source) as worker:
            return frame_images(worker, views, frame, fixtures.some(HALF))

    found = dict(moved)
    for frame in frames:
        kept = fixtures.kept(f"motion-{name}-{frame}", partial(of_frame, frame))
        found |= {f"{frame}-{key}": value for key, value in kept.items()}
    return found


def _positions(
    fixtures: Fixtures, source: Source, package: OnePart, frames: Sequence[int]
) -> dict[str, np.ndarray]:
    """As rna-motion would write them."""
    with fixtures.cycles(source) as worker:
        follows = FollowedSource(worker, [part_geometry(package)], f"{source.path.stem}.rna")
        found = [follows.positions(frame)[0] for frame in frames]
    return {f"{frame}-positions": p for frame, p in zip(frames, found, strict=True)}


def frame_images(
    worker: BlenderWorker, views: Views, frame: int, half: int
) -> dict[str, np.ndarray]:
    """Halves (2, n, 3) and alpha (n,) float32 of the views in a frame, of so many paths a pixel."""
    worker.show_frame(frame)
    halves: list[list[np.ndarray]] = [[], []]
    alpha = []
    for k, (camera, wi) in enumerate(zip(views.cameras, views.wi, strict=True)):
        for which, into in enumerate(halves):
            at = camera.to_world, np.radians(FOV_DEG), wi, half, 2 * k + which, SIDE, SIDE
            rendered = worker.render_pixel_centres(*at)
            into.append(rendered.radiance)
        alpha.append(rendered.alpha)
    both = np.stack([np.concatenate(one) for one in halves])
    return {"halves": both.astype(np.float32), "alpha": np.concatenate(alpha)}
