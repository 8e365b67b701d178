"""Scene files with assets, objects, materials and lights of every kind.

    python -m tests.render.whole_scenes FOLDER

writes each as FOLDER/NAME/scene.yaml, with its files.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

from rna_render.image.images import write_exr
from tests.conformance.conftest import KIT
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
BALL = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"

EVERYTHING = f"""
assets:
  - path: {TOY}
    transform: {{translation: [-0.6, 0, 0.2], rotation_deg: [0, 20, 0]}}
  - path: {BALL}
    transform: {{translation: [0.7, 0.35, -0.2], scale: 0.9}}
  - path: {TOY}
    transform: {{translation: [-0.3, 0, -0.9], scale: 1.3}}
ground:
  material: {{type: coated, color: [0.5, 0.3, 0.2], roughness: 0.25}}
camera: {{position: [0.2, 1.1, 2.6], look_at: [0.1, 0.25, -0.1], vertical_fov_deg: 36}}
lights:
  - {{type: directional, direction: [0.5, 0.9, 0.3], irradiance: [1.5, 1.4, 1.2],
      angular_diameter_deg: 5, group: sun}}
  - {{type: rectangle, position: [-1.2, 1, 0.9], look_at: [0, 0.2, 0], size: [0.6, 0.4],
      radiance: [6, 5, 4], group: lamps}}
  - {{type: disk, position: [1.4, 0.9, 0.3], look_at: [0.5, 0.3, 0], radius: 0.25,
      radiance: [3, 5, 9], group: lamps}}
  - {{type: sphere, position: [0.15, 0.35, 0.55], radius: 0.07, radiance: [10, 10, 4]}}
resolution: [40, 28]
samples: 2
max_depth: 3
"""

UNDER_A_SKY = f"""
assets:
  - path: {TOY}
ground:
  material: {{type: diffuse, color: [0.5, 0.6, 0.7]}}
camera: {{position: [1.4, 0.8, 0.8], look_at: [0.4, 0.15, -0.15], vertical_fov_deg: 30}}
lights:
  - {{type: environment, path: sky.exr, rotation_deg: 30}}
  - {{type: spot, position: [1, 1.5, 1], look_at: [0.4, 0, 0], intensity: [1, 0.8, 0.6]}}
  - {{type: directional, direction: [0.2, 1, 0.1], irradiance: [0.4, 0.4, 0.4]}}
resolution: [32, 24]
samples: 16
max_depth: 3
clamp_indirect: 2
"""


RELIEF = f"""
assets:
  - path: {KIT / "packages" / "surface-relief.rna"}
ground:
  material: {{type: shadow_catcher}}
objects:
  - path: quad.obj
    transform: {{translation: [-1.5, 0.5, 0]}}
    material: {{type: diffuse, texture: squares.png}}
camera: {{position: [0.4, 1.6, 3], look_at: [-0.3, 0.2, 0], vertical_fov_deg: 40}}
lights:
  - {{type: environment, radiance: [0.5, 0.6, 0.7]}}
  - {{type: directional, direction: [0.2, 0.9, 0.3], irradiance: [1.3, 1.3, 1.3]}}
resolution: [32, 24]
samples: 2
max_depth: 2
"""


GLOW = f"""
assets:
  - path: {KIT / "packages" / "surface-glow.rna"}
    emission: 2
camera: {{position: [1.4, 1.6, 2.6], look_at: [0, 0.2, 0], vertical_fov_deg: 30}}
lights:
  - {{type: point, position: [1, 2, 1], intensity: [1, 1, 1]}}
resolution: [32, 24]
samples: 2
max_depth: 2
"""

SCENES = {"everything": EVERYTHING, "sky": UNDER_A_SKY, "relief": RELIEF, "glow": GLOW}


def write_files(folder: Path) -> None:
    """The files that the scenes name: quad.obj, squares.png, sky.exr."""
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\n"
    (folder / "quad.obj").write_text(corners + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
    squares = np.kron([[0, 1], [1, 0]], np.ones((4, 4)))[..., None] * [200, 90, 30] + 20
    Image.fromarray(squares.astype(np.uint8)).save(folder / "squares.png")
    _write_sky(folder / "sky.exr")


def _write_sky(path: Path) -> None:
    y, x = np.mgrid[0:16, 0:32] / np.array([16, 32])[:, None, None]
    texels = np.stack([0.2 + x, 0.3 + y, 1.2 - y], axis=-1).astype(np.float32)
    texels[3, 20] = 60.0
    write_exr(path, {c: np.ascontiguousarray(texels[..., k]) for k, c in enumerate("RGB")}, {})


def write_scene(folder: Path, name: str) -> Path:
    """Write a scene of `SCENES` with its files; returns the scene file."""
    folder.mkdir(parents=True, exist_ok=True)
    write_files(folder)
    (folder / "scene.yaml").write_text(SCENES[name])
    return folder / "scene.yaml"


if __name__ == "__main__":
    for scene in SCENES:
        write_scene(Path(sys.argv[1]) / scene, scene)
