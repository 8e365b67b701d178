"""A block on a floor in the sun, at any size and anywhere, with whatever lies far away."""

from pathlib import Path
from typing import Any

import numpy as np

from rna_render.scene.core_yaml import dump_yaml
from rna_render.scene.scene_file import SceneFile, read_scene

GREY = {"type": "diffuse", "color": [0.5, 0.5, 0.5]}

# What must not change the picture: arguments of `scene`.
VARIANTS: dict[str, dict[str, Any]] = {
    "a millimetre": {"size": 1e-3},
    "ten kilometres": {"size": 1e4},
    "far from the origin": {"at": (1e5, 0.0, 1e5)},
    "high up": {"at": (0.0, 1e4, 0.0)},
    "a hill at 1 km": {"hill": 1e3},
    "a hill at 100 km": {"hill": 1e5},
    "a floor of 40 km": {"floor": 4e4},
    "a floor of 40 km far away": {"floor": 4e4, "at": (1e5, 3e3, 1e5)},
}


def scene(
    folder: Path,
    size: float = 1.0,
    at: tuple[float, float, float] = (0.0, 0.0, 0.0),
    hill: float | None = None,
    floor: float | None = None,
    tilt: float = 0.0,
) -> SceneFile:
    """size: of the scene, metres. at: where it stands. hill: distance of one behind the camera,
    which sends no light. floor: side of a mesh in place of the ground, turned by `tilt` degrees
    about z, with all that stands on it.
    """
    place = np.array(at)
    turned = {"translation": list(at), "rotation_deg": [0, 0, tilt]}
    c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

    def there(*point: float) -> list[float]:
        return (place + size * (turn @ point)).tolist()

    _quad(folder / "block.obj", [(-0.3, 0, 0), (0.3, 0, 0), (0.3, 0.6, 0), (-0.3, 0.6, 0)])
    objects = [{"path": "block.obj", "material": GREY, "transform": {**turned, "scale": size}}]
    if floor is not None:
        h = floor / 2
        _quad(folder / "floor.obj", [(-h, 0, h), (h, 0, h), (h, 0, -h), (-h, 0, -h)])
        objects.append({"path": "floor.obj", "material": GREY, "transform": turned})
    if hill is not None:
        # Seen from the scene it is a line.
        _quad(folder / "hill.obj", [(0, 0, hill), (9, 0, hill), (9, 99, hill), (0, 99, hill)])
        objects.append({"path": "hill.obj", "material": GREY, "transform": turned})
    data = {
        "objects": objects,
        "camera": {
            "position": there(1.6, 0.9, 0.9),
            "look_at": there(0, 0.1, 0),
            "up": (turn @ [0, 1, 0]).tolist(),
            "vertical_fov_deg": 30,
        },
        "lights": [
            {
                "type": "directional",
                "direction": (turn @ [1, 2, 0.5]).tolist(),
                "irradiance": 3.0,
            },
            {"type": "point", "position": there(-1, 1.5, 0.5), "intensity": 2.0 * size**2},
        ],
        "resolution": [64, 40],
        "samples": 8,
    }
    if floor is None:
        data["ground"] = {"height": at[1], "material": GREY}
    (folder / "scene.yaml").write_text(dump_yaml(data))
    return read_scene(folder / "scene.yaml")


def assert_same_picture(actual: dict[str, np.ndarray], expected: dict[str, np.ndarray]) -> None:
    """At most .1% of the pixels differ by more than 2%, and one that rounding puts elsewhere."""
    pictures = (np.stack([image[name] for name in "RGB"], axis=-1) for image in (actual, expected))
    a, b = pictures
    off = np.abs(a - b).max(axis=-1) > 0.02 * np.maximum(b.max(axis=-1), 0.02)
    assert (b.max(axis=-1) < 0.6 * b.max()).sum() > 20, "the expected picture has no shadow"
    assert off.sum() <= 1 + off.size // 1000, f"{off.sum()} of {off.size} pixels"


def _quad(path: Path, corners: list[tuple[float, float, float]]) -> None:
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners]
    path.write_text("\n".join([*lines, "f 1 2 3", "f 1 3 4", ""]))
