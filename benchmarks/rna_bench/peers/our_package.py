"""Our package on the cameras and lights of views."""

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.peers.study import Plan
from rna_bench.peers.views import PeerCamera, Views
from rna_bench.scenes.beside_cycles import OurScene
from rna_render.scene import Scene
from rna_sdk.package import Package, decoder_from_bytes


def measured(packages: Sequence[Path], plan: Plan, samples: int) -> list[dict[str, Any]]:
    """A row for each tier of each package, with its `images` by split.

    Several packages are distinguished by the names of their files.
    """
    rows = []
    for package, tier in ((path, name) for path in packages for name in tiers_of(path)):
        images, scores, seconds = {}, {}, []
        for split, held in plan.held_out.items():
            result = render_package(package, tier, held.views, held.cameras(), samples)
            images[split] = result[0]
            seconds.append(result[1])
            scores[split] = held.score(images[split]).as_json()
        which = f"{package.stem}, {tier}" if len(packages) > 1 else tier
        rows.append(
            {
                "title": f"ours, {which}",
                "parameters": parameters_of(package, tier),
                "samples": samples,
                "frame_cpu_seconds": round(float(np.mean(seconds)), 3),
                "scores": scores,
                "images": images,
            }
        )
    return rows


def tiers_of(package: Path) -> list[str]:
    """Names of a package's tiers."""
    with Package.open(package) as opened:
        return [tier.name for tier in opened.manifest.tiers]


def render_package(
    package: Path,
    tier: str,
    views: Views,
    cameras: Sequence[tuple[PeerCamera, np.ndarray]],
    samples: int,
) -> tuple[list[np.ndarray], float]:
    """Images (h, w, 3) float32, radiance over black, and the mean CPU seconds of one.

    views: for the sphere that the cameras' space is of, and the intensity of the lights.
    """
    images, begun = [], time.process_time()
    for camera, light in cameras:
        scene = _scene(package, tier, views, camera, light, samples)
        images.append(OurScene(scene).render(samples).pixels.astype(np.float32))
    return images, (time.process_time() - begun) / len(images)


def _scene(
    package: Path, tier: str, views: Views, camera: PeerCamera, light: np.ndarray, samples: int
) -> Scene:
    def placed(point: np.ndarray) -> tuple[float, float, float]:
        x, y, z = np.asarray(views.centre) + views.radius * point
        return float(x), float(y), float(z)

    matrix = camera.to_world
    eye, up = matrix[:3, 3], matrix[:3, 1]
    intensity = views.shown_intensity * views.radius**2
    lamp = {"type": "point", "position": placed(light), "intensity": (intensity,) * 3}
    viewed = {
        "position": placed(eye),
        "look_at": placed(eye - matrix[:3, 2]),
        "up": tuple(up.tolist()),
        "vertical_fov_deg": float(np.degrees(camera.fov_y)),
    }
    settings: dict[str, Any] = {"resolution": camera.size, "clamp_indirect": None}
    assets = [{"path": package.resolve(), "tier": tier}]
    return Scene(assets=assets, camera=viewed, lights=[lamp], samples=samples, **settings)


def parameters_of(package: Path, tier: str) -> int:
    """Numbers that a tier's transport is made of: texels of planes, weights and biases."""
    total = 0
    with Package.open(package) as opened:
        for k, part in enumerate(opened.tier(tier).parts):
            layers = decoder_from_bytes(opened.decoder(tier, k), part.decoder).layers
            total += 3 * part.resolution**2 * part.channels
            total += sum(layer.weight.size + layer.bias.size for layer in layers)
    return total
