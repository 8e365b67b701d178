"""The one error tree of the project.

::

    RnaError
    +-- PackageError     a `.rna` file breaks the format; carries the issues found
    +-- QueryError       wrong arguments to a runtime call: names, shapes, dtypes
    +-- MotionError      a motion cannot be used with a package, or written
    +-- SceneError       a scene file cannot be rendered; names file, line and key
    +-- GpuError         no GPU, or one that cannot do what is asked
    |   +-- DeviceLostError  the device was lost during work
    +-- PreviewError     the preview cannot start
    +-- ViewError        a page cannot be served or exported
    +-- CaptureError     capture cannot start or go on
    +-- TrainingError    training cannot start or go on
    +-- ExportError      a checkpoint cannot be turned into a package
    +-- ConformanceError a reader, or the conformance kit, cannot be run
    +-- WorkError        a worker ended, or a cluster cannot be used
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rna_sdk.package.issues import Issue


class RnaError(Exception):
    """Root of every error the project raises on purpose."""


class PackageError(RnaError):
    """A package breaks the format.

    Attributes:
        issues: what was found, in the order of the checks; never empty.
    """

    def __init__(self, issues: Iterable[Issue], path: object = None) -> None:
        self.issues: list[Issue] = list(issues)
        self.path = path
        place = f"{path}: " if path is not None else ""
        super().__init__(place + "\n".join(str(issue) for issue in self.issues))

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled by its arguments: by its message alone it could not be made again."""
        return type(self), (self.issues, self.path)


class QueryError(RnaError):
    """A runtime call got an argument that it cannot use."""


class MotionError(RnaError):
    """A motion cannot be read or written, or does not fit its package."""


class SceneError(RnaError):
    """A scene description cannot be rendered.

    Attributes:
        file, line, key: where the mistake is, as far as known; part of the message.
    """

    def __init__(
        self, message: str, *, file: object = None, line: int | None = None, key: str | None = None
    ) -> None:
        self.file, self.line, self.key = file, line, key
        parts = [str(file)] if file is not None else []
        parts += [str(line)] if line is not None else []
        place = ":".join(parts)
        subject = f"{key}: {message}" if key else message
        super().__init__(f"{place}: {subject}" if place else subject)


class PreviewError(RnaError):
    """The preview cannot start."""


class CaptureError(RnaError):
    """Capture cannot start or go on."""


class TrainingError(RnaError):
    """Training cannot start or go on."""


class ExportError(RnaError):
    """A checkpoint cannot be turned into a package."""


class ConformanceError(RnaError):
    """A reader, or the conformance kit, cannot be run."""


class WorkError(RnaError):
    """A worker of long work ended, or a cluster cannot be used."""


class GpuError(RnaError):
    """No usable GPU, its memory or limits exceeded, or a failed call."""


class DeviceLostError(GpuError):
    """The device was lost during work. Open a new one and load the asset again."""


class ViewError(RnaError):
    """A page cannot be served or exported."""
