"""What the runtime is asked does not depend on the order of a sample's fields."""

import inspect

import numpy as np
import pytest

from rna_export.capture.dataset.asset_arguments import emission_arguments, evaluate_arguments
from rna_export.capture.dataset.dataset_manifest import SAMPLE_FIELDS
from rna_export.capture.dataset.validation_view import ValidationView, all_queries
from rna_sdk.runtime import FiberAsset, SurfaceAsset

ASSETS = {"surface": SurfaceAsset, "fiber": FiberAsset}


def fields_of(kind: str) -> dict[str, np.ndarray]:
    """Every field in the reverse of the order that captures have, and one that is not asked."""
    printed = ["base_color"] if kind == "surface" else []
    names = [*printed, *reversed(SAMPLE_FIELDS[kind]), "uv"]
    return {name: np.full((2, 3), k, np.float32) for k, name in enumerate(names)}


@pytest.mark.parametrize("kind", ASSETS)
@pytest.mark.parametrize("method", ["evaluate", "emission"])
def test_arguments_are_those_of_the_runtime(kind, method):
    fields = fields_of(kind)
    actual = (evaluate_arguments if method == "evaluate" else emission_arguments)(fields)
    parameters = list(inspect.signature(getattr(ASSETS[kind], method)).parameters)
    expected = [name for name in parameters if name not in ("self", "out", "nearby")]
    assert [name.rstrip("s") for name in expected] == list(actual._fields)
    for name, value in actual._asdict().items():
        assert value is fields[name]


def test_queries_of_views_leave_out_what_the_runtime_does_not_take():
    fields = fields_of("surface")
    view = ValidationView(0, 2, np.arange(2), fields, np.zeros((2, 2, 3), np.float32))
    actual = all_queries([view, view])
    for values, name in zip(actual, ("position", "normal", "wo", "wi", "base_color"), strict=True):
        assert np.array_equal(values, np.concatenate([fields[name]] * 2))
    del fields["base_color"]
    *_, wi, base_color = all_queries([view, view])
    assert base_color is None and np.array_equal(wi, np.concatenate([fields["wi"]] * 2))
