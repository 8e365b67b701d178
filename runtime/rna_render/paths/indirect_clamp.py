"""The clamp of single paths' radiance that keeps specks out of pictures, where a scene asks for it.

Light that reaches a dull surface by way of an asset's highlight is found by chance alone: rarely,
and then much of it at once. A clamp that fits the scene's light takes it away, and with it a share
of the light that has met more than one thing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from rna_render.lights import Light

# Radiance of a path, in units of what a white ball as large as the scene would send on average.
AUTO = 10.0


def indirect_clamp(
    asked: float | Literal["auto"] | None, lights: Sequence[Light], scene_radius: float
) -> float | None:
    """The most radiance that a path may bring by way of more than one thing; None for any.

    asked: by the scene file; "auto" for AUTO times the mean radiance of a white ball as large as
    the scene, which follows from the lights' power.
    """
    if asked != "auto":
        return asked
    power = sum(light.power(scene_radius) for light in lights)
    ball = 4.0 * np.pi**2 * scene_radius**2
    if not (ball > 0.0 and power > 0.0 and np.isfinite(power / ball)):
        return None
    return AUTO * power / ball
