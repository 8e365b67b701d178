"""A scene file is read without the renderer: no Embree, no compiled code."""

import subprocess
import sys

import pytest

ENGINES = "numba", "onnxruntime", "embreex", "rna_trace.embree", "rna_render.paths.integrator"


@pytest.mark.parametrize("module", ["scene.scene_model", "scene.scene_file", "scene.animation"])
def test_the_scene_model_loads_no_engine(module):
    code = f"import rna_render.{module}, sys; print(*sys.modules)"
    command = [sys.executable, "-c", code]
    loaded = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    assert f"rna_render.{module}" in loaded
    assert [name for name in ENGINES if name in loaded] == []
