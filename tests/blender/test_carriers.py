"""What Blender's import asks the SDK of a package, of one inside a .glb too."""

import subprocess
import sys

import numpy as np
import pytest

from rna_render.image.images import read_exr
from tests.blender.test_extension import STAGE, TOY
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.package.carriers import CHANGES, changed, make_carrier

UNPACK = REPOSITORY / "exporters" / "blender_extension" / "sdk_side" / "unpack.py"


def test_a_carrier_is_imported_as_its_package(tmp_path):
    package = make_tiny_package(tmp_path / "tiny.rna")
    carrier = make_carrier(package, tmp_path / "tiny.glb")
    arrays = []
    for path in (package, carrier):
        out = tmp_path / f"{path.suffix}.npz"
        subprocess.run([sys.executable, UNPACK, path, out], check=True)
        with np.load(out) as file:
            arrays.append({name: file[name].tobytes() for name in file.files})
    assert arrays[0] == arrays[1] and "0/positions" in arrays[0]


@pytest.mark.blender
def test_blender_renders_the_same_pixels(run_in_blender, tmp_path):
    """And says in a line why a file cannot be imported."""
    carrier = make_carrier(TOY, tmp_path / "toy.glb")
    cut, two = (CHANGES[name][1] for name in ("package_cut", "two_packages"))
    changed(carrier, tmp_path / "cut.glb", cut)
    changed(carrier, tmp_path / "two.glb", two)
    (tmp_path / "plain.glb").write_bytes(b"glTF")
    printed = run_in_blender(
        STAGE
        + f"""
for path in (TOY, {str(carrier)!r}):
    bpy.ops.rna.import_package(filepath=path)
    write(os.path.basename(path) + ".exr")
    bpy.data.objects.remove(bpy.context.view_layer.objects.active)
for name in ("cut", "two", "plain"):
    refused(bpy.ops.rna.import_package, filepath={str(tmp_path)!r} + f"/{{name}}.glb")
"""
    )
    one, other = (read_exr(tmp_path / f"toy.{kind}.exr")[0] for kind in ("rna", "glb"))
    assert one["G"].max() > 0.1
    assert all(one[name].tobytes() == other[name].tobytes() for name in one)
    lines = [line for line in printed.splitlines() if line.startswith("refused:")]
    assert len(lines) == 3
    for line, words in zip(lines, ("ZIP_TRUNCATED", "GLB_SEVERAL", "GLB_"), strict=True):
        assert words in line
