"""Standard views and lights of a comparison, derived from the asset's bounding sphere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_render.scene_model import AssetModel, CameraModel, DirectionalModel, Scene

FOV_Y = np.radians(30.0)
_LIGHTS = {"key": (40.0, 45.0), "side": (-80.0, 20.0), "back": (170.0, 35.0)}  # from the camera
_CAMERAS = {"front": (35.0, 20.0, 1.0), "behind": (215.0, 30.0, 1.0), "close-up": (20.0, 25.0, 0.3)}


@dataclass(frozen=True)
class Shot:
    """One picture of a comparison; world space is the asset's object space."""

    name: str
    eye: np.ndarray  # (3,)
    target: np.ndarray  # (3,)
    wi: np.ndarray  # (3,) unit, towards the light
    resolution: int

    @property
    def to_world(self) -> np.ndarray:
        """(4, 4) camera (looking along -z) to world."""
        back = self.eye - self.target
        back = back / np.linalg.norm(back)
        right = np.cross([0.0, 1.0, 0.0], back)
        right /= np.linalg.norm(right)
        matrix = np.eye(4)
        matrix[:3, :3] = np.stack([right, np.cross(back, right), back], axis=1)
        matrix[:3, 3] = self.eye
        return matrix

    def scene(self, package: str, samples: int) -> Scene:
        """The same picture as a scene of the renderer."""
        vector = lambda v: tuple(float(x) for x in v)  # noqa: E731
        return Scene(
            assets=(AssetModel(path=package),),
            camera=CameraModel(
                position=vector(self.eye),
                look_at=vector(self.target),
                vertical_fov_deg=float(np.degrees(FOV_Y)),
            ),
            lights=(
                DirectionalModel(
                    type="directional", direction=vector(self.wi), irradiance=(1.0, 1.0, 1.0)
                ),
            ),
            resolution=(self.resolution, self.resolution),
            samples=samples,
        )


def shots(positions: np.ndarray, resolution: int, turn_deg: float) -> list[Shot]:
    """Three cameras x three lights around positions (v, 3); `turn_deg` says where its front is."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    centre = (low + high) / 2
    radius = float(np.linalg.norm(positions - centre, axis=1).max())
    result = []
    for camera, (azimuth, elevation, zoom) in _CAMERAS.items():
        wo = _direction(azimuth + turn_deg, elevation)
        target = centre
        if zoom < 1.0:  # look at what is nearest
            target = positions[np.argmax((positions - centre) @ wo)]
        eye = target + wo * zoom * 1.02 * radius / np.sin(FOV_Y / 2)
        for light, (side, height) in _LIGHTS.items():
            wi = _direction(azimuth + turn_deg + side, height)
            result.append(Shot(f"{camera}, {light} light", eye, target, wi, resolution))
    return result


def _direction(azimuth_deg: float, elevation_deg: float) -> np.ndarray:
    a, e = np.radians(azimuth_deg), np.radians(elevation_deg)
    return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
