"""Environments as other programs write them: the viewer reads what `rna-run` reads."""

import base64
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from rna_render.lights.files.environment_file import read_environment
from rna_sdk.errors import SceneError
from tests.render.environment_files import cases

REPOSITORY = Path(__file__).parents[2]


def read_by_viewer(paths: list[Path], folder: Path) -> list[np.ndarray | str]:
    """Each file's texels, or the viewer's message."""
    if shutil.which("npm") is None:
        pytest.skip("no Node; on Debian: apt-get install nodejs npm")
    if not (REPOSITORY / "runtime/web/node_modules/installed").is_file():
        subprocess.run([REPOSITORY / "scripts/web-bundle", folder / "site"], check=True)
    command = ["node", Path(__file__).with_name("read_images.mjs"), *paths]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    results = []
    for line in lines:
        read = json.loads(line)
        if "error" in read:
            assert read["error"].startswith("NotSupported: ")
            results.append(read["error"])
        else:
            texels = np.frombuffer(base64.b64decode(read["rgb"]), np.float32)
            results.append(texels.reshape(read["height"], read["width"], 3))
    return results


def test_the_viewer_reads_environments_as_rna_run_does(tmp_path):
    files = cases(tmp_path)
    for case, actual in zip(files, read_by_viewer([c.path for c in files], tmp_path), strict=True):
        if case.texels is not None:
            case.check(actual)
            continue
        assert isinstance(actual, str), case.path.name
        assert case.message in actual and case.path.name in actual
        with pytest.raises(SceneError) as caught:
            read_environment(case.path)
        if case.message:
            said = actual.removeprefix(f"NotSupported: {case.path.name}: ")
            assert said.split(":")[0] in str(caught.value)  # the same words
