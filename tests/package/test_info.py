"""rna-info: what a package says of itself."""

import json

import numpy as np
import pytest

from rna_sdk.commands.error_words import error_text
from rna_sdk.package import BaseColorRecord, Cone, Domain, Package, Provenance
from rna_sdk.package.command.package_info import info_lines, package_info
from rna_sdk.package.command.rna_info import main
from rna_sdk.runtime import SurfaceAsset, load
from rna_sdk.runtime.standin_colors import surface_colors
from tests.conftest import REPOSITORY
from tests.package.builders import make_part, make_tiny_package
from tests.package.lobes import FOREST, with_lobes
from tests.package.prints import LABEL, STAMP, make_images, make_print

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
CURLS = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"


def test_it_says_what_the_package_records(capsys):
    assert main([str(TOY)]) == 0
    said = capsys.readouterr().out
    for part in (
        "toy, 4.24 MB, format 2.0",
        "0.798 x 0.432 x 0.462 m",
        "asset: surface, 17,658 triangles",
        " ns/query (2 threads, AMD EPYC, 2 cores)",
        "hq-int8: ",
        "seen from all, lit from all",
        "examples/quickstart/toy.py",
        "1,760 lights, 4,096 rays a light, 16 samples a ray",
        "hq: 10,000 steps",
        "320 x 291 pixels",
        "only lobes 28.10 dB",
        "RNA_poster, RNA_standin, RNA_sampling, RNA_environment",
        "CC0-1.0",
    ):
        assert part in said, part
    assert "note" not in said


def test_the_error_is_told_in_words(tmp_path):
    info = package_info(make_tiny_package(tmp_path / "tiny.rna"))
    (tier,) = info["tiers"]
    tier.update(psnr=38.92, flip=0.081, flip_p95=0.25)
    assert f"small: {error_text(0.081, 0.25)}, PSNR 38.92 dB; " in "\n".join(info_lines(info))
    tier.update(flip=0.036, flip_p95=None)  # of the whole picture, as it was recorded once
    assert "small: PSNR 38.92 dB; " in "\n".join(info_lines(info))


def test_lobes_are_told_with_their_error(tmp_path):
    info = package_info(with_lobes(make_tiny_package(tmp_path / "tiny.rna"), tmp_path / "lit.rna"))
    assert info["parts"][0]["has"] == ["4 lobes"]
    assert info["lobes"] == [FOREST.model_dump(mode="json", by_alias=False)]
    lines = list(info_lines(info))
    assert "lobes       PSNR 30.50 dB, FLIP 0.0500 under forest; only lobes 28.50 dB" in lines
    assert any(line.endswith("RNA_environment") for line in lines)


def test_images_of_base_colour_are_listed(tmp_path):
    path = make_print(tmp_path / "print.rna")
    info = package_info(path)
    (part,) = info["parts"]
    assert part["has"] == ["base colour"]
    label, stamp = part["images"]
    assert (label["label"], label["width"], label["height"]) == ("label", 4, 3)
    assert stamp["entry"] == STAMP and stamp["bytes"] == len(make_images()[STAMP])
    small, hq = (tier["parts"][0] for tier in info["tiers"])
    assert small["uses_base_color"] and small["shadowed"] is None and hq["shadowed"] == "float32"
    lines = list(info_lines(info))
    size = f"{len(make_images()[LABEL]) / 1e6:.3g} MB"
    assert f"images      label: 4 x 3 pixels, {size}, textures/label.png" in lines
    assert any(line.endswith("float32 decoder, float32 for shadowed light") for line in lines)


def test_a_glb_has_the_print_at_its_vertices(tmp_path):
    """A record of red, green or blue alone is so at the vertices of its triangles."""
    records = tuple(
        BaseColorRecord(triangles=(k, 1), factor=tuple(np.eye(3)[k % 3].tolist())) for k in range(4)
    )
    path = make_print(tmp_path / "print.rna", parts=(make_part(base_color=records),))
    (part,) = load(path).parts
    assert isinstance(part, SurfaceAsset)
    colors = surface_colors(part)
    black = surface_colors(part.with_base_color(tint=(0, 0, 0)))
    added = (colors - black).reshape(4, 3, 3)
    for k in range(4):
        others = np.delete(added[k], k % 3, axis=1)
        assert not others.any() and (added[k, :, k % 3] >= 0).all()
    assert added.any()
    assert main([str(path), "--glb", str(tmp_path / "print.glb")]) == 0


def test_strands_are_counted(capsys):
    assert main([str(CURLS)]) == 0
    assert "asset: fiber, 9,000 strands, 162,000 points" in capsys.readouterr().out


def test_json_has_the_same_for_programs(capsys):
    assert main([str(TOY), "--json"]) == 0
    info = json.loads(capsys.readouterr().out)
    assert info == json.loads(json.dumps(package_info(TOY)))
    assert info["tiers"][0]["psnr"] == pytest.approx(41.285, abs=1e-3)
    assert info["poster"] == {"width": 320, "height": 291} and info["bytes"] == TOY.stat().st_size


def test_the_poster_is_written(tmp_path, capsys):
    assert main([str(TOY), "--poster", str(tmp_path / "toy.png")]) == 0
    with Package.open(TOY) as package:
        assert (tmp_path / "toy.png").read_bytes() == package.poster()
    make_tiny_package(tmp_path / "tiny.rna")
    before = (tmp_path / "tiny.rna").read_bytes()
    assert main([str(tmp_path / "tiny.rna"), "--poster", str(tmp_path / "tiny.rna")]) == 1
    assert "has no poster" in capsys.readouterr().err
    assert (tmp_path / "tiny.rna").read_bytes() == before


def test_what_is_not_recorded_is_said_and_nothing_reaches_the_terminal(tmp_path):
    make_tiny_package(
        tmp_path / "bare.rna",
        domain=Domain(wo="hemisphere", wi=(Cone(axis=(0, 1, 0), half_angle=1.0),)),
        provenance=Provenance(
            source="\x1b[2Jhidden\nline", tool="t", capture={"lights": "many"}, training={"a": 1}
        ),
    )
    lines = "\n".join(info_lines(package_info(tmp_path / "bare.rna")))
    assert "\x1b" not in lines and "?[2Jhidden?line" in lines
    assert "seen from those above the horizon, lit from 1 cone" in lines
    assert "captured    not recorded" in lines and "a: not recorded" in lines
    assert "poster      none" in lines and "extensions  none" in lines


def test_a_cut_of_direct_light_is_said(tmp_path):
    record = Provenance(source="s", tool="t", capture={"lights": 40, "clampDirect": 20.0})
    make_tiny_package(tmp_path / "cut.rna", provenance=record)
    lines = info_lines(package_info(tmp_path / "cut.rna"))
    assert "captured    40 lights, direct light cut at a radiance of 20" in lines


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("none.rna", "none.rna"),
        ("h.glb", "a model, not a package; rna-make"),
        ("s.yaml", "a scene, not a package; rna-run"),
        ("broken.rna", "error"),
    ],
)
def test_another_file_is_one_line(tmp_path, capsys, name, message):
    for made in ("h.glb", "s.yaml", "broken.rna"):
        (tmp_path / made).write_bytes(b"PK")
    assert main([str(tmp_path / name)]) == 1
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and message in said.err
