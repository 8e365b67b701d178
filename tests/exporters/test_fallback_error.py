"""fallbackFlip: the error of the mesh that other viewers show, beside validation images."""

from pathlib import Path

import numpy as np

from rna_export.fallback_error import complete_fallback, fallback_flip
from rna_sdk.package import validate
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.conftest import REPOSITORY
from tests.exporters.synthetic import ALBEDO, make_dataset
from tests.package.carriers import Document, changed, make_carrier, opened
from tests.render.assets import sphere

PACKAGE = REPOSITORY / "spec" / "conformance" / "packages" / "surface-float32.rna"


def coloured(folder: Path, color: np.ndarray, **attributes: object) -> Path:
    """The ball of the dataset as a rough .glb of this colour."""
    plain = folder / "plain.glb"
    plain.write_bytes(mesh_to_glb(sphere(3)))

    def change(document: Document) -> None:
        surface = {"baseColorFactor": [*color.tolist(), 1.0], "metallicFactor": 0.0}
        document["materials"] = [{"pbrMetallicRoughness": surface, **attributes}]
        document["meshes"][0]["primitives"][0]["material"] = 0

    return changed(plain, folder / "ball.glb", change)


def test_it_is_less_the_nearer_the_fallback_is(tmp_path):
    views = make_dataset(tmp_path / "ball.rays", views=4).dataset.whole_views()
    near = fallback_flip(coloured(tmp_path, ALBEDO), views)
    dark = fallback_flip(coloured(tmp_path, 0.3 * ALBEDO), views)
    other = fallback_flip(coloured(tmp_path, ALBEDO[::-1].copy()), views)
    gone = fallback_flip(coloured(tmp_path, ALBEDO, alphaMode="MASK", alphaCutoff=1.1), views)
    assert near < 0.6 * other and near < 0.6 * dark and dark < gone


def test_it_is_recorded_in_the_node_and_changes_nothing_else(tmp_path):
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    path = make_carrier(PACKAGE, tmp_path / "a.glb")
    before = opened(path)
    (line,) = complete_fallback(path, dataset)
    document, blob = opened(path)
    record = document["nodes"][-1]["extensions"]["RNA_relightable_asset"]
    assert f"FLIP {record.pop('fallbackFlip'):.4f}" in line
    assert (document, blob) == before and validate(path) == []
    assert complete_fallback(PACKAGE, dataset) == []


def test_a_source_that_moves_is_told(tmp_path):
    """The fallback is the package at rest: what keeps skin and clips is the source itself."""
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    moving, still = tmp_path / "walk.gltf", tmp_path / "still.gltf"
    moving.write_text('{"asset": {"version": "2.0"}, "animations": [{"name": "walk"}]}')
    still.write_text('{"asset": {"version": "2.0"}}')
    path = make_carrier(PACKAGE, tmp_path / "a.glb")
    for source, notes in ((moving, 1), (still, 0), (tmp_path / "gone.glb", 0)):
        lines = complete_fallback(path, dataset, source)
        told = [line for line in lines if "the fallback does not move" in line]
        assert len(told) == notes and all("walk.glb" in line for line in told)
