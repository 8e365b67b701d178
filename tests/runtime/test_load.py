"""Opening an asset: tier, threads, memory, and what comes with the import."""

import copy
import os
import pickle
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package import Cost, Package, Tier, Validation
from rna_sdk.runtime import FiberAsset, SurfaceAsset, load
from rna_sdk.runtime.tiers import choose_tier
from tests.package.builders import FIBER_INPUTS, make_curves, make_mesh, make_tier
from tests.package.lantern import make_lantern
from tests.runtime.points import random_points


def test_the_first_tier_is_the_default(tiers_path):
    assert load(tiers_path).tier.name == "hq"


def test_an_asset_tells_in_one_line_what_it_is(tiers_path, tmp_path):
    size, asset = f"{tiers_path.stat().st_size:,} bytes", load(tiers_path, tier="small")
    assert repr(asset) == (
        f"<SurfaceAsset {asset.name!r}: {asset.name} (surface); "
        f"tier small of hq, small, raw, odd; {size}>"
    )
    lantern = make_lantern(tmp_path / "lantern.rna")
    parts, size = "body (surface), tuft (fiber)", f"{lantern.stat().st_size:,} bytes"
    assert repr(load(lantern)) == (
        f"<CompositeAsset 'lantern': {parts}; tier small of small, hq; {size}>"
    )
    with Package.open(lantern) as package:
        assert repr(package) == f"<Package 'lantern': {parts}; tiers small, hq; {size}>"
    assert repr(package) == "<Package 'lantern', closed>"


@pytest.mark.parametrize("copied", [pickle.dumps, copy.copy, copy.deepcopy])
def test_a_pickled_asset_says_what_to_do_instead(tiers_path, copied):
    with pytest.raises(QueryError, match=r"call load\(path\) in each process"):
        copied(load(tiers_path))


