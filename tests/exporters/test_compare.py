"""The standard pictures of a comparison, and its page."""

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_export.asset_flip import ImageFlip
from rna_export.capture.orientation import joined_axes, rotation
from rna_export.compare.comparison_page import error_of, write_page
from rna_export.compare.comparison_run import Pair, Rendered, Timed, compare, judged
from rna_export.compare.origin import Origin
from rna_export.compare.views import Shot, shots
from rna_export.metrics import NoiselessPsnr, psnr
from rna_sdk.commands.error_words import error_text
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh, Provenance
from rna_sdk.package.packing import Unpacked
from rna_sdk.runtime import Asset, load

TOY = Path(__file__).parents[2] / "examples" / "quickstart" / "toy.rna"
SHA = "ab" * 32
CORNERS = np.float32([[-1, 0, -2], [1, 3, 2], [0, 1, 0], [-1, 3, 2]])
MESH = Mesh(CORNERS, np.float32([[0, 1, 0]] * 4), None, np.uint32([[0, 1, 2], [0, 2, 3]]))
STRANDS = Curves(CORNERS, np.full(4, 0.02, np.float32), np.uint32([0, 2, 4]))


def test_three_cameras_by_three_suns_and_a_white_world():
    pictures = shots([MESH], 32)
    assert len(pictures) == 12
    assert len({tuple(shot.eye) for shot in pictures}) == 3
    assert [shot.is_white for shot in pictures] == 3 * [False, False, False, True]
    suns = [shot.light for shot in pictures if not shot.is_white]
    assert np.allclose(np.linalg.norm(suns, axis=1), 1.0, atol=1e-6)
    assert pictures[3].name == "front, white world"
    assert pictures[3].scene(TOY, 1).lights[0].type == "environment"


def test_every_full_view_holds_the_whole_asset():
    for shot in shots([MESH], 32)[:8]:
        local = np.c_[CORNERS, np.ones(4)] @ np.linalg.inv(shot.view.to_world).T
        extent = np.abs(local[:, :2]) / -local[:, 2:3]
        assert extent.max() < np.tan(np.radians(15.0))


def test_fibers_are_also_seen_so_near_that_a_strand_fills_a_sixteenth():
    pictures = shots([STRANDS], 32)
    assert len(pictures) == 16
    distance = np.linalg.norm(pictures[-1].eye - pictures[-1].target)
    width = 2.0 * distance * np.tan(np.radians(15.0))
    assert width == pytest.approx(2.0 * 16.0 * 0.02, rel=0.1)


def test_parts_are_seen_together():
    both = shots([MESH, STRANDS], 32)
    assert {shot.camera_name for shot in both} == {"front", "behind", "close-up"}
    points = np.concatenate([MESH.positions, STRANDS.points])
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    assert np.allclose(both[0].target, centre)


@pytest.mark.parametrize("frame", [("-Z", "Y"), ("-Y", "Z"), ("X", "-Z")])
def test_front_and_up_turn_the_camera_and_keep_it_upright(frame):
    turn = rotation(*frame)
    turned = Mesh(CORNERS @ turn.T.astype(np.float32), MESH.normals, None, MESH.triangles)
    for usual, shot in zip(shots([MESH], 32), shots([turned], 32, frame), strict=True):
        expected = np.eye(4)
        expected[:3, :3] = turn
        np.testing.assert_allclose(shot.view.to_world, expected @ usual.view.to_world, atol=1e-6)
        if not shot.is_white:
            np.testing.assert_allclose(shot.light, turn @ usual.light, atol=1e-12)


def test_front_and_up_along_one_axis_are_refused():
    with pytest.raises(CaptureError, match="front Y and up -Y are along one axis"):
        rotation("Y", "-Y")


def test_an_axis_may_follow_its_option():
    given = ["a", "--front", "-Z", "--up=X", "--up", "-Y", "-Z"]
    assert joined_axes(given) == ["a", "--front=-Z", "--up=X", "--up=-Y", "-Z"]


