"""What Blender's import asks the SDK of a package, of one inside a .glb too."""

import subprocess
import sys

import numpy as np

from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.package.carriers import make_carrier

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
