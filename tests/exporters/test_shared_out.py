"""Shards small enough that all workers have some."""

from __future__ import annotations

import pytest

from rna_export.capture.capture_run import shared_out
from rna_export.capture.capture_settings import CaptureSettings


@pytest.mark.parametrize(
    ("lights", "workers", "shard"),
    [(2000, 2, 32), (2000, 16, 31), (3520, 16, 32), (64, 16, 1), (64, 2, 8), (3, 64, 1)],
)
def test_every_worker_has_four_shards_where_there_are_lights(
    lights: int, workers: int, shard: int
) -> None:
    settings = CaptureSettings.usual("surface", lights=lights)
    assert shared_out(settings, workers).lights_per_shard == shard
    assert shared_out(settings, workers).lights == lights
