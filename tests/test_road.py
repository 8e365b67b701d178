"""The whole road by its commands, from a scene to a relit image that is like Cycles'.

They run in this process: a new one imports for seconds.
"""

import json
from dataclasses import dataclass
from functools import partial
from importlib.metadata import entry_points
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.metrics import psnr
from rna_render import Camera
from rna_render.scene import read_scene
from tests.exporters.scenes import fur, write_scene

pytestmark = pytest.mark.blender

SURFACE = """
glossy = principled(Base_Color=(0.7, 0.2, 0.1, 1), Roughness=0.4)
add(*BALL, glossy, smooth=True, matrix=Matrix.Translation((0, 0, 0.3)))
add(*square(1.5, z=-1), diffuse((0.3, 0.5, 0.7)))
"""
FIBERS = fur(700, bend=0.25, root=0.04, tip=0.02, melanin=0.4)
CAPTURE = (
    "--workers 1 --validation-views 2 --validation-resolution 48 --validation-samples 32"
).split()


@dataclass(frozen=True)
class Asset:
    """What walks the road, and how good it must be at the end."""

    scene: str
    capture: str
    steps: int
    psnr: float
    correlation: float
    pictures: int


ASSETS = {
    "surface": Asset(
        SURFACE, "--lights 160 --rays 512 --samples 4 --domain hemisphere", 400, 29.0, 0.97, 12
    ),
    "fiber": Asset(FIBERS, "--lights 120 --rays 2048", 1500, 25.5, 0.78, 16),
}
WI = np.array([0.5, 0.8, 0.35])
EYE = np.array([1.0, 2.5, 4.5])
FOV_Y_DEG, SIZE = 40.0, 64
YAML = f"""
assets:
  - path: thing.rna
camera: {{position: {EYE.tolist()}, look_at: [0, 0, 0], vertical_fov_deg: {FOV_Y_DEG}}}
lights:
  - {{type: directional, direction: {WI.tolist()}, irradiance: [1, 1, 1]}}
resolution: [{SIZE}, {SIZE}]
samples: 16
"""


def run_command(capsys: pytest.CaptureFixture[str], name: str, *arguments: object) -> str:
    """Run one of the project's commands as installed; returns what it printed."""
    (script,) = entry_points(group="console_scripts", name=name)
    assert script.load()([*map(str, arguments)]) == 0, f"{name} failed"
    return capsys.readouterr().out


def read_rgba(path: Path) -> np.ndarray:
    with OpenEXR.File(str(path), separate_channels=True) as file:
        return np.stack([file.channels()[c].pixels for c in "RGBA"], axis=-1).astype(np.float32)


@pytest.mark.parametrize("kind", ASSETS)
def test_from_a_scene_to_a_relit_image(kind, tmp_path, blender_python, capsys):
    asset, command = ASSETS[kind], partial(run_command, capsys)
    source = write_scene(tmp_path, "thing", asset.scene)
    rays, run, package = tmp_path / "thing.rays", tmp_path / "run", tmp_path / "thing.rna"
    assert "next: rna-train" in command(
        "rna-capture", source, "--out", rays, *asset.capture.split(), *CAPTURE
    )
    said = command("rna-train", rays, "--preset", "small", "--steps", asset.steps, "--out", run)
    assert "next: rna-export" in said
    assert "next: rna-validate" in command("rna-export", run / "best.ckpt", "--out", package)
    assert "valid" in command("rna-validate", package)
    scene = tmp_path / "scene.yaml"
    scene.write_text(YAML)
    command("rna-run", scene, "--out", tmp_path / "out.exr", "--png", tmp_path / "out.png")
    ours = read_rgba(tmp_path / "out.exr")

    with BlenderWorker(blender_python, Source(source), tmp_path / "scratch", 1) as worker:
        wi = (WI / np.linalg.norm(WI)).astype(np.float32)
        file = read_scene(scene)
        camera = Camera(file.scene.camera, file.scene.resolution)
        cycles = worker.render_view(camera, wi, 64, seed=0)

    assert np.abs(ours[..., 3] - cycles[..., 3]).mean() < 0.01  # the same silhouette
    inside = (ours[..., 3] > 0.99) & (cycles[..., 3] > 0.99)
    assert inside.mean() > 0.25
    correlation = np.corrcoef(ours[inside][:, :3].ravel(), cycles[inside][:, :3].ravel())[0, 1]
    assert psnr(ours[inside][:, :3], cycles[inside][:, :3]) > asset.psnr
    assert correlation > asset.correlation
    assert (tmp_path / "out.png").stat().st_size > 1000

    # The standard pictures agree, too; the camera below the hemisphere is not among them.
    page, small = tmp_path / "compare", ["--resolution", 40, "--samples", 4, "--cycles-samples", 16]
    assert "index.html" in command("rna-compare", package, source, "--out", page, *small)
    results = json.loads((page / "results.json").read_text())
    assert len(results["pictures"]) == asset.pictures
    # At the exposure of an asset that is not dark, which the differences have a part of.
    assert results["psnr"] + 20.0 * np.log10(results["exposure"]) > 22.0
    assert (page / "sheet.png").is_file()
