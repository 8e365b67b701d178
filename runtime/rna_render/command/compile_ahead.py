"""Compiles the renderer's kernels in a process of its own, beside a first render that needs them.

    python -m rna_render.command.compile_ahead SCENE FOLDER

One process compiles one kernel at a time, whatever its threads. So this one begins with what the
render comes to late: rays that leave assets, and the queries of those of the scene. Then it
renders a triangle, whose files it writes into the folder, for what is left.
"""

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np

_TRIANGLE = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
"""

_SCENE = """
assets: []
objects: [{path: triangle.ply, material: {type: diffuse, color: [0.5, 0.5, 0.5]}}]
ground: {material: {type: diffuse, color: [0.5, 0.5, 0.5]}}
camera: {position: [1, 1, 1], look_at: [0, 0, 0], vertical_fov_deg: 40}
lights:
  - {type: directional, direction: [0, 1, 1], irradiance: [1, 1, 1]}
  - {type: environment, radiance: [0.1, 0.1, 0.1]}
resolution: [16, 16]
samples: 1
"""


@contextmanager
def compiling_ahead(scene: Path) -> Iterator[None]:
    """A context beside which such a process runs; at its end the process is ended."""
    quiet = subprocess.DEVNULL
    with tempfile.TemporaryDirectory(prefix="rna-run-") as folder:
        command = [sys.executable, "-m", "rna_render.command.compile_ahead", str(scene), folder]
        with subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet) as process:
            try:
                yield
            finally:
                process.kill()


def main() -> None:
    from rna_sdk.errors import RnaError
    from rna_sdk.machine.kernel_threads import limit_kernel_threads

    limit_kernel_threads(1)
    scene, folder = map(Path, sys.argv[1:])
    _leave_assets()
    with suppress(RnaError):  # which the render will tell of
        _ask_assets(scene)
    _render_triangle(folder)


def _leave_assets() -> None:
    from rna_render.world.neural_sampling import LobeMixture

    lobes, rows = LobeMixture().everywhere, np.ones((1, 3), np.float32)
    lobes.pdf(rows, rows, rows, rows)
    lobes.sample(rows, rows, rows, np.zeros((1, 2)))


def _ask_assets(scene: Path) -> None:
    from rna_render.scene import read_scene
    from rna_sdk.runtime import SurfaceAsset, load

    rows, numbers, yes = np.ones((1, 3), np.float32), np.zeros(1, np.float32), np.ones(1, bool)
    scene_file = read_scene(scene)
    for path, tier in {(model.path, model.tier) for model in scene_file.resolved.assets}:
        for part in load(path, tier=tier).parts:
            if isinstance(part, SurfaceAsset):
                color = part.base_color_at(np.zeros(1, np.int64), numbers, numbers, numbers)
                part.transport(rows, rows, rows, rows, yes, base_color=color)
            else:
                part.transport(rows, rows, numbers, rows, rows, yes)


def _render_triangle(folder: Path) -> None:
    from rna_render import load_world, make_integrator, render
    from rna_render.scene import read_scene

    path = folder / "scene.yaml"
    (folder / "triangle.ply").write_text(_TRIANGLE)
    path.write_text(_SCENE)
    scene_file = read_scene(path)
    render(scene_file.resolved, make_integrator(scene_file.resolved, load_world(scene_file)))


if __name__ == "__main__":
    main()
