"""A GPU for the tests: a real one, or the software driver of Mesa."""

from __future__ import annotations

import pytest

from rna_gpu import Device, GpuError, open_device


@pytest.fixture(scope="session")
def device() -> Device:
    try:
        return open_device()
    except GpuError as error:
        pytest.skip(str(error))
