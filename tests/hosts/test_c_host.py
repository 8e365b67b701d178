"""The C host beside the runtime: the same numbers and pictures."""

import ctypes
import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.runtime import load
from rna_sdk.runtime.tiers import expected_error
from tests.conformance.kit.decoders import Int8Decoder, KitInt8Layer
from tests.hosts.c_host import SOURCES, CAsset, compiler
from tests.hosts.packages import broken_constants, make_profile_tier, write_profile_package
from tests.package.builders import read_entries
from tests.package.corpus.registry import with_entry, with_manifest

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

EXAMPLES = Path(__file__).parents[2] / "examples"
TOY, CURLS = EXAMPLES / "quickstart" / "toy.rna", EXAMPLES / "fibers" / "curly_ball.rna"
ROWS = 2000
TOLERANCE = 1e-4  # of the root mean square


def random_rows(kind: str, bounds: np.ndarray, n: int) -> list[np.ndarray]:
    """Arguments of `evaluate`: positions in and about the bounds, directions of any length, and
    for surfaces base colours.
    """
    rng = np.random.default_rng(3)
    size = bounds[1] - bounds[0]
    positions = rng.uniform(bounds[0] - 0.1 * size, bounds[1] + 0.1 * size, (n, 3))
    axes, wo, wi = rng.normal(size=(3, n, 3))
    if kind == "fiber":
        rows = positions, axes, rng.uniform(-1.2, 1.2, n), wo, wi
    else:
        rows = positions, axes, wo, wi, rng.random((n, 3))
    return [a.astype(np.float32) for a in rows]


def differences(library: Path, package: Path, tier: str) -> np.ndarray:
    """(n,) largest difference of each row from the runtime, in parts of the root mean square."""
    asset, other = load(package, tier, threads=1), CAsset(library, package, tier)
    rows = random_rows(asset.kind, asset.bounds, ROWS)
    expected = np.concatenate(asset.evaluate(*rows), axis=1)
    actual = np.concatenate(other.evaluate(*rows), axis=1)
    other.close()
    scale = np.sqrt(np.mean(expected.astype(np.float64) ** 2))
    return np.abs(actual - expected).max(axis=1) / scale


@pytest.mark.parametrize("package", [TOY, CURLS], ids=["toy", "curls"])
def test_shipped_assets_mean_the_same(package, programs):
    assert differences(programs["librna.so"], package, "small").max() < TOLERANCE


def test_int8_sums_of_a_wide_layer_are_exact(programs, tmp_path):
    """Sums beyond what float32 holds, of which the bias leaves a few steps."""
    tier = make_profile_tier("wide", "surface", decoder_precision="int8")
    columns, wide, unit = tier.parts[0].query_width, 1100, np.float32(0.25)
    ones, steps = np.ones(columns, np.float32), np.arange(1, 7)
    weight = (126 + np.arange(wide * 6).reshape(wide, 6) % 2).astype(np.int8)
    full = KitInt8Layer(
        np.zeros((columns, wide), np.int8), np.ones(wide, np.float32), np.full(wide, 300), ones[0]
    )
    left = KitInt8Layer(
        weight, np.full(6, unit), steps - 255 * weight.sum(axis=0, dtype=int), ones[0]
    )
    layers = [replace(layer, bias=layer.bias.astype(np.int32)) for layer in (full, left)]
    file = Int8Decoder(ones, ones, layers, np.float32(1)).file()
    package = write_profile_package(tmp_path / "wide.rna", tier)
    # In place of a good decoder: an engine that sums in float32 calls this one inconsistent.
    package.write_bytes(with_entry(read_entries(package), tier.parts[0].decoder, file))
    asset = CAsset(programs["librna.so"], package, "wide")
    actual = asset.evaluate(*random_rows("surface", np.float32([[-1] * 3, [1] * 3]), 60))
    asset.close()
    expected = np.broadcast_to(np.exp(steps * unit) - 1, (60, 6))
    np.testing.assert_allclose(np.concatenate(actual, axis=1), expected, rtol=1e-5)


def test_a_row_means_the_same_in_any_batch(programs):
    asset = CAsset(programs["librna.so"], TOY, "small")
    rows = random_rows("surface", np.float32([[0, 0, -0.4], [0.8, 0.4, 0.1]]), 200)
    whole = np.concatenate(asset.evaluate(*rows), axis=1)
    for part in (slice(0, 1), slice(47, 49), slice(100, 157)):
        some = asset.evaluate(*(np.ascontiguousarray(a[part]) for a in rows))
        np.testing.assert_array_equal(np.concatenate(some, axis=1), whole[part])
    assert asset.evaluate(*(a[:0] for a in rows))[0].shape == (0, 3)
    asset.close()


@pytest.mark.parametrize("precision", ["float32", "int8"])
@pytest.mark.parametrize("number", [np.nan, np.inf])
def test_constants_that_are_not_finite_are_refused(number, precision, programs, tmp_path):
    """Every one, also where a later Clip or QuantizeLinear hides it."""
    package = tmp_path / "broken.rna"
    tier = make_profile_tier("small", "surface", decoder_precision=precision)
    entries = read_entries(write_profile_package(package, tier))
    for broken in broken_constants(entries, number):
        package.write_bytes(broken)
        validated = run(programs["conform"], "validate", package)
        assert (validated.returncode, validated.stdout.split()) == (1, ["DECODER_RESULT"])


