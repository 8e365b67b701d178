"""View transforms: from linear radiance to displayed values."""

import numpy as np

from rna_sdk.files.srgb import encode_srgb as encode_srgb  # public, too

# Stephen Hill's fit of the ACES reference rendering transform and its sRGB output transform, in
# https://github.com/TheRealMJP/BakingLab/blob/master/BakingLab/ACES.hlsl (MIT). Each row sums to
# one, so grey stays grey.
_RRT_FROM_LINEAR = np.array(
    [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]]
)
_LINEAR_FROM_ODT = np.array(
    [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]]
)
# ACES shows middle grey, 0.18, at 0.106, as a dark cinema wants it. With this factor before the
# curve, the solution of _aces_curve(0.18 x) = 0.18, both views show it alike.
_FILMIC_EXPOSURE = 1.461926
# The curve's quotient has no value at infinity, and is flat long before this.
_MAX_RADIANCE = 1e9


def to_display(rgb: np.ndarray, view: str, exposure: float = 0.0) -> np.ndarray:
    """Display values of linear radiance times 2^exposure: sRGB in [0, 1].

    rgb: (..., 3) float. view: `srgb` clamps to [0, 1]; `filmic` has a toe and a shoulder, with
    middle grey at 0.18 as in `srgb`, and white, with all three at 1, from 18 on.
    """
    linear = np.asarray(rgb, np.float64) * 2.0**exposure
    return encode_srgb(_filmic(linear) if view == "filmic" else linear)


def _filmic(linear: np.ndarray) -> np.ndarray:
    """Linear radiance as linear light of the screen, both (..., 3)."""
    radiance = np.clip(linear, 0.0, _MAX_RADIANCE)
    curved = _aces_curve(_FILMIC_EXPOSURE * radiance @ _RRT_FROM_LINEAR.T)
    return np.asarray(curved @ _LINEAR_FROM_ODT.T)


def _aces_curve(x: np.ndarray) -> np.ndarray:
    """RRTAndODTFit of the source above."""
    return (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081)