def test_the_page_holds_every_picture_and_its_numbers(tmp_path):
    pairs = [_pair(shot, k) for k, shot in enumerate(shots([MESH], 16)[:2])]
    write_page(tmp_path, "a <b>", pairs[:1], {"samples": 4})  # stopped here, a page is there
    assert "found here, 1 image<" in (tmp_path / "index.html").read_text()
    write_page(tmp_path, "a <b>", pairs, {"samples": 4})
    results = json.loads((tmp_path / "results.json").read_text())
    assert results["flip"] == pytest.approx(np.mean([p.flip.mean for p in pairs]))
    assert results["psnr"] == pytest.approx(np.mean([p.psnr for p in pairs]))
    assert results["psnr_without_noise"]["low"] == pytest.approx(29.5)
    assert [p["psnr_without_noise"]["low"] for p in results["pictures"]] == [29.0, 30.0]
    assert [p["name"] for p in results["pictures"]] == [p.shot.name for p in pairs]
    page = (tmp_path / "index.html").read_text()
    assert "a &lt;b&gt;" in page and "samples a pixel of ours" in page
    for name in ("0-ours.png", "1-cycles.png", "1-difference.png", "0-flip.png"):
        assert name in page
        assert (tmp_path / name).is_file()


def test_the_light_of_a_white_world_is_on_the_page_and_no_part_of_the_error(tmp_path):
    sun, *_, white = (_pair(shot, k) for k, shot in enumerate(shots([MESH], 16)[:4]))
    white = replace(white, ours=white.cycles / 3.0)
    write_page(tmp_path, "a third", [sun, white], {})
    results = json.loads((tmp_path / "results.json").read_text())
    assert results["albedo"] == pytest.approx(1 / 3)
    assert [p["albedo"] for p in results["pictures"]] == [None, pytest.approx(1 / 3)]
    assert results["flip"] == pytest.approx(sun.flip.mean)
    assert results["psnr"] == pytest.approx(sun.psnr)
    assert "reflects 33% of the light" in (tmp_path / "index.html").read_text()
    assert white.error == "reflects 33% of the light that Cycles' asset does"


def test_one_bright_picture_does_not_rule_the_exposures_of_the_others():
    suns = [shot for shot in shots([MESH], 8) if not shot.is_white]
    rendered = [_rendered(shot, 0.1) for shot in suns]
    before = judged(rendered[:8])
    close_up = _rendered(suns[8], 50.0)
    after = judged([*rendered[:8], close_up], before)
    assert [pair.exposure for pair in after[:8]] == [pair.exposure for pair in before]
    assert after[8].exposure == pytest.approx(before[0].exposure / 500.0)
    dark = _rendered(suns[8], 0.001)
    assert [pair.is_lit for pair in judged([*rendered[:8], dark], before)] == [True] * 8 + [False]


def _rendered(shot: Shot, radiance: float) -> Rendered:
    """A grey picture, ours a little brighter."""
    cycles = np.full((2, 8, 8, 4), [radiance, radiance, radiance, 1.0], np.float32)
    return Rendered(shot, Timed(1.2 * cycles[0], 0.0), Timed(cycles, 0.0))


def test_an_error_in_words_is_without_the_noise_of_cycles():
    pair = _pair(shots([MESH], 16)[0], 0)
    assert pair.error == f"FLIP {pair.flip.mean:.3f}, PSNR 30.0 dB"
    bound = replace(pair, psnr_without_noise=NoiselessPsnr(28.0, 28.0, None))
    assert bound.error.endswith("PSNR at least 28.0 dB")


