"""Scenes about one asset of any size: a ground, an environment or a lamp, a coloured wall."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.scene import Scene
from rna_sdk.runtime import Asset

GREY = {"type": "diffuse", "color": (0.2, 0.2, 0.2)}
RED = {"type": "diffuse", "color": (0.65, 0.05, 0.04)}
FOV_Y_DEG = 30.0

_AZIMUTH, _ELEVATION = 35.0, 12.0  # of the camera, degrees; the horizon is in the picture
_LAMP_AZIMUTH, _LAMP_ELEVATION = 75.0, 45.0
_GOLDEN_DEG = 137.508
_WALL_AZIMUTH = 90.0  # where the wall faces to: past the asset, near enough to the camera


@dataclass(frozen=True)
class Stage:
    """An asset in the middle of objects whose sizes follow from its own.

    package: the .rna file. tier: of it. positions: (n, 3), points of the asset. turn_deg: where
    its front is, as for rna-compare. resolution: width, height. margin: half the picture's height
    at the asset's middle, in units of its radius.
    """

    package: Path
    tier: str | None
    positions: np.ndarray
    turn_deg: float
    resolution: tuple[int, int]
    margin: float = 1.35

    @classmethod
    def of(cls, asset: Asset, package: Path, tier: str | None, **view: Any) -> "Stage":
        points = [p.curves.points if p.kind == "fiber" else p.mesh.positions for p in asset.parts]
        return cls(package, tier, np.concatenate(points), **view)

    @property
    def low(self) -> np.ndarray:
        return self.positions.min(axis=0)

    @property
    def centre(self) -> np.ndarray:
        return (self.low + self.positions.max(axis=0)) / 2

    @property
    def radius(self) -> float:
        return float(np.linalg.norm(self.positions - self.centre, axis=1).max())

    @property
    def size(self) -> float:
        return float(np.ptp(self.positions, axis=0).max())

    @property
    def camera(self) -> dict[str, Any]:
        distance = self.margin * self.radius / np.sin(np.radians(FOV_Y_DEG) / 2)
        eye = self.centre + distance * self.direction(_AZIMUTH, _ELEVATION)
        position, look_at = tuple(eye.tolist()), tuple(self.centre.tolist())
        return {"position": position, "look_at": look_at, "vertical_fov_deg": FOV_Y_DEG}

    def direction(self, azimuth_deg: float, elevation_deg: float) -> np.ndarray:
        """Unit, from the asset; azimuth 0 is its front."""
        a, e = np.radians(azimuth_deg + self.turn_deg), np.radians(elevation_deg)
        return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])

    def row_of_assets(self, distance: float, count: int, first_turn: float) -> list[dict[str, Any]]:
        """Instances in a row across the picture, so far behind the middle, each turned otherwise.

        distance: in units of the asset's radius, as everything here.
        """
        away = -self.direction(_AZIMUTH, 0.0)
        across = np.cross(away, [0.0, 1.0, 0.0])
        places = [k - (count - 1) / 2 for k in range(count)]
        middles = [self.radius * (distance * away + 2.4 * x * across) for x in places]
        return [
            self._standing(middle, first_turn + _GOLDEN_DEG * k) for k, middle in enumerate(middles)
        ]

    def _standing(self, offset: np.ndarray, turn_deg: float) -> dict[str, Any]:
        """The asset, turned about the vertical through its middle, then moved."""
        c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
        x, _, z = self.centre
        moved = offset + np.array([x - c * x - s * z, 0.0, z + s * x - c * z])
        transform = {"translation": tuple(moved.tolist()), "rotation_deg": (0.0, turn_deg, 0.0)}
        return {"path": self.package, "tier": self.tier, "transform": transform}

    def scene(self, *lights: dict[str, Any], **settings: Any) -> Scene:
        """The asset, or the given `assets`, with the given lights and settings."""
        assets = settings.pop("assets", [{"path": self.package, "tier": self.tier}])
        fair: dict[str, Any] = {"resolution": self.resolution, "clamp_indirect": None}
        return Scene(assets=assets, camera=self.camera, lights=lights, **fair, **settings)

    @property
    def ground(self) -> dict[str, Any]:
        return {"height": float(self.low[1]), "size": 40 * self.radius, "material": GREY}

    @property
    def lamp(self) -> dict[str, Any]:
        """A square lamp above and beside the asset."""
        towards = self.direction(_LAMP_AZIMUTH, _LAMP_ELEVATION)
        return {
            "type": "rectangle",
            "position": tuple((self.centre + 3.0 * self.radius * towards).tolist()),
            "look_at": tuple(self.centre.tolist()),
            "size": (1.5 * self.radius, 1.5 * self.radius),
            "radiance": (5.0, 5.0, 5.0),
            "visible_to_camera": False,
        }

    def environment(self, path: Path) -> dict[str, Any]:
        return {"type": "environment", "path": path}

    def wall(self, folder: Path) -> dict[str, Any]:
        """A red wall that stands behind the asset and faces it, as an object; writes its mesh."""
        normal, radius = self.direction(_WALL_AZIMUTH, 0.0), self.radius
        across = np.cross([0.0, 1.0, 0.0], normal)
        gap = ((self.positions - self.centre) @ normal).min() - 0.08 * radius
        front = np.array([*self.centre]) + gap * normal
        front[1] = self.low[1]
        corners = [
            front
            - depth * 0.1 * radius * normal
            + side * 1.3 * radius * across
            + np.array([0.0, up, 0.0])
            for depth in (1.0, 0.0)
            for up in (0.0, 2.2 * radius)
            for side in (-1.0, 1.0)
        ]
        faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]
        lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners] + [f"f {f}" for f in faces]
        path = folder / "wall.obj"
        path.write_text("\n".join(lines) + "\n")
        return {"path": path, "material": RED}
