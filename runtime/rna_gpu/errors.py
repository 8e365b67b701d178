"""What can go wrong with a GPU."""

from __future__ import annotations

from rna_sdk.errors import RnaError


class GpuError(RnaError):
    """There is no usable GPU, something does not fit on it, or it was lost."""


class DeviceLostError(GpuError):
    """The device went away during work; open a new one and begin the step again."""
