"""The poster image of a package."""

from itertools import product
from pathlib import Path

import numpy as np

from rna_export.pictures import png_bytes
from rna_render import World, encode_srgb, make_integrator, place_asset, render
from rna_render.scene import AssetModel, CameraModel, DirectionalModel, EnvironmentModel, Scene
from rna_sdk.runtime import FiberAsset, load

_SIDE = 320  # pixels, the longer
_SAMPLES = 32
# The first view of `<rna-viewer>` at its usual shape: runtime/web/src/element/orbit.js.
_AZIMUTH, _ELEVATION = 0.6, 0.35
_SLOPE = np.tan(np.radians(15.0))  # half the height of the view at distance 1
_ASPECT = 1.6
_FILLED = 0.95
_SUN = (0.68, 0.71, 0.18)
_KEY, _SKY = 2.2, 0.35  # irradiance of the sun, W/m^2; radiance of the sky


def render_poster(package: Path) -> bytes:
    """A PNG, sRGB with alpha, of the package's first tier; its longer side has 320 pixels.

    The camera is the one with which `<rna-viewer>` opens at 16:10; the picture is the part of its
    view that the asset's box needs. The light is a sun from the side and an even, invisible sky.
    """
    asset = load(package)
    geometries = [
        part.curves if isinstance(part, FiberAsset) else part.mesh for part in asset.parts
    ]
    low, high = (np.array(corners) for corners in zip(*(g.box() for g in geometries), strict=True))
    scene = _scene(package, low.min(axis=0), high.max(axis=0))
    world = World([place_asset(asset, np.eye(4))])
    channels = render(scene, make_integrator(scene, world)).channels()
    return png_of(np.stack([channels[name] for name in "RGBA"], axis=-1))


def _scene(package: Path, low: np.ndarray, high: np.ndarray) -> Scene:
    centre = (low + high) / 2
    distance, slopes = first_view(high - low)
    eye = centre + distance * _axes(_AZIMUTH)[2]
    width, height = np.maximum(1, np.rint(_SIDE * slopes / slopes.max()).astype(int))
    sun = DirectionalModel(type="directional", direction=_SUN, irradiance=(_KEY,) * 3)
    sky = EnvironmentModel(type="environment", radiance=(_SKY,) * 3, visible_to_camera=False)
    return Scene(
        assets=(AssetModel(path=package),),
        camera=CameraModel(
            position=tuple(eye.tolist()),
            look_at=tuple(centre.tolist()),
            vertical_fov_deg=float(np.degrees(2 * np.arctan(slopes[1]))),
        ),
        lights=(sun, sky),
        resolution=(int(width), int(height)),
        samples=_SAMPLES,
    )


def first_view(size: np.ndarray) -> tuple[float, np.ndarray]:
    """Where the viewer's camera is when it opens, and how much of its view a box takes.

    size: of the box (3,), which may turn about +y. Returns the distance from its middle, and half
    the width and height of its picture at distance 1, (2,) float64.
    """
    corners = size / 2 * np.array(list(product((-1, 1), repeat=3)))
    seen = np.concatenate([corners @ _axes(_AZIMUTH + k * np.pi / 8).T for k in range(16)])
    across = np.abs(seen[:, :2])
    limits = _FILLED * _SLOPE * np.array([_ASPECT, 1.0])
    distance = float(np.max(np.max(across / limits, axis=1) + seen[:, 2])) or 1.0
    return distance, np.max(across / (distance - seen[:, 2:]), axis=0) / _FILLED


def _axes(azimuth: float) -> np.ndarray:
    """Axes (3, 3) of a camera at the first view's height: right, up, away from the asset."""
    side, level = np.array([np.cos(azimuth), 0.0, -np.sin(azimuth)]), np.cos(_ELEVATION)
    away = np.array([level * np.sin(azimuth), np.sin(_ELEVATION), level * np.cos(azimuth)])
    return np.stack([side, np.cross(away, side), away])


def png_of(rgba: np.ndarray) -> bytes:
    """PNG of linear, premultiplied radiance (h, w, 4); a pixel in it is not premultiplied."""
    alpha = np.clip(rgba[..., 3:], 0.0, 1.0)
    colour = encode_srgb(rgba[..., :3] / np.maximum(alpha, 1e-6))
    pixels = np.rint(255.0 * np.concatenate([colour * (alpha > 0), alpha], axis=-1))
    return png_bytes(pixels.astype(np.uint8))
