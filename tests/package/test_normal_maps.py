"""Packages with normal maps are read as written, in any form of the file."""

import json

import numpy as np
import pytest

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package import NormalMapRecord, Package, quantise, validate, write_package
from rna_sdk.package.manifest.manifest_reader import parse_manifest
from rna_sdk.runtime import load
from tests.package.builders import (
    make_curves,
    make_manifest,
    make_mesh,
    make_part,
    make_tier_data,
    read_entries,
)
from tests.package.lantern import make_lantern_manifest, make_textures
from tests.package.relief import BARK, DENT, make_maps, make_relief, make_relief_manifest


@pytest.fixture(scope="module")
def relief(tmp_path_factory):
    """Path of a good package with normal maps; do not change it."""
    return make_relief(tmp_path_factory.mktemp("relief") / "relief.rna")


def test_normal_maps_come_back(relief):
    assert validate(relief) == []
    with Package.open(relief) as package:
        assert package.manifest.parts == make_relief_manifest().parts
        bark, dent = package.normal_maps()
        assert package.transmittance() == []
        with pytest.raises(QueryError, match="no part 1; this package has 1"):
            package.normal_maps(1)
    assert (bark.first, bark.count, dent.first, dent.count) == (0, 2, 3, 1)
    maps = make_maps()
    for actual, name in ((bark, BARK), (dent, DENT)):
        np.testing.assert_array_equal(actual.texture, maps[name])
        assert not actual.texture.flags.writeable and not actual.texture.flags.owndata
    (part,) = load(relief, "small", threads=1).parts
    assert [record.count for record in part.normal_maps] == [2, 1]


def test_a_package_without_is_none_the_wiser(lantern):
    with Package.open(lantern) as package:
        assert package.normal_maps(0) == [] and package.normal_maps(1) == []
    assert "normalMaps" not in json.loads(read_entries(lantern)["manifest.json"])["parts"][0]


def test_maps_stay_with_holes_and_quantised_geometry(tmp_path):
    """A part with both kinds of records, whose ranges cross."""
    lantern = make_lantern_manifest()
    record = NormalMapRecord(triangles=(1, 2), texture=BARK)
    body = lantern.parts[0].model_copy(update={"normal_maps": (record,)})
    manifest = lantern.model_copy(update={"parts": (body, lantern.parts[1])})
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    maps = {**make_textures(), BARK: make_maps()[BARK]}
    geometries = [quantise(make_mesh()), make_curves()]
    write_package(tmp_path / "x.rna", manifest, geometries, data, maps)
    assert validate(tmp_path / "x.rna") == []
    with Package.open(tmp_path / "x.rna") as package:
        (actual,) = package.normal_maps()
        assert len(package.transmittance()) == 2
        np.testing.assert_array_equal(actual.texture, maps[BARK])


@pytest.mark.parametrize(
    ("number", "changes", "where"),
    [
        (1, {"triangles": [1, 1]}, "/parts/0/normalMaps/1/triangles"),
        (1, {"texture": "normals/none"}, "/parts/0/normalMaps/1/texture"),
        (0, {"ior": [1.5, 1.5]}, "/parts/0/normalMaps/0/ior"),
    ],
)
def test_issues_tell_the_place_in_the_file(number, changes, where, relief):
    manifest = json.loads(read_entries(relief)["manifest.json"])
    manifest["parts"][0]["normalMaps"][number].update(changes)
    with pytest.raises(PackageError) as caught:
        parse_manifest(json.dumps(manifest).encode())
    assert caught.value.issues[0].pointer_or_offset == where


def test_what_is_no_map_is_not_written(tmp_path):
    manifest, path, maps = make_relief_manifest(), tmp_path / "x.rna", make_maps()
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    bare = make_mesh(uvs=False)
    for code, mesh, textures in (
        ("REFERENCE_MISSING at /parts/0/normalMaps/1/texture", make_mesh(), {BARK: maps[BARK]}),
        ("NORMAL_MAP_TEXTURE", make_mesh(), {**maps, DENT: maps[DENT][..., :1]}),
        ("NORMAL_MAP_TEXTURE", make_mesh(), {**maps, DENT: maps[DENT].astype(np.float32)}),
        ("NORMAL_MAP_UV", bare, maps),
    ):
        with pytest.raises(PackageError, match=code):
            write_package(path, manifest, [mesh], data, textures)
    fibers = make_part(kind="fiber", normal_maps=make_relief_manifest().parts[0].normal_maps)
    with pytest.raises(PackageError, match="FIELD_VALUE at /parts/0/normalMaps"):
        tufted = make_manifest(*manifest.tiers, parts=(fibers,))
        write_package(path, tufted, [make_curves()], data, maps)
    assert list(tmp_path.iterdir()) == []
