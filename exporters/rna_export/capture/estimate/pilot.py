"""A pilot: small renders that tell the noise of a path of Cycles, and the cost of rays here."""

import time
from collections.abc import Callable
from itertools import pairwise

import numpy as np
from pydantic import BaseModel, Field

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import frame, light_direction
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import ViewRays, hitting_rays
from rna_export.training.presets import PRESETS
from rna_sdk.machine.kernel_threads import kernel_threads, limit_kernel_threads
from rna_sdk.package import Domain
from rna_sdk.package.blocks import query_width
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder, ProfileLayer
from rna_sdk.runtime.engine.compiled_decoder import CompiledDecoder
from rna_sdk.runtime.engine.costs import median_seconds

PRESET = "small"

_ROWS = 4096
_OUTPUTS = 6  # visible and shadowed colours


def query_seconds(kind: str) -> float:
    """Seconds of one thread for a query's float32 decoder of PRESET, with random weights.

    kind: "surface" or "fiber".
    """
    model, rng = PRESETS[kind][PRESET].model, np.random.default_rng(0)
    columns = query_width(model.inputs, model.channels)
    widths = [columns, *[model.width] * model.hidden_layers, _OUTPUTS]
    layers = [
        ProfileLayer(
            rng.normal(size=sizes).astype(np.float32) / np.float32(np.sqrt(sizes[0])),
            np.zeros(sizes[1], np.float32),
            step=0.0,
            scale=None,
            relu=number < model.hidden_layers,
        )
        for number, sizes in enumerate(pairwise(widths))
    ]
    decoder = CompiledDecoder(ProfileDecoder(-1.0, 1.0, None, None, tuple(layers), 8.0, 1.0, None))
    queries = rng.uniform(-1.0, 1.0, (_ROWS, columns)).astype(np.float32)
    return median_seconds(lambda: decoder.run(queries), time.thread_time) / _ROWS


LIGHTS = 8
"""Renders of a pilot, three times: the noise ratio then repeats within about 15%."""

_RAYS = 1024  # of a render
_PIXELS = 100  # along the asset's diameter
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722], np.float32)  # Rec. 709
_SHOWN, _QUANTILE = 0.8, 0.95
"""Exposure: the luminance that the quantile gets, as in `rna-bench scenes`."""


class Pilot(BaseModel, extra="forbid", frozen=True):
    """Measurements of a source on one thread."""

    path_us: float = Field(gt=0, description="processor time of a path in Cycles, us")
    path_variance: float = Field(ge=0, description="of the luminance of a path along a fixed ray")
    pixel_variance: float = Field(ge=0, description="of the luminance within a pixel, noise-free")
    ray_us: float = Field(gt=0, description="processor time of a shadow ray in Embree, us")
    query_us: float = Field(gt=0, description="processor time of a query of `small`, us")

    @property
    def noise_ratio(self) -> float:
        """Variance of a path through a pixel, over the variance that remains if T is known."""
        return 1.0 + self.path_variance / max(self.pixel_variance, 1e-9)


def measure_pilot(
    scene: AssetScene,
    worker: BlenderWorker,
    settings: CaptureSettings,
    domain: Domain,
    cutouts: bool,
    path_seconds: float,
    tick: Callable[[], object],
    lights: int = LIGHTS,
) -> Pilot:
    """Render rays under several suns, twice and once more from within their pixels.

    cutouts: whether rays are kept where Cycles' alpha is below 1. path_seconds: processor time of a
    path, as the capture traces them. tick: called after each light. lights: suns, each with other
    rays.
    """
    samples, layers = settings.samples, np.random.default_rng
    count = min(_RAYS, settings.rays)
    rng, answers = np.random.default_rng(settings.seed), []
    for k in range(lights):
        wi = light_direction(k, settings.seed, domain.wi)
        rays = hitting_rays(scene, count, domain.wo, rng)
        near = _moved(rays, 2.0 * scene.radius / _PIXELS, rng)
        answers.append(
            [
                # The same layers of what lets light through are met in each turn.
                _luminance(
                    TracedRays.of(scene, worker, one, wi, samples, 3 * k + turn, layers(k), cutouts)
                )
                for turn, one in enumerate([rays, rays, near])
            ]
        )
        tick()
    path, pixel = variances(np.concatenate(answers, axis=1), samples)
    kind = "fiber" if worker.kind == "fiber" else "surface"
    return Pilot(
        path_us=1e6 * path_seconds,
        path_variance=path,
        pixel_variance=pixel,
        ray_us=1e6 * _ray_seconds(scene, rays, wi),
        query_us=1e6 * query_seconds(kind),
    )


def pilot_paths(settings: CaptureSettings) -> int:
    """Paths that a pilot of the usual lights traces at most."""
    return 3 * LIGHTS * min(_RAYS, settings.rays) * settings.samples


def variances(luminance: np.ndarray, samples: int) -> tuple[float, float]:
    """Variances of a path along a fixed ray, and of rays within a pixel.

    luminance: (3, n) float32, means of `samples` paths: along rays, along them once more with other
    random numbers, and along others through the same pixels. Exposed and clamped to [0, 1], as the
    error in scenes is measured: highlights that a screen does not show do not count.
    """
    white = float(np.quantile(luminance[:2], _QUANTILE)) or 1.0
    first, again, near = np.clip(luminance.astype(np.float64) * (_SHOWN / white), 0.0, 1.0)
    noise = np.mean((first - again) ** 2) / 2.0
    apart = np.mean((first - near) ** 2 + (again - near) ** 2) / 4.0
    return samples * float(noise), max(float(apart - noise), 0.0)


def _luminance(traced: TracedRays) -> np.ndarray:
    """(n,) float32, the values of points in a pixel; black where there is no sample."""
    return np.where(traced.valid, traced.rendered.radiance @ _LUMINANCE, np.float32(0.0))


def _moved(rays: ViewRays, width: float, rng: np.random.Generator) -> ViewRays:
    """The rays, moved sideways within pixels of a width, whose middles they are in."""
    s, t = frame(rays.directions)
    x, y = width * (rng.random((2, len(rays), 1)) - 0.5)
    return ViewRays((rays.origins + x * s + y * t).astype(np.float32), rays.directions)


def _ray_seconds(scene: AssetScene, rays: ViewRays, wi: np.ndarray) -> float:
    """Processor time of a shadow ray from where the rays hit, on one thread."""
    points = scene.shade_points(rays.origins, rays.directions)
    towards = np.ascontiguousarray(np.broadcast_to(wi.astype(np.float32), points.position.shape))
    threads = kernel_threads()
    limit_kernel_threads(1)
    try:
        return median_seconds(lambda: scene.visible(points, towards), time.thread_time) / len(rays)
    finally:
        limit_kernel_threads(threads)
