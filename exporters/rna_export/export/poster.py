"""The picture that a package shows of itself."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from PIL import Image

from rna_export.compare.views import shots
from rna_render.lights.models import DirectionalModel, EnvironmentModel
from rna_render.render import make_integrator, render
from rna_render.scene_model import Scene
from rna_render.srgb import encode_srgb
from rna_render.world import Placement, World
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import load

_SIDE = 256  # pixels
_SAMPLES = 32
_KEY, _SKY = 2.2, 0.35  # irradiance of the sun, W/m^2; radiance of the sky


def render_poster(package: Path, geometry: Mesh | Curves) -> bytes:
    """A PNG of 256 x 256 pixels, sRGB with alpha, of the package's first tier from the front.

    The light is a sun from the side and an even, invisible sky.
    """
    shot = shots(geometry, _SIDE, 0.0)[0]
    sun = DirectionalModel(type="directional", direction=tuple(shot.wi), irradiance=(_KEY,) * 3)
    sky = EnvironmentModel(type="environment", radiance=(_SKY,) * 3, visible_to_camera=False)
    plain = shot.scene(str(package.resolve()), _SAMPLES)
    scene = Scene.model_validate({**dict(plain), "lights": (sun, sky)})
    world = World([Placement(load(package), np.eye(4))])
    channels = render(scene, make_integrator(scene, world)).channels()
    return png_of(np.stack([channels[name] for name in "RGBA"], axis=-1))


def png_of(rgba: np.ndarray) -> bytes:
    """PNG of linear, premultiplied radiance (h, w, 4); a pixel in it is not premultiplied."""
    alpha = np.clip(rgba[..., 3:], 0.0, 1.0)
    colour = encode_srgb(rgba[..., :3] / np.maximum(alpha, 1e-6))
    pixels = np.rint(255.0 * np.concatenate([colour * (alpha > 0), alpha], axis=-1))
    file = io.BytesIO()
    Image.fromarray(pixels.astype(np.uint8), "RGBA").save(file, format="PNG", optimize=True)
    return file.getvalue()
