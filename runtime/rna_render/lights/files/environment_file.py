"""Images of environments: EXR or Radiance HDR in, radiance out."""

import warnings
from functools import lru_cache
from pathlib import Path

import numpy as np

from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.lights.files.environment_exr import read_exr_environment
from rna_render.lights.files.radiance_hdr import HDR_MAGIC, read_hdr
from rna_render.scene.limits import MAX_NUMBER
from rna_sdk.errors import SceneError
from rna_sdk.files.regular_file import check_regular

# First bytes of the file: OpenEXR file layout, "Magic Number".
EXR_MAGIC = bytes([0x76, 0x2F, 0x31, 0x01])

# The largest half float: a sun above it is infinite in a file of these.
BRIGHTEST = 65504.0


class EnvironmentWarning(UserWarning):
    """An environment is darker than its file means."""


def environment_image(path: Path) -> EquirectangularImage:
    """The image, ready to be sampled; the last few files are cached while they do not change.

    Errors are those of `read_environment`.
    """
    try:
        state = check_regular(path)
    except OSError as error:
        raise SceneError(f"cannot read the image: {error.strerror}", file=path) from error
    return _cached_image(path, state.st_mtime_ns, state.st_size)


@lru_cache(maxsize=4)
def _cached_image(path: Path, modified: int, size: int) -> EquirectangularImage:
    return EquirectangularImage(read_environment(path))


def read_environment(path: Path) -> np.ndarray:
    """Radiance of the texels, (h, w, 3) float32; negative values, which filters leave, are 0.

    The file's first bytes say what it is. Raises SceneError if it cannot be read, is neither EXR
    nor HDR, has no picture that `read_exr_environment` or `read_hdr` know, or has texels that are
    not numbers. Infinite ones are BRIGHTEST, of which it warns (EnvironmentWarning).
    """
    try:
        check_regular(path)
        with path.open("rb") as file:
            start = file.read(4)
    except OSError as error:
        raise SceneError(f"cannot read the image: {error.strerror}", file=path) from error
    if start == EXR_MAGIC:
        texels = read_exr_environment(path)
    elif start.startswith(HDR_MAGIC):
        texels = read_hdr(path)
    else:
        raise SceneError("is neither an EXR nor a Radiance HDR image", file=path)
    infinite = np.isposinf(texels)
    if infinite.any():
        texels[infinite] = BRIGHTEST
        count = np.count_nonzero(infinite.any(axis=2))
        what = f"infinite radiance in {count} texels is cut to {BRIGHTEST:,.0f}"
        warnings.warn(f"{path}: {what}: the sun is darker", EnvironmentWarning, stacklevel=2)
    usable = np.isfinite(texels) & (texels <= MAX_NUMBER)
    bad = np.count_nonzero(~usable.all(axis=2))
    if bad:
        raise SceneError(
            f"has {bad} texels that are not finite numbers of at most {MAX_NUMBER:g}", file=path
        )
    np.maximum(texels, np.float32(0.0), out=texels)
    return texels
