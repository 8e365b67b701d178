"""Datasets of equal size from a distant and a near capture: NAME-far, NAME-mixed, NAME-untold.

Untold are the samples of mixed without the distance of the light.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file, save_file

_ARMS = {"far": 0.0, "mixed": 0.5, "untold": 0.0}  # name -> settings.nearLights


def _told(arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Samples with the inverse distance of their light; 0 where none was captured."""
    zeros = {
        f"{name.removesuffix('wi')}inverse_distance": np.zeros(len(rows), np.float32)
        for name, rows in arrays.items()
        if name.endswith("/wi")
    }
    return zeros | arrays


def make(far: Path, near: Path, out: Path, arm: str, shards: int) -> None:
    """The dataset of an arm, of so many shards; half of them near ones unless it is `far`."""
    for folder in ("train", "validation", "emission"):
        (out / folder).mkdir(parents=True)
    for folder in ("geometry", "transmittance", "normals"):
        (out / folder).symlink_to((far / folder).resolve())
    manifest = json.loads((far / "manifest.json").read_text())
    settings = manifest["settings"]
    settings |= {"lights": shards * settings["lightsPerShard"], "nearLights": _ARMS[arm]}
    (out / "manifest.json").write_text(json.dumps(manifest))
    split = shards if arm == "far" else shards - shards // 2
    files = [far / f"train/{k:05d}.safetensors" for k in range(split)]
    files += [near / f"train/{k:05d}.safetensors" for k in range(shards - split)]
    for k, path in enumerate(files):
        save_file(_told(load_file(path)), out / f"train/{k:05d}.safetensors")
    for path in (far / "validation").glob("*.safetensors"):
        save_file(_told(load_file(path)), out / "validation" / path.name)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("far", type=Path)
    parser.add_argument("near", type=Path)
    parser.add_argument("name")
    parser.add_argument("--shards", type=int, default=62)
    args = parser.parse_args()
    for arm in _ARMS:
        make(args.far, args.near, Path(f"{args.name}-{arm}"), arm, args.shards)


if __name__ == "__main__":
    main()
