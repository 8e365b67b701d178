"""Compiles the renderer's kernels in a process of its own, beside a first render that needs them.

    python -m rna_render.command.compile_ahead FOLDER

It renders a triangle, whose files it writes into the folder. So the kernels of rays, lights and
film are in the cache on disk when the render comes to them: meanwhile that one compiles those of
its assets. One process compiles one kernel at a time, whatever its threads.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

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
def compiling_ahead() -> Iterator[None]:
    """A context beside which such a process runs; at its end the process is ended."""
    quiet = subprocess.DEVNULL
    with tempfile.TemporaryDirectory(prefix="rna-run-") as folder:
        command = [sys.executable, "-m", "rna_render.command.compile_ahead", folder]
        with subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet) as process:
            try:
                yield
            finally:
                process.kill()


def main() -> None:
    from rna_render import load_world, make_integrator, render
    from rna_render.scene import read_scene
    from rna_sdk.machine.kernel_threads import limit_kernel_threads

    limit_kernel_threads(1)
    folder = Path(sys.argv[1])
    path = folder / "scene.yaml"
    (folder / "triangle.ply").write_text(_TRIANGLE)
    path.write_text(_SCENE)
    scene_file = read_scene(path)
    render(scene_file.resolved, make_integrator(scene_file.resolved, load_world(scene_file)))


if __name__ == "__main__":
    main()
