"""The speed over Cycles that a pilot lets expect, by assets whose speed was measured.

At equal error the speedup is (time of a path x its variance) / (time of a sample of ours x its
variance). A path's variance comes from its walk inside the asset and from its place in the pixel;
ours has the latter alone. The times keep nearly the same ratio: assets with expensive paths, above
all strands, have expensive rays. So the speedup is the pilot's noise ratio times a constant.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from pydantic import BaseModel

from rna_export.capture.estimate.pilot import PRESET, Pilot

SAMPLES = 16  # of ours, at which speeds were measured
TABLE = Path(__file__).with_name("measured_assets.json")
"""The measured assets, written by `rna-bench gain`."""

_WORTH = 1.25  # times as fast, from which a gain is promised


class MeasuredAsset(BaseModel, extra="forbid", frozen=True):
    """An asset in scenes against Cycles.

    scenes: name -> times as fast at equal error with SAMPLES samples, of `rna-bench scenes`.
    """

    pilot: Pilot
    scenes: dict[str, float]

    @property
    def times(self) -> float:
        """Geometric mean over the scenes."""
        return float(np.exp(np.mean(np.log(list(self.scenes.values())))))


@dataclass(frozen=True)
class Gain:
    """Times as fast as Cycles in scenes; low, high: by the largest error of a left-out asset.

    extrapolated: whether the pilot's noise ratio lies beyond those of the measured assets.
    """

    times: float
    low: float
    high: float
    extrapolated: bool


def table_of(path: Path = TABLE) -> dict[str, MeasuredAsset]:
    """The assets of a table by name."""
    rows = json.loads(path.read_text())["assets"]
    return {
        name: MeasuredAsset(pilot=row["pilot"], scenes=row["scenes"]) for name, row in rows.items()
    }


def predicted(pilot: Pilot, assets: Sequence[MeasuredAsset]) -> float:
    """Times as fast as Cycles: as the assets have it for each unit of the noise ratio."""
    gains = np.log([asset.times / asset.pilot.noise_ratio for asset in assets])
    return float(np.exp(np.mean(gains)) * pilot.noise_ratio)


def left_out(assets: dict[str, MeasuredAsset]) -> dict[str, float]:
    """For each asset, the gain predicted from the others over the measured gain."""
    return {
        name: predicted(one.pilot, [other for other in assets.values() if other is not one])
        / one.times
        for name, one in assets.items()
    }


def gain(pilot: Pilot, assets: dict[str, MeasuredAsset]) -> Gain:
    """Gain that the measured assets predict for a pilot."""
    times = predicted(pilot, list(assets.values()))
    factor = float(np.exp(max(abs(np.log(off)) for off in left_out(assets).values())))
    ratios = [asset.pilot.noise_ratio for asset in assets.values()]
    is_among = min(ratios) <= pilot.noise_ratio <= max(ratios)
    return Gain(times, times / factor, times * factor, not is_among)


def gain_text(pilot: Pilot, assets: dict[str, MeasuredAsset]) -> str:
    """Cost of a path in Cycles and of a query here, and the gain: two lines."""
    cost = (
        f"a path of Cycles takes {pilot.path_us:.2g} us, and its variance is "
        f"{pilot.noise_ratio:.2g} times its pixel's variance; here a query of {PRESET} takes "
        f"{pilot.query_us:.2g} us and its ray {pilot.ray_us:.2g} us (processor time)"
    )
    return f"{cost}\ngain: {_in_words(gain(pilot, assets))}"


def _in_words(gain: Gain) -> str:
    by = f"in scenes at {SAMPLES} samples"
    reach = f"{gain.low:.2g} to {gain.high:.2g}"
    if gain.times < _WORTH:
        return (
            f"none: about {gain.times:.2g} times as fast as Cycles {by} ({reach}), since its "
            "paths have little noise; reasons to go on are portability and one look in all readers"
        )
    beyond = ", extrapolated: no measured asset is so noisy" if gain.extrapolated else ""
    return f"about {gain.times:.2g} times as fast as Cycles {by} ({reach}){beyond}"
