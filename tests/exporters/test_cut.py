"""A surface cut into pieces with planes of their own: what each has, and that no seam shows."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.cut import as_cut, cut_triangles
from rna_export.export.rna_export import main as export
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.report import Curves
from rna_export.training.training_run import Run, train
from rna_export.training.validation import answer
from rna_sdk.errors import CaptureError
from rna_sdk.package import Package, quantise
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.runtime import CompositeAsset, load
from tests.exporters.meshes import sphere
from tests.exporters.synthetic import make_dataset, tiny, transport
from tests.runtime.points import unit_vectors

RESOLUTION = 32
STEPS = 300


def area(mesh: Mesh) -> float:
    a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(float) for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2.0)


@pytest.mark.parametrize("pieces", [1, 2, 3, 8])
def test_pieces_have_each_triangle_once_and_equal_areas(pieces):
    mesh = sphere(4)
    cut = cut_triangles(mesh, pieces)
    assert np.array_equal(np.sort(np.concatenate(cut)), np.arange(len(mesh.triangles)))
    of = [area(Mesh(mesh.positions, mesh.normals, None, mesh.triangles[k])) for k in cut]
    assert np.allclose(of, area(mesh) / pieces, rtol=0.02)


def test_the_longest_side_is_cut():
    mesh = sphere(3)
    long = Mesh(mesh.positions * np.float32([1, 1, 3]), mesh.normals, None, mesh.triangles)
    low, high = (long.positions[long.triangles[k]].mean(axis=1) for k in cut_triangles(long, 2))
    assert low[:, 2].max() <= high[:, 2].min()


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return make_dataset(tmp_path_factory.mktemp("cut") / "ball.rays", shards=12).dataset


def test_samples_at_a_seam_belong_to_both_sides(whole):
    every = whole.only.training_samples()["position"]
    cut = as_cut(whole, 2)
    assert [part.name for part in cut.parts] == ["asset_0", "asset_1"]
    of = [part.training_samples()["position"] for part in cut.parts]
    assert len(every) < len(of[0]) + len(of[1]) < 1.3 * len(every)
    axis = int(np.argmax(np.abs(of[0].mean(axis=0))))
    assert min(of[0][:, axis].max(), of[1][:, axis].max()) > 0.0
    assert max(of[0][:, axis].min(), of[1][:, axis].min()) < 0.0
    for part, positions in zip(cut.parts, of, strict=True):
        low, high = np.array(part.bounds)
        assert (positions >= low - 1e-6).all() and (positions <= high + 1e-6).all()
        corners = part.geometry().positions
        assert (corners >= low - 1e-6).all() and (corners <= high + 1e-6).all()


def test_each_pixel_belongs_to_one_piece(whole):
    for view, uncut in zip(
        as_cut(whole, 4).whole_views(), whole.only.validation_views(), strict=True
    ):
        assert len(view.parts) == 4
        pixels = np.concatenate([part.pixel for part in view.parts])
        assert np.array_equal(np.sort(pixels), np.sort(uncut.pixel))
        assert np.array_equal(view.image(view.reference), uncut.image(uncut.reference))


def test_pieces_of_a_quantised_mesh_share_its_vertices(tmp_path):
    mesh = quantise(sphere(3))
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    Dataset.create(dataset.folder, dataset.manifest, {"asset": mesh})
    pieces = [part.geometry() for part in as_cut(Dataset(dataset.folder), 2).parts]
    actual = {tuple(p) for piece in pieces for p in piece.positions.tolist()}
    assert actual == {tuple(p) for p in mesh.positions.tolist()}
    assert all(piece.quantised is not None for piece in pieces)


def test_too_many_pieces_are_refused(whole):
    with pytest.raises(CaptureError, match="a cut in 17 gives 17 parts, expected at most 16"):
        as_cut(whole, 17)


@dataclass(frozen=True)
class Cut:
    """A run of two pieces."""

    dataset: Dataset
    out: Path
    models: tuple[NeuralAsset, ...]


@pytest.fixture(scope="module")
def cut(whole, tmp_path_factory):
    dataset, out = as_cut(whole, 2), tmp_path_factory.mktemp("run")
    preset = tiny(steps=STEPS).with_model(resolution=RESOLUTION)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        best = [train(Run(part, preset, "small", out / part.name)) for part in dataset.parts]
    return Cut(dataset, out, tuple(load_checkpoint(path).model for path in best))


def error_of_steps(
    across: Callable[[np.ndarray], tuple[int, int]], cut: Cut, plane: float
) -> tuple[float, float]:
    """RMS error of the step in radiance over 3 texels across a plane; RMS error of the radiance.

    `across`: which models answer on the near and on the far side.
    """
    rng = np.random.default_rng(3)
    low, high = np.array(cut.dataset.parts[0].bounds)
    axis = int(np.argmin(high - low))  # the cut one: each piece is half of the ball
    texel = (high - low)[axis] / RESOLUTION
    n = unit_vectors(rng, 60_000)
    n[:, axis] = plane + texel * rng.uniform(-0.2, 0.2, len(n))
    near, far = n.copy(), n.copy()
    near[:, axis] -= 1.5 * texel
    far[:, axis] += 1.5 * texel
    near, far = (p / np.linalg.norm(p, axis=1, keepdims=True) for p in (near, far))
    wo, wi = unit_vectors(rng, len(n)), unit_vectors(rng, len(n))
    lit = (np.sum(wo * n, axis=1) > 0.3) & (np.sum(wi * n, axis=1) > 0.3)
    errors = []
    for points, model in zip((near, far), across(n), strict=True):
        p = points[lit].astype(np.float32)
        queries = {"position": p, "normal": p, "wo": wo[lit], "wi": wi[lit]}
        errors.append(answer(cut.models[model], queries)[0] - transport(p, wo[lit], wi[lit])[0])
    step = errors[1] - errors[0]
    return float(np.sqrt(np.mean(step**2))), float(np.sqrt(np.mean(np.square(errors))))


def test_no_seam_shows_at_three_texels(cut):
    """The error steps at the seam no more than it does over as many texels inside a piece."""
    low, high = np.array(cut.dataset.parts[0].bounds)
    axis = int(np.argmin(high - low))
    upper = int(cut.dataset.parts[1].bounds[0][axis] > low[axis])
    order = (1 - upper, upper)
    seam, error = error_of_steps(lambda _: order, cut, 0.0)
    inside = [
        error_of_steps(lambda _, k=side: (k, k), cut, plane)
        for side, plane in ((order[0], -0.3), (order[1], 0.3))
    ]
    step_inside, error_inside = np.mean(inside, axis=0)
    assert seam < 1.25 * step_inside and seam < 1.25 * error
    assert error < 1.25 * error_inside


def test_a_package_of_pieces(cut, tmp_path, capsys):
    out = tmp_path / "ball.rna"
    assert export([str(cut.out), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "part asset_0 PSNR" in said and "part asset_1 PSNR" in said
    asset = load(out)
    assert isinstance(asset, CompositeAsset)
    with Package.open(out) as package:
        assert [part.name for part in package.manifest.parts] == ["asset_0", "asset_1"]
    one = load_checkpoint(cut.out / "asset_1" / "best.ckpt")
    assert (one.part, one.cut) == ("asset_1", 2)


def test_a_piece_is_missing(cut, tmp_path, capsys):
    only = str(cut.out / "asset_1" / "best.ckpt")
    assert export([only, "--out", str(tmp_path / "ball.rna")]) == 1
    error = capsys.readouterr().err
    assert "found checkpoints of asset_1; expected one of each part: asset_0, asset_1" in error
