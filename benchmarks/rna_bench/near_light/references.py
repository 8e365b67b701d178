"""Cycles' images of an asset under lamps at several distances, in two halves."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from rna_bench.cycles_worker import cycles
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_tasks import _of_light
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import sphere
from rna_export.capture.rays.captured_light import Lamp, _is_outside, lamp_at
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import ViewRays
from rna_render import Camera
from rna_render.scene import CameraModel

DISTANCES = (0.3, 0.5, 1.0, 2.0, 10.0)  # from the asset's middle, in its sizes
_FOV = np.radians(36.0)


def views(scene: AssetScene, side: int) -> Iterator[tuple[str, ViewRays, np.ndarray, float, Lamp]]:
    """Names, rays that hit, their pixels, and the light: two cameras, two lamps at each distance.

    A lamp that would be inside the asset or next to it stands in another direction.
    """
    for camera, turn in enumerate(np.radians([25.0, 205.0])):
        axis = np.array([np.sin(turn), 0.35, np.cos(turn)])
        axis /= np.linalg.norm(axis)
        rays, pixel = _rays(scene, axis, side)
        front = np.array([axis[0], 0.0, axis[2]]) / np.hypot(axis[0], axis[2])
        right, up = np.cross([0.0, 1.0, 0.0], front), np.array([0.0, 1.0, 0.0])
        for light, way in enumerate((front + right + up, up - 1.2 * right + 0.2 * front)):
            towards = (way / np.linalg.norm(way)).astype(np.float32)
            for distance in DISTANCES:
                others = sphere(np.random.default_rng([camera, light]).random((200, 2)))
                ways = [towards, *others[(others @ towards > 0.3) & (others @ axis > 0.0)]]
                lamps = (lamp_at(scene, w, distance) for w in ways)
                free = (x for x in lamps if _is_outside(scene, x, np.random.default_rng(0)))
                if (lamp := next(free, None)) is not None:
                    yield f"{camera}-{light}-{distance:g}", rays, pixel, distance, lamp


def _rays(scene: AssetScene, axis: np.ndarray, side: int) -> tuple[ViewRays, np.ndarray]:
    model = CameraModel(
        position=tuple(scene.centre + axis * (0.93 * scene.radius / np.sin(_FOV / 2.0))),
        look_at=tuple(scene.centre.astype(np.float64)),
        vertical_fov_deg=float(np.degrees(_FOV)),
    )
    camera = Camera(model, (side, side))
    pixels = np.arange(side**2, dtype=np.uint32)
    directions = camera.directions(pixels, np.full((side**2, 2), 0.5))
    rays = ViewRays(np.tile(camera.position, (side**2, 1)).astype(np.float32), directions)
    hit = np.flatnonzero(scene.part_hit(rays.origins, rays.directions) >= 0)
    return rays[hit], hit


def rendered(
    scene: AssetScene, worker: BlenderWorker, rays: ViewRays, lamp: Lamp, samples: int
) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Samples of the rays that hit the asset's one part, with `halves` (2, n, 3); their rays."""
    rng = np.random.default_rng
    halves = [TracedRays.of(scene, worker, rays, lamp, samples, k, rng(0), False) for k in (11, 12)]
    on = halves[0].points.on[0]
    kept = (halves[0].kept & halves[1].kept)[on.rows]
    rows = on.rows[kept]
    fields = {name: values[kept] for name, values in on.fields.items()}
    light = _of_light(scene, halves[0].points, lamp)
    fields |= {"wo": -rays.directions[rows], **{name: v[rows] for name, v in light.items()}}
    return {**fields, "halves": np.stack([half.radiance[rows] for half in halves])}, rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("source", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--side", type=int, default=112)
    parser.add_argument("--samples", type=int, default=128, help="of a half")
    args = parser.parse_args()
    scene = scene_of(Dataset(args.dataset))
    found: dict[str, np.ndarray] = {}
    with cycles(args.source) as worker:
        for name, rays, pixel, distance, lamp in views(scene, args.side):
            samples, rows = rendered(scene, worker, rays, lamp, args.samples)
            irradiance = (samples["inverse_distance"] * distance) ** 2  # 1 at the middle
            samples |= {"pixel": pixel[rows], "irradiance": irradiance}
            found |= {f"{name}/{field}": values for field, values in samples.items()}
    np.savez(args.out, side=args.side, **found)  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
