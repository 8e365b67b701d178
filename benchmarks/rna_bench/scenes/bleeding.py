"""Colour that goes from a wall to the asset beside it and back, in numbers of both programs."""

from __future__ import annotations

from typing import Any

import numpy as np

from rna_bench.scenes.beside_cycles import CyclesScene, OurScene
from rna_bench.scenes.stage import Stage
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_render.scene import Scene

ASSET, WALL, GROUND = 1, 2, 3  # of channel assetId


def bleeding(
    stage: Stage, scene: Scene, worker: BlenderWorker, samples: int, bounces: int | None
) -> dict[str, Any]:
    """Mean colours of regions, with and without what throws colour on them.

    Region, then case, then program: linear RGB. samples: of both, a pixel; means over regions have
    little noise.
    """
    cases = {
        "both": scene,
        "without wall": scene.model_copy(update={"objects": ()}),
        "without asset": scene.model_copy(update={"assets": ()}),
    }
    images = {
        case: {
            "ours": OurScene(one).render(samples).pixels,
            "cycles": CyclesScene(worker, one, bounces).render(samples, seed=7).pixels,
        }
        for case, one in cases.items()
    }
    regions = _regions(stage, OurScene(scene).channels(1))
    seen = {
        "asset's side that faces the wall": ("both", "without wall"),
        "wall near the asset": ("both", "without asset"),
        "ground near the asset": ("both", "without wall", "without asset"),
    }
    return {
        region: {
            case: {
                program: np.round(image[regions[region]].mean(axis=0, dtype=np.float64), 5).tolist()
                for program, image in images[case].items()
            }
            for case in of_region
        }
        for region, of_region in seen.items()
    }


def _regions(stage: Stage, channels: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Masks, (h, w) bool."""
    number = channels["assetId"]
    position = np.stack([channels[f"position.{axis}"] for axis in "XYZ"], axis=-1)
    offset = position - stage.centre
    towards_wall = -(offset @ stage.wall_normal)
    nearest = np.percentile(towards_wall[number == ASSET], 80.0)
    aside = offset + towards_wall[..., None] * stage.wall_normal
    level = offset * [1.0, 0.0, 1.0]
    return {
        "asset's side that faces the wall": (number == ASSET) & (towards_wall > nearest),
        "wall near the asset": (number == WALL)
        & (np.linalg.norm(aside, axis=-1) < 0.9 * stage.radius),
        "ground near the asset": (number == GROUND)
        & (np.linalg.norm(level, axis=-1) < 1.3 * stage.radius),
    }
