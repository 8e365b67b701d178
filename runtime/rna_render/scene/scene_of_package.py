"""The scene that a package is shown in when there is no scene file: a camera, a ground and light.

`rna-run` renders these values, and `rna-make` writes them beside a package as a scene file.
"""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.scene.core_yaml import dump_yaml
from rna_render.scene.glb_scene import (
    as_transforms,
    box_corners,
    is_glb_scene,
    read_glb_scene,
)
from rna_render.scene.gltf_container import open_gltf
from rna_sdk.errors import SceneError
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package import Cone, Curves, Package

_NOTES = {
    "- type: directional": "the key light; the next one shines from behind, for the outline",
    "  angular_diameter_deg: 6.0": "soft shadows; 0.53 for the sun",
    "- type: environment": "an even sky; path: NAME.hdr for an image",
    "animation:": "for rna-run --frames all",
}
_GREY = {"type": "diffuse", "color": [0.4, 0.4, 0.4]}
_WIDTH, _HEIGHT, _SAMPLES, _FOV_DEG = 800, 600, 32, 30.0
_MARGIN = 1.2  # of the image around the asset
_GAP = 1e-3  # from the asset down to the ground, of its size: a flat base has no plane with it

_EYE = (0.54, 0.36, 0.77)  # from the front, right and above
_KEY = (-0.4, 0.75, 0.55), (2.5, 2.4, 2.25), 6.0
_RIM = (0.45, 0.55, -0.7), (0.9, 0.95, 1.05), 10.0  # for the outline and what shines through
_LIGHTS = (_KEY, _RIM)
"""Direction, irradiance and angular diameter, degrees: of soft shadows; the sun has 0.53."""
_SKY = (0.28, 0.29, 0.31)
_BESIDE_EMISSION = 0.15  # of this light, where the asset has light of its own


@dataclass(frozen=True)
class Shown:
    """Facts that the scene depends on.

    low, high: (3,) corners of the asset's box, metres. points: (n, 3), the image shows them all.
    emits: whether it has light of its own. wo, wi: cones of the directions that it was captured
    for; none for all. glass: its smooth glass at each place, as objects of a scene.
    """

    low: np.ndarray
    high: np.ndarray
    points: np.ndarray
    emits: bool = False
    wo: tuple[Cone, ...] = ()
    wi: tuple[Cone, ...] = ()
    glass: tuple[dict[str, Any], ...] = ()

    @property
    def size(self) -> float:
        """Length of the box's diagonal, metres."""
        return float(np.linalg.norm(self.high - self.low))


def shown(package: Path) -> Shown:
    """Facts that a package's scene depends on, of a .glb with all its nodes.

    Raises PackageError for a broken package, SceneError for broken nodes or glass.
    """
    with Package.open(package) as opened:
        manifest = opened.manifest
        low, high = (corner.astype(np.float64) for corner in opened.box())
        parts = [opened.geometry(part) for part in range(len(manifest.parts))]
        points = np.concatenate(
            [part.points if isinstance(part, Curves) else part.positions for part in parts]
        )
        emits = any(part.emission for part in manifest.tiers[0].parts)
        wo, wi = (
            () if isinstance(region, str) else region
            for region in (manifest.domain.wo, manifest.domain.wi)
        )
    glass = glass_of(package)
    panes: list[dict[str, Any]] = [{"path": glass.name}] if glass.is_file() else []
    if panes:
        corners = _box_corners(glass)
        points = np.concatenate([points, corners])
        low, high = np.minimum(low, corners.min(axis=0)), np.maximum(high, corners.max(axis=0))
    if is_glb_scene(package):
        places, beside = read_glb_scene(package)
        if len(beside) or not np.array_equal(places, np.eye(4)[None]):
            corners = box_corners(low, high)
            moved = corners @ places[:, :3, :3].swapaxes(1, 2) + places[:, None, :3, 3]
            points = np.concatenate([moved.reshape(-1, 3), beside])
            low, high = points.min(axis=0), points.max(axis=0)
            transforms = [t.model_dump(exclude_unset=True) for t in as_transforms(places, package)]
            panes = [{**pane, "transform": t} for pane in panes for t in transforms]
    return Shown(low, high, points, emits, wo, wi, tuple(panes))


