"""The poster image of a package."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from rna_export.pictures import png_bytes
from rna_render import World, encode_srgb, make_integrator, place_asset, render
from rna_render.scene import AssetModel, CameraModel, DirectionalModel, EnvironmentModel, Scene
from rna_sdk.runtime import FiberAsset, load

_SIDE = 256  # pixels
_SAMPLES = 32
_FOV_DEG = 30.0
_EYE = (0.54, 0.34, 0.77)  # direction from the asset's middle: from the front, right and above
_SUN = (0.68, 0.71, 0.18)
_KEY, _SKY = 2.2, 0.35  # irradiance of the sun, W/m^2; radiance of the sky


def render_poster(package: Path) -> bytes:
    """A PNG of 256 x 256 pixels, sRGB with alpha, of the package's first tier.

    The light is a sun from the side and an even, invisible sky.
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
    centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    away = np.array(_EYE) / np.linalg.norm(_EYE)
    eye = centre + away * radius / np.sin(np.radians(_FOV_DEG) / 2)
    sun = DirectionalModel(type="directional", direction=_SUN, irradiance=(_KEY,) * 3)
    sky = EnvironmentModel(type="environment", radiance=(_SKY,) * 3, visible_to_camera=False)
    return Scene(
        assets=(AssetModel(path=package),),
        camera=CameraModel(
            position=tuple(eye.tolist()),
            look_at=tuple(centre.tolist()),
            vertical_fov_deg=_FOV_DEG,
        ),
        lights=(sun, sky),
        resolution=(_SIDE, _SIDE),
        samples=_SAMPLES,
    )


def png_of(rgba: np.ndarray) -> bytes:
    """PNG of linear, premultiplied radiance (h, w, 4); a pixel in it is not premultiplied."""
    alpha = np.clip(rgba[..., 3:], 0.0, 1.0)
    colour = encode_srgb(rgba[..., :3] / np.maximum(alpha, 1e-6))
    pixels = np.rint(255.0 * np.concatenate([colour * (alpha > 0), alpha], axis=-1))
    return png_bytes(pixels.astype(np.uint8))
