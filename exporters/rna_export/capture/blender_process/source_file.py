"""Is a path a model that Blender is to open? Asked before Blender starts."""

from pathlib import Path

from rna_export.blender.rna_sources.source_formats import SOURCE_FORMATS
from rna_sdk.errors import CaptureError
from rna_sdk.files.file_kinds import not_a
from rna_sdk.files.regular_file import check_regular

SUFFIXES = ", ".join(SOURCE_FORMATS)


def check_source(source: Path) -> None:
    """Raises `CaptureError` for a missing file or an unsupported format."""
    try:
        check_regular(source)
    except FileNotFoundError:
        raise CaptureError(f"{source}: no such file") from None
    except IsADirectoryError:
        raise CaptureError(f"{source}: is a folder, expected a file") from None
    except OSError as error:
        raise CaptureError(f"{source}: {error.strerror}") from None
    if source.suffix.lower() not in SOURCE_FORMATS:
        if (wrong := not_a("model", source)) is not None:
            raise CaptureError(f"{source}: {wrong}")
        raise CaptureError(
            f"{source}: found {source.suffix!r}, expected one of {SUFFIXES}; what Blender can "
            "import, it can save as .blend"
        )
