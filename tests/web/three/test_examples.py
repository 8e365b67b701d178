"""The examples for web developers, installed from the packed tarball."""

import io
import json
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.render.gltf_text import box_glb
from tests.web.pages import TIMEOUT
from tests.web.three.pages import REPOSITORY, TOY, installed, opened, packed

pytestmark = pytest.mark.chromium

EXAMPLES = REPOSITORY / "examples" / "web"
SIZE = 64, 40
ROBOT = Path(__file__).parent / "robot.png"
"""The Vite example in that size, by three.js 0.187 and SwiftShader: the robot beside the toy."""
FEW_FRAMES = """{
    const request = requestAnimationFrame;
    let count = 0;
    globalThis.requestAnimationFrame = (draw) => setTimeout(() => request(draw), count++ && 5000);
}"""
"""Else SwiftShader draws many before the picture of one can be taken."""
CELL = 4  # pixels a side
MOST = 12  # of 255: difference of a cell's mean colour from the picture's


def has_toy(red: np.ndarray, green: np.ndarray, blue: np.ndarray) -> bool:
    """Whether there is the toy's red and yellow."""
    return np.sum(red > 2 * green + 40) > 5 and np.sum((red > 80) & (green > 2 * blue)) > 5


def has_toy_in_green_glass(red: np.ndarray, green: np.ndarray, blue: np.ndarray) -> bool:
    """Whether all of the middle is green, in which the toy is seen as light and dark."""
    middle = np.s_[15:25, 24:40]
    is_green = np.all(green[middle] > 2 * np.maximum(red, blue)[middle])
    return bool(is_green) and np.ptp(green[middle]) > 60


def cells(pixels: np.ndarray) -> np.ndarray:
    """Mean colours of squares of the picture, (h / CELL, w / CELL, 3)."""
    width, height = (side // CELL for side in SIZE)
    return pixels.reshape(height, CELL, width, CELL, 3).mean((1, 3))


def has_robot(*channels: np.ndarray) -> bool:
    """Whether robot, toy, floor and their shadows are where the picture has them, and as bright."""
    expected = np.asarray(Image.open(ROBOT).convert("RGB"), float)
    return np.abs(cells(np.stack(channels, -1)) - cells(expected)).max() < MOST


def shows(folder: Path, has: Callable[..., bool] = has_toy, begin: str = "") -> bool:
    """Whether the folder's page comes to show that: of red, green, blue. If not: see seen.png.

    begin: JavaScript before that of the page.
    """
    end = time.monotonic() + TIMEOUT
    with opened(folder, "index.html", *SIZE, begin) as page:
        while time.monotonic() < end:
            image = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            if has(*np.moveaxis(np.asarray(image, float), -1, 0)):
                return True
            time.sleep(0.5)
    image.save(folder / "seen.png")
    return False


def test_plain_page(tmp_path):
    installed(tmp_path)
    shutil.copy(TOY, tmp_path)
    shutil.copy(EXAMPLES / "plain" / "index.html", tmp_path)
    assert shows(tmp_path)


def test_glass_beside_an_asset(tmp_path):
    installed(tmp_path)
    shutil.copy(TOY, tmp_path / "bottle.rna")
    glass = box_glb((1.6, 0.9, 0.8), colour=(0.01, 1.0, 0.01))
    (tmp_path / "bottle.glass.glb").write_bytes(glass)
    shutil.copy(EXAMPLES / "glass" / "index.html", tmp_path)
    assert shows(tmp_path, has_toy_in_green_glass, FEW_FRAMES)


def test_docs_have_the_page():
    page = (EXAMPLES / "plain" / "index.html").read_text()
    assert page in (REPOSITORY / "docs" / "three.md").read_text()
    assert len(page.splitlines()) == 10


def test_examples_ask_for_versions_that_fit():
    """The three.js that rna-three is built for, and the version that is packed."""
    packed = json.loads((REPOSITORY / "runtime" / "web" / "three" / "package.json").read_text())
    built = json.loads((REPOSITORY / "runtime" / "web" / "package.json").read_text())
    for example in ("vite", "react-three-fiber"):
        wanted = json.loads((EXAMPLES / example / "package.json").read_text())["dependencies"]
        assert wanted["rna-three"] == packed["version"]
        assert wanted["three"] == built["devDependencies"]["three"]


@pytest.mark.parametrize("example", ["vite", "react-three-fiber"])
def test_bundled_example(example, tmp_path):
    if shutil.which("npm") and subprocess.run(["npm", "ping"], capture_output=True).returncode:
        pytest.skip("the npm registry does not answer")
    folder = tmp_path / example
    shutil.copytree(EXAMPLES / example, folder)
    (folder / "public").mkdir(exist_ok=True)
    shutil.copy(TOY, folder / "public")
    install = ["npm", "install", "--no-audit", "--no-fund", "--loglevel=error", packed("rna-three")]
    subprocess.run(install, cwd=folder, check=True, timeout=600)
    subprocess.run(["npx", "vite", "build"], cwd=folder, check=True, timeout=600)
    assert (folder / "dist" / "index.html").is_file()
    assert shows(folder / "dist", has_robot if example == "vite" else has_toy)
