"""An asset's error and albedo in words: docs/error-in-words.md."""

GOOD, FAIR = 0.07, 0.11
"""Mean FLIP below which an asset is good, and below which it is fair."""

_STEPS = (
    (0.04, "very good: hard to tell from the original"),
    (GOOD, "good: differences show in close-ups"),
    (FAIR, "fair: differences show beside the original"),
    (0.18, "rough: right where light falls, blotchy in shade and highlights"),
    (0.30, "poor: stains or wrong colours that anybody sees"),
)
_WORST = "unusable: noise or wrong colours all over"


def error_in_words(flip: float) -> str:
    """A mean FLIP of an asset's pixels in words."""
    return next((words for below, words in _STEPS if flip < below), _WORST)


def error_text(flip: float, p95: float) -> str:
    """Mean and 95th percentile of the FLIP of an asset's pixels, in figures and words."""
    return f"FLIP {flip:.3f}, 95th percentile {p95:.2f} ({error_in_words(flip)})"


def albedo_text(ratio: float, grazing: float | None) -> str:
    """Light returned from a white world over Cycles', of all and of grazing views, in words."""
    text = f"reflects {ratio:.0%} of the light that Cycles' asset does"
    return text if grazing is None else f"{text}; {grazing:.0%} at grazing views"
