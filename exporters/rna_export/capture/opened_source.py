"""A source that Blender has open, before its capture: its geometry, checked, and its speed."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.check.self_check import SelfCheck, picture_side
from rna_export.capture.estimate.pilot import LIGHTS, PRESET, Pilot, measure_pilot
from rna_export.capture.geometry.exported_parts import ExportedParts, exported_parts
from rna_export.capture.preflight.material_record import Glass, MaterialFacts
from rna_export.capture.preflight.sharpest import sharpest_of
from rna_export.capture.preflight.verdicts import MaterialVerdict, preflight_lines, verdicts
from rna_export.capture.preflight.visible_share import visible_shares
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import light_direction
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_check import check_seen
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_export.capture.scene_domain import scene_domain
from rna_export.training.presets import PRESETS
from rna_render.scene import SceneFile
from rna_sdk.errors import CaptureError
from rna_sdk.package import Domain

CHECK_RENDERS = 6
"""Number of renders of `OpenedSource.checked`."""


@dataclass(frozen=True)
class Speed:
    """Speed of one worker: paths a second, and processor time of a path, s."""

    rate: float
    path_seconds: float


@dataclass(frozen=True)
class OpenedSource:
    """A source that a probe has open, and how it is captured.

    worker: the probe. limited: directions that a scene uses; None for all of the settings' domain.
    materials: how well each will be learnt. preflight: what is said of that before the first ray.
    """

    worker: BlenderWorker
    settings: CaptureSettings
    exported: ExportedParts
    scene: AssetScene
    limited: Domain | None
    materials: tuple[MaterialVerdict, ...]
    preflight: tuple[str, ...]

    @classmethod
    def of(
        cls, worker: BlenderWorker, given: dict[str, Any], name: str, for_scene: SceneFile | None
    ) -> "OpenedSource":
        """Export the geometry. name: of the asset in the scene."""
        facts = [MaterialFacts(**each) for each in worker.opened["materials"]]
        sharpest, of = sharpest_of(facts)
        settings = CaptureSettings.usual(worker.kind, **{"sharpest": sharpest, **given})
        exported = exported_parts(worker, settings)
        geometries = exported.geometries
        scene = _scene(exported, settings)
        limited = None if for_scene is None else scene_domain(for_scene, name, scene)
        glass = [Glass(**each) for each in worker.opened["glass"]]
        judged = verdicts(
            facts,
            glass,
            _texel(exported),
            exported.mapped,
            exported.coloured,
            exported.obstacles,
            visible_shares(exported, scene, facts),
        )
        lines = preflight_lines(judged)
        if of is not None and "sharpest" not in given:
            lines += [f"views look for the highlights of {of!r}, of roughness {sharpest:.2g}"]
        opened = cls(worker, settings, exported, scene, limited, judged, tuple(lines))
        exported.notes += check_seen(worker.source.path, scene, geometries, opened.domain.wo)
        return opened

    @property
    def domain(self) -> Domain:
        """Directions of views and lights."""
        return self.limited or Domain(wo=self.settings.domain, wi=self.settings.domain)

    def posed(self, positions: Sequence[np.ndarray]) -> AssetScene:
        """The scene of a pose; positions: of each part's vertices or points."""
        return _scene(self.exported, self.settings, positions)

    def checked(self, scene: AssetScene, tick: Callable[[], object]) -> tuple[SelfCheck, Speed]:
        """The comparison of the shown geometry with Cycles, and the speed of Cycles.

        tick: called after each of CHECK_RENDERS renders.
        """
        check = SelfCheck(
            scene,
            self.settings.samples,
            normals=not self.exported.has_learnt_relief,
            side=picture_side(self.settings.rays),
        )
        speed = self._speed(check, tick)
        refuse_nothing(check, self.worker.source)
        check.render_card(self.worker)
        tick()
        check.render_picture(self.worker, self.worker.source.path.name)
        tick()
        return check, speed

    def _speed(self, check: SelfCheck, tick: Callable[[], object]) -> Speed:
        """The mean of three renders as the capture will do them, after one that only warms up.

        All of them are checked.
        """
        settings, domain, worker = self.settings, self.domain, self.worker
        cutouts = self.exported.has_opaque_cutouts
        seconds, spent = [], []
        for k in range(4):
            wi = light_direction(k, settings.seed, domain.wi)
            if k == 0:
                check.render_chords(worker, wi, settings.rays, domain.wo, k)
                tick()
                continue
            start, before = time.perf_counter(), worker.processor_seconds()
            rng = np.random.default_rng(k)
            rays = sample_view_rays(check.scene, wi, settings.rays, domain.wo, rng)
            traced = TracedRays.of(
                check.scene, worker, rays, wi, settings.samples, k, rng, cutouts, check.normals
            )
            seconds.append(time.perf_counter() - start)
            after = worker.processor_seconds()
            spent.append(seconds[-1] if before is None or after is None else after - before)
            check.add(traced)
            tick()
        paths = settings.rays * settings.samples
        return Speed(paths / float(np.mean(seconds)), float(np.mean(spent)) / paths)

    def pilot(self, speed: Speed, tick: Callable[[], object], lights: int = LIGHTS) -> Pilot:
        """Noise of paths, and cost of rays here; tick, lights: of `measure_pilot`."""
        cutouts, path_seconds = self.exported.has_opaque_cutouts, speed.path_seconds
        return measure_pilot(
            self.scene,
            self.worker,
            settings=self.settings,
            domain=self.domain,
            cutouts=cutouts,
            path_seconds=path_seconds,
            tick=tick,
            lights=lights,
        )


def _texel(exported: ExportedParts) -> float:
    """Side of a texel of the planes of the largest part, m."""
    boxes = [geometry.box() for geometry in exported.geometries.values()]
    sides = [float((high - low).max()) for low, high in boxes]
    return max(sides) / PRESETS["surface"][PRESET].model.resolution


def _scene(
    exported: ExportedParts, settings: CaptureSettings, positions: Sequence[np.ndarray] = ()
) -> AssetScene:
    return AssetScene(
        geometries=tuple(exported.geometries.values()),
        sharpest=settings.sharpest,
        transmittances=exported.transmittances(),
        normal_maps=exported.normal_maps(),
        positions=positions,
    )


def refuse_nothing(check: SelfCheck, source: Source) -> None:
    """Raise CaptureError if no ray would make a sample."""
    if not check.used_rays:
        why = check.note() or "Cycles met nothing at their points"
        raise CaptureError(f"{source.path}: none of {check.rays:,} view rays can be kept: {why}")
