"""Where the preview's camera is: on a sphere about the point that it looks at."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from rna_render.scene.model_base import Vector
from rna_render.scene.scene_model import CameraModel

# At a pole the camera's `up` lies along its line of sight, and no image is upright.
MAX_ELEVATION = np.radians(89.0)
MIN_DISTANCE, MAX_DISTANCE = 1e-4, 1e6


@dataclass(frozen=True)
class Orbit:
    """A place on a sphere.

    model: the camera's other properties, its `up` among them, which is the sphere's axis.
    target: the middle. azimuth, elevation: radians, about the axis and above the
    plane it stands on; azimuth 0 is towards +z if the axis is +y.
    """

    model: CameraModel
    target: Vector
    azimuth: float
    elevation: float
    distance: float

    @classmethod
    def of(cls, model: CameraModel) -> Orbit:
        """The orbit that `model` stands on."""
        offset = np.subtract(model.position, model.look_at)
        distance = float(np.linalg.norm(offset))
        front, side, up = _axes(model) @ offset / distance
        azimuth, elevation = np.arctan2(side, front), np.arctan2(up, np.hypot(front, side))
        return cls(model, model.look_at, float(azimuth), float(elevation), distance)

    def camera(self) -> CameraModel:
        """The camera there; the inverse of `of`."""
        level = np.cos(self.elevation)
        local = (level * np.cos(self.azimuth), level * np.sin(self.azimuth), np.sin(self.elevation))
        position = self.target + self.distance * (local @ _axes(self.model))
        return self.model.model_copy(update={"position": _vector(position), "look_at": self.target})

    def turned(self, azimuth: float, elevation: float) -> Orbit:
        """Further round by `azimuth` and up by `elevation`, radians, but over no pole."""
        # A scene may begin nearer to a pole than the preview goes by itself.
        limit = max(MAX_ELEVATION, abs(self.elevation))
        return replace(
            self,
            azimuth=float(np.remainder(self.azimuth + azimuth, 2 * np.pi)),
            elevation=float(np.clip(self.elevation + elevation, -limit, limit)),
        )

    def dollied(self, factor: float) -> Orbit:
        """The orbit at `factor` times the distance."""
        distance = float(np.clip(self.distance * factor, MIN_DISTANCE, MAX_DISTANCE))
        return replace(self, distance=distance)

    def panned(self, right: float, up: float) -> Orbit:
        """Moved along the image, in heights of the image at the target's distance."""
        camera = self.camera()
        back = np.subtract(camera.position, camera.look_at) / self.distance
        right_world = np.cross(camera.up, back)
        right_world /= np.linalg.norm(right_world)
        height = 2 * self.distance * np.tan(np.radians(camera.vertical_fov_deg) / 2)
        shift = right * right_world + up * np.cross(back, right_world)
        return replace(self, target=_vector(self.target + height * shift))


def _vector(values: np.ndarray) -> Vector:
    x, y, z = (float(value) for value in values)
    return x, y, z


def _axes(model: CameraModel) -> np.ndarray:
    """Rows front, side and up, of which up is the sphere's axis: (3, 3), a rotation."""
    up = np.asarray(model.up, np.float64) / np.linalg.norm(model.up)
    helper = (0.0, 0.0, 1.0) if abs(up[2]) < 0.9 else (1.0, 0.0, 0.0)
    side = np.cross(up, helper)
    side /= np.linalg.norm(side)
    return np.stack([np.cross(side, up), side, up])
