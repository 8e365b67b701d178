"""A PSNR in words: the table of docs/psnr.md."""

from __future__ import annotations

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
