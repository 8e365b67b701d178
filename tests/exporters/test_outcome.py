"""What a bake's log says came true: by material, of highlights and outlines, at the worst place."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import write_arrays
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.capture.preflight.verdicts import MaterialVerdict
from rna_export.outcome.judged_image import box_sum
from rna_export.outcome.outcome import MaterialOutcome, Outcome
from rna_export.outcome.triangle_materials import TriangleMaterials
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh
from tests.exporters.synthetic import make_dataset

UPPER = MaterialVerdict(name="cap", is_="metal", learnt="well")
LOWER = MaterialVerdict(name="cup", is_="opaque", learnt="not", loses="relief")


def two_materials(folder: Path) -> Dataset:
    """A ball, 'cap' above and 'cup' below, in images without noise."""
    dataset = make_dataset(folder, views=8).dataset
    mesh = dataset.only.geometry()
    assert isinstance(mesh, Mesh)
    above = mesh.positions[mesh.triangles][..., 1].mean(axis=1) > 0.0
    write_arrays(
        folder / "materials.safetensors", {"asset": np.where(above, 1, 0).astype(np.int16)}
    )
    manifest = dataset.manifest.model_copy(update={"materials": (LOWER, UPPER)})
    manifest.write(folder / "manifest.json")
    return Dataset(folder)


def is_above(view: WholeView) -> np.ndarray:
    return np.asarray(view.parts[0].samples["position"][:, 1] > 0.0)


def outcome(dataset: Dataset, factors: tuple[float, float]) -> Outcome:
    """A model that is the reference times one factor above, and another one below."""
    views, (above, below) = dataset.whole_views(), factors
    shaded = [v.reference * np.where(is_above(v), above, below)[:, None] for v in views]
    return Outcome.of([s.astype(np.float32) for s in shaded], views, dataset)


def test_points_have_the_material_of_their_triangle(tmp_path):
    dataset = two_materials(tmp_path / "ball.rays")
    materials = TriangleMaterials(dataset)
    assert materials.names == ["cup", "cap", "asset"]
    for view in dataset.whole_views():
        off = np.abs(view.parts[0].samples["position"][:, 1]) > 0.1  # the seam follows triangles
        np.testing.assert_array_equal(materials.of_image(view)[off], is_above(view)[off])


@pytest.mark.parametrize("numbers", [np.zeros(3, np.int16), None])
def test_materials_that_do_not_fit_the_triangles_are_refused(numbers, tmp_path):
    dataset = two_materials(tmp_path / "ball.rays")
    wrong = dataset.materials["asset"] + np.int16(1) if numbers is None else numbers
    write_arrays(tmp_path / "ball.rays" / "materials.safetensors", {"asset": wrong})
    with pytest.raises(CaptureError, match="its materials do not fit its triangles"):
        TriangleMaterials(dataset)


def test_a_material_that_is_lost_is_told_beside_its_promise(tmp_path):
    dataset = two_materials(tmp_path / "ball.rays")
    made = outcome(dataset, (0.0, 1.0))
    cap, cup = made.materials
    assert (cap.name, cup.name) == ("cap", "cup") and cap.share + cup.share == pytest.approx(1.0)
    assert cap.flip is not None and cap.flip > 0.3 and cap.lost == cap.shown > 0
    assert cup.flip is not None and cup.flip < cap.flip / 2 and cup.lost == 0  # FLIP blurs the seam
    picture = tmp_path / "worst.png"
    title, first, second, *others = made.told(picture)
    assert title.startswith("what came true, in ")
    assert "'cap'" in first and "promised: learnt well: FLIP" in first
    assert first.endswith(
        f"worse than promised; lost in {cap.lost} of {cap.shown} images that show it"
    )
    assert "'cup'" in second and "promised: learnt without its relief: FLIP" in second
    assert others[-1].startswith("  worst place: validation image ") and "'cap'" in others[-1]
    assert others[-1].endswith(f"missing: {picture} shows it beside Cycles")
    with Image.open(picture) as image:
        assert image.width == 4 * 24 * round(256 / 24)


@pytest.mark.parametrize(
    ("promise", "flip", "ends"),
    [
        (LOWER, 0.034, "FLIP 0.034 (very good), better than promised"),
        (LOWER, 0.2, "FLIP 0.200 (poor)"),
        (UPPER, 0.034, "FLIP 0.034 (very good)"),
        (UPPER, 0.12, "FLIP 0.120 (rough), worse than promised"),
        (UPPER, None, "promised: learnt well: too little is seen of it to tell"),
        (None, 0.2, "pixels): FLIP 0.200 (poor)"),
    ],
)
def test_promises_are_compared_with_errors(promise, flip, ends):
    told = MaterialOutcome(name="m", share=0.3, flip=flip, shown=4, lost=0, promise=promise)
    assert told.told().startswith("  'm' (30% of the pixels)") and told.told().endswith(ends)
    assert told.told(is_sketch=True).endswith(ends.removesuffix(", worse than promised"))


def test_a_perfect_model_keeps_its_promises(tmp_path):
    made = outcome(two_materials(tmp_path / "ball.rays"), (1.0, 1.0))
    assert [each.flip for each in made.materials] == [0.0, 0.0]
    light = made.brightest, made.outline_light
    assert light == pytest.approx((1.0, 1.0)) and made.outline == 0.0
    assert 0.0 < made.outline_share < 0.5
    assert made.worst is None and made.told(Path("none.png")) == []


@pytest.mark.parametrize("factor", [0.8, 1.3])
def test_light_of_highlights_and_outlines_is_over_that_of_cycles(factor, tmp_path):
    made = outcome(two_materials(tmp_path / "ball.rays"), (factor, factor))
    assert made.brightest == pytest.approx(factor, rel=1e-5)
    assert made.outline_light == pytest.approx(factor, rel=1e-5)
    assert made.worst is not None and made.worst.light == pytest.approx(factor, rel=1e-5)


def test_a_dataset_without_materials_of_triangles_is_told_of_as_a_whole(tmp_path):
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    made = outcome(dataset, (0.0, 1.0))
    assert made.materials == ()
    lines = made.told(tmp_path / "worst.png")
    assert [line.split()[0] for line in lines] == ["in", "highlights:", "outlines", "worst"]
    assert "''" not in lines[-1]


def test_sums_of_squares_are_those_of_loops():
    values = np.random.default_rng(0).random((7, 7))
    padded = np.pad(values, 1)
    expected = [[padded[r : r + 3, c : c + 3].sum() for c in range(7)] for r in range(7)]
    np.testing.assert_allclose(box_sum(values, 3), expected)
