"""Base colour in the viewer: as a factor of transport, and looked up in images at the hits."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest

from rna_sdk import runtime
from rna_view.site_files import Site
from tests.gpu.test_evaluate import rows
from tests.package.prints import LABEL, STAMP, image_bytes, make_print
from tests.web.pages import base64_of, call_reader, viewer
from tests.web.test_picture import (
    LEAST_PSNR,
    SUNS,
    by_rna_run,
    by_viewer,
    middles_of_pixels,
    psnr,
    write_scene,
)

pytestmark = pytest.mark.chromium
__all__ = ["middles_of_pixels"]


def test_transport_as_the_runtime_has_it(tmp_path):
    """By one decoder, and by two of which one is for shadowed light."""
    path = make_print(tmp_path / "print.rna")
    colors = np.random.default_rng(1).uniform(size=(500, 3)).astype(np.float32)
    with viewer(Site({}, {})) as page:
        for tier in ("small", "hq"):
            asset = runtime.load(path, tier)
            x, n, wo, wi = rows(500, asset.bounds)
            expected = np.hstack(asset.evaluate(x, n, wo, wi, base_color=colors))
            queries = np.hstack([x, n, np.zeros((500, 1), np.float32), wo, wi, colors])
            text = base64.b64encode(queries.tobytes()).decode()
            call_reader(page, "load", base64_of(path), tier)
            answer = call_reader(page, "evaluate", 0, "transport", text)
            actual = np.frombuffer(base64.b64decode(answer), "<f4").reshape(500, 6)
            assert np.abs(actual - expected).max() <= 1e-3 * np.sqrt(np.mean(expected**2))


VIEW = {"position": [1.6, 1.5, 2.9], "look_at": [0.0, -0.1, 0.0]}
PRINT = """
  - path: {path}
    tier: hq
    maps: {{label: noise.png}}
    tint: [0.6, 1.2, 1]"""


def write_files(folder: Path) -> dict[str, bytes]:
    """Images for make_print, finer than pixels; in the folder another one, noise.png."""
    rng = np.random.default_rng(9)
    noise = [rng.integers(0, 256, (128, 256, 3)).astype(np.uint8) for _ in range(2)]
    (folder / "noise.png").write_bytes(image_bytes(noise[1][:100]))
    return {LABEL: image_bytes(noise[0]), STAMP: image_bytes(noise[1][:7, :9])}


def printed_anew(scene: Path, path: Path) -> None:
    """Changes the scene of write_scene: another map, a tint, and the tier of two decoders."""
    before = f"[{{path: {path}}}]"
    scene.write_text(scene.read_text().replace(before, PRINT.format(path=path)))


@pytest.mark.parametrize("is_changed", [False, True], ids=["its own print", "another print"])
@pytest.mark.usefixtures("middles_of_pixels")
def test_the_picture_of_the_path_tracer(tmp_path, is_changed):
    """By one decoder; by two, with another map and a tint."""
    path = make_print(tmp_path / "print.rna", write_files(tmp_path))
    scene = write_scene(tmp_path, {"path": path, **VIEW}, SUNS, [96, 60], 1)
    if is_changed:
        printed_anew(scene, path)
    assert psnr(by_viewer(scene, "&jitter=0"), by_rna_run(scene)) >= LEAST_PSNR
