"""Another print for a part: replacements of its package's images, and a tint."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError
from rna_sdk.package.textures.base_color import BaseColor

Images = Mapping[str, NDArray[np.uint8]]
"""Label of a record -> (H, W, 3) uint8."""


def check_images(images: Images | None, records: Sequence[BaseColor]) -> Images:
    """The images, none for None.

    Raises:
        QueryError: no record has the label of one, or it is no image.
    """
    if images is None:
        return {}
    labels = sorted({record.label for record in records if record.image is not None})
    if not isinstance(images, Mapping):
        found = " ".join(repr(images).split())[:40]
        raise QueryError(f"images: expected a dict of arrays by label, found {found}")
    arrays = {}
    for label, image in images.items():
        if label not in labels:
            known = ", ".join(labels) or "none: it has no base colour"
            raise QueryError(f"found the label {label!r}, expected one of: {known}")
        arrays[label] = array = np.asarray(image)
        if array.dtype != np.uint8 or array.ndim != 3 or array.shape[2] != 3 or not array.size:
            found = f"{array.shape} {array.dtype}"
            raise QueryError(f"{label}: expected an (H, W, 3) uint8 array, found {found}")
    return arrays


def with_images(
    records: Sequence[BaseColor], images: Images, tint: tuple[float, float, float]
) -> tuple[BaseColor, ...]:
    """The records with other images, by label, and all factors times the tint.

    Raises:
        QueryError: the tint is not three finite numbers of at least 0.
    """
    rgb = np.asarray(tint)
    if rgb.shape != (3,) or rgb.dtype.kind not in "uif" or not np.all((rgb >= 0) & (rgb < np.inf)):
        raise QueryError(f"tint: expected three numbers of at least 0, found {tint!r:.40}")
    return tuple(_with(record, images.get(record.label), tint) for record in records)


def _with(
    record: BaseColor, image: NDArray[np.uint8] | None, tint: tuple[float, float, float]
) -> BaseColor:
    (r, g, b), (x, y, z) = record.factor, tint
    tinted = replace(record, factor=(r * x, g * y, b * z))
    return tinted if image is None or record.image is None else replace(tinted, image=image)
