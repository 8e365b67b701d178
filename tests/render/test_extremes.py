"""The largest numbers that a scene may have give finite images, and say nothing on the way."""

from pathlib import Path

import numpy as np
import pytest

from rna_render.command.rna_run import main
from rna_render.image.images import read_exr

WALL = "v -2 0 -1\nv 2 0 -1\nv 2 2 -1\nv -2 2 -1\nf 1 2 3 4\n"
SCENE = """\
objects:
  - {path: wall.obj, material: {type: diffuse}}
ground: {size: 1.0e+18, material: {type: coated}}
camera: {position: [0, 1, 3], look_at: [0, 0, 0], vertical_fov_deg: 90}
lights:
  - {type: directional, direction: [0, 1.0e+18, 0], irradiance: [LIGHT, 1, 1]}
  - {type: point, position: [0, 1.0e-3, 0], intensity: [LIGHT, 1, 1]}
  - {type: spot, position: [1, 1, 0], look_at: [0, 0, 0], intensity: [LIGHT, 1, 1]}
  - {type: rectangle, position: [0, 2, 0], look_at: [0, 0, 0], up: [0, 0, 1], size: [1, 1],
     radiance: [LIGHT, 1, 1]}
  - {type: disk, position: [0, 2, 1], look_at: [0, 0, 0], radius: 1, radiance: [LIGHT, 1, 1]}
  - {type: sphere, position: [2, 2, 1], radius: 1, radiance: [LIGHT, 1, 1]}
  - {type: environment, radiance: [LIGHT, 1, 1]}
resolution: [12, 8]
samples: 4
clamp_indirect: 1.0e+18
"""


def render(folder: Path, text: str) -> int:
    (folder / "wall.obj").write_text(WALL)
    (folder / "scene.yaml").write_text(text)
    return main([str(folder / "scene.yaml"), "--out", str(folder / "out.exr")])


def test_the_brightest_lights_give_a_finite_image(tmp_path):
    assert render(tmp_path, SCENE.replace("LIGHT", "1.0e+18")) == 0
    channels, _ = read_exr(tmp_path / "out.exr")
    for name, values in channels.items():
        assert np.isfinite(values.astype(np.float64)).all(), name
    assert channels["R"].max() > 1e17


def test_a_light_beyond_float32_is_one_line(tmp_path, capsys):
    assert render(tmp_path, SCENE.replace("LIGHT", "1.0e+39", 1).replace("LIGHT", "1")) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "scene.yaml:6: lights[0].irradiance[0]: expected a number, at most 1e+18" in line
    assert not (tmp_path / "out.exr").exists()


@pytest.mark.parametrize(
    ("size", "scale", "message"),
    [
        (1e14, 1.0, "its size is 1e+14 m; expected 1e-06 to 1e+06"),
        (1e-15, 1.0, "its size is 1e-15 m"),
        (1e-7, 1.0, "its size is 1e-07 m"),
        (1e5, 1e5, "its size as placed is 1e+10 m"),
        (1e-5, 1e-5, "its size as placed is 1e-10 m"),
        (1.0, 1e7, "transform.scale: expected a number, at most 1e+06"),
        (1.0, 1e-7, "transform.scale: must be at least 1e-06, or at most -1e-06"),
        (0.99e6, 1.0, None),
        (1.01e-6, 1.0, None),
        (0.99, 1e6, None),
        (1.01, 1e-6, None),
        (0.99e6, 1e-6, None),
        (1.01e-6, 1e6, None),
    ],
)
def test_geometry_is_seen_or_refused(
    tmp_path,
    capsys,
    size,
    scale,
    message,
):
    """A grey square fills the image, lit from all sides or from nearby, or is an error."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    lines = [f"v {size / 2 * x:e} {size / 2 * y:e} 0" for x, y in corners]
    (tmp_path / "square.obj").write_text("\n".join([*lines, "f 1 2 3 4", ""]))
    away = min(max(size * scale / 2, 1e-13), 1e18)
    text = f"""
objects:
  - path: square.obj
    material: {{type: diffuse, color: [0.5, 0.5, 0.5]}}
    transform: {{scale: {scale:e}}}
camera: {{position: [0, 0, {away:e}], look_at: [0, 0, 0], vertical_fov_deg: 60}}
lights: [{{type: environment}}]
resolution: [8, 8]
samples: 4
"""
    assert render(tmp_path, text) == (message is not None)
    if message is not None:
        assert message in capsys.readouterr().err
        return
    np.testing.assert_allclose(read_exr(tmp_path / "out.exr")[0]["R"], 0.5, rtol=0.2)  # else 1
    near = f"type: point, position: [0, 0, {away:e}], intensity: {3 * [away**2]}"
    assert render(tmp_path, text.replace("type: environment", near)) == 0
    centre = read_exr(tmp_path / "out.exr")[0]["R"][3:5, 3:5]
    np.testing.assert_allclose(centre, 0.5 / np.pi, rtol=0.1)
