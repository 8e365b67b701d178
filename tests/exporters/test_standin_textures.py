"""Textures of stand-ins: baked at the right texels, in glTF's frame, and where they cannot be."""

import io
from dataclasses import replace

import numpy as np
import pytest
import torch
from PIL import Image

from rna_export.export.standin_textures import standin_textures, uv_points
from rna_export.training.model.analytic import gltf_material
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import ANALYTIC
from rna_render import encode_srgb
from rna_sdk.errors import ExportError
from rna_sdk.package import Mesh

SIDE = 16


def floor() -> Mesh:
    """In y = 0 from 0 to 1: u along x, v along z; its left half alone is in the texture."""
    corners = np.float32([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]])
    up = np.tile(np.float32([0, 1, 0]), (4, 1))
    uvs = corners[:, [0, 2]] * np.float32([0.5, 1.0])
    return Mesh(corners, up, uvs, np.uint32([[0, 2, 1], [0, 3, 2]]))


def model_of_place() -> NeuralAsset:
    """Outputs: the position's x and z as albedo, and a normal that leans along +x and -z."""
    bounds = torch.tensor([[-0.1, -0.1, -0.1], [1.1, 1.1, 1.1]])
    preset = ANALYTIC.with_model(
        inputs=("position", "normal"), resolution=2, channels=1, hidden_layers=1, width=6
    )
    model = NeuralAsset(preset.model, bounds)
    first, _, last = model.decoder
    with torch.no_grad():
        first.weight.copy_(torch.eye(6))
        first.bias.fill_(2.0)
        last.weight.zero_()
        last.weight[0, 0] = last.weight[1, 2] = 1.0
        last.bias.copy_(torch.tensor([-2.0, -2.0, 0.0, 1.0, 4.0, 0.3, 0.0, -0.2]))
    return model


def pixels(png: bytes) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(png)), np.float32) / 255.0


def test_texels_hold_the_material_of_their_place():
    model = model_of_place()
    images = {name: pixels(png) for name, png in standin_textures(model, floor(), SIDE).items()}
    assert {image.shape for image in images.values()} == {(SIDE, SIDE, 3)}
    row, column = 5, 3
    p = torch.tensor([[(column + 0.5) / SIDE * 2.0, 0.0, (row + 0.5) / SIDE]])
    n = torch.tensor([[0.0, 1.0, 0.0]])
    at = {"position": p, "normal": n, "wo": n, "wi": n}
    with torch.no_grad():
        material = gltf_material(model.decoder(model.queries(at)))
    base = encode_srgb(material.base_color.numpy())[0]
    np.testing.assert_allclose(images["base_color"][row, column], base, atol=0.003)
    rough = images["metallic_roughness"][row, column]
    np.testing.assert_allclose(
        rough[1:], [material.roughness.item(), material.metallic.item()], atol=0.003
    )
    mapped = 2.0 * images["normal"][row, column] - 1.0
    x, y, z = material.normal(n)[0].tolist()
    np.testing.assert_allclose(mapped, [x, -z, y], atol=0.01)  # x along u, y against v
    beside = images["base_color"][row, SIDE // 2 : SIDE // 2 + 4]  # grown past the chart
    assert np.abs(beside - images["base_color"][row, SIDE // 2 - 1]).max() < 0.1


@pytest.mark.parametrize(
    ("uvs", "what"),
    [
        (lambda uvs: None, "no texture coordinates"),
        (lambda uvs: 6.0 * uvs, "from 0 to 6, expected a texture that repeats less"),
        (lambda uvs: 3.0 * uvs, "overlap in"),
        (lambda uvs: np.float32([[0, 0], [1, 0], [1, 1], [1, 0]]), "overlap in"),
        (lambda uvs: np.zeros_like(uvs), "without an area"),
    ],
    ids=["none", "tiled often", "tiled", "folded", "a point"],
)
def test_what_lays_out_no_texture_is_told(uvs, what):
    mesh = floor()
    with pytest.raises(ExportError, match=what):
        uv_points(replace(mesh, uvs=uvs(mesh.uvs)), SIDE)


def test_charts_may_lie_over_the_edge_of_the_texture():
    mesh = floor()
    moved = replace(mesh, uvs=mesh.uvs + np.float32([-0.25, 0.5]))
    at, shifted = uv_points(mesh, SIDE), uv_points(moved, SIDE)
    assert len(at.texel) == len(shifted.texel) == SIDE * SIDE / 2
    row, column = np.divmod(at.texel, SIDE)
    expected = (row + SIDE // 2) % SIDE * SIDE + (column - SIDE // 4) % SIDE
    order = np.argsort(expected)
    np.testing.assert_array_equal(shifted.texel, expected[order])
    np.testing.assert_allclose(shifted.position, at.position[order], atol=1e-6)
