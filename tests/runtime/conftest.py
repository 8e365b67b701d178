"""Packages and assets for the tests here."""

from pathlib import Path

import pytest

from rna_sdk.package import Cost, Tier, Validation, write_package
from rna_sdk.runtime import load
from tests.package.builders import (
    FIBER_INPUTS,
    INPUTS,
    make_curves,
    make_manifest,
    make_mesh,
    make_tier,
    make_tier_data,
)


@pytest.fixture(scope="session")
def asset_path(tmp_path_factory):
    """Writes a package of one tier; the decoder's `width` and `layers`, then the tier's fields."""

    def write(width: int = 32, layers: int = 3, kind: str = "surface", **fields: object) -> Path:
        tier = make_tier(**{"inputs": INPUTS if kind == "surface" else FIBER_INPUTS, **fields})
        path = tmp_path_factory.mktemp("asset") / "asset.rna"
        data = make_tier_data(tier, width, layers)
        geometry = make_mesh() if kind == "surface" else make_curves()
        write_package(path, make_manifest(tier, kind=kind), [geometry], {tier.name: data})
        return path

    return write


@pytest.fixture(scope="session", params=["surface", "fiber", "int8"])
def asset(asset_path, request):
    """An asset whose decoder the runtime rewrites: either kind, or a surface in int8.

    On two threads.
    """
    fields: dict[str, object] = {"resolution": 16, "channels": 8}
    if request.param == "int8":
        fields |= {"plane_precision": "int8", "decoder_precision": "int8"}
    else:
        fields["kind"] = request.param
    return load(asset_path(**fields), threads=2)


@pytest.fixture(scope="session")
def tiers_path(tmp_path_factory):
    """A package of four tiers: two validated, one not, one validated but without a cost."""

    def tier(name: str, psnr: float | None, multiply_adds: int | None) -> Tier:
        validation = psnr and Validation(
            psnr=psnr, flip=0.1, relative_mse=0.1, images=1, definition="made up"
        )
        cost = multiply_adds and Cost(
            multiply_adds=multiply_adds, ns_per_query=1, threads=1, machine="made up"
        )
        return make_tier(name, validation=validation or None, cost=cost or None)

    tiers = (
        tier("hq", 40, 9000),
        tier("small", 35, 900),
        tier("raw", None, 1),
        tier("odd", 50, None),
    )
    path = tmp_path_factory.mktemp("tiers") / "tiers.rna"
    data = {t.name: make_tier_data(t, seed=seed) for seed, t in enumerate(tiers)}
    write_package(path, make_manifest(*tiers), [make_mesh()], data)
    return path
