"""Errors of the GPU reader."""

from __future__ import annotations

from rna_sdk.errors import RnaError


class GpuError(RnaError):
    """No usable GPU, its memory or limits exceeded, or a failed call."""


class DeviceLostError(GpuError):
    """The device was lost during work. Open a new one and load the asset again."""
