"""Stand-in textures that an export makes by itself."""

import io
import math
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from rna_export.export import standin_fit
from rna_export.export.standin_fit import LARGEST_SHARE, textures_within
from rna_sdk.package import Mesh
from tests.exporters import synthetic
from tests.exporters.synthetic import ALBEDO, make_dataset

STEPS = 40


def charted(mesh: Mesh) -> Mesh:
    """The mesh with a chart of its own for each triangle, in a grid."""
    corners = mesh.triangles.reshape(-1)
    count = len(corners) // 3
    side = math.ceil(math.sqrt(count))
    cells = np.stack(np.divmod(np.arange(count), side), axis=1)[:, None]
    uvs = (cells + np.array([[0.05, 0.05], [0.95, 0.05], [0.05, 0.95]])) / side
    return replace(
        mesh,
        positions=mesh.positions[corners],
        normals=mesh.normals[corners],
        uvs=uvs.reshape(-1, 2).astype(np.float32),
        triangles=np.arange(len(corners), dtype=np.uint32).reshape(-1, 3),
    )


@pytest.fixture
def dataset(tmp_path, monkeypatch):
    sphere = synthetic.sphere
    monkeypatch.setattr(synthetic, "sphere", lambda levels: charted(sphere(levels)))
    monkeypatch.setattr(standin_fit, "_STEPS", STEPS)
    return make_dataset(tmp_path / "ball.rays").dataset


def test_they_have_the_colour_of_the_asset_and_a_share_of_its_size(dataset, monkeypatch):
    said: list[str] = []
    model = standin_fit._fitted(dataset.only)
    monkeypatch.setattr(standin_fit, "_fitted", lambda part: model)
    (textures,) = textures_within(dataset, 10_000_000, said.append)
    assert textures is not None and "512 x 512" in said[0]
    base = np.asarray(Image.open(io.BytesIO(textures["base_color"])), np.float32) / 255.0
    mean = (((base + 0.055) / 1.055) ** 2.4).mean(axis=(0, 1))
    np.testing.assert_allclose(mean, ALBEDO, atol=0.2)
    assert mean[0] > mean[1] > mean[2]
    size = sum(map(len, textures.values()))
    # In a smaller package they are coarser, and in a tiny one there are none.
    (coarse,) = textures_within(dataset, int(0.5 * size / LARGEST_SHARE), said.append)
    assert coarse is not None and sum(map(len, coarse.values())) <= 0.5 * size
    assert textures_within(dataset, 1000, said.append) == [None]
    assert said[-1] == "stand-in: no textures, they exceed 15% of the package"


def test_without_texture_coordinates_there_are_none(tmp_path):
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    assert textures_within(dataset, 10_000_000, print) == [None]