FORKED = """
import os, signal, sys
import numpy as np
from rna_sdk.runtime import load
asset = load(sys.argv[1], threads=2)
rng = np.random.default_rng(1)
arguments = rng.normal(size=(4, 5000, 3)).astype(np.float32)
expected = asset.evaluate(*arguments)
child = os.fork()
if child == 0:
    signal.alarm(60)
    os._exit(0 if np.array_equal(asset.evaluate(*arguments), expected) else 1)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
def test_a_forked_process_evaluates_as_the_one_before(tiers_path):
    """Threads do not live on in it: neither may it wait for them."""
    command = [sys.executable, "-W", "ignore", "-c", FORKED, str(tiers_path)]
    assert subprocess.run(command, timeout=120).returncode == 0


@pytest.mark.parametrize(("min_psnr", "name"), [(35, "fast"), (39.9, "plain")])
def test_multiply_adds_of_int8_count_half(min_psnr, name):
    def tier(name: str, psnr: float, multiply_adds: int, precision: str) -> Tier:
        return make_tier(
            name,
            decoder_precision=precision,
            validation=Validation(psnr=psnr, flip=0, relative_mse=0, images=1, definition="-"),
            cost=Cost(multiply_adds=multiply_adds, ns_per_query=1, threads=1, machine="-"),
        )

    package = SimpleNamespace(
        manifest=SimpleNamespace(
            tiers=(tier("plain", 40, 600, "float32"), tier("fast", 39, 1000, "int8"))
        )
    )
    assert choose_tier(package, None, min_psnr).name == name


def test_a_tier_is_taken_by_name(tiers_path):
    small, hq = (load(tiers_path, tier=name) for name in ("small", "hq"))
    assert small.tier.name == "small"
    points = random_points(10)
    assert not np.array_equal(small.evaluate(*points), hq.evaluate(*points))


@pytest.mark.parametrize(
    ("min_psnr", "name"), [(30, "small"), (35, "small"), (35.1, "hq"), (45, "odd")]
)
def test_the_cheapest_tier_that_is_good_enough(tiers_path, min_psnr, name):
    assert load(tiers_path, min_psnr=min_psnr).tier.name == name


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"tier": "best"}, "best.*hq, small, raw, odd"),
        ({"min_psnr": 60}, "no tier of 60 dB.*hq 40 dB, small 35 dB, raw none, odd 50 dB"),
        ({"min_psnr": float("nan")}, "no tier of nan dB"),
        ({"min_psnr": "high"}, "expected a number of dB, found 'high'"),
        ({"tier": "hq", "min_psnr": 30}, "give only one"),
        ({"threads": 0}, "threads: expected .* found 0"),
        ({"threads": 1.5}, "threads: expected .* found 1.5"),
        ({"threads": True}, "threads: expected .* found True"),
    ],
)
def test_what_cannot_be_loaded_is_said(tiers_path, arguments, message):
    with pytest.raises(QueryError, match=message):
        load(tiers_path, **arguments)  # type: ignore[arg-type]


def test_a_broken_package_is_refused(tiers_path, tmp_path):
    broken = tmp_path / "broken.rna"
    broken.write_bytes(tiers_path.read_bytes()[:-100])
    with pytest.raises(PackageError):
        load(broken)


def test_threads_are_the_cores_of_the_process_by_default(tiers_path):
    assert load(tiers_path).threads == len(os.sched_getaffinity(0))
    assert load(tiers_path, threads=3).threads == 3


@pytest.mark.parametrize("path", [None, 3, ["toy.rna"]])
def test_a_path_that_is_none_is_said(path):
    message = f"^path: expected the name of a package, found {type(path).__name__}$"
    with pytest.raises(QueryError, match=message):
        load(path)


def test_the_rest_shape_cannot_be_written(asset_path):
    for kind in ("surface", "fiber"):
        asset = load(asset_path(kind=kind))
        geometry = asset.mesh if kind == "surface" else asset.curves
        for array in (value for value in vars(geometry).values() if value is not None):
            with pytest.raises(ValueError, match="read-only"):
                array[...] = 0


def test_geometry_and_bounds_come_with_the_asset(tiers_path):
    asset = load(tiers_path)
    assert asset.bounds.dtype == np.float32
    assert asset.bounds.tolist() == [[-1, -1, -1], [1, 1, 1]]
    np.testing.assert_array_equal(asset.mesh.positions, make_mesh().positions)


def test_the_kind_of_the_package_decides_what_is_loaded(asset_path):
    surface, fiber = (load(asset_path(kind=kind)) for kind in ("surface", "fiber"))
    assert isinstance(surface, SurfaceAsset) and isinstance(fiber, FiberAsset)
    assert (surface.kind, fiber.kind) == ("surface", "fiber")
    assert fiber.tier_part.inputs == FIBER_INPUTS
    assert fiber.bounds.tolist() == [[-1, -1, -1], [1, 1, 1]]
    curves = make_curves()
    np.testing.assert_array_equal(fiber.curves.points, curves.points)
    np.testing.assert_array_equal(fiber.curves.offsets, curves.offsets)


@pytest.mark.parametrize("precision", ["int8", "float16", "float32"])
def test_planes_stay_in_the_file(asset_path, precision):
    """The kernel reads the mapped bytes: what it works on is a view, not a copy."""
    package = Package.open(asset_path(plane_precision=precision))
    views: list[np.ndarray] = []
    planes = package.planes

    def remembered(tier: str, part: int) -> np.ndarray:
        actual = planes(tier, part)
        views.append(actual.texels if precision == "int8" else actual)
        return actual

    package.planes = remembered  # type: ignore[assignment, method-assign]
    asset = SurfaceAsset(package, package.manifest.tiers[0], 1, 0, "asset")
    assert np.shares_memory(asset._evaluators["transport"][0]._filler._texels, views[0])
    assert not views[0].flags.writeable


TRAINER_OR_RENDERER = ("torch", "lightning", "onnx", "bpy", "rna_trace", "rna_render", "rna_export")
ENGINES = ("numba", "llvmlite", "onnxruntime")
PACKAGE_ALONE = (*ENGINES, "rna_sdk.runtime")


@pytest.mark.parametrize(
    ("code", "unused"),
    [
        ("import rna_sdk.package", PACKAGE_ALONE),
        ("import rna_sdk.package as p; p.Package.open(path).planes('small')", PACKAGE_ALONE),
        ("import rna_sdk.runtime", ENGINES),
        ("from rna_sdk.runtime import Asset, load", ENGINES),
        (
            "import rna_sdk.runtime as r; r.Transform([[1.0 * (i == k) for k in range(4)]"
            " for i in range(4)])",
            ENGINES,
        ),
        ("import rna_sdk.runtime as r; r.load(path)", ()),
    ],
)
def test_nothing_is_loaded_before_it_is_used(tiers_path, code, unused):
    actual = f"sys.exit(str([m for m in {TRAINER_OR_RENDERER + unused} if m in sys.modules]))"
    program = f"import sys; path = sys.argv[1]; {code}; {actual}"
    done = subprocess.run(
        [sys.executable, "-c", program, tiers_path], capture_output=True, text=True
    )
    assert done.stderr.strip() == "[]"