def _box_corners(glb: Path) -> np.ndarray:
    """(8, 3) corners about the positions of a .glb without transforms, as its accessors say.

    Raises SceneError for a file that is none.
    """
    try:
        accessors = open_gltf(glb).json["accessors"]
        ranges = [(a["min"], a["max"]) for a in accessors if "min" in a]
        low, high = np.min([a for a, _ in ranges], axis=0), np.max([b for _, b in ranges], axis=0)
        return box_corners(low, high)
    except (OSError, ValueError, LookupError, TypeError) as error:
        raise SceneError("it cannot be read as .glb", file=glb) from error


def default_scene(package: Path) -> dict[str, Any]:
    """Keys and values of the scene that shows a package, named relative to its folder.

    The asset stands on a ground and fills the image. Directions lie within those that it was
    captured for. The glass beside the package is part of the scene. Raises PackageError for a
    broken package, SceneError for glass that cannot be read.
    """
    return scene_values(shown(package), package.name)


def scene_values(of: Shown, name: str) -> dict[str, Any]:
    """Keys and values of the scene for a package of this name."""
    places = max(0, 4 - math.floor(math.log10(of.size)))  # less than a thousandth of the size
    middle, towards_eye = (of.low + of.high) / 2, _within(_EYE, of.wo)
    scene: dict[str, Any] = {"assets": [{"path": name}]}
    if of.glass:
        scene["objects"] = list(of.glass)
    if towards_eye[1] > 0.0:  # the eye is above the ground
        (height,) = _rounded(np.array([of.low[1] - _GAP * of.size]), places)
        scene["ground"] = {"height": height, "material": _GREY}
    scene["camera"] = {
        "position": _rounded(middle + towards_eye * _distance(of, towards_eye), places),
        "look_at": _rounded(middle, places),
        "up": [0.0, 1.0, 0.0] if _is_level(towards_eye) else [0.0, 0.0, -1.0],
        "vertical_fov_deg": _FOV_DEG,
    }
    dimmed = _BESIDE_EMISSION if of.emits else 1.0
    scene["lights"] = [
        {
            "type": "directional",
            "direction": _rounded(_within(direction, of.wi)),
            "irradiance": _rounded(np.multiply(irradiance, dimmed)),
            "angular_diameter_deg": diameter,
        }
        for direction, irradiance, diameter in _LIGHTS
    ]
    if not of.wi:
        radiance = _rounded(np.multiply(_SKY, dimmed))
        scene["lights"].append({"type": "environment", "radiance": radiance})
    turn = {"frames": 48, "turntable": {}}
    return scene | {"resolution": [_WIDTH, _HEIGHT], "samples": _SAMPLES, "animation": turn}


def scene_text(scene: dict[str, Any]) -> str:
    """The text of a scene file with the values of `scene_values`, and notes for its reader."""
    text = dump_yaml(scene)
    for line, note in _NOTES.items():
        text = text.replace(line, f"{line}  # {note}", 1)
    return f"# A first scene. docs/scene.md lists all keys.\n{text}"


def _is_level(towards_eye: np.ndarray) -> bool:
    """Whether +y can be up in the image."""
    return bool(abs(towards_eye[1]) < 0.99)


def _distance(of: Shown, towards_eye: np.ndarray) -> float:
    """From the middle of the box to an eye that sees all points."""
    side = np.cross((0.0, 1.0, 0.0) if _is_level(towards_eye) else (0.0, 0.0, -1.0), towards_eye)
    side /= np.linalg.norm(side)
    up = np.cross(towards_eye, side)
    x, y, z = np.stack([side, up, towards_eye]) @ (of.points - (of.low + of.high) / 2).T
    half = np.tan(np.radians(_FOV_DEG) / 2) / _MARGIN
    beside = np.maximum(np.abs(x) / (half * _WIDTH / _HEIGHT), np.abs(y) / half)
    return float((beside + z).max())


def _within(direction: tuple[float, float, float], cones: tuple[Cone, ...]) -> np.ndarray:
    """(3,) unit: the direction, or the axis of the nearest cone that it is outside of."""
    unit: np.ndarray = np.array(direction) / np.linalg.norm(direction)
    if not cones:
        return unit
    outside = [np.arccos(np.clip(np.dot(c.axis, unit), -1, 1)) - c.half_angle for c in cones]
    nearest = int(np.argmin(outside))
    if outside[nearest] > 0.0:
        unit = np.array(cones[nearest].axis)
    return unit


def _rounded(values: np.ndarray, digits: int = 3) -> list[float]:
    return [round(value, digits) + 0.0 for value in values.tolist()]
