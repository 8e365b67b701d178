"""Benchmarks of one part: what they say of a package of several."""

import pytest

from rna_bench.one_part import load_one_part
from rna_sdk.errors import QueryError
from tests.package.builders import make_tiny_package
from tests.package.lantern import make_lantern


def test_a_package_of_one_part_is_its_part(tmp_path):
    asset = load_one_part(make_tiny_package(tmp_path / "x.rna"))
    assert (asset.name, asset.kind) == ("tetrahedron", "surface")


def test_a_package_of_several_parts_is_refused(tmp_path):
    path = make_lantern(tmp_path / "lantern.rna")
    with pytest.raises(QueryError, match=r"lantern.rna: found 2 parts, expected one"):
        load_one_part(path, "hq")
