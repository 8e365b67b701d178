"""A picture that marks where the exported geometry differs from Cycles' renders."""

import io
from collections.abc import Mapping

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.check.disagreement import ELSEWHERE, EXTRA, MISSING, TURNED, Disagreement
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import ViewRays

_PANEL = 384  # pixels, of each of the three
_MARKS = {
    MISSING: (214, 39, 40),
    EXTRA: (31, 119, 230),
    ELSEWHERE: (255, 187, 0),
    TURNED: (176, 60, 200),
}
_NAMES = {MISSING: "red", EXTRA: "blue", ELSEWHERE: "yellow", TURNED: "violet"}
_PAPER, _INK = (255, 255, 255), (20, 20, 20)
_FIELD = np.float32(0.86)  # what nothing covers


def disagreement_picture(
    scene: AssetScene,
    rays: ViewRays,
    rendered: RenderedRays,
    disagreement: Disagreement,
    name: str,
    said: Mapping[str, str],
) -> bytes:
    """PNG of three labelled images: Cycles', the exported geometry, their differences, in colours.

    rays: of a square image, by rows. said: what to write of each kind of disagreement.
    """
    exported = _shaded(scene, rays)
    images = _cycles(rendered), exported, _marked(exported, disagreement)
    labels = "Cycles", "exported geometry", "what differs"
    side = _PANEL
    line = side // 14
    font = ImageFont.load_default(line * 0.6)
    width, top = 3 * side, 2 * line
    sheet = Image.new("RGB", (width, top + side + line * (len(said) + 1)), _PAPER)
    draw = ImageDraw.Draw(sheet)
    title = f"{name}: the exported geometry differs from Cycles' renders"
    draw.text((line // 2, line // 2), title, _INK, font, anchor="lm")
    for k, (label, image) in enumerate(zip(labels, images, strict=True)):
        draw.text((k * side + line // 2, line + line // 2), label, _INK, font, anchor="lm")
        sheet.paste(image.resize((side, side), Image.Resampling.NEAREST), (k * side, top))
    for k, (kind, text) in enumerate(said.items()):
        y = top + side + line // 2 + k * line
        draw.rectangle((line // 2, y + line // 4, line, y + line * 3 // 4), _MARKS[kind])
        draw.text((line * 1.5, y + line // 2), f"{_NAMES[kind]}: {text}", _INK, font, anchor="lm")
    packed = io.BytesIO()
    sheet.save(packed, "PNG")
    return packed.getvalue()


def _cycles(rendered: RenderedRays) -> Image.Image:
    """Scaled to its own brightness: the light is one sun, and materials may be dark."""
    colour = np.nan_to_num(rendered.radiance, posinf=0.0)
    shown = colour[rendered.alpha > 0.5]
    white = max(float(np.quantile(shown, 0.98)) if len(shown) else 0.0, 1e-6)
    encoded = np.clip(colour / white, 0.0, 1.0) ** (1.0 / 2.2)
    alpha = rendered.alpha[:, None]
    return _image(encoded + (1.0 - alpha) * _FIELD)


def _shaded(scene: AssetScene, rays: ViewRays) -> Image.Image:
    """Grey, brighter where it faces the viewer; holes are holes."""
    points = scene.shade_points(rays.origins, rays.directions)
    facing = np.abs(np.sum(points.geometric_normal * rays.directions, axis=1))
    alpha = scene.coverage(rays.origins, rays.directions)
    grey = alpha * (0.15 + 0.55 * facing) + (1.0 - alpha) * _FIELD
    return _image(np.repeat(grey[:, None], 3, axis=1))


def _marked(exported: Image.Image, disagreement: Disagreement) -> Image.Image:
    pixels = np.asarray(exported, np.float32).reshape(-1, 3)
    pixels = 0.5 * pixels + 0.5 * 255.0 * _FIELD
    for kind, colour in _MARKS.items():
        pixels[getattr(disagreement, kind)] = colour
    if disagreement.excess:
        pixels[disagreement.partly] = _MARKS[MISSING if disagreement.excess > 0.0 else EXTRA]
    return _image(pixels / 255.0)


def _image(values: np.ndarray) -> Image.Image:
    side = round(len(values) ** 0.5)
    levels = np.round(255.0 * np.clip(values, 0.0, 1.0)).astype(np.uint8)
    return Image.fromarray(levels.reshape(side, side, 3))
