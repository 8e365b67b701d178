"""Whether highlights are narrower than what views look for."""

from __future__ import annotations

from collections.abc import Sequence

_NARROWER = 0.5  # of `sharpest`: peaks are off by 13% at 0.7 of it, by 44% at 0.36
_LEAST = 0.02  # the narrowest that was measured


def narrow_highlights(smoothest: tuple[str, float] | None, sharpest: float) -> Sequence[str]:
    """A note, or nothing.

    smoothest: name and roughness of the smoothest material. sharpest: that of the capture.
    """
    if smoothest is None or smoothest[1] >= _NARROWER * sharpest or sharpest <= _LEAST:
        return []
    material, roughness = smoothest
    return [
        f"material {material!r} has highlights of roughness {roughness:.2g}, which views of "
        f"--sharpest {sharpest:g} seldom meet, so they will be off; "
        f"--sharpest {max(roughness, _LEAST):.2g} looks for them"
    ]
