"""The scene that a package is shown in when there is no scene file: a camera, a ground and light.

It is written as the text of a scene file, which `rna-make` puts beside a package and `rna-run`
renders, so that both show the same.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_sdk.errors import SceneError
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package import Cone, Curves, Package

_TEXT = """\
# A first scene. Change what you like: docs/scene.md lists all keys.
assets:
  - path: {path}
{glass}{ground}camera:
  position: {eye}
  look_at: {middle}
{up}  vertical_fov_deg: {fov:g}
lights:
  - type: directional          # the key light
    direction: {key}
    irradiance: {key_light}
    angular_diameter_deg: 6    # soft shadows; 0.53 for the sun
  - type: directional          # from behind, for the outline and what shines through
    direction: {rim}
    irradiance: {rim_light}
    angular_diameter_deg: 10
{sky}resolution: [{width}, {height}]
samples: {samples}
animation:                     # for rna-run --frames all
  frames: 48
  turntable: {{}}
"""
_GLASS = """\
objects:
  - path: {path}               # the asset's smooth glass, an ordinary mesh
"""
_SKY_LIGHT = """\
  - type: environment          # an even sky; path: NAME.hdr for an image
    radiance: {radiance}
"""
_GROUND = """\
ground:
  height: {height}
  material: {{type: diffuse, color: [0.4, 0.4, 0.4]}}
"""

_UP = """\
  up: [0, 0, -1]
"""
_WIDTH, _HEIGHT, _SAMPLES, _FOV_DEG = 800, 600, 32, 30.0
_MARGIN = 1.2  # of the image around the asset
_GAP = 1e-3  # from the asset down to the ground, of its size: a flat base has no plane with it

_EYE = (0.54, 0.36, 0.77)  # from the front, right and above
_KEY, _KEY_LIGHT = (-0.4, 0.75, 0.55), (2.5, 2.4, 2.25)
_RIM, _RIM_LIGHT = (0.45, 0.55, -0.7), (0.9, 0.95, 1.05)
_SKY = (0.28, 0.29, 0.31)
_BESIDE_EMISSION = 0.15  # of this light, where the asset has light of its own


@dataclass(frozen=True)
class Shown:
    """Facts that the scene depends on.

    low, high: (3,) corners of the asset's box, metres. points: (n, 3), the image shows them all.
    emits: whether it has light of its own. wo, wi: cones of the directions that it was captured
    for; none for all. glass: name of the file with its smooth glass; None for none.
    """

    low: np.ndarray
    high: np.ndarray
    points: np.ndarray
    emits: bool = False
    wo: tuple[Cone, ...] = ()
    wi: tuple[Cone, ...] = ()
    glass: str | None = None

    @property
    def size(self) -> float:
        """Length of the box's diagonal, metres."""
        return float(np.linalg.norm(self.high - self.low))


def shown(package: Path) -> Shown:
    """Facts that a package's scene depends on. Raises PackageError for a broken package."""
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
    if not glass.is_file():
        return Shown(low, high, points, emits, wo, wi)
    corners = _box_corners(glass)
    points = np.concatenate([points, corners])
    low, high = np.minimum(low, corners.min(axis=0)), np.maximum(high, corners.max(axis=0))
    return Shown(low, high, points, emits, wo, wi, glass.name)


def _box_corners(glb: Path) -> np.ndarray:
    """(8, 3) corners about the positions of a .glb without transforms, as its accessors say.

    Raises SceneError for a file that is none.
    """
    try:
        data = glb.read_bytes()
        size = int.from_bytes(data[12:16], "little")
        accessors = json.loads(data[20 : 20 + size])["accessors"]
        ranges = [(a["min"], a["max"]) for a in accessors if "min" in a]
        low, high = np.min([a for a, _ in ranges], axis=0), np.max([b for _, b in ranges], axis=0)
        return np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, 8).T
    except (OSError, ValueError, LookupError, TypeError) as error:
        raise SceneError("it cannot be read as .glb", file=glb) from error


def default_scene(package: Path) -> str:
    """YAML of the scene that shows a package; it names the package relative to its folder.

    The asset stands on a ground and fills the image. Directions lie within those that it was
    captured for. The glass beside the package is part of the scene. Raises PackageError for a
    broken package, SceneError for glass that cannot be read.
    """
    return scene_text(shown(package), package.name)


def scene_text(of: Shown, name: str) -> str:
    """YAML of the scene for a package of this name."""
    middle = (of.low + of.high) / 2
    towards_eye = _within(_EYE, of.wo)
    eye = middle + towards_eye * _distance(of, towards_eye)
    dimmed = _BESIDE_EMISSION if of.emits else 1.0
    return _TEXT.format(
        path=json.dumps(name, ensure_ascii=False),
        glass="" if of.glass is None else _GLASS.format(path=json.dumps(of.glass)),
        ground=_ground(of, towards_eye),
        eye=_places(eye, of.size),
        middle=_places(middle, of.size),
        up="" if _is_level(towards_eye) else _UP,
        fov=_FOV_DEG,
        key=_numbers(_within(_KEY, of.wi)),
        key_light=_numbers(np.multiply(_KEY_LIGHT, dimmed)),
        rim=_numbers(_within(_RIM, of.wi)),
        rim_light=_numbers(np.multiply(_RIM_LIGHT, dimmed)),
        sky="" if of.wi else _SKY_LIGHT.format(radiance=_numbers(np.multiply(_SKY, dimmed))),
        width=_WIDTH,
        height=_HEIGHT,
        samples=_SAMPLES,
    )


def _ground(of: Shown, towards_eye: np.ndarray) -> str:
    """None where the eye is below it."""
    if towards_eye[1] <= 0.0:
        return ""
    height = of.low[1] - _GAP * of.size
    return _GROUND.format(height=_place(height, of.size))


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


def _numbers(values: np.ndarray) -> str:
    """Directions and light."""
    return f"[{', '.join(_rounded(value, 3) for value in values)}]"


def _places(values: np.ndarray, size: float) -> str:
    return f"[{', '.join(_place(value, size) for value in values)}]"


def _place(value: float, size: float) -> str:
    """Rounded to less than a thousandth of the asset's size."""
    return _rounded(value, max(0, 4 - math.floor(math.log10(size))))


def _rounded(value: float, digits: int) -> str:
    """Without an exponent, which YAML takes for text where it has no point."""
    return np.format_float_positional(value + 0.0, precision=digits, trim="-")
