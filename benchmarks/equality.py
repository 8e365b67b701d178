"""Where Cycles reaches the error that an image of ours has, and how long that takes it."""

from __future__ import annotations

from typing import Any

import numpy as np


def equal_error(psnr: float, seconds: float, cycles: list[dict[str, Any]]) -> dict[str, Any]:
    """Our image's error and time beside the time that Cycles takes for that error.

    cycles: `samples`, `seconds` and `psnr` of its images at several sample counts. Its error is
    a / samples, its time b + c samples; all three are fitted.
    """
    counts = np.array([row["samples"] for row in cycles], float)
    errors = 10.0 ** (-np.array([row["psnr"] for row in cycles]) / 10.0)
    a = np.exp(np.mean(np.log(errors * counts)))
    c, b = np.polyfit(counts, [row["seconds"] for row in cycles], 1)
    equal = a / 10.0 ** (-psnr / 10.0)
    return {
        "psnr": psnr,
        "seconds": seconds,
        "cycles_samples": equal,
        "cycles_seconds": b + c * equal,
        "extrapolated": bool(equal > counts.max()),
        "times_as_fast": (b + c * equal) / seconds,
    }