def test_the_page_says_what_was_compared_with_recorded_and_found_figures(tmp_path):
    package, source = _package(tmp_path), tmp_path / "ball.gltf"
    source.write_bytes(b"another ball")
    origin = Origin.of(package, None)
    doubt = origin.doubt(source)
    assert doubt is not None and "found SHA-256" in doubt and f"expected {SHA[:12]}" in doubt
    (pair,) = [_pair(shot, 0) for shot in shots([MESH], 16)[:1]]
    write_page(tmp_path / "out", "ball", [pair], {}, (package, source, origin, doubt))
    page = (tmp_path / "out" / "index.html").read_text()
    assert "is not the file that the package was captured from" in page
    assert "1,234 steps, 56 light directions" in page and "ball.py" in page
    assert f"<td>{error_of([pair])}</td>" in page
    assert f"{error_text(0.07, 0.2)}, 8 images of other views" in page and "39.50 dB" in page


def test_the_source_is_known_by_its_hash(tmp_path):
    source = tmp_path / "ball.py"
    source.write_bytes(b"a ball")
    sha = hashlib.sha256(b"a ball").hexdigest()
    in_text = {"source": f"ball.py (sha256 {sha})", "capture": {}}
    for recorded in ({"capture": {"sourceSha256": sha}}, in_text):
        assert Origin.of(_package(tmp_path, **recorded), None).doubt(source) is None
    unknown = Origin.of(_package(tmp_path, source="a friend's ball", capture={}), None)
    assert "does not record" in str(unknown.doubt(source))


def test_images_are_announced_and_handed_over_one_by_one():
    messages: list[str] = []
    actual: list[int] = []
    worker = _Cycles()
    with pytest.raises(KeyboardInterrupt):
        compare(
            toy(),
            TOY,
            worker,  # type: ignore[arg-type]
            samples=1,
            cycles_samples=2,
            resolution=8,
            frame=("Z", "Y"),
            begin=lambda k, n, shot: messages.append(f"{k} of {n}: {shot.name}"),
            done=lambda pairs: actual.append(len(pairs)),
        )
    assert messages[0] == "1 of 12: front, key light" and len(messages) == 3
    assert actual == [1, 2]  # before Ctrl-C in the third


class _Cycles:
    """Renders grey; at its fifth image, half of the third, somebody presses Ctrl-C."""

    def __init__(self) -> None:
        self.renders = 0

    def render_view(self, *_: object) -> np.ndarray:
        self.renders += 1
        if self.renders == 5:
            raise KeyboardInterrupt
        return np.full((8, 8, 4), [0.01, 0.01, 0.01, 1.0], np.float32)


def toy() -> Asset:
    return load(TOY, threads=1)


def _package(folder: Path, **provenance: object) -> Path:
    """The quickstart's package with another provenance."""
    capture = {"sourceSha256": SHA, "lights": 56}
    training = {"small": {"steps": 1234}, "hq": {"steps": 1}}
    whole = {"source": "ball.py", "tool": "t", "capture": capture, "training": training}
    unpacked = Unpacked.read(TOY)
    tier, *others = unpacked.manifest.tiers
    assert tier.validation is not None
    errors = {"psnr": 39.5, "flip": 0.07, "flip_p95": 0.2, "images": 8}
    recorded = tier.validation.model_copy(update=errors)
    manifest = unpacked.manifest.model_copy(
        update={
            "provenance": Provenance(**{**whole, **provenance}),
            "tiers": (tier.model_copy(update={"validation": recorded}), *others),
        }
    )
    path = folder / "ball.rna"
    replace(unpacked, manifest=manifest).write(path)
    return path


def _pair(shot: Shot, seed: int) -> Pair:
    rng = np.random.default_rng(seed)
    ours, cycles = rng.random((2, 16, 16, 3), dtype=np.float32) * 0.3
    error = ImageFlip.of(ours, np.stack([cycles] * 2), np.ones((16, 16)), 1.0)
    clean = NoiselessPsnr(30.0, 29.0 + seed, 31.0)
    return Pair(shot, ours, cycles, error, psnr(ours, cycles), clean, 0.0, 0.5, 1.0)
