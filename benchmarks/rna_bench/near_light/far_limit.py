"""What a perfect model of distant light would answer under lamps, at some pixels of references.

Cycles under a sun for each pixel, in the lamp's direction from its point.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from rna_bench.cycles_worker import cycles
from rna_bench.near_light.scores import images_of
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.dataset.dataset_folder import Dataset

_RAYS, _SAMPLES = 64, 16  # of a pixel; half of the rays for each half


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("source", type=Path)
    parser.add_argument("references", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--distances", type=float, nargs="+", default=[0.3, 0.5, 1.0])
    parser.add_argument("--pixels", type=int, default=100)
    args = parser.parse_args()
    size = scene_of(Dataset(args.dataset)).size
    found: dict[str, np.ndarray] = {}
    with cycles(args.source) as worker:
        for name, image in images_of(args.references):
            if float(name.split("-")[-1]) not in args.distances:
                continue
            rows = np.random.default_rng(5).permutation(len(image["wi"]))[: args.pixels]
            halves = [_under_a_sun(worker, image, row, size) for row in rows]
            found |= {f"{name}/rows": rows, f"{name}/halves": np.stack(halves, axis=1)}
    np.savez(args.out, **found)  # type: ignore[arg-type]


def _under_a_sun(
    worker: BlenderWorker, image: dict[str, np.ndarray], row: int, size: float
) -> np.ndarray:
    """Radiance of a pixel in two halves, (2, 3)."""
    x, wo = image["position"][row], image["wo"][row]
    origins = np.tile(x + np.float32(1e-3 * size) * wo, (_RAYS, 1)).astype(np.float32)
    along = np.tile(-wo, (_RAYS, 1)).astype(np.float32)
    answer = worker.render_rays(origins, along, image["wi"][row], _SAMPLES, int(row)).radiance
    return answer.reshape(2, _RAYS // 2, 3).mean(axis=1)


if __name__ == "__main__":
    main()
