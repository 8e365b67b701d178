"""Standard views and lights of a comparison, derived from the asset's bounding sphere."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.capture.blender_process.lighting import WhiteWorld
from rna_export.capture.orientation import rotation
from rna_render import Camera
from rna_render.scene import AssetModel, CameraModel, DirectionalModel, EnvironmentModel, Scene
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import Asset, FiberAsset

Frame = tuple[str, str]
"""Axes of the asset's space that are its front and its up."""

USUAL: Frame = ("Z", "Y")
FOV_Y = np.radians(30.0)
_ORBITS = {"front": (35.0, 20.0, 1.0), "behind": (215.0, 30.0, 1.0), "close-up": (20.0, 25.0, 0.3)}
"""Name -> azimuth and elevation in degrees, and the part of the asset's size that is shown."""
_SUNS = {"key": (40.0, 45.0), "side": (-80.0, 20.0), "back": (170.0, 35.0)}  # from the camera
_STRANDS = 16.0  # radii of the thickest strand from the middle of its picture to the edge


@dataclass(frozen=True)
class Shot:
    """One picture of a comparison; world space is the asset's object space."""

    number: int  # among all standard ones; Cycles' seeds follow from it
    camera_name: str  # of _ORBITS, or "strands"
    light_name: str  # "key light", ..., "white world"
    eye: np.ndarray  # (3,)
    target: np.ndarray  # (3,)
    light: np.ndarray | WhiteWorld  # (3,) unit, towards a sun of irradiance 1; or a world
    resolution: int
    up: np.ndarray  # (3,) unit

    @property
    def name(self) -> str:
        return f"{self.camera_name}, {self.light_name}"

    @property
    def is_white(self) -> bool:
        """Whether it is lit by a white world."""
        return isinstance(self.light, WhiteWorld)

    @property
    def camera(self) -> CameraModel:
        """The camera as the renderer has it."""
        return CameraModel(
            position=tuple(self.eye),
            look_at=tuple(self.target),
            up=tuple(self.up),
            vertical_fov_deg=np.degrees(FOV_Y),
        )

    @property
    def view(self) -> Camera:
        """The camera with its image."""
        return Camera(self.camera, (self.resolution, self.resolution))

    def scene(self, package: Path, samples: int) -> Scene:
        """This picture as a scene of the renderer."""
        light: DirectionalModel | EnvironmentModel
        if isinstance(self.light, WhiteWorld):
            light = EnvironmentModel(type="environment", visible_to_camera=False)
        else:
            direction, white = tuple(self.light), (1.0, 1.0, 1.0)
            light = DirectionalModel(type="directional", direction=direction, irradiance=white)
        return Scene(
            assets=(AssetModel(path=package),),
            camera=self.camera,
            lights=(light,),
            resolution=(self.resolution, self.resolution),
            samples=samples,
            clamp_indirect=None,
        )


def shots_of(asset: Asset, resolution: int, frame: Frame = USUAL) -> list[Shot]:
    """`shots` of an asset's own geometry."""
    parts = [part.curves if isinstance(part, FiberAsset) else part.mesh for part in asset.parts]
    return shots(parts, resolution, frame)


def shots(parts: Sequence[Mesh | Curves], resolution: int, frame: Frame = USUAL) -> list[Shot]:
    """Cameras x lights around the asset, whose front and up are those of `frame`.

    Fibers alone have one more camera, so near that single strands fill the picture.
    """
    positions = np.concatenate([p.points if isinstance(p, Curves) else p.positions for p in parts])
    strands = [part for part in parts if isinstance(part, Curves)]
    low, high = positions.min(axis=0), positions.max(axis=0)
    centre = (low + high) / 2
    radius = float(np.linalg.norm(positions - centre, axis=1).max())
    cameras = dict(_ORBITS)
    if len(strands) == len(parts):
        thickest = max(part.radii.max() for part in strands)
        cameras["strands"] = (*cameras["close-up"][:2], _STRANDS * thickest / radius)
    turned = rotation(*frame)
    result: list[Shot] = []
    for camera, (azimuth, elevation, zoom) in cameras.items():
        wo = turned @ _direction(azimuth, elevation)
        target = centre
        if zoom < 1.0:  # look at what is nearest
            target = positions[np.argmax((positions - centre) @ wo)]
        eye = target + wo * zoom * 1.02 * radius / np.sin(FOV_Y / 2)
        lights: dict[str, np.ndarray | WhiteWorld] = {
            f"{light} light": turned @ _direction(azimuth + side, height)
            for light, (side, height) in _SUNS.items()
        }
        for light_name, light in {**lights, "white world": WhiteWorld()}.items():
            result.append(
                Shot(
                    number=len(result),
                    camera_name=camera,
                    light_name=light_name,
                    eye=eye,
                    target=target,
                    light=light,
                    resolution=resolution,
                    up=turned[:, 1],
                )
            )
    return result


def _direction(azimuth_deg: float, elevation_deg: float) -> np.ndarray:
    a, e = np.radians(azimuth_deg), np.radians(elevation_deg)
    return np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