def test_pipes_and_devices_are_refused(programs, tmp_path):
    """To open a pipe would wait for a writer."""
    os.mkfifo(tmp_path / "pipe.rna")
    for path in (tmp_path / "pipe.rna", "/dev/zero", tmp_path):
        result = run(programs["conform"], "validate", path)
        assert (result.returncode, result.stdout.split()) == (1, ["FILE_UNREADABLE"])


def run(*command: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)


def test_error_by_height_and_domain_are_those_of_the_runtime(programs, tmp_path):
    rna = ctypes.CDLL(str(programs["librna.so"]))
    rna.rna_open.restype, rna.rna_flip_at.restype = ctypes.c_void_p, ctypes.c_double
    rna.rna_in_domain.restype = ctypes.c_bool
    up, down = ((ctypes.c_float * 3)(0.6, y, 0) for y in (0.8, -0.8))
    cone = {"axis": [0, 1, 0], "halfAngle": 0.7}
    for region, contains in (("sphere", [1, 1]), ("hemisphere", [1, 0]), ([cone], [1, 0])):
        path = tmp_path / "toy.rna"
        path.write_bytes(
            with_manifest(read_entries(TOY), lambda m, r=region: m["domain"].update(wi=r))
        )
        asset = ctypes.c_void_p(rna.rna_open(str(path).encode(), None))
        assert [rna.rna_in_domain(asset, True, d) for d in (up, down)] == contains
        assert rna.rna_in_domain(asset, False, down)
        assert not rna.rna_in_domain(asset, True, (ctypes.c_float * 3)(np.nan, 1, 0))
        tier = load(path).tier
        for pixels in (1e6, 300, 77.0, 40, 3, 0.5):
            actual = rna.rna_flip_at(asset, 0, ctypes.c_double(pixels))
            assert actual == pytest.approx(expected_error(tier, pixels), rel=1e-9)
        assert rna.rna_flip_at(asset, 9, ctypes.c_double(100)) < 0
        rna.rna_close(asset)


def test_null_and_nan_are_answered(programs):
    """No report, no path, no asset, and coordinates that are not numbers."""
    rna = ctypes.CDLL(str(programs["librna.so"]))
    for name in ("rna_open", "rna_open_memory", "rna_part", "rna_tier"):
        getattr(rna, name).restype = ctypes.c_void_p
    assert rna.rna_open(None, None) is None
    assert rna.rna_open_memory(None, 0, None) is None
    assert rna.rna_part(None, 0) is None and rna.rna_tier(None, 0) is None
    assert rna.rna_part_count(None) == rna.rna_tier_count(None) == 0
    assert rna.rna_tier_index(None, b"small") == -1
    asset = ctypes.c_void_p(rna.rna_open(str(TOY).encode(), None))
    assert asset and rna.rna_tier_index(asset, None) == -1
    normal = (ctypes.c_float * 3)(1, 1, 1)
    nan, tau = ctypes.c_double(np.nan), (ctypes.c_float * 3)(1, 1, 1)
    rna.rna_normal(asset, 0, 0, nan, nan, normal)
    rna.rna_transmittance(asset, 0, 0, nan, nan, (ctypes.c_float * 3)(np.nan, 0, 1), tau)
    rna.rna_normal(None, 0, 0, nan, nan, normal)
    rna.rna_transmittance(None, 0, 0, nan, nan, normal, tau)
    assert [*normal, *tau] == [0] * 6
    rna.rna_close(asset)
    rna.rna_close(None)


def test_data_of_extensions_are_as_in_the_file(programs):
    """The text of the JSON, and the bytes of an entry; NULL for missing ones."""
    rna, size = ctypes.CDLL(str(programs["librna.so"])), ctypes.c_size_t()
    for name in ("rna_open", "rna_extension", "rna_entry"):
        getattr(rna, name).restype = ctypes.c_void_p
    asset = ctypes.c_void_p(rna.rna_open(str(TOY).encode(), None))
    entries = read_entries(TOY)
    extensions = json.loads(entries["manifest.json"])["extensions"]
    for name, expected in extensions.items():
        at = rna.rna_extension(asset, name.encode(), ctypes.byref(size))
        assert json.loads(ctypes.string_at(at, size.value)) == expected
    image = extensions["RNA_poster"]["image"]
    at = rna.rna_entry(asset, image.encode(), ctypes.byref(size))
    assert ctypes.string_at(at, size.value) == entries[image]
    for of in (asset, None):
        assert rna.rna_extension(of, b"ACME_none", ctypes.byref(size)) is None and size.value == 0
        assert rna.rna_entry(of, b"none", None) is None
    rna.rna_close(asset)


@pytest.mark.parametrize(
    "target", ["x86_64-windows-gnu", "x86-windows-gnu", "arm-linux-musleabihf", "aarch64-macos"]
)
def test_it_compiles_for_other_systems(target, tmp_path):
    """By zig's compiler, where `pip install ziglang` has it."""
    zig = Path(pytest.importorskip("ziglang").__file__).with_name("zig")
    command = [zig, "cc", "-target", target, "-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror"]
    caches = dict.fromkeys(("ZIG_GLOBAL_CACHE_DIR", "ZIG_LOCAL_CACHE_DIR"), str(tmp_path))
    command += ["-fno-math-errno", "-ffp-contract=off", "-O1", "-c", SOURCES / "rna.c"]
    subprocess.run([*command, "-o", tmp_path / "rna.o"], check=True, env={**os.environ, **caches})


def test_it_compiles_without_warnings(tmp_path):
    command = ["cc", "-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror", "-O0", "-c"]
    subprocess.run([*command, SOURCES / "rna.c", "-o", tmp_path / "rna.o"], check=True)
