"""Shards small enough that many workers have some."""

from __future__ import annotations

import pytest

from rna_export.capture.capture_settings import CaptureSettings


@pytest.mark.parametrize(("lights", "shard"), [(3520, 32), (1024, 32), (512, 16), (64, 2), (3, 1)])
def test_there_are_32_shards_where_there_are_lights(lights: int, shard: int) -> None:
    settings = CaptureSettings.usual("surface", lights=lights)
    assert settings.shared_out().lights_per_shard == shard
    assert settings.shared_out().lights == lights
