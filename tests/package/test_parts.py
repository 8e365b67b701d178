"""Packages of several parts are read as written, one tier after the other."""

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package import Mesh, Package, validate, write_package
from rna_sdk.package.manifest.manifest_reader import parse_manifest
from tests.package.builders import (
    make_curves,
    make_manifest,
    make_mesh,
    make_part_data,
    make_tier,
    make_tier_data,
    read_entries,
)
from tests.package.lantern import (
    LEAF,
    PANE,
    make_lantern,
    make_lantern_data,
    make_lantern_manifest,
    make_textures,
)


def test_every_part_comes_back(lantern):
    assert validate(lantern) == []
    manifest = make_lantern_manifest()
    with Package.open(lantern) as package:
        assert package.manifest.parts == manifest.parts
        assert package.manifest.tiers == manifest.tiers
        assert isinstance(package.geometry(), Mesh)
        np.testing.assert_array_equal(package.curves(1).points, make_curves().points)
        for tier, parts in make_lantern_data(manifest).items():
            for k, made in enumerate(parts):
                np.testing.assert_array_equal(package.planes(tier, k), made.planes)
                assert bytes(package.decoder(tier, k)) == made.decoder
                for form, other in made.others.items():
                    assert bytes(package.decoder(tier, k, form)) == other
        holes, pane = package.transmittance()
        assert package.transmittance(1) == []
    assert (holes.first, holes.count, holes.cutoff, holes.ior) == (0, 2, 0.5, None)
    assert (pane.first, pane.count, pane.cutoff, pane.ior) == (3, 1, None, (1.5, 1.5))
    textures = make_textures()
    np.testing.assert_array_equal(holes.texture, textures[LEAF])
    np.testing.assert_array_equal(pane.texture, textures[PANE])
    assert not holes.texture.flags.writeable and not holes.texture.flags.owndata


def test_a_part_that_is_not_there(lantern):
    with Package.open(lantern) as package:
        for part in (2, -1):
            for ask in (package.geometry, package.transmittance):
                with pytest.raises(QueryError, match=f"no part {part}; this package has 2"):
                    ask(part)
            with pytest.raises(QueryError, match=f"no part {part}"):
                package.planes("small", part)
        with pytest.raises(QueryError, match="no decoder of emission in part 1 of tier 'small'"):
            package.decoder("small", 1, "emission")
        with pytest.raises(QueryError, match="a fiber part has no mesh"):
            package.mesh(1)


def test_entries_are_in_the_order_of_use(lantern):
    tuft = [(f"features/{t}-tuft.safetensors", f"decoders/{t}-tuft.onnx") for t in ("small", "hq")]
    body = [(f"decoders/{t}-body.onnx", f"decoders/{t}-body-glow.onnx") for t in ("small", "hq")]
    assert list(read_entries(lantern)) == [
        "manifest.json",
        *("geometry/body.glb", LEAF, PANE, "geometry/tuft.safetensors"),
        "features/body.safetensors",  # of both tiers
        *(*body[0], *tuft[0]),
        *(*body[1], *tuft[1]),
    ]


def test_equal_geometry_is_stored_once(tmp_path):
    parts = make_lantern_manifest().parts[:1]
    parts = (parts[0], parts[0].model_copy(update={"name": "twin"}))
    tier = make_tier()
    tier = tier.model_copy(update={"parts": tier.parts * 2})
    manifest = make_manifest(tier, parts=parts)
    mesh, data = make_mesh(), [make_part_data(tier.parts[0])] * 2
    write_package(tmp_path / "x.rna", manifest, [mesh, mesh], {"small": data}, make_textures())
    assert len(read_entries(tmp_path / "x.rna")) == 1 + 1 + 2 + 2
    other = make_mesh(uvs=False)
    with pytest.raises(PackageError, match=r"ENTRY_HASH at /parts/1/geometry: .* other data"):
        write_package(tmp_path / "x.rna", manifest, [mesh, other], {"small": data}, make_textures())


@pytest.mark.parametrize(
    ("edit", "where"),
    [
        (lambda m: m["parts"][1].update(kind="volume"), "/parts/1/kind"),
        (lambda m: m["parts"][1].pop("geometry"), "/parts/1/geometry"),
        (lambda m: m["tiers"][1]["parts"].pop(), "/tiers/1/parts"),
        (lambda m: m["tiers"][1]["parts"][0].pop("emission"), "/tiers/1/parts/0"),
        (
            lambda m: m["tiers"][0]["parts"][1]["inputs"].append("normal"),
            "/tiers/0/parts/1/inputs/7",
        ),
        (
            lambda m: m["tiers"][0]["parts"][0]["emission"]["inputs"].append("wi"),
            "/tiers/0/parts/0/emission/inputs/4",
        ),
        (
            lambda m: m["tiers"][1]["parts"][0]["emission"].update(decoder="decoders/none.onnx"),
            "/tiers/1/parts/0/emission/decoder",
        ),
        (
            lambda m: m["parts"][0]["transmittance"][1].update(texture="transmittance/none"),
            "/parts/0/transmittance/1/texture",
        ),
        (
            lambda m: m["parts"][0]["transmittance"][1].update(triangles=[1, 1]),
            "/parts/0/transmittance/1/triangles",
        ),
    ],
)
def test_issues_tell_the_place_in_the_file(edit, where, lantern):
    manifest = json.loads(read_entries(lantern)["manifest.json"])
    edit(manifest)
    with pytest.raises(PackageError) as caught:
        parse_manifest(json.dumps(manifest).encode())
    assert caught.value.issues[0].pointer_or_offset == where


def test_what_does_not_fit_the_manifest_is_not_written(tmp_path):
    manifest, path = make_lantern_manifest(), tmp_path / "x.rna"
    geometries, textures = [make_mesh(), make_curves()], make_textures()
    good = make_lantern_data(manifest)
    dark = [replace(good["hq"][0], others={}), good["hq"][1]]
    for code, arguments in (
        ("PARTS_DIFFER at /parts", (geometries[:1], good, textures)),
        ("PARTS_DIFFER at /tiers/1", (geometries, {**good, "hq": good["hq"][:1]}, textures)),
        ("PARTS_DIFFER at /tiers/1/parts/0/emission", (geometries, {**good, "hq": dark}, textures)),
        ("GEOMETRY_CONTAINER at /parts/0/geometry", (geometries[::-1], good, textures)),
        (
            "REFERENCE_MISSING at /parts/0/transmittance/1",
            (geometries, good, {LEAF: textures[LEAF]}),
        ),
        (
            "TRANSMITTANCE_TEXTURE",
            (geometries, good, {**textures, PANE: textures[PANE].astype(np.float32)}),
        ),
    ):
        with pytest.raises(PackageError, match=code):
            write_package(path, manifest, *arguments)
    assert list(tmp_path.iterdir()) == []
    assert make_lantern(path).read_bytes() == make_lantern(tmp_path / "y.rna").read_bytes()


def test_an_entry_of_many_tiers_is_checked_once(tmp_path, monkeypatch):
    from rna_sdk.package import validator

    tiers = [make_tier(f"t{k}", planes="features/p", decoder="decoders/d") for k in range(16)]
    path = tmp_path / "x.rna"
    data = {tier.name: make_tier_data(tiers[0]) for tier in tiers}
    write_package(path, make_manifest(*tiers), [make_mesh()], data)
    seen: list[Any] = []
    check = validator.check_decoder
    monkeypatch.setattr(validator, "check_decoder", lambda *a: seen.append(a) or check(*a))
    assert validate(path) == [] and len(seen) == 1
