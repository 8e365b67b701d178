"""RNA_sampling: lobes for rays that leave the parts of a package."""

from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from rna_render.world.neural_sampling import LobeMixture, PartLobes
from rna_sdk.errors import PackageError
from rna_sdk.package.command.package_info import package_info
from rna_sdk.package.manifest.extensions import (
    USUAL_SAMPLING,
    FiberLobe,
    MirrorLobe,
    Mixture,
    Sampling,
)
from rna_sdk.package.packing import Unpacked
from rna_sdk.runtime import load
from tests.package.builders import make_tiny_fiber_package, make_tiny_package

MIXTURES = (
    Mixture(cosine=0.5, mirror=(MirrorLobe(share=0.3, width=0.2),)),
    Mixture(first=1, mirror=(MirrorLobe(share=0.9, width=0.001),)),
)
CONES = (Mixture(forward=FiberLobe(share=0.2, width=0.5), cone=(FiberLobe(share=0.6, width=0.1),)),)


def with_sampling(package: Path, *mixtures: Mixture) -> Path:
    Unpacked.read(package).with_extension(Sampling(parts=(mixtures,)), {}).write(package)
    return package


def test_lobes_of_a_part_are_read_again(tmp_path):
    tiny = with_sampling(make_tiny_package(tmp_path / "tiny.rna"), *MIXTURES)
    fibers = with_sampling(make_tiny_fiber_package(tmp_path / "fibers.rna"), *CONES)
    assert load(tiny).parts[0].sampling == MIXTURES
    assert load(fibers).parts[0].sampling == CONES
    assert package_info(tiny)["parts"][0]["has"] == ["rays in 2 mixtures of lobes"]


def test_without_them_a_part_has_the_usual_ones_of_its_kind(tmp_path):
    tiny = load(make_tiny_package(tmp_path / "tiny.rna"))
    fibers = load(make_tiny_fiber_package(tmp_path / "fibers.rna"))
    assert tiny.parts[0].sampling == (USUAL_SAMPLING["surface"],)
    assert fibers.parts[0].sampling == (USUAL_SAMPLING["fiber"],)


@pytest.mark.parametrize("mixture", [Mixture(first=3, cone=CONES[0].cone), MIXTURES[0]])
def test_fibers_have_one_mixture_of_their_own_lobes(tmp_path, mixture):
    fibers = make_tiny_fiber_package(tmp_path / "fibers.rna")
    mixtures = (CONES[0], mixture) if mixture.first else (mixture,)
    with pytest.raises(PackageError, match="FIELD_VALUE"):
        with_sampling(fibers, *mixtures)


def test_points_have_the_lobes_of_their_triangles():
    triangle = np.array([0, 1, 7, 0])
    placed, rng = PartLobes.of(MIXTURES).at(triangle), np.random.default_rng(0)
    axis = np.float32(rng.normal(size=(4, 3)))
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    wi = placed.sample(axis, axis, axis, rng.random((4, 2)))
    pdf = placed.pdf(axis, axis, axis, wi)
    for k, mixture in enumerate(MIXTURES):
        here = np.flatnonzero((triangle > 0) == k)
        one = LobeMixture.of(mixture).everywhere
        np.testing.assert_array_equal(one.pdf(axis, axis, axis, wi[here], here), pdf[here])


LOBE = {"share": 0.1, "width": 0.1}


@pytest.mark.parametrize(
    "part",
    [
        None,
        [],
        [{"glossy": 0.5}],
        [{"cosine": -0.1}],
        [{"mirror": [{"width": 0.1}]}],
        [{"mirror": [LOBE] * 4}],
        [{"first": 1, "cosine": 0.5}],
        [{"first": first, "cosine": 0.5} for first in range(17)],
    ],
)
def test_wrong_data_is_refused(part):
    with pytest.raises(ValidationError):
        Sampling.model_validate({"parts": [part]})
