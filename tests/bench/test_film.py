"""`rna-bench film`: what it makes of frames that are rendered."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_bench.cli import main
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
SCENE = """
assets:
  - path: {path}
    motion: walk.rnam
camera: {{position: [0, 1, 4], look_at: [0, 0.4, 0]}}
resolution: [24, 16]
samples: 4
animation: {{frames: 3}}
"""


def stored_frame(path: Path, level: float, seconds: list[float]) -> None:
    ours = np.full((16, 24, 3), level, np.float32)
    alpha = np.zeros((16, 24), bool)
    alpha[4:12] = True
    path.parent.mkdir(exist_ok=True, parents=True)
    np.savez(path, ours=ours, cycles=0.5 * ours, alpha=alpha, seconds=np.array(seconds))


def test_a_film_of_finished_frames(tmp_path: Path) -> None:
    scene, out = tmp_path / "walk.yaml", tmp_path / "film"
    scene.write_text(SCENE.format(path=TOY))
    for k in range(3):
        stored_frame(out / "frames" / f"{k:04d}.npz", 0.1 - 0.03 * k, [1.0 + k, 10.0, 2.0, 19.0])
    assert main(["film", str(scene), "--source", str(scene), "--out", str(out)]) == 0
    record = json.loads((out / "film.json").read_text())
    assert record["median"]["ours_seconds"] == 2.0 and record["median"]["cycles_seconds"] == 10.0
    assert [record["frames"][1][f"{of}_cpu_seconds"] for of in ("ours", "cycles")] == [2.0, 19.0]
    assert [row["brightness"] for row in record["frames"]] == [[2.0] * 3] * 3
    with Image.open(out / "film.webp") as film:
        assert film.n_frames == 3 and film.size == (24 + 2 + 24, 16)


def test_a_scene_without_motion_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = tmp_path / "still.yaml"
    scene.write_text(SCENE.format(path=TOY).replace("    motion: walk.rnam\n", ""))
    scene.write_text(scene.read_text().replace("{frames: 3}", "{frames: 3, turntable: {}}"))
    assert main(["film", str(scene), "--source", str(scene), "--out", str(tmp_path)]) == 1
    assert "no asset with a `motion`" in capsys.readouterr().err
