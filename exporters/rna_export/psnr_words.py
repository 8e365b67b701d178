"""A PSNR in words: the table of docs/psnr.md."""

from __future__ import annotations

from rna_export.metrics import RAYS_ALONG_A_PIXEL

_STEPS = (
    (24.0, "unusable: noise or wrong colours all over"),
    (30.0, "poor: stains or noise that anybody sees"),
    (34.0, "rough: the asset is recognised, its highlights and shadows are blotchy"),
    (38.0, "fair: differences show beside the original, hardly alone"),
    (42.0, "good: differences show in close-ups"),
)
_BEST = "very good: hard to tell from the original"


def psnr_in_words(db: float) -> str:
    """What a PSNR of validation images, dB, looks like."""
    return next((words for below, words in _STEPS if db < below), _BEST)


def psnr_text(db: float, in_pixels: float | None = None) -> str:
    """A PSNR, dB, in figures and words.

    in_pixels: of strands, dB in pixels of several rays, which the words are then of. Validation
    images have one ray a pixel, which shows one strand; a picture shows the mean of several.
    """
    if in_pixels is None:
        return f"{db:.2f} dB ({psnr_in_words(db)})"
    pixels = f"{in_pixels:.1f} dB in pixels of {RAYS_ALONG_A_PIXEL**2}"
    return f"{db:.2f} dB a ray, {pixels} ({psnr_in_words(in_pixels)})"
