"""Views of `rna-bench peers-data`, rendered by Cycles."""

from dataclasses import replace

import numpy as np
import pytest

from rna_bench.peers.views_plan import INTENSITY, ViewsPlan
from rna_bench.peers.views_reader import read_views
from rna_bench.peers.views_rendering import render_views
from rna_sdk.errors import CaptureError
from tests.exporters.conftest import lent_workers, open_worker

__all__ = ["lent_workers", "open_worker"]


@pytest.mark.blender
def test_views_are_lamberts(open_worker, tmp_path):
    """Views of a unit ball: places, depth, light; nothing made twice."""
    worker, folder = open_worker("add(*BALL, diffuse((0.9, 0.5, 0.1)))"), tmp_path / "views"
    albedo = np.array([0.9, 0.5, 0.1])
    plan = ViewsPlan(3, 1, 0, 16, 64, 64)
    render_views(plan, worker, folder)
    views = read_views(folder, "train")
    assert views.depth is not None and views.radius == pytest.approx(1.0, abs=1e-3)
    k = int(np.argmax(views.rgba[..., 0]))
    pixel = views.batch(np.array([k]))
    point = pixel.origins[0] + views.depth.reshape(-1)[k] * pixel.directions[0]
    assert np.linalg.norm(point) == pytest.approx(1.0, abs=0.1)  # not through the pixel's middle
    way = pixel.lights[0] - point
    cosine = point @ way / np.linalg.norm(point) / np.linalg.norm(way)
    expected = albedo / np.pi * INTENSITY * cosine / (way @ way)
    np.testing.assert_allclose(pixel.colour[0], expected, rtol=0.1)
    written = {path: path.stat().st_mtime_ns for path in folder.rglob("*.exr")}
    (folder / "train" / "r_0001.exr").unlink()
    render_views(plan, worker, folder)
    again = {path: path.stat().st_mtime_ns for path in folder.rglob("*.exr")}
    made = {path.name for path in again if again[path] != written[path]}
    assert made == {"r_0001.exr", "r_0001_depth.exr"}
    np.testing.assert_allclose(read_views(folder, "train").rgba, views.rgba, atol=0.05)
    with pytest.raises(CaptureError, match=r"samples 64, now 8\): choose another --out"):
        render_views(replace(plan, samples=8), worker, folder)
