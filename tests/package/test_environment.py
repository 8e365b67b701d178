"""Lobes of parts (RNA_environment): written, read again, replaced, left out."""

import numpy as np
import pytest

from rna_sdk.package import Package, Unpacked, quantised_harmonics, validate
from rna_sdk.package.manifest.extensions import Environment, extension
from tests.package.lobes import FOREST, make_harmonics, make_lobes, with_lobes


def test_lobes_come_back(lantern, tmp_path):
    path = with_lobes(lantern, tmp_path / "x.rna", 1)
    assert validate(path) == []
    with Package.open(path) as package, Package.open(lantern) as plain:
        lobes = package.environment(1)
        assert lobes is not None and package.environment(0) is plain.environment(1) is None
        assert lobes.record.lobes == 4
        assert lobes.record.planes == plain.tier("small").parts[1].planes
        assert bytes(lobes.decoder) == make_lobes(plain, 1).decoder
        np.testing.assert_array_equal(lobes.harmonics, make_harmonics(plain.curves(1)))
        np.testing.assert_array_equal(lobes.planes, plain.planes("small", 1))
        assert extension(package.manifest, Environment).validation == (FOREST,)
        assert package.manifest.extensions_required == ()


def test_lobes_are_coded_and_replaced(tiny, tmp_path):
    path = with_lobes(tiny, tmp_path / "x.rna", 0)
    Unpacked.read(path).deflated().write(tmp_path / "coded.rna")
    with Package.open(tmp_path / "coded.rna") as package:
        lobes = package.environment()
        other = make_lobes(package, lobes=2, visibility=False)
        assert lobes is not None and lobes.record.lobes == 4
        np.testing.assert_array_equal(lobes.harmonics, make_harmonics(package.mesh()))
    Unpacked.read(path).with_environment([other]).write(path)
    with Package.open(path) as package:
        lobes = package.environment()
        assert lobes is not None and lobes.record.lobes == 2 and lobes.harmonics is None
        assert sum("RNA_environment" in name for name in package.manifest.entries) == 1
    assert validate(path) == []


def test_harmonics_are_stored_to_half_a_step():
    coefficients = np.random.default_rng(0).uniform(-1.0, 1.0, (50, 16))
    stored = quantised_harmonics(coefficients)
    assert stored.dtype == np.int8
    assert np.abs(stored / 127.0 - coefficients).max() <= 0.5 / 127.0
    assert quantised_harmonics(np.float32([[2.0, -2.0]])).tolist() == [[127, -127]]


def test_lobes_of_a_tier_that_is_not_there(tiny):
    with Package.open(tiny) as package:
        lobes = make_lobes(package)
    wrong = type(lobes)("none", lobes.lobes, lobes.inputs, lobes.decoder)
    with pytest.raises(KeyError):
        Unpacked.read(tiny).with_environment([wrong])
