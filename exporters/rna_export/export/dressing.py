"""What an exported package has beside the asset: poster and stand-in materials; and its coding."""

from __future__ import annotations

from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.export.poster import render_poster
from rna_export.export.standin import standin_material
from rna_sdk.errors import ExportError
from rna_sdk.package.extensions import Standin
from rna_sdk.package.packing import Unpacked
from rna_sdk.package.poster import png_size

_SHARDS = 12  # of training samples that a stand-in is estimated from


def dress(package: Path, dataset: Dataset, poster: Path | None, deflate: bool) -> None:
    """Add poster and stand-ins to the package, and code its entries if `deflate`.

    poster: a PNG; None: one is rendered. Raises ExportError where it is no PNG.
    """
    png = render_poster(package) if poster is None else _read_png(poster)
    materials = [standin_material(part.training_samples(_SHARDS)) for part in dataset.parts]
    standin = Standin(parts=tuple(materials))
    dressed = Unpacked.read(package).with_poster(png).with_extension(standin, {})
    (dressed.deflated() if deflate else dressed).write(package)


def _read_png(path: Path) -> bytes:
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ExportError(f"{path}: found {error.strerror}, expected a PNG (--poster)") from error
    if png_size(data) is None:
        raise ExportError(f"{path}: found no PNG, expected one (--poster)")
    return data
