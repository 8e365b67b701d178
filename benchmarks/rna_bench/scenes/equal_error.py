"""Where Cycles reaches the error that an image of ours has, and how long that takes it."""

from collections.abc import Sequence
from typing import Any

import numpy as np

Row = dict[str, Any]
"""`samples`, `seconds` and `psnr` of one image."""


def equal_error(ours: Row, cycles: Sequence[Row]) -> dict[str, Any]:
    """The time that Cycles takes for the error of our image, without denoising, over our time.

    cycles: images at several sample counts. Its error is a / samples, its time b + c samples; all
    three are fitted. `extrapolated`: the count lies beyond those that were rendered.
    """
    counts = np.array([row["samples"] for row in cycles], float)
    errors = 10.0 ** (-np.array([row["psnr"] for row in cycles]) / 10.0)
    a = np.exp(np.mean(np.log(errors * counts)))
    c, b = np.polyfit(counts, [row["seconds"] for row in cycles], 1)
    samples = float(a / 10.0 ** (-ours["psnr"] / 10.0))
    seconds = float(b + c * samples)
    return {
        "cycles_samples": samples,
        "cycles_seconds": seconds,
        "extrapolated": not counts.min() <= samples <= counts.max(),
        "times_as_fast": seconds / ours["seconds"],
    }


def equal_time(seconds: float, images: Sequence[Row]) -> int:
    """Index of the image whose time has the ratio nearest to 1 with the given one."""
    return int(np.argmin([abs(np.log(row["seconds"] / seconds)) for row in images]))
