"""Pictures of the C host: whole assets, light through glass, and errors that are named."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_sdk.package import Mesh, Tier, TierData, TierEmission, TransmittanceRecord, write_package
from tests.hosts.c_host import compiler
from tests.hosts.test_c_host import CURLS, TOY, run
from tests.package.builders import make_manifest, make_part, make_planes, make_tier_part
from tests.render.packages import constant_decoder

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

TAU = np.float64([200, 100, 0]) / 255
PANE = {"visible": (0.3, 0.2, 0.1), "shadowed": (0.0, 0.0, 0.0), "emission": (0.0, 0.1, 0.05)}
WALL = {"visible": (0.5, 0.4, 0.2), "shadowed": (0.1, 0.2, 0.3), "emission": (0.2, 0.1, 0.4)}


@pytest.fixture
def render(programs):
    return programs["render"]


def picture(render: Path, package: Path, out: Path, *options: object) -> np.ndarray:
    """(27, 48, 3) uint8."""
    result = run(render, package, out, "--size", 48, 27, "--samples", 1, *options)
    assert result.returncode == 0, result.stderr
    data = out.read_bytes()
    assert data.startswith(b"P6\n48 27\n255\n")
    return np.frombuffer(data[-48 * 27 * 3 :], np.uint8).reshape(27, 48, 3)


@pytest.mark.parametrize("package", [TOY, CURLS], ids=["toy", "curls"])
def test_default_camera_shows_the_asset(package, render, tmp_path):
    pixels = picture(render, package, tmp_path / "picture.ppm")
    assert pixels[0, 0].max() == 0 and pixels[10:17, 18:30].mean() > 15


def write_pane_before_wall(path: Path) -> Path:
    """A tinted pane at z = 0.5, and behind it a wall at z = -0.5; both glow."""
    emission = TierEmission(
        decoder="decoders/glow.onnx", inputs=("wo",), decoder_precision="float32"
    )
    tier_parts, data, meshes = [], [], []
    for name, colours, z in (("pane", PANE, 0.5), ("wall", WALL, -0.5)):
        glow_record: Any = emission.model_copy(update={"decoder": f"decoders/{name}-glow.onnx"})
        part = make_tier_part(name, inputs=("wo", "wi"), emission=glow_record)
        tier_parts.append(part)
        transport = constant_decoder(6, [*colours["visible"], *colours["shadowed"]])
        glow = constant_decoder(3, colours["emission"], "emission")
        data.append(TierData(make_planes(), transport, {"emission": glow}))
        corners = np.float32([[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]])
        normals = np.float32([[0, 0, 1]] * 4)
        meshes.append(Mesh(corners, normals, None, np.uint32([[0, 1, 2], [0, 2, 3]])))
    record = TransmittanceRecord(triangles=(0, 2), texture="transmittance/tint.safetensors")
    parts = (
        make_part(name="pane", geometry="geometry/pane.glb", transmittance=(record,)),
        make_part(name="wall", geometry="geometry/wall.glb"),
    )
    tier = Tier(name="small", parts=tuple(tier_parts))
    texture = {record.texture: np.round(TAU * 255).astype(np.uint8).reshape(1, 1, 3)}
    write_package(path, make_manifest(tier, parts=parts), meshes, {"small": data}, texture)
    return path


@pytest.mark.parametrize(("irradiance", "glow"), [(0, 1), (1, 0), (0.8, 0.5)])
def test_light_through_a_pane(irradiance, glow, render, tmp_path):
    """(1 - tau) of the pane, and tau of the wall, which the sun reaches through the pane alone."""
    package = write_pane_before_wall(tmp_path / "pane.rna")
    view = "--camera", 0, 0, 6, 0, 0, 0, 8, "--sun", 0, 0, 1, *[irradiance] * 3, "--glow", glow
    pixels = picture(render, package, tmp_path / "picture.ppm", *view)
    pane, wall = ({key: np.float64(value) for key, value in c.items()} for c in (PANE, WALL))
    on_wall = TAU * wall["visible"] + (1 - TAU) * wall["shadowed"]
    linear = (1 - TAU) * (irradiance * pane["visible"] + glow * pane["emission"])
    linear += TAU * (irradiance * on_wall + glow * wall["emission"])
    srgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    assert np.abs(pixels[8:19, 16:32] - 255 * srgb).max() <= 0.6


def test_an_edge_of_two_triangles_tints_once(programs, tmp_path):
    """The middle of the wall sees the sun through the diagonal of the pane."""
    package = write_pane_before_wall(tmp_path / "pane.rna")
    hit = np.zeros(8, "<f4")
    hit[2], hit[5] = 0.5, 1  # b_2: between the first corner and the third; wi is +z
    hit.view("<u4")[7] = 1  # the part
    hit.tofile(tmp_path / "hits")
    result = run(programs["conform"], "visibility", package, tmp_path / "hits", tmp_path / "seen")
    assert result.returncode == 0, result.stderr
    np.testing.assert_allclose(np.fromfile(tmp_path / "seen", "<f4"), TAU, atol=1e-6)


def test_errors_are_named(render, tmp_path):
    broken = tmp_path / "broken.rna"
    broken.write_bytes(TOY.read_bytes()[:-1])
    result = run(render, broken, tmp_path / "picture.ppm")
    assert result.returncode == 1 and "ZIP_TRUNCATED" in result.stderr
    result = run(render, TOY, tmp_path / "picture.ppm", "--tier", "none")
    assert result.returncode == 1 and "no such tier" in result.stderr
    result = run(render, TOY, tmp_path / "picture.ppm", "--size", 0, 0)
    assert result.returncode == 2 and "usage" in result.stderr
